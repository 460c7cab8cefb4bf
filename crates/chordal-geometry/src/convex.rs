//! The distance of two convex solids, between two bounds.
//!
//! The differences of their points (the Minkowski difference) form a convex body, too. Its point nearest to zero is found
//! with a simplex of its corners (GJK: Gilbert, Johnson, Keerthi, IEEE Journal of Robotics and Automation 4 (1988) 193).
//! Any direction gives a lower bound, by how far the body is beyond zero in it, and any point of the body an upper one: so
//! both bounds are valid wherever the search ends.

use core::fmt;

use crate::{Aabb, Transform, Vec3};

/// A convex solid in its own coordinates.
#[derive(Clone, Debug, PartialEq)]
pub enum ConvexSolid {
    /// A box along the axes.
    Cuboid(Aabb),
    /// A ball.
    Ball {
        /// Its middle, mm.
        center: Vec3,
        /// Its radius, mm.
        radius: f64,
    },
    /// A cylinder, or a cone if the radii differ.
    Frustum {
        /// The middles of its two ends, mm; different points.
        ends: [Vec3; 2],
        /// The radii of its two ends, mm.
        radii: [f64; 2],
    },
    /// The smallest convex solid around some points, mm.
    Hull(Vec<Vec3>),
}

/// Why dimensions give no convex solid.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SolidError {
    /// A coordinate or a radius is infinite or NaN.
    NotFinite,
    /// A radius is negative, or both are zero.
    NoRadius,
    /// Two ends are the same point, or a side of a box has no length.
    NoLength,
    /// There are no points.
    NoPoints,
}

impl fmt::Display for SolidError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            SolidError::NotFinite => "a dimension is infinite or NaN",
            SolidError::NoRadius => "its radius is not above zero",
            SolidError::NoLength => "it has no length along one of its directions",
            SolidError::NoPoints => "it has no points",
        })
    }
}

impl core::error::Error for SolidError {}

impl ConvexSolid {
    /// The box between two opposite corners, mm.
    ///
    /// # Errors
    /// [`SolidError::NotFinite`]; [`SolidError::NoLength`] if it is flat.
    pub fn cuboid(one: Vec3, other: Vec3) -> Result<ConvexSolid, SolidError> {
        if !(one.is_finite() && other.is_finite()) {
            return Err(SolidError::NotFinite);
        }
        let bounds = Aabb::of_points(one, other);
        match bounds.size().to_array().iter().all(|side| *side > 0.0) {
            true => Ok(ConvexSolid::Cuboid(bounds)),
            false => Err(SolidError::NoLength),
        }
    }

    /// The ball about a point, mm.
    ///
    /// # Errors
    /// [`SolidError::NotFinite`]; [`SolidError::NoRadius`].
    pub fn ball(center: Vec3, radius: f64) -> Result<ConvexSolid, SolidError> {
        match (center.is_finite() && radius.is_finite(), radius > 0.0) {
            (false, _) => Err(SolidError::NotFinite),
            (true, false) => Err(SolidError::NoRadius),
            (true, true) => Ok(ConvexSolid::Ball { center, radius }),
        }
    }

    /// The cylinder or cone between two points, with the radius at each of them, mm.
    ///
    /// # Errors
    /// [`SolidError::NotFinite`]; [`SolidError::NoRadius`]; [`SolidError::NoLength`] if both ends are the same point.
    pub fn frustum(ends: [Vec3; 2], radii: [f64; 2]) -> Result<ConvexSolid, SolidError> {
        let is_finite =
            ends.iter().all(|end| end.is_finite()) && radii.iter().all(|r| r.is_finite());
        if !is_finite {
            return Err(SolidError::NotFinite);
        }
        if radii.iter().any(|radius| *radius < 0.0) || radii == [0.0; 2] {
            return Err(SolidError::NoRadius);
        }
        match (ends[1] - ends[0]).normalized() {
            Some(_) => Ok(ConvexSolid::Frustum { ends, radii }),
            None => Err(SolidError::NoLength),
        }
    }

