//! Gaps in columns: what undercuts have removed below the top of a column.
//!
//! A column with gaps still has its two heights. Everything below the outer one may be stock, except in its certain
//! gaps; everything below the inner one is stock, except in its possible gaps. Where a height is lowered into a gap,
//! the gap is open at the top: the height drops to its floor, and the gap is removed. Few columns have gaps, so they
//! are kept in a separate table.

use std::collections::BTreeMap;

use super::grid::{BLOCKS, CELLS};
use super::heights::{round_down, round_up};
use crate::RemovedSpan;

/// Floor and top of a gap relative to the stock's top, mm.
pub(crate) type ColumnGap = [f32; 2];

/// The gaps of a column from below, which do not touch each other or the height.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct ColumnGaps {
    /// Where there is certainly no stock.
    pub surely: Vec<ColumnGap>,
    /// Where there may be no stock.
    pub maybe: Vec<ColumnGap>,
    /// Where there is no stock in the middle of the cell, if that is kept.
    pub middle: Vec<ColumnGap>,
}

impl ColumnGaps {
    fn is_empty(&self) -> bool {
        self.count() == 0
    }

    fn count(&self) -> usize {
        self.surely.len() + self.maybe.len() + self.middle.len()
    }
}

/// The gaps of the columns of a tile, by block and cell.
#[derive(Clone, Debug, Default)]
pub(crate) struct TileGaps {
    columns: BTreeMap<u16, ColumnGaps>,
    /// The blocks with a column that has gaps, as a bit set.
    blocks: u64,
    /// Upper bound of the tops of the gaps in each block, mm; empty without any.
    tops: Vec<f32>,
    /// Total number of gaps.
    count: usize,
}

/// Approximate bytes of a column in the table; of a gap below.
const COLUMN_BYTES: usize = size_of::<ColumnGaps>() + 2 * size_of::<u64>();
const GAP_BYTES: usize = size_of::<ColumnGap>();

fn key([block, cell]: [usize; 2]) -> u16 {
    (block * CELLS + cell) as u16
}

impl TileGaps {
    pub fn bytes(&self) -> usize {
        self.columns.len() * COLUMN_BYTES + self.count * GAP_BYTES
    }

    /// Whether a column of a block has gaps.
    pub fn is_in(&self, block: usize) -> bool {
        self.blocks & (1 << block) != 0
    }

    /// Whether a gap of a block may reach a height, if all heights of the block are at least `height`.
    pub fn may_reach(&self, block: usize, height: f32) -> bool {
        self.is_in(block) && self.tops[block] >= height
    }

    pub fn is_empty(&self) -> bool {
        self.columns.is_empty()
    }

    pub fn of(&self, place: [usize; 2]) -> Option<&ColumnGaps> {
        if self.is_in(place[0]) { self.columns.get(&key(place)) } else { None }
    }

    /// The columns of a block with gaps, by cell.
    pub fn of_block(&self, block: usize) -> impl Iterator<Item = (usize, &ColumnGaps)> {
        let range = if self.is_in(block) { key([block, 0])..key([block, CELLS]) } else { 0..0 };
        self.columns
            .range(range)
            .map(move |(at, column)| (usize::from(*at) - block * CELLS, column))
    }

    /// Adds removed spans to a column (relative to the stock's top, mm): those certain, those possible and those in
    /// its middle. Returns its new heights: outer, inner, middle. Where the table would be larger than `limit` bytes,
    /// certain gaps are dropped and the inner height goes below the possible ones: the bounds are then wider, but
    /// still valid.
    pub fn add(
        &mut self,
        place: [usize; 2],
        [surely, maybe, middle]: [&[RemovedSpan]; 3],
        heights: [f32; 3],
        bottom: f32,
        limit: usize,
    ) -> [f32; 3] {
        let mut column = self.columns.remove(&key(place)).unwrap_or_default();
        self.count -= column.count();
        for span in surely {
            // Rounded inwards.
            insert(&mut column.surely, [round_up(span.floor).max(bottom), round_down(span.top)]);
        }
        for span in maybe {
            insert(&mut column.maybe, [round_down(span.floor).max(bottom), round_up(span.top)]);
        }
        for span in middle {
            let [floor, top] = [span.floor, span.top].map(|height| height as f32);
            insert(&mut column.middle, [floor.max(bottom), top]);
        }
        let heights = self.put(place, column, heights);
        if self.bytes() > limit {
            return self.forget(place, heights);
        }
        heights
    }

    /// The heights of a column after its gaps were merged with lowered heights; unchanged where it has no gaps.
    pub fn settle(&mut self, place: [usize; 2], heights: [f32; 3]) -> [f32; 3] {
        let Some(column) = self.columns.remove(&key(place)) else { return heights };
        self.count -= column.count();
        self.put(place, column, heights)
    }

    fn put(
        &mut self,
        place: [usize; 2],
        mut column: ColumnGaps,
        [outer, inner, middle]: [f32; 3],
    ) -> [f32; 3] {
        let outer = come_to_light(&mut column.surely, outer);
        // What is certainly removed may be removed, too.
        let inner = come_to_light(&mut column.maybe, inner.min(outer));
        let middle = come_to_light(&mut column.middle, middle.min(outer));
        if !column.is_empty() {
            self.count += column.count();
            self.tops.resize(BLOCKS * BLOCKS, f32::NEG_INFINITY);
            let last = [&column.surely, &column.maybe, &column.middle].map(|gaps| gaps.last());
            for gap in last.into_iter().flatten() {
                self.tops[place[0]] = self.tops[place[0]].max(gap[1]);
            }
            self.columns.insert(key(place), column);
            self.blocks |= 1 << place[0];
        }
        [outer, inner, middle]
    }

