//! Carries out the steps of a plan on one tile.

use wide::{CmpGt, f32x4};

use super::block::{BlockPart, certified, sampled};
use super::grid::{BLOCK, BLOCKS, CELLS, GROUPS, LANES, StockGrid, TILE};
use super::heights::{HeightRange, bottom};
use super::plan::{PlanStep, StepAction};
use super::recorder::{LoweredColumn, TileRecorder};
use super::tile::StockTile;
use super::turning_move::TurningOnTile;
use super::undercut_move::OnTile;
use super::{ColumnOptions, ContactDepth, JobResult, Mode, StockPlan};
use crate::sweep::lanes::{CourseFrame, TileCourse};
use crate::sweep::shape::{AnyShape, PartKind};
use crate::sweep::strip::across;
use crate::sweep::{BodyPart as CutterPart, SweepPiece};

/// The steps of a plan on one tile.
#[derive(Debug)]
pub struct TileJob<'a> {
    pub(crate) grid: &'a StockGrid,
    pub(crate) options: &'a ColumnOptions,
    pub(crate) number: usize,
    pub(crate) tile: &'a mut StockTile,
    pub(crate) plan: &'a StockPlan,
    pub(crate) todo: &'a [(u32, u32)],
}

impl TileJob<'_> {
    /// Carries out the steps, in the order of the program.
    pub fn run(self) -> JobResult {
        self.run_with(None).0
    }

    /// Like [`TileJob::run`], and returns the columns that were lowered; `shares` are those of the plan's pieces.
    pub(crate) fn run_recording(self, shares: &[[f32; 2]]) -> (JobResult, Vec<LoweredColumn>) {
        self.run_with(Some(shares))
    }

    fn run_with(self, shares: Option<&[[f32; 2]]>) -> (JobResult, Vec<LoweredColumn>) {
        let bounds = self.grid.bounds();
        let place = CourseFrame {
            corner: self.grid.corner(self.number),
            cell: self.grid.resolution(),
            cells: TILE as u32,
            top: bounds.max.z,
            depth: bounds.size().z,
        };
        let [columns, rows] = self.grid.cells();
        let [column, row] = self.grid.first_cell(self.number);
        let within = [columns - column, rows - row].map(|cells| (cells as usize).min(TILE));
        let mut run = TileRun {
            grid: self.grid,
            number: self.number,
            tile: self.tile,
            mode: self.options.mode,
            keeps_middles: self.options.keeps_middles(),
            by_tag: self.options.by_tag,
            limit: self.options.gap_bytes(self.grid),
            place,
            within,
            bottom: bottom(self.grid),
            found: JobResult { tile: self.number, ..JobResult::default() },
            contact: None,
            only_inner: false,
            recorder: shares.map(|shares| {
                let corner = self.grid.corner(self.number);
                TileRecorder::new(shares, [column, row], columns, corner, self.grid.resolution())
            }),
        };
        for &(_, step) in self.todo {
            run.step(self.plan, &self.plan.steps[step as usize]);
        }
        run.tile.settle();
        (run.found, run.recorder.map_or_else(Vec::new, |recorder| recorder.lowered))
    }
}

struct TileRun<'a> {
    grid: &'a StockGrid,
    number: usize,
    tile: &'a mut StockTile,
    mode: Mode,
    /// Whether the heights in the middles of cells are kept.
    keeps_middles: bool,
    by_tag: bool,
    /// Most bytes that the gaps of the tile may take.
    limit: usize,
    place: CourseFrame,
    /// Cells of the tile inside the stock's box, along X and Y.
    within: [usize; 2],
    bottom: f32,
    found: JobResult,
    /// The deepest contact of the step; `None` where it does not compare.
    contact: Option<DeepestReach>,
    /// The step lowers only inner heights.
    only_inner: bool,
    recorder: Option<TileRecorder<'a>>,
}

/// Where a body reaches deepest into the tile.
#[derive(Clone, Copy, Debug)]
struct DeepestReach {
    least: f32,
    most: f32,
    cell: [usize; 2],
    top: f32,
}

