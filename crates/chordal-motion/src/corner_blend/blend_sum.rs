//! The sum of all corrections along a run, carried on from break to break.

use std::collections::VecDeque;

use chordal_geometry::AXES;

use crate::AxisValues;
use crate::corner_blend::BlendNode;
use crate::corner_blend::blend::{
    BlendJet, RAMP_SLOPE, RAMP_TURN_SHARE, curvature_blend, direction_blend,
};
use crate::piece::{AxisJet, go_ahead};

/// The sum is made anew after so many legs, before rounding adds up.
const LEGS_PER_FRESH_SUM: u32 = 16;

/// And where corrections that have ended leave more than so many times the rounding of σ: a narrow one has a large
/// third derivative, and by the rounding of its breaks it leaves a second one, which grows with the square of
/// the distance.
const MAX_RESIDUE_ROUNDINGS: f64 = 32.0;

/// Where the sum changes its polynomial.
#[derive(Clone, Copy, Debug)]
pub struct BlendBreak {
    pub at: f64,
    /// Changes of the third derivative of the axes.
    change: AxisValues,
    /// How many corrections begin, less those that end.
    begins: i32,
}

/// The sum of the corrections at a place that goes along the run.
#[derive(Debug, Default)]
pub struct BlendSum {
    /// Breaks that lie ahead, in order.
    breaks: VecDeque<BlendBreak>,
    jet: AxisJet,
    /// How many corrections there are.
    active: i32,
    /// Axes up to the last that any of them moves.
    axes: usize,
    /// Legs since the sum was made anew.
    legs: u32,
    /// Third derivatives of the corrections that have ended since, and the distance since the first of them did.
    ended: f64,
    distance: f64,
}

/// Where the ramp of a step of curvature turns, as shares of its half width, and by how many slopes.
const CURVATURE_BREAKS: [(f64, f64); 4] =
    [(-1.0, -1.0), (-RAMP_TURN_SHARE, 2.0), (RAMP_TURN_SHARE, -2.0), (1.0, 1.0)];
/// The same of a step of direction, next to the step itself.
const DIRECTION_BREAKS: [(f64, f64); 2] = [(-1.0, 1.0), (1.0, 1.0)];

impl BlendSum {
    /// The sum here.
    pub fn jet(&self) -> &AxisJet {
        &self.jet
    }

    /// Whether there are any here. Their sum may vanish all the same.
    pub fn are_there(&self) -> bool {
        self.active > 0
    }

    /// Axes up to the last that any of them may move.
    pub fn axes(&self) -> usize {
        self.axes
    }

    /// The run is over.
    pub fn clear(&mut self) {
        self.breaks.clear();
        self.axes = 0;
        self.begin(AxisJet::default());
        self.active = 0;
    }

    /// Goes on with a sum without rounding.
    fn begin(&mut self, jet: AxisJet) {
        self.jet = jet;
        (self.legs, self.ended, self.distance) = (0, 0.0, 0.0);
    }

    /// A node's widths are settled.
    pub fn add(&mut self, node: &BlendNode) {
        let moves = |axis: &usize| {
            node.step.direction_step[*axis] != 0.0 || node.step.curvature_step[*axis] != 0.0
        };
        self.axes = (self.axes..AXES).rev().find(moves).map_or(self.axes, |last| last + 1);
        let mut take = |step: &AxisValues, h: f64, slope: f64, turns: &[(f64, f64)]| {
            if h <= 0.0 {
                return;
            }
            for (place, jump) in turns {
                let change = step.map(|step| step * jump * slope);
                let begins = if *place == -1.0 { 1 } else { -i32::from(*place == 1.0) };
                self.insert(BlendBreak { at: node.at + place * h, change, begins });
            }
        };
        let (direction_half, curvature_half) = (node.direction_half, node.curvature_half);
        take(
            &node.step.direction_step,
            direction_half,
            1.0 / (direction_half * direction_half),
            &DIRECTION_BREAKS,
        );
        take(
            &node.step.curvature_step,
            curvature_half,
            RAMP_SLOPE / curvature_half,
            &CURVATURE_BREAKS,
        );
    }

    /// A break where nothing changes but the leg.
    pub fn cut(&mut self, at: f64) {
        self.insert(BlendBreak { at, change: [0.0; AXES], begins: 0 });
    }

    fn insert(&mut self, new: BlendBreak) {
        let after = self.breaks.iter().rev().take_while(|other| other.at > new.at).count();
        self.breaks.insert(self.breaks.len() - after, new);
    }

