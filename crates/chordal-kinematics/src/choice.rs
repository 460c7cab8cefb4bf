//! Which of several solutions a control takes.

use core::cmp::Ordering;
use core::f64::consts::TAU;
use core::fmt;

use crate::chain::{KinematicChain, MAX_JOINTS};
use crate::inverse::{JointSolution, JointSolutions};
use crate::joint::{JointAngles, RotaryJoint, RotaryLetter};
use crate::math;
use crate::triangle::AxisTriangle;

/// What differences of angles are ties, rad: a millionth of the least increment of any control.
const TIE_RAD: f64 = 1e-11;

/// How far outside of its travel an angle may be by the rounding of conversions, rad.
const TRAVEL_ROUNDING_RAD: f64 = 1e-12;

/// A sign of an angle.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum AngleSign {
    /// Zero or more.
    Positive,
    /// Zero or less.
    Negative,
}

/// Which solution a control takes of those within the travel of the axes, each with the whole turns that bring it near
/// the present angles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SolutionRule {
    /// The smallest movement of the master; then of the slave; then the master nearest to 0 or a multiple of 360 degrees;
    /// then the slave (Fanuc A-79348E p.28, 16i-MB G53.1). Which axis is the master is a parameter of the machine;
    /// [`KinematicChain::master`] is the usual one.
    MasterMovement {
        /// The master.
        master: RotaryLetter,
    },
    /// Near the pole the side on which the second axis is now; from the pole itself the side with more travel, and the
    /// negative one if both have the same (Mitsubishi M700 programming manual p.485). Farther from it, and where that
    /// side has no solution within travel, the smallest sum of movements.
    PoleSide {
        /// How near to the pole a direction is for this rule, rad (parameter #7907).
        near_rad: f64,
    },
    /// The primary axis nearest to 0 degrees, perhaps only with one sign (LinuxCNC, G53.1 of the remap for tilted work
    /// planes: P1 positive, P2 negative).
    LeastAngle {
        /// The primary axis.
        primary: RotaryLetter,
        /// The sign that it must have; `None`: either.
        sign: Option<AngleSign>,
    },
    /// The smallest sum of movements, perhaps only with one sign of an axis (LinuxCNC, the draft of native work planes:
    /// P1 and P2 are the sign of the secondary axis).
    LeastMovement {
        /// The axis whose sign is fixed, and that sign; `None`: no axis.
        sign: Option<(RotaryLetter, AngleSign)>,
    },
}

impl SolutionRule {
    /// The smallest sum of movements, whatever the signs are.
    pub const LEAST_MOVEMENT: SolutionRule = SolutionRule::LeastMovement { sign: None };
}

/// Why no solution was chosen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ChoiceError {
    /// In every solution an axis is outside of its travel.
    OutOfTravel {
        /// An axis that is outside in the solution that is nearest to its travel.
        letter: RotaryLetter,
        /// How far outside it is there, rad.
        beyond_rad: f64,
    },
    /// No solution within travel has the sign that the rule asks for.
    NoSuchSign {
        /// The axis whose sign it is.
        letter: RotaryLetter,
    },
}

impl fmt::Display for ChoiceError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            ChoiceError::OutOfTravel { letter, beyond_rad } => {
                let degrees = math::degrees_text(*beyond_rad);
                write!(f, "no solution is within travel: {letter} is {degrees} deg outside")
            }
            ChoiceError::NoSuchSign { letter } => {
                write!(f, "no solution within travel has the sign of {letter} that is asked for")
            }
        }
    }
}

impl core::error::Error for ChoiceError {}

/// Two solutions, with the turns next to the present angles on either side for each of two axes.
const MAX_CANDIDATES: usize = 8;

/// The angles among which a control chooses, in order.
#[derive(Clone, Copy)]
struct AngleCandidates {
    angles: [JointAngles; MAX_CANDIDATES],
    count: usize,
}

impl AngleCandidates {
    const NONE: AngleCandidates = AngleCandidates { angles: [[0.0; 3]; MAX_CANDIDATES], count: 0 };

    /// Those of some that fulfil a condition.
    fn of(candidates: &[JointAngles], fulfils: impl Fn(&JointAngles) -> bool) -> AngleCandidates {
        let mut kept = AngleCandidates::NONE;
        candidates.iter().filter(|angles| fulfils(angles)).for_each(|angles| kept.push(*angles));
        kept
    }

