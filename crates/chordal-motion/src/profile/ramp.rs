//! Changes of speed along a path, from and to even speed, under a largest acceleration and jerk.

use crate::root::cbrt;
use crate::trajectory::Phase;

/// What holds along a piece of path: σ per s², σ per s³.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Effort {
    /// Largest acceleration.
    pub acceleration: f64,
    /// Largest jerk.
    pub jerk: f64,
}

impl Effort {
    /// Nothing limits.
    pub const FREE: Effort = Effort { acceleration: f64::INFINITY, jerk: f64::INFINITY };

    /// What holds where both hold.
    #[inline]
    pub fn and(self, other: Effort) -> Effort {
        Effort {
            acceleration: self.acceleration.min(other.acceleration),
            jerk: self.jerk.min(other.jerk),
        }
    }

    /// How long a change of speed takes, s.
    #[inline]
    pub fn time(self, change: f64) -> f64 {
        let Effort { acceleration: a, jerk: j } = self;
        if change * j <= a * a { 2.0 * (change / j).sqrt() } else { change / a + a / j }
    }

    /// How far a change of speed goes.
    #[inline]
    pub fn way(self, from: f64, to: f64) -> f64 {
        self.time((to - from).abs()) * (from + to) / 2.0
    }

    /// How far a rise of speed has gone when it passes a speed between its ends.
    pub fn way_until(self, from: f64, to: f64, speed: f64) -> f64 {
        let (rise, done) = (to - from, speed - from);
        if done <= 0.0 {
            return 0.0;
        }
        if done > rise / 2.0 {
            // The second half is the first one turned about its middle.
            let (t, lost) = self.first_half(rise, rise - done);
            return self.way(from, to) - (to * t - lost);
        }
        let (t, gained) = self.first_half(rise, done);
        from * t + gained
    }

    /// In the first half of a rise from rest: the time to a speed and the way to there.
    fn first_half(self, rise: f64, done: f64) -> (f64, f64) {
        let Effort { acceleration: a, jerk: j } = self;
        let edge = if rise * j <= a * a { (rise / j).sqrt() } else { a / j };
        let curved = j * edge * edge / 2.0;
        if done <= curved {
            let t = (2.0 * done / j).max(0.0).sqrt();
            return (t, j * t * t * t / 6.0);
        }
        let even = (done - curved) / (j * edge);
        let way = j * edge * edge * edge / 6.0 + even * (curved + done) / 2.0;
        (edge + even, way)
    }

    /// By how much the speed can rise over a length. Not the speed itself: near the start of a
    /// fast ramp the sum would lose the rise. Rounded down, so that the ramp fits.
    pub fn rise(self, from: f64, length: f64) -> f64 {
        if length <= 0.0 { 0.0 } else { self.exact_rise(from, length) * (1.0 - 1e-14) }
    }

    fn exact_rise(self, from: f64, length: f64) -> f64 {
        let Effort { acceleration: a, jerk: j } = self;
        let most = a * a / j;
        // Without a stage of even acceleration: q³ + 2·from·q = length·√jerk with q = √rise.
        if self.way(from, from + most) >= length {
            let c = length * j.sqrt();
            let mut q = cbrt(c);
            if from > 0.0 {
                q = q.min(c / (2.0 * from));
            }
            // Newton's method from above on a convex function: every step stays above the root.
            for _ in 0..12 {
                let step = (q * (q * q + 2.0 * from) - c) / (3.0 * q * q + 2.0 * from);
                q -= step;
                if step <= 1e-15 * q {
                    break;
                }
            }
            return (q * q).min(most);
        }
        // rise²/2 + rise·(from + a²/2j) = a·length − from·a²/j
        let half = from + most / 2.0;
        let right = (a * length - from * most).max(0.0);
        2.0 * right / (half + (half * half + 2.0 * right).sqrt())
    }

    /// The phases of a change of speed, handed on in order.
    pub fn phases(self, at: f64, from: f64, to: f64, mut take: impl FnMut(Phase)) {
        let change = (to - from).abs();
        if change <= 0.0 {
            return;
        }
        let sign = if to > from { 1.0 } else { -1.0 };
        let Effort { acceleration: a, jerk: j } = self;
        let (edge, even) = if change * j <= a * a {
            ((change / j).sqrt(), 0.0)
        } else {
            (a / j, change / a - a / j)
        };
        let peak = sign * j * edge;
        let mut phase =
            Phase { duration_s: edge, from: at, speed: from, acceleration: 0.0, jerk: sign * j };
        take(phase);
        for (duration_s, acceleration, jerk) in [(even, peak, 0.0), (edge, peak, -sign * j)] {
            let now = phase.at(phase.duration_s);
            phase = Phase { duration_s, from: now.sigma, speed: now.speed, acceleration, jerk };
            if duration_s > 0.0 {
                take(phase);
            }
        }
    }
}

/// What holds along a piece of path, at low and at high speed: near the largest speed of a curve
/// most of the acceleration goes into turning. A ramp that goes through `knee` rests there at
/// even speed for an instant, or obeys the high effort all along, whichever is shorter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ability {
    /// Up to this speed `low` holds, σ per s.
    pub knee: f64,
    /// At low speed.
    pub low: Effort,
    /// At any speed.
    pub high: Effort,
}

/// How a ramp is made.
enum Plan {
    One(Effort),
    /// Two ramps that meet at the knee.
    Two,
}

impl Ability {
    /// Nothing limits.
    pub const FREE: Ability =
        Ability { knee: f64::INFINITY, low: Effort::FREE, high: Effort::FREE };

