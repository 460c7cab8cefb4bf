//! Frames that are fixed to the part: what tool centre point control and tilted planes make of the coordinates, and where they
//! start, pause and end.

use std::sync::Arc;

use chordal_command::{AxisMask, CommandKind, PartFrame, Position, ProgramOffsets};
use chordal_diagnostics::{Code, Diagnostic, Span};
use chordal_geometry::{Transform, Vec3};
use chordal_kinematics::{AngleSign, KinematicChain, RotaryMount, SolutionRule};
use chordal_machine::{AXES, AXIS_LETTERS, TcpFrame};

use crate::kernel::Kernel;
use crate::rules::RotaryChoice;
use crate::state::State;
use crate::statement::Statement;

/// Below this sine an axis of rotation is parallel to an axis of the program.
const PARALLEL: f64 = 1e-9;

/// Why the rotary axes cannot turn to a plane.
#[derive(Clone, PartialEq, Debug)]
pub enum TurnError {
    /// No tilted plane is in force.
    NoPlane,
    /// The machine file does not give the rotary axes, or not all that is needed.
    NoKinematics(String),
    /// The axes of this machine cannot bring the tool to this direction.
    Unreachable(String),
}

impl State {
    /// What lies between program coordinates and the gauge point.
    pub(crate) fn program_offsets(&self) -> ProgramOffsets {
        let (work, total) = (self.offsets.work(), self.offsets.total());
        ProgramOffsets { work, tool: std::array::from_fn(|axis| total[axis] - work[axis]) }
    }

    /// The positions of the axes in the work coordinate system: where the tip would be without a frame of the part.
    pub fn axis_position(&self) -> Position {
        let work = self.work_position();
        match &self.part_frame {
            None => work,
            Some(frame) => frame.axes_of_tip(&work, &self.program_offsets()),
        }
    }

    /// Whether the axes are known on which the positions of X, Y and Z depend.
    fn knows_axes_of(frame: &PartFrame, known: AxisMask) -> bool {
        let rotary = frame.chain.as_ref().map_or(AxisMask::NONE, AxisMask::of_chain);
        known.covers(AxisMask::LINEAR.or(rotary))
    }

    /// Whether the places of the tip and of the axes follow from each other, with the axes at a position.
    fn is_related(&self, frame: &PartFrame, place: &Position, known: AxisMask) -> bool {
        State::knows_axes_of(frame, known)
            && (frame.is_aligned(place, &self.program_offsets())
                || frame.chain.is_some() && self.offsets.known().covers(AxisMask::LINEAR))
    }

    /// Makes the coordinates those of the frame; the machine does not move. They stay known only where all axes are, and
    /// the place of the zero on the machine: it is turned.
    pub(crate) fn enter_part_frame(&mut self, frame: Arc<PartFrame>) {
        let axes = self.work_position();
        let known = self.frames.map().known(self.known);
        let is_related = self.is_related(&frame, &axes, known);
        let tip = frame.tip_of_axes(&axes, &self.program_offsets());
        self.part_frame = Some(frame);
        self.stand_at(tip, if is_related { known } else { known.without(AxisMask::LINEAR) });
    }

    /// Makes the coordinates those of the axes again; the machine does not move.
    pub(crate) fn leave_part_frame(&mut self) -> Option<Arc<PartFrame>> {
        let frame = self.part_frame.take()?;
        let tip = self.work_position();
        let known = self.frames.map().known(self.known);
        let is_related = self.is_related(&frame, &tip, known);
        let axes = frame.axes_of_tip(&tip, &self.program_offsets());
        self.stand_at(axes, if is_related { known } else { known.without(AxisMask::LINEAR) });
        Some(frame)
    }

