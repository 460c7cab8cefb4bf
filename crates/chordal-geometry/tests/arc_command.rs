//! From the words of an arc command to the curve.

mod common;

use chordal_geometry::{
    ArcFit, Curve, HalfCircleTolerance, ParamCurve, Plane, RadiusError, TurnDirection, Vec2, Vec3,
    arc_from_center, center_from_radius, spiral_from_center,
};
use common::*;
use proptest::prelude::*;

const NEAR: f64 = 1e-9;

fn xy(start: (f64, f64), end: (f64, f64), center: (f64, f64), d: TurnDirection) -> ArcFit {
    let (s, e) = (Vec3::new(start.0, start.1, 0.0), Vec3::new(end.0, end.1, 0.0));
    arc_from_center(Plane::Xy, s, e, center, d, 0, NEAR)
}

#[test]
fn quarter_turns_both_ways_in_every_plane() {
    for plane in [Plane::Xy, Plane::Zx, Plane::Yz] {
        let at = |a: f64, b: f64| plane.point(Vec2::new(a, b), 7.0);
        for (direction, sweep, middle) in [
            (TurnDirection::Ccw, 0.25 * TAU, (1.0, 1.0)),
            (TurnDirection::Cw, -0.75 * TAU, (-1.0, -1.0)),
        ] {
            let (s, e) = (at(2.0, 0.0), at(0.0, 2.0));
            let fit = arc_from_center(plane, s, e, (0.0, 0.0), direction, 0, NEAR);
            assert!((fit.sweep - sweep).abs() < 1e-15);
            let Curve::Arc(arc) = fit.curve else { panic!("radii agree") };
            assert_eq!((arc.w, arc.center), (plane.normal(), at(0.0, 0.0)));
            let k = 2.0_f64.sqrt();
            let half = arc.point_at(0.5 * arc.length());
            assert!(half.distance(at(middle.0 * k, middle.1 * k)) < 1e-14);
        }
    }
}

#[test]
fn coinciding_ends_are_a_full_turn() {
    for direction in [TurnDirection::Cw, TurnDirection::Ccw] {
        // A centre that no double meets exactly.
        let fit = xy((0.1, 0.7), (0.1, 0.7), (1.0 / 3.0, -2.2), direction);
        assert_eq!(fit.sweep, direction.sign() * TAU);
        assert!((fit.curve.length() - TAU * fit.radius_start).abs() < 1e-14);
    }
}

#[test]
fn extra_turns_and_rise() {
    let start = Vec3::new(1.0, 0.0, 5.0);
    let end = Vec3::new(-1.0, 0.0, 2.0);
    let fit = arc_from_center(Plane::Xy, start, end, (0.0, 0.0), TurnDirection::Cw, 2, NEAR);
    assert_eq!(fit.sweep, -2.5 * TAU);
    let length = ((2.5 * TAU) * (2.5 * TAU) + 9.0_f64).sqrt();
    assert!((fit.curve.length() - length).abs() < 1e-14);
    // A fifth of the way along is half a turn on, and a fifth of the way down.
    let p = fit.curve.point_at(0.2 * length);
    assert!(p.distance(Vec3::new(-1.0, 0.0, 4.4)) < 1e-14);
}

#[test]
fn half_turns_are_exact() {
    assert_eq!(xy((1.0, 0.0), (-1.0, 0.0), (0.0, 0.0), TurnDirection::Ccw).sweep, 0.5 * TAU);
    assert_eq!(xy((1.0, 0.0), (-1.0, 0.0), (0.0, 0.0), TurnDirection::Cw).sweep, -0.5 * TAU);
    assert_eq!(xy((-1.0, 0.0), (1.0, 0.0), (0.0, 0.0), TurnDirection::Ccw).sweep, 0.5 * TAU);
    assert_eq!(xy((-1.0, -0.0), (1.0, 0.0), (0.0, 0.0), TurnDirection::Cw).sweep, -0.5 * TAU);
}

#[test]
fn unequal_radii_make_a_spiral_that_meets_both_ends() {
    let fit = xy((10.0, 0.0), (0.0, 10.004), (0.0, 0.0), TurnDirection::Ccw);
    assert!((fit.radius_error() - 0.004).abs() < 1e-14);
    let Curve::Spiral(s) = fit.curve else { panic!("radii differ") };
    assert!((s.radius_at(0.5 * s.length()) - 10.002).abs() < 1e-6);
    let before = s.point_at(s.length() * (1.0 - 1e-12));
    assert!(before.distance(s.end) < 1e-10);
    // The tolerance decides.
    let (a, b) = (Vec3::new(10.0, 0.0, 0.0), Vec3::new(0.0, 10.004, 0.0));
    let fit = arc_from_center(Plane::Xy, a, b, (0.0, 0.0), TurnDirection::Ccw, 0, 0.005);
    assert!(matches!(fit.curve, Curve::Arc(_)));
    assert_eq!(fit.curve.end(), b);
}

#[test]
fn a_start_in_the_centre_spirals_out() {
    let fit = xy((0.0, 0.0), (3.0, 4.0), (0.0, 0.0), TurnDirection::Cw);
    assert_eq!((fit.radius_start, fit.radius_end, fit.sweep), (0.0, 5.0, -TAU));
    let end = at_fraction(&fit.curve, 1.0);
    assert!(end.distance(fit.curve.end()) < 1e-14);
}

