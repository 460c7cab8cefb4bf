//! The least time with limits of jerk, by convex programming: a yardstick.
//!
//! 1. The bound without jerk gives b̄ ≥ b = σ̇².
//! 2. A grid evenly spaced in time (`grid.rs`).
//! 3. A first program with |jerk| ≤ J/√b̄, which is conservative.
//! 4. Programs with the tangent of J/√b at the profile before (`convex_step.rs`), each a second-order
//!    conic program; every profile is a start for the next, and the times fall.
//!
//! 5. Intervals that turn out to take longer than was aimed at are cut, and it goes on.
//!
//! A [`LeastTimeGauge`] compares the steps of any planner with the bound and the reference.
//!
//! Pieces must fit in place, direction and curvature, as those of a planner do: a step of the
//! curvature at speed is a jerk without limit, which no velocity profile avoids and none here sees.
//!
//! (Verscheure and others 2009 for the convex program without jerk; Debrouwere and others 2013
//! for the sequence with jerk.)

mod conic_program;
mod convex_step;
mod gauge;
mod grid;
mod reference_profile;

use crate::time_bound::{PathRun, TimeBound};
use convex_step::{ConvexStep, JerkBoundForm, first_profile};
pub use gauge::{LeastTimeGauge, LeastTimes, RunTimes};
use grid::ReferenceGrid;
pub use reference_profile::ReferenceProfile;

/// How much work the reference may be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ReferenceQuality {
    /// Time between nodes, s; more where a run would need more than `most_nodes`.
    pub step_s: f64,
    /// Nodes at least.
    pub least_nodes: usize,
    /// Nodes at most; seams of pieces may double them.
    pub most_nodes: usize,
    /// Nodes at most over all runs that a [`LeastTimeGauge`] compares with the reference; later runs go
    /// without. At about half a millisecond each.
    pub total_nodes: usize,
    /// Convex programs at most.
    pub programs: usize,
}

impl Default for ReferenceQuality {
    fn default() -> ReferenceQuality {
        ReferenceQuality {
            step_s: 0.002,
            least_nodes: 150,
            most_nodes: 20_000,
            total_nodes: 60_000,
            programs: 8,
        }
    }
}

/// The iteration ends when a program gains less than this share of the time.
const SETTLED_TIME_SHARE: f64 = 1e-4;

/// No profile was found.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error(
    "the conic program for the least time has no solution: the run cannot be brought to a stop"
)]
pub struct ReferenceError;

/// The least time of a run within every limit, jerk included: a local optimum to the accuracy
/// of its grid, about 0.1 %.
///
/// # Errors
/// When no profile was found, which a run from rest always has; one that begins at speed may not.
pub fn reference(
    run: &PathRun<'_>,
    bound: &TimeBound,
    effort: &ReferenceQuality,
) -> Result<ReferenceProfile, ReferenceError> {
    let grid = ReferenceGrid::new(run, bound, effort);
    let mut profile = first_profile(run, &grid);
    profile = ConvexStep::solve(run, &profile, JerkBoundForm::Fixed).map_err(|_| ReferenceError)?;
    for _ in 1..effort.programs {
        // Where jerk makes it slower than was thought, its intervals must be shorter.
        let refined = profile.refine(2 * effort.most_nodes);
        let before = profile.time_s;
        let Ok(next) = ConvexStep::solve(run, &profile, JerkBoundForm::Tangent) else { break };
        profile = next;
        profile.change_s = before - profile.time_s;
        if !refined && profile.change_s.abs() < SETTLED_TIME_SHARE * profile.time_s {
            break;
        }
    }
    Ok(profile)
}