impl TileRun<'_> {
    fn step(&mut self, plan: &StockPlan, step: &PlanStep) {
        if step.action == StepAction::Turning {
            self.turning(plan, step);
            return;
        }
        if step.action.is_below() {
            self.below(plan, step);
            return;
        }
        let mut piece = plan.pieces[step.piece as usize];
        if !step.action.is_cut() {
            piece = piece.alone();
        }
        self.only_inner = step.action == StepAction::CutMost;
        if self.only_inner && self.mode == Mode::Sampled {
            return;
        }
        let piece = &piece;
        let part = &plan.parts[step.part as usize];
        // Lower bound of the floor: stock that is not higher is not met.
        let lowest = piece.lowest() + part.height - self.place.top;
        if lowest >= f64::from(self.tile.top()) {
            return;
        }
        if let Some(recorder) = &mut self.recorder {
            recorder.begin(piece, step.piece);
        }
        let course = TileCourse::new(piece, part, &self.place);
        self.contact = match step.action {
            StepAction::Compare(_) | StepAction::CompareMost(_) => {
                Some(DeepestReach { least: 0.0, most: 0.0, cell: [0; 2], top: 0.0 })
            }
            StepAction::Cut
            | StepAction::CutMost
            | StepAction::CutBelow
            | StepAction::CompareBelow(_)
            | StepAction::Turning => None,
        };
        self.shapes(piece, part, step, &course);
        let (StepAction::Compare(body) | StepAction::CompareMost(body), Some(mut deepest)) =
            (step.action, self.contact)
        else {
            return;
        };
        if step.action == StepAction::CompareMost(body) {
            deepest.least = 0.0;
        }
        if deepest.most > 0.0 {
            let [x, y] = [0, 1].map(|axis| {
                self.place.corner[axis] + self.place.cell * (deepest.cell[axis] as f64 + 0.5)
            });
            let contact = ContactDepth {
                least: f64::from(deepest.least),
                most: f64::from(deepest.most),
                at: [x, y, self.place.top + f64::from(deepest.top)],
            };
            self.found.contacts.push((body, piece.number, contact));
        }
    }

    /// Carries out a whole move of a tool that turns.
    fn turning(&mut self, plan: &StockPlan, step: &PlanStep) {
        let turning = &plan.turning[step.piece as usize];
        let mut on_tile = TurningOnTile {
            grid: self.grid,
            number: self.number,
            tile: self.tile,
            turning,
            solids: &plan.solids,
            by_tag: self.by_tag,
            keeps_middles: self.keeps_middles,
            limit: self.limit,
            count: 0,
        };
        let contacts = on_tile.run();
        self.found.counts.columns += on_tile.count;
        for (body, contact) in contacts.into_iter().enumerate() {
            if contact.most > 0.0 {
                self.found.contacts.push((body as u32, turning.number, contact));
            }
        }
    }

    /// Carries out a whole move of an undercut.
    fn below(&mut self, plan: &StockPlan, step: &PlanStep) {
        let below = &plan.below[step.piece as usize];
        let on_tile = OnTile {
            grid: self.grid,
            number: self.number,
            tile: self.tile,
            below,
            cutter: &plan.undercuts[below.cutter as usize],
            by_tag: self.by_tag,
            keeps_middles: self.keeps_middles,
            limit: self.limit,
        };
        if let StepAction::CompareBelow(body) = step.action {
            let (contact, count) = on_tile.compare();
            self.found.counts.columns += count;
            if contact.most > 0.0 {
                self.found.contacts.push((body, below.number, contact));
            }
        } else {
            self.found.counts.columns += on_tile.cut();
            self.tile.settle();
        }
    }

    fn shapes(
        &mut self,
        piece: &SweepPiece,
        part: &CutterPart,
        step: &PlanStep,
        course: &TileCourse,
    ) {
        // Neighbours have the same cutter; only the slope of the next piece differs.
        let next = AnyShape::new(part, piece.next.map_or(piece.slope, |joint| joint.slope));
        match (AnyShape::new(part, piece.slope), next) {
            (AnyShape::Flat(shape), _) => self.either(piece, step, course, [&shape; 2]),
            (AnyShape::Cone(shape), AnyShape::Cone(next)) => {
                self.either(piece, step, course, [&shape, &next]);
            }
            (AnyShape::Ball(shape), AnyShape::Ball(next)) => {
                self.either(piece, step, course, [&shape, &next]);
            }
            (AnyShape::Round(shape), AnyShape::Round(next)) => {
                self.either(piece, step, course, [&shape, &next]);
            }
            // The same part has the same shape on any slope.
            (AnyShape::Cone(_) | AnyShape::Ball(_) | AnyShape::Round(_), _) => {}
        }
    }

    fn either<S: PartKind>(
        &mut self,
        piece: &SweepPiece,
        step: &PlanStep,
        course: &TileCourse,
        shapes: [&S; 2],
    ) {
        if piece.slope == 0.0 {
            self.lower::<true, S>(piece, step, course, shapes);
        } else {
            self.lower::<false, S>(piece, step, course, shapes);
        }
    }

    /// Finds the blocks of the strip and lowers them.
    fn lower<const LEVEL: bool, S: PartKind>(
        &mut self,
        piece: &SweepPiece,
        step: &PlanStep,
        course: &TileCourse,
        shapes: [&S; 2],
    ) {
        let cell = self.place.cell;
        let begin = [piece.start.x - self.place.corner[0], piece.start.y - self.place.corner[1]];
        let margin = f64::from(course.slack);
        let strip = &step.strip;
        let [ux, uy] = piece.along;
        let sideways = ux.abs() * (strip.reach + margin);
        let ends = [uy * (strip.from - margin), uy * (strip.to + margin)];
        let rows = [
            begin[1] + ends[0].min(ends[1]) - sideways,
            begin[1] + ends[0].max(ends[1]) + sideways,
        ];
        let width = cell * BLOCK as f64;
        let units = BlockUnits::new(piece, cell);
        let [first, last] = between(rows, width, self.within[1].div_ceil(BLOCK));
        for block_row in first..=last {
            let y = f64::from(block_row) * width - begin[1];
            let columns = across(strip, piece.along, [y, y + width], margin).map(|x| x + begin[0]);
            let [from, to] = between(columns, width, self.within[0].div_ceil(BLOCK));
            for block_column in from..=to {
                let block = block_row as usize * BLOCKS + block_column as usize;
                self.found.counts.blocks += 1;
                if let Some(part) = units.part(piece, course, shapes, corner(block)) {
                    self.block::<LEVEL, S>(course, shapes[0], block, &part, piece.tag);
                }
            }
        }
    }

    /// Lowers a part of a block.
    #[inline]
    fn block<const LEVEL: bool, S: PartKind>(
        &mut self,
        course: &TileCourse,
        shape: &S,
        block: usize,
        part: &BlockPart,
        tag: u32,
    ) {
        let corner = corner(block);
        let (middle, half) = part.middle();
        let (a, e) = course.at(corner[0] + middle[0], corner[1] + middle[1]);
        let radius = half * self.place.cell as f32 + course.slack;
        let lowest = course.lowest_in_reach(a, radius);
        let (a, e) = (f32x4::splat(a), f32x4::splat(e));
        let least = course.least_within(shape, lowest, radius, a, e).to_array()[0];
        let range = self.tile.range(block);
        let raised = least + course.gap;
        if least >= range.outer[1] {
            return;
        }
        if self.contact.is_some() {
            self.compare::<LEVEL, S>(course, shape, block, part, lowest);
            return;
        }
        let lowers_outer = raised < range.outer[1] && !self.only_inner;
        if !lowers_outer && lowest >= range.inner[1] {
            return;
        }
        if self.by_tag {
            self.tile.keep(tag, block, self.grid, self.number);
        }
        if self.recorder.is_some() {
            let before = self.tile.get(block);
            self.lower_block::<LEVEL, S>(course, shape, block, part, lowest);
            let after = self.tile.get(block);
            if let Some(recorder) = &mut self.recorder {
                recorder.changed(block, &before, &after, self.within);
            }
            return;
        }
        self.lower_block::<LEVEL, S>(course, shape, block, part, lowest);
    }

    #[inline]
    fn lower_block<const LEVEL: bool, S: PartKind>(
        &mut self,
        course: &TileCourse,
        shape: &S,
        block: usize,
        part: &BlockPart,
        lowest: f32,
    ) {
        let (corner, range) = (corner(block), self.tile.range(block));
        if LEVEL && S::IS_FLAT && !self.only_inner && self.even(course, block, corner, range) {
            return;
        }
        self.found.counts.columns += part.cells() as u64;
        let bottom = f32x4::splat(self.bottom);
        let sampled_only = self.mode == Mode::Sampled;
        let data = self.tile.open(block);
        let range = if sampled_only {
            sampled::<LEVEL, S>(course, shape, corner, part, |at, floor| {
                lower(data, at, floor.fast_max(bottom));
            });
            let outer = ends(data);
            HeightRange { outer, inner: outer, middle: outer }
        } else {
            let (outer, rest) = data.split_at_mut(GROUPS);
            let (inner, middle) = rest.split_at_mut(GROUPS);
            let only_inner = self.only_inner;
            let keeps_middles = !only_inner && middle.len() == GROUPS;
            certified::<LEVEL, S>(course, shape, corner, part, lowest, |at, hi, lo, own| {
                if !only_inner {
                    lower(outer, at, hi.fast_max(bottom));
                }
                lower(inner, at, lo.fast_max(bottom));
                if keeps_middles {
                    lower(middle, at, own.fast_max(bottom));
                }
            });
            let range = ends(outer);
            let middle = if middle.is_empty() { range } else { ends(middle) };
            HeightRange { outer: range, inner: ends(inner), middle }
        };
        self.tile.close(block, range);
        self.tile.settle_gaps(block);
    }

    /// Finds how deep a part of a body reaches into a part of a block.
    fn compare<const LEVEL: bool, S: PartKind>(
        &mut self,
        course: &TileCourse,
        shape: &S,
        block: usize,
        part: &BlockPart,
        lowest: f32,
    ) {
        let Some(mut deepest) = self.contact else { return };
        self.found.counts.columns += part.cells() as u64;
        let corner = corner(block);
        let heights = self.tile.get(block);
        let bottom = f32x4::splat(self.bottom);
        let within = self.within;
        let mut report = |at: usize, hi: f32x4, lo: f32x4| {
            let group = |heights: &[f32; CELLS]| {
                let at = at * LANES;
                f32x4::from([heights[at], heights[at + 1], heights[at + 2], heights[at + 3]])
            };
            let most = group(&heights.outer) - lo.fast_max(bottom);
            let least = group(&heights.inner) - hi.fast_max(bottom);
            if most.cmp_gt(f32x4::splat(deepest.most)).none()
                && least.cmp_gt(f32x4::splat(deepest.least)).none()
            {
                return;
            }
            for (lane, (most, least)) in
                most.to_array().into_iter().zip(least.to_array()).enumerate()
            {
                let place = at * LANES + lane;
                let cell = [corner[0] as usize + place % BLOCK, corner[1] as usize + place / BLOCK];
                if cell[0] >= within[0] || cell[1] >= within[1] {
                    continue;
                }
                deepest.least = deepest.least.max(least);
                if most > deepest.most {
                    deepest = DeepestReach { most, cell, top: heights.outer[place], ..deepest };
                }
            }
        };
        match self.mode {
            Mode::Certified => {
                certified::<LEVEL, S>(course, shape, corner, part, lowest, |at, hi, lo, _| {
                    report(at, hi, lo);
                });
            }
            Mode::Sampled => {
                sampled::<LEVEL, S>(course, shape, corner, part, |at, floor| {
                    report(at, floor, floor)
                });
            }
        }
        self.contact = Some(deepest);
    }

    /// Sets a block to one height, if a level disc covers it and no cell is lower. Returns whether it did.
    fn even(
        &mut self,
        course: &TileCourse,
        block: usize,
        corner: [f32; 2],
        range: HeightRange,
    ) -> bool {
        let side = BLOCK as f32;
        let ends = [(0.0, 0.0), (side, 0.0), (0.0, side), (side, side)]
            .map(|(x, y)| course.at(corner[0] + x, corner[1] + y));
        let along = f32x4::from(ends.map(|(a, _)| a));
        let across = f32x4::from(ends.map(|(_, e)| e));
        if !course.covers(along, across) {
            return false;
        }
        let plain = course.plain_level();
        let [hi, lo] = match self.mode {
            Mode::Certified => course.level(),
            Mode::Sampled => [plain; 2],
        };
        let (hi, lo) = (hi.max(self.bottom), lo.max(self.bottom));
        let middle = if self.keeps_middles { plain.max(self.bottom) } else { hi };
        if range.outer[0] < hi || range.inner[0] < lo {
            return false;
        }
        self.found.counts.even += 1;
        self.tile.close(block, HeightRange::uniform(hi, lo, middle));
        self.tile.settle_gaps(block);
        true
    }
}

