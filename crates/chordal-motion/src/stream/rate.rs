//! The rate φ of planned time against the clock, and the proof that a course of it keeps every
//! limit.
//!
//! A rate that stays the same and is at most 1 is always safe: velocity, acceleration and jerk
//! are then φ, φ² and φ³ times the planned ones. So a course of the rate needs to be checked
//! only until it stays the same, and whoever follows checked courses alone is always safe.

use std::collections::VecDeque;

use super::block::{RateRange, StreamLimits};
use super::window::{StreamWindow, WindowStop};

/// The finest step of the clock in which a course is checked, s.
const MIN_CHECK_STEP_S: f64 = 0.001;
/// How many steps a check may take.
const MAX_CHECK_STEPS: f64 = 48.0;
/// How many times a step is compared with a block at most.
const MAX_BLOCK_COMPARISONS: usize = 384;

/// A time with a constant second derivative of the rate.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct RatePhase {
    pub seconds: f64,
    /// Per s².
    pub bend: f64,
}

/// The rate and its slope by the clock, per s.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct TimeRate {
    pub value: f64,
    pub slope: f64,
}

impl TimeRate {
    pub const fn even(value: f64) -> TimeRate {
        TimeRate { value, slope: 0.0 }
    }

    /// The rate `t` s later, and how much planned time has passed.
    #[inline]
    pub fn after(self, bend: f64, t: f64) -> (TimeRate, f64) {
        let TimeRate { value, slope } = self;
        let passed = t * (value + t * (slope / 2.0 + t * (bend / 6.0)));
        (
            TimeRate { value: value + t * (slope + t * (bend / 2.0)), slope: slope + t * bend },
            passed,
        )
    }
}

/// A course of the rate that ends at an even rate.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct RateCourse {
    bends: [RatePhase; 7],
    count: usize,
    /// The even rate at its end.
    pub ends_at: f64,
}

impl RateCourse {
    /// No change.
    pub fn even(rate: f64) -> RateCourse {
        RateCourse { ends_at: rate, ..RateCourse::default() }
    }

    /// From a rate to an even one, with at most `steep` per s (where it is not steeper already)
    /// and exactly `bend` per s² while the slope changes.
    pub fn to(from: TimeRate, target: f64, steep: f64, bend: f64) -> RateCourse {
        let mut course = RateCourse::even(target);
        let TimeRate { value, slope } = from;
        // Where the rate would come to if its slope were taken away at once.
        let nearest = value + slope * slope.abs() / (2.0 * bend);
        let side = if target >= nearest { 1.0 } else { -1.0 };
        let begin = side * slope;
        let change = (side * (target - value)).max(begin * begin.abs() / (2.0 * bend));
        let top = (bend * change + begin * begin / 2.0).max(0.0).sqrt().min(steep);
        let first = (top - begin) / bend;
        let even = change
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
    pub fn tail(rate: f64, steep: f64, bend: f64) -> RateCourse {
        let one = RateCourse::to(TimeRate::even(1.0), 0.0, steep, bend);
        let mut course = RateCourse::even(0.0);
        if rate > 0.0 {
            // The same movement in a time that runs more slowly.
            for bend in &one.bends[..one.count] {
                course.push(bend.seconds / rate, bend.bend * rate.powi(3));
            }
        }
        course
    }

    /// Goes on with another course.
    pub fn then(mut self, next: &RateCourse) -> RateCourse {
        for bend in &next.bends[..next.count] {
            self.push(bend.seconds, bend.bend);
        }
        self.ends_at = next.ends_at;
        self
    }

    pub fn push(&mut self, seconds: f64, bend: f64) {
        if seconds > 0.0 && self.count < self.bends.len() {
            self.bends[self.count] = RatePhase { seconds, bend };
            self.count += 1;
        }
    }

    pub fn get(&self, index: usize) -> Option<RatePhase> {
        (index < self.count).then(|| self.bends[index])
    }

    /// How long it takes by the clock, s.
    pub fn seconds(&self) -> f64 {
        self.bends[..self.count].iter().map(|bend| bend.seconds).sum()
    }

    /// How much planned time passes, s.
    pub fn passed(&self, from: TimeRate) -> f64 {
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
    pub fn holds(
        &self,
        from: TimeRate,
        windows: &WindowQueue,
        at_s: f64,
        room: &StreamLimits,
    ) -> bool {
        let mut walk =
            RateCursor { windows, window: 0, block: 0, at_s, left: MAX_BLOCK_COMPARISONS };
        walk.find_block();
        let step_s = MIN_CHECK_STEP_S.max(self.seconds() / MAX_CHECK_STEPS);
        let mut rate = from;
        for bend in &self.bends[..self.count] {
            let steps = (bend.seconds / step_s).ceil().max(1.0);
            let step = bend.seconds / steps;
            for _ in 0..steps as usize {
                let (next, passed) = rate.after(bend.bend, step);
                let Some(rates) = rates(rate, next, bend.bend) else { return false };
                match walk.go(passed.max(0.0), &rates, room) {
                    CheckOutcome::Holds => {}
                    CheckOutcome::Rests => return true,
                    CheckOutcome::Broken => return false,
                }
                rate = next;
            }
        }
        true
    }
}

/// What the rate does in a step, if it does not go below zero.
fn rates(one: TimeRate, two: TimeRate, bend: f64) -> Option<RateRange> {
    let (mut low, mut high) = (one.value.min(two.value), one.value.max(two.value));
    if one.slope * two.slope < 0.0 {
        let turn = one.value - one.slope * one.slope / (2.0 * bend);
        (low, high) = (low.min(turn), high.max(turn));
    }
    (low >= -1e-9).then(|| RateRange {
        rate: (low.max(0.0), high),
        slope: (one.slope.min(two.slope), one.slope.max(two.slope)),
        bend,
    })
}

/// Windows one after the other, where the motion is and further on.
pub(super) type WindowQueue = VecDeque<Box<StreamWindow>>;

enum CheckOutcome {
    Holds,
    Rests,
    Broken,
}

struct RateCursor<'a> {
    windows: &'a WindowQueue,
    window: usize,
    block: usize,
    at_s: f64,
    left: usize,
}

impl RateCursor<'_> {
    fn find_block(&mut self) {
        if let Some(window) = self.windows.get(self.window) {
            self.block = window.blocks.partition_point(|block| block.end_s <= self.at_s);
        }
    }