    /// What holds where both hold.
    #[inline]
    pub fn and(self, other: Ability) -> Ability {
        Ability {
            knee: self.knee.min(other.knee),
            low: self.low.and(other.low),
            high: self.high.and(other.high),
        }
    }

    fn plan(&self, low: f64, high: f64) -> Plan {
        if high <= self.knee {
            return Plan::One(self.low);
        }
        if low >= self.knee
            || self.high.way(low, high)
                <= self.low.way(low, self.knee) + self.high.way(self.knee, high)
        {
            return Plan::One(self.high);
        }
        Plan::Two
    }

    /// How far a change of speed goes.
    pub fn way(&self, from: f64, to: f64) -> f64 {
        let (low, high) = (from.min(to), from.max(to));
        match self.plan(low, high) {
            Plan::One(effort) => effort.way(low, high),
            Plan::Two => self.low.way(low, self.knee) + self.high.way(self.knee, high),
        }
    }

    /// How far a rise of speed has gone when it passes a speed between its ends.
    pub fn way_until(&self, from: f64, to: f64, speed: f64) -> f64 {
        match self.plan(from, to) {
            Plan::One(effort) => effort.way_until(from, to, speed),
            Plan::Two if speed <= self.knee => self.low.way_until(from, self.knee, speed),
            Plan::Two => self.low.way(from, self.knee) + self.high.way_until(self.knee, to, speed),
        }
    }

    /// The speed that can be reached over a length.
    pub fn climb(&self, from: f64, length: f64) -> f64 {
        if from >= self.knee {
            return from + self.high.rise(from, length);
        }
        let low = from + self.low.rise(from, length);
        if low <= self.knee {
            return low;
        }
        let rest = length - self.low.way(from, self.knee);
        let two = self.knee + self.high.rise(self.knee, rest);
        two.max(from + self.high.rise(from, length))
    }

    /// The phases of a change of speed, handed on in order.
    pub fn phases(&self, at: f64, from: f64, to: f64, mut take: impl FnMut(Phase)) {
        match self.plan(from.min(to), from.max(to)) {
            Plan::One(effort) => effort.phases(at, from, to, take),
            Plan::Two => {
                let (first, second) =
                    if from < to { (self.low, self.high) } else { (self.high, self.low) };
                first.phases(at, from, self.knee, &mut take);
                second.phases(at + first.way(from, self.knee), self.knee, to, take);
            }
        }
    }
}

/// The highest speed up to `top` between two speeds over a length. `None` when even the direct
/// change is longer than the length.
pub fn peak(from: f64, to: f64, length: f64, top: f64, ability: &Ability) -> Option<f64> {
    let low = from.max(to);
    let top = top.max(low);
    let way = |speed: f64| ability.way(from, speed) + ability.way(speed, to);
    let slack = length * (1.0 + 1e-12);
    if way(low) > slack {
        return None;
    }
    if way(top) <= length {
        return Some(top);
    }
    let (mut below, mut above) = (low, top);
    let (mut miss_below, mut miss_above) = (way(low) - length, way(top) - length);
    for _ in 0..80 {
        if above - below <= 1e-14 * above {
            break;
        }
        // The false position, kept off the ends of the bracket.
        let share = (miss_below / (miss_below - miss_above)).clamp(0.02, 0.98);
        let middle = below + (above - below) * share;
        let miss = way(middle) - length;
        if miss > 0.0 {
            (above, miss_above) = (middle, miss);
            miss_below *= 0.5;
        } else {
            (below, miss_below) = (middle, miss);
            miss_above *= 0.5;
        }
    }
    Some(below)
}

#[cfg(test)]
mod tests {
    use super::*;

    const EFFORT: Effort = Effort { acceleration: 5000.0, jerk: 1e5 };

    #[test]
    fn a_hundred_millimetres_take_the_published_time() {
        let ability = Ability { knee: f64::INFINITY, low: EFFORT, high: EFFORT };
        let top = peak(0.0, 0.0, 100.0, 500.0, &ability).unwrap();
        let time = 2.0 * EFFORT.time(top) + (100.0 - 2.0 * EFFORT.way(0.0, top)) / top;
        // Up to 500 mm/s in 500/5000 + 5000/1e5 s, twice, and 25 mm at that speed.
        assert!((top - 500.0).abs() < 1e-12, "{top}");
        assert!((time - 0.35).abs() < 1e-12, "{time}");
    }

    #[test]
    fn rise_is_the_inverse_of_way() {
        for from in [0.0, 1e-6, 0.3, 40.0, 499.0] {
            for length in [1e-9, 1e-3, 0.5, 7.0, 300.0] {
                let rise = EFFORT.rise(from, length);
                let time = EFFORT.time(rise);
                let way = time * (from + rise / 2.0);
                assert!((way / length - 1.0).abs() < 1e-9, "{from} {length}: {rise} {way}");
            }
        }
    }

    #[test]
    fn phases_arrive() {
        for (from, to) in [(0.0, 100.0), (300.0, 0.0), (10.0, 400.0), (5.0, 5.0)] {
            let mut last =
                Phase { duration_s: 0.0, from: 3.0, speed: from, acceleration: 0.0, jerk: 0.0 };
            EFFORT.phases(3.0, from, to, |phase| last = phase);
            let end = last.at(last.duration_s);
            assert!((end.speed - to).abs() < 1e-9 && end.acceleration.abs() < 1e-9);
            assert!((end.sigma - 3.0 - EFFORT.way(from, to)).abs() < 1e-9);
        }
    }
}
