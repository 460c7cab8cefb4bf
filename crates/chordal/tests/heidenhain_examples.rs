//! Worked examples of the language, with the results that were computed for them by hand: arcs, approaches, corners,
//! cycles, transformations, planes, and the arithmetic of FN.

use chordal::control::{Command, CommandKind, Origin};
use chordal::path::PathCommand;
use chordal::{Diagnostic, Job, Machine, PathSink, Severity, Source, SourceMap};

/// Results are rounded to four decimals, mm and degrees.
const TOLERANCE: f64 = 6e-5;

/// A move of the tool's centre.
#[derive(Clone, Debug, PartialEq)]
struct KlartextMove {
    to: [f64; 3],
    /// mm/min; `None` for a rapid.
    feed: Option<f64>,
    /// Centre on the axes of its plane, and degrees.
    arc: Option<([f64; 2], f64)>,
    length: f64,
}

/// The moves of a run, and its errors.
#[derive(Default)]
struct MoveRecord(Vec<KlartextMove>, Vec<String>);

impl PathSink for MoveRecord {
    fn command(&mut self, path: PathCommand<'_>) {
        let command: &Command = path.command;
        let Some(motion) = command.kind.motion() else { return };
        let from = [motion.from[0], motion.from[1], motion.from[2]];
        let to = [motion.to[0], motion.to[1], motion.to[2]];
        let shape = command.kind.shape();
        let straight = (0..3).map(|axis| (to[axis] - from[axis]).powi(2)).sum::<f64>().sqrt();
        let length = shape.map_or(straight, |shape| {
            let (a, b, normal) = shape.plane.axes();
            let radius = (from[a] - shape.center[0]).hypot(from[b] - shape.center[1]);
            (radius * shape.sweep).hypot(to[normal] - from[normal])
        });
        let feed = match command.kind {
            CommandKind::Rapid { .. } => None,
            _ => command.kind.feed().map(|feed| feed.value * 60.0),
        };
        let arc = shape.map(|shape| (shape.center, shape.sweep.to_degrees()));
        if length > 1e-9 {
            self.0.push(KlartextMove { to, feed, arc, length });
        }
    }

    fn diagnostic(&mut self, diagnostic: Diagnostic, _: &Origin) {
        if diagnostic.severity == Severity::Error {
            self.1.push(diagnostic.message);
        }
    }
}

/// The moves of blocks between the head of a program and its end, on a machine.
fn run_on(mut machine: Machine, blocks: &str) -> Vec<KlartextMove> {
    machine.axes.iter_mut().flatten().for_each(|axis| axis.travel = Some((-10_000.0, 10_000.0)));
    machine.work_offsets.entry("G54".to_string()).or_default().values = [Some(0.0); 6];
    let text = format!("BEGIN PGM E MM\n{blocks}\nM30\nEND PGM E MM\n");
    let mut sources = SourceMap::new();
    sources.add(Source::new("E.H", text.clone().into_bytes()));
    let mut record = MoveRecord::default();
    Job::new(sources, machine).expect("a job").compensated(None, &mut record);
    assert!(record.1.is_empty(), "{text}{:?}", record.1);
    record.0
}

fn run(blocks: &str) -> Vec<KlartextMove> {
    run_on(Machine::from_builtin("heidenhain-mill").expect("a built-in machine"), blocks)
}

/// The same after a tool of a radius was called, the spindle turns, and the tool is at a point of the plane at Z0.
fn run_with_tool(radius: f64, at: [f64; 2], blocks: &str) -> Vec<KlartextMove> {
    let [x, y] = at;
    run(&format!(
        "TOOL DEF 1 L+0 R+{radius}\nTOOL CALL 1 Z S500 F1000\nL X{x:+} Y{y:+} Z+0 R0 FMAX M3\n{blocks}"
    ))
}

#[track_caller]
fn near<const N: usize>(found: [f64; N], expected: [f64; N]) {
    let is_near = found.iter().zip(&expected).all(|(one, two)| (one - two).abs() <= TOLERANCE);
    assert!(is_near, "{found:?} is not {expected:?}");
}

fn end(moves: &[KlartextMove]) -> [f64; 3] {
    moves.last().expect("a move").to
}

/// The centre and the angle of the last arc.
#[track_caller]
fn last_arc(moves: &[KlartextMove]) -> [f64; 3] {
    let ([x, y], degrees) = moves.iter().rev().find_map(|own| own.arc).expect("an arc");
    [x, y, degrees]
}

