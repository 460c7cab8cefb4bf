//! The push side: plans moves and publishes windows.

use std::collections::VecDeque;

use rtrb::{Consumer, Producer};

use crate::limits::{AxisLimit, KinematicLimits};
use crate::move_request::{MoveError, MoveRequest};
use crate::planner::{MotionPlanner, PlannerLevel, PlannerOptions};
use crate::trajectory::PlannerStep;

use super::block::StreamLimits;
use super::rate::WindowQueue;
use super::timeline::{StreamTimeline, TimelineItem};
use super::window::{StreamWindow, WindowStop};
use super::window_cutter;

/// How a stream is set up.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StreamOptions {
    /// Time between two setpoints, s.
    pub period_s: f64,
    /// Shortest planned time in a window, s.
    pub window_s: f64,
    /// How many windows there are: together they bound memory and the time ahead.
    pub windows: usize,
    /// How many pieces of path a window may hold, about 300 bytes each where they are used, and as many for each curve below. In
    /// shorter windows the stop has less path, so that the axes cannot get as quick as planned:
    /// let it be the most pieces that are travelled in two times `window_s`.
    pub pieces: usize,
    /// Share of each axis' acceleration and jerk that the plan leaves to changes of the rate
    /// (hold, resume, override), 0 to 0.5. It costs about a third of itself in cycle time.
    pub headroom: f64,
    /// Whether the feed override and feed hold act on a dwell, too.
    pub scale_waits: bool,
}

impl Default for StreamOptions {
    fn default() -> StreamOptions {
        StreamOptions {
            period_s: 0.001,
            window_s: 0.1,
            windows: 16,
            pieces: 16_384,
            headroom: 0.03,
            scale_waits: false,
        }
    }
}

impl StreamOptions {
    /// The nearest options that can be worked with.
    pub(super) fn sane(self) -> StreamOptions {
        let within = |value: f64, least: f64, most: f64| {
            if value.is_nan() { least } else { value.clamp(least, most) }
        };
        StreamOptions {
            period_s: within(self.period_s, 1e-5, 1.0),
            window_s: within(self.window_s, 0.01, 10.0),
            windows: self.windows.clamp(3, 1024),
            pieces: self.pieces.clamp(16, 1 << 20),
            headroom: within(self.headroom, 0.0, 0.5),
            scale_waits: self.scale_waits,
        }
    }
}

/// What became of a move.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PushOutcome {
    /// It is taken.
    Taken,
    /// All windows are under way: push it again later.
    Full,
}

/// What cannot be streamed.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum FeederError {
    /// The move cannot be planned; it is left out.
    #[error(transparent)]
    Move(#[from] MoveError),
    /// The stream is finished.
    #[error("a move after the end of the stream")]
    Finished,
}

/// Moves are planned together when they would take so long at their largest speeds, s: well
/// above any stop, well below what a window's late arrival would cost.
const LOOK_AHEAD_S: f64 = 1.0;

/// So many moves may be with the planner before it emits a step; then the axes stop after
/// the last of them, which bounds memory whatever the program is.
const MAX_MOVES_IN_PLANNER: usize = 1 << 17;

/// The push side of a stream, for any thread.
#[derive(Debug)]
pub struct StreamFeeder {
    planner: MotionPlanner,
    line: WindowMaker,
    /// Moves that the planner took since its last step.
    within: usize,
}

/// The line of time and what becomes of it.
#[derive(Debug)]
struct WindowMaker {
    options: StreamOptions,
    room: StreamLimits,
    timeline: StreamTimeline,
    arrive: Producer<Box<StreamWindow>>,
    leave: Consumer<Box<StreamWindow>>,
    /// The window that is being made: alone in here so that stops are checked as the servo does.
    making: WindowQueue,
    /// How far ahead the next window is to end when a shorter one had no stop, s.
    reach_s: f64,
    /// Everything known is to go out.
    flushing: bool,
    finished: bool,
    published_last: bool,
}

impl StreamFeeder {
    pub(super) fn new(
        limits: KinematicLimits,
        options: StreamOptions,
        room: StreamLimits,
        (arrive, leave): (Producer<Box<StreamWindow>>, Consumer<Box<StreamWindow>>),
    ) -> StreamFeeder {
        let planner = MotionPlanner::new(
            reduced(&limits, 1.0 - options.headroom),
            PlannerOptions {
                look_ahead_s: LOOK_AHEAD_S,
                ..PlannerOptions::new(PlannerLevel::Fast)
            },
        );
        let line = WindowMaker {
            options,
            room,
            timeline: StreamTimeline::default(),
            arrive,
            leave,
            making: VecDeque::with_capacity(1),
            reach_s: options.window_s,
            flushing: false,
            finished: false,
            published_last: false,
        };
        StreamFeeder { planner, line, within: 0 }
    }

