//! What a control does at the ends of moves, as data: the mode it starts with, the tolerances
//! of the modes that round corners, and where it comes to rest whatever the mode.

use chordal_machine::SettingValue;

use crate::choices::{Choices, SWITCH, choose, mm_text, name_of};
use crate::command::PathMode;
use crate::parameters::Parameters;
use crate::settings::{Certainty, Field, Setting, setting};

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
    };

    /// The distance that a level of smoothness allows, mm.
    pub fn of_level(&self, level: u8) -> Option<f64> {
        let part = self.level_parts[usize::from(level.clamp(1, 3)) - 1];
        self.rounding_mm.map(|mm| mm * part)
    }

    /// The path mode of a program's first block.
    pub fn start_mode(&self) -> PathMode {
        match self.start {
            StartMode::Continuous => {
                PathMode::Continuous { tolerance_mm: self.of_level(self.level) }
            }
            StartMode::ExactPath => PathMode::ExactPath,
            StartMode::ExactStop => PathMode::ExactStop,
        }
    }
}

/// The path mode of a run: what the codes of each kind have set.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct PathState {
    /// By G61, G64 and their like.
    mode: PathMode,
    /// The distance that G187, G05.1 and their like have set, mm.
    distance_mm: Option<f64>,
    /// This block ends at rest (G9).
    pub once: bool,
}

impl PathState {
    pub fn new(rules: &PathRules) -> PathState {
        PathState { mode: rules.start_mode(), distance_mm: None, once: false }
    }

    /// The mode in force, the present block's own stop included.
    pub fn in_force(&self) -> PathMode {
        match self.mode {
            _ if self.once => PathMode::ExactStop,
            PathMode::Continuous { tolerance_mm } => {
                PathMode::Continuous { tolerance_mm: self.distance_mm.or(tolerance_mm) }
            }
            mode => mode,
        }
    }

    /// A code of the family of G61 and G64.
    pub fn set_mode(&mut self, mode: PathMode) {
        self.mode = mode;
    }

    /// A code that sets the distance apart from the mode; `None` takes it back.
    pub fn set_distance(&mut self, distance_mm: Option<f64>) {
        self.distance_mm = distance_mm;
    }
}

/// The rule that a setting changes.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
#[allow(missing_docs, reason = "each names a field of `PathRules`")]
pub enum PathField {
    Start,
    StopBeforeCut,
    StopBetweenRapids,
    StopAfterCut,
    Rounding,
    /// The part of a level, 1 to 3.
    LevelPart(u8),
    Level,
    LookAhead,
}

const STARTS: Choices<StartMode> = &[
    ("continuous", StartMode::Continuous),
    ("exact-path", StartMode::ExactPath),
    ("exact-stop", StartMode::ExactStop),
];
const LEVELS: Choices<u8> =
    &[("rough", 1), ("medium", 2), ("finish", 3), ("1", 1), ("2", 2), ("3", 3)];

/// The settings that every control has, under plain names.
pub const COMMON: &[Setting] = &[
    plain(
        "start_path_mode",
        PathField::Start,
        "path mode at power-on: `continuous`, `exact-path` or `exact-stop`",
        Certainty::Trade,
    ),
    plain(
        "stop_before_cut",
        PathField::StopBeforeCut,
        "a rapid ends at rest before a cut: `on` or `off`",
        Certainty::Trade,
    ),
    plain(
        "stop_between_rapids",
        PathField::StopBetweenRapids,
        "a rapid ends at rest before another rapid: `on` or `off`",
        Certainty::Unknown,
    ),
    plain(
        "stop_after_cut",
        PathField::StopAfterCut,
        "a cut ends at rest before a rapid: `on` or `off`",
        Certainty::Unknown,
    ),
];

/// The distance in G64, of controls that name none.
pub const CORNER_ROUNDING: Setting = setting(
    "corner rounding",
    Field::Path(PathField::Rounding),
    &[],
    "how far from a corner the tool passes in G64; `none`: `[motion] corner_tolerance`",
    Certainty::Unknown,
    "G64",
);

const fn plain(
    name: &'static str,
    field: PathField,
    text: &'static str,
    certainty: Certainty,
) -> Setting {
    Setting { name, field: Field::Path(field), values: &[], text, certainty, source: "" }
}

/// Sets one rule; the error says what it takes.
pub(crate) fn set(
    p: &mut Parameters,
    field: PathField,
    word: &str,
    value: &SettingValue,
) -> Result<(), String> {
    let length = || match value.as_length_mm() {
        Ok(mm) if mm >= 0.0 => Ok(mm),
        _ => Err("a length with its unit, such as \"0.05 mm\", or `none`".to_string()),
    };
    let optional = || if word.eq_ignore_ascii_case("none") { Ok(None) } else { length().map(Some) };
    let rules = &mut p.path;
    match field {
        PathField::Start => rules.start = choose(word, STARTS)?,
        PathField::StopBeforeCut => rules.stop_before_cut = choose(word, SWITCH)?,
        PathField::StopBetweenRapids => rules.stop_between_rapids = choose(word, SWITCH)?,
        PathField::StopAfterCut => rules.stop_after_cut = choose(word, SWITCH)?,
        PathField::Rounding => rules.rounding_mm = optional()?,
        PathField::LevelPart(level) => {
            let part = match value {
                SettingValue::Integer(number) => *number as f64,
                SettingValue::Float(number) => *number,
                _ => f64::NAN,
            };
            if !(part > 0.0 && part <= 10.0) {
                return Err("a number above 0, at most 10".to_string());
            }
            rules.level_parts[usize::from(level.clamp(1, 3)) - 1] = part;
        }
        PathField::Level => rules.level = choose(word, LEVELS)?,
        PathField::LookAhead => rules.look_ahead_mm = optional()?,
    }
    Ok(())
}

/// The present value of a rule, as a machine file writes it.
pub(crate) fn value_text(p: &Parameters, field: PathField) -> String {
    let rules = &p.path;
    let optional = |mm: Option<f64>| mm.map_or("none".to_string(), mm_text);
    match field {
        PathField::Start => name_of(rules.start, STARTS),
        PathField::StopBeforeCut => name_of(rules.stop_before_cut, SWITCH),
        PathField::StopBetweenRapids => name_of(rules.stop_between_rapids, SWITCH),
        PathField::StopAfterCut => name_of(rules.stop_after_cut, SWITCH),
        PathField::Rounding => optional(rules.rounding_mm),
        PathField::LevelPart(level) => {
            rules.level_parts[usize::from(level.clamp(1, 3)) - 1].to_string()
        }
        PathField::Level => name_of(rules.level, LEVELS),
        PathField::LookAhead => optional(rules.look_ahead_mm),
    }
}
