//! Random approaches and departures (APPR, DEP): the path of the tool's centre, part by part, against geometry that is
//! calculated here on its own: the point of the contour offset by the radius, PH, the centre of the arc, the point in
//! which line and arc are tangent, lengths, and the feed of each part.

use std::f64::consts::{PI, TAU};
use std::fmt::Write;

use chordal::control::{Command, Origin};
use chordal::path::PathCommand;
use chordal::{Diagnostic, Job, Machine, PathSink, Severity, Source, SourceMap};

const CASES: u64 = 20_000;
const CASES_IN_PROGRAM: u64 = 50;

/// Coordinates are written with six decimals, and angles magnify their rounding, mm.
const TOLERANCE_MM: f64 = 1e-4;

/// A sequence of numbers from 0 to 1.
struct ApproachNumbers(u64);

impl ApproachNumbers {
    fn next(&mut self) -> f64 {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        // As it is written: what the program says is what is expected of it.
        ((low + (high - low) * self.next()) * 1e3).round() / 1e3
    }

    fn below(&mut self, count: u32) -> u32 {
        (self.next() * f64::from(count)) as u32
    }

    fn is_one_of(&mut self, count: u32) -> bool {
        self.below(count) == 0
    }

    fn sign(&mut self) -> f64 {
        if self.is_one_of(2) { 1.0 } else { -1.0 }
    }
}

/// A point or a direction of the plane as a complex number.
#[derive(Clone, Copy, PartialEq, Debug)]
struct Complex(f64, f64);

impl Complex {
    fn of_angle(radians: f64) -> Complex {
        Complex(radians.cos(), radians.sin())
    }

    fn plus(self, other: Complex) -> Complex {
        Complex(self.0 + other.0, self.1 + other.1)
    }

    fn minus(self, other: Complex) -> Complex {
        Complex(self.0 - other.0, self.1 - other.1)
    }

    fn times(self, other: Complex) -> Complex {
        Complex(self.0 * other.0 - self.1 * other.1, self.0 * other.1 + self.1 * other.0)
    }

    fn scaled(self, factor: f64) -> Complex {
        Complex(self.0 * factor, self.1 * factor)
    }

    fn size(self) -> f64 {
        self.0.hypot(self.1)
    }

    fn angle(self) -> f64 {
        self.1.atan2(self.0)
    }

    /// This point turned about another one.
    fn about(self, center: Complex, radians: f64) -> Complex {
        center.plus(self.minus(center).times(Complex::of_angle(radians)))
    }
}

/// A move that is expected of the tool's centre.
#[derive(Clone, Debug)]
struct ExpectedMove {
    end: Complex,
    level: f64,
    /// The centre of an arc and its angle, rad.
    arc: Option<(Complex, f64)>,
    feed: f64,
}

/// A case: its lines, and what they move after the tool is at the start.
#[derive(Default, Debug)]
struct ApproachCase {
    text: String,
    lines: u32,
    /// The first line whose moves count.
    first: u32,
    start: (f64, f64, f64),
    expected: Vec<ExpectedMove>,
    axis: usize,
    /// The first axis of the plane is mirrored (cycle 8), and with it the side of the tool and every arc.
    is_mirrored: bool,
}

/// The letters of the axes of the plane and of the tool, by the tool axis X, Y, Z.
const LETTERS: [[char; 3]; 3] = [['Y', 'Z', 'X'], ['Z', 'X', 'Y'], ['X', 'Y', 'Z']];

/// Their places among X, Y and Z.
const PLACES: [[usize; 3]; 3] = [[1, 2, 0], [2, 0, 1], [0, 1, 2]];

/// The geometry of an arc that touches the contour.
#[derive(Clone, Copy)]
struct TouchingArc {
    center: Complex,
    /// 1 counter-clockwise.
    sign: f64,
    radius: f64,
}

/// The contour and what its tool is.
struct CaseMaker {
    numbers: ApproachNumbers,
    case: ApproachCase,
    /// 1 for RL.
    side: f64,
    tool_radius: f64,
    /// The feed that was programmed last.
    feed: f64,
    level: f64,
}

impl CaseMaker {
    fn line(&mut self, text: &str) {
        self.case.text.push_str(text);
        self.case.text.push('\n');
        self.case.lines += 1;
    }

    fn letters(&self) -> [char; 3] {
        LETTERS[self.case.axis]
    }

