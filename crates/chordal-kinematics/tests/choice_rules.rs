//! Which solution each control takes.

mod common;

use std::f64::consts::{PI, TAU};

use chordal_geometry::Vec3;
use chordal_kinematics::{
    AngleSign, ChoiceError, JointAngles, KinematicChain, RotaryJoint, RotaryLetter, SolutionRule,
};
use common::{RandomNumbers, chain, degrees, head_head, table_table_ac};

fn chosen(
    chain: &KinematicChain,
    direction: Vec3,
    present: JointAngles,
    rule: SolutionRule,
) -> Result<[f64; 3], ChoiceError> {
    let solutions = chain.joint_solutions(direction).expect("solutions");
    chain.choose(&solutions, &present, rule).map(|angles| angles.map(f64::to_degrees))
}

#[track_caller]
fn close(found: Result<[f64; 3], ChoiceError>, expected: [f64; 3]) {
    let found = found.expect("a solution");
    for (found, expected) in found.iter().zip(expected) {
        assert!((found - expected).abs() < 1e-9, "{found:?} is not {expected:?}");
    }
}

const MASTER_C: SolutionRule = SolutionRule::MasterMovement { master: RotaryLetter::C };

/// The head of the manual's example (A-79348E p.31): the tool along X is B 90 C 0, or B 270 C 180.
#[test]
fn fanuc_goes_down_its_list_of_ties() {
    let chain = head_head();
    let to = |b: f64, c: f64| chosen(&chain, Vec3::X, degrees(0.0, b, c), MASTER_C);
    // The master decides.
    close(to(0.0, 10.0), [0.0, 90.0, 0.0]);
    close(to(0.0, 170.0), [0.0, -90.0, 180.0]);
    // Both are 90 from C: the slave decides.
    close(to(170.0, 90.0), [0.0, 90.0, 0.0]);
    close(to(190.0, 90.0), [0.0, 270.0, 180.0]);
    // And both are 90 from B: the master nearest to 0.
    close(to(180.0, 90.0), [0.0, 90.0, 0.0]);
    // The master comes before the slave: 80 and 150 against 100 and 30.
    close(to(-60.0, 80.0), [0.0, 90.0, 0.0]);
    // C 0 and C 360 are as near to 0: the slave nearest to 0.
    close(chosen(&chain, Vec3::X, degrees(0.0, 0.0, 180.0), MASTER_C), [0.0, -90.0, 180.0]);
}

#[test]
fn fanuc_compares_the_distance_of_the_master_from_zero_before_that_of_the_slave() {
    // B170 A10 or B-10 A170, each 90 of B and 80 of A away: B is nearer to 0 in one, A in the other.
    let chain = chain(
        &[RotaryLetter::B, RotaryLetter::A].map(|letter| RotaryJoint::head(letter, Vec3::ZERO)),
    );
    let direction = chain.direction(&degrees(10.0, 170.0, 0.0));
    let present = degrees(90.0, 80.0, 0.0);
    let by = |master| chosen(&chain, direction, present, SolutionRule::MasterMovement { master });
    assert_eq!(chain.master(), Some(RotaryLetter::B));
    close(by(RotaryLetter::B), [170.0, -10.0, 0.0]);
    close(by(RotaryLetter::A), [10.0, 170.0, 0.0]);
}

/// The manual's "slave at 0": the master stays (A-79348E p.32).
#[test]
fn the_free_axis_stays_where_it_is() {
    for rule in [MASTER_C, SolutionRule::LEAST_MOVEMENT] {
        close(chosen(&head_head(), Vec3::Z, degrees(5.0, 45.0, 90.0), rule), [5.0, 0.0, 90.0]);
    }
}

#[test]
fn ranges_filter_pairs_before_anything_else() {
    let [c, b] =
        [RotaryLetter::C, RotaryLetter::B].map(|letter| RotaryJoint::head(letter, Vec3::ZERO));
    let tilt = 40_f64.to_radians();
    let direction = Vec3::new(tilt.sin(), 0.0, tilt.cos());
    let limited = chain(&[c, b.within(-PI, 0.0)]);
    close(chosen(&limited, direction, [0.0; 3], MASTER_C), [0.0, -40.0, 180.0]);
    // C may not reach 180, but -180.
    let less = chain(&[c.within(-PI, PI / 2.0), b.within(-PI, 0.0)]);
    close(chosen(&less, direction, degrees(0.0, 0.0, 80.0), MASTER_C), [0.0, -40.0, -180.0]);
    let none = chain(&[c, b.within(0.0, 30_f64.to_radians())]);
    let error = chosen(&none, direction, [0.0; 3], MASTER_C).expect_err("B reaches 30 at most");
    let ChoiceError::OutOfTravel { letter, beyond_rad } = error else { panic!("{error}") };
    assert_eq!(letter, RotaryLetter::B);
    assert!((beyond_rad.to_degrees() - 10.0).abs() < 1e-9, "{beyond_rad}");
}

#[test]
fn whole_turns_bring_the_angles_near_the_present_ones() {
    let present = degrees(0.0, 0.0, 1000.0);
    let direction = Vec3::new(0.0, -0.5, 0.75_f64.sqrt());
    let found = chosen(&table_table_ac(), direction, present, SolutionRule::LEAST_MOVEMENT);
    // A30 C0 + 1080 moves 110, A-30 C180 + 720 moves 130.
    close(found, [30.0, 0.0, 1080.0]);
}

