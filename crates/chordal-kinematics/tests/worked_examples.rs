//! Worked examples of kinematic chains: G54 at X-300 Y-200 Z-380, a tool 100 long.

#![allow(clippy::approx_constant, reason = "the numbers of the examples have four digits")]

mod common;

use chordal_geometry::{Transform, Vec3};
use chordal_kinematics::{JointPath, KinematicChain, SolutionRule, TipLine, ToolPose, linuxcnc};
use common::{
    TOOL_LENGTH_MM, WORK_OFFSET, chain, degrees, four_digits, four_digits_deg, gauge_point,
    head_head, head_table, nutating_head, nutating_table, table_table_ac, table_table_bc,
};

const POINT: Vec3 = Vec3::new(10.0, 0.0, 20.0);

fn tool(chain: &KinematicChain) -> Vec3 {
    chain.tool_vector(TOOL_LENGTH_MM)
}

/// A rotation about an axis through zero, in degrees.
fn rotation(axis: Vec3, angle_deg: f64) -> Transform {
    Transform::rotation_about(Vec3::ZERO, axis, angle_deg.to_radians())
}

/// The plane of G68.2 with I, J and K: Rz(I) Rx(J) Rz(K).
fn euler_plane(i: f64, j: f64, k: f64) -> Transform {
    rotation(Vec3::Z, k).then(&rotation(Vec3::X, j)).then(&rotation(Vec3::Z, i))
}

/// The plane of G68.2 P1 with I, J and K about fixed axes: Rz(K) Ry(J) Rx(I).
fn fixed_axes_plane(i: f64, j: f64, k: f64) -> Transform {
    rotation(Vec3::X, i).then(&rotation(Vec3::Y, j)).then(&rotation(Vec3::Z, k))
}

#[test]
fn example_27_all_zero() {
    for chain in [table_table_ac(), table_table_bc(), head_table(), head_head(), nutating_head()] {
        four_digits(gauge_point(&chain, POINT, &[0.0; 3]), -290.0, -200.0, -260.0);
    }
}

#[test]
fn example_28_tables_a_and_c() {
    let (chain, angles) = (table_table_ac(), degrees(30.0, 0.0, 45.0));
    four_digits(gauge_point(&chain, POINT, &angles), -292.9289, -186.1237, -261.8234);
    four_digits(chain.direction(&angles), 0.3536, -0.3536, 0.8660);
}

#[test]
fn example_29_tables_b_and_c() {
    let (chain, angles) = (table_table_bc(), degrees(0.0, 30.0, 45.0));
    four_digits(gauge_point(&chain, POINT, &angles), -313.8763, -207.0711, -261.8234);
    four_digits(chain.direction(&angles), 0.3536, 0.3536, 0.8660);
}

#[test]
fn example_30_head_and_table_and_two_heads() {
    let angles = degrees(0.0, 30.0, 45.0);
    four_digits(gauge_point(&head_table(), POINT, &angles), -167.9289, -207.0711, -293.4936);
    four_digits(gauge_point(&head_head(), POINT, &angles), -201.6117, -111.6117, -293.4936);
}

#[test]
fn example_31_nutating_head() {
    let (chain, angles) = (nutating_head(), degrees(0.0, 90.0, 30.0));
    four_digits(gauge_point(&chain, POINT, &angles), -199.4069, -3.3585, -385.0);
    four_digits(chain.direction(&angles), 0.3624, 0.7866, 0.5);
}

#[test]
fn example_31_nutating_table() {
    let (chain, angles) = (nutating_table(), degrees(0.0, 90.0, 0.0));
    four_digits(gauge_point(&chain, POINT, &angles), -328.2843, -187.0711, -272.9289);
    four_digits(chain.direction(&angles), 0.7071, 0.5, 0.5);
}

