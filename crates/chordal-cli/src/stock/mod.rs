//! `chordal stock`: what is left of the stock, and what is touched.

mod engagement;
mod lathe;

use std::path::{Path, PathBuf};

use chordal::motion::MotionOptions;
use chordal::stock::{EngagementOptions, StockLeft, StockOptions, StockReport, StockVerdict};
use chordal::{Job, Report};
use chordal_export::format::{STOCK_FILES, STOCK_FORMATS};
use chordal_export::report::{self, SarifReport};
use chordal_export::{
    FormatList, MeshSurface, OutputFormat, stock_json, stock_mesh, stock_png, stock_text,
};
use chordal_load::Loaded;
use clap::ArgAction;

use crate::failure::{CommandFailure, ExitVerdict};
use crate::formats::{format_of_file, format_parser};
use crate::options::{CommonArgs, ProblemDisplay, length};
use crate::output::write_whole;
use crate::programs::{load_one, recognized};
use crate::setup_files::files;
use crate::stock_failure::failure_of;
use crate::terminal::{TerminalSupport, say};
use crate::tiles::on_threads;

const EXAMPLES: &str = "\
Examples:
  chordal stock part.nc --setup op1.toml
  chordal stock part.nc --setup op1.toml --resolution 0.05mm
  chordal stock part.nc --setup op1.toml -o left.stl -o left.png
  chordal stock part.nc --setup op1.toml -o left.stl --smooth 0.02mm
  chordal stock part.nc --setup op1.toml --format json | jq .verdict
  chordal stock part.nc --setup op1.toml --engagement

The setup file names the machine, the stock and the tools:

  machine = \"haas-vf2\"
  [stock]
  shape = \"box\"
  work_offset = \"G54\"
  from = { X = \"0 mm\", Y = \"0 mm\", Z = \"-20 mm\" }
  to   = { X = \"80 mm\", Y = \"60 mm\", Z = \"0 mm\" }
  [tools.1]
  shape = \"flat\"
  diameter = \"10 mm\"
  flute_length = \"25 mm\"

Every answer lies between two bounds. Exit code 0: clean, which is proved; 1: problems, or not proved
at this resolution; 2: wrong use.

Of a lathe the half section is exact: -o part.svg, .png, .dxf, .stl, .3mf or .glb.

  [stock]
  shape = \"cylinder\"
  diameter = \"60 mm\"
  from = \"-100 mm\"
  to = \"1 mm\"";

/// Reports what a program removes, what is left, and what rapids, shank and holder touch
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// The program; `-` is standard input
    file: PathBuf,

    /// The machine, the stock and the tools
    #[arg(long, value_name = "SETUP.toml", conflicts_with = "machine")]
    setup: Option<PathBuf>,

    /// Side of a column, with its unit; without it, from the size of the stock
    #[arg(long, value_name = "LENGTH", value_parser = length)]
    resolution: Option<f64>,

    /// Where columns cannot tell they are halved, no finer than this; without it, an eighth of the resolution
    #[arg(long, value_name = "LENGTH", value_parser = length)]
    finest: Option<f64>,

    /// Touches that are no deeper are not reported
    #[arg(long, value_name = "LENGTH", default_value = "0.01mm", value_parser = length)]
    tolerance: f64,

    /// Reports how hard the cuts are: depths, chip, removal rate, power; files: .parquet, .arrow, .csv, .json
    #[arg(long)]
    engagement: bool,

    /// With --engagement: the thickest chip that a tooth may take; without it, `max_chip` of each tool
    #[arg(long, value_name = "LENGTH", value_parser = length, requires = "engagement")]
    chip: Option<f64>,

    /// Most memory for the columns, MiB
    #[arg(long, value_name = "MIB", default_value_t = 1024)]
    memory: u64,

    /// Writes what is left: `.stl`, `.3mf`, `.glb` or a picture `.png`; several times for several files
    #[arg(long, short, value_name = "OUT", action = ArgAction::Append)]
    output: Vec<PathBuf>,

    /// Meshes go smoothly through the middles of the columns, no further from them than so much, instead of in steps
    #[arg(long, value_name = "LENGTH", value_parser = length)]
    smooth: Option<f64>,

    /// Format of the answer
    #[arg(long, value_parser = format_parser(&STOCK_FORMATS), default_value = "text")]
    format: OutputFormat,

    #[command(flatten)]
    showing: ProblemDisplay,

    #[command(flatten)]
    common: CommonArgs,
}

/// What a program leaves of the stock of the setup; columns are cut on threads.
pub fn left(
    job: &Job<'_>,
    options: &StockOptions,
    setup: Option<&Path>,
) -> Result<StockLeft, CommandFailure> {
    job.stock_left(options, &files, &on_threads).map_err(|error| failure_of(error, setup))
}

pub fn run(mut args: Args, terminal: TerminalSupport) -> Result<ExitVerdict, CommandFailure> {
    args.common.set_up(args.setup.as_deref());
    let options = StockOptions {
        resolution_mm: args.resolution,
        finest_mm: args.finest,
        tolerance_mm: args.tolerance,
        budget: args.memory.saturating_mul(1 << 20),
    };
    let loaded = load_one(&args.file, &args.common)?;
    let job = loaded.job()?;
    if job.turns() {
        return lathe::run(&args, &loaded, &job, terminal);
    }
    if args.engagement {
        let options = EngagementOptions { stock: options, max_chip_mm: args.chip };
        return engagement::run(&args, &options, &loaded, terminal);
    }
    let formats = args.formats(&STOCK_FILES, "a known format", "the extensions are")?;
    let mut found = job
        .stock_by(&options, &files, &on_threads)
        .map_err(|error| failure_of(error, args.setup.as_deref()))?;
    // Where the limits of the axes are wrong there are no times; `chordal time` says why.
    if let Ok(timed) = job.time(&MotionOptions::default()) {
        found.take_times(&timed.time.tools);
    }
    args.write(formats, |path, format| content(&found, format, args.smooth, path))?;
    let answer = StockAnswer {
        report: &found.report,
        text: &|| stock_text(&found),
        json: &|| stock_json(&found, loaded.name()),
        note: "",
        is_fine: found.verdict == StockVerdict::Clean,
    };
    args.give(&answer, &loaded, &job, terminal)
}

/// What a run on stock came to.
struct StockAnswer<'a> {
    report: &'a Report,
    text: &'a dyn Fn() -> String,
    json: &'a dyn Fn() -> String,
    /// The last line of the text.
    note: &'a str,
    is_fine: bool,
}

