//! The motion as a drawing: speed, acceleration and jerk over time, and speed along the path.

mod buckets;
mod chart;
mod sheet;

use chordal::machine::PerAxis;
use chordal::motion::{
    KinematicLimits, MotionSample, PlannerStep, SetpointSampler, StepSource, StepSources,
};

use self::buckets::ValueBuckets;
use super::{PlotError, PlotOptions, render};

/// Time between the setpoints that a picture is made of, s.
const PERIOD_S: f64 = 0.0005;
/// Setpoints of which a picture is made at most. Those of what takes longer are further apart.
const MAX_SAMPLES: u64 = 20_000_000;
/// Tool changes that are marked.
const MAX_TOOLS: usize = 500;
/// Slower than this there is no direction of travel, mm/s.
const STANDSTILL_MM_PER_S: f64 = 1e-6;

/// Values of the path and of the axes, by their place in a [`ValueBuckets`] cell.
const SPEED: usize = 0;
const ALONG_ACCELERATION: usize = 1;
const ALONG_JERK: usize = 2;
const ACCELERATION: usize = 3;
const JERK: usize = 9;
const VALUES: usize = 15;

/// Collects setpoints, then draws them: speed, acceleration and jerk over time, each with the
/// limits of the axes, and speed along the path.
///
/// It holds extremes only, in intervals that grow with the program, so that it takes the same
/// room for any length and loses no peak of a setpoint.
#[derive(Debug)]
pub struct MotionPlot {
    limits: KinematicLimits,
    inch: bool,
    time: ValueBuckets<VALUES>,
    by_distance: ValueBuckets<1>,
    distance_mm: f64,
    last: Option<MotionSample>,
    /// Unit vector of travel.
    direction: [f64; 3],
    tool: u32,
    /// When each tool came, s.
    tools: Vec<(f64, u32)>,
    sampler: Option<SetpointSampler>,
}

impl MotionPlot {
    /// An empty drawing with the limits of the axes; numbered in inches or in millimetres.
    pub fn new(limits: &KinematicLimits, inch: bool) -> MotionPlot {
        MotionPlot {
            limits: *limits,
            inch,
            time: ValueBuckets::new(PERIOD_S),
            by_distance: ValueBuckets::new(0.01),
            distance_mm: 0.0,
            last: None,
            direction: [0.0; 3],
            tool: 0,
            tools: Vec::new(),
            sampler: Some(SetpointSampler::new(PERIOD_S).at_most(2 * MAX_SAMPLES)),
        }
    }

    /// The time between its setpoints where a program takes so long, s: a picture of days must not take hours.
    pub fn period_s(time_s: f64) -> f64 {
        PERIOD_S.max(time_s / MAX_SAMPLES as f64)
    }

    /// The same drawing of a program that takes so long, s.
    #[must_use]
    pub fn lasting(self, time_s: f64) -> MotionPlot {
        let period_s = MotionPlot::period_s(time_s);
        let sampler = SetpointSampler::new(period_s).at_most(2 * MAX_SAMPLES);
        MotionPlot { time: ValueBuckets::new(period_s), sampler: Some(sampler), ..self }
    }

    /// Numbers the axes in inches, or in millimetres: after a run, `Summary::inch` says what
    /// the program was in.
    pub fn set_inch(&mut self, inch: bool) {
        self.inch = inch;
    }

    /// Takes a step of a plan, as [`PlanSink::step`](chordal::motion::PlanSink::step) gets it.
    pub fn step(&mut self, step: PlannerStep<'_>, sources: &StepSources) {
        let Some(mut sampler) = self.sampler.take() else { return };
        let tag = match step {
            PlannerStep::Trajectory(trajectory) => trajectory.pieces.first().map(|piece| piece.tag),
            PlannerStep::Wait { tag, .. } => Some(tag),
        };
        if let Some(source) = tag.and_then(|tag| sources.get(tag)) {
            self.tool(sampler.time_s(), source.tool);
        }
        sampler.push(step, |sample| self.sample(sample, StepSource::line_of(sample.tag)));
        self.sampler = Some(sampler);
    }

    /// Takes the end of a plan. Steps after it are not drawn.
    pub fn finish(&mut self) {
        if let Some(sampler) = self.sampler.take() {
            sampler.finish(|sample| self.sample(sample, StepSource::line_of(sample.tag)));
        }
    }

    /// Marks that a tool is in the spindle from a time on, s.
    pub fn tool(&mut self, time_s: f64, tool: u32) {
        if tool != self.tool && self.tools.len() < MAX_TOOLS {
            self.tools.push((time_s, tool));
        }
        self.tool = tool;
    }

    /// Takes a setpoint of a block on this line; the next is later.
    pub fn sample(&mut self, sample: &MotionSample, line: u32) {
        let [vx, vy, vz, ..] = sample.velocity;
        let speed = (vx * vx + vy * vy + vz * vz).sqrt();
        if speed > STANDSTILL_MM_PER_S {
            self.direction = [vx / speed, vy / speed, vz / speed];
        } else if self.direction == [0.0; 3] {
            self.direction = unit(&sample.jerk);
        }
        let along = |axes: &PerAxis<f64>| {
            axes.iter().zip(&self.direction).map(|(value, part)| value * part).sum::<f64>()
        };
        let mut values = [0.0; VALUES];
        values[SPEED] = speed;
        values[ALONG_ACCELERATION] = along(&sample.acceleration);
        values[ALONG_JERK] = along(&sample.jerk);
        values[ACCELERATION..JERK].copy_from_slice(&sample.acceleration);
        values[JERK..].copy_from_slice(&sample.jerk);
        // A multiple of the width belongs to the interval it begins, whatever rounding says.
        self.time.push(sample.time_s * (1.0 + 1e-12), &values, line);
        if let Some(last) = &self.last {
            let step = |axis: usize| sample.position[axis] - last.position[axis];
            self.distance_mm += (0..3).map(|axis| step(axis) * step(axis)).sum::<f64>().sqrt();
        }
        self.by_distance.push(self.distance_mm, &[speed], line);
        self.last = Some(*sample);
    }

    /// The sheet as SVG. Sides below 200 px are drawn as 200.
    pub fn svg(&self, options: &PlotOptions) -> String {
        sheet::svg(self, options)
    }

    /// The sheet as PNG.
    ///
    /// # Errors
    /// When the sheet has no reasonable size.
    pub fn png(&self, options: &PlotOptions) -> Result<Vec<u8>, PlotError> {
        render(options.width_px, options.height_px, || self.svg(options))
    }
}

/// The direction of X, Y and Z; zero where there is none.
fn unit(axes: &PerAxis<f64>) -> [f64; 3] {
    let length = axes[..3].iter().map(|value| value * value).sum::<f64>().sqrt();
    if length > 0.0 { [axes[0] / length, axes[1] / length, axes[2] / length] } else { [0.0; 3] }
}
