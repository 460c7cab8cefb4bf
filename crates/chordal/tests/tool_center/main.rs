//! Tool centre point control, from the program to the axes. The positions of the machine are those of the kinematic
//! formulas, worked out apart from this code.

mod other_frames;
mod plane_forms;

use chordal::diagnostics::{Code, Severity};
use chordal::motion::{MotionOptions, MotionStep, PlannerLevel, SamplingRequest, StepSource};
use chordal::{Job, Machine, Source, SourceMap};

/// Where G54 is, and above it a tool of 100 mm.
const GAUGE_POINT: [f64; 3] = [-300.0, -200.0, -280.0];

const COMMON: &str = "
[work_offsets.G54]
X = '-300 mm'
Y = '-200 mm'
Z = '-380 mm'
[tools.1]
length = '100 mm'
diameter = '10 mm'
";

/// C through X-300 Y-200 on A through Y-200 Z-400.
const TRUNNION: &str = "inherits = 'fanuc-ac-trunnion'
[rotary.A]
point = { Y = '-200 mm', Z = '-400 mm' }
[rotary.C]
point = { X = '-300 mm', Y = '-200 mm' }
";

/// A head B 150 mm above the gauge point, and a table C.
const HEAD: &str = "inherits = 'fanuc-head-table'
[rotary.B]
point = { X = '0 mm', Z = '150 mm' }
[rotary.C]
point = { X = '-300 mm', Y = '-200 mm' }
";

fn machine(own: &str) -> Machine {
    let text = format!("{own}{COMMON}");
    Machine::from_toml("five.toml", &text, &|name| Err(format!("no {name}"))).expect("a machine")
}

fn job(machine: Machine, text: &str) -> Job<'static> {
    let mut sources = SourceMap::new();
    sources.add(Source::new("part.nc", text.as_bytes().to_vec()));
    Job::new(sources, machine).expect("good settings")
}

/// The ends of the moves of the axes, machine coordinates: X, Y, Z in mm, A, B, C in degrees.
fn ends(job: &Job, tolerance_mm: f64) -> Vec<[f64; 6]> {
    let mut ends = Vec::new();
    let options =
        MotionOptions { axis_chord_tolerance_mm: tolerance_mm, ..MotionOptions::default() };
    let taken = job.motion(&options, |step: &MotionStep, _: &_| {
        if let MotionStep::Move(motion) = step {
            let to = motion.to();
            ends.push(std::array::from_fn(|axis| match axis {
                0..3 => to[axis] + GAUGE_POINT[axis],
                _ => to[axis].to_degrees(),
            }));
        }
        Ok(())
    });
    assert!(taken.is_ok(), "limits");
    drop(taken);
    ends
}

fn assert_near(found: &[f64; 6], expected: [f64; 3]) {
    let near = found.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-4);
    assert!(near, "{found:?}, not {expected:?}");
}

fn clean(job: &Job) {
    clean_but(job, &[]);
}

/// Nothing but these problems is said.
fn clean_but(job: &Job, allowed: &[Code]) {
    let found = job.check().diagnostics;
    let told: Vec<_> = found
        .iter()
        .filter(|found| found.severity != Severity::Note && !allowed.contains(&found.code))
        .map(|found| (found.code, found.message.clone()))
        .collect();
    assert_eq!(told, []);
}

const START: &str = "G21 G90 G17 G94\nT1 M6\nS5000 M3\nG54 G0 X10. Y0 A0 C0\n";

#[test]
fn the_axes_go_where_the_tip_stays_on_the_turned_part() {
    let text = format!("{START}G43.4 H1 Z20.\nG1 X10. Y0 Z20. A30. C45. F500.\nG49\nM30\n");
    let job = job(machine(TRUNNION), &text);
    clean(&job);
    assert_near(ends(&job, 1e-3).last().expect("moves"), [-292.9289, -186.1237, -261.8234]);
}

#[test]
fn only_the_rotary_axis_is_programmed_and_the_linear_ones_follow() {
    let text = format!("{START}G43.4 H1 Z20.\nG1 A30. F500.\nM30\n");
    let job = job(machine(TRUNNION), &text);
    clean(&job);
    assert_near(ends(&job, 1e-3).last().expect("moves"), [-290.0, -180.0, -265.3590]);
}