#[test]
fn example_1_coordinates_with_and_without_i() {
    near(end(&run("L X+0 Y+20 Z+0 R0 FMAX\nL X+10 IY+5 FMAX")), [10.0, 25.0, 0.0]);
}

#[test]
fn examples_2_to_4_arcs_by_radius_and_tangent() {
    let short = run_with_tool(10.0, [30.0, 85.0], "CR X+70 Y+95 R+30 DR- F100");
    near(last_arc(&short), [55.2859, 68.8562, -86.8153]);
    let long = run_with_tool(10.0, [30.0, 85.0], "CR X+70 Y+95 R-30 DR- F100");
    near(last_arc(&long), [44.7141, 111.1438, -273.1847]);
    let tangent = run_with_tool(10.0, [95.0, 60.0], "L X+95 Y+40 F100\nCT X+40 Y+5");
    near(last_arc(&tangent), [56.3636, 40.0, -115.0576]);
    near([tangent.last().expect("an arc").length / 115.0576_f64.to_radians()], [38.6364]);
}

#[test]
fn example_5_polar_points() {
    let moves =
        run_with_tool(5.0, [0.0, 35.0], "CC X+40 Y+35\nLP PR+25 PA+120 F100\nCTP PR+30 PA+30");
    let [.., line, arc] = moves.as_slice() else { panic!("two moves") };
    near([line.to[0], line.to[1]], [27.5, 56.6506]);
    near([arc.to[0], arc.to[1]], [65.9808, 50.0]);
    let (center, degrees) = arc.arc.expect("an arc");
    near(center, [43.7482, 36.0126]);
    near([arc.length / degrees.to_radians().abs()], [26.2666]);
}

#[test]
fn examples_6_to_8_helices_and_arcs_in_other_planes() {
    let helix = run_with_tool(5.0, [32.0, 0.0], "CC X+0 Y+0\nCP IPA+3240 IZ+13.5 DR+ F100");
    let last = helix.last().expect("a helix");
    near([last.length], [1809.6077]);
    near([last.to[2], last_arc(&helix)[2]], [13.5, 3240.0]);
    let inside = run_with_tool(5.0, [27.0, 0.0], "CC X+0 Y+0\nCP IPA+3240 IZ+13.5 DR+ F100");
    near([inside.last().expect("a helix").length], [1526.8737]);
    let turns = run_with_tool(5.0, [51.5, 0.0], "CC X+0 Y+0\nCP IPA+731.125 DR+ F100");
    near([last_arc(&turns)[2] / 360.0], [2.0309]);
    let zx = run(
        "TOOL DEF 1 L+0 R+5\nTOOL CALL 1 Z S500\nL X+276.066 Y+0 Z-4 R0 FMAX M3\nCC X+277.066 Z-4\n\
         CP IPA-90 DR- F100",
    );
    near(end(&zx), [277.066, 0.0, -5.0]);
}

#[test]
fn example_9_corners() {
    let rounded = run_with_tool(1.0, [0.0, 0.0], "L X+20 F100\nRND R5\nL Y+20");
    near([rounded[0].to[0], rounded[1].to[1]], [15.0, 5.0]);
    let chamfered = run_with_tool(1.0, [0.0, 0.0], "L X+20 F100\nCHF 10\nL Y+20");
    near([chamfered[1].length], [14.1421]);
}

#[test]
fn examples_10_and_11_straight_approach_and_departure() {
    let moves = run_with_tool(
        10.0,
        [-40.0, -40.0],
        "L X-30 F200\nAPPR LT X+5 Y+5 LEN10 RL F100\nL Y+30\nL X+30\nL Y+5\nL X+5\nDEP LT LEN10",
    );
    // From (-5, -5) straight up to the compensated first point.
    near(moves[2].to, [-5.0, -5.0, 0.0]);
    near(moves[3].to, [-5.0, 5.0, 0.0]);
    near(end(&moves), [-5.0, -5.0, 0.0]);
    let [.., before, _] = moves.as_slice() else { panic!("a departure") };
    near(before.to, [5.0, -5.0, 0.0]);
}

