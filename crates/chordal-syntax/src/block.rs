//! Blocks, words, their values, and sets of letters.

use chordal_diagnostics::{Diagnostic, TextRange};

use crate::Decimal;

/// The value after an address letter.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum WordValue {
    /// A literal.
    Number(Decimal),
    /// The value of a register (`X+R3`), with its sign.
    Register {
        /// The digit of `R0` … `R9`.
        index: u8,
        /// True for a minus sign (`-R3`).
        negative: bool,
    },
    /// The text of a macro expression (`#101`, `[#1+2]`).
    Expression(TextRange),
    /// No readable value; the block has the diagnostic.
    Missing,
}

/// An address letter and its value.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Word {
    /// Upper case, `A`–`Z`.
    pub letter: u8,
    /// The register number of a register word (`R0+1.` → 0), else `None`.
    pub register: Option<u8>,
    /// There is a comma before the letter (`,R1.`: corner radius).
    pub comma: bool,
    /// The value.
    pub value: WordValue,
    /// The position of letter and value in the text.
    pub range: TextRange,
}

impl Word {
    /// The literal; `None` if the value is not one.
    #[inline]
    pub fn number(&self) -> Option<Decimal> {
        match self.value {
            WordValue::Number(number) => Some(number),
            _ => None,
        }
    }

    /// True for a polar radius or angle (`@5`, `^30`).
    pub const fn is_polar(&self) -> bool {
        matches!(self.letter, b'@' | b'^')
    }
}

/// A set of address letters.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default, Hash)]
pub struct Letters(pub u32);

impl Letters {
    /// The empty set.
    pub const NONE: Letters = Letters(0);

    /// The letters of an upper-case text.
    pub const fn of(text: &str) -> Letters {
        let bytes = text.as_bytes();
        let (mut bits, mut at) = (0, 0);
        while at < bytes.len() {
            bits |= 1 << (bytes[at] - b'A');
            at += 1;
        }
        Letters(bits)
    }

    /// True when `letter` is in the set.
    #[inline]
    pub const fn has(self, letter: u8) -> bool {
        self.0 & (1 << (letter - b'A')) != 0
    }

    /// Adds a letter.
    #[inline]
    pub const fn insert(&mut self, letter: u8) {
        self.0 |= 1 << (letter - b'A');
    }

    /// True if the sets have a letter in common.
    #[inline]
    pub const fn meets(self, other: Letters) -> bool {
        self.0 & other.0 != 0
    }

    /// True if every letter is also in `other`.
    #[inline]
    pub const fn within(self, other: Letters) -> bool {
        self.0 & !other.0 == 0
    }

    /// The letters in alphabetical order.
    pub fn iter(self) -> impl Iterator<Item = char> {
        ('A'..='Z').filter(move |letter| self.has(*letter as u8))
    }

    /// The letters of this set that are not in the other.
    #[inline]
    pub const fn without(self, other: Letters) -> Letters {
        Letters(self.0 & !other.0)
    }

    /// The letters that are in either set.
    #[inline]
    pub const fn union(self, other: Letters) -> Letters {
        Letters(self.0 | other.0)
    }
}

/// The kind of a block.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum BlockKind {
    /// Words, comments, or both.
    #[default]
    Words,
    /// `%`, with any text after it.
    Percent,
    /// A folder line of a memory dump (`&F=/USER/`).
    Folder,
    /// The text of a macro statement (`#1=2`, `IF[…]GOTO5`, `# IF V1 > 2 THEN …`).
    Macro(TextRange),
}

/// Block delete: `/`, `/2`; from the first word, or from the middle of the block.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct BlockDelete {
    /// The number of the switch; 1 if none is written.
    pub switch: u8,
    /// The number of the switch is written.
    pub numbered: bool,
    /// It is at the start of its line.
    pub first: bool,
    /// The index of the first word that is deleted.
    pub from_word: usize,
}

