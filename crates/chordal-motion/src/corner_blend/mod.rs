//! The path without steps: corrections within the tolerance take the steps of direction and curvature away, and what
//! comes out is a look-ahead window of pieces with the limits that hold on each.

mod blend;
mod blend_sum;
mod intervals;
mod joint;
mod joint_trial;
mod leg;
mod overlap;
pub mod path_span;
mod rest_decision;

pub use joint::{
    CornerTolerance, EXACT_TOLERANCE, JointKind, JointPassing, OverlapLimits, SlowJoint,
};
pub use leg::{LegPart, PathLeg};
pub use overlap::{RestEnd, overlap_of};

use std::collections::VecDeque;

use crate::move_request::CornerMode;
use crate::path_limits::AxisArrays;
use crate::ramp_profile::LimitInterval;
use blend::{CURVATURE_DEVIATION, DIRECTION_DEVIATION};
use blend_sum::BlendSum;
use joint::JointStep;
use joint_trial::JointTrial;
use path_span::PathPart;

/// No correction is wider than this, mm or rad to either side: what comes later than twice as
/// far cannot change the path any more.
const MAX_HALF_WIDTH: f64 = 10.0;

/// No more than this is left straight at an overlapped corner, mm or rad.
const MAX_CLEAR_END: f64 = 1.0;

/// The search for the half width of a correction among others ends when it is known to this
/// factor.
const WIDTH_SEARCH_FACTOR: f64 = 1.1;

/// Where two legs meet and something is eased.
#[derive(Clone, Copy, Debug)]
struct BlendNode {
    at: f64,
    step: JointStep,
    /// Number of the leg that begins here.
    leg: usize,
    direction_half: f64,
    curvature_half: f64,
    /// The half width with which it is known to be quicker than a rest, or zero.
    tried: f64,
    /// The axes rest here, and no correction reaches over it.
    rests: bool,
    /// It was decided together with its neighbours.
    decided_part: bool,
}

impl BlendNode {
    fn new(step: JointStep, at: f64, leg: usize) -> BlendNode {
        BlendNode {
            at,
            step,
            leg,
            direction_half: 0.0,
            curvature_half: 0.0,
            tried: 0.0,
            rests: false,
            decided_part: false,
        }
    }

    fn half(&self) -> f64 {
        self.direction_half.max(self.curvature_half)
    }

    /// With no correction.
    fn narrowed(self) -> BlendNode {
        BlendNode { direction_half: 0.0, curvature_half: 0.0, ..self }
    }

    /// The axes have to slow down for it.
    fn is_slow(&self) -> bool {
        self.step.speed_within(self.direction_half, self.curvature_half) < self.step.fastest()
    }

    /// Beyond this half width nothing is gained.
    fn need(&self) -> f64 {
        self.step.direction_need.max(self.step.curvature_need).min(MAX_HALF_WIDTH)
    }
}

/// The half width at which corrections with these sums of shares meet the tolerance.
fn half_within(direction_shares: f64, curvature_shares: f64) -> f64 {
    let (b, c) = (DIRECTION_DEVIATION * direction_shares, CURVATURE_DEVIATION * curvature_shares);
    if b + c <= 0.0 { f64::INFINITY } else { 2.0 / (b + (b * b + 4.0 * c).sqrt()) }
}

/// Smooths one run from rest to rest, as its moves arrive.
#[derive(Debug, Default)]
pub struct CornerBlender {
    /// Legs that have not been emitted; the first has the number `legs_gone`.
    legs: VecDeque<PathLeg>,
    legs_gone: usize,
    /// Parts of those legs beyond their first, in order.
    parts: VecDeque<LegPart>,
    /// Nodes that later legs or nodes may need; the first has the number `nodes_gone`.
    nodes: VecDeque<BlendNode>,
    nodes_gone: usize,
    /// Number of the first node that has not been decided by itself.
    decided_each: usize,
    /// At how many of the nodes the axes rest.
    resting: usize,
    /// Number of the first node that has not been decided with its neighbours.
    decided_part: usize,
    /// Number of the first node whose widths are not settled.
    unsettled: usize,
    length: f64,
    /// How much of the run's two ends is left straight where it can be, for movements that
    /// overlap there.
    clear: [f64; 2],
    corner: Option<CornerMode>,
    pending: Option<PendingLeg>,
    trial: JointTrial,
    /// Up to this number nodes were looked at for the end of the part to be decided.
    part_to: usize,
    corrections: BlendSum,
    /// Number of the first node that no leg has begun at.
    ahead: usize,
    scratch: intervals::IntervalScratch,
}

