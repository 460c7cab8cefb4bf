//! How Marlin moves and cuts, with the options and defaults of its configuration files.

use crate::vocabulary::*;
use chordal_command::Units;

pub(super) const PARAMETERS: Parameters = Parameters {
    excess_decimals: ExcessDecimals::Exact,
    decimal_point: DecimalPoint::Calculator,
    center_and_radius: CenterAndRadius::RadiusWins,
    end_optional: true,
    goes_on_after_refusal: true,
    tool_change: ToolChanger::Nobody,
    zero_feed_passed_over: true,
    preset_writes_system: true,
    build: FirmwareBuild {
        parentheses: false,
        lower_case: false,
        motion_modes: false,
        work_systems: false,
        planes: false,
        inch: false,
        turns: false,
        splines: false,
        probe: false,
        coolant: false,
        ..FirmwareBuild::COMMON
    },
    rules: Rules {
        length: LengthRules::ABSENT,
        units: Units::Millimetre,
        starts_without_motion: true,
        rapid: RapidPath::Straight,
        rapid_feed: RapidFeed::Programmed,
        // 1500 mm/min.
        starting_feed_mm_s: Some(25.0),
        bare_home_moves_all: true,
        spindle_by_hand: true,
        work_values_add: false,
        // There are no cycles; after G80 a line without a code is no motion.
        cycles: CycleRules { one_group_with_motion: true, ..CycleRules::COMMON },
        path: PathRules {
            stop_before_cut: false,
            stop_between_rapids: false,
            stop_after_cut: false,
            junctions: Some(JUNCTIONS),
            ..PathRules::COMMON
        },
        arc: ArcRules {
            // Marlin does not compare the radii: the last segment goes to the programmed end, wherever that is. Chordal
            // reports a difference beyond this.
            radius_error_tolerance_mm: 0.05,
            arc_mismatch: ArcMismatch::ArcThenLine,
            full_circle_by_radius: FullCircleByRadius::Refused,
            ..ArcRules::COMMON
        },
        ..Rules::COMMON
    },
    ..Parameters::COMMON
};

const JUNCTIONS: JunctionRules = JunctionRules {
    deviation_mm: 0.013,
    // The queue has room for 16 blocks, of which one is always free.
    blocks: 15,
    arc_tolerance_mm: 0.01,
    arc_segments: Some(ArcSegments { least_mm: 0.1, most_mm: 1.0, of_circle: 72 }),
    speed_steps_mm_s: None,
    steps_per_mm: [80.0, 80.0, 400.0],
    limited_jerk: false,
};
