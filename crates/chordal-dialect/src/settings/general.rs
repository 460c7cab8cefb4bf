//! General settings: power-on state, numbers, arcs, calls, tools and options of a build.

use chordal_command::{FeedAlong, RapidPath, Units};
use chordal_kernel::rules::*;
use chordal_machine::SettingValue;

use super::choices::{choose, mm_text, name_of};
use super::field::{SettingField, SettingInput, setting_fields, switch_text};
use crate::firmware::BuildOption;
use crate::parameters::*;

const FULL_CIRCLES_BY_RADIUS: &[(&str, FullCircleByRadius)] = &[
    ("refused", FullCircleByRadius::Refused),
    ("no-motion", FullCircleByRadius::NoMotion),
    ("straight", FullCircleByRadius::Straight),
];

const TOOL_CHANGERS: &[(&str, ToolChanger)] = &[
    ("sender", ToolChanger::Sender),
    ("nobody", ToolChanger::Nobody),
    ("machine", ToolChanger::Machine),
];

const AFTER_REFUSAL: &[(&str, bool)] = &[("stop", false), ("continue", true)];

const DWELL_UNITS: &[(&str, f64)] = &[("s", 1.0), ("ms", 0.001)];

const X_WORDS: &[(&str, bool)] = &[("radii", true), ("diameters", false)];

const CODE_SYSTEMS: &[(&str, u8)] = &[("A", 0), ("B", 1), ("C", 2)];

const ROUTINE_COUNTS: &[(&str, FixedRoutineCount)] =
    &[("repeat", FixedRoutineCount::Repeat), ("once", FixedRoutineCount::Once)];

const REGISTERS: &[(&str, u8)] = &[("R1", 1), ("R2", 2), ("R3", 3), ("R4", 4)];

const OUTSIDE_CORNERS: &[(&str, OutsideCorner)] =
    &[("linear", OutsideCorner::Linear), ("arc", OutsideCorner::Arc)];

const COMPENSATION_ENTRIES: &[(&str, CompensationEntry)] = &[
    ("A", CompensationEntry::A),
    ("B", CompensationEntry::B),
    ("contour", CompensationEntry::Contour),
];

const OFFSET_MEMORIES: &[(&str, OffsetMemory)] = &[
    ("not known", OffsetMemory::NotKnown),
    ("A", OffsetMemory::Whole),
    ("C", OffsetMemory::GeometryAndWear),
    ("B", OffsetMemory::GeometryAndWear),
];

const SPIRAL_ON_RAY: &[(&str, SpiralOnRay)] =
    &[("no-turn", SpiralOnRay::NoTurn), ("full-turn", SpiralOnRay::FullTurn)];

const OMITTED_CENTER: &[(&str, OmittedCenter)] =
    &[("start", OmittedCenter::Start), ("zero", OmittedCenter::Zero)];

const ARCS_WITHOUT_CENTER: &[(&str, bool)] = &[("line", true), ("refused", false)];
const MACHINE_MOVES: &[(&str, bool)] = &[("rapid", true), ("in-force", false)];

const EXCESS_DECIMALS: &[(&str, ExcessDecimals)] = &[
    ("exact", ExcessDecimals::Exact),
    ("cut", ExcessDecimals::Cut),
    ("rounded", ExcessDecimals::Rounded),
    ("unknown", ExcessDecimals::Unknown),
];

const SPINDLE_AT_TOOL_CHANGE: &[(&str, bool)] = &[("stops", true), ("turns", false)];

const NEAR_SEMICIRCLES: &[(&str, bool)] = &[("computed", false), ("middle", true)];

const ROTARY_IN_ARC: &[(&str, bool)] = &[("allowed", true), ("refused", false)];

const MACRO_ANGLES: &[(&str, bool)] = &[("0-to-360", true), ("180", false)];

const UNIT_CODES: &[(&str, UnitCodes)] =
    &[("G20/G21", UnitCodes::G20), ("G70/G71", UnitCodes::G70), ("both", UnitCodes::Both)];

const DECIMAL_POINTS: &[(&str, DecimalPoint)] =
    &[("least-increment", DecimalPoint::LeastIncrement), ("calculator", DecimalPoint::Calculator)];

const ARC_CENTERS: &[(&str, ArcCenter)] = &[
    ("from-start", ArcCenter::FromStart),
    ("absolute", ArcCenter::Absolute),
    ("from-center", ArcCenter::FromCenter),
];

