//! Expressions, by precedence climbing.

use chordal_diagnostics::TextRange;

use super::ast::{BinaryOperator, Expression, ExpressionKind, UnaryOperator};
use super::number_literal::bit_constant;
use super::parser::BlockParser;
use super::precedence::ComparisonPrecedence;
use super::scanner::{begins_name, decoded_text};
use super::words::number_kind;

/// Expressions within expressions. The limit keeps the stack small; no block of 512 characters needs as many.
const MAX_DEPTH: u32 = 200;

/// Operators of one expression. A block has at most 512 characters, so a valid one has fewer.
const MAX_OPERATORS: u32 = 512;

/// The operators that are names.
const WORD_OPERATORS: [(&str, BinaryOperator); 8] = [
    ("DIV", BinaryOperator::IntegerDivide),
    ("MOD", BinaryOperator::Modulo),
    ("AND", BinaryOperator::And),
    ("OR", BinaryOperator::Or),
    ("XOR", BinaryOperator::Xor),
    ("B_AND", BinaryOperator::BitAnd),
    ("B_OR", BinaryOperator::BitOr),
    ("B_XOR", BinaryOperator::BitXor),
];

impl BlockParser<'_> {
    /// A whole expression. The operators of its parts count as its own, so that the tree of an expression is never
    /// higher than both limits together.
    pub fn expression(&mut self) -> Option<Expression> {
        if self.depth == 0 {
            self.operators = 0;
        }
        self.operation(0)
    }

    /// Operands and the operators between them that bind more tightly than `outer`.
    fn operation(&mut self, outer: u8) -> Option<Expression> {
        if self.depth >= MAX_DEPTH {
            return self.fail("the expression is nested too deeply");
        }
        self.depth += 1;
        let operation = self.operands(outer);
        self.depth -= 1;
        operation
    }

    fn operands(&mut self, outer: u8) -> Option<Expression> {
        let mut left = self.operand()?;
        while let Some((operator, length)) = self.operator() {
            let binding = self.binding(operator);
            if binding <= outer {
                break;
            }
            self.scan.at += length;
            self.operators += 1;
            if self.operators > MAX_OPERATORS {
                return self.fail("the expression has too many operators");
            }
            let right = self.operation(binding)?;
            let range = left.range.cover(right.range);
            if is_comparison(operator) && (is_bare_logic(&left) || is_bare_logic(&right)) {
                self.block.doubtful_comparisons.push(range);
            }
            let kind = ExpressionKind::Binary(operator, Box::new(left), Box::new(right));
            left = Expression { range, kind };
        }
        Some(left)
    }

    /// The operator that is next and its length in bytes. Nothing but blanks is skipped, and those only before an operator.
    fn operator(&mut self) -> Option<(BinaryOperator, usize)> {
        let before = self.scan;
        let byte = self.scan.next_byte();
        let found = match (byte, self.scan.peek_after(1)) {
            (b'*', _) => Some((BinaryOperator::Multiply, 1)),
            (b'/', _) => Some((BinaryOperator::Divide, 1)),
            (b'+', _) => Some((BinaryOperator::Add, 1)),
            (b'-', _) => Some((BinaryOperator::Subtract, 1)),
            (b':', _) => Some((BinaryOperator::Chain, 1)),
            (b'=', b'=') => Some((BinaryOperator::Equal, 2)),
            (b'<', b'<') => Some((BinaryOperator::Join, 2)),
            (b'<', b'>') => Some((BinaryOperator::NotEqual, 2)),
            (b'<', b'=') => Some((BinaryOperator::LessOrEqual, 2)),
            (b'<', _) => Some((BinaryOperator::Less, 1)),
            (b'>', b'=') => Some((BinaryOperator::GreaterOrEqual, 2)),
            (b'>', _) => Some((BinaryOperator::Greater, 1)),
            (b'A'..=b'Z' | b'a'..=b'z', _) => self.word_operator(),
            _ => None,
        };
        if found.is_none() {
            self.scan = before;
        }
        found
    }

    fn word_operator(&self) -> Option<(BinaryOperator, usize)> {
        let found = WORD_OPERATORS.iter().find(|(word, _)| self.scan.is_word(word));
        found.map(|(word, operator)| (*operator, word.len()))
    }

    /// How tightly an operator binds; a higher number binds more tightly. Job Planning 07/2010, 1.7: comparisons bind
    /// least of all.
    fn binding(&self, operator: BinaryOperator) -> u8 {
        let comparisons_first = self.precedence == ComparisonPrecedence::BeforeLogic;
        match operator {
            BinaryOperator::Chain => 24,
            BinaryOperator::Multiply
            | BinaryOperator::Divide
            | BinaryOperator::IntegerDivide
            | BinaryOperator::Modulo => 22,
            BinaryOperator::Add | BinaryOperator::Subtract => 20,
            BinaryOperator::BitAnd => 18,
            BinaryOperator::BitXor => 16,
            BinaryOperator::BitOr => 14,
            BinaryOperator::Join if comparisons_first => 12,
            _ if comparisons_first && is_comparison(operator) => 11,
            BinaryOperator::And => 10,
            BinaryOperator::Xor => 8,
            BinaryOperator::Or => 6,
            BinaryOperator::Join => 4,
            BinaryOperator::Equal
            | BinaryOperator::NotEqual
            | BinaryOperator::Greater
            | BinaryOperator::Less
            | BinaryOperator::GreaterOrEqual
            | BinaryOperator::LessOrEqual => 2,
        }
    }

    /// A value with the operators before it.
    fn operand(&mut self) -> Option<Expression> {
        let first = self.scan.next_byte();
        let start = self.scan.at;
        let (operator, length) = match (first, self.scan.peek_after(1)) {
            (b'-', _) => (UnaryOperator::Minus, 1),
            (b'+', _) => (UnaryOperator::Plus, 1),
            (b'<', b'<') => (UnaryOperator::Text, 2),
            (b'N' | b'n', _) if self.scan.is_word("NOT") => (UnaryOperator::Not, 3),
            (b'B' | b'b', _) if self.scan.is_word("B_NOT") => (UnaryOperator::BitNot, 5),
            _ => return self.primary(first, start),
        };
        self.scan.at += length;
        self.unary(operator, start)
    }

    fn unary(&mut self, operator: UnaryOperator, start: usize) -> Option<Expression> {
        if operator == UnaryOperator::Minus {
            self.scan.skip_blanks();
            if let Some(number) = self.scan.read_number() {
                let range = self.scan.range_from(start);
                return Some(Expression { range, kind: number_kind(number.negated()) });
            }
        }
        let outer = match operator {
            UnaryOperator::Text => self.binding(BinaryOperator::Join),
            // No operator binds as tightly as these.
            _ => u8::MAX,
        };
        let operand = self.operation(outer);
        let range = self.scan.range_from(start);
        Some(Expression { range, kind: ExpressionKind::Unary(operator, Box::new(operand?)) })
    }

    fn primary(&mut self, first: u8, start: usize) -> Option<Expression> {
        let kind = match first {
            b'0'..=b'9' | b'.' => match self.scan.read_number() {
                Some(number) => number_kind(number),
                None => return self.fail("a value is missing"),
            },
            b'"' => ExpressionKind::Text(self.text()?),
            b'\'' => ExpressionKind::Integer(self.bit_constant()?),
            b'(' => return self.group(start),
            _ if begins_name(first) => self.named_value()?,
            _ => return self.fail("a value is missing"),
        };
        Some(Expression { range: self.scan.range_from(start), kind })
    }

    /// `(expression)`; the range has the parentheses.
    fn group(&mut self, start: usize) -> Option<Expression> {
        self.scan.at += 1;
        let mut inner = self.operation(0)?;
        if !self.scan.take(b')') {
            return self.fail("a closing parenthesis is missing");
        }
        inner.range = self.scan.range_from(start);
        Some(inner)
    }

    fn text(&mut self) -> Option<String> {
        let start = self.scan.at;
        if !self.scan.skip_text() {
            self.scan.at = start;
            return self.fail("the text has no closing quotation mark");
        }
        let range = self.scan.range_from(start);
        let bytes = self.scan.slice(range);
        Some(decoded_text(&bytes[1..bytes.len() - 1]))
    }

    /// `'H1F'`, `'B101'`.
    fn bit_constant(&mut self) -> Option<i64> {
        let inner = &self.scan.rest()[1..];
        let close = memchr::memchr(b'\'', inner);
        match close.and_then(|close| Some((close, bit_constant(&inner[..close])?))) {
            Some((close, value)) => {
                self.scan.at += close + 2;
                Some(value)
            }
            None => self.fail("a constant in apostrophes is 'H…' or 'B…' of at most 32 bits"),
        }
    }

    /// A variable, a function or TRUE and FALSE.
    fn named_value(&mut self) -> Option<ExpressionKind> {
        let range = self.scan.read_name()?;
        let name = self.scan.slice(range);
        if name.eq_ignore_ascii_case(b"TRUE") {
            return Some(ExpressionKind::Boolean(true));
        }
        if name.eq_ignore_ascii_case(b"FALSE") {
            return Some(ExpressionKind::Boolean(false));
        }
        let after = self.scan;
        if self.scan.next_byte() == b'(' {
            let name = self.scan.upper(range);
            return Some(ExpressionKind::Function(name, self.arguments()?));
        }
        self.scan = after;
        self.address(range).map(ExpressionKind::Variable)
    }

    /// `(1,,3)`: the arguments of a call, which begins with the next byte.
    pub fn arguments(&mut self) -> Option<Vec<Option<Expression>>> {
        self.scan.take(b'(');
        let mut arguments = Vec::new();
        if self.scan.take(b')') {
            return Some(arguments);
        }
        loop {
            let is_missing = matches!(self.scan.next_byte(), b',' | b')');
            arguments.push(if is_missing { None } else { Some(self.expression()?) });
            if self.scan.take(b')') {
                return Some(arguments);
            }
            if !self.scan.take(b',') {
                return self.fail("a comma or a closing parenthesis is missing");
            }
        }
    }

    /// `[1,X]`: the indices of a variable; none without brackets.
    pub fn indices(&mut self) -> Option<Vec<Expression>> {
        let mut indices = Vec::new();
        let after = self.scan;
        if !self.scan.take(b'[') {
            self.scan = after;
            return Some(indices);
        }
        loop {
            indices.push(self.expression()?);
            if self.scan.take(b']') {
                return Some(indices);
            }
            if !self.scan.take(b',') {
                return self.fail("a comma or a closing bracket is missing");
            }
        }
    }
}

fn is_comparison(operator: BinaryOperator) -> bool {
    matches!(
        operator,
        BinaryOperator::Equal
            | BinaryOperator::NotEqual
            | BinaryOperator::Greater
            | BinaryOperator::Less
            | BinaryOperator::GreaterOrEqual
            | BinaryOperator::LessOrEqual
    )
}

/// True for `a AND b`, `a OR b` and `a XOR b` without parentheses around them.
fn is_bare_logic(expression: &Expression) -> bool {
    let ExpressionKind::Binary(operator, left, right) = &expression.kind else { return false };
    let is_logic =
        matches!(operator, BinaryOperator::And | BinaryOperator::Or | BinaryOperator::Xor);
    let inner: TextRange = left.range.cover(right.range);
    is_logic && inner == expression.range
}
