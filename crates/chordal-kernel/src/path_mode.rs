//! The active path mode: whether and how the ends of moves are rounded.

use chordal_command::PathMode;

use crate::rules::{PathRules, ShortBlocks};

/// The path mode of a run: what the codes of each kind have set.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct PathState {
    /// By G61, G64 and their like.
    mode: PathMode,
    /// The tolerance that G187, G05.1 and similar codes set, mm; `None` without one.
    distance_mm: Option<f64>,
    /// Such a code makes the control join short blocks.
    joins: bool,
    /// This block ends at rest (G9).
    pub once: bool,
}

impl PathState {
    /// At power-on.
    pub fn new(rules: &PathRules) -> PathState {
        PathState { mode: rules.start_mode(), distance_mm: None, joins: false, once: false }
    }

    /// The active mode; with G9, the exact stop of the current block.
    pub fn in_force(&self) -> PathMode {
        match self.mode {
            _ if self.once => PathMode::ExactStop,
            PathMode::Continuous { tolerance_mm, joined } => PathMode::Continuous {
                tolerance_mm: self.distance_mm.or(tolerance_mm),
                joined: joined || self.joins,
            },
            mode => mode,
        }
    }

    /// Sets the mode by a code such as G61 or G64.
    pub fn set_mode(&mut self, mode: PathMode) {
        self.mode = mode;
    }

    /// Switches look-ahead on, with the tolerance of the rules, or off.
    pub fn set_look_ahead(&mut self, rules: &PathRules, on: bool) {
        self.distance_mm = rules.look_ahead_mm.filter(|_| on);
        self.joins = on && rules.short_blocks != ShortBlocks::Separate;
    }

    /// Sets the tolerance independently of the mode, mm; `None` ends it.
    pub fn set_distance(&mut self, distance_mm: Option<f64>) {
        self.distance_mm = distance_mm;
    }
}
