//! Contour (SL) cycles of HEIDENHAIN controls: the distance of the tool from walls that are written here by hand, levels,
//! feeds, directions and ends.

#![allow(dead_code, reason = "the runner of all cycles is shared")]

#[path = "heidenhain_cycles/shop.rs"]
mod shop;

use chordal::control::{Command, CommandKind};
use chordal::{Diagnostic, Job, Machine, RunSink, Severity, Sink, Source, SourceMap};
use shop::{DataSequence, SeenMove, infeeds};

/// Where the tool is when a cycle is called.
const START: [f64; 3] = [-40.0, -30.0, 90.0];

#[derive(Default)]
struct ContourCycleRecord {
    seen: Vec<SeenMove>,
    found: Vec<Diagnostic>,
    others: usize,
}

impl Sink for ContourCycleRecord {
    fn command(&mut self, command: &Command) {
        let Some(motion) = command.kind.motion() else { return };
        if !command.origin.cycle {
            self.others += 1;
            return;
        }
        let to = [motion.to[0], motion.to[1], motion.to[2]];
        let is_still = (0..3).all(|axis| (motion.to[axis] - motion.from[axis]).abs() < 1e-9);
        let feed = command.kind.feed().map_or(0.0, |feed| feed.value * 60.0);
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
        self.found.push(diagnostic);
    }
}

impl RunSink for ContourCycleRecord {}

fn run(cycles: &str, subprograms: &str, tool: f64) -> ContourCycleRecord {
    let [x, y, z] = START;
    let text = format!(
        "BEGIN PGM T MM\nTOOL DEF 1 L+0 R+{tool}\nTOOL CALL 1 Z S1000\nL Z+{z} R0 FMAX M3\nL X{x:+} Y{y:+} FMAX\n\
         {cycles}\nCYCL CALL\nM30\n{subprograms}\nEND PGM T MM\n"
    );
    let mut machine = Machine::from_builtin("heidenhain-mill").expect("a built-in machine");
    machine.axes.iter_mut().flatten().for_each(|axis| axis.travel = Some((-10_000.0, 10_000.0)));
    let offset = machine.work_offsets.entry("G54".to_string()).or_default();
    offset.values = [Some(0.0); 6];
    let mut sources = SourceMap::new();
    sources.add(Source::new("T.H", text.into_bytes()));
    let mut record = ContourCycleRecord::default();
    Job::new(sources, machine).expect("a job").run(&mut record);
    record
}

fn errors(record: &ContourCycleRecord) -> Vec<String> {
    let errors = record.found.iter().filter(|own| own.severity == Severity::Error);
    errors.map(|own| format!("{} {}", own.code.id(), own.message)).collect()
}

/// Points of all cuts in the plane with their level and feed.
fn cuts(seen: &[SeenMove]) -> Vec<([f64; 3], f64)> {
    let mut at = START;
    let mut found = Vec::new();
    for step in seen {
        let Some(to) = step.to() else { continue };
        match *step {
            SeenMove::Cut(_, feed) if (to[0] - at[0]).hypot(to[1] - at[1]) > 1e-9 => {
                for part in 0..=40 {
                    let t = f64::from(part) / 40.0;
                    found.push(([0, 1, 2].map(|k| at[k] + (to[k] - at[k]) * t), feed));
                }
            }
            SeenMove::Round(_, center, sweep, feed) => {
                let radius = (at[0] - center[0]).hypot(at[1] - center[1]);
                let from = (at[1] - center[1]).atan2(at[0] - center[0]);
                for part in 0..=60 {
                    let angle = from + sweep * f64::from(part) / 60.0;
                    let (x, y) =
                        (center[0] + radius * angle.cos(), center[1] + radius * angle.sin());
                    found.push(([x, y, to[2]], feed));
                }
            }
            _ => {}
        }
        at = to;
    }
    found
}

