//! Comparisons of programs: what is a difference and what is not.

use chordal::{Job, Machine, Source, SourceMap};
use chordal_compare::{
    Category, Comparison, ComparisonOptions, ComparisonVerdict, DifferenceValue, compare,
};

fn job<'a>(name: &str, machine: &str, text: &'a str) -> Job<'a> {
    let mut sources = SourceMap::new();
    sources.add(Source::new(name, text.as_bytes()));
    Job::new(sources, Machine::from_builtin(machine).unwrap()).unwrap()
}

fn held(a: &str, b: &str, options: &ComparisonOptions) -> Comparison {
    compare(&job("a.nc", "haas-vf2", a), &job("b.nc", "haas-vf2", b), options)
}

fn plain(a: &str, b: &str) -> Comparison {
    held(a, b, &ComparisonOptions::default())
}

fn lines(found: &Comparison, at: usize) -> [(u32, u32); 2] {
    found.differences[at].blocks.map(|blocks| blocks.unwrap().lines())
}

fn only(found: &Comparison, category: Category) -> &chordal_compare::Difference {
    assert_eq!(found.verdict, ComparisonVerdict::Different);
    let categories: Vec<_> = found.differences.iter().map(|one| one.category).collect();
    assert_eq!(categories, [category], "{:#?}", found.differences);
    &found.differences[0]
}

const PART: &str = "\
G21 G90 G17 G54
T1 M6
S3000 M3
G43 H1 Z10.
G0 X0 Y0
M8
G1 Z-2. F200.
X40. F600.
G3 X50. Y10. I0 J10.
G1 Y30.
X0
Y0
G0 Z10.
M9
M30
";

/// The same part programmed differently: other block numbers, spaces, R instead of the centre, increments, divided
/// lines and arcs, the contour in a subprogram.
const OTHERWISE: &str = "\
N5 G54 G17 G90 G21
N10 T01 M06
(rough)
N15 M03 S3000
N20 G43 H01 Z10.
N25 G00 X0. Y0.
N30 M08
N35 G01 Z-2. F200.
N40 M97 P100
N45 G00 Z10.
N50 M09
N55 M30
N100 G91 X15. F600.
X25.
G90 G03 X47.07106781186548 Y2.92893218813452 R10.
X50. Y10. R10.
G01 Y30. X50.
X0.
Y12.
Y0.
M99
";

#[test]
fn a_program_is_the_same_as_itself() {
    let found = plain(PART, PART);
    assert_eq!(found.verdict, ComparisonVerdict::Same);
    assert_eq!(found.max_distance_mm, Some(0.0));
    assert_eq!(found.moves[0], found.moves[1]);
    assert!(found.farthest.is_none());
}

#[test]
fn other_words_for_the_same_motion() {
    let found = plain(PART, OTHERWISE);
    assert_eq!(found.verdict, ComparisonVerdict::Same, "{:#?}", found.differences);
    assert!(found.max_distance_mm.unwrap() < 1e-9);
    // 7 lines and an arc, compared with divided lines and a divided arc.
    assert!(found.moves[1] > found.moves[0]);
}

#[test]
fn inches_are_millimetres() {
    let mm = "G21 G90\nG0 X0 Y0 Z5.08\nG1 Z0 F254.\nX25.4\nG2 X50.8 Y25.4 I0 J25.4\nG1 X0\nM30\n";
    let inch = "G20 G90\nG0 X0 Y0 Z.2\nG1 Z0 F10.\nX1.\nG2 X2. Y1. I0 J1.\nG1 X0\nM30\n";
    let found = plain(mm, inch);
    assert_eq!(found.verdict, ComparisonVerdict::Same, "{:#?}", found.differences);
}

