//! A right-handed coordinate system in space.

use crate::Vec3;

/// A right-handed orthonormal coordinate system: `u × v = w`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame {
    /// The origin of the system, mm.
    pub origin: Vec3,
    /// Unit vector of the first axis.
    pub u: Vec3,
    /// Unit vector of the second axis.
    pub v: Vec3,
    /// Unit vector of the third axis.
    pub w: Vec3,
}

impl Frame {
    /// The frame of the space itself.
    pub const IDENTITY: Frame = Frame { origin: Vec3::ZERO, u: Vec3::X, v: Vec3::Y, w: Vec3::Z };

    /// A frame at `origin` (mm) whose third axis has the direction `normal` and whose first axis is the projection of
    /// `towards`. `None` if one of the two is zero or they are parallel.
    #[must_use]
    pub fn from_normal(origin: Vec3, normal: Vec3, towards: Vec3) -> Option<Frame> {
        let w = normal.normalized()?;
        let v = w.cross(towards.normalized()?).normalized()?;
        // Twice, because the cross product of almost parallel vectors is only roughly perpendicular.
        let v = (v - w * v.dot(w)).normalized()?;
        let u = v.cross(w).normalized()?;
        Some(Frame { origin, u, v, w })
    }

    /// The coordinates in this frame of a point in space, mm.
    #[must_use]
    pub fn to_local(&self, p: Vec3) -> Vec3 {
        let d = p - self.origin;
        Vec3::new(d.dot(self.u), d.dot(self.v), d.dot(self.w))
    }

    /// The point in space that has these coordinates in this frame, mm.
    #[must_use]
    pub fn to_world(&self, p: Vec3) -> Vec3 {
        self.origin + self.u * p.x + self.v * p.y + self.w * p.z
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn local_and_back() {
        let f = Frame::from_normal(
            Vec3::new(1.0, -2.0, 3.0),
            Vec3::new(1.0, 1.0, 1.0),
            Vec3::new(0.0, 0.0, 2.0),
        )
        .unwrap();
        assert!((f.u.cross(f.v) - f.w).length() < 1e-15);
        assert!(f.u.z > 0.0);
        let p = Vec3::new(0.3, 40.0, -7.0);
        assert!(f.to_world(f.to_local(p)).distance(p) < 1e-13);
        assert!(Frame::from_normal(Vec3::ZERO, Vec3::Z, Vec3::Z).is_none());
        assert!(Frame::from_normal(Vec3::ZERO, Vec3::ZERO, Vec3::Z).is_none());
    }
}
