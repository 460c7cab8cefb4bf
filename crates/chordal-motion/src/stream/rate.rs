//! The rate φ of planned time against the clock, and the proof that a course of it keeps every
//! limit.
//!
//! A rate that stays the same and is at most 1 is always safe: velocity, acceleration and jerk
//! are then φ, φ² and φ³ times the planned ones. So a course of the rate needs to be checked
//! only until it stays the same, and whoever follows checked courses alone is always safe.

use std::collections::VecDeque;

use super::block::{Rates, Room};
use super::window::{Stop, Window};

/// The finest step of the clock in which a course is checked, s.
const STEP_S: f64 = 0.001;
/// How many steps a check may take.
const STEPS: f64 = 48.0;
/// How many times a step is compared with a block at most.
const BUDGET: usize = 384;

/// A time with a constant second derivative of the rate.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Bend {
    pub seconds: f64,
    /// Per s².
    pub bend: f64,
}

/// The rate and its slope by the clock, per s.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Rate {
    pub value: f64,
    pub slope: f64,
}

impl Rate {
    pub const fn even(value: f64) -> Rate {
        Rate { value, slope: 0.0 }
    }

    /// The rate `t` s later, and how much planned time has passed.
    #[inline]
    pub fn after(self, bend: f64, t: f64) -> (Rate, f64) {
        let Rate { value, slope } = self;
        let passed = t * (value + t * (slope / 2.0 + t * (bend / 6.0)));
        (Rate { value: value + t * (slope + t * (bend / 2.0)), slope: slope + t * bend }, passed)
    }
}

/// A course of the rate that ends at an even rate.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Course {
    bends: [Bend; 7],
    count: usize,
    /// The even rate at its end.
    pub ends_at: f64,
}

impl Course {
    /// No change.
    pub fn even(rate: f64) -> Course {
        Course { ends_at: rate, ..Course::default() }
    }

    /// From a rate to an even one, with at most `steep` per s (where it is not steeper already)
    /// and exactly `bend` per s² while the slope changes.
    pub fn to(from: Rate, target: f64, steep: f64, bend: f64) -> Course {
        let mut course = Course::even(target);
        let Rate { value, slope } = from;
        // Where the rate would come to if its slope were taken away at once.
        let nearest = value + slope * slope.abs() / (2.0 * bend);
        let side = if target >= nearest { 1.0 } else { -1.0 };
        let begin = side * slope;
        let way = (side * (target - value)).max(begin * begin.abs() / (2.0 * bend));
        let top = (bend * way + begin * begin / 2.0).max(0.0).sqrt().min(steep);
        let first = (top - begin) / bend;
        let even = way
            - (top * top - begin * begin) * first.signum() / (2.0 * bend)
            - top * top / (2.0 * bend);
        course.push(first.abs(), side * bend * first.signum());
        if top > 0.0 {
            course.push((even / top).max(0.0), 0.0);
            course.push(top / bend, -side * bend);
        }
        course
    }

    /// The stop of a window, begun at an even rate.
    pub fn tail(rate: f64, steep: f64, bend: f64) -> Course {
        let one = Course::to(Rate::even(1.0), 0.0, steep, bend);
        let mut course = Course::even(0.0);
        if rate > 0.0 {
            // The same movement in a time that runs more slowly.
            for bend in &one.bends[..one.count] {
                course.push(bend.seconds / rate, bend.bend * rate.powi(3));
            }
        }
        course
    }

    /// Goes on with another course.
    pub fn then(mut self, next: &Course) -> Course {
        for bend in &next.bends[..next.count] {
            self.push(bend.seconds, bend.bend);
        }
        self.ends_at = next.ends_at;
        self
    }

    pub fn push(&mut self, seconds: f64, bend: f64) {
        if seconds > 0.0 && self.count < self.bends.len() {
            self.bends[self.count] = Bend { seconds, bend };
            self.count += 1;
        }
    }

    pub fn get(&self, index: usize) -> Option<Bend> {
        (index < self.count).then(|| self.bends[index])
    }

    /// How long it takes by the clock, s.
    pub fn seconds(&self) -> f64 {
        self.bends[..self.count].iter().map(|bend| bend.seconds).sum()
    }

    /// How much planned time passes, s.
    pub fn passed(&self, from: Rate) -> f64 {
        let mut rate = from;
        let mut sum = 0.0;
        for bend in &self.bends[..self.count] {
            let (next, passed) = rate.after(bend.bend, bend.seconds);
            (rate, sum) = (next, sum + passed);
        }
        sum
    }

