//! `chordal stock --engagement`: how hard the cuts are.

use std::path::{Path, PathBuf};

use chordal::Job;
use chordal::stock::{EngagementOptions, EngagementReport};
use chordal_export::columns::{ColumnFile, ColumnFormat, CutColumns, cuts_csv};
use chordal_export::report::{self, Detail};
use chordal_export::{engagement_json, engagement_text};
use chordal_load::Loaded;

use crate::failure::{Failure, Verdict};
use crate::options::AnswerFormat;
use crate::output::write_whole;
use crate::programs::recognized;
use crate::setup_files;
use crate::stock_failure::failure_of;
use crate::terminal::{Terminal, say};

/// A file of moves.
#[derive(Clone, Copy)]
enum Form {
    Columns(ColumnFormat),
    Csv,
    Json,
}

fn form(path: &Path) -> Result<Form, Failure> {
    let ending = path.extension().unwrap_or_default().to_string_lossy().to_ascii_lowercase();
    Ok(match ending.as_str() {
        "parquet" => Form::Columns(ColumnFormat::Parquet),
        "arrow" => Form::Columns(ColumnFormat::Arrow),
        "csv" => Form::Csv,
        "json" => Form::Json,
        _ => {
            let message = format!("the extension of {} is not a format of moves", path.display());
            let help = "with --engagement the extensions are .parquet, .arrow, .csv, .json";
            return Err(Failure::wrong(message, help));
        }
    })
}

/// What is asked for in addition to the run.
pub struct Answer<'a> {
    pub output: &'a [PathBuf],
    pub format: AnswerFormat,
    pub detail: Detail,
    /// The setup file.
    pub setup: Option<&'a Path>,
}

pub fn run(
    args: &Answer<'_>,
    options: &EngagementOptions,
    loaded: &Loaded,
    terminal: Terminal,
) -> Result<Verdict, Failure> {
    let forms: Vec<Form> = args.output.iter().map(|path| form(path)).collect::<Result<_, _>>()?;
    let job = loaded.job()?;
    let found = job
        .engagement(options, &setup_files::files)
        .map_err(|error| failure_of(error, args.setup))?;
    for (path, form) in args.output.iter().zip(forms) {
        write_whole(path, &content(&found, &job, form, loaded.name())?)?;
    }
    match args.format {
        AnswerFormat::Text => {
            terminal.tell(&recognized(loaded));
            if found.report.worst().is_some() {
                say(&report::text(&found.report, job.sources(), terminal.out, args.detail))?;
            }
            say(&engagement_text(&found))?;
            written(args.output)?;
        }
        AnswerFormat::Json => say(&engagement_json(&found, loaded.name(), false))?,
    }
    let is_fine = found.problems.is_empty() && found.is_whole && found.report.counts.errors == 0;
    Ok(if is_fine { Verdict::Clean } else { Verdict::Problems })
}

fn written(paths: &[PathBuf]) -> Result<(), Failure> {
    for path in paths {
        say(&format!("written: {}\n", path.display()))?;
    }
    Ok(())
}

fn content(
    found: &EngagementReport,
    job: &Job<'_>,
    form: Form,
    name: &str,
) -> Result<Vec<u8>, Failure> {
    Ok(match form {
        Form::Json => engagement_json(found, name, true).into_bytes(),
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
