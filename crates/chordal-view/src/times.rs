//! The motion over time: setpoints at a constant period, the path segment of each, and the times of the run.

use std::collections::VecDeque;

use chordal::Job;
use chordal::control::ProgramOffsets;
use chordal::geometry::Vec3;
use chordal::machine::{AXES, PerAxis};
use chordal::motion::{
    LimitError, MotionOptions, MotionSample, PlacedPartFrame, PlanSink, PlannerStep,
    SetpointSampler, StepKind, StepSource, StepSources,
};
use chordal_export::short_blocks_text;
use serde_json::{Value, json};

use crate::answer;
use crate::cancel_token::CancelToken;
use crate::frame::ColumnFrame;
use crate::part_path::PartKinematics;
use crate::run::FinishedRun;

/// The most setpoints that are sent. When there are more, every second one is dropped, repeatedly.
const MAX_SETPOINTS: usize = 200_000;

/// The most setpoints that are computed, so that a program with very long dwells ends soon.
const MAX_SAMPLES: u64 = 20_000_000;

/// The shortest period, s.
const MIN_PERIOD_S: f64 = 0.002;

/// Plans a run and packs its motion; `None` when it was canceled.
///
/// # Errors A limit of an axis is not a positive number.
pub fn times(
    number: u64,
    job: &Job,
    run: &FinishedRun,
    cancel: &CancelToken,
) -> Result<Option<(Vec<u8>, Value)>, LimitError> {
    let period_s = (run.about_s / (MAX_SETPOINTS as f64 / 2.0)).max(MIN_PERIOD_S);
    let period_s = if period_s.is_finite() { period_s } else { 1.0 };
    let mut sink = TimedSetpointSink {
        steps: VecDeque::new(),
        sampler: SetpointSampler::new(period_s).at_most(MAX_SAMPLES),
        thinned: ThinnedSetpoints::default(),
    };
    // Rapids follow their dog-leg here, because the page shows positions.
    let options = MotionOptions { dog_leg_shape: true, ..MotionOptions::default() };
    let timed = job.time_with(&options, &mut sink)?;
    if !cancel.is_current() {
        return Ok(None);
    }
    let TimedSetpointSink { sampler, mut thinned, steps } = sink;
    let (total_s, cut_short) = (sampler.time_s(), sampler.is_exhausted());
    sampler.finish(|sample| thinned.take(sample, &steps));
    thinned.begin_at_first_move();
    let mut message = answer::times(&timed.time);
    message["type"] = json!("times");
    message["run"] = json!(number);
    message["refused"] = json!(timed.motion.refused_moves);
    message["short_blocks"] = json!(short_blocks_text(&timed.time.cut_ends, job));
    message["cuts_without_feed"] = json!(timed.motion.cuts_without_feed);
    message["assumed"] = json!(timed.motion.limits.assumed.len());
    let mut frame = ColumnFrame::default();
    if let Some(Ok(machine)) = job.machine_on_part() {
        let axes = thinned.machine_axes(&timed.motion.part_frames, machine.run_zero, |row| {
            run.modal.offsets_on(row)
        });
        frame.column("axes", &axes);
    }
    let does_turn = thinned.turns.iter().any(|angle| *angle != 0.0);
    let kinematics = PartKinematics::of(&job.rotary_axes()).filter(|_| does_turn);
    match kinematics {
        Some(kinematics) => {
            let mut placed = thinned.on_part(&kinematics);
            let period_s = period_s * thinned.stride as f64;
            thinned.follow_tip(&timed.motion.part_frames, &mut placed, period_s);
            frame.column("places", &placed);
            frame.column("programmed", &thinned.places);
        }
        None => frame.column("places", &thinned.places),
    }
    if does_turn {
        frame.column("turns", &thinned.turns);
    }
    frame.column("speed", &thinned.speed);
    frame.column("row", &thinned.row);
    let header = json!({
        "type": "setpoints",
        "run": number,
        "period_s": period_s * thinned.stride as f64,
        "total_s": total_s,
        "cut_short": cut_short,
    });
    Ok(Some((frame.finish(header), message)))
}

/// A planned step whose setpoints are not complete yet.
#[derive(Clone, Copy)]
struct PlannedStep {
    number: u32,
    row: u32,
    shift: PerAxis<f64>,
    part_frame: Option<u32>,
    /// A wait before the first move, at a position that the planner does not know yet.
    is_before_moves: bool,
}

