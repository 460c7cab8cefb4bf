//! The planned motion of a run, passed to a sink with the block of each step.

use chordal_command::Command;
use std::collections::VecDeque;

use chordal_diagnostics::Diagnostic;
use chordal_motion::{
    KinematicLimits, MotionPlanner, MoveError, MoveKind, PathPart, PathPiece, PlannerOptions,
    PlannerStep,
};

use super::{MachineLimits, MotionOptions, MotionSink, MotionStep, StepSource};

/// Takes the planned motion of a run.
pub trait PlanSink {
    /// A command of the tool centre, before its steps are planned.
    fn command(&mut self, _command: &Command) {}

    /// A step goes into the planner; what is planned from it has its tag.
    fn source(&mut self, _source: &StepSource) {}

    /// Like [`PlanSink::source`], with the move or the wait itself.
    fn request(&mut self, _step: &MotionStep, _source: &StepSource) {}

    /// A planned step; `sources` has every tag in it.
    fn step(&mut self, step: PlannerStep<'_>, sources: &StepSources);

    /// A problem of the program.
    fn diagnostic(&mut self, _diagnostic: Diagnostic) {}
}

/// The sources of the steps that are in the planner: as many as its look-ahead.
#[derive(Clone, Debug, Default)]
pub struct StepSources {
    sources: VecDeque<StepSource>,
}

impl StepSources {
    /// The source of the step with a tag; `None` when the step has been emitted.
    pub fn get(&self, tag: u64) -> Option<&StepSource> {
        let first = StepSource::number_of(self.sources.front()?.tag);
        self.sources.get(StepSource::number_of(tag).wrapping_sub(first) as usize)
    }

    /// Number of steps in the planner.
    pub fn len(&self) -> usize {
        self.sources.len()
    }

    /// True where no step is in the planner.
    pub fn is_empty(&self) -> bool {
        self.sources.is_empty()
    }

    fn push(&mut self, source: StepSource) {
        self.sources.push_back(source);
    }

    /// Drops the sources before a tag.
    fn forget_before(&mut self, tag: u64) {
        let Some(first) = self.sources.front().map(|source| StepSource::number_of(source.tag))
        else {
            return;
        };
        let count = StepSource::number_of(tag).wrapping_sub(first) as usize;
        if count <= self.sources.len() {
            self.sources.drain(..count);
        }
    }
}

/// Takes what goes into a planner and what comes out of it. `P` is the type of the path pieces in its steps.
pub(crate) trait PlanObserver<P> {
    /// A command of the tool centre, before its steps are planned.
    fn command(&mut self, _command: &Command) {}

    /// A step goes into the planner.
    fn request(&mut self, step: &MotionStep, source: &StepSource);

    /// A planned step.
    fn step(&mut self, step: PlannerStep<'_, P>);

    /// A problem of the program.
    fn diagnostic(&mut self, _diagnostic: Diagnostic) {}
}

/// Passes planned steps to a sink with the sources of the steps in the planner.
pub(crate) struct SourcedSink<'s, S> {
    sources: StepSources,
    sink: &'s mut S,
}

impl<'s, S: PlanSink> SourcedSink<'s, S> {
    pub fn new(sink: &'s mut S) -> SourcedSink<'s, S> {
        SourcedSink { sources: StepSources::default(), sink }
    }
}

impl<S: PlanSink> PlanObserver<PathPiece> for SourcedSink<'_, S> {
    fn command(&mut self, command: &Command) {
        self.sink.command(command);
    }

    fn request(&mut self, step: &MotionStep, source: &StepSource) {
        self.sources.push(*source);
        self.sink.source(source);
        self.sink.request(step, source);
    }

    fn step(&mut self, step: PlannerStep<'_>) {
        self.sink.step(step, &self.sources);
        let last = match step {
            PlannerStep::Trajectory(trajectory) => trajectory.pieces.last().map(|piece| piece.tag),
            PlannerStep::Wait { tag, .. } => Some(tag),
        };
        if let Some(tag) = last {
            // A move may end in one trajectory and go on in the next.
            self.sources.forget_before(tag);
        }
    }

    fn diagnostic(&mut self, diagnostic: Diagnostic) {
        self.sink.diagnostic(diagnostic);
    }
}

/// Puts the moves of a run through a planner.
pub(crate) struct PlanningSink<T, P = PathPiece> {
    planner: MotionPlanner<P>,
    make: fn(KinematicLimits, PlannerOptions) -> MotionPlanner<P>,
    options: PlannerOptions,
    limits: MachineLimits,
    /// The kind of move whose limits the planner has; `None` where cuts and rapids have the same limits.
    kind: Option<MoveKind>,
    taker: T,
}

impl<'s, S: PlanSink> PlanningSink<SourcedSink<'s, S>> {
    pub fn new(limits: MachineLimits, options: &MotionOptions, sink: &'s mut S) -> Self {
        PlanningSink::with(limits, options, MotionPlanner::new, SourcedSink::new(sink))
    }
}

impl<T: PlanObserver<P>, P: PathPart> PlanningSink<T, P> {
    /// Plans with the planner that `make` returns.
    pub fn with(
        limits: MachineLimits,
        options: &MotionOptions,
        make: fn(KinematicLimits, PlannerOptions) -> MotionPlanner<P>,
        taker: T,
    ) -> PlanningSink<T, P> {
        let junctions = limits.junctions;
        let options = PlannerOptions { junctions, ..PlannerOptions::new(options.level) };
        PlanningSink {
            planner: make(limits.cut, options),
            make,
            options,
            kind: (limits.cut != limits.rapid).then_some(MoveKind::Cut),
            limits,
            taker,
        }
    }

    /// Emits what is left in the planner, and returns the observer.
    pub fn finish(mut self) -> T {
        self.rest();
        self.taker
    }

    /// Emits what is left in the planner.
    fn rest(&mut self) {
        let PlanningSink { planner, taker, .. } = self;
        planner.finish(|step| taker.step(step));
    }

    /// Changes to the limits of a kind of move. Where they differ, the axes come to rest between rapid and cut.
    fn change_limits(&mut self, kind: MoveKind) {
        if self.kind.is_none_or(|before| before == kind) {
            return;
        }
        self.rest();
        self.kind = Some(kind);
        let limits: KinematicLimits = match kind {
            MoveKind::Rapid => self.limits.rapid,
            MoveKind::Cut => self.limits.cut,
        };
        self.planner = (self.make)(limits, self.options);
    }
}

impl<T: PlanObserver<P>, P: PathPart> MotionSink for PlanningSink<T, P> {
    fn command(&mut self, command: &Command) {
        self.taker.command(command);
    }

    fn step(&mut self, step: &MotionStep, source: &StepSource) -> Result<(), MoveError> {
        if let MotionStep::Move(motion) = step {
            self.change_limits(motion.kind);
        }
        self.taker.request(step, source);
        let PlanningSink { planner, taker, .. } = self;
        match step {
            MotionStep::Move(motion) => planner.push(motion, |step| taker.step(step)),
            MotionStep::Wait(wait) => {
                planner.wait(wait.seconds, wait.tag, |step| taker.step(step));
                Ok(())
            }
        }
    }

    fn diagnostic(&mut self, diagnostic: Diagnostic) {
        self.taker.diagnostic(diagnostic);
    }
}
