//! The planner of small controls (GRBL): trapezoids of constant acceleration without jerk limits, and at each junction of
//! two straight segments the speed of an arc that passes it within the junction deviation.
//!
//! Arcs are divided into the segments that the control makes, with their ends on the curve. The control looks a fixed
//! number of blocks ahead: each block ends no faster than the axes can stop from by the end of the last known one.

use std::collections::VecDeque;

use chordal_geometry::{AXES, Curve, ParamCurve, Placement};

use crate::AxisValues;
use crate::corner_blend::path_span::PathPart;
use crate::limits::KinematicLimits;
use crate::move_request::{CornerMode, MoveRequest};
use crate::piece::PathPiece;
use crate::trajectory::{JerkPhase, PlannedTrajectory, PlannerStep};

/// The parameters of the planner, as the control's settings have them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct JunctionRule {
    /// The junction deviation, mm (GRBL `$11`); 0: every segment ends at rest.
    pub deviation_mm: f64,
    /// The number of blocks that are known, the current one included.
    pub blocks: usize,
    /// The largest distance of the segments of an arc from it, mm (GRBL `$12`).
    pub arc_tolerance_mm: f64,
    /// The rule for dividing arcs by the length of segments instead (Marlin); `None`: by the tolerance.
    pub arc_segments: Option<ArcSegmentLengths>,
    /// The largest step of the speeds of X, Y and Z at a junction, mm/s, which replaces the deviation (Marlin's classic jerk);
    /// `None` where the deviation counts. Motion from rest begins at rest.
    pub speed_steps_mm_s: Option<[f64; 3]>,
    /// Steps per mm of X, Y and Z, to which the ends of segments are rounded (GRBL `$100` to `$102`); 0: not rounded.
    pub steps_per_mm: [f64; 3],
    /// The acceleration of a segment is constant, but only the average of a profile with the jerk of the axes
    /// (an option of grblHAL).
    pub limited_jerk: bool,
}

/// How an arc is divided by the length of its segments.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ArcSegmentLengths {
    /// The shortest segment, mm.
    pub least_mm: f64,
    /// The longest segment, mm.
    pub most_mm: f64,
    /// The smallest number of segments of a full circle, unless they would become shorter than the shortest.
    pub of_circle: f64,
}

impl ArcSegmentLengths {
    /// The number of segments of an arc with this length in its plane, mm, and this angle, rad. The last one may be shorter
    /// on the control; here all have the same length.
    fn count(&self, length: f64, angle: f64) -> f64 {
        let fewest = (self.of_circle * angle / std::f64::consts::TAU - 1e-9).ceil().max(1.0);
        let nominal = (length / self.most_mm + 1e-9).floor().max(fewest);
        let each = (length / nominal).clamp(self.least_mm, self.most_mm);
        (length / each - 1e-4).ceil().max(1.0)
    }
}

/// A junction is a reversal if the cosine of its angle is less, and straight if it is more.
const REVERSAL_COSINE: f64 = -0.999_999;
const STRAIGHT_COSINE: f64 = 0.999_999;
/// The smallest speed, mm/s: 1 mm/min.
const MIN_SPEED_MM_S: f64 = 1.0 / 60.0;
/// A trajectory with this many pieces ends at the next point of constant speed.
const MAX_TRAJECTORY_PIECES: usize = 8192;
/// The largest number of segments of one move.
const MAX_SEGMENTS_PER_MOVE: f64 = 1e7;

/// A straight segment in the queue.
#[derive(Clone, Copy, Debug)]
struct JunctionSegment {
    from: AxisValues,
    /// The derivatives of the axes by σ.
    direction: AxisValues,
    length: f64,
    /// The largest acceleration that all axes allow, σ per s².
    acceleration: f64,
    speed: f64,
    /// The square of the largest speed at its start, from the junction and the speeds of both segments.
    entry: f64,
    tag: u64,
}

/// The planner of small controls.
#[derive(Debug)]
pub(crate) struct JunctionPlanner<P> {
    rule: JunctionRule,
    waiting: VecDeque<JunctionSegment>,
    /// The segment before the next one; `None` where the axes rest between the two.
    last: Option<JunctionSegment>,
    /// The speed at the start of the first segment in the queue.
    speed: f64,
    trajectory: PlannedTrajectory<P>,
    /// σ at the end of the trajectory.
    end: f64,
}

impl<P: PathPart> JunctionPlanner<P> {
    pub fn new(rule: JunctionRule) -> JunctionPlanner<P> {
        JunctionPlanner {
            rule,
            waiting: VecDeque::new(),
            last: None,
            speed: 0.0,
            trajectory: PlannedTrajectory::default(),
            end: 0.0,
        }
    }

