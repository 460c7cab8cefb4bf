//! A program on stock as a list of column changes in order of time, for an animation that goes forward and backward.

mod hollows;

use chordal_stock::shape::{BodyBound, SolidShape};
use chordal_stock::{ColumnOptions, ColumnStock, LoweredColumn, Mode};

use super::gather::StockMoves;
use super::heights::ShapeHeights;
use super::run::StockRunError;
use super::setup::{NamedBody, SetupFileReader, shift_between};
use super::target::TARGET_TOLERANCE;
use super::tools::{ToolBody, tools_of};
use crate::job::Job;
use hollows::ReplayHollows;

/// Moves that are cut in one lot, whose changes are then reported together. Lots are larger where drops are thinned
/// out, since the last drop of each column in a lot is always reported.
const MOVES_PER_LOT: usize = 4096;
const MOVES_PER_THINNED_LOT: usize = 1 << 15;
/// Most moves of tools with undercuts whose cuts are shown: each takes a few milliseconds. With more of them, none
/// is.
const MAX_UNDERCUTS: usize = 5000;
/// The most memory of the columns, bytes.
const BUDGET: u64 = 1 << 30;
/// Round fixtures are approximated by triangles within this, mm.
const FIXTURE_SAG: f64 = 0.05;

/// The stock before the first cut.
#[derive(Clone, Debug, PartialEq)]
pub struct StockBefore {
    /// The corner of its box with the least coordinates, in the frame of the run, mm.
    pub low: [f64; 3],
    /// The corner with the largest, mm.
    pub high: [f64; 3],
    /// The side of a column, mm.
    pub resolution_mm: f64,
    /// Columns along X and Y; the last ones may reach over the box.
    pub columns: [u32; 2],
    /// The heights of the columns relative to the top of the box, mm: row by row from the least Y, each by X.
    pub heights: Vec<f32>,
    /// The same heights of the target part, and its tolerance, mm; `None` where no target is given.
    pub target: Option<(Vec<f32>, f64)>,
    /// The fixtures.
    pub fixtures: Vec<FixtureMesh>,
    /// What the replay leaves out.
    pub missing: ReplayOmissions,
}

/// A fixture as triangles.
#[derive(Clone, Debug, PartialEq)]
pub struct FixtureMesh {
    /// Its name in the setup.
    pub name: String,
    /// The corners of each triangle in the frame of the run, mm: nine numbers.
    pub corners: Vec<f32>,
}

/// What a replay leaves out.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ReplayOmissions {
    /// True where cuts of undercuts are left out, because there are too many moves of them.
    pub undercuts: bool,
    /// True where cuts in other orientations of the part are left out.
    pub turned: bool,
}

/// A column that a cut has lowered.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ColumnDrop {
    /// The column: `y · columns + x`.
    pub column: u32,
    /// The index of the path segment among all of the run.
    pub row: u32,
    /// The share of the segment that is done when the axis of the tool passes the column: from 0 to 1.
    pub share: f32,
    /// The new height relative to the top of the box, mm.
    pub height: f32,
}

/// The new gaps of a column from a moment on.
#[derive(Clone, Debug, PartialEq)]
pub struct GapChange {
    /// The column: `y · columns + x`.
    pub column: u32,
    /// The index of the path segment among all of the run.
    pub row: u32,
    /// The share of the segment that is done: from 0 to 1.
    pub share: f32,
    /// Its gaps from below, as floor and top relative to the top of the box, mm. A gap that reaches the height of the
    /// column is left out.
    pub gaps: Vec<[f32; 2]>,
}

/// The options of a replay.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ReplayOptions {
    /// Most columns; there are nearly as many.
    pub columns: u32,
    /// Drops are left out where a column appears too high without them by no more than this share of its side; zero
    /// leaves none out. After each tool, and after some thousand moves, all heights are right.
    pub lag: f64,
}

/// Receives the changes of a run on stock.
pub trait ReplaySink {
    /// The stock before the first cut.
    fn before(&mut self, stock: &StockBefore);
    /// Columns that were lowered, in the order of the run, and the share of the run that is done, from 0 to 1.
    /// Returns whether to go on.
    fn lowered(&mut self, drops: &[ColumnDrop], progress: f64) -> bool;
    /// Columns whose gaps have changed, in the order of the run. Returns whether to go on.
    fn gaps(&mut self, _changes: &[GapChange]) -> bool {
        true
    }
}

