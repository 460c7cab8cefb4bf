//! What a control remembers from block to block.

use std::sync::Arc;

use chordal_command::{
    AxisMask, CompensationSide, Coolant, FeedMode, Overrides, PartFrame, Position, SpindleState,
    Units,
};
use chordal_diagnostics::Span;
use chordal_geometry::{Plane, TurnDirection};
use chordal_machine::AXES;

use crate::frames::{Frames, PolarReading};
use crate::offsets::Offsets;
use crate::path_mode::PathState;
use crate::rules::{ArcCenter, CycleKind, Rules, TurningRules};
use crate::surface::SurfaceState;

/// The motion of a block without a motion code.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ModalMotion {
    /// G0.
    Rapid,
    /// G1.
    Linear,
    /// G2 and G3.
    Arc(TurnDirection),
    /// G2.1 and G3.1.
    Spiral(TurnDirection),
    /// G33.
    Thread,
    /// G33.1.
    RigidTap,
    /// G5, G5.1 and G5.2.
    Spline(SplineForm),
    /// A turning pass with its return to the start.
    Turn(TurnPass),
    /// A probe move, where its code stays active (RS274/NGC and GRBL G38.2 to G38.5).
    Probe {
        /// The control stops with an alarm when nothing was touched.
        must_hit: bool,
    },
    /// A threading cycle of several passes, where its code stays active and needs its words again (RS274/NGC G76).
    ThreadPasses,
    /// None: an axis word needs a motion code (LinuxCNC after G80).
    None,
}

/// A turning pass of one block, which later blocks repeat.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum TurnPass {
    /// Along Z (G90).
    Turning,
    /// Along X (G94).
    Facing,
    /// A thread (G92).
    Thread,
}

/// A running live tool of a turret.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct LiveTool {
    /// Its direction.
    pub turns: SpindleState,
    /// Its speed, rev/min.
    pub rpm: f64,
}

/// What turning passes and cycles remember from block to block, mm; depths on the radius.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct TurningMemory {
    /// The end of the last pass: X (a radius) and Z.
    pub pass_end: [f64; 2],
    /// Taper of a pass: start minus end, on the radius or along Z.
    pub pass_taper: f64,
    /// The lead of the last thread.
    pub pass_lead: f64,
    /// Depth of a roughing pass.
    pub rough_depth: f64,
    /// Retraction after a roughing pass.
    pub rough_retract: f64,
    /// The distance of the first pass of G73 from the last, on the radius and along Z.
    pub pattern: [f64; 2],
    /// Number of passes of G73.
    pub pattern_passes: u32,
    /// Retraction of a peck.
    pub peck_retract: f64,
    /// Threads end without their exit at 45 degrees.
    pub without_exit: bool,
    /// The words of the first block of a threading cycle.
    pub thread: ThreadMemory,
}

/// The words of the first block of a threading cycle.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct ThreadMemory {
    /// Finishing passes.
    pub finish_passes: u32,
    /// Length of the exit, in leads.
    pub exit_leads: f64,
    /// Included angle of the tool, degrees.
    pub angle_deg: f64,
    /// Least depth of a pass, mm.
    pub least: f64,
    /// Depth of the finishing pass, mm.
    pub finish: f64,
}

impl TurningMemory {
    /// At power-on.
    fn new(rules: &TurningRules) -> TurningMemory {
        TurningMemory {
            pass_end: [0.0; 2],
            pass_taper: 0.0,
            pass_lead: 0.0,
            rough_depth: rules.rough_depth_mm,
            rough_retract: rules.rough_retract_mm,
            pattern: [0.0; 2],
            pattern_passes: 1,
            peck_retract: rules.peck_retract_mm,
            without_exit: false,
            thread: ThreadMemory {
                finish_passes: rules.thread_finish_passes,
                exit_leads: rules.thread_exit_leads,
                angle_deg: rules.thread_angle_deg,
                least: rules.thread_least_mm,
                finish: rules.thread_finish_mm,
            },
        }
    }
}