#[test]
fn a_digit_of_a_coordinate() {
    let found = plain(PART, &PART.replace("X0\nY0\n", "X.1\nY0\n"));
    let one = only(&found, Category::Path);
    assert!((one.distance_mm.unwrap() - 0.1).abs() < 1e-9, "{one:?}");
    // The line to the point, the line from it, and the rapid after that.
    assert_eq!(lines(&found, 0), [(11, 13), (11, 13)]);
    assert_eq!(one.steps, [3, 3]);
}

#[test]
fn an_arc_that_leaves_its_circle_is_another_path_and_a_problem() {
    let found = plain(PART, &PART.replace("X40. F600.", "X40.1 F600."));
    let path = found.differences.iter().find(|one| one.category == Category::Path).unwrap();
    // The end of the line moves by 0.1 mm along the line, and the arc with it by less.
    assert!(path.distance_mm.unwrap() > 0.01 && path.distance_mm.unwrap() < 0.1, "{path:?}");
    let problem = found.differences.iter().find(|one| one.category == Category::Problem).unwrap();
    assert_eq!((problem.steps, problem.blocks[1].unwrap().lines()), ([0, 1], (9, 9)));
}

#[test]
fn a_corner_moved_by_a_quarter() {
    let found = plain(PART, &PART.replace("G1 Y30.", "G1 Y30.25"));
    let one = only(&found, Category::Path);
    assert!((one.distance_mm.unwrap() - 0.25).abs() < 1e-9, "{one:?}");
    // The line to the corner, and the lines after it.
    assert_eq!(lines(&found, 0), [(10, 12), (10, 12)]);
}

#[test]
fn within_the_tolerance() {
    let other = PART.replace("G1 Y30.", "G1 Y30.002");
    let options = ComparisonOptions { tolerance_mm: 0.005, ..ComparisonOptions::default() };
    let found = held(PART, &other, &options);
    assert_eq!(found.verdict, ComparisonVerdict::Within);
    assert!((found.max_distance_mm.unwrap() - 0.002).abs() < 1e-9);
    assert_eq!(found.farthest.map(|at| at.map(|place| place.line)), Some([10, 10]));
    let options = ComparisonOptions { tolerance_mm: 0.001, ..ComparisonOptions::default() };
    assert_eq!(held(PART, &other, &options).verdict, ComparisonVerdict::Different);
}

#[test]
fn everything_shifted_is_told_as_a_shift() {
    let one = "G21 G90\nG0 X0 Y0 Z0\nG1 X10. F100.\nG91\nX10.\nY5.\nX-10.\nY-5.\nM30\n";
    let other = one.replace("G1 X10. F100.", "G1 X10.5 F100.");
    let found = plain(one, &other);
    let difference = only(&found, Category::Path);
    assert!((difference.distance_mm.unwrap() - 0.5).abs() < 1e-9, "{difference:?}");
    assert_eq!(lines(&found, 0), [(3, 8), (3, 8)]);
    assert_eq!(difference.shift_mm, None);
}

#[test]
fn the_other_way_round_is_another_path() {
    let ccw = "G21 G90\nG0 X10. Y0 Z0\nG3 X-10. Y0 I-10. F100.\nM30\n";
    let found = plain(ccw, &ccw.replace("G3", "G2"));
    let one = only(&found, Category::Path);
    // Half circles on the two sides of their diameter, 20 mm apart in the middle.
    assert!((one.distance_mm.unwrap() - 20.0).abs() < 1e-5, "{one:?}");
}

