//! A rotary axis as data.

use core::f64::consts::{PI, TAU};
use core::fmt;

use chordal_geometry::Vec3;

use crate::math;

/// The letter of a rotary axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum RotaryLetter {
    /// About X, unless its direction says otherwise.
    A,
    /// About Y, unless its direction says otherwise.
    B,
    /// About Z, unless its direction says otherwise.
    C,
}

impl RotaryLetter {
    /// Every letter, in order.
    pub const ALL: [RotaryLetter; 3] = [RotaryLetter::A, RotaryLetter::B, RotaryLetter::C];

    /// Its index in [`JointAngles`]: 0, 1 and 2 for A, B and C.
    #[must_use]
    pub const fn index(self) -> usize {
        match self {
            RotaryLetter::A => 0,
            RotaryLetter::B => 1,
            RotaryLetter::C => 2,
        }
    }

    /// The unit vector of the linear axis that it turns about by ISO 841.
    #[must_use]
    pub const fn direction(self) -> Vec3 {
        match self {
            RotaryLetter::A => Vec3::X,
            RotaryLetter::B => Vec3::Y,
            RotaryLetter::C => Vec3::Z,
        }
    }
}

impl fmt::Display for RotaryLetter {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            RotaryLetter::A => "A",
            RotaryLetter::B => "B",
            RotaryLetter::C => "C",
        })
    }
}

/// The angles of A, B and C, rad, as the control shows them. Those of axes that a chain does not have are ignored.
pub type JointAngles = [f64; 3];

/// What a rotary axis carries.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum RotaryMount {
    /// The part: it stands between the part and the linear axes.
    Table,
    /// The tool: it stands between the linear axes and the tool.
    Head,
}

/// How a rotary axis reaches a programmed absolute angle.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum RolloverRule {
    /// The angle as it is written, through every turn: like a linear axis.
    #[default]
    Linear,
    /// The short direction to the same position within a turn; half a turn exactly is positive (Fanuc parameter 1008,
    /// ROA 1, RAB 0: B-63534EN p.531).
    Shortest,
    /// To the position of the absolute value within a turn, in the direction of the sign (Fanuc RAB 1; LinuxCNC
    /// WRAPPED_ROTARY). A negative zero counts as negative.
    Sign,
}

impl RolloverRule {
    /// Every rule.
    pub const ALL: [RolloverRule; 3] =
        [RolloverRule::Shortest, RolloverRule::Sign, RolloverRule::Linear];

    /// The word for it in machine files.
    #[must_use]
    pub const fn as_str(self) -> &'static str {
        match self {
            RolloverRule::Shortest => "shortest",
            RolloverRule::Sign => "sign",
            RolloverRule::Linear => "linear",
        }
    }

    /// How far the axis turns from the present angle to a programmed absolute one, rad.
    #[must_use]
    pub fn movement(self, present: f64, programmed: f64) -> f64 {
        let turn = |angle: f64| {
            let within = angle - TAU * math::floor(angle / TAU);
            // The rounding of the division may leave a whole turn.
            if within >= TAU { 0.0 } else { within }
        };
        match self {
            RolloverRule::Linear => programmed - present,
            RolloverRule::Shortest => {
                let forward = turn(programmed - present);
                // What rounding leaves of half a turn is half a turn, which is positive.
                if forward > PI + HALF_TURN_ROUNDING_RAD { forward - TAU } else { forward }
            }
            RolloverRule::Sign => {
                let forward = turn(programmed.abs() - present);
                match programmed.is_sign_negative() {
                    true if forward > 0.0 => forward - TAU,
                    _ => forward,
                }
            }
        }
    }
}

/// What conversions from degrees leave of half a turn, rad: less than the least increment of any control.
const HALF_TURN_ROUNDING_RAD: f64 = 1e-12;

