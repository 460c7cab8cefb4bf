//! How the joint of two moves is passed: at speed, eased within its tolerance, or at rest.

use chordal_geometry::AXES;

use crate::AxisValues;
use crate::corner_blend::blend::{CURVATURE_DEVIATION, DIRECTION_DEVIATION, RAMP_SLOPE};
use crate::cube_root::cbrt;
use crate::move_request::CornerMode;
use crate::path_limits::{AxisArrays, CURVE_ACCELERATION_SHARE, CURVE_JERK_SHARE};
use crate::ramp_profile::AccelJerk;

/// How far an exact joint may be left: a millionth of a millimetre, a hundred-millionth of a radian. It lets
/// the rounding of coordinates pass at speed, and is less than any scale resolves.
pub const EXACT_TOLERANCE: CornerTolerance = CornerTolerance { linear_mm: 1e-6, rotary_rad: 1e-8 };

/// How far easing may leave the path.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CornerTolerance {
    /// Of X, Y and Z, mm.
    pub linear_mm: f64,
    /// Of each rotary axis, rad.
    pub rotary_rad: f64,
}

impl CornerTolerance {
    /// How many tolerances a deviation is.
    pub fn of(&self, deviation: &AxisValues) -> f64 {
        let [x, y, z, a, b, c] = *deviation;
        let (linear, rotary) = ((x * x + y * y + z * z).sqrt(), a.abs().max(b.abs()).max(c.abs()));
        let share = |size: f64, tolerance: f64| if size > 0.0 { size / tolerance } else { 0.0 };
        share(linear, self.linear_mm).max(share(rotary, self.rotary_rad))
    }
}

/// One side of a joint.
#[derive(Clone, Copy, Debug)]
pub struct JointSide {
    /// First derivative by σ.
    pub direction: AxisValues,
    /// Second derivative by σ.
    pub curvature: AxisValues,
    /// Programmed speed, or the largest that the axes can hold, σ per s.
    pub speed: f64,
    /// It is a straight line.
    pub straight: bool,
    /// How the speed can change along it.
    pub effort: AccelJerk,
}

/// What two legs make where they meet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum JointKind {
    /// There is nothing to ease.
    Smooth,
    /// The axes rest.
    Stop,
    /// Corrections take the steps away without loss of time.
    Ease(JointStep),
    /// Easing takes time, and the lengths of the legs say whether a rest takes less.
    Slow(SlowJoint),
}

/// A joint that cannot be passed at full speed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SlowJoint {
    /// What easing would take away.
    pub step: JointStep,
    /// Half widths of the corrections of direction and of curvature, were there no others near.
    pub halves: (f64, f64),
    /// How the two movements may overlap if the axes rest.
    pub overlap: Option<OverlapLimits>,
}

/// How a joint is passed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum JointPassing {
    /// There is nothing to ease.
    Smooth,
    /// Corrections take the steps away. The half width for which it is known that a rest would
    /// take longer, or zero.
    Ease(JointStep, f64),
    /// At rest. The ends of the two movements may overlap in time, if there is a wish.
    Rest(Option<OverlapLimits>),
}

/// The steps at a joint that is eased.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct JointStep {
    /// Step of the first derivative.
    pub direction_step: AxisValues,
    /// Step of the second derivative.
    pub curvature_step: AxisValues,
    /// The step of direction over the tolerance, 1/σ.
    pub direction_share: f64,
    /// The step of curvature over the tolerance, 1/σ².
    pub curvature_share: f64,
    /// Half widths beyond which nothing is gained, σ.
    pub direction_need: f64,
    /// The same for the step of curvature.
    pub curvature_need: f64,
    /// The step of direction over the accelerations and over the jerks of the axes, the largest of each.
    direction_effort: [f64; 2],
    /// The step of curvature over the jerks.
    curvature_effort: f64,
    /// Speeds before and after it, σ per s, and how they can change.
    sides: [(f64, AccelJerk); 2],
}

impl JointStep {
    /// The largest speed through corrections of these half widths, σ per s.
    pub fn speed_within(&self, direction_half: f64, curvature_half: f64) -> f64 {
        let [a, j] = self.direction_effort;
        let mut speed = f64::INFINITY;
        if j > 0.0 {
            let by_square = (CURVE_ACCELERATION_SHARE * direction_half / a).sqrt();
            speed = by_square.min(cbrt(CURVE_JERK_SHARE * direction_half * direction_half / j));
        }
        if self.curvature_effort > 0.0 {
            speed = speed.min(cbrt(
                CURVE_JERK_SHARE * curvature_half / (RAMP_SLOPE * self.curvature_effort),
            ));
        }
        speed
    }

