//! Great circles of the tool: the direction is right, and the axes do not jump.

mod common;

use chordal_geometry::Vec3;
use chordal_kinematics::{DirectionError, KinematicChain, OrientationArc, OrientationError};
use common::{
    RandomNumbers, angle_between, degrees, head_head, head_table, nutating_head, nutating_table,
    table_table_ac, table_table_bc,
};

fn machines() -> [KinematicChain; 6] {
    [
        table_table_ac(),
        table_table_bc(),
        head_table(),
        head_head(),
        nutating_head(),
        nutating_table(),
    ]
}

const STEPS: u32 = 2000;

/// Compares the directions along an arc with the great circle by hand, and gives the largest step of an axis between two of
/// many angles, rad. Where an axis is fast, near a pole, it is sampled more densely, so that only a jump is left.
fn follow(chain: &KinematicChain, arc: &OrientationArc, from: Vec3, to: Vec3) -> f64 {
    let whole = angle_between(from, to);
    let mut largest = 0.0_f64;
    for step in 0..=STEPS {
        let sigma = f64::from(step) / f64::from(STEPS);
        let expected =
            (from * ((1.0 - sigma) * whole).sin() + to * (sigma * whole).sin()) / whole.sin();
        let off = angle_between(chain.direction(&arc.angles(sigma)), expected);
        assert!(off < 2e-11, "σ {sigma}: {off} rad off");
        if step < STEPS {
            largest = largest.max(largest_step(arc, sigma, 1.0 / f64::from(STEPS), 3));
        }
    }
    largest
}

/// The largest step of an axis on a part of an arc, rad, which is divided by 100 as long as the step is large.
fn largest_step(arc: &OrientationArc, sigma: f64, width: f64, divisions: u32) -> f64 {
    let (start, end) = (arc.angles(sigma), arc.angles(sigma + width));
    let step = start.iter().zip(end).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    if step < 0.01 || divisions == 0 {
        return step;
    }
    let part = |index: u32| sigma + width * f64::from(index) / 100.0;
    let parts = (0..100).map(|index| largest_step(arc, part(index), width / 100.0, divisions - 1));
    parts.fold(0.0, f64::max)
}

#[test]
fn random_arcs_are_followed_without_a_jump() {
    let mut random = RandomNumbers(31);
    let (mut arcs, mut refused) = (0, 0);
    for chain in machines() {
        for round in 0..150 {
            let (from, to) = (random.direction(), random.direction());
            // Some are not reached by nutating axes.
            let Ok(solutions) = chain.joint_solutions(from) else { continue };
            let mut start = solutions.as_slice()[round % 2].angles;
            let letter = chain.joints()[round % 2].letter;
            start[letter.index()] += std::f64::consts::TAU * f64::from(round as u32 % 5);
            match OrientationArc::new(&chain, from, to, &start) {
                Ok(arc) => {
                    for (own, expected) in arc.angles(0.0).iter().zip(start) {
                        assert!((own - expected).abs() < 1e-7, "{own} is not {expected}");
                    }
                    let largest = follow(&chain, &arc, from, to);
                    assert!(largest < 0.01, "{largest} rad in one step");
                    arcs += 1;
                }
                Err(OrientationError::Direction(DirectionError::Unreachable { .. })) => {
                    let reached = (0..=STEPS).all(|step| {
                        let part = f64::from(step) / f64::from(STEPS);
                        let between = from.lerp(to, part);
                        chain.joint_solutions(between).is_ok()
                    });
                    assert!(!reached, "every sample of the arc is reached");
                    refused += 1;
                }
                Err(error) => panic!("{error}"),
            }
        }
    }
    assert!(arcs > 600 && refused > 20, "{arcs} arcs, {refused} refused");
}

#[test]
fn derivatives_are_those_of_the_angles() {
    const STEP: f64 = 1e-3;
    let mut random = RandomNumbers(32);
    let mut compared = 0;
    for chain in machines() {
        for _ in 0..100 {
            let (from, to) = (random.direction(), random.direction());
            let Ok(solutions) = chain.joint_solutions(from) else { continue };
            let start = solutions.as_slice()[0].angles;
            let Ok(arc) = OrientationArc::new(&chain, from, to, &start) else { continue };
            let sigma = random.between(0.1, 0.9);
            let jet = arc.angle_jet(sigma).expect("no pole");
            // Where an axis is fast its higher derivatives are too large for differences.
            if jet.first.iter().any(|rate| rate.abs() > 6.0) {
                continue;
            }
            let at = |sigma: f64| arc.angle_jet(sigma).expect("no pole");
            let weights = [4.0 / 5.0, -1.0 / 5.0, 4.0 / 105.0, -1.0 / 280.0];
            for index in 0..3 {
                let numerical = |value: &dyn Fn(f64) -> f64| -> f64 {
                    let terms = weights.into_iter().zip(1..).map(|(weight, count)| {
                        let step = STEP * f64::from(count);
                        weight * (value(sigma + step) - value(sigma - step)) / STEP
                    });
                    terms.sum()
                };
                let first = numerical(&|sigma| arc.angles(sigma)[index]);
                let second = numerical(&|sigma| at(sigma).first[index]);
                let size = 1.0 + second.abs();
                assert!((jet.first[index] - first).abs() < 1e-9 * size, "{first}");
                assert!((jet.second[index] - second).abs() < 1e-8 * size, "{second}");
            }
            compared += 1;
        }
    }
    assert!(compared > 300, "{compared}");
}

