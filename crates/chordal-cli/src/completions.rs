//! `chordal completions`: the script by which a shell completes the command.

use clap_complete::Shell;

use crate::failure::{CommandFailure, ExitVerdict};
use crate::terminal::say;

const EXAMPLES: &str = "\
Examples:
  chordal completions bash > ~/.local/share/bash-completion/completions/chordal
  chordal completions zsh > ~/.zfunc/_chordal
  chordal completions fish > ~/.config/fish/completions/chordal.fish
  chordal completions powershell >> $PROFILE";

/// Prints a script with which a shell completes this command
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// The shell
    shell: Shell,
}

/// Into memory first: the generator would panic on a closed pipe.
pub fn run(args: &Args) -> Result<ExitVerdict, CommandFailure> {
    let mut script = Vec::new();
    clap_complete::generate(args.shell, &mut crate::command(), "chordal", &mut script);
    say(&String::from_utf8_lossy(&script))?;
    Ok(ExitVerdict::Clean)
}
