//! Conversational programs written in other forms do the same, and no text, whole or broken, stops a run.

#![allow(clippy::disallowed_methods, reason = "the programs are files")]

use std::fs;
use std::path::Path;

use chordal::{Command, Diagnostic, Job, Machine, RunSink, Severity, Sink, Source, SourceMap};

/// The number of broken programs; `CHORDAL_ROUNDS` is another one.
const BROKEN_PROGRAMS: u64 = 400;

fn programs() -> Vec<(String, String)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/heidenhain/programs");
    let entries = fs::read_dir(folder).expect("the programs");
    let files = entries.map(|entry| entry.expect("a file").path());
    let conversational = files.filter(|path| path.extension().is_some_and(|own| own == "h"));
    let mut found: Vec<(String, String)> = conversational
        .map(|path| {
            let name = path.file_stem().expect("a name").to_string_lossy().into_owned();
            (name, fs::read_to_string(&path).expect("a text"))
        })
        .collect();
    found.sort();
    found
}

fn job(text: &[u8]) -> Job<'static> {
    let machine = Machine::from_builtin("heidenhain-mill").expect("a built-in machine");
    let mut sources = SourceMap::new();
    sources.add(Source::new("part.h", text.to_vec()));
    Job::new(sources, machine).expect("settings")
}

/// The kinds of the commands with their numbers, and the codes of errors, without places in the text.
#[derive(Default, PartialEq, Debug)]
struct RunFacts {
    moves: Vec<[f64; 6]>,
    feeds: Vec<Option<f64>>,
    commands: usize,
    errors: Vec<&'static str>,
}

impl Sink for RunFacts {
    fn command(&mut self, command: &Command) {
        self.commands += 1;
        if let Some(motion) = command.kind.motion() {
            self.moves.push(motion.to);
            self.feeds.push(command.kind.feed().map(|feed| feed.value));
        }
    }

    fn diagnostic(&mut self, diagnostic: Diagnostic) {
        if diagnostic.severity == Severity::Error {
            self.errors.push(diagnostic.code.id());
        }
    }
}

impl RunSink for RunFacts {}

fn facts(text: &str) -> RunFacts {
    let mut facts = RunFacts::default();
    job(text.as_bytes()).run(&mut facts);
    facts
}

/// A line without its block number.
fn without_number(line: &str) -> &str {
    let digits = line.bytes().take_while(u8::is_ascii_digit).count();
    let rest = &line[digits..];
    match rest.strip_prefix(' ') {
        Some(rest) if digits > 0 => rest.trim_start(),
        _ => line,
    }
}

/// The words of a block without its remark.
fn without_remark(line: &str) -> &str {
    line.split(';').next().unwrap_or("").trim_end()
}

/// A program in another form.
type WrittenForm = fn(&str) -> String;

#[test]
fn other_forms_do_the_same() {
    let forms: [(&str, WrittenForm); 6] = [
        ("without block numbers", |text| {
            text.lines().map(|line| format!("{}\n", without_number(line))).collect()
        }),
        ("block numbers in tens", |text| {
            let mut number = 0;
            let numbered = text.lines().map(|line| match without_number(line) {
                own if own.len() == line.len() => format!("{line}\n"),
                own => {
                    number += 10;
                    format!("{number} {own}\n")
                }
            });
            numbered.collect()
        }),
        ("decimal commas", |text| {
            let comma = |line: &str| {
                // Names, remarks and the dots of old cycles are no numbers.
                let is_other =
                    ["BLK", "CYCL DEF", "PGM", "\"", "CALL"].iter().any(|own| line.contains(own));
                match is_other {
                    true => line.to_string(),
                    false => {
                        let words = without_remark(line);
                        format!("{}{}", words.replace('.', ","), &line[words.len()..])
                    }
                }
            };
            text.lines().map(|line| comma(line) + "\n").collect()
        }),
        ("lines that end with a carriage return", |text| text.replace('\n', "\r\n")),
        ("more blanks", |text| {
            let wide = |line: &str| match line.contains('"') || line.contains("PGM") {
                true => line.to_string(),
                false => format!("  {}  ", line),
            };
            text.lines().map(|line| wide(line) + "\n").collect()
        }),
        ("without remarks", |text| {
            let bare = |line: &str| match line.contains('~') || line.trim_start().starts_with(';') {
                true => line.to_string(),
                false => without_remark(line).to_string(),
            };
            text.lines().map(|line| bare(line) + "\n").collect()
        }),
    ];
    let (mut same, mut all) = (0, Vec::new());
    for (name, text) in programs() {
        let own = facts(&text);
        for (form, written) in &forms {
            // Elements of a free contour may name others by their block numbers.
            let names_blocks = [" RX", " RY", " RAN", " PAR", " RPR", " RPA", " RCC"];
            let is_named = names_blocks.iter().any(|word| text.contains(word));
            if form.contains("block numbers") && is_named {
                continue;
            }
            if facts(&written(&text)) == own {
                same += 1;
            } else {
                all.push(format!("{name}: {form}"));
            }
        }
    }
    assert!(all.is_empty(), "{same} are the same, not: {all:#?}");
}

/// The next number of a sequence.
fn next(state: &mut u64) -> u64 {
    *state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
    *state >> 33
}

#[test]
#[allow(clippy::disallowed_methods, reason = "how long a random test runs is for its caller")]
fn broken_programs_get_an_answer() {
    let rounds = std::env::var("CHORDAL_ROUNDS")
        .ok()
        .and_then(|text| text.parse().ok())
        .unwrap_or(BROKEN_PROGRAMS);
    let programs = programs();
    let (mut answered, mut all) = (0, 0);
    for seed in 0..rounds {
        let mut state = seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1;
        let (_, text) = &programs[(next(&mut state) as usize) % programs.len()];
        let mut bytes = text.clone().into_bytes();
        match next(&mut state) % 4 {
            // Half a file.
            0 => bytes.truncate(next(&mut state) as usize % bytes.len()),
            // Bytes of anything.
            1 => {
                for _ in 0..=next(&mut state) % 8 {
                    let at = next(&mut state) as usize % bytes.len();
                    bytes[at] = next(&mut state) as u8;
                }
            }
            // A line twice, or at another place.
            2 => {
                let mut lines: Vec<&str> = text.lines().collect();
                let from = next(&mut state) as usize % lines.len();
                let to = next(&mut state) as usize % lines.len();
                let line = lines[from];
                lines.insert(to, line);
                bytes = lines.join("\n").into_bytes();
            }
            // Digits that are others.
            _ => {
                for _ in 0..=next(&mut state) % 8 {
                    let at = next(&mut state) as usize % bytes.len();
                    if bytes[at].is_ascii_digit() {
                        bytes[at] = b'0' + (next(&mut state) % 10) as u8;
                    }
                }
            }
        }
        let report = job(&bytes).check();
        all += 1;
        answered += usize::from(!report.diagnostics.is_empty());
    }
    println!("{answered} of {all} broken programs have diagnostics");
}
