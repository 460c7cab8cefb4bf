//! Changes of a text by places, and why one cannot be made.

use crate::word_address::OtherLanguage;
use chordal::diagnostics::{Source, TextRange};
use chordal::syntax::{Block, Word};

use crate::Change;

/// A replacement of some text.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) struct WordEdit {
    pub(super) range: TextRange,
    pub(super) text: String,
    pub(super) reason: &'static str,
}

impl WordEdit {
    pub(super) fn new(range: TextRange, text: impl Into<String>, reason: &'static str) -> WordEdit {
        WordEdit { range, text: text.into(), reason }
    }

    /// Puts a text in.
    pub(super) fn insert(at: u32, text: impl Into<String>, reason: &'static str) -> WordEdit {
        WordEdit::new(TextRange::new(at, at), text, reason)
    }
}

/// Why a program stays as it is.
#[derive(Clone, PartialEq, Eq, Debug, thiserror::Error)]
#[error("line {line}: {what}")]
pub struct TransformRefusal {
    /// Line of the text, from 1.
    pub line: u32,
    /// The line as it is written.
    pub text: String,
    /// What stands in the way.
    pub what: String,
    /// What to do about it.
    pub help: String,
}

impl TransformRefusal {
    pub(super) fn new(
        text: &[u8],
        block: &Block,
        what: impl Into<String>,
        help: impl Into<String>,
    ) -> TransformRefusal {
        let words = String::from_utf8_lossy(block.range.slice(text)).trim().to_string();
        TransformRefusal { line: block.line, text: words, what: what.into(), help: help.into() }
    }
}

impl From<OtherLanguage> for TransformRefusal {
    fn from(refused: OtherLanguage) -> TransformRefusal {
        let OtherLanguage { first_line, what, help } = refused;
        TransformRefusal { line: 1, text: first_line, what, help: help.into() }
    }
}

/// The text after edits; of those that overlap the first counts.
pub(super) fn apply(text: &[u8], edits: &mut Vec<WordEdit>) -> Vec<u8> {
    edits.sort_by_key(|edit| (edit.range.start, edit.range.end));
    let mut edited = Vec::with_capacity(text.len());
    let mut at = 0;
    edits.retain(|edit| {
        let is_after = edit.range.start as usize >= at;
        if is_after {
            edited.extend_from_slice(&text[at..edit.range.start as usize]);
            edited.extend_from_slice(edit.text.as_bytes());
            at = edit.range.end as usize;
        }
        is_after
    });
    edited.extend_from_slice(&text[at..]);
    edited
}

/// What edits, in order, change of each line.
pub(super) fn changes(text: &[u8], edits: &[WordEdit]) -> Vec<Change> {
    let source = Source::new("", text);
    let mut changes: Vec<Change> = Vec::new();
    let mut until = 0;
    for (index, edit) in edits.iter().enumerate() {
        let line = source.line_of(edit.range.start);
        if line < until {
            continue;
        }
        // The lines that this edit and those next to it touch.
        let from = source.line_start(line);
        let (mut last, mut end) = (index, line_end(text, edit.range.end));
        while let Some(next) = edits.get(last + 1).filter(|next| next.range.start <= end) {
            end = end.max(line_end(text, next.range.end));
            last += 1;
        }
        let mut after = Vec::new();
        let mut at = from;
        for edit in &edits[index..=last] {
            after.extend_from_slice(TextRange::new(at, edit.range.start).slice(text));
            after.extend_from_slice(edit.text.as_bytes());
            at = edit.range.end;
        }
        after.extend_from_slice(TextRange::new(at, end.max(at)).slice(text));
        until = source.line_of(end) + 1;
        let words =
            |bytes: &[u8]| String::from_utf8_lossy(bytes).replace('\r', "").trim_end().to_string();
        changes.push(Change {
            line,
            before: words(TextRange::new(from, end).slice(text)),
            after: words(&after),
            reason: edit.reason.into(),
        });
    }
    changes
}

/// Where the line that a byte is on ends, its line end left out.
pub(super) fn line_end(text: &[u8], at: u32) -> u32 {
    let rest = text.get(at as usize..).unwrap_or(&[]);
    let length = rest.iter().position(|byte| *byte == b'\n' || *byte == b'\r');
    at + length.unwrap_or(rest.len()) as u32
}

/// A word with another value: all but its number stays.
pub(super) fn with_number(text: &[u8], word: &Word, number: &str) -> String {
    let old = String::from_utf8_lossy(word.range.slice(text)).into_owned();
    if word.register.is_some() {
        // A register word keeps a sign between its number and its value: `R0+1.`.
        let head = old.rfind(['+', '-']).map_or(old.as_str(), |at| &old[..at]);
        let sign = if number.starts_with('-') { "" } else { "+" };
        return format!("{head}{sign}{number}");
    }
    let is_number = |letter: char| letter.is_ascii_digit() || matches!(letter, '.' | '+' | '-');
    let mut head = old.trim_end_matches(is_number);
    if head.trim_end().ends_with(is_number) {
        // Blanks stood in the number.
        head = head.trim_end_matches(|letter: char| is_number(letter) || letter == ' ');
    }
    format!("{head}{number}")
}

/// New words in the place of the first of some, and nothing in the places of the others.
pub(super) fn replace_words(
    text: &[u8],
    old: &[Word],
    new: &str,
    reason: &'static str,
) -> Vec<WordEdit> {
    let one = |(index, word): (usize, &Word)| {
        if index == 0 {
            return WordEdit::new(word.range, new, reason);
        }
        let before = &text[..word.range.start as usize];
        let blanks = before.iter().rev().take_while(|byte| **byte == b' ').count() as u32;
        WordEdit::new(TextRange::new(word.range.start - blanks, word.range.end), "", reason)
    };
    old.iter().enumerate().map(one).collect()
}
