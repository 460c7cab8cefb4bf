//! Stock as columns along Z, in tiles, with two heights for each cell that bound the true surface.
//!
//! A cell is a square of the grid. The stock is nowhere on the cell higher than its *outer* height; below its *inner*
//! height, down to the bottom, everything on the cell is stock. A cut lowers the outer height to what it certainly
//! removes, and the inner one to what it may remove.
//!
//! [`ColumnStock::cut`] does everything in one call. A caller with threads makes a [`StockPlan`] of moves, gets a
//! [`TileJob`] for each tile that they meet ([`ColumnStock::jobs`]), and runs these in any order: the result is the
//! same to the bit.

mod block;
mod check;
mod gaps;
mod grid;
mod heights;
mod job;
mod job_result;
mod plan;
mod recorder;
mod tile;
mod touch;
mod turning_move;
mod undercut_move;
mod volume;
mod window;

use chordal_geometry::Aabb;

pub use check::{CheckedStock, JobRunner, StockCheck};
pub use grid::StockGrid;
pub use heights::{CellCeiling, CellHollows};
pub use job::TileJob;
pub use job_result::{ColumnCounts, JobResult};
pub use plan::{StockPlan, StockTask};
pub use recorder::LoweredColumn;
pub use touch::{ContactDepth, TouchAnswer};
pub use turning_move::TurningTask;
pub use volume::{CellHeights, OTHERS, VolumeInterval};
pub(crate) use window::{HeightWindow, StockLimits};

use crate::sweep::{RevolvedBody, TipMove};
use crate::{CutterProfile, RemovedSpan, Undercut};
use tile::StockTile;

/// How the heights of cells are computed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Mode {
    /// Two heights that bound the true surface everywhere on the cell.
    #[default]
    Certified,
    /// One height, that in the middle of the cell: not a bound, in about half the time.
    Sampled,
}

/// The options of a stock.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ColumnOptions {
    /// The side of a cell, mm.
    pub resolution: f64,
    /// How heights are computed.
    pub mode: Mode,
    /// Curves are divided into straight pieces within this share of the resolution, which the bounds allow for.
    pub chord_share: f64,
    /// Whether the height in the middle of each cell is kept in addition to the bounds, for surfaces and pictures
    /// ([`ColumnStock::middles`]). Takes 50 % more memory.
    pub middles: bool,
    /// Whether volumes are counted for each tag of moves. Copies of blocks are then kept while the moves of one tag
    /// change them, which may double the memory.
    pub by_tag: bool,
    /// Most memory of the columns, bytes.
    pub budget: u64,
}

impl ColumnOptions {
    /// Most bytes of the gaps in a tile: an equal share of what the columns leave of the budget.
    pub(crate) fn gap_bytes(&self, grid: &StockGrid) -> usize {
        let rest = self.budget as f64 - tile::bytes(grid.bounds(), self.resolution, self);
        (rest.max(0.0) / grid.tiles() as f64) as usize
    }

    /// Whether three heights are kept for each cell.
    pub(crate) fn keeps_middles(&self) -> bool {
        self.middles && self.mode == Mode::Certified
    }

    /// Certified columns with a resolution (mm) and a budget (bytes), with curves within a tenth of the resolution,
    /// without heights in the middles and volumes by tag.
    pub const fn new(resolution: f64, budget: u64) -> ColumnOptions {
        ColumnOptions {
            resolution,
            mode: Mode::Certified,
            chord_share: 0.1,
            middles: false,
            by_tag: false,
            budget,
        }
    }
}

/// Why a stock cannot be made.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum StockError {
    /// A number of the options that must be above zero is not.
    #[error("the {what} must be above zero, it is {value}")]
    NotPositive {
        /// What it is.
        what: &'static str,
        /// Its value.
        value: f64,
    },
    /// The stock has no volume, or its box is not finite.
    #[error("the stock's box has no volume, or is not finite")]
    Empty,
    /// One column would be wider than the stock.
    #[error("at {resolution} mm one column is wider than the stock; at {widest:.3} mm it is not")]
    TooCoarse {
        /// The requested resolution, mm.
        resolution: f64,
        /// The widest column that fits in the stock, mm.
        widest: f64,
    },
    /// More columns than the budget allows.
    #[error(
        "at {resolution} mm the stock needs up to {needed} bytes, {budget} are allowed; at {fits:.3} mm it fits"
    )]
    TooFine {
        /// The requested resolution, mm.
        resolution: f64,
        /// Bytes that it would need.
        needed: u64,
        /// Bytes that are allowed.
        budget: u64,
        /// The finest resolution that fits, mm; infinite if none does.
        fits: f64,
    },
}

