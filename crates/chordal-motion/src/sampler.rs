//! Setpoints at a fixed period from the steps of a planner.

use crate::Axes;
use crate::cursor::Cursor;
use crate::sample::Sample;
use crate::trajectory::{Step, Stretch};

/// Makes setpoints at a fixed period out of the steps of a planner, one after the other.
///
/// The last setpoint is the end itself, at the first multiple of the period that is not before
/// the end: a machine is sent whole periods.
#[derive(Clone, Debug)]
pub struct Sampler {
    period_s: f64,
    /// Number of the next setpoint.
    index: u64,
    /// No setpoint of this number or above is made.
    most: u64,
    /// When what was pushed so far is over, s.
    now_s: f64,
    /// The newest stretch, which the next may overlap; its memory is used again and again.
    held: Stretch,
    /// When the held stretch began, s; `None` at rest.
    held_s: Option<f64>,
    cursor: Cursor,
    /// The setpoint that is made.
    sample: Sample,
}

/// Where the multiple of a period counts as an instant, in periods: a sum of times is only so
/// exact.
const SAME: f64 = 1e-9;

impl Sampler {
    /// A sampler with a period in s.
    ///
    /// # Panics
    /// When the period is not a positive finite number.
    pub fn new(period_s: f64) -> Sampler {
        assert!(period_s > 0.0 && period_s.is_finite(), "a period of {period_s} s");
        Sampler {
            period_s,
            index: 0,
            most: u64::MAX,
            now_s: 0.0,
            held: Stretch::default(),
            held_s: None,
            cursor: Cursor::default(),
            sample: Sample::default(),
        }
    }

    /// Makes no more than so many setpoints: what a program waits for may be for ever.
    pub fn at_most(mut self, most: u64) -> Sampler {
        self.most = most;
        self
    }

    /// Whether what was pushed so far has more setpoints than it may make.
    pub fn is_exhausted(&self) -> bool {
        // The number of the last one, which is not made before the end is known.
        let last = (self.now_s / self.period_s - SAME).ceil();
        last >= self.most as f64
    }

    /// When what was pushed so far is over, s.
    pub fn time_s(&self) -> f64 {
        self.now_s
    }

    /// Takes a step and emits the setpoints that are certain now.
    pub fn push(&mut self, step: Step<'_>, mut take: impl FnMut(&Sample)) {
        match step {
            Step::Stretch(stretch) if stretch.phases.is_empty() => {}
            Step::Stretch(stretch) => {
                // Nothing overlaps a rest, nor what came before the stretch before.
                let begins_s =
                    self.held_s.map_or(self.now_s, |s| s.max(self.now_s - stretch.overlap_s));
                self.held_until(begins_s, &mut take);
                let mut cursor = Cursor::default();
                self.both_until_end(stretch, &mut cursor, begins_s, &mut take);
                self.now_s = self.now_s.max(begins_s + stretch.duration_s());
                self.held.clone_from(stretch);
                self.held_s = Some(begins_s);
                self.cursor = cursor;
            }
            Step::Wait { seconds, tag } => {
                self.held_until(self.now_s, &mut take);
                self.settle();
                self.now_s += seconds.max(0.0);
                self.sample.tag = tag;
                self.rest_until(self.now_s, &mut take);
            }
        }
    }

    /// Hands on what is left, the end included.
    pub fn finish(mut self, mut take: impl FnMut(&Sample)) {
        let end_s = self.now_s - SAME * self.period_s;
        self.held_until(end_s, &mut take);
        self.settle();
        if self.index < self.most {
            self.emit(self.next_s(), &mut take);
        }
    }

    #[inline(always)]
    fn next_s(&self) -> f64 {
        self.index as f64 * self.period_s
    }

    /// When the next setpoint is due, if that is before an instant.
    #[inline(always)]
    fn due(&self, until_s: f64) -> Option<f64> {
        let next_s = self.next_s();
        (next_s < until_s && self.index < self.most).then_some(next_s)
    }

    #[inline(always)]
    fn emit(&mut self, time_s: f64, take: &mut impl FnMut(&Sample)) {
        self.sample.time_s = time_s;
        take(&self.sample);
        self.index += 1;
    }

    /// Setpoints of the held stretch alone, before an instant.
    fn held_until(&mut self, until_s: f64, take: &mut impl FnMut(&Sample)) {
        let Some(held_s) = self.held_s else { return };
        while let Some(t) = self.due(until_s) {
            self.cursor.fill(&self.held, t - held_s, &mut self.sample);
            self.emit(t, take);
        }
    }

    /// Setpoints at rest, before an instant.
    fn rest_until(&mut self, until_s: f64, take: &mut impl FnMut(&Sample)) {
        while let Some(t) = self.due(until_s) {
            self.emit(t, take);
        }
    }

    /// Setpoints while the held stretch ends and the next has begun.
    fn both_until_end(
        &mut self,
        next: &Stretch,
        cursor: &mut Cursor,
        begins_s: f64,
        take: &mut impl FnMut(&Sample),
    ) {
        let Some(held_s) = self.held_s else { return };
        let corner = next.from();
        while let Some(t) = self.due(self.now_s) {
            self.cursor.fill(&self.held, t - held_s, &mut self.sample);
            let mut after = cursor.at(next, t - begins_s);
            for (place, corner) in after.position.iter_mut().zip(&corner) {
                *place -= corner;
            }
            add(&mut self.sample.position, &after.position);
            add(&mut self.sample.velocity, &after.velocity);
            add(&mut self.sample.acceleration, &after.acceleration);
            add(&mut self.sample.jerk, &after.jerk);
            self.emit(t, take);
        }
    }

    /// The held stretch is over: the axes stand at its end.
    fn settle(&mut self) {
        if self.held_s.take().is_some() {
            let tag = self.held.pieces.last().map_or(0, |piece| piece.tag);
            self.sample = Sample { position: self.held.to(), tag, ..Sample::default() };
        }
    }
}

fn add(sum: &mut Axes, part: &Axes) {
    for (sum, part) in sum.iter_mut().zip(part) {
        *sum += part;
    }
}
