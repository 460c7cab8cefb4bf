//! The milling cycles with numbers computed by hand.

use chordal_geometry::TurnDirection;

use super::{MillStep, MillingContext, milling_moves};
use crate::cycles::tests::notation::arguments;

/// A mill of 10 in the spindle.
fn context() -> MillingContext {
    MillingContext { tool_radius: Some(5.0), ..MillingContext::default() }
}

/// The moves of a call, one a line: `r` rapid, `l` line, `cw` and `ccw` arcs with their centre, `@` the feed of the cycle.
fn moves(call: &str) -> Vec<String> {
    moves_in(call, &context())
}

fn moves_in(call: &str, context: &MillingContext) -> Vec<String> {
    let (name, list) = call.trim_end_matches(')').split_once('(').expect("a call");
    match milling_moves(name, &arguments(list), context) {
        Ok(moves) => moves.steps.iter().map(text).collect(),
        Err(fault) => vec![format!("{} at {:?}", fault.alarm, fault.parameter)],
    }
}

fn fault(call: &str) -> String {
    let moves = moves(call);
    assert_eq!(moves.len(), 1, "{moves:?}");
    moves[0].clone()
}

fn text(step: &MillStep) -> String {
    let numbers = |numbers: &[f64]| {
        let short: Vec<String> = numbers
            .iter()
            .map(|number| {
                let rounded = (number * 1e4).round() / 1e4;
                format!("{}", if rounded == 0.0 { 0.0 } else { rounded })
            })
            .collect();
        short.join(",")
    };
    let at = |feed: Option<f64>| feed.map_or(String::new(), |feed| format!("@{feed}"));
    match *step {
        MillStep::Rapid(to) => format!("r {}", numbers(&to)),
        MillStep::Line { to, feed } => format!("l {}{}", numbers(&to), at(feed)),
        MillStep::Arc { center, direction, to, turns, feed } => {
            let word = if direction == TurnDirection::Cw { "cw" } else { "ccw" };
            let more = if turns > 0 { format!(" +{turns}") } else { String::new() };
            format!("{word} {} to {}{more}{}", numbers(&center), numbers(&to), at(feed))
        }
        MillStep::SpindleSpeed(rpm) => format!("S{rpm:?}"),
    }
}

/// A pocket of 40 × 20 with corners of 6, tool radius 5: the tool's centre goes round at 15 × 5 with corners of 1; one loop
/// at 0.8 · 10 = 8 ≥ 5 from the middle line, which is 20 long.
#[test]
fn a_rectangular_pocket_level_by_level() {
    let found = moves("POCKET3(50,0,2,-8,40,20,6,100,50,0,4,0,0,300,100,0,11,0)");
    let expected = [
        "r 100,50,100",
        "r 100,50,50",
        "r 100,50,2",
        "l 100,50,-4@100",
        "l 90,50,-4@300",
        "l 110,50,-4@300",
        "l 115,50,-4@300",
        "l 115,54,-4@300",
        "ccw 114,54 to 114,55,-4@300",
        "l 86,55,-4@300",
        "ccw 86,54 to 85,54,-4@300",
        "l 85,46,-4@300",
        "ccw 86,46 to 86,45,-4@300",
        "l 114,45,-4@300",
        "ccw 114,46 to 115,46,-4@300",
        "l 115,50,-4@300",
        "r 115,50,-2",
        "r 100,50,-2",
        "l 100,50,-8@100",
    ];
    assert_eq!(found[..expected.len()], expected);
    assert_eq!(found[found.len() - 2..], ["r 115,50,50", "r 100,50,50"]);
}

