//! Polylines within a tolerance of a curve, computed corner by corner.
//!
//! | curve | spacing | step |
//! |---|---|---|
//! | line | one chord | |
//! | arc, helix, inscribed | even | 2·acos(1 − e/R) |
//! | arc, helix, rounded down | even | 2·√(e·(2R − e))/R, their number rounded down |
//! | arc, helix, balanced | even but for the two ends | 2·acos((R − e)/(R + e)) |
//! | spiral, cone | closer where the curvature is larger | √(8e/√(r² + 4b²)), b = dr/dφ |
//! | span of a spline | even in its parameter | by its control points |
//!
//! *Balanced* corners are `e` outside the circle and the midpoints of chords up to `e` inside. The two ends are on the
//! curve, also for a full circle, and each end chord spans
//! acos((R − e)/R) + acos((R − e)/(R + e)). A full circle of R 10 mm within 1 µm thus takes
//! 2 + ⌈(2π − 0.06828)/0.0400⌉ = 158 chords instead of 223 inscribed ones, a quarter circle 40 instead of 56.
//! If the chords do not fill the sweep exactly, all are shortened, and the corners move inward because the error gets
//! smaller.
//!
//! The corners of a helix are above those of its projection along the axis, a circle. At the same fraction of a step, a
//! chord and the helix have the same height, so they differ by no more than chord and circle at that fraction. For a
//! chord that is symmetric about its midpoint this is the deviation of the circle; for a balanced end chord it is up to
//! e/R·15.3 % more, which is taken into account.
//!
//! A chord over the step δt of a curve p(t) deviates by at most δt²/8·max|p''|. On a spiral
//! |p''| = Θ²√(r² + 4b²) is convex in r, so the straight line between its end values bounds it. With this bound the
//! spacing has a closed form, and every corner can be computed without those before it. The corners of spirals are on the
//! curve in every placement.

use crate::bezier::Bezier;
use crate::winding::Winding;
use crate::{Vec3, math};

/// Where the corners of the chords are.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Placement {
    /// On the curve; the chords of a circle are inside it.
    #[default]
    Inscribed,
    /// Outside the circle by the tolerance, with the midpoints of the chords inside by the same distance: fewer chords
    /// by a factor of √2. On spirals and splines the same as inscribed.
    Balanced,
    /// On the curve, with the number of chords of a circle rounded down, but at least one, so that they may exceed the
    /// tolerance slightly. Controls of small machines divide arcs like this (GRBL). On spirals and splines the same as
    /// inscribed.
    RoundedDown,
}

impl Placement {
    /// The word for it in machine files.
    #[must_use]
    pub const fn as_str(self) -> &'static str {
        match self {
            Placement::Inscribed => "inscribed",
            Placement::Balanced => "balanced",
            Placement::RoundedDown => "rounded-down",
        }
    }
}

/// The largest number of chords of one curve: 2⁴⁰, a kilometre of chords of one nanometre.
pub const MAX_CHORDS: u64 = 1 << 40;

/// Why a curve cannot be divided into chords.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ChordError {
    /// The tolerance is zero, negative or NaN.
    Tolerance(f64),
    /// A number of the curve is NaN or infinite.
    NotFinite,
    /// More than [`MAX_CHORDS`] chords would be needed: about this many.
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

/// The corners of a polyline along a curve, from its exact start to its exact end.
///
/// There is one more point than chords. The tolerance is limited to half the radius (for balanced chords, a third of it),
/// so that there are at least three chords per turn, also for an infinite tolerance. On a spiral the limit grows with the
/// distance from the axis. If a whole number of chords fits within rounding, that is their number.
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
        /// How far the corners are outside, mm.
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

    /// The deviation of the chords of an arc, mm, if all of them span the same angle and have their ends on the arc;
    /// `None` for other chords.
    #[must_use]
    pub fn sagitta(&self) -> Option<f64> {
        let ChordSpacing::Even(winding) = &self.spacing else { return None };
        let (half, _) = math::sin_cos(0.25 * winding.theta / self.count as f64);
        Some(2.0 * winding.r0 * half * half)
    }

    /// The corner with this index, mm: the start at 0, the end at `chord_count()` and above.
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

    /// The chords along a span of a spline, in steps of equal parameter; `steps` is their number, not yet rounded.
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

/// Rounds up; a value that exceeds a whole number only by rounding gives that number.
fn whole(chords: f64) -> Result<u64, ChordError> {
    if chords.is_nan() || chords > MAX_CHORDS as f64 {
        return Err(ChordError::TooMany(chords));
    }
    Ok((chords - chords * 4.0 * f64::EPSILON).ceil().max(1.0) as u64)
}

/// acos(1 − e/R), in a form that is accurate for small e.
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

/// How many whole chords fit into an arc, from its radius and tolerance, mm, and its angle, rad, which is not negative;
/// zero if the tolerance is too large for a chord. The length of a chord is used instead of that of its arc, as in the
/// controls that round down ([`Placement::RoundedDown`]).
#[must_use]
pub fn chords_in_whole(radius: f64, angle: f64, tolerance: f64) -> f64 {
    let half_chord = (tolerance * (2.0 * radius - tolerance)).max(0.0).sqrt();
    if half_chord > 0.0 { (0.5 * angle * radius / half_chord).floor() } else { 0.0 }
}

fn balanced(winding: Winding, tolerance: f64) -> Result<(ChordSpacing, u64), ChordError> {
    let theta = winding.theta;
    // A third of the radius: steps of a third of a turn.
    let ratio = (tolerance / winding.r0).min(1.0 / 3.0);
    // For the end chords of a helix. The largest value of the factor, 0.1525, is its limit for small ratios.
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
    // Spans grow with the square root of the tolerance or slightly slower, so this smaller tolerance still fills the
    // sweep; the excess is subtracted from all spans in proportion.
    let shrink = (theta / reach(end, step)).min(1.0);
    let left = ratio * shrink * shrink;
    let (end, step) = spans(left);
    let end_span = end / reach(end, step);
    Ok((ChordSpacing::Balanced { winding, end_span, outward: left * winding.r0 }, count))
}

/// Corners at equal fractions of ∫√Q dt, where Q is linear from `Q(0)` to `Q(0)·(1 + growth)`.
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
    // Growth of the radius per radian.
    let b = (w.dr / w.theta).abs();
    let bend = |r: f64| (r * r + 4.0 * b * b).sqrt();
    let (q0, q1) = (bend(w.r0), bend(w.r0 + w.dr));
    let largest = q0.max(q1);
    // For a larger tolerance, the smallest number of steps below already covers the whole curve.
    let e = tolerance.min(largest);
    // Keeps every step below a third of a turn, also close to the axis.
    const MAX_CHORD_ANGLE_RAD: f64 = math::TAU / 3.0;
    let floor = 8.0 * e / (MAX_CHORD_ANGLE_RAD * MAX_CHORD_ANGLE_RAD);
    let least = q0.min(q1) + floor;
    // The largest growth of Q within a step, b per radian: with it added, the value at one end of a step is a bound for
    // the other end as well.
    let growth = b * (8.0 * e / least).sqrt();
    let (q0, q1) = (q0 + floor + growth, q1 + floor + growth);
    let grading = GradedSpacing::new((q1 - q0) / q0);
    let count = w.theta * q0.sqrt() * grading.integral() / (8.0 * e).sqrt();
    let count = whole(count)?;
    Ok((ChordSpacing::Graded { winding, grading }, count))
}
