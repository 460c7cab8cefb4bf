//! The straight line.

use crate::{Aabb, ChordError, Chords, Nearest, ParamCurve, Placement, Transform, Vec3};

/// A straight line between two points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Line {
    /// First point, mm.
    pub start: Vec3,
    /// Last point, mm.
    pub end: Vec3,
}

impl Line {
    /// The line from `start` to `end`, mm.
    #[must_use]
    pub const fn new(start: Vec3, end: Vec3) -> Self {
        Self { start, end }
    }

    /// The point at fraction `t` of the length, mm.
    fn at_fraction(&self, t: f64) -> Vec3 {
        if t <= 0.0 {
            self.start
        } else if t >= 1.0 {
            self.end
        } else {
            self.start.lerp(self.end, t)
        }
    }

    /// Fraction of the length at `s` mm, clamped to 0..=1.
    fn fraction(&self, s: f64) -> f64 {
        let length = self.length();
        if s <= 0.0 {
            0.0
        } else if s >= length {
            1.0
        } else {
            s / length
        }
    }
}

impl ParamCurve for Line {
    fn start(&self) -> Vec3 {
        self.start
    }

    fn end(&self) -> Vec3 {
        self.end
    }

    fn length(&self) -> f64 {
        self.start.distance(self.end)
    }

    fn point_at(&self, s: f64) -> Vec3 {
        self.at_fraction(self.fraction(s))
    }

    fn tangent_at(&self, _s: f64) -> Vec3 {
        (self.end - self.start).normalized().unwrap_or(Vec3::ZERO)
    }

    fn curvature_at(&self, _s: f64) -> Vec3 {
        Vec3::ZERO
    }

    fn curvature_derivative_at(&self, _s: f64) -> Vec3 {
        Vec3::ZERO
    }

    fn jet_at(&self, s: f64) -> [Vec3; 4] {
        [self.point_at(s), self.tangent_at(s), Vec3::ZERO, Vec3::ZERO]
    }

    fn bounds(&self) -> Aabb {
        Aabb::of_points(self.start, self.end)
    }

    fn reversed(&self) -> Self {
        Self { start: self.end, end: self.start }
    }

    fn split_at(&self, s: f64) -> (Self, Self) {
        let middle = self.point_at(s);
        (Self { start: self.start, end: middle }, Self { start: middle, end: self.end })
    }

    fn subsegment(&self, s0: f64, s1: f64) -> Self {
        Self { start: self.point_at(s0), end: self.point_at(s1) }
    }

    fn transformed(&self, transform: &Transform) -> Self {
        Self { start: transform.apply_point(self.start), end: transform.apply_point(self.end) }
    }

    fn nearest(&self, p: Vec3) -> Nearest {
        let along = self.end - self.start;
        let length_squared = along.length_squared();
        let t = if length_squared > 0.0 {
            ((p - self.start).dot(along) / length_squared).clamp(0.0, 1.0)
        } else {
            0.0
        };
        let point = self.at_fraction(t);
        Nearest { s: t * self.length(), point, distance: point.distance(p) }
    }

    fn max_curvature(&self) -> f64 {
        0.0
    }

    fn chords(&self, tolerance: f64, _placement: Placement) -> Result<Chords, ChordError> {
        Chords::straight(self.start, self.end, tolerance)
    }
}
