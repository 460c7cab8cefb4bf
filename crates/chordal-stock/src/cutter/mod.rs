//! A cutter: a body that turns about its axis, as the height of its lowest point at each distance from it.
//!
//! Below the distance r from the axis nothing of the cutter is lower than `height_at(r)` above its tip.
//! The function is put together from rings: a disc, a cone or a torus from one radius to the next.

mod inset;
mod shapes;
mod undercut;

use std::borrow::Cow;

pub use undercut::Undercut;

/// What a cutter is on a ring, by the distance r from the axis, mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum RingElement {
    /// Flat, at this height above the tip.
    Disc {
        /// Above the tip, mm.
        height: f64,
    },
    /// height + slope·(r − from): `slope` is the cotangent of the half angle.
    Cone {
        /// At the inner radius, above the tip, mm.
        height: f64,
        /// Rise by radius.
        slope: f64,
    },
    /// height + d²/(c + √(c² − d²)) with d = r − middle: a round of radius c about a circle of radius `middle`.
    Torus {
        /// The lowest point, above the tip, mm.
        height: f64,
        /// The radius of the round, mm.
        round: f64,
        /// The radius of the circle of its centres, mm: nothing for a ball.
        middle: f64,
    },
}

/// An element from one radius to the next.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ring {
    /// The inner radius, mm.
    pub from: f64,
    /// The outer radius, mm.
    pub to: f64,
    /// What is there.
    pub element: RingElement,
}

impl Ring {
    /// The height above the tip at a radius on the ring, mm.
    pub fn height_at(&self, radius: f64) -> f64 {
        match self.element {
            RingElement::Disc { height } => height,
            RingElement::Cone { height, slope } => height + slope * (radius - self.from),
            RingElement::Torus { height, round, middle } => {
                let d = radius - middle;
                height + d * d / (round + (round * round - d * d).max(0.0).sqrt())
            }
        }
    }
}

impl Ring {
    /// The largest radius on the ring at which it is no higher above the tip than this, mm.
    fn radius_at(&self, limit: f64) -> f64 {
        if self.height_at(self.to) <= limit {
            return self.to;
        }
        let radius = match self.element {
            RingElement::Disc { .. } => self.from,
            RingElement::Cone { height, slope } => self.from + (limit - height) / slope,
            RingElement::Torus { height, round, middle } => {
                let rise = limit - height;
                middle + (rise * (2.0 * round - rise)).max(0.0).sqrt()
            }
        };
        radius.clamp(self.from, self.to)
    }
}

/// Why there is no cutter of some dimensions.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum CutterError {
    /// A dimension is zero, below it or not a number.
    #[error("the {what} must be above zero, it is {value} mm")]
    NotPositive {
        /// What it is.
        what: &'static str,
        /// Its value, mm or rad.
        value: f64,
    },
    /// A dimension is larger than another one allows.
    #[error("the {what} is {value} mm; {most} mm is the most that fits")]
    TooLarge {
        /// What it is.
        what: &'static str,
        /// Its value, mm or rad.
        value: f64,
        /// The largest possible, mm or rad.
        most: f64,
    },
    /// An outline that goes back towards the axis on its way up: an undercut, which this form has not.
    #[error("the outline must not come nearer to the axis on its way up (at height {height} mm)")]
    Undercut {
        /// Where, mm above the tip.
        height: f64,
    },
}

/// A cutter that is no wider lower down: what it removes from a column is everything above its
/// lowest place, up to the end of its edges.
#[derive(Clone, Debug, PartialEq)]
pub struct CutterProfile {
    rings: Vec<Ring>,
    /// The height of the edges above the tip, mm; `None` where it is not known.
    flutes: Option<f64>,
}

impl CutterProfile {
    /// The rings from the axis outward: they follow each other without a gap.
    pub fn rings(&self) -> &[Ring] {
        &self.rings
    }

    /// The largest radius, mm.
    pub fn radius(&self) -> f64 {
        self.rings.last().map_or(0.0, |ring| ring.to)
    }

    /// How far up the edges reach from the tip, mm; `None` where it is not known.
    pub const fn flutes(&self) -> Option<f64> {
        self.flutes
    }

    /// The same cutter with edges that reach so far up, mm.
    #[must_use]
    pub fn with_flutes(mut self, flutes: Option<f64>) -> CutterProfile {
        self.flutes = flutes;
        self
    }

    /// The rings as far as edges are on them: where these end below the cutter's side, what is above and
    /// around them does not cut.
    pub fn edges(&self) -> Cow<'_, [Ring]> {
        let flutes = self.flutes.unwrap_or(f64::INFINITY);
        if self.side() <= flutes {
            return Cow::Borrowed(&self.rings);
        }
        let below = |ring: &Ring| {
            let to = ring.radius_at(flutes);
            (ring.height_at(ring.from) < flutes && ring.from < to).then_some(Ring { to, ..*ring })
        };
        Cow::Owned(self.rings.iter().map_while(below).collect())
    }

    /// The height of the lowest place at a distance from the axis, above the tip, mm; infinite outside
    /// the cutter.
    pub fn height_at(&self, radius: f64) -> f64 {
        let on = |ring: &&Ring| radius <= ring.to;
        self.rings.iter().find(on).map_or(f64::INFINITY, |ring| ring.height_at(radius))
    }

    /// The height of the cutter's side above its tip, mm: from there up it is a cylinder.
    pub fn side(&self) -> f64 {
        self.rings.last().map_or(0.0, |ring| ring.height_at(ring.to))
    }

    /// Whether the height is a convex function of the place around the axis: so a straight move sweeps a
    /// convex body, and below it the floor is a convex function too.
    pub fn is_convex(&self) -> bool {
        const EQUAL_RADIUS_MM: f64 = 1e-12;
        let slopes = |ring: &Ring| match ring.element {
            RingElement::Disc { .. } => [0.0, 0.0],
            RingElement::Cone { slope, .. } => [slope, slope],
            RingElement::Torus { round, middle, .. } => [ring.from, ring.to].map(|radius| {
                let d = radius - middle;
                d / (round * round - d * d).max(f64::MIN_POSITIVE).sqrt()
            }),
        };
        let mut last = 0.0;
        let mut height = self.rings.first().map_or(0.0, |ring| ring.height_at(ring.from));
        self.rings.iter().all(|ring| {
            let [begin, end] = slopes(ring);
            // A step up is no slope: the floor has a wall there.
            let follows = (ring.height_at(ring.from) - height).abs() <= EQUAL_RADIUS_MM;
            let rises = begin >= last - EQUAL_RADIUS_MM && end >= begin - EQUAL_RADIUS_MM;
            (last, height) = (end, ring.height_at(ring.to));
            follows && rises
        })
    }
}
