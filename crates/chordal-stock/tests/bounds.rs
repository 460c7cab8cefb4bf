//! The two heights of a cell enclose the floor everywhere on it.

mod support;

use chordal_geometry::{Aabb, Arc, Curve, Frame, Line, ParamCurve, Plane, Spiral};
use chordal_stock::{ColumnOptions, ColumnStock, CutterProfile, TipMove};
use support::{BUDGET, Random, cutters, floor, line, path, point, sampled, stock};

/// Random places in cells: the floor of all moves there is between the heights of its cell.
fn encloses(
    stock: &ColumnStock,
    cutter: &CutterProfile,
    moves: &[TipMove],
    random: &mut Random,
    places: u32,
) -> f64 {
    /// The reference never lies below the truth; this much above it by its own steps.
    const REFERENCE: f64 = 1e-6;
    let [columns, rows] = stock.grid().cells();
    let top = stock.grid().bounds().max.z;
    let bottom = stock.grid().bounds().min.z;
    let (mut gaps, mut count) = (0.0, 0.0);
    for _ in 0..places {
        let column = (random.next() * f64::from(columns)) as u32;
        let row = (random.next() * f64::from(rows)) as u32;
        let [low, high] = stock.grid().corners(column, row);
        // Corners and edges of cells too.
        let mut within = |from: f64, to: f64| match random.next() {
            share if share < 0.1 => from,
            share if share < 0.2 => to,
            _ => random.between(from, to),
        };
        let at = [within(low[0], high[0]), within(low[1], high[1])];
        let truth = moves
            .iter()
            .map(|path| floor(cutter, &path.curve, at, 400))
            .fold(top, f64::min)
            .max(bottom);
        let bounds = stock.heights_at(column, row).unwrap();
        assert!(
            bounds.outer >= truth - REFERENCE,
            "{bounds:?} {truth} {at:?} {cutter:?} {moves:?}"
        );
        assert!(bounds.inner <= truth, "{bounds:?} {truth} {at:?} {cutter:?} {moves:?}");
        if truth < top {
            gaps += bounds.outer - bounds.inner;
            count += 1.0;
        }
    }
    if count > 0.0 { gaps / count } else { 0.0 }
}

fn random_corners(random: &mut Random, count: usize, steep: f64) -> Vec<[f64; 3]> {
    let mut corners = vec![[random.between(-3.0, 3.0), random.between(-3.0, 3.0), -1.5]];
    while corners.len() < count {
        let last = corners[corners.len() - 1];
        let turn = random.between(0.0, std::f64::consts::TAU);
        let length =
            if random.next() < 0.5 { random.between(0.05, 0.4) } else { random.between(0.4, 4.0) };
        let rise = if random.next() < 0.3 { 0.0 } else { random.between(-steep, steep) * length };
        let (sin, cos) = libm::sincos(turn);
        let next = [last[0] + length * cos, last[1] + length * sin, last[2] + rise];
        if next[0].abs() < 4.0 && next[1].abs() < 4.0 && next[2] < 0.5 && next[2] > -3.0 {
            corners.push(next);
        }
    }
    corners
}

/// Paths along the axes through corners and middles of cells, level, steeper than any cutter's flank, and down.
#[test]
fn bounds_hold_for_paths_on_the_grid() {
    const CELL: f64 = 0.125;
    let mut random = Random(0x6e1d);
    for cutter in cutters() {
        for _ in 0..8 {
            let mut corners = vec![[0.0, 0.0, -1.0]];
            while corners.len() < 9 {
                let mut next = corners[corners.len() - 1];
                let axis = (random.next() * 3.0) as usize;
                let step = (random.between(-40.0, 40.0)).round() * CELL / 2.0;
                next[axis] += step;
                if axis < 2 {
                    let slope = [0.0, 0.0, 0.25, 0.5, 1.0, 3.0][(random.next() * 6.0) as usize];
                    next[2] += slope * step;
                }
                if next[0].abs() < 3.0 && next[1].abs() < 3.0 && next[2] < 0.5 && next[2] > -3.0 {
                    corners.push(next);
                }
            }
            let moves = path(&corners);
            let mut stock = stock([-5.0, -5.0, -4.0], [5.0, 5.0, 0.0], CELL);
            stock.cut(&cutter, &moves);
            encloses(&stock, &cutter, &moves, &mut random, 700);
        }
    }
}

