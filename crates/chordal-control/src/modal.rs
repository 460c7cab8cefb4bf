//! What a control remembers between two blocks, as its screen shows it.

use chordal_geometry::{Direction, Plane};

use crate::command::{
    AxisMask, Coolant, FeedMode, PathMode, Position, Side, SpindleState, Units, WorkName,
};
use crate::control::Control;
use crate::parameters::ArcCenter;
use crate::state::{Motion, State};
use crate::table::{Action, CycleKind};

/// The modal state after a block.
#[derive(Clone, Debug, PartialEq)]
pub struct Modal {
    /// The G codes in force by the control's own numbers (`G1`, `G17`, `G41`), the motion first.
    pub codes: Vec<String>,
    /// What a block without a motion code does; `None` where it needs one.
    pub motion: Option<Action>,
    /// G91 is in force.
    pub incremental: bool,
    /// The plane of arcs and compensation.
    pub plane: Plane,
    /// The side of cutter compensation.
    pub side: Side,
    /// What I, J and K of arcs say.
    pub arc_center: ArcCenter,
    /// The cycle in force.
    pub cycle: Option<CycleKind>,
    /// The tool tip in program coordinates, mm and rad.
    pub position: Position,
    /// The axes whose program coordinate is known.
    pub known: AxisMask,
    /// The machine coordinates, mm and rad.
    pub machine_position: Position,
    /// The axes whose machine coordinate is known.
    pub machine_known: AxisMask,
    /// Units of the program text.
    pub units: Units,
    /// What F counts.
    pub feed_mode: FeedMode,
    /// F in mm/s, 1/s or mm per revolution; `None` before any F.
    pub feed: Option<f64>,
    /// What the spindle does.
    pub spindle: SpindleState,
    /// Its speed, rev/min.
    pub rpm: f64,
    /// Coolant valves.
    pub coolant: Coolant,
    /// The tool in the spindle; 0 for none.
    pub tool: u32,
    /// The tool made ready.
    pub selected_tool: Option<u32>,
    /// The work coordinate system.
    pub work: WorkName,
    /// Its name on this control.
    pub work_name: String,
    /// Number of the tool length offset in force.
    pub length_offset: Option<u32>,
    /// Number of the radius offset that compensation uses.
    pub radius_offset: Option<u32>,
    /// How corners are passed.
    pub path_mode: PathMode,
}

impl Modal {
    pub(crate) fn of(state: &State, control: &Control) -> Modal {
        let mut machine_position = state.position;
        for (axis, value) in machine_position.iter_mut().enumerate() {
            *value = state.machine_position(axis);
        }
        let work = state.offsets.active();
        Modal {
            codes: codes(state, control),
            motion: motion(state),
            incremental: state.incremental,
            plane: state.plane,
            side: state.side,
            arc_center: state.arc_center,
            cycle: state.cycle.as_ref().map(|cycle| cycle.kind),
            position: state.position,
            known: state.known,
            machine_position,
            machine_known: state.machine_known,
            units: state.units,
            feed_mode: state.feed_mode,
            feed: Some(state.feed).filter(|feed| feed.is_finite()),
            spindle: state.spindle,
            rpm: state.rpm,
            coolant: state.coolant,
            tool: state.tool,
            selected_tool: state.selected_tool,
            work,
            work_name: state.offsets.key(work),
            length_offset: state.offsets.length().number,
            radius_offset: state.radius_offset,
            path_mode: state.path.in_force(),
        }
    }
}

/// The codes by the first row of the table that does what is in force. The work offset and the
/// tool length have names of their own.
fn codes(state: &State, control: &Control) -> Vec<String> {
    let mut actions = Vec::new();
    actions.extend(motion(state));
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

fn motion(state: &State) -> Option<Action> {
    match (&state.cycle, state.motion) {
        (Some(cycle), _) => Some(Action::Cycle(cycle.kind)),
        (None, Motion::Rapid) => Some(Action::Rapid),
        (None, Motion::Linear) => Some(Action::Linear),
        (None, Motion::Arc(Direction::Cw)) => Some(Action::ArcCw),
        (None, Motion::Arc(Direction::Ccw)) => Some(Action::ArcCcw),
        (None, Motion::Spiral(Direction::Cw)) => Some(Action::SpiralCw),
        (None, Motion::Spiral(Direction::Ccw)) => Some(Action::SpiralCcw),
        (None, Motion::None) => None,
    }
}
