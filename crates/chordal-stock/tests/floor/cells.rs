//! Bounds over cells against columns in them.

use chordal_geometry::{Arc, Frame, Vec3};
use chordal_stock::floor::merge;
use chordal_stock::{CutterProfile, CutterSweep, RemovedSpan};

use crate::moves::{self, KINDS, Kind, Random, SHAPES, Shape};

const GAP: f64 = 1e-4;

fn rounds() -> u64 {
    option_env!("CHORDAL_ROUNDS").and_then(|count| count.parse().ok()).unwrap_or(40)
}

/// Whether all of some spans is within others.
fn within(inner: &[RemovedSpan], outer: &[RemovedSpan]) -> bool {
    inner
        .iter()
        .all(|span| outer.iter().any(|other| other.floor <= span.floor && span.top <= other.top))
}

fn merged(mut spans: Vec<RemovedSpan>) -> Vec<RemovedSpan> {
    merge(&mut spans);
    spans
}

fn check(
    sweep: &CutterSweep,
    middle: [f64; 2],
    side: f64,
    random: &mut Random,
    what: &str,
) -> bool {
    const COLUMNS: u64 = 12;
    let bounds = sweep.cell_floor(middle, side);
    let (mut surely, mut maybe) = (Vec::new(), Vec::new());
    sweep.cell_spans(middle, side, &mut surely, &mut maybe);
    let (surely, maybe) = (merged(surely), merged(maybe));
    for column in 0..COLUMNS {
        // Corners first.
        let off = [0, 1].map(|axis| match column {
            0..4 => (((column >> axis) & 1) as f64 - 0.5) * side,
            _ => random.between(-0.5, 0.5) * side,
        });
        let place = [middle[0] + off[0], middle[1] + off[1]];
        let low = sweep.lowest(place);
        let (least, most) =
            low.map_or((f64::INFINITY, f64::INFINITY), |low| (low.lower, low.upper));
        assert!(bounds.lower <= most, "{place:?} {low:?} {bounds:?} {what}");
        assert!(bounds.upper >= least, "{place:?} {low:?} {bounds:?} {what}");
        let mut spans = Vec::new();
        sweep.spans(place, &mut spans);
        // Where a span is known to the gap only, so is what it may be.
        let shrink = |by: f64| {
            spans
                .iter()
                .map(|span| RemovedSpan { floor: span.floor + by, top: span.top - by })
                .collect()
        };
        let (whole, least): (Vec<RemovedSpan>, Vec<RemovedSpan>) = (shrink(-GAP), shrink(0.0));
        assert!(within(&surely, &merged(whole)), "{place:?} {spans:?} {surely:?} {what}");
        assert!(within(&merged(least), &maybe), "{place:?} {spans:?} {maybe:?} {what}");
    }
    bounds.upper < f64::INFINITY
}

#[test]
fn no_column_of_a_cell_is_outside_its_bounds() {
    for kind in KINDS {
        let mut reached = 0;
        for (number, shape) in SHAPES.into_iter().enumerate() {
            let mut random = Random::new(0xce11 ^ ((kind as u64) << 8) ^ number as u64);
            for _ in 0..rounds() {
                let cutter = moves::cutter(shape, &mut random);
                let cutter =
                    if random.below(2) == 0 { cutter } else { cutter.with_flutes(Some(30.0)) };
                let curve = moves::curve(kind, &mut random);
                let middle = moves::place(&curve, cutter.radius(), &mut random);
                let side = random.between(0.01, 0.5);
                let what = format!("{cutter:?} {curve:?} {middle:?} {side}");
                let sweep = CutterSweep::new(&cutter, &curve, GAP);
                reached += u64::from(check(&sweep, middle, side, &mut random, &what));

                let cutter = moves::undercut(&mut random);
                let middle = moves::place(&curve, cutter.radius(), &mut random);
                let what = format!("{cutter:?} {curve:?} {middle:?} {side}");
                let sweep = CutterSweep::of_undercut(&cutter, &curve, GAP);
                check(&sweep, middle, side, &mut random, &what);
            }
        }
        println!("{kind:?}: {reached} cells are surely reached");
        assert!(reached > rounds());
    }
}

/// The mean gap of the bounds over cells that are surely reached.
fn mean_gap(kind: Kind, shape: Shape, side: f64) -> f64 {
    let mut random = Random::new(7);
    let (mut sum, mut count) = (0.0, 0);
    for _ in 0..400 {
        let cutter = moves::cutter(shape, &mut random);
        let curve = moves::curve(kind, &mut random);
        let middle = moves::place(&curve, 0.7 * cutter.radius(), &mut random);
        let bounds = CutterSweep::new(&cutter, &curve, 1e-6).cell_floor(middle, side);
        // The same cells for all sides: those that a large one reaches.
        if CutterSweep::new(&cutter, &curve, 1e-6).cell_floor(middle, 0.25).upper < f64::INFINITY {
            sum += bounds.upper - bounds.lower;
            count += 1;
        }
    }
    assert!(count > 100);
    sum / f64::from(count)
}

#[test]
fn bounds_close_with_the_side_of_a_cell() {
    for (kind, shape) in [
        (Kind::Line, Shape::Ball),
        (Kind::Line, Shape::Bull),
        (Kind::Line, Shape::Outline),
        (Kind::Arc, Shape::Ball),
        (Kind::Upright, Shape::Ball),
    ] {
        let gaps = [0.2, 0.1, 0.05].map(|side| mean_gap(kind, shape, side));
        println!("{kind:?} {shape:?}: mean gap {gaps:.4?} mm on sides of 0.2, 0.1, 0.05 mm");
        assert!(gaps[1] < 0.7 * gaps[0] && gaps[2] < 0.7 * gaps[1], "{gaps:?}");
    }
}

/// The end of a window on a hill lies on the rim of the cutter, which is pushed outwards by half the diagonal of this cell: less
/// the push again it is beyond the rim by rounding, and was not counted.
#[test]
fn the_rim_of_a_pushed_cutter_counts() {
    let flat = CutterProfile::flat(3.76017863078379).unwrap();
    let (sine, cosine) = libm::sincos(0.2490610411948797);
    let center = Vec3::new(-15.070943442608073, -4.508585269673651, 6.823557612994016);
    let towards = Vec3::Z * cosine + Vec3::X * sine;
    let frame = Frame::from_normal(center, Vec3::Y, towards).unwrap();
    let hill = Arc::new(frame, 10.363389637542303, -0.7586677991447726, 0.0).into();
    let sweep = CutterSweep::new(&flat, &hill, 1e-6);
    let (middle, side) = ([-17.242791246112418, -5.6651598581193126], 0.9790640104599871);
    let floor = sweep.floor([-17.73232325085288, -5.908649322239445]).unwrap();
    let bounds = sweep.cell_floor(middle, side);
    assert!(bounds.lower <= floor && floor <= bounds.upper, "{floor} {bounds:?}");
}
