//! A machine with the axes of a lathe: X is programmed as a diameter, Z, and C turns. Numbers are
//! worked out beside each program; there is no lathe cycle in it.

use chordal::control::CommandKind;
use chordal::{Command, Job, Machine, Source, SourceMap};

const MACHINE: &str = "
control = 'fanuc'
[axes.X]
programmed = 'diameter'
travel = ['-20 mm', '300 mm']
[axes.Z]
travel = ['-500 mm', '0 mm']
[axes.C]
[work_offsets.G54]
X = '10 mm'
Z = '-200 mm'
C = '0 deg'
[home]
X = '280 mm'
Z = '0 mm'
[tools.3]
offset.X = '-60 mm'
offset_wear.X = '0.2 mm'
length = '40 mm'
";

fn run(text: &str, mut watch: impl FnMut(&Command)) -> chordal::Report {
    let machine = Machine::from_toml("lathe.toml", MACHINE, &|name| Err(format!("no {name}")));
    let mut sources = SourceMap::new();
    sources.add(Source::new("part.nc", text.as_bytes().to_vec()));
    let job = Job::new(sources, machine.expect("a good machine")).expect("good settings");
    job.report_of_commands(|command| watch(command))
}

/// X (a radius) and Z where each move ends, mm.
fn ends(text: &str) -> Vec<[f64; 2]> {
    let mut ends = Vec::new();
    let report = run(text, |command| {
        if let Some(motion) = command.kind.motion() {
            ends.push([motion.to[0], motion.to[2]]);
        }
    });
    assert_eq!(messages(&report), [""; 0]);
    ends
}

fn messages(report: &chordal::Report) -> Vec<String> {
    report.diagnostics.iter().map(|diagnostic| diagnostic.message.clone()).collect()
}

#[test]
fn a_word_of_x_is_twice_the_way_of_the_slide() {
    // 50 across is 25 from the axis; an increment of -10 takes 5 from the radius.
    let text =
        "G21 G90 G18 G94 S500 M3\nG0 X50. Z5.\nG1 Z-20. F100.\nX60.\nG91 X-10. Z-1.\nG90 X0\nM30\n";
    assert_eq!(
        ends(text),
        [[25.0, 5.0], [25.0, -20.0], [30.0, -20.0], [25.0, -21.0], [0.0, -21.0]]
    );
}

#[test]
fn inches_are_diameters_too() {
    // 2 in across: 25.4 mm from the axis.
    assert_eq!(ends("G20 G90 G18 G94\nG0 X2. Z0\nM30\n"), [[25.4, 0.0]]);
}

#[test]
fn the_words_of_an_arc_are_radii() {
    // From r 30, Z -20 to r 35, Z -25 about r 35, Z -20: a quarter of radius 5, π·5/2 long, at
    // 100 mm/min 4.712 s.
    let arc =
        "G21 G90 G18 G94 S500 M3\nG0 X60. Z-20.\nG1 F100. X60. Z-20.\nG2 X70. Z-25. I5. K0\nM30\n";
    let mut found = None;
    let report = run(arc, |command| {
        if let CommandKind::Arc { motion, shape, .. } = &command.kind {
            found = Some((motion.to[0], motion.to[2], shape.center, shape.radius_from));
        }
    });
    assert_eq!(messages(&report), [""; 0]);
    // The first axis of the plane is Z.
    assert_eq!(found, Some((35.0, -25.0, [-20.0, 35.0], 5.0)));
    let length = report.summary.feed_length_mm;
    assert!((length - 2.5 * std::f64::consts::PI).abs() < 1e-9, "{length}");
    assert!((report.summary.feed_time_s - 4.712_388_980_384_69).abs() < 1e-9);
    // The same by R.
    let by_r = arc.replace("I5. K0", "R5.");
    let mut center = [0.0; 2];
    run(&by_r, |command| {
        if let CommandKind::Arc { shape, .. } = &command.kind {
            center = shape.center;
        }
    });
    assert!((center[0] + 20.0).abs() < 1e-9 && (center[1] - 35.0).abs() < 1e-9, "{center:?}");
}

#[test]
fn offsets_presets_and_variables_are_diameters() {
    // G92 X100. makes of this place r 50; 10 across from there is r 5.
    let preset = "G21 G90 G18 G94\nG0 X50. Z0\nG92 X100.\nG0 X90.\nM30\n";
    assert_eq!(ends(preset), [[25.0, 0.0], [45.0, 0.0]]);
    // #5001 is the end of the last block as programmed: 50, and 20 more is r 35.
    let variable = "G21 G90 G18 G94\nG0 X50. Z0\n#100=#5001+20.\nG0 X#100\nM30\n";
    assert_eq!(ends(variable), [[25.0, 0.0], [35.0, 0.0]]);
    // G10 moves the zero of G54 from 10 to 30 across, so r 25 becomes 25 - 10 = 15; #2501 reads it.
    let data = "G21 G90 G18 G94\nG0 X50. Z0\nG10 L2 P1 X30.\nG91 G0 X0 Z1.\nG90 X#2501\nM30\n";
    assert_eq!(ends(data), [[25.0, 0.0], [15.0, 1.0], [15.0, 1.0]]);
    // G53 X280. is r 140 on the machine, 135 from the zero of G54 (r 5).
    assert_eq!(ends("G21 G90 G18 G94\nG53 G0 X280.\nM30\n"), [[135.0, 200.0]]);
}

#[test]
fn a_tool_offset_counts_on_x_and_z() {
    // Geometry -60 and wear 0.2 across are -29.9 of radius. The slide stands at r 25 + 5, and the
    // tool's place in the program becomes 25 + 29.9; Z: 0 - 40.
    let text = "G21 G90 G18 G94\nG0 X50. Z0\nG43 H3\nG91 G0 X0 Z1.\nM30\n";
    let ends = ends(text);
    assert!((ends[1][0] - 54.9).abs() < 1e-12, "{ends:?}");
    assert_eq!(ends[1][1], -39.0);
}

#[test]
fn travel_is_told_in_diameters() {
    // r 200 + 5 - 29.9 = 175.1 on the machine: 350.2 across, and the travel ends at 300.
    let report = run("G21 G90 G18 G94\nG43 H3\nG0 X400. Z0\nM30\n", |_| {});
    assert_eq!(
        messages(&report),
        ["X goes to 350.2 mm in machine coordinates, 50.2 mm beyond its travel"]
    );
    let label = &report.diagnostics[0].primary.text;
    assert_eq!(label, "travel is -20 mm to 300 mm");
}

#[test]
fn the_summary_shows_diameters_and_the_slides_way() {
    let report = run("G21 G90 G18 G94\nG0 X50. Z0\nG1 X60. F100.\nG0 C90.\nM30\n", |_| {});
    let x = report.summary.axes.iter().find(|axis| axis.letter == 'X').expect("X moves");
    assert_eq!(x.cut_range, Some((50.0, 60.0)));
    assert_eq!(report.summary.feed_length_mm, 5.0);
    // 5 mm at 100 mm/min: 3 s.
    assert!((report.summary.feed_time_s - 3.0).abs() < 1e-12);
    let c = report.summary.axes.iter().find(|axis| axis.letter == 'C').expect("C turns");
    assert_eq!(c.range.1, std::f64::consts::FRAC_PI_2);
}
