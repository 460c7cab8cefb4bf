//! Part programs with milling cycles from the text to the path: frames, planes, units, modal calls, alarms.

use chordal::control::{Command, CommandKind, Origin};
use chordal::geometry::TurnDirection;
use chordal::machine::Tool;
use chordal::path::PathCommand;
use chordal::{Code, Diagnostic, Job, Machine, PathSink, Report, Severity, Source, SourceMap};

#[derive(Default)]
struct CommandRecord(Vec<Command>);

impl PathSink for CommandRecord {
    fn command(&mut self, path: PathCommand<'_>) {
        self.0.push(path.command.clone());
    }

    fn diagnostic(&mut self, _: Diagnostic, _: &Origin) {}
}

/// A mill of 10 as T1; T2 has no diameter.
fn machine() -> Machine {
    let mut machine = Machine::from_builtin("sinumerik-mill").expect("a built-in machine");
    for (number, diameter_mm) in [(1, Some(10.0)), (2, None)] {
        let mut tool = Tool { diameter_mm, ..Tool::default() };
        tool.offset[2] = Some(100.0);
        machine.tools.insert(number, tool);
    }
    machine.axes.iter_mut().flatten().for_each(|axis| axis.travel = None);
    let offset = machine.work_offsets.entry("G54".to_string()).or_default();
    offset.values = [Some(0.0), Some(0.0), Some(-500.0), None, None, None];
    machine
}

/// Runs blocks between the usual head and M30.
fn run(blocks: &str) -> (Vec<Command>, Report) {
    let text = format!("G17 G90 G71 G54\nT1 M6\nD1 S3000 M3\nF500\nG0 X0 Y0 Z100\n{blocks}\nM30\n");
    let mut sources = SourceMap::new();
    sources.add(Source::new("mill.mpf", text.into_bytes()));
    let job = Job::new(sources, machine()).expect("a job");
    let mut record = CommandRecord::default();
    job.compensated(None, &mut record);
    (record.0, job.check())
}

/// The ends of all moves of cycles.
fn ends(commands: &[Command]) -> Vec<[f64; 3]> {
    let of_cycle = commands.iter().filter(|command| command.origin.cycle);
    of_cycle
        .filter_map(|command| command.kind.motion())
        .map(|motion| [motion.to[0], motion.to[1], motion.to[2]])
        .collect()
}

/// The lowest and the highest end along an axis.
fn extent(commands: &[Command], axis: usize) -> [f64; 2] {
    let of_axis = ends(commands).into_iter().map(|end| end[axis]);
    of_axis.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], at| [low.min(at), high.max(at)])
}

fn near(found: [f64; 2], expected: [f64; 2]) {
    let far = (0..2).any(|index| (found[index] - expected[index]).abs() > 1e-6);
    assert!(!far, "{found:?} is not {expected:?}");
}

/// The errors and warnings with their alarm.
fn problems(report: &Report) -> Vec<String> {
    let serious = report.diagnostics.iter().filter(|found| found.severity != Severity::Note);
    serious
        .map(|found| {
            let alarm = found.alarm.as_deref().unwrap_or("no alarm");
            format!("{} {alarm}: {}", found.code.info().id, found.message)
        })
        .collect()
}

fn assumed(report: &Report) -> usize {
    report.diagnostics.iter().filter(|found| found.code == Code::CyclePathAssumed).count()
}

const POCKET: &str = "POCKET3(50,0,2,-8,40,20,6,20,0,0,4,0,0,300,100,3,11,0)";