/// The setpoints to send, thinned out.
#[derive(Default)]
struct ThinnedSetpoints {
    samples: usize,
    stride: usize,
    places: Vec<f32>,
    /// A, B and C, rad.
    turns: Vec<f32>,
    speed: Vec<f32>,
    row: Vec<u32>,
    /// The frames of the part, by their index in the report.
    part_frames: Vec<Option<u32>>,
    /// The number of setpoints before the first move.
    before_moves: usize,
}

impl ThinnedSetpoints {
    fn take(&mut self, sample: &MotionSample, steps: &VecDeque<PlannedStep>) {
        self.stride = self.stride.max(1);
        let is_taken = self.samples.is_multiple_of(self.stride);
        self.samples += 1;
        if !is_taken {
            return;
        }
        let number = StepSource::number_of(sample.tag);
        let at = steps.partition_point(|step| step.number <= number);
        let planned = steps.get(at.saturating_sub(1));
        let (row, shift) = planned.map_or((0, [0.0; AXES]), |planned| (planned.row, planned.shift));
        if planned.is_some_and(|planned| planned.is_before_moves) {
            self.before_moves = self.row.len() + 1;
        }
        self.part_frames.push(planned.and_then(|planned| planned.part_frame));
        self.places.extend((0..3).map(|axis| (sample.position[axis] - shift[axis]) as f32));
        let turn = |axis: usize| (sample.position[axis] - shift[axis]) as f32;
        self.turns.extend((3..AXES).map(turn));
        self.speed.push((sample.speed() * 60.0) as f32);
        self.row.push(row);
        if self.row.len() >= MAX_SETPOINTS {
            self.thin_out();
        }
    }

    /// Until the first move the axes are where it begins.
    fn begin_at_first_move(&mut self) {
        let first = self.before_moves;
        if first >= self.row.len() {
            return;
        }
        let frame = self.part_frames[first];
        self.part_frames[..first].fill(frame);
        for at in 0..first {
            self.places.copy_within(3 * first..3 * first + 3, 3 * at);
            self.turns.copy_within(3 * first..3 * first + 3, 3 * at);
        }
    }

    /// The positions relative to the part.
    fn on_part(&self, kinematics: &PartKinematics) -> Vec<f32> {
        let (positions, turns) = (self.places.as_chunks::<3>().0, self.turns.as_chunks::<3>().0);
        let placed = positions.iter().zip(turns).flat_map(|(position, angles)| {
            let [x, y, z] = position.map(f64::from);
            let on_part = kinematics.at(angles.map(f64::from)).apply_point(Vec3::new(x, y, z));
            on_part.to_array().map(|mm| mm as f32)
        });
        placed.collect()
    }

    /// The positions of all axes in machine coordinates, six numbers each, mm and rad. `run_zero` is the zero of the run
    /// on the machine, `offsets` gives those in force on a row.
    fn machine_axes(
        &self,
        frames: &[PlacedPartFrame],
        run_zero: Vec3,
        offsets: impl Fn(u32) -> ProgramOffsets,
    ) -> Vec<f32> {
        let run_zero = run_zero.to_array();
        let (positions, turns) = (self.places.as_chunks::<3>().0, self.turns.as_chunks::<3>().0);
        let mut axes = Vec::with_capacity(AXES * self.row.len());
        for (at, (position, angles)) in positions.iter().zip(turns).enumerate() {
            let part_frame = self.part_frames[at].and_then(|index| frames.get(index as usize));
            let in_force = part_frame.map_or_else(|| offsets(self.row[at]), |own| own.offsets);
            for axis in 0..AXES {
                // Without a frame of the part X, Y and Z are in the frame of the run.
                let work = match axis {
                    0..3 if part_frame.is_none() => run_zero[axis],
                    _ => in_force.work[axis],
                };
                let value = if axis < 3 { position[axis] } else { angles[axis - 3] };
                axes.push((f64::from(value) + work + in_force.tool[axis]) as f32);
            }
        }
        axes
    }

