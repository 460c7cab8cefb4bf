//! A copy of the heights and gaps of a rectangle of cells, for many look-ups in a small part of the stock.

use std::collections::BTreeMap;

use super::gaps::{ColumnGap, ColumnGaps};
use super::grid::{BLOCK, BLOCKS};
use super::{ColumnStock, VolumeInterval};

/// The height where there is no stock.
const NONE: f32 = f32::NEG_INFINITY;

/// The heights of a rectangle of cells, relative to the top of the stock, mm.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct HeightWindow {
    /// The first cell of the rectangle, within the grid.
    first: [usize; 2],
    /// Cells along X and Y.
    size: [usize; 2],
    /// The corner of the first cell, mm.
    corner: [f64; 2],
    cell: f64,
    /// The sides of the cells inside the stock's box, along X and Y, mm.
    sides: [Vec<f64>; 2],
    top: f64,
    outer: Vec<f32>,
    inner: Vec<f32>,
    /// The gaps of cells that have some.
    gaps: BTreeMap<usize, ColumnGaps>,
    /// Upper bound of the outer heights.
    highest: f32,
}

/// What is known about the stock on some cells within an interval of heights, mm: there is none outside of `maybe`,
/// and it is everywhere in `surely`, which is empty where its end is below its start. Both may extend beyond the
/// interval.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct StockLimits {
    pub maybe: [f64; 2],
    pub surely: [f64; 2],
}

/// An interval without stock.
const EMPTY_INTERVAL: [f64; 2] = [f64::INFINITY, f64::NEG_INFINITY];

impl ColumnStock {
    /// A window of the cells that a rectangle meets, mm.
    pub(crate) fn window(&self, low: [f64; 2], high: [f64; 2]) -> HeightWindow {
        let grid = self.grid();
        let (cell, bounds, cells) = (grid.resolution(), grid.bounds(), grid.cells());
        let origin = [bounds.min.x, bounds.min.y];
        let at = |axis: usize, place: f64| {
            ((place - origin[axis]) / cell).floor().clamp(0.0, f64::from(cells[axis])) as usize
        };
        let first = [0, 1].map(|axis| at(axis, low[axis]));
        let size = [0, 1].map(|axis| {
            let end = at(axis, high[axis]) + 1;
            end.min(cells[axis] as usize).saturating_sub(first[axis])
        });
        let count = size[0] * size[1];
        let mut window = HeightWindow {
            first,
            size,
            corner: [0, 1].map(|axis| origin[axis] + cell * first[axis] as f64),
            cell,
            sides: [0, 1].map(|axis| {
                let length = if axis == 0 { bounds.size().x } else { bounds.size().y };
                let ends = first[axis]..first[axis] + size[axis];
                ends.map(|number| (length - cell * number as f64).min(cell)).collect()
            }),
            top: bounds.max.z,
            outer: vec![NONE; count],
            inner: vec![NONE; count],
            gaps: BTreeMap::new(),
            highest: NONE,
        };
        if count > 0 {
            self.fill(&mut window);
        }
        window
    }

    fn fill(&self, window: &mut HeightWindow) {
        let [columns, rows] = window.size;
        let [first_column, first_row] = window.first;
        let across = self.grid().tile_counts()[0] as usize;
        let [last_column, last_row] = [first_column + columns - 1, first_row + rows - 1];
        for block_row in first_row / BLOCK..=last_row / BLOCK {
            for block_column in first_column / BLOCK..=last_column / BLOCK {
                let tile = block_row / BLOCKS * across + block_column / BLOCKS;
                let block = block_row % BLOCKS * BLOCKS + block_column % BLOCKS;
                let heights = self.tiles[tile].get(block);
                let gaps = self.tiles[tile].gaps();
                let has_gaps = gaps.is_in(block);
                let [x, y] = [block_column * BLOCK, block_row * BLOCK];
                for row in y.max(first_row)..=(y + BLOCK - 1).min(last_row) {
                    for column in x.max(first_column)..=(x + BLOCK - 1).min(last_column) {
                        let from = (row - y) * BLOCK + column - x;
                        let to = (row - first_row) * columns + column - first_column;
                        window.outer[to] = heights.outer[from];
                        window.inner[to] = heights.inner[from];
                        if let Some(column) = gaps.of([block, from]).filter(|_| has_gaps) {
                            window.gaps.insert(to, column.clone());
                        }
                        window.highest = window.highest.max(heights.outer[from]);
                    }
                }
            }
        }
    }
}

