//! Nothing panics, nothing hangs: zeros, extremes, and numbers that are none.

mod common;

use chordal_geometry::{
    Arc, Curve, Frame, HalfCircleTolerance, Line, ParamCurve, Placement, Plane, Spiral, Tracer,
    Transform, TurnDirection, Vec3, arc_from_center, center_from_radius, spiral_from_center,
};
use common::*;
use proptest::prelude::*;

/// Asks everything once.
fn exercise(c: &Curve) {
    let length = c.length();
    let mut tracer = Tracer::new(c);
    for s in [0.0, 0.3 * length, length, -1.0, 1e300, f64::NAN, f64::INFINITY] {
        let _ = tracer.motion_at(s, [1.0, -2.0, 3.0]);
        let _ = (c.point_at(s), c.tangent_at(s), c.curvature_at(s), c.curvature_derivative_at(s));
        let (a, b) = c.split_at(s);
        let _ = (a.length(), b.length(), c.subsegment(s, 0.5 * length).length());
    }
    for p in [Vec3::ZERO, Vec3::new(1.0, -2.0, 3.0), c.start(), Vec3::X * f64::NAN] {
        let _ = c.nearest(p);
    }
    let _ = (c.bounds(), c.max_curvature(), c.reversed().length());
    let _ = c.transformed(&Transform::mirror(Vec3::X, Vec3::Y)).bounds();
    for placement in [Placement::Inscribed, Placement::Balanced] {
        for e in [1e-3, 1.0, 1e9, 0.0, f64::NAN, f64::INFINITY, 1e-300] {
            if let Ok(chords) = c.chords(e, placement) {
                assert!(chords.take(1000).count() >= 2);
            }
        }
    }
}

#[test]
fn no_length_at_all() {
    let at = Vec3::new(1.0, 2.0, 3.0);
    let f = Frame { origin: at, ..Plane::Zx.frame() };
    let none: [Curve; 4] = [
        Line::new(at, at).into(),
        Arc::new(f, 0.0, 5.0, 0.0).into(),
        Arc::new(f, 0.0, 0.0, 0.0).into(),
        Spiral::new(f, (0.0, 0.0), 5.0, 0.0).into(),
    ];
    for c in none {
        assert_eq!(c.length(), 0.0);
        assert_eq!(c.point_at(0.0), at);
        assert_eq!(c.tangent_at(0.0), Vec3::ZERO);
        assert_eq!(c.curvature_at(0.0), Vec3::ZERO);
        assert_eq!(Tracer::new(&c).jet_at(0.0), [at, Vec3::ZERO, Vec3::ZERO, Vec3::ZERO]);
        assert_eq!(c.max_curvature(), 0.0);
        assert_eq!((c.bounds().min, c.bounds().max), (at, at));
        assert_eq!(c.nearest(at + Vec3::Z * 3.0).distance, 3.0);
        assert_eq!(c.chord_count(0.1, Placement::Balanced), Ok(1));
        exercise(&c);
    }
}

#[test]
fn no_radius_but_a_rise_is_a_line() {
    for c in [
        Curve::from(Arc::new(Plane::Xy.frame(), 0.0, 5.0, -4.0)),
        Spiral::new(Plane::Xy.frame(), (0.0, 0.0), 5.0, -4.0).into(),
    ] {
        assert_eq!(c.length(), 4.0);
        assert_eq!(c.tangent_at(1.0), -Vec3::Z);
        assert!(c.point_at(1.0).distance(-Vec3::Z) < 1e-15);
        assert_eq!(c.bounds().min, Vec3::Z * -4.0);
        let n = c.nearest(Vec3::new(3.0, 0.0, -1.0));
        assert!((n.s - 1.0).abs() < 1e-12 && (n.distance - 3.0).abs() < 1e-15);
        exercise(&c);
    }
}