#[test]
fn the_spindle_and_cdir_choose_the_direction() {
    let turns = |cdir: u8, spindle_direction: u8| {
        let call = format!("POCKET4(50,0,2,-4,20,0,0,4,0,0,300,100,{cdir},11,0)");
        let context = MillingContext { spindle_direction, ..context() };
        let found = moves_in(&call, &context);
        match found.iter().find(|line| line.starts_with('c')) {
            Some(line) => line.split(' ').next().unwrap_or_default().to_string(),
            None => found[0].clone(),
        }
    };
    assert_eq!([turns(0, 3), turns(1, 3), turns(2, 3), turns(3, 3)], ["ccw", "cw", "cw", "ccw"]);
    assert_eq!([turns(0, 4), turns(1, 4), turns(2, 4), turns(3, 5)], ["cw", "ccw", "cw", "ccw"]);
    assert_eq!([turns(0, 5), turns(4, 3)], ["61102 at Some(12)", "61109 at Some(12)"]);
}

/// A helix of radius 3 with at most 2 a turn over 2 + 5 = 7 is 4 turns, and a full circle at the bottom.
#[test]
fn a_circular_pocket_with_a_helix() {
    let found = moves("POCKET4(50,0,2,-5,13,20,30,0,0,0,300,100,3,21,0,,,3,2)");
    assert_eq!(
        found,
        [
            "r 20,30,100",
            "r 20,30,50",
            "r 20,30,2",
            "l 23,30,2@100",
            "ccw 20,30 to 23,30,-5 +3@100",
            "ccw 20,30 to 23,30,-5@100",
            // The middle, and one loop at 13 − 5 = 8.
            "l 20,30,-5@300",
            "l 28,30,-5@300",
            "ccw 20,30 to 28,30,-5@300",
            "r 28,30,50",
            "r 20,30,50",
        ]
    );
}

/// Half the length of the ramp is 15; at 10 degrees a stroke of 30 goes down 5.29: 2 strokes for 2 + 4 + 4.
#[test]
fn a_ramp_ends_with_a_stroke_at_its_level() {
    let found = moves("POCKET3(50,0,2,-8,40,20,6,0,0,0,8,0,0,300,100,0,31,0,,,,10)");
    let expected = [
        "r 0,0,2",
        "l 15,0,2@100",
        "l -15,0,-3@100",
        "l 15,0,-8@100",
        "l -15,0,-8@100",
        "l 0,0,-8@100",
    ];
    assert_eq!(found[1..7], expected);
}

/// Edge with a quarter circle of 2 and the base after it; the base is reached from 0.5 + 2 above it.
#[test]
fn finishing_of_edge_and_base() {
    let found = moves("POCKET4(50,0,2,-5,20,0,0,5,0.2,0.5,300,100,3,12,0)");
    let expected = [
        "r 0,0,50",
        "r 0,0,2",
        "r 13,-2,2",
        "r 13,-2,-4.5",
        "ccw 13,0 to 15,0,-4.5@300",
        "ccw 0,0 to 15,0,-4.5@300",
        "ccw 13,0 to 13,2,-4.5@300",
        "r 13,2,2",
        "r 0,0,2",
        "r 0,0,-2.5",
        "l 0,0,-5@100",
        "l 7.5,0,-5@300",
        "ccw 0,0 to 7.5,0,-5@300",
        "l 15,0,-5@300",
        "ccw 0,0 to 15,0,-5@300",
        "r 15,0,50",
        "r 0,0,50",
    ];
    assert_eq!(found, expected);
}

#[test]
fn the_open_part_of_a_blank_is_not_cut() {
    // The middle line reaches 15 × 5 of the open 16 × 6: only the loop is left, and the tool goes down at feed.
    let found = moves("POCKET3(50,0,2,-4,40,20,6,0,0,0,4,0,0,300,100,3,21,0,32,12,,1,1)");
    assert_eq!(found[1..4], ["r 0,0,2", "l 0,0,-4@100", "l 15,0,-4@300"]);
    // All of it is open down to 3: the one infeed is from there.
    let found = moves("POCKET4(50,0,2,-5,20,0,0,2,0,0,300,100,3,11,0,,3)");
    assert_eq!(found.iter().filter(|line| line.ends_with("@100")).count(), 1);
}

