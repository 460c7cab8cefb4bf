//! Edits of a text that are made only where it runs the same after them.

use std::hash::{DefaultHasher, Hash, Hasher};

use chordal::control::CommandKind;
use chordal::diagnostics::TextRange;
use chordal::{Command, Diagnostic, RunSink, Sink};

use crate::EditorProgram;

/// A replacement of some text.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct FormatEdit {
    /// What goes.
    pub range: TextRange,
    /// What comes.
    pub text: String,
}

/// Why a text stays as it is.
#[derive(Clone, PartialEq, Eq, Debug, thiserror::Error)]
pub enum FormatError {
    /// The changed text would move otherwise.
    #[error(
        "the text was not changed: after the change it would run differently from line {line} on"
    )]
    MovesDifferently {
        /// The line of the first command that differs.
        line: u32,
    },
    /// A jump goes to a number that is computed.
    #[error("line {line} jumps to a number that it computes (`{text}`): numbers must stay")]
    ComputedJump {
        /// Where.
        line: u32,
        /// The line.
        text: String,
    },
    /// A number stands twice in a program, and something jumps to it.
    #[error("N{number} appears twice, and line {line} jumps to it")]
    Ambiguous {
        /// The number.
        number: i64,
        /// Where the jump is.
        line: u32,
    },
    /// Only word-address blocks have numbers.
    #[error("lines of this language have no block numbers")]
    OtherLanguage,
    /// Numbers grow beyond what the control reads.
    #[error("the last number would be N{last}, more than {most}")]
    TooLarge {
        /// The last number.
        last: u64,
        /// The largest allowed.
        most: u32,
    },
}

impl EditorProgram {
    /// The text after edits, which are in order and do not overlap.
    pub fn edited(&self, edits: &[FormatEdit]) -> Vec<u8> {
        let text = self.text();
        let mut edited = Vec::with_capacity(text.len());
        let mut at = 0;
        for edit in edits {
            edited.extend_from_slice(&text[at..edit.range.start as usize]);
            edited.extend_from_slice(edit.text.as_bytes());
            at = edit.range.end as usize;
        }
        edited.extend_from_slice(&text[at..]);
        edited
    }

    /// The edits, if the text runs the same after them.
    pub(crate) fn proved(&self, edits: Vec<FormatEdit>) -> Result<Vec<FormatEdit>, FormatError> {
        if edits.is_empty() {
            return Ok(edits);
        }
        let edited = self.with_text(self.edited(&edits));
        let (mut before, mut after) = (RunTrace::new(self), RunTrace::new(&edited));
        self.job().run(&mut before);
        edited.job().run(&mut after);
        let pairs = before.steps.iter().zip(&after.steps);
        let differs = pairs.into_iter().find(|((_, one), (_, two))| one != two);
        let line = match differs {
            Some(((line, _), _)) => *line,
            None if before.steps.len() == after.steps.len() => return Ok(edits),
            None => {
                let common = before.steps.len().min(after.steps.len());
                before.steps.get(common).or(before.steps.last()).map_or(1, |(line, _)| *line)
            }
        };
        Err(FormatError::MovesDifferently { line })
    }
}

/// Everything that a run does, without the places in the text: a line and a digest for each.
struct RunTrace<'a> {
    program: &'a EditorProgram,
    steps: Vec<(u32, u64)>,
    line: u32,
}

impl<'a> RunTrace<'a> {
    fn new(program: &'a EditorProgram) -> RunTrace<'a> {
        RunTrace { program, steps: Vec::new(), line: 1 }
    }

    fn push(&mut self, step: &str) {
        let mut hasher = DefaultHasher::new();
        step.hash(&mut hasher);
        self.steps.push((self.line, hasher.finish()));
    }
}

impl Sink for RunTrace<'_> {
    fn command(&mut self, command: &Command) {
        self.line = command.origin.line;
        match &command.kind {
            CommandKind::Message(range) => {
                let file = self.program.file_text(command.origin.span.file);
                self.push(&as_written(file, *range));
            }
            kind => self.push(&format!("{kind:?}")),
        }
    }

    fn diagnostic(&mut self, diagnostic: Diagnostic) {
        self.push(diagnostic.code.info().id);
    }
}

impl RunSink for RunTrace<'_> {}

/// A part of a text.
pub(crate) fn as_written(text: &[u8], range: TextRange) -> String {
    String::from_utf8_lossy(range.slice(text)).into_owned()
}
