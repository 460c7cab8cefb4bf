//! Programs with free contours (FK): the path of the tool's centre against geometry that is calculated here, and what is
//! said where several contours fit.

use chordal::control::{Command, Origin};
use chordal::path::PathCommand;
use chordal::{Diagnostic, Job, Machine, PathSink, Severity, Source, SourceMap};

const TOLERANCE_MM: f64 = 1e-6;

#[derive(Default)]
struct FreeContourPathRecord {
    moves: Vec<Command>,
    errors: Vec<Diagnostic>,
}

impl PathSink for FreeContourPathRecord {
    fn command(&mut self, path: PathCommand<'_>) {
        if path.command.kind.motion().is_some() {
            self.moves.push(path.command.clone());
        }
    }

    fn diagnostic(&mut self, found: Diagnostic, _: &Origin) {
        if found.severity == Severity::Error {
            self.errors.push(found);
        }
    }
}

fn run(blocks: &str, settings: &str) -> FreeContourPathRecord {
    let text = format!("inherits = \"heidenhain-mill\"\n[settings]\n{settings}\n");
    let mut machine =
        Machine::from_toml("a.toml", &text, &|name| Err(format!("no {name}"))).expect("a machine");
    machine.axes.iter_mut().flatten().for_each(|axis| axis.travel = Some((-10_000.0, 10_000.0)));
    machine.work_offsets.entry("G54".to_string()).or_default().values = [Some(0.0); 6];
    let mut sources = SourceMap::new();
    sources
        .add(Source::new("a.h", format!("BEGIN PGM A MM\n{blocks}\nEND PGM A MM\n").into_bytes()));
    let job = Job::new(sources, machine).expect("a job");
    let mut record = FreeContourPathRecord::default();
    job.compensated(None, &mut record);
    record
}

/// The moves of blocks with these numbers.
fn clean(blocks: &str, settings: &str) -> Vec<Command> {
    let record = run(blocks, settings);
    assert!(record.errors.is_empty(), "{:#?}", record.errors);
    record.moves
}

fn end(step: &Command) -> [f64; 2] {
    let to = step.kind.motion().expect("a move").to;
    [to[0], to[1]]
}

fn start(step: &Command) -> [f64; 2] {
    let from = step.kind.motion().expect("a move").from;
    [from[0], from[1]]
}

fn distance(one: [f64; 2], other: [f64; 2]) -> f64 {
    (one[0] - other[0]).hypot(one[1] - other[1])
}

fn near(found: [f64; 2], expected: [f64; 2]) {
    assert!(distance(found, expected) < TOLERANCE_MM, "{found:?} is not {expected:?}");
}

/// The arcs of a path with their centre and radius, and the lines with their length.
fn arc_of(step: &Command) -> Option<([f64; 2], f64, f64)> {
    let shape = step.kind.shape()?;
    Some((shape.center, distance(shape.center, end(step)), shape.sweep))
}

const TOOL: &str = "TOOL DEF 1 L+0 R+4\nTOOL CALL 1 Z S500\nL X-20 Y+30 R0 FMAX M3\nL Z-10 F1000\n";

