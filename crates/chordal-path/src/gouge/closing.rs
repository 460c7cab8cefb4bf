//! Finds where a chain of blocks closes, and on which side of the closed contour its leads are.

use core::f64::consts::{FRAC_PI_2, TAU};

use super::shape::GougeCurve;
use super::{ContourBlock, GougeOptions};

/// The largest number of blocks at either end of a chain that may be leads.
pub(super) const MAX_LEAD: usize = 3;

/// Directions that differ by less do not show on which side a lead is: then a point farther along it decides, rad.
const AMBIGUOUS_DIRECTION_RAD: f64 = 0.2;

/// On which side of a closed contour a block is that meets it at its closing point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum ClosingSide {
    /// On the side of the tool.
    ToolSide,
    /// Along the contour.
    Along,
    /// On the side of the material.
    FarSide,
}

/// A closed contour at its closing point.
#[derive(Clone, Copy, Debug)]
pub(super) struct ClosingPoint<'a> {
    /// Its first curve.
    pub(super) first: &'a GougeCurve,
    /// Its last curve.
    pub(super) last: &'a GougeCurve,
    /// +1 if the tool is on the left, −1 on the right.
    pub(super) side: f64,
    /// Points nearer than this are equal, mm.
    pub(super) grain: f64,
}

impl ClosingPoint<'_> {
    /// On which side a block is that begins at the closing point. A block that ends there is passed reversed.
    ///
    /// The side of the tool has the directions from the first of the contour, turning towards the tool, to the reverse of
    /// its last. For a block that starts along one of these two, a point farther along it decides.
    pub(super) fn lies(&self, lead: &GougeCurve) -> ClosingSide {
        let out = self.first.tangent_angles().0;
        let back = self.last.reversed().tangent_angles().0;
        let turned = |angle: f64| (self.side * (angle - out)).rem_euclid(TAU);
        let (open, angle) = (turned(back), turned(lead.tangent_angles().0));
        let near =
            |a: f64, b: f64| (a - b).abs().min(TAU - (a - b).abs()) < AMBIGUOUS_DIRECTION_RAD;
        if near(angle, 0.0) {
            return self.side_of(lead, self.first);
        }
        if near(angle, open) {
            return self.side_of(lead, self.last);
        }
        if angle < open { ClosingSide::ToolSide } else { ClosingSide::FarSide }
    }

    /// The side of a block that starts along a curve of the contour.
    fn side_of(&self, lead: &GougeCurve, curve: &GougeCurve) -> ClosingSide {
        let path = reach(lead).min(reach(curve));
        let left = curve.left_of(lead.at((path / lead.length()).min(1.0))) * self.side;
        if left > self.grain {
            ClosingSide::ToolSide
        } else if left < -self.grain {
            ClosingSide::FarSide
        } else {
            ClosingSide::Along
        }
    }
}

/// How far along a curve the side is decided, mm: its length, for an arc at most that of a quarter turn.
fn reach(curve: &GougeCurve) -> f64 {
    match *curve {
        GougeCurve::Line { .. } => curve.length(),
        GougeCurve::Arc { radius, sweep, .. } => radius * sweep.abs().min(FRAC_PI_2),
    }
}

/// The range of a chain (first block, end) that is certainly a closed contour: few blocks lead to it and away from it,
/// and they are on the side of the tool. `None` if there is none, or more than one possible.
pub(super) fn at_ends(
    chain: &[ContourBlock],
    side: f64,
    options: &GougeOptions,
) -> Option<(usize, usize)> {
    let count = chain.len();
    let mut found: Vec<(usize, usize, usize)> = Vec::new();
    for first in 0..count.min(MAX_LEAD + 1) {
        for dropped in 0..=MAX_LEAD.min(count - 1 - first) {
            let end = count - dropped;
            if let Some(leads) = led_to(chain, first, end, side, options) {
                found.push((first, end, leads));
            }
        }
    }
    let best = *found.iter().max_by_key(|(first, end, leads)| (*leads, end - first))?;
    let alone = found.iter().all(|other| other.0 < best.1 && best.0 < other.1);
    let plain = |leads: &[ContourBlock]| !closes_within(leads, options.vertex);
    (alone && plain(&chain[..best.0]) && plain(&chain[best.1..])).then_some((best.0, best.1))
}

/// For a range of a chain that is closed and whose neighbours are not on the side of the material: how many of the two
/// neighbours are certainly on the side of the tool. `None` for any other range.
fn led_to(
    chain: &[ContourBlock],
    first: usize,
    end: usize,
    side: f64,
    options: &GougeOptions,
) -> Option<usize> {
    let grain = options.vertex;
    let at = chain[first].curve.from();
    if end <= first || chain[end - 1].curve.to().distance(at) > grain {
        return None;
    }
    let closing =
        ClosingPoint { first: &chain[first].curve, last: &chain[end - 1].curve, side, grain };
    let before = first.checked_sub(1).map(|before| closing.lies(&chain[before].curve.reversed()));
    let after = chain.get(end).map(|after| closing.lies(&after.curve));
    let mut leads = 0;
    for lies in [before, after].into_iter().flatten() {
        match lies {
            ClosingSide::ToolSide => leads += 1,
            ClosingSide::Along => {}
            ClosingSide::FarSide => return None,
        }
    }
    Some(leads)
}

/// Whether a range of these blocks is a closed contour.
fn closes_within(blocks: &[ContourBlock], grain: f64) -> bool {
    (0..blocks.len()).any(|first| {
        let from = blocks[first].curve.from();
        blocks[first..].iter().any(|block| block.curve.to().distance(from) <= grain)
    })
}
