//! The ways in which words define a tilted plane, as rotations and origins.

use chordal_geometry::{Frame, Transform, Vec3};

/// The axes that I, J and K turn about.
const AXES_OF_ANGLES: [Vec3; 3] = [Vec3::X, Vec3::Y, Vec3::Z];

/// By how much two vectors of a plane may miss a right angle, degrees (B-64484EN, G68.2 P3: an alarm from 5 degrees on).
const SQUARE_TOLERANCE_DEG: f64 = 5.0;

/// Vectors within this angle of each other, rad, have no plane of their own.
const PARALLEL_RAD: f64 = 1e-9;

/// Euler angles: about Z, then about the new X, then about the new Z (Fanuc B-63944EN, G68.2).
pub fn euler([first, second, third]: [f64; 3]) -> Transform {
    turn(Vec3::Z, third).then(&turn(Vec3::X, second)).then(&turn(Vec3::Z, first))
}

/// Angles about axes that stay where they are, in an order.
pub fn about_fixed_axes(angles: [f64; 3], order: [usize; 3]) -> Transform {
    order.into_iter().fold(Transform::identity(), |rotation, axis| {
        rotation.then(&turn(AXES_OF_ANGLES[axis], angles[axis]))
    })
}

/// X lies at the first angle about Y, a second direction at the second one about X; then the plane turns about its normal
/// by the third. `None` where both directions are one.
pub fn two_projections([first, second, third]: [f64; 3]) -> Option<Transform> {
    let along = turn(Vec3::Y, first).apply_direction(Vec3::X);
    let across = turn(Vec3::X, second).apply_direction(Vec3::Y);
    let normal = along.cross(across);
    let frame = Frame::from_normal(Vec3::ZERO, normal, along)?;
    Some(turn(Vec3::Z, third).then(&Transform::from_frame(frame)))
}

/// The origin is the first point, X goes to the second, and the third lies on the side of Y. `None` where they lie on a
/// line.
pub fn through_points([origin, on_x, on_y]: [Vec3; 3]) -> Option<Transform> {
    let along = (on_x - origin).normalized()?;
    let across = (on_y - origin).normalized()?;
    let normal = along.cross(across);
    if normal.length() < PARALLEL_RAD {
        return None;
    }
    Frame::from_normal(origin, normal, along).map(Transform::from_frame)
}

/// The direction of X, and that of Z, which is made square to it.
///
/// # Errors
/// By how many degrees they miss a right angle, where that is too much; `None` for a vector of length 0.
pub fn by_vectors(origin: Vec3, [x, z]: [Vec3; 2]) -> Result<Transform, Option<f64>> {
    let (x, z) = (x.normalized().ok_or(None)?, z.normalized().ok_or(None)?);
    let off_deg = x.dot(z).clamp(-1.0, 1.0).asin().abs().to_degrees();
    if off_deg >= SQUARE_TOLERANCE_DEG {
        return Err(Some(off_deg));
    }
    let frame = Frame::from_normal(origin, z - x * x.dot(z), x).ok_or(None)?;
    Ok(Transform::from_frame(frame))
}

/// The plane upright under a tool: its X is level, or that of the work coordinate system where the tool stands upright in
/// it; then it turns about the tool by an angle (G68.3, with Z as the axis of reference).
pub fn under_tool(origin: Vec3, tool: Vec3, angle: f64) -> Option<Transform> {
    let level = Vec3::Z.cross(tool);
    let along = if level.length() < PARALLEL_RAD { Vec3::X } else { level };
    let frame = Frame::from_normal(origin, tool, along)?;
    Some(turn(Vec3::Z, angle).then(&Transform::from_frame(frame)))
}

/// A rotation by an angle about an axis through the new origin (G68 with I, J and K).
pub fn about_axis(origin: Vec3, axis: Vec3, angle: f64) -> Option<Transform> {
    let axis = axis.normalized()?;
    Some(turn(axis, angle).then(&Transform::translation(origin)))
}

/// A shift and then a turn about the normal, in a plane (G68.2 P2 Q0).
pub fn shifted(plane: &Transform, by: Vec3, angle: f64) -> Transform {
    turn(Vec3::Z, angle).then(&Transform::translation(by)).then(plane)
}

fn turn(about: Vec3, angle: f64) -> Transform {
    Transform::rotation_about(Vec3::ZERO, about, angle)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn assert_axes(plane: &Transform, [x, z]: [[f64; 3]; 2]) {
        for (axis, expected) in [(Vec3::X, x), (Vec3::Z, z)] {
            let found = plane.apply_direction(axis).to_array();
            let near = found.iter().zip(expected).all(|(a, b)| (a - b).abs() < 5e-5);
            assert!(near, "{found:?}, not {expected:?}");
        }
    }

    #[test]
    fn three_points() {
        let points = [(10.0, 0.0, 0.0), (20.0, 0.0, 5.0), (10.0, 10.0, 0.0)];
        let plane = through_points(points.map(|(x, y, z)| Vec3::new(x, y, z))).expect("a plane");
        assert_axes(&plane, [[0.8944, 0.0, 0.4472], [-0.4472, 0.0, 0.8944]]);
        assert_eq!(plane.apply_point(Vec3::ZERO).to_array(), [10.0, 0.0, 0.0]);
        let line = [(0.0, 0.0, 0.0), (1.0, 1.0, 1.0), (-3.0, -3.0, -3.0)];
        assert_eq!(through_points(line.map(|(x, y, z)| Vec3::new(x, y, z))), None);
    }

    #[test]
    fn two_vectors_are_made_square_or_refused() {
        // 3 degrees off: Z moves, X stays.
        let (sin, cos) = 3_f64.to_radians().sin_cos();
        let z = Vec3::new(sin, 0.0, cos);
        let plane = by_vectors(Vec3::ZERO, [Vec3::X * 7.0, z]).expect("a plane");
        assert_axes(&plane, [[1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]);
        let (sin, cos) = 6_f64.to_radians().sin_cos();
        let off = by_vectors(Vec3::ZERO, [Vec3::X, Vec3::new(sin, 0.0, cos)]).unwrap_err();
        assert!(off.is_some_and(|off| (off - 6.0).abs() < 1e-9));
        assert_eq!(by_vectors(Vec3::ZERO, [Vec3::ZERO, Vec3::Z]), Err(None));
    }

    #[test]
    fn under_a_tool_x_is_level() {
        // A trunnion at A30 C0 looks along (0, -sin 30, cos 30): the plane is that of a turn about X.
        let (sin, cos) = 30_f64.to_radians().sin_cos();
        let plane = under_tool(Vec3::ZERO, Vec3::new(0.0, -sin, cos), 0.0).expect("a plane");
        assert_axes(&plane, [[1.0, 0.0, 0.0], [0.0, -0.5, 0.8660]]);
        let upright = under_tool(Vec3::ZERO, Vec3::Z, 90_f64.to_radians()).expect("a plane");
        assert_axes(&upright, [[0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]);
    }
}
