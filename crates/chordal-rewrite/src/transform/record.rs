//! What every block of the text did each time it ran.

use std::collections::{HashMap, HashSet};

use chordal::control::{Action, CycleKind, MotionCode};
use chordal::control::{
    ArcCenter, ArcShape, AxisMask, CompensationSide, FeedMode, Position, Units,
};
use chordal::diagnostics::{Code, FileId};
use chordal::geometry::Plane;
use chordal::{Command, CommandKind, Diagnostic, Job, MAX_SIDE_RUNS};

use super::edit::{TransformRefusal, WordEdit};
use crate::convert::CycleContours;
use crate::sides::{block_delete_runs, deletable_blocks};
use crate::source::SourceBlocks;
use crate::walk::{WalkedBlock, walk};
use crate::word_address::BlockControl;

/// What the words of a block are read by.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct ReadingContext {
    /// G91 active before the block.
    pub(super) incremental_before: bool,
    /// G91 active after it.
    pub(super) incremental: bool,
    pub(super) plane: Plane,
    pub(super) units: Units,
    pub(super) arc_center: ArcCenter,
    pub(super) cycle: Option<CycleKind>,
    pub(super) feed_mode: FeedMode,
    pub(super) side: CompensationSide,
    pub(super) did: BlockEffect,
    /// What a block without a motion code does after it.
    pub(super) motion: Option<Action>,
    /// S is a cutting speed.
    pub(super) keeps_surface_speed: bool,
}

/// What a block did.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum BlockEffect {
    Nothing,
    Rapid,
    Line,
    Arc,
    Spiral,
    Spline,
    /// The moves of a cycle or a pocket.
    Cycle,
}

/// One time that a block ran.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct BlockPass {
    pub(super) context: ReadingContext,
    /// The tool tip before and after it, program coordinates, mm and rad.
    pub(super) from: Position,
    pub(super) to: Position,
    /// The axes whose position is known, before and after.
    pub(super) known: [AxisMask; 2],
    pub(super) shape: Option<ArcShape>,
    /// How many moves it made.
    pub(super) moves: u32,
    /// The active F, in mm/s, 1/s or mm.
    pub(super) feed: Option<f64>,
}

/// All times that a block ran.
#[derive(Clone, Debug)]
pub(super) struct BlockRuns {
    pub(super) first: BlockPass,
    /// How often it ran, in the run in which it did so most.
    pub(super) count: u32,
    /// The same of the last run that it was in, and which one that is.
    count_here: u32,
    run: u32,
    /// Which block of the run it was the first time, from 0.
    pub(super) order: u32,
    /// Each way in which its words were read.
    pub(super) contexts: Vec<ReadingContext>,
    /// It went from and to the same places every time.
    pub(super) same: bool,
    /// It ended at the same place every time.
    pub(super) same_end: bool,
    /// It made the same arc every time, wherever.
    pub(super) same_arc: bool,
}

impl BlockRuns {
    /// The edits that are right for every way in which the words were read; nothing where they are not the same for all.
    pub(super) fn edits_of_all(
        &self,
        edits_of: impl Fn(&ReadingContext) -> Result<Vec<WordEdit>, TransformRefusal>,
    ) -> Result<Option<Vec<WordEdit>>, TransformRefusal> {
        let mut contexts = self.contexts.iter();
        let Some(first) = contexts.next() else { return Ok(Some(Vec::new())) };
        let edits = edits_of(first)?;
        for context in contexts {
            if edits_of(context)? != edits {
                return Ok(None);
            }
        }
        Ok(Some(edits))
    }
}

/// The runs of all blocks of the first text, by the byte that they begin at.
#[derive(Debug, Default)]
pub(super) struct RunRecord {
    pub(super) blocks: HashMap<u32, BlockRuns>,
    /// The first move of a block that stands in another text: its file and line.
    pub(super) in_other_text: Option<(FileId, u32)>,
    /// The run under way, from 0: those after the first take other sides.
    run: u32,
    /// Blocks that block delete takes in the run under way, by the byte that they begin at.
    deleted: HashSet<u32>,
    /// How many blocks ran.
    ran: u32,
    last: Option<(Position, AxisMask, bool)>,
    /// Where the last move ended.
    reached: Option<Position>,
}

