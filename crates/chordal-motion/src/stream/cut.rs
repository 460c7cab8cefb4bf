//! Cuts windows out of the line of time and finds the stop of each.

use chordal_geometry::PerAxis;

use super::block::Room;
use super::bounds;
use super::rate::{Ahead, Course, Rate};
use super::timeline::{Item, Timeline};
use super::window::{Leg, Stop, Timed, Window};

/// Rates at the wall for which a stop is looked for, the best first.
const LEVELS: PerAxis<f64> = [1.0, 0.7, 0.4, 0.1, 0.01, 0.001];
/// Shares of the steepest stop that are tried.
const STEEPNESS: [f64; 7] = [0.96, 0.6, 0.3, 0.1, 0.03, 0.01, 0.003];
/// How many lengths of a stop before the end of the window it is begun.
const EARLIER: [f64; 4] = [1.0, 1.3, 1.8, 3.0];

/// Puts what lies on the line before `end_s` into an empty window. False, and the window is
/// to be cleared, when it has not that much room.
pub(super) fn lay(timeline: &Timeline, end_s: f64, pieces: usize, window: &mut Window) -> bool {
    let mut before_end_s = f64::NEG_INFINITY;
    for item in &timeline.items {
        let Item::Stretch(laid, from_s) = item else { break };
        if *from_s >= end_s {
            break;
        }
        let to_s = from_s + laid.duration_s();
        let (first, last) = (laid.phase_at(-from_s), laid.phase_at(end_s - from_s));
        let (near, far) = (laid.piece_at(-from_s), laid.piece_at(end_s - from_s));
        let legs = window.legs.len() + 1;
        let phases = window.phases.len() + last - first + 1;
        if window.pieces.len() + far - near + 1 > pieces || phases > 7 * pieces || legs > pieces {
            return false;
        }
        let phases_from = window.phases.len();
        window.phases.extend(
            laid.stretch.phases[first..=last]
                .iter()
                .zip(&laid.times[first..])
                .map(|(phase, time)| Timed { from_s: from_s + time, phase: *phase }),
        );
        let pieces_from = window.pieces.len();
        let places = &laid.places[near..];
        for (piece, from) in laid.stretch.pieces[near..=far].iter().zip(places) {
            window.push(*from, piece);
        }
        window.legs.push(Leg {
            from_s: *from_s,
            to_s,
            phases: (phases_from, window.phases.len()),
            pieces: (pieces_from, window.pieces.len()),
            corner: laid.stretch.from(),
            overlaps: before_end_s > *from_s,
        });
        before_end_s = to_s;
    }
    window.duration_s = end_s;
    true
}

/// Finds the latest stop of a window that does not rest at its end; `None` when there is none
/// for the levels that may be used.
pub(super) fn find_stop(ahead: &Ahead, room: &Room, levels: usize) -> Option<Stop> {
    let window = ahead.front()?;
    let (steepest, sharpest) = room.steepest(&window.fastest);
    for level in &LEVELS[..levels.min(LEVELS.len())] {
        for share in STEEPNESS {
            // At a lower rate the same slope is less of an acceleration.
            let (rate, bend) = (steepest * share / level.powi(2), sharpest * share / level.powi(3));
            let course = Course::tail(*level, rate, bend);
            let way_s = course.passed(Rate::even(*level));
            for earlier in EARLIER {
                // Rounding may not carry the stop over the end.
                let at_s = window.duration_s - way_s * earlier - 1e-9;
                if at_s <= 0.0 {
                    break;
                }
                if course.holds(Rate::even(*level), ahead, at_s, room) {
                    return Some(Stop::Tail { at_s, level: *level, rate, bend });
                }
            }
        }
    }
    None
}

/// How many levels there are.
pub(super) fn all_levels() -> usize {
    LEVELS.len()
}

/// Works out what the axes do in the window.
pub(super) fn survey(window: &mut Window) {
    bounds::fill(window);
}
