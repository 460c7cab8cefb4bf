//! Rapids, shanks, holders and edges that are too short.

mod support;

use chordal_geometry::Aabb;
use chordal_stock::{
    CheckedStock, ColumnOptions, ContactDepth, CutterProfile, RevolvedBody, StockCheck, StockTask,
    TipMove, TouchAnswer,
};
use support::{BUDGET, line, path, point, sampled, stock};

const TOLERANCE: f64 = 1e-3;
const DROP: f64 = 0.05;

fn answers(contacts: &[ContactDepth]) -> Vec<TouchAnswer> {
    contacts.iter().map(|contact| contact.touch(TOLERANCE)).collect()
}

#[test]
fn a_rapid_through_stock_is_told_with_its_depth() {
    let flat = CutterProfile::flat(6.0).unwrap();
    let mut block = stock([0.0, 0.0, -20.0], [40.0, 30.0, 0.0], 0.2);
    let body = RevolvedBody::of_cutter(&flat);
    let moves = path(&[
        [-10.0, 15.0, 5.0],
        // Above, down beside, through, along the bottom far below it, out.
        [50.0, 15.0, 5.0],
        [50.0, 15.0, -7.5],
        [20.0, 15.0, -7.5],
        [20.0, 15.0, 5.0],
    ]);
    let found = answers(&block.touch(&body, &moves));
    assert_eq!(found[0], TouchAnswer::Clean);
    assert_eq!(found[1], TouchAnswer::Clean);
    for touch in &found[2..] {
        let TouchAnswer::Hit { least, most, .. } = *touch else { panic!("{touch:?}") };
        assert!(least <= 7.5 && 7.5 <= most && most - least < 1e-3, "{touch:?}");
    }
    // In the slot that it has cut it only slides.
    block.cut(&flat, &[line([-10.0, 15.0, -7.5], [50.0, 15.0, -7.5])]);
    let again = block.touch(&body, &[line([50.0, 15.0, -7.5], [-10.0, 15.0, -7.5])]);
    assert!(!matches!(again[0].touch(TOLERANCE), TouchAnswer::Hit { .. }), "{again:?}");
    // A millimetre above the floor and away from the walls it touches nothing.
    let small = RevolvedBody::cylinder(4.0, 0.0);
    let inside = block.touch(&small, &[line([50.0, 15.0, -6.5], [-10.0, 15.0, -6.5])]);
    assert_eq!(inside[0].touch(TOLERANCE), TouchAnswer::Clean);
}

#[test]
fn a_body_below_what_is_cut_through_touches_nothing() {
    let flat = CutterProfile::flat(6.0).unwrap();
    let mut block = stock([0.0, 0.0, -5.0], [40.0, 30.0, 0.0], 0.2);
    let through = [line([-10.0, 15.0, -5.5], [50.0, 15.0, -5.5])];
    block.cut(&flat, &through);
    let small = RevolvedBody::cylinder(4.0, 0.0);
    assert_eq!(block.touch(&small, &through)[0].touch(TOLERANCE), TouchAnswer::Clean);
}

#[test]
fn edges_too_short_for_the_depth() {
    let long = CutterProfile::flat(6.0).unwrap().with_flutes(Some(8.0));
    let bodies = [RevolvedBody::above_flutes(&long).unwrap()];
    let slot = |z: f64| [line([5.0, 15.0, z], [35.0, 15.0, z])];
    let fresh = || stock([0.0, 0.0, -30.0], [40.0, 30.0, 0.0], 0.2);
    let found = fresh().cut_watching(&long, &bodies, &slot(-7.9), DROP);
    assert_eq!(found[0][0].touch(TOLERANCE), TouchAnswer::Clean);
    let found = fresh().cut_watching(&long, &bodies, &slot(-10.0), DROP);
    let TouchAnswer::Hit { least, most, .. } = found[0][0].touch(TOLERANCE) else {
        panic!("{found:?}")
    };
    assert!(least <= 2.0 && 2.0 <= most && most - least < 1e-3);
    // In two passes the edges are long enough; so is a thin shank in a deep hole that the cutter makes.
    let mut twice = fresh();
    for z in [-7.0, -10.0] {
        let found = twice.cut_watching(&long, &bodies, &slot(z), DROP);
        assert!(!matches!(found[0][0].touch(TOLERANCE), TouchAnswer::Hit { .. }), "{found:?}");
    }
    let shank = [RevolvedBody::cylinder(4.0, 8.0)];
    let hole = [line([20.0, 15.0, 1.0], [20.0, 15.0, -20.0])];
    let found = fresh().cut_watching(&long, &shank, &hole, DROP);
    assert_eq!(found[0][0].touch(TOLERANCE), TouchAnswer::Clean);
}