/// One block. The reader reuses it for every block.
#[derive(Clone, Debug, Default)]
pub struct Block {
    /// The text of the block, without its line end.
    pub range: TextRange,
    /// Line of the file, from 1.
    pub line: u32,
    /// Its kind.
    pub kind: BlockKind,
    /// Block delete, when there is a `/`.
    pub delete: Option<BlockDelete>,
    /// The words in order.
    pub words: Vec<Word>,
    /// Radius `@` and angle `^` of a polar target, which are not in `words` and `letters`.
    pub polar: Vec<Word>,
    /// The first channel mark of the block (`$2`, `!2L1`).
    pub channel: Option<TextRange>,
    /// Comments, including their delimiters.
    pub comments: Vec<TextRange>,
    /// At least one value is an expression.
    pub expressions: bool,
    /// There are words after a comma (`,R1.`), which are not in `letters`.
    pub commas: bool,
    /// What could not be read.
    pub problems: Vec<Diagnostic>,
    letters: Letters,
    repeated: Letters,
    first: [u8; 26],
}

impl Block {
    /// An empty block, to be filled by a reader.
    pub fn new() -> Block {
        Block::default()
    }

    pub(crate) fn clear(&mut self, start: u32, line: u32) {
        self.range = TextRange::new(start, start);
        self.line = line;
        self.kind = BlockKind::Words;
        self.delete = None;
        self.expressions = false;
        self.commas = false;
        self.words.clear();
        self.polar.clear();
        self.channel = None;
        self.comments.clear();
        self.problems.clear();
        self.letters = Letters::NONE;
        self.repeated = Letters::NONE;
    }

    /// Adds a word. It is public so that a repeat or a cycle can build blocks.
    #[inline(always)]
    pub fn push(&mut self, word: Word) {
        if word.comma {
            // `,R1.` and `,C1.` are not R and C words: they are found only by iterating over all words.
            self.commas = true;
        } else if self.letters.has(word.letter) {
            self.repeated.insert(word.letter);
        } else {
            self.letters.insert(word.letter);
            self.first[(word.letter - b'A') as usize] = self.words.len().min(255) as u8;
        }
        self.words.push(word);
    }

    /// Adds a word or a polar word (`@5`, `^30`).
    pub fn push_any(&mut self, word: Word) {
        if word.is_polar() { self.polar.push(word) } else { self.push(word) }
    }

    /// Removes the words with index `from` and above (block delete in the middle of a block).
    pub fn truncate(&mut self, from: usize) {
        let kept: Vec<Word> = self.words.drain(..).take(from).collect();
        if from == 0 {
            self.polar.clear();
        }
        self.letters = Letters::NONE;
        self.repeated = Letters::NONE;
        self.commas = false;
        kept.into_iter().for_each(|word| self.push(word));
    }

    /// The letters of the words in the block.
    #[inline]
    pub const fn letters(&self) -> Letters {
        self.letters
    }

    /// The letters that occur more than once.
    #[inline]
    pub const fn repeated(&self) -> Letters {
        self.repeated
    }

    /// The first word with a letter; `None` if there is none.
    #[inline]
    pub fn word(&self, letter: u8) -> Option<&Word> {
        if !self.letters.has(letter) {
            return None;
        }
        let first = self.first[(letter - b'A') as usize] as usize;
        if first < 255 { self.words.get(first) } else { self.all(letter).next() }
    }

    /// The last word with a letter, which is the one that counts if a letter is repeated; `None` if there is none.
    #[inline]
    pub fn last(&self, letter: u8) -> Option<&Word> {
        if self.repeated.has(letter) {
            self.words.iter().rev().find(|word| word.letter == letter && !word.comma)
        } else {
            self.word(letter)
        }
    }

    /// All words with a letter, in order.
    pub fn all(&self, letter: u8) -> impl Iterator<Item = &Word> {
        self.words.iter().filter(move |word| word.letter == letter && !word.comma)
    }

    /// True if the block has nothing to execute.
    pub fn is_idle(&self) -> bool {
        self.words.is_empty()
            && self.polar.is_empty()
            && self.channel.is_none()
            && self.kind == BlockKind::Words
    }
}