#[test]
fn a_pocket_is_cut_and_its_path_is_assumed() {
    let (commands, report) = run(&format!("{POCKET}\nG0 X0 Y0\n{POCKET}"));
    assert_eq!(problems(&report), [""; 0]);
    // Once for each cycle, and no proof holds over it.
    assert_eq!(assumed(&report), 1);
    assert!(report.is_path_verified() && !report.verified());
    near(extent(&commands, 0), [5.0, 35.0]);
    near(extent(&commands, 1), [-5.0, 5.0]);
    near(extent(&commands, 2), [-8.0, 100.0]);
    assert_eq!(ends(&commands).last(), Some(&[20.0, 0.0, 50.0]));
    let feeds: Vec<f64> = commands
        .iter()
        .filter_map(|command| match &command.kind {
            CommandKind::Line { feed, .. } if command.origin.cycle => Some(feed.value * 60.0),
            _ => None,
        })
        .collect();
    let is_feed = |feed: &f64| (feed - 300.0).abs() < 1e-9 || (feed - 100.0).abs() < 1e-9;
    assert!(feeds.iter().all(is_feed), "{feeds:?}");
}

/// The feed of the program is active again after the cycle.
#[test]
fn the_feed_of_the_program_stays() {
    let (commands, _) = run(&format!("{POCKET}\nG1 X50"));
    let last = commands.iter().rev().find_map(|command| match &command.kind {
        CommandKind::Line { feed, .. } => Some(feed.value * 60.0),
        _ => None,
    });
    assert!(last.is_some_and(|feed| (feed - 500.0).abs() < 1e-9), "{last:?}");
}

/// TRANS X100, AROT RPL=90: the centre (20, 0) is at (100, 20), and the length lies along Y.
#[test]
fn frames_turn_and_shift_a_pocket() {
    let (commands, report) = run(&format!("TRANS X100\nAROT RPL=90\n{POCKET}"));
    assert_eq!(problems(&report), [""; 0]);
    near(extent(&commands, 0), [95.0, 105.0]);
    near(extent(&commands, 1), [5.0, 35.0]);
}

/// A mirrored frame turns the arcs round.
#[test]
fn a_mirrored_pocket() {
    let directions = |frame: &str| {
        let (commands, report) = run(&format!("{frame}{POCKET}"));
        assert_eq!(problems(&report), [""; 0]);
        let sweeps: Vec<bool> = commands
            .iter()
            .filter_map(|command| command.kind.shape())
            .map(|shape| shape.sweep > 0.0)
            .collect();
        assert!(!sweeps.is_empty());
        (extent(&commands, 0), sweeps)
    };
    let (plain, mirrored) = (directions(""), directions("MIRROR X0\n"));
    near(plain.0, [5.0, 35.0]);
    near(mirrored.0, [-35.0, -5.0]);
    assert!(plain.1.iter().all(|is_left| *is_left));
    assert!(mirrored.1.iter().all(|is_left| !*is_left));
}

/// HOLES1 makes holes at 30, 60 and 90: a pocket without a reference point is cut at each of them, one with it in its place.
#[test]
fn a_pattern_of_pockets() {
    let centers = |call: &str| {
        let (commands, report) = run(&format!("MCALL {call}\nHOLES1(20,5,0,10,30,3)\nMCALL"));
        assert_eq!(problems(&report), [""; 0]);
        assert_eq!(assumed(&report), 1);
        let mut centers: Vec<[f64; 2]> = Vec::new();
        for shape in commands.iter().filter_map(|command| command.kind.shape()) {
            let center = [shape.center[0], shape.center[1]];
            if centers.last() != Some(&center) {
                centers.push(center);
            }
        }
        centers
    };
    let at_holes = centers("POCKET4(50,0,2,-4,12,,,4,0,0,300,100,3,11,0)");
    assert_eq!(at_holes, [[30.0, 5.0], [60.0, 5.0], [90.0, 5.0]]);
    let in_place = centers("POCKET4(50,0,2,-4,12,7,8,4,0,0,300,100,3,11,0)");
    assert_eq!(in_place, [[7.0, 8.0]]);
}

/// In G18 the first axis of the plane is Z, the second X, and the normal is Y.
#[test]
fn a_pocket_in_another_plane() {
    let (commands, report) = run("G18\nPOCKET4(50,0,2,-4,12,30,-10,4,0,0,300,100,3,11,0)");
    assert_eq!(problems(&report), [""; 0]);
    near([extent(&commands, 1)[0], 0.0], [-4.0, 0.0]);
    let shape = commands.iter().find_map(|command| command.kind.shape()).expect("an arc");
    near(shape.center, [30.0, -10.0]);
}

