//! The picture of a planned program.

use std::path::{Path, PathBuf};

use chordal::Job;
use chordal::motion::{MotionOptions, PlanSink, PlannerStep, StepSources};
use chordal::time::TimedRun;
use chordal_export::numbers::short;
use chordal_export::{MotionPlot, OutputFormat, PlotOptions};

use crate::failure::CommandFailure;
use crate::formats::picture_format;
use crate::output::write_whole;
use crate::time::wrong_limit;

/// Where a picture goes, and in which format.
pub struct TimePicture {
    path: PathBuf,
    format: OutputFormat,
}

impl TimePicture {
    /// A picture whose format its ending says; it does not take the place of the program.
    pub fn new(path: &Path, program: &Path) -> Result<TimePicture, CommandFailure> {
        let format = picture_format(path)?;
        if path.canonicalize().is_ok_and(|own| program.canonicalize().is_ok_and(|p| p == own)) {
            return Err(CommandFailure::wrong(
                format!("{} is the program", path.display()),
                "give the picture another name",
            ));
        }
        Ok(TimePicture { path: path.to_path_buf(), format })
    }

    /// Plans once more, draws and writes.
    pub fn draw(
        &self,
        job: &Job,
        options: &MotionOptions,
        timed: &TimedRun,
        inch: bool,
        plot: &PlotOptions,
    ) -> Result<(), CommandFailure> {
        let time_s = timed.time.total_s();
        let drawing = MotionPlot::new(&timed.motion.limits.cut, inch).lasting(time_s);
        let period_s = MotionPlot::period_s(time_s);
        let usual = MotionPlot::period_s(0.0);
        let mut plot = plot.clone();
        if period_s > usual {
            // Said, because what lies between two setpoints is not drawn.
            plot.subtitle += &format!(" · a setpoint every {} ms", short(1000.0 * period_s, 1));
        }
        let (plot, mut drawing) = (&plot, PictureSink(drawing));
        job.plan(options, &mut drawing).map_err(|error| wrong_limit(&error))?;
        drawing.0.finish();
        let picture = if self.format == OutputFormat::Png {
            let drawn = drawing.0.png(plot);
            drawn.map_err(|error| CommandFailure::Use { message: error.to_string(), help: None })?
        } else {
            drawing.0.svg(plot).into_bytes()
        };
        write_whole(&self.path, &picture)
    }
}

struct PictureSink(MotionPlot);

impl PlanSink for PictureSink {
    fn step(&mut self, step: PlannerStep<'_>, sources: &StepSources) {
        self.0.step(step, sources);
    }
}
