//! Conversational programs that begin at one of their lines.

#![allow(clippy::disallowed_methods, reason = "the programs are files")]

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use chordal::control::{AxisMask, Command, Origin, RunSink, Sink};
use chordal::{Job, Machine, Source, SourceMap};
use chordal_rewrite::restart::{RefusalReason, RestartProgram, restart};

/// The least number of lines of the frozen programs that move and at which they can begin.
const PROVED: usize = 1;

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/heidenhain/programs")
}

fn read(path: &Path) -> String {
    String::from_utf8_lossy(&std::fs::read(path).expect("a file")).into_owned()
}

fn name(path: &Path) -> String {
    path.file_name().unwrap_or_default().to_string_lossy().into_owned()
}

/// The programs of the folder with an extension.
fn programs(extension: &str) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(folder()).expect("a folder");
    let mut paths: Vec<PathBuf> = entries
        .map(|entry| entry.expect("an entry").path())
        .filter(|path| path.extension().is_some_and(|own| own == extension))
        .collect();
    paths.sort();
    paths
}

/// The machine that a program needs.
fn machine_of(text: &str) -> Machine {
    let five = ["PLANE ", "M128", "TCPM", "CYCL DEF 19"];
    let is_five = five.iter().any(|word| text.contains(word));
    let name = if is_five { "heidenhain-ac-trunnion" } else { "heidenhain-mill" };
    Machine::from_builtin(name).expect("a machine")
}

fn job_of(first: &str, text: &str, others: &[PathBuf]) -> Job<'static> {
    let mut sources = SourceMap::new();
    sources.add(Source::new(first, text.as_bytes().to_vec()));
    for other in others.iter().filter(|other| name(other) != first) {
        sources.add(Source::new(&name(other), read(other).into_bytes()));
    }
    Job::new(sources, machine_of(text)).expect("good settings")
}

/// The moves of a run from where the main program first comes to a byte of its text.
struct MovesFrom {
    start: u32,
    has_begun: bool,
    /// The lines with moves, of the first text.
    lines: BTreeSet<u32>,
    /// Where each move ends, and the axes whose place is known.
    ends: Vec<([f64; 6], AxisMask)>,
    calls: chordal::control::CallPath,
}

impl Sink for MovesFrom {
    fn command(&mut self, command: &Command) {
        let Origin { span, line, call, .. } = command.origin;
        let is_first = span.file == chordal::diagnostics::FileId(0);
        let Some(motion) = command.kind.motion() else { return };
        let is_main = is_first && call == self.calls;
        self.has_begun |= is_main && span.range.start >= self.start;
        if is_first {
            self.lines.insert(line);
        }
        if self.has_begun {
            self.ends.push((motion.to, motion.to_known));
        }
    }

    fn diagnostic(&mut self, _: chordal::Diagnostic) {}
}

impl RunSink for MovesFrom {}

fn moves_from(job: &Job, start: u32) -> MovesFrom {
    let calls = chordal::control::CallPath::default();
    let mut moves =
        MovesFrom { start, has_begun: false, lines: BTreeSet::new(), ends: Vec::new(), calls };
    drop(job.run(&mut moves));
    moves
}

/// All moves of both programs end at the same places, counted from the last on.
fn ends_are_same(job: &Job, done: &RestartProgram, text: &str) -> Result<(), String> {
    let start: usize = text.split_inclusive('\n').take(done.line as usize - 1).map(str::len).sum();
    let old = moves_from(job, start as u32);
    let new = moves_from(&job.with_text(done.text.clone()), done.head_bytes.end);
    if old.ends.len() != new.ends.len() {
        return Err(format!("{} moves, and {} in the new program", old.ends.len(), new.ends.len()));
    }
    // Where the head does not go to the place, the first rapids may come from another one.
    let first = if done.approaches { 2.min(old.ends.len()) } else { 0 };
    for (at, ((old, known), (new, also))) in old.ends.iter().zip(&new.ends).enumerate().skip(first) {
        let is_other = |axis: usize| known.has(axis) && (old[axis] - new[axis]).abs() > 1e-6;
        if (0..6).any(is_other) || known != also {
            return Err(format!("move {at}: {old:?} is {new:?}"));
        }
    }
    Ok(())
}

/// What is refused without the numbers in it.
fn kind_of(reason: RefusalReason, what: &str) -> String {
    let words: Vec<&str> = what
        .split_whitespace()
        .map(|word| if word.chars().any(|c| c.is_ascii_digit()) { "#" } else { word })
        .collect();
    format!("{} {}", reason.word(), words.join(" "))
}

#[test]
fn every_line_that_moves_is_proved_or_refused_with_a_reason() {
    let paths = programs("h");
    let others: Vec<PathBuf> = ["h", "d"].iter().flat_map(|own| programs(own)).collect();
    let mut reasons = BTreeMap::<String, Vec<String>>::new();
    let (mut proved, mut lines) = (0, 0);
    let mut wrong = Vec::new();
    for path in &paths {
        let text = read(path);
        let called: Vec<PathBuf> = others
            .iter()
            .filter(|other| text.to_lowercase().contains(name(other).trim_end_matches(".h")))
            .cloned()
            .collect();
        let job = job_of(&name(path), &text, &called);
        let moving = moves_from(&job, 0).lines;
        let mut own = 0;
        for line in moving.iter().copied() {
            match restart(&job, line) {
                Ok(done) => {
                    own += 1;
                    if let Err(what) = ends_are_same(&job, &done, &text) {
                        wrong.push(format!("{}:{line}: {what}\n{}", name(path), done.head.join("\n")));
                    }
                }
                Err(refused) => {
                    let why = &refused.refusal;
                    assert!(!why.what.is_empty() && !why.help.is_empty());
                    let kind = kind_of(refused.reason, &why.what);
                    reasons.entry(kind).or_default().push(format!("{}:{line}", name(path)));
                }
            }
        }
        println!("{}: {own} of {}", name(path), moving.len());
        proved += own;
        lines += moving.len();
    }
    println!("{} programs, {proved} of {lines} lines", paths.len());
    for (what, places) in &reasons {
        println!("  {} {what}: {}", places.len(), places[..places.len().min(4)].join(" "));
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(proved >= PROVED, "{proved}");
}
