//! A closed surface around columns of given heights: flat tops, vertical walls, a flat bottom.
//!
//! Each column is a prism over its cell, so the volume is the sum of the columns, and a wall stays a wall. Columns of
//! nearly one height are first joined to rectangles ([`cover`]); a rectangle has the mean height of its columns,
//! which keeps the volume. The vertices at a corner of cells are chosen ([`node`]) so that every edge of the result
//! has two triangles, even where two columns touch only in a vertical edge.
//!
//! A body with several intervals in a column is a [`LayerField`]: the same, with the undersides of gaps.

mod build;
mod cover;
mod layers;
mod node;

use chordal_geometry::Vec3;

use super::{MAX_COORDINATE_MM, Mesh};

pub use layers::{LayerField, SolidIntervals};

/// Heights over a grid of square cells, row by row: the top of the body over each cell.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HeightField<'a> {
    /// The corner of the grid with the lowest x and y, and the zero of the heights, mm.
    pub origin: Vec3,
    /// The side of a cell, mm.
    pub cell: f64,
    /// How many cells there are along X.
    pub columns: usize,
    /// How many cells there are along Y.
    pub rows: usize,
    /// Size of the grid along X and along Y, mm. The last cells end there, and may be narrower than the others.
    pub size: [f64; 2],
    /// The heights, mm above the origin: row by row, that with the lowest y first.
    pub heights: &'a [f32],
    /// The bottom, mm above the origin. A cell that is not higher is a hole.
    pub floor: f32,
}

/// The surface of a height field.
#[derive(Clone, Debug, PartialEq)]
pub struct HeightMesh {
    /// The closed mesh, in which each edge has two triangles; empty when every cell is a hole.
    pub mesh: Mesh,
    /// The largest difference between the height of a cell and that of the surface, mm.
    pub deviation: f64,
    touching: Vec<TouchingVertex>,
}

/// A vertex of a column that touches another one in a vertical edge.
#[derive(Clone, Copy, Debug, PartialEq)]
struct TouchingVertex {
    vertex: u32,
    /// The direction to its own column, along X and Y.
    toward: [i8; 2],
}

impl HeightMesh {
    /// The mesh with columns that touch in a vertical edge moved apart there, each by `gap` along X and Y, mm.
    ///
    /// For formats that do not share vertices (STL): their readers merge two vertices at one place, and would find
    /// edges with four triangles. It takes a little volume along these edges; `gap` must be small compared with a
    /// cell, and larger than the rounding of the format.
    #[must_use]
    pub fn parted(mut self, gap: f64) -> Mesh {
        for TouchingVertex { vertex, toward: [x, y] } in self.touching {
            let path = Vec3::new(f64::from(x), f64::from(y), 0.0);
            self.mesh.vertices[vertex as usize] += path * gap;
        }
        self.mesh
    }
}

/// Why there is no surface.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum HeightFieldError {
    /// The number of heights is not that of the cells.
    #[error("{found} heights for {columns} × {rows} cells")]
    Count {
        /// How many heights there are.
        found: usize,
        /// Cells along X.
        columns: usize,
        /// Cells along Y.
        rows: usize,
    },
    /// Too many cells to number the vertices.
    #[error("{columns} × {rows} cells are too many for one mesh")]
    TooMany {
        /// Cells along X.
        columns: usize,
        /// Cells along Y.
        rows: usize,
    },
    /// A height is NaN, or above the largest coordinate.
    #[error("the cell of column {column} and row {row} has the height {value} mm")]
    Height {
        /// The cell along X, from zero.
        column: usize,
        /// The cell along Y, from zero.
        row: usize,
        /// Its height, mm.
        value: f32,
    },
    /// A dimension of the field is not valid.
    #[error("the {what} cannot be {value} mm")]
    Dimension {
        /// What it is.
        what: &'static str,
        /// Its value, mm.
        value: f64,
    },
}

/// The cells of a field may be shorter in total than its size by this share, for rounding.
const SIZE_ROUNDING_SHARE: f64 = 1e-9;
/// Least width of a last cell as a share of a cell; the one before is shortened for it. So columns that touch can be
/// moved apart, and 32-bit floats keep its corners distinct.
const NARROWEST: f64 = 0.01;

/// A grid of cells in plan.
#[derive(Clone, Copy)]
struct PlanGrid {
    origin: Vec3,
    cell: f64,
    cells: [usize; 2],
    size: [f64; 2],
}

