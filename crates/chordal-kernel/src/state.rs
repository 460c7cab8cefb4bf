//! What a control remembers from block to block.

use chordal_command::{
    AxisMask, CompensationSide, Coolant, FeedMode, Overrides, Position, SpindleState, Units,
};
use chordal_diagnostics::Span;
use chordal_geometry::{Plane, TurnDirection};
use chordal_machine::AXES;

use crate::frames::{Frames, PolarReading};
use crate::offsets::Offsets;
use crate::path_mode::PathState;
use crate::rules::{ArcCenter, CycleKind, Rules, TurningRules};
use crate::surface::SurfaceState;

/// The motion that a block without a motion code makes.
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
    /// A pass of a lathe and back to its start.
    Turn(TurnPass),
    /// A probe move, where its code stays in force (RS274/NGC and GRBL G38.2 to G38.5).
    Probe {
        /// Without a touch the control stops.
        must_hit: bool,
    },
    /// A thread in many passes, where its code stays in force and needs its words again (RS274/NGC G76).
    ThreadPasses,
    /// None: an axis word needs a motion code (LinuxCNC after G80).
    None,
}

/// A pass of a lathe that one block makes, and that blocks after it repeat.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum TurnPass {
    /// Along Z (G90).
    Turning,
    /// Along X (G94).
    Facing,
    /// A thread (G92).
    Thread,
}

/// A live tool of a turret that turns.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct LiveTool {
    /// Which way.
    pub turns: SpindleState,
    /// Its speed, rev/min.
    pub rpm: f64,
}

/// What the passes and cycles of a lathe remember from block to block, mm; depths are measured on the radius.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct TurningMemory {
    /// The end of the last pass: X (a radius) and Z.
    pub pass_end: [f64; 2],
    /// How much a pass is tapered: start minus end.
    pub pass_taper: f64,
    /// The lead of the last thread.
    pub pass_lead: f64,
    /// Depth of a roughing pass.
    pub rough_depth: f64,
    /// How far it backs off.
    pub rough_retract: f64,
    /// What G73 leaves to be removed on the radius, and along Z.
    pub pattern: [f64; 2],
    /// In so many passes.
    pub pattern_passes: u32,
    /// How far a peck backs off.
    pub peck_retract: f64,
    /// Threads end without their exit.
    pub without_exit: bool,
    /// What the first block of a thread has said.
    pub thread: ThreadMemory,
}

/// What the first block of a thread cycle says.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct ThreadMemory {
    /// Finishing passes.
    pub finish_passes: u32,
    /// Length of the exit, in leads.
    pub exit_leads: f64,
    /// Angle of the tool, degrees.
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

/// How the words of a block give a spline.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum SplineForm {
    /// Two control points by their way from the start and from the end (G5).
    Cubic,
    /// One control point by its way from the start (G5.1).
    Quadratic,
    /// One control point a block, with its weight (G5.2).
    Points,
}

/// A canned cycle in force: its kind and the words that stay.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct CycleState {
    /// Which one.
    pub kind: CycleKind,
    /// Index of the drilling axis.
    pub axis: usize,
    /// Level of the drilling axis when the series of cycles began.
    pub initial: f64,
    /// R: a level, or as written where the control reads it again.
    pub r: Option<f64>,
    /// The depth.
    pub z: Option<f64>,
    /// Q: a step or a shift, mm.
    pub q: Option<f64>,
    /// I, J and K, mm.
    pub vector: [Option<f64>; 3],
    /// The dwell at the bottom, s.
    pub dwell_s: Option<f64>,
    /// P where it is the lift of a peck, mm.
    pub lift: Option<f64>,
    /// F where it is the speed of a tap.
    pub tap_rpm: Option<f64>,
    /// J where it says how much faster a tap leaves.
    pub out_factor: Option<f64>,
    /// `,R1` or `,R0` of a tap.
    pub synchronous: Option<bool>,
    /// E: speed of the spindle, reversed, after the hole.
    pub after_rpm: Option<f64>,
    /// The present block has made its hole.
    pub fired: bool,
}

