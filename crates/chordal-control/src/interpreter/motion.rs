//! Targets, straight moves, feed, and the choice between line, arc, spiral and cycle.

use chordal_diagnostics::{Code, Diagnostic, Span};
use chordal_geometry::Direction;
use chordal_syntax::{Block, Letters};

use super::Interpreter;
use super::values::AXIS_OF;
use crate::command::{
    ArcShape, AxisMask, CommandKind, Feed, FeedAlong, FeedMode, Move, Position, SpindleState, Units,
};
use crate::state::Motion;
use crate::table::{Action, MotionModality};

const CENTER: Letters = Letters::of("IJK");

impl Interpreter<'_> {
    /// The end point that the axis words of a block give, and the axes they name.
    #[inline]
    pub(super) fn target(&mut self, block: &Block) -> (Position, AxisMask) {
        let mut target = self.state.position;
        let mut named = AxisMask::NONE;
        let left_to_right = self.control.table.distance_left_to_right && block.letters().has(b'G');
        for word in &block.words {
            let axis = AXIS_OF[word.letter as usize] as usize;
            if axis < 6 && !word.comma {
                let Some(value) = self.axis_value(word, axis) else { continue };
                target[axis] =
                    if self.state.incremental { self.state.position[axis] + value } else { value };
                named.insert(axis);
            } else if left_to_right && word.letter == b'G' {
                self.distance_word(word);
            }
        }
        if !self.control.axes().covers(named) {
            self.missing_axes(block, &mut target, &mut named);
        }
        (target, named)
    }

    /// G90 and G91 where they act from left to right.
    fn distance_word(&mut self, word: &chordal_syntax::Word) {
        let row = self
            .literal(word)
            .and_then(crate::table::code_number)
            .and_then(|code| self.control.g_code(code));
        match row.map(|row| row.action) {
            Some(Action::Absolute) => self.set_incremental(false),
            Some(Action::Incremental) => self.set_incremental(true),
            _ => {}
        }
    }

    #[cold]
    fn missing_axes(&mut self, block: &Block, target: &mut Position, named: &mut AxisMask) {
        let absent = named.without(self.control.axes());
        for axis in absent.iter() {
            let index = axis as usize;
            target[index] = self.state.position[index];
            if self.told.axes.has(index) {
                continue;
            }
            self.told.axes.insert(index);
            let letter = axis.letter();
            let span = self.words_span(block, Letters(1 << (letter as u8 - b'A')));
            let machine = &self.machine.name;
            self.report(
                Diagnostic::new(
                    Code::NoSuchAxis,
                    span,
                    format!("the machine {machine} has no {letter} axis"),
                )
                .label("this word is skipped")
                .help(format!("add `[axes.{letter}]` to the machine file, or choose a machine")),
            );
        }
        *named = named.and(self.control.axes());
    }

    /// A block without a motion code of its own, or with one: `explicit`.
    pub(super) fn motion_or_cycle(
        &mut self,
        block: &Block,
        explicit: Option<Action>,
        cycle: Option<Action>,
    ) {
        self.end_cycle_if(explicit.is_some() && self.control.parameters.cycles.cancel.by_motion);
        let arc = matches!(explicit, Some(Action::ArcCw | Action::ArcCcw));
        match cycle {
            Some(Action::Cycle(kind)) => self.start_cycle(block, kind),
            _ if self.state.cycle.is_some() && !arc => self.next_hole(block),
            _ => self.motion_block(block, explicit),
        }
    }

    /// Takes the motion code, then moves as the words say.
    pub(super) fn motion_block(&mut self, block: &Block, explicit: Option<Action>) {
        if let Some(action) = explicit {
            self.take_motion_code(action);
        }
        match self.control.table.motion {
            MotionModality::Exclusive => self.exclusive_motion(block, explicit.is_some()),
            MotionModality::Armed => self.armed_motion(block, explicit),
        }
    }

    pub(super) fn take_motion_code(&mut self, action: Action) {
        let armed = self.control.table.motion == MotionModality::Armed;
        let motion = match action {
            Action::Rapid => Motion::Rapid,
            Action::Linear => Motion::Linear,
            Action::ArcCw => Motion::Arc(Direction::Cw),
            Action::ArcCcw => Motion::Arc(Direction::Ccw),
            Action::SpiralCw => Motion::Spiral(Direction::Cw),
            Action::SpiralCcw => Motion::Spiral(Direction::Ccw),
            _ => return,
        };
        match motion {
            // G2 and G3 arm a direction and leave G0 or G1 in force.
            Motion::Arc(direction) if armed => self.state.armed = Some(direction),
            Motion::Rapid if armed && self.control.parameters.rapid_disarms_arc => {
                (self.state.motion, self.state.armed) = (Motion::Rapid, None);
            }
            other => self.state.motion = other,
        }
    }

    fn exclusive_motion(&mut self, block: &Block, explicit: bool) {
        let arc_words = self.has_arc_words(block);
        let (target, named) = self.target(block);
        if named == AxisMask::NONE && !arc_words {
            return;
        }
        match self.state.motion {
            Motion::Rapid | Motion::Linear => {
                if named != AxisMask::NONE {
                    self.straight(block, target, named);
                }
            }
            Motion::Arc(direction) => self.arc_block(block, direction, target, named, explicit),
            Motion::Spiral(direction) => self.spiral_block(block, direction, target, named),
            Motion::None => self.report_no_motion(block, target, named),
        }
    }

    /// Axis words after G80 where that leaves no motion in force; shown as a rapid.
    #[cold]
    fn report_no_motion(&mut self, block: &Block, target: Position, named: AxisMask) {
        if named == AxisMask::NONE {
            return;
        }
        let span = self.span(block.range);
        self.report(
            Diagnostic::new(
                Code::NoMotionInForce,
                span,
                "axis words, and no motion code is active after G80",
            )
            .help("write G0 or G1 into this block"),
        );
        let motion = self.moved_to(target, named);
        let path = self.control.parameters.rapid;
        self.emit(CommandKind::Rapid { motion, path });
    }

    fn armed_motion(&mut self, block: &Block, explicit: Option<Action>) {
        let arc_words = self.has_arc_words(block);
        let (target, named) = self.target(block);
        let arc_code = matches!(explicit, Some(Action::ArcCw | Action::ArcCcw));
        // R0 in a block of its own only stores the register.
        let moves = named != AxisMask::NONE || arc_code || block.letters().meets(CENTER);
        if arc_words && moves {
            self.watch_rapid_after_arc(block, true, true);
            match self.state.armed {
                Some(direction) => self.arc_block(block, direction, target, named, arc_code),
                None => self.unarmed_arc(block, target, named),
            }
        } else if named != AxisMask::NONE {
            // A retract along the tool is meant as a rapid.
            let (_, _, normal) = self.state.plane.axes();
            let retract = named == AxisMask(1 << normal);
            self.watch_rapid_after_arc(block, false, explicit.is_some() || retract);
            if arc_code {
                self.report_line_for_arc(block);
            }
            self.straight(block, target, named);
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

    /// A straight move by the motion in force.
    pub(super) fn straight(&mut self, block: &Block, target: Position, named: AxisMask) {
        let motion = self.moved_to(target, named);
        if self.state.motion == Motion::Rapid {
            if self.state.incremental && named == AxisMask(1 << 2) {
                self.check_clearance_in_incremental(block, &motion);
            }
            let path = self.control.parameters.rapid;
            self.emit(CommandKind::Rapid { motion, path });
        } else {
            self.check_rotary(block, &motion);
            let feed = self.feed_for(block, &motion, None);
            self.emit(CommandKind::Line { motion, feed });
        }
    }

    /// A rapid of Z alone in G91 by as much as Z was when G91 came into force, away from there: the height
    /// itself, in G90, was likely meant.
    #[cold]
    fn check_clearance_in_incremental(&mut self, block: &Block, motion: &Move) {
        let begun = self.state.incremental_from[2];
        let lift = motion.to[2] - motion.from[2];
        // From below it ends where a program in G91 may mean to end.
        if begun <= 0.0 || (lift - begun).abs() > 1e-9 || motion.to[2] < begun + 1e-9 {
            return;
        }
        let (lift, end) = (self.length_text(lift), self.length_text(motion.to[2]));
        self.report(
            Diagnostic::new(
                Code::ClearanceInIncremental,
                self.span(block.range),
                format!("G91 is active: Z moves up by {lift} to {end}"),
            )
            .label("a distance, not a height")
            .note(format!(
                "G91 became active at Z {lift}: all cuts after that are {lift} higher than their Z words"
            ))
            .help("write G90 before it if the height is meant"),
        );
    }

    /// Moves the state to a point of program coordinates.
    #[inline]
    pub(super) fn moved_to(&mut self, target: Position, named: AxisMask) -> Move {
        let from_known = self.state.known;
        let offset_known = self.state.offsets.known();
        self.state.known = from_known.or(named);
        // An axis that was placed in program coordinates stands at a known machine place
        // only where the offset is known.
        let machine = self.state.machine_known;
        self.state.machine_known = machine.without(named).or(named.and(offset_known));
        let from = std::mem::replace(&mut self.state.position, target);
        Move { from, to: target, from_known, to_known: self.state.known }
    }

    /// The feed of a cutting move, with its checks.
    #[inline]
    pub(super) fn feed_for(
        &mut self,
        block: &Block,
        motion: &Move,
        shape: Option<&ArcShape>,
    ) -> Feed {
        let state = &self.state;
        let angular = state.feed_mode == FeedMode::PerTime && motion.only_turns(shape);
        let value = if angular { state.feed_angular } else { state.feed };
        let feed = Feed {
            value,
            mode: state.feed_mode,
            along: FeedAlong::Path,
            spindle_rev_per_s: state.rpm / 60.0,
        };
        let each_block = state.feed_mode == FeedMode::InverseTime && !block.letters().has(b'F');
        // No F at all is a NaN, which is not above zero either.
        let has_feed = value > 0.0;
        if !has_feed || each_block {
            self.report_missing_feed(block);
        }
        if self.state.spindle == SpindleState::Off {
            self.report_spindle_stopped(block);
        }
        if let Some(word) = self.state.feed_over {
            self.check_feed_limit(word, &feed, angular);
        }
        feed
    }

    #[cold]
    fn report_missing_feed(&mut self, block: &Block) {
        let inverse = self.state.feed_mode == FeedMode::InverseTime;
        if self.told.missing_feed && !inverse {
            return;
        }
        self.told.missing_feed = true;
        let zero = self.state.feed == 0.0;
        let message = match (inverse, zero) {
            (true, _) => "in inverse time (G93) every cutting block needs its own F",
            (_, true) => "a cutting move at feed zero",
            _ => "a cutting move before the first feed",
        };
        let span = self.span(block.range);
        self.report(
            Diagnostic::new(Code::MissingFeed, span, message)
                .label(if zero { "F is zero" } else { "no F in this block or before it" })
                .help("put an F word into this block"),
        );
    }

    #[cold]
    pub(super) fn report_spindle_stopped(&mut self, block: &Block) {
        if self.told.spindle_for_tool == Some(self.state.tool) {
            return;
        }
        self.told.spindle_for_tool = Some(self.state.tool);
        let span = self.span(block.range);
        let tool = self.state.tool;
        let with = if tool == 0 { String::new() } else { format!(" with tool {tool}") };
        self.report(
            Diagnostic::new(
                Code::SpindleStopped,
                span,
                format!("a cutting move{with}, and the spindle does not turn"),
            )
            .label("the first cut without a spindle")
            .help("start the spindle (S… M3) before the first cut"),
        );
    }

    fn check_rotary(&mut self, block: &Block, motion: &Move) {
        let limit = self.control.parameters.max_rotary_per_block_rad;
        if limit == f64::INFINITY {
            return;
        }
        for axis in 3..6 {
            let turn = (motion.to[axis] - motion.from[axis]).abs();
            if turn > limit * (1.0 + 1e-12) {
                let letter = b"XYZABC"[axis];
                let span = self.words_span(block, Letters(1 << (letter - b'A')));
                self.report(
                    Diagnostic::new(
                        Code::RotaryOverLimit,
                        span,
                        format!(
                            "{} turns {} degrees in one block; this control allows {}",
                            letter as char,
                            super::values::trim(turn.to_degrees(), 3),
                            super::values::trim(limit.to_degrees(), 3),
                        ),
                    )
                    .help("divide the move into several blocks"),
                );
            }
        }
    }

    /// F.
    pub(super) fn take_feed(&mut self, block: &Block) {
        let Some(word) = block.last(b'F').copied() else { return };
        let Some(number) = self.literal(&word) else { return };
        let parameters = &self.control.parameters;
        let (factor, mut extra) = match self.state.units {
            Units::Inch => (254, 1),
            Units::Millimetre => (1, 0),
        };
        if !number.has_point && self.state.units == Units::Inch {
            extra += parameters.feed_digits_inch;
        }
        let per_minute = number.times(factor, extra);
        let plain = number.to_f64();
        let (feed, angular) = match self.state.feed_mode {
            FeedMode::PerTime => (per_minute / 60.0, plain.to_radians() / 60.0),
            FeedMode::InverseTime => (plain / 60.0, plain / 60.0),
            FeedMode::PerRevolution => (per_minute, per_minute),
        };
        self.state.feed = feed;
        self.state.feed_angular = angular;
        if feed > 0.0 {
            self.told.missing_feed = false;
        }
        self.emit(CommandKind::FeedRate { value: feed, mode: self.state.feed_mode });
        let limits = &self.machine.feed;
        let over = self.state.feed_mode == FeedMode::PerTime
            && (is_over(feed, limits.max_mm_per_s) || is_over(angular, limits.max_rad_per_s));
        self.state.feed_over = over.then(|| self.span(word.range));
        if feed < 0.0 {
            self.report(
                Diagnostic::new(
                    Code::BadWordValue,
                    self.span(word.range),
                    format!("a feed cannot be negative: F{number}"),
                )
                .help("remove the sign"),
            );
        }
    }

    /// Holds a feed that is too large for lengths or for angles against the move that is made with it.
    #[cold]
    fn check_feed_limit(&mut self, word: Span, feed: &Feed, angular: bool) {
        let limits = self.machine.feed;
        let max = if angular { limits.max_rad_per_s } else { limits.max_mm_per_s };
        if feed.mode == FeedMode::PerTime
            && let Some(max) = max
            && is_over(feed.value, Some(max))
        {
            self.state.feed_over = None;
            self.report_feed_over(word, feed.value, max, angular);
        }
    }

    #[cold]
    pub(super) fn report_feed_over(&mut self, word: Span, feed: f64, max: f64, angular: bool) {
        let shown = |per_s: f64| match self.state.units {
            _ if angular => {
                format!("{} deg/min", super::values::trim(per_s.to_degrees() * 60.0, 0))
            }
            Units::Inch => format!("{} in/min", super::values::trim(per_s * 60.0 / 25.4, 1)),
            Units::Millimetre => format!("{} mm/min", super::values::trim(per_s * 60.0, 0)),
        };
        let (is, allowed) = (shown(feed), shown(max));
        let name = self.machine.name.clone();
        let key = if angular { "max_rotary" } else { "max" };
        self.report(
            Diagnostic::new(
                Code::FeedOverLimit,
                word,
                format!("a feed of {is} is above the {allowed} that {name} allows"),
            )
            .label(format!("at most {allowed}"))
            .help(format!(
                "program {allowed} or less, or raise `[feed] {key}` in the machine file"
            )),
        );
    }
}

/// Above a limit, which rounding does not make it.
pub(super) fn is_over(feed: f64, max: Option<f64>) -> bool {
    max.is_some_and(|max| feed > max * (1.0 + 1e-9))
}
