//! The velocity profile along a run: as quick as velocity, acceleration and jerk of every axis allow
//! together.
//!
//! | pass | file |
//! |---|---|
//! | where it goes at one speed, with nothing to solve | `cruise.rs` |
//! | what lies between in intervals, and a first profile without jerk along the path | `grid.rs` |
//! | a first profile of a window, with jerk along the path | `initial_guess.rs` |
//! | one window after the other, each solved until it holds every limit | `windows.rs` |
//! | the quickest profile on a window of intervals | `newton/` |
//! | phases of even jerk, and what they use | `phases.rs` |

mod cruise;
mod grid;
mod initial_guess;
mod newton;
mod phases;
mod windows;

use std::ops::Range;

use crate::piece::PathPiece;
use crate::time_bound::{JerkReserve, PathRun};
use crate::trajectory::JerkPhase;
use cruise::CruisePart;
use grid::{GridCut, ProfileGrid};
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

/// A profile nearer the least time than this needs smaller intervals, down to this share of the usual length.
const USUAL_GAP_SHARE: f64 = 2e-4;
const MIN_INTERVAL_SCALE: f64 = 0.25;
/// Intervals of a run that may be solved in vain, for cruises that are not reached. Then the run has no profile.
const MAX_WASTED_INTERVALS: usize = 40_000;

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

    /// About the least time of the last run without jerk along the path, s.
    pub fn least_s(&self) -> f64 {
        self.least_s
    }

    fn interval_s(&self, interval: usize) -> f64 {
        self.grid.intervals[interval].length / self.grid.bound[interval].sqrt().max(1e-9)
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
