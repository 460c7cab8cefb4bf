//! Programs in which faults are planted: their lines and words, and what a run does in each line.

pub mod kinds;
mod rules;
pub mod turning;

use std::collections::BTreeMap;
use std::ops::Range;

use chordal::control::{AfterBlock, RunOptions, RunSink};
use chordal::{Command, CommandKind, Diagnostic, Job, Machine, Report, Sink, Source, SourceMap};
use chordal_load::Loaded;

/// One word of a line.
pub struct Word {
    pub letter: u8,
    /// Letter and value in the text of the line.
    pub range: Range<usize>,
    /// What stands after the letter.
    pub value: String,
}

/// What a run does in a line, at its first pass.
#[derive(Clone, Copy, Default)]
pub struct Done {
    pub ran: bool,
    pub rapid: bool,
    /// A straight cut or an arc; also those of a cycle.
    pub cuts: bool,
    pub arc: bool,
    pub cycle: bool,
    /// Cutter compensation is on after it.
    pub compensated: bool,
    pub incremental: bool,
    pub tool: u32,
    /// Where the tool is after it, mm.
    pub place: [f64; 3],
}

pub struct Line {
    /// From 1.
    pub number: usize,
    pub text: String,
    /// Of lines without macro statements and expressions; without comments.
    pub words: Vec<Word>,
    pub done: Done,
}

impl Line {
    pub fn word(&self, letter: u8) -> Option<&Word> {
        self.words.iter().find(|word| word.letter == letter)
    }

    /// One of the G codes, written with or without a zero before.
    pub fn g(&self, codes: &[&str]) -> Option<&Word> {
        self.code(b'G', codes)
    }

    pub fn m(&self, codes: &[&str]) -> Option<&Word> {
        self.code(b'M', codes)
    }

    fn code(&self, letter: u8, codes: &[&str]) -> Option<&Word> {
        let same = |word: &&Word| {
            let value = word.value.trim_start_matches('0');
            let value = if value.is_empty() { "0" } else { value };
            word.letter == letter && codes.contains(&value)
        };
        self.words.iter().find(same)
    }

    /// The line with another word in place of this one.
    pub fn with(&self, word: &Word, new: &str) -> String {
        format!("{}{new}{}", &self.text[..word.range.start], &self.text[word.range.end..])
    }

    pub fn without(&self, word: &Word) -> String {
        self.with(word, "")
    }

    /// The line with more words after its last one, before a comment.
    pub fn and(&self, more: &str) -> Option<String> {
        let end = self.words.last()?.range.end;
        Some(format!("{}{more}{}", &self.text[..end], &self.text[end..]))
    }
}

/// A right program with what a run of it does.
pub struct Part {
    pub title: String,
    pub control: &'static str,
    pub lines: Vec<Line>,
    machine: Machine,
}

impl Part {
    /// The lines of a loaded program.
    pub fn new(title: &str, loaded: &Loaded) -> Part {
        let text = String::from_utf8_lossy(loaded.text()).into_owned();
        let control = loaded.control();
        let done = trace(loaded);
        let lines = text.lines().enumerate().map(|(index, line)| Line {
            number: index + 1,
            text: line.into(),
            words: words(line, control),
            done: done.get(&(index + 1)).copied().unwrap_or_default(),
        });
        let machine = loaded.machine().clone();
        Part { title: title.into(), control, lines: lines.collect(), machine }
    }

    /// The program with one line changed.
    pub fn planted(&self, line: usize, new: &str) -> String {
        let lines = self.lines.iter();
        let lines = lines.map(|own| if own.number == line { new } else { own.text.as_str() });
        lines.map(|text| format!("{text}\n")).collect()
    }

    /// What a check on the machine of the right program says.
    pub fn check(&self, text: &str) -> Report {
        let mut sources = SourceMap::new();
        sources.add(Source::new("part", text.as_bytes()));
        let options = RunOptions { assumed_machine: true, ..RunOptions::default() };
        let job = Job::new(sources, self.machine.clone()).expect("a job");
        job.options(options).check()
    }
}

/// The words of a line without its comments; none where it has macro statements or expressions.
fn words(line: &str, control: &str) -> Vec<Word> {
    let code = code_of(line, control);
    let macros = code.iter().any(|byte| matches!(byte, b'#' | b'[' | b'=' | b'"' | b'<' | b','));
    let mut at = 0;
    let mut words = Vec::new();
    if macros || code.contains(&b'/') {
        return words;
    }
    while at < code.len() {
        let letter = code[at].to_ascii_uppercase();
        if !letter.is_ascii_alphabetic() {
            at += 1;
            continue;
        }
        let value = |byte: &&u8| byte.is_ascii_digit() || matches!(**byte, b'.' | b'-' | b'+');
        let length = code[at + 1..].iter().take_while(value).count();
        if length == 0 {
            // Keywords, O words, or a bare letter.
            return Vec::new();
        }
        let range = at..at + 1 + length;
        words.push(Word { letter, value: line[at + 1..range.end].into(), range });
        at += 1 + length;
    }
    words
}

/// The bytes of a line with blanks where it has comments.
fn code_of(line: &str, control: &str) -> Vec<u8> {
    let mut code = line.as_bytes().to_vec();
    let mut open = false;
    for byte in &mut code {
        let ends = *byte == b')' && control != "fadal";
        open |= *byte == b'(' || *byte == b';';
        if open || !byte.is_ascii() {
            *byte = b' ';
        }
        open &= !ends;
    }
    code
}

/// What a run does in each line.
fn trace(loaded: &Loaded) -> BTreeMap<usize, Done> {
    let mut trace = Trace::default();
    loaded.job().expect("a job").run(&mut trace);
    trace.0
}

#[derive(Default)]
struct Trace(BTreeMap<usize, Done>);

impl Sink for Trace {
    fn command(&mut self, command: &Command) {
        let done = self.0.entry(command.origin.line as usize).or_default();
        match command.kind {
            CommandKind::Rapid { .. } => done.rapid = true,
            CommandKind::Line { .. } => done.cuts = true,
            CommandKind::Arc { .. } => (done.arc, done.cuts) = (true, true),
            _ => {}
        }
        done.cycle |= command.origin.cycle;
    }

    fn diagnostic(&mut self, _: Diagnostic) {}
}

impl RunSink for Trace {
    fn wants_blocks(&self) -> bool {
        true
    }

    fn block_done(&mut self, origin: &chordal::control::Origin, after: &AfterBlock) {
        let done = self.0.entry(origin.line as usize).or_default();
        if !done.ran {
            let modal = (after.modal)();
            done.ran = true;
            done.compensated = modal.side != chordal::control::CompensationSide::Off;
            done.incremental = modal.incremental;
            done.tool = modal.tool;
            done.place = [modal.position[0], modal.position[1], modal.position[2]];
        }
    }
}
