//! The six possible axes of a machine.

use std::fmt;

pub use chordal_geometry::{AXES, AXIS_LETTERS, AXIS_NAMES, PerAxis};

/// An axis. The number of each is its index in arrays over axes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[repr(usize)]
pub enum Axis {
    /// Linear, along the table.
    X = 0,
    /// Linear, across the table.
    Y = 1,
    /// Linear, along the spindle.
    Z = 2,
    /// Rotary, about X.
    A = 3,
    /// Rotary, about Y.
    B = 4,
    /// Rotary, about Z.
    C = 5,
}

impl Axis {
    /// Every axis, in order.
    pub const ALL: PerAxis<Axis> = [Axis::X, Axis::Y, Axis::Z, Axis::A, Axis::B, Axis::C];

    /// The letter of the axis, upper case.
    pub const fn letter(self) -> char {
        match self {
            Axis::X => 'X',
            Axis::Y => 'Y',
            Axis::Z => 'Z',
            Axis::A => 'A',
            Axis::B => 'B',
            Axis::C => 'C',
        }
    }

    /// The axis with a letter, in either case; `None` if there is none.
    pub const fn from_letter(letter: u8) -> Option<Axis> {
        match letter.to_ascii_uppercase() {
            b'X' => Some(Axis::X),
            b'Y' => Some(Axis::Y),
            b'Z' => Some(Axis::Z),
            b'A' => Some(Axis::A),
            b'B' => Some(Axis::B),
            b'C' => Some(Axis::C),
            _ => None,
        }
    }

    /// Whether the axis is rotary (A, B, C): its positions are in radians.
    pub const fn is_rotary(self) -> bool {
        matches!(self, Axis::A | Axis::B | Axis::C)
    }
}

impl fmt::Display for Axis {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.letter())
    }
}
