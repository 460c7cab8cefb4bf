//! Against geometry that knows none of the formulas: the cutter touches what it should touch.

use std::f64::consts::{PI, TAU};

use chordal_calc::{
    AnswerUnit, ArcArc, ArcPoints, ChordCount, LineArc, TravelSide, TwoLines, arc_points,
    arc_with_arc, chord_count, corner_of_lines, line_with_arc,
};
use chordal_geometry::{
    Circle2, Frame, ParamCurve, Placement, Plane, TurnDirection, Vec2, Vec3, circle_circle,
};
use proptest::prelude::*;

fn distance_to_line(point: Vec2, angle: f64) -> f64 {
    Vec2::new(angle.cos(), angle.sin()).cross(point)
}

proptest! {
    /// At a corner of lines the centre is CR to the left of both.
    #[test]
    fn lines_are_touched(cr in 0.5f64..20.0, a in -3.0f64..3.0, bend in -2.9f64..2.9) {
        let ask = TwoLines { cutter_radius: cr, a, b: a + bend, side: TravelSide::Left };
        let worked = corner_of_lines(&ask, AnswerUnit::Millimetre).unwrap();
        let center = Vec2::new(-worked.value("ΔX").unwrap(), worked.value("ΔY").unwrap());
        prop_assert!((distance_to_line(center, a) - cr).abs() < 1e-9 * (1.0 + center.length()));
        prop_assert!((distance_to_line(center, a + bend) - cr).abs() < 1e-9 * (1.0 + center.length()));
    }

    /// At a corner with an arc it is CR off the line and off the circle, on the sides asked for.
    #[test]
    fn a_line_and_an_arc_are_touched(
        cr in 0.5f64..5.0,
        radius in 6.0f64..50.0,
        share in 0.0f64..0.95,
        inside: bool,
        toward: bool,
    ) {
        let height = share * radius;
        let ask = LineArc { cutter_radius: cr, radius, height, inside, toward, corner: None };
        if let Ok(worked) = line_with_arc(&ask, AnswerUnit::Millimetre) {
            let corner = (radius * radius - height * height).sqrt();
            let up = if toward { cr } else { -cr };
            let center = Vec2::new(corner - worked.value("ΔX").unwrap(), up - height);
            let expected = if inside { radius - cr } else { radius + cr };
            prop_assert!((center.length() - expected).abs() < 1e-8);
        }
    }

    /// At a corner of arcs it is CR off both circles.
    #[test]
    fn arcs_are_touched(
        cr in 0.5f64..4.0,
        r1 in 6.0f64..40.0,
        r2 in 6.0f64..40.0,
        share in 0.05f64..0.95,
        angle in -3.1f64..3.1,
        inside: [bool; 2],
        left: bool,
    ) {
        let low = (r1 - r2).abs();
        let far = low + share * (r1 + r2 - low);
        let second = Vec2::new(far * angle.cos(), far * angle.sin());
        let side = if left { TravelSide::Left } else { TravelSide::Right };
        let ask = ArcArc { cutter_radius: cr, radii: [r1, r2], inside, center_offset: [second.a, second.b], side };
        if let Ok(worked) = arc_with_arc(&ask, AnswerUnit::Millimetre) {
            let circle = |center, radius| Circle2 { center, radius };
            let meet: Vec<Vec2> =
                circle_circle(circle(Vec2::ZERO, r1), circle(second, r2), 0.0).points().collect();
            let corner = if left { meet[0] } else { *meet.last().unwrap() };
            let step = Vec2::new(worked.value("ΔX").unwrap(), worked.value("ΔY").unwrap());
            let center = corner + step;
            for (radius, inside, middle) in [(r1, inside[0], Vec2::ZERO), (r2, inside[1], second)] {
                let expected = if inside { radius - cr } else { radius + cr };
                prop_assert!((center.distance(middle) - expected).abs() < 1e-6);
            }
        }
    }

    /// The curve library needs as many chords.
    #[test]
    fn chords_are_those_of_the_curve(radius in 1.0f64..500.0, share in 1e-5f64..0.2, sweep in 0.1f64..TAU) {
        let tolerance = radius * share;
        let worked = chord_count(&ChordCount { radius, tolerance, sweep }, AnswerUnit::Millimetre).unwrap();
        let arc = chordal_geometry::Arc::new(Plane::Xy.frame(), radius, sweep, 0.0);
        let chords = arc.chords(tolerance, Placement::Inscribed).unwrap().chord_count();
        prop_assert_eq!(worked.value("N").unwrap() as u64, chords);
        prop_assert!(worked.value("f").unwrap() <= tolerance * (1.0 + 1e-6));
    }
}

#[test]
fn an_arc_ends_where_the_curve_does() {
    let start = Vec2::new(12.0, -3.0);
    let ask =
        ArcPoints { start, radius: 10.0, from: 0.0, to: 1.25 * PI, direction: TurnDirection::Cw };
    let worked = arc_points(&ask, AnswerUnit::Millimetre).unwrap();
    let frame = Frame { origin: Vec3::new(2.0, -3.0, 0.0), ..Plane::Xy.frame() };
    let curve = chordal_geometry::Arc::new(frame, 10.0, -0.75 * PI, 0.0);
    assert!((worked.value("XE").unwrap() - curve.end.x).abs() < 1e-9);
    assert!((worked.value("YE").unwrap() - curve.end.y).abs() < 1e-9);
    assert!((worked.value("I").unwrap() + 10.0).abs() < 1e-12);
    assert!(worked.value("J").unwrap().abs() < 1e-12);
    assert!((worked.value("l").unwrap() - curve.length()).abs() < 1e-9);
}
