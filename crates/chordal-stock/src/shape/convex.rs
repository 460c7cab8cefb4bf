//! The distance of two convex bodies, between two bounds.
//!
//! The differences of their points (the Minkowski difference) form a convex body, too. Its point nearest to zero is
//! found with a simplex of its corners (GJK: Gilbert, Johnson, Keerthi, IEEE Journal of Robotics and Automation 4
//! (1988) 193). Any direction gives a lower bound, by how far the body is beyond zero in it, and any point an upper
//! one: so the result is valid whenever the search ends.

use chordal_geometry::Vec3;

/// A distance between two bounds, mm; zero for bodies that overlap.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DistanceInterval {
    /// Lower bound.
    pub lower: f64,
    /// Upper bound.
    pub upper: f64,
}

impl DistanceInterval {
    pub(super) const TOUCHING: DistanceInterval = DistanceInterval { lower: 0.0, upper: 0.0 };
    pub(super) const ENDLESS: DistanceInterval =
        DistanceInterval { lower: f64::INFINITY, upper: f64::INFINITY };

    pub(super) const fn exact(distance: f64) -> DistanceInterval {
        DistanceInterval { lower: distance, upper: distance }
    }

    /// The smaller of two distances.
    pub(super) fn or(self, other: DistanceInterval) -> DistanceInterval {
        DistanceInterval { lower: self.lower.min(other.lower), upper: self.upper.min(other.upper) }
    }
}

/// A convex body, given by its support function.
pub(super) trait ConvexBody {
    /// A point that is furthest in a direction (a vector of any length), mm.
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

/// Ends the search where rounding allows no progress; it usually converges long before.
const MAX_STEPS: usize = 96;

/// The distance of two convex bodies, mm: within `resolution`, or only so far that it is known to be above `enough`.
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
            // Zero is inside: the bodies overlap.
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

/// A simplex of up to four corners.
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

    /// Keeps only the corners of the face nearest to zero. Returns its nearest point, or `None` where zero is inside.
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
    // The nearest point is on a side, or the triangle is so thin that rounding puts it there.
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
        // Zero is on the other side of the face from the fourth corner, or the tetrahedron is degenerate.
        if -a.dot(normal) * (d - a).dot(normal) <= 0.0 {
            let face = on_triangle(a, b, c);
            best = Some(best.map_or(face, |other| nearer(other, face)));
        }
    }
    best
}
