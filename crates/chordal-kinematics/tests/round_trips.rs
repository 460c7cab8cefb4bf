//! Forward and inverse are each other's inverse, for every kind of machine.

mod common;

use core::f64::consts::PI;

use chordal_geometry::Vec3;
use chordal_kinematics::{
    DirectionError, KinematicChain, RotaryJoint, RotaryLetter, ToolPose, linuxcnc,
};
use common::{RandomNumbers, angle_between, chain};

const MAX_ERROR_MM: f64 = 1e-9;
const MAX_ERROR_RAD: f64 = 1e-9 * PI / 180.0;

/// A kind of machine, and the least and the largest angle of its reach from its first axis, rad.
struct MachineClass {
    name: &'static str,
    chain: KinematicChain,
    first: Vec3,
    reach: (f64, f64),
}

fn point(x: f64, y: f64, z: f64) -> Vec3 {
    Vec3::new(x, y, z)
}

fn machine_classes() -> Vec<MachineClass> {
    use RotaryLetter::{A, B, C};
    let round = point(-312.5, -187.25, 11.0);
    let tilting = point(7.5, -203.125, -412.75);
    let pivot = point(0.25, -0.125, 153.5);
    let nutating = point(0.0, 1.0, 1.0);
    let steep = point(0.0, 0.5, 0.75_f64.sqrt());
    let whole = (0.0, PI);
    let of = |name, joints: [RotaryJoint; 2], reach| MachineClass {
        name,
        chain: chain(&joints),
        first: joints[0].direction,
        reach,
    };
    let trunnion = linuxcnc::TrunnionParameters {
        rot_point: point(-10.0, 15.0, -120.0),
        offset: point(3.0, 4.0, 20.0),
        conventional_directions: false,
    };
    let (tilt, table) = (RotaryJoint::table(A, tilting), RotaryJoint::table(C, round));
    let two = |name, chain: Result<KinematicChain, _>| MachineClass {
        name,
        chain: chain.expect("a chain"),
        first: Vec3::Z,
        reach: whole,
    };
    vec![
        of("A/C tables", [table, tilt], whole),
        of("B/C tables", [table, RotaryJoint::table(B, tilting)], whole),
        of("head and table", [table, RotaryJoint::head(B, pivot)], whole),
        of("two heads", [RotaryJoint::head(C, pivot * 0.1), RotaryJoint::head(B, pivot)], whole),
        of(
            "nutating head",
            [RotaryJoint::head(C, pivot * 0.1), RotaryJoint::head(B, pivot).along(nutating)],
            (0.0, PI / 2.0),
        ),
        of(
            "nutating table",
            [table, RotaryJoint::table(B, tilting).along(nutating)],
            (0.0, PI / 2.0),
        ),
        of(
            "nutating head of 30 degrees, reversed",
            [
                RotaryJoint::head(C, pivot * 0.1),
                RotaryJoint::head(B, pivot).along(steep).turned_around(),
            ],
            (0.0, PI / 3.0),
        ),
        of("B/A heads", [RotaryJoint::head(B, pivot), RotaryJoint::head(A, pivot * 0.5)], whole),
        of("A/B tables", [RotaryJoint::table(A, tilting), RotaryJoint::table(B, round)], whole),
        // The tool is 90 degrees from B and 40 degrees from its carrier: it reaches 50 to 130 degrees.
        of(
            "leaning carrier",
            [
                RotaryJoint::table(A, tilting).along(point(
                    0.0,
                    40_f64.to_radians().cos(),
                    40_f64.to_radians().sin(),
                )),
                RotaryJoint::head(B, pivot),
            ],
            (PI / 2.0 - 40_f64.to_radians(), PI / 2.0 + 40_f64.to_radians()),
        ),
        two("xyzac-trt", linuxcnc::xyzac_trt(&trunnion)),
        two("xyzbc-trt", linuxcnc::xyzbc_trt(&trunnion)),
        two("5axiskins", linuxcnc::five_axis_head(250.0)),
    ]
}

/// What round trips have found.
#[derive(Default)]
struct RoundTripCount {
    reached: usize,
    unreachable: usize,
    largest_mm: f64,
    largest_rad: f64,
}

