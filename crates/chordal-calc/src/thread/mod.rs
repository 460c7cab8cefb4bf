//! Threads by name and by size: the basic 60° profile of unified and ISO metric threads here, what
//! a name says in `designation`, how it is read in `name`, limits of the classes in `unified` and
//! `metric`, pipe threads in `pipe`.

mod class;
mod designation;
mod figure;
mod formula_rows;
mod metric;
mod name;
mod pipe;
mod pipe_sizes;
mod series;
mod unified;
mod words;

pub use class::{FitClass, ToleranceZone};
pub use designation::{ThreadDesignation, ThreadForm};
use formula_rows::FormulaRows;

use crate::calculation::{QuantityKind, WorkedCalculation};
use crate::error::{CalcError, bounded};
use crate::math::{PI, atan};
use crate::numbers::AnswerUnit;

/// Height of the sharp profile over the pitch: √3/2.
pub(crate) const H: f64 = 0.866_025_403_784_438_6;
/// Minor diameter of an inside thread: 2·5/8·H below the major (ISO 68-1, ASME B1.1).
pub(crate) const INSIDE: f64 = 1.25 * H;
/// Pitch diameter: 2·3/8·H below the major.
pub(crate) const MIDDLE: f64 = 0.75 * H;
/// Root of an outside thread: 2·17/24·H below the major, the rounded root of the design profile.
pub(crate) const OUTSIDE: f64 = 17.0 / 12.0 * H;

/// Where a thread is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ThreadLocation {
    /// In a hole.
    Inside,
    /// On a boss.
    Outside,
}

/// Hand of a thread.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ThreadHand {
    /// Clockwise goes away.
    Right,
    /// Counter-clockwise goes away.
    Left,
}

/// A thread of the 60° profile.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ThreadSize {
    /// Nominal diameter, mm.
    pub major: f64,
    /// Distance of neighbouring crests, mm.
    pub pitch: f64,
    /// Number of starts.
    pub starts: u32,
}

impl ThreadSize {
    /// Checks that there is something between the crests.
    ///
    /// # Errors
    /// When a size is none, or the profile is deeper than the thread is thick.
    pub fn check(&self, units: AnswerUnit) -> Result<(), CalcError> {
        let ThreadSize { major, pitch, starts } = *self;
        bounded(&[major, pitch], &[], units)?;
        let good = |value: f64| value > 0.0 && value.is_finite();
        if !good(major) || !good(pitch) || starts == 0 {
            return Err(CalcError::new(
                format!(
                    "a thread with diameter {}, pitch {} and {starts} starts is not possible",
                    units.length(major),
                    units.length(pitch)
                ),
                "diameter, pitch and starts must be above zero",
            ));
        }
        if OUTSIDE * pitch >= major {
            return Err(CalcError::new(
                format!(
                    "a pitch of {} takes {} off a diameter of {}: nothing is left",
                    units.length(pitch),
                    units.length(OUTSIDE * pitch),
                    units.length(major)
                ),
                "check the pitch; --tpi takes threads per inch, --pitch a distance",
            ));
        }
        Ok(())
    }

    /// Minor diameter of an inside thread: the hole before it is cut, mm.
    pub fn minor_inside(&self) -> f64 {
        self.major - INSIDE * self.pitch
    }

    /// Where a profile without a rounded or flat root comes to a point, mm.
    pub(crate) fn sharp_root(&self) -> f64 {
        self.major - 2.0 * H * self.pitch
    }

    /// Root diameter of an outside thread, mm.
    pub fn minor_outside(&self) -> f64 {
        self.major - OUTSIDE * self.pitch
    }
}

/// Diameters, depths, lead and helix angle of a thread.
///
/// # Errors
/// When the thread cannot be.
pub fn thread_data(thread: &ThreadSize, units: AnswerUnit) -> Result<WorkedCalculation, CalcError> {
    let mut worked = basic(thread, units)?;
    worked.note("Basic sizes without allowance or tolerance; the class of fit adds them.");
    Ok(worked)
}

