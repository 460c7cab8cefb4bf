//! Reads the words of a cycle into its levels and other data.

use chordal_diagnostics::{Code, Diagnostic};
use chordal_dialect::{Action, ReadingCode};
use chordal_kernel::CycleState;
use chordal_kernel::rules::{DrillingAxis, IncrementalLevels, TapFeed};
use chordal_syntax::{Block, Letters};

use super::super::Interpreter;

impl Interpreter<'_> {
    /// True when a word of this block is read in G91; if G90 and G91 act from left to right, this depends on its
    /// position in the block.
    fn incremental_at(&self, block: &Block, letter: u8) -> bool {
        if !self.control.table.distance_left_to_right {
            return self.kernel.state.incremental;
        }
        let mut incremental = self.kernel.state.incremental;
        for word in &block.words {
            if word.letter == letter {
                break;
            }
            let code = (word.letter == b'G')
                .then(|| self.literal(word).and_then(chordal_dialect::code_number))
                .flatten();
            match code.and_then(|code| self.control.g_code(code)).map(|row| row.action) {
                Some(Action::Reading(ReadingCode::Absolute)) => incremental = false,
                Some(Action::Reading(ReadingCode::Incremental)) => incremental = true,
                _ => {}
            }
        }
        incremental
    }

    /// Reads the words of a block into the active cycle.
    pub(super) fn take_cycle_words(&mut self, block: &Block, cycle: &mut CycleState) {
        let rules = self.control.parameters.rules.cycles;
        let letters = block.letters();
        let reads_again = rules.incremental == IncrementalLevels::ReadAgain;
        let from = |relative: bool, base: f64| if relative && !reads_again { base } else { 0.0 };
        if letters.has(b'R')
            && let Some(value) =
                self.radius_word(block).and_then(|word| self.length_in_cycle(&word))
        {
            let relative = rules.incremental == IncrementalLevels::WhenProgrammed
                && self.incremental_at(block, b'R');
            let is_diameter = rules.radial_r_is_diameter && cycle.axis == 0;
            let value = if is_diameter { value / 2.0 } else { value };
            cycle.r = Some(match rules.r_from_initial {
                true => cycle.initial + value,
                false => value + from(relative, cycle.initial),
            });
        }
        let axis = cycle.axis;
        let letter = b"XYZ"[axis];
        if letters.has(letter)
            && let Some(value) = self.axis_value_of(block, axis)
        {
            let relative = self.incremental_at(block, letter);
            if relative && rules.incremental == IncrementalLevels::Refused {
                self.report_incremental_depth(block, letter);
            }
            let level = self.kernel.state.position[axis];
            let base = cycle.r.unwrap_or(level);
            let adds = relative && rules.incremental == IncrementalLevels::WhenProgrammed;
            cycle.z = Some(value + from(adds, base));
        }
        let increments = self.control.parameters.increments;
        if let Some((letter, _)) = increments.iter().find(|(_, of)| *of == letter)
            && let Some(word) = block.last(*letter).copied()
            && let Some(value) = self.axis_value(&word, axis)
        {
            cycle.z = Some(cycle.r.unwrap_or(cycle.initial) + value);
        }
        if letters.has(b'Q') {
            // On lathes Q is usually written in least increments: no report without a decimal point.
            let step = match rules.axis {
                DrillingAxis::OfCode => self.quiet_length(block, b'Q'),
                DrillingAxis::AlwaysZ | DrillingAxis::PlaneNormal => self.cycle_length(block, b'Q'),
            };
            cycle.q = step.or(cycle.q);
        }
        self.take_vector(block, cycle);
        if letters.has(b'P') {
            self.take_cycle_p(block, cycle);
        }
        if let Some(number) = block.last(b'E').and_then(|word| self.literal(word)) {
            cycle.after_rpm = Some(number.to_f64());
        }
        let is_speed = rules.tap.feed == TapFeed::SpeedWithLeadQ && cycle.kind.is_tap();
        if let Some(number) = block.last(b'F').and_then(|word| self.literal(word))
            && is_speed
        {
            cycle.tap_rpm = Some(number.to_f64());
        }
        for word in block.words.iter().filter(|word| word.comma && word.letter == b'R') {
            cycle.synchronous = self.literal(word).map(|number| number.mantissa != 0);
        }
    }

    /// Reads I, J and K: a shift, peck depths, the top of a bore, or the retraction factor of a tap.
    fn take_vector(&mut self, block: &Block, cycle: &mut CycleState) {
        let rules = &self.control.parameters.rules.cycles;
        let repeat_letter = rules.repeat_letter;
        let is_factor = rules.tap.out_factor_by_j && cycle.kind.is_tap();
        for (index, letter) in [b'I', b'J', b'K'].into_iter().enumerate() {
            if !block.letters().has(letter) || letter == repeat_letter {
                continue;
            }
            if is_factor {
                let number = block.last(letter).and_then(|word| self.literal(word));
                if letter == b'J' {
                    cycle.out_factor = number.map(|number| number.to_f64());
                }
                continue;
            }
            cycle.vector[index] = self.cycle_length(block, letter);
        }
    }

    /// Reads P: a dwell, or on some controls a distance.
    fn take_cycle_p(&mut self, block: &Block, cycle: &mut CycleState) {
        let rules = &self.control.parameters.rules.cycles;
        let is_distance = rules.peck.p_is_distance(cycle.kind);
        let (integer_s, point_s) = (rules.dwell_integer_s, rules.dwell_point_s);
        if is_distance {
            cycle.lift = self.cycle_length(block, b'P').map(f64::abs);
        } else if let Some(number) = block.last(b'P').and_then(|word| self.literal(word)) {
            let unit = if number.has_point { point_s } else { integer_s };
            cycle.dwell_s = Some((number.to_f64() * unit).max(0.0));
            self.kernel.state.cycle_dwell_s = cycle.dwell_s;
        }
    }

    fn report_incremental_depth(&mut self, block: &Block, letter: u8) {
        let span = self.words_span(block, Letters(1 << (letter - b'A')));
        self.kernel.report(
            Diagnostic::new(
                Code::CycleDepthIncremental,
                span,
                "the depth of a cycle must be given in G90 on this control",
            )
            .label("read as an absolute level")
            .help("define the cycle in G90; G91 may follow for the positions"),
        );
    }
}