    /// Appends angles, of which there are never more than fit.
    fn push(&mut self, angles: JointAngles) {
        if let Some(place) = self.angles.get_mut(self.count) {
            *place = angles;
            self.count += 1;
        }
    }

    fn as_slice(&self) -> &[JointAngles] {
        &self.angles[..self.count]
    }
}

impl KinematicChain {
    /// The angles that a control takes, rad: of the solutions with every number of whole turns within travel, the one
    /// that the rule prefers. A free axis stays where it is, and so do the angles of axes that the chain does not have.
    ///
    /// # Errors
    /// See [`ChoiceError`].
    pub fn choose(
        &self,
        solutions: &JointSolutions,
        present: &JointAngles,
        rule: SolutionRule,
    ) -> Result<JointAngles, ChoiceError> {
        let candidates = self.within_travel(solutions.as_slice(), present)?;
        let chosen = match rule {
            SolutionRule::MasterMovement { master } => {
                least(candidates.as_slice(), |angles| self.master_order(master, angles, present))
            }
            SolutionRule::PoleSide { near_rad } => {
                let on_side = self.on_present_side(candidates.as_slice(), present, near_rad);
                least(on_side.as_slice(), |angles| [sum_of_movements(angles, present)]).or_else(
                    || least(candidates.as_slice(), |angles| [sum_of_movements(angles, present)]),
                )
            }
            SolutionRule::LeastAngle { primary, sign } => {
                let signed = with_sign(candidates.as_slice(), sign.map(|sign| (primary, sign)))?;
                least(signed.as_slice(), |angles| {
                    [angles[primary.index()].abs(), sum_of_movements(angles, present)]
                })
            }
            SolutionRule::LeastMovement { sign } => {
                let signed = with_sign(candidates.as_slice(), sign)?;
                least(signed.as_slice(), |angles| [sum_of_movements(angles, present)])
            }
        };
        // There is a candidate, or an error has been returned above.
        Ok(chosen.unwrap_or(*present))
    }

    /// Every solution with the whole turns that bring its axes next to the present angles from either side, within
    /// travel.
    fn within_travel(
        &self,
        solutions: &[JointSolution],
        present: &JointAngles,
    ) -> Result<AngleCandidates, ChoiceError> {
        let mut candidates = AngleCandidates::NONE;
        let mut nearest: Option<(RotaryLetter, f64)> = None;
        for solution in solutions {
            // An axis that is free, or that the chain does not have, has one choice: where it is.
            let mut turned = [[Some(None), None]; MAX_JOINTS];
            for (turned, joint) in turned.iter_mut().zip(self.joints()) {
                if solution.free == Some(joint.letter) {
                    continue;
                }
                let index = joint.letter.index();
                let angles = turns_within_travel(joint, solution.angles[index], present[index]);
                *turned = angles.map(|angle| angle.map(|angle| Some((index, angle))));
                if angles.iter().all(Option::is_none) {
                    let beyond = beyond_travel(joint, solution.angles[index]);
                    if nearest.is_none_or(|(_, other)| beyond < other) {
                        nearest = Some((joint.letter, beyond));
                    }
                }
            }
            for first in turned[0].into_iter().flatten() {
                for second in turned[1].into_iter().flatten() {
                    let mut angles = *present;
                    for (index, angle) in [first, second].into_iter().flatten() {
                        angles[index] = angle;
                    }
                    candidates.push(angles);
                }
            }
        }
        match nearest {
            Some((letter, beyond_rad)) if candidates.as_slice().is_empty() => {
                Err(ChoiceError::OutOfTravel { letter, beyond_rad })
            }
            _ => Ok(candidates),
        }
    }

    /// What Fanuc compares, in order.
    fn master_order(
        &self,
        master: RotaryLetter,
        angles: &JointAngles,
        present: &JointAngles,
    ) -> [f64; 4] {
        let slave = self.joints().iter().map(|joint| joint.letter).find(|own| *own != master);
        let movement =
            |letter: RotaryLetter| (angles[letter.index()] - present[letter.index()]).abs();
        let from_zero = |letter: RotaryLetter| math::within_half_turn(angles[letter.index()]).abs();
        [
            movement(master),
            slave.map_or(0.0, movement),
            from_zero(master),
            slave.map_or(0.0, from_zero),
        ]
    }