#[test]
fn digits_of_the_editor() {
    // _AMODE 11: the depth is incremental, the stepover 50 % of the diameter; path radius 15 in 3 loops.
    let found = moves("POCKET4(50,1,2,6,20,0,0,6,0,0,300,100,3,11,50,,,,,0,1,2,10100,1,11)");
    assert_eq!(found[2], "l 0,0,-5@100");
    assert_eq!(found.iter().filter(|line| line.starts_with("ccw")).count(), 3);
    assert_eq!(
        fault("POCKET4(50,1,2,6,20,0,0,6,0,0,300,100,3,11,50,,,,,0,1,2,12100,1,11)"),
        "0 at Some(22)"
    );
    assert_eq!(
        fault("POCKET4(50,1,2,6,20,0,0,6,0,0,300,100,3,11,50,,,,,0,1,2,10100,2,11)"),
        "0 at Some(23)"
    );
}

#[test]
fn alarms_of_pockets() {
    assert_eq!(fault("POCKET3(50,0,2,-8,40,9,0,0,0,0,4,0,0,300,100,0,11,0)"), "61105 at None");
    assert_eq!(fault("POCKET3(50,0,2,-8,40,20,11,0,0,0,4,0,0,300,100,0,11,0)"), "61113 at Some(6)");
    assert_eq!(
        fault("POCKET3(50,0,2,-8,40,20,6,0,0,0,4,0,0,300,100,0,11,11)"),
        "61111 at Some(17)"
    );
    assert_eq!(fault("POCKET3(50,0,2,-8,40,20,6,0,0,0,4,0,5,300,100,0,11,0)"), "61110 at Some(12)");
    assert_eq!(fault("POCKET3(50,0,2,-8,40,20,6,0,0,0,4,0,0,300,100,0,21,0)"), "61108 at Some(21)");
    assert_eq!(fault("POCKET3(50,0,2,-8,40,20,6,0,0,0,4,0,0,300,100,0,13,0)"), "61002 at Some(16)");
    assert_eq!(fault("POCKET3(-5,0,2,-8,40,20,6,0,0,0,4,0,0,300,100,0,11,0)"), "61101 at Some(1)");
    assert_eq!(fault("POCKET3(50,0,2,-8,0,20,6,0,0,0,4,0,0,300,100,0,11,0)"), "61118 at Some(4)");
    assert_eq!(fault("POCKET3(50,0,2,-8,40,20,6,0,0,0,1E-9,0,0,300,100,0,11,0)"), "0 at None");
    let no_feed = MillingContext { has_feed: false, ..context() };
    let call = "POCKET3(50,0,2,-8,40,20,6,0,0,0,4,0,0,0,100,0,11,0)";
    assert_eq!(moves_in(call, &no_feed), ["61003 at Some(13)"]);
    let unknown = MillingContext { tool_radius: None, ..context() };
    assert_eq!(moves_in(call, &unknown), ["0 at None"]);
    let zero = MillingContext { tool_radius: Some(0.0), ..context() };
    assert_eq!(moves_in(call, &zero), ["61117 at None"]);
    assert!(moves("POCKET3(50,0,2,0,40,20,6,0,0,0,4,0,0,300,100,0,11,0)").is_empty());
}

/// The tool is too large for corners of 4, and fits between the sides.
#[test]
fn corners_get_at_least_the_radius_of_the_tool() {
    let corner = |call: &str| {
        let (name, list) = call.trim_end_matches(')').split_once('(').expect("a call");
        milling_moves(name, &arguments(list), &context()).expect("moves").enlarged_corner
    };
    assert_eq!(corner("POCKET3(50,0,2,-8,40,20,4,0,0,0,4,0,0,300,100,0,11,0)"), Some(5.0));
    assert_eq!(corner("POCKET3(50,0,2,-8,40,20,5,0,0,0,4,0,0,300,100,0,11,0)"), None);
    assert_eq!(corner("POCKET3(50,0,2,-8,40,20,0,0,0,0,4,0,0,300,100,0,11,0)"), None);
}

