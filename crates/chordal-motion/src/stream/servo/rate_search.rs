//! How the servo changes the rate: it draws up courses and follows the first that is proved safe.

use chordal_geometry::PerAxis;

use crate::AxisValues;

use super::{ActiveCourse, MAX_OVERRIDE, StreamServo};
use crate::stream::bounds;
use crate::stream::rate::{RateCourse, TimeRate};
use crate::stream::window::WindowStop;

/// Shares of the steepest change of the rate that are tried, quickest first; the first ones of
/// what the speeds of the next blocks allow, the others of what those of whole windows allow.
const STEEPNESS_SHARES: [f64; 9] = [0.96, 0.5, 0.96, 0.6, 0.35, 0.2, 0.1, 0.06, 0.03];
/// How many belong to the next blocks, and how many blocks those are.
const NEXT_TRIES_AND_BLOCKS: (usize, usize) = (2, 12);
/// Shares of the difference to the target rate that are tried, all of it first.
const DISTANCE_SHARES: PerAxis<f64> = [1.0, 0.5, 0.2, 0.05, 0.01, 0.001];
/// Courses that are drawn up, and that are checked, in one period at most.
const MAX_DRAFTS: usize = 9;
const MAX_CHECKS: usize = 2;
/// How long a rate above 1 is to last when it is checked, s by the clock.
const RAISED_RATE_S: [f64; 3] = [0.1, 0.04, 0.01];
impl StreamServo {
    /// Looks for a safe course towards the target rate.
    #[cold]
    pub(super) fn steer(&mut self) {
        if self.resting.is_some() {
            return;
        }
        let target = self.target();
        let (reached, left_s) = match &self.course {
            Some(under) if under.is_fresh() => (under.reaches, under.left_s),
            _ => (self.rate.value.clamp(0.0, MAX_OVERRIDE), f64::INFINITY),
        };
        let off = (reached - target).abs();
        if off == 0.0 && (left_s.is_finite() && target > 1.0) {
            return;
        }
        let Some((near, far)) = self.fastest() else { return };
        let (near, far) = (self.room.steepest(&near), self.room.steepest(&far));
        // Where the target rate is under way, only a quicker course to it is looked for.
        let shares = if off > 1e-9 { DISTANCE_SHARES.len() } else { 1 };
        let mut checks = 0;
        for _ in 0..MAX_DRAFTS {
            let index = self.try_next % (STEEPNESS_SHARES.len() * shares);
            self.try_next = index + 1;
            let kind = index % STEEPNESS_SHARES.len();
            let part = STEEPNESS_SHARES[kind];
            let (steep, bend) = if kind < NEXT_TRIES_AND_BLOCKS.0 { near } else { far };
            let share = DISTANCE_SHARES[index / STEEPNESS_SHARES.len()];
            let from = if target > 1.0 { 1.0 } else { self.rate.value };
            let aim = if share < 1.0 { from + share * (target - from) } else { target };
            let nearer = (aim - target).abs();
            let course = self.towards(aim, steep * part, bend * part, RAISED_RATE_S[index % 3]);
            let better = nearer < off - 1e-9 || (nearer <= off && course.seconds() < 0.9 * left_s);
            if !better {
                continue;
            }
            if self.is_safe(&course) {
                self.follow(course, aim, false);
                self.try_next = 0;
                return;
            }
            checks += 1;
            if checks == MAX_CHECKS {
                return;
            }
        }
    }

    /// Largest speeds of the axes in the next blocks, and in this window and the next.
    fn fastest(&self) -> Option<(AxisValues, AxisValues)> {
        let window = self.windows.front()?;
        let mut far = window.fastest;
        if let Some(next) = self.windows.get(1) {
            for (far, next) in far.iter_mut().zip(&next.fastest) {
                *far = far.max(*next);
            }
        }
        let first = window.blocks.partition_point(|block| block.end_s <= self.at_s);
        let end = (first + NEXT_TRIES_AND_BLOCKS.1).min(window.blocks.len());
        Some((bounds::fastest(&window.blocks[first.min(end)..end]), far))
    }

    /// A course to a rate; where that is above 1, it lasts for a while and goes back to 1.
    fn towards(&self, aim: f64, steep: f64, bend: f64, above_s: f64) -> RateCourse {
        let mut course = RateCourse::to(self.rate, aim, steep, bend);
        if aim > 1.0 {
            course.push(above_s, 0.0);
            course = course.then(&RateCourse::to(TimeRate::even(aim), 1.0, steep, bend));
        }
        course
    }

    fn is_safe(&self, course: &RateCourse) -> bool {
        let end_s = self.at_s + course.passed(self.rate);
        let within = match self.wall {
            _ if course.ends_at == 0.0 => true,
            Some((_, WindowStop::Rest)) => true,
            Some((wall_s, WindowStop::Tail { level, .. })) => {
                end_s <= wall_s && course.ends_at <= level
            }
            Some((_, WindowStop::Unknown)) | None => false,
        };
        within && course.holds(self.rate, &self.windows, self.at_s, &self.room)
    }

    pub(super) fn follow(&mut self, course: RateCourse, reaches: f64, starved: bool) {
        let left_s = course.seconds();
        let half_s = left_s / 2.0;
        self.course = Some(ActiveCourse { course, reaches, index: 0, gone_s: 0.0, left_s, half_s });
        if !starved {
            self.underrun = false;
        }
    }
}
