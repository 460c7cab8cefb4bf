//! What a diagnostic, a code, a letter or a setting means: from the registry and the tables,
//! so that it is what the program itself goes by.

use std::collections::BTreeMap;

use chordal::Code;
use chordal::control::table::{Action, CodeRow, ControlTable, CycleKind, DataTarget, Group};
use chordal::control::{
    COMMON_SETTINGS, CONTROLS, Control, Field, Parameters, Setting, value_text,
};

use crate::explain_letter::letter_text;
use crate::failure::{Failure, Verdict};
use crate::machine;
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
            // `{n}` is the number of the block.
            text.push_str(&format!("  {title:width$}  {}\n", alarm.replace("{n}", "…")));
        }
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

fn one_letter(word: &str) -> Option<u8> {
    match word.as_bytes() {
        [letter] if letter.is_ascii_alphabetic() => Some(letter.to_ascii_uppercase()),
        _ => None,
    }
}

/// `G54.1`.
pub fn code_name(letter: u8, code: u16) -> String {
    let (letter, whole) = (char::from(letter), code / 10);
    if code % 10 == 0 { format!("{letter}{whole}") } else { format!("{letter}{whole}.{}", code % 10) }
}

/// The codes of a table under a letter.
pub fn codes(table: &ControlTable, letter: u8) -> &'static [CodeRow] {
    if letter == b'G' { table.g_codes } else { table.m_codes }
}

fn code_text(letter: u8, code: u16, views: &[View]) -> Option<String> {
    let on = |view: &View| {
        let row = codes(view.table, letter).iter().find(|row| row.code == code)?;
        Some(row_text(letter, row, view))
    };
    sections(&code_name(letter, code), views, on)
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
        .map(|(titles, body)| format!("{name} on {}: {body}", titles.join(", ")))
        .collect();
    if !without.is_empty() {
        parts.push(format!("Not on {}.\n", without.join(", ")));
    }
    Some(parts.join("\n"))
}

/// What a code does on a control.
fn row_text(letter: u8, row: &CodeRow, view: &View) -> String {
    let mut text = format!("{}\n", row.title);
    let mut fact = |label: &str, words: String| text.push_str(&format!("  {label:8}{words}\n"));
    match row.action {
        Action::NotSimulated => {
            fact("note", "the control carries it out; Chordal says so where it stands, and does not".into());
            return text;
        }
        Action::NoEffect => fact("effect", "none on the path or the time".into()),
        _ => {}
    }
    if !row.words.is_empty() {
        fact("takes", format!("{}, beside the axes and F", spaced(row.words)));
    }
    match row.group {
        Group::OneShot => fact("holds", "in its own block only".into()),
        Group::Auxiliary | Group::Stopping | Group::Calling | Group::ToolChange => {}
        group => {
            let others: Vec<String> = codes(view.table, letter)
                .iter()
                .filter(|other| other.group == group && other.code != row.code)
                .map(|other| code_name(letter, other.code))
                .collect();
            let group = group_name(group);
            if others.is_empty() {
                fact("group", group);
            } else {
                fact("group", format!("{group}; another of it takes its place: {}", some(&others)));
            }
        }
    }
    facts_of_action(row.action, view).into_iter().for_each(|(label, words)| fact(label, words));
    let fields = fields_of(row.action);
    for (index, setting) in settings(view.table, fields).into_iter().enumerate() {
        let value = own_value(setting, &view.parameters);
        let label = if index == 0 { "settings" } else { "" };
        text.push_str(&format!("  {label:8} {} = {value}: {}\n", setting.name, setting.text));
    }
    text
}

/// What the table says of an action beside its settings.
fn facts_of_action(action: Action, view: &View) -> Vec<(&'static str, String)> {
    match action {
        Action::Dwell => view
            .table
            .dwell
            .iter()
            .map(|word| {
                let (letter, whole, point) = (char::from(word.letter), word.integer_s, word.point_s);
                ("time", format!("{letter}1 is {whole} s, {letter}1. is {point} s"))
            })
            .collect(),
        Action::SetData => {
            let mut targets: BTreeMap<u16, &str> = BTreeMap::new();
            for (number, target) in view.table.set_data {
                targets.insert(*number, target_name(*target));
            }
            targets.iter().map(|(number, what)| ("writes", format!("L{number}: {what}"))).collect()
        }
        _ => Vec::new(),
    }
}

