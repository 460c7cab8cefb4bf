//! Shapes as heights over cells, as columns begin with them.

use chordal_geometry::Aabb;
use chordal_stock::shape::{Cells, Grid, Shape, Span};
use chordal_stock::{Amount, Stock};

/// The heights of a shape over cells of any size: quick on those of one grid.
pub(super) struct Heights<'s> {
    /// What holds the shape.
    outer: &'s Shape,
    /// What lies in it, where that is another.
    inner: Option<&'s Shape>,
    grid: Grid,
    cells: Option<Cells>,
    inner_cells: Option<Cells>,
    bottom: f64,
}

impl<'s> Heights<'s> {
    /// With the cells of a resolution in the box of the shape, mm.
    pub fn new(shape: &'s Shape, resolution: f64) -> Heights<'s> {
        Heights::between([shape, shape], resolution)
    }

    /// Of a shape between two: one that holds it, and one that lies in it.
    pub fn between([shape, inner]: [&'s Shape; 2], resolution: f64) -> Heights<'s> {
        let inner = (!std::ptr::eq(shape, inner)).then_some(inner);
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
        let inner_cells = inner.and_then(|inner| inner.cells(&grid).ok());
        Heights { outer: shape, inner, grid, cells, inner_cells, bottom: bounds.min.z }
    }

    /// The box around the shape.
    pub fn bounds(&self) -> Aabb {
        self.outer.bounds()
    }

    /// Of a cell between two corners: a height above which there is nothing of the shape, and one below which all
    /// of the cell is shape, down to the bottom of its box unless it is hollow there, mm.
    pub fn of(&self, low: [f64; 2], high: [f64; 2]) -> [f64; 2] {
        let side = (high[0] - low[0]).max(high[1] - low[1]);
        let is_own = (side - self.grid.cell).abs() <= 1e-9 * self.grid.cell;
        let at = |axis: usize| (low[axis] - self.grid.origin[axis]) / self.grid.cell;
        let (column, row) = (at(0).round(), at(1).round());
        let near = (at(0) - column).abs() < 1e-6 && (at(1) - row).abs() < 1e-6;
        let is_known = is_own
            && near
            && (column as usize) < self.grid.columns
            && (row as usize) < self.grid.rows;
        let place = is_known.then_some((column as usize, row as usize));
        let one = Grid { origin: low, cell: side, columns: 1, rows: 1, grow: GROW };
        let own = self.of_shape(self.outer, self.cells.as_ref(), place, &one);
        match self.inner {
            None => own,
            Some(inner) => {
                let [_, least] = self.of_shape(inner, self.inner_cells.as_ref(), place, &one);
                [own[0], least.min(own[0])]
            }
        }
    }

    /// Of what lies under the top nothing is said: a touch begins there.
    fn of_shape(
        &self,
        shape: &Shape,
        cells: Option<&Cells>,
        place: Option<(usize, usize)>,
        one: &Grid,
    ) -> [f64; 2] {
        let heights = |cells: &Cells, (column, row): (usize, usize)| {
            let top = |spans: &[Span]| spans.last().map_or(self.bottom, |span| span.to);
            [top(cells.outer(column, row)), top(cells.inner(column, row))]
        };
        match (cells, place) {
            (Some(cells), Some(place)) => heights(cells, place),
            _ => match shape.cells(one) {
                Ok(cells) => heights(&cells, (0, 0)),
                // A cell without a size: nothing is sure.
                Err(_) => [shape.bounds().max.z, self.bottom],
            },
        }
    }

    /// What is removed and what is left of the shape, mm³, where it is hollow from below: the columns alone know
    /// nothing of that. `None` where it is not.
    pub fn volumes(&self, stock: &Stock) -> Option<[Amount; 2]> {
        let cells = self.cells.as_ref()?;
        let inner_cells = if self.inner.is_some() { self.inner_cells.as_ref()? } else { cells };
        let is_full = |spans: &[Span]| match spans {
            [] => true,
            [one] => one.from <= self.bottom + NEAR,
            _ => false,
        };
        let mut places =
            (0..self.grid.rows).flat_map(|row| (0..self.grid.columns).map(move |at| [at, row]));
        if places.all(|[column, row]| is_full(inner_cells.inner(column, row))) {
            return None;
        }
        let pairs = stock.height_pairs();
        let [mut removed, mut left] = [Amount::default(); 2];
        for (index, pair) in pairs.iter().enumerate() {
            let [columns, _] = stock.grid().cells();
            let (column, row) = (index % columns as usize, index / columns as usize);
            if column >= self.grid.columns || row >= self.grid.rows {
                continue;
            }
            let [low, high] = stock.grid().corners(column as u32, row as u32);
            let area = (high[0] - low[0]) * (high[1] - low[1]);
            let [outer, inner] = [cells.outer(column, row), inner_cells.inner(column, row)];
            // What undercuts may have removed besides, wherever it is.
            let gaps = gaps_of(stock, column as u32, row as u32);
            let most = area * below(outer, pair.outer);
            let least = area * (below(inner, pair.inner) - gaps).max(0.0);
            left.least += least;
            left.most += most;
            removed.least += (area * below(inner, f64::INFINITY) - most).max(0.0);
            removed.most += area * below(outer, f64::INFINITY) - least;
        }
        Some([removed, left])
    }
}

/// How much undercuts may have removed from a column below its heights, mm.
pub(super) fn gaps_of(stock: &Stock, column: u32, row: u32) -> f64 {
    if !stock.has_gaps() {
        return 0.0;
    }
    let [_, maybe] = stock.gaps_at(column, row);
    maybe.iter().map(|gap| gap.top - gap.floor).sum()
}

/// How much of some spans is below a height, mm.
fn below(spans: &[Span], height: f64) -> f64 {
    spans.iter().map(|span| (span.to.min(height) - span.from).max(0.0)).sum()
}

/// Cells are not wider than they are: the columns count their own rounding.
const GROW: f64 = 0.0;
/// A shape that begins so near the bottom stands on it, mm.
const NEAR: f64 = 1e-6;
