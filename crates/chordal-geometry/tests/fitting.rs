//! Lines and arcs through points: how many, how far off, and in one direction where they meet.

use chordal_geometry::{
    Arc, Curve, FitMeasure, FitOptions, FitPiece, ParamCurve, Placement, Plane, Vec3, breaks,
    fit_path, simplify,
};
use core::f64::consts::{PI, TAU};
use proptest::prelude::*;

fn ellipse(count: usize) -> Vec<Vec3> {
    let at = |index: usize| TAU * (index % count) as f64 / count as f64;
    (0..=count).map(|i| Vec3::new(30.0 * at(i).cos(), 10.0 * at(i).sin(), 0.0)).collect()
}

/// ∫(|κ′|/(factor·e))^⅓ ds of a curve given by its derivatives with respect to a parameter.
fn asymptotic(
    range: (f64, f64),
    derivatives: impl Fn(f64) -> [[f64; 2]; 3],
    factor: f64,
    tolerance: f64,
) -> f64 {
    let steps = 200_000;
    let width = (range.1 - range.0) / f64::from(steps);
    (0..steps)
        .map(|step| {
            let [[x1, y1], [x2, y2], [x3, y3]] =
                derivatives(range.0 + width * (f64::from(step) + 0.5));
            let speed2 = x1 * x1 + y1 * y1;
            let cross = x1 * y2 - y1 * x2;
            // κ = cross/v³; its derivative by arc length.
            let slope = ((x1 * y3 - y1 * x3) * speed2 - 3.0 * cross * (x1 * x2 + y1 * y2))
                / (speed2 * speed2 * speed2);
            (slope.abs() / (factor * tolerance)).cbrt() * speed2.sqrt() * width
        })
        .sum()
}

fn ellipse_derivatives(u: f64) -> [[f64; 2]; 3] {
    let (a, b) = (30.0, 10.0);
    [[-a * u.sin(), b * u.cos()], [-a * u.cos(), -b * u.sin()], [a * u.sin(), -b * u.cos()]]
}

/// The largest distance from points along the pieces to a row of chords, and back: an independent look, by
/// brute force.
fn apart(points: &[Vec3], pieces: &[FitPiece]) -> f64 {
    let samples: Vec<Vec3> = pieces
        .iter()
        .flat_map(|piece| {
            let length = piece.curve.length();
            (0..=200).map(move |step| piece.curve.point_at(length * f64::from(step) / 200.0))
        })
        .collect();
    let to_chord = |p: Vec3, a: Vec3, b: Vec3| {
        let chord = b - a;
        let t = ((p - a).dot(chord) / chord.length_squared()).clamp(0.0, 1.0);
        p.distance(a + chord * t)
    };
    let there = samples.iter().map(|sample| {
        points.windows(2).map(|pair| to_chord(*sample, pair[0], pair[1])).fold(f64::MAX, f64::min)
    });
    let back = points.iter().map(|point| {
        pieces.iter().map(|piece| piece.curve.nearest(*point).distance).fold(f64::MAX, f64::min)
    });
    there.chain(back).fold(0.0, f64::max)
}

fn worst(pieces: &[FitPiece]) -> f64 {
    pieces.iter().map(|piece| piece.deviation).fold(0.0, f64::max)
}

fn kinks(pieces: &[FitPiece], corner: f64) -> usize {
    breaks(pieces).filter(|(_, angle)| *angle > 1e-7 && *angle < corner).count()
}

/// The largest angle, degrees, by which the direction steps at a joint, that of the end with the start of a
/// closed path among them.
fn largest_step(pieces: &[FitPiece], is_closed: bool) -> f64 {
    let (first, last) = (pieces[0].curve, pieces[pieces.len() - 1].curve);
    let (a, b) = (last.tangent_at(last.length()), first.tangent_at(0.0));
    let closing = is_closed.then(|| a.cross(b).length().atan2(a.dot(b)));
    breaks(pieces).map(|(_, angle)| angle).chain(closing).fold(0.0, f64::max).to_degrees()
}

fn is_joined(points: &[Vec3], pieces: &[FitPiece]) -> bool {
    let ends = (pieces[0].curve.start(), pieces[pieces.len() - 1].curve.end());
    pieces.windows(2).all(|pair| pair[0].curve.end() == pair[1].curve.start())
        && ends.0 == points[0]
        && ends.1.distance(points[points.len() - 1]) < 1e-9
}