    /// The smallest convex solid around points, mm. It may be flat.
    ///
    /// # Errors
    /// [`SolidError::NotFinite`]; [`SolidError::NoPoints`].
    pub fn hull(points: Vec<Vec3>) -> Result<ConvexSolid, SolidError> {
        match (points.is_empty(), points.iter().all(|point| point.is_finite())) {
            (true, _) => Err(SolidError::NoPoints),
            (false, false) => Err(SolidError::NotFinite),
            (false, true) => Ok(ConvexSolid::Hull(points)),
        }
    }

    /// The solid after a transformation; a box becomes the hull of its corners.
    #[must_use]
    pub fn transformed(&self, transform: &Transform) -> ConvexSolid {
        let scale = transform.scale_factor();
        match self {
            ConvexSolid::Ball { center, radius } => {
                ConvexSolid::Ball { center: transform.apply_point(*center), radius: radius * scale }
            }
            ConvexSolid::Frustum { ends, radii } => ConvexSolid::Frustum {
                ends: ends.map(|end| transform.apply_point(end)),
                radii: radii.map(|radius| radius * scale),
            },
            ConvexSolid::Cuboid(_) | ConvexSolid::Hull(_) => {
                let corners = self.enclosing_balls().into_iter();
                ConvexSolid::Hull(corners.map(|(at, _)| transform.apply_point(at)).collect())
            }
        }
    }

    /// A point of the solid that is farthest in a direction of any length, mm.
    #[must_use]
    pub fn farthest(&self, direction: Vec3) -> Vec3 {
        match self {
            ConvexSolid::Cuboid(Aabb { min, max }) => {
                let at = |along: f64, low: f64, high: f64| if along > 0.0 { high } else { low };
                Vec3::new(
                    at(direction.x, min.x, max.x),
                    at(direction.y, min.y, max.y),
                    at(direction.z, min.z, max.z),
                )
            }
            ConvexSolid::Ball { center, radius } => {
                *center + direction.normalized().map_or(Vec3::ZERO, |unit| unit * *radius)
            }
            ConvexSolid::Frustum { ends, radii } => {
                let axis = (ends[1] - ends[0]).normalized().unwrap_or(Vec3::Z);
                let across = across(direction, axis);
                let rim =
                    |end: usize| ends[end] + across.map_or(Vec3::ZERO, |unit| unit * radii[end]);
                let [one, other] = [rim(0), rim(1)];
                if one.dot(direction) > other.dot(direction) { one } else { other }
            }
            ConvexSolid::Hull(points) => {
                let mut best = (f64::NEG_INFINITY, Vec3::ZERO);
                for &point in points {
                    let reach = point.dot(direction);
                    if reach > best.0 {
                        best = (reach, point);
                    }
                }
                best.1
            }
        }
    }

    /// Balls whose convex hull contains the solid, each with its middle and its radius, mm: the corners of a polyhedron,
    /// with a radius of zero; a ball about each end of a cylinder or cone.
    #[must_use]
    pub fn enclosing_balls(&self) -> Vec<(Vec3, f64)> {
        match self {
            ConvexSolid::Cuboid(Aabb { min, max }) => {
                let pick = |high: bool, low: f64, top: f64| if high { top } else { low };
                let corner = |index: u8| {
                    let [x, y, z] = [1, 2, 4].map(|bit| index & bit != 0);
                    let at = [pick(x, min.x, max.x), pick(y, min.y, max.y), pick(z, min.z, max.z)];
                    (Vec3::from_array(at), 0.0)
                };
                (0..8).map(corner).collect()
            }
            ConvexSolid::Ball { center, radius } => vec![(*center, *radius)],
            ConvexSolid::Frustum { ends, radii } => vec![(ends[0], radii[0]), (ends[1], radii[1])],
            ConvexSolid::Hull(points) => points.iter().map(|point| (*point, 0.0)).collect(),
        }
    }