impl HeightWindow {
    /// Upper bound of the height of the stock in the window, mm.
    pub fn highest(&self) -> f64 {
        self.top + f64::from(self.highest)
    }

    /// The first and last cell of a range of coordinates along an axis, counted from the window's first cell; they
    /// may be outside the window.
    fn cells(&self, axis: usize, from: f64, to: f64) -> [i64; 2] {
        let at = |place: f64| ((place - self.corner[axis]) / self.cell).floor() as i64;
        [at(from), at(to)]
    }

    /// What is known about the stock on the cells that a rectangle (middle and half sides) meets, within an interval
    /// of heights, mm. Outside the window there is no stock.
    pub fn ends(&self, place: [f64; 2], half: [f64; 2], section: [f64; 2]) -> StockLimits {
        let section = section.map(|height| height - self.top);
        let [x0, x1] = self.cells(0, place[0] - half[0], place[0] + half[0]);
        let [y0, y1] = self.cells(1, place[1] - half[1], place[1] + half[1]);
        let [columns, rows] = self.size.map(|size| size as i64);
        let is_whole = x0 >= 0 && y0 >= 0 && x1 < columns && y1 < rows;
        let mut maybe = EMPTY_INTERVAL;
        let mut surely = if is_whole { [f64::NEG_INFINITY, f64::INFINITY] } else { EMPTY_INTERVAL };
        for row in y0.max(0)..=y1.min(rows - 1) {
            for column in x0.max(0)..=x1.min(columns - 1) {
                let at = (row * columns + column) as usize;
                let [some, all] = self.over(at, section);
                maybe = [maybe[0].min(some[0]), maybe[1].max(some[1])];
                surely = [surely[0].max(all[0]), surely[1].min(all[1])];
            }
        }
        let from_top = |ends: [f64; 2]| ends.map(|height| self.top + height);
        StockLimits { maybe: from_top(maybe), surely: from_top(surely) }
    }

    /// The stock of a cell within an interval of heights: where it may be, and the certain part that overlaps the
    /// interval most.
    fn over(&self, at: usize, [from, to]: [f64; 2]) -> [[f64; 2]; 2] {
        let [outer, inner] = [self.outer[at], self.inner[at]].map(f64::from);
        let Some(column) = self.gaps.get(&at) else {
            return [[f64::NEG_INFINITY, outer], [f64::NEG_INFINITY, inner]];
        };
        let within = |gap: &&ColumnGap| f64::from(gap[0]) <= from && from <= f64::from(gap[1]);
        let maybe = match column.surely.iter().find(within) {
            Some(gap) if to <= f64::from(gap[1]) => EMPTY_INTERVAL,
            Some(gap) => [f64::from(gap[1]), outer],
            None => [f64::NEG_INFINITY, outer],
        };
        let mut floor = f64::NEG_INFINITY;
        let (mut surely, mut most) = (EMPTY_INTERVAL, f64::NEG_INFINITY);
        for [gap, next] in column.maybe.iter().map(|gap| gap.map(f64::from)).chain([[inner; 2]]) {
            let share = gap.min(to) - floor.max(from);
            if share > most {
                (surely, most) = ([floor, gap], share);
            }
            floor = next;
        }
        [maybe, surely]
    }

