//! Rotates shapes, and converts them to triangles.

use std::f64::consts::{PI, TAU};

use chordal_geometry::{Aabb, Transform, Vec3};

use super::round::CylinderShape;
use super::{BodyBound, ShapeAxis, ShapeKind, SolidShape};
use crate::mesh::Mesh;

/// A direction counts as an axis where the cosine of the angle differs from 1 by less than this: over the longest
/// part that is far less than the rounding of heights.
const ALONG: f64 = 1e-12;
/// Least and largest number of sides of a cylinder as triangles.
const SIDES: [f64; 2] = [12.0, 2048.0];

impl ShapeAxis {
    const ALL: [ShapeAxis; 3] = [ShapeAxis::X, ShapeAxis::Y, ShapeAxis::Z];

    /// The direction and two normal ones, as a right-handed frame.
    fn frame(self) -> [Vec3; 3] {
        match self {
            ShapeAxis::X => [Vec3::X, Vec3::Y, Vec3::Z],
            ShapeAxis::Y => [Vec3::Y, Vec3::Z, Vec3::X],
            ShapeAxis::Z => [Vec3::Z, Vec3::X, Vec3::Y],
        }
    }
}

impl SolidShape {
    /// The shape after a transformation: one that contains it, and one that it contains. The two differ by at most
    /// `sag` (mm), and only for a cylinder at an oblique angle.
    ///
    /// # Errors `None` where coordinates become too large.
    pub fn turned(&self, by: &Transform, sag: f64) -> Option<[SolidShape; 2]> {
        if let ShapeKind::Round(round) = &self.0
            && let Some(same) = turned_round(round, by)
        {
            let same = SolidShape(ShapeKind::Round(same));
            return Some([same.clone(), same]);
        }
        let shape = |bound| {
            let mesh = self.triangles(sag, bound);
            let vertices = mesh.vertices().iter().map(|at| by.apply_point(*at)).collect();
            SolidShape::surface(Mesh::new(vertices, mesh.triangles().to_vec()).ok()?).ok()
        };
        Some([shape(BodyBound::Outer)?, shape(BodyBound::Inner)?])
    }

    /// The shape as triangles that contain it or that it contains, within `sag` (mm) of its surface.
    pub fn triangles(&self, sag: f64, bound: BodyBound) -> Mesh {
        match &self.0 {
            ShapeKind::Cuboid(around) => cuboid(around),
            ShapeKind::Round(round) => prism(round, sag, bound),
            ShapeKind::Meshed(meshed) => meshed.mesh.clone(),
        }
    }
}

/// The transformed cylinder, where its axis is again along X, Y or Z.
fn turned_round(round: &CylinderShape, by: &Transform) -> Option<CylinderShape> {
    let [along, ..] = round.axis.frame();
    let path = by.apply_direction(along);
    let axis =
        ShapeAxis::ALL.into_iter().find(|axis| path.dot(axis.frame()[0]).abs() > 1.0 - ALONG)?;
    let own = round.middle - along * along.dot(round.middle);
    let ends = [round.from, round.to].map(|at| by.apply_point(own + along * at));
    let [a, b] = ends.map(|end| end.dot(axis.frame()[0]));
    Some(CylinderShape { axis, middle: ends[0], from: a.min(b), to: a.max(b), ..*round })
}

fn cuboid(Aabb { min, max }: &Aabb) -> Mesh {
    let corner = |bits: u32| {
        let pick = |bit: u32, low: f64, high: f64| if bits & bit == 0 { low } else { high };
        Vec3::new(pick(1, min.x, max.x), pick(2, min.y, max.y), pick(4, min.z, max.z))
    };
    // Each face counter-clockwise from outside.
    const FACES: [[u32; 4]; 6] =
        [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    let triangles = FACES.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]).collect();
    // The corners of a shape are always valid in a mesh.
    Mesh::new((0..8).map(corner).collect(), triangles).unwrap_or_default()
}

