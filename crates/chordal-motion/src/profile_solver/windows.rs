//! What is long is solved in windows. Each ends at rest; what lies so far before its end that the
//! rest cannot reach it is kept, and the next window goes on from there.

use chordal_geometry::AXES;

use super::grid::GridNode;
use super::{ProfileSolver, RunEnding, WindowSide};
use crate::time_bound::PathRun;

/// The length of a window at least, by its time without jerk, s: several times the longest braking, of which the next
/// window repeats one.
const MIN_WINDOW_S: f64 = 0.5;
/// The end of a window that is solved again by the next one, s, at least: it ends at rest, which the path does not.
const MIN_RESOLVED_S: f64 = 0.15;
/// Before the last braking of a window, this share of the time that a rest takes to reach is solved again, too.
const RAMP_RESOLVED_SHARE: f64 = 0.4;
/// Rounds in which limits are tightened where the phases, measured on every axis, use more than there is.
const MAX_TIGHTENINGS: usize = 10;
/// A use of a limit that is above one by no more is rounding.
const LIMIT_ROUNDING_SHARE: f64 = 1e-9;
/// The share of a limit that is kept for what lies between the probed instants of a phase.
const PROBE_RESERVE_SHARE: f64 = 1e-5;
/// Intervals of a window at least.
const MIN_WINDOW_INTERVALS: usize = 8;

/// Where a window begins, and where the one before it did.
#[derive(Clone, Copy, Debug)]
struct WindowStart {
    from: usize,
    side: WindowSide,
    before: Option<(usize, WindowSide)>,
}

impl ProfileSolver {
    /// Solves for all coefficients, window by window.
    pub(super) fn solve(
        &mut self,
        run: &PathRun<'_>,
        ends: [RunEnding; 2],
        look_s: f64,
        gap: f64,
    ) -> Option<()> {
        let count = self.grid.intervals.len();
        self.coefficients.clear();
        self.coefficients.resize(count, 0.0);
        if let RunEnding::Even(speed) = ends[0] {
            self.coefficients[..2].fill(speed * speed);
        }
        self.solved = 0;
        let window_s = MIN_WINDOW_S.max(3.0 * look_s);
        let side = if ends[0] == RunEnding::Rest { WindowSide::Rest } else { WindowSide::Fixed };
        let mut begin = WindowStart { from: 0, side, before: None };
        loop {
            let mut to = self.after(begin.from, window_s);
            if count - to < MIN_WINDOW_INTERVALS {
                to = count;
            }
            let is_last = to == count;
            let end = match ends[1] {
                RunEnding::Even(speed) if is_last => {
                    self.coefficients[count - 2..].fill(speed * speed);
                    WindowSide::Fixed
                }
                _ => WindowSide::Rest,
            };
            let Some(solved) = self.solve_or_wider(run, begin, to, end, gap) else {
                self.failed_at = if is_last { f64::NAN } else { self.grid.nodes[begin.from].at };
                return None;
            };
            if is_last {
                return Some(());
            }
            let from = self.settled_until(begin.from, to, look_s);
            begin = WindowStart { from, side: WindowSide::Fixed, before: Some(solved) };
        }
    }

    /// Solves a window. Where what the window before has left cannot be gone on with, both are solved as
    /// one: where it begins, then.
    fn solve_or_wider(
        &mut self,
        run: &PathRun<'_>,
        begin: WindowStart,
        to: usize,
        end: WindowSide,
        gap: f64,
    ) -> Option<(usize, WindowSide)> {
        let own = (begin.from, begin.side);
        if self.solve_window(run, (own.0, to), [own.1, end], gap).is_some() {
            return Some(own);
        }
        let wider = begin.before?;
        self.solve_window(run, (wider.0, to), [wider.1, end], gap).map(|()| wider)
    }

    /// The time to a rest from the largest speed.
    pub(super) fn look_s(&self) -> f64 {
        let most = |of: fn(&GridNode) -> &[f64; AXES]| {
            let rates = self.grid.nodes.iter().flat_map(of);
            rates.fold(0.0_f64, |most, rate| most.max(rate.abs()))
        };
        let a = 1.0 / most(|node| &node.by_acceleration[0]);
        let j = 1.0 / most(|node| &node.by_jerk[0]);
        let speed = self.grid.bound.iter().fold(0.0_f64, |most, b| most.max(*b)).sqrt();
        let brake_s = if speed * j > a * a { speed / a + a / j } else { 2.0 * (speed / j).sqrt() };
        MIN_RESOLVED_S.max(brake_s)
    }

    /// So far a window that ends at rest is kept: its last braking, and the time in which jerk turns what was
    /// before into that, is solved again by the next.
    fn settled_until(&self, from: usize, to: usize, look_s: f64) -> usize {
        let falls = |k: &usize| self.coefficients[*k - 1] > self.coefficients[*k];
        let brakes = (from + 1..to).rev().take_while(falls).count();
        let before_brakes = self.before(to - brakes, RAMP_RESOLVED_SHARE * look_s);
        // Some of every window is kept.
        let least = from + ((to - from) / MIN_WINDOW_INTERVALS).max(3);
        self.before(to, look_s).min(before_brakes).max(least)
    }

