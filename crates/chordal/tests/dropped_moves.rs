//! Nothing is dropped without a word: every suite program with one word taken out of a block, or set to
//! zero. A block that moved before, and of which words are left that ask for a move, still moves, or
//! something is said that was not said before.

#![allow(
    clippy::disallowed_methods,
    clippy::disallowed_types,
    reason = "a test reads the programs of its folder"
)]

#[path = "suite/grammar.rs"]
#[allow(dead_code, reason = "only the head of a program is read here")]
mod grammar;
#[path = "suite/runner.rs"]
#[allow(dead_code, reason = "only what moved and what was said is looked at")]
mod runner;

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use chordal::Machine;
use chordal::control::Control;
use chordal::diagnostics::FileId;
use chordal::machine::AXIS_LETTERS;
use chordal::syntax::{Block, BlockKind, BlockReader, Word};
use grammar::Program;
use runner::{Ran, run};

/// A word of a program that is changed.
struct Change {
    line: u32,
    letter: char,
    text: String,
    zero: bool,
    /// Axes that other words of the block name, besides the changed one.
    left: Vec<usize>,
    /// Centre, radius or count words are left.
    arc_left: bool,
}

fn programs() -> Vec<PathBuf> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/suite");
    let mut files = Vec::new();
    for folder in std::fs::read_dir(root).unwrap().flatten() {
        files.extend(std::fs::read_dir(folder.path()).unwrap().flatten().map(|file| file.path()));
    }
    files.sort();
    files
}

/// Words whose change leaves the rest of the block as it was: no code that takes the axis words for
/// itself, no call, no number of a block.
fn changes_only_itself(word: &Word) -> bool {
    match word.letter {
        b'G' => {
            let tenths = word.number().map(|number| (number.to_f64() * 10.0) as u32);
            matches!(tenths, Some(0 | 10 | 20 | 30 | 21 | 31 | 170 | 180 | 190 | 400 | 410 | 420))
        }
        b'N' | b'O' | b'M' | b'T' | b'E' => false,
        _ => true,
    }
}

fn changes(text: &str, control: &Control) -> Vec<Change> {
    let mut reader = BlockReader::new(text.as_bytes(), FileId(0), control.table.lexicon);
    let mut block = Block::new();
    let mut found = Vec::new();
    while reader.read(&mut block) {
        // A register, an argument or a coordinate that an expression gives is another thing.
        let plain =
            block.kind == BlockKind::Words && !block.expressions && block.problems.is_empty();
        let registers = block.words.iter().any(|word| word.register.is_some());
        if !plain || registers || block.all(b'G').any(|word| !changes_only_itself(word)) {
            continue;
        }
        for (at, word) in block.words.iter().enumerate() {
            if !changes_only_itself(word) || word.comma {
                continue;
            }
            let others = || block.words.iter().enumerate().filter(|(index, _)| *index != at);
            let axis = |letter: u8| AXIS_LETTERS.as_bytes().iter().position(|axis| *axis == letter);
            let left = others().filter_map(|(_, word)| axis(word.letter)).collect();
            let arc_left = others().any(|(_, word)| b"IJKR".contains(&word.letter));
            for zero in [false, true] {
                if zero && word.letter == b'G' {
                    continue;
                }
                let (start, end) = (word.range.start as usize, word.range.end as usize);
                let letter = word.letter as char;
                let put = if zero { format!("{letter}0") } else { " ".repeat(end - start) };
                found.push(Change {
                    line: block.line,
                    letter,
                    text: format!("{}{put}{}", &text[..start], &text[end..]),
                    zero,
                    left: Vec::clone(&left),
                    arc_left,
                });
            }
        }
    }
    found
}

/// How often each diagnostic stands on each line.
fn said(ran: &Ran) -> BTreeMap<(u32, &'static str), usize> {
    let mut said = BTreeMap::new();
    for told in &ran.told {
        *said.entry((told.line, told.id)).or_default() += 1;
    }
    said
}

/// What was wrong with a change, if anything was.
fn dropped(program: &Program, before: &Ran, change: &Change) -> Option<String> {
    let moved = |ran: &Ran| ran.made.iter().filter(|made| made.line == change.line).count();
    let own: Vec<_> = before.made.iter().filter(|made| made.line == change.line).collect();
    let asked = own.iter().any(|made| {
        let goes = |axis: &usize| made.from[*axis] != made.to[*axis];
        change.left.iter().any(goes) || made.shape.is_some() && change.arc_left
    });
    // A cycle with a count of zero is only remembered, on every control that has it.
    let remembered = change.zero && matches!(change.letter, 'L' | 'K') && own.len() > 1;
    if !asked || remembered {
        return None;
    }
    let changed = Program { text: change.text.clone(), ..program.clone() };
    let after = run(&changed, &program.machine).ok()?;
    if moved(&after) > 0 {
        return None;
    }
    let (was, is) = (said(before), said(&after));
    let more = is.iter().any(|(key, count)| was.get(key).copied().unwrap_or(0) < *count);
    let still = is.keys().any(|(line, _)| *line == change.line);
    if more || still {
        return None;
    }
    let block = change.text.lines().nth(change.line as usize - 1).unwrap_or("");
    let block = block.split("(=").next().unwrap_or(block).trim_end();
    Some(format!("line {}: `{block}` moves nothing and says nothing", change.line))
}

#[test]
fn no_move_is_dropped_without_a_message() {
    let mut tried = 0_usize;
    let mut wrong = Vec::new();
    for file in programs() {
        let text = std::fs::read_to_string(&file).unwrap();
        let program = grammar::read(&text).unwrap();
        let machine = Machine::from_builtin(&program.machine).unwrap();
        let (control, _) = Control::of(&machine).expect("a word-address control");
        let before = run(&program, &program.machine).unwrap();
        for change in changes(&text, &control) {
            tried += 1;
            if let Some(text) = dropped(&program, &before, &change) {
                wrong.push(format!("{}: {text}", file.display()));
            }
        }
    }
    println!("{tried} changes of {} programs", programs().len());
    assert!(tried > 5_000, "only {tried} changes were found");
    assert!(wrong.is_empty(), "{} changes:\n{}", wrong.len(), wrong.join("\n"));
}
