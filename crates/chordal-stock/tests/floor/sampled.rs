//! Random cutters on random moves of every kind against dense sampling.
//!
//! More cases: `CHORDAL_ROUNDS=20000 cargo test --release -p chordal-stock --test floor sampled -- --nocapture`.

use chordal_stock::floor::LowestLocation;
use chordal_stock::{CutterSweep, RemovedSpan};

use crate::moves::{self, KINDS, Kind, Random, SHAPES, Shape};
use crate::sampler;

/// What two closed forms may differ from the samples, mm.
const SAME: f64 = 2e-9;
/// The gap of the bounds where there is no closed form, mm.
const GAP: f64 = 1e-6;

fn rounds() -> u64 {
    option_env!("CHORDAL_ROUNDS").and_then(|count| count.parse().ok()).unwrap_or(60)
}

fn has_closed_form(kind: Kind, shape: Shape) -> bool {
    match kind {
        Kind::Line | Kind::Plunge | Kind::Arc => true,
        Kind::Helix => shape != Shape::Bull,
        Kind::Upright => shape == Shape::Flat || shape == Shape::Ball,
        _ => false,
    }
}

/// How far two heights are apart, as rounding sees it: where the move is steep, a column that stands
/// aside by 1e-15 mm is at another height.
fn check(kind: Kind, shape: Shape) {
    let mut random = Random::new(0x5eed ^ (kind as u64) << 8 ^ (shape as u64));
    let (mut worst, mut widest, mut reached) = (0.0_f64, 0.0_f64, 0);
    for round in 0..rounds() {
        let cutter = moves::cutter(shape, &mut random);
        let flutes = cutter.side() + random.between(0.0, 20.0);
        let cutter = cutter.with_flutes(Some(flutes));
        let curve = moves::curve(kind, &mut random);
        let place = moves::place(&curve, cutter.radius(), &mut random);
        let edges: Vec<f64> = cutter.rings().iter().map(|ring| ring.to).collect();
        let over = sampler::over(&curve, place, &edges, &|r| cutter.height_at(r), &|_| flutes);
        if over.grazes {
            continue;
        }
        let sweep = CutterSweep::new(&cutter, &curve, GAP);
        let lowest = sweep.lowest(place);
        let what =
            || format!("{kind:?} {shape:?} {round}: {lowest:?}\n{cutter:?}\n{curve:?}\n{place:?}");
        assert_eq!(lowest.is_some(), !over.windows.is_empty(), "{}", what());
        let (Some(lowest), Some(floor)) = (lowest, over.floor()) else { continue };
        reached += 1;
        widest = widest.max(lowest.upper - lowest.lower);
        let off = (lowest.lower - floor).max(floor - lowest.upper).max(0.0);
        let off = if has_closed_form(kind, shape) {
            assert_eq!(lowest.lower, lowest.upper, "{}", what());
            (floor - lowest.upper).abs()
        } else {
            off
        };
        worst = worst.max(off);
        assert!(off <= SAME, "off by {off:e}: sampled {floor}, {}", what());
        // Where it is: no end is lower than what is between.
        for (at, share) in [(LowestLocation::Start, 0.0), (LowestLocation::End, 1.0)] {
            if lowest.at == at {
                let p = moves::point(&curve, share);
                let (x, y) = (p.x - place[0], p.y - place[1]);
                let height = p.z + cutter.height_at((x * x + y * y).sqrt());
                assert!((height - lowest.upper).abs() <= 2e-12, "{}", what());
            }
        }
        let mut spans = Vec::new();
        sweep.spans(place, &mut spans);
        compare(&spans, &over.windows, &mut worst, &what);
    }
    println!(
        "{kind:?} {shape:?}: {reached} cases, worst {worst:.1e} mm, widest gap {widest:.1e} mm"
    );
    assert!(reached * 2 > rounds(), "most cases are over the column");
    assert!(widest <= GAP);
}

fn compare(
    spans: &[RemovedSpan],
    windows: &[sampler::Sampled],
    worst: &mut f64,
    what: &dyn Fn() -> String,
) {
    assert_eq!(spans.len(), windows.len(), "{spans:?} {windows:?} {}", what());
    for (span, window) in spans.iter().zip(windows) {
        let (floor, top) = (span.floor - window.floor, window.top - span.top);
        for off in [floor, top] {
            assert!((-SAME..=GAP + SAME).contains(&off), "{spans:?} {windows:?} {}", what());
            *worst = worst.max(-off);
        }
    }
}

macro_rules! every_cutter {
    ($($name:ident $kind:ident)*) => {$(
        #[test]
        fn $name() {
            for shape in SHAPES {
                check(Kind::$kind, shape);
            }
        }
    )*};
}

every_cutter! {
    every_cutter_on_lines Line
    every_cutter_on_plunges Plunge
    every_cutter_on_arcs Arc
    every_cutter_on_helices Helix
    every_cutter_on_upright_arcs Upright
    every_cutter_on_tilted_turns Tilted
    every_cutter_on_upright_helices UprightHelix
    every_cutter_on_spirals Spiral
    every_cutter_on_cones Cone
    every_cutter_on_splines Spline
}

#[test]
fn undercuts_on_every_kind_of_move() {
    for kind in KINDS {
        let mut random = Random::new(0xd15c ^ kind as u64);
        let (mut worst, mut reached) = (0.0_f64, 0);
        for round in 0..rounds() {
            let cutter = moves::undercut(&mut random);
            let curve = moves::curve(kind, &mut random);
            let place = moves::place(&curve, cutter.radius(), &mut random);
            let lower = |r: f64| cutter.lower().height_at(r);
            let upper = |r: f64| cutter.height() - cutter.upper().height_at(r);
            let edges: Vec<f64> = cutter.lower().rings().iter().map(|ring| ring.to).collect();
            let over = sampler::over(&curve, place, &edges, &lower, &upper);
            if over.grazes {
                continue;
            }
            let sweep = CutterSweep::of_undercut(&cutter, &curve, GAP);
            let mut spans = Vec::new();
            sweep.spans(place, &mut spans);
            let what = || format!("{kind:?} {round}\n{cutter:?}\n{curve:?}\n{place:?}");
            compare(&spans, &over.windows, &mut worst, &what);
            if let (Some(top), Some(sampled)) = (sweep.top(place), over.top()) {
                let off = sampled - top;
                assert!((-SAME..=GAP + SAME).contains(&off), "{top} {sampled} {}", what());
                reached += 1;
            }
        }
        println!("{kind:?} undercut: {reached} cases, worst {worst:.1e} mm beyond the gap");
        assert!(reached * 2 > rounds());
    }
}
