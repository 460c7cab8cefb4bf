//! Spirals and cones: Mitsubishi type 1 and type 2, Fanuc's L and Q.
//!
//! With r0 and r1 the distances of start and end from the centre and θ the directed angle from start to end in
//! [0, 2π), the angle of a spiral is θ plus full turns; the radius changes linearly with the angle from r0 to
//! r1. When the end is the start, G2 and G3 make a full circle, as they do without Q, K or L; for G2.1 and
//! G3.1, P counts every turn.

use std::f64::consts::{PI, TAU};

use chordal_command::{ArcShape, AxisMask, CommandKind, Position, telling_number};
use chordal_diagnostics::{Code, Diagnostic, Severity};
use chordal_geometry::{TurnDirection, arc_sweep};

use super::arc::point;
use crate::kernel::Kernel;
use crate::rules::{SpiralForm, SpiralOnRay};
use crate::statement::{Statement, WordMeaning};

/// The words of a spiral, except its end point.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct SpiralWords {
    /// Clockwise or counterclockwise.
    pub direction: TurnDirection,
    /// It has a centre word and no radius.
    pub centered: bool,
    /// It has a radius.
    pub by_radius: bool,
    /// The centre words on the two axes of the plane, mm, `None` when omitted; [`ArcCenter`](crate::rules::ArcCenter)
    /// says how they are read.
    pub center: [Option<f64>; 2],
    /// The change of the radius per turn, mm (Q).
    pub increment: Option<f64>,
    /// The height of a turn, mm (I, J or K normal to the plane); `None` where the control does not use it.
    pub height: Option<f64>,
    /// The number of turns, a begun one included (L).
    pub count: Option<u32>,
}

/// Largest number of turns (the manuals give 0 to 99).
const MAX_TURNS: u32 = 99;

/// An end may miss the ray of the start by this many least increments through rounding: half of one for each of
/// the words of the end and of the centre.
const ROUNDED_INCREMENTS: f64 = 1.5;

/// Ends, centre and θ of a spiral block.
struct SpiralEnds {
    center: (f64, f64),
    radius_from: f64,
    radius_to: f64,
    /// Directed angle from start to end in [0, 2π).
    angle: f64,
    /// The end is on the ray from the centre through the start, within the rounding of coordinates.
    on_ray: bool,
    /// The end is the start, on the axes of the plane.
    closed: bool,
    direction: TurnDirection,
}

impl SpiralEnds {
    /// The angle with this many full turns added. An end that rounding puts slightly before the ray of the start
    /// does not add a turn.
    fn with_turns(&self, turns: u32) -> f64 {
        let before_ray = self.on_ray && self.angle > PI;
        let beyond = if turns > 0 && before_ray { self.angle - TAU } else { self.angle };
        beyond + TAU * f64::from(turns)
    }
}

