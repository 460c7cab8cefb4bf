//! Data as JSON for people and programs: numbers without the digits that sums of doubles leave behind.

use serde_json::{Number, Value};

/// So many figures outlive the rounding of a few sums; a double has up to seventeen.
const FIGURES: usize = 14;

/// Data as JSON text over several lines, with an end of line: `60.0` where sums have made 60.00000000000001.
pub fn pretty_json(mut data: Value) -> String {
    round(&mut data);
    format!("{data:#}\n")
}

fn round(data: &mut Value) {
    match data {
        Value::Number(number) if number.is_f64() => {
            let value = number.as_f64().unwrap_or(f64::NAN);
            let near = format!("{value:.*e}", FIGURES - 1).parse().unwrap_or(value);
            if let Some(near) = Number::from_f64(near) {
                *number = near;
            }
        }
        Value::Array(values) => values.iter_mut().for_each(round),
        Value::Object(members) => members.values_mut().for_each(round),
        Value::Number(_) | Value::String(_) | Value::Bool(_) | Value::Null => {}
    }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::pretty_json;

    #[test]
    fn sums_leave_no_digits_behind() {
        let sum: f64 = [0.1; 3].iter().sum();
        let cases = [
            (60.000_000_000_000_01, "60.0\n"),
            (sum, "0.3\n"),
            (1.0 - 0.9, "0.1\n"),
            (-3.400_000_000_000_000_4, "-3.4\n"),
            (1e-7 / 3.0, "3.3333333333333e-8\n"),
            (123_456_789.125, "123456789.125\n"),
            (0.0, "0.0\n"),
        ];
        for (value, text) in cases {
            assert_eq!(pretty_json(json!(value)), text);
        }
        assert_eq!(pretty_json(json!(f64::NAN)), "null\n");
        assert_eq!(
            pretty_json(json!({"a": [1, 0.1 + 0.2]})),
            "{\n  \"a\": [\n    1,\n    0.3\n  ]\n}\n"
        );
    }
}
