//! The pull side: a setpoint at each period.

mod rate_search;

use std::collections::VecDeque;

use rtrb::{Consumer, Producer};

use chordal_geometry::AXES;

use crate::sample::AxisState;
use crate::{AxisValues, MotionSample};

use super::block::StreamLimits;
use super::rate::{RateCourse, TimeRate, WindowQueue};
use super::window::{StreamWindow, WindowCursor, WindowStop};

/// Largest override.
const MAX_OVERRIDE: f64 = 2.0;

/// What an axis card is sent.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ServoSetpoint {
    /// mm and rad.
    pub position: AxisValues,
    /// mm/s and rad/s.
    pub velocity: AxisValues,
    /// mm/s² and rad/s².
    pub acceleration: AxisValues,
    /// The tag of the move or of the wait that is under way.
    pub tag: u64,
    /// Planned time that passes in a second: 0 rests, 1 moves as planned.
    pub rate: f64,
    /// A feed hold is active; the axes rest when the rate is 0.
    pub holding: bool,
    /// No further window has come in time: the axes come to a stop, or rest.
    pub underrun: bool,
    /// The end of the program is reached.
    pub finished: bool,
}

/// The pull side, for the thread that serves the axes: [`StreamServo::next`] allocates nothing, frees
/// nothing, takes no lock and has no loop that grows with the program.
///
/// The path and the velocity profile come planned; what changes here is the rate φ at which planned
/// time passes. Velocity, acceleration and jerk of an axis are vφ, aφ² + vφ̇ and
/// jφ³ + 3aφφ̇ + vφ̈. Every course of φ is checked against what all axes do in the time ahead
/// before its first instant is sent, and ends at an even rate of 1 at most, which is safe for
/// ever, or at rest. Hence, when the planned motion holds the limits:
///
/// - hold, resume and override hold them too, at any instant and in any order, within a
///   relative 1e-6; the axes never leave the planned path and never go back on it;
/// - an override above 100 % is used as far as the motion ahead leaves room, and 100 % where it
///   leaves none: an axis that moves at its limits does not get quicker;
/// - a change begins when the motion ahead leaves room for it: at once in even motion; while an
///   axis uses all its jerk, after that phase, or less steeply. Planning with some
///   [`headroom`](super::StreamOptions::headroom) makes sure that there is always some.
#[derive(Debug)]
pub struct StreamServo {
    pub(super) arriving: Consumer<Box<StreamWindow>>,
    pub(super) leaving: Producer<Box<StreamWindow>>,
    pub(super) period_s: f64,
    pub(super) scale_waits: bool,
    pub(super) room: StreamLimits,
    /// The window under way and those after it.
    windows: WindowQueue,
    /// Planned time in the first of them, s.
    at_s: f64,
    place: WindowCursor,
    rate: TimeRate,
    /// The second derivative of the rate at the setpoint.
    bend: f64,
    course: Option<ActiveCourse>,
    /// Where the motion stops when nothing further comes: planned time from the start of the
    /// first window, s, how, and the number of its window.
    wall: Option<(f64, WindowStop)>,
    wall_window: usize,
    /// What is left of a wait, s.
    waiting: Option<f64>,
    holding: bool,
    override_factor: f64,
    /// The next course to try.
    try_next: usize,
    underrun: bool,
    underruns: u64,
    /// Where the axes are before the first window and at planned rest.
    resting: Option<AxisState>,
    tag: u64,
}

/// What comes of a planned rest.
enum RestOutcome {
    /// Nothing moves in this period.
    Stays,
    /// There is something else to wait for.
    Waits,
    /// The motion begins.
    Goes,
}

/// A course under way.
#[derive(Clone, Copy, Debug)]
struct ActiveCourse {
    course: RateCourse,
    index: usize,
    /// Gone in the part at `index`, s.
    gone_s: f64,
    /// What is left of it by the clock, and half of the whole, s.
    left_s: f64,
    half_s: f64,
    /// The rate that it is for: the even one at its end, or the one above 1 on its way.
    reaches: f64,
}

