//! Computes the curve of an arc command from its ends, its centre or radius, and its direction.

use crate::{Arc, Curve, Plane, Spiral, TurnDirection, Vec2, Vec3, math};

/// The curve of an arc command, with the values for checking it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ArcFit {
    /// Distance from the centre to the start in the plane, mm.
    pub radius_start: f64,
    /// Distance from the centre to the end in the plane, mm.
    pub radius_end: f64,
    /// The angle of the arc, rad, positive counter-clockwise.
    pub sweep: f64,
    /// The curve: an arc if the radii agree, otherwise a spiral.
    pub curve: Curve,
}

impl ArcFit {
    /// End radius minus start radius, mm.
    #[must_use]
    pub fn radius_error(&self) -> f64 {
        self.radius_end - self.radius_start
    }
}

/// The radii of an arc command and its angle, without a curve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ArcSweep {
    /// Distance from the centre to the start in the plane, mm.
    pub radius_start: f64,
    /// Distance from the centre to the end in the plane, mm.
    pub radius_end: f64,
    /// The angle of the arc, rad, positive counter-clockwise.
    pub sweep: f64,
}

impl ArcSweep {
    /// End radius minus start radius, mm.
    #[must_use]
    pub fn radius_error(&self) -> f64 {
        self.radius_end - self.radius_start
    }
}

/// The radii and the angle of [`arc_from_center`] without the curve.
#[inline]
#[must_use]
pub fn arc_sweep(
    plane: Plane,
    start: Vec3,
    end: Vec3,
    center: (f64, f64),
    direction: TurnDirection,
    extra_turns: u32,
) -> ArcSweep {
    let ends = ArcEnds::new(plane, start, end, center);
    let sweep = ends.sweep(direction, extra_turns);
    ArcSweep { radius_start: ends.radius_start, radius_end: ends.radius_end, sweep }
}

/// The curve from `start` to `end` (mm) about `center` (mm, in the two coordinates of the plane).
///
/// The sweep is in `(0, 2π]` in the direction `direction`, plus `extra_turns` full turns. If the end is on the ray from
/// the centre through the start, for example equal to the start, it is therefore a full turn. If the centre is known to
/// a few digits only, an end close to that ray can be on the wrong side of it because of rounding: then the sweep is
/// almost zero instead of almost a full turn, or the reverse.
///
/// The height along the normal is linear in the angle. If the radii differ by at most `radius_tolerance` (mm), the
/// curve is an [`Arc`] with the radius of the start, and its end is off the circle by that difference; this is for
/// differences from rounding, where such a gap does not matter. Otherwise the curve is a [`Spiral`], which is always
/// continuous.
///
/// ```
/// use chordal_geometry::{arc_from_center, Curve, TurnDirection, ParamCurve, Plane, Vec3};
///
/// let (start, end) = (Vec3::new(10.0, 0.0, 0.0), Vec3::new(0.0, 10.0, 0.0));
/// let fit = arc_from_center(Plane::Xy, start, end, (0.0, 0.0), TurnDirection::Ccw, 0, 1e-9);
/// assert!(matches!(fit.curve, Curve::Arc(_)));
/// assert_eq!(fit.curve.length(), 5.0 * core::f64::consts::PI);
/// ```
#[must_use]
pub fn arc_from_center(
    plane: Plane,
    start: Vec3,
    end: Vec3,
    center: (f64, f64),
    direction: TurnDirection,
    extra_turns: u32,
    radius_tolerance: f64,
) -> ArcFit {
    let ends = ArcEnds::new(plane, start, end, center);
    ends.fit(ends.sweep(direction, extra_turns), radius_tolerance)
}

impl Arc {
    /// The same as [`arc_from_center`].
    #[must_use]
    pub fn from_center(
        plane: Plane,
        start: Vec3,
        end: Vec3,
        center: (f64, f64),
        direction: TurnDirection,
        extra_turns: u32,
        radius_tolerance: f64,
    ) -> ArcFit {
        arc_from_center(plane, start, end, center, direction, extra_turns, radius_tolerance)
    }
}

/// The curve from `start` to `end` (mm) about `center` (mm, in plane coordinates) with the programmed sweep: `sweep`
/// radians, positive counter-clockwise, of any size.
///
/// The ends and the centre already determine the angle up to full turns. The result has the angle closest to `sweep` that
/// leads from the start to the end, so the curve is continuous even if `sweep` is rounded coarsely. The difference to
/// [`ArcFit::sweep`] shows how much the two disagree.
/// `radius_tolerance` (mm) is that of [`arc_from_center`].
#[inline]
#[must_use]
pub fn spiral_from_center(
    plane: Plane,
    start: Vec3,
    end: Vec3,
    center: (f64, f64),
    sweep: f64,
    radius_tolerance: f64,
) -> ArcFit {
    let ends = ArcEnds::new(plane, start, end, center);
    let fixed = if ends.radius_start > 0.0 && ends.radius_end > 0.0 {
        let angle = math::atan2(ends.from.cross(ends.to), ends.from.dot(ends.to));
        angle + math::TAU * ((sweep - angle) / math::TAU).round()
    } else {
        // An end in the centre has no direction to compare with.
        sweep
    };
    ends.fit(fixed, radius_tolerance)
}

/// Start and end relative to the centre.
struct ArcEnds {
    plane: Plane,
    start: Vec3,
    end: Vec3,
    center: Vec2,
    from: Vec2,
    to: Vec2,
    radius_start: f64,
    radius_end: f64,
}

