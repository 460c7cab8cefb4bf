//! The compensated programs of the documents with real tools: the tool touches the part's
//! contour everywhere it can reach and crosses it nowhere. The part is written by hand.

#![allow(clippy::disallowed_methods, reason = "a test reads its programs")]

mod part;
mod tool;

use part::{Piece, circle, rounded_square, slot};
use tool::{Cut, Run};

/// What rounding to four decimals in the documents does to a distance, in.
const DOCUMENT_IN: f64 = 6e-5;

/// Centres are never nearer to the contour than the radius, and every place of the contour
/// is reached.
fn touches_and_never_crosses(contour: &[Piece], radius: f64, cuts: &[Cut], tolerance: f64) {
    assert!(!cuts.is_empty(), "nothing is cut with compensation");
    let mut nearest = f64::INFINITY;
    for cut in cuts {
        for step in 0..=200 {
            let point = cut.piece.at(f64::from(step) / 200.0);
            nearest = nearest.min(part::distance(contour, point));
        }
    }
    assert!(nearest >= radius - tolerance, "centre {nearest} from the contour, radius {radius}");
    let path: Vec<Piece> = cuts.iter().map(|cut| cut.piece).collect();
    for piece in contour {
        for step in 0..=200 {
            let point = piece.at(f64::from(step) / 200.0);
            let away = part::distance(&path, point);
            assert!(away <= radius + tolerance, "{point:?} stays {away} away, radius {radius}");
        }
    }
}

#[test]
fn fadal_boss() {
    let run = Run::new("fadal/boss.nc", &["tools.3.diameter=0.5 in"]);
    let boss = circle([-3.0, -2.0], 1.0);
    touches_and_never_crosses(&boss, 0.25, &run.cuts, DOCUMENT_IN);
    let turns: Vec<_> = run.cuts.iter().filter(|cut| cut.sweep_degrees().abs() == 360.0).collect();
    assert_eq!(turns.len(), 2, "absolute and incremental");
    turns.iter().for_each(|turn| assert!((turn.radius() - 1.25).abs() < 1e-9));
}

#[test]
fn fadal_slot() {
    let run = Run::new("fadal/slot.nc", &["tools.6.diameter=0.375 in"]);
    let walls = slot([1.0, -1.5], [2.0, -1.5], 0.19);
    touches_and_never_crosses(&walls, 0.1875, &run.cuts, DOCUMENT_IN);
}

#[test]
fn fadal_pocket_by_subroutines() {
    let run = Run::new("fadal/subroutines.nc", &["tools.1.diameter=0.5 in"]);
    touches_and_never_crosses(&rounded_square(1.5, 0.52), 0.25, &run.cuts, DOCUMENT_IN);
}

#[test]
fn fadal_pocket_by_subprograms() {
    let run = Run::new("fadal/subprograms.nc", &["tools.1.diameter=0.5 in"]);
    touches_and_never_crosses(&rounded_square(1.5, 0.52), 0.25, &run.cuts, DOCUMENT_IN);
}

#[test]
fn fadal_bore() {
    let run = Run::new("fadal/bore.nc", &["tools.1.diameter=0.75 in"]);
    touches_and_never_crosses(&circle([2.0, -2.0], 1.0), 0.375, &run.cuts, DOCUMENT_IN);
    let depths: Vec<f64> =
        run.cuts.iter().filter(|cut| cut.is_arc()).map(|cut| cut.depth).collect();
    for (depth, expected) in depths.iter().zip([-0.3, -0.6, -0.9, -1.03, -1.03, -1.03]) {
        assert!((depth - expected).abs() < 1e-9, "{depths:?}");
    }
    assert_eq!(depths.len(), 6);
}

#[test]
fn fadal_partial_helices() {
    let run = Run::new("fadal/partial-helices.nc", &["tools.1.diameter=0.375 in"]);
    let walls = slot([0.0, 0.0], [1.0, 0.0], 0.19);
    touches_and_never_crosses(&walls, 0.1875, &run.cuts, DOCUMENT_IN);
}

