//! Thread mill programs, judged by the path that each control makes of them. Nothing here knows
//! how the programs are made: diameter, pitch, hand and clearance are measured on the curves.

use std::f64::consts::TAU;

use chordal::geometry::{Arc, Curve, ParamCurve, Vec3};
use chordal::machine::ControlName;
use chordal::{Job, Machine, Report, Segment, SegmentKind, Severity, Source, SourceMap};
use chordal_calc::{
    AnswerUnit, MillingDirection, RampSweep, ThreadHand, ThreadLocation, ThreadMill,
    ThreadMillCutter, ThreadSize, thread_mill,
};

/// A machine of each control.
const MACHINES: [(ControlName, &str); 5] = [
    (ControlName::Fadal, "fadal-4020"),
    (ControlName::Haas, "haas-vf2"),
    (ControlName::Fanuc, "fanuc-30i"),
    (ControlName::Mitsubishi, "mitsubishi-m700"),
    (ControlName::Linuxcnc, "linuxcnc-mill"),
];

fn run(text: &str, machine: &str) -> (Report, Vec<Segment>) {
    run_with(text, machine, None)
}

/// The same with an assignment to the machine.
fn run_with(text: &str, machine: &str, set: Option<&str>) -> (Report, Vec<Segment>) {
    let mut sources = SourceMap::new();
    sources.add(Source::new("thread.nc", text.as_bytes().to_vec()));
    let mut machine = Machine::from_builtin(machine).expect("a machine");
    if let Some(assignment) = set {
        machine.set(assignment).expect("an assignment");
    }
    let job = Job::new(sources, machine).expect("a job");
    let mut path = Vec::new();
    let report = job.report_with(|_, segments| path.extend_from_slice(segments));
    (report, path)
}

/// Every combination of what a thread can be.
fn all() -> Vec<ThreadMill> {
    let sizes = [
        // 1.5-8 with a tool of .75, M30x2 with 16, and small and fine ones.
        (AnswerUnit::Inch, 38.1, 25.4 / 8.0, 19.05, 12.7),
        (AnswerUnit::Millimetre, 30.0, 2.0, 16.0, 24.0),
        (AnswerUnit::Inch, 25.4 * 0.3125, 25.4 / 18.0, 25.4 * 0.235, 25.4 * 0.4),
        (AnswerUnit::Millimetre, 6.0, 1.0, 4.5, 9.3),
        (AnswerUnit::Inch, 25.4 * 0.25, 25.4 / 20.0, 25.4 * 0.18, 25.4 * 0.3333),
        (AnswerUnit::Millimetre, 100.0, 6.0, 40.0, 51.7),
        (AnswerUnit::Millimetre, 12.0, 1.75, 9.511, 20.0001),
        (AnswerUnit::Inch, 101.6, 25.4 / 4.0, 38.1, 60.0),
        (AnswerUnit::Millimetre, 3.0, 0.5, 2.33, 4.0),
        (AnswerUnit::Inch, 27.0, 25.4 / 13.0, 20.0, 11.1),
    ];
    let mut asks = Vec::new();
    for (units, major, pitch, tool_diameter, depth) in sizes {
        for (control, _) in MACHINES {
            for place in [ThreadLocation::Inside, ThreadLocation::Outside] {
                for hand in [ThreadHand::Right, ThreadHand::Left] {
                    for cutter in [ThreadMillCutter::Hob, ThreadMillCutter::Single] {
                        for cut in [MillingDirection::Climb, MillingDirection::Conventional] {
                            for ramp in [None, Some(RampSweep::Eighth), Some(RampSweep::Quarter)] {
                                asks.push(ThreadMill {
                                    thread: ThreadSize { major, pitch, starts: 1 },
                                    place,
                                    hand,
                                    cutter,
                                    cut,
                                    ramp,
                                    root: None,
                                    tool_diameter,
                                    depth,
                                    feed: 4.0,
                                    spindle: 2000.0,
                                    wear: None,
                                    tool: 7,
                                    number: 1001,
                                    clearance: 2.54,
                                    control,
                                    units,
                                });
                            }
                        }
                    }
                }
            }
        }
    }
    asks
}

