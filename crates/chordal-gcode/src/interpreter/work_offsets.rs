//! Work offsets selected by a number P.

use chordal_command::WorkName;
use chordal_diagnostics::{Code, Diagnostic};
use chordal_dialect::CodeRow;
use chordal_machine::{AXES, AXIS_LETTERS, PerAxis};
use chordal_syntax::{Block, Letters};

use super::Interpreter;

/// The last work offset on controls where one code numbers all of them (Mach3).
const MAX_WORK_ORDINAL: u32 = 254;

/// The work offset with a number P; `None` above the last one.
pub(super) fn work_of_ordinal(number: u32) -> Option<WorkName> {
    WorkName::of_ordinal(u16::try_from(number).ok().filter(|n| u32::from(*n) <= MAX_WORK_ORDINAL)?)
}

/// The last fixture offset of the table (Fanuc 30i).
const LAST_FIXTURE_ERROR: u32 = 8;

impl Interpreter<'_> {
    /// Carries out G54.1 P or G154 P.
    pub(super) fn select_extended_work(&mut self, block: &Block, at: usize) {
        match self.count_of(block, b'P') {
            Some(number) if (1..=300).contains(&number) => {
                let name = WorkName::Extended(number as u16);
                self.warn_of_work_change(block, at, name);
                self.kernel.select_work(name);
            }
            Some(number) => self.report_no_offset(
                block,
                format!("there is no extended work offset P{number}"),
                "extended work offsets begin with P1",
            ),
            None => {
                let span = self.span(block.words[at].range);
                let message = "an extended work offset without its number".to_string();
                self.kernel.missing_word(span, message, "write P and the number after the code");
            }
        }
    }

    /// True for G54 with a P of its own, an extended work offset on some controls; P may also belong to another code of
    /// the block.
    pub(super) fn numbers_by_p(&self, block: &Block, row: &CodeRow, at: usize) -> bool {
        row.words.has(b'P')
            && block.letters().has(b'P')
            && !block.words.iter().enumerate().any(|(place, word)| {
                place != at
                    && matches!(word.letter, b'G' | b'M')
                    && self.control.row_of(word).is_none_or(|row| row.words.has(b'P'))
            })
    }

    /// Carries out G59, or G59 P with the number of any work offset.
    pub(super) fn select_work_by_ordinal(&mut self, block: &Block, at: usize) {
        let number = match block.letters().has(b'P') {
            true => self.count_of(block, b'P'),
            false => Some(6),
        };
        let Some(number) = number else { return };
        match work_of_ordinal(number) {
            Some(name) => {
                self.warn_of_work_change(block, at, name);
                self.select_work(name);
            }
            None => self.report_no_offset(
                block,
                format!("there is no work offset P{number}"),
                &format!("P1 to P6 are G54 to G59, and P{MAX_WORK_ORDINAL} is the last"),
            ),
        }
    }

    /// Reports an increment of a work offset that the machine file does not give: the sum is not known.
    pub(super) fn check_added_values(
        &mut self,
        block: &Block,
        key: &str,
        values: &PerAxis<Option<f64>>,
    ) {
        if !self.kernel.adds_to_work_values() {
            return;
        }
        let offsets = &self.kernel.state.offsets;
        let is_missing =
            |axis: usize| values[axis].is_some() && offsets.work_value(key, axis).is_none();
        let Some(axis) = (0..AXES).find(|axis| is_missing(*axis)) else { return };
        let letter = AXIS_LETTERS.as_bytes()[axis] as char;
        let message = format!("`{letter}` is added to that of {key}, which is not given");
        let help = format!("give it in the machine file: `[work_offsets.{key}]`");
        let span = self.words_span(block, Letters(1 << (letter as u8 - b'A')));
        self.lose_path_once(span, message, help);
    }

    /// G54.2: the error of a clamped part turns with the tables.
    pub(super) fn select_fixture_error(&mut self, block: &Block, at: usize) {
        let span = self.span(block.words[at].range);
        match self.count_of(block, b'P') {
            Some(0) => self.kernel.select_fixture_error(span, 0),
            Some(_) if self.kernel.state.part_frame.is_some() => {
                let what = "a fixture offset in a frame of the part";
                self.not_followed(&block.words[at], what);
            }
            Some(number) if number <= LAST_FIXTURE_ERROR => {
                self.kernel.select_fixture_error(span, number as u16);
            }
            Some(number) => self.report_no_offset(
                block,
                format!("there is no fixture offset P{number}"),
                &format!("P1 to P{LAST_FIXTURE_ERROR}, and P0 ends it"),
            ),
            None => {
                let message = "a fixture offset without its number".to_string();
                self.kernel.missing_word(span, message, "write P and the number after the code");
            }
        }
    }

    fn report_no_offset(&mut self, block: &Block, message: String, help: &str) {
        let span = self.words_span(block, Letters::of("P"));
        self.kernel.report(Diagnostic::new(Code::BadWordValue, span, message).help(help));
    }
}
