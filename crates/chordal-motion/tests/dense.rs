//! Dense chords: near the least time, within every limit and the tolerance, and never slower for more
//! feed, acceleration, jerk or tolerance, for finer chords, or backwards.
//!
//! `CHORDAL_ROUNDS=n` takes more random paths.

#![allow(clippy::disallowed_methods, reason = "a test reads how many rounds it is to run")]

mod support;

use chordal_motion::{
    CornerMode, KinematicLimits, LimitUse, MoveRequest, PlannedTrajectory, PlannerLevel,
    largest_use,
};
use support::dense::{self, Places};
use support::{cut, limits, line, plan, samples, time_of};

const FEED: f64 = 1000.0;

fn fast() -> KinematicLimits {
    limits(500.0, 5000.0, 1e5)
}

fn planned(
    places: &[[f64; 3]],
    feed: f64,
    tolerance: f64,
    limits: KinematicLimits,
) -> Vec<PlannedTrajectory> {
    plan(&dense::moves(places, feed, tolerance), limits, PlannerLevel::Fast)
}

fn rounds(few: u64) -> u64 {
    std::env::var("CHORDAL_ROUNDS").ok().and_then(|text| text.parse().ok()).unwrap_or(few)
}

/// The paths of the table, each with the time that it may take, s: a little more than the least time
/// with jerk, by conic programs on a fine grid.
fn table() -> Vec<(&'static str, Places, f64)> {
    vec![
        ("ellipse, 334 chords", dense::ellipse(334, None), 0.57),
        ("ellipse, 1,336 chords", dense::ellipse(1336, None), 0.57),
        ("ellipse, 1,336 chords, 3 decimals", dense::ellipse(1336, Some(3)), 0.57),
        ("ellipse, 5,000 chords", dense::ellipse(5000, None), 0.57),
        ("ellipse, 5,000 chords, 3 decimals", dense::ellipse(5000, Some(3)), 0.57),
        ("circle R5, two turns", dense::circle(5.0, 2.0, 0.1, None), 0.57),
        ("spiral", dense::spiral(0.1), 3.05),
        ("star", dense::star(0.1), 1.36),
        ("trident", dense::trident(0.1), 1.27),
        ("butterfly", dense::butterfly(0.1), 3.05),
        ("raster", dense::raster(20, 60.0, 0.5, 0.2), 10.1),
    ]
}

#[test]
fn dense_chords_take_little_more_than_the_least_time() {
    for (name, places, most_s) in table() {
        let trajectories = planned(&places, FEED, 0.01, fast());
        let time = time_of(&trajectories);
        let used = trajectories
            .iter()
            .map(|s| largest_use(s, &fast(), 7))
            .fold(LimitUse::default(), LimitUse::or);
        println!("{name}: {time:.4} s, {used:?}");
        assert!(time <= most_s, "{name}: {time} s");
        assert!(used.velocity <= 1.0 + 1e-9, "{name}: {used:?}");
        assert!(used.acceleration <= 1.003 && used.jerk <= 1.001, "{name}: {used:?}");
    }
}

#[test]
fn machines_that_reach_their_acceleration_at_once_have_curves() {
    let limits = limits(500.0, 1000.0, 1e6);
    for (name, places, most_s) in [
        ("ellipse, 5,000 chords, 3 decimals", dense::ellipse(5000, Some(3)), 1.07),
        ("star", dense::star(0.1), 2.25),
        ("spiral", dense::spiral(0.1), 6.16),
    ] {
        let time = time_of(&planned(&places, FEED, 0.01, limits));
        assert!(time <= most_s, "{name}: {time} s");
    }
}