#[test]
fn examples_12_and_13_lct() {
    let moves = run_with_tool(
        10.0,
        [-10.0, -10.0],
        "L X-10 F200\nAPPR LCT X+5 Y+5 R5 RL F100\nL Y+30\nL X+30\nL Y+5\nL X+5\nDEP LCT X-20 Y-20 R5",
    );
    near([moves[1].to[0], moves[1].to[1], moves[1].length], [-5.286, 3.3333, 14.1421]);
    let (center, degrees) = moves[2].arc.expect("an arc");
    near([center[0], center[1], degrees.abs()], [-10.0, 5.0, 19.4712]);
    let [.., arc, line] = moves.as_slice() else { panic!("a departure") };
    let (center, degrees) = arc.arc.expect("an arc");
    near([center[0], center[1], degrees.abs()], [5.0, -10.0, 32.5031]);
    near([arc.to[0], arc.to[1], line.length], [2.3133, -5.7832, 26.4575]);
    near(line.to, [-20.0, -20.0, 0.0]);
}

#[test]
fn examples_14_and_15_approach_on_arcs() {
    let start = |angle: u32| {
        let moves = run_with_tool(
            5.0,
            [-40.0, 60.0],
            &format!("L X-39 F200\nAPPR CT X+10 Y+20 CCA{angle} R+8 RL F100\nL X+40\nL Y-20 R0"),
        );
        let (center, _) = moves[3].arc.expect("an arc");
        near(center, [10.0, 33.0]);
        near(moves[3].to, [10.0, 25.0, 0.0]);
        [moves[2].to[0], moves[2].to[1]]
    };
    near(start(90), [2.0, 33.0]);
    near(start(180), [10.0, 41.0]);
    let polar = run_with_tool(
        5.0,
        [50.0, 50.0],
        "L X+51 F200\nCC X+50 Y+50\nAPPR PCT PR+32 PA-180 CCA180 R+2 RL F100\nCP IPA+360 DR+\nDEP CT CCA180 R+2",
    );
    near([polar[2].to[0], polar[2].to[1]], [27.0, 50.0]);
    let (center, _) = polar[3].arc.expect("an arc");
    near([center[0], center[1], polar[3].to[0]], [25.0, 50.0, 23.0]);
}

#[test]
fn example_16_outside_corner() {
    let moves = run_with_tool(10.0, [-30.0, 0.0], "L X-20 RL F100\nL X+0\nL Y-30\nL X-20 R0");
    let corner = moves.iter().find(|own| own.arc.is_some()).expect("an arc");
    near([corner.length], [15.708]);
}

/// The levels of a hole at X0 Y0, from the surface: rapids as `r`, feeds as `f`.
fn hole(definition: &str) -> String {
    let moves = run_with_tool(3.0, [0.0, 0.0], &format!("L Z+60 FMAX\n{definition}\nCYCL CALL"));
    let level = |own: &KlartextMove| {
        let kind = if own.feed.is_some() { 'f' } else { 'r' };
        format!("{kind}{}", (own.to[2] * 1000.0).round() / 1000.0)
    };
    moves[1..].iter().map(level).collect::<Vec<_>>().join(" ")
}

#[test]
fn examples_17_to_20_pecking() {
    let drilled =
        hole("CYCL DEF 200 Q200=2 Q201=-15 Q206=100 Q202=6 Q210=0 Q203=+0 Q204=50 Q211=0");
    assert_eq!(drilled, "r2 f-6 r2 r-5.8 f-12 r2 r-11.8 f-15 r50");
    let universal = |breaks: u32| {
        hole(&format!(
            "CYCL DEF 203 Q200=2 Q201=-20 Q206=100 Q202=5 Q210=0 Q203=+0 Q204=50 Q212=0 Q213={breaks} Q205=0 \
             Q211=0 Q208=500 Q256=0.2"
        ))
    };
    assert_eq!(universal(3), "r2 f-5 f-4.8 f-10 f-9.8 f-15 f-14.8 f-20 f2 r50");
    assert_eq!(universal(1), "r2 f-5 f-4.8 f-10 f2 r-9.8 f-15 f-14.8 f-20 f2 r50");
    let decreasing = hole(
        "CYCL DEF 203 Q200=2 Q201=-30 Q206=100 Q202=10 Q210=0 Q203=+0 Q204=50 Q212=2 Q213=0 Q205=4 Q211=0 \
         Q208=99999 Q256=0.2",
    );
    let depths: Vec<&str> = decreasing.split(' ').filter(|level| level.starts_with("f-")).collect();
    assert_eq!(depths, ["f-10", "f-18", "f-24", "f-28", "f-30"]);
}