fn target_name(target: DataTarget) -> &'static str {
    match target {
        DataTarget::WorkOffset => "work offset P",
        DataTarget::WorkOffsetFromPosition => "work offset P, so that the position gets these numbers",
        DataTarget::ExtendedWorkOffset => "extended work offset P",
        DataTarget::Length => "length of tool P",
        DataTarget::LengthWear => "wear of the length of tool P",
        DataTarget::Radius => "radius or diameter of tool P",
        DataTarget::RadiusWear => "wear of the radius or diameter of tool P",
        DataTarget::ToolTable => "length and radius of tool P",
        DataTarget::Register => "a register R",
        DataTarget::Other => "something that is not simulated",
    }
}

/// The settings that change what an action does.
fn fields_of(action: Action) -> &'static [Field] {
    use Field as F;
    match action {
        Action::Rapid => &[F::Rapid],
        Action::ArcCw | Action::ArcCcw => &[
            F::ArcCenter,
            F::RadiusErrorTolerance,
            F::ArcMismatch,
            F::SemicircleTolerance,
            F::CenterAndRadius,
            F::FullCircleByRadius,
            F::HelixFeed,
            F::MaxRadius,
            F::Spiral,
        ],
        Action::SpiralCw | Action::SpiralCcw => &[F::Spiral, F::SpiralEndTolerance],
        Action::PlaneXy | Action::PlaneZx | Action::PlaneYz => &[F::PlaneCodes],
        Action::Inch | Action::Millimetre => &[F::Units, F::UnitsByG70],
        Action::Absolute | Action::Incremental => &[F::StartDistance],
        Action::CompensationLeft | Action::CompensationRight => {
            &[F::RadiusOffsets, F::MaxRadiusCompensated]
        }
        Action::LengthPlus | Action::LengthMinus => &[F::LengthMustMatchTool, F::LengthByHAlone],
        Action::Cycle(CycleKind::ChipBreak) => &[F::ChipBreak],
        Action::Cycle(CycleKind::Peck) => &[F::PeckClearance],
        Action::CallProgram | Action::CallLabel => &[F::Nesting, F::PackedCalls],
        Action::Return => &[F::ReturnLabelInCallee],
        _ => &[],
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

/// The present value of a setting in its own words.
pub fn own_value(setting: &Setting, parameters: &Parameters) -> String {
    let value = value_text(parameters, setting.field);
    let own = setting.values.iter().find(|(_, common)| *common == value);
    own.map_or(value.clone(), |(own, _)| format!("{own} ({value})"))
}

fn setting_text(word: &str, views: &[View]) -> Option<String> {
    let on = |view: &View| {
        let settings = view.table.settings.iter().chain(COMMON_SETTINGS);
        let found = settings.into_iter().find(|setting| setting.name.eq_ignore_ascii_case(word))?;
        let value = own_value(found, &view.parameters);
        let source = if found.source.is_empty() { String::new() } else { format!("\n  source  {}", found.source) };
        Some(format!("{}\n  value   {value}{source}\n", found.text))
    };
    sections(word, views, on)
}

/// `ToolLength` → `tool length`.
fn group_name(group: Group) -> String {
    let mut name = String::new();
    for letter in format!("{group:?}").chars() {
        if letter.is_uppercase() && !name.is_empty() {
            name.push(' ');
        }
        name.extend(letter.to_lowercase());
    }
    name
}

/// `I J K R`.
pub fn spaced(letters: &str) -> String {
    letters.chars().map(String::from).collect::<Vec<_>>().join(" ")
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
    if let Some((letter, code)) = code_of(word) {
        let all = views.iter().flat_map(|view| codes(view.table, letter));
        let near = all.min_by_key(|row| row.code.abs_diff(code));
        let message = match titles.as_slice() {
            [one] => format!("{one} has no {}", code_name(letter, code)),
            _ => format!("no control here has {}", code_name(letter, code)),
        };
        return match near {
            Some(row) => {
                Failure::wrong(message, format!("{} is {}", code_name(letter, row.code), row.title))
            }
            None => Failure::Use { message, help: None },
        };
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
        None => Failure::wrong(message, "write a message (CH401), a code (G154), a letter (R) or a setting"),
    }
}
