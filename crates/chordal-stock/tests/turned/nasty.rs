//! Random booleans of regions that share edges, touch, nearly touch, and are hardly there.

use chordal_geometry::Vec2;
use chordal_stock::lathe::{
    CombinedRegion, Insert, InsertShape, LatheStock, OutlineSegment, OverlayError, Region,
    RegionError, SegmentArc, Tip, ToolOutline,
};

use crate::shop::{Random, at, bar, near, point, rounds};

/// Where shapes lie, mm.
const ROOM: f64 = 12.0;

/// A coordinate: on a coarse raster, or moved off it by next to nothing, or anywhere.
fn coordinate(random: &mut Random, sloppy: i32) -> f64 {
    let value = random.between(0.0, ROOM);
    let value = match random.below(4) {
        0 => value,
        1 => (value * 2.0).round() / 2.0,
        _ => value.round(),
    };
    match random.below(3) {
        0 if sloppy < 0 => value + random.between(-1.0, 1.0) * 10_f64.powi(sloppy),
        _ => value,
    }
}

fn place(random: &mut Random, sloppy: i32) -> Vec2 {
    let r = coordinate(random, sloppy).abs();
    at(coordinate(random, sloppy) - 0.5 * ROOM, r)
}

/// Corners joined by lines and arcs. Some cross themselves.
fn loop_of(random: &mut Random, corners: &[Vec2]) -> Vec<OutlineSegment> {
    let count = corners.len();
    (0..count)
        .map(|side| {
            let (from, to) = (corners[side], corners[(side + 1) % count]);
            let half = (from + to) * 0.5;
            let aside = (to - from).turned_left();
            match random.below(4) {
                0 => OutlineSegment::arc(from, to, half + aside * random.between(0.5, 4.0), true),
                1 => OutlineSegment::arc(from, to, half, random.below(2) == 0),
                _ => OutlineSegment::line(from, to),
            }
        })
        .collect()
}

fn shape(random: &mut Random, sloppy: i32) -> Result<Region, RegionError> {
    match random.below(5) {
        0 => {
            let (p, q) = (place(random, sloppy), place(random, sloppy));
            Region::tube(p.b.min(q.b), p.b.max(q.b), p.a, q.a)
        }
        1 => {
            let center = place(random, sloppy);
            let radius = [1.0, 2.0, center.b, random.between(0.1, 3.0)][random.below(4)];
            let right = center + at(radius, 0.0);
            Region::contour(&[vec![OutlineSegment::arc(
                right,
                right,
                center,
                random.below(2) == 0,
            )]])
        }
        2 => {
            let corners = [0; 3].map(|_| place(random, sloppy));
            Region::contour(&[loop_of(random, &corners)])
        }
        3 => {
            // A sliver along a line.
            let (from, to) = (place(random, sloppy), place(random, sloppy));
            let wide = 10_f64.powf(random.between(-9.0, -2.0));
            let aside = (to - from).turned_left() * (wide / 10.0);
            Region::contour(&[loop_of(random, &[from, to, to + aside, from + aside])])
        }
        _ => {
            let count = 3 + random.below(6);
            let corners: Vec<Vec2> = (0..count).map(|_| place(random, sloppy)).collect();
            Region::contour(&[loop_of(random, &corners)])
        }
    }
}

fn combine(random: &mut Random, a: &Region, b: &Region) -> Result<CombinedRegion, OverlayError> {
    match random.below(3) {
        0 => a.difference(b),
        1 => a.union(b),
        _ => a.intersection(b),
    }
}

