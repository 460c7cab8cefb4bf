//! Laws that the floor keeps on any move.

use chordal_geometry::{
    Arc, Curve, Frame, Line, ParamCurve, Placement, Spiral, SplinePiece, Transform, Vec3,
};
use chordal_stock::floor::{LowestLocation, LowestPoint};
use chordal_stock::{CutterProfile, CutterSweep};
use proptest::prelude::*;

use crate::moves::{self, KINDS, Random, SHAPES};

const GAP: f64 = 1e-7;
/// Rounding, where a move is not much steeper than 20.
const SAME: f64 = 1e-9;

/// More: `CHORDAL_ROUNDS=20000 cargo test --release -p chordal-stock --test floor properties`.
fn cases() -> u32 {
    option_env!("CHORDAL_ROUNDS").and_then(|count| count.parse().ok()).unwrap_or(600)
}

/// A cutter, a move and a column that is not just at the rim.
fn case(seed: u64, kind: usize, shape: usize) -> (CutterProfile, Curve, [f64; 2]) {
    let mut random = Random::new(seed);
    let cutter = moves::cutter(SHAPES[shape], &mut random);
    let curve = moves::curve(KINDS[kind], &mut random);
    let place = moves::place(&curve, 0.9 * cutter.radius(), &mut random);
    (cutter, curve, place)
}

fn lowest(cutter: &CutterProfile, curve: &Curve, place: [f64; 2]) -> Option<LowestPoint> {
    CutterSweep::new(cutter, curve, GAP).lowest(place)
}

/// Two brackets of one truth overlap.
fn agree(one: Option<LowestPoint>, other: Option<LowestPoint>) -> bool {
    match (one, other) {
        (None, None) => true,
        (Some(a), Some(b)) => a.lower <= b.upper + SAME && b.lower <= a.upper + SAME,
        _ => false,
    }
}

fn least(of: impl IntoIterator<Item = Option<LowestPoint>>) -> Option<LowestPoint> {
    of.into_iter().flatten().reduce(|a, b| LowestPoint {
        lower: a.lower.min(b.lower),
        upper: a.upper.min(b.upper),
        at: LowestLocation::Between,
    })
}

