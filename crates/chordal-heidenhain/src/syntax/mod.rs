//! Reads programs into blocks. Reading never fails: what is not understood stays as text, with a fault.
//!
//! `reader` divides the text into blocks, `tokens` a block into words, numbers and signs; `statements` decides what a
//! block is (`iso` of DIN/ISO programs), and `words`, `formulas`, `functions` and `cycles` read its parts.

mod ast;
mod cursor;
mod cycles;
mod formulas;
mod free_contours;
mod free_words;
mod functions;
mod iso;
mod labels;
mod operands;
mod parser;
mod plain_line;
mod plane_words;
mod planes;
mod reader;
mod statements;
mod tokens;
mod word_search;
mod words;

pub use ast::*;
pub use free_words::{FreePointWords, FreeRelation, FreeRelationWord};
pub use operands::{OperandWord, ParameterBank, ParameterName, WordOperand};
pub use parser::{KlartextReader, block_of_lines};
pub use planes::{PlaneForm, PlanePositioning, PlaneWords};
pub use reader::{KlartextLines, LineReader};
pub use tokens::{KlartextToken, KlartextTokenKind, scan_tokens};
pub use word_search::contains_ignoring_case;
