//! Which share of its programmed feed each block may have.

use std::collections::{BTreeMap, HashMap};

use chordal::Job;
use chordal::diagnostics::FileId;
use chordal::stock::{EngagementReport, MoveEngagement};

use super::OptimizeOptions;

/// Feeds change by whole steps of this ratio, down to the next one: many small changes cost more than they give.
const STEP: f64 = 1.05;
/// A feed goes up only over blocks that take so long at the feed before, s.
const STEADY: f64 = 0.5;
/// No feed becomes less than this share of the programmed one.
const FLOOR: f64 = 0.05;
/// A share so near a step is on it.
const ON_STEP: f64 = 1e-9;

/// What shares depend on.
pub(super) struct ShareInputs<'a> {
    moves: &'a [MoveEngagement],
    /// The thickest chip of each tool, mm.
    limits: &'a BTreeMap<u32, f64>,
    /// The largest share.
    faster: f64,
    /// The most power of each tool, kW.
    power: BTreeMap<u32, f64>,
    /// Power grows with the feed to the power of 1 less this.
    exponent: f64,
    /// The machine's largest feed, mm/s.
    feed_max: Option<f64>,
}

/// The most power that a tool may take: the spindle's, or without that what the tool takes in the program itself.
fn power(found: &EngagementReport) -> BTreeMap<u32, f64> {
    let of = |own: f64| found.spindle_kw.unwrap_or(own);
    let tools = found.tools.iter();
    tools.filter_map(|tool| Some((tool.number, of(tool.power_kw?.peak)))).collect()
}

/// A visit of a block: moves of one block that follow each other.
#[derive(Clone, Copy, Debug)]
struct BlockVisit {
    block: Option<u32>,
    share: f64,
    /// How long it takes at its programmed feed, s.
    seconds: f64,
    tool: u32,
}

impl<'a> ShareInputs<'a> {
    pub fn new(
        job: &Job,
        before: &'a EngagementReport,
        limits: &'a BTreeMap<u32, f64>,
        options: &OptimizeOptions,
    ) -> ShareInputs<'a> {
        ShareInputs {
            moves: &before.moves,
            limits,
            faster: options.faster.max(1.0),
            power: power(before),
            exponent: before.material.as_ref().map_or(0.0, |material| material.m_c),
            feed_max: job.machine().feed.max_mm_per_s,
        }
    }

    /// Blocks of the first text whose feed may be changed, by the byte that they begin at, with the share that each
    /// may have.
    pub fn by_block(&self) -> HashMap<u32, f64> {
        let mut visits = self.visits();
        // The same feed for each time that a block runs.
        even(&mut visits);
        steady(&mut visits);
        even(&mut visits);
        let known = visits.iter().filter_map(|visit| Some((visit.block?, visit.share)));
        known.collect()
    }

    fn visits(&self) -> Vec<BlockVisit> {
        let mut visits: Vec<BlockVisit> = Vec::new();
        let mut last = None;
        for each in self.moves {
            let changeable = self.is_changeable(each);
            let share = if changeable { self.share(each) } else { 1.0 };
            match visits.last_mut().filter(|_| last == Some(each.origin)) {
                Some(visit) => {
                    visit.share = visit.share.min(share);
                    visit.seconds += each.seconds();
                    if !changeable {
                        visit.block = None;
                    }
                }
                None => visits.push(BlockVisit {
                    block: changeable.then_some(each.origin.span.range.start),
                    share,
                    seconds: each.seconds(),
                    tool: each.tool,
                }),
            }
            last = Some(each.origin);
        }
        visits
    }

    /// The feed of a move may be another one.
    pub fn is_changeable(&self, each: &MoveEngagement) -> bool {
        let is_own = each.by_time && each.origin.span.file == FileId(0);
        is_own && each.feed_mm_per_s > 0.0 && self.limits.contains_key(&each.tool)
    }

    /// The share that a move may have: a step, or 1.
    pub fn share(&self, each: &MoveEngagement) -> f64 {
        // How fast an end mill may go down is no question of its chip: centre, coolant and chips decide it.
        let mut most = if each.falls { 1.0 } else { self.faster };
        if let (Some(chip), Some(limit)) = (each.chip, self.limits.get(&each.tool)) {
            most = most.min(limit / chip.peak_mm.most);
        }
        if let (Some(effort), Some(limit)) = (each.effort, self.power.get(&each.tool))
            && effort.power_kw > 0.0
        {
            // A pass that takes the most already may stay.
            let share = libm::pow(limit / effort.power_kw, 1.0 / (1.0 - self.exponent));
            most = most.min(share);
        }
        if let Some(limit) = self.feed_max {
            // A faster feed than that is reported by the check; it is not changed for it.
            most = most.min((limit / each.feed_mm_per_s).max(1.0));
        }
        step_below(most.max(FLOOR))
    }
}