/// The kinds of spline blocks.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum SplineForm {
    /// Two control points, relative to the start and to the end (G5).
    Cubic,
    /// One control point, relative to the start (G5.1).
    Quadratic,
    /// One control point a block, with its weight (G5.2).
    Points,
}

/// An active canned cycle: its kind and its modal words; `None` for a word that was not given.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct CycleState {
    /// The cycle.
    pub kind: CycleKind,
    /// Index of the drilling axis.
    pub axis: usize,
    /// Position of the drilling axis when the series of cycles began, mm.
    pub initial: f64,
    /// R: a level, mm, or the value as written on controls that read it again for each hole.
    pub r: Option<f64>,
    /// Z: the depth, mm.
    pub z: Option<f64>,
    /// Q: a step or a shift, mm.
    pub q: Option<f64>,
    /// I, J and K, mm.
    pub vector: [Option<f64>; 3],
    /// The dwell at the bottom, s.
    pub dwell_s: Option<f64>,
    /// P when it is the retraction of a peck, mm.
    pub lift: Option<f64>,
    /// F when it is the speed of a tap, rev/min.
    pub tap_rpm: Option<f64>,
    /// J when it is the factor of the retraction speed of a tap.
    pub out_factor: Option<f64>,
    /// `,R1` or `,R0` of a tap.
    pub synchronous: Option<bool>,
    /// E: speed of the spindle, in reverse, after the hole, rev/min.
    pub after_rpm: Option<f64>,
    /// The current block has made its hole.
    pub fired: bool,
}

impl CycleState {
    /// A cycle without words.
    pub fn new(kind: CycleKind, axis: usize, initial: f64) -> CycleState {
        CycleState {
            kind,
            axis,
            initial,
            r: None,
            z: None,
            q: None,
            vector: [None; 3],
            dwell_s: None,
            lift: None,
            tap_rpm: None,
            out_factor: None,
            synchronous: None,
            after_rpm: None,
            fired: false,
        }
    }
}

/// Which overrides of the control panel are disabled, and by what.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct OverrideState {
    /// By M48, M49 and similar codes.
    pub by_code: Overrides,
    /// G63 is active.
    pub tapping_mode: bool,
    /// A tapping cycle is in its hole.
    pub in_tap: bool,
    /// The overrides last emitted.
    pub pushed: Overrides,
}

impl Default for OverrideState {
    fn default() -> OverrideState {
        let (by_code, pushed) = (Overrides::ON, Overrides::ON);
        OverrideState { by_code, tapping_mode: false, in_tap: false, pushed }
    }
}

impl OverrideState {
    /// The overrides that act now.
    pub fn in_force(&self) -> Overrides {
        let feed = self.by_code.feed && !self.tapping_mode && !self.in_tap;
        Overrides { feed, ..self.by_code }
    }
}

/// Active words whose values are not known: they are not missing, but cannot be checked.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct UnknownWords {
    /// F.
    pub feed: bool,
    /// S.
    pub speed: bool,
    /// T.
    pub tool: bool,
    /// The number of the radius offset.
    pub radius_offset: bool,
}

/// The axes that are still where the machine was when the program began. They are drawn at the reference point,
/// but a program that reads their position reads an unknown value.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct StartAxes {
    /// In program coordinates.
    pub program: AxisMask,
    /// In machine coordinates.
    pub machine: AxisMask,
}

