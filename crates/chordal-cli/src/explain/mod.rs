//! What a diagnostic, a code, a letter or a setting means: from the registry and the tables,
//! so that it is what the program itself goes by.

mod code;
mod letter;

use chordal::Code;
use chordal::control::table::ControlTable;
use chordal::control::{
    COMMON_SETTINGS, CONTROLS, Control, Field, Parameters, Setting, value_text,
};

use self::code::{code_name, code_text, codes};
use self::letter::letter_text;
use crate::failure::{Failure, Verdict};
use crate::machine;
use crate::numbers::short;
use crate::terminal::say;

const EXAMPLES: &str = "\
Examples:
  chordal explain CH401                       a message, by its number
  chordal explain radius-mismatch             or by its name
  chordal explain G154                        a code, on every control that has it
  chordal explain M17 --machine fadal-4020    a code on one control
  chordal explain R                           a letter
  chordal explain \"Setting 40\"                a setting";

/// Explains a message, a code, a letter or a setting
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// `CH401`, `radius-mismatch`, `G2`, `G02.1`, `M17`, `R`, `"Setting 40"`
    #[arg(value_name = "CODE|WORD", required = true)]
    words: Vec<String>,

    /// Only on this machine: a built-in name or a machine file
    #[arg(long, short, value_name = "NAME|FILE.toml")]
    machine: Option<String>,
}

/// Codes that differ by more, in tenths, are no slips of each other.
const NEAR: u16 = 20;

/// A control to explain on.
pub struct View {
    pub table: &'static ControlTable,
    pub parameters: Parameters,
}

pub fn run(args: &Args) -> Result<Verdict, Failure> {
    let views: Vec<View> = match &args.machine {
        Some(name) => {
            let (control, _) = Control::of(&machine::named(name)?);
            vec![View { table: control.table, parameters: control.parameters }]
        }
        None => {
            CONTROLS.map(|table| View { table, parameters: table.parameters }).into_iter().collect()
        }
    };
    let word = args.words.join(" ");
    let text = Code::find(&word)
        .map(diagnostic_text)
        .or_else(|| code_of(&word).and_then(|(letter, code)| code_text(letter, code, &views)))
        .or_else(|| one_letter(&word).and_then(|letter| letter_text(letter, &views)))
        .or_else(|| setting_text(&word, &views));
    match text {
        Some(text) => say(&text).map(|()| Verdict::Clean),
        None => Err(unknown(&word, &views)),
    }
}