impl Job<'_> {
    /// Cuts the stock of the machine's setup, and reports what is lowered when. Heights are sampled in the middle of
    /// each column and have no bounds; see [`Job::stock`] for those. Cuts in other orientations of the part are left
    /// out. Returns what is left, or `None` where the sink did not want to go on.
    ///
    /// # Errors
    /// Without stock, with a setup that is incomplete, or with too many columns.
    pub fn replay_stock(
        &self,
        options: &ReplayOptions,
        files: SetupFileReader<'_>,
        replay: &mut dyn ReplaySink,
    ) -> Result<Option<ColumnStock>, StockRunError> {
        if self.turns() {
            return Err(StockRunError::Turns);
        }
        let setup = &self.machine().setup;
        let premise = self.stock_premise()?;
        let tools = tools_of(self);
        let mut gathered = StockMoves::new(self, &tools, false);
        self.report_watched(&mut gathered);
        let all = gathered.rows();
        let shape_of = |name: &str, body| {
            let named = NamedBody { name, body };
            let shift = shift_between(self.machine(), &named, gathered.work.as_deref())?;
            named.shape(shift, files, false)
        };
        let shape = shape_of("stock", &premise.body)?;
        let resolution = resolution_for(&shape, options.columns);
        let heights = ShapeHeights::new(&shape, resolution);
        let sampled =
            ColumnOptions { mode: Mode::Sampled, ..ColumnOptions::new(resolution, BUDGET) };
        let mut stock =
            ColumnStock::shaped(shape.bounds(), sampled, |low, high| heights.of(low, high))?;
        let target = match &setup.target {
            Some(body) => {
                let shape = shape_of("target", body)?;
                let tolerance = body.tolerance_mm.unwrap_or(TARGET_TOLERANCE);
                Some((target_heights(&shape, &stock), tolerance))
            }
            None => None,
        };
        if heights.is_hollow() {
            stock.hollow(&|corners| heights.hollows(corners));
        }
        let mut before = before(&stock, target);
        let of_undercuts = gathered.batches.iter().filter(|batch| {
            let is_undercut = |tool: &ToolBody| !tool.undercuts.is_empty();
            !batch.kind.is_rapid()
                && tools.get(&batch.tool).is_some_and(|tool| tool.as_ref().is_ok_and(is_undercut))
        });
        let undercuts = of_undercuts.map(|batch| batch.moves.len()).sum::<usize>() > MAX_UNDERCUTS;
        before.missing = ReplayOmissions { undercuts, turned: gathered.leaves_out_turned };
        for (name, body) in &setup.fixtures {
            let named = NamedBody { name, body };
            let shift = shift_between(self.machine(), &named, gathered.work.as_deref())?;
            let mesh = named.shape(shift, files, true)?.triangles(FIXTURE_SAG, BodyBound::Outer);
            let corners = (0..mesh.triangles().len()).flat_map(|at| mesh.corners(at));
            let corners = corners.flat_map(|at| at.to_array().map(|mm| mm as f32)).collect();
            before.fixtures.push(FixtureMesh { name: name.clone(), corners });
        }
        replay.before(&before);
        let mut hollows = ReplayHollows::new(&before);
        if heights.is_hollow() && !replay.gaps(&hollows.all(&stock)) {
            return Ok(None);
        }
        let mut thinning = (options.lag > 0.0).then(|| {
            let most = (options.lag * resolution) as f32;
            ReplayThinning { most, last: vec![0; before.heights.len()], shown: before.heights }
        });
        let at_once = if thinning.is_some() { MOVES_PER_THINNED_LOT } else { MOVES_PER_LOT };
        for batch in &gathered.batches {
            let Some(Ok(tool)) = tools.get(&batch.tool) else { continue };
            if batch.kind.is_rapid() {
                continue;
            }
            if !tool.undercuts.is_empty() {
                if undercuts {
                    continue;
                }
                for (path, row) in batch.moves.iter().zip(&batch.rows) {
                    let (drops, gaps) = hollows.cut(&mut stock, tool, path, *row);
                    let done = f64::from(row + 1) / f64::from(all.max(1));
                    if !replay.lowered(&drops, done) || !replay.gaps(&gaps) {
                        return Ok(None);
                    }
                }
                continue;
            }
            for (moves, rows) in batch.moves.chunks(at_once).zip(batch.rows.chunks(at_once)) {
                let mut lowered = stock.cut_telling(tool.removes(), moves);
                if let Some(thinning) = &mut thinning {
                    thinning.thin(&mut lowered);
                }
                let drops: Vec<ColumnDrop> = lowered
                    .iter()
                    .map(|at| ColumnDrop {
                        column: at.cell,
                        row: rows[at.number as usize],
                        share: at.share,
                        height: at.height,
                    })
                    .collect();
                hollows.lowered(&drops);
                let last = rows.last().map_or(0, |row| row + 1);
                if !replay.lowered(&drops, f64::from(last) / f64::from(all.max(1))) {
                    return Ok(None);
                }
            }
        }
        Ok(Some(stock))
    }
}

