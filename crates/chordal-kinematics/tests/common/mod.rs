//! Machines and comparisons that several tests use.

#![allow(dead_code, reason = "each test uses some of them")]

use chordal_geometry::Vec3;
use chordal_kinematics::{JointAngles, KinematicChain, RotaryJoint, RotaryLetter};

/// G54 of the worked examples, machine coordinates, mm.
pub const WORK_OFFSET: Vec3 = Vec3::new(-300.0, -200.0, -380.0);

/// The length of the tool of the worked examples, mm.
pub const TOOL_LENGTH_MM: f64 = 100.0;

pub const ROUND_TABLE: Vec3 = Vec3::new(-300.0, -200.0, 0.0);

pub fn chain(joints: &[RotaryJoint]) -> KinematicChain {
    KinematicChain::new(joints).expect("a chain")
}

/// C through X-300 Y-200 on A through Y-200 Z-400.
pub fn table_table_ac() -> KinematicChain {
    chain(&[
        RotaryJoint::table(RotaryLetter::C, ROUND_TABLE),
        RotaryJoint::table(RotaryLetter::A, Vec3::new(0.0, -200.0, -400.0)),
    ])
}

/// C through X-300 Y-200 on B through X-300 Z-400.
pub fn table_table_bc() -> KinematicChain {
    chain(&[
        RotaryJoint::table(RotaryLetter::C, ROUND_TABLE),
        RotaryJoint::table(RotaryLetter::B, Vec3::new(-300.0, 0.0, -400.0)),
    ])
}

/// The table C and a head B, 150 above the gauge point.
pub fn head_table() -> KinematicChain {
    chain(&[
        RotaryJoint::table(RotaryLetter::C, ROUND_TABLE),
        RotaryJoint::head(RotaryLetter::B, Vec3::Z * 150.0),
    ])
}

/// A head C on the line of the spindle, and on it B, 150 above the gauge point.
pub fn head_head() -> KinematicChain {
    chain(&[
        RotaryJoint::head(RotaryLetter::C, Vec3::ZERO),
        RotaryJoint::head(RotaryLetter::B, Vec3::Z * 150.0),
    ])
}

/// The same with the direction of B halfway between Y and Z.
pub fn nutating_head() -> KinematicChain {
    chain(&[
        RotaryJoint::head(RotaryLetter::C, Vec3::ZERO),
        RotaryJoint::head(RotaryLetter::B, Vec3::Z * 150.0).along(Vec3::new(0.0, 1.0, 1.0)),
    ])
}

/// The table C on a table halfway between Y and Z, through X-300 Y-200 Z-400.
pub fn nutating_table() -> KinematicChain {
    chain(&[
        RotaryJoint::table(RotaryLetter::C, ROUND_TABLE),
        RotaryJoint::table(RotaryLetter::B, Vec3::new(-300.0, -200.0, -400.0))
            .along(Vec3::new(0.0, 1.0, 1.0)),
    ])
}

pub fn degrees(a: f64, b: f64, c: f64) -> JointAngles {
    [a, b, c].map(f64::to_radians)
}

/// The gauge point of the worked examples for a point in the work coordinate system.
pub fn gauge_point(chain: &KinematicChain, work: Vec3, angles: &JointAngles) -> Vec3 {
    chain.gauge_point(WORK_OFFSET + work, angles, chain.tool_vector(TOOL_LENGTH_MM))
}

/// Compares with numbers that are rounded to four digits.
#[track_caller]
pub fn four_digits(found: Vec3, x: f64, y: f64, z: f64) {
    for (found, expected) in found.to_array().into_iter().zip([x, y, z]) {
        assert!((found - expected).abs() <= 5e-5 + 1e-9, "{found:?} is not {:?}", [x, y, z]);
    }
}

#[track_caller]
pub fn four_digits_deg(found_rad: f64, expected_deg: f64) {
    let found = found_rad.to_degrees();
    assert!((found - expected_deg).abs() <= 5e-5 + 1e-9, "{found} is not {expected_deg}");
}

/// The angle between two directions, rad, by the chord between them.
pub fn angle_between(a: Vec3, b: Vec3) -> f64 {
    2.0 * (0.5 * (a - b).length()).asin()
}

/// Uniform pseudo-random numbers in 0..1: a linear congruence of 64 bits.
pub struct RandomNumbers(pub u64);

impl RandomNumbers {
    pub fn unit(&mut self) -> f64 {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        f64::from((self.0 >> 33) as u32) / f64::from(1_u32 << 31)
    }

    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    pub fn point(&mut self, size: f64) -> Vec3 {
        Vec3::new(self.between(-size, size), self.between(-size, size), self.between(-size, size))
    }

    /// A direction, evenly on the sphere.
    pub fn direction(&mut self) -> Vec3 {
        loop {
            let v = self.point(1.0);
            if v.length() <= 1.0
                && let Some(unit) = v.normalized()
            {
                return unit;
            }
        }
    }
}
