//! Lathes on stock: volumes and profiles with a closed form, planted faults, compensated contours.

mod faults;
mod programs;
mod replay;
mod tips;

use chordal::stock::section::Region;
use chordal::stock::{TurnedOptions, TurnedReport};
use chordal::{Job, Machine, Source, SourceMap};

/// Runs a program on a setup.
fn turn(setup: &str, program: &str) -> TurnedReport {
    turn_with(setup, program, &|name| Err(format!("no file {name}")))
}

fn turn_with(
    setup: &str,
    program: &str,
    files: &dyn Fn(&str) -> Result<Vec<u8>, String>,
) -> TurnedReport {
    turn_with_files("fanuc-lathe", setup, program, files)
}

/// The same on another machine, without files.
pub(crate) fn turn_on(machine: &str, setup: &str, program: &str) -> TurnedReport {
    turn_with_files(machine, setup, program, &|name| Err(format!("no file {name}")))
}

fn turn_with_files(
    machine: &str,
    setup: &str,
    program: &str,
    files: &dyn Fn(&str) -> Result<Vec<u8>, String>,
) -> TurnedReport {
    let none = |name: &str| Err(format!("no file {name}"));
    let setup = format!("machine = \"{machine}\"\n{setup}");
    let machine = Machine::from_toml("setup.toml", &setup, &none).expect("a good setup");
    let mut sources = SourceMap::new();
    sources.add(Source::new("part.nc", program.as_bytes().to_vec()));
    let job = Job::new(sources, machine).expect("a job");
    job.turned_stock(&TurnedOptions::default(), files).expect("stock")
}

/// Without the last digits, by which places would be sorted.
fn tidy(value: f64) -> f64 {
    (value * 1e10).round() / 1e10 + 0.0
}

/// The corners of everything that is left, as (diameter, z), sorted.
fn corners(found: &TurnedReport) -> Vec<(f64, f64)> {
    let segments = found.sections().flat_map(Region::shape).flatten();
    let mut corners: Vec<(f64, f64)> =
        segments.map(|at| (tidy(2.0 * at.start.b), tidy(at.start.a))).collect();
    corners.sort_by(|x, y| x.partial_cmp(y).expect("numbers"));
    corners
}