    /// After a move in a frame of the part: every linear axis may have moved, and is known where all are.
    fn place_axes_of_tip(&mut self) {
        let Some(frame) = &self.part_frame else { return };
        let known = self.frames.map().known(self.known);
        let place = self.work_position();
        let is_known =
            self.offsets.known().covers(AxisMask::LINEAR) && self.is_related(frame, &place, known);
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
    /// Tool centre point control: from here on the control holds the tip while rotary axes turn; the machine does not move.
    pub fn begin_tool_center(&mut self) {
        self.set_part_frame(true, self.tilted_plane());
    }

    /// The length of the tool acts along it as the heads stand from here on, and nothing else of the kinematics does (Haas
    /// G143): the place of the pivot is in the coordinates of the program already.
    pub fn begin_length_along_tool(&mut self) {
        self.suspend_part_frame();
        self.state.has_tilted_plane = false;
        let chain = self.rotary_chain().ok().map(|chain| chain.with_heads_at_gauge_point());
        let frame = self.part_frame_of(chain, false, Transform::identity());
        self.resume_part_frame(Arc::new(frame));
        self.state.length_along_tool = true;
    }

    /// The target of a move while the length acts along the tool, where an axis that is not named stands (Haas G143).
    pub fn target_along_tool(&self, target: &Position, named: AxisMask) -> Position {
        let Some(frame) = &self.state.part_frame else { return *target };
        let offsets = self.state.program_offsets();
        let from = frame.axes_of_tip(&self.state.position, &offsets);
        let to = frame.axes_of_tip(target, &offsets);
        std::array::from_fn(|axis| match AxisMask::LINEAR.without(named).has(axis) {
            true => target[axis] + from[axis] - to[axis],
            false => target[axis],
        })
    }

    /// Ends tool centre point control; a tilted plane stays.
    pub fn end_tool_center(&mut self) {
        self.state.tool_by_vector = false;
        if std::mem::take(&mut self.state.length_along_tool) {
            return self.set_part_frame(false, None);
        }
        if self.state.tip_by_kinematics {
            return;
        }
        if self.state.part_frame.as_ref().is_some_and(|frame| frame.follows_tip) {
            self.set_part_frame(false, self.tilted_plane());
        }
    }

    /// Switches the kinematics of the control (LinuxCNC, switchkins): X, Y and Z are the tip on the part, or positions of the
    /// axes. The machine does not move.
    pub fn switch_kinematics(&mut self, follow_tip: bool) {
        self.state.tip_by_kinematics = false;
        match follow_tip {
            true => self.begin_tool_center(),
            false => self.end_tool_center(),
        }
        self.state.tip_by_kinematics = follow_tip;
    }

    /// The rotary axes of the machine.
    ///
    /// # Errors
    /// What is missing, in words.
    pub fn rotary_chain(&self) -> Result<KinematicChain, String> {
        let chain = self.machine.kinematic_chain().map_err(|error| error.to_string())?;
        match chain.joints() {
            [] => Err("the machine has no rotary axis".into()),
            _ => Ok(chain),
        }
    }

    /// The rotary axes that turn the tool or the part, as far as the machine file gives them.
    pub fn rotary_axes(&self) -> AxisMask {
        // That of a frame is at hand; to make it from the machine file takes time.
        let of_frame = self.state.part_frame.as_ref().and_then(|frame| frame.chain.as_ref());
        match of_frame.filter(|chain| !chain.joints().is_empty()) {
            Some(chain) => AxisMask::of_chain(chain),
            None => self.rotary_chain().map_or(AxisMask::NONE, |chain| AxisMask::of_chain(&chain)),
        }
    }

    /// Before a move to these positions of the axes under tool centre point control, on a control whose coordinates keep the
    /// axes of the machine: the end point counts as the tables lie at the end of the move, so the frame lies so from here on.
    /// The machine does not move.
    pub fn turn_fixed_frame(&mut self, target: &Position) {
        let turns = target[3..] != self.state.position[3..];
        if !self.rules.frames.tip_frame_stays || !turns {
            return;
        }
        let Some(frame) = self.state.part_frame.clone().filter(|frame| frame.follows_tip) else {
            return;
        };
        self.suspend_part_frame();
        self.resume_part_frame(Arc::new(self.fixed_frame(&frame, target)));
    }

    /// The frame with the tables as they lie at a position, so that its axes are those of the machine.
    fn fixed_frame(&self, frame: &PartFrame, place: &Position) -> PartFrame {
        let work = self.state.program_offsets().work;
        let frame_angles = std::array::from_fn(|axis| work[axis + 3] + place[axis + 3]);
        PartFrame { frame_angles, ..frame.clone() }
    }

    /// The rotary axes that turn in a move to a position, and are no table about an axis of the program.
    pub fn turns_across(&self, target: &Position, normal: usize) -> AxisMask {
        let from = &self.state.position;
        let frame = self.state.part_frame.as_ref();
        let chain = frame.and_then(|frame| frame.chain);
        let mut axes = AxisMask::NONE;
        (3..AXES).filter(|axis| from[*axis] != target[*axis]).for_each(|axis| axes.insert(axis));
        for joint in chain.iter().flat_map(|chain| chain.joints()) {
            let along = [Vec3::X, Vec3::Y, Vec3::Z][normal];
            let is_about = joint.direction.cross(along).length() < PARALLEL;
            if joint.side == RotaryMount::Table && is_about {
                axes.remove(joint.letter.index() + 3);
            }
        }
        axes
    }

    /// A rotary axis with a work offset other than 0, and that offset, degrees.
    pub fn rotary_work_offset(&self) -> Option<(char, f64)> {
        let work = self.state.program_offsets().work;
        let axis = (3..AXES).find(|axis| work[*axis] != 0.0)?;
        Some((char::from(AXIS_LETTERS.as_bytes()[axis]), work[axis].to_degrees()))
    }

    /// Whether a tilted plane is in force; it may be level.
    pub fn has_tilted_plane(&self) -> bool {
        self.state.has_tilted_plane
    }

    /// From here on coordinates are those of a plane, which is given in the work coordinate system; the machine does not
    /// move. `None` ends it.
    pub fn set_tilted_plane(&mut self, plane: Option<Transform>) {
        let follows_tip = self.state.part_frame.as_ref().is_some_and(|frame| frame.follows_tip);
        if plane.is_some() || self.state.part_frame.is_some() {
            self.set_part_frame(follows_tip, plane);
        }
    }

    /// The tilted plane in force, in the work coordinate system; `None` without one.
    pub fn tilted_plane(&self) -> Option<Transform> {
        let frame = self.state.part_frame.as_ref()?;
        self.state.has_tilted_plane.then_some(frame.plane)
    }

    /// From here on coordinates are turned in space (G68 with I, J and K): the axes move along them however the rotary axes
    /// stand.
    pub fn set_space_rotation(&mut self, plane: Transform) {
        self.suspend_part_frame();
        let frame = self.part_frame_of(Some(KinematicChain::CARTESIAN), false, plane);
        self.resume_part_frame(Arc::new(frame));
        self.state.has_tilted_plane = true;
    }

    /// Whether the coordinates are turned in space (G68 with I, J and K).
    pub fn is_rotated_in_space(&self) -> bool {
        let frame = self.state.part_frame.as_ref();
        frame.is_some_and(|frame| {
            !frame.follows_tip && frame.chain == Some(KinematicChain::CARTESIAN)
        })
    }

    fn set_part_frame(&mut self, follows_tip: bool, plane: Option<Transform>) {
        self.suspend_part_frame();
        (self.state.origin_on_table, self.state.has_tilted_plane) = (false, plane.is_some());
        if !follows_tip && plane.is_none() {
            return;
        }
        let plane = plane.unwrap_or(Transform::identity());
        let frame = self.part_frame_of(self.rotary_chain().ok(), follows_tip, plane);
        self.resume_part_frame(Arc::new(frame));
    }

    fn part_frame_of(
        &self,
        chain: Option<KinematicChain>,
        follows_tip: bool,
        plane: Transform,
    ) -> PartFrame {
        let offsets = self.state.program_offsets();
        let place = self.state.work_position();
        let is_as_turned =
            self.machine.tcp_frame == TcpFrame::Activation || self.rules.frames.tip_frame_stays;
        let frame_angles = std::array::from_fn(|axis| match is_as_turned && follows_tip {
            true => offsets.work[axis + 3] + place[axis + 3],
            false => offsets.work[axis + 3],
        });
        PartFrame { chain, frame_angles, plane, follows_tip }
    }

    /// The tip of the tool and its direction, in the work coordinate system as it lies with the tables at zero.
    ///
    /// # Errors
    /// [`TurnError::NoKinematics`] where they are not known.
    pub fn tool_on_part(&self) -> Result<(Vec3, Vec3), TurnError> {
        let chain = self.rotary_chain().map_err(TurnError::NoKinematics)?;
        let (place, offsets) = (self.state.axis_position(), self.state.program_offsets());
        let frame = self.part_frame_of(Some(chain), true, Transform::identity());
        let known = self.state.frames.map().known(self.state.known);
        if !State::knows_axes_of(&frame, known) {
            let what = "the program has not said where the axes are".to_string();
            return Err(TurnError::NoKinematics(what));
        }
        let tip = frame.tip_of_axes(&place, &offsets);
        let direction = frame.tool_direction(&place, &offsets).unwrap_or(Vec3::Z);
        Ok((Vec3::new(tip[0], tip[1], tip[2]), direction))
    }

    /// The origin of the work coordinates rides on the tables from here on, and their axes stay those of the machine (Haas
    /// G254).
    ///
    /// # Errors
    /// [`TurnError::NoKinematics`] where it is not known how the tables stand.
    pub fn begin_origin_on_table(&mut self) -> Result<(), TurnError> {
        self.tool_on_part()?;
        let (place, offsets) = (self.state.axis_position(), self.state.program_offsets());
        let chain = self.rotary_chain().ok();
        let level = self.part_frame_of(chain, false, Transform::identity());
        let plane = level.machine_axes(&place, &offsets);
        self.suspend_part_frame();
        self.resume_part_frame(Arc::new(PartFrame { plane, ..level }));
        (self.state.origin_on_table, self.state.named_on_table) = (true, AxisMask::NONE);
        Ok(())
    }

    /// The origin no longer rides on the tables (Haas G255).
    pub fn end_origin_on_table(&mut self) {
        if std::mem::take(&mut self.state.origin_on_table) {
            self.set_part_frame(false, None);
        }
    }

    /// A move of rotary axes alone while the origin rides on the tables: the linear axes stand, and the origin has another
    /// place afterwards.
    pub fn turn_with_origin(&mut self, at: &dyn Statement, mut target: Position, named: AxisMask) {
        self.suspend_part_frame();
        // The coordinates of the linear axes are others without the frame.
        target[..3].copy_from_slice(&self.state.position[..3]);
        self.straight(at, target, named);
        self.go_on_with_origin();
    }

    /// The origin goes on riding on the tables after moves of the axes.
    fn go_on_with_origin(&mut self) {
        if self.begin_origin_on_table().is_err() {
            self.go_astray(AxisMask::LINEAR);
        }
    }

    /// Makes moves of the axes themselves, such as to a reference point, outside of a frame that is in force.
    pub fn by_axes(&mut self, moves: impl FnOnce(&mut Self)) {
        let frame = self.suspend_part_frame();
        moves(self);
        match frame {
            // The moves may have turned the tables.
            Some(_) if self.state.origin_on_table => self.go_on_with_origin(),
            Some(frame) if frame.follows_tip && self.rules.frames.tip_frame_stays => {
                let place = self.state.position;
                self.resume_part_frame(Arc::new(self.fixed_frame(&frame, &place)));
            }
            Some(frame) => self.resume_part_frame(frame),
            None => self.follow_fixture_error(),
        }
    }

    /// Says that the tip is followed and the axes are not, and why.
    pub fn report_no_kinematics(&mut self, at: Span, name: &str, why: &str) {
        let message =
            format!("{name}: where X, Y and Z are while rotary axes turn is not known: {why}");
        let diagnostic = Diagnostic::new(Code::KinematicsNotKnown, at, message)
            .label("the tip is followed; travel and time are not")
            .help("give the rotary axes in the machine file; see `chordal explain CH448`");
        self.report(diagnostic);
    }

    /// Leaves the frame; what was in force.
    fn suspend_part_frame(&mut self) -> Option<Arc<PartFrame>> {
        self.state.part_frame.as_ref()?;
        self.end_corner_before("the coordinates change before the next move");
        let frame = self.state.leave_part_frame();
        self.emit(CommandKind::PartFrame { frame: None, position: self.state.position });
        frame
    }

    /// Enters a frame, or goes on in it after such a move.
    fn resume_part_frame(&mut self, frame: Arc<PartFrame>) {
        self.state.enter_part_frame(Arc::clone(&frame));
        let position = self.state.position;
        self.emit(CommandKind::PartFrame { frame: Some(frame), position });
    }

    /// Turns the rotary axes so that the tool stands upright on the tilted plane (G53.1), by a rapid of these axes alone, or
    /// with the tip held where it is (G53.6). `sign` is that of the axis nearer to the tool, where the program chooses it.
    ///
    /// # Errors
    /// See [`TurnError`].
    pub fn turn_to_plane(
        &mut self,
        holds_tip: bool,
        sign: Option<AngleSign>,
    ) -> Result<(), TurnError> {
        let is_plane = self.state.has_tilted_plane;
        let Some(frame) = self.state.part_frame.clone().filter(|_| is_plane) else {
            return Err(TurnError::NoPlane);
        };
        let angles = match self.angles_of_direction(&frame, Vec3::Z, sign) {
            Ok(angles) => angles,
            Err(error) => {
                // The tip is known again where the program names it; where the rotary axes are is not.
                self.go_astray(AxisMask::ROTARY);
                return Err(error);
            }
        };
        self.turn_to_angles(holds_tip, &angles)
    }

    /// The same to these program positions of A, B and C, rad.
    ///
    /// # Errors
    /// [`TurnError::NoPlane`] where no tilted plane is in force.
    pub fn turn_to_angles(&mut self, holds_tip: bool, angles: &[f64; 3]) -> Result<(), TurnError> {
        let is_plane = self.state.has_tilted_plane;
        let Some(frame) = self.state.part_frame.clone().filter(|_| is_plane) else {
            return Err(TurnError::NoPlane);
        };
        let paused = match holds_tip {
            true => {
                self.set_part_frame(true, Some(frame.plane));
                Some(Arc::clone(&frame)).filter(|frame| !frame.follows_tip)
            }
            false => self.suspend_part_frame(),
        };
        let mut target = self.state.position;
        let mut named = AxisMask::NONE;
        let chain = frame.chain.iter().flat_map(|chain| chain.joints());
        for axis in chain.map(|joint| joint.letter.index()) {
            target[axis + 3] = angles[axis];
            named.insert(axis + 3);
        }
        self.rapid_to(target, named);
        if let Some(frame) = paused {
            self.suspend_part_frame();
            self.resume_part_frame(frame);
        }
        Ok(())
    }

    /// After a move in a frame of the part, from a position. Without tool centre point control nobody says what a control
    /// does where a rotary axis turns in a tilted plane.
    #[cold]
    pub(crate) fn moved_on_part(&mut self, from: &Position) {
        let state = &self.state;
        let turns = from[3..] != state.position[3..];
        let is_plane = !state.length_along_tool
            && state.part_frame.as_ref().is_some_and(|frame| !frame.follows_tip);
        if turns && is_plane {
            let what = "a rotary axis turns in a tilted plane: where the tip goes is not followed";
            let help = "end the plane before, or turn to it with G53.1";
            let diagnostic = Diagnostic::new(Code::NotFollowed, self.origin.span, what);
            self.report(diagnostic.label("from here on the path is not known").help(help));
        }
        self.state.place_axes_of_tip();
    }

    /// The program positions of A, B and C, rad, with which the tool points along a vector of program coordinates.
    fn angles_of_direction(
        &self,
        frame: &PartFrame,
        direction: Vec3,
        sign: Option<AngleSign>,
    ) -> Result<[f64; 3], TurnError> {
        let (Some(chain), Some(direction)) = (&frame.chain, frame.direction_on_part(direction))
        else {
            let what = self.rotary_chain().err().unwrap_or_default();
            return Err(TurnError::NoKinematics(what));
        };
        let offsets = self.state.program_offsets();
        let away: [f64; 3] =
            std::array::from_fn(|axis| offsets.work[axis + 3] + offsets.tool[axis + 3]);
        let present = std::array::from_fn(|axis| self.state.position[axis + 3] + away[axis]);
        let of_sign = sign.zip(chain.joints().last());
        let rule = match of_sign.map(|(sign, joint)| (joint.letter, sign)) {
            Some(of_axis) => SolutionRule::LeastMovement { sign: Some(of_axis) },
            None => self.solution_rule(chain),
        };
        let unreachable = |error: &dyn std::fmt::Display| TurnError::Unreachable(error.to_string());
        let solutions = chain.joint_solutions(direction).map_err(|error| unreachable(&error))?;
        let angles =
            chain.choose(&solutions, &present, rule).map_err(|error| unreachable(&error))?;
        Ok(std::array::from_fn(|axis| angles[axis] - away[axis]))
    }

    /// The rule by which this control chooses between two positions of the rotary axes.
    fn solution_rule(&self, chain: &KinematicChain) -> SolutionRule {
        match (self.rules.frames.rotary_choice, chain.master()) {
            (RotaryChoice::Master, Some(master)) => SolutionRule::MasterMovement { master },
            (RotaryChoice::PoleSide { near_rad }, _) => SolutionRule::PoleSide { near_rad },
            (RotaryChoice::Master | RotaryChoice::LeastMovement, _) => SolutionRule::LEAST_MOVEMENT,
        }
    }

    /// The program positions of A, B and C, rad, with which the tool points along a vector of program coordinates, from its
    /// tip to its holder.
    ///
    /// # Errors
    /// [`TurnError::NoPlane`] where coordinates are not those of the part, and the others.
    pub fn rotary_of_direction(&self, direction: Vec3) -> Result<[f64; 3], TurnError> {
        let frame = self.state.part_frame.as_ref().ok_or(TurnError::NoPlane)?;
        self.angles_of_direction(frame, direction, None)
    }

    /// The program positions of A, B and C, rad, with which the tool stands upright on the tilted plane; `sign` is that of
    /// the axis nearer to the tool, where the program chooses it.
    ///
    /// # Errors
    /// See [`TurnError`].
    pub fn rotary_of_plane(&self, sign: Option<AngleSign>) -> Result<[f64; 3], TurnError> {
        let frame = self.state.part_frame.as_ref().ok_or(TurnError::NoPlane)?;
        self.angles_of_direction(frame, Vec3::Z, sign)
    }

    /// X, Y and Z of the tool on the part as it lies with the tables at zero, when the rotary axes are at these program
    /// positions of A, B and C, rad: the axes of the machine, turned by the heads and seen from the tables.
    ///
    /// # Errors
    /// [`TurnError::NoKinematics`] where the machine file does not give the rotary axes.
    pub fn tool_axes_at(&self, angles: &[f64; 3]) -> Result<[Vec3; 3], TurnError> {
        let chain = self.rotary_chain().map_err(TurnError::NoKinematics)?;
        let (mut place, offsets) = (self.state.axis_position(), self.state.program_offsets());
        place[3..].copy_from_slice(angles);
        let level = self.part_frame_of(Some(chain), false, Transform::identity());
        let on_part = level.machine_axes(&place, &offsets);
        let joints = offsets.angles(&place);
        let turned = |axis| on_part.apply_vector(chain.tool_on_heads(&joints, axis));
        Ok([Vec3::X, Vec3::Y, Vec3::Z].map(turned))
    }

    /// The largest angle between the tool and the plane of its directions before and after a turn of the rotary axes to
    /// these program positions of A, B and C, rad; `None` where the machine file does not give the axes.
    pub fn swing_of_tool(&self, angles: &[f64; 3]) -> Option<f64> {
        let chain = self.state.part_frame.as_ref()?.chain?;
        let offsets = self.state.program_offsets();
        let known = self.state.frames.map().known(self.state.known);
        if !known.covers(AxisMask::of_chain(&chain)) {
            return None;
        }
        let [a, b, c] = *angles;
        let from = offsets.angles(&self.state.position);
        Some(chain.swing(&from, &offsets.angles(&[0.0, 0.0, 0.0, a, b, c])))
    }
}
