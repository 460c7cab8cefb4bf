use chordal::{Job, Segment};

/// What stands on the sheet beside the path, and how large it is.
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
    fn default() -> PlotOptions {
        PlotOptions {
            title: String::new(),
            subtitle: String::new(),
            width_px: 1600,
            height_px: 1130,
            dark: false,
        }
    }
}

/// Why there is no picture.
#[derive(Debug, thiserror::Error)]
pub enum PlotError {
    /// The sheet is empty or larger than can be held.
    #[error("a picture of {0} by {1} pixels cannot be drawn")]
    Size(u32, u32),
    /// The drawing was not accepted by the renderer.
    #[error("the drawing could not be rendered: {0}")]
    Render(String),
}

/// Under construction.
#[derive(Debug)]
pub struct Plot {}

impl Plot {
    /// An empty drawing for a job.
    pub fn new(_job: &Job) -> Plot {
        Plot {}
    }

    /// Numbers of the axes in inches, or in millimetres.
    pub fn set_inch(&mut self, _inch: bool) {}

    /// Adds a segment.
    pub fn segment(&mut self, _segment: &Segment) {}

    /// The sheet as SVG.
    pub fn svg(&self, _options: &PlotOptions) -> String {
        String::new()
    }

    /// The sheet as PNG.
    ///
    /// # Errors
    /// When the sheet has no size or an unreasonable one.
    pub fn png(&self, options: &PlotOptions) -> Result<Vec<u8>, PlotError> {
        Err(PlotError::Size(options.width_px, options.height_px))
    }
}
