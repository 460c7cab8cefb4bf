//! What a control does at the ends of moves, as data: the mode it starts with, the tolerances
//! of the modes that round corners, and where it comes to rest whatever the mode.

use chordal_command::PathMode;

/// The path mode at power-on.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum StartMode {
    /// Corners are rounded.
    Continuous,
    /// Exact path.
    ExactPath,
    /// A stop at the end of every block.
    ExactStop,
}

/// Where a control joins many short blocks into one smooth curve.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum ShortBlocks {
    /// Nowhere: each corner is passed by itself.
    Separate,
    /// In its look-ahead and high-accuracy modes only.
    LookAhead,
    /// Wherever corners may be rounded.
    Joined,
}

/// How a control cuts an arc into segments by their length, not by how far they are from it (Marlin).
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct ArcSegments {
    /// The shortest, mm.
    pub least_mm: f64,
    /// The longest, mm.
    pub most_mm: f64,
    /// A full circle has so many at least, where they do not become too short.
    pub of_circle: u32,
}

/// How a control without jerk limits passes from one straight segment to the next (GRBL).
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct JunctionRules {
    /// How far a detour at a junction would be from it, mm.
    pub deviation_mm: f64,
    /// Blocks that it knows, with the one under way.
    pub blocks: u32,
    /// How far the segments of an arc are from it, mm.
    pub arc_tolerance_mm: f64,
    /// Arcs are cut by the length of segments instead.
    pub arc_segments: Option<ArcSegments>,
    /// By how much X, Y and Z may change their speed at a junction at once, mm/s, where that counts and not the
    /// deviation.
    pub speed_steps_mm_s: Option<[f64; 3]>,
    /// Segments end on whole steps of X, Y and Z, so many a mm.
    pub steps_per_mm: [f64; 3],
    /// A segment is accelerated less, as a jerk limit would do it (grblHAL).
    pub limited_jerk: bool,
}

/// How a control passes the ends of moves. Lengths are mm.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct PathRules {
    /// The path mode at power-on and after the program's end.
    pub start: StartMode,
    /// A rapid ends at rest before a cut (in-position check).
    pub stop_before_cut: bool,
    /// A rapid ends at rest before another rapid.
    pub stop_between_rapids: bool,
    /// A cut ends at rest before a rapid.
    pub stop_after_cut: bool,
    /// Largest distance from a corner where no code names one; `None`: the control knows no
    /// such figure, and the machine file's `[motion] corner_tolerance` holds.
    pub rounding_mm: Option<f64>,
    /// Levels of smoothness (Haas G187 P1 to P3): the part of `rounding_mm` that each allows.
    pub level_parts: [f64; 3],
    /// The level in force when no code names one, 1 to 3.
    pub level: u8,
    /// The same distance in high-accuracy and look-ahead modes.
    pub look_ahead_mm: Option<f64>,
    /// Where short blocks become one curve.
    pub short_blocks: ShortBlocks,
    /// Trapezoids with junction deviation, where the control moves like that and not with limited jerk.
    pub junctions: Option<JunctionRules>,
    /// The spindle output drives a laser (GRBL's `$32=1`): another S in the block of a motion does not stop the axes.
    pub laser_mode: bool,
}

impl PathRules {
    /// Rapids with an in-position check, cuts that run into each other.
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

    /// The distance that a level of smoothness allows, mm.
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
