//! Threads by name or by size.

use chordal_calc::{Designation, Thread, Units, thread_data};

use super::answer::{Answer, give, refused};
use super::quantity::{Numbers, UnitsName, Written, length};
use crate::failure::Failure;

const EXAMPLES: &str = "\
Examples:
  chordal calc thread M30x2
  chordal calc thread 1.5-8
  chordal calc thread \"1 1/16-28\" --starts 2
  chordal calc thread --diameter 1.5in --tpi 8 -o thread.svg";

/// Diameters, depth, lead and helix angle of a 60° thread (UN, ISO metric)
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    #[command(flatten)]
    size: Size,

    /// Number of starts
    #[arg(long, value_name = "N", default_value = "1")]
    starts: u32,

    #[command(flatten)]
    answer: Answer,
}

/// Which thread.
#[derive(clap::Args)]
pub struct Size {
    /// Its name: M30x2, 1.5-8, "1 1/16-28"
    #[arg(value_name = "THREAD")]
    name: Option<String>,

    /// Major (nominal) diameter, where no name is given
    #[arg(long, value_name = "LENGTH", value_parser = length, conflicts_with = "name")]
    diameter: Option<Written>,

    /// Distance from crest to crest
    #[arg(long, value_name = "LENGTH", value_parser = length, conflicts_with_all = ["name", "tpi"])]
    pitch: Option<Written>,

    /// Threads per inch
    #[arg(long, value_name = "N", conflicts_with = "name")]
    tpi: Option<f64>,
}

impl Size {
    /// The thread, and the numbers in its own unit unless another is asked for.
    pub fn thread(
        &self,
        starts: u32,
        asked: Option<UnitsName>,
    ) -> Result<(Thread, Numbers), Failure> {
        if let Some(name) = &self.name {
            let Designation { major, pitch, units } = Designation::read(name).map_err(refused)?;
            let mut numbers = Numbers::new(asked, []);
            if asked.is_none() {
                numbers.units = units;
            }
            return Ok((Thread { major, pitch, starts }, numbers));
        }
        let written = [self.diameter.as_ref(), self.pitch.as_ref()];
        let mut numbers = Numbers::new(asked, written);
        if asked.is_none() && self.tpi.is_some() {
            numbers.units = Units::Inch;
        }
        let pitch = match (&self.pitch, self.tpi) {
            (Some(pitch), _) => Some(numbers.of(pitch)?),
            (None, Some(tpi)) if tpi > 0.0 && tpi.is_finite() => Some(25.4 / tpi),
            (None, Some(tpi)) => {
                return Err(Failure::wrong(
                    format!("{tpi} threads per inch cannot be"),
                    "give a number above zero",
                ));
            }
            (None, None) => None,
        };
        match (&self.diameter, pitch) {
            (Some(diameter), Some(pitch)) => {
                Ok((Thread { major: numbers.of(diameter)?, pitch, starts }, numbers))
            }
            _ => Err(Failure::wrong(
                "which thread is not said",
                "name it, as M30x2 or 1.5-8, or give --diameter with --pitch or --tpi",
            )),
        }
    }
}

pub fn run(args: &Args) -> Result<(), Failure> {
    let (thread, numbers) = args.size.thread(args.starts, args.answer.units)?;
    give(thread_data(&thread, numbers.units), &args.answer)
}