/// A leg that waits for its end: the joint before it is slow, and how it is passed depends on
/// how long the leg is.
#[derive(Debug)]
struct PendingLeg {
    leg: PathLeg,
    parts: Vec<LegPart>,
    corner: CornerMode,
    slow: SlowJoint,
}

/// A piece of path and what holds on it, as they are made.
#[derive(Debug)]
pub struct LookAheadQueue<P> {
    /// The path.
    pub pieces: Vec<P>,
    /// The largest programmed speed on each, σ per s; empty where the level needs none.
    pub speeds: Vec<f64>,
    /// The speeds are kept: only the best level needs them.
    pub keeps_speeds: bool,
    /// The limits, each over one or more pieces.
    pub intervals: Vec<LimitInterval>,
    /// What the intervals take at their largest speeds, s.
    pub time_s: f64,
}

/// A leg whose length is known.
#[derive(Debug)]
pub struct ReleasedLeg {
    leg: PathLeg,
    parts: Vec<LegPart>,
    corner: CornerMode,
    /// How the joint before it is passed.
    pub passing: JointPassing,
}

impl PendingLeg {
    /// More length would change nothing.
    fn is_long(&self) -> bool {
        let half = self.slow.half();
        self.leg.curve.is_some()
            || self.leg.length >= half + self.slow.step.full_speed_distances()[1]
    }
}

impl<P> LookAheadQueue<P> {
    /// An empty one.
    pub fn new(keeps_speeds: bool) -> LookAheadQueue<P> {
        let (pieces, speeds, intervals) = (Vec::new(), Vec::new(), Vec::new());
        LookAheadQueue { pieces, speeds, keeps_speeds, intervals, time_s: 0.0 }
    }

    fn clear(&mut self) {
        self.pieces.clear();
        self.speeds.clear();
        self.intervals.clear();
        self.time_s = 0.0;
    }
}

impl CornerBlender {
    /// Whether no move is in it.
    pub fn is_empty(&self) -> bool {
        self.corner.is_none()
    }

    /// What the last move and the next make where they meet; `None` at the start of a run.
    pub fn joint(&self, next: &PathLeg, limits: &AxisArrays) -> Option<JointKind> {
        let (last, part, corner) = match &self.pending {
            Some(pending) => (&pending.leg, pending.parts.last(), pending.corner),
            None => {
                let last = self.legs.back()?;
                (last, if last.more > 0 { self.parts.back() } else { None }, self.corner?)
            }
        };
        let size = next.part.start.iter().fold(1.0_f64, |all, value| all.max(value.abs()));
        let shortest = part.unwrap_or(&last.part).length.min(next.length);
        let noise = 1e-11 + 4e-15 * size / shortest;
        let axes = last.axes.max(next.axes);
        Some(joint::joint([&last.tail, &next.head], axes, corner, noise, limits))
    }

    /// Keeps a leg back until its length is known. Says whether it is known now.
    pub fn defer(&mut self, leg: PathLeg, corner: CornerMode, slow: SlowJoint) -> bool {
        let pending = self.pending.insert(PendingLeg { leg, parts: Vec::new(), corner, slow });
        pending.is_long()
    }

    /// Whether the next leg goes on with the one that is kept back.
    pub fn lengthens(&self, next: &PathLeg, joint: Option<JointKind>) -> bool {
        let pending = self.pending.as_ref();
        joint == Some(JointKind::Smooth)
            && pending.is_some_and(|pending| pending.leg.goes_on_with(next))
    }

    /// Lengthens the leg that is kept back. Says whether its length is known now.
    pub fn lengthen(&mut self, next: PathLeg, corner: CornerMode) -> bool {
        let Some(pending) = &mut self.pending else { return false };
        pending.parts.push(LegPart { from: pending.leg.length, ..next.part });
        pending.leg.length += next.length;
        pending.leg.more += 1;
        pending.corner = corner;
        pending.is_long()
    }

    /// Takes the leg that is kept back, with how the joint before it is passed.
    pub fn release(&mut self, limits: &AxisArrays) -> Option<ReleasedLeg> {
        let PendingLeg { mut leg, parts, corner, slow } = self.pending.take()?;
        leg.place(self.length);
        let half = slow.half();
        let distances = slow.step.full_speed_distances();
        let passing = match self.legs.back() {
            Some(last) if last.length.min(leg.length) >= half => {
                let short = [last.length - half < distances[0], leg.length - half < distances[1]];
                if short == [false; 2] && slow.step.is_even() {
                    slow.between_long()
                } else {
                    let before = last.ending(last.length.min(half + distances[0]));
                    let after = leg.beginning(leg.length.min(half + distances[1]));
                    self.trial.quickest(&slow, [&before, &after], limits)
                }
            }
            // Others are in its reach: what is best is seen when their widths are known.
            _ => JointPassing::Ease(slow.step, 0.0),
        };
        Some(ReleasedLeg { leg, parts, corner, passing })
    }

