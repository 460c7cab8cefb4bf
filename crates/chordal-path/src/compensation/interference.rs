//! The interference check that a control makes for a block between two corners. It compares neighbours only; the module
//! `gouge` checks the whole contour.

use chordal_command::Units;
use chordal_geometry::Vec2;
use chordal_kernel::rules::InterferenceSearch;

use super::plane::{CompensationCurve, offset_between};
use super::queue::QueuedBlock;
use super::{BlockRole, Compensator, PathSink};

/// A move reversed by less than this is a rounding error, mm.
const REVERSED_MM: f64 = 1e-6;

/// An arc reversed by less than this is a rounding error, rad.
const TURNED_RAD: f64 = 1e-6;

/// Why a block does not fit.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) enum InterferenceKind {
    /// A straight move is reversed: its length and what it loses at its corners, mm.
    Reversed { length: f64, lost: f64 },
    /// The sweep of the arc differs from the programmed one, rad.
    Turned { programmed: f64, becomes: f64 },
    /// The offset vectors at its ends cross.
    Crossing,
}

impl Compensator {
    /// Reports an inside arc that the tool does not fit into; true if it does not.
    pub(super) fn inside_arc_too_small(&self, block: &QueuedBlock, out: &mut dyn PathSink) -> bool {
        let CompensationCurve::Arc { sweep, radius_from, radius_to, .. } = block.curve else {
            return false;
        };
        let rules = &self.rules.compensation;
        let inside = block.sign * sweep.signum() > 0.0;
        if !inside || !rules.checks {
            return false;
        }
        let radius = radius_from.min(radius_to);
        let offset = block.radii.0.max(block.radii.1);
        let short = if rules.equal_radius_refused { 0.0 } else { rules.tangent_mm };
        let too_small = if rules.equal_radius_refused {
            radius <= offset + 1e-9
        } else {
            radius < offset - short
        };
        if too_small {
            self.report_inside_arc(block, radius, offset, out);
        } else if radius <= offset + rules.tangent_mm {
            self.inside_arc_vanishes(block, offset, out);
        }
        too_small
    }

    /// Makes the check that this control makes. Some controls first drop corner points of the two corners that interfere.
    pub(super) fn interferes(
        &mut self,
        block: &mut QueuedBlock,
        _new: Option<&QueuedBlock>,
    ) -> Option<InterferenceKind> {
        loop {
            let found = self.test(block)?;
            if self.rules.compensation.interference != InterferenceSearch::Direction {
                return Some(found);
            }
            let before = self.queue.back_mut()?.corner.as_mut();
            let (Some(before), Some(own)) = (before, block.corner.as_mut()) else {
                return Some(found);
            };
            let links = before.points().len() > 1 && own.points().len() > 1;
            if !links || before.arc.is_some() || own.arc.is_some() {
                return Some(found);
            }
            before.drop_last();
            own.drop_first();
            block.start = before.last();
            block.straight = true;
        }
    }

    fn test(&self, block: &QueuedBlock) -> Option<InterferenceKind> {
        let (start, end) = (block.start, block.corner.as_ref()?.first());
        let rules = &self.rules.compensation;
        if !rules.checks {
            return None;
        }
        match rules.interference {
            InterferenceSearch::ArcAngle if !block.curve.is_arc() => None,
            InterferenceSearch::ArcAngle => arc_angle(block, start, end),
            InterferenceSearch::Direction => direction(block, start, end, rules.tangent_mm),
            InterferenceSearch::Vectors => {
                crossing(block.curve.from(), start, block.curve.to(), end)
                    .then_some(InterferenceKind::Crossing)
            }
            InterferenceSearch::Strict => self.strict(block, start, end),
        }
    }

    fn strict(&self, block: &QueuedBlock, start: Vec2, end: Vec2) -> Option<InterferenceKind> {
        match block.curve {
            CompensationCurve::Line { .. } => direction(block, start, end, 0.0),
            CompensationCurve::Arc { sweep, .. } => {
                // The first arc of a contour is checked only if its own end moves.
                let first =
                    self.queue.back().is_some_and(|before| before.role == BlockRole::StartUp);
                let moved = block.corner.as_ref().is_some_and(|corner| corner.inside);
                if block.role == BlockRole::StartUp || (first && !moved) {
                    return None;
                }
                let becomes = swept(block, start, end);
                let limits = self.rules.compensation.longer_arc_rad;
                let limit = limits[usize::from(self.units == Units::Inch)];
                let longer = becomes * sweep.signum() - sweep.abs();
                let reversed = becomes * sweep.signum() < -TURNED_RAD;
                (longer > limit || reversed)
                    .then_some(InterferenceKind::Turned { programmed: sweep, becomes })
            }
        }
    }
}

/// Compares the compensated direction with the programmed one, and the sweep of an arc. An inside arc that has shrunk to
/// a point is not checked.
fn direction(
    block: &QueuedBlock,
    start: Vec2,
    end: Vec2,
    point_mm: f64,
) -> Option<InterferenceKind> {
    let moved = end - start;
    match block.curve {
        CompensationCurve::Line { from, to } => {
            let along = (to - from).normalized()?;
            let forward = moved.dot(along);
            let length = from.distance(to);
            (forward < -REVERSED_MM)
                .then_some(InterferenceKind::Reversed { length, lost: length - forward })
        }
        CompensationCurve::Arc { .. } if block.straight => None,
        CompensationCurve::Arc { from, to, sweep, radius_from, .. } => {
            let left = radius_from - block.sign * sweep.signum() * block.radii.0;
            if left.abs() <= point_mm {
                return None;
            }
            let becomes = swept(block, start, end);
            let backward = (to - from).dot(moved) < -REVERSED_MM * from.distance(to);
            let turned = (becomes - sweep).abs() > std::f64::consts::PI
                || becomes * sweep.signum() < -TURNED_RAD;
            (backward || turned).then_some(InterferenceKind::Turned { programmed: sweep, becomes })
        }
    }
}

/// Fanuc 5008#1: reports only arcs whose sweep differs from the programmed one by more than 180 degrees.
fn arc_angle(block: &QueuedBlock, start: Vec2, end: Vec2) -> Option<InterferenceKind> {
    let CompensationCurve::Arc { sweep, .. } = block.curve else { return None };
    let becomes = swept(block, start, end);
    let turned = !block.straight && (becomes - sweep).abs() > std::f64::consts::PI;
    turned.then_some(InterferenceKind::Turned { programmed: sweep, becomes })
}

fn swept(block: &QueuedBlock, start: Vec2, end: Vec2) -> f64 {
    match offset_between(&block.curve, block.sign, block.radii, start, end) {
        CompensationCurve::Arc { sweep, .. } => sweep,
        CompensationCurve::Line { .. } => 0.0,
    }
}

/// True if the segment from `a` to `b` and the segment from `c` to `d` cross between their ends.
fn crossing(a: Vec2, b: Vec2, c: Vec2, d: Vec2) -> bool {
    let side = |p: Vec2, q: Vec2, r: Vec2| (q - p).cross(r - p);
    let separate = |one: f64, other: f64| {
        (one > REVERSED_MM && other < -REVERSED_MM) || (one < -REVERSED_MM && other > REVERSED_MM)
    };
    separate(side(a, b, c), side(a, b, d)) && separate(side(c, d, a), side(c, d, b))
}
