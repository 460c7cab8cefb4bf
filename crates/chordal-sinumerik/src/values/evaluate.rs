//! Evaluates expressions.

use chordal_diagnostics::TextRange;

use super::functions::function_value;
use super::operators::{binary_operation, unary_operation};
use super::value::{SinumerikValue, ValueFault};
use crate::syntax::{Address, Expression, ExpressionKind};

/// The alarm of an unknown name.
const UNKNOWN_NAME_ALARM: u32 = 12550;

/// The index of a source for an index that is a name of an axis or of a part of a frame: `$AA_IM[X]`,
/// `$P_UIFR[1,X,TR]`. The source finds the name in the indices of the address.
pub const NAMED_INDEX: i64 = i64::MIN;

/// The parts of a frame as indices: translation, rotation, mirror, scale, fine translation.
const FRAME_PARTS: [&str; 5] = ["TR", "RT", "MI", "SC", "FI"];

/// Where the values of variables come from.
pub trait VariableSource {
    /// The value of a variable. An index that is no number is [`NAMED_INDEX`]. The name of an axis is a
    /// [`SinumerikValue::Axis`]; an unknown name is the alarm 12550.
    fn read(
        &mut self,
        address: &Address,
        indices: &[i64],
    ) -> Result<SinumerikValue, EvaluationError>;

    /// The value of a function that is not part of the language; `None` when there is none of this name. An error with an
    /// empty range gets the range of the call.
    fn call(
        &mut self,
        name: &str,
        arguments: &[Option<SinumerikValue>],
    ) -> Option<Result<SinumerikValue, EvaluationError>>;
}

/// Why an expression has no value.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct EvaluationError {
    /// The part of the program at fault.
    pub range: TextRange,
    /// The number of the alarm.
    pub alarm: u32,
    /// What is wrong, as a sentence without a full stop.
    pub message: String,
}

impl EvaluationError {
    /// An error at a range.
    pub fn new(range: TextRange, alarm: u32, message: impl Into<String>) -> EvaluationError {
        EvaluationError { range, alarm, message: message.into() }
    }

    /// The error of a name that nothing has.
    pub fn unknown_name(range: TextRange, name: &str) -> EvaluationError {
        EvaluationError::new(range, UNKNOWN_NAME_ALARM, format!("the name {name} is unknown"))
    }
}

impl ValueFault {
    /// The fault of a part of the program.
    pub fn at(self, range: TextRange) -> EvaluationError {
        EvaluationError { range, alarm: self.alarm, message: self.message }
    }
}

/// The value of an expression.
pub fn evaluate(
    expression: &Expression,
    source: &mut dyn VariableSource,
) -> Result<SinumerikValue, EvaluationError> {
    match &expression.kind {
        ExpressionKind::Integer(value) => Ok(match i32::try_from(*value) {
            Ok(value) => SinumerikValue::Integer(value),
            Err(_) => SinumerikValue::Real(*value as f64),
        }),
        ExpressionKind::Real(value) => {
            SinumerikValue::finite(*value).map_err(|fault| fault.at(expression.range))
        }
        ExpressionKind::Boolean(value) => Ok(SinumerikValue::Boolean(*value)),
        ExpressionKind::Text(text) => Ok(SinumerikValue::text(text)),
        ExpressionKind::Variable(address) => variable(address, source),
        ExpressionKind::Function(name, arguments) => {
            function(name, arguments, expression.range, source)
        }
        ExpressionKind::Unary(operator, operand) => {
            let value = evaluate(operand, source)?;
            unary_operation(*operator, value).map_err(|fault| fault.at(expression.range))
        }
        ExpressionKind::Binary(operator, left, right) => {
            let left = evaluate(left, source)?;
            let right = evaluate(right, source)?;
            binary_operation(*operator, &left, &right).map_err(|fault| fault.at(expression.range))
        }
    }
}

fn variable(
    address: &Address,
    source: &mut dyn VariableSource,
) -> Result<SinumerikValue, EvaluationError> {
    if address.name == "$PI" {
        return Ok(SinumerikValue::Real(std::f64::consts::PI));
    }
    let mut indices = Vec::with_capacity(address.indices.len());
    for index in &address.indices {
        match evaluate_index(index, source)? {
            IndexValue::Known(index) => indices.push(index),
            IndexValue::Unknown(value) => return Ok(value),
        }
    }
    source.read(address, &indices)
}

/// The value of an index.
pub enum IndexValue {
    /// A whole number, or [`NAMED_INDEX`].
    Known(i64),
    /// It depends on something that nobody gave.
    Unknown(SinumerikValue),
}

/// The value of an index. REAL indices are rounded as in an assignment to INT.
pub fn evaluate_index(
    index: &Expression,
    source: &mut dyn VariableSource,
) -> Result<IndexValue, EvaluationError> {
    // The parts of frames (TR, RT, MI, SC, FI) are names without a value.
    if matches!(&index.kind, ExpressionKind::Variable(name) if FRAME_PARTS.contains(&&*name.name)) {
        return Ok(IndexValue::Known(NAMED_INDEX));
    }
    match evaluate(index, source)? {
        SinumerikValue::Axis(_) => Ok(IndexValue::Known(NAMED_INDEX)),
        value if value.unknown_cause().is_some() => Ok(IndexValue::Unknown(value)),
        value => match value.to_integer() {
            Ok(index) => Ok(IndexValue::Known(i64::from(index))),
            Err(fault) => Err(fault.at(index.range)),
        },
    }
}

fn function(
    name: &str,
    arguments: &[Option<Expression>],
    range: TextRange,
    source: &mut dyn VariableSource,
) -> Result<SinumerikValue, EvaluationError> {
    let mut values = Vec::with_capacity(arguments.len());
    for argument in arguments {
        values.push(match argument {
            Some(argument) => Some(evaluate(argument, source)?),
            None => None,
        });
    }
    if let Some(unknown) = values.iter().flatten().find(|value| value.unknown_cause().is_some()) {
        return Ok(unknown.clone());
    }
    if let Some(result) = function_value(name, &values) {
        return result.map_err(|fault| fault.at(range));
    }
    match source.call(name, &values) {
        Some(result) => result.map_err(|error| {
            let range = if error.range.is_empty() { range } else { error.range };
            EvaluationError { range, ..error }
        }),
        None => Err(EvaluationError::unknown_name(range, name)),
    }
}
