//! Undercuts in columns: known volumes, places against dense samples, what is touched in a gap.

mod support;

use std::f64::consts::TAU;

use chordal_geometry::{Aabb, Arc, Curve, Frame, Line, ParamCurve, Vec3};
use chordal_stock::{
    ColumnOptions, ColumnStock, CutterProfile, RemovedSpan, RevolvedBody, StockError, TipMove,
    TouchAnswer, Undercut, VolumeInterval,
};
use support::{BUDGET, Random, line, path, point, stock};

/// One cut of a program.
enum Cut {
    Plain(CutterProfile, Vec<TipMove>),
    Below(Undercut, Vec<TipMove>),
}

fn cut(stock: &mut ColumnStock, cuts: &[Cut]) {
    for each in cuts {
        match each {
            Cut::Plain(cutter, moves) => stock.cut(cutter, moves),
            Cut::Below(undercut, moves) => stock.cut_below(&[(0.0, undercut.clone())], moves),
        };
    }
}

/// What is removed lies about the truth, and nearer to it with finer cells.
fn encloses(truth: f64, make: impl Fn(f64) -> ColumnStock, cuts: &[Cut]) {
    let mut gaps = Vec::new();
    for resolution in [0.4, 0.2, 0.1] {
        let mut stock = make(resolution);
        cut(&mut stock, cuts);
        let removed = stock.removed();
        assert!(
            removed.least <= truth && truth <= removed.most,
            "{removed:?} {truth} {resolution}"
        );
        gaps.push(removed.most - removed.least);
    }
    assert!(gaps[1] < gaps[0] && gaps[2] < 0.4 * gaps[0], "{gaps:?}");
    assert!(gaps[2] < 0.1 * truth, "{gaps:?} {truth}");
}

#[test]
fn a_t_slot_below_a_slot() {
    let plate = |resolution| stock([0.0, -30.0, -20.0], [100.0, 30.0, 0.0], resolution);
    let slot = vec![line([-20.0, 0.0, -12.0], [120.0, 0.0, -12.0])];
    let under = Undercut::t_slot(20.0, 4.0, 9.0).unwrap();
    let cuts = [
        Cut::Plain(CutterProfile::flat(10.0).unwrap(), slot.clone()),
        Cut::Below(under.clone(), slot.clone()),
    ];
    encloses(12.0 * 1000.0 + 4000.0, plate, &cuts);
    // The other way round it is the same.
    let [plain, below] = cuts;
    encloses(12.0 * 1000.0 + 4000.0, plate, &[below, plain]);
    // Beside the slot a roof of 8 mm stands over the gap.
    let mut left = plate(0.2);
    cut(&mut left, &[Cut::Below(under, slot)]);
    let [surely, maybe] = left.gaps_at(250, 190);
    let heights = left.heights_at(250, 190).unwrap();
    assert_eq!((heights.outer, heights.inner, surely.len()), (0.0, 0.0, 1));
    assert!((surely[0].floor + 12.0).abs() < 1e-4 && (surely[0].top + 8.0).abs() < 1e-4);
    assert!(maybe[0].floor <= surely[0].floor && surely[0].top <= maybe[0].top);
}

#[test]
fn a_lollipop_below_a_slot() {
    let plate = |resolution| stock([0.0, -8.0, -12.0], [20.0, 8.0, 0.0], resolution);
    let at = |z: f64| vec![line([-10.0, 0.0, z], [30.0, 0.0, z])];
    let cuts = [
        Cut::Below(Undercut::lollipop(6.0, 3.0).unwrap(), at(-9.0)),
        Cut::Plain(CutterProfile::flat(3.0).unwrap(), at(-6.0)),
    ];
    encloses(20.0 * 37.664_831, plate, &cuts);
}

fn helix(turns: f64, from: f64) -> TipMove {
    let frame = Frame { origin: Vec3::Z * from, ..Frame::IDENTITY };
    let curve: Curve = Arc::new(frame, 6.0, turns * TAU, 3.0 * turns).into();
    TipMove { curve, tag: 0 }
}

