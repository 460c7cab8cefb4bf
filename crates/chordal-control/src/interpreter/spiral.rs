//! Spirals and cones: Mitsubishi type 1 and type 2, Fanuc's L and Q.
//!
//! With r0 and r1 the distances of start and end from the centre and θ the directed angle
//! from start to end in [0, 2π), the angle of a spiral is θ plus whole turns; the radius
//! goes linearly with the angle. Where the end is the start, G2 and G3 make a full circle, as they
//! do without Q, K or L; G2.1 and G3.1 count every turn in P.

use std::f64::consts::{PI, TAU};

use chordal_diagnostics::{Code, Diagnostic, Severity};
use chordal_geometry::{Direction, arc_from_center};
use chordal_syntax::{Block, Letters};

use super::Interpreter;
use super::arc::{center_letters, point};
use crate::command::{ArcShape, AxisMask, CommandKind, Position};
use crate::parameters::{SpiralForm, SpiralOnRay};

/// Most turns of a spiral (the manuals' 0 to 99).
const MAX_TURNS: u32 = 99;

/// So many least increments off the ray of the start are rounding: half of one for each of the words of
/// the end and of the centre.
const ROUNDED_INCREMENTS: f64 = 1.5;

/// Ends, centre and θ of a spiral block.
struct SpiralEnds {
    center: (f64, f64),
    radius_from: f64,
    radius_to: f64,
    /// Directed angle from start to end in [0, 2π).
    angle: f64,
    /// The end is on the ray of the start, but for the rounding of coordinates to the least increment.
    on_ray: bool,
    /// The end is the start, on the axes of the plane.
    closed: bool,
    direction: Direction,
}

impl SpiralEnds {
    /// The angle with so many whole turns. Rounded coordinates that put the end a little before the ray
    /// of the start do not make a turn more of it.
    fn with_turns(&self, turns: u32) -> f64 {
        let before_ray = self.on_ray && self.angle > PI;
        let beyond = if turns > 0 && before_ray { self.angle - TAU } else { self.angle };
        beyond + TAU * f64::from(turns)
    }
}

