//! The changes that undercuts make to columns, for a replay.

use std::collections::BTreeMap;

use chordal_geometry::ParamCurve;
use chordal_stock::{ColumnStock, TipMove};

use super::super::tools::ToolBody;
use super::{ColumnDrop, GapChange, StockBefore};

/// Columns that are lower by less than this are unchanged, mm: rounding.
const EQUAL_HEIGHT_MM: f32 = 1e-3;
/// A move is cut in pieces of this many columns, and in at most `MAX_PIECES`: what each piece removes is reported at
/// its end.
const COLUMNS: f64 = 4.0;
const MAX_PIECES: f64 = 64.0;

/// The gaps and heights that were reported last.
pub(super) struct ReplayHollows {
    columns: [u32; 2],
    low: [f64; 2],
    top: f64,
    side: f64,
    gaps: BTreeMap<u32, Vec<[f32; 2]>>,
    heights: Vec<f32>,
}

impl ReplayHollows {
    pub fn new(before: &StockBefore) -> ReplayHollows {
        ReplayHollows {
            columns: before.columns,
            low: [before.low[0], before.low[1]],
            top: before.high[2],
            side: before.resolution_mm,
            gaps: BTreeMap::new(),
            heights: before.heights.clone(),
        }
    }

    /// All gaps before the first cut.
    pub fn all(&mut self, stock: &ColumnStock) -> Vec<GapChange> {
        let everywhere = [[0, self.columns[0]], [0, self.columns[1]]];
        self.changed(stock, everywhere, 0, 0.0).1
    }

    /// Records columns that cutters without undercuts have lowered.
    pub fn lowered(&mut self, drops: &[ColumnDrop]) {
        for drop in drops {
            self.heights[drop.column as usize] = drop.height;
        }
    }

    /// Cuts a move of a tool with undercuts. Returns the columns that are lower, and those whose gaps have changed.
    pub fn cut(
        &mut self,
        stock: &mut ColumnStock,
        tool: &ToolBody,
        path: &TipMove,
        row: u32,
    ) -> (Vec<ColumnDrop>, Vec<GapChange>) {
        let length = path.curve.length();
        let count = (length / (COLUMNS * self.side)).ceil().clamp(1.0, MAX_PIECES);
        let (mut drops, mut gaps) = (Vec::new(), Vec::new());
        for k in 0..count as u32 {
            let [from, to] = [k, k + 1].map(|k| f64::from(k) / count);
            let curve = match count > 1.0 {
                true => path.curve.subsegment(length * from, length * to),
                false => path.curve,
            };
            stock.cut_below(&tool.undercuts, &[TipMove { curve, ..*path }]);
            let (bounds, margin) = (curve.bounds(), tool.radius() + self.side);
            let ends = [[bounds.min.x, bounds.max.x], [bounds.min.y, bounds.max.y]];
            let near = [0, 1].map(|axis| {
                let at = |place: f64| {
                    let column = ((place - self.low[axis]) / self.side).floor();
                    column.clamp(0.0, f64::from(self.columns[axis])) as u32
                };
                [at(ends[axis][0] - margin), at(ends[axis][1] + margin + self.side)]
            });
            let (some, more) = self.changed(stock, near, row, to as f32);
            drops.extend(some);
            gaps.extend(more);
        }
        (drops, gaps)
    }

    /// What has changed since the last report in a range of columns and rows.
    fn changed(
        &mut self,
        stock: &ColumnStock,
        [across, up]: [[u32; 2]; 2],
        row: u32,
        share: f32,
    ) -> (Vec<ColumnDrop>, Vec<GapChange>) {
        let (mut drops, mut changes) = (Vec::new(), Vec::new());
        for y in up[0]..up[1] {
            for x in across[0]..across[1] {
                let column = y * self.columns[0] + x;
                let Some(heights) = stock.heights_at(x, y) else { continue };
                let height = (heights.outer - self.top) as f32;
                let known = &mut self.heights[column as usize];
                if height < *known - EQUAL_HEIGHT_MM {
                    *known = height;
                    drops.push(ColumnDrop { column, row, share, height });
                }
                let [surely, _] = stock.gaps_at(x, y);
                let gaps: Vec<[f32; 2]> = surely
                    .iter()
                    .map(|gap| [gap.floor, gap.top].map(|height| (height - self.top) as f32))
                    .collect();
                if self.gaps.get(&column).map_or(&[][..], Vec::as_slice) != gaps {
                    self.gaps.insert(column, gaps.clone());
                    changes.push(GapChange { column, row, share, gaps });
                }
            }
        }
        (drops, changes)
    }
}
