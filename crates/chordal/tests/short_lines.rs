//! Which controls join short lines into one curve, and what short lines cost.

use std::collections::BTreeMap;
use std::f64::consts::TAU;

use chordal::control::PathMode;
use chordal::motion::{
    CornerMode, MotionOptions, MotionStep, PlanSink, PlannerStep, StepSource, StepSources,
};
use chordal::time::{ChordCost, ChordRemedy};
use chordal::{Job, Machine, Source, SourceMap};

fn job<'a>(program: &str, machine: &str, changes: &[&str]) -> Job<'a> {
    let mut machine = Machine::from_builtin(machine).expect("built in");
    for change in changes {
        machine.set(change).expect("a change");
    }
    let mut sources = SourceMap::new();
    sources.add(Source::new("t.nc", program.as_bytes().to_vec()));
    Job::new(sources, machine).expect("a job")
}

/// Whether short lines are joined after the first cut, and the distance.
fn first_corner(machine: &str, code: &str, options: &MotionOptions) -> (bool, f64) {
    let program = format!("%\nO1\nG21 G90 G54 S600 M3\n{code}\nG1 X10. F600.\nY1.\nY2.\nM30\n%\n");
    let mut corners = Vec::new();
    let sink = |step: &MotionStep, _: &StepSource| {
        if let MotionStep::Move(motion) = step {
            corners.push(motion.corner);
        }
        Ok(())
    };
    let _ = job(&program, machine, &[]).motion(options, sink).expect("limits");
    match corners[0] {
        CornerMode::Joined { linear_mm, .. } => (true, linear_mm),
        CornerMode::Blended { linear_mm, .. } => (false, linear_mm),
        corner => panic!("{machine} {code}: {corner:?}"),
    }
}

#[test]
fn each_control_joins_short_lines_where_its_table_says_so() {
    let joins =
        |machine: &str, code: &str| first_corner(machine, code, &MotionOptions::default()).0;
    for (machine, code, joined) in [
        ("fanuc-0i", "", false),
        ("fanuc-0i", "G05.1 Q1", true),
        ("fanuc-0i", "G05.1 Q3", true),
        ("fanuc-0i", "G05 P10000", true),
        ("fanuc-0i", "G05.1 Q1\nG05.1 Q0", false),
        ("mitsubishi-m700", "", false),
        ("mitsubishi-m700", "G61.1", true),
        ("mitsubishi-m700", "G61.1\nG64", false),
        ("haas-vf2", "", true),
        ("haas-vf2", "G187 P3 E0.02", true),
        ("fadal-4020", "G8", false),
        ("linuxcnc-mill", "G64 P0.01 Q0.01", false),
    ] {
        assert_eq!(joins(machine, code), joined, "{machine} {code}");
    }
}

#[test]
fn another_tolerance_leaves_it_to_the_program_whether_lines_are_joined() {
    let tolerance_mm = Some(0.03);
    let path_mode = Some(PathMode::Continuous { tolerance_mm, joined: false });
    let options = MotionOptions { path_mode, ..MotionOptions::default() };
    assert_eq!(first_corner("fanuc-0i", "G05.1 Q1", &options), (true, 0.03));
    assert_eq!(first_corner("fanuc-0i", "", &options), (false, 0.03));
}

/// A circle of 20 mm in lines of an even length, with so many decimals.
fn circle(lines: u32, decimals: usize) -> String {
    let mut text = String::from("%\nO1\nG21 G90 G54 S600 M3\nG64 P0.01\nG1 X20. Y0 F6000.\n");
    for line in 1..=lines {
        let angle = TAU * f64::from(line) / f64::from(lines);
        let (x, y) = (20.0 * angle.cos(), 20.0 * angle.sin());
        text.push_str(&format!("X{x:.decimals$} Y{y:.decimals$}\n"));
    }
    text + "M30\n%\n"
}

fn cost(program: &str, changes: &[&str]) -> ChordCost {
    let job = job(program, "linuxcnc-mill", changes);
    let mut costs = job.chord_costs(&MotionOptions::default(), false).expect("limits");
    assert_eq!(costs.len(), 1);
    costs.remove(0)
}

fn saved(cost: &ChordCost, wanted: impl Fn(&ChordRemedy) -> bool) -> f64 {
    cost.savings.iter().find(|(remedy, _)| wanted(remedy)).map_or(0.0, |(_, saved)| *saved)
}

#[test]
fn rounded_coordinates_cost_what_one_more_decimal_saves() {
    let rough = cost(&circle(1257, 3), &[]);
    let fine = cost(&circle(1257, 5), &[]);
    assert_eq!(rough.lines, 1257);
    assert!((rough.length_mm - TAU * 20.0).abs() < 0.1);
    assert!((rough.feed_s - TAU * 20.0 / 100.0).abs() < 0.002);
    let by_decimal = saved(&rough, |remedy| *remedy == ChordRemedy::Decimals(4));
    let difference = rough.time_s - fine.time_s;
    assert!(difference > 0.1, "{} s, {} s", rough.time_s, fine.time_s);
    assert!((by_decimal - difference).abs() < 0.2 * difference, "{by_decimal} s of {difference} s");
    // Whatever noise there is, a curve does not follow it, nor do arcs.
    let joined = saved(&rough, |remedy| *remedy == ChordRemedy::Joined);
    assert!(joined > by_decimal, "{joined} s");
    assert!(saved(&rough, |remedy| matches!(remedy, ChordRemedy::Arcs { .. })) > by_decimal);
    // The largest first.
    assert!(rough.savings.is_sorted_by(|a, b| a.1 >= b.1));
}

