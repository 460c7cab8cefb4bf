//! Cuts windows out of the line of time and finds the stop of each.

use chordal_geometry::PerAxis;

use super::block::StreamLimits;
use super::bounds;
use super::rate::{RateCourse, TimeRate, WindowQueue};
use super::timeline::{StreamTimeline, TimelineItem};
use super::window::{StreamWindow, TimedPhase, WindowLeg, WindowStop};

/// Rates at the wall for which a stop is looked for, the best first.
const WALL_RATES: PerAxis<f64> = [1.0, 0.7, 0.4, 0.1, 0.01, 0.001];
/// Shares of the steepest stop that are tried.
const STOP_STEEPNESS_SHARES: [f64; 7] = [0.96, 0.6, 0.3, 0.1, 0.03, 0.01, 0.003];
/// How many lengths of a stop before the end of the window it is begun.
const STOP_LEAD_FACTORS: [f64; 4] = [1.0, 1.3, 1.8, 3.0];

/// Puts what lies on the line before `end_s` into an empty window. False, and the window is
/// to be cleared, when it has not that much room.
pub(super) fn fill_window(
    timeline: &StreamTimeline,
    end_s: f64,
    pieces: usize,
    window: &mut StreamWindow,
) -> bool {
    let mut before_end_s = f64::NEG_INFINITY;
    for item in &timeline.items {
        let TimelineItem::Trajectory(entry, from_s) = item else { break };
        if *from_s >= end_s {
            break;
        }
        let to_s = from_s + entry.duration_s();
        let (first, last) = (entry.phase_at(-from_s), entry.phase_at(end_s - from_s));
        let (near, far) = (entry.piece_at(-from_s), entry.piece_at(end_s - from_s));
        let legs = window.legs.len() + 1;
        let phases = window.phases.len() + last - first + 1;
        if window.pieces.len() + far - near + 1 > pieces || phases > 7 * pieces || legs > pieces {
            return false;
        }
        let phases_from = window.phases.len();
        window.phases.extend(
            entry.trajectory.phases[first..=last]
                .iter()
                .zip(&entry.times[first..])
                .map(|(phase, time)| TimedPhase { from_s: from_s + time, phase: *phase }),
        );
        let pieces_from = window.pieces.len();
        let places = &entry.places[near..];
        for (piece, from) in entry.trajectory.pieces[near..=far].iter().zip(places) {
            window.push(*from, piece);
        }
        window.legs.push(WindowLeg {
            from_s: *from_s,
            to_s,
            phases: (phases_from, window.phases.len()),
            pieces: (pieces_from, window.pieces.len()),
            corner: entry.trajectory.from(),
            overlaps: before_end_s > *from_s,
        });
        before_end_s = to_s;
    }
    window.duration_s = end_s;
    true
}

/// Finds the latest stop of a window that does not rest at its end; `None` when there is none
/// for the levels that may be used.
pub(super) fn find_stop(
    ahead: &WindowQueue,
    room: &StreamLimits,
    levels: usize,
) -> Option<WindowStop> {
    let window = ahead.front()?;
    let (steepest, sharpest) = room.steepest(&window.fastest);
    for level in &WALL_RATES[..levels.min(WALL_RATES.len())] {
        for share in STOP_STEEPNESS_SHARES {
            // At a lower rate the same slope is less of an acceleration.
            let (rate, bend) = (steepest * share / level.powi(2), sharpest * share / level.powi(3));
            let course = RateCourse::tail(*level, rate, bend);
            let stop_s = course.passed(TimeRate::even(*level));
            for earlier in STOP_LEAD_FACTORS {
                // Rounding may not carry the stop over the end.
                let at_s = window.duration_s - stop_s * earlier - 1e-9;
                if at_s <= 0.0 {
                    break;
                }
                if course.holds(TimeRate::even(*level), ahead, at_s, room) {
                    return Some(WindowStop::Tail { at_s, level: *level, rate, bend });
                }
            }
        }
    }
    None
}

/// How many levels there are.
pub(super) fn all_levels() -> usize {
    WALL_RATES.len()
}

/// Works out what the axes do in the window.
pub(super) fn survey(window: &mut StreamWindow) {
    bounds::fill(window);
}
