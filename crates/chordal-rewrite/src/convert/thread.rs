//! Cuts in step with the spindle among commands: overrides off, the cut, overrides on.

use chordal::control::{FeedMode, Move};
use chordal::{Command, CommandKind};

/// Commands of one thread.
pub(super) const COMMANDS: usize = 3;

/// The cut and its lead along the path, mm, where commands begin with a thread in one pass.
pub(super) fn first(commands: &[Command]) -> Option<(&Move, f64)> {
    let [before, cut, after, ..] = commands else { return None };
    let overrides = |command: &Command| match command.kind {
        CommandKind::Overrides(overrides) => Some(overrides.feed),
        _ => None,
    };
    let CommandKind::Line { motion, feed } = &cut.kind else { return None };
    let is_thread = overrides(before) == Some(false)
        && overrides(after) == Some(true)
        && feed.mode == FeedMode::PerRevolution;
    is_thread.then_some((motion, feed.value))
}

/// The lead along the axis that moves more.
pub(super) fn along_the_longer_axis(motion: &Move, lead_mm: f64) -> f64 {
    let [dx, dz] = [0, 2].map(|axis| (motion.to[axis] - motion.from[axis]).abs());
    let path = libm::hypot(dx, dz);
    if path > 0.0 { lead_mm * dx.max(dz) / path } else { lead_mm }
}
