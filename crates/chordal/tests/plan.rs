//! A run through the planner: time, limits, and where every piece comes from.

#![allow(
    clippy::disallowed_methods,
    clippy::disallowed_types,
    reason = "a test reads the programs of the repository"
)]

mod mill;

use chordal::machine::PerAxis;
use chordal::motion::{
    MotionOptions, MotionReport, PlanSink, PlannerStep, StepKind, StepSource, StepSources, WaitKind,
};
use chordal::{Job, Machine, SegmentKind, Source, SourceMap};

/// What came out of a planner.
#[derive(Default)]
struct Planned {
    seconds: f64,
    waits: Vec<(WaitKind, f64)>,
    lines: Vec<u32>,
    tags_without_source: usize,
    most_sources: usize,
    largest_gap: f64,
    end: Option<PerAxis<f64>>,
}

impl PlanSink for Planned {
    fn step(&mut self, step: PlannerStep<'_>, sources: &StepSources) {
        self.most_sources = self.most_sources.max(sources.len());
        match step {
            PlannerStep::Trajectory(stretch) => {
                self.seconds += stretch.duration_s() - stretch.overlap_s;
                let from = stretch.from();
                if let Some(end) = self.end {
                    let gaps = from.iter().zip(end).map(|(a, b)| (a - b).abs());
                    self.largest_gap = gaps.fold(self.largest_gap, f64::max);
                }
                self.end = Some(stretch.to());
                for piece in &stretch.pieces {
                    match sources.get(piece.tag) {
                        Some(source) => {
                            assert_eq!(source.tag, piece.tag);
                            assert_eq!(source.origin.line, StepSource::line_of(piece.tag));
                            if self.lines.last() != Some(&source.origin.line) {
                                self.lines.push(source.origin.line);
                            }
                        }
                        None => self.tags_without_source += 1,
                    }
                }
            }
            PlannerStep::Wait { seconds, tag } => {
                self.seconds += seconds;
                match sources.get(tag).map(|source| source.kind) {
                    Some(StepKind::Wait(kind)) => self.waits.push((kind, seconds)),
                    _ => self.tags_without_source += 1,
                }
            }
        }
    }
}

fn plan_with(program: &str, changes: &[&str], options: MotionOptions) -> (Planned, MotionReport) {
    let mut machine = mill::machine("inherits = 'mill.toml'");
    for change in changes {
        machine.set(change).expect("a change");
    }
    let mut sources = SourceMap::new();
    sources.add(Source::new("t.ngc", program.as_bytes()));
    let job = Job::new(sources, machine).expect("a job");
    let mut planned = Planned::default();
    let report = job.plan(&options, &mut planned).expect("limits");
    assert_eq!(planned.tags_without_source, 0);
    (planned, report)
}

fn plan(program: &str) -> (Planned, MotionReport) {
    plan_with(program, &[], MotionOptions::default())
}

#[test]
fn a_line_takes_its_time_with_ramps() {
    // 100 mm at 100 mm/s: each ramp of 100/2000 + 2000/1e5 s costs half of itself more.
    let (planned, report) = plan("G21 G90 G61 S600 M3\nG1 X100 F6000\nM2\n");
    assert_eq!(report.refused_moves, 0);
    assert!((planned.seconds - 1.07).abs() < 1e-6, "{}", planned.seconds);
}

#[test]
fn cutting_a_line_into_pieces_changes_no_time() {
    let mut program = String::from("G21 G90 G64 P0.01 S600 M3\n");
    for piece in 1..=100 {
        program += &format!("G1 X{piece} F6000\n");
    }
    let (planned, _) = plan(&(program + "M2\n"));
    assert!((planned.seconds - 1.07).abs() < 1e-6, "{}", planned.seconds);
    assert_eq!(planned.lines.len(), 100);
}

#[test]
fn waits_are_in_the_time_and_known() {
    let (planned, _) = plan("G21 G90 G61 T1 M6\nS600 M3\nG1 X100 F6000\nG4 P2.5\nM2\n");
    let timed: Vec<_> = planned.waits.iter().filter(|wait| wait.1 > 0.0).copied().collect();
    assert_eq!(timed, [(WaitKind::ToolChange, 6.0), (WaitKind::Dwell, 2.5)]);
    assert!((planned.seconds - 1.07 - 8.5).abs() < 1e-6, "{}", planned.seconds);
}

#[test]
fn offsets_and_waits_leave_no_gap() {
    let program = "G21 G90 G64 P0.05 S600 M3\nG0 X10 Y10\nG1 Z-1 F600\nG92 X0 Y0\nG1 X20\nY20\n\
                   G4 P0.5\nG92.1\nG2 X40 Y30 I10 J0\nG43.1 Z5\nG1 Z3\nG0 X0 Y0\nM2\n";
    let (planned, report) = plan(program);
    assert_eq!(report.refused_moves, 0, "{:?}", report.refused);
    assert!(planned.largest_gap < 1e-6, "{}", planned.largest_gap);
}

