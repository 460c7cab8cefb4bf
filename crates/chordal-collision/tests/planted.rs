//! Planted collisions and near misses of known depth and clearance, thin walls, and random bodies against dense samples.

mod common;

use chordal_collision::{AxisMove, LinkedSolid, PairAnswer, PairCheck};
use chordal_geometry::{
    Arc, ConvexSolid, Curve, Line, ParamCurve, PlacedSolid, Plane, Transform, Vec3, solid_distance,
};
use common::{Kinematics, Random};

const TOLERANCE_MM: f64 = 0.1;
const BUDGET: u64 = 1_000_000;

/// Where the body of the tool reaches farthest down a direction of the part, at a share of the move.
struct Reach<'a> {
    machine: &'a Kinematics,
    path: &'a AxisMove,
    tool: &'a ConvexSolid,
    up: Vec3,
}

impl Reach<'_> {
    /// The lowest point of the tool along `up`, in coordinates of the part.
    fn at(&self, share: f64) -> f64 {
        let to_part = self.machine.tool_on_part(&self.path.at(share));
        let down = to_part.inverse().apply_direction(-self.up);
        to_part.apply_point(self.tool.farthest(down)).dot(self.up)
    }

    /// The lowest one of the whole move, and its share.
    fn lowest(&self) -> (f64, f64) {
        const SAMPLES: usize = 2000;
        let shares = (0..=SAMPLES).map(|at| at as f64 / SAMPLES as f64);
        let by_height = |a: &(f64, f64), b: &(f64, f64)| a.0.total_cmp(&b.0);
        let mut best = shares.map(|share| (self.at(share), share)).min_by(by_height).unwrap();
        let mut width = 1.0 / SAMPLES as f64;
        while width > 1e-10 {
            for share in [best.1 - width, best.1 + width] {
                let share = share.clamp(0.0, 1.0);
                if self.at(share) < best.0 {
                    best = (self.at(share), share);
                }
            }
            width *= 0.7;
        }
        best
    }
}

/// A large block on the part whose face is `gap` below the tool at the lowest point of a random move: with a negative gap
/// the tool is so deep in it. Of the block everything else is far away.
fn case(random: &mut Random, number: usize, gap: f64) -> (PairAnswer, u64, String) {
    let machine = Kinematics::number(number);
    let path = machine.random_move(random);
    let tool = random.solid(8.0, Vec3::new(0.0, 0.0, -60.0));
    let up = random.direction();
    let reach = Reach { machine: &machine, path: &path, tool: &tool, up };
    let (lowest, share) = reach.lowest();
    let to_part = machine.tool_on_part(&path.at(share));
    let below = to_part.apply_point(tool.farthest(to_part.inverse().apply_direction(-up)));
    let foot = below - up * (below.dot(up) - lowest + gap);
    let side = up.cross(random.direction()).normalized().unwrap();
    let other = up.cross(side);
    let block = [0.0, -4000.0].into_iter().flat_map(|depth| {
        [(-1.0, -1.0), (-1.0, 1.0), (1.0, -1.0), (1.0, 1.0)]
            .map(|(u, v)| foot + up * depth + side * (u * 4000.0) + other * (v * 4000.0))
    });
    let block = ConvexSolid::hull(block.collect()).unwrap();
    let bodies = [
        LinkedSolid::new(machine.links.tool(), tool),
        LinkedSolid::new(machine.links.part(), block),
    ];
    let mut budget = BUDGET;
    let check = PairCheck::new(&machine.links, &bodies[0], &bodies[1]);
    let answer = check.along(&path, TOLERANCE_MM, &mut budget);
    if let PairAnswer::Contact { share, .. } = answer {
        let deepest = check.deepest(&path, share, TOLERANCE_MM);
        assert!(deepest.depth_mm <= -gap.min(0.0) + 1e-6, "{deepest:?} of {gap}");
    }
    (answer, BUDGET - budget, format!("case {number} {} {path:?}", machine.name))
}

#[test]
fn planted_collisions_are_found() {
    let mut random = Random::new(20_260_801);
    let (mut found, mut positions) = (0, 0);
    for number in 0..200 {
        let depth = random.between(TOLERANCE_MM, 5.0 * TOLERANCE_MM);
        let (answer, looked, what) = case(&mut random, number, -depth);
        assert!(
            matches!(answer, PairAnswer::Contact { .. }),
            "{answer:?} at depth {depth}: {what}"
        );
        found += 1;
        positions += looked;
    }
    println!("{found} of 200 planted collisions found, {} positions each", positions / 200);
}

#[test]
fn near_misses_are_not_reported() {
    let mut random = Random::new(20_260_802);
    let (mut free, mut positions) = (0, 0);
    for number in 0..200 {
        let clearance = random.between(TOLERANCE_MM, 3.0 * TOLERANCE_MM);
        let (answer, looked, what) = case(&mut random, number, clearance);
        assert_eq!(answer, PairAnswer::Free, "clearance {clearance}: {what}");
        free += 1;
        positions += looked;
    }
    println!("{free} of 200 near misses free, {} positions each", positions / 200);
}

