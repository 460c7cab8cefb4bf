//! Points and vectors in a plane.

use core::ops::{Add, Mul, Neg, Sub};

/// A point or a vector in a plane: the coordinates along the plane's first and second axis, mm.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Vec2 {
    /// Along the first axis, mm.
    pub a: f64,
    /// Along the second axis, mm.
    pub b: f64,
}

impl Vec2 {
    /// The origin.
    pub const ZERO: Vec2 = Vec2::new(0.0, 0.0);

    /// The vector with these coordinates, mm.
    #[must_use]
    pub const fn new(a: f64, b: f64) -> Self {
        Self { a, b }
    }

    /// The vector with these coordinates, mm.
    #[must_use]
    pub const fn from_array([a, b]: [f64; 2]) -> Self {
        Self { a, b }
    }

    /// The coordinates, mm.
    #[must_use]
    pub const fn to_array(self) -> [f64; 2] {
        [self.a, self.b]
    }

    /// Scalar product, mm².
    #[must_use]
    pub fn dot(self, o: Vec2) -> f64 {
        self.a * o.a + self.b * o.b
    }

    /// Signed area of the parallelogram, mm²: positive if `o` is counter-clockwise of this vector.
    #[must_use]
    pub fn cross(self, o: Vec2) -> f64 {
        self.a * o.b - self.b * o.a
    }

    /// Length, mm.
    #[must_use]
    pub fn length(self) -> f64 {
        self.dot(self).sqrt()
    }

    /// Distance to another point, mm.
    #[must_use]
    pub fn distance(self, o: Vec2) -> f64 {
        (self - o).length()
    }

    /// The vector rotated by a quarter turn counter-clockwise.
    #[must_use]
    pub fn turned_left(self) -> Vec2 {
        Vec2::new(-self.b, self.a)
    }

    /// The unit vector in this direction; `None` if the vector is zero or not finite.
    #[must_use]
    pub fn normalized(self) -> Option<Vec2> {
        let largest = self.a.abs().max(self.b.abs());
        if !(largest > 0.0 && largest.is_finite()) {
            return None;
        }
        let scaled = Vec2::new(self.a / largest, self.b / largest);
        let length = scaled.length();
        if length.is_finite() { Some(scaled * (1.0 / length)) } else { None }
    }
}

impl From<(f64, f64)> for Vec2 {
    fn from((a, b): (f64, f64)) -> Self {
        Self::new(a, b)
    }
}

impl From<Vec2> for (f64, f64) {
    fn from(v: Vec2) -> Self {
        (v.a, v.b)
    }
}

impl Add for Vec2 {
    type Output = Vec2;
    fn add(self, o: Vec2) -> Vec2 {
        Vec2::new(self.a + o.a, self.b + o.b)
    }
}

impl Sub for Vec2 {
    type Output = Vec2;
    fn sub(self, o: Vec2) -> Vec2 {
        Vec2::new(self.a - o.a, self.b - o.b)
    }
}

impl Mul<f64> for Vec2 {
    type Output = Vec2;
    fn mul(self, k: f64) -> Vec2 {
        Vec2::new(self.a * k, self.b * k)
    }
}

impl Neg for Vec2 {
    type Output = Vec2;
    fn neg(self) -> Vec2 {
        Vec2::new(-self.a, -self.b)
    }
}
