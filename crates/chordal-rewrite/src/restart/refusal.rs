//! Why a program cannot begin at a line.

pub use chordal::control::RestartObstacle as RefusalReason;

use crate::TransformRefusal;

/// A refusal and its kind.
#[derive(Debug)]
pub struct RestartRefusal {
    /// What kind it is.
    pub reason: RefusalReason,
    /// What is said about it.
    pub refusal: TransformRefusal,
}
