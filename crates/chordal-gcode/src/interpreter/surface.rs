//! Polar and cylindrical interpolation: the codes that start and end it, what is permitted while it is active, and the
//! words of its moves.

use chordal_command::{AxisMask, CompensationSide, Position, RotarySurface, SurfaceShape};
use chordal_diagnostics::{Code, Diagnostic, Severity, Span};
use chordal_dialect::{
    Action, CodeRow, ModeCode, MotionCode, OnceCode, ReadingCode, SurfaceCode, SurfaceRules,
    SurfaceWord,
};
use chordal_geometry::{Plane, TurnDirection};
use chordal_kernel::{ModalMotion, NewSurface, SurfacePlane, SurfaceState};
use chordal_machine::{AXIS_LETTERS, Axis};
use chordal_syntax::{Block, Letters, Word};

use super::Interpreter;
use super::literals::AXIS_OF;

const CENTERS: Letters = Letters::of("IJK");

/// Whether a code is permitted on a surface.
enum OnSurface {
    Allowed,
    /// A rapid where none is permitted: reported, but shown.
    Rapid,
    /// A code of tool length.
    Length,
    Refused,
}

impl Interpreter<'_> {
    /// The active surface and the rules of the control for it; `None` when there is none.
    fn surface_rules(&self) -> Option<(SurfaceState, &'static SurfaceRules)> {
        let state = self.kernel.state.surface?;
        let table = self.control.table;
        let rules = match state.run.surface.shape {
            SurfaceShape::Face { .. } => table.face,
            SurfaceShape::Cylinder { .. } => table.cylinder,
        };
        Some((state, rules?))
    }

    /// The name of the active interpolation, for messages.
    fn surface_name(&self) -> &'static str {
        let shape = self.kernel.state.surface.map(|state| state.run.surface.shape);
        match shape {
            Some(SurfaceShape::Cylinder { .. }) => "cylindrical interpolation",
            Some(SurfaceShape::Face { .. }) | None => "polar interpolation",
        }
    }

    /// Carries out G12.1, G13.1 or G7.1.
    pub(super) fn surface_code(&mut self, block: &Block, at: usize, code: SurfaceCode) {
        let table = self.control.table;
        match code {
            SurfaceCode::FaceOff => {
                self.unused_axes(block, |_, _| false);
                self.end_surface(block, at);
            }
            SurfaceCode::Face => {
                self.unused_axes(block, |_, _| false);
                let Some(rules) = table.face else { return };
                if self.may_begin_surface(block, at, rules, "polar interpolation") {
                    self.begin_face(block, at, rules);
                }
            }
            SurfaceCode::Cylinder => {
                let Some(rules) = table.cylinder else { return };
                self.cylinder(block, at, rules);
            }
        }
    }

    fn end_surface(&mut self, block: &Block, at: usize) {
        if self.kernel.state.surface.is_none() {
            return;
        }
        if self.kernel.is_compensating() {
            let name = self.surface_name();
            let rules = self.surface_rules().and_then(|(_, rules)| rules.mode);
            self.refuse_surface(
                self.span(block.words[at].range),
                format!("{name} ends while cutter compensation is on"),
                "cancel compensation with G40 on a move before",
                rules,
            );
        }
        self.kernel.end_surface();
    }

    /// Reports that a surface cannot start or end here.
    fn refuse_surface(&mut self, span: Span, message: String, help: &str, alarm: Option<&str>) {
        let diagnostic = Diagnostic::new(Code::SurfaceMode, span, message).help(help);
        match alarm {
            Some(alarm) => self.report_refused(diagnostic, alarm),
            None => self.kernel.report(diagnostic),
        }
    }

    /// Checks that a surface may start here; false when it cannot be followed.
    fn may_begin_surface(
        &mut self,
        block: &Block,
        at: usize,
        rules: &SurfaceRules,
        name: &str,
    ) -> bool {
        let code = self.code_text(block, at);
        let span = self.span(block.words[at].range);
        if rules.alone.is_some() && block.all(b'G').count() > 1 {
            let help = "put the other G codes into the block before";
            let message = format!("{code} must be alone in its block");
            self.refuse_surface(span, message, help, rules.alone);
        }
        if self.kernel.state.surface.is_some() {
            let active = self.surface_name();
            let message = format!("{code} while {active} is active");
            self.refuse_surface(span, message, "end it before", rules.nested);
            return false;
        }
        if self.kernel.is_compensating() {
            let message = format!("{name} begins while cutter compensation is on");
            let help = "cancel compensation with G40 before, and start it again inside";
            self.refuse_surface(span, message, help, rules.mode);
        }
        let state = &self.kernel.state;
        let frame = match (state.frames.is_plain(), state.polar.is_some(), state.cycle.is_some()) {
            (false, ..) => Some("coordinates are mirrored, scaled or rotated"),
            (_, true, _) => Some("end points are a radius and an angle (G16)"),
            (.., true) => Some("a canned cycle is active"),
            (true, false, false) => None,
        };
        let Some(what) = frame else { return true };
        let message = format!("{name} begins while {what}");
        self.refuse_surface(span, message, "end it before; this is not followed", rules.mode);
        self.lose_path(block.words[at].range, format!("{code} is not followed here"));
        false
    }

    /// Reports a missing rotary axis; the surface is shown nevertheless.
    fn check_rotary_axis(&mut self, span: Span, rotary: usize, rules: &SurfaceRules) {
        if self.control.axes().has(rotary) {
            return;
        }
        let letter = Axis::ALL[rotary].letter();
        if self.options.assumed_machine {
            let message =
                format!("the assumed machine ({}) has no {letter} axis", self.machine.title);
            let help = "name your machine with --machine";
            let diagnostic = Diagnostic::new(Code::NoSuchAxis, span, message)
                .severity(Severity::Warning)
                .help(help);
            return self.kernel.report(diagnostic);
        }
        let message = format!("the machine {} has no {letter} axis", self.machine.name);
        let help = format!("add `[axes.{letter}]` to the machine file, or choose a machine");
        self.refuse_surface(span, message, &help, rules.axes);
    }

    fn begin_face(&mut self, block: &Block, at: usize, rules: &'static SurfaceRules) {
        let (rotary, along, across) = (Axis::C as usize, Axis::X as usize, Axis::Y as usize);
        let span = self.span(block.words[at].range);
        self.check_rotary_axis(span, rotary, rules);
        let surface = self.kernel.face(rotary, along, across);
        self.kernel.begin_surface(NewSurface {
            surface,
            own_plane: Plane::Xy,
            plane: SurfacePlane::Same,
            own_feed: rules.own_feed,
        });
    }

    /// G7.1 with the rotary axis and the radius, or G107 with the linear axis that it replaces.
    fn cylinder(&mut self, block: &Block, at: usize, rules: &'static SurfaceRules) {
        let span = self.span(block.words[at].range);
        let rotary = (3..6).find(|axis| block.letters().has(AXIS_LETTERS.as_bytes()[*axis]));
        let by_linear = rules.word == SurfaceWord::Linear;
        let Some(rotary) = rotary else {
            if by_linear && !block.letters().meets(Letters::of("XYZ")) {
                return self.end_surface(block, at);
            }
            let code = self.code_text(block, at);
            let message = format!("{code} without its rotary axis");
            let help = "name the rotary axis: with the radius of the cylinder, 0 ends it";
            return self.refuse_surface(span, message, help, rules.axes);
        };
        let letter = AXIS_LETTERS.as_bytes()[rotary];
        let radius = match by_linear {
            true => match block.letters().has(b'R') {
                true => self.length_of(block, b'R'),
                false => self.length_of(block, b'Q').map(|diameter| diameter / 2.0),
            },
            false => self.length_of(block, letter),
        };
        let Some(radius_mm) = radius else {
            let message = "the radius of the cylinder is missing".to_string();
            let help = "write R, the radius, or Q, the diameter";
            self.kernel.missing_word(span, message, help);
            return self.lose_path(block.words[at].range, "the cylinder is not known".into());
        };
        if radius_mm == 0.0 {
            return self.end_surface(block, at);
        }
        let across = match by_linear {
            true => (0..3).find(|axis| block.letters().has(AXIS_LETTERS.as_bytes()[*axis])),
            false if rotary == Axis::B as usize => Some(Axis::X as usize),
            false => Some(Axis::Y as usize),
        };
        let axial = rotary - 3;
        let Some(across) = across.filter(|across| *across != axial && radius_mm > 0.0) else {
            let message = match radius_mm > 0.0 {
                true => format!(
                    "{} turns about {}: the linear axis it takes the place of is another",
                    char::from(letter),
                    Axis::ALL[axial].letter()
                ),
                false => "the radius of a cylinder is negative".to_string(),
            };
            let help = "name the linear axis across, and a radius above 0";
            self.refuse_surface(span, message, help, rules.axes);
            return self.lose_path(block.words[at].range, "the cylinder is not known".into());
        };
        if !self.may_begin_surface(block, at, rules, "cylindrical interpolation") {
            return;
        }
        self.check_rotary_axis(span, rotary, rules);
        let stationary = self.kernel.state.position[across];
        let shape = SurfaceShape::Cylinder { radius_mm };
        let surface = RotarySurface { shape, rotary, across, across_position: stationary };
        let own_plane = plane_of(axial, across);
        let plane = plane_relation(self.kernel.state.plane, own_plane, axial, rules);
        self.kernel.begin_surface(NewSurface {
            surface,
            own_plane,
            plane,
            own_feed: rules.own_feed,
        });
    }

    /// Selects a plane on a cylinder: arcs still lie in the unrolled surface, with their direction as in that plane.
    /// False when no surface is active.
    pub(super) fn plane_on_surface(&mut self, plane: Plane) -> bool {
        let Some((mut state, rules)) = self.surface_rules() else { return false };
        let axial = state.run.surface.rotary - 3;
        let own_plane = plane_of(axial, state.run.surface.across);
        if matches!(state.run.surface.shape, SurfaceShape::Cylinder { .. }) {
            state.plane = plane_relation(plane, own_plane, axial, rules);
            state.plane_after = plane;
            self.kernel.state.surface = Some(state);
        }
        true
    }

    /// Reports codes that are not permitted on the surface; false when the block is skipped.
    pub(super) fn check_surface_codes(
        &mut self,
        block: &Block,
        codes: &[(&'static CodeRow, usize)],
    ) -> bool {
        let Some((state, rules)) = self.surface_rules() else { return true };
        let mut is_carried_out = true;
        for (row, at) in codes.iter().filter(|(_, at)| block.words[*at].letter == b'G') {
            let alarm = match on_surface(row.action, &state, rules) {
                OnSurface::Allowed => continue,
                OnSurface::Rapid => rules.code,
                OnSurface::Length => {
                    is_carried_out = false;
                    rules.length
                }
                OnSurface::Refused => {
                    is_carried_out = false;
                    rules.code
                }
            };
            let message = format!("{} in {}", row.name(b'G'), self.surface_name());
            let word = self.span(block.words[*at].range);
            self.refuse_on_surface(word, message, alarm);
        }
        if let Some(word) = block.last(b'T').copied() {
            let message = format!("a tool or its offset changes in {}", self.surface_name());
            self.refuse_on_surface(self.span(word.range), message, None);
            is_carried_out = false;
        }
        is_carried_out
    }

    fn refuse_on_surface(&mut self, span: Span, message: String, alarm: Option<&str>) {
        let help = "end the interpolation before, and begin it again after";
        let diagnostic = Diagnostic::new(Code::SurfaceCode, span, message).help(help);
        match alarm {
            Some(alarm) => self.report_refused(diagnostic, alarm),
            None => self.kernel.report(diagnostic),
        }
    }

    /// Checks the motion of a block and the centre words of its arc.
    pub(super) fn check_surface_motion(&mut self, block: &Block, explicit: bool) {
        let Some((state, rules)) = self.surface_rules() else { return };
        let span = self.span(block.range);
        let name = self.surface_name();
        match self.kernel.state.motion {
            ModalMotion::Linear => {}
            ModalMotion::Rapid if rules.rapid || explicit => {}
            ModalMotion::Rapid => {
                let message = format!("a rapid in {name}: G0 is active from before");
                self.refuse_on_surface(span, message, rules.code);
            }
            ModalMotion::Arc(_) if state.plane == SurfacePlane::Other => {
                let message = format!("an arc in {name} in a plane without the rotary axis");
                let help =
                    "choose the plane of the axis of the cylinder and the rotary axis before";
                self.refuse_surface(span, message, help, rules.mode);
                self.lose_path(block.range, "this arc is not followed".into());
            }
            ModalMotion::Arc(_) if !rules.centers && block.letters().meets(CENTERS) => {
                let words = self.words_span(block, CENTERS);
                let message = format!("an arc in {name} with I, J or K: only R gives its centre");
                let help = "write the radius with R";
                self.refuse_surface(words, message, help, rules.mode);
                self.lose_path(block.range, "this arc is not followed".into());
            }
            ModalMotion::Arc(_) => {}
            ModalMotion::Spiral(_)
            | ModalMotion::Thread
            | ModalMotion::RigidTap
            | ModalMotion::Probe { .. }
            | ModalMotion::ThreadPasses
            | ModalMotion::Turn(_)
            | ModalMotion::Spline(_)
            | ModalMotion::None => {
                let message = format!("in {name} only straight cuts and arcs are possible");
                self.refuse_on_surface(span, message, rules.code);
                self.lose_path(block.range, "this move is not followed".into());
            }
        }
    }

    /// The direction of an arc: G2 and G3 are exchanged when the plane has the axes of the surface in the other order.
    pub(super) fn direction_on_surface(&self, direction: TurnDirection) -> TurnDirection {
        direction.mirrored_if(self.is_surface_swapped())
    }

    /// The side of compensation, exchanged likewise.
    pub(super) fn side_on_surface(&self, side: CompensationSide) -> CompensationSide {
        side.mirrored_if(self.is_surface_swapped())
    }

    /// Whether the plane has the axes of the surface in the other order.
    fn is_surface_swapped(&self) -> bool {
        self.kernel.state.surface.is_some_and(|state| state.plane == SurfacePlane::Swapped)
    }

    /// The end point of a block in coordinates of the surface, and the coordinates it names.
    #[cold]
    pub(super) fn target_on_surface(&mut self, block: &Block) -> (Position, AxisMask) {
        let from = self.kernel.state.position;
        let (mut target, mut named) = (from, AxisMask::NONE);
        let Some((state, rules)) = self.surface_rules() else { return (target, named) };
        let incremental = self.kernel.state.incremental;
        for word in &block.words {
            if word.comma {
                continue;
            }
            let (axis, by) = match self.increment_axis(word) {
                Some(axis) => (axis, true),
                None => (AXIS_OF[usize::from(word.letter)] as usize, incremental),
            };
            if axis >= 6 {
                continue;
            }
            let Some((slot, value)) = self.value_on_surface(word, axis, &state, rules) else {
                continue;
            };
            target[slot] = if by { from[slot] + value } else { value };
            named.insert(slot);
        }
        (target, named)
    }

    /// An axis word as a coordinate of the surface: its index and value, mm; `None` when it cannot be followed.
    fn value_on_surface(
        &mut self,
        word: &Word,
        axis: usize,
        state: &SurfaceState,
        rules: &SurfaceRules,
    ) -> Option<(usize, f64)> {
        let surface = state.run.surface;
        if axis == surface.across && rules.word == SurfaceWord::Linear {
            return Some((axis, self.length(word)?));
        }
        if axis == surface.across || axis == surface.rotary && rules.word == SurfaceWord::Linear {
            let letter = char::from(word.letter);
            let message =
                format!("{letter} itself moves in {}: this is not followed", self.surface_name());
            self.lose_path(word.range, message);
            return None;
        }
        if axis == surface.rotary {
            let value = match (rules.word, surface.shape) {
                (SurfaceWord::RotaryAngle, SurfaceShape::Cylinder { radius_mm }) => {
                    self.axis_value(word, axis)? * radius_mm
                }
                _ => self.length(word)?,
            };
            return Some((surface.across, value));
        }
        let radii = self.control.parameters.face_x_radius;
        match surface.shape {
            SurfaceShape::Face { along, .. } if along == axis && radii => {
                Some((axis, self.length(word)?))
            }
            SurfaceShape::Face { .. } | SurfaceShape::Cylinder { .. } => {
                if !self.control.axes().has(axis) {
                    let letter = char::from(word.letter);
                    let message = format!(
                        "{letter} in {}: the machine has no such axis",
                        self.surface_name()
                    );
                    self.lose_path(word.range, message);
                    return None;
                }
                Some((axis, self.axis_value(word, axis)?))
            }
        }
    }
}

/// The plane of two linear axes.
fn plane_of(one: usize, other: usize) -> Plane {
    match one + other {
        1 => Plane::Xy,
        2 => Plane::Zx,
        _ => Plane::Yz,
    }
}

/// How the plane of the program relates to that of a cylinder.
fn plane_relation(plane: Plane, own: Plane, axial: usize, rules: &SurfaceRules) -> SurfacePlane {
    let (a, b, _) = plane.axes();
    if plane == own {
        SurfacePlane::Same
    } else if rules.word == SurfaceWord::RotaryAngle && (a == axial || b == axial) {
        SurfacePlane::Swapped
    } else {
        SurfacePlane::Other
    }
}

/// Whether a code is permitted on a surface.
fn on_surface(action: Action, state: &SurfaceState, rules: &SurfaceRules) -> OnSurface {
    let allowed = |is: bool| if is { OnSurface::Allowed } else { OnSurface::Refused };
    match action {
        Action::Motion(MotionCode::Linear | MotionCode::ArcCw | MotionCode::ArcCcw) => {
            OnSurface::Allowed
        }
        Action::Motion(MotionCode::Rapid) if rules.rapid => OnSurface::Allowed,
        Action::Motion(MotionCode::Rapid) => OnSurface::Rapid,
        Action::Motion(_) | Action::Cycle(_) => OnSurface::Refused,
        Action::Once(code) => allowed(matches!(code, OnceCode::Dwell | OnceCode::Surface(_))),
        Action::Mode(code) => allowed(mode_on_surface(code, state, rules)),
        Action::Reading(code) => allowed(code != ReadingCode::SurfaceSpeed),
        Action::Length(_) => OnSurface::Length,
        // These are reported elsewhere, or are M codes.
        Action::Before(_)
        | Action::After(_)
        | Action::Call(_)
        | Action::NoEffect
        | Action::NotSimulated
        | Action::NotFollowed => OnSurface::Allowed,
    }
}

fn mode_on_surface(code: ModeCode, state: &SurfaceState, rules: &SurfaceRules) -> bool {
    let is_face = matches!(state.run.surface.shape, SurfaceShape::Face { .. });
    match code {
        ModeCode::PlaneXy => rules.planes,
        ModeCode::PlaneZx | ModeCode::PlaneYz => rules.planes && !is_face,
        ModeCode::CompensationOff
        | ModeCode::CompensationLeft
        | ModeCode::CompensationRight
        | ModeCode::CompensationLeftByDiameter
        | ModeCode::CompensationRightByDiameter
        | ModeCode::CornerArc
        | ModeCode::CancelCycle
        | ModeCode::Path(_)
        | ModeCode::Overrides { .. }
        | ModeCode::OverridesByP
        | ModeCode::ModalCallOff
        | ModeCode::ThreadExit { .. }
        | ModeCode::DataLinesOff => true,
        ModeCode::WorkOffset(_)
        | ModeCode::WorkOffsetPoint(_)
        | ModeCode::WorkOffsetExtended
        | ModeCode::FixtureError
        | ModeCode::WorkOffsetByOrdinal
        | ModeCode::StoreReference { .. }
        | ModeCode::WorkOffsetNumbered(_)
        | ModeCode::ReturnInitial
        | ModeCode::ReturnToR
        | ModeCode::RotationOff
        | ModeCode::ScalingOff
        | ModeCode::Polar { .. }
        | ModeCode::ModalSubroutine => false,
    }
}
