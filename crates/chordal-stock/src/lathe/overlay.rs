//! Boolean operations with a check: area(A−B) + area(A∩B) = area(A).
//!
//! Where the check fails, the second set is shifted by a ten-millionth of the size and the operation repeated; the
//! result gives the shift.

use chordal_geometry::Vec2;

use super::arrange::{
    ArrangementInput, ArrangementResult, EdgeArrangement, RegionRule, UnlistedEdges,
};
use super::edge::{Box2, RegionEdge};
use super::hull::DirectionHull;

/// Points within this share of the size are merged: far more than rounding (2e-16), far less than the tolerance of
/// the area check.
const COINCIDENT_SHARE: f64 = 1e-11;
/// The first shift as a share of the size; it doubles with each of [`SHIFTS`].
const SHIFT: f64 = 1e-7;
/// Directions of the shifts: none is parallel to an axis or at a common angle.
const SHIFTS: [Vec2; 5] = [
    Vec2::new(0.7891, 0.6143),
    Vec2::new(-0.5477, 0.8367),
    Vec2::new(0.3162, -0.9487),
    Vec2::new(-0.8944, -0.4472),
    Vec2::new(0.9701, 0.2425),
];
/// Margins around the second set as a share of the size: one above the tolerance, one above the largest shift.
const MARGINS: [f64; 2] = [2e-8, 4e-6];
/// Tolerance of the area check, as a share of the first area.
const AREA: f64 = 1e-9;
/// Rounding error of sums of areas, as a share of the size squared.
const AREA_ROUNDING_SHARE: f64 = 1e-13;

/// No result of a boolean operation passed its check. The operands are unchanged.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("the outlines of stock and tool meet in a way that cannot be told apart")]
pub struct OverlayError;

/// The tolerances for two sets.
#[derive(Clone, Copy, Debug)]
pub(crate) struct OverlayScale {
    pub tolerance: f64,
    pub margin: f64,
    size: f64,
    area: f64,
}

impl OverlayScale {
    /// The tolerances for a largest coordinate (mm) and an area of the first set (mm²).
    pub fn new(size: f64, area: f64) -> OverlayScale {
        OverlayScale { tolerance: COINCIDENT_SHARE * size, margin: MARGINS[0] * size, size, area }
    }

    /// With a margin for shifts.
    pub fn wide(self) -> OverlayScale {
        OverlayScale { margin: MARGINS[1] * self.size, ..self }
    }
}

/// Area (mm²) and volume (mm³).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct AreaAndVolume {
    pub area: f64,
    pub volume: f64,
}

/// Results and work space, reused between operations.
#[derive(Debug, Default)]
pub(crate) struct OverlayWorkspace {
    arrangement: EdgeArrangement,
    shifted: Vec<RegionEdge>,
    is_shifted: bool,
    /// Bound of the deviation of the result, mm: 0, or the shift of the second set, or the thickness of what was too
    /// thin to be resolved.
    pub off: f64,
    /// The edges of the intersection.
    pub common: Vec<RegionEdge>,
    pub amounts: AreaAndVolume,
}

/// The operands of an operation, with their tolerances.
#[derive(Clone, Copy)]
pub(crate) struct OverlayOperands<'a> {
    /// Edges of the first set that may be within the margin of the second.
    pub first: &'a [RegionEdge],
    pub others: &'a dyn UnlistedEdges,
    pub second: &'a [RegionEdge],
    pub simple: bool,
    /// The box of the second set.
    pub bounds: Box2,
    pub hull: &'a DirectionHull,
    pub scale: OverlayScale,
}

impl<'a> OverlayOperands<'a> {
    /// The middle of the overlap of both boxes. Relative to it, areas are sums of small triangles, with little
    /// cancellation.
    fn middle(&self) -> Vec2 {
        let (one, two) = (self.bounds, Box2::around(self.first));
        let low = Vec2::new(one.min.a.max(two.min.a), one.min.b.max(two.min.b));
        let high = Vec2::new(one.max.a.min(two.max.a), one.max.b.min(two.max.b));
        let middle = (low + high) * 0.5;
        if middle.a.is_finite() && middle.b.is_finite() { middle } else { Vec2::ZERO }
    }

