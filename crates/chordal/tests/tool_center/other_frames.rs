//! Frames of the tip that stay, the length along the tool, the error of a clamped part, and cuts in which the tool swings.

use super::*;

const START_TIP: &str = "G21 G90 G17 G94\nT1 M6\nS5000 M3\nG54 G0 X10. Y0 A0 C0\nG43.4 H1 Z20.\n";

fn last_end(own: &str, text: &str) -> [f64; 6] {
    let job = job(machine(own), text);
    clean(&job);
    *ends(&job, 1e-3).last().expect("moves")
}

/// The only problem of a code: its text.
fn told(own: &str, text: &str, code: Code) -> Option<String> {
    let found = job(machine(own), text).check().diagnostics;
    let told: Vec<_> = found.into_iter().filter(|found| found.code == code).collect();
    assert!(told.len() < 2, "{told:?}");
    let told = told.into_iter().next()?;
    Some(format!("{} / {} / {}", told.message, told.primary.text, told.alarm.unwrap_or_default()))
}

#[test]
fn a_frame_that_stays_gives_the_end_after_the_turn() {
    let stays = format!("{TRUNNION}[settings]\n'No. 19696#5' = '1'\n");
    // The axes of the machine go to the coordinates themselves, however the tables have turned. Y, which the last block does
    // not name, is where it was.
    for moves in
        ["G1 X10. Y5. Z20. A30. C45. F500.\n", "G1 Y5. A10. F500.\nG1 X10. Z20. A30. C45.\n"]
    {
        let text = format!("{START_TIP}{moves}G49\nM30\n");
        assert_near(&last_end(&stays, &text), [-290.0, -195.0, -260.0]);
    }
    // On the way the tip goes straight on the part, so that the axes bend: with 10 mm around the centre of C to 90 degrees
    // the tip goes from part X10 Y0 to X0 Y10, and is 7.07 mm from the centre in the middle.
    let text = format!("{START_TIP}G1 X10. Y0 C90. F500.\nM30\n");
    let job = job(machine(&stays), &text);
    clean(&job);
    let nearest = ends(&job, 1e-3)
        .iter()
        .map(|end| (end[0] + 300.0).hypot(end[1] + 200.0))
        .fold(9e9, f64::min);
    assert!((nearest - 10.0 / 2.0_f64.sqrt()).abs() < 0.01, "{nearest}");
}

#[test]
fn what_a_frame_that_stays_refuses() {
    let stays = format!("{TRUNNION}[settings]\n'No. 19696#5' = '1'\n");
    let by_vector = START_TIP.replace("G43.4", "G43.5");
    let found = told(&stays, &format!("{by_vector}M30\n"), Code::ToolVector);
    assert!(found.is_some_and(|text| text.contains("PS5459")));
    let arc = |word: &str| format!("{START_TIP}G3 X0. Y10. I-10. J0 {word} F500.\nM30\n");
    let found = told(&stays, &arc("A10."), Code::RotaryInArc);
    assert!(found.is_some_and(|text| text.contains("while A turns") && text.contains("PS5421")));
    assert_eq!(told(&stays, &arc("C10."), Code::RotaryInArc), None);
    assert!(told(&stays, &arc("C10."), Code::NotFollowed).is_some());
    assert_eq!(told(&stays, &arc(""), Code::NotFollowed), None);
}

/// Heads A and B 200 mm above the gauge point.
const TWO_HEADS: &str = "inherits = 'haas-vf2'
[axes.A]
[axes.B]
[rotary.B]
turns = 'head'
point = { X = '0 mm', Z = '200 mm' }
[rotary.A]
turns = 'head'
on = 'B'
point = { Y = '0 mm', Z = '200 mm' }
";

const START_HEADS: &str = "G21 G90 G17 G94\nT1 M6\nS5000 M3\nG54 G0 A0. B0.\n";

#[test]
fn the_length_acts_along_the_tool() {
    // The length alone, without the pivot: 100 mm along (sin 30, 0, cos 30).
    let begin = "G143 H1 X0. Y0. Z50. A0. B30.\n";
    let at = [-250.0, -200.0, -330.0 + 86.602_54];
    let text = format!("{START_HEADS}{begin}M30\n");
    assert_near(&last_end(TWO_HEADS, &text), at);
    // An axis that is not named stands; one that is named goes to its place with the heads as they stand.
    let text = format!("{START_HEADS}{begin}G1 B0. F500.\nM30\n");
    assert_near(&last_end(TWO_HEADS, &text), at);
    let text = format!("{START_HEADS}{begin}G1 B0. F500.\nG1 X0.\nM30\n");
    assert_near(&last_end(TWO_HEADS, &text), [-300.0, at[1], at[2]]);
    let text = format!("{START_HEADS}{begin}G49 G1 X0. Y0. Z50. F500.\nM30\n");
    let end = *ends(&job(machine(TWO_HEADS), &text), 1e-3).last().expect("moves");
    assert_near(&end, [-300.0, -200.0, -330.0]);
}

