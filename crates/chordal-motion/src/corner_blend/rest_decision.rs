//! Decides at which corners the axes rest, because passing them blended would be slower.
//!
//! A node is decided by itself first, as if all others were eased. Then a part of the path, from
//! rest to rest or from one long leg to the next, is decided as a whole: what rests bounds the
//! corrections of its neighbours, which makes more of them slow, until nothing changes. If it
//! is quicker to rest at all its joints, the axes do. No answer depends on the direction of the
//! path or on how its lines are cut.

use std::collections::VecDeque;

use crate::corner_blend::leg::PathLeg;
use crate::corner_blend::{BlendNode, CornerBlender, MAX_CLEAR_END};
use crate::path_limits::AxisArrays;

/// Parts of more legs are not decided as a whole: their nodes are decided one by one.
const MAX_PART_LEGS: usize = 64;

impl CornerBlender {
    /// Decides nodes as if all of them were eased, as far as enough is known of the legs to come.
    pub(super) fn decide_each(&mut self, ends: bool, limits: &AxisArrays) {
        while let Some(node) = self.nodes.get(self.decided_each - self.nodes_gone) {
            if !ends && self.length - node.at <= 2.0 * node.need() + MAX_CLEAR_END {
                break;
            }
            let index = self.decided_each - self.nodes_gone;
            let node = self.with_half(index, self.half_among(index, self.room(node), false));
            if !ends && node.is_slow() && !self.is_known_around(&node) {
                break;
            }
            let clear = self.is_clearly_quicker_eased(&node);
            let rests = !clear && self.is_quicker_at_rest(&node, limits);
            let tried = if clear { 0.0 } else { node.half() };
            self.nodes[index] = BlendNode { rests, tried, ..node };
            self.resting += usize::from(rests);
            self.decided_each += 1;
        }
    }

    /// Decides the part that begins with the first node that is not decided with its neighbours. False when more has to be
    /// known of the moves to come.
    pub(super) fn decide_part(&mut self, ends: bool, limits: &AxisArrays) -> bool {
        let from = self.decided_part - self.nodes_gone;
        let Some(to) = self.part_from(from, ends) else { return false };
        let known = match self.nodes.get(self.decided_each - self.nodes_gone) {
            Some(next) => next.at > self.nodes[to - 1].at + self.nodes[to - 1].need(),
            None => true,
        };
        if self.decided_each - self.nodes_gone < to || !(known || ends) {
            return false;
        }
        let legs = self.nodes[to - 1].leg - self.nodes[from].leg;
        if legs < MAX_PART_LEGS && self.nodes.range(from..to).any(|node| self.may_lose(node)) {
            let rests = |nodes: &VecDeque<BlendNode>| {
                nodes.range(from..to).filter(|node| node.rests).count()
            };
            let before = rests(&self.nodes);
            self.rest_where_quicker(from, to, limits);
            self.nodes.range_mut(from..to).for_each(|node| node.decided_part = true);
            self.resting += rests(&self.nodes) - before;
        }
        self.decided_part = to + self.nodes_gone;
        true
    }

    /// The node after the last of the part that begins with a node. `None` when that is not known;
    /// the next search goes on from where this one ends.
    fn part_from(&mut self, from: usize, ends: bool) -> Option<usize> {
        let mut to = self.part_to.saturating_sub(self.nodes_gone).max(from + 1);
        loop {
            self.part_to = to + self.nodes_gone;
            let node = &self.nodes[to - 1];
            let legs = node.leg - self.nodes[from].leg;
            if node.rests || legs >= MAX_PART_LEGS || self.is_followed_by_long(node) {
                return Some(to);
            }
            match self.nodes.get(to) {
                Some(next) if next.rests && to + self.nodes_gone < self.decided_each => {
                    return Some(to);
                }
                Some(_) if to + self.nodes_gone < self.decided_each || ends => to += 1,
                None if ends => return Some(to),
                _ => return None,
            }
        }
    }

