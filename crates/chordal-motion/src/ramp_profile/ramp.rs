//! Changes of speed along a path, from and to even speed, under a largest acceleration and jerk.

use crate::cube_root::cbrt;
use crate::trajectory::JerkPhase;

/// What holds along a piece of path: σ per s², σ per s³.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AccelJerk {
    /// Largest acceleration.
    pub acceleration: f64,
    /// Largest jerk.
    pub jerk: f64,
}

impl AccelJerk {
    /// Nothing limits.
    pub const FREE: AccelJerk = AccelJerk { acceleration: f64::INFINITY, jerk: f64::INFINITY };

    /// What holds where both hold.
    #[inline]
    pub fn and(self, other: AccelJerk) -> AccelJerk {
        AccelJerk {
            acceleration: least(self.acceleration, other.acceleration),
            jerk: least(self.jerk, other.jerk),
        }
    }

    /// How long a change of speed takes, s.
    #[inline]
    pub fn time(self, change: f64) -> f64 {
        let AccelJerk { acceleration: a, jerk: j } = self;
        // No change takes no time, even where nothing may be used for it.
        if change <= 0.0 {
            return 0.0;
        }
        if change * j <= a * a { 2.0 * (change / j).sqrt() } else { change / a + a / j }
    }

    /// How far a change of speed goes.
    #[inline]
    pub fn distance(self, from: f64, to: f64) -> f64 {
        self.time((to - from).abs()) * (from + to) / 2.0
    }

    /// How far a rise of speed has gone when it passes a speed between its ends.
    pub fn distance_until(self, from: f64, to: f64, speed: f64) -> f64 {
        let (rise, done) = (to - from, speed - from);
        if done <= 0.0 {
            return 0.0;
        }
        if done > rise / 2.0 {
            // The second half is the first one turned about its middle.
            let (t, lost) = self.first_half(rise, rise - done);
            return self.distance(from, to) - (to * t - lost);
        }
        let (t, gained) = self.first_half(rise, done);
        from * t + gained
    }

    /// In the first half of a rise from rest: the time to a speed and the distance to there.
    fn first_half(self, rise: f64, done: f64) -> (f64, f64) {
        let AccelJerk { acceleration: a, jerk: j } = self;
        let edge = if rise * j <= a * a { (rise / j).sqrt() } else { a / j };
        let curved = j * edge * edge / 2.0;
        if done <= curved {
            let t = (2.0 * done / j).max(0.0).sqrt();
            return (t, j * t * t * t / 6.0);
        }
        let even = (done - curved) / (j * edge);
        let distance = j * edge * edge * edge / 6.0 + even * (curved + done) / 2.0;
        (edge + even, distance)
    }

    /// By how much the speed can rise over a length. Not the speed itself: near the start of a
    /// fast ramp the sum would lose the rise. Rounded down, so that the ramp fits.
    pub fn rise(self, from: f64, length: f64) -> f64 {
        if length <= 0.0 { 0.0 } else { self.exact_rise(from, length) * (1.0 - 1e-14) }
    }

