//! Simplifies a path to fewer chords.

use crate::Vec3;

use super::{DistinctPoints, FitError};

/// The indices of the `points` (mm) to keep so that the Fréchet distance between the path of chords through them and that
/// through all points is at most `tolerance` (mm). Both ends are kept.
///
/// Each chord is as long as possible. There are never more chords than the minimum for half of the tolerance.
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

/// The farthest point to which one chord leads, as far as doubling and bisection find it.
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

/// Whether the chord from the first point to the last is within the tolerance of the path between them. Each point is
/// matched with its foot on the chord, or with the farthest point that was already matched, if that is later.
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
