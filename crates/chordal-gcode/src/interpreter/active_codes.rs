//! The active codes, as the control writes them.

use chordal_command::CompensationSide;
use chordal_dialect::Control;
use chordal_dialect::{Action, ModeCode};
use chordal_kernel::State;

/// The G codes of the active modes: for each mode the first row of the table with its action. Work offset and tool
/// length are reported by their own names.
pub(super) fn active_codes(state: &State, control: &Control) -> Vec<String> {
    let mut actions = Vec::new();
    actions.extend(state.motion_mode().map(Action::from));
    actions.push(state.plane.into());
    actions.push(Action::of_distance(state.incremental));
    actions.push(state.feed_mode.into());
    actions.push(state.units.into());
    actions.push(match state.side {
        CompensationSide::Off => Action::Mode(ModeCode::CompensationOff),
        CompensationSide::Left => Action::Mode(ModeCode::CompensationLeft),
        CompensationSide::Right => Action::Mode(ModeCode::CompensationRight),
    });
    if state.cycle.is_some() {
        actions.push(if state.return_to_r {
            Action::Mode(ModeCode::ReturnToR)
        } else {
            Action::Mode(ModeCode::ReturnInitial)
        });
    }
    let rows = control.table.g_codes;
    let code = |action| rows.iter().find(|row| row.action == action).map(|row| row.name(b'G'));
    actions.into_iter().filter_map(code).collect()
}
