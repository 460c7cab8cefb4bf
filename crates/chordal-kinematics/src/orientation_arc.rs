//! The tool turns from one direction to another along a great circle, and the rotary axes follow without a jump.

use core::f64::consts::{PI, TAU};
use core::fmt;

use chordal_geometry::Vec3;

use crate::chain::KinematicChain;
use crate::inverse::DirectionError;
use crate::jet::AngleJet;
use crate::joint::{JointAngles, RotaryJoint};
use crate::math;
use crate::triangle::{AxisTriangle, POLE_SINE, TriangleSide};

/// The most parts of an arc with even angles: with more of them the arc leads past a pole.
pub const MAX_PARTS: u32 = 256;

/// How far the start angles may be from the start direction, rad.
const START_TOLERANCE_RAD: f64 = 1e-9;

/// Why the tool cannot follow a great circle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum OrientationError {
    /// A direction of the arc is zero, or not reached, or the axes are parallel.
    Direction(DirectionError),
    /// The machine does not have two rotary axes.
    NotTwoAxes,
    /// The two directions are opposite, so that there are many great circles between them.
    Opposite,
    /// The start angles do not give the start direction.
    NotAtStart {
        /// The angle between them, rad.
        off_rad: f64,
    },
}

impl fmt::Display for OrientationError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            OrientationError::Direction(error) => error.fmt(f),
            OrientationError::NotTwoAxes => {
                write!(f, "the tool follows a great circle only with two rotary axes")
            }
            OrientationError::Opposite => {
                write!(
                    f,
                    "the directions at start and end are opposite, so that no plane is determined"
                )
            }
            OrientationError::NotAtStart { off_rad } => write!(
                f,
                "the angles at the start give a direction that is {} deg off",
                off_rad.to_degrees()
            ),
        }
    }
}

impl core::error::Error for OrientationError {}

impl From<DirectionError> for OrientationError {
    fn from(error: DirectionError) -> Self {
        OrientationError::Direction(error)
    }
}

/// A great circle between two directions of the tool, by σ from 0 to 1 (Siemens ORIVECT, Heidenhain PATHCTRL VECTOR,
/// Fanuc G43.5), with the angles of the rotary axes on it.
///
/// The angles do not jump: they stay on one side of the triangle of the two axes. Where the arc leads exactly through a
/// pole they change to the other side there, and the first axis stays where it is. Where it begins on a pole, the angle of
/// the first axis at σ = 0 is the one in which it leaves the pole, to which that axis must turn first.
#[derive(Clone, Copy, Debug)]
pub struct OrientationArc {
    chain: KinematicChain,
    triangle: AxisTriangle,
    from: Vec3,
    /// The direction about which the tool turns, by the right-hand rule.
    normal: Vec3,
    /// The angle between the two directions, rad.
    sweep: f64,
    side: TriangleSide,
    /// The azimuth about the first axis at the start, rad.
    azimuth: f64,
    /// Whole turns that are added to the angles of the two axes by the right-hand rule, rad.
    turns: [f64; 2],
    /// The angle along the arc at which it passes through a pole, rad, and whether that is opposite to the first axis.
    pole: Option<(f64, bool)>,
}

impl OrientationArc {
    /// The great circle from one direction to another (of any length, in part coordinates), from start angles (rad) that
    /// give the first of them.
    ///
    /// # Errors
    /// See [`OrientationError`]: among others, a part of the arc that the machine does not reach.
    pub fn new(
        chain: &KinematicChain,
        from: Vec3,
        to: Vec3,
        start: &JointAngles,
    ) -> Result<Self, OrientationError> {
        let unit = |v: Vec3| v.normalized().ok_or(DirectionError::NoDirection);
        let (from, to) = (unit(from)?, unit(to)?);
        let [first, second] = chain.joints() else { return Err(OrientationError::NotTwoAxes) };
        let triangle = AxisTriangle::of(chain).ok_or(DirectionError::ParallelAxes)?;
        let off_rad = math::angle_between(chain.direction(start), from);
        if off_rad > START_TOLERANCE_RAD {
            return Err(OrientationError::NotAtStart { off_rad });
        }
        let sweep = math::angle_between(from, to);
        if PI - sweep < POLE_SINE {
            return Err(OrientationError::Opposite);
        }
        // Without a turn any plane will do.
        let normal = from.cross(to).normalized().unwrap_or(triangle.first());
        let mut arc = Self {
            chain: *chain,
            triangle,
            from,
            normal,
            sweep,
            side: triangle.side_of(second.right_hand_angle(start)),
            azimuth: triangle.azimuth(from),
            turns: [0.0; 2],
            pole: None,
        };
        arc.check_reach()?;
        arc.pole = arc.pole_on_arc();
        arc.begin([first, second].map(|joint| joint.right_hand_angle(start)));
        Ok(arc)
    }