/// Paths on which an axis turned back where the first profile of a window fell to nothing: a profile that nearly
/// stops was all that was found from there.
#[test]
fn no_law_nearly_stops_where_an_axis_turns_back() {
    let harmonics = |chord: f64, seed: u64| {
        let mut places = dense::harmonics(chord, 4, seed);
        places.truncate(1000);
        places
    };
    let time = |places: &[[f64; 3]], feed: f64, tolerance: f64| {
        time_of(&planned(places, feed, tolerance, fast()))
    };
    let there = harmonics(0.2, 494);
    let mut back = there.clone();
    back.reverse();
    let ratio = time(&back, 1000.0, 0.05) / time(&there, 1000.0, 0.05);
    assert!((ratio - 1.0).abs() < 1e-3, "backwards {ratio}");
    let places = harmonics(0.4, 1563);
    let ratio = time(&places, 250.0, 1.41 * 0.02) / time(&places, 250.0, 0.02);
    assert!(ratio < 1.005, "more tolerance {ratio}");
    let places = harmonics(0.4, 4155);
    let ratio = time(&places, 1.26 * 250.0, 0.002) / time(&places, 250.0, 0.002);
    assert!(ratio < 1.001, "more feed {ratio}");
}

/// The least distance of a place from the chords after one of them, no more than `reach` of them, and the
/// number of the nearest.
fn distance(place: [f64; 3], places: &[[f64; 3]], from: usize, reach: usize) -> (f64, usize) {
    let mut best = (f64::INFINITY, from);
    let last = (from + reach).min(places.len() - 1);
    for index in from.saturating_sub(reach)..last {
        let (a, b) = (places[index], places[index + 1]);
        let dot = |x: [f64; 3], y: [f64; 3]| x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
        let less = |x: [f64; 3], y: [f64; 3]| [x[0] - y[0], x[1] - y[1], x[2] - y[2]];
        let (along, offset) = (less(b, a), less(place, a));
        let square = dot(along, along);
        let share = if square > 0.0 { (dot(offset, along) / square).clamp(0.0, 1.0) } else { 0.0 };
        let off = less(offset, along.map(|part| part * share));
        let off = dot(off, off).sqrt();
        if off < best.0 {
            best = (off, index);
        }
    }
    best
}

fn largest_distance(trajectories: &[PlannedTrajectory], places: &[[f64; 3]]) -> f64 {
    let (mut most, mut near) = (0.0_f64, 0);
    // No axis moves more than a tenth of a millimetre from sample to sample.
    let least = |pair: &[[f64; 3]]| (0..3).map(|k| (pair[0][k] - pair[1][k]).powi(2)).sum::<f64>();
    let chord = places.windows(2).map(least).fold(f64::INFINITY, f64::min).sqrt();
    let reach = 5 + (0.2 / chord) as usize;
    for sample in samples(trajectories, 0.2e-3) {
        let [x, y, z, ..] = sample.position;
        let (off, index) = distance([x, y, z], places, near, reach);
        (most, near) = (most.max(off), index);
    }
    most
}

#[test]
fn the_curve_stays_within_the_tolerance() {
    for seed in 0..rounds(24) {
        let chord = [0.02, 0.05, 0.1, 0.4][seed as usize % 4];
        let tolerance = [0.002, 0.01, 0.05][seed as usize % 3];
        let places = dense::harmonics(chord, 3 + seed as i32 % 2, seed + 1);
        let trajectories = planned(&places, FEED, tolerance, fast());
        let off = largest_distance(&trajectories, &places);
        assert!(off <= tolerance * (1.0 + 1e-6), "seed {seed}: {off} mm of {tolerance}");
        let end = trajectories[trajectories.len() - 1].to();
        let last = places[places.len() - 1];
        assert!((0..3).all(|axis| (end[axis] - last[axis]).abs() < 1e-9), "{end:?} {last:?}");
    }
}

#[test]
fn corners_sharper_than_the_tolerance_stay() {
    // A square of 2 mm in chords of 0.1 mm.
    let mut places: Places = Vec::new();
    let corners = [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0], [0.0, 0.0]];
    for pair in corners.windows(2) {
        for step in 0..20 {
            let share = f64::from(step) / 20.0;
            let at = |axis: usize| pair[0][axis] + share * (pair[1][axis] - pair[0][axis]);
            places.push([at(0), at(1), 0.0]);
        }
    }
    places.push([0.0; 3]);
    for tolerance in [0.001, 0.01] {
        let trajectories = planned(&places, FEED, tolerance, fast());
        assert!(largest_distance(&trajectories, &places) <= tolerance * (1.0 + 1e-6));
    }
}