    /// A ball around the solid: its middle and its radius, mm.
    #[must_use]
    pub fn bounding_ball(&self) -> (Vec3, f64) {
        let balls = self.enclosing_balls();
        let bounds = balls.iter().fold(Aabb::EMPTY, |bounds, (at, radius)| {
            let own = Aabb::of_points(*at, *at).expand(*radius);
            bounds.union(own)
        });
        let center = bounds.center();
        let radius = match self {
            ConvexSolid::Frustum { ends, radii } => {
                // The farthest points are on the rims, not on the balls around them.
                let axis = (ends[1] - ends[0]).normalized().unwrap_or(Vec3::Z);
                let rim = |end: usize| {
                    let arm = ends[end] - center;
                    let along = arm.dot(axis);
                    let across = (arm - axis * along).length() + radii[end];
                    (along * along + across * across).sqrt()
                };
                rim(0).max(rim(1))
            }
            _ => balls.iter().fold(0.0, |most: f64, (at, r)| most.max(at.distance(center) + r)),
        };
        (center, radius)
    }
}

/// The unit vector of the part of a direction that is across an axis, if there is one above rounding.
fn across(direction: Vec3, axis: Vec3) -> Option<Vec3> {
    let unit = direction.normalized()?;
    let rest = (unit - axis * unit.dot(axis)).normalized()?;
    // Of a direction along the axis only rounding is left, which may be along the axis, too.
    let again = rest - axis * rest.dot(axis);
    if again.length_squared() > 0.5 { again.normalized() } else { None }
}

/// A convex solid at its place in space.
#[derive(Clone, Copy, Debug)]
pub struct PlacedSolid<'s> {
    solid: &'s ConvexSolid,
    pose: Transform,
    /// A ball around the solid in its own coordinates.
    ball: (Vec3, f64),
}

impl<'s> PlacedSolid<'s> {
    /// A solid with the transform from its coordinates to those of space: a rotation and a translation, without scale.
    #[must_use]
    pub fn new(solid: &'s ConvexSolid, pose: Transform) -> PlacedSolid<'s> {
        PlacedSolid { solid, pose, ball: solid.bounding_ball() }
    }

    /// The same for a solid whose [bounding ball](ConvexSolid::bounding_ball) is known.
    #[must_use]
    pub fn with_ball(
        solid: &'s ConvexSolid,
        ball: (Vec3, f64),
        pose: Transform,
    ) -> PlacedSolid<'s> {
        PlacedSolid { solid, pose, ball }
    }

    /// A point of the solid that is farthest in a direction of any length, mm.
    #[must_use]
    pub fn farthest(&self, direction: Vec3) -> Vec3 {
        self.pose.apply_point(self.solid.farthest(self.pose.revert_direction(direction)))
    }

    /// A ball around the solid: its middle and its radius, mm.
    #[must_use]
    pub fn bounding_ball(&self) -> (Vec3, f64) {
        (self.pose.apply_point(self.ball.0), self.ball.1)
    }
}

/// A distance between two bounds, mm; for solids that overlap the upper one is zero but for rounding.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SolidDistance {
    /// The distance is not smaller.
    pub lower: f64,
    /// The distance is not larger.
    pub upper: f64,
}

/// Ends the search where rounding allows no progress; it usually ends long before.
const MAX_STEPS: usize = 96;

/// What rounding may add to a bound, in parts of the distances that go into it: some hundred operations.
const ROUNDING_SHARE: f64 = 128.0 * f64::EPSILON;

