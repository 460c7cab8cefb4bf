//! Reads parts of a text: those of macros.

use chordal_diagnostics::TextRange;

use super::ast::{BlockStatement, Expression};
use super::parser::BlockParser;
use super::precedence::ComparisonPrecedence;

/// The statements of a part of a text, which is in one line.
pub fn statements_of(text: &[u8], part: TextRange) -> Vec<BlockStatement> {
    BlockParser::new(text, part, 1, ComparisonPrecedence::default()).read().statements
}

/// The expression that a part of a text is; `None` if it is something else.
pub fn constant_of(text: &[u8], part: TextRange) -> Option<Expression> {
    let mut parser = BlockParser::new(text, part, 1, ComparisonPrecedence::default());
    let value = parser.expression()?;
    parser.scan.is_at_end().then_some(value)
}
