//! A closed surface through the middles of columns, with large triangles where it is flat.
//!
//! The corners are the middles of cells, with a ring of corners at the bottom around them, which makes the walls. A
//! square of corners is halved along its diagonal, and each triangle is halved again, down to single cells, until no
//! cell is further from its triangle than the tolerance (longest-edge bisection). Triangles that share a long edge
//! are halved together, which keeps the surface closed. Where a cell is cut through, the surface ends at the bottom.

use std::collections::BTreeMap;

use chordal_geometry::Vec3;

use super::steps::{HeightField, HeightFieldError};
use super::weld::VertexWelder;
use super::{Mesh, MeshError};

/// Why there is no such surface.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum SmoothError {
    /// The height field is not valid.
    #[error(transparent)]
    Field(#[from] HeightFieldError),
    /// More vertices than a mesh can have.
    #[error(transparent)]
    Mesh(#[from] MeshError),
    /// Holes touch in too many edges.
    #[error("the surface through the columns touches itself; the one with steps does not")]
    Touches,
    /// There is only one row or column, and no surface between its middles.
    #[error("the surface needs two columns along X and along Y")]
    Narrow,
}

/// A corner, by column and row of the grid with the ring.
type GridCorner = [u32; 2];

/// Height to which corners where holes touch are filled, mm: far below any tolerance, and more than the rounding of
/// 32-bit floats.
const FILLED: f64 = 1e-3;
/// How often corners are filled before the surface is given up.
const MAX_FILL_ROUNDS: usize = 16;

impl HeightField<'_> {
    /// The closed surface through the middles of the cells, from which no cell's height is further than `tolerance`,
    /// mm, along Z. Walls are as wide as a cell.
    ///
    /// # Errors When the grid or a height is not valid, or the surface would touch itself.
    pub fn smooth(&self, tolerance: f64) -> Result<Mesh, SmoothError> {
        self.check(tolerance)?;
        if self.columns < 2 || self.rows < 2 {
            return Err(SmoothError::Narrow);
        }
        let mut grid = SurfaceCorners::of(self, tolerance);
        for _ in 0..MAX_FILL_ROUNDS {
            let top = grid.triangles(true);
            let touching = grid.touching(&top);
            if touching.is_empty() {
                let mesh = grid.mesh(&top, &grid.triangles(false))?;
                return if mesh.edges().are_closed() {
                    Ok(mesh)
                } else {
                    Err(SmoothError::Touches)
                };
            }
            for at in touching {
                grid.fill(at);
            }
        }
        Err(SmoothError::Touches)
    }
}

/// The corners of the surface.
struct SurfaceCorners {
    x: Vec<f64>,
    y: Vec<f64>,
    /// Heights row by row, mm; `None` for a hole and for the ring.
    z: Vec<Option<f64>>,
    bottom: f64,
    /// Cells along a side of the root square, a power of two.
    side: u32,
    tolerance: f64,
}

impl SurfaceCorners {
    fn of(field: &HeightField<'_>, tolerance: f64) -> SurfaceCorners {
        let HeightField { origin, cell, columns, rows, size, .. } = *field;
        let along = |from: f64, count: usize, size: f64| -> Vec<f64> {
            let place = |at: usize| match at {
                0 | 1 => 0.0,
                _ if at >= count => size,
                _ => (at as f64 - 0.5) * cell,
            };
            (0..count + 2).map(|at| from + place(at)).collect()
        };
        let width = columns + 2;
        let mut z = vec![None; width * (rows + 2)];
        let floor = f64::from(field.floor);
        for row in 0..rows {
            for column in 0..columns {
                let height = f64::from(field.heights[row * columns + column]);
                z[(row + 1) * width + column + 1] = (height > floor).then_some(origin.z + height);
            }
        }
        let side = (columns.max(rows) as u32 + 1).next_power_of_two();
        let bottom = origin.z + floor;
        SurfaceCorners {
            x: along(origin.x, columns, size[0]),
            y: along(origin.y, rows, size[1]),
            z,
            bottom,
            side,
            tolerance,
        }
    }

    fn index(&self, [x, y]: GridCorner) -> Option<usize> {
        let (x, y) = (x as usize, y as usize);
        (x < self.x.len() && y < self.y.len()).then(|| y * self.x.len() + x)
    }

