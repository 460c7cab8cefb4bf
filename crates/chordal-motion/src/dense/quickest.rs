//! The quickest of some curves through the same chords.
//!
//! A curve within a tolerance is also within a larger one. So the lower values of a fixed ladder of tolerances
//! are candidates as well, and more tolerance is not slower. About how long a curve takes is known from the
//! first law that the steps to the quickest one begin with: only of those that are near the least of these
//! times, of each way of smoothing, the quickest laws are made.

use chordal_geometry::AXES;

use super::LADDER;
use crate::bound::{Gentle, Run};
use crate::curve::{Chords, Measure, Smooth, Smoothing, SmoothingKind};
use crate::law::{Ends, Laid, Planner as LawPlanner, Work};
use crate::limits::Limits;
use crate::piece::Piece;
use crate::trajectory::Phase;

/// Curves of one way of smoothing whose first laws take longer than the least by a larger share are not the
/// quickest, nor are those of a way whose least is above the other's by a larger share.
const NEAR: f64 = 0.005;
const OTHER: f64 = 0.02;
/// The same of runs that take no longer, s: their laws take little.
const SHORT_S: f64 = 0.5;
const NEAR_IF_SHORT: f64 = 0.03;
const OTHER_IF_SHORT: f64 = 0.05;
/// Where the first laws of all curves of a value of the ladder take so much longer, those of lower values do so, too.
const FAR: f64 = 0.02;
/// Of what a run takes longer than at its feed another curve gains no more than about this share: a tenth where most
/// was seen to be gained. By no more do the estimates of such a run differ.
const GAIN: f64 = 0.2;
/// What cannot be gained by more than this share is not looked for, nor, in runs of many chords, by this one:
/// there every candidate takes long.
const LITTLE: f64 = 2e-4;
const LITTLE_OF_MANY: f64 = 4e-3;
const MANY: usize = 2000;
/// Steps in which the share of the speeds is looked for that a short way is quickest at.
const SLOWER: [f64; 4] = [0.8, 1.05, 0.98, 1.005];

/// Finds the quickest curves, one after the other; keeps its memory.
#[derive(Debug, Default)]
pub(super) struct Quickest {
    smoothing: Smoothing,
    divided: Chords,
    law: LawPlanner,
    found: Vec<Candidate>,
    /// Memory of candidates.
    spare: Vec<Candidate>,
}

/// A curve and its law from rest to rest.
#[derive(Debug)]
pub(super) struct Curved {
    pub pieces: Vec<Piece>,
    pub phases: Vec<Phase>,
    /// About the least time without jerk, s.
    pub least_s: f64,
    pub time_s: f64,
    /// The time at the feeds, with a start and a stop, s.
    pub at_feed_s: f64,
}

/// A curve, with the largest speed on each piece.
#[derive(Debug, Default)]
struct Candidate {
    pieces: Vec<Piece>,
    speeds: Vec<f64>,
    laid: Laid,
    way: Option<SmoothingKind>,
}

/// The least times of first laws, of each way.
#[derive(Clone, Copy, Debug)]
struct Leasts([f64; SmoothingKind::ALL.len()]);

