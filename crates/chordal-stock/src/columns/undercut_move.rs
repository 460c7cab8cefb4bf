//! Moves of undercuts: cutters that remove from a column what is between their lower and their upper side.
//!
//! A move is processed as a whole and in double precision: there are few such moves, and its spans are known for
//! every kind of path.

use chordal_geometry::{Curve, ParamCurve};

use super::ContactDepth;
use super::gaps::SolidColumn;
use super::grid::{BLOCK, BLOCKS, CELLS, StockGrid};
use super::heights::POINT;
use super::tile::StockTile;
use crate::floor::merge;
use crate::{CutterSweep, RemovedSpan, Undercut};

/// The gap between the bounds where there is no closed form, mm: far below any resolution, yet cheap.
const BOUNDS_GAP_MM: f64 = 1e-4;

/// A whole move of an undercut.
#[derive(Clone, Debug)]
pub(crate) struct UndercutMove {
    /// Index of the cutter in the plan.
    pub cutter: u32,
    /// The path of the cutter's lower end.
    pub curve: Curve,
    /// Index of the move in its list.
    pub number: u32,
    pub tag: u32,
}

impl UndercutMove {
    /// The first and the last tile (or block) of this width that it meets, along X and Y from an origin; none where
    /// the first is larger.
    pub fn range(
        &self,
        radius: f64,
        origin: [f64; 2],
        width: f64,
        counts: [u32; 2],
    ) -> [[i64; 2]; 2] {
        let bounds = self.curve.bounds();
        let ends = [[bounds.min.x, bounds.max.x], [bounds.min.y, bounds.max.y]];
        [0, 1].map(|axis| {
            let [low, high] = ends[axis];
            let from = ((low - radius - origin[axis]) / width).floor();
            let to = ((high + radius - origin[axis]) / width).floor();
            let most = f64::from(counts[axis]);
            [from.clamp(0.0, most) as i64, to.clamp(-1.0, most - 1.0) as i64]
        })
    }

    /// Whether its tip rises somewhere, and whether it falls.
    pub fn rises_and_falls(curve: &Curve) -> [bool; 2] {
        let (start, end, bounds) = (curve.start(), curve.end(), curve.bounds());
        match curve {
            Curve::Line(_) => [end.z > start.z, end.z < start.z],
            // Level up to rounding, or a helix that only rises or only falls.
            Curve::Arc(arc) if arc.w.x == 0.0 && arc.w.y == 0.0 => {
                [end.z > start.z, end.z < start.z]
            }
            _ => [bounds.max.z > start.z.min(end.z), bounds.min.z < start.z.max(end.z)],
        }
    }
}

/// A move of an undercut on a tile.
pub(crate) struct OnTile<'a> {
    pub grid: &'a StockGrid,
    pub number: usize,
    pub tile: &'a mut StockTile,
    pub below: &'a UndercutMove,
    pub cutter: &'a Undercut,
    pub by_tag: bool,
    /// Whether the spans in the middles of cells are kept.
    pub keeps_middles: bool,
    /// Most bytes that the gaps of the tile may take.
    pub limit: usize,
}

/// The spans of a cell, relative to the stock's top.
#[derive(Default)]
struct CellSpans {
    surely: Vec<RemovedSpan>,
    maybe: Vec<RemovedSpan>,
    /// Those in the middle of the cell, after [`CellSpans::find_middle`].
    middle: Vec<RemovedSpan>,
}

/// Where the bounds of a span differ by less than this, mm, its ends in the middle of the cell are taken midway.
const MIDPOINT_SPAN_MM: f64 = 2e-3;

impl CellSpans {
    /// Finds the spans of a square; false where the move does not meet it.
    fn find(&mut self, sweep: &CutterSweep<'_>, middle: [f64; 2], side: f64, top: f64) -> bool {
        self.surely.clear();
        self.maybe.clear();
        sweep.cell_spans(middle, side, &mut self.surely, &mut self.maybe);
        for spans in [&mut self.surely, &mut self.maybe] {
            from_top(spans, top);
        }
        !self.maybe.is_empty()
    }

    /// Finds the spans in the middle of a square.
    fn find_middle(&mut self, sweep: &CutterSweep<'_>, middle: [f64; 2], top: f64) {
        self.middle.clear();
        let is_near = |(a, b): (&RemovedSpan, &RemovedSpan)| {
            (a.floor - b.floor).abs() < MIDPOINT_SPAN_MM && (a.top - b.top).abs() < MIDPOINT_SPAN_MM
        };
        let mut pairs = self.surely.iter().zip(&self.maybe);
        if self.surely.len() == self.maybe.len() && pairs.all(is_near) {
            self.middle.extend(self.surely.iter().zip(&self.maybe).map(|(a, b)| RemovedSpan {
                floor: 0.5 * (a.floor + b.floor),
                top: 0.5 * (a.top + b.top),
            }));
            return;
        }
        // In so small a cell, what may be removed is removed.
        sweep.cell_spans(middle, POINT, &mut Vec::new(), &mut self.middle);
        from_top(&mut self.middle, top);
    }

