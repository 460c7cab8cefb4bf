//! Finds the reason why a move takes its time.

use super::report::TimeReason;

/// How long one move spent in which state.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct MoveProgress {
    /// The whole time, s.
    pub time_s: f64,
    /// At a constant speed equal to the programmed one, s.
    pub at_feed_s: f64,
    /// At a constant speed below it, s.
    pub even_s: f64,
    /// At a constant acceleration, s.
    pub even_acceleration_s: f64,
    /// At a changing acceleration, s.
    pub jerk_s: f64,
    /// True where it begins or ends at rest.
    pub rests: bool,
    /// True where it overlaps the move before or after it: a corner passed by overlapping both.
    pub overlaps: bool,
}

/// The properties of the move on which the reason depends, too.
#[derive(Clone, Copy, Debug)]
pub(super) struct ReasonQuery {
    pub rapid: bool,
    /// The path of X, Y and Z is not a line.
    pub curved: bool,
    /// Its length over its speed, s.
    pub ideal_s: f64,
}

/// Lost time below this share of the whole is negligible: the block counts as running at its feed.
const AT_FEED_LOSS_SHARE: f64 = 0.02;

/// A straight move that would take less than this at its feed, s, is short: controls have
/// servo periods of 1 to 8 ms and plan blocks ahead by tens of them.
const SHORT_MOVE_S: f64 = 0.02;

/// Decides why a move is not faster.
pub(super) fn reason_of(progress: &MoveProgress, query: &ReasonQuery) -> TimeReason {
    if query.rapid {
        return TimeReason::Rapid;
    }
    if progress.time_s - query.ideal_s <= AT_FEED_LOSS_SHARE * progress.time_s {
        return TimeReason::Feed;
    }
    if !query.curved && query.ideal_s < SHORT_MOVE_S && !progress.rests {
        return TimeReason::ShortSegments;
    }
    if query.curved && !progress.rests && progress.at_feed_s == 0.0 {
        return TimeReason::Curvature;
    }
    if progress.even_s > (progress.time_s - progress.at_feed_s) / 2.0 {
        return if query.curved { TimeReason::Curvature } else { TimeReason::AxisSpeed };
    }
    if progress.overlaps {
        return TimeReason::Corner;
    }
    if progress.rests {
        return TimeReason::Stop;
    }
    if progress.jerk_s > progress.even_acceleration_s {
        TimeReason::Jerk
    } else {
        TimeReason::Acceleration
    }
}
