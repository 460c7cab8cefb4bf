//! Similarity transformations, which do not change the kind of a curve.

use crate::{Frame, Vec3, math};

/// A similarity: rotation or reflection, then a uniform scale above zero, then a translation.
///
/// Different scales per axis are not supported, because they would turn a circle into an ellipse.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Transform {
    /// Images of the unit vectors X, Y, Z before scaling; orthonormal.
    columns: [Vec3; 3],
    /// The scale factor, above zero.
    scale: f64,
    /// The image of the origin, mm.
    translation: Vec3,
}

impl Transform {
    /// The identity.
    #[must_use]
    pub const fn identity() -> Self {
        Self { columns: [Vec3::X, Vec3::Y, Vec3::Z], scale: 1.0, translation: Vec3::ZERO }
    }

    /// A translation by `by`, mm.
    #[must_use]
    pub const fn translation(by: Vec3) -> Self {
        Self { columns: [Vec3::X, Vec3::Y, Vec3::Z], scale: 1.0, translation: by }
    }

    /// A rotation by `angle` radians about the line through `point` (mm) along `axis` (of any length),
    /// counter-clockwise seen against `axis`. A zero axis gives the identity.
    #[must_use]
    pub fn rotation_about(point: Vec3, axis: Vec3, angle: f64) -> Self {
        if angle == 0.0 {
            return Self::identity();
        }
        let Some(w) = axis.normalized() else { return Self::identity() };
        let (sin, cos) = math::sin_cos(angle);
        let turn = |e: Vec3| {
            let along = w * e.dot(w);
            along + (e - along) * cos + w.cross(e) * sin
        };
        Self::about(point, [turn(Vec3::X), turn(Vec3::Y), turn(Vec3::Z)], 1.0)
    }

    /// A reflection in the plane through `point` (mm) with this `normal` (of any length). A zero normal gives the
    /// identity.
    #[must_use]
    pub fn mirror(normal: Vec3, point: Vec3) -> Self {
        let Some(n) = normal.normalized() else { return Self::identity() };
        let flip = |e: Vec3| e - n * (2.0 * e.dot(n));
        Self::about(point, [flip(Vec3::X), flip(Vec3::Y), flip(Vec3::Z)], 1.0)
    }

    /// A scaling by `k` about the origin. A negative `k` scales by `|k|` and reflects through the origin. `None` if `k`
    /// is zero or not finite.
    #[must_use]
    pub fn scale(k: f64) -> Option<Self> {
        if k == 0.0 || !k.is_finite() {
            return None;
        }
        let s = if k < 0.0 { -1.0 } else { 1.0 };
        Some(Self {
            columns: [Vec3::X * s, Vec3::Y * s, Vec3::Z * s],
            scale: k.abs(),
            translation: Vec3::ZERO,
        })
    }

    /// Converts coordinates in `frame` to space (see [`Frame::to_world`]).
    #[must_use]
    pub const fn from_frame(frame: Frame) -> Self {
        Self { columns: [frame.u, frame.v, frame.w], scale: 1.0, translation: frame.origin }
    }

    fn about(point: Vec3, columns: [Vec3; 3], scale: f64) -> Self {
        let mut t = Self { columns, scale, translation: Vec3::ZERO };
        t.translation = point - t.apply_vector(point);
        t
    }

    /// This transform followed by `next`.
    #[must_use]
    pub fn then(&self, next: &Transform) -> Self {
        Self {
            columns: self.columns.map(|c| next.apply_direction(c)),
            scale: self.scale * next.scale,
            translation: next.apply_point(self.translation),
        }
    }

    /// The image of a point, mm.
    #[must_use]
    pub fn apply_point(&self, p: Vec3) -> Vec3 {
        self.translation + self.apply_vector(p)
    }

    /// The image of the difference of two points, mm: rotated and scaled, not translated.
    #[must_use]
    pub fn apply_vector(&self, v: Vec3) -> Vec3 {
        self.apply_direction(v) * self.scale
    }

    /// The image of a direction: only rotated or reflected, so that a unit vector stays one.
    #[must_use]
    pub fn apply_direction(&self, v: Vec3) -> Vec3 {
        let [a, b, c] = self.columns;
        a * v.x + b * v.y + c * v.z
    }

    /// The direction whose image is `v`: only rotated or reflected back, so that a unit vector stays one.
    #[must_use]
    pub fn revert_direction(&self, v: Vec3) -> Vec3 {
        let [a, b, c] = self.columns;
        Vec3::new(a.dot(v), b.dot(v), c.dot(v))
    }

    /// The inverse transform.
    #[must_use]
    pub fn inverse(&self) -> Self {
        let [a, b, c] = self.columns;
        let columns =
            [Vec3::new(a.x, b.x, c.x), Vec3::new(a.y, b.y, c.y), Vec3::new(a.z, b.z, c.z)];
        let mut t = Self { columns, scale: 1.0 / self.scale, translation: Vec3::ZERO };
        t.translation = -t.apply_vector(self.translation);
        t
    }

    /// Ratio of lengths after to lengths before, above zero.
    #[must_use]
    pub const fn scale_factor(&self) -> f64 {
        self.scale
    }

    /// Whether it mirrors, so that left and right are exchanged.
    #[must_use]
    pub fn is_reflection(&self) -> bool {
        let [a, b, c] = self.columns;
        a.cross(b).dot(c) < 0.0
    }
}

impl Default for Transform {
    fn default() -> Self {
        Self::identity()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::FRAC_PI_2;

    fn close(a: Vec3, b: Vec3) {
        assert!(a.distance(b) < 1e-13, "{a:?} is not {b:?}");
    }

    #[test]
    fn by_hand() {
        let quarter = Transform::rotation_about(Vec3::new(1.0, 0.0, 0.0), Vec3::Z * 5.0, FRAC_PI_2);
        close(quarter.apply_point(Vec3::new(3.0, 0.0, 7.0)), Vec3::new(1.0, 2.0, 7.0));
        let m = Transform::mirror(Vec3::X, Vec3::new(2.0, 0.0, 0.0));
        close(m.apply_point(Vec3::new(5.0, 1.0, 1.0)), Vec3::new(-1.0, 1.0, 1.0));
        assert!(m.is_reflection() && !quarter.is_reflection());
        let k = Transform::scale(-2.0).unwrap();
        close(k.apply_point(Vec3::new(1.0, 2.0, 3.0)), Vec3::new(-2.0, -4.0, -6.0));
        assert!(k.is_reflection() && k.scale_factor() == 2.0);
        assert!(Transform::scale(0.0).is_none());
    }

    #[test]
    fn then_and_inverse() {
        let t = Transform::rotation_about(Vec3::new(1.0, 2.0, 3.0), Vec3::new(1.0, -1.0, 0.5), 0.7)
            .then(&Transform::scale(2.5).unwrap())
            .then(&Transform::mirror(Vec3::new(1.0, 1.0, 0.0), Vec3::X))
            .then(&Transform::translation(Vec3::new(-4.0, 0.0, 9.0)));
        let p = Vec3::new(12.0, -5.0, 0.25);
        close(t.inverse().apply_point(t.apply_point(p)), p);
        close(t.then(&t.inverse()).apply_point(p), p);
        close(t.apply_vector(p), t.apply_point(p) - t.apply_point(Vec3::ZERO));
        close(t.revert_direction(t.apply_direction(p)), p);
        assert_eq!(Transform::rotation_about(p, Vec3::ZERO, 1.0), Transform::identity());
    }
}
