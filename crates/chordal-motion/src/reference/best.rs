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
/// Linear programmes at most.
const PROGRAMS: usize = 8;
/// The iteration ends when a programme gains less than this share of the time.
const SETTLED: f64 = 1e-4;
const DEBUG: bool = true;
/// By which share speeds may change at a time at first.
const REACH: f64 = 0.5;
/// By this much more than measured the time is stretched: peaks are found to about 1e-9.
const MARGIN: f64 = 1e-8;

/// The law as phases, stretched until every limit is held; `None` when that was not found.
pub fn best(run: &Run<'_>, law: &Law) -> Option<Best> {
    if law.sigma.len() > MOST_PHASES {
        return None;
    }
    let mut plan = Plan::of(law)?;
    let mut best: Option<Best> = None;
    let mut reach = REACH;
    for _ in 0..PROGRAMS {
        let Some((next, stretch)) = improved(run, &plan, reach) else {
            reach *= 0.25;
            continue;
        };
        if DEBUG {
            eprintln!(
                "   {:?} step {} {:?}",
                next.duration_s(),
                stretch,
                excess(run, &next.phases())
            );
        }
        let before = best.as_ref().map_or(f64::INFINITY, |best| best.time_s);
        let time_s = next.duration_s() * stretch;
        if time_s < before {
            plan = next.stretched(stretch);
            best = Some(Best { time_s: plan.duration_s(), phases: plan.phases() });
        } else {
            reach *= 0.25;
        }
        if (before - time_s).abs() < SETTLED * time_s {
            break;
        }
    }
    best
}

/// A better law and by how much it must be stretched.
fn improved(run: &Run<'_>, plan: &Plan, reach: f64) -> Option<(Plan, f64)> {
    let next = polish(run, plan, reach).ok()?.exact()?;
    if next.goes_back() {
        return None;
    }
    let stretch = excess(run, &next.phases()).stretch() * (1.0 + MARGIN);
    stretch.is_finite().then_some((next, stretch))
}
