//! What the columns of setpoints are, whatever they are written to.
//!
//! `time_s`; `x_mm`, `x_vel_mm_per_s`, `x_acc_mm_per_s2` and the same of Y and Z; `a_deg`,
//! `a_vel_deg_per_s`, `a_acc_deg_per_s2` and the same of B and C, of the rotary axes that the program
//! moves; `speed_mm_per_s`, which is that of the tool along X, Y and Z; `line`. Which axes there are
//! must be known before the first setpoint, because nothing is held back: a run of the program says so.

use chordal::control::AxisMask;
use chordal::machine::{AXES, Axis};
use chordal::motion::MotionSample;
use chordal::{Job, Report};

use crate::digest::sha256_hex;

/// The version of the columns and of what they mean.
pub const SAMPLE_SCHEMA: &str = "chordal.samples/1";

/// What is known of setpoints before the first one.
#[derive(Clone, Debug, PartialEq)]
pub struct SampleHead {
    /// Which of A, B and C are columns.
    pub rotary: [bool; 3],
    /// Time from one setpoint to the next, s.
    pub period_s: f64,
    /// The name of the program's file.
    pub program: String,
    /// SHA-256 of the program's text, as `sha256sum` prints it.
    pub program_sha256: String,
    /// The machine.
    pub machine: String,
    /// The control, as machine files name it.
    pub control: String,
}

impl SampleHead {
    /// Of the program and the machine of a job, and the report of its run.
    pub fn of(job: &Job, report: &Report, period_s: f64) -> SampleHead {
        let program = job.sources().get(chordal::diagnostics::FileId(0));
        let text = program.map_or(&[][..], |source| source.text());
        SampleHead {
            rotary: ['A', 'B', 'C']
                .map(|letter| report.summary.axes.iter().any(|axis| axis.letter == letter)),
            period_s,
            program: program.map_or_else(String::new, |source| source.name().to_string()),
            program_sha256: sha256_hex(text),
            machine: job.machine().name.clone(),
            control: job.machine().control.as_str().to_string(),
        }
    }

    /// The columns of doubles.
    pub(crate) fn columns(&self) -> Vec<SetpointColumn> {
        columns_of(self.axes())
    }

    /// The axes that are columns.
    pub fn axes(&self) -> AxisMask {
        let mut axes = AxisMask::LINEAR;
        (3..AXES).filter(|axis| self.rotary[axis - 3]).for_each(|axis| axes.insert(axis));
        axes
    }
}

/// The columns of doubles, those before `line`, for a machine with these axes.
fn columns_of(axes: AxisMask) -> Vec<SetpointColumn> {
    let mut columns = vec![SetpointColumn::new("time_s", "s", SetpointValue::Time)];
    for axis in axes.iter() {
        let letter = axis.letter().to_ascii_lowercase();
        let (unit, units) = match axis.is_rotary() {
            false => ("mm", ["mm", "mm/s", "mm/s^2"]),
            true => ("deg", ["deg", "deg/s", "deg/s^2"]),
        };
        let names = [
            format!("{letter}_{unit}"),
            format!("{letter}_vel_{unit}_per_s"),
            format!("{letter}_acc_{unit}_per_s2"),
        ];
        for (order, (name, unit)) in names.into_iter().zip(units).enumerate() {
            let value = SetpointValue::Axis { axis: axis as usize, order };
            columns.push(SetpointColumn { name, unit, value });
        }
    }
    columns.push(SetpointColumn::new("speed_mm_per_s", "mm/s", SetpointValue::Speed));
    columns
}

/// Name, unit and meaning of the columns of doubles, for a machine with these axes.
pub(crate) fn sample_columns(
    axes: AxisMask,
) -> impl Iterator<Item = (String, &'static str, String)> {
    columns_of(axes).into_iter().map(|column| {
        let meaning = match column.value {
            SetpointValue::Time => "from the start".to_string(),
            SetpointValue::Speed => {
                "speed of the tool along X, Y and Z; NaN where it is not known".to_string()
            }
            SetpointValue::Axis { axis, order } => {
                let what = ["place", "velocity", "acceleration"][order];
                format!(
                    "{what} of {}, continuous where offsets jump; NaN where it is not known",
                    Axis::ALL[axis].letter()
                )
            }
        };
        (column.name, column.unit, meaning)
    })
}

/// A column of doubles.
#[derive(Clone, Debug)]
pub(crate) struct SetpointColumn {
    pub name: String,
    unit: &'static str,
    value: SetpointValue,
}

#[derive(Clone, Copy, Debug)]
enum SetpointValue {
    Time,
    /// 0 is the place, 1 the velocity, 2 the acceleration.
    Axis {
        axis: usize,
        order: usize,
    },
    Speed,
}

impl SetpointColumn {
    fn new(name: &str, unit: &'static str, value: SetpointValue) -> SetpointColumn {
        SetpointColumn { name: name.into(), unit, value }
    }

    /// Its value, in its unit.
    #[inline]
    pub(crate) fn of(&self, sample: &MotionSample) -> f64 {
        match self.value {
            SetpointValue::Time => sample.time_s,
            SetpointValue::Speed => {
                let [x, y, z, ..] = sample.velocity;
                (x * x + y * y + z * z).sqrt()
            }
            SetpointValue::Axis { axis, order } => {
                let row = match order {
                    0 => &sample.position,
                    1 => &sample.velocity,
                    _ => &sample.acceleration,
                };
                if axis < 3 { row[axis] } else { row[axis].to_degrees() }
            }
        }
    }
}