fn levels(seen: &[SeenMove]) -> Vec<f64> {
    let mut found: Vec<f64> = Vec::new();
    for (point, _) in cuts(seen) {
        if !found.iter().any(|level| (level - point[2]).abs() < 1e-7) {
            found.push(point[2]);
        }
    }
    found.sort_by(|a, b| b.total_cmp(a));
    found
}

fn same(found: &[f64], expected: &[f64]) -> bool {
    found.len() == expected.len() && found.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-6)
}

/// A rectangle from (0, 0) to (100, 60) with corners of 8 mm and a chamfer, a round island, and a square one that is
/// turned; the sides of the program say what is what.
const POCKET: &str = "LBL 1\nL X+50 Y+0 RL\nL X+100\nRND R8\nL Y+60\nCHF 10\nL X+0\nRND R8\nL Y+0\nRND R8\nL X+50\nLBL 0\n\
    LBL 2\nCC X+30 Y+30\nL X+40 Y+30 RR\nC X+40 Y+30 DR+\nLBL 0\n\
    LBL 3\nQ50 = 12\nL X+70 Y+18 RL\nL IX-Q50 IY+Q50\nL IX+12 IY+12\nL IX+12 IY-12\nL IX-12 IY-12\nLBL 0";

/// The distance from the walls of that pocket: negative in the material.
fn room(p: [f64; 2]) -> f64 {
    let [x, y] = p;
    // The rounded rectangle.
    let q = [(x - 50.0).abs() - 50.0 + 8.0, (y - 30.0).abs() - 30.0 + 8.0];
    let rounded = 8.0 - q[0].max(0.0).hypot(q[1].max(0.0)) - q[0].max(q[1]).min(0.0);
    // The corner at (100, 60) is cut by a line through (90, 60) and (100, 50) instead.
    let sharp = x.min(100.0 - x).min(y).min(60.0 - y);
    let is_there = x > 80.0 && y > 40.0;
    let wall = if is_there { sharp } else { rounded };
    let chamfer = (150.0 - x - y) / 2.0_f64.sqrt();
    let disc = (x - 30.0).hypot(y - 30.0) - 10.0;
    // The square with corners (70, 18), (58, 30), (70, 42), (82, 30).
    let (u, v) =
        (((x - 70.0) + (y - 30.0)) / 2.0_f64.sqrt(), ((y - 30.0) - (x - 70.0)) / 2.0_f64.sqrt());
    let half = 12.0 / 2.0_f64.sqrt();
    let q = [u.abs() - half, v.abs() - half];
    let square = q[0].max(0.0).hypot(q[1].max(0.0)) + q[0].max(q[1]).min(0.0);
    wall.min(chamfer).min(disc).min(square)
}

struct Values {
    depth: f64,
    side: f64,
    floor: f64,
    surface: f64,
    clearance: f64,
    top: f64,
    infeed: f64,
    tool: f64,
    overlap: f64,
    left: f64,
    turn: f64,
}

impl Values {
    fn random(random: &mut DataSequence) -> Values {
        let mut of = |values: &[f64]| values[random.below(values.len())];
        Values {
            depth: of(&[5.0, 12.5, 20.0]),
            side: of(&[0.0, 0.3, 0.8]),
            floor: of(&[0.0, 0.2, 0.5]),
            surface: of(&[0.0, 10.0, -3.5]),
            clearance: of(&[1.0, 2.0, 3.5]),
            top: of(&[30.0, 50.0, 75.5]),
            infeed: of(&[2.0, 5.0, 30.0]),
            tool: of(&[2.0, 3.0, 4.0]),
            overlap: of(&[0.5, 1.0, 1.4]),
            left: of(&[0.0, 0.1, 0.6]),
            turn: of(&[1.0, -1.0, 1.0]),
        }
    }

    fn cycle_20(&self) -> String {
        format!(
            "CYCL DEF 14.0 CONTOUR\nCYCL DEF 14.1 CONTOUR LABEL1 /2 /3\nCYCL DEF 20 CONTOUR DATA ~\n  Q1=-{} ~\n  Q2={} ~\n  \
             Q3={} ~\n  Q4={} ~\n  Q5={} ~\n  Q6={} ~\n  Q7={} ~\n  Q8=0.5 ~\n  Q9={}\n",
            self.depth,
            self.overlap,
            self.side,
            self.floor,
            self.surface,
            self.clearance,
            self.top,
            self.turn
        )
    }
}

