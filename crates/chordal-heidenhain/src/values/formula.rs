//! Evaluates formulas. Angles are degrees.

use chordal_diagnostics::TextRange;
use chordal_kernel::frames::sin_cos_degrees;

use super::parameters::ParameterStore;
use crate::syntax::{
    FormulaFunction, FormulaOperator, FormulaStep, KlartextFormula, ParameterName,
};

/// Why a formula has no value.
#[derive(Clone, PartialEq, Debug)]
pub enum FormulaError {
    /// A division by zero, with the place of the operator.
    DivisionByZero(TextRange),
    /// A function or a power of a number that it is not defined for, with its words.
    OutsideDomain(TextRange, String),
    /// A parameter that was never set.
    Unset(TextRange, ParameterName),
    /// The result is too large.
    Overflow(TextRange),
}

/// The value of a formula.
///
/// # Errors
/// Why it has none, with the place of the step.
pub fn formula_value(
    formula: &KlartextFormula,
    parameters: &ParameterStore,
) -> Result<f64, FormulaError> {
    let mut stack: Vec<f64> = Vec::new();
    for (step, range) in &formula.steps {
        let value = match step {
            FormulaStep::Number(value) => *value,
            FormulaStep::Parameter(name) => {
                parameters.number(*name).ok_or(FormulaError::Unset(*range, *name))?
            }
            FormulaStep::Function(function) => {
                let operand = stack.pop().unwrap_or_default();
                function_value(*function, operand)
                    .ok_or_else(|| domain_error(*range, *function, operand))?
            }
            FormulaStep::Operator(operator) => {
                let second = stack.pop().unwrap_or_default();
                let first = stack.pop().unwrap_or_default();
                operator_value(*operator, first, second, *range)?
            }
        };
        if !value.is_finite() {
            return Err(FormulaError::Overflow(*range));
        }
        stack.push(value);
    }
    Ok(stack.pop().unwrap_or_default())
}

fn domain_error(range: TextRange, function: FormulaFunction, operand: f64) -> FormulaError {
    let allowed = match function {
        FormulaFunction::SquareRoot => "the root of a number below zero",
        FormulaFunction::ArcSine | FormulaFunction::ArcCosine => {
            "the angle of a sine or cosine that is not between -1 and 1"
        }
        FormulaFunction::NaturalLogarithm | FormulaFunction::DecimalLogarithm => {
            "the logarithm of a number that is not above zero"
        }
        _ => "the tangent of a right angle",
    };
    FormulaError::OutsideDomain(range, format!("{allowed}: it is {operand}"))
}

/// The value of a function; `None` where it is not defined.
fn function_value(function: FormulaFunction, x: f64) -> Option<f64> {
    Some(match function {
        FormulaFunction::Sine => sin_cos_degrees(x).0,
        FormulaFunction::Cosine => sin_cos_degrees(x).1,
        FormulaFunction::Tangent => {
            let (sin, cos) = sin_cos_degrees(x);
            if cos == 0.0 {
                return None;
            }
            sin / cos
        }
        FormulaFunction::ArcSine if x.abs() <= 1.0 => libm::asin(x).to_degrees(),
        FormulaFunction::ArcCosine if x.abs() <= 1.0 => libm::acos(x).to_degrees(),
        FormulaFunction::SquareRoot if x >= 0.0 => x.sqrt(),
        FormulaFunction::NaturalLogarithm if x > 0.0 => libm::log(x),
        FormulaFunction::DecimalLogarithm if x > 0.0 => libm::log10(x),
        FormulaFunction::ArcSine
        | FormulaFunction::ArcCosine
        | FormulaFunction::SquareRoot
        | FormulaFunction::NaturalLogarithm
        | FormulaFunction::DecimalLogarithm => return None,
        FormulaFunction::ArcTangent => libm::atan(x).to_degrees(),
        FormulaFunction::Square => x * x,
        FormulaFunction::Exponential => libm::exp(x),
        FormulaFunction::Absolute => x.abs(),
        FormulaFunction::Integer => x.trunc(),
        FormulaFunction::Fraction => x.fract(),
        FormulaFunction::Negative => 0.0 - x,
        FormulaFunction::SignOf => match x {
            0.0 => 0.0,
            x => x.signum(),
        },
    })
}

fn operator_value(
    operator: FormulaOperator,
    first: f64,
    second: f64,
    range: TextRange,
) -> Result<f64, FormulaError> {
    Ok(match operator {
        FormulaOperator::Add => first + second,
        FormulaOperator::Subtract => first - second,
        FormulaOperator::Multiply => first * second,
        FormulaOperator::Divide | FormulaOperator::Remainder if second == 0.0 => {
            return Err(FormulaError::DivisionByZero(range));
        }
        FormulaOperator::Divide => first / second,
        // The sign is that of the number that is divided; the manuals show positive numbers alone.
        FormulaOperator::Remainder => libm::fmod(first, second),
        FormulaOperator::Power if first == 0.0 && second < 0.0 => {
            return Err(FormulaError::DivisionByZero(range));
        }
        FormulaOperator::Power => {
            let value = libm::pow(first, second);
            if value.is_nan() {
                let message = format!("a power that has no value: {first} ^ {second}");
                return Err(FormulaError::OutsideDomain(range, message));
            }
            value
        }
        FormulaOperator::Length => libm::hypot(first, second),
        // The first value lies opposite of the angle.
        FormulaOperator::Angle => {
            let degrees = libm::atan2(first, second).to_degrees().rem_euclid(360.0);
            // An angle just below zero rounds to a full turn.
            if degrees < 360.0 { degrees } else { 0.0 }
        }
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::syntax::{KlartextReader, KlartextStatement};

    fn value(text: &str) -> Result<f64, FormulaError> {
        let block = KlartextReader::new(text.as_bytes()).next().expect("a block");
        let KlartextStatement::Assign { formula, .. } = block.statement else {
            panic!("{text}: {:?}", block.faults);
        };
        formula_value(&formula, &ParameterStore::default())
    }

    #[test]
    fn functions_bind_to_the_next_operand() {
        let near = |text: &str, expected: f64| {
            let found = value(text).expect("a value");
            assert!((found - expected).abs() < 5e-5, "{text}: {found}");
        };
        near("Q3 = SQ 10 - 3^3", 73.0);
        near("Q1 = ( 5 + 3 ) * 10", 80.0);
        near("Q1 = 20 - 5 - 3", 12.0);
        near("Q1 = 10 / 4 * 2", 5.0);
        near("Q1 = LOG 1000 + LN EXP 2", 5.0);
        near("Q1 = 2 * SIN 30 + COS 60", 1.5);
        near("FN 8: Q9 = +5 LEN +4", 6.4031);
        near("FN 13: Q11 = -3 ANG -3", 225.0);
        near("FN 4: Q13 = +1 DIV -8", -0.125);
        near("Q1 = - 200", -200.0);
    }

    #[test]
    fn what_has_no_value() {
        assert!(matches!(value("Q1 = 1 / 0"), Err(FormulaError::DivisionByZero(_))));
        assert!(matches!(value("Q1 = SQRT -4"), Err(FormulaError::OutsideDomain(..))));
        assert!(matches!(value("Q1 = ASIN 1.2"), Err(FormulaError::OutsideDomain(..))));
        assert!(matches!(value("Q1 = LN 0"), Err(FormulaError::OutsideDomain(..))));
        assert!(matches!(value("Q1 = Q2"), Err(FormulaError::Unset(..))));
        assert!(matches!(value("Q1 = EXP 1000"), Err(FormulaError::Overflow(_))));
    }
}
