//! The law of time along a run: as quick as velocity, acceleration and jerk of every axis allow
//! together.
//!
//! | pass | file |
//! |---|---|
//! | the run in cells, and a first law without jerk along the path | `grid.rs` |
//! | a first law of a window, with jerk along the path | `start.rs` |
//! | the quickest law on a window of cells | `newton/` |
//! | phases of even jerk, and what they use | `phases.rs` |
//!
//! A long run is solved in windows. Each ends at rest; what lies so far before its end that the
//! rest cannot reach it is kept, and the next window goes on from there.

mod grid;
mod newton;
mod phases;
mod start;

use std::ops::Range;

use chordal_geometry::AXES;

use crate::bound::Run;
use crate::trajectory::Phase;
use grid::{Grid, Node};
use newton::Newton;
use start::Start;

/// How a run begins or ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Ends {
    /// At rest.
    Rest,
    /// At this speed, without acceleration.
    Even(f64),
}

/// How a window begins or ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Side {
    /// At rest.
    Rest,
    /// With two coefficients that are given.
    Fixed,
}

/// Where a window begins, and where the one before it did.
#[derive(Clone, Copy, Debug)]
struct Begin {
    from: usize,
    side: Side,
    before: Option<(usize, Side)>,
}

/// A law nearer the least time than this needs smaller cells, down to this share of the usual length.
const USUAL_GAP: f64 = 2e-4;
const FINEST: f64 = 0.25;
/// A window takes so long at least without jerk, s.
const WINDOW_S: f64 = 0.5;
/// So much of its end is solved again by the next, s.
const LOOK_S: f64 = 0.15;
/// Before the last braking of a window, this share of the time that a rest takes to reach is solved again, too.
const RAMP_SHARE: f64 = 0.4;
/// Rounds of taking limits back where the phases use more than there is.
const ROUNDS: usize = 10;
/// Use of a limit above one by no more is rounding.
const ROUNDING: f64 = 1e-9;
/// So much is kept for what lies between the places of a phase that are looked at.
const BETWEEN: f64 = 1e-5;
/// Speeds whose squares differ by no larger share are passed at the lowest of them.
const EVEN: f64 = 1e-3;
/// An even speed that uses no more of acceleration and jerk is reached and left like one on a line.
const CALM: f64 = 0.5;
/// No window has fewer cells.
const FEWEST: usize = 8;

/// What laws took.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Work {
    /// Cells of all runs.
    pub cells: u64,
    /// Windows, each as often as it was solved.
    pub windows: u64,
    /// Windows without an answer.
    pub failed: u64,
    /// Iterations times cells.
    pub steps: u64,
}

/// Finds laws, one after the other; keeps its memory.
#[derive(Debug, Default)]
pub(crate) struct Planner {
    grid: Grid,
    start: Start,
    newton: Newton,
    coefficients: Vec<f64>,
    window: Vec<f64>,
    /// So many coefficients have been solved, if not all of them for good.
    solved: usize,
    /// Cells on which the law is even, with the square of the speed.
    cruises: Vec<(Range<usize>, f64)>,
    pub work: Work,
}

impl Planner {
    /// The law of a run as phases; `None` where none was found within all limits.
    pub fn plan(&mut self, run: &Run<'_>, ends: [Ends; 2], gap: f64) -> Option<Vec<Phase>> {
        if !self.grid.lay(run, ends, (gap / USUAL_GAP).clamp(FINEST, 1.0)) {
            return None;
        }
        self.work.cells += self.grid.cells.len() as u64;
        let look_s = self.look_s();
        self.find_cruises(run, look_s);
        if self.solve(run, ends, look_s, gap).is_none() {
            // A cruise that is not reached in time is no ground to have no law.
            if self.cruises.is_empty() {
                return None;
            }
            self.cruises.clear();
            self.solve(run, ends, look_s, gap)?;
        }
        Some(self.phases(ends))
    }

    /// Solves for all coefficients, window by window.
    fn solve(&mut self, run: &Run<'_>, ends: [Ends; 2], look_s: f64, gap: f64) -> Option<()> {
        let count = self.grid.cells.len();
        self.coefficients.clear();
        self.coefficients.resize(count, 0.0);
        if let Ends::Even(speed) = ends[0] {
            self.coefficients[..2].fill(speed * speed);
        }
        self.solved = 0;
        let window_s = WINDOW_S.max(3.0 * look_s);
        let side = if ends[0] == Ends::Rest { Side::Rest } else { Side::Fixed };
        let mut begin = Begin { from: 0, side, before: None };
        let mut next_cruise = 0;
        loop {
            let mut to = self.after(begin.from, window_s);
            if count - to < FEWEST {
                to = count;
            }
            while self
                .cruises
                .get(next_cruise)
                .is_some_and(|(range, _)| range.start < begin.from + FEWEST)
            {
                next_cruise += 1;
            }
            let cruise = self.cruises.get(next_cruise).cloned();
            let cruise = cruise.filter(|(range, _)| range.start + 2 < to + FEWEST);
            if let Some((range, square)) = cruise {
                self.coefficients[range.clone()].fill(square);
                self.solve_or_wider(run, begin, range.start + 2, Side::Fixed, gap)?;
                begin = Begin { from: range.end - 2, side: Side::Fixed, before: None };
                continue;
            }
            let is_last = to == count;
            let end = match ends[1] {
                Ends::Even(speed) if is_last => {
                    self.coefficients[count - 2..].fill(speed * speed);
                    Side::Fixed
                }
                _ => Side::Rest,
            };
            let solved = self.solve_or_wider(run, begin, to, end, gap)?;
            if is_last {
                return Some(());
            }
            let from = self.kept(begin.from, to, look_s);
            begin = Begin { from, side: Side::Fixed, before: Some(solved) };
        }
    }