fn check_heights(record: &ContourCycleRecord, values: &Values, expected: &[f64]) {
    let found = levels(&record.seen);
    assert!(same(&found, expected), "{found:?} {expected:?}");
    let ends: Vec<[f64; 3]> = record.seen.iter().filter_map(SeenMove::to).collect();
    assert_eq!(ends.first().map(|to| to[2]), Some(values.top));
    assert_eq!(ends.last().map(|to| to[2]), Some(values.top));
    // Rapids in the plane are made at the clearance or above it, and none goes into the material.
    let mut at = START;
    for step in &record.seen {
        let Some(to) = step.to() else { continue };
        if matches!(step, SeenMove::Rapid(_)) {
            let least = values.surface + values.clearance - 1e-9;
            assert!(to[2] >= least, "a rapid to {to:?}");
            let is_flat = (to[0] - at[0]).hypot(to[1] - at[1]) < 1e-9;
            assert!(is_flat || at[2] >= least, "a rapid from {at:?} to {to:?}");
        }
        at = to;
    }
    // The contours themselves are not carried out.
    assert_eq!(record.others, 2);
}

#[test]
fn rough_out_and_floor_stay_inside_and_clear_all() {
    let mut random = DataSequence(11);
    for round in 0..60 {
        let values = Values::random(&mut random);
        let number = if round % 3 == 0 { 23 } else { 22 };
        let own = match number {
            22 => format!(
                "CYCL DEF 22 ROUGH-OUT Q10={} Q11=111 Q12=555 Q18=0 Q19=99 Q208=MAX",
                values.infeed
            ),
            _ => "CYCL DEF 23 FLOOR FINISHING Q11=111 Q12=555 Q208=0".to_string(),
        };
        let record = run(&format!("{}{own}", values.cycle_20()), POCKET, values.tool);
        assert!(errors(&record).is_empty(), "{:?}", errors(&record));
        let bottom = if number == 22 { values.depth - values.floor } else { values.depth };
        let expected = match number {
            22 => infeeds(values.surface, bottom, values.infeed),
            _ => vec![values.surface - bottom],
        };
        check_heights(&record, &values, &expected);
        let keep = values.tool + values.side;
        let points = cuts(&record.seen);
        let least = points.iter().map(|(p, _)| room([p[0], p[1]])).fold(f64::INFINITY, f64::min);
        assert!((least - keep).abs() < 1e-6, "{least} is not {keep}");
        assert!(points.iter().all(|(_, feed)| (feed - 555.0).abs() < 1e-6));
        // On each level no point that the tool can reach is left.
        let last = expected[expected.len() - 1];
        let path: Vec<[f64; 2]> = points
            .iter()
            .filter(|(p, _)| (p[2] - last).abs() < 1e-7)
            .map(|(p, _)| [p[0], p[1]])
            .collect();
        for i in 0..50 {
            for j in 0..30 {
                let p = [2.0 * f64::from(i), 2.0 * f64::from(j)];
                if room(p) < keep {
                    continue;
                }
                let near = path.iter().map(|q| (q[0] - p[0]).hypot(q[1] - p[1]));
                let near = near.fold(f64::INFINITY, f64::min);
                assert!(near < values.tool + 0.7, "{p:?} is left by {near}");
            }
        }
    }
}

