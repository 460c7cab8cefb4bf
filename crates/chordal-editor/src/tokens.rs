//! The words of a text by what they are, for colours.

use chordal::diagnostics::TextRange;
use chordal::syntax::{Block, BlockKind, Value, Word};

use crate::Program;
use crate::scan::{Mark, marks};

/// What a piece of text is.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum Class {
    /// A comment with its marks.
    Comment,
    /// `%`, folder lines, block delete.
    Mark,
    /// O word or other head of a program.
    Program,
    /// N word or other label.
    Label,
    /// G code.
    GCode,
    /// M code.
    MCode,
    /// X Y Z A B C U V W: where to.
    Axis,
    /// F and S.
    Speed,
    /// T, D and H.
    Tool,
    /// Any other word.
    Parameter,
    /// A variable or a register.
    Variable,
    /// A word of the macro language.
    Keyword,
    /// A number within a macro statement.
    Number,
    /// A text within a macro statement.
    Text,
    /// What cannot be read.
    Unknown,
}

impl Class {
    /// All classes, in the order in which protocols number them.
    pub const ALL: [Class; 15] = [
        Class::Comment,
        Class::Mark,
        Class::Program,
        Class::Label,
        Class::GCode,
        Class::MCode,
        Class::Axis,
        Class::Speed,
        Class::Tool,
        Class::Parameter,
        Class::Variable,
        Class::Keyword,
        Class::Number,
        Class::Text,
        Class::Unknown,
    ];
}

/// A piece of text and its class.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Token {
    /// The text.
    pub range: TextRange,
    /// What it is.
    pub class: Class,
}

impl Program {
    /// The tokens of the lines from `from` up to, not including, `to`, in the order of the text.
    pub fn tokens(&self, from: u32, to: u32) -> Vec<Token> {
        let mut tokens = Vec::new();
        self.blocks(from, to, |block| {
            let first = tokens.len();
            block_tokens(self, block, &mut tokens);
            tokens[first..].sort_by_key(|token: &Token| token.range.start);
        });
        tokens
    }
}

fn block_tokens(program: &Program, block: &Block, tokens: &mut Vec<Token>) {
    let comments = block.comments.iter();
    tokens.extend(comments.map(|range| Token { range: *range, class: Class::Comment }));
    match block.kind {
        BlockKind::Percent | BlockKind::Folder => {
            tokens.push(Token { range: block.range, class: Class::Mark });
        }
        BlockKind::Macro(range) => macro_tokens(program, range, tokens),
        BlockKind::Words => {}
    }
    if block.delete.is_some() {
        let text = block.range.slice(program.text());
        if let Some(at) = text.iter().position(|byte| *byte == b'/') {
            let start = block.range.start + at as u32;
            tokens.push(Token { range: TextRange::new(start, start + 1), class: Class::Mark });
        }
    }
    for word in &block.words {
        word_tokens(program, word, tokens);
    }
}

fn word_tokens(program: &Program, word: &Word, tokens: &mut Vec<Token>) {
    let class = class_of(word);
    if let Value::Expression(range) = word.value {
        let letter = TextRange::new(word.range.start, range.start);
        tokens.push(Token { range: letter, class });
        macro_tokens(program, range, tokens);
    } else {
        tokens.push(Token { range: word.range, class });
    }
}

/// The class of a word by its letter.
pub(crate) fn class_of(word: &Word) -> Class {
    if word.register.is_some() {
        return Class::Variable;
    }
    if matches!(word.value, Value::Missing) {
        return Class::Unknown;
    }
    match word.letter {
        _ if word.comma => Class::Parameter,
        b'O' => Class::Program,
        b'N' => Class::Label,
        b'G' => Class::GCode,
        b'M' => Class::MCode,
        b'X' | b'Y' | b'Z' | b'A' | b'B' | b'C' | b'U' | b'V' | b'W' => Class::Axis,
        b'F' | b'S' => Class::Speed,
        b'T' | b'D' | b'H' => Class::Tool,
        _ => Class::Parameter,
    }
}

fn macro_tokens(program: &Program, range: TextRange, tokens: &mut Vec<Token>) {
    for (mark, range) in marks(program.text(), range, program.lexicon()) {
        let class = match mark {
            Mark::Variable => Class::Variable,
            Mark::Word => Class::Keyword,
            Mark::Number => Class::Number,
            Mark::Text => Class::Text,
            Mark::Comment => Class::Comment,
        };
        tokens.push(Token { range, class });
    }
}
