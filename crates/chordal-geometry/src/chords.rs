//! Polylines within a tolerance of a curve, corner by corner.
//!
//! | curve | spacing | step |
//! |---|---|---|
//! | line | one chord | |
//! | arc, helix, inscribed | even | 2·acos(1 − e/R) |
//! | arc, helix, rounded down | even | 2·√(e·(2R − e))/R, the number of them rounded down |
//! | arc, helix, balanced | even but for the two ends | 2·acos((R − e)/(R + e)) |
//! | spiral, cone | closer where the curvature is larger | √(8e/√(r² + 4b²)), b = dr/dφ |
//! | span of a spline | even in its parameter | by its control points |
//!
//! *Balanced* corners lie `e` outside the circle and chord middles up to `e` inside. The two ends
//! stay on the curve, for a full circle as well, and each end chord spans
//! acos((R − e)/R) + acos((R − e)/(R + e)). A full circle of R 10 mm within 1 µm thus takes
//! 2 + ⌈(2π − 0.06828)/0.0400⌉ = 158 chords where inscribed ones are 223, a quarter 40 and 56.
//! Where the chords do not fill the sweep exactly, they are shortened together and the corners move
//! inward with the error that is left.
//!
//! A helix has its corners over those of the circle it is seen as from above: a chord and the helix
//! at the same share of its step have the same height, so they differ by no more than chord and
//! circle do at that share. For a chord that is symmetric about its middle this is the deviation of
//! the circle; for a balanced end chord it is up to e/R·15.3 % more, which is allowed for.
//!
//! A chord over the step δt of a curve p(t) deviates by at most δt²/8·max|p''|. On a spiral
//! |p''| = Θ²√(r² + 4b²) is convex in r, so the straight line between its end values bounds it; that
//! makes the spacing a closed form and every corner reachable without the ones before. Corners of
//! spirals lie on the curve in either placement.

use crate::bezier::Bezier;
use crate::winding::Winding;
use crate::{Vec3, math};

/// Where the corners of the chords lie.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Placement {
    /// On the curve; the chords of a circle lie inside it.
    #[default]
    Inscribed,
    /// The tolerance outside the circle, the middles of the chords inside by the same; √2 fewer
    /// chords. On spirals and splines the same as inscribed.
    Balanced,
    /// On the curve, and no more chords of a circle than steps of the tolerance fit in whole, but one: they may be a
    /// little farther off. The control units of small machines cut arcs so (GRBL). On spirals and splines the same as
    /// inscribed.
    RoundedDown,
}

impl Placement {
    /// The word of files.
    #[must_use]
    pub const fn as_str(self) -> &'static str {
        match self {
            Placement::Inscribed => "inscribed",
            Placement::Balanced => "balanced",
            Placement::RoundedDown => "rounded-down",
        }
    }
}

/// The most chords one curve is cut into: 2⁴⁰. At a nanometre each that is a kilometre.
pub const MAX_CHORDS: u64 = 1 << 40;

/// Why a curve was not cut into chords.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ChordError {
    /// The tolerance is zero, negative or NaN.
    Tolerance(f64),
    /// A number of the curve is NaN or infinite.
    NotFinite,
    /// More than [`MAX_CHORDS`] chords would be needed; about so many.
    TooMany(f64),
}

impl core::fmt::Display for ChordError {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        match self {
            ChordError::Tolerance(e) => write!(f, "a chord tolerance of {e} is not above zero"),
            ChordError::NotFinite => f.write_str("the curve is not finite"),
            ChordError::TooMany(n) => {
                write!(f, "about {n:.3e} chords would be needed; the limit is {MAX_CHORDS}")
            }
        }
    }
}

impl core::error::Error for ChordError {}

/// The corners of a polyline along a curve, from its start to its end; both are given exactly.
///
/// One more point than chords. A tolerance above half the radius (a third, balanced) counts as
/// that, so there are at least three chords to a turn; an infinite one asks for just those. On a
/// spiral the limit grows with the distance from the axis. A sweep that fits a number of chords to
/// within rounding takes that number.
#[derive(Clone, Debug)]
pub struct Chords {
    spacing: ChordSpacing,
    start: Vec3,
    end: Vec3,
    count: u64,
    next: u64,
}

#[derive(Clone, Debug)]
#[allow(clippy::large_enum_variant, reason = "one for each curve, never kept in numbers")]
enum ChordSpacing {
    Ends,
    Even(Winding),
    Balanced {
        winding: Winding,
        /// Fraction of the sweep that each end chord spans.
        end_span: f64,
        /// How far the corners lie outside, mm.
        outward: f64,
    },
    Graded {
        winding: Winding,
        grading: GradedSpacing,
    },
    Parameter(Bezier),
}

impl Chords {
    /// How many chords there are.
    #[must_use]
    pub const fn chord_count(&self) -> u64 {
        self.count
    }

