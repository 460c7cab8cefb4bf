//! Values of variables and expressions.

mod evaluate;
mod function_arguments;
mod functions;
mod operators;
mod text_functions;
mod value;

pub use evaluate::{
    EvaluationError, IndexValue, NAMED_INDEX, VariableSource, evaluate, evaluate_index,
};
pub use operators::{DIVISION_BY_ZERO, binary_operation, is_equal_number, unary_operation};
pub use value::{SinumerikValue, ValueFault, number_text};
