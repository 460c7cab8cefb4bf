//! Runs a program and notes what happens by line.

use chordal::control::{ArcShape, FeedAlong, FeedMode, PathMode, RapidPath, SpindleState, Units};
use chordal::geometry::{ParamCurve, Plane, Vec3};
use chordal::machine::{AXES, AXIS_LETTERS, PerAxis};
use chordal::path::curve_of;
use chordal::{
    Command, CommandKind, Diagnostic, Job, Machine, PathCommand, Report, RunWatch, Segment,
    Severity, Source, SourceMap,
};

use crate::grammar::Program;

/// A motion that was made.
#[derive(Clone, Debug)]
pub struct Made {
    pub line: u32,
    pub kind: &'static str,
    pub from: PerAxis<f64>,
    pub to: PerAxis<f64>,
    pub shape: Option<ArcShape>,
    pub length: f64,
    /// In mm/min (or deg/min, 1/min, mm per revolution); `None` for rapids.
    pub feed: Option<f64>,
    /// True where `feed` has a length in it.
    pub feed_has_length: bool,
    pub along: Option<&'static str>,
    pub tangents: (Vec3, Vec3),
    pub mode: PathMode,
    /// What its places are multiplied by, beside those of the slide.
    written: PerAxis<f64>,
}

impl Made {
    /// Makes its places what a program writes: diameters on axes that are programmed so.
    fn write_as(&mut self, factors: &PerAxis<f64>) {
        self.written = *factors;
        for (axis, factor) in factors.iter().enumerate() {
            self.from[axis] *= factor;
            self.to[axis] *= factor;
        }
        if let Some(shape) = &mut self.shape {
            let (first, second, _) = shape.plane.axes();
            shape.center[0] *= factors[first];
            shape.center[1] *= factors[second];
        }
    }
}

/// A diagnostic and the line it points at.
#[derive(Clone, Debug)]
pub struct Told {
    pub line: u32,
    pub id: &'static str,
    pub severity: Severity,
    pub text: String,
}

/// All that a run did.
#[derive(Debug)]
pub struct Ran {
    pub made: Vec<Made>,
    /// What is no motion, in the words of the grammar: its line, and how many motions of that
    /// line came before.
    pub events: Vec<(u32, usize, String)>,
    pub told: Vec<Told>,
    /// Lines that were printed, each with the line of the program that printed it.
    pub printed: Vec<(u32, String)>,
    pub report: Report,
    /// mm in one unit of the expectations' lengths.
    pub unit: f64,
}

/// Runs the program on a machine.
pub fn run(program: &Program, machine: &str) -> Result<Ran, String> {
    let mut machine = Machine::from_builtin(machine).map_err(|error| format!("{error:?}"))?;
    for assignment in &program.set {
        machine.set(assignment).map_err(|error| error.message)?;
    }
    machine.switches.block_delete = [program.block_delete; 10];
    let mut sources = SourceMap::new();
    sources.add(Source::new("program.nc", program.text.as_bytes()));
    let job = Job::new(sources, machine).map_err(|error| format!("{error:?}"))?;
    let mode = job.rules().path.start_mode();
    let mut seen = Seen::new(program.of_path, mode);
    let report = job.report_watched(&mut seen);
    let Seen { mut made, events, printed, .. } = seen;
    let factors = job.machine().written_factors();
    made.iter_mut().for_each(|made| made.write_as(&factors));
    let inch = match program.units.as_deref() {
        Some(units) => units == "inch",
        None => job.rules().units == Units::Inch,
    };
    let source = job.sources().iter().next().map(|(_, source)| source);
    let line = |d: &Diagnostic| source.map_or(1, |s| s.line_of(d.primary.span.range.start));
    let told = report
        .diagnostics
        .iter()
        .map(|d| Told {
            line: line(d),
            id: d.code.info().id,
            severity: d.severity,
            text: words_of(d),
        })
        .collect();
    Ok(Ran { made, events, told, printed, report, unit: if inch { 25.4 } else { 1.0 } })
}