impl Args {
    /// The formats of the files to write. What each must be, and what stands before the endings, is for messages.
    fn formats(
        &self,
        list: &FormatList,
        kind: &str,
        endings: &str,
    ) -> Result<Vec<OutputFormat>, CommandFailure> {
        let none = |name| format!("the extension of {name} is not {kind}");
        self.output.iter().map(|path| format_of_file(list, path, none, endings)).collect()
    }

    fn write(
        &self,
        formats: Vec<OutputFormat>,
        content: impl Fn(&Path, OutputFormat) -> Result<Vec<u8>, CommandFailure>,
    ) -> Result<(), CommandFailure> {
        let mut files = self.output.iter().zip(formats);
        files.try_for_each(|(path, format)| write_whole(path, &content(path, format)?))
    }

    fn give(
        &self,
        answer: &StockAnswer<'_>,
        loaded: &Loaded,
        job: &Job<'_>,
        terminal: TerminalSupport,
    ) -> Result<ExitVerdict, CommandFailure> {
        match self.format {
            OutputFormat::Json => say(&(answer.json)())?,
            OutputFormat::Sarif => {
                let mut sarif = SarifReport::new();
                sarif.add(answer.report, job.sources());
                say(&sarif.finish())?;
            }
            _ => {
                terminal.write_error(&recognized(loaded));
                if answer.report.worst().is_some() {
                    let detail = self.showing.detail();
                    say(&report::text(answer.report, job.sources(), terminal.out, detail))?;
                }
                say(&(answer.text)())?;
                for path in &self.output {
                    say(&format!("written: {}\n", path.display()))?;
                }
                say(answer.note)?;
            }
        }
        Ok(if answer.is_fine { ExitVerdict::Clean } else { ExitVerdict::Problems })
    }
}

fn content(
    found: &StockReport,
    format: OutputFormat,
    smooth: Option<f64>,
    path: &Path,
) -> Result<Vec<u8>, CommandFailure> {
    let help = match smooth {
        Some(_) => "use another resolution, or leave --smooth out",
        None => "use a larger resolution",
    };
    let wrong = |message: String| CommandFailure::wrong(message, help);
    if format == OutputFormat::Png {
        return stock_png(found).map_err(|error| wrong(error.to_string()));
    }
    let name = path.file_stem().unwrap_or_default().to_string_lossy();
    let steps = MeshSurface::Steps(0.1 * found.resolution_mm);
    let surface = smooth.map_or(steps, MeshSurface::Smooth);
    stock_mesh(found, format, surface, &name).map_err(|error| wrong(error.to_string()))
}
