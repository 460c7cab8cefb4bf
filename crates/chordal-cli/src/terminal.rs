//! What the output streams can show, and writing to them.

use std::fmt::Display;
use std::io::{self, Write};

use anstream::{AutoStream, ColorChoice};
use chordal_load::LoadError;

use crate::failure::CommandFailure;

/// What the two output streams can show.
#[derive(Clone, Copy, Debug)]
pub struct TerminalSupport {
    /// Colours on standard output.
    pub out: bool,
    /// Colours on standard error.
    pub err: bool,
}

impl TerminalSupport {
    /// Colours as the user wishes; without a wish on terminals only, and never under
    /// `NO_COLOR`.
    pub fn new(wish: clap::ColorChoice) -> TerminalSupport {
        match wish {
            clap::ColorChoice::Always => ColorChoice::Always,
            clap::ColorChoice::Never => ColorChoice::Never,
            clap::ColorChoice::Auto => ColorChoice::Auto,
        }
        .write_global();
        TerminalSupport {
            out: AutoStream::choice(&io::stdout()) != ColorChoice::Never,
            err: AutoStream::choice(&io::stderr()) != ColorChoice::Never,
        }
    }

    /// Says why something could not be done, on standard error.
    pub fn failure(self, failure: &CommandFailure) {
        if !failure.is_closed_pipe() {
            self.write_error(&self.failure_text(failure));
        }
    }

    /// A failure as text.
    pub fn failure_text(self, failure: &CommandFailure) -> String {
        let error = style(self.err, BOLD_RED, "error:");
        match failure {
            CommandFailure::Load(LoadError::Machine(errors)) => errors
                .iter()
                .map(|error| chordal_export::machine_error_text(error, self.err))
                .collect(),
            CommandFailure::Use { message, help: Some(help) }
            | CommandFailure::Load(LoadError::Request { message, help: Some(help) }) => {
                format!("{error} {message}\n{} {help}\n", style(self.err, BOLD, "help:"))
            }
            other => format!("{error} {other}\n"),
        }
    }

    /// Writes to standard error; nothing can be reported when that fails.
    pub fn write_error(self, text: &str) {
        let _ = anstream::stderr().write_all(text.as_bytes());
    }
}

/// Writes to standard output. (`print!` would panic when the reader has gone.)
pub fn say(text: &str) -> Result<(), CommandFailure> {
    let mut out = anstream::stdout().lock();
    out.write_all(text.as_bytes())?;
    Ok(out.flush()?)
}

/// Bold.
pub const BOLD: &str = "\x1b[1m";
/// Bold and red, as errors are drawn.
pub const BOLD_RED: &str = "\x1b[1;31m";

/// A text in a style, where there are styles.
pub fn style(on: bool, code: &str, text: impl Display) -> String {
    if on { format!("{code}{text}\x1b[0m") } else { text.to_string() }
}