/// Two slots of 30 × 12 at 0 and 90 degrees, inner ends at 20; the tool's centre moves between 26 and 44 on the middle line,
/// and round it at 1.
#[test]
fn radial_slots() {
    let found = moves("SLOT1(50,0,2,-4,,2,30,12,0,0,20,0,90,100,300,4,3,0,1)");
    let first = [
        "r 26,0,100",
        "r 26,0,50",
        "r 26,0,2",
        "l 26,0,-4@100",
        "l 44,0,-4@300",
        "l 45,0,-4@300",
        "ccw 44,0 to 44,1,-4@300",
        "l 26,1,-4@300",
        "ccw 26,0 to 25,0,-4@300",
        "ccw 26,0 to 26,-1,-4@300",
        "l 44,-1,-4@300",
        "ccw 44,0 to 45,0,-4@300",
        "r 45,0,50",
        "r 26,0,50",
        "r 0,26,50",
    ];
    assert_eq!(found[..first.len()], first);
    assert_eq!(found.last().map(String::as_str), Some("r 0,26,50"));
}

/// A slot of 12 along a circle of 40 from 0 to 90 degrees: there and back on the middle line, and round it at 1.
#[test]
fn slots_along_a_circle() {
    let found = moves("SLOT2(50,0,2,-4,,1,90,12,0,0,40,0,0,100,300,4,3,0,1)");
    let root = 40.0 * std::f64::consts::FRAC_1_SQRT_2;
    assert_eq!(found[..4], ["r 40,0,100", "r 40,0,50", "r 40,0,2", "l 40,0,-4@100"]);
    assert_eq!(found[4], "ccw 0,0 to 0,40,-4@300");
    assert_eq!(found[5], format!("cw 0,0 to {0:.4},{0:.4},-4@300", root));
    let loop_of_outer = [
        "l 28.9914,28.9914,-4@300",
        "ccw 0,0 to 0,41,-4@300",
        "ccw 0,40 to 0,39,-4@300",
        "cw 0,0 to 39,0,-4@300",
        "ccw 40,0 to 41,0,-4@300",
        "ccw 0,0 to 28.9914,28.9914,-4@300",
    ];
    assert_eq!(found[6..12], loop_of_outer);
}

/// The first end is the nearer one, and the tool goes to and fro: down 3 and 3.
#[test]
fn elongated_holes() {
    let near = MillingContext { position: [100.0, 0.0, 50.0], ..context() };
    let found = moves_in("LONGHOLE(50,0,2,-6,,2,30,0,0,20,0,180,100,300,3)", &near);
    assert_eq!(
        found,
        [
            "r 45,0,50",
            "r 45,0,2",
            "l 45,0,-3@100",
            "l 25,0,-3@300",
            "l 25,0,-6@100",
            "l 45,0,-6@300",
            "r 45,0,50",
            "r -25,0,50",
            "r -25,0,2",
            "l -25,0,-3@100",
            "l -45,0,-3@300",
            "l -45,0,-6@100",
            "l -25,0,-6@300",
            "r -25,0,50",
        ]
    );
}

#[test]
fn alarms_of_slots() {
    assert_eq!(fault("SLOT1(50,0,2,-4,,0,30,12,0,0,20,0,90,100,300,4,3,0,1)"), "61103 at Some(5)");
    assert_eq!(fault("SLOT1(50,0,2,-4,,5,30,12,0,0,20,0,90,100,300,4,3,0,1)"), "61106 at Some(5)");
    assert_eq!(fault("SLOT1(50,0,2,-4,,5,30,12,0,0,2,0,0,100,300,4,3,0,1)"), "61104 at Some(10)");
    assert_eq!(fault("SLOT1(50,0,2,-4,,2,30,9,0,0,20,0,90,100,300,4,3,0,1)"), "61105 at None");
    assert_eq!(fault("SLOT2(50,0,2,-4,,4,85,12,0,0,40,0,0,100,300,4,3,0,1)"), "61104 at Some(10)");
    assert_eq!(
        fault("SLOT1(50,0,2,-4,,2,30,12,0,0,20,0,90,100,300,4,3,0,31)"),
        "61128 at Some(23)"
    );
    assert_eq!(fault("LONGHOLE(50,0,2,-6,,2,9,0,0,20,0,180,100,300,3)"), "61105 at None");
}