/// What the path shows.
struct Measured {
    /// The full turns about the axis, in order.
    turns: Vec<Arc>,
    /// The arcs before and after.
    arc_in: Arc,
    arc_out: Arc,
}

fn measure(path: &[Segment]) -> Measured {
    let arcs: Vec<Arc> = path
        .iter()
        .filter(|segment| segment.kind == SegmentKind::Arc)
        .map(|segment| match segment.curve {
            Curve::Arc(arc) => arc,
            other => panic!("an arc that is {other:?}"),
        })
        .collect();
    let (first, rest) = arcs.split_first().expect("arcs");
    let (last, turns) = rest.split_last().expect("turns");
    assert!(turns.iter().all(|arc| (arc.sweep.abs() - TAU).abs() < 1e-9), "full turns");
    Measured { turns: turns.to_vec(), arc_in: *first, arc_out: *last }
}

fn off_axis(point: Vec3) -> f64 {
    point.x.hypot(point.y)
}

/// Angle between two directions seen from above, degrees.
fn kink(a: Vec3, b: Vec3) -> f64 {
    let cross = a.x * b.y - a.y * b.x;
    let dot = a.x * b.x + a.y * b.y;
    cross.atan2(dot).abs().to_degrees()
}

#[track_caller]
fn near(what: &str, value: f64, expected: f64, tolerance: f64, text: &str) {
    assert!((value - expected).abs() <= tolerance, "{what} {value}, not {expected}\n{text}");
}

fn judge(ask: &ThreadMill, text: &str, report: &Report, path: &[Segment]) {
    assert!(
        !matches!(report.worst(), Some(Severity::Warning | Severity::Error)),
        "{:?}\n{text}",
        report.diagnostics
    );
    let step = ask.units.mm() / 10f64.powi(ask.units.word_decimals() as i32);
    let Measured { turns, arc_in, arc_out } = measure(path);
    let inside = ask.place == ThreadLocation::Inside;
    let sign = if inside { 1.0 } else { -1.0 };
    let (pitch, tool) = (ask.thread.pitch, ask.tool_diameter);
    // UN and ISO: 5/4 H off the major diameter inside, 17/12 H outside.
    let h = pitch * 3f64.sqrt() / 2.0;
    let hole = ask.thread.major - 1.25 * h;
    let root = ask.thread.major - 17.0 / 12.0 * h;
    let cut = if inside { ask.thread.major } else { root };

    for arc in &turns {
        near("axis", off_axis(arc.center), 0.0, 1e-9, text);
        near("diameter", 2.0 * (arc.radius + sign * tool / 2.0), cut, 1.01 * step, text);
        near("pitch", arc.rise.abs(), pitch, 1.01 * step, text);
        let right = arc.sweep * arc.w.z * arc.rise > 0.0;
        assert_eq!(right, ask.hand == ThreadHand::Right, "hand\n{text}");
        // With M3 the tool climbs counter-clockwise in a hole and clockwise on a boss.
        let ccw = arc.sweep * arc.w.z > 0.0;
        assert_eq!(ccw, inside == (ask.cut == MillingDirection::Climb), "sense\n{text}");
    }
    // F of the centre moves the points of the teeth at the feed asked for, along the helix or along
    // its circle, as the control takes F.
    let whole = |segment: &&Segment| match segment.curve {
        Curve::Arc(arc) => (arc.sweep.abs() - TAU).abs() < 1e-9,
        _ => false,
    };
    for segment in path.iter().filter(whole) {
        let feed = segment.length_mm / segment.duration_s;
        let at_the_teeth = feed * cut / (2.0 * turns[0].radius);
        let circle = TAU * turns[0].radius / segment.length_mm;
        let off = (at_the_teeth - ask.feed).abs().min((at_the_teeth * circle - ask.feed).abs());
        near("feed off by", off, 0.0, 0.01 * ask.feed, text);
    }
    // Errors of rounding do not add up over the turns.
    let (bottom, top) = turns
        .iter()
        .flat_map(|arc| [arc.start.z, arc.end.z])
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), z| (low.min(z), high.max(z)));
    near("bottom", bottom, -ask.depth, 0.51 * step, text);
    near("height", top - bottom, turns.len() as f64 * pitch, 1.01 * step, text);
    match ask.cutter {
        ThreadMillCutter::Hob => assert_eq!(turns.len(), 1, "{text}"),
        ThreadMillCutter::Single => {
            assert!(top >= pitch - step, "the thread runs out above the part\n{text}");
            assert!(top <= 2.0 * pitch + step, "no turn too many\n{text}");
        }
    }

    // In and out without a kink, with the slope of the thread.
    let joints = [(arc_in, turns[0]), (turns[turns.len() - 1], arc_out)];
    for (before, after) in joints {
        assert!((before.end - after.start).length() < 1e-9);
        let (a, b) = (before.tangent_at(before.length()), after.tangent_at(0.0));
        assert!(kink(a, b) < 0.01, "kink of {} deg\n{text}", kink(a, b));
        let slope = |t: Vec3| (t.z / t.x.hypot(t.y)).atan().to_degrees();
        let rounding = (2.0 * step / before.length().min(after.length())).to_degrees();
        near("slope", slope(a), slope(b), rounding, text);
    }
    leaves_the_thread_whole(ask, cut, hole, path, step, text);
}

