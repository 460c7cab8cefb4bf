//! Stretches made by hand: a path and the seven phases of a rest-to-rest law.

#![allow(dead_code, reason = "each test uses its own part")]

use chordal_geometry::{Curve, ParamCurve};
use chordal_motion::{Axes, Phase, Piece, Stretch};

/// Largest speed, acceleration and jerk along the path.
#[derive(Clone, Copy, Debug)]
pub struct Law {
    pub speed: f64,
    pub acceleration: f64,
    pub jerk: f64,
}

pub const LAW: Law = Law { speed: 100.0, acceleration: 2000.0, jerk: 1e5 };

impl Law {
    /// Time from rest to speed, s; both limits are reached.
    pub fn ramp_s(&self) -> f64 {
        self.speed / self.acceleration + self.acceleration / self.jerk
    }

    /// From rest to rest over a length that suffices to reach the speed.
    pub fn phases(&self, length: f64) -> Vec<Phase> {
        let Law { speed, acceleration, jerk } = *self;
        let bend = acceleration / jerk;
        let even = speed / acceleration - bend;
        let cruise = (length - speed * self.ramp_s()) / speed;
        assert!(even >= 0.0 && cruise >= 0.0);
        let mut phases = Vec::new();
        let mut at = (0.0, 0.0, 0.0);
        for (duration_s, jerk) in [
            (bend, jerk),
            (even, 0.0),
            (bend, -jerk),
            (cruise, 0.0),
            (bend, -jerk),
            (even, 0.0),
            (bend, jerk),
        ] {
            let phase = Phase { duration_s, from: at.0, speed: at.1, acceleration: at.2, jerk };
            let along = phase.at(duration_s);
            at = (along.sigma, along.speed, along.acceleration);
            phases.push(phase);
        }
        phases
    }
}

/// A straight piece.
pub fn straight(from: Axes, direction: Axes, length: f64, tag: u64) -> Piece {
    Piece { length, base: None, start: [from, direction, [0.0; 6], [0.0; 6]], tag }
}

/// A piece over a curve.
pub fn over(curve: Curve, tag: u64) -> Piece {
    Piece { length: curve.length(), base: Some((curve, 0.0)), start: [[0.0; 6]; 4], tag }
}

/// Pieces from rest to rest.
pub fn stretch(pieces: Vec<Piece>, law: Law, overlap_s: f64) -> Stretch {
    let length = pieces.iter().map(|piece| piece.length).sum();
    Stretch { phases: law.phases(length), pieces, overlap_s }
}