/// Two rows of 8 ≥ 7.5 over a width of 15: the centres are at 7.5 − 5 and 15 − 5; 5 + 3 beside the ends.
#[test]
fn a_face_to_and_fro() {
    let found = moves("CYCLE71(50,1,2,0,0,0,40,15,0,1,0,3,0,300,31,0)");
    let expected = [
        "r -8,2.5,100",
        "r -8,2.5,50",
        "r -8,2.5,3",
        "r -8,2.5,0",
        "l 48,2.5,0@300",
        "l 48,10,0@300",
        "l -8,10,0@300",
        "r -8,10,50",
    ];
    assert_eq!(found, expected);
    // Finishing takes the depth at once; in one direction each row begins on the same side.
    let found = moves("CYCLE71(50,1,2,0,0,0,-40,-15,0,0.1,0,3,0,300,22,0)");
    assert_eq!(found[3..6], ["r -3,8,0", "l -3,-23,0@300", "r -3,-23,3"]);
}

/// The call of a program on the web, with the stepover in % (_AMODE 11010): 80 % of 63 is 50.4, three rows of 35.
#[test]
fn a_face_between_corners() {
    let face = MillingContext { tool_radius: Some(31.5), ..context() };
    let call = "CYCLE61(35.8,25.88,5,0,0,0,102,105,30,80,0.2,3000,31,0,1,11010)";
    let found = moves_in(call, &face);
    assert_eq!(
        found[..4],
        ["r -36.5,3.5,100", "r -36.5,3.5,35.8", "r -36.5,3.5,30.88", "r -36.5,3.5,0.2"]
    );
    assert_eq!(found.iter().filter(|line| line.starts_with('l')).count(), 5);
    let off_zero = "CYCLE61(35.8,25.88,5,0,1,0,102,105,2,80,0.2,3000,31,0,1,11010)";
    assert_eq!(moves_in(off_zero, &face), ["0 at Some(4)"]);
    assert_eq!(fault("CYCLE71(50,1,2,0,0,0,40,15,0,1,0,0,0,300,31,0)"), "61122 at Some(11)");
    assert_eq!(fault("CYCLE71(50,1,2,0,0,0,40,15,0,1,0,3,0,300,51,0)"), "61002 at Some(14)");
}

/// A spigot of 30 in a blank of 40: round at 15 + 5, from 20 + 5 + 2 beside it.
#[test]
fn a_circular_spigot() {
    let found = moves("CYCLE77(50,0,2,-6,,30,10,0,3,0,0,300,100,0,1,40)");
    let expected = [
        "r 37,0,100",
        "r 37,0,50",
        "r 37,0,2",
        "l 37,0,-3@100",
        "ccw 33.5,0 to 30,0,-3@300",
        "cw 10,0 to 30,0,-3@300",
        "ccw 33.5,0 to 37,0,-3@300",
        "l 37,0,-6@100",
    ];
    assert_eq!(found[..8], expected);
    assert_eq!(found.last().map(String::as_str), Some("r 37,0,50"));
}

