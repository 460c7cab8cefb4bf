//! Reads blocks. The modules: `macros` finds the ends of expressions and statements, `problems` reports text that is
//! not a word, `remark` finds prose.

mod macros;
mod problems;
mod remark;

use chordal_diagnostics::{
    Applicability, Code, Diagnostic, FileId, Fix, Span, TextRange, line_end_length,
};

use crate::alignment::is_alignment_number;
use crate::block::{Block, BlockDelete, BlockKind, Letters, Word, WordValue};
use crate::decimal::{self, Decimal};
use crate::lexicon::{Lexicon, ParenthesisComment, Semicolon};

/// A position between two blocks.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct BlockPosition {
    /// Offset in the text, bytes.
    pub offset: u32,
    /// Line of the file, from 1.
    pub line: u32,
}

/// Reads blocks from a text, one at a time, into a buffer that the caller owns.
#[derive(Clone, Debug)]
pub struct BlockReader<'a> {
    text: &'a [u8],
    file: FileId,
    lexicon: Lexicon,
    at: usize,
    line: u32,
    end: usize,
    /// Letters that need special treatment: those of registers, and the O of flow control.
    special: Letters,
}

/// The largest number of problems that are reported in one block, so that a megabyte of unreadable text on one line
/// does not give a million.
const PROBLEMS_PER_BLOCK: usize = 8;

/// The largest distance at which the end of a nested comment is searched, bytes: a line of parentheses only must not be
/// read again for each of them.
const MAX_NESTED_COMMENT_BYTES: usize = 1024;

#[derive(Clone, Copy, PartialEq, Eq)]
enum CharClass {
    Letter,
    Blank,
    Digit,
    Other,
    LineEnd,
}

const CLASSES: [CharClass; 256] = {
    let mut table = [CharClass::Other; 256];
    let mut byte = 0;
    while byte < 256 {
        table[byte] = match byte as u8 {
            b'A'..=b'Z' | b'a'..=b'z' => CharClass::Letter,
            // NUL is padding of tapes and memories; DC1–DC4 start and stop a tape punch; 1A is an old end-of-file mark.
            b' ' | b'\t' | 0 | 0x0b | 0x0c | 0x11..=0x14 | 0x1a | 0x7f => CharClass::Blank,
            b'0'..=b'9' | b'.' | b'+' | b'-' => CharClass::Digit,
            b'\n' | b'\r' => CharClass::LineEnd,
            _ => CharClass::Other,
        };
        byte += 1;
    }
    table
};

/// Bytes that show, directly after a number, that it is not a plain one: `1..2`, `1O.5`, `1[`, `1#`.
const STRANGE_AFTER_NUMBER: [bool; 256] = {
    let mut table = [false; 256];
    let strange = b".Oo[#";
    let mut index = 0;
    while index < strange.len() {
        table[strange[index] as usize] = true;
        index += 1;
    }
    table
};

impl<'a> BlockReader<'a> {
    /// A reader at the beginning of `text`.
    pub fn new(text: &'a [u8], file: FileId, lexicon: Lexicon) -> BlockReader<'a> {
        let mut special = Letters::NONE;
        if lexicon.registers {
            special.insert(b'R');
        }
        if lexicon.o_words {
            special.insert(b'O');
        }
        BlockReader { text, file, lexicon, at: 0, line: 1, end: text.len(), special }
    }

    /// The start of the next block.
    pub fn position(&self) -> BlockPosition {
        BlockPosition { offset: self.at as u32, line: self.line }
    }

    /// Continues at a position from [`position`](Self::position).
    pub fn seek(&mut self, position: BlockPosition) {
        self.at = (position.offset as usize).min(self.end);
        self.line = position.line;
    }

    /// Sets the end of reading to `offset`, in bytes.
    pub fn limit(&mut self, offset: u32) {
        self.end = (offset as usize).min(self.text.len());
    }

    /// The text that is read.
    pub fn text(&self) -> &'a [u8] {
        self.text
    }

    /// Fills `block` with the next block that is not empty; false at the end.
    pub fn read(&mut self, block: &mut Block) -> bool {
        loop {
            if self.at >= self.end {
                return false;
            }
            block.clear(self.at as u32, self.line);
            self.read_block(block);
            if !block.is_idle() || !block.comments.is_empty() || !block.problems.is_empty() {
                return true;
            }
        }
    }

    #[inline]
    fn peek(&self) -> u8 {
        if self.at < self.end { self.text[self.at] } else { b'\n' }
    }

