//! The repeats of blocks and calls, and the check that a subprogram returns to its start.

use chordal_diagnostics::{Code, Diagnostic, Severity};
use chordal_dialect::code_number;
use chordal_dialect::table::LineRepeat;
use chordal_dialect::{Action, ReadingCode};
use chordal_syntax::{Block, Letters, Word};

use super::Interpreter;

impl Interpreter<'_> {
    pub(super) fn allowed_repeats(&mut self, word: &Word, count: u32) -> u32 {
        let table = self.control.table;
        if table.line_repeat == LineRepeat::MainProgram && !self.frames.is_empty() {
            self.kernel.report(
                Diagnostic::new(
                    Code::RepeatNotAllowed,
                    self.span(word.range),
                    "L repeats a line only in the main program, and this is a subprogram",
                )
                .label("carried out once")
                .help("repeat the call instead, or write the line out"),
            );
            return 1;
        }
        if count == 0 {
            self.kernel.report(
                Diagnostic::new(
                    Code::BadWordValue,
                    self.span(word.range),
                    "L0: this block is not executed",
                )
                .severity(Severity::Warning)
                .label("executed no times")
                .help("remove L0, or the block"),
            );
        }
        self.cut_to_limit(word, count)
    }

    /// Reports a helix repeated in G90: from the second pass on, its height is already reached.
    pub(super) fn check_repeated_height(&mut self, block: &Block, word: &Word, times: u32) {
        let (a, b, normal) = self.kernel.state.plane.axes();
        let letter = b"XYZ"[normal];
        let letters = block.letters();
        // Only the repeats of a full circle have the same centre.
        let circle = letters.meets(Letters::of("IJK"))
            && !letters.has(b'R')
            && !letters.has(b"XYZ"[a])
            && !letters.has(b"XYZ"[b]);
        if times < 2 || !circle || !letters.has(letter) {
            return;
        }
        let again = times - 1;
        let letter = letter as char;
        self.kernel.report(
            Diagnostic::new(
                Code::RepeatsStandStill,
                self.span(word.range),
                format!(
                    "in G90 {letter} is reached the first time: the other {again} are flat circles"
                ),
            )
            .label("repeats the block")
            .help(format!("write G91 with {letter} for one turn")),
        );
    }

    pub(super) fn cut_to_limit(&mut self, word: &Word, count: u32) -> u32 {
        let limit = self.control.parameters.max_repeats;
        if count <= limit {
            return count;
        }
        self.kernel.report(
            Diagnostic::new(
                Code::BadWordValue,
                self.span(word.range),
                format!("{count} repeats are more than the {limit} this control allows"),
            )
            .label("carried out once")
            .help(format!("write {limit} or less")),
        );
        1
    }

    /// True when the words of a block are increments: by its own G90 or G91, which may not have acted yet, or by the
    /// active one. A block with both has increments before its G90.
    pub(super) fn reads_incremental(&self, block: &Block) -> bool {
        let says = |action| {
            block.all(b'G').any(|word| {
                let code = self.literal(word).and_then(code_number);
                code.and_then(|code| self.control.g_code(code))
                    .is_some_and(|row| row.action == action)
            })
        };
        says(Action::Reading(ReadingCode::Incremental))
            || self.kernel.state.incremental && !says(Action::Reading(ReadingCode::Absolute))
    }

    /// Remembers a contour in G91 that starts at the position of the subprogram's call: it should return there.
    pub(super) fn note_contour_of_call(&mut self, block: &Block) {
        let at = [self.kernel.state.position[0], self.kernel.state.position[1]];
        let incremental = self.reads_incremental(block);
        let span = self.kernel.origin.span;
        if let Some(frame) = self.frames.last_mut()
            && incremental
            && frame.remaining == 0
            && frame.entry == at
        {
            frame.contour = Some(span);
        }
    }

    /// Reports such a subprogram if it does not end where it began.
    pub(super) fn check_contour_of_call(&mut self) {
        let Some(frame) = self.frames.last_mut() else { return };
        let Some(contour) = frame.contour.take() else { return };
        let [x, y] = frame.entry;
        let (dx, dy) = (self.kernel.state.position[0] - x, self.kernel.state.position[1] - y);
        let near = self.control.parameters.rules.least_increment(self.kernel.state.units);
        if dx.abs() <= 2.0 * near && dy.abs() <= 2.0 * near {
            return;
        }
        let (dx, dy) = (self.kernel.length_text(dx), self.kernel.length_text(dy));
        self.kernel.report(
            Diagnostic::new(
                Code::EndsOutside,
                self.kernel.origin.span,
                format!("this subprogram ends X {dx}, Y {dy} away from its start"),
            )
            .label("returns from here")
            .also(contour, "its contour in G91 starts from the position of the call")
            .help("look for missing blocks if it should come back; a second call starts here"),
        );
    }
}