#[test]
fn examples_21_to_23_taps_and_helices() {
    let tapped = run_with_tool(
        3.0,
        [0.0, 0.0],
        "L Z+10 FMAX\nCYCL DEF 207 Q200=2 Q201=-10 Q239=1.5 Q203=+0 Q204=50\nCYCL CALL",
    );
    let feed = tapped.iter().find(|own| own.to[2] == -10.0).and_then(|own| own.feed);
    near([feed.expect("a feed")], [750.0]);
    let bore = run_with_tool(
        3.0,
        [0.0, 0.0],
        "L Z+10 FMAX\nCYCL DEF 208 Q200=2 Q201=-10 Q206=100 Q334=2 Q203=+0 Q204=50 Q335=20 Q342=0 Q351=1\nCYCL CALL",
    );
    let helix = bore.iter().find(|own| own.arc.is_some()).expect("a helix");
    near([helix.to[0], helix.arc.expect("an arc").1 / 360.0], [7.0, 6.0]);
    let thread = |windings: i32| {
        run_with_tool(
            3.0,
            [0.0, 0.0],
            &format!(
                "L Z+10 FMAX\nCYCL DEF 262 Q335=16 Q239=1.5 Q201=-20 Q355={windings} Q253=750 Q351=+1 Q200=2 Q203=+0 \
                 Q204=50 Q207=500\nCYCL CALL"
            ),
        )
    };
    let longest = |moves: &[KlartextMove]| {
        let arcs = moves.iter().filter_map(|own| Some((own.arc?.1.abs() / 360.0, own.feed)));
        arcs.fold((0.0, None), |most, own| if own.0 > most.0 { own } else { most })
    };
    let (turns, feed) = longest(&thread(0));
    // A turn, and half of one at most on either side.
    assert!((1.0..=2.0).contains(&turns), "{turns}");
    near([feed.expect("a feed")], [312.5]);
    let (turns, _) = longest(&thread(1));
    assert!((13.0..=15.0).contains(&turns), "{turns}");
}

#[test]
fn example_24_holes_on_a_circle() {
    let moves = run_with_tool(
        3.0,
        [0.0, 0.0],
        "L Z+50 FMAX\nCYCL DEF 200 Q200=2 Q201=-5 Q206=100 Q202=5 Q210=0 Q203=+0 Q204=50 Q211=0\n\
         CYCL DEF 220 Q216=+50 Q217=+50 Q244=80 Q245=+0 Q246=+360 Q247=0 Q241=8 Q200=2 Q203=+0 Q204=50",
    );
    let holes: Vec<[f64; 2]> =
        moves.iter().filter(|own| own.to[2] == -5.0).map(|own| [own.to[0], own.to[1]]).collect();
    assert_eq!(holes.len(), 8);
    near(holes[0], [90.0, 50.0]);
    near(holes[1], [78.2843, 78.2843]);
    near(holes[2], [50.0, 90.0]);
}

#[test]
fn examples_25_and_26_transformations_in_their_order() {
    let shift = "CYCL DEF 7.0 DATUM\nCYCL DEF 7.1 X+20\nCYCL DEF 7.2 Y+5\n";
    let rotation = "CYCL DEF 10.0 ROTATION\nCYCL DEF 10.1 ROT+30\n";
    let scale = "CYCL DEF 11.0 SCALING\nCYCL DEF 11.1 SCL 0.5\n";
    let point = |before: &str| {
        let [x, y, _] = end(&run(&format!("L Z+0 R0 FMAX\n{before}L X+10 Y+0 R0 FMAX")));
        [x, y]
    };
    near(point(&format!("{shift}{rotation}")), [28.6603, 10.0]);
    near(point(&format!("{rotation}{shift}")), [23.4808, 19.3301]);
    near(point(&format!("{shift}{rotation}{scale}")), [24.3301, 7.5]);
}

#[test]
fn examples_27_and_28_tilted_planes() {
    let place = |angles: &str, point: &str| {
        let text = format!(
            "BEGIN PGM E MM\nTOOL DEF 1 L+0 R+5\nTOOL CALL 1 Z S500\nL Z+50 R0 FMAX\nPLANE SPATIAL {angles} STAY\n\
             L {point} R0 FMAX\nM30\nEND PGM E MM\n"
        );
        let mut machine = Machine::from_builtin("heidenhain-ac-trunnion").expect("a machine");
        machine.work_offsets.entry("G54".to_string()).or_default().values = [Some(0.0); 6];
        let mut sources = SourceMap::new();
        sources.add(Source::new("E.H", text.into_bytes()));
        let job = Job::new(sources, machine).expect("a job");
        let mut last = PlanePoint::default();
        job.compensated(None, &mut last);
        last.point.expect("a point in a plane")
    };
    near(place("SPA+0 SPB+30 SPC+90", "X+10 Y+0 Z+0"), [0.0, 8.6603, -5.0]);
    near(place("SPA+0 SPB+30 SPC+90", "X+0 Y+0 Z+10"), [0.0, 5.0, 8.6603]);
    near(place("SPA+30 SPB+0 SPC+90", "X+0 Y+10 Z+0"), [-8.6603, 0.0, 5.0]);
}

