//! How grblHAL moves, cuts and drills.

use super::super::grbl::rules::PARAMETERS as FAMILY;
use crate::vocabulary::*;

pub(super) const PARAMETERS: Parameters = Parameters {
    tool_change: ToolChanger::Machine,
    nesting: 10,
    rules: Rules {
        // For a build without a tool table.
        length: LengthRules {
            source: ToolLengths::Absent,
            without_number: LengthWithoutNumber::OfTool,
            ..LengthRules::COMMON
        },
        cycles: CYCLES,
        chip_break_mm: 0.1,
        length_is_copied: true,
        path: PathRules {
            junctions: Some(JunctionRules {
                deviation_mm: 0.01,
                blocks: 100,
                arc_tolerance_mm: 0.002,
                arc_segments: None,
                speed_steps_mm_s: None,
                steps_per_mm: [250.0; 3],
                limited_jerk: false,
            }),
            ..FAMILY.rules.path
        },
        ..FAMILY.rules
    },
    ..FAMILY
};

const CYCLES: CycleRules = CycleRules {
    axis: DrillingAxis::PlaneNormal,
    fires_on: FiringWords::AnyAxis,
    order: LevelOrder::DepthBelowR,
    zero_repeats: ZeroRepeats::Refused,
    approach: HoleApproach::ByClearLevel,
    dwell_integer_s: 1.0,
    dwell_point_s: 1.0,
    needs_p: true,
    one_group_with_motion: true,
    peck: PeckRules {
        positive_only: true,
        returns_to_clear: true,
        feeds_down: true,
        dwell_each_s: 0.25,
        ..CycleRules::COMMON.peck
    },
    tap: TapRules { starts_spindle: false, ..CycleRules::COMMON.tap },
    ..CycleRules::COMMON
};