#[test]
fn fadal_outside_thread() {
    let run = Run::new("fadal/od-thread.nc", &["tools.5.diameter=0.5 in"]);
    touches_and_never_crosses(&circle([0.0, 0.0], 0.5094), 0.25, &run.cuts, DOCUMENT_IN);
    assert_eq!(run.cuts.iter().filter(|cut| cut.sweep_degrees() == -360.0).count(), 15);
}

#[test]
fn fadal_inside_thread() {
    let run = Run::new("fadal/id-thread.nc", &["tools.5.diameter=0.5 in"]);
    touches_and_never_crosses(&circle([0.0, 0.0], 0.5313), 0.25, &run.cuts, DOCUMENT_IN);
    assert_eq!(run.cuts.iter().filter(|cut| cut.sweep_degrees() == 360.0).count(), 15);
}

/// The profile of the G18 and G19 examples: along X or Y, and Z.
fn profile() -> Vec<Piece> {
    let sweep = |from: [f64; 2], to: [f64; 2], c: [f64; 2], sense: f64| {
        let angle = |p: [f64; 2]| (p[1] - c[1]).atan2(p[0] - c[0]).to_degrees();
        let radius = (from[0] - c[0]).hypot(from[1] - c[1]);
        let turned = (sense * (angle(to) - angle(from))).rem_euclid(360.0);
        Piece::Arc(c, radius, angle(from), sense * turned)
    };
    let corners = [[-5.09, -2.56], [-3.4585, -1.618], [-2.9928, -0.952], [-1.86, 0.0], [0.0, 0.0]];
    vec![
        Piece::Line(corners[0], corners[1]),
        sweep(corners[1], corners[2], [-3.9385, -0.7866], 1.0),
        sweep(corners[2], corners[3], [-1.86, -1.15], -1.0),
        Piece::Line(corners[3], corners[4]),
    ]
}

#[test]
fn fadal_profiles_in_g18_and_g19() {
    for (program, first) in
        [("fadal/g18-g90.nc", 0), ("fadal/g19-g90.nc", 1), ("fadal/g19-g91.nc", 1)]
    {
        let run = Run::seen_along(program, &["tools.1.diameter=0.375 in"], [first, 2]);
        touches_and_never_crosses(&profile(), 0.1875, &run.cuts, DOCUMENT_IN);
        let radii: Vec<f64> =
            run.cuts.iter().filter(|cut| cut.is_arc()).map(|cut| cut.radius()).collect();
        assert!((radii[0] - 0.7725).abs() < DOCUMENT_IN && (radii[1] - 1.3375).abs() < DOCUMENT_IN);
    }
}

#[test]
fn the_wrong_side_of_the_incremental_g18_example_is_found() {
    let run = Run::seen_along("fadal/g18-g91.nc", &["tools.1.diameter=0.375 in"], [0, 2]);
    let told = run.told("CH534");
    assert!(told.iter().any(|text| text.contains("G42")), "{told:?}");
}

#[test]
fn haas_inside_thread() {
    for radius in [0.0001, 0.175, 0.213, 0.245] {
        let set = format!("tools.1.diameter={} in", 2.0 * radius);
        let run = Run::new("haas/O60023.nc", &[&set]);
        touches_and_never_crosses(&circle([0.0, 0.0], 0.5), radius, &run.cuts, DOCUMENT_IN);
    }
}

#[test]
fn haas_outside_thread() {
    for radius in [0.25, 0.45] {
        let set = format!("tools.1.diameter={} in", 2.0 * radius);
        let run = Run::new("haas/O60024.nc", &[&set]);
        touches_and_never_crosses(&circle([0.0, 0.0], 0.962), radius, &run.cuts, DOCUMENT_IN);
    }
}

#[test]
fn haas_single_point_thread() {
    let run = Run::new("haas/O60025.nc", &["tools.1.diameter=0.4 in"]);
    touches_and_never_crosses(&circle([0.0, 0.0], 0.5), 0.2, &run.cuts, DOCUMENT_IN);
    assert_eq!(run.cuts.iter().filter(|cut| cut.sweep_degrees() == 360.0).count(), 5);
}