    /// The candidates near the pole on the side of the second axis that Mitsubishi keeps; none if they are not near it.
    fn on_present_side(
        &self,
        candidates: &[JointAngles],
        present: &JointAngles,
        near_rad: f64,
    ) -> AngleCandidates {
        let (Some(triangle), Some(first)) = (AxisTriangle::of(self), candidates.first()) else {
            return AngleCandidates::NONE;
        };
        let polar = triangle.polar_angle(self.direction(first));
        let second = &self.joints()[1];
        let Some(pole) = triangle.pole_angle(polar) else { return AngleCandidates::NONE };
        if polar.min(core::f64::consts::PI - polar) > near_rad {
            return AngleCandidates::NONE;
        }
        let pole = second.sign() * pole;
        let index = second.letter.index();
        let side = |angles: &JointAngles| math::within_half_turn(angles[index] - pole);
        let kept = match side(present) {
            now if now > TIE_RAD => 1.0,
            now if now < -TIE_RAD => -1.0,
            _ => side_with_more_travel(second, math::nearest_turn(pole, present[index])),
        };
        AngleCandidates::of(candidates, |angles| side(angles) * kept >= -TIE_RAD)
    }
}

/// The side of a pole on which an axis has more travel: +1 or −1; −1 if both have the same.
fn side_with_more_travel(joint: &RotaryJoint, pole: f64) -> f64 {
    match joint.travel {
        Some((low, high)) if high - pole > pole - low + TIE_RAD => 1.0,
        _ => -1.0,
    }
}

fn sum_of_movements(angles: &JointAngles, present: &JointAngles) -> f64 {
    angles.iter().zip(present).map(|(angle, now)| (angle - now).abs()).sum()
}

fn with_sign(
    candidates: &[JointAngles],
    sign: Option<(RotaryLetter, AngleSign)>,
) -> Result<AngleCandidates, ChoiceError> {
    let Some((letter, sign)) = sign else { return Ok(AngleCandidates::of(candidates, |_| true)) };
    let signed = AngleCandidates::of(candidates, |angles| match sign {
        AngleSign::Positive => angles[letter.index()] >= -TIE_RAD,
        AngleSign::Negative => angles[letter.index()] <= TIE_RAD,
    });
    if signed.as_slice().is_empty() { Err(ChoiceError::NoSuchSign { letter }) } else { Ok(signed) }
}

/// The first candidate of the least order, compared number by number; numbers that differ by rounding are ties.
fn least<const N: usize>(
    candidates: &[JointAngles],
    order: impl Fn(&JointAngles) -> [f64; N],
) -> Option<JointAngles> {
    let compare = |a: &[f64; N], b: &[f64; N]| {
        let differs = a.iter().zip(b).find(|(a, b)| (**a - **b).abs() > TIE_RAD);
        differs.map_or(Ordering::Equal, |(a, b)| a.total_cmp(b))
    };
    let mut best: Option<(JointAngles, [f64; N])> = None;
    for angles in candidates {
        let own = order(angles);
        if best.as_ref().is_none_or(|(_, other)| compare(&own, other) == Ordering::Less) {
            best = Some((*angles, own));
        }
    }
    best.map(|(angles, _)| angles)
}

/// The angle with the whole turns that bring it next to another one within travel: from above, then from below, so that
/// of half a turn the positive direction is first; if it is equal, that alone.
fn turns_within_travel(joint: &RotaryJoint, angle: f64, present: f64) -> [Option<f64>; 2] {
    let (low, high) = joint.travel.unwrap_or((f64::NEG_INFINITY, f64::INFINITY));
    let (low, high) = (low - TRAVEL_ROUNDING_RAD, high + TRAVEL_ROUNDING_RAD);
    // Present angles outside of travel are read as its nearest end.
    let present = present.clamp(low, high);
    let above = angle + TAU * math::ceil((present - angle) / TAU - TRAVEL_ROUNDING_RAD);
    let is_present = above - present <= TRAVEL_ROUNDING_RAD;
    let within = |angle: &f64| (low..=high).contains(angle);
    let below = Some(above - TAU).filter(|_| !is_present);
    [Some(above).filter(within), below.filter(within)]
}

/// How far the nearest turn of an angle is outside of the travel of an axis, rad.
fn beyond_travel(joint: &RotaryJoint, angle: f64) -> f64 {
    let Some((low, high)) = joint.travel else { return 0.0 };
    let from = |end: f64| (math::nearest_turn(angle, end) - end).abs();
    from(low).min(from(high))
}
