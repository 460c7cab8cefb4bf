//! What is switched on: spindle, coolant, compensation, path mode, overrides.

/// What the spindle does.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum SpindleState {
    /// Stands.
    Off,
    /// M3.
    Cw,
    /// M4.
    Ccw,
    /// Stands at its mark (M19).
    Oriented,
}

/// Coolant valves.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default, Hash)]
pub struct Coolant {
    /// Mist.
    pub mist: bool,
    /// Flood.
    pub flood: bool,
    /// Through the tool.
    pub through_tool: bool,
}

/// Cutter radius compensation.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum CompensationSide {
    /// G40.
    Off,
    /// G41.
    Left,
    /// G42.
    Right,
}

/// How corners are passed.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum PathMode {
    /// Every corner exactly, without a stop where the path is smooth (LinuxCNC G61).
    ExactPath,
    /// A stop at every corner (G61, LinuxCNC G61.1, Fadal G9).
    ExactStop,
    /// Corners may be rounded (G64, Fadal G8) within a distance in mm, where one is given.
    Continuous {
        /// Largest distance from the programmed path; `None` when the control decides.
        tolerance_mm: Option<f64>,
        /// Many short blocks become one smooth curve within that distance; otherwise each corner is
        /// passed by itself.
        joined: bool,
    },
}

/// Which overrides of the operator's panel act.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Overrides {
    /// On the feed of cuts.
    pub feed: bool,
    /// On rapids.
    pub rapid: bool,
}

impl Overrides {
    /// Both act, as at power-on and after the program's end.
    pub const ON: Overrides = Overrides { feed: true, rapid: true };
}