#[test]
fn mitsubishi_keeps_the_side_near_the_pole() {
    let rule = SolutionRule::PoleSide { near_rad: 5_f64.to_radians() };
    let at = |tilt: f64| {
        let tilt = tilt.to_radians();
        Vec3::new(0.0, -tilt.sin(), tilt.cos())
    };
    let chain_of = |low: f64, high: f64| {
        let [c, a] =
            [RotaryLetter::C, RotaryLetter::A].map(|letter| RotaryJoint::table(letter, Vec3::ZERO));
        chain(&[c, a.within(low.to_radians(), high.to_radians())])
    };
    let chain = chain_of(-120.0, 120.0);
    // A stays positive although C turns by 170 for it and only by 10 for the other solution.
    close(chosen(&chain, at(2.0), degrees(1.0, 0.0, 170.0), rule), [2.0, 0.0, 0.0]);
    close(chosen(&chain, at(2.0), degrees(-1.0, 0.0, 10.0), rule), [-2.0, 0.0, 180.0]);
    // Farther from the pole the smallest sum of movements.
    close(chosen(&chain, at(20.0), degrees(1.0, 0.0, 170.0), rule), [-20.0, 0.0, 180.0]);
    // From 0 the side with more travel; of equal ones the negative.
    let present = degrees(0.0, 0.0, 20.0);
    close(chosen(&chain_of(-30.0, 120.0), at(2.0), present, rule), [2.0, 0.0, 0.0]);
    close(chosen(&chain_of(-120.0, 30.0), at(2.0), present, rule), [-2.0, 0.0, 180.0]);
    close(chosen(&chain, at(2.0), present, rule), [-2.0, 0.0, 180.0]);
    // A side without travel is not kept.
    close(chosen(&chain_of(-1.0, 120.0), at(2.0), degrees(-1.0, 0.0, 0.0), rule), [2.0, 0.0, 0.0]);
}

#[test]
fn the_side_counts_from_the_angle_of_the_pole() {
    // The tool is along B, the first axis, at A90 of a reversed A.
    let rule = SolutionRule::PoleSide { near_rad: 5_f64.to_radians() };
    for (low, high, expected) in [(-10.0, 170.0, 88.0), (10.0, 190.0, 92.0)] {
        let [b, a] =
            [RotaryLetter::B, RotaryLetter::A].map(|letter| RotaryJoint::head(letter, Vec3::ZERO));
        let a = a.turned_around().within(f64::to_radians(low), f64::to_radians(high));
        let chain = chain(&[b, a]);
        let direction = chain.direction(&degrees(88.0, 0.0, 0.0));
        let found = chosen(&chain, direction, degrees(90.0, 0.0, 0.0), rule).expect("a solution");
        assert!((found[0] - expected).abs() < 1e-9, "A{} is not A{expected}", found[0]);
    }
}

#[test]
fn linuxcnc_takes_the_least_primary_or_a_sign() {
    let direction = Vec3::new(0.3, 0.4, 0.75_f64.sqrt());
    let chain = table_table_ac();
    let rule = |sign| SolutionRule::LeastAngle { primary: RotaryLetter::C, sign };
    let c = |sign, present: f64| {
        let found = chosen(&chain, direction, degrees(0.0, 0.0, present), rule(sign));
        found.expect("a solution")[2]
    };
    assert!((c(None, 150.0) - -36.869_897_645_844_02).abs() < 1e-9);
    assert!((c(Some(AngleSign::Positive), 0.0) - 143.130_102_354_155_98).abs() < 1e-9);
    assert!((c(Some(AngleSign::Negative), 0.0) - -36.869_897_645_844_02).abs() < 1e-9);

    let rule = |sign| SolutionRule::LeastMovement { sign: Some((RotaryLetter::A, sign)) };
    let present = degrees(0.0, 0.0, -40.0);
    let a = |sign| chosen(&chain, direction, present, rule(sign)).expect("a solution")[0];
    assert!((a(AngleSign::Positive) - 30.0).abs() < 1e-9);
    assert!((a(AngleSign::Negative) + 30.0).abs() < 1e-9);

    let [table, tilt] = chain.joints() else { panic!("two joints") };
    let limited = common::chain(&[*table, tilt.within(0.0, 2.0)]);
    let error = chosen(&limited, direction, present, rule(AngleSign::Negative));
    assert_eq!(error, Err(ChoiceError::NoSuchSign { letter: RotaryLetter::A }));
}

#[test]
fn no_other_turn_within_travel_is_nearer() {
    let mut random = RandomNumbers(9);
    for _ in 0..2000 {
        let low = random.between(-8.0, 0.0);
        let [c, a] =
            [RotaryLetter::C, RotaryLetter::A].map(|letter| RotaryJoint::table(letter, Vec3::ZERO));
        let c = c.within(low, low + random.between(TAU, 12.0));
        let chain = chain(&[c, a]);
        let present = [random.between(-3.0, 3.0), 0.0, random.between(-8.0, 8.0)];
        let solutions = chain.joint_solutions(random.direction()).expect("solutions");
        let found = chain.choose(&solutions, &present, SolutionRule::LEAST_MOVEMENT);
        let found = found.expect("C turns once within its travel");
        let movement =
            |angles: &[f64; 3]| (angles[0] - present[0]).abs() + (angles[2] - present[2]).abs();
        let (low, high) = c.travel.expect("limits");
        assert!((low - 1e-9..=high + 1e-9).contains(&found[2]));
        for solution in solutions.as_slice() {
            for turns in -3..=3 {
                for other in -3..=3 {
                    let [a, b, c] = solution.angles;
                    let angles = [a + TAU * f64::from(other), b, c + TAU * f64::from(turns)];
                    if (low..=high).contains(&angles[2]) {
                        assert!(movement(&found) <= movement(&angles) + 1e-9);
                    }
                }
            }
        }
    }
}
