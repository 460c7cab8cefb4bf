//! What a run becomes before it is planned: moves that join on to each other, speeds, corners,
//! waits.

mod mill;

use chordal::machine::AXES;
use chordal::motion::{
    CornerMode, MotionOptions, MotionReport, MotionStep, MotionWait, MoveError, MoveKind,
    MoveRequest, StepSource, WaitKind,
};
use chordal::{Job, Machine, Source, SourceMap};

const MACHINE: &str = "
inherits = \"mill.toml\"
control = \"fanuc\"
[axes.X]
max_velocity = \"400 mm/s\"
[axes.Y]
max_velocity = \"400 mm/s\"
[axes.A]
max_velocity = \"100 deg/s\"
max_acceleration = \"500 deg/s^2\"
max_jerk = \"10000 deg/s^3\"
[work_offsets.G55]
X = \"100 mm\"
Y = \"0 mm\"
Z = \"0 mm\"
[tools.1]
length = \"50 mm\"
[times]
spindle_per_1000_rpm = \"0.5 s\"
spindle_orient = \"1 s\"
m_code = \"0.25 s\"
";

fn machine(changes: &[&str]) -> Machine {
    let mut machine = mill::machine(MACHINE);
    for change in changes {
        machine.set(change).expect("a change");
    }
    machine
}

fn run_with(
    program: &str,
    changes: &[&str],
    options: MotionOptions,
) -> (Vec<(MotionStep, StepSource)>, MotionReport) {
    let mut sources = SourceMap::new();
    sources.add(Source::new("t.nc", program.as_bytes()));
    let job = Job::new(sources, machine(changes)).expect("a job");
    let mut steps = Vec::new();
    let sink = |step: &MotionStep, source: &StepSource| {
        steps.push((*step, *source));
        Ok(())
    };
    let (report, _) = job.motion(&options, sink).expect("limits");
    (steps, report)
}

fn run(program: &str) -> (Vec<(MotionStep, StepSource)>, MotionReport) {
    run_with(program, &[], MotionOptions::default())
}

fn moves(steps: &[(MotionStep, StepSource)]) -> Vec<MoveRequest> {
    let of = |step: &MotionStep| match step {
        MotionStep::Move(motion) => Some(*motion),
        MotionStep::Wait(_) => None,
    };
    steps.iter().filter_map(|(step, _)| of(step)).collect()
}

fn waits(steps: &[(MotionStep, StepSource)]) -> Vec<(WaitKind, f64)> {
    let of = |step: &MotionStep| match step {
        MotionStep::Move(_) => None,
        MotionStep::Wait(MotionWait { seconds, kind, .. }) => Some((*kind, *seconds)),
    };
    steps.iter().filter_map(|(step, _)| of(step)).collect()
}

fn cuts(steps: &[(MotionStep, StepSource)]) -> Vec<MoveRequest> {
    moves(steps).into_iter().filter(|motion| motion.kind == MoveKind::Cut).collect()
}

#[test]
fn moves_join_on_over_offsets_lengths_and_presets() {
    let (steps, _) = run("G90 G54 S1000 M3\nG0 X10. Y10.\nG43 H1 Z5.\nG1 Z0 F600.\nX20.\n\
                          G55\nX0.\nG92 X7. Y7.\nG1 X8. Y9.\nG49\nG1 Z1.\nG91 G28 Z0\nM30\n");
    let moves = moves(&steps);
    assert!(moves.len() >= 8);
    for pair in moves.windows(2) {
        let (to, from) = (pair[0].to(), pair[1].from());
        for axis in 0..AXES {
            assert!((to[axis] - from[axis]).abs() < 1e-7, "{pair:?}");
        }
    }
}

#[test]
fn a_known_work_offset_is_travelled() {
    let (steps, _) = run("G90 G54 S1000 M3\nG1 X20. F600.\nG55 X0.\nM30\n");
    let cuts = cuts(&steps);
    // X0 of G55 is 100 mm of the machine: 80 mm to go.
    assert!((cuts[1].length() - 80.0).abs() < 1e-9, "{:?}", cuts[1]);
}

#[test]
fn a_cut_without_feed_is_left_out_and_counted() {
    let (steps, report) = run("G90 G54 S1000 M3\nG1 X10.\nF600.\nX20.\nM30\n");
    assert_eq!(report.cuts_without_feed, 1);
    assert_eq!(cuts(&steps).len(), 1);
}

