//! Tiles in any order and on any number of threads, volumes by tag, counts, memory.
#![allow(clippy::disallowed_methods, reason = "a test is a shell: it has threads")]

mod support;

use chordal_geometry::Aabb;
use chordal_stock::columns::{JobResult, StockTask};
use chordal_stock::{
    ColumnOptions, ColumnStock, CutterProfile, Mode, RevolvedBody, StockError, TipMove,
};
use support::surface::{RADIUS, SIDE, raster};
use support::{BUDGET, line, path, point, stock};

fn plate(resolution: f64) -> ColumnStock {
    stock([0.0, 0.0, -10.0], [SIDE, SIDE, 0.0], resolution)
}

fn by_tag(min: [f64; 3], max: [f64; 3], resolution: f64) -> ColumnStock {
    let options = ColumnOptions { by_tag: true, ..ColumnOptions::new(resolution, BUDGET) };
    ColumnStock::new(Aabb { min: point(min), max: point(max) }, options).unwrap()
}

fn same_bits(a: &ColumnStock, b: &ColumnStock) {
    let bits = |stock: &ColumnStock| -> Vec<[u64; 2]> {
        stock.height_pairs().iter().map(|p| [p.outer.to_bits(), p.inner.to_bits()]).collect()
    };
    assert!(bits(a) == bits(b));
    let volumes = |stock: &ColumnStock| format!("{:?} {:?}", stock.left(), stock.removed_by_tag());
    assert_eq!(volumes(a), volumes(b));
}

#[test]
fn any_order_and_any_number_of_threads_give_the_same_bits() {
    let ball = CutterProfile::ball(2.0 * RADIUS).unwrap();
    let moves: Vec<TipMove> = raster(1.0).into_iter().step_by(3).take(3000).collect();
    let bodies = [RevolvedBody::cylinder(20.0, 4.0)];
    let task = StockTask {
        cutter: Some(&ball),
        bodies: &bodies,
        moves: &moves,
        drop: 0.1,
        ..StockTask::default()
    };
    let mut one = by_tag([0.0, 0.0, -10.0], [SIDE, SIDE, 0.0], 0.2);
    let plan = one.plan(&task);
    let found: Vec<JobResult> = one.jobs(&plan).into_iter().map(|job| job.run()).collect();
    let contacts = plan.contacts(&found);
    let mut back = by_tag([0.0, 0.0, -10.0], [SIDE, SIDE, 0.0], 0.2);
    let found: Vec<JobResult> = back.jobs(&plan).into_iter().rev().map(|job| job.run()).collect();
    assert_eq!(plan.contacts(&found), contacts);
    same_bits(&one, &back);
    for threads in [2, 5] {
        let mut many = by_tag([0.0, 0.0, -10.0], [SIDE, SIDE, 0.0], 0.2);
        let mut jobs = many.jobs(&plan);
        let share = jobs.len().div_ceil(threads);
        let found: Vec<JobResult> = std::thread::scope(|scope| {
            let mut running = Vec::new();
            while !jobs.is_empty() {
                let some = jobs.split_off(jobs.len().saturating_sub(share));
                let run = move || some.into_iter().map(|job| job.run()).collect::<Vec<JobResult>>();
                running.push(scope.spawn(run));
            }
            running.into_iter().flat_map(|thread| thread.join().unwrap()).collect()
        });
        assert_eq!(plan.contacts(&found), contacts);
        same_bits(&one, &many);
    }
}

#[test]
fn few_columns_are_looked_at() {
    let ball = CutterProfile::ball(2.0 * RADIUS).unwrap();
    let all = raster(0.1);
    let moves = &all[60_000..72_000];
    for mode in [Mode::Sampled, Mode::Certified] {
        let bounds = Aabb { min: point([0.0, 0.0, -10.0]), max: point([SIDE, SIDE, 0.0]) };
        let mut stock =
            ColumnStock::new(bounds, ColumnOptions { mode, ..ColumnOptions::new(0.05, BUDGET) })
                .unwrap();
        let counts = stock.cut(&ball, moves);
        let each = counts.columns / moves.len() as u64;
        assert!(each <= 1000, "{each} columns a move");
        assert!(stock.bytes() <= 10 * 1216 * 1216, "{}", stock.bytes());
    }
}