/// What a block has done.
#[derive(Debug, Default)]
struct VisitEffects {
    kind: Option<BlockEffect>,
    shape: Option<ArcShape>,
    moves: u32,
    from: Option<(Position, AxisMask)>,
}

impl RunRecord {
    /// With the blocks of contours that only cycles of a lathe read, as if they ran where the cycle does.
    pub(super) fn with_contours(job: &Job) -> RunRecord {
        let mut record = RunRecord::of(job);
        if !job.profile().turns {
            return record;
        }
        let source = SourceBlocks::of(job);
        for contour in &CycleContours::of(&source, job).list {
            let runs = |at: usize| record.blocks.get(&source.blocks[at].range.start).cloned();
            let Some(cycle) = contour.cycles.iter().find_map(|(at, _)| runs(*at)) else { continue };
            let mut context = cycle.first.context;
            for at in contour.blocks.clone() {
                let arc =
                    |code| source.has_action(at, job.control(), |own| own == Action::Motion(code));
                if arc(MotionCode::ArcCw) || arc(MotionCode::ArcCcw) {
                    context.did = BlockEffect::Arc;
                } else if arc(MotionCode::Rapid) || arc(MotionCode::Linear) {
                    context.did = BlockEffect::Line;
                }
                context.motion = None;
                let first = BlockPass { context, shape: None, moves: 0, ..cycle.first };
                let runs = BlockRuns { first, count: 1, contexts: vec![context], ..cycle.clone() };
                record.blocks.entry(source.blocks[at].range.start).or_insert(runs);
            }
        }
        record
    }

    /// With the blocks of both sides of conditions that nobody knows, and with block delete on and off.
    pub(super) fn of(job: &Job) -> RunRecord {
        let deletable = deletable_blocks(job);
        let block_delete = block_delete_runs(&deletable);
        let whole = deletable.iter().filter(|block| block.is_whole);
        let deletable: HashSet<u32> = whole.map(|block| block.start).collect();
        let mut record = RunRecord::default();
        let first = record.run(job, &deletable);
        job.run_other_sides(&first, MAX_SIDE_RUNS, block_delete, |side, _| {
            record.run(&side, &deletable)
        });
        record
    }

    /// Runs once more, and gives what was assumed.
    fn run(&mut self, job: &Job, deletable: &HashSet<u32>) -> Vec<Diagnostic> {
        let is_deleting = job.machine().switches.block_delete.contains(&true);
        self.deleted = if is_deleting { deletable.clone() } else { HashSet::new() };
        (self.last, self.reached) = (None, None);
        let is_assumed =
            |one: &&Diagnostic| matches!(one.code, Code::AssumedBranch | Code::BlockDeleteDecides);
        let mut assumed = Vec::new();
        walk(job, |visit| {
            assumed.extend(visit.output.diagnostics.iter().filter(is_assumed).cloned());
            self.visit(visit);
        });
        self.run += 1;
        assumed
    }

