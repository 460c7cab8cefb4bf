//! How Haas lathes move, cut and compensate.

use crate::vocabulary::*;

pub(super) const PARAMETERS: Parameters = Parameters {
    excess_decimals: ExcessDecimals::Unknown,
    most_digits: 0,
    nesting: 9,
    max_repeats: 99,
    largest_numbers: LargestNumbers { block: 99_999_999, program: 99_999, offset: 0, tool: 0 },
    packed_calls: false,
    macro_angles_full_circle: false,
    return_label_in_callee: true,
    arc_without_center_is_line: false,
    live_tool_p: 0,
    second_spindle_p: 0,
    corner_words_in_g1: true,
    rules: Rules {
        rapid: RapidPath::DogLeg,
        // How F counts the C axis of a lathe is not known.
        rotary_feed: RotaryFeedRules::COMMON,
        chip_break_mm: 0.508,
        peck_clearance_mm: 0.508,
        cycles: CYCLES,
        turning: TURNING,
        corner: RoundingRules {
            moves: CornerMoves::Lines,
            dwells_between: 1,
            ..RoundingRules::COMMON
        },
        ..FANUC.rules
    },
    ..FANUC
};

const FANUC: Parameters = crate::controls::fanuc_lathe::PARAMETERS;

/// R and Z are coordinates; R of a radial hole is a diameter, as CAM systems write it. The hole is at the position of
/// the tool.
const CYCLES: CycleRules = CycleRules {
    repeat_letter: b'L',
    r_from_initial: false,
    radial_r_is_diameter: true,
    missing_r: MissingLevel::Current,
    dwell_point_s: 1.0,
    ..FANUC.rules.cycles
};

/// A cycle is one block. Its passes begin at the position of the tool; a thread has no separate finishing pass.
const TURNING: TurningRules = TurningRules {
    rough_retract_mm: 1.27,
    first_level: FirstLevel::Start,
    peck_retract_mm: 0.508,
    thread_finish_passes: 0,
    thread_angle_deg: 0.0,
    return_left_out: true,
    two_blocks: false,
    ..TurningRules::COMMON
};
