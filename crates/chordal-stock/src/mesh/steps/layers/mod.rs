//! A closed surface around columns with gaps: flat tops and undersides, vertical walls.
//!
//! Like a [`HeightField`](super::HeightField), but a column may have several intervals. Tops are at multiples of
//! [`STEP`], and undersides halfway between them: so no top touches an underside in an edge, and every edge has two
//! triangles. Where two columns touch in a vertical edge, there are two vertices at each of its ends, and another
//! pair between them.

mod build;
mod corner;
mod cover;

use chordal_geometry::Vec3;

use super::{HeightField, HeightFieldError, HeightMesh, PlanGrid};
use crate::mesh::MAX_COORDINATE_MM;

/// Tops are at multiples of this, mm: 32-bit floats can represent half of it up to four metres.
pub(super) const STEP: f64 = 1.0 / 1024.0;

/// The intervals of material of all columns.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SolidIntervals {
    /// The end of each column in `all`.
    ends: Vec<usize>,
    all: Vec<[f64; 2]>,
}

impl SolidIntervals {
    /// Adds a column: its intervals of material as pairs of heights, mm, from the lowest.
    pub fn push(&mut self, column: impl IntoIterator<Item = [f64; 2]>) {
        self.all.extend(column);
        self.ends.push(self.all.len());
    }

    /// Number of columns.
    pub fn len(&self) -> usize {
        self.ends.len()
    }

    /// Whether there is no column.
    pub fn is_empty(&self) -> bool {
        self.ends.is_empty()
    }

    /// The intervals of the column with this number, from the lowest, mm.
    ///
    /// # Panics
    /// When there is no such column.
    pub fn of(&self, column: usize) -> &[[f64; 2]] {
        &self.all[self.range(column)]
    }

    /// The indices of a column's intervals.
    fn range(&self, column: usize) -> std::ops::Range<usize> {
        let from = column.checked_sub(1).map_or(0, |before| self.ends[before]);
        from..self.ends[column]
    }

    /// The total length of all intervals, mm.
    pub fn length(&self) -> f64 {
        self.all.iter().map(|[from, to]| to - from).sum()
    }
}

/// Columns with several intervals over a grid of square cells, row by row.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LayerField<'a> {
    /// The corner of the grid with the lowest x and y, and the zero of the heights, mm. There is no material below.
    pub origin: Vec3,
    /// The side of a cell, mm.
    pub cell: f64,
    /// How many cells there are along X.
    pub columns: usize,
    /// How many cells there are along Y.
    pub rows: usize,
    /// Size of the grid along X and along Y, mm. The last cells end there, and may be narrower than the others.
    pub size: [f64; 2],
    /// The intervals, with heights above the origin: row by row, that with the lowest y first.
    pub intervals: &'a SolidIntervals,
}

impl LayerField<'_> {
    /// The closed surface, in which no top and no underside differs from that of its cell by more than `tolerance`
    /// plus 0.001, mm. Intervals and gaps that are thinner than twice that are left out.
    ///
    /// # Errors When the grid or a height is not valid.
    pub fn mesh(&self, tolerance: f64) -> Result<HeightMesh, HeightFieldError> {
        self.check(tolerance)?;
        let thick = self.without_thin(2.0 * (tolerance + STEP));
        let cover = cover::LayerCover::new(self, &thick, tolerance);
        let (mesh, touching) = build::LayerBuilder::new(self, &cover).mesh();
        Ok(HeightMesh { mesh, deviation: cover.deviation, touching })
    }

    /// The volume of the columns, mm³.
    pub fn volume(&self) -> f64 {
        let solid = |cell: usize| self.intervals.of(cell).iter().map(|[from, to]| to - from).sum();
        self.plan().integral(solid)
    }

    fn plan(&self) -> PlanGrid {
        let LayerField { origin, cell, columns, rows, size, .. } = *self;
        PlanGrid { origin, cell, cells: [columns, rows], size }
    }

    fn check(&self, tolerance: f64) -> Result<(), HeightFieldError> {
        let LayerField { columns, rows, intervals, .. } = *self;
        // The check of a height field serves for the grid.
        let flat = HeightField {
            origin: self.origin,
            cell: self.cell,
            columns,
            rows,
            size: self.size,
            heights: &vec![0.0; intervals.len()],
            floor: 0.0,
        };
        flat.check(tolerance)?;
        let good = |height: f64| height >= 0.0 && self.origin.z + height <= MAX_COORDINATE_MM;
        for cell in 0..intervals.len() {
            let bad = intervals.of(cell).iter().flatten().find(|height| !good(**height));
            if let Some(&value) = bad {
                let (column, row) = (cell % columns, cell / columns);
                return Err(HeightFieldError::Height { column, row, value: value as f32 });
            }
        }
        Ok(())
    }

    /// The intervals without gaps and intervals thinner than `least`, mm.
    fn without_thin(&self, least: f64) -> SolidIntervals {
        let mut kept = SolidIntervals::default();
        let mut column: Vec<[f64; 2]> = Vec::new();
        for cell in 0..self.intervals.len() {
            column.clear();
            for &[from, to] in self.intervals.of(cell) {
                match column.last_mut() {
                    Some(last) if from - last[1] < least => last[1] = last[1].max(to),
                    _ => column.push([from, to]),
                }
            }
            column.retain(|[from, to]| to - from >= least);
            kept.push(column.iter().copied());
        }
        kept
    }
}
