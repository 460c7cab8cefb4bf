//! Takes what a run produces, as it is produced.

use chordal_diagnostics::Diagnostic;

use crate::command::Command;

/// Takes what a run produces, as it is produced.
pub trait Sink {
    /// A command.
    fn command(&mut self, command: &Command);
    /// A problem.
    fn diagnostic(&mut self, diagnostic: Diagnostic);
}

/// Takes nothing.
impl Sink for () {
    fn command(&mut self, _: &Command) {}
    fn diagnostic(&mut self, _: Diagnostic) {}
}
