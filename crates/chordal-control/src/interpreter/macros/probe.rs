//! Probe and skip moves.

use crate::command::Position;

/// What the probe moves found.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub(in super::super) struct Probe {
    /// The last one touched something.
    pub found: bool,
    /// Points that the fixed routines store, mm and rad.
    pub points: [Position; 3],
}
