//! Offsets and lengths between program and machine coordinates.

use chordal_command::{AxisMask, Command, CommandKind, Position};
use chordal_machine::AXES;

/// What lies between program and machine coordinates while commands go by.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame {
    /// Added to program coordinates, without tool length, mm and rad.
    pub work: Position,
    /// Added by the offsets of the tool, the length with them, mm and rad.
    pub tool: Position,
    /// The axes for which the way to machine coordinates is known.
    pub known: AxisMask,
}

impl Frame {
    /// The frame before the first command.
    pub fn new(offset: Position, known: AxisMask) -> Frame {
        Frame { work: offset, tool: [0.0; AXES], known }
    }

    /// Follows a command; true when the frame changed.
    pub fn follow(&mut self, command: &Command) -> bool {
        match &command.kind {
            CommandKind::WorkOffset { offset, known, .. } => {
                self.work = *offset;
                self.known = *known;
            }
            CommandKind::ToolLength { offset, known, .. } => {
                self.tool = *offset;
                self.known = *known;
            }
            _ => return false,
        }
        true
    }

    /// A program coordinate in machine coordinates.
    pub fn machine(&self, position: &Position, axis: usize) -> f64 {
        position[axis] + self.work[axis] + self.tool[axis]
    }
}
