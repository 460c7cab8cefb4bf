//! Full circles, helices, spirals and cones with every optional word given, zero and left out, on every
//! control: something moves or something is said, and what runs without a word has the angle, the length
//! and the feed of a calculation of its own.
//!
//! `CHORDAL_ROUNDS` sets how many blocks are tried on each machine (3,000).

#![allow(clippy::disallowed_methods, reason = "a test may be asked for more rounds")]

use std::f64::consts::TAU;

use chordal::control::{ArcShape, Feed, FeedAlong, Move};
use chordal::geometry::ParamCurve;
use chordal::path::{curve_of, duration_s};
use chordal::{Job, Machine, Severity, Source, SourceMap};

/// How a control counts turns.
#[derive(Clone, Copy, PartialEq, Debug)]
enum Form {
    /// An arc is what it is; P does nothing.
    Plain,
    /// P counts all turns.
    AllTurns,
    /// G2.1 and G3.1 with P; P of G2 and G3 counts turns beside the angle between the ends.
    Pitches,
    /// Q, then the height, then L; P counts turns beside the angle between the ends.
    IncrementHeightCount,
    /// Q, then L, rounded up.
    IncrementCount,
}

const MACHINES: [(&str, Form); 7] = [
    ("fadal-4020", Form::Plain),
    ("haas-vf2", Form::Plain),
    ("fanuc-6m", Form::Plain),
    ("fanuc-30i", Form::IncrementCount),
    ("mitsubishi-m700", Form::Pitches),
    ("mitsubishi-m700-type2", Form::IncrementHeightCount),
    ("linuxcnc-mill", Form::AllTurns),
];

/// Numbers that look random and are the same at every run.
struct Dice(u64);

impl Dice {
    fn next(&mut self) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0
    }

    fn below(&mut self, count: u64) -> u64 {
        (self.next() >> 11) % count
    }

    fn one_in(&mut self, count: u64) -> bool {
        self.below(count) == 0
    }

    /// A length of three decimals between two.
    fn length(&mut self, from: f64, to: f64) -> f64 {
        let steps = ((to - from) * 1000.0) as u64;
        from + self.below(steps) as f64 / 1000.0
    }

    fn pick<T: Copy>(&mut self, of: &[T]) -> T {
        of[self.below(of.len() as u64) as usize]
    }
}

fn thousandths(value: f64) -> f64 {
    (value * 1000.0).round() / 1000.0
}

/// A block and what it is meant to be.
#[derive(Debug)]
struct Asked {
    text: String,
    /// G2.1 or G3.1.
    spiral_code: bool,
    ccw: bool,
    start: [f64; 3],
    end: [f64; 3],
    center: [f64; 2],
    /// Indices of the plane's axes and its normal.
    axes: [usize; 3],
    p: Option<f64>,
    q: Option<f64>,
    l: Option<f64>,
    height: Option<f64>,
    by_radius: bool,
}

