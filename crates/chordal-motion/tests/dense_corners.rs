//! Corners between dense runs: the next run begins before the last has ended, and the sum of both keeps every
//! limit and the tolerance.
//!
//! `CHORDAL_ROUNDS=n` takes more random paths.

#![allow(clippy::disallowed_methods, reason = "a test reads how many rounds it is to run")]

mod support;

use chordal_geometry::{AXES, Arc, Curve, Frame, Line, ParamCurve, Plane, Vec3};
use chordal_motion::{
    CornerMode, KinematicLimits, MotionSample, MoveRequest, PlannedTrajectory, PlannerLevel,
};
use support::dense::{self, Places};
use support::{cut, limits, plan, samples, time_of};

/// What rounding may add to a limit.
const ABOVE: f64 = 1.0 + 1e-6;

fn rounds(few: u64) -> u64 {
    std::env::var("CHORDAL_ROUNDS").ok().and_then(|text| text.parse().ok()).unwrap_or(few)
}

/// A path with corners, its moves, limits and tolerance, by a number.
struct Case {
    places: Places,
    corners: Vec<usize>,
    feed: f64,
    tolerance: f64,
    limits: KinematicLimits,
    /// A rotary axis moves as well.
    turns: bool,
}

impl Case {
    fn new(seed: u64) -> Case {
        let pick = |values: &[f64], by: u64| values[(seed / by) as usize % values.len()];
        let (places, corners) = dense::bends(seed + 1, pick(&[0.05, 0.1, 0.3, 1.0], 1), 4);
        Case {
            places,
            corners,
            feed: pick(&[1000.0, 200.0, 40.0], 4),
            tolerance: pick(&[0.01, 0.1, 0.002, 0.5], 3),
            turns: seed % 4 == 3,
            limits: limits(500.0, pick(&[5000.0, 1000.0, 20_000.0], 7), pick(&[1e5, 1e6, 2e4], 5)),
        }
    }

    fn moves(&self) -> Vec<MoveRequest> {
        let mut moves = dense::moves(&self.places, self.feed, self.tolerance);
        if self.turns {
            // An axis that sways while the tool moves.
            let angle = |index: usize| [2e-3 * (0.3 * index as f64).sin(), 0.0, 0.0];
            for (index, motion) in moves.iter_mut().enumerate() {
                (motion.rotary_from, motion.rotary_to) = (angle(index), angle(index + 1));
            }
        }
        moves
    }

    /// The same with a stop at each corner.
    fn stopping(&self) -> Vec<MoveRequest> {
        let mut moves = self.moves();
        assert_eq!(moves.len() + 1, self.places.len());
        self.corners.iter().for_each(|place| moves[place - 1].corner = CornerMode::Stop);
        moves
    }
}

fn square(a: [f64; 3], b: [f64; 3]) -> f64 {
    (0..3).map(|axis| (a[axis] - b[axis]).powi(2)).sum()
}

/// The distance of a place from the line between two.
fn distance(place: [f64; 3], [a, b]: [[f64; 3]; 2]) -> f64 {
    let length = square(a, b);
    let dot: f64 = (0..3).map(|axis| (place[axis] - a[axis]) * (b[axis] - a[axis])).sum();
    let share = if length > 0.0 { (dot / length).clamp(0.0, 1.0) } else { 0.0 };
    square(place, std::array::from_fn(|axis| a[axis] + share * (b[axis] - a[axis]))).sqrt()
}

fn nearest(place: [f64; 3], path: &[[f64; 3]]) -> f64 {
    path.windows(2).map(|ends| distance(place, [ends[0], ends[1]])).fold(f64::INFINITY, f64::min)
}

fn places_of(samples: &[MotionSample]) -> Places {
    samples
        .iter()
        .map(|sample| [sample.position[0], sample.position[1], sample.position[2]])
        .collect()
}

