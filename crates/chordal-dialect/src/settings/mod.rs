//! Settings of a machine file: the control's own parameters under their own names.

mod choices;
mod compensation;
mod cycle;
mod frame;
mod general;
mod length;
mod path_mode;
mod rotary_feed;
mod turning;

use chordal_command::{FeedAlong, RapidPath, Units};
use chordal_kernel::rules::*;
use chordal_machine::{Machine, SettingEntry as Given, SettingValue};

use self::choices::{choose, mm_text, name_of};
pub use self::compensation::CompensationField;
pub use self::cycle::CycleField;
pub use self::frame::FrameField;
use self::general::*;
pub use self::length::LengthField;
pub use self::path_mode::PathField;
pub(crate) use self::path_mode::{CORNER_ROUNDING, short_blocks};
pub use self::rotary_feed::RotaryFeedField;
pub use self::turning::TurningField;
use crate::firmware::BuildOption;
use crate::parameters::*;

/// How sure a default is.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum Certainty {
    /// A manual says so.
    Documented,
    /// Inferred from examples or computed.
    Inferred,
    /// Known in the trade, no text found.
    Trade,
    /// Not known: the value is a choice.
    Unknown,
}

/// The parameter that a setting changes.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
#[allow(missing_docs, reason = "each names a field of `Parameters`")]
pub enum SettingField {
    Units,
    StartMotion,
    StartDistance,
    DecimalPoint,
    FeedDigits,
    ArcCenter,
    PlaneCodes,
    RadiusErrorTolerance,
    ArcMismatch,
    SemicircleTolerance,
    NearSemicircle,
    ExcessDecimals,
    /// Whether a tool change stops the spindle.
    SpindleAtToolChange,
    MostDigits,
    HelixFeed,
    Spiral,
    SpiralEndTolerance,
    SpiralOnRay,
    RotaryInArc,
    OmittedCenter,
    MachineMove,
    RapidDisarmsArc,
    CenterAndRadius,
    FullCircleByRadius,
    /// A block of an arc without a centre and without a radius (Fanuc No. 3403#5).
    ArcWithoutCenter,
    Rapid,
    RapidFeed,
    PowerLetter,
    MaxRadius,
    MaxRadiusCompensated,
    RadiusOffsets,
    OutsideCorner,
    CompensationEntry,
    LengthByHAlone,
    Nesting,
    PackedCalls,
    ChipBreak,
    PeckClearance,
    LengthMustMatchTool,
    UnitCodes,
    ReturnLabelInCallee,
    PocketStepover,
    FixedRoutineCount,
    BoreDiameterRegister,
    Cycle(CycleField),
    Compensation(CompensationField),
    Path(PathField),
    Frame(FrameField),
    /// F with rotary axes.
    RotaryFeed(RotaryFeedField),
    Turning(TurningField),
    /// Tool lengths.
    Length(LengthField),
    /// What words of X are at power-on (LinuxCNC G7, G8).
    StartRadii,
    /// What words of X are in polar interpolation.
    FaceX,
    /// Which P of M3, M4 and M5 names the live tool.
    LiveToolP,
    /// Which P of M3 and M4 names the second spindle.
    SecondSpindleP,
    /// The first M code that waits for another path, and the last.
    WaitCode {
        last: bool,
    },
    /// What happens after a block that the control refuses (GRBL).
    AfterRefusal,
    /// Who changes tools (GRBL).
    ToolChanger,
    /// Whether the build of its firmware has something.
    Build(BuildOption),
    /// Which system of G codes (Fanuc lathes No. 3401).
    CodeSystem,
    /// What the time of G4 counts in (Mach3).
    DwellUnit,
    MacroAngles,
    /// What the old numbers of tool offsets are.
    OffsetMemory,
    /// A G code that calls a macro, by its place.
    AliasG(u8),
    /// An M code that does.
    AliasM(u8),
    /// An M code that calls a subprogram.
    AliasSubprogram(u8),
}

