//! Setpoints at a fixed period from the steps of a planner.

use chordal_geometry::AXES;

use crate::AxisValues;
use crate::cursor::{TrajectoryCursor, TrajectoryPlace};
use crate::sample::MotionSample;
use crate::trajectory::{PlannedTrajectory, PlannerStep};

/// Makes setpoints at a fixed period out of the steps of a planner, one after the other.
///
/// The last setpoint is the end itself, at the first multiple of the period that is not before
/// the end: a machine is sent whole periods.
#[derive(Clone, Debug)]
pub struct SetpointSampler {
    period_s: f64,
    /// Number of the next setpoint.
    index: u64,
    /// No setpoint of this number or above is made.
    most: u64,
    /// When what was pushed so far is over, s.
    now_s: f64,
    /// What is left of the newest trajectory, which the next may overlap; its memory is used again
    /// and again.
    pending: PlannedTrajectory,
    /// When that trajectory began, and from when on the next may overlap it, s; `None` at rest.
    pending_s: Option<[f64; 2]>,
    /// Where it ends, and the tag there.
    end: (AxisValues, u64),
    cursor: TrajectoryCursor,
    /// The setpoint that is made.
    sample: MotionSample,
}

/// Where the multiple of a period counts as an instant, in periods: a sum of times is only so
/// exact.
const INSTANT_TOLERANCE_PERIODS: f64 = 1e-9;

/// So many places are found before the axes are read there: what one setpoint waits for does not
/// keep the next waiting.
const BATCH_SETPOINTS: usize = 8;

impl SetpointSampler {
    /// A sampler with a period in s.
    ///
    /// # Panics
    /// When the period is not a positive finite number.
    pub fn new(period_s: f64) -> SetpointSampler {
        assert!(period_s > 0.0 && period_s.is_finite(), "a period of {period_s} s");
        SetpointSampler {
            period_s,
            index: 0,
            most: u64::MAX,
            now_s: 0.0,
            pending: PlannedTrajectory::default(),
            pending_s: None,
            end: ([0.0; AXES], 0),
            cursor: TrajectoryCursor::default(),
            sample: MotionSample::default(),
        }
    }

    /// Makes no more than so many setpoints: what a program waits for may be for ever.
    pub fn at_most(mut self, most: u64) -> SetpointSampler {
        self.most = most;
        self
    }

    /// Whether what was pushed so far has more setpoints than it may make.
    pub fn is_exhausted(&self) -> bool {
        // The number of the last one, which is not made before the end is known.
        let last = (self.now_s / self.period_s - INSTANT_TOLERANCE_PERIODS).ceil();
        last >= self.most as f64
    }

    /// When what was pushed so far is over, s.
    pub fn time_s(&self) -> f64 {
        self.now_s
    }

    /// Takes a step and emits the setpoints that are certain now.
    pub fn push(&mut self, step: PlannerStep<'_>, mut take: impl FnMut(&MotionSample)) {
        match step {
            PlannerStep::Trajectory(trajectory) if trajectory.phases.is_empty() => {}
            PlannerStep::Trajectory(trajectory) => {
                // Nothing overlaps a rest, nor what came before the straight end of the trajectory before.
                let begins_s = self.pending_s.map_or(self.now_s, |[_, from_s]| {
                    from_s.max(self.now_s - trajectory.overlap_s)
                });
                self.emit_pending_until(begins_s, &mut take);
                let mut cursor = TrajectoryCursor::default();
                self.both_until_end(trajectory, &mut cursor, begins_s, &mut take);
                self.now_s = self.now_s.max(begins_s + trajectory.duration_s());
                let from_s = begins_s + free_until_s(trajectory);
                self.alone_until(trajectory, &mut cursor, [begins_s, from_s], &mut take);
                let (phase, piece) = cursor.rebase();
                self.pending.phases.clear();
                self.pending.phases.extend_from_slice(&trajectory.phases[phase..]);
                self.pending.pieces.clear();
                self.pending.pieces.extend_from_slice(&trajectory.pieces[piece..]);
                self.pending_s = Some([begins_s, from_s]);
                self.end = (trajectory.to(), trajectory.pieces.last().map_or(0, |piece| piece.tag));
                self.cursor = cursor;
            }
            PlannerStep::Wait { seconds, tag } => {
                self.emit_pending_until(self.now_s, &mut take);
                self.settle();
                self.now_s += seconds.max(0.0);
                self.sample.tag = tag;
                self.rest_until(self.now_s, &mut take);
            }
        }
    }

