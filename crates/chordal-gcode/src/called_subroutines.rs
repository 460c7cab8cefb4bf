//! Finds the subroutines that a text calls by O words.

use chordal_diagnostics::{FileId, TextRange};
use chordal_syntax::{
    Block, BlockKind, BlockReader, ExpressionParser, FlowWord, Lexicon, OLabel, parse_o_word,
};

use crate::macros::names::normalized;

/// Longest line that is examined.
const MAX_LINE_BYTES: usize = 4096;

/// The names of the subroutines that a text calls by O words (`o<name> call`), each once: the
/// files that a control would look for when they are not in the text.
pub fn called_subs(text: &[u8], lexicon: &Lexicon) -> Vec<String> {
    let mut names = Vec::new();
    if !lexicon.o_words {
        return names;
    }
    for word in [b"call", b"CALL", b"Call"] {
        for at in memchr::memmem::find_iter(text, word) {
            let from = at.saturating_sub(MAX_LINE_BYTES);
            let start =
                memchr::memrchr2(b'\n', b'\r', &text[from..at]).map_or(from, |i| from + i + 1);
            names.extend(called_in(&text[start..at + word.len()], lexicon));
        }
    }
    names.sort_unstable();
    names.dedup();
    names
}

fn called_in(line: &[u8], lexicon: &Lexicon) -> Option<String> {
    let mut reader = BlockReader::new(line, FileId(0), *lexicon);
    let mut block = Block::new();
    if !reader.read(&mut block) {
        return None;
    }
    let BlockKind::Macro(range) = block.kind else { return None };
    let mut parser = ExpressionParser::new(line, FileId(0), lexicon.grammar);
    parser.start(line, FileId(0), TextRange::new(range.start, line.len() as u32));
    if !range.slice(line).first()?.eq_ignore_ascii_case(&b'O') {
        return None;
    }
    let word = parse_o_word(&mut parser);
    match (word.label, word.word) {
        (OLabel::Text(label), Some(FlowWord::Call)) => Some(normalized(label.slice(line))),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn calls_by_name_and_number() {
        let text =
            b"o<Lift> call\n  N5 O100 CALL [1]\n(o<no> call)\no<lift> call [2]\no[#1] call\n";
        let lexicon = chordal_dialect::table(chordal_machine::ControlName::Linuxcnc)
            .expect("a table")
            .lexicon;
        let of = |o_words| Lexicon { o_words, ..lexicon };
        assert_eq!(called_subs(text, &of(true)), ["100", "lift"]);
        assert!(called_subs(text, &of(false)).is_empty());
    }
}
