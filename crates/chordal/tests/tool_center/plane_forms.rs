//! Planes by points, vectors, the tool and other planes, directions of the tool as vectors, origins on the tables and
//! rotations in space.

use super::*;

/// The tip of a plane of 30 degrees about X through X50, at X10 Y5 Z2 of it.
const IN_PLANE: [f64; 3] = [-240.0, -185.0, -280.6795];

fn last_end(own: &str, text: &str) -> [f64; 6] {
    let job = job(machine(own), text);
    // A block to a vector from the upright tool swings it; here only its end counts.
    clean_but(&job, &[Code::SwingingTool]);
    *ends(&job, 1e-3).last().expect("moves")
}

#[test]
fn one_plane_in_all_forms() {
    let points = "G68.2 P2 Q1 X50. Y0 Z0\nG68.2 P2 Q2 X60. Y0 Z0\nG68.2 P2 Q3 X50. Y866.025 Z500.";
    let vectors = "G68.2 P3 Q1 X50. Y0 Z0 I1. J0 K0\nG68.2 P3 Q2 I0 J-0.5 K0.8660254";
    for definition in [
        "G68.2 X50. Y0 Z0 I0 J30. K0",
        points,
        // In another order, through another origin, shifted back.
        "G68.2 P2 Q2 X60. Y0 Z0\nG68.2 P2 Q1 X45. Y0 Z0\nG68.2 P2 Q3 X50. Y866.025 Z500.\nG68.2 P2 Q0 X5. Y0 Z0 R0",
        vectors,
        "G68.2 X50. Y0 Z0 I0 J0 K0\nG68.4 X0 Y0 Z0 I0 J30. K0",
        "G68.2 X0 Y0 Z0 I0 J30. K0\nG68.4 P2 Q1 X50. Y0 Z0\nG68.4 P2 Q2 X51. Y0 Z0\nG68.4 P2 Q3 X50. Y1. Z0",
        "G0 A30.\nG68.3 X50. Y0 Z0",
        // A quarter turn, and back by the words.
        "G0 A30.\nG68.3 X50. Y0 Z0 R90.\nG68.4 X0 Y0 Z0 I0 J0 K-90.",
    ] {
        let text = format!("{UP}{definition}\nG53.1\nG1 X10. Y5. Z2. F500.\nG69\nM30\n");
        assert_near(&last_end(TRUNNION, &text), IN_PLANE);
    }
}

#[test]
fn a_plane_under_the_tool_begins_at_its_tip() {
    // The tip stands at work X0 Y0 Z100 with the table flat. At A30 it stands over another point of the part:
    // (0, 0, 120) from the axis of A turns by 30 degrees.
    let text = format!("{UP}G0 A30.\nG68.3\nG1 X0 Y0 Z0 F500.\nM30\n");
    let end = last_end(TRUNNION, &text);
    assert_near(&end, [-300.0, -200.0, -180.0]);
    assert!((end[3] - 30.0).abs() < 1e-9, "{end:?}");
}

#[test]
fn the_sign_of_the_tilt_is_chosen() {
    // The same plane with X along Y of the part.
    for (turn, angles, gauge) in [
        ("G53.1 P1", [30.0, 90.0], [-290.0, -228.3013, -255.6795]),
        ("G53.1 P2", [-30.0, -90.0], [-310.0, -171.6987, -255.6795]),
    ] {
        let plane = "G68.2 X50. Y0 Z0 I90. J30. K0";
        let text = format!("{UP}{plane}\n{turn}\nG1 X10. Y5. Z2. F500.\nM30\n");
        let end = last_end(TRUNNION, &text);
        assert!((end[3] - angles[0]).abs() < 1e-9 && (end[5] - angles[1]).abs() < 1e-9, "{end:?}");
        assert_near(&end, gauge);
    }
}

