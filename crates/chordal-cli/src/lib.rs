//! The `chordal` command: arguments and files in, text and files out.
//!
//! The command is a library, so that another shell can offer it. One file per subcommand; `options`
//! holds the arguments that several share, `programs` loads what they name (with `chordal-load`),
//! `output` writes files whole or not at all.
//!
//! ```
//! let words = ["chordal", "explain", "G83", "--machine", "haas-vf2"];
//! assert_eq!(chordal_cli::run(words.map(Into::into)), 0);
//! ```

#![allow(
    clippy::disallowed_methods,
    clippy::disallowed_types,
    reason = "a shell: files, terminal and clock are its business, so that they are nobody else's"
)]

mod archive;
mod calc;
mod calibrate;
mod changed;
mod check;
mod chords;
mod collide;
mod commands;
mod comp_range;
mod compare;
mod completions;
mod convert;
mod explain;
mod failure;
mod formats;
mod lsp;
mod machines;
mod optimize;
mod options;
mod out;
mod output;
mod passes;
mod path;
mod pecks;
mod programs;
mod readings;
mod report;
mod restart;
mod rows;
mod run;
mod sample;
mod serve;
mod setup_files;
mod sheet;
mod stock;
mod stock_failure;
mod stream;
mod summary;
mod terminal;
mod tiles;
mod time;
mod transform;
mod unified;
mod view;

use std::ffi::OsString;

use chordal_export::numbers;
use clap::{ColorChoice, Parser, Subcommand};

use crate::failure::{CommandFailure, ExitVerdict};
use crate::terminal::TerminalSupport;

const ABOUT: &str = "Runs CNC programs exactly as their control would";

const LONG_ABOUT: &str = "\
Runs CNC programs exactly as their control would: Fadal, Haas, Fanuc, Mitsubishi, LinuxCNC, GRBL,
Mach3, Marlin, Sinumerik, HEIDENHAIN.

Chordal reads the program with the rules of one control, says where that control would stop
and why, and gives the exact path of the tool. It recognizes from the text for which control a
program was written; give --machine if you know better.";

const EXAMPLES: &str = "\
Examples:
  chordal run part.nc                        what it does, how long, where it would stop
  chordal run part.nc -o part.svg            the same, and a picture
  chordal view part.nc                       program and path side by side, in the browser
  chordal time part.nc                       how long it takes, where and why
  chordal report part.nc -o setup.html       a setup sheet to print or mail
  chordal stock part.nc --setup op1.toml     what is left of the stock, and what is touched
  chordal collide part.nc --setup op1.toml   which bodies of machine, fixtures and tools touch
  chordal check archive/                     problems of every program in a folder
  chordal archive check archive/ --out results.parquet
                                             all of a folder tree as one table
  chordal compare released.nc returned.nc    how far apart the paths of two programs are
  chordal diff before/ after/                what changed in two folders: motion, times, problems
  chordal convert part.nc --to haas-vf2      the program for another machine, with a proof
  chordal transform part.nc --rotate 30      the same part, rotated, with a proof
  chordal restart part.nc --line 120         the program from line 120 on, with a proof
  chordal optimize part.nc --setup op1.toml  feeds by what the tool meets, with a proof
  chordal run part.nc --machine haas-vf2     as a Haas would, for whatever control it was written
  chordal explain CH401                      what a message means
  chordal explain M17 --machine fadal-4020   what a code does
  chordal machines haas-vf2                  a machine and its control's settings

Exit code: 0 clean, 1 problems in the program, 2 wrong use or a file that cannot be read.";

#[derive(Parser)]
#[command(name = "chordal", version, about = ABOUT, long_about = LONG_ABOUT, after_help = EXAMPLES)]
#[command(propagate_version = true, subcommand_required = true, arg_required_else_help = true)]
struct Cli {
    #[command(subcommand)]
    command: CliCommand,