#[test]
fn an_arc_and_its_chords() {
    let arc = "G21 G90\nG0 X10. Y0 Z0\nG3 X0 Y10. I-10. F100.\nM30\n";
    let mut chords = String::from("G21 G90\nG0 X10. Y0 Z0\nG1 F100.\n");
    for i in 1..=20 {
        let angle = f64::from(i) * std::f64::consts::FRAC_PI_2 / 20.0;
        chords += &format!("X{:.9} Y{:.9}\n", 10.0 * angle.cos(), 10.0 * angle.sin());
    }
    chords += "M30\n";
    // Each chord deviates from the arc by r(1 − cos(π/80)) = 7.709 µm.
    let sagitta = 10.0 * (1.0 - (std::f64::consts::PI / 80.0).cos());
    let options = ComparisonOptions { tolerance_mm: 0.01, ..ComparisonOptions::default() };
    let found = held(arc, &chords, &options);
    assert_eq!(found.verdict, ComparisonVerdict::Within, "{:#?}", found.differences);
    let most = found.max_distance_mm.unwrap();
    assert!(most >= sagitta - 1e-6 && most < sagitta * 1.02, "{most} against {sagitta}");
    let options = ComparisonOptions { tolerance_mm: 0.007, ..ComparisonOptions::default() };
    assert_eq!(held(arc, &chords, &options).verdict, ComparisonVerdict::Different);
}

#[test]
fn a_feed() {
    let found = plain(PART, &PART.replace("F600.", "F650."));
    let one = only(&found, Category::Feed);
    assert_eq!(found.max_distance_mm, Some(0.0));
    let Some([DifferenceValue::Feed(a), DifferenceValue::Feed(b)]) = one.values.clone() else {
        panic!("{one:?}")
    };
    assert!((a - 10.0).abs() < 1e-9 && (b - 650.0 / 60.0).abs() < 1e-9);
    assert_eq!(lines(&found, 0), [(8, 12), (8, 12)]);
    assert_eq!(one.steps, [5, 5]);
}

#[test]
fn a_spindle_a_tool_an_offset_a_coolant() {
    for (from, to, category) in [
        ("S3000", "S3001", Category::Spindle),
        ("M3", "M4", Category::Spindle),
        ("T1", "T2", Category::Tool),
        ("H1", "H2", Category::LengthOffset),
        ("G54", "G55", Category::WorkOffset),
        ("M8", "M88", Category::Coolant),
        ("M30", "M0\nM30", Category::Stop),
        ("M9\n", "G4 P1.5\nM9\n", Category::Dwell),
        ("G1 Y30.", "G0 Y30.", Category::Rapid),
    ] {
        let found = plain(PART, &PART.replacen(from, to, 1));
        assert_eq!(found.verdict, ComparisonVerdict::Different, "{from} {to}");
        let categories: Vec<_> = found.differences.iter().map(|one| one.category).collect();
        assert!(categories.contains(&category), "{from} {to}: {:#?}", found.differences);
        assert_eq!(found.max_distance_mm, Some(0.0), "{from} {to}");
    }
}

#[test]
fn a_move_more() {
    let found = plain(PART, &PART.replace("G0 Z10.\nM9", "G0 Z10.\nX-30. Y0\nM9"));
    let one = only(&found, Category::Path);
    assert_eq!(one.steps, [0, 1]);
    assert!((one.distance_mm.unwrap() - 30.0).abs() < 1e-9);
    assert_eq!(lines(&found, 0)[1], (14, 14));
    // It is missing after line 13 of the other program.
    assert_eq!(lines(&found, 0)[0], (13, 13));
}

#[test]
fn two_pockets_in_another_order() {
    let pocket = |x: f64| format!("G0 X{x:.1} Y0\nG1 Z-1. F100.\nX{:.1}\nY5.\nG0 Z5.\n", x + 9.0);
    let (one, two, three) = (pocket(0.0), pocket(20.0), pocket(40.0));
    let program = |parts: [&str; 3]| {
        format!("G21 G90\nG0 X0 Y0 Z5.\n{}{}{}G0 X0 Y0\nM30\n", parts[0], parts[1], parts[2])
    };
    let a = program([&one, &two, &three]);
    let b = program([&one, &three, &two]);
    let found = plain(&a, &b);
    assert_eq!(found.verdict, ComparisonVerdict::Different);
    assert!(found.max_distance_mm.unwrap() > 1.0);
    assert!(found.differences.iter().any(|one| one.category == Category::Order));
}

