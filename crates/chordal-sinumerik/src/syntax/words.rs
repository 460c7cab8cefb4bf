//! Addresses with values, bare names and calls.

use chordal_diagnostics::TextRange;

use super::ast::{
    Address, AddressWord, CallStatement, Expression, ExpressionKind, IndirectCall, StatementKind,
    ValueFunction, WordValue,
};
use super::number_literal::NumberLiteral;
use super::parser::BlockParser;

/// The names of the value functions (Fundamentals 11/2006, 4.2).
const VALUE_FUNCTIONS: [(&str, ValueFunction); 9] = [
    ("AC", ValueFunction::Absolute),
    ("IC", ValueFunction::Incremental),
    ("DC", ValueFunction::ShortestPath),
    ("ACP", ValueFunction::Positive),
    ("ACN", ValueFunction::Negative),
    ("DAC", ValueFunction::AbsoluteDiameter),
    ("DIC", ValueFunction::IncrementalDiameter),
    ("RAC", ValueFunction::AbsoluteRadius),
    ("RIC", ValueFunction::IncrementalRadius),
];

impl BlockParser<'_> {
    /// A word of a single letter: `X10`, `X=R1`, `S2=900`, `R[1]=5`, and a call of `L10(1,2)`.
    pub fn letter_word(&mut self, letter: TextRange) -> Option<StatementKind> {
        if self.has_extension() {
            return self.assignment(letter);
        }
        let mut ahead = self.scan;
        match ahead.next_byte() {
            b'[' | b'=' => self.assignment(letter),
            b'0'..=b'9' | b'.' | b'+' | b'-' => self.packed_word(letter),
            // The fault is the letter alone: what follows a blank is another word.
            _ => {
                self.scan.at = letter.start as usize;
                self.fail("the address has no value")
            }
        }
    }

    /// True when digits and an equals sign follow: the digits are the extension of the address.
    fn has_extension(&self) -> bool {
        let mut ahead = self.scan;
        ahead.at += ahead.count_digits();
        ahead.at > self.scan.at && ahead.take_equals()
    }

    /// `X10`, `X-.5`, `L10`, `L10(1,2)`.
    fn packed_word(&mut self, letter: TextRange) -> Option<StatementKind> {
        self.scan.skip_blanks();
        let value = self.signed_number()?;
        if self.scan.peek() == b'(' && matches!(value.kind, ExpressionKind::Integer(_)) {
            let range = letter.cover(value.range);
            let name = self.scan.upper(range);
            return self.call(name, range).map(StatementKind::Call);
        }
        if self.scan.peek() == b':' {
            return self.fail("a label begins with two letters or underscores");
        }
        let address = Address {
            range: letter,
            name: self.scan.address_name(letter),
            extension: None,
            indices: Vec::new(),
        };
        let value = WordValue::Plain(value);
        Some(StatementKind::Word(AddressWord { address, value, has_equals: false }))
    }

    fn signed_number(&mut self) -> Option<Expression> {
        let start = self.scan.at;
        let is_negative = self.scan.peek() == b'-';
        if matches!(self.scan.peek(), b'+' | b'-') {
            self.scan.at += 1;
            self.scan.skip_blanks();
        }
        let Some(number) = self.scan.read_number() else {
            return self.fail("a number is missing; an expression needs an equals sign before it");
        };
        let number = if is_negative { number.negated() } else { number };
        Some(Expression { range: self.scan.range_from(start), kind: number_kind(number) })
    }

    /// An address, its extension and indices, an equals sign and a value.
    fn assignment(&mut self, name: TextRange) -> Option<StatementKind> {
        let address = self.address(name)?;
        if !self.scan.take_equals() {
            self.scan.at = name.start as usize;
            return self.fail("an equals sign is missing");
        }
        let value = self.word_value()?;
        Some(StatementKind::Word(AddressWord { address, value, has_equals: true }))
    }

    /// What follows a name of several characters: a value, arguments or nothing.
    pub fn named_statement(&mut self, name: String, range: TextRange) -> Option<StatementKind> {
        let mut ahead = self.scan;
        match ahead.next_byte() {
            b'[' => self.assignment(range),
            b'=' if ahead.peek_after(1) != b'=' => self.assignment(range),
            b'(' => self.call(name, range).map(StatementKind::Call),
            _ => Some(StatementKind::Name(name)),
        }
    }

    /// What follows an equals sign.
    pub fn word_value(&mut self) -> Option<WordValue> {
        self.scan.skip_blanks();
        let begin = self.scan;
        if let Some(name) = self.scan.read_name()
            && self.scan.next_byte() == b'('
            && let Some(value) = self.value_function(name)
        {
            return value;
        }
        self.scan = begin;
        self.expression().map(WordValue::Plain)
    }

    /// The value in the parentheses of AC, IC, …, SET and REP; `None` for any other function.
    fn value_function(&mut self, name: TextRange) -> Option<Option<WordValue>> {
        let name = self.scan.slice(name);
        let is = |candidate: &str| name.eq_ignore_ascii_case(candidate.as_bytes());
        if is("SET") {
            return Some(self.value_list().map(WordValue::Set));
        }
        if is("REP") {
            return Some(self.parenthesized().map(WordValue::Repeated));
        }
        let (_, function) = VALUE_FUNCTIONS.iter().find(|(candidate, _)| is(candidate))?;
        Some(self.parenthesized().map(|value| WordValue::Function(*function, value)))
    }

    /// `(value)`.
    fn parenthesized(&mut self) -> Option<Expression> {
        self.scan.take(b'(');
        let value = self.expression()?;
        if !self.scan.take(b')') {
            return self.fail("a closing parenthesis is missing");
        }
        Some(value)
    }

    /// `(1,2,3)` with all values.
    pub fn value_list(&mut self) -> Option<Vec<Expression>> {
        let mut values = Vec::new();
        for value in self.arguments()? {
            match value {
                Some(value) => values.push(value),
                None => return self.fail("a value of the list is missing"),
            }
        }
        Some(values)
    }

    /// A name with its arguments, if it has any.
    pub fn call(&mut self, name: String, range: TextRange) -> Option<CallStatement> {
        let after = self.scan;
        let arguments = if self.scan.next_byte() == b'(' {
            Some(self.arguments()?)
        } else {
            self.scan = after;
            None
        };
        Some(CallStatement { name, range, arguments })
    }

    /// `MCALL` alone or with a call.
    pub fn modal_call(&mut self) -> Option<StatementKind> {
        if self.scan.is_at_end() {
            return Some(StatementKind::ModalCall(None));
        }
        let (name, range) = self.required_name("the name of the program")?;
        let call = self.call(name, range)?;
        Some(StatementKind::ModalCall(Some(call)))
    }

    /// `CALL path`, `CALL BLOCK A TO B`, `CALL path BLOCK A TO B`.
    pub fn indirect_call(&mut self) -> Option<StatementKind> {
        if self.scan.take_word("BLOCK") {
            return self.called_blocks(None);
        }
        let program = self.expression()?;
        if self.scan.take_word("BLOCK") {
            return self.called_blocks(Some(program));
        }
        Some(StatementKind::IndirectCall(IndirectCall::Named(program)))
    }

    fn called_blocks(&mut self, program: Option<Expression>) -> Option<StatementKind> {
        let (from, _) = self.required_name("the first label")?;
        if !self.scan.take_word("TO") {
            return self.fail("TO and the last label are missing");
        }
        let (to, _) = self.required_name("the last label")?;
        Some(StatementKind::IndirectCall(IndirectCall::Blocks { program, from, to }))
    }

    /// `EXTCALL("file")`, `ISOCALL "file"`.
    pub fn named_call(&mut self) -> Option<StatementKind> {
        let program = self.expression()?;
        Some(StatementKind::IndirectCall(IndirectCall::Named(program)))
    }

    /// `PCALL /_N_WCS_DIR/_N_PART_WPD/NAME(1,2)`: the path is no expression.
    pub fn path_call(&mut self) -> Option<StatementKind> {
        self.scan.skip_blanks();
        let start = self.scan.at;
        while !matches!(self.scan.peek(), b'(' | b';' | 0..=b' ') {
            self.scan.at += 1;
        }
        let range = self.scan.range_from(start);
        if range.is_empty() {
            return self.fail("the path of the program is missing");
        }
        let path: String = self.scan.slice(range).iter().map(|byte| char::from(*byte)).collect();
        let call = self.call(path.to_ascii_uppercase(), range)?;
        Some(StatementKind::IndirectCall(IndirectCall::Path(call)))
    }
}

/// The expression of a number.
pub(super) fn number_kind(number: NumberLiteral) -> ExpressionKind {
    match number {
        NumberLiteral::Whole(value) => ExpressionKind::Integer(value),
        NumberLiteral::Decimal(value) => ExpressionKind::Real(value),
    }
}