/// A contour about three circles, as the manuals show one: after APPR, with lines of which nothing is known.
#[test]
fn a_belt_about_three_circles_after_appr() {
    let blocks = format!(
        "{TOOL}APPR CT X+2 Y+30 CCA90 R+5 RL F250
FC DR- R18 CLSD+ CCX+20 CCY+30
FLT
FCT DR- R15 CCX+50 CCY+75
FLT
FCT DR- R15 CCX+75 CCY+20
FLT
FCT DR- R18 CLSD- CCX+20 CCY+30
DEP CT CCA90 R+5 F1000
L X-30 Y+0 FMAX"
    );
    let moves = clean(&blocks, "");
    let circles = [([20.0, 30.0], 18.0), ([50.0, 75.0], 15.0), ([75.0, 20.0], 15.0)];
    let contour: Vec<&Command> =
        moves.iter().filter(|step| (7..=13).contains(&step.origin.line)).collect();
    // The tool is on the left of a clockwise contour: outside, 4 mm off.
    near(start(contour[0]), [-2.0, 30.0]);
    assert_eq!(contour.len(), 7);
    for (index, step) in contour.iter().enumerate() {
        if index % 2 == 0 {
            let (center, radius) = circles[(index / 2) % 3];
            let (found, found_radius, sweep) = arc_of(step).expect("an arc");
            near(found, center);
            assert!((found_radius - radius - 4.0).abs() < TOLERANCE_MM);
            assert!(sweep < 0.0);
        } else {
            let [(one, r), (other, s)] = [circles[index / 2], circles[(index / 2 + 1) % 3]];
            let expected = (distance(one, other).powi(2) - (r - s) * (r - s)).sqrt();
            let length = distance(start(step), end(step));
            assert!((length - expected).abs() < TOLERANCE_MM, "{length} is not {expected}");
            // The line is perpendicular to the radii at both ends.
            let along = [end(step)[0] - start(step)[0], end(step)[1] - start(step)[1]];
            let radial = [start(step)[0] - one[0], start(step)[1] - one[1]];
            assert!((along[0] * radial[0] + along[1] * radial[1]).abs() < 1e-6);
        }
    }
    near(end(contour[6]), [-2.0, 30.0]);
    // The approach: a quarter of a circle of 5 mm about (-7, 30) that ends upwards.
    let approach: Vec<&Command> =
        moves.iter().filter(|step| step.origin.line == 6 && step.kind.shape().is_some()).collect();
    let (center, radius, sweep) = arc_of(approach[0]).expect("an arc");
    near(center, [-7.0, 30.0]);
    near(start(approach[0]), [-7.0, 25.0]);
    assert!((radius - 5.0).abs() < TOLERANCE_MM && (sweep.to_degrees() - 90.0).abs() < 1e-6);
    let departure = moves.iter().find(|step| step.origin.line == 14 && step.kind.shape().is_some());
    near(end(departure.expect("an arc")), [-7.0, 35.0]);
}

/// A line at the beginning, with RR, and a rounding between two elements of the contour.
#[test]
fn a_line_after_appr_and_a_rounding() {
    let blocks = format!(
        "{TOOL}APPR LT X+10 Y+10 LEN8 RR F250
FL AN+0
FL X+60 Y+50 AN+90
RND R10
FL X+10 AN+180
DEP LT LEN5
L X-30 Y+0 FMAX"
    );
    let moves = clean(&blocks, "");
    let of = |line: u32| moves.iter().filter(move |step| step.origin.line == line);
    near(end(of(6).next().expect("a move")), [2.0, 6.0]);
    near(end(of(7).next().expect("a move")), [60.0, 6.0]);
    // The tool is outside: the rounding of 10 mm is 14 mm on its path.
    let arc = moves.iter().find(|step| arc_of(step).is_some_and(|arc| (arc.1 - 14.0).abs() < 1e-6));
    near(arc_of(arc.expect("the rounding")).expect("an arc").0, [50.0, 40.0]);
    near(end(of(10).next_back().expect("a move")), [10.0, 54.0]);
}

/// A keyhole of two circles and two parallel lines, at whose blocks several contours fit.
const KEYHOLE: &str = "FPOL X+30 Y+30
10 FC DR- R30 CCX+30 CCY+30
11 FL AN+60 PDX+30 PDY+30 D10
12 FSELECT a
13 FC DR- R20 CCPR+55 CCPA+60
14 FSELECT b
15 FL AN-120 PDX+30 PDY+30 D10
16 FSELECT c
17 FC X+0 DR- R30 CCX+30 CCY+30
18 FSELECT d";

fn keyhole(selections: [u32; 4], settings: &str) -> Vec<Command> {
    let mut contour = KEYHOLE.to_string();
    for (name, number) in ["a", "b", "c", "d"].into_iter().zip(selections) {
        contour = contour.replace(&format!("FSELECT {name}"), &format!("FSELECT {number}"));
    }
    clean(&format!("{TOOL}L X+0 Y+30 F100\n{contour}\nL X+30 Y+30 FMAX"), settings)
}

