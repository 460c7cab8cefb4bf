//! Reading never fails and keeps every character.

#![allow(clippy::disallowed_methods, reason = "the programs are files")]

use std::fs;
use std::path::{Path, PathBuf};

use chordal_heidenhain::syntax::{KlartextReader, KlartextStatement, LineReader};
use proptest::prelude::*;

fn programs(part: &str) -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/heidenhain").join(part);
    let entries = fs::read_dir(folder).expect("the programs");
    let files = entries.map(|entry| entry.expect("a file").path());
    let mut files: Vec<PathBuf> =
        files.filter(|path| path.extension().is_some_and(|own| own == "h" || own == "i")).collect();
    files.sort();
    files
}

/// The right programs have no fault in their text.
#[test]
fn right_programs_are_read() {
    for path in programs("programs") {
        let text = fs::read(&path).expect("a program");
        for block in KlartextReader::new(&text) {
            assert_eq!(block.faults, [], "{} line {}", path.display(), block.line);
            assert_ne!(block.statement, KlartextStatement::Unknown, "{}", path.display());
        }
    }
}

/// What is read of a text: the blocks lie one after the other, and between them are blanks and continuation signs alone.
fn check_spans(text: &[u8]) {
    let mut end = 0_usize;
    for block in LineReader::new(text) {
        let (start, next) = (block.range.start as usize, block.range.end as usize);
        assert!(end <= start && start <= next && next <= text.len());
        let between = &text[end..start];
        assert!(between.iter().all(u8::is_ascii_whitespace), "{between:?}");
        let mut inside: Vec<_> = block.parts.iter().chain(&block.comments).copied().collect();
        inside.sort();
        for (one, two) in inside.iter().zip(inside.iter().skip(1)) {
            assert!(one.end <= two.start);
        }
        end = next;
    }
    assert!(text[end..].iter().all(u8::is_ascii_whitespace));
    for block in KlartextReader::new(text) {
        for fault in block.faults {
            assert!(fault.range.end as usize <= text.len());
            assert!(!fault.message.is_empty());
        }
    }
}

/// Pieces of which random programs are made.
const PIECES: [&str; 50] = [
    "N10",
    "G01",
    "G98 L1",
    "L1,3",
    "D01",
    "P01",
    "*",
    "%",
    "G54",
    "H",
    "L",
    "LP",
    "C",
    "CC",
    "CR",
    "CT",
    "X",
    "IX",
    "+",
    "-",
    "10",
    "Q1",
    "QL2",
    "=",
    "(",
    ")",
    "SIN",
    "^",
    "FN 4:",
    "DIV",
    "IF",
    "GOTO LBL 1",
    "CYCL DEF 200",
    "CYCL DEF 7.1",
    "Q200=",
    "~",
    ";",
    "TOOL CALL",
    "DR",
    "\"",
    "REP",
    "/",
    "\n",
    "M99",
    "M140 MB",
    "APPR LCT",
    "BLK FORM 0.1",
    "PATTERN DEF POS1 (",
    "FN 18: SYSREAD",
    "9 .0",
];

proptest! {
    #[test]
    fn any_bytes_are_read(text in proptest::collection::vec(any::<u8>(), 0..200)) {
        check_spans(&text);
        // The other form of programs.
        check_spans(&[b"%1 G71 *\n", text.as_slice()].concat());
    }

    #[test]
    fn any_pieces_are_read(
        pieces in proptest::collection::vec((0..PIECES.len(), any::<bool>()), 0..60)
    ) {
        let text: String = pieces
            .iter()
            .map(|(piece, blank)| format!("{}{}", PIECES[*piece], if *blank { " " } else { "" }))
            .collect();
        check_spans(text.as_bytes());
        check_spans(format!("%1 G71 *\n{text}").as_bytes());
    }
}

/// Deep formulas are refused, and long ones are read.
#[test]
fn formulas_have_a_largest_depth() {
    let deep = format!("Q1 = {}1", "(".repeat(100_000));
    let block = KlartextReader::new(deep.as_bytes()).next().expect("a block");
    assert!(!block.faults.is_empty());
    let long = format!("Q1 = 1{}", " + 1".repeat(100_000));
    let block = KlartextReader::new(long.as_bytes()).next().expect("a block");
    assert_eq!(block.faults, []);
}
