//! Runs that are timed.

use chordal_control::{Command, Origin};
use chordal_diagnostics::Diagnostic;
use chordal_path::{PathCommand, PathSink};

use super::builder::TimeBuilder;
use super::report::TimeReport;
use crate::compensated::Compensated;
use crate::job::{Job, Report, ReportSink, Watch};
use crate::motion::{
    LimitError, MachineLimits, MotionBuilder, MotionOptions, MotionReport, MotionStep, PlanSink,
    Planning, Sources, Step, StepSource,
};

/// The time of a run, and how it was planned.
#[derive(Clone, Debug)]
pub struct Timed {
    /// Where the time goes.
    pub time: TimeReport,
    /// Limits, what was assumed, and what could not be planned.
    pub motion: MotionReport,
}

impl Job<'_> {
    /// Runs, plans and adds up the time.
    ///
    /// # Errors
    /// A limit of an axis that is not a positive number.
    pub fn time(&self, options: &MotionOptions) -> Result<Timed, LimitError> {
        let mut timing = Timing::default();
        let motion = self.plan(options, &mut timing)?;
        Ok(Timed { time: timing.0.finish(), motion })
    }

    /// Runs once with all checks, sums up and adds up the time. The report stands whether or
    /// not the limits let anything be planned. There is no time where the program has more
    /// than `most_moves` moves: planning takes several times as long as all the rest.
    pub fn report_timed(
        &self,
        options: &MotionOptions,
        most_moves: u64,
        watch: &mut impl Watch,
    ) -> (Report, Result<Option<Timed>, LimitError>) {
        let limits = match MachineLimits::of(self.machine()) {
            Ok(limits) => limits,
            Err(error) => return (self.report_watched(watch), Err(error)),
        };
        let mut timing = Timing::default();
        let planning = Planning::new(limits.clone(), options, &mut timing);
        let motion = MotionBuilder::new(self, limits, options, planning);
        let report = ReportSink::new(self, watch);
        let both = Both { report, motion: Some(motion), left: most_moves };
        let (outcomes, Both { report, motion, .. }) = Compensated::judge(self, both);
        let planned = motion.map(|motion| {
            let (motion, mut planning) = motion.finish(outcomes.clone());
            planning.finish();
            motion
        });
        let timed = planned.map(|motion| Timed { time: timing.0.finish(), motion });
        (report.finish(outcomes), Ok(timed))
    }
}

/// Adds up the steps of a run.
#[derive(Debug, Default)]
struct Timing(TimeBuilder);

impl PlanSink for Timing {
    fn asked(&mut self, step: &MotionStep, source: &StepSource) {
        self.0.asked(step, source);
    }

    fn step(&mut self, step: Step<'_>, _: &Sources) {
        self.0.step(step);
    }
}

/// A run that is judged and planned at once.
struct Both<'m, 'w, 's, W> {
    report: ReportSink<'m, 'w, W>,
    /// Gone when there are too many moves.
    motion: Option<MotionBuilder<'m, Planning<'s, Timing>>>,
    /// Moves that may come yet.
    left: u64,
}

impl<W: Watch> PathSink for Both<'_, '_, '_, W> {
    fn programmed(&mut self, command: &Command) {
        self.report.programmed(command);
    }

    fn command(&mut self, path: PathCommand<'_>) {
        self.report.command(path);
        let Some(motion) = &mut self.motion else { return };
        if path.command.kind.motion().is_some() {
            let Some(left) = self.left.checked_sub(1) else {
                self.motion = None;
                return;
            };
            self.left = left;
        }
        motion.command(path);
    }

    fn diagnostic(&mut self, diagnostic: Diagnostic, origin: &Origin) {
        self.report.diagnostic(diagnostic, origin);
    }
}