const SPIRALS: &[(&str, SpiralForm)] = &[
    ("none", SpiralForm::None),
    ("pitches", SpiralForm::Pitches),
    ("increment-height-count", SpiralForm::IncrementHeightCount),
    ("increment-count", SpiralForm::IncrementCount),
];

const UNITS: &[(&str, Units)] = &[("inch", Units::Inch), ("mm", Units::Millimetre)];

const MOTIONS: &[(&str, bool)] = &[("rapid", false), ("linear", true)];

const DISTANCES: &[(&str, bool)] = &[("absolute", false), ("incremental", true)];

const PLANE_CODES: &[(&str, PlaneCodes)] =
    &[("standard", PlaneCodes::Standard), ("swapped", PlaneCodes::Swapped)];

const ARC_MISMATCHES: &[(&str, ArcMismatch)] =
    &[("spiral", ArcMismatch::Spiral), ("arc-then-line", ArcMismatch::ArcThenLine)];

const HELIX_FEEDS: &[(&str, FeedAlong)] = &[("path", FeedAlong::Path), ("plane", FeedAlong::Plane)];

const CENTERS_AND_RADII: &[(&str, CenterAndRadius)] =
    &[("radius-wins", CenterAndRadius::RadiusWins), ("refused", CenterAndRadius::Refused)];

const RAPIDS: &[(&str, RapidPath)] =
    &[("dog-leg", RapidPath::DogLeg), ("straight", RapidPath::Straight)];

const OFFSET_KINDS: &[(&str, OffsetKind)] =
    &[("diameter", OffsetKind::Diameter), ("radius", OffsetKind::Radius)];

/// The length that messages give as an example.
const EXAMPLE: &str = "0.0005 in";

const TWO_INCREMENTS: &str = "two-increments";