/// Whether the solutions for t (.3, .4, .8660) are these two, in degrees, in either order.
#[track_caller]
fn solutions_are(chain: &KinematicChain, expected: [[f64; 3]; 2]) {
    let direction = Vec3::new(0.3, 0.4, 0.75_f64.sqrt());
    let found = chain.joint_solutions(direction).expect("solutions");
    let found: Vec<[f64; 3]> = found
        .as_slice()
        .iter()
        .inspect(|solution| assert_eq!(solution.free, None))
        .map(|solution| solution.angles.map(f64::to_degrees))
        .collect();
    assert_eq!(found.len(), 2);
    for angles in expected {
        let is_same = |other: &&[f64; 3]| {
            let turns = |a: f64, b: f64| (a - b) / 360.0 - ((a - b) / 360.0).round();
            angles.iter().zip(**other).all(|(a, b)| (turns(*a, b) * 360.0).abs() <= 5e-5 + 1e-9)
        };
        assert_eq!(found.iter().filter(is_same).count(), 1, "{angles:?} in {found:?}");
    }
}

#[test]
fn example_32_solutions_of_a_and_c() {
    solutions_are(&table_table_ac(), [[30.0, 0.0, 143.1301], [-30.0, 0.0, -36.8699]]);
}

#[test]
fn example_32_solutions_of_b_and_c() {
    for chain in [table_table_bc(), head_table(), head_head()] {
        solutions_are(&chain, [[0.0, 30.0, 53.1301], [0.0, -30.0, -126.8699]]);
    }
}

#[test]
fn example_32_solutions_of_b_and_a() {
    use chordal_kinematics::{RotaryJoint, RotaryLetter};
    let chain = chain(&[
        RotaryJoint::head(RotaryLetter::B, Vec3::ZERO),
        RotaryJoint::head(RotaryLetter::A, Vec3::ZERO),
    ]);
    solutions_are(&chain, [[-23.5782, 19.1066, 0.0], [203.5782, 199.1066, 0.0]]);
}

#[test]
fn example_32_solutions_of_a_nutating_head() {
    for chain in [nutating_head(), nutating_table()] {
        solutions_are(&chain, [[0.0, 42.9414, 37.5878], [0.0, -42.9414, -111.3276]]);
    }
}

#[test]
fn example_32_choice_of_fanuc() {
    use chordal_kinematics::RotaryLetter;
    let direction = Vec3::new(0.3, 0.4, 0.75_f64.sqrt());
    let present = degrees(0.0, 0.0, -40.0);
    for master in [RotaryLetter::A, RotaryLetter::C] {
        let rule = SolutionRule::MasterMovement { master };
        let chain = table_table_ac();
        let solutions = chain.joint_solutions(direction).expect("solutions");
        let angles = chain.choose(&solutions, &present, rule).expect("a solution");
        four_digits_deg(angles[0], -30.0);
        four_digits_deg(angles[2], -36.8699);

        let [c, a] = chain.joints() else { panic!("two joints") };
        let limited = common::chain(&[*c, a.within(0.0, 120_f64.to_radians())]);
        let angles = limited.choose(&solutions, &present, rule).expect("a solution");
        four_digits_deg(angles[0], 30.0);
        // The position 143.1301, with the turn that is nearest to -40: 176.9 and not 183.1 away.
        four_digits_deg(angles[2], 143.1301 - 360.0);
    }
}

#[test]
fn example_33_a_line_with_tool_centre_point_control() {
    let chain = table_table_ac();
    let path = JointPath {
        chain,
        tip: TipLine { from: WORK_OFFSET, to: WORK_OFFSET + Vec3::X * 50.0 },
        from: [0.0; 3],
        to: degrees(30.0, 0.0, 90.0),
        tool: tool(&chain),
    };
    four_digits(path.positions(0.0).gauge_point, -300.0, -200.0, -280.0);
    four_digits(path.positions(0.5).gauge_point, -282.3223, -211.8989, -276.1062);
    four_digits(path.positions(1.0).gauge_point, -300.0, -233.3013, -257.6795);
    let (from, to) = (path.positions(0.0), path.positions(1.0));
    let deviation = chain.straight_deviation(&from, &to, path.tool, 1e-6);
    assert!((deviation - 18.2874).abs() <= 5e-5 + 1e-6, "{deviation}");
}

#[test]
fn example_34_the_tip_rests_while_a_turns() {
    let chain = table_table_ac();
    let found = gauge_point(&chain, POINT, &degrees(30.0, 0.0, 0.0));
    four_digits(found, -290.0, -180.0, -265.3590);
}

