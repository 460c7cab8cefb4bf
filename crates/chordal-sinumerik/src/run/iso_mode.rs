//! The ISO mode (G291), in which the control reads the codes of another language: it is not read.

use chordal_command::AxisMask;
use chordal_diagnostics::TextRange;

use super::interpreter::Interpreter;

impl Interpreter<'_> {
    /// Leaves out the blocks up to the one with G290: they are not those of this language, so that nothing in them is
    /// a fault, and where the machine is after them is not known.
    pub(super) fn skip_iso_mode(&mut self, range: TextRange) {
        let what = "the ISO mode of the control is not read: the blocks up to G290 are left out";
        self.not_followed(range, what);
        self.kernel.go_astray(AxisMask::ALL);
        self.lose_state();
        self.running().reader.skip_lines_until(ends_iso_mode);
    }
}

/// Whether G290 stands in a line, outside of comments.
fn ends_iso_mode(line: &[u8]) -> bool {
    let comment = memchr::memchr2(b';', b'(', line).unwrap_or(line.len());
    let code = &line[..comment];
    code.windows(4).enumerate().any(|(at, word)| {
        let follows = code.get(at + 4).is_none_or(|next| !next.is_ascii_digit());
        follows && word.eq_ignore_ascii_case(b"G290")
    })
}