/// The step at or below a share.
fn step_below(share: f64) -> f64 {
    let steps = (libm::log(share) / libm::log(STEP) + ON_STEP).floor();
    if steps == 0.0 { 1.0 } else { libm::pow(STEP, steps) }
}

/// Gives every visit of a block its least share.
fn even(visits: &mut [BlockVisit]) {
    let mut least: HashMap<u32, f64> = HashMap::new();
    for visit in visits.iter() {
        if let Some(block) = visit.block {
            let entry = least.entry(block).or_insert(visit.share);
            *entry = entry.min(visit.share);
        }
    }
    for visit in visits {
        if let Some(block) = visit.block {
            visit.share = least[&block];
        }
    }
}

/// Keeps a lower share where a higher one would not last.
fn steady(visits: &mut [BlockVisit]) {
    let mut now: Option<(f64, u32)> = None;
    for at in 0..visits.len() {
        let BlockVisit { block, share, tool, .. } = visits[at];
        if block.is_none() {
            now = None;
            continue;
        }
        let kept = match now {
            Some((last, of)) if of == tool && share > last => {
                last.max(lasting(&visits[at..], tool, last))
            }
            _ => share,
        };
        visits[at].share = kept;
        now = Some((kept, tool));
    }
}

/// The least share of the blocks over which a higher one must last, by their time at the share `now`.
fn lasting(visits: &[BlockVisit], tool: u32, now: f64) -> f64 {
    let (mut least, mut seconds) = (f64::INFINITY, 0.0);
    for visit in visits {
        if visit.block.is_none() || visit.tool != tool || seconds >= STEADY {
            break;
        }
        least = least.min(visit.share);
        seconds += visit.seconds / now;
    }
    least
}

#[cfg(test)]
mod tests {
    use super::*;

    fn visits(of: &[(f64, f64)]) -> Vec<BlockVisit> {
        let numbered = of.iter().enumerate();
        numbered
            .map(|(n, &(share, seconds))| BlockVisit {
                block: Some(n as u32),
                share,
                seconds,
                tool: 1,
            })
            .collect()
    }

    fn shares(visits: &[BlockVisit]) -> Vec<f64> {
        visits.iter().map(|visit| visit.share).collect()
    }

    #[test]
    fn down_at_once_and_up_only_if_it_lasts() {
        let mut some =
            visits(&[(1.0, 1.0), (0.5, 0.1), (1.0, 0.2), (0.5, 0.1), (1.0, 0.6), (0.8, 1.0)]);
        steady(&mut some);
        assert_eq!(shares(&some), [1.0, 0.5, 0.5, 0.5, 1.0, 0.8]);
        // As high as lasts.
        let mut some = visits(&[(0.4, 1.0), (1.0, 0.1), (0.7, 3.0)]);
        steady(&mut some);
        assert_eq!(shares(&some), [0.4, 0.7, 0.7]);
    }

    #[test]
    fn a_block_that_runs_twice_has_one_share() {
        let mut some = visits(&[(1.0, 1.0), (0.6, 1.0), (0.9, 1.0)]);
        some[2].block = Some(0);
        even(&mut some);
        assert_eq!(shares(&some), [0.9, 0.6, 0.9]);
    }

    #[test]
    fn shares_are_steps_downwards() {
        assert_eq!(step_below(1.0), 1.0);
        assert_eq!(step_below(1.04), 1.0);
        assert!((step_below(1.06) - 1.05).abs() < 1e-12);
        assert!((step_below(0.999) - 1.0 / 1.05).abs() < 1e-12);
        for n in 1..400 {
            let share = f64::from(n) / 100.0;
            let step = step_below(share);
            assert!(step <= share * (1.0 + 1e-9) && step * STEP > share);
        }
    }
}