    /// Time lost at the joint against passing it at full speed, s.
    fn loss(&self, speed: f64, width: f64) -> f64 {
        let fastest = self.sides[0].0.max(self.sides[1].0);
        let ramps: f64 = self
            .sides
            .iter()
            .map(|(full, effort)| {
                let change = (full - speed).max(0.0);
                effort.time(change) * change / (2.0 * full)
            })
            .sum();
        let slow = if width > 0.0 && speed < fastest {
            width * (1.0 / speed - 1.0 / fastest)
        } else {
            0.0
        };
        ramps + slow
    }

    /// The larger of the speeds before and after it, σ per s.
    pub fn fastest(&self) -> f64 {
        self.sides[0].0.max(self.sides[1].0)
    }

    /// It is nearly as fast on both sides, so that its speed shows what a correction costs.
    pub fn is_even(&self) -> bool {
        let [(before, _), (after, _)] = self.sides;
        before.min(after) > 0.99 * before.max(after)
    }

    /// Whether passing at rest would be quicker than within corrections of these half widths,
    /// between legs on which the full speed is reached.
    pub fn is_quicker_at_rest(&self, direction_half: f64, curvature_half: f64) -> bool {
        let speed = self.speed_within(direction_half, curvature_half);
        self.loss(speed, 2.0 * direction_half.max(curvature_half)) > self.loss(0.0, 0.0)
    }

    /// Ways beyond which the lengths of the legs change nothing: from rest to full speed and
    /// back with half the jerk, σ.
    pub fn full_speed_distances(&self) -> [f64; 2] {
        self.sides.map(|(speed, effort)| {
            let reduced = AccelJerk { jerk: effort.jerk / 2.0, ..effort };
            2.0 * reduced.distance(0.0, speed)
        })
    }
}

impl SlowJoint {
    /// Half width of the wider correction.
    pub fn half(&self) -> f64 {
        self.halves.0.max(self.halves.1)
    }

    /// The quickest way to pass it between legs on which the full speed is reached.
    pub fn between_long(&self) -> JointPassing {
        let SlowJoint { step, halves, overlap } = self;
        let width = 2.0 * self.half();
        let ease = step.loss(step.speed_within(halves.0, halves.1), width);
        let rest = step.loss(0.0, 0.0);
        let overlapped = overlap.map_or(f64::INFINITY, |overlap| {
            let mut reduced = *step;
            reduced.sides.iter_mut().for_each(|(_, effort)| effort.jerk *= overlap.jerk_share);
            let [(_, one), (_, two)] = reduced.sides;
            reduced.loss(0.0, 0.0) - overlap_time(overlap.reach, one.jerk, two.jerk)
        });
        self.quickest(ease, rest, overlapped)
    }

    /// The quickest, by what each takes, s.
    pub fn quickest(&self, ease: f64, rest: f64, overlapped: f64) -> JointPassing {
        if ease <= rest.min(overlapped) {
            JointPassing::Ease(self.step, self.half())
        } else if overlapped < rest {
            JointPassing::Rest(self.overlap)
        } else {
            JointPassing::Rest(None)
        }
    }
}

/// What the overlap of two movements at a corner has to keep.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OverlapLimits {
    /// How far each movement may be from the corner when both are as far, σ.
    pub reach: f64,
    /// Share of the jerk with which the two ends may run, so that their sum keeps the limits.
    pub jerk_share: f64,
}

impl OverlapLimits {
    /// With like jerks on both sides a movement is so many reaches from the corner when the other has just
    /// stopped.
    pub const CLEAR_REACHES: f64 = 8.0;

    /// How far from the corner the movements are when one of them has just stopped, with like
    /// jerks on both sides, σ.
    pub fn clear(&self) -> f64 {
        OverlapLimits::CLEAR_REACHES * self.reach
    }
}

/// The half width that a step of direction may have by its tolerance alone.
fn direction_half(step: &JointStep) -> f64 {
    1.0 / (DIRECTION_DEVIATION * step.direction_share)
}

fn curvature_half(step: &JointStep) -> f64 {
    (1.0 / (CURVATURE_DEVIATION * step.curvature_share)).sqrt()
}