#[test]
fn bounds_hold_for_random_paths_of_every_cutter() {
    let mut random = Random(0x5eed);
    for cutter in cutters() {
        for steep in [0.3, 1.0, 3.0] {
            for _ in 0..4 {
                let corners = random_corners(&mut random, 8, steep);
                let moves = path(&corners);
                let mut stock = stock([-5.0, -5.0, -4.0], [5.0, 5.0, 0.0], 0.13);
                stock.cut(&cutter, &moves);
                encloses(&stock, &cutter, &moves, &mut random, 1400);
            }
        }
    }
}

/// Arcs and helices in every plane, spirals, a spline: their pieces allow for how far they lie from the curve.
#[test]
fn bounds_hold_for_curves() {
    let mut random = Random(0xa2c5);
    let mut curves: Vec<Curve> = Vec::new();
    for plane in [Plane::Xy, Plane::Zx, Plane::Yz] {
        for rise in [0.0, 1.4] {
            let sweep = random.between(-5.0, 5.0);
            let origin = point([random.between(-1.0, 1.0), random.between(-1.0, 1.0), -1.2]);
            let frame = Frame { origin, ..plane.frame() };
            curves.push(Arc::new(frame, random.between(0.5, 2.5), sweep, rise).into());
        }
    }
    let frame = |z: f64| Frame { origin: point([0.0, 0.0, z]), ..Plane::Xy.frame() };
    curves.push(Spiral::new(frame(-1.0), (0.5, 3.0), 9.0, -1.0).into());
    for cutter in cutters() {
        for curve in &curves {
            let lead = [curve.start() + point([0.7, 0.4, 0.3]), curve.start()];
            let lead = Curve::Line(Line::new(lead[0], lead[1]));
            let moves = [lead, *curve].map(|curve| TipMove { curve, tag: 0 });
            let mut stock = stock([-5.0, -5.0, -4.0], [5.0, 5.0, 0.0], 0.13);
            stock.cut(&cutter, &moves);
            encloses(&stock, &cutter, &moves, &mut random, 150);
        }
    }
}

/// What a coarsely cut arc leaves to the line after it, the line bounds with the arc's distance.
#[test]
fn bounds_hold_where_coarse_arcs_meet_lines() {
    let mut random = Random(0xc0a25e);
    for cutter in cutters() {
        for _ in 0..12 {
            let origin = point([random.between(-1.0, 1.0), random.between(-1.0, 1.0), -1.2]);
            let plane = if random.next() < 0.5 { Plane::Xy } else { Plane::Zx };
            let frame = Frame { origin, ..plane.frame() };
            let arc = Arc::new(frame, random.between(0.8, 2.0), random.between(-3.0, 3.0), 0.0);
            let end = arc.end();
            let along = arc.tangent_at(arc.length());
            let line = Line::new(end, end + along * random.between(0.2, 1.5));
            let moves = [Curve::Arc(arc), line.into()].map(|curve| TipMove { curve, tag: 0 });
            let (min, max) = (point([-5.0, -5.0, -4.0]), point([5.0, 5.0, 0.0]));
            let options = ColumnOptions { chord_share: 3.0, ..ColumnOptions::new(0.1, BUDGET) };
            let mut stock = ColumnStock::new(Aabb { min, max }, options).unwrap();
            stock.cut(&cutter, &moves);
            encloses(&stock, &cutter, &moves, &mut random, 400);
        }
    }
}

#[test]
fn a_line_cut_anywhere_and_a_path_run_backwards_leave_the_same() {
    let mut random = Random(77);
    for cutter in cutters() {
        let corners = random_corners(&mut random, 12, 1.0);
        let moves = path(&corners);
        let mut plain = stock([-5.0, -5.0, -4.0], [5.0, 5.0, 0.0], 0.1);
        let mut cut_up = plain.clone();
        let mut backwards = plain.clone();
        plain.cut(&cutter, &moves);
        let mut divided = Vec::new();
        for two in corners.windows(2) {
            let at = random.next();
            let middle = [0, 1, 2].map(|n| two[0][n] + at * (two[1][n] - two[0][n]));
            divided.extend([line(two[0], middle), line(middle, two[1])]);
        }
        cut_up.cut(&cutter, &divided);
        let back: Vec<[f64; 3]> = corners.iter().rev().copied().collect();
        backwards.cut(&cutter, &path(&back));
        let [columns, rows] = plain.grid().cells();
        for other in [&cut_up, &backwards] {
            for n in 0..columns * rows {
                let (column, row) = (n % columns, n / columns);
                let (a, b) = (
                    plain.heights_at(column, row).unwrap(),
                    other.heights_at(column, row).unwrap(),
                );
                assert!(a.inner <= b.outer && b.inner <= a.outer, "{a:?} {b:?} {cutter:?}");
            }
            let (a, b) = (plain.left(), other.left());
            assert!(a.least <= b.most && b.least <= a.most);
        }
    }
}

