//! Reads the words of spiral blocks; the kernel makes the curve.

use chordal_command::{AxisMask, Position};
use chordal_diagnostics::{Code, Diagnostic};
use chordal_geometry::TurnDirection;
use chordal_kernel::SpiralWords;
use chordal_kernel::rules::SpiralForm;
use chordal_syntax::{Block, Letters};

use super::Interpreter;
use super::arc::center_letters;

impl Interpreter<'_> {
    /// G2.1 and G3.1 with P.
    pub(super) fn spiral_block(
        &mut self,
        block: &Block,
        direction: TurnDirection,
        target: Position,
        named: AxisMask,
    ) {
        let at = self.at(block);
        if self.control.parameters.rules.arc.spiral != SpiralForm::Pitches {
            self.kernel.report(
                Diagnostic::new(
                    Code::NoSpirals,
                    self.span(block.range),
                    "G2.1 and G3.1 are not spirals with the settings of this machine",
                )
                .help(
                    "this machine writes spirals with G2 and G3 (type 2); see its setting `spiral`",
                ),
            );
            return self.kernel.straight_instead(&at, target, named);
        }
        self.check_height_word(block);
        let spiral = self.spiral_words(block, direction);
        let pitches = self.count_of(block, b'P').unwrap_or(0);
        self.kernel.spiral_by_pitches(&at, &spiral, pitches, target, named);
    }

    /// G2 and G3 with Q, K or L.
    pub(super) fn spiral_of_type_two(
        &mut self,
        block: &Block,
        direction: TurnDirection,
        target: Position,
        named: AxisMask,
    ) {
        let at = self.at(block);
        let mut spiral = self.spiral_words(block, direction);
        if spiral.centered
            && let Some(word) = block.last(b'P').copied()
        {
            self.unused_word(&word);
        }
        let (_, _, height) = center_letters(self.kernel.state.plane);
        let form = self.control.parameters.rules.arc.spiral;
        let height_counts = form == SpiralForm::IncrementHeightCount && block.letters().has(height);
        if height_counts {
            spiral.height = self.length_of(block, height);
        } else if spiral.centered {
            self.check_height_word(block);
        }
        spiral.increment = self.length_of(block, b'Q');
        spiral.count = self.count_of(block, b'L');
        self.kernel.spiral_by_increment(&at, &spiral, target, named);
    }

    fn spiral_words(&mut self, block: &Block, direction: TurnDirection) -> SpiralWords {
        let (a, b, _) = center_letters(self.kernel.state.plane);
        let letters = block.letters();
        let by_radius = letters.has(b'R');
        let centered = !by_radius && (letters.has(a) || letters.has(b));
        let center = match centered {
            true => [self.length_of(block, a), self.length_of(block, b)],
            false => [None; 2],
        };
        let (increment, height, count) = (None, None, None);
        SpiralWords { direction, centered, by_radius, center, increment, height, count }
    }

    /// True when a G2 or G3 block is a spiral by its words.
    pub(super) fn is_spiral_of_type_two(&mut self, block: &Block, target: &Position) -> bool {
        (self.has_spiral_words(block) || self.has_two_radii(block, target))
            && !self.is_plain_circle(block, target)
    }

    /// True for a full circle whose other words are zero, as postprocessors write them, or give its one turn.
    fn is_plain_circle(&self, block: &Block, target: &Position) -> bool {
        let zero = |letter| block.last(letter).is_none_or(|word| self.is_zero(word));
        let (a_letter, b_letter, height) = center_letters(self.kernel.state.plane);
        let letters = block.letters();
        let one_turn = block.last(b'L').is_none_or(|word| {
            self.literal(word)
                .and_then(|number| number.to_integer())
                .is_some_and(|n| n == 0 || n == 1)
        });
        self.kernel.ends_at_start(target)
            && !letters.has(b'R')
            && (letters.has(a_letter) || letters.has(b_letter))
            && one_turn
            && zero(b'Q')
            && zero(height)
    }

    /// True when two different radii make a spiral of less than a turn without Q, L and K, as with L1 (M700V manual
    /// 6.13 (7)).
    fn has_two_radii(&mut self, block: &Block, target: &Position) -> bool {
        let rules = &self.control.parameters.rules.arc;
        let (form, tolerance_mm) = (rules.spiral, rules.radius_error_tolerance_mm);
        if form != SpiralForm::IncrementHeightCount || block.letters().has(b'R') {
            return false;
        }
        let spiral = self.spiral_words(block, TurnDirection::Ccw);
        let [from, to] = self.kernel.radii(spiral.center, target);
        spiral.centered && (from - to).abs() > tolerance_mm
    }

    fn has_spiral_words(&self, block: &Block) -> bool {
        let letters = block.letters();
        match self.control.parameters.rules.arc.spiral {
            SpiralForm::None | SpiralForm::Pitches => false,
            SpiralForm::IncrementCount => letters.meets(Letters::of("QL")),
            SpiralForm::IncrementHeightCount => {
                let (_, _, height) = center_letters(self.kernel.state.plane);
                letters.meets(Letters::of("QL")) || letters.has(height)
            }
        }
    }
}
