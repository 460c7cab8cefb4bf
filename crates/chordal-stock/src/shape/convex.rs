//! The distance of two convex bodies, from below and from above.
//!
//! The differences of their points are a convex body too; its point nearest to zero is found from a simplex of its
//! corners (Gilbert, Johnson, Keerthi, IEEE Journal of Robotics and Automation 4 (1988) 193). Any direction gives a
//! lower bound, by how far the body lies beyond zero in it, and any point an upper one: so the
//! answer is sound whenever the search ends.

use chordal_geometry::Vec3;

/// A distance between two bounds, mm. Nothing is less than zero: bodies that overlap have none.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DistanceInterval {
    /// It is not less.
    pub lower: f64,
    /// It is not more.
    pub upper: f64,
}

impl DistanceInterval {
    pub(super) const TOUCHING: DistanceInterval = DistanceInterval { lower: 0.0, upper: 0.0 };
    pub(super) const ENDLESS: DistanceInterval =
        DistanceInterval { lower: f64::INFINITY, upper: f64::INFINITY };

    pub(super) const fn exact(distance: f64) -> DistanceInterval {
        DistanceInterval { lower: distance, upper: distance }
    }

    /// The distance of the nearer of two.
    pub(super) fn or(self, other: DistanceInterval) -> DistanceInterval {
        DistanceInterval { lower: self.lower.min(other.lower), upper: self.upper.min(other.upper) }
    }
}

/// A body that knows its furthest point in any direction.
pub(super) trait ConvexBody {
    /// A point furthest in a direction of any length, mm.
    fn furthest(&self, path: Vec3) -> Vec3;
}

impl ConvexBody for [Vec3] {
    fn furthest(&self, path: Vec3) -> Vec3 {
        let mut best = (f64::NEG_INFINITY, Vec3::ZERO);
        for &corner in self {
            let reach = corner.dot(path);
            if reach > best.0 {
                best = (reach, corner);
            }
        }
        best.1
    }
}

impl ConvexBody for chordal_geometry::Aabb {
    fn furthest(&self, path: Vec3) -> Vec3 {
        let at = |path: f64, low: f64, high: f64| if path > 0.0 { high } else { low };
        let (low, high) = (self.min, self.max);
        Vec3::new(at(path.x, low.x, high.x), at(path.y, low.y, high.y), at(path.z, low.z, high.z))
    }
}

/// Ends the search where rounding leaves no progress; a certificate is there long before.
const MAX_STEPS: usize = 96;

/// The distance of two convex bodies, mm: known to `resolution`, or no further than that it is above `enough`.
pub(super) fn distance<A: ConvexBody + ?Sized, B: ConvexBody + ?Sized>(
    a: &A,
    b: &B,
    resolution: f64,
    enough: f64,
) -> DistanceInterval {
    let difference = |path: Vec3| a.furthest(path) - b.furthest(-path);
    let mut nearest = difference(Vec3::X);
    let mut simplex = Simplex { corners: [nearest; 4], count: 1 };
    let mut found = DistanceInterval { lower: 0.0, upper: nearest.length() };
    for _ in 0..MAX_STEPS {
        if found.upper <= 0.0 {
            break;
        }
        let corner = difference(-nearest);
        found.lower = found.lower.max(corner.dot(nearest) / nearest.length()).min(found.upper);
        if found.upper - found.lower <= resolution || found.lower >= enough {
            break;
        }
        if simplex.corners[..simplex.count].contains(&corner) {
            break;
        }
        simplex.corners[simplex.count] = corner;
        simplex.count += 1;
        let Some(point) = simplex.reduce() else {
            // Zero lies within.
            return DistanceInterval { lower: 0.0, upper: 0.0 };
        };
        let length = point.length();
        if length >= found.upper {
            break;
        }
        found.upper = length;
        nearest = point;
    }
    found
}

/// Up to four corners.
#[derive(Clone, Copy)]
struct Simplex {
    corners: [Vec3; 4],
    count: usize,
}

impl Simplex {
    fn of(corners: &[Vec3]) -> Simplex {
        let mut simplex = Simplex { corners: [Vec3::ZERO; 4], count: corners.len() };
        simplex.corners[..corners.len()].copy_from_slice(corners);
        simplex
    }

    /// Keeps the corners of the part nearest to zero: its nearest point, or `None` where zero is inside.
    fn reduce(&mut self) -> Option<Vec3> {
        let (point, kept) = match self.corners[..self.count] {
            [a, b] => on_edge(a, b),
            [a, b, c] => on_triangle(a, b, c),
            [a, b, c, d] => on_tetrahedron([a, b, c, d])?,
            _ => (self.corners[0], Simplex::of(&self.corners[..1])),
        };
        *self = kept;
        Some(point)
    }
}

fn on_edge(a: Vec3, b: Vec3) -> (Vec3, Simplex) {
    let along = b - a;
    let t = -a.dot(along);
    let whole = along.length_squared();
    if t <= 0.0 {
        (a, Simplex::of(&[a]))
    } else if t >= whole {
        (b, Simplex::of(&[b]))
    } else {
        (a.lerp(b, t / whole), Simplex::of(&[a, b]))
    }
}

/// After Ericson, Real-Time Collision Detection (2005), 5.1.5.
fn on_triangle(a: Vec3, b: Vec3, c: Vec3) -> (Vec3, Simplex) {
    let (ab, ac) = (b - a, c - a);
    let (d1, d2) = (-ab.dot(a), -ac.dot(a));
    if d1 <= 0.0 && d2 <= 0.0 {
        return (a, Simplex::of(&[a]));
    }
    let (d3, d4) = (-ab.dot(b), -ac.dot(b));
    if d3 >= 0.0 && d4 <= d3 {
        return (b, Simplex::of(&[b]));
    }
    let (d5, d6) = (-ab.dot(c), -ac.dot(c));
    if d6 >= 0.0 && d5 <= d6 {
        return (c, Simplex::of(&[c]));
    }
    let of_c = d1 * d4 - d3 * d2;
    let of_b = d5 * d2 - d1 * d6;
    let of_a = d3 * d6 - d5 * d4;
    let whole = of_a + of_b + of_c;
    if of_a > 0.0 && of_b > 0.0 && of_c > 0.0 && whole > 0.0 {
        let point = a * (of_a / whole) + b * (of_b / whole) + c * (of_c / whole);
        return (point, Simplex::of(&[a, b, c]));
    }
    // On a side, or so thin that rounding puts it there: the nearest of them.
    nearer(nearer(on_edge(a, b), on_edge(b, c)), on_edge(a, c))
}

fn nearer(a: (Vec3, Simplex), b: (Vec3, Simplex)) -> (Vec3, Simplex) {
    if b.0.length_squared() < a.0.length_squared() { b } else { a }
}

fn on_tetrahedron(corners: [Vec3; 4]) -> Option<(Vec3, Simplex)> {
    let mut best: Option<(Vec3, Simplex)> = None;
    for [i, j, k, opposite] in [[0, 1, 2, 3], [0, 1, 3, 2], [0, 2, 3, 1], [1, 2, 3, 0]] {
        let [a, b, c, d] = [i, j, k, opposite].map(|corner: usize| corners[corner]);
        let normal = (b - a).cross(c - a);
        // Zero on the other side of the face than the fourth corner, or a body without volume.
        if -a.dot(normal) * (d - a).dot(normal) <= 0.0 {
            let face = on_triangle(a, b, c);
            best = Some(best.map_or(face, |other| nearer(other, face)));
        }
    }
    best
}
