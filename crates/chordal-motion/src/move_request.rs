//! A move as the input of the planner, and how the corner at its end is passed.

use chordal_geometry::{AXES, Curve, ParamCurve};

use crate::AxisValues;
use crate::limits::{KinematicLimits, letter};

/// How the end of a move is passed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum CornerMode {
    /// The axes come to rest at the end.
    Stop,
    /// The path is followed exactly: the axes rest where its direction or curvature has a step, and do not
    /// where it is smooth.
    Exact,
    /// Without rest, within the tolerance of the programmed path; many short moves may become one curve.
    Joined {
        /// The tolerance of X, Y and Z, mm.
        linear_mm: f64,
        /// The tolerance of each rotary axis, rad.
        rotary_rad: f64,
    },
    /// Without rest, within the tolerance of the programmed path, and each corner is blended by itself.
    Blended {
        /// The tolerance of X, Y and Z, mm.
        linear_mm: f64,
        /// The tolerance of each rotary axis, rad.
        rotary_rad: f64,
    },
}

impl CornerMode {
    /// How far from the corner the axes may pass: mm, and rad of each rotary axis. `None` where the path is
    /// followed exactly or the axes rest.
    pub fn tolerance(&self) -> Option<(f64, f64)> {
        match *self {
            CornerMode::Stop | CornerMode::Exact => None,
            CornerMode::Joined { linear_mm, rotary_rad }
            | CornerMode::Blended { linear_mm, rotary_rad } => Some((linear_mm, rotary_rad)),
        }
    }
}

/// What a move is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MoveKind {
    /// Positioning: nothing is cut, and rapids may have limits of their own.
    Rapid,
    /// A move at a feed.
    Cut,
}

/// An exact piece of path, its speed and its corner. Rotary axes turn in proportion to the distance along it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MoveRequest {
    /// The curve of X, Y and Z, mm.
    pub curve: Curve,
    /// Rotary axes A B C at the start, rad.
    pub rotary_from: [f64; 3],
    /// Rotary axes A B C at the end, rad.
    pub rotary_to: [f64; 3],
    /// The length of the path to which speed and distances refer, mm, where it is not that of the curve: the path of the tip
    /// while the axes move straight. Only lines have it.
    pub path_length: Option<f64>,
    /// Largest speed along the path, mm/s (rad/s where rotary axes alone move); infinite for as
    /// fast as the axis limits allow.
    pub speed: f64,
    /// How the corner at its end is passed. After the last move the axes rest in any case.
    pub corner: CornerMode,
    /// Rapid or cut. The planner treats both alike: rapids with other limits are planned by another planner.
    pub kind: MoveKind,
    /// A number of the caller, such as the line of the block, which pieces and setpoints get, too.
    pub tag: u64,
}

/// A move that cannot be planned.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum MoveError {
    /// A number that is not finite.
    #[error("a coordinate of the move is not a finite number")]
    NotFinite,
    /// A speed that is zero, negative or NaN.
    #[error("the speed of the move is {0} mm/s: it must be above zero")]
    Speed(f64),
    /// A motion of an axis that the machine does not have.
    #[error("axis {} moves, but no limits are given for it", letter(*.0))]
    NoAxis(usize),
    /// A tolerance that is negative or NaN.
    #[error("the tolerance of the corner is {0}: it must not be below zero")]
    Tolerance(f64),
    /// The move does not begin where the previous one ends.
    #[error("the move begins {0} mm (or rad) away from the end of the move before it")]
    Gap(f64),
}

impl MoveRequest {
    /// Its length in σ: mm of X, Y and Z or of the path of the tip, or rad where rotary axes alone move.
    pub fn length(&self) -> f64 {
        if let Some(length) = self.path_length {
            return length;
        }
        let length = self.curve.length();
        if length > 0.0 { length } else { self.turn() }
    }

    /// Whether rotary axes alone move, and σ is an angle.
    pub fn turns_only(&self) -> bool {
        self.path_length.is_none() && self.curve.length() <= 0.0
    }

    /// How long it takes at its speed, s.
    pub fn at_speed_s(&self) -> f64 {
        self.length() / self.speed
    }

    /// How far the rotary axes turn, rad.
    fn turn(&self) -> f64 {
        (0..3).map(|i| (self.rotary_to[i] - self.rotary_from[i]).powi(2)).sum::<f64>().sqrt()
    }

    /// The axes at its start, mm and rad.
    pub fn from(&self) -> AxisValues {
        join(self.curve.start().to_array(), self.rotary_from)
    }

    /// The axes at its end, mm and rad.
    pub fn to(&self) -> AxisValues {
        join(self.curve.end().to_array(), self.rotary_to)
    }

    /// The axes after a fraction of its length, 0 to 1, mm and rad.
    pub fn at(&self, share: f64) -> AxisValues {
        let place = self.curve.point_at(share * self.curve.length()).to_array();
        let turned =
            |i: usize| self.rotary_from[i] + share * (self.rotary_to[i] - self.rotary_from[i]);
        join(place, std::array::from_fn(turned))
    }

    /// Checks that it can be planned.
    ///
    /// # Errors
    /// The first reason why it cannot.
    pub fn check(&self, limits: &KinematicLimits) -> Result<(), MoveError> {
        let (from, to) = (self.from(), self.to());
        let length = self.length();
        if !from.iter().chain(&to).all(|value| value.is_finite()) || !length.is_finite() {
            return Err(MoveError::NotFinite);
        }
        if self.speed.is_nan() || self.speed <= 0.0 {
            return Err(MoveError::Speed(self.speed));
        }
        if let Some((linear_mm, rotary_rad)) = self.corner.tolerance() {
            for tolerance in [linear_mm, rotary_rad] {
                if tolerance.is_nan() || tolerance < 0.0 {
                    return Err(MoveError::Tolerance(tolerance));
                }
            }
        }
        // The extent of a curve is expensive to find, and needed only on machines that lack an axis.
        let extent = || {
            let bounds = self.curve.bounds();
            (bounds.min.to_array(), bounds.max.to_array())
        };
        let moves = |axis: usize| {
            if axis < 3 {
                let (min, max) = extent();
                min[axis] < max[axis]
            } else {
                from[axis] != to[axis]
            }
        };
        match (0..AXES).find(|axis| limits.axis(*axis).is_none() && moves(*axis)) {
            Some(axis) => Err(MoveError::NoAxis(axis)),
            None => Ok(()),
        }
    }
}

fn join(linear: [f64; 3], rotary: [f64; 3]) -> AxisValues {
    [linear[0], linear[1], linear[2], rotary[0], rotary[1], rotary[2]]
}
