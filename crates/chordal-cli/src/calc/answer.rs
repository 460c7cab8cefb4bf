//! What comes out: text or JSON, and the figure.

use std::path::{Path, PathBuf};

use chordal_calc::{CalcError, WorkedCalculation};
use chordal_export::{PlotOptions, figure_png, figure_svg, worked_json, worked_text};
use clap::ValueEnum;

use super::quantity::UnitsName;
use crate::failure::CommandFailure;
use crate::output::write_whole;
use crate::terminal::say;

/// What every calculation takes.
#[derive(clap::Args)]
pub struct CalculationOutput {
    /// Units of the answer, and of numbers without a unit
    #[arg(long, value_enum)]
    pub units: Option<UnitsName>,

    /// Format of the answer
    #[arg(long, value_enum, default_value = "text")]
    pub format: CalculationFormat,

    /// Writes the figure, as .svg or .png; may be repeated
    #[arg(short, long = "output", value_name = "FILE")]
    pub outputs: Vec<PathBuf>,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
pub enum CalculationFormat {
    /// Text for the reader
    Text,
    /// JSON for programs
    Json,
}

/// The sheet of a figure, px.
const SHEET: (u32, u32) = (1200, 800);

/// What a file's ending asks for.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum FigureFormat {
    Svg,
    Png,
}

/// The kind of picture; `None` for another ending.
pub fn picture(path: &Path) -> Option<FigureFormat> {
    let ending = path.extension()?.to_string_lossy().to_ascii_lowercase();
    match ending.as_str() {
        "svg" => Some(FigureFormat::Svg),
        "png" => Some(FigureFormat::Png),
        _ => None,
    }
}

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
        let kind = picture(path).ok_or_else(|| {
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
        CalculationFormat::Text => say(&worked_text(&worked)),
        CalculationFormat::Json => say(&worked_json(&worked, None)),
    }
}

/// Writes the figure of a calculation.
pub fn draw(
    worked: &WorkedCalculation,
    path: &Path,
    kind: FigureFormat,
) -> Result<(), CommandFailure> {
    let (width_px, height_px) = SHEET;
    let options = PlotOptions { width_px, height_px, ..PlotOptions::default() };
    let content = match kind {
        FigureFormat::Svg => figure_svg(worked, &options).into_bytes(),
        FigureFormat::Png => {
            figure_png(worked, &options).map_err(|error| CommandFailure::Write {
                file: path.to_string_lossy().into_owned(),
                reason: error.to_string(),
            })?
        }
    };
    write_whole(path, &content)
}
