//! Where a program may be split: before tool changes, and where the tool stands above all cuts.

use std::collections::{BTreeMap, HashMap};
use std::ops::Range;

use chordal::control::{Action, AfterCode, CompensationSide, Modal, OnceCode};
use chordal::syntax::Block;
use chordal::{Command, CommandKind, Control, Job};

use crate::source::SourceBlocks;
use crate::state::OpenConstructs;
use crate::walk::{WalkedBlock, walk};
use crate::word_address::BlockControl;

/// What makes a place safe.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum SafePointKind {
    /// A tool change follows.
    ToolChange,
    /// The tool is above all cuts of its work offset.
    Clear,
}

/// A place between two blocks of the main program.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct SplitPoint {
    /// The block after it.
    pub(super) at: usize,
    /// How many blocks were carried out before it.
    pub(super) ran: u32,
    pub(super) kind: SafePointKind,
    /// Where the tool stands, mm, and in which work offset.
    pub(super) height: (f64, u32),
    /// How many cuts were made before it.
    pub(super) cuts: u32,
}

/// A run, as far as splitting it goes.
#[derive(Debug)]
pub(super) struct SplitSurvey {
    /// In order, each once.
    pub(super) points: Vec<SplitPoint>,
    /// The last block of the main program that was carried out.
    pub(super) end: usize,
    /// How many cuts it makes.
    pub(super) cuts: u32,
    /// M codes that may last and that nothing is known of, with the line of the first.
    pub(super) unknown: BTreeMap<String, u32>,
    /// By subprogram: the blocks of the main program that carry it out, in order.
    pub(super) users: Vec<Vec<usize>>,
}

impl SplitSurvey {
    pub(super) fn of(job: &Job, source: &SourceBlocks, main: &Range<usize>) -> SplitSurvey {
        let mut finder = SplitPointFinder {
            source,
            control: job.control(),
            main: main.clone(),
            survey: SplitSurvey {
                points: Vec::new(),
                end: main.start,
                cuts: 0,
                unknown: BTreeMap::new(),
                users: vec![Vec::new(); source.subs.len()],
            },
            cuts: HashMap::new(),
            open: OpenConstructs::default(),
            has_incremental_data: false,
            settled: false,
        };
        walk(job, |visit| finder.visit(visit));
        let SplitPointFinder { mut survey, cuts, .. } = finder;
        let all = survey.cuts;
        survey.points.retain(|point| point.cuts > 0 && point.cuts < all);
        // Between a tool change and the first cut, the change would be made twice.
        let mut changed = None;
        survey.points.retain(|point| {
            let is_change = point.kind == SafePointKind::ToolChange;
            changed = if is_change { Some(point.cuts) } else { changed };
            is_change || changed != Some(point.cuts)
        });
        survey.points.retain(|point| {
            let (height, work) = point.height;
            let highest = cuts.get(&work).copied().unwrap_or(f64::NEG_INFINITY);
            point.kind == SafePointKind::ToolChange || height > highest
        });
        survey
    }
}

struct SplitPointFinder<'s, 'a> {
    source: &'s SourceBlocks<'a>,
    control: &'s Control,
    main: Range<usize>,
    survey: SplitSurvey,
    /// By work offset: the highest place of a cut, but for those that lead straight up.
    cuts: HashMap<u32, f64>,
    open: OpenConstructs,
    /// Offsets were written by increments.
    has_incremental_data: bool,
    /// Neither compensation nor a cycle nor a corner was active after the last block.
    settled: bool,
}

impl SplitPointFinder<'_, '_> {
    /// Notes the M codes that may last and that nothing is known of.
    fn note_unknown(&mut self, block: &Block) {
        for word in &block.words {
            let Some(row) = self.control.row_of(word) else { continue };
            if row.action.is_left_out() && word.letter != b'G'
                || row.action == Action::After(AfterCode::ShopCode)
            {
                self.survey.unknown.entry(row.name(word.letter)).or_insert(block.line);
            }
        }
    }

