//! Parses word-address text into blocks of words with spans.
//!
//! Blocks are read on demand into a buffer that is reused, so no memory beyond the text itself is needed. Reading never
//! fails: unreadable text becomes a diagnostic of the block, and the rest of the block is read.
//!
//! ```
//! use chordal_diagnostics::FileId;
//! use chordal_syntax::{Block, BlockReader, Lexicon};
//!
//! let mut reader = BlockReader::new(b"N10 G1 X-1.50 (CUT)\nM30\n", FileId(0), Lexicon::COMMON);
//! let mut block = Block::default();
//! assert!(reader.read(&mut block));
//! let x = block.word(b'X').unwrap().number().unwrap();
//! assert_eq!((x.mantissa, x.scale, x.has_point), (-150, 2, true));
//! ```

#![forbid(unsafe_code)]

mod alignment;
mod block;
mod decimal;
mod encoding;
mod expression;
mod lexicon;
mod line_statement;
mod oword;
mod program_name;
mod programs;
mod reader;
mod statement;

pub use block::{Block, BlockDelete, BlockKind, Letters, Word, WordValue};
pub use decimal::Decimal;
pub use encoding::{Decoded, Encoding, decode};
pub use expression::{
    BracketStyle, Expression, ExpressionParser, ExpressionStep, Function, MacroGrammar, Operator,
    OperatorRow, StackOp, operator,
};
pub use lexicon::{Lexicon, ParenthesisComment, Semicolon};
pub use line_statement::{LineStatement, PrintItem, parse_line_statement};
pub use oword::{FlowWord, OLabel, OWord, parse_o_word};
pub use program_name::{is_program_name, scan_program_name};
pub use programs::{ProgramHead, find_programs};
pub use reader::{BlockPosition, BlockReader};
pub use statement::{AssignTarget, ConditionBranch, MacroStatement, OutputCode, parse_statement};
