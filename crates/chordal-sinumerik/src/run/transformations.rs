//! TRANSMIT, TRACYL and TRAORI: coordinates on the face or the cylinder of a rotating part, and of a turned tool.

use chordal_command::{AxisMask, RotarySurface, SurfaceShape};
use chordal_diagnostics::{Code, Diagnostic, Severity, TextRange};
use chordal_geometry::Vec3;
use chordal_kernel::{NewSurface, SurfacePlane, TurnError};
use chordal_machine::Axis;

use super::interpreter::Interpreter;
use crate::alarms::NO_ALARM;

const X: usize = Axis::X as usize;
const Y: usize = Axis::Y as usize;
const C: usize = Axis::C as usize;

/// The calls that choose or end a transformation.
pub const TRANSFORMATIONS: [&str; 5] = ["TRANSMIT", "TRACYL", "TRAANG", "TRAORI", "TRAFOOF"];

impl Interpreter<'_> {
    /// Chooses a transformation, with the numbers of its call, or ends the one in force (Job Planning 07/2010, 7).
    pub(super) fn choose_transformation(
        &mut self,
        name: &str,
        numbers: &[Option<f64>],
        range: TextRange,
    ) {
        if self.kernel.is_compensating() {
            let message = format!("{name} while tool radius compensation is on");
            let span = self.span(range);
            let diagnostic = Diagnostic::new(Code::SurfaceMode, span, message);
            let help = "cancel compensation with G40 on a move before";
            self.report_alarm(14400, diagnostic.help(help));
        }
        self.end_transformation();
        match name {
            "TRANSMIT" => self.begin_face(range),
            "TRACYL" => self.begin_cylinder(numbers.first().copied().flatten(), range),
            "TRAORI" if self.needs_rotary_axis(name, &[Axis::A, Axis::B, Axis::C], range) => {
                self.begin_tool_center(name, range);
            }
            "TRAANG" => self.not_followed(range, "TRAANG, the inclined axis, is not followed"),
            _ => {}
        }
    }

    /// TRAORI: the tip goes where the program says, and the axes where the machine file puts them.
    fn begin_tool_center(&mut self, name: &str, range: TextRange) {
        self.kernel.begin_tool_center();
        self.modes.last_direction = None;
        if let Err(error) = self.kernel.rotary_chain() {
            self.report_no_kinematics(name, &error, range);
        }
    }

    /// Says once that the tip is followed and the axes are not, and why.
    pub(super) fn report_no_kinematics(&mut self, name: &str, why: &str, range: TextRange) {
        if self.is_first_report("kinematics") {
            let span = self.span(range);
            self.kernel.report_no_kinematics(span, name, why);
        }
    }

    /// The direction of the tool by A3, B3 and C3, as positions of the rotary axes; `None` where it is not known.
    pub(super) fn rotary_of_direction(
        &mut self,
        direction: [f64; 3],
        range: TextRange,
    ) -> Option<[f64; 3]> {
        match self.kernel.rotary_of_direction(Vec3::from_array(direction)) {
            Ok(angles) => return Some(angles),
            Err(TurnError::NoPlane) => {
                self.not_followed(range, "a direction of the tool without TRAORI is not followed");
            }
            Err(TurnError::NoKinematics(why)) => {
                self.report_no_kinematics("the direction of the tool", &why, range);
            }
            Err(TurnError::Unreachable(why)) => {
                let message = format!("the direction of the tool: {why}");
                let diagnostic = Diagnostic::new(Code::TiltedPlane, self.span(range), message);
                self.report_alarm(NO_ALARM, diagnostic);
            }
        }
        self.kernel.go_astray(AxisMask::ROTARY);
        None
    }

    /// Ends the surface; the plane stays that of the program. Ends the control of the tip.
    fn end_transformation(&mut self) {
        self.kernel.end_tool_center();
        let plane = self.kernel.state.plane;
        if let Some(surface) = &mut self.kernel.state.surface {
            surface.plane_after = plane;
            self.kernel.end_surface();
            self.modes.last_direction = None;
        }
    }

    /// TRANSMIT: X and Y are Cartesian coordinates of the face, X is that of C0.
    fn begin_face(&mut self, range: TextRange) {
        if !self.needs_rotary_axis("TRANSMIT", &[Axis::C], range) {
            return;
        }
        let is_placed = self.kernel.state.known.has(C);
        let surface = self.kernel.face_from(0.0, [C, X, Y]);
        self.begin_surface(surface);
        if !is_placed {
            self.kernel.go_astray(AxisMask(1 << X | 1 << Y));
        }
    }

    /// TRACYL(d): Y is the length around a cylinder of diameter d.
    fn begin_cylinder(&mut self, diameter: Option<f64>, range: TextRange) {
        let Some(diameter) = diameter.filter(|diameter| *diameter > 0.0) else {
            let message = "TRACYL needs the diameter of the cylinder, above 0";
            return self.alarm(14020, Code::MissingWord, range, message);
        };
        if !self.needs_rotary_axis("TRACYL", &[Axis::C, Axis::A, Axis::B], range) {
            return;
        }
        let axes = self.programs.control.axes();
        // The rotary axis turns about one linear axis; the one across is replaced by the length around.
        let found = [(C, Y), (Axis::A as usize, Y), (Axis::B as usize, X)];
        let (rotary, across) =
            found.into_iter().find(|(rotary, _)| axes.has(*rotary)).unwrap_or(found[0]);
        let shape = SurfaceShape::Cylinder { radius_mm: diameter * self.unit_mm() / 2.0 };
        let across_position = self.kernel.state.position[across];
        self.begin_surface(RotarySurface { shape, rotary, across, across_position });
    }

    fn begin_surface(&mut self, surface: RotarySurface) {
        let own_plane = self.kernel.state.plane;
        let plane = SurfacePlane::Same;
        self.kernel.begin_surface(NewSurface { surface, own_plane, plane, own_feed: false });
        self.modes.last_direction = None;
    }

    /// Whether the machine can have the transformation; the control's alarm where it cannot. On a machine that is assumed
    /// it is a warning, and the transformation is carried out.
    fn needs_rotary_axis(&mut self, name: &str, any_of: &[Axis], range: TextRange) -> bool {
        let axes = self.programs.control.axes();
        if any_of.iter().any(|axis| axes.has(*axis as usize)) {
            return true;
        }
        let letters: Vec<String> = any_of.iter().map(|axis| axis.letter().to_string()).collect();
        let letters = letters.join(" or ");
        let span = self.span(range);
        if self.programs.options.assumed_machine {
            let title = &self.kernel.machine.title;
            let message = format!("{name}: the assumed machine ({title}) has no {letters} axis");
            let diagnostic = Diagnostic::new(Code::NoSuchAxis, span, message);
            let help = "name your machine with --machine";
            let diagnostic = diagnostic.severity(Severity::Warning).help(help);
            self.report_possible_alarm(14401, diagnostic);
            return true;
        }
        let title = &self.kernel.machine.title;
        let message = format!("{name}: {title} has no {letters} axis");
        let help = "add the axis to the machine file (`[axes.C]`), or choose a machine";
        let diagnostic = Diagnostic::new(Code::NoSuchAxis, span, message).help(help);
        self.report_alarm(14401, diagnostic);
        self.lose_path(range, "what follows", "the transformation");
        false
    }
}
