//! A motion in time: pieces of path, and phases of constant jerk along them.

use chordal_geometry::AXES;

use crate::AxisValues;
use crate::piece::{PathPiece, SIXTH};

/// A part of a velocity profile with constant jerk along the path.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct JerkPhase {
    /// Duration, s.
    pub duration_s: f64,
    /// σ at its start, from the start of the trajectory.
    pub from: f64,
    /// σ per s at its start.
    pub speed: f64,
    /// σ per s² at its start.
    pub acceleration: f64,
    /// σ per s³, constant.
    pub jerk: f64,
}

/// The velocity profile at an instant: σ and its derivatives with respect to time.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ProfilePoint {
    /// σ from the start of the trajectory.
    pub sigma: f64,
    /// σ per s.
    pub speed: f64,
    /// σ per s².
    pub acceleration: f64,
    /// σ per s³.
    pub jerk: f64,
}

impl JerkPhase {
    /// The velocity profile `t` s after its start.
    #[inline]
    pub fn at(&self, t: f64) -> ProfilePoint {
        let JerkPhase { from, speed, acceleration, jerk, .. } = *self;
        ProfilePoint {
            sigma: from + t * (speed + t * (acceleration / 2.0 + t * (jerk * SIXTH))),
            speed: speed + t * (acceleration + t * (jerk / 2.0)),
            acceleration: acceleration + t * jerk,
            jerk,
        }
    }

    /// When the phase reaches `sigma`, s from its start, limited to the time from `from` to its end. The speed
    /// must not be negative; where the profile rests at `sigma`, the first instant.
    pub fn time_at(&self, sigma: f64, from: f64) -> f64 {
        let (mut low, mut high) = (from, self.duration_s);
        if self.acceleration == 0.0 && self.jerk == 0.0 && self.speed > 0.0 && low <= high {
            return ((sigma - self.from) / self.speed).clamp(low, high);
        }
        let near = 4.0 * f64::EPSILON * sigma.abs().max(self.from.abs());
        let mut t = low;
        for _ in 0..MAX_CROSSING_STEPS {
            let along = self.at(t);
            let beyond = along.sigma - sigma;
            if beyond.abs() <= near || high - low <= f64::EPSILON * high {
                break;
            }
            if beyond > 0.0 {
                high = t
            } else {
                low = t
            }
            let newton = t - beyond / along.speed;
            // Bisection where Newton's step leaves the bracket or the speed is zero.
            t = if newton > low && newton < high { newton } else { low + (high - low) / 2.0 };
        }
        t
    }
}

/// The largest number of steps of the search for a crossing: bisection alone reaches the last bit in fewer.
const MAX_CROSSING_STEPS: u32 = 80;

/// Path and time between two instants without acceleration: from rest to rest, or to a point
/// that is passed at constant speed, where the next trajectory begins.
///
/// `P` says how the path is represented: by [`PathPiece`]s, or only their [`PathSpan`](crate::PathSpan)s.
#[derive(Debug, PartialEq)]
pub struct PlannedTrajectory<P = PathPiece> {
    /// The path, in order.
    pub pieces: Vec<P>,
    /// The velocity profile along it, in order.
    pub phases: Vec<JerkPhase>,
    /// How long before the end of the previous trajectory it begins, s. In that time the motions are
    /// added, each on a straight line, so that the tool passes the corner between them within its
    /// tolerance.
    pub overlap_s: f64,
}

impl<P> Default for PlannedTrajectory<P> {
    fn default() -> PlannedTrajectory<P> {
        PlannedTrajectory { pieces: Vec::new(), phases: Vec::new(), overlap_s: 0.0 }
    }
}

impl<P: Clone> Clone for PlannedTrajectory<P> {
    fn clone(&self) -> PlannedTrajectory<P> {
        PlannedTrajectory {
            pieces: self.pieces.clone(),
            phases: self.phases.clone(),
            overlap_s: self.overlap_s,
        }
    }

    /// Reuses the memory of the vectors.
    fn clone_from(&mut self, source: &PlannedTrajectory<P>) {
        self.pieces.clone_from(&source.pieces);
        self.phases.clone_from(&source.phases);
        self.overlap_s = source.overlap_s;
    }
}

impl<P> PlannedTrajectory<P> {
    /// Its duration, s.
    pub fn duration_s(&self) -> f64 {
        self.phases.iter().map(|phase| phase.duration_s).sum()
    }
}

impl PlannedTrajectory {
    /// The length of its path, σ.
    pub fn length(&self) -> f64 {
        self.pieces.iter().map(|piece| piece.length).sum()
    }

    /// The axes at its start, mm and rad.
    pub fn from(&self) -> AxisValues {
        self.pieces.first().map_or([0.0; AXES], |piece| piece.at(0.0)[0])
    }

    /// The axes at its end, mm and rad.
    pub fn to(&self) -> AxisValues {
        self.pieces.last().map_or([0.0; AXES], |piece| piece.at(piece.length)[0])
    }
}

/// What a planner emits.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PlannerStep<'a, P = PathPiece> {
    /// The axes move.
    Trajectory(&'a PlannedTrajectory<P>),
    /// The axes rest.
    Wait {
        /// How long, s; not negative.
        seconds: f64,
        /// The number that the caller gave with the wait.
        tag: u64,
    },
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_phase_says_when_it_passes_a_place() {
        // Even, from rest, to rest, through its turn of acceleration, and far from zero.
        for (speed, acceleration, jerk, from) in [
            (10.0, 0.0, 0.0, 0.0),
            (0.0, 0.0, 1e5, 0.0),
            (50.0, -2000.0, 4e4, 3.0),
            (20.0, 300.0, -1e4, 1e6),
            (1e-9, 0.0, 3.0, 0.0),
        ] {
            let phase = JerkPhase { duration_s: 0.05, from, speed, acceleration, jerk };
            for share in [0.0, 1e-6, 0.1, 0.5, 0.9, 1.0] {
                let t = phase.duration_s * share;
                let sigma = phase.at(t).sigma;
                let crossing_s = phase.time_at(sigma, 0.0);
                // As near as the place is exact.
                let off = (phase.at(crossing_s).sigma - sigma).abs();
                assert!(off <= 1e-15 * sigma.abs().max(from), "{phase:?} {t} {crossing_s} {off:e}");
            }
        }
    }

    #[test]
    fn a_place_beyond_a_phase_is_passed_at_its_ends() {
        for jerk in [0.0, 100.0] {
            let phase =
                JerkPhase { duration_s: 2.0, from: 5.0, speed: 1.0, acceleration: 0.0, jerk };
            assert_eq!(phase.time_at(4.0, 0.0), 0.0);
            assert_eq!(phase.time_at(5.1, 0.5), 0.5);
            assert!((phase.time_at(1e9, 0.0) - 2.0).abs() < 1e-14);
            assert!(phase.time_at(f64::NAN, 0.0).is_nan() || jerk > 0.0);
        }
        let still =
            JerkPhase { duration_s: 2.0, from: 5.0, speed: 0.0, acceleration: 0.0, jerk: 0.0 };
        assert_eq!(still.time_at(5.0, 0.0), 0.0);
    }
}
