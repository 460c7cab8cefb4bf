//! Where the axes had better rest than pass an eased corner slowly.
//!
//! It is judged twice. First as if all nodes were eased: what rests then bounds the corrections
//! of its neighbours. Then with the widths that are left, where that changes nothing for others
//! any more, so that the answer does not depend on the direction of the path.

use crate::cell::AxisArrays;
use crate::smooth::leg::Leg;
use crate::smooth::{CLEAREST, Node, Smoother};

impl Smoother {
    /// Judges nodes as if all of them were eased, as far as enough is known of the legs to come.
    pub(super) fn judge(&mut self, ends: bool, limits: &AxisArrays) {
        while let Some(node) = self.nodes.get(self.judged - self.nodes_gone) {
            if !ends && self.length - node.at <= 2.0 * node.need() + CLEAREST {
                break;
            }
            let index = self.judged - self.nodes_gone;
            let node = self.widened(index, self.room(node), false);
            let Some(rests) = self.is_quicker_at_rest(&node, ends, limits) else { break };
            let judged = &mut self.nodes[index];
            judged.rests = rests;
            judged.tried = node.half();
            self.judged += 1;
        }
    }

    /// No correction reaches over the ends of the run, where the axes stand still.
    fn room(&self, node: &Node) -> f64 {
        let room = |way: f64, clear: f64| (way - clear).max(way / 2.0);
        room(node.at, self.clear[0]).min(room(self.length - node.at, self.clear[1]))
    }

    /// Nor over a node where they rest.
    pub(super) fn room_among_rests(&self, index: usize) -> f64 {
        let node = &self.nodes[index];
        let way = |other: &Node| (other.at - node.at).abs();
        let near = |other: &&Node| way(other) < node.need();
        let rest = |other: &&Node| other.rests;
        let before = self.nodes.range(..index).rev().take_while(near).find(rest);
        let after = self.nodes.range(index + 1..).take_while(near).find(rest);
        [before, after].into_iter().flatten().map(way).fold(self.room(node), f64::min)
    }

    /// A node with the widths that it has within some room.
    pub(super) fn widened(&self, index: usize, room: f64, among_rests: bool) -> Node {
        let node = self.nodes[index];
        let half = self.half_among(index, node.need().min(room), among_rests);
        let (kink_half, bend_half) = (half.min(node.step.kink_need), half.min(node.step.bend_need));
        Node { kink_half, bend_half, ..node }
    }

    /// Whether the axes had better rest at a node, given its widths. `None` when too little is
    /// known of the legs to come.
    pub(super) fn is_quicker_at_rest(
        &mut self,
        node: &Node,
        ends: bool,
        limits: &AxisArrays,
    ) -> Option<bool> {
        let (kink_half, bend_half, half) = (node.kink_half, node.bend_half, node.half());
        let speed = node.step.speed_within(kink_half, bend_half);
        if speed >= node.step.fastest() || half == node.tried {
            return Some(false);
        }
        let first = node.leg - self.legs_gone;
        let [way_before, way_after] = node.step.ways().map(|way| way + half);
        let before = covering(self.legs.range(..first).rev(), half);
        let after = covering(self.legs.range(first..), half);
        let open = first + after.legs == self.legs.len() && !ends;
        if open && after.way < way_after {
            return None;
        }
        if before.way >= way_before && after.way >= way_after {
            return Some(node.step.is_quicker_at_rest(kink_half, bend_half));
        }
        let trial = &mut self.trial;
        let mut rest = 0.0;
        for leg in self.legs.range(first - before.legs..first) {
            rest += trial.alone(&leg.ending(leg.length.min(way_before)), limits);
        }
        for leg in self.legs.range(first..first + after.legs) {
            rest += trial.alone(&leg.beginning(leg.length.min(way_after)), limits);
        }
        let before = self.legs[first - 1].ending(before.way.min(way_before));
        let after = self.legs[first].beginning(after.way.min(way_after));
        let eased = trial.eased(node.step, (kink_half, bend_half), [&before, &after], limits);
        Some(rest < eased)
    }
}

/// The legs that a correction goes over.
struct Covering {
    legs: usize,
    way: f64,
}

/// The first legs that are as long together as a half width.
fn covering<'a>(legs: impl Iterator<Item = &'a Leg>, half: f64) -> Covering {
    let mut covering = Covering { legs: 0, way: 0.0 };
    for leg in legs {
        covering.legs += 1;
        covering.way += leg.length;
        // Widths often end at a node: rounding must not take one more leg in.
        if covering.way >= half * (1.0 - 1e-9) {
            break;
        }
    }
    covering
}
