//! The time that no velocity profile can beat within the limits of velocity and acceleration: the
//! two-pass time scaling, without jerk.
//!
//! With b = σ̇² the acceleration of an axis is q′b′/2 + q″b. Backwards from rest, the first pass
//! finds the largest b at each node from which the end can still be reached; forwards, the second
//! takes the largest b at the next node within that bound. Both limits of each axis hold exactly at
//! both ends of each interval, seen from inside it, so that steps of the curvature, the limit curve
//! of the speed and its traps (where q′ of an axis is zero) need no case of their own.
//! (Bobrow, Dubowsky, Gibson 1985; reachability: Pham and Pham 2018.)
//!
//! **Grid.** A piece begins as one interval for each tenth of a radian that the path turns on it, and
//! the run as at least 64. Intervals are then halved as long as halving changes their time by more
//! than their share, until the last halving has changed less than 8e-5 of the whole. Both ends
//! being held makes each grid a little slower than the limit, and its error falls at least in
//! proportion to the size of the intervals. The limit is therefore within one more such change, of
//! which 1.2 times is subtracted from the time: the result is rounded down.

mod run;
mod speed_region;

use chordal_geometry::PerAxis;
pub(crate) use run::JerkReserve;
pub use run::{PathRun, PathRunError};
use speed_region::SpeedRegion;

/// The smallest number of intervals of a run, and the largest beyond one per piece.
const MIN_INTERVALS: usize = 64;
const MAX_INTERVALS: usize = 4_000_000;
/// The largest fraction of the time that the last halving may have changed.
const MAX_UNKNOWN_SHARE: f64 = 8e-5;
/// How many times that change is subtracted: once is the limit of refinement to first order.
const REFINEMENT_MARGIN: f64 = 1.2;
const MAX_REFINEMENTS: usize = 14;
/// Largest turn on an interval of the first grid, rad.
const MAX_INTERVAL_TURN_RAD: f64 = 0.1;

/// The fastest velocity profile without jerk limits.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct TimeBound {
    /// A time that no profile within the limits falls below, s.
    pub time_s: f64,
    /// Points of the path, σ from the start.
    pub sigma: Vec<f64>,
    /// σ̇² at these points; linear between them.
    pub square: Vec<f64>,
}

#[derive(Clone, Copy)]
struct BoundInterval {
    piece: usize,
    from: f64,
    to: f64,
    /// This interval's part of the change of time by the halving that made it, s.
    change_s: f64,
    /// The time it took before it was halved, by the first of its halves.
    whole_s: Option<f64>,
}

/// The fastest profile without jerk limits, and a time that is never above the true one's by
/// rounding or by its grid, and at most 1e-4 of it below (more where 4 million intervals are not
/// enough).
pub fn time_bound(run: &PathRun<'_>) -> TimeBound {
    let mut intervals = first_grid(run);
    let mut square = scale(run, &intervals);
    for _ in 0..MAX_REFINEMENTS {
        let total: f64 =
            intervals.iter().zip(square.windows(2)).map(|(c, b)| interval_time(c, b)).sum();
        if unknown(&intervals) <= MAX_UNKNOWN_SHARE * total {
            break;
        }
        let share = 0.25 * MAX_UNKNOWN_SHARE * total / intervals.len() as f64;
        let Some(halved) = halve(&intervals, &square, share) else { break };
        let finer = scale(run, &halved);
        intervals = halved;
        square = finer;
        note_changes(&mut intervals, &square);
    }
    let time_s: f64 =
        intervals.iter().zip(square.windows(2)).map(|(c, b)| interval_time(c, b)).sum();
    let mut sigma = vec![0.0];
    sigma.extend(intervals.iter().map(|interval| interval.to));
    TimeBound {
        time_s: (time_s - REFINEMENT_MARGIN * unknown(&intervals)) * (1.0 - 1e-12),
        sigma,
        square,
    }
}

/// How much the last halvings changed the time, s.
fn unknown(intervals: &[BoundInterval]) -> f64 {
    intervals.iter().map(|interval| interval.change_s).sum()
}

