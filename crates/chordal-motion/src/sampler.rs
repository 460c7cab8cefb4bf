//! Setpoints at a fixed period from the steps of a planner.

use chordal_geometry::AXES;

use crate::Axes;
use crate::cursor::{Cursor, Place};
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
    /// What is left of the newest stretch, which the next may overlap; its memory is used again
    /// and again.
    held: Stretch,
    /// When that stretch began, and from when on the next may overlap it, s; `None` at rest.
    held_s: Option<[f64; 2]>,
    /// Where it ends, and the tag there.
    end: (Axes, u64),
    cursor: Cursor,
    /// The setpoint that is made.
    sample: Sample,
}

/// Where the multiple of a period counts as an instant, in periods: a sum of times is only so
/// exact.
const SAME: f64 = 1e-9;

/// So many places are found before the axes are read there: what one setpoint waits for does not
/// keep the next waiting.
const BATCH: usize = 8;

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
            end: ([0.0; AXES], 0),
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
                // Nothing overlaps a rest, nor what came before the straight end of the stretch before.
                let begins_s = self
                    .held_s
                    .map_or(self.now_s, |[_, from_s]| from_s.max(self.now_s - stretch.overlap_s));
                self.held_until(begins_s, &mut take);
                let mut cursor = Cursor::default();
                self.both_until_end(stretch, &mut cursor, begins_s, &mut take);
                self.now_s = self.now_s.max(begins_s + stretch.duration_s());
                let from_s = begins_s + free_until_s(stretch);
                self.alone_until(stretch, &mut cursor, [begins_s, from_s], &mut take);
                let (phase, piece) = cursor.leave_behind();
                self.held.phases.clear();
                self.held.phases.extend_from_slice(&stretch.phases[phase..]);
                self.held.pieces.clear();
                self.held.pieces.extend_from_slice(&stretch.pieces[piece..]);
                self.held_s = Some([begins_s, from_s]);
                self.end = (stretch.to(), stretch.pieces.last().map_or(0, |piece| piece.tag));
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

    /// When the setpoint after so many is due, if that is before an instant.
    #[inline(always)]
    fn due(&self, after: u64, until_s: f64) -> Option<f64> {
        let due_s = (self.index + after) as f64 * self.period_s;
        (due_s < until_s && self.index + after < self.most).then_some(due_s)
    }

    #[inline(always)]
    fn emit(&mut self, time_s: f64, take: &mut impl FnMut(&Sample)) {
        self.sample.time_s = time_s;
        take(&self.sample);
        self.index += 1;
    }

    /// Setpoints of the held stretch alone, before an instant.
    fn held_until(&mut self, until_s: f64, take: &mut impl FnMut(&Sample)) {
        let Some([held_s, _]) = self.held_s else { return };
        let (held, mut cursor) = (std::mem::take(&mut self.held), std::mem::take(&mut self.cursor));
        self.alone_until(&held, &mut cursor, [held_s, until_s], take);
        (self.held, self.cursor) = (held, cursor);
    }

    /// Setpoints of a stretch alone that began at an instant, before another.
    fn alone_until(
        &mut self,
        stretch: &Stretch,
        cursor: &mut Cursor,
        [begins_s, until_s]: [f64; 2],
        take: &mut impl FnMut(&Sample),
    ) {
        let mut places = [Place::default(); BATCH];
        loop {
            let mut count = 0;
            for place in &mut places {
                let Some(t) = self.due(count, until_s) else { break };
                let Some(found) = cursor.walk.to(stretch, t - begins_s) else { return };
                *place = found;
                count += 1;
            }
            for place in &places[..count as usize] {
                cursor.reading.fill(stretch, place, &mut self.sample);
                self.emit(self.next_s(), take);
            }
            if (count as usize) < BATCH {
                return;
            }
        }
    }

    /// Setpoints at rest, before an instant.
    fn rest_until(&mut self, until_s: f64, take: &mut impl FnMut(&Sample)) {
        while let Some(t) = self.due(0, until_s) {
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
        let Some([held_s, _]) = self.held_s else { return };
        let corner = next.from();
        while let Some(t) = self.due(0, self.now_s) {
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
            let (position, tag) = self.end;
            self.sample = Sample { position, tag, ..Sample::default() };
        }
    }
}

/// Until when no movement after it overlaps a stretch, s from its start: in its first half, and before the straight
/// line that it ends on. Curves meet in their halves, single moves on straight lines.
fn free_until_s(stretch: &Stretch) -> f64 {
    straight_end_s(stretch).min(0.5 * stretch.duration_s())
}

/// When the straight line begins that a stretch ends on, s from its start.
fn straight_end_s(stretch: &Stretch) -> f64 {
    let straight = stretch.pieces.iter().rev().take_while(|piece| piece.is_straight()).count();
    let bent = stretch.pieces.len() - straight;
    if bent == 0 {
        return 0.0;
    }
    let place: f64 = stretch.pieces[..bent].iter().map(|piece| piece.length).sum();
    let mut end_s = stretch.duration_s();
    for phase in stretch.phases.iter().rev() {
        end_s -= phase.duration_s;
        if phase.from <= place {
            return (end_s + phase.time_at(place, 0.0)).max(0.0);
        }
    }
    0.0
}

fn add(sum: &mut Axes, part: &Axes) {
    for (sum, part) in sum.iter_mut().zip(part) {
        *sum += part;
    }
}
