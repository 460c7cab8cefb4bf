//! How LinuxCNC (RS274/NGC) moves, cuts, drills and compensates.

use crate::vocabulary::*;
use chordal_syntax::Letters;

pub(in crate::controls) const PARAMETERS: Parameters = Parameters {
    excess_decimals: ExcessDecimals::Exact,
    decimal_point: DecimalPoint::Calculator,
    center_and_radius: CenterAndRadius::Refused,
    dwell_with_motion: true,
    offset_zero_in_force: true,
    end_required: true,
    strict_words: true,
    words_of_codes: Letters::of("DH"),
    // From its functions `enhance_block` and `check_g_codes`.
    one_code_takes_axes: Some("Cannot use two g codes that both use axis values"),
    m_groups: M_GROUPS,
    m_groups_alarm: Some("Two m codes used from same modal group"),
    longest_line: 253,
    plain_block_delete: true,
    nesting: 9,
    rules: Rules {
        feed_mode_code_ends_feed: true,
        // `G43 H0` is the offset of the tool in the spindle on machines whose changer puts tools back (its
        // documentation, G43).
        length: LengthRules {
            source: ToolLengths::TouchedOff,
            without_number: LengthWithoutNumber::OfTool,
            zero_is_of_tool: true,
            // The list of what M2 and M30 change has no tool length (its documentation, M2).
            ended_by: LengthEnds { program_end: false, ..LengthRules::COMMON.ended_by },
            ..LengthRules::COMMON
        },
        spindle_stops_at_tool_change: true,
        frames: FRAMES,
        turning: TurningRules {
            tips_mirrored: true,
            speed_limit_example: "G96 D2500 S…",
            contour_words: true,
            ..TurningRules::COMMON
        },
        rapid: RapidPath::Straight,
        radius_offsets: OffsetKind::Diameter,
        starts_without_motion: true,
        bare_home_moves_all: true,
        work_values_add: false,
        shift_is_preset: true,
        length_is_copied: true,
        cycles: CYCLES,
        compensation: COMPENSATION,
        // Rapids are blended like cuts.
        path: PathRules {
            stop_before_cut: false,
            stop_between_rapids: false,
            stop_after_cut: false,
            ..PathRules::COMMON
        },
        compensation_entry: CompensationEntry::Contour,
        outside_corner: OutsideCorner::Arc,
        arc: ArcRules {
            // Beyond this difference the radii must agree to 0.1 %, and beyond a hundred times it the arc is refused.
            radius_error_tolerance_mm: 0.028_284_3,
            radius_error_relative: 0.001,
            radius_error_limit_mm: 2.828_43,
            radius_error_inch_factor: 2.54,
            ..ArcRules::COMMON
        },
        ..Rules::COMMON
    },
    // `M68 E3 Qn` (LinuxCNC, switchkins).
    kinematics_output: Some(KinematicsOutput { m_code: 680, number: 3 }),
    ..Parameters::COMMON
};

/// The modal groups of M codes, in tenths.
const M_GROUPS: &[&[u16]] = &[
    &[0, 10, 20, 300, 600],
    &[620, 630, 640, 650, 660, 670, 680],
    &[60, 610],
    &[30, 40, 50, 190],
    &[70, 80, 90],
    &[480, 490, 500, 510, 520, 530],
];

pub(in crate::controls) const CYCLES: CycleRules = CycleRules {
    axis: DrillingAxis::PlaneNormal,
    fires_on: FiringWords::AnyAxis,
    incremental: IncrementalLevels::ReadAgain,
    order: LevelOrder::DepthBelowR,
    keeps_words: false,
    zero_repeats: ZeroRepeats::Refused,
    approach: HoleApproach::ByClearLevel,
    dwell_integer_s: 1.0,
    dwell_point_s: 1.0,
    needs_p: true,
    strict: true,
    one_group_with_motion: true,
    starts_at_r: true,
    peck: PeckRules { positive_only: true, ..CycleRules::COMMON.peck },
    tap: TapRules {
        starts_spindle: false,
        spindle_must_turn: true,
        out_to_clear: true,
        dwell_after_reverse: true,
        keeps_dwell: true,
        exchanged_off_xy: true,
        ..CycleRules::COMMON.tap
    },
    bore: BoreRules {
        dwell_out_to_clear: true,
        dwell_before_stop: true,
        spindle_must_turn: true,
        shift: ShiftWords::Vector,
        back: BackBore::UpAndDown,
        ..CycleRules::COMMON.bore
    },
    ..CycleRules::COMMON
};

/// As the interpreter of LinuxCNC 2.9 does it.
pub(in crate::controls) const COMPENSATION: CompensationRules = CompensationRules {
    tangent_rad: 0.05,
    off_at_once: true,
    cusps_meet: true,
    inverse_time_as_speed: true,
    corner_of_next: true,
    start_on_arc: true,
    repeated: RepeatedCodeRule::Refused,
    side_change: SideChange::Refused,
    new_offset: AllowanceRule::Refused,
    lead: LeadLength::AboveOffset,
    lead_follows_code: true,
    planes: CompensationPlanes::NotYz,
    interference: InterferenceSearch::Strict,
    equal_radius_refused: true,
    longer_arc_rad: [0.0254, 0.001],
    coordinate_change: AllowanceRule::Refused,
    offset_of_tool: true,
    ..CompensationRules::COMMON
};

/// There is no G68, G51 or G51.1; G10 L2 R rotates a work coordinate system.
const FRAMES: FrameRules =
    FrameRules { work_rotation: true, plane_change: true, ..FrameRules::COMMON };
