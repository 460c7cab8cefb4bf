//! What must hold for every curve: length, points, derivatives, parts, transforms.

mod common;

use chordal_geometry::{Arc, Curve, Line, ParamCurve, Plane, Spiral, Tracer, Transform, Vec3};
use common::*;
use proptest::prelude::*;

fn close(a: Vec3, b: Vec3, tolerance: f64) -> Result<(), TestCaseError> {
    prop_assert!(a.distance(b) <= tolerance, "{a:?} and {b:?} are {:e} apart", a.distance(b));
    Ok(())
}

#[test]
fn a_quarter_circle_by_hand() {
    let a = Arc::new(Plane::Xy.frame(), 2.0, TAU / 4.0, 0.0);
    assert!((a.length() - 0.5 * TAU).abs() < 1e-15);
    let s = a.length() / 3.0;
    assert!(a.point_at(s).distance(Vec3::new(3.0_f64.sqrt(), 1.0, 0.0)) < 1e-15);
    assert!(a.tangent_at(0.0).distance(Vec3::Y) < 1e-15);
    assert!(a.curvature_at(0.0).distance(Vec3::X * -0.5) < 1e-15);
    assert!(a.curvature_derivative_at(0.0).distance(Vec3::Y * -0.25) < 1e-15);
    assert_eq!(a.max_curvature(), 0.5);
}

#[test]
fn a_helix_by_hand() {
    // Radius 3, 8π rise a turn: the slope is 4 to 3, so a turn is 2π·5 long.
    let a = Arc::new(Plane::Xy.frame(), 3.0, TAU, 4.0 * TAU);
    assert!((a.length() - 5.0 * TAU).abs() < 1e-14);
    assert!(a.tangent_at(0.0).distance(Vec3::new(0.0, 0.6, 0.8)) < 1e-15);
    assert!((a.max_curvature() - 3.0 / 25.0).abs() < 1e-16);
}

#[test]
fn derivatives_of_an_arc_step_by_step() {
    for (sweep, rise) in [(2.0, 0.0), (-4.0, 0.0), (30.0, 25.0), (-7.0, -3.0)] {
        let arc = Arc::new(Plane::Zx.frame(), 3.0, sweep, rise);
        let step = arc.length() / 8.0;
        let mut derivatives = arc.derivatives_from(0.3 * step, step);
        let axes: [[[f64; 8]; 3]; 3] = std::array::from_fn(|axis| derivatives.of_axis(axis));
        for index in 0..8 {
            let at = |order: usize| Vec3::from_array(axes.map(|of| of[order][index]));
            assert_eq!(derivatives.here(), [at(0), at(1), at(2)]);
            let [_, exact @ ..] = arc.jet_at((0.3 + index as f64) * step);
            for (stepped, exact) in derivatives.here().into_iter().zip(exact) {
                assert!(stepped.distance(exact) < 1e-14, "{sweep} {index}: {stepped:?} {exact:?}");
            }
            derivatives.advance();
        }
    }
    let point = Arc::new(Plane::Xy.frame(), 0.0, 0.0, 0.0);
    assert_eq!(point.derivatives_from(0.0, 1.0).here(), [Vec3::ZERO; 3]);
}

#[test]
fn archimedean_spiral_from_its_centre() {
    // r = φ over one turn: ½[2π√(1 + 4π²) + asinh 2π] = 21.256 294 148 209 1.
    let s = Spiral::new(Plane::Xy.frame(), (0.0, TAU), TAU, 0.0);
    assert!((s.length() - 21.256_294_148_209_098).abs() < 1e-13);
    // At the centre the curvature of r = φ is 2, largest of all.
    assert!((s.curvature_at(0.0).length() - 2.0).abs() < 1e-14);
    assert!((s.max_curvature() - 2.0).abs() < 1e-14);
    assert!(s.tangent_at(0.0).distance(Vec3::X) < 1e-15);
}

#[test]
fn a_spiral_without_sweep_is_a_line() {
    let s = Spiral::new(Plane::Xy.frame(), (2.0, 5.0), 0.0, 4.0);
    assert_eq!(s.length(), 5.0);
    assert!(s.point_at(2.5).distance(Vec3::new(3.5, 0.0, 2.0)) < 1e-15);
    assert_eq!(s.tangent_at(1.0), Vec3::new(0.6, 0.0, 0.8));
    assert_eq!(s.max_curvature(), 0.0);
}

