//! What is not known, and so not proved: each reason once.

use chordal_diagnostics::{Code, Diagnostic, Span};

/// Collects what is not proved.
#[derive(Debug, Default)]
pub(super) struct CollisionDoubts {
    pub diagnostics: Vec<Diagnostic>,
    reasons: Vec<String>,
}

impl CollisionDoubts {
    /// Adds a reason with the block where it first counts, unless it is known.
    pub fn add(&mut self, span: Span, reason: String, help: &str) {
        if self.reasons.contains(&reason) {
            return;
        }
        let diagnostic = Diagnostic::new(Code::CollisionNotProved, span, reason.clone());
        self.diagnostics.push(diagnostic.help(help));
        self.reasons.push(reason);
    }
}
