//! Arcs and helices: the centre in all its forms, R, full circles, turns, mismatch.

use chordal_diagnostics::{Code, Diagnostic, Severity};
use chordal_geometry::{
    ArcFit, Direction, Plane, RadiusError, Vec3, arc_from_center, center_from_radius,
};
use chordal_syntax::{Block, Letters, Word};

use super::Interpreter;
use super::values::trim;
use crate::command::{ArcShape, AxisMask, CommandKind, FeedAlong, Position, Side};
use crate::parameters::{
    ArcCenter, ArcMismatch, CenterAndRadius, FullCircleByRadius, OmittedCenter, SpiralForm,
};
use crate::state::Motion;
use crate::table::{ArcTurns, MotionModality};

const CENTER: Letters = Letters::of("IJK");

/// Centre letters by axis.
const CENTER_LETTERS: [u8; 3] = *b"IJK";

/// The spatial part of a position.
#[inline]
pub(super) fn point(position: &Position) -> Vec3 {
    Vec3::new(position[0], position[1], position[2])
}

/// The letters of the plane's centre words.
pub(super) fn center_letters(plane: Plane) -> (u8, u8, u8) {
    let (a, b, normal) = plane.axes();
    (CENTER_LETTERS[a], CENTER_LETTERS[b], CENTER_LETTERS[normal])
}

/// Name of a plane for people, with its code.
pub(super) fn plane_name(plane: Plane) -> &'static str {
    match plane {
        Plane::Xy => "G17, the XY plane",
        Plane::Zx => "G18, the ZX plane",
        Plane::Yz => "G19, the YZ plane",
    }
}

