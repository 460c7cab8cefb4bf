//! Joins the cells of a height field to rectangles, each of one height.

use super::HeightField;

/// A rectangle of cells that becomes one face.
#[derive(Clone, Copy, Debug)]
pub(super) struct CellRectangle {
    /// The first cell along X and the one after the last.
    pub columns: [usize; 2],
    /// The first cell along Y and the one after the last.
    pub rows: [usize; 2],
    /// Their height, mm above the origin.
    pub height: f64,
}

impl CellRectangle {
    /// Its first corner and the opposite one.
    pub fn ends(&self) -> [[usize; 2]; 2] {
        [0, 1].map(|end| [self.columns[end], self.rows[end]])
    }
}

/// Rectangles that cover every cell with material once.
pub(super) struct RectangleCover {
    pub rectangles: Vec<CellRectangle>,
    /// The number of the rectangle of each cell, or [`NONE`].
    pub of: Vec<u32>,
    /// The largest difference between the height of a cell and that of its rectangle, mm.
    pub deviation: f64,
}

/// Marks a hole: a cell that is cut through.
pub(super) const NONE: u32 = u32::MAX;

/// Range and mean of the heights of the cells of a rectangle.
#[derive(Clone, Copy)]
pub(super) struct HeightSummary {
    low: f64,
    high: f64,
    sum: f64,
    count: usize,
}

impl HeightSummary {
    pub(super) const NO: HeightSummary =
        HeightSummary { low: f64::INFINITY, high: f64::NEG_INFINITY, sum: 0.0, count: 0 };

    pub(super) fn with(self, height: f64) -> HeightSummary {
        HeightSummary {
            low: self.low.min(height),
            high: self.high.max(height),
            sum: self.sum + height,
            count: self.count + 1,
        }
    }

    /// The mean, which keeps the volume. Clamping keeps rounding from moving it out of the range.
    pub(super) fn mean(&self) -> f64 {
        (self.sum / self.count as f64).clamp(self.low, self.high)
    }

    pub(super) fn deviation(&self) -> f64 {
        self.deviation_from(self.mean())
    }

    pub(super) fn deviation_from(&self, height: f64) -> f64 {
        (self.high - height).max(height - self.low)
    }
}

/// Heights of joined cells are multiples of this, mm: 32-bit floats can represent them up to 256 mm. Otherwise means
/// that differ only by rounding would become walls of zero height in files of 32-bit floats.
const STEP: f64 = 1.0 / 65536.0;

/// Rounds means to multiples of [`STEP`], and carries the error of the volume over to the next ones.
#[derive(Default)]
struct HeightRounder {
    /// The missing volume so far, mm times cells.
    missing: f64,
}

impl HeightRounder {
    fn height(&mut self, heights: &HeightSummary, tolerance: f64) -> f64 {
        let mean = heights.mean();
        let cells = heights.count as f64;
        let corrected = mean + (self.missing / cells).clamp(-STEP, STEP);
        let rounded = (corrected / STEP).round() * STEP;
        let height = if heights.low < heights.high && heights.deviation_from(rounded) <= tolerance {
            rounded
        } else {
            mean
        };
        self.missing += (mean - height) * cells;
        height
    }
}

impl RectangleCover {
    /// Rectangles of tops in which no height differs from the mean by more than the tolerance, mm.
    pub(super) fn of_tops(field: &HeightField, tolerance: f64) -> RectangleCover {
        RectangleCover::new(field, |column, row| field.height(column, row), tolerance)
    }

    /// Rectangles of the bottom.
    pub(super) fn of_bottoms(field: &HeightField) -> RectangleCover {
        let floor = f64::from(field.floor);
        RectangleCover::new(field, |_, _| floor, 0.0)
    }

    /// Grows a rectangle from each free cell, first along X as far as the tolerance allows, then along Y.
    fn new(
        field: &HeightField,
        height: impl Fn(usize, usize) -> f64,
        tolerance: f64,
    ) -> RectangleCover {
        let HeightField { columns, rows, .. } = *field;
        let floor = f64::from(field.floor);
        let mut cover = RectangleCover {
            rectangles: Vec::new(),
            of: vec![NONE; columns * rows],
            deviation: 0.0,
        };
        let mut rounder = HeightRounder::default();
        for row in 0..rows {
            let mut column = 0;
            while column < columns {
                let free = |cover: &RectangleCover, column: usize, row: usize| {
                    cover.of[row * columns + column] == NONE && field.height(column, row) > floor
                };
                if !free(&cover, column, row) {
                    column += 1;
                    continue;
                }
                let mut heights = HeightSummary::NO.with(height(column, row));
                let mut end = column + 1;
                while end < columns && free(&cover, end, row) {
                    let more = heights.with(height(end, row));
                    if more.deviation() > tolerance {
                        break;
                    }
                    heights = more;
                    end += 1;
                }
                let mut top = row + 1;
                while top < rows && (column..end).all(|at| free(&cover, at, top)) {
                    let more = (column..end).fold(heights, |sum, at| sum.with(height(at, top)));
                    if more.deviation() > tolerance {
                        break;
                    }
                    heights = more;
                    top += 1;
                }
                let number = cover.rectangles.len() as u32;
                for row in row..top {
                    cover.of[row * columns..][column..end].fill(number);
                }
                let height = rounder.height(&heights, tolerance);
                cover.deviation = cover.deviation.max(heights.deviation_from(height));
                cover.rectangles.push(CellRectangle {
                    columns: [column, end],
                    rows: [row, top],
                    height,
                });
                column = end;
            }
        }
        cover
    }
}
