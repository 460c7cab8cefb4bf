//! Reads the words of mirror, scaling, rotation and polar coordinates.

use chordal_command::{AxisMask, CompensationSide, Position};
use chordal_diagnostics::{Code, Diagnostic};
use chordal_dialect::{Action, CodeGroup, CodeRow, OnceCode, code_number};
use chordal_geometry::{Plane, Vec3};
use chordal_kernel::PolarWords;
use chordal_kernel::frames::ScaleFactors;
use chordal_kernel::frames::plane_forms;
use chordal_machine::AXES;
use chordal_syntax::{Block, Letters};

use super::Interpreter;
use super::literals::AXIS_OF;

impl Interpreter<'_> {
    /// G68: a centre on the axes of the plane, and the angle R.
    pub(super) fn rotation(&mut self, block: &Block, at: usize) {
        if !self.control.parameters.rules.frames.has_rotation {
            let code = Code::RotationOption;
            return self.lacks_option(block, at, code, "rotation of coordinates");
        }
        let row = block.words[at].number().and_then(code_number);
        let row = row.and_then(|code| self.control.g_code(code));
        if row.is_some_and(|row| self.is_spatial(block, row)) {
            return self.rotation_in_space(block, at);
        }
        if self.control.parameters.rules.frames.rotation_center_by_ab {
            return self.rotation_about_ab(block, at);
        }
        let values = self.axis_words(block);
        let (a, b, _) = self.kernel.state.plane.axes();
        self.unused_axes(block, |axis, _| axis == a || axis == b);
        let degrees = self.angle_of(block, b'R');
        self.kernel.rotate(&self.at(block), [values[a], values[b]], degrees);
    }

    /// G68 with I, J and K: the coordinates turn by R about an axis, and X, Y and Z are their new origin.
    fn rotation_in_space(&mut self, block: &Block, at: usize) {
        let [x, y, z, ..] = self.axis_words(block);
        let axis = self.vector_of(block);
        let degrees = self.angle_of(block, b'R');
        let (Some(x), Some(y), Some(z), Some(degrees)) = (x, y, z, degrees) else {
            let what = "a rotation in space without X, Y, Z or R";
            return self.not_followed(&block.words[at], what);
        };
        let origin = Vec3::new(x, y, z);
        // Tool centre point control and planes by angles are not combined with it.
        let is_simple = self.kernel.is_rotated_in_space() || self.kernel.state.part_frame.is_none();
        match plane_forms::about_axis(origin, axis, degrees.to_radians()) {
            Some(turned) if is_simple => {
                let plane = turned.then(&self.active_plane());
                self.kernel.set_space_rotation(plane);
            }
            _ => self.not_followed(&block.words[at], "a rotation about an axis by I, J and K"),
        }
    }

    /// G68 of Mach3: A and B are the centre.
    fn rotation_about_ab(&mut self, block: &Block, at: usize) {
        if self.kernel.state.plane != Plane::Xy {
            return self.not_followed(&block.words[at], "a rotation outside of G17");
        }
        let center = [b'A', b'B'].map(|letter| self.length_of(block, letter));
        let degrees = self.angle_of(block, b'R');
        self.kernel.rotate(&self.at(block), center, degrees);
    }

    /// G51: a centre, and the factor P of all axes or I, J and K of each axis.
    pub(super) fn scaling(&mut self, block: &Block, at: usize) {
        if !self.control.parameters.rules.frames.has_scaling {
            return self.lacks_option(block, at, Code::ScalingOption, "scaling");
        }
        if self.control.parameters.rules.frames.factors_by_axes {
            return self.scaling_by_axes(block);
        }
        let center = self.axis_words(block);
        let rotary = self.control.parameters.rules.frames.scales_rotary;
        self.unused_axes(block, |axis, _| axis < 3 || rotary);
        let factors = if block.letters().has(b'P') {
            self.factor_of(block, b'P').map_or(ScaleFactors::Omitted, ScaleFactors::Common)
        } else if self.control.parameters.rules.frames.factors_by_vector
            && block.letters().meets(Letters::of("IJK"))
        {
            ScaleFactors::Each([b'I', b'J', b'K'].map(|letter| self.factor_of(block, letter)))
        } else {
            ScaleFactors::Omitted
        };
        self.kernel.scale(&self.at(block), &center, factors);
    }

    /// G51 of Mach3: X, Y and Z are factors.
    fn scaling_by_axes(&mut self, block: &Block) {
        let each = [b'X', b'Y', b'Z'].map(|letter| self.factor_of(block, letter));
        if each.iter().all(Option::is_none) {
            let span = self.span(block.range);
            let message = "a scaling without a factor".to_string();
            return self.kernel.missing_word(span, message, "write the factors with X, Y and Z");
        }
        self.kernel.scale(&self.at(block), &[Some(0.0); AXES], ScaleFactors::Each(each));
    }

    /// Reports a block whose result under G51 of Mach3 is not known: it is known only for lines, arcs by their centre,
    /// and blocks without lengths.
    pub(super) fn check_multiplied_words(
        &mut self,
        block: &Block,
        codes: &[(&'static CodeRow, usize)],
    ) {
        let state = &self.kernel.state;
        let by_axes = self.control.parameters.rules.frames.factors_by_axes;
        if !by_axes || state.frames.scaling().is_none() {
            return;
        }
        let has_no_lengths = |group: CodeGroup| {
            matches!(
                group,
                CodeGroup::Distance
                    | CodeGroup::ArcDistance
                    | CodeGroup::FeedMode
                    | CodeGroup::SpindleMode
                    | CodeGroup::Scaling
                    | CodeGroup::PathMode
                    | CodeGroup::Stopping
                    | CodeGroup::Spindle
                    | CodeGroup::Coolant
                    | CodeGroup::ToolChange
                    | CodeGroup::Calling
            )
        };
        let known = |row: &CodeRow| {
            row.action.is_plain_motion()
                || row.action == Action::Once(OnceCode::Dwell)
                || has_no_lengths(row.group)
        };
        let unknown = codes.iter().any(|(row, _)| !known(row));
        let lengths = block.letters().meets(Letters::of("RUVWABC"));
        let frames = state.frames.rotation().is_some() || state.polar.is_some();
        let cuts = state.side != CompensationSide::Off || state.cycle.is_some();
        if !block.is_idle() && (unknown || lengths || frames || cuts) {
            let message =
                "words are multiplied (G51), which is followed for lines and arcs by I, J, K alone";
            self.lose_path(block.range, message.to_string());
        }
    }

    /// G51.1 and Haas G101.
    pub(super) fn mirror(&mut self, block: &Block, at: usize, at_zero: bool) {
        let mut lines = self.axis_words(block);
        if lines.iter().all(Option::is_none) {
            let span = self.span(block.words[at].range);
            let message = "a mirror without an axis".to_string();
            return self.kernel.missing_word(span, message, "name the axes that are mirrored");
        }
        if at_zero {
            lines = lines.map(|line| line.map(|_| 0.0));
        }
        self.kernel.mirror(&self.at(block), &lines);
    }

    /// G50.1 and Haas G100: the named axes, or all.
    pub(super) fn mirror_off(&mut self, block: &Block) {
        let named = AxisMask::with_values(&self.axis_words(block));
        let axes = if named == AxisMask::NONE { AxisMask::ALL } else { named };
        self.kernel.end_mirror(&self.at(block), axes);
    }

    /// Reports a frame that is an option which the machine does not have.
    fn lacks_option(&mut self, block: &Block, at: usize, code: Code, what: &str) {
        let name = self.code_text(block, at);
        let span = self.span(block.words[at].range);
        self.kernel.report(
            Diagnostic::new(code, span, format!("{name}: this machine has no option of {what}"))
                .label("the coordinates stay as they are")
                .help("write the coordinates themselves, or correct the setting of the option"),
        );
    }

    /// A scale factor; a number without a point counts in the unit of the control.
    fn factor_of(&mut self, block: &Block, letter: u8) -> Option<f64> {
        let number = self.literal(block.last(letter)?)?;
        let unit = if number.has_point { 1.0 } else { self.control.table.scale_unit };
        Some(number.to_f64() * unit)
    }

    /// An angle in degrees.
    pub(super) fn angle_of(&mut self, block: &Block, letter: u8) -> Option<f64> {
        self.word_degrees(block.last(letter)?)
    }

    /// The end point when the words of the plane's axes are a radius and an angle.
    #[cold]
    pub(super) fn target_by_angle(&mut self, block: &Block) -> (Position, AxisMask) {
        let state = &self.kernel.state;
        let (from, plane, incremental) = (state.position, state.plane, state.incremental);
        let (a, b, _) = plane.axes();
        let mut target = from;
        let mut named = AxisMask::NONE;
        let mut polar = PolarWords::default();
        for word in &block.words {
            let axis = AXIS_OF[word.letter as usize] as usize;
            if axis >= AXES || word.comma {
                continue;
            }
            if axis == a {
                polar.radius = self.length(word);
            } else if axis == b {
                polar.angle = self.word_degrees(word);
            } else if let Some(value) = self.axis_value(word, axis) {
                target[axis] = if incremental { from[axis] + value } else { value };
                named.insert(axis);
            }
        }
        if (polar.radius, polar.angle) != (None, None) {
            self.check_polar_about_start(block);
        }
        if (polar.radius, polar.angle) != (None, None)
            && let Some(state) = &mut self.kernel.state.polar
        {
            [target[a], target[b]] = state.target(polar, &from, plane, incremental);
            named.insert(a);
            named.insert(b);
        }
        (target, named)
    }

    /// Reports polar words about the start (Mach3) other than for straight moves of the XY plane in G90.
    fn check_polar_about_start(&mut self, block: &Block) {
        let state = &self.kernel.state;
        if state.polar.is_none_or(|polar| polar.pole.is_none()) {
            return;
        }
        let drills = block
            .all(b'G')
            .any(|word| self.control.row_of(word).is_some_and(|row| row.action.cycle().is_some()));
        let what = if state.incremental {
            "polar words in G91"
        } else if state.plane != Plane::Xy {
            "polar words outside of G17"
        } else if drills || state.cycle.is_some() || self.moves_on_arc(block) {
            "polar words of arcs and cycles"
        } else {
            return;
        };
        self.lose_path(block.range, format!("{what} are not followed"));
    }
}
