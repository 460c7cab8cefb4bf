//! `chordal stock`: what is left of the stock, and what is touched.

use std::path::{Path, PathBuf};

use chordal::Job;
use chordal::motion::MotionOptions;
use chordal::stock::{EngagementOptions, StockLeft, StockOptions, StockReport, StockVerdict};
use chordal_export::report::{self, SarifReport};
use chordal_export::{MeshFormat, MeshSurface, stock_json, stock_mesh, stock_png, stock_text};
use clap::ArgAction;

use crate::engagement;
use crate::failure::{CommandFailure, ExitVerdict};
use crate::lathe_stock;
use crate::options::{AnswerFormat, CommonArgs, ProblemDisplay, length};
use crate::output::write_whole;
use crate::programs::{load_one, recognized};
use crate::setup_files::{SetupProblemFormat, files};
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
    #[arg(long, value_enum, default_value = "text")]
    format: SetupProblemFormat,

    #[command(flatten)]
    showing: ProblemDisplay,

    #[command(flatten)]
    common: CommonArgs,
}

/// What a file of the stock holds.
#[derive(Clone, Copy)]
enum StockFormat {
    Mesh(MeshFormat),
    Picture,
}

fn form(path: &Path) -> Result<StockFormat, CommandFailure> {
    let ending = path.extension().unwrap_or_default().to_string_lossy().to_ascii_lowercase();
    Ok(match ending.as_str() {
        "stl" => StockFormat::Mesh(MeshFormat::Stl),
        "3mf" => StockFormat::Mesh(MeshFormat::ThreeMf),
        "glb" => StockFormat::Mesh(MeshFormat::Glb),
        "png" => StockFormat::Picture,
        _ => {
            let message = format!("the extension of {} is not a known format", path.display());
            return Err(CommandFailure::wrong(
                message,
                "the extensions are .stl, .3mf, .glb, .png",
            ));
        }
    })
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
        let answer = lathe_stock::TurnedOutput {
            output: &args.output,
            format: args.format,
            detail: args.showing.detail(),
            engagement: args.engagement,
            tolerance_mm: args.tolerance,
            has_columns: args.resolution.or(args.finest).or(args.chip).is_some(),
            setup: args.setup.as_deref(),
        };
        return lathe_stock::run(&answer, &loaded, &job, terminal);
    }
    if args.engagement {
        let options = EngagementOptions { stock: options, max_chip_mm: args.chip };
        let format = match args.format {
            SetupProblemFormat::Text => AnswerFormat::Text,
            SetupProblemFormat::Json => AnswerFormat::Json,
            SetupProblemFormat::Sarif => {
                let message = "--engagement has no SARIF";
                return Err(CommandFailure::wrong(
                    message,
                    "write --format json, or leave --engagement out",
                ));
            }
        };
        let answer = engagement::EngagementOutput {
            output: &args.output,
            format,
            detail: args.showing.detail(),
            setup: args.setup.as_deref(),
        };
        return engagement::run(&answer, &options, &loaded, terminal);
    }
    let forms: Vec<StockFormat> =
        args.output.iter().map(|path| form(path)).collect::<Result<_, _>>()?;
    let mut found = job
        .stock_by(&options, &files, &on_threads)
        .map_err(|error| failure_of(error, args.setup.as_deref()))?;
    // Where the limits of the axes are wrong there are no times; `chordal time` says why.
    if let Ok(timed) = job.time(&MotionOptions::default()) {
        found.take_times(&timed.time.tools);
    }
    for (path, form) in args.output.iter().zip(forms) {
        write_whole(path, &content(&found, form, args.smooth, path)?)?;
    }
    match args.format {
        SetupProblemFormat::Text => {
            terminal.write_error(&recognized(&loaded));
            if found.report.worst().is_some() {
                let detail = args.showing.detail();
                say(&report::text(&found.report, job.sources(), terminal.out, detail))?;
            }
            say(&stock_text(&found))?;
            for path in &args.output {
                say(&format!("written: {}\n", path.display()))?;
            }
        }
        SetupProblemFormat::Json => say(&stock_json(&found, loaded.name()))?,
        SetupProblemFormat::Sarif => {
            let mut sarif = SarifReport::new();
            sarif.add(&found.report, job.sources());
            say(&sarif.finish())?;
        }
    }
    Ok(if found.verdict == StockVerdict::Clean {
        ExitVerdict::Clean
    } else {
        ExitVerdict::Problems
    })
}

fn content(
    found: &StockReport,
    form: StockFormat,
    smooth: Option<f64>,
    path: &Path,
) -> Result<Vec<u8>, CommandFailure> {
    let help = match smooth {
        Some(_) => "use another resolution, or leave --smooth out",
        None => "use a larger resolution",
    };
    let wrong = |message: String| CommandFailure::wrong(message, help);
    match form {
        StockFormat::Picture => stock_png(found).map_err(|error| wrong(error.to_string())),
        StockFormat::Mesh(format) => {
            let name = path.file_stem().unwrap_or_default().to_string_lossy();
            let steps = MeshSurface::Steps(0.1 * found.resolution_mm);
            let surface = smooth.map_or(steps, MeshSurface::Smooth);
            stock_mesh(found, format, surface, &name).map_err(|error| wrong(error.to_string()))
        }
    }
}
