//! Non-modal codes that use the axis words: dwell, reference points, machine coordinates, presets and shifts.

use chordal_command::{AxisMask, CommandKind, CompensationSide};
use chordal_diagnostics::{Code, Diagnostic, Severity};
use chordal_dialect::{Action, CodeGroup, CodeRow, OnceCode};
use chordal_geometry::TurnDirection;
use chordal_kernel::ModalMotion;
use chordal_kernel::rules::{AllowanceRule, TurnCycle};
use chordal_machine::{AXES, PerAxis};
use chordal_syntax::{Block, Decimal, Word};

use super::Interpreter;
use super::literals::{AXIS_OF, trim};

impl Interpreter<'_> {
    /// Makes a code modal if the table lists it as a motion code: the next block with axis words repeats it.
    fn make_modal(&mut self, code: OnceCode, motion: ModalMotion) {
        let rows = self.control.table.g_codes;
        let is = |row: &CodeRow| row.action == Action::Once(code) && row.group == CodeGroup::Motion;
        if rows.iter().any(is) {
            self.kernel.end_cycle_if(true);
            self.kernel.state.motion = motion;
        }
    }

    pub(super) fn one_shot(&mut self, block: &Block, code: OnceCode, at: usize) {
        let to_machine = matches!(
            code,
            OnceCode::ReturnToReference { .. }
                | OnceCode::ReturnFromReference
                | OnceCode::Home
                | OnceCode::MachineCoordinates
        );
        if to_machine && self.kernel.state.side != CompensationSide::Off {
            self.reference_in_compensation(block, at);
        }
        if code.works_with_places() {
            let name = self.code_text(block, at);
            self.kernel.warn_of_frames(self.span(block.words[at].range), &name);
            self.kernel.forget_jump();
        }
        match code {
            OnceCode::Dwell => self.dwell(block, at),
            OnceCode::SetData => self.set_data(block, at),
            OnceCode::ReturnToReference { second } => {
                self.kernel.end_cycle_if(self.control.parameters.rules.cycles.cancel.by_reference);
                self.return_to_reference(block, second);
            }
            OnceCode::ReturnFromReference => {
                self.kernel.end_cycle_if(self.control.parameters.rules.cycles.cancel.by_reference);
                self.return_from_reference(block);
            }
            OnceCode::Home => self.home(block),
            OnceCode::Pattern(pattern) => self.pattern(block, at, pattern),
            OnceCode::Probe { must_hit } => {
                self.make_modal(code, ModalMotion::Probe { must_hit });
                self.probe_move(block, at, must_hit);
            }
            OnceCode::LocalShift | OnceCode::PresetPosition if self.lacks_axes(block) => {
                let span = self.span(block.words[at].range);
                self.report_refused(
                    Diagnostic::new(Code::MissingWord, span, "this code needs an axis word")
                        .help("write the axes and their values"),
                    "All axes missing with g52 or g92",
                );
            }
            OnceCode::MachineCoordinates if !self.may_use_machine_coordinates() => {
                let span = self.span(block.words[at].range);
                self.report_refused(
                    Diagnostic::new(Code::NoMotionInForce, span, "G53 needs G0 or G1")
                        .help("write G0 or G1 into this block"),
                    "Must use g0 or g1 with g53",
                );
                self.machine_coordinates(block, at);
            }
            OnceCode::MachineCoordinates => {
                if self.control.parameters.strict_words && self.kernel.state.incremental {
                    let span = self.span(block.words[at].range);
                    self.report_refused(
                        Diagnostic::new(Code::BadWordValue, span, "G53 in G91")
                            .label("shown as an absolute move")
                            .help("write G90 before it: machine coordinates are absolute"),
                        "Cannot use g53 incremental",
                    );
                }
                self.machine_coordinates(block, at);
            }
            OnceCode::LocalShift => {
                let values = self.axis_words(block);
                self.kernel.local_shift(&values);
            }
            OnceCode::PresetPosition => {
                let values = self.preset_words(block);
                if self.control.parameters.preset_writes_system {
                    return self.write_active_system(&values, true);
                }
                if values.iter().all(Option::is_none) && self.control.parameters.preset_limits_speed
                {
                    return;
                }
                self.kernel.preset_position(&values);
            }
            OnceCode::ClearPreset { .. } if self.control.parameters.preset_writes_system => {
                self.write_active_system(&[Some(0.0); AXES], false);
            }
            OnceCode::ClearPreset { keep } => self.kernel.clear_preset(keep),
            OnceCode::RestorePreset => {
                self.kernel.restore_preset();
            }
            OnceCode::Rotation => self.rotation(block, at),
            OnceCode::Scaling => self.scaling(block, at),
            OnceCode::Mirror { at_zero } => self.mirror(block, at, at_zero),
            OnceCode::MirrorOff => self.mirror_off(block),
            OnceCode::CircularPocketCw => self.circular_pocket(block, at, TurnDirection::Cw),
            OnceCode::CircularPocketCcw => self.circular_pocket(block, at, TurnDirection::Ccw),
            OnceCode::GeneralPocket => self.general_pocket(block, at),
            OnceCode::CornerArcBlock => self.corner_arc(block, true),
            OnceCode::Turning(cycle) => {
                if cycle == TurnCycle::LineThread {
                    self.make_modal(code, ModalMotion::ThreadPasses);
                }
                self.turning_cycle(block, at, cycle);
            }
            OnceCode::Surface(code) => self.surface_code(block, at, code),
            OnceCode::TiltedPlane(code) => self.tilted_plane(block, at, code),
            OnceCode::Engraving => self.engrave(block, at),
        }
    }

    /// True for a code without axis words, on controls where that stops the program.
    fn lacks_axes(&mut self, block: &Block) -> bool {
        self.control.parameters.strict_words && self.axis_words(block).iter().all(Option::is_none)
    }

    fn may_use_machine_coordinates(&self) -> bool {
        !self.control.parameters.strict_words
            || matches!(self.kernel.state.motion, ModalMotion::Rapid | ModalMotion::Linear)
                && self.kernel.state.cycle.is_none()
    }

    /// Reports an error with the alarm text of this case.
    pub(super) fn report_refused(&mut self, diagnostic: Diagnostic, alarm: &str) {
        let title = self.control.table.title;
        let diagnostic = diagnostic.severity(Severity::Error).alarm(format!("{title}: {alarm}"));
        self.kernel.report(diagnostic);
    }

    fn dwell(&mut self, block: &Block, at: usize) {
        let mut words = self.control.dwell_words();
        let found = words.find_map(|rule| block.last(rule.letter).map(|word| (rule, *word)));
        if !self.control.parameters.dwell_with_motion {
            let time = found.map(|(rule, _)| rule.letter);
            self.unused_axes(block, |_, letter| Some(letter) == time);
        }
        let Some((rule, word)) = found else {
            if self.control.table.dwell_alone_stops {
                // An exact stop: the axes stop, without a dwell.
                return self.kernel.emit(CommandKind::Dwell { seconds: 0.0, label: None });
            }
            let span = self.span(block.words[at].range);
            let letters: Vec<String> =
                self.control.dwell_words().map(|rule| (rule.letter as char).to_string()).collect();
            let help = format!("give the time with {}", letters.join(", "));
            return self.kernel.missing_word(span, "a dwell without a time".into(), &help);
        };
        let Some(number) = self.literal(&word) else { return };
        let seconds = number.to_f64() * rule.unit_s(number.has_point);
        if number.has_point && !rule.takes_point {
            self.report_point_of_dwell(&word, number, seconds);
        }
        if seconds < 0.0 {
            self.kernel.report(
                Diagnostic::new(
                    Code::BadWordValue,
                    self.span(word.range),
                    format!("a dwell cannot be negative: {}{number}", word.letter as char),
                )
                .help("remove the sign"),
            );
            return;
        }
        self.kernel.emit(CommandKind::Dwell { seconds, label: None });
    }

    fn report_point_of_dwell(&mut self, word: &Word, number: Decimal, seconds: f64) {
        let letter = word.letter as char;
        let others = self.control.dwell_words().filter(|rule| rule.takes_point);
        let others: Vec<String> =
            others.map(|rule| format!("{}{number}", rule.letter as char)).collect();
        self.kernel.report(
            Diagnostic::new(
                Code::BadNumber,
                self.span(word.range),
                format!("`{letter}{number}` of a dwell has a decimal point, which {letter} must not have"),
            )
            .label(format!("read as {} s", trim(seconds, 3)))
            .help(format!(
                "write {letter} without a point, in milliseconds, or {} for seconds",
                others.join(" or ")
            )),
        );
    }

    /// Reports G28, G29, G30 and G53 while the tool is offset from the contour.
    fn reference_in_compensation(&mut self, block: &Block, at: usize) {
        let refused =
            self.control.parameters.rules.compensation.coordinate_change == AllowanceRule::Refused;
        let (first, second, _) = self.kernel.state.plane.axes();
        let named = self.axis_words(block);
        if !refused && named[first].is_none() && named[second].is_none() {
            return;
        }
        let span = self.span(block.words[at].range);
        let message = "a move to a machine point while cutter compensation is on";
        let diagnostic = Diagnostic::new(Code::ReferenceInCompensation, span, message)
            .severity(if refused { Severity::Error } else { Severity::Warning })
            .help("cancel compensation with G40 first");
        self.kernel.report(diagnostic);
    }

    /// G28 and G30: moves through the point given by the words, then to the reference point with the named axes.
    fn return_to_reference(&mut self, block: &Block, second: bool) {
        let (target, mut named) = self.target(block);
        // An axis that the machine does not have also counts as named.
        let names_none = !block.words.iter().any(|word| {
            AXIS_OF[usize::from(word.letter)] < 6 || self.increment_axis(word).is_some()
        });
        let number = if second { self.count_of(block, b'P').unwrap_or(2).clamp(2, 4) } else { 1 };
        let place = self.reference(number);
        if named == AxisMask::NONE {
            if !names_none {
                return;
            }
            if !self.control.parameters.rules.bare_home_moves_all {
                let span = self.span(block.range);
                return self.kernel.missing_word(
                    span,
                    "a return to the reference point without an axis".into(),
                    "give the axes that return, such as `G91 G28 Z0`",
                );
            }
            named = self.control.axes();
            return self.kernel.go_to_reference(named, &place);
        }
        self.kernel.return_over(target, named, &place);
    }

    /// Writes the active work coordinate system: the values, or (`from_position`) so that the position gets them.
    fn write_active_system(&mut self, values: &PerAxis<Option<f64>>, from_position: bool) {
        let offsets = &self.kernel.state.offsets;
        let key = offsets.key(offsets.active());
        let axes = self.control.axes();
        let values = std::array::from_fn(|axis| values[axis].filter(|_| axes.has(axis)));
        self.kernel.write_work_values(&key, &values, from_position);
    }

    /// Homes the named axes, or all; then their coordinates equal machine coordinates.
    fn home(&mut self, block: &Block) {
        let mut named = AxisMask::NONE;
        for word in &block.words {
            let axis = AXIS_OF[word.letter as usize] as usize;
            if axis < AXES {
                named.insert(axis);
            }
        }
        let named = named.and(self.control.axes());
        let named = if named == AxisMask::NONE { self.control.axes() } else { named };
        if self.kernel.state.offsets.active() != super::NATIVE {
            let message = "homing while a work coordinate system is active: whether its offset still acts on these axes \
                           depends on the version of the firmware";
            self.lose_path(block.range, message.to_string());
        } else {
            let values = std::array::from_fn(|axis| named.has(axis).then_some(0.0));
            self.write_active_system(&values, false);
        }
        self.kernel.go_to_reference(named, &self.reference(1));
    }

    /// A reference point by its number, machine coordinates, mm and rad: as stored by the program, else by the machine
    /// file.
    pub(super) fn reference(&self, number: u32) -> PerAxis<Option<f64>> {
        let (of_machine, stored) = match number {
            ..=1 => (self.machine.home, Some(0)),
            2 => (self.machine.reference_points[0], Some(1)),
            _ => (self.machine.reference_points[(number.min(4) - 2) as usize], None),
        };
        let stored = stored.map_or([None; AXES], |at: usize| self.references[at]);
        std::array::from_fn(|axis| stored[axis].or(of_machine[axis]))
    }

    /// The stored reference point (1 or 2) of an axis, mm or rad (LinuxCNC #5161 to #5186); `None` when not stored.
    pub(super) fn stored_reference(&self, number: usize, axis: usize) -> Option<f64> {
        self.references[number - 1][axis]
    }

    /// G28.1 and G30.1: stores the present position.
    pub(super) fn store_reference(&mut self, second: bool) {
        let state = &self.kernel.state;
        let place = std::array::from_fn(|axis| Some(state.machine_position(axis)));
        self.references[usize::from(second)] = place;
        self.emit_references();
    }

    /// G29: moves to its end point; the intermediate point of the last G28 is not remembered.
    fn return_from_reference(&mut self, block: &Block) {
        let (target, named) = self.target(block);
        if named != AxisMask::NONE {
            self.kernel.rapid(target, named);
        }
    }

    /// G53: moves to machine coordinates given by the words.
    fn machine_coordinates(&mut self, block: &Block, at: usize) {
        let mut place = [0.0; AXES];
        let mut named = AxisMask::NONE;
        for word in &block.words {
            let axis = AXIS_OF[word.letter as usize] as usize;
            if axis < 6
                && !word.comma
                && let Some(value) = self.axis_value(word, axis)
            {
                place[axis] = value;
                named.insert(axis);
            }
        }
        let axes = self.control.axes();
        for word in &block.words {
            let axis = AXIS_OF[usize::from(word.letter)] as usize;
            let absent = axis < AXES && !word.comma && !axes.has(axis);
            if absent && !self.is_axis_of_second_spindle(char::from(word.letter), word.range) {
                self.unused_word(word);
            }
        }
        let named = named.and(axes);
        if named == AxisMask::NONE {
            if self.control.parameters.preset_writes_system {
                self.select_work(super::NATIVE);
            }
            return;
        }
        if self.control.parameters.rules.machine_move_needs_absolute
            && self.kernel.state.incremental
        {
            return self.report_ignored_machine_move(block, at);
        }
        self.kernel.to_machine_point(&self.at(block), place, named);
    }

    fn report_ignored_machine_move(&mut self, block: &Block, at: usize) {
        let word = block.words[at];
        let name = self.code_text(block, at);
        let title = self.control.table.title;
        self.kernel.report(
            Diagnostic::new(
                Code::UnusedWord,
                self.span(word.range),
                format!("{title} ignores {name} in G91: this block does not move"),
            )
            .label("machine coordinates are absolute")
            .help(format!("write `G90 {name}`, and G91 again after it where it is needed")),
        );
    }

    /// Reports the axis words of a block that its code does not use, by axis and letter.
    pub(super) fn unused_axes(&mut self, block: &Block, used: impl Fn(usize, u8) -> bool) {
        for word in &block.words {
            let axis = AXIS_OF[word.letter as usize] as usize;
            if axis < AXES && !word.comma && !used(axis, word.letter) {
                self.unused_word(word);
            }
        }
    }

    /// The coordinates that the present position gets by a preset; an incremental letter changes them by its value.
    fn preset_words(&mut self, block: &Block) -> PerAxis<Option<f64>> {
        let mut values = self.axis_words(block);
        for (letter, axis) in self.control.parameters.increments {
            let axis = AXIS_OF[usize::from(*axis)] as usize;
            if let Some(word) = block.last(*letter).copied()
                && let Some(by) = self.axis_value(&word, axis)
            {
                values[axis] = Some(self.kernel.state.position[axis] + by);
            }
        }
        values
    }

    /// The values of the axis words of a block, mm and rad, regardless of G90 and G91.
    pub(super) fn axis_words(&mut self, block: &Block) -> PerAxis<Option<f64>> {
        let mut values = [None; AXES];
        for word in &block.words {
            let axis = AXIS_OF[word.letter as usize] as usize;
            if axis < 6 && !word.comma {
                values[axis] = self.axis_value(word, axis);
            }
        }
        values
    }
}
