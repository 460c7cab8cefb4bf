//! Runs a cycle with random data and records what the tool does.

use std::collections::BTreeMap;

use chordal::control::{Command, CommandKind};
use chordal::{Diagnostic, Job, Machine, RunSink, Severity, Sink, Source, SourceMap};

/// Runs of each cycle.
pub const RUNS_OF_CYCLE: u64 = 200;

/// How far a length may be off, mm.
pub const NEAR_MM: f64 = 1e-6;

/// The tool axis where the cycle is called, mm.
pub const START_MM: f64 = 80.0;

/// Where the cycle is called, mm.
pub const CALLED_AT: [f64; 2] = [12.5, -7.0];

/// The speed of the spindle, rev/min.
pub const RPM: f64 = 600.0;

/// The words of a cycle with the values that each takes.
pub type Choices = &'static [(u32, &'static [f64])];

/// A random sequence.
pub struct DataSequence(pub u64);

impl DataSequence {
    pub fn below(&mut self, count: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 % count as u64) as usize
    }
}

/// The values of a cycle.
#[derive(Clone, Debug)]
pub struct CycleData(pub BTreeMap<u32, f64>);

impl CycleData {
    pub fn of(&self, number: u32) -> f64 {
        self.0.get(&number).copied().unwrap_or(0.0)
    }

    pub fn has(&self, number: u32) -> bool {
        self.0.contains_key(&number)
    }

    /// Set-up clearance, bottom and end level of the 200s.
    pub fn levels(&self) -> (f64, f64, f64) {
        let clearance = self.of(203) + self.of(200);
        let end = clearance.max(self.of(203) + self.of(204));
        (clearance, self.of(203) + self.of(201), end)
    }
}

/// What the tool does.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum SeenMove {
    /// To a point by a rapid.
    Rapid([f64; 3]),
    /// To a point at a feed, mm/min.
    Cut([f64; 3], f64),
    /// To a point round a centre by an angle, at a feed.
    Round([f64; 3], [f64; 2], f64, f64),
    /// A wait, s.
    Wait(f64),
}

impl SeenMove {
    pub fn to(&self) -> Option<[f64; 3]> {
        match self {
            SeenMove::Rapid(to) | SeenMove::Cut(to, _) | SeenMove::Round(to, ..) => Some(*to),
            SeenMove::Wait(_) => None,
        }
    }
}

#[derive(Default)]
struct CycleRecord {
    seen: Vec<SeenMove>,
    errors: Vec<String>,
}

impl Sink for CycleRecord {
    fn command(&mut self, command: &Command) {
        if !command.origin.cycle {
            return;
        }
        if let CommandKind::Dwell { seconds, .. } = command.kind {
            self.seen.push(SeenMove::Wait(seconds));
        }
        let Some(motion) = command.kind.motion() else { return };
        let to = [motion.to[0], motion.to[1], motion.to[2]];
        let feed = command.kind.feed().map_or(0.0, |feed| feed.value * 60.0);
        let is_still = (0..3).all(|axis| (motion.to[axis] - motion.from[axis]).abs() < 1e-9);
        match &command.kind {
            CommandKind::Arc { shape, .. } => {
                self.seen.push(SeenMove::Round(to, shape.center, shape.sweep, feed));
            }
            _ if is_still => {}
            CommandKind::Rapid { .. } => self.seen.push(SeenMove::Rapid(to)),
            _ => self.seen.push(SeenMove::Cut(to, feed)),
        }
    }

    fn diagnostic(&mut self, diagnostic: Diagnostic) {
        if diagnostic.severity == Severity::Error {
            self.errors.push(format!("{}: {}", diagnostic.code.id(), diagnostic.message));
        }
    }
}

impl RunSink for CycleRecord {}