    fn point_words(&self, point: Complex) -> String {
        let [a, b, _] = self.letters();
        format!("{a}{:+.6} {b}{:+.6}", point.0, point.1)
    }

    fn expect(&mut self, end: Complex, arc: Option<(Complex, f64)>, feed: f64) {
        let level = self.level;
        self.case.expected.push(ExpectedMove { end, level, arc, feed });
    }

    /// F of a block, or none: then the last one goes on.
    fn feed_word(&mut self) -> (String, f64) {
        if self.numbers.is_one_of(3) {
            return (String::new(), self.feed);
        }
        let feed = f64::from(100 + self.numbers.below(2_000));
        (format!(" F{feed}"), feed)
    }

    /// From the contour to the side of the tool.
    fn normal(&self, tangent: Complex) -> Complex {
        tangent.times(Complex(0.0, self.side))
    }

    fn touching(&self, contact: Complex, tangent: Complex, signed_radius: f64) -> TouchingArc {
        let center = contact.plus(self.normal(tangent).scaled(signed_radius));
        let sign = self.side * signed_radius.signum();
        TouchingArc { center, sign, radius: signed_radius.abs() }
    }

    fn begin(&mut self) {
        let radius = self.numbers.between(0.5, 12.0);
        let (longer, larger) = match self.numbers.is_one_of(2) {
            true => (self.numbers.between(-0.5, 0.5), self.numbers.between(-0.4, 0.8)),
            false => (0.0, 0.0),
        };
        self.tool_radius = radius + larger;
        self.case.axis = self.numbers.below(3) as usize;
        self.side = self.numbers.sign();
        let [a, b, n] = self.letters();
        self.line(&format!("TOOL DEF 1 L+0 R{radius:+.3}"));
        self.line(&format!("TOOL CALL 1 {n} S1000 DL{longer:+.3} DR{larger:+.3}"));
        self.line(&format!("L {a}+500 {b}+500 R0 FMAX"));
        self.case.is_mirrored = self.numbers.is_one_of(4);
        if self.case.is_mirrored {
            self.line("CYCL DEF 8.0 MIRROR IMAGE");
            self.line(&format!("CYCL DEF 8.1 {a}"));
        }
    }

