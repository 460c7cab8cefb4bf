//! Joins the tops and undersides of columns to rectangles, each of one height.

use super::super::cover::{CellRectangle, HeightSummary, NONE};
use super::{LayerField, STEP, SolidIntervals};

/// The index of an end of an interval.
const UNDERSIDE: usize = 0;
const TOP: usize = 1;

/// Rectangles that cover every top and every underside once.
pub(super) struct LayerCover {
    pub undersides: Vec<CellRectangle>,
    pub tops: Vec<CellRectangle>,
    /// The intervals of each cell, with the heights of their rectangles, mm.
    pub intervals: SolidIntervals,
    /// The numbers of the rectangles of the underside and of the top of each interval.
    pub of: Vec<[u32; 2]>,
    /// The largest difference between an end and its rectangle, mm.
    pub deviation: f64,
}

impl LayerCover {
    /// Rectangles in which no end of an interval differs from the mean by more than the tolerance, mm.
    pub fn new(field: &LayerField<'_>, intervals: &SolidIntervals, tolerance: f64) -> LayerCover {
        let mut cover = LayerCover {
            undersides: Vec::new(),
            tops: Vec::new(),
            intervals: intervals.clone(),
            of: vec![[NONE; 2]; intervals.all.len()],
            deviation: 0.0,
        };
        for end in [UNDERSIDE, TOP] {
            let mut growing = RectangleGrowth { field, intervals, tolerance, end, row: Vec::new() };
            for cell in 0..intervals.len() {
                for section in intervals.range(cell) {
                    if cover.of[section][end] == NONE {
                        growing.rectangle(cell, section, &mut cover);
                    }
                }
            }
        }
        cover
    }

    /// The rectangles of the ends of each interval of a cell.
    pub fn rectangles(&self, cell: usize) -> &[[u32; 2]] {
        &self.of[self.intervals.range(cell)]
    }
}

/// The height of a rectangle from the mean of its ends, mm. Tops are at multiples of [`STEP`] and undersides halfway
/// between them, so that they never coincide; those on the floor stay there.
fn height(mean: f64, end: usize) -> f64 {
    match end {
        TOP => (mean / STEP).round() * STEP,
        _ if mean <= 0.0 => 0.0,
        _ => ((mean / STEP).floor() + 0.5) * STEP,
    }
}

/// Grows rectangles of one kind of end.
struct RectangleGrowth<'a> {
    field: &'a LayerField<'a>,
    intervals: &'a SolidIntervals,
    tolerance: f64,
    end: usize,
    /// The intervals of the row that is tried; a buffer that is reused.
    row: Vec<usize>,
}

impl RectangleGrowth<'_> {
    /// Grows a rectangle from an end, first along X as far as the tolerance allows, then along Y.
    fn rectangle(&mut self, cell: usize, section: usize, cover: &mut LayerCover) {
        let LayerField { columns, rows, .. } = *self.field;
        let (column, row) = (cell % columns, cell / columns);
        let mut heights = HeightSummary::NO.with(self.intervals.all[section][self.end]);
        let mut all = vec![section];
        let mut right = column + 1;
        while right < columns {
            let Some((next, more)) = self.next(row * columns + right, heights, cover) else {
                break;
            };
            heights = more;
            all.push(next);
            right += 1;
        }
        let mut top = row + 1;
        'rows: while top < rows {
            let mut more = heights;
            self.row.clear();
            for at in column..right {
                let Some((next, with)) = self.next(top * columns + at, more, cover) else {
                    break 'rows;
                };
                more = with;
                self.row.push(next);
            }
            heights = more;
            all.append(&mut self.row);
            top += 1;
        }
        let height = height(heights.mean(), self.end);
        cover.deviation = cover.deviation.max(heights.deviation_from(height));
        let into = if self.end == TOP { &mut cover.tops } else { &mut cover.undersides };
        let number = into.len() as u32;
        into.push(CellRectangle { columns: [column, right], rows: [row, top], height });
        for section in all {
            cover.of[section][self.end] = number;
            cover.intervals.all[section][self.end] = height;
        }
    }

    /// The free end of a cell that is nearest to the mean of a rectangle, with the extended summary; `None` where
    /// none is within the tolerance.
    fn next(
        &self,
        cell: usize,
        heights: HeightSummary,
        cover: &LayerCover,
    ) -> Option<(usize, HeightSummary)> {
        let mean = heights.mean();
        let off = |section: &usize| (self.intervals.all[*section][self.end] - mean).abs();
        let free = self.intervals.range(cell).filter(|at| cover.of[*at][self.end] == NONE);
        let nearest = free.min_by(|a, b| off(a).total_cmp(&off(b)))?;
        let height = self.intervals.all[nearest][self.end];
        // Undersides on the floor are not joined with others.
        let is_on_floor = |height: f64| height <= 0.0;
        if self.end == UNDERSIDE && is_on_floor(height) != is_on_floor(mean) {
            return None;
        }
        let more = heights.with(height);
        (more.deviation() <= self.tolerance).then_some((nearest, more))
    }
}