#[test]
fn without_it_the_linear_axes_go_to_their_words() {
    let text = format!("{START}G43 H1 Z20.\nG1 X10. Y0 Z20. A30. C45. F500.\nM30\n");
    let job = job(machine(TRUNNION), &text);
    assert_near(ends(&job, 1e-3).last().expect("moves"), [-290.0, -200.0, -260.0]);
}

#[test]
fn a_head_and_a_table() {
    let start = START.replace("A0 C0", "B0 C0");
    let text = format!("{start}G43.4 H1 Z20.\nG1 X10. Y0 Z20. B30. C45. F500.\nM30\n");
    let job = job(machine(HEAD), &text);
    clean(&job);
    assert_near(ends(&job, 1e-3).last().expect("moves"), [-167.9289, -207.0711, -293.4936]);
}

#[test]
fn a_haas_with_tables_b_and_c() {
    let own = "inherits = 'haas-umc750'
[rotary.B]
point = { X = '-300 mm', Z = '-400 mm' }
[rotary.C]
point = { X = '-300 mm', Y = '-200 mm' }
";
    let start = "G21 G90 G17 G94\nT1 M6\nS5000 M3\nG54 G0 X10. Y0 B0 C0\n";
    let text = format!("{start}G234 H1 Z20.\nG1 X10. Y0 Z20. B30. C45. F500.\nG49\nM30\n");
    let job = job(machine(own), &text);
    assert_near(ends(&job, 1e-3).last().expect("moves"), [-313.8763, -207.0711, -261.8234]);
    // Its origin turned by hand: G54 at (-290, -210, -380), the tip at (1, 0, 2) with the table at B90.
    let text = format!(
        "{start}G10 L2 P1 X-290. Y-210. Z-380.\nG0 X1. Y0 B0\nG234 H1 Z50.\nG1 X1. Y0 Z2. B90. F500.\nM30\n"
    );
    let job = self::job(machine(own), &text);
    assert_near(ends(&job, 1e-3).last().expect("moves"), [-322.0, -210.0, -289.0]);
}

#[test]
fn the_axes_keep_the_tip_on_its_line_within_the_tolerance() {
    let text = format!("{START}G0 X0 Y0\nG43.4 H1 Z0\nG1 X50. Y0 Z0 A30. C90. F500.\nM30\n");
    for tolerance in [1e-1, 1e-2, 1e-3] {
        let job = job(machine(TRUNNION), &text);
        clean(&job);
        let ends = ends(&job, tolerance);
        assert_near(ends.last().expect("moves"), [-300.0, -233.3013, -257.6795]);
        // The tip at the middle of each chord of the axes: back through A, then C.
        let mut farthest: f64 = 0.0;
        let start = ends.iter().rposition(|end| end[3] == 0.0 && end[5] == 0.0).expect("a start");
        for pair in ends[start..].windows(2) {
            let middle: [f64; 6] =
                std::array::from_fn(|axis| (pair[0][axis] + pair[1][axis]) / 2.0);
            let (sa, ca) = middle[3].to_radians().sin_cos();
            let (sc, cc) = middle[5].to_radians().sin_cos();
            let [x, y, z] = [middle[0] + 300.0, middle[1] + 200.0, middle[2] - 100.0 + 400.0];
            let (y, z) = (y * ca - z * sa, y * sa + z * ca);
            let (x, y) = (x * cc - y * sc, x * sc + y * cc);
            let share = middle[3] / 30.0;
            let away = [x - 50.0 * share, y, z - 20.0];
            farthest = farthest.max(away.iter().map(|mm| mm * mm).sum::<f64>().sqrt());
        }
        assert!(farthest <= tolerance + 1e-9, "{farthest} with {tolerance}");
        // Where many chords are needed, they are not far more than that.
        let is_coarse = tolerance > 1e-3;
        assert!(is_coarse || farthest > tolerance / 4.0, "{farthest}: too many chords");
    }
}

#[test]
fn the_feed_is_the_speed_of_the_tip() {
    // 50 mm on the part at 500 mm/min: 6 s, whatever the axes do.
    let text = format!("{START}G0 X0 Y0\nG43.4 H1 Z0\nG1 X50. A10. C20. F500.\nM30\n");
    let job = job(machine(TRUNNION), &text);
    let report = job.report_of_commands(|_| {});
    assert!((report.summary.feed_time_s - 6.0).abs() < 1e-9, "{}", report.summary.feed_time_s);
    assert!((report.summary.feed_length_mm - 50.0).abs() < 1e-9);
}

