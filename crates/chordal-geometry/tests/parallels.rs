//! Intersections and offsets.

mod common;

use chordal_geometry::{
    Arc, Circle2, Line, Line2, Meeting, ParamCurve, Plane, Vec2, Vec3, circle_circle, line_circle,
    line_line,
};
use common::*;
use proptest::prelude::*;

fn line2(a: f64, b: f64, da: f64, db: f64) -> Line2 {
    Line2 { point: Vec2::new(a, b), direction: Vec2::new(da, db) }
}

fn circle2(a: f64, b: f64, radius: f64) -> Circle2 {
    Circle2 { center: Vec2::new(a, b), radius }
}

#[test]
fn lines_by_hand() {
    let x = line_line(line2(0.0, 0.0, 2.0, 0.0), line2(3.0, -1.0, 0.0, 4.0), 0.0).unwrap();
    assert_eq!(x.point, Vec2::new(3.0, 0.0));
    assert_eq!((x.along_first, x.along_second), (1.5, 0.25));
    assert!(line_line(line2(0.0, 0.0, 1.0, 1.0), line2(5.0, 0.0, -2.0, -2.0), 0.0).is_none());
    assert!(line_line(line2(0.0, 0.0, 1.0, 0.0), line2(0.0, 1.0, 1.0, 1e-7), 1e-6).is_none());
    assert!(line_line(line2(0.0, 0.0, 0.0, 0.0), line2(0.0, 1.0, 1.0, 0.0), 0.0).is_none());
}

#[test]
fn line_and_circle_by_hand() {
    let c = circle2(1.0, 1.0, 5.0);
    let m = line_circle(line2(-100.0, 4.0, 3.0, 0.0), c, 0.0);
    assert_eq!(m, Meeting::Cross(Vec2::new(-3.0, 4.0), Vec2::new(5.0, 4.0)));
    let m = line_circle(line2(0.0, 6.0, 1.0, 0.0), c, 0.0);
    assert_eq!(m, Meeting::Touch(Vec2::new(1.0, 6.0)));
    assert_eq!(line_circle(line2(0.0, 6.001, 1.0, 0.0), c, 1e-6), Meeting::None);
    let m = line_circle(line2(0.0, 6.001, 1.0, 0.0), c, 0.01);
    assert_eq!(m.nearest_to(Vec2::ZERO), Some(Vec2::new(1.0, 6.001)));
    assert_eq!(line_circle(line2(0.0, 0.0, 0.0, 0.0), c, 1.0), Meeting::None);
}

#[test]
fn circles_by_hand() {
    let m = circle_circle(circle2(0.0, 0.0, 5.0), circle2(6.0, 0.0, 5.0), 0.0);
    assert_eq!(m, Meeting::Cross(Vec2::new(3.0, 4.0), Vec2::new(3.0, -4.0)));
    let touch = |a: Circle2, b: Circle2, p: Vec2| match circle_circle(a, b, 1e-9) {
        Meeting::Touch(q) => assert!(p.distance(q) < 1e-9, "{q:?}"),
        other => panic!("{other:?}"),
    };
    touch(circle2(0.0, 0.0, 2.0), circle2(5.0, 0.0, 3.0), Vec2::new(2.0, 0.0));
    touch(circle2(0.0, 0.0, 5.0), circle2(3.0, 0.0, 2.0), Vec2::new(5.0, 0.0));
    touch(circle2(3.0, 0.0, 2.0), circle2(0.0, 0.0, 5.0), Vec2::new(5.0, 0.0));
    touch(circle2(0.0, 0.0, 2.0), circle2(5.0 + 1e-10, 0.0, 3.0), Vec2::new(2.0, 0.0));
    let c = circle2(1.0, 2.0, 3.0);
    assert_eq!(circle_circle(c, circle2(1.0, 2.0, 2.0), 1e-9), Meeting::None);
    assert_eq!(circle_circle(c, circle2(1.0, 9.0, 2.0), 1e-9), Meeting::None);
    assert_eq!(circle_circle(c, c, 0.0), Meeting::Same);
    assert_eq!(circle_circle(c, c, 0.0).points().count(), 0);
}

#[test]
fn nan_meets_nothing() {
    let n = f64::NAN;
    assert!(line_line(line2(n, 0.0, 1.0, 0.0), line2(0.0, 0.0, n, 1.0), 0.0).is_none());
    assert_eq!(line_circle(line2(0.0, 0.0, 1.0, 0.0), circle2(0.0, n, 1.0), 1.0), Meeting::None);
    assert_eq!(circle_circle(circle2(0.0, 0.0, n), circle2(1.0, 0.0, 1.0), 1.0), Meeting::None);
    assert_eq!(circle_circle(circle2(0.0, n, 1.0), circle2(1.0, 0.0, 1.0), 1.0), Meeting::None);
}