    /// When to use colours; auto: on a terminal, unless NO_COLOR is set
    #[arg(long, global = true, value_name = "WHEN", default_value = "auto")]
    #[arg(hide_default_value = true, display_order = 100)]
    color: ColorChoice,
}

#[derive(Subcommand)]
enum CliCommand {
    Run(run::Args),
    View(view::Args),
    Time(time::Args),
    Report(report::Args),
    Calibrate(calibrate::Args),
    Check(check::Args),
    Archive(archive::Args),
    Compare(compare::Args),
    Diff(Box<archive::diff::Args>),
    Convert(convert::Args),
    Transform(Box<transform::Args>),
    Restart(restart::Args),
    Optimize(Box<optimize::Args>),
    Commands(commands::Args),
    Path(path::Args),
    Stock(Box<stock::Args>),
    Collide(Box<collide::Args>),
    CompRange(comp_range::Args),
    Chords(chords::Args),
    Sample(sample::Args),
    Calc(Box<calc::Args>),
    Explain(explain::Args),
    Machines(machines::Args),
    Lsp(lsp::Args),
    Serve(serve::Args),
    Stream(stream::Args),
    Completions(completions::Args),
}

impl CliCommand {
    fn carry_out(self, terminal: TerminalSupport) -> Result<ExitVerdict, CommandFailure> {
        match self {
            CliCommand::Run(args) => run::run(args, terminal),
            CliCommand::View(args) => view::run(args, terminal),
            CliCommand::Time(args) => time::run(&args, terminal),
            CliCommand::Report(mut args) => report::run(&mut args, terminal),
            CliCommand::Calibrate(args) => calibrate::run(&args),
            CliCommand::Check(args) => check::run(args, terminal),
            CliCommand::Archive(args) => archive::run(&args, terminal),
            CliCommand::Compare(args) => compare::run(&args, terminal),
            CliCommand::Diff(args) => archive::diff::run(&args, terminal),
            CliCommand::Convert(args) => convert::run(&args, terminal),
            CliCommand::Transform(args) => transform::run(&args, terminal),
            CliCommand::Restart(mut args) => restart::run(&mut args, terminal),
            CliCommand::Optimize(mut args) => optimize::run(&mut args, terminal),
            CliCommand::Commands(args) => commands::run(&args, terminal),
            CliCommand::Path(args) => path::run(&args, terminal),
            CliCommand::Stock(args) => stock::run(*args, terminal),
            CliCommand::Collide(args) => collide::run(*args, terminal),
            CliCommand::CompRange(args) => comp_range::run(&args),
            CliCommand::Chords(args) => chords::run(&args, terminal),
            CliCommand::Sample(args) => sample::run(&args, terminal),
            CliCommand::Calc(args) => calc::run(&args),
            CliCommand::Explain(args) => explain::run(&args),
            CliCommand::Machines(args) => machines::run(&args),
            CliCommand::Lsp(args) => lsp::run(args),
            CliCommand::Serve(args) => serve::run(&args),
            CliCommand::Stream(args) => stream::run(&args, terminal),
            CliCommand::Completions(args) => completions::run(&args),
        }
    }
}

/// What the command takes, for completions and manual pages.
pub fn command() -> clap::Command {
    <Cli as clap::CommandFactory>::command()
}

/// Runs the command with its arguments, of which the first is its own name, and says what the
/// process should end with: 0 clean, 1 problems in a program, 2 wrong use.
pub fn run(arguments: impl IntoIterator<Item = OsString>) -> u8 {
    let cli = match Cli::try_parse_from(arguments) {
        Ok(cli) => cli,
        Err(error) => {
            // Nothing can be reported when even that cannot be written.
            let _ = error.print();
            return u8::try_from(error.exit_code()).unwrap_or(2);
        }
    };
    chordal_load::ledger::begin();
    let terminal = TerminalSupport::new(cli.color);
    let verdict = cli.command.carry_out(terminal).unwrap_or_else(|failure| {
        terminal.failure(&failure);
        failure.verdict()
    });
    verdict as u8
}
