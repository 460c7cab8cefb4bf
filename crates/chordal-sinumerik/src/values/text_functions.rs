//! The functions of texts (Job Planning 07/2010, 1.9). Positions count from 0; -1 is no position.

use super::function_arguments::FunctionArguments;
use super::value::{SinumerikValue, ValueFault, single_character};

/// The value of a function of texts; `None` when it is none.
pub(super) fn function_value(
    arguments: &FunctionArguments<'_>,
) -> Option<Result<SinumerikValue, ValueFault>> {
    Some(match arguments.name {
        "STRLEN" => single_text(arguments, |text| count(text.chars().count())),
        "TOUPPER" => single_text(arguments, |text| SinumerikValue::text(&text.to_uppercase())),
        "TOLOWER" => single_text(arguments, |text| SinumerikValue::text(&text.to_lowercase())),
        "ISNUMBER" => {
            single_text(arguments, |text| SinumerikValue::Boolean(number_of(text).is_some()))
        }
        "NUMBER" => number(arguments),
        "INDEX" => searched(arguments, |text, part| text.find(single(part)?)),
        "RINDEX" => searched(arguments, |text, part| text.rfind(single(part)?)),
        "MINDEX" => searched(arguments, |text, part| text.find(|c| part.contains(c))),
        "MATCH" => searched(arguments, |text, part| text.find(part)),
        "SUBSTR" => part_of(arguments),
        _ => return None,
    })
}

fn count(value: usize) -> SinumerikValue {
    SinumerikValue::Integer(i32::try_from(value).unwrap_or(i32::MAX))
}

fn single_text(
    arguments: &FunctionArguments<'_>,
    function: fn(&str) -> SinumerikValue,
) -> Result<SinumerikValue, ValueFault> {
    arguments.expect_count(1, 1)?;
    Ok(function(&arguments.value(0)?.to_text()?))
}

/// The number that a text is: a sign, digits with a point, `EX` and an exponent. `None` for any other text.
fn number_of(text: &str) -> Option<f64> {
    let text = text.trim().to_ascii_uppercase();
    let is_number =
        text.bytes().all(|byte| matches!(byte, b'0'..=b'9' | b'.' | b'+' | b'-' | b'E' | b'X'));
    let value = text.replace("EX", "E").parse::<f64>().ok()?;
    (is_number && value.is_finite()).then_some(value)
}

fn number(arguments: &FunctionArguments<'_>) -> Result<SinumerikValue, ValueFault> {
    arguments.expect_count(1, 1)?;
    let text = arguments.value(0)?.to_text()?;
    match number_of(&text) {
        Some(value) => Ok(SinumerikValue::Real(value)),
        None => Err(ValueFault::arithmetic(format!("the text \"{text}\" is no number"))),
    }
}

/// The only character of a text.
fn single(text: &str) -> Option<char> {
    single_character(text).map(char::from)
}

/// The position of the second text, or of one of its characters, in the first.
fn searched(
    arguments: &FunctionArguments<'_>,
    find: fn(&str, &str) -> Option<usize>,
) -> Result<SinumerikValue, ValueFault> {
    arguments.expect_count(2, 2)?;
    let (text, part) = (arguments.value(0)?.to_text()?, arguments.value(1)?.to_text()?);
    Ok(match find(&text, &part) {
        Some(byte) => count(text[..byte].chars().count()),
        None => SinumerikValue::Integer(-1),
    })
}

/// SUBSTR(text, start, length): without a length up to the end. Before the beginning and after the end there is nothing.
fn part_of(arguments: &FunctionArguments<'_>) -> Result<SinumerikValue, ValueFault> {
    arguments.expect_count(2, 3)?;
    let text = arguments.value(0)?.to_text()?;
    let start = arguments.value(1)?.to_integer()?;
    let length = match arguments.optional(2) {
        Some(length) => usize::try_from(length.to_integer()?).unwrap_or(0),
        None => usize::MAX,
    };
    let Ok(start) = usize::try_from(start) else { return Ok(SinumerikValue::text("")) };
    let part: String = text.chars().skip(start).take(length).collect();
    Ok(SinumerikValue::text(&part))
}
