//! How GRBL 1.1 moves and cuts.

use crate::vocabulary::*;
use chordal_command::Units;

pub(in crate::controls) const PARAMETERS: Parameters = Parameters {
    excess_decimals: ExcessDecimals::Exact,
    decimal_point: DecimalPoint::Calculator,
    center_and_radius: CenterAndRadius::Refused,
    dwell_with_motion: true,
    preset_cleared_after_motion: true,
    offset_zero_in_force: true,
    offset_number_optional: true,
    end_optional: true,
    tool_change: ToolChanger::Sender,
    rules: Rules {
        length: LengthRules::ABSENT,
        units: Units::Millimetre,
        rapid: RapidPath::Straight,
        bare_home_moves_all: true,
        spindle_by_hand: true,
        // F counts along the vector of all axes, and G20 does not scale rotary ones.
        rotary_feed: RotaryFeedRules::measured(RotaryFeed::DegreesAsMillimetres),
        work_values_add: false,
        // There is no stop between a rapid and a cut.
        path: PathRules {
            stop_before_cut: false,
            stop_between_rapids: false,
            stop_after_cut: false,
            junctions: Some(JunctionRules {
                deviation_mm: 0.01,
                blocks: 15,
                arc_tolerance_mm: 0.002,
                arc_segments: None,
                speed_steps_mm_s: None,
                steps_per_mm: [250.0; 3],
                limited_jerk: false,
            }),
            ..PathRules::COMMON
        },
        arc: ArcRules {
            // Beyond this difference the radii must agree to 0.1 %, and beyond a hundred times it the arc is refused.
            radius_error_tolerance_mm: 0.005,
            radius_error_relative: 0.001,
            radius_error_limit_mm: 0.5,
            judged_before: true,
            full_circle_by_radius: FullCircleByRadius::Straight,
            ..ArcRules::COMMON
        },
        ..Rules::COMMON
    },
    ..Parameters::COMMON
};
