//! `chordal calibrate`: a machine's limits from measured cycle times.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use chordal::Machine;
use chordal::machine::{Axis, builtin};
use chordal::motion::{LimitError, MotionOptions, WaitKind};
use chordal::time::{FitParameter, LimitFactors, LimitFit, TimePrediction, UnfitReason, fit};
use chordal_load::{FileAccess, Loaded};

use crate::failure::{CommandFailure, ExitVerdict};
use crate::numbers::{counted, duration, fixed, short};
use crate::options::CommonArgs;
use crate::output::write_whole;
use crate::programs::load_one;
use crate::summary::plain_table;
use crate::terminal::say;
use crate::time::wrong_limit;

const EXAMPLES: &str = "\
Examples:
  chordal calibrate measured.csv --machine haas-vf2
  chordal calibrate measured.csv --machine haas-vf2 -o our-vf2.toml
  chordal time part.nc --machine our-vf2.toml

The rows of the file are `program,time`: the file of a program, in the folder of the CSV file or with
its path, and the time that its cycle took on the machine, in seconds or as 12:34 or 1:02:03. A first
row of names and rows that begin with # are skipped. Measure from cycle start to the end with
the overrides at 100 %, with programs of different kinds: long cuts, many short moves, tool
changes.";

/// Fits acceleration, jerk and tool change time of a machine to measured cycle times
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// Measured times: rows `program,time`
    #[arg(value_name = "MEASURED.csv")]
    measured: PathBuf,

    /// Writes a machine file with the fitted numbers; it inherits everything else
    #[arg(long, short, value_name = "MACHINE.toml")]
    output: Option<PathBuf>,

    #[command(flatten)]
    common: CommonArgs,
}

/// A program and its time on the machine.
struct CycleTimeMeasurement {
    loaded: Loaded,
    seconds: f64,
}

pub fn run(args: &Args) -> Result<ExitVerdict, CommandFailure> {
    let Some(name) = &args.common.machine else {
        return Err(CommandFailure::wrong(
            "no machine is given",
            "give it with --machine: the fit starts from its limits",
        ));
    };
    if let Some(output) = &args.output {
        keep_machine(name, output)?;
    }
    let measurements = read(args)?;
    let machine = measurements[0].loaded.machine().clone();
    let start = LimitFactors {
        acceleration: 1.0,
        jerk: 1.0,
        tool_change_s: machine.times.tool_change_s.unwrap_or(0.0),
    };
    let fitted = fit_to(&measurements, &machine, start)?;
    say(&text(&measurements, &machine, start, &fitted))?;
    if let Some(output) = &args.output {
        let file = machine_file(name, output, &machine, &fitted).map_err(|e| wrong_limit(&e))?;
        write_whole(output, file.as_bytes())?;
        say(&format!("\nwritten to {}\n", output.display()))?;
    }
    Ok(ExitVerdict::Clean)
}

/// The fitted file inherits the machine's and cannot take its place.
fn keep_machine(name: &str, output: &Path) -> Result<(), CommandFailure> {
    let same = |a: &Path, b: &Path| match (a.canonicalize(), b.canonicalize()) {
        (Ok(a), Ok(b)) => a == b,
        _ => false,
    };
    if builtin(name).is_none() && same(Path::new(name), output) {
        return Err(CommandFailure::wrong(
            format!("{} is the machine file that is fitted", output.display()),
            "give the output another name: the output inherits this file",
        ));
    }
    Ok(())
}

fn read(args: &Args) -> Result<Vec<CycleTimeMeasurement>, CommandFailure> {
    let path = &args.measured;
    let name = path.to_string_lossy();
    let text =
        FileAccess::Disk.text(path).map_err(|error| CommandFailure::read(name.as_ref(), &error))?;
    let folder = path.parent().unwrap_or(Path::new(""));
    let mut measurements = Vec::new();
    for (index, row) in text.trim_start_matches('\u{feff}').lines().enumerate() {
        let row = row.trim();
        if row.is_empty() || row.starts_with('#') {
            continue;
        }
        let stated = row.rsplit_once([',', ';', '\t']);
        let (file, time) =
            stated.map_or((row, ""), |(file, time)| (unquoted(file), unquoted(time)));
        match seconds(time) {
            Some(seconds) => {
                let loaded = load_one(&folder.join(file), &args.common)?;
                measurements.push(CycleTimeMeasurement { loaded, seconds });
            }
            // Names of columns.
            None if measurements.is_empty() && !time.contains(|c: char| c.is_ascii_digit()) => {}
            None => {
                return Err(CommandFailure::wrong(
                    format!("{name}, line {}: `{time}` is not a time", index + 1),
                    "a row is `program,time`, the time in seconds or as 12:34 or 1:02:03",
                ));
            }
        }
    }
    if measurements.is_empty() {
        return Err(CommandFailure::wrong(
            format!("{name} holds no measured time"),
            "a row is `program,time`, such as `part.nc,754.2`",
        ));
    }
    Ok(measurements)
}

