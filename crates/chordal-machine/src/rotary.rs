//! Points of the path and the direction of the tool relative to the part, with rotary axes.
//!
//! A, B and C turn about axes parallel to X, Y and Z through a point in the machine file. Tables carry the part, with the
//! axis of the first letter closest to the machine; heads carry the tool.

use chordal_geometry::{Transform, Vec3};

use crate::machine::{RotaryAxis, RotaryTarget};

/// The linear axes that A, B and C turn about.
const AXES: [Vec3; 3] = [Vec3::X, Vec3::Y, Vec3::Z];

/// A rotation of the tool relative to the part by a rotary axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ToolRotation {
    /// 0, 1 and 2 for A, B and C.
    pub axis: usize,
    /// The unit vector about which a positive angle turns the tool, by the right-hand rule.
    pub about: Vec3,
}

impl RotaryAxis {
    /// A point on the axis of rotation, program coordinates, mm.
    #[must_use]
    pub fn center(&self) -> Vec3 {
        let [x, y, z] = self.center_mm.map(|mm| mm.unwrap_or(0.0));
        Vec3::new(x, y, z)
    }

    /// The unit vector about which a positive angle turns, by the right-hand rule.
    fn about(&self, axis: usize) -> Vec3 {
        if self.reversed { AXES[axis] * -1.0 } else { AXES[axis] }
    }
}

/// The transform from program coordinates to those of the part, which are equal if A, B and C (rad) are zero. Axes that
/// turn the tool, and those that are not known to turn the part, are ignored.
#[must_use]
pub fn part_transform(rotary: &[RotaryAxis; 3], angles: [f64; 3]) -> Transform {
    let turned = rotary.iter().zip(angles).enumerate();
    turned.filter(|(_, (own, angle))| own.turns == Some(RotaryTarget::Table) && *angle != 0.0).fold(
        Transform::identity(),
        |to_part, (axis, (own, angle))| {
            to_part.then(&Transform::rotation_about(own.center(), own.about(axis), angle))
        },
    )
}

/// The rotations from the direction of the tool on the machine to its direction relative to the part, in the order in
/// which they are applied: those of heads, then those of tables.
#[must_use]
pub fn tool_rotations(rotary: &[RotaryAxis; 3]) -> Vec<ToolRotation> {
    let of = |turns: RotaryTarget| {
        let axes = rotary.iter().enumerate().filter(move |(_, own)| own.turns == Some(turns));
        axes.map(|(axis, own)| ToolRotation { axis, about: own.about(axis) })
    };
    of(RotaryTarget::Head).chain(of(RotaryTarget::Table)).collect()
}

#[cfg(test)]
mod tests {
    use std::f64::consts::FRAC_PI_2;

    use super::*;

    const QUARTER: [f64; 3] = [FRAC_PI_2, 0.0, 0.0];

    fn table() -> RotaryAxis {
        RotaryAxis { turns: Some(RotaryTarget::Table), ..RotaryAxis::default() }
    }

    fn at(rotary: [RotaryAxis; 3], angles: [f64; 3], point: [f64; 3]) -> [f64; 3] {
        let [x, y, z] = point;
        let placed = part_transform(&rotary, angles).apply_point(Vec3::new(x, y, z)).to_array();
        placed.map(|mm| (mm * 1e9).round() / 1e9 + 0.0)
    }

    #[test]
    fn a_table_turns_the_path_about_its_axis_and_a_head_does_not() {
        let none = RotaryAxis::default();
        let head = RotaryAxis { turns: Some(RotaryTarget::Head), ..none };
        let reversed = RotaryAxis { reversed: true, ..table() };
        // The tool above the part at A0 is on its side at A90: a positive angle turns it from Z to -Y.
        assert_eq!(at([table(), none, none], QUARTER, [5.0, 0.0, 10.0]), [5.0, -10.0, 0.0]);
        assert_eq!(at([reversed, none, none], QUARTER, [5.0, 0.0, 10.0]), [5.0, 10.0, 0.0]);
        assert_eq!(at([head, none, none], QUARTER, [5.0, 0.0, 10.0]), [5.0, 0.0, 10.0]);
        assert_eq!(at([none; 3], QUARTER, [5.0, 0.0, 10.0]), [5.0, 0.0, 10.0]);
        // 30 above an axis that lies 20 below zero.
        let low = RotaryAxis { center_mm: [None, None, Some(-20.0)], ..table() };
        assert_eq!(at([low, none, none], QUARTER, [0.0, 0.0, 10.0]), [0.0, -30.0, -20.0]);
    }

    #[test]
    fn heads_turn_the_tool_before_tables_do() {
        let head =
            RotaryAxis { turns: Some(RotaryTarget::Head), reversed: true, ..RotaryAxis::default() };
        let rotations = tool_rotations(&[table(), head, RotaryAxis::default()]);
        let expected = [(1, Vec3::Y * -1.0), (0, Vec3::X)];
        assert_eq!(rotations, expected.map(|(axis, about)| ToolRotation { axis, about }));
    }
}
