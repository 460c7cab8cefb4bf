//! `chordal time`: how long a program takes, where and why.

mod cells;
mod chords;
mod corners;
mod least;
mod picture;
mod text;

use std::path::PathBuf;

use chordal::motion::{LimitError, MotionOptions, OperationStart, PlannerLevel};
use chordal::time::{RepeatPlanning, TimeQuestion};
use chordal_export::format::ANSWER_FORMATS;
use chordal_export::{OutputFormat, PlotOptions, time_json};
use clap::ValueEnum;

use self::picture::TimePicture;
use crate::failure::{CommandFailure, ExitVerdict};
use crate::formats::format_parser;
use crate::options::CommonArgs;
use crate::programs::load_one;
use crate::rows::print_problems;
use crate::summary::subtitle;
use crate::terminal::{TerminalSupport, say};

const EXAMPLES: &str = "\
Examples:
  chordal time part.nc                         by tool, the slowest blocks, what if
  chordal time part.nc --machine vf2.toml
  chordal time part.nc --set motion.feed_override=0.8
  chordal time part.nc --format json | jq .total_s
  chordal time part.nc -o part-speed.svg       speed, acceleration, jerk as a picture
  chordal time part.nc --operations comment    from comment to comment
  chordal time part.nc --bound                 how far above the physical limit it runs

The time keeps the limits of velocity, acceleration and jerk of every axis, and passes corners as the
path mode of the control says. `lost` is the time above that at the programmed feed or rapid speed.
Problems of the program go to standard error; the exit code is 1 when there are errors.";

/// Reports how long a program takes, where the time goes and why
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// The program; `-` is standard input
    file: PathBuf,

    /// Effort of the planner
    #[arg(long, value_enum, default_value = "fast")]
    level: LevelName,

    /// Format of the answer
    #[arg(long, value_parser = format_parser(&ANSWER_FORMATS), default_value = "text")]
    format: OutputFormat,

    /// Draws speed, acceleration and jerk over time and speed along the path: .svg or .png
    #[arg(long, short, value_name = "PICTURE")]
    output: Option<PathBuf>,

    /// Plans again with other overrides, path modes and short lines, for programs of any length
    ///
    /// Without it, Chordal does so for programs of up to 20,000 moves.
    #[arg(long)]
    what_if: bool,

    /// Reports how far the program and each operation are above the physical limit
    ///
    /// The bound is the least time within the limits of velocity and acceleration of every axis; the
    /// reference is the least time with jerk, too. Takes up to a minute; runs that need too much
    /// work get no reference.
    #[arg(long)]
    bound: bool,

    /// Where operations begin
    #[arg(long, value_enum, default_value = "tool", value_name = "WHERE")]
    operations: OperationName,

    #[command(flatten)]
    common: CommonArgs,
}

/// Where operations begin.
#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
enum OperationName {
    /// At every tool change
    Tool,
    /// At comments on lines of their own, too
    Comment,
}

impl From<OperationName> for OperationStart {
    fn from(name: OperationName) -> OperationStart {
        match name {
            OperationName::Tool => OperationStart::ToolChange,
            OperationName::Comment => OperationStart::Comment,
        }
    }
}

/// Effort of the planner.
#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
pub enum LevelName {
    /// In one pass, for programs of any length
    Fast,
    /// By optimization, for short programs
    Best,
}

impl From<LevelName> for PlannerLevel {
    fn from(name: LevelName) -> PlannerLevel {
        match name {
            LevelName::Fast => PlannerLevel::Fast,
            LevelName::Best => PlannerLevel::Best,
        }
    }
}

pub fn run(args: &Args, terminal: TerminalSupport) -> Result<ExitVerdict, CommandFailure> {
    let picture =
        args.output.as_deref().map(|path| TimePicture::new(path, &args.file)).transpose()?;
    let loaded = load_one(&args.file, &args.common)?;
    let job = loaded.job()?;
    let options = MotionOptions {
        level: args.level.into(),
        operations: args.operations.into(),
        ..MotionOptions::default()
    };
    let repeat_planning =
        if args.what_if { RepeatPlanning::Always } else { RepeatPlanning::IfShort };
    let question = TimeQuestion { options, repeat_planning, computes_least: args.bound };
    let (report, study) = job.time_study(&question);
    let Some(study) = study.map_err(|error| wrong_limit(&error))? else {
        return Ok(print_problems(&report, &loaded, &job, terminal));
    };
    let text = match args.format {
        OutputFormat::Text => text::text(loaded.name(), &study, &report, &job, terminal.out),
        _ => time_json(&study, &report, &job),
    };
    if let Some(picture) = &picture {
        let plot = PlotOptions {
            title: loaded.name().to_string(),
            subtitle: subtitle(&job, &report, Some(&study.timed)),
            ..PlotOptions::default()
        };
        picture.draw(&job, &question.options, &study.timed, report.summary.inch, &plot)?;
    }
    say(&text)?;
    Ok(print_problems(&report, &loaded, &job, terminal))
}

/// A limit nothing can be planned with.
pub fn wrong_limit(error: &LimitError) -> CommandFailure {
    CommandFailure::wrong(error.to_string(), "correct it in the machine file, or with --set")
}