impl Kernel<'_> {
    /// Cuts a spiral by its additional turns (G2.1 and G3.1 with P): the angle is θ + 2πP.
    pub fn spiral_by_pitches(
        &mut self,
        at: &dyn Statement,
        spiral: &SpiralWords,
        pitches: u32,
        target: Position,
        named: AxisMask,
    ) {
        let mut target = target;
        self.snap_to_start(&mut target);
        let Some(ends) = self.spiral_ends(at, spiral, &target) else {
            return self.straight_instead(at, target, named);
        };
        let turns = self.checked_turns(at, WordMeaning::Pitches, pitches);
        let angle = ends.with_turns(turns);
        self.emit_spiral(at, &ends, angle, target, named, WordMeaning::Pitches);
    }

    /// Cuts a spiral by its increment, height or count (G2 and G3 with Q, K or L).
    pub fn spiral_by_increment(
        &mut self,
        at: &dyn Statement,
        spiral: &SpiralWords,
        target: Position,
        named: AxisMask,
    ) {
        let Some(ends) = self.spiral_ends(at, spiral, &target) else {
            return self.straight_instead(at, target, named);
        };
        let angle = self.spiral_angle(at, spiral, &ends, &target);
        self.emit_spiral(at, &ends, angle, target, named, WordMeaning::Count);
    }

    /// The end is the start, on the axes of the plane.
    pub fn ends_at_start(&self, target: &Position) -> bool {
        let (a, b, _) = self.state.plane.axes();
        let from = &self.state.position;
        target[a] == from[a] && target[b] == from[b]
    }

    fn spiral_ends(
        &mut self,
        at: &dyn Statement,
        spiral: &SpiralWords,
        target: &Position,
    ) -> Option<SpiralEnds> {
        if !spiral.centered {
            let [a, b] = at.center_names(self.state.plane);
            let message = match spiral.by_radius {
                true => "a spiral cannot be given by R",
                false => "a spiral without a centre",
            };
            let help = format!("give the centre with {a} and {b}");
            self.report(Diagnostic::new(Code::NoCenter, at.span(), message).help(help));
            return None;
        }
        if self.spiral_is_refused(at) || !self.arc_fits_frames(at) {
            return None;
        }
        let center = self.center(spiral.center, self.state.arc_center);
        let direction = spiral.direction;
        let from = point(&self.state.position);
        let fit = arc_sweep(self.state.plane, from, point(target), center, direction, 0);
        // `arc_sweep` makes a full turn of an end on the ray of the start; here it is no turn.
        let full = fit.sweep.abs();
        let radius = fit.radius_start.min(fit.radius_end);
        let short_of_ray = (TAU - full) * radius;
        let near = self.rules.arc.coincidence_mm;
        let angle = if short_of_ray <= near || full * radius <= near { 0.0 } else { full };
        let rounding = ROUNDED_INCREMENTS * self.rules.least_increment(self.state.units);
        let on_ray = short_of_ray <= rounding || full * radius <= rounding;
        if fit.radius_start <= near && fit.radius_end <= near {
            let span = at.words(WordMeaning::Center);
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
            self.report_end_on_center(at, fit.radius_start <= near);
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

    /// The whole angle, rad, by increment, height or count, in this precedence.
    fn spiral_angle(
        &mut self,
        at: &dyn Statement,
        spiral: &SpiralWords,
        ends: &SpiralEnds,
        target: &Position,
    ) -> f64 {
        let (_, _, normal) = self.state.plane.axes();
        let form = self.rules.arc.spiral;
        if let Some(q) = spiral.increment.filter(|q| *q != 0.0) {
            let signed = form == SpiralForm::IncrementCount;
            let change = ends.radius_to - ends.radius_from;
            if ends.closed {
                let why = "and start and end are equally far from the centre";
                self.report_no_increment(at, WordMeaning::Increment, why);
                return TAU;
            }
            if signed && change * q < 0.0 {
                self.report_sign_of_q(at, change);
            }
            let turns = change.abs() / q.abs();
            let angle = self.congruent(at, WordMeaning::Increment, turns, q.abs(), ends);
            if signed && let Some(count) = spiral.count {
                self.check_count(at, count, angle / TAU);
            }
            return angle;
        }
        let height = WordMeaning::Height(self.state.plane);
        if let Some(k) = spiral.height.filter(|k| *k != 0.0) {
            let rise = target[normal] - self.state.position[normal];
            if ends.closed && rise == 0.0 {
                self.report_no_increment(at, height, "and the end is as high as the start");
                return TAU;
            }
            let turns = rise.abs() / k.abs();
            return self.congruent(at, height, turns, k.abs(), ends);
        }
        let full_turn =
            ends.closed || ends.on_ray && self.rules.arc.spiral_on_ray == SpiralOnRay::FullTurn;
        if full_turn || ends.angle > 0.0 {
            self.report_zero_count(at, spiral, ends);
        }
        let count = self.checked_turns(at, WordMeaning::Count, spiral.count.unwrap_or(1).max(1));
        ends.with_turns(if full_turn { count } else { count - 1 })
    }

    /// Reports Q, the height word or L of zero, when it makes the block a spiral.
    fn report_zero_count(&mut self, at: &dyn Statement, spiral: &SpiralWords, ends: &SpiralEnds) {
        let zero = match spiral.count {
            _ if ends.closed => None,
            // The control counts turns begun, from one.
            Some(0) if self.rules.arc.spiral == SpiralForm::IncrementCount => {
                return self.report_count_of_zero(at);
            }
            Some(0) => Some(WordMeaning::Count),
            Some(_) => None,
            None if at.has(WordMeaning::Increment) => Some(WordMeaning::Increment),
            None if spiral.height.is_some() => Some(WordMeaning::Height(self.state.plane)),
            None => None,
        };
        let Some(letter) = zero else { return };
        let span = at.words(letter);
        let letter = at.name(letter);
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

    fn report_count_of_zero(&mut self, at: &dyn Statement) {
        let span = at.words(WordMeaning::Count);
        self.report(
            Diagnostic::new(Code::BadWordValue, span, "`L` counts the turns begun, from one")
                .label("read as L1")
                .help("write L1 for less than a turn"),
        );
    }

    /// Reports an increment of a radius or height that does not change, on a full circle.
    fn report_no_increment(&mut self, at: &dyn Statement, letter: WordMeaning, why: &str) {
        let span = at.words(letter);
        let letter = at.name(letter);
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

    /// Reports a spiral that begins or ends on its centre.
    fn report_end_on_center(&mut self, at: &dyn Statement, start: bool) {
        let span = at.words(WordMeaning::Center);
        let (end, other) = if start { ("start", "end") } else { ("end", "start") };
        self.report(
            Diagnostic::new(
                Code::ZeroRadius,
                span,
                format!("the {end} of this spiral is its centre"),
            )
            .severity(Severity::Warning)
            .label(format!("the angle there is not known; shown as that of the {other}"))
            .help(format!(
                "it is not known whether the control accepts it: {} it a little away from the centre",
                if start { "begin" } else { "end" }
            )),
        );
    }

    /// The angle with the number of full turns that ends exactly at the programmed end; reports an increment that
    /// gives another angle.
    fn congruent(
        &mut self,
        at: &dyn Statement,
        letter: WordMeaning,
        turns: f64,
        per_turn: f64,
        ends: &SpiralEnds,
    ) -> f64 {
        let fraction = ends.angle / TAU;
        if turns > f64::from(MAX_TURNS) + 1.0 {
            let span = at.words(letter);
            let (letter, turns) = (at.name(letter), turns_text(turns));
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
        if off > self.rules.arc.spiral_end_tolerance_mm * (1.0 + 1e-9) {
            let span = at.words(letter);
            let programmed = turns_text(turns);
            let fits = turns_text(whole + fraction);
            let off = self.length_text(off);
            let allowed = self.length_text(self.rules.arc.spiral_end_tolerance_mm);
            self.report(
                Diagnostic::new(
                    Code::SpiralTurns,
                    span,
                    format!(
                        "{} asks for {programmed} turns, and start, end and centre allow {fits}",
                        at.name(letter)
                    ),
                )
                .label(format!("the end would be {off} off; {allowed} is allowed"))
                .help("change the end point, or the increment per turn"),
            );
        }
        ends.angle + TAU * whole
    }

    fn check_count(&mut self, at: &dyn Statement, count: u32, turns: f64) {
        // The count is of turns begun: four and a quarter are L5.
        let begun = (turns - 1e-9).ceil().max(1.0);
        if f64::from(count) != begun {
            let span = at.words(WordMeaning::Count);
            let turns = turns_text(turns);
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

    fn report_sign_of_q(&mut self, at: &dyn Statement, change: f64) {
        let span = at.words(WordMeaning::Increment);
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

    fn checked_turns(&mut self, at: &dyn Statement, letter: WordMeaning, turns: u32) -> u32 {
        if turns <= MAX_TURNS {
            return turns;
        }
        let span = at.words(letter);
        self.report(
            Diagnostic::new(
                Code::BadWordValue,
                span,
                format!(
                    "{}{turns} is above the {MAX_TURNS} turns of this control",
                    at.name(letter)
                ),
            )
            .help(format!("write {MAX_TURNS} or less")),
        );
        MAX_TURNS
    }

    /// Emits the spiral; `letter` is the word that counts turns.
    fn emit_spiral(
        &mut self,
        at: &dyn Statement,
        ends: &SpiralEnds,
        angle: f64,
        target: Position,
        named: AxisMask,
        letter: WordMeaning,
    ) {
        if angle <= 0.0 {
            self.report_no_turn(at, ends, &target, letter);
            return self.straight_instead(at, target, named);
        }
        let plane = self.state.plane;
        let shape = ArcShape {
            plane,
            center: [ends.center.0, ends.center.1],
            sweep: ends.direction.sign() * angle,
            radius_from: ends.radius_from,
            radius_to: ends.radius_to,
        };
        self.check_rotary_in_arc(at, &target);
        let motion = self.moved_to(target, named);
        let feed = self.feed_for(at, &motion, Some(&shape));
        // One turn back to the start is a circle or a helix, whichever words program it.
        let circle = ends.closed && angle == TAU;
        self.emit(match circle {
            true => CommandKind::Arc { motion, shape, feed },
            false => CommandKind::Spiral { motion, shape, feed },
        });
    }

    /// Reports start and end on one ray from the centre with a count that adds no turn.
    fn report_no_turn(
        &mut self,
        at: &dyn Statement,
        ends: &SpiralEnds,
        target: &Position,
        letter: WordMeaning,
    ) {
        let height = WordMeaning::Height(self.state.plane);
        // Without a count, the message names the word that makes the statement a spiral.
        let letter = match letter {
            WordMeaning::Count if !at.has(WordMeaning::Count) && at.has(WordMeaning::Increment) => {
                WordMeaning::Increment
            }
            WordMeaning::Count if !at.has(WordMeaning::Count) && at.has(height) => height,
            letter => letter,
        };
        let where_to = if ends.closed {
            "the end of this spiral is its start"
        } else {
            "start and end of this spiral lie on one ray from the centre"
        };
        let shown =
            if *target == self.state.position { "nothing moves" } else { "a straight line" };
        let name = at.name(letter);
        let whole =
            |number: &str| number.parse::<f64>().is_ok_and(|n| n >= 0.0 && n.fract() == 0.0);
        let counts = matches!(letter, WordMeaning::Pitches | WordMeaning::Count);
        let count = match at.number(letter) {
            Some(number) if !counts || whole(&number) => format!("with {name}{number}"),
            // The wrong word was already reported.
            Some(_) => return,
            None => format!("without {name}"),
        };
        let more = if letter == WordMeaning::Pitches { "P1" } else { "L2" };
        let span = at.span();
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

fn turns_text(turns: f64) -> String {
    telling_number(turns, 4)
}
