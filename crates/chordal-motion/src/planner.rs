//! The planner: takes moves, emits steps; its levels and options.

use chordal_geometry::{AXES, Curve};

use crate::AxisValues;
use crate::corner_blend::path_span::{PathPart, PathSpan, sealed::PathStorage};
use crate::corner_blend::{
    CornerBlender, JointKind, JointPassing, LookAheadQueue, OverlapLimits, PathLeg, RestEnd,
    overlap_of,
};
use crate::cube_root::cbrt;
use crate::curve_planner::{ChainLink, CornerStrategy, CurvePlanner};
use crate::junction_planner::{JunctionPlanner, JunctionRule};
use crate::limits::KinematicLimits;
use crate::move_request::{CornerMode, MoveError, MoveRequest};
use crate::path_limits::AxisArrays;
use crate::piece::PathPiece;
use crate::profile_solver::{SolverWork, solve_profile};
use crate::ramp_profile::{LimitInterval, RampSolver};
use crate::time_bound::PathRun;
use crate::trajectory::{JerkPhase, PlannedTrajectory, PlannerStep};

/// How hard a planner tries.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PlannerLevel {
    /// In one pass, for programs of any length.
    Fast,
    /// By optimization, for measuring how far the fast level is from the limit, and for short
    /// jobs that run often.
    Best,
}

/// The options of a planner.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlannerOptions {
    /// How hard it tries.
    pub level: PlannerLevel,
    /// Moves are looked at together when they would take so long at their largest speeds, s.
    /// What is certain of them is emitted, so that a servo loop is fed early. Infinite: as
    /// many as memory allows.
    pub row_s: f64,
    /// Dense moves from rest to rest are planned as smooth curves, where that is quicker: at most 50,000
    /// moves wait for their rest. Otherwise every corner is passed by itself.
    pub joins: bool,
    /// Trapezoids with junction deviation instead of limited jerk, where the control moves like that.
    pub junctions: Option<JunctionRule>,
}

impl PlannerOptions {
    /// A planner that takes its time.
    pub fn new(level: PlannerLevel) -> PlannerOptions {
        PlannerOptions { level, row_s: f64::INFINITY, joins: true, junctions: None }
    }
}

/// So many pieces are looked at together. A row ends earlier where the axes stop; a longer one
/// is emitted as far as later moves cannot change it.
const ROW: usize = 8192;

/// Shorter moves are left out, mm or rad: their direction would be rounding.
const SHORTEST: f64 = 1e-9;

/// A gap between moves that is closed without a word, mm or rad.
const GAP: f64 = 1e-6;

/// Turns moves into steps: holds every limit, keeps the path, loses little time.
///
/// `P` is what its stretches say about the path: all of it ([`MotionPlanner::new`]) or only what times need
/// ([`MotionPlanner::of_times`]).
#[derive(Debug)]
pub struct MotionPlanner<P = PathPiece> {
    limits: KinematicLimits,
    arrays: AxisArrays,
    smoother: CornerBlender,
    row: LookAheadQueue<P>,
    solver: RampSolver,
    trajectory: PlannedTrajectory<P>,
    /// Speed at the start of the row.
    speed: f64,
    options: PlannerOptions,
    /// Rows are looked at when they are so many times as long as usual: a power of two.
    lookahead_factor: usize,
    /// Where the axes will be after all moves.
    position: Option<AxisValues>,
    /// The corner at which the run begins, and how the movement before it ends.
    overlap: Option<OverlapLimits>,
    /// The same for the corner at which the run ends, where that is known.
    next_overlap: Option<OverlapLimits>,
    last: Option<RestEnd>,
    /// Moves that wait for their end at rest, where whole rows are planned.
    group: Option<Box<MoveGroup>>,
    /// Plans all moves, where the control has that law.
    junctions: Option<Box<JunctionPlanner<P>>>,
}

/// Moves from rest on.
#[derive(Debug)]
struct MoveGroup {
    moves: Vec<MoveRequest>,
    /// The time that they ask for by their feeds, s.
    feed_s: f64,
    /// Until the next rest moves are planned as they come: one keeps its exact path, or there are
    /// too many or they are too long.
    passes: bool,
    dense: CurvePlanner,
    /// Another planner, for the time that corners by themselves take.
    other: MotionPlanner<PathSpan>,
}

/// A group of fewer moves is planned corner by corner.
const FEW: usize = 8;
/// When so many moves wait and are not dense, the rest of the group will not be either.
const ENOUGH: usize = 4096;
/// When so many moves wait, those before the last corner are planned.
const MANY: usize = 50_000;
/// Moves that take longer on average at their feeds are not dense: their corners are best passed each by
/// itself.
const DENSE_S: f64 = 0.04;
/// Curves that take no more times as long as without jerk, and less than stops, are quicker than corners
/// by themselves, or as quick within half a percent.
const NEAR: f64 = 1.5;

