//! The bodies of a machine itself, and the order of the axes that carry them.

use crate::axis::Axis;

/// The order of the linear axes, from the base outwards, for those of the part and for those of the tool.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[allow(missing_docs, reason = "each is the order of its letters")]
pub enum LinearOrder {
    Xyz,
    Xzy,
    #[default]
    Yxz,
    Yzx,
    Zxy,
    Zyx,
}

impl LinearOrder {
    /// Every order.
    pub const ALL: [LinearOrder; 6] = [
        LinearOrder::Xyz,
        LinearOrder::Xzy,
        LinearOrder::Yxz,
        LinearOrder::Yzx,
        LinearOrder::Zxy,
        LinearOrder::Zyx,
    ];

    /// The word for it in machine files.
    pub const fn as_str(self) -> &'static str {
        match self {
            LinearOrder::Xyz => "XYZ",
            LinearOrder::Xzy => "XZY",
            LinearOrder::Yxz => "YXZ",
            LinearOrder::Yzx => "YZX",
            LinearOrder::Zxy => "ZXY",
            LinearOrder::Zyx => "ZYX",
        }
    }

    /// The axes from the base outwards.
    pub const fn axes(self) -> [Axis; 3] {
        use Axis::{X, Y, Z};
        match self {
            LinearOrder::Xyz => [X, Y, Z],
            LinearOrder::Xzy => [X, Z, Y],
            LinearOrder::Yxz => [Y, X, Z],
            LinearOrder::Yzx => [Y, Z, X],
            LinearOrder::Zxy => [Z, X, Y],
            LinearOrder::Zyx => [Z, Y, X],
        }
    }
}

/// What a body of the machine is fixed to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum SolidLink {
    /// The machine's base, which stands.
    Base,
    /// What an axis moves.
    Axis(Axis),
    /// What holds the tool.
    Spindle,
}

impl SolidLink {
    /// Every link.
    pub const ALL: [SolidLink; 8] = [
        SolidLink::Base,
        SolidLink::Axis(Axis::X),
        SolidLink::Axis(Axis::Y),
        SolidLink::Axis(Axis::Z),
        SolidLink::Axis(Axis::A),
        SolidLink::Axis(Axis::B),
        SolidLink::Axis(Axis::C),
        SolidLink::Spindle,
    ];

    /// The word for it in machine files.
    pub const fn as_str(self) -> &'static str {
        match self {
            SolidLink::Base => "base",
            SolidLink::Axis(Axis::X) => "X",
            SolidLink::Axis(Axis::Y) => "Y",
            SolidLink::Axis(Axis::Z) => "Z",
            SolidLink::Axis(Axis::A) => "A",
            SolidLink::Axis(Axis::B) => "B",
            SolidLink::Axis(Axis::C) => "C",
            SolidLink::Spindle => "spindle",
        }
    }
}

/// The shape of a body of the machine.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum MachineSolidShape {
    /// Between two opposite corners.
    Box,
    /// Between the middles of two ends: a cylinder, or a cone with another diameter at its end.
    Cylinder,
}

impl MachineSolidShape {
    /// Every shape.
    pub const ALL: [MachineSolidShape; 2] = [MachineSolidShape::Box, MachineSolidShape::Cylinder];

    /// The word for it in machine files.
    pub const fn as_str(self) -> &'static str {
        match self {
            MachineSolidShape::Box => "box",
            MachineSolidShape::Cylinder => "cylinder",
        }
    }
}

/// A body of the machine as written in the file: convex, in machine coordinates with every axis at zero, where the gauge
/// point of the spindle is at zero. `None`: not given.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MachineSolid {
    /// What it is fixed to.
    pub on: Option<SolidLink>,
    /// Its shape.
    pub shape: Option<MachineSolidShape>,
    /// A corner of a box, or the middle of an end of a cylinder: X, Y, Z, mm.
    pub from: [Option<f64>; 3],
    /// The opposite corner or end: X, Y, Z, mm.
    pub to: [Option<f64>; 3],
    /// The diameter of a cylinder, of a cone that at `from`, mm.
    pub diameter_mm: Option<f64>,
    /// The diameter of a cone at `to`, mm; `None`: as at `from`.
    pub end_diameter_mm: Option<f64>,
    /// The names of other bodies that it may touch.
    pub may_touch: Vec<String>,
}
