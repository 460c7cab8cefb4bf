//! The motion in time: setpoints at an even period, which piece of path each is on, and the times.

use std::collections::VecDeque;

use chordal::Job;
use chordal::machine::{AXES, PerAxis};
use chordal::motion::{
    LimitError, MotionOptions, MotionSample, PlanSink, PlannerStep, SetpointSampler, StepSource,
    StepSources,
};
use chordal_export::short_blocks_text;
use serde_json::{Value, json};

use crate::answer;
use crate::frame::Frame;
use crate::wanted::Wanted;

/// Setpoints that are sent at most; beyond, every second is left out, and again.
const MOST: usize = 200_000;

/// Setpoints that are looked at at most: a program that dwells for a year must not take one.
const MOST_LOOKED_AT: u64 = 20_000_000;

/// The shortest period, s.
const SHORTEST_S: f64 = 0.002;

/// Plans a run and packs its motion; `None` when nobody wants it any more. `about_s` is its time
/// without acceleration.
///
/// # Errors
/// A limit of an axis that is not a positive number.
pub fn times(
    number: u64,
    job: &Job,
    about_s: f64,
    wanted: &Wanted,
) -> Result<Option<(Vec<u8>, Value)>, LimitError> {
    let period_s = (about_s / (MOST as f64 / 2.0)).max(SHORTEST_S);
    let period_s = if period_s.is_finite() { period_s } else { 1.0 };
    let mut sink = Setpoints {
        steps: VecDeque::new(),
        sampler: SetpointSampler::new(period_s).at_most(MOST_LOOKED_AT),
        kept: Kept::default(),
    };
    // Places count here, so that a rapid goes where its axes take it.
    let options = MotionOptions { dog_leg_shape: true, ..MotionOptions::default() };
    let timed = job.time_with(&options, &mut sink)?;
    if !wanted.is_wanted() {
        return Ok(None);
    }
    let Setpoints { sampler, mut kept, steps } = sink;
    let (total_s, cut_short) = (sampler.time_s(), sampler.is_exhausted());
    sampler.finish(|sample| kept.take(sample, &steps));
    let mut told = answer::times(&timed.time);
    told["type"] = json!("times");
    told["run"] = json!(number);
    told["refused"] = json!(timed.motion.refused_moves);
    told["short_blocks"] = json!(short_blocks_text(&timed.time.cut_ends, job));
    told["cuts_without_feed"] = json!(timed.motion.cuts_without_feed);
    told["assumed"] = json!(timed.motion.limits.assumed.len());
    let mut frame = Frame::default();
    frame.column("places", &kept.places);
    if kept.turns.iter().any(|angle| *angle != 0.0) {
        frame.column("turns", &kept.turns);
    }
    frame.column("speed", &kept.speed);
    frame.column("row", &kept.row);
    let header = json!({
        "type": "setpoints",
        "run": number,
        "period_s": period_s * kept.stride as f64,
        "total_s": total_s,
        "cut_short": cut_short,
    });
    Ok(Some((frame.finish(header), told)))
}

/// A step that the planner holds.
#[derive(Clone, Copy)]
struct Held {
    number: u32,
    row: u32,
    shift: PerAxis<f64>,
}

/// Setpoints, thinned out to what is sent.
#[derive(Default)]
struct Kept {
    looked_at: usize,
    stride: usize,
    places: Vec<f32>,
    /// A, B and C, rad.
    turns: Vec<f32>,
    speed: Vec<f32>,
    row: Vec<u32>,
}

impl Kept {
    fn take(&mut self, sample: &MotionSample, steps: &VecDeque<Held>) {
        self.stride = self.stride.max(1);
        let is_kept = self.looked_at.is_multiple_of(self.stride);
        self.looked_at += 1;
        if !is_kept {
            return;
        }
        let number = StepSource::number_of(sample.tag);
        let at = steps.partition_point(|step| step.number <= number);
        let held = steps.get(at.saturating_sub(1));
        let (row, shift) = held.map_or((0, [0.0; AXES]), |held| (held.row, held.shift));
        self.places.extend((0..3).map(|axis| (sample.position[axis] - shift[axis]) as f32));
        let turn = |axis: usize| (sample.position[axis] - shift[axis]) as f32;
        self.turns.extend((3..AXES).map(turn));
        self.speed.push((sample.speed() * 60.0) as f32);
        self.row.push(row);
        if self.row.len() >= MOST {
            self.thin_out();
        }
    }

    /// Leaves out every second one.
    fn thin_out(&mut self) {
        let halves = self.row.len().div_ceil(2);
        for at in 0..halves {
            self.row[at] = self.row[2 * at];
            self.speed[at] = self.speed[2 * at];
            self.places.copy_within(6 * at..6 * at + 3, 3 * at);
            self.turns.copy_within(6 * at..6 * at + 3, 3 * at);
        }
        self.row.truncate(halves);
        self.speed.truncate(halves);
        self.places.truncate(3 * halves);
        self.turns.truncate(3 * halves);
        self.stride *= 2;
    }
}

struct Setpoints {
    steps: VecDeque<Held>,
    sampler: SetpointSampler,
    kept: Kept,
}

impl PlanSink for Setpoints {
    fn source(&mut self, source: &StepSource) {
        // A piece of path is a row of what was sent.
        let row = u32::try_from(source.piece).unwrap_or(u32::MAX);
        let number = StepSource::number_of(source.tag);
        self.steps.push_back(Held { number, row, shift: source.shift });
    }

    fn step(&mut self, step: PlannerStep<'_>, sources: &StepSources) {
        if self.sampler.is_exhausted() {
            return;
        }
        let Setpoints { sampler, kept, steps } = self;
        sampler.push(step, |sample| kept.take(sample, steps));
        // The sampler holds the last stretch, whose steps the planner has forgotten.
        let most = 2 * sources.len() + 100_000;
        let passed = steps.len().saturating_sub(most);
        steps.drain(..passed);
    }
}