    /// How far the chords of an arc are from it where all of them span the same angle with their ends on it, mm; `None`
    /// for others.
    #[must_use]
    pub fn sagitta(&self) -> Option<f64> {
        let ChordSpacing::Even(winding) = &self.spacing else { return None };
        let (half, _) = math::sin_cos(0.25 * winding.theta / self.count as f64);
        Some(2.0 * winding.r0 * half * half)
    }

    /// Corner number `index`, mm: the start at 0, the end from `chord_count()` on.
    #[must_use]
    pub fn corner(&self, index: u64) -> Vec3 {
        if index == 0 {
            return self.start;
        }
        if index >= self.count {
            return self.end;
        }
        let share = index as f64 / self.count as f64;
        match &self.spacing {
            ChordSpacing::Ends => self.end,
            ChordSpacing::Even(winding) => winding.point(share),
            ChordSpacing::Balanced { winding, end_span, outward } => {
                let inner = self.count - 2;
                let t = if inner == 0 {
                    0.5
                } else {
                    let part = (index - 1) as f64 / inner as f64;
                    *end_span + (1.0 - 2.0 * *end_span) * part
                };
                winding.point_outside(t, *outward)
            }
            ChordSpacing::Graded { winding, grading } => winding.point(grading.fraction(share)),
            ChordSpacing::Parameter(span) => span.jet(share)[0],
        }
    }

    pub(crate) fn straight(start: Vec3, end: Vec3, tolerance: f64) -> Result<Self, ChordError> {
        check_tolerance(tolerance)?;
        if !(start.is_finite() && end.is_finite()) {
            return Err(ChordError::NotFinite);
        }
        Ok(Self { spacing: ChordSpacing::Ends, start, end, count: 1, next: 0 })
    }

    pub(crate) fn around(
        winding: Winding,
        start: Vec3,
        end: Vec3,
        tolerance: f64,
        placement: Placement,
    ) -> Result<Self, ChordError> {
        let straight = Self::straight(start, end, tolerance)?;
        let w = &winding;
        if !(w.length().is_finite() && w.center.is_finite() && w.u.is_finite()) {
            return Err(ChordError::NotFinite);
        }
        if w.theta == 0.0 || (w.r0 == 0.0 && w.dr == 0.0) {
            return Ok(straight);
        }
        let (spacing, count) = if w.dr != 0.0 {
            graded(winding, tolerance)?
        } else {
            match placement {
                Placement::Inscribed => {
                    (ChordSpacing::Even(winding), inscribed_count(w, tolerance)?)
                }
                Placement::Balanced => balanced(winding, tolerance)?,
                Placement::RoundedDown => {
                    (ChordSpacing::Even(winding), rounded_down(w, tolerance)?)
                }
            }
        };
        Ok(Self { spacing, count, ..straight })
    }

    /// Along a span of a spline, in so many steps of equal parameter.
    pub(crate) fn along(
        span: Bezier,
        end: Vec3,
        steps: f64,
        tolerance: f64,
    ) -> Result<Self, ChordError> {
        let straight = Self::straight(span.start, end, tolerance)?;
        let is_finite = span.points[..span.order].iter().all(|point| point.point.is_finite());
        if !is_finite {
            return Err(ChordError::NotFinite);
        }
        Ok(Self { spacing: ChordSpacing::Parameter(span), count: whole(steps)?, ..straight })
    }
}

impl Iterator for Chords {
    type Item = Vec3;

    fn next(&mut self) -> Option<Vec3> {
        if self.next > self.count {
            return None;
        }
        let p = self.corner(self.next);
        self.next += 1;
        Some(p)
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        let left = (self.count + 1).saturating_sub(self.next);
        (usize::try_from(left).unwrap_or(usize::MAX), usize::try_from(left).ok())
    }

    fn nth(&mut self, n: usize) -> Option<Vec3> {
        self.next = self.next.saturating_add(n as u64).min(self.count + 1);
        self.next()
    }
}

impl core::iter::FusedIterator for Chords {}

fn check_tolerance(tolerance: f64) -> Result<(), ChordError> {
    if tolerance > 0.0 { Ok(()) } else { Err(ChordError::Tolerance(tolerance)) }
}

/// Rounded up, but a whole number that rounding has lifted by a hair stays itself.
fn whole(chords: f64) -> Result<u64, ChordError> {
    if chords.is_nan() || chords > MAX_CHORDS as f64 {
        return Err(ChordError::TooMany(chords));
    }
    Ok((chords - chords * 4.0 * f64::EPSILON).ceil().max(1.0) as u64)
}

/// acos(1 − e/R), in the form that keeps its digits when e is small.
fn half_step_inscribed(ratio: f64) -> f64 {
    2.0 * math::asin((0.5 * ratio).sqrt())
}

/// acos((R − e)/(R + e)), likewise.
fn half_step_balanced(ratio: f64) -> f64 {
    2.0 * math::atan(ratio.sqrt())
}