#[test]
fn a_holder_meets_a_wall_beside_the_path() {
    let ball = CutterProfile::ball(6.0).unwrap();
    let mut block = stock([0.0, 0.0, -40.0], [60.0, 60.0, 0.0], 0.4);
    // A pocket 30 deep from x = 30 on.
    let wide = CutterProfile::flat(20.0).unwrap();
    block.cut(
        &wide,
        &path(&[[40.0, 0.0, -30.0], [40.0, 60.0, -30.0], [60.0, 60.0, -30.0], [60.0, 0.0, -30.0]]),
    );
    let holder = [RevolvedBody::stack(25.0, &[[10.0, 12.0, 12.0], [20.0, 40.0, 40.0]])];
    // The lower end of the holder, of radius 6, is 5 below the top; the wide one 5 above it.
    let along = |x: f64| path(&[[x, 10.0, -30.0], [x, 50.0, -30.0]]);
    let clear = block.clone().cut_watching(&ball, &holder, &along(37.0), DROP);
    assert_eq!(clear[0][0].touch(TOLERANCE), TouchAnswer::Clean);
    let near = block.clone().cut_watching(&ball, &holder, &along(34.0), DROP);
    let TouchAnswer::Hit { least, most, at } = near[0][0].touch(TOLERANCE) else {
        panic!("{near:?}")
    };
    assert!(least <= 5.0 && (5.0..5.001).contains(&most), "{near:?}");
    assert!(at[0] < 30.4 && at[0] > 27.6 && at[2] == 0.0, "{at:?}");
}

#[test]
fn between_clean_and_hit_lies_what_the_cells_cannot_say() {
    let mut block = stock([0.0, 0.0, -20.0], [40.0, 30.0, 0.0], 0.5);
    block.cut(
        &CutterProfile::flat(10.0).unwrap(),
        &[line([-10.0, 15.03, -5.0], [50.0, 15.03, -5.0])],
    );
    // A hundredth from the wall of the slot: no cell of half a millimetre knows.
    let near = RevolvedBody::cylinder(9.98, 0.0);
    let found = block.touch(&near, &[line([-10.0, 15.03, -4.0], [50.0, 15.03, -4.0])]);
    let TouchAnswer::Undecided { most, .. } = found[0].touch(TOLERANCE) else {
        panic!("{found:?}")
    };
    assert!(most <= 4.001);
}

#[test]
fn samples_answer_too() {
    let mut block = sampled([0.0, 0.0, -20.0], [40.0, 30.0, 0.0], 0.5);
    let body = RevolvedBody::of_cutter(&CutterProfile::ball(6.0).unwrap());
    let found = block.touch(&body, &path(&[[5.0, 5.0, 2.0], [15.0, 15.0, -2.0]]));
    assert!((found[0].most - 2.0).abs() < 0.1 && found[0].least == found[0].most);
}