#[test]
fn example_35_the_tip_without_tool_centre_point_control() {
    let (chain, angles) = (table_table_ac(), degrees(30.0, 0.0, 45.0));
    let unturned = gauge_point(&chain, POINT, &[0.0; 3]);
    let tip = chain.pose(unturned, &angles, tool(&chain)).tip - WORK_OFFSET;
    four_digits(tip, 21.2132, -7.0711, 14.6410);
}

/// The gauge point for a point of a tilted plane at these angles, which must give the tool the normal of the plane.
#[track_caller]
fn in_plane(
    chain: &KinematicChain,
    plane: &Transform,
    origin: Vec3,
    point: Vec3,
    angles: [f64; 3],
) -> Vec3 {
    let angles = angles.map(f64::to_radians);
    let off = common::angle_between(chain.direction(&angles), plane.apply_direction(Vec3::Z));
    assert!(off < 1e-14, "the tool is {off} rad off the normal of the plane");
    gauge_point(chain, origin + plane.apply_point(point), &angles)
}

const PLANE_ORIGIN: Vec3 = Vec3::new(50.0, 0.0, 0.0);
const PLANE_POINT: Vec3 = Vec3::new(10.0, 5.0, 2.0);

/// Angles of the solutions for the normal of a plane, in degrees.
fn plane_angles(chain: &KinematicChain, plane: &Transform, rule: SolutionRule) -> [f64; 3] {
    let solutions = chain.joint_solutions(plane.apply_direction(Vec3::Z)).expect("solutions");
    chain.choose(&solutions, &[0.0; 3], rule).expect("a solution").map(f64::to_degrees)
}

#[test]
fn example_38_a_tilted_plane_on_tables_a_and_c() {
    let (chain, plane) = (table_table_ac(), euler_plane(0.0, 30.0, 0.0));
    let angles = plane_angles(&chain, &plane, SolutionRule::LEAST_MOVEMENT);
    assert!((angles[0] - 30.0).abs() < 1e-9 && angles[2].abs() < 1e-9, "{angles:?}");
    four_digits(PLANE_ORIGIN + plane.apply_point(PLANE_POINT), 60.0, 3.3301, 4.2321);
    let found = in_plane(&chain, &plane, PLANE_ORIGIN, PLANE_POINT, [30.0, 0.0, 0.0]);
    four_digits(found, -240.0, -185.0, -280.6795);
}

#[test]
fn example_39_a_turned_plane_with_both_solutions() {
    let (chain, plane) = (table_table_ac(), euler_plane(90.0, 30.0, 0.0));
    let found = in_plane(&chain, &plane, PLANE_ORIGIN, PLANE_POINT, [30.0, 0.0, 90.0]);
    four_digits(found, -290.0, -228.3013, -255.6795);
    let other = in_plane(&chain, &plane, PLANE_ORIGIN, PLANE_POINT, [-30.0, 0.0, -90.0]);
    four_digits(other, -310.0, -171.6987, -255.6795);
    // X of the plane is −X of the machine there.
    let turned = chain.part_transform(&degrees(-30.0, 0.0, -90.0)).inverse();
    four_digits(turned.apply_direction(plane.apply_direction(Vec3::X)), -1.0, 0.0, 0.0);
}

#[test]
fn example_40_a_tilted_plane_on_two_heads() {
    let (chain, plane) = (head_head(), fixed_axes_plane(0.0, 30.0, 0.0));
    let angles = plane_angles(&chain, &plane, SolutionRule::LEAST_MOVEMENT);
    assert!((angles[1] - 30.0).abs() < 1e-9 && angles[2].abs() < 1e-9, "{angles:?}");
    let found = in_plane(&chain, &plane, PLANE_ORIGIN, PLANE_POINT, [0.0, 30.0, 0.0]);
    four_digits(found, -115.3397, -195.0, -316.7616);
}

