//! The chains of LinuxCNC's machines against the formulas of its kinematics modules.

mod common;

use chordal_geometry::{Transform, Vec3};
use chordal_kinematics::linuxcnc::{TrunnionParameters, five_axis_head, xyzac_trt, xyzbc_trt};
use common::{RandomNumbers, degrees};

fn turned(v: Vec3, axis: Vec3, angle: f64) -> Vec3 {
    Transform::rotation_about(Vec3::ZERO, axis, angle).apply_vector(v)
}

/// The positions of the joints by `trtfuncs.c`: R(−tilt)(R(−C)(w − r) − d') + d' + r with d' = d + tool offset.
fn joints_of_trunnion(
    parameters: &TrunnionParameters,
    world: Vec3,
    tool_offset_mm: f64,
    (axis, tilt): (Vec3, f64),
    turn: f64,
) -> Vec3 {
    let sign = if parameters.conventional_directions { 1.0 } else { -1.0 };
    let offset = parameters.offset + Vec3::Z * tool_offset_mm;
    let on_table = turned(world - parameters.rot_point, Vec3::Z, -sign * turn);
    turned(on_table - offset, axis, -sign * tilt) + offset + parameters.rot_point
}

#[test]
fn trunnions() {
    let mut random = RandomNumbers(11);
    for round in 0..2000 {
        let own = random.point(50.0);
        let mut parameters = TrunnionParameters {
            rot_point: random.point(200.0),
            offset: Vec3::new(0.0, own.y, own.z),
            conventional_directions: round % 2 == 0,
        };
        let tip = random.point(300.0);
        let length = random.between(-20.0, 150.0);
        let (tilt, turn) = (random.between(-3.0, 3.0), random.between(-6.0, 6.0));
        let world = tip + Vec3::Z * length;

        let chain = xyzac_trt(&parameters).expect("a chain");
        let found = chain.gauge_point(tip, &[tilt, 0.0, turn], chain.tool_vector(length));
        let expected = joints_of_trunnion(&parameters, world, length, (Vec3::X, tilt), turn);
        assert!(found.distance(expected) < 1e-11, "{found:?} is not {expected:?}");

        parameters.offset = Vec3::new(own.x, 0.0, own.z);
        let chain = xyzbc_trt(&parameters).expect("a chain");
        let found = chain.gauge_point(tip, &[0.0, tilt, turn], chain.tool_vector(length));
        let expected = joints_of_trunnion(&parameters, world, length, (Vec3::Y, tilt), turn);
        assert!(found.distance(expected) < 1e-11, "{found:?} is not {expected:?}");
    }
}

#[test]
fn the_inverse_of_xyzbc_in_the_source_misses_its_forward_form_by_the_offsets() {
    // By (−2 dz sin B, 0, 2 dx sin B) with the default directions: with the signs of the offset terms as if conventional.
    let parameters =
        TrunnionParameters { offset: Vec3::new(3.0, 0.0, 20.0), ..TrunnionParameters::default() };
    let chain = xyzbc_trt(&parameters).expect("a chain");
    let (sin, cos) = 30_f64.to_radians().sin_cos();
    let tip = Vec3::new(10.0, 0.0, 20.0);
    let found = chain.gauge_point(tip, &degrees(0.0, 30.0, 0.0), Vec3::ZERO);
    let (dx, dz) = (3.0, 20.0);
    // Ry(B) w, then the offset terms of the source, which are those of Ry(−B).
    let in_source = Vec3::new(
        cos * tip.x + sin * tip.z - cos * dx + sin * dz + dx,
        0.0,
        -sin * tip.x + cos * tip.z - sin * dx - cos * dz + dz,
    );
    let missed = found - in_source;
    assert!(missed.distance(Vec3::new(-2.0 * dz * sin, 0.0, 2.0 * dx * sin)) < 1e-12, "{missed:?}");
}

#[test]
fn offsets_that_a_module_does_not_have_are_ignored() {
    let parameters = TrunnionParameters { offset: Vec3::new(1.0, 2.0, 3.0), ..Default::default() };
    let point = |chain: chordal_kinematics::KinematicChain| chain.joints()[1].point;
    assert_eq!(point(xyzac_trt(&parameters).expect("a chain")), Vec3::new(0.0, 2.0, 3.0));
    assert_eq!(point(xyzbc_trt(&parameters).expect("a chain")), Vec3::new(1.0, 0.0, 3.0));
}

#[test]
fn five_axis_heads() {
    let mut random = RandomNumbers(12);
    for _ in 0..2000 {
        let (pivot, w) = (random.between(50.0, 400.0), random.between(-30.0, 120.0));
        let (b, c) = (random.between(-3.0, 3.0), random.between(-6.0, 6.0));
        let tip = random.point(300.0);
        let chain = five_axis_head(pivot).expect("a chain");
        let found = chain.gauge_point(tip, &[0.0, b, c], chain.tool_vector(w));
        // 5axiskins.c: joints = tip − (r sB cC, r sB sC, pivot − r cB), r = pivot + W.
        let r = pivot + w;
        let (sb, cb) = b.sin_cos();
        let (sc, cc) = c.sin_cos();
        let expected = tip - Vec3::new(r * sb * cc, r * sb * sc, pivot - r * cb);
        assert!(found.distance(expected) < 1e-11, "{found:?} is not {expected:?}");
    }
}
