//! Points and directions of a plane.

/// Points closer than this are one, mm.
pub const COINCIDENT_POINTS_MM: f64 = 1e-6;

/// The distance of two points.
pub fn distance(one: [f64; 2], two: [f64; 2]) -> f64 {
    libm::hypot(two[0] - one[0], two[1] - one[1])
}

/// The direction from one point to another; `None` if they are one.
pub fn unit_vector(from: [f64; 2], to: [f64; 2]) -> Option<[f64; 2]> {
    let length = distance(from, to);
    (length > COINCIDENT_POINTS_MM)
        .then(|| [(to[0] - from[0]) / length, (to[1] - from[1]) / length])
}

/// The point at a distance in a direction.
pub fn point_ahead(point: [f64; 2], direction: [f64; 2], by: f64) -> [f64; 2] {
    [point[0] + direction[0] * by, point[1] + direction[1] * by]
}

/// A direction turned by a quarter to the left.
pub const fn left_normal(direction: [f64; 2]) -> [f64; 2] {
    [-direction[1], direction[0]]
}

/// A point turned about a centre by an angle, rad.
pub fn turned_about(point: [f64; 2], center: [f64; 2], angle_rad: f64) -> [f64; 2] {
    let (sin, cos) = libm::sincos(angle_rad);
    let [x, y] = [point[0] - center[0], point[1] - center[1]];
    [center[0] + x * cos - y * sin, center[1] + x * sin + y * cos]
}