/// Solves a pose and compares what every solution gives.
fn round_trip(class: &MachineClass, pose: ToolPose, tool: Vec3, count: &mut RoundTripCount) {
    // An independent criterion: the angle to the first axis, against the tilt that the axes allow.
    let unit = class.first.normalized().expect("a direction");
    let polar = angle_between(unit, pose.direction);
    let (low, high) = class.reach;
    let outside = (low - polar).max(polar - high);
    match class.chain.axis_positions(&pose, tool) {
        Ok(solutions) => {
            assert!(outside < 1e-9, "{}: reached {outside} rad outside", class.name);
            let mut found = 0;
            for axes in solutions {
                let again = class.chain.pose(axes.gauge_point, &axes.angles, tool);
                let off_rad = angle_between(again.direction, pose.direction);
                let off_mm = again.tip.distance(pose.tip);
                assert!(off_mm <= MAX_ERROR_MM, "{} {pose:?}: {off_mm} mm", class.name);
                assert!(off_rad <= MAX_ERROR_RAD, "{} {pose:?}: {off_rad} rad", class.name);
                count.largest_mm = count.largest_mm.max(off_mm);
                count.largest_rad = count.largest_rad.max(off_rad);
                found += 1;
            }
            assert!(found > 0);
            count.reached += 1;
        }
        Err(DirectionError::Unreachable { beyond_rad }) => {
            assert!(outside > 0.0, "{}: {pose:?} is within reach", class.name);
            assert!((beyond_rad - outside).abs() < 1e-7, "{beyond_rad} is not {outside}");
            count.unreachable += 1;
        }
        Err(error) => panic!("{}: {error}", class.name),
    }
}

#[test]
fn a_grid_of_directions_with_its_poles() {
    for class in machine_classes() {
        let tool = class.chain.tool_vector(123.456);
        let mut count = RoundTripCount::default();
        // 24 angles from the pole, both poles among them, and 216 about it.
        for row in 0..24 {
            for column in 0..216 {
                let polar = PI * f64::from(row) / 23.0;
                let azimuth = 2.0 * PI * f64::from(column) / 216.0;
                let (sin, cos) = polar.sin_cos();
                let direction = match row {
                    0 => Vec3::Z,
                    23 => -Vec3::Z,
                    _ => point(sin * azimuth.cos(), sin * azimuth.sin(), cos),
                };
                let tip = point(-250.0 + f64::from(column), -150.0, -300.0 + f64::from(row));
                round_trip(&class, ToolPose { tip, direction }, tool, &mut count);
            }
        }
        assert_eq!(count.reached + count.unreachable, 5184);
        print_count(&class, &count);
    }
}

#[test]
fn a_grid_of_angles_with_their_poles_and_limits() {
    for class in machine_classes() {
        let tool = class.chain.tool_vector(123.456);
        let mut count = RoundTripCount::default();
        let [first, second] = class.chain.joints() else { panic!("two joints") };
        for row in 0..24 {
            for column in 0..216 {
                let mut angles = [0.0; 3];
                angles[second.letter.index()] = (15.0 * f64::from(row) - 180.0).to_radians();
                angles[first.letter.index()] = (360.0 / 216.0 * f64::from(column)).to_radians();
                let pose = class.chain.pose(point(-250.0, -150.0, f64::from(row)), &angles, tool);
                round_trip(&class, pose, tool, &mut count);
            }
        }
        assert_eq!((count.reached, count.unreachable), (5184, 0), "{}", class.name);
        print_count(&class, &count);
    }
}

#[test]
fn random_directions() {
    let mut random = RandomNumbers(20);
    for class in machine_classes() {
        let mut count = RoundTripCount::default();
        for _ in 0..100_000 {
            let pose = ToolPose { tip: random.point(400.0), direction: random.direction() };
            let tool = random.point(150.0);
            round_trip(&class, pose, tool, &mut count);
        }
        print_count(&class, &count);
        let (low, high) = class.reach;
        // The part of the sphere within reach: a zone.
        let share = (low.cos() - high.cos()) / 2.0;
        let found = count.reached as f64 / 1e5;
        assert!((found - share).abs() < 0.01, "{}: {found} is not {share}", class.name);
    }
}