#[test]
fn what_the_length_along_the_tool_refuses() {
    let begin = "G143 H1 X0. Y0. Z50. A0. B30.\n";
    for (moves, message) in [
        ("G91 G143 H1 X1. Y0. Z1. A0. B1.\n".to_string(), "G143 in G91"),
        (format!("{begin}G91 G1 X1. Y0 Z0 A0 B1. F500.\nX1.\n"), "a move under G143 in G91"),
        (format!("{begin}G2 X10. Y0. I5. J0. F500.\n"), "an arc under G143"),
        (format!("{begin}G81 X10. Y0. Z-5. R2. F500.\n"), "a canned cycle under G143"),
    ] {
        let text = format!("{START_HEADS}{moves}M30\n");
        let found = told(TWO_HEADS, &text, Code::LengthAlongTool);
        assert!(found.as_ref().is_some_and(|found| found.starts_with(message)), "{found:?}");
    }
    let tables = "inherits = 'haas-umc750'\n";
    let text = "G21 G90 G17 G94\nT1 M6\nS5000 M3\nG54 G0 X0. Y0.\nG143 H1 Z50.\nM30\n";
    let found = told(tables, text, Code::LengthAlongTool);
    let axes = "this machine has B, which turns the table, and C, which turns the table";
    assert!(found.as_ref().is_some_and(|found| found.contains(axes)), "{found:?}");
}

/// The same error of the part, measured at C0 and at C90.
const FIXTURES: &str = "
[work_offsets.'G54.2 P1']
X = '1 mm'
Y = '0.5 mm'
Z = '0 mm'
[work_offsets.'G54.2 P2']
X = '0.5 mm'
Y = '-1 mm'
Z = '0 mm'
C = '90 deg'
";

#[test]
fn the_error_of_a_clamped_part_turns_with_the_tables() {
    let own = format!("{TRUNNION}{FIXTURES}");
    let start = "G21 G90 G17 G94\nT1 M6\nS5000 M3\nG54 G0 X0. Y0. C0.\nG43 H1 Z20.\n";
    for (moves, at) in [
        ("G54.2 P1\nX10. Y0.\n", [-289.0, -199.5]),
        ("G54.2 P2\nX10. Y0.\n", [-289.0, -199.5]),
        ("C90.\nG54.2 P1\nX10. Y0.\n", [-289.5, -201.0]),
        ("C90.\nG54.2 P2\nX10. Y0.\n", [-289.5, -201.0]),
        // Tables that turn while it is on take it along.
        ("G54.2 P1\nX10. Y0.\nC90.\n", [-289.5, -201.0]),
        ("G54.2 P1\nX10. Y0. C90.\n", [-289.5, -201.0]),
        ("G54.2 P1\nX10. Y0.\nG28 G91 C0.\nG90 X10. Y0.\n", [-289.0, -199.5]),
        ("G54.2 P1\nX10. Y0.\nG54.2 P0\nX10. Y0.\n", [-290.0, -200.0]),
    ] {
        let end = last_end(&own, &format!("{start}{moves}M30\n"));
        assert_near(&end, [at[0], at[1], -260.0]);
    }
    let text = format!("{start}G54.2 P3\nX10. Y0.\nM30\n");
    let found = told(&own, &text, Code::OffsetNotSet);
    assert!(found.is_some_and(|found| found.contains("G54.2 P3")));
}

#[test]
fn a_tool_that_swings_in_a_cut_is_told() {
    // A tilts by 30 degrees to one side at most: to 35 degrees on the other side C turns by half a turn.
    let start = "G21 G90 G17 G94\nT1 M6\nS5000 M3\nG54 G0 X10. Y0 A20. C0\nG43.5 H1 Z20.\n";
    let moves = |motion: &str, vector: &str| format!("{start}{motion} X12. {vector} F500.\nM30\n");
    let other_side = "I0 J0.573576 K0.819152";
    let found = told(TRUNNION, &moves("G1", other_side), Code::SwingingTool).expect("a warning");
    assert!(found.contains("swings 27.5 deg"), "{found}");
    assert!(found.contains("A by 15 deg and C by") && found.contains("180 deg"), "{found}");
    assert_eq!(told(TRUNNION, &moves("G0", other_side), Code::SwingingTool), None);
    // To the side within travel, the tool stays in the plane.
    let near = "I0 J0.422618 K0.906308";
    assert_eq!(told(TRUNNION, &moves("G1", near), Code::SwingingTool), None);
}

#[test]
fn a_rotary_axis_that_cannot_keep_up_is_told() {
    let text = format!("{START_TIP}G1 X12. C180. F15000.\nM30\n");
    let found = told(TRUNNION, &text, Code::TipFeedTooFast).expect("a warning");
    assert!(found.contains("PS5422") && found.contains("10800 deg/min"), "{found}");
    // 180 degrees at 180 deg/s take a second: 2 mm in it are 120 mm/min.
    let text = format!("{START_TIP}G1 X12. C180. F119.\nM30\n");
    assert_eq!(told(TRUNNION, &text, Code::TipFeedTooFast), None);
}

#[test]
fn an_angle_beyond_a_turn_on_an_axis_that_rolls_over_by_sign() {
    let own = |control: &str| {
        format!("control = '{control}'\n[axes.C]\n[rotary.C]\nturns = 'table'\nrollover = 'sign'\n")
    };
    let text = "G21 G90 G17 G94\nT1 M6\nS5000 M3\nG54 G0 X10. Y0 C0\nC359.9\nC-400.\nM30\n";
    let found = told(&own("linuxcnc"), text, Code::BadWordValue).expect("an alarm");
    assert!(
        found.contains("-400 deg")
            && found.contains("Invalid absolute position -400.00 for wrapped rotary axis C"),
        "{found}"
    );
    assert_eq!(told(&own("fanuc"), text, Code::BadWordValue), None);
}
