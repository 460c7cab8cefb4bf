//! A cutter as a body of revolution, given by the height of its lowest point at each distance from the axis.
//!
//! At the distance r from the axis the lowest point of the cutter is `height_at(r)` above its tip. The function is
//! composed of rings: a disc, a cone or a torus from one radius to the next.

mod inset;
mod shapes;
mod undercut;

use std::borrow::Cow;

pub use undercut::Undercut;

/// The shape of a cutter on a ring, as a function of the distance r from the axis, mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum RingElement {
    /// Flat, at this height above the tip.
    Disc {
        /// Height above the tip, mm.
        height: f64,
    },
    /// height + slope·(r − from): `slope` is the cotangent of the half angle.
    Cone {
        /// Height at the inner radius, above the tip, mm.
        height: f64,
        /// Rise per radius.
        slope: f64,
    },
    /// height + d²/(c + √(c² − d²)) with d = r − middle: a torus with the minor radius c and the major radius
    /// `middle`.
    Torus {
        /// Height of the lowest point above the tip, mm.
        height: f64,
        /// The minor radius c, mm.
        round: f64,
        /// The major radius, mm: zero for a ball.
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
    /// The shape on the ring.
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

/// Why dimensions do not give a cutter.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum CutterError {
    /// A dimension is not above zero, or not finite.
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
    /// An outline comes nearer to the axis on its way up: an undercut, which a profile cannot have.
    #[error("the outline must not come nearer to the axis on its way up (at height {height} mm)")]
    Undercut {
        /// Height of that point above the tip, mm.
        height: f64,
    },
}

/// A cutter that nowhere gets wider towards its tip. It removes from a column everything above its lowest point, up
/// to the end of its edges.
#[derive(Clone, Debug, PartialEq)]
pub struct CutterProfile {
    rings: Vec<Ring>,
    /// The height of the edges above the tip, mm; `None` where it is not known.
    flutes: Option<f64>,
}

impl CutterProfile {
    /// The rings from the axis outwards, without gaps.
    pub fn rings(&self) -> &[Ring] {
        &self.rings
    }

    /// The largest radius, mm.
    pub fn radius(&self) -> f64 {
        self.rings.last().map_or(0.0, |ring| ring.to)
    }

    /// The length of the edges from the tip, mm; `None` where it is not known.
    pub const fn flutes(&self) -> Option<f64> {
        self.flutes
    }

    /// The same cutter with another length of the edges, mm.
    #[must_use]
    pub fn with_flutes(mut self, flutes: Option<f64>) -> CutterProfile {
        self.flutes = flutes;
        self
    }

    /// The rings as far as they have edges. Where the edges end below the cutter's side, the rest does not cut.
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

    /// The height of the lowest point at a distance from the axis, above the tip, mm; infinite outside the cutter.
    pub fn height_at(&self, radius: f64) -> f64 {
        let on = |ring: &&Ring| radius <= ring.to;
        self.rings.iter().find(on).map_or(f64::INFINITY, |ring| ring.height_at(radius))
    }

    /// The height above the tip from which the cutter is a cylinder, mm.
    pub fn side(&self) -> f64 {
        self.rings.last().map_or(0.0, |ring| ring.height_at(ring.to))
    }

    /// Whether the height is a convex function of the position in plan. Then a straight move sweeps a convex body,
    /// and its floor is a convex function, too.
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
            // A step is not convex: the floor has a wall there.
            let follows = (ring.height_at(ring.from) - height).abs() <= EQUAL_RADIUS_MM;
            let rises = begin >= last - EQUAL_RADIUS_MM && end >= begin - EQUAL_RADIUS_MM;
            (last, height) = (end, ring.height_at(ring.to));
            follows && rises
        })
    }
}