#[inline(always)]
fn lower(heights: &mut [f32x4], at: usize, to: f32x4) {
    heights[at] = heights[at].fast_min(to);
}

/// The least and the largest of the heights of a block.
#[inline(always)]
fn ends(heights: &[f32x4]) -> [f32; 2] {
    let (mut least, mut most) = (heights[0], heights[0]);
    for &some in &heights[1..] {
        least = least.fast_min(some);
        most = most.fast_max(some);
    }
    let (least, most) = (least.to_array(), most.to_array());
    [
        least[0].min(least[1]).min(least[2].min(least[3])),
        most[0].max(most[1]).max(most[2].max(most[3])),
    ]
}

/// The corner of a block, in cells of its tile.
fn corner(block: usize) -> [f32; 2] {
    [(block % BLOCKS * BLOCK) as f32, (block / BLOCKS * BLOCK) as f32]
}

/// A block divided into four: squares where the path runs mostly along X, otherwise bands of rows.
struct BlockUnits {
    squares: bool,
    /// Half sizes along the piece and across it, mm.
    half: [f32; 2],
}

impl BlockUnits {
    const BAND: f64 = (BLOCK / LANES) as f64;

    fn new(piece: &SweepPiece, cell: f64) -> BlockUnits {
        let [ux, uy] = piece.along.map(f64::abs);
        let squares = ux >= uy;
        let (width, height) =
            if squares { (LANES as f64, LANES as f64) } else { (BLOCK as f64, BlockUnits::BAND) };
        let (x, y) = (width * cell / 2.0, height * cell / 2.0);
        BlockUnits { squares, half: [(ux * x + uy * y) as f32, (uy * x + ux * y) as f32] }
    }

