//! The velocity profile along a run: as quick as velocity, acceleration and jerk of every axis allow
//! together.
//!
//! | pass | file |
//! |---|---|
//! | where it goes at one speed, with nothing to solve | `cruise.rs` |
//! | what lies between in intervals, and a first profile without jerk along the path | `grid.rs` |
//! | a first profile of a window, with jerk along the path | `initial_guess.rs` |
//! | the quickest profile on a window of intervals | `newton/` |
//! | phases of even jerk, and what they use | `phases.rs` |
//!
//! What is long is solved in windows. Each ends at rest; what lies so far before its end that the
//! rest cannot reach it is kept, and the next window goes on from there.

mod cruise;
mod grid;
mod initial_guess;
mod newton;
mod phases;

use std::ops::Range;

use chordal_geometry::AXES;

use crate::piece::PathPiece;
use crate::time_bound::{JerkReserve, PathRun};
use crate::trajectory::JerkPhase;
use cruise::CruisePart;
use grid::{GridCut, GridNode, ProfileGrid};
use initial_guess::InitialGuess;
use newton::NewtonSolver;

/// How a run begins or ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum RunEnding {
    /// At rest.
    Rest,
    /// At this speed, without acceleration.
    Even(f64),
}

/// How a window begins or ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum WindowSide {
    /// At rest.
    Rest,
    /// With two coefficients that are known.
    Fixed,
}

/// Where a window begins, and where the one before it did.
#[derive(Clone, Copy, Debug)]
struct WindowStart {
    from: usize,
    side: WindowSide,
    before: Option<(usize, WindowSide)>,
}

/// A profile nearer the least time than this needs smaller intervals, down to this share of the usual length.
const USUAL_GAP_SHARE: f64 = 2e-4;
const MIN_INTERVAL_SCALE: f64 = 0.25;
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
/// Intervals of a run that may be solved in vain, for cruises that are not reached. Then the run has no profile.
const MAX_WASTED_INTERVALS: usize = 40_000;
/// Intervals of a window at least.
const MIN_WINDOW_INTERVALS: usize = 8;

/// The work of a solver so far.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct SolverWork {
    /// Intervals of all runs.
    pub intervals: u64,
    /// Solutions of windows; a window may be solved several times.
    pub windows: u64,
    /// Windows without a solution.
    pub failed: u64,
    /// Iterations times intervals.
    pub steps: u64,
}

/// Finds profiles, one after the other; keeps its memory.
#[derive(Debug, Default)]
pub(crate) struct ProfileSolver {
    grid: ProfileGrid,
    start: InitialGuess,
    newton: NewtonSolver,
    coefficients: Vec<f64>,
    window: Vec<f64>,
    /// So many coefficients have been solved, if not all of them for good.
    solved: usize,
    cruises: Vec<CruisePart>,
    parts: Vec<SolvedPart>,
    /// The path of a part.
    pieces: Vec<PathPiece>,
    speeds: Vec<f64>,
    /// About the least time of the last run without jerk along the path, s.
    least_s: f64,
    /// Where the last window without an answer began, σ.
    failed_at: f64,
    pub work: SolverWork,
}

/// What is known of a run whose profile is not solved yet.
#[derive(Clone, Debug, Default)]
pub(crate) struct PreparedRun {
    /// About the least time without jerk along the path, s.
    pub least_s: f64,
    /// The time of the first profile, s.
    pub first_s: f64,
    cruises: Vec<CruisePart>,
    /// Where its intervals begin, if there are no cruises.
    cuts: Vec<GridCut>,
}

/// A part of a run that has its profile.
#[derive(Debug)]
struct SolvedPart {
    phases: Vec<JerkPhase>,
    /// About the least time without jerk along the path, s.
    least_s: f64,
}