/// Nothing but the thread is cut, and the tool comes down clear of the part.
fn leaves_the_thread_whole(
    ask: &ThreadMill,
    cut: f64,
    hole: f64,
    path: &[Segment],
    step: f64,
    text: &str,
) {
    let tool = ask.tool_diameter / 2.0;
    let inside = ask.place == ThreadLocation::Inside;
    let mut up_or_down = 0;
    for segment in path.iter().filter(|segment| segment.known) {
        for index in 0..=64 {
            let point = segment.curve.point_at(segment.curve.length() * f64::from(index) / 64.0);
            if point.z >= ask.thread.pitch {
                continue;
            }
            let away = off_axis(point);
            if inside {
                assert!(away + tool <= cut / 2.0 + step, "outside the thread\n{text}");
            } else {
                assert!(away - tool >= cut / 2.0 - step, "below the root\n{text}");
            }
        }
        let (from, to) = (segment.curve.start(), segment.curve.end());
        let straight = segment.kind != SegmentKind::Arc && off_axis(to - from) < 1e-9;
        let (straight_down, straight_up) =
            (straight && to.z < from.z, straight && to.z > from.z && from.z < 0.0);
        if (straight_down && to.z < 0.0) || straight_up {
            up_or_down += 1;
            let clear = if inside {
                off_axis(to) + tool < hole / 2.0
            } else {
                off_axis(to) - tool > ask.thread.major / 2.0
            };
            assert!(clear, "up or down in the part at {to:?}\n{text}");
        }
    }
    // Cut downwards with one tooth, it begins above the part; it ends below in any case.
    let into_the_part = path.iter().any(|segment| segment.curve.end().z < 0.0);
    assert!(into_the_part && up_or_down > 0, "no way up or down\n{text}");
}

#[test]
fn every_thread_on_every_control() {
    let (mut written, mut refused) = (0, 0);
    for ask in all() {
        let machine = MACHINES.iter().find(|(control, _)| *control == ask.control).unwrap().1;
        match thread_mill(&ask) {
            Ok(program) => {
                let (report, path) = run(&program.text, machine);
                judge(&ask, &program.text, &report, &path);
                written += 1;
            }
            Err(error) => {
                // In a narrow hole only the arc from the axis is free.
                let eighth =
                    ask.ramp == Some(RampSweep::Eighth) && ask.place == ThreadLocation::Inside;
                assert!(eighth && error.message.contains("1/8"), "{error}");
                refused += 1;
            }
        }
    }
    println!("{written} programs, {refused} refused");
    assert!(written > 2000 && refused < 400, "{written} written, {refused} refused");
}

