//! Whether a body that moves keeps clear of a shape, without samples: no place of it comes nearer faster than
//! the tip goes, so the next look is after distance over speed.

use chordal_geometry::Vec3;

use super::SolidShape;
use super::body::RoundBody;
use super::convex::DistanceInterval;

/// A way of a tip, from 0 to 1.
pub struct TipMotion<'a> {
    /// The place of the tip at a fraction, mm.
    pub tip: &'a dyn Fn(f64) -> Vec3,
    /// The most that the tip moves for one unit of the fraction, mm: for a curve at even speed its length.
    pub speed: f64,
}

/// How a body passed a shape.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PassageAnswer {
    /// It is never nearer than the clearance, and never nearer than this.
    Clean {
        /// The distance is not less anywhere on the way, mm.
        nearest: f64,
    },
    /// At a fraction of the way it is nearer than the clearance and the tolerance; before it is not nearer than the
    /// clearance.
    Hit {
        /// Where, from 0 to 1.
        fraction: f64,
        /// The distance there.
        distance: DistanceInterval,
    },
    /// Not decided in the steps allowed, or where the distance is not known well enough.
    Undecided {
        /// Up to here it is clean, from 0 to 1.
        fraction: f64,
        /// The distance there.
        distance: DistanceInterval,
    },
}

impl SolidShape {
    /// Whether a body keeps a clearance (mm, may be zero) on its way. A hit is where the distance is surely not above
    /// clearance and tolerance; the tolerance (mm) must be above zero.
    pub fn passage(
        &self,
        body: &RoundBody,
        path: &TipMotion,
        clearance: f64,
        tolerance: f64,
        steps: usize,
    ) -> PassageAnswer {
        // So that a step which is no hit is at least three quarters of the tolerance long.
        let resolution = tolerance / 4.0;
        let mut fraction = 0.0;
        let mut distance = self.distance(body, (path.tip)(fraction), resolution);
        let mut nearest = distance.lower;
        for _ in 0..steps {
            if distance.upper <= clearance + tolerance {
                return PassageAnswer::Hit { fraction, distance };
            }
            if fraction >= 1.0 {
                return PassageAnswer::Clean { nearest };
            }
            let free = distance.lower - clearance;
            let next = if path.speed > 0.0 { fraction + free / path.speed } else { 1.0 };
            if !(free > 0.0 && next > fraction) {
                return PassageAnswer::Undecided { fraction, distance };
            }
            let next = next.min(1.0);
            let ahead = self.distance(body, (path.tip)(next), resolution);
            // Nearer from one end, away to the other: half of what the way is longer than the difference.
            let between = (distance.lower + ahead.lower - (next - fraction) * path.speed) / 2.0;
            nearest = nearest.min(ahead.lower).min(between.max(clearance));
            (fraction, distance) = (next, ahead);
        }
        PassageAnswer::Undecided { fraction, distance }
    }
}
