//! How far the tool leaves the plane of two directions while the rotary axes turn evenly.

use chordal_geometry::Vec3;

use crate::chain::KinematicChain;
use crate::joint::JointAngles;
use crate::math;

/// In how many parts a turn is looked at; an even number, so that its middle is one of them.
const PARTS: u32 = 8;

/// Below this sine two directions are one, which has no plane with itself.
const SAME_DIRECTION: f64 = 1e-9;

impl KinematicChain {
    /// The largest angle between the tool and the plane of its two end directions while the rotary axes turn evenly from
    /// one position to another, rad. With one direction at both ends it is the angle to that direction.
    ///
    /// A tool that is turned by its vector goes about the shortest way in between, in that plane. Where one axis meets its
    /// travel, or the directions lie at different sides of the pole, the axes go another way and the tool swings aside.
    #[must_use]
    pub fn swing(&self, from: &JointAngles, to: &JointAngles) -> f64 {
        let [first, last] = [from, to].map(|angles| self.direction(angles));
        let normal = first.cross(last);
        let normal = if normal.length() < SAME_DIRECTION { None } else { normal.normalized() };
        let away = |part: u32| {
            let share = f64::from(part) / f64::from(PARTS);
            let angles = core::array::from_fn(|axis| from[axis] + (to[axis] - from[axis]) * share);
            let direction = self.direction(&angles);
            normal.map_or_else(
                || math::angle_between(direction, first),
                |normal| angle_to_plane(direction, normal),
            )
        };
        (1..PARTS).map(away).fold(0.0, f64::max)
    }
}

/// The angle between a unit vector and the plane of a unit normal, rad.
fn angle_to_plane(direction: Vec3, normal: Vec3) -> f64 {
    let across = direction.dot(normal);
    let along = direction - normal * across;
    math::atan2(across.abs(), along.length())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::joint::{RotaryJoint, RotaryLetter};

    fn trunnion() -> KinematicChain {
        let joints =
            [RotaryLetter::C, RotaryLetter::A].map(|letter| RotaryJoint::table(letter, Vec3::ZERO));
        KinematicChain::new(&joints).expect("a chain")
    }

    #[track_caller]
    fn assert_swing(from: [f64; 3], to: [f64; 3], expected_deg: f64) {
        let radians = |angles: [f64; 3]| angles.map(f64::to_radians);
        let swing = trunnion().swing(&radians(from), &radians(to)).to_degrees();
        assert!((swing - expected_deg).abs() < 1e-3, "{swing}");
    }

    #[test]
    fn a_tilt_alone_stays_in_its_plane() {
        assert_swing([-20.0, 0.0, 30.0], [40.0, 0.0, 30.0], 0.0);
    }

    #[test]
    fn half_a_turn_of_the_table_leads_the_tool_aside() {
        // From 30 degrees to one side to 30 degrees to the other one: with A up to 30 degrees, and C by half a turn, the
        // tool goes about on a cone, and is 30 degrees out of the plane in the middle.
        assert_swing([30.0, 0.0, 0.0], [30.0, 0.0, 180.0], 30.0);
        assert_swing([30.0, 0.0, 0.0], [30.0, 0.0, 360.0], 60.0);
    }

    #[test]
    fn near_the_pole_the_tool_swings_by_little() {
        assert_swing([0.5, 0.0, 0.0], [0.5, 0.0, 180.0], 0.5);
        assert_swing([0.0, 0.0, 0.0], [0.0, 0.0, 180.0], 0.0);
    }
}
