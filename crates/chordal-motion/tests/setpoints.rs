//! Setpoints against a slow evaluation of their own: the velocity profile and the defining formulas of
//! the curves, derivatives by differences of places alone.

mod support;

use chordal_geometry::{
    AXES, Arc, Curve, EvenPart, Frame, Line, ParamCurve, Spiral, Spline, SplinePiece, Vec3,
};
use chordal_motion::{
    AxisLimit, AxisValues, CornerMode, JerkPhase, KinematicLimits, MotionPlanner, MotionSample,
    MoveKind, MoveRequest, PathPiece, PlannedTrajectory, PlannerLevel, PlannerOptions, PlannerStep,
    SetpointSampler, TrajectoryCursor,
};
use support::law::{LAW, Law, piece as over, straight};

/// The point at `s` mm of a curve, by its formula.
fn point(curve: &Curve, s: f64) -> Vec3 {
    let about = |center: Vec3, u: Vec3, w: Vec3, radius: f64, angle: f64| {
        center + u * (radius * libm::cos(angle)) + w.cross(u) * (radius * libm::sin(angle))
    };
    match curve {
        Curve::Line(line) => line.start + (line.end - line.start) * (s / line.length()),
        Curve::Arc(a) => {
            let share = s / libm::hypot(a.radius * a.sweep, a.rise);
            about(a.center, a.u, a.w, a.radius, a.sweep * share) + a.w * (a.rise * share)
        }
        Curve::Spiral(c) => {
            let share = spiral_share(c, s);
            let radius = c.radius_start + (c.radius_end - c.radius_start) * share;
            about(c.center, c.u, c.w, radius, c.sweep * share) + c.w * (c.rise * share)
        }
        Curve::Spline(piece) => piece.jet_at_parameter(spline_parameter(piece, s))[0],
    }
}

/// The parameter after `s` mm: by Newton's steps, on extrapolated sums of chords.
fn spline_parameter(piece: &SplinePiece, s: f64) -> f64 {
    let at = |t: f64| piece.jet_at_parameter(t)[0];
    let length_to = |to: f64| {
        // Sums of 8, 16, … chords are off by even powers of their number.
        let sums: [f64; 5] = std::array::from_fn(|k| {
            let count = 8 << k;
            let place = |n: usize| at(to * n as f64 / count as f64);
            (0..count).map(|n| place(n).distance(place(n + 1))).sum()
        });
        let mut row = sums;
        for order in 1..row.len() {
            for k in 0..row.len() - order {
                row[k] = row[k + 1] + (row[k + 1] - row[k]) / (4f64.powi(order as i32) - 1.0);
            }
        }
        row[0]
    };
    let mut t = s / piece.length();
    for _ in 0..6 {
        t -= (length_to(t) - s) / piece.jet_at_parameter(t)[1].length();
    }
    t
}

/// The even parts of a span with weights, and of one without.
fn bent() -> Vec<Curve> {
    let points = |of: &[[f64; 3]]| of.iter().map(|p| Vec3::from_array(*p)).collect::<Vec<Vec3>>();
    let round = points(&[[20.0, 0.0, 1.0], [22.0, 18.0, 0.0], [0.0, 20.0, 5.0]]);
    let wavy = points(&[
        [0.0, 0.0, 0.0],
        [15.0, 12.0, 3.0],
        [28.0, -8.0, 9.0],
        [50.0, 20.0, 0.0],
        [60.0, -5.0, 2.0],
    ]);
    let round = Spline::uniform(3, round, vec![1.0, 0.6, 1.2]).unwrap();
    let wavy = Spline::uniform(5, wavy, vec![1.0; 5]).unwrap();
    let mut parts = Vec::new();
    for piece in round.pieces().unwrap().into_iter().chain(wavy.pieces().unwrap()) {
        piece.even_parts(1e-6, &mut |part| match part {
            EvenPart::Bent(bent) => parts.push(Curve::Spline(bent)),
            EvenPart::Line(line) => parts.push(Curve::Line(line)),
        });
    }
    parts
}

