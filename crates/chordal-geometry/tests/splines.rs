//! Splines: points and derivatives by a second formula, lengths, boxes, parts, chords.

use chordal_geometry::{
    Arc, Curve, EvenPart, ParamCurve, Placement, Plane, Spline, SplineError, SplinePiece, Tracer,
    Transform, Vec3,
};
use proptest::prelude::*;

fn at(x: f64, y: f64) -> Vec3 {
    Vec3::new(x, y, 0.0)
}

/// The basis function of an order by its recursion (Cox and de Boor), 0/0 as 0.
fn basis(knots: &[f64], index: usize, order: usize, u: f64) -> f64 {
    if order == 1 {
        let last = knots[knots.len() - 1];
        let (low, high) = (knots[index], knots[index + 1]);
        return f64::from((low <= u && u < high) || (u == last && low < high && high == last));
    }
    let part = |over: f64, under: f64| if under == 0.0 { 0.0 } else { over / under };
    let rise = part(u - knots[index], knots[index + order - 1] - knots[index]);
    let fall = part(knots[index + order] - u, knots[index + order] - knots[index + 1]);
    rise * basis(knots, index, order - 1, u) + fall * basis(knots, index + 1, order - 1, u)
}

/// The point as the weighted mean of the control points.
fn by_basis(spline: &Spline, u: f64) -> Vec3 {
    let (mut sum, mut weight) = (Vec3::ZERO, 0.0);
    for (index, point) in spline.points().iter().enumerate() {
        let share = spline.weights()[index] * basis(spline.knots(), index, spline.order(), u);
        sum += *point * share;
        weight += share;
    }
    sum / weight
}

fn worked() -> Spline {
    let points = vec![at(0.0, 0.0), at(1.0, 2.0), at(3.0, 3.0), at(5.0, 0.0), at(7.0, 1.0)];
    Spline::uniform(4, points, vec![1.0, 1.0, 2.0, 1.0, 1.0]).unwrap()
}

#[test]
fn points_by_hand() {
    let spline = worked();
    assert_eq!(spline.knots(), [0.0, 0.0, 0.0, 0.0, 1.0, 2.0, 2.0, 2.0, 2.0]);
    for (u, x, y) in [(0.5, 1.8, 2.15), (1.0, 3.0, 7.0 / 3.0), (1.5, 4.3, 1.35), (2.0, 7.0, 1.0)] {
        assert!(spline.point_at(u).distance(at(x, y)) < 1e-14, "{u}: {:?}", spline.point_at(u));
    }
    // B(½) of a cubic is (P₀ + 3P₁ + 3P₂ + P₃)/8.
    let cubic =
        Spline::bezier(vec![at(0.0, 0.0), at(0.0, 3.0), at(1.0, -2.0), at(1.0, 1.0)]).unwrap();
    assert!(cubic.point_at(0.5).distance(at(0.5, 0.5)) < 1e-15);
    assert_eq!((cubic.start_tangent(), cubic.end_tangent()), (Vec3::Y, Vec3::Y));
}

#[test]
fn what_is_no_spline() {
    let points = vec![at(0.0, 0.0), at(1.0, 2.0)];
    let uniform = |order, weights: Vec<f64>| Spline::uniform(order, points.clone(), weights);
    assert_eq!(uniform(3, vec![1.0; 2]), Err(SplineError::TooFew { points: 2, order: 3 }));
    assert_eq!(uniform(1, vec![1.0; 2]), Err(SplineError::Order(1)));
    assert_eq!(uniform(2, vec![1.0]), Err(SplineError::Weights(1)));
    assert_eq!(uniform(2, vec![1.0, 0.0]), Err(SplineError::Weight(0.0)));
    let knots = |knots: &[f64]| Spline::new(2, points.clone(), vec![1.0; 2], knots.to_vec());
    assert_eq!(knots(&[0.0, 0.0, 1.0]), Err(SplineError::Knots));
    assert_eq!(knots(&[0.0, 0.5, 1.0, 1.0]), Err(SplineError::Knots));
    assert_eq!(knots(&[0.0, 0.0, f64::NAN, 1.0]), Err(SplineError::NotFinite));
    assert!(knots(&[0.0, 0.0, 1.0, 1.0]).is_ok());
}

