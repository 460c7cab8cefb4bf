//! What a diagnostic, a code, a letter, a setting or an alarm means: from the registry and the tables,
//! so that it is what the program itself goes by.

use chordal::control::{Alarms, COMMON_SETTINGS, control_profile, word_meanings};
use chordal::machine::ControlName;
use chordal::{Code, Machine};

use crate::meaning::{
    ControlView, alarm_text, code_name, code_of, code_text, codes, diagnostic_text, letter_text,
    number_text, one_letter, setting_text,
};

/// Codes that differ by more, in tenths, are not typing errors of each other.
const MAX_TYPING_ERROR_TENTHS: u16 = 20;

/// A word that nothing explains.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UnknownTerm {
    /// What does not go.
    pub message: String,
    /// What does.
    pub help: Option<String>,
}

/// What a word means on some controls: `CH401`, `radius-mismatch`, `G2`, `M17`, `R`, `L9601`, `Setting 40`,
/// `alarm 304`.
///
/// # Errors
/// A word that none of them knows, with the nearest one.
pub fn explain(word: &str, views: &[ControlView]) -> Result<String, UnknownTerm> {
    let alarms: Vec<Alarms> = views
        .iter()
        .map(|view| Alarms { title: view.table.title, texts: view.table.alarms })
        .collect();
    let text = Code::find(word)
        .map(diagnostic_text)
        .or_else(|| code_of(word).and_then(|(letter, code)| code_text(letter, code, views)))
        .or_else(|| one_letter(word).and_then(|letter| letter_text(letter, views)))
        .or_else(|| setting_text(word, views))
        .or_else(|| alarm_text(word, &alarms))
        .or_else(|| number_text(word, views));
    text.ok_or_else(|| unknown(word, views))
}

/// The same on one machine, or on all controls; also words of languages without tables of codes (`CYCL DEF 200`,
/// `CYCLE83`) and the alarms of their controls.
///
/// # Errors
/// A word that none of them knows, with the nearest one.
pub fn explain_on(word: &str, machine: Option<&Machine>) -> Result<String, UnknownTerm> {
    let views = machine.map_or_else(ControlView::all, ControlView::on);
    let meanings = word_meanings(word, machine.map(|machine| machine.control));
    let of_languages = meanings.iter().map(|(title, meaning)| format!("{title}: {meaning}\n"));
    let of_languages: String = of_languages.collect();
    let unknown = match explain(word, &views) {
        Ok(text) if of_languages.is_empty() => return Ok(text),
        Ok(text) => return Ok(format!("{}\n\n{of_languages}", text.trim_end())),
        Err(unknown) => unknown,
    };
    let controls = machine.map_or_else(ControlName::all, |machine| vec![machine.control]);
    let profiles = controls.into_iter().filter_map(control_profile);
    let alarms: Vec<Alarms> = profiles.map(|profile| profile.alarms()).collect();
    let of_languages = Some(of_languages).filter(|text| !text.is_empty());
    alarm_text(word, &alarms).or(of_languages).ok_or(unknown)
}

/// G or M with a number, however large.
fn is_code(word: &str) -> bool {
    let rest = word.strip_prefix(['G', 'g', 'M', 'm']);
    rest.is_some_and(|rest| rest.trim_start().starts_with(|first: char| first.is_ascii_digit()))
}

/// No control knows it: the nearest one that some control knows.
fn unknown(word: &str, views: &[ControlView]) -> UnknownTerm {
    let titles: Vec<&str> = views.iter().map(|view| view.table.title).collect();
    if is_code(word) && !views.is_empty() {
        let name = word.to_uppercase();
        let message = match titles.as_slice() {
            [one] => format!("{one} does not have {name}"),
            _ => format!("no control has {name}"),
        };
        let near = code_of(word).and_then(|(letter, code)| {
            let all = views.iter().flat_map(|view| codes(view.table, letter));
            let near = all.min_by_key(|row| row.code.abs_diff(code))?;
            let close = near.code.abs_diff(code) <= MAX_TYPING_ERROR_TENTHS;
            close.then(|| format!("{} is {}", code_name(letter, near.code), near.title))
        });
        return UnknownTerm { message, help: near };
    }
    if let Some(letter) = one_letter(word)
        && !views.is_empty()
    {
        let message = format!("{} has no meaning on {}", char::from(letter), titles.join(", "));
        return UnknownTerm { message, help: None };
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
    let help = match near {
        Some((_, near)) => format!("did you mean `{near}`?"),
        None => {
            "write a message (CH401), a code (G154), a letter (R), a setting or an alarm (PS0010)"
                .into()
        }
    };
    UnknownTerm { message, help: Some(help) }
}