impl ActiveCourse {
    /// Whether it still leads to what it is for: above 1 only in its first half, then another
    /// has to be found in time.
    fn is_fresh(&self) -> bool {
        self.reaches <= 1.0 || self.left_s > self.half_s
    }
}

impl StreamServo {
    pub(super) fn new(
        (arriving, leaving): (Consumer<Box<StreamWindow>>, Producer<Box<StreamWindow>>),
        windows: usize,
        (period_s, scale_waits): (f64, bool),
        room: StreamLimits,
        start: AxisValues,
    ) -> StreamServo {
        StreamServo {
            arriving,
            leaving,
            period_s,
            scale_waits,
            room,
            windows: VecDeque::with_capacity(windows + 1),
            at_s: 0.0,
            place: WindowCursor::default(),
            rate: TimeRate::even(1.0),
            bend: 0.0,
            course: None,
            wall: None,
            wall_window: 0,
            waiting: None,
            holding: false,
            override_factor: 1.0,
            try_next: 0,
            underrun: false,
            underruns: 0,
            resting: Some(AxisState { position: start, ..AxisState::default() }),
            tag: 0,
        }
    }

    /// Feed hold: the axes stop on the path.
    pub fn hold(&mut self) {
        if !self.holding {
            self.holding = true;
            self.try_next = 0;
        }
    }

    /// The motion goes on after a hold.
    pub fn resume(&mut self) {
        if self.holding {
            self.holding = false;
            self.try_next = 0;
        }
    }

    /// Feed override: 1 is 100 %. From 0 to 2; a number that is none changes nothing.
    pub fn set_override(&mut self, factor: f64) {
        // What is tried next stays: with another factor in every period the milder courses
        // must have their turn, too.
        if !factor.is_nan() {
            self.override_factor = factor.clamp(0.0, MAX_OVERRIDE);
        }
    }

    /// How often no further window came in time.
    pub fn underruns(&self) -> u64 {
        self.underruns
    }

    /// The setpoint one period after the last; for ever, as axes need one at rest, too.
    #[allow(clippy::should_implement_trait, reason = "there is always a next one, no option")]
    #[inline]
    pub fn next(&mut self) -> ServoSetpoint {
        self.take_windows();
        if self.course.is_some() || self.rate.value != self.target() {
            self.steer();
        }
        self.advance();
        self.setpoint()
    }

    fn target(&self) -> f64 {
        if self.holding { 0.0 } else { self.override_factor }
    }

    /// The even rate that is taken up at once where the plan rests.
    fn target_from_rest(&self) -> f64 {
        let level = match self.wall {
            Some((_, WindowStop::Tail { level, .. })) => level,
            _ => 1.0,
        };
        self.target().min(level).min(1.0)
    }

    /// The even rate that the axes come to when nothing is changed.
    fn ends_at(&self) -> f64 {
        self.course.as_ref().map_or(self.rate.value, |under| under.course.ends_at)
    }

    #[inline]
    fn take_windows(&mut self) {
        while let Ok(window) = self.arriving.pop() {
            self.windows.push_back(window);
            if self.windows.len() == 1 {
                self.place = WindowCursor::default();
                self.at_s = 0.0;
                self.enter_window();
            }
        }
        if self.wall_window < self.windows.len() {
            self.find_wall();
        }
    }

    /// Moves the wall to the newest window whose stop is safe at the present rate.
    fn find_wall(&mut self) {
        let mut from_s: f64 =
            self.windows.iter().take(self.wall_window).map(|window| window.duration_s).sum();
        for index in self.wall_window..self.windows.len() {
            let StreamWindow { stop, duration_s, .. } = *self.windows[index];
            let (wall_s, safe) = match stop {
                WindowStop::Unknown => (0.0, false),
                WindowStop::Rest => (from_s + duration_s, true),
                WindowStop::Tail { at_s, level, .. } => {
                    let rate = self.ends_at();
                    let is_resting = self.resting.is_some();
                    (from_s + at_s, is_resting || rate <= level)
                }
            };
            if safe && wall_s >= self.at_s {
                self.wall = Some((wall_s, stop));
                self.wall_window = index + 1;
            }
            from_s += duration_s;
        }
    }