#[test]
fn the_direction_of_the_tool_as_a_vector() {
    let direction = "I0.3535534 J-0.3535534 K0.8660254";
    let moves = format!("G1 X10. Y0 Z20. {direction} F500.\n");
    let text = format!("{START}G43.5 H1 Z20.\n{moves}G49\nM30\n");
    let end = last_end(TRUNNION, &text);
    assert_near(&end, [-292.9289, -186.1237, -261.8234]);
    assert!((end[3] - 30.0).abs() < 1e-4 && (end[5] - 45.0).abs() < 1e-4, "{end:?}");
    // Only a vector: the tip stands. Without a vector the direction stays; letters that are left out are 0.
    for moves in [
        format!("G1 {direction} F500.\n"),
        format!("G1 {direction} F500.\nX10. Y0 Z20.\n"),
        format!("G1 J-0.5 K0.8660254 F500.\n{direction}\n"),
        format!("G0 {direction}\n"),
    ] {
        let text = format!("{START}G43.5 H1 Z20.\n{moves}G49\nM30\n");
        assert_near(&last_end(TRUNNION, &text), [-292.9289, -186.1237, -261.8234]);
    }
    // In a tilted plane the vector is one of the plane: its Z is upright on it.
    let text = format!(
        "{UP}G68.2 X50. Y0 Z0 I0 J30. K0\nG53.1\nG43.5 H1\nG1 X10. Y5. Z2. I0 J0 K1. F500.\nM30\n"
    );
    assert_near(&last_end(TRUNNION, &text), IN_PLANE);
}

#[test]
fn wrong_directions_of_the_tool() {
    for (moves, message) in [
        ("G1 X1. I0 J0 K0 F500.", "no direction"),
        ("G1 X1. A10. F500.", "a rotary axis while"),
        ("G1 X1. I0 J0 K-1. F500.", "cannot be reached"),
    ] {
        let text = format!("{START}G43.5 H1 Z20.\n{moves}\nM30\n");
        let found = job(machine(TRUNNION), &text).check().diagnostics;
        let told = found.iter().find(|found| found.code == Code::ToolVector);
        assert!(told.is_some_and(|found| found.message.contains(message)), "{found:?}");
    }
    // After G43.4 the letters are none of this mode.
    let text = format!("{START}G43.5 H1 Z20.\nG49\nG43.4 H1\nG1 X1. A10. F500.\nM30\n");
    clean(&job(machine(TRUNNION), &text));
}

#[test]
fn an_origin_on_the_tables() {
    let own = "inherits = 'haas-umc750'
[rotary.B]
point = { X = '-300 mm', Z = '-400 mm' }
[rotary.C]
point = { X = '-300 mm', Y = '-200 mm' }
";
    let start =
        "G21 G90 G17 G94\nT1 M6\nS5000 M3\nG54 G0 X10. Y0 B0 C0\nG10 L2 P1 X-290. Y-210. Z-380.\n";
    for (turn, expected) in [
        ("G0 B90. C0\nG254", [-319.0, -210.0, -288.0]),
        ("G0 B90. C90.\nG254", [-319.0, -210.0, -308.0]),
        ("G0 B90. C0\nG254\nG255\nG0 B0", [-289.0, -210.0, -278.0]),
    ] {
        let moves = "G0 X1. Y0\nZ20.\nG1 Z2. F500.\nM30\n";
        let text = format!("{start}G43 H1 Z100.\n{turn}\n{moves}");
        assert_near(&last_end(own, &text), expected);
    }
    let told = |lines: &str, severity: Severity, message: &str| {
        let text = format!("{start}G43 H1 Z100.\n{lines}\nM30\n");
        let job = job(machine(own), &text);
        let found = job.check().diagnostics;
        let found = found.iter().find(|found| found.message.contains(message));
        assert!(found.is_some_and(|found| found.severity == severity), "{lines}: {found:?}");
        *ends(&job, 1e-3).last().expect("moves")
    };
    let cut = "a cut after G254 before X and Y";
    told("G254\nG1 X1. Y0 F500.", Severity::Error, cut);
    told("G254\nG0 Z50.\nX1. Y0\nG1 X5. F500.", Severity::Error, cut);
    told("G254\nG234 H1 Z50.", Severity::Error, "G234 while the dynamic work offset is on");
    told("G254\nG254", Severity::Error, "G254 while the dynamic work offset is on already");
    told("G10 L2 P1 B5.\nG254", Severity::Error, "G254 with B at 5 deg in the work offset");
    // The axes stand while the table turns, and the origin rides on.
    let turning = "G254\nG0 X0 Y0\nZ50.\nB90.\nX1. Y0\nZ20.\nG1 Z2. F500.";
    let end = told(turning, Severity::Warning, "a rotary axis turns while");
    assert_near(&end, [-319.0, -210.0, -288.0]);
}

