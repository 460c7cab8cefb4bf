//! Bounds over a whole cell: what a move certainly removes from every column in a square, and what it may remove from
//! any.
//!
//! Any column in the cell is within half a diagonal s of its middle. So the floor of the cutter pushed outwards by s
//! is a lower bound, and that of the cutter pulled inwards by s an upper bound. A convex cutter on a straight move
//! sweeps a convex body: its floor f is a convex function of the position. So its maximum is at a corner c and, since
//! f(m) ≤ (f(p) + f(p′))/2 for points p, p′ opposite each other about the middle m, its minimum is at least 2·f(m) −
//! f(c).

use super::CutterSweep;
use super::path::TipPath;
use super::pieces::WIDE;
use super::profile::PushedProfile;
use crate::floor::RemovedSpan;

/// Bound of the rounding error of a column or a height, mm, for slopes below 1000 and lengths of some metres. Windows
/// are too wide by less than this.
const ROUNDING_MM: f64 = 2.0 * WIDE;
/// The same for larger lengths, as a share of the length.
const ROUNDING_SHARE: f64 = 64.0 * f64::EPSILON;

/// Two bounds of a height over all of a cell, mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HeightBounds {
    /// Lower bound over all columns of the cell.
    pub lower: f64,
    /// Upper bound over all columns of the cell.
    pub upper: f64,
}

impl HeightBounds {
    /// The floor where no column is reached.
    const NOWHERE: HeightBounds = HeightBounds { lower: f64::INFINITY, upper: f64::INFINITY };
}

/// A square about its middle, grown by the errors of rounding and of the ends of an arc.
struct CellSquare {
    middle: [f64; 2],
    /// Half a side.
    half: f64,
    /// Half a diagonal.
    reach: f64,
    /// Error bound of heights.
    off: f64,
    gap: f64,
}

impl CellSquare {
    fn corners(&self) -> [[f64; 2]; 4] {
        let ([x, y], half) = (self.middle, self.half);
        [[x - half, y - half], [x + half, y - half], [x - half, y + half], [x + half, y + half]]
    }

    /// The floor of a profile along the whole path.
    fn floor(&self, path: &TipPath, profile: PushedProfile, is_convex: bool) -> HeightBounds {
        let outer = path.lowest(profile.pushed(self.reach), self.middle, self.gap);
        let Some(outer) = outer else { return HeightBounds::NOWHERE };
        let lower = outer.lower - self.off;
        if is_convex && path.is_straight() {
            let at = |place: [f64; 2]| {
                path.lowest(profile, place, self.gap).map_or(f64::INFINITY, |low| low.upper)
            };
            let upper = self.corners().map(at).into_iter().fold(f64::NEG_INFINITY, f64::max);
            if upper < f64::INFINITY {
                let reflected = 2.0 * at(self.middle) - upper;
                return HeightBounds {
                    lower: lower.max(reflected - self.off),
                    upper: upper + self.off,
                };
            }
        }
        let inner = path.lowest(profile.pushed(-self.reach), self.middle, self.gap);
        let upper = inner.map_or(f64::INFINITY, |low| low.upper + self.off);
        HeightBounds { lower, upper }
    }

    /// One of the two bounds within a range of the path.
    fn floor_within(
        &self,
        path: &TipPath,
        profile: PushedProfile,
        range: [f64; 2],
        is_outer: bool,
    ) -> Option<f64> {
        let by = if is_outer { self.reach } else { -self.reach };
        let low = path.lowest_within(profile.pushed(by), self.middle, range, self.gap)?;
        Some(if is_outer { low.lower - self.off } else { low.upper + self.off })
    }
}

impl CutterSweep<'_> {
    fn cell(&self, middle: [f64; 2], side: f64) -> CellSquare {
        let size = middle.into_iter().fold(self.path.size(), |size, x| size.max(x.abs()));
        let off = ROUNDING_MM + ROUNDING_SHARE * size + self.path.off();
        let half = 0.5 * side + off;
        CellSquare { middle, half, reach: half * std::f64::consts::SQRT_2, off, gap: self.gap }
    }

    /// Bounds of the floor over a cell with this middle and side, mm. The upper bound is infinite where the cutter
    /// may miss some column of the cell; both are where it misses all.
    #[must_use]
    pub fn cell_floor(&self, middle: [f64; 2], side: f64) -> HeightBounds {
        let cell = self.cell(middle, side);
        cell.floor(&self.path, self.profile(), self.is_convex)
    }

    /// Adds what is certainly removed from every column of a cell with this middle and side (mm), and what may be
    /// removed from any: one span for each connected part of the move, in order.
    pub fn cell_spans(
        &self,
        middle: [f64; 2],
        side: f64,
        surely: &mut Vec<RemovedSpan>,
        maybe: &mut Vec<RemovedSpan>,
    ) {
        let cell = self.cell(middle, side);
        let profile = self.profile();
        if self.path.is_straight() {
            let floor = cell.floor(&self.path, profile, self.is_convex);
            // The upper side is evaluated as a mirror image.
            let top = self.top.as_ref().map(|top| {
                let floor = cell.floor(&top.path, PushedProfile::new(&top.rings), top.is_convex);
                HeightBounds { lower: top.height - floor.upper, upper: top.height - floor.lower }
            });
            let top = top.unwrap_or(HeightBounds::NOWHERE);
            push(surely, floor.upper, top.lower);
            push(maybe, floor.lower, top.upper);
            return;
        }
        for (is_outer, out) in [(false, surely), (true, maybe)] {
            let by = if is_outer { cell.reach } else { -cell.reach };
            self.path.windows(middle, profile.pushed(by).radius(), is_outer, &mut |range| {
                let floor = cell.floor_within(&self.path, profile, range, is_outer);
                let top = match &self.top {
                    None => Some(f64::INFINITY),
                    Some(top) => {
                        let profile = PushedProfile::new(&top.rings);
                        let low = cell.floor_within(&top.path, profile, range, is_outer);
                        low.map(|low| top.height - low)
                    }
                };
                if let (Some(floor), Some(top)) = (floor, top) {
                    push(out, floor, top);
                }
            });
        }
    }
}

fn push(spans: &mut Vec<RemovedSpan>, floor: f64, top: f64) {
    if floor < top {
        spans.push(RemovedSpan { floor, top });
    }
}