/// What the tool does in the cycle of a definition, with a tool of a radius.
pub fn run(definition: &str, tool: f64) -> Vec<SeenMove> {
    let [x, y] = CALLED_AT;
    let text = format!(
        "BEGIN PGM T MM\nTOOL DEF 1 L+0 R+{tool}\nTOOL CALL 1 Z S{RPM}\nL Z+{START_MM} R0 FMAX M3\n\
         {definition}\nL X{x:+} Y{y:+} FMAX\nCYCL CALL\nM30\nEND PGM T MM\n"
    );
    let mut machine = Machine::from_builtin("heidenhain-mill").expect("a built-in machine");
    machine.axes.iter_mut().flatten().for_each(|axis| axis.travel = Some((-10_000.0, 10_000.0)));
    let offset = machine.work_offsets.entry("G54".to_string()).or_default();
    offset.values = [Some(0.0); 6];
    let mut sources = SourceMap::new();
    sources.add(Source::new("T.H", text.clone().into_bytes()));
    let mut record = CycleRecord::default();
    Job::new(sources, machine).expect("a job").run(&mut record);
    assert!(record.errors.is_empty(), "{text}{:?}", record.errors);
    record.seen
}

/// Runs a cycle with random values of its words, and compares each run.
pub fn each_cycle(
    number: u32,
    choices: Choices,
    tool: f64,
    mut compare: impl FnMut(&CycleData, &[SeenMove]),
) {
    let mut random = DataSequence(0x9E37_79B9_7F4A_7C15 ^ u64::from(number));
    for _ in 0..RUNS_OF_CYCLE {
        let mut data = BTreeMap::new();
        let mut text = format!("CYCL DEF {number} A CYCLE");
        for (word, values) in choices {
            assert!(values.len() >= 3 || *word == 213, "Q{word} of cycle {number}");
            let value = values[random.below(values.len())];
            data.insert(*word, value);
            text += &format!(" ~\n  Q{word}={value} ;A WORD");
        }
        compare(&CycleData(data), &run(&text, tool));
    }
}

/// Whether two records of motions are the same.
pub fn same(found: &[SeenMove], expected: &[SeenMove]) -> bool {
    let near = |a: f64, b: f64| (a - b).abs() < NEAR_MM;
    let near_points = |a: [f64; 3], b: [f64; 3]| (0..3).all(|axis| near(a[axis], b[axis]));
    let is_same = |(found, expected): (&SeenMove, &SeenMove)| match (*found, *expected) {
        (SeenMove::Rapid(a), SeenMove::Rapid(b)) => near_points(a, b),
        (SeenMove::Cut(a, f), SeenMove::Cut(b, g)) => near_points(a, b) && near(f, g),
        (SeenMove::Round(a, c, s, f), SeenMove::Round(b, d, t, g)) => {
            near_points(a, b) && near(c[0], d[0]) && near(c[1], d[1]) && near(s, t) && near(f, g)
        }
        (SeenMove::Wait(a), SeenMove::Wait(b)) => near(a, b),
        _ => false,
    };
    found.len() == expected.len() && found.iter().zip(expected).all(is_same)
}

/// Points along what the tool does at a feed, with the level and the feed; arcs in steps of two degrees.
pub fn cut_points(seen: &[SeenMove]) -> Vec<([f64; 3], f64)> {
    let mut at = [CALLED_AT[0], CALLED_AT[1], START_MM];
    let mut found = Vec::new();
    for step in seen {
        match *step {
            SeenMove::Rapid(_) | SeenMove::Wait(_) => {}
            SeenMove::Cut(to, feed) => {
                for part in 0..=16 {
                    let t = f64::from(part) / 16.0;
                    found.push(([0, 1, 2].map(|axis| at[axis] + (to[axis] - at[axis]) * t), feed));
                }
            }
            SeenMove::Round(to, center, sweep, feed) => {
                let count = ((sweep.abs().to_degrees() / 2.0).ceil() as u32).max(1);
                let radius = (at[0] - center[0]).hypot(at[1] - center[1]);
                let from = (at[1] - center[1]).atan2(at[0] - center[0]);
                for part in 0..=count {
                    let t = f64::from(part) / f64::from(count);
                    let angle = from + sweep * t;
                    let (x, y) =
                        (center[0] + radius * angle.cos(), center[1] + radius * angle.sin());
                    found.push(([x, y, at[2] + (to[2] - at[2]) * t], feed));
                }
            }
        }
        at = step.to().unwrap_or(at);
    }
    found
}