    fn side_word(&self) -> &'static str {
        if self.side > 0.0 { "RL" } else { "RR" }
    }

    /// The end of the tangent from a point outside to the arc, or from the arc to it; `None` where there is none.
    fn tangent_end(arc: &TouchingArc, outside: Complex, arrives: bool) -> Option<Complex> {
        let away = outside.minus(arc.center);
        if away.size() < arc.radius + 0.5 {
            return None;
        }
        let half = (arc.radius / away.size()).acos();
        [half, -half].into_iter().find_map(|turn| {
            let radial = Complex::of_angle(away.angle() + turn);
            let point = arc.center.plus(radial.scaled(arc.radius));
            let along = radial.times(Complex(0.0, arc.sign));
            let line = if arrives { point.minus(outside) } else { outside.minus(point) };
            let agreement = line.0 * along.0 + line.1 * along.1;
            (agreement > 0.0).then_some(point)
        })
    }

    /// The angle of an arc from one point to another in its direction, rad, signed.
    fn sweep(arc: &TouchingArc, from: Complex, to: Complex) -> f64 {
        let angle = to.minus(arc.center).angle() - from.minus(arc.center).angle();
        arc.sign * (arc.sign * angle).rem_euclid(TAU)
    }

    /// The words of a point, cartesian or polar about a pole.
    fn end_words(&mut self, point: Complex, pole: Option<Complex>) -> String {
        match pole {
            None => self.point_words(point),
            Some(pole) => {
                let away = point.minus(pole);
                format!("PR{:+.9} PA{:+.9}", away.size(), away.angle().to_degrees())
            }
        }
    }

    fn approach(&mut self, point: Complex, tangent: Complex) -> Option<()> {
        let contact = point.plus(self.normal(tangent).scaled(self.tool_radius));
        let start = contact.plus(
            Complex::of_angle(self.numbers.between(-PI, PI))
                .scaled(self.numbers.between(20.0, 80.0)),
        );
        let start = Complex((start.0 * 1e3).round() / 1e3, (start.1 * 1e3).round() / 1e3);
        let [a, b, n] = self.letters();
        let level = self.numbers.between(-5.0, 5.0);
        self.feed = f64::from(100 + self.numbers.below(2_000));
        self.line(&format!(
            "L {a}{:+.6} {b}{:+.6} {n}{level:+.3} F{}",
            start.0, start.1, self.feed
        ));
        self.level = level;
        self.case.start = (start.0, start.1, level);
        let pole = self
            .numbers
            .is_one_of(2)
            .then(|| Complex(self.numbers.between(-60.0, 60.0), self.numbers.between(-60.0, 60.0)));
        let mut first = self.case.lines + 1;
        if let Some(pole) = pole {
            let words = self.point_words(pole);
            self.line(&format!("CC {words}"));
            first += 1;
        }
        self.case.first = first;
        let prefix = if pole.is_some() { "P" } else { "" };
        let words = self.end_words(point, pole);
        let depth = self.numbers.is_one_of(3).then(|| self.numbers.between(-20.0, -6.0));
        let level_word = depth.map_or(String::new(), |depth| format!(" {n}{depth:+.3}"));
        let (feed_word, feed) = self.feed_word();
        let side = self.side_word();
        let before = self.feed;
        let block = |form: &str, data: String| {
            format!("APPR {prefix}{form} {words}{level_word} {data} {side}{feed_word}")
        };
        let to_helper = |own: &mut CaseMaker, helper: Complex, feed: f64| {
            own.expect(helper, None, feed);
            if let Some(depth) = depth {
                own.level = depth;
                own.expect(helper, None, feed);
            }
        };
        match self.numbers.below(4) {
            0 => {
                let length = self.numbers.between(1.0, 20.0);
                self.line(&block("LT", format!("LEN{length}")));
                to_helper(self, contact.minus(tangent.scaled(length)), before);
                self.expect(contact, None, feed);
            }
            1 => {
                let length = self.numbers.between(1.0, 20.0);
                self.line(&block("LN", format!("LEN{length}")));
                let helper = contact.plus(self.normal(tangent).scaled(length));
                to_helper(self, helper, before);
                self.expect(contact, None, feed);
            }
            2 => {
                let radius = self.numbers.between(1.0, 20.0) * self.numbers.sign();
                let degrees = self.numbers.between(5.0, 350.0);
                self.line(&block("CT", format!("CCA{degrees} R{radius:+}")));
                let arc = self.touching(contact, tangent, radius);
                let sweep = arc.sign * degrees.to_radians();
                to_helper(self, contact.about(arc.center, -sweep), before);
                self.expect(contact, Some((arc.center, sweep)), feed);
            }
            _ => {
                let radius = self.numbers.between(1.0, 20.0);
                self.line(&block("LCT", format!("R{radius}")));
                let arc = self.touching(contact, tangent, radius);
                let helper = CaseMaker::tangent_end(&arc, start, true)?;
                let sweep = CaseMaker::sweep(&arc, helper, contact);
                (0.02..TAU - 0.02).contains(&sweep.abs()).then_some(())?;
                to_helper(self, helper, feed);
                self.expect(contact, Some((arc.center, sweep)), feed);
            }
        }
        self.feed = feed;
        Some(())
    }

    /// The elements of the contour from a point on; where and in which direction it ends.
    fn contour(&mut self, shape: u32, point: Complex, tangent: Complex) -> (Complex, Complex) {
        match shape {
            0 => self.straight(point, tangent),
            1 => self.arc(point, tangent, false),
            2 => {
                let (point, tangent) = self.straight(point, tangent);
                self.arc(point, tangent, true)
            }
            _ => {
                let (point, tangent) = self.arc(point, tangent, false);
                self.straight(point, tangent)
            }
        }
    }

    fn straight(&mut self, point: Complex, tangent: Complex) -> (Complex, Complex) {
        let end = point.plus(tangent.scaled(self.numbers.between(5.0, 50.0)));
        let words = self.point_words(end);
        let (feed_word, feed) = self.feed_word();
        self.line(&format!("L {words}{feed_word}"));
        self.feed = feed;
        self.expect(end.plus(self.normal(tangent).scaled(self.tool_radius)), None, feed);
        (end, tangent)
    }

    fn arc(&mut self, point: Complex, tangent: Complex, is_tangent: bool) -> (Complex, Complex) {
        let turn = self.numbers.sign();
        let radius = self.tool_radius + self.numbers.between(3.0, 40.0);
        let sweep = turn * self.numbers.between(0.4, 2.8);
        let center = point.plus(tangent.times(Complex(0.0, turn)).scaled(radius));
        let end = point.about(center, sweep);
        let direction = tangent.times(Complex::of_angle(sweep));
        let (feed_word, feed) = self.feed_word();
        let words = self.point_words(end);
        if is_tangent {
            self.line(&format!("CT {words}{feed_word}"));
        } else {
            let center_words = self.point_words(center);
            self.line(&format!("CC {center_words}"));
            let sign = if turn > 0.0 { '+' } else { '-' };
            self.line(&format!("C {words} DR{sign}{feed_word}"));
        }
        self.feed = feed;
        let offset = end.plus(self.normal(direction).scaled(self.tool_radius));
        self.expect(offset, Some((center, sweep)), feed);
        (end, direction)
    }

    fn departure(&mut self, point: Complex, tangent: Complex) -> Option<()> {
        let contact = point.plus(self.normal(tangent).scaled(self.tool_radius));
        let (feed_word, feed) = self.feed_word();
        match self.numbers.below(4) {
            0 => {
                let length = self.numbers.between(1.0, 20.0);
                self.line(&format!("DEP LT LEN{length}{feed_word}"));
                self.expect(contact.plus(tangent.scaled(length)), None, feed);
            }
            1 => {
                let length = self.numbers.between(1.0, 20.0);
                self.line(&format!("DEP LN LEN{length}{feed_word}"));
                self.expect(contact.plus(self.normal(tangent).scaled(length)), None, feed);
            }
            2 => {
                let radius = self.numbers.between(1.0, 20.0) * self.numbers.sign();
                let degrees = self.numbers.between(5.0, 350.0);
                self.line(&format!("DEP CT CCA{degrees} R{radius:+}{feed_word}"));
                let arc = self.touching(contact, tangent, radius);
                let sweep = arc.sign * degrees.to_radians();
                self.expect(contact.about(arc.center, sweep), Some((arc.center, sweep)), feed);
            }
            _ => {
                let radius = self.numbers.between(1.0, 20.0);
                let angle = self.numbers.between(-PI, PI);
                let away = Complex::of_angle(angle).scaled(self.numbers.between(20.0, 80.0));
                let outside = contact.plus(away);
                let pole = self.numbers.is_one_of(2).then(|| {
                    Complex(self.numbers.between(-60.0, 60.0), self.numbers.between(-60.0, 60.0))
                });
                if let Some(pole) = pole {
                    let words = self.point_words(pole);
                    self.line(&format!("CC {words}"));
                }
                let prefix = if pole.is_some() { "P" } else { "" };
                let words = self.end_words(outside, pole);
                self.line(&format!("DEP {prefix}LCT {words} R{radius}{feed_word}"));
                let arc = self.touching(contact, tangent, radius);
                let helper = CaseMaker::tangent_end(&arc, outside, false)?;
                let sweep = CaseMaker::sweep(&arc, contact, helper);
                (0.02..TAU - 0.02).contains(&sweep.abs()).then_some(())?;
                self.expect(helper, Some((arc.center, sweep)), feed);
                self.expect(outside, None, feed);
            }
        }
        Some(())
    }

    /// After the departure there is no compensation, and the feed is that before it.
    fn last_line(&mut self) {
        let end = Complex(self.numbers.between(90.0, 120.0), self.numbers.between(90.0, 120.0));
        let words = self.point_words(end);
        self.line(&format!("L {words}"));
        self.expect(end, None, self.feed);
        if self.case.is_mirrored {
            self.line("CYCL DEF 8.0 MIRROR IMAGE");
            self.line("CYCL DEF 8.1");
        }
    }
}

