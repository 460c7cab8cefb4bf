//! The profile as phases of even jerk, and what they use of the limits.

use super::grid::ProfileGrid;
use crate::limit_use::LimitUse;
use crate::time_bound::PathRun;
use crate::trajectory::{JerkPhase, ProfilePoint};

/// On a part of an interval the speed changes by no larger share.
const MAX_SPEED_CHANGE_SHARE: f64 = 0.04;
const MAX_INTERVAL_PARTS: f64 = 16.0;
/// Places of a phase that are looked at, and where one of them uses nearly all of a limit.
const PHASE_PROBES: [u32; 2] = [4, 16];
const NEARLY_USED_SHARE: f64 = 0.999;

/// σ̇ and σ̈ at a node.
#[derive(Clone, Copy, Debug)]
struct NodeMotion {
    speed: f64,
    acceleration: f64,
}

/// Two phases of one duration from one passing to another, or one of even speed.
fn pair(at: f64, length: f64, from: NodeMotion, to: NodeMotion, take: &mut impl FnMut(JerkPhase)) {
    if from.speed == to.speed && from.acceleration == 0.0 && to.acceleration == 0.0 {
        let (duration_s, speed) = (length / from.speed, from.speed);
        return take(JerkPhase { duration_s, from: at, speed, acceleration: 0.0, jerk: 0.0 });
    }
    let sum = from.speed + to.speed;
    let change = from.acceleration - to.acceleration;
    let duration_s =
        2.0 * length / (sum + (sum * sum + 4.0 * length * change / 3.0).max(0.0).sqrt());
    let middle = (to.speed - from.speed) / duration_s - 0.5 * (from.acceleration + to.acceleration);
    let first = JerkPhase {
        duration_s,
        from: at,
        speed: from.speed,
        acceleration: from.acceleration,
        jerk: (middle - from.acceleration) / duration_s,
    };
    let end = first.at(duration_s);
    take(first);
    take(JerkPhase {
        duration_s,
        from: end.sigma,
        speed: end.speed,
        acceleration: middle,
        jerk: (to.acceleration - middle) / duration_s,
    });
}

impl ProfileGrid {
    fn passing(&self, node: usize, c: &[f64], from: usize) -> NodeMotion {
        let (g, h) = (self.intervals[node - 1].length, self.intervals[node].length);
        let (before, after) = (c[node - 1 - from], c[node - from]);
        // Even speeds are even to the last bit.
        let square = if before == after { before } else { (before * h + after * g) / (g + h) };
        NodeMotion { speed: square.max(0.0).sqrt(), acceleration: (after - before) / (g + h) }
    }

    /// The phases of an interval, with the coefficients from interval `from` on. The first and the last interval of
    /// the grid begin and end at rest.
    pub fn phases(&self, interval: usize, c: &[f64], from: usize, mut take: impl FnMut(JerkPhase)) {
        let (at, length) = (self.nodes[interval].at, self.intervals[interval].length);
        if interval == 0 {
            let to = self.passing(1, c, from);
            let duration_s = 3.0 * length / to.speed;
            let jerk = 2.0 * to.speed / (duration_s * duration_s);
            return take(JerkPhase { duration_s, from: at, speed: 0.0, acceleration: 0.0, jerk });
        }
        let begins = self.passing(interval, c, from);
        if interval + 1 == self.intervals.len() {
            let duration_s = 3.0 * length / begins.speed;
            let jerk = 2.0 * begins.speed / (duration_s * duration_s);
            let (speed, acceleration) = (begins.speed, -jerk * duration_s);
            return take(JerkPhase { duration_s, from: at, speed, acceleration, jerk });
        }
        let to = self.passing(interval + 1, c, from);
        let change = (to.speed - begins.speed).abs() / begins.speed.min(to.speed);
        let parts = (change / MAX_SPEED_CHANGE_SHARE).ceil().clamp(1.0, MAX_INTERVAL_PARTS) as u32;
        let slope = (to.acceleration - begins.acceleration) / length;
        let mut here = begins;
        let mut begin = 0.0;
        for part in 1..=parts {
            let end = length * f64::from(part) / f64::from(parts);
            let next = if part == parts {
                to
            } else {
                let square = begins.speed * begins.speed;
                NodeMotion {
                    speed: (square + end * (2.0 * begins.acceleration + slope * end))
                        .max(0.0)
                        .sqrt(),
                    acceleration: begins.acceleration + slope * end,
                }
            };
            pair(at + begin, end - begin, here, next, &mut take);
            (here, begin) = (next, end);
        }
    }

    /// What an interval's phases use of the limits, at most; of the velocity also what the feed leaves.
    pub fn use_of(&self, interval: usize, c: &[f64], from: usize, run: &PathRun<'_>) -> LimitUse {
        let mut used = LimitUse::default();
        self.phases(interval, c, from, |phase| {
            for count in PHASE_PROBES {
                for probe in 0..=count {
                    let along = phase.at(phase.duration_s * f64::from(probe) / f64::from(count));
                    used = used.or(self.use_at(run, interval, &along));
                }
                if used.acceleration.max(used.jerk) < NEARLY_USED_SHARE {
                    break;
                }
            }
        });
        used
    }

    fn use_at(&self, run: &PathRun<'_>, interval: usize, along: &ProfilePoint) -> LimitUse {
        let piece = self.intervals[interval].piece as usize;
        let ProfilePoint { speed: v, acceleration: a, jerk: j, .. } = *along;
        let square = v * v;
        let mut most = [v / run.feed(piece), 0.0, 0.0];
        let mut add = |axis: usize, p: f64, q: f64, r: f64| {
            let used = [
                (p * v).abs() * self.of_velocity[axis],
                (p * a + q * square).abs() * self.of_acceleration[axis],
                (p * j + v * (3.0 * q * a + r * square)).abs(),
            ];
            for (most, used) in most.iter_mut().zip(used) {
                *most = if used > *most { used } else { *most };
            }
        };
        if run.pieces()[piece].base.is_none() {
            let [first, second] = &self.nodes[interval].by_jerk;
            let third = &self.intervals[interval].third[0];
            let offset = along.sigma - self.nodes[interval].at;
            for &axis in &self.axes {
                let (q, r) = (second[axis], third[axis]);
                add(axis, first[axis] + offset * (q + 0.5 * offset * r), q + offset * r, r);
            }
        } else {
            let [_, first, second, third] = run.jet(piece, along.sigma);
            let jerk = run.limits().jerk();
            for &axis in &self.axes {
                let [p, q, r] = [first, second, third].map(|row| row[axis] / jerk[axis]);
                add(axis, p, q, r);
            }
        }
        let [velocity, acceleration, jerk] = most;
        LimitUse { velocity, acceleration, jerk }
    }
}
