//! Offsets and lengths between program and machine coordinates.

use chordal_command::{AxisMask, Command, CommandKind, Position, SurfaceRun, WorkName, WorkZero};
use chordal_machine::AXES;

/// What lies between program and machine coordinates while commands go by.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ProgramFrame {
    /// The work coordinate system.
    pub name: WorkName,
    /// Where the zero of program coordinates comes from.
    pub zero: WorkZero,
    /// Added to program coordinates, without tool length, mm and rad.
    pub work: Position,
    /// Added by the offsets of the tool, the length with them, mm and rad.
    pub tool: Position,
    /// The axes for which the way to machine coordinates is known.
    pub known: AxisMask,
    /// The surface on which two coordinates lie, with how far its axis has turned.
    pub surface: Option<SurfaceRun>,
}

impl ProgramFrame {
    /// The frame before the first command.
    pub fn new(offset: Position, known: AxisMask) -> ProgramFrame {
        ProgramFrame {
            name: WorkName::G(54),
            zero: WorkZero::of_system(offset, known),
            work: offset,
            tool: [0.0; AXES],
            known,
            surface: None,
        }
    }

    /// The same frame, where another work coordinate system is the first.
    pub fn in_system(self, name: WorkName) -> ProgramFrame {
        ProgramFrame { name, ..self }
    }

    /// Follows a command; true when the frame changed.
    pub fn follow(&mut self, command: &Command) -> bool {
        match &command.kind {
            CommandKind::WorkOffset { name, offset, zero, known, .. } => {
                (self.name, self.zero) = (*name, *zero);
                self.work = *offset;
                self.known = *known;
            }
            CommandKind::ToolLength { offset, known, .. } => {
                self.tool = *offset;
                self.known = *known;
            }
            CommandKind::Surface { surface, .. } => self.surface = surface.map(SurfaceRun::new),
            CommandKind::End => {
                self.surface = None;
                return false;
            }
            kind => {
                if let (Some(surface), Some(motion)) = (&mut self.surface, kind.motion()) {
                    surface.follow(motion, kind.shape());
                }
                return false;
            }
        }
        true
    }

    /// A position of the program with the axes themselves, at the end of the last move.
    #[inline]
    pub fn on_axes(&self, position: &Position) -> Position {
        match &self.surface {
            None => *position,
            Some(surface) => surface.on_axes(position),
        }
    }

    /// A program coordinate of the axes themselves in machine coordinates.
    pub fn machine(&self, position: &Position, axis: usize) -> f64 {
        position[axis] + self.work[axis] + self.tool[axis]
    }
}