/// A case from its number; numbers whose approach has no tangent are counted on.
fn case_of(seed: u64) -> ApproachCase {
    for attempt in 0..1_000 {
        let numbers =
            ApproachNumbers((seed * 1_000 + attempt).wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1);
        let mut maker = CaseMaker {
            numbers,
            case: ApproachCase::default(),
            side: 1.0,
            tool_radius: 0.0,
            feed: 0.0,
            level: 0.0,
        };
        maker.begin();
        let point = Complex(maker.numbers.between(-50.0, 50.0), maker.numbers.between(-50.0, 50.0));
        let tangent = Complex::of_angle(maker.numbers.between(-PI, PI));
        let shape = maker.numbers.below(4);
        if maker.approach(point, tangent).is_none() {
            continue;
        }
        let (end, direction) = maker.contour(shape, point, tangent);
        if maker.departure(end, direction).is_none() {
            continue;
        }
        maker.last_line();
        return maker.case;
    }
    panic!("no case {seed}");
}

/// The moves of the tool's centre with their lines.
#[derive(Default)]
struct ApproachPathRecord(Vec<Command>);

impl PathSink for ApproachPathRecord {
    fn command(&mut self, path: PathCommand<'_>) {
        if path.command.kind.motion().is_some() {
            self.0.push(path.command.clone());
        }
    }

