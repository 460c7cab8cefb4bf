//! Threads by name or by size.

use chordal_calc::{AnswerUnit, ThreadDesignation, ThreadSize, named_thread, thread_data};

use super::answer::{CalculationOutput, give, refused};
use super::quantity::{UnitReader, UnitsName, WrittenQuantity, length};
use crate::failure::CommandFailure;

const EXAMPLES: &str = "\
Examples:
  chordal calc thread M30x2
  chordal calc thread 1.5-8
  chordal calc thread \"1 1/16-28\" --starts 2
  chordal calc thread 1/4-20-2A/2B
  chordal calc thread M10x1.5-6g
  chordal calc thread 1/2-NPT
  chordal calc thread G1/2
  chordal calc thread --diameter 1.5in --tpi 8 -o thread.svg";

/// Diameters, depth, lead, helix angle and limits of a thread (UN, ISO metric, NPT, G, R)
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    #[command(flatten)]
    size: ThreadSizeArgs,

    /// Number of starts
    #[arg(long, value_name = "N", default_value = "1")]
    starts: u32,

    #[command(flatten)]
    answer: CalculationOutput,
}

/// Which thread.
#[derive(clap::Args)]
pub struct ThreadSizeArgs {
    /// Its name: M30x2, 1.5-8, "1 1/16-28 UN-2A", #10-24, "1/2 NPT"; a class gives its limits
    #[arg(value_name = "THREAD")]
    name: Option<String>,

    /// Major (nominal) diameter, if no name is given
    #[arg(long, value_name = "LENGTH", value_parser = length, conflicts_with = "name")]
    diameter: Option<WrittenQuantity>,

    /// Distance from crest to crest
    #[arg(long, value_name = "LENGTH", value_parser = length, conflicts_with_all = ["name", "tpi"])]
    pitch: Option<WrittenQuantity>,

    /// Threads per inch
    #[arg(long, value_name = "N", conflicts_with = "name")]
    tpi: Option<f64>,
}

/// A thread as it was asked for.
pub struct ThreadRequest {
    /// What the name says, where it has one.
    pub name: Option<ThreadDesignation>,
    size: Option<(f64, f64)>,
    /// Its numbers in its own unit unless another is asked for.
    pub numbers: UnitReader,
}

impl ThreadRequest {
    /// The thread with so many starts, for what needs the 60° profile.
    pub fn thread(&self, starts: u32) -> Result<ThreadSize, CommandFailure> {
        match (&self.name, self.size) {
            (Some(name), _) => name.thread(starts).map_err(refused),
            (None, Some((major, pitch))) => Ok(ThreadSize { major, pitch, starts }),
            (None, None) => Err(missing_thread()),
        }
    }
}

fn missing_thread() -> CommandFailure {
    CommandFailure::wrong(
        "no thread is given",
        "give its name, such as M30x2 or 1.5-8, or --diameter with --pitch or --tpi",
    )
}

impl ThreadSizeArgs {
    /// The thread, by its name or by its sizes.
    pub fn read(&self, requested: Option<UnitsName>) -> Result<ThreadRequest, CommandFailure> {
        if let Some(name) = &self.name {
            let name = ThreadDesignation::read(name).map_err(refused)?;
            let mut numbers = UnitReader::new(requested, []);
            if requested.is_none() {
                numbers.units = name.units;
            }
            return Ok(ThreadRequest { name: Some(name), size: None, numbers });
        }
        let written = [self.diameter.as_ref(), self.pitch.as_ref()];
        let mut numbers = UnitReader::new(requested, written);
        if requested.is_none() && self.tpi.is_some() {
            numbers.units = AnswerUnit::Inch;
        }
        let pitch = self.pitch(&numbers)?;
        match (&self.diameter, pitch) {
            (Some(diameter), Some(pitch)) => Ok(ThreadRequest {
                name: None,
                size: Some((numbers.of(diameter)?, pitch)),
                numbers,
            }),
            _ => Err(missing_thread()),
        }
    }

    /// --pitch, or that of --tpi, mm.
    fn pitch(&self, numbers: &UnitReader) -> Result<Option<f64>, CommandFailure> {
        match (&self.pitch, self.tpi) {
            (Some(pitch), _) => Ok(Some(numbers.of(pitch)?)),
            (None, Some(tpi)) if tpi > 0.0 && tpi.is_finite() => Ok(Some(25.4 / tpi)),
            (None, Some(tpi)) => Err(CommandFailure::wrong(
                format!("{tpi} threads per inch are not possible"),
                "give a number above zero",
            )),
            (None, None) => Ok(None),
        }
    }
}

pub fn run(args: &Args) -> Result<(), CommandFailure> {
    let requested = args.size.read(args.answer.units)?;
    let units = requested.numbers.units;
    let worked = match &requested.name {
        Some(name) => named_thread(name, args.starts, units),
        None => thread_data(&requested.thread(args.starts)?, units),
    };
    give(worked, &args.answer)
}
