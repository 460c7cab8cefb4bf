//! Macro languages: what a control's macro statements, variables and calls do.
//!
//! `rules` is the part of a control's table; `value` and `functions` compute; `evaluate` runs
//! the steps of an expression; `variables` keeps locals and common variables, `names` named ones; `arguments`
//! reads the words of a macro call; `output` writes the text of DPRNT.

pub(crate) mod arguments;
pub(crate) mod evaluate;
pub(crate) mod functions;
pub(crate) mod names;
pub(crate) mod output;
pub(crate) mod value;
pub(crate) mod variables;

#[cfg(test)]
mod tests;