    /// The height of a corner, mm; `None` for a hole, the ring and outside of it.
    fn height(&self, at: GridCorner) -> Option<f64> {
        self.index(at).and_then(|at| self.z[at])
    }

    fn fill(&mut self, at: GridCorner) {
        if let Some(at) = self.index(at) {
            self.z[at] = Some(self.bottom + FILLED);
        }
    }

    fn place(&self, [x, y]: GridCorner) -> [f64; 2] {
        let last = |all: &[f64], at: u32| all[(at as usize).min(all.len() - 1)];
        [last(&self.x, x), last(&self.y, y)]
    }

    /// The triangles with material: of the top, or of the flat bottom.
    fn triangles(&self, is_top: bool) -> Vec<[GridCorner; 3]> {
        let n = self.side;
        let across = n as usize + 1;
        let mut halved = HalvedEdges { bits: vec![false; across * across], across, count: 0 };
        let roots = [[[0, 0], [n, n], [n, 0]], [[n, n], [0, 0], [0, n]]];
        for root in roots {
            self.ask(root, is_top, &mut halved);
        }
        // Where one triangle is halved, its neighbour across the long edge is halved, too, and so are all triangles
        // that contain either.
        loop {
            let before = halved.count;
            for root in roots {
                self.spread(root, &mut halved);
            }
            if halved.count == before {
                break;
            }
        }
        let mut all = Vec::new();
        for root in roots {
            self.gather(root, &halved, &mut all);
        }
        all
    }

    /// Marks the triangles that must be halved. Returns whether this one or one inside it must be.
    fn ask(&self, triangle: [GridCorner; 3], is_top: bool, halved: &mut HalvedEdges) -> bool {
        let [a, b, c] = triangle;
        if is_single(a, b) || self.is_outside(&triangle) {
            return false;
        }
        let middle = middle(a, b);
        let inner = [[c, a, middle], [b, c, middle]].map(|half| self.ask(half, is_top, halved));
        let asks = inner[0] || inner[1] || !self.fits(&triangle, is_top);
        if asks {
            halved.set(middle);
        }
        asks
    }

    /// Marks triangles that contain a halved one. Returns whether this one is halved.
    fn spread(&self, triangle: [GridCorner; 3], halved: &mut HalvedEdges) -> bool {
        let [a, b, c] = triangle;
        if is_single(a, b) || self.is_outside(&triangle) {
            return false;
        }
        let middle = middle(a, b);
        let inner = [[c, a, middle], [b, c, middle]].map(|half| self.spread(half, halved));
        if inner[0] || inner[1] {
            halved.set(middle);
        }
        halved.has(middle)
    }

    fn is_outside(&self, corners: &[GridCorner; 3]) -> bool {
        let least = |axis: usize| corners.iter().map(|at| at[axis]).min().unwrap_or(0) as usize;
        least(0) >= self.x.len() || least(1) >= self.y.len()
    }

    /// Whether all corners in a triangle are within the tolerance of its plane, or all of them are holes.
    fn fits(&self, corners: &[GridCorner; 3], is_top: bool) -> bool {
        let [a, b, c] = *corners;
        let heights = corners.map(|at| self.height(at));
        let places = corners.map(|at| self.place(at));
        let plane = match heights {
            [Some(a), Some(b), Some(c)] => Some(HeightPlane::through(places, [a, b, c])),
            [None, None, None] => None,
            _ => return false,
        };
        let range = |axis: usize, most: usize| {
            let all = [a[axis], b[axis], c[axis]];
            let [low, high] =
                [all.iter().min(), all.iter().max()].map(|at| at.copied().unwrap_or(0));
            // There are no corners beyond the ring.
            low..=high.min(most as u32)
        };
        let side = |from: GridCorner, to: GridCorner, at: GridCorner| {
            let [fx, fy, tx, ty, x, y] =
                [from[0], from[1], to[0], to[1], at[0], at[1]].map(i64::from);
            (tx - fx) * (y - fy) - (x - fx) * (ty - fy)
        };
        let turn = side(a, b, c).signum();
        let is_inside = |at: GridCorner| {
            [side(a, b, at), side(b, c, at), side(c, a, at)].iter().all(|side| side * turn >= 0)
        };
        range(1, self.y.len()).all(|y| {
            range(0, self.x.len()).all(|x| {
                let at = [x, y];
                if !is_inside(at) {
                    return true;
                }
                match (self.height(at), &plane) {
                    (None, None) => true,
                    (Some(z), Some(plane)) => {
                        !is_top || (z - plane.at(self.place(at))).abs() <= self.tolerance
                    }
                    _ => false,
                }
            })
        })
    }