/// A setting of a control's table.
#[derive(Clone, Copy, Debug)]
pub struct Setting {
    /// The name in the manual, or a plain one that all controls share.
    pub name: &'static str,
    /// What it changes.
    pub field: SettingField,
    /// Each value's own word and the common word it stands for (`"1"` → `"plane"`); empty
    /// where the common words or a quantity are written.
    pub values: &'static [(&'static str, &'static str)],
    /// What it does.
    pub text: &'static str,
    /// How sure the default is.
    pub certainty: Certainty,
    /// Manual and section.
    pub source: &'static str,
}

/// The settings that every control has, under plain names.
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
    common("units", SettingField::Units, "units at power-on: `inch` or `mm`"),
    common("start_motion", SettingField::StartMotion, "motion at power-on: `rapid` or `linear`"),
    common(
        "start_distance",
        SettingField::StartDistance,
        "`absolute` or `incremental` at power-on",
    ),
    common(
        "decimal_point",
        SettingField::DecimalPoint,
        "a number without a point: `least-increment` (X10 is 0.001 in) or `calculator` (X10 is ten)",
    ),
    common(
        "excess_decimals",
        SettingField::ExcessDecimals,
        "decimals beyond the least increment (X1.23456 in inch): `cut`, `rounded`, `exact`, or `unknown` (exact, with a note)",
    ),
    common(
        "spindle_at_tool_change",
        SettingField::SpindleAtToolChange,
        "a tool change (M6, or T of a turret) stops the spindle (`stops`), or it turns on (`turns`)",
    ),
    common(
        "most_digits",
        SettingField::MostDigits,
        "largest number of digits of a length; 0 for no limit",
    ),
    common(
        "feed_digits_inch",
        SettingField::FeedDigits,
        "decimals of an inch F written without a point",
    ),
    common(
        "arc_center",
        SettingField::ArcCenter,
        "I J K: `from-start`, `absolute` or `from-center`",
    ),
    common(
        "plane_codes",
        SettingField::PlaneCodes,
        "`standard`, or `swapped` (G18 is YZ, G19 is ZX)",
    ),
    common(
        "radius_error_tolerance",
        SettingField::RadiusErrorTolerance,
        "largest difference of an arc's radii at start and end",
    ),
    common(
        "arc_mismatch",
        SettingField::ArcMismatch,
        "within the tolerance: `spiral` to the end, or `arc-then-line`",
    ),
    common(
        "semicircle_tolerance",
        SettingField::SemicircleTolerance,
        "chord - 2R up to here puts the centre in the middle of the chord, as where R is rounded: a length, or `two-increments` (0.0002 in, 0.002 mm)",
    ),
    common(
        "near_semicircle",
        SettingField::NearSemicircle,
        "2R longer than the chord by no more than `semicircle_tolerance`: the centre is `computed`, or in the `middle` of the chord",
    ),
    common(
        "helix_feed",
        SettingField::HelixFeed,
        "F of a helix along the `path` or in the `plane`",
    ),
    common(
        "rotary_feed",
        SettingField::RotaryFeed(RotaryFeedField::Measure),
        "F of a line with rotary axes counts `linear-axes`, all axes with `degrees-as-units` or `degrees-as-mm`, or all axes `on-diameter`",
    ),
    common(
        "rotary_diameter_4th",
        SettingField::RotaryFeed(RotaryFeedField::FourthDiameter),
        "diameter on which F `on-diameter` counts A, or B where there is no A",
    ),
    common(
        "rotary_diameter_5th",
        SettingField::RotaryFeed(RotaryFeedField::FifthDiameter),
        "diameter on which F `on-diameter` counts C, or B where there is an A",
    ),
    common(
        "spiral",
        SettingField::Spiral,
        "spiral commands: `none`, `pitches`, `increment-height-count` or `increment-count`",
    ),
    common(
        "spiral_on_ray",
        SettingField::SpiralOnRay,
        "a spiral with L whose start and end are on one ray from the centre: L1 is `no-turn` or a `full-turn`",
    ),
    common(
        "rotary_in_arc",
        SettingField::RotaryInArc,
        "a rotary axis in the block of an arc: `allowed` or `refused`",
    ),
    common(
        "omitted_center",
        SettingField::OmittedCenter,
        "a missing centre word, where centres are coordinates: that of the `start`, or `zero`",
    ),
    common(
        "machine_move",
        SettingField::MachineMove,
        "a move of G53 is a `rapid`, or uses the active motion code (`in-force`)",
    ),
    common(
        "rapid_disarms_arc",
        SettingField::RapidDisarmsArc,
        "G0 cancels the direction that G2 or G3 gave, where they only give a direction: `on` or `off`",
    ),
    common(
        "spiral_end_tolerance",
        SettingField::SpiralEndTolerance,
        "largest distance of a computed spiral end from the programmed one",
    ),
    common(
        "center_and_radius",
        SettingField::CenterAndRadius,
        "both in a block: `radius-wins` or `refused`",
    ),
    common(
        "full_circle_by_radius",
        SettingField::FullCircleByRadius,
        "`refused`, `no-motion` or `straight`",
    ),
    common("rapid", SettingField::Rapid, "rapids: `dog-leg` or `straight`"),
    common("max_radius", SettingField::MaxRadius, "largest radius of an arc"),
    common(
        "max_radius_compensated",
        SettingField::MaxRadiusCompensated,
        "largest radius of an arc with cutter compensation",
    ),
    common(
        "radius_offsets",
        SettingField::RadiusOffsets,
        "the offset table holds `diameter` or `radius`",
    ),
    common(
        "outside_corner",
        SettingField::OutsideCorner,
        "outside corners with compensation: `linear` or `arc`",
    ),
    common(
        "compensation_entry",
        SettingField::CompensationEntry,
        "start and end of compensation: `A`, `B` or `contour`",
    ),
    common("nesting", SettingField::Nesting, "largest number of nested calls"),
    common("chip_break", SettingField::ChipBreak, "lift of a chip-breaking peck (G73)"),
    common("peck_clearance", SettingField::PeckClearance, "clearance of a full-retract peck (G83)"),
];

