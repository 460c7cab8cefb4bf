//! The state of a control, item by item: a program that restarts within another one must restore all of them.

use chordal_command::{AxisMask, Position};

use crate::state::State;

/// One item of the state.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug, Hash)]
pub enum StateItem {
    /// Units of the text.
    Units,
    /// G90 or G91, and the position at which G91 became active.
    Distance,
    /// The plane of arcs and compensation.
    Plane,
    /// The motion of a block without a motion code.
    Motion,
    /// The meaning of centre words.
    ArcCenter,
    /// The canned cycle.
    Cycle,
    /// The modal words of the cycle, and what turning cycles remember.
    CycleWords,
    /// The unit of F.
    FeedMode,
    /// F.
    Feed,
    /// What the spindle does.
    Spindle,
    /// The spindle speed.
    SpindleSpeed,
    /// A live tool.
    LiveTool,
    /// The cutting speed that is kept.
    SurfaceSpeed,
    /// The limit of the spindle.
    SpeedLimit,
    /// Coolant.
    Coolant,
    /// The tool in the spindle.
    Tool,
    /// The tool made ready, where it is not the one in the spindle.
    ReadyTool,
    /// Cutter compensation.
    Side,
    /// The number of the radius offset.
    RadiusOffset,
    /// The work coordinate system.
    WorkOffset,
    /// G52 and G92, and the error of a clamped part (G54.2).
    Shift,
    /// The tool length in force.
    LengthOffset,
    /// The length offset that was named and waits for its code.
    NamedLength,
    /// What the program has written into the tables of offsets.
    Tables,
    /// Mirror, scaling, rotation, polar coordinates, a surface, tool centre point control.
    Frames,
    /// How corners are passed.
    PathMode,
    /// Which overrides are enabled.
    Overrides,
    /// The known coordinates of the tool tip.
    Position,
}

impl StateItem {
    /// What the item is called in messages about a difference.
    pub fn word(self) -> &'static str {
        match self {
            StateItem::Units => "the unit",
            StateItem::Distance => "G90 or G91",
            StateItem::Plane => "the plane",
            StateItem::Motion => "the motion code",
            StateItem::ArcCenter => "the way of arc centres",
            StateItem::Cycle => "the canned cycle",
            StateItem::CycleWords => "a word of the cycle",
            StateItem::FeedMode => "the feed mode",
            StateItem::Feed => "the feed",
            StateItem::Spindle => "the spindle",
            StateItem::SpindleSpeed => "the spindle speed",
            StateItem::LiveTool => "the live tool",
            StateItem::SurfaceSpeed => "the cutting speed",
            StateItem::SpeedLimit => "the limit of the spindle",
            StateItem::Coolant => "the coolant",
            StateItem::Tool => "the tool",
            StateItem::ReadyTool => "the tool made ready",
            StateItem::Side => "cutter compensation",
            StateItem::RadiusOffset => "the radius offset",
            StateItem::WorkOffset => "the work offset",
            StateItem::Shift => "the shift of the zero",
            StateItem::LengthOffset => "the length offset",
            StateItem::NamedLength => "the length that was named",
            StateItem::Tables => "the table of offsets",
            StateItem::Frames => "a frame",
            StateItem::PathMode => "the path mode",
            StateItem::Overrides => "the overrides",
            StateItem::Position => "the position",
        }
    }
}

/// The value of an item.
#[derive(Clone, PartialEq, Debug)]
pub enum StateValue {
    /// It has no value.
    None,
    /// Numbers: mm, rad, mm/s, rev/min.
    Numbers(Vec<f64>),
    /// One of several: the debug text of its type in this library.
    Word(String),
    /// Numbers of table entries, each with its name.
    Places(Vec<(String, Vec<Option<f64>>)>),
}

impl From<Option<f64>> for StateValue {
    fn from(value: Option<f64>) -> StateValue {
        value.map_or(StateValue::None, |value| StateValue::Numbers(vec![value]))
    }
}

