//! One program on five controls: it differs exactly where the controls differ, and each
//! difference is pinned here.

use chordal::control::{CommandKind, FeedAlong};
use chordal::machine::AXES;
use chordal::{Job, Machine, Source, SourceMap};

/// A machine of each control, all started in millimetres.
const MACHINES: [&str; 5] =
    ["fadal-4020", "haas-vf2", "fanuc-30i", "mitsubishi-m700", "linuxcnc-mill"];

/// What a block does on a control, in a few words.
fn effects(machine: &str, setup: &str, block: &str) -> String {
    let text =
        format!("G21 G17 G90 G94 S1000 M3\nG0 X0. Y0. Z0.\nG1 F100.\n{setup}\n{block}\nM30\n");
    let line = 5 + setup.matches('\n').count() as u32;
    let mut sources = SourceMap::new();
    sources.add(Source::new("five.nc", text.into_bytes()));
    let machine = Machine::from_builtin(machine).expect("a built-in machine");
    let job = Job::new(sources, machine).expect("good settings");
    let mut effects = Vec::new();
    let mut offset_from = [0.0; AXES];
    let report = job.report_of_commands(|command| {
        if command.origin.line != line {
            return;
        }
        let number = |value: f64| {
            format!("{value:.4}").trim_end_matches('0').trim_end_matches('.').to_string()
        };
        if let Some(motion) = command.kind.motion() {
            offset_from = motion.from;
            let mut words = match &command.kind {
                CommandKind::Rapid { .. } => "rapid".to_string(),
                CommandKind::Line { .. } => "line".into(),
                CommandKind::Arc { shape, feed, .. } => {
                    let plane = if feed.along == FeedAlong::Plane { " F in the plane" } else { "" };
                    format!("arc {} deg{plane}", number(shape.sweep.to_degrees()))
                }
                CommandKind::Spiral { shape, .. } => {
                    format!("spiral {} deg", number(shape.sweep.to_degrees()))
                }
                _ => String::new(),
            };
            for (axis, letter) in "XYZ".chars().enumerate() {
                if motion.to[axis] != motion.from[axis] {
                    words += &format!(" {letter}{}", number(motion.to[axis]));
                }
            }
            effects.push(words);
        }
        match &command.kind {
            CommandKind::Dwell { seconds, .. } => {
                effects.push(format!("dwell {} s", number(*seconds)))
            }
            CommandKind::ToolLength { number: Some(n), .. } => effects.push(format!("length {n}")),
            CommandKind::WorkOffset { name, .. } => effects.push(format!("offset {name:?}")),
            _ => {}
        }
    });
    let told = report.diagnostics.iter().filter(|d| {
        let source = job.sources().get(d.primary.span.file).expect("the program");
        source.line_of(d.primary.span.range.start) == line && d.severity > chordal::Severity::Note
    });
    effects.extend(told.map(|d| d.code.id().to_string()));
    effects.join(", ")
}

/// Runs a block on the five controls: Fadal, Haas, Fanuc, Mitsubishi, LinuxCNC.
#[track_caller]
fn five(setup: &str, block: &str, expected: [&str; 5]) {
    for (machine, expected) in MACHINES.iter().zip(expected) {
        assert_eq!(effects(machine, setup, block), expected, "`{block}` on {machine}");
    }
}

#[test]
fn a_number_without_a_point() {
    // Calculator controls take units, the others least increments, and say so.
    five(
        "",
        "X10",
        ["line X10", "line X0.01, CH305", "line X0.01, CH305", "line X0.01, CH305", "line X10"],
    );
}

#[test]
fn an_arc_direction_that_stays_armed() {
    // After a straight cut a Fadal still knows the last G3; elsewhere I has no effect on G1.
    let line = "line X10, CH304";
    five("G3 X0. Y0. I5.\nG1 X0.\nG1", "X10. I5.", ["arc 180 deg X10", line, line, line, line]);
}

#[test]
fn a_block_without_a_centre_after_an_arc() {
    // G2 stays active, except on a Fadal, where such a block is a straight cut.
    let error = "line X5, CH405";
    five("G2 X0. Y0. I5.", "X5.", ["line X5", error, error, error, error]);
}

#[test]
fn a_line_repeat() {
    let once = "line X1, CH304";
    five(
        "G91",
        "G1 X1. L3",
        ["line X1, line X2, line X3", "line X1, line X2, line X3", once, once, once],
    );
}

#[test]
fn absolute_and_incremental_in_one_block() {
    // Left to right on a Fadal; two codes of one group elsewhere, and the last one counts.
    let clash = "line X4, CH302";
    five("G1 X5.", "G91 X4. G90", ["line X9", clash, clash, clash, clash]);
}