#[test]
fn a_parabola_has_a_length_in_closed_form() {
    // y = x² from 0 to 1: √5/2 + asinh(2)/4.
    let spline = Spline::bezier(vec![at(0.0, 0.0), at(0.5, 0.0), at(1.0, 1.0)]).unwrap();
    let exact = 1.478_942_857_544_597_4;
    assert!((spline.length(1e-12) - exact).abs() < 1e-12);
    let piece = spline.pieces().unwrap()[0];
    assert!((piece.length() - exact).abs() < 1e-14);
    // Its curvature is largest at the vertex: 2.
    assert!((piece.max_curvature() - 2.0).abs() < 1e-12);
    assert!(piece.curvature_at(0.0).distance(Vec3::Y * 2.0) < 1e-13);
}

#[test]
fn a_quarter_circle_answers_as_the_arc() {
    let weights = [1.0, 0.5_f64.sqrt(), 1.0];
    let piece = SplinePiece::new(&[at(5.0, 0.0), at(5.0, 5.0), at(0.0, 5.0)], &weights).unwrap();
    let arc = Arc::new(Plane::Xy.frame(), 5.0, std::f64::consts::FRAC_PI_2, 0.0);
    assert!((piece.length() - arc.length()).abs() < 1e-13);
    let mut tracer = Tracer::new(&Curve::Spline(piece));
    for k in 0..=20 {
        let s = arc.length() * f64::from(k) / 20.0;
        let exact = arc.jet_at(s);
        for (order, (a, b)) in piece.jet_at(s).into_iter().zip(exact).enumerate() {
            assert!(a.distance(b) < 1e-12, "{s}, derivative {order}: {a:?} {b:?}");
        }
        let [p, d1, d2, d3] = exact;
        let exact = [p, d1 * 2.0, d1 * 3.0 + d2 * 4.0, d1 * 4.0 + d2 * 18.0 + d3 * 8.0];
        // What a tracer promises of a spline, and what follows for its derivatives.
        let within = [1e-9, 1e-9, 1e-8, 1e-8];
        let found = tracer.motion_at(s, [2.0, 3.0, 4.0]);
        for ((a, b), within) in found.into_iter().zip(exact).zip(within) {
            assert!(a.distance(b) < within, "{s}: {a:?} {b:?}");
        }
    }
    let box_of = piece.bounds();
    assert!(box_of.min.distance(Vec3::ZERO) < 1e-15 && box_of.max.distance(at(5.0, 5.0)) < 1e-15);
}

#[test]
fn odd_splines_have_answers() {
    let pieces = |points: &[Vec3]| Spline::bezier(points.to_vec()).unwrap().pieces().unwrap()[0];
    // A cusp: to (1,1) and back.
    let cusp = pieces(&[at(0.0, 0.0), at(1.0, 1.0), at(0.0, 1.0), at(1.0, 0.0)]);
    assert!(cusp.length().is_finite() && cusp.point_at(0.4 * cusp.length()).is_finite());
    // No speed at either end.
    let still = pieces(&[at(0.0, 0.0), at(0.0, 0.0), at(10.0, 0.0), at(10.0, 0.0)]);
    assert!((still.length() - 10.0).abs() < 1e-12);
    assert_eq!((still.tangent_at(0.0), still.tangent_at(10.0)), (Vec3::X, Vec3::X));
    assert!(still.point_at(3.0).distance(at(3.0, 0.0)) < 1e-11);
    // One point.
    let none = pieces(&[at(1.0, 1.0), at(1.0, 1.0), at(1.0, 1.0)]);
    assert_eq!((none.length(), none.tangent_at(0.0)), (0.0, Vec3::ZERO));
    assert_eq!(none.chords(0.1, Placement::Inscribed).unwrap().count(), 2);
    let lost = pieces(&[at(0.0, 0.0), at(1.0, 1.0), at(0.0, 1.0)]);
    assert!(lost.point_at(f64::NAN).x.is_nan());
    for piece in [cusp, still, none] {
        let mut length = 0.0;
        piece.even_parts(1e-6, &mut |part| {
            length += match part {
                EvenPart::Line(line) => line.length(),
                EvenPart::Bent(bent) => bent.length(),
            };
        });
        assert!((length - piece.length()).abs() < 1e-4, "{length} {}", piece.length());
    }
}

