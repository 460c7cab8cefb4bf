//! What a shape fills over the cells of a grid: for each cell what it may fill anywhere in it (outer bound), and what
//! it fills everywhere in it (inner bound).

use chordal_geometry::Aabb;

use super::{ShapeError, ShapeKind, SolidShape};
use crate::mesh::MAX_COORDINATE_MM;

/// By how much a cell that does not grow is inset from its edges, mm. So a wall on the edge of a cell, up to
/// rounding, belongs to one cell only.
pub const EDGE: f64 = 2e-9;

/// Square cells.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CellGrid {
    /// The corner with the lowest x and y, mm.
    pub origin: [f64; 2],
    /// The side of a cell, mm.
    pub cell: f64,
    /// How many cells there are along X.
    pub columns: usize,
    /// How many cells there are along Y.
    pub rows: usize,
    /// Each cell is enlarged by this on every side, mm, for bounds that must hold around it, too. From [`EDGE`] on
    /// the cells leave no gaps.
    pub grow: f64,
}

/// From one height to another, mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HeightSpan {
    /// The lower one.
    pub from: f64,
    /// The higher one.
    pub to: f64,
}

/// A rectangle along the axes, mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct CellRect {
    pub x: HeightSpan,
    pub y: HeightSpan,
}

impl CellGrid {
    /// The rectangle for which a cell's bounds are computed: half of [`EDGE`] is left for rounding in what follows.
    pub(super) fn rect(&self, column: usize, row: usize) -> CellRect {
        CellRect { x: self.strip(0, column), y: self.strip(1, row) }
    }

    /// The strip of the cells with one index along X (0) or Y (1).
    pub(super) fn strip(&self, axis: usize, number: usize) -> HeightSpan {
        let out = self.grow - EDGE / 2.0;
        let at = |number: usize| self.origin[axis] + number as f64 * self.cell;
        HeightSpan { from: at(number) - out, to: at(number + 1) + out }
    }

    /// The middle of the cells with one index along X (0) or Y (1), mm.
    pub(super) fn middle(&self, axis: usize, number: usize) -> f64 {
        self.origin[axis] + (number as f64 + 0.5) * self.cell
    }

    /// The cells of a row whose strips may reach into a span along X: the first, and the one after the last.
    pub(super) fn reached(&self, span: HeightSpan) -> [usize; 2] {
        let cell = |value: f64| (value - self.origin[0]) / self.cell;
        // EDGE is more than rounding; the casts saturate.
        let out = self.grow + EDGE;
        let first = cell(span.from - out).floor().max(0.0) as usize;
        let after = (cell(span.to + out).floor() + 1.0).max(0.0) as usize;
        [first.min(self.columns), after.min(self.columns)]
    }

    fn check(&self) -> Result<(), ShapeError> {
        let CellGrid { columns, rows, cell, .. } = *self;
        let counted = columns.checked_mul(rows).is_some_and(|count| count < u32::MAX as usize);
        let reach = columns.max(rows) as f64 * cell + self.grow;
        let near = self.origin.iter().all(|from| from.abs() + reach <= MAX_COORDINATE_MM);
        // A cell must be wider than its inset.
        let good = cell > 4.0 * EDGE && self.grow >= 0.0 && near;
        if counted && good { Ok(()) } else { Err(ShapeError::Grid { columns, rows, cell }) }
    }
}

/// Lists of spans, one for each cell.
#[derive(Clone, Debug, Default, PartialEq)]
struct SpanLists {
    /// The end of each cell's list in `spans`.
    ends: Vec<usize>,
    spans: Vec<HeightSpan>,
}

impl SpanLists {
    fn at(&self, cell: usize) -> &[HeightSpan] {
        let from = cell.checked_sub(1).map_or(0, |before| self.ends[before]);
        &self.spans[from..self.ends[cell]]
    }
}

/// What a shape fills over the cells of a grid.
#[derive(Clone, Debug, PartialEq)]
pub struct ShapeCells {
    columns: usize,
    outer: SpanLists,
    inner: SpanLists,
}

