//! The surface of what is left: the heights in the middles of columns, or intervals where heights alone do not
//! suffice: gaps of undercuts, stock that is hollow from below, and cuts from other sides.
//!
//! Where a wall passes through a column, its upper and lower bound are the top and the foot of the wall. Any height
//! between them would be a ledge that no tool has made, so the column gets the height at its middle, which is the
//! level on one side of the wall.

use chordal_geometry::{Aabb, Vec3};
use chordal_stock::mesh::{HeightField, HeightFieldError, HeightMesh, LayerField, SolidIntervals};

use super::removal::OtherSide;
use super::report::StockReport;
use super::solid_intervals::{ColumnKnowledge, intervals_of};
use super::turns::boxed;

/// The boundary of a cut from another side is bisected this often, to 1/64 of a column.
const MAX_HALVINGS: u32 = 6;

impl StockReport {
    /// The intervals of material that are left in the middle of each column of the stock, measured from its bottom,
    /// mm. `None` where the heights of the columns suffice.
    pub fn intervals(&self) -> Option<&SolidIntervals> {
        self.has_undersides().then(|| self.intervals.get_or_init(|| self.find_intervals()))
    }

    /// What is left, as a closed surface of flat tops and undersides within a tolerance of their columns, mm. A
    /// column has the height at its middle, so the surface has no steps that tools and stock do not have, and a wall
    /// is at most half a column's diagonal from its true place.
    ///
    /// # Errors
    /// When there are too many columns for one mesh.
    pub fn surface(&self, tolerance_mm: f64) -> Result<HeightMesh, HeightFieldError> {
        let grid = self.stock.grid();
        let [columns, rows] = grid.cells().map(|cells| cells as usize);
        let (origin, cell) = (grid.bounds().min, grid.resolution());
        let size = [grid.bounds().size().x, grid.bounds().size().y];
        match self.intervals() {
            Some(intervals) => {
                LayerField { origin, cell, columns, rows, size, intervals }.mesh(tolerance_mm)
            }
            None => {
                let heights: Vec<f32> =
                    self.tops().iter().map(|top| (top - origin.z).max(0.0) as f32).collect();
                let heights = &heights;
                let field = HeightField { origin, cell, columns, rows, size, heights, floor: 0.0 };
                field.mesh(tolerance_mm)
            }
        }
    }

    fn find_intervals(&self) -> SolidIntervals {
        let others: Vec<SideHeights<'_>> = self.others.iter().map(SideHeights::new).collect();
        let grid = self.stock.grid();
        let bounds = grid.bounds();
        let [columns, rows] = grid.cells();
        let (pairs, middles) = (self.stock.height_pairs(), self.stock.middles());
        let mut all = SolidIntervals::default();
        for row in 0..rows {
            for column in 0..columns {
                let (at, index) =
                    ([column, row], row as usize * columns as usize + column as usize);
                let pair = pairs[index];
                let outer = intervals_of(&self.stock, at, ColumnKnowledge::Maybe, pair.outer);
                let inner = intervals_of(
                    &self.stock,
                    at,
                    ColumnKnowledge::Surely,
                    pair.inner.min(pair.outer),
                );
                let middle =
                    intervals_of(&self.stock, at, ColumnKnowledge::InTheMiddle, middles[index]);
                let mut own = between(&middle, &outer, &inner);
                let corners = grid.corners(column, row);
                for other in &others {
                    own = other.cut(own, corners, grid.resolution());
                }
                all.push(
                    own.into_iter().map(|[from, to]| [from - bounds.min.z, to - bounds.min.z]),
                );
            }
        }
        all
    }

    /// Whether columns may have material above a gap: by undercuts, stock that is hollow from below, or cuts in
    /// another orientation.
    pub fn has_undersides(&self) -> bool {
        let has_others = self.others.iter().any(|other| other.removed.is_any());
        self.stock.has_gaps() || has_others
    }

    /// The height at the middle of each column, mm, row by row; that of the bottom where nothing is left.
    pub fn tops(&self) -> Vec<f64> {
        let bottom = self.stock.grid().bounds().min.z;
        match self.intervals() {
            Some(intervals) => {
                let top =
                    |column| intervals.of(column).last().map_or(bottom, |[_, to]| bottom + to);
                (0..intervals.len()).map(top).collect()
            }
            None => self.stock.middles().into_iter().map(|top| top.max(bottom)).collect(),
        }
    }
}

/// What is left in the middle of a column, clamped to what may be left of it and extended to what certainly is:
/// rounding may move an end of the middle beyond that of a bound.
fn between(middle: &[[f64; 2]], outer: &[[f64; 2]], inner: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let within = outer.iter().flat_map(|[from, to]| {
        middle.iter().map(move |[floor, top]| [from.max(*floor), to.min(*top)])
    });
    let mut all: Vec<[f64; 2]> = within.chain(inner.iter().copied()).collect();
    all.retain(|[from, to]| from < to);
    all.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let mut joined: Vec<[f64; 2]> = Vec::with_capacity(all.len());
    for [from, to] in all {
        match joined.last_mut() {
            Some(last) if from <= last[1] => last[1] = last[1].max(to),
            _ => joined.push([from, to]),
        }
    }
    joined
}

