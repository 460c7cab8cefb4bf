//! The tokens of a block, for colours.

use chordal_diagnostics::TextRange;
use chordal_kernel::{Token, TokenClass};
use chordal_syntax::{Block, BlockKind, Lexicon, Word, WordValue};

use crate::marks::{StatementMark, marks};

/// The tokens of a block, in the order of the text.
pub fn block_tokens(text: &[u8], lexicon: &Lexicon, block: &Block, tokens: &mut Vec<Token>) {
    let first = tokens.len();
    let comments = block.comments.iter();
    tokens.extend(comments.map(|range| Token { range: *range, class: TokenClass::Comment }));
    match block.kind {
        BlockKind::Percent | BlockKind::Folder => {
            tokens.push(Token { range: block.range, class: TokenClass::Mark });
        }
        BlockKind::Macro(range) => macro_tokens(text, lexicon, range, tokens),
        BlockKind::Words => {}
    }
    if block.delete.is_some() {
        let text = block.range.slice(text);
        if let Some(at) = text.iter().position(|byte| *byte == b'/') {
            let start = block.range.start + at as u32;
            tokens.push(Token { range: TextRange::new(start, start + 1), class: TokenClass::Mark });
        }
    }
    for word in &block.words {
        word_tokens(text, lexicon, word, tokens);
    }
    tokens[first..].sort_by_key(|token: &Token| token.range.start);
}

fn word_tokens(text: &[u8], lexicon: &Lexicon, word: &Word, tokens: &mut Vec<Token>) {
    let class = class_of(word);
    if let WordValue::Expression(range) = word.value {
        let letter = TextRange::new(word.range.start, range.start);
        tokens.push(Token { range: letter, class });
        macro_tokens(text, lexicon, range, tokens);
    } else {
        tokens.push(Token { range: word.range, class });
    }
}

/// The class of a word by its letter.
pub fn class_of(word: &Word) -> TokenClass {
    if word.register.is_some() {
        return TokenClass::Variable;
    }
    if matches!(word.value, WordValue::Missing) {
        return TokenClass::Unknown;
    }
    match word.letter {
        _ if word.comma => TokenClass::Parameter,
        b'O' => TokenClass::Program,
        b'N' => TokenClass::Label,
        b'G' => TokenClass::GCode,
        b'M' => TokenClass::MCode,
        b'X' | b'Y' | b'Z' | b'A' | b'B' | b'C' | b'U' | b'V' | b'W' => TokenClass::Axis,
        b'F' | b'S' => TokenClass::Speed,
        b'T' | b'D' | b'H' => TokenClass::Tool,
        _ => TokenClass::Parameter,
    }
}

fn macro_tokens(text: &[u8], lexicon: &Lexicon, range: TextRange, tokens: &mut Vec<Token>) {
    for (mark, range) in marks(text, range, lexicon) {
        let class = match mark {
            StatementMark::Variable => TokenClass::Variable,
            StatementMark::Word => TokenClass::Keyword,
            StatementMark::Number => TokenClass::Number,
            StatementMark::Text => TokenClass::Text,
            StatementMark::Comment => TokenClass::Comment,
        };
        tokens.push(Token { range, class });
    }
}
