//! Random machines and random paths.

use super::cut;
use chordal_geometry::{Arc, Curve, Frame, Line, ParamCurve, Spiral, Vec3};
use chordal_motion::{AxisLimit, CornerMode, KinematicLimits, MoveRequest};

/// A small generator of numbers, the same on every machine.
pub struct Dice(pub u64);

impl Dice {
    pub fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// Evenly from `low` to `high`.
    pub fn even(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * (self.next() >> 11) as f64 / (1u64 << 53) as f64
    }

    /// Evenly in the logarithm.
    pub fn decades(&mut self, low: f64, high: f64) -> f64 {
        self.even(low.ln(), high.ln()).exp()
    }

    pub fn below(&mut self, count: u64) -> u64 {
        self.next() % count
    }

    pub fn direction(&mut self) -> Vec3 {
        loop {
            let v = Vec3::new(self.even(-1.0, 1.0), self.even(-1.0, 1.0), self.even(-1.0, 1.0));
            if let Some(unit) = v.normalized()
                && v.length() <= 1.0
            {
                return unit;
            }
        }
    }
}

/// Limits of one machine, its axes unlike each other.
pub fn random_limits(dice: &mut Dice) -> KinematicLimits {
    let mut axis = |velocity: f64, acceleration: f64, jerk: f64| {
        Some(AxisLimit {
            velocity: velocity * dice.even(0.5, 2.0),
            acceleration: acceleration * dice.even(0.5, 2.0),
            jerk: jerk * dice.even(0.5, 2.0),
        })
    };
    let linear =
        |axis: &mut dyn FnMut(f64, f64, f64) -> Option<AxisLimit>| axis(300.0, 3000.0, 1e5);
    let x = linear(&mut axis);
    let y = linear(&mut axis);
    let z = linear(&mut axis);
    KinematicLimits::new([
        x,
        y,
        z,
        axis(2.0, 20.0, 400.0),
        axis(2.0, 20.0, 400.0),
        axis(3.0, 30.0, 900.0),
    ])
    .unwrap()
}

/// What a random path may hold.
#[derive(Clone, Copy, Debug)]
pub struct Mix {
    pub moves: usize,
    pub curves: bool,
    pub rotary: bool,
    pub shortest: f64,
    pub longest: f64,
    /// How far directions turn from move to move at most, rad; above π anywhere.
    pub turn: f64,
}

/// Moves that join on.
pub fn random_path(dice: &mut Dice, mix: &Mix) -> Vec<MoveRequest> {
    let mut moves: Vec<MoveRequest> = Vec::new();
    let mut at = Vec3::ZERO;
    let mut rotary = [0.0; 3];
    let mut heading = dice.direction();
    let mut speed = dice.decades(5.0, 500.0);
    let modes = [
        CornerMode::Stop,
        CornerMode::Exact,
        CornerMode::Joined {
            linear_mm: dice.decades(1e-4, 1.0),
            rotary_rad: dice.decades(1e-5, 1e-2),
        },
        CornerMode::Joined { linear_mm: 0.01, rotary_rad: 1e-4 },
    ];
    let mut corner = modes[dice.below(4) as usize];
    while moves.len() < mix.moves {
        if dice.below(8) == 0 {
            speed = dice.decades(5.0, 2000.0);
        }
        if dice.below(12) == 0 {
            corner = modes[dice.below(4) as usize];
        }
        heading = if mix.turn > 3.0 {
            match dice.below(8) {
                0 => -heading,
                1 => heading,
                _ => dice.direction(),
            }
        } else {
            let side = dice.direction();
            let angle = dice.even(0.0, mix.turn);
            (heading + side * angle).normalized().unwrap_or(heading)
        };
        let length = dice.decades(mix.shortest, mix.longest);
        let curve: Curve = match if mix.curves { dice.below(4) } else { 0 } {
            0 | 1 => Line { start: at, end: at + heading * length }.into(),
            kind => {
                // Tangent to the heading.
                let radius = dice.decades(0.05, 50.0);
                let side = dice.direction();
                let Some(out) = heading.cross(side).normalized() else { continue };
                let axis = out.cross(heading);
                let frame = Frame::from_normal(at - out * radius, axis, out).unwrap();
                let sweep = (length / radius).clamp(1e-3, 12.0);
                let rise = if dice.below(2) == 0 { 0.0 } else { dice.even(-0.3, 0.3) * length };
                let curve: Curve = if kind == 2 {
                    Arc::new(frame, radius, sweep, rise).into()
                } else {
                    let end = radius * dice.even(0.3, 1.7);
                    Spiral::new(frame, (radius, end), sweep, rise).into()
                };
                curve
            }
        };
        let start = curve.start();
        if start.distance(at) > 1e-9 {
            continue;
        }
        heading = curve.tangent_at(curve.length());
        at = curve.end();
        let from = rotary;
        if mix.rotary && dice.below(3) != 0 {
            for angle in &mut rotary {
                *angle += dice.even(-0.02, 0.02) * length.min(10.0);
            }
        }
        let tag = moves.len() as u64;
        let motion = cut(curve, speed, corner);
        moves.push(MoveRequest { rotary_from: from, rotary_to: rotary, tag, ..motion });
    }
    moves
}