    /// Solves a window. Where what the window before has left cannot be gone on with, both are solved as
    /// one: where it begins, then.
    fn solve_or_wider(
        &mut self,
        run: &Run<'_>,
        begin: Begin,
        to: usize,
        end: Side,
        gap: f64,
    ) -> Option<(usize, Side)> {
        let own = (begin.from, begin.side);
        if self.solve_window(run, (own.0, to), [own.1, end], gap).is_some() {
            return Some(own);
        }
        let wider = begin.before?;
        self.solve_window(run, (wider.0, to), [wider.1, end], gap).map(|()| wider)
    }

    /// Where the law without jerk is even for so long that jerk changes nothing in the middle.
    fn find_cruises(&mut self, run: &Run<'_>, look_s: f64) {
        self.cruises.clear();
        let cells = self.grid.cells.len();
        let mut begin = 0;
        while begin < cells {
            let first = self.grid.bound[begin];
            let like = |b: &&f64| (**b - first).abs() <= EVEN * first;
            let even = self.grid.bound[begin..].iter().take_while(like);
            let (count, square) =
                even.fold((0, first), |(count, least), b| (count + 1, least.min(*b)));
            let end = begin + count;
            let after = self.after_exactly(begin, look_s);
            let until = self.before(end, look_s);
            if until > after + 2 * FEWEST {
                self.window.clear();
                self.window.resize(end - begin, square);
                let fits = |cell: usize| {
                    let used = self.grid.use_of(cell, &self.window, begin, run);
                    used.velocity <= 1.0 + ROUNDING && used.acceleration.max(used.jerk) <= CALM
                };
                if (after..until).all(fits) {
                    self.cruises.push((after..until, square));
                }
            }
            begin = end.max(begin + 1);
        }
    }

    /// The time to a rest from the largest speed.
    fn look_s(&self) -> f64 {
        let most = |of: fn(&Node) -> &[f64; AXES]| {
            let rates = self.grid.nodes.iter().flat_map(of);
            rates.fold(0.0_f64, |most, rate| most.max(rate.abs()))
        };
        let a = 1.0 / most(|node| &node.by_acceleration[0]);
        let j = 1.0 / most(|node| &node.by_jerk[0]);
        let speed = self.grid.bound.iter().fold(0.0_f64, |most, b| most.max(*b)).sqrt();
        let brake_s = if speed * j > a * a { speed / a + a / j } else { 2.0 * (speed / j).sqrt() };
        LOOK_S.max(brake_s)
    }

    /// So far a window that ends at rest is kept: its last braking, and the time in which jerk turns what was
    /// before into that, is solved again by the next.
    fn kept(&self, from: usize, to: usize, look_s: f64) -> usize {
        let falls = |k: &usize| self.coefficients[*k - 1] > self.coefficients[*k];
        let brakes = (from + 1..to).rev().take_while(falls).count();
        let before_brakes = self.before(to - brakes, RAMP_SHARE * look_s);
        // Some of every window is kept.
        let least = from + ((to - from) / FEWEST).max(3);
        self.before(to, look_s).min(before_brakes).max(least)
    }

    /// About the least time of the last run without jerk along the path, s.
    pub fn least_s(&self) -> f64 {
        (0..self.grid.cells.len()).map(|cell| self.cell_s(cell)).sum()
    }

    fn cell_s(&self, cell: usize) -> f64 {
        self.grid.cells[cell].length / self.grid.bound[cell].sqrt().max(1e-9)
    }

    /// The first cell that begins a time after the start of another.
    fn after_exactly(&self, from: usize, seconds: f64) -> usize {
        let (mut to, mut t) = (from, 0.0);
        while to < self.grid.cells.len() && t < seconds {
            t += self.cell_s(to);
            to += 1;
        }
        to
    }

    /// The same, with as many cells as a window has at least.
    fn after(&self, from: usize, seconds: f64) -> usize {
        self.after_exactly(from, seconds).max(from + 2 * FEWEST).min(self.grid.cells.len())
    }

