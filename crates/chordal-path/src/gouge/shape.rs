//! Lines and arcs in the compensation plane.

use core::f64::consts::{FRAC_PI_2, PI, TAU};

use chordal_geometry::Vec2;

/// A line or an arc in the plane of compensation, mm and rad.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum GougeCurve {
    /// A straight line.
    Line {
        /// The start, mm.
        from: Vec2,
        /// The end, mm.
        to: Vec2,
    },
    /// An arc, also of a full turn or more.
    Arc {
        /// Centre, mm.
        center: Vec2,
        /// Radius, mm, not negative.
        radius: f64,
        /// The direction from the centre to the first point, rad.
        start: f64,
        /// The angle from the first point to the last, rad, positive counter-clockwise.
        sweep: f64,
    },
}

/// The unit vector at an angle, rad.
pub(super) fn unit(angle: f64) -> Vec2 {
    let (sin, cos) = libm::sincos(angle);
    Vec2::new(cos, sin)
}

/// The angle of a vector, rad.
pub(super) fn angle_of(v: Vec2) -> f64 {
    libm::atan2(v.b, v.a)
}

/// The same angle in −π..=π, rad.
pub(super) fn wrapped(angle: f64) -> f64 {
    let turned = angle - TAU * libm::round(angle / TAU);
    turned.clamp(-PI, PI)
}

impl GougeCurve {
    /// The line between two points, mm.
    #[must_use]
    pub const fn line(from: Vec2, to: Vec2) -> Self {
        GougeCurve::Line { from, to }
    }

    /// The arc about `center` from one point to another, mm, counter-clockwise or clockwise; a full turn if the points
    /// are equal. The radius is the distance of `from` from the centre.
    #[must_use]
    pub fn arc(center: Vec2, from: Vec2, to: Vec2, counter_clockwise: bool) -> Self {
        let start = angle_of(from - center);
        let raw = angle_of(to - center) - start;
        let path = if counter_clockwise { 1.0 } else { -1.0 };
        let mut turn = raw * path;
        turn -= TAU * libm::floor(turn / TAU);
        // A turn of zero, and a full turn that differs only by rounding, both mean the full circle.
        if from.distance(to) <= 1e-9 || turn <= 0.0 {
            turn = TAU;
        }
        GougeCurve::Arc { center, radius: from.distance(center), start, sweep: path * turn }
    }

    /// The first point, mm.
    #[must_use]
    pub fn from(&self) -> Vec2 {
        self.at(0.0)
    }

    /// The last point, mm.
    #[must_use]
    pub fn to(&self) -> Vec2 {
        self.at(1.0)
    }

    /// The point at a fraction of the length, 0..=1, mm.
    #[must_use]
    pub fn at(&self, fraction: f64) -> Vec2 {
        match *self {
            GougeCurve::Line { from, to } => from * (1.0 - fraction) + to * fraction,
            GougeCurve::Arc { center, radius, start, sweep } => {
                center + unit(start + sweep * fraction) * radius
            }
        }
    }

    /// Length, mm.
    #[must_use]
    pub fn length(&self) -> f64 {
        match *self {
            GougeCurve::Line { from, to } => from.distance(to),
            GougeCurve::Arc { radius, sweep, .. } => radius * sweep.abs(),
        }
    }

    /// The angles of the tangents at both ends, rad, not unwrapped relative to a neighbour; the second is the first
    /// plus the sweep.
    pub(super) fn tangent_angles(&self) -> (f64, f64) {
        match *self {
            GougeCurve::Line { from, to } => {
                let angle = angle_of(to - from);
                (angle, angle)
            }
            GougeCurve::Arc { start, sweep, .. } => {
                let first = start + if sweep < 0.0 { -FRAC_PI_2 } else { FRAC_PI_2 };
                (first, first + sweep)
            }
        }
    }

    /// The same curve in the opposite direction.
    #[must_use]
    pub fn reversed(&self) -> Self {
        match *self {
            GougeCurve::Line { from, to } => GougeCurve::Line { from: to, to: from },
            GougeCurve::Arc { center, radius, start, sweep } => {
                GougeCurve::Arc { center, radius, start: start + sweep, sweep: -sweep }
            }
        }
    }

    /// The piece between two fractions of the length, 0..=1.
    #[must_use]
    pub(super) fn piece(&self, first: f64, last: f64) -> GougeCurve {
        match *self {
            GougeCurve::Line { .. } => GougeCurve::line(self.at(first), self.at(last)),
            GougeCurve::Arc { center, radius, start, sweep } => GougeCurve::Arc {
                center,
                radius,
                start: start + first * sweep,
                sweep: (last - first) * sweep,
            },
        }
    }

    /// The position of a point that is on the curve, as a fraction of the length, 0..=1.
    pub(super) fn fraction(&self, p: Vec2) -> f64 {
        match *self {
            GougeCurve::Line { from, to } => {
                let along = to - from;
                ((p - from).dot(along) / along.dot(along)).clamp(0.0, 1.0)
            }
            GougeCurve::Arc { center, start, sweep, .. } => {
                let turned = (angle_of(p - center) - start) * sweep.signum();
                let turned = turned - TAU * libm::floor(turned / TAU);
                // Because of rounding, the first point may appear to be at a full turn.
                if TAU - turned < 1e-9 { 0.0 } else { (turned / sweep.abs()).min(1.0) }
            }
        }
    }

    /// The distance of a point to the left of the curve extended at both ends along its line or circle, mm.
    pub(super) fn left_of(&self, p: Vec2) -> f64 {
        match *self {
            GougeCurve::Line { from, to } => {
                let along = to - from;
                along.cross(p - from) / along.length()
            }
            GougeCurve::Arc { center, radius, sweep, .. } => {
                (radius - p.distance(center)) * sweep.signum()
            }
        }
    }

    /// Whether all of its numbers are finite.
    #[must_use]
    pub fn is_finite(&self) -> bool {
        match *self {
            GougeCurve::Line { from, to } => {
                (from.a + from.b).is_finite() && (to.a + to.b).is_finite()
            }
            GougeCurve::Arc { center, radius, start, sweep } => {
                (center.a + center.b + radius + start + sweep).is_finite()
            }
        }
    }

    /// The nearest point of the curve to `p`, mm.
    pub(super) fn nearest(&self, p: Vec2) -> Vec2 {
        match *self {
            GougeCurve::Line { from, to } => {
                let along = to - from;
                let square = along.dot(along);
                if square <= 0.0 {
                    return from;
                }
                let t = ((p - from).dot(along) / square).clamp(0.0, 1.0);
                from + along * t
            }
            GougeCurve::Arc { center, radius, start, sweep } => {
                let out = p - center;
                if out.dot(out) > 0.0 && within(start, sweep, angle_of(out)) {
                    return center + out * (radius / out.length());
                }
                let (first, last) = (self.from(), self.to());
                if p.distance(first) <= p.distance(last) { first } else { last }
            }
        }
    }

    /// Whether an arc passes the direction `angle`, rad; false for a line.
    pub(super) fn passes(&self, angle: f64) -> bool {
        match *self {
            GougeCurve::Line { .. } => false,
            GougeCurve::Arc { start, sweep, .. } => within(start, sweep, angle),
        }
    }
}

/// Whether a sweep from the direction `start` passes the direction `angle`, rad.
pub(super) fn within(start: f64, sweep: f64, angle: f64) -> bool {
    let turned = if sweep < 0.0 { start - angle } else { angle - start };
    turned - TAU * libm::floor(turned / TAU) <= sweep.abs()
}
