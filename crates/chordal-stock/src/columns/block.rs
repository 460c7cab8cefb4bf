//! Bounds of the floor on the cells of a block.
//!
//! The floor F is a convex function of the column, so on a cell it is largest at a corner (`hi`), and by reflection
//! through the middle nowhere below 2·F(middle) − hi (`lo`). A cell with a corner that is not reached has no `hi`,
//! and its `lo` follows from its nearest point.

use wide::{CmpEq, f32x4};

use super::grid::{BLOCK, LANES};
use crate::sweep::lanes::{LOWER, NOT_REACHED, PLAIN, TileCourse, UPPER};
use crate::sweep::shape::PartKind;

/// Groups of four cells in a row of a block.
const GROUPS_OF_ROW: usize = BLOCK / LANES;

/// A rectangle of cells of a block: its first column and row, its number of groups of four columns, and its number of
/// rows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct BlockPart {
    pub column: usize,
    pub row: usize,
    pub groups: usize,
    pub rows: usize,
}

impl BlockPart {
    /// Its number of cells.
    pub fn cells(&self) -> usize {
        self.groups * LANES * self.rows
    }

    /// Its middle relative to the corner of the block, and half its diagonal, in cells.
    pub fn middle(&self) -> ([f32; 2], f32) {
        let (width, height) = ((self.groups * LANES) as f32, self.rows as f32);
        let middle = [self.column as f32 + width / 2.0, self.row as f32 + height / 2.0];
        (middle, (width * width + height * height).sqrt() / 2.0)
    }
}

/// Distance between rows in the array of corners: one corner more than cells, rounded up to whole groups.
const STRIDE: usize = BLOCK + LANES;

#[inline(always)]
fn ramp(step: f32) -> f32x4 {
    f32x4::from([0.0, step, 2.0 * step, 3.0 * step])
}

#[inline(always)]
fn load(from: &[f32; STRIDE * STRIDE], at: usize) -> f32x4 {
    match from[at..].first_chunk::<LANES>() {
        Some(&group) => f32x4::from(group),
        None => f32x4::splat(NOT_REACHED),
    }
}

/// Calls `put` for each group of four cells of a part with its number in the block, the bounds `hi` and `lo` of the
/// floor, and the floor in the middle of each cell. `corner` is that of the block, in cells of the tile; `lowest` the
/// least height of the part of the cutter on the block.
#[inline(always)]
pub(crate) fn certified<const LEVEL: bool, S: PartKind>(
    course: &TileCourse,
    shape: &S,
    corner: [f32; 2],
    part: &BlockPart,
    lowest: f32,
    mut put: impl FnMut(usize, f32x4, f32x4, f32x4),
) {
    let (x, y) = (corner[0] + part.column as f32, corner[1] + part.row as f32);
    let mut corners = [0.0_f32; STRIDE * STRIDE];
    let (ramp_a, ramp_e) = (ramp(course.along[1]), ramp(course.across[1]));
    let [rows_a, rows_e] = &course.rows;
    let begin = |x: f32, y: f32, ramp_a: f32x4, ramp_e: f32x4| {
        let (a, e) = course.at(x, y);
        (ramp_a + f32x4::splat(a), ramp_e + f32x4::splat(e))
    };
    for group in 0..part.groups {
        let (a, e) = begin(x + (group * LANES) as f32, y, ramp_a, ramp_e);
        for row in 0..part.rows + 1 {
            let floor = course.floor::<LEVEL, UPPER, S>(shape, a + rows_a[row], e + rows_e[row]);
            let at = row * STRIDE + group * LANES;
            corners[at..at + LANES].copy_from_slice(floor.as_array_ref());
        }
    }
    // The last column of corners, four rows at once.
    let last = part.groups * LANES;
    let (up_a, up_e) = (ramp(course.along[2]), ramp(course.across[2]));
    let mut row = 0;
    while row <= part.rows {
        let (a, e) = begin(x + last as f32, y + row as f32, up_a, up_e);
        let floor = course.floor::<LEVEL, UPPER, S>(shape, a, e).to_array();
        for (n, value) in floor.into_iter().enumerate() {
            corners[(row + n) * STRIDE + last] = value;
        }
        row += LANES;
    }
    let nothing = f32x4::splat(NOT_REACHED);
    let least = f32x4::splat(lowest);
    for group in 0..part.groups {
        let pair = |row: usize| {
            let at = row * STRIDE + group * LANES;
            load(&corners, at).fast_max(load(&corners, at + 1))
        };
        let mut before = pair(0);
        let (a, e) = begin(x + (group * LANES) as f32 + 0.5, y + 0.5, ramp_a, ramp_e);
        for row in 0..part.rows {
            let after = pair(row + 1);
            let hi = before.fast_max(after);
            before = after;
            let (a, e) = (a + rows_a[row], e + rows_e[row]);
            let middle = course.floor::<LEVEL, LOWER, S>(shape, a, e);
            let mut lo = (middle + middle - hi).fast_max(least);
            let open = hi.cmp_eq(nothing);
            if open.any() {
                let within = course.half_diagonal;
                lo = open.blend(course.least_within(shape, lowest, within, a, e), lo);
            }
            let at = (part.row + row) * GROUPS_OF_ROW + part.column / LANES + group;
            put(at, hi, lo, middle + course.raise);
        }
    }
}

/// Like [`certified`], but only with the floor in the middle of each cell.
#[inline(always)]
pub(crate) fn sampled<const LEVEL: bool, S: PartKind>(
    course: &TileCourse,
    shape: &S,
    corner: [f32; 2],
    part: &BlockPart,
    mut put: impl FnMut(usize, f32x4),
) {
    let (x, y) = (corner[0] + part.column as f32 + 0.5, corner[1] + part.row as f32 + 0.5);
    let (ramp_a, ramp_e) = (ramp(course.along[1]), ramp(course.across[1]));
    for group in 0..part.groups {
        let (a, e) = course.at(x + (group * LANES) as f32, y);
        let (a, e) = (ramp_a + f32x4::splat(a), ramp_e + f32x4::splat(e));
        for row in 0..part.rows {
            let (a, e) = (a + course.rows[0][row], e + course.rows[1][row]);
            let floor = course.floor::<LEVEL, PLAIN, S>(shape, a, e);
            put((part.row + row) * GROUPS_OF_ROW + part.column / LANES + group, floor);
        }
    }
}
