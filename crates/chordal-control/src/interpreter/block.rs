//! One block: its codes are gathered, judged, and taken in the order a control takes them.

use chordal_diagnostics::{Code, Diagnostic, Severity};
use chordal_geometry::Plane;
use chordal_syntax::{Block, Letters};

use super::report::code_number;
use super::{EndReason, Flow, Interpreter};
use crate::command::{AxisMask, CommandKind, FeedMode, Sink, SpindleState, Units, WorkName};
use crate::offsets::LengthOffset;
use crate::parameters::{ArcCenter, PlaneCodes, SpiralForm, UnitCodes};
use crate::state::{Motion, Scale};
use crate::table::{Action, CodeRow, Group, LineRepeat, MotionModality, Subroutines};

/// Letters of a block that only moves: no mode, no table, no call.
const PLAIN: Letters = Letters::of("NXYZABCFIJKG");

/// The fixed subroutine that drills a bolt circle (Fadal L93NN).
const BOLT_CIRCLE: u32 = 93;

/// Letters that every block may have.
const ALWAYS: Letters = Letters::of("NOGMFSTHDXYZABC");

impl<S: Sink> Interpreter<'_, S> {
    /// Carries out the words of a block.
    pub(super) fn carry_out(&mut self, block: &Block) -> Flow {
        if self.plain_motion(block) {
            return Flow::Next;
        }
        if let Some(flow) = self.macro_call(block) {
            return flow;
        }
        let active = self.macros.active;
        let mut codes = std::mem::take(&mut self.codes);
        self.gather(block, &mut codes);
        let flow = self.carry_out_codes(block, &codes);
        codes.clear();
        self.codes = codes;
        // The block that begins it does not call.
        if active > 0 && self.macros.active > 0 { self.modal_call_after(block, flow) } else { flow }
    }

    /// Blocks that hold nothing but a move, which is most of them. False, and nothing done,
    /// when there is more in the block than that.
    #[inline]
    fn plain_motion(&mut self, block: &Block) -> bool {
        let letters = block.letters();
        if !letters.within(PLAIN)
            || self.state.cycle.is_some()
            || self.macros.active > 0
            || block.repeated() != Letters::NONE
        {
            return false;
        }
        let (words, explicit) = match block.word(b'G') {
            None => (self.modal_arc_words().unwrap_or(Letters::NONE), None),
            Some(word) => {
                let code = word.number().and_then(code_number);
                let row = code.and_then(|code| self.control.g_code(code));
                let Some(row) = row.filter(|row| row.group == Group::Motion) else { return false };
                (self.words_of(row), Some(row.action))
            }
        };
        if !letters.within(ALWAYS.union(words)) {
            return false;
        }
        if letters.has(b'F') {
            self.take_feed(block);
        }
        self.motion_block(block, explicit);
        true
    }

    /// Finds the rows of all G and M words and judges how they go together.
    fn gather(&mut self, block: &Block, codes: &mut Vec<(&'static CodeRow, usize)>) {
        codes.clear();
        self.check_repeated_words(block);
        for (at, word) in block.words.iter().enumerate() {
            if !matches!(word.letter, b'G' | b'M') {
                continue;
            }
            let Some(number) = self.literal(word) else { continue };
            let row = code_number(number).and_then(|code| match word.letter {
                b'G' => self.control.g_code(code).filter(|row| self.has_unit_code(row)),
                _ => self.control.m_code(code),
            });
            match row {
                Some(row) => codes.push((row, at)),
                None => self.unknown_code(word),
            }
        }
        self.check_groups(block, codes);
    }

    /// Inch and millimetres may be chosen by G20 and G21, by G70 and G71, or by either.
    fn has_unit_code(&self, row: &CodeRow) -> bool {
        let by_g70 = row.code >= 700;
        match self.control.parameters.unit_codes {
            _ if row.group != Group::Units => true,
            UnitCodes::Both => true,
            UnitCodes::G20 => !by_g70,
            UnitCodes::G70 => by_g70,
        }
    }

    fn check_groups(&mut self, block: &Block, codes: &[(&'static CodeRow, usize)]) {
        for (index, second) in codes.iter().enumerate() {
            let letter = block.words[second.1].letter;
            let clash = codes[..index].iter().find(|first| {
                block.words[first.1].letter == letter
                    && self.one_group(first.0.group, second.0.group)
                    && excludes(first.0, second.0, self.control.table.distance_left_to_right)
            });
            if let Some(first) = clash {
                self.same_group(block, *first, *second);
            }
        }
        let g_words = block.all(b'G').count();
        for (row, at) in codes {
            let word = &block.words[*at];
            if g_words > 1 && word.letter == b'G' && self.control.table.alone.contains(&row.code) {
                let title = self.control.table.title;
                let name = super::report::decimal_code(row.code);
                self.report(
                    Diagnostic::new(
                        Code::NotAlone,
                        self.span(word.range),
                        format!("on a {title} G{name} must be the only G code of its block"),
                    )
                    .help("put the other G codes into the block before"),
                );
            }
        }
    }

    #[inline]
    fn check_repeated_words(&mut self, block: &Block) {
        const MAY_REPEAT: Letters = Letters::of("GM");
        if !block.repeated().within(MAY_REPEAT) {
            self.report_repeated_words(block);
        }
    }

    #[cold]
    fn report_repeated_words(&mut self, block: &Block) {
        let mut seen = Letters::NONE;
        for word in &block.words {
            // R words name registers; two of them may differ.
            let again = seen.has(word.letter)
                && !matches!(word.letter, b'G' | b'M')
                && !word.comma
                && word.register.is_none();
            // The words of a second return (`G28 Z0 G28 X0 Y0`) are told with the codes.
            if again {
                let letter = word.letter as char;
                let first = block.word(word.letter).map_or(word.range, |w| w.range);
                self.report(
                    Diagnostic::new(
                        Code::RepeatedWord,
                        self.span(word.range),
                        format!("`{letter}` stands more than once in this block"),
                    )
                    .label("the last one counts")
                    .also(self.span(first), "the first")
                    .help("keep one of them"),
                );
            }
            seen.insert(word.letter);
        }
    }

    fn carry_out_codes(&mut self, block: &Block, codes: &[(&'static CodeRow, usize)]) -> Flow {
        // What an unknown code would have done with the words is not known; the tool still
        // goes to the end point that they name.
        let code_words = block.all(b'G').count() + block.all(b'M').count();
        if codes.len() < code_words {
            for (row, _) in codes {
                self.take_reading_mode(row.action);
            }
            self.take_letters(block, codes);
            let (target, named) = self.target(block);
            if named != AxisMask::NONE {
                self.straight(block, target, named);
            }
            return self.take_after_motion(block, codes);
        }
        let claims = self.claims(codes);
        if let Some(flow) = self.repeat_or_call_by_l(block, codes, claims) {
            return flow;
        }
        self.check_unused(block, claims);
        self.block_without_repeats(block, codes)
    }

    /// What a block does once; a line repeat does it again and again.
    pub(super) fn block_without_repeats(
        &mut self,
        block: &Block,
        codes: &[(&'static CodeRow, usize)],
    ) -> Flow {
        for (row, _) in codes {
            self.take_reading_mode(row.action);
        }
        self.take_registers(block);
        self.take_letters(block, codes);
        // G41 beside a pocket names its side; the cycle offsets by itself.
        let own_side = codes.iter().any(|(row, _)| row.action == Action::GeneralPocket);
        for (row, at) in codes {
            if !(own_side && row.group == Group::Compensation) {
                self.take_mode(block, row, *at);
            }
        }
        self.take_length(block, codes);
        let one_shot = codes.iter().rev().find(|(row, _)| takes_axes(row.action));
        match one_shot {
            Some((row, at)) => {
                self.modes_beside_one_shot(codes);
                self.one_shot(block, row.action, *at);
            }
            None => {
                let motion = codes.iter().rev().find(|(row, _)| row.group == Group::Motion);
                let cycle = codes.iter().rev().find(|(row, _)| row.group == Group::Cycle);
                self.motion_or_cycle(block, motion.map(|c| c.0.action), cycle.map(|c| c.0.action));
            }
        }
        self.take_after_motion(block, codes)
    }

    /// A motion code stays in force, and decides between rapid and feed, when another code
    /// takes the axis words. G90 and G91 hold for words that are not read as a target.
    fn modes_beside_one_shot(&mut self, codes: &[(&'static CodeRow, usize)]) {
        for (row, _) in codes {
            match row.action {
                Action::Absolute => self.state.incremental = false,
                Action::Incremental => self.state.incremental = true,
                action if row.group == Group::Motion => {
                    self.end_cycle_if(self.control.parameters.cycles.cancel.by_motion);
                    self.take_motion_code(action);
                }
                _ => {}
            }
        }
    }

    /// Letters that the block's codes and modes take.
    fn claims(&self, codes: &[(&'static CodeRow, usize)]) -> Letters {
        let mut claims = ALWAYS;
        for (row, _) in codes {
            claims = claims.union(self.words_of(row));
        }
        let table = self.control.table;
        if table.work_offset_by_e {
            claims.insert(b'E');
        }
        if table.lexicon.registers {
            claims.insert(b'R');
        }
        if let Some(cycle) = self.state.cycle
            && let Some(row) = table.g_codes.iter().find(|r| r.action == Action::Cycle(cycle.kind))
        {
            claims = claims.union(row.words);
        }
        if let Some(words) = self.modal_arc_words() {
            claims = claims.union(words);
        }
        claims
    }

    /// What a block without a motion code may have because of the motion in force.
    fn modal_arc_words(&self) -> Option<Letters> {
        let code = match self.state.motion {
            Motion::Arc(_) => 20,
            Motion::Spiral(_) => 21,
            _ if self.control.table.motion == MotionModality::Armed => 20,
            _ => return None,
        };
        self.control.g_code(code).map(|row| self.words_of(row))
    }

    /// The letters a code takes with the parameters in force: Q and L on an arc only where
    /// they make it a spiral.
    fn words_of(&self, row: &CodeRow) -> Letters {
        let arc = matches!(row.action, Action::ArcCw | Action::ArcCcw);
        let spirals = matches!(
            self.control.parameters.spiral,
            SpiralForm::IncrementCount | SpiralForm::IncrementHeightCount
        );
        if arc && !spirals { row.words.without(Letters::of("QL")) } else { row.words }
    }

    fn check_unused(&mut self, block: &Block, claims: Letters) {
        if block.letters().within(claims) {
            return self.check_comma_words(block);
        }
        for index in 0..block.words.len() {
            let word = block.words[index];
            if !word.comma && !claims.has(word.letter) {
                self.unused_word(&word);
            }
        }
        self.check_comma_words(block);
    }

    fn check_comma_words(&mut self, block: &Block) {
        for word in block.words.iter().filter(|word| word.comma) {
            if word.letter == b'R' && self.tap_stands_in(block) {
                continue;
            }
            let letter = word.letter as char;
            self.report(
                Diagnostic::new(
                    Code::NotSimulated,
                    self.span(word.range),
                    format!("`,{letter}` (corner rounding or chamfer) is not carried out"),
                )
                .severity(Severity::Warning),
            );
        }
    }

    /// L without a code that takes it: a line repeat, or on a Fadal a call.
    fn repeat_or_call_by_l(
        &mut self,
        block: &Block,
        codes: &[(&'static CodeRow, usize)],
        claims: Letters,
    ) -> Option<Flow> {
        let table = self.control.table;
        let calls = table.subroutines == Subroutines::LetterL;
        let taken = claims.has(b'L') && !(calls && self.cycle_counts_in_l(block, codes));
        if taken || !block.letters().has(b'L') {
            return None;
        }
        let word = *block.last(b'L')?;
        let count = self.count(&word)?;
        // Below a hundred L repeats the hole of the cycle in force.
        if claims.has(b'L') && count < 100 {
            return None;
        }
        if table.subroutines == Subroutines::LetterL && count >= 100 {
            let mut claims = claims;
            claims.insert(b'L');
            self.check_unused(block, claims);
            self.take_registers(block);
            self.take_letters(block, codes);
            if self.fixed_routine(block, &word, count) {
                return Some(Flow::Next);
            }
            if count / 100 == BOLT_CIRCLE {
                self.bolt_circle(block, &word, count % 100);
                return Some(Flow::Next);
            }
            if self.state.cycle.is_some() {
                self.next_hole_beside_call(block);
            } else {
                let (target, named) = self.target(block);
                if named != AxisMask::NONE {
                    self.straight(block, target, named);
                }
            }
            self.call_subroutine(&word, count);
            return Some(Flow::Next);
        }
        if table.line_repeat == LineRepeat::None {
            return None;
        }
        let mut claims = claims;
        claims.insert(b'L');
        self.check_unused(block, claims);
        let times = self.allowed_repeats(&word, count);
        self.warn_of_repeated_modal_subroutine(block, times);
        for pass in 0..times {
            if pass > 0 && !self.count_repeated() {
                return Some(Flow::End(EndReason::Budget));
            }
            if let end @ Flow::End(_) = self.block_without_repeats(block, codes) {
                return Some(end);
            }
        }
        Some(Flow::Next)
    }

    /// Modes that change how the numbers of this very block are read.
    fn take_reading_mode(&mut self, action: Action) {
        match action {
            Action::Inch => self.set_units(Units::Inch),
            Action::Millimetre => self.set_units(Units::Millimetre),
            Action::Absolute if !self.control.table.distance_left_to_right => {
                self.state.incremental = false;
            }
            Action::Incremental if !self.control.table.distance_left_to_right => {
                self.state.incremental = true;
            }
            Action::ArcCenterAbsolute => self.state.arc_center = ArcCenter::Absolute,
            Action::ArcCenterIncremental => self.state.arc_center = ArcCenter::FromStart,
            Action::FeedPerTime => self.set_feed_mode(FeedMode::PerTime),
            Action::FeedInverseTime => self.set_feed_mode(FeedMode::InverseTime),
            Action::FeedPerRevolution => self.set_feed_mode(FeedMode::PerRevolution),
            _ => {}
        }
    }

    fn set_units(&mut self, units: Units) {
        if self.state.units != units {
            self.state.units = units;
            self.state.scale = Scale::new(units, &self.control.parameters);
            self.emit(CommandKind::Units(units));
        }
    }

    fn set_feed_mode(&mut self, mode: FeedMode) {
        if self.state.feed_mode != mode {
            self.state.feed_mode = mode;
            // A feed of one mode means nothing in another.
            self.state.feed = f64::NAN;
            self.state.feed_angular = f64::NAN;
            self.told.missing_feed = false;
            self.emit(CommandKind::FeedMode(mode));
        }
    }

    /// E, F, S, T, D, and M6, spindle and coolant on.
    fn take_letters(&mut self, block: &Block, codes: &[(&'static CodeRow, usize)]) {
        let letters = block.letters();
        if letters.has(b'F') && !self.feed_is_tap_speed(codes) {
            self.take_feed(block);
        }
        if letters.has(b'S') {
            self.take_speed(block);
        }
        if letters.has(b'T') {
            self.take_tool_word(block);
        }
        if letters.has(b'E') && self.control.table.work_offset_by_e {
            self.take_e_word(block);
        }
        if letters.has(b'D')
            && let Some(number) = self.count_of(block, b'D')
        {
            let before = self.state.radius_offset.replace(number);
            // A G41 or G42 in the same block tells it by itself.
            if self.state.side != crate::command::Side::Off
                && before != Some(number)
                && !codes.iter().any(|(row, _)| row.group == Group::Compensation)
            {
                self.change_compensation_offset(block);
            }
        }
        for (row, at) in codes {
            match row.action {
                Action::ToolChange => self.tool_change(block, *at),
                Action::SpindleCw => self.set_spindle(SpindleState::Cw),
                Action::SpindleCcw => self.set_spindle(SpindleState::Ccw),
                Action::SpindleOrient => self.set_spindle(SpindleState::Oriented),
                Action::CoolantMist => self.set_coolant(|c| c.mist = true),
                Action::CoolantFlood => self.set_coolant(|c| c.flood = true),
                Action::CoolantThroughTool => self.set_coolant(|c| c.through_tool = true),
                _ => {}
            }
        }
    }

    /// Modes that the motion of this block obeys.
    fn take_mode(&mut self, block: &Block, row: &'static CodeRow, at: usize) {
        match row.action {
            Action::PlaneXy => self.set_plane(block, at, Plane::Xy),
            Action::PlaneZx => self.set_plane(block, at, Plane::Zx),
            Action::PlaneYz => self.set_plane(block, at, Plane::Yz),
            Action::CompensationOff | Action::CompensationLeft | Action::CompensationRight => {
                self.set_compensation(block, at, row.action);
            }
            Action::CornerArc { own_block: false } => self.corner_arc(block, false),
            Action::WorkOffset(number) => self.select_work(WorkName::G(number)),
            Action::WorkOffsetPoint(number) => self.select_work(WorkName::G59(number)),
            Action::WorkOffsetNumbered(number) => self.select_work(WorkName::Extended(number)),
            Action::WorkOffsetExtended => self.select_extended_work(block, at),
            Action::PathExact
            | Action::PathExactStop
            | Action::ExactStopOnce
            | Action::PathContinuous
            | Action::PathHighAccuracy
            | Action::LookAhead { .. }
            | Action::Smoothness => self.take_path_mode(block, row, at),
            Action::ReturnInitial => self.state.return_to_r = false,
            Action::ReturnToR => self.state.return_to_r = true,
            Action::CancelCycle => self.cancel_cycle(),
            Action::ModalSubroutine => self.begin_modal_subroutine(block, at),
            Action::ModalCallOff => self.end_modal_call(),
            Action::NotSimulated => {
                let word = block.words[at];
                self.not_simulated(&word, row);
            }
            _ => {}
        }
    }

    fn set_plane(&mut self, block: &Block, at: usize, plane: Plane) {
        let swapped = self.control.parameters.plane_codes == PlaneCodes::Swapped;
        let plane = match plane {
            Plane::Zx if swapped => Plane::Yz,
            Plane::Yz if swapped => Plane::Zx,
            other => other,
        };
        if plane == self.state.plane {
            return;
        }
        if self.state.side != crate::command::Side::Off {
            self.report(
                Diagnostic::new(
                    Code::PlaneChangeInCompensation,
                    self.span(block.words[at].range),
                    "the plane changes while cutter compensation is on",
                )
                .help("cancel compensation with G40 first"),
            );
        }
        self.state.plane = plane;
        self.emit(CommandKind::Plane(plane));
    }

    /// G43, G44, G49 and H.
    fn take_length(&mut self, block: &Block, codes: &[(&'static CodeRow, usize)]) {
        let length_code = codes.iter().rev().find(|(row, _)| row.group == Group::ToolLength);
        let by_code = length_code.map(|(row, _)| row.action);
        if by_code.is_none() && !block.letters().has(b'H') {
            return;
        }
        let called = codes.iter().any(|(row, _)| row.group == Group::Calling)
            || codes.iter().any(|(row, _)| row.action == Action::SetData);
        if called {
            return;
        }
        if by_code == Some(Action::LengthCancel) {
            return self.set_length(block, LengthOffset { number: None, minus: false });
        }
        let in_force = self.state.offsets.length();
        let minus = match by_code {
            Some(Action::LengthMinus) => true,
            Some(_) => false,
            None => in_force.minus,
        };
        // H alone changes the length where the control has it so, or where one is in force.
        let applies = by_code.is_some()
            || self.control.parameters.length_by_h_alone
            || in_force.number.is_some();
        if !applies {
            return;
        }
        let number = match block.letters().has(b'H') {
            true => self.count_of(block, b'H'),
            false => in_force.number.or(Some(self.state.tool)),
        };
        match number {
            Some(0) => self.set_length(block, LengthOffset { number: None, minus: false }),
            Some(number) => {
                self.check_length_number(block, number);
                self.set_length(block, LengthOffset { number: Some(number), minus });
            }
            None => {}
        }
    }

    /// Spindle and coolant off, stops, ends, calls and returns.
    fn take_after_motion(&mut self, block: &Block, codes: &[(&'static CodeRow, usize)]) -> Flow {
        if self.state.path.once {
            self.end_exact_stop_once();
        }
        for (row, at) in codes {
            match row.action {
                // Where they act from left to right the last one stays in force, whether or
                // not the block had axis words to act on.
                Action::Absolute => self.state.incremental = false,
                Action::Incremental => self.state.incremental = true,
                Action::SpindleStop => self.set_spindle(SpindleState::Off),
                Action::CoolantOff => self.set_coolant(|c| *c = Default::default()),
                Action::CoolantThroughToolOff => self.set_coolant(|c| c.through_tool = false),
                Action::ProgramStop => self.emit(CommandKind::Stop { optional: false }),
                Action::OptionalStop => self.emit(CommandKind::Stop { optional: true }),
                Action::ProgramEnd { .. } => {
                    self.set_spindle(SpindleState::Off);
                    self.emit(CommandKind::End);
                    return Flow::End(EndReason::ProgramEnd);
                }
                Action::RunCycleHere => self.run_cycle_here(block, *at),
                Action::CallProgram => self.call_program(block, *at),
                Action::CallLabel => self.call_label(block, *at),
                Action::Return => return self.return_from_program(block, *at),
                Action::SubroutineEnd => self.return_from_subroutine(block, *at),
                _ => {}
            }
        }
        Flow::Next
    }
}

/// Codes of one group that stand in one block against the rules.
fn excludes(first: &CodeRow, second: &CodeRow, distance_left_to_right: bool) -> bool {
    match second.group {
        Group::Distance => !distance_left_to_right && first.code != second.code,
        Group::OneShot => takes_axes(first.action) && takes_axes(second.action),
        Group::Auxiliary | Group::Calling | Group::Coolant | Group::Spindle => false,
        _ => first.code != second.code,
    }
}

/// Codes that take the axis words of their block for themselves.
fn takes_axes(action: Action) -> bool {
    matches!(
        action,
        Action::Dwell
            | Action::SetData
            | Action::ReturnToReference { .. }
            | Action::ReturnFromReference
            | Action::MachineCoordinates
            | Action::LocalShift
            | Action::PresetPosition
            | Action::ClearPreset { .. }
            | Action::RestorePreset
            | Action::CircularPocketCw
            | Action::CircularPocketCcw
            | Action::GeneralPocket
            | Action::Pattern(_)
            | Action::Probe { .. }
            | Action::CornerArc { own_block: true }
            | Action::NotSimulated
    )
}
