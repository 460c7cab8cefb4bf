//! What operators do with values.

use std::cmp::Ordering;

use super::value::{SinumerikValue, ValueFault, WRONG_TYPE_ALARM};
use crate::syntax::{BinaryOperator, UnaryOperator};

/// How much two numbers may differ and be equal, as a part of the greater (NC Programming 12/2019, 3.1.3.4, states that
/// there is such a limit but not how great it is).
const EQUALITY_TOLERANCE: f64 = 1e-12;

/// What `==` says about two numbers.
pub fn is_equal_number(left: f64, right: f64) -> bool {
    (left - right).abs() <= EQUALITY_TOLERANCE * left.abs().max(right.abs())
}

/// The value of an operator before its operand.
pub fn unary_operation(
    operator: UnaryOperator,
    value: SinumerikValue,
) -> Result<SinumerikValue, ValueFault> {
    if value.unknown_cause().is_some() {
        return Ok(value);
    }
    match operator {
        UnaryOperator::Plus => Ok(match numeric("+", &value)? {
            NumericOperand::Whole(whole) => SinumerikValue::Integer(whole),
            NumericOperand::Decimal(decimal) => SinumerikValue::Real(decimal),
        }),
        UnaryOperator::Minus => Ok(match numeric("-", &value)? {
            NumericOperand::Whole(whole) => match whole.checked_neg() {
                Some(negative) => SinumerikValue::Integer(negative),
                None => SinumerikValue::Real(-f64::from(whole)),
            },
            NumericOperand::Decimal(decimal) => SinumerikValue::Real(-decimal),
        }),
        UnaryOperator::Not => Ok(SinumerikValue::Boolean(!value.to_boolean()?)),
        UnaryOperator::BitNot => Ok(SinumerikValue::Integer(!value.to_integer()?)),
        UnaryOperator::Text => Ok(SinumerikValue::Text(value.to_text()?)),
    }
}

/// The value of an operator between its operands.
pub fn binary_operation(
    operator: BinaryOperator,
    left: &SinumerikValue,
    right: &SinumerikValue,
) -> Result<SinumerikValue, ValueFault> {
    if let Some(value) = with_unknown(operator, left, right) {
        return Ok(value);
    }
    match operator {
        BinaryOperator::Chain => Err(ValueFault {
            alarm: WRONG_TYPE_ALARM,
            message: "the operator : joins frames only".to_string(),
        }),
        BinaryOperator::Multiply => arithmetic("*", left, right, i32::checked_mul, |a, b| a * b),
        BinaryOperator::Add => arithmetic("+", left, right, i32::checked_add, |a, b| a + b),
        BinaryOperator::Subtract => arithmetic("-", left, right, i32::checked_sub, |a, b| a - b),
        BinaryOperator::Divide => divide(left, right),
        BinaryOperator::IntegerDivide => integer_divide(left, right),
        BinaryOperator::Modulo => modulo(left, right),
        BinaryOperator::BitAnd => bits(left, right, |a, b| a & b),
        BinaryOperator::BitXor => bits(left, right, |a, b| a ^ b),
        BinaryOperator::BitOr => bits(left, right, |a, b| a | b),
        BinaryOperator::And => logic(left, right, |a, b| a && b),
        BinaryOperator::Xor => logic(left, right, |a, b| a != b),
        BinaryOperator::Or => logic(left, right, |a, b| a || b),
        BinaryOperator::Join => join(left, right),
        BinaryOperator::Equal => compare(left, right, |_, equal| equal),
        BinaryOperator::NotEqual => compare(left, right, |_, equal| !equal),
        BinaryOperator::Greater => {
            compare(left, right, |order, _| order == Some(Ordering::Greater))
        }
        BinaryOperator::Less => compare(left, right, |order, _| order == Some(Ordering::Less)),
        BinaryOperator::GreaterOrEqual => {
            compare(left, right, |order, equal| equal || order == Some(Ordering::Greater))
        }
        BinaryOperator::LessOrEqual => {
            compare(left, right, |order, equal| equal || order == Some(Ordering::Less))
        }
    }
}

/// The value of an operation with an operand that is not known: not known either, unless the other operand alone
/// decides (`FALSE AND …`, `TRUE OR …`). `None` when both operands are known.
fn with_unknown(
    operator: BinaryOperator,
    left: &SinumerikValue,
    right: &SinumerikValue,
) -> Option<SinumerikValue> {
    let (unknown, other) = match (left.unknown_cause(), right.unknown_cause()) {
        (Some(_), _) => (left, right),
        (None, Some(_)) => (right, left),
        (None, None) => return None,
    };
    let decides = match operator {
        BinaryOperator::And => Some(false),
        BinaryOperator::Or => Some(true),
        _ => None,
    };
    match decides.filter(|value| other.to_boolean().as_ref() == Ok(value)) {
        Some(value) => Some(SinumerikValue::Boolean(value)),
        None => Some(unknown.clone()),
    }
}

/// A number with its type.
#[derive(Clone, Copy)]
enum NumericOperand {
    Whole(i32),
    Decimal(f64),
}

impl NumericOperand {
    fn real(self) -> f64 {
        match self {
            NumericOperand::Whole(value) => f64::from(value),
            NumericOperand::Decimal(value) => value,
        }
    }
}

