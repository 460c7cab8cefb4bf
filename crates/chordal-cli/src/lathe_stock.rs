//! `chordal stock` for lathes: the exact half section.

use std::path::{Path, PathBuf};

use chordal::Job;
use chordal::motion::MotionOptions;
use chordal::stock::{StockVerdict, TurnedOptions, TurnedReport};
use chordal_export::columns::{ColumnFile, ColumnFormat, CutColumns, cuts_csv};
use chordal_export::report::{self, ReportDetail, SarifReport};
use chordal_export::{
    MeshFormat, PlotOptions, section_dxf, section_png, section_svg, turned_json, turned_mesh,
    turned_text, turning_json, turning_text,
};
use chordal_load::Loaded;

use crate::failure::{CommandFailure, ExitVerdict};
use crate::output::write_whole;
use crate::programs::recognized;
use crate::setup_files::{SetupProblemFormat, files};
use crate::stock_failure::failure_of;
use crate::terminal::{TerminalSupport, say};

/// What a file holds.
#[derive(Clone, Copy)]
enum TurnedFormat {
    Svg,
    Png,
    Dxf,
    Mesh(MeshFormat),
    Columns(ColumnFormat),
    Csv,
    Json,
}

fn form(path: &Path, engagement: bool) -> Result<TurnedFormat, CommandFailure> {
    let ending = path.extension().unwrap_or_default().to_string_lossy().to_ascii_lowercase();
    let found = match (ending.as_str(), engagement) {
        ("svg", false) => TurnedFormat::Svg,
        ("png", false) => TurnedFormat::Png,
        ("dxf", false) => TurnedFormat::Dxf,
        ("stl", false) => TurnedFormat::Mesh(MeshFormat::Stl),
        ("3mf", false) => TurnedFormat::Mesh(MeshFormat::ThreeMf),
        ("glb", false) => TurnedFormat::Mesh(MeshFormat::Glb),
        ("parquet", true) => TurnedFormat::Columns(ColumnFormat::Parquet),
        ("arrow", true) => TurnedFormat::Columns(ColumnFormat::Arrow),
        ("csv", true) => TurnedFormat::Csv,
        ("json", true) => TurnedFormat::Json,
        _ => {
            let message = format!("the extension of {} is not a known format", path.display());
            let help = if engagement {
                "with --engagement the extensions are .parquet, .arrow, .csv, .json"
            } else {
                "of a lathe the extensions are .svg, .png, .dxf, .stl, .3mf, .glb"
            };
            return Err(CommandFailure::wrong(message, help));
        }
    };
    Ok(found)
}

/// What is asked for in addition to the run.
pub struct TurnedOutput<'a> {
    pub output: &'a [PathBuf],
    pub format: SetupProblemFormat,
    pub detail: ReportDetail,
    /// How hard each cut is.
    pub engagement: bool,
    pub tolerance_mm: f64,
    /// Options of columns were given, which a half section has not.
    pub has_columns: bool,
    /// The setup file.
    pub setup: Option<&'a Path>,
}

pub fn run(
    args: &TurnedOutput<'_>,
    loaded: &Loaded,
    job: &Job<'_>,
    terminal: TerminalSupport,
) -> Result<ExitVerdict, CommandFailure> {
    let forms: Vec<TurnedFormat> =
        args.output.iter().map(|path| form(path, args.engagement)).collect::<Result<_, _>>()?;
    let options = TurnedOptions { tolerance_mm: args.tolerance_mm, replay: false };
    let found = job.turned_stock(&options, &files);
    let mut found = found.map_err(|error| failure_of(error, args.setup))?;
    // Where the limits of the axes are wrong there are no times; `chordal time` says why.
    if let Ok(timed) = job.time(&MotionOptions::default()) {
        found.take_times(&timed.time.tools);
    }
    for (path, form) in args.output.iter().zip(forms) {
        write_whole(path, &content(&found, job, form, loaded.name(), path)?)?;
    }
    match args.format {
        SetupProblemFormat::Text => {
            terminal.write_error(&recognized(loaded));
            if found.report.worst().is_some() {
                say(&report::text(&found.report, job.sources(), terminal.out, args.detail))?;
            }
            if args.engagement {
                say(&turning_text(&found))?;
            }
            say(&turned_text(&found))?;
            for path in args.output {
                say(&format!("written: {}\n", path.display()))?;
            }
            if args.has_columns {
                say(
                    "note: a half section is exact: --resolution, --finest and --chip have no effect\n",
                )?;
            }
        }
        SetupProblemFormat::Json if args.engagement => say(&turning_json(&found, loaded.name()))?,
        SetupProblemFormat::Json => say(&turned_json(&found, loaded.name()))?,
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
    found: &TurnedReport,
    job: &Job<'_>,
    form: TurnedFormat,
    name: &str,
    path: &Path,
) -> Result<Vec<u8>, CommandFailure> {
    let options = || PlotOptions {
        title: name.to_string(),
        subtitle: subtitle(found),
        ..PlotOptions::default()
    };
    Ok(match form {
        TurnedFormat::Svg => section_svg(found, &options()).into_bytes(),
        TurnedFormat::Png => section_png(found, &options())
            .map_err(|error| CommandFailure::wrong(error.to_string(), "write an .svg"))?,
        TurnedFormat::Dxf => section_dxf(found),
        TurnedFormat::Mesh(format) => {
            let own = path.file_stem().unwrap_or_default().to_string_lossy();
            turned_mesh(found, format, &own)
                .map_err(|error| CommandFailure::wrong(error.to_string(), "write a .dxf"))?
        }
        TurnedFormat::Json => turning_json(found, name).into_bytes(),
        TurnedFormat::Csv => {
            let mut text = Vec::new();
            cuts_csv(&mut text, job, &found.moves)?;
            text
        }
        TurnedFormat::Columns(format) => {
            let mut file = ColumnFile::new(Vec::new(), format, CutColumns::new(job))?;
            for each in &found.moves {
                file.put(|rows| rows.cut(each))?;
            }
            file.finish()?
        }
    })
}

/// The volumes, in one line.
fn subtitle(found: &TurnedReport) -> String {
    let text = turned_text(found);
    let lines = text.lines().take(2);
    let words: Vec<String> =
        lines.map(|line| line.split_whitespace().collect::<Vec<_>>().join(" ")).collect();
    words.join(", ")
}