#[test]
fn coarse_chords_and_tight_tolerances_are_named_with_what_they_cost() {
    // 1.0 mm lines leave a circle of 20 mm by 0.0065 mm at their middles: more than the tolerance.
    let joined = ["settings.\"short blocks\" = joined"];
    let coarse = cost(&circle(120, 5).replace("P0.01", "P0.002"), &joined);
    let finer = saved(&coarse, |remedy| matches!(remedy, ChordRemedy::Finer(_)));
    assert!(finer > 0.2 * coarse.time_s, "{coarse:?}");
    let wider = saved(&coarse, |remedy| *remedy == ChordRemedy::Tolerance(0.005));
    assert!(wider > 0.05 * coarse.time_s, "{coarse:?}");
    // Dense lines on the same circle have little to gain.
    let dense = cost(&circle(1257, 5), &joined);
    for (remedy, saved) in &dense.savings {
        assert!(*saved < 0.1 * dense.time_s, "{remedy:?} {saved} s of {} s", dense.time_s);
    }
}

/// The time of each line of the program, from the plan with its whole path: when each piece ends is found by
/// halving.
#[derive(Default)]
struct LineTimes(BTreeMap<u32, f64>);

impl PlanSink for LineTimes {
    fn step(&mut self, step: PlannerStep<'_>, _: &StepSources) {
        match step {
            PlannerStep::Wait { seconds, tag } => {
                *self.0.entry(StepSource::line_of(tag)).or_default() += seconds;
            }
            PlannerStep::Trajectory(stretch) => {
                assert_eq!(stretch.overlap_s, 0.0, "no line has a corner by itself");
                let whole = stretch.duration_s();
                let sigma_at = |mut t: f64| {
                    let mut phases = stretch.phases.iter().peekable();
                    while let Some(phase) = phases.next() {
                        if t <= phase.duration_s || phases.peek().is_none() {
                            return phase.at(t).sigma;
                        }
                        t -= phase.duration_s;
                    }
                    0.0
                };
                let (mut sigma, mut before) = (0.0, 0.0);
                for (index, piece) in stretch.pieces.iter().enumerate() {
                    sigma += piece.length;
                    let (mut low, mut high) = (before, whole);
                    for _ in 0..60 {
                        let middle = 0.5 * (low + high);
                        if sigma_at(middle) < sigma { low = middle } else { high = middle }
                    }
                    let end = if index + 1 == stretch.pieces.len() { whole } else { high };
                    *self.0.entry(StepSource::line_of(piece.tag)).or_default() += end - before;
                    before = end;
                }
            }
        }
    }
}

#[test]
fn lines_of_a_curve_have_the_times_of_their_pieces() {
    // Long ways at one feed, three feeds in a row, some lines longer than a piece of the curve, and an arc.
    let mut program = String::from("%\nO1\nG21 G90 G54 S600 M3\nG0 X0 Y0 Z1.\nG9 G1 Z0 F3000.\n");
    for row in 0..4_u32 {
        for step in 0..400_u32 {
            let x = 0.1 * f64::from(if row % 2 == 0 { step } else { 399 - step });
            let feed = match (row, step) {
                (1, 100) => "F1500.",
                (1, 250) => "F6000.",
                (2, 0) => "F3000.",
                _ => "",
            };
            if (150..190).contains(&step) && step % 8 != 0 {
                continue;
            }
            let z = 0.5 * (0.3 * x).sin();
            // Rest at both ends of the way to the next row: there is no overlap.
            let stop = if step == 0 || step == 399 { "G9 " } else { "" };
            program += &format!("{stop}X{x:.3} Y{}. Z{z:.4} {feed}\n", 2 * row);
        }
    }
    program += "G2 X20. Y30. R60.\nG4 P100\nG0 Z50.\nM30\n%\n";
    let job = job(&program, "haas-vf2", &["motion.corner_tolerance = '0.01 mm'"]);
    let options = MotionOptions::default();
    let mut lines = LineTimes::default();
    let with_path = job.time_with(&options, &mut lines).expect("limits").time;
    let timed = job.time(&options).expect("limits").time;
    let near = |a: f64, b: f64| assert!((a - b).abs() < 1e-9 * b.max(1.0), "{a} is not {b}");
    near(timed.total_s(), lines.0.values().sum());
    for (one, other) in
        [(&timed.longest, &with_path.longest), (&timed.costliest, &with_path.costliest)]
    {
        assert_eq!(one.len(), 10);
        for (one, other) in one.iter().zip(other) {
            assert_eq!(one.origin, other.origin);
            assert_eq!((one.runs, one.reason, one.loses), (other.runs, other.reason, other.loses));
            near(one.time_s, other.time_s);
            near(one.lost_s, other.lost_s);
            near(one.time_s, lines.0[&one.origin.line]);
        }
    }
    near(timed.times.lost_s, with_path.times.lost_s);
    near(timed.at_feed_s, with_path.at_feed_s);
    assert_eq!(timed.moves, with_path.moves);
}
