//! Chords: their number, and their distance from the curve by dense sampling.

mod common;

use chordal_geometry::{
    Arc, ChordError, Curve, Line, MAX_CHORDS, ParamCurve, Placement, Plane, Spiral, Vec3,
};
use common::*;
use proptest::prelude::*;

const BOTH: [Placement; 2] = [Placement::Inscribed, Placement::Balanced];

fn circle(radius: f64, sweep: f64) -> Arc {
    Arc::new(Plane::Xy.frame(), radius, sweep, 0.0)
}

#[test]
fn the_known_counts() {
    let count = |sweep, placement| circle(10.0, sweep).chord_count(0.001, placement).unwrap();
    assert_eq!(count(TAU, Placement::Inscribed), 223);
    assert_eq!(count(TAU, Placement::Balanced), 158);
    assert_eq!(count(0.25 * TAU, Placement::Inscribed), 56);
    assert_eq!(count(0.25 * TAU, Placement::Balanced), 40);
    assert_eq!(count(-0.25 * TAU, Placement::Balanced), 40);
}

#[test]
fn rounded_down_counts_are_those_of_the_firmware() {
    // Of GRBL's own source, run: its arc tolerance, radius, angle.
    for (radius, sweep, n) in [(1.0, 0.5 * TAU, 24), (1.0, TAU, 49), (1000.0, 0.5 * TAU, 785)] {
        let chords = circle(radius, sweep).chords(0.002, Placement::RoundedDown).unwrap();
        assert_eq!(chords.chord_count(), n);
        let sagitta = radius * (1.0 - libm::cos(sweep / n as f64 / 2.0));
        assert!((chords.sagitta().unwrap() - sagitta).abs() < 1e-12 * radius);
    }
    // Less than one step, and a tolerance as large as the circle.
    assert_eq!(circle(1.0, 0.01).chord_count(0.002, Placement::RoundedDown), Ok(1));
    assert_eq!(circle(1.0, TAU).chord_count(3.0, Placement::RoundedDown), Ok(1));
}

#[test]
fn one_fewer_inscribed_chord_would_deviate_too_much() {
    for sweep in [0.3, 1.0, 3.0, TAU, 20.0] {
        for e in [1e-6, 1e-3, 0.01, 0.3] {
            let n = circle(10.0, sweep).chord_count(e, Placement::Inscribed).unwrap() as f64;
            let sagitta = |n: f64| 10.0 * (1.0 - libm::cos(sweep / n / 2.0));
            assert!(sagitta(n) <= e * (1.0 + 1e-9), "sweep {sweep}, e {e}, n {n}");
            if n > 1.0 {
                assert!(sagitta(n - 1.0) > e, "sweep {sweep}, e {e}, n {n}");
            }
        }
    }
}

#[test]
fn a_whole_number_of_steps_stays_that_number() {
    // A square, a hexagon and a 360-gon by their own deviation, as computed with rounding.
    for n in [4_u32, 6, 12, 360] {
        let e = 7.0 * (1.0 - libm::cos(TAU / f64::from(n) / 2.0));
        let count = circle(7.0, TAU).chord_count(e * (1.0 + 1e-12), Placement::Inscribed);
        assert_eq!(count, Ok(u64::from(n)));
    }
}

#[test]
fn balanced_corners_lie_outside_and_ends_on_the_circle() {
    let a = circle(10.0, TAU);
    let corners: Vec<Vec3> = a.chords(0.001, Placement::Balanced).unwrap().collect();
    assert_eq!(corners.len(), 159);
    assert_eq!((corners[0], corners[158]), (a.start, a.end));
    for pair in corners[1..158].windows(2) {
        assert!((pair[0].length() - 10.001).abs() < 1e-5 && pair[0].length() <= 10.001);
        let middle = pair[0].lerp(pair[1], 0.5).length();
        assert!((middle - 9.999).abs() < 1e-5 && middle >= 9.999);
    }
}

#[test]
fn the_end_chords_of_a_steep_helix_stay_within_the_tolerance() {
    // So steep that the nearest point is the one at the same height.
    for e in [0.001, 0.01, 0.1, 1.0, 3.0] {
        let helix = Curve::from(Arc::new(Plane::Xy.frame(), 10.0, TAU, 1e5));
        let corners: Vec<Vec3> = helix.chords(e, Placement::Balanced).unwrap().collect();
        let worst = deviation(&helix, &corners);
        assert!(worst <= e * (1.0 + 1e-9) && worst > 0.5 * e, "{worst} for {e}");
    }
}

#[test]
fn a_line_is_one_chord() {
    let l = Line::new(Vec3::X, Vec3::Y);
    for placement in BOTH {
        let c = l.chords(1e-9, placement).unwrap();
        assert_eq!(c.chord_count(), 1);
        assert_eq!(c.collect::<Vec<_>>(), [Vec3::X, Vec3::Y]);
    }
}

#[test]
fn large_tolerances_still_leave_three_to_a_turn() {
    for placement in BOTH {
        for e in [10.0, 1e9, f64::INFINITY] {
            let once = circle(10.0, TAU).chord_count(e, placement).unwrap();
            assert!((3..=4).contains(&once), "{once}");
            let many = circle(10.0, 10.0 * TAU).chord_count(e, placement).unwrap();
            assert!((30..=31).contains(&many), "{many}");
            let s = Spiral::new(Plane::Xy.frame(), (0.0, 1e-3), 10.0 * TAU, 0.0);
            let n = s.chord_count(e, placement).unwrap();
            assert!((30..100).contains(&n), "{n}");
        }
    }
}