/// The last point of a tilted plane in coordinates of the preset.
#[derive(Default)]
struct PlanePoint {
    plane: Option<chordal::geometry::Transform>,
    point: Option<[f64; 3]>,
}

impl PathSink for PlanePoint {
    fn command(&mut self, path: PathCommand<'_>) {
        if let CommandKind::PartFrame { frame, .. } = &path.command.kind {
            self.plane = frame.as_ref().map(|frame| frame.plane);
        }
        if let (Some(plane), Some(motion)) = (&self.plane, path.command.kind.motion()) {
            let own = chordal::geometry::Vec3::new(motion.to[0], motion.to[1], motion.to[2]);
            self.point = Some(plane.apply_point(own).to_array());
        }
    }

    fn diagnostic(&mut self, _: Diagnostic, _: &Origin) {}
}

#[test]
fn example_29_lengths_and_angles() {
    let value =
        |function: &str| end(&run(&format!("L Y+0 Z+0 R0 FMAX\n{function}\nL X+Q1 FMAX")))[0];
    near([value("FN 8: Q1 = +5 LEN +4")], [6.4031]);
    near([value("FN 13: Q1 = +25 ANG +25")], [45.0]);
}

#[test]
fn example_30_repeats() {
    near(
        end(&run("L X+35 Y+0 Z+0 R0 FMAX\nLBL 1\nL IX+1 FMAX\nCALL LBL 1 REP 2")),
        [38.0, 0.0, 0.0],
    );
}

#[test]
fn example_31_decimal_commas() {
    let moves = run_with_tool(
        3.0,
        [0.0, 0.0],
        "L Z+60 FMAX\nCYCL DEF 200 Q200=2 Q201=-54,887 Q206=100 Q202=60 Q210=0 Q203=50 Q204=2 Q211=0\nCYCL CALL",
    );
    let levels: Vec<f64> = moves[1..].iter().map(|own| own.to[2]).collect();
    assert_eq!(levels.len(), 3, "{levels:?}");
    near([levels[0], levels[1], levels[2]], [52.0, -4.887, 52.0]);
}

#[test]
fn example_32_feeds_of_inch_programs() {
    let text = "BEGIN PGM E INCH\nTOOL CALL 1 Z S500\nL X+0 Y+0 Z+1 R0 FMAX M3\nL X+1 F2000\nM30\nEND PGM E INCH\n";
    let mut sources = SourceMap::new();
    sources.add(Source::new("E.H", text.as_bytes()));
    let machine = Machine::from_builtin("heidenhain-mill").expect("a built-in machine");
    let mut record = MoveRecord::default();
    Job::new(sources, machine).expect("a job").compensated(None, &mut record);
    let feed = record.0.last().and_then(|own| own.feed).expect("a feed");
    near([feed / 25.4], [200.0]);
}

#[test]
fn patterns_are_drilled_point_by_point() {
    let moves = run_with_tool(
        3.0,
        [0.0, 0.0],
        "L Z+50 FMAX\nCYCL DEF 200 Q200=2 Q201=-5 Q206=100 Q202=5 Q210=0 Q203=+0 Q204=50 Q211=0\n\
         PATTERN DEF ROW1 (X+25 Y+33,5 D+8 NUM3 ROT+90 Z+0) CIRC1 (X+100 Y+50 D40 START+0 NUM4 Z-2)\nCYCL CALL PAT FMAX",
    );
    let is_bottom = |own: &&KlartextMove| own.feed.is_some();
    let holes: Vec<[f64; 3]> = moves.iter().filter(is_bottom).map(|own| own.to).collect();
    assert_eq!(holes.len(), 7, "{holes:?}");
    near(holes[2], [25.0, 49.5, -5.0]);
    near(holes[4], [100.0, 70.0, -7.0]);
}
