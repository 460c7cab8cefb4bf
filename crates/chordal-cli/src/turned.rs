//! `chordal stock` for lathes: the exact half section.

use std::path::{Path, PathBuf};

use chordal::Job;
use chordal::motion::MotionOptions;
use chordal::stock::{StockVerdict, TurnedOptions, TurnedReport};
use chordal_export::columns::{ColumnFile, ColumnFormat, CutColumns, cuts_csv};
use chordal_export::report::{self, Detail, Sarif};
use chordal_export::{
    MeshFormat, PlotOptions, section_dxf, section_png, section_svg, turned_json, turned_mesh,
    turned_text, turning_json, turning_text,
};
use chordal_load::Loaded;

use crate::failure::{Failure, Verdict};
use crate::output::write_whole;
use crate::programs::recognized;
use crate::setup_files::{Format, files};
use crate::stock_failure::failure_of;
use crate::terminal::{Terminal, say};

/// What a file holds.
#[derive(Clone, Copy)]
enum Form {
    Svg,
    Png,
    Dxf,
    Mesh(MeshFormat),
    Columns(ColumnFormat),
    Csv,
    Json,
}

fn form(path: &Path, engagement: bool) -> Result<Form, Failure> {
    let ending = path.extension().unwrap_or_default().to_string_lossy().to_ascii_lowercase();
    let found = match (ending.as_str(), engagement) {
        ("svg", false) => Form::Svg,
        ("png", false) => Form::Png,
        ("dxf", false) => Form::Dxf,
        ("stl", false) => Form::Mesh(MeshFormat::Stl),
        ("3mf", false) => Form::Mesh(MeshFormat::ThreeMf),
        ("glb", false) => Form::Mesh(MeshFormat::Glb),
        ("parquet", true) => Form::Columns(ColumnFormat::Parquet),
        ("arrow", true) => Form::Columns(ColumnFormat::Arrow),
        ("csv", true) => Form::Csv,
        ("json", true) => Form::Json,
        _ => {
            let message = format!("the extension of {} is not a known format", path.display());
            let help = if engagement {
                "with --engagement the extensions are .parquet, .arrow, .csv, .json"
            } else {
                "of a lathe the extensions are .svg, .png, .dxf, .stl, .3mf, .glb"
            };
            return Err(Failure::wrong(message, help));
        }
    };
    Ok(found)
}

/// What is asked for in addition to the run.
pub struct Answer<'a> {
    pub output: &'a [PathBuf],
    pub format: Format,
    pub detail: Detail,
    /// How hard each cut is.
    pub engagement: bool,
    pub tolerance_mm: f64,
    /// Options of columns were given, which a half section has not.
    pub has_columns: bool,
    /// The setup file.
    pub setup: Option<&'a Path>,
}

pub fn run(
    args: &Answer<'_>,
    loaded: &Loaded,
    job: &Job<'_>,
    terminal: Terminal,
) -> Result<Verdict, Failure> {
    let forms: Vec<Form> =
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
        Format::Text => {
            terminal.tell(&recognized(loaded));
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
        Format::Json if args.engagement => say(&turning_json(&found, loaded.name()))?,
        Format::Json => say(&turned_json(&found, loaded.name()))?,
        Format::Sarif => {
            let mut sarif = Sarif::new();
            sarif.add(&found.report, job.sources());
            say(&sarif.finish())?;
        }
    }
    Ok(if found.verdict == StockVerdict::Clean { Verdict::Clean } else { Verdict::Problems })
}

fn content(
    found: &TurnedReport,
    job: &Job<'_>,
    form: Form,
    name: &str,
    path: &Path,
) -> Result<Vec<u8>, Failure> {
    let options = || PlotOptions {
        title: name.to_string(),
        subtitle: subtitle(found),
        ..PlotOptions::default()
    };
    Ok(match form {
        Form::Svg => section_svg(found, &options()).into_bytes(),
        Form::Png => section_png(found, &options())
            .map_err(|error| Failure::wrong(error.to_string(), "write an .svg"))?,
        Form::Dxf => section_dxf(found),
        Form::Mesh(format) => {
            let own = path.file_stem().unwrap_or_default().to_string_lossy();
            turned_mesh(found, format, &own)
                .map_err(|error| Failure::wrong(error.to_string(), "write a .dxf"))?
        }
        Form::Json => turning_json(found, name).into_bytes(),
        Form::Csv => {
            let mut text = Vec::new();
            cuts_csv(&mut text, job, &found.moves)?;
            text
        }
        Form::Columns(format) => {
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