/// What two legs make where they meet; axes from `axes` on move on neither.
pub fn joint(
    [before, after]: [&JointSide; 2],
    axes: usize,
    corner: CornerMode,
    noise: f64,
    limits: &AxisArrays,
) -> JointKind {
    let direction_step = difference(&after.direction, &before.direction, axes);
    let size = |of: &AxisValues| of[..axes].iter().fold(0.0_f64, |all, value| all.max(value.abs()));
    let straight = before.straight && after.straight;
    let curvature_step =
        if straight { [0.0; AXES] } else { difference(&after.curvature, &before.curvature, axes) };
    let has_curvature_step = !straight
        && size(&curvature_step)
            > 1e-9 * size(&before.curvature).max(size(&after.curvature)) + 1e-12;
    let has_direction_step = size(&direction_step) > noise;
    let (tolerance, overlaps) = match corner {
        CornerMode::Stop => return JointKind::Stop,
        _ if !has_curvature_step && !has_direction_step => return JointKind::Smooth,
        CornerMode::Exact => (EXACT_TOLERANCE, false),
        CornerMode::Joined { linear_mm, rotary_rad }
        | CornerMode::Blended { linear_mm, rotary_rad } => (
            CornerTolerance {
                linear_mm: linear_mm.max(EXACT_TOLERANCE.linear_mm),
                rotary_rad: rotary_rad.max(EXACT_TOLERANCE.rotary_rad),
            },
            true,
        ),
    };
    let speed = before.speed.max(after.speed);
    let (one, two) = (before.effort, after.effort);
    let nothing = [0.0; AXES];
    let (direction_step, curvature_step) = (
        if has_direction_step { direction_step } else { nothing },
        if has_curvature_step { curvature_step } else { nothing },
    );
    let over = |is_there: bool, step: &AxisValues, most: &AxisValues| {
        let axes = if is_there { axes } else { 0 };
        (0..axes).fold(0.0_f64, |all, axis| all.max(step[axis].abs() / most[axis]))
    };
    let by_acceleration = over(has_direction_step, &direction_step, &limits.acceleration);
    let by_jerk = [
        over(has_direction_step, &direction_step, &limits.jerk),
        over(has_curvature_step, &curvature_step, &limits.jerk),
    ];
    let (square, cube) = (speed * speed, speed * speed * speed);
    let step = JointStep {
        direction_step,
        curvature_step,
        direction_share: if has_direction_step { tolerance.of(&direction_step) } else { 0.0 },
        curvature_share: if has_curvature_step { tolerance.of(&curvature_step) } else { 0.0 },
        direction_need: (6.0 * cube * by_jerk[0]).sqrt().max(2.0 * square * by_acceleration),
        curvature_need: 3.0 * RAMP_SLOPE * cube * by_jerk[1],
        direction_effort: [by_acceleration, by_jerk[0]],
        curvature_effort: by_jerk[1],
        sides: [(before.speed, one), (after.speed, two)],
    };
    // Both corrections at once share the tolerance.
    let half = if has_direction_step && has_curvature_step { 0.5 } else { 1.0 };
    let direction_half = (half * direction_half(&step)).min(step.direction_need);
    let curvature_half = (half.sqrt() * curvature_half(&step)).min(step.curvature_need);
    let direction_half = if has_direction_step { direction_half } else { 0.0 };
    let curvature_half = if has_curvature_step { curvature_half } else { 0.0 };
    if step.speed_within(direction_half, curvature_half) >= speed {
        return JointKind::Ease(step);
    }
    let overlap = (overlaps && before.straight && after.straight)
        .then(|| overlap(before, after, &tolerance, &direction_step, limits, one, two));
    JointKind::Slow(SlowJoint { step, halves: (direction_half, curvature_half), overlap })
}

/// How long two ends with these jerks overlap, so that both are `reach` from the corner at once.
pub fn overlap_time(reach: f64, before: f64, after: f64) -> f64 {
    cbrt(6.0 * reach / before) + cbrt(6.0 * reach / after)
}

fn overlap(
    before: &JointSide,
    after: &JointSide,
    tolerance: &CornerTolerance,
    direction_step: &AxisValues,
    limits: &AxisArrays,
    one: AccelJerk,
    two: AccelJerk,
) -> OverlapLimits {
    let mut share = 1.0_f64;
    for axis in 0..AXES {
        let sum = (one.jerk * before.direction[axis] + two.jerk * after.direction[axis]).abs();
        if sum > 0.0 {
            share = share.min(limits.jerk[axis] / sum);
        }
    }
    let most = tolerance
        .of(direction_step)
        .max(tolerance.of(&before.direction))
        .max(tolerance.of(&after.direction));
    OverlapLimits { reach: 1.0 / most, jerk_share: share }
}

/// What the axes can do along a direction.
pub fn effort(direction: &[f64], limits: &AxisArrays) -> AccelJerk {
    let mut effort = AccelJerk::FREE;
    for (axis, share) in direction.iter().map(|share| share.abs()).enumerate() {
        if share > 0.0 {
            effort.acceleration = effort.acceleration.min(limits.acceleration[axis] / share);
            effort.jerk = effort.jerk.min(limits.jerk[axis] / share);
        }
    }
    effort
}

fn difference(a: &AxisValues, b: &AxisValues, axes: usize) -> AxisValues {
    let mut difference = [0.0; AXES];
    for axis in 0..axes.min(AXES) {
        difference[axis] = a[axis] - b[axis];
    }
    difference
}
