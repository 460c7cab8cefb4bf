//! Lines of any input, of bounded length.

use std::io::{BufRead, Read};

use chordal_ask::QuestionFailure;

/// Most bytes of a line: a program of a few million lines.
const MAX_LINE_BYTES: u64 = 1 << 28;

/// A line without its end, or why it cannot be taken.
pub type InputLine = Result<Vec<u8>, QuestionFailure>;

/// Reads lines until the input ends or `take` does not want more. Empty lines are left out; of a line that is
/// too long the rest is read over.
pub fn read(input: &mut impl BufRead, mut take: impl FnMut(InputLine) -> bool) {
    loop {
        let mut line = Vec::new();
        let read = input.take(MAX_LINE_BYTES).read_until(b'\n', &mut line);
        let reported = match read {
            Ok(0) => return,
            Ok(_) if line.len() as u64 == MAX_LINE_BYTES && line.last() != Some(&b'\n') => {
                line = Vec::new();
                if input.skip_until(b'\n').is_err() {
                    return;
                }
                Err(QuestionFailure::wrong(
                    format!("a line has more than {MAX_LINE_BYTES} bytes"),
                    "name the file of the program instead of its text",
                ))
            }
            Ok(_) => Ok(line),
            Err(error) => {
                let failure =
                    QuestionFailure::plain(format!("the input cannot be read: {error}"), None);
                take(Err(failure));
                return;
            }
        };
        let is_empty = reported.as_ref().is_ok_and(|line| line.iter().all(u8::is_ascii_whitespace));
        if !is_empty && !take(reported) {
            return;
        }
    }
}
