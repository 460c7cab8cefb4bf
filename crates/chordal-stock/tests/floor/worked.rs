//! Cases by hand.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use chordal_geometry::{Arc, Curve, Frame, Line, SplinePiece, Vec3};
use chordal_stock::floor::{LowestLocation, floor, merge, spans};
use chordal_stock::{CutterProfile, CutterSweep, RemovedSpan, Undercut};

/// Half a unit of the sixth digit.
const DIGITS: f64 = 5e-7;
const GAP: f64 = 1e-9;

fn line(from: [f64; 3], to: [f64; 3]) -> Curve {
    Line::new(Vec3::from_array(from), Vec3::from_array(to)).into()
}

/// An arc about Y (as Z and X turn: from Z to X), or about −Y; starts at an angle θ from X towards Z.
fn upright(center: [f64; 2], radius: f64, from: f64, sweep: f64) -> Curve {
    let (sine, cosine) = libm::sincos(from);
    let u = Vec3::new(cosine, 0.0, sine);
    // Turning about −Y takes X to Z.
    let w = -Vec3::Y;
    let origin = Vec3::new(center[0], 0.0, center[1]);
    Arc::new(Frame { origin, u, v: w.cross(u), w }, radius, sweep, 0.0).into()
}

#[test]
fn a_ball_on_a_ramp() {
    let slope = line([0.0, 0.0, 0.0], [60.0, 0.0, -6.0]);
    let ball = CutterProfile::ball(10.0).unwrap();
    let off = floor(&ball, &slope, [30.0, 0.0], GAP).unwrap() + 3.0;
    assert!((off + 0.024_938).abs() < DIGITS);
    assert!((off - 5.0 * (1.0 - 1.01_f64.sqrt())).abs() < 1e-14);
}

#[test]
fn a_bull_on_a_ramp() {
    let slope = line([-20.0, 0.0, 10.0], [20.0, 0.0, -10.0]);
    let bull = CutterProfile::bull(10.0, 2.0).unwrap();
    for (aside, expected) in [(0.0, -1.736_068), (2.0, -1.464_102), (4.0, -0.353_995)] {
        let low = CutterSweep::new(&bull, &slope, GAP).lowest([0.0, aside]).unwrap();
        assert!((low.upper - expected).abs() < DIGITS, "{aside}: {low:?}");
        assert_eq!((low.at, low.lower), (LowestLocation::Between, low.upper));
    }
    // It touches 3.894427 ahead: a move that ends before is lowest at its end.
    let at = |end: f64| {
        let slope = line([-20.0, 0.0, 10.0], [end, 0.0, -0.5 * end]);
        CutterSweep::new(&bull, &slope, GAP).lowest([0.0, 0.0]).unwrap().at
    };
    assert_eq!((at(3.894_426), at(3.894_429)), (LowestLocation::End, LowestLocation::Between));
}

#[test]
fn a_ball_on_a_helix() {
    // In mid sweep, ψ = 0 of the column at D = 9.
    let frame = Frame::IDENTITY;
    let helix: Curve = Arc::new(frame, 10.0, TAU, 4.0).into();
    let ball = CutterProfile::ball(6.0).unwrap();
    let low = floor(&ball, &helix, [-9.0, 0.0], GAP).unwrap() - 2.0;
    assert!((low - 0.165_211).abs() < DIGITS, "{low}");
    // The nearest point alone says 0.171573; the lag is 1.14382°.
    assert!((ball.height_at(1.0) - 0.171_573).abs() < DIGITS);
    let lag = 1.143_82_f64.to_radians();
    let rho = (1.0 + 4.0 * 90.0 * libm::sin(lag / 2.0).powi(2)).sqrt();
    assert!((low - (ball.height_at(rho) - 4.0 / TAU * lag)).abs() < 1e-9);
}

#[test]
fn hills_and_valleys() {
    let ball = CutterProfile::ball(4.0).unwrap();
    let hill = upright([0.0, -10.0], 10.0, 0.0, PI);
    let low = CutterSweep::new(&ball, &hill, GAP).lowest([3.0, 0.0]).unwrap();
    assert!((low.upper + 0.583_802).abs() < DIGITS);
    assert!((low.upper - (55.0_f64.sqrt() - 8.0)).abs() < 1e-13);
    assert_eq!(low.at, LowestLocation::Between);
    let valley = upright([0.0, 10.0], 10.0, PI, PI);
    let low = floor(&ball, &valley, [3.0, 0.0], GAP).unwrap();
    assert!((low - 0.381_050).abs() < DIGITS);
    assert!((low - (12.0 - 135.0_f64.sqrt())).abs() < 1e-13);
}

