//! The receiver of a run's commands and diagnostics.

use chordal_diagnostics::Diagnostic;

use crate::command::Command;

/// Receives the commands and diagnostics of a run in their order.
pub trait Sink {
    /// Receives a command.
    fn command(&mut self, command: &Command);
    /// Receives a diagnostic.
    fn diagnostic(&mut self, diagnostic: Diagnostic);
}

/// Takes nothing.
impl Sink for () {
    fn command(&mut self, _: &Command) {}
    fn diagnostic(&mut self, _: Diagnostic) {}
}
