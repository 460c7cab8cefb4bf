//! Words of mirror, scaling, rotation and polar coordinates.

use chordal_command::{AxisMask, Position};
use chordal_diagnostics::{Code, Diagnostic};
use chordal_dialect::code_number;
use chordal_kernel::PolarWords;
use chordal_kernel::frames::Factors;
use chordal_machine::AXES;
use chordal_syntax::{Block, Letters};

use super::Interpreter;
use super::literals::AXIS_OF;

impl Interpreter<'_> {
    /// G68: a centre on the axes of the plane, and R, the angle.
    pub(super) fn rotation(&mut self, block: &Block, at: usize) {
        if !self.control.parameters.rules.frames.has_rotation {
            let code = Code::RotationOption;
            return self.lacks_option(block, at, code, "rotation of coordinates");
        }
        let row = block.words[at].number().and_then(code_number);
        let row = row.and_then(|code| self.control.g_code(code));
        if row.is_some_and(|row| self.is_spatial(block, row)) {
            // Three words of direction: a rotation about any axis.
            return self.not_followed(&block.words[at], "a rotation about an axis by I, J and K");
        }
        let values = self.axis_words(block);
        let (a, b, _) = self.kernel.state.plane.axes();
        self.unused_axes(block, |axis, _| axis == a || axis == b);
        let degrees = self.angle_of(block, b'R');
        self.kernel.rotate(&self.at(block), [values[a], values[b]], degrees);
    }

    /// G51: a centre, and P for all axes or I, J and K for one each.
    pub(super) fn scaling(&mut self, block: &Block, at: usize) {
        if !self.control.parameters.rules.frames.has_scaling {
            return self.lacks_option(block, at, Code::ScalingOption, "scaling");
        }
        let center = self.axis_words(block);
        let rotary = self.control.parameters.rules.frames.scales_rotary;
        self.unused_axes(block, |axis, _| axis < 3 || rotary);
        let factors = if block.letters().has(b'P') {
            self.factor_of(block, b'P').map_or(Factors::Omitted, Factors::Common)
        } else if self.control.parameters.rules.frames.factors_by_vector
            && block.letters().meets(Letters::of("IJK"))
        {
            Factors::Each([b'I', b'J', b'K'].map(|letter| self.factor_of(block, letter)))
        } else {
            Factors::Omitted
        };
        self.kernel.scale(&self.at(block), &center, factors);
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

    /// A frame that the machine does not have.
    fn lacks_option(&mut self, block: &Block, at: usize, code: Code, what: &str) {
        let name = self.code_text(block, at);
        let span = self.span(block.words[at].range);
        self.kernel.report(
            Diagnostic::new(code, span, format!("{name}: this machine has no option of {what}"))
                .label("the coordinates stay as they are")
                .help("write the coordinates themselves, or correct the setting of the option"),
        );
    }

    /// A scale factor: a number without a point counts in the control's unit.
    fn factor_of(&mut self, block: &Block, letter: u8) -> Option<f64> {
        let number = self.literal(block.last(letter)?)?;
        let unit = if number.has_point { 1.0 } else { self.control.table.scale_unit };
        Some(number.to_f64() * unit)
    }

    /// An angle in degrees.
    pub(super) fn angle_of(&mut self, block: &Block, letter: u8) -> Option<f64> {
        self.word_degrees(block.last(letter)?)
    }

    /// The end point that the words give while they are a radius and an angle on the axes of the plane.
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
        if (polar.radius, polar.angle) != (None, None)
            && let Some(state) = &mut self.kernel.state.polar
        {
            [target[a], target[b]] = state.target(polar, &from, plane, incremental);
            named.insert(a);
            named.insert(b);
        }
        (target, named)
    }
}