#[test]
fn a_given_sweep_counts_turns() {
    let (s, e) = (Vec3::new(1.0, 0.0, 0.0), Vec3::new(0.0, 3.0, 0.0));
    // Three and a quarter turns, rounded to whole degrees by the program and a bit more.
    let fit = spiral_from_center(Plane::Xy, s, e, (0.0, 0.0), 3.25 * TAU + 0.01, NEAR);
    assert!((fit.sweep - 3.25 * TAU).abs() < 1e-14);
    assert!(at_fraction(&fit.curve, 1.0).distance(e) < 1e-13);
    let fit = spiral_from_center(Plane::Xy, s, e, (0.0, 0.0), -2.75 * TAU, NEAR);
    assert!((fit.sweep + 2.75 * TAU).abs() < 1e-14);
    // From the centre outward the sweep is taken as it is.
    let fit = spiral_from_center(Plane::Xy, Vec3::ZERO, e, (0.0, 0.0), 5.0, NEAR);
    assert_eq!(fit.sweep, 5.0);
    assert!(at_fraction(&fit.curve, 1.0).distance(e) < 1e-14);
}

#[test]
fn centres_from_radii_by_hand() {
    let (s, e) = (Vec3::ZERO, Vec3::new(6.0, 0.0, 1.0));
    let c =
        |r, d| center_from_radius(Plane::Xy, s, e, r, d, HalfCircleTolerance::either(0.0)).unwrap();
    assert_eq!(c(5.0, TurnDirection::Ccw), (3.0, 4.0));
    assert_eq!(c(5.0, TurnDirection::Cw), (3.0, -4.0));
    assert_eq!(c(-5.0, TurnDirection::Ccw), (3.0, -4.0));
    assert_eq!(c(-5.0, TurnDirection::Cw), (3.0, 4.0));
    assert_eq!(c(3.0, TurnDirection::Cw), (3.0, 0.0));
}

#[test]
fn radii_that_do_not_reach() {
    let (s, e) = (Vec3::ZERO, Vec3::new(6.0, 0.0, 0.0));
    let with = |r, tolerance| {
        center_from_radius(
            Plane::Xy,
            s,
            e,
            r,
            TurnDirection::Cw,
            HalfCircleTolerance::either(tolerance),
        )
    };
    assert_eq!(
        with(2.0, 0.001),
        Err(RadiusError::TooShort { chord: 6.0, radius: 2.0, short_by: 1.0 })
    );
    assert_eq!(with(2.9996, 0.001), Ok((3.0, 0.0)));
    assert_eq!(with(3.0004, 0.001), Ok((3.0, 0.0)));
    assert!(matches!(with(0.0, 0.001), Err(RadiusError::TooShort { .. })));
    assert_eq!(with(f64::NAN, 0.001), Err(RadiusError::NotFinite));
    let full = center_from_radius(
        Plane::Xy,
        s,
        Vec3::Z,
        4.0,
        TurnDirection::Cw,
        HalfCircleTolerance::either(0.001),
    );
    assert_eq!(full, Err(RadiusError::FullCircle));
    // Where the centre is computed, by Pythagoras: 3.0004² - 3² = 0.04899².
    let computed = HalfCircleTolerance { too_short_mm: 0.001, too_long_mm: 0.0 };
    let (x, y) = center_from_radius(Plane::Xy, s, e, 3.0004, TurnDirection::Cw, computed).unwrap();
    assert!((x - 3.0).abs() < 1e-12 && (y + 0.048_991_4).abs() < 1e-6, "{x} {y}");
    let short = center_from_radius(Plane::Xy, s, e, 2.9996, TurnDirection::Cw, computed);
    assert_eq!(short, Ok((3.0, 0.0)));
    assert!(RadiusError::FullCircle.to_string().contains("coincide"));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn the_curve_meets_both_ends_in_the_given_sense(
        start in point(), end in point(), a in coordinate(), b in coordinate(),
        cw in any::<bool>(), turns in 0..4u32,
    ) {
        let direction = if cw { TurnDirection::Cw } else { TurnDirection::Ccw };
        for plane in [Plane::Xy, Plane::Zx, Plane::Yz] {
            let fit = arc_from_center(plane, start, end, (a, b), direction, turns, NEAR);
            prop_assert!(fit.sweep * direction.sign() > 0.0);
            let least = f64::from(turns) * TAU;
            prop_assert!(fit.sweep.abs() >= least && fit.sweep.abs() <= least + TAU);
            prop_assert_eq!((fit.curve.start(), fit.curve.end()), (start, end));
            prop_assert!(at_fraction(&fit.curve, 0.0).distance(start) < 1e-12);
            prop_assert!(at_fraction(&fit.curve, 1.0).distance(end) < 1e-11);
        }
    }

    #[test]
    fn a_radius_gives_equal_distances_and_the_right_sweep(
        start in point(), end in point(), more in 1.0001..50.0_f64, cw in any::<bool>(), long in any::<bool>(),
    ) {
        let direction = if cw { TurnDirection::Cw } else { TurnDirection::Ccw };
        let chord = Plane::Xy.project(start).distance(Plane::Xy.project(end));
        prop_assume!(chord > 1e-3);
        let radius = 0.5 * chord * more * if long { -1.0 } else { 1.0 };
        let c = center_from_radius(Plane::Xy, start, end, radius, direction, HalfCircleTolerance::either(0.0)).unwrap();
        let fit = arc_from_center(Plane::Xy, start, end, c, direction, 0, 1e-9);
        prop_assert!((fit.radius_start - radius.abs()).abs() < 1e-12 * (radius.abs() + 300.0));
        prop_assert!(fit.radius_error().abs() < 1e-12 * (radius.abs() + 300.0));
        prop_assert_eq!(fit.sweep.abs() > 0.5 * TAU, long);
        let by_chord = 2.0 * libm::asin((chord / (2.0 * radius.abs())).min(1.0));
        let expected = if long { TAU - by_chord } else { by_chord };
        prop_assert!((fit.sweep.abs() - expected).abs() < 1e-9);
    }
}