    /// What the commands of a block come to.
    fn effects_of(&mut self, commands: &[Command]) -> VisitEffects {
        let mut did = VisitEffects::default();
        for command in commands {
            let kind = match &command.kind {
                _ if command.origin.cycle && command.kind.motion().is_some() => BlockEffect::Cycle,
                CommandKind::Rapid { .. } => BlockEffect::Rapid,
                CommandKind::Line { .. } => BlockEffect::Line,
                CommandKind::Arc { .. } => BlockEffect::Arc,
                CommandKind::Spiral { .. } => BlockEffect::Spiral,
                CommandKind::Spline { .. } => BlockEffect::Spline,
                _ => continue,
            };
            if command.origin.span.file != FileId(0) {
                self.in_other_text.get_or_insert((command.origin.span.file, command.origin.line));
            }
            did.kind = Some(match did.kind {
                Some(BlockEffect::Cycle) => BlockEffect::Cycle,
                // An arc whose end is a little off it goes on as a line.
                Some(BlockEffect::Arc) => BlockEffect::Arc,
                // `,R` ends a line in an arc.
                Some(BlockEffect::Line) => BlockEffect::Line,
                _ => kind,
            });
            if let Some(shape) = command.kind.shape()
                && did.kind != Some(BlockEffect::Line)
            {
                did.shape.get_or_insert(*shape);
            }
            if let Some(motion) = command.kind.motion() {
                // After a corner the move begins at its end; the program counts from the corner itself.
                let after_corner = self.reached == Some(motion.from);
                let from = match self.last {
                    Some((place, ..)) if after_corner => place,
                    _ => motion.from,
                };
                did.from.get_or_insert((from, motion.from_known));
                self.reached = Some(motion.to);
            }
            did.moves += 1;
        }
        did
    }

    fn visit(&mut self, visit: &WalkedBlock) {
        let (modal, span) = (visit.modal(), visit.origin.span);
        let did = self.effects_of(&visit.output.commands);
        let before = self.last.unwrap_or((modal.position, AxisMask::NONE, modal.incremental));
        let from = did.from.unwrap_or((before.0, before.1));
        self.last = Some((modal.position, modal.known, modal.incremental));
        let start = span.range.start;
        if span.file != FileId(0) || self.deleted.contains(&start) {
            return;
        }
        let context = ReadingContext {
            incremental_before: before.2,
            incremental: modal.incremental,
            plane: modal.plane,
            units: modal.units,
            arc_center: modal.arc_center,
            cycle: modal.cycle,
            feed_mode: modal.feed_mode,
            side: modal.side,
            did: did.kind.unwrap_or(BlockEffect::Nothing),
            motion: modal.motion.map(Action::from),
            keeps_surface_speed: modal.surface_speed.is_some(),
        };
        let run = BlockPass {
            context,
            from: from.0,
            to: modal.position,
            known: [from.1, modal.known],
            shape: did.shape,
            moves: did.moves,
            feed: modal.feed,
        };
        let order = self.ran;
        self.ran += 1;
        self.blocks
            .entry(start)
            .and_modify(|runs| {
                runs.count_here = if runs.run == self.run { runs.count_here + 1 } else { 1 };
                runs.run = self.run;
                runs.count = runs.count.max(runs.count_here);
                runs.same &= (runs.first.from, runs.first.to) == (run.from, run.to)
                    && runs.first.shape == run.shape
                    && runs.first.known == run.known;
                runs.same_end &= runs.first.to == run.to && runs.first.known[1] == run.known[1];
                runs.same_arc &= is_same_arc(&runs.first, &run);
                if !runs.contexts.contains(&context) {
                    runs.contexts.push(context);
                }
            })
            .or_insert_with(|| BlockRuns {
                first: run,
                count: 1,
                count_here: 1,
                run: self.run,
                order,
                contexts: vec![context],
                same: true,
                same_end: true,
                same_arc: true,
            });
    }
}

/// Two runs make one arc at two places.
fn is_same_arc(one: &BlockPass, other: &BlockPass) -> bool {
    let (Some(a), Some(b)) = (one.shape, other.shape) else { return one.shape == other.shape };
    let (first, second, normal) = a.plane.axes();
    let spoke = |run: &BlockPass, shape: &ArcShape| {
        [shape.center[0] - run.from[first], shape.center[1] - run.from[second]]
    };
    let rise = |run: &BlockPass| run.to[normal] - run.from[normal];
    let is_near = |a: f64, b: f64| (a - b).abs() < 1e-9;
    let (u, v) = (spoke(one, &a), spoke(other, &b));
    a.plane == b.plane
        && is_near(a.sweep, b.sweep)
        && is_near(u[0], v[0])
        && is_near(u[1], v[1])
        && is_near(a.radius_to, b.radius_to)
        && is_near(rise(one), rise(other))
}