    /// Goes over to a leg that begins at `from`. Breaks up to `until` count as passed; `own` is the
    /// node where it begins, and `nodes` are those that reach into the leg.
    pub fn enter<'a>(
        &mut self,
        from: f64,
        until: f64,
        own: Option<&BlendNode>,
        nodes: impl Iterator<Item = &'a BlendNode>,
    ) {
        while self.next_before(from).is_some() {
            self.pass();
        }
        if let Some(node) = own {
            self.pass_node(node);
        }
        while self.next_before(until).is_some() {
            self.pass();
        }
        self.legs += 1;
        // A correction that is narrower than rounding ends where it begins, and leaves nothing.
        let over = own.is_some_and(|node| is_over(node, until));
        if self.active == 0 {
            self.jet = AxisJet::default();
        } else if over || self.legs >= LEGS_PER_FRESH_SUM {
            self.begin(sum(from, until, nodes));
        }
    }

    /// Makes the sum anew at a place on a leg, if rounding would grow too large on the part ahead. Breaks up to
    /// `until` are passed; `nodes` are those that reach into the leg.
    pub fn refresh<'a>(
        &mut self,
        [from, until]: [f64; 2],
        ahead: f64,
        nodes: impl Iterator<Item = &'a BlendNode>,
    ) {
        let distance = self.distance + ahead;
        if self.active > 0 && self.ended * distance * distance > MAX_RESIDUE_ROUNDINGS {
            self.begin(sum(from, until, nodes));
        }
    }

    /// The same whatever lies before the leg.
    pub fn enter_anew<'a>(
        &mut self,
        from: f64,
        until: f64,
        nodes: impl Iterator<Item = &'a BlendNode>,
    ) {
        while self.next_before(until).is_some() {
            self.pass();
        }
        let jet = if self.active > 0 { sum(from, until, nodes) } else { AxisJet::default() };
        self.begin(jet);
    }

    /// The steps that the corrections take away lie here.
    fn pass_node(&mut self, node: &BlendNode) {
        let [_, first, second, third] = &mut self.jet;
        let h = node.direction_half;
        if h > 0.0 {
            for ((first, third), step) in first.iter_mut().zip(third).zip(&node.step.direction_step)
            {
                *first -= step;
                *third -= 2.0 * step / (h * h);
            }
        }
        if node.curvature_half > 0.0 {
            second
                .iter_mut()
                .zip(&node.step.curvature_step)
                .for_each(|(second, step)| *second -= step);
        }
    }

    /// The next break that lies no farther than a place.
    pub fn next_before(&self, place: f64) -> Option<f64> {
        self.breaks.front().map(|next| next.at).filter(|at| *at <= place)
    }

    /// Passes the next break, where the sum is already.
    pub fn pass(&mut self) {
        let Some(BlendBreak { change, begins, .. }) = self.breaks.pop_front() else { return };
        self.active += begins;
        if self.active == 0 {
            // What is left is rounding.
            self.begin(AxisJet::default());
        } else {
            if begins < 0 {
                self.ended += change.iter().fold(0.0_f64, |most, part| most.max(part.abs()));
            }
            let third = &mut self.jet[3][..self.axes];
            third.iter_mut().zip(change).for_each(|(third, change)| *third += change);
        }
    }

    /// Goes on along the path.
    pub fn advance(&mut self, distance: f64) {
        if self.active > 0 {
            go_ahead(&mut self.jet, distance, self.axes);
            if self.ended > 0.0 {
                self.distance += distance;
            }
        }
    }
}

/// A correction of the node has ended at a place.
fn is_over(node: &BlendNode, place: f64) -> bool {
    [node.direction_half, node.curvature_half]
        .iter()
        .any(|half| *half > 0.0 && node.at + half <= place)
}

/// The sum at the start of a leg, node by node. Breaks up to `until` are passed.
fn sum<'a>(from: f64, until: f64, nodes: impl Iterator<Item = &'a BlendNode>) -> AxisJet {
    let mut jet = AxisJet::default();
    for node in nodes {
        let w = from - node.at;
        let mut take = |step: &AxisValues, h: f64, bump: fn(f64, f64, f64) -> BlendJet| {
            // In the same words as the breaks, so that none is lost by rounding.
            let passed = |place: f64| node.at + place * h <= until;
            if h <= 0.0 || passed(1.0) || !passed(-1.0) {
                return;
            }
            let inside = match (passed(-RAMP_TURN_SHARE), passed(RAMP_TURN_SHARE)) {
                (false, _) => -0.5 * (1.0 + RAMP_TURN_SHARE),
                (_, true) => 0.5 * (1.0 + RAMP_TURN_SHARE),
                // A node lies at an end of a leg or outside: before this leg or after it.
                _ if node.at <= until => 0.5 * RAMP_TURN_SHARE,
                _ => -0.5 * RAMP_TURN_SHARE,
            };
            for (row, factor) in jet.iter_mut().zip(bump(w, inside * h, h)) {
                row.iter_mut().zip(step).for_each(|(value, step)| *value += step * factor);
            }
        };
        take(&node.step.direction_step, node.direction_half, direction_blend);
        take(&node.step.curvature_step, node.curvature_half, curvature_blend);
    }
    jet
}
