//! Targets, straight moves, the F word, and the choice between line, arc, spiral and cycle.

use std::f64::consts::TAU;

use chordal_command::{AxisMask, FeedMode, Position, Units, number_text};
use chordal_diagnostics::{Code, Diagnostic, Severity, Span};
use chordal_dialect::table::MotionModality;
use chordal_dialect::{Action, MotionCode, ReadingCode};
use chordal_geometry::TurnDirection;
use chordal_kernel::rules::{CycleKind, TurnCycle};
use chordal_kernel::{ModalMotion, SplineForm};
use chordal_machine::{Axis, RolloverRule};
use chordal_syntax::{Block, Letters, Word};

use super::Interpreter;
use super::literals::AXIS_OF;

/// A turn, degrees.
const TURN_DEG: f64 = 360.0;

/// What conversions from degrees leave of a turn, rad: less than the least increment of any control.
const ANGLE_ROUNDING_RAD: f64 = 1e-12;

/// The number of linear axes, before which no axis rolls over.
const LINEAR_AXES: usize = 3;

const CENTER: Letters = Letters::of("IJK");

impl Interpreter<'_> {
    /// The end point given by the axis words of a block (mm, rad), and the axes they name.
    #[inline]
    pub(super) fn target(&mut self, block: &Block) -> (Position, AxisMask) {
        if self.kernel.state.polar.is_some() || self.kernel.state.surface.is_some() {
            let (target, named) = match self.kernel.state.polar.is_some() {
                true => self.target_by_angle(block),
                false => self.target_on_surface(block),
            };
            if !self.kernel.state.incremental {
                self.kernel.state.place(named);
            }
            return (target, named);
        }
        let from = self.kernel.state.control_position.unwrap_or(self.kernel.state.position);
        let mut target = from;
        let mut named = AxisMask::NONE;
        let is_incremental = self.kernel.state.incremental;
        let mut increments = AxisMask::NONE;
        let left_to_right = self.control.table.distance_left_to_right && block.letters().has(b'G');
        for word in &block.words {
            let axis = AXIS_OF[word.letter as usize] as usize;
            if axis < 6 && !word.comma {
                let Some(value) = self.axis_value(word, axis) else { continue };
                target[axis] = match (self.kernel.state.incremental, axis) {
                    (true, _) => from[axis] + value,
                    (false, 0..3) => value,
                    (false, _) => self.rotary_target(word, axis, from[axis], value),
                };
                named.insert(axis);
            } else if let Some(axis) = self.increment_axis(word) {
                let Some(by) = self.axis_value(word, axis) else { continue };
                target[axis] = from[axis] + by;
                named.insert(axis);
                increments.insert(axis);
            } else if left_to_right && word.letter == b'G' {
                self.distance_word(word);
            }
        }
        if !is_incremental && !self.kernel.state.incremental {
            self.kernel.state.place(named.without(increments));
        }
        if !block.polar.is_empty() {
            self.radius_and_angle(block, &mut target, &mut named);
        }
        if !self.control.axes().covers(named) {
            self.missing_axes(block, &mut target, &mut named);
        }
        (target, named)
    }

    #[cold]
    fn report_inverse_time(&mut self, word: &Word, value: f64) {
        let most = self.control.parameters.largest_inverse_time;
        let message = format!("F{} in inverse time (G93) is above {most}", number_text(value, 1));
        let diagnostic = Diagnostic::new(Code::FeedOverLimit, self.span(word.range), message)
            .label(format!("the block takes less than {:.2} ms", 60_000.0 / most))
            .help(format!("make the block longer, or F {most} at most"));
        self.kernel.report(diagnostic);
    }

    /// The position of a rotary axis that a word names, rad: where the axis rolls over, the word is an angle on the circle,
    /// and the position counts turns.
    fn rotary_target(&mut self, word: &Word, axis: usize, from: f64, value: f64) -> f64 {
        let rollover = self.machine.rotary[axis - LINEAR_AXES].rollover;
        if rollover == Some(RolloverRule::Sign) && value.abs() > TAU - ANGLE_ROUNDING_RAD {
            self.report_beyond_turn(word, axis, value);
        }
        match rollover {
            Some(rule) if self.kernel.state.known.has(axis) => from + rule.movement(from, value),
            _ => value,
        }
    }

    /// Reports an absolute angle of a whole turn or more, on controls that refuse it.
    #[cold]
    fn report_beyond_turn(&mut self, word: &Word, axis: usize, value: f64) {
        let Some(alarm) = self.control.table.rollover_beyond_turn else { return };
        let letter = Axis::ALL[axis].letter();
        let degrees = number_text(value.to_degrees(), 3);
        let alarm = alarm.replace("{axis}", &letter.to_string());
        let alarm = alarm.replace("{value}", &format!("{:.2}", value.to_degrees()));
        let message =
            format!("{letter} rolls over after a turn, and {degrees} deg is not within it");
        let within = number_text(value.to_degrees() % TURN_DEG, 3);
        let diagnostic = Diagnostic::new(Code::BadWordValue, self.span(word.range), message)
            .label("above -360 and below 360 deg")
            .help(format!(
                "write {within}, with the sign of the direction; more turns need a block each, or G91"
            ));
        self.report_refused(diagnostic, &alarm);
    }

    /// The axis that a letter moves by an increment (U for X); `None` for other letters.
    #[inline]
    pub(super) fn increment_axis(&self, word: &Word) -> Option<usize> {
        let increments = self.increments();
        if increments.is_empty() || word.comma {
            return None;
        }
        let (_, axis) = increments.iter().find(|(letter, _)| *letter == word.letter)?;
        Some(AXIS_OF[usize::from(*axis)] as usize)
    }

    /// Carries out G90 and G91 on controls where they act from left to right.
    fn distance_word(&mut self, word: &Word) {
        let row = self
            .literal(word)
            .and_then(chordal_dialect::code_number)
            .and_then(|code| self.control.g_code(code));
        match row.map(|row| row.action) {
            Some(Action::Reading(ReadingCode::Absolute)) => self.kernel.set_incremental(false),
            Some(Action::Reading(ReadingCode::Incremental)) => self.kernel.set_incremental(true),
            _ => {}
        }
    }

    #[cold]
    fn missing_axes(&mut self, block: &Block, target: &mut Position, named: &mut AxisMask) {
        let absent = named.without(self.control.axes());
        for axis in absent.iter() {
            let index = axis as usize;
            target[index] = self.kernel.state.position[index];
            if self.reported.axes.has(index) {
                continue;
            }
            self.reported.axes.insert(index);
            let letter = axis.letter();
            let span = self.words_span(block, Letters(1 << (letter as u8 - b'A')));
            if self.is_axis_of_second_spindle(letter, span.range) {
                continue;
            }
            let diagnostic = self.no_such_axis(letter, span);
            self.kernel.report(diagnostic);
        }
        *named = named.and(self.control.axes());
    }

    /// The problem of an axis the machine does not have: an error for a machine that the user chose, a warning for an
    /// assumed one, as then the assumption is wrong.
    fn no_such_axis(&self, letter: char, span: Span) -> Diagnostic {
        let machine = self.machine;
        if self.options.assumed_machine {
            let message = format!("the assumed machine ({}) has no {letter} axis", machine.title);
            let help = format!(
                "name your machine with --machine, or give it the axis: `--set axes.{letter}=…`"
            );
            return Diagnostic::new(Code::NoSuchAxis, span, message)
                .severity(Severity::Warning)
                .label("this word is skipped")
                .help(help);
        }
        let message = format!("the machine {} has no {letter} axis", machine.name);
        Diagnostic::new(Code::NoSuchAxis, span, message)
            .label("this word is skipped")
            .help(format!("add `[axes.{letter}]` to the machine file, or choose a machine"))
    }

    /// Carries out the motion or the cycle of a block; `explicit` is its own motion code.
    pub(super) fn motion_or_cycle(
        &mut self,
        block: &Block,
        explicit: Option<MotionCode>,
        cycle: Option<(CycleKind, bool)>,
    ) {
        self.kernel.end_cycle_if(
            explicit.is_some() && self.control.parameters.rules.cycles.cancel.by_motion,
        );
        let arc = matches!(explicit, Some(MotionCode::ArcCw | MotionCode::ArcCcw));
        match cycle {
            Some((kind, radial)) => {
                self.check_straight_along_tool(block, "a canned cycle");
                self.check_turn_in(block, "a canned cycle");
                self.start_cycle(block, kind, radial);
            }
            _ if self.kernel.state.cycle.is_some() && !arc => {
                self.check_turn_in(block, "a canned cycle");
                self.next_hole(block);
            }
            _ => self.motion_block(block, explicit),
        }
    }

    /// Sets the motion code, then makes the motion of the words.
    pub(super) fn motion_block(&mut self, block: &Block, explicit: Option<MotionCode>) {
        let modal = self.kernel.state.motion;
        if let Some(action) = explicit {
            self.watch_open_spline(block, action);
            if action == MotionCode::SplineEnd {
                return self.end_spline(block);
            }
            self.take_motion_code(action);
        }
        if let ModalMotion::Spline(form) = self.kernel.state.motion {
            self.spline_block(block, form, explicit.is_some());
            // G5 and G5.1 act in their block only.
            if form != SplineForm::Points {
                self.kernel.state.motion = modal;
            }
            return;
        }
        match self.control.table.motion {
            MotionModality::Exclusive => self.exclusive_motion(block, explicit.is_some()),
            MotionModality::Armed => self.armed_motion(block, explicit),
        }
    }

    pub(super) fn take_motion_code(&mut self, code: MotionCode) {
        let armed = self.control.table.motion == MotionModality::Armed;
        let motion = match code {
            MotionCode::Rapid => ModalMotion::Rapid,
            MotionCode::Linear => ModalMotion::Linear,
            MotionCode::ArcCw => ModalMotion::Arc(TurnDirection::Cw),
            MotionCode::ArcCcw => ModalMotion::Arc(TurnDirection::Ccw),
            MotionCode::SpiralCw => ModalMotion::Spiral(TurnDirection::Cw),
            MotionCode::SpiralCcw => ModalMotion::Spiral(TurnDirection::Ccw),
            MotionCode::Thread => ModalMotion::Thread,
            MotionCode::RigidTap => ModalMotion::RigidTap,
            MotionCode::Spline(form) => ModalMotion::Spline(form),
            MotionCode::SplineEnd => ModalMotion::None,
            MotionCode::Turn(pass) => ModalMotion::Turn(pass),
        };
        match motion {
            // G2 and G3 select a direction and leave G0 or G1 active.
            ModalMotion::Arc(direction) if armed => self.kernel.state.armed = Some(direction),
            ModalMotion::Rapid if armed && self.control.parameters.rapid_cancels_arc => {
                (self.kernel.state.motion, self.kernel.state.armed) = (ModalMotion::Rapid, None);
            }
            other => self.kernel.state.motion = other,
        }
    }

    fn exclusive_motion(&mut self, block: &Block, explicit: bool) {
        let arc_words = self.has_arc_words(block);
        let (mut target, mut named) = self.target(block);
        if block.commas && self.control.parameters.corner_words_in_g1 {
            self.line_by_angle(block, &mut target, &mut named);
        }
        if named != AxisMask::NONE && self.open_line.is_some() {
            self.end_open_line(block, &target, named);
        }
        if named == AxisMask::NONE
            && (!arc_words || matches!(self.kernel.state.motion, ModalMotion::Turn(_)))
            && !self.has_tool_vector(block)
        {
            return;
        }
        if self.kernel.state.frame_jump.is_some() {
            self.kernel.check_first_after_frame(&self.at(block), &target, named);
        }
        if self.kernel.state.surface.is_some() {
            self.check_surface_motion(block, explicit);
        }
        match self.kernel.state.motion {
            ModalMotion::Rapid | ModalMotion::Linear => {
                if named.and(AxisMask::ROTARY) != AxisMask::NONE {
                    self.kernel.turn_fixture_error(&target);
                }
                if self.kernel.state.part_frame.is_some() {
                    self.straight_on_part(block, target, named);
                } else if named != AxisMask::NONE {
                    self.kernel.straight(&self.at(block), target, named);
                }
            }
            ModalMotion::Arc(direction) => {
                if self.has_tool_vector(block) {
                    let range = self.words_span(block, CENTER).range;
                    let message = "an arc with I, J and K under G43.5 is not followed";
                    self.lose_path(range, message.to_string());
                }
                self.check_straight_along_tool(block, "an arc");
                self.check_arc_in_fixed_frame(block, &target, named);
                if self.kernel.state.offsets.fixture().number != 0 {
                    self.check_turn_in(block, "an arc");
                }
                let direction = self.direction_on_surface(direction);
                self.arc_block(block, direction, target, named, explicit);
            }
            ModalMotion::Spiral(direction) => {
                self.check_straight_along_tool(block, "a spiral");
                self.spiral_block(block, direction, target, named);
            }
            ModalMotion::Thread => self.thread_block(block, target, named, false),
            ModalMotion::RigidTap => self.thread_block(block, target, named, true),
            ModalMotion::Turn(pass) => self.turn_block(block, pass, target, named, explicit),
            ModalMotion::Probe { must_hit } => self.probe_move(block, 0, must_hit),
            ModalMotion::ThreadPasses => self.turning_cycle(block, 0, TurnCycle::LineThread),
            // Carried out before, as it has other words.
            ModalMotion::Spline(_) => {}
            ModalMotion::None => self.report_no_motion(block, target, named),
        }
    }

    /// Reports axis words without an active motion (after G80); shown as a rapid.
    #[cold]
    fn report_no_motion(&mut self, block: &Block, target: Position, named: AxisMask) {
        if named == AxisMask::NONE {
            return;
        }
        let span = self.span(block.range);
        self.kernel.report(
            Diagnostic::new(
                Code::NoMotionInForce,
                span,
                "axis words, and no motion code is active: none was written, or G80 has ended it",
            )
            .help("write G0 or G1 into this block"),
        );
        self.kernel.rapid(target, named);
    }

    fn armed_motion(&mut self, block: &Block, explicit: Option<MotionCode>) {
        let arc_words = self.has_arc_words(block);
        let (target, named) = self.target(block);
        if self.kernel.state.frame_jump.is_some() {
            self.kernel.check_first_after_frame(&self.at(block), &target, named);
        }
        let arc_code = matches!(explicit, Some(MotionCode::ArcCw | MotionCode::ArcCcw));
        // R0 in a block of its own only stores the register.
        let moves = named != AxisMask::NONE || arc_code || block.letters().meets(CENTER);
        if arc_words && moves {
            self.watch_rapid_after_arc(block, true, true);
            match self.kernel.state.armed {
                Some(direction) => self.arc_block(block, direction, target, named, arc_code),
                None => self.unarmed_arc(block, target, named),
            }
        } else if named != AxisMask::NONE {
            // A retraction along the tool is intended as a rapid.
            let (_, _, normal) = self.kernel.state.plane.axes();
            let retract = named == AxisMask(1 << normal);
            self.watch_rapid_after_arc(block, false, explicit.is_some() || retract);
            if arc_code {
                self.report_line_for_arc(block);
            }
            self.kernel.straight(&self.at(block), target, named);
        }
    }

    /// True when the block has a centre word or a radius.
    #[inline]
    pub(super) fn has_arc_words(&self, block: &Block) -> bool {
        let letters = block.letters();
        if letters.meets(CENTER) {
            return true;
        }
        letters.has(b'R') && self.radius_word(block).is_some()
    }

    /// Carries out F.
    pub(super) fn take_feed(&mut self, block: &Block) {
        let Some(word) = block.last(b'F').copied() else { return };
        let Some(number) = self.literal(&word) else { return };
        let parameters = &self.control.parameters;
        if parameters.zero_feed_passed_over && number.to_f64() <= 0.0 {
            return self.kernel.report(
                Diagnostic::new(
                    Code::MissingFeed,
                    self.span(word.range),
                    format!("F{number} does nothing here: the feed before it stays"),
                )
                .severity(Severity::Warning)
                .help("write a feed above zero"),
            );
        }
        let units = match self.units_of_feed.take() {
            Some(units) => {
                self.report_feed_before_units(&word, units);
                units
            }
            None => self.kernel.state.units,
        };
        let (factor, mut extra) = match units {
            Units::Inch => (254, 1),
            Units::Millimetre => (1, 0),
        };
        if !number.has_point && units == Units::Inch {
            extra += parameters.feed_digits_inch;
        }
        let per_minute = number.times(factor, extra);
        let plain = number.to_f64();
        let (feed, angular) = match self.kernel.state.feed_mode {
            FeedMode::PerTime => (per_minute / 60.0, plain.to_radians() / 60.0),
            FeedMode::InverseTime => {
                if plain > parameters.largest_inverse_time {
                    self.report_inverse_time(&word, plain);
                }
                (plain / 60.0, plain / 60.0)
            }
            FeedMode::PerRevolution => (per_minute, per_minute),
        };
        self.feed_number = Some((feed, plain));
        self.kernel.set_feed(self.span(word.range), feed, angular);
        if feed < 0.0 {
            self.kernel.report(
                Diagnostic::new(
                    Code::BadWordValue,
                    self.span(word.range),
                    format!("a feed cannot be negative: F{number}"),
                )
                .help("remove the sign"),
            );
        }
    }

    /// Reports F in a block that changes the units after it, with its value.
    fn report_feed_before_units(&mut self, word: &Word, units: Units) {
        let Some(number) = self.literal(word) else { return };
        if self.kernel.state.feed_mode == FeedMode::InverseTime {
            return;
        }
        let (own, other, per_own) = match units {
            Units::Inch => ("in", "mm", 25.4),
            Units::Millimetre => ("mm", "in", 1.0 / 25.4),
        };
        let value = number_text(number.to_f64() * per_own, 4);
        let title = self.control.table.title;
        let message = format!(
            "F{number} is {number} {own}, that is {value} {other}: {title} takes F before the units of its block change"
        );
        self.kernel.report(
            Diagnostic::new(Code::FeedBeforeUnits, self.span(word.range), message)
                .help("write F in a block after that of G20 or G21"),
        );
    }
}