/// In inches the path of the tool's centre is 25.4 − 5 from the middle, and the quarter circle of finishing is 2 mm.
#[test]
fn a_pocket_in_inches() {
    let (commands, report) = run("G70\nPOCKET4(2,0,.1,-.2,1,0,0,.5,.01,0,300,100,3,12,0)");
    assert_eq!(problems(&report), [""; 0]);
    let radii: Vec<f64> =
        commands.iter().filter_map(|command| command.kind.shape()).map(|s| s.radius_from).collect();
    assert_eq!(radii.len(), 3, "{radii:?}");
    near([radii[0], radii[1]], [2.0, 20.4]);
}

/// A helix of two turns has one arc with both.
#[test]
fn a_helix_into_the_pocket() {
    let (commands, _) = run("POCKET4(50,0,2,-4,20,0,0,4,0,0,300,100,3,21,0,,,4,3)");
    let helix = commands.iter().find_map(|command| command.kind.shape()).expect("a helix");
    assert!((helix.sweep.to_degrees() - 720.0).abs() < 1e-6);
    assert_eq!(TurnDirection::Ccw.sign(), helix.sweep.signum());
}

#[test]
fn alarms_and_what_is_not_followed() {
    let first = |blocks: &str| {
        let found = problems(&run(blocks).1);
        assert!(!found.is_empty(), "{blocks}");
        found[0].clone()
    };
    let of = |blocks: &str, alarm: &str| {
        let found = first(blocks);
        assert!(found.contains(alarm), "{found}");
    };
    of(&format!("D0\n{POCKET}"), "61000");
    of(&format!("G41 G1 X10 Y10\n{POCKET}\nG40 X0"), "61815");
    of(&format!("M5\n{}", POCKET.replace(",3,11", ",0,11")), "61102");
    of("POCKET4(50,0,2,-4,4,0,0,4,0,0,300,100,3,11,0)", "61105");
    of("POCKET4(-50,0,2,-4,12,0,0,4,0,0,300,100,3,11,0)", "61101");
    // A tool that nobody gave is no fault of the program.
    let report = run(&format!("T2 M6\n{POCKET}")).1;
    assert!(!report.is_path_verified());
    assert!(report.diagnostics.iter().any(|found| found.code == Code::UnknownPath));
    of("CYCLE72(\"A\",50,0,2,-4,4,0,0,300,100,11,41,1,5)", "14011");
    let corners = first(&POCKET.replace(",20,6,", ",20,4,"));
    assert!(corners.starts_with("CH827") && corners.contains("5 mm"), "{corners}");
    // A cycle that is refused does not move.
    assert!(ends(&run("POCKET4(50,0,2,-4,4,0,0,4,0,0,300,100,3,11,0)").0).is_empty());
}

/// Each cycle runs in a program; the tool is at the retract plane after it.
#[test]
fn all_milling_cycles_run() {
    let calls = [
        "POCKET1(50,0,2,-8,,40,20,6,0,0,0,100,300,4,3,0.3,0,0,400,900)",
        "POCKET2(50,0,2,-8,,20,0,0,100,300,4,3,0.3,0,0,400,900)",
        "SLOT1(50,0,2,-4,,4,30,15,40,45,20,45,90,100,320,6,2,0.5,0,10,400,1200)",
        "SLOT2(50,0,2,-4,,3,70,15,60,60,42,,120,100,300,6,2,0.5,0,10,400,1200)",
        "LONGHOLE(50,0,2,,23,4,30,40,45,20,45,90,100,320,6)",
        "CYCLE61(50,1,2,0,0,0,100,100,2,70,0.1,800,31,0,1,10)",
        "CYCLE71(10,0,2,-11,100,100,60,40,10,6,8,5,0,4000,31,5)",
        "CYCLE76(10,0,2,-17.5,,60,40,15,80,60,10,11,0,0,900,800,0,1,80,50)",
        "CYCLE77(10,0,3,-20,,50,60,70,10,0.5,0,900,800,1,1,55)",
        "CYCLE90(48,40,5,0,40,60,50,2,500,2,0,60,50)",
    ];
    for call in calls {
        let (commands, report) = run(call);
        assert_eq!(problems(&report), [""; 0], "{call}");
        let retract: f64 = call
            .split_once('(')
            .and_then(|(_, list)| list.split(',').next()?.parse().ok())
            .expect("a plane");
        assert_eq!(ends(&commands).last().map(|end| end[2]), Some(retract), "{call}");
    }
}

