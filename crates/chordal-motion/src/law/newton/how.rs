//! From where the Newton steps begin.

use super::NEAR;

/// A window that is solved again begins with this share of its solution.
const AGAIN: f64 = 0.995;
/// The open gap at the start, as a share of the time; near the solution in gaps that are wanted.
const FAR_OPEN: f64 = 0.1;
const NEAR_GAPS: f64 = 10.0;

/// How near the solution a start is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Begin {
    /// A first law.
    Far,
    /// The solution within limits that were a little wider, with its prices.
    Near,
}

impl Begin {
    /// The gap that is taken to be open, as a share of the time.
    pub fn open(self, gap: f64) -> f64 {
        match self {
            Begin::Far => FAR_OPEN,
            Begin::Near => NEAR_GAPS * gap,
        }
    }

    /// So much of a cap may be used, and of the coefficients that are given.
    pub fn shares(self) -> [f64; 2] {
        match self {
            Begin::Far => [NEAR, 1.0],
            Begin::Near => [AGAIN; 2],
        }
    }
}