const fn common(name: &'static str, field: SettingField, text: &'static str) -> Setting {
    Setting { name, field, values: &[], text, certainty: Certainty::Documented, source: "" }
}

/// Writes a row of a control's own settings.
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

/// Why a setting was refused.
#[derive(Clone, Debug, PartialEq)]
pub struct SettingError {
    /// Its name in the machine file.
    pub name: String,
    /// What is wrong.
    pub message: String,
    /// What to write.
    pub help: Option<String>,
}

/// The setting of a table by name, without regard to case.
pub fn find<'t>(own: &'t [Setting], name: &str) -> Option<&'t Setting> {
    own.iter().chain(COMMON).find(|setting| setting.name.eq_ignore_ascii_case(name))
}

/// The parameters of a machine: the table's, changed by the machine file's settings.
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
    for (name, provided) in &machine.settings {
        if let Err(error) = apply(own, &mut parameters, name, provided) {
            errors.push(error);
        }
    }
    (parameters, errors)
}

fn apply(
    own: &[Setting],
    parameters: &mut Parameters,
    name: &str,
    context: &Given,
) -> Result<(), SettingError> {
    let refuse = |message: String, help: Option<String>| SettingError {
        name: name.to_string(),
        message,
        help,
    };
    let Some(setting) = find(own, name) else {
        let near = own
            .iter()
            .chain(COMMON)
            .map(|setting| (strsim::jaro_winkler(setting.name, name), setting.name))
            .filter(|(likeness, _)| *likeness > 0.8)
            .max_by(|a, b| a.0.total_cmp(&b.0));
        return Err(refuse(
            format!("this control has no setting `{name}`"),
            near.map(|(_, near)| format!("did you mean `{near}`?")),
        ));
    };
    let written = shown(&context.value);
    let word = setting
        .values
        .iter()
        .find(|(own_word, _)| own_word.eq_ignore_ascii_case(&written))
        .map_or(written.as_str(), |(_, word)| word);
    set(parameters, setting.field, word, &context.value).map_err(|target| {
        refuse(format!("`{name}` cannot be `{written}`"), Some(format!("it takes {target}")))
    })
}

fn shown(value: &SettingValue) -> String {
    match value {
        SettingValue::Text(text) => text.clone(),
        SettingValue::Integer(number) => number.to_string(),
        SettingValue::Float(number) => number.to_string(),
        SettingValue::Bool(flag) => if *flag { "on" } else { "off" }.to_string(),
    }
}