/// A dwell, a change of the spindle or a stop, in words.
fn event_of(kind: &CommandKind) -> Option<String> {
    Some(match kind {
        CommandKind::Dwell { seconds, .. } => format!("dwell {}", short(*seconds)),
        CommandKind::Spindle { state, .. } => match state {
            SpindleState::Off => "spindle off".into(),
            SpindleState::Cw => "spindle cw".into(),
            SpindleState::Ccw => "spindle ccw".into(),
            SpindleState::Oriented => "spindle oriented".into(),
        },
        CommandKind::Stop { .. } => "stop".into(),
        _ => return None,
    })
}

/// Notes the motions asked for, what happens between them, and the printed lines.
struct Seen {
    of_path: bool,
    mode: PathMode,
    /// The mode in which every program begins.
    start_mode: PathMode,
    made: Vec<Made>,
    events: Vec<(u32, usize, String)>,
    printed: Vec<(u32, String)>,
}

impl Seen {
    fn new(of_path: bool, mode: PathMode) -> Seen {
        let start_mode = mode;
        let (made, events, printed) = (Vec::new(), Vec::new(), Vec::new());
        Seen { of_path, mode, start_mode, made, events, printed }
    }

    fn command(&mut self, command: &Command) {
        match command.kind {
            CommandKind::PathMode(mode) => self.mode = mode,
            CommandKind::End => self.mode = self.start_mode,
            _ => {}
        }
        self.made.extend(made_by(command, self.mode));
        if let Some(event) = event_of(&command.kind) {
            let line = command.origin.line;
            let before = self.made.iter().filter(|made| made.line == line).count();
            self.events.push((line, before, event));
        }
    }
}

impl RunWatch for Seen {
    fn programmed(&mut self, command: &Command) {
        if !self.of_path {
            self.command(command);
        }
        if let CommandKind::Output { text } = &command.kind {
            self.printed.push((command.origin.line, text.clone()));
        }
    }

    fn path(&mut self, path: PathCommand<'_>, _: &[Segment]) {
        if self.of_path {
            self.command(path.command);
        }
    }
}

fn words_of(diagnostic: &Diagnostic) -> String {
    let mut text = diagnostic.message.clone();
    let more =
        [Some(&diagnostic.primary.text), diagnostic.alarm.as_ref(), diagnostic.help.as_ref()];
    for part in more.into_iter().flatten().chain(&diagnostic.notes) {
        text.push_str(" / ");
        text.push_str(part);
    }
    text
}

fn made_by(command: &Command, mode: PathMode) -> Option<Made> {
    let motion = command.kind.motion()?;
    let shape = command.kind.shape().copied();
    let kind = match &command.kind {
        CommandKind::Rapid { .. } => "rapid",
        CommandKind::Line { .. } => "line",
        CommandKind::Arc { .. } => "arc",
        CommandKind::Spline { .. } => "spline",
        _ => "spiral",
    };
    let feed = command.kind.feed();
    let linear = motion.from[..3] != motion.to[..3] || motion.from == motion.to || shape.is_some();
    // A rapid that obeys a feed.
    let rapid_feed = match command.kind {
        CommandKind::Rapid { path: RapidPath::AtFeed(speed), .. } => Some(speed * 60.0),
        _ => None,
    };
    let value = feed.map(|feed| match feed.mode {
        FeedMode::PerTime if !linear => (feed.value * 60.0).to_degrees(),
        FeedMode::PerTime | FeedMode::InverseTime => feed.value * 60.0,
        FeedMode::PerRevolution => feed.value,
    });
    let (length, tangents) = match command.kind.spline() {
        Some(spline) => (spline.length(1e-9), (spline.start_tangent(), spline.end_tangent())),
        None => {
            let curve = curve_of(motion, shape.as_ref());
            let length = curve.length();
            (length, (curve.tangent_at(0.0), curve.tangent_at(length)))
        }
    };
    Some(Made {
        written: [1.0; AXES],
        line: command.origin.line,
        kind,
        from: motion.from,
        to: motion.to,
        shape,
        length,
        feed: value.or(rapid_feed),
        feed_has_length: rapid_feed.is_some()
            || linear && feed.is_some_and(|feed| feed.mode != FeedMode::InverseTime),
        along: feed.map(|feed| if feed.along == FeedAlong::Path { "path" } else { "plane" }),
        tangents,
        mode,
    })
}

