//! `chordal collide`: which bodies of the machine, the setup and the tools touch.

use std::path::PathBuf;

use chordal::collision::{CollisionError, CollisionOptions, CollisionVerdict};
use chordal::stock::StockRunError;
use chordal_export::format::STOCK_FORMATS;
use chordal_export::report::{self, SarifReport};
use chordal_export::{OutputFormat, collision_json, collision_text};

use crate::failure::{CommandFailure, ExitVerdict};
use crate::formats::format_parser;
use crate::options::{CommonArgs, ProblemDisplay, length};
use crate::programs::{load_one, recognized};
use crate::setup_files::files;
use crate::stock_failure::failure_of;
use crate::terminal::{TerminalSupport, say};

const EXAMPLES: &str = "\
Examples:
  chordal collide part.nc --machine my-trunnion.toml
  chordal collide part.nc --setup op1.toml
  chordal collide part.nc --setup op1.toml --tolerance 0.02mm
  chordal collide part.nc --setup op1.toml --format json | jq .verdict

The machine file gives the bodies of the machine:

  [kinematics]
  X = \"head\"
  Y = \"table\"
  Z = \"head\"
  [solids.cradle]
  on = \"A\"
  shape = \"box\"
  from = { X = \"-700 mm\", Y = \"-400 mm\", Z = \"-700 mm\" }
  to   = { X = \"-300 mm\", Y = \"-100 mm\", Z = \"-560 mm\" }

Exit code 0: clean, which is proved; 1: collisions, or not proved; 2: wrong use.";

/// Reports which bodies of the machine, the setup and the tools touch along the moves
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// The program; `-` is standard input
    file: PathBuf,

    /// The machine, the fixtures and the tools
    #[arg(long, value_name = "SETUP.toml", conflicts_with = "machine")]
    setup: Option<PathBuf>,

    /// Bodies that touch are always found; bodies that stay so far apart are never reported
    #[arg(long, value_name = "LENGTH", default_value = "0.1mm", value_parser = length)]
    tolerance: f64,

    /// Most positions of two bodies that are looked at
    #[arg(long, value_name = "N", default_value_t = CollisionOptions::default().budget)]
    positions: u64,

    /// Format of the answer
    #[arg(long, value_parser = format_parser(&STOCK_FORMATS), default_value = "text")]
    format: OutputFormat,

    #[command(flatten)]
    showing: ProblemDisplay,

    #[command(flatten)]
    common: CommonArgs,
}

pub fn run(mut args: Args, terminal: TerminalSupport) -> Result<ExitVerdict, CommandFailure> {
    args.common.set_up(args.setup.as_deref());
    let options = CollisionOptions { tolerance_mm: args.tolerance, budget: args.positions };
    let loaded = load_one(&args.file, &args.common)?;
    let job = loaded.job()?;
    let found = job.collide(&options, &files).map_err(|error| match error {
        CollisionError::Setup(error) => {
            failure_of(StockRunError::Setup(error), args.setup.as_deref())
        }
        CollisionError::Turns => {
            CommandFailure::wrong(error.to_string(), "run `chordal stock` for a lathe")
        }
        other => CommandFailure::wrong(other.to_string(), "give another --tolerance"),
    })?;
    match args.format {
        OutputFormat::Json => say(&collision_json(&found, loaded.name()))?,
        OutputFormat::Sarif => {
            let mut sarif = SarifReport::new();
            sarif.add(&found.report, job.sources());
            say(&sarif.finish())?;
        }
        _ => {
            terminal.write_error(&recognized(&loaded));
            if found.report.worst().is_some() {
                let detail = args.showing.detail();
                say(&report::text(&found.report, job.sources(), terminal.out, detail))?;
            }
            say(&collision_text(&found))?;
        }
    }
    Ok(match found.verdict {
        CollisionVerdict::Clean => ExitVerdict::Clean,
        CollisionVerdict::Problems | CollisionVerdict::NotProved => ExitVerdict::Problems,
    })
}
