//! The three coordinate planes and the two directions of rotation in them.

use crate::{Frame, Vec2, Vec3};

/// A coordinate plane; its two axes are ordered so that first × second = normal.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Plane {
    /// First axis X, second Y, normal Z.
    #[default]
    Xy,
    /// First axis Z, second X, normal Y.
    Zx,
    /// First axis Y, second Z, normal X.
    Yz,
}

impl Plane {
    /// The indices in `[x, y, z]` of the first axis, the second axis and the normal.
    #[must_use]
    pub const fn axes(self) -> (usize, usize, usize) {
        match self {
            Plane::Xy => (0, 1, 2),
            Plane::Zx => (2, 0, 1),
            Plane::Yz => (1, 2, 0),
        }
    }

    /// Unit vector of the first axis.
    #[must_use]
    pub const fn first_axis(self) -> Vec3 {
        match self {
            Plane::Xy => Vec3::X,
            Plane::Zx => Vec3::Z,
            Plane::Yz => Vec3::Y,
        }
    }

    /// Unit vector of the second axis.
    #[must_use]
    pub const fn second_axis(self) -> Vec3 {
        match self {
            Plane::Xy => Vec3::Y,
            Plane::Zx => Vec3::X,
            Plane::Yz => Vec3::Z,
        }
    }

    /// Unit normal. Counter-clockwise is meant looking against it.
    #[must_use]
    pub const fn normal(self) -> Vec3 {
        match self {
            Plane::Xy => Vec3::Z,
            Plane::Zx => Vec3::Y,
            Plane::Yz => Vec3::X,
        }
    }

    /// The frame at the origin whose `u`, `v`, `w` are first axis, second axis and normal.
    #[must_use]
    pub const fn frame(self) -> Frame {
        Frame { origin: Vec3::ZERO, u: self.first_axis(), v: self.second_axis(), w: self.normal() }
    }

    /// The coordinates of a point in the plane, mm, without its height.
    #[must_use]
    pub const fn project(self, p: Vec3) -> Vec2 {
        match self {
            Plane::Xy => Vec2::new(p.x, p.y),
            Plane::Zx => Vec2::new(p.z, p.x),
            Plane::Yz => Vec2::new(p.y, p.z),
        }
    }

    /// The coordinate of a point along the normal, mm.
    #[must_use]
    pub const fn height(self, p: Vec3) -> f64 {
        match self {
            Plane::Xy => p.z,
            Plane::Zx => p.y,
            Plane::Yz => p.x,
        }
    }

    /// The point with these plane coordinates and this height, all mm.
    #[must_use]
    pub const fn point(self, ab: Vec2, height: f64) -> Vec3 {
        match self {
            Plane::Xy => Vec3::new(ab.a, ab.b, height),
            Plane::Zx => Vec3::new(ab.b, height, ab.a),
            Plane::Yz => Vec3::new(height, ab.a, ab.b),
        }
    }
}

/// A direction of rotation in a plane, seen against its normal.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum TurnDirection {
    /// Clockwise: from the second axis to the first, a negative sweep.
    Cw,
    /// Counter-clockwise: from the first axis to the second, a positive sweep.
    Ccw,
}

impl TurnDirection {
    /// Sign of a sweep in this direction: −1 clockwise, +1 counter-clockwise.
    #[must_use]
    pub const fn sign(self) -> f64 {
        match self {
            TurnDirection::Cw => -1.0,
            TurnDirection::Ccw => 1.0,
        }
    }

    /// The other direction.
    #[must_use]
    pub const fn reversed(self) -> TurnDirection {
        match self {
            TurnDirection::Cw => TurnDirection::Ccw,
            TurnDirection::Ccw => TurnDirection::Cw,
        }
    }

    /// The other direction if `mirrored` is true, otherwise the same one.
    #[must_use]
    pub const fn mirrored_if(self, mirrored: bool) -> TurnDirection {
        if mirrored { self.reversed() } else { self }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_plane_is_right_handed_and_consistent() {
        let p = Vec3::new(1.0, 2.0, 3.0);
        for plane in [Plane::Xy, Plane::Zx, Plane::Yz] {
            let f = plane.frame();
            assert_eq!(f.u.cross(f.v), f.w);
            let (a, b, n) = plane.axes();
            assert_eq!(f.u.component(a), 1.0);
            assert_eq!(f.v.component(b), 1.0);
            assert_eq!(f.w.component(n), 1.0);
            assert_eq!(plane.project(p), Vec2::new(p.component(a), p.component(b)));
            assert_eq!(plane.height(p), p.component(n));
            assert_eq!(plane.point(plane.project(p), plane.height(p)), p);
        }
    }
}
