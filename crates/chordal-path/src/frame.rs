//! The offsets between program and machine coordinates.

use std::sync::Arc;

use chordal_command::{
    AxisMask, Command, CommandKind, PartFrame, Position, ProgramOffsets, SurfaceRun, WorkName,
    WorkZero,
};
use chordal_machine::AXES;

/// The relation between program and machine coordinates, which follows the commands of a run.
#[derive(Clone, Debug, PartialEq)]
pub struct ProgramFrame {
    /// The active work coordinate system.
    pub name: WorkName,
    /// Where the zero of program coordinates comes from.
    pub zero: WorkZero,
    /// What is added to program coordinates, without the tool offset, mm and rad.
    pub work: Position,
    /// The offset of the tool, including its length, that is added as well, mm and rad.
    pub tool: Position,
    /// The axes whose machine coordinates are known.
    pub known: AxisMask,
    /// The surface on which two coordinates lie, and the position of its axis; `None` without one.
    pub surface: Option<SurfaceRun>,
    /// Tool centre point control; `None` when coordinates are those of the axes.
    pub part_frame: Option<Arc<PartFrame>>,
}

impl ProgramFrame {
    /// The frame before the first command, in G54, with this offset (mm and rad) and the axes for which it is known.
    pub fn new(offset: Position, known: AxisMask) -> ProgramFrame {
        ProgramFrame {
            name: WorkName::G(54),
            zero: WorkZero::of_system(offset, known),
            work: offset,
            tool: [0.0; AXES],
            known,
            surface: None,
            part_frame: None,
        }
    }

    /// The same frame with another initial work coordinate system.
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
            CommandKind::PartFrame { frame, .. } => self.part_frame.clone_from(frame),
            CommandKind::End => {
                (self.surface, self.part_frame) = (None, None);
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

    /// Converts a program position at the end of the last move to positions of the real axes, mm and rad.
    #[inline]
    pub fn on_axes(&self, position: &Position) -> Position {
        match (&self.surface, &self.part_frame) {
            (None, None) => *position,
            (Some(surface), _) => surface.on_axes(position),
            (None, Some(control)) => control.axes_of_tip(position, &self.offsets()),
        }
    }

    /// What lies between program coordinates and the gauge point.
    pub fn offsets(&self) -> ProgramOffsets {
        ProgramOffsets { work: self.work, tool: self.tool }
    }

    /// The machine coordinate of an axis at a position of the real axes, mm or rad.
    pub fn machine(&self, position: &Position, axis: usize) -> f64 {
        position[axis] + self.work[axis] + self.tool[axis]
    }
}
