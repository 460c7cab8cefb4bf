//! How the direction of a tool turns along a move.

use chordal_geometry::Vec3;

/// A rotation about an axis, evenly from one angle to another.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AxisTurn {
    /// The unit vector about which positive angles turn, by the right-hand rule.
    pub about: Vec3,
    /// The angle at the start, rad.
    pub from: f64,
    /// The angle at the end, rad.
    pub to: f64,
}

/// Most rotations of a tool that change along one move.
const MAX_TURNS: usize = 4;

/// The direction of a tool along a move, from its tip to its holder: a fixed direction, then rotations whose angles
/// change evenly with the length of the path.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ToolTurn {
    direction: Vec3,
    /// The rotations that change, in the order in which they are applied.
    turns: [AxisTurn; MAX_TURNS],
    count: usize,
}

impl ToolTurn {
    /// The direction with all rotations at zero, of any length, and the rotations in the order in which they are
    /// applied. `None` where a vector is zero or not finite, an angle is not finite, or more than four angles change.
    pub fn new(direction: Vec3, turns: &[AxisTurn]) -> Option<ToolTurn> {
        let still = AxisTurn { about: Vec3::Z, from: 0.0, to: 0.0 };
        let mut own =
            ToolTurn { direction: direction.normalized()?, turns: [still; MAX_TURNS], count: 0 };
        for turn in turns {
            let about = turn.about.normalized()?;
            if !(turn.from.is_finite() && turn.to.is_finite()) {
                return None;
            }
            let is_along = own.count == 0 && about.cross(own.direction) == Vec3::ZERO;
            if is_along {
                continue;
            }
            if turn.from == turn.to {
                // A rotation that stands turns all that comes before it.
                own.direction = rotated(own.direction, about, turn.from);
                for before in &mut own.turns[..own.count] {
                    before.about = rotated(before.about, about, turn.from);
                }
            } else {
                *own.turns.get_mut(own.count)? = AxisTurn { about, ..*turn };
                own.count += 1;
            }
        }
        Some(own)
    }

    /// A direction that does not change; `None` where it is zero or not finite.
    pub fn constant(direction: Vec3) -> Option<ToolTurn> {
        ToolTurn::new(direction, &[])
    }

    /// The unit vector at a share of the move, from 0 to 1.
    pub fn direction(&self, share: f64) -> Vec3 {
        let turns = self.turns[..self.count].iter();
        let turned = turns.fold(self.direction, |direction, turn| {
            rotated(direction, turn.about, turn.from + share * (turn.to - turn.from))
        });
        turned.normalized().unwrap_or(turned)
    }

    /// Upper bounds of the first and the second derivative of the direction by the share of the move, rad.
    pub(crate) fn rates(&self) -> [f64; 2] {
        let turns = &self.turns[..self.count];
        let angle = |turn: &AxisTurn| (turn.to - turn.from).abs();
        let all: f64 = turns.iter().map(angle).sum();
        // The first axis keeps its angle to the direction.
        let spared = turns.first().map_or(0.0, |turn| {
            angle(turn) * (1.0 - turn.about.cross(self.direction).length().min(1.0))
        });
        [all - spared, all * all]
    }
}

/// A vector turned about a unit vector, by the right-hand rule.
fn rotated(vector: Vec3, about: Vec3, angle: f64) -> Vec3 {
    let (sine, cosine) = libm::sincos(angle);
    vector * cosine + about.cross(vector) * sine + about * (about.dot(vector) * (1.0 - cosine))
}

#[cfg(test)]
mod tests {
    use std::f64::consts::FRAC_PI_2;

    use super::*;

    #[test]
    fn rotations_are_applied_in_order() {
        let tilt = AxisTurn { about: Vec3::X, from: 0.0, to: FRAC_PI_2 };
        let stand = AxisTurn { about: Vec3::Z, from: FRAC_PI_2, to: FRAC_PI_2 };
        let turn = ToolTurn::new(Vec3::Z * 2.0, &[tilt, stand]).unwrap();
        // Z goes to -Y about X, and -Y goes to X about Z.
        assert!(turn.direction(0.0).distance(Vec3::Z) < 1e-15);
        assert!(turn.direction(1.0).distance(Vec3::X) < 1e-15);
        assert!((turn.rates()[0] - FRAC_PI_2).abs() < 1e-15);
        // About its own axis the tool turns without a change of its direction.
        let spin = AxisTurn { about: Vec3::Z, from: 0.0, to: 3.0 };
        assert_eq!(ToolTurn::new(Vec3::Z, &[spin]).unwrap().rates(), [0.0, 0.0]);
        assert!(ToolTurn::new(Vec3::ZERO, &[]).is_none());
        assert!(ToolTurn::new(Vec3::Z, &[AxisTurn { to: f64::NAN, ..tilt }]).is_none());
    }
}
