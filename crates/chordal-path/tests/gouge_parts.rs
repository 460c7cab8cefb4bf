//! The parts of the gouge check: distances of curves, and which blocks are the part.

mod support;

use chordal_geometry::Vec2;
use chordal_path::gouge::{
    CenterMove, Contour, ContourBlock, GougeCurve, GougeKind, GougeOptions, GougeRole, PartContour,
    ToolSide, check, nearest,
};
use support::{Dice, contour, point_distance};

fn v(a: f64, b: f64) -> Vec2 {
    Vec2::new(a, b)
}

fn line(a: f64, b: f64, c: f64, d: f64) -> GougeCurve {
    GougeCurve::line(v(a, b), v(c, d))
}

fn any_curve(dice: &mut Dice) -> GougeCurve {
    let from = v(dice.between(-10.0, 10.0), dice.between(-10.0, 10.0));
    if dice.unit() < 0.4 {
        return GougeCurve::line(from, v(dice.between(-10.0, 10.0), dice.between(-10.0, 10.0)));
    }
    GougeCurve::Arc {
        center: from,
        radius: dice.between(0.1, 8.0),
        start: dice.between(-7.0, 7.0),
        sweep: dice.between(-8.0, 8.0),
    }
}

#[test]
fn the_distance_of_two_curves_is_the_least_over_both() {
    const STEPS: usize = 400;
    for seed in 0..1500 {
        let mut dice = Dice::new(seed);
        let (first, second) = (any_curve(&mut dice), any_curve(&mut dice));
        let near = nearest(&first, &second);
        let distance = near.square.sqrt();
        assert!((near.first.distance(near.second) - distance).abs() < 1e-9, "seed {seed}");
        let on_both = point_distance(&first, near.first).max(point_distance(&second, near.second));
        assert!(on_both < 1e-9, "seed {seed}: {on_both}");
        let sampled = (0..=STEPS)
            .map(|k| point_distance(&second, first.at(k as f64 / STEPS as f64)))
            .fold(f64::INFINITY, f64::min);
        assert!(distance <= sampled + 1e-9, "seed {seed}: {distance} but {sampled}");
        let step = first.length() / STEPS as f64;
        assert!(sampled <= distance + step, "seed {seed}: {distance} but {sampled}");
        let back = nearest(&second, &first).square.sqrt();
        assert!((back - distance).abs() < 1e-9, "seed {seed}");
    }
}

#[test]
fn a_chain_that_comes_back_to_a_vertex_is_the_part_between_the_visits() {
    let circle = GougeCurve::arc(v(1.0, 0.0), v(0.0, 0.0), v(0.0, 0.0), false);
    let curves = [line(0.0, -3.0, 0.0, 0.0), circle, line(0.0, 0.0, 0.0, 3.0)];
    let material =
        PartContour::of(&contour(&curves, ToolSide::Left, 0.5), &GougeOptions::default());
    assert_eq!(material.tags, [1]);
    assert!(material.is_closed());
}

/// A contour that is run three microns past its start: the last block begins and ends at one place, and is
/// no wall that would take the place of the real one.
#[test]
fn a_block_as_short_as_the_grain_closes_nothing() {
    let curves = [
        line(0.0, 0.0, 10.0, 0.0),
        line(10.0, 0.0, 10.0, 10.0),
        line(10.0, 10.0, 0.0, 10.0),
        line(0.0, 10.0, 0.0, 0.0),
        line(0.0, 0.0, 0.003, 0.0),
    ];
    let material =
        PartContour::of(&contour(&curves, ToolSide::Left, 0.5), &GougeOptions::default());
    assert_eq!(material.tags, [0, 1, 2, 3]);
    assert!(material.is_closed());
}

/// A lead arc is never of the same circle as its neighbour: that is the wall, in two blocks.
#[test]
fn an_arc_that_goes_on_along_the_same_circle_is_no_lead() {
    let quarter = |from: Vec2, to: Vec2| GougeCurve::arc(v(0.0, 0.0), from, to, true);
    let curves = [
        quarter(v(6.0, 0.0), v(0.0, 6.0)),
        quarter(v(0.0, 6.0), v(-6.0, 0.0)),
        quarter(v(-6.0, 0.0), v(0.0, -6.0)),
    ];
    let material =
        PartContour::of(&contour(&curves, ToolSide::Left, 0.5), &GougeOptions::default());
    assert_eq!(material.tags, [0, 1, 2]);
}

#[test]
fn a_lead_arc_of_an_open_chain_is_not_the_part() {
    // A quarter turn of radius 4 onto the wall Y0 with the tool inside it, and off again.
    let curves = [
        GougeCurve::arc(v(0.0, 4.0), v(-4.0, 4.0), v(0.0, 0.0), true),
        line(0.0, 0.0, 30.0, 0.0),
        GougeCurve::arc(v(30.0, 4.0), v(30.0, 0.0), v(34.0, 4.0), true),
    ];
    let left = PartContour::of(&contour(&curves, ToolSide::Left, 3.0), &GougeOptions::default());
    assert_eq!(left.tags, [1]);
    assert_eq!(left.lead_arcs.len(), 2);
    // With the tool outside of it the arc is a wall.
    let right = PartContour::of(&contour(&curves, ToolSide::Right, 3.0), &GougeOptions::default());
    assert_eq!(right.tags, [0, 1, 2]);
}

