//! When values that a control keeps are the same.

/// Values nearer than this are the same, mm, rad or the number itself: below the least increment of every control, and
/// above what a change of units rounds.
const EQUAL_VALUE: f64 = 1e-5;

/// Whether two hold the same in the same places: of offsets that a program writes, or gives itself (G43.1).
pub fn are_same_values(a: &[Option<f64>], b: &[Option<f64>]) -> bool {
    let is_same = |(a, b): (&Option<f64>, &Option<f64>)| match (a, b) {
        (Some(a), Some(b)) => (a - b).abs() < EQUAL_VALUE,
        (a, b) => a == b,
    };
    a.len() == b.len() && a.iter().zip(b).all(is_same)
}