/// Up on the left, where the line leaves the large circle and meets the small one; down on the right.
fn is_keyhole(moves: &[Command]) {
    let (sin, cos) = 60_f64.to_radians().sin_cos();
    let [large, small] = [[30.0, 30.0], [30.0 + 55.0 * cos, 30.0 + 55.0 * sin]];
    let point = |center: [f64; 2], radius: f64, side: f64, toward: f64| {
        let along = toward * (radius * radius - 100.0_f64).sqrt();
        [center[0] + along * cos - side * sin, center[1] + along * sin + side * cos]
    };
    let own: Vec<&Command> =
        moves.iter().filter(|step| (8..=15).contains(&step.origin.line)).collect();
    let expected = [
        (point(large, 30.0, 10.0, 1.0), Some(large)),
        (point(small, 20.0, 10.0, -1.0), None),
        (point(small, 20.0, -10.0, -1.0), Some(small)),
        (point(large, 30.0, -10.0, 1.0), None),
    ];
    assert_eq!(own.len(), 5, "{own:#?}");
    for (step, (to, center)) in own.iter().zip(expected) {
        near(end(step), to);
        if let Some(center) = center {
            let (found, _, sweep) = arc_of(step).expect("an arc");
            near(found, center);
            assert!(sweep < 0.0);
        }
    }
    let last = arc_of(own[4]).expect("an arc");
    near(last.0, large);
    assert!(end(own[4])[0].abs() < TOLERANCE_MM);
}

#[test]
fn solutions_are_selected_by_their_numbers() {
    is_keyhole(&keyhole([3, 2, 3, 2], "free_contour_order = \"along\""));
    // In the other order the contour that turns least comes first: the arc to the first line by 101 degrees and a corner
    // of 70, those to the second line by 120, 180, 300 and 360 degrees, of which the third is the keyhole's.
    is_keyhole(&keyhole([1, 2, 3, 2], ""));
}

#[test]
fn words_refer_to_blocks_by_their_numbers() {
    let blocks = format!(
        "{TOOL}L X+0 Y+0 F100
12 FPOL X+10 Y+10
13 FL PR+20 PA+20
14 FL AN+45 LEN5
15 FL IX+20 IY-3 RX 13 RY13
16 FL IPR+35 PA+0 RPR 13
17 FL LEN20 AN+15
18 FL IAN+90 RAN N17 LEN 12.5
19 FL PAR 17 DP12.5 LEN8
20 FSELECT 2
21 FL LEN 20 IAN+95
22 FC DR- R10 ICCX+20 ICCY-15 RCCX16 RCCY17 P1X+300 P1Y+300
L X+0 Y+0 R0 FMAX"
    );
    // The arc has no end: said where it is, with what the others are.
    let record = run(&blocks, "");
    assert!(
        record.errors.iter().any(|error| error.message.contains("contradict")),
        "{record:?}",
        record = record.errors
    );
    let without: String = blocks
        .lines()
        .filter(|line| !line.starts_with("22"))
        .fold(String::new(), |text, line| text + line + "\n");
    let moves = clean(&without, "");
    let at = |block: u32| {
        let line = without.lines().position(|line| line.starts_with(&format!("{block} ")));
        let line = line.expect("a block") as u32 + 2;
        end(moves.iter().rfind(|step| step.origin.line == line).expect("a move"))
    };
    let (sin, cos) = 20_f64.to_radians().sin_cos();
    let first = [10.0 + 20.0 * cos, 10.0 + 20.0 * sin];
    near(at(13), first);
    near(at(15), [first[0] + 20.0, first[1] - 3.0]);
    near(at(16), [10.0 + 55.0, 10.0]);
    let along = |from: [f64; 2], degrees: f64, by: f64| {
        [from[0] + by * degrees.to_radians().cos(), from[1] + by * degrees.to_radians().sin()]
    };
    let p17 = along([65.0, 10.0], 15.0, 20.0);
    let p18 = along(p17, 105.0, 12.5);
    near(at(17), p17);
    near(at(18), p18);
    let p19 = along(p18, 195.0, 8.0);
    near(at(19), p19);
    near(at(21), along(p19, 290.0, 20.0));
}

