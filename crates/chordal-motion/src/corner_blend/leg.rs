//! A leg of the path: straight moves on one line, or one arc or spiral.

use chordal_geometry::{AXES, Curve, ParamCurve, Vec3};

use crate::AxisValues;
use crate::corner_blend::joint::{JointSide, effort};
use crate::cube_root::cbrt;
use crate::move_request::MoveRequest;
use crate::path_limits::{AxisArrays, CURVE_ACCELERATION_SHARE, CURVE_JERK_SHARE, PathTurning};
use crate::ramp_profile::AccelJerk;

/// A straight piece of a leg, as programmed.
#[derive(Clone, Copy, Debug)]
pub struct LegPart {
    /// Where it begins, σ of the run.
    pub from: f64,
    /// Its extent in σ.
    pub length: f64,
    /// The axes at its start; without X, Y and Z where a curve gives them.
    pub start: AxisValues,
    /// Their derivative by σ.
    pub direction: AxisValues,
    /// The tag of its move.
    pub tag: u64,
}

/// Moves on one straight line at one speed, or one arc or spiral.
#[derive(Clone, Debug)]
pub struct PathLeg {
    /// Where it begins, σ of the run.
    pub from: f64,
    /// Its extent in σ.
    pub length: f64,
    /// The curve, where it is not a line.
    pub curve: Option<Box<Curve>>,
    /// Axes up to the last that moves.
    pub axes: usize,
    /// Programmed speed, σ per s.
    pub feed: f64,
    /// The speed is along the path of a tip that the axes follow.
    pub follows_tip: bool,
    /// Its first part.
    pub part: LegPart,
    /// How many more parts it has.
    pub more: u32,
    /// How it begins.
    pub head: JointSide,
    /// How it ends.
    pub tail: JointSide,
    /// Numbers of the first node that reaches into it and of the one after the last.
    pub nodes: (usize, usize),
    /// The axes come to rest where it begins, in the middle of a run.
    pub begins_at_rest: bool,
    /// Share of the jerk in its first and in its second half.
    pub jerk_share: [f64; 2],
}

impl PathLeg {
    /// The leg of one move, not yet in its place; `start` is where the axes are when it begins.
    pub fn new(motion: &MoveRequest, start: &AxisValues, limits: &AxisArrays) -> PathLeg {
        let length = motion.length();
        let end = motion.to();
        let curve = match motion.curve {
            Curve::Line(_) => None,
            curve => Some(Box::new(curve)),
        };
        let mut direction = [0.0; AXES];
        let first = if curve.is_some() { 3 } else { 0 };
        for axis in first..AXES {
            direction[axis] = (end[axis] - start[axis]) / length;
        }
        let last = (0..AXES).rev().find(|axis| direction[*axis] != 0.0);
        let axes = last.map_or(0, |last| last + 1).max(first);
        let mut anchor = *start;
        if curve.is_some() {
            anchor[..3].fill(0.0);
        }
        let side = |sigma: f64| {
            let mut side = JointSide {
                direction,
                curvature: [0.0; AXES],
                speed: motion.speed,
                straight: true,
                effort: AccelJerk::FREE,
            };
            if let Some(curve) = &curve {
                side.straight = false;
                let (tangent, curvature) = turn_at(curve, sigma);
                side.direction[..3].copy_from_slice(&tangent.to_array());
                side.curvature[..3].copy_from_slice(&curvature.to_array());
                side.speed = holdable_bent(&side, limits).min(side.speed);
            }
            side.speed = holdable(&side.direction[..axes], limits).min(side.speed);
            side.effort = effort(&side.direction[..axes], limits);
            side
        };
        let head = side(0.0);
        let tail = if curve.is_some() { side(length) } else { head };
        PathLeg {
            from: 0.0,
            length,
            curve,
            axes,
            feed: motion.speed,
            follows_tip: motion.path_length.is_some(),
            part: LegPart { from: 0.0, length, start: anchor, direction, tag: motion.tag },
            more: 0,
            head,
            tail,
            nodes: (usize::MAX, 0),
            begins_at_rest: false,
            jerk_share: [1.0; 2],
        }
    }

    /// Whether another leg, smoothly joined, is the same line at the same speed.
    pub fn goes_on_with(&self, next: &PathLeg) -> bool {
        let are_lines = self.curve.is_none() && next.curve.is_none();
        are_lines && (self.feed, self.follows_tip) == (next.feed, next.follows_tip)
    }

    /// Its end as a leg of its own, of some length: a straight line as it ends, unless it is a
    /// longer curve, which stays whole.
    pub fn ending(&self, length: f64) -> PathLeg {
        self.part_by(&self.tail, length, self.end() - length)
    }

    /// Its start likewise.
    pub fn beginning(&self, length: f64) -> PathLeg {
        self.part_by(&self.head, length, self.from)
    }

