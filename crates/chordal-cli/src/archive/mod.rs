//! Whole archives.

mod check;
pub mod diff;
mod progress;

use std::path::{Path, PathBuf};

use chordal::machine::ControlName;
use chordal_load::{Request, RequestedMachine};

use crate::failure::{CommandFailure, ExitVerdict};
use crate::options::{BlockDeleteName, block_delete_of};
use crate::terminal::TerminalSupport;

/// Checks whole archives of programs, and compares them
#[derive(clap::Args)]
pub struct Args {
    #[command(subcommand)]
    command: ArchiveCommand,
}

#[derive(clap::Subcommand)]
enum ArchiveCommand {
    Check(check::Args),
    /// The same as `chordal diff`
    Diff(diff::Args),
}

/// What the programs of an archive are run on.
#[derive(clap::Args, Clone, Debug)]
#[command(next_help_heading = "Machine")]
pub struct ArchiveMachines {
    /// The machine of all programs: a built-in name or a machine file
    ///
    /// Without it, `chordal.toml` in the program's folder decides, or else the control is recognized
    /// from each program.
    #[arg(long, short, value_name = "NAME|FILE.toml", conflicts_with = "control")]
    machine: Option<String>,

    /// The control of all programs, on a typical machine with it
    #[arg(long, value_name = "NAME")]
    control: Option<ControlName>,

    /// Overrides any key of the machine, such as `tools.5.diameter="0.5 in"`
    #[arg(long = "set", value_name = "KEY=VALUE")]
    set: Vec<String>,

    /// Takes a GRBL machine's settings from what it printed for `$$`
    #[arg(long, value_name = "dump.txt")]
    settings: Option<PathBuf>,

    /// Tools from a LinuxCNC tool table, in the machine's units at power-on
    #[arg(long, value_name = "tool.tbl")]
    tools: Option<PathBuf>,

    /// Block delete: skips the blocks that start with `/`; `=both` runs the program both ways
    #[arg(long, value_enum, value_name = "WHICH", num_args = 0..=1, require_equals = true, default_missing_value = "on")]
    block_delete: Option<BlockDeleteName>,

    /// Largest number of blocks carried out in calls, repeats and jumps before a program counts as endless
    #[arg(long, value_name = "N")]
    max_blocks: Option<u64>,
}

impl ArchiveMachines {
    /// With the setup file, which names the machine, where there is one.
    pub fn request(&self, setup: Option<&Path>) -> Request {
        let setup = setup.map(|setup| setup.to_string_lossy().into_owned());
        let named = setup.or_else(|| self.machine.clone()).map(RequestedMachine::Name);
        Request {
            machine: named.or(self.control.map(RequestedMachine::Control)),
            set: self.set.clone(),
            settings: self.settings.clone(),
            tools: self.tools.clone(),
            block_delete: block_delete_of(self.block_delete),
            max_blocks: self.max_blocks,
            ..Request::default()
        }
    }
}

/// As many threads as were asked for, or as the machine has.
pub fn jobs(requested: Option<usize>) -> usize {
    let all = || std::thread::available_parallelism().map_or(1, std::num::NonZero::get);
    requested.unwrap_or_else(all).max(1)
}

pub fn run(args: &Args, terminal: TerminalSupport) -> Result<ExitVerdict, CommandFailure> {
    match &args.command {
        ArchiveCommand::Check(args) => check::run(args, terminal),
        ArchiveCommand::Diff(args) => diff::run(args, terminal),
    }
}