/// The share of the sweep after `s` mm: by halves, on the closed form of the way.
fn spiral_share(c: &Spiral, s: f64) -> f64 {
    let growth = c.radius_end - c.radius_start;
    let m = libm::hypot(growth, c.rise);
    let length_to = |share: f64| {
        let primitive = |x: f64| {
            let g = libm::hypot(x, m);
            0.5 * (x * g + m * m * libm::asinh(x / m))
        };
        let around = c.sweep.abs();
        let (from, to) = (c.radius_start * around, (c.radius_start + growth * share) * around);
        (primitive(to) - primitive(from)) / (growth * around)
    };
    let (mut low, mut high) = (0.0, 1.0);
    for _ in 0..100 {
        let middle = 0.5 * (low + high);
        if length_to(middle) < s { low = middle } else { high = middle }
    }
    0.5 * (low + high)
}

fn sigma_in(phase: &JerkPhase, t: f64) -> f64 {
    phase.from + phase.speed * t + phase.acceleration * t * t / 2.0 + phase.jerk * t * t * t / 6.0
}

fn place_on(piece: &PathPiece, sigma: f64) -> AxisValues {
    let [x, d1, d2, d3] = &piece.start;
    let mut place: AxisValues = std::array::from_fn(|axis| {
        x[axis]
            + d1[axis] * sigma
            + d2[axis] * sigma * sigma / 2.0
            + d3[axis] * sigma * sigma * sigma / 6.0
    });
    if let Some((curve, from)) = &piece.base {
        for (place, part) in place.iter_mut().zip(point(curve, from + sigma).to_array()) {
            *place += part;
        }
    }
    place
}

/// One phase on one piece, with the time and the place at which they begin.
struct Part<'a> {
    phase: &'a JerkPhase,
    phase_from: f64,
    piece: &'a PathPiece,
    piece_from: f64,
}

impl Part<'_> {
    fn at(trajectory: &PlannedTrajectory, time_s: f64) -> Option<Part<'_>> {
        let mut phase_from = 0.0;
        let phase = trajectory.phases.iter().find(|phase| {
            let within = time_s - phase_from < phase.duration_s;
            phase_from += if within { 0.0 } else { phase.duration_s };
            within
        })?;
        let (sigma, mut piece_from) = (sigma_in(phase, time_s - phase_from), 0.0);
        let piece = trajectory.pieces.iter().find(|piece| {
            let within = sigma - piece_from < piece.length;
            piece_from += if within { 0.0 } else { piece.length };
            within
        })?;
        Some(Part { phase, phase_from, piece, piece_from })
    }

    fn place(&self, time_s: f64) -> AxisValues {
        let sigma = sigma_in(self.phase, time_s - self.phase_from);
        place_on(self.piece, sigma - self.piece_from)
    }

    fn holds(&self, time_s: f64) -> bool {
        let t = time_s - self.phase_from;
        let sigma = sigma_in(self.phase, t) - self.piece_from;
        t >= 0.0 && t <= self.phase.duration_s && sigma >= 0.0 && sigma <= self.piece.length
    }
}

/// Step of the differences, s: the path turns by less than a fiftieth of a radian in it.
const H: f64 = 4e-4;

/// Compares every setpoint of a trajectory with the slow evaluation. Places may be `off` mm apart;
/// the derivatives must be those of the slow places, as far as these are exact.
fn compare(trajectory: &PlannedTrajectory, period_s: f64, off: f64) -> usize {
    let mut samples = Vec::new();
    let mut sampler = SetpointSampler::new(period_s);
    sampler.push(PlannerStep::Trajectory(trajectory), |sample| samples.push(*sample));
    sampler.finish(|sample| samples.push(*sample));
    let mut compared = 0;
    for sample in &samples {
        let Some(part) = Part::at(trajectory, sample.time_s) else { continue };
        let slow = part.place(sample.time_s);
        for (fast, slow) in sample.position.iter().zip(&slow) {
            let difference = (fast - slow).abs();
            assert!(difference <= off, "{slow} at {} s: {difference:e} apart", sample.time_s);
        }
        compared += 1;
        if part.holds(sample.time_s - 3.0 * H) && part.holds(sample.time_s + 3.0 * H) {
            let noise = off + 4e-16 * slow.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
            compare_derivatives(sample, &part, noise);
        }
    }
    compared
}

