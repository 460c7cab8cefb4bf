//! Points of the path and the direction of the tool relative to the part, with rotary axes.
//!
//! A, B and C turn about axes parallel to X, Y and Z, or along the directions of the machine file, through a point in the
//! machine file. Tables carry the part, with the axis of the first letter closest to the machine; heads carry the tool,
//! with the axis of the last letter closest to the machine. The machine file may say otherwise what carries what.

use chordal_geometry::{Transform, Vec3};

use crate::axis::Axis;
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
        let direction = self.direction.and_then(|along| Vec3::from_array(along).normalized());
        let direction = direction.unwrap_or(AXES[axis]);
        if self.reversed { direction * -1.0 } else { direction }
    }
}

/// Why the order of tables or heads is not known. Axes are 0, 1 and 2 for A, B and C.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum CarrierError {
    /// The carrier of an axis is not one of these tables or heads.
    NotOfChain { axis: usize, carrier: Axis },
    /// Axes carry each other.
    InCircle { axis: usize },
}

/// The tables, or the heads, in order from the part to the tool: 0, 1 and 2 for A, B and C.
pub(crate) fn part_to_tool(
    rotary: &[RotaryAxis; 3],
    target: RotaryTarget,
) -> Result<Vec<usize>, CarrierError> {
    let mut left: Vec<usize> =
        (0..3).rev().filter(|axis| rotary[*axis].turns == Some(target)).collect();
    // Pairs of which the first is closer to the part: a carried table, the carrier of a head.
    let mut pairs = Vec::new();
    for &axis in &left {
        let Some(carrier) = rotary[axis].on else { continue };
        let Some(&on) = left.iter().find(|other| Axis::ALL[3 + **other] == carrier) else {
            return Err(CarrierError::NotOfChain { axis, carrier });
        };
        pairs.push(match target {
            RotaryTarget::Table => (axis, on),
            RotaryTarget::Head => (on, axis),
        });
    }
    let mut order = Vec::new();
    while let Some(&axis) = left.first() {
        let is_next =
            |axis: &usize| !pairs.iter().any(|(one, other)| other == axis && left.contains(one));
        let Some(place) = left.iter().position(is_next) else {
            return Err(CarrierError::InCircle { axis });
        };
        order.push(left.remove(place));
    }
    Ok(order)
}

/// The same for pictures, which take the order of the letters where the file is wrong.
fn drawn_order(rotary: &[RotaryAxis; 3], target: RotaryTarget) -> Vec<usize> {
    let by_letters = || rotary.map(|own| RotaryAxis { on: None, ..own });
    part_to_tool(rotary, target)
        .or_else(|_| part_to_tool(&by_letters(), target))
        .unwrap_or_default()
}

/// The transform from program coordinates to those of the part, which are equal if A, B and C (rad) are zero. Axes that
/// turn the tool, and those that are not known to turn the part, are ignored.
#[must_use]
pub fn part_transform(rotary: &[RotaryAxis; 3], angles: [f64; 3]) -> Transform {
    let tables = drawn_order(rotary, RotaryTarget::Table).into_iter().rev();
    tables.filter(|axis| angles[*axis] != 0.0).fold(Transform::identity(), |to_part, axis| {
        let own = &rotary[axis];
        to_part.then(&Transform::rotation_about(own.center(), own.about(axis), angles[axis]))
    })
}

/// The rotations from the direction of the tool on the machine to its direction relative to the part, in the order in
/// which they are applied: those of heads, then those of tables.
#[must_use]
pub fn tool_rotations(rotary: &[RotaryAxis; 3]) -> Vec<ToolRotation> {
    let of = |target: RotaryTarget| {
        let axes = drawn_order(rotary, target).into_iter().rev();
        axes.map(|axis| ToolRotation { axis, about: rotary[axis].about(axis) })
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

    #[test]
    fn the_machine_file_says_what_carries_what() {
        let none = RotaryAxis::default();
        let order = |rotary: [RotaryAxis; 3], target| part_to_tool(&rotary, target);
        let on = |own: RotaryAxis, carrier| RotaryAxis { on: Some(carrier), ..own };
        let head = RotaryAxis { turns: Some(RotaryTarget::Head), ..none };
        assert_eq!(order([table(), none, table()], RotaryTarget::Table), Ok(vec![2, 0]));
        let a_on_c = [on(table(), Axis::C), none, table()];
        assert_eq!(order(a_on_c, RotaryTarget::Table), Ok(vec![0, 2]));
        assert_eq!(order([none, head, head], RotaryTarget::Head), Ok(vec![2, 1]));
        assert_eq!(order([none, head, on(head, Axis::B)], RotaryTarget::Head), Ok(vec![1, 2]));
        let circle = [on(table(), Axis::C), none, on(table(), Axis::A)];
        let in_circle = Err(CarrierError::InCircle { axis: 2 });
        assert_eq!(order(circle, RotaryTarget::Table), in_circle);
        let other = Err(CarrierError::NotOfChain { axis: 0, carrier: Axis::B });
        assert_eq!(order([on(table(), Axis::B), head, none], RotaryTarget::Table), other);
        // Pictures draw by the letters then.
        let expected = tool_rotations(&[table(), none, table()]);
        assert_eq!(tool_rotations(&circle), expected);
        // A on C: the turn of A is the last one, closest to the part.
        let axes: Vec<usize> = tool_rotations(&a_on_c).iter().map(|turn| turn.axis).collect();
        assert_eq!(axes, [2, 0]);
    }

    #[test]
    fn an_axis_may_have_a_direction_of_its_own() {
        let none = RotaryAxis::default();
        let nutating = RotaryAxis { direction: Some([0.0, 2.0, 2.0]), ..table() };
        // Half a turn about the bisector of Y and Z exchanges them and mirrors X.
        let placed = part_transform(&[none, nutating, none], [0.0, 2.0 * FRAC_PI_2, 0.0]);
        let turned = placed.apply_point(Vec3::new(1.0, 2.0, 3.0));
        assert!(turned.distance(Vec3::new(-1.0, 3.0, 2.0)) < 1e-14, "{turned:?}");
    }
}