impl Made {
    /// The path mode in the words of the grammar, and its distance in mm (0: none named).
    pub fn corner(&self) -> (&'static str, f64) {
        match self.mode {
            PathMode::ExactStop => ("stop", 0.0),
            PathMode::ExactPath => ("exact", 0.0),
            PathMode::Continuous { tolerance_mm, .. } => ("round", tolerance_mm.unwrap_or(0.0)),
        }
    }

    pub fn plane(&self) -> Option<&'static str> {
        self.shape.map(|shape| match shape.plane {
            Plane::Xy => "xy",
            Plane::Zx => "zx",
            Plane::Yz => "yz",
        })
    }

    pub fn is_helix(&self) -> bool {
        self.shape.is_some_and(|shape| {
            let (_, _, normal) = shape.plane.axes();
            self.kind == "arc" && self.from[normal] != self.to[normal]
        })
    }

    /// What must hold for every arc, whatever a program expects: ends, centre, radii and sweep
    /// agree with each other. Names what does not.
    pub fn contradiction(&self) -> Option<String> {
        let shape = self.shape?;
        let (a, b, _) = shape.plane.axes();
        let slide = |axis: usize, way: f64| way / self.written[axis];
        let arm =
            |p: &PerAxis<f64>| (slide(a, p[a] - shape.center[0]), slide(b, p[b] - shape.center[1]));
        let (from, to) = (arm(&self.from), arm(&self.to));
        let radii = (from.0.hypot(from.1), to.0.hypot(to.1));
        let off = (radii.0 - shape.radius_from).abs().max((radii.1 - shape.radius_to).abs());
        if off > 1e-6 {
            return Some(format!("the radii differ from the ends' distances by {off:e} mm"));
        }
        let (sin, cos) = shape.sweep.sin_cos();
        let turned = (from.0 * cos - from.1 * sin, from.0 * sin + from.1 * cos);
        let scale = shape.radius_to / shape.radius_from;
        let miss = (turned.0 * scale - to.0).hypot(turned.1 * scale - to.1);
        (miss > 1e-6).then(|| format!("the sweep misses the end by {miss:e} mm"))
    }

    /// For people, in the units of the expectations.
    pub fn describe(&self, unit: f64) -> String {
        let mut text = if self.is_helix() { "helix".to_string() } else { self.kind.to_string() };
        if let Some(shape) = self.shape {
            let (a, b, _) = shape.plane.axes();
            let letter = |axis: usize| "XYZ".as_bytes()[axis] as char;
            text += if shape.sweep > 0.0 { " ccw" } else { " cw" };
            text += &format!(" plane {}", self.plane().unwrap_or(""));
            text += &format!(" center {}{}", letter(a), short(shape.center[0] / unit));
            text += &format!(" {}{}", letter(b), short(shape.center[1] / unit));
            text += &format!(" radius {}", short(shape.radius_from / unit));
            if (shape.radius_from - shape.radius_to).abs() > 1e-9 {
                text += &format!("..{}", short(shape.radius_to / unit));
            }
            text += &format!(" sweep {}", short(shape.sweep.to_degrees().abs()));
        }
        text += &format!(" from{}", self.place(&self.from, unit));
        text += &format!(" to{}", self.place(&self.to, unit));
        text += &format!(" length {}", short(self.length / unit));
        if let Some(feed) = self.feed {
            let unit = if self.feed_has_length { unit } else { 1.0 };
            text += &format!(" feed {}", short(feed / unit));
        }
        text
    }

    fn place(&self, position: &PerAxis<f64>, unit: f64) -> String {
        let axes = (0..AXES).filter(|&axis| axis < 3 || self.from[axis] != self.to[axis]);
        axes.map(|axis| {
            let value = if axis < 3 { position[axis] / unit } else { position[axis].to_degrees() };
            format!(" {}{}", AXIS_LETTERS.as_bytes()[axis] as char, short(value))
        })
        .collect()
    }
}

/// A number without useless zeros.
pub fn short(value: f64) -> String {
    let text = format!("{value:.6}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".into() } else { text.into() }
}