#[test]
fn a_touch_without_depth_is_found() {
    let mut random = Random::new(11);
    for number in 0..60 {
        let (answer, _, what) = case(&mut random, number, 0.0);
        assert!(matches!(answer, PairAnswer::Contact { .. }), "{answer:?}: {what}");
    }
}

/// Moves of 200 mm through a plate of 0.1 mm.
#[test]
fn a_thin_wall_between_two_samples_is_found() {
    let directions =
        [Vec3::X, -Vec3::Y, Vec3::Z, Vec3::new(1.0, 1.0, 0.3), Vec3::new(-0.2, 0.7, -1.0)];
    let mut found = 0;
    for (number, direction) in directions.into_iter().enumerate() {
        for machine in (0..Kinematics::COUNT).map(Kinematics::number) {
            let along = direction.normalized().unwrap();
            let [start, end] = [along * -123.0, along * 77.0];
            let path = AxisMove {
                curve: Curve::Line(Line { start, end }),
                rotary_from: [0.0; 3],
                rotary_to: [0.0; 3],
                deviation_mm: 0.0,
            };
            let side = along.cross(Vec3::new(0.31, -0.2, 0.9)).normalized().unwrap();
            let other = along.cross(side);
            let at = |x: f64| {
                [(-1.0, -1.0), (-1.0, 1.0), (1.0, -1.0), (1.0, 1.0)]
                    .map(|(u, v)| along * x + (side * u + other * v) * 30.0)
            };
            let plate = ConvexSolid::hull([at(0.0), at(0.1)].concat()).unwrap();
            let needle = ConvexSolid::ball(Vec3::ZERO, 0.05).unwrap();
            let (tool, part) = (machine.links.tool(), machine.links.part());
            let bodies = [LinkedSolid::new(tool, needle), LinkedSolid::new(part, plate)];
            let mut budget = BUDGET;
            let check = PairCheck::new(&machine.links, &bodies[0], &bodies[1]);
            let answer = check.along(&path, 0.01, &mut budget);
            assert!(matches!(answer, PairAnswer::Contact { .. }), "{answer:?}: {number}");
        }
        found += 1;
    }
    println!("{found} of 5 walls found, on {} machines each", Kinematics::COUNT);
}

/// Bodies of usual size on all links, against positions close to each other.
#[test]
fn random_bodies_agree_with_dense_samples() {
    let mut random = Random::new(5);
    let (mut free, mut contacts) = (0, 0);
    for number in 0..300 {
        let machine = Kinematics::number(number);
        let mut path = machine.random_move(&mut random);
        if number % 3 == 0 {
            let turned = Transform::translation(path.curve_start());
            let arc = Arc::new(Plane::Xy.frame(), 40.0, random.between(-6.0, 6.0), 25.0);
            path = AxisMove { curve: Curve::Arc(arc).transformed(&turned), ..path.0 }.into();
        }
        let solids = [
            random.solid(90.0, Vec3::new(0.0, 0.0, -20.0)),
            random.solid(120.0, Vec3::new(60.0, 40.0, -120.0)),
        ];
        let links =
            [machine.links.tool(), [machine.links.part(), machine.links.base()][number % 2]];
        let [one, other] = [0, 1].map(|i| LinkedSolid::new(links[i], solids[i].clone()));
        let mut budget = BUDGET;
        let answer =
            PairCheck::new(&machine.links, &one, &other).along(&path, TOLERANCE_MM, &mut budget);
        let distance = |share: f64| {
            let axes = path.at(share);
            let placed =
                [0, 1].map(|i| PlacedSolid::new(&solids[i], machine.links.pose(links[i], &axes)));
            solid_distance(&placed[0], &placed[1], 1e-4, f64::INFINITY)
        };
        let samples: Vec<_> = (0..=1000).map(|at| distance(f64::from(at) / 1000.0)).collect();
        let nearest = samples.iter().map(|found| found.upper).fold(f64::INFINITY, f64::min);
        match answer {
            PairAnswer::Free => {
                free += 1;
                assert!(nearest > 0.0, "{number}: {nearest}");
            }
            PairAnswer::Contact { share, .. } => {
                contacts += 1;
                assert!(distance(share).lower <= TOLERANCE_MM, "{number}");
            }
            PairAnswer::Undecided { .. } => panic!("{number}: {answer:?}"),
        }
    }
    println!("{free} free, {contacts} contacts");
    assert!(free > 50 && contacts > 50, "{free} {contacts}");
}

#[test]
fn what_the_budget_does_not_decide_is_undecided() {
    let mut random = Random::new(9);
    let machine = Kinematics::number(0);
    let path = machine.random_move(&mut random);
    let solid = || ConvexSolid::ball(Vec3::ZERO, 5.0).unwrap();
    let bodies =
        [machine.links.tool(), machine.links.base()].map(|link| LinkedSolid::new(link, solid()));
    let check = PairCheck::new(&machine.links, &bodies[0], &bodies[1]);
    let answer = check.along(&path, TOLERANCE_MM, &mut 0);
    assert_eq!(answer, PairAnswer::Undecided { share: 0.0 });
}