setting_fields! {
    UNITS = choice(rules.units, UNITS);
    START_MOTION = choice(rules.starts_linear, MOTIONS);
    START_DISTANCE = choice(rules.starts_incremental, DISTANCES);
    DECIMAL_POINT = choice(decimal_point, DECIMAL_POINTS);
    FEED_DIGITS = custom(
        |p, input| {
            p.feed_digits_inch = input.count()?.min(6) as u8;
            Ok(())
        },
        |p, _| p.feed_digits_inch.to_string()
    );
    ARC_CENTER = choice(rules.arc.arc_center, ARC_CENTERS);
    PLANE_CODES = choice(plane_codes, PLANE_CODES);
    RADIUS_ERROR_TOLERANCE = length(rules.arc.radius_error_tolerance_mm, EXAMPLE);
    ARC_MISMATCH = choice(rules.arc.arc_mismatch, ARC_MISMATCHES);
    SEMICIRCLE_TOLERANCE = custom(
        |p, input| {
            let is_length = input.word != TWO_INCREMENTS;
            p.rules.arc.semicircle_tolerance_mm =
                if is_length { Some(input.length(EXAMPLE)?) } else { None };
            Ok(())
        },
        |p, _| p.rules.arc.semicircle_tolerance_mm.map_or(TWO_INCREMENTS.to_string(), mm_text)
    );
    NEAR_SEMICIRCLE = choice(rules.arc.semicircle_of_long_radius, NEAR_SEMICIRCLES);
    EXCESS_DECIMALS = choice(excess_decimals, EXCESS_DECIMALS);
    SPINDLE_AT_TOOL_CHANGE = choice(rules.spindle_stops_at_tool_change, SPINDLE_AT_TOOL_CHANGE);
    MOST_DIGITS = custom(
        |p, input| {
            p.most_digits = input.count()?.min(18) as u8;
            Ok(())
        },
        |p, _| p.most_digits.to_string()
    );
    HELIX_FEED = choice(rules.arc.helix_feed, HELIX_FEEDS);
    SPIRAL = choice(rules.arc.spiral, SPIRALS);
    SPIRAL_END_TOLERANCE = length(rules.arc.spiral_end_tolerance_mm, EXAMPLE);
    SPIRAL_ON_RAY = choice(rules.arc.spiral_on_ray, SPIRAL_ON_RAY);
    ROTARY_IN_ARC = choice(rules.arc.rotary_in_arc, ROTARY_IN_ARC);
    OMITTED_CENTER = choice(rules.arc.omitted_center, OMITTED_CENTER);
    MACHINE_MOVE = choice(rules.machine_move_is_rapid, MACHINE_MOVES);
    RAPID_CANCELS_ARC = flag(rapid_cancels_arc);
    CENTER_AND_RADIUS = choice(center_and_radius, CENTERS_AND_RADII);
    /// A block of an arc without a centre and without a radius (Fanuc No. 3403#5).
    ARC_WITHOUT_CENTER = choice(arc_without_center_is_line, ARCS_WITHOUT_CENTER);
    FULL_CIRCLE_BY_RADIUS = choice(rules.arc.full_circle_by_radius, FULL_CIRCLES_BY_RADIUS);
    RAPID = choice(rules.rapid, RAPIDS);
    RAPID_FEED = custom(set_rapid_feed, |p, _| match p.rules.rapid_feed {
        RapidFeed::OfMachine => "machine".into(),
        RapidFeed::Programmed => "programmed".into(),
        RapidFeed::Fixed(speed) => (speed * 60.0).to_string(),
    });
    POWER_LETTER = custom(
        |p, input| {
            p.power_letter = input.flag()?.then_some(b'P');
            Ok(())
        },
        |p, _| switch_text(p.power_letter.is_some())
    );
    MAX_RADIUS = length(rules.arc.max_radius_mm, EXAMPLE);
    MAX_RADIUS_COMPENSATED = length(rules.arc.max_radius_compensated_mm, EXAMPLE);
    RADIUS_OFFSETS = choice(rules.radius_offsets, OFFSET_KINDS);
    OUTSIDE_CORNER = choice(rules.outside_corner, OUTSIDE_CORNERS);
    COMPENSATION_ENTRY = choice(rules.compensation_entry, COMPENSATION_ENTRIES);
    LENGTH_BY_H_ALONE = flag(length_by_h_alone);
    NESTING = custom(
        |p, input| {
            p.nesting = input.count()?.clamp(1, 100);
            Ok(())
        },
        |p, _| p.nesting.to_string()
    );
    PACKED_CALLS = flag(packed_calls);
    CHIP_BREAK = length(rules.chip_break_mm, EXAMPLE);
    PECK_CLEARANCE = length(rules.peck_clearance_mm, EXAMPLE);
    LENGTH_MUST_MATCH_TOOL = flag(length_must_match_tool);
    UNIT_CODES = choice(unit_codes, UNIT_CODES);
    RETURN_LABEL_IN_CALLEE = flag(return_label_in_callee);
    POCKET_STEPOVER = custom(
        |p, input| {
            p.rules.pocket_stepover_mm = match input.word {
                "no limit" => f64::INFINITY,
                _ => Some(input.length(EXAMPLE)?)
                    .filter(|step| *step > 0.0)
                    .ok_or("a length above zero, or `no limit`")?,
            };
            Ok(())
        },
        |p, _| mm_text(p.rules.pocket_stepover_mm)
    );
    FIXED_SUBROUTINE_REPEATS = choice(fixed_routine_count, ROUTINE_COUNTS);
    BORE_DIAMETER_REGISTER = choice(bore_diameter_register, REGISTERS);
    /// Whether X is a radius or a diameter at power-on (LinuxCNC G7, G8).
    START_RADII = choice(starts_with_radii, X_WORDS);
    /// Whether X is a radius or a diameter in polar interpolation.
    FACE_X = choice(face_x_radius, X_WORDS);
    /// The P of M3, M4 and M5 that selects the live tool.
    LIVE_TOOL_P = custom(
        |p, input| {
            p.live_tool_p = input.count()?;
            Ok(())
        },
        |p, _| p.live_tool_p.to_string()
    );
    /// The P of M3 and M4 that selects the second spindle.
    SECOND_SPINDLE_P = custom(
        |p, input| {
            p.second_spindle_p = input.count()?;
            Ok(())
        },
        |p, _| p.second_spindle_p.to_string()
    );
    /// The first M code that waits for another channel.
    FIRST_WAIT_CODE = custom(
        |p, input| {
            p.wait_codes[usize::from(input.index)] = input.count()?;
            Ok(())
        },
        |p, index| p.wait_codes[usize::from(index)].to_string()
    );
    /// What happens after a block that the control refuses (GRBL).
    AFTER_REFUSAL = choice(goes_on_after_refusal, AFTER_REFUSAL);
    /// Who changes tools (GRBL).
    TOOL_CHANGER = choice(tool_change, TOOL_CHANGERS);
    /// Whether the build of a firmware has the first option: see [`SettingField::build`].
    BUILD = custom(
        |p, input| {
            *p.build.option_mut(BuildOption::ALL[usize::from(input.index)]) = input.flag()?;
            Ok(())
        },
        |p, index| switch_text(p.build.has(BuildOption::ALL[usize::from(index)]))
    );
    /// The G code system (Fanuc lathes No. 3401).
    CODE_SYSTEM = custom(set_code_system, |p, _| name_of(p.code_system, CODE_SYSTEMS));
    /// The unit of the time of G4 (Mach3).
    DWELL_UNIT = choice(dwell_factor, DWELL_UNITS);
    MACRO_ANGLES = choice(macro_angles_full_circle, MACRO_ANGLES);
    /// How tool offsets are stored, which decides what #2001 to #2400 mean.
    OFFSET_MEMORY = choice(offset_memory, OFFSET_MEMORIES);
    ALIAS_G = custom(
        |p, input| {
            p.aliases.g[usize::from(input.index)] = alias_code(p, input)?;
            Ok(())
        },
        |p, index| p.aliases.g[usize::from(index)].to_string()
    );
    ALIAS_M = custom(
        |p, input| {
            p.aliases.m[usize::from(input.index)] = alias_code(p, input)?;
            Ok(())
        },
        |p, index| p.aliases.m[usize::from(index)].to_string()
    );
    ALIAS_SUBPROGRAM = custom(
        |p, input| {
            p.aliases.m_subprogram[usize::from(input.index)] = alias_code(p, input)?;
            Ok(())
        },
        |p, index| p.aliases.m_subprogram[usize::from(index)].to_string()
    );
}