/// The derivatives against differences of the fourth order.
fn compare_derivatives(sample: &MotionSample, part: &Part<'_>, noise: f64) {
    let near: [AxisValues; 7] =
        std::array::from_fn(|n| part.place(sample.time_s + (n as f64 - 3.0) * H));
    // Weights of the seven places, and what these are off, by the same division.
    let kinds = [
        (&sample.velocity, [0.0, 1.0, -8.0, 0.0, 8.0, -1.0, 0.0], 12.0 * H, 2.0),
        (&sample.acceleration, [0.0, -1.0, 16.0, -30.0, 16.0, -1.0, 0.0], 12.0 * H * H, 6.0),
        (&sample.jerk, [1.0, -8.0, 13.0, 0.0, -13.0, 8.0, -1.0], 8.0 * H * H * H, 6.0),
    ];
    for (order, (fast, weights, step, times)) in kinds.into_iter().enumerate() {
        let size = fast.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
        let slack = times * noise / H.powi(order as i32 + 1) + 1e-5 * size;
        for (axis, fast) in fast.iter().enumerate() {
            let sum: f64 = weights.iter().zip(&near).map(|(weight, at)| weight * at[axis]).sum();
            let slow = sum / step;
            assert!(
                (fast - slow).abs() <= slack,
                "derivative {} of axis {axis} at {} s: {fast}, {slow} by differences",
                order + 1,
                sample.time_s
            );
        }
    }
}

fn tilted() -> Frame {
    Frame::from_normal(Vec3::new(3.0, -2.0, 1.0), Vec3::new(1.0, 2.0, 0.5), Vec3::Z).unwrap()
}

#[test]
fn arcs_and_helices() {
    for (radius, sweep, rise) in
        [(25.0, -4.0, 0.0), (10.0, 40.0, 0.0), (12.0, 30.0, 55.0), (5.0, -60.0, -1e-3)]
    {
        let curve: Curve = Arc::new(tilted(), radius, sweep, rise).into();
        let trajectory = LAW.trajectory(vec![over(curve, 1)]);
        assert!(compare(&trajectory, 0.001, 1e-12) > 500);
    }
}

#[test]
fn a_long_arc_of_a_large_radius() {
    // A millimetre of a kilometre is a rounding of 1e-10 mm; 300 m of it are travelled.
    let radius = 1e6;
    let frame = Frame { origin: Vec3::new(-radius, 0.0, 0.0), ..tilted() };
    for sweep in [4e-4, -1e-1, 0.3] {
        let curve: Curve = Arc::new(frame, radius, sweep, 0.0).into();
        let trajectory = Law { speed: 800.0, ..LAW }.trajectory(vec![over(curve, 1)]);
        assert!(compare(&trajectory, 0.0037, 1e-9) > 100);
    }
}

#[test]
fn a_tiny_arc() {
    // Thirty turns of a micrometre, at a speed that turns slowly enough for differences.
    let law = Law { speed: 0.05, acceleration: 1.0, jerk: 100.0 };
    for rise in [0.0, 1e-3] {
        let curve: Curve = Arc::new(tilted(), 1e-3, 190.0, rise).into();
        let trajectory = law.trajectory(vec![over(curve, 1)]);
        assert!(compare(&trajectory, 0.001, 1e-14) > 1000);
    }
}

