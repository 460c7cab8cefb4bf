//! A job's moves, and its steps as they are planned.

use chordal_motion::LimitError;

use super::builder::MotionBuilder;
use super::limits::MachineLimits;
use super::options::MotionOptions;
use super::plan::{PlanSink, PlanningSink};
use super::steps::{MotionReport, MotionSink};
use crate::compensation_sink::CompensationSink;
use crate::job::Job;

impl Job<'_> {
    /// Runs and emits the moves of the machine and its waits, as a planner takes them.
    ///
    /// # Errors
    /// A limit of an axis that is not a positive number.
    pub fn motion<S: MotionSink>(
        &self,
        options: &MotionOptions,
        sink: S,
    ) -> Result<(MotionReport, S), LimitError> {
        let limits = MachineLimits::of(self.machine())?;
        let builder = MotionBuilder::new(self, limits, options, sink);
        let (outcomes, builder) = CompensationSink::run(self, builder);
        Ok(builder.finish(outcomes))
    }

    /// Runs and plans: emits the steps of the machine as they become certain.
    ///
    /// # Errors
    /// A limit of an axis that is not a positive number.
    pub fn plan<S: PlanSink>(
        &self,
        options: &MotionOptions,
        sink: &mut S,
    ) -> Result<MotionReport, LimitError> {
        let planning = PlanningSink::new(MachineLimits::of(self.machine())?, options, sink);
        let (report, planning) = self.motion(options, planning)?;
        planning.finish();
        Ok(report)
    }
}
