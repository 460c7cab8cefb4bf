//! Tool centre point control: what it makes of the coordinates, and where it starts, pauses and ends.

use std::sync::Arc;

use chordal_command::{AxisMask, CommandKind, Position, ProgramOffsets, ToolCenterControl};
use chordal_machine::TcpFrame;

use crate::kernel::Kernel;
use crate::state::State;

impl State {
    /// What lies between program coordinates and the gauge point.
    pub(crate) fn program_offsets(&self) -> ProgramOffsets {
        let (work, total) = (self.offsets.work(), self.offsets.total());
        ProgramOffsets { work, tool: std::array::from_fn(|axis| total[axis] - work[axis]) }
    }

    /// The positions of the axes in the work coordinate system: where the tip would be without tool centre point control.
    pub fn axis_position(&self) -> Position {
        let work = self.work_position();
        match &self.tool_center {
            None => work,
            Some(control) => control.axes_of_tip(&work, &self.program_offsets()),
        }
    }

    /// The axes on which the positions of X, Y and Z depend under tool centre point control.
    fn axes_of_chain(control: &ToolCenterControl) -> AxisMask {
        let mut axes = AxisMask::LINEAR;
        let joints = control.chain.iter().flat_map(|chain| chain.joints());
        joints.for_each(|joint| axes.insert(joint.letter.index() + 3));
        axes
    }

    /// Makes the coordinates those of the tip; the machine does not move. They stay known only where all axes are, and
    /// the place of the zero on the machine: it is turned.
    pub(crate) fn start_tool_center(&mut self, control: Arc<ToolCenterControl>) {
        let (axes, offsets) = (self.work_position(), self.program_offsets());
        let known = self.frames.map().known(self.known);
        let is_known = control.is_aligned(&axes, &offsets)
            || control.chain.is_some() && self.offsets.known().covers(AxisMask::LINEAR);
        let is_known = is_known && known.covers(State::axes_of_chain(&control));
        let tip = control.tip_of_axes(&axes, &offsets);
        self.tool_center = Some(control);
        self.stand_at(tip, if is_known { known } else { known.without(AxisMask::LINEAR) });
    }

    /// Makes the coordinates those of the axes again; the machine does not move.
    pub(crate) fn stop_tool_center(&mut self) -> Option<Arc<ToolCenterControl>> {
        let control = self.tool_center.take()?;
        let (tip, offsets) = (self.work_position(), self.program_offsets());
        let axes = control.axes_of_tip(&tip, &offsets);
        let known = self.frames.map().known(self.known);
        let is_known = known.covers(State::axes_of_chain(&control))
            && (control.is_aligned(&tip, &offsets)
                || control.chain.is_some() && self.offsets.known().covers(AxisMask::LINEAR));
        let known = if is_known { known } else { known.without(AxisMask::LINEAR) };
        self.stand_at(axes, known);
        Some(control)
    }

    /// After a move under tool centre point control: every linear axis may have moved, and is known where all are.
    #[cold]
    pub(crate) fn place_axes_of_tip(&mut self) {
        let Some(control) = &self.tool_center else { return };
        let known = self.frames.map().known(self.known);
        let is_known = control.chain.is_some()
            && known.covers(State::axes_of_chain(control))
            && self.offsets.known().covers(AxisMask::LINEAR);
        self.machine_known = match is_known {
            true => self.machine_known.or(AxisMask::LINEAR),
            false => self.machine_known.without(AxisMask::LINEAR),
        };
        if is_known {
            self.start.machine = self.start.machine.without(AxisMask::LINEAR);
        }
    }
}

impl Kernel<'_> {
    /// From here on coordinates are those of the tip in a frame that is fixed to the part; the machine does not move. True
    /// if the machine file gives the rotary axes, so that the linear axes can be followed.
    pub fn begin_tool_center(&mut self) -> bool {
        self.end_tool_center();
        let chain = self.machine.kinematic_chain().ok();
        let offsets = self.state.program_offsets();
        let place = self.state.work_position();
        let frame_angles = std::array::from_fn(|axis| match self.machine.tcp_frame {
            TcpFrame::Zero => offsets.work[axis + 3],
            TcpFrame::Activation => offsets.work[axis + 3] + place[axis + 3],
        });
        let is_followed = chain.is_some();
        self.resume_tool_center(Arc::new(ToolCenterControl { chain, frame_angles }));
        is_followed
    }

    /// Ends tool centre point control: coordinates are those of the axes again.
    pub fn end_tool_center(&mut self) {
        self.suspend_tool_center();
    }

    /// Ends it for a move of the axes themselves, such as to a reference point; what was in force.
    pub(crate) fn suspend_tool_center(&mut self) -> Option<Arc<ToolCenterControl>> {
        self.state.tool_center.as_ref()?;
        self.end_corner_before("tool centre point control ends before the next move");
        let control = self.state.stop_tool_center();
        self.emit(CommandKind::ToolCenter { control: None, position: self.state.position });
        control
    }

    /// Begins it, or goes on with it after such a move.
    pub(crate) fn resume_tool_center(&mut self, control: Arc<ToolCenterControl>) {
        self.state.start_tool_center(Arc::clone(&control));
        let position = self.state.position;
        self.emit(CommandKind::ToolCenter { control: Some(control), position });
    }
}
