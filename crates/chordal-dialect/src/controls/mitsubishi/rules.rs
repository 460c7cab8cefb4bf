//! How Mitsubishi M700 and M800 move, cut, drill and compensate.

use crate::vocabulary::*;

pub(super) const PARAMETERS: Parameters = Parameters {
    excess_decimals: ExcessDecimals::Cut,
    nesting: 8,
    macro_angles_full_circle: true,
    m_groups: SPINDLE_CODES,
    // With every option: eight digits of N and O, 999 offsets. From practice, no manual was found.
    largest_numbers: LargestNumbers { block: 99_999_999, program: 99_999_999, offset: 999, tool: 0 },
    rules: Rules {
        spindle_stops_at_tool_change: true,
        frames: FRAMES,
        machine_move_is_rapid: true,
        length: LengthRules { adds_to_increment: true, ..LengthRules::COMMON },
        radius_offsets: OffsetKind::Radius,
        // As on a Fanuc; no section of the manual was found.
        rotary_feed: RotaryFeedRules::measured(RotaryFeed::DegreesAsUnits),
        chip_break_mm: 1.0,
        peck_clearance_mm: 1.0,
        cycles: CYCLES,
        compensation: COMPENSATION,
        corner: RoundingRules { moves: CornerMoves::LinesAndArcs, ..RoundingRules::COMMON },
        path: PathRules { look_ahead_mm: Some(0.01), short_blocks: ShortBlocks::LookAhead, ..PathRules::COMMON },
        arc: ArcRules {
            helix_feed: FeedAlong::Path,
            spiral: SpiralForm::Pitches,
            // Section 6.13: the manual's examples have RadErr 0.100.
            radius_error_tolerance_mm: 0.1,
            // As with parameter #11028 on.
            semicircle_of_long_radius: true,
            spiral_end_tolerance_mm: 0.1,
            ..ArcRules::COMMON
        },
        ..Rules::COMMON
    },
    ..Parameters::COMMON
};

const CYCLES: CycleRules = CycleRules {
    // Programs that run on machines tap with M29 and G84 without R.
    missing_r: MissingLevel::Initial,
    peck: PeckRules { dwell: PeckDwell::EachPeck, ..CycleRules::COMMON.peck },
    bore: BoreRules {
        dwell_before_stop: true,
        shift: ShiftWords::Vector,
        shift_at_feed: true,
        ..CycleRules::COMMON.bore
    },
    ..CycleRules::COMMON
};

/// Mitsubishi M700V manual: up to three blocks without motion in a row, and no M0, M1, M2 and M30.
const COMPENSATION: CompensationRules = CompensationRules {
    idle_blocks: Some(3),
    stops_end_look_ahead: true,
    off_toward: true,
    interference: InterferenceSearch::Vectors,
    ..CompensationRules::COMMON
};

/// Mitsubishi M700V manual, G51 and G68: angle and centre are absolute or incremental by G90 and G91; an axis without a
/// centre is not scaled.
const FRAMES: FrameRules = FrameRules {
    // #7907, whose default is not known.
    rotary_choice: RotaryChoice::PoleSide { near_rad: 1.0_f64.to_radians() },
    // M700V manual 6.13.
    refuses_spirals: true,
    angle_adds: true,
    angle_is_kept: true,
    center_by_mode: true,
    scales_named_axes: true,
    factor_range: [0.0, 100.0],
    unequal_arcs: UnequalArcs::Refused,
    rotation_stays: true,
    work_change: true,
    ..FrameRules::COMMON
};

/// M700V manual p. 463 to 469: three-dimensional coordinate conversion.
pub(super) const SPATIAL: SpatialRules = SpatialRules {
    begins: &[680, 681],
    max_active: None,
    format: None,
    parallel_axes: None,
    in_compensation: Some("P922"),
    length_not_nested: None,
    excluded_codes: Some((NOT_INSIDE, "P923")),
    inside: &[(NOT_INSIDE, "P921"), (&[431], "P927"), (&[434, 435], "P941")],
    before: &[(431, "P931"), (434, "P922"), (435, "P922")],
    scaling_in_offset: None,
};

/// M800/M80 alarm list (M01 0185, P33) and M700 programming manual p.479: tilted planes, direction of the tool by a vector.
pub(super) const TILTED_PLANE: TiltedPlaneRules = TiltedPlaneRules {
    twice: Some("M01 0185"),
    format: None,
    without_plane: Some("M01 0185"),
    unreachable: None,
    rotary_with_vector: Some("P33"),
    vector_in_fixed_frame: None,
    arc_while_turning: None,
};

/// Codes that are not allowed while a rotation in space is active: G41.1, G51, G52 and G54 to G59, in tenths.
const NOT_INSIDE: &[u16] = &[411, 421, 510, 520, 540, 541, 550, 560, 570, 580, 590];