#[test]
fn side_finishing_touches_every_wall() {
    let mut random = DataSequence(23);
    for _ in 0..60 {
        let values = Values::random(&mut random);
        let own = format!(
            "CYCL DEF 24 SIDE FINISHING ~\n  Q9={} ~\n  Q10=-{} ~\n  Q11=111 ~\n  Q12=444 ~\n  Q14={}",
            values.turn, values.infeed, values.left
        );
        let record = run(&format!("{}{own}", values.cycle_20()), POCKET, values.tool);
        assert!(errors(&record).is_empty(), "{:?}", errors(&record));
        check_heights(&record, &values, &infeeds(values.surface, values.depth, values.infeed));
        let keep = values.tool + values.left;
        let points = cuts(&record.seen);
        let least = points.iter().map(|(p, _)| room([p[0], p[1]])).fold(f64::INFINITY, f64::min);
        assert!((least - keep).abs() < 1e-6, "{least} is not {keep}");
        // Every point of the walls is touched on the last level: points on the three walls, by hand.
        let last = values.surface - values.depth;
        let touches = |wall: [f64; 2]| {
            let on = points.iter().filter(|(p, _)| (p[2] - last).abs() < 1e-7);
            let near = on.map(|(p, _)| (p[0] - wall[0]).hypot(p[1] - wall[1]));
            let near = near.fold(f64::INFINITY, f64::min);
            assert!((near - keep).abs() < 0.4, "{wall:?}: {near} is not {keep}");
        };
        for t in 1..10 {
            touches([10.0 + 8.0 * f64::from(t), 0.0]);
            touches([0.0, 10.0 + 4.0 * f64::from(t)]);
            let (sin, cos) = (0.6 * f64::from(t)).sin_cos();
            touches([30.0 + 10.0 * cos, 30.0 + 10.0 * sin]);
            touches([70.0 - 1.2 * f64::from(t), 18.0 + 1.2 * f64::from(t)]);
        }
        // Climb milling leaves the walls on the right: counter-clockwise in the pocket, clockwise about the islands.
        let about_disc: f64 = record
            .seen
            .iter()
            .map(|step| match step {
                SeenMove::Round(_, c, sweep, _) if (c[0] - 30.0).hypot(c[1] - 30.0) < 1e-6 => {
                    *sweep
                }
                _ => 0.0,
            })
            .sum();
        assert!(about_disc * values.turn < 0.0, "{about_disc}");
    }
}

/// Two lines, an arc, and a line that go round a corner.
const TRAIN: &str =
    "LBL 5\nL X+0 Y+0 RL\nL X+40\nL X+60 Y+20\nCR X+80 Y+40 R+20 DR-\nL Y+70\nLBL 0";

/// The distance from that train.
fn from_train([x, y]: [f64; 2]) -> f64 {
    let line = |a: [f64; 2], b: [f64; 2]| {
        let d = [b[0] - a[0], b[1] - a[1]];
        let t = ((x - a[0]) * d[0] + (y - a[1]) * d[1]) / (d[0] * d[0] + d[1] * d[1]);
        let t = t.clamp(0.0, 1.0);
        (x - a[0] - d[0] * t).hypot(y - a[1] - d[1] * t)
    };
    // Clockwise from (60, 20) to (80, 40) with 20 mm: about (80, 20).
    let on_arc = x <= 80.0 && y >= 20.0;
    let arc = match on_arc {
        true => ((x - 80.0).hypot(y - 20.0) - 20.0).abs(),
        false => (x - 60.0).hypot(y - 20.0).min((x - 80.0).hypot(y - 40.0)),
    };
    line([0.0, 0.0], [40.0, 0.0])
        .min(line([40.0, 0.0], [60.0, 20.0]))
        .min(arc)
        .min(line([80.0, 40.0], [80.0, 70.0]))
}

