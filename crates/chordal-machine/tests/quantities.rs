//! Quantities: every unit, exactly.

use chordal_machine::{QuantityDimension, QuantityError, SettingValue, parse_quantity};
use proptest::prelude::*;

fn check(text: &str, dimension: QuantityDimension, expected: f64) {
    assert_eq!(parse_quantity(text, dimension), Ok(expected), "{text}");
}

#[test]
fn units() {
    use std::f64::consts::{PI, TAU};
    for (text, mm) in [
        ("0.5 in", 12.7),
        ("0.5in", 12.7),
        (".5 inch", 12.7),
        ("5.e-1 IN", 12.7),
        ("+0.50 \"", 12.7),
        ("-1 ft", -304.8),
        ("1 m", 1000.0),
        ("2.5 cm", 25.0),
        ("3 um", 0.003),
        ("3 \u{b5}m", 0.003),
        ("3 \u{3bc}m", 0.003),
        ("  7 mm  ", 7.0),
        ("0 mm", 0.0),
    ] {
        check(text, QuantityDimension::Length, mm);
    }
    check("1.5 s", QuantityDimension::Time, 1.5);
    check("250 ms", QuantityDimension::Time, 0.25);
    check("0.1 min", QuantityDimension::Time, 6.0);
    check("900 in/min", QuantityDimension::Velocity, 381.0);
    check("900 IPM", QuantityDimension::Velocity, 381.0);
    check("25 m / min", QuantityDimension::Velocity, 25_000.0 / 60.0);
    check("5 mm/ms", QuantityDimension::Velocity, 5000.0);
    check("2000 mm/s^2", QuantityDimension::Acceleration, 2000.0);
    check("2000 mm/s\u{b2}", QuantityDimension::Acceleration, 2000.0);
    check("3600 mm/min^2", QuantityDimension::Acceleration, 1.0);
    check("60 mm/min/s", QuantityDimension::Acceleration, 1.0);
    check("100 m/s^3", QuantityDimension::Jerk, 100_000.0);
    check("100 m/s\u{b3}", QuantityDimension::Jerk, 100_000.0);
    check("90 deg", QuantityDimension::Angle, PI / 2.0);
    check("360 \u{b0}", QuantityDimension::Angle, TAU);
    check("1 rev", QuantityDimension::Angle, TAU);
    check("2 rad", QuantityDimension::Angle, 2.0);
    check("60 rpm", QuantityDimension::AngularVelocity, TAU);
    check("180 deg/s^2", QuantityDimension::AngularAcceleration, PI);
    check("180 deg/s^3", QuantityDimension::AngularJerk, PI);
    check("6000 rpm", QuantityDimension::SpindleSpeed, 6000.0);
    check("100 rev/s", QuantityDimension::SpindleSpeed, 6000.0);
    check("33.3 rev/min", QuantityDimension::SpindleSpeed, 33.3);
    for text in ["1500 N/mm^2", "1500 N/mm\u{b2}", "1500N/mm2", "1500 MPa"] {
        check(text, QuantityDimension::Stress, 1500.0);
    }
    // A thousand pounds on a square inch.
    check("64516 ksi", QuantityDimension::Stress, 444_822.161_526_05);
}

