//! Heights of shapes over cells: what columns begin with.

use chordal_geometry::Aabb;
use chordal_stock::RemovedSpan as Hollow;
use chordal_stock::shape::{CellGrid, HeightSpan, ShapeCells, SolidShape};

/// The heights of a shape over cells of any size; those of one grid are computed once.
pub(super) struct ShapeHeights<'s> {
    /// A shape that contains the true one.
    outer: &'s SolidShape,
    /// A shape that the true one contains, where it is another.
    inner: Option<&'s SolidShape>,
    grid: CellGrid,
    cells: Option<ShapeCells>,
    inner_cells: Option<ShapeCells>,
    bottom: f64,
    is_hollow: bool,
}

impl<'s> ShapeHeights<'s> {
    /// With the cells of a resolution in the box of the shape, mm.
    pub fn new(shape: &'s SolidShape, resolution: f64) -> ShapeHeights<'s> {
        ShapeHeights::between([shape, shape], resolution)
    }

    /// For a shape that is known only between two: one that contains it, and one that it contains.
    pub fn between([shape, inner]: [&'s SolidShape; 2], resolution: f64) -> ShapeHeights<'s> {
        let inner = (!std::ptr::eq(shape, inner)).then_some(inner);
        let bounds = shape.bounds();
        let size = bounds.size();
        let count = |length: f64| (length / resolution).ceil().max(1.0) as usize;
        let grid = CellGrid {
            origin: [bounds.min.x, bounds.min.y],
            cell: resolution,
            columns: count(size.x),
            rows: count(size.y),
            grow: GROW,
        };
        let cells = shape.cells(&grid).ok();
        let inner_cells = inner.and_then(|inner| inner.cells(&grid).ok());
        let bottom = bounds.min.z;
        // Whether no cell has anything missing below its top. Cells of other sizes are then not examined for hollows
        // either.
        let is_full = |cells: &ShapeCells| {
            let places = (0..grid.rows).flat_map(|row| (0..grid.columns).map(move |at| [at, row]));
            places.into_iter().all(|[column, row]| match cells.inner(column, row) {
                [] => true,
                [one] => one.from <= bottom + ON_BOTTOM_MM,
                _ => false,
            })
        };
        let known = inner_cells.as_ref().or(cells.as_ref());
        let is_hollow = !known.is_some_and(is_full);
        ShapeHeights { outer: shape, inner, grid, cells, inner_cells, bottom, is_hollow }
    }

    /// The box around the shape.
    pub fn bounds(&self) -> Aabb {
        self.outer.bounds()
    }

    /// For a cell between two corners: a height above which there is nothing of the shape, and one below which the
    /// shape fills the cell, down to the bottom of its box unless it is hollow there, mm.
    pub fn of(&self, low: [f64; 2], high: [f64; 2]) -> [f64; 2] {
        let (place, one) = self.place(low, high);
        let own = self.of_shape(self.outer, self.cells.as_ref(), place, &one);
        match self.inner {
            None => own,
            Some(inner) => {
                let [_, least] = self.of_shape(inner, self.inner_cells.as_ref(), place, &one);
                [own[0], least.min(own[0])]
            }
        }
    }

    /// The cell of the grid between two corners, where it is one of the grid, and a grid of that cell alone.
    fn place(&self, low: [f64; 2], high: [f64; 2]) -> (Option<(usize, usize)>, CellGrid) {
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
        (place, CellGrid { origin: low, cell: side, columns: 1, rows: 1, grow: GROW })
    }

    /// The tops of outer and inner shape. Hollows below them are left out, since a tool first touches the top.
    fn of_shape(
        &self,
        shape: &SolidShape,
        cells: Option<&ShapeCells>,
        place: Option<(usize, usize)>,
        one: &CellGrid,
    ) -> [f64; 2] {
        let heights = |cells: &ShapeCells, (column, row): (usize, usize)| {
            let top = |spans: &[HeightSpan]| spans.last().map_or(self.bottom, |span| span.to);
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

    /// The intervals that the shape fills in a cell between two corners, from below, mm: those it fills anywhere in
    /// the cell, and those it fills everywhere in it.
    pub fn filled(&self, [low, high]: [[f64; 2]; 2]) -> [Vec<[f64; 2]>; 2] {
        let (place, one) = self.place(low, high);
        let of = |cells: &ShapeCells, (column, row): (usize, usize)| {
            [cells.outer(column, row), cells.inner(column, row)].map(|spans| {
                let spans = spans.iter().map(|span| [span.from.max(self.bottom), span.to]);
                spans.filter(|[from, to]| from < to).collect::<Vec<[f64; 2]>>()
            })
        };
        let both = |shape: &SolidShape, cells: Option<&ShapeCells>| match (cells, place) {
            (Some(cells), Some(place)) => of(cells, place),
            _ => match shape.cells(&one) {
                Ok(cells) => of(&cells, (0, 0)),
                // A cell without a size: nothing is sure.
                Err(_) => [vec![[self.bottom, shape.bounds().max.z]], Vec::new()],
            },
        };
        let [outer, inner] = both(self.outer, self.cells.as_ref());
        match self.inner {
            None => [outer, inner],
            Some(shape) => {
                let [_, inner] = both(shape, self.inner_cells.as_ref());
                [outer, inner]
            }
        }
    }

    /// The hollows of a cell between two corners below its tops: those certain in all of the cell, and those possible
    /// anywhere in it.
    pub fn hollows(&self, corners: [[f64; 2]; 2]) -> [Vec<Hollow>; 2] {
        if !self.is_hollow {
            return [Vec::new(), Vec::new()];
        }
        self.filled(corners).map(|filled| {
            let mut from = self.bottom;
            let mut hollows = Vec::new();
            for [floor, top] in filled {
                if floor > from + ON_BOTTOM_MM {
                    hollows.push(Hollow { floor: from, top: floor });
                }
                from = top;
            }
            hollows
        })
    }

    /// Whether some cell is hollow below its top.
    pub fn is_hollow(&self) -> bool {
        self.is_hollow
    }
}

/// Cells are not widened: the columns allow for their own rounding.
const GROW: f64 = 0.0;
/// A shape that begins within this of the bottom stands on it, mm.
const ON_BOTTOM_MM: f64 = 1e-6;
