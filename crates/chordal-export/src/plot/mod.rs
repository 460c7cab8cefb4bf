//! The path as a drawing: three views and an isometric one on a sheet, as SVG or PNG.

mod depths;
mod figure;
mod figure_labels;
mod frame;
mod lathe_stock;
mod layout;
mod motion;
mod page;
mod palette;
mod pen;
mod relief;
mod section;
mod sheet;
mod store;
mod text;
mod view;

use std::sync::Arc;

use chordal::control::Units;
use chordal::stock::{StockReport, TurnedReport};
use chordal::{Job, Segment};
use resvg::tiny_skia::{Pixmap, Transform};
use resvg::usvg;

pub use figure::{figure_png, figure_svg};
pub use motion::MotionPlot;
pub use page::{PageTool, PageView, Viewpoint};
use relief::StockRelief;
pub use section::{page_section, section_png, section_svg};
use store::PathStore;

/// What stands on the sheet in addition to the path, and how large it is.
#[derive(Clone, Debug)]
pub struct PlotOptions {
    /// First line of the caption: the file's name.
    pub title: String,
    /// Second line: machine, units, time.
    pub subtitle: String,
    /// Width of the sheet, px.
    pub width_px: u32,
    /// Height of the sheet, px.
    pub height_px: u32,
    /// Light lines on a dark sheet.
    pub dark: bool,
}

impl Default for PlotOptions {
    /// An A4 sheet on its long side.
    fn default() -> PlotOptions {
        PlotOptions {
            title: String::new(),
            subtitle: String::new(),
            width_px: 1600,
            height_px: 1131,
            dark: false,
        }
    }
}

/// Why there is no picture.
#[derive(Debug, thiserror::Error)]
pub enum PlotError {
    /// The sheet is empty or larger than can be held.
    #[error("a picture of {0} by {1} pixels cannot be drawn; both must be between 200 and 16384")]
    Size(u32, u32),
    /// The drawing was not accepted by the renderer.
    #[error("the drawing could not be rendered: {0}")]
    Render(String),
}

/// Sides that a PNG may have, px.
const SIDES_PX: std::ops::RangeInclusive<u32> = 200..=16384;
/// Pixels of the largest PNG: four bytes each are held while it is drawn.
const MAX_PIXELS: u64 = 128 << 20;

/// Collects a path, then draws it: top, front and right view in third-angle projection with
/// one scale, and an isometric view.
///
/// Cuts are coloured by tool; rapids are thin and dashed. What is not known relative to the
/// part, in a work offset of which nobody knows how it lies to the first, or not finite, is left out. Rapids that go far beyond the cuts are cut off at the
/// edge of the views.
#[derive(Debug)]
pub struct Plot {
    store: PathStore,
    inch: bool,
    /// Of a lathe: one view, with the half section of what is left where it is known.
    turned: Option<lathe_stock::TurnedStockPlot>,
}

impl Plot {
    /// An empty drawing for a job, numbered in the units of the job's control.
    pub fn new(job: &Job) -> Plot {
        let inch = job.rules().units == Units::Inch;
        let turned = job.turns().then(lathe_stock::TurnedStockPlot::default);
        Plot { store: PathStore::new(job.profile().work_names), inch, turned }
    }

    /// The same for a picture file. Where the spindle may be a laser, and one tool cuts with several values of S, the
    /// cuts are coloured by them, from least to most.
    pub fn picture(job: &Job) -> Plot {
        let mut plot = Plot::new(job);
        plot.store.by_power = job.rules().spindle_by_hand;
        plot
    }

    /// Two runs in one picture: the first as a band, the second as a line in it. Where they go
    /// different ways, band and line part.
    pub fn overlay(jobs: [&Job; 2], names: [String; 2]) -> Plot {
        let mut plot = Plot::new(jobs[0]);
        plot.store.overlay = Some(names);
        for (number, job) in (1..).zip(jobs) {
            let report = job.report_with(|_, segments| {
                for segment in segments {
                    plot.store.push(&Segment { tool: number, ..*segment });
                }
            });
            plot.inch = report.summary.inch;
        }
        plot
    }

