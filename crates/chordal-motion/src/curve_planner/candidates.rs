//! The quickest of some curves through the same chords.
//!
//! A curve within a tolerance is also within a larger one. So the lower values of a fixed ladder of tolerances
//! are candidates as well, and more tolerance is not slower. About how long a curve takes is known from the
//! first profile that the steps to the quickest one begin with: only of those that are near the least of these
//! times, of each kind of smoothing, the quickest profiles are solved.

use chordal_geometry::AXES;

use crate::curve_fit::{ChordPath, CurveSmoother, SmoothCurve, SmoothingKind, ToleranceMeasure};
use crate::limits::KinematicLimits;
use crate::piece::PathPiece;
use crate::profile_solver::{PreparedRun, ProfileSolver, RunEnding, SolverWork};
use crate::time_bound::{JerkReserve, PathRun};
use crate::trajectory::JerkPhase;
use crate::tuning::TUNING;

/// Steps in which the share of the speeds is looked for at which a short run is quickest.
const SPEED_SEARCH_FACTORS: [f64; 4] = [0.8, 1.05, 0.98, 1.005];

/// Finds the quickest curves, one after the other; keeps its memory.
#[derive(Debug, Default)]
pub(super) struct CandidateSearch {
    smoothing: CurveSmoother,
    divided: ChordPath,
    solver: ProfileSolver,
    candidates: Vec<CurveCandidate>,
    /// Memory of candidates.
    spare: Vec<CurveCandidate>,
}

/// A curve and its profile from rest to rest.
#[derive(Debug)]
pub(super) struct SolvedCurve {
    pub pieces: Vec<PathPiece>,
    pub phases: Vec<JerkPhase>,
    /// About the least time without jerk, s.
    pub least_s: f64,
    pub time_s: f64,
    /// The time at the feeds, with a start and a stop, s.
    pub at_feed_s: f64,
}

/// A curve, with the largest speed on each piece.
#[derive(Debug, Default)]
struct CurveCandidate {
    pieces: Vec<PathPiece>,
    speeds: Vec<f64>,
    prepared: PreparedRun,
    kind: Option<SmoothingKind>,
}

/// The least times of first profiles, of each kind.
#[derive(Clone, Copy, Debug)]
struct LeastFirstTimes([f64; SmoothingKind::ALL.len()]);

