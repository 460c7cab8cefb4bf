//! A mesh as a shape: what its inside fills over cells, and whether a point is inside.
//!
//! Over a cell the triangles clipped to it take bands of heights. Between two bands there is no surface, so all of
//! the cell is inside there, or none of it. Which of the two is found by counting crossings of the surface on a
//! vertical line at the middle of the cell (winding number).

use chordal_geometry::{Aabb, Vec3};

use super::ShapeError;
use super::cells::{CellFiller, CellGrid, CellRect, HeightSpan};
use super::clip::FlatPolygon;
use super::tree::TriangleTree;
use crate::mesh::{Edges, Mesh};

#[derive(Clone, Debug)]
pub(super) struct MeshedShape {
    pub mesh: Mesh,
    pub edges: Edges,
    pub tree: TriangleTree,
}

/// Most triangles over the cells of a row, each counted once for every cell: about a gigabyte of memory.
const MAX_BANDS: usize = 1 << 24;

/// The range of heights of a triangle over a cell of a row.
#[derive(Clone, Copy, Debug)]
struct TriangleBand {
    column: usize,
    heights: HeightSpan,
    /// The crossing of the vertical line at the middle of the cell, upwards: 1 from inside to outside, −1 from
    /// outside to inside, 0 for none.
    outward: i32,
}

impl MeshedShape {
    pub(super) fn new(mesh: Mesh, edges: Edges) -> MeshedShape {
        let tree = TriangleTree::new(&mesh);
        MeshedShape { mesh, edges, tree }
    }

    /// Fills the cells row by row, so that only one row is in memory.
    pub(super) fn fill(&self, grid: &CellGrid, filler: &mut CellFiller) -> Result<(), ShapeError> {
        let mut bands = Vec::new();
        for row in 0..grid.rows {
            bands.clear();
            self.bands(grid, row, &mut bands)?;
            bands.sort_unstable_by(|a, b| {
                a.column.cmp(&b.column).then(a.heights.from.total_cmp(&b.heights.from))
            });
            let mut rest = bands.as_slice();
            for column in 0..grid.columns {
                let count = rest.iter().take_while(|band| band.column == column).count();
                fill_cell(&rest[..count], filler);
                filler.end_cell();
                rest = &rest[count..];
            }
        }
        Ok(())
    }

    fn bands(
        &self,
        grid: &CellGrid,
        row: usize,
        bands: &mut Vec<TriangleBand>,
    ) -> Result<(), ShapeError> {
        let Some(last) = grid.columns.checked_sub(1) else { return Ok(()) };
        let CellRect { x: HeightSpan { from, .. }, y } = grid.rect(0, row);
        let x = HeightSpan { from, to: grid.strip(0, last).to };
        let reaches = |around: &Aabb| {
            around.min.x <= x.to
                && around.max.x >= x.from
                && around.min.y <= y.to
                && around.max.y >= y.from
        };
        self.tree.each(reaches, |triangle| {
            if bands.len() <= MAX_BANDS {
                self.bands_of(triangle, grid, row, bands);
            }
        });
        if bands.len() > MAX_BANDS { Err(ShapeError::TooManyTriangles { row }) } else { Ok(()) }
    }

    fn bands_of(
        &self,
        triangle: usize,
        grid: &CellGrid,
        row: usize,
        bands: &mut Vec<TriangleBand>,
    ) {
        let whole = FlatPolygon::of_triangle(self.mesh.corners(triangle));
        let heights = whole.range(2);
        // Bound of the rounding error of a height between two corners.
        let pad = 4.0 * f64::EPSILON * heights.from.abs().max(heights.to.abs());
        let padded = |part: HeightSpan| HeightSpan {
            from: (part.from - pad).max(heights.from),
            to: (part.to + pad).min(heights.to),
        };
        let strip = whole.within(1, grid.strip(1, row));
        let crossings = self.crossings(triangle, grid.middle(1, row));
        let mut reach = strip.range(0);
        for crossing in crossings.iter().flatten() {
            reach.from = reach.from.min(crossing.x);
            reach.to = reach.to.max(crossing.x);
        }
        if reach.from > reach.to {
            return;
        }
        let [left, right] = grid.reached(reach);
        for column in left..right {
            let outward = outward(&crossings, grid.middle(0, column));
            let part = strip.within(0, grid.strip(0, column));
            let heights = if !part.is_empty() {
                padded(part.range(2))
            } else if outward != 0 {
                // The clipped part is so thin that rounding decides whether it exists: all of the triangle counts.
                heights
            } else {
                continue;
            };
            bands.push(TriangleBand { column, heights, outward });
        }
    }

