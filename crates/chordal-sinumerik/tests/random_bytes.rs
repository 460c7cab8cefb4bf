//! The reader takes any bytes.

use chordal_diagnostics::TextRange;
use chordal_sinumerik::syntax::{BlockReader, tokens, units};
use proptest::prelude::*;

/// Pieces of the language, so that random lines come near to real ones.
const PIECES: [&str; 48] = [
    "N10 ",
    "/2",
    ":5",
    "LAB:",
    "G1",
    "X10",
    "X=",
    "R1",
    "R[",
    "]",
    "(",
    ")",
    ",",
    "\"",
    "'H1F'",
    "'",
    "IF ",
    "GOTOF ",
    "CASE ",
    " OF ",
    "DEFAULT ",
    "FOR ",
    " TO ",
    "REPEAT ",
    "P=2",
    "MCALL ",
    "CALL ",
    "BLOCK ",
    "PCALL ",
    "DEF REAL ",
    "PROC ",
    "VAR ",
    "STRING[",
    "EXTERN ",
    "DEFINE ",
    " AS ",
    "AC(",
    "SET(",
    "<<",
    "==",
    " AND ",
    "NOT ",
    "-",
    ".5",
    "EX-3",
    ";",
    "\n",
    "%_N_A_MPF\n",
];

fn read_all(text: &[u8]) {
    let whole = text.len() as u32;
    let mut end = 0;
    for block in BlockReader::new(text) {
        assert!(block.range.start >= end && block.range.end <= whole);
        end = block.range.end;
        let mut at = block.range.start;
        for statement in &block.statements {
            assert!(statement.range.start >= at && statement.range.end <= block.range.end);
            at = statement.range.end;
        }
        for fault in &block.faults {
            assert!(fault.range.start <= fault.range.end && fault.range.end <= block.range.end);
        }
    }
    let mut start = 0;
    for unit in units(text) {
        assert_eq!(unit.range.start, start);
        start = unit.range.end;
    }
    assert_eq!(start, whole);
    let mut at = 0;
    for token in tokens(text, TextRange::new(0, whole)) {
        assert!(token.range.start >= at && token.range.end > token.range.start);
        at = token.range.end;
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(4000))]

    #[test]
    fn any_bytes_are_read(text in prop::collection::vec(any::<u8>(), 0..300)) {
        read_all(&text);
    }

    #[test]
    fn any_pieces_are_read(pieces in prop::collection::vec(prop::sample::select(&PIECES[..]), 0..60)) {
        read_all(pieces.concat().as_bytes());
    }
}
