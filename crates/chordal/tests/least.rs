//! How far from the least time: bound, reference and the level best.

mod mill;

use chordal::motion::{MotionOptions, PlannerLevel};
use chordal::time::{LeastReport, ReferenceQuality};
use chordal::{Job, Machine, Source, SourceMap};

const MACHINE: &str = "
inherits = \"mill.toml\"
control = \"fanuc\"
[axes.X]
rapid_acceleration = \"4000 mm/s^2\"
";

fn job(program: &[u8], machine: Machine) -> Job<'_> {
    let mut sources = SourceMap::new();
    sources.add(Source::new("t.nc", program));
    Job::new(sources, machine).expect("a job")
}

fn least(program: &str, effort: ReferenceQuality) -> LeastReport {
    let machine = mill::machine(MACHINE);
    job(program.as_bytes(), machine).least(&MotionOptions::default(), effort).expect("limits")
}

fn near(value: f64, expected: f64) {
    assert!((value - expected).abs() < 1e-6 * expected, "{value} is not {expected}");
}

/// Two tools, a line each: 100 mm at 100 mm/s, then 100 mm of X as a rapid and 50 mm back.
/// A cut of 100 mm from rest to rest: 1 s and 100/2000 s, with jerk 2000/100000 s more.
/// The rapid reaches 200 mm/s: 0.5 s, 200/4000 s, with jerk 4000/100000 s more.
const TWO_TOOLS: &str = "\
O1
G21 G90 G61
T1 M6
G1 X100. F6000.
T2 M6
G0 X200.
G1 X150.
M30
";

#[test]
fn two_operations_by_hand() {
    let report = least(TWO_TOOLS, ReferenceQuality::default());
    let [first, second] = report.operations[..] else { panic!("{report:?}") };
    near(first.time_s, 6.0 + 1.07);
    near(first.bound_s, 6.0 + 1.05);
    near(first.reference_s, 6.0 + 1.07);
    near(second.bound_s, 6.0 + 0.55 + 0.55);
    near(second.reference_s, 6.0 + 0.59 + 0.57);
    near(report.whole.bound_s, first.bound_s + second.bound_s);
    near(report.whole.time_s, first.time_s + second.time_s);
    assert_eq!(report.whole.unknown_s, 0.0);
}

#[test]
fn the_time_that_is_held_against_the_limit_is_the_time_of_the_program() {
    let program = "G21 G90 G64 G0 X0 Y0 Z0\nG1 X30. F6000.\nY20.\nG2 X50. Y0 I0 J-20.\nG0 X0 Z5.\n\
                   G1 Y9. F2000.\nM30\n";
    let machine = mill::machine(MACHINE);
    let job = job(program.as_bytes(), machine);
    let options = MotionOptions::default();
    let least = job.least(&options, ReferenceQuality::default()).expect("limits").whole;
    near(least.time_s, job.time(&options).expect("limits").time.total_s());
    assert!(least.bound_s < least.reference_s && least.reference_s <= least.time_s, "{least:?}");
    assert!(least.time_s < 1.1 * least.reference_s, "{least:?}");
}

#[test]
fn what_is_too_much_work_is_told() {
    let arcs = "G21 G90 G17 G0 X0 Y0 Z0\nG1 X40. F6000.\nG3 X60. Y20. I0 J20.\nM30\n";
    let none = ReferenceQuality { most_nodes: 0, ..ReferenceQuality::default() };
    let report = least(arcs, none).whole;
    assert!(report.unknown_s > 0.5 * report.time_s, "{report:?}");
    assert!(report.bound_s > 0.0 && report.bound_s < report.time_s, "{report:?}");
    assert_eq!(least(arcs, ReferenceQuality::default()).whole.unknown_s, 0.0);
}

#[test]
fn best_is_never_slower_than_fast() {
    let machine = mill::machine(MACHINE);
    for program in [
        "G21 G90 G17 G64 G0 X0 Y0 Z0\nG1 X8. F6000.\nG3 X12. Y4. I0 J4.\nG1 Y9.\nM30\n",
        "G21 G90 G61 G0 X0 Y0 Z0\nG1 X5. F3000.\nY4.\nM30\n",
    ] {
        let job = job(program.as_bytes(), machine.clone());
        let time = |level| {
            let options = MotionOptions { level, ..MotionOptions::default() };
            job.time(&options).expect("limits").time.total_s()
        };
        let (fast, best) = (time(PlannerLevel::Fast), time(PlannerLevel::Best));
        assert!(best > 0.0 && best <= fast * (1.0 + 1e-9), "best {best} s, fast {fast} s");
    }
}