fn first_grid(run: &PathRun<'_>) -> Vec<BoundInterval> {
    let mut intervals = Vec::with_capacity(run.pieces().len().max(MIN_INTERVALS));
    for (index, piece) in run.pieces().iter().enumerate() {
        if piece.length <= 0.0 {
            continue;
        }
        let (from, to) = (run.from(index), run.from(index) + piece.length);
        let turn = [0.0, 0.5, 1.0].map(|share| {
            let jet = piece.at(share * piece.length);
            let size = |row: &PerAxis<f64>| row.iter().map(|v| v * v).sum::<f64>().sqrt();
            let rate = size(&jet[1]);
            if rate > 0.0 { size(&jet[2]) / rate * piece.length } else { 0.0 }
        });
        let by_turn =
            turn.iter().fold(0.0, |most: f64, one| most.max(*one)) / MAX_INTERVAL_TURN_RAD;
        let by_length = MIN_INTERVALS as f64 * piece.length / run.length();
        let count = by_turn.max(by_length).ceil().clamp(1.0, 100_000.0) as usize;
        let count = count.min(1 + MAX_INTERVALS.saturating_sub(intervals.len()));
        let mut begins = from;
        for part in 1..=count {
            let ends =
                if part == count { to } else { from + piece.length * part as f64 / count as f64 };
            if ends > begins {
                let change_s = f64::INFINITY;
                intervals.push(BoundInterval {
                    piece: index,
                    from: begins,
                    to: ends,
                    change_s,
                    whole_s: None,
                });
                begins = ends;
            }
        }
    }
    intervals
}

/// Halves the intervals that changed more than their share; `None` when there is none.
fn halve(intervals: &[BoundInterval], square: &[f64], share: f64) -> Option<Vec<BoundInterval>> {
    let many = |interval: &BoundInterval| interval.change_s > share;
    let count = intervals.iter().filter(|interval| many(interval)).count();
    if count == 0 || intervals.len() + count > 2 * MAX_INTERVALS {
        return None;
    }
    let mut out = Vec::with_capacity(intervals.len() + count);
    for (interval, ends) in intervals.iter().zip(square.windows(2)) {
        let middle = 0.5 * (interval.from + interval.to);
        if many(interval) && middle > interval.from && middle < interval.to {
            let whole_s = Some(interval_time(interval, ends));
            out.push(BoundInterval { to: middle, whole_s, ..*interval });
            out.push(BoundInterval { from: middle, whole_s: None, ..*interval });
        } else {
            // An interval of the first grid that is too short to be halved has no say.
            let change_s = if interval.change_s.is_finite() { interval.change_s } else { 0.0 };
            out.push(BoundInterval { whole_s: None, change_s, ..*interval });
        }
    }
    Some(out)
}

/// What the last halving changed, half of it for each half.
fn note_changes(intervals: &mut [BoundInterval], square: &[f64]) {
    for index in 0..intervals.len() {
        let Some(before) = intervals[index].whole_s.take() else { continue };
        let (first, second) = (&intervals[index], &intervals[index + 1]);
        let now =
            interval_time(first, &square[index..]) + interval_time(second, &square[index + 1..]);
        let change = 0.5 * (before - now).abs();
        intervals[index].change_s = change;
        intervals[index + 1].change_s = change;
    }
}

/// Time over an interval with b linear between its ends.
fn interval_time(interval: &BoundInterval, ends: &[f64]) -> f64 {
    2.0 * (interval.to - interval.from) / (ends[0].sqrt() + ends[1].sqrt())
}

/// The two passes: b at the nodes.
fn scale(run: &PathRun<'_>, intervals: &[BoundInterval]) -> Vec<f64> {
    let room = |interval: &BoundInterval| {
        SpeedRegion::new(run, interval.piece, interval.from, interval.to)
    };
    let mut square = vec![0.0; intervals.len() + 1];
    for (index, interval) in intervals.iter().enumerate().rev() {
        let mut before = room(interval).largest_before(square[index + 1]);
        if index > 0 {
            let other = &intervals[index - 1];
            let cap = run.speed_cap(other.piece, &run.jet(other.piece, other.to));
            before = before.min(cap * cap);
        }
        square[index] = before;
    }
    square[0] = square[0].min(run.start_speed() * run.start_speed());
    for (index, interval) in intervals.iter().enumerate() {
        square[index + 1] = room(interval).largest_after(square[index], square[index + 1]);
    }
    square
}