    fn gather(
        &self,
        triangle: [GridCorner; 3],
        halved: &HalvedEdges,
        all: &mut Vec<[GridCorner; 3]>,
    ) {
        let [a, b, c] = triangle;
        if !is_single(a, b) && halved.has(middle(a, b)) {
            let middle = middle(a, b);
            self.gather([c, a, middle], halved, all);
            self.gather([b, c, middle], halved, all);
        } else if triangle.iter().any(|at| self.height(*at).is_some()) {
            all.push([a, c, b]);
        }
    }

    /// Hole corners at which four triangles with material would share an edge at the bottom.
    fn touching(&self, top: &[[GridCorner; 3]]) -> Vec<GridCorner> {
        let mut edges: BTreeMap<[GridCorner; 2], usize> = BTreeMap::new();
        for [a, b, c] in top {
            for [from, to] in [[a, b], [b, c], [c, a]] {
                if self.height(*from).is_none() && self.height(*to).is_none() {
                    *edges.entry([*from.min(to), *from.max(to)]).or_default() += 1;
                }
            }
        }
        let is_ring = |[x, y]: GridCorner| {
            let (x, y) = (x as usize, y as usize);
            x == 0 || y == 0 || x + 1 >= self.x.len() || y + 1 >= self.y.len()
        };
        let twice = edges.into_iter().filter(|(_, count)| *count > 1);
        twice.flat_map(|(ends, _)| ends.into_iter().find(|end| !is_ring(*end))).collect()
    }

    fn mesh(&self, top: &[[GridCorner; 3]], bottom: &[[GridCorner; 3]]) -> Result<Mesh, MeshError> {
        let over = top.iter().map(|corners| corners.map(|at| self.vertex(at, true)));
        let under = bottom.iter().map(|[a, b, c]| [*c, *b, *a].map(|at| self.vertex(at, false)));
        welded(&over.chain(under).collect::<Vec<_>>())
    }

    fn vertex(&self, at: GridCorner, is_top: bool) -> Vec3 {
        let [x, y] = self.place(at);
        let z = self.height(at).filter(|_| is_top).unwrap_or(self.bottom);
        Vec3::new(x, y, z)
    }
}

/// The long edges that are halved, by their midpoints.
struct HalvedEdges {
    bits: Vec<bool>,
    across: usize,
    count: usize,
}

impl HalvedEdges {
    fn at(&self, [x, y]: GridCorner) -> usize {
        y as usize * self.across + x as usize
    }

    fn has(&self, at: GridCorner) -> bool {
        self.bits[self.at(at)]
    }

    fn set(&mut self, at: GridCorner) {
        let at = self.at(at);
        self.count += usize::from(!self.bits[at]);
        self.bits[at] = true;
    }
}

/// The midpoint of a long edge.
fn middle(a: GridCorner, b: GridCorner) -> GridCorner {
    [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2]
}

/// Whether a triangle is half a single cell: its long edge has no corner at its midpoint.
fn is_single(a: GridCorner, b: GridCorner) -> bool {
    (a[0] + b[0]) % 2 == 1 || (a[1] + b[1]) % 2 == 1
}

/// A plane over X and Y.
struct HeightPlane {
    from: [f64; 2],
    z: f64,
    slope: [f64; 2],
}

impl HeightPlane {
    fn through([a, b, c]: [[f64; 2]; 3], [za, zb, zc]: [f64; 3]) -> HeightPlane {
        let [ux, uy, vx, vy] = [b[0] - a[0], b[1] - a[1], c[0] - a[0], c[1] - a[1]];
        let area = ux * vy - uy * vx;
        let [u, v] = [zb - za, zc - za];
        HeightPlane { from: a, z: za, slope: [(u * vy - v * uy) / area, (v * ux - u * vx) / area] }
    }

    fn at(&self, [x, y]: [f64; 2]) -> f64 {
        self.z + self.slope[0] * (x - self.from[0]) + self.slope[1] * (y - self.from[1])
    }
}

