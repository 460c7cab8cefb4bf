//! The bodies of the machine for the page: triangles, what moves each of them relative to the part, and the positions of
//! the axes over time. The page composes the motions and knows no kinematics.

use std::f64::consts::TAU;

use chordal::Job;
use chordal::collision::{LinkJoint, MachineOnPart, PartRelativeBody};
use chordal::geometry::{Aabb, ConvexSolid, Transform, Vec3};
use serde_json::{Value, json};

use crate::answer::point;

/// The sides of a drawn cylinder.
const CYLINDER_SIDES: usize = 48;

/// The message about the bodies of the machine; null where there are none.
pub fn machine_bodies(job: &Job) -> Value {
    match job.machine_on_part() {
        None => Value::Null,
        Some(Err(reason)) => json!({ "solids": [], "to_part": null, "left_out": [reason] }),
        Some(Ok(MachineOnPart { bodies, to_part, left_out, .. })) => json!({
            "solids": bodies.iter().map(body).collect::<Vec<_>>(),
            "to_part": matrix(&to_part),
            "left_out": left_out,
        }),
    }
}

fn body(body: &PartRelativeBody) -> Value {
    let corners = triangles(&body.solid);
    json!({
        "name": body.name,
        "corners": corners.iter().flat_map(|corner| corner.to_array()).collect::<Vec<_>>(),
        "motions": body.motions.iter().filter_map(motion).collect::<Vec<_>>(),
    })
}

/// What an axis does to a body: a shift along a vector, or a turn about a line, by the position of the axis.
fn motion(joint: &LinkJoint) -> Option<Value> {
    match *joint {
        LinkJoint::Fixed => None,
        LinkJoint::Linear { axis, sign } => {
            let along = [Vec3::X, Vec3::Y, Vec3::Z].get(axis).map(|along| point(*along * sign))?;
            Some(json!({ "axis": axis, "along": along }))
        }
        LinkJoint::Rotary { axis, sign, point: through, direction } => {
            let about = point(direction.normalized()? * sign);
            Some(json!({ "axis": axis, "about": about, "through": point(through) }))
        }
    }
}

/// Sixteen numbers, column by column.
fn matrix(transform: &Transform) -> Vec<f64> {
    let directions = [Vec3::X, Vec3::Y, Vec3::Z];
    let columns = directions.map(|along| (transform.apply_vector(along), 0.0));
    let columns = columns.into_iter().chain([(transform.apply_point(Vec3::ZERO), 1.0)]);
    columns.flat_map(|(column, last)| [column.x, column.y, column.z, last]).collect()
}

/// The corners of the triangles of a body, counter-clockwise seen from outside. Machine files have boxes, cylinders and
/// cones only.
fn triangles(solid: &ConvexSolid) -> Vec<Vec3> {
    match solid {
        ConvexSolid::Cuboid(bounds) => box_triangles(bounds),
        ConvexSolid::Frustum { ends, radii } => frustum_triangles(*ends, *radii),
        ConvexSolid::Ball { .. } | ConvexSolid::Hull(_) => Vec::new(),
    }
}

fn box_triangles(bounds: &Aabb) -> Vec<Vec3> {
    let ends = [bounds.min, bounds.max];
    let mut corners = Vec::new();
    for axis in 0..3 {
        let (next, last) = ((axis + 1) % 3, (axis + 2) % 3);
        for side in 0..2 {
            let corner = |along_next: usize, along_last: usize| {
                let mut at = [0.0; 3];
                at[axis] = ends[side].component(axis);
                at[next] = ends[along_next].component(next);
                at[last] = ends[along_last].component(last);
                Vec3::from_array(at)
            };
            let face = [corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)];
            let order = if side == 1 { [0, 1, 2, 0, 2, 3] } else { [0, 2, 1, 0, 3, 2] };
            corners.extend(order.map(|index| face[index]));
        }
    }
    corners
}

fn frustum_triangles(ends: [Vec3; 2], radii: [f64; 2]) -> Vec<Vec3> {
    let Some(axis) = (ends[1] - ends[0]).normalized() else { return Vec::new() };
    let other = if axis.x.abs() < 0.5 { Vec3::X } else { Vec3::Y };
    let Some(u) = axis.cross(other).normalized() else { return Vec::new() };
    let rim = |end: usize, step: usize| {
        let angle = TAU * (step % CYLINDER_SIDES) as f64 / CYLINDER_SIDES as f64;
        let turn = Transform::rotation_about(Vec3::ZERO, axis, angle);
        ends[end] + turn.apply_vector(u) * radii[end]
    };
    let side = |step: usize| {
        let [a, b] = [rim(0, step), rim(0, step + 1)];
        let [c, d] = [rim(1, step), rim(1, step + 1)];
        [a, b, d, a, d, c, ends[0], b, a, ends[1], c, d]
    };
    (0..CYLINDER_SIDES).flat_map(side).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The volume inside of triangles, by the divergence theorem: negative where they lie inside out.
    fn volume(corners: &[Vec3]) -> f64 {
        corners.as_chunks::<3>().0.iter().map(|[a, b, c]| a.dot(b.cross(*c)) / 6.0).sum()
    }

    #[test]
    fn triangles_enclose_the_body() {
        let (low, high) = (Vec3::new(-1.0, 2.0, 3.0), Vec3::new(4.0, 4.0, 10.0));
        let cuboid = ConvexSolid::cuboid(low, high).expect("a box");
        assert!((volume(&triangles(&cuboid)) - 5.0 * 2.0 * 7.0).abs() < 1e-9);
        let ends = [Vec3::new(5.0, 5.0, 5.0), Vec3::new(5.0, -5.0, 5.0)];
        let frustum = ConvexSolid::frustum(ends, [3.0, 1.0]).expect("a cone");
        let exact = std::f64::consts::PI * 10.0 * (9.0 + 3.0 + 1.0) / 3.0;
        let share = volume(&triangles(&frustum)) / exact;
        assert!((0.99..1.0).contains(&share), "{share}");
    }
}