#[test]
fn speeds_follow_the_feed_mode() {
    let (steps, _) = run("G90 G54 S600 M3\nG1 X10. F600.\nG93 X20. F30.\nG95 X30. F0.2\nM30\n");
    let speeds: Vec<f64> = cuts(&steps).iter().map(|motion| motion.speed).collect();
    // 600 mm/min; 10 mm in a thirtieth of a minute; 0.2 mm × 10 rev/s.
    for (speed, due) in speeds.iter().zip([10.0, 5.0, 2.0]) {
        assert!((speed - due).abs() < 1e-9, "{speeds:?}");
    }
}

#[test]
fn rotary_axes_alone_turn_by_degrees_a_minute() {
    let (steps, _) = run("G90 G54 S600 M3\nG1 A90. F600.\nM30\n");
    let cut = cuts(&steps)[0];
    assert!((cut.speed - 10f64.to_radians()).abs() < 1e-12);
    assert!((cut.length() - 90f64.to_radians()).abs() < 1e-12);
}

#[test]
fn overrides_change_speeds() {
    let options = MotionOptions {
        feed_override: Some(0.5),
        rapid_override: Some(0.25),
        ..Default::default()
    };
    let (steps, _) = run_with("G90 G54 S600 M3\nG0 X100.\nG1 X10. F600.\nM30\n", &[], options);
    let moves = moves(&steps);
    assert!((moves[0].speed - 100.0).abs() < 1e-9, "a quarter of 400 mm/s");
    assert!((moves[1].speed - 5.0).abs() < 1e-9, "half of 600 mm/min");
}

/// Speeds at half the feed and half the rapid speed, mm/s.
fn halved(program: &str, control: &str) -> Vec<f64> {
    let text = format!("inherits = \"mill.toml\"\ncontrol = \"{control}\"\n");
    let options =
        MotionOptions { feed_override: Some(0.5), rapid_override: Some(0.5), ..Default::default() };
    let mut sources = SourceMap::new();
    sources.add(Source::new("t.nc", program.as_bytes()));
    let job = Job::new(sources, mill::machine(&text)).expect("a job");
    let mut speeds = Vec::new();
    let sink = |step: &MotionStep, _: &StepSource| {
        if let MotionStep::Move(motion) = step {
            speeds.push((motion.speed * 1e6).round() / 1e6);
        }
        Ok(())
    };
    let (report, _) = job.motion(&options, sink).expect("limits");
    assert_eq!(report.refused_moves, 0);
    speeds
}

#[test]
fn overrides_act_where_the_program_lets_them() {
    let head = "G21 G90 G54 S600 M3\nG1 X10. F600.\n";
    // Feeds of 10 mm/s and rapids of 200 mm/s, halved where the override acts.
    let by_m49 = format!("{head}M49\nX20.\nG0 X30.\nM48\nG1 X40.\nG0 X0.\nM30\n");
    assert_eq!(halved(&by_m49, "fanuc"), [5.0, 10.0, 100.0, 5.0, 100.0]);
    assert_eq!(halved(&by_m49, "linuxcnc"), [5.0, 10.0, f64::INFINITY, 5.0, 100.0]);
    let tapping = format!("{head}G63\nX20.\nG64\nX30.\nM49\nG63 X40.\nG64 X50.\nM30\n");
    for control in ["fanuc", "mitsubishi"] {
        assert_eq!(halved(&tapping, control)[..3], [5.0, 10.0, 5.0], "{control}");
    }
    assert_eq!(halved(&tapping, "fanuc")[3..], [10.0, 10.0], "G64 does not end M49");
    let by_p = format!("{head}M50 P0\nX20.\nM50\nX30.\nM50 P0\nM50 P1\nX40.\nM2\n");
    assert_eq!(halved(&by_p, "linuxcnc"), [5.0, 10.0, 5.0, 5.0]);
}

#[test]
fn no_override_acts_on_a_tap() {
    // 600 rpm with a lead of 1 mm: 10 mm/s in and out; the cut after it is halved again.
    let program = "G21 G90 G54 S600 M3\nG0 X0 Y0 Z5.\nG84 Z-10. R5. F600.\nG80\nG1 X10.\nM30\n";
    for control in ["fanuc", "haas", "mitsubishi"] {
        let speeds = halved(program, control);
        assert_eq!(speeds[speeds.len() - 3..], [10.0, 10.0, 5.0], "{control}: {speeds:?}");
    }
}