/// Three turns of a thread less two, both about the same bore of R13, each known to its bounds.
#[test]
fn turns_of_a_thread() {
    let disc = Undercut::thread_disc(20.0, 1.5, 0.0, 12.0).unwrap();
    let bore = Arc::new(Frame { origin: Vec3::Z * -30.0, ..Frame::IDENTITY }, 8.0, TAU, 0.0);
    let removed = |turns: f64| {
        let mut part = stock([-18.0, -18.0, -30.0], [18.0, 18.0, 0.0], 0.1);
        part.cut(&CutterProfile::flat(10.0).unwrap(), &[TipMove { curve: bore.into(), tag: 0 }]);
        let before = part.left();
        let body = Arc::new(Frame { origin: Vec3::Z * -30.0, ..Frame::IDENTITY }, 3.0, TAU, 0.0);
        part.cut(&CutterProfile::flat(10.0).unwrap(), &[TipMove { curve: body.into(), tag: 0 }]);
        let bored = part.left();
        assert!(bored.most <= before.most);
        part.cut_below(&[(0.0, disc.clone())], &[helix(turns, -25.0)]);
        let threaded = part.left();
        [bored.least - threaded.most, bored.most - threaded.least]
    };
    let [two, three] = [removed(2.0), removed(3.0)];
    let truth = 548.655;
    assert!(three[0] - two[1] <= truth && truth <= three[1] - two[0], "{two:?} {three:?}");
    assert!(three[1] - three[0] < 0.5 * three[1], "{three:?}");
}

/// Whether a place is removed: by the move's poses, and by how much it is inside or outside of them, mm.
fn depth(undercut: &Undercut, curve: &Curve, at: [f64; 3]) -> f64 {
    const PLACES: u32 = 1000;
    let length = curve.length();
    let pose = |n: u32| {
        let tip = curve.point_at(length * f64::from(n) / f64::from(PLACES));
        let rho = libm::hypot(tip.x - at[0], tip.y - at[1]);
        if rho > undercut.radius() {
            return f64::NEG_INFINITY;
        }
        let low = tip.z + undercut.lower().height_at(rho);
        let high = tip.z + undercut.height() - undercut.upper().height_at(rho);
        (at[2] - low).min(high - at[2])
    };
    (0..=PLACES).map(pose).fold(f64::NEG_INFINITY, f64::max)
}

fn random_moves(random: &mut Random) -> Vec<TipMove> {
    let mut at =
        || [random.between(-8.0, 8.0), random.between(-8.0, 8.0), random.between(-9.0, -2.0)];
    let (from, to, center) = (at(), at(), at());
    let frame = Frame { origin: point(center), ..Frame::IDENTITY };
    let arc = Arc::new(frame, 3.0, 5.0, random.between(-3.0, 3.0));
    let upright = Frame::from_normal(point(center), Vec3::X, Vec3::Z).unwrap();
    vec![
        line(from, to),
        TipMove { curve: arc.into(), tag: 0 },
        TipMove { curve: Arc::new(upright, 4.0, 2.0, 0.0).into(), tag: 0 },
    ]
}

#[test]
fn places_are_gone_or_left_as_the_columns_say() {
    let mut random = Random(77);
    let (mut gone, mut still) = (0, 0);
    for round in 0..12 {
        let undercut = match round % 3 {
            0 => Undercut::t_slot(7.0, 2.0, 3.0),
            1 => Undercut::lollipop(5.0, 2.0),
            _ => Undercut::thread_disc(6.0, 0.4, 0.5, 4.0),
        }
        .unwrap();
        let moves = random_moves(&mut random);
        let flat = CutterProfile::flat(4.0).unwrap();
        let slot = vec![line([-10.0, 1.0, -4.0], [10.0, -2.0, -3.0])];
        // With much room for gaps, and with none at all: wider bounds, and still bounds.
        let bounds = Aabb { min: point([-12.0; 3]), max: point([12.0, 12.0, 0.0]) };
        let Err(StockError::TooFine { needed, .. }) =
            ColumnStock::new(bounds, ColumnOptions::new(0.25, 1))
        else {
            panic!("columns need more than a byte")
        };
        for budget in [BUDGET, needed] {
            let mut part = ColumnStock::new(bounds, ColumnOptions::new(0.25, budget)).unwrap();
            part.cut_below(&[(0.0, undercut.clone())], &moves[..2]);
            part.cut(&flat, &slot);
            part.cut_below(&[(0.0, undercut.clone())], &moves[2..]);
            for _ in 0..600 {
                let at = [
                    random.between(-12.0, 12.0),
                    random.between(-12.0, 12.0),
                    random.between(-12.0, 0.0),
                ];
                let cell = [0, 1].map(|axis| ((at[axis] + 12.0) / 0.25) as u32);
                let heights = part.heights_at(cell[0], cell[1]).unwrap();
                let [surely, maybe] = part.gaps_at(cell[0], cell[1]);
                let within = |spans: &[RemovedSpan]| {
                    spans.iter().any(|span| span.floor <= at[2] && at[2] <= span.top)
                };
                let inside = moves
                    .iter()
                    .map(|path| depth(&undercut, &path.curve, at))
                    .fold(f64::NEG_INFINITY, f64::max);
                let floor = support::floor(&flat, &slot[0].curve, [at[0], at[1]], 100);
                if inside > 0.0 || at[2] > floor {
                    gone += 1;
                    assert!(at[2] >= heights.inner || within(&maybe), "{round} {at:?} {heights:?}");
                } else if inside < -0.05 && at[2] < floor - 1e-3 {
                    still += 1;
                    assert!(
                        at[2] <= heights.outer && !within(&surely),
                        "{round} {at:?} {heights:?}"
                    );
                }
            }
        }
    }
    assert!(gone > 1000 && still > 4000, "{gone} {still}");
}