fn inscribed_count(w: &Winding, tolerance: f64) -> Result<u64, ChordError> {
    // Half the radius: steps of a third of a turn.
    let ratio = (tolerance / w.r0).min(0.5);
    whole(w.theta / (2.0 * half_step_inscribed(ratio)))
}

fn rounded_down(w: &Winding, tolerance: f64) -> Result<u64, ChordError> {
    whole(chords_in_whole(w.r0, w.theta, tolerance).max(1.0))
}

/// How many chords of a tolerance fit in an arc in whole, by its radius and its angle in rad, neither negative; zero
/// where the circle has none. The chord is taken for the step, as the control units do that round down
/// ([`Placement::RoundedDown`]).
#[must_use]
pub fn chords_in_whole(radius: f64, angle: f64, tolerance: f64) -> f64 {
    let half_chord = (tolerance * (2.0 * radius - tolerance)).max(0.0).sqrt();
    if half_chord > 0.0 { (0.5 * angle * radius / half_chord).floor() } else { 0.0 }
}

fn balanced(winding: Winding, tolerance: f64) -> Result<(ChordSpacing, u64), ChordError> {
    let theta = winding.theta;
    // A third of the radius: steps of a third of a turn.
    let ratio = (tolerance / winding.r0).min(1.0 / 3.0);
    // The end chords of a helix; the factor's largest value, 0.1525, is the limit for small ratios.
    let ratio = if winding.rise == 0.0 { ratio } else { ratio / (1.0 + 0.153 * ratio) };
    let spans = |ratio: f64| {
        let step = half_step_balanced(ratio);
        (half_step_inscribed(ratio) + step, 2.0 * step)
    };
    let (end, step) = spans(ratio);
    if theta <= 2.0 * half_step_inscribed(ratio) {
        return Ok((ChordSpacing::Ends, 1));
    }
    let inner = if theta <= 2.0 * end { 0 } else { whole((theta - 2.0 * end) / step)? };
    let count = inner + 2;
    let reach = |end: f64, step: f64| 2.0 * end + inner as f64 * step;
    // Spans grow with the square root of the tolerance, or a little slower, so this smaller
    // tolerance still fills the sweep; what it overfills is taken from all spans alike.
    let shrink = (theta / reach(end, step)).min(1.0);
    let left = ratio * shrink * shrink;
    let (end, step) = spans(left);
    let end_span = end / reach(end, step);
    Ok((ChordSpacing::Balanced { winding, end_span, outward: left * winding.r0 }, count))
}

/// Corners at equal shares of ∫√Q dt, Q running evenly from `Q(0)` to `Q(0)·(1 + growth)`.
#[derive(Clone, Debug)]
struct GradedSpacing {
    growth: f64,
    /// (1 + growth)^(3/2) − 1.
    reach: f64,
}

impl GradedSpacing {
    fn new(growth: f64) -> Self {
        Self { growth, reach: math::exp_m1(1.5 * math::ln_1p(growth)) }
    }

    /// ∫√Q dt over the whole curve, relative to √Q(0).
    fn integral(&self) -> f64 {
        if self.growth == 0.0 { 1.0 } else { self.reach / (1.5 * self.growth) }
    }

    fn fraction(&self, share: f64) -> f64 {
        if self.growth == 0.0 {
            return share;
        }
        let grown = math::exp_m1(math::ln_1p(share * self.reach) / 1.5);
        (grown / self.growth).clamp(0.0, 1.0)
    }
}

fn graded(winding: Winding, tolerance: f64) -> Result<(ChordSpacing, u64), ChordError> {
    let w = &winding;
    // Growth of the radius for each radian.
    let b = (w.dr / w.theta).abs();
    let bend = |r: f64| (r * r + 4.0 * b * b).sqrt();
    let (q0, q1) = (bend(w.r0), bend(w.r0 + w.dr));
    let largest = q0.max(q1);
    // Beyond this the least of steps below already holds the whole curve.
    let e = tolerance.min(largest);
    // Keeps every step below a third of a turn, however near to the axis.
    const MAX_CHORD_ANGLE_RAD: f64 = math::TAU / 3.0;
    let floor = 8.0 * e / (MAX_CHORD_ANGLE_RAD * MAX_CHORD_ANGLE_RAD);
    let least = q0.min(q1) + floor;
    // What Q can grow by within a step, b for each radian: with that added, the value at one end of
    // a step covers the other end as well.
    let growth = b * (8.0 * e / least).sqrt();
    let (q0, q1) = (q0 + floor + growth, q1 + floor + growth);
    let grading = GradedSpacing::new((q1 - q0) / q0);
    let count = w.theta * q0.sqrt() * grading.integral() / (8.0 * e).sqrt();
    let count = whole(count)?;
    Ok((ChordSpacing::Graded { winding, grading }, count))
}