impl CycleState {
    /// Without words.
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

/// What keeps the panel's overrides from acting.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct OverrideState {
    /// By M48, M49 and their like.
    pub by_code: Overrides,
    /// G63 is in force.
    pub tapping_mode: bool,
    /// A tap is in its hole.
    pub in_tap: bool,
    /// What was pushed last.
    pub pushed: Overrides,
}

impl Default for OverrideState {
    fn default() -> OverrideState {
        let (by_code, pushed) = (Overrides::ON, Overrides::ON);
        OverrideState { by_code, tapping_mode: false, in_tap: false, pushed }
    }
}

impl OverrideState {
    /// What acts now.
    pub fn in_force(&self) -> Overrides {
        let feed = self.by_code.feed && !self.tapping_mode && !self.in_tap;
        Overrides { feed, ..self.by_code }
    }
}

/// Words that are in force and have values that are not known: nothing is missing, and nothing of them can
/// be checked.
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

/// The axes of which the place follows from where the machine stood when the program began. It is drawn at the
/// reference point, and a program that reads it reads what nobody knows.
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
    /// Where the control takes the tool to be, where that is not its position: targets begin there.
    pub control_position: Option<Position>,
    /// The axes whose program coordinate is known.
    pub known: AxisMask,
    /// The axes whose machine coordinate is known.
    pub machine_known: AxisMask,
    /// The axes that went to an unknown place: an increment does not make their place known again.
    pub astray: AxisMask,
    /// The axes that stand where the run began.
    pub start: StartAxes,
    /// Words in force whose values are not known.
    pub unknown: UnknownWords,
    /// The offset tables, and which are in force.
    pub offsets: Offsets,
    /// Mirror, scaling and rotation.
    pub frames: Frames,
    /// By how much rotation and scaling have changed the coordinates of the position since the program
    /// named both axes of the plane.
    pub frame_jump: Option<Position>,
    /// The angle that the last rotation was given, degrees.
    pub last_rotation_deg: Option<f64>,
    /// End points are a radius and an angle.
    pub polar: Option<PolarReading>,
    /// Two coordinates lie on a surface that turns with a rotary axis.
    pub surface: Option<SurfaceState>,
    /// Units of the program.
    pub units: Units,
    /// The plane of arcs and compensation.
    pub plane: Plane,
    /// G91 is in force.
    pub incremental: bool,
    /// Where the tool stood when G91 came into force.
    pub incremental_from: Position,
    /// What a block without a motion code does.
    pub motion: ModalMotion,
    /// The direction that G2 or G3 armed, where they arm one.
    pub armed: Option<TurnDirection>,
    /// The last block cut an arc while G0 is in force (where G2 and G3 do not cancel it).
    pub arc_over_rapid: bool,
    /// What centre words say.
    pub arc_center: ArcCenter,
    /// What F counts.
    pub feed_mode: FeedMode,
    /// F as the mode counts it: mm/s, 1/s, mm per revolution; `None` before any F.
    pub feed: Option<f64>,
    /// F of rotary moves alone, rad/s.
    pub feed_angular: Option<f64>,
    /// The F word in force where it is above a limit of the machine that no move has met yet.
    pub feed_over: Option<Span>,
    /// What the spindle does.
    pub spindle: SpindleState,
    /// Its speed, rev/min; the last one while a cutting speed is kept.
    pub rpm: f64,
    /// A live tool that turns, and cuts in place of the spindle.
    pub live: Option<LiveTool>,
    /// The speed that a live tool was given last, rev/min.
    pub live_rpm: f64,
    /// The cutting speed that is kept (G96), mm/s; `None` in G97.
    pub surface_speed: Option<f64>,
    /// The last cutting speed, which a G96 without S brings back, mm/s.
    pub last_surface_speed: f64,
    /// The limit of the spindle speed that the program has set, rev/min.
    pub speed_limit: Option<f64>,
    /// Open valves.
    pub coolant: Coolant,
    /// The tool in the spindle; 0 for none.
    pub tool: u32,
    /// The tool made ready.
    pub selected_tool: Option<u32>,
    /// The side of cutter compensation.
    pub side: CompensationSide,
    /// Number of its offset.
    pub radius_offset: Option<u32>,
    /// Number of the length offset that a word named while no length was in force.
    pub named_length: Option<u32>,
    /// A cycle ends at R, not at its initial level.
    pub return_to_r: bool,
    /// The cycle in force.
    pub cycle: Option<CycleState>,
    /// The last dwell that a cycle was given, s.
    pub cycle_dwell_s: Option<f64>,
    /// The path mode.
    pub path: PathState,
    /// The overrides.
    pub overrides: OverrideState,
    /// Passes and cycles of a lathe.
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

    /// The machine coordinate of an axis.
    pub fn machine_position(&self, axis: usize) -> f64 {
        let place = match (&self.surface, self.frames.is_plain()) {
            (Some(surface), _) => surface.run.on_axes(&self.position)[axis],
            (None, true) => self.position[axis],
            (None, false) => self.work_position()[axis],
        };
        place + self.offsets.total()[axis]
    }

    /// The program coordinate of an axis where it follows from the program.
    pub fn known_position(&self, axis: usize) -> Option<f64> {
        let is_known = self.known.has(axis) && !self.start.program.has(axis);
        is_known.then_some(self.position[axis])
    }

    /// The machine coordinate of an axis where it follows from the program.
    pub fn known_machine_position(&self, axis: usize) -> Option<f64> {
        let is_known = self.machine_known.has(axis) && !self.start.machine.has(axis);
        is_known.then(|| self.machine_position(axis))
    }

    /// Axes come to places that a block names: their program coordinates are known.
    #[inline]
    pub fn place(&mut self, axes: AxisMask) {
        if axes.and(self.start.program.or(self.astray)) != AxisMask::NONE {
            self.start.program = self.start.program.without(axes);
            self.astray = self.astray.without(axes);
        }
    }

    /// Axes come to places of machine coordinates.
    pub fn leave_machine_start(&mut self, axes: AxisMask) {
        self.start.machine = self.start.machine.without(axes);
        self.start.program = self.start.program.without(axes);
    }

    /// The tool tip in the work coordinate system, the frames undone.
    pub fn work_position(&self) -> Position {
        match self.frames.is_plain() {
            true => self.position,
            false => self.frames.map().point(&self.position),
        }
    }

    /// Changes the offsets: the machine stands still and the program coordinates change.
    pub fn shift_coordinates(&mut self, change: impl FnOnce(&mut Offsets)) {
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
                // The coordinate follows from the place of the machine.
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

    /// Writes the turn of a work coordinate system. While G92 or G52 is in force, the interpreter of RS274/NGC turns its
    /// place about the zero of the program, and the machine turns about that of the work coordinate system: from then
    /// on it believes to be where the machine does not stand, and the next move ends where it believes.
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

    /// Changes the frames: the machine stands still and the program coordinates change.
    pub fn change_frames(&mut self, change: impl FnOnce(&mut Frames)) {
        let work = self.work_position();
        let known = self.frames.map().known(self.known);
        change(&mut self.frames);
        self.stand_at(work, known);
    }

    /// Puts the tool tip at a place of the work coordinate system.
    pub fn stand_at(&mut self, work: Position, known: AxisMask) {
        if self.frames.is_plain() {
            (self.position, self.known) = (work, known);
        } else {
            self.position = self.frames.inverse().point(&work);
            self.known = self.frames.inverse().known(known);
        }
    }
}

/// A vector of X and Y after a turn.
fn turned([x, y]: [f64; 2], degrees: f64) -> [f64; 2] {
    let (sin, cos) = libm::sincos(degrees.to_radians());
    [cos * x - sin * y, sin * x + cos * y]
}