    /// Nothing is open that a part does not say again.
    fn is_closed(&self) -> bool {
        let OpenConstructs { call, unknown, shift, frames, .. } = &self.open;
        let is_open = shift.is_active || frames.any() || call.is_some() || unknown.is_some();
        self.settled && !is_open && !self.has_incremental_data
    }

    /// The place before a tool change, remarks before it included.
    fn before(&mut self, at: usize, ran: u32, modal: &Modal) {
        let is_remark = |at: &usize| {
            let block = &self.source.blocks[*at];
            block.words.is_empty() && block.kind == chordal::syntax::BlockKind::Words
        };
        let remarks = (self.main.start..at).rev().take_while(is_remark).count();
        let at = at - remarks;
        self.forget(at);
        if self.is_closed() && ran > 0 {
            let (kind, cuts) = (SafePointKind::ToolChange, self.survey.cuts);
            let height = (f64::INFINITY, modal.work.ordinal());
            self.survey.points.push(SplitPoint { at, ran, kind, height, cuts });
        }
    }

    /// Takes back the places from a block on.
    fn forget(&mut self, from: usize) {
        while self.survey.points.last().is_some_and(|point| point.at >= from) {
            self.survey.points.pop();
        }
    }

    fn after_block(&mut self, at: usize, ran: u32, modal: &Modal) {
        self.forget(at + 1);
        let is_known = (0..3).all(|axis| modal.known.has(axis));
        if is_known && self.is_closed() && at + 1 < self.main.end {
            let (at, kind, cuts) = (at + 1, SafePointKind::Clear, self.survey.cuts);
            let height = (modal.position[2], modal.work.ordinal());
            self.survey.points.push(SplitPoint { at, ran, kind, height, cuts });
        }
    }

    /// Counts cuts and notes how high they are.
    fn note_cuts(&mut self, commands: &[Command], work: u32) {
        for command in commands {
            let is_rapid = matches!(command.kind, CommandKind::Rapid { .. });
            let Some(motion) = command.kind.motion().filter(|_| !is_rapid) else { continue };
            self.survey.cuts += 1;
            let leads_up = motion.from[..2] == motion.to[..2]
                && motion.to[2] > motion.from[2]
                && command.kind.shape().is_none();
            if !leads_up {
                let highest = self.cuts.entry(work).or_insert(f64::NEG_INFINITY);
                *highest = highest.max(motion.to[2]);
            }
        }
    }

    fn visit(&mut self, visit: &WalkedBlock) {
        let (modal, ran) = (visit.modal(), visit.ran as u32);
        self.note_cuts(&visit.output.commands, modal.work.ordinal());
        let block = self.source.block_at(visit.origin.span);
        let in_main = block.filter(|at| visit.is_main() && self.main.contains(at));
        if let Some(at) = in_main.filter(|at| self.source.changes_tool(*at, self.control)) {
            self.before(at, ran, &modal);
        }
        if let Some(at) = block {
            let (source, control, block) = (self.source, self.control, &self.source.blocks[at]);
            self.open.follow(source, control, block, true);
            self.note_unknown(block);
            let writes_data = |action| action == Action::Once(OnceCode::SetData);
            self.has_incremental_data |=
                modal.incremental && source.has_action(at, control, writes_data);
        }
        self.settled = modal.side == CompensationSide::Off
            && modal.cycle.is_none()
            && (block.is_none() || self.open.corner.is_none());
        match (block, in_main) {
            (_, Some(at)) => {
                self.after_block(at, ran + 1, &modal);
                self.survey.end = self.survey.end.max(at);
            }
            (Some(at), None) => {
                // The place after the calling block lies within the call.
                let is_within =
                    |point: &mut SplitPoint| point.kind == SafePointKind::Clear && point.ran == ran;
                self.survey.points.pop_if(is_within);
                let main = self.survey.end;
                if let Some(sub) = self.source.sub_of(at) {
                    let users = &mut self.survey.users[sub];
                    if users.last() != Some(&main) {
                        users.push(main);
                    }
                }
            }
            (None, None) => {}
        }
    }
}