fn asked(dice: &mut Dice, form: Form) -> Asked {
    let axes = dice.pick(&[[0, 1, 2], [2, 0, 1], [1, 2, 0]]);
    let [a, b, c] = axes;
    let mut start = [0.0; 3];
    for value in &mut start {
        *value = thousandths(dice.length(-50.0, 50.0));
    }
    let arm = match dice.below(4) {
        0 => [dice.length(1.0, 40.0), 0.0],
        1 => [0.0, -dice.length(1.0, 40.0)],
        _ => [dice.length(-40.0, 40.0), dice.length(1.0, 40.0)],
    };
    let center = [start[a] + arm[0], start[b] + arm[1]];
    let mut end = start;
    let (from, radius) = ((-arm[1]).atan2(-arm[0]), arm[0].hypot(arm[1]));
    let ends = dice.below(5);
    match ends {
        0 | 1 => {}
        2 => {
            let angle = from + dice.length(0.1, 6.2);
            end[a] = thousandths(center[0] + radius * angle.cos());
            end[b] = thousandths(center[1] + radius * angle.sin());
        }
        3 => {
            let part = dice.pick(&[0.5, 2.0]);
            (end[a], end[b]) = (center[0] - arm[0] * part, center[1] - arm[1] * part);
        }
        _ => {
            end[a] = thousandths(center[0] + dice.length(-60.0, 60.0));
            end[b] = thousandths(center[1] + dice.length(-60.0, 60.0));
        }
    }
    (end[a], end[b]) = (thousandths(end[a]), thousandths(end[b]));
    if dice.one_in(3) {
        end[c] = thousandths(start[c] + dice.length(-20.0, 20.0));
    }
    let spiral_code = if form == Form::Pitches { dice.one_in(2) } else { dice.one_in(20) };
    let ccw = dice.one_in(2);
    let mut words = vec![match (spiral_code, ccw) {
        (false, false) => "G2".to_string(),
        (false, true) => "G3".to_string(),
        (true, false) => "G2.1".to_string(),
        (true, true) => "G3.1".to_string(),
    }];
    for axis in 0..3 {
        if end[axis] != start[axis] || dice.one_in(3) {
            words.push(format!("{}{:.3}", ["X", "Y", "Z"][axis], end[axis]));
        }
    }
    let mut center = center;
    let by_radius = dice.one_in(12);
    if by_radius {
        let value = dice.pick(&[0.0, radius, -radius]);
        words.push(format!("R{value:.3}"));
    }
    for (index, axis) in [a, b].into_iter().enumerate() {
        let left_out = if arm[index] == 0.0 { dice.one_in(2) } else { dice.one_in(25) };
        let value = if dice.one_in(30) { 0.0 } else { arm[index] };
        if left_out || by_radius && dice.one_in(2) {
            // A centre word left out is zero.
            center[index] = start[axis];
        } else {
            center[index] = start[axis] + value;
            words.push(format!("{}{value:.3}", ["I", "J", "K"][axis]));
        }
    }
    let mut optional = |letter: &str, values: &[f64]| {
        if dice.one_in(2) {
            return None;
        }
        let value = dice.pick(values);
        words.push(if letter == "P" || letter == "L" {
            format!("{letter}{value}")
        } else {
            format!("{letter}{value:.3}")
        });
        Some(value)
    };
    let counts = [0.0, 1.0, 2.0, 3.0];
    let p = optional("P", &counts);
    let q = optional("Q", &[0.0, 0.0, 2.0, -2.0, 5.0]);
    let l = optional("L", &counts);
    let height = optional(["I", "J", "K"][c], &[0.0, 0.0, 2.0, -1.0]);
    if dice.one_in(10) {
        words.push("A10.".into());
    }
    let text = words.join(" ");
    Asked { text, spiral_code, ccw, start, end, center, axes, p, q, l, height, by_radius }
}

