//! The states of spindle, coolant, compensation, path mode and overrides.

/// The state of the spindle.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum SpindleState {
    /// Stopped.
    Off,
    /// Clockwise (M3).
    Cw,
    /// Counter-clockwise (M4).
    Ccw,
    /// Stopped at its reference angle (M19).
    Oriented,
}

/// Which coolant valves are open.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default, Hash)]
pub struct Coolant {
    /// Mist.
    pub mist: bool,
    /// Flood.
    pub flood: bool,
    /// Coolant through the tool.
    pub through_tool: bool,
}

/// Cutter radius compensation.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum CompensationSide {
    /// None (G40).
    Off,
    /// Left of the path (G41).
    Left,
    /// Right of the path (G42).
    Right,
}

impl CompensationSide {
    /// 1 left of the path, -1 right of it, 0 without compensation.
    pub const fn sign(self) -> f64 {
        match self {
            CompensationSide::Off => 0.0,
            CompensationSide::Left => 1.0,
            CompensationSide::Right => -1.0,
        }
    }

    /// The other side if `mirrored` is true, otherwise the same one.
    #[must_use]
    pub const fn mirrored_if(self, mirrored: bool) -> CompensationSide {
        match self {
            CompensationSide::Left if mirrored => CompensationSide::Right,
            CompensationSide::Right if mirrored => CompensationSide::Left,
            same => same,
        }
    }
}

/// How corners are passed.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum PathMode {
    /// Exactly along the path, without a stop where it is smooth (LinuxCNC G61).
    ExactPath,
    /// A stop at every corner (G61, LinuxCNC G61.1, Fadal G9).
    ExactStop,
    /// Corners may be rounded (G64, Fadal G8).
    Continuous {
        /// Largest distance from the programmed path; `None` when the control decides.
        tolerance_mm: Option<f64>,
        /// Many short blocks become one smooth curve within that distance; otherwise each corner is
        /// passed by itself.
        joined: bool,
    },
}

/// Which overrides of the operator's panel are enabled.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Overrides {
    /// The feed override.
    pub feed: bool,
    /// The rapid override.
    pub rapid: bool,
}

impl Overrides {
    /// Both are enabled, as at power-on and after the program's end.
    pub const ON: Overrides = Overrides { feed: true, rapid: true };
}