#[test]
fn an_error_that_only_one_has() {
    let found = plain(PART, &PART.replace("I0 J10.", "I0 J12."));
    let problem = found.differences.iter().find(|one| one.category == Category::Problem).unwrap();
    assert_eq!(problem.steps, [0, 1]);
    assert_eq!(problem.blocks[1].unwrap().lines(), (9, 9));
}

#[test]
fn nothing_against_something() {
    let found = plain("", PART);
    assert_eq!(found.verdict, ComparisonVerdict::Different);
    let found = plain("", "");
    assert_eq!(found.verdict, ComparisonVerdict::Same);
    assert_eq!(found.max_distance_mm, None);
}

/// One program on two controls: G90 G91 in one line and arcs have the same effect; only the machines differ.
#[test]
fn one_program_on_two_machines() {
    let text = "G20 G90\nG0 X0 Y0 Z.1\nG1 Z-.1 F10.\nX1.\nG3 X2. Y1. I0 J1.\nM2\n";
    let options = ComparisonOptions::default();
    let found = compare(&job("a", "fanuc-6m", text), &job("a", "haas-vf2", text), &options);
    assert!(found.max_distance_mm.unwrap() < 1e-9, "{:#?}", found.differences);
}

/// One turn at a time or all at once: points that are passed several times must not confuse the traversal.
#[test]
fn turns_of_a_helix_in_pieces() {
    let head = "G21 G90 S100 M3\nG0 X10. Y0 Z0\nG1 F100.\n";
    let whole = format!("{head}G3 X10. Y0 Z-6. I-10. P3\nG3 I-10. P2\nM30\n");
    let turns =
        format!("{head}G3 Z-2. I-10.\nG3 Z-4. I-10.\nG3 Z-6. I-10.\nG3 I-10.\nG3 I-10.\nM30\n");
    let jobs = [&whole, &turns].map(|text| job("a.nc", "mitsubishi-m700", text));
    let found = compare(&jobs[0], &jobs[1], &ComparisonOptions::default());
    assert_eq!(found.verdict, ComparisonVerdict::Same, "{:#?}", found.differences);
}

/// A rapid of two legs that rounding reduces to one: legs must be paired with legs and not with a cut.
#[test]
fn rounding_makes_no_difference_within_the_tolerance() {
    let head = "G21 G90 S100 M3\nG0 X0 Y0 Z2.\n";
    let a = format!("{head}G0 X10. Y10.\nG1 Z-3. F100.\nG0 Z2.\nM30\n");
    let b = format!("{head}G0 X10. Y10.001\nG1 Z-3. F100.\nG0 Z2.\nM30\n");
    let within = ComparisonOptions { tolerance_mm: 0.002, ..ComparisonOptions::default() };
    let found = held(&a, &b, &within);
    assert_eq!(found.verdict, ComparisonVerdict::Within, "{:#?}", found.differences);
    assert!(found.max_distance_mm.unwrap() <= 0.0011);
}

/// Compares the programmed contours, independent of the corner behaviour of the controls.
#[test]
fn contours_as_programmed() {
    let text =
        "G20 G90 S100 M3\nG0 X-1. Y-1. Z0\nG1 G41 D1 X0 F10.\nY1.\nX2.\nY0\nX-1.\nG40 Y-1.\nM30\n";
    let jobs = ["fadal-4020", "fanuc-6m"].map(|name| {
        let mut machine = Machine::from_builtin(name).unwrap();
        machine.set("tools.1.diameter=\"10 mm\"").unwrap();
        let mut sources = SourceMap::new();
        sources.add(Source::new("a.nc", text.as_bytes()));
        Job::new(sources, machine).unwrap()
    });
    let center = compare(&jobs[0], &jobs[1], &ComparisonOptions::default());
    assert!(center.max_distance_mm.unwrap() > 1.0, "an arc on one, two lines on the other");
    let programmed = ComparisonOptions {
        programmed: true,
        ignored: vec![Category::PathMode, Category::RapidPath],
        ..ComparisonOptions::default()
    };
    let contour = compare(&jobs[0], &jobs[1], &programmed);
    assert_eq!(contour.verdict, ComparisonVerdict::Same, "{:#?}", contour.differences);
}