impl CandidateSearch {
    /// The quickest curve through some chords, if there is one. `make` makes pieces with their largest speeds,
    /// `run` takes them as a run.
    pub fn plan(
        &mut self,
        chords: &ChordPath,
        measure: &ToleranceMeasure,
        (limits, gap): (&KinematicLimits, f64),
        mut make: impl FnMut(&SmoothCurve<'_>, &mut Vec<PathPiece>, &mut Vec<f64>),
        run: impl for<'a> Fn(&'a [PathPiece], &'a [f64]) -> Option<PathRun<'a>>,
    ) -> Option<SolvedCurve> {
        self.spare.append(&mut self.candidates);
        let own = measure.linear_mm();
        let has_ladder = measure.has_linear();
        let lower = TUNING
            .curves
            .tolerance_ladder_mm
            .iter()
            .rev()
            .copied()
            .filter(|value| has_ladder && *value < own);
        let little = if chords.count() > TUNING.curves.long_run_chords {
            TUNING.curves.long_negligible_gain
        } else {
            TUNING.curves.negligible_gain
        };
        let (mut leasts, mut at_feed_s) = (LeastFirstTimes::NONE, f64::INFINITY);
        let mut best: Option<SolvedCurve> = None;
        for tolerance in std::iter::once(own).chain(lower) {
            let measure = measure.with_linear(tolerance);
            if !self.divided.divide(chords, measure.width_point_spacing()) {
                break;
            }
            let mut level_s = f64::INFINITY;
            for kind in SmoothingKind::ALL {
                let mut candidate = self.spare.pop().unwrap_or_default();
                candidate.clear();
                if let Some(smooth) = self.smoothing.smooth(&self.divided, &measure, kind) {
                    make(&smooth, &mut candidate.pieces, &mut candidate.speeds);
                }
                let mut prepared = std::mem::take(&mut candidate.prepared);
                let whole = run(&candidate.pieces, &candidate.speeds).filter(|run| {
                    self.solver.prepare_run(run, [RunEnding::Rest; 2], gap, &mut prepared)
                });
                let Some(whole) = whole else {
                    self.spare.push(candidate);
                    continue;
                };
                let is_first = prepared.first_s <= leasts.s().min(level_s);
                level_s = level_s.min(prepared.first_s);
                leasts.see(kind, prepared.first_s);
                at_feed_s = at_feed_s.min(candidate.at_feed_s(limits, whole.ends()));
                // A run that is at its feed nearly everywhere needs no other candidate.
                if is_first
                    && best.is_none()
                    && TUNING.curves.max_gain_share * (prepared.least_s - at_feed_s)
                        <= little * at_feed_s
                    && let Some(planned) = self.solve_prepared(&whole, gap, &prepared)
                {
                    let is_done = planned.is_near(at_feed_s, little);
                    let pieces = std::mem::take(&mut candidate.pieces);
                    best = Some(SolvedCurve { pieces, at_feed_s, ..planned });
                    if is_done {
                        return best;
                    }
                } else {
                    candidate.prepared = prepared;
                    candidate.kind = Some(kind);
                    self.keep(candidate);
                }
            }
            let far_s = window_s(TUNING.curves.ladder_stop_share, leasts.s(), at_feed_s, &best);
            if level_s > leasts.s() + far_s || level_s == f64::INFINITY {
                break;
            }
            self.drop_far(&leasts);
        }
        let [near_s, other_s] =
            leasts.shares().map(|share| window_s(share, leasts.s(), at_feed_s, &best));
        let is_near = |candidate: &CurveCandidate| leasts.has_near(candidate, near_s, other_s);
        let best = self.quickest_candidate(gap, is_near, best, run);
        best.map(|best| SolvedCurve { at_feed_s, ..best })
    }

    /// Keeps a candidate that is not one of those that are known already.
    fn keep(&mut self, candidate: CurveCandidate) {
        let is_known = |other: &CurveCandidate| {
            other.prepared.least_s == candidate.prepared.least_s
                && other.pieces.len() == candidate.pieces.len()
        };
        if self.candidates.iter().any(is_known) {
            self.spare.push(candidate);
        } else {
            self.candidates.push(candidate);
        }
    }

    /// Drops the candidates that others of their kind are far ahead of.
    fn drop_far(&mut self, leasts: &LeastFirstTimes) {
        let near_s = leasts.shares()[0] * leasts.s();
        let mut index = 0;
        while index < self.candidates.len() {
            if !leasts.has_near(&self.candidates[index], near_s, f64::INFINITY) {
                self.spare.push(self.candidates.swap_remove(index));
            } else {
                index += 1;
            }
        }
    }

    /// The quickest with its profile of the candidates that are near the least, and of the best that is known; where
    /// none of these has a profile, the first that has one.
    fn quickest_candidate(
        &mut self,
        gap: f64,
        is_near: impl Fn(&CurveCandidate) -> bool,
        mut best: Option<SolvedCurve>,
        run: impl for<'a> Fn(&'a [PathPiece], &'a [f64]) -> Option<PathRun<'a>>,
    ) -> Option<SolvedCurve> {
        let mut candidates = std::mem::take(&mut self.candidates);
        candidates.sort_by(|a, b| a.prepared.first_s.total_cmp(&b.prepared.first_s));
        for candidate in &mut candidates {
            if best.is_some() && !is_near(candidate) {
                continue;
            }
            let CurveCandidate { pieces, speeds, prepared, .. } = &*candidate;
            let Some(whole) = run(pieces, speeds) else { continue };
            let Some(planned) = self.solve_prepared(&whole, gap, prepared) else { continue };
            if best.as_ref().is_none_or(|best| planned.time_s < best.time_s) {
                let pieces = std::mem::take(&mut candidate.pieces);
                best = Some(SolvedCurve { pieces, ..planned });
            }
        }
        self.spare.append(&mut candidates);
        best
    }

    /// What all profiles took.
    pub fn work(&self) -> SolverWork {
        self.solver.work
    }

    /// The profile of a run, without its pieces.
    pub fn solve(&mut self, run: &PathRun<'_>, gap: f64) -> Option<SolvedCurve> {
        let phases = self.solver.plan(run, [RunEnding::Rest; 2], gap)?;
        Some(self.curved(phases))
    }

    /// The same of a run that was prepared.
    fn solve_prepared(
        &mut self,
        run: &PathRun<'_>,
        gap: f64,
        prepared: &PreparedRun,
    ) -> Option<SolvedCurve> {
        let phases = self.solver.plan_prepared(run, [RunEnding::Rest; 2], gap, prepared)?;
        Some(self.curved(phases))
    }

    fn curved(&self, phases: Vec<JerkPhase>) -> SolvedCurve {
        let time_s = phases.iter().map(|phase| phase.duration_s).sum();
        let least_s = self.solver.least_s();
        SolvedCurve { pieces: Vec::new(), phases, least_s, time_s, at_feed_s: time_s }
    }
}

impl LeastFirstTimes {
    const NONE: LeastFirstTimes = LeastFirstTimes([f64::INFINITY; SmoothingKind::ALL.len()]);