#[test]
fn numbers_that_are_none() {
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let f = Plane::Xy.frame();
        let p = Vec3::X * bad;
        for c in [
            Curve::from(Line::new(Vec3::ZERO, p)),
            Arc::new(f, bad, 1.0, 0.0).into(),
            Arc::new(f, 1.0, bad, 2.0).into(),
            Arc::new(f, 1.0, 1.0, bad).into(),
            Arc::new(Frame { u: p, ..f }, 1.0, 1.0, 1.0).into(),
            Spiral::new(f, (bad, 1.0), 9.0, 0.0).into(),
            Spiral::new(f, (1.0, bad), 9.0, 0.0).into(),
            Spiral::new(f, (1.0, 2.0), bad, 0.0).into(),
            Spiral::new(f, (1.0, 2.0), 9.0, bad).into(),
            Spiral::new(Frame { origin: p, ..f }, (1.0, 2.0), 9.0, 1.0).into(),
        ] {
            exercise(&c);
            assert!(c.chords(0.1, Placement::Inscribed).is_err());
        }
        for (s, e, m) in [(p, Vec3::Y, 0.0), (Vec3::Y, p, 0.0), (Vec3::X, Vec3::Y, bad)] {
            exercise(&arc_from_center(Plane::Xy, s, e, (m, 0.0), TurnDirection::Cw, 0, 1e-9).curve);
            exercise(&spiral_from_center(Plane::Xy, s, e, (m, 0.0), 9.0, 1e-9).curve);
            exercise(&spiral_from_center(Plane::Xy, s, e, (0.0, 0.0), bad, 1e-9).curve);
        }
        assert!(
            center_from_radius(
                Plane::Xy,
                p,
                Vec3::Y,
                1.0,
                TurnDirection::Cw,
                HalfCircleTolerance::either(0.1)
            )
            .is_err()
        );
    }
}

#[test]
fn a_huge_radius_keeps_its_digits() {
    // 100 mm along a circle of a kilometre.
    let c = Curve::from(Arc::new(Plane::Xy.frame(), 1e6, 1e-4, 0.0));
    assert!((c.length() - 100.0).abs() < 1e-12);
    assert!(c.nearest(c.point_at(50.0)).distance < 1e-9);
    assert!((c.bounds().size().x - 0.005).abs() < 1e-9);
    assert_eq!(c.chord_count(0.01, Placement::Inscribed), Ok(1));
    assert_eq!(c.chord_count(0.001, Placement::Inscribed), Ok(2));
    exercise(&c);
}

#[test]
fn minute_curves() {
    let f = Plane::Xy.frame();
    let a = Arc::new(f, 1e-12, TAU, 0.0);
    assert!((a.length() - TAU * 1e-12).abs() < 1e-27);
    assert!((a.nearest(Vec3::Y).point - Vec3::Y * 1e-12).length() < 1e-27);
    let s = Spiral::new(f, (1e-12, 2e-12), TAU, 1e-12);
    let expected = length_by_polylines(&s.into(), 0.0, 1.0);
    assert!((s.length() - expected).abs() < 1e-12 * expected);
    let half = s.point_at(0.5 * s.length());
    assert!((s.nearest(half).s - 0.5 * s.length()).abs() < 1e-9 * s.length());
    for c in [Curve::from(a), s.into(), Line::new(Vec3::ZERO, Vec3::X * 1e-12).into()] {
        exercise(&c);
    }
}

fn wild() -> impl Strategy<Value = f64> {
    prop_oneof![
        Just(0.0),
        Just(-0.0),
        Just(1.0),
        Just(TAU),
        Just(1e6),
        Just(1e-12),
        Just(1e-160),
        Just(-1e160),
        Just(f64::MAX),
        Just(f64::MIN_POSITIVE),
        Just(5e-324),
        Just(f64::NAN),
        Just(f64::INFINITY),
        -10.0..10.0,
        -1e9..1e9,
    ]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(3000))]

    #[test]
    fn anything_goes(r0 in wild(), r1 in wild(), sweep in wild(), rise in wild(), f in frame()) {
        exercise(&Arc::new(f, r0, sweep, rise).into());
        exercise(&Spiral::new(f, (r0, r1), sweep, rise).into());
        exercise(&Spiral::new(f, (r0.abs(), r0.abs()), sweep, rise).into());
    }

    #[test]
    fn any_command_goes(x in wild(), y in wild(), z in wild(), a in wild(), b in wild(), tol in wild()) {
        let (s, e) = (Vec3::new(x, y, z), Vec3::new(y, z, x));
        exercise(&arc_from_center(Plane::Yz, s, e, (a, b), TurnDirection::Ccw, 3, tol).curve);
        exercise(&spiral_from_center(Plane::Yz, s, e, (a, b), x, tol).curve);
        let _ = center_from_radius(Plane::Yz, s, e, a, TurnDirection::Ccw, HalfCircleTolerance::either(tol));
    }
}