#[test]
fn random_chains() {
    let mut random = RandomNumbers(7);
    let mut count = [0, 0];
    for _ in 0..20_000 {
        let head = |joint: RotaryJoint| match random_choice(joint.point) {
            true => RotaryJoint { side: chordal_kinematics::RotaryMount::Head, ..joint },
            false => joint,
        };
        let joints = [
            RotaryJoint::table(RotaryLetter::C, random.point(300.0)).along(random.direction()),
            head(RotaryJoint::table(RotaryLetter::A, random.point(300.0)))
                .along(random.direction()),
        ];
        let chain = chain(&joints).with_tool_direction(random.direction()).expect("a tool");
        let pose = ToolPose { tip: random.point(400.0), direction: random.direction() };
        let tool = random.point(150.0);
        // The formula with three numbers, as a second method: al u1 + be u2 + ga u1 x u2 has the scalar products of the
        // triangle with both axes.
        let [u1, u2] = joints.map(|joint| joint.direction);
        let g = u1.dot(u2);
        let (t1, k2) = (u1.dot(pose.direction), u2.dot(chain.tool_direction()));
        let (al, be) = ((g * k2 - t1) / (g * g - 1.0), (g * t1 - k2) / (g * g - 1.0));
        let square = 1.0 - al * al - be * be - 2.0 * al * be * g;
        match chain.axis_positions(&pose, tool) {
            Ok(solutions) => {
                count[0] += 1;
                let mut found: Vec<f64> = Vec::new();
                for axes in solutions {
                    let again = chain.pose(axes.gauge_point, &axes.angles, tool);
                    assert!(again.tip.distance(pose.tip) <= MAX_ERROR_MM);
                    assert!(angle_between(again.direction, pose.direction) <= MAX_ERROR_RAD);
                    let second = chain.joints()[1];
                    let z = chordal_geometry::Transform::rotation_about(
                        Vec3::ZERO,
                        second.direction,
                        axes.angles[0],
                    )
                    .apply_direction(chain.tool_direction());
                    found.push(z.dot(u1.cross(u2)));
                }
                // Both solutions: +ga and -ga.
                let ga = square.max(0.0).sqrt() * u1.cross(u2).length();
                assert_eq!(found.len(), 2);
                found.sort_by(f64::total_cmp);
                assert!((found[0] + ga).abs() < 1e-6 && (found[1] - ga).abs() < 1e-6);
            }
            Err(DirectionError::Unreachable { .. }) => {
                count[1] += 1;
                assert!(square < 1e-9, "{square}");
            }
            Err(error) => panic!("{error}"),
        }
    }
    assert!(count[0] > 5_000 && count[1] > 1_000, "{count:?}");
}

fn random_choice(point: Vec3) -> bool {
    point.x > 0.0
}

#[test]
fn directions_near_poles() {
    let mut random = RandomNumbers(3);
    for class in machine_classes() {
        let mut count = RoundTripCount::default();
        for power in 0..9 {
            for _ in 0..200 {
                // From 1 rad down to 1e-8 rad from the pole, which the solver does not treat as the pole.
                let polar = 10_f64.powi(-power);
                let azimuth = random.between(-PI, PI);
                let side = if random.unit() < 0.5 { 1.0 } else { -1.0 };
                let (sin, cos) = polar.sin_cos();
                let direction = point(sin * azimuth.cos(), sin * azimuth.sin(), side * cos);
                let pose = ToolPose { tip: random.point(400.0), direction };
                round_trip(&class, pose, random.point(150.0), &mut count);
            }
        }
        print_count(&class, &count);
    }
}

fn print_count(class: &MachineClass, count: &RoundTripCount) {
    println!(
        "{}: {} reached, {} unreachable, {:.2e} mm, {:.2e} deg",
        class.name,
        count.reached,
        count.unreachable,
        count.largest_mm,
        count.largest_rad.to_degrees()
    );
}

#[test]
fn a_pole_leaves_the_first_axis_free() {
    let chain = common::table_table_ac();
    for (direction, tilt) in [(Vec3::Z, 0.0), (-Vec3::Z, PI)] {
        let solutions = chain.joint_solutions(direction).expect("a solution");
        let [solution] = solutions.as_slice() else { panic!("{solutions:?}") };
        assert_eq!(solution.free, Some(RotaryLetter::C));
        assert!((solution.angles[0].abs() - tilt).abs() < 1e-15);
    }
    // The documented limit: a sine of 1e-9.
    let near = |sine: f64| chain.joint_solutions(point(sine, 0.0, 1.0)).expect("a solution");
    assert_eq!(near(0.9e-9).as_slice().len(), 1);
    assert_eq!(near(1.1e-9).as_slice().len(), 2);
}

#[test]
fn both_solutions_are_one_at_the_limit_of_the_reach() {
    let chain = common::nutating_head();
    let direction = chain.direction(&common::degrees(0.0, 180.0, 25.0));
    let solutions = chain.joint_solutions(direction).expect("a solution");
    let [solution] = solutions.as_slice() else { panic!("{solutions:?}") };
    assert!((solution.angles[1].abs() - PI).abs() < 1e-7, "{solution:?}");
    // A ten-millionth of a degree beyond it is beyond it.
    let beyond = direction + Vec3::Z * -1e-7_f64.to_radians();
    assert!(chain.joint_solutions(beyond).is_err());
}