    /// Plans a move and publishes what is certain.
    ///
    /// # Errors
    /// When the move cannot be planned; it is left out.
    pub fn push(&mut self, motion: &MoveRequest) -> Result<PushOutcome, FeederError> {
        if !self.line.accepts()? {
            return Ok(PushOutcome::Full);
        }
        let StreamFeeder { planner, line, within } = self;
        *within += 1;
        let mut take = |step: PlannerStep<'_>| {
            *within = 0;
            line.timeline.push(step);
        };
        planner.push(motion, &mut take)?;
        if self.within >= MAX_MOVES_IN_PLANNER {
            planner.finish(|step| line.timeline.push(step));
            self.within = 0;
        }
        line.publish();
        Ok(PushOutcome::Taken)
    }

    /// The axes come to rest and wait for a time, s.
    ///
    /// # Errors
    /// When the stream is finished.
    pub fn wait(&mut self, seconds: f64, tag: u64) -> Result<PushOutcome, FeederError> {
        if !self.line.accepts()? {
            return Ok(PushOutcome::Full);
        }
        let StreamFeeder { planner, line, .. } = self;
        planner.wait(seconds, tag, |step| line.timeline.push(step));
        line.publish();
        Ok(PushOutcome::Taken)
    }

    /// Takes a step that was planned elsewhere, at the best level for example. It must go on
    /// where the step before ended, and its limits should leave the headroom that is set.
    ///
    /// # Errors
    /// When the stream is finished.
    pub fn push_step(&mut self, step: PlannerStep<'_>) -> Result<PushOutcome, FeederError> {
        if !self.line.accepts()? {
            return Ok(PushOutcome::Full);
        }
        self.line.timeline.push(step);
        self.line.publish();
        Ok(PushOutcome::Taken)
    }

    /// No further move is known for now: plans to rest and publishes everything. What does not
    /// find a window at once goes out with later calls of this or any other function.
    pub fn flush(&mut self) {
        let StreamFeeder { planner, line, .. } = self;
        if !line.finished {
            planner.finish(|step| line.timeline.push(step));
        }
        line.flushing = true;
        line.publish();
    }

    /// The end of the program. Returns whether all of it is published; call it again until
    /// then.
    pub fn finish(&mut self) -> bool {
        let StreamFeeder { planner, line, .. } = self;
        if !line.finished {
            planner.finish(|step| line.timeline.push(step));
            line.flushing = true;
            line.finished = true;
        }
        line.publish();
        line.published_last
    }
}

/// Limits with a share of accelerations and jerks.
fn reduced(limits: &KinematicLimits, share: f64) -> KinematicLimits {
    let axes = [0, 1, 2, 3, 4, 5].map(|axis| {
        limits.axis(axis).map(|limit| AxisLimit {
            acceleration: limit.acceleration * share,
            jerk: limit.jerk * share,
            ..*limit
        })
    });
    KinematicLimits::new(axes).unwrap_or(*limits)
}

impl WindowMaker {
    /// Whether there is room for more, once what can go out has gone.
    fn accepts(&mut self) -> Result<bool, FeederError> {
        if self.finished {
            return Err(FeederError::Finished);
        }
        self.publish();
        if self.timeline.items.is_empty() {
            self.flushing = false;
        }
        // What was flushed goes out before anything comes after it.
        Ok(!self.flushing && self.next_end_s().is_none())
    }

    /// When the next window ends, if one can be made.
    fn next_end_s(&self) -> Option<f64> {
        let StreamTimeline { ends_s, certain_s, .. } = self.timeline;
        let whole = self.flushing || self.timeline.wait_index().is_some();
        let reach_s = self.reach_s;
        if whole && ends_s <= reach_s * 1.5 {
            return (!self.timeline.items.is_empty()).then_some(ends_s);
        }
        (reach_s <= if whole { ends_s } else { certain_s }).then_some(reach_s)
    }

    /// Publishes as many windows as there are.
    fn publish(&mut self) {
        while let Some(end_s) = self.next_end_s() {
            if self.making.is_empty() {
                let Ok(window) = self.leave.pop() else { return };
                self.making.push_back(window);
            }
            if !self.make(end_s) {
                continue;
            }
            self.reach_s = self.options.window_s;
            if let Some(window) = self.making.pop_front() {
                self.published_last = window.last;
                // The ring has room for every window there is.
                let _ = self.arrive.push(window);
            }
        }
        self.publish_end();
    }

    /// The end of the program, when its last window has gone out before that was known.
    fn publish_end(&mut self) {
        if !self.finished || self.published_last || !self.timeline.items.is_empty() {
            return;
        }
        let Some(mut window) = self.making.pop_front().or_else(|| self.leave.pop().ok()) else {
            return;
        };
        window.clear();
        window.wait = Some((0.0, 0));
        window.last = true;
        self.published_last = self.arrive.push(window).is_ok();
    }

    /// Makes a window that ends at `end_s`; false: another end is to be tried, `reach_s` says
    /// which.
    fn make(&mut self, end_s: f64) -> bool {
        let Some(window) = self.making.front_mut() else { return false };
        window.clear();
        if !window_cutter::fill_window(&self.timeline, end_s, self.options.pieces, window) {
            // Fewer pieces, then; a single instant always has room.
            self.reach_s = end_s / 2.0;
            return false;
        }
        window_cutter::survey(window);
        let whole = end_s >= self.timeline.ends_s;
        if whole {
            window.stop = WindowStop::Rest;
        } else {
            // A longer window may hold a better stop, if it may get longer at all.
            let longer_s = end_s * 1.5;
            let full = longer_s > 4.0 * self.options.window_s || end_s < self.options.window_s;
            let levels = if full { window_cutter::all_levels() } else { 1 };
            match window_cutter::find_stop(&self.making, &self.room, levels) {
                Some(stop) => {
                    if let Some(window) = self.making.front_mut() {
                        window.stop = stop;
                    }
                }
                None if !full => {
                    self.reach_s = longer_s;
                    return false;
                }
                None => {}
            }
        }
        self.timeline.cut(end_s);
        if whole {
            self.end_part();
        }
        true
    }

    /// The trajectories before a wait, or all of them, are in the window that is being made.
    fn end_part(&mut self) {
        let Some(window) = self.making.front_mut() else { return };
        if let Some(TimelineItem::Wait(seconds, tag)) = self.timeline.items.front() {
            window.wait = Some((*seconds, *tag));
            self.timeline.items.pop_front();
            self.timeline.measure();
        }
        window.last = self.finished && self.timeline.items.is_empty();
    }
}
