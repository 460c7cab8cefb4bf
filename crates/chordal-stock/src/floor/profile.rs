//! The lower side of a cutter, also grown outwards by a distance.

use crate::cutter::{Ring, RingElement};

/// The rings of a cutter, each pushed outwards: the lowest place of a cutter whose axis is anywhere
/// within `push` of where it is taken to be. Pulled inwards, it is the highest that this place can be.
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

    /// The same rings pushed outwards by so much more, or pulled inwards, mm.
    pub(super) fn pushed(self, by: f64) -> PushedProfile<'a> {
        PushedProfile { push: self.push + by, ..self }
    }

    /// The largest radius, mm; below zero where all is pulled in.
    pub(super) fn radius(&self) -> f64 {
        self.rings.last().map_or(0.0, |ring| ring.to + self.push)
    }

    /// Height above the tip at a distance from the axis, mm; infinite outside. At a step it is that of
    /// the inner ring, the lower one: a cutter is closed.
    pub(super) fn height_at(&self, radius: f64) -> f64 {
        // Compared where the rings are now, as `radius` says it: less the push again, its own radius may be beyond
        // the last ring by rounding. A number that is none is outside.
        let on = |ring: &&Ring| radius <= ring.to + self.push;
        self.rings.iter().find(on).map_or(f64::INFINITY, |ring| {
            ring.height_at((radius - self.push).max(0.0).min(ring.to))
        })
    }

    /// The rings where they are now, from the axis outwards.
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
                // What is left of a cone that has come to the axis begins higher up.
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