    /// Where the sides of a triangle cross a line along X, seen from above.
    fn crossings(&self, triangle: usize, y: f64) -> [Option<SideCrossing>; 3] {
        let [a, b, c] = self.mesh.triangles()[triangle];
        [(a, b), (b, c), (c, a)].map(|(from, to)| {
            // Two triangles with a common side compute it from the same end, so that they agree to the bit.
            let [low, high] =
                [from.min(to), from.max(to)].map(|vertex| self.mesh.vertices()[vertex as usize]);
            let (below, above) = (low.y <= y, high.y <= y);
            (below != above).then(|| {
                let t = (y - low.y) / (high.y - low.y);
                let up = below == (from < to);
                let x = low.x + t * (high.x - low.x);
                // Clamped to the box of the triangle, by which the tree excludes triangles.
                SideCrossing { x: x.clamp(low.x.min(high.x), low.x.max(high.x)), up }
            })
        })
    }

    /// Whether a point is inside a closed mesh; for a point on the surface the result is undefined.
    pub(super) fn contains(&self, place: Vec3) -> bool {
        if !self.edges.are_closed() {
            return false;
        }
        let Vec3 { x, y, z } = place;
        let reaches = |around: &Aabb| {
            around.min.x <= x
                && around.max.x >= x
                && around.min.y <= y
                && around.max.y >= y
                && around.max.z >= z
        };
        let mut winding = 0;
        self.tree.each(reaches, |triangle| {
            let outward = outward(&self.crossings(triangle, y), x);
            if outward != 0 {
                let corners = self.mesh.corners(triangle);
                let heights = FlatPolygon::of_triangle(corners).range(2);
                let [a, b, c] = corners;
                let normal = (b - a).cross(c - a);
                // The point is below the plane of the triangle.
                let below = (place - a).dot(normal) * normal.z < 0.0;
                if z < heights.from || (z <= heights.to && below) {
                    winding += outward;
                }
            }
        });
        winding != 0
    }
}

/// Where a side crosses a line along X.
#[derive(Clone, Copy, Debug)]
struct SideCrossing {
    x: f64,
    /// Whether the side runs towards higher y.
    up: bool,
}

/// 1 where a point is within an upward-facing triangle in plan, −1 for a downward-facing one, 0 outside.
fn outward(crossings: &[Option<SideCrossing>; 3], x: f64) -> i32 {
    let beyond = crossings.iter().flatten().filter(|crossing| crossing.x > x);
    beyond.map(|crossing| if crossing.up { 1 } else { -1 }).sum()
}

/// Makes the lists of a cell from its bands, sorted by their lower ends.
fn fill_cell(bands: &[TriangleBand], filler: &mut CellFiller) {
    let mut filled: Option<HeightSpan> = None;
    let mut winding = 0;
    let mut at = 0;
    while let Some(first) = bands.get(at) {
        // Overlapping bands are merged.
        let mut band = first.heights;
        while let Some(next) = bands.get(at).filter(|next| next.heights.from <= band.to) {
            band.to = band.to.max(next.heights.to);
            winding -= next.outward;
            at += 1;
        }
        let span = filled.get_or_insert(band);
        span.to = band.to;
        let above = bands.get(at).filter(|_| winding != 0);
        match above {
            Some(next) => filler.inner(HeightSpan { from: band.to, to: next.heights.from }),
            None => filler.outer(*span),
        }
        if above.is_none() {
            filled = None;
        }
    }
}