#[test]
fn a_dwell() {
    // Milliseconds; with a point Haas means seconds; LinuxCNC always does.
    five(
        "",
        "G4 P500",
        ["dwell 0.5 s", "dwell 0.5 s", "dwell 0.5 s", "dwell 0.5 s", "dwell 500 s"],
    );
    five(
        "",
        "G4 P1.5",
        [
            "dwell 0.0015 s",
            "dwell 1.5 s",
            // Fanuc's P takes no point (PS0007).
            "dwell 0.0015 s, CH101",
            "dwell 0.0015 s",
            "dwell 1.5 s",
        ],
    );
}

#[test]
fn a_work_offset_by_e() {
    let unused = "CH304";
    five("", "E3", ["offset E(3)", unused, unused, unused, unused]);
}

#[test]
fn a_length_by_h_alone() {
    five(
        "",
        "G0 H5 Z10.",
        ["length 5, rapid Z10", "rapid Z10", "rapid Z10", "rapid Z10", "rapid Z10, CH304"],
    );
}

#[test]
fn a_bare_return_to_the_reference_point() {
    let missing = "CH308";
    five("G0 Z5.", "G28", [missing, "rapid Z0", missing, missing, "rapid Z0"]);
}

#[test]
fn a_full_circle_by_radius() {
    five("", "G2 R5.", ["CH403"; 5]);
}

#[test]
fn both_a_centre_and_a_radius() {
    let r_wins = "arc -180 deg X10, CH409";
    five("", "G2 X10. I5. R5.", [r_wins, r_wins, r_wins, r_wins, "line X10, CH409"]);
}

#[test]
fn an_end_that_is_off_the_arc() {
    // 0.05 mm: Mitsubishi's RadErr of 0.1 allows it, LinuxCNC looks at the radius too.
    let refused = "arc -180 deg X99.95, CH401";
    let taken = "arc -180 deg X99.95";
    five("", "G2 X99.95 I50.", [refused, refused, refused, taken, taken]);
}

#[test]
fn the_feed_of_a_helix() {
    let path = "arc 360 deg Z-1";
    five("", "G3 I5. Z-1.", [path, path, "arc 360 deg F in the plane Z-1", path, path]);
}

#[test]
fn turns_of_an_arc() {
    // Mitsubishi counts turns beside the angle between the ends, which a full circle does not have, LinuxCNC all of
    // them; the others have none.
    let unused = "arc 360 deg, CH304";
    five("", "G3 I5. P2", [unused, unused, unused, "arc 720 deg", "arc 720 deg"]);
}

#[test]
fn a_spiral_by_turns() {
    // A count of turns begun (two are L2), a repeat of the line, or nothing.
    let unused = "arc -360 deg X5, CH401, CH304";
    let repeated = "arc -360 deg X5, arc -360 deg, CH401";
    five("", "G2 X5. I10. L2", [repeated, repeated, "spiral -720 deg X5", unused, unused]);
}

#[test]
fn two_codes_of_one_group() {
    let clash = "line X1, CH302";
    five("", "G0 G1 X1.", [clash; 5]);
}

#[test]
fn a_code_that_only_some_have() {
    five("", "G154 P2", ["CH301", "offset Extended(2)", "CH301", "CH301", "CH301"]);
    five(
        "",
        "G2.1 X10. I5. P1",
        [
            "line X10, CH301",
            "line X10, CH301",
            "line X10, CH301",
            "spiral -540 deg X10",
            "line X10, CH301",
        ],
    );
    five("", "G61.1", ["CH301", "CH301", "CH301", "", ""]);
}

#[test]
fn a_comment_behind_a_semicolon() {
    // The end of a block on most controls, so another block may follow; a comment in LinuxCNC.
    let two = "line X1, line Y1";
    five("", "X1. ; Y1.", [two, two, two, two, "line X1"]);
}

#[test]
fn a_register_or_a_radius() {
    // R0 is a register on a Fadal, and elsewhere a radius of zero and a number too many.
    let refused = "line X10, CH402, CH102";
    five("", "G2 X10. R0+5.", ["arc -180 deg X10", refused, refused, refused, refused]);
}

#[test]
fn a_spiral_by_its_increment() {
    // Fanuc's Q is the change of radius in a turn; type 1 of Mitsubishi has none.
    let unused = "arc -360 deg X5, CH401, CH304";
    five("", "G2 X5. I10. Q-5.", [unused, unused, "spiral -360 deg X5", unused, unused]);
}

#[test]
fn a_comment_left_open() {
    five(
        "",
        "X1. (Y1.",
        ["line X1", "line X1, CH104", "line X1, CH104", "line X1, CH104", "line X1, CH104"],
    );
}

#[test]
fn a_star_in_the_line() {
    let refused = "line X1 Y1, CH105";
    five("", "X1. * Y1.", ["line X1", refused, refused, refused, refused]);
}