#[test]
fn memory_stays_bounded() {
    let mut program = String::from("G21 G90 G64 P0.01 S600 M3\nF3000\n");
    for piece in 0..50_000 {
        program += &format!("G1 X{}.{} Y{}\n", piece / 10, piece % 10, piece % 2);
    }
    let (planned, report) = plan(&(program + "M2\n"));
    assert_eq!(report.refused_moves, 0);
    assert!(report.moves >= 50_000 - 1);
    assert!(planned.most_sources < 50_000, "{}", planned.most_sources);
}

#[test]
fn half_the_feed_override_takes_longer_and_rapids_do_not() {
    let program = "G21 G90 G61 S600 M3\nG0 X100\nG1 X0 F6000\nM2\n";
    let full = plan(program).0.seconds;
    let half =
        plan_with(program, &[], MotionOptions { feed_override: Some(0.5), ..Default::default() });
    // 100 mm at 50 mm/s in place of 100 mm/s: 1 s more, and the ramp of 25 + 20 ms in place of
    // 50 + 20 ms.
    assert!((half.0.seconds - full - 0.975).abs() < 1e-6, "{} {full}", half.0.seconds);
}

#[test]
fn rapids_with_limits_of_their_own_take_their_own_time() {
    let program = "G21 G90 G61 S600 M3\nG0 X100\nG1 X0 F6000\nM2\n";
    let same = plan(program).0.seconds;
    let (slow, _) =
        plan_with(program, &["axes.X.rapid_acceleration = 1000 mm/s^2"], MotionOptions::default());
    // 200 mm/s: a ramp is 200/1000 + 1000/1e5 = 0.21 s in place of 0.12 s, but 100 mm are too
    // short for the first: with 1000 mm/s² the time is 2·(v/a + a/j) at v where (v/a + a/j)·v
    // is 100 mm.
    let (a, j) = (1000.0_f64, 100_000.0_f64);
    let v = ((a * a / j).powi(2) / 4.0 + a * 100.0).sqrt() - a * a / j / 2.0;
    let v = v.min(200.0);
    let ramp = v / a + a / j;
    let due = 2.0 * ramp + (100.0 - v * ramp) / v;
    let was = 0.12 + 100.0 / 200.0;
    assert!((slow.seconds - same - (due - was)).abs() < 1e-6, "{} {same} {due}", slow.seconds);
}

#[test]
fn a_dog_leg_rapid_takes_the_time_of_its_slowest_axis() {
    let program = "G21 G90 G61 S600 M3\nG0 X100 Y50\nM2\n";
    let seconds = |dog_leg_shape: bool| {
        let options = MotionOptions { dog_leg_shape, ..Default::default() };
        plan_with(program, &["rapid.shape = dog-leg"], options).0.seconds
    };
    // X alone takes 100 mm at 200 mm/s and one ramp of 0.12 s, whatever Y does meanwhile.
    assert!((seconds(false) - 0.62).abs() < 1e-6, "{}", seconds(false));
    // The shape with its bend costs no more than a stop there, which is another ramp.
    let shape = seconds(true);
    assert!(shape > 0.62 - 1e-9 && shape < 0.74, "{shape}");
}

/// Time of a program by its feeds and rapids alone, and with the planner.
#[derive(Default)]
struct Compared {
    planned: Planned,
    cuts_s: f64,
}

impl PlanSink for Compared {
    fn source(&mut self, source: &StepSource) {
        match source.kind {
            StepKind::Move(SegmentKind::Rapid) => {}
            _ => self.cuts_s += source.nominal_s,
        }
    }

    fn step(&mut self, step: PlannerStep<'_>, sources: &StepSources) {
        self.planned.step(step, sources);
    }
}

#[test]
fn every_program_of_the_repository_can_be_planned() {
    let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let mut folders = vec![root.join("examples"), root.join("tests/suite")];
    let mut count = 0;
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(&folder).into_iter().flatten().flatten() {
            let path = entry.path();
            if path.is_dir() {
                folders.push(path);
                continue;
            }
            let Ok(text) = std::fs::read_to_string(&path) else { continue };
            let machine = text.split_once("(machine: ").and_then(|(_, rest)| rest.split_once(')'));
            let machine = machine.and_then(|(name, _)| Machine::from_builtin(name).ok());
            let Some(mut machine) = machine else { continue };
            let head = text.lines().map_while(|line| line.strip_prefix('(')?.strip_suffix(')'));
            for assignment in head.filter_map(|line| line.strip_prefix("set: ")) {
                machine.set(assignment).expect("a key of the machine");
            }
            let mut sources = SourceMap::new();
            sources.add(Source::new("t.nc", text.as_bytes()));
            let Ok(job) = Job::new(sources, machine) else { continue };
            let mut compared = Compared::default();
            let report = job.plan(&MotionOptions::default(), &mut compared).expect("limits");
            let (planned, name) = (&compared.planned, path.display());
            assert_eq!(report.refused_moves, 0, "{name}: {:?}", report.refused);
            assert_eq!(planned.tags_without_source, 0, "{name}");
            assert!(planned.largest_gap < 2e-6, "{name}: {}", planned.largest_gap);
            assert!(planned.seconds.is_finite(), "{name}");
            assert!(
                planned.seconds > compared.cuts_s * (1.0 - 1e-3) - 1e-6,
                "{name}: {} s planned, {} s at the feeds",
                planned.seconds,
                compared.cuts_s
            );
            count += 1;
        }
    }
    assert!(count > 150, "{count} programs");
}
