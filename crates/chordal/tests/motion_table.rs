//! The motion table: eleven programs, from their text to samples, next to what LinuxCNC takes for
//! them. `cargo test -p chordal --test motion_table -- --nocapture` prints the rows of
//! docs/motion.md.

#![allow(clippy::disallowed_methods, reason = "a test reads the programs of the repository")]

mod motion_rows;

use chordal::geometry::{ParamCurve, Vec3};
use chordal::motion::{
    KinematicLimits, MachineLimits, MotionOptions, MotionSample, MotionStep, MoveRequest, PlanSink,
    PlannedTrajectory, PlannerLevel, PlannerStep, SetpointSampler, StepSource, StepSources,
};
use chordal::{Job, Machine, Source, SourceMap};
use chordal_motion::{LeastTimeGauge, LeastTimes, LimitUse, ReferenceQuality, largest_use};
use motion_rows::{ROWS, Row, folder};

/// What rounding may add to a limit.
const ABOVE: f64 = 1.0 + 1e-6;

/// A program with all its moves and its plan.
#[derive(Default)]
struct Planned {
    moves: Vec<MoveRequest>,
    stretches: Vec<PlannedTrajectory>,
}

impl PlanSink for Planned {
    fn request(&mut self, step: &MotionStep, _source: &StepSource) {
        if let MotionStep::Move(motion) = step {
            self.moves.push(*motion);
        }
    }

    fn step(&mut self, step: PlannerStep<'_>, _sources: &StepSources) {
        match step {
            PlannerStep::Trajectory(stretch) => self.stretches.push(stretch.clone()),
            PlannerStep::Wait { seconds, .. } => {
                assert_eq!(seconds, 0.0, "these programs never wait")
            }
        }
    }
}

impl Planned {
    fn new(row: &Row, machine: &Machine, level: PlannerLevel) -> Planned {
        let text = row.text();
        let mut sources = SourceMap::new();
        sources.add(Source::new(row.name, text.as_bytes()));
        let job = Job::new(sources, machine.clone()).expect("a job");
        let mut planned = Planned::default();
        let options = MotionOptions { level, ..MotionOptions::default() };
        let report = job.plan(&options, &mut planned).expect("limits");
        assert_eq!(report.refused_moves, 0, "{}", row.name);
        assert_eq!(report.cuts_without_feed, 0, "{}", row.name);
        planned
    }

    fn time_s(&self) -> f64 {
        self.stretches.iter().map(|stretch| stretch.duration_s() - stretch.overlap_s).sum()
    }

    fn largest_use(&self, limits: &KinematicLimits) -> LimitUse {
        self.stretches
            .iter()
            .map(|s| largest_use(s, limits, 8))
            .fold(LimitUse::default(), LimitUse::or)
    }

    fn samples(&self, period_s: f64) -> Vec<MotionSample> {
        let mut samples = Vec::new();
        let mut sampler = SetpointSampler::new(period_s);
        for stretch in &self.stretches {
            sampler.push(PlannerStep::Trajectory(stretch), |sample| samples.push(*sample));
        }
        sampler.finish(|sample| samples.push(*sample));
        samples
    }

    /// Bound and reference of this path.
    fn least(&self, limits: &KinematicLimits, effort: ReferenceQuality) -> LeastTimes {
        let mut gauge = LeastTimeGauge::new(*limits, effort);
        let feed = |tag| self.moves.iter().find(|motion| motion.tag == tag).unwrap().speed;
        let speeds: std::collections::BTreeMap<u64, f64> =
            self.stretches.iter().flat_map(|s| &s.pieces).map(|p| (p.tag, feed(p.tag))).collect();
        for stretch in &self.stretches {
            gauge.push(PlannerStep::Trajectory(stretch), |tag| speeds[&tag], |_| {});
        }
        gauge.finish(|_| {})
    }

    /// The largest distance of a sample from the programmed path, mm.
    fn deviation(&self, samples: &[MotionSample]) -> f64 {
        let index = |tag| self.moves.partition_point(|motion| motion.tag < tag);
        let mut most = 0.0_f64;
        for sample in samples {
            let [x, y, z, ..] = sample.position;
            let at = index(sample.tag);
            let near = at.saturating_sub(20)..(at + 21).min(self.moves.len());
            let distances =
                self.moves[near].iter().map(|m| m.curve.nearest(Vec3::new(x, y, z)).distance);
            most = most.max(distances.fold(f64::INFINITY, f64::min));
        }
        most
    }

    /// The distance that the program allows, mm.
    fn allowed(&self) -> f64 {
        let of = |motion: &MoveRequest| motion.corner.tolerance().map_or(0.0, |(mm, _)| mm);
        self.moves.iter().map(of).fold(1e-6, f64::max)
    }
}

/// The largest differences of samples over all axes: velocity, acceleration, jerk.
fn differences(samples: &[MotionSample], period_s: f64) -> [f64; 3] {
    let mut most = [0.0_f64; 3];
    for axis in 0..3 {
        let mut values: Vec<f64> = samples.iter().map(|sample| sample.position[axis]).collect();
        for largest in &mut most {
            values = values.windows(2).map(|pair| (pair[1] - pair[0]) / period_s).collect();
            *largest = values.iter().fold(*largest, |most, value| most.max(value.abs()));
        }
    }
    most
}

