//! Gathers moves up to their next rest, and plans them as smooth curves or corner by corner, whichever is
//! quicker.

use chordal_geometry::{AXES, Curve};

use super::PlannerLevel;
use super::corner_planner::CornerPlanner;
use crate::AxisValues;
use crate::corner_blend::OverlapLimits;
use crate::corner_blend::path_span::{PathPart, PathSpan};
use crate::cube_root::cbrt;
use crate::curve_planner::{ChainLink, CornerStrategy, CurvePlanner};
use crate::limits::KinematicLimits;
use crate::move_request::{CornerMode, MoveRequest};
use crate::piece::PathPiece;
use crate::profile_solver::SolverWork;
use crate::trajectory::{PlannedTrajectory, PlannerStep};
use crate::tuning::TUNING;

/// Plans groups of moves.
#[derive(Debug)]
pub(crate) struct CurveStrategy<P> {
    level: PlannerLevel,
    /// The length of a look-ahead window, s.
    look_ahead_s: f64,
    group: MoveGroup,
    /// Until the next rest moves are planned as they come: one keeps its exact path, or there are
    /// too many or they are too long.
    passes_on: bool,
    curves: CurvePlanner,
    /// Plans what is no curve.
    corners: CornerPlanner<P>,
    /// Only for the time that a group takes corner by corner.
    comparison: CornerPlanner<PathSpan>,
}

/// Moves from a rest on, whose plan waits for the next rest.
#[derive(Debug, Default)]
struct MoveGroup {
    moves: Vec<MoveRequest>,
    /// Their time at their feeds, s.
    feed_s: f64,
}

impl<P: PathPart> CurveStrategy<P> {
    /// A strategy for a machine at rest.
    pub fn new(limits: KinematicLimits, level: PlannerLevel, look_ahead_s: f64) -> Self {
        CurveStrategy {
            level,
            look_ahead_s,
            group: MoveGroup::default(),
            passes_on: false,
            curves: CurvePlanner::default(),
            corners: CornerPlanner::new(limits, level, look_ahead_s),
            comparison: CornerPlanner::new(limits, PlannerLevel::Fast, f64::INFINITY),
        }
    }

