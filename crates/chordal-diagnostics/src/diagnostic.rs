//! A diagnostic and its parts: labels, notes, fixes.

use crate::{Code, Severity, Span};

/// Words of a source with something to say about them.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Label {
    /// The words.
    pub span: Span,
    /// What to say; may be empty.
    pub text: String,
}

/// Whether a fix may be made without asking.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Applicability {
    /// Keeps or restores what was certainly meant.
    Safe,
    /// Probably what was meant; a person must look.
    Unsafe,
}

/// A replacement of some words.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Fix {
    /// What it does, as an order: "write `I2.`".
    pub title: String,
    /// The words that go.
    pub span: Span,
    /// The words that come.
    pub replacement: String,
    /// Whether it may be made without asking.
    pub applicability: Applicability,
}

/// One problem of a program.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Diagnostic {
    /// The registered code.
    pub code: Code,
    /// How bad it is here.
    pub severity: Severity,
    /// One sentence with the measured numbers in the program's units.
    pub message: String,
    /// The words that cause it.
    pub primary: Label,
    /// Other words that matter.
    pub secondary: Vec<Label>,
    /// What the user's own control would show.
    pub alarm: Option<String>,
    /// Further facts.
    pub notes: Vec<String>,
    /// What to do.
    pub help: Option<String>,
    /// A replacement that does it.
    pub fix: Option<Fix>,
    /// Others that would do it as well, the likeliest first.
    pub other_fixes: Vec<Fix>,
    /// The calls through which the block was reached, innermost first.
    pub calls: Vec<Span>,
}

impl Diagnostic {
    /// A problem of the registered severity at some words.
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

    /// The label next to the underlined words.
    pub fn label(mut self, text: impl Into<String>) -> Diagnostic {
        self.primary.text = text.into();
        self
    }

    /// Points at other words too.
    pub fn also(mut self, span: Span, text: impl Into<String>) -> Diagnostic {
        self.secondary.push(Label { span, text: text.into() });
        self
    }

    /// What the user's own control would show.
    pub fn alarm(mut self, text: impl Into<String>) -> Diagnostic {
        self.alarm = Some(text.into());
        self
    }

    /// Adds a fact.
    pub fn note(mut self, text: impl Into<String>) -> Diagnostic {
        self.notes.push(text.into());
        self
    }

    /// What to do.
    pub fn help(mut self, text: impl Into<String>) -> Diagnostic {
        self.help = Some(text.into());
        self
    }

    /// A replacement for some words.
    pub fn fix(mut self, fix: Fix) -> Diagnostic {
        self.fix = Some(fix);
        self
    }

    /// The fix, and the others that would do.
    pub fn fixes(&self) -> impl Iterator<Item = &Fix> {
        self.fix.iter().chain(&self.other_fixes)
    }

    /// Another severity than the registered one.
    pub fn severity(mut self, severity: Severity) -> Diagnostic {
        self.severity = severity;
        self
    }
}
