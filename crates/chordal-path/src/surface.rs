//! Times of cuts at a constant cutting speed: the spindle turns faster closer to its axis, and with it a feed per
//! revolution is faster.

use chordal_command::{Feed, FeedMode, SurfaceSpeed};
use chordal_geometry::{Curve, ParamCurve};

/// A piece of a cut with an almost constant speed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurfacePart {
    /// Where it begins on the curve, mm.
    pub from: f64,
    /// Where it ends, mm.
    pub to: f64,
    /// How long it takes, s.
    pub seconds: f64,
}

/// The largest change of the spindle speed on a piece, as a fraction of it.
const CHANGE: f64 = 0.02;

/// The largest number of times a curve is halved: the shortest pieces are about a thousandth of it.
const MAX_HALVINGS: u32 = 10;

/// The pieces of a cut at a constant cutting speed; `None` if the feed does not depend on the spindle speed. X of the
/// curve is the radius of the part.
pub fn surface_parts(feed: &Feed, curve: &Curve) -> Option<Vec<SurfacePart>> {
    let surface = feed.surface?;
    if feed.mode != FeedMode::PerRevolution || feed.value <= 0.0 || feed.value.is_nan() {
        return None;
    }
    let length = curve.length();
    let mut parts = Vec::new();
    divide(&surface, feed.value, curve, [0.0, length], 0, &mut parts);
    Some(parts)
}

/// How long a cut at a constant cutting speed takes, s; `None` if the feed does not depend on the spindle speed.
pub(crate) fn surface_time(feed: &Feed, curve: &Curve) -> Option<f64> {
    Some(surface_parts(feed, curve)?.iter().map(|part| part.seconds).sum())
}

fn divide(
    surface: &SurfaceSpeed,
    per_rev: f64,
    curve: &Curve,
    [from, to]: [f64; 2],
    depth: u32,
    parts: &mut Vec<SurfacePart>,
) {
    let speed = |s: f64| surface.rev_per_s(curve.point_at(s).x);
    let middle = (from + to) / 2.0;
    let [first, half, last] = [from, middle, to].map(speed);
    let (least, most) = (first.min(half).min(last), first.max(half).max(last));
    // Without a limit, the speed at the axis is infinite.
    let even = most.is_finite() && most - least <= CHANGE * most;
    if even || depth == MAX_HALVINGS {
        let seconds = time(surface, per_rev, curve, [from, to]);
        return parts.push(SurfacePart { from, to, seconds });
    }
    divide(surface, per_rev, curve, [from, middle], depth + 1, parts);
    divide(surface, per_rev, curve, [middle, to], depth + 1, parts);
}

/// The integral of ds / (F n), s, by Gauss quadrature with three points: n is almost constant on a piece.
fn time(surface: &SurfaceSpeed, per_rev: f64, curve: &Curve, [from, to]: [f64; 2]) -> f64 {
    const POINTS: [(f64, f64); 3] =
        [(-0.774_596_669_241_483_4, 5.0), (0.0, 8.0), (0.774_596_669_241_483_4, 5.0)];
    let (middle, half) = ((from + to) / 2.0, (to - from) / 2.0);
    let sum: f64 = POINTS
        .iter()
        .map(|(at, weight)| weight / surface.rev_per_s(curve.point_at(middle + at * half).x))
        .sum();
    sum / 9.0 * half / per_rev
}

#[cfg(test)]
mod tests {
    use super::*;
    use chordal_command::FeedAlong;
    use chordal_geometry::{Line, Vec3};

    /// Seconds of a straight cut between two places of (X, Z), X a radius, at 200 m/min and most 3000 rpm.
    fn seconds(from: [f64; 2], to: [f64; 2], per_rev: f64) -> f64 {
        seconds_below(50.0, from, to, per_rev)
    }

    /// The same with another limit of the spindle, rev/s.
    fn seconds_below(most_rev_per_s: f64, from: [f64; 2], to: [f64; 2], per_rev: f64) -> f64 {
        let feed = Feed {
            value: per_rev,
            mode: FeedMode::PerRevolution,
            along: FeedAlong::Path,
            spindle_rev_per_s: 0.0,
            lead_change: 0.0,
            surface: Some(SurfaceSpeed {
                mm_per_s: 200_000.0 / 60.0,
                most_rev_per_s,
                is_limited: true,
            }),
        };
        let point = |[x, z]: [f64; 2]| Vec3::new(x, 0.0, z);
        let line = Curve::Line(Line { start: point(from), end: point(to) });
        surface_time(&feed, &line).expect("per revolution")
    }

    #[test]
    fn times_are_those_of_integrals_by_hand() {
        // A face from diameter 60 to the axis at 0.2: pi·(30² − 10.6103²)/(0.2·V) outside diameter 21.2207,
        // and 10.6103/(0.2·50) at the limit inside.
        let face = seconds([30.0, 0.0], [0.0, 0.0], 0.2);
        assert!((face - 4.7717).abs() < 4.7717e-4, "{face}");
        // Along Z at diameter 40, and a cone from 20 to 40 over 15 without a limit: 2·pi·15·18.0278/(0.3·V).
        let along = seconds([20.0, 0.0], [20.0, -50.0], 0.3);
        assert!((along - std::f64::consts::TAU).abs() < 1e-4, "{along}");
        let cone = seconds_below(1e3, [10.0, 0.0], [20.0, -15.0], 0.3);
        assert!((cone - 1.6991).abs() < 1.7e-4, "{cone}");
    }
}
