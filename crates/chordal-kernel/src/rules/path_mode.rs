//! The rules of a control for the ends of moves, as data: the mode at power-on, the tolerances of the modes that
//! round corners, and where it stops in every mode.

use chordal_command::PathMode;

/// The path mode at power-on.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum StartMode {
    /// Corners are rounded.
    Continuous,
    /// Corners are exact, without a stop where the direction does not change.
    ExactPath,
    /// A stop at the end of every block.
    ExactStop,
}

/// Where a control joins many short blocks into one smooth curve.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum ShortBlocks {
    /// Never: each corner is planned by itself.
    Separate,
    /// In its look-ahead and high-accuracy modes only.
    LookAhead,
    /// Wherever corners may be rounded.
    Joined,
}

/// How a control divides an arc into segments by their length, not by a tolerance (Marlin).
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct ArcSegments {
    /// Shortest segment, mm.
    pub least_mm: f64,
    /// Longest segment, mm.
    pub most_mm: f64,
    /// Minimum number of segments of a full circle, unless they become shorter than `least_mm`.
    pub of_circle: u32,
}

/// How a control without jerk limits passes from one straight segment to the next (GRBL).
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct JunctionRules {
    /// Junction deviation: the distance of an imagined rounding from the corner, mm.
    pub deviation_mm: f64,
    /// Blocks of look-ahead, including the current one.
    pub blocks: u32,
    /// Largest distance of the segments of an arc from it, mm.
    pub arc_tolerance_mm: f64,
    /// Arcs are divided by segment length instead; `None` by `arc_tolerance_mm`.
    pub arc_segments: Option<ArcSegments>,
    /// Largest step of the speed of X, Y and Z at a junction (classic jerk), mm/s; `None` when the junction deviation
    /// limits the speed.
    pub speed_steps_mm_s: Option<[f64; 3]>,
    /// Motor steps per mm of X, Y and Z; segments end on whole steps.
    pub steps_per_mm: [f64; 3],
    /// The acceleration of a segment is reduced as a jerk limit would reduce it (grblHAL).
    pub limited_jerk: bool,
}

/// The rules for the ends of moves; lengths in mm.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct PathRules {
    /// The path mode at power-on and after the program's end.
    pub start: StartMode,
    /// A rapid stops before a cut (in-position check).
    pub stop_before_cut: bool,
    /// A rapid stops before another rapid.
    pub stop_between_rapids: bool,
    /// A cut stops before a rapid.
    pub stop_after_cut: bool,
    /// Largest distance from a corner when no code gives one; `None` when the control has no such value and the
    /// machine file's `[motion] corner_tolerance` applies.
    pub rounding_mm: Option<f64>,
    /// Levels of smoothness (Haas G187 P1 to P3): the fraction of `rounding_mm` that each allows.
    pub level_parts: [f64; 3],
    /// The active level when no code names one, 1 to 3.
    pub level: u8,
    /// The same distance in high-accuracy and look-ahead modes; `None` for `rounding_mm`.
    pub look_ahead_mm: Option<f64>,
    /// When short blocks become one curve.
    pub short_blocks: ShortBlocks,
    /// Trapezoidal profiles with junction deviation; `None` for a control with limited jerk.
    pub junctions: Option<JunctionRules>,
    /// The spindle output drives a laser (GRBL's `$32=1`): another S in the block of a motion does not stop the axes.
    pub laser_mode: bool,
}

impl PathRules {
    /// Rapids stop (in-position check), consecutive cuts do not.
    pub const COMMON: PathRules = PathRules {
        start: StartMode::Continuous,
        stop_before_cut: true,
        stop_between_rapids: true,
        stop_after_cut: true,
        rounding_mm: None,
        level_parts: [1.0; 3],
        level: 2,
        look_ahead_mm: None,
        short_blocks: ShortBlocks::Separate,
        junctions: None,
        laser_mode: false,
    };

    /// The tolerance of a level of smoothness, mm; `None` when the control has no value.
    pub fn of_level(&self, level: u8) -> Option<f64> {
        let part = self.level_parts[usize::from(level.clamp(1, 3)) - 1];
        self.rounding_mm.map(|mm| mm * part)
    }

    /// The mode that rounds corners, with or without look-ahead.
    pub fn continuous(&self, tolerance_mm: Option<f64>, look_ahead: bool) -> PathMode {
        let joined = match self.short_blocks {
            ShortBlocks::Separate => false,
            ShortBlocks::LookAhead => look_ahead,
            ShortBlocks::Joined => true,
        };
        PathMode::Continuous { tolerance_mm, joined }
    }

    /// The path mode of a program's first block.
    pub fn start_mode(&self) -> PathMode {
        match self.start {
            StartMode::Continuous => self.continuous(self.of_level(self.level), false),
            StartMode::ExactPath => PathMode::ExactPath,
            StartMode::ExactStop => PathMode::ExactStop,
        }
    }
}
