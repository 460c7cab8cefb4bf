//! The codes that start and end frames, and what a control refuses there.

use chordal_command::{AxisMask, CompensationSide};
use chordal_diagnostics::{Code, Diagnostic, Severity, Span};
use chordal_geometry::Plane;
use chordal_machine::{AXES, PerAxis};

use crate::frames::{AxisScaling, Frames, InPlane, PlaneRotation, PolarReading, ScaleFactors};
use crate::kernel::Kernel;
use crate::rules::UnequalArcs;
use crate::statement::{Statement, WordMeaning};

impl Kernel<'_> {
    /// Rotates coordinates in the active plane, about a centre that is absolute even in G91; an axis without a
    /// centre uses the present position.
    pub fn rotate(&mut self, at: &dyn Statement, center: [Option<f64>; 2], degrees: Option<f64>) {
        self.check_start_in_compensation(at);
        let rules = &self.rules.frames;
        let most = rules.largest_angle_deg;
        if let Some(degrees) = degrees.filter(|degrees| degrees.abs() > most) {
            return self.report(
                Diagnostic::new(
                    Code::FrameValue,
                    at.words(WordMeaning::Angle),
                    format!("a rotation by {degrees}°, and this control takes {most}° at most"),
                )
                .label("the coordinates are not rotated")
                .help(format!("write {}°, which is the same direction", degrees % 360.0)),
            );
        }
        let place = self.state.position;
        let before = self.state.frames.programmed_degrees();
        let kept = self.state.last_rotation_deg;
        let degrees = match (degrees, before) {
            (Some(degrees), Some(before)) if rules.angle_adds && self.state.incremental => {
                before + degrees
            }
            (Some(degrees), _) => degrees,
            (None, _) if rules.angle_is_kept => kept.unwrap_or(0.0),
            (None, _) => rules.omitted_angle_deg,
        };
        self.state.last_rotation_deg = Some(degrees);
        let plane = self.state.plane;
        let (a, b, _) = plane.axes();
        self.change_frames(|frames| frames.set_rotation(None));
        // The position of the tool without the previous rotation.
        let here = self.state.position;
        let center = [center[0].unwrap_or(here[a]), center[1].unwrap_or(here[b])];
        self.change_frames(|frames| {
            frames.set_rotation(Some(PlaneRotation { plane, center, degrees }));
        });
        self.note_jump(&place);
    }

    /// From here on, end points are a radius and an angle (`on`), or coordinates again.
    pub fn set_polar(&mut self, on: bool) {
        let (a, b, _) = self.state.plane.axes();
        let here = [self.state.position[a], self.state.position[b]];
        let pole = self.rules.frames.polar_about_start.then_some(here);
        self.state.polar = on.then_some(PolarReading { angle: None, pole });
    }

    /// Scales coordinates about a centre; an axis without a centre uses the present position.
    pub fn scale(
        &mut self,
        at: &dyn Statement,
        center: &PerAxis<Option<f64>>,
        factors: ScaleFactors,
    ) {
        self.check_start_in_compensation(at);
        let rules = &self.rules.frames;
        let mut of_axes = [1.0; AXES];
        match factors {
            ScaleFactors::Common(factor) => {
                let scaled = if rules.scales_rotary { AXES } else { 3 };
                of_axes[..scaled].fill(factor);
            }
            ScaleFactors::Each(each) => {
                for (of_axis, provided) in of_axes.iter_mut().zip(each) {
                    *of_axis = provided.unwrap_or(1.0);
                }
            }
            ScaleFactors::Omitted => of_axes[..3].copy_from_slice(&rules.omitted_factors),
        }
        if rules.scales_named_axes && center.iter().any(Option::is_some) {
            for (of_axis, named) in of_axes.iter_mut().zip(center) {
                if named.is_none() {
                    *of_axis = 1.0;
                }
            }
        }
        let [least, most] = rules.factor_range;
        let wrong = |factor: &&f64| factor.abs() <= least || factor.abs() >= most;
        if let Some(wrong) = of_axes.iter().find(wrong) {
            let message =
                format!("a scale factor of {wrong} is outside of what this control takes");
            let range = format!("above {least} and below {most}");
            let span = at.span();
            return self.report(
                Diagnostic::new(Code::FrameValue, span, message).label(range).help(
                    "write the factor as the control counts it; a factor of 1 changes nothing",
                ),
            );
        }
        let place = self.state.position;
        self.change_frames(|frames| frames.set_scaling(None));
        let here = self.state.position;
        let by_mode = rules.center_by_mode && self.state.incremental;
        let center = std::array::from_fn(|axis| match center[axis] {
            Some(value) if by_mode => here[axis] + value,
            Some(value) => value,
            None => here[axis],
        });
        self.change_frames(|frames| {
            frames.set_scaling(Some(AxisScaling { center, factors: of_axes }));
        });
        self.note_jump(&place);
    }

    /// Mirrors each axis that has a value at that coordinate, mm.
    pub fn mirror(&mut self, at: &dyn Statement, lines: &PerAxis<Option<f64>>) {
        self.check_start_in_compensation(at);
        self.change_frames(|frames| {
            for (axis, line) in lines.iter().enumerate() {
                if line.is_some() {
                    frames.set_mirror(axis, *line);
                }
            }
        });
    }

    /// Ends the mirror image of these axes.
    pub fn end_mirror(&mut self, at: &dyn Statement, axes: AxisMask) {
        let ends = self.state.frames.kinds().mirror;
        if ends && !self.rules.frames.mirror_ends_in_compensation {
            self.check_end_in_compensation(at, "mirror image");
        }
        self.change_frames(|frames| {
            for axis in axes.iter() {
                frames.set_mirror(axis as usize, None);
            }
        });
    }

    /// Ends the rotation.
    pub fn end_rotation(&mut self, at: &dyn Statement) {
        let ends = self.state.frames.rotation().is_some();
        if ends && !self.rules.frames.rotation_ends_in_compensation {
            self.check_end_in_compensation(at, "rotation");
        }
        let place = self.state.position;
        self.change_frames(|frames| frames.set_rotation(None));
        self.note_jump(&place);
    }

    /// Ends the scaling.
    pub fn end_scaling(&mut self) {
        let place = self.state.position;
        self.change_frames(|frames| frames.set_scaling(None));
        self.note_jump(&place);
    }

    /// Reports a frame that ends while the tool is offset, where the control requires compensation off before.
    fn check_end_in_compensation(&mut self, at: &dyn Statement, what: &str) {
        if self.state.side == CompensationSide::Off {
            return;
        }
        let span = at.span();
        self.report(
            Diagnostic::new(
                Code::FrameInCompensation,
                span,
                format!("{what} ends while cutter compensation is on"),
            )
            .label("the offset contour breaks here")
            .help("cancel compensation with G40 before this block"),
        );
    }

    /// Changes the frames without moving the machine. A mirror that starts or ends changes the side of the tool.
    fn change_frames(&mut self, change: impl FnOnce(&mut Frames)) {
        let plane = self.state.plane;
        let side = self.state.side;
        let before = self.state.frames.map().side(side, plane);
        self.state.change_frames(change);
        if side != CompensationSide::Off && self.state.frames.map().side(side, plane) != before {
            let number = self.state.radius_offset;
            self.emit_compensation(number, None, self.origin.span);
        }
    }

    /// Reports a frame that starts while the tool is offset.
    fn check_start_in_compensation(&mut self, at: &dyn Statement) {
        if self.state.side == CompensationSide::Off || self.rules.frames.in_compensation {
            return;
        }
        let span = at.span();
        self.report(
            Diagnostic::new(
                Code::FrameInCompensation,
                span,
                "the coordinates are mirrored, scaled or rotated while cutter compensation is on",
            )
            .label("the offset contour breaks here")
            .help("cancel compensation with G40 before this block, and start it again after it"),
        );
    }

    /// True when the active frames keep an arc in the active plane an arc; otherwise this is reported.
    pub fn arc_fits_frames(&mut self, at: &dyn Statement) -> bool {
        if self.state.frames.is_plain() {
            return true;
        }
        let plane = self.state.plane;
        match self.state.frames.in_plane(plane) {
            InPlane::Similar { .. } => true,
            InPlane::Unequal { .. } => {
                let judged = self.rules.frames.unequal_arcs == UnequalArcs::Judged;
                if !judged {
                    self.report_unequal_arc(at);
                }
                judged
            }
            InPlane::Tilted if self.rules.frames.work_rotation => true,
            InPlane::Tilted => {
                self.report_tilted_arc(at.span(), "an arc");
                false
            }
        }
    }

    /// Reports a spiral while coordinates are mirrored or scaled, on a control that refuses it; true when refused.
    pub fn spiral_is_refused(&mut self, at: &dyn Statement) -> bool {
        let kinds = self.state.frames.kinds();
        if !self.rules.frames.refuses_spirals || !kinds.mirror && !kinds.scaling {
            return false;
        }
        let what = if kinds.mirror { "mirrored" } else { "scaled" };
        self.report(
            Diagnostic::new(
                Code::SpiralInFrame,
                at.span(),
                format!("a spiral while coordinates are {what}: this control refuses it"),
            )
            .label("shown as a straight line")
            .help("cancel the mirror image (G50.1) and the scaling (G50) first"),
        );
        true
    }

    #[cold]
    fn report_unequal_arc(&mut self, at: &dyn Statement) {
        let span = at.span();
        self.report(
            Diagnostic::new(
                Code::UnequalScaleArc,
                span,
                "an arc while the axes of its plane have different scale factors: it would be an ellipse",
            )
            .label("shown as a straight line")
            .help("scale both axes of the plane alike, or write the curve as lines"),
        );
    }

    /// Reports an arc, or compensation (`what`), in a plane other than that of the rotation.
    #[cold]
    pub fn report_tilted_arc(&mut self, span: Span, what: &str) {
        let plane = |plane: Plane| match plane {
            Plane::Xy => "XY (G17)",
            Plane::Zx => "ZX (G18)",
            Plane::Yz => "YZ (G19)",
        };
        let turned = self.state.frames.rotation().map_or(Plane::Xy, |rotation| rotation.plane);
        let message =
            format!("{what} in {} while {} is rotated", plane(self.state.plane), plane(turned));
        self.report(
            Diagnostic::new(Code::FramePlane, span, message)
                .label("not the plane of the rotation")
                .help(
                    "cancel the rotation with G69 first, or choose the plane before the rotation",
                ),
        );
    }

    /// Reports a change of plane while a rotation is active.
    pub(crate) fn check_plane_change(&mut self, word: Span, plane: Plane) {
        let other = self.state.frames.rotation().is_some_and(|rotation| rotation.plane != plane);
        if !other || self.rules.frames.plane_change {
            return;
        }
        self.report(
            Diagnostic::new(Code::FramePlane, word, "the plane changes while a rotation is active")
                .help("cancel the rotation with G69 first"),
        );
    }

    /// Warns of a code that uses machine or work coordinates while the program mirrors, scales or rotates them.
    pub fn warn_of_frames(&mut self, word: Span, code: &str) {
        if !self.state.frames.are_inside_presets() {
            return;
        }
        let active = self.state.frames.names();
        self.report(
            Diagnostic::new(
                Code::FrameWithReference,
                word,
                format!("{code} while {active} is active"),
            )
            .severity(Severity::Warning)
            .label("carried out")
            .help(format!(
                "manuals ask to cancel {active} first: move this block before or after it"
            )),
        );
    }

    /// A length on the machine along an axis, converted to program coordinates, mm.
    pub fn unscaled(&self, axis: usize, mm: f64) -> f64 {
        match self.state.frames.is_plain() {
            true => mm,
            false => mm / self.state.frames.map().factor_along(axis),
        }
    }
}