#[test]
fn a_call_with_packed_repeats() {
    // Ten times O5 on a Fanuc, program 100005 elsewhere.
    let missing = "CH201";
    five("", "M98 P100005", [missing; 5]);
}

#[test]
fn a_call_of_a_letter_l() {
    // A subroutine that is not there, a repeat of a block that does nothing, or nothing.
    five("", "L201", ["CH201", "CH303", "CH304", "CH304", "CH304"]);
}

#[test]
fn a_centre_outside_the_plane() {
    // A height word of spirals is skipped where a control knows them, and said to be; a zero, as posts
    // write it, says nothing where the control does not refuse it.
    five("", "G2 X10. I5. K1.", ["arc -180 deg X10, CH404"; 5]);
    let (refused, taken) = ("arc -180 deg X10, CH404", "arc -180 deg X10");
    five("", "G2 X10. I5. K0.", [taken, refused, taken, taken, refused]);
}

#[test]
fn the_middle_of_a_chord() {
    // 2R - chord is 0.002 mm: on a Mitsubishi the middle of the chord is the centre, a half turn. The others go
    // twice the angle whose sine is 5 by 5.001.
    let computed = "arc -177.7084 deg X10";
    five("", "G2 X10. R5.001", [computed, computed, computed, "arc -180 deg X10", computed]);
}

#[test]
fn a_radius_above_the_largest() {
    let taken = "arc -0.0564 deg X10";
    five("", "G2 X10. R10160.", ["arc -0.0564 deg X10, CH408", taken, taken, taken, taken]);
}

#[test]
fn codes_for_inches() {
    // G70 is inch on a Fadal, a bolt circle on a Haas, which needs a cycle, and a finishing cycle on LinuxCNC, which
    // needs its contour; it is unknown elsewhere. An old Fanuc has a setting for it.
    let unknown = "line X1, CH301";
    five("", "G70 X1.", ["line X25.4", "CH807", unknown, unknown, "CH308"]);
}

#[test]
fn a_code_that_wants_to_be_alone() {
    five(
        "",
        "G90 G92 X1.",
        ["offset E(1), CH307", "offset G(54)", "offset G(54)", "offset G(54)", "offset G(54)"],
    );
}

#[test]
fn a_rotation() {
    // LinuxCNC turns a work coordinate system by G10 L2 R and has no G68.
    five("", "G68 X10. Y5. R30.", ["", "", "", "", "line X10 Y5, CH301"]);
    five(
        "G68 X10. Y5. R30.",
        "X20. Y5.",
        [
            "line X18.6603 Y10",
            "line X18.6603 Y10",
            "line X18.6603 Y10",
            "line X18.6603 Y10",
            "line X20",
        ],
    );
}

#[test]
fn an_angle_in_g91() {
    // Mitsubishi adds it; Haas by Setting 73 and Fanuc by parameter 5400 count it absolute.
    five(
        "G68 X0 Y0 R30.\nG91 G68 X0 Y0 R15.\nG90",
        "X10. Y0",
        [
            "line X9.6593 Y2.5882",
            "line X9.6593 Y2.5882",
            "line X9.6593 Y2.5882",
            "line X7.0711 Y7.0711",
            "line X10",
        ],
    );
}

#[test]
fn scaling_names_its_axes() {
    // Mitsubishi scales the axes whose centre is named, the others all three. Fadal scales by G51.3 alone.
    five(
        "G51 X0 P2.",
        "X10. Y5.",
        ["line X10 Y5", "line X20 Y10", "line X20 Y10", "line X20 Y5", "line X10 Y5"],
    );
    // An arc then is an ellipse on Mitsubishi, which refuses it.
    five(
        "G51 X0 P2.",
        "G2 X10. Y10. R10.",
        [
            "arc -90 deg X10 Y10",
            "arc -90 deg X20 Y20",
            "arc -90 deg X20 Y20",
            "line X20 Y10, CH431",
            "arc -90 deg X10 Y10",
        ],
    );
}

#[test]
fn a_mirror() {
    // G51.1 at a line; Haas mirrors by G101 about the work zero.
    five(
        "G51.1 X50.",
        "X20. Y5.",
        ["line X80 Y5", "line X20 Y5", "line X80 Y5", "line X80 Y5", "line X20 Y5"],
    );
    five(
        "G101 X50.",
        "X20. Y5.",
        ["line X20 Y5", "line X-20 Y5", "line X20 Y5", "line X20 Y5", "line X20 Y5"],
    );
}

#[test]
fn polar_coordinates() {
    five(
        "G16",
        "X100. Y30.",
        [
            "line X100 Y30",
            "line X100 Y30",
            "line X86.6025 Y50",
            "line X86.6025 Y50",
            "line X100 Y30",
        ],
    );
}