    /// Takes a checked move, and emits the segments that later moves cannot change.
    pub fn push(
        &mut self,
        motion: &MoveRequest,
        limits: &KinematicLimits,
        take: &mut impl FnMut(PlannerStep<'_, P>),
    ) {
        let count = self.segments_of(motion);
        let length = motion.length() / count;
        let mut from = motion.from();
        let mut number = 1.0;
        while number <= count {
            let to = if number < count { motion.at(number / count) } else { motion.to() };
            self.add(from, to, length, motion, limits);
            while self.waiting.len() >= self.rule.blocks.max(1) {
                self.run_first(take);
            }
            from = to;
            number += 1.0;
        }
        if motion.corner == CornerMode::Stop {
            self.rest(take);
        }
    }

    /// Emits all segments in the queue, which end at rest.
    pub fn rest(&mut self, take: &mut impl FnMut(PlannerStep<'_, P>)) {
        while !self.waiting.is_empty() {
            self.run_first(take);
        }
        self.emit(take);
        (self.last, self.speed) = (None, 0.0);
    }

    /// The number of segments of a move; their ends are on the curve.
    fn segments_of(&self, motion: &MoveRequest) -> f64 {
        if let (Some(lengths), Curve::Arc(arc)) = (self.rule.arc_segments, &motion.curve) {
            let angle = arc.sweep.abs();
            return lengths.count(arc.radius * angle, angle).min(MAX_SEGMENTS_PER_MOVE);
        }
        let chords = motion.curve.chord_count(self.rule.arc_tolerance_mm, Placement::RoundedDown);
        chords.map_or(1.0, |count| (count as f64).min(MAX_SEGMENTS_PER_MOVE))
    }

    fn add(
        &mut self,
        from: AxisValues,
        to: AxisValues,
        length: f64,
        motion: &MoveRequest,
        limits: &KinematicLimits,
    ) {
        let [from, to] = [from, to].map(|place| self.on_steps(place));
        let away: AxisValues = std::array::from_fn(|axis| to[axis] - from[axis]);
        let linear = chord(&away[..3]);
        let length = if linear > 0.0 { linear } else { chord(&away[3..]).min(length) };
        // A distance of less than a step is no motion.
        if length <= 0.0 {
            return;
        }
        let direction = away.map(|away| away / length);
        let speed = motion.speed.min(least(&limits.velocity(), &direction)).max(MIN_SPEED_MM_S);
        let acceleration = self.acceleration(&direction, speed, limits);
        let mut next = JunctionSegment {
            from,
            direction,
            length,
            acceleration,
            speed,
            entry: 0.0,
            tag: motion.tag,
        };
        if let Some(last) = &self.last {
            next.entry = self.junction(last, &next, limits);
        }
        self.last = Some(next);
        self.waiting.push_back(next);
    }

    /// The constant acceleration of a segment. With limited jerk it is its speed over the time in which a profile with
    /// that jerk reaches this speed from rest.
    fn acceleration(&self, direction: &AxisValues, speed: f64, limits: &KinematicLimits) -> f64 {
        let most = least(&limits.acceleration(), direction);
        if !self.rule.limited_jerk {
            return most;
        }
        let jerk = least(&limits.jerk(), direction);
        let rise = most / jerk;
        let gained = 0.5 * jerk * rise * rise;
        let half = 0.5 * speed;
        let time = if half > gained {
            2.0 * (rise + (half - gained) / most)
        } else {
            2.0 * (speed / jerk).sqrt()
        };
        speed / time
    }

    /// The nearest position that is a whole number of steps.
    fn on_steps(&self, mut place: AxisValues) -> AxisValues {
        for (value, steps) in place.iter_mut().zip(self.rule.steps_per_mm) {
            if steps > 0.0 {
                *value = (*value * steps).round() / steps;
            }
        }
        place
    }

    /// The square of the speed at the junction of two segments.
    fn junction(
        &self,
        before: &JunctionSegment,
        after: &JunctionSegment,
        limits: &KinematicLimits,
    ) -> f64 {
        let speed = before.speed.min(after.speed);
        if let Some(steps) = self.rule.speed_steps_mm_s {
            let change = |axis: usize| (after.direction[axis] - before.direction[axis]).abs();
            let allowed = |axis: usize| match change(axis) {
                change if change > 0.0 => steps[axis] / change,
                _ => f64::INFINITY,
            };
            let largest = (0..3).map(allowed).fold(speed, f64::min);
            return largest * largest;
        }
        let cosine: f64 = (0..AXES).map(|k| before.direction[k] * after.direction[k]).sum();
        if cosine > STRAIGHT_COSINE {
            return speed * speed;
        }
        if cosine < REVERSAL_COSINE {
            return 0.0;
        }
        // Half of the angle between the two, and the direction of the acceleration at the junction.
        let sine = ((1.0 + cosine) / 2.0).sqrt();
        let turn: AxisValues = std::array::from_fn(|k| after.direction[k] - before.direction[k]);
        let size = chord(&turn);
        let acceleration = least(&limits.acceleration(), &turn.map(|turn| turn / size));
        (acceleration * self.rule.deviation_mm * sine / (1.0 - sine)).min(speed * speed)
    }

    /// Emits the first segment. Its end speed is one from which the axes can stop by the end of the last known segment.
    fn run_first(&mut self, take: &mut impl FnMut(PlannerStep<'_, P>)) {
        let Some(first) = self.waiting.pop_front() else { return };
        let mut exit = 0.0;
        for segment in self.waiting.iter().rev() {
            exit = segment.entry.min(exit + 2.0 * segment.acceleration * segment.length);
        }
        let entry = self.speed * self.speed;
        let exit = exit.min(entry + 2.0 * first.acceleration * first.length);
        self.phases(&first, exit.sqrt());
        let mut start = [[0.0; AXES]; 4];
        (start[0], start[1]) = (first.from, first.direction);
        let piece = PathPiece { length: first.length, base: None, start, tag: first.tag };
        self.trajectory.pieces.push(P::of(&piece));
        self.speed = exit.sqrt();
        let is_even = self.trajectory.phases.last().is_some_and(|phase| phase.acceleration == 0.0);
        if self.trajectory.pieces.len() >= MAX_TRAJECTORY_PIECES && is_even {
            self.emit(take);
        }
    }

    /// The phases of a segment: acceleration, constant speed and deceleration, each as far as there is room.
    fn phases(&mut self, segment: &JunctionSegment, exit: f64) {
        let JunctionSegment { length, acceleration, speed, .. } = *segment;
        let entry = self.speed;
        let top_square = (entry * entry + exit * exit) / 2.0 + acceleration * length;
        let top = top_square.sqrt().min(speed).max(entry.max(exit));
        let ramp = |from: f64, to: f64| (from * from - to * to).abs() / (2.0 * acceleration);
        let even = (length - ramp(entry, top) - ramp(top, exit)).max(0.0);
        self.phase((top - entry) / acceleration, entry, acceleration);
        self.phase(if top > 0.0 { even / top } else { 0.0 }, top, 0.0);
        self.phase((top - exit) / acceleration, top, -acceleration);
    }

    fn phase(&mut self, duration_s: f64, speed: f64, acceleration: f64) {
        if duration_s > 0.0 {
            let phase = JerkPhase { duration_s, from: self.end, speed, acceleration, jerk: 0.0 };
            self.end += duration_s * (speed + duration_s * acceleration / 2.0);
            self.trajectory.phases.push(phase);
        }
    }

    fn emit(&mut self, take: &mut impl FnMut(PlannerStep<'_, P>)) {
        if !self.trajectory.pieces.is_empty() {
            take(PlannerStep::Trajectory(&self.trajectory));
        }
        self.trajectory.pieces.clear();
        self.trajectory.phases.clear();
        self.end = 0.0;
    }
}

fn chord(away: &[f64]) -> f64 {
    away.iter().map(|away| away * away).sum::<f64>().sqrt()
}

/// The limit along a direction that keeps the limits of all axes.
fn least(limits: &AxisValues, direction: &AxisValues) -> f64 {
    let moving = limits.iter().zip(direction).filter(|(_, share)| **share != 0.0);
    moving.fold(f64::INFINITY, |least, (limit, share)| least.min(limit / share.abs()))
}

#[cfg(test)]
mod tests {
    use std::f64::consts::{PI, TAU};

    use chordal_geometry::{Arc, Plane};

    use super::*;
    use crate::move_request::MoveKind;

    #[test]
    fn segments_of_an_arc_are_those_of_the_firmware() {
        let rule = JunctionRule {
            deviation_mm: 0.01,
            blocks: 15,
            arc_tolerance_mm: 0.002,
            arc_segments: None,
            speed_steps_mm_s: None,
            steps_per_mm: [0.0; 3],
            limited_jerk: false,
        };
        let planner: JunctionPlanner<PathPiece> = JunctionPlanner::new(rule);
        // Radius 1, half and full turn, radius 10 and half of 1,000.
        for (radius, angle, count) in [(1.0, PI, 24.0), (1.0, TAU, 49.0), (1000.0, PI, 785.0)] {
            let arc = MoveRequest {
                curve: Arc::new(Plane::Xy.frame(), radius, angle, 0.0).into(),
                rotary_from: [0.0; 3],
                rotary_to: [0.0; 3],
                path_length: None,
                speed: 100.0,
                corner: CornerMode::Stop,
                kind: MoveKind::Cut,
                tag: 1,
            };
            assert_eq!(planner.segments_of(&arc), count);
        }
    }
}