    /// Adds a leg that goes on from the last one, which it meets as `passing` says; `corner`
    /// is how its end is passed.
    pub fn push(&mut self, mut leg: PathLeg, corner: CornerMode, passing: Option<JointPassing>) {
        leg.place(self.length);
        self.length += leg.length;
        self.corner = Some(corner);
        match (passing, self.legs.back_mut()) {
            (Some(JointPassing::Smooth), Some(last)) if last.goes_on_with(&leg) => {
                last.length += leg.length;
                last.more += 1;
                self.parts.push_back(leg.part);
                return;
            }
            (Some(JointPassing::Ease(step, tried)), _) => {
                let number = self.legs_gone + self.legs.len();
                self.nodes.push_back(BlendNode { tried, ..BlendNode::new(step, leg.from, number) });
            }
            _ => {}
        }
        self.legs.push_back(leg);
    }

    /// Adds a leg that was kept back.
    pub fn push_released(
        &mut self,
        ReleasedLeg { leg, parts, corner, .. }: ReleasedLeg,
        passing: Option<JointPassing>,
    ) {
        let from = self.length;
        self.push(leg, corner, passing);
        self.parts.extend(parts.into_iter().map(|part| LegPart { from: from + part.from, ..part }));
    }

    /// The run begins at a corner where the movements overlap.
    pub fn begin_with(&mut self, overlap: &OverlapLimits) {
        self.clear[0] = overlap.clear().min(MAX_CLEAR_END);
        if let Some(leg) = self.legs.front_mut() {
            leg.jerk_share[0] = overlap.jerk_share;
        }
    }

    /// The run ends at a corner where the movements overlap.
    pub fn end_with(&mut self, overlap: &OverlapLimits) {
        self.clear[1] = overlap.clear().min(MAX_CLEAR_END);
        if let Some(leg) = self.legs.back_mut() {
            leg.jerk_share[1] = overlap.jerk_share;
        }
    }

    /// Emits what later moves cannot change; all of it when the run ends here.
    pub fn drain(
        &mut self,
        ends: bool,
        limits: &AxisArrays,
        queue: &mut LookAheadQueue<impl PathPart>,
    ) {
        self.settle(ends, limits);
        while let Some(leg) = self.legs.front() {
            let certain =
                self.legs.len() > 1 && leg.end() + MAX_HALF_WIDTH <= self.next_unsettled();
            if !(ends || certain) {
                break;
            }
            self.emit_first(limits, queue);
        }
        if ends {
            // Keeps the memory for the next run.
            self.nodes.clear();
            self.parts.clear();
            (self.legs_gone, self.nodes_gone) = (0, 0);
            (self.decided_each, self.decided_part, self.unsettled, self.ahead) = (0, 0, 0, 0);
            self.resting = 0;
            self.part_to = 0;
            self.corrections.clear();
            (self.length, self.clear) = (0.0, [0.0; 2]);
            self.corner = None;
        }
    }

    /// Where the first correction of unknown width may be.
    fn next_unsettled(&self) -> f64 {
        self.nodes.get(self.unsettled - self.nodes_gone).map_or(self.length, |node| node.at)
    }

    /// Gives the nodes their widths, as far as later moves cannot change them.
    fn settle(&mut self, ends: bool, limits: &AxisArrays) {
        self.decide_each(ends, limits);
        while self.unsettled < self.decided_each {
            if self.unsettled >= self.decided_part && !self.decide_part(ends, limits) {
                break;
            }
            let index = self.unsettled - self.nodes_gone;
            if self.resting > 0 && !self.nodes[index].decided_part {
                self.settle_among_rests(index, limits);
            }
            let node = self.nodes[index];
            if node.half() > 0.0 {
                self.reach(self.unsettled, node.leg, node.at, node.half());
            } else {
                self.legs[node.leg - self.legs_gone].begins_at_rest = true;
            }
            self.corrections.add(&node);
            self.unsettled += 1;
        }
    }

    /// Gives a node that was decided by itself its widths between the rests around it.
    fn settle_among_rests(&mut self, index: usize, limits: &AxisArrays) {
        if self.nodes[index].rests {
            self.nodes[index] = self.nodes[index].narrowed();
            return;
        }
        let node = self.widened(index);
        let rests = !self.is_clearly_quicker_eased(&node) && self.is_quicker_at_rest(&node, limits);
        self.nodes[index] = if rests { node.narrowed() } else { node };
    }

