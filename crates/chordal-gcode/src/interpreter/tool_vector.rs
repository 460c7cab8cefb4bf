//! Straight moves in a frame of the part: the direction of the tool as a vector (G43.5), and rotary axes that turn while the
//! origin rides on the tables (G254).

use chordal_command::{AxisMask, Position, number_text};
use chordal_diagnostics::{Code, Diagnostic, Severity, Span};
use chordal_geometry::Vec3;
use chordal_kernel::{ModalMotion, TurnError};
use chordal_machine::Axis;
use chordal_syntax::{Block, Letters};

use super::Interpreter;

/// The index of Z among the axes.
const Z: usize = 2;

/// How far the tool may swing out of the plane of two directions in a cut, degrees. Blocks of a posted program stay far
/// below: they are as short as the tolerance of the surface asks for. Next to the pole a table may turn by half a turn,
/// and the tool swings by less than this.
const LARGEST_SWING_DEG: f64 = 2.0;

const VECTOR: Letters = Letters::of("IJK");

impl Interpreter<'_> {
    /// Whether words of this block are a direction of the tool.
    #[inline]
    pub(super) fn has_tool_vector(&self, block: &Block) -> bool {
        self.kernel.state.tool_by_vector && block.letters().meets(VECTOR)
    }

    /// A straight move in a frame of the part.
    #[cold]
    pub(super) fn straight_on_part(
        &mut self,
        block: &Block,
        mut target: Position,
        mut named: AxisMask,
    ) {
        if self.kernel.state.tool_by_vector {
            self.take_tool_vector(block, &mut target, &mut named);
        }
        if named == AxisMask::NONE {
            return;
        }
        if self.kernel.state.origin_on_table {
            return self.straight_from_table(block, target, named);
        }
        if self.kernel.state.length_along_tool {
            return self.straight_along_tool(block, target, named);
        }
        self.kernel.turn_fixed_frame(&target);
        self.kernel.straight(&self.at(block), target, named);
    }

    /// A straight move while the origin rides on the tables. X and Y, then Z are named before the first cut, because each
    /// axis goes to its new place only when it is named (Haas mill manual, G254).
    fn straight_from_table(&mut self, block: &Block, target: Position, named: AxisMask) {
        let span = self.span(block.range);
        if named.and(AxisMask::ROTARY) != AxisMask::NONE {
            let message = "a rotary axis turns while the dynamic work offset is on";
            let help = "end it with G255 before the axis turns, and begin it again after that";
            let diagnostic = Diagnostic::new(Code::TiltedPlane, span, message).help(help);
            self.kernel.report(diagnostic.severity(Severity::Warning));
        }
        let named_before = &mut self.kernel.state.named_on_table;
        let now = named_before.or(named.and(AxisMask::LINEAR));
        let is_in_order =
            named_before.covers(AxisMask::XY) || !named.has(Z) || named.covers(AxisMask::XY);
        *named_before =
            if is_in_order { now } else { now.without(AxisMask::LINEAR.without(AxisMask::XY)) };
        let is_placed = named_before.covers(AxisMask::LINEAR);
        if self.kernel.state.motion == ModalMotion::Linear && !is_placed {
            let message = "a cut after G254 before X and Y, and then Z were named";
            let help = "move to X and Y and then to Z by a rapid before the cut";
            self.kernel.report(Diagnostic::new(Code::TiltedPlane, span, message).help(help));
            self.kernel.state.named_on_table = AxisMask::LINEAR;
        }
        let at = self.at(block);
        match named.and(AxisMask::LINEAR) == AxisMask::NONE {
            true => self.kernel.turn_with_origin(&at, target, named),
            false => self.kernel.straight(&at, target, named),
        }
    }

    /// I, J and K of the block as the rotary axes that bring the tool to this direction.
    fn take_tool_vector(&mut self, block: &Block, target: &mut Position, named: &mut AxisMask) {
        if named.and(AxisMask::ROTARY) != AxisMask::NONE {
            let message = "a rotary axis while I, J and K are the direction of the tool";
            let help = "write the direction as I, J and K, or begin with G43.4 in place of G43.5";
            let span = self.words_span(block, Letters::of("ABC"));
            let Some(alarm) = self.control.table.tilted_plane.rotary_with_vector else {
                return self.report_tool_vector(span, message.into(), help);
            };
            let diagnostic = Diagnostic::new(Code::ToolVector, span, message).help(help);
            return self.report_refused(diagnostic, alarm);
        }
        if !block.letters().meets(VECTOR) {
            return;
        }
        let span = self.words_span(block, VECTOR);
        let vector = self.vector_of(block);
        if vector == Vec3::ZERO {
            let message = "I, J and K are all 0: no direction of the tool";
            let help = "write the vector from the tip of the tool to its holder";
            return self.report_tool_vector(span, message.into(), help);
        }
        match self.kernel.rotary_of_direction(vector) {
            Ok(angles) => {
                if self.kernel.state.motion == ModalMotion::Linear {
                    self.check_swing(span, &angles);
                }
                target[3..].copy_from_slice(&angles);
                *named = named.or(self.kernel.rotary_axes());
            }
            Err(TurnError::NoKinematics(_) | TurnError::NoPlane) => {
                self.kernel.go_astray(AxisMask::ROTARY);
            }
            Err(TurnError::Unreachable(why)) => {
                let message = format!("the direction of the tool cannot be reached: {why}");
                let help = "choose another direction, or a machine whose axes reach it";
                self.report_tool_vector(span, message, help);
            }
        }
    }

    /// I, J and K as the components of a vector, with every decimal; letters that are left out are 0.
    pub(super) fn vector_of(&mut self, block: &Block) -> Vec3 {
        let mut component = |letter: u8| {
            let word = block.last(letter)?;
            let number = self.literal(word)?;
            // Without a point they count in the increments of angles, whatever the units of the program are.
            if number.has_point { Some(number.to_f64()) } else { self.word_degrees(word) }
        };
        Vec3::from_array(b"IJK".map(|letter| component(letter).unwrap_or(0.0)))
    }

    /// Warns of a cut in which the tool does not go from one direction to the next near the plane of both.
    fn check_swing(&mut self, span: Span, angles: &[f64; 3]) {
        let Some(swing) = self.kernel.swing_of_tool(angles) else { return };
        if swing.to_degrees() <= LARGEST_SWING_DEG {
            return;
        }
        let from = self.kernel.state.position;
        let turns = (0..3).filter_map(|index| {
            let turn = (angles[index] - from[index + 3]).to_degrees();
            let letter = Axis::ALL[index + 3].letter();
            let degrees = number_text(turn, 3);
            (degrees != "0").then(|| format!("{letter} by {degrees} deg"))
        });
        let turns = turns.collect::<Vec<_>>().join(" and ");
        let swing = number_text(swing.to_degrees(), 1);
        let message =
            format!("the tool swings {swing} deg out of the plane of its two directions in a cut");
        self.kernel.report(
            Diagnostic::new(Code::SwingingTool, span, message)
                .label(format!("turns {turns} within this block"))
                .note(format!("up to {LARGEST_SWING_DEG} deg is not reported"))
                .help("turn by a rapid with the tool off the part, or give directions between"),
        );
    }

    fn report_tool_vector(&mut self, span: Span, message: String, help: &str) {
        let diagnostic = Diagnostic::new(Code::ToolVector, span, message).help(help);
        self.kernel.report(diagnostic);
    }
}
