//! The settings that a firmware lists for `$$`, read into keys of a machine file, and written back.
//!
//! ```
//! use chordal_dialect::{dump, table};
//! use chordal_machine::ControlName;
//!
//! let rows = table(ControlName::Grbl).unwrap().firmware.unwrap().dump;
//! let read = dump::read("dump.txt", "$11=0.020\n$110=5000.000\n", rows).unwrap();
//! assert_eq!(read[0].assignment, "settings.$11=0.020 mm");
//! assert_eq!(read[1].assignment, "axes.X.max_velocity=5000.000 mm/min");
//! ```

use std::fmt::Write;
use std::ops::Range;
use std::sync::Arc;

use chordal_machine::{Machine, MachineError};

use crate::control::Control;
use crate::firmware::{DumpMeaning, DumpRow};

/// A setting of such a list, as a key of a machine file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct DumpSetting {
    /// `axes.X.max_velocity=5000.000 mm/min`.
    pub assignment: String,
    /// The bytes of its value in the list.
    pub span: Range<usize>,
}

/// How the lines between settings begin in a log of a sender: answers, reports and remarks.
const OTHER_LINE_STARTS: [&str; 9] = ["ok", "[", "<", "grbl", "(", ";", "#", ">", "$$"];

/// Reads a list: one setting on each line, as `$110=5000.000` or `$110=5000.000 (x max rate, mm/min)`. Settings
/// that describe nothing of the machine are left out.
///
/// # Errors
/// One error for each line that is neither a setting nor an answer and for each value that is no number from zero
/// on, or one for a text without any setting.
pub fn read(
    name: &str,
    text: &str,
    rows: &[DumpRow],
) -> Result<Vec<DumpSetting>, Vec<MachineError>> {
    let (mut settings, mut errors, mut has_any) = (Vec::new(), Vec::new(), false);
    let whole: Arc<str> = text.into();
    let fail = |errors: &mut Vec<MachineError>, span: Range<usize>, message: String, help: &str| {
        let (file, text) = (name.to_string(), whole.clone());
        let (span, help) = (Some(span), Some(help.to_string()));
        errors.push(MachineError { message, help, file, span, text });
    };
    let mut line_start = 0;
    for line in text.split_inclusive('\n') {
        let begin = line_start + (line.len() - line.trim_start().len());
        line_start += line.len();
        let line = line.trim();
        let is_answer = || {
            let lower = line.to_ascii_lowercase();
            OTHER_LINE_STARTS.iter().any(|answer| lower.starts_with(answer))
        };
        let Some((number, value)) = setting_of(line) else {
            if !line.is_empty() && !is_answer() {
                let span = begin..begin + line.len();
                let message = "this line is no setting and no answer of the firmware".to_string();
                fail(&mut errors, span, message, "a dump has lines such as `$110=5000.000`");
            }
            continue;
        };
        has_any = true;
        let Some(row) = number.parse().ok().and_then(|n: u16| rows.iter().find(|r| r.number == n))
        else {
            continue;
        };
        let from = begin + (value.as_ptr() as usize - line.as_ptr() as usize);
        let span = from..from + value.len();
        match value.parse::<f64>() {
            Ok(number) if number.is_finite() && number >= 0.0 => {
                settings.push(DumpSetting { assignment: row.assignment(value), span });
            }
            _ => {
                let message = format!("`${number}` needs a number from zero on, not `{value}`");
                fail(&mut errors, span, message, "write it as the firmware does: `$110=5000.000`");
            }
        }
    }
    if !has_any {
        // One error instead of one for each line of some other file.
        errors.clear();
        let message = "there is no setting in this file".to_string();
        let help =
            "keep what the firmware answers to `$$`: lines such as `$110=5000.000`".to_string();
        let (file, text) = (name.to_string(), whole);
        errors.push(MachineError { message, help: Some(help), file, span: None, text });
    }
    if errors.is_empty() { Ok(settings) } else { Err(errors) }
}

/// The number and the value of `$110=5000.000 (x max rate, mm/min)`, or the name and the value of `$N0=G54`.
fn setting_of(line: &str) -> Option<(&str, &str)> {
    let (number, value) = line.strip_prefix('$')?.split_once('=')?;
    let is_name = !number.is_empty() && number.bytes().all(|byte| byte.is_ascii_alphanumeric());
    let value = value.split(['(', ' ', '\t']).next().unwrap_or_default();
    is_name.then_some((number, value))
}

impl DumpRow {
    fn assignment(&self, value: &str) -> String {
        let number = self.number;
        match self.meaning {
            DumpMeaning::JunctionDeviation | DumpMeaning::ArcTolerance => {
                format!("settings.${number}={value} mm")
            }
            DumpMeaning::Steps(_) | DumpMeaning::LaserMode => format!("settings.${number}={value}"),
            DumpMeaning::Velocity(axis) => format!("axes.{axis}.max_velocity={value} mm/min"),
            DumpMeaning::Acceleration(axis) => {
                format!("axes.{axis}.max_acceleration={value} mm/s^2")
            }
            DumpMeaning::Travel(axis) => format!("axes.{axis}.travel=[\"-{value} mm\", \"0 mm\"]"),
        }
    }

    /// Its value on a machine; `None` if the machine file does not give it.
    fn value(&self, machine: &Machine, control: &Control) -> Option<f64> {
        let junctions = control.parameters.rules.path.junctions;
        match self.meaning {
            DumpMeaning::JunctionDeviation => Some(junctions?.deviation_mm),
            DumpMeaning::ArcTolerance => Some(junctions?.arc_tolerance_mm),
            DumpMeaning::LaserMode => {
                Some(f64::from(u8::from(control.parameters.rules.path.laser_mode)))
            }
            DumpMeaning::Steps(axis) => junctions?.steps_per_mm.get(axis as usize).copied(),
            DumpMeaning::Velocity(axis) => Some(60.0 * machine.axis(axis)?.max_velocity?),
            DumpMeaning::Acceleration(axis) => machine.axis(axis)?.max_acceleration,
            DumpMeaning::Travel(axis) => {
                let (low, high) = machine.axis(axis)?.travel?;
                Some(high - low)
            }
        }
    }
}

/// The settings of a machine as its firmware would list them; `None` if its firmware has no such list.
pub fn write(machine: &Machine) -> Option<String> {
    let (control, _) = Control::of(machine)?;
    let rows = control.table.firmware?.dump;
    let mut text = String::new();
    for row in rows {
        if let Some(value) = row.value(machine, &control) {
            let value = match row.meaning {
                DumpMeaning::LaserMode => value.to_string(),
                DumpMeaning::JunctionDeviation
                | DumpMeaning::ArcTolerance
                | DumpMeaning::Steps(_)
                | DumpMeaning::Velocity(_)
                | DumpMeaning::Acceleration(_)
                | DumpMeaning::Travel(_) => number(value),
            };
            let _ = writeln!(text, "${}={value}", row.number);
        }
    }
    Some(text)
}

/// A value with three decimals, as the firmware writes it, or with as many more as it takes to read the same value
/// back.
fn number(value: f64) -> String {
    let reads_back = |text: &str| {
        text.parse::<f64>().is_ok_and(|read| (read - value).abs() <= 1e-12 * value.abs())
    };
    let texts = (3..=9).map(|places| format!("{value:.places$}"));
    texts.into_iter().find(|text| reads_back(text)).unwrap_or_else(|| value.to_string())
}