    fn forget(&mut self, place: [usize; 2], [outer, inner, middle]: [f32; 3]) -> [f32; 3] {
        let Some(column) = self.columns.remove(&key(place)) else { return [outer, inner, middle] };
        self.count -= column.count();
        [outer, column.maybe.first().map_or(inner, |gap| inner.min(gap[0])), middle]
    }
}

/// Adds a gap, and merges it with those that it touches.
fn insert(gaps: &mut Vec<ColumnGap>, [mut floor, mut top]: ColumnGap) {
    if floor >= top {
        return;
    }
    gaps.retain(|gap| {
        let separate = gap[1] < floor || top < gap[0];
        if !separate {
            (floor, top) = (floor.min(gap[0]), top.max(gap[1]));
        }
        separate
    });
    let at = gaps.partition_point(|gap| gap[0] < floor);
    gaps.insert(at, [floor, top]);
}

/// Removes gaps that reach the height or are above it, and returns the height after that.
fn come_to_light(gaps: &mut Vec<ColumnGap>, mut height: f32) -> f32 {
    while let Some(&[floor, top]) = gaps.last() {
        if top < height {
            break;
        }
        height = height.min(floor);
        gaps.pop();
    }
    height
}

/// The length of a column from the bottom to a height without its gaps, mm.
pub(crate) fn solid(height: f32, bottom: f64, gaps: &[ColumnGap]) -> f64 {
    (f64::from(height) - bottom).max(0.0) - gaps.iter().map(length).sum::<f64>()
}

fn length([floor, top]: &ColumnGap) -> f64 {
    (f64::from(*top) - f64::from(*floor)).max(0.0)
}

/// A column as intervals of stock: its height and gaps.
#[derive(Clone, Copy)]
pub(crate) struct SolidColumn<'a> {
    pub height: f32,
    pub gaps: &'a [ColumnGap],
}

impl SolidColumn<'_> {
    /// Its intervals from a bottom on.
    fn intervals(&self, bottom: f64) -> impl Iterator<Item = [f64; 2]> {
        let floors = core::iter::once(bottom).chain(self.gaps.iter().map(|gap| f64::from(gap[1])));
        let tops = self.gaps.iter().map(|gap| f64::from(gap[0]));
        let tops = tops.chain(core::iter::once(f64::from(self.height)));
        floors.zip(tops).map(|(floor, top)| [floor, top])
    }

    /// The length of it within an interval, mm.
    pub fn within(&self, bottom: f64, [floor, top]: [f64; 2]) -> f64 {
        self.intervals(bottom).map(|[from, to]| (to.min(top) - from.max(floor)).max(0.0)).sum()
    }

    /// The length of it that is not in another column, mm.
    pub fn without(&self, other: &SolidColumn<'_>, bottom: f64) -> f64 {
        let own = self.intervals(bottom);
        own.map(|part| (part[1] - part[0]).max(0.0) - other.within(bottom, part)).sum()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const PLACE: [usize; 2] = [3, 17];
    const ALL: usize = 1 << 20;

    fn span(floor: f64, top: f64) -> RemovedSpan {
        RemovedSpan { floor, top }
    }

    #[test]
    fn gaps_join_and_come_to_light() {
        let mut gaps = TileGaps::default();
        let all = |spans: &'static [RemovedSpan]| [spans, spans, spans];
        static LOW: [RemovedSpan; 1] = [RemovedSpan { floor: -12.0, top: -8.0 }];
        static NEXT: [RemovedSpan; 1] = [RemovedSpan { floor: -8.0, top: -7.0 }];
        assert_eq!(gaps.add(PLACE, all(&LOW), [0.0; 3], -20.0, ALL), [0.0; 3]);
        assert_eq!(gaps.add(PLACE, all(&NEXT), [0.0; 3], -20.0, ALL), [0.0; 3]);
        assert_eq!(gaps.of(PLACE).unwrap().surely, [[-12.0, -7.0]]);
        assert_eq!(gaps.of(PLACE).unwrap().middle, [[-12.0, -7.0]]);
        assert!(gaps.may_reach(PLACE[0], -7.5) && !gaps.may_reach(PLACE[0], -6.5));
        // A cut to -7.5 is into the gap.
        assert_eq!(gaps.settle(PLACE, [-7.5; 3]), [-12.0; 3]);
        assert!(gaps.is_empty() && gaps.of(PLACE).is_none());
    }

    #[test]
    fn a_column_without_room_for_gaps_has_wider_bounds() {
        let mut gaps = TileGaps::default();
        let spans = [span(-12.0, -8.0)];
        assert_eq!(gaps.add(PLACE, [&spans; 3], [0.0; 3], -20.0, 0), [0.0, -12.0, 0.0]);
        assert!(gaps.is_empty());
    }

    #[test]
    fn what_is_left_of_columns() {
        let gaps = [[-12.0, -8.0], [-4.0, -3.0]];
        let column = SolidColumn { height: -1.0, gaps: &gaps };
        assert_eq!(solid(-1.0, -20.0, &gaps), 14.0);
        assert_eq!(column.within(-20.0, [-9.0, -3.5]), 4.0);
        assert_eq!(column.without(&SolidColumn { height: -8.0, gaps: &[] }, -20.0), 6.0);
    }
}