impl Quickest {
    /// The quickest curve through some chords, if there is one. `lay` makes pieces with their largest speeds,
    /// `run` takes them as a run.
    pub fn plan(
        &mut self,
        chords: &Chords,
        measure: &Measure,
        (limits, gap): (&Limits, f64),
        mut lay: impl FnMut(&Smooth<'_>, &mut Vec<Piece>, &mut Vec<f64>),
        run: impl for<'a> Fn(&'a [Piece], &'a [f64]) -> Option<Run<'a>>,
    ) -> Option<Curved> {
        self.spare.append(&mut self.found);
        let own = measure.linear_mm();
        let has_ladder = measure.has_linear();
        let lower = LADDER.iter().rev().copied().filter(|value| has_ladder && *value < own);
        let little = if chords.count() > MANY { LITTLE_OF_MANY } else { LITTLE };
        let (mut leasts, mut at_feed_s) = (Leasts::NONE, f64::INFINITY);
        let mut best: Option<Curved> = None;
        for tolerance in std::iter::once(own).chain(lower) {
            let measure = measure.with_linear(tolerance);
            if !self.divided.divide(chords, measure.places_apart()) {
                break;
            }
            let mut level_s = f64::INFINITY;
            for way in SmoothingKind::ALL {
                let mut candidate = self.spare.pop().unwrap_or_default();
                candidate.clear();
                if let Some(smooth) = self.smoothing.smooth(&self.divided, &measure, way) {
                    lay(&smooth, &mut candidate.pieces, &mut candidate.speeds);
                }
                let mut laid = std::mem::take(&mut candidate.laid);
                let whole = run(&candidate.pieces, &candidate.speeds)
                    .filter(|run| self.law.lay_run(run, [Ends::Rest; 2], gap, &mut laid));
                let Some(whole) = whole else {
                    self.spare.push(candidate);
                    continue;
                };
                let is_first = laid.first_s <= leasts.s().min(level_s);
                level_s = level_s.min(laid.first_s);
                leasts.see(way, laid.first_s);
                at_feed_s = at_feed_s.min(candidate.at_feed_s(limits, whole.ends()));
                // A run that is at its feed nearly everywhere needs no other candidate.
                if is_first
                    && best.is_none()
                    && GAIN * (laid.least_s - at_feed_s) <= little * at_feed_s
                    && let Some(planned) = self.solve_laid(&whole, gap, &laid)
                {
                    let is_done = planned.is_near(at_feed_s, little);
                    let pieces = std::mem::take(&mut candidate.pieces);
                    best = Some(Curved { pieces, at_feed_s, ..planned });
                    if is_done {
                        return best;
                    }
                } else {
                    candidate.laid = laid;
                    candidate.way = Some(way);
                    self.keep(candidate);
                }
            }
            let far_s = window_s(FAR, leasts.s(), at_feed_s, &best);
            if level_s > leasts.s() + far_s || level_s == f64::INFINITY {
                break;
            }
            self.drop_far(&leasts);
        }
        let [near_s, other_s] =
            leasts.shares().map(|share| window_s(share, leasts.s(), at_feed_s, &best));
        let is_near = |candidate: &Candidate| leasts.has_near(candidate, near_s, other_s);
        let best = self.quickest_of_found(gap, is_near, best, run);
        best.map(|best| Curved { at_feed_s, ..best })
    }

    /// Keeps a candidate that is not one of those that are known already.
    fn keep(&mut self, candidate: Candidate) {
        let is_known = |other: &Candidate| {
            other.laid.least_s == candidate.laid.least_s
                && other.pieces.len() == candidate.pieces.len()
        };
        if self.found.iter().any(is_known) {
            self.spare.push(candidate);
        } else {
            self.found.push(candidate);
        }
    }

    /// Drops the candidates that others of their way are far ahead of.
    fn drop_far(&mut self, leasts: &Leasts) {
        let near_s = leasts.shares()[0] * leasts.s();
        let mut index = 0;
        while index < self.found.len() {
            if !leasts.has_near(&self.found[index], near_s, f64::INFINITY) {
                self.spare.push(self.found.swap_remove(index));
            } else {
                index += 1;
            }
        }
    }

    /// The quickest with its law of the candidates that are near the least, and of the best that is known; where
    /// none of these has a law, the first that has one.
    fn quickest_of_found(
        &mut self,
        gap: f64,
        is_near: impl Fn(&Candidate) -> bool,
        mut best: Option<Curved>,
        run: impl for<'a> Fn(&'a [Piece], &'a [f64]) -> Option<Run<'a>>,
    ) -> Option<Curved> {
        let mut found = std::mem::take(&mut self.found);
        found.sort_by(|a, b| a.laid.first_s.total_cmp(&b.laid.first_s));
        for candidate in &mut found {
            if best.is_some() && !is_near(candidate) {
                continue;
            }
            let Candidate { pieces, speeds, laid, .. } = &*candidate;
            let Some(whole) = run(pieces, speeds) else { continue };
            let Some(planned) = self.solve_laid(&whole, gap, laid) else { continue };
            if best.as_ref().is_none_or(|best| planned.time_s < best.time_s) {
                let pieces = std::mem::take(&mut candidate.pieces);
                best = Some(Curved { pieces, ..planned });
            }
        }
        self.spare.append(&mut found);
        best
    }

    /// What all laws took.
    pub fn work(&self) -> Work {
        self.law.work
    }

    /// The law of a run, without its pieces.
    pub fn solve(&mut self, run: &Run<'_>, gap: f64) -> Option<Curved> {
        let phases = self.law.plan(run, [Ends::Rest; 2], gap)?;
        Some(self.curved(phases))
    }

    /// The same of a run that was laid.
    fn solve_laid(&mut self, run: &Run<'_>, gap: f64, laid: &Laid) -> Option<Curved> {
        let phases = self.law.plan_laid(run, [Ends::Rest; 2], gap, laid)?;
        Some(self.curved(phases))
    }

    fn curved(&self, phases: Vec<Phase>) -> Curved {
        let time_s = phases.iter().map(|phase| phase.duration_s).sum();
        let least_s = self.law.least_s();
        Curved { pieces: Vec::new(), phases, least_s, time_s, at_feed_s: time_s }
    }
}

impl Leasts {
    const NONE: Leasts = Leasts([f64::INFINITY; SmoothingKind::ALL.len()]);