    fn diagnostic(&mut self, found: Diagnostic, _: &Origin) {
        assert!(found.severity != Severity::Error, "{found:?}");
    }
}

fn moves_of(text: &str) -> Vec<Command> {
    let mut machine = Machine::from_builtin("heidenhain-mill").expect("a built-in machine");
    machine.axes.iter_mut().flatten().for_each(|axis| axis.travel = Some((-10_000.0, 10_000.0)));
    machine.work_offsets.entry("G54".to_string()).or_default().values = [Some(0.0); 6];
    let mut sources = SourceMap::new();
    sources.add(Source::new("a.h", text.as_bytes().to_vec()));
    let job = Job::new(sources, machine).expect("a job");
    let mut record = ApproachPathRecord::default();
    job.compensated(None, &mut record);
    record.0
}

/// Compares a move with what is expected of it; the largest difference, mm.
fn fault_of(found: &Command, expected: &ExpectedMove, case: &ApproachCase) -> Result<f64, String> {
    let motion = found.kind.motion().expect("a move");
    let [a, b, n] = PLACES[case.axis];
    let sign = if case.is_mirrored { -1.0 } else { 1.0 };
    let off = Complex(sign * motion.to[a], motion.to[b]).minus(expected.end).size();
    let mut fault = off.max((motion.to[n] - expected.level).abs());
    let feed = found.kind.feed().map_or(0.0, |feed| feed.value * 60.0);
    if (feed - expected.feed).abs() > 1e-6 {
        return Err(format!("the feed is {feed}"));
    }
    match (found.kind.shape(), expected.arc) {
        (None, None) => {}
        (Some(shape), Some((center, sweep))) => {
            fault =
                fault.max(Complex(sign * shape.center[0], shape.center[1]).minus(center).size());
            fault = fault.max((sign * shape.sweep - sweep).abs() * shape.radius_from);
        }
        _ => return Err("one is an arc".into()),
    }
    Ok(fault)
}

#[test]
fn random_approaches_and_departures() {
    let (mut moves, mut farthest) = (0, 0.0_f64);
    for program in 0..CASES / CASES_IN_PROGRAM {
        let cases: Vec<ApproachCase> =
            (0..CASES_IN_PROGRAM).map(|own| case_of(program * CASES_IN_PROGRAM + own)).collect();
        let mut text = String::from("BEGIN PGM A MM\n");
        cases.iter().for_each(|case| text += &case.text);
        writeln!(text, "M30\nEND PGM A MM").expect("a text");
        let found = moves_of(&text);
        let mut line = 1;
        for case in &cases {
            let own = found.iter().filter(|command| {
                let motion = command.kind.motion().expect("a move");
                let is_own = (line + case.first..=line + case.lines).contains(&command.origin.line);
                let length: f64 =
                    (0..3).map(|axis| (motion.to[axis] - motion.from[axis]).powi(2)).sum();
                is_own && (length > 1e-12 || command.kind.shape().is_some())
            });
            let own: Vec<&Command> = own.collect();
            let shown = || format!("{}\n{:#?}", case.text, case.expected);
            assert_eq!(own.len(), case.expected.len(), "{}\n{own:#?}", shown());
            for (found, expected) in own.iter().zip(&case.expected) {
                let fault = fault_of(found, expected, case).unwrap_or_else(|what| {
                    panic!("{what}: {found:#?}\n{expected:#?}\n{}", shown())
                });
                assert!(fault < TOLERANCE_MM, "{fault}: {found:#?}\n{expected:#?}\n{}", shown());
                farthest = farthest.max(fault);
            }
            moves += own.len();
            line += case.lines;
        }
    }
    println!("{CASES} cases, {moves} moves, {farthest:.1e} mm off at most");
}
