//! The planner: takes moves, emits steps; its levels, options and strategies.
//!
//! | strategy | for | file |
//! |---|---|---|
//! | corners | moves that keep their exact path or their corners | `corner_planner.rs` |
//! | curves | dense moves from rest to rest, where curves are quicker; all others corner by corner | `curve_strategy.rs` |
//! | junctions | controls that have no jerk | `junction_planner.rs` of the crate |

mod corner_planner;
mod curve_strategy;

use crate::AxisValues;
use crate::corner_blend::path_span::{PathPart, PathSpan};
use crate::junction_planner::{JunctionPlanner, JunctionRule};
use crate::limits::KinematicLimits;
use crate::move_request::{MoveError, MoveRequest};
use crate::piece::PathPiece;
use crate::profile_solver::SolverWork;
use crate::trajectory::PlannerStep;
use crate::tuning::TUNING;
use corner_planner::CornerPlanner;
use curve_strategy::CurveStrategy;

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
    /// [`PlannerLevel::Fast`] for programs of any length.
    pub level: PlannerLevel,
    /// The length of a look-ahead window, s: moves are planned together when they would take so long at their largest
    /// speeds. What is certain of them is emitted, so that a servo loop is fed early. Infinite: as
    /// many as memory allows.
    pub look_ahead_s: f64,
    /// Dense moves from rest to rest are planned as smooth curves, where that is quicker: at most 50,000
    /// moves wait for their rest. Otherwise every corner is passed by itself.
    pub joins: bool,
    /// Trapezoids with junction deviation instead of limited jerk, where the control moves like that.
    pub junctions: Option<JunctionRule>,
}

impl PlannerOptions {
    /// A planner that looks ahead without limit and may plan curves.
    pub fn new(level: PlannerLevel) -> PlannerOptions {
        PlannerOptions { level, look_ahead_s: f64::INFINITY, joins: true, junctions: None }
    }
}

/// Turns moves into steps: holds every limit, keeps the path, loses little time.
///
/// `P` is what its trajectories say about the path: all of it ([`MotionPlanner::new`]) or only what times need
/// ([`MotionPlanner::of_times`]).
#[derive(Debug)]
pub struct MotionPlanner<P = PathPiece> {
    limits: KinematicLimits,
    /// Where the axes will be after all moves; `None` where the next move may begin anywhere.
    position: Option<AxisValues>,
    strategy: PlanningStrategy<P>,
}

/// How moves become trajectories.
#[derive(Debug)]
enum PlanningStrategy<P> {
    /// Every corner by itself.
    Corners(Box<CornerPlanner<P>>),
    /// Dense moves as smooth curves where these are quicker, the others corner by corner.
    Curves(Box<CurveStrategy<P>>),
    /// Trapezoids with a speed at each junction.
    Junctions(Box<JunctionPlanner<P>>),
}

impl<P: PathPart> PlanningStrategy<P> {
    fn new(limits: KinematicLimits, options: PlannerOptions) -> PlanningStrategy<P> {
        let PlannerOptions { level, look_ahead_s, joins, junctions } = options;
        match junctions {
            Some(rule) => PlanningStrategy::Junctions(Box::new(JunctionPlanner::new(rule))),
            None if joins => {
                let strategy = CurveStrategy::new(limits, level, look_ahead_s);
                PlanningStrategy::Curves(Box::new(strategy))
            }
            None => {
                let planner = CornerPlanner::new(limits, level, look_ahead_s);
                PlanningStrategy::Corners(Box::new(planner))
            }
        }
    }
}

impl MotionPlanner {
    /// A planner for a machine at rest.
    pub fn new(limits: KinematicLimits, options: PlannerOptions) -> MotionPlanner {
        MotionPlanner::at_rest(limits, options)
    }
}

impl MotionPlanner<PathSpan> {
    /// A planner that works out the times of level fast and keeps no path.
    pub fn of_times(limits: KinematicLimits) -> MotionPlanner<PathSpan> {
        MotionPlanner::of_times_by(limits, None)
    }

    /// The same, by trapezoids with junction deviation where there is a rule for them.
    pub fn of_times_by(
        limits: KinematicLimits,
        junctions: Option<JunctionRule>,
    ) -> MotionPlanner<PathSpan> {
        let options = PlannerOptions { junctions, ..PlannerOptions::new(PlannerLevel::Fast) };
        MotionPlanner::at_rest(limits, options)
    }
}

impl<P: PathPart> MotionPlanner<P> {
    fn at_rest(limits: KinematicLimits, options: PlannerOptions) -> MotionPlanner<P> {
        let strategy = PlanningStrategy::new(limits, options);
        MotionPlanner { limits, position: None, strategy }
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
        if motion.length() < TUNING.shortest_move {
            // The next line begins where this one did, so nothing is lost.
            self.position = Some(start);
            return Ok(());
        }
        self.position = Some(motion.to());
        match &mut self.strategy {
            PlanningStrategy::Corners(planner) => planner.push(motion, &start, &mut take),
            PlanningStrategy::Curves(strategy) => strategy.push(motion, &start, &mut take),
            PlanningStrategy::Junctions(planner) => planner.push(motion, &self.limits, &mut take),
        }
        Ok(())
    }

    /// What the profiles of curves took so far. Where windows have failed, other curves or corners were planned.
    pub fn work(&self) -> SolverWork {
        match &self.strategy {
            PlanningStrategy::Curves(strategy) => strategy.work(),
            PlanningStrategy::Corners(_) | PlanningStrategy::Junctions(_) => SolverWork::default(),
        }
    }

    /// The axes come to rest and wait for a time, s.
    pub fn wait(&mut self, seconds: f64, tag: u64, mut take: impl FnMut(PlannerStep<'_, P>)) {
        self.finish(&mut take);
        take(PlannerStep::Wait { seconds, tag });
    }

    /// The axes come to rest: emits all steps that are left. The next move may begin anywhere.
    pub fn finish(&mut self, mut take: impl FnMut(PlannerStep<'_, P>)) {
        match &mut self.strategy {
            PlanningStrategy::Corners(planner) => planner.finish(&mut take),
            PlanningStrategy::Curves(strategy) => strategy.finish(&mut take),
            PlanningStrategy::Junctions(planner) => planner.rest(&mut take),
        }
        self.position = None;
    }

    /// Where a move begins: where the one before it ended.
    fn start_of(&self, motion: &MoveRequest) -> Result<AxisValues, MoveError> {
        let from = motion.from();
        let Some(position) = self.position else { return Ok(from) };
        let gap = from.iter().zip(&position).fold(0.0_f64, |gap, (a, b)| gap.max((a - b).abs()));
        if gap > TUNING.closed_gap { Err(MoveError::Gap(gap)) } else { Ok(position) }
    }
}