/// The contour of a rectangle of 40 by 20, cut from its left side upwards with the tool outside, in two depths.
fn contour_milled(approach: u32) -> Vec<Command> {
    let blocks = format!(
        "CYCLE72(\"AA:BB\",50,0,2,-6,3,0,0,300,100,1,41,{approach},8,300,{approach},8)\nGOTOF CC\n\
         AA: G1 X0 Y0\nY20\nX40\nY0\nBB: X0\nCC: G0 Z100"
    );
    let (commands, report) = run(&blocks);
    let found = problems(&report);
    assert!(found.iter().all(|found| found.is_empty()), "{found:?}");
    commands
}

/// The tool's centre is its radius off the contour, which begins and ends with the lead of the call.
#[test]
fn a_contour_is_milled_on_the_tools_side() {
    let places = |commands: &[Command]| -> Vec<[f64; 3]> {
        let moves = commands.iter().filter_map(|command| command.kind.motion());
        moves.map(|motion| [motion.to[0], motion.to[1], motion.to[2]]).collect()
    };
    let straight = places(&contour_milled(1));
    let has = |place: [f64; 3]| {
        straight.iter().any(|at| (0..3).all(|axis| (at[axis] - place[axis]).abs() < 1e-9))
    };
    for level in [-3.0, -6.0] {
        // From 8 before the start, up the left side, round the corners, back to the start and 8 beyond.
        for place in [
            [-5.0, -8.0, level],
            [-5.0, 0.0, level],
            [-5.0, 20.0, level],
            [40.0, 25.0, level],
            [0.0, -5.0, level],
            [-8.0, -5.0, level],
        ] {
            assert!(has(place), "{place:?} in {straight:?}");
        }
    }
    let lowest = straight.iter().map(|at| at[2]).fold(f64::INFINITY, f64::min);
    assert_eq!(lowest, -6.0);
    // Quarter circles of 8 lead in from the left and out downwards.
    let curved = contour_milled(2);
    let radii: Vec<f64> = curved
        .iter()
        .filter_map(|command| command.kind.shape())
        .map(|shape| (shape.radius_from * 1e6).round() / 1e6)
        .collect();
    assert_eq!(radii.iter().filter(|radius| **radius == 8.0).count(), 4, "{radii:?}");
    assert!(
        places(&curved).iter().any(|at| (at[0] + 13.0).abs() < 1e-9 && (at[1] + 8.0).abs() < 1e-9)
    );
}

/// The feeds of a cycle are written as F is: per revolution while G95 is active.
#[test]
fn the_feeds_of_a_contour_follow_g95() {
    let blocks = "CYCLE72(\"AA:BB\",50,0,2,-3,3,0,0,0.2,0.1,1,41,1,8,0.2,1,8)\nGOTOF CC\n\
         AA: G1 X0 Y0\nY20\nX40\nY0\nBB: X0\nCC: G0 Z100";
    let (commands, _) = run(&format!("G95 F0.5\n{blocks}"));
    let feeds: Vec<f64> = commands
        .iter()
        .filter_map(|command| match &command.kind {
            CommandKind::Line { feed, .. } => Some(feed.value),
            _ => None,
        })
        .collect();
    assert!(feeds.contains(&0.1) && feeds.contains(&0.2), "{feeds:?}");
    assert!(feeds.iter().all(|feed| [0.1, 0.2].contains(feed)), "{feeds:?}");
}
