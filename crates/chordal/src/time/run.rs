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
    /// not the limits let anything be planned.
    pub fn report_timed(
        &self,
        options: &MotionOptions,
        watch: &mut impl Watch,
    ) -> (Report, Result<Timed, LimitError>) {
        let limits = match MachineLimits::of(self.machine()) {
            Ok(limits) => limits,
            Err(error) => return (self.report_watched(watch), Err(error)),
        };
        let mut timing = Timing::default();
        let planning = Planning::new(limits.clone(), options, &mut timing);
        let motion = MotionBuilder::new(self, limits, options, planning);
        let both = Both { report: ReportSink::new(self, watch), motion };
        let (outcomes, Both { report, motion }) = Compensated::judge(self, both);
        let (motion, mut planning) = motion.finish(outcomes.clone());
        planning.finish();
        (report.finish(outcomes), Ok(Timed { time: timing.0.finish(), motion }))
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
    motion: MotionBuilder<'m, Planning<'s, Timing>>,
}

impl<W: Watch> PathSink for Both<'_, '_, '_, W> {
    fn programmed(&mut self, command: &Command) {
        self.report.programmed(command);
    }

    fn command(&mut self, path: PathCommand<'_>) {
        self.report.command(path);
        self.motion.command(path);
    }

    fn diagnostic(&mut self, diagnostic: Diagnostic, origin: &Origin) {
        self.report.diagnostic(diagnostic, origin);
    }
}