    /// Whether every limit holds along the course, begun `at_s` into the first of the windows.
    /// The check ends well where the plan rests and waits, or rests at the end.
    pub fn holds(&self, from: Rate, windows: &Ahead, at_s: f64, room: &Room) -> bool {
        let mut walk = Walk { windows, window: 0, block: 0, at_s, left: BUDGET };
        walk.find_block();
        let step_s = STEP_S.max(self.seconds() / STEPS);
        let mut rate = from;
        for bend in &self.bends[..self.count] {
            let steps = (bend.seconds / step_s).ceil().max(1.0);
            let step = bend.seconds / steps;
            for _ in 0..steps as usize {
                let (next, passed) = rate.after(bend.bend, step);
                let Some(rates) = rates(rate, next, bend.bend) else { return false };
                match walk.go(passed.max(0.0), &rates, room) {
                    Walked::Held => {}
                    Walked::Rests => return true,
                    Walked::Broken => return false,
                }
                rate = next;
            }
        }
        true
    }
}

/// What the rate does in a step, if it does not go below zero.
fn rates(one: Rate, two: Rate, bend: f64) -> Option<Rates> {
    let (mut low, mut high) = (one.value.min(two.value), one.value.max(two.value));
    if one.slope * two.slope < 0.0 {
        let turn = one.value - one.slope * one.slope / (2.0 * bend);
        (low, high) = (low.min(turn), high.max(turn));
    }
    (low >= -1e-9).then(|| Rates {
        rate: (low.max(0.0), high),
        slope: (one.slope.min(two.slope), one.slope.max(two.slope)),
        bend,
    })
}

/// Windows one after the other, where the motion is and further on.
pub(super) type Ahead = VecDeque<Box<Window>>;

enum Walked {
    Held,
    Rests,
    Broken,
}

struct Walk<'a> {
    windows: &'a Ahead,
    window: usize,
    block: usize,
    at_s: f64,
    left: usize,
}

impl Walk<'_> {
    fn find_block(&mut self) {
        if let Some(window) = self.windows.get(self.window) {
            self.block = window.blocks.partition_point(|block| block.end_s <= self.at_s);
        }
    }

    /// Holds the rates against every block that is met while planned time passes.
    fn go(&mut self, passed: f64, rates: &Rates, room: &Room) -> Walked {
        let mut until_s = self.at_s + passed;
        loop {
            let Some(window) = self.windows.get(self.window) else { return Walked::Broken };
            if self.left == 0 {
                return Walked::Broken;
            }
            self.left -= 1;
            let Some(block) = window.blocks.get(self.block) else {
                let last = self.window + 1 == self.windows.len();
                if window.wait.is_some() || (last && window.stop == Stop::Rest) {
                    return Walked::Rests;
                }
                until_s -= window.duration_s;
                self.window += 1;
                self.block = 0;
                continue;
            };
            if !block.allows(rates, room) {
                return Walked::Broken;
            }
            if until_s < block.end_s {
                self.at_s = until_s;
                return Walked::Held;
            }
            self.block += 1;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn end(course: &Course, from: Rate) -> Rate {
        course.bends[..course.count]
            .iter()
            .fold(from, |rate, bend| rate.after(bend.bend, bend.seconds).0)
    }

    #[test]
    fn a_course_ends_evenly_at_its_target() {
        for value in [0.0, 0.3, 1.0, 1.7] {
            for slope in [-9.0, -0.5, 0.0, 2.0, 30.0] {
                for target in [0.0, 0.31, 1.0, 2.0] {
                    for (steep, bend) in [(0.5, 3.0), (10.0, 20.0), (2.0, 1e4)] {
                        let from = Rate { value, slope };
                        let course = Course::to(from, target, steep, bend);
                        let end = end(&course, from);
                        assert!((end.value - target).abs() < 1e-9, "{from:?} {course:?} {end:?}");
                        assert!(end.slope.abs() < 1e-9, "{from:?} {course:?} {end:?}");
                    }
                }
            }
        }
    }

    #[test]
    fn a_stop_is_the_same_way_at_any_rate() {
        let whole = Course::tail(1.0, 8.0, 200.0).passed(Rate::even(1.0));
        // It falls as evenly after its middle as before: on average the rate is a half.
        assert!((whole - Course::tail(1.0, 8.0, 200.0).seconds() / 2.0).abs() < 1e-12);
        for rate in [0.9, 0.5, 0.01] {
            let tail = Course::tail(rate, 8.0, 200.0);
            assert!((tail.passed(Rate::even(rate)) - whole).abs() < 1e-12);
            assert!(end(&tail, Rate::even(rate)).value.abs() < 1e-12);
        }
    }
}