#[test]
fn a_rapid_in_its_own_gap_touches_nothing() {
    let slot = vec![line([-20.0, 0.0, -12.0], [120.0, 0.0, -12.0])];
    let under = Undercut::t_slot(20.0, 4.0, 9.0).unwrap();
    let mut part = stock([0.0, -30.0, -20.0], [100.0, 30.0, 0.0], 0.2);
    part.cut(&CutterProfile::flat(10.0).unwrap(), &slot);
    let body = RevolvedBody::of_undercuts(&[(0.0, under.clone())]);
    let neck = RevolvedBody::cylinder(9.0, 4.0);
    // Before the gap is cut, the disc meets both sides of the slot.
    let back = [line([120.0, 0.0, -12.0], [-20.0, 0.0, -12.0])];
    let before = part.touch(&body, &back)[0];
    assert!(
        matches!(before.touch(0.01), TouchAnswer::Hit { least, most, .. } if least > 3.99 && most < 4.01)
    );
    let found = part.cut_watching_below(&[(0.0, under)], std::slice::from_ref(&neck), &slot);
    assert_eq!(found[0][0].touch(0.01), TouchAnswer::Clean, "{:?}", found[0][0]);
    // As wide as the gap it cannot be decided; a little smaller it can.
    let smaller = Undercut::t_slot(19.0, 3.8, 8.0).unwrap();
    let smaller = RevolvedBody::of_undercuts(&[(0.1, smaller)]);
    assert_eq!(part.touch(&smaller, &back)[0].touch(0.01), TouchAnswer::Clean);
    // Up inside of the slot the disc meets the roof beside it.
    let up = [line([50.0, 0.0, -12.0], [50.0, 0.0, 20.0])];
    let hit = part.touch(&body, &up)[0];
    assert!(matches!(hit.touch(0.01), TouchAnswer::Hit { least, .. } if least > 7.99), "{hit:?}");
    // A little to the side the neck does, too.
    let aside = [line([50.0, 0.0, -12.0], [50.0, 3.0, -12.0])];
    assert!(matches!(part.touch(&neck, &aside)[0].touch(0.01), TouchAnswer::Hit { .. }));
}

#[test]
fn a_neck_is_compared_with_what_its_edges_leave() {
    let under = Undercut::t_slot(20.0, 4.0, 9.0).unwrap();
    let neck = RevolvedBody::cylinder(9.0, 4.0);
    let watched = |moves: &[TipMove]| {
        let mut part = stock([0.0, -30.0, -20.0], [100.0, 30.0, 0.0], 0.25);
        let found =
            part.cut_watching_below(&[(0.0, under.clone())], std::slice::from_ref(&neck), moves);
        found[0].iter().map(|contact| contact.touch(0.01)).collect::<Vec<_>>()
    };
    // Down from above the disc makes room for its neck; from the side at depth it does not.
    let down = watched(&path(&[[50.0, 0.0, 5.0], [50.0, 0.0, -12.0]]));
    assert_eq!(down, [TouchAnswer::Clean]);
    let into = watched(&path(&[[-15.0, 0.0, -12.0], [50.0, 0.0, -12.0]]));
    assert!(matches!(into[0], TouchAnswer::Hit { least, .. } if least > 7.9), "{into:?}");
    // On the way up it meets the roof before the disc does.
    let up = watched(&path(&[[-15.0, 0.0, -12.0], [50.0, 0.0, 1.0]]));
    assert!(matches!(up[0], TouchAnswer::Hit { .. }), "{up:?}");
}