#[test]
fn a_t_slot_below_a_slot() {
    let mut out = Vec::new();
    let slot = CutterProfile::flat(10.0).unwrap();
    let under = Undercut::t_slot(20.0, 4.0, 9.0).unwrap();
    let through = |z: f64| line([-10.0, 0.0, z], [110.0, 0.0, z]);
    spans(&slot, &through(-12.0), [50.0, 8.0], GAP, &mut out);
    assert!(out.is_empty());
    CutterSweep::of_undercut(&under, &through(-12.0), GAP).spans([50.0, 8.0], &mut out);
    assert_eq!(out, [RemovedSpan { floor: -12.0, top: -8.0 }]);
    out.clear();
    spans(&slot, &through(-12.0), [50.0, 3.0], GAP, &mut out);
    CutterSweep::of_undercut(&under, &through(-12.0), GAP).spans([50.0, 3.0], &mut out);
    merge(&mut out);
    assert_eq!(out, [RemovedSpan { floor: -12.0, top: f64::INFINITY }]);
}

#[test]
fn turns_of_a_thread() {
    // At D = 14 one turn removes 2.136887 of height.
    let disc = Undercut::thread_disc(20.0, 1.5, 0.0, 12.0).unwrap();
    let thread: Curve = Arc::new(Frame::IDENTITY, 6.0, 4.0 * TAU, 12.0).into();
    let mut out = Vec::new();
    CutterSweep::of_undercut(&disc, &thread, GAP).spans([-14.0, 0.0], &mut out);
    assert_eq!(out.len(), 4);
    for (turn, span) in out.iter().enumerate() {
        assert!((span.top - span.floor - 2.136_887).abs() < DIGITS, "{span:?}");
        let middle = 0.5 * (span.top + span.floor);
        assert!((middle - (3.0 * turn as f64 + 1.5 + 0.75)).abs() < 1e-12);
    }
    // Nearer they meet.
    out.clear();
    CutterSweep::of_undercut(&disc, &thread, GAP).spans([-5.0, 0.0], &mut out);
    merge(&mut out);
    assert_eq!(out.len(), 1);
}

#[test]
fn plunges_and_retracts() {
    let flat = CutterProfile::flat(6.0).unwrap();
    let down = Line::new(Vec3::Z * 5.0, Vec3::Z * -4.0);
    let low = |place: [f64; 2]| CutterSweep::new(&flat, &down.into(), GAP).lowest(place);
    assert_eq!(low([3.0, 0.0]).map(|low| (low.upper, low.at)), Some((-4.0, LowestLocation::End)));
    assert_eq!(low([3.1, 0.0]), None);
    let up = Line::new(down.end, down.start);
    let sweep = CutterSweep::new(&flat, &up.into(), GAP);
    assert_eq!(
        sweep.lowest([1.0, 1.0]).map(|low| (low.upper, low.at)),
        Some((-4.0, LowestLocation::Start))
    );
}

#[test]
fn flutes_end_somewhere() {
    let flat = CutterProfile::flat(6.0).unwrap().with_flutes(Some(12.0));
    let ramp = line([0.0, 0.0, 0.0], [20.0, 0.0, -10.0]);
    let mut out = Vec::new();
    spans(&flat, &ramp, [10.0, 0.0], GAP, &mut out);
    assert_eq!(out, [RemovedSpan { floor: -6.5, top: 8.5 }]);
}

#[test]
fn what_is_above_the_edges_does_not_cut() {
    // Of a countersink of 90° with edges 3 mm high the radius 3 cuts; of a ball R5 with 2 mm the radius 4.
    let vee = CutterProfile::pointed(10.0, 0.0, FRAC_PI_2).unwrap().with_flutes(Some(3.0));
    let ball = CutterProfile::ball(10.0).unwrap().with_flutes(Some(2.0));
    let level = line([-20.0, 0.0, 0.0], [20.0, 0.0, 0.0]);
    for (cutter, reach) in [(vee, 3.0), (ball, 4.0)] {
        let mut out = Vec::new();
        spans(&cutter, &level, [0.0, reach + 1e-9], GAP, &mut out);
        assert_eq!(out, []);
        spans(&cutter, &level, [0.0, reach - 1e-9], GAP, &mut out);
        assert_eq!(out.len(), 1);
        assert!((out[0].top - out[0].floor).abs() < 1e-8, "{out:?}");
    }
    let none = CutterProfile::flat(6.0).unwrap().with_flutes(Some(-1.0));
    assert_eq!(floor(&none, &level, [0.0, 0.0], GAP), None);
}

