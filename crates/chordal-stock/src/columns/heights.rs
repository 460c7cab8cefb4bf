//! The heights of a block, from the top of the stock.

use super::grid::{CELLS, StockGrid};
use crate::RemovedSpan;

/// A height above which nothing is left of a cell: by its corners, and the one that is known so far, mm.
pub type CellCeiling<'a> = dyn Fn([[f64; 2]; 2], f64) -> f64 + 'a;

/// What columns lack below their tops, by the corners of a cell: surely nothing on all of it, and where nothing may be
/// anywhere on it; from below, mm.
pub type CellHollows<'a> = dyn Fn([[f64; 2]; 2]) -> [Vec<RemovedSpan>; 2] + 'a;

/// The middle of a cell is asked for as a cell with such a side, mm: far above rounding, far below any resolution.
pub(crate) const POINT: f64 = 1e-6;

/// The heights of a block: outer and inner, from the stock's top, mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct BlockHeights {
    pub outer: [f32; CELLS],
    pub inner: [f32; CELLS],
}

/// The least and the largest outer and inner height of a block, and of the heights in the middles of its cells, mm:
/// where these are not kept, the outer ones.
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

    /// The heights of a block that is even.
    pub fn even(&self) -> BlockHeights {
        BlockHeights { outer: [self.outer[0]; CELLS], inner: [self.inner[0]; CELLS] }
    }

    pub fn is_uniform(&self) -> bool {
        [self.outer, self.inner, self.middle].iter().all(|[least, most]| least == most)
    }
}

/// Not below the number.
pub(crate) fn round_up(value: f64) -> f32 {
    let near = value as f32;
    if f64::from(near) < value { near.next_up() } else { near }
}

/// Not above the number.
pub(crate) fn round_down(value: f64) -> f32 {
    let near = value as f32;
    if f64::from(near) > value { near.next_down() } else { near }
}

/// The bottom of the stock, from its top, rounded down, mm.
pub(crate) fn bottom(grid: &StockGrid) -> f32 {
    round_down(-grid.bounds().size().z)
}