/// The operand of an arithmetic operator: BOOL and CHAR are whole numbers.
fn numeric(operator: &str, value: &SinumerikValue) -> Result<NumericOperand, ValueFault> {
    match value {
        SinumerikValue::Integer(value) => Ok(NumericOperand::Whole(*value)),
        SinumerikValue::Real(value) => Ok(NumericOperand::Decimal(*value)),
        SinumerikValue::Boolean(value) => Ok(NumericOperand::Whole(i32::from(*value))),
        SinumerikValue::Character(code) => Ok(NumericOperand::Whole(i32::from(*code))),
        SinumerikValue::Text(_) | SinumerikValue::Axis(_) | SinumerikValue::Unknown(_) => {
            Err(wrong_type(operator, value))
        }
    }
}

fn wrong_type(operator: &str, value: &SinumerikValue) -> ValueFault {
    let message = format!("the operator {operator} does not go with {}", value.description());
    ValueFault { alarm: WRONG_TYPE_ALARM, message }
}

/// Two INT give an INT in its range; everything else gives a REAL.
fn arithmetic(
    name: &str,
    left: &SinumerikValue,
    right: &SinumerikValue,
    whole: fn(i32, i32) -> Option<i32>,
    decimal: fn(f64, f64) -> f64,
) -> Result<SinumerikValue, ValueFault> {
    let (left, right) = (numeric(name, left)?, numeric(name, right)?);
    if let (NumericOperand::Whole(left), NumericOperand::Whole(right)) = (left, right)
        && let Some(result) = whole(left, right)
    {
        return Ok(SinumerikValue::Integer(result));
    }
    SinumerikValue::finite(decimal(left.real(), right.real()))
}

/// The message of a division by zero, which has the alarm of other arithmetic errors.
pub const DIVISION_BY_ZERO: &str = "division by zero";

fn division_by_zero() -> ValueFault {
    ValueFault::arithmetic(DIVISION_BY_ZERO)
}

/// `/` gives a REAL, also of two INT.
fn divide(left: &SinumerikValue, right: &SinumerikValue) -> Result<SinumerikValue, ValueFault> {
    let (left, right) = (numeric("/", left)?.real(), numeric("/", right)?.real());
    if right == 0.0 {
        return Err(division_by_zero());
    }
    SinumerikValue::finite(left / right)
}

/// DIV gives the quotient without its fraction.
fn integer_divide(
    left: &SinumerikValue,
    right: &SinumerikValue,
) -> Result<SinumerikValue, ValueFault> {
    let (left, right) = (numeric("DIV", left)?.real(), numeric("DIV", right)?.real());
    if right == 0.0 {
        return Err(division_by_zero());
    }
    let quotient = left / right;
    if !quotient.is_finite() {
        return SinumerikValue::finite(quotient);
    }
    Ok(SinumerikValue::whole(quotient.trunc()))
}

/// MOD gives the remainder of DIV, with the sign of the dividend.
fn modulo(left: &SinumerikValue, right: &SinumerikValue) -> Result<SinumerikValue, ValueFault> {
    let (left, right) = (numeric("MOD", left)?, numeric("MOD", right)?);
    if right.real() == 0.0 {
        return Err(division_by_zero());
    }
    match (left, right) {
        // -1 is the only divisor whose quotient may overflow; its remainder is 0.
        (NumericOperand::Whole(left), NumericOperand::Whole(right)) => {
            Ok(SinumerikValue::Integer(left.checked_rem(right).unwrap_or(0)))
        }
        _ => Ok(SinumerikValue::Real(libm::fmod(left.real(), right.real()))),
    }
}

fn bits(
    left: &SinumerikValue,
    right: &SinumerikValue,
    operation: fn(i32, i32) -> i32,
) -> Result<SinumerikValue, ValueFault> {
    Ok(SinumerikValue::Integer(operation(left.to_integer()?, right.to_integer()?)))
}

fn logic(
    left: &SinumerikValue,
    right: &SinumerikValue,
    operation: fn(bool, bool) -> bool,
) -> Result<SinumerikValue, ValueFault> {
    Ok(SinumerikValue::Boolean(operation(left.to_boolean()?, right.to_boolean()?)))
}

fn join(left: &SinumerikValue, right: &SinumerikValue) -> Result<SinumerikValue, ValueFault> {
    let (left, right) = (left.to_text()?, right.to_text()?);
    Ok(SinumerikValue::text(&format!("{left}{right}")))
}

/// Compares two numbers, two texts or two axes. `is_true` gets their exact order and whether they are equal.
fn compare(
    left: &SinumerikValue,
    right: &SinumerikValue,
    is_true: fn(Option<Ordering>, bool) -> bool,
) -> Result<SinumerikValue, ValueFault> {
    let (order, is_equal) = match (left, right) {
        (SinumerikValue::Axis(left), SinumerikValue::Axis(right)) => {
            let order = left.cmp(right);
            (Some(order), order == Ordering::Equal)
        }
        (SinumerikValue::Text(_), SinumerikValue::Text(_) | SinumerikValue::Character(_))
        | (SinumerikValue::Character(_), SinumerikValue::Text(_)) => {
            let order = left.to_text()?.cmp(&right.to_text()?);
            (Some(order), order == Ordering::Equal)
        }
        _ => {
            let left = numeric("of a comparison", left)?.real();
            let right = numeric("of a comparison", right)?.real();
            (left.partial_cmp(&right), is_equal_number(left, right))
        }
    };
    Ok(SinumerikValue::Boolean(is_true(order, is_equal)))
}