#[test]
fn volumes_by_tag_and_threads() {
    let under = Undercut::t_slot(20.0, 4.0, 9.0).unwrap();
    let (z, tags) = (-12.0, [1, 2]);
    let along = |y: f64, tag: u32| TipMove { tag, ..line([-20.0, y, z], [120.0, y, z]) };
    let moves = [along(0.0, tags[0]), along(15.0, tags[1])];
    let bounds = Aabb { min: point([0.0, -30.0, -20.0]), max: point([100.0, 30.0, 0.0]) };
    let options = ColumnOptions { by_tag: true, ..ColumnOptions::new(0.25, BUDGET) };
    let mut part = ColumnStock::new(bounds, options).unwrap();
    let mut other = part.clone();
    part.cut_below(&[(0.0, under.clone())], &moves);
    let by_tag = part.removed_by_tag();
    let truth = [8000.0, 6000.0];
    for ((tag, amount), (expected, truth)) in by_tag.iter().zip(tags.iter().zip(truth)) {
        assert_eq!(tag, expected);
        assert!(amount.least <= truth && truth <= amount.most, "{by_tag:?}");
        assert!(amount.most - amount.least < 0.07 * truth, "{by_tag:?}");
    }
    // Tiles in another order: the same bits.
    let undercuts = [(0.0, under)];
    let task =
        chordal_stock::StockTask { undercuts: &undercuts, moves: &moves, ..Default::default() };
    let plan = other.plan(&task);
    other.jobs(&plan).into_iter().rev().for_each(|job| drop(job.run()));
    assert_eq!(part.left(), other.left());
    for (column, row) in [(10, 10), (100, 130), (399, 160)] {
        assert_eq!(part.gaps_at(column, row), other.gaps_at(column, row));
    }
    assert!((part.removed().least..=part.removed().most).contains(&(140.0 * 100.0)));
}

#[test]
fn stock_that_is_hollow_from_below_is_cut_into_its_hollow() {
    // 40 × 20 × 20 mm; from x = 20 on 8 mm are missing below.
    let bounds = Aabb::of_points(Vec3::new(0.0, 0.0, -20.0), Vec3::new(40.0, 20.0, 0.0));
    let mut stock = ColumnStock::new(bounds, ColumnOptions::new(0.5, 100_000_000)).unwrap();
    stock.hollow(&|[low, _]| {
        let spans = if low[0] >= 20.0 - 1e-9 {
            vec![RemovedSpan { floor: -20.0, top: -12.0 }]
        } else {
            Vec::new()
        };
        [spans.clone(), spans]
    });
    let whole = 40.0 * 20.0 * 20.0 - 20.0 * 20.0 * 8.0;
    let VolumeInterval { least, most } = stock.left();
    assert!((least - whole).abs() < 0.1 && (most - whole).abs() < 0.1, "{least} {most}");
    assert_eq!(stock.removed().most, 0.0);
    // A slot of 10 mm, 15 deep: through the roof of the hollow, which is 12 thick.
    let flat = CutterProfile::flat(10.0).unwrap();
    let slot = Line::new(Vec3::new(-20.0, 10.0, -15.0), Vec3::new(60.0, 10.0, -15.0));
    stock.cut(&flat, &[TipMove { curve: slot.into(), tag: 0 }]);
    let removed = stock.removed();
    let truth = 10.0 * (20.0 * 15.0 + 20.0 * 12.0);
    assert!(removed.least <= truth && truth <= removed.most, "{removed:?}");
    // Each of the two walls is known to a column on either side of it.
    assert!(removed.most - removed.least < 4.0 * 0.5 * truth / 10.0 + 1.0, "{removed:?}");
    // The hollow is open there, and closed beside the slot.
    assert_eq!(stock.heights_at(60, 20).unwrap().outer, -20.0);
    assert_eq!(stock.gaps_at(60, 2)[0], [RemovedSpan { floor: -20.0, top: -12.0 }]);
    assert!(stock.gaps_at(60, 20)[0].is_empty());
}
