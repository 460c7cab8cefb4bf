//! How Fanuc 0i moves, cuts, drills and compensates.

use crate::vocabulary::*;

pub(super) const PARAMETERS: Parameters = Parameters {
    excess_decimals: ExcessDecimals::Cut,
    most_digits: 8,
    nesting: 10,
    packed_calls: true,
    macro_angles_full_circle: true,
    arc_without_center_is_line: true,
    m_groups: SPINDLE_CODES,
    // With every option: eight digits of N and O, 2000 offsets. From practice, no manual was found.
    largest_numbers: LargestNumbers { block: 99_999_999, program: 99_999_999, offset: 2000, tool: 0 },
    rules: Rules {
        spindle_stops_at_tool_change: true,
        frames: FRAMES,
        preset_clears_shift: true,
        machine_move_is_rapid: true,
        machine_move_needs_absolute: true,
        length: LengthRules { adds_to_increment: true, ..LengthRules::COMMON },
        radius_offsets: OffsetKind::Radius,
        // B-63174EN 4.2: X20. C40. F300. takes 0.149 min.
        rotary_feed: RotaryFeedRules::measured(RotaryFeed::DegreesAsUnits),
        chip_break_mm: 1.0,
        peck_clearance_mm: 1.0,
        cycles: CYCLES,
        compensation: COMPENSATION,
        corner: CORNER,
        path: PathRules { look_ahead_mm: Some(0.01), short_blocks: ShortBlocks::LookAhead, ..PathRules::COMMON },
        arc: ArcRules {
            full_circle_by_radius: FullCircleByRadius::NoMotion,
            helix_feed: FeedAlong::Plane,
            spiral: SpiralForm::IncrementCount,
            spiral_end_tolerance_mm: 0.0127,
            // L counts the turns that are begun: exactly one turn is L1.
            spiral_on_ray: SpiralOnRay::FullTurn,
            rotary_in_arc: false,
            ..ArcRules::COMMON
        },
        ..Rules::COMMON
    },
    ..Parameters::COMMON
};

const CYCLES: CycleRules = CycleRules {
    repeat_letter: b'K',
    // Programs that run on machines tap with M29 and G84 without R.
    missing_r: MissingLevel::Initial,
    tap: TapRules { pecks_by_q: true, ..CycleRules::COMMON.tap },
    ..CycleRules::COMMON
};

/// Fanuc 16i and 30i: three blocks are read ahead, so that one block without motion is allowed between two moves.
const COMPENSATION: CompensationRules = CompensationRules {
    idle_blocks: Some(1),
    zero_move_counts: 2,
    off_toward: true,
    repeated: RepeatedCodeRule::Perpendicular,
    spirals: SpiralCompensation::ByCircles,
    ..CompensationRules::COMMON
};

/// Operator's Manual of the 30i, optional chamfering and corner R: one block with G4 is allowed between the two
/// moves, and a corner whose direction changes by 1 degree or less gets neither chamfer nor rounding.
const CORNER: RoundingRules =
    RoundingRules {
        moves: CornerMoves::LinesAndArcs,
        dwells_between: 1,
        straight_deg: 1.0,
        ..RoundingRules::COMMON
    };

/// Coordinates have eight digits; from practice: no cycle along a mirrored or scaled axis.
const FRAMES: FrameRules = FrameRules {
    rotary_choice: RotaryChoice::Master,
    largest_scaled_increments: 99_999_999.0,
    cycles_along_scaled: false,
    ..FrameRules::COMMON
};

/// Alarm list of the 30i: tilted working planes.
pub(super) const TILTED_PLANE: TiltedPlaneRules = TiltedPlaneRules {
    twice: Some("PS5456 TOO MANY G68.2 NESTING"),
    format: Some("PS5457 G68.2 FORMAT ERROR"),
    without_plane: Some("PS5458 ILLEGAL USE OF G53.1"),
    unreachable: Some("PS5459 MACHINE PARAMETER INCORRECT"),
    rotary_with_vector: None,
    vector_in_fixed_frame: Some("PS5459 MACHINE PARAMETER INCORRECT"),
    arc_while_turning: Some("PS5421 ILLEGAL COMMAND IN G43.4/G43.5"),
};

/// Alarm list of the 30i: three-dimensional coordinate conversion.
pub(super) const SPATIAL: SpatialRules = SpatialRules {
    begins: &[680],
    max_active: Some((2, "PS5043 TOO MANY G68 NESTING")),
    format: Some("PS5044 G68 FORMAT ERROR"),
    parallel_axes: Some("PS0047 ILLEGAL AXIS SELECT"),
    in_compensation: Some("PS0049 ILLEGAL COMMAND(G68,G69)"),
    length_not_nested: Some("PS0049 ILLEGAL COMMAND(G68,G69)"),
    excluded_codes: None,
    inside: &[],
    before: &[],
    scaling_in_offset: Some("PS0141 CAN NOT COMMAND G51 IN 3-D OFFSET"),
};
