//! The machine that is assumed when only the control is known.

use chordal::RunOptions;
use chordal::machine::{AXIS_LETTERS, builtin_names};
use chordal::{Code, Job, Machine, Source, SourceMap};

use crate::head::whole_lines;

/// How much of the beginning is run to see which axes move, bytes.
const HEAD: usize = 256 << 10;

/// The limit on repeated blocks in this run.
const MAX_REPEATED: u64 = 2_000;

/// Why the assumed machine is not the default one of its control.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct MovedAxes {
    /// Axes that the program moves and the default machine does not have.
    pub letters: Vec<char>,
    /// The title of the machine that has them.
    pub machine: String,
}

impl MovedAxes {
    /// `B and C`.
    pub(crate) fn list(&self) -> String {
        let letters: Vec<String> = self.letters.iter().map(char::to_string).collect();
        match letters.as_slice() {
            [] => String::new(),
            [one] => one.clone(),
            [first @ .., last] => format!("{} and {last}", first.join(", ")),
        }
    }
}

/// The machine to assume for a control: the default one or, when the program moves axes that this one does not have,
/// a built-in one that has them.
pub(crate) fn assume(usual: Machine, text: &[u8]) -> (Machine, Option<MovedAxes>) {
    let head = whole_lines(text, HEAD);
    if !names_missing_axis(&usual, head) {
        return (usual, None);
    }
    let letters = missing_axes(&usual, head);
    if letters.is_empty() {
        return (usual, None);
    }
    let built_in = builtin_names().iter().filter_map(|name| Machine::from_builtin(name).ok());
    let mut same = built_in.filter(|machine| machine.control == usual.control);
    match same.find(|machine| letters.iter().all(|letter| has(machine, *letter))) {
        Some(machine) => {
            let moved = MovedAxes { letters, machine: machine.title.clone() };
            (machine, Some(moved))
        }
        None => (usual, None),
    }
}

fn has(machine: &Machine, letter: char) -> bool {
    AXIS_LETTERS.find(letter).is_some_and(|index| machine.axes[index].is_some())
}

/// A quick test: whether the letter of an axis that the machine does not have occurs with a value after it. Most
/// programs need no further test.
fn names_missing_axis(machine: &Machine, text: &[u8]) -> bool {
    let begins_value = |byte: &u8| matches!(byte, b'0'..=b'9' | b'.' | b'-' | b'+' | b'#' | b'[');
    text.windows(2).any(|pair| {
        let letter = pair[0].to_ascii_uppercase();
        matches!(letter, b'A'..=b'C') && begins_value(&pair[1]) && !has(machine, letter.into())
    })
}

/// The axes that a run reports as missing.
fn missing_axes(machine: &Machine, text: &[u8]) -> Vec<char> {
    let mut sources = SourceMap::new();
    sources.add(Source::new("", text));
    let options = RunOptions {
        max_repeated_blocks: MAX_REPEATED,
        assumed_machine: true,
        ..RunOptions::default()
    };
    let Ok(job) = Job::new(sources, machine.clone()) else { return Vec::new() };
    let report = job.options(options).check();
    let missing = report.diagnostics.iter().filter(|one| one.code == Code::NoSuchAxis);
    let words = missing.filter_map(|one| text.get(one.primary.span.range.start as usize));
    let mut letters: Vec<char> =
        words.map(|letter| char::from(letter.to_ascii_uppercase())).collect();
    letters.sort_unstable();
    letters.dedup();
    letters
}
