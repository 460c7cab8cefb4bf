//! Lines of any input, of bounded length.

use std::io::{BufRead, Read};

use chordal_ask::QuestionFailure;

/// Most bytes of a line: a program of a few million lines.
const LONGEST: u64 = 1 << 28;

/// A line without its end, or why it cannot be taken.
pub type Line = Result<Vec<u8>, QuestionFailure>;

/// Reads lines until the input ends or `take` does not want more. Empty lines are left out; of a line that is
/// too long the rest is read over.
pub fn read(input: &mut impl BufRead, mut take: impl FnMut(Line) -> bool) {
    loop {
        let mut line = Vec::new();
        let read = input.take(LONGEST).read_until(b'\n', &mut line);
        let told = match read {
            Ok(0) => return,
            Ok(_) if line.len() as u64 == LONGEST && line.last() != Some(&b'\n') => {
                line = Vec::new();
                if input.skip_until(b'\n').is_err() {
                    return;
                }
                Err(QuestionFailure::wrong(
                    format!("a line has more than {LONGEST} bytes"),
                    "name the file of the program instead of its text",
                ))
            }
            Ok(_) => Ok(line),
            Err(error) => {
                let told =
                    QuestionFailure::plain(format!("the input cannot be read: {error}"), None);
                take(Err(told));
                return;
            }
        };
        let is_empty = told.as_ref().is_ok_and(|line| line.iter().all(u8::is_ascii_whitespace));
        if !is_empty && !take(told) {
            return;
        }
    }
}