    /// Easing may take time here: the axes slow down, or get up to speed on the correction, where
    /// less of their jerk is free for that, or turn on a curve and at a step of direction at once.
    fn may_lose(&self, node: &BlendNode) -> bool {
        let leg = node.leg - self.legs_gone;
        let (before, after) = (&self.legs[leg - 1], &self.legs[leg]);
        let [distance_before, distance_after] =
            node.step.full_speed_distances().map(|distance| distance / 2.0 + node.half());
        let has_direction_step = node.step.direction_share > 0.0;
        node.is_slow()
            || !node.step.is_even()
            || before.length < distance_before
            || after.length < distance_after
            || has_direction_step && (before.curve.is_some() || after.curve.is_some())
    }

    /// The leg after a node is so long that full speed is reached on it whatever happens at its
    /// ends.
    fn is_followed_by_long(&self, node: &BlendNode) -> bool {
        let leg = &self.legs[node.leg - self.legs_gone];
        let half = node.half();
        leg.curve.is_none()
            // What the axes need takes a root to find, and most legs are too short anyway.
            && leg.length >= 2.0 * half
            && leg.length >= 2.0 * (half + node.step.full_speed_distances()[1])
    }

    /// Lets the axes rest at nodes of a part until nothing gets quicker by it.
    fn rest_where_quicker(&mut self, from: usize, to: usize, limits: &AxisArrays) {
        loop {
            for index in from..to {
                if !self.nodes[index].rests {
                    self.nodes[index] = self.widened(index);
                }
            }
            let mut more = Vec::new();
            for index in from..to {
                let node = self.nodes[index];
                if !node.rests && self.is_quicker_at_rest(&node, limits) {
                    more.push(index);
                }
            }
            if more.is_empty() {
                break;
            }
            more.into_iter().for_each(|index| self.nodes[index].rests = true);
        }
        if self.is_quicker_at_all_rests(from, to, limits) {
            self.nodes.range_mut(from..to).for_each(|node| node.rests = true);
        }
        for node in self.nodes.range_mut(from..to).filter(|node| node.rests) {
            *node = node.narrowed();
        }
    }

    /// Whether a part takes longer with its corrections than with a rest at every joint.
    fn is_quicker_at_all_rests(&mut self, from: usize, to: usize, limits: &AxisArrays) -> bool {
        let (first, last) = (self.nodes[from], self.nodes[to - 1]);
        if self.nodes.range(from..to).all(|node| node.rests) {
            return false;
        }
        let begin = first.leg - self.legs_gone - 1;
        let end = last.leg - self.legs_gone;
        let nodes = || self.nodes.range(from..to);
        let legs: Vec<PathLeg> = (begin..=end)
            .map(|index| {
                let leg = &self.legs[index];
                let mut part = if index == begin {
                    leg.ending(leg.length.min(first.half() + first.step.full_speed_distances()[0]))
                } else if index == end {
                    leg.beginning(leg.length.min(last.half() + last.step.full_speed_distances()[1]))
                } else {
                    leg.beginning(leg.length)
                };
                part.begins_at_rest =
                    nodes().any(|node| node.rests && node.leg - self.legs_gone == index);
                part
            })
            .collect();
        let eased: Vec<BlendNode> = nodes().filter(|node| !node.rests).copied().collect();
        let stops: f64 = legs.iter().map(|leg| self.trial.alone(leg, limits)).sum();
        stops < self.trial.together(&legs, &eased, limits)
    }

    /// No correction reaches over the ends of the run, where the axes rest.
    fn room(&self, node: &BlendNode) -> f64 {
        let room = |distance: f64, clear: f64| (distance - clear).max(distance / 2.0);
        let ends = room(node.at, self.clear[0]).min(room(self.length - node.at, self.clear[1]));
        node.need().min(ends)
    }

