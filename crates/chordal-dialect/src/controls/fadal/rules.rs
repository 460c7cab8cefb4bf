//! How Fadal CNC 88 moves, cuts, drills and compensates.

use crate::vocabulary::*;

pub(super) const PARAMETERS: Parameters = Parameters {
    decimal_point: DecimalPoint::Calculator,
    length_by_h_alone: true,
    unit_codes: UnitCodes::Both,
    nesting: 7,
    max_repeats: 99,
    // User Manual 2003: N up to 99999, O up to 9999, a table of 99 offsets.
    largest_numbers: LargestNumbers { block: 99_999, program: 9999, offset: 99, tool: 0 },
    rules: Rules {
        spindle_stops_at_tool_change: true,
        rapid: RapidPath::DogLeg,
        // Section 10: a rotary axis turns at most 1080 degrees in a block.
        max_rotary_per_block_rad: 6.0 * std::f64::consts::PI,
        radius_offsets: OffsetKind::Diameter,
        chip_break_mm: 1.27,
        peck_clearance_mm: 1.27,
        cycles: CYCLES,
        compensation: COMPENSATION,
        path: PathRules { start: StartMode::ExactStop, ..PathRules::COMMON },
        outside_corner: OutsideCorner::Arc,
        // Section 10: the mirror image must not change before G40.
        frames: FrameRules { mirror_ends_in_compensation: false, ..FrameRules::COMMON },
        arc: ArcRules {
            helix_feed: FeedAlong::Path,
            // Section 13: the largest programmable radius is 399.9999 in, with CRC 99.9999 in.
            max_radius_mm: 399.9999 * 25.4,
            max_radius_compensated_mm: 99.9999 * 25.4,
            ..ArcRules::COMMON
        },
        ..Rules::COMMON
    },
    ..Parameters::COMMON
};

const CYCLES: CycleRules = CycleRules {
    fires_on: FiringWords::Place,
    definition: DefinitionFires::WithPlace,
    incremental: IncrementalLevels::Refused,
    missing_r: MissingLevel::Current,
    order: LevelOrder::AllBelowInitial,
    // Section 15: G80, G28, G29, M6, G49 and H0 end a cycle; G0 and G1 are not listed.
    cancel: CycleCancel {
        by_motion: false,
        by_reference: true,
        by_tool_change: true,
        by_length_cancel: true,
    },
    peck: PeckRules { decreasing: true, p_is_lift: true, ..CycleRules::COMMON.peck },
    tap: TapRules { feed: TapFeed::SpeedWithLeadQ, ..CycleRules::COMMON.tap },
    bore: BoreRules {
        direction: ShiftDirection { second: true, minus: false },
        ..CycleRules::COMMON.bore
    },
    ..CycleRules::COMMON
};

/// Fadal User Manual, section 10. The start-up is that of its example of a contoured slot, which is right only with
/// an offset vector at right angles to the next block.
const COMPENSATION: CompensationRules = CompensationRules {
    side_change: SideChange::RefusedOnLine,
    coordinate_change: AllowanceRule::Refused,
    ..CompensationRules::COMMON
};
