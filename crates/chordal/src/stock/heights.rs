//! Shapes as heights over cells, as columns begin with them.

use chordal_stock::shape::{Cells, Grid, Shape};

/// The heights of a shape over cells of any size: quick on those of one grid.
pub(super) struct Heights<'s> {
    shape: &'s Shape,
    grid: Grid,
    cells: Option<Cells>,
    bottom: f64,
}

impl<'s> Heights<'s> {
    /// With the cells of a resolution in the box of the shape, mm.
    pub fn new(shape: &'s Shape, resolution: f64) -> Heights<'s> {
        let bounds = shape.bounds();
        let size = bounds.size();
        let count = |length: f64| (length / resolution).ceil().max(1.0) as usize;
        let grid = Grid {
            origin: [bounds.min.x, bounds.min.y],
            cell: resolution,
            columns: count(size.x),
            rows: count(size.y),
            grow: GROW,
        };
        let cells = shape.cells(&grid).ok();
        Heights { shape, grid, cells, bottom: bounds.min.z }
    }

    /// Of a cell between two corners: a height above which there is nothing of the shape, and one below which all
    /// of the cell is shape down to the bottom of its box, mm.
    pub fn of(&self, low: [f64; 2], high: [f64; 2]) -> [f64; 2] {
        let side = (high[0] - low[0]).max(high[1] - low[1]);
        let is_own = (side - self.grid.cell).abs() <= 1e-9 * self.grid.cell;
        let at = |axis: usize| (low[axis] - self.grid.origin[axis]) / self.grid.cell;
        let (column, row) = (at(0).round(), at(1).round());
        let near = (at(0) - column).abs() < 1e-6 && (at(1) - row).abs() < 1e-6;
        match &self.cells {
            Some(cells)
                if is_own
                    && near
                    && (column as usize) < self.grid.columns
                    && (row as usize) < self.grid.rows =>
            {
                self.heights(cells, column as usize, row as usize)
            }
            _ => {
                let one = Grid { origin: low, cell: side, columns: 1, rows: 1, grow: GROW };
                match self.shape.cells(&one) {
                    Ok(cells) => self.heights(&cells, 0, 0),
                    // A cell without a size: nothing is sure.
                    Err(_) => [self.shape.bounds().max.z, self.bottom],
                }
            }
        }
    }

    fn heights(&self, cells: &Cells, column: usize, row: usize) -> [f64; 2] {
        let outer = cells.outer(column, row).last().map_or(self.bottom, |span| span.to);
        let inner = cells.inner(column, row).first().filter(|span| span.from <= self.bottom + NEAR);
        [outer, inner.map_or(self.bottom, |span| span.to)]
    }
}

/// Cells are not wider than they are: the columns count their own rounding.
const GROW: f64 = 0.0;
/// A shape that begins so near the bottom stands on it, mm.
const NEAR: f64 = 1e-6;