impl SettingField {
    /// The last M code that waits for another channel.
    pub const LAST_WAIT_CODE: SettingField = SettingField::FIRST_WAIT_CODE.at(1);

    /// Whether the build of a firmware has an option.
    pub const fn build(option: BuildOption) -> SettingField {
        SettingField::BUILD.at(option as u8)
    }

    /// Whether it is an option of a firmware's build.
    pub fn is_build_option(self) -> bool {
        self == SettingField::BUILD.at(self.index)
    }

    /// The G code that calls the macro with this index, from 0.
    pub const fn alias_g(index: u8) -> SettingField {
        SettingField::ALIAS_G.at(index)
    }

    /// The M code that calls the macro with this index, from 0.
    pub const fn alias_m(index: u8) -> SettingField {
        SettingField::ALIAS_M.at(index)
    }

    /// The M code that calls the subprogram with this index, from 0.
    pub const fn alias_subprogram(index: u8) -> SettingField {
        SettingField::ALIAS_SUBPROGRAM.at(index)
    }
}

fn set_rapid_feed(p: &mut Parameters, input: &SettingInput<'_>) -> Result<(), String> {
    p.rules.rapid_feed = match (input.word, input.value) {
        ("programmed", _) => RapidFeed::Programmed,
        (_, SettingValue::Integer(speed @ 1..=1_000_000)) => RapidFeed::Fixed(*speed as f64 / 60.0),
        (_, SettingValue::Float(speed)) if *speed > 0.0 && *speed < 1e6 => {
            RapidFeed::Fixed(*speed / 60.0)
        }
        _ => return Err("a feed in mm/min, or `programmed`".to_string()),
    };
    Ok(())
}

fn set_code_system(p: &mut Parameters, input: &SettingInput<'_>) -> Result<(), String> {
    p.code_system = choose(input.word, CODE_SYSTEMS)?;
    // Inch and millimetres are G70 and G71 in C.
    p.unit_codes = if p.code_system == 2 { UnitCodes::G70 } else { UnitCodes::G20 };
    let example = if p.code_system == 0 { "G50 S2500" } else { "G92 S2500" };
    p.rules.turning.speed_limit_example = example;
    Ok(())
}

fn alias_code(p: &mut Parameters, input: &SettingInput<'_>) -> Result<u16, String> {
    let code = input.count()?.min(6000) as u16;
    p.aliases.any |= code > 0;
    Ok(code)
}
