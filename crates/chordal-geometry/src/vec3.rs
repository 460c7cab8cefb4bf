//! Points and vectors in space.

use core::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};

/// A point or a vector in space; lengths in millimetres unless the caller decides otherwise.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Vec3 {
    /// First coordinate, mm.
    pub x: f64,
    /// Second coordinate, mm.
    pub y: f64,
    /// Third coordinate, mm.
    pub z: f64,
}

impl Vec3 {
    /// The origin.
    pub const ZERO: Vec3 = Vec3::new(0.0, 0.0, 0.0);
    /// Unit vector along X.
    pub const X: Vec3 = Vec3::new(1.0, 0.0, 0.0);
    /// Unit vector along Y.
    pub const Y: Vec3 = Vec3::new(0.0, 1.0, 0.0);
    /// Unit vector along Z.
    pub const Z: Vec3 = Vec3::new(0.0, 0.0, 1.0);

    /// The vector with these coordinates, mm.
    #[must_use]
    pub const fn new(x: f64, y: f64, z: f64) -> Self {
        Self { x, y, z }
    }

    /// The coordinates as `[x, y, z]`, mm.
    #[must_use]
    pub const fn to_array(self) -> [f64; 3] {
        [self.x, self.y, self.z]
    }

    /// The vector of `[x, y, z]`, mm.
    #[must_use]
    pub const fn from_array(a: [f64; 3]) -> Self {
        Self::new(a[0], a[1], a[2])
    }

    /// Scalar product, mm².
    #[must_use]
    pub fn dot(self, o: Vec3) -> f64 {
        self.x * o.x + self.y * o.y + self.z * o.z
    }

    /// Vector product, mm².
    #[must_use]
    pub fn cross(self, o: Vec3) -> Vec3 {
        Vec3::new(
            self.y * o.z - self.z * o.y,
            self.z * o.x - self.x * o.z,
            self.x * o.y - self.y * o.x,
        )
    }

    /// Square of the length, mm².
    #[must_use]
    pub fn length_squared(self) -> f64 {
        self.dot(self)
    }

    /// Length, mm.
    #[must_use]
    pub fn length(self) -> f64 {
        self.length_squared().sqrt()
    }

    /// The unit vector in this direction; `None` if the vector is zero or not finite.
    #[must_use]
    pub fn normalized(self) -> Option<Vec3> {
        // Scaled first, so that the squares neither underflow nor overflow.
        let largest = self.x.abs().max(self.y.abs()).max(self.z.abs());
        if !(largest > 0.0 && largest.is_finite()) {
            return None;
        }
        let scaled = self / largest;
        let length = scaled.length();
        if length.is_finite() { Some(scaled / length) } else { None }
    }

    /// Distance to another point, mm.
    #[must_use]
    pub fn distance(self, o: Vec3) -> f64 {
        (self - o).length()
    }

    /// The point at fraction `t` between this one and `o`: exactly `self` at 0 and exactly `o` at 1.
    #[must_use]
    pub fn lerp(self, o: Vec3, t: f64) -> Vec3 {
        self * (1.0 - t) + o * t
    }

    /// Whether every coordinate is finite.
    #[must_use]
    pub fn is_finite(self) -> bool {
        self.x.is_finite() && self.y.is_finite() && self.z.is_finite()
    }

    /// The coordinate with this index, mm: 0 is x, 1 is y, any other z.
    #[must_use]
    pub const fn component(self, index: usize) -> f64 {
        match index {
            0 => self.x,
            1 => self.y,
            _ => self.z,
        }
    }
}

impl Add for Vec3 {
    type Output = Vec3;
    fn add(self, o: Vec3) -> Vec3 {
        Vec3::new(self.x + o.x, self.y + o.y, self.z + o.z)
    }
}

impl Sub for Vec3 {
    type Output = Vec3;
    fn sub(self, o: Vec3) -> Vec3 {
        Vec3::new(self.x - o.x, self.y - o.y, self.z - o.z)
    }
}

impl AddAssign for Vec3 {
    fn add_assign(&mut self, o: Vec3) {
        *self = *self + o;
    }
}

impl SubAssign for Vec3 {
    fn sub_assign(&mut self, o: Vec3) {
        *self = *self - o;
    }
}

impl Mul<f64> for Vec3 {
    type Output = Vec3;
    fn mul(self, k: f64) -> Vec3 {
        Vec3::new(self.x * k, self.y * k, self.z * k)
    }
}

impl Mul<Vec3> for f64 {
    type Output = Vec3;
    fn mul(self, v: Vec3) -> Vec3 {
        v * self
    }
}

impl Div<f64> for Vec3 {
    type Output = Vec3;
    fn div(self, k: f64) -> Vec3 {
        Vec3::new(self.x / k, self.y / k, self.z / k)
    }
}

impl Neg for Vec3 {
    type Output = Vec3;
    fn neg(self) -> Vec3 {
        Vec3::new(-self.x, -self.y, -self.z)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn products_by_hand() {
        let a = Vec3::new(1.0, 2.0, 3.0);
        let b = Vec3::new(-4.0, 5.0, 6.0);
        assert_eq!(a.dot(b), 24.0);
        assert_eq!(a.cross(b), Vec3::new(-3.0, -18.0, 13.0));
        assert_eq!(Vec3::X.cross(Vec3::Y), Vec3::Z);
        assert_eq!(Vec3::new(3.0, 4.0, 12.0).length(), 13.0);
    }

    #[test]
    fn lerp_is_exact_at_both_ends() {
        let a = Vec3::new(0.1, 1e17, -3.3);
        let b = Vec3::new(1e-9, 0.7, 5.5);
        assert_eq!(a.lerp(b, 0.0), a);
        assert_eq!(a.lerp(b, 1.0), b);
    }

    #[test]
    fn normalizing_survives_extreme_lengths() {
        let tiny = Vec3::new(3e-300, 4e-300, 0.0).normalized().unwrap();
        assert!((tiny - Vec3::new(0.6, 0.8, 0.0)).length() < 1e-15);
        let huge = Vec3::new(3e300, 4e300, 0.0).normalized().unwrap();
        assert!((huge - Vec3::new(0.6, 0.8, 0.0)).length() < 1e-15);
        assert!(Vec3::ZERO.normalized().is_none());
        assert!(Vec3::new(f64::NAN, 1.0, 0.0).normalized().is_none());
        assert!(Vec3::new(f64::INFINITY, 1.0, 0.0).normalized().is_none());
    }
}
