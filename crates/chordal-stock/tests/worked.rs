//! Volumes that are known: the truth lies between the two, and finer columns bring them together.

mod support;

use std::f64::consts::PI;

use chordal_geometry::{Arc, Frame, Vec3};
use chordal_stock::{ColumnStock, CutterProfile, TipMove};
use support::{line, path, stock};

/// The volume removed at three resolutions, each half the last: always around the truth. The gap falls
/// as the resolution does. (A wall on an edge of cells is uncertain on both sides, one within a cell only there:
/// these resolutions have the walls of all cases on edges, or of round ones anywhere.)
fn encloses(
    truth: f64,
    make: impl Fn(f64) -> ColumnStock,
    moves: &[(CutterProfile, Vec<TipMove>)],
) -> f64 {
    const QUARTER: f64 = 0.28;
    let mut gaps = Vec::new();
    for resolution in [0.2, 0.1, 0.05] {
        let mut stock = make(resolution);
        for (cutter, moves) in moves {
            stock.cut(cutter, moves);
        }
        let removed = stock.removed();
        assert!(removed.least <= truth, "{removed:?} {truth} at {resolution}");
        assert!(removed.most >= truth, "{removed:?} {truth} at {resolution}");
        gaps.push(removed.most - removed.least);
    }
    assert!(gaps[2] < gaps[1] && gaps[1] < gaps[0] && gaps[2] <= QUARTER * gaps[0], "{gaps:?}");
    gaps[2] / truth
}

fn block(resolution: f64) -> ColumnStock {
    stock([-10.0, -10.0, -20.0], [70.0, 10.0, 0.0], resolution)
}

fn groove(cutter: CutterProfile, from: f64, to: f64) -> Vec<(CutterProfile, Vec<TipMove>)> {
    vec![(cutter, vec![line([0.0, 0.0, from], [60.0, 0.0, to])])]
}

#[test]
fn slots() {
    let flat = || CutterProfile::flat(10.0).unwrap();
    let truth = (600.0 + 25.0 * PI) * 5.0;
    assert!(encloses(truth, block, &groove(flat(), -5.0, -5.0)) < 0.03);
    let through = |resolution| stock([0.0, 0.0, -20.0], [100.0, 60.0, 0.0], resolution);
    let along = vec![line([-20.0, 30.0, -5.0], [120.0, 30.0, -5.0])];
    let across = vec![line([50.0, -20.0, -5.0], [50.0, 80.0, -5.0])];
    assert!(encloses(5000.0, through, &[(flat(), along.clone())]) < 0.06);
    encloses(7500.0, through, &[(flat(), along), (flat(), across)]);
}

#[test]
fn grooves_of_rounds_and_points() {
    let ball = || CutterProfile::ball(10.0).unwrap();
    encloses(1302.107, block, &groove(ball(), -3.0, -3.0));
    encloses(3975.074, block, &groove(ball(), -7.0, -7.0));
    encloses(3265.132, block, &groove(CutterProfile::bull(10.0, 2.0).unwrap(), -5.0, -5.0));
    let point = CutterProfile::pointed(10.0, 0.0, PI / 2.0).unwrap();
    encloses(540.0 + 9.0 * PI, block, &groove(point, -3.0, -3.0));
}

#[test]
fn a_drilled_hole() {
    let drill = CutterProfile::pointed(10.0, 0.0, 118_f64.to_radians()).unwrap();
    let deep = |resolution| stock([-7.0, -7.0, -25.0], [7.0, 7.0, 0.0], resolution);
    let hole = vec![line([0.0, 0.0, 3.0], [0.0, 0.0, -20.0])];
    encloses(1413.491, deep, &[(drill, hole)]);
}

#[test]
fn a_ramp() {
    let flat = CutterProfile::flat(10.0).unwrap();
    encloses(2271.239, block, &groove(flat, 0.0, -6.0));
}

#[test]
fn an_arc_slot_and_bores() {
    let flat = || CutterProfile::flat(6.0).unwrap();
    let plate = |resolution| stock([-25.0, -25.0, -11.0], [25.0, 25.0, 0.0], resolution);
    let frame =
        |z: f64| Frame { origin: Vec3::new(0.0, 0.0, z), ..chordal_geometry::Plane::Xy.frame() };
    let arc = Arc::new(frame(-4.0), 20.0, PI / 2.0, 0.0);
    encloses(
        4.0 * (60.0 * PI + 9.0 * PI),
        plate,
        &[(flat(), vec![TipMove { curve: arc.into(), tag: 0 }])],
    );
    // Down five turns of pitch 2, and one turn on the floor: a ring about a core of 3, and a full bore.
    for (radius, truth) in [(8.0, 1600.0 * PI), (4.0, 810.0 * PI)] {
        let down = Arc::new(frame(0.0), radius, -10.0 * PI, -10.0);
        let flat_turn = Arc::new(frame(-10.0), radius, -2.0 * PI, 0.0);
        let moves = [down, flat_turn].map(|arc| TipMove { curve: arc.into(), tag: 0 });
        encloses(truth, plate, &[(CutterProfile::flat(10.0).unwrap(), moves.to_vec())]);
        let without = if radius > 5.0 { 4667.323 } else { 2415.713 };
        encloses(without, plate, &[(CutterProfile::flat(10.0).unwrap(), moves[..1].to_vec())]);
    }
}

#[test]
fn a_plunge_removes_and_a_retract_does_not() {
    let flat = CutterProfile::flat(10.0).unwrap();
    let deep = |resolution| stock([-7.0, -7.0, -25.0], [7.0, 7.0, 0.0], resolution);
    let moves = path(&[[0.0, 0.0, 2.0], [0.0, 0.0, -8.0], [0.0, 0.0, 2.0]]);
    encloses(25.0 * PI * 8.0, deep, &[(flat.clone(), moves)]);
    let mut still = deep(0.1);
    still.cut(&flat, &path(&[[0.0, 0.0, 0.0], [0.0, 0.0, 5.0], [5.0, 0.0, 5.0]]));
    assert_eq!(still.removed().least, 0.0);
    // A tool that stands on the top may have touched what rounding leaves open.
    assert!(still.removed().most < 0.02);
}