    /// Keeps a checked move for its group, or plans a move that is of none, which begins at `start`.
    pub fn push(
        &mut self,
        motion: &MoveRequest,
        start: &AxisValues,
        take: &mut impl FnMut(PlannerStep<'_, P>),
    ) {
        let rests = motion.corner == CornerMode::Stop;
        let fits = matches!(motion.corner, CornerMode::Stop | CornerMode::Joined { .. });
        if self.passes_on || !fits {
            self.passes_on = !rests;
            self.plan_corners(take);
            return self.corners.push(motion, start, take);
        }
        self.group.push(motion);
        if rests {
            self.plan_group(take);
        } else if self.group.is_long(self.look_ahead_s) && !self.group.is_dense() {
            self.passes_on = true;
            self.plan_corners(take);
        } else if self.group.moves.len() >= TUNING.max_group_moves {
            self.plan_to_last_corner(take);
        }
    }

    /// The axes come to rest after all moves, whatever the corner of the last one says.
    pub fn finish(&mut self, take: &mut impl FnMut(PlannerStep<'_, P>)) {
        self.passes_on = false;
        if let Some(last) = self.group.moves.last_mut() {
            last.corner = CornerMode::Stop;
            self.plan_group(take);
        }
        self.corners.finish(take);
    }

    /// What the profiles of curves took so far.
    pub fn work(&self) -> SolverWork {
        self.curves.work()
    }

    /// Plans the group up to its last corner, or to its sharpest joint; where it has too many
    /// chords all of it, and what comes until the next rest, corner by corner.
    fn plan_to_last_corner(&mut self, take: &mut impl FnMut(PlannerStep<'_, P>)) {
        let Some(corner) = self.curves.last_corner(&self.group.moves) else {
            self.passes_on = true;
            return self.plan_corners(take);
        };
        let after = self.group.moves.split_off(corner);
        self.curves.keep(corner);
        self.group.feed_s -= after.iter().map(MoveRequest::at_speed_s).sum::<f64>();
        self.plan_group(take);
        after.iter().for_each(|motion| self.group.push(motion));
    }

    /// Plans the group, which ends at rest, as smooth curves or corner by corner, whichever is
    /// quicker.
    fn plan_group(&mut self, take: &mut impl FnMut(PlannerStep<'_, P>)) {
        if self.group.is_dense()
            && let Some(trajectories) = self.quicker_curves()
        {
            // What was planned before has ended at rest.
            self.corners.finish(take);
            trajectories.iter().for_each(|trajectory| take(PlannerStep::Trajectory(trajectory)));
            self.clear();
        }
        self.plan_corners(take);
    }

    /// Plans the group corner by corner.
    fn plan_corners(&mut self, take: &mut impl FnMut(PlannerStep<'_, P>)) {
        self.corners.push_all(&self.group.moves, take);
        self.clear();
    }

    fn clear(&mut self) {
        self.group.clear();
        self.curves.forget();
    }

    /// The group as smooth curves from corner to corner, if corners by themselves are not quicker.
    fn quicker_curves(&mut self) -> Option<Vec<PlannedTrajectory<P>>> {
        let CurveStrategy { group, curves, comparison, .. } = self;
        let moves = &group.moves;
        let limits = *comparison.limits();
        let gap = TUNING.profile_gaps[usize::from(self.level == PlannerLevel::Best)];
        let mut corners: CornerPlanner<PathPiece> =
            CornerPlanner::new(limits, PlannerLevel::Fast, f64::INFINITY);
        let (links, least_s) = curves.plan(moves, &limits, gap, &mut corners);
        let time_s = links.iter().map(ChainLink::time_s).sum::<f64>();
        let is_quick = corners.is_quick(moves, time_s, least_s) || {
            let mut corners_s = 0.0;
            comparison.plan_run(moves, |one| corners_s += one.duration_s() - one.overlap_s);
            time_s < corners_s
        };
        is_quick.then(|| links.into_iter().map(ChainLink::into_trajectory).collect())
    }
}

impl MoveGroup {
    fn push(&mut self, motion: &MoveRequest) {
        self.feed_s += motion.at_speed_s();
        self.moves.push(*motion);
    }

    fn clear(&mut self) {
        self.moves.clear();
        self.feed_s = 0.0;
    }

    /// Whether its moves are many and short for their feeds.
    fn is_dense(&self) -> bool {
        let count = self.moves.len();
        count >= TUNING.min_group_moves && self.feed_s < TUNING.dense_move_s * count as f64
    }

    /// Whether enough of it is known to see that the rest of it is not dense either, or a servo loop waits.
    fn is_long(&self, look_ahead_s: f64) -> bool {
        let count = self.moves.len();
        count >= TUNING.min_group_moves
            && (self.feed_s >= look_ahead_s || count == TUNING.sampled_group_moves)
    }
}

impl CornerStrategy for CornerPlanner<PathPiece> {
    fn plan(
        &mut self,
        moves: &[MoveRequest],
        overlaps: [Option<OverlapLimits>; 2],
        out: &mut Vec<PlannedTrajectory>,
    ) {
        self.plan_run_between(moves, overlaps, |one| out.push(one.clone()));
    }

    fn is_quick(&self, moves: &[MoveRequest], time_s: f64, least_s: f64) -> bool {
        time_s < TUNING.curve_always_faster_below * least_s
            && are_slower_with_stops(moves, time_s, self.limits())
    }
}

/// Whether moves take longer than a time, s, with a stop at the end of each: by feed, acceleration or jerk
/// alone.
fn are_slower_with_stops(moves: &[MoveRequest], than_s: f64, limits: &KinematicLimits) -> bool {
    let (acceleration, jerk) = (limits.acceleration(), limits.jerk());
    let one = |motion: &MoveRequest| {
        let (from, to) = (motion.from(), motion.to());
        let mut least = motion.at_speed_s();
        for axis in 0..AXES {
            let distance = (to[axis] - from[axis]).abs();
            if distance > 0.0 && matches!(motion.curve, Curve::Line(_)) {
                let by_acceleration = 2.0 * (distance / acceleration[axis]).sqrt();
                least = least.max(by_acceleration).max(cbrt(32.0 * distance / jerk[axis]));
            }
        }
        least
    };
    // Short moves take so much longer with stops that few of them are enough.
    let mut least_s = 0.0;
    moves.iter().any(|motion| {
        least_s += one(motion);
        least_s > than_s
    })
}