impl ProfileSolver {
    /// The profile of a run as phases; `None` where none was found within all limits.
    pub fn plan(
        &mut self,
        run: &PathRun<'_>,
        ends: [RunEnding; 2],
        gap: f64,
    ) -> Option<Vec<JerkPhase>> {
        cruise::find(run, &mut self.cruises);
        self.plan_around_cruises(run, ends, gap, None)
    }

    /// The same of a run that was prepared.
    pub fn plan_prepared(
        &mut self,
        run: &PathRun<'_>,
        ends: [RunEnding; 2],
        gap: f64,
        prepared: &PreparedRun,
    ) -> Option<Vec<JerkPhase>> {
        self.cruises.clone_from(&prepared.cruises);
        self.plan_around_cruises(run, ends, gap, Some(prepared))
    }

    fn plan_around_cruises(
        &mut self,
        run: &PathRun<'_>,
        ends: [RunEnding; 2],
        gap: f64,
        prepared: Option<&PreparedRun>,
    ) -> Option<Vec<JerkPhase>> {
        let mut parts = std::mem::take(&mut self.parts);
        parts.clear();
        let solved = match prepared.filter(|prepared| prepared.cruises.is_empty()) {
            Some(prepared) => {
                self.grid.rebuild(run, ends, &prepared.cuts);
                self.solve_part(run, ends, gap, prepared.least_s).map(|part| parts.push(part))
            }
            None => self.plan_parts(run, ends, gap, &mut parts),
        };
        let phases = solved.map(|()| self.join(&mut parts));
        self.parts = parts;
        phases
    }

    /// Prepares a run, without its profile: what is known of it, then; false where it has too many intervals.
    pub fn prepare_run(
        &mut self,
        run: &PathRun<'_>,
        ends: [RunEnding; 2],
        gap: f64,
        prepared: &mut PreparedRun,
    ) -> bool {
        cruise::find(run, &mut self.cruises);
        prepared.cruises.clone_from(&self.cruises);
        prepared.cuts.clear();
        prepared.least_s = 0.0;
        if self.cruises.is_empty() {
            let Some(least_s) = self.prepare(run, ends, gap) else { return false };
            prepared.least_s = least_s;
            prepared.first_s = self.first_s(ends);
            prepared.cuts.extend_from_slice(self.grid.cuts());
            return true;
        }
        let cruises = self.cruises.iter();
        prepared.least_s = cruises.map(|cruise| (cruise.to - cruise.from) / cruise.speed).sum();
        prepared.first_s = prepared.least_s;
        for index in 0..=self.cruises.len() {
            let own = self.between(run, ends, index, |planner, part, ends| {
                let least_s = planner.prepare(part, ends, gap)?;
                Some([least_s, planner.first_s(ends)])
            });
            let Some([least_s, first_s]) = own else { return false };
            prepared.least_s += least_s;
            prepared.first_s += first_s;
        }
        true
    }

    /// Prepares a run, or a part of it, in intervals: about its least time without jerk along the path, s.
    fn prepare(&mut self, run: &PathRun<'_>, ends: [RunEnding; 2], gap: f64) -> Option<f64> {
        self.failed_at = f64::NAN;
        let is_built =
            self.grid.build(run, ends, (gap / USUAL_GAP_SHARE).clamp(MIN_INTERVAL_SCALE, 1.0));
        is_built.then(|| self.own_intervals(ends).map(|interval| self.interval_s(interval)).sum())
    }

