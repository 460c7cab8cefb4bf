//! Errors in machine files, with the text that they underline.

use std::fmt;
use std::ops::Range;
use std::sync::Arc;

/// A problem in a machine file, an assignment or a tool table.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{}: {message}", self.place())]
pub struct MachineError {
    /// The problem, for users.
    pub message: String,
    /// How to correct it; `None` if there is no advice.
    pub help: Option<String>,
    /// The name of the file, as passed in.
    pub file: String,
    /// The bytes of `text` to underline; `None` if something is missing in the file.
    pub span: Option<Range<usize>>,
    /// The whole text of the file.
    pub text: Arc<str>,
}

impl MachineError {
    /// The line of the start of the span, from 1; `None` without a span.
    pub fn line(&self) -> Option<usize> {
        let before = &self.text.as_bytes()[..self.span.as_ref()?.start.min(self.text.len())];
        Some(1 + before.iter().filter(|byte| **byte == b'\n').count())
    }

    /// The location as text: `file:line`.
    fn place(&self) -> String {
        match self.line() {
            Some(line) => format!("{}:{line}", self.file),
            None => self.file.clone(),
        }
    }

    /// The text that the span underlines; empty without a span.
    pub fn underlined(&self) -> &str {
        self.span.clone().and_then(|span| self.text.get(span)).unwrap_or("")
    }
}

/// The position of a value in a file.
#[derive(Clone, PartialEq, Eq)]
pub struct ValueLocation {
    /// The name of the file.
    pub file: Arc<str>,
    /// The position in `text`, bytes.
    pub span: Range<usize>,
    /// The whole text of the file.
    pub text: Arc<str>,
}

impl fmt::Debug for ValueLocation {
    /// Omits the text of the file.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}..{}", self.file, self.span.start, self.span.end)
    }
}

/// A text with errors. Spans are relative to `shift`.
#[derive(Clone)]
pub(crate) struct ErrorSource {
    pub(crate) file: Arc<str>,
    pub(crate) text: Arc<str>,
    pub(crate) shift: usize,
}

impl ErrorSource {
    pub(crate) fn new(file: &str, text: &str) -> Self {
        ErrorSource { file: file.into(), text: text.into(), shift: 0 }
    }

    /// The span in the whole text, limited to its bounds and to whole characters.
    pub(crate) fn span(&self, span: Range<usize>) -> Range<usize> {
        let clamped = |at: usize| {
            let at = (at + self.shift).min(self.text.len());
            (0..=at).rev().find(|at| self.text.is_char_boundary(*at)).unwrap_or(0)
        };
        let start = clamped(span.start);
        start..clamped(span.end).max(start)
    }

    pub(crate) fn error(
        &self,
        span: Option<Range<usize>>,
        message: impl Into<String>,
        help: Option<String>,
    ) -> MachineError {
        let span = span.map(|span| self.span(span));
        MachineError {
            message: message.into(),
            help,
            file: self.file.to_string(),
            span,
            text: self.text.clone(),
        }
    }

    pub(crate) fn location(&self, span: Range<usize>) -> ValueLocation {
        ValueLocation { file: self.file.clone(), span: self.span(span), text: self.text.clone() }
    }
}