fn unquoted(text: &str) -> &str {
    text.trim().trim_matches('"').trim()
}

/// `754.2`, `754.2 s`, `12:34`, `1:02:03.5`: a time above zero.
fn seconds(text: &str) -> Option<f64> {
    let text = text.strip_suffix('s').unwrap_or(text).trim();
    let mut seconds = 0.0;
    let parts: Vec<&str> = text.split(':').collect();
    if parts.len() > 3 {
        return None;
    }
    for part in parts {
        let value: f64 = part.parse().ok()?;
        seconds = seconds * 60.0 + value;
    }
    (seconds > 0.0 && f64::is_finite(seconds)).then_some(seconds)
}

/// Fits; what a program takes with some factors is planned once.
fn fit_to(
    measurements: &[CycleTimeMeasurement],
    machine: &Machine,
    start: LimitFactors,
) -> Result<LimitFit, CommandFailure> {
    let measured: Vec<f64> = measurements.iter().map(|program| program.seconds).collect();
    let mut known: BTreeMap<(usize, u64, u64), TimePrediction> = BTreeMap::new();
    let mut failed = None;
    let fitted = fit(&measured, start, |index, factors| {
        let key = (index, factors.acceleration.to_bits(), factors.jerk.to_bits());
        *known.entry(key).or_insert_with(|| {
            predict(&measurements[index].loaded, machine, factors).unwrap_or_else(|failure| {
                failed.get_or_insert(failure);
                TimePrediction { without_changes_s: 0.0, tool_changes: 0 }
            })
        })
    });
    failed.map_or(Ok(fitted), Err)
}

fn predict(
    loaded: &Loaded,
    machine: &Machine,
    factors: &LimitFactors,
) -> Result<TimePrediction, CommandFailure> {
    let changed = factors.on(machine).map_err(|error| wrong_limit(&error))?;
    let timed = loaded.job_on(changed)?.time(&MotionOptions::default());
    let time = timed.map_err(|error| wrong_limit(&error))?.time;
    let changes = time.waits.iter().find(|(kind, _)| *kind == WaitKind::ToolChange);
    let changes_s = changes.map_or(0.0, |(_, seconds)| *seconds);
    Ok(TimePrediction {
        without_changes_s: time.total_s() - changes_s,
        tool_changes: time.tool_changes,
    })
}

fn text(
    measurements: &[CycleTimeMeasurement],
    machine: &Machine,
    start: LimitFactors,
    fitted: &LimitFit,
) -> String {
    let programs = counted(measurements.len() as u64, "program", "programs");
    let mut text = format!("{programs} measured on {} ({})\n\n", machine.title, machine.name);
    let mut numbers = plain_table(&["", "machine file", "fitted"], 1);
    let to = &fitted.factors;
    for (parameter, before, after) in [
        (FitParameter::Acceleration, "1".to_string(), format!("x {}", fixed(to.acceleration, 3))),
        (FitParameter::Jerk, "1".to_string(), format!("x {}", fixed(to.jerk, 3))),
        (
            FitParameter::ToolChange,
            format!("{} s", fixed(start.tool_change_s, 2)),
            format!("{} s", fixed(to.tool_change_s, 2)),
        ),
    ] {
        let is_fitted =
            fitted.undetermined.iter().all(|(undetermined, _)| *undetermined != parameter);
        let after = if is_fitted { after } else { "kept".to_string() };
        numbers.add_row([parameter.word().to_string(), before, after]);
    }
    push_lines(&mut text, &numbers);
    text.push('\n');
    let header = ["program", "measured", "before", "error", "fitted", "error"];
    let mut table = plain_table(&header, 1);
    for (program, times) in measurements.iter().zip(&fitted.programs) {
        let error = |predicted: f64| {
            let percent = (predicted / times.measured_s - 1.0) * 100.0;
            format!("{}{} %", if percent > 0.0 { "+" } else { "" }, fixed(percent, 1))
        };
        table.add_row([
            program.loaded.name().to_string(),
            duration(times.measured_s),
            duration(times.before_s),
            error(times.before_s),
            duration(times.after_s),
            error(times.after_s),
        ]);
    }
    push_lines(&mut text, &table);
    text.push_str(&format!("\n  remaining error {} %", short(fitted.error() * 100.0, 2)));
    if fitted.is_exact_by_count() {
        text.push_str(
            ": there are as many unknowns as programs, so it means nothing; measure more programs",
        );
    }
    text.push('\n');
    for (parameter, why) in &fitted.undetermined {
        text.push_str(&format!("  {}\n", undetermined_text(*parameter, *why)));
    }
    for (program, times) in measurements.iter().zip(&fitted.programs) {
        if (times.after_s / times.measured_s - 1.0).abs() > MAX_RELATIVE_ERROR {
            text.push_str(&format!(
                "  {}: no machine of this kind explains its time; was it exactly this program, with the \
                 overrides\n    at 100 %, without a wait for the operator?\n",
                program.loaded.name()
            ));
        }
    }
    text
}