    /// The time of the first profile of what was prepared last, as one window, s.
    fn first_s(&mut self, ends: [RunEnding; 2]) -> f64 {
        let count = self.grid.intervals.len();
        self.window.clear();
        self.window.resize(count, 0.0);
        for (end, fixed) in ends.iter().zip([0..2, count - 2..count]) {
            if let RunEnding::Even(speed) = end {
                self.window[fixed].fill(speed * speed);
            }
        }
        let sides = ends
            .map(|end| if end == RunEnding::Rest { WindowSide::Rest } else { WindowSide::Fixed });
        self.start.find(&self.grid, (0, count), sides, &mut self.window);
        let length = |interval: usize| self.grid.intervals[interval].length;
        let speed = |node: usize| {
            let (before, after) = (length(node - 1), length(node));
            let [one, two] = [self.window[node - 1], self.window[node]];
            ((one * after + two * before) / (before + after)).sqrt()
        };
        let inner = (1..count - 1)
            .map(|interval| 2.0 * length(interval) / (speed(interval) + speed(interval + 1)));
        let mut time_s: f64 = inner.sum();
        if ends[0] == RunEnding::Rest {
            time_s += 3.0 * length(0) / speed(1);
        }
        if ends[1] == RunEnding::Rest {
            time_s += 3.0 * length(count - 1) / speed(count - 1);
        }
        time_s
    }

    /// The intervals of what was prepared last that are its own, and not before or after it.
    fn own_intervals(&self, ends: [RunEnding; 2]) -> Range<usize> {
        let begin = usize::from(ends[0] != RunEnding::Rest);
        begin..self.grid.intervals.len() - usize::from(ends[1] != RunEnding::Rest)
    }

    /// The profiles of what lies around the cruises.
    fn plan_parts(
        &mut self,
        run: &PathRun<'_>,
        ends: [RunEnding; 2],
        gap: f64,
        parts: &mut Vec<SolvedPart>,
    ) -> Option<()> {
        let (mut in_vain, mut failed_at) = (0, f64::NAN);
        while parts.len() <= self.cruises.len() {
            let index = parts.len();
            let part = if self.cruises.is_empty() {
                self.plan_part(run, ends, gap)
            } else {
                self.plan_between(run, ends, gap, index)
            };
            match part {
                Some(part) => parts.push(part),
                None if self.cruises.is_empty() || in_vain > MAX_WASTED_INTERVALS => return None,
                // A cruise that is not reached in time is no ground to have no profile.
                None => {
                    // What was joined at its end is not why it fails where it did before.
                    if index == 0 && self.failed_at == failed_at {
                        return None;
                    }
                    failed_at = if index == 0 { self.failed_at } else { f64::NAN };
                    in_vain += self.grid.intervals.len();
                    self.cruises
                        .drain(index.saturating_sub(1)..(index + 1).min(self.cruises.len()));
                    parts.truncate(index.saturating_sub(1));
                }
            }
        }
        Some(())
    }

    /// The profile of what lies between two cruises, or between one and an end of the run.
    fn plan_between(
        &mut self,
        run: &PathRun<'_>,
        ends: [RunEnding; 2],
        gap: f64,
        index: usize,
    ) -> Option<SolvedPart> {
        let from = index.checked_sub(1).map_or(0.0, |before| self.cruises[before].to);
        let mut part = self
            .between(run, ends, index, |planner, part, ends| planner.plan_part(part, ends, gap))?;
        part.phases.iter_mut().for_each(|phase| phase.from += from);
        Some(part)
    }