/// Without a known position, both are assumed to start at the same one.
#[test]
fn increments_from_anywhere() {
    let text = "G21 G91 S100 M3\nG1 X10. F100.\nY5.\nM30\n";
    assert_eq!(plain(text, text).max_distance_mm, Some(0.0));
    let found = plain(text, &text.replace("Y5.", "Y5.5"));
    let path = only(&found, Category::Path);
    assert!((path.distance_mm.unwrap() - 0.5).abs() < 1e-9, "{path:?}");
}

#[test]
fn a_difference_says_where_to_look() {
    let longer = PART.replace("Y30.", "Y30.4");
    let found = plain(PART, &longer);
    let path = only(&found, Category::Path);
    // Both corners of the longer side are 0.4 mm off.
    let [a, b] = path.at_mm.unwrap();
    assert!((b[1] - a[1] - 0.4).abs() < 1e-9 && a[0] == b[0], "{a:?} {b:?}");
    assert_eq!((a[1], a[2]), (30.0, -2.0));
    assert_eq!(found.farthest_at_mm, path.at_mm);
    // When only one of the two moves, the other stands still.
    let detour = PART.replace("Y30.\n", "Y30.\nX60.\nX50.\n");
    let found = plain(&detour, PART);
    assert_eq!(found.farthest_at_mm, Some([[60.0, 30.0, -2.0], [50.0, 30.0, -2.0]]));
    // Equal paths have no such point.
    assert_eq!(plain(PART, PART).farthest_at_mm, None);
}

#[test]
fn a_run_that_is_given_up_has_nothing_to_tell() {
    let long = "G21 G90 G54\nG0 X0 Y0 Z5.\nG1 Z0 F100.\n".to_string() + &"X1.\nX0\n".repeat(50_000);
    let other = long.replace("X1.", "X2.");
    let [a, b] = [&long, &other].map(|text| job("a.nc", "haas-vf2", text));
    let b = b.interrupt(std::sync::Arc::new(|| true));
    let found = compare(&a, &b, &ComparisonOptions::default());
    assert_eq!((found.max_distance_mm, found.differences.len()), (None, 0));
}

#[test]
fn splines_as_far_apart_as_their_control_points_and_their_chords() {
    let on = |a: &str, b: &str, options: &ComparisonOptions| {
        compare(&job("a.nc", "linuxcnc-mill", a), &job("b.nc", "linuxcnc-mill", b), options)
    };
    let text = "G21 G90 G17 S900 M3 F600\nG0 X0 Y0 Z0\nG5 I0 J30 P0 Q-30 X10 Y10\nM2\n";
    let plain = ComparisonOptions::default();
    assert_eq!(on(text, text, &plain).verdict, ComparisonVerdict::Same);
    // The same curve as a NURBS of order 4.
    let nurbs = text
        .replace("G5 I0 J30 P0 Q-30 X10 Y10", "G5.2 X0 Y30 P1 L4\nX10 Y-20 P1\nX10 Y10 P1\nG5.3");
    assert_eq!(on(text, &nurbs, &plain).verdict, ComparisonVerdict::Same);
    let moved = text.replace("J30", "J31");
    let found = on(text, &moved, &plain);
    assert_eq!(found.verdict, ComparisonVerdict::Different);
    // At most the distance of the control points, and at least that of the curves, 4/9 mm at t = 1/3.
    let far = found.max_distance_mm.unwrap();
    assert!(far > 0.3 && far <= 1.0, "{far}");
}
