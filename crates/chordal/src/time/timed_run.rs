//! Runs, plans and times a job.

use chordal_command::{Command, Origin};
use chordal_diagnostics::Diagnostic;
use chordal_path::{PathCommand, PathSink};

use super::builder::TimeBuilder;
use super::report::TimeReport;
use crate::compensation_sink::CompensationSink;
use crate::job::Job;
use crate::motion::{
    KinematicLimits, LimitError, MachineLimits, MotionBuilder, MotionOptions, MotionPlanner,
    MotionReport, MotionStep, PathPart, PathPiece, PlanObserver, PlanSink, PlannerLevel,
    PlannerOptions, PlannerStep, PlanningSink, SourcedSink, StepSource,
};
use crate::other_sides::{BlockDeleteRuns, MAX_SIDE_RUNS};
use crate::report::{KEPT_PER_CODE, Report, ReportSink, RunWatch};

/// The time of a run, and how it was planned.
#[derive(Clone, Debug)]
pub struct TimedRun {
    /// Where the time goes.
    pub time: TimeReport,
    /// The limits, those that were assumed, and what could not be planned.
    pub motion: MotionReport,
}

impl Job<'_> {
    /// Runs, plans and adds up the time.
    ///
    /// # Errors
    /// A limit of an axis that is not a positive number.
    pub fn time(&self, options: &MotionOptions) -> Result<TimedRun, LimitError> {
        match options.level {
            PlannerLevel::Fast => self.timed(options, |limits, options| {
                MotionPlanner::of_times_by(limits, options.junctions)
            }),
            PlannerLevel::Best => self.timed(options, MotionPlanner::new),
        }
    }

    /// Runs and plans once, adds up the time, and passes every step on to `sink`.
    ///
    /// # Errors
    /// A limit of an axis that is not a positive number.
    pub fn time_with<S: PlanSink>(
        &self,
        options: &MotionOptions,
        sink: &mut S,
    ) -> Result<TimedRun, LimitError> {
        let limits = MachineLimits::of(self.machine())?;
        let taker = TimedSteps { time: TimeBuilder::default(), steps: SourcedSink::new(sink) };
        let planning = PlanningSink::with(limits, options, MotionPlanner::new, taker);
        let (motion, planning) = self.motion(options, planning)?;
        Ok(TimedRun { time: planning.finish().time.finish(), motion })
    }

    /// The least and the most time, s, of the first run (`total_s`) and of those that take other sides of assumed
    /// conditions. `None` where no condition was assumed. Combinations of sides that were not run may take less or
    /// more.
    ///
    /// # Errors
    /// A limit of an axis that is not a positive number.
    pub fn time_of_sides(
        &self,
        options: &MotionOptions,
        report: &Report,
        total_s: f64,
    ) -> Result<Option<[f64; 2]>, LimitError> {
        let (mut range, mut error) = ([total_s; 2], None);
        let (first, as_needed) = (&report.diagnostics, BlockDeleteRuns::WhereItDecides);
        let sides = self.run_other_sides(first, MAX_SIDE_RUNS, as_needed, |job, _| {
            let (report, timed) = job.report_timed(options, u64::MAX, &mut ());
            match timed {
                Ok(Some(timed)) => {
                    let side_s = timed.time.total_s();
                    range = [range[0].min(side_s), range[1].max(side_s)];
                }
                Ok(None) => {}
                Err(limit) => error = Some(limit),
            }
            report.diagnostics
        });
        match error {
            Some(error) => Err(error),
            None => Ok((!sides.is_empty()).then_some(range)),
        }
    }

    fn timed<P: PathPart>(
        &self,
        options: &MotionOptions,
        make: MakePlanner<P>,
    ) -> Result<TimedRun, LimitError> {
        let limits = MachineLimits::of(self.machine())?;
        let planning = PlanningSink::with(limits, options, make, TimeBuilder::default());
        let (motion, planning) = self.motion(options, planning)?;
        Ok(TimedRun { time: planning.finish().finish(), motion })
    }

    /// Runs once with all checks, and adds up the summary and the time. The report is complete even where the limits
    /// of the machine prevent planning. The time is `None` where the program has more than `most_moves` moves:
    /// planning takes several times as long as all the rest.
    pub fn report_timed(
        &self,
        options: &MotionOptions,
        most_moves: u64,
        watch: &mut dyn RunWatch,
    ) -> (Report, Result<Option<TimedRun>, LimitError>) {
        match options.level {
            PlannerLevel::Fast => self.report_and_time(
                options,
                |limits, options| MotionPlanner::of_times_by(limits, options.junctions),
                most_moves,
                watch,
            ),
            PlannerLevel::Best => {
                self.report_and_time(options, MotionPlanner::new, most_moves, watch)
            }
        }
    }

    fn report_and_time<P: PathPart>(
        &self,
        options: &MotionOptions,
        make: MakePlanner<P>,
        most_moves: u64,
        watch: &mut dyn RunWatch,
    ) -> (Report, Result<Option<TimedRun>, LimitError>) {
        let limits = match MachineLimits::of(self.machine()) {
            Ok(limits) => limits,
            Err(error) => return (self.report_watched(watch), Err(error)),
        };
        let planning = PlanningSink::with(limits.clone(), options, make, TimeBuilder::default());
        let motion = MotionBuilder::new(self, limits, options, planning);
        let report = ReportSink::new(self, watch);
        let both = ReportAndTime { report, motion: Some(motion), left: most_moves };
        let (outcomes, ReportAndTime { report, motion, .. }) = CompensationSink::judge(self, both);
        let timed = motion.map(|motion| {
            let (motion, planning) = motion.finish(outcomes.clone());
            TimedRun { time: planning.finish().finish(), motion }
        });
        let mut report = report.finish(outcomes);
        self.check_other_sides(&mut report, KEPT_PER_CODE);
        (report, Ok(timed))
    }
}