fn prism(round: &CylinderShape, sag: f64, bound: BodyBound) -> Mesh {
    let [along, u, v] = round.axis.frame();
    let own = round.middle - along * along.dot(round.middle);
    let part = (sag.max(0.0) / round.outer).min(1.0);
    // The number of sides whose chords are within the sag.
    let sides = (PI / libm::acos(1.0 - part).max(1e-9)).ceil().clamp(SIDES[0], SIDES[1]);
    let wide = 1.0 / libm::cos(PI / sides);
    let [outer, inner] = match bound {
        BodyBound::Outer => [round.outer * wide, round.inner],
        BodyBound::Inner => [round.outer, round.inner * wide],
    };
    let count = sides as u32;
    let ring = |radius: f64, end: f64| {
        (0..count).map(move |at| {
            let (sin, cos) = libm::sincos(TAU * f64::from(at) / sides);
            own + along * end + u * (radius * cos) + v * (radius * sin)
        })
    };
    let mut vertices: Vec<Vec3> = Vec::new();
    for (radius, end) in [(outer, round.from), (outer, round.to)] {
        vertices.extend(ring(radius, end));
    }
    let is_tube = round.inner > 0.0;
    if is_tube {
        vertices.extend(ring(inner, round.from).chain(ring(inner, round.to)));
    } else {
        vertices.extend([own + along * round.from, own + along * round.to]);
    }
    let mut triangles = Vec::new();
    for at in 0..count {
        let next = (at + 1) % count;
        let quad = |[a, b, c, d]: [u32; 4]| [[a, b, c], [a, c, d]];
        triangles.extend(quad([at, next, count + next, count + at]));
        if is_tube {
            let (low, high) = (2 * count, 3 * count);
            triangles.extend(quad([low + next, low + at, high + at, high + next]));
            triangles.extend(quad([next, at, low + at, low + next]));
            triangles.extend(quad([count + at, count + next, high + next, high + at]));
        } else {
            triangles.extend([[next, at, 2 * count], [count + at, count + next, 2 * count + 1]]);
        }
    }
    Mesh::new(vertices, triangles).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shapes() -> [SolidShape; 4] {
        let corner = Vec3::new(10.0, 6.0, 4.0);
        [
            SolidShape::cuboid(Vec3::ZERO, corner).expect("a box"),
            SolidShape::cylinder(ShapeAxis::X, corner, 10.0, 0.0, 30.0).expect("a bar"),
            SolidShape::cylinder(ShapeAxis::Y, corner, 10.0, -5.0, 3.0).expect("a disc"),
            SolidShape::tube(ShapeAxis::Z, corner, [10.0, 6.0], 0.0, 30.0).expect("a tube"),
        ]
    }

    #[test]
    fn triangles_are_closed_and_hold_the_shape_or_lie_in_it() {
        for shape in shapes() {
            let [outer, inner] =
                [BodyBound::Outer, BodyBound::Inner].map(|bound| shape.triangles(1e-3, bound));
            assert!(outer.edges().are_closed() && inner.edges().are_closed());
            let volume = shape.volume();
            assert!(inner.volume() <= volume * (1.0 + 1e-12) && inner.volume() > 0.998 * volume);
            assert!(outer.volume() >= volume * (1.0 - 1e-12) && outer.volume() < 1.002 * volume);
        }
    }

    #[test]
    fn a_quarter_turn_is_exact_and_another_angle_is_enclosed() {
        let about = |angle: f64| Transform::rotation_about(Vec3::ZERO, Vec3::X, angle);
        for shape in shapes() {
            let [a, b] = shape.turned(&about(PI / 2.0), 1e-3).expect("a shape");
            assert!((a.volume() - shape.volume()).abs() < 1e-6, "{shape:?}");
            assert_eq!(a.bounds(), b.bounds());
            let (own, there) = (shape.bounds(), a.bounds());
            assert!(
                (there.max.z - own.max.y).abs() < 1e-9 && (there.min.y + own.max.z).abs() < 1e-9
            );
            let [outer, inner] = shape.turned(&about(0.7), 1e-3).expect("a shape");
            assert!(outer.volume() >= shape.volume() - 1e-6);
            assert!(inner.volume() <= shape.volume() + 1e-6);
        }
    }
}