    fn read_block(&mut self, block: &mut Block) {
        let text = &self.text[..self.end];
        while let Some(&byte) = text.get(self.at) {
            match CLASSES[byte as usize] {
                CharClass::Letter => {
                    if !self.read_word(block, byte & !0x20, false) {
                        break;
                    }
                }
                CharClass::Blank => self.at += 1,
                CharClass::LineEnd => {
                    block.range.end = self.at as u32;
                    self.skip_line_end();
                    return;
                }
                CharClass::Digit => self.lone_number(block),
                CharClass::Other => {
                    if !self.read_mark(block, byte) {
                        return;
                    }
                }
            }
        }
        block.range.end = self.at as u32;
    }

    fn skip_line_end(&mut self) {
        let rest = &self.text[self.at..self.end];
        // Most lines end with one byte, so that is tested first.
        self.at += match rest {
            [b'\n', next, ..] if *next != b'\r' => 1,
            _ => line_end_length(rest),
        };
        self.line += 1;
    }

    /// Reads a character other than letters, numbers, blanks and line ends. False at the end of the block.
    fn read_mark(&mut self, block: &mut Block, byte: u8) -> bool {
        let start = self.at;
        match byte {
            b'(' => self.parenthesis(block),
            b';' if self.lexicon.semicolon == Semicolon::EndOfBlock => {
                block.range.end = start as u32;
                self.at += 1;
                return false;
            }
            b';' => self.comment_to_line_end(block),
            b'*' if self.lexicon.star_comment => self.comment_to_line_end(block),
            b'\'' if self.lexicon.star_comment => self.comment_to_line_end(block),
            b'%' if block.words.is_empty() => {
                block.kind = BlockKind::Percent;
                if !self.end_of_block_follows() {
                    self.skip_to_line_end();
                }
            }
            // `M30%`: the percent sign after the last block of a tape is a separate block.
            b'%' if self.ends_tape_here() => {
                block.range.end = start as u32;
                return false;
            }
            b'&' if block.words.is_empty() => {
                block.kind = BlockKind::Folder;
                self.skip_to_line_end();
            }
            b'/' => self.block_delete(block),
            b':' if self.program_colon(block) => {
                let is_aligned = is_alignment_number(&self.text[self.at..self.end]);
                self.read_word(block, if is_aligned { b'N' } else { b'O' }, false);
            }
            b',' => self.comma_word(block),
            b'#' if self.lexicon.macro_lines => {
                self.skip_to_line_end();
                block.kind = BlockKind::Macro(TextRange::new(start as u32, self.at as u32));
            }
            b'#' | b'[' => {
                self.skip_statement();
                let range = TextRange::new(start as u32, self.at as u32);
                block.kind = BlockKind::Macro(range);
            }
            b'@' | b'^' if self.lexicon.polar_words => {
                return self.read_any_word(block, byte, false);
            }
            b'$' | b'!' if self.lexicon.channels => self.channel_mark(block),
            b'<' if self.lexicon.named_programs => self.program_name(block),
            _ => self.unexpected(block),
        }
        true
    }

    /// Reads `$2` or `!2L1`: the mark and the digits, letters and marks that follow it.
    fn channel_mark(&mut self, block: &mut Block) {
        let start = self.at as u32;
        let is_of_mark = |byte: &u8| byte.is_ascii_alphanumeric() || matches!(byte, b'$' | b'!');
        let rest = &self.text[self.at + 1..self.end];
        self.at += 1 + rest.iter().take_while(|byte| is_of_mark(byte)).count();
        block.channel.get_or_insert(TextRange::new(start, self.at as u32));
    }

    /// Whether a colon begins a program (`:0097`): only an N number may be before it, and a number must follow.
    fn program_colon(&self, block: &Block) -> bool {
        block.words.iter().all(|word| word.letter == b'N')
            && self.text.get(self.at + 1).is_some_and(u8::is_ascii_digit)
    }

    /// Whether an end of block follows directly on a mark (`%;`); if so, continues there.
    fn end_of_block_follows(&mut self) -> bool {
        let rest = &self.text[self.at + 1..self.end];
        let blanks =
            rest.iter().take_while(|byte| CLASSES[**byte as usize] == CharClass::Blank).count();
        let follows =
            self.lexicon.semicolon == Semicolon::EndOfBlock && rest.get(blanks) == Some(&b';');
        if follows {
            self.at += 1 + blanks;
        }
        follows
    }

