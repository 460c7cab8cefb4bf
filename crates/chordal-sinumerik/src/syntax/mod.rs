//! Text → blocks. Reading never fails: what cannot be read is a fault of its block.

mod ast;
mod definitions;
mod expressions;
mod flow;
mod names;
mod number_literal;
mod parser;
mod parts;
mod pending_fault;
mod plain_line;
mod precedence;
mod reader;
mod recovery;
mod scanner;
mod spacing;
mod tokens;
mod units;
mod words;

pub use ast::*;
pub use parts::{constant_of, statements_of};
pub use plain_line::{PlainLine, PlainValue};
pub use precedence::ComparisonPrecedence;
pub use reader::BlockReader;
pub use spacing::with_uniform_spacing;
pub use tokens::tokens;
pub use units::{ProgramUnit, ProgramUnitKind, is_table_text, units};
