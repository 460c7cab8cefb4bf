//! Streaming for a servo loop: moves are pushed on one thread, setpoints pulled on another.
//!
//! ```text
//! moves → Feeder: plan, cut into windows, verify a stop in each ─┐ ring of windows
//!                                          ┌─ used windows ring ←┼─────────────┐
//!                                          └→ Feeder             └→ Servo: rate, setpoint
//! ```
//!
//! - Memory is bounded: windows are made once and go round. [`StreamFeeder::push`] says
//!   [`PushOutcome::Full`] while all of them are under way.
//! - Every window ends at rest, or carries a stop: a fall of the rate of time to zero before
//!   the window ends, verified on all axes. When no further window has come by then, the servo
//!   takes it; a window that comes later is spliced in where the axes are at that instant, in
//!   the middle of the stop, too.
//! - The axes never leave the planned path: hold, resume, override, underrun change when, not
//!   where.
//!
//! ```
//! use chordal_motion::{AxisLimit, AxisValues, KinematicLimits, StreamOptions, stream};
//!
//! let axis = AxisLimit { velocity: 200.0, acceleration: 2000.0, jerk: 1e5 };
//! let limits = KinematicLimits::new([Some(axis), Some(axis), Some(axis), None, None, None])?;
//! let (mut feeder, mut servo) = stream(limits, StreamOptions::default(), AxisValues::default());
//! feeder.finish();
//! assert_eq!(servo.next().position, AxisValues::default());
//! # Ok::<(), chordal_motion::LimitError>(())
//! ```

mod block;
mod bounds;
mod feeder;
mod rate;
mod servo;
mod timeline;
mod window;
mod window_cutter;

pub use feeder::{FeederError, PushOutcome, StreamFeeder, StreamOptions};
pub use servo::{ServoSetpoint, StreamServo};

use crate::{AxisValues, KinematicLimits};

/// A feeder and the servo it feeds, with the axes at rest at `start`.
pub fn stream(
    limits: KinematicLimits,
    options: StreamOptions,
    start: AxisValues,
) -> (StreamFeeder, StreamServo) {
    let options = options.sane();
    let room = block::StreamLimits::new(&limits);
    let (arrive, arriving) = rtrb::RingBuffer::new(options.windows);
    let (mut leaving, leave) = rtrb::RingBuffer::new(options.windows);
    for _ in 0..options.windows {
        // The rings hold every window there is.
        let _ = leaving.push(Box::new(window::StreamWindow::new()));
    }
    let feeder = StreamFeeder::new(limits, options, room, (arrive, leave));
    let times = (options.period_s, options.scale_waits);
    (feeder, StreamServo::new((arriving, leaving), options.windows, times, room, start))
}