/// What a thread's name says: its basic sizes, and the limits of the classes in it.
///
/// # Errors
/// When the thread cannot be, or the standard has no limits for its class.
pub fn named_thread(
    name: &ThreadDesignation,
    starts: u32,
    units: AnswerUnit,
) -> Result<WorkedCalculation, CalcError> {
    let mut worked = match name.form {
        ThreadForm::Metric | ThreadForm::Unified => sixty(name, starts, units)?,
        ThreadForm::Npt | ThreadForm::Nptf | ThreadForm::G | ThreadForm::R => {
            pipe::worked(name, starts, units)?
        }
    };
    worked.notes.extend(name.notes.iter().cloned());
    Ok(worked)
}

/// A thread of the 60° profile by its name.
fn sixty(
    name: &ThreadDesignation,
    starts: u32,
    units: AnswerUnit,
) -> Result<WorkedCalculation, CalcError> {
    let thread = name.thread(starts)?;
    if name.classes.is_empty() {
        return thread_data(&thread, units);
    }
    let mut worked = basic(&thread, units)?;
    for class in &name.classes {
        worked.title.push_str(&format!(", {class}"));
    }
    worked.note("D, D2, D1 and d3 are basic sizes; the limits of the class follow them.");
    for class in &name.classes {
        match class {
            FitClass::Unified { grade, place } => {
                unified::limits(&mut worked, &thread, *grade, *place)
            }
            FitClass::Metric { pitch, crest } => {
                metric::limits(&mut worked, &thread, *pitch, *crest)?
            }
            FitClass::Pipe { .. } => {}
        }
    }
    if units != name.units {
        let unit = name.units.name();
        worked.note(format!("The numbers in the formulas of the limits are in {unit}."));
    }
    if starts > 1 {
        worked.note("The limits are for a thread with one start.");
    }
    Ok(worked)
}

fn basic(thread: &ThreadSize, units: AnswerUnit) -> Result<WorkedCalculation, CalcError> {
    thread.check(units)?;
    let ThreadSize { major, pitch, starts } = *thread;
    let mut worked = WorkedCalculation::new("Thread, 60° profile (UN and ISO metric)", units);
    worked.input("D", "major (nominal) diameter", QuantityKind::Length, major);
    worked.input("P", "pitch", QuantityKind::Length, pitch);
    worked.input("n", "starts", QuantityKind::Number, f64::from(starts));
    let p = units.number(pitch);
    let length = QuantityKind::Length;
    if units == AnswerUnit::Inch {
        let tpi = 25.4 / pitch;
        let filled = format!("1/{p}");
        worked.intermediate("TPI", "threads per inch", QuantityKind::Number, tpi, "1/P", filled);
    }
    let lead = pitch * f64::from(starts);
    let number = |mm: f64| units.number(mm);
    let known = [("D", major), ("P", pitch)];
    worked.result("L", "lead: Z in one turn", length, lead, "n·P", format!("{starts}·{p}"));
    let mut rows = FormulaRows::new(&mut worked, 1.0, &number, &known);
    rows.intermediate("H", "height of the sharp profile", H * pitch, "0.866025·P");
    for (symbol, meaning, share, formula) in [
        ("D2", "pitch diameter", MIDDLE, "D − 0.649519·P"),
        ("D1", "minor diameter inside: the hole", INSIDE, "D − 1.082532·P"),
        ("d3", "minor (root) diameter outside", OUTSIDE, "D − 1.226869·P"),
    ] {
        rows.result(symbol, meaning, major - share * pitch, formula);
    }
    let (inside, outside) = (INSIDE * pitch / 2.0, OUTSIDE * pitch / 2.0);
    rows.result("t1", "single depth inside, 5/8·H", inside, "0.541266·P");
    rows.result("t3", "single depth outside, 17/24·H", outside, "0.613435·P");
    let middle = major - MIDDLE * pitch;
    worked.result(
        "φ",
        "helix angle at the pitch diameter",
        QuantityKind::Angle,
        atan(lead / (PI * middle)),
        "atan(L/(π·D2))",
        format!("atan({}/(π·{}))", units.number(lead), units.number(middle)),
    );
    worked.figure = figure::profile(thread, units);
    Ok(worked)
}