/// ArcWelder, at its best setting, needs 13, 23 and 41 arcs at the first three tolerances, which are
/// not tangent.
#[test]
fn an_ellipse_of_1336_chords() {
    let points = ellipse(1336);
    for (tolerance, arcs, tangent_arcs) in
        [(0.05, 10, 12), (0.01, 18, 20), (0.002, 31, 33), (0.0005, 50, 52)]
    {
        let free = asymptotic((0.0, TAU), ellipse_derivatives, 192.0, tolerance);
        let least = asymptotic((0.0, TAU), ellipse_derivatives, 72.0 * 3f64.sqrt(), tolerance);
        let options = FitOptions::within(tolerance);
        let tangent = fit_path(&points, &options).unwrap();
        let any = fit_path(&points, &FitOptions { tangent: false, ..options }).unwrap();
        println!(
            "{tolerance} mm: {} arcs, {} tangent ones, the start among them to {:.1e} degrees; asymptotically {least:.1} (free ends {free:.1})",
            any.len(),
            tangent.len(),
            largest_step(&tangent, true),
        );
        assert!(any.len() <= arcs && tangent.len() <= tangent_arcs);
        assert!(any.len() as f64 <= 1.25 * free, "{} arcs, {free} is the least", any.len());
        assert!(tangent.len() as f64 <= 1.25 * least);
        assert!(largest_step(&tangent, true) <= 1e-7, "{}", largest_step(&tangent, true));
        for pieces in [&tangent, &any] {
            assert!(is_joined(&points, pieces));
            assert!(worst(pieces) <= tolerance);
            assert!(apart(&points, pieces) <= worst(pieces) + 1e-9);
        }
    }
}

/// The start lies where it lies: not at a vertex, and in the middle of a piece that would be one otherwise.
#[test]
fn closed_paths_are_tangent_at_their_start() {
    let least =
        |tolerance: f64| asymptotic((0.0, TAU), ellipse_derivatives, 72.0 * 3f64.sqrt(), tolerance);
    let (mut arcs, mut asymptotically) = (0, 0.0);
    for start in [0, 64, 170, 334, 467] {
        let mut points = ellipse(1336);
        points.pop();
        points.rotate_left(start);
        points.push(points[0]);
        for tolerance in [0.1, 0.03, 0.01, 0.003, 0.001] {
            let pieces = fit_path(&points, &FitOptions::within(tolerance)).unwrap();
            assert!(is_joined(&points, &pieces) && worst(&pieces) <= tolerance);
            assert!(largest_step(&pieces, true) <= 1e-7, "{}", largest_step(&pieces, true));
            (arcs, asymptotically) = (arcs + pieces.len(), asymptotically + least(tolerance));
        }
    }
    println!("{arcs} arcs, asymptotically {asymptotically:.1}");
    assert!(f64::from(arcs as u32) <= 1.1 * asymptotically, "{arcs}, {asymptotically}");
    // A half circle and a line with corners; it begins within the half circle.
    let mut points: Vec<Vec3> = (0..=200)
        .map(|i| PI * f64::from(i) / 200.0)
        .map(|t| Vec3::new(12.0 * t.cos() + 0.8 * (3.0 * t).cos(), 9.0 * t.sin(), 0.0))
        .collect();
    points.rotate_left(90);
    points.push(points[0]);
    let pieces = fit_path(&points, &FitOptions::within(0.005)).unwrap();
    assert!(is_joined(&points, &pieces) && worst(&pieces) <= 0.005);
    let corners: Vec<f64> =
        breaks(&pieces).map(|(_, angle)| angle).filter(|it| *it > 1e-9).collect();
    assert!(corners.len() == 2 && corners.iter().all(|angle| *angle > 1.0), "{corners:?}");
    let (first, last) = (pieces[0].curve, pieces[pieces.len() - 1].curve);
    let closing = last.tangent_at(last.length()).cross(first.tangent_at(0.0)).length();
    assert!(closing < 1e-9, "{closing}");
}

