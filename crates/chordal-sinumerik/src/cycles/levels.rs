//! The planes and depths of a hole, which all drilling cycles compute alike.

use super::arguments::{CycleCall, CycleFault};
use crate::alarms::NO_ALARM;

/// The reference plane is defined incorrectly.
pub(super) const REFERENCE_PLANE: u32 = 61_101;

/// The levels of a hole: absolute coordinates of the drilling axis.
#[derive(Clone, Copy)]
pub(super) struct HoleLevels {
    /// RTP: where the cycle ends.
    pub(super) retract: f64,
    /// RFP: the surface.
    pub(super) reference: f64,
    /// The reference plane and the safety distance: where the feed starts.
    pub(super) start: f64,
    /// The bottom of the hole.
    pub(super) bottom: f64,
    /// 1 when the hole goes toward smaller coordinates, otherwise -1.
    pub(super) direction: f64,
}

/// The names of the parameters of the levels.
pub(super) struct LevelNames {
    pub(super) retract: &'static str,
    pub(super) reference: &'static str,
    pub(super) safety: &'static str,
    pub(super) depth: &'static str,
    pub(super) relative_depth: &'static str,
}

impl LevelNames {
    /// Those of the drilling cycles.
    const USUAL: LevelNames = LevelNames {
        retract: "RTP",
        reference: "RFP",
        safety: "SDIS",
        depth: "DP",
        relative_depth: "DPR",
    };
}

/// Which of DP and DPR is the depth.
#[derive(Clone, Copy, PartialEq)]
enum DepthChoice {
    /// DPR if it is not 0, otherwise DP: `_AMODE` is 0 or missing.
    Compatible,
    Relative,
    Absolute,
}

impl HoleLevels {
    /// The levels of a call with the usual names; `None` when the reference plane is the depth, where the cycle does
    /// nothing (CYCLE82, version 06.02.09).
    ///
    /// # Errors
    /// 61101 when RTP = RFP with a relative depth, or when the retract plane and the depth are on the same side.
    pub(super) fn of_call(call: &CycleCall<'_>) -> Result<Option<HoleLevels>, CycleFault> {
        HoleLevels::of_names(call, &LevelNames::USUAL)
    }

    /// The same with other names of the parameters.
    pub(super) fn of_names(
        call: &CycleCall<'_>,
        names: &LevelNames,
    ) -> Result<Option<HoleLevels>, CycleFault> {
        let (retract, reference) = (call.number(names.retract), call.number(names.reference));
        let relative = call.magnitude(names.relative_depth);
        let uses_relative = match depth_choice(call)? {
            DepthChoice::Compatible => relative != 0.0,
            // Which of the two is meant is not clear.
            DepthChoice::Relative if relative == 0.0 && call.argument(names.depth).is_some() => {
                return Err(unmodelled(call, "_AMODE"));
            }
            DepthChoice::Relative => true,
            DepthChoice::Absolute => false,
        };
        let bottom = if !uses_relative {
            call.number(names.depth)
        } else if retract == reference {
            let text =
                "with a relative depth the retract plane must differ from the reference plane";
            return Err(call.fault(REFERENCE_PLANE, Some(names.reference), text));
        } else {
            reference - (retract - reference).signum() * relative
        };
        let safety = call.magnitude(names.safety);
        HoleLevels::between(call, names.reference, [retract, reference, safety, bottom])
    }

    /// The levels between a retract plane, a reference plane with a safety distance above it, and a bottom. The name is that
    /// of the parameter of the reference plane.
    ///
    /// # Errors
    /// 61101 when the retract plane and the depth are on the same side.
    pub(super) fn between(
        call: &CycleCall<'_>,
        reference_name: &str,
        [retract, reference, safety, bottom]: [f64; 4],
    ) -> Result<Option<HoleLevels>, CycleFault> {
        if reference == bottom {
            return Ok(None);
        }
        let direction = (reference - bottom).signum();
        if (retract - reference) * direction < 0.0 {
            let text = "the reference plane must be between the retract plane and the depth";
            return Err(call.fault(REFERENCE_PLANE, Some(reference_name), text));
        }
        let start = reference + direction * safety;
        Ok(Some(HoleLevels { retract, reference, start, bottom, direction }))
    }

    /// The depth of the bottom below the reference plane: more than 0.
    pub(super) fn total(&self) -> f64 {
        (self.reference - self.bottom).abs()
    }

    /// The level at a depth below the reference plane.
    pub(super) fn at_depth(&self, depth: f64) -> f64 {
        if depth == self.total() { self.bottom } else { self.reference - self.direction * depth }
    }

    /// The level at a depth, but not above the start plane.
    pub(super) fn at_depth_below_start(&self, depth: f64) -> f64 {
        let level = self.at_depth(depth);
        if (level - self.start) * self.direction > 0.0 { self.start } else { level }
    }
}

/// The last digit of `_AMODE` chooses between DP and DPR: 0 as older versions, 1 relative, 2 absolute.
fn depth_choice(call: &CycleCall<'_>) -> Result<DepthChoice, CycleFault> {
    match call.integer("_AMODE") % 10 {
        0 => Ok(DepthChoice::Compatible),
        1 => Ok(DepthChoice::Relative),
        2 => Ok(DepthChoice::Absolute),
        _ => Err(unmodelled(call, "_AMODE")),
    }
}

/// The dwell DTB as G4 takes it: seconds, or revolutions when negative. The second digit of `_AMODE` chooses the unit: 0
/// by the sign, 1 seconds, 2 revolutions.
///
/// # Errors
/// `_AMODE` has digits that are not modelled: they choose the units of further arguments.
pub(super) fn dwell_at_bottom(call: &CycleCall<'_>) -> Result<f64, CycleFault> {
    let amount = call.number("DTB");
    match call.integer("_AMODE") / 10 {
        0 => Ok(amount),
        1 => Ok(amount.abs()),
        2 => Ok(-amount.abs()),
        _ => Err(unmodelled(call, "_AMODE")),
    }
}

pub(super) fn unmodelled(call: &CycleCall<'_>, parameter: &str) -> CycleFault {
    let text =
        format!("{} = {} of {} is not modelled", parameter, call.number(parameter), call.name());
    call.fault(NO_ALARM, Some(parameter), &text)
}