/// What a block of the machine did: its moves, and the diagnostics of its line.
type Done = (Vec<(Move, Option<ArcShape>, Option<Feed>)>, Vec<(Severity, &'static str)>);

fn run(machine: &str, asked: &Asked) -> Done {
    let plane = ["G17", "G18", "G19"][asked.axes[2].abs_diff(2)];
    let [x, y, z] = asked.start;
    let text = format!(
        "G21 G90 G94 S1000 M3\nG0 X{x:.3} Y{y:.3} Z{z:.3}\nG1 F100.\n{plane}\n{}\nM30\n",
        asked.text
    );
    let mut sources = SourceMap::new();
    sources.add(Source::new("arc.nc", text.as_bytes()));
    let job = Job::new(sources, Machine::from_builtin(machine).unwrap()).unwrap();
    let mut moves = Vec::new();
    let report = job.report_of_commands(|command| {
        if command.origin.line == 5
            && let Some(motion) = command.kind.motion()
        {
            moves.push((*motion, command.kind.shape().copied(), command.kind.feed().copied()));
        }
    });
    let said = report.diagnostics.iter().filter(|d| {
        let source = job.sources().get(d.primary.span.file).unwrap();
        source.line_of(d.primary.span.range.start) == 5
    });
    (moves, said.map(|d| (d.severity, d.code.id())).collect())
}

impl Asked {
    /// Directed angle from start to end about the centre, in [0, 2π), and the radii.
    fn polar(&self) -> (f64, f64, f64) {
        let [a, b, _] = self.axes;
        let from = [self.start[a] - self.center[0], self.start[b] - self.center[1]];
        let to = [self.end[a] - self.center[0], self.end[b] - self.center[1]];
        let sense = if self.ccw { 1.0 } else { -1.0 };
        let turned = (to[1].atan2(to[0]) - from[1].atan2(from[0])) * sense;
        (turned.rem_euclid(TAU), from[0].hypot(from[1]), to[0].hypot(to[1]))
    }

    fn is_closed(&self) -> bool {
        let [a, b, _] = self.axes;
        self.start[a] == self.end[a] && self.start[b] == self.end[b]
    }

    /// The whole angle by the manuals' rules.
    fn angle(&self, form: Form) -> f64 {
        let (turned, r0, r1) = self.polar();
        // Rounded coordinates: on the ray of the start, or a little before it.
        let on_ray = turned.min(TAU - turned) * r0.min(r1) <= 1.5e-3;
        let before_ray = on_ray && turned > TAU / 2.0;
        let within = if before_ray { turned - TAU } else { turned };
        // An end a little before the ray is nearly a turn away, unless whole turns are counted.
        let with_turns = |turns: f64| TAU * turns + if turns > 0.0 { within } else { turned };
        let count = |word: Option<f64>| word.unwrap_or(0.0);
        let arc = if self.is_closed() { TAU } else { turned };
        // The angle between the ends of a full circle is zero: P are all its turns (Mitsubishi M700V 6.6 (3)).
        let beside_angle = |turns: f64| match self.is_closed() {
            true => TAU * turns.max(1.0),
            false => turned + TAU * turns,
        };
        let by_increment = |change: f64, each: f64| {
            let least = if self.is_closed() { 1.0 } else { 0.0 };
            let whole = (change.abs() / each.abs() - within / TAU).round().max(least);
            within + TAU * whole
        };
        let rise = self.end[self.axes[2]] - self.start[self.axes[2]];
        let words = count(self.q) != 0.0 || self.l.is_some() || count(self.height) != 0.0;
        // Words of zero, or of one turn, leave a full circle what it is without them.
        let circle = self.is_closed()
            && count(self.q) == 0.0
            && count(self.height) == 0.0
            && count(self.l) <= 1.0;
        match form {
            Form::Plain => arc,
            Form::AllTurns => arc + TAU * (count(self.p) - 1.0).max(0.0),
            Form::Pitches if self.spiral_code => with_turns(count(self.p)),
            Form::Pitches => beside_angle(count(self.p)),
            Form::IncrementHeightCount | Form::IncrementCount => {
                let begun = count(self.l).max(1.0) - 1.0;
                let full = self.is_closed() || on_ray && form == Form::IncrementCount;
                if count(self.q) != 0.0 && !self.is_closed() {
                    by_increment(r1 - r0, self.q.unwrap())
                } else if form == Form::IncrementHeightCount && count(self.height) != 0.0 {
                    by_increment(rise, self.height.unwrap())
                } else if words && !circle {
                    with_turns(begun + f64::from(u8::from(full)))
                } else if form == Form::IncrementHeightCount {
                    beside_angle(count(self.p))
                } else {
                    arc
                }
            }
        }
    }

    /// Lengths by Simpson's rule: along the path, and in the plane.
    fn lengths(&self, angle: f64) -> (f64, f64) {
        let (_, r0, r1) = self.polar();
        let rise = self.end[self.axes[2]] - self.start[self.axes[2]];
        let speed = |part: f64, rise: f64| {
            let radius = r0 + (r1 - r0) * part;
            ((radius * angle).powi(2) + (r1 - r0).powi(2) + rise.powi(2)).sqrt()
        };
        let simpson = |rise: f64| {
            let steps = 2000;
            let at = |index: usize| speed(index as f64 / steps as f64, rise);
            let inner: f64 =
                (1..steps).map(|index| at(index) * if index % 2 == 1 { 4.0 } else { 2.0 }).sum();
            (at(0) + inner + at(steps)) / (3 * steps) as f64
        };
        (simpson(rise), simpson(0.0))
    }
}

/// Says what is wrong with what the control made of a block.
fn wrong(form: Form, asked: &Asked, done: &Done) -> Option<String> {
    let (moves, said) = done;
    let goes = |motion: &Move, shape: &Option<ArcShape>| {
        curve_of(motion, shape.as_ref()).length() > 1e-9 || motion.from != motion.to
    };
    if !moves.iter().any(|(motion, shape, _)| goes(motion, shape)) {
        // G2 alone is active for the blocks after it.
        let asks = asked.text.contains(['X', 'Y', 'Z', 'A', 'I', 'J', 'K']);
        return (said.is_empty() && asks).then(|| "moves nothing and says nothing".into());
    }
    // F is a length per minute on every arc, whatever was said.
    for (motion, shape, feed) in moves {
        let (Some(shape), Some(feed)) = (shape, feed) else { continue };
        let curve = curve_of(motion, Some(shape));
        if (feed.value * 60.0 - 100.0).abs() > 1e-9 {
            return Some(format!("runs at {} mm/min", feed.value * 60.0));
        }
        if duration_s(feed, motion, &curve) <= 0.0 {
            return Some("takes no time".into());
        }
    }
    let quiet = said.iter().all(|(severity, _)| *severity == Severity::Note);
    let [(motion, Some(shape), Some(feed))] = &moves[..] else {
        let straight = moves.iter().any(|(_, shape, _)| shape.is_none());
        return (straight && quiet).then(|| "is straight without a word".into());
    };
    if !quiet || asked.by_radius {
        return None;
    }
    let angle = asked.angle(form);
    if (shape.sweep.abs() - angle).abs() > 1e-3 || (shape.sweep > 0.0) != asked.ccw {
        let (is, due) = (shape.sweep.to_degrees(), angle.to_degrees());
        return Some(format!("turns by {is}, not by {due}"));
    }
    let (along, flat) = asked.lengths(shape.sweep.abs());
    let length = if feed.along == FeedAlong::Path { along } else { flat };
    let curve = curve_of(motion, Some(shape));
    let time = duration_s(feed, motion, &curve);
    // Ends are off the circle by half a thousandth, which a mismatch leaves to the last turn.
    if (time - length * 60.0 / 100.0).abs() > 1e-3 * (1.0 + time) {
        return Some(format!("takes {time} s, not {} s", length * 0.6));
    }
    None
}

#[test]
fn something_moves_or_something_is_said() {
    let rounds = std::env::var("CHORDAL_ROUNDS").ok().and_then(|text| text.parse().ok());
    let rounds: usize = rounds.unwrap_or(3_000);
    for (machine, form) in MACHINES {
        let mut dice = Dice(0x9e37_79b9_7f4a_7c15 ^ machine.len() as u64);
        let (mut clean, mut failed) = (0, Vec::new());
        for _ in 0..rounds {
            let mut asked = asked(&mut dice, form);
            if machine == "fadal-4020" {
                // R is a register there, and L a repeat of the line.
                asked.text = asked.text.replace(" R", " R0+").replace("+-", "-");
            }
            let done = run(machine, &asked);
            clean += usize::from(done.1.is_empty());
            if let Some(text) = wrong(form, &asked, &done) {
                failed.push(format!("{} from {:?}: {text}", asked.text, asked.start));
            }
        }
        println!("{machine}: {rounds} blocks, {clean} of them without a word");
        assert!(clean * 50 > rounds, "{machine}: hardly a block is clean");
        let count = failed.len();
        failed.truncate(12);
        assert!(failed.is_empty(), "{machine}: {count} of {rounds}\n{}", failed.join("\n"));
    }
}

/// A spiral from its centre or to it: what is said of the one end and what to do about it, the right way round.
#[test]
fn a_spiral_that_begins_or_ends_on_its_centre_says_which() {
    let head = "G21 G90 G94 G17\nS900 M3\nG0 X10. Y0. Z2.\nG1 Z-1. F90.\n";
    // From the centre, and to it.
    let cases = [
        ("mitsubishi-m700-type2", "G03 X30. Y0. I0. J0. L3", "start", "end", "begin it"),
        ("mitsubishi-m700-type2", "G02 X10. Y8. I0. J0. L2 K-1. Z-3.", "start", "end", "begin it"),
        ("fanuc-30i", "G02 X30. Y0. I0. J0. L3", "start", "end", "begin it"),
        ("mitsubishi-m700-type2", "G03 X30. Y0. I20. J0. L3", "end", "start", "end it"),
        ("fanuc-30i", "G03 X10. Y7. I0. J7. L1", "end", "start", "end it"),
        ("mitsubishi-m700", "G02.1 X0. Y0. I-10. P1", "end", "start", "end it"),
    ];
    for (machine, block, own, other, help) in cases {
        let text = format!("{head}{block}\nG0 Z9.\nM30\n");
        let mut sources = SourceMap::new();
        sources.add(Source::new("part.nc", text.as_bytes().to_vec()));
        let job = Job::new(sources, Machine::from_builtin(machine).unwrap()).unwrap();
        let found = job.check().diagnostics;
        let problem = found.iter().find(|one| one.code.id() == "CH412");
        let problem = problem.unwrap_or_else(|| panic!("{machine} {block}: {found:?}"));
        assert_eq!(problem.message, format!("the {own} of this spiral is its centre"), "{block}");
        assert!(problem.primary.text.ends_with(&format!("that of the {other}")), "{block}");
        let said = problem.help.clone().unwrap();
        assert!(said.contains(&format!("{help} a little away")), "{block}: {said}");
    }
}