#[test]
fn the_limits_of_all_axes_hold_near_the_pole() {
    // The tip goes 1 mm while C turns by 170 degrees at A1: X and Y swing.
    let text = format!(
        "{START}G0 X100. Y0\nG43.4 H1 Z20.\nG1 X100. Y0 Z20. A1. C0 F5000.\nG1 X101. C170. F5000.\n\
         G1 X0 A30. C0\nM30\n"
    );
    let job = job(machine(TRUNNION), &text);
    clean_but(&job, &[Code::TipFeedTooFast]);
    let mut last: Option<[f64; 6]> = None;
    let request =
        SamplingRequest { period_s: 1e-3, level: PlannerLevel::Fast, max_samples: 1_000_000 };
    let velocity = [0.8, 0.8, 0.8].map(|mm: f64| mm * 1000.0);
    let mut count = 0;
    job.setpoints(&request, |sample, _| {
        if let Some(last) = last.filter(|last| last.iter().all(|value| value.is_finite())) {
            for axis in 0..3 {
                let speed = (sample.position[axis] - last[axis]).abs() / 1e-3;
                assert!(speed <= velocity[axis] * 1.001, "axis {axis}: {speed}");
            }
            for axis in [3, 5] {
                let speed = (sample.position[axis] - last[axis]).abs().to_degrees() / 1e-3;
                assert!(speed <= 180.0 * 1.001, "axis {axis}: {speed}");
            }
        }
        // What waits before the first move has no position yet.
        last = Some(sample.position).filter(|place| *place != [0.0; 6]);
        count += 1;
    })
    .expect("setpoints");
    assert!(count > 1000, "{count}");
}

#[test]
fn a_reference_return_in_between_moves_the_axes_alone() {
    // At A30 C45 the machine goes up to its reference in Z, and comes back to the same place on the part.
    let text = format!(
        "{START}G43.4 H1 Z20.\nG1 X10. Y0 Z20. A30. C45. F500.\nG91 G28 Z0\nG90 G0 X10. Y0 Z20.\nM30\n"
    );
    let job = job(machine(TRUNNION), &text);
    clean(&job);
    let ends = ends(&job, 1e-3);
    let up = ends.iter().rev().nth(1).expect("moves");
    assert_near(up, [-292.9289, -186.1237, 0.0]);
    assert_near(ends.last().expect("moves"), [-292.9289, -186.1237, -261.8234]);
}

#[test]
fn the_travel_of_the_axes_is_checked_along_the_whole_move() {
    // The tip stays at X200 of the part while C turns by 360 degrees: both ends are at X-100, the middle at X-500.
    let narrow =
        TRUNNION.replace("[rotary.A]", "[axes.X]\ntravel = ['-450 mm', '0 mm']\n[rotary.A]");
    let narrow = format!("{narrow}rollover = 'linear'\n");
    let text = format!("{START}G43.4 H1 Z20.\nG1 X200. Y0 Z20. F500.\nG1 C360. F500.\nM30\n");
    let job = job(machine(&narrow), &text);
    let found = job.check().diagnostics;
    let over: Vec<&str> = found
        .iter()
        .filter(|found| found.code == Code::TravelExceeded)
        .map(|found| found.message.as_str())
        .collect();
    assert_eq!(over.len(), 1, "{found:?}");
    assert!(over[0].contains("X goes to -500 mm"), "{over:?}");
}

#[test]
fn without_the_points_of_the_machine_the_tip_is_followed_and_the_time_is_not_verified() {
    let text = format!("{START}G43.4 H1 Z20.\nG1 X30. Y0 Z20. A30. C45. F500.\nG49\nM30\n");
    let job = job(machine("inherits = 'fanuc-30i'\n[axes]\nB = false\n"), &text);
    let report = job.check();
    let codes: Vec<Code> = report.diagnostics.iter().map(|found| found.code).collect();
    assert!(codes.contains(&Code::KinematicsNotKnown), "{codes:?}");
    assert!(report.is_path_verified() && !report.verified());
    let mut ends = Vec::new();
    job.path(|segment| ends.push(chordal::geometry::ParamCurve::end(&segment.curve).to_array()));
    assert_eq!(ends.last(), Some(&[30.0, 0.0, 20.0]));
}

/// Two heads: C on the spindle line, then B 150 mm above the gauge point.
const TWO_HEADS: &str = "inherits = 'fanuc-30i'
[axes]
A = false
[rotary.C]
turns = 'head'
point = { X = '0 mm', Y = '0 mm' }
[rotary.B]
turns = 'head'
on = 'C'
point = { X = '0 mm', Z = '150 mm' }
";