    fn see(&mut self, way: SmoothingKind, first_s: f64) {
        let own = &mut self.0[way as usize];
        *own = own.min(first_s);
    }

    /// The least of all.
    fn s(&self) -> f64 {
        self.0.iter().copied().fold(f64::INFINITY, f64::min)
    }

    /// How near the least of its way the first law of a candidate is, and that least the least of all.
    fn shares(&self) -> [f64; 2] {
        if self.s() > SHORT_S { [NEAR, OTHER] } else { [NEAR_IF_SHORT, OTHER_IF_SHORT] }
    }

    /// Whether a candidate is near the least of its way, and that is near the least of all.
    fn has_near(&self, candidate: &Candidate, near_s: f64, other_s: f64) -> bool {
        let Some(way) = candidate.way else { return false };
        let own_s = self.0[way as usize];
        candidate.laid.first_s <= own_s + near_s && own_s <= self.s() + other_s
    }
}

impl Curved {
    /// Whether no curve can gain much of what it takes longer than at its feed.
    fn is_near(&self, at_feed_s: f64, little: f64) -> bool {
        GAIN * (self.time_s - at_feed_s) <= little * self.time_s
    }
}

/// A share of a time, but no more than of what a run is known to take longer than at its feed, s.
fn window_s(share: f64, least_s: f64, at_feed_s: f64, known: &Option<Curved>) -> f64 {
    let open_s = known.as_ref().map_or(f64::INFINITY, |known| known.time_s - at_feed_s);
    (share * least_s).min(GAIN * open_s)
}

impl Candidate {
    fn clear(&mut self) {
        self.pieces.clear();
        self.speeds.clear();
    }

    /// The time at its speeds, with a start and a stop, s: little is quicker. Where the way is too short for them, at the
    /// share of them at which it is the least. Ends with a share of the jerk have no more of it on all of the way.
    fn at_feed_s(&self, limits: &Limits, gentle: &[Gentle; 2]) -> f64 {
        let at_speed = self.pieces.iter().zip(&self.speeds);
        let at_speed_s: f64 = at_speed.map(|(piece, speed)| piece.length / speed).sum();
        let ends =
            [(self.pieces.first(), self.speeds.first()), (self.pieces.last(), self.speeds.last())];
        let time_s = |share: f64| {
            let lost = ends.into_iter().zip(gentle).map(|(end, gentle)| match end {
                (Some(piece), Some(speed)) => {
                    0.5 * ramp_s(piece, share * speed, limits, gentle.share)
                }
                _ => 0.0,
            });
            at_speed_s / share + lost.sum::<f64>()
        };
        let (mut share, mut least_s) = (1.0, time_s(1.0));
        for factor in SLOWER {
            while factor * share <= 1.0 && time_s(factor * share) < least_s {
                share *= factor;
                least_s = time_s(share);
            }
        }
        least_s
    }
}

/// The time of a straight way from rest to a speed in the direction of a piece, s.
fn ramp_s(piece: &Piece, speed: f64, limits: &Limits, share: f64) -> f64 {
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
