//! Parts that are turned by rotary axes: how the part lies while they stand at an angle, and whether the tool is
//! clear of it while they turn.

use std::f64::consts::TAU;

use chordal_geometry::{Aabb, Transform, Vec3};
use chordal_machine::{RotaryAxis, RotaryTarget, part_transform};
use chordal_stock::shape::SolidShape;

/// Angles that differ by less than this are equal, rad.
const EQUAL_ANGLE_RAD: f64 = 1e-9;
/// A cylinder at an oblique angle is approximated by triangles within this, mm.
const SAG: f64 = 1e-3;
const LETTERS: [char; 3] = ['A', 'B', 'C'];
const AXES: [Vec3; 3] = [Vec3::X, Vec3::Y, Vec3::Z];

/// The orientation of the part at some angles of the rotary axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct PartOrientation {
    /// Angles of A, B and C, rad, each within half a turn of zero.
    pub angles: [f64; 3],
    /// Transforms coordinates of the part, which are those of the program while all angles are zero, to those of the
    /// program.
    pub to_program: Transform,
}

impl PartOrientation {
    /// The part as it was given.
    pub const NONE: PartOrientation =
        PartOrientation { angles: [0.0; 3], to_program: Transform::identity() };

    /// The orientation at some angles; an error says why it is not known.
    pub fn of(rotary: &[RotaryAxis; 3], angles: [f64; 3]) -> Result<PartOrientation, String> {
        let angles = angles.map(within_half_a_turn);
        for (axis, angle) in angles.into_iter().enumerate().filter(|(_, angle)| *angle != 0.0) {
            let letter = LETTERS[axis];
            let degrees = angle.to_degrees();
            match rotary[axis].turns {
                Some(RotaryTarget::Table) => {}
                Some(RotaryTarget::Head) => {
                    return Err(format!(
                        "{letter} turns the tool to {degrees:.3}°, and tools are followed upright only"
                    ));
                }
                None => {
                    return Err(format!(
                        "{letter} is at {degrees:.3}°, and what it turns is not known: give [rotary.{letter}]"
                    ));
                }
            }
        }
        Ok(PartOrientation { angles, to_program: part_transform(rotary, angles).inverse() })
    }

    pub fn is_none(&self) -> bool {
        self.angles == [0.0; 3]
    }

    pub fn is_at(&self, angles: [f64; 3]) -> bool {
        let same = |(a, b): (&f64, f64)| within_half_a_turn(a - b) == 0.0;
        self.angles.iter().zip(angles).all(same)
    }

    /// A shape of the part in this orientation: one that contains it and one that it contains. `None` where it cannot
    /// be turned.
    pub fn shapes(&self, shape: &SolidShape) -> Option<[SolidShape; 2]> {
        if self.is_none() {
            return Some([shape.clone(), shape.clone()]);
        }
        shape.turned(&self.to_program, SAG)
    }

    /// Its name in messages: `A90`.
    pub fn name(&self) -> String {
        let named = LETTERS.iter().zip(self.angles).filter(|(_, angle)| *angle != 0.0);
        let parts: Vec<String> = named
            .map(|(letter, angle)| {
                let text = format!("{:.3}", angle.to_degrees());
                format!("{letter}{}", text.trim_end_matches('0').trim_end_matches('.'))
            })
            .collect();
        if parts.is_empty() { "all at zero".to_string() } else { parts.join(" ") }
    }
}

/// Whether rotary axes are at the same angles, rad; a full turn counts as a difference.
pub(super) fn are_same(a: [f64; 3], b: [f64; 3]) -> bool {
    a.iter().zip(b).all(|(a, b)| (a - b).abs() < EQUAL_ANGLE_RAD)
}

fn within_half_a_turn(angle: f64) -> f64 {
    let rest = angle - TAU * (angle / TAU).round();
    if rest.abs() < EQUAL_ANGLE_RAD { 0.0 } else { rest }
}

