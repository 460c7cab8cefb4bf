//! The heights of a block, relative to the top of the stock.

use super::grid::{CELLS, StockGrid};
use crate::RemovedSpan;

/// Returns the height above which nothing is left of a cell, mm, given its corners and the height known so far.
pub type CellCeiling<'a> = dyn Fn([[f64; 2]; 2], f64) -> f64 + 'a;

/// Returns the hollows below the top of a cell, given its corners: those that are certain everywhere on it, and those
/// that are possible anywhere on it; from below, mm.
pub type CellHollows<'a> = dyn Fn([[f64; 2]; 2]) -> [Vec<RemovedSpan>; 2] + 'a;

/// The middle of a cell is evaluated as a cell with this side, mm: far above rounding, far below any resolution.
pub(crate) const POINT: f64 = 1e-6;

/// The outer and inner heights of a block, relative to the stock's top, mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct BlockHeights {
    pub outer: [f32; CELLS],
    pub inner: [f32; CELLS],
}

/// The least and the largest outer and inner height of a block, and height in the middle of its cells, mm. Where the
/// latter are not kept, `middle` is that of the outer ones.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct HeightRange {
    pub outer: [f32; 2],
    pub inner: [f32; 2],
    pub middle: [f32; 2],
}

impl HeightRange {
    pub fn uniform(outer: f32, inner: f32, middle: f32) -> HeightRange {
        HeightRange { outer: [outer; 2], inner: [inner; 2], middle: [middle; 2] }
    }

    /// The heights of a block of one height.
    pub fn even(&self) -> BlockHeights {
        BlockHeights { outer: [self.outer[0]; CELLS], inner: [self.inner[0]; CELLS] }
    }

    pub fn is_uniform(&self) -> bool {
        [self.outer, self.inner, self.middle].iter().all(|[least, most]| least == most)
    }
}

/// Rounds to single precision, upwards.
pub(crate) fn round_up(value: f64) -> f32 {
    let near = value as f32;
    if f64::from(near) < value { near.next_up() } else { near }
}

/// Rounds to single precision, downwards.
pub(crate) fn round_down(value: f64) -> f32 {
    let near = value as f32;
    if f64::from(near) > value { near.next_down() } else { near }
}

/// The bottom of the stock relative to its top, rounded down, mm.
pub(crate) fn bottom(grid: &StockGrid) -> f32 {
    round_down(-grid.bounds().size().z)
}