    /// One period by the clock.
    #[inline]
    fn advance(&mut self) {
        let mut left_s = self.period_s;
        // Every turn uses up time, a window, a part of a course or a wait: windows are few.
        for _ in 0..64 {
            if left_s <= 0.0 {
                break;
            }
            if self.resting.is_some() {
                match self.leave_rest(&mut left_s) {
                    RestOutcome::Stays => return,
                    RestOutcome::Waits => continue,
                    RestOutcome::Goes => {}
                }
            }
            let before = left_s;
            if self.course.is_some() {
                self.along_course(&mut left_s);
            } else {
                self.evenly(&mut left_s);
            }
            if !self.pass_windows(&mut left_s, before) {
                return;
            }
        }
    }

    /// At planned rest, or before the first window.
    fn leave_rest(&mut self, left_s: &mut f64) -> RestOutcome {
        if !self.wait_out(left_s) {
            return RestOutcome::Stays;
        }
        let Some(window) = self.windows.front() else { return RestOutcome::Stays };
        if self.at_s >= window.duration_s {
            if self.windows.len() < 2 {
                if !window.last {
                    self.starve();
                }
                return RestOutcome::Stays;
            }
            self.drop_window();
            return RestOutcome::Waits;
        }
        // Nothing moves here, so that any even rate may be taken up.
        self.rate = TimeRate::even(self.target_from_rest());
        if self.rate.value == 0.0 {
            return RestOutcome::Stays;
        }
        self.resting = None;
        self.underrun = false;
        RestOutcome::Goes
    }

    /// Spends time on the wait, if there is one; whether it is over.
    fn wait_out(&mut self, left_s: &mut f64) -> bool {
        let Some(waiting) = self.waiting else { return true };
        let rate = if self.scale_waits { self.target() } else { 1.0 };
        if waiting > *left_s * rate {
            self.waiting = Some(waiting - *left_s * rate);
            return false;
        }
        if rate > 0.0 {
            *left_s -= waiting / rate;
        }
        self.waiting = None;
        true
    }

    /// A window without motion is a wait alone.
    fn enter_window(&mut self) {
        if let Some(window) = self.windows.front()
            && window.legs.is_empty()
            && let Some(wait) = window.wait
        {
            self.begin_wait(wait);
        }
    }

    fn begin_wait(&mut self, (seconds, tag): (f64, u64)) {
        self.waiting = Some(seconds);
        self.tag = tag;
        if let Some(state) = &mut self.resting {
            state.tag = tag;
        }
    }

    #[inline]
    fn evenly(&mut self, left_s: &mut f64) {
        self.bend = 0.0;
        let rate = self.rate.value;
        let Some((wall_s, stop)) = self.wall else {
            *left_s = 0.0;
            return;
        };
        if rate <= 0.0 {
            *left_s = 0.0;
            return;
        }
        let until_s = self.at_s + rate * *left_s;
        if until_s <= wall_s {
            self.at_s = until_s;
            *left_s = 0.0;
            return;
        }
        match stop {
            WindowStop::Unknown | WindowStop::Rest => {
                *left_s -= (wall_s - self.at_s) / rate;
                // Exactly the end, whatever rounding made of the time to it.
                self.at_s = if self.wall_window == 1 { window_end(&self.windows) } else { wall_s };
            }
            WindowStop::Tail { rate: steep, bend, .. } => {
                let mut course = RateCourse::even(rate);
                course.push((wall_s - self.at_s) / rate, 0.0);
                self.follow(course.then(&RateCourse::tail(rate, steep, bend)), 0.0, true);
                self.starve();
            }
        }
    }

    fn starve(&mut self) {
        if !self.underrun {
            self.underruns += 1;
        }
        self.underrun = true;
    }

