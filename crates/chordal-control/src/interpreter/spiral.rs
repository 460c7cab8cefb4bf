//! Spirals and cones: Mitsubishi type 1 and type 2, Fanuc's L and Q.
//!
//! With r0 and r1 the distances of start and end from the centre and θ the directed angle
//! from start to end in [0, 2π), the angle of a spiral is θ plus whole turns; the radius
//! goes linearly with the angle.

use std::f64::consts::TAU;

use chordal_diagnostics::{Code, Diagnostic};
use chordal_geometry::{Direction, arc_from_center};
use chordal_syntax::{Block, Letters};

use super::Interpreter;
use super::arc::{center_letters, point};
use crate::command::{ArcShape, AxisMask, CommandKind, Position};
use crate::parameters::SpiralForm;

/// Most turns of a spiral (the manuals' 0 to 99).
const MAX_TURNS: u32 = 99;

/// Ends, centre and θ of a spiral block.
struct SpiralEnds {
    center: (f64, f64),
    radius_from: f64,
    radius_to: f64,
    /// Directed angle from start to end in [0, 2π).
    angle: f64,
    direction: Direction,
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
        let Some(ends) = self.spiral_ends(block, direction, &target) else {
            return self.straight_instead(block, target, named);
        };
        let turns = match block.letters().has(b'P') {
            true => self.count_of(block, b'P').unwrap_or(0),
            false => 0,
        };
        let turns = self.checked_turns(block, b'P', turns);
        let angle = ends.angle + TAU * f64::from(turns);
        self.emit_spiral(block, &ends, angle, target, named);
    }

    /// True when a G2 or G3 block is a spiral by its words.
    pub(super) fn is_spiral_of_type_two(&self, block: &Block) -> bool {
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
        let angle = self.spiral_angle(block, &ends, &target);
        self.emit_spiral(block, &ends, angle, target, named);
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
        let angle = if full >= TAU * (1.0 - 1e-12) { 0.0 } else { full };
        let near = self.control.parameters.coincidence_mm;
        if fit.radius_start <= near && fit.radius_end <= near {
            let span = self.words_span(block, Letters::of("IJK"));
            self.report(
                Diagnostic::new(
                    Code::ZeroRadius,
                    span,
                    "start, end and centre of this spiral are one point",
                )
                .help("give the way from the start to the centre"),
            );
            return None;
        }
        Some(SpiralEnds {
            center,
            radius_from: fit.radius_start,
            radius_to: fit.radius_end,
            angle,
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
        let count = if letters.has(b'L') { self.count_of(block, b'L') } else { None };
        if letters.has(b'Q')
            && let Some(q) = self.length_of(block, b'Q')
            && q != 0.0
        {
            let signed = form == SpiralForm::IncrementCount;
            let change = ends.radius_to - ends.radius_from;
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
            let turns = rise.abs() / k.abs();
            return self.congruent(block, height_letter, turns, k.abs(), ends);
        }
        let count = self.checked_turns(block, b'L', count.unwrap_or(1).max(1));
        ends.angle + TAU * f64::from(count - 1)
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
        let whole = (turns - fraction).round().clamp(0.0, f64::from(MAX_TURNS));
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
                .severity(chordal_diagnostics::Severity::Warning)
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

    fn emit_spiral(
        &mut self,
        block: &Block,
        ends: &SpiralEnds,
        angle: f64,
        target: Position,
        named: AxisMask,
    ) {
        if angle == 0.0 {
            // No turn at all: a straight way along the ray.
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
        let motion = self.moved_to(target, named);
        let feed = self.feed_for(block, &motion);
        self.emit(CommandKind::Spiral { motion, shape, feed });
    }
}
