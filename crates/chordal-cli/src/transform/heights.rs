//! `--heights`: the map, and what is said of it.

use std::path::Path;

use chordal::Job;
use chordal_load::FileAccess;
use chordal_rewrite::{
    HeightCorrection, HeightMap, HeightOptions, MapError, TransformRefusal, TransformedProgram,
    warp,
};
use clap::ValueEnum;

use super::{TargetUnit, length, position};
use crate::failure::CommandFailure;
use crate::numbers::{SummaryUnits, grouped, short};

/// A surface that may be so far off is none.
const MAX_TOLERANCE_MM: f64 = 10.0;

/// How the map of `--heights` is used.
#[derive(clap::Args)]
pub(super) struct MapArgs {
    /// Units of the map; without it, those of the program
    #[arg(long, value_enum, requires = "heights")]
    heights_units: Option<TargetUnit>,

    /// The place whose height is taken for zero, where Z was set; without it, heights count as measured
    #[arg(long, value_name = "X,Y", requires = "heights", allow_hyphen_values = true)]
    heights_zero: Option<String>,

    /// How far the new path may be off the surface; 0.01 mm or 0.0005 in if not given
    #[arg(long, value_name = "LENGTH", requires = "heights")]
    heights_tolerance: Option<String>,

    /// A cut beyond the map: refused, or the edge of the map goes on
    #[arg(long, value_enum, default_value = "refuse", requires = "heights")]
    heights_outside: OutsideMapPolicy,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
enum OutsideMapPolicy {
    Refuse,
    Clamp,
}

/// A map that was read, and how to use it.
pub(super) struct HeightMapInput {
    map: HeightMap,
    how: HeightOptions,
    /// Of the program.
    units: SummaryUnits,
    /// Of the map.
    map_units: SummaryUnits,
}

impl HeightMapInput {
    pub(super) fn read(
        path: &Path,
        args: &MapArgs,
        units: SummaryUnits,
    ) -> Result<HeightMapInput, CommandFailure> {
        let map_units =
            args.heights_units.map_or(units, |unit| SummaryUnits::of(unit == TargetUnit::Inch));
        let bytes = FileAccess::Disk.bytes(path).map_err(|error| {
            CommandFailure::wrong(
                format!("{}: {error}", path.display()),
                "name a file that can be read",
            )
        })?;
        let map =
            HeightMap::read(&bytes, map_units.length_mm()).map_err(|error| wrong(path, error))?;
        let map = match &args.heights_zero {
            None => map,
            Some(text) => {
                let at = position(text, units)?;
                let outside = map.outside(at);
                if outside > 0.0 {
                    let far = outside / units.length_mm();
                    return Err(CommandFailure::wrong(
                        format!("`{text}` lies {far:.3} {} beyond the map", units.length_unit()),
                        "name a place of the map",
                    ));
                }
                map.with_zero_at(at)
            }
        };
        let usual = if units.length_mm() == 1.0 { 0.01 } else { 0.0127 };
        let tolerance_mm = match &args.heights_tolerance {
            None => usual,
            Some(text) => length(text, units)?,
        };
        if !(tolerance_mm > 0.0 && tolerance_mm <= MAX_TOLERANCE_MM) {
            return Err(CommandFailure::wrong(
                format!("a tolerance lies above zero and within {MAX_TOLERANCE_MM} mm"),
                "write a length, such as 0.01mm",
            ));
        }
        let how =
            HeightOptions { tolerance_mm, clamp: args.heights_outside == OutsideMapPolicy::Clamp };
        Ok(HeightMapInput { map, how, units, map_units })
    }

    /// A program bent over the map.
    pub(super) fn warp(&self, job: &Job) -> Result<TransformedProgram, TransformRefusal> {
        let warped = warp(job, &self.map, &self.how)?;
        Ok(self.described(warped))
    }

    /// The same for a program that was changed before; where that is not proved it is left so.
    pub(super) fn warp_on(
        &self,
        job: &Job,
        mut done: TransformedProgram,
    ) -> Result<TransformedProgram, TransformRefusal> {
        if !done.certificate.holds() {
            return Ok(done);
        }
        let bent = self.warp(&job.with_text(done.text.clone()))?;
        done.changes.extend(bent.changes);
        done.notes.extend(bent.notes);
        done.notes.push(
            "what was changed before is proved by itself; the proof below is that of the map"
                .into(),
        );
        (done.text, done.certificate) = (bent.text, bent.certificate);
        Ok(done)
    }

    fn described(&self, warped: HeightCorrection) -> TransformedProgram {
        let HeightCorrection { mut done, heights_mm, moves } = warped;
        let unit = self.units.length_mm();
        let name = self.units.length_unit();
        let digits = if unit == 1.0 { 3 } else { 4 };
        let number = |mm: f64| short(mm / unit, digits);
        let [columns, rows] = self.map.size();
        let [x, y] = self.map.bounds();
        let [low, high] = self.map.range();
        let mut map = format!(
            "the map has {columns} by {rows} points, X{} to {}, Y{} to {}, heights {} to {} {name}",
            number(x[0]),
            number(x[1]),
            number(y[0]),
            number(y[1]),
            number(low),
            number(high)
        );
        map += match self.map_units {
            SummaryUnits::Inch => "; the file is in inches",
            SummaryUnits::Millimetre => "; the file is in millimetres",
        };
        done.notes.insert(0, map);
        if let Some([low, high]) = heights_mm {
            done.notes.push(format!(
                "heights under the cuts: {} to {} {name}; {} moves, {} before",
                number(low),
                number(high),
                grouped(moves[1]),
                grouped(moves[0])
            ));
        }
        done
    }
}

fn wrong(path: &Path, error: MapError) -> CommandFailure {
    let place = error.line.map_or(String::new(), |line| format!(":{line}"));
    let words = if error.text.is_empty() { String::new() } else { format!(" in `{}`", error.text) };
    CommandFailure::wrong(format!("{}{place}: {}{words}", path.display(), error.what), error.help)
}
