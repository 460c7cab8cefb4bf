//! A diagnostic and its parts: labels, notes, fixes.

use crate::{Code, Severity, Span};

/// A span of a source with a text about it.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Label {
    /// The labelled words.
    pub span: Span,
    /// The text of the label; may be empty.
    pub text: String,
}

/// Whether a fix may be applied without asking the user.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Applicability {
    /// The fix certainly keeps or restores what was meant.
    Safe,
    /// The fix is probably what was meant; a person must check it.
    Unsafe,
}

/// A replacement of some words.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Fix {
    /// What it does, as an imperative: "write `I2.`".
    pub title: String,
    /// The words that are replaced.
    pub span: Span,
    /// The replacement.
    pub replacement: String,
    /// Whether it may be applied without asking.
    pub applicability: Applicability,
}

/// One problem of a program.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Diagnostic {
    /// The registered code.
    pub code: Code,
    /// The severity in this case.
    pub severity: Severity,
    /// One sentence with the measured numbers in the program's units.
    pub message: String,
    /// The words that cause it.
    pub primary: Label,
    /// Other words that matter.
    pub secondary: Vec<Label>,
    /// The message that the user's own control would show; `None` when unknown.
    pub alarm: Option<String>,
    /// Further information.
    pub notes: Vec<String>,
    /// The advice for the user; `None` when there is none.
    pub help: Option<String>,
    /// The most likely fix; `None` without one.
    pub fix: Option<Fix>,
    /// Alternative fixes, the most likely one first.
    pub other_fixes: Vec<Fix>,
    /// The calls through which the block was reached, the innermost first.
    pub calls: Vec<Span>,
}

impl Diagnostic {
    /// A problem at a span, with the registered severity.
    pub fn new(code: Code, span: Span, message: impl Into<String>) -> Diagnostic {
        Diagnostic {
            code,
            severity: code.info().severity,
            message: message.into(),
            primary: Label { span, text: String::new() },
            secondary: Vec::new(),
            alarm: None,
            notes: Vec::new(),
            help: None,
            fix: None,
            other_fixes: Vec::new(),
            calls: Vec::new(),
        }
    }

    /// Sets the label of the underlined words.
    pub fn label(mut self, text: impl Into<String>) -> Diagnostic {
        self.primary.text = text.into();
        self
    }

    /// Adds a label for other words.
    pub fn also(mut self, span: Span, text: impl Into<String>) -> Diagnostic {
        self.secondary.push(Label { span, text: text.into() });
        self
    }

    /// Sets the message that the user's own control would show.
    pub fn alarm(mut self, text: impl Into<String>) -> Diagnostic {
        self.alarm = Some(text.into());
        self
    }

    /// Adds a note.
    pub fn note(mut self, text: impl Into<String>) -> Diagnostic {
        self.notes.push(text.into());
        self
    }

    /// Sets the advice.
    pub fn help(mut self, text: impl Into<String>) -> Diagnostic {
        self.help = Some(text.into());
        self
    }

    /// Sets the fix.
    pub fn fix(mut self, fix: Fix) -> Diagnostic {
        self.fix = Some(fix);
        self
    }

    /// The fix and its alternatives.
    pub fn fixes(&self) -> impl Iterator<Item = &Fix> {
        self.fix.iter().chain(&self.other_fixes)
    }

    /// Sets another severity than the registered one.
    pub fn severity(mut self, severity: Severity) -> Diagnostic {
        self.severity = severity;
        self
    }
}