/// A rotary axis of a machine.
///
/// With the signs of ISO 841 a positive angle turns the tool relative to the part by the right-hand rule about
/// `direction`, whether the axis carries the part or the tool.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RotaryJoint {
    /// The letter of its axis.
    pub letter: RotaryLetter,
    /// Whether it carries the part or the tool.
    pub side: RotaryMount,
    /// The direction of its axis with every rotary axis at zero; of any length above zero.
    pub direction: Vec3,
    /// A point on its axis with every rotary axis at zero, mm: in machine coordinates for a table, from the gauge point
    /// for a head.
    pub point: Vec3,
    /// Its positive direction is opposite to ISO 841: its angles are negated.
    pub reversed: bool,
    /// The lowest and the highest angle, rad; `None`: it turns endlessly.
    pub travel: Option<(f64, f64)>,
    /// How it reaches a programmed absolute angle.
    pub rollover: RolloverRule,
}

impl RotaryJoint {
    /// A table that turns about the axis of its letter through a point in machine coordinates (mm), without limits.
    #[must_use]
    pub const fn table(letter: RotaryLetter, point: Vec3) -> Self {
        Self {
            letter,
            side: RotaryMount::Table,
            direction: letter.direction(),
            point,
            reversed: false,
            travel: None,
            rollover: RolloverRule::Linear,
        }
    }

    /// A head that turns about the axis of its letter through a point relative to the gauge point (mm), without limits.
    #[must_use]
    pub const fn head(letter: RotaryLetter, point: Vec3) -> Self {
        Self { side: RotaryMount::Head, ..Self::table(letter, point) }
    }

    /// The same axis with another direction.
    #[must_use]
    pub const fn along(self, direction: Vec3) -> Self {
        Self { direction, ..self }
    }

    /// The same axis with these lowest and highest angles, rad.
    #[must_use]
    pub const fn within(self, low: f64, high: f64) -> Self {
        Self { travel: Some((low, high)), ..self }
    }

    /// The same axis with its positive direction opposite to ISO 841.
    #[must_use]
    pub const fn turned_around(self) -> Self {
        Self { reversed: !self.reversed, ..self }
    }

    /// +1 with the signs of ISO 841, −1 if it is reversed.
    pub(crate) const fn sign(&self) -> f64 {
        if self.reversed { -1.0 } else { 1.0 }
    }

    /// The angle of this axis by the right-hand rule about its direction, rad.
    pub(crate) fn right_hand_angle(&self, angles: &JointAngles) -> f64 {
        self.sign() * angles[self.letter.index()]
    }

    /// A point turned with the tool by `angle` (rad, right-hand rule).
    pub(crate) fn turned_point(&self, p: Vec3, angle: f64) -> Vec3 {
        self.point + math::rotated(p - self.point, self.direction, angle)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn degrees(rule: RolloverRule, present: f64, programmed: f64) -> f64 {
        rule.movement(present.to_radians(), programmed.to_radians()).to_degrees()
    }

    #[track_caller]
    fn close(found: f64, expected: f64) {
        assert!((found - expected).abs() < 1e-9, "{found} is not {expected}");
    }

    #[test]
    fn shortest_moves_of_the_manual() {
        // B-63534EN p.531: from 0 to A-150, A540, A-620.
        close(degrees(RolloverRule::Shortest, 0.0, -150.0), -150.0);
        close(degrees(RolloverRule::Shortest, 210.0, 540.0), -30.0);
        close(degrees(RolloverRule::Shortest, 180.0, -620.0), -80.0);
        close(degrees(RolloverRule::Shortest, 30.0, 210.0), 180.0);
        close(degrees(RolloverRule::Shortest, 30.0, -150.0), 180.0);
    }

    #[test]
    fn the_sign_is_the_direction() {
        close(degrees(RolloverRule::Sign, 30.0, 10.0), 340.0);
        close(degrees(RolloverRule::Sign, 30.0, -10.0), -20.0);
        close(degrees(RolloverRule::Sign, 30.0, -90.0), -300.0);
        close(degrees(RolloverRule::Sign, 30.0, -0.0), -30.0);
        close(degrees(RolloverRule::Sign, 30.0, 0.0), 330.0);
        close(degrees(RolloverRule::Sign, 30.0, 30.0), 0.0);
    }

    #[test]
    fn linear_turns_through_every_turn() {
        close(degrees(RolloverRule::Linear, 30.0, 750.0), 720.0);
    }
}