/// A diagnostic: severity, explanation, and what each control shows.
fn diagnostic_text(code: Code) -> String {
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
fn without_places(alarm: &str) -> String {
    let mut parts = alarm.split('{');
    let mut text = parts.next().unwrap_or_default().to_string();
    for part in parts {
        text.push('…');
        text.push_str(part.split_once('}').map_or(part, |(_, rest)| rest));
    }
    text
}

/// `G2`, `g02.1`, `M 17` → letter and ten times the number.
fn code_of(word: &str) -> Option<(u8, u16)> {
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

/// G or M with a number, however large.
fn is_code(word: &str) -> bool {
    let rest = word.strip_prefix(['G', 'g', 'M', 'm']);
    rest.is_some_and(|rest| rest.trim_start().starts_with(|first: char| first.is_ascii_digit()))
}

fn one_letter(word: &str) -> Option<u8> {
    match word.as_bytes() {
        [letter] if letter.is_ascii_alphabetic() => Some(letter.to_ascii_uppercase()),
        _ => None,
    }
}

/// A text for each control, those that say the same together; at the end the controls that
/// say nothing. `None` when none says anything.
pub fn sections(
    name: &str,
    views: &[View],
    on: impl Fn(&View) -> Option<String>,
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
pub struct Facts {
    pub text: String,
    label: &'static str,
}

impl Facts {
    /// A text that begins behind the title.
    pub fn new(first: &str) -> Facts {
        Facts { text: format!(" {first}\n"), label: "" }
    }

    /// Adds a line.
    pub fn add(&mut self, label: &'static str, words: &str) {
        let shown = if label == self.label { "" } else { label };
        self.text.push_str(&format!("  {shown:10}{words}\n"));
        self.label = label;
    }
}

/// For each field its setting: the control's own name before the common one.
pub fn settings(table: &ControlTable, fields: &[Field]) -> Vec<&'static Setting> {
    let of = |field: &Field| {
        let own = table.settings.iter().find(|setting| setting.field == *field);
        own.or_else(|| COMMON_SETTINGS.iter().find(|setting| setting.field == *field))
    };
    fields.iter().filter_map(of).collect()
}

/// The present value of a setting in its own words; a length in both units.
pub fn own_value(setting: &Setting, parameters: &Parameters) -> String {
    let value = value_text(parameters, setting.field);
    if let Some(mm) = value.strip_suffix(" mm").and_then(|mm| mm.parse().ok()) {
        return both_units(mm);
    }
    let own = setting.values.iter().find(|(_, common)| *common == value);
    own.map_or(value.clone(), |(own, _)| format!("{own} ({value})"))
}

/// `12.7 mm (0.5 in)`: one of them is the reader's.
pub fn both_units(mm: f64) -> String {
    format!("{} mm ({} in)", short(mm, 4), short(mm / 25.4, 4))
}

fn setting_text(word: &str, views: &[View]) -> Option<String> {
    let on = |view: &View| {
        let settings = view.table.settings.iter().chain(COMMON_SETTINGS);
        let found = settings.into_iter().find(|setting| setting.name.eq_ignore_ascii_case(word))?;
        let value = own_value(found, &view.parameters);
        let mut facts = Facts::new(found.text);
        facts.add("value", &value);
        if !found.source.is_empty() {
            facts.add("source", found.source);
        }
        Some(facts.text)
    };
    sections(word, views, on)
}

/// A list that does not run on for ever.
pub fn some(names: &[String]) -> String {
    const MOST: usize = 14;
    let shown = names[..names.len().min(MOST)].join(" ");
    if names.len() > MOST { format!("{shown} … ({} in all)", names.len()) } else { shown }
}

/// Nobody knows it: the nearest that somebody does.
fn unknown(word: &str, views: &[View]) -> Failure {
    let titles: Vec<&str> = views.iter().map(|view| view.table.title).collect();
    if is_code(word) {
        let name = word.to_uppercase();
        let message = match titles.as_slice() {
            [one] => format!("{one} has no {name}"),
            _ => format!("no control here has {name}"),
        };
        let near = code_of(word).and_then(|(letter, code)| {
            let all = views.iter().flat_map(|view| codes(view.table, letter));
            let near = all.min_by_key(|row| row.code.abs_diff(code))?;
            let close = near.code.abs_diff(code) <= NEAR;
            close.then(|| format!("{} is {}", code_name(letter, near.code), near.title))
        });
        return Failure::Use { message, help: near };
    }
    if let Some(letter) = one_letter(word) {
        let message = format!("{} has no meaning on {}", char::from(letter), titles.join(", "));
        return Failure::Use { message, help: None };
    }
    let names = Code::ALL.iter().flat_map(|code| [code.info().id, code.info().name]);
    let settings = views.iter().flat_map(|view| view.table.settings).chain(COMMON_SETTINGS);
    let likeness = |name: &str| strsim::jaro_winkler(&name.to_lowercase(), &word.to_lowercase());
    let near = names
        .chain(settings.map(|setting| setting.name))
        .map(|name| (likeness(name), name))
        .filter(|(likeness, _)| *likeness > 0.8)
        .max_by(|a, b| a.0.total_cmp(&b.0));
    let message = format!("`{word}` is no message, code, letter or setting");
    match near {
        Some((_, near)) => Failure::wrong(message, format!("did you mean `{near}`?")),
        None => Failure::wrong(
            message,
            "write a message (CH401), a code (G154), a letter (R) or a setting",
        ),
    }
}