    /// The largest half width up to `most` with which a node and all nodes in its reach, were
    /// they as wide, keep the tolerance together. If the widest of the corrections over any
    /// place is chosen so, their sum keeps it there.
    fn half_among(&self, index: usize, most: f64, among_rests: bool) -> f64 {
        let within = |half: f64| {
            let (mut direction_shares, mut curvature_shares) = (0.0, 0.0);
            let at = self.nodes[index].at;
            let near = |node: &BlendNode| {
                (node.at - at).abs() < 2.0 * half && !(among_rests && node.rests)
            };
            for node in self.nodes.range(..=index).rev() {
                if !near(node) {
                    break;
                }
                direction_shares += node.step.direction_share;
                curvature_shares += node.step.curvature_share;
            }
            for node in self.nodes.range(index + 1..) {
                if !near(node) {
                    break;
                }
                direction_shares += node.step.direction_share;
                curvature_shares += node.step.curvature_share;
            }
            half_within(direction_shares, curvature_shares)
        };
        let own = &self.nodes[index].step;
        let mut above = most.min(half_within(own.direction_share, own.curvature_share));
        let mut below = within(above);
        if below >= above {
            below = above;
        }
        while above > WIDTH_SEARCH_FACTOR * below {
            let middle = (below * above).sqrt();
            let most = within(middle);
            if most >= middle {
                below = middle;
            } else {
                above = middle;
                // Among fewer nodes there is at least as much room.
                below = below.max(most);
            }
        }
        self.snapped(index, below)
    }

    /// A little less than a half width, so that the correction ends at another node where one is
    /// near: in a series of even lines the changes of all corrections then cancel.
    fn snapped(&self, index: usize, half: f64) -> f64 {
        const MIN_SNAP_SHARE: f64 = 0.75;
        const SNAP_ROUNDING_SHARE: f64 = 1e-9;
        let at = self.nodes[index].at;
        let distance = |node: &BlendNode| (node.at - at).abs();
        let reach = |node: &&BlendNode| distance(node) <= half * (1.0 + SNAP_ROUNDING_SHARE);
        let left = self.nodes.range(..index).rev().take_while(reach).last().map_or(0.0, distance);
        let right = self.nodes.range(index + 1..).take_while(reach).last().map_or(0.0, distance);
        let far = left.max(right);
        if far >= MIN_SNAP_SHARE * half { far.min(half) } else { half }
    }

    /// Marks in the legs around a node that it reaches into them.
    fn reach(&mut self, number: usize, first: usize, at: f64, half: f64) {
        let first = first - self.legs_gone;
        for leg in self.legs.range_mut(..first).rev().take_while(|leg| leg.end() > at - half) {
            leg.nodes.0 = leg.nodes.0.min(number);
            leg.nodes.1 = number + 1;
        }
        for leg in self.legs.range_mut(first..).take_while(|leg| leg.from < at + half) {
            leg.nodes.0 = leg.nodes.0.min(number);
            leg.nodes.1 = number + 1;
        }
    }

    /// Emits the first leg.
    fn emit_first(&mut self, limits: &AxisArrays, queue: &mut LookAheadQueue<impl PathPart>) {
        let Some(leg) = self.legs.pop_front() else { return };
        let own = self.nodes.get(self.ahead - self.nodes_gone);
        let own = own.filter(|node| node.leg == self.legs_gone);
        self.ahead += usize::from(own.is_some());
        self.legs_gone += 1;
        let (from, to) = leg.nodes;
        let nodes = if from < to { from - self.nodes_gone..to - self.nodes_gone } else { 0..0 };
        let until = leg.from + intervals::rounding(&leg);
        let nodes = self.nodes.range(nodes);
        self.corrections.enter(leg.from, until, own, nodes.clone());
        let more = leg.more as usize;
        let parts = self.parts.range(..more);
        intervals::make(
            &leg,
            parts,
            nodes,
            limits,
            &mut self.corrections,
            &mut self.scratch,
            queue,
        );
        self.parts.drain(..more);
        while self.nodes.front().is_some_and(|node| {
            node.at + 2.0 * MAX_HALF_WIDTH < leg.end() && self.nodes_gone < self.unsettled
        }) {
            let node = self.nodes.pop_front();
            self.nodes_gone += 1;
            self.resting -= usize::from(node.is_some_and(|node| node.rests));
        }
    }
}
