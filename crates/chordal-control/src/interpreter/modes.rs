//! The modes that a block sets: those its numbers are read by, those its motion obeys, and what
//! comes after the motion.

use chordal_diagnostics::{Code, Diagnostic};
use chordal_geometry::Plane;
use chordal_syntax::Block;

use super::{EndReason, Flow, Interpreter};
use crate::command::{CommandKind, FeedMode, Side, SpindleState, Units, WorkName};
use crate::offsets::LengthOffset;
use crate::parameters::{ArcCenter, PlaneCodes};
use crate::state::Scale;
use crate::table::{Action, CodeRow, Group};

impl Interpreter<'_> {
    /// Modes that change how the numbers of this very block are read.
    pub(super) fn take_reading_mode(&mut self, action: Action) {
        match action {
            Action::Inch => self.set_units(Units::Inch),
            Action::Millimetre => self.set_units(Units::Millimetre),
            Action::Absolute if !self.control.table.distance_left_to_right => {
                self.set_incremental(false);
            }
            Action::Incremental if !self.control.table.distance_left_to_right => {
                self.set_incremental(true);
            }
            Action::ArcCenterAbsolute => self.state.arc_center = ArcCenter::Absolute,
            Action::ArcCenterIncremental => self.state.arc_center = ArcCenter::FromStart,
            Action::FeedPerTime => self.set_feed_mode(FeedMode::PerTime),
            Action::FeedInverseTime => self.set_feed_mode(FeedMode::InverseTime),
            Action::FeedPerRevolution => self.set_feed_mode(FeedMode::PerRevolution),
            _ => {}
        }
    }

    /// G90 and G91; where the tool stands when G91 comes into force is remembered.
    pub(super) fn set_incremental(&mut self, incremental: bool) {
        if incremental && !self.state.incremental {
            self.state.incremental_from = self.state.position;
        }
        self.state.incremental = incremental;
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
    pub(super) fn take_letters(&mut self, block: &Block, codes: &[(&'static CodeRow, usize)]) {
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
            if self.state.side != Side::Off
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
    pub(super) fn take_mode(&mut self, block: &Block, row: &'static CodeRow, at: usize) {
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
            | Action::PathTapping
            | Action::LookAhead { .. }
            | Action::Smoothness => self.take_path_mode(block, row, at),
            Action::Overrides { .. } | Action::OverridesByP => {
                self.take_overrides(block, row.action);
            }
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
        if self.state.side != Side::Off {
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
    pub(super) fn take_length(&mut self, block: &Block, codes: &[(&'static CodeRow, usize)]) {
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

    /// A motion code stays in force, and decides between rapid and feed, when another code
    /// takes the axis words. G90 and G91 hold for words that are not read as a target.
    pub(super) fn modes_beside_one_shot(
        &mut self,
        block: &Block,
        codes: &[(&'static CodeRow, usize)],
        taker: &CodeRow,
    ) {
        for (row, at) in codes {
            match row.action {
                Action::ArcCw | Action::ArcCcw | Action::SpiralCw | Action::SpiralCcw
                    if self.has_arc_words(block) =>
                {
                    self.arc_left_out(block, *at, row, taker);
                    self.take_motion_code(row.action);
                }
                Action::Absolute => self.set_incremental(false),
                Action::Incremental => self.set_incremental(true),
                action if row.group == Group::Motion => {
                    self.end_cycle_if(self.control.parameters.cycles.cancel.by_motion);
                    self.take_motion_code(action);
                }
                _ => {}
            }
        }
    }

    /// G2 or G3 with a centre in the block of a code that takes the axis words for itself.
    fn arc_left_out(&mut self, block: &Block, at: usize, arc: &CodeRow, taker: &CodeRow) {
        let (arc, taker) = (arc.name(b'G'), taker.name(b'G'));
        self.report(
            Diagnostic::new(
                Code::SameGroup,
                self.span(block.words[at].range),
                format!("{arc} makes no arc in the block of {taker}, which uses the axis words"),
            )
            .severity(chordal_diagnostics::Severity::Warning)
            .label("the arc is skipped")
            .help("write the arc in a separate block"),
        );
    }

    /// Spindle and coolant off, stops, ends, calls and returns.
    pub(super) fn take_after_motion(
        &mut self,
        block: &Block,
        codes: &[(&'static CodeRow, usize)],
    ) -> Flow {
        if self.state.path.once {
            self.end_exact_stop_once();
        }
        for (row, at) in codes {
            match row.action {
                // Where they act from left to right the last one stays in force, whether or
                // not the block had axis words to act on.
                Action::Absolute => self.set_incremental(false),
                Action::Incremental => self.set_incremental(true),
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
                Action::ShopCode => self.carry_out_shop_code(block, codes, *at),
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
