//! `chordal stock --engagement`: how hard the cuts are.

use std::path::{Path, PathBuf};

use chordal::Job;
use chordal::stock::{EngagementOptions, EngagementReport};
use chordal_export::columns::{ColumnFile, ColumnFormat, CutColumns, cuts_csv};
use chordal_export::report::{self, ReportDetail};
use chordal_export::{engagement_json, engagement_text};
use chordal_load::Loaded;

use crate::failure::{CommandFailure, ExitVerdict};
use crate::options::AnswerFormat;
use crate::output::write_whole;
use crate::programs::recognized;
use crate::setup_files;
use crate::stock_failure::failure_of;
use crate::terminal::{TerminalSupport, say};

/// A file of moves.
#[derive(Clone, Copy)]
enum EngagementFormat {
    Columns(ColumnFormat),
    Csv,
    Json,
}

fn form(path: &Path) -> Result<EngagementFormat, CommandFailure> {
    let ending = path.extension().unwrap_or_default().to_string_lossy().to_ascii_lowercase();
    Ok(match ending.as_str() {
        "parquet" => EngagementFormat::Columns(ColumnFormat::Parquet),
        "arrow" => EngagementFormat::Columns(ColumnFormat::Arrow),
        "csv" => EngagementFormat::Csv,
        "json" => EngagementFormat::Json,
        _ => {
            let message = format!("the extension of {} is not a format of moves", path.display());
            let help = "with --engagement the extensions are .parquet, .arrow, .csv, .json";
            return Err(CommandFailure::wrong(message, help));
        }
    })
}

/// What is asked for in addition to the run.
pub struct EngagementOutput<'a> {
    pub output: &'a [PathBuf],
    pub format: AnswerFormat,
    pub detail: ReportDetail,
    /// The setup file.
    pub setup: Option<&'a Path>,
}

pub fn run(
    args: &EngagementOutput<'_>,
    options: &EngagementOptions,
    loaded: &Loaded,
    terminal: TerminalSupport,
) -> Result<ExitVerdict, CommandFailure> {
    let forms: Vec<EngagementFormat> =
        args.output.iter().map(|path| form(path)).collect::<Result<_, _>>()?;
    let job = loaded.job()?;
    let found = job
        .engagement(options, &setup_files::files)
        .map_err(|error| failure_of(error, args.setup))?;
    for (path, form) in args.output.iter().zip(forms) {
        write_whole(path, &content(&found, &job, form, loaded.name())?)?;
    }
    match args.format {
        AnswerFormat::Text => {
            terminal.write_error(&recognized(loaded));
            if found.report.worst().is_some() {
                say(&report::text(&found.report, job.sources(), terminal.out, args.detail))?;
            }
            say(&engagement_text(&found))?;
            written(args.output)?;
        }
        AnswerFormat::Json => say(&engagement_json(&found, loaded.name(), false))?,
    }
    let is_fine = found.problems.is_empty() && found.is_whole && found.report.counts.errors == 0;
    Ok(if is_fine { ExitVerdict::Clean } else { ExitVerdict::Problems })
}

fn written(paths: &[PathBuf]) -> Result<(), CommandFailure> {
    for path in paths {
        say(&format!("written: {}\n", path.display()))?;
    }
    Ok(())
}

fn content(
    found: &EngagementReport,
    job: &Job<'_>,
    form: EngagementFormat,
    name: &str,
) -> Result<Vec<u8>, CommandFailure> {
    Ok(match form {
        EngagementFormat::Json => engagement_json(found, name, true).into_bytes(),
        EngagementFormat::Csv => {
            let mut text = Vec::new();
            cuts_csv(&mut text, job, &found.moves)?;
            text
        }
        EngagementFormat::Columns(format) => {
            let mut file = ColumnFile::new(Vec::new(), format, CutColumns::new(job))?;
            for each in &found.moves {
                file.put(|rows| rows.cut(each))?;
            }
            file.finish()?
        }
    })
}