/// Everything a control remembers from block to block.
#[derive(Clone, PartialEq, Debug)]
pub struct State {
    /// The tool tip in program coordinates.
    pub position: Position,
    /// The position that the control assumes, program coordinates; targets are computed from it. `None` when it
    /// equals `position`.
    pub control_position: Option<Position>,
    /// The axes whose program coordinate is known.
    pub known: AxisMask,
    /// The axes whose machine coordinate is known.
    pub machine_known: AxisMask,
    /// The axes that moved to an unknown position; an increment does not make them known again.
    pub astray: AxisMask,
    /// The axes that have not moved since the run began.
    pub start: StartAxes,
    /// Active words whose values are not known.
    pub unknown: UnknownWords,
    /// The offset tables, and which are active.
    pub offsets: Offsets,
    /// Mirror, scaling and rotation.
    pub frames: Frames,
    /// By how much rotation and scaling have changed the coordinates of the position since the program named both
    /// axes of the plane, mm; `None` without a change.
    pub frame_jump: Option<Position>,
    /// The angle of the last rotation, degrees; `None` before one.
    pub last_rotation_deg: Option<f64>,
    /// Polar coordinates; `None` when end points are coordinates.
    pub polar: Option<PolarReading>,
    /// The surface of polar or cylindrical interpolation; `None` when inactive.
    pub surface: Option<SurfaceState>,
    /// The frame of the part (tool centre point control, a tilted plane); `None` when coordinates are those of the axes.
    pub part_frame: Option<Arc<PartFrame>>,
    /// The frame of the part is that of a tilted plane, perhaps a level one (G68.2 to G69).
    pub has_tilted_plane: bool,
    /// Under tool centre point control the program gives the direction of the tool as a vector (G43.5).
    pub tool_by_vector: bool,
    /// The length of the tool acts along it as the heads stand, and an axis that a block does not name stands (Haas G143).
    pub length_along_tool: bool,
    /// The tip is followed by the kinematics of the control, which no code of the tool length ends.
    pub tip_by_kinematics: bool,
    /// The origin of the coordinates rides on the tables, and their axes stay those of the machine (Haas G254).
    pub origin_on_table: bool,
    /// The linear axes that moves have named since then; Z only after X and Y.
    pub named_on_table: AxisMask,
    /// Units of the program.
    pub units: Units,
    /// The plane of arcs and compensation.
    pub plane: Plane,
    /// G91 is active.
    pub incremental: bool,
    /// The position at which G91 became active.
    pub incremental_from: Position,
    /// The motion of a block without a motion code.
    pub motion: ModalMotion,
    /// The direction that G2 or G3 selected, on controls where arcs then need no code; `None` otherwise.
    pub armed: Option<TurnDirection>,
    /// The last block cut an arc while G0 is active (on controls where G2 and G3 do not cancel it).
    pub arc_over_rapid: bool,
    /// The meaning of centre words.
    pub arc_center: ArcCenter,
    /// The unit of F.
    pub feed_mode: FeedMode,
    /// F in the unit of the mode: mm/s, 1/s or mm per revolution; `None` before any F.
    pub feed: Option<f64>,
    /// F of moves of rotary axes alone, rad/s; `None` before any F.
    pub feed_angular: Option<f64>,
    /// The active F word while it may exceed a limit of the machine and no move has been checked; `None` otherwise.
    pub feed_over: Option<Span>,
    /// What the spindle does.
    pub spindle: SpindleState,
    /// Its speed, rev/min; during G96 the last one.
    pub rpm: f64,
    /// The running live tool, which cuts in place of the spindle; `None` when none runs.
    pub live: Option<LiveTool>,
    /// The last speed of a live tool, rev/min.
    pub live_rpm: f64,
    /// The cutting speed that is kept (G96), mm/s; `None` in G97.
    pub surface_speed: Option<f64>,
    /// The last cutting speed, which G96 without S restores, mm/s.
    pub last_surface_speed: f64,
    /// The programmed limit of the spindle speed, rev/min; `None` without one.
    pub speed_limit: Option<f64>,
    /// Open coolant valves.
    pub coolant: Coolant,
    /// The tool in the spindle; 0 for none.
    pub tool: u32,
    /// The tool made ready for the next change; `None` before a T word.
    pub selected_tool: Option<u32>,
    /// The side of cutter compensation.
    pub side: CompensationSide,
    /// Number of the radius offset; `None` before one.
    pub radius_offset: Option<u32>,
    /// Number of a length offset that was programmed while no length was active; `None` without one.
    pub named_length: Option<u32>,
    /// A cycle returns to R (G99), not to its initial level (G98).
    pub return_to_r: bool,
    /// The active cycle; `None` without one.
    pub cycle: Option<CycleState>,
    /// The last dwell of a cycle, s; `None` before one.
    pub cycle_dwell_s: Option<f64>,
    /// The path mode.
    pub path: PathState,
    /// The overrides.
    pub overrides: OverrideState,
    /// The memory of turning passes and cycles.
    pub turning: TurningMemory,
}

