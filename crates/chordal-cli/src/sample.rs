//! `chordal sample`: the setpoints of the axes.

use std::path::PathBuf;

use chordal::control::AxisMask;
use chordal::machine::QuantityDimension;
use chordal::motion::{
    MotionOptions, PlannerLevel, SamplingError, SamplingReport, SamplingRequest,
};
use chordal::{Job, Report, Severity};
use chordal_export::columns::SampleColumns;
use chordal_export::format::ROW_FORMATS;
use chordal_export::report::{self, ReportDetail};
use chordal_export::{
    OutputFormat, SampleHead, SampleWriter, not_named_texts, write_unless_failed,
};
use clap::ValueEnum;

use crate::failure::{CommandFailure, ExitVerdict};
use crate::formats::{format_of, format_parser};
use crate::numbers::{SummaryUnits, counted, duration, grouped, short};
use crate::options::{CommonArgs, quantity};
use crate::out::{RowOutput, trouble};
use crate::programs::{load_one, recognized};
use crate::terminal::{BOLD, TerminalSupport, style};
use crate::time::wrong_limit;

const EXAMPLES: &str = "\
Examples:
  chordal sample part.nc --period 1ms -o part.csv
  chordal sample part.nc --period 250us -o part.parquet
  chordal sample part.nc --period 4ms --format jsonl | head
  chordal sample part.nc -m haas-vf2 --level best -o part.arrow

One row per period: time_s; x_mm, x_vel_mm_per_s, x_acc_mm_per_s2 and the same of Y and Z; a_deg,
a_vel_deg_per_s, a_acc_deg_per_s2 and the same of B and C if the program moves them;
speed_mm_per_s; line. Positions are continuous where an offset or a tool length jumps; one that is
not known is blank. The first row is the start, the last one the end. Parquet and Arrow files contain their units, their schema
(chordal.samples/1) and the SHA-256 of the program.

The summary on standard error gives the chord error of the period: how far the tool is from the path
when the axes go straight from one setpoint to the next.";

/// Writes the setpoints of the axes at a period: position, velocity, acceleration
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// The program; `-` is standard input
    file: PathBuf,

    /// Time from one setpoint to the next, with its unit
    #[arg(long, value_name = "TIME", default_value = "1ms", value_parser = period)]
    period: f64,

    /// Writes a file in the format of its extension; without it, standard output
    #[arg(long, short, value_name = "OUT")]
    output: Option<PathBuf>,

    /// Format of the setpoints if no file extension gives it; CSV on standard output
    #[arg(long, value_parser = format_parser(&ROW_FORMATS))]
    format: Option<OutputFormat>,

    /// Effort of the planner
    #[arg(long, value_enum, default_value = "fast")]
    level: PlanningQuality,

    /// Largest number of setpoints
    #[arg(long, value_name = "N", default_value_t = 100_000_000)]
    max_samples: u64,

    #[command(flatten)]
    common: CommonArgs,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
enum PlanningQuality {
    /// In one pass
    Fast,
    /// By optimization
    Best,
}

impl PlanningQuality {
    fn of(self) -> PlannerLevel {
        match self {
            PlanningQuality::Fast => PlannerLevel::Fast,
            PlanningQuality::Best => PlannerLevel::Best,
        }
    }
}

/// Microseconds are a unit of control units only: machine files have none.
pub fn period(text: &str) -> Result<f64, String> {
    let micro =
        ["us", "\u{b5}s", "\u{3bc}s"].iter().find_map(|unit| text.trim().strip_suffix(unit));
    let seconds = match micro {
        Some(number) => quantity(&format!("{number} ms"), QuantityDimension::Time)? / 1e3,
        None => quantity(text, QuantityDimension::Time)?,
    };
    if seconds > 0.0 { Ok(seconds) } else { Err("a period must be above zero".to_string()) }
}

/// A time that differs by less is the same to a reader.
const NOTICED: f64 = 1e-4;

pub fn run(args: &Args, terminal: TerminalSupport) -> Result<ExitVerdict, CommandFailure> {
    let path = args.output.as_deref();
    let format = format_of(&ROW_FORMATS, args.format, path, OutputFormat::Csv, "setpoints")?;
    let out = RowOutput::open(path, &args.file, format)?;
    let loaded = load_one(&args.file, &args.common)?;
    let job = loaded.job()?;
    let report = job.report();
    let head = SampleHead::of(&job, &report, args.period);
    let reported = |error| trouble(path, error);
    let mut writer = SampleWriter::new(out, format, SampleColumns::new(&head)).map_err(reported)?;
    let mut done = Ok(());
    let sampling = SamplingRequest {
        period_s: args.period,
        level: args.level.of(),
        max_samples: args.max_samples,
    };
    let sampled = job.setpoints(&sampling, |sample, line| {
        write_unless_failed(&mut done, || writer.sample(sample, line));
    });
    let sampled = sampled.map_err(|error| failure(&error, args.max_samples, args.period))?;
    done.map_err(reported)?;
    writer.finish().map_err(reported)?.put()?;

    terminal.write_error(&recognized(&loaded));
    terminal.write_error(&report::text(
        &report,
        job.sources(),
        terminal.err,
        ReportDetail::default(),
    ));
    let units = if report.summary.inch { SummaryUnits::Inch } else { SummaryUnits::Millimetre };
    let bent = sampled.motion.bent_rapids > 0;
    let machine_s = if bent { machine_time(&job, args.level) } else { None };
    let columns = head.axes();
    let not_named = not_named_texts(job.not_named_axes());
    terminal.write_error(&summary(
        &sampled,
        machine_s,
        args.period,
        units,
        &not_named,
        columns,
        terminal.err,
    ));
    Ok(verdict(&report))
}