/// How near the least time a law is, by level.
const GAPS: [f64; 2] = [2e-4, 5e-5];

impl MotionPlanner {
    /// A planner for a machine at rest.
    pub fn new(limits: KinematicLimits, options: PlannerOptions) -> MotionPlanner {
        MotionPlanner::whole(limits, options)
    }
}

impl MotionPlanner<PathSpan> {
    /// A planner that works out the times of level fast and keeps no path.
    pub fn of_times(limits: KinematicLimits) -> MotionPlanner<PathSpan> {
        MotionPlanner::of_times_by(limits, None)
    }

    /// The same, by trapezoids with junction deviation where there is such a law.
    pub fn of_times_by(
        limits: KinematicLimits,
        junctions: Option<JunctionRule>,
    ) -> MotionPlanner<PathSpan> {
        MotionPlanner::whole(
            limits,
            PlannerOptions { junctions, ..PlannerOptions::new(PlannerLevel::Fast) },
        )
    }
}

impl<P: PathPart> MotionPlanner<P> {
    /// A planner that looks at whole groups of moves, where it may.
    fn whole(limits: KinematicLimits, options: PlannerOptions) -> MotionPlanner<P> {
        let group = (options.joins && options.junctions.is_none()).then(|| {
            let other = MotionPlanner::at_rest(limits, PlannerOptions::new(PlannerLevel::Fast));
            let (moves, dense) = (Vec::new(), CurvePlanner::default());
            Box::new(MoveGroup { moves, feed_s: 0.0, passes: false, dense, other })
        });
        MotionPlanner { group, ..MotionPlanner::at_rest(limits, options) }
    }

    fn at_rest(limits: KinematicLimits, options: PlannerOptions) -> MotionPlanner<P> {
        MotionPlanner {
            arrays: AxisArrays::new(&limits),
            limits,
            smoother: CornerBlender::default(),
            row: LookAheadQueue::new(options.level == PlannerLevel::Best),
            solver: RampSolver::default(),
            trajectory: PlannedTrajectory::default(),
            speed: 0.0,
            options,
            lookahead_factor: 1,
            position: None,
            overlap: None,
            next_overlap: None,
            last: None,
            group: None,
            junctions: options.junctions.map(|law| Box::new(JunctionPlanner::new(law))),
        }
    }

