//! The lower side of a cutter, offset outwards or inwards by a distance.

use crate::cutter::{Ring, RingElement};

/// The rings of a cutter, each pushed outwards: a lower bound of a cutter whose axis is anywhere within `push` of its
/// nominal place. Pulled inwards, an upper bound.
#[derive(Clone, Copy, Debug)]
pub(super) struct PushedProfile<'a> {
    rings: &'a [Ring],
    /// Outwards, mm; below zero inwards.
    push: f64,
}

impl<'a> PushedProfile<'a> {
    pub(super) const fn new(rings: &'a [Ring]) -> PushedProfile<'a> {
        PushedProfile { rings, push: 0.0 }
    }

    /// The same rings pushed outwards by a further distance (inwards where negative), mm.
    pub(super) fn pushed(self, by: f64) -> PushedProfile<'a> {
        PushedProfile { push: self.push + by, ..self }
    }

    /// The largest radius, mm; negative where the profile is pulled in completely.
    pub(super) fn radius(&self) -> f64 {
        self.rings.last().map_or(0.0, |ring| ring.to + self.push)
    }

    /// Height above the tip at a distance from the axis, mm; infinite outside. At a step it is that of the inner,
    /// lower ring, since a cutter is a closed set.
    pub(super) fn height_at(&self, radius: f64) -> f64 {
        // Compared with the pushed rings, as in `radius()`: if the push were subtracted again, the result could lie
        // beyond the last ring by rounding. NaN is outside.
        let on = |ring: &&Ring| radius <= ring.to + self.push;
        self.rings.iter().find(on).map_or(f64::INFINITY, |ring| {
            ring.height_at((radius - self.push).max(0.0).min(ring.to))
        })
    }

    /// The pushed rings, from the axis outwards.
    pub(super) fn rings(&self) -> impl Iterator<Item = Ring> {
        let push = self.push;
        let middle = self.rings.first().filter(|_| push > 0.0).map(|ring| Ring {
            from: 0.0,
            to: push,
            element: RingElement::Disc { height: ring.height_at(ring.from) },
        });
        let moved = move |ring: &Ring| {
            let (from, to) = ((ring.from + push).max(0.0), ring.to + push);
            let element = match ring.element {
                RingElement::Torus { height, round, middle } => {
                    RingElement::Torus { height, round, middle: middle + push }
                }
                // Where a cone is pulled in past the axis, the rest of it begins higher up.
                RingElement::Cone { slope, .. } if ring.from + push < 0.0 => {
                    RingElement::Cone { height: ring.height_at(-push), slope }
                }
                other => other,
            };
            (to >= 0.0).then_some(Ring { from, to, element })
        };
        middle.into_iter().chain(self.rings.iter().filter_map(moved))
    }
}

/// The lowest of the heights that were offered, and where on the path it was.
#[derive(Clone, Copy, Debug)]
pub(super) struct LowestOffer {
    pub height: f64,
    /// Parameter of the path.
    pub at: f64,
}

impl LowestOffer {
    pub(super) const NONE: LowestOffer = LowestOffer { height: f64::INFINITY, at: f64::NAN };

    pub(super) fn offer(&mut self, height: f64, at: f64) {
        if height < self.height {
            *self = LowestOffer { height, at };
        }
    }

    pub(super) fn found(self) -> Option<LowestOffer> {
        (self.height < f64::INFINITY).then_some(self)
    }
}
