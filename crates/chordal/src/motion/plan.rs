//! The planned motion of a run, given to a sink with the block of each step.

use chordal_command::Command;
use std::collections::VecDeque;

use chordal_diagnostics::Diagnostic;
use chordal_motion::{Limits, MoveError, MoveKind, PathPart, Piece, Planner, PlannerOptions, Step};

use super::{MachineLimits, MotionOptions, MotionSink, MotionStep, StepSource};

/// Takes the planned motion of a run.
pub trait PlanSink {
    /// A command of the tool centre goes by, before its steps are planned.
    fn command(&mut self, _command: &Command) {}

    /// A step goes into the planner; what comes out of it bears its tag.
    fn source(&mut self, _source: &StepSource) {}

    /// The same, with the move or the wait itself.
    fn asked(&mut self, _step: &MotionStep, _source: &StepSource) {}

    /// A planned step; `sources` knows every tag in it.
    fn step(&mut self, step: Step<'_>, sources: &Sources);

    /// A problem of the program.
    fn diagnostic(&mut self, _diagnostic: Diagnostic) {}
}

/// The sources of the steps that the planner holds: as many as it looks ahead.
#[derive(Clone, Debug, Default)]
pub struct Sources {
    held: VecDeque<StepSource>,
}

impl Sources {
    /// Where a tag comes from; `None` when its step is over.
    pub fn get(&self, tag: u64) -> Option<&StepSource> {
        let first = StepSource::number_of(self.held.front()?.tag);
        self.held.get(StepSource::number_of(tag).wrapping_sub(first) as usize)
    }

    /// How many are held.
    pub fn len(&self) -> usize {
        self.held.len()
    }

    /// None is held.
    pub fn is_empty(&self) -> bool {
        self.held.is_empty()
    }

    fn push(&mut self, source: StepSource) {
        self.held.push_back(source);
    }

    /// Forgets what lies before a tag.
    fn forget_before(&mut self, tag: u64) {
        let Some(first) = self.held.front().map(|source| StepSource::number_of(source.tag)) else {
            return;
        };
        let count = StepSource::number_of(tag).wrapping_sub(first) as usize;
        if count <= self.held.len() {
            self.held.drain(..count);
        }
    }
}

/// Takes what goes into a planner and what comes out of it. `P` is what the steps say about the path.
pub(crate) trait Planned<P> {
    /// A command of the tool centre goes by, before its steps are planned.
    fn command(&mut self, _command: &Command) {}

    /// A step goes into the planner.
    fn asked(&mut self, step: &MotionStep, source: &StepSource);

    /// A planned step.
    fn step(&mut self, step: Step<'_, P>);

    /// A problem of the program.
    fn diagnostic(&mut self, _diagnostic: Diagnostic) {}
}

/// A sink with the sources of what the planner holds.
pub(crate) struct WithSources<'s, S> {
    sources: Sources,
    sink: &'s mut S,
}

impl<'s, S: PlanSink> WithSources<'s, S> {
    pub fn new(sink: &'s mut S) -> WithSources<'s, S> {
        WithSources { sources: Sources::default(), sink }
    }
}

impl<S: PlanSink> Planned<Piece> for WithSources<'_, S> {
    fn command(&mut self, command: &Command) {
        self.sink.command(command);
    }

    fn asked(&mut self, step: &MotionStep, source: &StepSource) {
        self.sources.push(*source);
        self.sink.source(source);
        self.sink.asked(step, source);
    }

    fn step(&mut self, step: Step<'_>) {
        self.sink.step(step, &self.sources);
        let last = match step {
            Step::Stretch(stretch) => stretch.pieces.last().map(|piece| piece.tag),
            Step::Wait { tag, .. } => Some(tag),
        };
        if let Some(tag) = last {
            // A move may end in one stretch and go on in the next.
            self.sources.forget_before(tag);
        }
    }

    fn diagnostic(&mut self, diagnostic: Diagnostic) {
        self.sink.diagnostic(diagnostic);
    }
}

/// Puts the moves of a run through a planner.
pub(crate) struct Planning<T, P = Piece> {
    planner: Planner<P>,
    make: fn(Limits, PlannerOptions) -> Planner<P>,
    options: PlannerOptions,
    limits: MachineLimits,
    /// Rapids have limits of their own: the planner of the kind of move that is under way.
    kind: Option<MoveKind>,
    taker: T,
}

impl<'s, S: PlanSink> Planning<WithSources<'s, S>> {
    pub fn new(limits: MachineLimits, options: &MotionOptions, sink: &'s mut S) -> Self {
        Planning::with(limits, options, Planner::new, WithSources::new(sink))
    }
}

impl<T: Planned<P>, P: PathPart> Planning<T, P> {
    /// With the planner that is wanted.
    pub fn with(
        limits: MachineLimits,
        options: &MotionOptions,
        make: fn(Limits, PlannerOptions) -> Planner<P>,
        taker: T,
    ) -> Planning<T, P> {
        let junctions = limits.junctions;
        let options = PlannerOptions { junctions, ..PlannerOptions::new(options.level) };
        Planning {
            planner: make(limits.cut, options),
            make,
            options,
            kind: (limits.cut != limits.rapid).then_some(MoveKind::Cut),
            limits,
            taker,
        }
    }

    /// Hands on what the planner holds, and gives back who took it.
    pub fn finish(mut self) -> T {
        self.rest();
        self.taker
    }

    /// Hands on what the planner holds.
    fn rest(&mut self) {
        let Planning { planner, taker, .. } = self;
        planner.finish(|step| taker.step(step));
    }

    /// Where rapids have other limits the axes come to rest between the two.
    fn change_limits(&mut self, kind: MoveKind) {
        if self.kind.is_none_or(|before| before == kind) {
            return;
        }
        self.rest();
        self.kind = Some(kind);
        let limits: Limits = match kind {
            MoveKind::Rapid => self.limits.rapid,
            MoveKind::Cut => self.limits.cut,
        };
        self.planner = (self.make)(limits, self.options);
    }
}

impl<T: Planned<P>, P: PathPart> MotionSink for Planning<T, P> {
    fn command(&mut self, command: &Command) {
        self.taker.command(command);
    }

    fn step(&mut self, step: &MotionStep, source: &StepSource) -> Result<(), MoveError> {
        if let MotionStep::Move(motion) = step {
            self.change_limits(motion.kind);
        }
        self.taker.asked(step, source);
        let Planning { planner, taker, .. } = self;
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