    fn lowest(&self) -> f64 {
        self.maybe.first().map_or(f64::INFINITY, |span| span.floor)
    }
}

/// Merges spans, and makes them relative to a top, mm.
fn from_top(spans: &mut Vec<RemovedSpan>, top: f64) {
    merge(spans);
    for span in spans {
        (span.floor, span.top) = (span.floor - top, span.top - top);
    }
}

impl OnTile<'_> {
    /// Calls `found` for each cell that the move may meet, and returns their number.
    fn each(
        &mut self,
        finds_middles: bool,
        mut found: impl FnMut(&mut Self, [usize; 2], &CellSpans),
    ) -> u64 {
        let sweep = CutterSweep::of_undercut(self.cutter, &self.below.curve, BOUNDS_GAP_MM);
        let (cell, corner) = (self.grid.resolution(), self.grid.corner(self.number));
        let top = self.grid.bounds().max.z;
        let width = cell * BLOCK as f64;
        let [first_column, first_row] = self.grid.first_cell(self.number);
        let [columns, rows] = self.grid.cells();
        let radius = self.cutter.radius() + cell;
        let [across, up] = self.below.range(radius, corner, width, [BLOCKS as u32; 2]);
        let mut spans = CellSpans::default();
        let mut count = 0;
        for row in up[0]..=up[1] {
            for column in across[0]..=across[1] {
                let block = row as usize * BLOCKS + column as usize;
                let middle = [column as f64, row as f64].map(|at| (at + 0.5) * width);
                let middle = [corner[0] + middle[0], corner[1] + middle[1]];
                if !spans.find(&sweep, middle, width, top)
                    || spans.lowest() >= f64::from(self.tile.range(block).outer[1])
                {
                    continue;
                }
                for at in 0..CELLS {
                    let x = column as usize * BLOCK + at % BLOCK;
                    let y = row as usize * BLOCK + at / BLOCK;
                    if x as u32 + first_column >= columns || y as u32 + first_row >= rows {
                        continue;
                    }
                    let middle = [x, y].map(|n| (n as f64 + 0.5) * cell);
                    let middle = [corner[0] + middle[0], corner[1] + middle[1]];
                    if spans.find(&sweep, middle, cell, top) {
                        count += 1;
                        if finds_middles {
                            spans.find_middle(&sweep, middle, top);
                        }
                        found(self, [block, at], &spans);
                    }
                }
            }
        }
        count
    }

    /// Removes what the cutter sweeps, and returns the number of cells that were examined.
    pub fn cut(mut self) -> u64 {
        let bottom = super::heights::bottom(self.grid);
        self.each(self.keeps_middles, |on, place, spans| {
            let heights = on.tile.heights(place);
            if spans.lowest() < f64::from(heights[0]) {
                if on.by_tag {
                    on.tile.keep(on.below.tag, place[0], on.grid, on.number);
                }
                let found = [&spans.surely[..], &spans.maybe[..], &spans.middle[..]];
                on.tile.hollow(place, found, bottom, on.limit);
            }
        })
    }

    /// The contact of the cutter with the stock, and the number of cells that were examined.
    pub fn compare(mut self) -> (ContactDepth, u64) {
        let bounds = self.grid.bounds();
        let (top, bottom) = (bounds.max.z, -bounds.size().z);
        let (cell, corner) = (self.grid.resolution(), self.grid.corner(self.number));
        let mut deepest = ContactDepth::NONE;
        let count = self.each(false, |on, place, spans| {
            let [outer, inner] = on.tile.heights(place);
            let column = on.tile.gaps().of(place);
            let [surely, maybe] =
                column.map_or([&[][..]; 2], |column| [&column.surely[..], &column.maybe[..]]);
            let depth = |solid: SolidColumn<'_>, spans: &[RemovedSpan]| {
                let of = |span: &RemovedSpan| solid.within(bottom, [span.floor, span.top]);
                spans.iter().map(of).fold(0.0, f64::max)
            };
            let most = depth(SolidColumn { height: outer, gaps: surely }, &spans.maybe);
            let least = depth(SolidColumn { height: inner, gaps: maybe }, &spans.surely);
            deepest.least = deepest.least.max(least);
            if most > deepest.most {
                let [block, at] = place;
                let x = block % BLOCKS * BLOCK + at % BLOCK;
                let y = block / BLOCKS * BLOCK + at / BLOCK;
                let [x, y] = [x, y].map(|n| (n as f64 + 0.5) * cell);
                let z = spans.maybe.last().map_or(0.0, |span| span.top.min(f64::from(outer)));
                deepest.most = most;
                deepest.at = [corner[0] + x, corner[1] + y, top + z];
            }
        });
        (deepest, count)
    }
}