fn tilted(azimuth_deg: f64, polar_deg: f64) -> Vec3 {
    let (azimuth, polar) = (azimuth_deg.to_radians(), polar_deg.to_radians());
    Vec3::new(polar.sin() * azimuth.cos(), polar.sin() * azimuth.sin(), polar.cos())
}

#[test]
fn through_the_pole_the_tilt_changes_its_sign_and_the_turn_rests() {
    // B/C: from B 20 to B -30 with C at 35.
    for chain in [table_table_bc(), head_table(), head_head()] {
        let start = degrees(0.0, 20.0, 35.0);
        let (from, to) = (chain.direction(&start), chain.direction(&degrees(0.0, -30.0, 35.0)));
        let arc = OrientationArc::new(&chain, from, to, &start).expect("an arc");
        for (sigma, b) in [(0.0, 20.0), (0.2, 10.0), (0.4, 0.0), (0.5, -5.0), (1.0, -30.0)] {
            let [_, own_b, own_c] = arc.angles(sigma).map(f64::to_degrees);
            assert!((own_b - b).abs() < 1e-6, "{own_b} is not {b}");
            assert!((own_c - 35.0).abs() < 1e-6, "{own_c} at {sigma}");
        }
        assert!(follow(&chain, &arc, from, to) < 0.01);
    }
}

#[test]
fn through_the_opposite_pole_as_well() {
    let chain = head_table();
    let start = degrees(0.0, 160.0, 35.0);
    let (from, to) = (chain.direction(&start), chain.direction(&degrees(0.0, 190.0, 35.0)));
    let arc = OrientationArc::new(&chain, from, to, &start).expect("an arc");
    for (sigma, b) in [(0.0, 160.0), (0.5, 175.0), (0.9, 187.0), (1.0, 190.0)] {
        let [_, own_b, own_c] = arc.angles(sigma).map(f64::to_degrees);
        assert!((own_b - b).abs() < 1e-6, "{own_b} is not {b}");
        assert!((own_c - 35.0).abs() < 1e-6, "{own_c} at {sigma}");
    }
}

#[test]
fn a_nutating_head_passes_its_pole() {
    for chain in [nutating_head(), nutating_table()] {
        let (from, to) = (tilted(70.0, 25.0), tilted(250.0, 40.0));
        let start = chain.joint_solutions(from).expect("solutions").as_slice()[1].angles;
        let arc = OrientationArc::new(&chain, from, to, &start).expect("an arc");
        assert!(follow(&chain, &arc, from, to) < 0.01);
    }
}

#[test]
fn beside_the_pole_the_turn_goes_round() {
    // A degree beside it, C turns by nearly 180 and the tilt keeps its sign.
    let chain = table_table_bc();
    let (from, to) = (tilted(3.0, 20.0), tilted(178.0, 20.0));
    let start = degrees(0.0, 20.0, 3.0);
    let arc = OrientationArc::new(&chain, from, to, &start).expect("an arc");
    let [_, b, c] = arc.angles(1.0).map(f64::to_degrees);
    assert!((b - 20.0).abs() < 1e-9 && (c - 178.0).abs() < 1e-9, "B{b} C{c}");
    assert!(follow(&chain, &arc, from, to) < 0.01);
}

#[test]
fn from_the_pole_the_first_angle_is_that_of_leaving() {
    let chain = table_table_bc();
    let to = tilted(50.0, 30.0);
    let arc = OrientationArc::new(&chain, Vec3::Z, to, &degrees(0.0, 0.0, 40.0)).expect("an arc");
    for (sigma, b) in [(0.0, 0.0), (0.5, 15.0), (1.0, 30.0)] {
        let [_, own_b, own_c] = arc.angles(sigma).map(f64::to_degrees);
        assert!((own_b - b).abs() < 1e-6 && (own_c - 50.0).abs() < 1e-6, "B{own_b} C{own_c}");
    }
    // From C-120 the other side is nearer: C-130 and a negative tilt.
    let arc = OrientationArc::new(&chain, Vec3::Z, to, &degrees(0.0, 0.0, -120.0)).expect("an arc");
    let [_, b, c] = arc.angles(1.0).map(f64::to_degrees);
    assert!((b + 30.0).abs() < 1e-6 && (c + 130.0).abs() < 1e-6, "B{b} C{c}");
    assert_eq!(arc.angle_jet(0.0), None);
    assert!(arc.angle_jet(0.5).is_some());
}

