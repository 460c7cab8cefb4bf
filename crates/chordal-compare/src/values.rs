//! Equality of values that a control stores.

/// Values that differ by less are equal (mm, rad or a plain number): below the least increment of every control, and
/// above the rounding error of a unit conversion.
const EQUAL_VALUE: f64 = 1e-5;

/// Whether two lists of offsets, written by a program or set directly with G43.1, have equal values at the same
/// positions.
pub fn are_same_values(a: &[Option<f64>], b: &[Option<f64>]) -> bool {
    let is_same = |(a, b): (&Option<f64>, &Option<f64>)| match (a, b) {
        (Some(a), Some(b)) => (a - b).abs() < EQUAL_VALUE,
        (a, b) => a == b,
    };
    a.len() == b.len() && a.iter().zip(b).all(is_same)
}
