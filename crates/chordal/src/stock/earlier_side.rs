//! What is certainly removed from a part before it is cut in another orientation: the columns of that orientation
//! begin lower, or become lower before it is cut so again.

use std::rc::Rc;

use chordal_geometry::{Aabb, Transform, Vec3};
use chordal_stock::ColumnStock;
use chordal_stock::shape::SolidShape;

use super::heights::ShapeHeights;
use super::turns::boxed;

/// Positions that differ by less than this are equal, mm.
const COINCIDENT_MM: f64 = 1e-6;
/// How often a column is halved in height to find how much of it another orientation has removed.
const MAX_HALVINGS: u32 = 4;

/// The heights above which nothing is left of the columns of one orientation.
pub(super) struct SideTops {
    low: [f64; 2],
    cell: f64,
    cells: [usize; 2],
    outer: Vec<f32>,
}

impl SideTops {
    pub fn of(stock: &ColumnStock) -> SideTops {
        let grid = stock.grid();
        let min = grid.bounds().min;
        let up = |height: f64| {
            let near = height as f32;
            if f64::from(near) < height { near.next_up() } else { near }
        };
        SideTops {
            low: [min.x, min.y],
            cell: grid.resolution(),
            cells: grid.cells().map(|cells| cells as usize),
            outer: stock.height_pairs().iter().map(|pair| up(pair.outer)).collect(),
        }
    }

    /// Whether nothing is left in a box.
    fn is_empty(&self, body: &Aabb) -> bool {
        // There is no stock outside the columns.
        let range = |axis: usize, from: f64, to: f64| {
            let at = |place: f64| (place - self.low[axis]) / self.cell;
            let end = (at(to + COINCIDENT_MM).floor() + 1.0).clamp(0.0, self.cells[axis] as f64);
            (at(from - COINCIDENT_MM).floor().max(0.0) as usize)..end as usize
        };
        let floor = body.min.z - COINCIDENT_MM;
        range(1, body.min.y, body.max.y).all(|row| {
            range(0, body.min.x, body.max.x)
                .all(|column| f64::from(self.outer[row * self.cells[0] + column]) <= floor)
        })
    }
}

/// The state of one orientation at an earlier moment, as seen from another one.
#[derive(Clone)]
pub(super) struct EarlierSide {
    pub tops: Rc<SideTops>,
    /// Transforms the part from its current orientation to the earlier one.
    pub there: Transform,
}

impl EarlierSide {
    /// The height above which nothing is left of a column between two corners, mm; nothing was left above `top`
    /// before.
    fn below(&self, [low, high]: [[f64; 2]; 2], top: f64, bottom: f64) -> f64 {
        let is_empty = |from: f64, to: f64| {
            let min = Vec3::new(low[0], low[1], from);
            let max = Vec3::new(high[0], high[1], to);
            self.tops.is_empty(&boxed(&Aabb { min, max }, &self.there))
        };
        let mut free = top;
        let mut step = self.tops.cell;
        let mut halvings = 0;
        while free > bottom && halvings <= MAX_HALVINGS {
            let next = (free - step).max(bottom);
            if is_empty(next, free) {
                free = next;
            } else {
                step /= 2.0;
                halvings += 1;
            }
        }
        free
    }
}

/// A stock before the first cut in an orientation: a shape without what earlier orientations have certainly removed.
pub(super) struct InitialStock<'s> {
    pub shape: ShapeHeights<'s>,
    earlier: Vec<EarlierSide>,
    bottom: f64,
}

impl<'s> InitialStock<'s> {
    /// Between two shapes, in cells of a resolution, mm.
    pub fn new(
        shapes: [&'s SolidShape; 2],
        resolution: f64,
        earlier: Vec<EarlierSide>,
    ) -> InitialStock<'s> {
        let shape = ShapeHeights::between(shapes, resolution);
        let bottom = shape.bounds().min.z;
        InitialStock { shape, earlier, bottom }
    }

    /// As [`ShapeHeights::of`].
    pub fn of(&self, low: [f64; 2], high: [f64; 2]) -> [f64; 2] {
        let [outer, inner] = self.shape.of(low, high);
        let outer = below(&self.earlier, [low, high], outer, self.bottom);
        [outer, inner.min(outer)]
    }
}

/// The height above which earlier orientations have left nothing of a column between two corners, mm.
pub(super) fn below(earlier: &[EarlierSide], corners: [[f64; 2]; 2], top: f64, bottom: f64) -> f64 {
    earlier.iter().fold(top, |top, side| side.below(corners, top, bottom))
}
