//! What comes out: text or JSON, and the figure.

use std::path::{Path, PathBuf};

use chordal_calc::{CalcError, WorkedCalculation};
use chordal_export::format::{CALCULATION_FORMATS, PICTURE_FILES};
use chordal_export::{OutputFormat, PlotOptions, figure_png, figure_svg, worked_json, worked_text};

use super::quantity::UnitsName;
use crate::failure::CommandFailure;
use crate::formats::format_parser;
use crate::output::write_whole;
use crate::terminal::say;

/// What every calculation takes.
#[derive(clap::Args)]
pub struct CalculationOutput {
    /// Units of the answer, and of numbers without a unit
    #[arg(long, value_enum)]
    pub units: Option<UnitsName>,

    /// Format of the answer
    #[arg(long, value_parser = format_parser(&CALCULATION_FORMATS), default_value = "text")]
    pub format: OutputFormat,

    /// Writes the figure, as .svg or .png; may be repeated
    #[arg(short, long = "output", value_name = "FILE")]
    pub outputs: Vec<PathBuf>,
}

/// The sheet of a figure, px.
const SHEET: (u32, u32) = (1200, 800);

/// What cannot be, as a wrong use.
pub fn refused(error: CalcError) -> CommandFailure {
    CommandFailure::wrong(error.message, error.help)
}

/// Writes the answer and its figures.
pub fn give(
    worked: Result<WorkedCalculation, CalcError>,
    answer: &CalculationOutput,
) -> Result<(), CommandFailure> {
    let worked = worked.map_err(refused)?;
    let mut pictures = Vec::new();
    for path in &answer.outputs {
        let kind = PICTURE_FILES.of_file(path).ok_or_else(|| {
            CommandFailure::wrong(
                format!("a figure cannot be written as {}", path.display()),
                "the extensions are .svg and .png",
            )
        })?;
        pictures.push((path, kind));
    }
    for (path, kind) in pictures {
        draw(&worked, path, kind)?;
    }
    match answer.format {
        OutputFormat::Text => say(&worked_text(&worked)),
        _ => say(&worked_json(&worked, None)),
    }
}

/// Writes the figure of a calculation.
pub fn draw(
    worked: &WorkedCalculation,
    path: &Path,
    kind: OutputFormat,
) -> Result<(), CommandFailure> {
    let (width_px, height_px) = SHEET;
    let options = PlotOptions { width_px, height_px, ..PlotOptions::default() };
    let content = match kind {
        OutputFormat::Svg => figure_svg(worked, &options).into_bytes(),
        _ => figure_png(worked, &options).map_err(|error| CommandFailure::Write {
            file: path.to_string_lossy().into_owned(),
            reason: error.to_string(),
        })?,
    };
    write_whole(path, &content)
}
