//! What a control remembers between two blocks, as its screen shows it.

use chordal_command::{
    AxisMask, CompensationSide, Coolant, FeedMode, PathMode, Position, SpindleState, Units,
    WorkName,
};
use chordal_geometry::{Plane, TurnDirection};

use crate::frames::FrameKinds;
use crate::rules::{ArcCenter, CycleKind};
use crate::state::{LiveTool, ModalMotion, SplineForm, State, TurnPass};

/// The motion of a block without a motion code.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum MotionMode {
    /// A rapid.
    Rapid,
    /// A straight cut.
    Linear,
    /// An arc.
    Arc(TurnDirection),
    /// A spiral.
    Spiral(TurnDirection),
    /// A straight cut synchronized with the spindle.
    Thread,
    /// A synchronized cut in, and out again with the spindle reversed.
    RigidTap,
    /// A spline.
    Spline(SplineForm),
    /// A turning pass with its return to the start.
    Turn(TurnPass),
    /// A probe move, where its code stays active.
    Probe {
        /// The control stops with an alarm when nothing was touched.
        must_hit: bool,
    },
    /// A threading cycle of several passes, where its code stays active.
    ThreadPasses,
    /// A canned cycle.
    Cycle(CycleKind),
}

/// The modal state after a block.
#[derive(Clone, Debug, PartialEq)]
pub struct Modal {
    /// The active G codes as the control writes them (`G1`, `G17`, `G41`), the motion first.
    pub codes: Vec<String>,
    /// The motion of a block without a motion code; `None` when a block needs one.
    pub motion: Option<MotionMode>,
    /// G91 is active.
    pub incremental: bool,
    /// The plane of arcs and compensation.
    pub plane: Plane,
    /// The side of cutter compensation.
    pub side: CompensationSide,
    /// The meaning of I, J and K of arcs.
    pub arc_center: ArcCenter,
    /// The active cycle; `None` without one.
    pub cycle: Option<CycleKind>,
    /// The tool tip in program coordinates, mm and rad.
    pub position: Position,
    /// The axes whose program coordinate is known.
    pub known: AxisMask,
    /// Of these, the axes that have not moved since the run began: they stand where the run assumes that it begins.
    pub unmoved: AxisMask,
    /// The machine coordinates, mm and rad.
    pub machine_position: Position,
    /// The axes whose machine coordinate is known.
    pub machine_known: AxisMask,
    /// Units of the program text.
    pub units: Units,
    /// The unit of F.
    pub feed_mode: FeedMode,
    /// F in mm/s, 1/s or mm per revolution; `None` before any F.
    pub feed: Option<f64>,
    /// What the spindle does.
    pub spindle: SpindleState,
    /// The programmed speed of the spindle, rev/min.
    pub rpm: f64,
    /// The running live tool, which cuts in place of the spindle; `None` when none runs.
    pub live: Option<LiveTool>,
    /// The cutting speed that the spindle keeps (G96), mm/s; `None` with a fixed speed.
    pub surface_speed: Option<f64>,
    /// The limit of the spindle speed (G50 S), rev/min; `None` without one.
    pub speed_limit: Option<f64>,
    /// Coolant valves.
    pub coolant: Coolant,
    /// The tool in the spindle; 0 for none.
    pub tool: u32,
    /// The tool made ready for the next change; `None` before a T word.
    pub selected_tool: Option<u32>,
    /// The tool tip in the work coordinate system, without mirror, scaling or rotation, mm and rad.
    pub work_position: Position,
    /// The kinds of active frames.
    pub frames: FrameKinds,
    /// The work coordinate system.
    pub work: WorkName,
    /// Its name on this control.
    pub work_name: String,
    /// Number of the active tool length offset; `None` without one.
    pub length_offset: Option<u32>,
    /// Active tool offsets that the program itself gives (G43.1), mm and rad; `None` otherwise.
    pub own_length: Option<Position>,
    /// Number of the radius offset that compensation uses; `None` before one.
    pub radius_offset: Option<u32>,
    /// How corners are passed.
    pub path_mode: PathMode,
}

impl Modal {
    /// The modal part of a state; `codes` are the active codes in the language of the program.
    pub fn of(state: &State, codes: Vec<String>) -> Modal {
        let mut machine_position = state.position;
        for (axis, value) in machine_position.iter_mut().enumerate() {
            *value = state.machine_position(axis);
        }
        let work = state.offsets.active();
        Modal {
            codes,
            motion: state.motion_mode(),
            incremental: state.incremental,
            plane: state.plane,
            side: state.side,
            arc_center: state.arc_center,
            cycle: state.cycle.as_ref().map(|cycle| cycle.kind),
            position: state.position,
            known: state.known,
            unmoved: state.start.program,
            machine_position,
            machine_known: state.machine_known,
            units: state.units,
            feed_mode: state.feed_mode,
            feed: state.feed,
            spindle: state.spindle,
            rpm: state.rpm,
            live: state.live,
            surface_speed: state.surface_speed,
            speed_limit: state.speed_limit,
            coolant: state.coolant,
            tool: state.tool,
            selected_tool: state.selected_tool,
            work_position: state.work_position(),
            frames: state.frame_kinds(),
            work,
            work_name: state.offsets.key(work),
            length_offset: state.offsets.length().number,
            own_length: state.offsets.own_length(),
            radius_offset: state.radius_offset,
            path_mode: state.path.in_force(),
        }
    }
}

impl State {
    /// The kinds of active frames, polar coordinates and surfaces included.
    pub(crate) fn frame_kinds(&self) -> FrameKinds {
        FrameKinds {
            polar: self.polar.is_some(),
            surface: self.surface.is_some(),
            part: self.part_frame.is_some(),
            ..self.frames.kinds()
        }
    }

    /// The motion of a block without a motion code; `None` when a block needs one.
    pub fn motion_mode(&self) -> Option<MotionMode> {
        match (&self.cycle, self.motion) {
            (Some(cycle), _) => Some(MotionMode::Cycle(cycle.kind)),
            (None, ModalMotion::Rapid) => Some(MotionMode::Rapid),
            (None, ModalMotion::Linear) => Some(MotionMode::Linear),
            (None, ModalMotion::Arc(direction)) => Some(MotionMode::Arc(direction)),
            (None, ModalMotion::Spiral(direction)) => Some(MotionMode::Spiral(direction)),
            (None, ModalMotion::Thread) => Some(MotionMode::Thread),
            (None, ModalMotion::RigidTap) => Some(MotionMode::RigidTap),
            (None, ModalMotion::Spline(form)) => Some(MotionMode::Spline(form)),
            (None, ModalMotion::Probe { must_hit }) => Some(MotionMode::Probe { must_hit }),
            (None, ModalMotion::ThreadPasses) => Some(MotionMode::ThreadPasses),
            (None, ModalMotion::Turn(pass)) => Some(MotionMode::Turn(pass)),
            (None, ModalMotion::None) => None,
        }
    }
}