impl From<Option<u32>> for StateValue {
    fn from(value: Option<u32>) -> StateValue {
        value.map(f64::from).into()
    }
}

fn word(value: impl std::fmt::Debug) -> StateValue {
    StateValue::Word(format!("{value:?}"))
}

fn place(position: Position, known: AxisMask) -> StateValue {
    let axes = position.iter().enumerate();
    StateValue::Numbers(axes.filter(|(axis, _)| known.has(*axis)).map(|(_, at)| *at).collect())
}

impl State {
    /// All items with their values. The state is destructured, so that a new field does not compile until it is
    /// considered here.
    pub fn state_items(&self) -> Vec<(StateItem, StateValue)> {
        let State {
            position,
            known,
            machine_known: _,
            start: _,
            control_position: _,
            astray: _,
            unknown: _,
            offsets,
            frames: _,
            frame_jump: _,
            last_rotation_deg: _,
            polar: _,
            surface: _,
            part_frame: _,
            has_tilted_plane: _,
            tool_by_vector: _,
            length_along_tool: _,
            tip_by_kinematics: _,
            origin_on_table: _,
            named_on_table: _,
            units,
            plane,
            incremental,
            // A restart sets it by writing G91 at the right position.
            incremental_from: _,
            motion: _,
            armed: _,
            arc_over_rapid: _,
            arc_center,
            feed_mode,
            feed,
            feed_angular: _,
            feed_over: _,
            spindle,
            rpm,
            live,
            live_rpm: _,
            surface_speed,
            last_surface_speed: _,
            speed_limit,
            coolant,
            tool,
            selected_tool,
            side,
            radius_offset,
            named_length,
            return_to_r,
            cycle,
            cycle_dwell_s: _,
            path,
            overrides,
            turning,
        } = self;
        let frames = self.frame_kinds();
        let shift = (0..position.len()).map(|axis| offsets.shift_of(axis));
        let shift = shift.chain([f64::from(offsets.fixture().number)]).collect();
        vec![
            (StateItem::Units, word(units)),
            (StateItem::Distance, word(incremental)),
            (StateItem::Plane, word(plane)),
            (StateItem::Motion, word(self.motion_mode())),
            (StateItem::ArcCenter, word(arc_center)),
            (StateItem::Cycle, word(cycle.as_ref().map(|cycle| cycle.kind))),
            (StateItem::CycleWords, word((cycle, return_to_r, turning))),
            (StateItem::FeedMode, word(feed_mode)),
            (StateItem::Feed, (*feed).into()),
            (StateItem::Spindle, word(spindle)),
            (StateItem::SpindleSpeed, Some(*rpm).into()),
            (StateItem::LiveTool, word(live)),
            (StateItem::SurfaceSpeed, (*surface_speed).into()),
            (StateItem::SpeedLimit, (*speed_limit).into()),
            (StateItem::Coolant, word(coolant)),
            (StateItem::Tool, Some(*tool).into()),
            (StateItem::ReadyTool, selected_tool.filter(|ready| ready != tool).into()),
            (StateItem::Side, word(side)),
            (StateItem::RadiusOffset, (*radius_offset).into()),
            (StateItem::WorkOffset, word(offsets.active())),
            (StateItem::Shift, StateValue::Numbers(shift)),
            (StateItem::LengthOffset, length(self)),
            (StateItem::NamedLength, (*named_length).into()),
            (StateItem::Tables, StateValue::Places(offsets.all_written())),
            (StateItem::Frames, word(frames)),
            (StateItem::PathMode, word(path.in_force())),
            (StateItem::Overrides, word(overrides.in_force())),
            (StateItem::Position, place(*position, *known)),
        ]
    }
}

/// The number of the length offset, or the offsets that the program gives by value.
fn length(state: &State) -> StateValue {
    match state.offsets.own_length() {
        Some(values) => StateValue::Places(vec![("own".into(), values.map(Some).to_vec())]),
        None => state.offsets.length().number.into(),
    }
}