    fn see(&mut self, kind: SmoothingKind, first_s: f64) {
        let own = &mut self.0[kind as usize];
        *own = own.min(first_s);
    }

    /// The least of all.
    fn s(&self) -> f64 {
        self.0.iter().copied().fold(f64::INFINITY, f64::min)
    }

    /// How near the least of its kind the first profile of a candidate is, and that least the least of all.
    fn shares(&self) -> [f64; 2] {
        if self.s() > TUNING.curves.short_run_s {
            [TUNING.curves.kind_window, TUNING.curves.rival_window]
        } else {
            [TUNING.curves.short_kind_window, TUNING.curves.short_rival_window]
        }
    }

    /// Whether a candidate is near the least of its kind, and that is near the least of all.
    fn has_near(&self, candidate: &CurveCandidate, near_s: f64, other_s: f64) -> bool {
        let Some(kind) = candidate.kind else { return false };
        let own_s = self.0[kind as usize];
        candidate.prepared.first_s <= own_s + near_s && own_s <= self.s() + other_s
    }
}

impl SolvedCurve {
    /// Whether no curve can gain much of what it takes longer than at its feed.
    fn is_near(&self, at_feed_s: f64, little: f64) -> bool {
        TUNING.curves.max_gain_share * (self.time_s - at_feed_s) <= little * self.time_s
    }
}

/// A share of a time, but no more than of what a run is known to take longer than at its feed, s.
fn window_s(share: f64, least_s: f64, at_feed_s: f64, known: &Option<SolvedCurve>) -> f64 {
    let open_s = known.as_ref().map_or(f64::INFINITY, |known| known.time_s - at_feed_s);
    (share * least_s).min(TUNING.curves.max_gain_share * open_s)
}

impl CurveCandidate {
    fn clear(&mut self) {
        self.pieces.clear();
        self.speeds.clear();
    }

    /// The time at its speeds, with a start and a stop, s: little is quicker. Where the run is too short for them, at the
    /// share of them at which it is the least. Ends with a share of the jerk have no more of it on all of it.
    fn at_feed_s(&self, limits: &KinematicLimits, reserve: &[JerkReserve; 2]) -> f64 {
        let at_speed = self.pieces.iter().zip(&self.speeds);
        let at_speed_s: f64 = at_speed.map(|(piece, speed)| piece.length / speed).sum();
        let ends =
            [(self.pieces.first(), self.speeds.first()), (self.pieces.last(), self.speeds.last())];
        let time_s = |share: f64| {
            let lost = ends.into_iter().zip(reserve).map(|(end, reserve)| match end {
                (Some(piece), Some(speed)) => {
                    0.5 * ramp_s(piece, share * speed, limits, reserve.share)
                }
                _ => 0.0,
            });
            at_speed_s / share + lost.sum::<f64>()
        };
        let (mut share, mut least_s) = (1.0, time_s(1.0));
        for factor in SPEED_SEARCH_FACTORS {
            while factor * share <= 1.0 && time_s(factor * share) < least_s {
                share *= factor;
                least_s = time_s(share);
            }
        }
        least_s
    }
}

/// The time of a straight line from rest to a speed in the direction of a piece, s.
fn ramp_s(piece: &PathPiece, speed: f64, limits: &KinematicLimits, share: f64) -> f64 {
    let least = |limits: &[f64; AXES]| {
        let of = |axis: usize| limits[axis] / piece.start[1][axis].abs();
        (0..AXES).map(of).fold(f64::INFINITY, f64::min)
    };
    let (acceleration, jerk) = (least(&limits.acceleration()), share * least(&limits.jerk()));
    if speed * jerk > acceleration * acceleration {
        speed / acceleration + acceleration / jerk
    } else {
        2.0 * (speed / jerk).sqrt()
    }
}