    /// A node with the widths that it has among others, none of which reaches over a rest.
    pub(super) fn widened(&self, index: usize) -> BlendNode {
        let node = &self.nodes[index];
        let distance = |other: &BlendNode| (other.at - node.at).abs();
        let near = |other: &&BlendNode| distance(other) < node.need();
        let rest = |other: &&BlendNode| other.rests;
        let before = self.nodes.range(..index).rev().take_while(near).find(rest);
        let after = self.nodes.range(index + 1..).take_while(near).find(rest);
        let room =
            [before, after].into_iter().flatten().map(distance).fold(self.room(node), f64::min);
        self.with_half(index, self.half_among(index, room, true))
    }

    fn with_half(&self, index: usize, half: f64) -> BlendNode {
        let node = self.nodes[index];
        let (direction_half, curvature_half) =
            (half.min(node.step.direction_need), half.min(node.step.curvature_need));
        BlendNode { direction_half, curvature_half, ..node }
    }

    /// The legs that a node's correction goes over are known, or long enough.
    fn is_known_around(&self, node: &BlendNode) -> bool {
        if self.legs.back().is_some_and(|last| last.from > node.at + node.half()) {
            return true;
        }
        let first = node.leg - self.legs_gone;
        let after = covering(self.legs.range(first..), node.half());
        first + after.legs < self.legs.len()
            || after.distance >= node.step.full_speed_distances()[1] + node.half()
    }

    /// The legs before and from the leg `first` on that a correction of this half width goes over.
    fn covering_sides(&self, first: usize, half: f64) -> [CoveredLegs; 2] {
        let before = covering(self.legs.range(..first).rev(), half);
        [before, covering(self.legs.range(first..), half)]
    }

    /// The axes pass an eased node faster than they get to be on any leg in its reach, between
    /// rests.
    pub(super) fn is_clearly_quicker_eased(&self, node: &BlendNode) -> bool {
        let speed = node.step.speed_within(node.direction_half, node.curvature_half);
        let slower = |leg: &PathLeg| {
            leg.feed <= speed || leg.head.effort.rise(0.0, leg.length / 2.0) <= speed
        };
        let first = node.leg - self.legs_gone;
        let [before, after] = self.covering_sides(first, node.half());
        self.legs.range(first - before.legs..first + after.legs).all(slower)
    }

    /// Whether the axes had better rest at a node, given its widths: between its legs alone, from
    /// rest to rest.
    pub(super) fn is_quicker_at_rest(&mut self, node: &BlendNode, limits: &AxisArrays) -> bool {
        let (direction_half, curvature_half, half) =
            (node.direction_half, node.curvature_half, node.half());
        if !node.is_slow() || half == node.tried {
            return false;
        }
        let first = node.leg - self.legs_gone;
        let [distance_before, distance_after] =
            node.step.full_speed_distances().map(|distance| distance + half);
        let [before, after] = self.covering_sides(first, half);
        let long = before.distance >= distance_before && after.distance >= distance_after;
        if long && node.step.is_even() {
            return node.step.is_quicker_at_rest(direction_half, curvature_half);
        }
        let trial = &mut self.trial;
        let mut rest = 0.0;
        for leg in self.legs.range(first - before.legs..first) {
            rest += trial.alone(&leg.ending(leg.length.min(distance_before)), limits);
        }
        for leg in self.legs.range(first..first + after.legs) {
            rest += trial.alone(&leg.beginning(leg.length.min(distance_after)), limits);
        }
        let before = self.legs[first - 1].ending(before.distance.min(distance_before));
        let after = self.legs[first].beginning(after.distance.min(distance_after));
        let eased =
            trial.eased(node.step, (direction_half, curvature_half), [&before, &after], limits);
        rest < eased
    }
}

/// The legs that a correction goes over.
struct CoveredLegs {
    legs: usize,
    distance: f64,
}

/// The first legs that are as long together as a half width.
fn covering<'a>(legs: impl Iterator<Item = &'a PathLeg>, half: f64) -> CoveredLegs {
    let mut covering = CoveredLegs { legs: 0, distance: 0.0 };
    for leg in legs {
        covering.legs += 1;
        covering.distance += leg.length;
        // Widths often end at a node: rounding must not take one more leg in.
        if covering.distance >= half * (1.0 - 1e-9) {
            break;
        }
    }
    covering
}
