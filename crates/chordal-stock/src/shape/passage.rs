//! Finds whether a moving body keeps clear of a shape. Nothing is sampled: no point of the body approaches faster
//! than the tip moves, so the next evaluation can wait for distance over speed (conservative advancement).

use chordal_geometry::Vec3;

use super::SolidShape;
use super::body::RoundBody;
use super::convex::DistanceInterval;

/// The path of a tip, with a parameter from 0 to 1.
pub struct TipMotion<'a> {
    /// The position of the tip at a parameter, mm.
    pub tip: &'a dyn Fn(f64) -> Vec3,
    /// Largest speed of the tip per unit of the parameter, mm: for a curve at constant speed its length.
    pub speed: f64,
}

/// How a body passed a shape.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PassageAnswer {
    /// It is never nearer than the clearance.
    Clean {
        /// Lower bound of the distance along the whole path, mm.
        nearest: f64,
    },
    /// At a parameter it is nearer than clearance plus tolerance; before that it is not nearer than the clearance.
    Hit {
        /// The parameter, from 0 to 1.
        fraction: f64,
        /// The distance there.
        distance: DistanceInterval,
    },
    /// Not decided within the allowed steps, or because the distance is not known well enough.
    Undecided {
        /// The parameter up to which it is clean, from 0 to 1.
        fraction: f64,
        /// The distance there.
        distance: DistanceInterval,
    },
}

impl SolidShape {
    /// Whether a body keeps a clearance (mm, may be zero) along a path. A hit is where the distance is certainly not
    /// above clearance plus tolerance (mm, must be above zero).
    pub fn passage(
        &self,
        body: &RoundBody,
        path: &TipMotion,
        clearance: f64,
        tolerance: f64,
        steps: usize,
    ) -> PassageAnswer {
        // With this resolution every step that is not a hit is at least three quarters of the tolerance long.
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
            // The least distance between two evaluations a and b at path length l apart is at least (a + b − l)/2.
            let between = (distance.lower + ahead.lower - (next - fraction) * path.speed) / 2.0;
            nearest = nearest.min(ahead.lower).min(between.max(clearance));
            (fraction, distance) = (next, ahead);
        }
        PassageAnswer::Undecided { fraction, distance }
    }
}
