//! Runs that take the other side where nobody knows which one the control takes.
//!
//! A run takes a condition of an unknown value as not fulfilled. What the program does where it is fulfilled is run
//! as well: each condition once, with those before it that lead there; and what it does with block delete switched the
//! other way, where that decides about more than its own blocks. Not every combination is run.

use std::collections::{BTreeSet, VecDeque};
use std::sync::Arc;

use chordal_diagnostics::{Code, Diagnostic, FileId, Source, SourceMap, Span};
use chordal_gcode::RunOptions;

use crate::job::Job;
use crate::report::{KEPT_PER_CODE, OtherSides, Report};

/// Most runs that take other sides.
pub const MAX_SIDE_RUNS: usize = 16;

/// Most of them that cut stock.
pub const MAX_STOCK_SIDE_RUNS: usize = 4;

/// Most blocks that such a run carries out in calls, repeats and jumps.
const MAX_REPEATED_BLOCKS: u64 = 100_000;

/// What a run takes otherwise than the first one.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum AlternativeRun {
    /// This condition is fulfilled, and those that lead to it.
    Fulfilled(Span),
    /// Block delete is switched the other way.
    BlockDelete,
}

/// When block delete is run both ways.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum BlockDeleteRuns {
    /// Where it decides about a mode or a value that later blocks use, and where the job asks for both.
    WhereItDecides,
    /// Always.
    Both,
}

/// A run to do.
struct PendingRun {
    side: AlternativeRun,
    fulfilled: BTreeSet<(FileId, u32)>,
    block_delete: bool,
}

