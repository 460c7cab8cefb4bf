//! The time of a program with the analyses that go with it.

use chordal_diagnostics::Code;

use super::{ChordCost, LeastReport, ReferenceQuality, TimeAlternative, TimedRun};
use crate::job::Job;
use crate::motion::{LimitError, MotionOptions, PlannerLevel};
use crate::report::Report;

/// Most moves of a program for which alternatives are planned without being requested: all of them together then take
/// less than a second.
const MAX_UNREQUESTED_MOVES: u64 = 20_000;

/// Most moves of a program whose cycle time is planned for a summary. Longer programs are planned only on request, so
/// that the summary of a million lines takes no longer than its run.
const MAX_SUMMARIZED_MOVES: u64 = 300_000;

/// Typical length of a line in a program of many short moves, bytes.
const MOVE_LINE_BYTES: u64 = 20;

/// Whether a program is planned again with something changed.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum RepeatPlanning {
    /// Never.
    Never,
    /// Where it is short, and planned at the fast level.
    IfShort,
    /// However long it takes.
    Always,
}

/// What to compute about the time of a program.
#[derive(Clone, Debug)]
pub struct TimeQuestion {
    /// How the program is planned.
    pub options: MotionOptions,
    /// Whether to plan again with other overrides and path modes, and to compute what short lines cost.
    pub repeat_planning: RepeatPlanning,
    /// Whether to compute the least times within the physical limits.
    pub computes_least: bool,
}

/// The time of a program and what was computed along with it.
#[derive(Clone, Debug)]
pub struct TimeStudy {
    /// The time.
    pub timed: TimedRun,
    /// The least and the most time, s, where it depends on conditions that nobody knows; `None` without such
    /// conditions.
    pub range_s: Option<[f64; 2]>,
    /// How much computing the planner spent.
    pub level: PlannerLevel,
    /// The times of the same program with changes; empty where none were planned.
    pub what_if: Vec<TimeAlternative>,
    /// The least times; `None` where they were not requested.
    pub least: Option<LeastReport>,
    /// What the short lines of each tool cost; empty where that was not computed.
    pub chords: Vec<ChordCost>,
}

/// Most moves that are planned for the summary of a program of so many bytes; 0 for a text so long that it would
/// exceed the limit and be planned in vain.
pub fn max_summarized_moves(bytes: usize) -> u64 {
    if bytes as u64 > MAX_SUMMARIZED_MOVES * MOVE_LINE_BYTES { 0 } else { MAX_SUMMARIZED_MOVES }
}

/// How much work the reference may take: some ten seconds, whatever the program.
fn effort() -> ReferenceQuality {
    ReferenceQuality { most_nodes: 4_000, total_nodes: 12_000, ..ReferenceQuality::default() }
}

impl Job<'_> {
    /// Runs with all checks, plans, and computes what the question demands. The report is complete even where the
    /// limits of the machine prevent planning.
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
        let repeats_planning = match question.repeat_planning {
            RepeatPlanning::Never => false,
            RepeatPlanning::IfShort => {
                options.level == PlannerLevel::Fast && timed.time.moves <= MAX_UNREQUESTED_MOVES
            }
            RepeatPlanning::Always => true,
        };
        // A run that was stopped by its budget has no whole time to compare with.
        let is_stopped =
            report.diagnostics.iter().any(|diagnostic| diagnostic.code == Code::BudgetReached);
        let repeats_planning = repeats_planning && !is_stopped;
        let (what_if, chords) = if repeats_planning && timed.time.moves > 0 {
            (
                self.what_if(options, &self.changes())?,
                self.chord_costs(options, report.summary.inch)?,
            )
        } else {
            (Vec::new(), Vec::new())
        };
        let least = question.computes_least.then(|| self.least(options, effort())).transpose()?;
        let range_s = self.time_of_sides(options, report, timed.time.total_s())?;
        Ok(TimeStudy { timed, range_s, level: options.level, what_if, least, chords })
    }
}
