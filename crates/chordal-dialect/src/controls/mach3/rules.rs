//! How Mach3 moves, cuts and drills: as the RS274/NGC interpreter that LinuxCNC is based on, too.

use super::super::linuxcnc::PARAMETERS as FAMILY;
use super::super::linuxcnc::rules::CYCLES as FAMILY_CYCLES;
use crate::vocabulary::*;

/// Whether unused words stop a program is not known: they are warnings.
pub(super) const PARAMETERS: Parameters = Parameters {
    offset_zero_in_force: false,
    end_required: false,
    strict_words: false,
    m_groups: M_GROUPS,
    longest_line: 0,
    unit_codes: UnitCodes::Both,
    calls_within_file: true,
    calls_counted_by_q: true,
    calls_upwards: true,
    rules: Rules {
        // M3 without S is accepted: Mach3's screen has a field for S, many routers set the speed by a knob, and LazyCam
        // writes M3 alone.
        speed_by_hand: true,
        // By default M6 runs the macros of the machine alone.
        spindle_stops_at_tool_change: false,
        starts_without_motion: false,
        pocket_is_one_circle: true,
        cycles: CYCLES,
        frames: FRAMES,
        length: LengthRules {
            zero_is_of_tool: false,
            ended_by: LengthRules::COMMON.ended_by,
            ..FAMILY.rules.length
        },
        ..FAMILY.rules
    },
    ..FAMILY
};

/// The modal groups of M codes, in tenths; M7 and M8 may be in one block.
const M_GROUPS: &[&[u16]] = &[&[0, 10, 20, 300, 470], &[30, 40, 50], &[480, 490]];

/// A cycle without P has no dwell.
const CYCLES: CycleRules = CycleRules {
    needs_p: false,
    approach: HoleApproach::FromAboveR,
    bore: BoreRules { spindle_must_turn: false, ..FAMILY_CYCLES.bore },
    ..FAMILY_CYCLES
};

/// G68 has A, B and R; the pole of G16 is the position of the tool.
const FRAMES: FrameRules = FrameRules {
    rotation_center_by_ab: true,
    factors_by_axes: true,
    unequal_arcs: UnequalArcs::Refused,
    polar_about_start: true,
    work_rotation: false,
    ..FAMILY.rules.frames
};
