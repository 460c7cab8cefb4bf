//! How Haas mills move, cut, drill and compensate.

use crate::vocabulary::*;

pub(super) const PARAMETERS: Parameters = Parameters {
    decimal_point: DecimalPoint::LeastIncrement,
    center_and_radius: CenterAndRadius::RadiusWins,
    nesting: 9,
    max_repeats: 99,
    length_must_match_tool: true,
    m_groups: SPINDLE_CODES,
    // D up to 200 and O of five digits are documented, H and T are taken to be as D. The limit of N is not known:
    // eight digits are more than any post writes.
    largest_numbers: LargestNumbers { block: 99_999_999, program: 99_999, offset: 200, tool: 200 },
    return_label_in_callee: true,
    rules: Rules {
        spindle_stops_at_tool_change: true,
        frames: FRAMES,
        rapid: RapidPath::DogLeg,
        radius_offsets: OffsetKind::Diameter,
        // Settings 34 and 79, whose values at delivery are not known.
        rotary_feed: RotaryFeedRules {
            diameter_names: ["Setting 34", "Setting 79"],
            ..RotaryFeedRules::measured(RotaryFeed::OnDiameter)
        },
        chip_break_mm: 0.508,
        peck_clearance_mm: 0.508,
        bare_home_moves_all: true,
        preset_clears_shift: true,
        cycles: CYCLES,
        compensation: COMPENSATION,
        corner: CORNER,
        path: PATH,
        ..Rules::COMMON
    },
    // Mill operator's manual, G93.
    largest_inverse_time: 45_000.0,
    ..Parameters::COMMON
};

const CYCLES: CycleRules = CycleRules {
    fires_on: FiringWords::Place,
    // As with Setting 28 on.
    definition: DefinitionFires::Always,
    missing_r: MissingLevel::Current,
    zero_repeats: ZeroRepeats::PlaceOnly,
    dwell_point_s: 1.0,
    peck: PeckRules {
        decreasing: true,
        return_after_k: true,
        dwell: PeckDwell::Bottom,
        ..CycleRules::COMMON.peck
    },
    tap: TapRules { out_factor_by_j: true, ..CycleRules::COMMON.tap },
    bore: BoreRules { shift: ShiftWords::QOrVector, ..CycleRules::COMMON.bore },
    ..CycleRules::COMMON
};

// Setting 85 is 0.025 in; the fractions of it that the smoothness levels use are a choice, no text has figures.
const PATH: PathRules = PathRules {
    rounding_mm: Some(0.635),
    level_parts: [1.0, 0.5, 0.2],
    level: 2,
    short_blocks: ShortBlocks::Joined,
    ..PathRules::COMMON
};

/// Haas Mill NGC Operator's Manual (2017), cutter compensation.
const COMPENSATION: CompensationRules = CompensationRules {
    side_change: SideChange::Along,
    // From the note on thread milling: the lead-in is longer than the offset.
    lead: LeadLength::AboveOffset,
    planes: CompensationPlanes::XyOnly,
    new_offset_on_arc: AllowanceRule::Refused,
    inside_feed_least: 0.5,
    ..CompensationRules::COMMON
};

/// Haas NGC manual, G51 and G68: one factor for all axes, rotary ones included.
const FRAMES: FrameRules = FrameRules {
    rotary_choice: RotaryChoice::Master,
    scales_rotary: true,
    factors_by_vector: false,
    factor_range: [0.000_999, 999.001],
    unequal_arcs: UnequalArcs::Refused,
    rotation_ends_in_compensation: false,
    largest_angle_deg: 360.0,
    ..FrameRules::COMMON
};

/// Haas Mill Operator's Manual, corner rounding and chamfering: between two straight cuts; one G4 is allowed between
/// them.
const CORNER: RoundingRules =
    RoundingRules { moves: CornerMoves::Lines, dwells_between: 1, ..RoundingRules::COMMON };