/// Moves in one plan: enough to make the lists of tiles worthwhile, few enough to stay in memory.
const MOVES_PER_PLAN: usize = 1 << 15;

/// A stock from which tools remove material.
#[derive(Clone, Debug)]
pub struct ColumnStock {
    grid: StockGrid,
    options: ColumnOptions,
    tiles: Vec<StockTile>,
    /// The volume at the beginning, mm³.
    begun: VolumeInterval,
}

impl ColumnStock {
    /// A full box, mm.
    ///
    /// # Errors When the box or the options are not valid, or the columns do not fit in the budget.
    pub fn new(bounds: Aabb, options: ColumnOptions) -> Result<ColumnStock, StockError> {
        ColumnStock::shaped(bounds, options, |_, _| [bounds.max.z, bounds.max.z])
    }

    /// Stock of any shape in a box, mm. `heights` gets the corners of a cell (least and largest x and y) and returns
    /// a height above which there is no stock on it, and one below which all of the cell is stock, down to the bottom
    /// of the box. Where middles are kept and the two differ, it is also called for a cell of 1e-6 mm in the middle.
    ///
    /// # Errors
    /// As [`ColumnStock::new`].
    pub fn shaped(
        bounds: Aabb,
        options: ColumnOptions,
        heights: impl Fn([f64; 2], [f64; 2]) -> [f64; 2],
    ) -> Result<ColumnStock, StockError> {
        let positive = |what, value: f64| {
            let right = value > 0.0 && value.is_finite();
            if right { Ok(()) } else { Err(StockError::NotPositive { what, value }) }
        };
        positive("resolution", options.resolution)?;
        positive("share of the resolution", options.chord_share)?;
        let size = bounds.size();
        if !(size.is_finite() && size.x > 0.0 && size.y > 0.0 && size.z > 0.0) {
            return Err(StockError::Empty);
        }
        let widest = size.x.min(size.y);
        if options.resolution > widest {
            return Err(StockError::TooCoarse { resolution: options.resolution, widest });
        }
        let needed = |resolution: f64| tile::bytes(bounds, resolution, &options);
        if needed(options.resolution) > options.budget as f64 {
            return Err(StockError::TooFine {
                resolution: options.resolution,
                needed: needed(options.resolution) as u64,
                budget: options.budget,
                fits: tile::finest(bounds, &options),
            });
        }
        let grid = StockGrid::new(bounds, options.resolution);
        let tiles =
            (0..grid.tiles()).map(|number| StockTile::new(&grid, &options, number, &heights));
        let mut stock =
            ColumnStock { tiles: tiles.collect(), grid, options, begun: VolumeInterval::default() };
        stock.begun = stock.left();
        Ok(stock)
    }

    /// The grid of its cells.
    pub fn grid(&self) -> &StockGrid {
        &self.grid
    }

    /// Its options.
    pub fn options(&self) -> &ColumnOptions {
        &self.options
    }

    /// Removes what a cutter sweeps on its moves, in order.
    pub fn cut(&mut self, cutter: &CutterProfile, moves: &[TipMove]) -> ColumnCounts {
        let mut counts = ColumnCounts::default();
        let task = StockTask { cutter: Some(cutter), moves, ..StockTask::default() };
        for (_, task) in check::chunks(task) {
            counts = self.run(&self.plan(&task)).1.plus(counts);
        }
        counts
    }

    /// Removes what undercuts sweep, each with the height of its lower end above the tip of the moves, mm.
    pub fn cut_below(&mut self, undercuts: &[(f64, Undercut)], moves: &[TipMove]) -> ColumnCounts {
        let mut counts = ColumnCounts::default();
        let task = StockTask { undercuts, moves, ..StockTask::default() };
        for (_, task) in check::chunks(task) {
            counts = self.run(&self.plan(&task)).1.plus(counts);
        }
        counts
    }

