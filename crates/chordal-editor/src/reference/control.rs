//! `docs/reference/controls/<control>.md`: codes, words, settings and alarms of one control.

use chordal::Code;
use chordal::control::Action;
use chordal::control::table::{CodeGroup, CodeRow, ControlTable, DataTarget, code_name};
use chordal::control::{COMMON_SETTINGS, Certainty, Setting};

use crate::meaning::{
    ControlView, codes, group_name, letter_meanings, own_value, target_name, without_places,
    word_rows,
};
use crate::reference::{HEAD, cell, diagnostics, table_row, unsupported_codes};

/// The page of a control.
pub(super) fn page(table: &'static ControlTable) -> String {
    let view = ControlView { table, parameters: table.parameters };
    let mut text = format!(
        "# {}\n\n{HEAD}\n\
         In a machine file: `control = \"{}\"`. Source: {}.\n\n\
         A code may also take the axis words and F, where they make sense. Codes of one group exclude each\n\
         other: one stays active until the next one of its group. `chordal explain G83 --machine …` says the same\n\
         with the settings of your machine.\n",
        table.title,
        table.name,
        table.source.trim_end_matches('.'),
    );
    for (letter, title) in [(b'G', "G codes"), (b'M', "M codes")] {
        text.push_str(&format!("\n## {title}\n\n"));
        text.push_str("| code | meaning | group | words |\n|---|---|---|---|\n");
        for run in runs(table, letter) {
            text.push_str(&code_row(letter, run, &view));
        }
    }
    text.push_str(&order(table));
    text.push_str(&data(table));
    text.push_str(&not_here(table));
    text.push_str(&letters(&view));
    text.push_str(&settings(&view));
    text.push_str(&alarms(table));
    text
}

