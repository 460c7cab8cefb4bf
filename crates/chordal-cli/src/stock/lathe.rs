//! `chordal stock` for lathes: the exact half section.

use std::path::Path;

use chordal::Job;
use chordal::motion::MotionOptions;
use chordal::stock::{StockVerdict, TurnedOptions, TurnedReport};
use chordal_export::format::{ENGAGEMENT_FILES, LATHE_STOCK_FILES};
use chordal_export::{
    OutputFormat, PlotOptions, section_dxf, section_png, section_svg, turned_json, turned_mesh,
    turned_text, turning_json, turning_text,
};
use chordal_load::Loaded;

use super::engagement::{ENDINGS, cut_rows};
use super::{Args, StockAnswer};
use crate::failure::{CommandFailure, ExitVerdict};
use crate::setup_files::files;
use crate::stock_failure::failure_of;
use crate::terminal::TerminalSupport;

pub fn run(
    args: &Args,
    loaded: &Loaded,
    job: &Job<'_>,
    terminal: TerminalSupport,
) -> Result<ExitVerdict, CommandFailure> {
    let (list, endings) = match args.engagement {
        true => (&ENGAGEMENT_FILES, ENDINGS),
        false => (&LATHE_STOCK_FILES, "of a lathe the extensions are"),
    };
    let formats = args.formats(list, "a known format", endings)?;
    let options = TurnedOptions { tolerance_mm: args.tolerance, replay: false };
    let found = job.turned_stock(&options, &files);
    let mut found = found.map_err(|error| failure_of(error, args.setup.as_deref()))?;
    // Where the limits of the axes are wrong there are no times; `chordal time` says why.
    if let Ok(timed) = job.time(&MotionOptions::default()) {
        found.take_times(&timed.time.tools);
    }
    let name = loaded.name();
    args.write(formats, |path, format| match format {
        rows if args.engagement && rows != OutputFormat::Json => cut_rows(&found.moves, job, rows),
        format => content(&found, format, name, path),
    })?;
    let text = || {
        let moves = if args.engagement { turning_text(&found) } else { String::new() };
        moves + &turned_text(&found)
    };
    let json =
        || if args.engagement { turning_json(&found, name) } else { turned_json(&found, name) };
    // A half section has no columns.
    let note = match args.resolution.or(args.finest).or(args.chip) {
        Some(_) => {
            "note: a half section is exact: --resolution, --finest and --chip have no effect\n"
        }
        None => "",
    };
    let is_fine = found.verdict == StockVerdict::Clean;
    let answer = StockAnswer { report: &found.report, text: &text, json: &json, note, is_fine };
    args.give(&answer, loaded, job, terminal)
}

fn content(
    found: &TurnedReport,
    format: OutputFormat,
    name: &str,
    path: &Path,
) -> Result<Vec<u8>, CommandFailure> {
    let options = || PlotOptions {
        title: name.to_string(),
        subtitle: subtitle(found),
        ..PlotOptions::default()
    };
    Ok(match format {
        OutputFormat::Json => turning_json(found, name).into_bytes(),
        OutputFormat::Svg => section_svg(found, &options()).into_bytes(),
        OutputFormat::Png => section_png(found, &options())
            .map_err(|error| CommandFailure::wrong(error.to_string(), "write an .svg"))?,
        OutputFormat::Dxf => section_dxf(found),
        mesh => {
            let own = path.file_stem().unwrap_or_default().to_string_lossy();
            turned_mesh(found, mesh, &own)
                .map_err(|error| CommandFailure::wrong(error.to_string(), "write a .dxf"))?
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