    /// The first interval that begins a time after the start of another, or as many intervals after it as a window
    /// has at least.
    fn after(&self, from: usize, seconds: f64) -> usize {
        let (mut to, mut t) = (from, 0.0);
        while to < self.grid.intervals.len() && t < seconds {
            t += self.interval_s(to);
            to += 1;
        }
        to.max(from + 2 * MIN_WINDOW_INTERVALS).min(self.grid.intervals.len())
    }

    fn before(&self, to: usize, seconds: f64) -> usize {
        let (mut from, mut t) = (to, 0.0);
        while from > 0 && t < seconds {
            from -= 1;
            t += self.interval_s(from);
        }
        from.min(to.saturating_sub(3))
    }

    /// Solves a window until its phases hold every limit as far as they are kept.
    fn solve_window(
        &mut self,
        run: &PathRun<'_>,
        (from, to): (usize, usize),
        sides: [WindowSide; 2],
        gap: f64,
    ) -> Option<()> {
        let count = self.grid.intervals.len();
        self.begin_window((from, to), sides);
        for round in 0..=MAX_TIGHTENINGS {
            let n = to - from;
            let solution = if round == 0 {
                self.newton.solve(&self.grid, (from, to), sides, &mut self.window, gap)
            } else {
                self.newton.again(&self.grid, (from, to), sides, &mut self.window, gap)
            };
            self.work.windows += 1;
            self.work.steps += u64::from(solution.iterations) * n as u64;
            if !solution.converged {
                self.work.failed += 1;
                return None;
            }
            // The intervals after the kept ones count, too: so the next window has a profile to its rest.
            let first = from + usize::from(sides[0] == WindowSide::Fixed);
            // The stop of a window that others follow is not the last word.
            let is_stop = to < count || sides[1] == WindowSide::Fixed;
            let last = if is_stop { to - 1 } else { count };
            if !self.tighten(run, from, (first, last), round) {
                self.coefficients[from..to].copy_from_slice(&self.window);
                self.solved = to;
                return Some(());
            }
            if round == MAX_TIGHTENINGS {
                break;
            }
        }
        self.work.failed += 1;
        None
    }

    /// The profile with which a window is begun.
    fn begin_window(&mut self, (from, to): (usize, usize), sides: [WindowSide; 2]) {
        let n = to - from;
        self.window.clear();
        self.window.resize(n, 0.0);
        for (side, fixed) in [(0, 0..2), (1, n - 2..n)] {
            if sides[side] == WindowSide::Fixed {
                let known_ends = &self.coefficients[from + fixed.start..from + fixed.end];
                self.window[fixed].copy_from_slice(known_ends);
            }
        }
        self.start.find(&self.grid, (from, to), sides, &mut self.window);
        // What the window before had beyond its kept part is a profile already.
        if sides[0] == WindowSide::Fixed && from + 2 < self.solved {
            let known = &self.coefficients[from + 2..self.solved];
            for (value, known) in self.window[2..].iter_mut().zip(known) {
                *value = value.max(*known);
            }
        }
    }

    /// Lowers what may be used where the phases use too much; whether they do.
    fn tighten(
        &mut self,
        run: &PathRun<'_>,
        from: usize,
        (first, last): (usize, usize),
        round: usize,
    ) -> bool {
        const TIGHTENING_FACTOR: f64 = 1.0015;
        const SPEED_TIGHTENING_FACTOR: f64 = 1.000_02;
        // What stays over is taken back more and more.
        let more = |used: f64| (used * TIGHTENING_FACTOR).powi(1 + round as i32 / 2);
        let mut over = false;
        let (mut speed, mut nodes) = (1.0 + LIMIT_ROUNDING_SHARE, last..first);
        for interval in first..last {
            let used = self.grid.use_of(interval, &self.window, from, run);
            if used.velocity > 1.0 + LIMIT_ROUNDING_SHARE {
                speed = speed.max(used.velocity);
                nodes = nodes.start.min(interval)..nodes.end.max(interval + 2);
            }
            let most = self.grid.intervals[interval].most;
            if used.jerk > most * (1.0 - PROBE_RESERVE_SHARE) {
                self.grid.intervals[interval].share /= more(used.jerk / most);
                over = true;
            }
            if used.acceleration > 1.0 - PROBE_RESERVE_SHARE {
                for node in [interval, interval + 1] {
                    self.grid.nodes[node].share /= more(used.acceleration);
                }
                over = true;
            }
        }
        if speed > 1.0 + LIMIT_ROUNDING_SHARE {
            // Where a speed stays even, what bulges out between two nodes moves on to the next ones.
            let inner = nodes.start.max(first + 2)..nodes.end.min(last - 1);
            let inner = self.grid.nodes.get_mut(inner).unwrap_or_default();
            inner.iter_mut().for_each(|node| node.cap /= (speed * SPEED_TIGHTENING_FACTOR).powi(2));
            over = true;
        }
        over
    }
}