    /// The index of the cell at a point; `None` outside.
    fn cell(&self, place: [f64; 2]) -> Option<usize> {
        let [x, _] = self.cells(0, place[0], place[0]);
        let [y, _] = self.cells(1, place[1], place[1]);
        let [columns, rows] = self.size.map(|size| size as i64);
        let is_in = x >= 0 && y >= 0 && x < columns && y < rows;
        is_in.then_some((y * columns + x) as usize)
    }

    /// The middle between the two heights of the cell at a point, mm.
    pub fn middle(&self, place: [f64; 2]) -> f64 {
        let Some(at) = self.cell(place) else { return f64::NEG_INFINITY };
        self.top + 0.5 * (f64::from(self.outer[at]) + f64::from(self.inner[at]))
    }

    /// The share of an interval of heights that gaps take in the cell at a point: the middle between certain and
    /// possible gaps.
    pub fn missing(&self, place: [f64; 2], section: [f64; 2]) -> f64 {
        let column = self.cell(place).and_then(|at| self.gaps.get(&at));
        let Some(column) = column else { return 0.0 };
        let [from, to] = section.map(|height| height - self.top);
        let taken = |gap: &ColumnGap| {
            let [floor, top] = gap.map(f64::from);
            if to > from {
                (top.min(to) - floor.max(from)).max(0.0) / (to - from)
            } else {
                f64::from(u8::from(floor <= from && from <= top))
            }
        };
        let sum = |gaps: &[ColumnGap]| gaps.iter().map(taken).sum::<f64>().min(1.0);
        0.5 * (sum(&column.surely) + sum(&column.maybe))
    }

    /// Upper and lower bound of the height of a cell if its gaps were closed by lowering it, relative to the top, mm.
    fn filled(&self, at: usize) -> [f64; 2] {
        let heights = [self.outer[at], self.inner[at]].map(f64::from);
        let Some(column) = self.gaps.get(&at) else { return heights };
        let taken = |gaps: &[ColumnGap]| {
            gaps.iter().map(|gap| f64::from(gap[1]) - f64::from(gap[0])).sum::<f64>()
        };
        [heights[0] - taken(&column.surely), heights[1] - taken(&column.maybe)]
    }

    /// What was removed between this window and a later one of the same cells, mm³: the bounds, and the value by the
    /// middles of the two heights of each cell. `counts` decides by the middle of a cell whether it counts.
    pub fn removed(
        &self,
        after: &HeightWindow,
        counts: impl Fn([f64; 2]) -> bool,
    ) -> (VolumeInterval, f64) {
        let (mut amount, mut middle) = (VolumeInterval::default(), 0.0);
        for at in 0..self.outer.len().min(after.outer.len()) {
            let [[before, inner], [outer, after]] = [self.filled(at), after.filled(at)];
            if before == outer && inner == after {
                continue;
            }
            let place = [at % self.size[0], at / self.size[0]];
            let middle_of =
                |axis: usize| self.corner[axis] + self.cell * (place[axis] as f64 + 0.5);
            if !counts([middle_of(0), middle_of(1)]) {
                continue;
            }
            let area = self.sides[0][place[0]] * self.sides[1][place[1]];
            amount.least += area * (inner - outer).max(0.0);
            amount.most += area * (before - after).max(0.0);
            middle += area * 0.5 * ((before + inner) - (outer + after));
        }
        (amount, middle)
    }
}

#[cfg(test)]
mod tests {
    use chordal_geometry::{Aabb, Line, Vec3};

    use crate::{ColumnOptions, CutterProfile, TipMove};

    use super::*;