#[test]
fn a_move_over_a_column_twice() {
    let flat = CutterProfile::flat(4.0).unwrap();
    // Half a turn in a vertical plane, a bottle neck: over x = −8 on its way up and down.
    let loop_ = upright([0.0, 0.0], 10.0, -FRAC_PI_2, -PI);
    let mut out = Vec::new();
    spans(&flat, &loop_, [-5.0, 0.0], GAP, &mut out);
    assert_eq!(out.len(), 2);
    assert!((out[0].floor + 91.0_f64.sqrt()).abs() < 1e-12, "{out:?}");
    assert!((out[1].floor - 51.0_f64.sqrt()).abs() < 1e-12, "{out:?}");
}

#[test]
fn degenerate_curves_are_lines() {
    let ball = CutterProfile::ball(6.0).unwrap();
    let still: Curve = Line::new(Vec3::ZERO, Vec3::ZERO).into();
    assert_eq!(floor(&ball, &still, [0.0, 0.0], GAP), Some(0.0));
    let no_radius: Curve = Arc::new(Frame::IDENTITY, 0.0, TAU, -3.0).into();
    assert_eq!(floor(&ball, &no_radius, [0.0, 0.0], GAP), Some(-3.0));
    let no_sweep: Curve = Arc::new(Frame::IDENTITY, 5.0, 0.0, -3.0).into();
    assert_eq!(floor(&ball, &no_sweep, [5.0, 0.0], GAP), Some(-3.0));
    // On the axis of a helix, and on its own circle.
    let helix: Curve = Arc::new(Frame::IDENTITY, 2.0, TAU, 1.0).into();
    let height = ball.height_at(2.0);
    assert!((floor(&ball, &helix, [0.0, 0.0], GAP).unwrap() - height).abs() < 1e-15);
    assert!(floor(&ball, &helix, [2.0, 0.0], GAP).unwrap() <= 0.0);
    let nowhere = floor(&ball, &line([0.0; 3], [1.0, 0.0, 0.0]), [f64::NAN, 0.0], GAP);
    assert_eq!(nowhere, None);
}

#[test]
fn ends_of_an_arc_count_as_they_were_given() {
    // A control takes radii as equal that are not quite: this one ends 0.01 outside its circle and lower.
    let arc = Arc::new(Frame::IDENTITY, 10.0, FRAC_PI_2, 0.0);
    let arc = Arc { end: Vec3::new(0.0, 10.01, -0.002), ..arc };
    let flat = CutterProfile::flat(4.0).unwrap();
    let sweep = CutterSweep::new(&flat, &arc.into(), GAP);
    let low = sweep.lowest([0.0, 12.005]).unwrap();
    assert_eq!((low.lower, low.upper, low.at), (-0.002, -0.002, LowestLocation::End));
    // So do bounds over a cell about it.
    assert!(sweep.cell_floor([0.0, 12.005], 0.001).lower <= -0.002);
}

#[test]
fn a_path_along_the_rim_is_over_the_column_or_not() {
    // A quarter of a circle as a spline, about the column, with the radius of the cutter: rounding says.
    let [a, b, c] = [[5.0, 0.0], [5.0, 5.0], [0.0, 5.0]].map(|[x, y]| Vec3::new(x, y, 0.0));
    let quarter: Curve = SplinePiece::new(&[a, b, c], &[1.0, 0.5_f64.sqrt(), 1.0]).unwrap().into();
    for make in [CutterProfile::flat, CutterProfile::ball] {
        let cutter = make(10.0).unwrap();
        let sweep = CutterSweep::new(&cutter, &quarter, GAP);
        let mut out = Vec::new();
        sweep.spans([0.0, 0.0], &mut out);
        assert_eq!(out.len(), 1);
        // A ball is there at its side; as near as a column that stands aside by what rounding is.
        assert!((out[0].floor - cutter.side()).abs() < 1e-5, "{out:?}");
        assert_eq!(sweep.floor([-1e-6, -1e-6]), None);
    }
}

#[test]
fn a_helix_of_many_turns() {
    let helix: Curve = Arc::new(Frame::IDENTITY, 10.0, 1e5 * TAU, 1e5).into();
    let ball = CutterProfile::ball(6.0).unwrap().with_flutes(Some(10.0));
    let sweep = CutterSweep::new(&ball, &helix, GAP);
    let low = sweep.floor([9.0, 0.0]).unwrap();
    let height = ball.height_at(1.0);
    assert!(low <= height && low > height - 0.01, "{low}");
    let mut out = Vec::new();
    sweep.spans([9.0, 0.0], &mut out);
    assert_eq!(out.len(), 100_001);
    merge(&mut out);
    assert_eq!(out.len(), 1);
}