/// A relative error that no limits of axes make.
const MAX_RELATIVE_ERROR: f64 = 0.25;

fn push_lines(text: &mut String, table: &comfy_table::Table) {
    for line in table.lines() {
        text.push_str(&format!("  {}\n", line.trim_end()));
    }
}

fn undetermined_text(parameter: FitParameter, why: UnfitReason) -> String {
    let word = parameter.word();
    match why {
        UnfitReason::NoEffect => {
            let more = match parameter {
                FitParameter::ToolChange => "programs with tool changes",
                _ => "programs of many short moves",
            };
            format!("{word}: these programs hardly depend on it; measure {more}")
        }
        UnfitReason::SameAs(other) => format!(
            "{word}: cannot be separated from {} with these programs; measure others",
            other.word()
        ),
        UnfitReason::TooFew => {
            format!("{word}: cannot be separated with so few programs; measure more")
        }
    }
}

/// A machine file with what was fitted; it inherits the rest.
fn machine_file(
    name: &str,
    output: &Path,
    machine: &Machine,
    fitted: &LimitFit,
) -> Result<String, LimitError> {
    let is_fitted =
        |parameter| fitted.undetermined.iter().all(|(undetermined, _)| *undetermined != parameter);
    let factors = &fitted.factors;
    let changed = factors.on(machine)?;
    let mut text = format!(
        "# Fitted to {}; remaining error {} %.\ninherits = {:?}\n",
        counted(fitted.programs.len() as u64, "measured program", "measured programs"),
        short(fitted.error() * 100.0, 2),
        parent(name, output)
    );
    for axis in Axis::ALL {
        let Some(limits) = changed.axis(axis) else { continue };
        let (unit, part) = if axis.is_rotary() { ("deg", 1f64.to_degrees()) } else { ("mm", 1.0) };
        let rows = [
            ("max_acceleration", limits.max_acceleration, FitParameter::Acceleration, 2),
            ("rapid_acceleration", limits.rapid_acceleration, FitParameter::Acceleration, 2),
            ("max_jerk", limits.max_jerk, FitParameter::Jerk, 3),
            ("rapid_jerk", limits.rapid_jerk, FitParameter::Jerk, 3),
        ];
        let rows = rows.iter().filter(|(_, _, parameter, _)| is_fitted(*parameter));
        let rows: String = rows
            .filter_map(|(key, value, _, power)| {
                let value = short((*value)? * part, 1);
                Some(format!("{key} = \"{value} {unit}/s^{power}\"\n"))
            })
            .collect();
        if !rows.is_empty() {
            text.push_str(&format!("\n[axes.{axis}]\n{rows}"));
        }
    }
    if is_fitted(FitParameter::ToolChange) {
        let seconds = short(factors.tool_change_s, 2);
        text.push_str(&format!("\n[times]\ntool_change = \"{seconds} s\"\n"));
    }
    Ok(text)
}

/// What the fitted file inherits: a file is named from the folder of the fitted one.
fn parent(name: &str, output: &Path) -> String {
    let path = Path::new(name);
    if builtin(name).is_some() {
        return name.to_string();
    }
    let folder = |path: &Path| match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder.canonicalize().ok(),
        _ => Path::new(".").canonicalize().ok(),
    };
    match path.file_name() {
        Some(file) if folder(path) == folder(output) => file.to_string_lossy().into_owned(),
        _ => path
            .canonicalize()
            .map_or_else(|_| name.to_string(), |whole| whole.to_string_lossy().into_owned()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_are_read_as_people_write_them() {
        assert_eq!(seconds("754.2"), Some(754.2));
        assert_eq!(seconds("754.2 s"), Some(754.2));
        assert_eq!(seconds("12:34"), Some(754.0));
        assert_eq!(seconds("1:02:03.5"), Some(3723.5));
        for wrong in ["", "s", "-3", "0", "1:2:3:4", "12m", "nan", "inf"] {
            assert_eq!(seconds(wrong), None, "{wrong}");
        }
    }
}