    fn along_course(&mut self, left_s: &mut f64) {
        let Some(under) = &mut self.course else { return };
        let Some(bend) = under.course.get(under.index) else {
            self.rate = TimeRate::even(under.course.ends_at);
            self.bend = 0.0;
            self.course = None;
            return;
        };
        let rest_s = (bend.seconds - under.gone_s).max(0.0);
        let step_s = rest_s.min(*left_s);
        let (rate, passed) = self.rate.after(bend.bend, step_s);
        self.rate = rate;
        self.bend = bend.bend;
        self.at_s += passed.max(0.0);
        *left_s -= step_s;
        under.left_s -= step_s;
        if step_s >= rest_s {
            under.index += 1;
            under.gone_s = 0.0;
            if under.course.get(under.index).is_none() {
                self.rate = TimeRate::even(under.course.ends_at);
                self.course = None;
            }
        } else {
            under.gone_s += step_s;
        }
    }

    /// Goes over to the next window where the first is over; whether there is time to go on.
    #[inline]
    fn pass_windows(&mut self, left_s: &mut f64, before_s: f64) -> bool {
        // A period may pass several windows where the pieces are very short.
        loop {
            let Some(window) = self.windows.front() else { return false };
            if self.at_s < window.duration_s {
                return true;
            }
            let pauses = self.windows.get(1).is_none_or(|next| next.legs.is_empty());
            let rests = window.wait.is_some()
                || (window.stop == WindowStop::Rest && (pauses || self.wall_window == 1));
            if rests {
                // What went beyond the end is time to wait, or to begin anew.
                let beyond = self.at_s - window.duration_s;
                if self.rate.value > 0.0 {
                    *left_s = (*left_s + beyond / self.rate.value).min(before_s);
                }
                self.rest_at_end();
                return true;
            }
            if self.windows.len() < 2 {
                return true;
            }
            self.at_s -= window.duration_s;
            self.drop_window_keeping_time();
        }
    }

    /// The plan rests at the end of the first window.
    fn rest_at_end(&mut self) {
        let Some(window) = self.windows.front() else { return };
        self.at_s = window.duration_s;
        self.resting = window.end().or(self.resting);
        let wait = window.wait;
        self.course = None;
        self.rate = TimeRate::even(self.rate.value.clamp(0.0, 1.0));
        self.bend = 0.0;
        if let Some(state) = &self.resting {
            self.tag = state.tag;
        }
        if let Some(wait) = wait {
            self.begin_wait(wait);
        }
    }

    fn drop_window(&mut self) {
        self.at_s = 0.0;
        self.drop_window_keeping_time();
        self.enter_window();
    }

    fn drop_window_keeping_time(&mut self) {
        let Some(window) = self.windows.pop_front() else { return };
        if let Some((wall_s, _)) = &mut self.wall {
            *wall_s -= window.duration_s;
        }
        self.wall_window = self.wall_window.saturating_sub(1);
        if self.wall_window == 0 {
            self.wall = None;
            self.find_wall();
        }
        self.place = WindowCursor::default();
        // The ring back has room for every window there is.
        if let Err(rtrb::PushError::Full(window)) = self.leaving.push(window) {
            std::mem::forget(window);
        }
    }

    #[inline]
    fn setpoint(&mut self) -> ServoSetpoint {
        let ended = self.windows.front().is_some_and(|window| window.last)
            && self.windows.len() == 1
            && self.resting.is_some()
            && self.waiting.is_none()
            && self.at_s >= window_end(&self.windows);
        let mut point = ServoSetpoint {
            rate: self.rate.value,
            holding: self.holding,
            underrun: self.underrun,
            finished: ended,
            ..ServoSetpoint::default()
        };
        if let Some(state) = &self.resting {
            point.position = state.position;
            point.tag = state.tag;
            return point;
        }
        let Some(window) = self.windows.front() else { return point };
        let mut planned = MotionSample::default();
        self.place.fill(window, self.at_s, &mut planned);
        let TimeRate { value, slope } = self.rate;
        point.position = planned.position;
        point.tag = planned.tag;
        for axis in 0..AXES {
            let (v, a) = (planned.velocity[axis], planned.acceleration[axis]);
            point.velocity[axis] = v * value;
            point.acceleration[axis] = a * value * value + v * slope;
        }
        point
    }
}

fn window_end(windows: &WindowQueue) -> f64 {
    windows.front().map_or(0.0, |window| window.duration_s)
}