    /// Whether there is nothing after a percent sign on its line.
    fn ends_tape_here(&self) -> bool {
        let rest = &self.text[self.at + 1..self.end];
        let blanks =
            rest.iter().take_while(|byte| CLASSES[usize::from(**byte)] == CharClass::Blank).count();
        self.lexicon.semicolon == Semicolon::EndOfBlock
            && rest.get(blanks).is_none_or(|byte| matches!(byte, b'\n' | b'\r' | b';'))
    }

    fn skip_to_line_end(&mut self) {
        let rest = &self.text[self.at..self.end];
        self.at += memchr::memchr2(b'\n', b'\r', rest).unwrap_or(rest.len());
    }

    fn comment_to_line_end(&mut self, block: &mut Block) {
        let start = self.at as u32;
        self.skip_to_line_end();
        block.comments.push(TextRange::new(start, self.at as u32));
    }

    fn parenthesis(&mut self, block: &mut Block) {
        if self.lexicon.parenthesis == ParenthesisComment::ToEndOfLine {
            return self.comment_to_line_end(block);
        }
        let start = self.at;
        let rest = &self.text[start..self.end];
        match memchr::memchr3(b')', b'\n', b'\r', rest) {
            Some(close) if rest[close] == b')' => {
                self.at += close + 1;
                if let Some(inner) = memchr::memchr(b'(', &rest[1..close]) {
                    self.nested_comment(block, start, start + 1 + inner);
                }
            }
            other => {
                self.at += other.unwrap_or(rest.len());
                let line_end = self.at as u32;
                self.problem(block, || {
                    let open = Span::new(self.file, start as u32, start as u32 + 1);
                    let end = Span::new(self.file, line_end, line_end);
                    Diagnostic::new(
                        Code::UnclosedComment,
                        open,
                        "this comment is not closed before the end of the line",
                    )
                    .label("opened here")
                    .help("close the comment with `)`")
                    .fix(Fix {
                        title: "close the comment".into(),
                        span: end,
                        replacement: ")".into(),
                        applicability: Applicability::Safe,
                    })
                });
            }
        }
        block.comments.push(TextRange::new(start as u32, self.at as u32));
    }

    /// Reads a comment with another `(` before its first `)`: if the parentheses are balanced on its line, all of it is
    /// one comment.
    #[cold]
    fn nested_comment(&mut self, block: &mut Block, start: usize, inner: usize) {
        let mut depth = 0_u32;
        let line = self.text[start..self.end].iter().take_while(|byte| !b"\r\n".contains(byte));
        let length = line.take(MAX_NESTED_COMMENT_BYTES).position(|byte| {
            match byte {
                b'(' => depth += 1,
                b')' => depth -= 1,
                _ => {}
            }
            depth == 0
        });
        let close = self.at as u32;
        match length {
            Some(length) => self.at = start + length + 1,
            // There are more `(` than `)`: the first `)` ends the comment, and no text is left over.
            None if self.lexicon.strict_comments => {}
            None => return,
        }
        self.problem(block, || {
            let inner = Span::new(self.file, inner as u32, inner as u32 + 1);
            Diagnostic::new(Code::NestedComment, inner, "there is a comment inside this comment")
                .label("the inner comment begins here")
                .also(
                    Span::new(self.file, close - 1, close),
                    "the control takes this for the end of the comment",
                )
                .help("write the brackets `[` and `]` instead of the inner parentheses")
        });
    }

    fn block_delete(&mut self, block: &mut Block) {
        self.at += 1;
        let (switch, numbered) = match self.peek() {
            digit @ b'1'..=b'9' => {
                self.at += 1;
                (digit - b'0', true)
            }
            _ => (1, false),
        };
        if block.delete.is_none() {
            // An N number does not count: `/N10 …` and `N10 / …` delete the same words.
            let only_number = block.words.iter().all(|word| word.letter == b'N');
            let from_word = if only_number { 0 } else { block.words.len() };
            let first = block.words.is_empty() && block.comments.is_empty();
            block.delete = Some(BlockDelete { switch, numbered, first, from_word });
        }
    }

    fn comma_word(&mut self, block: &mut Block) {
        let start = self.at;
        self.at += 1;
        let letter = self.peek();
        if letter.is_ascii_alphabetic() {
            self.read_word(block, letter & !0x20, true);
        } else {
            self.at = start;
            self.unexpected(block);
        }
    }