/// The differences of positions hold every limit.
fn check_limits(case: &Case, trajectories: &[PlannedTrajectory], name: &str) {
    for period in [1e-3, 2.5e-4] {
        let samples = samples(trajectories, period);
        // They make the overlaps that the plan counts, also where runs end in bends.
        let end = samples.last().map_or(0.0, |sample| sample.time_s);
        let late = end - time_of(trajectories);
        assert!((-1e-9..period).contains(&late), "{name}: setpoints end {late} s after the plan");
        let rate = |values: &[f64]| -> Vec<f64> {
            values.windows(2).map(|pair| (pair[1] - pair[0]) / period).collect()
        };
        let most = |values: &[f64]| values.iter().fold(0.0_f64, |all, value| all.max(value.abs()));
        let limit = |values: [f64; AXES], axis: usize| values[axis] * ABOVE;
        for axis in 0..4 {
            let x: Vec<f64> = samples.iter().map(|sample| sample.position[axis]).collect();
            let v = rate(&x);
            let a = rate(&v);
            let j = rate(&a);
            let late = samples.last().map_or(0.0, |sample| sample.time_s) * f64::EPSILON;
            let rounding = 4.0 * (1e-13 + most(&v) * late) / period.powi(3);
            let [v, a, j] = [most(&v), most(&a), most(&j)];
            assert!(v <= limit(case.limits.velocity(), axis), "{name}, axis {axis}: {v}");
            assert!(a <= limit(case.limits.acceleration(), axis), "{name}, axis {axis}: {a}");
            assert!(j <= limit(case.limits.jerk(), axis) + rounding, "{name}, axis {axis}: {j}");
        }
        let speed = samples.iter().map(MotionSample::speed).fold(0.0, f64::max);
        assert!(speed <= case.feed * ABOVE, "{name}: {speed} mm/s");
    }
}

#[test]
fn overlaps_keep_every_limit_and_the_tolerance_both_ways() {
    let (mut overlapped, mut corners) = (0, 0);
    for seed in 0..rounds(60) {
        let case = Case::new(seed);
        let name = format!("seed {seed}");
        let trajectories = plan(&case.moves(), case.limits, PlannerLevel::Fast);
        check_limits(&case, &trajectories, &name);
        let most = case.tolerance * ABOVE;
        let path = places_of(&samples(&trajectories, 5e-5));
        let step =
            2.0 * path.windows(2).map(|pair| square(pair[0], pair[1]).sqrt()).fold(0.0, f64::max);
        for place in path.iter().step_by(1 + path.len() / 2000) {
            let off = nearest(*place, &case.places);
            assert!(off <= most, "{name}: the tool is {off} mm off the path");
        }
        for corner in &case.corners {
            let off = nearest(case.places[*corner], &path);
            assert!(off <= most + step * step, "{name}: the tool passes a corner {off} mm from it");
        }
        // Never three at once.
        for pair in trajectories.windows(2) {
            let both = pair[0].overlap_s + pair[1].overlap_s;
            assert!(both <= pair[0].duration_s() * (1.0 + 1e-9), "{name}: {both} s");
        }
        overlapped += trajectories.iter().filter(|trajectory| trajectory.overlap_s > 0.0).count();
        corners += case.corners.len();
    }
    println!("{overlapped} overlaps at {corners} corners");
    assert!(2 * overlapped > corners, "{overlapped} overlaps at {corners} corners");
}

#[test]
fn no_path_is_slower_than_with_a_rest_at_its_corners() {
    for seed in 0..rounds(60) {
        let case = Case::new(seed);
        let ours = time_of(&plan(&case.moves(), case.limits, PlannerLevel::Fast));
        let rests = time_of(&plan(&case.stopping(), case.limits, PlannerLevel::Fast));
        assert!(ours <= rests * 1.001, "seed {seed}: {ours} s, with rests {rests} s");
    }
}