    /// Sets what is left from the start angles of the two axes.
    fn begin(&mut self, start: [f64; 2]) {
        if self.starts_on_pole() {
            // An arc that leaves a pole does not pass through it.
            self.pole = None;
            if self.sweep > 0.0 {
                self.leave_pole(start[0]);
            } else {
                self.azimuth += start[0] - self.right_hand_angles(0.0)[0];
            }
        }
        let own = self.right_hand_angles(0.0);
        self.turns =
            core::array::from_fn(|index| math::nearest_turn(own[index], start[index]) - own[index]);
    }

    fn starts_on_pole(&self) -> bool {
        AxisTriangle::is_pole(self.triangle.polar_angle(self.from))
    }

    /// Takes the azimuth in which the arc leaves a pole, and the side on which the first axis is nearer to its angle.
    fn leave_pole(&mut self, first_angle: f64) {
        self.azimuth = self.triangle.azimuth(self.normal.cross(self.from));
        let turn = |side: TriangleSide| {
            let arc = Self { side, ..*self };
            math::within_half_turn(arc.right_hand_angles(0.0)[0] - first_angle).abs()
        };
        let (left, right) = (turn(TriangleSide::Left), turn(TriangleSide::Right));
        self.side = if left <= right { TriangleSide::Left } else { TriangleSide::Right };
    }

    /// Where the arc passes through a pole between its ends.
    fn pole_on_arc(&self) -> Option<(f64, bool)> {
        let first = self.triangle.first();
        let (square, sweep) = (first.dot(self.normal), self.sweep);
        let onward = self.normal.cross(self.from);
        [(first, false), (-first, true)].into_iter().find_map(|(pole, is_opposite)| {
            let along = math::atan2(pole.dot(onward), pole.dot(self.from));
            let is_between = square.abs() < POLE_SINE && along > 0.0 && along <= sweep + POLE_SINE;
            is_between.then_some((along, is_opposite))
        })
    }

    /// Refuses an arc that leaves the reach. Its angle to the first axis is extreme at its ends, and where it is nearest
    /// to that axis or farthest from it.
    fn check_reach(&self) -> Result<(), OrientationError> {
        let first = self.triangle.first();
        let nearest = math::atan2(first.dot(self.normal.cross(self.from)), first.dot(self.from));
        let farthest = if nearest > 0.0 { nearest - PI } else { nearest + PI };
        let inside =
            [nearest, farthest].into_iter().filter(|turn| (0.0..=self.sweep).contains(turn));
        let beyond_rad = [0.0, self.sweep]
            .into_iter()
            .chain(inside)
            .map(|turn| self.triangle.beyond_reach(self.triangle.polar_angle(self.turned(turn))))
            .fold(0.0, f64::max);
        if beyond_rad > 0.0 {
            return Err(DirectionError::Unreachable { beyond_rad }.into());
        }
        Ok(())
    }

    /// The direction after a part of the sweep, rad.
    fn turned(&self, turn: f64) -> Vec3 {
        math::rotated(self.from, self.normal, turn)
    }

    /// The angle between the two directions, rad.
    #[must_use]
    pub const fn sweep(&self) -> f64 {
        self.sweep
    }

    /// The unit vector of the tool at σ, part coordinates.
    #[must_use]
    pub fn direction(&self, sigma: f64) -> Vec3 {
        self.turned(self.sweep * sigma)
    }

    /// The angles of the rotary axes at σ, rad. Those of other letters are zero.
    #[must_use]
    pub fn angles(&self, sigma: f64) -> JointAngles {
        let own = self.right_hand_angles(self.sweep * sigma);
        let mut angles = [0.0; 3];
        for (joint, (angle, turns)) in
            self.chain.joints().iter().zip(own.into_iter().zip(self.turns))
        {
            angles[joint.letter.index()] = joint.sign() * (angle + turns);
        }
        angles
    }