    /// Reads a word whose letter is at `self.at`. False if the rest of the line is a macro statement.
    #[inline(always)]
    fn read_word(&mut self, block: &mut Block, letter: u8, comma: bool) -> bool {
        let plain = !comma && !self.special.has(letter);
        if plain
            && !self.lexicon.blanks_in_numbers
            && let Some(rest) = self.text[..self.end].get(self.at + 1..)
            && let Some(head) = rest.first_chunk::<{ decimal::SHORT_BYTES }>()
            && let Some((number, length)) = decimal::scan_short(head)
            && !STRANGE_AFTER_NUMBER[head[length] as usize]
        {
            let start = self.at;
            self.at += 1 + length;
            let range = TextRange::new(start as u32, self.at as u32);
            block.push(Word {
                letter,
                register: None,
                comma,
                value: WordValue::Number(number),
                range,
            });
            return true;
        }
        self.read_any_word(block, letter, comma)
    }

    #[inline(never)]
    fn read_any_word(&mut self, block: &mut Block, letter: u8, comma: bool) -> bool {
        let start = self.at - usize::from(comma);
        if letter == b'O' && self.lexicon.o_words && self.flow_control() {
            if self.lexicon.strict_comments && !block.comments.is_empty() {
                self.o_word_after_comment(block, start);
            }
            self.skip_to_line_end();
            block.kind = BlockKind::Macro(TextRange::new(start as u32, self.at as u32));
            return false;
        }
        self.at += 1;
        let mut register = None;
        let text = &self.text[..self.end];
        while let Some(&byte) = text.get(self.at)
            && CLASSES[byte as usize] == CharClass::Blank
        {
            self.at += 1;
        }
        if letter == b'R' && self.lexicon.registers {
            register = Some(self.register());
        }
        let value = match decimal::scan(&text[self.at..]) {
            Some((number, length))
                if !STRANGE_AFTER_NUMBER
                    [text.get(self.at + length).copied().unwrap_or(b'\n') as usize] =>
            {
                self.at += length;
                if self.lexicon.blanks_in_numbers {
                    self.more_digits(number)
                } else {
                    WordValue::Number(number)
                }
            }
            _ => match self.loose_number().or_else(|| self.unusual_value(block, letter, start)) {
                Some(value) => value,
                None => return false,
            },
        };
        let range = TextRange::new(start as u32, self.at as u32);
        block.push_any(Word { letter, register, comma, value, range });
        true
    }

    /// The register digit of a register word; 0 without one (`R+.1`).
    fn register(&mut self) -> u8 {
        let digit = self.peek();
        let next = self.text.get(self.at + 1).copied().unwrap_or(b'\n');
        // `R.05` and `R10.` without a sign are values of register 0.
        if digit.is_ascii_digit() && !next.is_ascii_digit() && next != b'.' {
            self.at += 1;
            while CLASSES[self.peek() as usize] == CharClass::Blank && self.at < self.end {
                self.at += 1;
            }
            return digit - b'0';
        }
        0
    }

    /// Adds digits after blanks to the number, if the lexicon allows blanks in numbers.
    #[cold]
    fn more_digits(&mut self, number: Decimal) -> WordValue {
        let line = &self.text[self.at..self.end];
        let blanks = line.iter().take_while(|b| **b == b' ' || **b == b'\t').count();
        let next = line.get(blanks).copied().unwrap_or(b'\n');
        if blanks == 0 || !(next.is_ascii_digit() || next == b'.' && !number.has_point) {
            return WordValue::Number(number);
        }
        let taken =
            line.iter().take_while(|b| b.is_ascii_digit() || matches!(b, b'.' | b' ' | b'\t'));
        let taken = taken.count();
        let unsigned = number.to_string();
        let digits: Vec<u8> = unsigned
            .trim_start_matches('-')
            .bytes()
            .chain(line[..taken].iter().copied().filter(|b| !matches!(b, b' ' | b'\t')))
            .collect();
        let point = digits.iter().filter(|b| **b == b'.').count() <= 1;
        match Decimal::parse_long(&digits).filter(|_| point) {
            Some(whole) => {
                self.at += taken;
                let mantissa = if number.negative { -whole.mantissa } else { whole.mantissa };
                WordValue::Number(Decimal { mantissa, negative: number.negative, ..whole })
            }
            None => WordValue::Number(number),
        }
    }

