//! How Fanuc lathes move, cut and compensate.

use crate::vocabulary::*;

pub(in crate::controls) const PARAMETERS: Parameters = Parameters {
    excess_decimals: ExcessDecimals::Cut,
    most_digits: 8,
    nesting: 10,
    packed_calls: true,
    macro_angles_full_circle: true,
    increments: &[(b'U', b'X'), (b'V', b'Y'), (b'W', b'Z'), (b'H', b'C')],
    tool_word: ToolWord::StationAndOffset { digits: 2 },
    preset_limits_speed: true,
    arc_without_center_is_line: true,
    m_groups: SPINDLE_CODES,
    largest_numbers: LargestNumbers { block: 99_999_999, program: 99_999_999, offset: 0, tool: 0 },
    line_after_arc_is_usual: true,
    corner_words_in_g1: true,
    thread_lead: b'F',
    live_tool_p: 12,
    second_spindle_p: 13,
    second_spindle_axes: b"AB",
    rules: Rules {
        length: LengthRules { source: ToolLengths::TouchedOff, ..LengthRules::COMMON },
        starts_in: Plane::Zx,
        preset_clears_shift: true,
        starts_per_revolution: true,
        machine_move_is_rapid: true,
        radius_offsets: OffsetKind::Radius,
        rotary_feed: RotaryFeedRules::measured(RotaryFeed::DegreesAsUnits),
        bare_home_moves_all: true,
        chip_break_mm: 1.0,
        peck_clearance_mm: 1.0,
        cycles: CYCLES,
        compensation: COMPENSATION,
        corner: CORNER,
        turning: TurningRules { thread_words_take_point: false, ..TurningRules::COMMON },
        arc: ArcRules {
            full_circle_by_radius: FullCircleByRadius::NoMotion,
            rotary_in_arc: false,
            ..ArcRules::COMMON
        },
        ..Rules::COMMON
    },
    ..Parameters::COMMON
};

/// R of a hole is relative to the position of the tool; Q, the depth of a peck, is optional.
const CYCLES: CycleRules = CycleRules {
    axis: DrillingAxis::OfCode,
    repeat_letter: b'K',
    r_from_initial: true,
    missing_r: MissingLevel::Current,
    peck: PeckRules { q_optional: true, dwell: PeckDwell::Bottom, ..CycleRules::COMMON.peck },
    ..CycleRules::COMMON
};

/// Two blocks are read ahead (B-63604EN): one block without motion is allowed between two moves.
const COMPENSATION: CompensationRules = CompensationRules {
    idle_blocks: Some(1),
    ..CompensationRules::COMMON
};

/// Chamfer and corner R with a comma, as on mills.
const CORNER: RoundingRules =
    RoundingRules {
        moves: CornerMoves::LinesAndArcs,
        dwells_between: 1,
        straight_deg: 1.0,
        ..RoundingRules::COMMON
    };
