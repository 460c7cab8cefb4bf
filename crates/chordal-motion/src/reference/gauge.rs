//! How far a planned movement is from the least time.

use super::{Effort, reference};
use crate::bound::{Run, bound};
use crate::limits::Limits;
use crate::piece::Piece;
use crate::trajectory::{Phase, Step, Stretch};

/// The times of one run from rest to rest, and the least it could take.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct RunTimes {
    /// Tags of its first and of its last piece.
    pub tags: (u64, u64),
    /// As planned, s.
    pub time_s: f64,
    /// The time that nothing beats while velocities and accelerations are held, s.
    pub bound_s: f64,
    /// The least time with jerk, s; `time_s` where no law was found or that is less.
    pub reference_s: f64,
    /// How much of it is made together with the run before, s.
    pub overlap_s: f64,
}

/// Times of a whole movement.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Least {
    /// As planned, s.
    pub time_s: f64,
    /// Without jerk, s.
    pub bound_s: f64,
    /// With jerk, s.
    pub reference_s: f64,
}

impl Least {
    /// Adds a run, of which the overlap counts once.
    fn add(&mut self, run: &RunTimes) {
        self.time_s += run.time_s - run.overlap_s;
        self.bound_s += (run.bound_s - run.overlap_s).max(0.0);
        self.reference_s += run.reference_s - run.overlap_s;
    }
}

/// Holds the steps of a planner against the least time.
///
/// The path is taken as the planner has made it, eased corners included, and so are the places
/// where it rests and by how much the runs before and after a corner overlap there: the bound and
/// the reference of a chain of runs are the sums of theirs less the same overlaps.
#[derive(Debug)]
pub struct Gauge {
    limits: Limits,
    effort: Effort,
    pieces: Vec<Piece>,
    speeds: Vec<f64>,
    run: RunTimes,
    sum: Least,
}

/// Share of its largest speed below which a stretch ends at rest.
const AT_REST: f64 = 1e-6;

impl Gauge {
    /// A gauge for a machine at rest.
    pub fn new(limits: Limits, effort: Effort) -> Gauge {
        Gauge {
            limits,
            effort,
            pieces: Vec::new(),
            speeds: Vec::new(),
            run: RunTimes::default(),
            sum: Least::default(),
        }
    }

    /// Takes a step, with the programmed speed of each tag (σ per s; infinite for a rapid), and
    /// hands on each run that it ends.
    pub fn push(
        &mut self,
        step: Step<'_>,
        speed: impl Fn(u64) -> f64,
        mut take: impl FnMut(&RunTimes),
    ) {
        match step {
            Step::Wait { seconds, .. } => {
                self.sum.time_s += seconds;
                self.sum.bound_s += seconds;
                self.sum.reference_s += seconds;
            }
            Step::Stretch(stretch) => {
                if self.pieces.is_empty() {
                    self.run.overlap_s = stretch.overlap_s;
                }
                self.run.time_s += stretch.duration_s();
                self.pieces.extend_from_slice(&stretch.pieces);
                self.speeds.extend(stretch.pieces.iter().map(|piece| speed(piece.tag)));
                if ends_at_rest(stretch) {
                    self.measure(&mut take);
                }
            }
        }
    }

    /// The times of everything.
    pub fn finish(mut self, mut take: impl FnMut(&RunTimes)) -> Least {
        self.measure(&mut take);
        self.sum
    }

    /// The run is over.
    fn measure(&mut self, take: &mut impl FnMut(&RunTimes)) {
        let mut times = std::mem::take(&mut self.run);
        let (Some(first), Some(last)) = (self.pieces.first(), self.pieces.last()) else { return };
        times.tags = (first.tag, last.tag);
        (times.bound_s, times.reference_s) = (times.time_s, times.time_s);
        if let Ok(run) = Run::new(&self.pieces, &self.speeds, 0.0, &self.limits) {
            let bound = bound(&run);
            times.bound_s = bound.time_s.min(times.time_s);
            if let Ok(law) = reference(&run, &bound, &self.effort) {
                times.reference_s = law.time_s.clamp(times.bound_s, times.time_s);
            }
        }
        self.pieces.clear();
        self.speeds.clear();
        self.sum.add(&times);
        take(&times);
    }
}

fn ends_at_rest(stretch: &Stretch) -> bool {
    let most = stretch.phases.iter().fold(0.0, |most: f64, phase| most.max(phase.speed));
    let end = |phase: &Phase| phase.at(phase.duration_s).speed;
    stretch.phases.last().is_some_and(|phase| end(phase) <= AT_REST * most)
}
