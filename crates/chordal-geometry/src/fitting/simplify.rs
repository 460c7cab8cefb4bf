//! The same path in fewer chords.

use crate::Vec3;

use super::{DistinctPoints, FitError};

/// Numbers of those of `points` (mm) that are kept so that the path of chords through them is nowhere
/// further than `tolerance` (mm) from that through all, in the sense of Fréchet. Both ends are kept.
///
/// Each chord goes as far as it can: never more chords than the fewest for half of the tolerance.
///
/// # Errors
/// See [`FitError`].
pub fn simplify(points: &[Vec3], tolerance: f64) -> Result<Vec<usize>, FitError> {
    let points = DistinctPoints::of(points, tolerance)?;
    let mut kept: Vec<usize> = points.index.first().copied().into_iter().collect();
    let (mut at, mut hint) = (0, 1);
    while at + 1 < points.at.len() {
        let to = furthest(&points.at, at, hint, tolerance);
        kept.push(points.index[to]);
        hint = to - at;
        at = to;
    }
    Ok(kept)
}

/// The furthest point, as far as doubling and halving find it, to which one chord leads.
fn furthest(points: &[Vec3], from: usize, hint: usize, tolerance: f64) -> usize {
    let (mut good, mut bad) = (1, points.len() - from);
    let mut step = (hint / 2).max(1);
    while good + 1 < bad {
        let next = (good + step).min(bad - 1);
        if !is_near(&points[from..=from + next], tolerance) {
            bad = next;
            break;
        }
        good = next;
        step *= 2;
    }
    while bad - good > 1 {
        let next = good + (bad - good) / 2;
        if is_near(&points[from..=from + next], tolerance) {
            good = next;
        } else {
            bad = next;
        }
    }
    from + good
}

/// Whether the chord from the first point to the last is within the tolerance of the path between
/// them: each point against its foot, or the furthest that was reached already.
fn is_near(part: &[Vec3], tolerance: f64) -> bool {
    let (first, last) = (part[0], part[part.len() - 1]);
    let chord = last - first;
    let square = chord.length_squared();
    let mut reached = 0.0f64;
    part.iter().all(|point| {
        let t = if square > 0.0 { (*point - first).dot(chord) / square } else { 0.0 };
        reached = t.clamp(reached, 1.0);
        point.distance(first + chord * reached) <= tolerance
    })
}
