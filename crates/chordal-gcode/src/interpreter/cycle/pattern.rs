//! Holes on a circle, an arc or a line: the active cycle at computed positions.

use chordal_diagnostics::{Code, Diagnostic};
use chordal_kernel::rules::HolePattern;
use chordal_syntax::Block;

use super::super::Interpreter;

impl Interpreter<'_> {
    /// G70, G71, G72 of a Haas: I, J, K and L about the present position.
    pub(in super::super) fn pattern(&mut self, block: &Block, at: usize, pattern: HolePattern) {
        let span = self.span(block.words[at].range);
        if self.kernel.state.cycle.is_none() {
            return self.kernel.report_no_cycle(span, "a hole pattern without an active cycle");
        }
        let size = self.length_of(block, b'I');
        let start = self.angle_word(block, b'J');
        let step = self.angle_word(block, b'K');
        let (Some(size), Some(count)) = (size, self.pattern_count(block)) else {
            return self.report_pattern_words(block, "I and L");
        };
        if pattern == HolePattern::Arc && step.is_none() {
            return self.report_pattern_words(block, "K, the angle between two holes");
        }
        let turn = if count < 0 { -360.0 } else { 360.0 };
        let number = count.unsigned_abs();
        let start = start.unwrap_or(0.0);
        let step = match pattern {
            HolePattern::Circle => turn / number as f64,
            HolePattern::Arc => step.unwrap_or(0.0),
            HolePattern::Line => 0.0,
        };
        let by_line = pattern == HolePattern::Line;
        self.kernel.holes_about_here(&self.at(block), number as u32, |index| {
            let along = if by_line { f64::from(index) * size } else { size };
            (along, start + f64::from(index) * step)
        });
    }

    /// J or K of a pattern, degrees, with or without a decimal point.
    fn angle_word(&self, block: &Block, letter: u8) -> Option<f64> {
        block.last(letter).and_then(|word| self.literal(word)).map(|number| number.to_f64())
    }

    /// L, the number of holes; negative for clockwise.
    fn pattern_count(&mut self, block: &Block) -> Option<i64> {
        let word = *block.last(b'L')?;
        let count = self.literal(&word)?.to_integer()?;
        let limit = i64::from(self.control.parameters.max_repeats.max(9999));
        (count != 0 && count.abs() <= limit).then_some(count)
    }

    pub(super) fn report_pattern_words(&mut self, block: &Block, what: &str) {
        let span = self.span(block.range);
        self.kernel.report(
            Diagnostic::new(Code::PatternWords, span, format!("a hole pattern without {what}"))
                .label("nothing is drilled")
                .help("I is the radius or the distance, J the first angle, L the number of holes"),
        );
    }
}
