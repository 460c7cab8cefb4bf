//! Trajectories made by hand: pieces of path, and the seven phases of a profile from rest to rest.

use super::line;
use chordal_geometry::{AXES, Arc, Curve, ParamCurve, Plane};
use chordal_motion::{AxisValues, JerkPhase, PathPiece, PlannedTrajectory};

/// Largest speed, acceleration and jerk along the path.
#[derive(Clone, Copy, Debug)]
pub struct Law {
    pub speed: f64,
    pub acceleration: f64,
    pub jerk: f64,
}

pub const LAW: Law = Law { speed: 100.0, acceleration: 2000.0, jerk: 1e5 };

/// What a speed takes: the time of each change of acceleration and the even time between two.
struct Ramp {
    bend_s: f64,
    even_s: f64,
}

impl Ramp {
    fn time_s(&self) -> f64 {
        2.0 * self.bend_s + self.even_s
    }
}

impl Law {
    /// From rest to a speed.
    fn ramp(&self, speed: f64) -> Ramp {
        let bend_s = (self.acceleration / self.jerk).min((speed / self.jerk).sqrt());
        Ramp { bend_s, even_s: (speed / self.acceleration - bend_s).max(0.0) }
    }

    /// The largest speed from rest to rest over a length.
    fn top(&self, length: f64) -> f64 {
        let distance = |speed: f64| speed * self.ramp(speed).time_s();
        if distance(self.speed) <= length {
            return self.speed;
        }
        let (mut low, mut high) = (0.0, self.speed);
        for _ in 0..200 {
            let mid = 0.5 * (low + high);
            if distance(mid) > length { high = mid } else { low = mid }
        }
        low
    }

    /// Time from rest to rest over a length: seven phases, or fewer where it is short.
    pub fn time_s(&self, length: f64) -> f64 {
        let top = self.top(length);
        let ramp_s = self.ramp(top).time_s();
        2.0 * ramp_s + (length / top - ramp_s).max(0.0)
    }

    /// The phases from rest to rest over a length.
    pub fn phases(&self, length: f64) -> Vec<JerkPhase> {
        let top = self.top(length);
        let ramp = self.ramp(top);
        let cruise_s = (length / top - ramp.time_s()).max(0.0);
        let mut phases = Vec::new();
        let mut at = (0.0, 0.0, 0.0);
        for (duration_s, jerk) in [
            (ramp.bend_s, self.jerk),
            (ramp.even_s, 0.0),
            (ramp.bend_s, -self.jerk),
            (cruise_s, 0.0),
            (ramp.bend_s, -self.jerk),
            (ramp.even_s, 0.0),
            (ramp.bend_s, self.jerk),
        ] {
            if duration_s <= 0.0 {
                continue;
            }
            let phase = JerkPhase { duration_s, from: at.0, speed: at.1, acceleration: at.2, jerk };
            let end = phase.at(duration_s);
            // Rounding must not be carried on where the acceleration is known to be gone.
            let settled = end.acceleration.abs() < 1e-9 * self.acceleration;
            at = (end.sigma, end.speed, if settled { 0.0 } else { end.acceleration });
            phases.push(phase);
        }
        phases
    }

    /// Pieces from rest to rest.
    pub fn trajectory(&self, pieces: Vec<PathPiece>) -> PlannedTrajectory {
        let length = pieces.iter().map(|piece| piece.length).sum();
        PlannedTrajectory { phases: self.phases(length), pieces, overlap_s: 0.0 }
    }
}

/// A straight piece in a direction of all axes.
pub fn straight(from: AxisValues, direction: AxisValues, length: f64, tag: u64) -> PathPiece {
    PathPiece { length, base: None, start: [from, direction, [0.0; AXES], [0.0; AXES]], tag }
}

/// The piece of path of a curve, with straight lines as polynomials.
pub fn piece(curve: Curve, tag: u64) -> PathPiece {
    let length = curve.length();
    if let Curve::Line(_) = curve {
        let mut axes = [[0.0; AXES]; 2];
        axes[0][..3].copy_from_slice(&curve.start().to_array());
        axes[1][..3].copy_from_slice(&curve.tangent_at(0.0).to_array());
        return straight(axes[0], axes[1], length, tag);
    }
    PathPiece { length, base: Some((curve, 0.0)), start: [[0.0; AXES]; 4], tag }
}

/// The piece of a straight line.
pub fn straight_piece(from: [f64; 3], to: [f64; 3]) -> PathPiece {
    piece(line(from, to), 0)
}

/// A line cut into pieces.
pub fn cut_line(from: [f64; 3], to: [f64; 3], count: usize) -> Vec<PathPiece> {
    let whole = straight_piece(from, to);
    let length = whole.length / count as f64;
    (0..count)
        .map(|i| {
            let [at, direction, ..] = whole.at(length * i as f64);
            straight(at, direction, length, i as u64)
        })
        .collect()
}

/// Along an arc about the origin, at a speed at which a circle holds 2000 mm/s² and 1e5 mm/s³ of
/// its axes with some room.
pub fn circle_trajectory(radius: f64, sweep: f64, tag: u64) -> PlannedTrajectory {
    // With v²/R at 1000 and the path's own at 500, an axis stays below 1500 of 2000, and its
    // jerk κ²v³ + 3κva + j below 1e5.
    let speed = (1000.0 * radius).sqrt().min(150.0).min((2e4 * radius * radius).cbrt());
    let arc = Arc::new(Plane::Xy.frame(), radius, sweep, 0.0);
    Law { speed, acceleration: 500.0, jerk: 2e4 }.trajectory(vec![piece(arc.into(), tag)])
}
