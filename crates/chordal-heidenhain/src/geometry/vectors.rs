//! Points and directions of a plane.

use chordal_geometry::Vec2;

/// Points closer than this are one, mm.
pub const COINCIDENT_POINTS_MM: f64 = 1e-6;

/// The direction from one point to another; `None` if they are one.
pub(super) fn unit_vector(from: Vec2, to: Vec2) -> Option<Vec2> {
    let along = to - from;
    (along.length() > COINCIDENT_POINTS_MM).then(|| along.normalized())?
}

/// A point turned about a centre by an angle, rad.
pub(super) fn turned(point: Vec2, center: Vec2, angle_rad: f64) -> Vec2 {
    let (sin, cos) = libm::sincos(angle_rad);
    let away = point - center;
    center + away * cos + away.turned_left() * sin
}

/// The same with the coordinates of the points, mm.
pub fn turned_about(point: [f64; 2], center: [f64; 2], angle_rad: f64) -> [f64; 2] {
    turned(Vec2::from_array(point), Vec2::from_array(center), angle_rad).to_array()
}
