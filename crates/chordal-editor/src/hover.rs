//! The text shown when the pointer rests on a word: its form, whatever the language.

use chordal::Diagnostic;
use chordal::diagnostics::TextRange;

/// The text shown when the pointer rests on a word or a name.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Hover {
    /// The bytes of the text that it explains.
    pub range: TextRange,
    /// The explanation as Markdown.
    pub text: String,
}

/// Markdown of an explanation: the first line bold, the rest as a code block, so that its columns line up.
pub(crate) fn as_markdown(text: &str) -> String {
    let text = text.trim_end();
    match text.split_once('\n') {
        None => format!("**{text}**"),
        Some((first, rest)) if rest.trim().is_empty() => format!("**{first}**"),
        Some((first, rest)) => format!("**{}**\n```text\n{rest}\n```", first.trim_end()),
    }
}

/// A diagnostic as markdown: message, alarm, notes and help.
pub fn diagnostic_markdown(diagnostic: &Diagnostic) -> String {
    let info = diagnostic.code.info();
    let mut text = format!("**{}** ({} {})", diagnostic.message, info.id, info.name);
    if let Some(alarm) = &diagnostic.alarm {
        text.push_str(&format!("\n\nThe control shows: {alarm}"));
    }
    for note in &diagnostic.notes {
        text.push_str(&format!("\n\n{note}"));
    }
    if let Some(help) = &diagnostic.help {
        text.push_str(&format!("\n\nHelp: {help}"));
    }
    text
}
