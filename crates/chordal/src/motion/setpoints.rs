//! Samples the axis positions of a whole run at a fixed period.

use std::collections::VecDeque;

use chordal_command::AxisMask;

use super::{
    LimitError, MotionOptions, MotionReport, MotionSample, PlanSink, PlannerLevel, PlannerStep,
    SetpointSampler, StepSource, StepSources, UnknownAxes,
};
use crate::job::Job;

/// Which setpoints are requested.
#[derive(Clone, Copy, Debug)]
pub struct SamplingRequest {
    /// Time from one setpoint to the next, s.
    pub period_s: f64,
    /// How much computing the planner spends on a faster motion.
    pub level: PlannerLevel,
    /// The largest number of setpoints; a run with more is an error.
    pub max_samples: u64,
}

/// How the run was planned and sampled.
#[derive(Clone, Debug)]
pub struct SamplingReport {
    /// How the run was planned.
    pub motion: MotionReport,
    /// Time of the run, s.
    pub time_s: f64,
    /// How many setpoints there are.
    pub count: u64,
    /// Axes that have no known position at some setpoint, and are NaN there.
    pub unknown_axes: AxisMask,
    /// The largest distance of the tool from the path when the axes go straight from one setpoint to the next, mm,
    /// and the program line where it occurs.
    pub chord: (f64, u32),
}

/// Why there are no setpoints.
#[derive(Clone, Debug)]
pub enum SamplingError {
    /// A limit of an axis that is not a positive number.
    Limit(LimitError),
    /// There are more than [`SamplingRequest::max_samples`].
    TooMany {
        /// A lower bound of the time of the run, s.
        at_least_s: f64,
    },
}

impl From<LimitError> for SamplingError {
    fn from(error: LimitError) -> SamplingError {
        SamplingError::Limit(error)
    }
}

impl Job<'_> {
    /// Plans the run and emits its setpoints in order of time, each with the line of its block. Dog-leg rapids keep
    /// their shape. The position of an axis that is not known is NaN, and so are its velocity and acceleration where
    /// it moves.
    ///
    /// # Errors
    /// A limit of an axis that is not a positive number, or more setpoints than requested.
    pub fn setpoints(
        &self,
        sampling: &SamplingRequest,
        take: impl FnMut(&MotionSample, u32),
    ) -> Result<SamplingReport, SamplingError> {
        let SamplingRequest { period_s, level, max_samples } = *sampling;
        let options = MotionOptions { level, dog_leg_shape: true, ..MotionOptions::default() };
        let unknown = UnknownAxesQueue::default();
        let taker = SetpointTaker { take, period_s, count: 0, chord: (0.0, 0), unknown };
        let mut setpoints =
            SetpointSink { sampler: SetpointSampler::new(period_s).at_most(max_samples), taker };
        let motion = self.plan(&options, &mut setpoints)?;
        let SetpointSink { sampler, mut taker } = setpoints;
        let time_s = sampler.time_s();
        if sampler.is_exhausted() {
            return Err(SamplingError::TooMany { at_least_s: time_s });
        }
        sampler.finish(|sample| taker.take(sample));
        let unknown_axes = taker.unknown.missing;
        Ok(SamplingReport { motion, time_s, count: taker.count, unknown_axes, chord: taker.chord })
    }
}

/// Passes the planner's steps through the sampler.
struct SetpointSink<F> {
    sampler: SetpointSampler,
    taker: SetpointTaker<F>,
}

struct SetpointTaker<F> {
    take: F,
    period_s: f64,
    count: u64,
    chord: (f64, u32),
    unknown: UnknownAxesQueue,
}

/// Remembers from which step on which axes are not known.
#[derive(Default)]
struct UnknownAxesQueue {
    /// The number of the step and its unknown axes, where these differ from the step before.
    changes: VecDeque<(u32, UnknownAxes)>,
    /// All axes that were unknown at some setpoint.
    missing: AxisMask,
}

