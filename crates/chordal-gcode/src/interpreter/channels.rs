//! A second spindle and further channels of a lathe. Each is reported once a program and not followed. Moves of the
//! second spindle alone do not affect the path of the tools.

use chordal_diagnostics::{Code, Diagnostic, TextRange};
use chordal_dialect::code_number;
use chordal_syntax::{Block, Word};

use super::Interpreter;

impl Interpreter<'_> {
    /// Reports the channel marks `$2` and `!2L1`.
    pub(super) fn check_channel(&mut self, block: &Block) {
        if let Some(range) = block.channel {
            let mark = String::from_utf8_lossy(range.slice(self.reader.text())).into_owned();
            let what = match mark.starts_with('!') {
                true => "waits for another channel",
                false => "is for one of several channels",
            };
            self.other_channel(range, &format!("{mark} {what}"));
        }
    }

    /// Reports an M code that waits for another path (Fanuc parameters 8110 and 8111); true for such a code.
    pub(super) fn waits_for_path(&mut self, word: &Word, number: i64) -> bool {
        let [first, last] = self.control.parameters.wait_codes.map(i64::from);
        let waits = last > 0 && (first..=last).contains(&number);
        if waits {
            self.other_channel(word.range, &format!("M{number} waits for another channel"));
        }
        waits
    }

    fn other_channel(&mut self, range: TextRange, what: &str) {
        if std::mem::replace(&mut self.reported.channels, true) {
            return;
        }
        let message = format!(
            "{what}: only this program is followed, not what the other channel cuts meanwhile"
        );
        self.lose_path(range, message);
    }

    /// Reports a code of the second spindle; false for any other.
    pub(super) fn is_of_second_spindle(&mut self, word: &Word) -> bool {
        let code = self.literal(word).and_then(code_number);
        let codes = self.control.table.second_spindle;
        let is_one = code.is_some_and(|code| codes.contains(&(word.letter, code)));
        if is_one {
            let name = self.word_text(word);
            self.second_spindle(word.range, &name);
        }
        is_one
    }

    /// Reports P of M3 and M4 that names the second spindle (Fanuc). The path of the tools is not affected.
    pub(super) fn check_second_spindle(&mut self, block: &Block) {
        let number = self.control.parameters.second_spindle_p;
        let word = block.last(b'P').copied().filter(|_| number > 0);
        let Some(word) = word else { return };
        let p = self.literal(&word).map(|number| number.to_f64());
        if p == Some(f64::from(number)) {
            let message = format!("P{number} names the second spindle, which is not followed");
            self.note_second_spindle(
                word.range,
                message,
                "check by other means what is cut at that spindle",
            );
        }
    }

    /// Reports an axis that carries the second spindle and that the machine file does not have: its moves are skipped.
    pub(super) fn is_axis_of_second_spindle(&mut self, letter: char, range: TextRange) -> bool {
        let is_one = self.control.parameters.second_spindle_axes.contains(&(letter as u8));
        if is_one {
            let machine = &self.machine.name;
            let message = format!(
                "the machine {machine} has no {letter} axis, which carries the second spindle: its moves are left out"
            );
            let help = format!("add `[axes.{letter}]` to the machine file");
            self.note_second_spindle(range, message, &help);
        }
        is_one
    }

    fn note_second_spindle(&mut self, range: TextRange, message: String, help: &str) {
        if std::mem::replace(&mut self.reported.second_spindle_noted, true) {
            return;
        }
        let code = Code::NotSimulated;
        self.kernel.report(
            Diagnostic::new(code, self.span(range), message)
                .label("the other axes move as written")
                .help(help),
        );
    }

    fn second_spindle(&mut self, range: TextRange, name: &str) {
        if std::mem::replace(&mut self.reported.second_spindle, true) {
            return;
        }
        let message = format!(
            "{name} is for the second spindle: how it takes the part, and what is cut there, is not followed"
        );
        self.lose_path(range, message);
    }
}
