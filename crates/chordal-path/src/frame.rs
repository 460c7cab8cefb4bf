//! Offsets and lengths between program and machine coordinates.

use chordal_command::{AxisMask, Command, CommandKind, Position};

/// What lies between program and machine coordinates while commands go by.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame {
    /// Added to program coordinates, without tool length, mm and rad.
    pub work: Position,
    /// Added to Z by the tool length, mm.
    pub length: f64,
    /// The axes for which the way to machine coordinates is known.
    pub known: AxisMask,
}

impl Frame {
    /// The frame before the first command.
    pub fn new(offset: Position, known: AxisMask) -> Frame {
        Frame { work: offset, length: 0.0, known }
    }

    /// Follows a command; true when the frame changed.
    pub fn follow(&mut self, command: &Command) -> bool {
        match &command.kind {
            CommandKind::WorkOffset { offset, known, .. } => {
                self.work = *offset;
                self.known = *known;
            }
            CommandKind::ToolLength { length_mm, known, .. } => {
                self.length = length_mm.unwrap_or(0.0);
                self.known = *known;
            }
            _ => return false,
        }
        true
    }

    /// A program coordinate in machine coordinates.
    pub fn machine(&self, position: &Position, axis: usize) -> f64 {
        let length = if axis == 2 { self.length } else { 0.0 };
        position[axis] + self.work[axis] + length
    }
}
