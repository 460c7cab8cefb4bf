//! Volumes that are known, by columns.
//!
//! The floor is summed by the rule of the middle over squares; a square at a rim counts as a column or not
//! at all, so that a wall of height h and length l brings an error of about h·√(l·g³) (random signs).

use std::f64::consts::{FRAC_PI_2, TAU};

use chordal_geometry::{Arc, Curve, Frame, Line, Vec3};
use chordal_stock::floor::merge;
use chordal_stock::{CutterProfile, CutterSweep, RemovedSpan, Undercut};

/// Side of a column, mm.
const STEP: f64 = 0.05;
/// Where a wall is high and not long.
const FINE: f64 = 0.01;

/// What some moves remove below z = 0 from a box in plan.
fn volume(sweeps: &[CutterSweep], from: [f64; 2], to: [f64; 2]) -> f64 {
    by_columns(sweeps, from, to, STEP)
}

fn by_columns(sweeps: &[CutterSweep], from: [f64; 2], to: [f64; 2], step: f64) -> f64 {
    let count = [0, 1].map(|k| ((to[k] - from[k]) / step).round() as usize);
    let mut spans: Vec<RemovedSpan> = Vec::new();
    let mut sum = 0.0;
    for i in 0..count[0] {
        for j in 0..count[1] {
            let place = [(i as f64 + 0.5) * step + from[0], (j as f64 + 0.5) * step + from[1]];
            spans.clear();
            for sweep in sweeps {
                sweep.spans(place, &mut spans);
            }
            merge(&mut spans);
            sum += spans.iter().map(|span| (span.top.min(0.0) - span.floor).max(0.0)).sum::<f64>();
        }
    }
    sum * step * step
}

fn line(from: [f64; 3], to: [f64; 3]) -> Curve {
    Line::new(Vec3::from_array(from), Vec3::from_array(to)).into()
}

/// A groove of 60 mm by a cutter at a depth, with both its ends.
fn groove(cutter: &CutterProfile, depth: f64) -> f64 {
    let along = line([0.0, 0.0, -depth], [60.0, 0.0, -depth]);
    let reach = 6.0;
    volume(&[CutterSweep::new(cutter, &along, 1e-6)], [-reach, -reach], [60.0 + reach, reach])
}

fn near(found: f64, expected: f64, share: f64) {
    println!("{found:.3} for {expected:.3}: {:+.1e} of it", found / expected - 1.0);
    assert!((found / expected - 1.0).abs() <= share, "{found} {expected}");
}

/// Of the volume: what the columns at rims bring.
const WALLS: f64 = 3e-4;
/// Where the floor runs out without a wall.
const SMOOTH: f64 = 3e-5;

#[test]
fn slots_and_grooves() {
    let flat = CutterProfile::flat(10.0).unwrap();
    near(groove(&flat, 5.0), 3392.699, WALLS);
    let ball = CutterProfile::ball(10.0).unwrap();
    near(groove(&ball, 3.0), 1302.107, SMOOTH);
    near(groove(&ball, 7.0), 3975.074, WALLS);
    near(groove(&CutterProfile::bull(10.0, 2.0).unwrap(), 5.0), 3265.132, WALLS);
    let vee = CutterProfile::pointed(10.0, 0.0, FRAC_PI_2).unwrap();
    near(groove(&vee, 3.0), 568.274, SMOOTH);
}

#[test]
fn through_and_across() {
    let flat = CutterProfile::flat(10.0).unwrap();
    let one = line([-10.0, 30.0, -5.0], [110.0, 30.0, -5.0]);
    let two = line([50.0, -10.0, -5.0], [50.0, 70.0, -5.0]);
    let sweeps = [CutterSweep::new(&flat, &one, 1e-6), CutterSweep::new(&flat, &two, 1e-6)];
    near(volume(&sweeps[..1], [0.0, 0.0], [100.0, 60.0]), 5000.0, 1e-9);
    near(volume(&sweeps, [0.0, 0.0], [100.0, 60.0]), 7500.0, 1e-9);
}

#[test]
fn drills_and_ramps() {
    let drill = CutterProfile::pointed(10.0, 0.0, 118.0_f64.to_radians()).unwrap();
    let plunge = line([0.0, 0.0, 2.0], [0.0, 0.0, -20.0]);
    let hole =
        by_columns(&[CutterSweep::new(&drill, &plunge, 1e-6)], [-6.0, -6.0], [6.0, 6.0], FINE);
    near(hole, 1413.491, WALLS);
    let flat = CutterProfile::flat(10.0).unwrap();
    let ramp = line([0.0, 0.0, 0.0], [60.0, 0.0, -6.0]);
    near(
        volume(&[CutterSweep::new(&flat, &ramp, 1e-6)], [-6.0, -6.0], [66.0, 6.0]),
        2271.239,
        WALLS,
    );
}

