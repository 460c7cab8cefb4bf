//! Two bodies along a move.

use chordal_geometry::{
    ConvexSolid, PerAxis, PlacedSolid, SolidDistance, Transform, Vec3, solid_depth, solid_distance,
};

use crate::axis_move::AxisMove;
use crate::links::{LinkJoint, MachineLinks, pose_of};

/// A convex body on a link of a machine, in machine coordinates with every axis at zero.
#[derive(Clone, Debug, PartialEq)]
pub struct LinkedSolid {
    link: usize,
    solid: ConvexSolid,
    /// A ball around it.
    ball: (Vec3, f64),
    /// Balls whose hull contains it, for its distance from axes of rotation.
    corners: Vec<(Vec3, f64)>,
}

impl LinkedSolid {
    /// A body on a link of [`MachineLinks`].
    #[must_use]
    pub fn new(link: usize, solid: ConvexSolid) -> LinkedSolid {
        let (ball, corners) = (solid.bounding_ball(), solid.enclosing_balls());
        LinkedSolid { link, solid, ball, corners }
    }

    /// The link.
    #[must_use]
    pub fn link(&self) -> usize {
        self.link
    }

    /// The body.
    #[must_use]
    pub fn solid(&self) -> &ConvexSolid {
        &self.solid
    }

    fn placed(&self, pose: Transform) -> PlacedSolid<'_> {
        PlacedSolid::with_ball(&self.solid, self.ball, pose)
    }
}

/// What is known of two bodies along a move.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PairAnswer {
    /// They touch nowhere, which is proved.
    Free,
    /// They touch, or come nearer than the tolerance.
    Contact {
        /// The share of the move at which that was found, from 0 to 1.
        share: f64,
        /// Their distance there, mm.
        distance: SolidDistance,
    },
    /// The budget was used up, or rounding does not allow an answer.
    Undecided {
        /// The share of the move up to which it is decided.
        share: f64,
    },
}

/// How far two bodies overlap on a move, or how near they are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PairOverlap {
    /// The share of the move, from 0 to 1.
    pub share: f64,
    /// A lower bound of the depth there, mm; zero if they do not surely overlap.
    pub depth_mm: f64,
    /// An upper bound of their distance there, mm.
    pub distance_mm: f64,
}

/// Intervals are halved at most so often; smaller ones are below the rounding of their ends.
const MAX_HALVINGS: u32 = 48;

/// Positions on a move at which the depth of a contact is measured.
const DEPTH_POSITIONS: u32 = 64;

/// Two bodies of a machine, with the joints between them.
#[derive(Clone, Debug)]
pub struct PairCheck<'b> {
    bodies: [&'b LinkedSolid; 2],
    /// The joints from what carries both to each of them, outwards.
    sides: [Vec<LinkJoint>; 2],
}