/// Sets one parameter; the error says what it takes.
fn set(
    p: &mut Parameters,
    field: SettingField,
    word: &str,
    value: &SettingValue,
) -> Result<(), String> {
    let length = || {
        value
            .as_length_mm()
            .map_err(|_| "a length with its unit, such as \"0.0005 in\"".to_string())
    };
    let count = || match value {
        SettingValue::Integer(number) if (0..=100_000).contains(number) => Ok(*number as u32),
        _ => Err("a whole number".to_string()),
    };
    let flag = || match word {
        "on" | "1" | "true" => Ok(true),
        "off" | "0" | "false" => Ok(false),
        _ => Err("`on` or `off`".to_string()),
    };
    match field {
        SettingField::Units => {
            p.rules.units = choose(word, &[("inch", Units::Inch), ("mm", Units::Millimetre)])?
        }
        SettingField::StartMotion => {
            p.rules.starts_linear = choose(word, &[("rapid", false), ("linear", true)])?
        }
        SettingField::StartDistance => {
            p.rules.starts_incremental =
                choose(word, &[("absolute", false), ("incremental", true)])?;
        }
        SettingField::DecimalPoint => p.decimal_point = choose(word, DECIMAL_POINTS)?,
        SettingField::FeedDigits => p.feed_digits_inch = count()?.min(6) as u8,
        SettingField::ArcCenter => p.rules.arc.arc_center = choose(word, ARC_CENTERS)?,
        SettingField::PlaneCodes => {
            p.plane_codes = choose(
                word,
                &[("standard", PlaneCodes::Standard), ("swapped", PlaneCodes::Swapped)],
            )?;
        }
        SettingField::RadiusErrorTolerance => p.rules.arc.radius_error_tolerance_mm = length()?,
        SettingField::ArcMismatch => {
            p.rules.arc.arc_mismatch = choose(
                word,
                &[("spiral", ArcMismatch::Spiral), ("arc-then-line", ArcMismatch::ArcThenLine)],
            )?;
        }
        SettingField::SemicircleTolerance if word == "two-increments" => {
            p.rules.arc.semicircle_tolerance_mm = None
        }
        SettingField::SemicircleTolerance => p.rules.arc.semicircle_tolerance_mm = Some(length()?),
        SettingField::NearSemicircle => {
            p.rules.arc.semicircle_of_long_radius = choose(word, NEAR_SEMICIRCLES)?;
        }
        SettingField::ExcessDecimals => p.excess_decimals = choose(word, EXCESS_DECIMALS)?,
        SettingField::SpindleAtToolChange => {
            p.rules.spindle_stops_at_tool_change = choose(word, SPINDLE_AT_TOOL_CHANGE)?;
        }
        SettingField::MostDigits => p.most_digits = count()?.min(18) as u8,
        SettingField::HelixFeed => {
            p.rules.arc.helix_feed =
                choose(word, &[("path", FeedAlong::Path), ("plane", FeedAlong::Plane)])?;
        }
        SettingField::Spiral => p.rules.arc.spiral = choose(word, SPIRALS)?,
        SettingField::SpiralEndTolerance => p.rules.arc.spiral_end_tolerance_mm = length()?,
        SettingField::SpiralOnRay => p.rules.arc.spiral_on_ray = choose(word, SPIRAL_ON_RAY)?,
        SettingField::RotaryInArc => p.rules.arc.rotary_in_arc = choose(word, ROTARY_IN_ARC)?,
        SettingField::OmittedCenter => p.rules.arc.omitted_center = choose(word, OMITTED_CENTER)?,
        SettingField::MachineMove => p.rules.machine_move_is_rapid = choose(word, MACHINE_MOVES)?,
        SettingField::RapidDisarmsArc => p.rapid_disarms_arc = flag()?,
        SettingField::CenterAndRadius => {
            p.center_and_radius = choose(
                word,
                &[
                    ("radius-wins", CenterAndRadius::RadiusWins),
                    ("refused", CenterAndRadius::Refused),
                ],
            )?;
        }
        SettingField::ArcWithoutCenter => {
            p.arc_without_center_is_line = choose(word, ARCS_WITHOUT_CENTER)?;
        }
        SettingField::FullCircleByRadius => {
            p.rules.arc.full_circle_by_radius = choose(word, FULL_CIRCLES_BY_RADIUS)?;
        }
        SettingField::Rapid => {
            p.rules.rapid =
                choose(word, &[("dog-leg", RapidPath::DogLeg), ("straight", RapidPath::Straight)])?;
        }
        SettingField::RapidFeed => {
            p.rules.rapid_feed = match (word, value) {
                ("programmed", _) => RapidFeed::Programmed,
                (_, SettingValue::Integer(speed @ 1..=1_000_000)) => {
                    RapidFeed::Fixed(*speed as f64 / 60.0)
                }
                (_, SettingValue::Float(speed)) if *speed > 0.0 && *speed < 1e6 => {
                    RapidFeed::Fixed(*speed / 60.0)
                }
                _ => return Err("a feed in mm/min, or `programmed`".to_string()),
            };
        }
        SettingField::PowerLetter => p.power_letter = flag()?.then_some(b'P'),
        SettingField::MaxRadius => p.rules.arc.max_radius_mm = length()?,
        SettingField::MaxRadiusCompensated => p.rules.arc.max_radius_compensated_mm = length()?,
        SettingField::RadiusOffsets => {
            p.rules.radius_offsets = choose(
                word,
                &[("diameter", OffsetKind::Diameter), ("radius", OffsetKind::Radius)],
            )?;
        }
        SettingField::OutsideCorner => p.rules.outside_corner = choose(word, OUTSIDE_CORNERS)?,
        SettingField::CompensationEntry => {
            p.rules.compensation_entry = choose(word, COMPENSATION_ENTRIES)?
        }
        SettingField::LengthByHAlone => p.length_by_h_alone = flag()?,
        SettingField::Nesting => p.nesting = count()?.clamp(1, 100),
        SettingField::PackedCalls => p.packed_calls = flag()?,
        SettingField::ChipBreak => p.rules.chip_break_mm = length()?,
        SettingField::PeckClearance => p.rules.peck_clearance_mm = length()?,
        SettingField::LengthMustMatchTool => p.length_must_match_tool = flag()?,
        SettingField::UnitCodes => p.unit_codes = choose(word, UNIT_CODES)?,
        SettingField::ReturnLabelInCallee => p.return_label_in_callee = flag()?,
        SettingField::PocketStepover if word == "no limit" => {
            p.rules.pocket_stepover_mm = f64::INFINITY
        }
        SettingField::PocketStepover => {
            p.rules.pocket_stepover_mm = length().and_then(|step| match step > 0.0 {
                true => Ok(step),
                false => Err("a length above zero, or `no limit`".to_string()),
            })?;
        }
        SettingField::FixedRoutineCount => p.fixed_routine_count = choose(word, ROUTINE_COUNTS)?,
        SettingField::BoreDiameterRegister => p.bore_diameter_register = choose(word, REGISTERS)?,
        SettingField::Cycle(rule) => cycle::set(p, rule, word, value)?,
        SettingField::Compensation(rule) => compensation::set(p, rule, word, value)?,
        SettingField::Path(rule) => path_mode::set(p, rule, word, value)?,
        SettingField::Frame(rule) => frame::set(p, rule, word, value)?,
        SettingField::RotaryFeed(rule) => rotary_feed::set(p, rule, word, length)?,
        SettingField::Turning(rule) => turning::set(p, rule, word, value)?,
        SettingField::Length(rule) => length::set(p, rule, word)?,
        SettingField::StartRadii => p.starts_with_radii = choose(word, X_WORDS)?,
        SettingField::FaceX => p.face_x_radius = choose(word, X_WORDS)?,
        SettingField::LiveToolP => p.live_tool_p = count()?,
        SettingField::SecondSpindleP => p.second_spindle_p = count()?,
        SettingField::WaitCode { last } => p.wait_codes[usize::from(last)] = count()?,
        SettingField::OffsetMemory => p.offset_memory = choose(word, OFFSET_MEMORIES)?,
        SettingField::ToolChanger => p.tool_change = choose(word, TOOL_CHANGERS)?,
        SettingField::Build(option) => *p.build.option_mut(option) = flag()?,
        SettingField::AfterRefusal => p.goes_on_after_refusal = choose(word, AFTER_REFUSAL)?,
        SettingField::CodeSystem => {
            p.code_system = choose(word, CODE_SYSTEMS)?;
            // Inch and millimetres are G70 and G71 in C.
            p.unit_codes = if p.code_system == 2 { UnitCodes::G70 } else { UnitCodes::G20 };
            let example = if p.code_system == 0 { "G50 S2500" } else { "G92 S2500" };
            p.rules.turning.speed_limit_example = example;
        }
        SettingField::DwellUnit => p.dwell_factor = choose(word, DWELL_UNITS)?,
        SettingField::MacroAngles => {
            p.macro_angles_full_circle = choose(word, MACRO_ANGLES)?;
        }
        SettingField::AliasG(_) | SettingField::AliasM(_) | SettingField::AliasSubprogram(_) => {
            let code = count()?.min(6000) as u16;
            p.aliases.any |= code > 0;
            match field {
                SettingField::AliasG(at) => p.aliases.g[at as usize] = code,
                SettingField::AliasM(at) => p.aliases.m[at as usize] = code,
                SettingField::AliasSubprogram(at) => p.aliases.m_subprogram[at as usize] = code,
                _ => {}
            }
        }
    }
    Ok(())
}