#[test]
fn volumes_by_tag() {
    let flat = CutterProfile::flat(10.0).unwrap();
    let tagged = |tag: u32, path: TipMove| TipMove { tag, ..path };
    let along = line([-20.0, 30.0, -5.0], [120.0, 30.0, -5.0]);
    let across = line([50.0, -20.0, -5.0], [50.0, 80.0, -5.0]);
    for separate in [false, true] {
        let mut block = by_tag([0.0, 0.0, -20.0], [100.0, 60.0, 0.0], 0.1);
        let moves = [tagged(7, along), tagged(3, across), tagged(7, along)];
        if separate {
            for path in moves {
                block.cut(&flat, &[path]);
            }
        } else {
            block.cut(&flat, &moves);
        }
        let by_tag = block.removed_by_tag();
        let truths = [(3, 2500.0), (7, 5000.0)];
        for ((tag, amount), (of, truth)) in by_tag.iter().zip(truths) {
            assert_eq!(*tag, of);
            assert!(amount.least <= truth && truth <= amount.most, "{amount:?} {truth}");
            assert!(amount.most - amount.least < 0.12 * truth, "{amount:?}");
        }
        let all = block.removed();
        assert!(all.least <= 7500.0 && 7500.0 <= all.most && all.most - all.least < 0.05 * 7500.0);
        let left = block.left();
        assert!(left.least <= 112_500.0 && 112_500.0 <= left.most);
    }
}

#[test]
fn finer_columns_agree_with_coarser_ones() {
    let bull = CutterProfile::bull(6.0, 1.0).unwrap();
    let moves = path(&[[2.0, 2.0, -1.0], [9.0, 5.0, -3.0], [4.0, 8.0, -0.5], [4.0, 2.0, -0.5]]);
    let make = |resolution: f64| {
        let mut stock = stock([0.0, 0.0, -5.0], [12.8, 12.8, 0.0], resolution);
        stock.cut(&bull, &moves);
        stock
    };
    let (fine, coarse) = (make(0.1), make(0.2));
    let [columns, rows] = fine.grid().cells();
    for n in 0..columns * rows {
        let (column, row) = (n % columns, n / columns);
        let a = fine.heights_at(column, row).unwrap();
        let b = coarse.heights_at(column / 2, row / 2).unwrap();
        assert!(a.inner <= b.outer && b.inner <= a.outer, "{a:?} {b:?}");
    }
    let (a, b) = (fine.removed(), coarse.removed());
    assert!(a.most - a.least < 0.6 * (b.most - b.least), "{a:?} {b:?}");
}

#[test]
fn a_budget_says_what_fits() {
    let bounds = Aabb { min: point([0.0; 3]), max: point([500.0, 300.0, 20.0]) };
    let budget = 50_000_000;
    let error = ColumnStock::new(bounds, ColumnOptions::new(0.05, budget)).unwrap_err();
    let StockError::TooFine { needed, fits, .. } = error else { panic!("{error}") };
    assert!(needed > 480_000_000 && needed < 540_000_000, "{needed}");
    assert!(fits > 0.15 && fits < 0.18, "{fits}");
    assert!(ColumnStock::new(bounds, ColumnOptions::new(fits, budget)).is_ok());
    assert_eq!(
        error.to_string(),
        format!(
            "at 0.05 mm the stock needs up to {needed} bytes, 50000000 are allowed; at {fits:.3} mm it fits"
        )
    );
    for wrong in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(ColumnStock::new(bounds, ColumnOptions::new(wrong, budget)).is_err());
    }
    let flat = Aabb { max: point([500.0, 300.0, 0.0]), ..bounds };
    assert_eq!(
        ColumnStock::new(flat, ColumnOptions::new(0.1, budget)).unwrap_err(),
        StockError::Empty
    );
}

#[test]
fn a_round_bar_and_cells_over_the_edge() {
    let bounds = Aabb { min: point([-10.0, -10.0, -8.0]), max: point([10.0, 10.0, 0.0]) };
    let bar = ColumnStock::shaped(bounds, ColumnOptions::new(0.13, BUDGET), |low, high| {
        let far = |a: f64, b: f64| a.abs().max(b.abs());
        let near = |a: f64, b: f64| if a * b < 0.0 { 0.0 } else { a.abs().min(b.abs()) };
        let most = libm::hypot(far(low[0], high[0]), far(low[1], high[1]));
        let least = libm::hypot(near(low[0], high[0]), near(low[1], high[1]));
        [if least < 10.0 { 0.0 } else { -8.0 }, if most <= 10.0 { 0.0 } else { -8.0 }]
    })
    .unwrap();
    let truth = 800.0 * std::f64::consts::PI;
    let left = bar.left();
    assert!(left.least < truth && truth < left.most && left.most - left.least < 0.06 * truth);
    // A box that is no multiple of the cell has its own volume.
    let odd = stock([0.0, 0.0, -3.0], [7.7, 5.3, 0.0], 0.25);
    assert!((odd.left().most - 7.7 * 5.3 * 3.0).abs() < 1e-4, "{:?}", odd.left());
}

#[test]
fn nonsense_moves_remove_nothing() {
    let mut block = plate(0.5);
    let before = block.left();
    let flat = CutterProfile::flat(10.0).unwrap();
    let nan = line([f64::NAN, 0.0, 0.0], [1.0, 1.0, -1.0]);
    let far = line([1e9, 1e9, -5.0], [1e9 + 1.0, 1e9, -5.0]);
    let high = line([0.0, 0.0, 20.0], [60.0, 60.0, 1.0]);
    block.cut(&flat, &[nan, far, high]);
    assert_eq!(block.left(), before);
}
