//! The height in the middle of each cell: that of one more stock, which is asked there alone, and between the bounds.

mod support;

use chordal_geometry::{Aabb, Arc, Curve, Frame, Vec3};
use chordal_stock::{ColumnOptions, ColumnStock, CutterProfile, RemovedSpan, TipMove, Undercut};
use support::{BUDGET, Random, cutters, floor, line, path, point, sampled, stock};

const LOW: [f64; 3] = [-5.0, -5.0, -4.0];
const HIGH: [f64; 3] = [5.0, 5.0, 0.0];
const CELL: f64 = 0.125;

fn with_middles(resolution: f64) -> ColumnStock {
    let bounds = Aabb { min: point(LOW), max: point(HIGH) };
    ColumnStock::new(
        bounds,
        ColumnOptions { middles: true, ..ColumnOptions::new(resolution, BUDGET) },
    )
    .unwrap()
}

/// Lines level, up, down and straight down, some of them through corners and middles of cells.
fn random_path(random: &mut Random) -> Vec<TipMove> {
    let mut corners = vec![[0.0, 0.0, -1.0]];
    while corners.len() < 9 {
        let mut next = corners[corners.len() - 1];
        if random.next() < 0.5 {
            let axis = (random.next() * 3.0) as usize;
            next[axis] += random.between(-40.0, 40.0).round() * CELL / 2.0;
        } else {
            next = [random.between(-3.0, 3.0), random.between(-3.0, 3.0), next[2]];
            next[2] += if random.next() < 0.5 { 0.0 } else { random.between(-0.5, 0.5) };
        }
        if next[0].abs() < 3.0 && next[1].abs() < 3.0 && next[2] < 0.5 && next[2] > -3.0 {
            corners.push(next);
        }
    }
    path(&corners)
}

/// How far the height in the middle of a cell is from the floors near it, from the least to the largest: rounding decides
/// of a wall that passes so near, and steep flanks make much of little in plan.
fn off_near(cutter: &CutterProfile, moves: &[TipMove], middle: [f64; 2], height: f64) -> f64 {
    /// The contact of a round corner is known to a share of 2⁻¹⁵ of the radius of 2 mm, along the path and across it,
    /// where it begins and where it ends.
    const NEAR: f64 = 2e-4;
    let ways = [[0.0, 0.0], [NEAR, 0.0], [-NEAR, 0.0], [0.0, NEAR], [0.0, -NEAR]];
    let diagonals = [[NEAR, NEAR], [-NEAR, NEAR], [NEAR, -NEAR], [-NEAR, -NEAR]];
    let places = ways.into_iter().chain(diagonals).map(|[x, y]| [middle[0] + x, middle[1] + y]);
    let truth = |at: [f64; 2]| {
        let floors = moves.iter().map(|path| floor(cutter, &path.curve, at, 400));
        floors.fold(HIGH[2], f64::min).max(LOW[2])
    };
    let [low, high] = places
        .map(truth)
        .fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], at| [low.min(at), high.max(at)]);
    (low - height).max(height - high).max(0.0)
}

#[test]
fn the_middle_is_the_floor_there() {
    let mut random = Random(0x3a11);
    for cutter in cutters() {
        for _ in 0..6 {
            let moves = random_path(&mut random);
            let mut own = with_middles(CELL);
            own.cut(&cutter, &moves);
            let mut asked = sampled(LOW, HIGH, CELL);
            asked.cut(&cutter, &moves);
            let mut plain = stock(LOW, HIGH, CELL);
            plain.cut(&cutter, &moves);
            // The bounds are the same with middles and without.
            let pairs = own.height_pairs();
            assert_eq!(pairs, plain.height_pairs());
            let columns = own.grid().cells()[0] as usize;
            let (middles, sampled) = (own.middles(), asked.height_pairs());
            for (index, middle) in middles.iter().enumerate() {
                let pair = pairs[index];
                assert!(pair.inner <= *middle && *middle <= pair.outer, "{middle} {pair:?}");
                if (middle - sampled[index].outer).abs() < 2e-4 {
                    continue;
                }
                let [column, row] = [index % columns, index / columns];
                let at = [column, row].map(|cell| LOW[0] + (cell as f64 + 0.5) * CELL);
                let off = off_near(&cutter, &moves, at, *middle);
                assert!(off < 2e-4, "{middle} {:?} {off} {at:?} {cutter:?}", sampled[index]);
            }
        }
    }
}