impl State {
    /// At power-on.
    pub fn new(rules: &Rules, offsets: Offsets, home: Position) -> State {
        let mut position = home;
        let known = offsets.known();
        let total = offsets.total();
        for axis in 0..AXES {
            position[axis] -= total[axis];
        }
        State {
            position,
            control_position: None,
            known,
            machine_known: AxisMask::ALL,
            astray: AxisMask::NONE,
            start: StartAxes { program: AxisMask::ALL, machine: AxisMask::ALL },
            unknown: UnknownWords::default(),
            offsets,
            frames: Frames::default(),
            frame_jump: None,
            last_rotation_deg: None,
            polar: None,
            surface: None,
            part_frame: None,
            has_tilted_plane: false,
            tool_by_vector: false,
            length_along_tool: false,
            tip_by_kinematics: false,
            origin_on_table: false,
            named_on_table: AxisMask::NONE,
            units: rules.units,
            plane: rules.starts_in,
            incremental: rules.starts_incremental,
            incremental_from: [0.0; AXES],
            motion: match rules.starts_linear {
                _ if rules.starts_without_motion => ModalMotion::None,
                true => ModalMotion::Linear,
                false => ModalMotion::Rapid,
            },
            armed: None,
            arc_over_rapid: false,
            arc_center: rules.arc.arc_center,
            feed_mode: rules.starting_feed_mode(),
            feed: rules.starting_feed_mm_s,
            feed_angular: None,
            feed_over: None,
            spindle: SpindleState::Off,
            rpm: 0.0,
            live: None,
            live_rpm: 0.0,
            surface_speed: None,
            last_surface_speed: 0.0,
            speed_limit: None,
            coolant: Coolant::default(),
            tool: 0,
            selected_tool: None,
            side: CompensationSide::Off,
            radius_offset: None,
            named_length: None,
            return_to_r: rules.cycles.starts_at_r,
            cycle: None,
            cycle_dwell_s: None,
            path: PathState::new(&rules.path),
            overrides: OverrideState::default(),
            turning: TurningMemory::new(&rules.turning),
        }
    }

    /// The machine coordinate of an axis, mm or rad.
    pub fn machine_position(&self, axis: usize) -> f64 {
        let place = match (&self.surface, &self.part_frame, self.frames.is_plain()) {
            (Some(surface), ..) => surface.run.on_axes(&self.position)[axis],
            (None, Some(_), _) => self.axis_position()[axis],
            (None, None, true) => self.position[axis],
            (None, None, false) => self.work_position()[axis],
        };
        place + self.offsets.total()[axis]
    }

    /// The program coordinate of an axis, mm or rad; `None` when it does not follow from the program.
    pub fn known_position(&self, axis: usize) -> Option<f64> {
        let is_known = self.known.has(axis) && !self.start.program.has(axis);
        is_known.then_some(self.position[axis])
    }

    /// The machine coordinate of an axis, mm or rad; `None` when it does not follow from the program.
    pub fn known_machine_position(&self, axis: usize) -> Option<f64> {
        let is_known = self.machine_known.has(axis) && !self.start.machine.has(axis);
        is_known.then(|| self.machine_position(axis))
    }

    /// Marks the program coordinates of axes as known: a block moves them to named positions.
    #[inline]
    pub fn place(&mut self, axes: AxisMask) {
        if axes.and(self.start.program.or(self.astray)) != AxisMask::NONE {
            self.start.program = self.start.program.without(axes);
            self.astray = self.astray.without(axes);
        }
    }

    /// Marks axes as moved to positions of machine coordinates.
    pub fn leave_machine_start(&mut self, axes: AxisMask) {
        self.start.machine = self.start.machine.without(axes);
        self.start.program = self.start.program.without(axes);
    }

    /// The tool tip in the work coordinate system, without mirror, scaling or rotation.
    pub fn work_position(&self) -> Position {
        match self.frames.is_plain() {
            true => self.position,
            false => self.frames.map().point(&self.position),
        }
    }