#[test]
fn spiral_joins_the_arc_as_the_growth_vanishes() {
    for rise in [0.0, 7.0] {
        let arc = Arc::new(Plane::Xy.frame(), 10.0, 4.0, rise);
        for growth in [1e-3, 1e-6, 1e-9, 1e-12, 1e-15, 0.0] {
            let s = Spiral::new(Plane::Xy.frame(), (10.0, 10.0 + growth), 4.0, rise);
            let expected = length_by_polylines(&s.into(), 0.0, 1.0);
            assert!((s.length() - expected).abs() <= 1e-12 * expected, "growth {growth}");
            let apart = (s.length() - arc.length()).abs();
            assert!(apart <= 2.1 * growth + 1e-13, "growth {growth}: {apart:e}");
        }
    }
}

#[test]
fn a_mirror_turns_the_sense() {
    let a = Arc::new(Plane::Xy.frame(), 5.0, 1.0, 2.0);
    let m = a.transformed(&Transform::mirror(Vec3::X, Vec3::ZERO));
    assert_eq!(m.w, Vec3::Z);
    assert_eq!(m.sweep, -1.0);
    assert_eq!(m.rise, 2.0);
    assert_eq!(m.start, Vec3::new(-5.0, 0.0, 0.0));
    let m = a.transformed(&Transform::mirror(Vec3::Z, Vec3::ZERO));
    assert_eq!((m.w, m.sweep, m.rise), (-Vec3::Z, -1.0, 2.0));
}

#[test]
fn through_three_points() {
    let a =
        Arc::through(Vec3::new(3.0, 0.0, 1.0), Vec3::new(0.0, 3.0, 1.0), Vec3::new(0.0, -3.0, 1.0))
            .unwrap();
    assert!(a.center.distance(Vec3::Z) < 1e-15);
    assert!((a.radius - 3.0).abs() < 1e-15);
    assert!((a.sweep - 0.75 * TAU).abs() < 1e-15);
    assert!(a.nearest(Vec3::new(0.0, 3.0, 1.0)).distance < 1e-14);
    let on_line = Arc::through(Vec3::ZERO, Vec3::X, Vec3::X * 2.0);
    assert!(on_line.is_none());
    assert!(Arc::through(Vec3::X, Vec3::Y, Vec3::X).is_none());
}