    /// Numbers the axes in inches, or in millimetres: after a run, `Summary::inch` says what
    /// the program was in.
    pub fn set_inch(&mut self, inch: bool) {
        self.inch = inch;
    }

    /// Draws the stock that is left, shaded, under the path.
    pub fn set_stock(&mut self, found: &StockReport) {
        self.store.stock = Some(StockRelief::of(found));
    }

    /// Draws what is left of turned stock under the path of a lathe.
    pub fn set_section(&mut self, found: &TurnedReport) {
        self.turned = Some(lathe_stock::TurnedStockPlot::of(found));
    }

    /// Whether this is the picture of a lathe: one view, Z to the right and X up.
    pub fn is_turned(&self) -> bool {
        self.turned.is_some()
    }

    /// Adds a segment.
    pub fn segment(&mut self, segment: &Segment) {
        self.store.push(segment);
    }

    /// The sheet as SVG. Sides below 200 px are drawn as 200.
    pub fn svg(&self, options: &PlotOptions) -> String {
        sheet::layers(&self.store, self.turned.as_ref(), self.inch, options).svg()
    }

    /// The sheet as PNG.
    ///
    /// # Errors
    /// When the sheet has no reasonable size.
    pub fn png(&self, options: &PlotOptions) -> Result<Vec<u8>, PlotError> {
        let (width, height) = (options.width_px, options.height_px);
        may_be(width, height)?;
        sheet::layers(&self.store, self.turned.as_ref(), self.inch, options).pixels(width, height)
    }
}

/// The colours of the drawings as TypeScript: the page of `chordal view` shows the same ones.
pub fn palette_typescript() -> String {
    palette::typescript()
}

/// Draws an SVG of this size as PNG; it is asked for only when the size can be drawn.
fn render(width: u32, height: u32, svg: impl FnOnce() -> String) -> Result<Vec<u8>, PlotError> {
    may_be(width, height)?;
    let mut pixmap = Pixmap::new(width, height).ok_or(PlotError::Size(width, height))?;
    draw_onto(&mut pixmap, &svg(), &usvg_options())?;
    png_of(&pixmap)
}

/// Whether a picture of this size can be held.
fn may_be(width: u32, height: u32) -> Result<(), PlotError> {
    let pixels = u64::from(width) * u64::from(height);
    if SIDES_PX.contains(&width) && SIDES_PX.contains(&height) && pixels <= MAX_PIXELS {
        Ok(())
    } else {
        Err(PlotError::Size(width, height))
    }
}

fn draw_onto(pixmap: &mut Pixmap, svg: &str, options: &usvg::Options<'_>) -> Result<(), PlotError> {
    let tree =
        usvg::Tree::from_str(svg, options).map_err(|error| PlotError::Render(error.to_string()))?;
    resvg::render(&tree, Transform::identity(), &mut pixmap.as_mut());
    Ok(())
}

fn png_of(pixmap: &Pixmap) -> Result<Vec<u8>, PlotError> {
    pixmap.encode_png().map_err(|error| PlotError::Render(error.to_string()))
}

/// The two fonts the sheets are set in come with the program: a sheet looks the same on every
/// computer.
fn usvg_options() -> usvg::Options<'static> {
    let mut fonts = usvg::fontdb::Database::new();
    fonts.load_font_data(epaint_default_fonts::UBUNTU_LIGHT.to_vec());
    fonts.load_font_data(epaint_default_fonts::HACK_REGULAR.to_vec());
    fonts.set_sans_serif_family("Ubuntu");
    fonts.set_monospace_family("Hack");
    usvg::Options {
        font_family: "Ubuntu".into(),
        fontdb: Arc::new(fonts),
        ..usvg::Options::default()
    }
}