#[test]
fn the_contour_train_follows_the_parallel() {
    let mut random = DataSequence(31);
    for _ in 0..100 {
        let values = Values::random(&mut random);
        let kind = [1.0, -1.0, 0.0][random.below(3)];
        let side = ["RL", "RR", "R0"][random.below(3)];
        let cycle = format!(
            "CYCL DEF 14.0 CONTOUR\nCYCL DEF 14.1 CONTOUR LABEL 5\nCYCL DEF 25 CONTOUR TRAIN Q1=-{} Q3={} Q5={} Q7={} Q10={} \
             Q11=111 Q12=333 Q15={kind}",
            values.depth, values.side, values.surface, values.top, values.infeed
        );
        let record = run(&cycle, &TRAIN.replace("RL", side), values.tool);
        assert!(errors(&record).is_empty(), "{:?}", errors(&record));
        let expected = infeeds(values.surface, values.depth, values.infeed);
        assert!(same(&levels(&record.seen), &expected));
        let keep = if side == "R0" { 0.0 } else { values.tool + values.side };
        for (p, feed) in cuts(&record.seen) {
            let found = from_train([p[0], p[1]]);
            assert!((found - keep).abs() < 1e-5, "{found} is not {keep} at {p:?}");
            assert!((feed - 333.0).abs() < 1e-6);
        }
        // Each level goes from one end to the other; RL along the contour is climb milling, RR against it.
        let sign = match side {
            "RR" => -1.0,
            _ => 1.0,
        };
        let begin = [0.0, sign * keep];
        let end = [80.0 - sign * keep, 70.0];
        for (index, level) in expected.iter().enumerate() {
            let on: Vec<[f64; 3]> = cuts(&record.seen)
                .iter()
                .map(|(p, _)| *p)
                .filter(|p| (p[2] - level).abs() < 1e-7)
                .collect();
            let climbs = match kind {
                0.0 => index % 2 == 0,
                own => own > 0.0,
            };
            let goes_along = climbs == (side != "RR");
            let (from, to) = if goes_along { (begin, end) } else { (end, begin) };
            let (first, last) = (on[0], on[on.len() - 1]);
            assert!(
                (first[0] - from[0]).hypot(first[1] - from[1]) < 1e-6,
                "{first:?} {from:?} {side} {kind}"
            );
            assert!((last[0] - to[0]).hypot(last[1] - to[1]) < 1e-6, "{last:?} {to:?}");
        }
    }
}

