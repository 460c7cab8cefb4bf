//! What a diagnostic, a code, a letter, a setting or an alarm means: from the registry and the tables,
//! so that it is what the program itself goes by.

use chordal::Code;
use chordal::control::{COMMON_SETTINGS, Control};
use chordal_editor::meaning::{
    View, alarm_text, code_name, code_of, code_text, codes, diagnostic_text, letter_text,
    one_letter, setting_text,
};
use chordal_load::machine;

use crate::failure::{Failure, Verdict};
use crate::terminal::say;

const EXAMPLES: &str = "\
Examples:
  chordal explain CH401                       a message, by its number
  chordal explain radius-mismatch             or by its name
  chordal explain G154                        a code, on every control that has it
  chordal explain M17 --machine fadal-4020    a code on one control
  chordal explain R                           a letter
  chordal explain \"Setting 40\"                a setting
  chordal explain PS0010                      an alarm of a control, by its number
  chordal explain alarm 304                   or as the control shows it";

/// Explains a message, a code, a letter, a setting or an alarm
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// `CH401`, `radius-mismatch`, `G2`, `G02.1`, `M17`, `R`, `"Setting 40"`, `alarm 304`
    #[arg(value_name = "CODE|WORD", required = true)]
    words: Vec<String>,

    /// Only on this machine: a built-in name or a machine file
    #[arg(long, short, value_name = "NAME|FILE.toml")]
    machine: Option<String>,
}

/// Codes that differ by more, in tenths, are not typing errors of each other.
const NEAR: u16 = 20;

pub fn run(args: &Args) -> Result<Verdict, Failure> {
    let views = match &args.machine {
        Some(name) => vec![View::of(&Control::of(&machine::named(name)?).0)],
        None => View::all(),
    };
    let word = args.words.join(" ");
    let text = Code::find(&word)
        .map(diagnostic_text)
        .or_else(|| code_of(&word).and_then(|(letter, code)| code_text(letter, code, &views)))
        .or_else(|| one_letter(&word).and_then(|letter| letter_text(letter, &views)))
        .or_else(|| setting_text(&word, &views))
        .or_else(|| alarm_text(&word, &views));
    match text {
        Some(text) => say(&text).map(|()| Verdict::Clean),
        None => Err(unknown(&word, &views)),
    }
}

/// G or M with a number, however large.
fn is_code(word: &str) -> bool {
    let rest = word.strip_prefix(['G', 'g', 'M', 'm']);
    rest.is_some_and(|rest| rest.trim_start().starts_with(|first: char| first.is_ascii_digit()))
}

/// No control knows it: the nearest one that some control knows.
fn unknown(word: &str, views: &[View]) -> Failure {
    let titles: Vec<&str> = views.iter().map(|view| view.table.title).collect();
    if is_code(word) {
        let name = word.to_uppercase();
        let message = match titles.as_slice() {
            [one] => format!("{one} does not have {name}"),
            _ => format!("no control has {name}"),
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
    let names = Code::all().flat_map(|code| [code.info().id, code.info().name]);
    let settings = views.iter().flat_map(|view| view.table.settings).chain(COMMON_SETTINGS);
    let likeness = |name: &str| strsim::jaro_winkler(&name.to_lowercase(), &word.to_lowercase());
    let near = names
        .chain(settings.map(|setting| setting.name))
        .map(|name| (likeness(name), name))
        .filter(|(likeness, _)| *likeness > 0.8)
        .max_by(|a, b| a.0.total_cmp(&b.0));
    let message = format!("`{word}` is not a message, code, letter, setting or known alarm");
    match near {
        Some((_, near)) => Failure::wrong(message, format!("did you mean `{near}`?")),
        None => Failure::wrong(
            message,
            "write a message (CH401), a code (G154), a letter (R), a setting or an alarm (PS0010)",
        ),
    }
}