    /// Emits what is left, the end included.
    pub fn finish(mut self, mut take: impl FnMut(&MotionSample)) {
        let end_s = self.now_s - INSTANT_TOLERANCE_PERIODS * self.period_s;
        self.emit_pending_until(end_s, &mut take);
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
    fn emit(&mut self, time_s: f64, take: &mut impl FnMut(&MotionSample)) {
        self.sample.time_s = time_s;
        take(&self.sample);
        self.index += 1;
    }

    /// Setpoints of the pending trajectory alone, before an instant.
    fn emit_pending_until(&mut self, until_s: f64, take: &mut impl FnMut(&MotionSample)) {
        let Some([pending_s, _]) = self.pending_s else { return };
        let (pending, mut cursor) =
            (std::mem::take(&mut self.pending), std::mem::take(&mut self.cursor));
        self.alone_until(&pending, &mut cursor, [pending_s, until_s], take);
        (self.pending, self.cursor) = (pending, cursor);
    }

    /// Setpoints of a trajectory alone that began at an instant, before another.
    fn alone_until(
        &mut self,
        trajectory: &PlannedTrajectory,
        cursor: &mut TrajectoryCursor,
        [begins_s, until_s]: [f64; 2],
        take: &mut impl FnMut(&MotionSample),
    ) {
        let mut places = [TrajectoryPlace::default(); BATCH_SETPOINTS];
        loop {
            let mut count = 0;
            for place in &mut places {
                let Some(t) = self.due(count, until_s) else { break };
                let Some(reached) = cursor.walk.to(trajectory, t - begins_s) else { return };
                *place = reached;
                count += 1;
            }
            for place in &places[..count as usize] {
                cursor.reading.fill(trajectory, place, &mut self.sample);
                self.emit(self.next_s(), take);
            }
            if (count as usize) < BATCH_SETPOINTS {
                return;
            }
        }
    }

    /// Setpoints at rest, before an instant.
    fn rest_until(&mut self, until_s: f64, take: &mut impl FnMut(&MotionSample)) {
        while let Some(t) = self.due(0, until_s) {
            self.emit(t, take);
        }
    }

    /// Setpoints while the pending trajectory ends and the next has begun.
    fn both_until_end(
        &mut self,
        next: &PlannedTrajectory,
        cursor: &mut TrajectoryCursor,
        begins_s: f64,
        take: &mut impl FnMut(&MotionSample),
    ) {
        let Some([pending_s, _]) = self.pending_s else { return };
        let corner = next.from();
        while let Some(t) = self.due(0, self.now_s) {
            self.cursor.fill(&self.pending, t - pending_s, &mut self.sample);
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

    /// The pending trajectory is over: the axes are at its end.
    fn settle(&mut self) {
        if self.pending_s.take().is_some() {
            let (position, tag) = self.end;
            self.sample = MotionSample { position, tag, ..MotionSample::default() };
        }
    }
}

/// Until when no movement after it overlaps a trajectory, s from its start: in its first half, and before the straight
/// line that it ends on. Curves meet in their halves, single moves on straight lines.
fn free_until_s(trajectory: &PlannedTrajectory) -> f64 {
    straight_end_s(trajectory).min(0.5 * trajectory.duration_s())
}

/// When the straight line begins that a trajectory ends on, s from its start.
fn straight_end_s(trajectory: &PlannedTrajectory) -> f64 {
    let straight = trajectory.pieces.iter().rev().take_while(|piece| piece.is_straight()).count();
    let bent = trajectory.pieces.len() - straight;
    if bent == 0 {
        return 0.0;
    }
    let place: f64 = trajectory.pieces[..bent].iter().map(|piece| piece.length).sum();
    let mut end_s = trajectory.duration_s();
    for phase in trajectory.phases.iter().rev() {
        end_s -= phase.duration_s;
        if phase.from <= place {
            return (end_s + phase.time_at(place, 0.0)).max(0.0);
        }
    }
    0.0
}

fn add(sum: &mut AxisValues, part: &AxisValues) {
    for (sum, part) in sum.iter_mut().zip(part) {
        *sum += part;
    }
}
