//! The level "best": the reference as phases of even jerk that hold every limit.

use super::Law;
use super::excess::excess;
use super::plan::Plan;
use super::polish::polish;
use crate::bound::Run;
use crate::trajectory::Phase;

/// A velocity profile in phases.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Best {
    /// How long it takes, s.
    pub time_s: f64,
    /// Its phases; σ and its first two derivatives have no steps.
    pub phases: Vec<Phase>,
}

impl Best {
    /// This law, or the given one where that is quicker.
    #[must_use]
    pub fn or(self, given: &[Phase]) -> Best {
        let time_s: f64 = given.iter().map(|phase| phase.duration_s).sum();
        if time_s <= self.time_s { Best { time_s, phases: given.to_vec() } } else { self }
    }
}

/// Phases at most; longer runs keep the law they have.
const MOST_PHASES: usize = 6000;
/// Linear programs at most.
const PROGRAMS: usize = 16;
/// The iteration ends when a program gains less than this share of the time.
const SETTLED: f64 = 1e-4;
/// By which share speeds may change at a time at first.
const REACH: f64 = 0.5;
/// How it changes after a law that is no better, and after one that is.
const SHRINK: f64 = 0.4;
const GROW: f64 = 1.5;
/// By this much more than measured the time is stretched: peaks are found to about 1e-9.
const MARGIN: f64 = 1e-8;

/// The law as phases, stretched until every limit is held; `None` when that was not found, the
/// run does not begin at rest (it cannot be stretched) or is too long for one program.
///
/// Phases end where pieces do, as far as the pieces there differ: a jerk of the axes that steps
/// with the path is answered by a step of the jerk along it.
pub fn best(run: &Run<'_>, law: &Law) -> Option<Best> {
    if law.sigma.len() > MOST_PHASES || run.start_speed() > 0.0 {
        return None;
    }
    let mut plan = Plan::of(law)?;
    let mut best: Option<Best> = None;
    let mut reach = REACH;
    for _ in 0..PROGRAMS {
        let Some((next, stretch)) = improved(run, &plan, reach) else {
            reach *= SHRINK;
            continue;
        };
        let before = best.as_ref().map_or(f64::INFINITY, |best| best.time_s);
        let time_s = next.duration_s() * stretch;
        if time_s < before {
            plan = next.stretched(stretch);
            reach = REACH.min(reach * GROW);
            best = Some(Best { time_s: plan.duration_s(), phases: plan.phases() });
        } else {
            reach *= SHRINK;
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
