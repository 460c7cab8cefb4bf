//! Compares the planned time of a program with the least time that its machine could take.

use std::collections::VecDeque;

use chordal_motion::{LeastTimeGauge, LeastTimes, ReferenceQuality, RunTimes};

use super::builder::MAX_OPERATIONS;
use crate::job::Job;
use crate::motion::{
    LimitError, MachineLimits, MotionOptions, MotionStep, MoveKind, OperationMark, PlanSink,
    PlannerStep, StepSource, StepSources,
};

/// The least times of a program, waits included.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LeastReport {
    /// Of the whole program.
    pub whole: LeastTimes,
    /// Of each operation, as in [`TimeReport::operations`](super::TimeReport::operations).
    pub operations: Vec<LeastTimes>,
}

impl Job<'_> {
    /// Plans once more and compares every motion from rest to rest with its lower bound without jerk limits and its
    /// reference with them. The reference is found by convex programming, which takes about half a millisecond per 2
    /// ms of motion that is not a straight line, up to the limits of `effort`. A whole motion from rest to rest is
    /// held in memory.
    ///
    /// # Errors
    /// A limit of an axis that is not a positive number.
    pub fn least(
        &self,
        options: &MotionOptions,
        effort: ReferenceQuality,
    ) -> Result<LeastReport, LimitError> {
        let limits = MachineLimits::of(self.machine())?;
        let mut measuring = LeastTimeSink {
            cuts: LeastTimeGauge::new(limits.cut, effort),
            rapids: (limits.rapid != limits.cut).then(|| LeastTimeGauge::new(limits.rapid, effort)),
            requested: VecDeque::new(),
            operations: OperationLeastTimes::default(),
        };
        self.plan(options, &mut measuring)?;
        Ok(measuring.finish())
    }
}

/// The programmed speed of a move that is still in the planner.
#[derive(Clone, Copy, Debug)]
struct RequestedSpeed {
    tag: u64,
    speed: f64,
    rapid: bool,
}

/// Where operations begin, and the sums of their times.
#[derive(Debug, Default)]
struct OperationLeastTimes {
    /// The first tag of each operation.
    starts: Vec<u64>,
    report: LeastReport,
}

impl OperationLeastTimes {
    fn begin(&mut self, tag: u64) {
        self.starts.push(tag);
        if self.report.operations.len() < MAX_OPERATIONS {
            self.report.operations.push(LeastTimes::default());
        }
    }

    /// The sums to which a step with this tag is added.
    fn sums(&mut self, tag: u64) -> impl Iterator<Item = &mut LeastTimes> {
        let index = self.starts.partition_point(|start| *start <= tag).saturating_sub(1);
        let LeastReport { whole, operations } = &mut self.report;
        std::iter::once(whole).chain(operations.get_mut(index))
    }

    /// Adds a motion from rest to rest. It lies within one operation, since the axes rest at a tool change; where
    /// operations begin at comments it counts for the one in which it begins.
    fn add(&mut self, run: &RunTimes) {
        self.sums(run.tags.0).for_each(|sum| sum.add(run));
    }
}

struct LeastTimeSink {
    cuts: LeastTimeGauge,
    /// `None` where rapids have the same limits as cuts.
    rapids: Option<LeastTimeGauge>,
    requested: VecDeque<RequestedSpeed>,
    operations: OperationLeastTimes,
}

impl LeastTimeSink {
    fn finish(mut self) -> LeastReport {
        let operations = &mut self.operations;
        self.cuts.finish(|run| operations.add(run));
        if let Some(rapids) = self.rapids {
            rapids.finish(|run| operations.add(run));
        }
        self.operations.report
    }
}

/// The move or wait with a tag, found by its number.
fn find(requested: &VecDeque<RequestedSpeed>, tag: u64) -> Option<&RequestedSpeed> {
    let first = StepSource::number_of(requested.front()?.tag);
    requested.get(StepSource::number_of(tag).wrapping_sub(first) as usize)
}

impl PlanSink for LeastTimeSink {
    fn request(&mut self, step: &MotionStep, source: &StepSource) {
        let tag = source.tag;
        if matches!(source.operation, Some(OperationMark::Begins(_))) {
            self.operations.begin(tag);
        }
        let (speed, rapid) = match step {
            MotionStep::Move(motion) => (motion.speed, motion.kind == MoveKind::Rapid),
            MotionStep::Wait(_) => (f64::INFINITY, false),
        };
        self.requested.push_back(RequestedSpeed { tag, speed, rapid });
    }

    fn step(&mut self, step: PlannerStep<'_>, _: &StepSources) {
        let LeastTimeSink { cuts, rapids, requested, operations } = self;
        let last = match step {
            PlannerStep::Wait { seconds, tag } => {
                operations.sums(tag).for_each(|sum| sum.add_wait(seconds));
                tag
            }
            PlannerStep::Trajectory(trajectory) => {
                let Some(last) = trajectory.pieces.last() else { return };
                let rapid = find(requested, last.tag).is_some_and(|requested| requested.rapid);
                let gauge = match rapids {
                    Some(rapids) if rapid => rapids,
                    _ => cuts,
                };
                let speed =
                    |tag| find(requested, tag).map_or(f64::INFINITY, |requested| requested.speed);
                gauge.push(step, speed, |run| operations.add(run));
                last.tag
            }
        };
        while requested.front().is_some_and(|first| first.tag < last) {
            requested.pop_front();
        }
    }
}