/// The box of everything that a body with this box passes while one axis of the table turns it by any angle; `None`
/// where several axes turn, or something other than a table.
pub(super) fn swept(
    rotary: &[RotaryAxis; 3],
    from: [f64; 3],
    to: [f64; 3],
    body: &Aabb,
) -> Option<Aabb> {
    let mut turning = (0..3).filter(|axis| (from[*axis] - to[*axis]).abs() >= EQUAL_ANGLE_RAD);
    let (axis, None) = (turning.next()?, turning.next()) else { return None };
    if rotary[axis].turns != Some(RotaryTarget::Table) {
        return None;
    }
    let middle = rotary[axis].center();
    // An axis with a direction of its own need not be along a linear axis.
    let is_along_letter = rotary[axis].direction.is_none()
        && (0..3).all(|other| other == axis || within_half_a_turn(from[other]) == 0.0);
    let corners = (0..8u32).map(|bits| {
        let pick = |bit: u32, low: f64, high: f64| if bits & bit == 0 { low } else { high };
        let Aabb { min, max } = body;
        Vec3::new(pick(1, min.x, max.x), pick(2, min.y, max.y), pick(4, min.z, max.z)) - middle
    });
    let along = AXES[axis];
    // Where another axis turns the axis itself, or it is inclined, only the distance from its centre is known.
    let distance = |arm: Vec3| {
        if is_along_letter { (arm - along * along.dot(arm)).length() } else { arm.length() }
    };
    let reach = corners.map(distance).fold(0.0, f64::max);
    let around = Vec3::new(reach, reach, reach);
    let mut swept = Aabb { min: middle - around, max: middle + around };
    if is_along_letter {
        let keep = |own: Vec3, of: Vec3| own - along * along.dot(own) + along * along.dot(of);
        swept = Aabb { min: keep(swept.min, body.min), max: keep(swept.max, body.max) };
    }
    Some(swept)
}

/// The box around a transformed box.
pub(super) fn boxed(body: &Aabb, by: &Transform) -> Aabb {
    let corners = (0..8u32).map(|bits| {
        let pick = |bit: u32, low: f64, high: f64| if bits & bit == 0 { low } else { high };
        let Aabb { min, max } = body;
        Vec3::new(pick(1, min.x, max.x), pick(2, min.y, max.y), pick(4, min.z, max.z))
    });
    corners.fold(Aabb::EMPTY, |around, corner| around.include(by.apply_point(corner)))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn table() -> [RotaryAxis; 3] {
        let a = RotaryAxis { turns: Some(RotaryTarget::Table), ..RotaryAxis::default() };
        [
            a,
            RotaryAxis::default(),
            RotaryAxis { turns: Some(RotaryTarget::Head), ..RotaryAxis::default() },
        ]
    }

    #[test]
    fn a_part_at_an_angle_lies_where_the_tool_finds_it() {
        let turn = PartOrientation::of(&table(), [TAU / 4.0, 0.0, 0.0]).expect("a table");
        // With A at 90 degrees a tool that comes down at Y0 Z10 is at Y-10 of the part: the tool turns about it
        // as a right-hand screw goes along X.
        let seen = turn.to_program.apply_point(Vec3::new(3.0, -10.0, 0.0));
        assert!((seen - Vec3::new(3.0, 0.0, 10.0)).length() < 1e-9, "{seen:?}");
        assert_eq!(turn.name(), "A90");
        assert!(turn.is_at([TAU / 4.0 + TAU, 0.0, 0.0]) && !turn.is_at([0.0; 3]));
        assert!(
            PartOrientation::of(&table(), [0.0, 1.0, 0.0])
                .is_err_and(|why| why.contains("[rotary.B]"))
        );
        assert!(
            PartOrientation::of(&table(), [0.0, 0.0, 1.0])
                .is_err_and(|why| why.contains("upright"))
        );
        assert_eq!(PartOrientation::of(&table(), [TAU, 0.0, -TAU]), Ok(PartOrientation::NONE));
    }

    #[test]
    fn what_turns_stays_within_its_radius() {
        let body = Aabb { min: Vec3::new(0.0, -3.0, -4.0), max: Vec3::new(50.0, 3.0, 4.0) };
        let swept = swept(&table(), [0.0; 3], [1.0, 0.0, 0.0], &body).expect("a table");
        assert_eq!(swept.min.to_array(), [0.0, -5.0, -5.0]);
        assert_eq!(swept.max.to_array(), [50.0, 5.0, 5.0]);
    }

    #[test]
    fn an_inclined_axis_keeps_the_part_in_a_ball() {
        let body = Aabb { min: Vec3::new(0.0, -3.0, -4.0), max: Vec3::new(12.0, 3.0, 4.0) };
        let mut rotary = table();
        rotary[0].direction = Some([0.0, 1.0, 1.0]);
        let swept = swept(&rotary, [0.0; 3], [1.0, 0.0, 0.0], &body).expect("a table");
        assert_eq!(swept.min.to_array(), [-13.0; 3]);
        assert_eq!(swept.max.to_array(), [13.0; 3]);
    }
}