/// A disc around an arc, a wall of which passes most cells at its rim: each has all of the level or nothing of it.
#[test]
fn a_round_wall_has_two_levels() {
    let mut own = with_middles(CELL);
    let frame = Frame { origin: Vec3::Z * -1.5, ..Frame::IDENTITY };
    let curve: Curve = Arc::new(frame, 2.0, 5.0, 0.0).into();
    own.cut(&CutterProfile::flat(3.0).unwrap(), &[TipMove { curve, tag: 0 }]);
    let (middles, pairs) = (own.middles(), own.height_pairs());
    let walls = pairs.iter().filter(|pair| pair.outer - pair.inner > 1.0).count();
    assert!(walls > 100, "{walls}");
    for middle in &middles {
        let is_level = [0.0, -1.5].iter().any(|level| (middle - level).abs() < 1e-6);
        assert!(is_level, "{middle}");
    }
}

#[test]
fn gaps_in_the_middle_have_two_levels() {
    let mut own = with_middles(CELL);
    let under = Undercut::t_slot(3.0, 1.0, 1.0).unwrap();
    let moves = [line([-7.0, -3.0, -3.0], [7.0, 2.3, -3.0])];
    own.cut(&CutterProfile::flat(1.5).unwrap(), &moves);
    own.cut_below(&[(0.0, under)], &moves);
    let [columns, rows] = own.grid().cells();
    let (middles, pairs) = (own.middles(), own.height_pairs());
    let (mut gaps, mut walls) = (0, 0);
    for row in 0..rows {
        for column in 0..columns {
            let [surely, maybe] = own.gaps_at(column, row);
            let middle = own.gaps_in_middle(column, row);
            walls += usize::from(surely.len() != maybe.len());
            // What is left of the column, less its gaps.
            let length = |height: f64, gaps: &[RemovedSpan]| {
                height - LOW[2] - gaps.iter().map(|gap| gap.top - gap.floor).sum::<f64>()
            };
            let index = (row * columns + column) as usize;
            let left = length(middles[index], &middle);
            assert!(length(pairs[index].inner, &maybe) <= left + 1e-3, "{column} {row}");
            assert!(left <= length(pairs[index].outer, &surely) + 1e-3, "{column} {row}");
            for gap in middle {
                gaps += 1;
                let is_level = (gap.floor + 3.0).abs() < 1e-3 && (gap.top + 2.0).abs() < 1e-3;
                assert!(is_level, "{gap:?}");
            }
        }
    }
    assert!(gaps > 500 && walls > 100, "{gaps} {walls}");
    // In half a slot's width on either side of the neck's slot.
    let area = f64::from(gaps) * CELL * CELL;
    let length = 10.0 * (14.0_f64.hypot(5.3) / 14.0);
    assert!((area - 1.5 * length).abs() < 0.05 * area, "{area} {length}");
}

/// A round bar: as it begins, a cell is all stock or none.
#[test]
fn stock_begins_with_what_is_in_the_middle_of_its_cells() {
    let bounds = Aabb { min: point(LOW), max: point(HIGH) };
    let options = ColumnOptions { middles: true, ..ColumnOptions::new(0.3, BUDGET) };
    let far = |low: [f64; 2], high: [f64; 2], most: bool| {
        let along = |axis: usize| {
            let ends = [low[axis], high[axis]].map(f64::abs);
            let crosses = low[axis] <= 0.0 && 0.0 <= high[axis];
            match most {
                true => ends[0].max(ends[1]),
                false if crosses => 0.0,
                false => ends[0].min(ends[1]),
            }
        };
        along(0).hypot(along(1))
    };
    let bar = ColumnStock::shaped(bounds, options, |low, high| {
        [false, true].map(|most| if far(low, high, most) < 5.0 { HIGH[2] } else { LOW[2] })
    });
    let bar = bar.unwrap();
    let columns = bar.grid().cells()[0];
    for (index, middle) in bar.middles().into_iter().enumerate() {
        let (column, row) = (index as u32 % columns, index as u32 / columns);
        let [low, high] = bar.grid().corners(column, row);
        let from_axis = (0.5 * (low[0] + high[0])).hypot(0.5 * (low[1] + high[1]));
        let expected = if from_axis < 5.0 { HIGH[2] } else { LOW[2] };
        assert_eq!(middle, expected, "{low:?} {high:?}");
    }
}
