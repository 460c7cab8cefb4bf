//! Where a chain of blocks closes, and on which side of the closed contour its leads lie.

use core::f64::consts::{FRAC_PI_2, TAU};

use super::shape::GougeCurve;
use super::{ContourBlock, GougeOptions};

/// So many blocks at either end of a chain may lead to the contour and away.
pub(super) const MAX_LEAD: usize = 3;

/// Directions that differ by less do not tell on which side a lead lies: its course does, rad.
const AMBIGUOUS_DIRECTION_RAD: f64 = 0.2;

/// How a block lies that meets a closed contour at its closing point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum ClosingSide {
    /// Where the tool is.
    ToolSide,
    /// Along the contour.
    Along,
    /// Where the material stays.
    FarSide,
}

/// A closed contour at its closing point.
#[derive(Clone, Copy, Debug)]
pub(super) struct ClosingPoint<'a> {
    /// Its first curve.
    pub(super) first: &'a GougeCurve,
    /// Its last curve.
    pub(super) last: &'a GougeCurve,
    /// +1 with the tool on the left.
    pub(super) side: f64,
    /// What differs by less is the same place, mm.
    pub(super) grain: f64,
}

impl ClosingPoint<'_> {
    /// How a block lies that begins at the closing point. One that ends there is given reversed.
    ///
    /// The tool has the directions from the contour's first, turned towards the tool, to the way back
    /// along its last. A block that sets out along one of the two is judged by where it comes to.
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

    /// On which side of a curve of the contour a block comes that sets out along it.
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

/// So far along a curve it is judged, mm: of an arc a quarter turn at most.
fn reach(curve: &GougeCurve) -> f64 {
    match *curve {
        GougeCurve::Line { .. } => curve.length(),
        GougeCurve::Arc { radius, sweep, .. } => radius * sweep.abs().min(FRAC_PI_2),
    }
}

/// The stretch of a chain, first and end, that is a closed contour beyond doubt: few blocks lead to
/// it and away, and these lie where the tool is.
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

/// Whether a stretch is closed and what comes before and after it lies where the tool is, or along
/// it: how many of the two surely lie where the tool is.
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

/// Whether a few blocks have a closed contour among them.
fn closes_within(blocks: &[ContourBlock], grain: f64) -> bool {
    (0..blocks.len()).any(|first| {
        let from = blocks[first].curve.from();
        blocks[first..].iter().any(|block| block.curve.to().distance(from) <= grain)
    })
}