/// The levels on which the tool moves in the plane at a feed, from the top.
pub fn cut_levels(seen: &[SeenMove]) -> Vec<f64> {
    let mut at = [CALLED_AT[0], CALLED_AT[1], START_MM];
    let mut levels: Vec<f64> = Vec::new();
    for step in seen {
        let Some(to) = step.to() else { continue };
        let is_level = (to[2] - at[2]).abs() < 1e-9;
        let is_cut = matches!(step, SeenMove::Cut(..) | SeenMove::Round(..));
        if is_cut && is_level && !levels.iter().any(|level| (level - to[2]).abs() < 1e-7) {
            levels.push(to[2]);
        }
        at = to;
    }
    levels.sort_by(|a, b| b.total_cmp(a));
    levels
}

/// From a surface by an infeed to a depth below it.
pub fn infeeds(surface: f64, depth: f64, infeed: f64) -> Vec<f64> {
    let mut found = Vec::new();
    let mut reached = 0.0;
    while reached < depth - 1e-9 {
        reached = if infeed > 0.0 { (reached + infeed).min(depth) } else { depth };
        found.push(surface - reached);
    }
    found
}

pub fn assert_near(found: f64, expected: f64, what: &str, data: &CycleData) {
    assert!((found - expected).abs() < NEAR_MM, "{what}: {found} is not {expected}\n{data:?}");
}

pub fn assert_levels(seen: &[SeenMove], expected: &[f64], data: &CycleData) {
    let found = cut_levels(seen);
    let is_same = found.len() == expected.len()
        && found.iter().zip(expected).all(|(a, b)| (a - b).abs() < NEAR_MM);
    assert!(is_same, "levels {found:?} are not {expected:?}\n{data:?}");
}

/// The level at the end, and the first one after a rapid.
pub fn assert_ends(seen: &[SeenMove], first: f64, last: f64, data: &CycleData) {
    let begin = seen.iter().find_map(SeenMove::to).expect("a move");
    assert_near(begin[2], first, "the first level", data);
    let end = seen.iter().rev().find_map(SeenMove::to).expect("a move");
    assert_near(end[2], last, "the end level", data);
    assert!(matches!(seen[0], SeenMove::Rapid(_)), "{data:?}");
}

/// The feeds of the moves straight down, and of all others.
pub fn feeds(seen: &[SeenMove]) -> (Vec<f64>, Vec<f64>) {
    let mut at = [CALLED_AT[0], CALLED_AT[1], START_MM];
    let (mut down, mut across) = (Vec::new(), Vec::new());
    for step in seen {
        let Some(to) = step.to() else { continue };
        let is_vertical = (to[0] - at[0]).hypot(to[1] - at[1]) < 1e-9;
        match *step {
            SeenMove::Cut(_, feed) if is_vertical => down.push(feed),
            SeenMove::Cut(_, feed) | SeenMove::Round(_, _, _, feed) => across.push(feed),
            SeenMove::Rapid(_) | SeenMove::Wait(_) => {}
        }
        at = to;
    }
    (down, across)
}

pub fn assert_feeds(found: &[f64], allowed: &[f64], what: &str, data: &CycleData) {
    for feed in found {
        let is_allowed = allowed.iter().any(|own| (own - feed).abs() < 1e-6);
        assert!(is_allowed, "{what}: {feed} is not one of {allowed:?}\n{data:?}");
    }
}