impl Interpreter<'_> {
    /// G2.1 and G3.1 with P: the angle is θ + 2πP.
    pub(super) fn spiral_block(
        &mut self,
        block: &Block,
        direction: Direction,
        target: Position,
        named: AxisMask,
    ) {
        if self.control.parameters.spiral != SpiralForm::Pitches {
            let span = self.span(block.range);
            self.report(
                Diagnostic::new(
                    Code::NoSpirals,
                    span,
                    "G2.1 and G3.1 are not spirals with the settings of this machine",
                )
                .help(
                    "this machine writes spirals with G2 and G3 (type 2); see its setting `spiral`",
                ),
            );
            return self.straight_instead(block, target, named);
        }
        let mut target = target;
        self.snap_to_start(&mut target);
        self.check_height_word(block);
        let Some(ends) = self.spiral_ends(block, direction, &target) else {
            return self.straight_instead(block, target, named);
        };
        let turns = match block.letters().has(b'P') {
            true => self.count_of(block, b'P').unwrap_or(0),
            false => 0,
        };
        let turns = self.checked_turns(block, b'P', turns);
        let angle = ends.with_turns(turns);
        self.emit_spiral(block, &ends, angle, target, named, b'P');
    }

    /// True when a G2 or G3 block is a spiral by its words.
    pub(super) fn is_spiral_of_type_two(&self, block: &Block, target: &Position) -> bool {
        self.has_spiral_words(block) && !self.is_plain_circle(block, target)
    }

    /// A full circle whose further words are zero, as posts write them, or ask for its one turn.
    fn is_plain_circle(&self, block: &Block, target: &Position) -> bool {
        let zero = |letter| block.last(letter).is_none_or(|word| self.is_zero(word));
        let (a_letter, b_letter, height) = center_letters(self.state.plane);
        let letters = block.letters();
        let one_turn = block.last(b'L').is_none_or(|word| {
            self.literal(word)
                .and_then(|number| number.to_integer())
                .is_some_and(|n| n == 0 || n == 1)
        });
        self.ends_at_start(target)
            && !letters.has(b'R')
            && (letters.has(a_letter) || letters.has(b_letter))
            && one_turn
            && zero(b'Q')
            && zero(height)
    }

    /// The end is the start, on the axes of the plane.
    fn ends_at_start(&self, target: &Position) -> bool {
        let (a, b, _) = self.state.plane.axes();
        let from = &self.state.position;
        target[a] == from[a] && target[b] == from[b]
    }

    fn has_spiral_words(&self, block: &Block) -> bool {
        let letters = block.letters();
        match self.control.parameters.spiral {
            SpiralForm::None | SpiralForm::Pitches => false,
            SpiralForm::IncrementCount => letters.meets(Letters::of("QL")),
            SpiralForm::IncrementHeightCount => {
                let (_, _, height) = center_letters(self.state.plane);
                letters.meets(Letters::of("QL")) || letters.has(height)
            }
        }
    }

    /// G2 and G3 with Q, K or L.
    pub(super) fn spiral_of_type_two(
        &mut self,
        block: &Block,
        direction: Direction,
        target: Position,
        named: AxisMask,
    ) {
        let Some(ends) = self.spiral_ends(block, direction, &target) else {
            return self.straight_instead(block, target, named);
        };
        if let Some(word) = block.last(b'P').copied() {
            self.unused_word(&word);
        }
        let angle = self.spiral_angle(block, &ends, &target);
        self.emit_spiral(block, &ends, angle, target, named, b'L');
    }

    fn spiral_ends(
        &mut self,
        block: &Block,
        direction: Direction,
        target: &Position,
    ) -> Option<SpiralEnds> {
        let (a_letter, b_letter, _) = center_letters(self.state.plane);
        let letters = block.letters();
        if letters.has(b'R') || !(letters.has(a_letter) || letters.has(b_letter)) {
            let span = self.span(block.range);
            let message = if letters.has(b'R') {
                "a spiral cannot be given by R"
            } else {
                "a spiral without a centre"
            };
            self.report(Diagnostic::new(Code::NoCenter, span, message).help(format!(
                "give the centre with {} and {}",
                a_letter as char, b_letter as char
            )));
            return None;
        }
        let center = self.center(block);
        let from = point(&self.state.position);
        let fit = arc_from_center(self.state.plane, from, point(target), center, direction, 0, 0.0);
        // The fit calls an end on the start's ray a full turn; here it is none.
        let full = fit.sweep.abs();
        let radius = fit.radius_start.min(fit.radius_end);
        let short_of_ray = (TAU - full) * radius;
        let near = self.control.parameters.coincidence_mm;
        let angle = if short_of_ray <= near || full * radius <= near { 0.0 } else { full };
        let rounding =
            ROUNDED_INCREMENTS * self.control.parameters.least_increment(self.state.units);
        let on_ray = short_of_ray <= rounding || full * radius <= rounding;
        if fit.radius_start <= near && fit.radius_end <= near {
            let span = self.words_span(block, Letters::of("IJK"));
            self.report(
                Diagnostic::new(
                    Code::ZeroRadius,
                    span,
                    "start, end and centre of this spiral are one point",
                )
                .help("give the distance from the start to the centre"),
            );
            return None;
        }
        if fit.radius_start <= near || fit.radius_end <= near {
            self.report_end_on_center(block, fit.radius_start <= near);
        }
        Some(SpiralEnds {
            closed: self.ends_at_start(target),
            center,
            radius_from: fit.radius_start,
            radius_to: fit.radius_end,
            angle,
            on_ray,
            direction,
        })
    }

    /// The whole angle by Q, height or L, in this precedence.
    fn spiral_angle(&mut self, block: &Block, ends: &SpiralEnds, target: &Position) -> f64 {
        let letters = block.letters();
        let (_, _, height_letter) = center_letters(self.state.plane);
        let (_, _, normal) = self.state.plane.axes();
        let form = self.control.parameters.spiral;
        let height_counts = form == SpiralForm::IncrementHeightCount && letters.has(height_letter);
        if !height_counts {
            self.check_height_word(block);
        }
        let count = if letters.has(b'L') { self.count_of(block, b'L') } else { None };
        if letters.has(b'Q')
            && let Some(q) = self.length_of(block, b'Q')
            && q != 0.0
        {
            let signed = form == SpiralForm::IncrementCount;
            let change = ends.radius_to - ends.radius_from;
            if ends.closed {
                self.report_no_increment(
                    block,
                    b'Q',
                    "and start and end are equally far from the centre",
                );
                return TAU;
            }
            if signed && change * q < 0.0 {
                self.report_sign_of_q(block, change);
            }
            let turns = change.abs() / q.abs();
            let angle = self.congruent(block, b'Q', turns, q.abs(), ends);
            if form == SpiralForm::IncrementCount
                && let Some(count) = count
            {
                self.check_count(block, count, angle / TAU);
            }
            return angle;
        }
        if height_counts
            && let Some(k) = self.length_of(block, height_letter)
            && k != 0.0
        {
            let rise = target[normal] - self.state.position[normal];
            if ends.closed && rise == 0.0 {
                self.report_no_increment(
                    block,
                    height_letter,
                    "and the end is as high as the start",
                );
                return TAU;
            }
            let turns = rise.abs() / k.abs();
            return self.congruent(block, height_letter, turns, k.abs(), ends);
        }
        let full_turn = ends.closed
            || ends.on_ray && self.control.parameters.spiral_on_ray == SpiralOnRay::FullTurn;
        if full_turn || ends.angle > 0.0 {
            self.report_zero_count(block, height_counts, count, ends);
        }
        let count = self.checked_turns(block, b'L', count.unwrap_or(1).max(1));
        ends.with_turns(if full_turn { count } else { count - 1 })
    }

    /// Q, the height word or L of zero, in a block that they make a spiral.
    fn report_zero_count(
        &mut self,
        block: &Block,
        height_counts: bool,
        count: Option<u32>,
        ends: &SpiralEnds,
    ) {
        let (_, _, height) = center_letters(self.state.plane);
        let zero = match count {
            _ if ends.closed => None,
            // The control counts turns begun, from one.
            Some(0) if self.control.parameters.spiral == SpiralForm::IncrementCount => {
                return self.report_count_of_zero(block);
            }
            Some(0) => Some(b'L'),
            Some(_) => None,
            None if block.letters().has(b'Q') => Some(b'Q'),
            None if height_counts => Some(height),
            None => None,
        };
        let Some(letter) = zero else { return };
        let span = self.words_span(block, Letters(1 << (letter - b'A')));
        let letter = letter as char;
        self.report(
            Diagnostic::new(
                Code::SpiralTurns,
                span,
                format!("`{letter}` of zero gives no number of turns: it is read as L1"),
            )
            .severity(Severity::Warning)
            .label("the first turn, and no further one")
            .help("write the count with L, or remove the word"),
        );
    }

    fn report_count_of_zero(&mut self, block: &Block) {
        let span = self.words_span(block, Letters::of("L"));
        self.report(
            Diagnostic::new(Code::BadWordValue, span, "`L` counts the turns begun, from one")
                .label("read as L1")
                .help("write L1 for less than a turn"),
        );
    }

    /// An increment per turn of something that does not change, on a full circle.
    fn report_no_increment(&mut self, block: &Block, letter: u8, why: &str) {
        let span = self.words_span(block, Letters(1 << (letter - b'A')));
        let letter = letter as char;
        self.report(
            Diagnostic::new(
                Code::SpiralTurns,
                span,
                format!("`{letter}` asks for a change in each turn, {why}"),
            )
            .label("shown as one full circle")
            .help(format!("remove {letter} for a circle, or give the end of the spiral")),
        );
    }

    /// A spiral that begins or ends on its centre.
    fn report_end_on_center(&mut self, block: &Block, start: bool) {
        let span = self.words_span(block, Letters::of("IJK"));
        let (end, other) = if start { ("start", "end") } else { ("end", "start") };
        self.report(
            Diagnostic::new(
                Code::ZeroRadius,
                span,
                format!("the {end} of this spiral is its centre"),
            )
            .severity(Severity::Warning)
            .label(format!("the angle there is not known; shown as that of the {other}"))
            .help(
                "it is not known whether the control accepts it: end it a little away from the centre",
            ),
        );
    }

    /// Whole turns so that the angle ends exactly at the programmed end, and a problem when
    /// the given increment means another angle.
    fn congruent(
        &mut self,
        block: &Block,
        letter: u8,
        turns: f64,
        per_turn: f64,
        ends: &SpiralEnds,
    ) -> f64 {
        let fraction = ends.angle / TAU;
        if turns > f64::from(MAX_TURNS) + 1.0 {
            let span = self.words_span(block, Letters(1 << (letter - b'A')));
            let (letter, turns) = (letter as char, self.turns_text(turns));
            self.report(
                Diagnostic::new(
                    Code::BadWordValue,
                    span,
                    format!(
                        "{letter} asks for {turns} turns, more than the {MAX_TURNS} of this control"
                    ),
                )
                .label(format!("shown with {MAX_TURNS} turns"))
                .help("write a larger increment per turn"),
            );
            return ends.angle + TAU * f64::from(MAX_TURNS);
        }
        let least = if ends.closed { 1.0 } else { 0.0 };
        let whole = (turns - fraction).round().clamp(least, f64::from(MAX_TURNS));
        let off = (turns - whole - fraction).abs() * per_turn;
        if off > self.control.parameters.spiral_end_tolerance_mm * (1.0 + 1e-9) {
            let span = self.words_span(block, Letters(1 << (letter - b'A')));
            let given = self.turns_text(turns);
            let fits = self.turns_text(whole + fraction);
            let off = self.length_text(off);
            let allowed = self.length_text(self.control.parameters.spiral_end_tolerance_mm);
            self.report(
                Diagnostic::new(
                    Code::SpiralTurns,
                    span,
                    format!(
                        "{} asks for {given} turns, and start, end and centre allow {fits}",
                        letter as char
                    ),
                )
                .label(format!("the end would be {off} off; {allowed} is allowed"))
                .help("change the end point, or the increment per turn"),
            );
        }
        ends.angle + TAU * whole
    }

    fn check_count(&mut self, block: &Block, count: u32, turns: f64) {
        // The count is of turns begun: four and a quarter are L5.
        let begun = (turns - 1e-9).ceil().max(1.0);
        if f64::from(count) != begun {
            let span = self.words_span(block, Letters::of("L"));
            let turns = self.turns_text(turns);
            self.report(
                Diagnostic::new(
                    Code::SpiralTurns,
                    span,
                    format!("L{count} contradicts Q, which asks for {turns} turns"),
                )
                .severity(Severity::Warning)
                .label("Q is followed")
                .help(format!("write L{begun}, or leave L out")),
            );
        }
    }

    fn report_sign_of_q(&mut self, block: &Block, change: f64) {
        let span = self.words_span(block, Letters::of("Q"));
        let grows = if change > 0.0 { "grows" } else { "shrinks" };
        let change = self.length_text(change.abs());
        self.report(
            Diagnostic::new(
                Code::SpiralTurns,
                span,
                format!("the sign of Q contradicts the ends: the radius {grows} by {change}"),
            )
            .help("Q is positive when the radius grows, negative when it shrinks"),
        );
    }

    fn checked_turns(&mut self, block: &Block, letter: u8, turns: u32) -> u32 {
        if turns <= MAX_TURNS {
            return turns;
        }
        let span = self.words_span(block, Letters(1 << (letter - b'A')));
        self.report(
            Diagnostic::new(
                Code::BadWordValue,
                span,
                format!("{}{turns} is above the {MAX_TURNS} turns of this control", letter as char),
            )
            .help(format!("write {MAX_TURNS} or less")),
        );
        MAX_TURNS
    }

    /// `letter` is the one that counts turns.
    fn emit_spiral(
        &mut self,
        block: &Block,
        ends: &SpiralEnds,
        angle: f64,
        target: Position,
        named: AxisMask,
        letter: u8,
    ) {
        if angle <= 0.0 {
            self.report_no_turn(block, ends, &target, letter);
            return self.straight_instead(block, target, named);
        }
        let plane = self.state.plane;
        let shape = ArcShape {
            plane,
            center: [ends.center.0, ends.center.1],
            sweep: ends.direction.sign() * angle,
            radius_from: ends.radius_from,
            radius_to: ends.radius_to,
        };
        self.check_rotary_in_arc(block, &target);
        let motion = self.moved_to(target, named);
        let feed = self.feed_for(block, &motion, Some(&shape));
        // One turn back to the start is a circle or a helix, whatever words say so.
        let circle = ends.closed && angle == TAU;
        self.emit(match circle {
            true => CommandKind::Arc { motion, shape, feed },
            false => CommandKind::Spiral { motion, shape, feed },
        });
    }

    /// Start and end on one ray from the centre, and a count that adds no turn.
    fn report_no_turn(&mut self, block: &Block, ends: &SpiralEnds, target: &Position, letter: u8) {
        let (_, _, height) = center_letters(self.state.plane);
        let words = block.letters();
        // Without L the word is named that makes the block a spiral.
        let letter = match letter {
            b'L' if !words.has(b'L') && words.has(b'Q') => b'Q',
            b'L' if !words.has(b'L') && words.has(height) => height,
            letter => letter,
        } as char;
        let where_to = if ends.closed {
            "the end of this spiral is its start"
        } else {
            "start and end of this spiral lie on one ray from the centre"
        };
        let shown =
            if *target == self.state.position { "nothing moves" } else { "a straight line" };
        let written = block.last(letter as u8).map(|word| self.literal(word));
        let counts = matches!(letter, 'P' | 'L');
        let whole = |number: &chordal_syntax::Decimal| {
            !counts || number.to_integer().is_some_and(|n| n >= 0)
        };
        let count = match written {
            Some(Some(number)) if whole(&number) => format!("with {letter}{number}"),
            // What is wrong with the word was reported.
            Some(_) => return,
            None => format!("without {letter}"),
        };
        let more = if letter == 'P' { "P1" } else { "L2" };
        let span = self.span(block.range);
        self.report(
            Diagnostic::new(
                Code::SpiralTurns,
                span,
                format!("{where_to}, and {count} it makes no turn"),
            )
            .severity(Severity::Warning)
            .label(format!("shown as programmed: {shown}"))
            .help(format!("write {more} for one turn, or give another end")),
        );
    }
}