pub fn verdict(report: &Report) -> ExitVerdict {
    if report.worst() == Some(Severity::Error) { ExitVerdict::Problems } else { ExitVerdict::Clean }
}

/// Why there are no setpoints: at most `max_samples` were requested, one every `period_s` seconds.
pub fn failure(error: &SamplingError, max_samples: u64, period_s: f64) -> CommandFailure {
    match error {
        SamplingError::Limit(error) => wrong_limit(error),
        SamplingError::TooMany { at_least_s } => CommandFailure::wrong(
            format!(
                "more than {} setpoints: the run takes at least {}, with a setpoint every {}",
                grouped(max_samples),
                duration(*at_least_s),
                time_text(period_s),
            ),
            "give a longer --period, or a larger --max-samples",
        ),
    }
}

/// The time of the machine. The setpoints take longer: they bend where an axis of a dog-leg rapid arrives,
/// and slow down there, while the machine's axes do not wait for each other.
fn machine_time(job: &Job, level: PlanningQuality) -> Option<f64> {
    let options = MotionOptions { level: level.of(), ..MotionOptions::default() };
    job.time(&options).ok().map(|timed| timed.time.total_s())
}

fn summary(
    sampled: &SamplingReport,
    machine_s: Option<f64>,
    period_s: f64,
    units: SummaryUnits,
    not_named: &[String],
    columns: AxisMask,
    colors: bool,
) -> String {
    let SamplingReport { motion, time_s, count, chord, .. } = sampled;
    let mut text = String::new();
    let mut row = |name: &str, value: &str| {
        let name = style(colors, BOLD, format!("{name:10}"));
        text.push_str(&format!("  {name}{value}\n"));
    };
    let count = counted(*count, "setpoint", "setpoints");
    row("samples", &format!("{count}, one every {}", time_text(period_s)));
    row("time", &format!("{} ({} s)", duration(*time_s), short(*time_s, 6)));
    let extra = machine_s.map_or(0.0, |machine| time_s - machine);
    if extra > NOTICED * time_s {
        let (extra, time) = (duration(extra), duration(time_s - extra));
        row(
            "",
            &format!(
                "{extra} more than `chordal time` says ({time}): a rapid slows down here where one"
            ),
        );
        row("", "of its axes arrives; on the machine the others go on at full speed");
    }
    for text in not_named {
        row("zero", text);
    }
    if units == SummaryUnits::Inch {
        row("units", "mm and degrees in the rows, though the program is in inch");
    }
    let (chord_mm, line) = *chord;
    row("chord", &chord_text(chord_mm, line, units));
    if !motion.limits.assumed.is_empty() {
        row("limits", "typical values were used where the machine file gives none");
    }
    let axes = sampled.unknown_axes.and(columns).iter();
    let blank: Vec<String> = axes.map(|axis| axis.letter().to_string()).collect();
    if !blank.is_empty() {
        row("blank", &format!("{} where the place is not known", blank.join(", ")));
    }
    if motion.cuts_without_feed > 0 {
        let cuts = counted(motion.cuts_without_feed, "cut", "cuts");
        row("left out", &format!("{cuts} without a feed"));
    }
    if let Some(first) = motion.refused.first() {
        let moves = counted(motion.refused_moves, "move", "moves");
        let line = first.source.origin.line;
        row("left out", &format!("{moves}; the first on line {line}: {}", first.error));
    }
    text
}

/// How far the period cuts corners: with the digits that count.
fn chord_text(mm: f64, line: u32, units: SummaryUnits) -> String {
    if mm == 0.0 {
        return "none: there are only straight moves".to_string();
    }
    let (value, unit) = match units {
        SummaryUnits::Inch => (mm / 25.4, "in"),
        SummaryUnits::Millimetre => (mm, "mm"),
    };
    let decimals = (2.0 - value.log10().floor()).clamp(0.0, 12.0) as usize;
    format!("at most {} {unit}, on line {line}", short(value, decimals))
}

/// `1 ms`, `250 us`, `2 s`.
fn time_text(seconds: f64) -> String {
    let (value, unit) = match seconds {
        s if s >= 0.999_999 => (s, "s"),
        s if s >= 0.999_999e-3 => (s * 1e3, "ms"),
        s => (s * 1e6, "us"),
    };
    format!("{} {unit}", short(value, 6))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn periods_have_units() {
        for (text, seconds) in
            [("1ms", 1e-3), ("250 us", 2.5e-4), ("62.5µs", 6.25e-5), ("2 s", 2.0)]
        {
            assert!((period(text).unwrap() - seconds).abs() <= 1e-15 * seconds, "{text}");
        }
        for (text, said) in [
            ("0 ms", "above zero"),
            ("-1ms", "above zero"),
            ("NaN", "does not start with a number"),
            ("1", "no unit"),
            ("1 mm", "is a length"),
            ("us", "does not start with a number"),
        ] {
            let error = period(text).unwrap_err();
            assert!(error.contains(said), "{text}: {error}");
        }
    }

    #[test]
    fn a_chord_has_its_line() {
        assert_eq!(chord_text(2e-3, 7, SummaryUnits::Millimetre), "at most 0.002 mm, on line 7");
    }

    #[test]
    fn times_read_well() {
        assert_eq!(time_text(1e-3), "1 ms");
        assert_eq!(time_text(2.5e-4), "250 us");
        assert_eq!(time_text(2.0), "2 s");
    }
}
