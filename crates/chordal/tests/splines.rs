//! Splines of a program: their path, their time, their plan.

mod mill;

use chordal::geometry::{ParamCurve, Placement, Spline, Vec3};
use chordal::motion::{MotionOptions, PlanSink, PlannerStep, StepSources};
use chordal::{Job, Segment, SegmentKind, Source, SourceMap};
use chordal_motion::{LimitUse, largest_use};

/// An S of order 4 from (0, 0) to (7, 1), ten times as large.
const S_CURVE: &str = "G21 G90 G61 S600 M3 F6000\nG0 X0 Y0 Z0\nG5.2 X10 Y20 P1 L4\nX30 Y30 P2\n\
                       X50 Y0 P1\nX70 Y10 P1\nG5.3\nM2\n";

fn s_curve() -> Spline {
    let points = [(0.0, 0.0), (10.0, 20.0), (30.0, 30.0), (50.0, 0.0), (70.0, 10.0)];
    let points = points.map(|(x, y)| Vec3::new(x, y, 0.0)).to_vec();
    Spline::uniform(4, points, vec![1.0, 1.0, 2.0, 1.0, 1.0]).unwrap()
}

fn job(text: &str) -> Job<'_> {
    let mut sources = SourceMap::new();
    sources.add(Source::new("t.ngc", text.as_bytes()));
    Job::new(sources, mill::machine("inherits = 'mill.toml'")).expect("a job")
}

fn path(text: &str) -> Vec<Segment> {
    let mut segments = Vec::new();
    job(text).path(|segment| segments.push(*segment));
    segments.retain(|segment| segment.kind == SegmentKind::Spline);
    segments
}

#[derive(Default)]
struct Planned {
    seconds: f64,
    used: LimitUse,
    end: [f64; 6],
    farthest: f64,
}

impl PlanSink for Planned {
    fn step(&mut self, step: PlannerStep<'_>, _: &StepSources) {
        let PlannerStep::Trajectory(stretch) = step else { return };
        let limits = chordal::motion::MachineLimits::of(&mill::machine("inherits = 'mill.toml'"));
        self.seconds += stretch.duration_s() - stretch.overlap_s;
        self.used = self.used.or(largest_use(stretch, &limits.unwrap().cut, 3));
        self.end = stretch.to();
        let spans = s_curve().pieces().unwrap();
        for piece in &stretch.pieces {
            let [x, y, z, ..] = piece.at(0.5 * piece.length)[0];
            let place = Vec3::new(x, y, z);
            let away = spans.iter().map(|span| span.nearest(place).distance);
            self.farthest = self.farthest.max(away.fold(f64::INFINITY, f64::min));
        }
    }
}

#[test]
fn the_path_is_the_spline() {
    let segments = path(S_CURVE);
    assert_eq!(segments.len(), 2, "two spans between three knots");
    let length: f64 = segments.iter().map(|segment| segment.length_mm).sum();
    assert!((length - s_curve().length(1e-10)).abs() < 1e-8);
    // 6000 mm/min along the path.
    let seconds: f64 = segments.iter().map(|segment| segment.duration_s).sum();
    assert!((seconds - length / 100.0).abs() < 1e-9);
    let mut off = 0.0_f64;
    for segment in &segments {
        for corner in segment.curve.chords(0.01, Placement::Inscribed).unwrap() {
            let spans = s_curve().pieces().unwrap();
            let away = spans.iter().map(|span| span.nearest(corner).distance);
            off = off.max(away.fold(f64::INFINITY, f64::min));
        }
    }
    assert!(off < 1e-8, "{off}");
}

#[test]
fn inverse_time_is_the_time_of_the_whole_spline() {
    let text = S_CURVE.replace("G5.3", "G93 F30\nG5.3 F30");
    let seconds: f64 = path(&text).iter().map(|segment| segment.duration_s).sum();
    assert!((seconds - 2.0).abs() < 1e-9, "{seconds}");
}

#[test]
fn a_spline_is_planned_within_the_limits_in_every_path_mode() {
    for mode in ["G61", "G61.1", "G64 P0.01"] {
        let text = S_CURVE.replace("G61", mode);
        let mut planned = Planned::default();
        let report = job(&text).plan(&MotionOptions::default(), &mut planned).expect("limits");
        assert_eq!((report.refused_moves, report.cuts_without_feed), (0, 0), "{mode}");
        let worst = planned.used.velocity.max(planned.used.acceleration).max(planned.used.jerk);
        assert!(worst <= 1.0 + 1e-6, "{mode}: {:?}", planned.used);
        let nominal = s_curve().length(1e-9) / 100.0;
        assert!(
            planned.seconds > nominal && planned.seconds < 2.0 * nominal,
            "{mode}: {}",
            planned.seconds
        );
        assert!((planned.end[0] - 70.0).abs() < 1e-9 && (planned.end[1] - 10.0).abs() < 1e-9);
        assert!(planned.farthest < 0.01, "{mode}: {}", planned.farthest);
    }
}