    fn before(&self, to: usize, seconds: f64) -> usize {
        let (mut from, mut t) = (to, 0.0);
        while from > 0 && t < seconds {
            from -= 1;
            t += self.cell_s(from);
        }
        from.min(to.saturating_sub(3))
    }

    /// Solves a window until its phases hold every limit as far as they are kept.
    fn solve_window(
        &mut self,
        run: &Run<'_>,
        (from, to): (usize, usize),
        sides: [Side; 2],
        gap: f64,
    ) -> Option<()> {
        let count = self.grid.cells.len();
        self.begin_window((from, to), sides);
        for round in 0..=ROUNDS {
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
            // The cells after the kept ones count, too: so the next window has a law to its rest.
            let first = from + usize::from(sides[0] == Side::Fixed);
            // The stop of a window that others follow is not the last word.
            let is_stop = to < count || sides[1] == Side::Fixed;
            let last = if is_stop { to - 1 } else { count };
            if !self.take_back(run, from, (first, last), round) {
                self.coefficients[from..to].copy_from_slice(&self.window);
                self.solved = to;
                return Some(());
            }
            if round == ROUNDS {
                break;
            }
        }
        self.work.failed += 1;
        None
    }

    /// The law with which a window is begun.
    fn begin_window(&mut self, (from, to): (usize, usize), sides: [Side; 2]) {
        let n = to - from;
        self.window.clear();
        self.window.resize(n, 0.0);
        for (side, kept) in [(0, 0..2), (1, n - 2..n)] {
            if sides[side] == Side::Fixed {
                let given = &self.coefficients[from + kept.start..from + kept.end];
                self.window[kept].copy_from_slice(given);
            }
        }
        self.start.find(&self.grid, (from, to), sides, &mut self.window);
        // What the window before had beyond its kept part is a law already.
        if sides[0] == Side::Fixed && from + 2 < self.solved {
            let known = &self.coefficients[from + 2..self.solved];
            for (value, known) in self.window[2..].iter_mut().zip(known) {
                *value = value.max(*known);
            }
        }
    }

    /// Lowers what may be used where the phases use too much; whether they do.
    fn take_back(
        &mut self,
        run: &Run<'_>,
        from: usize,
        (first, last): (usize, usize),
        round: usize,
    ) -> bool {
        const MORE: f64 = 1.0015;
        const MORE_SPEED: f64 = 1.000_02;
        // What stays over is taken back more and more.
        let more = |used: f64| (used * MORE).powi(1 + round as i32 / 2);
        let mut over = false;
        let (mut speed, mut nodes) = (1.0 + ROUNDING, last..first);
        for cell in first..last {
            let used = self.grid.use_of(cell, &self.window, from, run);
            if used.velocity > 1.0 + ROUNDING {
                speed = speed.max(used.velocity);
                nodes = nodes.start.min(cell)..nodes.end.max(cell + 2);
            }
            let most = self.grid.cells[cell].most;
            if used.jerk > most * (1.0 - BETWEEN) {
                self.grid.cells[cell].share /= more(used.jerk / most);
                over = true;
            }
            if used.acceleration > 1.0 - BETWEEN {
                for node in [cell, cell + 1] {
                    self.grid.nodes[node].share /= more(used.acceleration);
                }
                over = true;
            }
        }
        if speed > 1.0 + ROUNDING {
            // Where a speed is held, what bulges out between two nodes moves on to the next ones.
            let inner = nodes.start.max(first + 2)..nodes.end.min(last - 1);
            let inner = self.grid.nodes.get_mut(inner).unwrap_or_default();
            inner.iter_mut().for_each(|node| node.cap /= (speed * MORE_SPEED).powi(2));
            over = true;
        }
        over
    }

    fn phases(&self, ends: [Ends; 2]) -> Vec<Phase> {
        let mut phases: Vec<Phase> = Vec::with_capacity(2 * self.grid.cells.len());
        let begin = usize::from(ends[0] != Ends::Rest);
        let end = self.grid.cells.len() - usize::from(ends[1] != Ends::Rest);
        let is_even = |phase: &Phase| phase.acceleration == 0.0 && phase.jerk == 0.0;
        for cell in begin..end {
            self.grid.phases(cell, &self.coefficients, 0, |phase| match phases.last_mut() {
                Some(last) if is_even(last) && is_even(&phase) && last.speed == phase.speed => {
                    last.duration_s += phase.duration_s;
                }
                _ => phases.push(phase),
            });
        }
        phases
    }
}

/// The law of a run to rest as phases, within `gap` of the least time, and what it took; without
/// phases where none was found within all limits.
pub fn law(run: &Run<'_>, gap: f64) -> (Option<Vec<Phase>>, Work) {
    let begin = if run.start_speed() > 0.0 { Ends::Even(run.start_speed()) } else { Ends::Rest };
    let mut planner = Planner::default();
    let phases = planner.plan(run, [begin, Ends::Rest], gap);
    (phases, planner.work)
}