    #[test]
    fn a_window_has_the_heights_of_its_cells() {
        let bounds = Aabb::of_points(Vec3::new(-3.0, 2.0, -10.0), Vec3::new(40.3, 31.1, 1.0));
        let mut stock = ColumnStock::new(bounds, ColumnOptions::new(0.5, 10_000_000)).unwrap();
        let curve = Line::new(Vec3::new(0.0, 5.0, -2.0), Vec3::new(30.0, 22.0, -6.0)).into();
        stock.cut(&CutterProfile::ball(6.0).unwrap(), &[TipMove { curve, tag: 0 }]);
        let window = stock.window([-9.0, 7.3], [22.2, 19.9]);
        assert_eq!((window.first, window.size), ([0, 10], [51, 26]));
        for row in 0..26 {
            for column in 0..51 {
                let heights = stock.heights_at(column, 10 + row).unwrap();
                let place = [-2.75 + 0.5 * f64::from(column), 7.25 + 0.5 * f64::from(row)];
                let ends = window.ends(place, [0.1; 2], [-8.0, -7.0]);
                assert_eq!([ends.maybe[1], ends.surely[1]], [heights.outer, heights.inner]);
            }
        }
        // Beyond the stock there is nothing.
        let outside = stock.window([50.0, 0.0], [60.0, 10.0]);
        let ends = outside.ends([55.0, 5.0], [1.0; 2], [-9.0, 0.0]);
        assert_eq!([ends.maybe[1], ends.surely[1]], [f64::NEG_INFINITY; 2]);
    }

    #[test]
    fn a_window_has_the_gaps_of_its_cells() {
        let bounds = Aabb::of_points(Vec3::new(0.0, 0.0, -20.0), Vec3::new(40.0, 30.0, 0.0));
        let mut stock = ColumnStock::new(bounds, ColumnOptions::new(0.5, 10_000_000)).unwrap();
        let disc = crate::Undercut::t_slot(20.0, 4.0, 8.0).unwrap();
        let curve = Line::new(Vec3::new(-20.0, 15.0, -12.0), Vec3::new(60.0, 15.0, -12.0)).into();
        stock.cut_below(&[(0.0, disc)], &[TipMove { curve, tag: 0 }]);
        let window = stock.window([0.0, 0.0], [40.0, 30.0]);
        let near = |value: f64, truth: f64| (value - truth).abs() < 0.01;
        let ends = |y: f64, stretch: [f64; 2]| window.ends([20.25, y], [0.1; 2], stretch);
        // In the gap there is nothing; below it all up to its floor, above it up to the top.
        assert_eq!(ends(15.25, [-11.0, -9.0]).maybe, EMPTY_INTERVAL);
        assert!(near(ends(15.25, [-15.0, -13.0]).surely[1], -12.0));
        let above = ends(15.25, [-7.0, -2.0]);
        assert!(
            near(above.maybe[1], 0.0) && near(above.surely[0], -8.0) && near(above.surely[1], 0.0)
        );
        // From in it upwards it may begin, and surely begins, at its top.
        let both = ends(15.25, [-11.0, -2.0]);
        assert!(
            near(both.maybe[0], -8.0) && near(both.surely[0], -8.0) && near(both.surely[1], 0.0)
        );
        // Next to it, all.
        assert!(near(ends(2.25, [-11.0, -9.0]).surely[1], 0.0));
        assert!((window.missing([20.25, 15.25], [-12.0, -4.0]) - 0.5).abs() < 0.01);
        assert_eq!(window.missing([20.25, 15.25], [-10.0, -10.0]), 1.0);
        assert_eq!(window.missing([20.25, 2.25], [-12.0, -4.0]), 0.0);
        // What a hole to the gap removes is the stock above it.
        let drop = Line::new(Vec3::new(20.0, 15.0, 1.0), Vec3::new(20.0, 15.0, -9.0)).into();
        stock.cut(&CutterProfile::flat(10.0).unwrap(), &[TipMove { curve: drop, tag: 0 }]);
        let after = stock.window([0.0, 0.0], [40.0, 30.0]);
        let (bounds, middle) = window.removed(&after, |_| true);
        let truth = 8.0 * 25.0 * std::f64::consts::PI;
        assert!(bounds.least <= truth && truth <= bounds.most, "{bounds:?}");
        assert!((middle / truth - 1.0).abs() < 0.02, "{middle} {truth}");
    }
}
