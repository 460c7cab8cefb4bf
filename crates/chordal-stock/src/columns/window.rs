//! The heights of some cells, side by side: to look at many places of a small part of the stock.

use super::grid::{BLOCK, BLOCKS};
use super::{Amount, Stock};

/// Below every stock: where there is none.
const NONE: f32 = f32::NEG_INFINITY;

/// The heights of a rectangle of cells, counted from the top of the stock, mm.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Window {
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
    /// No outer height is above this.
    highest: f32,
}

/// What is known of the heights on some cells, mm: none is above the first, none below the second.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Ends {
    pub highest: f64,
    pub lowest: f64,
}

impl Stock {
    /// The heights of the cells that a rectangle meets, mm.
    pub(crate) fn window(&self, low: [f64; 2], high: [f64; 2]) -> Window {
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
        let mut window = Window {
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
            highest: NONE,
        };
        if count > 0 {
            self.fill(&mut window);
        }
        window
    }

    fn fill(&self, window: &mut Window) {
        let [columns, rows] = window.size;
        let [first_column, first_row] = window.first;
        let across = self.grid().tile_counts()[0] as usize;
        let [last_column, last_row] = [first_column + columns - 1, first_row + rows - 1];
        for block_row in first_row / BLOCK..=last_row / BLOCK {
            for block_column in first_column / BLOCK..=last_column / BLOCK {
                let tile = block_row / BLOCKS * across + block_column / BLOCKS;
                let block = block_row % BLOCKS * BLOCKS + block_column % BLOCKS;
                let heights = self.tiles[tile].get(block);
                let [x, y] = [block_column * BLOCK, block_row * BLOCK];
                for row in y.max(first_row)..=(y + BLOCK - 1).min(last_row) {
                    for column in x.max(first_column)..=(x + BLOCK - 1).min(last_column) {
                        let from = (row - y) * BLOCK + column - x;
                        let to = (row - first_row) * columns + column - first_column;
                        window.outer[to] = heights.outer[from];
                        window.inner[to] = heights.inner[from];
                        window.highest = window.highest.max(heights.outer[from]);
                    }
                }
            }
        }
    }
}

impl Window {
    /// Nothing of the stock on the window is above this, mm.
    pub fn highest(&self) -> f64 {
        self.top + f64::from(self.highest)
    }

    /// The cells of a range of places along an axis, from the window's first one; those outside count, too.
    fn cells(&self, axis: usize, from: f64, to: f64) -> [i64; 2] {
        let at = |place: f64| ((place - self.corner[axis]) / self.cell).floor() as i64;
        [at(from), at(to)]
    }

    /// The ends of the heights on the cells that a rectangle about a place meets, by half its sides, mm. Outside the
    /// window there is no stock.
    pub fn ends(&self, place: [f64; 2], half: [f64; 2]) -> Ends {
        let [x0, x1] = self.cells(0, place[0] - half[0], place[0] + half[0]);
        let [y0, y1] = self.cells(1, place[1] - half[1], place[1] + half[1]);
        let [columns, rows] = self.size.map(|size| size as i64);
        let is_whole = x0 >= 0 && y0 >= 0 && x1 < columns && y1 < rows;
        let (mut highest, mut lowest) = (NONE, if is_whole { f32::INFINITY } else { NONE });
        for row in y0.max(0)..=y1.min(rows - 1) {
            for column in x0.max(0)..=x1.min(columns - 1) {
                let at = (row * columns + column) as usize;
                highest = highest.max(self.outer[at]);
                lowest = lowest.min(self.inner[at]);
            }
        }
        Ends { highest: self.top + f64::from(highest), lowest: self.top + f64::from(lowest) }
    }

    /// The middle between the two heights of the cell at a place, mm.
    pub fn middle(&self, place: [f64; 2]) -> f64 {
        let [x, _] = self.cells(0, place[0], place[0]);
        let [y, _] = self.cells(1, place[1], place[1]);
        let [columns, rows] = self.size.map(|size| size as i64);
        if x < 0 || y < 0 || x >= columns || y >= rows {
            return f64::NEG_INFINITY;
        }
        let at = (y * columns + x) as usize;
        self.top + 0.5 * (f64::from(self.outer[at]) + f64::from(self.inner[at]))
    }

    /// What was removed between this window and a later one of the same cells, mm³: its bounds, and by the middles
    /// of the two heights of each cell. `counts`: the cells that count, by their middles.
    pub fn removed(&self, after: &Window, counts: impl Fn([f64; 2]) -> bool) -> (Amount, f64) {
        let (mut amount, mut middle) = (Amount::default(), 0.0);
        for at in 0..self.outer.len().min(after.outer.len()) {
            let all = [self.outer[at], self.inner[at], after.outer[at], after.inner[at]];
            let [before, inner, outer, after] = all;
            if before == outer && inner == after {
                continue;
            }
            let [before, inner, outer, after] = [before, inner, outer, after].map(f64::from);
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

    use crate::{Cutter, Move, Options};

    use super::*;

    #[test]
    fn a_window_has_the_heights_of_its_cells() {
        let bounds = Aabb::of_points(Vec3::new(-3.0, 2.0, -10.0), Vec3::new(40.3, 31.1, 1.0));
        let mut stock = Stock::new(bounds, Options::new(0.5, 10_000_000)).unwrap();
        let curve = Line::new(Vec3::new(0.0, 5.0, -2.0), Vec3::new(30.0, 22.0, -6.0)).into();
        stock.cut(&Cutter::ball(6.0).unwrap(), &[Move { curve, tag: 0 }]);
        let window = stock.window([-9.0, 7.3], [22.2, 19.9]);
        assert_eq!((window.first, window.size), ([0, 10], [51, 26]));
        for row in 0..26 {
            for column in 0..51 {
                let heights = stock.heights_at(column, 10 + row).unwrap();
                let place = [-2.75 + 0.5 * f64::from(column), 7.25 + 0.5 * f64::from(row)];
                let ends = window.ends(place, [0.1; 2]);
                assert_eq!([ends.highest, ends.lowest], [heights.outer, heights.inner]);
            }
        }
        // Beyond the stock there is nothing.
        let outside = stock.window([50.0, 0.0], [60.0, 10.0]);
        assert_eq!(outside.ends([55.0, 5.0], [1.0; 2]).highest, f64::NEG_INFINITY);
    }
}
