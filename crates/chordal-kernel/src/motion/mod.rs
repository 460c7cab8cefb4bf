//! Straight moves, and the feed of cuts.

mod arc;
mod corner;
mod great_circle;
mod reference;
mod rotary_feed;
mod spiral;
mod spline;
mod thread;
mod vanishing_circle;

use chordal_command::{
    ArcShape, AxisMask, CommandKind, Feed, FeedAlong, FeedMode, Move, Position, RapidPath,
    SpindleState, Units, telling_number,
};
use chordal_diagnostics::{Code, Diagnostic, Span};
use chordal_machine::{AXES, Axis};

pub use arc::{ArcWords, MisfitArc};
pub use spiral::SpiralWords;

use crate::kernel::Kernel;
use crate::rules::RapidFeed;
use crate::state::ModalMotion;
use crate::statement::{Statement, WordMeaning};

impl Kernel<'_> {
    /// Makes a straight move in the active motion mode: a rapid under G0, else a cut.
    pub fn straight(&mut self, at: &dyn Statement, target: Position, named: AxisMask) {
        let motion = self.moved_to(target, named);
        if self.state.motion == ModalMotion::Rapid {
            if self.state.incremental && named == AxisMask(1 << 2) {
                self.check_clearance_in_incremental(at, &motion);
            }
            let path = self.path_of_rapid();
            self.emit(CommandKind::Rapid { motion, path });
            if self.state.surface_speed.is_some() && motion.from[0] != motion.to[0] {
                self.follow_diameter();
            }
        } else if self.has_plain_feed(&motion) {
            // Most of the blocks of a program. Their feed is written where the command is made, which is faster than
            // a feed that a call returns.
            let state = &self.state;
            let feed = Feed {
                value: state.feed.unwrap_or(f64::NAN),
                mode: FeedMode::PerTime,
                along: FeedAlong::Path,
                spindle_rev_per_s: state.rpm / 60.0,
                lead_change: 0.0,
                surface: None,
            };
            self.emit(CommandKind::Line { motion, feed });
        } else {
            self.straight_cut(at, motion);
        }
    }

    /// Whether the feed of a straight cut is F per time along X, Y and Z with a spindle that turns, and there is nothing
    /// to check: what [`Kernel::feed_for`] returns then.
    #[inline]
    fn has_plain_feed(&self, motion: &Move) -> bool {
        let state = &self.state;
        state.feed_mode == FeedMode::PerTime
            && state.feed.is_some_and(|feed| feed > 0.0)
            && state.feed_over.is_none()
            && state.spindle != SpindleState::Off
            && state.rpm != 0.0
            && state.live.is_none()
            && state.surface_speed.is_none()
            && motion.from[3..] == motion.to[3..]
    }

    /// A straight cut with any feed.
    #[inline(never)]
    fn straight_cut(&mut self, at: &dyn Statement, motion: Move) {
        self.check_rotary(at, &motion);
        let feed = self.feed_for(at, &motion, None);
        self.emit(CommandKind::Line { motion, feed });
    }

    /// The path of a G0, with its speed on controls where G0 has one.
    pub(crate) fn path_of_rapid(&self) -> RapidPath {
        let speed = match self.rules.rapid_feed {
            RapidFeed::OfMachine => None,
            RapidFeed::Programmed => self.state.feed,
            RapidFeed::Fixed(speed) => Some(speed),
        };
        match speed.filter(|speed| *speed > 0.0) {
            Some(speed) => RapidPath::AtFeed(speed),
            // The axes go together, so that the tip goes straight.
            None if self.state.part_frame.is_some() => RapidPath::Straight,
            None => self.rules.rapid,
        }
    }

    /// Reports a rapid of Z alone in G91 by the height at which G91 became active: that height, in G90, was
    /// probably meant.
    #[cold]
    fn check_clearance_in_incremental(&mut self, at: &dyn Statement, motion: &Move) {
        let begun = self.state.incremental_from[2];
        let lift = motion.to[2] - motion.from[2];
        // From below that height, the end may be intended in G91.
        if begun <= 0.0 || (lift - begun).abs() > 1e-9 || motion.to[2] < begun + 1e-9 {
            return;
        }
        let (lift, end) = (self.length_text(lift), self.length_text(motion.to[2]));
        self.report(
            Diagnostic::new(
                Code::ClearanceInIncremental,
                at.span(),
                format!("G91 is active: Z moves up by {lift} to {end}"),
            )
            .label("a distance, not a height")
            .note(format!(
                "G91 became active at Z {lift}: all cuts after that are {lift} higher than their Z words"
            ))
            .help("write G90 before it if the height is meant"),
        );
    }

    /// Moves the state to a point of program coordinates and returns the move; `named` are the axes whose target
    /// is known.
    #[inline]
    pub fn moved_to(&mut self, target: Position, named: AxisMask) -> Move {
        let from_known = self.state.known;
        let offset_known = self.state.offsets.known();
        self.state.known = from_known.or(named).without(self.state.astray);
        // An axis that was moved in program coordinates has a known machine position only if the
        // offset is known.
        let machine = self.state.machine_known;
        let (moved, placed) = match self.state.frames.is_plain() {
            true => (named, named),
            false => {
                let map = self.state.frames.map();
                let moved = map.reached(named);
                (moved, moved.and(map.known(self.state.known)))
            }
        };
        let placed = placed.without(self.state.astray);
        let left = placed.and(offset_known).without(self.state.start.program);
        self.state.start.machine = self.state.start.machine.without(left);
        self.state.machine_known = machine.without(moved).or(placed.and(offset_known));
        self.state.control_position = None;
        let from = std::mem::replace(&mut self.state.position, target);
        if self.state.part_frame.is_some() {
            self.moved_on_part(&from);
        }
        Move { from, to: target, from_known, to_known: self.state.known }
    }

    /// The feed of a cutting move; checks F and the spindle.
    #[inline(always)]
    pub fn feed_for(
        &mut self,
        at: &dyn Statement,
        motion: &Move,
        shape: Option<&ArcShape>,
    ) -> Feed {
        let state = &self.state;
        let angular = state.feed_mode == FeedMode::PerTime && motion.only_turns(shape);
        let value = if angular { state.feed_angular } else { state.feed };
        // A missing F becomes NaN, which fails `> 0` like zero.
        let value = value.unwrap_or(f64::NAN);
        let (spindle_rev_per_s, surface) = self.spindle_of_feed(motion.from[0]);
        let is_on_part = self.state.part_frame.is_some();
        let (value, along) =
            match is_on_part || motion.from[3..] == motion.to[3..] || shape.is_some() {
                true => (value, FeedAlong::Path),
                false => self.rotary_feed(at, motion, value),
            };
        let state = &self.state;
        let feed = Feed {
            value,
            mode: state.feed_mode,
            along,
            spindle_rev_per_s,
            lead_change: 0.0,
            surface,
        };
        let each_block = state.feed_mode == FeedMode::InverseTime && !at.has_feed();
        let has_feed = value > 0.0;
        if !has_feed && !state.unknown.feed || each_block {
            self.report_missing_feed(at);
        }
        if self.turning() == SpindleState::Off
            || self.state.rpm == 0.0 && self.turns_without_speed()
        {
            self.report_spindle_stopped(at);
        }
        if let Some(word) = self.state.feed_over {
            self.check_feed_limit(word, (motion, shape), &feed, angular);
        }
        feed
    }

    /// True when the spindle was started without an S, on a control where the operator does not set the speed.
    #[cold]
    pub(crate) fn turns_without_speed(&self) -> bool {
        let state = &self.state;
        let known = state.live.is_none() && state.surface_speed.is_none() && !state.unknown.speed;
        known && !self.rules.speed_by_hand
    }

    #[cold]
    fn report_missing_feed(&mut self, at: &dyn Statement) {
        let inverse = self.state.feed_mode == FeedMode::InverseTime;
        if self.reported.missing_feed && !inverse {
            return;
        }
        self.reported.missing_feed = true;
        let zero = self.state.feed == Some(0.0);
        let message = match (inverse, zero) {
            (true, _) => "in inverse time (G93) every cutting block needs its own F",
            (_, true) => "a cutting move at feed zero",
            _ => "a cutting move before the first feed",
        };
        let span = at.span();
        self.report(
            Diagnostic::new(Code::MissingFeed, span, message)
                .label(if zero { "F is zero" } else { "no F in this block or before it" })
                .help("put an F word into this block"),
        );
    }

    /// Reports a cut with the spindle stopped, once for each tool.
    #[cold]
    pub fn report_spindle_stopped(&mut self, at: &dyn Statement) {
        if self.rules.spindle_by_hand || self.reported.spindle_for_tool == Some(self.state.tool) {
            return;
        }
        self.reported.spindle_for_tool = Some(self.state.tool);
        let span = at.span();
        let tool = self.state.tool;
        let with = if tool == 0 { String::new() } else { format!(" with tool {tool}") };
        let (why, help) = match self.turning() {
            SpindleState::Off => {
                ("the spindle does not turn", "start the spindle (S… M3) before the first cut")
            }
            _ => ("the spindle has no speed", "write S into the block that starts the spindle"),
        };
        self.report(
            Diagnostic::new(Code::SpindleStopped, span, format!("a cutting move{with}, and {why}"))
                .label("the first cut without a spindle")
                .help(help),
        );
    }

    fn check_rotary(&mut self, at: &dyn Statement, motion: &Move) {
        let limit = self.rules.max_rotary_per_block_rad;
        if limit == f64::INFINITY {
            return;
        }
        for axis in 3..AXES {
            let turn = (motion.to[axis] - motion.from[axis]).abs();
            if turn > limit * (1.0 + 1e-12) {
                let letter = Axis::ALL[axis].letter();
                let span = at.words(WordMeaning::Axes(AxisMask(1 << axis)));
                self.report(
                    Diagnostic::new(
                        Code::RotaryOverLimit,
                        span,
                        format!(
                            "{} turns {} degrees in one block; this control allows {}",
                            letter,
                            telling_number(turn.to_degrees(), 3),
                            telling_number(limit.to_degrees(), 3),
                        ),
                    )
                    .help("divide the move into several blocks"),
                );
            }
        }
    }

    /// Compares a feed that may be too large with the limit that applies to the move: of lengths or of angles.
    #[cold]
    fn check_feed_limit(
        &mut self,
        word: Span,
        (motion, shape): (&Move, Option<&ArcShape>),
        feed: &Feed,
        angular: bool,
    ) {
        let limits = self.machine.feed;
        let max = if angular { limits.max_rad_per_s } else { limits.max_mm_per_s };
        match (feed.mode, max) {
            (FeedMode::PerTime, Some(max)) if is_over(feed.value, Some(max)) => {
                self.state.feed_over = None;
                self.report_feed_over(word, feed.value, max, angular);
            }
            (FeedMode::PerRevolution, _) => self.check_feed_per_turn(word, motion, shape, feed),
            (FeedMode::PerTime | FeedMode::InverseTime, _) => {}
        }
    }

    /// Reports a feed above a limit of the machine, both in mm/s or rad/s.
    #[cold]
    pub fn report_feed_over(&mut self, word: Span, feed: f64, max: f64, angular: bool) {
        let shown = |per_s: f64| match self.state.units {
            _ if angular => {
                format!("{} deg/min", telling_number(per_s.to_degrees() * 60.0, 0))
            }
            Units::Inch => format!("{} in/min", telling_number(per_s * 60.0 / 25.4, 1)),
            Units::Millimetre => format!("{} mm/min", telling_number(per_s * 60.0, 0)),
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

    /// Makes a rapid, whatever motion is active.
    pub fn rapid(&mut self, target: Position, named: AxisMask) {
        let motion = self.moved_to(target, named);
        let path = self.rules.rapid;
        self.emit(CommandKind::Rapid { motion, path });
    }

    /// Makes a rapid unless the position is already reached.
    pub fn rapid_to(&mut self, target: Position, named: AxisMask) {
        if target == self.state.position {
            self.state.control_position = None;
            self.state.known = self.state.known.or(named).without(self.state.astray);
            return;
        }
        self.rapid(target, named);
    }

    /// Makes a straight cut at the active feed, whatever motion is active.
    pub fn line(&mut self, at: &dyn Statement, target: Position, named: AxisMask) {
        let motion = self.moved_to(target, named);
        let feed = self.feed_for(at, &motion, None);
        self.emit(CommandKind::Line { motion, feed });
    }

    /// An F whose value is not known.
    pub fn set_unknown_feed(&mut self) {
        (self.state.feed, self.state.feed_angular) = (None, None);
        (self.state.feed_over, self.state.unknown.feed) = (None, true);
    }

    /// Axes move to a position that is not known.
    pub fn go_astray(&mut self, axes: AxisMask) {
        let state = &mut self.state;
        state.known = state.known.without(axes);
        state.machine_known = state.machine_known.without(axes);
        state.astray = state.astray.or(axes);
    }

    /// Sets F: in the unit of the active feed mode (mm/s, mm per revolution, 1/s), and as rad/s for moves of
    /// rotary axes alone.
    pub fn set_feed(&mut self, word: Span, feed: f64, angular: f64) {
        self.state.feed = Some(feed);
        self.state.feed_angular = Some(angular);
        self.state.unknown.feed = false;
        if feed > 0.0 {
            self.reported.missing_feed = false;
        }
        self.emit(CommandKind::FeedRate { value: feed, mode: self.state.feed_mode });
        let limits = &self.machine.feed;
        let over = match self.state.feed_mode {
            FeedMode::PerTime => {
                is_over(feed, limits.max_mm_per_s) || is_over(angular, limits.max_rad_per_s)
            }
            // Only known with the spindle speed of the next cut.
            FeedMode::PerRevolution => true,
            FeedMode::InverseTime => false,
        };
        self.state.feed_over = over.then_some(word);
    }
}

/// True above a limit by more than rounding; false without a limit.
pub fn is_over(feed: f64, max: Option<f64>) -> bool {
    max.is_some_and(|max| feed > max * (1.0 + 1e-9))
}
