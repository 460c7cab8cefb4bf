use std::collections::VecDeque;

use chordal_control::Command;
use chordal_diagnostics::Diagnostic;
use chordal_motion::{Limits, MoveError, MoveKind, Planner, PlannerOptions, Step};

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

/// Puts the moves of a run through a planner.
pub(crate) struct Planning<'s, S> {
    planner: Planner,
    options: PlannerOptions,
    limits: MachineLimits,
    /// Rapids have limits of their own: the planner of the kind of move that is under way.
    kind: Option<MoveKind>,
    sources: Sources,
    sink: &'s mut S,
}

impl<'s, S: PlanSink> Planning<'s, S> {
    pub fn new(limits: MachineLimits, options: &MotionOptions, sink: &'s mut S) -> Self {
        let options = PlannerOptions::new(options.level);
        Planning {
            planner: Planner::new(limits.cut, options),
            options,
            kind: (limits.cut != limits.rapid).then_some(MoveKind::Cut),
            limits,
            sources: Sources::default(),
            sink,
        }
    }

    /// Hands on what the planner holds.
    pub fn finish(&mut self) {
        let Planning { planner, sources, sink, .. } = self;
        planner.finish(|step| hand_on(step, sources, *sink));
    }

    /// Where rapids have other limits the axes come to rest between the two.
    fn change_limits(&mut self, kind: MoveKind) {
        if self.kind.is_none_or(|before| before == kind) {
            return;
        }
        self.finish();
        self.kind = Some(kind);
        let limits: Limits = match kind {
            MoveKind::Rapid => self.limits.rapid,
            MoveKind::Cut => self.limits.cut,
        };
        self.planner = Planner::new(limits, self.options);
    }
}

fn hand_on<S: PlanSink>(step: Step<'_>, sources: &mut Sources, sink: &mut S) {
    sink.step(step, sources);
    let last = match step {
        Step::Stretch(stretch) => stretch.pieces.last().map(|piece| piece.tag),
        Step::Wait { tag, .. } => Some(tag),
    };
    if let Some(tag) = last {
        // A move may end in one stretch and go on in the next.
        sources.forget_before(tag);
    }
}

impl<S: PlanSink> MotionSink for Planning<'_, S> {
    fn command(&mut self, command: &Command) {
        self.sink.command(command);
    }

    fn step(&mut self, step: &MotionStep, source: &StepSource) -> Result<(), MoveError> {
        if let MotionStep::Move(motion) = step {
            self.change_limits(motion.kind);
        }
        self.sources.push(*source);
        self.sink.source(source);
        self.sink.asked(step, source);
        let Planning { planner, sources, sink, .. } = self;
        match step {
            MotionStep::Move(motion) => planner.push(motion, |step| hand_on(step, sources, *sink)),
            MotionStep::Wait(wait) => {
                planner.wait(wait.seconds, wait.tag, |step| hand_on(step, sources, *sink));
                Ok(())
            }
        }
    }

    fn diagnostic(&mut self, diagnostic: Diagnostic) {
        self.sink.diagnostic(diagnostic);
    }
}
