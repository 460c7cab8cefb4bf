//! Parameters and the values of formulas.

mod formula;
mod parameters;

pub use formula::{FormulaError, formula_value};
pub use parameters::ParameterStore;