#[test]
fn the_largest_feed_of_the_machine_holds() {
    let options = MotionOptions { feed_override: Some(2.0), ..Default::default() };
    let program = "G90 G54 S600 M3\nG1 X10. F600.\nM30\n";
    let (steps, _) = run_with(program, &["feed.max = 15 mm/s"], options);
    assert!((cuts(&steps)[0].speed - 15.0).abs() < 1e-9);
}

#[test]
fn waits_take_the_times_of_the_machine() {
    let (steps, _) =
        run("G90 G54 T1 M6\nS2000 M3\nM8\nG4 P1500\nS3000\nM3\nM4\nM19\nM0\nM1\nM30\n");
    let due = [
        (WaitKind::ToolChange, 6.0),
        (WaitKind::SpindleSpeed, 1.0),
        (WaitKind::Coolant, 0.25),
        (WaitKind::Dwell, 1.5),
        (WaitKind::SpindleSpeed, 0.5),
        // From 3000 rpm one way to 3000 rpm the other way.
        (WaitKind::SpindleSpeed, 3.0),
        (WaitKind::SpindleSpeed, 1.5),
        (WaitKind::SpindleOrient, 1.0),
        (WaitKind::Stop, 0.0),
        (WaitKind::End, 0.0),
    ];
    assert_eq!(waits(&steps), due);
}

#[test]
fn assumed_limits_are_named() {
    let mut sources = SourceMap::new();
    sources.add(Source::new("t.nc", b"G0 X1.\nM30\n".as_slice()));
    let text = "control = \"fanuc\"\n[axes.X]\nmax_velocity = \"10 m/min\"\n";
    let machine = Machine::from_toml("m.toml", text, &|_| Err(String::new())).expect("a machine");
    let job = Job::new(sources, machine).expect("a job");
    let sink = |_: &MotionStep, _: &StepSource| Ok(());
    let (report, _) = job.motion(&MotionOptions::default(), sink).expect("limits");
    let assumed: Vec<String> = report
        .limits
        .assumed
        .iter()
        .map(|assumed| format!("{} {}", assumed.axis, assumed.quantity))
        .collect();
    assert_eq!(assumed, ["X acceleration", "X jerk"]);
}

#[test]
fn a_limit_that_is_none_is_an_error() {
    let mut machine = machine(&[]);
    machine.axes[1].as_mut().expect("Y").max_jerk = Some(f64::NAN);
    let mut sources = SourceMap::new();
    sources.add(Source::new("t.nc", b"G0 X1.\nM30\n".as_slice()));
    let job = Job::new(sources, machine).expect("a job");
    let sink = |_: &MotionStep, _: &StepSource| Ok(());
    let error = job.motion(&MotionOptions::default(), sink).err().expect("an error");
    assert_eq!(error.to_string(), "the jerk limit of axis Y is NaN: it must be a positive number");
}

#[test]
fn the_default_mode_rounds_corners_between_cuts_within_the_tolerance_of_the_machine() {
    let program = "G90 G54 S600 M3\nG0 X100.\nG1 X10. F600.\nY10.\nG0 X0\nM30\n";
    let (steps, _) = run_with(program, &["motion.corner_tolerance = 0.02 mm"], Default::default());
    let corners: Vec<CornerMode> = moves(&steps).iter().map(|motion| motion.corner).collect();
    let rotary_rad = 0.01_f64.to_radians();
    assert_eq!(
        corners,
        [
            CornerMode::Stop,
            CornerMode::Blended { linear_mm: 0.02, rotary_rad },
            CornerMode::Stop,
            CornerMode::Stop
        ]
    );
}

#[test]
fn a_one_shot_stop_and_the_modes_end_where_they_should() {
    let program = "%\nO1\nG90 G54 S600 M3\nG9 G1 X10. F600.\nX20.\nG61 X30.\nX40.\nM30\n\
                   O2\nG90 G54 S600 M3\nG1 X50. F600.\nX60.\nX70.\nM30\n%\n";
    let (steps, _) = run(program);
    let stops: Vec<bool> =
        cuts(&steps).iter().map(|motion| motion.corner == CornerMode::Stop).collect();
    // The last one stands before M30.
    assert_eq!(stops, [true, false, true, true, false, false, true]);
}