#[test]
fn near_tangency_keeps_its_digits() {
    // Two circles of radius 1000 that overlap by 1e-9: half the common chord is √(r·overlap).
    let m = circle_circle(circle2(0.0, 0.0, 1000.0), circle2(2000.0 - 1e-9, 0.0, 1000.0), 0.0);
    let Meeting::Cross(p, q) = m else { panic!("{m:?}") };
    // The overlap as doubles have it.
    let overlap: f64 = 2000.0 - (2000.0 - 1e-9);
    assert!((p.distance(q) - 2.0 * (1000.0 * overlap).sqrt()).abs() < 1e-12);
}

#[test]
fn offsets_by_hand() {
    let l = Line::new(Vec3::ZERO, Vec3::new(10.0, 0.0, 3.0));
    let left = l.offset(Vec3::Z, 2.0).unwrap();
    assert_eq!(left, Line::new(Vec3::new(0.0, 2.0, 0.0), Vec3::new(10.0, 2.0, 3.0)));
    assert!(Line::new(Vec3::ZERO, Vec3::Z).offset(Vec3::Z, 1.0).is_none());
    assert!(Line::new(Vec3::X, Vec3::X).offset(Vec3::Z, 1.0).is_none());
    let ccw = Arc::new(Plane::Xy.frame(), 5.0, 0.25 * TAU, 0.0);
    let inner = ccw.offset(2.0).unwrap();
    assert_eq!((inner.radius, inner.start), (3.0, Vec3::new(3.0, 0.0, 0.0)));
    assert!(inner.end.distance(Vec3::new(0.0, 3.0, 0.0)) < 1e-15);
    assert_eq!(ccw.reversed().offset(2.0).unwrap().radius, 7.0);
    assert!(
        ccw.offset(5.0).is_none() && ccw.offset(6.0).is_none() && ccw.offset(f64::NAN).is_none()
    );
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn meeting_points_lie_on_both(
        p in point(), q in point(), r0 in 0.1..200.0, r1 in 0.1..200.0, turn in 0.0..TAU,
    ) {
        let (a, b) = (Vec2::new(p.x, p.y), Vec2::new(q.x, q.y));
        let line = Line2 { point: a, direction: Vec2::new(libm::cos(turn), libm::sin(turn)) };
        let circle = Circle2 { center: b, radius: r1 };
        for m in line_circle(line, circle, 0.0).points() {
            prop_assert!((m.distance(b) - r1).abs() < 1e-12);
            prop_assert!(line.direction.cross(m - a).abs() < 1e-12);
        }
        let other = Circle2 { center: a, radius: r0 };
        let there: Vec<Vec2> = circle_circle(circle, other, 0.0).points().collect();
        let back: Vec<Vec2> = circle_circle(other, circle, 0.0).points().collect();
        prop_assert_eq!(there.len(), back.len());
        let gap = b.distance(a);
        prop_assert_eq!(there.len() == 2, gap < r0 + r1 && gap > (r0 - r1).abs());
        for m in &there {
            // Where the circles are nearly concentric their crossing is badly conditioned.
            let unit = 1e-12 * (1.0 + 400.0 / gap);
            prop_assert!((m.distance(b) - r1).abs() < unit && (m.distance(a) - r0).abs() < unit);
        }
        if let [l, r] = there[..] {
            prop_assert!((a - b).cross(l - b) >= 0.0 && (a - b).cross(r - b) <= 0.0);
        }
    }

    #[test]
    fn crossing_lines_agree_with_their_parameters(p in point(), q in point(), t in 0.0..TAU, u in 0.0..TAU) {
        let first = Line2 { point: Vec2::new(p.x, p.y), direction: Vec2::new(libm::cos(t), libm::sin(t)) };
        let second = Line2 { point: Vec2::new(q.x, q.y), direction: Vec2::new(libm::cos(u), libm::sin(u)) };
        let Some(x) = line_line(first, second, 1e-3) else { return Ok(()) };
        let on_first = first.point + first.direction * x.along_first;
        let on_second = second.point + second.direction * x.along_second;
        prop_assert!(x.point.distance(on_first) < 1e-9 && x.point.distance(on_second) < 1e-9);
    }

    #[test]
    fn an_offset_is_everywhere_that_far_to_the_left(a in arc(), share in 0.0..1.0, by in -80.0..80.0) {
        let Some(o) = a.offset(by) else { return Ok(()) };
        let (s, so) = (a.length() * share, o.length() * share);
        let t = a.tangent_at(s);
        let left = a.w.cross(t).normalized().unwrap();
        let unit = scale_of(&a.into()) + scale_of(&o.into());
        prop_assert!(o.point_at(so).distance(a.point_at(s) + left * by) < 1e-11 * unit);
        let back = o.offset(-by).unwrap();
        prop_assert!((back.radius - a.radius).abs() < 1e-12 * unit);
        prop_assert!(back.end.distance(a.end) < 1e-12 * unit);
    }
}
