//! Settings of a machine file: the parameters of the control under their own names.

mod choices;
mod compensation;
mod cycle;
mod field;
mod frame;
mod general;
mod length;
mod path_mode;
mod rotary_feed;
mod turning;

use chordal_command::RapidPath;
use chordal_kernel::SettingError;
use chordal_machine::{Machine, SettingEntry, SettingValue};

pub use self::field::SettingField;
use self::field::{SettingInput, switch_text};
pub(crate) use self::path_mode::{CORNER_ROUNDING, short_blocks};
use crate::parameters::*;

/// How certain a fact about a control is.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum Certainty {
    /// A manual says so.
    Documented,
    /// Inferred from examples, or computed.
    Inferred,
    /// Seen in practice, such as in post-processors, but in no manual.
    Practice,
    /// Not known: the value is a choice.
    Unknown,
}

/// A row of a control's table of settings.
#[derive(Clone, Copy, Debug)]
pub struct Setting {
    /// The name in the manual, or a common name that all controls share.
    pub name: &'static str,
    /// The parameter that it sets.
    pub field: SettingField,
    /// The control's own words for values, each with the common word that it stands for (`"1"` → `"plane"`); empty
    /// where common words or quantities are used.
    pub values: &'static [(&'static str, &'static str)],
    /// What it does, for users.
    pub text: &'static str,
    /// How certain the default is.
    pub certainty: Certainty,
    /// Manual and section.
    pub source: &'static str,
}

/// The settings of every control, under common names.
pub const COMMON: &[Setting] = &{
    const COMPENSATION: usize = GENERAL.len();
    const PATH: usize = COMPENSATION + compensation::COMMON.len();
    const LENGTH: usize = PATH + path_mode::COMMON.len();
    let mut all = [GENERAL[0]; LENGTH + length::COMMON.len()];
    let mut at = 0;
    while at < all.len() {
        all[at] = if at < COMPENSATION {
            GENERAL[at]
        } else if at < PATH {
            compensation::COMMON[at - COMPENSATION]
        } else if at < LENGTH {
            path_mode::COMMON[at - PATH]
        } else {
            length::COMMON[at - LENGTH]
        };
        at += 1;
    }
    all
};

const GENERAL: &[Setting] = &[
    common("units", SettingField::UNITS, "units at power-on: `inch` or `mm`"),
    common("start_motion", SettingField::START_MOTION, "motion at power-on: `rapid` or `linear`"),
    common(
        "start_distance",
        SettingField::START_DISTANCE,
        "`absolute` or `incremental` at power-on",
    ),
    common(
        "decimal_point",
        SettingField::DECIMAL_POINT,
        "a number without a point: `least-increment` (X10 is 0.001 in) or `calculator` (X10 is ten)",
    ),
    common(
        "excess_decimals",
        SettingField::EXCESS_DECIMALS,
        "decimals beyond the least increment (X1.23456 in inch): `cut`, `rounded`, `exact`, or `unknown` (exact, with a note)",
    ),
    common(
        "spindle_at_tool_change",
        SettingField::SPINDLE_AT_TOOL_CHANGE,
        "a tool change (M6, or T of a turret) stops the spindle (`stops`), or it turns on (`turns`)",
    ),
    common(
        "most_digits",
        SettingField::MOST_DIGITS,
        "largest number of digits of a length; 0 for no limit",
    ),
    common(
        "feed_digits_inch",
        SettingField::FEED_DIGITS,
        "decimals of an inch F written without a point",
    ),
    common(
        "arc_center",
        SettingField::ARC_CENTER,
        "I J K: `from-start`, `absolute` or `from-center`",
    ),
    common(
        "plane_codes",
        SettingField::PLANE_CODES,
        "`standard`, or `swapped` (G18 is YZ, G19 is ZX)",
    ),
    common(
        "radius_error_tolerance",
        SettingField::RADIUS_ERROR_TOLERANCE,
        "largest difference of an arc's radii at start and end",
    ),
    common(
        "arc_mismatch",
        SettingField::ARC_MISMATCH,
        "within the tolerance: `spiral` to the end, or `arc-then-line`",
    ),
    common(
        "semicircle_tolerance",
        SettingField::SEMICIRCLE_TOLERANCE,
        "chord - 2R up to here puts the centre in the middle of the chord, as where R is rounded: a length, or `two-increments` (0.0002 in, 0.002 mm)",
    ),
    common(
        "near_semicircle",
        SettingField::NEAR_SEMICIRCLE,
        "2R longer than the chord by no more than `semicircle_tolerance`: the centre is `computed`, or in the `middle` of the chord",
    ),
    common(
        "helix_feed",
        SettingField::HELIX_FEED,
        "F of a helix along the `path` or in the `plane`",
    ),
    common(
        "rotary_feed",
        SettingField::ROTARY_FEED_MEASURE,
        "F of a line with rotary axes counts `linear-axes`, all axes with `degrees-as-units` or `degrees-as-mm`, or all axes `on-diameter`",
    ),
    common(
        "rotary_diameter_4th",
        SettingField::ROTARY_FEED_FOURTH_DIAMETER,
        "diameter on which F `on-diameter` counts A, or B where there is no A",
    ),
    common(
        "rotary_diameter_5th",
        SettingField::ROTARY_FEED_FIFTH_DIAMETER,
        "diameter on which F `on-diameter` counts C, or B where there is an A",
    ),
    common(
        "spiral",
        SettingField::SPIRAL,
        "spiral commands: `none`, `pitches`, `increment-height-count` or `increment-count`",
    ),
    common(
        "spiral_on_ray",
        SettingField::SPIRAL_ON_RAY,
        "a spiral with L whose start and end are on one ray from the centre: L1 is `no-turn` or a `full-turn`",
    ),
    common(
        "rotary_in_arc",
        SettingField::ROTARY_IN_ARC,
        "a rotary axis in the block of an arc: `allowed` or `refused`",
    ),
    common(
        "omitted_center",
        SettingField::OMITTED_CENTER,
        "a missing centre word, where centres are coordinates: that of the `start`, or `zero`",
    ),
    common(
        "machine_move",
        SettingField::MACHINE_MOVE,
        "a move of G53 is a `rapid`, or uses the active motion code (`in-force`)",
    ),
    common(
        "rapid_disarms_arc",
        SettingField::RAPID_CANCELS_ARC,
        "G0 cancels the direction that G2 or G3 gave, where they only give a direction: `on` or `off`",
    ),
    common(
        "spiral_end_tolerance",
        SettingField::SPIRAL_END_TOLERANCE,
        "largest distance of a computed spiral end from the programmed one",
    ),
    common(
        "center_and_radius",
        SettingField::CENTER_AND_RADIUS,
        "both in a block: `radius-wins` or `refused`",
    ),
    common(
        "full_circle_by_radius",
        SettingField::FULL_CIRCLE_BY_RADIUS,
        "`refused`, `no-motion` or `straight`",
    ),
    common("rapid", SettingField::RAPID, "rapids: `dog-leg` or `straight`"),
    common("max_radius", SettingField::MAX_RADIUS, "largest radius of an arc"),
    common(
        "max_radius_compensated",
        SettingField::MAX_RADIUS_COMPENSATED,
        "largest radius of an arc with cutter compensation",
    ),
    common(
        "radius_offsets",
        SettingField::RADIUS_OFFSETS,
        "the offset table holds `diameter` or `radius`",
    ),
    common(
        "outside_corner",
        SettingField::OUTSIDE_CORNER,
        "outside corners with compensation: `linear` or `arc`",
    ),
    common(
        "compensation_entry",
        SettingField::COMPENSATION_ENTRY,
        "start and end of compensation: `A`, `B` or `contour`",
    ),
    common("nesting", SettingField::NESTING, "largest number of nested calls"),
    common("chip_break", SettingField::CHIP_BREAK, "lift of a chip-breaking peck (G73)"),
    common(
        "peck_clearance",
        SettingField::PECK_CLEARANCE,
        "clearance of a full-retract peck (G83)",
    ),
];