/// The rows of `tools/surfacing.py`: 1,000 points of a tenth of a millimetre each, in the digits of the program.
/// The least number is that of the surface it is computed from, every row by itself.
#[test]
fn a_surfacing_program_row_by_row() {
    let z = |row: f64, x: f64| 0.6 * (0.3 * x).sin() + 0.3 * (0.11 * x + 0.05 * row).cos();
    let derivatives = |row: f64, x: f64| {
        let phase = 0.11 * x + 0.05 * row;
        let slope = 0.18 * (0.3 * x).cos() - 0.033 * phase.sin();
        let bend = -0.054 * (0.3 * x).sin() - 0.003_63 * phase.cos();
        let third = -0.016_2 * (0.3 * x).cos() + 0.000_399_3 * phase.sin();
        [[1.0, slope], [0.0, bend], [0.0, third]]
    };
    for (tolerance, most) in [(0.01, 1.1), (0.002, 1.1)] {
        let (mut arcs, mut least) = (0, 0.0);
        for row in 0..20 {
            let points: Vec<Vec3> = (0..1000)
                .map(|i| 0.1 * f64::from(if row % 2 == 0 { i } else { 999 - i }))
                .map(|x| {
                    Vec3::new(x, 0.1 * f64::from(row), (z(f64::from(row), x) * 1e4).round() / 1e4)
                })
                .collect();
            let pieces = fit_path(&points, &FitOptions::within(tolerance)).unwrap();
            assert!(is_joined(&points, &pieces) && worst(&pieces) <= tolerance);
            assert!(largest_step(&pieces, false) <= 1e-7, "row {row}");
            if row == 7 {
                assert!(apart(&points, &pieces) <= worst(&pieces) + 1e-9);
            }
            arcs += pieces.len();
            least += asymptotic(
                (0.0, 99.9),
                |x| derivatives(f64::from(row), x),
                72.0 * 3f64.sqrt(),
                tolerance,
            );
        }
        println!("{tolerance} mm: {arcs} arcs in 20 rows, asymptotically {least:.1}");
        assert!(f64::from(arcs as u32) <= most * least, "{arcs} arcs, {least} is the least");
    }
}

#[test]
fn a_circle_of_223_chords_is_one_arc() {
    let circle = Arc::new(Plane::Xy.frame(), 10.0, TAU, 0.0);
    let points: Vec<Vec3> = circle.chords(0.001, Placement::Inscribed).unwrap().collect();
    assert_eq!(points.len(), 224);
    let closed: Vec<Vec3> = points[..223].iter().chain(points.first()).copied().collect();
    let pieces = fit_path(&closed, &FitOptions::within(0.001)).unwrap();
    let [FitPiece { curve: Curve::Arc(arc), .. }] = pieces[..] else { panic!("{pieces:?}") };
    assert!((arc.radius - 10.0).abs() < 1e-9 && (arc.sweep - TAU).abs() < 1e-12);
    // With the digits of a program it is two at most.
    let rounded = |p: &Vec3| Vec3::new((p.x * 1e3).round() / 1e3, (p.y * 1e3).round() / 1e3, 0.0);
    let rough: Vec<Vec3> = closed.iter().map(rounded).collect();
    let pieces = fit_path(&rough, &FitOptions::within(0.002)).unwrap();
    assert!(pieces.len() <= 2, "{pieces:?}");
}

#[test]
fn a_spiral_of_short_lines() {
    // r = 2 + θ over six turns.
    let at = |theta: f64| Vec3::new((2.0 + theta) * theta.cos(), (2.0 + theta) * theta.sin(), 0.0);
    let points: Vec<Vec3> = (0..=2000).map(|i| at(6.0 * TAU * f64::from(i) / 2000.0)).collect();
    let derivatives = |t: f64| {
        let (sin, cos) = t.sin_cos();
        let r = 2.0 + t;
        [
            [cos - r * sin, sin + r * cos],
            [-2.0 * sin - r * cos, 2.0 * cos - r * sin],
            [-3.0 * cos + r * sin, -3.0 * sin - r * cos],
        ]
    };
    for tolerance in [0.05, 0.01, 0.005] {
        let least = asymptotic((0.0, 6.0 * TAU), derivatives, 72.0 * 3f64.sqrt(), tolerance);
        let measure = FitMeasure::Points;
        let pieces =
            fit_path(&points, &FitOptions { measure, ..FitOptions::within(tolerance) }).unwrap();
        let from_points = points.iter().map(|point| {
            pieces.iter().map(|piece| piece.curve.nearest(*point).distance).fold(f64::MAX, f64::min)
        });
        assert!(from_points.fold(0.0, f64::max) <= tolerance);
        println!("{tolerance} mm: {} tangent arcs, asymptotically {least:.1}", pieces.len());
        assert_eq!(kinks(&pieces, 1.0), 0);
        assert!(pieces.len() as f64 <= 1.25 * least + 2.0);
    }
}

