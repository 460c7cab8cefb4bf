//! How far a planned movement is from the least time.

use chordal_geometry::PerAxis;

use super::{ReferenceQuality, reference};
use crate::cube_root::cbrt;
use crate::limits::KinematicLimits;
use crate::piece::PathPiece;
use crate::time_bound::{PathRun, time_bound};
use crate::trajectory::{JerkPhase, PlannedTrajectory, PlannerStep};

/// The times of one run from rest to rest, and the least it could take.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct RunTimes {
    /// Tags of its first and of its last piece.
    pub tags: (u64, u64),
    /// As planned, s.
    pub time_s: f64,
    /// The time that nothing beats within the limits of velocity and acceleration, s.
    pub bound_s: f64,
    /// The least time with jerk, s, and no more than `time_s`; `None` where the work that is
    /// allowed was spent or no profile was found.
    pub reference_s: Option<f64>,
    /// How much of it is made together with the run before, s.
    pub overlap_s: f64,
}

/// Times of a whole movement.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct LeastTimes {
    /// As planned, s.
    pub time_s: f64,
    /// Without jerk, s.
    pub bound_s: f64,
    /// With jerk, s; runs without a reference count as planned.
    pub reference_s: f64,
    /// How much of `time_s` is of runs without a reference, s.
    pub unknown_s: f64,
}

impl LeastTimes {
    /// Adds a run, of which the overlap counts once.
    pub fn add(&mut self, run: &RunTimes) {
        self.time_s += run.time_s - run.overlap_s;
        self.bound_s += (run.bound_s - run.overlap_s).max(0.0);
        self.reference_s += run.reference_s.unwrap_or(run.time_s) - run.overlap_s;
        if run.reference_s.is_none() {
            self.unknown_s += run.time_s - run.overlap_s;
        }
    }

    /// Adds a time in which nothing moves, s: no machine is quicker.
    pub fn add_wait(&mut self, seconds: f64) {
        self.time_s += seconds;
        self.bound_s += seconds;
        self.reference_s += seconds;
    }
}

/// Compares the steps of a planner with the least time.
///
/// The path is taken as the planner has made it, eased corners included, and so are the places
/// where it rests and by how much the runs before and after a corner overlap there: the bound and
/// the reference of a chain of runs are the sums of theirs less the same overlaps.
#[derive(Debug)]
pub struct LeastTimeGauge {
    limits: KinematicLimits,
    effort: ReferenceQuality,
    pieces: Vec<PathPiece>,
    speeds: Vec<f64>,
    run: RunTimes,
    sum: LeastTimes,
    /// Nodes that may still be spent.
    left: usize,
}

/// Share of its largest speed below which a trajectory ends at rest.
const REST_SPEED_SHARE: f64 = 1e-6;

impl LeastTimeGauge {
    /// A gauge for a machine at rest.
    pub fn new(limits: KinematicLimits, effort: ReferenceQuality) -> LeastTimeGauge {
        LeastTimeGauge {
            limits,
            left: effort.total_nodes,
            effort,
            pieces: Vec::new(),
            speeds: Vec::new(),
            run: RunTimes::default(),
            sum: LeastTimes::default(),
        }
    }

    /// Takes a step, with the programmed speed of each tag (σ per s; infinite for a rapid), and
    /// emits each run that it ends.
    pub fn push(
        &mut self,
        step: PlannerStep<'_>,
        speed: impl Fn(u64) -> f64,
        mut take: impl FnMut(&RunTimes),
    ) {
        match step {
            PlannerStep::Wait { seconds, .. } => self.sum.add_wait(seconds),
            PlannerStep::Trajectory(trajectory) => {
                if self.pieces.is_empty() {
                    self.run.overlap_s = trajectory.overlap_s;
                }
                self.run.time_s += trajectory.duration_s();
                self.pieces.extend_from_slice(&trajectory.pieces);
                self.speeds.extend(trajectory.pieces.iter().map(|piece| speed(piece.tag)));
                if ends_at_rest(trajectory) {
                    self.measure(&mut take);
                }
            }
        }
    }

