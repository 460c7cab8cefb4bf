//! Work offsets, tool length, compensation, G10, tools, spindle, coolant, registers.

use chordal_command::{CommandKind, CompensationSide, Units, WorkName};
use chordal_diagnostics::{Code, Diagnostic, Severity, Span};
use chordal_dialect::table::{DataTarget, MotionModality};
use chordal_dialect::{Action, ModeCode, MotionCode};
use chordal_dialect::{CodeGroup, ToolWord};
use chordal_kernel::LengthOffset;
use chordal_kernel::ModalMotion;
use chordal_kernel::ToolValue;
use chordal_kernel::rules::LeadLength;
use chordal_machine::{AXIS_LETTERS, Axis, PerAxis};
use chordal_syntax::{Block, Letters, WordValue};

use super::Interpreter;
use super::work_offsets::work_of_ordinal;
use chordal_command::telling_number;

/// How the words of G10 give the offsets of a tool.
#[derive(Clone, Copy, PartialEq, Eq)]
enum ToolFrom {
    /// The words are the offsets.
    Words,
    /// The present position gets these work coordinates.
    WorkPosition,
    /// The present position gets these coordinates of the ninth work offset, which belongs to the fixture.
    Fixture,
}

const Z: usize = Axis::Z as usize;

/// The last work offset of a control that selects them by E.
const MAX_BY_E: u32 = 48;

