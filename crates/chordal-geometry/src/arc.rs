//! The circular arc and the helix.

use crate::winding::Winding;
use crate::{
    Aabb, ChordError, Chords, Frame, Nearest, ParamCurve, Placement, Transform, TurnDirection,
    Vec3, math,
};

/// A circular arc in any plane or, when `rise` is not zero, a helix; of any number of turns.
///
/// Between its ends the curve is `center + radius·(u cos φ + v sin φ) + rise·(φ/sweep)·w` with
/// `v = w × u` and φ from 0 to `sweep`. The ends are stored as they were passed in, so that neighbours in a program meet
/// exactly; they may differ from the formula by rounding, or by the difference of radii that the caller accepted as equal
/// (see [`arc_from_center`](crate::arc_from_center)).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Arc {
    /// Centre at the height of the start, mm.
    pub center: Vec3,
    /// Unit vector from the centre towards the start.
    pub u: Vec3,
    /// Unit vector of the axis.
    pub w: Vec3,
    /// Radius, mm, not negative.
    pub radius: f64,
    /// Angle travelled about `w`, radians: positive counter-clockwise, of any size.
    pub sweep: f64,
    /// Movement along `w` over the whole sweep, mm.
    pub rise: f64,
    /// The exact start that was passed in, mm.
    pub start: Vec3,
    /// The exact end that was passed in, mm.
    pub end: Vec3,
}

impl Arc {
    /// The arc that starts at `radius` mm along `frame.u`, turns about `frame.w` by `sweep`
    /// radians and rises by `rise` mm. The ends follow from these.
    #[must_use]
    pub fn new(frame: Frame, radius: f64, sweep: f64, rise: f64) -> Self {
        let winding = Winding::new(frame.origin, frame.u, frame.w, (radius, radius), sweep, rise);
        Self {
            center: frame.origin,
            u: frame.u,
            w: frame.w,
            radius,
            sweep,
            rise,
            start: winding.point(0.0),
            end: winding.point(1.0),
        }
    }

    /// The arc of less than one turn from `start` through `via` to `end`, all mm. `None` if the three are on a line
    /// within rounding, or two of them coincide.
    #[must_use]
    pub fn through(start: Vec3, via: Vec3, end: Vec3) -> Option<Self> {
        let (a, b) = (via - start, end - start);
        let normal = a.cross(b);
        let w = normal.normalized()?;
        let to_center = (b * a.length_squared() - a * b.length_squared()).cross(normal)
            / (2.0 * normal.length_squared());
        let radius = to_center.length();
        let u = (-to_center).normalized()?;
        if !radius.is_finite() {
            return None;
        }
        let to_end = b - to_center;
        let angle = math::atan2(to_end.dot(w.cross(u)), to_end.dot(u));
        let sweep = if angle <= 0.0 { angle + math::TAU } else { angle };
        Some(Self { center: start + to_center, u, w, radius, sweep, rise: 0.0, start, end })
    }

    /// Angle travelled from the start at `s` mm, radians, with the sign of `sweep`.
    #[must_use]
    pub fn angle_at(&self, s: f64) -> f64 {
        self.sweep * self.fraction(s)
    }

    /// Movement along the axis per radian, mm; zero for a plane arc.
    #[must_use]
    pub fn rise_per_radian(&self) -> f64 {
        if self.sweep == 0.0 { 0.0 } else { self.rise / self.sweep }
    }

    /// The direction of rotation about `w`.
    #[must_use]
    pub fn direction(&self) -> TurnDirection {
        if self.sweep < 0.0 { TurnDirection::Cw } else { TurnDirection::Ccw }
    }

    pub(crate) fn winding(&self) -> Winding {
        let radii = (self.radius, self.radius);
        Winding::new(self.center, self.u, self.w, radii, self.sweep, self.rise)
    }

    /// Fraction of the sweep at `s` mm, clamped to 0..=1.
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

    fn at_fraction(&self, t: f64) -> Vec3 {
        if t <= 0.0 {
            self.start
        } else if t >= 1.0 {
            self.end
        } else {
            self.winding().point(t)
        }
    }

    /// The part between two fractions of the sweep, `t0 <= t1`.
    fn part(&self, t0: f64, t1: f64) -> Self {
        let p = self.winding().part(t0, t1);
        Self {
            center: p.center,
            u: p.u,
            w: self.w,
            radius: self.radius,
            sweep: self.sweep * (t1 - t0),
            rise: p.rise,
            start: self.at_fraction(t0),
            end: self.at_fraction(t1),
        }
    }
}

/// The derivatives of an arc at equal steps along it. Each is computed from the one before it by a rotation, which
/// needs no sine. See [`Arc::derivatives_from`].
#[derive(Clone, Copy, Debug)]
pub struct Derivatives {
    /// Unit vectors outward and in the direction of rotation, at the current point.
    out: Vec3,
    along: Vec3,
    /// Sine and cosine of the angle of a step.
    step: (f64, f64),
    /// Sizes of the three derivatives perpendicular to the axis: 1, 1/mm, 1/mm² per length.
    sizes: [f64; 3],
    /// The component of the tangent along the axis.
    rise: Vec3,
}