    /// What `of` makes of the path between two cruises, or between one and an end of the run.
    fn between<T>(
        &mut self,
        run: &PathRun<'_>,
        ends: [RunEnding; 2],
        index: usize,
        of: impl FnOnce(&mut ProfileSolver, &PathRun<'_>, [RunEnding; 2]) -> Option<T>,
    ) -> Option<T> {
        let before = index.checked_sub(1).map(|before| self.cruises[before]);
        let after = self.cruises.get(index).copied();
        let even = |cruise: CruisePart| (RunEnding::Even(cruise.speed), JerkReserve::NONE);
        let own = |side: usize| (ends[side], run.ends()[side]);
        let (begins, first) = before.map_or_else(|| own(0), even);
        let (stops, last) = after.map_or_else(|| own(1), even);
        let from = before.map_or(0.0, |cruise| cruise.to);
        let to = after.map_or(run.length(), |cruise| cruise.from);
        let (mut pieces, mut speeds) =
            (std::mem::take(&mut self.pieces), std::mem::take(&mut self.speeds));
        cruise::cut(run, from..to, &mut pieces, &mut speeds);
        let part = PathRun::new(&pieces, &speeds, 0.0, run.limits()).ok();
        let part = part.map(|part| part.with_ends([first, last]));
        let solved = part.and_then(|part| of(self, &part, [begins, stops]));
        (self.pieces, self.speeds) = (pieces, speeds);
        solved
    }

    /// The profiles of all parts with the cruises between them.
    fn join(&mut self, parts: &mut Vec<SolvedPart>) -> Vec<JerkPhase> {
        self.least_s = parts.iter().map(|part| part.least_s).sum();
        let count: usize = parts.iter().map(|part| part.phases.len() + 1).sum();
        let mut parts = parts.drain(..).map(|part| part.phases);
        let mut phases = parts.next().unwrap_or_default();
        phases.reserve_exact(count - phases.len());
        for (cruise, part) in self.cruises.iter().zip(parts) {
            let CruisePart { from, to, speed } = *cruise;
            let duration_s = (to - from) / speed;
            self.least_s += duration_s;
            let even = JerkPhase { duration_s, from, speed, acceleration: 0.0, jerk: 0.0 };
            std::iter::once(even).chain(part).for_each(|phase| add(&mut phases, phase));
        }
        phases
    }

    /// The profile of a run, or of a part of it, that has no cruise.
    fn plan_part(
        &mut self,
        run: &PathRun<'_>,
        ends: [RunEnding; 2],
        gap: f64,
    ) -> Option<SolvedPart> {
        let least_s = self.prepare(run, ends, gap)?;
        self.solve_part(run, ends, gap, least_s)
    }

    /// The profile of a part that was prepared.
    fn solve_part(
        &mut self,
        run: &PathRun<'_>,
        ends: [RunEnding; 2],
        gap: f64,
        least_s: f64,
    ) -> Option<SolvedPart> {
        self.work.intervals += self.grid.intervals.len() as u64;
        let look_s = self.look_s();
        self.solve(run, ends, look_s, gap)?;
        Some(SolvedPart { phases: self.phases(self.own_intervals(ends)), least_s })
    }

    /// Solves for all coefficients, window by window.
    fn solve(
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
    fn look_s(&self) -> f64 {
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

    /// About the least time of the last run without jerk along the path, s.
    pub fn least_s(&self) -> f64 {
        self.least_s
    }

    fn interval_s(&self, interval: usize) -> f64 {
        self.grid.intervals[interval].length / self.grid.bound[interval].sqrt().max(1e-9)
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

    fn phases(&self, intervals: Range<usize>) -> Vec<JerkPhase> {
        let mut phases: Vec<JerkPhase> = Vec::with_capacity(2 * intervals.len());
        for interval in intervals {
            self.grid.phases(interval, &self.coefficients, 0, |phase| add(&mut phases, phase));
        }
        phases
    }
}

/// Adds a phase; one that goes on at an even speed makes the last one longer.
fn add(phases: &mut Vec<JerkPhase>, phase: JerkPhase) {
    let is_even = |phase: &JerkPhase| phase.acceleration == 0.0 && phase.jerk == 0.0;
    match phases.last_mut() {
        Some(last) if is_even(last) && is_even(&phase) && last.speed == phase.speed => {
            last.duration_s += phase.duration_s;
        }
        _ => phases.push(phase),
    }
}

/// The profile of a run to rest as phases, within `gap` of the least time, and what it took; without
/// phases where none was found within all limits.
pub fn solve_profile(run: &PathRun<'_>, gap: f64) -> (Option<Vec<JerkPhase>>, SolverWork) {
    let begin =
        if run.start_speed() > 0.0 { RunEnding::Even(run.start_speed()) } else { RunEnding::Rest };
    let mut planner = ProfileSolver::default();
    let phases = planner.plan(run, [begin, RunEnding::Rest], gap);
    (phases, planner.work)
}