impl Job<'_> {
    /// The jobs of the runs that take other sides than this one, which has reported `first`: at most
    /// [`MAX_SIDE_RUNS`], and whether those are all.
    pub fn other_side_jobs(
        &self,
        first: &[Diagnostic],
        block_delete: BlockDeleteRuns,
    ) -> (Vec<(AlternativeRun, Job<'_>)>, bool) {
        let mut jobs = Vec::new();
        let sides = self.run_other_sides(first, MAX_SIDE_RUNS, block_delete, |job, side| {
            let found = job.check_of_run(KEPT_PER_CODE).diagnostics;
            jobs.push((side, job));
            found
        });
        (jobs, sides.left_out.is_empty())
    }

    /// Whether this is the run of another side than the usual one.
    pub fn takes_other_side(&self) -> bool {
        self.run_options().is_other_side
    }

    /// Runs the other sides of what the first run has assumed, and of what is met on the way. `run` gets the job of
    /// each and the side that it takes, and gives the problems found.
    pub fn run_other_sides<'s>(
        &'s self,
        first: &[Diagnostic],
        most_runs: usize,
        block_delete: BlockDeleteRuns,
        mut run: impl FnMut(Job<'s>, AlternativeRun) -> Vec<Diagnostic>,
    ) -> OtherSides {
        let mut met: BTreeSet<(FileId, u32)> = BTreeSet::new();
        let mut pending = VecDeque::new();
        let mut sides = OtherSides::default();
        // Where somebody has switched it on, that is how the program is run.
        let is_on = self.machine().switches.block_delete.contains(&true);
        let decides = first.iter().any(|each| each.code == Code::BlockDeleteDecides);
        let is_requested =
            self.run_options().both_block_deletes || block_delete == BlockDeleteRuns::Both;
        if is_requested || decides && !is_on {
            let (side, fulfilled) = (AlternativeRun::BlockDelete, BTreeSet::new());
            pending.push_back(PendingRun { side, fulfilled, block_delete: true });
        }
        let mut meet = |found: &[Diagnostic],
                        (before, block_delete): (&BTreeSet<_>, bool),
                        pending: &mut VecDeque<_>| {
            for condition in assumed_conditions(found) {
                if met.insert(place(condition)) {
                    let mut fulfilled = before.clone();
                    fulfilled.insert(place(condition));
                    let side = AlternativeRun::Fulfilled(condition);
                    pending.push_back(PendingRun { side, fulfilled, block_delete });
                }
            }
        };
        meet(first, (&BTreeSet::new(), false), &mut pending);
        while let Some(PendingRun { side, fulfilled, block_delete }) = pending.pop_front() {
            if sides.count() >= most_runs || self.is_interrupted() {
                if let AlternativeRun::Fulfilled(condition) = side {
                    sides.left_out.push(condition);
                }
                continue;
            }
            let found = run(self.taking(fulfilled.clone(), block_delete), side);
            match side {
                AlternativeRun::Fulfilled(condition) => sides.run.push(condition),
                AlternativeRun::BlockDelete => sides.block_delete = true,
            }
            meet(&found, (&fulfilled, block_delete), &mut pending);
        }
        sides
    }

    /// The same job, with these conditions taken as fulfilled, and block delete switched the other way.
    fn taking(&self, fulfilled: BTreeSet<(FileId, u32)>, block_delete: bool) -> Job<'_> {
        let mut sources = SourceMap::new();
        for (_, source) in self.sources().iter() {
            sources.add(Source::new(source.name(), source.text()));
        }
        let provided = self.run_options();
        let options = RunOptions {
            is_other_side: true,
            fulfilled: Arc::new(fulfilled),
            max_repeated_blocks: provided.max_repeated_blocks.min(MAX_REPEATED_BLOCKS),
            ..provided.clone()
        };
        let job = self.with_sources(sources).options(options);
        if block_delete { job.with_other_block_delete() } else { job }
    }

    /// Adds what checks find on the other sides of assumed conditions to a report.
    pub(crate) fn check_other_sides(&self, report: &mut Report, most_per_code: usize) {
        self.add_other_sides(report, MAX_SIDE_RUNS, |job| {
            job.check_of_run(most_per_code).diagnostics
        });
        let OtherSides { run, left_out, .. } = &report.other_sides;
        for each in report.diagnostics.iter_mut().filter(|each| each.code == Code::AssumedBranch) {
            if run.contains(&each.primary.span) {
                each.notes.push("the other side was run, too: its problems are listed".to_string());
            } else if left_out.contains(&each.primary.span) {
                let message = format!(
                    "the other side was not run: a program has at most {MAX_SIDE_RUNS} such runs"
                );
                each.notes.push(message);
            }
        }
    }

    /// Runs the other sides of assumed conditions and adds the problems that only they have.
    pub(crate) fn add_other_sides(
        &self,
        report: &mut Report,
        most_runs: usize,
        mut run: impl FnMut(&Job<'_>) -> Vec<Diagnostic>,
    ) {
        if self.takes_other_side() {
            return;
        }
        let mut known: BTreeSet<(Code, Span)> =
            report.diagnostics.iter().map(|each| (each.code, each.primary.span)).collect();
        let mut new = Vec::new();
        let as_needed = BlockDeleteRuns::WhereItDecides;
        let sides = self.run_other_sides(&report.diagnostics, most_runs, as_needed, |job, side| {
            let found = run(&job);
            for each in &found {
                if known.insert((each.code, each.primary.span)) {
                    new.push(each.clone().note(self.words_of(side)));
                }
            }
            found
        });
        report.add(new);
        report.other_sides = sides;
    }

    /// A side in the words of a note.
    fn words_of(&self, side: AlternativeRun) -> String {
        match side {
            AlternativeRun::Fulfilled(condition) => {
                let source = self.sources().get(condition.file);
                let line = source.map_or(0, |source| source.line_of(condition.range.start));
                format!("where the condition in line {line} is fulfilled")
            }
            AlternativeRun::BlockDelete if self.machine().switches.block_delete.contains(&true) => {
                "with block delete off".to_string()
            }
            AlternativeRun::BlockDelete => "with block delete on".to_string(),
        }
    }
}

/// The conditions that a run has assumed.
fn assumed_conditions(found: &[Diagnostic]) -> impl Iterator<Item = Span> + '_ {
    found.iter().filter(|each| each.code == Code::AssumedBranch).map(|each| each.primary.span)
}

fn place(condition: Span) -> (FileId, u32) {
    (condition.file, condition.range.start)
}