    /// Reads any number of signs, and digits with blanks between them (`x--1`, `y - 2`), if the lexicon allows them.
    /// Digits after the 18th are dropped. `None` if there is no such number.
    #[cold]
    fn loose_number(&mut self) -> Option<WordValue> {
        if !self.lexicon.blanks_in_numbers {
            return None;
        }
        let line = &self.text[self.at..self.end];
        let blank = |b: &u8| matches!(b, b' ' | b'\t');
        let signs = line.iter().take_while(|b| blank(b) || matches!(b, b'+' | b'-')).count();
        let negative = line[..signs].iter().filter(|b| **b == b'-').count() % 2 == 1;
        let digit = |b: &u8| b.is_ascii_digit() || *b == b'.';
        let taken = line[signs..].iter().take_while(|b| blank(b) || digit(b)).count();
        let end = signs + taken;
        let strange = line.get(end).is_some_and(|b| STRANGE_AFTER_NUMBER[usize::from(*b)]);
        let digits: Vec<u8> = line[signs..end].iter().copied().filter(|b| digit(b)).collect();
        if strange || digits.iter().filter(|b| **b == b'.').count() > 1 {
            return None;
        }
        let number = Decimal::parse_long(&digits)?;
        self.at += line[..end].trim_ascii_end().len();
        let mantissa = if negative { -number.mantissa } else { number.mantissa };
        Some(WordValue::Number(Decimal { mantissa, negative, ..number }))
    }

    /// Reads a value that is not a plain number. `None` if the line is a macro statement.
    #[cold]
    fn unusual_value(&mut self, block: &mut Block, letter: u8, start: usize) -> Option<WordValue> {
        if letter == b'N'
            && let Some(number) = self.number_of_packed_block()
        {
            return Some(WordValue::Number(number));
        }
        let text = &self.text[..self.end];
        let rest = &text[self.at..];
        let is_sign = |b: &&u8| matches!(**b, b'+' | b'-');
        // If numbers may have blanks, they may have any number of signs (`X--#1`).
        let sign = match self.lexicon.blanks_in_numbers {
            true => rest.iter().take_while(|b| is_sign(b) || matches!(**b, b' ' | b'\t')).count(),
            false => usize::from(rest.first().as_ref().is_some_and(is_sign)),
        };
        let blanks = rest[sign..].iter().take_while(|b| matches!(b, b' ' | b'\t')).count();
        match rest.get(sign + blanks) {
            Some(b'#' | b'[') => {
                block.expressions = true;
                return Some(self.expression());
            }
            Some(mark)
                if mark.is_ascii_alphabetic() && self.function_at(self.at + sign + blanks) =>
            {
                block.expressions = true;
                return Some(self.expression());
            }
            _ => {}
        }
        match rest.get(sign) {
            Some(b'R' | b'r') if self.lexicon.registers => {
                if let Some(digit) = rest.get(sign + 1).filter(|b| b.is_ascii_digit()) {
                    self.at += sign + 2;
                    // `X+R6.`: the point has no meaning.
                    let more = rest.get(sign + 3).is_some_and(u8::is_ascii_digit);
                    self.at += usize::from(rest.get(sign + 2) == Some(&b'.') && !more);
                    return Some(WordValue::Register {
                        index: digit - b'0',
                        negative: rest[0] == b'-',
                    });
                }
            }
            _ => {}
        }
        if rest.first().is_some_and(u8::is_ascii_alphabetic) && self.remark(block, start) {
            return None;
        }
        // `DO1` begins a loop if it is alone in its block.
        let in_words = block.words.iter().any(|word| word.letter != b'N');
        let do_loop = letter == b'D' && !in_words && self.keyword(start);
        if !do_loop && let Some(value) = self.letter_for_digit(block, start) {
            return Some(value);
        }
        let begins_number = rest.first().is_some_and(|b| CLASSES[*b as usize] == CharClass::Digit);
        if begins_number {
            self.bad_number(block, start);
            return Some(WordValue::Missing);
        }
        // Two letters in a row may be a keyword (IF, WHILE, DPRNT, sub): a macro statement.
        if rest.first().is_some_and(u8::is_ascii_alphabetic) && self.keyword(start) {
            self.at = start;
            self.skip_statement();
            let range = TextRange::new(start as u32, self.at as u32);
            block.kind = BlockKind::Macro(range);
            return None;
        }
        self.problem(block, || {
            let span = Span::new(self.file, start as u32, start as u32 + 1);
            let name = letter as char;
            Diagnostic::new(Code::MissingValue, span, format!("`{name}` has no number"))
                .label("this letter needs a number")
                .help(format!("write the number, or remove the `{name}`"))
        });
        Some(WordValue::Missing)
    }
}