impl Derivatives {
    /// The unit tangent, the curvature vector (1/mm) and its derivative (1/mm²) at the current point.
    #[must_use]
    pub fn here(&self) -> [Vec3; 3] {
        let [first, second, third] = self.sizes;
        [self.along * first + self.rise, self.out * -second, self.along * -third]
    }

    /// One of the components X, Y and Z of the three derivatives, at the current point and the steps after it: `N`
    /// points.
    #[must_use]
    pub fn of_axis<const N: usize>(&self, axis: usize) -> [[f64; N]; 3] {
        let ((sin, cos), [first, second, third]) = (self.step, self.sizes);
        let (mut out, mut along) = (self.out.component(axis), self.along.component(axis));
        let rise = self.rise.component(axis);
        let mut places = [[0.0; N]; 3];
        let [firsts, seconds, thirds] = &mut places;
        for ((to_first, to_second), to_third) in firsts.iter_mut().zip(seconds).zip(thirds) {
            *to_first = along * first + rise;
            *to_second = out * -second;
            *to_third = along * -third;
            (out, along) = (out * cos + along * sin, along * cos - out * sin);
        }
        places
    }

    /// Moves to the next step.
    pub fn advance(&mut self) {
        let ((sin, cos), out, along) = (self.step, self.out, self.along);
        self.out = out * cos + along * sin;
        self.along = along * cos - out * sin;
    }
}

impl Arc {
    /// The derivatives with respect to length at `s` mm from the start, and after it in steps of `step` mm. Rounding
    /// adds up, so this is for few steps. The points are not limited to the ends; the derivatives of an arc without
    /// length are zero.
    #[must_use]
    pub fn derivatives_from(&self, s: f64, step: f64) -> Derivatives {
        let (winding, length) = (self.winding(), self.length());
        let per_mm = if length == 0.0 { 0.0 } else { 1.0 / length };
        let rate = winding.theta * per_mm;
        let turned = |path: f64| math::sin_cos_of_quarters(path * rate / math::FRAC_PI_2);
        let (sin, cos) = turned(s);
        let first = self.radius * rate;
        Derivatives {
            out: winding.u * cos + winding.v * sin,
            along: winding.v * cos - winding.u * sin,
            step: turned(step),
            sizes: [first, first * rate, first * rate * rate],
            rise: self.w * (self.rise * per_mm),
        }
    }
}

impl ParamCurve for Arc {
    fn start(&self) -> Vec3 {
        self.start
    }

    fn end(&self) -> Vec3 {
        self.end
    }

    fn length(&self) -> f64 {
        let around = self.radius * self.sweep;
        if self.rise == 0.0 {
            around.abs()
        } else {
            (around * around + self.rise * self.rise).sqrt()
        }
    }

    fn point_at(&self, s: f64) -> Vec3 {
        self.at_fraction(self.fraction(s))
    }

    fn tangent_at(&self, s: f64) -> Vec3 {
        self.winding().intrinsic(self.fraction(s)).tangent
    }

    fn curvature_at(&self, s: f64) -> Vec3 {
        self.winding().intrinsic(self.fraction(s)).curvature
    }

    fn curvature_derivative_at(&self, s: f64) -> Vec3 {
        self.winding().intrinsic(self.fraction(s)).curvature_derivative
    }

    fn jet_at(&self, s: f64) -> [Vec3; 4] {
        let t = self.fraction(s);
        let (point, derivatives) = self.winding().jet(t);
        // The exact ends, like `point_at`.
        derivatives.derivatives_after(if t <= 0.0 {
            self.start
        } else if t >= 1.0 {
            self.end
        } else {
            point
        })
    }

    fn bounds(&self) -> Aabb {
        self.winding().interior_bounds().include(self.start).include(self.end)
    }

    fn reversed(&self) -> Self {
        let (u, _) = self.winding().radial(1.0);
        Self {
            center: self.center + self.w * self.rise,
            u,
            sweep: -self.sweep,
            rise: -self.rise,
            start: self.end,
            end: self.start,
            ..*self
        }
    }

    fn split_at(&self, s: f64) -> (Self, Self) {
        let t = self.fraction(s);
        (self.part(0.0, t), self.part(t, 1.0))
    }

    fn subsegment(&self, s0: f64, s1: f64) -> Self {
        let (t0, t1) = (self.fraction(s0), self.fraction(s1));
        if t1 < t0 { self.part(t1, t0).reversed() } else { self.part(t0, t1) }
    }

    fn transformed(&self, transform: &Transform) -> Self {
        let sense = if transform.is_reflection() { -1.0 } else { 1.0 };
        let scale = transform.scale_factor();
        Self {
            center: transform.apply_point(self.center),
            u: transform.apply_direction(self.u),
            w: transform.apply_direction(self.w),
            radius: self.radius * scale,
            sweep: self.sweep * sense,
            rise: self.rise * scale,
            start: transform.apply_point(self.start),
            end: transform.apply_point(self.end),
        }
    }

    fn nearest(&self, p: Vec3) -> Nearest {
        let (t, _) = self.winding().nearest_fraction(p);
        let point = self.at_fraction(t);
        Nearest { s: t * self.length(), point, distance: point.distance(p) }
    }

    fn max_curvature(&self) -> f64 {
        self.winding().max_curvature()
    }

    fn chords(&self, tolerance: f64, placement: Placement) -> Result<Chords, ChordError> {
        Chords::around(self.winding(), self.start, self.end, tolerance, placement)
    }
}
