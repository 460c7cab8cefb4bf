//! Tool centre point control, the length of the tool along its direction as the heads stand (Haas G143), and arcs while the
//! tables turn.

use chordal_command::{AxisMask, Position};
use chordal_diagnostics::{Code, Diagnostic};
use chordal_dialect::CodeRow;
use chordal_machine::{AXES, Axis, RotaryTarget};
use chordal_syntax::{Block, Letters};

use super::Interpreter;

/// The number of linear axes, before which none is rotary.
const LINEAR_AXES: usize = 3;

/// The heads that G143 is made for.
const HEADS: [usize; 2] = [Axis::A as usize, Axis::B as usize];

impl Interpreter<'_> {
    /// G43.4, G234: from here on coordinates are those of the tip.
    pub(super) fn begin_tool_center(
        &mut self,
        block: &Block,
        code: Option<&(&'static CodeRow, usize)>,
        by_vector: bool,
    ) {
        if let Some((_, at)) = code {
            self.check_begin_of_tool_center(block, *at, by_vector);
        }
        self.kernel.begin_tool_center();
        self.kernel.state.tool_by_vector = by_vector;
        let error = self.kernel.rotary_chain().err();
        if let (Some(error), Some((_, at))) = (error, code) {
            let (name, span) = (self.code_text(block, *at), self.span(block.words[*at].range));
            self.kernel.report_no_kinematics(span, &name, &error);
        }
    }

    /// G143: the manual asks for two heads A and B, and for G90.
    pub(super) fn begin_length_along_tool(&mut self, block: &Block, at: usize) {
        let (name, span) = (self.code_text(block, at), self.span(block.words[at].range));
        self.check_absolute_along_tool(block, &name);
        let is_there = |axis: usize| self.machine.axes[axis].is_some();
        let turns = |axis: usize| self.machine.rotary[axis - LINEAR_AXES].turns;
        let is_head = |axis: usize| {
            is_there(axis) && turns(axis).is_none_or(|what| what == RotaryTarget::Head)
        };
        if !HEADS.into_iter().all(is_head) {
            let found = (LINEAR_AXES..AXES).filter(|axis| is_there(*axis)).map(|axis| {
                let letter = Axis::ALL[axis].letter();
                turns(axis).map_or_else(
                    || letter.to_string(),
                    |what| format!("{letter}, which turns the {}", what.as_str()),
                )
            });
            let found = found.collect::<Vec<_>>().join(", and ");
            let label = match found.is_empty() {
                true => "this machine has no rotary axis".to_string(),
                false => format!("this machine has {found}"),
            };
            let message = format!("{name} on a machine without the heads A and B");
            return self.kernel.report(
                Diagnostic::new(Code::LengthAlongTool, span, message)
                    .label(label)
                    .help("use G234 on a machine with tables, or G43 with the tool upright"),
            );
        }
        if let Err(why) = self.kernel.rotary_chain() {
            self.kernel.report_no_kinematics(span, &name, &why);
        }
        self.kernel.begin_length_along_tool();
    }

    /// The length along the tool is used in G90.
    fn check_absolute_along_tool(&mut self, block: &Block, name: &str) {
        if !self.kernel.state.incremental || self.reported.incremental_along_tool {
            return;
        }
        self.reported.incremental_along_tool = true;
        let message = format!("{name} in G91");
        self.kernel.report(
            Diagnostic::new(Code::LengthAlongTool, self.span(block.range), message)
                .label("the length turns with the heads, and increments do not say to where")
                .help("write G90 and the end points"),
        );
    }

    /// A straight move while the length acts along the tool: an axis that the block does not name stands.
    pub(super) fn straight_along_tool(&mut self, block: &Block, target: Position, named: AxisMask) {
        self.check_absolute_along_tool(block, "a move under G143");
        let target = self.kernel.target_along_tool(&target, named);
        self.kernel.straight(&self.at(block), target, named);
    }

    /// Under G143 there are only straight moves: no arcs, no cycles.
    pub(super) fn check_straight_along_tool(&mut self, block: &Block, what: &str) {
        if !self.kernel.state.length_along_tool {
            return;
        }
        let message = format!("{what} under G143");
        self.kernel.report(
            Diagnostic::new(Code::LengthAlongTool, self.span(block.range), message)
                .label("five-axis length compensation moves in G0 and G1 only")
                .help("end it before with G49, or write lines"),
        );
    }

    /// An arc in a frame of the tip that stays. Only a table about the normal of its plane may turn with it; what its path
    /// is then is not followed.
    pub(super) fn check_arc_in_fixed_frame(
        &mut self,
        block: &Block,
        target: &Position,
        named: AxisMask,
    ) {
        let follows_tip =
            self.kernel.state.part_frame.as_ref().is_some_and(|frame| frame.follows_tip);
        let stays = self.control.parameters.rules.frames.tip_frame_stays;
        let turns = target[3..] != self.kernel.state.position[3..];
        if !follows_tip || !stays || !turns || named.and(AxisMask::ROTARY) == AxisMask::NONE {
            return;
        }
        let (_, _, normal) = self.kernel.state.plane.axes();
        let across = self.kernel.turns_across(target, normal);
        let Some(axis) = across.iter().next() else {
            let message = "an arc while the table turns, in a frame that stays, is not followed";
            return self.lose_path(block.range, message.to_string());
        };
        let letter = axis.letter();
        let message = format!("an arc while {letter} turns, in a frame of the tip that stays");
        let diagnostic = Diagnostic::new(Code::RotaryInArc, self.span(block.range), message)
            .label(format!("{letter} is no table about the normal of the plane of the arc"))
            .help("turn before the arc, or write it as lines");
        match self.control.table.tilted_plane.arc_while_turning {
            Some(alarm) => self.report_refused(diagnostic, alarm),
            None => self.kernel.report(diagnostic),
        }
    }

    /// Rotary axes in a block that is no straight move, where the coordinates follow the tables: with the error of a clamped
    /// part, and in a frame of the tip that stays.
    pub(super) fn check_turn_in(&mut self, block: &Block, what: &str) {
        if !block.letters().meets(Letters::of("ABC")) {
            return;
        }
        let follows_tip =
            self.kernel.state.part_frame.as_ref().is_some_and(|frame| frame.follows_tip);
        let stays = follows_tip && self.control.parameters.rules.frames.tip_frame_stays;
        let frame = match self.kernel.state.offsets.fixture().number {
            0 if stays => "in a frame of the tip that stays",
            0 => return,
            _ => "with a fixture offset",
        };
        let message = format!("{what} that turns the tables, {frame}, is not followed");
        self.lose_path(block.range, message);
    }
}