impl Interpreter<'_> {
    /// The word that gives the radius: R, or R0 where R names registers.
    pub(super) fn radius_word(&self, block: &Block) -> Option<Word> {
        if self.control.table.lexicon.registers {
            block.all(b'R').find(|word| word.register == Some(0)).copied()
        } else {
            block.last(b'R').copied()
        }
    }

    /// A block whose motion is an arc: by centre, by radius, or a spiral of the control.
    pub(super) fn arc_block(
        &mut self,
        block: &Block,
        direction: Direction,
        mut target: Position,
        named: AxisMask,
        explicit: bool,
    ) {
        let letters = block.letters();
        let (a_letter, b_letter, normal_letter) = center_letters(self.state.plane);
        let has_center = letters.has(a_letter) || letters.has(b_letter);
        let radius = if letters.has(b'R') { self.radius_word(block) } else { None };
        self.snap_to_start(&mut target);
        if self.is_spiral_of_type_two(block, &target) {
            return self.spiral_of_type_two(block, direction, target, named);
        }
        let outside = letters.has(normal_letter) && self.check_height_word(block);
        if has_center && radius.is_some() && !self.center_and_radius(block) {
            return self.straight_instead(block, target, named);
        }
        let turns = self.extra_turns(block, radius.is_some());
        match radius {
            Some(word) => self.arc_by_radius(block, &word, direction, target, named, turns),
            None if has_center => {
                let center = self.center(block);
                self.arc_by_center(block, direction, target, named, center, turns);
            }
            None => {
                // Without that word nothing is left of the centre: one problem, not two.
                if !outside {
                    self.report_no_center(block, explicit);
                }
                self.straight_instead(block, target, named);
            }
        }
    }

    /// An end that misses the start by rounding only is the start: a full circle.
    #[inline]
    pub(super) fn snap_to_start(&self, target: &mut Position) {
        let (a, b, _) = self.state.plane.axes();
        let from = &self.state.position;
        let (da, db) = (target[a] - from[a], target[b] - from[b]);
        let near = self.control.parameters.coincidence_mm;
        if da * da + db * db < near * near {
            target[a] = from[a];
            target[b] = from[b];
        }
    }

    /// The centre on the plane's axes, by the rule in force.
    pub(super) fn center(&mut self, block: &Block) -> (f64, f64) {
        let (a, b, _) = self.state.plane.axes();
        let (a_letter, b_letter, _) = center_letters(self.state.plane);
        let start = (self.state.position[a], self.state.position[b]);
        let given = (self.length_of(block, a_letter), self.length_of(block, b_letter));
        match self.state.arc_center {
            ArcCenter::FromStart => {
                (start.0 + given.0.unwrap_or(0.0), start.1 + given.1.unwrap_or(0.0))
            }
            ArcCenter::FromCenter => {
                (start.0 - given.0.unwrap_or(0.0), start.1 - given.1.unwrap_or(0.0))
            }
            ArcCenter::Absolute => {
                // A zero elsewhere is the start's own coordinate; whether it is here is not known.
                let left_out = match self.control.parameters.omitted_center {
                    OmittedCenter::Start => start,
                    OmittedCenter::Zero => (0.0, 0.0),
                };
                (given.0.unwrap_or(left_out.0), given.1.unwrap_or(left_out.1))
            }
        }
    }

    fn arc_by_center(
        &mut self,
        block: &Block,
        direction: Direction,
        target: Position,
        named: AxisMask,
        center: (f64, f64),
        turns: u32,
    ) {
        let plane = self.state.plane;
        let from = self.state.position;
        let fit =
            arc_from_center(plane, point(&from), point(&target), center, direction, turns, 0.0);
        if fit.radius_start <= self.control.parameters.coincidence_mm {
            self.report_zero_radius(block);
            return self.straight_instead(block, target, named);
        }
        self.check_mismatch(block, &fit);
        self.check_radius_limit(block, fit.radius_start.max(fit.radius_end));
        self.emit_arc(block, center, &fit, target, named);
    }

    fn arc_by_radius(
        &mut self,
        block: &Block,
        word: &Word,
        direction: Direction,
        target: Position,
        named: AxisMask,
        turns: u32,
    ) {
        let Some(radius) = self.length(word) else { return };
        let plane = self.state.plane;
        let (start, end) = (point(&self.state.position), point(&target));
        // A difference of rounding must not decide at the tolerance itself.
        let tolerance = self.control.parameters.semicircle_tolerance(self.state.units) + 1e-9;
        match center_from_radius(plane, start, end, radius, direction, tolerance) {
            Ok(center) => {
                let fit = arc_from_center(plane, start, end, center, direction, turns, 0.0);
                self.check_radius_limit(block, fit.radius_start);
                self.emit_arc(block, center, &fit, target, named);
            }
            Err(RadiusError::FullCircle) => self.full_circle_by_radius(block, word, target, named),
            Err(RadiusError::TooShort { chord, radius, short_by }) => {
                let (chord, radius, needed, short) = (
                    self.length_text(chord),
                    self.length_text(radius),
                    self.length_text(chord / 2.0),
                    self.length_text(short_by),
                );
                let span = self.span(word.range);
                self.report(
                    Diagnostic::new(
                        Code::RadiusTooShort,
                        span,
                        format!(
                            "start and end are {chord} apart; a radius of {radius} does not reach"
                        ),
                    )
                    .label(format!("short by {short}"))
                    .help(format!("the radius must be at least {needed}; check the end point too")),
                );
                self.straight_instead(block, target, named);
            }
            Err(RadiusError::NotFinite) => {}
        }
    }

    fn full_circle_by_radius(
        &mut self,
        block: &Block,
        word: &Word,
        target: Position,
        named: AxisMask,
    ) {
        let span = self.span(word.range);
        let (a, b, _) = center_letters(self.state.plane);
        let by = format!(
            "give the centre with {} or {} and leave the end point out",
            a as char, b as char
        );
        let (what, severity) = match self.control.parameters.full_circle_by_radius {
            FullCircleByRadius::Refused => ("the control refuses it", Severity::Error),
            FullCircleByRadius::NoMotion => ("nothing moves", Severity::Warning),
        };
        self.report(
            Diagnostic::new(
                Code::FullCircleByRadius,
                span,
                format!("start and end are the same point: a radius gives no circle, and {what}"),
            )
            .severity(severity)
            .help(by),
        );
        if self.control.parameters.full_circle_by_radius == FullCircleByRadius::Refused {
            self.straight_instead(block, target, named);
        }
    }

    /// P on an arc, as turns beside the arc's own.
    fn extra_turns(&mut self, block: &Block, by_radius: bool) -> u32 {
        let rule = self.control.table.arc_turns;
        if rule == ArcTurns::None || !block.letters().has(b'P') {
            return 0;
        }
        if rule == ArcTurns::Extra && by_radius {
            // A radius fixes an arc of less than a turn.
            if let Some(word) = block.word(b'P').copied() {
                self.unused_word(&word);
            }
            return 0;
        }
        let turns = self.count_of(block, b'P').unwrap_or(0).min(9999);
        match rule {
            ArcTurns::Total => turns.saturating_sub(1),
            _ => turns,
        }
    }

    /// Emits the arc, or the arc and the straight rest where the control does that.
    pub(super) fn emit_arc(
        &mut self,
        block: &Block,
        center: (f64, f64),
        fit: &ArcFit,
        target: Position,
        named: AxisMask,
    ) {
        let error = fit.radius_error().abs();
        let parameters = &self.control.parameters;
        let rest = parameters.arc_mismatch == ArcMismatch::ArcThenLine
            && error > parameters.coincidence_mm
            && error <= parameters.radius_error_tolerance_mm;
        let plane = self.state.plane;
        let mut shape = ArcShape {
            plane,
            center: [center.0, center.1],
            sweep: fit.sweep,
            radius_from: fit.radius_start,
            radius_to: fit.radius_end,
        };
        let mut arc_end = target;
        if rest {
            // Where the arc with the start's radius meets the ray of the programmed end.
            let (a, b, _) = plane.axes();
            let scale = fit.radius_start / fit.radius_end;
            arc_end[a] = center.0 + (target[a] - center.0) * scale;
            arc_end[b] = center.1 + (target[b] - center.1) * scale;
            shape.radius_to = fit.radius_start;
        }
        self.check_rotary_in_arc(block, &target);
        let motion = self.moved_to(arc_end, named);
        let mut feed = self.feed_for(block, &motion, Some(&shape));
        feed.along = self.feed_along(&motion, plane);
        self.emit(CommandKind::Arc { motion, shape, feed });
        if rest {
            let motion = self.moved_to(target, named);
            feed.along = FeedAlong::Path;
            self.emit(CommandKind::Line { motion, feed });
        }
    }

    /// F of a helix; a flat arc is the same either way.
    pub(super) fn feed_along(&self, motion: &crate::command::Move, plane: Plane) -> FeedAlong {
        let (_, _, normal) = plane.axes();
        if motion.from[normal] == motion.to[normal] {
            FeedAlong::Path
        } else {
            self.control.parameters.helix_feed
        }
    }

    /// An arc that cannot be made still brings the tool to its end.
    pub(super) fn straight_instead(&mut self, block: &Block, target: Position, named: AxisMask) {
        if target == self.state.position {
            return;
        }
        let rapid = self.state.motion == Motion::Rapid;
        let armed = self.control.table.motion == MotionModality::Armed;
        if rapid && armed {
            return self.straight(block, target, named);
        }
        let motion = self.moved_to(target, named);
        let feed = self.feed_for(block, &motion, None);
        self.emit(CommandKind::Line { motion, feed });
    }

    #[inline]
    fn check_mismatch(&mut self, block: &Block, fit: &ArcFit) {
        let p = &self.control.parameters;
        let error = fit.radius_error().abs();
        // A difference of rounding must not decide at the tolerance itself.
        if error <= p.radius_error_tolerance_mm * (1.0 + 1e-9) {
            return;
        }
        let by_radius = p.radius_error_relative > 0.0
            && error <= p.radius_error_limit_mm
            && error <= p.radius_error_relative * fit.radius_start.max(fit.radius_end);
        if !by_radius {
            self.report_mismatch(block, fit);
        }
    }

    #[cold]
    fn report_mismatch(&mut self, block: &Block, fit: &ArcFit) {
        let (a, b, _) = self.state.plane.axes();
        let letters = b"XYZ";
        let mut words = CENTER;
        words.insert(letters[a]);
        words.insert(letters[b]);
        let span = self.words_span(block, words);
        let error = self.length_text(fit.radius_error().abs());
        let allowed = self.length_text(self.control.parameters.radius_error_tolerance_mm);
        let (from, to) = (self.length_text(fit.radius_start), self.length_text(fit.radius_end));
        let place = if fit.radius_end > fit.radius_start { "outside" } else { "inside" };
        let alarm = self.alarm_text(Code::RadiusMismatch, Some(error.clone()));
        let mut diagnostic = Diagnostic::new(
            Code::RadiusMismatch,
            span,
            format!("the end is {error} off the arc; this control allows {allowed}"),
        )
        .label(format!("radius {from} at the start, {to} at the end"))
        .note(format!("the end lies {place} the circle through the start"))
        .help(
            "check the end point and the centre words of this block, and the end point of the \
             block before, where the arc starts",
        );
        diagnostic.alarm = alarm;
        if let Some(hint) = self.center_hint(block, fit) {
            diagnostic = diagnostic.note(hint);
        }
        self.report(diagnostic);
    }

    /// Says when the same words make a true arc under another rule for the centre.
    fn center_hint(&mut self, block: &Block, fit: &ArcFit) -> Option<String> {
        let in_force = self.state.arc_center;
        let end = {
            let (a, b, _) = self.state.plane.axes();
            let kept = self.state.incremental;
            let (target, _) = self.target(block);
            self.state.incremental = kept;
            (target[a], target[b])
        };
        let start = {
            let (a, b, _) = self.state.plane.axes();
            (self.state.position[a], self.state.position[b])
        };
        let rules = [
            (ArcCenter::FromStart, "from the start to the centre"),
            (ArcCenter::Absolute, "as the centre's coordinates"),
            (ArcCenter::FromCenter, "from the centre to the start"),
        ];
        for (rule, words) in rules {
            if rule == in_force {
                continue;
            }
            self.state.arc_center = rule;
            let center = self.center(block);
            self.state.arc_center = in_force;
            let radius =
                |p: (f64, f64)| ((p.0 - center.0).powi(2) + (p.1 - center.1).powi(2)).sqrt();
            let (from, to) = (radius(start), radius(end));
            if from > 1e-6 && (from - to).abs() < 0.01 * fit.radius_error().abs() {
                return Some(format!(
                    "the radii agree ({}) when the centre words are read {words}",
                    { self.length_text(from) }
                ));
            }
        }
        None
    }

    fn check_radius_limit(&mut self, block: &Block, radius: f64) {
        let parameters = &self.control.parameters;
        let compensated = self.state.side != Side::Off;
        let limit = if compensated {
            parameters.max_radius_compensated_mm
        } else {
            parameters.max_radius_mm
        };
        if radius <= limit * (1.0 + 1e-9) {
            return;
        }
        let (is, allowed) = (self.length_text(radius), self.length_text(limit));
        let with = if compensated { " with cutter compensation" } else { "" };
        let span = self.words_span(block, Letters::of("IJKR"));
        self.report(
            Diagnostic::new(
                Code::RadiusOverLimit,
                span,
                format!("a radius of {is} is above the {allowed} that this control allows{with}"),
            )
            .label(format!("at most {allowed}"))
            .help("program it as lines, or with arcs of a smaller radius"),
        );
    }

    fn report_zero_radius(&mut self, block: &Block) {
        let span = self.words_span(block, CENTER);
        self.report(
            Diagnostic::new(Code::ZeroRadius, span, "the centre of this arc is its start point")
                .label("these words place it there")
                .help(match self.state.arc_center {
                    ArcCenter::FromStart => "give the distance from the start to the centre",
                    ArcCenter::Absolute => "give the coordinates of the centre",
                    ArcCenter::FromCenter => "give the distance from the centre to the start",
                }),
        );
    }

    /// A centre word outside the plane. Controls with cones know it as their height word: outside a cone
    /// it is passed over, and a zero, as posts write it, says nothing.
    /// True where it was reported as an error.
    pub(super) fn check_height_word(&mut self, block: &Block) -> bool {
        let (_, _, letter) = center_letters(self.state.plane);
        let Some(word) = block.last(letter) else { return false };
        let strict = self.control.table.strict_center_words;
        if !strict && self.is_zero(word) {
            return false;
        }
        let passed_over = !strict && self.control.parameters.spiral != SpiralForm::None;
        let severity = if passed_over { Severity::Warning } else { Severity::Error };
        let plane = self.state.plane;
        let (a, b, _) = center_letters(plane);
        let span = self.words_span(block, Letters(1 << (letter - b'A')));
        self.report(
            Diagnostic::new(
                Code::CenterOutsidePlane,
                span,
                format!("{} does not belong to {}", letter as char, plane_name(plane)),
            )
            .severity(severity)
            .label(format!("only {} and {} here", a as char, b as char))
            .help("remove the word, or choose the plane with G17, G18 or G19"),
        );
        !passed_over
    }

    /// A rotary axis in the block of an arc, on a control that does not turn it there.
    pub(super) fn check_rotary_in_arc(&mut self, block: &Block, target: &Position) {
        let turns = target[3..] != self.state.position[3..];
        if self.control.parameters.rotary_in_arc || !turns {
            return;
        }
        let title = self.control.table.title;
        let span = self.words_span(block, Letters::of("ABC"));
        self.report(
            Diagnostic::new(
                Code::RotaryInArc,
                span,
                format!("a rotary axis in the block of an arc: {title} does not turn it there"),
            )
            .label("shown turning with the arc")
            .help("turn it in a block before; if this machine turns it with the arc, set `rotary_in_arc`"),
        );
    }

    /// Both a centre and a radius: true when R is followed.
    fn center_and_radius(&mut self, block: &Block) -> bool {
        let wins = self.control.parameters.center_and_radius == CenterAndRadius::RadiusWins;
        let span = self.words_span(block, Letters::of("IJKR"));
        let (what, severity) = if wins {
            ("R is followed", Severity::Warning)
        } else {
            ("the control refuses the block", Severity::Error)
        };
        self.report(
            Diagnostic::new(
                Code::CenterAndRadius,
                span,
                format!("this arc has both a centre and a radius; {what}"),
            )
            .severity(severity)
            .help("keep one of them"),
        );
        wins
    }

    fn report_no_center(&mut self, block: &Block, explicit: bool) {
        let span = self.span(block.range);
        let (a, b, _) = center_letters(self.state.plane);
        let message = if explicit {
            "this arc has neither a centre nor a radius"
        } else {
            "an arc is active from a block before, and this block has neither centre nor radius"
        };
        self.report(
            Diagnostic::new(Code::NoCenter, span, message)
                .label("shown as a straight line")
                .help(format!("give {} and {} or R, or write G1 for a line", a as char, b as char)),
        );
    }

    /// Fadal: G2 or G3 in a block without a centre is a line.
    pub(super) fn report_line_for_arc(&mut self, block: &Block) {
        let span = self.words_span(block, Letters::of("G"));
        let rapid = self.state.motion == Motion::Rapid;
        let message = if rapid {
            "G2 or G3 without a centre, and G0 is active: this control makes a rapid"
        } else {
            "G2 or G3 without a centre: this control makes a straight line"
        };
        let mut diagnostic = Diagnostic::new(Code::NoCenter, span, message)
            .severity(Severity::Warning)
            .label("no I, J, K or R0 in this block")
            .help(if rapid {
                "give the centre; for a straight cut write G1"
            } else {
                "give the centre, or leave the G code out"
            });
        diagnostic.alarm = None;
        self.report(diagnostic);
    }

    /// Fadal: a block without a code after an arc that was cut while G0 is in force.
    #[cold]
    fn report_rapid_after_arc(&mut self, block: &Block) {
        let span = self.span(block.range);
        self.report(
            Diagnostic::new(
                Code::RapidAfterArc,
                span,
                "this block is a rapid: G0 is still active, because G2 and G3 do not cancel it here",
            )
            .label("no motion code, after an arc")
            .help("write G1 for a cut, G0 for a rapid"),
        );
    }

    /// Notes an arc that is cut while G0 is in force, and the block after it that goes at rapid.
    #[inline]
    pub(super) fn watch_rapid_after_arc(&mut self, block: &Block, arc: bool, meant: bool) {
        let before = self.state.arc_over_rapid;
        self.state.arc_over_rapid = arc && self.state.motion == Motion::Rapid;
        if before && !meant && self.state.motion == Motion::Rapid {
            self.report_rapid_after_arc(block);
        }
    }

    /// Fadal: a centre before any G2 or G3.
    pub(super) fn unarmed_arc(&mut self, block: &Block, target: Position, named: AxisMask) {
        let by_radius = !block.letters().meets(CENTER);
        let span = self.words_span(block, Letters::of("IJKR"));
        let title = self.control.table.title;
        let message = if by_radius {
            "R0 in a move, and no G2 or G3 came before".to_string()
        } else {
            "a centre is given, but no G2 or G3 came before".to_string()
        };
        let mut diagnostic = Diagnostic::new(Code::NoCenter, span, message)
            .label("which direction?")
            .help("write G2 or G3 into this block");
        diagnostic.alarm = Some(if by_radius {
            format!("{title}: I, J, OR K MUST BE SPECIFIED")
        } else {
            let n = self.sequence.map_or("?".to_string(), |number| number.to_string());
            format!("{title}: BAD CIRCLE OR MISSING G AT N={n}")
        });
        self.report(diagnostic);
        if named != AxisMask::NONE {
            self.straight_instead(block, target, named);
        }
    }

    /// Sweep for messages.
    pub(super) fn turns_text(&self, turns: f64) -> String {
        trim(turns, 4)
    }
}
