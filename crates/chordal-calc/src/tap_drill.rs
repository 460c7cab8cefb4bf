//! The drill before a tap.

use crate::calculation::{QuantityKind, WorkedCalculation};
use crate::error::CalcError;
use crate::numbers::{AnswerUnit, trimmed};
use crate::thread::ThreadSize;

/// A hole to be tapped.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TapDrill {
    /// The thread, of the 60° profile.
    pub thread: ThreadSize,
    /// How much of the full profile is asked for; 1 is all.
    pub share: f64,
    /// The tap presses the thread instead of cutting it.
    pub forming: bool,
}

/// Depth of the full profile of both sides together over the pitch, as tap makers count it: 3/4·√3.
const FULL: f64 = 1.299;
/// The same for a forming tap: the material that gives way goes into the crests.
const FORMED: f64 = 0.68;

/// Diameter of the hole for a share of the full profile.
///
/// # Errors
/// When nothing is left of the hole, or the share is none.
pub fn tap_drill(ask: &TapDrill, units: AnswerUnit) -> Result<WorkedCalculation, CalcError> {
    let TapDrill { thread, share, forming } = *ask;
    thread.check(units)?;
    if !(share > 0.0 && share <= 1.0) {
        return Err(CalcError::new(
            format!("{} % of a thread is not possible", trimmed(share * 100.0, 2)),
            "give more than 0 and at most 100; 60 to 75 is usual",
        ));
    }
    let factor = if forming { FORMED } else { FULL };
    let hole = thread.major - factor * thread.pitch * share;
    if hole <= 0.0 {
        return Err(CalcError::new(
            format!(
                "the thread is deeper than its diameter of {}: no hole is left",
                units.length(thread.major)
            ),
            "check diameter and pitch",
        ));
    }
    let mut worked = WorkedCalculation::new("Hole for a tap", units);
    worked.input("D", "nominal diameter", QuantityKind::Length, thread.major);
    worked.input("P", "pitch", QuantityKind::Length, thread.pitch);
    worked.input("e", "share of the full profile", QuantityKind::Number, share);
    let (d, p, e) = (units.number(thread.major), units.number(thread.pitch), trimmed(share, 4));
    worked.result(
        "B",
        "diameter of the hole",
        QuantityKind::Length,
        hole,
        &format!("D − {factor}·P·e"),
        format!("{d} − {factor}·{p}·{e}"),
    );
    worked.note(match forming {
        true => {
            "For a tap that presses the thread. Its hole is held closer than that of a cutting tap."
        }
        false => "For a tap that cuts. Take the nearest drill; the tap's maker may say another.",
    });
    Ok(worked)
}
