//! Work offsets, tool length, compensation, G10, tools, spindle, coolant, registers.

use chordal_diagnostics::{Code, Diagnostic, Severity};
use chordal_syntax::{Block, Letters, Value};

use super::Interpreter;
use super::values::trim;
use crate::command::{CommandKind, Coolant, Side, SpindleState, WorkName};
use crate::compensation::LeadLength;
use crate::offsets::LengthOffset;
use crate::parameters::OffsetKind;
use crate::state::Motion;
use crate::table::{Action, DataTarget, Group, MotionModality};

impl Interpreter<'_> {
    pub(super) fn emit_work_offset(&mut self) {
        let state = &self.state;
        let kind = CommandKind::WorkOffset {
            name: state.offsets.active(),
            offset: state.offsets.work(),
            known: state.offsets.known(),
            position: state.position,
        };
        self.emit(kind);
    }

    pub(super) fn select_work(&mut self, name: WorkName) {
        if self.state.offsets.active() == name {
            return;
        }
        self.state.shift_coordinates(|offsets| offsets.select(name));
        self.emit_work_offset();
    }

    /// E.
    pub(super) fn take_e_word(&mut self, block: &Block) {
        let Some(number) = self.count_of(block, b'E') else { return };
        if number > 48 {
            let span = self.words_span(block, Letters::of("E"));
            self.report(
                Diagnostic::new(
                    Code::BadWordValue,
                    span,
                    format!("there is no work offset E{number}"),
                )
                .label("E0 to E48")
                .help("E1 to E48 choose a work offset, E0 cancels"),
            );
            return;
        }
        if self.moves_on_arc(block) {
            let span = self.words_span(block, Letters::of("E"));
            self.report(
                Diagnostic::new(Code::BadWordValue, span, "E may not be in a block with an arc")
                    .label("the work offset changes only with G0 or G1")
                    .help("put E into the block before"),
            );
        }
        let name = if number == 0 { WorkName::Machine } else { WorkName::E(number as u16) };
        self.select_work(name);
    }

    /// G54.1 P, G154 P.
    pub(super) fn select_extended_work(&mut self, block: &Block, at: usize) {
        match self.count_of(block, b'P') {
            Some(number) if (1..=300).contains(&number) => {
                self.select_work(WorkName::Extended(number as u16));
            }
            Some(number) => {
                let span = self.words_span(block, Letters::of("P"));
                self.report(
                    Diagnostic::new(
                        Code::BadWordValue,
                        span,
                        format!("there is no extended work offset P{number}"),
                    )
                    .help("extended work offsets begin with P1"),
                );
            }
            None => {
                let span = self.span(block.words[at].range);
                let message = "an extended work offset without its number".to_string();
                self.missing_word(span, message, "write P and the number after the code");
            }
        }
    }

    pub(super) fn set_length(&mut self, block: &Block, length: LengthOffset) {
        let cancel = self.control.parameters.cycles.cancel;
        self.end_cycle_if(length.number.is_none() && cancel.by_length_cancel);
        self.state.shift_coordinates(|offsets| offsets.set_length(length));
        let length_mm = self.state.offsets.length_in_force();
        if let (Some(number), None) = (length.number, length_mm) {
            let span = self.words_span(block, Letters::of("H"));
            self.tell_unset(
                span,
                "length".into(),
                format!("the machine file gives no length for tool {number}"),
                format!("set it with --set tools.{number}.length=\"…\""),
            );
        }
        let known = self.state.offsets.known();
        self.emit(CommandKind::ToolLength { number: length.number, length_mm, known });
    }

    /// Told once for each offset.
    fn tell_unset(
        &mut self,
        span: chordal_diagnostics::Span,
        name: String,
        message: String,
        help: String,
    ) {
        if self.told.offsets.contains(&name) {
            return;
        }
        self.told.offsets.push(name);
        self.report(Diagnostic::new(Code::OffsetNotSet, span, message).help(help));
    }

    /// H of another tool than the one in the spindle.
    pub(super) fn check_length_number(&mut self, block: &Block, number: u32) {
        let tool = self.state.tool;
        if tool == 0 || tool == number {
            return;
        }
        let severity = if self.control.parameters.length_must_match_tool {
            Severity::Error
        } else {
            Severity::Note
        };
        let span = self.words_span(block, Letters::of("H"));
        self.report(
            Diagnostic::new(
                Code::LengthOffsetOfOtherTool,
                span,
                format!("H{number} is not the length offset of tool {tool} in the spindle"),
            )
            .severity(severity)
            .label(format!("tool {tool} is in the spindle"))
            .help(format!("write H{tool} if offsets have the numbers of their tools")),
        );
    }

    /// G40, G41, G42.
    pub(super) fn set_compensation(&mut self, block: &Block, at: usize, action: Action) {
        let side = match action {
            Action::CompensationLeft => Side::Left,
            Action::CompensationRight => Side::Right,
            _ => Side::Off,
        };
        let before = self.state.side;
        if side == Side::Off && before == Side::Off {
            return;
        }
        let span = self.span(block.words[at].range);
        self.check_compensation_move(block, side, span);
        let number = self.compensation_number(block);
        if side != Side::Off && number.is_none() {
            let code = Code::CompensationWithoutOffset;
            let alarms = self.control.table.alarm(code).is_some();
            let severity = if alarms { Severity::Error } else { code.info().severity };
            self.report(
                Diagnostic::new(code, span, "compensation is turned on without an offset number")
                    .severity(severity)
                    .label("no offset number for this")
                    .help("put the D word into this block or before it"),
            );
        }
        if before == Side::Off {
            self.note_contour_of_call(block);
        }
        self.state.side = side;
        if before == Side::Off {
            self.check_lead_in_words(block, span);
        }
        let toward = self.compensation_direction(block);
        self.emit_compensation(number, toward, span);
    }

    /// A block that turns compensation on and moves the third axis alone, on a control that wants a lead-in.
    fn check_lead_in_words(&mut self, block: &Block, span: chordal_diagnostics::Span) {
        let rules = &self.control.parameters.compensation;
        let (a, b, normal) = self.state.plane.axes();
        let [a, b, normal] = [a, b, normal].map(|axis| b"XYZ"[axis]);
        let letters = block.letters();
        let alone = letters.has(normal) && !letters.has(a) && !letters.has(b);
        let wants = rules.lead == LeadLength::AboveOffset && !rules.lead_follows_code;
        if !alone || !wants || self.moves_on_arc(block) {
            return;
        }
        let [a, b, normal] = [a, b, normal].map(char::from);
        self.report(
            Diagnostic::new(
                Code::LeadInTooShort,
                span,
                format!(
                    "compensation starts in a block that moves only {normal}: this is not a lead-in"
                ),
            )
            .label(format!("no {a} or {b} in this block"))
            .help(format!("move {a} or {b} in the block of G41 or G42, by more than the offset")),
        );
    }

    /// D while compensation is on: the offset changes with this block.
    pub(super) fn change_compensation_offset(&mut self, block: &Block) {
        let number = self.compensation_number(block);
        let span = self.words_span(block, Letters::of("D"));
        self.emit_compensation(number, None, span);
    }

    fn emit_compensation(
        &mut self,
        number: Option<u32>,
        toward: Option<[f64; 2]>,
        span: chordal_diagnostics::Span,
    ) {
        let side = self.state.side;
        let cancelled = number == Some(0);
        let radius_mm = match number {
            Some(0) => Some(0.0),
            other => other.and_then(|number| self.state.offsets.radius_mm(number)),
        };
        if cancelled && side != Side::Off {
            self.report(
                Diagnostic::new(
                    Code::CompensationWithoutOffset,
                    span,
                    "with D0 the tool is not offset",
                )
                .severity(Severity::Note)
                .help("write the number of the tool's offset"),
            );
        }
        self.emit(CommandKind::Compensation { side, number, radius_mm, toward });
        if let (Some(number), None) = (number, radius_mm)
            && side != Side::Off
            && !cancelled
        {
            self.tell_unset(
                span,
                format!("radius {number}"),
                format!(
                    "the machine file gives no diameter for offset {number}: compensation has no \
                     effect, and the programmed contour is shown"
                ),
                format!("set it with --set tools.{number}.diameter=\"…\""),
            );
        }
    }

    /// I J K beside G40, G41 or G42, on the axes of the plane.
    fn compensation_direction(&mut self, block: &Block) -> Option<[f64; 2]> {
        if !self.control.parameters.compensation.off_toward
            || !block.letters().meets(Letters::of("IJK"))
            || self.moves_on_arc(block)
        {
            return None;
        }
        let (first, second, _) = self.state.plane.axes();
        let along = |s: &mut Self, axis: usize| s.length_of(block, b"IJK"[axis]).unwrap_or(0.0);
        Some([along(self, first), along(self, second)])
    }

    /// G39: the direction of what follows, by I J K, or by the axes where they are not moved.
    pub(super) fn corner_arc(&mut self, block: &Block, own_block: bool) {
        if self.state.side == Side::Off {
            return;
        }
        let (first, second, _) = self.state.plane.axes();
        let letters = block.letters();
        let toward = if letters.meets(Letters::of("IJK")) && own_block {
            let along = |s: &mut Self, axis: usize| s.length_of(block, b"IJK"[axis]).unwrap_or(0.0);
            Some([along(self, first), along(self, second)])
        } else if own_block && letters.meets(Letters::of("XYZ")) {
            let (target, _) = self.target(block);
            let from = self.state.position;
            Some([target[first] - from[first], target[second] - from[second]])
        } else {
            None
        };
        self.emit(CommandKind::CornerArc { toward });
    }

    /// The offset in force, or the tool in the spindle.
    fn compensation_number(&mut self, block: &Block) -> Option<u32> {
        if self.control.parameters.compensation.offset_of_tool {
            let given = if block.letters().has(b'D') { self.count_of(block, b'D') } else { None };
            return given.filter(|number| *number > 0).or(Some(self.state.tool));
        }
        self.offset_in_force()
    }

    /// The number of the radius offset in force: D, or where H brings the diameter too, H.
    pub(super) fn offset_in_force(&self) -> Option<u32> {
        let by_h = self.control.parameters.length_by_h_alone;
        self.state.radius_offset.or(self.state.offsets.length().number.filter(|_| by_h))
    }

    /// Compensation goes on and off along a straight move.
    fn check_compensation_move(
        &mut self,
        block: &Block,
        side: Side,
        span: chordal_diagnostics::Span,
    ) {
        // A change of side is no start.
        let on = self.state.side != Side::Off;
        let may_start = on || self.control.parameters.compensation.start_on_arc;
        if (side != Side::Off && may_start) || !self.moves_on_arc(block) {
            return;
        }
        let what = if side == Side::Off { "ends" } else { "starts" };
        self.report(
            Diagnostic::new(
                Code::CompensationOnArc,
                span,
                format!("cutter compensation {what} on an arc"),
            )
            .label("this block is an arc")
            .help(if side == Side::Off {
                "put G40 on a straight move away from the contour"
            } else {
                "put G41 or G42 on a straight move to the contour"
            }),
        );
    }

    /// True when the motion of this block is an arc, by its own code or the one in force.
    fn moves_on_arc(&self, block: &Block) -> bool {
        let arc_words = self.has_arc_words(block);
        if self.control.table.motion == MotionModality::Armed {
            return arc_words;
        }
        let moves = arc_words || block.letters().meets(Letters::of("XYZ"));
        let own = block.all(b'G').filter_map(|word| {
            let row = self.control.g_code(crate::table::code_number(word.number()?)?)?;
            (row.group == Group::Motion).then_some(row.action)
        });
        moves
            && match own.last() {
                Some(action) => !matches!(action, Action::Rapid | Action::Linear),
                None => !matches!(self.state.motion, Motion::Rapid | Motion::Linear),
            }
    }

    /// G10.
    pub(super) fn set_data(&mut self, block: &Block, at: usize) {
        let l = self.count_of(block, b'L');
        let target = l.and_then(|l| {
            let rows = self.control.table.set_data;
            rows.iter().find(|(number, _)| u32::from(*number) == l).map(|(_, target)| *target)
        });
        let span = self.span(block.words[at].range);
        match target {
            Some(DataTarget::WorkOffset) => self.write_work_offset(block, false),
            Some(DataTarget::WorkOffsetFromPosition) => self.write_work_offset(block, true),
            Some(DataTarget::ExtendedWorkOffset) => self.write_extended(block),
            Some(DataTarget::Register) => self.write_register(block, l.unwrap_or(100) - 100),
            Some(DataTarget::ToolTable) => self.write_tool_table(block),
            Some(
                target @ (DataTarget::Length
                | DataTarget::LengthWear
                | DataTarget::Radius
                | DataTarget::RadiusWear),
            ) => self.write_tool(block, target),
            Some(DataTarget::Other) => self.report(Diagnostic::new(
                Code::NotSimulated,
                span,
                format!("G10 L{} is not simulated", l.unwrap_or(0)),
            )),
            None => {
                let known: Vec<String> = self
                    .control
                    .table
                    .set_data
                    .iter()
                    .filter(|(number, _)| *number < 100)
                    .map(|(number, _)| format!("L{number}"))
                    .collect();
                let help = format!("this control has {}", known.join(", "));
                let message = match l {
                    Some(l) => format!("this control does not have G10 L{l}"),
                    None => "G10 without L".to_string(),
                };
                self.report(Diagnostic::new(Code::BadWordValue, span, message).help(help));
            }
        }
    }

    /// The key of work offset P as G10 L2 counts them.
    fn work_key(&mut self, block: &Block) -> Option<String> {
        let number = self.count_of(block, b'P')?;
        let table = self.control.table;
        let name = match number {
            n if table.work_offset_by_e => return Some(format!("E{n}")),
            0 if table.arc_turns == crate::table::ArcTurns::Total => self.state.offsets.active(),
            0 => return Some("EXT".into()),
            n @ 1..=6 => WorkName::G(n as u16 + 53),
            n @ 7..=9 => WorkName::G59(n as u16 - 6),
            _ => return None,
        };
        Some(self.state.offsets.key(name))
    }

    fn write_work_offset(&mut self, block: &Block, from_position: bool) {
        let Some(key) = self.work_key(block) else {
            let span = self.words_span(block, Letters::of("P"));
            let message = "G10 L2 needs P, the number of the work offset".to_string();
            return self.missing_word(span, message, "P1 to P6 are G54 to G59");
        };
        self.write_work_values(block, &key, from_position);
    }

    fn write_extended(&mut self, block: &Block) {
        let Some(number) = self.count_of(block, b'P') else {
            let span = self.span(block.range);
            let message = "G10 L20 needs P, the number of the work offset".to_string();
            return self.missing_word(span, message, "write P and the number");
        };
        let key = self.state.offsets.key(WorkName::Extended(number as u16));
        self.write_work_values(block, &key, false);
    }

    fn write_work_values(&mut self, block: &Block, key: &str, from_position: bool) {
        let values = self.axis_words(block);
        let add = self.state.incremental && !from_position;
        let machine: Vec<f64> = (0..6).map(|axis| self.state.machine_position(axis)).collect();
        let work = self.state.offsets.work();
        self.state.shift_coordinates(|offsets| {
            for (axis, value) in values.iter().enumerate() {
                let Some(value) = *value else { continue };
                let stored = if from_position {
                    // So that the present place gets this coordinate.
                    let beyond_work = offsets.total()[axis] - work[axis];
                    machine[axis] - value - beyond_work
                } else {
                    value
                };
                offsets.write_work(key, axis, stored, add);
            }
        });
        self.emit_work_offset();
    }

    fn write_tool(&mut self, block: &Block, target: DataTarget) {
        let number = self.count_of(block, b'P');
        let register = self.radius_word(block);
        let value = register.and_then(|word| self.length(&word));
        let (Some(number), Some(value)) = (number, value) else {
            let span = self.span(block.range);
            let message = "G10 for a tool needs P, its number, and R, the value".to_string();
            return self.missing_word(span, message, "write P and R");
        };
        self.store_tool_value(target, number, value, self.state.incremental);
    }

    /// Writes a tool offset, mm.
    pub(super) fn store_tool_value(
        &mut self,
        target: DataTarget,
        number: u32,
        value: f64,
        add: bool,
    ) {
        let diameter = match self.control.parameters.radius_offsets {
            OffsetKind::Diameter => 1.0,
            OffsetKind::Radius => 2.0,
        };
        self.state.shift_coordinates(|offsets| {
            let tool = offsets.tool_mut(number);
            let (field, value) = match target {
                DataTarget::Length => (&mut tool.length_mm, value),
                DataTarget::LengthWear => (&mut tool.length_wear_mm, value),
                DataTarget::Radius => (&mut tool.diameter_mm, value * diameter),
                _ => (&mut tool.diameter_wear_mm, value * diameter),
            };
            *field = Some(if add { field.unwrap_or(0.0) + value } else { value });
        });
    }

    /// LinuxCNC G10 L1: Z is the length, R the radius.
    fn write_tool_table(&mut self, block: &Block) {
        let Some(number) = self.count_of(block, b'P') else { return };
        let length = self.length_of(block, b'Z');
        let radius = self.length_of(block, b'R');
        self.state.shift_coordinates(|offsets| {
            let tool = offsets.tool_mut(number);
            tool.length_mm = length.or(tool.length_mm);
            tool.diameter_mm = radius.map(|r| 2.0 * r).or(tool.diameter_mm);
        });
    }

    fn write_register(&mut self, block: &Block, index: u32) {
        let word = self.radius_word(block);
        if let Some(value) = word.and_then(|word| self.literal(&word)) {
            self.state.registers[(index % 10) as usize] = value;
        }
    }

    /// `R1+.01` stores a value; R0 with a move is also the radius.
    pub(super) fn take_registers(&mut self, block: &Block) {
        if !self.control.table.lexicon.registers || !block.letters().has(b'R') {
            return;
        }
        for word in block.words.iter() {
            if let Some(index) = word.register
                && !matches!(word.value, Value::Missing)
                && let Some(value) = self.literal(word)
            {
                self.state.registers[index as usize] = value;
            }
        }
    }

    pub(super) fn take_speed(&mut self, block: &Block) {
        let Some(word) = block.last(b'S').copied() else { return };
        let Some(number) = self.literal(&word) else { return };
        let rpm = number.to_f64();
        if rpm < 0.0 {
            self.report(
                Diagnostic::new(
                    Code::BadWordValue,
                    self.span(word.range),
                    format!("a spindle speed cannot be negative: S{number}"),
                )
                .help("M3 and M4 choose the direction"),
            );
            return;
        }
        if let Some(max) = self.machine.spindle_max_rpm
            && rpm > max
        {
            let max = trim(max, 0);
            self.report(
                Diagnostic::new(
                    Code::SpindleOverLimit,
                    self.span(word.range),
                    format!("S{number} is above the {max} rpm of this machine"),
                )
                .help(format!("program S{max} or less")),
            );
        }
        self.state.rpm = rpm;
        if self.state.spindle != SpindleState::Off {
            self.emit(CommandKind::Spindle { state: self.state.spindle, rpm });
        }
    }

    pub(super) fn set_spindle(&mut self, spindle: SpindleState) {
        let turning = matches!(self.state.spindle, SpindleState::Cw | SpindleState::Ccw);
        if spindle == SpindleState::Off && !turning {
            return;
        }
        self.state.spindle = spindle;
        let rpm = if spindle == SpindleState::Off { 0.0 } else { self.state.rpm };
        self.emit(CommandKind::Spindle { state: spindle, rpm });
    }

    pub(super) fn set_coolant(&mut self, change: impl FnOnce(&mut Coolant)) {
        let before = self.state.coolant;
        change(&mut self.state.coolant);
        if self.state.coolant != before {
            self.emit(CommandKind::Coolant(self.state.coolant));
        }
    }

    /// T.
    pub(super) fn take_tool_word(&mut self, block: &Block) {
        if let Some(number) = self.count_of(block, b'T') {
            self.state.selected_tool = Some(number);
            self.emit(CommandKind::ToolSelect { number });
        }
    }

    /// M6.
    pub(super) fn tool_change(&mut self, block: &Block, at: usize) {
        self.state.arc_over_rapid = false;
        let Some(number) = self.state.selected_tool else {
            let span = self.span(block.words[at].range);
            let message = "a tool change without a tool number".to_string();
            return self.missing_word(span, message, "write T and the tool's number before M6");
        };
        if self.state.side != Side::Off {
            let span = self.span(block.words[at].range);
            let code = Code::ToolChangeInCompensation;
            let refused = self.control.table.alarm(code).is_some();
            self.report(
                Diagnostic::new(code, span, "the tool is changed while cutter compensation is on")
                    .severity(if refused { Severity::Error } else { Severity::Warning })
                    .help("cancel compensation with G40 first"),
            );
        }
        self.end_cycle_if(self.control.parameters.cycles.cancel.by_tool_change);
        self.state.tool = number;
        if self.control.table.spindle_stops_at_tool_change {
            self.state.spindle = SpindleState::Off;
        }
        self.emit(CommandKind::Tool { number });
    }
}
