//! The Archimedean spiral and its counterpart on a cone.

use crate::winding::Winding;
use crate::{
    Aabb, ChordError, Chords, Frame, Nearest, ParamCurve, Placement, Transform, TurnDirection, Vec3,
};

/// An Archimedean spiral in any plane or, if `rise` is not zero, the curve above it on a cone; of any number of turns.
///
/// Between its ends the curve is `center + r·(u cos φ + v sin φ) + rise·(φ/sweep)·w` with `v = w × u`, φ from 0 to
/// `sweep` and the radius `r` linear in φ from `radius_start` to `radius_end`. With a sweep of zero it is the straight
/// line between its ends. The ends are stored as they were passed in; they may differ from the formula by rounding.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spiral {
    /// Centre at the height of the start, mm.
    pub center: Vec3,
    /// Unit vector from the centre towards the start.
    pub u: Vec3,
    /// Unit vector of the axis.
    pub w: Vec3,
    /// Radius at the start, mm, not negative.
    pub radius_start: f64,
    /// Radius at the end, mm, not negative.
    pub radius_end: f64,
    /// Angle travelled about `w`, radians: positive counter-clockwise, of any size.
    pub sweep: f64,
    /// Movement along `w` over the whole sweep, mm.
    pub rise: f64,
    /// The exact start that was passed in, mm.
    pub start: Vec3,
    /// The exact end that was passed in, mm.
    pub end: Vec3,
}

impl Spiral {
    /// The spiral that starts at `radii.0` mm along `frame.u`, turns about `frame.w` by `sweep`
    /// radians to the radius `radii.1` mm and rises by `rise` mm. The ends follow from these.
    #[must_use]
    pub fn new(frame: Frame, radii: (f64, f64), sweep: f64, rise: f64) -> Self {
        let winding = Winding::new(frame.origin, frame.u, frame.w, radii, sweep, rise);
        Self {
            center: frame.origin,
            u: frame.u,
            w: frame.w,
            radius_start: radii.0,
            radius_end: radii.1,
            sweep,
            rise,
            start: winding.point(0.0),
            end: winding.point(1.0),
        }
    }

    /// Angle travelled from the start at `s` mm, radians, with the sign of `sweep`.
    #[must_use]
    pub fn angle_at(&self, s: f64) -> f64 {
        self.sweep * self.winding().fraction_at(s)
    }

    /// Distance from the axis at `s` mm from the start, mm.
    #[must_use]
    pub fn radius_at(&self, s: f64) -> f64 {
        let w = self.winding();
        w.radius(w.fraction_at(s))
    }

    /// The direction of rotation about `w`.
    #[must_use]
    pub fn direction(&self) -> TurnDirection {
        if self.sweep < 0.0 { TurnDirection::Cw } else { TurnDirection::Ccw }
    }

    pub(crate) fn winding(&self) -> Winding {
        let radii = (self.radius_start, self.radius_end);
        Winding::new(self.center, self.u, self.w, radii, self.sweep, self.rise)
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
        let whole = self.winding();
        let p = whole.part(t0, t1);
        Self {
            center: p.center,
            u: p.u,
            w: self.w,
            radius_start: p.r0,
            radius_end: if t1 >= 1.0 { self.radius_end } else { whole.radius(t1) },
            sweep: self.sweep * (t1 - t0),
            rise: p.rise,
            start: self.at_fraction(t0),
            end: self.at_fraction(t1),
        }
    }
}

impl ParamCurve for Spiral {
    fn start(&self) -> Vec3 {
        self.start
    }

    fn end(&self) -> Vec3 {
        self.end
    }

    fn length(&self) -> f64 {
        self.winding().length()
    }

    fn point_at(&self, s: f64) -> Vec3 {
        self.at_fraction(self.winding().fraction_at(s))
    }

    fn tangent_at(&self, s: f64) -> Vec3 {
        let w = self.winding();
        w.intrinsic(w.fraction_at(s)).tangent
    }

    fn curvature_at(&self, s: f64) -> Vec3 {
        let w = self.winding();
        w.intrinsic(w.fraction_at(s)).curvature
    }

    fn curvature_derivative_at(&self, s: f64) -> Vec3 {
        let w = self.winding();
        w.intrinsic(w.fraction_at(s)).curvature_derivative
    }

    fn jet_at(&self, s: f64) -> [Vec3; 4] {
        let winding = self.winding();
        let t = winding.fraction_at(s);
        let (point, derivatives) = winding.jet(t);
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
            w: self.w,
            radius_start: self.radius_end,
            radius_end: self.radius_start,
            sweep: -self.sweep,
            rise: -self.rise,
            start: self.end,
            end: self.start,
        }
    }

    fn split_at(&self, s: f64) -> (Self, Self) {
        let t = self.winding().fraction_at(s);
        (self.part(0.0, t), self.part(t, 1.0))
    }

    fn subsegment(&self, s0: f64, s1: f64) -> Self {
        let w = self.winding();
        let (t0, t1) = (w.fraction_at(s0), w.fraction_at(s1));
        if t1 < t0 { self.part(t1, t0).reversed() } else { self.part(t0, t1) }
    }

    fn transformed(&self, transform: &Transform) -> Self {
        let sense = if transform.is_reflection() { -1.0 } else { 1.0 };
        let scale = transform.scale_factor();
        Self {
            center: transform.apply_point(self.center),
            u: transform.apply_direction(self.u),
            w: transform.apply_direction(self.w),
            radius_start: self.radius_start * scale,
            radius_end: self.radius_end * scale,
            sweep: self.sweep * sense,
            rise: self.rise * scale,
            start: transform.apply_point(self.start),
            end: transform.apply_point(self.end),
        }
    }

    fn nearest(&self, p: Vec3) -> Nearest {
        let w = self.winding();
        let (t, _) = w.nearest_fraction(p);
        let point = self.at_fraction(t);
        Nearest { s: w.length_to(t), point, distance: point.distance(p) }
    }

    fn max_curvature(&self) -> f64 {
        self.winding().max_curvature()
    }

    fn chords(&self, tolerance: f64, placement: Placement) -> Result<Chords, ChordError> {
        Chords::around(self.winding(), self.start, self.end, tolerance, placement)
    }
}
