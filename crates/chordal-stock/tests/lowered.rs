//! What is lowered when: the list alone gives the stock again, at the end and on the way.

use chordal_geometry::{Aabb, Line, Vec3};
use chordal_stock::{ColumnOptions, ColumnStock, CutterProfile, LoweredColumn, Mode, TipMove};

const SIZE: [f64; 3] = [40.0, 30.0, 20.0];
const CELL: f64 = 0.5;

/// Numbers from 0 to 1, the same each time.
struct Random(u64);

impl Random {
    fn share(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }
}

fn stock(mode: Mode) -> ColumnStock {
    let bounds = Aabb::of_points(Vec3::ZERO, Vec3::new(SIZE[0], SIZE[1], SIZE[2]));
    ColumnStock::new(bounds, ColumnOptions { mode, ..ColumnOptions::new(CELL, 100_000_000) })
        .unwrap()
}

/// The outer heights, from the top, as they are stored.
fn heights(stock: &ColumnStock) -> Vec<f32> {
    stock.height_pairs().iter().map(|pair| (pair.outer - SIZE[2]) as f32).collect()
}

fn carry_out(heights: &mut [f32], lowered: &[LoweredColumn]) {
    for at in lowered {
        heights[at.cell as usize] = at.height;
    }
}

/// A path of so many lines, each from where the last one ended, level, up, down, and straight down.
fn path(random: &mut Random, count: usize) -> Vec<TipMove> {
    let mut at = Vec3::new(5.0, 5.0, 15.0);
    let mut moves = Vec::new();
    for n in 0..count {
        let end = match n % 5 {
            0 => Vec3::new(at.x, at.y, 10.0 + 8.0 * random.share()),
            1 | 2 => Vec3::new(SIZE[0] * random.share(), SIZE[1] * random.share(), at.z),
            _ => {
                let z = 8.0 + 11.0 * random.share();
                Vec3::new(SIZE[0] * random.share(), SIZE[1] * random.share(), z)
            }
        };
        moves.push(TipMove { curve: Line::new(at, end).into(), tag: 1 });
        at = end;
    }
    moves
}

fn end(path: &TipMove) -> Vec3 {
    use chordal_geometry::ParamCurve;
    path.curve.end()
}

fn cutters() -> Vec<CutterProfile> {
    vec![
        CutterProfile::flat(6.0).unwrap(),
        CutterProfile::ball(7.0).unwrap(),
        CutterProfile::bull(8.0, 1.5).unwrap(),
        CutterProfile::pointed(6.0, 1.0, 1.6).unwrap(),
    ]
}

#[test]
fn the_list_gives_the_stock_again_to_the_bit() {
    let mut random = Random(11);
    for mode in [Mode::Sampled, Mode::Certified] {
        for cutter in cutters() {
            let moves = path(&mut random, 60);
            let (mut plain, mut told) = (stock(mode), stock(mode));
            let mut again = heights(&told);
            plain.cut(&cutter, &moves);
            let lowered = told.cut_telling(&cutter, &moves);
            assert_eq!(plain.height_pairs(), told.height_pairs());
            carry_out(&mut again, &lowered);
            assert_eq!(again, heights(&plain));
            // In the order of the moves, and along each of them; a column is only ever lowered.
            let when = |at: &LoweredColumn| (at.number, at.share);
            assert!(lowered.is_sorted_by(|a, b| when(a) <= when(b)));
            let mut now = vec![0.0_f32; again.len()];
            for at in &lowered {
                assert!((0.0..=1.0).contains(&at.share) && at.height < now[at.cell as usize]);
                now[at.cell as usize] = at.height;
            }
        }
    }
}

/// On the way the list lacks only what the tool covers where it stands: with that cut, too, it is the stock of the
/// moves until then.
#[test]
fn after_each_move_it_lacks_only_what_the_tool_covers() {
    let mut random = Random(5);
    let mut lacking = 0;
    for cutter in cutters() {
        let moves = path(&mut random, 40);
        let mut told = stock(Mode::Sampled);
        let mut again = heights(&told);
        let lowered = told.cut_telling(&cutter, &moves);
        let mut rest = lowered.as_slice();
        for number in 0..moves.len() as u32 {
            let done = rest.partition_point(|at| at.number <= number);
            carry_out(&mut again, &rest[..done]);
            rest = &rest[done..];
            let mut until = stock(Mode::Sampled);
            until.cut(&cutter, &moves[..=number as usize]);
            let tip = end(&moves[number as usize]);
            let mut under = stock(Mode::Sampled);
            let stand = Line::new(tip, tip + Vec3::new(0.0, 0.0, 1.0));
            under.cut(&cutter, &[TipMove { curve: stand.into(), tag: 1 }]);
            let [columns, _] = until.grid().cells();
            let (until, under) = (heights(&until), heights(&under));
            for (cell, (&want, &have)) in until.iter().zip(&again).enumerate() {
                let x = CELL * (f64::from(cell as u32 % columns) + 0.5) - tip.x;
                let y = CELL * (f64::from(cell as u32 / columns) + 0.5) - tip.y;
                if x.hypot(y) > cutter.radius() + 1e-3 {
                    assert_eq!(want, have, "column {cell} after move {number}");
                } else {
                    lacking += usize::from(want != have);
                    let shown = have.min(under[cell]);
                    assert!((want - shown).abs() < 2e-4, "{want} {shown} after move {number}");
                }
            }
        }
    }
    // Otherwise the test would show nothing of that: a ball leaves columns to the next move.
    assert!(lacking > 50, "{lacking}");
}
