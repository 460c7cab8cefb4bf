//! Arguments that several commands share.

use std::path::{Path, PathBuf};

use chordal::machine::{QuantityDimension, QuantityError, parse_quantity};
use chordal::syntax::scan_program_name;
use chordal::{EVERY_PLACE, KEPT_PER_CODE};
use chordal_export::report::ReportDetail;
use chordal_load::{BlockDeleteSwitch, Request, RequestedMachine};
use clap::ValueEnum;

/// How the switch of block delete stands.
#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
pub enum BlockDeleteName {
    /// The blocks that start with `/` are skipped
    On,
    /// The program is run with and without them
    Both,
}

/// What the request says of block delete.
pub fn block_delete_of(name: Option<BlockDeleteName>) -> BlockDeleteSwitch {
    match name {
        None => BlockDeleteSwitch::AsMachine,
        Some(BlockDeleteName::On) => BlockDeleteSwitch::On,
        Some(BlockDeleteName::Both) => BlockDeleteSwitch::Both,
    }
}

/// What all commands that run a program share.
#[derive(clap::Args, Clone, Debug)]
#[command(next_help_heading = "Machine")]
pub struct CommonArgs {
    /// The machine: a built-in name (see `chordal machines`) or a machine file
    ///
    /// Without it, `chordal.toml` in the program's folder decides, or else the control is
    /// recognized from the program.
    #[arg(long, short, value_name = "NAME|FILE.toml")]
    pub machine: Option<String>,

    /// Overrides any key of the machine, such as `tools.5.diameter="0.5 in"`
    ///
    /// Also `"settings.Setting 58=fanuc"`, `work_offsets.G54.X="10 in"`, `control=haas`, `#500=1.5`.
    /// `chordal machines --schema` lists the keys.
    #[arg(long = "set", visible_alias = "assume", value_name = "KEY=VALUE")]
    pub set: Vec<String>,

    /// Takes a GRBL machine's settings from what it printed for `$$`
    #[arg(long, value_name = "dump.txt")]
    pub settings: Option<PathBuf>,

    /// Tools from a LinuxCNC tool table, in the machine's units at power-on
    #[arg(long, value_name = "tool.tbl")]
    pub tools: Option<PathBuf>,

    /// Runs only this program of the file, such as `1000` or `O1000`
    #[arg(long, value_name = "N", value_parser = program_number)]
    pub program: Option<u32>,

    /// Block delete: skips the blocks that start with `/`; `=both` runs the program both ways
    #[arg(long, value_enum, value_name = "WHICH", num_args = 0..=1, require_equals = true, default_missing_value = "on")]
    pub block_delete: Option<BlockDeleteName>,

    /// Largest number of blocks carried out in calls, repeats and jumps before a program counts as endless
    #[arg(long, value_name = "N")]
    pub max_blocks: Option<u64>,
}

impl CommonArgs {
    /// Takes the machine from a setup file, which names it.
    pub fn set_up(&mut self, setup: Option<&Path>) {
        if let Some(setup) = setup {
            self.machine = Some(setup.to_string_lossy().into_owned());
        }
    }

    /// What the arguments say, for loading.
    pub fn request(&self) -> Request {
        Request {
            machine: self.machine.clone().map(RequestedMachine::Name),
            set: self.set.clone(),
            settings: self.settings.clone(),
            tools: self.tools.clone(),
            program: self.program,
            block_delete: block_delete_of(self.block_delete),
            max_blocks: self.max_blocks,
            ..Request::default()
        }
    }
}

/// How much is shown of the problems.
#[derive(clap::Args, Clone, Copy, Debug)]
#[command(next_help_heading = "Problems")]
pub struct ProblemDisplay {
    /// Shows so many places of each code in full; without it as many as fit a screen
    #[arg(long, value_name = "N", conflicts_with_all = ["quiet", "verbose"])]
    max: Option<usize>,

    /// One line for each code
    #[arg(long, short)]
    quiet: bool,

    /// Every place in full
    #[arg(long, short, conflicts_with = "quiet")]
    verbose: bool,
}

impl ProblemDisplay {
    /// For the text of a report.
    pub fn detail(self) -> ReportDetail {
        match (self.quiet, self.verbose, self.max) {
            (true, ..) => ReportDetail::Lines,
            (_, true, _) => ReportDetail::All,
            (.., Some(most)) => ReportDetail::Places(most),
            _ => ReportDetail::default(),
        }
    }

    /// How many problems of each code must be kept for it.
    pub fn kept(self) -> usize {
        if self.verbose { EVERY_PLACE } else { KEPT_PER_CODE.max(self.max.unwrap_or(0)) }
    }
}

/// `1000`, `O1000`, `o1000`, `:1000`.
fn program_number(text: &str) -> Result<u32, String> {
    if let Some((number, _)) = scan_program_name(text.as_bytes()) {
        return Ok(number);
    }
    let digits = text.strip_prefix(['O', 'o', ':']).unwrap_or(text);
    digits.parse().map_err(|_| "write a program number, such as `1000` or `O1000`".to_string())
}

/// A quantity with its unit, in that of its dimension; what is wrong with it in words.
pub fn quantity(text: &str, dimension: QuantityDimension) -> Result<f64, String> {
    parse_quantity(text, dimension).map_err(|error| wrong_quantity(&error))
}

/// A length above zero with its unit, mm.
pub fn length(text: &str) -> Result<f64, String> {
    match quantity(text, QuantityDimension::Length)? {
        mm if mm > 0.0 => Ok(mm),
        _ => Err("the length must be above zero".to_string()),
    }
}

/// What is wrong with a quantity, and what to write.
pub fn wrong_quantity(error: &QuantityError) -> String {
    match error.help() {
        Some(help) => format!("{error}; {help}"),
        None => error.to_string(),
    }
}
