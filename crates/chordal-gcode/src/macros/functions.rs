//! Functions and operators of macro languages. Angles are degrees.

use chordal_dialect::macros::{LogicRule, MacroRules, RoundingRule};
use chordal_syntax::{Function, Operator};

use super::value::{MacroValue, equal};

/// Why a function has no result.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) enum FunctionError {
    DivisionByZero,
    /// The function is not defined for this argument.
    Domain(f64),
    /// The value is not known outside the control (PRM).
    Unknown,
}

type FunctionResult = Result<f64, FunctionError>;

/// Sine and cosine of degrees, exact at multiples of 90.
fn sin_cos(degrees: f64) -> (f64, f64) {
    let turn = libm::fmod(degrees, 360.0);
    let quarter = turn / 90.0;
    if quarter == libm::trunc(quarter) {
        return match (quarter as i32).rem_euclid(4) {
            0 => (0.0, 1.0),
            1 => (1.0, 0.0),
            2 => (0.0, -1.0),
            _ => (-1.0, 0.0),
        };
    }
    libm::sincos(turn.to_radians())
}

/// The nearest whole number, half away from zero.
pub(crate) fn round(value: f64) -> f64 {
    libm::round(value)
}

/// Rounds to a number of decimals.
pub(crate) fn round_to(value: f64, digits: u8) -> f64 {
    let power = 10f64.powi(i32::from(digits));
    let scaled = value * power;
    if scaled.abs() < 1e15 { libm::round(scaled) / power } else { value }
}

/// A function of one argument.
pub(crate) fn one(
    function: Function,
    x: f64,
    rules: &MacroRules,
    word_digits: Option<u8>,
) -> FunctionResult {
    let domain = |good: bool, value: f64| {
        if good { Ok(value) } else { Err(FunctionError::Domain(x)) }
    };
    match function {
        Function::Sin => Ok(sin_cos(x).0),
        Function::Cos => Ok(sin_cos(x).1),
        Function::Tan => {
            let (sin, cos) = sin_cos(x);
            domain(cos != 0.0, sin / cos)
        }
        Function::Asin => {
            let angle = libm::asin(x).to_degrees();
            let full = rules.asin_full_circle && angle < 0.0;
            domain(x.abs() <= 1.0, if full { angle + 360.0 } else { angle })
        }
        Function::Acos => domain(x.abs() <= 1.0, libm::acos(x).to_degrees()),
        Function::Atan => Ok(libm::atan(x).to_degrees()),
        Function::Sqrt => domain(x >= 0.0, x.sqrt()),
        Function::Abs => Ok(x.abs()),
        Function::Bin => from_bcd(x).ok_or(FunctionError::Domain(x)),
        Function::Bcd => to_bcd(x).ok_or(FunctionError::Domain(x)),
        // Inside a word ROUND rounds to the increment of the address, elsewhere to whole numbers.
        Function::Round => Ok(word_digits.map_or_else(|| round(x), |digits| round_to(x, digits))),
        Function::RoundPlaces => Ok(round_to(x, word_digits.unwrap_or(0))),
        Function::Fix => Ok(match rules.fix {
            RoundingRule::TowardZero => libm::trunc(x),
            RoundingRule::Floor => libm::floor(x),
        }),
        Function::Fup => Ok(match rules.fix {
            RoundingRule::TowardZero if x < 0.0 => libm::floor(x),
            _ => libm::ceil(x),
        }),
        Function::Ln => domain(x > 0.0, libm::log(x)),
        Function::Exp => Ok(libm::exp(x)),
        Function::AddPoint => Ok(x),
        Function::Sign => Ok(if x < 0.0 { -1.0 } else { 1.0 }),
        Function::Not => Ok(truth(x == 0.0)),
        Function::Power | Function::Parameter | Function::Exists => Err(FunctionError::Unknown),
    }
}

/// A function of two arguments.
pub(crate) fn two(function: Function, a: f64, b: f64, rules: &MacroRules) -> FunctionResult {
    match function {
        Function::Atan => {
            let angle = libm::atan2(a, b).to_degrees();
            let full = rules.atan_full_circle && angle < 0.0;
            Ok(if full { angle + 360.0 } else { angle })
        }
        Function::Power => power(a, b),
        _ => Err(FunctionError::Unknown),
    }
}

fn power(a: f64, b: f64) -> FunctionResult {
    let result = libm::pow(a, b);
    if result.is_nan() || result.is_infinite() { Err(FunctionError::Domain(a)) } else { Ok(result) }
}

/// An operator on known values.
pub(crate) fn binary(
    operator: Operator,
    a: MacroValue,
    b: MacroValue,
    rules: &MacroRules,
) -> FunctionResult {
    let near = rules.equal_tolerance;
    let (x, y) = (a.known().unwrap_or(0.0), b.known().unwrap_or(0.0));
    Ok(match operator {
        Operator::Add => x + y,
        Operator::Subtract => x - y,
        Operator::Multiply => x * y,
        Operator::Divide if y == 0.0 => return Err(FunctionError::DivisionByZero),
        Operator::Divide => x / y,
        Operator::Modulo if y == 0.0 => return Err(FunctionError::DivisionByZero),
        Operator::Modulo => {
            let rest = libm::fmod(x, y);
            if rules.modulo_positive && rest < 0.0 { rest + y.abs() } else { rest }
        }
        Operator::Power => return power(x, y),
        Operator::And | Operator::Or | Operator::Xor => logic(operator, x, y, rules.logic),
        Operator::Equal => truth(equal(a, b, near)),
        Operator::NotEqual => truth(!equal(a, b, near)),
        // In these, vacant acts as zero.
        Operator::Greater => truth(x > y),
        Operator::GreaterOrEqual => truth(x >= y),
        Operator::Less => truth(x < y),
        Operator::LessOrEqual => truth(x <= y),
    })
}

fn logic(operator: Operator, x: f64, y: f64, logic: LogicRule) -> f64 {
    if logic == LogicRule::Logical {
        let (a, b) = (x != 0.0, y != 0.0);
        return truth(match operator {
            Operator::And => a && b,
            Operator::Or => a || b,
            _ => a != b,
        });
    }
    let (a, b) = (bits(x), bits(y));
    f64::from(match operator {
        Operator::And => a & b,
        Operator::Or => a | b,
        _ => a ^ b,
    })
}

/// The integer part as a 32-bit pattern.
fn bits(x: f64) -> i32 {
    let whole = libm::trunc(x);
    if whole.abs() < 2f64.powi(53) { whole as i64 as i32 } else { 0 }
}

fn truth(value: bool) -> f64 {
    if value { 1.0 } else { 0.0 }
}

fn from_bcd(x: f64) -> Option<f64> {
    let mut bits = whole(x)?;
    let (mut sum, mut place) = (0u64, 1u64);
    while bits > 0 {
        let digit = bits & 15;
        if digit > 9 {
            return None;
        }
        sum += digit * place;
        place *= 10;
        bits >>= 4;
    }
    Some(sum as f64)
}

fn to_bcd(x: f64) -> Option<f64> {
    let mut digits = whole(x)?;
    if digits > 99_999_999 {
        return None;
    }
    let (mut bits, mut shift) = (0u64, 0);
    while digits > 0 {
        bits |= (digits % 10) << shift;
        digits /= 10;
        shift += 4;
    }
    Some(bits as f64)
}

fn whole(x: f64) -> Option<u64> {
    let x = round(x);
    (0.0..=4_294_967_295.0).contains(&x).then_some(x as u64)
}