impl Interpreter<'_> {
    /// Carries out E, which selects a work offset.
    pub(super) fn take_e_word(&mut self, block: &Block) {
        let Some(number) = self.count_of(block, b'E') else { return };
        if number > MAX_BY_E {
            let span = self.words_span(block, Letters::of("E"));
            self.kernel.report(
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
            self.kernel.report(
                Diagnostic::new(Code::BadWordValue, span, "E may not be in a block with an arc")
                    .label("the work offset changes only with G0 or G1")
                    .help("put E into the block before"),
            );
        }
        let name = if number == 0 { WorkName::Machine } else { WorkName::E(number as u16) };
        self.kernel.select_work(name);
    }

    /// Reports H of another tool than the one in the spindle.
    pub(super) fn check_length_number(&mut self, block: &Block, number: u32) {
        let tool = self.kernel.state.tool;
        if tool == 0 || tool == number {
            return;
        }
        let severity = if self.control.parameters.length_must_match_tool {
            Severity::Error
        } else {
            Severity::Note
        };
        let span = self.words_span(block, Letters::of("H"));
        self.kernel.report(
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

    /// Carries out G40, G41 or G42.
    pub(super) fn set_compensation(&mut self, block: &Block, at: usize, side: CompensationSide) {
        let before = self.kernel.state.side;
        if side == CompensationSide::Off && before == CompensationSide::Off {
            return;
        }
        let span = self.span(block.words[at].range);
        self.check_compensation_move(block, side, span);
        let number = self.compensation_number(block);
        let unknown = self.kernel.state.unknown.radius_offset;
        let without = side != CompensationSide::Off && number.is_none() && !unknown;
        // On controls without an alarm for this, D0 is active from power-on.
        let refused = self.control.table.alarm(Code::CompensationWithoutOffset).is_some();
        if without {
            self.report_no_offset_number(span, refused);
        }
        if before == CompensationSide::Off {
            self.note_contour_of_call(block);
        }
        self.kernel.state.side = self.side_on_surface(side);
        if before == CompensationSide::Off {
            self.check_lead_in_words(block, span);
        }
        let toward = self.compensation_direction(block);
        if without && !refused {
            let (side, tip) = (self.kernel.state.side, [0.0; 2]);
            let (number, radius_mm) = (Some(0), Some(0.0));
            return self.kernel.emit(CommandKind::Compensation {
                side,
                number,
                radius_mm,
                toward,
                tip,
            });
        }
        self.kernel.emit_compensation(number, toward, span);
    }

    /// G41.1 and G42.1: D is the diameter of the tool; a negative one changes the side.
    pub(super) fn compensation_by_diameter(
        &mut self,
        block: &Block,
        at: usize,
        side: CompensationSide,
    ) {
        let span = self.span(block.words[at].range);
        let name = if side == CompensationSide::Left { "G41.1" } else { "G42.1" };
        let Some(diameter) = self.length_of(block, b'D') else {
            let diagnostic = Diagnostic::new(Code::MissingWord, span, format!("{name} without D"))
                .help("give the diameter of the tool with D");
            return self.report_refused(diagnostic, &format!("{name} with no D word"));
        };
        if block.letters().has(b'L') && self.kernel.state.plane != chordal_geometry::Plane::Zx {
            let span = self.words_span(block, Letters::of("L"));
            self.report_refused(
                Diagnostic::new(
                    Code::BadWordValue,
                    span,
                    "L, the tip of a turning tool, needs G18",
                )
                .help("remove L, or write G18 before"),
                &format!("{name} with L word, but plane is not G18"),
            );
        }
        let side = side.mirrored_if(diameter < 0.0);
        self.check_compensation_move(block, side, span);
        if self.kernel.state.side == CompensationSide::Off {
            self.note_contour_of_call(block);
        }
        self.kernel.state.side = side;
        let radius_mm = Some(diameter.abs() / 2.0);
        let (number, toward) = (None, None);
        let tip = if block.letters().has(b'L') { self.count_of(block, b'L') } else { None };
        let tip = self.kernel.direction_of_tip(tip);
        self.kernel.emit(CommandKind::Compensation { side, number, radius_mm, toward, tip });
    }

    /// G43.2: adds the offsets of tool H to the active ones.
    pub(super) fn add_tool_offsets(&mut self, block: &Block) {
        if !block.letters().has(b'H') && block.letters().meets(Letters::of(AXIS_LETTERS)) {
            let values = self.axis_words(block);
            return self.kernel.set_tool_offsets(&values, true);
        }
        let Some(number) = self.count_of(block, b'H') else {
            let span = self.span(block.range);
            let diagnostic =
                Diagnostic::new(Code::MissingWord, span, "G43.2 without H and without axis words")
                    .help(
                        "give the number of the tool with H, or the lengths to add with X, Y and Z",
                    );
            let alarm = "G43.2: No axes specified and H word missing";
            return self.report_refused(diagnostic, alarm);
        };
        let offsets = &self.kernel.state.offsets;
        let tool = offsets.tool(number);
        let values: PerAxis<Option<f64>> =
            std::array::from_fn(|axis| tool.and_then(|tool| tool.offset_of(axis)));
        if values[Z].is_none() {
            // The sum is unknown like the added value.
            let length = LengthOffset { number: Some(number), minus: false };
            return self.kernel.set_length(&self.at(block), length);
        }
        self.kernel.set_tool_offsets(&values, true);
    }

    /// Reports a block that starts compensation and moves only the third axis, on a control that needs a lead-in.
    fn check_lead_in_words(&mut self, block: &Block, span: Span) {
        let rules = &self.control.parameters.rules.compensation;
        let (a, b, normal) = self.kernel.state.plane.axes();
        let [a, b, normal] = [a, b, normal].map(|axis| b"XYZ"[axis]);
        let letters = block.letters();
        let alone = letters.has(normal) && !letters.has(a) && !letters.has(b);
        let wants = rules.lead == LeadLength::AboveOffset && !rules.lead_follows_code;
        if !alone || !wants || self.moves_on_arc(block) {
            return;
        }
        let [a, b, normal] = [a, b, normal].map(char::from);
        self.kernel.report(
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

    /// D while compensation is on: changes the offset with this block.
    pub(super) fn change_compensation_offset(&mut self, block: &Block) {
        let number = self.compensation_number(block);
        let span = self.words_span(block, Letters::of("D"));
        self.kernel.emit_compensation(number, None, span);
    }

    /// I J K in the block of G40, G41 or G42, on the axes of the plane; `None` without them.
    fn compensation_direction(&mut self, block: &Block) -> Option<[f64; 2]> {
        if !self.control.parameters.rules.compensation.off_toward
            || !block.letters().meets(Letters::of("IJK"))
            || self.moves_on_arc(block)
        {
            return None;
        }
        let (first, second, _) = self.kernel.state.plane.axes();
        let along = |s: &mut Self, axis: usize| s.length_of(block, b"IJK"[axis]).unwrap_or(0.0);
        Some([along(self, first), along(self, second)])
    }

    /// G39: the direction of the next move, by I J K, or by axis words that then do not move.
    pub(super) fn corner_arc(&mut self, block: &Block, own_block: bool) {
        if self.kernel.state.side == CompensationSide::Off {
            if own_block {
                self.unused_axes(block, |_, _| false);
            }
            return;
        }
        let (first, second, _) = self.kernel.state.plane.axes();
        let letters = block.letters();
        if own_block {
            let by_vector = letters.meets(Letters::of("IJK"));
            self.unused_axes(block, |axis, _| !by_vector && (axis == first || axis == second));
        }
        let toward = if letters.meets(Letters::of("IJK")) && own_block {
            let along = |s: &mut Self, axis: usize| s.length_of(block, b"IJK"[axis]).unwrap_or(0.0);
            Some([along(self, first), along(self, second)])
        } else if own_block && letters.meets(Letters::of("XYZ")) {
            let (target, _) = self.target(block);
            let from = self.kernel.state.position;
            Some([target[first] - from[first], target[second] - from[second]])
        } else {
            None
        };
        self.kernel.emit(CommandKind::CornerArc { toward });
    }

    /// The number of the active offset, or of the tool in the spindle; `None` for neither.
    fn compensation_number(&mut self, block: &Block) -> Option<u32> {
        if self.control.parameters.rules.compensation.offset_of_tool {
            let d = if block.letters().has(b'D') { self.count_of(block, b'D') } else { None };
            return d.filter(|number| *number > 0).or(Some(self.kernel.state.tool));
        }
        self.active_radius_offset()
    }

    /// The number of the active radius offset: D, or H on controls where H includes the diameter.
    pub(super) fn active_radius_offset(&self) -> Option<u32> {
        let by_h = self.control.parameters.length_by_h_alone;
        self.kernel.state.radius_offset.or(self
            .kernel
            .state
            .offsets
            .length()
            .number
            .filter(|_| by_h))
    }

    /// Reports that compensation starts or ends on an arc.
    fn check_compensation_move(&mut self, block: &Block, side: CompensationSide, span: Span) {
        // A change of side is not a start.
        let on = self.kernel.state.side != CompensationSide::Off;
        let may_start = on || self.control.parameters.rules.compensation.start_on_arc;
        if (side != CompensationSide::Off && may_start) || !self.moves_on_arc(block) {
            return;
        }
        let what = if side == CompensationSide::Off { "ends" } else { "starts" };
        self.kernel.report(
            Diagnostic::new(
                Code::CompensationOnArc,
                span,
                format!("cutter compensation {what} on an arc"),
            )
            .label("this block is an arc")
            .help(if side == CompensationSide::Off {
                "put G40 on a straight move away from the contour"
            } else {
                "put G41 or G42 on a straight move to the contour"
            }),
        );
    }

    /// True when the motion of this block is an arc, by its own code or the active one.
    pub(super) fn moves_on_arc(&self, block: &Block) -> bool {
        let arc_words = self.has_arc_words(block);
        if self.control.table.motion == MotionModality::Armed {
            return arc_words;
        }
        let moves = arc_words || block.letters().meets(Letters::of("XYZ"));
        let own = block.all(b'G').filter_map(|word| {
            let row = self.control.g_code(chordal_dialect::code_number(word.number()?)?)?;
            (row.group == CodeGroup::Motion).then_some(row.action)
        });
        moves
            && match own.last() {
                Some(action) => !matches!(
                    action,
                    Action::Motion(MotionCode::Rapid) | Action::Motion(MotionCode::Linear)
                ),
                None => {
                    !matches!(self.kernel.state.motion, ModalMotion::Rapid | ModalMotion::Linear)
                }
            }
    }

    /// Carries out G10.
    pub(super) fn set_data(&mut self, block: &Block, at: usize) {
        let l = self.count_of(block, b'L');
        let target = l.and_then(|l| {
            let rows = self.control.table.set_data;
            rows.iter().find(|(number, _)| u32::from(*number) == l).map(|(_, target)| *target)
        });
        let stations = self.control.parameters.tool_word != ToolWord::Tool;
        if l.is_none() && stations {
            return self.write_turning_tool(block, None);
        }
        let span = self.span(block.words[at].range);
        match target {
            Some(DataTarget::WorkOffset) => self.write_work_offset(block, false),
            Some(DataTarget::WorkOffsetFromPosition) => self.write_work_offset(block, true),
            Some(DataTarget::ExtendedWorkOffset) => self.write_extended(block),
            Some(DataTarget::Register) => self.write_register(block, l.unwrap_or(100) - 100),
            // Written values are active at once, so there is nothing to reload.
            Some(DataTarget::Reload) => {}
            Some(DataTarget::ToolTable) => self.write_tool_table(block, ToolFrom::Words),
            Some(DataTarget::TurningTool { wear }) => self.write_turning_tool(block, Some(wear)),
            Some(DataTarget::ToolFromPosition) => {
                self.write_tool_table(block, ToolFrom::WorkPosition);
            }
            Some(DataTarget::ToolFromFixture) => {
                self.write_tool_table(block, ToolFrom::Fixture);
            }
            Some(DataTarget::Tool(value)) => self.write_tool(block, value),
            Some(DataTarget::Other) => {
                self.emit_data(block);
                self.kernel.report(Diagnostic::new(
                    Code::NotSimulated,
                    span,
                    format!("G10 L{} is not simulated", l.unwrap_or(0)),
                ));
            }
            Some(DataTarget::IntoRegister) => {
                let l = l.unwrap_or(0);
                let message =
                    format!("G10 L{l} reads a value of the control into R, which is not followed");
                self.lose_path(block.words[at].range, message);
            }
            Some(DataTarget::Lines) => {
                self.emit_data(block);
                self.begin_data_lines(span, l.unwrap_or(0));
            }
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
                self.kernel.report(Diagnostic::new(Code::BadWordValue, span, message).help(help));
            }
        }
    }

    /// G10 L50: the lines up to G11 are parameter data.
    fn begin_data_lines(&mut self, span: Span, l: u32) {
        self.data_lines = true;
        let end = self.code_that(Action::Mode(ModeCode::DataLinesOff));
        self.kernel.report(
            Diagnostic::new(
                Code::NotSimulated,
                span,
                format!("G10 L{l} writes parameters of the control, which is not simulated"),
            )
            .label(format!("the lines up to {end} are data, no motion"))
            .help("say what the machine does otherwise with `[settings]` of the machine file"),
        );
    }

    /// True when a block after G10 L50 is data. A block with a code is not: it ends the data, even without G11.
    pub(super) fn is_data_line(&mut self, block: &Block) -> bool {
        let word = block.words.iter().find(|word| matches!(word.letter, b'G' | b'M'));
        let Some(word) = word else {
            self.emit_data(block);
            return true;
        };
        self.data_lines = false;
        let row = word.number().and_then(chordal_dialect::code_number);
        let row = row.and_then(|code| self.control.g_code(code));
        let off = Action::Mode(ModeCode::DataLinesOff);
        if word.letter != b'G' || row.is_none_or(|row| row.action != off) {
            let end = self.code_that(off);
            self.kernel.report(
                Diagnostic::new(
                    Code::MissingWord,
                    self.span(word.range),
                    format!("this block stands among the data of G10, which no {end} ended"),
                )
                .label("carried out as a block")
                .help(format!("write {end} after the last line of data")),
            );
        }
        false
    }

    /// The name of the G code with an action; empty when there is none.
    fn code_that(&self, action: Action) -> String {
        let row = self.control.table.g_codes.iter().find(|row| row.action == action);
        row.map_or_else(String::new, |row| row.name(b'G'))
    }

    /// The key of the work offset P of G10 L2; `None` when there is none.
    fn work_key(&mut self, block: &Block) -> Option<String> {
        let (table, parameters) = (self.control.table, &self.control.parameters);
        let number = match block.last(b'P') {
            None if parameters.offset_number_optional => 0,
            _ => self.count_of(block, b'P')?,
        };
        let name = match number {
            n if table.work_names.by_e => return (n <= MAX_BY_E).then(|| format!("E{n}")),
            n if table.work_names.first > 1 => work_of_ordinal(n)?,
            0 if parameters.offset_zero_in_force => self.kernel.state.offsets.active(),
            0 => return Some("EXT".into()),
            n @ 1..=6 => WorkName::G(n as u16 + 53),
            n @ 7..=9 if table.work_names.extended == "G59" => WorkName::G59(n as u16 - 6),
            _ => return None,
        };
        Some(self.kernel.state.offsets.key(name))
    }

    fn write_work_offset(&mut self, block: &Block, from_position: bool) {
        let Some(key) = self.work_key(block) else {
            let span = self.words_span(block, Letters::of("P"));
            if let Some(word) = block.last(b'P') {
                let text = String::from_utf8_lossy(word.range.slice(self.reader.text()));
                let message = format!("there is no work offset {text} for G10 L2");
                return self.kernel.report(Diagnostic::new(Code::BadWordValue, span, message));
            }
            let message = "G10 L2 needs P, the number of the work offset".to_string();
            return self.kernel.missing_word(span, message, "P1 to P6 are G54 to G59");
        };
        let values = self.axis_words(block);
        if !from_position {
            self.check_added_values(block, &key, &values);
        }
        let offsets = &self.kernel.state.offsets;
        if key == offsets.key(offsets.active()) {
            self.take_written_offsets();
        }
        if self.control.parameters.rules.frames.work_rotation && block.letters().has(b'R') {
            if from_position {
                return self.report_rotation_from_position(block);
            }
            if let Some(degrees) = self.angle_of(block, b'R') {
                self.kernel.write_work_rotation(&key, degrees);
            }
        }
        self.kernel.write_work_values(&key, &values, from_position);
    }

    fn report_rotation_from_position(&mut self, block: &Block) {
        let span = self.words_span(block, Letters::of("R"));
        let message = "R does not go with G10 L20: a rotation cannot be computed from the position";
        self.report_refused(
            Diagnostic::new(Code::BadWordValue, span, message)
                .label("nothing is written")
                .help("write the rotation with G10 L2 P R"),
            "R not allowed in G10 L20",
        );
    }

    fn write_extended(&mut self, block: &Block) {
        let Some(number) = self.count_of(block, b'P') else {
            let span = self.span(block.range);
            let message = "G10 L20 needs P, the number of the work offset".to_string();
            return self.kernel.missing_word(span, message, "write P and the number");
        };
        let key = self.kernel.state.offsets.key(WorkName::Extended(number as u16));
        let values = self.axis_words(block);
        self.check_added_values(block, &key, &values);
        self.kernel.write_work_values(&key, &values, false);
    }

    fn write_tool(&mut self, block: &Block, of: ToolValue) {
        let number = self.count_of(block, b'P');
        let register = self.radius_word(block);
        let value = register.and_then(|word| self.length(&word));
        let (Some(number), Some(value)) = (number, value) else {
            let span = self.span(block.range);
            let message = "G10 for a tool needs P, its number, and R, the value".to_string();
            return self.kernel.missing_word(span, message, "write P and R");
        };
        self.kernel.store_tool_value(of, number, value, self.kernel.state.incremental);
    }

    /// LinuxCNC G10 L1, L10 and L11: the axis words are the offsets of the tool, or the coordinates that the present
    /// position gets with them; R is the radius.
    fn write_tool_table(&mut self, block: &Block, from: ToolFrom) {
        let Some(number) = self.count_of(block, b'P') else { return };
        let mut words = self.axis_words(block);
        let state = &self.kernel.state;
        let offsets = &state.offsets;
        let fixture = offsets.key(WorkName::G59(3));
        for (axis, word) in words.iter_mut().enumerate() {
            let Some(value) = *word else { continue };
            let machine = state.machine_position(axis);
            *word = Some(match from {
                ToolFrom::Words => value,
                ToolFrom::WorkPosition => machine - offsets.work()[axis] - value,
                ToolFrom::Fixture => {
                    machine - offsets.work_value(&fixture, axis).unwrap_or(0.0) - value
                }
            });
        }
        let radius = self.length_of(block, b'R');
        let tip = if block.letters().has(b'Q') { self.count_of(block, b'Q') } else { None };
        self.kernel.state.shift_coordinates(|offsets| {
            let tool = offsets.tool_mut(number);
            tool.tip = tip.or(tool.tip);
            for (offset, word) in tool.offset.iter_mut().zip(words) {
                *offset = word.or(*offset);
            }
            tool.diameter_mm = radius.map(|r| 2.0 * r).or(tool.diameter_mm);
        });
    }

    fn write_register(&mut self, block: &Block, index: u32) {
        let word = self.radius_word(block);
        if let Some(value) = word.and_then(|word| self.literal(&word)) {
            self.registers[(index % 10) as usize] = Some(value);
        }
    }

    /// `R1+.01` stores a value; R0 with a move is also the radius.
    pub(super) fn take_registers(&mut self, block: &Block) {
        if !self.control.table.lexicon.registers || !block.letters().has(b'R') {
            return;
        }
        for word in block.words.iter() {
            if let Some(index) = word.register
                && !matches!(word.value, WordValue::Missing)
                && let Some(value) = self.literal(word)
            {
                self.registers[index as usize] = Some(value);
            }
        }
    }

    pub(super) fn take_speed(&mut self, block: &Block) {
        let Some(word) = block.last(b'S').copied() else { return };
        let Some(number) = self.literal(&word) else { return };
        let rpm = number.to_f64();
        if self.kernel.state.surface_speed.is_some() && rpm >= 0.0 {
            // Metres or feet per minute.
            let unit_mm = match self.kernel.state.units {
                Units::Inch => 304.8,
                Units::Millimetre => 1000.0,
            };
            return self.kernel.set_surface_speed(rpm * unit_mm / 60.0);
        }
        if rpm < 0.0 {
            self.kernel.report(
                Diagnostic::new(
                    Code::BadWordValue,
                    self.span(word.range),
                    format!("a spindle speed cannot be negative: S{number}"),
                )
                .help("M3 and M4 choose the direction"),
            );
            return;
        }
        let most = match self.names_live_tool(block) {
            true => self.machine.live_tool_max_rpm,
            false => self.machine.spindle_max_rpm,
        };
        if let Some(max) = most
            && rpm > max
        {
            let max = telling_number(max, 0);
            self.kernel.report(
                Diagnostic::new(
                    Code::SpindleOverLimit,
                    self.span(word.range),
                    format!("S{number} is above the {max} rpm of this machine"),
                )
                .help(format!("program S{max} or less")),
            );
        }
        self.kernel.set_speed(rpm);
    }

    /// The power of the spindle in percent: as percent of the largest speed in the machine file, if given.
    pub(super) fn take_power(&mut self, block: &Block, letter: u8) {
        let Some(word) = block.last(letter).copied() else { return };
        let Some(number) = self.literal(&word) else { return };
        let percent = number.to_f64();
        if !(0.0..=100.0).contains(&percent) {
            self.kernel.report(
                Diagnostic::new(
                    Code::BadWordValue,
                    self.span(word.range),
                    format!("a power of {number} percent"),
                )
                .help("write 0 to 100"),
            );
        }
        let percent = percent.clamp(0.0, 100.0);
        self.kernel
            .set_speed(self.machine.spindle_max_rpm.map_or(percent, |max| max * percent / 100.0));
    }

    /// Carries out T.
    pub(super) fn take_tool_word(&mut self, block: &Block) {
        if let ToolWord::StationAndOffset { digits } = self.control.parameters.tool_word {
            return self.take_station(block, digits);
        }
        let largest = self.control.parameters.largest_numbers.tool;
        if let Some(number) = self.count_up_to(block, b'T', largest) {
            self.kernel.select_tool(number);
        }
    }

    /// Carries out M6.
    pub(super) fn tool_change(&mut self, block: &Block, at: usize) {
        self.kernel.tool_change(self.span(block.words[at].range));
    }
}