/// Everything that must hold of a plan; hands back its largest jerk and its deviation.
fn held(row: &Row, planned: &Planned, limits: &KinematicLimits) -> (f64, f64) {
    let name = row.name;
    let used = planned.largest_use(limits);
    let worst = used.velocity.max(used.acceleration).max(used.jerk);
    assert!(worst <= ABOVE, "{name}: {used:?}");
    let most = limits.axis(0).unwrap();
    let (mut deviation, mut jerk) = (0.0_f64, 0.0_f64);
    for period_s in [1e-3, 2.5e-4] {
        let samples = planned.samples(period_s);
        // Positions up to 50 mm are rounded to 1e-14 mm, times to a share of 1e-16.
        let rounding = 8.0 * (1e-14 + 200.0 * planned.time_s() * f64::EPSILON) / period_s.powi(3);
        let [v, a, j] = differences(&samples, period_s);
        assert!(v <= most.velocity * ABOVE, "{name} at {period_s} s: {v} mm/s");
        assert!(a <= most.acceleration * ABOVE, "{name} at {period_s} s: {a} mm/s²");
        assert!(j <= most.jerk * ABOVE + rounding, "{name} at {period_s} s: {j} mm/s³");
        deviation = deviation.max(planned.deviation(&samples));
        jerk = jerk.max(j);
    }
    assert!(
        deviation <= planned.allowed() * ABOVE,
        "{name}: {deviation} mm off the path, {} allowed",
        planned.allowed()
    );
    let (first, last) = (&planned.stretches[0], planned.stretches.last().unwrap());
    let ends =
        [(first.from(), planned.moves[0].from()), (last.to(), planned.moves.last().unwrap().to())];
    for (is, due) in ends {
        assert!(
            is.iter().zip(due).all(|(is, due)| (is - due).abs() < 1e-9),
            "{name}: {is:?} {due:?}"
        );
    }
    (jerk.max(used.jerk * most.jerk), deviation)
}

fn machine() -> (Machine, KinematicLimits) {
    let text = std::fs::read_to_string(folder().join("mill.toml")).expect("mill.toml");
    let machine = Machine::from_toml("mill.toml", &text, &|_| Err(String::new())).expect("a mill");
    let limits = MachineLimits::of(&machine).expect("limits");
    assert!(limits.assumed.is_empty());
    (machine, limits.cut)
}

/// Everything of a row.
fn check(row: &Row) {
    let (machine, limits) = machine();
    let fast = Planned::new(row, &machine, PlannerLevel::Fast);
    let (jerk, deviation) = held(row, &fast, &limits);
    // The reference of the long rows takes a minute: they are compared with the bound, which is
    // below it.
    let no_work = ReferenceQuality { total_nodes: 0, ..ReferenceQuality::default() };
    let effort = if row.reference { ReferenceQuality::default() } else { no_work };
    let (least, time_s) = (fast.least(&limits, effort), fast.time_s());
    assert!(!row.reference || least.unknown_s == 0.0, "{}: no reference was found", row.name);
    let least_s = if row.reference { least.reference_s } else { least.bound_s };
    assert!((least.time_s - time_s).abs() < 1e-9, "{}: {} {time_s}", row.name, least.time_s);
    let best = Planned::new(row, &machine, PlannerLevel::Best);
    held(row, &best, &limits);
    let best_s = best.time_s();
    let [trapezoid, trapezoid_new, s_curve] = row.linuxcnc_s;
    let line = format!(
        "| {} | {trapezoid:.3} | {trapezoid_new:.3} | {s_curve:.3} | {time_s:.3} | {best_s:.3} | {:.3} | {} | {:.2}e5 | {} |",
        row.title,
        least.bound_s,
        if row.reference { format!("{least_s:.3}") } else { "–".into() },
        jerk / 1e5,
        // Below a nanometre it is rounding.
        if deviation < 1e-6 { "0".into() } else { format!("{deviation:.4}") },
    );
    println!("{line}");
    let name = row.name;
    assert!(least.bound_s <= least.reference_s, "{name}: {least:?}");
    assert!(time_s <= s_curve, "{name}: {time_s} s, LinuxCNC {s_curve} s");
    assert!(time_s <= 1.10 * least_s, "{name}: {time_s} s, least {least_s} s");
    if let Some(most_s) = row.most_s {
        assert!(time_s <= most_s, "{name}: {time_s} s, {most_s} s wanted");
    }
    // The bound knows no jerk.
    let near = if row.reference { 1.01 } else { 1.05 };
    assert!(best_s <= near * least_s, "{name}: best {best_s} s, least {least_s} s");
    assert!(best_s <= time_s * (1.0 + 1e-9), "{name}: best {best_s} s, fast {time_s} s");
}

fn check_named(name: &str) {
    check(ROWS.iter().find(|row| row.name == name).expect("a row"));
}

macro_rules! rows {
    ($($name:ident)*) => {
        $(#[test]
        fn $name() {
            check_named(stringify!($name));
        })*

        #[test]
        fn every_row_is_tested() {
            assert_eq!(ROWS.map(|row| row.name), [$(stringify!($name)),*]);
        }
    };
}

rows! {
    line100_g61
    square_f3000_g611
    square_f3000_g64p001
    square_f3000_g64p01
    square_f9000_g64p001
    circle20_g61
    circle2x5_g61
    helix10x3_g61
    rrect_g61
    spiral2000_g64p001
    raster4000_g64p001
}