    fn exact_rise(self, from: f64, length: f64) -> f64 {
        let AccelJerk { acceleration: a, jerk: j } = self;
        let most = a * a / j;
        // Without a stage of even acceleration: q³ + 2·from·q = length·√jerk with q = √rise.
        if self.distance(from, from + most) >= length {
            let c = length * j.sqrt();
            if from <= 0.0 {
                return cbrt(c * c).min(most);
            }
            // Both guesses lie above the root; the one that leaves out less lies nearer.
            let even = if from > 0.0 { c / (2.0 * from) } else { f64::INFINITY };
            let mut q = if even * even <= 2.0 * from { even } else { cbrt(c) };
            // Newton's method from above on a convex function: every step stays above the root,
            // and after a step of this size what is left is its square.
            for _ in 0..12 {
                let step = (q * (q * q + 2.0 * from) - c) / (3.0 * q * q + 2.0 * from);
                q -= step;
                if step <= 1e-8 * q {
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

    /// The phases of a change of speed, emitted in order.
    pub fn phases(self, at: f64, from: f64, to: f64, mut take: impl FnMut(JerkPhase)) {
        let change = (to - from).abs();
        if change <= 0.0 {
            return;
        }
        let sign = if to > from { 1.0 } else { -1.0 };
        let AccelJerk { acceleration: a, jerk: j } = self;
        let (edge, even) = if change * j <= a * a {
            ((change / j).sqrt(), 0.0)
        } else {
            (a / j, change / a - a / j)
        };
        let peak = sign * j * edge;
        let mut phase = JerkPhase {
            duration_s: edge,
            from: at,
            speed: from,
            acceleration: 0.0,
            jerk: sign * j,
        };
        take(phase);
        for (duration_s, acceleration, jerk) in [(even, peak, 0.0), (edge, peak, -sign * j)] {
            let now = phase.at(phase.duration_s);
            phase = JerkPhase { duration_s, from: now.sigma, speed: now.speed, acceleration, jerk };
            if duration_s > 0.0 {
                take(phase);
            }
        }
    }
}

/// The lesser of two numbers: quicker than with a rule for what is no number.
#[inline]
pub fn least(a: f64, b: f64) -> f64 {
    if b < a { b } else { a }
}

/// How many ranges of speed have an effort of their own.
const SPEED_RANGES: usize = 3;

/// What holds along a piece of path in ranges of speed: near the largest speed of a curve most of
/// the acceleration goes into turning. A ramp over several ranges rests at even speed for an
/// instant between two of them, or obeys the effort of a higher one all along.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpeedDependentLimits {
    /// Up to these speeds the first efforts hold, σ per s.
    pub knees: [f64; SPEED_RANGES - 1],
    /// From low speed to high; the last holds at any speed.
    pub efforts: [AccelJerk; SPEED_RANGES],
}

/// What a ramp over several ranges of speed is made for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RampAim {
    /// Little distance.
    Short,
    /// Little time lost.
    Quick,
}

/// A rise of speed in parts, each from even speed to even speed: the first under the effort of one
/// range, which may reach down over lower ones, then one part for each range above.
#[derive(Clone, Copy, Debug)]
struct SpeedRise {
    /// The range whose effort the first part obeys.
    first: usize,
    distance: f64,
    time: f64,
}

impl SpeedRise {
    #[inline]
    fn new(first: usize, low: f64, high: f64, effort: AccelJerk) -> SpeedRise {
        let time = effort.time(high - low);
        SpeedRise { first, distance: time * (low + high) / 2.0, time }
    }

    /// What is kept small.
    #[inline]
    fn cost(&self, high: f64, aim: RampAim) -> f64 {
        match aim {
            RampAim::Short => self.distance,
            // Time lost against travelling at the higher speed.
            RampAim::Quick => self.time * high - self.distance,
        }
    }
}

impl SpeedDependentLimits {
    /// Nothing limits.
    pub const FREE: SpeedDependentLimits = SpeedDependentLimits::even(AccelJerk::FREE);

    /// One effort at any speed.
    pub const fn even(effort: AccelJerk) -> SpeedDependentLimits {
        SpeedDependentLimits {
            knees: [f64::INFINITY; SPEED_RANGES - 1],
            efforts: [effort; SPEED_RANGES],
        }
    }

    /// What holds where both hold.
    #[inline]
    pub fn and(self, other: SpeedDependentLimits) -> SpeedDependentLimits {
        SpeedDependentLimits {
            knees: std::array::from_fn(|level| least(self.knees[level], other.knees[level])),
            efforts: std::array::from_fn(|level| self.efforts[level].and(other.efforts[level])),
        }
    }

    #[inline]
    fn rise(&self, low: f64, high: f64, aim: RampAim) -> SpeedRise {
        let mut level = self.knees.iter().take_while(|knee| low >= **knee).count();
        let top = |level: usize| self.knees.get(level).map_or(high, |knee| high.min(*knee));
        let mut best = SpeedRise::new(level, low, top(level), self.efforts[level]);
        while level + 1 < SPEED_RANGES && high > self.knees[level] {
            let knee = self.knees[level];
            level += 1;
            let top = top(level);
            let direct = SpeedRise::new(level, low, top, self.efforts[level]);
            let step = SpeedRise::new(level, knee, top, self.efforts[level]);
            let stepped = SpeedRise {
                distance: best.distance + step.distance,
                time: best.time + step.time,
                ..best
            };
            let is_best = direct.cost(top, aim) <= stepped.cost(top, aim);
            best = if is_best { direct } else { stepped };
        }
        best
    }

    /// The parts of a rise from low speed to high, from the lowest on.
    fn parts(
        &self,
        low: f64,
        high: f64,
        aim: RampAim,
    ) -> impl DoubleEndedIterator<Item = (f64, f64, AccelJerk)> {
        let first = self.rise(low, high, aim).first;
        let last = self.knees.iter().take_while(|knee| high > **knee).count().max(first);
        (first..=last).map(move |level| {
            let from = if level == first { low } else { self.knees[level - 1] };
            let to = if level == last { high } else { self.knees[level] };
            (from, to, self.efforts[level])
        })
    }

    /// How far a change of speed goes, and how long it takes, s.
    #[inline]
    pub fn extent(&self, from: f64, to: f64, aim: RampAim) -> (f64, f64) {
        let rise = self.rise(from.min(to), from.max(to), aim);
        (rise.distance, rise.time)
    }

    /// How far a change of speed goes.
    #[inline]
    pub fn distance(&self, from: f64, to: f64, aim: RampAim) -> f64 {
        self.extent(from, to, aim).0
    }

    /// How far a rise of speed has gone when it passes a speed between its ends.
    pub fn distance_until(&self, from: f64, to: f64, speed: f64, aim: RampAim) -> f64 {
        let mut distance = 0.0;
        for (low, high, effort) in self.parts(from, to, aim) {
            if speed <= high {
                return distance + effort.distance_until(low, high, speed);
            }
            distance += effort.distance(low, high);
        }
        distance
    }

    /// The speed that can be reached over a length.
    pub fn climb(&self, from: f64, length: f64) -> f64 {
        let level = self.knees.iter().take_while(|knee| from >= **knee).count();
        let mut most = 0.0_f64;
        for first in level..SPEED_RANGES {
            let (mut speed, mut rest) = (from, length);
            for (effort, knee) in
                self.efforts[first..].iter().zip(self.knees[first..].iter().chain(&[f64::INFINITY]))
            {
                let reached = speed + effort.rise(speed, rest);
                if reached <= *knee {
                    speed = reached;
                    break;
                }
                rest -= effort.distance(speed, *knee);
                speed = *knee;
            }
            most = most.max(speed);
            if self.knees.get(first).is_none_or(|knee| most <= *knee) {
                // Higher efforts are no better.
                break;
            }
        }
        most
    }

    /// The phases of a change of speed, emitted in order.
    pub fn phases(
        &self,
        at: f64,
        (from, to): (f64, f64),
        aim: RampAim,
        mut take: impl FnMut(JerkPhase),
    ) {
        let parts = self.parts(from.min(to), from.max(to), aim);
        let mut place = at;
        if from <= to {
            for (low, high, effort) in parts {
                effort.phases(place, low, high, &mut take);
                place += effort.distance(low, high);
            }
        } else {
            for (low, high, effort) in parts.rev() {
                effort.phases(place, high, low, &mut take);
                place += effort.distance(low, high);
            }
        }
    }
}

/// The highest speed up to `top` between two speeds over a length, up with one ability and down
/// with another, and how the ramps are made. `None` when even the direct change is longer than
/// the length.
pub fn peak(
    (from, to): (f64, f64),
    length: f64,
    top: f64,
    up: &SpeedDependentLimits,
    down: &SpeedDependentLimits,
) -> Option<(f64, RampAim)> {
    let low = from.max(to);
    let top = top.max(low);
    let distances =
        |speed: f64, aim: RampAim| up.distance(from, speed, aim) + down.distance(speed, to, aim);
    if distances(top, RampAim::Quick) <= length {
        return Some((top, RampAim::Quick));
    }
    let slack = length * (1.0 + 1e-12);
    let quick = distances(low, RampAim::Quick);
    let (aim, shortest) = if quick <= length {
        (RampAim::Quick, quick)
    } else {
        (RampAim::Short, distances(low, RampAim::Short))
    };
    // A distance that is NaN is longer than every length.
    if shortest > slack || shortest.is_nan() {
        return None;
    }
    if shortest >= length {
        return Some((low, aim));
    }
    let miss = |speed: f64| distances(speed, aim) - length;
    let miss_top = miss(top);
    if miss_top <= 0.0 {
        return Some((top, aim));
    }
    let speed = highest((low, shortest - length), (top, miss_top), 1e-14 * length, miss);
    Some((speed, aim))
}

/// The largest speed between two at which a rising function is not above zero, with its values at
/// both. Where it is nearer to zero than `close`, that is near enough.
fn highest(
    (mut below, mut value_below): (f64, f64),
    (mut above, mut value_above): (f64, f64),
    close: f64,
    value: impl Fn(f64) -> f64,
) -> f64 {
    const RELATIVE_PRECISION: f64 = 1e-14;
    // The false position. An end that stays is given less weight each time, by the method of
    // Anderson and Björck.
    let less = |new: f64, old: f64| {
        let weight = 1.0 - new / old;
        if weight > 0.0 { weight } else { 0.5 }
    };
    let mut stays = 0_i32;
    for _ in 0..80 {
        let gap = above - below;
        if gap <= RELATIVE_PRECISION * above {
            break;
        }
        let share = value_below / (value_below - value_above);
        // Values without measure say nothing of where the zero lies.
        let share = if share.is_nan() { 0.5 } else { share };
        let margin = (0.25 * RELATIVE_PRECISION * above).min(gap / 4.0);
        let middle = (below + gap * share).max(below + margin).min(above - margin);
        let new = value(middle);
        if new > 0.0 || new.is_nan() {
            if stays > 0 {
                value_below *= less(new, value_above);
            }
            (above, value_above, stays) = (middle, new, 1);
            if new <= close {
                // One step further is below.
                let next = (middle * (1.0 - RELATIVE_PRECISION)).max(below);
                if value(next) <= 0.0 {
                    return next;
                }
            }
        } else {
            if stays < 0 {
                value_above *= less(new, value_below);
            }
            (below, value_below, stays) = (middle, new, -1);
            if new >= -close {
                break;
            }
        }
    }
    below
}

#[cfg(test)]
mod tests {
    use super::*;

    const RAMP_LIMITS: AccelJerk = AccelJerk { acceleration: 5000.0, jerk: 1e5 };

    #[test]
    fn a_hundred_millimetres_take_the_published_time() {
        let ability = SpeedDependentLimits::even(RAMP_LIMITS);
        let (top, _) = peak((0.0, 0.0), 100.0, 500.0, &ability, &ability).unwrap();
        let time =
            2.0 * RAMP_LIMITS.time(top) + (100.0 - 2.0 * RAMP_LIMITS.distance(0.0, top)) / top;
        // Up to 500 mm/s in 500/5000 + 5000/1e5 s, twice, and 25 mm at that speed.
        assert!((top - 500.0).abs() < 1e-12, "{top}");
        assert!((time - 0.35).abs() < 1e-12, "{time}");
    }

    #[test]
    fn rise_is_the_inverse_of_distance() {
        for from in [0.0, 1e-6, 0.3, 40.0, 499.0] {
            for length in [1e-9, 1e-3, 0.5, 7.0, 300.0] {
                let rise = RAMP_LIMITS.rise(from, length);
                let time = RAMP_LIMITS.time(rise);
                let distance = time * (from + rise / 2.0);
                assert!(
                    (distance / length - 1.0).abs() < 1e-9,
                    "{from} {length}: {rise} {distance}"
                );
            }
        }
    }

    #[test]
    fn phases_arrive() {
        for (from, to) in [(0.0, 100.0), (300.0, 0.0), (10.0, 400.0), (5.0, 5.0)] {
            let mut last =
                JerkPhase { duration_s: 0.0, from: 3.0, speed: from, acceleration: 0.0, jerk: 0.0 };
            RAMP_LIMITS.phases(3.0, from, to, |phase| last = phase);
            let end = last.at(last.duration_s);
            assert!((end.speed - to).abs() < 1e-9 && end.acceleration.abs() < 1e-9);
            assert!((end.sigma - 3.0 - RAMP_LIMITS.distance(from, to)).abs() < 1e-9);
        }
    }
}
