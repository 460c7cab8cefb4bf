//! Further runs that take the other branch of a condition whose value nobody knows.
//!
//! A run takes a condition on an unknown value as not fulfilled. The program is run again with the condition
//! fulfilled: once for each condition, with the earlier conditions that lead to it. It is also run with block delete
//! switched the other way, where that affects more than the deleted blocks themselves. Not every combination is run.

use std::collections::{BTreeSet, VecDeque};
use std::sync::Arc;

use chordal_diagnostics::{Code, Diagnostic, FileId, Source, SourceMap, Span};
use chordal_kernel::RunOptions;

use crate::job::Job;
use crate::report::{KEPT_PER_CODE, OtherSides, Report};

/// Most runs that take other sides: they multiply the time of a check.
pub const MAX_SIDE_RUNS: usize = 16;

/// Most such runs that cut stock, which takes far longer than a check.
pub const MAX_STOCK_SIDE_RUNS: usize = 4;

/// Most blocks that such a run carries out in calls, repeats and jumps: an assumed condition may loop for ever.
const MAX_REPEATED_BLOCKS: u64 = 100_000;

/// How a run differs from the first one.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum AlternativeRun {
    /// This condition is taken as fulfilled, and those that lead to it.
    Fulfilled(Span),
    /// Block delete is switched the other way.
    BlockDelete,
}

/// When block delete is run both ways.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum BlockDeleteRuns {
    /// Where a deleted block sets a mode or a value that later blocks use, and where the options of the job demand
    /// both.
    WhereItDecides,
    /// Always.
    Both,
}

/// A run that is still to be done.
struct PendingRun {
    side: AlternativeRun,
    fulfilled: BTreeSet<(FileId, u32)>,
    block_delete: bool,
}

impl Job<'_> {
    /// The jobs that take other sides than this one, which has reported `first`: at most [`MAX_SIDE_RUNS`], and
    /// whether those are all.
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

    /// Whether this job takes another side than the usual one.
    pub fn takes_other_side(&self) -> bool {
        self.run_options().is_other_side
    }

    /// Runs the other sides of the conditions that the first run has assumed, and of those that the further runs
    /// assume. `run` gets each job and the side that it takes, and returns the problems found.
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
        // Where the user has switched block delete on, the program is meant to run so.
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
        let base = self.run_options();
        let options = RunOptions {
            is_other_side: true,
            fulfilled: Arc::new(fulfilled),
            max_repeated_blocks: base.max_repeated_blocks.min(MAX_REPEATED_BLOCKS),
            ..base.clone()
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

    /// Describes a side, for the note of a problem.
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

/// The conditions that a run has assumed, by its problems.
fn assumed_conditions(found: &[Diagnostic]) -> impl Iterator<Item = Span> + '_ {
    found.iter().filter(|each| each.code == Code::AssumedBranch).map(|each| each.primary.span)
}

fn place(condition: Span) -> (FileId, u32) {
    (condition.file, condition.range.start)
}