/// Strips leave out what neighbours take: nothing is lost against all columns under every piece by itself.
#[test]
fn strips_are_the_plain_loop() {
    let mut random = Random(4711);
    for cutter in cutters() {
        for steep in [0.2, 1.0, 2.7] {
            let mut corners = random_corners(&mut random, 25, steep);
            // There and back, and down.
            let last = corners[corners.len() - 1];
            let before = corners[corners.len() - 2];
            corners.extend([before, [before[0], before[1], -2.5], last]);
            let moves = path(&corners);
            let mut strips = sampled([-5.0, -5.0, -4.0], [5.0, 5.0, 0.0], 0.1);
            let mut plain = strips.clone();
            strips.cut(&cutter, &moves);
            for path in &moves {
                plain.cut(&cutter, &[*path]);
            }
            let [columns, rows] = plain.grid().cells();
            for n in 0..columns * rows {
                let (a, b) = (
                    strips.heights_at(n % columns, n / columns).unwrap().outer,
                    plain.heights_at(n % columns, n / columns).unwrap().outer,
                );
                assert!((a - b).abs() < 2e-4, "{a} {b} {cutter:?} {corners:?}");
            }
        }
    }
}

#[test]
fn samples_are_the_floor_at_the_middle() {
    let mut random = Random(99);
    for cutter in cutters() {
        let moves = path(&random_corners(&mut random, 6, 0.8));
        let mut stock = sampled([-5.0, -5.0, -4.0], [5.0, 5.0, 0.0], 0.2);
        stock.cut(&cutter, &moves);
        let [columns, rows] = stock.grid().cells();
        for n in 0..columns * rows {
            let [low, high] = stock.grid().corners(n % columns, n / columns);
            let at = [(low[0] + high[0]) / 2.0, (low[1] + high[1]) / 2.0];
            let near = |dx: f64, dy: f64| {
                let floors = moves
                    .iter()
                    .map(|path| floor(&cutter, &path.curve, [at[0] + dx, at[1] + dy], 100));
                floors.fold(0.0, f64::min).max(-4.0)
            };
            let found = stock.heights_at(n % columns, n / columns).unwrap().outer;
            // Rounding is a shift in plan: the height is one of those around.
            let around = [(1e-5, 0.0), (-1e-5, 0.0), (0.0, 1e-5), (0.0, -1e-5), (0.0, 0.0)]
                .map(|(dx, dy)| near(dx, dy));
            let least = around.into_iter().fold(f64::INFINITY, f64::min);
            let most = around.into_iter().fold(f64::NEG_INFINITY, f64::max);
            assert!(
                found >= least - 2e-5 && found <= most + 2e-5,
                "{found} {least} {most} {cutter:?}"
            );
        }
    }
}

#[test]
fn nothing_depends_on_where_the_origin_is() {
    let mut random = Random(3);
    let cutter = CutterProfile::bull(4.0, 0.7).unwrap();
    let corners = random_corners(&mut random, 10, 1.0);
    let far: Vec<[f64; 3]> =
        corners.iter().map(|c| [c[0] + 2000.0, c[1] - 900.0, c[2] + 500.0]).collect();
    let mut here = stock([-5.0, -5.0, -4.0], [5.0, 5.0, 0.0], 0.1);
    let mut there = stock([1995.0, -905.0, 496.0], [2005.0, -895.0, 500.0], 0.1);
    here.cut(&cutter, &path(&corners));
    there.cut(&cutter, &path(&far));
    let (a, b) = (here.left(), there.left());
    assert!((a.least - b.least).abs() < 0.02 && (a.most - b.most).abs() < 0.02, "{a:?} {b:?}");
}
