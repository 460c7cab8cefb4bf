//! `chordal calc`: the shop's mathematics. One file per subject; `quantity` reads its numbers,
//! `answer` writes what comes out.

mod answer;
mod arcs;
mod corners;
mod cutting;
mod holes;
mod quantity;
mod thread;
mod thread_mill;

use clap::Subcommand;

use crate::failure::{CommandFailure, ExitVerdict};

const EXAMPLES: &str = "\
Examples:
  chordal calc corner --angle 30deg --tool 0.5in
  chordal calc speeds --tool 12mm --surface 120m/min --teeth 4 --per-tooth 0.05mm
  chordal calc bolt-circle --diameter 80mm --holes 6
  chordal calc tap-drill M10x1.5
  chordal calc thread M30x2
  chordal calc thread-mill M30x2 --tool 16mm --depth 20mm --feed 400mm/min \\
      --spindle 3000 --control haas -o thread.nc -o thread.svg

Every answer has its formula, the formula with the numbers, and, with -o figure.svg or
-o figure.png, a drawing. Lengths have a unit (1.5in, 38mm), or --units gives it for all.
A tool is given by its diameter.";

/// Shop mathematics: cutter offsets, arcs, chords, holes, speeds and feeds, threads, thread mill programs
#[derive(clap::Args)]
#[command(after_help = EXAMPLES, subcommand_required = true, arg_required_else_help = true)]
pub struct Args {
    #[command(subcommand)]
    subject: CalculationSubject,
}

#[derive(Subcommand)]
enum CalculationSubject {
    Corner(corners::CornerArgs),
    TwoAngles(corners::TwoAnglesArgs),
    Tangent(corners::TangentArgs),
    LineArc(arcs::LineArcArgs),
    ArcArc(arcs::ArcArcArgs),
    Arc(arcs::ArcArgs),
    Chords(arcs::ChordsArgs),
    BoltCircle(holes::BoltCircleArgs),
    Speeds(cutting::Args),
    TapDrill(holes::TapDrillArgs),
    Thread(thread::Args),
    ThreadMill(thread_mill::Args),
}

pub fn run(args: &Args) -> Result<ExitVerdict, CommandFailure> {
    match &args.subject {
        CalculationSubject::Corner(args) => corners::corner(args),
        CalculationSubject::TwoAngles(args) => corners::two_angles(args),
        CalculationSubject::Tangent(args) => corners::tangent(args),
        CalculationSubject::LineArc(args) => arcs::line_arc(args),
        CalculationSubject::ArcArc(args) => arcs::arc_arc(args),
        CalculationSubject::Arc(args) => arcs::arc(args),
        CalculationSubject::Chords(args) => arcs::chords(args),
        CalculationSubject::BoltCircle(args) => holes::circle(args),
        CalculationSubject::Speeds(args) => cutting::run(args),
        CalculationSubject::TapDrill(args) => holes::tap_drill_of(args),
        CalculationSubject::Thread(args) => thread::run(args),
        CalculationSubject::ThreadMill(args) => thread_mill::run(args),
    }?;
    Ok(ExitVerdict::Clean)
}
