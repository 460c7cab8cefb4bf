//! Random contours as programs: their text, and their run through the whole of Chordal.

#[path = "../../../chordal-path/tests/support/mod.rs"]
pub mod support;

use std::fmt::Write;

use chordal::geometry::Vec2;
use chordal::path::PathSink;
use chordal::path::gouge::{GougeCurve, ToolSide};
use chordal::{Job, Machine, Source, SourceMap};

/// The program that turns the offset on from `start` to the chain, and off from the chain to `end`.
pub fn text_of(side: ToolSide, start: Vec2, chain: &[GougeCurve], end: Vec2) -> String {
    let code = if side == ToolSide::Left { "G41" } else { "G42" };
    let mut text = String::from("G21 G90 G17 G40\nT1 M6\nS1000 M3\n");
    let at = |p: Vec2| format!("X{:.9} Y{:.9}", p.a, p.b);
    writeln!(text, "G0 {}\nG1 {code} D1 {} F100.", at(start), at(chain[0].from())).unwrap();
    for curve in chain {
        match *curve {
            GougeCurve::Line { to, .. } => writeln!(text, "G1 {}", at(to)),
            GougeCurve::Arc { center, sweep, .. } => {
                let arm = center - curve.from();
                let g = if sweep > 0.0 { "G3" } else { "G2" };
                writeln!(text, "{g} {} I{:.9} J{:.9}", at(curve.to()), arm.a, arm.b)
            }
        }
        .unwrap();
    }
    writeln!(text, "G1 G40 {}\nM30", at(end)).unwrap();
    text
}

/// What a sink sees of the program, run with a tool of this radius (mm).
pub fn run<S: PathSink + Default>(text: &str, radius: f64) -> S {
    let mut machine = Machine::from_builtin("fanuc-30i").unwrap();
    for assignment in [
        format!("tools.1.diameter={} mm", 2.0 * radius),
        "settings.outside_corner=arc".into(),
        // The contours have more decimals than the control.
        "settings.excess_decimals=exact".into(),
        "settings.most_digits=0".into(),
    ] {
        machine.set(&assignment).unwrap();
    }
    let mut sources = SourceMap::new();
    sources.add(Source::new("random.nc", text.as_bytes()));
    let job = Job::new(sources, machine).unwrap();
    let mut seen = S::default();
    job.compensated(None, &mut seen);
    seen
}