/// Makes a planner whose steps describe the path as the type `P` does.
type MakePlanner<P> = fn(KinematicLimits, PlannerOptions) -> MotionPlanner<P>;

impl<P: PathPart> PlanObserver<P> for TimeBuilder {
    fn request(&mut self, step: &MotionStep, source: &StepSource) {
        TimeBuilder::announce(self, step, source);
    }

    fn step(&mut self, step: PlannerStep<'_, P>) {
        TimeBuilder::step(self, step);
    }
}

/// Times steps and passes them on.
struct TimedSteps<'s, S> {
    time: TimeBuilder,
    steps: SourcedSink<'s, S>,
}

impl<S: PlanSink> PlanObserver<PathPiece> for TimedSteps<'_, S> {
    fn command(&mut self, command: &Command) {
        self.steps.command(command);
    }

    fn request(&mut self, step: &MotionStep, source: &StepSource) {
        self.time.announce(step, source);
        self.steps.request(step, source);
    }

    fn step(&mut self, step: PlannerStep<'_>) {
        self.time.step(step);
        self.steps.step(step);
    }

    fn diagnostic(&mut self, diagnostic: Diagnostic) {
        self.steps.diagnostic(diagnostic);
    }
}

/// Checks and plans in one run.
struct ReportAndTime<'m, 'w, P> {
    report: ReportSink<'m, 'w>,
    /// `None` once there are too many moves.
    motion: Option<MotionBuilder<'m, PlanningSink<TimeBuilder, P>>>,
    /// Moves that may still come before there are too many.
    left: u64,
}

impl<P: PathPart> PathSink for ReportAndTime<'_, '_, P> {
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
        motion.follow(path.command, self.report.segments(), self.report.part_frame());
    }

    fn diagnostic(&mut self, diagnostic: Diagnostic, origin: &Origin) {
        self.report.diagnostic(diagnostic, origin);
    }
}
