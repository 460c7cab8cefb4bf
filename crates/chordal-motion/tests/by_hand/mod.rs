//! Stretches made by hand, and what is asked of setpoints.

#![allow(dead_code, reason = "each test binary uses its part")]

use chordal_geometry::{Arc, Curve, Line, ParamCurve, Plane, Vec3};
use chordal_motion::{Axes, AxisLimit, Limits, Phase, Piece, Setpoint, Stretch};

/// The axes X, Y and Z with the same limits.
pub fn limits(velocity: f64, acceleration: f64, jerk: f64) -> Limits {
    let axis = Some(AxisLimit { velocity, acceleration, jerk });
    Limits::new([axis, axis, axis, None, None, None]).expect("positive limits")
}

pub fn line(from: [f64; 3], to: [f64; 3]) -> Curve {
    let at = |p: [f64; 3]| Vec3::new(p[0], p[1], p[2]);
    Line::new(at(from), at(to)).into()
}

pub fn circle(radius: f64, sweep: f64) -> Curve {
    Arc::new(Plane::Xy.frame(), radius, sweep, 0.0).into()
}

/// The piece of path of a curve, with straight lines as polynomials.
pub fn piece(curve: &Curve, tag: u64) -> Piece {
    let length = curve.length();
    let mut start = [[0.0; 6]; 4];
    let base = match curve {
        Curve::Line(_) => {
            start[0][..3].copy_from_slice(&curve.start().to_array());
            start[1][..3].copy_from_slice(&curve.tangent_at(0.0).to_array());
            None
        }
        _ => Some((*curve, 0.0)),
    };
    Piece { length, base, start, tag }
}

/// A line cut into pieces.
pub fn cut_line(from: [f64; 3], to: [f64; 3], count: usize) -> Vec<Piece> {
    let whole = line(from, to);
    let step = whole.length() / count as f64;
    (0..count)
        .map(|i| {
            let mut piece = piece(&whole, i as u64);
            let at = whole.point_at(step * i as f64).to_array();
            piece.start[0][..3].copy_from_slice(&at);
            piece.length = step;
            piece
        })
        .collect()
}

/// From rest to rest along pieces in seven phases.
pub fn stretch(pieces: Vec<Piece>, speed: f64, acceleration: f64, jerk: f64) -> Stretch {
    let length: f64 = pieces.iter().map(|piece| piece.length).sum();
    let times = |top: f64| {
        let build = (acceleration / jerk).min((top / jerk).sqrt());
        (build, (top / acceleration - build).max(0.0))
    };
    let way = |top: f64| {
        let (build, even) = times(top);
        top * (2.0 * build + even)
    };
    let mut top = speed;
    if way(top) > length {
        let (mut low, mut high) = (0.0, speed);
        for _ in 0..200 {
            top = (low + high) / 2.0;
            if way(top) > length { high = top } else { low = top }
        }
        top = low;
    }
    let (build, even) = times(top);
    let cruise = (length - way(top)).max(0.0) / top;
    let mut phases = Vec::new();
    let mut along = (0.0, 0.0, 0.0);
    for (duration_s, jerk) in [
        (build, jerk),
        (even, 0.0),
        (build, -jerk),
        (cruise, 0.0),
        (build, -jerk),
        (even, 0.0),
        (build, jerk),
    ] {
        if duration_s <= 0.0 {
            continue;
        }
        let phase =
            Phase { duration_s, from: along.0, speed: along.1, acceleration: along.2, jerk };
        let end = phase.at(duration_s);
        // Rounding must not be carried on where the acceleration is known to be gone.
        let settled = end.acceleration.abs() < 1e-9 * acceleration;
        along = (end.sigma, end.speed, if settled { 0.0 } else { end.acceleration });
        phases.push(phase);
    }
    Stretch { pieces, phases, overlap_s: 0.0 }
}

/// Speed and scalar limits at which a circle holds the limits of its axes with some room.
pub fn circle_stretch(radius: f64, sweep: f64, tag: u64) -> Stretch {
    // With v²/R at 1000 and the path's own at 500, an axis stays below 1500 of 2000, and its
    // jerk κ²v³ + 3κva + j below 1e5.
    let speed = (1000.0 * radius).sqrt().min(150.0).min((2e4 * radius * radius).cbrt());
    stretch(vec![piece(&circle(radius, sweep), tag)], speed, 500.0, 2e4)
}

/// Largest differences of setpoints by time, over limits.
#[derive(Debug, Default)]
pub struct Watch {
    last: Vec<Axes>,
    /// Ratios of velocity, acceleration and jerk to their limits, by differences.
    pub worst: [f64; 3],
    /// Ratios of the velocity and acceleration that come with the setpoint.
    pub told: [f64; 2],
}

impl Watch {
    pub fn take(&mut self, point: &Setpoint, period_s: f64, limits: &Limits) {
        self.last.push(point.position);
        if self.last.len() > 4 {
            self.last.remove(0);
        }
        let back = |axis: usize, count: usize| {
            let at = self.last.len().checked_sub(1 + count)?;
            Some(self.last[at][axis])
        };
        for axis in 0..6 {
            let Some(limit) = limits.axis(axis) else { continue };
            let [a, b, c, d] = [3, 2, 1, 0].map(|count| back(axis, count));
            let mut take = |row: usize, value: Option<f64>, limit: f64| {
                if let Some(value) = value {
                    let share = value.abs() / period_s.powi(row as i32 + 1) / limit;
                    self.worst[row] = self.worst[row].max(share);
                }
            };
            let (Some(d), Some(c)) = (d, c) else { continue };
            take(0, Some(d - c), limit.velocity);
            take(1, b.map(|b| d - 2.0 * c + b), limit.acceleration);
            take(2, a.zip(b).map(|(a, b)| d - 3.0 * c + 3.0 * b - a), limit.jerk);
            self.told[0] = self.told[0].max(point.velocity[axis].abs() / limit.velocity);
            self.told[1] = self.told[1].max(point.acceleration[axis].abs() / limit.acceleration);
        }
    }

    /// Fails when a limit was broken by more than a relative 1e-6 and what rounding does to
    /// differences of coordinates of some hundred mm.
    pub fn check(&self, period_s: f64, limits: &Limits) {
        let least = limits.axis(0).expect("an X axis");
        let rounding = 1e-13;
        let slack = [
            rounding / period_s / least.velocity,
            4.0 * rounding / period_s.powi(2) / least.acceleration,
            8.0 * rounding / period_s.powi(3) / least.jerk,
        ];
        for (worst, slack) in self.worst.iter().zip(slack) {
            assert!(*worst <= 1.0 + 1e-6 + slack, "{self:?}");
        }
        for told in self.told {
            assert!(told <= 1.0 + 1e-6, "{self:?}");
        }
    }
}