#[test]
fn a_direction_that_stays_keeps_the_angles() {
    let chain = nutating_head();
    let start = degrees(0.0, 70.0, 400.0);
    let from = chain.direction(&start);
    let arc = OrientationArc::new(&chain, from, from * 3.0, &start).expect("an arc");
    for sigma in [0.0, 0.3, 1.0] {
        for (own, expected) in arc.angles(sigma).iter().zip(start) {
            assert!((own - expected).abs() < 1e-12, "{own} is not {expected}");
        }
    }
    // On the pole, too, where nothing is left to turn.
    let start = degrees(0.0, 0.0, 123.0);
    let arc = OrientationArc::new(&chain, Vec3::Z, Vec3::Z, &start).expect("an arc");
    let [_, b, c] = arc.angles(0.5).map(f64::to_degrees);
    assert!(b.abs() < 1e-9 && (c - 123.0).abs() < 1e-9, "B{b} C{c}");
}

#[test]
fn an_arc_that_leaves_the_reach_between_its_ends_is_refused() {
    use chordal_geometry::Transform;
    use chordal_kinematics::{RotaryJoint, RotaryLetter};
    // The tool is 90 degrees from B, and B 40 degrees from A, which carries it: it reaches 50 to 130 degrees from A.
    let axis = Vec3::new(0.0, 40_f64.to_radians().cos(), 40_f64.to_radians().sin());
    let chain = common::chain(&[
        RotaryJoint::head(RotaryLetter::A, Vec3::ZERO).along(axis),
        RotaryJoint::head(RotaryLetter::B, Vec3::ZERO),
    ]);
    let around_x = |deg: f64| {
        Transform::rotation_about(Vec3::ZERO, Vec3::X, deg.to_radians()).apply_direction(axis)
    };
    // 70 degrees on both sides of A, and of its opposite.
    for (from, to) in [(around_x(-70.0), around_x(70.0)), (around_x(110.0), around_x(-110.0))] {
        let start = chain.joint_solutions(from).expect("solutions").as_slice()[0].angles;
        assert!(chain.joint_solutions(to).is_ok());
        let Err(OrientationError::Direction(DirectionError::Unreachable { beyond_rad })) =
            OrientationArc::new(&chain, from, to, &start)
        else {
            panic!("the middle of the arc is along A");
        };
        assert!((beyond_rad.to_degrees() - 50.0).abs() < 1e-6, "{beyond_rad}");
    }
}

#[test]
fn what_is_no_arc() {
    let chain = table_table_bc();
    let start = degrees(0.0, 20.0, 0.0);
    let from = chain.direction(&start);
    let error = |chain: &KinematicChain, from: Vec3, to: Vec3| {
        OrientationArc::new(chain, from, to, &start).expect_err("no arc")
    };
    assert_eq!(error(&chain, from, -from), OrientationError::Opposite);
    assert_eq!(error(&KinematicChain::CARTESIAN, from, from), OrientationError::NotTwoAxes);
    let OrientationError::NotAtStart { off_rad } = error(&chain, Vec3::Z, Vec3::X) else {
        panic!("the start angles give B20");
    };
    assert!((off_rad.to_degrees() - 20.0).abs() < 1e-9);
    let no = OrientationError::Direction(DirectionError::NoDirection);
    assert_eq!(error(&chain, Vec3::ZERO, from), no);

    // Both ends of a nutating head are within reach, the middle is not... below the horizon by 20 degrees.
    let head = nutating_head();
    let start = head.joint_solutions(tilted(0.0, 80.0)).expect("solutions").as_slice()[0].angles;
    let result = OrientationArc::new(&head, tilted(0.0, 80.0), tilted(0.0, 110.0), &start);
    let Err(OrientationError::Direction(DirectionError::Unreachable { beyond_rad })) = result
    else {
        panic!("{result:?}");
    };
    assert!((beyond_rad.to_degrees() - 20.0).abs() < 1e-9);
}

#[test]
fn parts_with_even_angles_stay_next_to_the_arc() {
    const TOLERANCE_RAD: f64 = 1e-4;
    let mut random = RandomNumbers(33);
    let (mut compared, mut split) = (0, 0);
    for chain in machines() {
        for _ in 0..100 {
            let (from, to) = (random.direction(), random.direction());
            let Ok(solutions) = chain.joint_solutions(from) else { continue };
            let start = solutions.as_slice()[0].angles;
            let Ok(arc) = OrientationArc::new(&chain, from, to, &start) else { continue };
            let Some(parts) = arc.parts(&start, TOLERANCE_RAD) else { continue };
            assert_eq!(parts.last(), Some(&arc.angles(1.0)));
            let normal = from.cross(to).normalized().expect("a plane");
            let ends: Vec<_> = [start].into_iter().chain(parts).collect();
            for pair in ends.windows(2) {
                for share in [0.25, 0.5, 0.75] {
                    let angles = std::array::from_fn(|axis| {
                        pair[0][axis] + (pair[1][axis] - pair[0][axis]) * share
                    });
                    let away = chain.direction(&angles).dot(normal).abs();
                    assert!(away < TOLERANCE_RAD * 1.5, "{away}");
                }
            }
            (compared, split) = (compared + 1, split + usize::from(ends.len() > 2));
        }
    }
    assert!(compared > 300 && split > 300, "{compared} arcs, {split} in parts");
}
