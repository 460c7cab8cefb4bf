//! From where the Newton steps begin.

use super::WALL_STEP_SHARE;

/// A window that is solved again begins with this share of its solution.
const WARM_START_SHARE: f64 = 0.995;
/// The open gap at the start, as a share of the time; near the solution in requested gaps.
const COLD_OPEN_SHARE: f64 = 0.1;
const WARM_OPEN_GAPS: f64 = 10.0;

/// How near the solution a start is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum NewtonStart {
    /// A first profile.
    Far,
    /// The solution within limits that were a little wider, with its prices.
    Near,
}

impl NewtonStart {
    /// The gap that is taken to be open, as a share of the time.
    pub fn open(self, gap: f64) -> f64 {
        match self {
            NewtonStart::Far => COLD_OPEN_SHARE,
            NewtonStart::Near => WARM_OPEN_GAPS * gap,
        }
    }

    /// So much of a cap may be used, and of the known coefficients.
    pub fn shares(self) -> [f64; 2] {
        match self {
            NewtonStart::Far => [WALL_STEP_SHARE, 1.0],
            NewtonStart::Near => [WARM_START_SHARE; 2],
        }
    }
}