    /// Counts what a cutter sweeps as possibly removed: only inner heights are lowered.
    pub fn cut_at_most(&mut self, cutter: &CutterProfile, moves: &[TipMove]) {
        let task = StockTask { may: Some(cutter), moves, ..StockTask::default() };
        for (_, task) in check::chunks(task) {
            self.run(&self.plan(&task));
        }
    }

    /// Like [`ColumnStock::cut`], and returns the columns that were lowered, in the order in which the axis of the
    /// tool passes them. Columns under the tool that its axis has not passed yet are reported later; a picture shows
    /// them cut by the tool itself.
    pub fn cut_telling(&mut self, cutter: &CutterProfile, moves: &[TipMove]) -> Vec<LoweredColumn> {
        let mut all = Vec::new();
        let task = StockTask { cutter: Some(cutter), moves, ..StockTask::default() };
        for (first, task) in check::chunks(task) {
            let plan = self.plan(&task);
            let shares = recorder::shares(&plan.pieces);
            let jobs = self.jobs(&plan).into_iter();
            let mut lowered: Vec<LoweredColumn> =
                jobs.flat_map(|job| job.run_recording(&shares).1).collect();
            // The sort is stable: two changes of a column at one moment keep their order.
            lowered.sort_by(|a, b| a.number.cmp(&b.number).then(a.share.total_cmp(&b.share)));
            let numbered = |at: LoweredColumn| LoweredColumn { number: first + at.number, ..at };
            all.extend(lowered.into_iter().map(numbered));
        }
        all
    }

    /// How deep a body touches the stock on each of its moves; nothing is removed. For a rapid of a cutter use
    /// [`RevolvedBody::of_cutter`].
    pub fn touch(&mut self, body: &RevolvedBody, moves: &[TipMove]) -> Vec<ContactDepth> {
        let mut contacts = Vec::new();
        let task = StockTask { bodies: core::slice::from_ref(body), moves, ..StockTask::default() };
        for (_, task) in check::chunks(task) {
            contacts.extend(self.run(&self.plan(&task)).0.into_iter().flatten());
        }
        contacts
    }

    /// Removes what a cutter sweeps, and returns for each body (shank, holder, the part above the edges) and each
    /// move how deep the body touches what the cutter has left so far. `drop`: see [`StockTask::drop`].
    pub fn cut_watching(
        &mut self,
        cutter: &CutterProfile,
        bodies: &[RevolvedBody],
        moves: &[TipMove],
        drop: f64,
    ) -> Vec<Vec<ContactDepth>> {
        let mut contacts = vec![Vec::new(); bodies.len()];
        let task = StockTask { cutter: Some(cutter), bodies, moves, drop, ..StockTask::default() };
        for (_, task) in check::chunks(task) {
            let (found, _) = self.run(&self.plan(&task));
            for (all, some) in contacts.iter_mut().zip(found) {
                all.extend(some);
            }
        }
        contacts
    }

    /// Like [`ColumnStock::cut_below`], and returns for each body (neck, holder) and each move how deep the body
    /// touches what is left when it comes. Bodies are above the undercuts.
    pub fn cut_watching_below(
        &mut self,
        undercuts: &[(f64, Undercut)],
        bodies: &[RevolvedBody],
        moves: &[TipMove],
    ) -> Vec<Vec<ContactDepth>> {
        let mut contacts = vec![Vec::new(); bodies.len()];
        for (_, task) in
            check::chunks(StockTask { undercuts, bodies, moves, ..StockTask::default() })
        {
            let (found, _) = self.run(&self.plan(&task));
            for (all, some) in contacts.iter_mut().zip(found) {
                all.extend(some);
            }
        }
        contacts
    }

    /// Removes what a tool sweeps while its direction turns, and returns for each body and each move how deep the body
    /// touches what is left when it comes. `tolerance`: a depth that does not count, mm.
    pub fn cut_turning(
        &mut self,
        turning: TurningTask<'_>,
        moves: &[TipMove],
        tolerance: f64,
    ) -> Vec<Vec<ContactDepth>> {
        let mut contacts = vec![Vec::new(); turning.bodies.len()];
        let task =
            StockTask { turning: Some(turning), moves, drop: tolerance, ..StockTask::default() };
        for (_, task) in check::chunks(task) {
            let (found, _) = self.run(&self.plan(&task));
            for (all, some) in contacts.iter_mut().zip(found) {
                all.extend(some);
            }
        }
        contacts
    }