#[test]
fn spirals() {
    for (radii, sweep, rise) in [
        ((4.0, 12.0), 6.0, 1.0),
        ((0.0, 10.0), -7.0, 0.0),
        ((30.0, 5.0), 9.0, 0.0),
        ((10.0, 10.5), 40.0, 20.0),
        ((2.0, 40.0), 1.0, 0.0),
    ] {
        let curve: Curve = Spiral::new(tilted(), radii, sweep, rise).into();
        let law = Law { speed: 30.0, acceleration: 600.0, jerk: 2e4 };
        let trajectory = law.trajectory(vec![over(curve, 1)]);
        assert!(compare(&trajectory, 0.001, 1e-11) > 500, "{radii:?}");
    }
}

#[test]
fn splines() {
    let law = Law { speed: 60.0, acceleration: 900.0, jerk: 4e4 };
    for curve in bent() {
        let trajectory = law.trajectory(vec![over(curve, 1)]);
        // Within 1e-9 mm of the curve, and what the sums of chords are off.
        assert!(compare(&trajectory, 0.009, 1.2e-9) > 5, "{curve:?}");
    }
}

#[test]
fn a_spiral_that_hardly_grows() {
    let curve: Curve = Spiral::new(tilted(), (20.0, 20.0 + 1e-9), 12.0, 0.0).into();
    let arc: Curve = Arc::new(tilted(), 20.0, 12.0, 0.0).into();
    let [one, two] = [curve, arc].map(|curve| LAW.trajectory(vec![over(curve, 1)]));
    let (mut a, mut b) = (TrajectoryCursor::default(), TrajectoryCursor::default());
    let mut t = 0.0;
    while t < one.duration_s() {
        let (a, b) = (a.at(&one, t), b.at(&two, t));
        for axis in 0..3 {
            // Half of the growth for each radian of its way, and all of it outward.
            assert!((a.position[axis] - b.position[axis]).abs() < 7.1e-9, "{t}");
            assert!((a.acceleration[axis] - b.acceleration[axis]).abs() < 1e-4, "{t}");
        }
        t += 0.001;
    }
}

#[test]
fn corrections_over_curves_and_turning_axes() {
    let bent = |mut piece: PathPiece| {
        piece.start[0] = [0.1, -0.2, 0.3, 1.0, 2.0, -3.0];
        piece.start[1][4] = 0.02;
        piece.start[2] = [1e-3, -2e-3, 1e-3, 1e-4, 0.0, 0.0];
        piece.start[3] = [-1e-5, 1e-5, 2e-5, 0.0, 1e-6, 0.0];
        piece
    };
    let arc: Curve = Arc::new(tilted(), 25.0, -3.0, 4.0).into();
    let spiral: Curve = Spiral::new(tilted(), (8.0, 14.0), 6.0, 0.0).into();
    let line = straight([0.0; AXES], [0.6, 0.0, 0.8, 0.0, 0.0, 0.01], 70.0, 1);
    for piece in [bent(over(arc, 1)), bent(over(spiral, 1)), bent(line)] {
        let trajectory = Law { speed: 60.0, ..LAW }.trajectory(vec![piece]);
        assert!(compare(&trajectory, 0.001, 1e-11) > 500);
    }
}

#[test]
fn a_curve_in_pieces_is_the_curve() {
    let arc: Curve = Arc::new(tilted(), 25.0, -3.0, 4.0).into();
    let spiral: Curve = Spiral::new(tilted(), (8.0, 14.0), 6.0, 0.0).into();
    for curve in bent().into_iter().chain([arc, spiral]) {
        let whole = LAW.trajectory(vec![over(curve, 1)]);
        let (mut pieces, mut from) = (Vec::new(), 0.0);
        for share in [0.1, 0.25, 0.05, 0.3, 0.3] {
            let length = curve.length() * share;
            let piece = over(curve, 1);
            pieces.push(PathPiece { length, base: Some((curve, from)), ..piece });
            from += length;
        }
        let cut = PlannedTrajectory { pieces, ..whole.clone() };
        let (mut a, mut b) = (TrajectoryCursor::default(), TrajectoryCursor::default());
        let mut t = 0.0;
        while t < whole.duration_s() {
            let (a, b) = (a.at(&whole, t), b.at(&cut, t));
            for axis in 0..3 {
                assert!((a.position[axis] - b.position[axis]).abs() < 1e-12);
                assert!((a.jerk[axis] - b.jerk[axis]).abs() < 1e-6);
            }
            t += 0.001;
        }
    }
}

