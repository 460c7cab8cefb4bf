//! Runs a program of the suite with a real tool and takes the cuts made with compensation.

use std::path::Path;

use chordal::control::CompensationSide;
use chordal::machine::PerAxis;
use chordal::{CommandKind, Job, Machine, PathCommand, RunWatch, Segment, Source, SourceMap};

use crate::part::Piece;

/// A cut of the tool centre with compensation on, in inches, seen along two axes.
#[derive(Clone, Copy, Debug)]
pub struct Cut {
    pub piece: Piece,
    /// The third axis at its end.
    pub depth: f64,
}

impl Cut {
    pub fn is_arc(&self) -> bool {
        matches!(self.piece, Piece::Arc(..))
    }

    pub fn sweep_degrees(&self) -> f64 {
        match self.piece {
            Piece::Arc(_, _, _, sweep) => (sweep * 1e6).round() / 1e6,
            Piece::Line(..) => 0.0,
        }
    }

    pub fn radius(&self) -> f64 {
        match self.piece {
            Piece::Arc(_, radius, ..) => radius,
            Piece::Line(..) => f64::INFINITY,
        }
    }
}

/// What a run did.
pub struct Run {
    pub cuts: Vec<Cut>,
    told: Vec<(&'static str, String)>,
}

struct Cuts {
    axes: [usize; 2],
    cuts: Vec<Cut>,
}

impl RunWatch for Cuts {
    fn path(&mut self, path: PathCommand<'_>, _: &[Segment]) {
        if path.side == CompensationSide::Off {
            return;
        }
        let kind = &path.command.kind;
        let Some(motion) = kind.motion().filter(|_| !matches!(kind, CommandKind::Rapid { .. }))
        else {
            return;
        };
        let [a, b] = self.axes;
        let inch = |position: &PerAxis<f64>| [position[a] / 25.4, position[b] / 25.4];
        let (from, to) = (inch(&motion.from), inch(&motion.to));
        let piece = match kind.shape() {
            None => Piece::Line(from, to),
            Some(shape) => {
                // The plane of G18 is ZX; seen along X and Z it turns the other way.
                let (first, _, _) = shape.plane.axes();
                let (center, sense) = match first == a {
                    true => (shape.center, 1.0),
                    false => ([shape.center[1], shape.center[0]], -1.0),
                };
                let center = [center[0] / 25.4, center[1] / 25.4];
                let start = (from[1] - center[1]).atan2(from[0] - center[0]).to_degrees();
                let radius = shape.radius_from / 25.4;
                Piece::Arc(center, radius, start, sense * shape.sweep.to_degrees())
            }
        };
        self.cuts.push(Cut { piece, depth: motion.to[3 - a - b] / 25.4 });
    }
}

impl Run {
    pub fn new(program: &str, set: &[&str]) -> Run {
        Run::seen_along(program, set, [0, 1])
    }

    pub fn seen_along(program: &str, set: &[&str], axes: [usize; 2]) -> Run {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/suite");
        let text = std::fs::read(folder.join(program)).expect("a program of the suite");
        let name = if program.starts_with("fadal") { "fadal-4020" } else { "haas-vf2" };
        let mut machine = Machine::from_builtin(name).expect("a built-in machine");
        for assignment in set {
            machine.set(assignment).expect("a good assignment");
        }
        let mut sources = SourceMap::new();
        sources.add(Source::new(program, text));
        let job = Job::new(sources, machine).expect("a good machine");
        let mut seen = Cuts { axes, cuts: Vec::new() };
        let report = job.report_watched(&mut seen);
        let told = report.diagnostics.iter().map(|diagnostic| {
            let help = diagnostic.help.clone().unwrap_or_default();
            (diagnostic.code.info().id, format!("{} {help}", diagnostic.message))
        });
        Run { cuts: seen.cuts, told: told.collect() }
    }

    /// The texts of a code.
    pub fn told(&self, id: &str) -> Vec<&str> {
        self.told.iter().filter(|told| told.0 == id).map(|told| told.1.as_str()).collect()
    }
}
