//! What is left as stretches of columns, where heights alone do not say it: gaps of undercuts, stock that is hollow
//! from below, and cuts from other sides.

use chordal_geometry::{Aabb, Vec3};
use chordal_stock::mesh::{HeightField, HeightFieldError, HeightMesh, LayerField, Stretches};

use super::removed::OtherSide;
use super::report::StockReport;
use super::stretches::stretches_of;
use super::turns::boxed;

/// Where a column is cut from another side is found to this share of a column.
const HALVINGS: u32 = 6;

impl StockReport {
    /// What is left as stretches of material in each column of the stock, from its bottom, mm: the middle between
    /// the two bounds. `None` where the heights of the columns say it all.
    pub fn stretches(&self) -> Option<&Stretches> {
        self.has_undersides().then(|| self.stretches.get_or_init(|| self.find_stretches()))
    }

    /// What is left as a closed surface of flat tops and undersides, which are no further from their columns than a
    /// tolerance, mm; the middle between the two bounds.
    ///
    /// # Errors
    /// When there are too many columns for one mesh.
    pub fn surface(&self, tolerance_mm: f64) -> Result<HeightMesh, HeightFieldError> {
        let grid = self.stock.grid();
        let [columns, rows] = grid.cells().map(|cells| cells as usize);
        let (origin, cell) = (grid.bounds().min, grid.resolution());
        match self.stretches() {
            Some(stretches) => {
                LayerField { origin, cell, columns, rows, stretches }.mesh(tolerance_mm)
            }
            None => {
                let heights: Vec<f32> =
                    self.tops().iter().map(|top| (top - origin.z).max(0.0) as f32).collect();
                let field =
                    HeightField { origin, cell, columns, rows, heights: &heights, floor: 0.0 };
                field.mesh(tolerance_mm)
            }
        }
    }

    fn find_stretches(&self) -> Stretches {
        let others: Vec<Other<'_>> = self.others.iter().map(Other::new).collect();
        let grid = self.stock.grid();
        let bounds = grid.bounds();
        let [columns, rows] = grid.cells();
        let pairs = self.stock.height_pairs();
        let mut all = Stretches::default();
        for row in 0..rows {
            for column in 0..columns {
                let pair = pairs[row as usize * columns as usize + column as usize];
                let outer = stretches_of(&self.stock, [column, row], 0, pair.outer);
                let inner = stretches_of(&self.stock, [column, row], 1, pair.inner.min(pair.outer));
                let mut own = middle(&outer, &inner);
                let [low, high] = grid.corners(column, row);
                for other in &others {
                    own = other.cut(own, [low, high], grid.resolution());
                }
                all.push(
                    own.into_iter().map(|[from, to]| [from - bounds.min.z, to - bounds.min.z]),
                );
            }
        }
        all
    }

    /// Whether columns may have material above where they have none: gaps of undercuts, stock that is hollow from
    /// below, cuts while the part is turned.
    pub fn has_undersides(&self) -> bool {
        let has_others = self.others.iter().any(|other| other.removed.is_any());
        self.stock.has_gaps() || has_others
    }

    /// The middle between the two bounds of the top of each column, mm, row by row: the bottom where nothing is left.
    pub fn tops(&self) -> Vec<f64> {
        let bottom = self.stock.grid().bounds().min.z;
        match self.stretches() {
            Some(stretches) => {
                let top =
                    |column| stretches.of(column).last().map_or(bottom, |[_, to]| bottom + to);
                (0..stretches.len()).map(top).collect()
            }
            None => {
                let pairs = self.stock.height_pairs().into_iter();
                pairs
                    .map(|pair| (0.5 * (pair.outer + pair.inner.max(bottom))).max(bottom))
                    .collect()
            }
        }
    }
}

/// The middle between two bounds: its length is the mean of theirs. An end that both have is in the middle of the
/// two. What only one of them has is half as long: a gap about its middle, a stretch from its lower end on.
fn middle(outer: &[[f64; 2]], inner: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let mean = |a: f64, b: f64| 0.5 * (a + b);
    let mut all = Vec::new();
    for &[from, to] in outer {
        let within = |part: &&[f64; 2]| part[0] < to && from < part[1];
        let parts: Vec<[f64; 2]> =
            inner.iter().filter(within).map(|[a, b]| [a.max(from), b.min(to)]).collect();
        let (Some(first), Some(last)) = (parts.first(), parts.last()) else {
            all.push([from, mean(from, to)]);
            continue;
        };
        let mut begin = mean(from, first[0]);
        for pair in parts.windows(2) {
            let [floor, top] = [pair[0][1], pair[1][0]];
            let quarter = 0.25 * (top - floor);
            all.push([begin, floor + quarter]);
            begin = top - quarter;
        }
        all.push([begin, mean(to, last[1])]);
    }
    all.retain(|[from, to]| from < to);
    all
}

/// Another side with the heights of its columns.
struct Other<'a> {
    side: &'a OtherSide,
    /// The middle of the bounds of each column that is cut; infinite where none is, mm.
    heights: Vec<f64>,
}

impl<'a> Other<'a> {
    fn new(side: &'a OtherSide) -> Other<'a> {
        let pairs = side.stock.height_pairs();
        let heights = pairs.iter().enumerate().map(|(column, pair)| {
            let middle = 0.5 * (pair.outer + pair.inner);
            if side.removed.is_cut(column) { middle } else { f64::INFINITY }
        });
        Other { side, heights: heights.collect() }
    }

    /// Stretches of a column less what is cut from this side.
    fn cut(
        &self,
        stretches: Vec<[f64; 2]>,
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
        for stretch in stretches {
            if self.side.removed.is_above(&boxed(&body(stretch), &self.side.there)) {
                left.push(stretch);
            } else {
                left.extend(kept(stretch, step, &is_left));
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
        // What may be a gap only is left.
        at.z > self.heights[column] || self.side.removed.is_in_gap(column, at.z)
    }
}

/// The parts of a stretch where a question has the answer yes, asked so often along it and more closely where the
/// answer changes.
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
        for _ in 0..HALVINGS {
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
    fn the_middle_has_the_mean_length() {
        let outer: [&[[f64; 2]]; 5] = [
            &[[0.0, 10.0]],
            &[[0.0, 4.0], [6.0, 10.0]],
            &[[0.0, 10.0]],
            &[[0.0, 2.0], [8.0, 9.0]],
            &[],
        ];
        let inner: [&[[f64; 2]]; 5] = [
            &[[0.0, 8.0]],
            &[[0.0, 3.0], [7.0, 10.0]],
            &[[1.0, 4.0], [6.0, 9.0]],
            &[[0.0, 2.0]],
            &[],
        ];
        for (outer, inner) in outer.into_iter().zip(inner) {
            let middle = middle(outer, inner);
            let mean = 0.5 * (length(outer) + length(inner));
            assert!((length(&middle) - mean).abs() < 1e-12, "{middle:?}");
        }
        assert_eq!(
            middle(&[[0.0, 4.0], [6.0, 10.0]], &[[0.0, 3.0], [7.0, 10.0]]),
            [[0.0, 3.5], [6.5, 10.0]]
        );
    }

    #[test]
    fn what_is_kept_of_a_stretch() {
        let kept = kept([0.0, 10.0], 0.5, &|z| !(2.0..=7.3).contains(&z));
        let near = |a: f64, b: f64| (a - b).abs() < 0.01;
        let [[a, b], [c, d]] = kept[..] else { panic!("{kept:?}") };
        assert!(a == 0.0 && near(b, 2.0) && near(c, 7.3) && d == 10.0, "{kept:?}");
    }
}
