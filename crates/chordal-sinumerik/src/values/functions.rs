//! The functions of numbers. Angles are degrees.

use super::function_arguments::FunctionArguments;
use super::text_functions;
use super::value::{SinumerikValue, ValueFault};

/// The value of a function of the language; `None` when it is none.
pub(super) fn function_value(
    name: &str,
    values: &[Option<SinumerikValue>],
) -> Option<Result<SinumerikValue, ValueFault>> {
    let arguments = FunctionArguments { name, values };
    Some(match name {
        "SIN" => real(&arguments, |angle| Ok(sine_and_cosine(angle).0)),
        "COS" => real(&arguments, |angle| Ok(sine_and_cosine(angle).1)),
        "TAN" => real(&arguments, tangent),
        "ASIN" => real(&arguments, |value| unit_range(value).map(|v| libm::asin(v).to_degrees())),
        "ACOS" => real(&arguments, |value| unit_range(value).map(|v| libm::acos(v).to_degrees())),
        "ATAN2" => angle_of(&arguments),
        "SQRT" => real(&arguments, square_root),
        "POT" => real(&arguments, |value| Ok(value * value)),
        "LN" => real(&arguments, logarithm),
        "EXP" => real(&arguments, |value| Ok(libm::exp(value))),
        "ABS" => absolute(&arguments),
        "TRUNC" => arguments.only_real().map(|value| SinumerikValue::whole(value.trunc())),
        "ROUND" => arguments.only_real().map(|value| SinumerikValue::whole(value.round())),
        // -3.1 gives -3 (Job Planning 03/2006, 1.24).
        "ROUNDUP" => arguments.only_real().map(|value| SinumerikValue::whole(value.ceil())),
        "MINVAL" => chosen(&arguments, |left, right| left <= right),
        "MAXVAL" => chosen(&arguments, |left, right| left >= right),
        "BOUND" => bounded(&arguments),
        _ => return text_functions::function_value(&arguments),
    })
}

fn real(
    arguments: &FunctionArguments<'_>,
    function: fn(f64) -> Result<f64, ValueFault>,
) -> Result<SinumerikValue, ValueFault> {
    SinumerikValue::finite(function(arguments.only_real()?)?)
}

/// The sine and the cosine of an angle in degrees. The angle is reduced to ±45° before it becomes radians, so that
/// multiples of 90° are exact.
fn sine_and_cosine(degrees: f64) -> (f64, f64) {
    let turn = libm::fmod(degrees, 360.0);
    let quarter = (turn / 90.0).round();
    let (sine, cosine) = libm::sincos((turn - quarter * 90.0).to_radians());
    match (quarter as i32).rem_euclid(4) {
        0 => (sine, cosine),
        1 => (cosine, -sine),
        2 => (-sine, -cosine),
        _ => (-cosine, sine),
    }
}

fn tangent(degrees: f64) -> Result<f64, ValueFault> {
    let (sine, cosine) = sine_and_cosine(degrees);
    if cosine == 0.0 {
        return Err(ValueFault::arithmetic("the tangent of 90° is infinite"));
    }
    Ok(sine / cosine)
}

fn unit_range(value: f64) -> Result<f64, ValueFault> {
    if (-1.0..=1.0).contains(&value) {
        Ok(value)
    } else {
        Err(ValueFault::arithmetic("the arc sine and cosine need a value from -1 to 1"))
    }
}

/// ATAN2(y,x): the angle of the vector (x,y) above -180° up to 180°.
fn angle_of(arguments: &FunctionArguments<'_>) -> Result<SinumerikValue, ValueFault> {
    arguments.expect_count(2, 2)?;
    let (y, x) = (arguments.real(0)?, arguments.real(1)?);
    let degrees = libm::atan2(y, x).to_degrees();
    SinumerikValue::finite(if degrees <= -180.0 { 180.0 } else { degrees })
}

fn square_root(value: f64) -> Result<f64, ValueFault> {
    if value < 0.0 {
        return Err(ValueFault::arithmetic("the square root of a negative number"));
    }
    Ok(value.sqrt())
}

fn logarithm(value: f64) -> Result<f64, ValueFault> {
    if value <= 0.0 {
        return Err(ValueFault::arithmetic("the logarithm of a number that is not positive"));
    }
    Ok(libm::log(value))
}

/// The type of the argument stays.
fn absolute(arguments: &FunctionArguments<'_>) -> Result<SinumerikValue, ValueFault> {
    let value = arguments.only_real()?;
    Ok(match arguments.value(0)? {
        SinumerikValue::Real(_) => SinumerikValue::Real(value.abs()),
        _ => SinumerikValue::whole(value.abs()),
    })
}

/// The first of two numbers if the condition holds, else the second.
fn chosen(
    arguments: &FunctionArguments<'_>,
    is_first: fn(f64, f64) -> bool,
) -> Result<SinumerikValue, ValueFault> {
    arguments.expect_count(2, 2)?;
    let index = usize::from(!is_first(arguments.real(0)?, arguments.real(1)?));
    arguments.value(index).cloned()
}

/// BOUND(least, greatest, value).
fn bounded(arguments: &FunctionArguments<'_>) -> Result<SinumerikValue, ValueFault> {
    arguments.expect_count(3, 3)?;
    let (least, greatest, value) = (arguments.real(0)?, arguments.real(1)?, arguments.real(2)?);
    let index = if value < least {
        0
    } else if value > greatest {
        1
    } else {
        2
    };
    arguments.value(index).cloned()
}