impl<'b> PairCheck<'b> {
    /// The check of two bodies.
    #[must_use]
    pub fn new(
        links: &MachineLinks,
        one: &'b LinkedSolid,
        other: &'b LinkedSolid,
    ) -> PairCheck<'b> {
        PairCheck { bodies: [one, other], sides: links.sides_between(one.link, other.link) }
    }

    /// Whether the two bodies touch along a move. Bodies that touch are always found, and bodies that stay `tolerance_mm`
    /// apart are never reported. Each position that is looked at takes one from `budget`.
    #[must_use]
    pub fn along(&self, path: &AxisMove, tolerance_mm: f64, budget: &mut u64) -> PairAnswer {
        // Intervals from the last to the first: the middle, half the width, and how often it was halved.
        let mut intervals = vec![(0.5, 0.5, 0_u32)];
        while let Some((middle, half, halvings)) = intervals.pop() {
            if *budget == 0 {
                return PairAnswer::Undecided { share: middle - half };
            }
            *budget -= 1;
            let axes = path.at(middle);
            let poses = [0, 1].map(|side| pose_of(&self.sides[side], &axes));
            let travel = self.travel(path, half, &axes);
            let placed = [0, 1].map(|side| self.bodies[side].placed(poses[side]));
            let balls = [0, 1].map(|side| placed[side].bounding_ball());
            let gap = balls[0].0.distance(balls[1].0) - balls[0].1 - balls[1].1;
            if gap > travel {
                continue;
            }
            let resolution = tolerance_mm / 8.0;
            let distance = solid_distance(&placed[0], &placed[1], resolution, travel);
            if distance.lower > travel {
                continue;
            }
            if distance.upper <= tolerance_mm / 2.0 {
                return PairAnswer::Contact { share: middle, distance };
            }
            if halvings >= MAX_HALVINGS || travel.is_nan() {
                return PairAnswer::Undecided { share: middle - half };
            }
            let quarter = half / 2.0;
            intervals.push((middle + quarter, quarter, halvings + 1));
            intervals.push((middle - quarter, quarter, halvings + 1));
        }
        PairAnswer::Free
    }

    /// How deep the two bodies are in each other at their deepest on a move, as far as some positions of it and `near`
    /// show: for messages.
    #[must_use]
    pub fn deepest(&self, path: &AxisMove, near: f64, tolerance_mm: f64) -> PairOverlap {
        let shares = (0..=DEPTH_POSITIONS).map(|at| f64::from(at) / f64::from(DEPTH_POSITIONS));
        let mut deepest = self.overlap(path, near, tolerance_mm);
        for share in shares {
            let found = self.overlap(path, share, tolerance_mm);
            if (found.depth_mm, -found.distance_mm) > (deepest.depth_mm, -deepest.distance_mm) {
                deepest = found;
            }
        }
        deepest
    }

    fn overlap(&self, path: &AxisMove, share: f64, tolerance_mm: f64) -> PairOverlap {
        let axes = path.at(share);
        let [a, b] = [0, 1].map(|side| self.bodies[side].placed(pose_of(&self.sides[side], &axes)));
        let resolution = tolerance_mm / 8.0;
        let distance_mm = solid_distance(&a, &b, resolution, f64::INFINITY).upper;
        let depth_mm =
            if distance_mm < tolerance_mm { solid_depth(&a, &b, resolution).lower } else { 0.0 };
        PairOverlap { share, depth_mm, distance_mm }
    }

    /// How far a point of one body may move relative to the other one from the middle of an interval, whose half is `half`,
    /// mm. What a body moves relative to what carries both is added up.
    fn travel(&self, path: &AxisMove, half: f64, axes: &PerAxis<f64>) -> f64 {
        let by = path.travel(half);
        let of_side = |side: usize| side_travel(self.bodies[side], &self.sides[side], axes, &by);
        of_side(0) + of_side(1) + 2.0 * path.deviation_mm + ROUNDING_MM
    }
}

/// What rounding may add to distances on a machine, mm.
const ROUNDING_MM: f64 = 1e-9;

/// How far a point of a body may move while the axes move by up to `by` from their positions.
///
/// The joints are changed one after the other, the outermost first. A joint that turns by `a` moves a point at the distance
/// `r` from its axis by at most `a r`; what the joints before it have moved the point adds to `r`.
fn side_travel(
    body: &LinkedSolid,
    joints: &[LinkJoint],
    axes: &PerAxis<f64>,
    by: &PerAxis<f64>,
) -> f64 {
    let mut moved = 0.0;
    // Linear joints that follow each other move along axes that are square to each other.
    let mut square = 0.0;
    for (place, joint) in joints.iter().enumerate().rev() {
        match *joint {
            LinkJoint::Fixed => {}
            LinkJoint::Linear { axis, .. } => square += by[axis] * by[axis],
            LinkJoint::Rotary { axis, point, direction, .. } => {
                moved += f64::sqrt(square);
                square = 0.0;
                if by[axis] > 0.0 {
                    let outer = pose_of(&joints[place + 1..], axes);
                    let radius = farthest_from_axis(body, &outer, point, direction) + moved;
                    moved += (by[axis] * radius).min(2.0 * radius);
                }
            }
        }
    }
    (moved + square.sqrt()) * (1.0 + RELATIVE_ROUNDING)
}

/// What rounding adds to a bound of travel, in parts of it.
const RELATIVE_ROUNDING: f64 = 1e-12;

/// The largest distance of a point of a body from a line, mm.
fn farthest_from_axis(body: &LinkedSolid, pose: &Transform, point: Vec3, direction: Vec3) -> f64 {
    let from_axis = |at: Vec3| (pose.apply_point(at) - point).cross(direction).length();
    body.corners.iter().map(|(at, radius)| from_axis(*at) + radius).fold(0.0, f64::max)
}
