//! The tokens of a block in their order, and the values that words have.

use chordal_diagnostics::TextRange;

use super::ast::{KlartextFault, KlartextFaultKind};
use super::operands::{OperandWord, ParameterBank, ParameterName, WordOperand};
use super::tokens::{KlartextToken, KlartextTokenKind};

/// The last Q and QS parameter (TNC 640 user's manual 34059x, Q parameters).
const MAX_SHARED_PARAMETER: f64 = 1999.0;
/// The last QL and QR parameter.
const MAX_LOCAL_PARAMETER: f64 = 499.0;

/// Reads the tokens of a block.
pub struct TokenCursor<'t> {
    /// The text of the program.
    pub text: &'t [u8],
    tokens: &'t [KlartextToken],
    at: usize,
    /// What could not be read.
    pub faults: Vec<KlartextFault>,
}

impl<'t> TokenCursor<'t> {
    /// At the first token.
    pub fn new(text: &'t [u8], tokens: &'t [KlartextToken]) -> TokenCursor<'t> {
        TokenCursor { text, tokens, at: 0, faults: Vec::new() }
    }

    /// The next token; `None` at the end.
    pub fn peek(&self) -> Option<&'t KlartextToken> {
        self.tokens.get(self.at)
    }

    /// The token `ahead` of the next one.
    pub fn peek_after(&self, ahead: usize) -> Option<&'t KlartextToken> {
        self.tokens.get(self.at + ahead)
    }

    /// Takes the next token.
    pub fn take(&mut self) -> Option<&'t KlartextToken> {
        let token = self.tokens.get(self.at)?;
        self.at += 1;
        Some(token)
    }

    /// Whether all tokens are taken.
    pub fn is_at_end(&self) -> bool {
        self.at >= self.tokens.len()
    }

    /// The next word; `None` if the next token is none.
    pub fn peek_word(&self) -> Option<&'t str> {
        self.word_after(0)
    }

    /// The word `ahead` of the next token; `None` if that token is no word.
    pub fn word_after(&self, ahead: usize) -> Option<&'t str> {
        match &self.peek_after(ahead)?.kind {
            KlartextTokenKind::Word(word) => Some(word),
            _ => None,
        }
    }

    /// Takes the next token if it is this word.
    pub fn take_word(&mut self, word: &str) -> bool {
        let is_word = self.peek_word() == Some(word);
        self.at += usize::from(is_word);
        is_word
    }

    /// Takes the next token if it is this sign.
    pub fn take_sign(&mut self, sign: u8) -> bool {
        let is_sign = self.peek().is_some_and(|token| token.kind == KlartextTokenKind::Sign(sign));
        self.at += usize::from(is_sign);
        is_sign
    }

    /// Leaves out the last token if it is this sign.
    pub fn drop_last_sign(&mut self, sign: u8) {
        let last = self.tokens.last().map(|token| &token.kind);
        if last == Some(&KlartextTokenKind::Sign(sign)) {
            self.tokens = &self.tokens[..self.tokens.len() - 1];
        }
    }

    /// The text from the next token to the end of the block.
    pub fn rest(&self) -> TextRange {
        let from = self.tokens.get(self.at).or(self.tokens.last());
        let (Some(from), Some(last)) = (from, self.tokens.last()) else {
            return TextRange::default();
        };
        match self.is_at_end() {
            true => TextRange::new(last.range.end, last.range.end),
            false => TextRange::new(from.range.start, last.range.end),
        }
    }

    /// Takes all tokens that are left.
    pub fn take_rest(&mut self) -> TextRange {
        let rest = self.rest();
        self.at = self.tokens.len();
        rest
    }

    /// The text from a token on up to the last one that was taken.
    pub fn range_from(&self, start: TextRange) -> TextRange {
        let last = self.at.checked_sub(1).and_then(|at| self.tokens.get(at));
        last.map_or(start, |last| start.cover(last.range))
    }

    /// Notes a fault.
    pub fn fault(&mut self, kind: KlartextFaultKind, range: TextRange, message: impl Into<String>) {
        self.faults.push(KlartextFault { range, message: message.into(), kind });
    }

    /// The text of a range.
    pub fn shown(&self, range: TextRange) -> String {
        String::from_utf8_lossy(range.slice(self.text)).into_owned()
    }

    /// Takes an unsigned whole number.
    pub fn take_whole(&mut self) -> Option<u32> {
        let KlartextTokenKind::Number(value) = self.peek()?.kind else { return None };
        let is_whole = value.fract() == 0.0 && (0.0..=f64::from(u32::MAX)).contains(&value);
        is_whole.then(|| {
            self.at += 1;
            value as u32
        })
    }

    /// Takes the name of a parameter.
    pub fn take_parameter(&mut self) -> Option<ParameterName> {
        let bank = ParameterBank::of_letters(self.peek_word()?)?;
        let KlartextTokenKind::Number(number) = self.peek_after(1)?.kind else { return None };
        if number.fract() != 0.0 || number > 99_999.0 {
            return None;
        }
        let start = self.peek()?.range;
        self.at += 2;
        let most = match bank {
            ParameterBank::Shared | ParameterBank::Text => MAX_SHARED_PARAMETER,
            ParameterBank::Local | ParameterBank::Retained => MAX_LOCAL_PARAMETER,
        };
        if number > most {
            let range = self.range_from(start);
            let message = format!("{} is above {most}, the last one", self.shown(range));
            self.fault(KlartextFaultKind::Unreadable, range, message);
        }
        Some(ParameterName { bank, number: number as u32 })
    }

    /// Takes a value: signs and a number or a parameter; `None`, with nothing taken, if there is none.
    pub fn take_operand(&mut self) -> Option<WordOperand> {
        let start = self.at;
        let mut is_negative = false;
        let first = self.peek().map(|token| token.range);
        while let Some(KlartextToken { kind: KlartextTokenKind::Sign(sign), .. }) = self.peek() {
            match sign {
                b'+' => {}
                b'-' => is_negative = !is_negative,
                _ => break,
            }
            self.at += 1;
        }
        if self.at > start + 1
            && let Some(first) = first
        {
            let range = self.range_from(first);
            let message = format!("{} stand before one value", self.shown(range));
            self.fault(KlartextFaultKind::Unreadable, range, message);
        }
        if let Some(name) = self.take_parameter() {
            return Some(WordOperand::Parameter { is_negative, name });
        }
        if let Some(KlartextToken { kind: KlartextTokenKind::Number(value), .. }) = self.peek() {
            self.at += 1;
            return Some(WordOperand::Number(if is_negative { -value } else { *value }));
        }
        self.at = start;
        None
    }

    /// Takes the value of a word that was taken; without one it is a fault.
    pub fn operand_of(&mut self, word: TextRange, is_incremental: bool) -> Option<OperandWord> {
        let value = self.take_operand();
        let range = self.range_from(word);
        if value.is_none() {
            let message = format!("`{}` has no value", self.shown(word));
            self.fault(KlartextFaultKind::MissingValue, word, message);
        }
        Some(OperandWord { is_incremental, value: value?, range })
    }
}
