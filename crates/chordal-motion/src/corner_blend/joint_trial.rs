//! What a joint costs between legs that are too short to reach their speed: each way to pass it,
//! planned with nothing but its two legs, from rest to rest.

use crate::corner_blend::blend_sum::BlendSum;
use crate::corner_blend::intervals::{self, IntervalScratch};
use crate::corner_blend::joint::{JointPassing, JointStep, SlowJoint};
use crate::corner_blend::leg::PathLeg;
use crate::corner_blend::overlap::{RestEnd, overlap_of};
use crate::corner_blend::path_span::PathSpan;
use crate::corner_blend::{BlendNode, LookAheadQueue};
use crate::path_limits::AxisArrays;
use crate::ramp_profile::RampSolver;
use crate::trajectory::JerkPhase;

/// Plans joints. Keeps its memory from one to the next.
#[derive(Debug)]
pub struct JointTrial {
    queue: LookAheadQueue<PathSpan>,
    solver: RampSolver,
    phases: Vec<JerkPhase>,
    corrections: BlendSum,
    scratch: IntervalScratch,
}

impl Default for JointTrial {
    fn default() -> JointTrial {
        JointTrial {
            queue: LookAheadQueue::new(false),
            solver: RampSolver::default(),
            phases: Vec::new(),
            corrections: BlendSum::default(),
            scratch: IntervalScratch::default(),
        }
    }
}

impl JointTrial {
    /// The quickest way to pass a joint between two legs.
    pub fn quickest(
        &mut self,
        slow: &SlowJoint,
        legs: [&PathLeg; 2],
        limits: &AxisArrays,
    ) -> JointPassing {
        let [before, after] = legs;
        let rest = self.alone(before, limits) + self.alone(after, limits);
        let ease = self.eased(slow.step, slow.halves, legs, limits);
        let overlapped = slow.overlap.map_or(f64::INFINITY, |overlap| {
            let (mut last, mut first) = (before.clone(), after.clone());
            last.jerk_share[1] = overlap.jerk_share;
            first.jerk_share[0] = overlap.jerk_share;
            let one = self.alone(&last, limits);
            let end = RestEnd::last(&self.phases, &self.queue.pieces);
            let two = self.alone(&first, limits);
            let start = RestEnd::first(&self.phases, &self.queue.pieces);
            let (Some(end), Some(start)) = (end, start) else { return f64::INFINITY };
            // What the lower jerk costs may be more where the axes do not come from rest.
            let (cost, gain) = (one + two - rest, overlap_of(&overlap, &end, &start));
            if gain < 2.0 * cost { f64::INFINITY } else { rest + cost - gain }
        });
        slow.quickest(ease, rest, overlapped)
    }

    /// How long a leg takes from rest to rest, s.
    pub fn alone(&mut self, leg: &PathLeg, limits: &AxisArrays) -> f64 {
        self.time(&[leg], &[], limits)
    }

    /// How long two legs take from rest to rest with their joint eased, s.
    pub fn eased(
        &mut self,
        step: JointStep,
        (direction_half, curvature_half): (f64, f64),
        legs: [&PathLeg; 2],
        limits: &AxisArrays,
    ) -> f64 {
        let node =
            BlendNode { direction_half, curvature_half, ..BlendNode::new(step, legs[1].from, 0) };
        self.time(&legs, &[node], limits)
    }

    /// How long some legs take from rest to rest, s; the axes rest where a leg begins so.
    pub fn together(&mut self, legs: &[PathLeg], nodes: &[BlendNode], limits: &AxisArrays) -> f64 {
        let legs: Vec<&PathLeg> = legs.iter().collect();
        self.time(&legs, nodes, limits)
    }

    fn time(&mut self, legs: &[&PathLeg], nodes: &[BlendNode], limits: &AxisArrays) -> f64 {
        let JointTrial { queue, solver, phases: profile, corrections, scratch } = self;
        queue.clear();
        corrections.clear();
        nodes.iter().for_each(|node| corrections.add(node));
        for leg in legs {
            let until = leg.from + intervals::rounding(leg);
            corrections.enter_anew(leg.from, until, nodes.iter());
            intervals::make(leg, [].iter(), nodes.iter(), limits, corrections, scratch, queue);
        }
        solver.solve(&queue.intervals, 0.0, 0.0);
        profile.clear();
        solver.phases(&queue.intervals, 0, queue.intervals.len(), profile);
        profile.iter().map(|phase| phase.duration_s).sum()
    }
}