const fn common(name: &'static str, field: SettingField, text: &'static str) -> Setting {
    Setting { name, field, values: &[], text, certainty: Certainty::Documented, source: "" }
}

/// A row of a control's own settings.
pub const fn setting(
    name: &'static str,
    field: SettingField,
    values: &'static [(&'static str, &'static str)],
    text: &'static str,
    certainty: Certainty,
    source: &'static str,
) -> Setting {
    Setting { name, field, values, text, certainty, source }
}

/// The setting of a name, regardless of case: the control's own, otherwise the common one. `None` if there is
/// neither.
pub fn find<'t>(own: &'t [Setting], name: &str) -> Option<&'t Setting> {
    own.iter().chain(COMMON).find(|setting| setting.name.eq_ignore_ascii_case(name))
}

/// The parameters of a machine: those of the table, changed by the settings of the machine file; an error for each setting that was refused.
pub fn resolve(
    own: &[Setting],
    table: &Parameters,
    machine: &Machine,
) -> (Parameters, Vec<SettingError>) {
    let mut parameters = *table;
    if let Some(shape) = machine.rapid {
        parameters.rules.rapid = match shape {
            chordal_machine::RapidShape::DogLeg => RapidPath::DogLeg,
            chordal_machine::RapidShape::Straight => RapidPath::Straight,
        };
    }
    parameters.rules.rotary_feed.has_a = machine.axes[3].is_some();
    let mut errors = Vec::new();
    for (name, entry) in &machine.settings {
        if let Err(error) = apply(own, &mut parameters, name, entry) {
            errors.push(error);
        }
    }
    (parameters, errors)
}

/// The Jaro–Winkler similarity from which a name is suggested for a misspelt one: 0 for unlike names, 1 for equal ones.
const MIN_NAME_SIMILARITY: f64 = 0.8;

fn apply(
    own: &[Setting],
    parameters: &mut Parameters,
    name: &str,
    entry: &SettingEntry,
) -> Result<(), SettingError> {
    let refuse = |message: String, help: Option<String>| SettingError {
        name: name.to_string(),
        message,
        help,
    };
    let Some(setting) = find(own, name) else {
        let similar = own
            .iter()
            .chain(COMMON)
            .map(|setting| (strsim::jaro_winkler(setting.name, name), setting.name))
            .filter(|(similarity, _)| *similarity > MIN_NAME_SIMILARITY)
            .max_by(|a, b| a.0.total_cmp(&b.0));
        return Err(refuse(
            format!("this control has no setting `{name}`"),
            similar.map(|(_, similar)| format!("did you mean `{similar}`?")),
        ));
    };
    let written = value_text(&entry.value);
    let word = setting
        .values
        .iter()
        .find(|(own_word, _)| own_word.eq_ignore_ascii_case(&written))
        .map_or(written.as_str(), |(_, word)| word);
    let input = SettingInput { word, value: &entry.value, index: setting.field.index };
    (setting.field.set)(parameters, &input).map_err(|target| {
        refuse(format!("`{name}` cannot be `{written}`"), Some(format!("it takes {target}")))
    })
}

fn value_text(value: &SettingValue) -> String {
    match value {
        SettingValue::Text(text) => text.clone(),
        SettingValue::Integer(number) => number.to_string(),
        SettingValue::Float(number) => number.to_string(),
        SettingValue::Bool(flag) => switch_text(*flag),
    }
}