#[test]
fn a_run_off_beyond_the_first_wall_is_not_the_part() {
    let curves = [
        line(0.0, 0.0, 0.0, 40.0),
        line(0.0, 40.0, 40.0, 40.0),
        line(40.0, 40.0, 40.0, -1.0),
        line(40.0, -1.0, -8.0, -1.0),
    ];
    let material =
        PartContour::of(&contour(&curves, ToolSide::Left, 2.0), &GougeOptions::default());
    assert_eq!(material.curves[3], line(40.0, -1.0, 0.0, -1.0));
}

#[test]
fn marked_blocks_and_no_others_are_the_part() {
    let mut contour =
        contour(&[line(0.0, 0.0, 9.0, 0.0), line(9.0, 0.0, 9.0, 9.0)], ToolSide::Left, 1.0);
    contour.blocks[1].role = GougeRole::Part;
    assert_eq!(PartContour::of(&contour, &GougeOptions::default()).tags, [1]);
}

#[test]
fn repeated_passes_are_entered_once_and_a_slit_is_told() {
    let square = [
        line(0.0, 0.0, 10.0, 0.0),
        line(10.0, 0.0, 10.0, 10.0),
        line(10.0, 10.0, 0.0, 10.0),
        line(0.0, 10.0, 0.0, 0.0),
    ];
    let twice: Vec<GougeCurve> = square.iter().chain(&square).copied().collect();
    let material = PartContour::of(&contour(&twice, ToolSide::Left, 1.0), &GougeOptions::default());
    assert_eq!(material.tags, [0, 1, 2, 3]);
    assert!(material.ambiguous.is_empty() && material.is_closed());

    let there_and_back = [line(0.0, 0.0, 50.0, 0.0), line(50.0, 0.0, 0.0, 0.0)];
    let slit = contour(&there_and_back, ToolSide::Left, 1.0);
    assert_eq!(PartContour::of(&slit, &GougeOptions::default()).ambiguous, [(0, 1)]);
    // The two arcs of one circle share ends and centre, and are not a slit.
    let halves = [
        GougeCurve::arc(v(0.0, 0.0), v(5.0, 0.0), v(-5.0, 0.0), true),
        GougeCurve::arc(v(0.0, 0.0), v(-5.0, 0.0), v(5.0, 0.0), true),
    ];
    let circle = PartContour::of(&contour(&halves, ToolSide::Left, 1.0), &GougeOptions::default());
    assert_eq!(circle.tags, [0, 1]);
    assert!(circle.ambiguous.is_empty());
}

#[test]
fn a_lead_through_a_wall_far_from_the_open_end_is_a_gouge_of_the_part() {
    let block = |curve, tag, role| ContourBlock { curve, tag, role };
    // The lead passes through the second wall on its way to the first.
    let contour = Contour {
        blocks: vec![
            block(line(60.0, 20.0, 0.0, 20.0), 0, GougeRole::LeadIn),
            block(line(0.0, 20.0, 0.0, -40.0), 1, GougeRole::Offset),
            block(line(0.0, -40.0, 40.0, -40.0), 2, GougeRole::Offset),
            block(line(40.0, -40.0, 40.0, 60.0), 3, GougeRole::Offset),
        ],
        side: ToolSide::Left,
        radius: 2.0,
    };
    let path = [line(60.0, 20.0, 2.0, 20.0), line(2.0, 20.0, 2.0, -38.0)]
        .into_iter()
        .zip(0..)
        .map(|(curve, tag)| CenterMove { curve, tag })
        .collect::<Vec<_>>();
    let report = check(&contour, &path, &GougeOptions::default());
    assert_eq!(report.gouges.len(), 1);
    let gouge = report.gouges[0];
    assert_eq!((gouge.depth, gouge.point), (2.0, v(40.0, 20.0)));
    assert_eq!((gouge.cutting, gouge.cut, gouge.kind), (0, 3, GougeKind::Contour));
}

#[test]
fn the_number_reported_is_bounded_and_says_so() {
    // Forty notches 4 wide, each too narrow for the tool in its own place.
    let mut points = vec![v(-50.0, 0.0)];
    for k in 0..40 {
        let a = 50.0 * f64::from(k);
        points.extend([v(a, 0.0), v(a, -30.0), v(a + 4.0, -30.0), v(a + 4.0, 0.0)]);
    }
    points.push(v(2050.0, 0.0));
    let curves: Vec<GougeCurve> = points.windows(2).map(|p| GougeCurve::line(p[0], p[1])).collect();
    let contour = contour(&curves, ToolSide::Left, 3.0);
    // The tool dives to the floor of every notch along its middle.
    let path: Vec<CenterMove> = curves
        .iter()
        .zip(0..)
        .map(|(c, tag)| {
            let middle = |p: Vec2| v(p.a + if p.b < -1.0 { 2.0 } else { 0.0 }, p.b + 3.0);
            CenterMove { curve: GougeCurve::line(middle(c.from()), middle(c.to())), tag }
        })
        .collect();
    let few = check(&contour, &path, &GougeOptions { most: 5, ..GougeOptions::default() });
    assert_eq!((few.gouges.len(), few.more, few.complete), (5, true, true));
    let starved = check(&contour, &path, &GougeOptions { budget: 3, ..GougeOptions::default() });
    assert!(!starved.complete);
}