prop_compose! {
    fn splines()(order in 2_usize..=6, more in 0_usize..5)(
        order in Just(order),
        points in prop::collection::vec((-20.0..20.0, -20.0..20.0, -5.0..5.0), order + more),
        weights in prop::collection::vec(0.2..5.0, order + more),
    ) -> Spline {
        let points = points.into_iter().map(|(x, y, z)| Vec3::new(x, y, z)).collect();
        Spline::uniform(order, points, weights).unwrap()
    }
}

/// The largest coordinate of an axis, times a sign, that a spline reaches: of each span its ends, where a
/// polyline has its tips, and the surroundings of the best of many places, divided by three again and again.
fn farthest(spline: &Spline, axis: usize, sign: f64) -> f64 {
    const PLACES: u32 = 100;
    let (first, last) = spline.domain();
    let value = |u: f64| sign * spline.point_at(u).to_array()[axis];
    let mut knots = spline.knots().to_vec();
    knots.retain(|knot| (first..=last).contains(knot));
    knots.dedup();
    let mut most = f64::NEG_INFINITY;
    for span in knots.windows(2) {
        let at = |place: f64| span[0] + (span[1] - span[0]) * place / f64::from(PLACES);
        let best = (0..=PLACES)
            .max_by(|a, b| value(at(f64::from(*a))).total_cmp(&value(at(f64::from(*b)))))
            .map_or(0.0, f64::from);
        most = most.max(value(at(best)));
        let (mut low, mut high) =
            (at((best - 1.0).max(0.0)), at((best + 1.0).min(f64::from(PLACES))));
        for _ in 0..60 {
            let third = (high - low) / 3.0;
            if value(low + third) < value(high - third) {
                low += third;
            } else {
                high -= third;
            }
            most = most.max(value(low)).max(value(high));
        }
    }
    most
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(96))]

    #[test]
    fn points_are_the_weighted_means(spline in splines(), share in 0.0..=1.0) {
        let (first, last) = spline.domain();
        let u = first + (last - first) * share;
        prop_assert!(spline.point_at(u).distance(by_basis(&spline, u)) < 1e-11);
    }

    #[test]
    fn derivatives_are_differences(spline in splines(), share in 0.0..1.0) {
        // Within one span.
        let u: f64 = share * spline.domain().1;
        let u = u.floor() + 0.1 + 0.8 * u.fract();
        let h = 1e-4;
        let (before, now, after) = (spline.jet_at(u - h), spline.jet_at(u), spline.jet_at(u + h));
        for order in 0..3 {
            let slope = (after[order] - before[order]) / (2.0 * h);
            let size = (0..4).map(|k| now[k].length()).fold(1.0, f64::max);
            prop_assert!(slope.distance(now[order + 1]) < 1e-3 * size, "{order}: {slope:?} {:?}", now[order + 1]);
        }
    }

    #[test]
    fn pieces_are_the_spline(spline in splines(), share in 0.0..=1.0) {
        let pieces = spline.pieces().unwrap();
        let (first, _) = spline.domain();
        for (index, piece) in pieces.iter().enumerate() {
            let u = first + index as f64 + share;
            prop_assert!(piece.jet_at_parameter(share)[0].distance(by_basis(&spline, u)) < 1e-10);
        }
        for pair in pieces.windows(2) {
            prop_assert_eq!(pair[0].end(), pair[1].start());
        }
        prop_assert_eq!(pieces[0].start(), spline.start());
        prop_assert_eq!(pieces[pieces.len() - 1].end(), spline.end());
        let sum: f64 = pieces.iter().map(ParamCurve::length).sum();
        prop_assert!((sum - spline.length(1e-10)).abs() < 1e-9);
    }

    #[test]
    fn reversed_split_and_mapped(spline in splines(), share in 0.01..0.99_f64) {
        let (first, last) = spline.domain();
        let u = first + (last - first) * share;
        let back = spline.reversed();
        prop_assert!(back.point_at(first + last - u).distance(spline.point_at(u)) < 1e-10);
        let shear = |p: Vec3| Vec3::new(p.x + 0.5 * p.y + 3.0, 2.0 * p.y - p.z, p.z - 1.0);
        prop_assert!(spline.mapped(shear).point_at(u).distance(shear(spline.point_at(u))) < 1e-10);
        let (before, after) = spline.split_at(u).unwrap();
        prop_assert_eq!(before.end(), after.start());
        prop_assert_eq!((before.domain(), after.domain()), ((first, u), (u, last)));
        for k in 0..=8 {
            let part = f64::from(k) / 8.0;
            let (a, b) = (first + (u - first) * part, u + (last - u) * part);
            prop_assert!(before.point_at(a).distance(by_basis(&spline, a)) < 1e-9);
            prop_assert!(after.point_at(b).distance(by_basis(&spline, b)) < 1e-9);
        }
    }

    #[test]
    fn lengths_and_places_of_pieces(spline in splines(), share in 0.0..=1.0) {
        for piece in spline.pieces().unwrap() {
            let length = piece.length();
            let s = length * share;
            let (before, after) = piece.split_at(s);
            prop_assert!((before.length() - s).abs() < 1e-9, "{} {s}", before.length());
            prop_assert!((before.length() + after.length() - length).abs() < 1e-9);
            prop_assert_eq!(before.end(), after.start());
            prop_assert!(piece.reversed().point_at(length - s).distance(piece.point_at(s)) < 1e-8);
            let nearest = piece.nearest(piece.point_at(s));
            prop_assert!(nearest.distance < 1e-6, "{}", nearest.distance);
            let by = Transform::rotation_about(Vec3::X, Vec3::Z, 1.0).then(&Transform::scale(2.0).unwrap());
            let moved = piece.transformed(&by);
            prop_assert!(moved.point_at(2.0 * s).distance(by.apply_point(piece.point_at(s))) < 1e-8);
            let mut tracer = Tracer::new(&Curve::Spline(piece));
            prop_assert!(tracer.jet_at(s)[0].distance(piece.point_at(s)) < 1e-9);
        }
    }

    #[test]
    fn boxes_hold_and_touch(spline in splines()) {
        let found = spline.bounds();
        let (first, last) = spline.domain();
        for k in 0..=2000 {
            let p = spline.point_at(first + (last - first) * f64::from(k) / 2000.0);
            prop_assert!(found.expand(1e-12).contains(p));
        }
        for axis in 0..3 {
            for (sign, side) in [(1.0, found.max), (-1.0, found.min)] {
                let reached = sign * farthest(&spline, axis, sign);
                let side = side.to_array()[axis];
                prop_assert!((reached - side).abs() < 1e-9, "{axis}: {reached}, the box {side}");
            }
        }
    }

    #[test]
    fn chords_hold_their_tolerance(spline in splines(), tolerance in 0.001..0.5_f64) {
        for piece in spline.pieces().unwrap() {
            let corners: Vec<Vec3> = piece.chords(tolerance, Placement::Inscribed).unwrap().collect();
            let count = corners.len() - 1;
            prop_assert_eq!((corners[0], corners[count]), (piece.start(), piece.end()));
            for k in 0..200 {
                let t = (f64::from(k) + 0.5) / 200.0;
                let index = ((t * count as f64) as usize).min(count - 1);
                let chord = chordal_geometry::Line { start: corners[index], end: corners[index + 1] };
                let off = chord.nearest(piece.jet_at_parameter(t)[0]).distance;
                prop_assert!(off <= tolerance, "{off} > {tolerance}");
            }
        }
    }

    #[test]
    fn even_parts_follow_the_curve(spline in splines()) {
        for piece in spline.pieces().unwrap() {
            let mut at = piece.start();
            let mut length = 0.0;
            piece.even_parts(1e-6, &mut |part| {
                let curve = match part {
                    EvenPart::Line(line) => Curve::Line(line),
                    EvenPart::Bent(bent) => Curve::Spline(bent),
                };
                assert!(curve.start().distance(at) < 1e-12);
                at = curve.end();
                length += curve.length();
                assert!(piece.nearest(curve.point_at(0.5 * curve.length())).distance < 1e-5);
            });
            prop_assert!(at.distance(piece.end()) < 1e-12);
            prop_assert!((length - piece.length()).abs() < 1e-4);
        }
    }
}