#[test]
fn an_instant_is_the_same_whatever_was_sampled_before() {
    let spiral: Curve = Spiral::new(tilted(), (0.0, 14.0), 20.0, 3.0).into();
    let arc: Curve = Arc::new(tilted(), 25.0, -3.0, 4.0).into();
    for curve in bent().into_iter().chain([spiral, arc]) {
        let trajectory = LAW.trajectory(vec![over(curve, 1)]);
        let mut walking = TrajectoryCursor::default();
        let mut t = 0.0;
        while t < trajectory.duration_s() {
            let (walked, fresh) =
                (walking.at(&trajectory, t), TrajectoryCursor::default().at(&trajectory, t));
            assert_eq!(walked, fresh, "to the bit, at {t} s");
            t += 0.0013;
        }
    }
}

/// A line, a tangent arc, a line at a corner and a spiral, passed within a tolerance.
fn eased() -> Vec<PlannedTrajectory> {
    let axis = Some(AxisLimit { velocity: 200.0, acceleration: 2000.0, jerk: 1e5 });
    let limits = KinematicLimits::new([axis, axis, axis, None, None, None]).unwrap();
    let at = |x: f64, y: f64| Vec3::new(x, y, 0.0);
    let flat = |x: f64, y: f64| Frame { origin: at(x, y), u: -Vec3::Y, v: Vec3::X, w: Vec3::Z };
    let arc = Arc::new(flat(60.0, 20.0), 20.0, 1.5, 0.0);
    let line = Line::new(arc.end(), at(90.0, 60.0));
    let spiral = Spiral::new(
        Frame { origin: line.end + Vec3::Y * 15.0, ..flat(0.0, 0.0) },
        (15.0, 25.0),
        5.0,
        0.0,
    );
    let curves: [Curve; 4] =
        [Line::new(at(0.0, 0.0), at(60.0, 0.0)).into(), arc.into(), line.into(), spiral.into()];
    let mut planner = MotionPlanner::new(limits, PlannerOptions::new(PlannerLevel::Fast));
    let mut trajectories = Vec::new();
    let mut take = |step: PlannerStep<'_>| {
        if let PlannerStep::Trajectory(trajectory) = step {
            trajectories.push(trajectory.clone());
        }
    };
    for (tag, curve) in curves.into_iter().enumerate() {
        let motion = MoveRequest {
            curve,
            rotary_from: [0.0; 3],
            rotary_to: [0.0; 3],
            path_length: None,
            speed: 80.0,
            corner: CornerMode::Joined { linear_mm: 0.05, rotary_rad: 0.0 },
            kind: MoveKind::Cut,
            tag: tag as u64,
        };
        planner.push(&motion, &mut take).unwrap();
    }
    planner.finish(&mut take);
    trajectories
}

#[test]
fn eased_corners_between_lines_arcs_and_spirals() {
    let trajectories = eased();
    let compared: usize =
        trajectories.iter().map(|trajectory| compare(trajectory, 0.000_25, 1e-11)).sum();
    let bent = trajectories.iter().flat_map(|trajectory| &trajectory.pieces);
    let bent = bent.filter(|piece| piece.start[3] != [0.0; AXES]);
    assert!(bent.filter(|piece| piece.base.is_some()).count() >= 2, "eased over a curve");
    assert!(compared > 4000, "{compared}");
}
