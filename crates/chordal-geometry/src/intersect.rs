//! Intersections of lines and circles in a plane.
//!
//! Differences of squares are computed as products, and all coordinates are relative to one of the two shapes, so that no
//! digits are lost because of a large distance from the origin.

use core::f64::consts::TAU;

use crate::Vec2;

/// An infinite line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Line2 {
    /// A point on the line, mm.
    pub point: Vec2,
    /// The direction of the line, of any length above zero.
    pub direction: Vec2,
}

/// A full circle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Circle2 {
    /// Centre, mm.
    pub center: Vec2,
    /// Radius, mm, not negative.
    pub radius: f64,
}

/// The points two shapes have in common.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Meeting {
    /// They have none.
    None,
    /// They touch in one point, mm.
    Touch(Vec2),
    /// They cross in two points, mm: with a line, in the order of its direction; for two circles, first the point on
    /// the left, seen from the first centre to the second.
    Cross(Vec2, Vec2),
    /// They are equal within the tolerance.
    Same,
}

impl Meeting {
    /// The points, mm: none, one or two; none if the shapes are equal.
    pub fn points(self) -> impl Iterator<Item = Vec2> {
        let (a, b) = match self {
            Meeting::None | Meeting::Same => (None, None),
            Meeting::Touch(p) => (Some(p), None),
            Meeting::Cross(p, q) => (Some(p), Some(q)),
        };
        a.into_iter().chain(b)
    }

    /// The point nearest to `p`, mm; `None` without points.
    #[must_use]
    pub fn nearest_to(self, p: Vec2) -> Option<Vec2> {
        match self {
            Meeting::None | Meeting::Same => None,
            Meeting::Touch(q) => Some(q),
            Meeting::Cross(a, b) => Some(if b.distance(p) < a.distance(p) { b } else { a }),
        }
    }
}

/// The fractions of an arc, from 0 to less than 1, at which it passes an angle (rad): one for each of its turns.
pub fn fractions_at_angle(start: f64, sweep: f64, angle: f64) -> impl Iterator<Item = f64> {
    let path = if sweep < 0.0 { start - angle } else { angle - start };
    let (first, whole) = (path.rem_euclid(TAU), sweep.abs());
    let turns = core::iter::successors(Some(first), |swept| Some(swept + TAU));
    turns.take_while(move |swept| *swept < whole).map(move |swept| swept / whole)
}

/// Where two lines cross.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LineCrossing {
    /// The point, mm.
    pub point: Vec2,
    /// Its position along the first line, in lengths of its direction vector.
    pub along_first: f64,
    /// Its position along the second line, in lengths of its direction vector.
    pub along_second: f64,
}

/// The crossing of two lines. `None` if the absolute sine of the angle between them is at most `parallel_sine`, or a
/// direction is zero.
#[must_use]
pub fn line_line(first: Line2, second: Line2, parallel_sine: f64) -> Option<LineCrossing> {
    let (d0, d1) = (first.direction, second.direction);
    let cross = d0.cross(d1);
    let parallel = parallel_sine.max(0.0) * d0.length() * d1.length();
    if cross.is_nan() || cross.abs() <= parallel {
        return None;
    }
    let between = second.point - first.point;
    let along_first = between.cross(d1) / cross;
    let along_second = between.cross(d0) / cross;
    // From the nearer of the two points, because the error grows with the distance.
    let by_first = along_first.abs() * d0.length() <= along_second.abs() * d1.length();
    let point =
        if by_first { first.point + d0 * along_first } else { second.point + d1 * along_second };
    Some(LineCrossing { point, along_first, along_second })
}

/// The intersections of a line and a circle. A line that misses the circle by at most `tolerance` (mm) touches it at the
/// point nearest to the centre.
#[must_use]
pub fn line_circle(line: Line2, circle: Circle2, tolerance: f64) -> Meeting {
    let Some(t) = line.direction.normalized() else { return Meeting::None };
    let to_center = circle.center - line.point;
    // The distance of the centre from the line, and the point of the line nearest to it.
    let left = t.cross(to_center);
    let d = left.abs();
    // Computed from the centre, so that the points are on the circle even if `point` is far away.
    let foot = circle.center - t.turned_left() * left;
    let rho = circle.radius;
    let product = (rho - d) * (rho + d);
    if product > 0.0 {
        let half = product.sqrt();
        Meeting::Cross(foot - t * half, foot + t * half)
    } else if d - rho <= tolerance.max(0.0) {
        Meeting::Touch(foot)
    } else {
        Meeting::None
    }
}

/// The intersections of two circles, by the radical line. Circles that miss each other, from outside or from inside, by
/// at most `tolerance` (mm) touch in the middle of the gap; circles whose centres and radii agree within it are equal.
#[must_use]
pub fn circle_circle(first: Circle2, second: Circle2, tolerance: f64) -> Meeting {
    let tolerance = tolerance.max(0.0);
    let (r0, r1) = (first.radius, second.radius);
    let between = second.center - first.center;
    let distance = between.length();
    if distance <= tolerance && (r0 - r1).abs() <= tolerance {
        return Meeting::Same;
    }
    let Some(t) = between.normalized() else { return Meeting::None };
    // (D + r0 + r1)(D + r0 − r1)(D − r0 + r1)(r0 + r1 − D) is (2·D·h)², with h half the common chord: Heron's product,
    // which is accurate for a small factor, unlike r0² − a².
    let outside = r0 + r1 - distance;
    let inside = distance - (r0 - r1).abs();
    let a = 0.5 * (distance + (r0 - r1) * ((r0 + r1) / distance));
    if outside > 0.0 && inside > 0.0 {
        let heron = (distance + r0 + r1) * inside * (distance + (r0 - r1).abs()) * outside;
        let h = heron.sqrt() / (2.0 * distance);
        let foot = first.center + t * a;
        let left = t.turned_left() * h;
        return Meeting::Cross(foot + left, foot - left);
    }
    if -outside > tolerance || -inside > tolerance || !(outside + inside).is_finite() {
        return Meeting::None;
    }
    // In the middle of the gap, on the line of the centres.
    let along = if outside <= 0.0 {
        0.5 * (r0 + (distance - r1))
    } else if r0 >= r1 {
        0.5 * (r0 + (distance + r1))
    } else {
        -0.5 * (r0 + (r1 - distance))
    };
    Meeting::Touch(first.center + t * along)
}