    /// The angles at the ends of equal parts of the arc, without its start: so many parts that the tool stays within a
    /// tolerance (rad) of the arc where the axes turn evenly in each of them, and at most [`MAX_PARTS`]. `None` where that is
    /// not enough, as next to a pole, and where the first axis must turn before the arc begins.
    #[must_use]
    pub fn parts(&self, start: &JointAngles, tolerance_rad: f64) -> Option<Vec<JointAngles>> {
        let first = self.angles(0.0);
        let is_at_start = self.chain.joints().iter().map(|joint| joint.letter.index());
        if !is_at_start.into_iter().all(|at| (first[at] - start[at]).abs() < START_TOLERANCE_RAD) {
            return None;
        }
        let mut count = 1;
        while count <= MAX_PARTS {
            let share = |part: u32| f64::from(part) / f64::from(count);
            let ends: Vec<JointAngles> = (0..=count).map(|part| self.angles(share(part))).collect();
            // A part may lie on both sides of the arc, so that its middle alone says nothing.
            let is_near = |(part, ends): (u32, &[JointAngles])| {
                [0.25, 0.5, 0.75].into_iter().all(|within| {
                    let angles = core::array::from_fn(|at| {
                        ends[0][at] + (ends[1][at] - ends[0][at]) * within
                    });
                    let on_arc = self.direction((f64::from(part) + within) / f64::from(count));
                    math::angle_between(self.chain.direction(&angles), on_arc) <= tolerance_rad
                })
            };
            if (0..).zip(ends.windows(2)).all(is_near) {
                return Some(ends[1..].to_vec());
            }
            count *= 2;
        }
        None
    }

    /// The angles of the two axes by the right-hand rule, without the turns of the start.
    fn right_hand_angles(&self, turn: f64) -> [f64; 2] {
        let direction = self.turned(turn);
        let polar = self.triangle.polar_angle(direction);
        let sign = self.side.sign();
        match self.pole {
            Some((pole, is_opposite)) if turn > pole => {
                // On the other side of the pole the azimuth is half a turn further, and the corner at the first axis, a
                // right angle on the pole, counts the other direction: together the first axis does not jump.
                let azimuth = self.azimuth - sign * PI;
                let (one, two) = self.triangle.angles(polar, azimuth, self.side.other());
                [one, if is_opposite { two - sign * TAU } else { two }]
            }
            _ => {
                let (one, two) = self.triangle.angles(polar, self.azimuth_at(direction), self.side);
                [one, two]
            }
        }
    }

    /// The azimuth about the first axis, which changes by less than half a turn along a great circle of less than that.
    fn azimuth_at(&self, direction: Vec3) -> f64 {
        if self.pole.is_some() || self.starts_on_pole() {
            return self.azimuth;
        }
        math::nearest_turn(self.triangle.azimuth(direction), self.azimuth)
    }

    /// The angles at σ with their derivatives; `None` on a pole, where the first axis has no speed.
    ///
    /// With `v` the direction of the second axis, turned by the first one, `t' = a1' u1 × t + a2' v × t`; products with
    /// `u1` and `v` give each of the two, and the same with the derivative of this equation.
    #[must_use]
    pub fn angle_jet(&self, sigma: f64) -> Option<AngleJet> {
        let [first, second] = self.chain.joints() else { return None };
        let angles = self.angles(sigma);
        let direction = self.direction(sigma);
        let axis = first.direction;
        let carried = math::rotated(second.direction, axis, first.right_hand_angle(&angles));
        let volume = axis.cross(direction).dot(carried);
        if volume.abs() < POLE_SINE {
            return None;
        }
        // A change of the direction as speeds of the two axes.
        let speeds = |change: Vec3| [change.dot(carried) / volume, -change.dot(axis) / volume];
        let change = self.normal.cross(direction) * self.sweep;
        let [one, two] = speeds(change);
        let turn_of_carried = axis.cross(carried) * one;
        let rest = -direction * (self.sweep * self.sweep)
            - axis.cross(change) * one
            - (turn_of_carried.cross(direction) + carried.cross(change)) * two;
        let [one_second, two_second] = speeds(rest);
        let mut jet = AngleJet { angles, ..AngleJet::default() };
        let mut set = |joint: &RotaryJoint, rate: f64, second: f64| {
            jet.first[joint.letter.index()] = joint.sign() * rate;
            jet.second[joint.letter.index()] = joint.sign() * second;
        };
        set(first, one, one_second);
        set(second, two, two_second);
        Some(jet)
    }
}