    fn input(&self, second: &'a [RegionEdge]) -> ArrangementInput<'a> {
        let OverlayOperands { first, others, simple, hull, scale, .. } = *self;
        let (margin, tolerance) = (0.5 * scale.margin, scale.tolerance);
        ArrangementInput { first, others, second, simple, hull, margin, tolerance }
    }
}

impl OverlayWorkspace {
    /// Computes the arrangement and the intersection, and checks them.
    pub fn lay(&mut self, operands: &OverlayOperands<'_>) -> Result<(), OverlayError> {
        self.is_shifted = false;
        self.off = self.try_lay(operands, operands.second).ok_or(OverlayError)?;
        Ok(())
    }

    /// The same with the second set shifted, by increasing amounts. The scale must be [`wide`](OverlayScale::wide).
    pub fn lay_shifted(&mut self, operands: &OverlayOperands<'_>) -> Result<(), OverlayError> {
        let mut length = SHIFT * operands.scale.size;
        for direction in SHIFTS {
            let mut shifted = core::mem::take(&mut self.shifted);
            shifted.clear();
            shifted.extend(operands.second.iter().map(|edge| edge.moved(direction * length)));
            let found = self.try_lay(operands, &shifted);
            self.shifted = shifted;
            if let Some(off) = found {
                self.is_shifted = true;
                self.off = length + off;
                return Ok(());
            }
            length *= 2.0;
        }
        self.common.clear();
        self.amounts = AreaAndVolume::default();
        Err(OverlayError)
    }

    /// The error bound, mm; `None` if the check fails. It is the tolerance where the first set has thinner walls or
    /// gaps, which vanish.
    fn try_lay(&mut self, operands: &OverlayOperands<'_>, second: &[RegionEdge]) -> Option<f64> {
        let input = operands.input(second);
        let Self { arrangement, common, amounts, .. } = self;
        arrangement.lay(&input);
        common.clear();
        arrangement.bounds(&input, RegionRule::Intersection, |edge| common.push(edge));
        let origin = operands.middle();
        *amounts = measure(common, origin);
        if !arrangement.closes(RegionRule::Intersection)
            || !arrangement.closes(RegionRule::Difference)
        {
            return None;
        }
        let before: f64 = operands.first.iter().map(|edge| edge.area(origin)).sum();
        let mut after = 0.0;
        arrangement.bounds(&input, RegionRule::Difference, |edge| after += edge.area(origin));
        let OverlayScale { tolerance, size, area, .. } = operands.scale;
        let around: f64 = operands.first.iter().chain(second).map(RegionEdge::length).sum();
        let (off, rounding) =
            ((before - after - amounts.area).abs(), AREA_ROUNDING_SHARE * size * size);
        if off <= AREA * area + rounding {
            Some(0.0)
        } else if off <= tolerance * around + rounding {
            Some(tolerance)
        } else {
            None
        }
    }

    /// How a rule changes the first set, after [`lay`](Self::lay).
    pub fn outcome(
        &mut self,
        operands: &OverlayOperands<'_>,
        rule: RegionRule,
        outcome: &mut ArrangementResult,
    ) {
        let second = if self.is_shifted { &self.shifted[..] } else { operands.second };
        self.arrangement.outcome(&operands.input(second), rule, outcome);
    }
}

/// Area and volume within closed edges; areas are computed relative to `origin`.
pub(crate) fn measure(edges: &[RegionEdge], origin: Vec2) -> AreaAndVolume {
    edges.iter().fold(AreaAndVolume::default(), |sum, edge| AreaAndVolume {
        area: sum.area + edge.area(origin),
        volume: sum.volume + edge.volume(),
    })
}