    /// The times of everything.
    pub fn finish(mut self, mut take: impl FnMut(&RunTimes)) -> LeastTimes {
        self.measure(&mut take);
        self.sum
    }

    /// The run is over.
    fn measure(&mut self, take: &mut impl FnMut(&RunTimes)) {
        let mut times = std::mem::take(&mut self.run);
        let (Some(first), Some(last)) = (self.pieces.first(), self.pieces.last()) else { return };
        times.tags = (first.tag, last.tag);
        (times.bound_s, times.reference_s) = self.least(times.time_s);
        self.pieces.clear();
        self.speeds.clear();
        self.sum.add(&times);
        take(&times);
    }

    /// Bound and reference of the run that took `time_s`.
    fn least(&mut self, time_s: f64) -> (f64, Option<f64>) {
        if let Some((bound_s, reference_s)) = self.least_of_line() {
            return (bound_s.min(time_s), Some(reference_s.min(time_s)));
        }
        let Ok(run) = PathRun::new(&self.pieces, &self.speeds, 0.0, &self.limits) else {
            return (time_s, None);
        };
        let bound = time_bound(&run);
        let bound_s = bound.time_s.min(time_s);
        let effort =
            ReferenceQuality { most_nodes: self.effort.most_nodes.min(self.left), ..self.effort };
        if effort.most_nodes < effort.least_nodes {
            return (bound_s, None);
        }
        let profile = reference(&run, &bound, &effort).ok();
        self.left -= profile
            .as_ref()
            .map_or(effort.least_nodes, |profile| profile.sigma.len())
            .min(self.left);
        (bound_s, profile.map(|profile| profile.time_s.clamp(bound_s, time_s)))
    }

    /// A straight line at one feed has closed forms for both: most runs of a program that drills
    /// or stops at corners are one.
    fn least_of_line(&self) -> Option<(f64, f64)> {
        let (first, feed) = (self.pieces.first()?, *self.speeds.first()?);
        let one = self.pieces.iter().all(|piece| {
            piece.is_straight() && piece.start[1] == first.start[1] && piece.length >= 0.0
        });
        if !one || self.speeds.iter().any(|speed| *speed != feed) {
            return None;
        }
        let along = |limits: PerAxis<f64>| {
            let rates = first.start[1].iter().zip(limits).filter(|(rate, _)| **rate != 0.0);
            rates.fold(f64::MAX, |least, (rate, limit)| least.min(limit / rate.abs()))
        };
        let distance: f64 = self.pieces.iter().map(|piece| piece.length).sum();
        let v = feed.min(along(self.limits.velocity()));
        let (a, j) = (along(self.limits.acceleration()), along(self.limits.jerk()));
        let known = distance > 0.0 && v > 0.0 && v < f64::MAX;
        known.then(|| (without_jerk(distance, v, a), with_jerk(distance, v, a, j)))
    }
}

/// From rest to rest over a distance, σ.
fn without_jerk(distance: f64, v: f64, a: f64) -> f64 {
    let top = v.min((distance * a).sqrt());
    distance / top + top / a
}

/// The same with a limit of jerk: seven phases or fewer. A ramp to the speed `top` takes
/// 2√(top/j), or top/a + a/j where it touches the acceleration.
fn with_jerk(distance: f64, v: f64, a: f64, j: f64) -> f64 {
    // The top at which two ramps make up the distance.
    let sharp = cbrt(0.25 * distance * distance * j);
    let touched = 0.5 * ((a * a * a * a / (j * j) + 4.0 * distance * a).sqrt() - a * a / j);
    let top = v.min(if sharp * j <= a * a { sharp } else { touched });
    let ramp = if top * j <= a * a { 2.0 * (top / j).sqrt() } else { top / a + a / j };
    distance / top + ramp
}

fn ends_at_rest(trajectory: &PlannedTrajectory) -> bool {
    let most = trajectory.phases.iter().fold(0.0, |most: f64, phase| most.max(phase.speed));
    let end = |phase: &JerkPhase| phase.at(phase.duration_s).speed;
    trajectory.phases.last().is_some_and(|phase| end(phase) <= REST_SPEED_SHARE * most)
}