#[test]
fn a_helix_and_arcs_in_every_plane() {
    for plane in [Plane::Xy, Plane::Zx, Plane::Yz] {
        let helix = Arc::new(plane.frame(), 10.0, 4.0, 5.0);
        let points: Vec<Vec3> = helix.chords(0.0005, Placement::Inscribed).unwrap().collect();
        let options = FitOptions { plane: Some(plane), ..FitOptions::within(0.005) };
        let pieces = fit_path(&points, &options).unwrap();
        let [FitPiece { curve: Curve::Arc(arc), .. }] = pieces[..] else { panic!("{pieces:?}") };
        assert!((arc.rise - 5.0).abs() < 1e-9 && (arc.sweep - 4.0).abs() < 1e-3);
        assert!(apart(&points, &pieces) <= worst(&pieces) + 1e-9);
        let flat = Arc::new(plane.frame(), 10.0, -2.0, 0.0);
        let points: Vec<Vec3> = flat.chords(0.0005, Placement::Inscribed).unwrap().collect();
        let pieces = fit_path(&points, &FitOptions::within(0.005)).unwrap();
        assert!(pieces.len() == 1 && pieces[0].plane == plane, "{pieces:?}");
    }
}

/// Four lines and four arcs, as they were drawn, from the chords of it.
#[test]
fn a_rounded_rectangle_keeps_its_lines() {
    let mut points = Vec::new();
    let corners = [(40.0, 20.0, 0.0), (-40.0, 20.0, 0.5), (-40.0, -20.0, 1.0), (40.0, -20.0, 1.5)];
    for (x, y, quarter) in corners {
        for step in 0..=60 {
            let angle = PI * (quarter + 0.5 * f64::from(step) / 60.0);
            points.push(Vec3::new(x + 8.0 * angle.cos(), y + 8.0 * angle.sin(), 0.0));
        }
    }
    points.push(points[0]);
    let pieces = fit_path(&points, &FitOptions::within(0.005)).unwrap();
    assert_eq!(pieces.len(), 8, "{pieces:?}");
    assert_eq!(kinks(&pieces, 1.0), 0);
    let straight: Vec<f64> = pieces
        .iter()
        .filter(|piece| matches!(piece.curve, Curve::Line(_)))
        .map(|piece| piece.curve.length())
        .collect();
    assert!(straight.len() == 4 && straight.iter().all(|length| *length > 39.5), "{straight:?}");
}

#[test]
fn corners_stay_where_they_are() {
    let square: Vec<Vec3> = [(0.0, 0.0), (10.0, 0.0), (10.0, 10.0), (0.0, 10.0), (0.0, 0.0)]
        .map(|(x, y)| Vec3::new(x, y, 0.0))
        .to_vec();
    let pieces = fit_path(&square, &FitOptions::within(1.0)).unwrap();
    assert_eq!(pieces.len(), 4);
    assert!(pieces.iter().zip(&square).all(|(piece, corner)| piece.curve.start() == *corner));
    assert_eq!(simplify(&square, 1.0).unwrap(), [0, 1, 2, 3, 4]);
}

#[test]
fn odd_points_are_answered() {
    let options = FitOptions::within(0.01);
    let same = [Vec3::X; 5];
    assert!(fit_path(&same, &options).unwrap().is_empty());
    assert!(fit_path(&[], &options).unwrap().is_empty());
    assert_eq!(simplify(&[], 0.01).unwrap(), []);
    assert!(fit_path(&[Vec3::new(f64::NAN, 0.0, 0.0)], &options).is_err());
    assert!(fit_path(&same, &FitOptions::within(0.0)).is_err());
    let back = [Vec3::ZERO, Vec3::X, Vec3::ZERO, Vec3::X];
    assert_eq!(fit_path(&back, &options).unwrap().len(), 3);
}