/// The present value of a parameter, as a machine file writes it.
pub fn value_text(p: &Parameters, field: SettingField) -> String {
    let on = |flag: bool| if flag { "on" } else { "off" }.to_string();
    match field {
        SettingField::Units => if p.rules.units == Units::Inch { "inch" } else { "mm" }.into(),
        SettingField::StartMotion => if p.rules.starts_linear { "linear" } else { "rapid" }.into(),
        SettingField::StartDistance => {
            if p.rules.starts_incremental { "incremental" } else { "absolute" }.into()
        }
        SettingField::DecimalPoint => name_of(p.decimal_point, DECIMAL_POINTS),
        SettingField::FeedDigits => p.feed_digits_inch.to_string(),
        SettingField::ArcCenter => name_of(p.rules.arc.arc_center, ARC_CENTERS),
        SettingField::PlaneCodes => {
            if p.plane_codes == PlaneCodes::Standard { "standard" } else { "swapped" }.into()
        }
        SettingField::RadiusErrorTolerance => mm_text(p.rules.arc.radius_error_tolerance_mm),
        SettingField::ArcMismatch => {
            if p.rules.arc.arc_mismatch == ArcMismatch::Spiral { "spiral" } else { "arc-then-line" }
                .into()
        }
        SettingField::SemicircleTolerance => match p.rules.arc.semicircle_tolerance_mm {
            Some(tolerance) => mm_text(tolerance),
            None => "two-increments".into(),
        },
        SettingField::NearSemicircle => {
            name_of(p.rules.arc.semicircle_of_long_radius, NEAR_SEMICIRCLES)
        }
        SettingField::ExcessDecimals => name_of(p.excess_decimals, EXCESS_DECIMALS),
        SettingField::SpindleAtToolChange => {
            name_of(p.rules.spindle_stops_at_tool_change, SPINDLE_AT_TOOL_CHANGE)
        }
        SettingField::MostDigits => p.most_digits.to_string(),
        SettingField::HelixFeed => {
            if p.rules.arc.helix_feed == FeedAlong::Path { "path" } else { "plane" }.into()
        }
        SettingField::Spiral => name_of(p.rules.arc.spiral, SPIRALS),
        SettingField::SpiralEndTolerance => mm_text(p.rules.arc.spiral_end_tolerance_mm),
        SettingField::SpiralOnRay => name_of(p.rules.arc.spiral_on_ray, SPIRAL_ON_RAY),
        SettingField::RotaryInArc => name_of(p.rules.arc.rotary_in_arc, ROTARY_IN_ARC),
        SettingField::OmittedCenter => name_of(p.rules.arc.omitted_center, OMITTED_CENTER),
        SettingField::MachineMove => name_of(p.rules.machine_move_is_rapid, MACHINE_MOVES),
        SettingField::RapidDisarmsArc => on(p.rapid_disarms_arc),
        SettingField::CenterAndRadius => {
            let wins = p.center_and_radius == CenterAndRadius::RadiusWins;
            if wins { "radius-wins" } else { "refused" }.into()
        }
        SettingField::ArcWithoutCenter => {
            name_of(p.arc_without_center_is_line, ARCS_WITHOUT_CENTER)
        }
        SettingField::FullCircleByRadius => {
            name_of(p.rules.arc.full_circle_by_radius, FULL_CIRCLES_BY_RADIUS)
        }
        SettingField::Rapid => {
            if p.rules.rapid == RapidPath::DogLeg { "dog-leg" } else { "straight" }.into()
        }
        SettingField::RapidFeed => match p.rules.rapid_feed {
            RapidFeed::OfMachine => "machine".into(),
            RapidFeed::Programmed => "programmed".into(),
            RapidFeed::Fixed(speed) => (speed * 60.0).to_string(),
        },
        SettingField::PowerLetter => on(p.power_letter.is_some()),
        SettingField::MaxRadius => mm_text(p.rules.arc.max_radius_mm),
        SettingField::MaxRadiusCompensated => mm_text(p.rules.arc.max_radius_compensated_mm),
        SettingField::RadiusOffsets => {
            if p.rules.radius_offsets == OffsetKind::Diameter { "diameter" } else { "radius" }
                .into()
        }
        SettingField::OutsideCorner => name_of(p.rules.outside_corner, OUTSIDE_CORNERS),
        SettingField::CompensationEntry => {
            name_of(p.rules.compensation_entry, COMPENSATION_ENTRIES)
        }
        SettingField::LengthByHAlone => on(p.length_by_h_alone),
        SettingField::Nesting => p.nesting.to_string(),
        SettingField::PackedCalls => on(p.packed_calls),
        SettingField::ChipBreak => mm_text(p.rules.chip_break_mm),
        SettingField::PeckClearance => mm_text(p.rules.peck_clearance_mm),
        SettingField::LengthMustMatchTool => on(p.length_must_match_tool),
        SettingField::UnitCodes => name_of(p.unit_codes, UNIT_CODES),
        SettingField::ReturnLabelInCallee => on(p.return_label_in_callee),
        SettingField::PocketStepover => mm_text(p.rules.pocket_stepover_mm),
        SettingField::FixedRoutineCount => name_of(p.fixed_routine_count, ROUTINE_COUNTS),
        SettingField::BoreDiameterRegister => name_of(p.bore_diameter_register, REGISTERS),
        SettingField::Cycle(rule) => cycle::value_text(p, rule),
        SettingField::Compensation(rule) => compensation::value_text(p, rule),
        SettingField::Path(rule) => path_mode::value_text(p, rule),
        SettingField::Frame(rule) => frame::value_text(p, rule),
        SettingField::RotaryFeed(rule) => rotary_feed::value_text(p, rule),
        SettingField::Turning(rule) => turning::value_text(p, rule),
        SettingField::Length(rule) => length::value_text(p, rule),
        SettingField::StartRadii => name_of(p.starts_with_radii, X_WORDS),
        SettingField::FaceX => name_of(p.face_x_radius, X_WORDS),
        SettingField::LiveToolP => p.live_tool_p.to_string(),
        SettingField::SecondSpindleP => p.second_spindle_p.to_string(),
        SettingField::WaitCode { last } => p.wait_codes[usize::from(last)].to_string(),
        SettingField::OffsetMemory => name_of(p.offset_memory, OFFSET_MEMORIES),
        SettingField::ToolChanger => name_of(p.tool_change, TOOL_CHANGERS),
        SettingField::Build(option) => on(p.build.has(option)),
        SettingField::AfterRefusal => name_of(p.goes_on_after_refusal, AFTER_REFUSAL),
        SettingField::CodeSystem => name_of(p.code_system, CODE_SYSTEMS),
        SettingField::DwellUnit => name_of(p.dwell_factor, DWELL_UNITS),
        SettingField::MacroAngles => name_of(p.macro_angles_full_circle, MACRO_ANGLES),
        SettingField::AliasG(at) => p.aliases.g[at as usize].to_string(),
        SettingField::AliasM(at) => p.aliases.m[at as usize].to_string(),
        SettingField::AliasSubprogram(at) => p.aliases.m_subprogram[at as usize].to_string(),
    }
}