/// Rows that follow each other and say the same: a range of user codes is one line.
fn runs(table: &'static ControlTable, letter: u8) -> Vec<&'static [CodeRow]> {
    let same = |a: &CodeRow, b: &CodeRow| {
        (a.title, a.action, a.group, a.words) == (b.title, b.action, b.group, b.words)
    };
    let runs = codes(table, letter).chunk_by(same);
    runs.filter(|run| !run[0].action.is_left_out()).collect()
}

fn code_row(letter: u8, run: &[CodeRow], view: &ControlView) -> String {
    let row = &run[0];
    let name = |row: &CodeRow| code_name(letter, row.code);
    let names = match run {
        [one] => name(one),
        [first, .., last] if run.len() > 4 => format!("{} to {}", name(first), name(last)),
        some => some.iter().map(name).collect::<Vec<_>>().join(" "),
    };
    let group = match (row.action, row.group) {
        (Action::NoEffect, _) => "no effect on path or time".to_string(),
        (_, CodeGroup::OneShot) => "this block only".into(),
        (
            _,
            CodeGroup::Auxiliary | CodeGroup::Stopping | CodeGroup::Calling | CodeGroup::ToolChange,
        ) => "–".into(),
        (_, group) => group_name(group),
    };
    table_row(&[names, cell(row.title), group, words(row, view)])
}

/// `Q` depth of each peck …
fn words(row: &CodeRow, view: &ControlView) -> String {
    let lines = word_rows(row, view).into_iter().map(|(letters, meaning)| {
        let letters: Vec<String> = letters.split(' ').map(|letter| format!("`{letter}`")).collect();
        format!("{} {}", letters.join(" "), cell(&meaning))
    });
    lines.collect::<Vec<_>>().join("<br>")
}

/// In which order a block is carried out.
fn order(table: &ControlTable) -> String {
    let groups = table.order.steps.iter().enumerate().map(|(place, group)| {
        let names: Vec<&str> = group.iter().map(|step| step.name()).collect();
        table_row(&[(place + 1).to_string(), names.join("; ")])
    });
    format!(
        "\n## Order within a block\n\nWhatever the order of the words; what stands in one row acts in the order of the block.\n\
         Source: {} ({}).\n\n| | |\n|---|---|\n{}",
        table.order.source,
        sure(table.order.certainty),
        groups.collect::<String>()
    )
}

/// What G10 writes, by L.
fn data(table: &ControlTable) -> String {
    let known: Vec<_> = table
        .set_data
        .iter()
        .filter(|(_, target)| {
            !matches!(target, DataTarget::Other | DataTarget::IntoRegister | DataTarget::Lines)
        })
        .collect();
    if known.is_empty() {
        return String::new();
    }
    let mut text = String::from("\n## G10\n\n| L | writes |\n|---|---|\n");
    for run in known.chunk_by(|a, b| a.1 == b.1) {
        let numbers: Vec<String> = run.iter().map(|(number, _)| format!("L{number}")).collect();
        text.push_str(&table_row(&[numbers.join(" "), target_name(run[0].1).into()]));
    }
    text
}

fn not_here(table: &ControlTable) -> String {
    let (rows, data) = (unsupported_codes::of(table), unsupported_codes::data_of(table));
    if rows.is_empty() && data.is_empty() {
        return String::new();
    }
    let mut text = format!(
        "\n## Not carried out\n\n\
         The control has these codes. Chordal reports {} for each of them in a program and continues without it.\n\n\
         | code | meaning |\n|---|---|\n",
        Code::NotSimulated.info().id
    );
    for (name, title) in rows {
        text.push_str(&table_row(&[name, cell(title)]));
    }
    for name in data {
        text.push_str(&table_row(&[name, "other data".into()]));
    }
    text
}

fn letters(view: &ControlView) -> String {
    let mut text = String::from(
        "\n## Letters\n\nWhat a letter means by itself. With a code, see the words of the code.\n\n\
         | letter | meaning |\n|---|---|\n",
    );
    for letter in (b'A'..=b'Z').filter(|letter| !matches!(letter, b'G' | b'M')) {
        let meanings = letter_meanings(letter, view);
        if !meanings.is_empty() {
            let name = format!("`{}`", char::from(letter));
            text.push_str(&table_row(&[name, cell(&meanings.join("; "))]));
        }
    }
    text
}

fn settings(view: &ControlView) -> String {
    let mut text = String::from(
        "\n## Settings\n\n\
         Written in the machine file under `[settings]`. How sure: *documented* in a manual; *inferred* from\n\
         examples; *trade* knowledge without a text; *unknown*: the default is assumed.\n\n\
         | setting | what it does | values | default | how sure | source |\n|---|---|---|---|---|---|\n",
    );
    for setting in view.table.settings {
        let mut cells = setting_cells(setting, view);
        cells.push(sure(setting.certainty).into());
        cells.push(cell(setting.source));
        text.push_str(&table_row(&cells));
    }
    text.push_str(
        "\nThese names are valid on every control; the defaults are those of this one.\n\n\
         | setting | what it does | values | default |\n|---|---|---|---|\n",
    );
    for setting in COMMON_SETTINGS {
        text.push_str(&table_row(&setting_cells(setting, view)));
    }
    text
}

fn setting_cells(setting: &Setting, view: &ControlView) -> Vec<String> {
    let values: Vec<String> = setting
        .values
        .iter()
        .map(|(own, common)| match own == common {
            true => format!("`{own}`"),
            false => format!("`{own}` = {common}"),
        })
        .collect();
    let default = own_value(setting, &view.parameters);
    vec![
        format!("`\"{}\"`", setting.name),
        cell(setting.text),
        cell(&values.join("<br>")),
        cell(&default),
    ]
}

const fn sure(certainty: Certainty) -> &'static str {
    match certainty {
        Certainty::Documented => "documented",
        Certainty::Inferred => "inferred",
        Certainty::Practice => "trade",
        Certainty::Unknown => "unknown",
    }
}

fn alarms(table: &ControlTable) -> String {
    let mut text = String::from(
        "\n## Alarms\n\n| diagnostic | meaning | the control shows |\n|---|---|---|\n",
    );
    let mut alarms: Vec<_> = table.alarms.iter().collect();
    alarms.sort_by_key(|(code, _)| code.info().id);
    for (code, alarm) in alarms {
        let info = code.info();
        let link = format!("[{}](../diagnostics.md#{})", info.id, diagnostics::anchor(info));
        text.push_str(&table_row(&[link, cell(info.summary), cell(&without_places(alarm))]));
    }
    text
}