#[test]
fn bad_tolerances_are_errors() {
    for curve in [Curve::Line(Line::new(Vec3::X, Vec3::Y)), circle(1.0, 1.0).into()] {
        for e in [0.0, -0.0, -1.0, f64::NEG_INFINITY] {
            assert_eq!(curve.chord_count(e, Placement::Inscribed), Err(ChordError::Tolerance(e)));
        }
        assert!(curve.chords(f64::NAN, Placement::Balanced).is_err());
    }
}

#[test]
fn too_many_is_said_before_any_is_made() {
    for placement in BOTH {
        for e in [1e-300, f64::MIN_POSITIVE, 5e-324] {
            let arc = circle(1e6, TAU).chord_count(e, placement);
            assert!(matches!(arc, Err(ChordError::TooMany(_))), "{arc:?}");
            let s = Spiral::new(Plane::Xy.frame(), (1e6, 0.0), TAU, 0.0);
            assert!(matches!(s.chord_count(e, placement), Err(ChordError::TooMany(_))));
        }
        let n = circle(1e6, TAU).chord_count(1e-9, placement).unwrap();
        assert!(n > 40_000_000 && n < MAX_CHORDS);
        // Reached without walking there.
        let mut c = circle(1e6, TAU).chords(1e-9, placement).unwrap();
        assert_eq!(c.nth(n as usize), Some(circle(1e6, TAU).end));
        assert_eq!(c.next(), None);
    }
}

#[test]
fn the_iterator_counts_what_is_left() {
    let mut c = circle(10.0, 1.0).chords(0.01, Placement::Inscribed).unwrap();
    let n = c.chord_count() as usize;
    assert_eq!(c.size_hint(), (n + 1, Some(n + 1)));
    c.next();
    assert_eq!(c.size_hint(), (n, Some(n)));
    assert_eq!(c.by_ref().count(), n);
    assert_eq!((c.size_hint(), c.next()), ((0, Some(0)), None));
}

#[test]
fn spirals_take_few_more_chords_than_their_curvature_asks() {
    // 20 turns of pitch 1 to radius 20, e 1 µm: ∫√(κ·v²/8e)dφ ≈ ∫√(r/8e)dφ.
    let s = Spiral::new(Plane::Xy.frame(), (0.0, 20.0), 20.0 * TAU, 0.0);
    let n = s.chord_count(0.001, Placement::Inscribed).unwrap() as f64;
    let asked = 20.0 * TAU * (20.0_f64 / 0.008).sqrt() * 2.0 / 3.0;
    assert!(n >= asked && n < 1.02 * asked, "{n} for {asked}");
}

/// Largest distance of the chords from the curve and of the curve from the chords, by sampling the
/// curve finely around each chord.
fn deviation(c: &Curve, corners: &[Vec3]) -> f64 {
    const FINE: usize = 24;
    let mut worst = 0.0_f64;
    for pair in corners.windows(2) {
        let (a, b) = (pair[0], pair[1]);
        for i in 0..=FINE {
            let on_chord = a.lerp(b, i as f64 / FINE as f64);
            worst = worst.max(c.nearest(on_chord).distance);
        }
    }
    worst
}

/// Distance of samples of the curve from the polyline, walking both in step.
fn reverse_deviation(c: &Curve, corners: &[Vec3]) -> f64 {
    let n = corners.len() * 12;
    let mut chord = 0;
    let mut worst = 0.0_f64;
    for i in 0..=n {
        let p = at_fraction(c, i as f64 / n as f64);
        let distance = |k: usize| distance_to_segment(p, corners[k], corners[k + 1]);
        // This chord or the next; looking further would confuse the turns of a circle.
        let last = (chord + 1).min(corners.len() - 2);
        let best = (chord..=last).min_by(|&a, &b| distance(a).total_cmp(&distance(b)));
        chord = best.unwrap_or(chord);
        worst = worst.max(distance(chord));
    }
    worst
}

fn tolerance() -> impl Strategy<Value = f64> {
    (-4.0..0.5_f64).prop_map(|k| libm::pow(10.0, k))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(250))]

    #[test]
    fn chords_stay_within_the_tolerance(c in curve(), e in tolerance(), balanced in any::<bool>()) {
        let placement = BOTH[usize::from(balanced)];
        let chords = c.chords(e, placement).unwrap();
        prop_assume!(chords.chord_count() < 3000);
        let corners: Vec<Vec3> = chords.collect();
        prop_assert_eq!((corners[0], corners[corners.len() - 1]), (c.start(), c.end()));
        let rounding = 1e-12 * scale_of(&c);
        let there = deviation(&c, &corners);
        prop_assert!(there <= e * (1.0 + 1e-9) + rounding, "chords are {there} off, {e} allowed");
        let back = reverse_deviation(&c, &corners);
        prop_assert!(back <= e * (1.0 + 1e-9) + rounding, "the curve is {back} off, {e} allowed");
    }

    #[test]
    fn balanced_is_never_more(a in arc(), e in tolerance()) {
        let (i, b) = (a.chord_count(e, BOTH[0]), a.chord_count(e, BOTH[1]));
        prop_assume!(e < a.radius / 3.0);
        prop_assert!(b.unwrap() <= i.unwrap());
    }

    #[test]
    fn a_reversed_curve_has_the_same_corners(c in curve(), e in tolerance(), balanced in any::<bool>()) {
        let placement = BOTH[usize::from(balanced)];
        let (there, back) = (c.chords(e, placement).unwrap(), c.reversed().chords(e, placement).unwrap());
        let n = there.chord_count();
        prop_assume!(n == back.chord_count());
        for i in [0, 1, n / 3, n / 2, n - 1, n] {
            prop_assert!(there.corner(i).distance(back.corner(n - i)) <= 1e-11 * scale_of(&c));
        }
    }
}