fn refine(tasks: &[StockTask<'_>], resolution: f64, finest: f64) -> CheckedStock {
    let bounds = Aabb { min: point([0.0, 0.0, -20.0]), max: point([40.0, 30.0, 0.0]) };
    let heights = |_: [f64; 2], _: [f64; 2]| [0.0, 0.0];
    let options = ColumnOptions::new(resolution, BUDGET);
    let check = StockCheck {
        bounds,
        options,
        heights: &heights,
        hollows: None,
        tasks,
        lowered: &[],
        tolerance: TOLERANCE,
        finest,
    };
    check.run().unwrap()
}

#[test]
fn what_cells_cannot_say_is_done_again_finer() {
    let cutter = CutterProfile::flat(10.0).unwrap();
    let slot: Vec<TipMove> = path(&[[-10.0, 15.03, -5.0], [50.0, 15.03, -5.0], [50.0, 15.03, 9.0]]);
    let back = [line([-10.0, 15.03, -4.0], [50.0, 15.03, -4.0])];
    // The gap to the walls: 0.2, 0.05, none, and beyond the wall by 0.06.
    let bodies = [9.6, 9.9, 10.0, 10.12].map(|diameter| RevolvedBody::cylinder(diameter, 0.0));
    let cut = StockTask { cutter: Some(&cutter), moves: &slot, ..StockTask::default() };
    let ask = StockTask { bodies: &bodies, moves: &back, ..StockTask::default() };
    let coarse = refine(&[cut, ask], 0.8, 0.8);
    assert_eq!(coarse.refined, 0);
    for of_body in &coarse.contacts[1] {
        assert!(
            matches!(of_body[0].touch(TOLERANCE), TouchAnswer::Undecided { .. }),
            "{of_body:?}"
        );
    }
    let fine = refine(&[cut, ask], 0.8, 0.02);
    let answer = |body: usize| fine.contacts[1][body][0].touch(TOLERANCE);
    assert_eq!(answer(0), TouchAnswer::Clean);
    assert_eq!(answer(1), TouchAnswer::Clean);
    assert!(matches!(answer(2), TouchAnswer::Undecided { .. }), "{:?}", answer(2));
    let TouchAnswer::Hit { least, most, .. } = answer(3) else { panic!("{:?}", answer(3)) };
    assert!(least <= 4.0 && 4.0 <= most && most - least < 1e-3);
    // Only the tiles along the walls, and not the whole stock again: at the last size it has 1200 tiles.
    assert!(fine.refined < 700, "{}", fine.refined);
    assert_eq!(fine.stock.left(), coarse.stock.left());
}

#[test]
fn a_refined_answer_is_that_of_the_whole_stock_at_that_size() {
    let ball = CutterProfile::ball(6.0).unwrap().with_flutes(Some(4.0));
    let mut random = support::Random(2024);
    let mut corners = vec![[20.0, 15.0, 1.0]];
    for _ in 0..60 {
        corners.push([
            random.between(5.0, 35.0),
            random.between(5.0, 25.0),
            random.between(-6.0, 1.0),
        ]);
    }
    let moves = path(&corners);
    let bodies = [
        RevolvedBody::above_flutes(&ball).unwrap(),
        RevolvedBody::stack(7.0, &[[5.0, 10.0, 20.0]]),
    ];
    let task = StockTask {
        cutter: Some(&ball),
        bodies: &bodies,
        moves: &moves,
        drop: 0.2,
        ..StockTask::default()
    };
    let fine = refine(&[task], 0.8, 0.2);
    let whole = refine(&[task], 0.2, 0.2);
    let coarse = refine(&[task], 0.8, 0.8);
    let (mut decided, mut hits) = (0, 0);
    for body in 0..bodies.len() {
        for n in 0..moves.len() {
            let touch = |of: &CheckedStock| of.contacts[0][body][n].touch(TOLERANCE);
            match (touch(&fine), touch(&whole)) {
                // What coarse cells are sure of, fine ones are too, and never of the contrary.
                (TouchAnswer::Clean, other) => assert!(!matches!(other, TouchAnswer::Hit { .. })),
                (TouchAnswer::Hit { .. }, other) => {
                    hits += 1;
                    assert_ne!(other, TouchAnswer::Clean);
                }
                (TouchAnswer::Undecided { .. }, other) => {
                    assert!(
                        matches!(other, TouchAnswer::Undecided { .. } | TouchAnswer::Hit { .. }),
                        "{other:?}"
                    );
                }
            }
            let open = |touch: TouchAnswer| matches!(touch, TouchAnswer::Undecided { .. });
            decided += usize::from(open(touch(&coarse)) && !open(touch(&fine)));
        }
    }
    assert!(hits > 5 && decided > 5, "{hits} {decided}");
}
