//! Taps among the commands of a run: a cut along the normal, the spindle reversed, and the same way back.

use chordal::CommandKind;
use chordal::control::{Feed, FeedMode, Move, PostedKind, SpindleState, TappedHole};
use chordal::geometry::Plane;

use super::places::PlacedCommand;

/// Ratios of two speeds that are nearer to 1 are rounding.
const SAME_SPEED: f64 = 1e-9;

/// A tap, and how many commands make it.
pub(super) struct FoundTap {
    pub hole: TappedHole,
    pub length: usize,
    /// The spindle after it, and its speed, rev/min.
    pub spindle: (SpindleState, f64),
}

/// Reads the commands of a cycle one after the other.
struct TapReader<'p> {
    placed: &'p [PlacedCommand],
    at: usize,
    spindle: (SpindleState, f64),
    dwell_s: f64,
    /// The cycle has switched the feed override off, as only taps do.
    is_sure: bool,
}

impl<'p> TapReader<'p> {
    fn command(&self) -> Option<&'p CommandKind> {
        match &self.placed.get(self.at)?.kind {
            PostedKind::Command(command) => Some(command),
            PostedKind::MachineMove { .. } | PostedKind::Hole(_) | PostedKind::Tap(_) => None,
        }
    }

    /// Passes over what the spindle does, and dwells.
    fn skip(&mut self) {
        while let Some(command) = self.command() {
            if let CommandKind::Spindle { state, rpm } = command {
                self.spindle = (*state, *rpm);
            } else if let CommandKind::Overrides(overrides) = command {
                self.is_sure |= !overrides.feed;
            } else if let CommandKind::Dwell { seconds, .. } = command {
                self.dwell_s += seconds;
            } else {
                return;
            }
            self.at += 1;
        }
    }

    fn cut(&mut self) -> Option<(&'p Move, Feed)> {
        let Some(CommandKind::Line { motion, feed }) = self.command() else { return None };
        self.at += 1;
        Some((motion, *feed))
    }
}

/// The tap that begins here; `None` where none does, and why where its steps cannot be written.
pub(super) fn tap_of(
    placed: &[PlacedCommand],
    plane: Plane,
    before: (SpindleState, f64),
) -> Option<Result<FoundTap, String>> {
    let mut reader = TapReader { placed, at: 0, spindle: before, dwell_s: 0.0, is_sure: false };
    reader.skip();
    if reader.dwell_s > 0.0 {
        return None;
    }
    let (inward, rpm) = reader.spindle;
    let (down, feed) = reader.cut()?;
    reader.skip();
    let is_reversed = matches!(
        (inward, reader.spindle.0),
        (SpindleState::Cw, SpindleState::Ccw) | (SpindleState::Ccw, SpindleState::Cw)
    );
    if !is_reversed {
        return reader.is_sure.then(|| Err("a tap without a reversal of the spindle".into()));
    }
    let dwell_s = reader.dwell_s;
    let Some((up, out)) = reader.cut() else {
        return Some(Err("a tap that does not feed out".into()));
    };
    reader.skip();
    let (_, _, normal) = plane.axes();
    let is_along = |axis: usize| axis == normal || down.from[axis] == down.to[axis];
    let out_factor = match feed.mode {
        FeedMode::PerTime => out.value / feed.value,
        FeedMode::PerRevolution | FeedMode::InverseTime => {
            out.spindle_rev_per_s / feed.spindle_rev_per_s * out.value / feed.value
        }
    };
    let problem = if up.to[..3] != down.from[..3] || !(0..6).all(is_along) {
        Some(
            "a tap in several steps, or one that does not go back to where it began: write a tapping cycle that cuts the thread in one step, without chip breaking",
        )
    } else if (out_factor - 1.0).abs() > SAME_SPEED && feed.mode != FeedMode::PerTime {
        Some("a tap that feeds out at a different speed than in")
    } else if reader.dwell_s > dwell_s {
        Some("a tap with a dwell at its start")
    } else {
        None
    };
    if let Some(problem) = problem {
        return Some(Err(problem.into()));
    }
    if rpm <= 0.0 {
        return Some(Err("a tap without a spindle speed".into()));
    }
    let hole = TappedHole {
        plane,
        start: down.from,
        bottom_mm: down.to[normal],
        feed,
        out_factor: if (out_factor - 1.0).abs() > SAME_SPEED { out_factor } else { 1.0 },
        is_left: inward == SpindleState::Ccw,
        dwell_s,
        rpm,
        spindle: [before.0, reader.spindle.0],
    };
    Some(Ok(FoundTap { hole, length: reader.at, spindle: reader.spindle }))
}
