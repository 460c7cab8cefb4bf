//! Spaces and block numbers, changed only where the motion stays the same.

use std::collections::HashMap;

use chordal::diagnostics::TextRange;
use chordal::syntax::{Block, BlockKind, Word, WordValue};

use super::WordAddressText;
use super::names::{NameRole, SymbolName};
use crate::edit_proof::{FormatEdit, FormatError, as_written};

/// Block numbers as they are wanted.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct NumberingOptions {
    /// Of the first block of each program.
    pub first: u32,
    /// From one to the next.
    pub step: u32,
    /// Blocks without a number get one.
    pub all: bool,
}

/// The largest N number that all controls here read.
const MAX_NUMBER: u32 = 99_999;

impl WordAddressText<'_> {
    /// One space between words and none in them, for the lines from `from` up to, not
    /// including, `to`. Comments, macro statements and what cannot be read stay.
    ///
    /// # Errors
    /// The changed text would run differently.
    pub(crate) fn spaced(&self, from: u32, to: u32) -> Result<Vec<FormatEdit>, FormatError> {
        let mut edits = Vec::new();
        self.blocks(from, to, |block| edits.extend(self.space(block)));
        self.proved(edits)
    }

    /// New block numbers, and jumps that go to them.
    ///
    /// # Errors
    /// Jumps to computed or ambiguous numbers, numbers too large, or a text that would run
    /// differently.
    pub(crate) fn renumbered(
        &self,
        numbering: NumberingOptions,
    ) -> Result<Vec<FormatEdit>, FormatError> {
        self.computed_jump()?;
        let mut numbers = BlockNumberer::new(*self, numbering);
        self.blocks(1, u32::MAX, |block| numbers.block(block));
        let BlockNumberer { mut edits, new, last, .. } = numbers;
        if last > u64::from(MAX_NUMBER) {
            return Err(FormatError::TooLarge { last, most: MAX_NUMBER });
        }
        for place in self.occurrences() {
            let SymbolName::Label { program, number } = place.name else { continue };
            let Some(targets) = new.get(&(program, number)) else { continue };
            if place.role == NameRole::Definition {
                continue;
            }
            let [target] = targets.as_slice() else {
                let line = self.source().line_of(place.range.start);
                return Err(FormatError::Ambiguous { number, line });
            };
            let word = place.range.slice(self.text());
            let letter = word.first().filter(|byte| byte.is_ascii_alphabetic());
            let letter = letter.map_or(String::new(), |byte| char::from(*byte).to_string());
            edits.push(FormatEdit { range: place.range, text: format!("{letter}{target}") });
        }
        edits.sort_by_key(|edit| edit.range.start);
        self.proved(edits)
    }

    fn space(&self, block: &Block) -> Option<FormatEdit> {
        if block.kind != BlockKind::Words || !block.problems.is_empty() {
            return None;
        }
        let text = self.text();
        let words = block.words.iter().map(|word| (word.range, self.tight(word)));
        let comments = block.comments.iter().map(|range| (*range, as_written(text, *range)));
        let mut pieces: Vec<(TextRange, String)> = words.chain(comments).collect();
        pieces.sort_by_key(|(range, _)| range.start);
        let first = pieces.first()?.0.start;
        let gaps_are_blank = pieces.windows(2).all(|pair| {
            let gap = TextRange::new(pair[0].0.end, pair[1].0.start);
            gap.slice(text).iter().all(u8::is_ascii_whitespace)
        });
        let following = TextRange::new(pieces.last()?.0.end, block.range.end);
        if !gaps_are_blank || !following.slice(text).iter().all(u8::is_ascii_whitespace) {
            return None;
        }
        // Block delete hugs the first word.
        let mut line =
            as_written(text, TextRange::new(block.range.start, first)).trim().to_string();
        for (index, (_, piece)) in pieces.iter().enumerate() {
            if index > 0 {
                line.push(' ');
            }
            line.push_str(piece);
        }
        let same = line.as_bytes() == block.range.slice(text);
        (!same).then_some(FormatEdit { range: block.range, text: line })
    }

    /// A word without blanks; an expression stays as it is written.
    fn tight(&self, word: &Word) -> String {
        let text = self.text();
        if let WordValue::Expression(range) = word.value {
            let head = TextRange::new(word.range.start, range.start);
            return without_blanks(text, head) + as_written(text, range).trim();
        }
        without_blanks(text, word.range)
    }

    fn computed_jump(&self) -> Result<(), FormatError> {
        let mut found = None;
        self.blocks(1, u32::MAX, |block| {
            if let BlockKind::Macro(range) = block.kind
                && found.is_none()
            {
                let statement = range.slice(self.text()).to_ascii_uppercase();
                let jump = statement.windows(4).position(|word| word == b"GOTO");
                let following = jump.map(|at| statement[at + 4..].trim_ascii_start());
                if following.and_then(<[u8]>::first).is_some_and(|byte| matches!(byte, b'#' | b'['))
                {
                    found = Some(block.line);
                }
            }
        });
        match found {
            None => Ok(()),
            Some(line) => {
                let text = String::from_utf8_lossy(self.source().line_text(line)).trim().into();
                Err(FormatError::ComputedJump { line, text })
            }
        }
    }
}

fn without_blanks(text: &[u8], range: TextRange) -> String {
    as_written(text, range).chars().filter(|letter| !letter.is_whitespace()).collect()
}

/// Gives numbers to the blocks of a text, program by program.
struct BlockNumberer<'a> {
    program: WordAddressText<'a>,
    numbering: NumberingOptions,
    index: usize,
    begun: bool,
    next: u64,
    last: u64,
    edits: Vec<FormatEdit>,
    /// The new numbers of each old one.
    new: HashMap<(usize, i64), Vec<u64>>,
}

impl<'a> BlockNumberer<'a> {
    fn new(program: WordAddressText<'a>, numbering: NumberingOptions) -> BlockNumberer<'a> {
        BlockNumberer {
            program,
            numbering,
            index: 0,
            begun: false,
            next: u64::from(numbering.first),
            last: 0,
            edits: Vec::new(),
            new: HashMap::new(),
        }
    }

    fn block(&mut self, block: &Block) {
        if block.kind != BlockKind::Words || block.words.is_empty() {
            return;
        }
        if block.word(b'O').is_some() {
            if self.begun {
                self.index += 1;
            }
            self.begun = true;
            self.next = u64::from(self.numbering.first);
            return;
        }
        self.begun = true;
        let number = self.next;
        let text = self.program.text();
        match block.word(b'N') {
            Some(word) => {
                if let Some(old) = word.number().and_then(|number| number.to_integer()) {
                    self.new.entry((self.index, old)).or_default().push(number);
                }
                self.edit(word.range, format!("N{number}"), text);
            }
            None if self.numbering.all => {
                let at = block.words[0].range.start;
                self.edit(TextRange::new(at, at), format!("N{number} "), text);
            }
            None => return,
        }
        self.last = number;
        self.next += u64::from(self.numbering.step.max(1));
    }

    fn edit(&mut self, range: TextRange, new: String, text: &[u8]) {
        if range.slice(text) != new.as_bytes() {
            self.edits.push(FormatEdit { range, text: new });
        }
    }
}
