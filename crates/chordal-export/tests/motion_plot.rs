//! Pictures of a motion made by hand.

use chordal::machine::AXES;
use chordal::motion::{
    AxisLimit, JerkPhase, KinematicLimits, MachineLimits, MotionOptions, PathPiece, PlanSink,
    PlannedTrajectory, PlannerStep, SetpointSampler, StepSource, StepSources,
};
use chordal::{Job, Machine, Source, SourceMap};
use chordal_export::{MotionPlot, PlotOptions};

/// From rest to rest over a length, with 100 mm/s, 2000 mm/s² and 1e5 mm/s³ along the path.
fn phases(length: f64) -> Vec<JerkPhase> {
    let cruise = (length - 7.0) / 100.0;
    let mut at = (0.0, 0.0, 0.0);
    let durations = [0.02, 0.03, 0.02, cruise, 0.02, 0.03, 0.02];
    let jerks = [1e5, 0.0, -1e5, 0.0, -1e5, 0.0, 1e5];
    durations
        .into_iter()
        .zip(jerks)
        .map(|(duration_s, jerk)| {
            let phase = JerkPhase { duration_s, from: at.0, speed: at.1, acceleration: at.2, jerk };
            let along = phase.at(duration_s);
            at = (along.sigma, along.speed, along.acceleration);
            phase
        })
        .collect()
}

/// One side of a square, with a tag.
fn side(from: [f64; 2], direction: [f64; 2], length: f64, tag: u64) -> PlannedTrajectory {
    let mut start = [[0.0; AXES]; 4];
    start[0][..2].copy_from_slice(&from);
    start[1][..2].copy_from_slice(&direction);
    let pieces = vec![PathPiece { length, base: None, start, tag }];
    PlannedTrajectory { pieces, phases: phases(length), overlap_s: 0.0 }
}

fn limits() -> KinematicLimits {
    let limit = |jerk| Some(AxisLimit { velocity: 200.0, acceleration: 2500.0, jerk });
    KinematicLimits::new([limit(1.2e5), limit(1.2e5), limit(9e4), None, None, None]).unwrap()
}

fn square() -> MotionPlot {
    let mut plot = MotionPlot::new(&limits(), false);
    let sources = StepSources::default();
    plot.tool(0.0, 3);
    for (line, (from, direction)) in [
        ([0.0, 0.0], [1.0, 0.0]),
        ([50.0, 0.0], [0.6, 0.8]),
        ([80.0, 40.0], [-1.0, 0.0]),
        ([30.0, 40.0], [-0.6, -0.8]),
    ]
    .into_iter()
    .enumerate()
    {
        let tag = StepSource::tag_of(line as u32, 10 + line as u32);
        plot.step(PlannerStep::Trajectory(&side(from, direction, 50.0, tag)), &sources);
        if line == 1 {
            plot.step(PlannerStep::Wait { seconds: 0.4, tag }, &sources);
            plot.tool(1.54, 12);
        }
    }
    plot.finish();
    plot
}

fn options() -> PlotOptions {
    PlotOptions {
        title: "square.nc".into(),
        subtitle: "by hand · 2.7 s".into(),
        ..PlotOptions::default()
    }
}

#[test]
fn the_sheet_says_what_it_shows() {
    let svg = square().svg(&options());
    for text in [
        "square.nc",
        "Speed over time, mm/min",
        "Acceleration over time, mm/s²; limits X Y 2,500",
        "Jerk over time, m/s³; limits X Y 120",
        "Speed along the path, mm/min",
        ">6,000<",
        ">0.5 s<",
        ">T12<",
        ">line 11<",
        "limit of an axis",
    ] {
        assert!(svg.contains(text), "{text} is missing");
    }
    // Z does not move: neither its curve nor its limit is there.
    assert!(!svg.contains(">Z<") && !svg.contains("Z 2,500"));
}

#[test]
fn a_sheet_in_inches() {
    let mut plot = square();
    plot.set_inch(true);
    let svg = plot.svg(&options());
    for text in ["Speed over time, in/min", "in/s²", "in/s³", "0 in<"] {
        assert!(svg.contains(text), "{text} is missing");
    }
    assert!(!svg.contains("mm/min"));
}