#[test]
fn a_tool_along_the_second_axis_leaves_it_free() {
    let chain = chain(&[
        RotaryJoint::table(RotaryLetter::A, Vec3::ZERO),
        RotaryJoint::head(RotaryLetter::C, Vec3::ZERO),
    ]);
    let direction = point(0.0, -(30_f64.to_radians().sin()), 30_f64.to_radians().cos());
    let solutions = chain.joint_solutions(direction).expect("a solution");
    let [solution] = solutions.as_slice() else { panic!("{solutions:?}") };
    assert_eq!(solution.free, Some(RotaryLetter::C));
    assert!((solution.angles[0].to_degrees() - 30.0).abs() < 1e-9);
    let error = chain.joint_solutions(point(0.1, 0.0, 1.0)).expect_err("off the plane");
    let DirectionError::Unreachable { beyond_rad } = error else { panic!("{error}") };
    assert!((beyond_rad - 0.1_f64.atan()).abs() < 1e-12);
}

#[test]
fn one_axis_and_none() {
    let tilt =
        chain(&[RotaryJoint::table(RotaryLetter::A, point(0.0, -50.0, -70.0)).turned_around()]);
    let pose = tilt.pose(point(1.0, 2.0, 3.0), &common::degrees(-40.0, 0.0, 0.0), Vec3::ZERO);
    let found: Vec<_> = tilt.axis_positions(&pose, Vec3::ZERO).expect("a solution").collect();
    assert_eq!(found.len(), 1);
    assert!((found[0].angles[0].to_degrees() + 40.0).abs() < 1e-9);
    assert!(found[0].gauge_point.distance(point(1.0, 2.0, 3.0)) < 1e-12);
    let error = tilt.joint_solutions(Vec3::X).expect_err("A does not turn the tool to X");
    let DirectionError::Unreachable { beyond_rad } = error else { panic!("{error}") };
    assert!((beyond_rad - PI / 2.0).abs() < 1e-12);

    let just_off = point(1e-10, 1.0, 1.0);
    assert!(tilt.joint_solutions(just_off).is_err());
    let round = chain(&[RotaryJoint::table(RotaryLetter::C, Vec3::ZERO)]);
    let solutions = round.joint_solutions(Vec3::Z * 7.0).expect("a solution");
    assert_eq!(solutions.as_slice()[0].free, Some(RotaryLetter::C));
    assert!(round.joint_solutions(point(0.9e-9, 0.0, 1.0)).is_ok());
    assert!(round.joint_solutions(point(1.1e-9, 0.0, 1.0)).is_err());

    let none = KinematicChain::CARTESIAN;
    assert_eq!(none.joint_solutions(Vec3::Z).expect("a solution").as_slice()[0].free, None);
    let error = none.joint_solutions(point(0.0, 1.0, 1.0)).expect_err("no axis turns the tool");
    let DirectionError::Unreachable { beyond_rad } = error else { panic!("{error}") };
    assert!((beyond_rad - PI / 4.0).abs() < 1e-12);
    assert_eq!(none.joint_solutions(Vec3::ZERO), Err(DirectionError::NoDirection));
}

#[test]
fn the_inverse_refuses_parallel_axes() {
    let parallel = chain(&[
        RotaryJoint::table(RotaryLetter::C, Vec3::ZERO),
        RotaryJoint::head(RotaryLetter::B, Vec3::X).along(Vec3::Z * -2.0),
    ]);
    assert_eq!(parallel.joint_solutions(Vec3::Z), Err(DirectionError::ParallelAxes));
    // Forward works: -90 about the one and +90 about the other.
    let tip = parallel.pose(Vec3::ZERO, &common::degrees(0.0, 90.0, 90.0), Vec3::ZERO).tip;
    assert!(tip.distance(point(-1.0, 1.0, 0.0)) < 1e-15, "{tip:?}");
}

#[test]
fn what_is_no_chain() {
    use chordal_kinematics::ChainError;
    let table = RotaryJoint::table(RotaryLetter::C, Vec3::ZERO);
    let head = RotaryJoint::head(RotaryLetter::B, Vec3::ZERO);
    let error = |joints: &[RotaryJoint]| KinematicChain::new(joints).expect_err("no chain");
    assert_eq!(error(&[table, head, head]), ChainError::TooManyJoints { count: 3 });
    let before = ChainError::HeadBeforeTable { head: RotaryLetter::B, table: RotaryLetter::C };
    assert_eq!(error(&[head, table]), before);
    assert_eq!(error(&[table, table]), ChainError::SameLetter { letter: RotaryLetter::C });
    let letter = RotaryLetter::C;
    assert_eq!(error(&[table.along(Vec3::ZERO)]), ChainError::NoDirection { letter });
    let nan = RotaryJoint { point: Vec3::X * f64::NAN, ..table };
    assert_eq!(error(&[nan]), ChainError::NoPoint { letter });
    assert_eq!(error(&[table.within(1.0, -1.0)]), ChainError::NoTravel { letter });
    let tool = KinematicChain::CARTESIAN.with_tool_direction(Vec3::ZERO);
    assert_eq!(tool, Err(ChainError::NoToolDirection));
}
