//! The codes in force, by the control's own numbers.

use chordal_command::{FeedMode, Side, Units};
use chordal_dialect::{Action, Control};
use chordal_geometry::Plane;
use chordal_kernel::State;

/// The codes by the first row of the table that does what is in force. The work offset and the
/// tool length have names of their own.
pub(super) fn codes_in_force(state: &State, control: &Control) -> Vec<String> {
    let mut actions = Vec::new();
    actions.extend(state.motion_mode().map(Action::from));
    actions.push(match state.plane {
        Plane::Xy => Action::PlaneXy,
        Plane::Zx => Action::PlaneZx,
        Plane::Yz => Action::PlaneYz,
    });
    actions.push(if state.incremental { Action::Incremental } else { Action::Absolute });
    actions.push(match state.feed_mode {
        FeedMode::PerTime => Action::FeedPerTime,
        FeedMode::InverseTime => Action::FeedInverseTime,
        FeedMode::PerRevolution => Action::FeedPerRevolution,
    });
    actions.push(match state.units {
        Units::Inch => Action::Inch,
        Units::Millimetre => Action::Millimetre,
    });
    actions.push(match state.side {
        Side::Off => Action::CompensationOff,
        Side::Left => Action::CompensationLeft,
        Side::Right => Action::CompensationRight,
    });
    if state.cycle.is_some() {
        actions.push(if state.return_to_r { Action::ReturnToR } else { Action::ReturnInitial });
    }
    let rows = control.table.g_codes;
    let code = |action| rows.iter().find(|row| row.action == action).map(|row| row.name(b'G'));
    actions.into_iter().filter_map(code).collect()
}
