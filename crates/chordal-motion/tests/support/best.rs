//! The profile of the level best.

use chordal_motion::{JerkPhase, PathRun, solve_profile};

/// As near the least time as the level best goes.
const GAP: f64 = 5e-5;

/// A velocity profile in phases.
#[derive(Clone, Debug, PartialEq)]
pub struct Best {
    /// How long it takes, s.
    pub time_s: f64,
    pub phases: Vec<JerkPhase>,
}

/// The profile of a run, where there is one.
pub fn best(run: &PathRun<'_>) -> Option<Best> {
    let phases = solve_profile(run, GAP).0?;
    Some(Best { time_s: phases.iter().map(|phase| phase.duration_s).sum(), phases })
}