/// The point on the part where the last move ends, mm.
fn last_tip(job: &Job) -> [f64; 3] {
    let mut last = [f64::NAN; 3];
    job.path(|segment| last = chordal::geometry::ParamCurve::end(&segment.curve).to_array());
    last
}

fn assert_point(found: [f64; 3], expected: [f64; 3]) {
    let near = found.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-4);
    assert!(near, "{found:?}, not {expected:?}");
}

const UP: &str = "G21 G90 G17 G94\nT1 M6\nS5000 M3\nG54 G0 X0 Y0 A0 C0\nG43 H1 Z100.\n";

#[test]
fn a_tilted_plane_on_a_trunnion() {
    // The plane through X50, tilted by 30 degrees about X: A30.
    let text = format!("{UP}G68.2 X50. Y0 Z0 I0 J30. K0\nG53.1\nG1 X10. Y5. Z2. F500.\nG69\nM30\n");
    let job = job(machine(TRUNNION), &text);
    clean(&job);
    assert_point(last_tip(&job), [60.0, 3.3301, 4.2321]);
    let ends = ends(&job, 1e-3);
    let last = ends.last().expect("moves");
    assert_near(last, [-240.0, -185.0, -280.6795]);
    assert!((last[3] - 30.0).abs() < 1e-9 && last[5].abs() < 1e-9, "{last:?}");
    // With I90: A30 C90, or A-30 C-90 where A may be negative.
    let text = text.replace("I0 J30.", "I90. J30.");
    let positive =
        TRUNNION.replace("[rotary.A]", "[axes.A]\ntravel = ['0 deg', '120 deg']\n[rotary.A]");
    let job = self::job(machine(&positive), &text);
    let last = *self::ends(&job, 1e-3).last().expect("moves");
    assert_near(&last, [-290.0, -228.3013, -255.6795]);
    assert!((last[3] - 30.0).abs() < 1e-9 && (last[5] - 90.0).abs() < 1e-9, "{last:?}");
}

#[test]
fn the_tip_is_held_or_not_while_the_heads_turn() {
    let up = UP.replace("A0 C0", "B0 C0").replace("Z100.", "Z50.");
    let plane = format!("{up}G68.2 P1 X50. Y0 Z0 I0 J30. K0\n");
    let text = format!("{plane}G53.1\nG1 X10. Y5. Z2. F500.\nM30\n");
    let job = job(machine(TWO_HEADS), &text);
    clean(&job);
    let turned = ends(&job, 1e-3);
    // G53.1 moves no linear axis.
    assert_near(&turned[turned.len() - 2], [-300.0, -200.0, -230.0]);
    let last = turned.last().expect("moves");
    assert_near(last, [-115.3397, -195.0, -316.7616]);
    assert!((last[4] - 30.0).abs() < 1e-9 && last[5].abs() < 1e-9, "{last:?}");
    // G53.6 holds the tip, and the axes go round it.
    let held = self::job(machine(TWO_HEADS), &format!("{plane}G53.6\nM30\n"));
    clean(&held);
    assert_near(ends(&held, 1e-3).last().expect("moves"), [-175.0, -200.0, -263.4936]);
    assert_point(last_tip(&held), [0.0, 0.0, 50.0]);
}

#[test]
fn the_planes_by_their_angles() {
    // A point one unit along X, and one along the normal, of each plane.
    let cases = [
        ("I30. J20. K10.", [0.7713, 0.6337, 0.0594], [0.1710, -0.2962, 0.9397]),
        ("P1 I10. J20. K30.", [0.8138, 0.4698, -0.3420], [0.3785, 0.0180, 0.9254]),
        ("P1 Q321 I10. J20. K30.", [0.8138, 0.5438, -0.2049], [0.3420, -0.1632, 0.9254]),
        ("P4 I20. J10. K0", [0.9397, 0.0, -0.3420], [0.3374, -0.1635, 0.9271]),
    ];
    for (words, along, normal) in cases {
        for (target, expected) in [("X1000. Y0 Z0", along), ("X0 Y0 Z1000.", normal)] {
            let text = format!("{UP}G68.2 X0 Y0 Z0 {words}\nG1 {target} F500.\nG69\nM30\n");
            let found = last_tip(&job(machine(TRUNNION), &text)).map(|mm| mm / 1000.0);
            assert_point(found.map(|v| (v * 1e4).round() / 1e4), expected);
        }
    }
    // A Haas names the order of the axes.
    let own = TRUNNION.replace("fanuc-ac-trunnion", "haas-umc750").replace("rotary.A", "rotary.B");
    let own = own.replace("Y = '-200 mm', Z", "X = '-300 mm', Z");
    let up = UP.replace("A0 C0", "B0 C0");
    let text = format!("{up}G268 X0 Y0 Z0 I10. J20. K30. Q123\nG1 X1000. Y0 Z0 F500.\nG269\nM30\n");
    let found = last_tip(&job(machine(&own), &text)).map(|mm| (mm * 10.0).round() / 1e4);
    assert_point(found, [0.8138, 0.4698, -0.3420]);
}

