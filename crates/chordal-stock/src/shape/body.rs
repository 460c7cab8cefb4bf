//! A body of revolution about a vertical axis: a stack of cylinders and cones above a tip.

use chordal_geometry::{Aabb, Vec3};
use libm::{acos, asin, cos, sincos};

use super::convex::ConvexBody;
use crate::cutter::{CutterProfile, Ring, RingElement};

/// A cylinder or a truncated cone about the axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frustum {
    /// Its lower end above the tip, mm.
    pub from: f64,
    /// Its upper end above the tip, mm.
    pub to: f64,
    /// Its radius at the lower end, mm.
    pub lower: f64,
    /// Its radius at the upper end, mm.
    pub upper: f64,
}

/// Why parts do not form a body.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum BodyError {
    /// There is no part.
    #[error("a body needs a part")]
    Empty,
    /// A part has a number that is not finite or a negative radius, or its end is not above its start.
    #[error("part {part} of the body runs from {} to {} mm with radii {} and {} mm",
        .frustum.from, .frustum.to, .frustum.lower, .frustum.upper)]
    Part {
        /// The part, from zero.
        part: usize,
        /// Its dimensions.
        frustum: Frustum,
    },
    /// A tolerance that is not above zero, or an upper end that is not above the cutter's profile.
    #[error("a cutter cannot become a body up to {top} mm within {tolerance} mm")]
    Cutter {
        /// The upper end, mm above the tip.
        top: f64,
        /// The tolerance, mm.
        tolerance: f64,
    },
}

/// On which side of the exact shape an approximation lies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BodyBound {
    /// It contains the exact shape.
    Outer,
    /// The exact shape contains it.
    Inner,
}

/// Frustums above a tip: a tool, a shank, a holder, or all of them.
#[derive(Clone, Debug, PartialEq)]
pub struct RoundBody {
    frustums: Vec<Frustum>,
}

impl RoundBody {
    /// The body of these parts, which may overlap and leave gaps.
    ///
    /// # Errors
    /// When there is no part, or one has no height or a radius below zero.
    pub fn new(frustums: Vec<Frustum>) -> Result<RoundBody, BodyError> {
        if frustums.is_empty() {
            return Err(BodyError::Empty);
        }
        for (part, &frustum) in frustums.iter().enumerate() {
            let Frustum { from, to, lower, upper } = frustum;
            let finite = [from, to, lower, upper].into_iter().all(f64::is_finite);
            if !(finite && from < to && lower >= 0.0 && upper >= 0.0) {
                return Err(BodyError::Part { part, frustum });
            }
        }
        Ok(RoundBody { frustums })
    }

    /// A cutter from its tip up to a height above it, mm. Rounded parts become cones within `tolerance` (mm) of them,
    /// outside or inside; everything else is exact.
    ///
    /// # Errors When `top` is not above the cutter's profile, or the tolerance is not above zero.
    pub fn of_cutter(
        cutter: &CutterProfile,
        top: f64,
        tolerance: f64,
        bound: BodyBound,
    ) -> Result<RoundBody, BodyError> {
        let good = top.is_finite() && top > cutter.side() && tolerance > 0.0;
        if !good {
            return Err(BodyError::Cutter { top, tolerance });
        }
        let mut outline = BodyOutline { frustums: Vec::new(), at: [0.0, 0.0] };
        for ring in cutter.rings() {
            outline.to([ring.from, ring.height_at(ring.from)]);
            match ring.element {
                RingElement::Torus { height, round, middle } => {
                    outline.round(ring, [middle, height + round], round, tolerance, bound);
                }
                RingElement::Disc { .. } | RingElement::Cone { .. } => {}
            }
            outline.to([ring.to, ring.height_at(ring.to)]);
        }
        outline.to([cutter.radius(), top]);
        RoundBody::new(outline.frustums)
    }

    /// Its parts.
    pub fn frustums(&self) -> &[Frustum] {
        &self.frustums
    }

    /// This body and another one about the same axis and tip.
    #[must_use]
    pub fn and(mut self, other: &RoundBody) -> RoundBody {
        self.frustums.extend_from_slice(&other.frustums);
        self
    }

    /// The largest radius, mm.
    pub fn radius(&self) -> f64 {
        self.frustums.iter().fold(0.0, |most, part| part.lower.max(part.upper).max(most))
    }
}

/// An outline that is traced outwards and upwards, and the frustums that it makes.
struct BodyOutline {
    frustums: Vec<Frustum>,
    /// Distance from the axis and height, mm.
    at: [f64; 2],
}

impl BodyOutline {
    fn to(&mut self, [radius, height]: [f64; 2]) {
        let [lower, from] = self.at;
        if height > from {
            self.frustums.push(Frustum { from, to: height, lower, upper: radius });
        }
        self.at = [radius, height.max(from)];
    }

    /// Traces the arc of a ring as chords (inside) or tangents (outside).
    fn round(
        &mut self,
        ring: &Ring,
        [x, z]: [f64; 2],
        round: f64,
        tolerance: f64,
        bound: BodyBound,
    ) {
        /// More sides than any tolerance of a tool needs.
        const MAX_SIDES: f64 = 1000.0;
        let [first, last] =
            [ring.from, ring.to].map(|radius| asin(((radius - x) / round).clamp(-1.0, 1.0)));
        // The middle of a chord is at r·cos, a corner of tangents at r/cos of half the angle.
        let cosine = match bound {
            BodyBound::Inner => 1.0 - tolerance / round,
            BodyBound::Outer => round / (round + tolerance),
        };
        let step = 2.0 * acos(cosine.max(0.0));
        let sides = ((last - first) / step).ceil().clamp(1.0, MAX_SIDES);
        let angle = (last - first) / sides;
        let (reach, offset, count) = match bound {
            BodyBound::Inner => (round, 1.0, sides as usize - 1),
            BodyBound::Outer => (round / cos(angle / 2.0), 0.5, sides as usize),
        };
        for side in 0..count {
            let (sin, cos) = sincos(first + (side as f64 + offset) * angle);
            self.to([x + reach * sin, z - reach * cos]);
        }
    }
}

/// The volume swept by a part of a body on a straight path, which is convex, too.
#[derive(Clone, Copy, Debug)]
pub(super) struct SweptFrustum {
    pub frustum: Frustum,
    pub from: Vec3,
    pub to: Vec3,
}

impl SweptFrustum {
    pub(super) fn bounds(&self) -> Aabb {
        let Frustum { from, to, lower, upper } = self.frustum;
        let radius = lower.max(upper);
        let path = Aabb::of_points(self.from, self.to);
        Aabb {
            min: path.min + Vec3::new(-radius, -radius, from),
            max: path.max + Vec3::new(radius, radius, to),
        }
    }
}

impl ConvexBody for SweptFrustum {
    fn furthest(&self, path: Vec3) -> Vec3 {
        let Frustum { from, to, lower, upper } = self.frustum;
        let plan = (path.x * path.x + path.y * path.y).sqrt();
        let higher = upper * plan + to * path.z > lower * plan + from * path.z;
        let (radius, height) = if higher { (upper, to) } else { (lower, from) };
        let tip = if (self.to - self.from).dot(path) > 0.0 { self.to } else { self.from };
        let out = if plan > 0.0 { radius / plan } else { 0.0 };
        tip + Vec3::new(path.x * out, path.y * out, height)
    }
}