#[test]
fn bends_of_dog_leg_rapids_are_not_stops() {
    let (steps, _) = run_with(
        "G90 G54\nG0 X100. Y50.\nX0\nM30\n",
        &["rapid.shape = dog-leg", "motion.rapid_corner_tolerance = 4 mm"],
        MotionOptions { dog_leg_shape: true, ..MotionOptions::default() },
    );
    let moves = moves(&steps);
    assert_eq!(moves.len(), 3);
    assert_eq!(moves[0].corner, CornerMode::Blended { linear_mm: 4.0, rotary_rad: 0.04 });
    assert_eq!(moves[1].corner, CornerMode::Stop);
    assert!((moves[0].to()[0] - 50.0).abs() < 1e-9, "Y has arrived when X is half way");
}

#[test]
fn the_bottom_of_a_drilled_hole_is_a_stop() {
    let program = "G90 G54 S600 M3\nG0 X0 Y0 Z10.\nG98 G85 X0 Y0 Z-5. R2. F600.\nG80\nM30\n";
    let (steps, _) = run(program);
    let down = cuts(&steps)[0];
    assert!((down.to()[2] + 5.0).abs() < 1e-9);
    assert_eq!(down.corner, CornerMode::Stop);
}

#[test]
fn linuxcnc_blends_rapids_and_eases_tangent_arcs_where_the_machine_allows_it() {
    let program = "G21 G90 G64 P0.1 S600 M3\nG0 X10\nG1 X20 F600\nG61\nX30\n\
                   G3 X40 Y10 R10\nG1 X50\nM2\n";
    let run_on = |changes: &[&str]| {
        let mut machine = Machine::from_builtin("linuxcnc-mill").expect("built in");
        for change in changes {
            machine.set(change).expect("a change");
        }
        let mut sources = SourceMap::new();
        sources.add(Source::new("t.ngc", program.as_bytes()));
        let job = Job::new(sources, machine).expect("a job");
        let mut corners = Vec::new();
        let sink = |step: &MotionStep, _: &StepSource| {
            if let MotionStep::Move(motion) = step {
                corners.push(motion.corner);
            }
            Ok(())
        };
        let _ = job.motion(&MotionOptions::default(), sink).expect("limits");
        corners
    };
    let within =
        |linear_mm: f64| CornerMode::Blended { linear_mm, rotary_rad: 0.01_f64.to_radians() };
    assert_eq!(
        run_on(&[]),
        [within(0.1), within(0.1), CornerMode::Exact, CornerMode::Exact, CornerMode::Stop]
    );
    // The line meets the arc smoothly, and leaves it at a right angle.
    assert_eq!(
        run_on(&["motion.exact_path_tolerance = 0.002 mm"]),
        [within(0.1), within(0.1), within(0.002), CornerMode::Exact, CornerMode::Stop]
    );
}

#[test]
fn after_a_refused_move_the_next_joins_on_to_the_last_that_was_taken() {
    let mut sources = SourceMap::new();
    let program = "G90 G54 S600 M3\nG1 X10. F600.\nX20.\nX30. Y10.\nM30\n";
    sources.add(Source::new("t.nc", program.as_bytes()));
    let job = Job::new(sources, machine(&[])).expect("a job");
    let mut taken = Vec::new();
    let mut shifts = Vec::new();
    let sink = |step: &MotionStep, source: &StepSource| {
        let MotionStep::Move(motion) = step else { return Ok(()) };
        if source.origin.line == 3 {
            return Err(MoveError::NotFinite);
        }
        taken.push(*motion);
        shifts.push(source.shift[0]);
        Ok(())
    };
    let (report, _) = job.motion(&MotionOptions::default(), sink).expect("limits");
    assert_eq!((report.moves, report.refused_moves), (2, 1));
    assert_eq!(report.refused[0].source.origin.line, 3);
    assert_eq!(taken[0].to()[0], 10.0);
    assert_eq!(taken[1].from()[0], 10.0);
    assert_eq!(taken[1].to()[..2], [20.0, 10.0]);
    assert_eq!(shifts, [0.0, -10.0]);
}