#[test]
fn an_hour_takes_no_more_room_than_a_second() {
    let side = side([0.0, 0.0], [1.0, 0.0], 360_000.0, 7);
    let mut plot = MotionPlot::new(&limits(), false);
    let mut sampler = SetpointSampler::new(0.01);
    sampler.push(PlannerStep::Trajectory(&side), |sample| plot.sample(sample, 7));
    sampler.finish(|sample| plot.sample(sample, 7));
    let svg = plot.svg(&options());
    assert!(svg.len() < 500_000, "{} bytes", svg.len());
    // 0.07 s of acceleration in an hour are still there.
    assert!(svg.contains(">6,000<") && svg.contains("0 min<") && svg.contains("0 m<"));
}

#[test]
fn nothing_and_any_size_can_be_drawn() {
    let mut empty = MotionPlot::new(&limits(), true);
    empty.finish();
    for (width_px, height_px) in [(0, 0), (200, 200), (5000, 300)] {
        let options = PlotOptions { width_px, height_px, ..options() };
        for plot in [&empty, &square()] {
            let svg = plot.svg(&options);
            assert!(svg.ends_with("</svg>\n") && !svg.contains("NaN") && !svg.contains("inf"));
        }
    }
    assert!(square().png(&PlotOptions { width_px: 0, ..options() }).is_err());
    assert_eq!(square().png(&options()).unwrap()[1..4], *b"PNG");
}

struct Drawn(MotionPlot);

impl PlanSink for Drawn {
    fn step(&mut self, step: PlannerStep<'_>, sources: &StepSources) {
        self.0.step(step, sources);
    }
}

fn planned(name: &str, program: &[u8], machine: &str) -> MotionPlot {
    let mut sources = SourceMap::new();
    sources.add(Source::new(name, program));
    let job = Job::new(sources, Machine::from_builtin(machine).unwrap()).unwrap();
    let limits = MachineLimits::of(job.machine()).unwrap();
    let mut drawn = Drawn(MotionPlot::new(&limits.cut, job.report().summary.inch));
    job.plan(&MotionOptions::default(), &mut drawn).unwrap();
    drawn.0.finish();
    drawn.0
}

#[test]
fn a_program_with_two_tools() {
    let program = b"O1\nT1 M6\nG20 G90 G0 X0 Y0\nS900 M3\nG1 X4. F60.\nM5\nT7 M6\nM3\n\
                    G3 X4. Y2. R1.\nM30\n";
    let svg = planned("O1.nc", program, "haas-vf2").svg(&options());
    for text in ["in/min", ">T1<", ">T7<", ">X<", ">Y<", ">line 5<", ">line 9<"] {
        assert!(svg.contains(text), "{text} is missing");
    }
}

/// Setpoints of a program of days are further apart, so that their number has an end.
#[test]
fn a_program_of_days_has_no_more_setpoints_than_one_of_hours() {
    let usual = MotionPlot::period_s(0.0);
    assert_eq!(MotionPlot::period_s(3600.0), usual);
    for days in [1.0, 3.5, 400.0] {
        let time_s = days * 86_400.0;
        let count = time_s / MotionPlot::period_s(time_s);
        assert!(count <= 20_000_001.0 && MotionPlot::period_s(time_s) > usual, "{days}: {count}");
    }
    // The whole of it is drawn all the same.
    let mut plot = MotionPlot::new(&limits(), false).lasting(5.0 * 86_400.0);
    let sources = StepSources::default();
    let tag = StepSource::tag_of(0, 1);
    plot.step(PlannerStep::Trajectory(&side([0.0, 0.0], [1.0, 0.0], 50.0, tag)), &sources);
    plot.step(PlannerStep::Wait { seconds: 5.0 * 86_400.0, tag }, &sources);
    plot.finish();
    let svg = plot.svg(&options());
    assert!(
        svg.contains("120 h") || svg.contains("5 d") || svg.contains("120"),
        "no axis of five days"
    );
}
