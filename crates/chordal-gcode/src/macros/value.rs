//! Values: numbers and null.

/// A value of a variable or an expression; `None` is null, the value of a variable that was
/// never written.
pub(crate) type Value = Option<f64>;

/// A value in arithmetic: null counts as zero.
#[inline]
pub(crate) fn number(value: Value) -> f64 {
    value.unwrap_or(0.0)
}

/// EQ: null equals null and nothing else, not even zero (Mitsubishi M700V p. 389).
#[inline]
pub(crate) fn equal(a: Value, b: Value, tolerance: f64) -> bool {
    match (a, b) {
        (Some(a), Some(b)) => a == b || (a - b).abs() < tolerance,
        (a, b) => a.is_none() && b.is_none(),
    }
}