    /// Adds hollows that the stock has below its tops before the first cut. Where they take more memory than the
    /// budget leaves, the bounds become wider.
    pub fn hollow(&mut self, hollows: &CellHollows<'_>) {
        let limit = self.options.gap_bytes(&self.grid);
        for (number, tile) in self.tiles.iter_mut().enumerate() {
            tile.begin_hollow(&self.grid, number, limit, hollows);
        }
        self.begun = self.left();
    }

    /// Lowers cells for a reason other than moves, to heights above which nothing is left. Volumes by tag count it
    /// for [`OTHERS`].
    pub fn lower(&mut self, lower: &CellCeiling<'_>) {
        for (number, tile) in self.tiles.iter_mut().enumerate() {
            tile.lower(&self.grid, number, self.options.by_tag, lower);
        }
    }

    /// The plan of a task: the tiles that its moves meet, and the steps on each.
    pub fn plan(&self, task: &StockTask<'_>) -> StockPlan {
        StockPlan::new(&self.grid, &self.options, task)
    }

    /// Runs all jobs of a plan, one after the other.
    fn run(&mut self, plan: &StockPlan) -> (Vec<Vec<ContactDepth>>, ColumnCounts) {
        let found: Vec<JobResult> = self.jobs(plan).into_iter().map(TileJob::run).collect();
        let counts = found
            .iter()
            .map(|found| found.counts)
            .fold(ColumnCounts::default(), ColumnCounts::plus);
        (plan.contacts(&found), counts)
    }

    /// One job for each tile of a plan of this stock. They may run in any order and on any thread, but all of them
    /// before those of the next plan.
    pub fn jobs<'a>(&'a mut self, plan: &'a StockPlan) -> Vec<TileJob<'a>> {
        let grid = &self.grid;
        let options = &self.options;
        let mut tiles = self.tiles.iter_mut().enumerate();
        plan.tiles()
            .filter_map(|(number, todo)| {
                let (_, tile) = tiles.find(|(at, _)| *at == number)?;
                Some(TileJob { grid, options, number, tile, plan, todo })
            })
            .collect()
    }

    /// The volume that is left, mm³.
    pub fn left(&self) -> VolumeInterval {
        let tiles = self.tiles.iter().enumerate();
        tiles
            .map(|(number, tile)| tile.left(&self.grid, number))
            .fold(VolumeInterval::default(), VolumeInterval::plus)
    }

    /// The removed volume, mm³.
    pub fn removed(&self) -> VolumeInterval {
        let left = self.left();
        let all = VolumeInterval {
            least: (self.begun.least - left.most).max(0.0),
            most: self.begun.most - left.least,
        };
        if !self.options.by_tag {
            return all;
        }
        let by_tag = self.removed_by_tag().into_iter();
        let sum = by_tag.fold(VolumeInterval::default(), |sum, (_, amount)| sum.plus(amount));
        // Both intervals contain the true volume. The sum by tag is not widened by cells that no move has met; the
        // whole is not widened by the uncertainty that counts anew for each tag.
        VolumeInterval { least: all.least.max(sum.least), most: all.most.min(sum.most) }
    }

    /// What the moves of each tag have removed, mm³, by ascending tags; empty without [`ColumnOptions::by_tag`].
    pub fn removed_by_tag(&self) -> Vec<(u32, VolumeInterval)> {
        let mut amounts = Vec::new();
        for (number, tile) in self.tiles.iter().enumerate() {
            tile.removed(&self.grid, number, &mut amounts);
        }
        amounts
    }

    /// The outer and inner heights of all cells, mm: row by row from the least y, each by x.
    pub fn height_pairs(&self) -> Vec<CellHeights> {
        let top = self.grid.bounds().max.z;
        self.by_cell(CellHeights { outer: top, inner: top }, |tile, block| {
            let heights = tile.get(block);
            core::array::from_fn(|cell| CellHeights {
                outer: top + f64::from(heights.outer[cell]),
                inner: top + f64::from(heights.inner[cell]),
            })
        })
    }