#[test]
fn a_rotation_in_space() {
    let text = format!("{UP}G68 X10. Y0 Z0 I0 J1. K0 R30.\nG1 X10. Y0 Z0 F500.\nG69\nM30\n");
    assert_near(&last_end(TRUNNION, &text), [-281.3397, -200.0, -285.0]);
    let text = format!(
        "{UP}G68 X10. Y0 Z0 I0 J1. K0 R30.\nG68 X5. Y0 Z0 I0 J0 K1. R90.\nG1 X0 Y10. Z0 F500.\nG69\nM30\n"
    );
    assert_near(&last_end(TRUNNION, &text), [-294.3301, -200.0, -277.5]);
}

#[test]
fn definitions_that_make_no_plane() {
    let fault = |lines: &str, alarm: &str, line: u32| {
        let text = format!("{UP}{lines}\nG1 X1. F100.\nM30\n");
        let job = job(machine(TRUNNION), &text);
        let report = job.check();
        let told = report
            .diagnostics
            .iter()
            .find(|found| found.alarm.as_ref().is_some_and(|text| text.contains(alarm)));
        let Some(told) = told else { panic!("{lines}: {:?}", report.diagnostics) };
        let before = &text[..told.primary.span.range.start as usize];
        assert_eq!(before.lines().count() as u32 + 1 - 5, line, "{lines}: {told:?}");
        assert!(!report.is_path_verified(), "{lines}");
    };
    // On a line; without Q3; a fourth point; vectors 84 degrees apart; a vector of length 0.
    fault("G68.2 P2 Q1 X0 Y0 Z0\nG68.2 P2 Q2 X1. Y1. Z1.\nG68.2 P2 Q3 X-3. Y-3. Z-3.", "PS5457", 1);
    fault("G68.2 P2 Q1 X0 Y0 Z0\nG68.2 P2 Q2 X1. Y1. Z1.", "PS5457", 1);
    fault("G68.2 P2 Q4 X0 Y0 Z0", "PS5457", 1);
    fault("G68.2 P3 Q1 X0 Y0 Z0 I1. J0 K0\nG68.2 P3 Q2 I0.104528 J0 K0.994522", "PS5457", 1);
    fault("G68.2 P3 Q1 X0 Y0 Z0 I0 J0 K0\nG68.2 P3 Q2 I0 J0 K1.", "PS5457", 1);
    fault("G68.2 P7 X0 Y0 Z0", "PS5457", 1);
    // A block between: the plane is made of what has come.
    fault(
        "G68.2 P2 Q1 X0 Y0 Z0\nG68.2 P2 Q2 X1. Y0 Z0\nG0 X3.\nG68.2 P2 Q3 X0 Y1. Z0",
        "PS5457",
        1,
    );
    let text = format!("{UP}G68.4 X0 Y0 Z0 I0 J30. K0\nM30\n");
    let found = job(machine(TRUNNION), &text).check().diagnostics;
    let alarms: Vec<_> = found.iter().filter_map(|found| found.alarm.clone()).collect();
    assert!(alarms.iter().any(|alarm| alarm.contains("PS5457")), "{found:?}");
}