/// What the judge says is not always yes: a thread of another pitch, hand or diameter is refused.
#[test]
fn the_judge_sees_what_is_wrong() {
    let ask = all().into_iter().find(|ask| ask.control == ControlName::Haas).unwrap();
    let text = thread_mill(&ask).unwrap().text;
    let (report, path) = run(&text, "haas-vf2");
    judge(&ask, &text, &report, &path);
    let wrong = |change: fn(&mut ThreadMill)| {
        let mut other = ask.clone();
        change(&mut other);
        let judged = std::panic::catch_unwind(|| judge(&other, "", &report, &path));
        assert!(judged.is_err());
    };
    wrong(|ask| ask.hand = ThreadHand::Left);
    wrong(|ask| ask.thread.major += 0.01);
    wrong(|ask| ask.thread.pitch += 0.01);
    wrong(|ask| ask.depth += 0.01);
    wrong(|ask| ask.place = ThreadLocation::Outside);
    wrong(|ask| ask.cut = MillingDirection::Conventional);
    let kinked = text.replace("J0. Z-0.5 ", "J0. Z-0.52 ");
    assert_ne!(kinked, text);
    let (report, path) = run(&kinked, "haas-vf2");
    assert!(std::panic::catch_unwind(|| judge(&ask, "", &report, &path)).is_err());
}

/// The lead-in of the form with compensation: straight, longer than the wear, on the right side.
#[test]
fn compensation_has_a_straight_way_in_and_out() {
    let mut compensated = 0;
    for mut ask in all() {
        // The narrow holes have no room for it.
        if ask.ramp.is_some() || ask.thread.major < 20.0 {
            continue;
        }
        ask.wear = Some(0.2);
        let text = match thread_mill(&ask) {
            Ok(program) => program.text,
            Err(error) if error.message.contains("arc of 1/8 turn") => continue,
            Err(error) => panic!("{error}"),
        };
        compensated += 1;
        let side = if ask.cut == MillingDirection::Climb { "G41 " } else { "G42 " };
        let on = text.lines().find(|line| line.starts_with(side)).expect("a way in");
        assert!(on.contains("X") && on.contains("Y") && !on.contains('I'), "{on}");
        assert!(text.lines().any(|line| line.starts_with("G40 G") && !line.contains('I')));
        assert!(text.contains("D7"), "{text}");
        let plain = text.replace(side, "").replace("G40 G1 ", "G1 ").replace("G40 G01 ", "G01 ");
        let plain = plain.replace(" D7", "");
        let machine = MACHINES.iter().find(|(control, _)| *control == ask.control).unwrap().1;
        let (report, path) = run(&plain, machine);
        judge(&ask, &plain, &report, &path);
        let at = path.iter().position(|segment| segment.kind == SegmentKind::Arc).unwrap();
        assert_eq!(path[at - 1].kind, SegmentKind::Line);
        assert!(path[at - 1].length_mm > 0.2);
        let turn = |path: &[Segment]| {
            let mut arcs = path.iter().filter_map(|segment| match segment.curve {
                Curve::Arc(arc) if arc.sweep.abs() > 0.999 * TAU => Some(arc.radius),
                _ => None,
            });
            arcs.next_back().expect("a turn")
        };
        // A worn tool goes nearer to the thread: inside out, outside in.
        let outward = if ask.place == ThreadLocation::Inside { -1.0 } else { 1.0 };
        for radius in [0.1, -0.1] {
            let set = format!("tools.7.diameter={} mm", 2.0 * radius);
            let (report, worn) = run_with(&text, machine, Some(&set));
            assert_eq!(report.counts.errors + report.counts.warnings, 0, "{text}\n{report:?}");
            let grown = turn(&worn) - turn(&path);
            assert!((grown - outward * radius).abs() < 1e-6, "{grown} {radius}\n{text}");
        }
    }
    assert!(compensated > 100, "{compensated}");
}

/// A remark holds nothing that a control could take for the end of its block or of the remark.
#[test]
fn remarks_are_safe() {
    for ask in all().into_iter().step_by(7) {
        let text = thread_mill(&ThreadMill { wear: None, ..ask.clone() }).map(|made| made.text);
        let Ok(text) = text else { continue };
        assert!(text.is_ascii());
        for line in text.lines() {
            let semicolon = line.rfind(';').is_none_or(|at| at == 0);
            assert!(semicolon && line.matches('(').count() <= 1, "{line}");
            assert_eq!(line.matches('(').count(), line.matches(')').count(), "{line}");
            assert!(line.len() <= 80, "{line}");
        }
    }
}
