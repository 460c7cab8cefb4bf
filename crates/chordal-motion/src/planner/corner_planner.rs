//! Plans every corner by itself: blends them, looks ahead, and finds the feedrate profile of ramps.

use chordal_geometry::AXES;

use crate::AxisValues;
use crate::corner_blend::path_span::{PathPart, sealed::PathStorage};
use crate::corner_blend::{
    CornerBlender, JointKind, JointPassing, LookAheadQueue, OverlapLimits, PathLeg, RestEnd,
    overlap_of,
};
use crate::limits::KinematicLimits;
use crate::move_request::MoveRequest;
use crate::path_limits::AxisArrays;
use crate::planner::PlannerLevel;
use crate::profile_solver::solve_profile;
use crate::ramp_profile::{LimitInterval, RampSolver};
use crate::time_bound::PathRun;
use crate::trajectory::{JerkPhase, PlannedTrajectory, PlannerStep};
use crate::tuning::TUNING;

/// Plans moves corner by corner, each run from rest to rest. Its memory is kept from one run to the next.
#[derive(Debug)]
pub(crate) struct CornerPlanner<P> {
    limits: KinematicLimits,
    arrays: AxisArrays,
    level: PlannerLevel,
    /// The length of a look-ahead window, s.
    look_ahead_s: f64,
    /// A window is planned when it is so many times as long as usual: a power of two.
    lookahead_factor: usize,
    blender: CornerBlender,
    queue: LookAheadQueue<P>,
    solver: RampSolver,
    trajectory: PlannedTrajectory<P>,
    /// The speed at which the queue begins, σ per s.
    speed: f64,
    /// The corner at which the run begins, and how the movement before it ends.
    overlap: Option<OverlapLimits>,
    /// The same for the corner at which the run ends, where that is known.
    next_overlap: Option<OverlapLimits>,
    last: Option<RestEnd>,
}

impl<P: PathPart> CornerPlanner<P> {
    /// A planner for a machine at rest.
    pub fn new(limits: KinematicLimits, level: PlannerLevel, look_ahead_s: f64) -> Self {
        CornerPlanner {
            arrays: AxisArrays::new(&limits),
            limits,
            level,
            look_ahead_s,
            lookahead_factor: 1,
            blender: CornerBlender::default(),
            queue: LookAheadQueue::new(level == PlannerLevel::Best),
            solver: RampSolver::default(),
            trajectory: PlannedTrajectory::default(),
            speed: 0.0,
            overlap: None,
            next_overlap: None,
            last: None,
        }
    }

    /// What the axes can do.
    pub fn limits(&self) -> &KinematicLimits {
        &self.limits
    }