fn swapped(at: LowestLocation) -> LowestLocation {
    match at {
        LowestLocation::Start => LowestLocation::End,
        LowestLocation::Between => LowestLocation::Between,
        LowestLocation::End => LowestLocation::Start,
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: cases(), failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn a_reversed_move_has_the_same_floor(seed: u64, kind in 0..KINDS.len(), shape in 0..SHAPES.len()) {
        let (cutter, curve, place) = case(seed, kind, shape);
        let there = lowest(&cutter, &curve, place);
        let back = lowest(&cutter, &curve.reversed(), place);
        prop_assert!(agree(there, back), "{there:?} {back:?}");
        if let (Some(there), Some(back)) = (there, back) {
            // Where both ends are as low it is the end, both ways.
            prop_assert!(back.at == swapped(there.at) || back.at == there.at, "{there:?} {back:?}");
        }
    }

    #[test]
    fn a_move_that_is_split_has_the_same_floor(
        seed: u64, kind in 0..KINDS.len(), shape in 0..SHAPES.len(), share in 0.0..1.0,
    ) {
        let (cutter, curve, place) = case(seed, kind, shape);
        let whole = lowest(&cutter, &curve, place);
        let (before, after) = curve.split_at(share * curve.length());
        let parts = [before, after].map(|part| lowest(&cutter, &part, place));
        let both = least(parts);
        prop_assert!(agree(whole, both), "{whole:?} {both:?}");
        // What is left to a neighbour is there.
        if let [Some(first), _] = parts && first.at == LowestLocation::End {
            let after = parts[1].map_or(f64::INFINITY, |low| low.upper);
            prop_assert!(after <= first.upper + GAP, "{parts:?}");
        }
    }

    #[test]
    fn turned_mirrored_and_in_inches_it_is_the_same(
        seed: u64, kind in 0..KINDS.len(), shape in 0..SHAPES.len(),
    ) {
        let (cutter, curve, place) = case(seed, kind, shape);
        let here = lowest(&cutter, &curve, place);
        let turn = Transform::rotation_about(Vec3::ZERO, Vec3::Z, std::f64::consts::FRAC_PI_2);
        for by in [
            turn,
            Transform::mirror(Vec3::X, Vec3::ZERO),
            Transform::mirror(Vec3::Y, Vec3::X),
            Transform::translation(Vec3::new(1200.0, -3400.0, 0.0)),
        ] {
            let moved = by.apply_point(Vec3::new(place[0], place[1], 0.0));
            let there = lowest(&cutter, &curve.transformed(&by), [moved.x, moved.y]);
            prop_assert!(agree(here, there), "{here:?} {there:?}");
        }
    }

    #[test]
    fn in_inches_it_is_the_same(seed: u64, kind in 0..KINDS.len(), diameter in 1.0..12.0) {
        const INCH: f64 = 25.4;
        let (_, curve, place) = case(seed, kind, 0);
        let small = curve.transformed(&Transform::scale(1.0 / INCH).unwrap());
        for make in [CutterProfile::flat, CutterProfile::ball] {
            let here = lowest(&make(diameter).unwrap(), &curve, place);
            let there = lowest(&make(diameter / INCH).unwrap(), &small, place.map(|x| x / INCH));
            let there = there.map(|low| {
                LowestPoint { lower: low.lower * INCH, upper: low.upper * INCH, at: low.at }
            });
            // At the rim it is for rounding to say.
            if here.is_some() && there.is_some() {
                prop_assert!(agree(here, there), "{here:?} {there:?}");
            }
        }
    }

    #[test]
    fn odd_numbers_give_no_panic(seed: u64, shape in 0..SHAPES.len()) {
        let mut random = Random::new(seed);
        let cutter = moves::cutter(SHAPES[shape], &mut random);
        const ODD: [f64; 10] =
            [0.0, -0.0, 1.0, -7.5, 1e-300, 1e-12, 1e9, 1e200, f64::INFINITY, f64::NAN];
        let mut number = || ODD[random.below(ODD.len() as u64) as usize];
        let mut point = || Vec3::new(number(), number(), number());
        let frame = Frame { origin: point(), ..Frame::IDENTITY };
        let upright = Frame { origin: point(), u: Vec3::X, v: Vec3::Z, w: -Vec3::Y };
        let line = Line::new(point(), point());
        let points = [point(), point(), point()];
        let [a, b] = [number(), number()];
        let mut curves: Vec<Curve> = vec![
            line.into(),
            Arc::new(frame, a.abs(), 5.0, b).into(),
            Arc::new(upright, a.abs(), 5.0, b).into(),
            Spiral::new(frame, (a.abs(), b.abs()), 5.0, 1.0).into(),
        ];
        curves.extend(SplinePiece::new(&points, &[1.0; 3]).map(Curve::from));
        for curve in curves {
            for place in [[0.0, 0.0], [number(), number()]] {
                let sweep = CutterSweep::new(&cutter, &curve, 1e-3);
                let mut out = Vec::new();
                sweep.spans(place, &mut out);
                let low = sweep.lowest(place);
                prop_assert!(low.is_none_or(|low| low.lower <= low.upper), "{low:?}");
                let cell = sweep.cell_floor(place, 0.1);
                prop_assert!(cell.lower <= cell.upper, "{cell:?}");
            }
        }
    }

    #[test]
    fn strips_leave_the_same_floor(seed: u64, shape in 0..SHAPES.len(), count in 2..6_usize) {
        let mut random = Random::new(seed);
        let cutter = moves::cutter(SHAPES[shape], &mut random);
        let mut last = Vec3::ZERO;
        let chain: Vec<Curve> = (0..count).map(|_| {
            let kind = KINDS[random.below(KINDS.len() as u64) as usize];
            let curve = moves::curve(kind, &mut random);
            let curve = curve.transformed(&Transform::translation(last - curve.start()));
            last = curve.end();
            curve
        }).collect();
        let middle = &chain[random.below(count as u64) as usize];
        let place = moves::place(middle, cutter.radius(), &mut random);
        let lows: Vec<Option<LowestPoint>> =
            chain.iter().map(|curve| lowest(&cutter, curve, place)).collect();
        let at = |k: usize| lows[k].map(|low| low.at);
        // What is lowest at an end is left to the neighbour there, but not by both of them.
        let is_left = |k: usize| match at(k) {
            Some(LowestLocation::End) => k + 1 < count,
            Some(LowestLocation::Start) => k > 0 && at(k - 1) != Some(LowestLocation::End),
            _ => false,
        };
        let plain = least(lows.iter().copied());
        let strips = least((0..count).filter(|k| !is_left(*k)).map(|k| lows[k]));
        prop_assert!(agree(plain, strips), "{plain:?} {strips:?} {lows:?}");
    }

    #[test]
    fn a_curve_is_between_its_chords(
        seed: u64, kind in 2..KINDS.len(), shape in 0..3_usize, sagitta in 0.001..0.05,
    ) {
        let mut random = Random::new(seed);
        let radius = random.between(1.0, 6.0);
        let corner = random.between(0.1, 0.9) * radius;
        // The cutter with all its sides moved outwards; its tip comes to lie lower by as much.
        let moved = |by: f64| match shape {
            0 => CutterProfile::flat(2.0 * (radius + by)),
            1 => CutterProfile::ball(2.0 * (radius + by)),
            _ => CutterProfile::bull(2.0 * (radius + by), corner + by),
        }.unwrap();
        let curve = moves::curve(KINDS[kind], &mut random);
        let place = moves::place(&curve, radius, &mut random);
        let corners: Vec<Vec3> = curve.chords(sagitta, Placement::Inscribed).unwrap().collect();
        let along = |cutter: &CutterProfile| {
            let chord = |pair: &[Vec3]| {
                lowest(cutter, &Line::new(pair[0], pair[1]).into(), place).map(|low| low.upper)
            };
            corners.windows(2).filter_map(chord).fold(f64::INFINITY, f64::min)
        };
        let (below, above) = (along(&moved(sagitta)) - sagitta, along(&moved(-sagitta)) + sagitta);
        let here = lowest(&moved(0.0), &curve, place);
        let (lower, upper) =
            here.map_or((f64::INFINITY, f64::INFINITY), |low| (low.lower, low.upper));
        // The sagitta of the chords is as exact as they are counted.
        prop_assert!(below <= upper + SAME, "{below} {here:?} {above}");
        prop_assert!(lower <= above + SAME, "{below} {here:?} {above}");
    }
}