#[test]
fn asking_beyond_the_ends_gives_the_ends() {
    let l = Line::new(Vec3::X, Vec3::Y);
    assert_eq!(l.point_at(-1.0), l.start);
    assert_eq!(l.point_at(9.0), l.end);
    assert_eq!(l.subsegment(9.0, -9.0), l.reversed());
    let (before, after) = l.split_at(-1.0);
    assert_eq!((before.length(), after), (0.0, l));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn ends_are_exact(c in curve()) {
        prop_assert_eq!(c.point_at(0.0), c.start());
        prop_assert_eq!(c.point_at(c.length()), c.end());
    }

    #[test]
    fn length_agrees_with_polylines(c in curve()) {
        let expected = length_by_polylines(&c, 0.0, 1.0);
        // The sums are exact to a few parts in 1e13 only where the coordinates are not much larger
        // than the pieces.
        let rounding = 1e-13 * scale_of(&c);
        prop_assert!(
            (c.length() - expected).abs() <= 1e-12 * expected + rounding,
            "{} but polylines give {}", c.length(), expected
        );
    }

    #[test]
    fn points_are_where_the_length_says(c in curve(), share in 0.0..1.0) {
        // s by polylines up to a fraction of the sweep, and back.
        let s = length_by_polylines(&c, 0.0, share);
        close(c.point_at(s), at_fraction(&c, share), 1e-11 * scale_of(&c))?;
    }

    #[test]
    fn tangent_is_the_derivative_of_points(c in curve(), share in 0.01..0.99) {
        let s = c.length() * share;
        let h = 1e-5 / rate_of(&c);
        prop_assume!(h < 0.01 * c.length());
        let numeric = (c.point_at(s + h) - c.point_at(s - h)) / (2.0 * h);
        let rounding = 4e-15 * scale_of(&c) / h;
        prop_assume!(rounding < 1e-3);
        close(c.tangent_at(s), numeric, 1e-8 + rounding)?;
        prop_assert!((c.tangent_at(s).length() - 1.0).abs() < 1e-14);
    }

    #[test]
    fn curvature_is_the_derivative_of_the_tangent(c in curve(), share in 0.01..0.99) {
        let s = c.length() * share;
        let unit = rate_of(&c);
        let h = 1e-5 / unit;
        // s itself is known to its own rounding only.
        let rounding = (1e-15 + 2e-16 * unit * c.length() * 4.0) / h;
        prop_assume!(s - h > 0.0 && s + h < c.length() && rounding < 1e-3 * unit);
        let numeric = (c.tangent_at(s + h) - c.tangent_at(s - h)) / (2.0 * h);
        close(c.curvature_at(s), numeric, 1e-8 * unit + rounding)?;
        let numeric = (c.curvature_at(s + h) - c.curvature_at(s - h)) / (2.0 * h);
        close(c.curvature_derivative_at(s), numeric, 1e-7 * unit * unit + rounding * unit)?;
    }

    #[test]
    fn all_at_once_is_the_same_as_one_by_one(c in curve(), share in -0.1..1.1) {
        let s = c.length() * share;
        let [point, tangent, curvature, derivative] = c.jet_at(s);
        prop_assert_eq!(point, c.point_at(s));
        prop_assert_eq!(tangent, c.tangent_at(s));
        prop_assert_eq!(curvature, c.curvature_at(s));
        prop_assert_eq!(derivative, c.curvature_derivative_at(s));
    }

    #[test]
    fn a_tracer_answers_the_same_wherever_it_was_asked_before(
        c in curve(), shares in prop::collection::vec(-0.1..1.1, 1..20), forward in any::<bool>(),
    ) {
        prop_assume!(c.length() > 0.0);
        let mut shares = shares;
        if forward {
            shares.sort_by(f64::total_cmp);
        }
        let unit = rate_of(&c);
        // Either angle is as exact as the whole sweep is, by a few roundings; the derivatives are sums of
        // some ten terms that may cancel.
        let angle = 1e-15 * (2.0 + unit * c.length());
        let mut tracer = Tracer::new(&c);
        for share in shares {
            let s = c.length() * share;
            let jet = c.jet_at(s);
            let traced = tracer.jet_at(s);
            if s <= 0.0 || s >= c.length() {
                prop_assert_eq!(traced[0], jet[0]);
            }
            close(traced[0], jet[0], 4e-16 * scale_of(&c) + angle / unit)?;
            for order in 1..4 {
                close(traced[order], jet[order], 8.0 * angle * unit.powi(order as i32 - 1))?;
            }
        }
    }

    #[test]
    fn a_traced_motion_follows_the_chain_rule(
        c in curve(), share in 0.0..1.0, speed in 0.0..200.0, acceleration in -2e3..2e3, jerk in -1e5..1e5,
    ) {
        let s = c.length() * share;
        let mut tracer = Tracer::new(&c);
        let [point, d1, d2, d3] = tracer.jet_at(s);
        let [at, v, a, j] = tracer.motion_at(s, [speed, acceleration, jerk]);
        prop_assert_eq!(at, point);
        let near = |a: Vec3, parts: [Vec3; 3]| {
            let size: f64 = parts.iter().map(|part| part.length()).sum();
            close(a, parts[0] + parts[1] + parts[2], 4e-15 * size)
        };
        near(v, [d1 * speed, Vec3::ZERO, Vec3::ZERO])?;
        near(a, [d1 * acceleration, d2 * (speed * speed), Vec3::ZERO])?;
        near(j, [d1 * jerk, d2 * (3.0 * speed * acceleration), d3 * speed.powi(3)])?;
    }

    #[test]
    fn no_sample_is_more_curved_than_the_most(c in curve()) {
        let most = c.max_curvature();
        let mut seen = 0.0_f64;
        for i in 0..=400 {
            seen = seen.max(c.curvature_at(c.length() * f64::from(i) / 400.0).length());
        }
        prop_assert!(seen <= most * (1.0 + 1e-10), "{seen} above {most}");
    }

    #[test]
    fn reversed_runs_backwards_and_twice_is_the_same(c in curve(), share in 0.0..1.0) {
        let r = c.reversed();
        let unit = scale_of(&c);
        prop_assert!((r.length() - c.length()).abs() <= 1e-14 * unit);
        let s = c.length() * share;
        close(r.point_at(c.length() - s), c.point_at(s), 1e-12 * unit)?;
        close(r.tangent_at(c.length() - s), -c.tangent_at(s), 1e-9)?;
        let rr = r.reversed();
        prop_assert_eq!((rr.start(), rr.end()), (c.start(), c.end()));
        close(rr.point_at(s), c.point_at(s), 1e-13 * unit)?;
    }

    #[test]
    fn parts_join_and_their_lengths_add(c in curve(), share in 0.0..1.0) {
        let s = c.length() * share;
        let (a, b) = c.split_at(s);
        prop_assert_eq!((a.start(), b.end()), (c.start(), c.end()));
        prop_assert_eq!(a.end(), b.start());
        let unit = scale_of(&c);
        prop_assert!((a.length() + b.length() - c.length()).abs() <= 1e-12 * c.length() + 1e-15 * unit);
        prop_assert!((a.length() - s).abs() <= 1e-12 * c.length() + 1e-15 * unit);
        close(b.point_at(0.5 * b.length()), c.point_at(s + 0.5 * b.length()), 1e-12 * unit)?;
        close(a.tangent_at(a.length()), b.tangent_at(0.0), 1e-9)?;
    }

    #[test]
    fn a_part_is_where_it_was(c in curve(), x in 0.0..1.0, y in 0.0..1.0) {
        let (s0, s1) = (c.length() * x, c.length() * y);
        let part = c.subsegment(s0, s1);
        let unit = scale_of(&c);
        prop_assert!((part.length() - (s1 - s0).abs()).abs() <= 1e-12 * unit);
        close(part.start(), c.point_at(s0), 1e-12 * unit)?;
        close(part.end(), c.point_at(s1), 1e-12 * unit)?;
        close(part.point_at(0.5 * part.length()), c.point_at(0.5 * (s0 + s1)), 1e-11 * unit)?;
    }

    #[test]
    fn transforms_commute_with_points(c in curve(), t in transform(), share in 0.0..1.0) {
        let moved = c.transformed(&t);
        let unit = scale_of(&c) * t.scale_factor() + scale_of(&moved);
        prop_assert!((moved.length() - c.length() * t.scale_factor()).abs() <= 1e-13 * unit);
        let s = c.length() * share;
        let there = s * t.scale_factor();
        close(moved.point_at(there), t.apply_point(c.point_at(s)), 1e-11 * unit)?;
        close(moved.tangent_at(there), t.apply_direction(c.tangent_at(s)), 1e-8)?;
        let back = moved.transformed(&t.inverse());
        close(back.point_at(s), c.point_at(s), 1e-11 * unit / t.scale_factor().min(1.0))?;
    }

    #[test]
    fn turning_keeps_the_length(c in curve(), p in point(), axis in point(), angle in -10.0..10.0) {
        let turned = c.transformed(&Transform::rotation_about(p, axis, angle));
        prop_assert!((turned.length() - c.length()).abs() <= 1e-13 * scale_of(&c));
    }

    #[test]
    fn an_arc_through_points_of_an_arc_is_that_arc(a in arc(), share in 0.1..0.9) {
        let plane = Arc::new(
            chordal_geometry::Frame { origin: a.center, u: a.u, v: a.w.cross(a.u), w: a.w },
            a.radius,
            a.sweep.signum() * (a.sweep.abs() % 6.0).max(0.3),
            0.0,
        );
        let via = plane.point_at(plane.length() * share);
        let again = Arc::through(plane.start, via, plane.end).unwrap();
        let unit = 1e-15 * scale_of(&Curve::Arc(plane)) * 4000.0;
        close(again.center, plane.center, unit)?;
        prop_assert!((again.length() - plane.length()).abs() <= unit * 4.0);
    }
}
