//! Which cycles mean the same on two controls.

use chordal::control::{Action, Control, CycleFamily, CycleKind};
use chordal::geometry::Plane;

use crate::convert::codes;
use crate::convert::context::ConvertContext;
use crate::convert::draft::NeedsExpansion;
use crate::convert::trace::BlockExecution;

/// Whether the words of a cycle may stay. The proof has the last word: this keeps away what is known to be
/// otherwise.
pub(super) fn is_kept(
    context: &ConvertContext,
    kind: CycleKind,
    run: &BlockExecution,
) -> Result<(), NeedsExpansion> {
    let [from, to] = context.controls();
    let axes = context.controls().map(|control| control.parameters.rules.cycles.axis);
    let is_same_axis = axes[0] == axes[1] || run.after.plane == Plane::Xy || kind.is_tap();
    let has_code = codes::row(Action::Cycle(kind), to).is_some();
    if has_code && is_same_axis && has_same_moves(kind, from, to, context.exact_cycles) {
        return Ok(());
    }
    Err(NeedsExpansion(format!("{} works differently on {}", kind.facts().name, to.table.title)))
}

/// The moves of a hole are the same; those of pecks may differ unless `exact`.
fn has_same_moves(kind: CycleKind, from: &Control, to: &Control, exact: bool) -> bool {
    let rules = [&from.parameters.rules, &to.parameters.rules];
    let [one, other] = rules.map(|rules| rules.cycles);
    if kind.facts().of_one_control {
        return false;
    }
    match kind.family() {
        // A tap cannot be written out: the spindle would not follow. The proof says what differs.
        CycleFamily::Tap | CycleFamily::Drill | CycleFamily::Bore => true,
        // P can say the lift of G73 where it is one there.
        CycleFamily::ChipBreak => {
            !exact || rules[0].chip_break_mm == rules[1].chip_break_mm || other.peck.p_is_lift
        }
        CycleFamily::Peck => !exact || rules[0].peck_clearance_mm == rules[1].peck_clearance_mm,
        CycleFamily::FineBore => one.bore.shift_at_feed == other.bore.shift_at_feed,
        CycleFamily::BackBore => {
            one.bore.shift_at_feed == other.bore.shift_at_feed && one.bore.back == other.bore.back
        }
    }
}