    /// Takes a checked move that begins at `start`, and emits the steps that are certain now.
    pub fn push(
        &mut self,
        motion: &MoveRequest,
        start: &AxisValues,
        take: &mut impl FnMut(PlannerStep<'_, P>),
    ) {
        let leg = PathLeg::new(motion, start, &self.arrays);
        let joint = self.blender.joint(&leg, &self.arrays);
        if self.blender.lengthens(&leg, joint) {
            if self.blender.lengthen(leg, motion.corner) {
                self.release(take);
            }
            return;
        }
        self.release(take);
        let passing = match joint {
            Some(JointKind::Slow(slow)) => {
                if self.blender.defer(leg, motion.corner, slow) {
                    self.release(take);
                }
                return;
            }
            Some(JointKind::Ease(step)) => Some(JointPassing::Ease(step, 0.0)),
            Some(JointKind::Smooth) => Some(JointPassing::Smooth),
            Some(JointKind::Stop) => {
                self.rest(None, take);
                None
            }
            None => None,
        };
        self.blender.push(leg, motion.corner, passing);
        self.advance(take);
    }

    /// Takes moves that follow each other, and emits the steps that are certain now.
    pub fn push_all(&mut self, moves: &[MoveRequest], take: &mut impl FnMut(PlannerStep<'_, P>)) {
        let mut at = moves.first().map_or([0.0; AXES], MoveRequest::from);
        for motion in moves {
            self.push(motion, &at, take);
            at = motion.to();
        }
    }

    /// The axes come to rest: emits the steps that are left. No later run overlaps this one.
    pub fn finish(&mut self, take: &mut impl FnMut(PlannerStep<'_, P>)) {
        self.release(take);
        self.end_run(take);
        (self.overlap, self.last) = (None, None);
    }

    /// Plans checked moves from rest to rest.
    pub fn plan_run(&mut self, moves: &[MoveRequest], mut each: impl FnMut(&PlannedTrajectory<P>)) {
        let mut take = |step: PlannerStep<'_, P>| {
            if let PlannerStep::Trajectory(trajectory) = step {
                each(trajectory);
            }
        };
        self.push_all(moves, &mut take);
        self.finish(&mut take);
    }

    /// The same between two corners at which other movements, which are planned elsewhere, overlap these.
    pub fn plan_run_between(
        &mut self,
        moves: &[MoveRequest],
        [begins, ends]: [Option<OverlapLimits>; 2],
        mut each: impl FnMut(&PlannedTrajectory<P>),
    ) {
        let mut take = |step: PlannerStep<'_, P>| {
            if let PlannerStep::Trajectory(trajectory) = step {
                each(trajectory);
            }
        };
        let Some((first, others)) = moves.split_first() else { return };
        self.push(first, &first.from(), &mut take);
        if let Some(overlap) = &begins {
            self.blender.begin_with(overlap);
        }
        let mut at = first.to();
        for motion in others {
            self.push(motion, &at, &mut take);
            at = motion.to();
        }
        self.release(&mut take);
        self.rest(ends, &mut take);
        self.finish(&mut take);
    }

    /// Goes on with a leg whose length has become known.
    fn release(&mut self, take: &mut impl FnMut(PlannerStep<'_, P>)) {
        let Some(released) = self.blender.release(&self.arrays) else { return };
        let passing = match released.passing {
            JointPassing::Rest(overlap) => {
                self.rest(overlap, take);
                None
            }
            passing => Some(passing),
        };
        self.blender.push_released(released, passing);
        if let (Some(overlap), None) = (&self.overlap, passing) {
            self.blender.begin_with(overlap);
        }
        self.advance(take);
    }

    /// The axes come to rest where the last leg ends.
    fn rest(&mut self, overlap: Option<OverlapLimits>, take: &mut impl FnMut(PlannerStep<'_, P>)) {
        if let Some(overlap) = &overlap {
            self.blender.end_with(overlap);
        }
        self.next_overlap = overlap;
        self.end_run(take);
        self.next_overlap = None;
        self.overlap = overlap;
    }

    /// Emits what is certain, if it is much.
    fn advance(&mut self, take: &mut impl FnMut(PlannerStep<'_, P>)) {
        self.blender.drain(false, &self.arrays, &mut self.queue);
        let long = self.queue.time_s >= self.look_ahead_s * self.lookahead_factor as f64;
        // The best profile is found from rest to rest.
        let long = long && self.level == PlannerLevel::Fast;
        if long || self.queue.pieces.len() >= TUNING.window_pieces * self.lookahead_factor {
            self.emit_certain(take);
        }
    }

    /// The axes come to rest at the end of what was pushed.
    fn end_run(&mut self, take: &mut impl FnMut(PlannerStep<'_, P>)) {
        if self.blender.is_empty() && self.queue.intervals.is_empty() {
            return;
        }
        self.blender.drain(true, &self.arrays, &mut self.queue);
        let count = self.queue.intervals.len();
        self.solver.solve(&self.queue.intervals, self.speed, 0.0);
        self.emit(count, take);
        self.speed = 0.0;
        self.lookahead_factor = 1;
    }

    /// Emits as much of a long window as later moves cannot change.
    fn emit_certain(&mut self, take: &mut impl FnMut(PlannerStep<'_, P>)) {
        self.solver.solve(&self.queue.intervals, self.speed, 0.0);
        match self.solver.last_certain() {
            Some(speed_node) if speed_node.node > 0 => {
                self.emit(speed_node.node, take);
                self.speed = speed_node.speed;
                self.lookahead_factor = 1;
            }
            // The stop at the end reaches back to the start: more has to be known.
            _ => self.lookahead_factor *= 2,
        }
    }

    /// Emits the intervals before a boundary, which is a node of known speed, from rest to rest where the
    /// axes rest before.
    fn emit(&mut self, node: usize, take: &mut impl FnMut(PlannerStep<'_, P>)) {
        let mut begin = 0;
        while begin < node {
            let rest =
                self.queue.intervals[begin..node].iter().position(|interval| interval.ends_at_rest);
            let end = rest.map_or(node, |index| begin + index + 1);
            self.emit_between(begin, end, take);
            begin = end;
        }
        self.queue.intervals.drain(..node);
        self.queue.time_s =
            self.queue.intervals.iter().map(|interval| interval.length / interval.speed).sum();
    }

    /// Emits the intervals between two boundaries.
    fn emit_between(
        &mut self,
        begin: usize,
        end: usize,
        take: &mut impl FnMut(PlannerStep<'_, P>),
    ) {
        let trajectory = &mut self.trajectory;
        trajectory.phases.clear();
        trajectory.pieces.clear();
        let first = self.solver.phases(&self.queue.intervals, begin, end, &mut trajectory.phases);
        let from = first.map_or(0.0, |speed_node| speed_node.at);
        if from > 0.0 {
            trajectory.phases.iter_mut().for_each(|phase| phase.from -= from);
        }
        let pieces = pieces_of(&self.queue.intervals[begin..end]);
        if pieces == self.queue.pieces.len() {
            std::mem::swap(&mut trajectory.pieces, &mut self.queue.pieces);
        } else {
            trajectory.pieces.extend(self.queue.pieces.drain(..pieces));
        }
        let from_rest = first.is_none_or(|speed_node| speed_node.speed <= 0.0);
        if self.level == PlannerLevel::Best && from_rest {
            let shares = [self.overlap, self.next_overlap].map(|o| o.map_or(1.0, |o| o.jerk_share));
            improve(trajectory, &self.queue.speeds[..pieces], &self.limits, shares);
        }
        if self.queue.keeps_speeds {
            self.queue.speeds.drain(..pieces);
        }
        let (phases, pieces) = (&trajectory.phases, &trajectory.pieces);
        let (first, last) = (RestEnd::first(phases, pieces), RestEnd::last(phases, pieces));
        trajectory.overlap_s = match (self.overlap.take(), self.last, first) {
            (Some(overlap), Some(last), Some(first)) => overlap_of(&overlap, &last, &first),
            _ => 0.0,
        };
        self.last = last;
        take(PlannerStep::Trajectory(trajectory));
    }
}

fn pieces_of(intervals: &[LimitInterval]) -> usize {
    intervals.iter().map(|interval| interval.pieces as usize).sum()
}

/// Replaces the profile of a trajectory from rest to rest by a quicker one, where there is one. The speeds are the
/// largest programmed ones on its pieces; the shares those of the jerk at both its ends.
fn improve(
    trajectory: &mut PlannedTrajectory<impl PathPart>,
    speeds: &[f64],
    limits: &KinematicLimits,
    shares: [f64; 2],
) {
    let limits = limits.with_jerk(shares[0].min(shares[1]));
    let Some(path) = PathStorage::path(&trajectory.pieces) else { return };
    let Ok(run) = PathRun::new(path, speeds, 0.0, &limits) else { return };
    let Some(phases) = solve_profile(&run, TUNING.profile_gaps[1]).0 else { return };
    let time_s = |phases: &[JerkPhase]| phases.iter().map(|phase| phase.duration_s).sum::<f64>();
    if time_s(&phases) < time_s(&trajectory.phases) {
        trajectory.phases = phases;
    }
}