/// The mesh with equal corners merged, and without degenerate triangles.
fn welded(corners: &[[Vec3; 3]]) -> Result<Mesh, MeshError> {
    let mut welder = VertexWelder::new(0.0);
    let numbered = corners.iter().map(|triangle| triangle.map(|corner| welder.vertex(corner)));
    let triangles: Vec<[u32; 3]> =
        numbered.filter(|[a, b, c]| a != b && b != c && c != a).collect();
    Mesh::new(welder.into_vertices(), triangles)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn field(heights: &[f32], columns: usize) -> HeightField<'_> {
        let rows = heights.len() / columns;
        let origin = Vec3::new(-3.0, 5.0, -30.0);
        let size = [columns, rows].map(|count| 0.5 * count as f64);
        HeightField { origin, cell: 0.5, columns, rows, size, heights, floor: 0.0 }
    }

    /// A bowl in a block, with a hole and places that are cut through and touch.
    fn bowl(columns: usize, rows: usize) -> Vec<f32> {
        let height = |x: f64, y: f64| {
            let from_middle = (x * x + y * y).sqrt();
            if from_middle < 4.0 {
                0.0
            } else if from_middle < 25.0 {
                5.0 + 0.02 * from_middle * from_middle
            } else if x > 30.0 && ((x as i64 / 2) + (y.abs() as i64 / 2)) % 2 == 0 {
                0.0
            } else {
                20.0
            }
        };
        let at = |index: usize| {
            let (x, y) = ((index % columns) as f64, (index / columns) as f64);
            height(x - 40.0, y - 30.0) as f32
        };
        (0..columns * rows).map(at).collect()
    }

    #[test]
    fn the_surface_is_closed_and_near_every_column() {
        let (columns, rows) = (90, 61);
        let heights = bowl(columns, rows);
        let own = field(&heights, columns);
        for tolerance in [0.0, 0.01, 0.2] {
            let mesh = own.smooth(tolerance).expect("a surface");
            assert!(mesh.edges().are_closed());
            // Walls are a cell wide.
            let volume = own.volume();
            assert!((mesh.volume() - volume).abs() < 0.06 * volume, "{} {volume}", mesh.volume());
            // Straight up through the middle of each column.
            for (index, height) in heights.iter().enumerate().step_by(37) {
                let (column, row) = (index % columns, index / columns);
                let inside = (1..columns - 1).contains(&column) && (1..rows - 1).contains(&row);
                if *height <= 0.0 || !inside {
                    continue;
                }
                let x = -3.0 + (column as f64 + 0.5) * 0.5 + 1e-7;
                let y = 5.0 + (row as f64 + 0.5) * 0.5 + 2e-7;
                let top = (0..mesh.triangles().len())
                    .filter_map(|at| over(mesh.corners(at), x, y))
                    .fold(f64::NEG_INFINITY, f64::max);
                let off = (top - (-30.0 + f64::from(*height))).abs();
                assert!(off <= tolerance + 1e-3, "{off} at {column}, {row}");
            }
        }
    }

    fn over(corners: [Vec3; 3], x: f64, y: f64) -> Option<f64> {
        let [a, b, c] = corners;
        let side = |p: Vec3, q: Vec3| (q.x - p.x) * (y - p.y) - (x - p.x) * (q.y - p.y);
        let [u, v, w] = [side(b, c), side(c, a), side(a, b)];
        let area = u + v + w;
        let is_in = area.abs() > 1e-12 && [u, v, w].iter().all(|part| part / area >= 0.0);
        is_in.then(|| (u * a.z + v * b.z + w * c.z) / area)
    }

    #[test]
    fn flat_places_have_few_triangles() {
        let (columns, rows) = (200, 150);
        let flat = vec![10.0; columns * rows];
        let mesh = field(&flat, columns).smooth(0.001).expect("a surface");
        assert!(mesh.edges().are_closed());
        let size = [100.0, 75.0, 10.0];
        assert!((mesh.volume() - size.iter().product::<f64>()).abs() < 1e-6);
        assert!(mesh.triangles().len() < 9_000, "{}", mesh.triangles().len());
        assert_eq!(field(&[1.0, 2.0], 2).smooth(0.1), Err(SmoothError::Narrow));
    }
}