/// Areas of all results fit together, and points are where they belong.
fn check(random: &mut Random, a: &Region, b: &Region) -> Result<(), OverlayError> {
    let (less, both, either) = (a.difference(b)?, a.intersection(b)?, a.union(b)?);
    let shifted = less.bound.max(both.bound).max(either.bound);
    let off = 1e-8 + 100.0 * shifted;
    near(less.region.area() + both.region.area(), a.area(), off);
    near(either.region.area() + both.region.area(), a.area() + b.area(), off);
    for _ in 0..4 {
        let p = at(random.between(-0.6, 0.6) * ROOM, random.between(0.0, 1.1) * ROOM);
        let (in_a, in_b) = (a.holds(p), b.holds(p));
        let found = [&less, &both, &either].map(|result| result.region.holds(p));
        if found != [in_a && !in_b, in_a && in_b, in_a || in_b] {
            let off = [a, b].map(|region| distance(region, p));
            let most = 1e-8 + 2.0 * shifted;
            assert!(off[0].min(off[1]) < most, "{p:?} {found:?} {in_a} {in_b} {off:?}");
        }
    }
    Ok(())
}

fn distance(region: &Region, p: Vec2) -> f64 {
    let sides = region.outline();
    let off = |side: &OutlineSegment| match side.bend {
        None => {
            let along = side.end - side.start;
            let share = ((p - side.start).dot(along) / along.dot(along)).clamp(0.0, 1.0);
            p.distance(side.start + along * share)
        }
        Some(bend) => (p.distance(bend.center) - bend.radius).abs(),
    };
    sides.iter().flatten().map(off).fold(f64::INFINITY, f64::min)
}

#[test]
fn random_booleans_of_nasty_regions() {
    let rounds = rounds(4000) / 4;
    let (mut done, mut refused, mut unresolved, mut shifted) = (0_u64, 0_u64, 0_u64, 0_u64);
    for round in 0..rounds {
        let mut random =
            Random(0x2545_F491_4F6C_DD1D ^ (round + 1).wrapping_mul(0x9E37_79B9_7F4A_7C15));
        // Exact, or with rounding of some size: none, up to 1e-3 mm.
        let sloppy = [0, -15, -12, -10, -9, -8, -7, -6, -5, -3][random.below(10)];
        let mut regions = Vec::new();
        while regions.len() < 4 {
            match shape(&mut random, sloppy) {
                Ok(region) => regions.push(region),
                Err(_) => refused += 1,
            }
        }
        let mut all = regions[0].clone();
        for other in &regions[1..] {
            done += 3;
            match check(&mut random, &all, other) {
                Ok(()) => {}
                Err(OverlayError) => unresolved += 1,
            }
            done += 1;
            if let Ok(combined) = combine(&mut random, &all, other) {
                shifted += u64::from(combined.bound > 1e-7);
                all = combined.region;
            }
        }
        // Twice the same takes nothing more.
        if let Ok(once) = all.difference(&regions[1]) {
            done += 2;
            if let Ok(twice) = once.region.intersection(&regions[1]) {
                let off = 1e-8 + 100.0 * (once.bound + twice.bound);
                near(twice.region.area(), 0.0, off);
            }
        }
    }
    println!(
        "{done} booleans, {shifted} shifted, {unresolved} unresolved; {refused} outlines refused"
    );
    assert!(unresolved * 1000 <= done, "{unresolved} of {done} are unresolved");
}