/// Dense chords along a wave, a tangent arc of many times their length, and the wave again.
fn wave_and_arc(radius: f64) -> Vec<MoveRequest> {
    let within = CornerMode::Joined { linear_mm: 0.01, rotary_rad: 1e-4 };
    let wave = |x: f64| [x, 0.05 * x * (0.8 * x).sin() * (10.0 - x) / 10.0, 0.0];
    let places: Places = (0..=100).map(|index| wave(0.1 * f64::from(index))).collect();
    let mut moves = dense::moves(&places, 1000.0, 0.01);
    let (end, before) = (places[100], places[99]);
    let heading = (end[1] - before[1]).atan2(end[0] - before[0]);
    let (sin, cos) = heading.sin_cos();
    let plane = Plane::Xy.frame();
    let center = Vec3::new(end[0] - radius * sin, end[1] + radius * cos, 0.0);
    let out = Vec3::new(sin, -cos, 0.0);
    let frame = Frame { origin: center, u: out, v: plane.w.cross(out), w: plane.w };
    let arc: Curve = Arc::new(frame, radius, 1.5, 0.0).into();
    let from = arc.end();
    let along = arc.tangent_at(arc.length());
    moves.push(cut(arc, 1000.0, within));
    let mut at = from;
    for index in 1..=100 {
        let [x, y, _] = wave(0.1 * f64::from(index));
        let next = from + along * x + plane.w.cross(along) * y;
        moves.push(cut(Line::new(at, next).into(), 1000.0, within));
        at = next;
    }
    moves.iter_mut().enumerate().for_each(|(index, motion)| motion.tag = index as u64);
    moves
}

#[test]
fn a_step_of_the_curvature_between_chords_and_an_arc_is_no_rest() {
    for radius in [2.0, 10.0, 50.0] {
        let moves = wave_and_arc(radius);
        let trajectories = plan(&moves, limits(500.0, 5000.0, 1e5), PlannerLevel::Fast);
        assert_eq!(trajectories.len(), 1, "R{radius}: rests between chords and arc");
        let mut most = 0.0_f64;
        for sample in samples(&trajectories, 1e-4) {
            most = most.max(support::distance(&moves, sample.tag as usize, 30, &sample.position));
        }
        println!("R{radius}: {:.4} s, {most:.5} mm off", time_of(&trajectories));
        assert!(most <= 0.01 * ABOVE, "R{radius}: {most} mm");
    }
}

#[test]
fn rows_overlap_at_their_ends_however_they_lie() {
    // Axes that take part in both movements share their jerk.
    for (degrees, most_s) in [(0.0, 10.1), (15.0, 10.1), (30.0, 10.1), (45.0, 10.1)] {
        let places = dense::turned(dense::raster(20, 60.0, 0.5, 0.2), degrees);
        let moves = dense::moves(&places, 1000.0, 0.01);
        let time = time_of(&plan(&moves, limits(500.0, 5000.0, 1e5), PlannerLevel::Fast));
        println!("{degrees} degrees: {time:.4} s");
        assert!(time <= most_s, "{degrees} degrees: {time} s");
    }
}

/// A sum of harmonics of 400 chords.
fn harmonics(chord: f64, seed: u64) -> Places {
    let mut places = dense::harmonics(chord, 4, seed);
    places.truncate(400);
    places
}

fn time_s(places: &[[f64; 3]], feed: f64, tolerance: f64) -> f64 {
    let moves = dense::moves(places, feed, tolerance);
    time_of(&plan(&moves, limits(500.0, 5000.0, 1e5), PlannerLevel::Fast))
}

#[test]
fn a_bend_that_is_round_within_a_lower_tolerance_is_no_corner_within_a_larger_one() {
    for seed in [1624, 2344] {
        let places = harmonics(0.05, seed);
        let [fine, wide] = [0.05, 0.0705].map(|tolerance| time_s(&places, 250.0, tolerance));
        assert!(wide <= 1.0002 * fine, "path {seed}: {wide} s above {fine} s");
    }
}

#[test]
fn corners_between_curves_share_the_jerk_alike_in_both_directions() {
    for (chord, seed, feed, tolerance) in
        [(0.2, 202, 250.0, 0.01), (0.4, 151, 250.0, 0.005), (0.4, 27, 250.0, 0.01)]
    {
        let mut places = harmonics(chord, seed);
        let there = time_s(&places, feed, tolerance);
        places.reverse();
        let back = time_s(&places, feed, tolerance);
        let off = (back / there - 1.0).abs();
        assert!(off < 0.001, "path {seed}: {there} s there, {back} s back");
    }
}
