//! How a control passes the ends of moves, apart from the path mode in force.

use crate::command::PathMode;

/// Where a control comes to rest and which path mode it starts with.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct CornerRules {
    /// The path mode at power-on.
    pub start: PathMode,
    /// A rapid ends at rest before a cut (in-position check).
    pub stop_before_cut: bool,
    /// A rapid ends at rest before another rapid.
    pub stop_between_rapids: bool,
    /// A cut ends at rest before a rapid.
    pub stop_after_cut: bool,
}

impl CornerRules {
    /// Rapids with an in-position check, cuts that run into each other.
    pub const COMMON: CornerRules = CornerRules {
        start: PathMode::Continuous { tolerance_mm: None },
        stop_before_cut: true,
        stop_between_rapids: true,
        stop_after_cut: true,
    };
}
