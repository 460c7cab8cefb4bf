//! The `chordal` command.

use std::process::ExitCode;

#[allow(clippy::disallowed_methods, reason = "a shell: its arguments come from the environment")]
fn main() -> ExitCode {
    ExitCode::from(chordal_cli::run(std::env::args_os()))
}