/// The distance of two convex solids, mm: bounds within `resolution` of each other, or a lower bound above `enough`. Where
/// rounding does not allow that, the bounds are wider, and still bounds.
#[must_use]
pub fn solid_distance(
    a: &PlacedSolid<'_>,
    b: &PlacedSolid<'_>,
    resolution: f64,
    enough: f64,
) -> SolidDistance {
    let difference = |direction: Vec3| a.farthest(direction) - b.farthest(-direction);
    let [one, other] = [a.bounding_ball(), b.bounding_ball()];
    let rounding = ROUNDING_SHARE * (one.0.length() + one.1 + other.0.length() + other.1);
    let start = (other.0 - one.0).normalized().unwrap_or(Vec3::X);
    let mut nearest = difference(start);
    let mut simplex = vec![nearest];
    let mut bounds = SolidDistance { lower: 0.0, upper: nearest.length() + rounding };
    if !bounds.upper.is_finite() {
        return SolidDistance { lower: 0.0, upper: f64::INFINITY };
    }
    for _ in 0..MAX_STEPS {
        let length = nearest.length();
        if length <= rounding {
            break;
        }
        let corner = difference(-nearest);
        let reached = corner.dot(nearest) / length - rounding;
        bounds.lower = bounds.lower.max(reached).min(bounds.upper);
        let is_decided = bounds.upper - bounds.lower <= resolution || bounds.lower > enough;
        if is_decided || simplex.contains(&corner) {
            break;
        }
        simplex.push(corner);
        let (point, kept) = nearest_of_simplex(&simplex);
        if kept.len() == 4 {
            // Zero is inside.
            return SolidDistance { lower: 0.0, upper: 0.0 };
        }
        simplex = kept;
        if point.length() >= length {
            break;
        }
        nearest = point;
        bounds.upper = bounds.upper.min(nearest.length() + rounding);
    }
    bounds
}

/// The point of a simplex of one to four corners that is nearest to zero, and the corners of the smallest face with it.
/// The last corner is new: without it nothing is nearer.
fn nearest_of_simplex(corners: &[Vec3]) -> (Vec3, Vec<Vec3>) {
    let Some((newest, others)) = corners.split_last() else { return (Vec3::ZERO, Vec::new()) };
    let mut best = (*newest, vec![*newest]);
    let mut best_square = newest.length_squared();
    for choice in 1_u32..1 << others.len() {
        let mut face = vec![*newest];
        face.extend(
            others.iter().enumerate().filter(|(i, _)| choice & (1 << i) != 0).map(|(_, c)| *c),
        );
        let Some(point) = nearest_inside(&face) else { continue };
        let square = point.length_squared();
        if square < best_square {
            (best, best_square) = ((point, face), square);
        }
    }
    best
}

/// The point nearest to zero of the plane of some corners, if it is between them; `None` where it is not, or the corners
/// are in one line or plane.
fn nearest_inside(corners: &[Vec3]) -> Option<Vec3> {
    // Smaller parts of the square of the edges than this are rounding.
    const FLAT: f64 = 1e-24;
    match *corners {
        [p, q] => {
            let edge = q - p;
            let share = -p.dot(edge) / edge.length_squared();
            (share > 0.0 && share < 1.0).then(|| p + edge * share)
        }
        [p, q, r] => {
            let (u, v) = (q - p, r - p);
            let normal = u.cross(v);
            let square = normal.length_squared();
            if square.is_nan() || square <= FLAT * u.length_squared() * v.length_squared() {
                return None;
            }
            // The parts of the triangle on the other sides of the foot of the perpendicular from zero.
            let of_r = p.cross(q).dot(normal) / square;
            let of_p = q.cross(r).dot(normal) / square;
            let of_q = r.cross(p).dot(normal) / square;
            let is_inside = of_p > 0.0 && of_q > 0.0 && of_r > 0.0;
            // A mean of the corners is a point of the triangle whatever rounding has made of their shares.
            is_inside.then(|| (p * of_p + q * of_q + r * of_r) / (of_p + of_q + of_r))
        }
        [p, q, r, s] => {
            let (u, v, w) = (q - p, r - p, s - p);
            let volume = u.dot(v.cross(w));
            if volume == 0.0 || volume.is_nan() {
                return None;
            }
            let of_q = -p.dot(v.cross(w)) / volume;
            let of_r = -p.dot(w.cross(u)) / volume;
            let of_s = -p.dot(u.cross(v)) / volume;
            let of_p = 1.0 - of_q - of_r - of_s;
            let is_inside = of_p > 0.0 && of_q > 0.0 && of_r > 0.0 && of_s > 0.0;
            // The shares of a flat simplex are rounding.
            let mean = p * of_p + q * of_q + r * of_r + s * of_s;
            (is_inside
                && mean.length()
                    <= ROUNDING_SHARE * (u.length() + v.length() + w.length() + p.length()))
            .then_some(Vec3::ZERO)
        }
        _ => None,
    }
}
