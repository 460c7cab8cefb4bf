//! A difference and an intersection that are checked: area(A−B) + area(A∩B) = area(A).
//!
//! Where the check fails, the second set is shifted by a ten-millionth of the size and the work done
//! again; the result says by how much.

use chordal_geometry::Vec2;

use super::arrange::{
    ArrangementInput, ArrangementResult, EdgeArrangement, RegionRule, UnlistedEdges,
};
use super::edge::{Box2, RegionEdge};
use super::hull::DirectionHull;

/// Points this near, as a part of the size, are the same: far more than rounding (2e-16 of it), far less than
/// what areas are checked to.
const COINCIDENT_SHARE: f64 = 1e-11;
/// The first shift, as a part of the size; it doubles with each of [`SHIFTS`].
const SHIFT: f64 = 1e-7;
/// Directions of the shifts: none is that of an axis or of a usual angle.
const SHIFTS: [Vec2; 5] = [
    Vec2::new(0.7891, 0.6143),
    Vec2::new(-0.5477, 0.8367),
    Vec2::new(0.3162, -0.9487),
    Vec2::new(-0.8944, -0.4472),
    Vec2::new(0.9701, 0.2425),
];
/// Around the second set, as a part of the size: more than the tolerance, and more than the largest shift.
const MARGINS: [f64; 2] = [2e-8, 4e-6];
/// How well areas must agree, as a part of the first's.
const AREA: f64 = 1e-9;
/// What sums of areas lose by rounding, as a part of the size squared.
const AREA_ROUNDING_SHARE: f64 = 1e-13;

/// A boolean operation found no answer that passes its check. The operands are as they were.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("the outlines of stock and tool meet in a way that cannot be told apart")]
pub struct OverlayError;

/// The lengths by which two sets are compared.
#[derive(Clone, Copy, Debug)]
pub(crate) struct OverlayScale {
    pub tolerance: f64,
    pub margin: f64,
    size: f64,
    area: f64,
}

impl OverlayScale {
    /// From the largest coordinate (mm) and the area of the first set (mm²).
    pub fn new(size: f64, area: f64) -> OverlayScale {
        OverlayScale { tolerance: COINCIDENT_SHARE * size, margin: MARGINS[0] * size, size, area }
    }

    /// With room for shifts.
    pub fn wide(self) -> OverlayScale {
        OverlayScale { margin: MARGINS[1] * self.size, ..self }
    }
}

/// Area and volume.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct AreaAndVolume {
    pub area: f64,
    pub volume: f64,
}

/// Work space, kept between operations for its memory.
#[derive(Debug, Default)]
pub(crate) struct OverlayWorkspace {
    arrangement: EdgeArrangement,
    shifted: Vec<RegionEdge>,
    is_shifted: bool,
    /// By how much the result may be off the outlines that were given, mm: 0, or a shift of the second set, or
    /// what was too thin to be told.
    pub off: f64,
    /// What both have in common.
    pub common: Vec<RegionEdge>,
    pub amounts: AreaAndVolume,
}

/// The operands, whose tolerances are those of a [`OverlayScale`].
#[derive(Clone, Copy)]
pub(crate) struct OverlayOperands<'a> {
    /// Edges of the first set that may come within the scale's margin of the second.
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
    /// The middle of where both sets are: areas about it are those of small triangles.
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
    /// Lays the second set over the first, finds what they have in common and checks it.
    pub fn lay(&mut self, operands: &OverlayOperands<'_>) -> Result<(), OverlayError> {
        self.is_shifted = false;
        self.off = self.try_lay(operands, operands.second).ok_or(OverlayError)?;
        Ok(())
    }

    /// The same with the second set shifted, by more and more. The margin must be wide.
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

    /// By how much outlines may be off, mm; `None` if the check fails. It is the tolerance where the first
    /// set has walls or gaps that are thinner, which become none.
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

    /// What a rule makes of the first set, after [`lay`](Self::lay).
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

/// Area and volume within closed edges; areas are taken about `origin`.
pub(crate) fn measure(edges: &[RegionEdge], origin: Vec2) -> AreaAndVolume {
    edges.iter().fold(AreaAndVolume::default(), |sum, edge| AreaAndVolume {
        area: sum.area + edge.area(origin),
        volume: sum.volume + edge.volume(),
    })
}
