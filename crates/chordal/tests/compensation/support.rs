//! Runs a program through compensation and notes the path of the tool centre.

use chordal::control::{CompensationSide, Origin};
use chordal::geometry::Plane;
use chordal::{
    CommandKind, Diagnostic, Job, Machine, PathCommand, PathSink, Severity, Source, SourceMap,
};

/// A move in the plane: where it ends, and for an arc its centre and its sweep.
#[derive(Clone, Copy, Debug)]
pub struct Step {
    pub to: [f64; 2],
    pub arc: Option<([f64; 2], Sweep)>,
}

#[derive(Clone, Copy, Debug)]
pub enum Sweep {
    Degrees(f64),
    Clockwise,
    Counterclockwise,
}

/// What a run gave.
#[derive(Debug)]
pub struct Ran {
    /// From the first compensated move on, in the unit of the case.
    pub steps: Vec<Step>,
    /// The third axis at the end of each.
    pub heights: Vec<f64>,
    /// Errors as the control shows them.
    pub alarms: Vec<String>,
    /// All codes that were reported.
    pub told: Vec<&'static str>,
    plane: Plane,
    unit: f64,
    begun: bool,
}

impl PathSink for Ran {
    fn command(&mut self, path: PathCommand<'_>) {
        if let CommandKind::Plane(plane) = path.command.kind {
            self.plane = plane;
        }
        let Some(motion) = path.command.kind.motion() else { return };
        self.begun |= path.side != CompensationSide::Off;
        if !self.begun {
            return;
        }
        let (a, b, c) = self.plane.axes();
        let arc = path.command.kind.shape().map(|shape| {
            let center = [shape.center[0] / self.unit, shape.center[1] / self.unit];
            (center, Sweep::Degrees(shape.sweep.to_degrees()))
        });
        self.steps.push(Step { to: [motion.to[a] / self.unit, motion.to[b] / self.unit], arc });
        self.heights.push(motion.to[c] / self.unit);
    }

    fn diagnostic(&mut self, diagnostic: Diagnostic, _: &Origin) {
        self.told.push(diagnostic.code.id());
        if diagnostic.severity == Severity::Error {
            self.alarms.push(diagnostic.alarm.unwrap_or(diagnostic.message));
        }
    }
}

/// A machine with the offset D1 and these settings, in words of `chordal … --set`.
pub fn machine(name: &str, radius: f64, unit: &str, settings: &[&str]) -> Machine {
    let mut machine = Machine::from_builtin(name).expect("a built-in machine");
    let unit = if unit == "inch" { "in" } else { unit };
    let offset = format!("tools.1.diameter=\"{} {unit}\"", 2.0 * radius);
    let calculator = "settings.decimal_point=calculator";
    // The contours have more decimals than the controls.
    let decimals = ["settings.excess_decimals=exact", "settings.most_digits=0"];
    for assignment in [offset.as_str(), calculator].iter().chain(&decimals).chain(settings) {
        machine.set(assignment).unwrap_or_else(|error| panic!("{assignment}: {error}"));
    }
    machine
}

/// The tool centre of a program; `unit` is mm in one unit of the figures.
pub fn run(text: &str, machine: Machine, unit: f64) -> Ran {
    let mut sources = SourceMap::new();
    sources.add(Source::new("case.nc", text.as_bytes()));
    let job = Job::new(sources, machine).expect("the settings are known");
    let mut ran = Ran {
        steps: Vec::new(),
        heights: Vec::new(),
        alarms: Vec::new(),
        told: Vec::new(),
        plane: Plane::Xy,
        unit,
        begun: false,
    };
    job.compensated(None, &mut ran);
    ran
}
