//! The deviation of a piece from the points that it replaces.

use crate::{Vec2, math};

use super::FitMeasure;
use super::flat::{FittedPiece, FittedShape, PlanarPoints};

/// With [`FitMeasure::Points`], points must not be farther apart than this along an arc, rad: between them the path is
/// not known.
const WIDEST_STEP: f64 = math::PI / 4.0;

/// An upper bound of the Fréchet distance between a piece and its part of the path, mm; `None` if the path does not
/// follow the piece, or the bound is above `limit`.
///
/// Each point of the path is matched with its foot on the piece, or with the farthest point that was already matched, if
/// that is later. Along this matching the distance is largest at the ends of chords, or where a chord is nearest to the
/// centre.
pub(super) fn deviation(
    flat: &PlanarPoints,
    piece: &FittedPiece,
    measure: FitMeasure,
    limit: f64,
) -> Option<f64> {
    let worst = match piece.shape {
        FittedShape::Line => along_line(flat, piece, limit),
        // Comparisons with NaN would not find a deviation.
        FittedShape::Arc { center, sweep } if !(center.dot(center) + sweep).is_finite() => None,
        FittedShape::Arc { center, sweep } => {
            along_arc(flat, piece, (center, sweep), measure, limit)
        }
    };
    worst.filter(|worst| *worst <= limit && worst.is_finite())
}

/// The points of a part of the path: its ends, and those between.
fn points(flat: &PlanarPoints, span: [f64; 2]) -> impl Iterator<Item = (Vec2, f64)> + '_ {
    let [from, to] = span;
    let (first, after) = (from as usize + 1, math::ceil(to) as usize);
    let inner = (first..after.max(first)).map(|index| (flat.at[index], flat.height[index]));
    let end = (to > from).then(|| flat.point(to));
    core::iter::once(flat.point(from)).chain(inner).chain(end)
}

fn distance(a: (Vec2, f64), b: (Vec2, f64)) -> f64 {
    let (flat, high) = (a.0 - b.0, a.1 - b.1);
    (flat.dot(flat) + high * high).sqrt()
}

fn along_line(flat: &PlanarPoints, piece: &FittedPiece, limit: f64) -> Option<f64> {
    let (chord, rise) = (piece.chord(), piece.heights[1] - piece.heights[0]);
    let square = chord.dot(chord) + rise * rise;
    let at = |t: f64| (piece.ends[0] + chord * t, piece.heights[0] + rise * t);
    let (mut worst, mut reached) = (0.0f64, 0.0f64);
    for (index, point) in points(flat, piece.span).enumerate() {
        let (off, high) = (point.0 - piece.ends[0], point.1 - piece.heights[0]);
        let t = if square > 0.0 { (off.dot(chord) + high * rise) / square } else { 0.0 };
        let fraction = t.clamp(reached, 1.0);
        // The start of the line is also matched with the first point.
        if index == 0 {
            worst = distance(point, at(0.0));
        }
        worst = worst.max(distance(point, at(fraction)));
        reached = fraction;
        if worst > limit {
            return None;
        }
    }
    let end = flat.point(piece.span[1]);
    Some(worst.max(distance(end, at(1.0))))
}

fn along_arc(
    flat: &PlanarPoints,
    piece: &FittedPiece,
    (center, sweep): (Vec2, f64),
    measure: FitMeasure,
    limit: f64,
) -> Option<f64> {
    let spoke = piece.ends[0] - center;
    let radius = spoke.length();
    let (sign, sweep) = (sweep.signum(), sweep.abs());
    let rise = (piece.heights[1] - piece.heights[0]) / sweep;
    let at = |angle: f64| {
        let (sin, cos) = math::sin_cos(angle * sign);
        let turned = spoke * cos + spoke.turned_left() * sin;
        (center + turned, piece.heights[0] + rise * angle)
    };
    let step = |a: Vec2, b: Vec2| angle(sign * a.cross(b), a.dot(b));
    let mut row = points(flat, piece.span);
    let first = row.next()?;
    let mut arm = first.0 - center;
    let mut arm_length = arm.length();
    let mut angle = step(spoke, arm);
    let mut reached = angle.clamp(0.0, sweep);
    let mut worst = distance(first, (piece.ends[0], piece.heights[0]));
    worst = worst.max(distance(first, at(reached)));
    let mut last = first;
    for point in row {
        let next = point.0 - center;
        let (turn, length) = (step(arm, next), next.length());
        angle += turn;
        if turn.abs() > if measure == FitMeasure::Points { WIDEST_STEP } else { 0.9 * math::PI } {
            return None;
        }
        if angle <= reached {
            worst = worst.max(distance(point, at(reached)));
        } else {
            let mut off = (length - radius).abs().max((arm_length - radius).abs());
            if measure == FitMeasure::Chords {
                off = off.max((least(arm, next) - radius).abs());
            }
            let mut high = (point.1 - piece.heights[0] - rise * angle.min(sweep)).abs();
            if rise != 0.0 {
                // Along a chord the angle is not linear; twice this is the second derivative.
                let bend = (next - arm).length() / length.min(arm_length);
                high = high.max((last.1 - piece.heights[0] - rise * (angle - turn)).abs());
                high += rise.abs() * 0.25 * bend * bend;
            }
            worst = worst.max((off * off + high * high).sqrt());
            reached = angle.min(sweep);
            if angle > sweep {
                worst = worst.max(distance(point, at(sweep)));
            }
        }
        if worst > limit {
            return None;
        }
        (arm, arm_length, last) = (next, length, point);
    }
    Some(worst.max(distance(last, (piece.ends[1], piece.heights[1]))))
}

/// The angle of a direction, rad; for a small angle, as that of most chords, by a series.
fn angle(sin: f64, cos: f64) -> f64 {
    if sin.abs() > 0.03 * cos {
        return math::atan2(sin, cos);
    }
    let slope = sin / cos;
    let square = slope * slope;
    slope * (1.0 - square * (1.0 / 3.0 - square * (0.2 - square * (1.0 / 7.0 - square / 9.0))))
}

/// The smallest distance of the chord between two points from the origin, mm.
fn least(a: Vec2, b: Vec2) -> f64 {
    let chord = b - a;
    let square = chord.dot(chord);
    let t = if square > 0.0 { (-a.dot(chord) / square).clamp(0.0, 1.0) } else { 0.0 };
    (a + chord * t).length()
}