impl UnknownAxesQueue {
    fn follow(&mut self, source: &StepSource) {
        let last = self.changes.back().map(|(_, axes)| *axes).unwrap_or_default();
        if source.unknown_axes != last {
            self.changes.push_back((StepSource::number_of(source.tag), source.unknown_axes));
        }
    }

    /// The axes that are not known in the step with this tag. Tags grow.
    fn at(&mut self, tag: u64) -> UnknownAxes {
        let number = StepSource::number_of(tag);
        while self.changes.get(1).is_some_and(|(from, _)| *from <= number) {
            self.changes.pop_front();
        }
        let axes = self.changes.front().filter(|(from, _)| *from <= number);
        axes.map(|(_, axes)| *axes).unwrap_or_default()
    }

    /// The setpoint with NaN for what is not known.
    fn without(&mut self, sample: &MotionSample, unknown: UnknownAxes) -> MotionSample {
        let mut sample = *sample;
        for axis in unknown.places.iter().map(|axis| axis as usize) {
            sample.position[axis] = f64::NAN;
            if unknown.moves.has(axis) {
                (sample.velocity[axis], sample.acceleration[axis]) = (f64::NAN, f64::NAN);
            }
        }
        self.missing = self.missing.or(unknown.places);
        sample
    }
}

impl<F: FnMut(&MotionSample, u32)> SetpointTaker<F> {
    #[inline]
    fn take(&mut self, sample: &MotionSample) {
        let line = StepSource::line_of(sample.tag);
        match self.unknown.at(sample.tag) {
            unknown if unknown.places == AxisMask::NONE => (self.take)(sample, line),
            unknown => (self.take)(&self.unknown.without(sample, unknown), line),
        }
        self.count += 1;
        let chord = normal_acceleration(sample) * self.period_s * self.period_s / 8.0;
        if chord > self.chord.0 {
            self.chord = (chord, line);
        }
    }
}

impl<F: FnMut(&MotionSample, u32)> PlanSink for SetpointSink<F> {
    fn source(&mut self, source: &StepSource) {
        self.taker.unknown.follow(source);
    }

    fn step(&mut self, step: PlannerStep<'_>, _: &StepSources) {
        self.sampler.push(step, |sample| self.taker.take(sample));
    }
}

/// The acceleration normal to the path of the tool, v²·κ, mm/s². Over a period T the chord from one setpoint to the
/// next leaves the path by (vT)²·κ/8, the sagitta of the arc.
fn normal_acceleration(sample: &MotionSample) -> f64 {
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).take(3).map(|(a, b)| a * b).sum::<f64>();
    let speed2 = dot(&sample.velocity, &sample.velocity);
    if speed2 == 0.0 {
        return 0.0;
    }
    let along = dot(&sample.velocity, &sample.acceleration);
    let all = dot(&sample.acceleration, &sample.acceleration);
    // On a straight path `all` and `along`² / `speed2` differ only by rounding, which must not pass for a curvature.
    let across2 = all - along * along / speed2;
    if across2 > 1e-12 * all { across2.sqrt() } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_chord_of_a_period_on_a_circle() {
        // 400 mm/s on R10 at 1 ms: 2 µm.
        let sample = MotionSample {
            velocity: [0.0, 400.0, 0.0, 0.0, 0.0, 0.0],
            acceleration: [-16_000.0, 700.0, 0.0, 0.0, 0.0, 0.0],
            ..MotionSample::default()
        };
        let chord = normal_acceleration(&sample) * 1e-6 / 8.0;
        assert!((chord - 2e-3).abs() < 1e-12);
        let straight = MotionSample { acceleration: [0.0, -700.0, 0.0, 0.0, 0.0, 0.0], ..sample };
        assert_eq!(normal_acceleration(&straight), 0.0);
        assert_eq!(normal_acceleration(&MotionSample::default()), 0.0);
    }
}
