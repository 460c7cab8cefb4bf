//! The level "best": the reference as phases of even jerk that hold every limit.

use super::Law;
use super::excess::excess;
use super::plan::Plan;
use super::polish::polish;
use crate::bound::Run;
use crate::trajectory::Phase;

/// A law of time in phases.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Best {
    /// How long it takes, s.
    pub time_s: f64,
    /// Its phases; σ and its first two derivatives have no steps.
    pub phases: Vec<Phase>,
}

/// Phases at most; longer runs keep the law they have.
const MOST_PHASES: usize = 6000;
const LEAST_PHASES: usize = 150;
/// Linear programmes at most.
const PROGRAMS: usize = 8;
/// The iteration ends when a programme gains less than this share of the time.
const SETTLED: f64 = 1e-4;
/// By this much more than measured the time is stretched: peaks are found to about 1e-9.
const MARGIN: f64 = 1e-8;

/// The law as phases, stretched until every limit is held; `None` when that was not found.
pub fn best(run: &Run<'_>, law: &Law) -> Option<Best> {
    let phases = law.sigma.len().clamp(LEAST_PHASES, MOST_PHASES);
    let mut plan = Plan::of(law, phases);
    let mut best: Option<Best> = None;
    let mut reach = run.length() / 50.0;
    for _ in 0..PROGRAMS {
        let Ok(next) = polish(run, &plan, reach) else {
            reach *= 0.25;
            continue;
        };
        let next = next.exact(run);
        let stretch = excess(run, &next.phases()).stretch() * (1.0 + MARGIN);
        let time_s = next.duration_s() * stretch;
        println!("   polish {:.6} stretch {:.6} -> {:.6} back {}", next.duration_s(), stretch, time_s, next.goes_back());
        if next.goes_back() || !time_s.is_finite() {
            reach *= 0.25;
            continue;
        }
        let before = best.as_ref().map_or(f64::INFINITY, |best| best.time_s);
        if time_s >= before {
            reach *= 0.25;
            continue;
        }
        plan = next.stretched(stretch);
        best = Some(Best { time_s: plan.duration_s(), phases: plan.phases() });
        if before - time_s < SETTLED * time_s {
            break;
        }
    }
    best
}