    /// The part of a block that the piece may not leave to its neighbours.
    #[inline(always)]
    fn part<S: PartKind>(
        &self,
        piece: &SweepPiece,
        course: &TileCourse,
        shapes: [&S; 2],
        corner: [f32; 2],
    ) -> Option<BlockPart> {
        let middles = if self.squares {
            [[2.0, 2.0], [6.0, 2.0], [2.0, 6.0], [6.0, 6.0]]
        } else {
            [[4.0, 1.0], [4.0, 3.0], [4.0, 5.0], [4.0, 7.0]]
        };
        let at = middles.map(|[x, y]| course.at(corner[0] + x, corner[1] + y));
        let places = [f32x4::from(at.map(|at| at.0)), f32x4::from(at.map(|at| at.1))];
        let taken = course.takes(piece, shapes, places, self.half).move_mask();
        if taken == 0 {
            return None;
        }
        Some(if self.squares {
            // Pairs of bits are the left and right columns, and the lower and upper rows.
            let (left, right) = (taken & 0b0101 != 0, taken & 0b1010 != 0);
            let (low, high) = (taken & 0b0011 != 0, taken & 0b1100 != 0);
            BlockPart {
                column: if left { 0 } else { LANES },
                row: if low { 0 } else { LANES },
                groups: usize::from(left) + usize::from(right),
                rows: LANES * (usize::from(low) + usize::from(high)),
            }
        } else {
            let band = BLOCK / LANES;
            let first = taken.trailing_zeros() as usize;
            let last = (taken as u32).ilog2() as usize;
            BlockPart {
                column: 0,
                row: first * band,
                groups: BLOCK / LANES,
                rows: (last + 1 - first) * band,
            }
        })
    }
}

/// The first and the last of `count` equal steps between two coordinates; none where the first is larger.
fn between([from, to]: [f64; 2], length: f64, count: usize) -> [i32; 2] {
    let most = count as f64;
    // Clamped to zero before truncation.
    let first = (from / length).clamp(0.0, most) as i32;
    let last = (to / length + 1.0).clamp(0.0, most) as i32 - 1;
    [first, last]
}
