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

/// Seconds that a program cuts on a built-in machine.
fn cutting_seconds(machine: &str, text: &str) -> f64 {
    let mut machine = Machine::from_builtin(machine).expect("a built-in machine");
    for tool in ["tools.1.offset.X=0 mm", "tools.1.offset.Z=0 mm"] {
        machine.set(tool).expect("a tool");
    }
    let mut sources = SourceMap::new();
    sources.add(Source::new("part.nc", text.as_bytes().to_vec()));
    let report = Job::new(sources, machine).expect("good settings").report();
    assert_eq!(report.counts.errors, 0, "{:?}", messages(&report));
    report.summary.feed_time_s
}

/// The integral of ds / (F n) along straight cuts between (diameter, Z), by a hundred thousand steps: n is `cutting`, in
/// the unit of X each minute, over the circumference, and at most `limit`.
fn seconds_by_hand(places: &[[f64; 2]], cutting: f64, limit: f64, per_rev: f64) -> f64 {
    const STEPS: u32 = 100_000;
    let legs = places.windows(2).map(|leg| {
        let [from, to] = [leg[0], leg[1]];
        let length = f64::hypot((to[0] - from[0]) / 2.0, to[1] - from[1]);
        let step = |index: u32| {
            let share = (f64::from(index) + 0.5) / f64::from(STEPS);
            let diameter = from[0] + (to[0] - from[0]) * share;
            let rpm = (cutting / (std::f64::consts::PI * diameter.abs())).min(limit);
            length / f64::from(STEPS) / (per_rev * rpm) * 60.0
        };
        (0..STEPS).map(step).sum::<f64>()
    });
    legs.sum()
}

#[test]
fn times_at_a_cutting_speed_are_integrals() {
    let near = |what: &str, time: f64, by_hand: f64| {
        assert!((time - by_hand).abs() < by_hand * 1e-3, "{what}: {time} s, by hand {by_hand} s");
    };
    // A face to the axis: below a diameter of 21.2 the spindle turns at its limit.
    let face = "G21 G18 G40 G99\nT0101\nG50 S3000\nG96 S200 M3\nG0 X60. Z0\nG1 X0 F.2\nM30\n";
    let by_hand = seconds_by_hand(&[[60.0, 0.0], [0.0, 0.0]], 200e3, 3000.0, 0.2);
    assert!((by_hand - 4.7717).abs() < 1e-3, "{by_hand}");
    near("face", cutting_seconds("fanuc-lathe", face), by_hand);
    // A contour with cylinders, a cone and a shoulder, and a feed that changes on it.
    let contour = "G21 G18 G40 G99\nT101\nG50 S3500\nG96 S180 M3\nG0 X20. Z0\n\
                   G1 Z-20. F.25\nX40. Z-35.\nZ-50.\nG1 X58. F.1\nM30\n";
    let first = [[20.0, 0.0], [20.0, -20.0], [40.0, -35.0], [40.0, -50.0]];
    let by_hand = seconds_by_hand(&first, 180e3, 3500.0, 0.25)
        + seconds_by_hand(&[[40.0, -50.0], [58.0, -50.0]], 180e3, 3500.0, 0.1);
    near("contour", cutting_seconds("haas-lathe", contour), by_hand);
    // Inches: feet per minute, and inches per revolution.
    let inches = "G20 G18 G40 G99\nT0101\nG50 S2500\nG96 S600 M3\nG0 X3. Z0\nG1 X.25 F.01\nZ-.75\nX1.25 Z-2.\nM30\n";
    let places = [[3.0, 0.0], [0.25, 0.0], [0.25, -0.75], [1.25, -2.0]];
    let by_hand = seconds_by_hand(&places, 600.0 * 12.0, 2500.0, 0.01);
    near("inches", cutting_seconds("mitsubishi-lathe", inches), by_hand);
    // LinuxCNC: D is the limit; the machine's own is 3000 rpm.
    let linuxcnc = "G21 G7 G18 G40 G90\nT1 M6 G43\nG96 D1200 S150 M3\nG95 F0.15\nG0 X80 Z0\nG1 X10\nZ-12\nX50 Z-30\nM2\n";
    let places = [[80.0, 0.0], [10.0, 0.0], [10.0, -12.0], [50.0, -30.0]];
    let by_hand = seconds_by_hand(&places, 150e3, 1200.0, 0.15);
    near("LinuxCNC", cutting_seconds("linuxcnc-lathe", linuxcnc), by_hand);
}

/// Cutting time at the programmed feeds, s, and the problems.
fn feed_time(text: &str) -> (f64, Vec<String>) {
    let report = run(text, |_| {});
    (report.summary.feed_time_s, messages(&report))
}

#[test]
fn f_is_the_speed_on_the_cylinder_and_on_the_face() {
    // 30 along Z and 60 degrees at radius 50, 52.36: 60.3453 mm at 500 mm a minute.
    let text = "G21 G90 G18 G94 S500 M3\nG54 G0 X104. Z0 C0\nG7.1 C50.\nG1 Z-30. C60. F500.\nG7.1 C0\nM30\n";
    let (time, said) = feed_time(text);
    assert!((time - 7.2414).abs() < 5e-5, "{time}");
    assert_eq!(said, [""; 0]);
    // Ten across and forty along the flat, whatever C turns.
    let text =
        "G21 G90 G18 G94 S500 M3\nG54 G0 X40. Z0 C0\nG12.1\nG1 C10. F1000.\nX-40.\nG13.1\nM30\n";
    let (time, said) = feed_time(text);
    assert!((time - 3.0).abs() < 1e-9, "{time}");
    assert_eq!(said, [""; 0]);
}

#[test]
fn the_travel_on_a_face_is_that_of_x_itself() {
    // X 250 and C 100 are 2·hypot(125, 100) = 320.156 across, and G54 adds 10 to each diameter.
    let text = "G21 G90 G18 G94 S500 M3\nG54 G0 X250. Z-10. C0\nG12.1\nG1 C50. F1000.\nC100.\nG13.1\nM30\n";
    let (_, said) = feed_time(text);
    assert_eq!(said.len(), 1, "{said:?}");
    assert!(
        said[0].contains("X goes to 330.156 mm") && said[0].contains("30.156 mm beyond"),
        "{said:?}"
    );
    // Through the axis X comes back on its own side.
    let text =
        "G21 G90 G18 G94 S500 M3\nG54 G0 X200. Z-10. C0\nG12.1\nG1 X-200. F1000.\nG13.1\nM30\n";
    assert_eq!(feed_time(text).1, [""; 0]);
}
