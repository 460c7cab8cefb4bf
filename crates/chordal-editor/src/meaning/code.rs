//! What a G or M code does on a control, from its row of the table.

use std::collections::BTreeMap;

use chordal::Code;
use chordal::control::table::{
    ArcTurns, CodeGroup, CodeRow, ControlTable, DataTarget, MotionModality, code_name,
};
use chordal::control::{Action, MotionCode, OnceCode, SurfaceCode};
use chordal::control::{Certainty, SurfaceWord, ToolValue, dwell_text};
use chordal::syntax::Letters;

use crate::meaning::form::{example, word_rows};
use crate::meaning::{ControlView, FactLines, own_value, sections, settings, some, without_places};

/// The codes of a table under a letter.
pub fn codes(table: &ControlTable, letter: u8) -> &'static [CodeRow] {
    if letter == b'G' { table.g_codes } else { table.m_codes }
}

/// The code on each control; `None` when it is nowhere.
pub fn code_text(letter: u8, code: u16, views: &[ControlView]) -> Option<String> {
    let on = |view: &ControlView| {
        let row = codes(view.table, letter).iter().find(|row| row.code == code)?;
        Some(row_text(letter, row, view, views.len() > 1))
    };
    sections(&code_name(letter, code), views, on)
}

/// The code on one control in few words; `None` when it has none.
pub fn code_brief(letter: u8, code: u16, view: &ControlView) -> Option<String> {
    let row = codes(view.table, letter).iter().find(|row| row.code == code)?;
    let title = view.table.title;
    Some(format!("{} on {title}:{}", code_name(letter, code), row_text(letter, row, view, true)))
}

/// What a code does on a control; in few words where there are `several`.
fn row_text(letter: u8, row: &CodeRow, view: &ControlView, several: bool) -> String {
    let mut facts = FactLines::new(row.title);
    if row.action.is_left_out() {
        let note = match row.action == Action::NotFollowed {
            true => {
                "the control carries it out and Chordal does not: an error, from there on the path is not known"
            }
            false => "the control carries it out; Chordal does not, and reports each use",
        };
        facts.add("note", note);
        return facts.text;
    }
    if row.action == Action::NoEffect {
        facts.add("effect", "none on the path or the time");
    }
    match several {
        true if row.words != Letters::NONE => {
            let letters: Vec<String> = row.words.iter().map(String::from).collect();
            facts.add("takes", &format!("{}{}", letters.join(" "), extra_words(row.action)));
        }
        true => {}
        false => {
            if let Some(example) = example(letter, row, view) {
                facts.add("example", &example);
            }
            for (letters, meaning) in word_rows(row, view) {
                facts.add("words", &format!("{letters}: {meaning}"));
            }
        }
    }
    let arc = matches!(
        row.action,
        Action::Motion(MotionCode::ArcCw) | Action::Motion(MotionCode::ArcCcw)
    );
    match row.group {
        CodeGroup::OneShot => facts.add("holds", "only in its own block"),
        CodeGroup::Auxiliary | CodeGroup::Stopping | CodeGroup::Calling | CodeGroup::ToolChange => {
        }
        CodeGroup::Motion if arc && view.table.motion == MotionModality::Armed => {
            facts.add(
                "holds",
                "as the direction of every block with a centre or a radius; other blocks move as G1",
            );
        }
        group => {
            let others: Vec<String> = codes(view.table, letter)
                .iter()
                .filter(|other| other.group == group && other.code != row.code)
                .map(|other| code_name(letter, other.code))
                .collect();
            let ended = if others.is_empty() {
                String::new()
            } else {
                format!(", until {}", some(&others))
            };
            facts.add("group", &format!("{}{ended}", group_name(group)));
        }
    }
    facts_of_action(row.action, view, several, &mut facts);
    let known = row.action.facts(view.table, &view.parameters);
    for setting in settings(view.table, known.settings) {
        let value = own_value(setting, &view.parameters);
        let meaning = if several { String::new() } else { format!(": {}", setting.text) };
        facts.add("settings", &format!("{} = {value}{meaning}", setting.name));
    }
    if !several {
        for (code, alarm) in alarms(known.problems, view.table) {
            facts.add("alarms", &format!("{code} {}", without_places(alarm)));
        }
    }
    facts.text
}

/// What the control shows for problems, by their codes.
fn alarms(problems: &[Code], table: &ControlTable) -> BTreeMap<&'static str, &'static str> {
    problems.iter().filter_map(|code| Some((code.id(), table.alarm(*code)?))).collect()
}

/// What stands in the block in addition to a code's own words.
fn extra_words(action: Action) -> &'static str {
    if action.motion().is_some() || action.cycle().is_some() {
        ", with the axes and F"
    } else if matches!(action, Action::Mode(_) | Action::Length(_)) {
        ", with the axes"
    } else {
        ""
    }
}