#[test]
fn several_contours_are_said_with_their_numbers_and_points() {
    let blocks = format!(
        "{TOOL}L X+0 Y+0 F100
7 FC DR+ CCX+10 CCY+0
8 FL AN+90 X+12 Y+50
L X+0 Y+0 R0 FMAX"
    );
    let record = run(&blocks, "");
    let error = record.errors.first().expect("an error");
    assert!(error.message.contains("2 contours fit"), "{error:?}");
    assert!(error.message.contains("1: X12 Y-9.798 about X10 Y0, X12 Y50"), "{error:?}");
    assert!(error.message.contains("2: X12 Y9.798 about X10 Y0"), "{error:?}");
    let help = format!("{error:?}");
    assert!(help.contains("FSELECT"), "{help}");
    // With FSELECT the run is clean, and goes to the selected point.
    let selected = blocks.replace("Y+50\n", "Y+50\nFSELECT 2\n");
    let moves = clean(&selected, "");
    assert!(moves.iter().any(|step| distance(end(step), [12.0, 96_f64.sqrt()]) < TOLERANCE_MM));
    // A number that does not exist.
    let beyond = run(&blocks.replace("Y+50\n", "Y+50\nFSELECT 3\n"), "");
    assert!(
        beyond.errors.iter().any(|error| error.message.contains("solution 3")),
        "{:?}",
        beyond.errors
    );
}

/// The first block after which FSELECT must choose is named, with what is known there.
#[test]
fn the_block_of_the_first_choice_is_named() {
    let without: String = KEYHOLE
        .lines()
        .filter(|line| !line.contains("FSELECT"))
        .fold(String::new(), |text, line| text + line + "\n");
    let record = run(&format!("{TOOL}L X+0 Y+30 F100\n{without}L X+30 Y+30 FMAX"), "");
    let error = record.errors.first().expect("an error");
    assert!(error.message.contains("4 contours fit"), "{error:?}");
    let text = format!("{TOOL}L X+0 Y+30 F100\n{without}");
    let span = error.primary.span.range;
    let shown = span.slice(format!("BEGIN PGM A MM\n{text}").as_bytes()).to_vec();
    assert_eq!(shown, b"11 FL AN+60 PDX+30 PDY+30 D10");
    assert!(error.message.contains("a point at 60 degrees"), "{error:?}");
    // Parallel lines in both directions: of the second nothing but its direction is known.
    let parallel = "7 FL AN+15 LEN20\n8 FL IAN+90 LEN 12.5\n9 FL PAR 7 DP12.5 LEN8";
    let record = run(&format!("{TOOL}L X+0 Y+0 F100\n{parallel}\nL X+0 Y+0 FMAX"), "");
    let error = record.errors.first().expect("an error");
    assert!(error.message.contains("2 contours fit"), "{error:?}");
}

#[test]
fn what_is_missing_is_said() {
    let said = |block: &str, words: &str| {
        let record =
            run(&format!("{TOOL}L X+0 Y+0 F100\n7 FL X+5 Y+5\n{block}\nL X+0 Y+0 R0 FMAX"), "");
        let found = record.errors.iter().any(|error| error.message.contains(words));
        assert!(found, "{block}: {:#?}", record.errors);
    };
    said("8 FL AN+30 LEN5 P1X+3", "needs both X and Y");
    said("8 FL AN+30 LEN5 PDX+3 PDY+4", "need the distance D");
    said("8 FL AN+30 LEN5 D4", "needs the point PDX and PDY");
    said("8 FC R5 X+9 Y+9", "no direction DR");
    said("8 FL IX+3 Y+1 RX 99", "block number 99");
    said("8 FL P1PR+3 P1PA+10 LEN5", "needs the pole FPOL");
    said("8 FL PAR LEN5", "no block number");
    said("8 FL P4X+3 LEN5", "is no point of a free contour");
}