    /// Takes a move and emits the steps that are certain now.
    ///
    /// # Errors
    /// When the move cannot be planned; it is left out.
    pub fn push(
        &mut self,
        motion: &MoveRequest,
        mut take: impl FnMut(PlannerStep<'_, P>),
    ) -> Result<(), MoveError> {
        motion.check(&self.limits)?;
        let start = self.start_of(motion)?;
        if motion.length() < SHORTEST {
            // The next line begins where this one did, so nothing is lost.
            self.position = Some(start);
            return Ok(());
        }
        self.position = Some(motion.to());
        if let Some(junctions) = &mut self.junctions {
            junctions.push(motion, &self.limits, &mut take);
        } else if self.group.is_some() {
            self.gather(motion, &start, &mut take);
        } else {
            self.corner_by_corner(motion, &start, &mut take);
        }
        Ok(())
    }

    /// Keeps a move for its group, or plans a move that is of none.
    fn gather(
        &mut self,
        motion: &MoveRequest,
        start: &AxisValues,
        take: &mut impl FnMut(PlannerStep<'_, P>),
    ) {
        let Some(group) = &mut self.group else { return };
        let rests = motion.corner == CornerMode::Stop;
        let fits = matches!(motion.corner, CornerMode::Stop | CornerMode::Joined { .. });
        if group.passes || !fits {
            group.passes = !rests;
            self.plan_moves(take);
            return self.corner_by_corner(motion, start, take);
        }
        group.push(motion);
        if rests {
            self.plan_group(take);
        } else if group.is_long(self.options.row_s) && !group.is_dense() {
            group.passes = true;
            self.plan_moves(take);
        } else if group.moves.len() >= MANY {
            self.plan_to_last_corner(take);
        }
    }

    /// Plans the kept moves up to their last corner, or to their sharpest joint; where they have too many
    /// chords all of them, and what comes until the next rest, corner by corner.
    fn plan_to_last_corner(&mut self, take: &mut impl FnMut(PlannerStep<'_, P>)) {
        let Some(group) = &mut self.group else { return };
        let Some(corner) = group.dense.last_corner(&group.moves) else {
            group.passes = true;
            return self.plan_moves(take);
        };
        let after = group.moves.split_off(corner);
        group.dense.keep(corner);
        group.feed_s -= after.iter().map(MoveRequest::at_speed_s).sum::<f64>();
        self.plan_group(take);
        if let Some(group) = &mut self.group {
            after.iter().for_each(|motion| group.push(motion));
        }
    }

    /// Plans the kept moves corner by corner.
    fn plan_moves(&mut self, take: &mut impl FnMut(PlannerStep<'_, P>)) {
        let Some(group) = &mut self.group else { return };
        let moves = std::mem::take(&mut group.moves);
        let mut at = moves.first().map_or([0.0; AXES], MoveRequest::from);
        for motion in &moves {
            self.corner_by_corner(motion, &at, take);
            at = motion.to();
        }
        if let Some(group) = &mut self.group {
            group.moves = moves;
            group.clear();
        }
    }

    /// Plans the kept moves, which end at rest, as smooth curves or corner by corner, whichever is
    /// quicker.
    fn plan_group(&mut self, take: &mut impl FnMut(PlannerStep<'_, P>)) {
        let Some(mut group) = self.group.take() else { return };
        if group.is_dense() {
            let gap = GAPS[usize::from(self.options.level == PlannerLevel::Best)];
            if let Some(trajectories) = group.quicker_curves(&self.limits, gap) {
                // What was planned before has ended at rest.
                self.release(take);
                self.end_run(take);
                (self.overlap, self.last) = (None, None);
                trajectories
                    .iter()
                    .for_each(|trajectory| take(PlannerStep::Trajectory(trajectory)));
                group.clear();
            }
        }
        self.group = Some(group);
        self.plan_moves(take);
    }

    /// Takes a move and hands on the steps that are certain now.
    fn corner_by_corner(
        &mut self,
        motion: &MoveRequest,
        start: &AxisValues,
        take: &mut impl FnMut(PlannerStep<'_, P>),
    ) {
        let leg = PathLeg::new(motion, start, &self.arrays);
        let joint = self.smoother.joint(&leg, &self.arrays);
        if self.smoother.lengthens(&leg, joint) {
            if self.smoother.lengthen(leg, motion.corner) {
                self.release(take);
            }
            return;
        }
        self.release(take);
        let passing = match joint {
            Some(JointKind::Slow(slow)) => {
                if self.smoother.defer(leg, motion.corner, slow) {
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
        self.smoother.push(leg, motion.corner, passing);
        self.advance(take);
    }

    /// Goes on with a leg whose length has become known.
    fn release(&mut self, take: &mut impl FnMut(PlannerStep<'_, P>)) {
        let Some(released) = self.smoother.release(&self.arrays) else { return };
        let passing = match released.passing {
            JointPassing::Rest(overlap) => {
                self.rest(overlap, take);
                None
            }
            passing => Some(passing),
        };
        self.smoother.push_released(released, passing);
        if let (Some(overlap), None) = (&self.overlap, passing) {
            self.smoother.begin_with(overlap);
        }
        self.advance(take);
    }

    /// The axes come to rest where the last leg ends.
    fn rest(&mut self, overlap: Option<OverlapLimits>, take: &mut impl FnMut(PlannerStep<'_, P>)) {
        if let Some(overlap) = &overlap {
            self.smoother.end_with(overlap);
        }
        self.next_overlap = overlap;
        self.end_run(take);
        self.next_overlap = None;
        self.overlap = overlap;
    }

    /// Hands on what is certain, if it is much.
    fn advance(&mut self, take: &mut impl FnMut(PlannerStep<'_, P>)) {
        self.smoother.drain(false, &self.arrays, &mut self.row);
        let long = self.row.time_s >= self.options.row_s * self.lookahead_factor as f64;
        // The best law is found from rest to rest.
        let long = long && self.options.level == PlannerLevel::Fast;
        if long || self.row.pieces.len() >= ROW * self.lookahead_factor {
            self.hand_on(take);
        }
    }

    /// What the laws of dense moves took so far. Where windows have failed, other curves or corners were planned.
    pub fn work(&self) -> SolverWork {
        self.group.as_ref().map_or(SolverWork::default(), |group| group.dense.work())
    }

    /// The axes come to rest and stand for a time, s.
    pub fn wait(&mut self, seconds: f64, tag: u64, mut take: impl FnMut(PlannerStep<'_, P>)) {
        self.finish(&mut take);
        take(PlannerStep::Wait { seconds, tag });
    }

    /// The axes come to rest: emits the rest of the steps. The next move may begin anywhere.
    pub fn finish(&mut self, mut take: impl FnMut(PlannerStep<'_, P>)) {
        if let Some(junctions) = &mut self.junctions {
            junctions.rest(&mut take);
        }
        self.end_group(&mut take);
        self.release(&mut take);
        self.end_run(&mut take);
        self.position = None;
        self.overlap = None;
        self.last = None;
    }

    /// The axes come to rest after the kept moves, whatever their last corner says.
    fn end_group(&mut self, take: &mut impl FnMut(PlannerStep<'_, P>)) {
        let Some(group) = &mut self.group else { return };
        group.passes = false;
        if let Some(last) = group.moves.last_mut() {
            last.corner = CornerMode::Stop;
            self.plan_group(take);
        }
    }

    /// Plans moves that were found good when they came, from rest to rest.
    fn plan_all(&mut self, moves: &[MoveRequest], mut each: impl FnMut(&PlannedTrajectory<P>)) {
        let mut take = |step: PlannerStep<'_, P>| {
            if let PlannerStep::Trajectory(trajectory) = step {
                each(trajectory);
            }
        };
        for motion in moves {
            let _ = self.push(motion, &mut take);
        }
        self.finish(&mut take);
    }

    /// The same between two corners where movements that are planned elsewhere overlap theirs.
    fn plan_between(
        &mut self,
        moves: &[MoveRequest],
        overlaps: [Option<OverlapLimits>; 2],
        mut each: impl FnMut(&PlannedTrajectory<P>),
    ) {
        let mut take = |step: PlannerStep<'_, P>| {
            if let PlannerStep::Trajectory(trajectory) = step {
                each(trajectory);
            }
        };
        let [begins, ends] = overlaps;
        let mut begins = begins;
        for motion in moves {
            let _ = self.push(motion, &mut take);
            if let Some(overlap) = begins.take() {
                self.smoother.begin_with(&overlap);
            }
        }
        self.release(&mut take);
        self.rest(ends, &mut take);
        self.finish(take);
    }

    /// Where a move begins: where the one before it ended.
    fn start_of(&self, motion: &MoveRequest) -> Result<AxisValues, MoveError> {
        let from = motion.from();
        let Some(position) = self.position else { return Ok(from) };
        let gap = from.iter().zip(&position).fold(0.0_f64, |gap, (a, b)| gap.max((a - b).abs()));
        if gap > GAP { Err(MoveError::Gap(gap)) } else { Ok(position) }
    }

    /// The axes come to rest at the end of what was pushed.
    fn end_run(&mut self, take: &mut impl FnMut(PlannerStep<'_, P>)) {
        if self.smoother.is_empty() && self.row.cells.is_empty() {
            return;
        }
        self.smoother.drain(true, &self.arrays, &mut self.row);
        let count = self.row.cells.len();
        self.solver.solve(&self.row.cells, self.speed, 0.0);
        self.emit(count, take);
        self.speed = 0.0;
        self.lookahead_factor = 1;
    }

    /// Hands on as much of a long row as later moves cannot change.
    fn hand_on(&mut self, take: &mut impl FnMut(PlannerStep<'_, P>)) {
        self.solver.solve(&self.row.cells, self.speed, 0.0);
        match self.solver.last_certain() {
            Some(station) if station.node > 0 => {
                self.emit(station.node, take);
                self.speed = station.speed;
                self.lookahead_factor = 1;
            }
            // The stop at the end reaches back to the start: more has to be known.
            _ => self.lookahead_factor *= 2,
        }
    }

    /// Emits the cells before a boundary, which is a station, from rest to rest where the
    /// axes rest before.
    fn emit(&mut self, node: usize, take: &mut impl FnMut(PlannerStep<'_, P>)) {
        let mut begin = 0;
        while begin < node {
            let rest = self.row.cells[begin..node].iter().position(|cell| cell.ends_at_rest);
            let end = rest.map_or(node, |index| begin + index + 1);
            self.emit_part(begin, end, take);
            begin = end;
        }
        self.row.cells.drain(..node);
        self.row.time_s = self.row.cells.iter().map(|cell| cell.length / cell.speed).sum();
    }

    /// Emits the cells between two boundaries.
    fn emit_part(&mut self, begin: usize, end: usize, take: &mut impl FnMut(PlannerStep<'_, P>)) {
        let trajectory = &mut self.trajectory;
        trajectory.phases.clear();
        trajectory.pieces.clear();
        let first = self.solver.phases(&self.row.cells, begin, end, &mut trajectory.phases);
        let from = first.map_or(0.0, |station| station.at);
        if from > 0.0 {
            trajectory.phases.iter_mut().for_each(|phase| phase.from -= from);
        }
        let pieces = pieces_of(&self.row.cells[begin..end]);
        if pieces == self.row.pieces.len() {
            std::mem::swap(&mut trajectory.pieces, &mut self.row.pieces);
        } else {
            trajectory.pieces.extend(self.row.pieces.drain(..pieces));
        }
        let from_rest = first.is_none_or(|station| station.speed <= 0.0);
        if self.options.level == PlannerLevel::Best && from_rest {
            let shares = [self.overlap, self.next_overlap].map(|o| o.map_or(1.0, |o| o.jerk_share));
            improve(trajectory, &self.row.speeds[..pieces], &self.limits, shares);
        }
        if self.row.keeps_speeds {
            self.row.speeds.drain(..pieces);
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

impl MoveGroup {
    /// The time of its moves corner by corner, s.
    fn corners_s(&mut self) -> f64 {
        let mut time_s = 0.0;
        self.other.plan_all(&self.moves, |one| time_s += one.duration_s() - one.overlap_s);
        time_s
    }

    /// Whether its moves are many and short for their feeds.
    fn is_dense(&self) -> bool {
        self.moves.len() >= FEW && self.feed_s < DENSE_S * self.moves.len() as f64
    }

    fn push(&mut self, motion: &MoveRequest) {
        self.feed_s += motion.at_speed_s();
        self.moves.push(*motion);
    }

    fn clear(&mut self) {
        self.moves.clear();
        self.feed_s = 0.0;
        self.dense.forget();
    }

    /// Whether enough of it is known to see that the rest is not dense either, or somebody waits.
    fn is_long(&self, row_s: f64) -> bool {
        self.moves.len() >= FEW && (self.feed_s >= row_s || self.moves.len() == ENOUGH)
    }

    /// Its moves as smooth curves from corner to corner, if corners by themselves are not quicker.
    fn quicker_curves<P: PathPart>(
        &mut self,
        limits: &KinematicLimits,
        gap: f64,
    ) -> Option<Vec<PlannedTrajectory<P>>> {
        let planner = MotionPlanner::at_rest(*limits, PlannerOptions::new(PlannerLevel::Fast));
        let mut singly = ByCorners(planner);
        let (links, least_s) = self.dense.plan(&self.moves, limits, gap, &mut singly);
        let time_s = links.iter().map(ChainLink::time_s).sum::<f64>();
        let is_quick = singly.is_quick(&self.moves, time_s, least_s) || time_s < self.corners_s();
        is_quick.then(|| links.into_iter().map(ChainLink::into_kept_trajectory).collect())
    }
}

/// Plans the moves of a group that are no curve.
struct ByCorners(MotionPlanner);

impl CornerStrategy for ByCorners {
    fn plan(
        &mut self,
        moves: &[MoveRequest],
        overlaps: [Option<OverlapLimits>; 2],
        out: &mut Vec<PlannedTrajectory>,
    ) {
        self.0.plan_between(moves, overlaps, |one| out.push(one.clone()));
    }

    fn is_quick(&self, moves: &[MoveRequest], time_s: f64, least_s: f64) -> bool {
        time_s < NEAR * least_s && are_slower_with_stops(moves, time_s, &self.0.limits)
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
    // Short moves take so much longer that few of them tell.
    let mut least_s = 0.0;
    moves.iter().any(|motion| {
        least_s += one(motion);
        least_s > than_s
    })
}

fn pieces_of(cells: &[LimitInterval]) -> usize {
    cells.iter().map(|cell| cell.pieces as usize).sum()
}

/// A quicker velocity profile for a stretch from rest to rest, where there is one. The speeds are the
/// largest that are asked for on its pieces; the shares those of the jerk at both its ends.
fn improve(
    trajectory: &mut PlannedTrajectory<impl PathPart>,
    speeds: &[f64],
    limits: &KinematicLimits,
    shares: [f64; 2],
) {
    let limits = limits.with_jerk(shares[0].min(shares[1]));
    let Some(path) = PathStorage::path(&trajectory.pieces) else { return };
    let Ok(run) = PathRun::new(path, speeds, 0.0, &limits) else { return };
    let Some(phases) = solve_profile(&run, GAPS[1]).0 else { return };
    let time_s = |phases: &[JerkPhase]| phases.iter().map(|phase| phase.duration_s).sum::<f64>();
    if time_s(&phases) < time_s(&trajectory.phases) {
        trajectory.phases = phases;
    }
}