#[test]
fn refusals() {
    let refused =
        |text: &str, dimension| parse_quantity(text, dimension).expect_err(text).to_string();
    assert_eq!(
        refused("25 m/min", QuantityDimension::Length),
        "this must be a length; `25 m/min` is a velocity"
    );
    assert_eq!(
        refused("25", QuantityDimension::Velocity),
        "this must be a velocity; `25` has no unit"
    );
    assert_eq!(
        refused("", QuantityDimension::Time),
        "this must be a time; `` does not start with a number"
    );
    assert_eq!(
        refused("inf mm", QuantityDimension::Length),
        "this must be a length; `inf mm` does not start with a number"
    );
    assert_eq!(
        refused("1,5 mm", QuantityDimension::Length),
        "this must be a length; `,5 mm` is not a unit"
    );
    assert_eq!(
        refused("1 mm/s^4", QuantityDimension::Length),
        "this must be a length; `mm/s^4` is not a unit"
    );
    assert_eq!(
        refused("1 mm/mm", QuantityDimension::Length),
        "this must be a length; `mm/mm` is not a unit"
    );
    assert_eq!(
        refused("1 s/s", QuantityDimension::Time),
        "this must be a time; `1 s/s` is not a quantity of a machine file"
    );
    assert_eq!(
        refused("1 rad/s", QuantityDimension::SpindleSpeed),
        "this must be a spindle speed; `1 rad/s` is an angular velocity"
    );
    assert_eq!(
        refused("1e400 mm", QuantityDimension::Length),
        "this must be a length; `1e400 mm` is out of range"
    );
    let help = |text: &str, dimension| parse_quantity(text, dimension).expect_err(text).help();
    assert_eq!(
        help("5 imch", QuantityDimension::Length).as_deref(),
        Some("write it with its unit: \"5 in\" or \"5 mm\"")
    );
    assert_eq!(
        help("5 mm/mi", QuantityDimension::Velocity).as_deref(),
        Some("did you mean \"5 mm/min\"?")
    );
    assert_eq!(
        help("5 km", QuantityDimension::Length).as_deref(),
        Some("write it with its unit: \"5 in\" or \"5 mm\"")
    );
}

#[test]
fn settings_as_lengths() {
    let text = SettingValue::Text("0.0005 in".into());
    assert_eq!(text.as_length_mm(), Ok(0.0127));
    let none = |value: SettingValue| value.as_length_mm().expect_err("no length");
    assert!(matches!(none(SettingValue::Integer(5)), QuantityError::NoUnit { .. }));
    assert!(matches!(none(SettingValue::Float(0.5)), QuantityError::NoUnit { .. }));
    assert!(matches!(none(SettingValue::Bool(true)), QuantityError::NotANumber { .. }));
}

/// `count` times ten to minus `decimals`, as somebody writes it.
fn decimal(count: u64, decimals: usize) -> String {
    let digits = format!("{count:0width$}", width = decimals + 1);
    let (whole, part) = digits.split_at(digits.len() - decimals);
    if part.is_empty() { whole.to_string() } else { format!("{whole}.{part}") }
}

proptest! {
    /// A quotient of two numbers that doubles hold exactly is rounded once by the hardware.
    #[test]
    fn inches_round_once(count in 0..1_000_000_000_000u64, decimals in 0..8usize) {
        let number = decimal(count, decimals);
        let ten = 10f64.powi(decimals as i32 + 1);
        let mm = (count * 254) as f64 / ten;
        prop_assert_eq!(parse_quantity(&format!("{number} in"), QuantityDimension::Length), Ok(mm));
        prop_assert_eq!(parse_quantity(&format!("-{number} in"), QuantityDimension::Length), Ok(-mm));
        let rate = (count * 254) as f64 / (60.0 * ten);
        prop_assert_eq!(parse_quantity(&format!("{number} in/min"), QuantityDimension::Velocity), Ok(rate));
        let jerk = (count * 254) as f64 / (216_000.0 * ten);
        prop_assert_eq!(parse_quantity(&format!("{number} in/min^3"), QuantityDimension::Jerk), Ok(jerk));
    }

    #[test]
    fn millimetres_are_as_written(value in any::<f64>().prop_filter("finite", |v| v.is_finite())) {
        prop_assert_eq!(parse_quantity(&format!("{value} mm"), QuantityDimension::Length), Ok(value));
        prop_assert_eq!(parse_quantity(&format!("{value:e} mm"), QuantityDimension::Length), Ok(value));
    }

    #[test]
    fn degrees_are_within_the_last_bit(count in -360_000_000..360_000_000i64) {
        let degrees = count as f64 / 1e6;
        let radians = parse_quantity(&format!("{degrees} deg"), QuantityDimension::Angle).expect("an angle");
        prop_assert!((radians - degrees.to_radians()).abs() <= radians.abs() * f64::EPSILON);
    }
}