/// Another orientation with the heights of its columns.
struct SideHeights<'a> {
    side: &'a OtherSide,
    /// The height at the middle of each column that is cut; infinite for a column that is not, mm.
    heights: Vec<f64>,
}

impl<'a> SideHeights<'a> {
    fn new(side: &'a OtherSide) -> SideHeights<'a> {
        let middles = side.stock.middles().into_iter().enumerate();
        let heights = middles.map(
            |(column, middle)| {
                if side.removed.is_cut(column) { middle } else { f64::INFINITY }
            },
        );
        SideHeights { side, heights: heights.collect() }
    }

    /// The intervals of a column without what is cut in this orientation.
    fn cut(
        &self,
        intervals: Vec<[f64; 2]>,
        [low, high]: [[f64; 2]; 2],
        step: f64,
    ) -> Vec<[f64; 2]> {
        let body = |[from, to]: [f64; 2]| Aabb {
            min: Vec3::new(low[0], low[1], from),
            max: Vec3::new(high[0], high[1], to),
        };
        let middle = [0, 1].map(|axis| 0.5 * (low[axis] + high[axis]));
        let is_left = |z: f64| {
            let at = Vec3::new(middle[0], middle[1], z);
            !self.is_removed(self.side.there.apply_point(at))
        };
        let mut left = Vec::new();
        for range in intervals {
            if self.side.removed.is_above(&boxed(&body(range), &self.side.there)) {
                left.push(range);
            } else {
                left.extend(kept(range, step, &is_left));
            }
        }
        left
    }

    fn is_removed(&self, at: Vec3) -> bool {
        let grid = self.side.stock.grid();
        let [columns, rows] = grid.cells();
        let min = grid.bounds().min;
        let cell = |place: f64, least: f64, count: u32| {
            let cell = ((place - least) / grid.resolution()).floor();
            (cell >= 0.0 && cell < f64::from(count)).then_some(cell as u32)
        };
        let (Some(column), Some(row)) = (cell(at.x, min.x, columns), cell(at.y, min.y, rows))
        else {
            return false;
        };
        let column = row as usize * columns as usize + column as usize;
        // A gap that is only possible counts as left.
        at.z > self.heights[column] || self.side.removed.is_in_gap(column, at.z)
    }
}

/// The parts of an interval where `is_left` is true. It is sampled at this step, and its changes are bisected.
fn kept([from, to]: [f64; 2], step: f64, is_left: &dyn Fn(f64) -> bool) -> Vec<[f64; 2]> {
    let count = ((to - from) / step).ceil().max(1.0);
    let width = (to - from) / count;
    let at = |number: f64| from + (number + 0.5) * width;
    let mut parts = Vec::new();
    let mut was_left = is_left(at(0.0));
    let mut begin = from;
    for number in 1..count as u64 {
        let is = is_left(at(number as f64));
        if is == was_left {
            continue;
        }
        let [mut before, mut after] = [at(number as f64 - 1.0), at(number as f64)];
        for _ in 0..MAX_HALVINGS {
            let middle = 0.5 * (before + after);
            if is_left(middle) == was_left {
                before = middle;
            } else {
                after = middle;
            }
        }
        let change = 0.5 * (before + after);
        if was_left {
            parts.push([begin, change]);
        }
        (begin, was_left) = (change, is);
    }
    if was_left {
        parts.push([begin, to]);
    }
    parts
}

#[cfg(test)]
mod tests {
    use super::*;

    fn length(all: &[[f64; 2]]) -> f64 {
        all.iter().map(|[from, to]| to - from).sum()
    }

    #[test]
    fn the_middle_lies_between_the_bounds() {
        let outer = [[0.0, 4.0], [6.0, 10.0]];
        let inner = [[0.0, 3.0], [7.0, 9.0]];
        for (middle, expected) in [
            // As it is, where it is between them.
            (&[[0.0, 3.5], [6.5, 9.5]][..], &[[0.0, 3.5], [6.5, 9.5]][..]),
            // Rounding has moved its ends.
            (&[[0.0, 4.1], [5.9, 10.1]], &outer),
            (&[[0.0, 2.9], [7.1, 8.9]], &inner),
            (&[], &inner),
            (&[[0.0, 10.0]], &outer),
        ] {
            let found = between(middle, &outer, &inner);
            assert_eq!(found, expected);
            assert!(length(&inner) <= length(&found) && length(&found) <= length(&outer));
        }
    }

    #[test]
    fn what_is_kept_of_a_stretch() {
        let kept = kept([0.0, 10.0], 0.5, &|z| !(2.0..=7.3).contains(&z));
        let near = |a: f64, b: f64| (a - b).abs() < 0.01;
        let [[a, b], [c, d]] = kept[..] else { panic!("{kept:?}") };
        assert!(a == 0.0 && near(b, 2.0) && near(c, 7.3) && d == 10.0, "{kept:?}");
    }
}