    fn part_by(&self, side: &JointSide, length: f64, from: f64) -> PathLeg {
        let mut part = self.clone();
        (part.more, part.begins_at_rest, part.jerk_share) = (0, false, [1.0; 2]);
        if self.curve.is_none() || length > self.length {
            part.curve = None;
            (part.length, part.part.length, part.part.direction) = (length, length, side.direction);
            part.place(from);
        }
        part
    }

    /// Moves it along the run.
    pub fn place(&mut self, from: f64) {
        (self.from, self.part.from) = (from, from);
    }

    /// No speed on it is higher when the axes rest at both its ends, σ per s.
    pub fn fastest_alone(&self) -> f64 {
        self.head.effort.rise(0.0, self.length / 2.0).min(self.feed)
    }

    /// It may be so short that one limit can hold all along, which is little time lost.
    pub fn may_be_brief(&self) -> bool {
        self.curve.is_none() && self.jerk_share == [1.0; 2] && self.is_brief_at(self.head.speed)
    }

    /// It is so short at a speed.
    pub fn is_brief_at(&self, speed: f64) -> bool {
        const BRIEF_LEG_S: f64 = 0.004;
        self.length <= BRIEF_LEG_S * speed
    }

    /// Where it ends, σ of the run.
    pub fn end(&self) -> f64 {
        self.from + self.length
    }
}

/// Tangent and curvature of a curve at an end.
fn turn_at(curve: &Curve, s: f64) -> (Vec3, Vec3) {
    match curve {
        Curve::Arc(arc) => {
            let [tangent, curvature, _] = arc.derivatives_from(s, 0.0).here();
            (tangent, curvature)
        }
        curve => (curve.tangent_at(s), curve.curvature_at(s)),
    }
}

/// The speed that the axes can hold along a direction.
fn holdable(direction: &[f64], limits: &AxisArrays) -> f64 {
    let shares =
        direction.iter().zip(&limits.velocity).map(|(component, most)| component.abs() / most);
    1.0 / shares.fold(0.0, f64::max)
}

/// The speed that the axes can hold around a bend.
fn holdable_bent(side: &JointSide, limits: &AxisArrays) -> f64 {
    let k = side.curvature.iter().map(|curvature| curvature * curvature).sum::<f64>().sqrt();
    (0..AXES).fold(f64::INFINITY, |speed, axis| {
        let (direction, curvature) = (side.direction[axis].abs(), side.curvature[axis].abs());
        let by_square = CURVE_ACCELERATION_SHARE * limits.acceleration[axis] / curvature;
        let by_cube = CURVE_JERK_SHARE * limits.jerk[axis] / (k * k * direction);
        speed.min(by_square.sqrt()).min(cbrt(by_cube))
    })
}

/// How a curve turns between two of its places, and how much of X, Y and Z is even on it.
pub fn turning(curve: &Curve, from: f64, to: f64) -> (PathTurning, [f64; 3]) {
    match curve {
        Curve::Line(_) => (
            PathTurning { share: [0.0; 3], curvature: 0.0, twist: 0.0 },
            curve.tangent_at(from).to_array().map(f64::abs),
        ),
        Curve::Arc(arc) => {
            let length = arc.length();
            let (around, along) = (arc.radius * arc.sweep.abs() / length, arc.rise.abs() / length);
            let axis = arc.w.to_array();
            let share = axis.map(|w| around * (1.0 - w * w).max(0.0).sqrt());
            let turning = PathTurning { share, curvature: arc.sweep.abs() / length, twist: 0.0 };
            (turning, axis.map(|w| along * w.abs()))
        }
        Curve::Spiral(_) | Curve::Spline(_) => {
            // Both change evenly enough over a piece of a spiral, and over one of an even part of a
            // spline, to be met between its probes.
            const PROBE_MARGIN: f64 = 1.05;
            let (mut curvature, mut twist) = (0.0_f64, 0.0_f64);
            for probe in 0..=4 {
                let jet = curve.jet_at(from + (to - from) * f64::from(probe) / 4.0);
                let k = jet[2].length();
                let along = jet[1] * jet[3].dot(jet[1]);
                curvature = curvature.max(k);
                twist = twist.max((jet[3] - along).length());
            }
            let turning = PathTurning {
                share: [1.0; 3],
                curvature: curvature * PROBE_MARGIN,
                twist: twist * PROBE_MARGIN,
            };
            (turning, [0.0; 3])
        }
    }
}

/// Into how many pieces a curve is cut so that each has nearly one curvature.
pub fn cuts(curve: &Curve) -> usize {
    match curve {
        Curve::Spiral(spiral) => ((spiral.sweep.abs() / 0.2).ceil() as usize).clamp(1, 512),
        // Even parts of a spline turn by a quarter radian at most.
        Curve::Spline(_) => 4,
        Curve::Line(_) | Curve::Arc(_) => 1,
    }
}