/// A rectangle of 40 × 20 with corners of 3 and an allowance of 1: round at 26 × 16 with corners of 9.
#[test]
fn a_rectangular_spigot() {
    let found = moves("CYCLE76(50,0,2,-6,,40,20,3,0,0,90,6,1,0,300,100,3,1,50,30)");
    let expected = [
        "r 0,32,100",
        "r 0,32,50",
        "r 0,32,2",
        "l 0,32,-6@100",
        "cw 0,29 to 0,26,-6@300",
        "l -7,26,-6@300",
        "ccw -7,17 to -16,17,-6@300",
    ];
    assert_eq!(found[..7], expected);
    assert_eq!(
        fault("CYCLE76(50,0,2,-6,,40,20,3,0,0,90,6,1,0,300,100,3,3,50,30)"),
        "61002 at Some(17)"
    );
}

/// M30 × 2 with a mill of 10: the helix at 15 − 5 = 10, quarter circles of 5 that go 0.5 · (10 + 10) / 30 along the thread.
#[test]
fn an_internal_thread() {
    let found = moves("CYCLE90(50,0,2,-10,,30,27.5,2,200,3,0,60,50)");
    let expected = [
        "r 65,45,100",
        "r 65,45,50",
        "r 65,45,2",
        "ccw 65,50 to 70,50,1.6667@200",
        // 11.6667 are 5 turns and 5/6.
        "ccw 60,50 to 70,50,-8.3333 +4@200",
        "ccw 60,50 to 65,41.3397,-10@200",
    ];
    assert_eq!(found[..6], expected);
    assert!(found[6].starts_with("ccw 62.5,45.6699 to "), "{}", found[6]);
    assert!(found[6].ends_with(",-10.3333@200"), "{}", found[6]);
    assert_eq!(fault("CYCLE90(50,0,2,-10,,30,9,2,200,3,0,60,50)"), "61105 at None");
    assert_eq!(fault("CYCLE90(50,0,2,-10,,30,31,2,200,3,0,60,50)"), "61119 at Some(5)");
    assert_eq!(fault("CYCLE90(50,0,2,-10,,30,27,0,200,3,0,60,50)"), "61001 at Some(7)");
    assert_eq!(fault("CYCLE90(50,0,2,-10,,30,27,2,200,3,2,60,50)"), "61120 at Some(10)");
}

/// An external thread begins in the fourth quadrant with G3 and is touched from outside: core 12 and tool 5 are the helix.
#[test]
fn an_external_thread() {
    let found = moves("CYCLE90(50,0,2,-10,,26,24,2,200,3,1,0,0)");
    // Quarter circles of 1 + 5: from 17 + 6 = 23 and −6.
    assert_eq!(found[0], "r 23,-6,100");
    assert!(found[3].starts_with("cw 23,0 to 17,0,"), "{}", found[3]);
    assert!(found[4].starts_with("ccw 0,0 to 17,0,"), "{}", found[4]);
}

#[test]
fn a_reference_point_that_is_left_out() {
    let call = "POCKET4(50,0,2,-4,20,,,4,0,0,300,100,3,11,0)";
    let at = MillingContext { position: [7.0, 8.0, 50.0], ..context() };
    assert_eq!(moves_in(call, &at)[0], "r 0,0,50");
    assert_eq!(moves_in(call, &MillingContext { is_modal: true, ..at })[0], "r 7,8,2");
}

#[test]
fn older_pockets_rough_and_finish_in_one_call() {
    let found = moves("POCKET2(50,0,2,-8,,20,0,0,100,300,4,3,0.3,0,0,400,900)");
    let speeds: Vec<&String> = found.iter().filter(|line| line.starts_with('S')).collect();
    assert_eq!(speeds, ["SSome(900.0)", "SNone"]);
    // The edge is finished in one infeed at a feed of its own.
    assert_eq!(found.iter().filter(|line| line.ends_with("@400")).count(), 3);
    assert!(found.contains(&"ccw 0,0 to 15,0,-8@400".to_string()), "{found:?}");
    assert!(found.contains(&"ccw 0,0 to 14.7,0,-8@300".to_string()), "{found:?}");
    assert_eq!(fault("POCKET1(50,0,2,-8,,40,20,6,0,0,0,100,300,4,3,0.3,3)"), "61002 at Some(16)");
}