impl PlanGrid {
    /// The distance of a corner from the first one along an axis, mm.
    fn along(&self, axis: usize, corner: usize) -> f64 {
        if corner >= self.cells[axis] {
            return self.size[axis];
        }
        let is_last = corner > 0 && corner + 1 == self.cells[axis];
        let most = if is_last { self.size[axis] - NARROWEST * self.cell } else { self.size[axis] };
        (corner as f64 * self.cell).min(most).max(0.0)
    }

    /// The point at a corner and a height, mm.
    fn point(&self, [column, row]: [usize; 2], height: f64) -> Vec3 {
        self.origin + Vec3::new(self.along(0, column), self.along(1, row), height)
    }

    /// The sum of a value over all cells, weighted by their areas.
    fn integral(&self, value: impl Fn(usize) -> f64) -> f64 {
        let [columns, rows] = self.cells;
        let width = |axis: usize, at: usize| self.along(axis, at + 1) - self.along(axis, at);
        let of_row = |row: usize| {
            let of_cell = |column: usize| width(0, column) * value(row * columns + column);
            width(1, row) * (0..columns).map(of_cell).sum::<f64>()
        };
        (0..rows).map(of_row).sum()
    }
}

impl HeightField<'_> {
    /// The closed surface, which differs from the height of no cell by more than `tolerance`, mm. With zero only
    /// cells of equal height are joined. The volume is that of the columns, up to half of 2⁻¹⁶ mm over the last of
    /// the joined faces.
    ///
    /// # Errors When the grid or a height is not valid.
    pub fn mesh(&self, tolerance: f64) -> Result<HeightMesh, HeightFieldError> {
        self.check(tolerance)?;
        let tops = cover::RectangleCover::of_tops(self, tolerance);
        let bottoms = cover::RectangleCover::of_bottoms(self);
        let (mesh, touching) = build::StepBuilder::new(self, &tops, &bottoms).mesh();
        Ok(HeightMesh { mesh, deviation: tops.deviation, touching })
    }

    /// The volume of the columns, mm³.
    pub fn volume(&self) -> f64 {
        let floor = f64::from(self.floor);
        let solid = |cell: usize| (f64::from(self.heights[cell]) - floor).max(0.0);
        self.plan().integral(solid)
    }

    fn plan(&self) -> PlanGrid {
        let HeightField { origin, cell, columns, rows, size, .. } = *self;
        PlanGrid { origin, cell, cells: [columns, rows], size }
    }

    /// The height of a cell, mm above the origin; that of the bottom for a hole.
    fn height(&self, column: usize, row: usize) -> f64 {
        f64::from(self.heights[row * self.columns + column].max(self.floor))
    }

    pub(super) fn check(&self, tolerance: f64) -> Result<(), HeightFieldError> {
        let HeightField { columns, rows, size, .. } = *self;
        let found = self.heights.len();
        if columns.checked_mul(rows) != Some(found) {
            return Err(HeightFieldError::Count { found, columns, rows });
        }
        // Each corner has at most five levels (four tops and the bottom) with two vertices each.
        const MAX_CELLS: usize = u32::MAX as usize / 10;
        if (columns + 1).saturating_mul(rows + 1) > MAX_CELLS {
            return Err(HeightFieldError::TooMany { columns, rows });
        }
        let at_least_zero = tolerance >= 0.0 && tolerance.is_finite();
        let reach = columns.max(rows) as f64 * self.cell;
        let within = self.cell > 0.0 && reach <= MAX_COORDINATE_MM;
        let floor = f64::from(self.floor);
        let near = |from: f64| from.abs() + reach <= MAX_COORDINATE_MM;
        let HeightField { origin: Vec3 { x, y, .. }, .. } = *self;
        // The last cells may be narrower, but must have a width.
        let ends = |cells: usize, size: f64| {
            let whole = cells as f64 * self.cell;
            size <= whole * (1.0 + SIZE_ROUNDING_SHARE) && (cells == 0 || size > whole - self.cell)
        };
        for (what, value, good) in [
            ("origin", x, near(x)),
            ("origin", y, near(y)),
            ("tolerance", tolerance, at_least_zero),
            ("cell", self.cell, within),
            ("size", size[0], ends(columns, size[0])),
            ("size", size[1], ends(rows, size[1])),
            ("bottom", floor, (self.origin.z + floor).abs() <= MAX_COORDINATE_MM),
        ] {
            if !good {
                return Err(HeightFieldError::Dimension { what, value });
            }
        }
        // Minus infinity is a missing column.
        let good = |value: f32| self.origin.z + f64::from(value) <= MAX_COORDINATE_MM;
        match self.heights.iter().position(|&value| !good(value)) {
            Some(at) => {
                let (column, row) = (at % columns, at / columns);
                Err(HeightFieldError::Height { column, row, value: self.heights[at] })
            }
            None => Ok(()),
        }
    }
}