    /// Changes the offsets: the machine does not move, the program coordinates change.
    pub fn shift_coordinates(&mut self, change: impl FnOnce(&mut Offsets)) {
        let part_frame = self.leave_part_frame();
        self.shift_axes(change);
        if let Some(frame) = part_frame {
            self.enter_part_frame(frame);
        }
    }

    fn shift_axes(&mut self, change: impl FnOnce(&mut Offsets)) {
        let mut work = self.work_position();
        let mut known = self.frames.map().known(self.known);
        let old_total = self.offsets.total();
        let old_known = self.offsets.known();
        let old_identity = self.offsets.identity();
        let old_turn_deg = self.frames.work_rotation_deg();
        let drift = self
            .control_position
            .map(|assumed| [0, 1, 2].map(|axis| assumed[axis] - self.position[axis]));
        change(&mut self.offsets);
        self.offsets.update();
        let new_total = self.offsets.total();
        let new_known = self.offsets.known();
        let identity = self.offsets.identity();
        for axis in 0..AXES {
            let same = identity.same_for(&old_identity, axis);
            let unchanged = new_total[axis] == old_total[axis]
                && old_known.has(axis) == new_known.has(axis)
                && (same || new_known.has(axis));
            if unchanged {
                continue;
            }
            work[axis] += old_total[axis] - new_total[axis];
            let is_related = identity.same_unknowns_for(&old_identity, axis);
            if self.machine_known.has(axis) && new_known.has(axis) {
                known.insert(axis);
                // The coordinate follows from the machine's start position.
                if !is_related && self.start.machine.has(axis) {
                    self.start.program.insert(axis);
                }
            } else if !is_related {
                known = known.without(AxisMask(1 << axis));
            }
        }
        self.offsets.turn_coordinates(&mut self.frames);
        self.stand_at(work, known);
        if let Some([x, y, z]) = drift {
            let [x, y] = turned([x, y], old_turn_deg - self.frames.work_rotation_deg());
            let mut assumed = self.position;
            [x, y, z].iter().enumerate().for_each(|(axis, by)| assumed[axis] += by);
            self.control_position = Some(assumed);
        }
    }

    /// Writes the rotation of a work coordinate system. While G92 or G52 is active, the interpreter of RS274/NGC rotates
    /// its position about the zero of the program, but the machine about the zero of the work coordinate system: from
    /// then on its position differs from the machine's, and the next move ends where the interpreter assumes.
    pub fn write_work_rotation(&mut self, key: &str, degrees: f64) {
        let old_turn_deg = self.frames.work_rotation_deg();
        self.shift_coordinates(|offsets| offsets.write_rotation(key, degrees));
        let by_deg = old_turn_deg - self.frames.work_rotation_deg();
        let preset = self.offsets.zero_of_turn().map(|zero| -zero);
        if by_deg != 0.0 && preset != [0.0; 2] {
            let by = turned(preset, by_deg);
            let mut assumed = self.control_position.unwrap_or(self.position);
            (0..2).for_each(|axis| assumed[axis] += preset[axis] - by[axis]);
            self.control_position = Some(assumed);
        }
    }

    /// Changes the frames: the machine does not move, the program coordinates change.
    pub fn change_frames(&mut self, change: impl FnOnce(&mut Frames)) {
        let work = self.work_position();
        let known = self.frames.map().known(self.known);
        change(&mut self.frames);
        self.stand_at(work, known);
    }

    /// Sets the position of the tool tip in the work coordinate system.
    pub fn stand_at(&mut self, work: Position, known: AxisMask) {
        if self.frames.is_plain() {
            (self.position, self.known) = (work, known);
        } else {
            self.position = self.frames.inverse().point(&work);
            self.known = self.frames.inverse().known(known);
        }
    }
}

/// A vector of X and Y after a rotation.
fn turned([x, y]: [f64; 2], degrees: f64) -> [f64; 2] {
    let (sin, cos) = libm::sincos(degrees.to_radians());
    [cos * x - sin * y, sin * x + cos * y]
}
