//! The time of a program with everything that is computed along with it.

use chordal_diagnostics::Code;

use super::{ChordCost, LeastReport, ReferenceQuality, TimeAlternative, TimedRun};
use crate::job::Job;
use crate::motion::{LimitError, MotionOptions, PlannerLevel};
use crate::report::Report;

/// Most moves of a program that is planned again unasked: all changes together then take less
/// than a second.
const MAX_UNREQUESTED_MOVES: u64 = 20_000;

/// Most moves of a program whose cycle time is planned for a summary: longer ones are for a
/// question about the time, so that the summary of a million lines is there at once.
const MAX_SUMMARIZED_MOVES: u64 = 300_000;

/// Bytes of a line of a program of many short moves.
const MOVE_LINE_BYTES: u64 = 20;

/// Whether a program is planned again with something changed.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum RepeatPlanning {
    /// Not at all.
    Never,
    /// Where it is short and planned in one pass.
    IfShort,
    /// However long it takes.
    Always,
}

/// What to compute about the time of a program.
#[derive(Clone, Debug)]
pub struct TimeQuestion {
    /// How it is planned.
    pub options: MotionOptions,
    /// Other overrides and path modes, and what short lines cost.
    pub again: RepeatPlanning,
    /// The least times within the physical limits.
    pub bound: bool,
}

/// The time of a program and what was computed along with it.
#[derive(Clone, Debug)]
pub struct TimeStudy {
    /// The time.
    pub timed: TimedRun,
    /// The least and the most time where it depends on conditions that nobody knows, s.
    pub range_s: Option<[f64; 2]>,
    /// How hard the planner tried.
    pub level: PlannerLevel,
    /// The same program with changes, where that was requested.
    pub what_if: Vec<TimeAlternative>,
    /// The least times, where they were requested.
    pub least: Option<LeastReport>,
    /// What the short lines of each tool cost, where that was requested.
    pub chords: Vec<ChordCost>,
}

/// Most moves that are planned for the summary of a program of so many bytes. A long text is not
/// planned in vain.
pub fn max_summarized_moves(bytes: usize) -> u64 {
    if bytes as u64 > MAX_SUMMARIZED_MOVES * MOVE_LINE_BYTES { 0 } else { MAX_SUMMARIZED_MOVES }
}

/// How much work the reference may be: some ten seconds, whatever the program.
fn effort() -> ReferenceQuality {
    ReferenceQuality { most_nodes: 4_000, total_nodes: 12_000, ..ReferenceQuality::default() }
}

impl Job<'_> {
    /// Runs with all checks, plans, and answers the question. There is a report whether or not
    /// the limits let anything be planned. There is no time of a program with more moves than can
    /// be counted.
    pub fn time_study(
        &self,
        question: &TimeQuestion,
    ) -> (Report, Result<Option<TimeStudy>, LimitError>) {
        let (report, timed) = self.report_timed(&question.options, u64::MAX, &mut ());
        let study = timed
            .and_then(|timed| timed.map(|timed| self.study(timed, &report, question)).transpose());
        (report, study)
    }

    fn study(
        &self,
        timed: TimedRun,
        report: &Report,
        question: &TimeQuestion,
    ) -> Result<TimeStudy, LimitError> {
        let options = &question.options;
        let again = match question.again {
            RepeatPlanning::Never => false,
            RepeatPlanning::IfShort => {
                options.level == PlannerLevel::Fast && timed.time.moves <= MAX_UNREQUESTED_MOVES
            }
            RepeatPlanning::Always => true,
        };
        // What is stopped by its budget has no time of its own, and none that could be another.
        let is_stopped =
            report.diagnostics.iter().any(|diagnostic| diagnostic.code == Code::BudgetReached);
        let again = again && !is_stopped;
        let (what_if, chords) = if again && timed.time.moves > 0 {
            (
                self.what_if(options, &self.changes())?,
                self.chord_costs(options, report.summary.inch)?,
            )
        } else {
            (Vec::new(), Vec::new())
        };
        let least = question.bound.then(|| self.least(options, effort())).transpose()?;
        let range_s = self.time_of_sides(options, report, timed.time.total_s())?;
        Ok(TimeStudy { timed, range_s, level: options.level, what_if, least, chords })
    }
}