impl ShapeCells {
    /// What the shape may fill anywhere in the cell: disjoint spans, from the lowest.
    ///
    /// # Panics
    /// When the grid has no such cell.
    pub fn outer(&self, column: usize, row: usize) -> &[HeightSpan] {
        self.outer.at(row * self.columns + column)
    }

    /// What the shape fills everywhere in the cell: disjoint spans, from the lowest.
    ///
    /// # Panics
    /// When the grid has no such cell.
    pub fn inner(&self, column: usize, row: usize) -> &[HeightSpan] {
        self.inner.at(row * self.columns + column)
    }
}

/// Collects the lists of one cell after the other.
pub(super) struct CellFiller {
    cells: ShapeCells,
}

impl CellFiller {
    pub(super) fn new(grid: &CellGrid) -> CellFiller {
        let lists = || SpanLists {
            ends: Vec::with_capacity(grid.columns * grid.rows),
            spans: Vec::with_capacity(grid.columns * grid.rows),
        };
        CellFiller { cells: ShapeCells { columns: grid.columns, outer: lists(), inner: lists() } }
    }

    /// Adds what the current cell may be filled with.
    pub(super) fn outer(&mut self, span: HeightSpan) {
        self.cells.outer.spans.push(span);
    }

    /// Adds what the current cell is certainly filled with.
    pub(super) fn inner(&mut self, span: HeightSpan) {
        self.cells.inner.spans.push(span);
    }

    /// Ends the lists of a cell.
    pub(super) fn end_cell(&mut self) {
        for lists in [&mut self.cells.outer, &mut self.cells.inner] {
            lists.ends.push(lists.spans.len());
        }
    }

    pub(super) fn cells(self) -> ShapeCells {
        self.cells
    }
}

impl SolidShape {
    /// What the shape fills over the cells of a grid, with an outer and an inner bound for each cell.
    ///
    /// For a box and a vertical cylinder the heights are exact; the bounds differ for lying cylinders, slopes and
    /// walls within a cell. They hold at every point of a cell that is at least [`EDGE`] minus `grow` inside its
    /// edge.
    ///
    /// # Errors When the grid has too many cells or invalid numbers, or the shape is a mesh that is not closed or has
    /// too many triangles above each other.
    pub fn cells(&self, grid: &CellGrid) -> Result<ShapeCells, ShapeError> {
        grid.check()?;
        let mut filler = CellFiller::new(grid);
        let mut each = |fill: &dyn Fn(CellRect, &mut CellFiller)| {
            for row in 0..grid.rows {
                for column in 0..grid.columns {
                    fill(grid.rect(column, row), &mut filler);
                    filler.end_cell();
                }
            }
        };
        match &self.0 {
            ShapeKind::Cuboid(around) => each(&|rect, filler| fill_box(around, rect, filler)),
            ShapeKind::Round(round) => each(&|rect, filler| round.fill(rect, filler)),
            ShapeKind::Meshed(meshed) if meshed.edges.are_closed() => {
                meshed.fill(grid, &mut filler)?
            }
            ShapeKind::Meshed(meshed) => return Err(ShapeError::Open { edges: meshed.edges }),
        }
        Ok(filler.cells())
    }
}

impl HeightSpan {
    pub(super) fn overlaps(self, other: HeightSpan) -> bool {
        self.from < other.to && other.from < self.to
    }

    pub(super) fn contains(self, other: HeightSpan) -> bool {
        self.from <= other.from && other.to <= self.to
    }
}

fn fill_box(around: &Aabb, rect: CellRect, filler: &mut CellFiller) {
    let side = |axis: usize| HeightSpan {
        from: around.min.component(axis),
        to: around.max.component(axis),
    };
    if side(0).overlaps(rect.x) && side(1).overlaps(rect.y) {
        filler.outer(side(2));
    }
    if side(0).contains(rect.x) && side(1).contains(rect.y) {
        filler.inner(side(2));
    }
}