impl ArcEnds {
    #[inline]
    fn new(plane: Plane, start: Vec3, end: Vec3, center: (f64, f64)) -> Self {
        let center = Vec2::from(center);
        let from = plane.project(start) - center;
        let to = plane.project(end) - center;
        let (radius_start, radius_end) = (from.length(), to.length());
        Self { plane, start, end, center, from, to, radius_start, radius_end }
    }

    /// The angle from the start to the end in a direction, plus full turns, rad.
    #[inline]
    fn sweep(&self, direction: TurnDirection, extra_turns: u32) -> f64 {
        let sign = direction.sign();
        // The multiplication by ±1 is exact. For coinciding ends both products in the cross product are equal, so its
        // zero is exact as well and needs no special case.
        let angle = math::atan2(sign * self.from.cross(self.to), self.from.dot(self.to));
        let directed = if angle <= 0.0 { angle + math::TAU } else { angle };
        sign * (directed + f64::from(extra_turns) * math::TAU)
    }

    #[inline]
    fn fit(&self, sweep: f64, radius_tolerance: f64) -> ArcFit {
        let &Self { plane, start, end, radius_start, radius_end, .. } = self;
        let height = plane.height(start);
        let center = plane.point(self.center, height);
        let u = plane.point(self.start_direction(sweep), 0.0);
        let w = plane.normal();
        let rise = plane.height(end) - height;
        let curve = if (radius_end - radius_start).abs() <= radius_tolerance {
            Curve::Arc(Arc { center, u, w, radius: radius_start, sweep, rise, start, end })
        } else {
            Curve::Spiral(Spiral {
                center,
                u,
                w,
                radius_start,
                radius_end,
                sweep,
                rise,
                start,
                end,
            })
        };
        ArcFit { radius_start, radius_end, sweep, curve }
    }

    /// Unit vector from the centre to the start. For a start in the centre it is the direction from which the sweep
    /// leads to the end.
    fn start_direction(&self, sweep: f64) -> Vec2 {
        if self.radius_start > 0.0 {
            return self.from * (1.0 / self.radius_start);
        }
        if self.radius_end > 0.0 {
            let to = self.to * (1.0 / self.radius_end);
            let (sin, cos) = math::sin_cos(sweep);
            return Vec2::new(to.a * cos + to.b * sin, to.b * cos - to.a * sin);
        }
        Vec2::new(1.0, 0.0)
    }
}

/// Why a radius does not give a centre.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum RadiusError {
    /// Start and end coincide in the plane: every centre at that distance is possible.
    FullCircle,
    /// The radius is too small to reach from start to end.
    TooShort {
        /// Distance between start and end in the plane, mm.
        chord: f64,
        /// The radius without its sign, mm.
        radius: f64,
        /// By how much the radius falls short of half the chord, mm.
        short_by: f64,
    },
    /// A coordinate or the radius is NaN or infinite.
    NotFinite,
}

impl core::fmt::Display for RadiusError {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        match self {
            RadiusError::FullCircle => {
                f.write_str("start and end coincide: a radius does not determine the centre")
            }
            RadiusError::TooShort { chord, radius, short_by } => {
                write!(
                    f,
                    "radius {radius} is too short by {short_by}: start and end are {chord} apart"
                )
            }
            RadiusError::NotFinite => f.write_str("a coordinate or the radius is not finite"),
        }
    }
}

impl core::error::Error for RadiusError {}

/// By how much twice the radius may differ from the chord of a half circle, mm.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct HalfCircleTolerance {
    /// By how much it may be shorter. Without this tolerance such an arc would not reach its end.
    pub too_short_mm: f64,
    /// By how much it may be longer; 0 if the centre of such an arc is computed.
    pub too_long_mm: f64,
}

impl HalfCircleTolerance {
    /// The same tolerance in both directions, mm.
    pub const fn either(mm: f64) -> HalfCircleTolerance {
        HalfCircleTolerance { too_short_mm: mm, too_long_mm: mm }
    }

    /// The tolerance in a plane that is scaled by a factor.
    #[must_use]
    pub fn scaled(self, factor: f64) -> HalfCircleTolerance {
        HalfCircleTolerance {
            too_short_mm: self.too_short_mm * factor,
            too_long_mm: self.too_long_mm * factor,
        }
    }
}

/// The centre (mm, in plane coordinates) of the arc from `start` to `end` with a signed radius, mm:
/// positive for the arc of at most half a turn, negative for the one of more.
///
/// If twice the radius and the chord differ by no more than `tolerance`, the centre is the midpoint of the chord, because
/// the arc is probably a half circle with a rounded radius.
///
/// # Errors
/// See [`RadiusError`].
pub fn center_from_radius(
    plane: Plane,
    start: Vec3,
    end: Vec3,
    radius: f64,
    direction: TurnDirection,
    tolerance: HalfCircleTolerance,
) -> Result<(f64, f64), RadiusError> {
    let from = plane.project(start);
    let along = plane.project(end) - from;
    let chord = along.length();
    let size = radius.abs();
    if !(chord.is_finite() && size.is_finite()) {
        return Err(RadiusError::NotFinite);
    }
    if chord == 0.0 {
        return Err(RadiusError::FullCircle);
    }
    let half = 0.5 * chord;
    let middle = from + along * 0.5;
    let excess = 2.0 * size - chord;
    let near = if excess < 0.0 { tolerance.too_short_mm } else { tolerance.too_long_mm };
    if excess.abs() <= near {
        return Ok(middle.into());
    }
    if size < half {
        return Err(RadiusError::TooShort { chord, radius: size, short_by: half - size });
    }
    // As a product, because the difference of squares would lose half the digits near a half circle.
    let height = ((size - half) * (size + half)).sqrt();
    let side = if radius < 0.0 { -direction.sign() } else { direction.sign() };
    Ok((middle + along.turned_left() * (side * height / chord)).into())
}
