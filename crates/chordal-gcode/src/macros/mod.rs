//! Macro languages: what a control's macro statements, variables and calls do.
//!
//! `value` and `functions` compute; `evaluate` runs the steps of an expression; `variables` stores local and common
//! variables, `names` named ones; `arguments` reads the words of a macro call; `output` writes the text of DPRNT.

pub(crate) mod arguments;
pub(crate) mod evaluate;
pub(crate) mod functions;
pub(crate) mod names;
pub(crate) mod output;
pub(crate) mod value;
pub(crate) mod variables;

#[cfg(test)]
mod tests;
