//! `chordal explain`: what a diagnostic, a code, a letter, a setting or an alarm means.

use chordal_editor::explain::{UnknownTerm, explain_on};
use chordal_load::machine;

use crate::failure::{CommandFailure, ExitVerdict};
use crate::terminal::say;

const EXAMPLES: &str = "\
Examples:
  chordal explain CH401                       a message, by its number
  chordal explain radius-mismatch             or by its name
  chordal explain G154                        a code, on every control that has it
  chordal explain M17 --machine fadal-4020    a code on one control
  chordal explain R                           a letter
  chordal explain L9601 -m fadal-4020         a letter whose number says something
  chordal explain \"Setting 40\"                a setting
  chordal explain PS0010                      an alarm of a control, by its number
  chordal explain alarm 304                   or as the control shows it
  chordal explain CYCL DEF 200                a word of HEIDENHAIN or Sinumerik programs";

/// Explains a message, a code, a letter, a setting or an alarm
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// `CH401`, `radius-mismatch`, `G2`, `G02.1`, `M17`, `R`, `L9601`, `"Setting 40"`, `alarm 304`, `CYCLE83`
    #[arg(value_name = "CODE|WORD", required = true)]
    words: Vec<String>,

    /// Only on this machine: a built-in name or a machine file
    #[arg(long, short, value_name = "NAME|FILE.toml")]
    machine: Option<String>,
}

pub fn run(args: &Args) -> Result<ExitVerdict, CommandFailure> {
    let machine = args.machine.as_deref().map(machine::named).transpose()?;
    match explain_on(&args.words.join(" "), machine.as_ref()) {
        Ok(text) => say(&text).map(|()| ExitVerdict::Clean),
        Err(UnknownTerm { message, help }) => Err(CommandFailure::Use { message, help }),
    }
}