/// Passes of a nose along the same lines and arcs again and again, each off by next to nothing.
#[test]
fn the_same_profile_many_times() {
    let rounds = rounds(400);
    let mut bounds = 0;
    for round in 0..rounds {
        let mut random = Random(0x0F1E_2D3C_4B5A_6978 ^ (round + 1).wrapping_mul(0x9E37_79B9_7F4A));
        let sloppy = [0.0, 1e-15, 1e-13, 1e-12, 1e-11, 1e-10, 1e-9, 1e-8, 1e-6][random.below(9)];
        let nose = [0.0, 0.4, 0.8][random.below(3)];
        let insert = Insert {
            nose,
            tip: Tip::new(3).unwrap(),
            flanks: [0.0, std::f64::consts::FRAC_PI_2],
            length: 60.0,
            shape: InsertShape::Parallelogram,
        };
        let tool = insert.outline().unwrap();
        let profile = [
            OutlineSegment::line(at(1.0, 10.0), at(-10.0, 10.0)),
            OutlineSegment::arc(at(-10.0, 10.0), at(-15.0, 15.0), at(-10.0, 15.0), false),
            OutlineSegment::line(at(-15.0, 15.0), at(-15.0, 18.0)),
            OutlineSegment::arc(at(-15.0, 18.0), at(-17.0, 20.0), at(-17.0, 18.0), true),
            OutlineSegment::line(at(-17.0, 20.0), at(-40.0, 20.0)),
            OutlineSegment::line(at(-40.0, 20.0), at(1.0, 20.0)),
        ];
        let mut stock = bar(22.0, -60.0, 0.0);
        let mut areas = Vec::new();
        for _ in 0..4 {
            for side in &profile {
                let off = at(random.between(-1.0, 1.0), random.between(-1.0, 1.0)) * sloppy;
                let bend = side.bend.map(|bend| SegmentArc { center: bend.center + off, ..bend });
                let path =
                    OutlineSegment { start: side.start + off, end: side.end + off, bend, ..*side };
                let pass = stock.cut(&tool, &path).unwrap();
                bounds += u64::from(pass.bound > 0.0);
            }
            areas.push(stock.area());
        }
        for after in &areas[1..] {
            near(*after, areas[0], 200.0 * sloppy + 1e-8);
        }
        // Every pass leaves a few corners at most.
        assert!(stock.edges() < 120, "{} edges", stock.edges());
        near(stock.area(), Region::contour(&stock.region().outline()).unwrap().area(), 1e-7);
    }
    assert!(bounds * 100 <= rounds * 24, "{bounds} passes were not exact");
}

#[test]
fn passes_of_any_numbers_do_not_panic() {
    let rounds = rounds(4000);
    let odd = [
        0.0,
        -0.0,
        1.0,
        -1.0,
        1e-300,
        1e-12,
        1e-6,
        12.0,
        -12.0,
        1e3,
        1e6,
        -1e6,
        1e9,
        f64::MAX,
        f64::MIN_POSITIVE,
        f64::INFINITY,
        f64::NAN,
    ];
    let mut answered = 0;
    for round in 0..rounds {
        let mut random = Random(0xD1B5_4A32_D192_ED03 ^ (round + 1).wrapping_mul(0x1234_5677));
        let mut any = || match random.below(3) {
            0 => odd[random.below(odd.len())],
            1 => random.between(-12.0, 12.0),
            _ => random.between(-12.0, 12.0).round(),
        };
        let (from, to, center) = (at(any(), any()), at(any(), any()), at(any(), any()));
        let numbers = [any(), any(), any(), any()];
        let insert = Insert {
            nose: numbers[0],
            tip: Tip::new(3).unwrap(),
            flanks: [numbers[1], numbers[1] + numbers[2].abs()],
            length: numbers[3],
            shape: InsertShape::Triangle,
        };
        let tools = [
            insert.outline(),
            ToolOutline::polygon(&[from, to, center]),
            ToolOutline::drill(numbers[0], numbers[1], numbers[2]),
            ToolOutline::round(numbers[0], Tip::new(0).unwrap()),
            Ok(point()),
        ];
        let mut stock = bar(10.0, -20.0, 0.0);
        let before = stock.volume();
        for tool in tools.into_iter().flatten() {
            for path in
                [OutlineSegment::line(from, to), OutlineSegment::arc(from, to, center, true)]
            {
                if let Ok(pass) = stock.cut(&tool, &path) {
                    answered += 1;
                    assert!(pass.area >= -1e-6 && pass.volume >= -1e-6, "{pass:?}");
                }
            }
        }
        assert!(stock.volume() <= before + 1e-6);
        let bound = bound_of(&stock);
        assert!(bound.0.a >= -20.1 && bound.1.b <= 10.1 && bound.0.b >= -0.1);
    }
    assert!(answered > rounds / 2, "{answered}");
}

fn bound_of(stock: &LatheStock) -> (Vec2, Vec2) {
    stock.region().bounds().unwrap_or((Vec2::ZERO, Vec2::ZERO))
}