#[test]
fn what_cannot_be_followed_is_said() {
    let data = "CYCL DEF 20 CONTOUR DATA Q1=-9 Q2=1 Q3=0 Q4=0 Q5=0 Q6=2 Q7=50 Q8=0 Q9=1\n";
    let rough = "CYCL DEF 22 ROUGH-OUT Q10=5 Q11=1 Q12=5 Q18=0";
    let label =
        |number: &str| format!("CYCL DEF 14.0 CONTOUR\nCYCL DEF 14.1 CONTOUR LABEL{number}\n");
    let square = |side: &str, from: f64, to: f64| {
        format!(
            "L X{from:+} Y{from:+} {side}\nL X{to:+}\nL Y{to:+}\nL X{from:+}\nL Y{from:+}\nLBL 0\n"
        )
    };
    let first = |cycles: &str, subprograms: &str, tool: f64| {
        let record = run(cycles, subprograms, tool);
        assert!(record.seen.is_empty(), "nothing is cut: {cycles}");
        errors(&record).first().cloned().unwrap_or_default()
    };
    let one = format!("LBL 1\n{}", square("RL", 0.0, 40.0));
    assert!(first(&format!("{data}{rough}"), &one, 5.0).contains("cycle 14, which is missing"));
    assert!(
        first(&format!("{}{rough}", label("1")), &one, 5.0).contains("cycle 20, which is missing")
    );
    assert!(first(&format!("{}{data}{rough}", label("9")), &one, 5.0).contains("no label 9"));
    let all = format!("{}{data}{rough}", label("1"));
    assert!(first(&all, &one, 25.0).contains("there is no room"));
    let open = "LBL 1\nL X+0 Y+0 RL\nL X+40\nL Y+40\nLBL 0";
    assert!(first(&all, open, 5.0).contains("open by 56.5685 mm"));
    let bare = one.replace(" RL", "");
    assert!(first(&all, &bare, 5.0).contains("neither RL nor RR"));
    let probe = one.replace("L Y+40", "CYCL CALL\nL Y+40");
    assert!(first(&all, &probe, 5.0).starts_with("CH312"));
    let eight = "LBL 1\nL X+0 Y+0 RL\nL X+40 Y+40\nL X+40 Y+0\nL X+0 Y+40\nL X+0 Y+0\nLBL 0";
    assert!(first(&all, eight, 5.0).contains("crosses itself at 20.000, 20.000"));
    let two = format!("{}{data}{rough}", label("1 /2"));
    let overlapping = format!("{one}LBL 2\n{}", square("RL", 20.0, 60.0));
    assert!(first(&two, &overlapping, 5.0).starts_with("CH312"));
    let outside = format!("{one}LBL 2\n{}", square("RR", 60.0, 80.0));
    assert!(first(&two, &outside, 5.0).starts_with("CH312"));
    let pilot = format!("{}{data}CYCL DEF 21 PILOT DRILLING Q10=5 Q11=100 Q13=1", label("1"));
    assert!(first(&pilot, &one, 5.0).starts_with("CH312"));
    let coarse = format!("{}{data}CYCL DEF 22 ROUGH-OUT Q10=5 Q11=1 Q12=5 Q18=4", label("1"));
    assert!(first(&coarse, &one, 5.0).starts_with("CH312"));
    // A tool that is too large for an inside corner of a train.
    let narrow = "LBL 1\nL X+0 Y+0 RL\nL X+20\nL Y+6\nL X+24\nL Y+20\nLBL 0";
    let train = format!(
        "{}CYCL DEF 25 CONTOUR TRAIN Q1=-5 Q3=0 Q5=0 Q7=50 Q10=5 Q11=1 Q12=5 Q15=1",
        label("1")
    );
    let record = run(&train, narrow, 9.0);
    assert!(errors(&record)[0].contains("there is no room"), "{:?}", errors(&record));
    assert!(record.found.iter().any(|own| {
        own.alarm.as_deref().is_some_and(|alarm| alarm.ends_with("TOOL RADIUS TOO LARGE"))
    }));
    // A wall that the tool does not reach is said, and the others are finished.
    let notch =
        "LBL 1\nL X+0 Y+0 RL\nL X+40\nL Y+20\nL X+45\nL Y+26\nL X+40\nL Y+60\nL X+0\nL Y+0\nLBL 0";
    let side =
        format!("{}{data}CYCL DEF 24 SIDE FINISHING Q9=1 Q10=5 Q11=1 Q12=5 Q14=0", label("1"));
    let record = run(&side, notch, 5.0);
    assert!(errors(&record).is_empty(), "{:?}", errors(&record));
    assert!(record.found.iter().any(|own| own.message.contains("from the wall at 45.000, 23.000")));
    assert!(!record.seen.is_empty());
}

#[test]
fn contours_are_shifted_turned_and_mirrored_with_the_coordinates() {
    let values = Values {
        depth: 5.0,
        side: 0.0,
        floor: 0.0,
        surface: 0.0,
        clearance: 2.0,
        top: 50.0,
        infeed: 5.0,
        tool: 3.0,
        overlap: 1.0,
        left: 0.0,
        turn: 1.0,
    };
    let side = "CYCL DEF 24 SIDE FINISHING Q9=1 Q10=5 Q11=111 Q12=444 Q14=0";
    let placed = |before: &str, back: &dyn Fn([f64; 2]) -> [f64; 2]| {
        let record = run(&format!("{before}\n{}{side}", values.cycle_20()), POCKET, values.tool);
        assert!(errors(&record).is_empty(), "{:?}", errors(&record));
        let least = cuts(&record.seen)
            .iter()
            .map(|(p, _)| room(back([p[0], p[1]])))
            .fold(f64::INFINITY, f64::min);
        assert!((least - values.tool).abs() < 1e-6, "{before}: {least}");
    };
    placed("CYCL DEF 7.0\nCYCL DEF 7.1 X+13 Y-7", &|[x, y]| [x - 13.0, y + 7.0]);
    placed("CYCL DEF 10.0\nCYCL DEF 10.1 ROT+90", &|[x, y]| [y, -x]);
    placed("CYCL DEF 8.0\nCYCL DEF 8.1 X", &|[x, y]| [-x, y]);
}