#[test]
fn arcs_and_bores() {
    let quarter =
        Arc::new(Frame { origin: Vec3::Z * -4.0, ..Frame::IDENTITY }, 20.0, FRAC_PI_2, 0.0);
    let flat = CutterProfile::flat(6.0).unwrap();
    let slot =
        volume(&[CutterSweep::new(&flat, &quarter.into(), 1e-6)], [-4.0, -4.0], [24.0, 24.0]);
    near(slot, 867.080, WALLS);
    // Five turns of pitch 2, and one on the floor.
    let flat = CutterProfile::flat(10.0).unwrap();
    for (radius, with, without) in [(8.0, 5026.548, 4667.323), (4.0, 2544.690, 2415.713)] {
        let helix = Arc::new(Frame::IDENTITY, radius, 5.0 * TAU, -10.0);
        let floor =
            Arc::new(Frame { origin: Vec3::Z * -10.0, ..Frame::IDENTITY }, radius, TAU, 0.0);
        let sweeps = [
            CutterSweep::new(&flat, &helix.into(), 1e-6),
            CutterSweep::new(&flat, &floor.into(), 1e-6),
        ];
        near(volume(&sweeps, [-14.0, -14.0], [14.0, 14.0]), with, WALLS);
        near(volume(&sweeps[..1], [-14.0, -14.0], [14.0, 14.0]), without, WALLS);
    }
}

#[test]
fn undercuts() {
    let slot = CutterProfile::flat(10.0).unwrap();
    let under = Undercut::t_slot(20.0, 4.0, 9.0).unwrap();
    let along = line([-20.0, 0.0, -12.0], [120.0, 0.0, -12.0]);
    let sweeps =
        [CutterSweep::new(&slot, &along, 1e-6), CutterSweep::of_undercut(&under, &along, 1e-6)];
    let [from, to] = [[0.0, -12.0], [100.0, 12.0]];
    near(volume(&sweeps, from, to) - volume(&sweeps[..1], from, to), 4000.0, 1e-9);

    // A lollipop whose neck has a slot of its width above it: the area across, on a length of 10.
    let ball = Undercut::lollipop(6.0, 3.0).unwrap();
    let neck = CutterProfile::flat(3.0).unwrap();
    let at = |z: f64| line([-10.0, 0.0, z], [20.0, 0.0, z]);
    let sweeps = [
        CutterSweep::of_undercut(&ball, &at(-9.0), 1e-6),
        CutterSweep::new(&neck, &at(-6.0), 1e-6),
    ];
    near(volume(&sweeps, [0.0, -4.0], [10.0, 4.0]) / 10.0, 37.664_831, 3e-4);

    // A thread beyond the bore of R13, by turn: two whole turns less the two that are whole already.
    let disc = Undercut::thread_disc(20.0, 1.5, 0.0, 12.0).unwrap();
    let deep = Frame { origin: Vec3::Z * -60.0, ..Frame::IDENTITY };
    let turns = |count: f64| -> Curve { Arc::new(deep, 6.0, count * TAU, 3.0 * count).into() };
    let beyond = |curve: &Curve| {
        let sweep = CutterSweep::of_undercut(&disc, curve, 1e-6);
        let mut spans = Vec::new();
        let mut sum = 0.0;
        let count = (34.0 / STEP) as usize;
        for i in 0..count {
            for j in 0..count {
                let place = [i, j].map(|k| (k as f64 + 0.5) * STEP - 17.0);
                if place[0] * place[0] + place[1] * place[1] > 169.0 {
                    spans.clear();
                    sweep.spans(place, &mut spans);
                    merge(&mut spans);
                    sum += spans.iter().map(|span| span.top - span.floor).sum::<f64>();
                }
            }
        }
        sum * STEP * STEP
    };
    near(beyond(&turns(3.0)) - beyond(&turns(2.0)), 548.655, WALLS);
}

#[test]
fn scallops() {
    // R3 at a step of 0.5: the ridge, and the mean over the step.
    let ball = CutterProfile::ball(6.0).unwrap();
    let sweeps = [0.0, 0.5].map(|y| line([-10.0, y, 0.0], [10.0, y, 0.0]));
    let sweeps = sweeps.each_ref().map(|curve| CutterSweep::new(&ball, curve, 1e-6));
    let floor = |y: f64| sweeps.iter().filter_map(|s| s.floor([0.0, y])).fold(1.0, f64::min);
    assert!((floor(0.25) - 0.010_435).abs() < 5e-7);
    let count = 10_000;
    let mean = (0..count).map(|k| floor(0.5 * (k as f64 + 0.5) / count as f64)).sum::<f64>();
    assert!((mean / count as f64 - 0.003_476).abs() < 5e-7);
}
