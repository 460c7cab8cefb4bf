//! Boxes and nearest points against dense samples.

mod common;

use chordal_geometry::{Arc, Curve, Frame, ParamCurve, Plane, Spiral, Vec3};
use common::*;
use proptest::prelude::*;

fn samples(c: &Curve) -> u32 {
    match c {
        Curve::Line(_) | Curve::Spline(_) => 10,
        Curve::Arc(a) => 400 + (a.sweep.abs() * 60.0) as u32,
        Curve::Spiral(s) => 400 + (s.sweep.abs() * 60.0) as u32,
    }
}

#[test]
fn the_box_of_a_plane_arc_is_exact() {
    let a =
        Arc::new(Frame { origin: Vec3::new(1.0, 2.0, 3.0), ..Plane::Xy.frame() }, 5.0, TAU, 0.0);
    assert_eq!(a.bounds().min, Vec3::new(-4.0, -3.0, 3.0));
    assert_eq!(a.bounds().max, Vec3::new(6.0, 7.0, 3.0));
    // From 45° to 135°: only the top is an extreme.
    let d = 0.5_f64.sqrt();
    let f = Frame::from_normal(Vec3::ZERO, Vec3::Z, Vec3::new(1.0, 1.0, 0.0)).unwrap();
    let b = Arc::new(f, 2.0, TAU / 4.0, 0.0).bounds();
    assert_eq!(b.max.y, 2.0);
    assert!((b.min.y - 2.0 * d).abs() < 1e-15);
    assert!((b.max.x - 2.0 * d).abs() < 1e-15 && (b.min.x + 2.0 * d).abs() < 1e-15);
}

#[test]
fn the_box_of_a_tilted_circle() {
    // A circle with axis (1,1,1)/√3 reaches r·√(2/3) along every axis.
    let f = Frame::from_normal(Vec3::ZERO, Vec3::new(1.0, 1.0, 1.0), Vec3::X).unwrap();
    let b = Arc::new(f, 3.0, TAU, 0.0).bounds();
    let reach = 3.0 * (2.0_f64 / 3.0).sqrt();
    for k in 0..3 {
        assert!((b.max.component(k) - reach).abs() < 1e-15);
        assert!((b.min.component(k) + reach).abs() < 1e-15);
    }
}

#[test]
fn nearest_on_a_long_helix_finds_the_turn() {
    // 100 turns of pitch 1; the point beside turn 40.
    let a = Arc::new(Plane::Xy.frame(), 10.0, 100.0 * TAU, 100.0);
    let n = a.nearest(Vec3::new(12.0, 0.0, 40.0));
    assert!((n.s / a.length() - 0.4).abs() < 1e-4);
    assert!(n.distance < 2.0 + 1e-9);
    // On the axis the distance is the radius, at the height of the point.
    let n = a.nearest(Vec3::new(0.0, 0.0, 62.5));
    assert!((n.distance - 10.0).abs() < 1e-12 && (n.point.z - 62.5).abs() < 1e-9);
}

#[test]
fn nearest_on_a_circle_from_its_centre_is_the_first_point() {
    let a = Arc::new(Plane::Zx.frame(), 4.0, 2.0, 0.0);
    let n = a.nearest(Vec3::ZERO);
    assert_eq!((n.s, n.distance), (0.0, 4.0));
}

#[test]
fn nearest_between_the_arms_of_a_spiral() {
    // r = φ/2π: arms one apart. From (5.4, 0) the arm at r = 5 (a whole turn) is nearer than r = 6.
    let s = Spiral::new(Plane::Xy.frame(), (0.0, 20.0), 20.0 * TAU, 0.0);
    let n = s.nearest(Vec3::new(5.4, 0.0, 0.0));
    assert!((s.radius_at(n.s) - 5.0).abs() < 0.01);
    let n = s.nearest(Vec3::new(5.6, 0.0, 0.0));
    assert!((s.radius_at(n.s) - 6.0).abs() < 0.01);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    #[test]
    fn boxes_hold_the_curve_and_no_more(c in curve()) {
        let b = c.bounds();
        let unit = scale_of(&c);
        let slack = b.expand(1e-14 * unit);
        let n = samples(&c);
        let mut seen = chordal_geometry::Aabb::of_points(c.start(), c.end());
        for i in 0..=n {
            let p = at_fraction(&c, f64::from(i) / f64::from(n));
            prop_assert!(slack.contains(p), "{p:?} outside {b:?}");
            seen = seen.include(p);
        }
        // Samples miss an extreme by at most h²/8 of the second derivative; generously.
        let step = match &c {
            Curve::Line(_) | Curve::Spline(_) => 0.0,
            Curve::Arc(a) => a.sweep.abs() / f64::from(n),
            Curve::Spiral(s) => s.sweep.abs() / f64::from(n),
        };
        let second = match &c {
            Curve::Line(_) | Curve::Spline(_) => 0.0,
            Curve::Arc(a) => a.radius,
            Curve::Spiral(s) => {
                let b = (s.radius_end - s.radius_start).abs() / s.sweep.abs();
                s.radius_start.max(s.radius_end) + 2.0 * b
            }
        };
        let miss = step * step / 8.0 * second * 1.01 + 1e-13 * unit;
        let apart = (b.max - seen.max).to_array().into_iter().chain((seen.min - b.min).to_array());
        for gap in apart {
            prop_assert!(gap <= miss, "the box is {gap:e} wider than the samples ({miss:e})");
        }
    }

    #[test]
    fn nothing_is_nearer_than_the_nearest(c in curve(), p in point(), near in any::<bool>(), share in 0.0..1.0) {
        // Half the points close to the curve, where the choice between turns is delicate.
        let p = if near { c.point_at(c.length() * share) + p * 0.02 } else { p };
        let n = c.nearest(p);
        let unit = scale_of(&c) + p.length();
        prop_assert!((n.distance - n.point.distance(p)).abs() <= 1e-15 * unit);
        prop_assert!(n.point.distance(c.point_at(n.s)) <= 1e-11 * unit);
        let count = samples(&c);
        for i in 0..=count {
            let d = at_fraction(&c, f64::from(i) / f64::from(count)).distance(p);
            prop_assert!(n.distance <= d + 1e-13 * unit, "{} but a sample at {}", n.distance, d);
        }
    }

    #[test]
    fn points_of_the_curve_are_their_own_nearest(c in curve(), share in 0.0..1.0) {
        let p = c.point_at(c.length() * share);
        prop_assert!(c.nearest(p).distance <= 1e-12 * scale_of(&c));
    }
}