#[test]
fn labels_with_names_are_said() {
    let data = "CYCL DEF 14.0\nCYCL DEF 14.1 CONTOUR LABEL \"POCKET1\"\nCYCL DEF 20 Q1=-9 Q2=1 Q3=0 Q4=0 Q5=0 Q6=2 Q7=50 Q8=0 Q9=1\n\
        CYCL DEF 23 Q11=100 Q12=500";
    let record = run(data, POCKET, 3.0);
    assert!(errors(&record).iter().any(|own| own.contains("labels with names")));
    assert!(record.seen.is_empty());
}

#[test]
fn contours_in_patterns_are_said() {
    let data = "CYCL DEF 14.0\nCYCL DEF 14.1 CONTOUR LABEL1\nCYCL DEF 20 Q1=-9 Q2=1 Q3=0 Q4=0 Q5=0 Q6=2 Q7=50 Q8=0 Q9=1\n\
        CYCL DEF 23 Q11=100 Q12=500\nCYCL DEF 220 Q216=0 Q217=0 Q244=20 Q241=3 Q246=360";
    let record = run(data, POCKET, 3.0);
    assert!(errors(&record).iter().any(|own| own.contains("in a pattern is not followed")));
}

/// The same pocket in the words of DIN/ISO programs.
const ISO: &str = "%T G71 *\nN10 G99 T1 L+0 R+3 *\nN20 T1 G17 S1000 *\nN30 G00 G40 G90 Z+90 M3 *\nN40 X-40 Y-30 *\n\
    N50 G37 P01 1 P02 2 *\n\
    N60 G120 Q1=-5 Q2=1 Q3=0 Q4=0 Q5=0 Q6=2 Q7=50 Q8=0 Q9=1 *\nN70 G124 Q9=1 Q10=5 Q11=111 Q12=444 Q14=0 *\nN80 G79 *\n\
    N90 M30 *\nN100 G98 L1 *\nN110 G01 G41 X+50 Y+0 *\nN120 X+100 *\nN130 G25 R8 *\nN140 Y+60 *\nN150 G24 R10 *\n\
    N160 X+0 *\nN170 G25 R8 *\nN180 G91 Y-60 *\nN190 G25 R8 *\nN200 X+50 *\nN210 G98 L0 *\n\
    N220 G98 L2 *\nN230 G90 I+30 J+30 *\nN240 G01 G90 G42 X+40 Y+30 *\nN250 G03 X+40 Y+30 *\nN260 G98 L0 *\nN999 %T G71 *\n";

#[test]
fn contours_of_din_iso_programs_are_the_same() {
    let mut machine = Machine::from_builtin("heidenhain-mill").expect("a built-in machine");
    machine.axes.iter_mut().flatten().for_each(|axis| axis.travel = Some((-10_000.0, 10_000.0)));
    machine.work_offsets.entry("G54".to_string()).or_default().values = [Some(0.0); 6];
    let mut sources = SourceMap::new();
    sources.add(Source::new("T.I", ISO.as_bytes().to_vec()));
    let mut iso = ContourCycleRecord::default();
    Job::new(sources, machine).expect("a job").run(&mut iso);
    assert!(errors(&iso).is_empty(), "{:?}", errors(&iso));
    let cycles = "CYCL DEF 14.0\nCYCL DEF 14.1 CONTOUR LABEL1 /2\nCYCL DEF 20 Q1=-5 Q2=1 Q3=0 Q4=0 Q5=0 Q6=2 Q7=50 Q8=0 Q9=1\n\
        CYCL DEF 24 Q9=1 Q10=5 Q11=111 Q12=444 Q14=0";
    let own = run(cycles, POCKET, 3.0);
    assert_eq!(iso.seen.len(), own.seen.len());
    for (a, b) in iso.seen.iter().zip(&own.seen) {
        let (a, b) = (a.to().expect("a move"), b.to().expect("a move"));
        assert!((0..3).all(|axis| (a[axis] - b[axis]).abs() < 1e-6), "{a:?} {b:?}");
    }
}