    /// A value for each cell, computed by blocks: row by row from the least y, each by x.
    fn by_cell<T: Copy>(
        &self,
        begun: T,
        of_block: impl Fn(&StockTile, usize) -> [T; grid::CELLS],
    ) -> Vec<T> {
        let [columns, rows] = self.grid.cells().map(|cells| cells as usize);
        let mut all = vec![begun; columns * rows];
        for (number, tile) in self.tiles.iter().enumerate() {
            let first = self.grid.first_cell(number).map(|cell| cell as usize);
            for block in 0..grid::BLOCKS * grid::BLOCKS {
                let x = first[0] + block % grid::BLOCKS * grid::BLOCK;
                let y = first[1] + block / grid::BLOCKS * grid::BLOCK;
                if x >= columns || y >= rows {
                    continue;
                }
                let values = of_block(tile, block);
                let width = grid::BLOCK.min(columns - x);
                for (row, values) in values.chunks_exact(grid::BLOCK).enumerate() {
                    if y + row < rows {
                        let from = (y + row) * columns + x;
                        all[from..from + width].copy_from_slice(&values[..width]);
                    }
                }
            }
        }
        all
    }

    /// The outer and the inner height of a cell (column, row), mm; `None` outside the grid.
    pub fn heights_at(&self, column: u32, row: u32) -> Option<CellHeights> {
        let [columns, rows] = self.grid.cells();
        if column >= columns || row >= rows {
            return None;
        }
        let (tile, cell) = self.grid.tile_of(column, row);
        let [outer, inner] = self.tiles[tile].heights(cell);
        let top = self.grid.bounds().max.z;
        Some(CellHeights { outer: top + f64::from(outer), inner: top + f64::from(inner) })
    }

    /// The height in the middle of each cell, between its bounds, mm: row by row from the least y, each by x. It is
    /// the height that the moves leave there, up to rounding and the deviation of straight pieces from curves; so a
    /// cell with a wall through it has the level on one side of the wall. Midway between the bounds without
    /// [`ColumnOptions::middles`].
    pub fn middles(&self) -> Vec<f64> {
        let top = self.grid.bounds().max.z;
        self.by_cell(0.0, |tile, block| {
            let (heights, middles) = (tile.get(block), tile.middles(block));
            core::array::from_fn(|cell| {
                let [outer, inner] = [heights.outer[cell], heights.inner[cell]].map(f64::from);
                let middle = middles.map_or(0.5 * (outer + inner), |all| f64::from(all[cell]));
                top + middle.min(outer).max(inner)
            })
        })
    }

    /// What undercuts have removed in the middle of a cell (column, row) below its height there, from below, mm;
    /// empty without [`ColumnOptions::middles`].
    pub fn gaps_in_middle(&self, column: u32, row: u32) -> Vec<RemovedSpan> {
        let of = |column: &gaps::ColumnGaps| self.spans(&column.middle);
        self.column_at(column, row).map_or_else(Vec::new, of)
    }

    fn column_at(&self, column: u32, row: u32) -> Option<&gaps::ColumnGaps> {
        let [columns, rows] = self.grid.cells();
        if column >= columns || row >= rows {
            return None;
        }
        let (tile, cell) = self.grid.tile_of(column, row);
        self.tiles[tile].gaps().of(cell)
    }

    fn spans(&self, gaps: &[gaps::ColumnGap]) -> Vec<RemovedSpan> {
        let top = self.grid.bounds().max.z;
        let span = |gap: &gaps::ColumnGap| {
            let [floor, top] = gap.map(|height| top + f64::from(height));
            RemovedSpan { floor, top }
        };
        gaps.iter().map(span).collect()
    }

    /// What undercuts have removed from a cell (column, row) below its heights, from below, mm: what is certainly
    /// removed everywhere on it, and what may be removed anywhere on it.
    pub fn gaps_at(&self, column: u32, row: u32) -> [Vec<RemovedSpan>; 2] {
        match self.column_at(column, row) {
            Some(column) => [self.spans(&column.surely), self.spans(&column.maybe)],
            None => [Vec::new(), Vec::new()],
        }
    }

    /// Whether columns have gaps, so that heights alone do not describe what is left.
    pub fn has_gaps(&self) -> bool {
        self.tiles.iter().any(|tile| !tile.gaps().is_empty())
    }

    /// The bytes that its columns currently take.
    pub fn bytes(&self) -> u64 {
        self.tiles.iter().map(StockTile::bytes).sum()
    }
}
