//! How deep two convex solids overlap, between two bounds.
//!
//! The depth is the length of the shortest shift that separates the solids: the distance from zero to the surface of their
//! Minkowski difference. A polyhedron inside of the difference grows towards its surface where it is nearest to zero (the
//! expanding polytope algorithm). Its nearest face is a lower bound, and the difference in any direction an upper one.

use crate::Vec3;
use crate::convex::PlacedSolid;

/// A depth between two bounds, mm; the upper one is zero for solids that do not overlap.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DepthBounds {
    /// The depth is not smaller.
    pub lower: f64,
    /// The depth is not larger.
    pub upper: f64,
}

/// The most corners that are added to the polyhedron.
const MAX_CORNERS: usize = 96;

/// A face of the polyhedron: three corners counter-clockwise from outside.
struct DepthFace {
    corners: [usize; 3],
    normal: Vec3,
    distance: f64,
}

/// Directions of the first corners: none is along an axis, or across another one.
const FIRST_DIRECTIONS: [Vec3; 8] = [
    Vec3::new(1.0, 0.31, 0.17),
    Vec3::new(-1.0, -0.29, 0.11),
    Vec3::new(0.23, 1.0, -0.19),
    Vec3::new(-0.13, -1.0, 0.37),
    Vec3::new(0.41, -0.07, 1.0),
    Vec3::new(-0.21, 0.27, -1.0),
    Vec3::new(0.71, 0.83, 0.93),
    Vec3::new(-0.91, -0.73, -0.87),
];

/// How deep two convex solids overlap, mm: bounds within `resolution` of each other where the solids are not too round for
/// it, and bounds in any case.
#[must_use]
pub fn solid_depth(a: &PlacedSolid<'_>, b: &PlacedSolid<'_>, resolution: f64) -> DepthBounds {
    let difference = |direction: Vec3| a.farthest(direction) - b.farthest(-direction);
    let none = DepthBounds { lower: 0.0, upper: 0.0 };
    let mut upper = f64::INFINITY;
    let mut reach = |unit: Vec3| {
        let corner = difference(unit);
        upper = upper.min(corner.dot(unit));
        (corner, upper)
    };
    let firsts: Vec<Vec3> = FIRST_DIRECTIONS
        .into_iter()
        .chain([Vec3::X, Vec3::Y, Vec3::Z, -Vec3::X, -Vec3::Y, -Vec3::Z])
        .filter_map(Vec3::normalized)
        .map(|unit| reach(unit).0)
        .collect();
    let Some((mut corners, mut faces)) = first_faces(&firsts) else {
        let (_, upper) = reach(Vec3::Z);
        return DepthBounds { lower: 0.0, upper: if upper > 0.0 { upper } else { 0.0 } };
    };
    for corner in firsts {
        grow(&mut corners, &mut faces, corner);
    }
    let mut lower = 0.0_f64;
    for _ in 0..MAX_CORNERS {
        // As long as zero is outside, the face of the smallest distance is one that sees it.
        let by_distance =
            |one: &&DepthFace, other: &&DepthFace| one.distance.total_cmp(&other.distance);
        let Some(nearest) = faces.iter().min_by(by_distance) else { break };
        lower = lower.max(nearest.distance);
        let (corner, upper) = reach(nearest.normal);
        if upper <= 0.0 {
            return none;
        }
        if upper - lower <= resolution || !grow(&mut corners, &mut faces, corner) {
            break;
        }
    }
    let upper = if upper > 0.0 { upper } else { 0.0 };
    DepthBounds { lower: lower.min(upper), upper }
}

/// A tetrahedron of some of these points; `None` if they are all in one plane.
fn first_faces(points: &[Vec3]) -> Option<(Vec<Vec3>, Vec<DepthFace>)> {
    let p = *points.first()?;
    let farthest = |value: &dyn Fn(Vec3) -> f64| {
        points.iter().copied().max_by(|a, b| value(*a).total_cmp(&value(*b)))
    };
    let q = farthest(&|at| at.distance(p))?;
    let r = farthest(&|at| (q - p).cross(at - p).length_squared())?;
    let normal = (q - p).cross(r - p);
    let s = farthest(&|at| normal.dot(at - p).abs())?;
    let corners = vec![p, q, r, s];
    let volume = normal.dot(s - p);
    if volume == 0.0 || !volume.is_finite() {
        return None;
    }
    let orders = [[0, 1, 2], [0, 3, 1], [1, 3, 2], [2, 3, 0]];
    let outward = |[i, j, k]: [usize; 3]| if volume < 0.0 { [i, j, k] } else { [i, k, j] };
    let faces: Option<Vec<DepthFace>> =
        orders.into_iter().map(|order| face(&corners, outward(order))).collect();
    Some((corners, faces?))
}

/// A face with its outward normal; `None` if it has no area.
fn face(corners: &[Vec3], [i, j, k]: [usize; 3]) -> Option<DepthFace> {
    let [p, q, r] = [corners[i], corners[j], corners[k]];
    let normal = (q - p).cross(r - p).normalized()?;
    Some(DepthFace { corners: [i, j, k], normal, distance: normal.dot(p) })
}

/// Adds a corner: the faces that see it are replaced by faces from their outline to it. False if nothing changes, or
/// rounding gives no face.
fn grow(corners: &mut Vec<Vec3>, faces: &mut Vec<DepthFace>, corner: Vec3) -> bool {
    let sees = |face: &DepthFace| face.normal.dot(corner) > face.distance;
    let mut outline: Vec<[usize; 2]> = Vec::new();
    for face in faces.iter().filter(|face| sees(face)) {
        let [i, j, k] = face.corners;
        for [from, to] in [[i, j], [j, k], [k, i]] {
            // An edge between two faces that see it has both directions.
            match outline.iter().position(|edge| *edge == [to, from]) {
                Some(place) => {
                    outline.swap_remove(place);
                }
                None => outline.push([from, to]),
            }
        }
    }
    if outline.is_empty() || corners.contains(&corner) {
        return false;
    }
    corners.push(corner);
    let newest = corners.len() - 1;
    let mut new_faces = Vec::new();
    for [from, to] in outline {
        match face(corners, [from, to, newest]) {
            Some(face) => new_faces.push(face),
            None => return false,
        }
    }
    faces.retain(|face| !sees(face));
    faces.append(&mut new_faces);
    true
}