    /// Makes the setpoints in frames of the part those of the tip: the programmed positions, which replace those of the
    /// axes, and in `placed` those on the part; the speed becomes that of the tip.
    fn follow_tip(&mut self, frames: &[PlacedPartFrame], placed: &mut [f32], period_s: f64) {
        let frame_of = |index: Option<u32>| frames.get(index? as usize);
        let rows = self.part_frames.iter().enumerate();
        let of_tip: Vec<usize> =
            rows.filter(|(_, index)| frame_of(**index).is_some()).map(|(at, _)| at).collect();
        for at in &of_tip {
            let Some(frame) = frame_of(self.part_frames[*at]) else { continue };
            let value = |from: &[f32], axis: usize| f64::from(from[3 * at + axis]);
            let axes: PerAxis<f64> = std::array::from_fn(|axis| match axis {
                0..3 => value(&self.places, axis),
                _ => value(&self.turns, axis - 3),
            });
            let program = frame.program_position(&axes);
            let on_part = frame.in_run_frame(&program).to_array();
            for axis in 0..3 {
                self.places[3 * at + axis] = program[axis] as f32;
                placed[3 * at + axis] = on_part[axis] as f32;
            }
        }
        let point =
            |at: usize| Vec3::from_array([0, 1, 2].map(|axis| f64::from(placed[3 * at + axis])));
        for pair in of_tip.windows(2).filter(|pair| pair[1] == pair[0] + 1) {
            let mm_per_s = point(pair[0]).distance(point(pair[1])) / period_s;
            self.speed[pair[0]] = (mm_per_s * 60.0) as f32;
        }
    }

    /// Drops every second setpoint.
    fn thin_out(&mut self) {
        let halves = self.row.len().div_ceil(2);
        for at in 0..halves {
            self.row[at] = self.row[2 * at];
            self.part_frames[at] = self.part_frames[2 * at];
            self.speed[at] = self.speed[2 * at];
            self.places.copy_within(6 * at..6 * at + 3, 3 * at);
            self.turns.copy_within(6 * at..6 * at + 3, 3 * at);
        }
        self.before_moves = self.before_moves.div_ceil(2);
        self.row.truncate(halves);
        self.part_frames.truncate(halves);
        self.speed.truncate(halves);
        self.places.truncate(3 * halves);
        self.turns.truncate(3 * halves);
        self.stride *= 2;
    }
}

struct TimedSetpointSink {
    steps: VecDeque<PlannedStep>,
    sampler: SetpointSampler,
    thinned: ThinnedSetpoints,
}

impl PlanSink for TimedSetpointSink {
    fn source(&mut self, source: &StepSource) {
        // The index of a path segment is the row in the sent columns.
        let row = u32::try_from(source.piece).unwrap_or(u32::MAX);
        let number = StepSource::number_of(source.tag);
        let part_frame = match source.kind {
            StepKind::Move(_) => source.part_frame,
            // The tip stays where the last move has brought it.
            StepKind::Wait(_) => self.steps.back().and_then(|step| step.part_frame),
        };
        let is_before_moves = matches!(source.kind, StepKind::Wait(_))
            && self.steps.back().is_none_or(|step| step.is_before_moves);
        let shift = source.shift;
        self.steps.push_back(PlannedStep { number, row, shift, part_frame, is_before_moves });
    }

    fn step(&mut self, step: PlannerStep<'_>, sources: &StepSources) {
        if self.sampler.is_exhausted() {
            return;
        }
        let TimedSetpointSink { sampler, thinned, steps } = self;
        sampler.push(step, |sample| thinned.take(sample, steps));
        // The sampler lags behind by one trajectory, whose steps the planner has already dropped.
        let most = 2 * sources.len() + 100_000;
        let passed = steps.len().saturating_sub(most);
        steps.drain(..passed);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn axes_on_the_machine_are_those_of_the_gauge_point() {
        let setpoints = ThinnedSetpoints {
            places: vec![10.0, 20.0, 30.0],
            turns: vec![0.0, 0.0, 1.0],
            row: vec![7],
            part_frames: vec![None],
            ..ThinnedSetpoints::default()
        };
        // The work offset in force is another one than that of the run, to which the positions belong.
        let offsets = |row| {
            assert_eq!(row, 7);
            ProgramOffsets {
                work: [-1.0, -2.0, -3.0, 0.0, 0.0, 0.5],
                tool: [0.0, 0.0, 100.0, 0.0, 0.0, 0.0],
            }
        };
        let run_zero = Vec3::new(-300.0, -200.0, -350.0);
        let axes = setpoints.machine_axes(&[], run_zero, offsets);
        assert_eq!(axes, [-290.0, -180.0, -220.0, 0.0, 0.0, 1.5]);
    }
}