#[test]
fn arcs_and_cycles_lie_in_the_plane() {
    // A full circle of 10 mm in a plane at 30 degrees about X, and a hole along its normal.
    let text = format!(
        "{UP}G68.2 X50. Y0 Z0 I0 J30. K0\nG53.1\nG0 X10. Y0 Z5.\nG1 Z0 F500.\nG3 X10. Y0 I-10. J0\n\
         G0 Z5.\nG98 G81 X0 Y20. Z-10. R2. F100.\nG80\nG69\nM30\n"
    );
    let job = job(machine(TRUNNION), &text);
    clean(&job);
    let (sin, cos) = 30_f64.to_radians().sin_cos();
    let mut arcs = Vec::new();
    let mut ends = Vec::new();
    job.path(|segment| {
        if let chordal::geometry::Curve::Arc(arc) = &segment.curve {
            arcs.push((arc.center.to_array(), arc.radius, arc.w.to_array()));
        }
        ends.push(chordal::geometry::ParamCurve::end(&segment.curve).to_array());
    });
    let [(center, radius, normal)] = arcs[..] else { panic!("{arcs:?}") };
    assert_point(center, [50.0, 0.0, 0.0]);
    assert!((radius - 10.0).abs() < 1e-9);
    assert_point(normal, [0.0, -sin, cos]);
    // The bottom of the hole: 20 along Y of the plane, 10 below it.
    let bottom = [50.0, 20.0 * cos + 10.0 * sin, 20.0 * sin - 10.0 * cos];
    let is_bottom = |end: &&[f64; 3]| end.iter().zip(bottom).all(|(a, b)| (a - b).abs() < 1e-9);
    assert_eq!(ends.iter().filter(is_bottom).count(), 1, "{ends:?}");
}

#[test]
fn wrong_uses_of_tilted_planes() {
    let alarm_of = |lines: &str| {
        let text = format!("{UP}{lines}\nM30\n");
        let found = job(machine(TRUNNION), &text).check().diagnostics;
        found.into_iter().find(|found| found.severity == Severity::Error).and_then(|f| f.alarm)
    };
    let has = |lines: &str, alarm: &str| {
        let found = alarm_of(lines);
        assert!(found.as_ref().is_some_and(|text| text.contains(alarm)), "{lines}: {found:?}");
    };
    has("G53.1", "PS5458");
    has("G68.2 X0 Y0 Z0 I0 J30. K0\nG68.2 X0 Y0 Z0 I0 J20. K0", "PS5456");
    has("G68.2 P1 Q122 X0 Y0 Z0 I0 J30. K0", "PS5457");
    // A turns from -30 to 120 degrees only: a plane whose normal points down is out of reach.
    has("G68.2 X0 Y0 Z0 I0 J170. K0\nG53.1", "PS5459");
    // A rotary axis that turns in the plane: nobody says where the tip goes.
    let text = format!("{UP}G68.2 X0 Y0 Z0 I0 J30. K0\nG1 X5. C10. F500.\nM30\n");
    let report = job(machine(TRUNNION), &text).check();
    assert!(!report.is_path_verified(), "{:?}", report.diagnostics);
    // After G69 there is none.
    has("G68.2 X0 Y0 Z0 I0 J30. K0\nG53.1\nG69\nG53.1", "PS5458");
}

