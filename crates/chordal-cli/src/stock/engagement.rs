//! `chordal stock --engagement`: how hard the cuts are.

use chordal::Job;
use chordal::stock::EngagementOptions;
use chordal_export::columns::{ColumnFile, CutColumns, CuttingMoveData, cuts_csv};
use chordal_export::format::ENGAGEMENT_FILES;
use chordal_export::{OutputFormat, engagement_json, engagement_text};
use chordal_load::Loaded;

use super::{Args, StockAnswer};
use crate::failure::{CommandFailure, ExitVerdict};
use crate::setup_files::files;
use crate::stock_failure::failure_of;
use crate::terminal::TerminalSupport;

/// What stands before the endings of files, for messages.
pub const ENDINGS: &str = "with --engagement the extensions are";

pub fn run(
    args: &Args,
    options: &EngagementOptions,
    loaded: &Loaded,
    terminal: TerminalSupport,
) -> Result<ExitVerdict, CommandFailure> {
    if args.format == OutputFormat::Sarif {
        let help = "write --format json, or leave --engagement out";
        return Err(CommandFailure::wrong("--engagement has no SARIF", help));
    }
    let formats = args.formats(&ENGAGEMENT_FILES, "a format of moves", ENDINGS)?;
    let job = loaded.job()?;
    let setup = args.setup.as_deref();
    let found = job.engagement(options, &files).map_err(|error| failure_of(error, setup))?;
    args.write(formats, |_, format| match format {
        OutputFormat::Json => Ok(engagement_json(&found, loaded.name(), true).into_bytes()),
        rows => cut_rows(&found.moves, &job, rows),
    })?;
    let answer = StockAnswer {
        report: &found.report,
        text: &|| engagement_text(&found),
        json: &|| engagement_json(&found, loaded.name(), false),
        note: "",
        is_fine: found.problems.is_empty() && found.is_whole && found.report.counts.errors == 0,
    };
    args.give(&answer, loaded, &job, terminal)
}

/// The moves that cut as the rows of a file.
pub fn cut_rows<T: CuttingMoveData>(
    moves: &[T],
    job: &Job<'_>,
    format: OutputFormat,
) -> Result<Vec<u8>, CommandFailure> {
    if format == OutputFormat::Csv {
        let mut text = Vec::new();
        cuts_csv(&mut text, job, moves)?;
        return Ok(text);
    }
    let mut file = ColumnFile::new(Vec::new(), format, CutColumns::new(job))?;
    for each in moves {
        file.put(|rows| rows.cut(each))?;
    }
    Ok(file.finish()?)
}