/// Times along a row of settings; how much one is slower than the quickest before it, as a share.
fn worst_step(times: &[f64]) -> f64 {
    let mut least = f64::INFINITY;
    times.iter().fold(0.0_f64, |worst, time| {
        let step = time / least - 1.0;
        least = least.min(*time);
        worst.max(step)
    })
}

fn figures() -> [(&'static str, Places); 3] {
    [
        ("ellipse", dense::ellipse(1336, Some(3))),
        ("star", dense::star(0.1)),
        ("harmonics", dense::harmonics(0.1, 4, 1)),
    ]
}

#[test]
fn more_of_the_axes_or_of_the_feed_is_never_slower() {
    // The profiles are within 2e-4 of the best on their grid, and the grid changes with the limits. The curve
    // does so with acceleration and jerk: it is no smoother than the axes need.
    const MAX_SLOWER_SHARES: [f64; 3] = [1e-3, 1e-2, 1e-3];
    for (name, places) in figures() {
        let row = |time: &dyn Fn(f64) -> f64| {
            let times: Vec<f64> = (0..7).map(|step| time(1.4_f64.powi(step))).collect();
            worst_step(&times)
        };
        let time = |feed, limits| time_of(&planned(&places, feed, 0.01, limits));
        let by_feed = row(&|factor| time(60.0 * factor, fast()));
        let by_acceleration = row(&|factor| time(FEED, limits(500.0, 1500.0 * factor, 1e5)));
        let by_jerk = row(&|factor| time(FEED, limits(500.0, 5000.0, 2e4 * factor)));
        println!("{name}: feed {by_feed:e}, acceleration {by_acceleration:e}, jerk {by_jerk:e}");
        let worst = [by_feed, by_acceleration, by_jerk];
        assert!(
            worst.iter().zip(MAX_SLOWER_SHARES).all(|(worst, most)| *worst <= most),
            "{name}: {worst:?}"
        );
    }
}

#[test]
fn finer_chords_fewer_decimals_and_the_reverse_path_take_as_long() {
    let time = |places: &[[f64; 3]]| time_of(&planned(places, FEED, 0.01, fast()));
    let whole = time(&dense::ellipse(1336, None));
    for (count, decimals) in [(2672, None), (5344, None), (1336, Some(4)), (1336, Some(3))] {
        let other = time(&dense::ellipse(count, decimals));
        assert!(other <= 1.01 * whole, "{count} chords, {decimals:?}: {other} s for {whole} s");
    }
    for (name, places) in figures() {
        let back: Places = places.iter().rev().copied().collect();
        let (there, again) = (time(&places), time(&back));
        println!("{name}: {there} s and {again} s");
        assert!((there / again - 1.0).abs() <= 1e-3, "{name}: {there} s and {again} s");
    }
}

#[test]
fn no_path_is_slower_than_with_a_stop_at_every_corner() {
    for seed in 0..rounds(12) {
        let places = dense::harmonics([0.3, 1.0, 3.0][seed as usize % 3], 3, seed + 7);
        let eased = time_of(&planned(&places, 200.0, 0.005, fast()));
        let stops: Vec<MoveRequest> = places
            .windows(2)
            .map(|pair| cut(line(pair[0], pair[1]), 200.0, CornerMode::Stop))
            .collect();
        let stopped = time_of(&plan(&stops, fast(), PlannerLevel::Fast));
        assert!(eased <= stopped * (1.0 + 1e-9), "seed {seed}: {eased} s for {stopped} s");
    }
}

#[test]
fn every_move_has_its_time() {
    let places = dense::star(0.1);
    let moves = dense::moves(&places, FEED, 0.01);
    let trajectories = plan(&moves, fast(), PlannerLevel::Fast);
    let tags: Vec<u64> = trajectories
        .iter()
        .flat_map(|trajectory| trajectory.pieces.iter().map(|piece| piece.tag))
        .collect();
    assert!(tags.is_sorted());
    let mut tag_order = tags;
    tag_order.dedup();
    assert_eq!(tag_order, (0..moves.len() as u64).collect::<Vec<_>>());
    let length: f64 = trajectories.iter().map(PlannedTrajectory::length).sum();
    let whole: f64 = moves.iter().map(MoveRequest::length).sum();
    assert!((length - whole).abs() < 1e-9 * whole);
}
