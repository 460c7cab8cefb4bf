//! Active comments: `(MSG, …)`, `(PRINT, …)`, `(DEBUG, …)`, `(LOG, …)`, `(ABORT, …)`
//! (LinuxCNC "Comments"). Only the last comment of a line acts.

use chordal_command::CommandKind;
use std::fmt::Write;

use chordal_diagnostics::{Code, Diagnostic, TextRange};

use super::super::{BlockFlow, EndReason, Interpreter};
use crate::macros::evaluate::ValuePurpose;

/// What a comment does with its text.
enum CommentAction {
    Show,
    Print,
    Abort,
}

impl Interpreter<'_> {
    /// Carries out the last comment of a line; `Some` when it ends the run.
    #[cold]
    pub(in super::super) fn acting_comment(&mut self, comments: &[TextRange]) -> Option<BlockFlow> {
        let text = self.reader.text();
        let comment = comments.iter().rfind(|range| range.slice(text).first() == Some(&b'('))?;
        let (act, inner) = act_of(text, *comment)?;
        match act {
            CommentAction::Show => self.kernel.emit(CommandKind::Message(inner)),
            CommentAction::Print => {
                let line = self.expanded(inner);
                self.print_text(inner, line);
            }
            CommentAction::Abort => {
                let line = self.expanded(inner);
                let shown = line.trim();
                let title = self.control.table.title;
                self.kernel.report(
                    Diagnostic::new(
                        Code::ProgramAlarm,
                        self.span(*comment),
                        format!("the program stops itself: {shown}"),
                    )
                    .label("the run ends here")
                    .alarm(format!("{title}: {shown}"))
                    .help("check the conditions that lead to this line"),
                );
                return Some(BlockFlow::End(EndReason::Alarm));
            }
        }
        None
    }

    /// The text with the values of its parameters, with six decimals; `%d` (none), `%f` (four) and `%.3f` change
    /// the number of decimals from there on.
    fn expanded(&mut self, range: TextRange) -> String {
        let text = self.reader.text();
        let bytes = range.slice(text);
        let mut line = String::new();
        let mut decimals = 6;
        let mut plain = 0;
        let mut at = 0;
        let shown = |part: &[u8]| String::from_utf8_lossy(part).into_owned();
        while at < bytes.len() {
            let after = &bytes[at + 1..];
            if bytes[at] == b'%'
                && let Some((places, length)) = format_of(after, decimals)
            {
                line += &shown(&bytes[plain..at]);
                decimals = places;
                at += 1 + length;
                plain = at;
            } else if bytes[at] == b'#'
                && after.first().is_some_and(|b| b.is_ascii_digit() || *b == b'<')
            {
                line += &shown(&bytes[plain..at]);
                let start = range.start + at as u32;
                let digits = after.iter().take_while(|b| b.is_ascii_digit()).count();
                let length = match after[0] {
                    b'<' => after.iter().position(|b| *b == b'>').map_or(after.len(), |n| n + 1),
                    _ => digits,
                };
                let value = TextRange::new(start, start + 1 + length as u32);
                match self.word_value(value, ValuePurpose::VALUE) {
                    Some(value) => match value.known() {
                        Some(value) => {
                            let _ = write!(line, "{value:.decimals$}");
                        }
                        None => line.push('?'),
                    },
                    None => line += "######",
                }
                at += 1 + length;
                plain = at;
            } else {
                at += 1;
            }
        }
        line += &shown(&bytes[plain..]);
        line
    }
}

/// The action of a comment, and the text after its keyword; `None` for an ordinary comment.
fn act_of(text: &[u8], comment: TextRange) -> Option<(CommentAction, TextRange)> {
    let bytes = comment.slice(text);
    let comma = bytes.iter().take(16).position(|b| *b == b',')?;
    let word: Vec<u8> =
        bytes[1..comma].iter().filter(|b| **b != b' ').map(u8::to_ascii_uppercase).collect();
    let act = match word.as_slice() {
        b"MSG" => CommentAction::Show,
        b"PRINT" | b"DEBUG" | b"LOG" => CommentAction::Print,
        b"ABORT" => CommentAction::Abort,
        _ => return None,
    };
    let start = comment.start + comma as u32 + 1;
    let end = comment.end - u32::from(bytes.last() == Some(&b')'));
    Some((act, TextRange::new(start, end.max(start))))
}

/// `d`, `f` or `.3f` after a percent sign: the number of decimals, and the length of the format. With any other
/// text after a point only the percent sign is removed, as in LinuxCNC 2.9.
fn format_of(text: &[u8], decimals: usize) -> Option<(usize, usize)> {
    match text {
        [b'd', ..] => Some((0, 1)),
        [b'f', ..] => Some((4, 1)),
        [b'.', digit @ b'0'..=b'9', b'f', ..] => Some((usize::from(digit - b'0'), 3)),
        [b'.', ..] => Some((decimals, 0)),
        _ => None,
    }
}