    /// Compares the rates with every block that is met while planned time passes.
    fn go(&mut self, passed: f64, rates: &RateRange, room: &StreamLimits) -> CheckOutcome {
        let mut until_s = self.at_s + passed;
        loop {
            let Some(window) = self.windows.get(self.window) else { return CheckOutcome::Broken };
            if self.left == 0 {
                return CheckOutcome::Broken;
            }
            self.left -= 1;
            let Some(block) = window.blocks.get(self.block) else {
                let last = self.window + 1 == self.windows.len();
                if window.wait.is_some() || (last && window.stop == WindowStop::Rest) {
                    return CheckOutcome::Rests;
                }
                until_s -= window.duration_s;
                self.window += 1;
                self.block = 0;
                continue;
            };
            if !block.allows(rates, room) {
                return CheckOutcome::Broken;
            }
            if until_s < block.end_s {
                self.at_s = until_s;
                return CheckOutcome::Holds;
            }
            self.block += 1;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn end(course: &RateCourse, from: TimeRate) -> TimeRate {
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
                        let from = TimeRate { value, slope };
                        let course = RateCourse::to(from, target, steep, bend);
                        let end = end(&course, from);
                        assert!((end.value - target).abs() < 1e-9, "{from:?} {course:?} {end:?}");
                        assert!(end.slope.abs() < 1e-9, "{from:?} {course:?} {end:?}");
                    }
                }
            }
        }
    }

    #[test]
    fn a_stop_passes_the_same_time_at_any_rate() {
        let whole = RateCourse::tail(1.0, 8.0, 200.0).passed(TimeRate::even(1.0));
        // It falls as evenly after its middle as before: on average the rate is a half.
        assert!((whole - RateCourse::tail(1.0, 8.0, 200.0).seconds() / 2.0).abs() < 1e-12);
        for rate in [0.9, 0.5, 0.01] {
            let tail = RateCourse::tail(rate, 8.0, 200.0);
            assert!((tail.passed(TimeRate::even(rate)) - whole).abs() < 1e-12);
            assert!(end(&tail, TimeRate::even(rate)).value.abs() < 1e-12);
        }
    }
}