/// What no control takes as an arc is lines; what it does, arcs.
#[test]
fn no_arc_is_larger_than_the_largest_radius() {
    for (radius, is_lines) in [(15_000.0, true), (9_000.0, false)] {
        let arc = Arc::new(Plane::Xy.frame(), radius, 400.0 / radius, 0.0);
        let points: Vec<Vec3> = (0..=400).map(|i| arc.point_at(f64::from(i))).collect();
        let pieces = fit_path(&points, &FitOptions::within(0.01)).unwrap();
        assert!(is_joined(&points, &pieces) && worst(&pieces) <= 0.01);
        let lines = pieces.iter().filter(|piece| matches!(piece.curve, Curve::Line(_))).count();
        assert!(pieces.len() <= 12, "{pieces:?}");
        assert_eq!(lines, if is_lines { pieces.len() } else { 0 }, "{pieces:?}");
        if !is_lines {
            assert_eq!(pieces.len(), 1);
        }
    }
    // Flatter and flatter: the radius grows from 1 m beyond all bounds.
    let points: Vec<Vec3> = (0..=2000)
        .map(|i| 0.2 * f64::from(i))
        .map(|x| Vec3::new(x, (x - 200.0).powi(3) / 2.4e5, 0.0))
        .collect();
    let pieces = fit_path(&points, &FitOptions::within(0.002)).unwrap();
    assert!(is_joined(&points, &pieces) && worst(&pieces) <= 0.002);
    for piece in &pieces {
        assert!(!matches!(piece.curve, Curve::Arc(arc) if arc.radius > 10_000.0), "{piece:?}");
    }
    assert!(largest_step(&pieces, false) < 1e-7, "{}", largest_step(&pieces, false));
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(60) })]

    /// Whatever the points, the new path is joined, within the tolerance by a look that knows nothing of
    /// how it was found, and corners are the only turns.
    #[test]
    fn any_points(
        steps in prop::collection::vec((0.01f64..1.0, -0.7f64..0.7, -0.05f64..0.05), 3..120),
        tolerance in 0.002f64..0.1,
        smooth in prop::bool::ANY,
        plunges in prop::bool::ANY,
        closed in prop::bool::ANY,
    ) {
        let (mut at, mut heading, mut bend) = (Vec3::ZERO, 0.0f64, 0.0f64);
        let mut points = vec![at];
        for (length, turn, rise) in steps {
            bend = if smooth { (bend + 0.1 * turn).clamp(-0.3, 0.3) } else { turn };
            heading += bend;
            // Some moves are none in the plane.
            let flat = if plunges && rise > 0.04 { 0.0 } else { length };
            let height = if smooth && !plunges { 0.0 } else { rise * length };
            at += Vec3::new(heading.cos() * flat, heading.sin() * flat, height);
            points.push(at);
        }
        if closed {
            points.push(points[0]);
        }
        let pieces = fit_path(&points, &FitOptions::within(tolerance)).unwrap();
        prop_assert!(is_joined(&points, &pieces));
        prop_assert!(worst(&pieces) <= tolerance * (1.0 + 1e-12));
        prop_assert!(apart(&points, &pieces) <= worst(&pieces) + 1e-9);
        prop_assert!(pieces.len() < points.len());
        let kept = simplify(&points, tolerance).unwrap();
        prop_assert_eq!((kept[0], kept[kept.len() - 1]), (0, points.len() - 1));
        for pair in kept.windows(2) {
            let (a, b) = (points[pair[0]], points[pair[1]]);
            let chord = b - a;
            for point in &points[pair[0]..=pair[1]] {
                let t = ((*point - a).dot(chord) / chord.length_squared()).clamp(0.0, 1.0);
                prop_assert!(point.distance(a + chord * t) <= tolerance * (1.0 + 1e-12));
            }
        }
    }
}

/// Prints times: `cargo test --release --test fitting -- --ignored --nocapture`.
#[test]
#[ignore = "prints how long a million points take, and checks nothing"]
#[allow(clippy::disallowed_methods)]
fn a_million_points() {
    let wave = |i: i32| {
        let t = f64::from(i) * 1e-3;
        Vec3::new(20.0 * t, 8.0 * t.sin() + 3.0 * (2.7 * t).cos(), 0.0)
    };
    let rounded = |p: Vec3| Vec3::new((p.x * 1e4).round() / 1e4, (p.y * 1e4).round() / 1e4, 0.0);
    let points: Vec<Vec3> = (0..1_000_000).map(|i| rounded(wave(i))).collect();
    for tolerance in [0.01, 0.002] {
        let start = std::time::Instant::now();
        let pieces = fit_path(&points, &FitOptions::within(tolerance)).unwrap();
        let fitted = start.elapsed();
        let kinks = kinks(&pieces, 1.0);
        let any =
            fit_path(&points, &FitOptions { tangent: false, ..FitOptions::within(tolerance) });
        let kept = simplify(&points, tolerance).unwrap();
        println!(
            "{tolerance} mm: {} pieces in {fitted:?}, {kinks} joints not tangent; {} not tangent; {} chords",
            pieces.len(),
            any.unwrap().len(),
            kept.len(),
        );
    }
}
