//! An axis-aligned box.

use crate::Vec3;

/// An axis-aligned box, including its faces.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Aabb {
    /// The corner with the smallest coordinates, mm.
    pub min: Vec3,
    /// The corner with the largest coordinates, mm.
    pub max: Vec3,
}

impl Aabb {
    /// The empty box: its union with any box is that box.
    pub const EMPTY: Aabb = Aabb {
        min: Vec3::new(f64::INFINITY, f64::INFINITY, f64::INFINITY),
        max: Vec3::new(f64::NEG_INFINITY, f64::NEG_INFINITY, f64::NEG_INFINITY),
    };

    /// The smallest box around two points, mm.
    #[must_use]
    pub fn of_points(a: Vec3, b: Vec3) -> Aabb {
        Aabb::EMPTY.include(a).include(b)
    }

    /// The smallest box around this one and `p`, mm. A coordinate that is NaN is ignored.
    #[must_use]
    pub fn include(self, p: Vec3) -> Aabb {
        Aabb {
            min: Vec3::new(self.min.x.min(p.x), self.min.y.min(p.y), self.min.z.min(p.z)),
            max: Vec3::new(self.max.x.max(p.x), self.max.y.max(p.y), self.max.z.max(p.z)),
        }
    }

    /// The smallest box around both.
    #[must_use]
    pub fn union(self, o: Aabb) -> Aabb {
        Aabb {
            min: Vec3::new(
                self.min.x.min(o.min.x),
                self.min.y.min(o.min.y),
                self.min.z.min(o.min.z),
            ),
            max: Vec3::new(
                self.max.x.max(o.max.x),
                self.max.y.max(o.max.y),
                self.max.z.max(o.max.z),
            ),
        }
    }

    /// Whether `p`, mm, is in the box or on its faces.
    #[must_use]
    pub fn contains(&self, p: Vec3) -> bool {
        self.min.x <= p.x
            && p.x <= self.max.x
            && self.min.y <= p.y
            && p.y <= self.max.y
            && self.min.z <= p.z
            && p.z <= self.max.z
    }

    /// Whether the box contains no point.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        !(self.min.x <= self.max.x && self.min.y <= self.max.y && self.min.z <= self.max.z)
    }

    /// Lengths of the sides, mm; zero for the empty box.
    #[must_use]
    pub fn size(&self) -> Vec3 {
        if self.is_empty() { Vec3::ZERO } else { self.max - self.min }
    }

    /// The box with every face moved outward by `margin` mm (inward when negative, down to an
    /// empty box).
    #[must_use]
    pub fn expand(self, margin: f64) -> Aabb {
        let by = Vec3::new(margin, margin, margin);
        Aabb { min: self.min - by, max: self.max + by }
    }

    /// The middle, mm; NaN for the empty box.
    #[must_use]
    pub fn center(&self) -> Vec3 {
        self.min * 0.5 + self.max * 0.5
    }

    /// Whether the two boxes share a point.
    #[must_use]
    pub fn intersects(&self, o: &Aabb) -> bool {
        self.min.x <= o.max.x
            && o.min.x <= self.max.x
            && self.min.y <= o.max.y
            && o.min.y <= self.max.y
            && self.min.z <= o.max.z
            && o.min.z <= self.max.z
    }
}

impl Default for Aabb {
    fn default() -> Self {
        Self::EMPTY
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn empty_is_neutral() {
        let b = Aabb::of_points(Vec3::new(1.0, 5.0, -1.0), Vec3::new(0.0, 6.0, 2.0));
        assert_eq!(b.union(Aabb::EMPTY), b);
        assert_eq!(Aabb::EMPTY.union(b), b);
        assert!(Aabb::EMPTY.is_empty() && !b.is_empty());
        assert_eq!(Aabb::EMPTY.size(), Vec3::ZERO);
        assert_eq!(b.size(), Vec3::new(1.0, 1.0, 3.0));
        assert!(b.contains(b.min) && b.contains(b.max) && b.contains(b.center()));
        assert!(!b.contains(Vec3::ZERO));
        assert!(b.expand(-0.6).is_empty() && b.expand(0.1).contains(b.min));
        assert!(b.intersects(&b.expand(-0.1)) && !b.intersects(&Aabb::EMPTY));
    }
}