#[test]
fn example_41_the_tip_wanders_with_g53_1_and_rests_with_g53_6() {
    let (chain, angles) = (head_head(), degrees(0.0, 30.0, 0.0));
    let start = gauge_point(&chain, Vec3::Z * 50.0, &[0.0; 3]);
    four_digits(start, -300.0, -200.0, -230.0);
    let wandered = chain.pose(start, &angles, tool(&chain)).tip - WORK_OFFSET;
    four_digits(wandered, -125.0, 0.0, 83.4936);
    let rests = gauge_point(&chain, Vec3::Z * 50.0, &angles);
    four_digits(rests, -175.0, -200.0, -263.4936);
}

#[test]
fn example_42_only_the_origin_rides_the_table() {
    let chain = table_table_bc();
    let origin = Vec3::new(-290.0, -210.0, -380.0);
    let point = Vec3::new(1.0, 0.0, 2.0);
    let with_origin =
        |angles: [f64; 3]| chain.gauge_point(origin, &angles, Vec3::ZERO) + point - tool(&chain);
    four_digits(with_origin(degrees(0.0, 90.0, 0.0)), -319.0, -210.0, -288.0);
    four_digits(with_origin(degrees(0.0, 90.0, 90.0)), -319.0, -210.0, -308.0);
    let tip = origin + point;
    let followed = chain.gauge_point(tip, &degrees(0.0, 90.0, 0.0), tool(&chain));
    four_digits(followed, -322.0, -210.0, -289.0);
}

#[test]
fn example_43_a_fixture_error_turns_with_the_table() {
    let to_machine = table_table_ac().part_transform(&degrees(0.0, 0.0, 90.0)).inverse();
    four_digits(to_machine.apply_vector(Vec3::new(1.0, 0.5, 0.0)), 0.5, -1.0, 0.0);
}

#[test]
fn example_44_kinematics_of_linuxcnc() {
    let parameters = linuxcnc::TrunnionParameters {
        offset: Vec3::Z * 20.0,
        ..linuxcnc::TrunnionParameters::default()
    };
    let angles = degrees(30.0, 0.0, 45.0);
    let joints = |parameters: &linuxcnc::TrunnionParameters| {
        let chain = linuxcnc::xyzac_trt(parameters).expect("a chain");
        chain.gauge_point(POINT, &angles, Vec3::ZERO)
    };
    four_digits(joints(&parameters), 7.0711, 6.1237, 23.5355);
    let conventional = linuxcnc::TrunnionParameters { conventional_directions: true, ..parameters };
    four_digits(joints(&conventional), 7.0711, -6.1237, 23.5355);

    let head = linuxcnc::five_axis_head(250.0).expect("a chain");
    let found = head.gauge_point(Vec3::ZERO, &degrees(0.0, 30.0, 45.0), Vec3::ZERO);
    four_digits(found, -88.3883, -88.3883, -33.4936);
}

#[test]
fn example_45_the_turn_is_fast_beside_a_pole() {
    use chordal_kinematics::OrientationArc;
    // A great circle whose nearest point to the pole is 1 degree from it, at its middle; 20 degrees long.
    let chain = table_table_ac();
    let beside = rotation(Vec3::Y, 1.0);
    let at = |deg: f64| beside.apply_direction(rotation(Vec3::X, deg).apply_direction(Vec3::Z));
    let start = chain.joint_solutions(at(-10.0)).expect("solutions").as_slice()[0].angles;
    let arc = OrientationArc::new(&chain, at(-10.0), at(10.0), &start).expect("an arc");
    let jet = arc.angle_jet(0.5).expect("no pole");
    // 10 deg/s along the arc of 20 degrees: σ grows by 1/2 per second.
    let speed_deg_per_s = (0.5 * jet.first[2]).abs().to_degrees();
    // On the sphere the speed is v / sin e; the small angle of the example gives v / e.
    let expected = 10.0 / 1_f64.to_radians().sin();
    assert!((speed_deg_per_s - expected).abs() < 1e-9, "{speed_deg_per_s} is not {expected}");
    assert!(
        (speed_deg_per_s * 1_f64.to_radians().sin() / 1_f64.to_radians() - 572.96).abs() < 5e-3
    );
}

#[test]
fn a_pose_has_a_unit_direction() {
    let ToolPose { direction, .. } = nutating_head().pose(POINT, &degrees(0.0, 77.0, 5.0), POINT);
    assert!((direction.length() - 1.0).abs() < 1e-15);
}
