//! Holes on a circle, an arc or a line: the cycle in force at computed places.

use chordal_diagnostics::{Code, Diagnostic};
use chordal_syntax::Block;

use super::super::Interpreter;
use super::bore::plane_axes;
use crate::table::Pattern;

impl Interpreter<'_> {
    /// G70, G71, G72 of a Haas: I, J, K and L about the place where the tool stands.
    pub(in super::super) fn pattern(&mut self, block: &Block, at: usize, pattern: Pattern) {
        let span = self.span(block.words[at].range);
        if self.state.cycle.is_none() {
            return self.report_no_cycle(span, "a hole pattern without an active cycle");
        }
        let size = self.length_of(block, b'I');
        let start = self.angle_word(block, b'J');
        let step = self.angle_word(block, b'K');
        let (Some(size), Some(count)) = (size, self.pattern_count(block)) else {
            return self.report_pattern_words(block, "I and L");
        };
        if pattern == Pattern::Arc && step.is_none() {
            return self.report_pattern_words(block, "K, the angle between two holes");
        }
        let turn = if count < 0 { -360.0 } else { 360.0 };
        let number = count.unsigned_abs();
        let start = start.unwrap_or(0.0);
        let step = match pattern {
            Pattern::Circle => turn / number as f64,
            Pattern::Arc => step.unwrap_or(0.0),
            Pattern::Line => 0.0,
        };
        let by_line = pattern == Pattern::Line;
        self.holes_about_here(block, number as u32, |index| {
            let along = if by_line { f64::from(index) * size } else { size };
            (along, start + f64::from(index) * step)
        });
    }

    /// Holes at polar places (mm, degrees) about the place where the tool stands.
    pub(in super::super) fn holes_about_here(
        &mut self,
        block: &Block,
        count: u32,
        place: impl Fn(u32) -> (f64, f64),
    ) {
        let Some(hole) = self.resolve_hole(block) else { return };
        let center = self.state.position;
        let [a, b] = plane_axes(hole.axis);
        for index in 0..count {
            if index > 0 && !self.count_repeated() {
                return;
            }
            let (radius, degrees) = place(index);
            let (sin, cos) = sin_cos_degrees(degrees);
            let mut target = center;
            target[a] += radius * cos;
            target[b] += radius * sin;
            self.drill_at(block, &hole, target);
        }
    }

    /// J and K of a pattern are degrees, with or without a point.
    fn angle_word(&self, block: &Block, letter: u8) -> Option<f64> {
        block.last(letter).and_then(|word| self.literal(word)).map(|number| number.to_f64())
    }

    /// L; negative goes clockwise.
    fn pattern_count(&mut self, block: &Block) -> Option<i64> {
        let word = *block.last(b'L')?;
        let count = self.literal(&word)?.to_integer()?;
        let limit = i64::from(self.control.parameters.max_repeats.max(9999));
        (count != 0 && count.abs() <= limit).then_some(count)
    }

    pub(super) fn report_pattern_words(&mut self, block: &Block, what: &str) {
        let span = self.span(block.range);
        self.report(
            Diagnostic::new(Code::PatternWords, span, format!("a hole pattern without {what}"))
                .label("nothing is drilled")
                .help("I is the radius or the distance, J the first angle, L the number of holes"),
        );
    }
}

/// Exact where the angle is a whole number of quarter turns.
fn sin_cos_degrees(degrees: f64) -> (f64, f64) {
    let turned = degrees.rem_euclid(360.0);
    match turned {
        0.0 => (0.0, 1.0),
        90.0 => (1.0, 0.0),
        180.0 => (0.0, -1.0),
        270.0 => (-1.0, 0.0),
        _ => libm::sincos(turned.to_radians()),
    }
}
