//! Measures how much of the limits of the axes a motion uses.

use chordal_geometry::AXES;

use crate::cube_root::cbrt;
use crate::limits::KinematicLimits;
use crate::reader::state_of;
use crate::sample::AxisState;
use crate::trajectory::PlannedTrajectory;

/// The largest use of the limits, as fractions of them: 1 is a limit that is just met.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct LimitUse {
    /// Largest velocity of an axis over its limit.
    pub velocity: f64,
    /// Largest acceleration of an axis over its limit.
    pub acceleration: f64,
    /// Largest jerk of an axis over its limit.
    pub jerk: f64,
}

impl LimitUse {
    /// The larger of both for each quantity.
    #[must_use]
    pub fn or(self, other: LimitUse) -> LimitUse {
        LimitUse {
            velocity: self.velocity.max(other.velocity),
            acceleration: self.acceleration.max(other.acceleration),
            jerk: self.jerk.max(other.jerk),
        }
    }

    /// The use at an instant.
    #[must_use]
    pub fn of(state: &AxisState, limits: &KinematicLimits) -> LimitUse {
        let mut used = LimitUse::default();
        for axis in 0..AXES {
            let Some(limit) = limits.axis(axis) else { continue };
            used.velocity = used.velocity.max(state.velocity[axis].abs() / limit.velocity);
            used.acceleration =
                used.acceleration.max(state.acceleration[axis].abs() / limit.acceleration);
            used.jerk = used.jerk.max(state.jerk[axis].abs() / limit.jerk);
        }
        used
    }

    /// The factor by which the motion must take longer to stay within every limit; at most 1 if it
    /// does so already.
    #[must_use]
    pub fn time_scale(&self) -> f64 {
        self.velocity.max(self.acceleration.sqrt()).max(cbrt(self.jerk))
    }
}

/// Distances in σ below this are rounding.
const NEGLIGIBLE_SIGMA: f64 = 1e-11;

/// The largest use in a trajectory, measured on each part with one piece and one phase at both its ends and
/// at `probes` points between.
#[must_use]
pub fn largest_use(
    trajectory: &PlannedTrajectory,
    limits: &KinematicLimits,
    probes: u32,
) -> LimitUse {
    let mut used = LimitUse::default();
    let mut pieces = trajectory.pieces.iter();
    let Some(mut piece) = pieces.next() else { return used };
    let mut piece_from = 0.0;
    for phase in &trajectory.phases {
        let mut t = 0.0;
        loop {
            let end = piece_from + piece.length;
            let leaves = (phase.at(phase.duration_s).sigma > end).then(|| phase.time_at(end, t));
            let until = leaves.unwrap_or(phase.duration_s);
            // The starts of a phase and a piece at one point may differ by rounding.
            let distance = phase.at(until).sigma - phase.at(t).sigma;
            let probes = if distance > NEGLIGIBLE_SIGMA { probes + 2 } else { 0 };
            for probe in 0..probes {
                let along = phase.at(t + (until - t) * f64::from(probe) / f64::from(probes - 1));
                let sigma = (along.sigma - piece_from).clamp(0.0, piece.length);
                used = used.or(LimitUse::of(&state_of(piece, sigma, &along), limits));
            }
            t = until;
            if leaves.is_none() {
                break;
            }
            piece_from += piece.length;
            match pieces.next() {
                Some(next) => piece = next,
                None => return used,
            }
        }
    }
    used
}
