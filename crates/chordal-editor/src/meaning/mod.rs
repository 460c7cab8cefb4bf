//! What a diagnostic, a code, a letter or a setting means: from the registry and the tables, so
//! that it is what the interpreter itself goes by.

mod alarm;
mod code;
mod form;
mod letter;
mod number;
mod word;

use chordal::control::table::ControlTable;
use chordal::control::{
    COMMON_SETTINGS, CONTROLS, Control, Parameters, Setting, SettingField, telling_number,
};
use chordal::{Code, Machine};

pub use alarm::alarm_text;
pub use chordal::control::table::code_name;
pub(crate) use code::target_name;
pub use code::{code_brief, code_text, codes, group_name};
pub use form::{example, word_rows};
pub use letter::{letter_meanings, letter_text};
pub use number::number_text;
pub use word::word_meaning;

/// A control to explain on.
#[derive(Clone, Debug)]
pub struct ControlView {
    /// Its table.
    pub table: &'static ControlTable,
    /// Its habits, settings of the machine counted.
    pub parameters: Parameters,
}

impl ControlView {
    /// As a machine has it.
    pub fn of(control: &Control) -> ControlView {
        ControlView { table: control.table, parameters: control.parameters }
    }

    /// The control of a machine; empty when its language has no tables of codes.
    pub fn on(machine: &Machine) -> Vec<ControlView> {
        Control::of(machine).map(|(control, _)| ControlView::of(&control)).into_iter().collect()
    }

    /// All controls as they are without a machine's settings.
    pub fn all() -> Vec<ControlView> {
        CONTROLS
            .iter()
            .copied()
            .map(|table| ControlView { table, parameters: table.parameters })
            .collect()
    }
}

/// A diagnostic: severity, explanation, and what each control shows.
pub fn diagnostic_text(code: Code) -> String {
    let info = code.info();
    let severity = info.severity.word();
    let mut text = format!("{} {}: {}\n", info.id, info.name, info.summary);
    text.push_str(&format!("\n{}\n\nSeverity: {severity}.\n", info.explanation.trim()));
    let alarms: Vec<_> =
        CONTROLS.iter().filter_map(|table| Some((table.title, table.alarm(code)?))).collect();
    if !alarms.is_empty() {
        text.push_str("\nWhat the controls show:\n");
        let width = alarms.iter().map(|(title, _)| title.len()).max().unwrap_or(0);
        for (title, alarm) in alarms {
            text.push_str(&format!("  {title:width$}  {}\n", without_places(alarm)));
        }
    }
    text
}

/// `N={n}` → `N=…`: the control fills in a number.
pub(crate) fn without_places(alarm: &str) -> String {
    let mut parts = alarm.split('{');
    let mut text = parts.next().unwrap_or_default().to_string();
    for part in parts {
        text.push('…');
        text.push_str(part.split_once('}').map_or(part, |(_, rest)| rest));
    }
    text
}

/// `G2`, `g02.1`, `M 17` → letter and ten times the number.
pub fn code_of(word: &str) -> Option<(u8, u16)> {
    let letter = one_letter(word.get(..1)?).filter(|letter| matches!(letter, b'G' | b'M'))?;
    let number = word[1..].trim();
    let (whole, tenth) = number.split_once('.').unwrap_or((number, "0"));
    let digits = |text: &str| text.bytes().all(|byte| byte.is_ascii_digit());
    if !digits(whole) || !digits(tenth) || tenth.len() != 1 {
        return None;
    }
    let code = whole.parse::<u16>().ok()?.checked_mul(10)?;
    Some((letter, code.checked_add(tenth.parse().ok()?)?))
}

/// The letter of a text that is one, in upper case.
pub fn one_letter(word: &str) -> Option<u8> {
    match word.as_bytes() {
        [letter] if letter.is_ascii_alphabetic() => Some(letter.to_ascii_uppercase()),
        _ => None,
    }
}

/// A setting on each control that has it; `None` when none has.
pub fn setting_text(word: &str, views: &[ControlView]) -> Option<String> {
    let on = |view: &ControlView| {
        let settings = view.table.settings.iter().chain(COMMON_SETTINGS);
        let found = settings.into_iter().find(|setting| setting.name.eq_ignore_ascii_case(word))?;
        let value = own_value(found, &view.parameters);
        let mut facts = FactLines::new(found.text);
        facts.add("value", &value);
        if !found.source.is_empty() {
            facts.add("source", found.source);
        }
        Some(facts.text)
    };
    sections(word, views, on)
}

/// A text for each control, those that say the same together; at the end the controls that
/// say nothing. `None` when none says anything.
pub(crate) fn sections(
    name: &str,
    views: &[ControlView],
    on: impl Fn(&ControlView) -> Option<String>,
) -> Option<String> {
    let mut sections: Vec<(Vec<&str>, String)> = Vec::new();
    let mut without = Vec::new();
    for view in views {
        let title = view.table.title;
        match on(view) {
            None => without.push(title),
            Some(body) => match sections.iter_mut().find(|(_, other)| *other == body) {
                Some((titles, _)) => titles.push(title),
                None => sections.push((vec![title], body)),
            },
        }
    }
    if sections.is_empty() {
        return None;
    }
    let mut parts: Vec<String> = sections
        .into_iter()
        .map(|(titles, body)| format!("{name} on {}:{body}", titles.join(", ")))
        .collect();
    if !without.is_empty() {
        parts.push(format!("Not on {}.\n", without.join(", ")));
    }
    Some(parts.join("\n"))
}

/// Lines of facts with their labels on the left; a label is not said twice in a row.
pub(crate) struct FactLines {
    pub text: String,
    label: &'static str,
}

impl FactLines {
    /// A text that begins after the title.
    pub fn new(first: &str) -> FactLines {
        FactLines { text: format!(" {first}\n"), label: "" }
    }

    /// Adds a line.
    pub fn add(&mut self, label: &'static str, words: &str) {
        let shown = if label == self.label { "" } else { label };
        self.text.push_str(&format!("  {shown:10}{words}\n"));
        self.label = label;
    }
}

/// For each field its setting: the control's own name before the common one.
pub(crate) fn settings(table: &ControlTable, fields: &[SettingField]) -> Vec<&'static Setting> {
    let of = |field: &SettingField| {
        let own = table.settings.iter().find(|setting| setting.field == *field);
        own.or_else(|| COMMON_SETTINGS.iter().find(|setting| setting.field == *field))
    };
    fields.iter().filter_map(of).collect()
}

/// The present value of a setting in its own words; a length in both units.
pub fn own_value(setting: &Setting, parameters: &Parameters) -> String {
    let value = setting.field.value_text(parameters);
    if let Some(mm) = value.strip_suffix(" mm").and_then(|mm| mm.parse().ok()) {
        return both_units(mm);
    }
    let own = setting.values.iter().find(|(_, common)| *common == value);
    own.map_or(value.clone(), |(own, _)| format!("{own} ({value})"))
}

/// `12.7 mm (0.5 in)`: one of them is the reader's.
pub fn both_units(mm: f64) -> String {
    format!("{} mm ({} in)", telling_number(mm, 4), telling_number(mm / 25.4, 4))
}

/// A list that does not run on for ever.
pub(crate) fn some(names: &[String]) -> String {
    const MAX_FACT_LINES: usize = 14;
    let shown = names[..names.len().min(MAX_FACT_LINES)].join(" ");
    if names.len() > MAX_FACT_LINES {
        format!("{shown} … ({} in all)", names.len())
    } else {
        shown
    }
}
