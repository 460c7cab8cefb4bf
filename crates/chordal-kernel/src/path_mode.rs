//! The path mode in force: how the ends of moves are passed.

use chordal_command::PathMode;

use crate::rules::{PathRules, ShortBlocks};

/// The path mode of a run: what the codes of each kind have set.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct PathState {
    /// By G61, G64 and their like.
    mode: PathMode,
    /// The distance that G187, G05.1 and their like have set, mm.
    distance_mm: Option<f64>,
    /// Such a code joins short blocks.
    joins: bool,
    /// This block ends at rest (G9).
    pub once: bool,
}

impl PathState {
    /// At power-on.
    pub fn new(rules: &PathRules) -> PathState {
        PathState { mode: rules.start_mode(), distance_mm: None, joins: false, once: false }
    }

    /// The mode in force, the present block's own stop included.
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

    /// A code of the family of G61 and G64.
    pub fn set_mode(&mut self, mode: PathMode) {
        self.mode = mode;
    }

    /// A code that switches look-ahead on, with the distance of the rules, or off.
    pub fn set_look_ahead(&mut self, rules: &PathRules, on: bool) {
        self.distance_mm = rules.look_ahead_mm.filter(|_| on);
        self.joins = on && rules.short_blocks != ShortBlocks::Separate;
    }

    /// A code that sets the distance apart from the mode; `None` takes it back.
    pub fn set_distance(&mut self, distance_mm: Option<f64>) {
        self.distance_mm = distance_mm;
    }
}
