//! A closed surface around columns with gaps: flat tops and undersides, upright walls.
//!
//! As a [`HeightField`](super::HeightField), but a column may have several stretches. Tops have heights in steps of
//! [`STEP`], undersides lie half a step between them: so no top touches an underside in an edge, and every edge has
//! two triangles. Where two columns touch in an upright edge, its ends are two vertices each, and one more pair
//! between them.

mod build;
mod corner;
mod cover;

use chordal_geometry::Vec3;

use super::{HeightField, HeightFieldError, HeightMesh, PlanGrid};
use crate::mesh::MAX_COORDINATE_MM;

/// Tops have heights in such steps, mm: files of floats of 32 bits tell half of one apart up to four metres.
pub(super) const STEP: f64 = 1.0 / 1024.0;

/// The stretches of columns, one column after the other.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SolidIntervals {
    /// Where the stretches of each column end.
    ends: Vec<usize>,
    all: Vec<[f64; 2]>,
}

impl SolidIntervals {
    /// Adds a column: its stretches of material, each from a height to another, mm, from the lowest.
    pub fn push(&mut self, column: impl IntoIterator<Item = [f64; 2]>) {
        self.all.extend(column);
        self.ends.push(self.all.len());
    }

    /// How many columns there are.
    pub fn len(&self) -> usize {
        self.ends.len()
    }

    /// Whether there is no column.
    pub fn is_empty(&self) -> bool {
        self.ends.is_empty()
    }

    /// The stretches of a column by its number, from the lowest, mm.
    ///
    /// # Panics
    /// When there is no such column.
    pub fn of(&self, column: usize) -> &[[f64; 2]] {
        &self.all[self.range(column)]
    }

    /// The places of a column's stretches among all.
    fn range(&self, column: usize) -> std::ops::Range<usize> {
        let from = column.checked_sub(1).map_or(0, |before| self.ends[before]);
        from..self.ends[column]
    }

    /// How long all stretches are together, mm.
    pub fn length(&self) -> f64 {
        self.all.iter().map(|[from, to]| to - from).sum()
    }
}

/// Columns of several stretches over a grid of square cells, row by row.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LayerField<'a> {
    /// The corner of the grid with the lowest x and y, and the zero of the heights, mm. Nothing is below.
    pub origin: Vec3,
    /// The side of a cell, mm.
    pub cell: f64,
    /// How many cells there are along X.
    pub columns: usize,
    /// How many cells there are along Y.
    pub rows: usize,
    /// How far the grid reaches along X and along Y, mm: there the last cells end, at their sides at the latest.
    pub size: [f64; 2],
    /// The stretches above the origin: `columns` of the lowest row first.
    pub intervals: &'a SolidIntervals,
}

impl LayerField<'_> {
    /// The closed surface, in which no top and no underside is further from that of its cell than `tolerance` and a
    /// thousandth, mm. Stretches and gaps that are thinner than twice that are left out.
    ///
    /// # Errors
    /// When the grid is none, or a height is no number.
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
        // The grid, without the heights that it would have.
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

    /// The stretches of each column, of which neither they nor the gaps between them are thinner than so much, mm.
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