/// Thins out drops that would hardly be visible.
struct ReplayThinning {
    /// A column may appear too high by this, mm.
    most: f32,
    /// The last reported height of each column.
    shown: Vec<f32>,
    /// The index of the last drop of each column in the lot.
    last: Vec<usize>,
}

impl ReplayThinning {
    fn thin(&mut self, lowered: &mut Vec<LoweredColumn>) {
        for (place, at) in lowered.iter().enumerate() {
            self.last[at.cell as usize] = place;
        }
        let mut place = 0;
        lowered.retain(|at| {
            let cell = at.cell as usize;
            let is_reported = self.last[cell] == place || self.shown[cell] - at.height > self.most;
            place += 1;
            if is_reported {
                self.shown[cell] = at.height;
            }
            is_reported
        });
    }
}

fn before(stock: &ColumnStock, target: Option<(Vec<f32>, f64)>) -> StockBefore {
    let grid = stock.grid();
    let (min, max) = (grid.bounds().min, grid.bounds().max);
    let heights = stock.height_pairs();
    StockBefore {
        low: [min.x, min.y, min.z],
        high: [max.x, max.y, max.z],
        resolution_mm: grid.resolution(),
        columns: grid.cells(),
        heights: heights.iter().map(|at| (at.outer - max.z) as f32).collect(),
        target,
        fixtures: Vec::new(),
        missing: ReplayOmissions::default(),
    }
}

/// The heights of the part over the columns of the stock relative to its top, mm: midway between their bounds.
fn target_heights(shape: &SolidShape, stock: &ColumnStock) -> Vec<f32> {
    let grid = stock.grid();
    let heights = ShapeHeights::new(shape, grid.resolution());
    let [columns, rows] = grid.cells();
    let (bottom, top) = (grid.bounds().min.z, grid.bounds().max.z);
    let cells = (0..rows).flat_map(|row| (0..columns).map(move |column| (column, row)));
    let height = |(column, row)| {
        let [low, high] = grid.corners(column, row);
        let [outer, inner] = heights.of(low, high);
        (0.5 * (outer.max(bottom) + inner.max(bottom)) - top) as f32
    };
    cells.map(height).collect()
}

/// A resolution of two digits with at most this many columns, mm.
fn resolution_for(stock: &SolidShape, columns: u32) -> f64 {
    let size = stock.bounds().size();
    let most = f64::from(columns.max(1));
    let least = (size.x * size.y / most).sqrt();
    let digit = libm::pow(10.0, libm::floor(libm::log10(least)) - 1.0);
    let count = |steps: f64| {
        let along = |length: f64| (length / (steps * digit)).ceil();
        along(size.x) * along(size.y)
    };
    let mut steps = (least / digit).ceil();
    // Columns that reach over the edge count, too. The loop ends at one column for the whole stock.
    while count(steps) > most && steps * digit < size.x.max(size.y) {
        steps += 1.0;
    }
    steps * digit
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_left_out_is_small_and_never_the_last() {
        let at = |cell, share, height| LoweredColumn { cell, number: 0, share, height };
        let mut thinning = ReplayThinning { most: 0.1, shown: vec![0.0; 2], last: vec![0; 2] };
        let mut lowered = vec![
            at(0, 0.1, -0.06),
            at(1, 0.2, -0.5),
            at(0, 0.3, -0.12),
            at(0, 0.4, -0.2),
            at(0, 0.5, -0.21),
        ];
        thinning.thin(&mut lowered);
        // −0.06 is less than a tenth below 0, −0.2 less than a tenth below −0.12.
        assert_eq!(lowered, [at(1, 0.2, -0.5), at(0, 0.3, -0.12), at(0, 0.5, -0.21)]);
        let mut next = vec![at(1, 0.1, -0.55), at(1, 0.2, -0.56)];
        thinning.thin(&mut next);
        assert_eq!(next, [at(1, 0.2, -0.56)]);
    }
}
