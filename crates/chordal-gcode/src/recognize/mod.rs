//! Recognizes the control that a program was written for, by weighted signs in the text.
//!
//! Every sign counts once, however often it occurs. The signs are defined in the folders of the controls and in
//! [`chordal_dialect::not_read`]; here they are searched for and weighed.

mod catalog;
mod forms;
mod line;
mod pattern;
mod sample;
mod style;
mod tally;

use chordal_dialect::not_read::NotRead;
use chordal_dialect::recognition::RecognitionEvidence;
use chordal_kernel::{ANOTHER_KIND, ControlCandidate, FoundSign};

use catalog::{CATALOG, LanguageSigns, SignTarget};
use line::SampleLine;
use style::TextStyle;
use tally::TextTally;

/// Searches for the signs of all controls with word-address blocks, and for those of the languages that are not read.
pub fn candidates(text: &[u8]) -> Vec<ControlCandidate> {
    let tally = tally(text);
    let mut lines = LineNumbers::new(text);
    let languages = CATALOG.languages.iter();
    languages.filter_map(|listed| candidate(listed, &tally, &mut lines)).collect()
}

/// Whether the beginning of a text leaves it open what a whole number without a point is.
pub fn leaves_whole_numbers_open(text: &[u8]) -> bool {
    let (mut style, mut line) = (TextStyle::default(), SampleLine::default());
    let beginning = &text[..text.len().min(STYLE_HEAD_BYTES)];
    for words in beginning.split(|byte| matches!(byte, b'\n' | b'\r')) {
        let words = &words[..words.len().min(MAX_LINE_BYTES)];
        line.read(words);
        style.record_line(words, &line, 0);
    }
    style.leaves_whole_numbers_open()
}

/// How much of a text shows how its numbers are written, bytes.
const STYLE_HEAD_BYTES: usize = 64 << 10;

fn tally(text: &[u8]) -> TextTally {
    let mut tally = TextTally::new();
    let mut line = SampleLine::default();
    for part in sample::parts(text) {
        let mut at = part.start;
        while at < part.end {
            let rest = &text[at..part.end];
            let end = memchr::memchr2(b'\n', b'\r', rest).unwrap_or(rest.len());
            // The rest of a very long line is not a sign.
            let words = &rest[..end.min(MAX_LINE_BYTES)];
            line.read(words);
            tally.line(words, &line, at);
            at += end + 1;
        }
    }
    tally
}

/// The examined part of a line, bytes.
const MAX_LINE_BYTES: usize = 512;

/// The candidate of a language; `None` for a language that is not read with too little evidence.
fn candidate(
    listed: &LanguageSigns,
    tally: &TextTally,
    lines: &mut LineNumbers,
) -> Option<ControlCandidate> {
    let of = |range: std::ops::Range<usize>| found(range, tally);
    let mut signs = of(listed.first..listed.own);
    let (name, title, control, not_read, kind) = match listed.language {
        SignTarget::Control(name, table) => (table.name, table.title, name, None, table.kind),
        SignTarget::NotRead(language) => {
            (language.name, language.what, language.shown_on, Some(language), None)
        }
    };
    let needed = not_read.map(|language| language.needed).or(kind.map(|kind| kind.needed));
    let of_kind = needed.is_none_or(|needed| weight(&signs) >= needed);
    if not_read.is_some() && !of_kind {
        return None;
    }
    let own = of(listed.own..listed.end);
    if own.is_empty() && not_read.is_some_and(|language| language.needs_own) {
        return None;
    }
    signs.extend(own);
    // Signs that distinguish controls of one kind mean nothing in a program for another kind.
    let weight = if of_kind { weight(&signs) } else { ANOTHER_KIND };
    let mut signs: Vec<FoundSign> = signs
        .into_iter()
        .map(|(evidence, at)| FoundSign {
            sign: evidence.reason,
            line: lines.line_of(at),
            offset: at as u32,
            weight: evidence.weight,
            machine: evidence.machine,
        })
        .collect();
    signs.sort_by_key(|sign| (-sign.weight, sign.offset));
    Some(ControlCandidate {
        name,
        title,
        control,
        not_read: not_read.is_some_and(|language| !language.is_read()),
        weight,
        signs,
        errors: None,
    })
}

/// The signs found and their offsets; of several with the same text only the strongest.
fn found(
    range: std::ops::Range<usize>,
    tally: &TextTally,
) -> Vec<(&'static RecognitionEvidence, usize)> {
    let mut found: Vec<(&'static RecognitionEvidence, usize)> = Vec::new();
    for index in range {
        let evidence = CATALOG.entries[index].evidence;
        let Some(at) = tally.found(index) else { continue };
        match found.iter_mut().find(|(other, _)| other.reason == evidence.reason) {
            Some(same) if same.0.weight < evidence.weight => *same = (evidence, at),
            Some(_) => {}
            None => found.push((evidence, at)),
        }
    }
    found
}

fn weight(signs: &[(&'static RecognitionEvidence, usize)]) -> i32 {
    signs.iter().map(|(evidence, _)| evidence.weight).sum()
}

/// Finds line numbers of offsets; known ones are cached.
struct LineNumbers<'a> {
    text: &'a [u8],
    end: u8,
    known: std::collections::BTreeMap<usize, u32>,
}

impl<'a> LineNumbers<'a> {
    fn new(text: &'a [u8]) -> LineNumbers<'a> {
        let head = &text[..text.len().min(1 << 16)];
        let end = if memchr::memchr(b'\n', head).is_some() { b'\n' } else { b'\r' };
        LineNumbers { text, end, known: std::iter::once((0, 1)).collect() }
    }

    /// The line of an offset, counted from the nearest known one before it.
    fn line_of(&mut self, at: usize) -> u32 {
        let (from, line) =
            self.known.range(..=at).next_back().map_or((0, 1), |(from, line)| (*from, *line));
        let ends = self.text[from..at].iter().filter(|byte| **byte == self.end).count();
        let line = line + ends as u32;
        self.known.insert(at, line);
        line
    }
}

/// The language with a name that is not read; `None` for other names.
pub fn not_read(name: &str) -> Option<&'static NotRead> {
    chordal_dialect::not_read::ALL.iter().copied().find(|language| language.name == name)
}