/// What the table says of an action in addition to its settings.
fn facts_of_action(action: Action, view: &ControlView, several: bool, facts: &mut FactLines) {
    if action == Action::Once(OnceCode::Dwell) {
        for word in view.table.dwell_words(&view.parameters).filter(|_| several) {
            facts.add("time", &dwell_text(word));
        }
        if view.table.dwell_alone_stops {
            facts.add("alone", "an exact stop");
        }
    }
    if action == Action::Once(OnceCode::SetData) {
        // One line for all numbers that write the same.
        let mut targets: Vec<(&str, Vec<String>)> = Vec::new();
        for (number, target) in view.table.set_data {
            let (name, number) = (target_name(*target), format!("L{number}"));
            match targets.iter_mut().find(|(other, _)| *other == name) {
                Some((_, numbers)) => numbers.push(number),
                None => targets.push((name, vec![number])),
            }
        }
        for (name, numbers) in targets {
            facts.add("writes", &format!("{}: {name}", numbers.join(" ")));
        }
    }
    if let Action::Once(OnceCode::Surface(code)) = action {
        surface_facts(code, view, facts);
    }
    if matches!(action, Action::Motion(MotionCode::ArcCw | MotionCode::ArcCcw)) {
        match view.table.arc_turns {
            ArcTurns::None => {}
            ArcTurns::Extra => facts.add("turns", "P: full turns in addition to the arc itself"),
            ArcTurns::BeyondAngle => facts.add(
                "turns",
                "P: full turns in addition to the angle from start to end; all turns of a full circle",
            ),
            ArcTurns::Total => facts.add("turns", "P: all turns, the arc itself counted as one"),
        }
    }
}

/// How coordinates on a face or a cylinder are written, what may not come there, and how sure that is.
fn surface_facts(code: SurfaceCode, view: &ControlView, facts: &mut FactLines) {
    let rules = match code {
        SurfaceCode::Face => view.table.face,
        SurfaceCode::Cylinder => view.table.cylinder,
        SurfaceCode::FaceOff => None,
    };
    let Some(rules) = rules else { return };
    facts.add(
        "across",
        match rules.word {
            SurfaceWord::RotaryLength => "a length with the letter of the rotary axis",
            SurfaceWord::RotaryAngle => {
                "an angle with the letter of the rotary axis, as a length on the cylinder"
            }
            SurfaceWord::Linear => "a length with the letter of the linear axis",
        },
    );
    match (rules.rapid, rules.code) {
        (true, _) => facts.add("rapids", "allowed"),
        (false, Some(alarm)) => facts.add("rapids", alarm),
        (false, None) => facts.add("rapids", "refused"),
    }
    let sure = match rules.certainty {
        Certainty::Documented => "documented",
        Certainty::Inferred => "inferred",
        Certainty::Practice => "known in the trade",
        Certainty::Unknown => "not known",
    };
    facts.add("sure", &format!("{sure}: {}", rules.source));
}

pub(crate) fn target_name(target: DataTarget) -> &'static str {
    match target {
        DataTarget::WorkOffset => "work offset P",
        DataTarget::WorkOffsetFromPosition => {
            "work offset P, so that the current position becomes these numbers"
        }
        DataTarget::ExtendedWorkOffset => "extended work offset P",
        DataTarget::Tool(ToolValue::Length) => "length of tool P",
        DataTarget::Tool(ToolValue::LengthWear) => "wear of the length of tool P",
        DataTarget::Tool(ToolValue::Radius) => "radius or diameter of tool P",
        DataTarget::Tool(ToolValue::RadiusWear) => "wear of the radius or diameter of tool P",
        DataTarget::TurningTool { wear: false } => "geometry of turning tool P",
        DataTarget::TurningTool { wear: true } => "wear of turning tool P",
        DataTarget::ToolTable => "length and radius of tool P",
        DataTarget::ToolFromPosition => {
            "offsets of tool P, so that the current position becomes these numbers"
        }
        DataTarget::ToolFromFixture => {
            "offsets of tool P, so that the current position becomes these numbers in the last work offset"
        }
        DataTarget::Reload => "nothing: the tool table is read again",
        DataTarget::Register => "a register R",
        DataTarget::Other => "not carried out",
        DataTarget::IntoRegister => "a register R, with a value of the control: not followed",
        DataTarget::Lines => "parameters of the control, by the lines up to G11: not carried out",
    }
}

/// `ToolLength` → `tool length`.
pub fn group_name(group: CodeGroup) -> String {
    let mut name = String::new();
    for letter in format!("{group:?}").chars() {
        if letter.is_uppercase() && !name.is_empty() {
            name.push(' ');
        }
        name.extend(letter.to_lowercase());
    }
    name
}