#[test]
fn the_tip_is_found_again_from_the_axes() {
    // What the playback of a program shows: program coordinates, and the place on the part.
    let ac = format!("{START}G43.4 H1 Z20.\nG1 X40. Y5. Z3. A30. C45. F500.\nM30\n");
    let heads = ac.replace("A0 C0", "B0 C0").replace("A30.", "B30.");
    let plane = format!("{UP}G68.2 X50. Y0 Z0 I0 J30. K0\nG53.1\nG1 X40. Y5. Z3. F500.\nM30\n");
    let (sin, cos) = 30_f64.to_radians().sin_cos();
    let in_plane = [90.0, 5.0 * cos - 3.0 * sin, 5.0 * sin + 3.0 * cos];
    for (own, text, on_part) in [
        (TRUNNION, &ac, [40.0, 5.0, 3.0]),
        (TWO_HEADS, &heads, [40.0, 5.0, 3.0]),
        (TRUNNION, &plane, in_plane),
    ] {
        let job = job(machine(own), text);
        let mut last = None;
        let taken =
            job.motion(&MotionOptions::default(), |step: &MotionStep, source: &StepSource| {
                if let MotionStep::Move(motion) = step {
                    let to = motion.to();
                    let axes: [f64; 6] = std::array::from_fn(|axis| to[axis] - source.shift[axis]);
                    last = Some((axes, source.part_frame));
                }
                Ok(())
            });
        let frames = taken.map(|(report, _)| report.part_frames).unwrap_or_default();
        let Some((axes, Some(index))) = last else { panic!("{last:?}") };
        let placed = &frames[index as usize];
        let program = placed.program_position(&axes);
        assert_point([program[0], program[1], program[2]], [40.0, 5.0, 3.0]);
        assert_point(placed.in_run_frame(&program).to_array(), on_part);
    }
}

#[test]
fn a_rotary_axis_rolls_over_by_the_rule_of_the_machine() {
    let ends_of = |rule: &str| {
        let own = format!("inherits = 'fanuc-30i'\n[axes.A]\n[rotary.A]\nrollover = '{rule}'\n");
        let text = "G21 G90 G0 A0\nA-150.\nA540.\nA-620.\nG91 A380.\nA-840.\nM30\n";
        let job = job(machine(&own), text);
        let mut angles: Vec<f64> = ends(&job, 1e-3).iter().map(|end| end[3].round()).collect();
        angles.retain(|angle| *angle != 0.0);
        angles
    };
    assert_eq!(ends_of("shortest"), [-150.0, -180.0, -260.0, 120.0, -720.0]);
    assert_eq!(ends_of("linear"), [-150.0, 540.0, -620.0, -240.0, -1080.0]);
    assert_eq!(ends_of("sign"), [-210.0, -180.0, -460.0, -80.0, -920.0]);
}

/// LinuxCNC's trunnion: the kinematics follow the tip until M68 switches them to the axes, and back.
#[test]
fn kinematics_are_switched_by_an_output() {
    let own = "inherits = 'linuxcnc-xyzac-trt'
[rotary.A]
point = { Y = '-200 mm', Z = '-400 mm' }
reversed = false
[rotary.C]
point = { X = '-300 mm', Y = '-200 mm' }
reversed = false
[axes.X]
travel = ['-1000 mm', '0 mm']
[axes.Y]
travel = ['-500 mm', '0 mm']
[axes.Z]
travel = ['-500 mm', '0 mm']
";
    let start = "G21 G90 G17 G94 G54\nT1 M6\nG43\nS5000 M3\nG0 X10. Y0 Z20. A0 C0\n";
    let tip = [-292.9289, -186.1237, -261.8234];
    let axes = [-290.0, -200.0, -260.0];
    let turned = "G1 X10. Y0 Z20. A30. C45. F500.\n";
    let last = |middle: &str, own: &str| {
        let job = job(machine(own), &format!("{start}{middle}M2\n"));
        clean(&job);
        *ends(&job, 1e-3).last().expect("moves")
    };
    assert_near(&last(turned, own), tip);
    assert_near(&last(&format!("M68 E3 Q1\nM66 E0 L0\n{turned}"), own), axes);
    assert_near(&last(&format!("M68 E3 Q1\nM68 E3 Q0\n{turned}"), own), tip);
    // Another output switches nothing, and neither does a length.
    assert_near(&last(&format!("M68 E2 Q1\nG49\nG43\n{turned}"), own), tip);
    let axes_first = format!("{own}[kinematics]\nat_start = 'axes'\n");
    assert_near(&last(turned, &axes_first), axes);
    assert_near(&last(&format!("M68 E3 Q1\n{turned}"), &axes_first), tip);
    // The third kinematics are those of the user.
    let job = job(machine(own), &format!("{start}M68 E3 Q2\n{turned}M2\n"));
    assert!(job.check().diagnostics.iter().any(|found| found.code == Code::NotFollowed));
}
