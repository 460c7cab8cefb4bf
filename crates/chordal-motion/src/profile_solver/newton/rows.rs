//! The rows of limits: their slacks, their prices, and what they add to a step.
//!
//! A row says that a sum of the three coefficients around an interval, and of its elastic share, stays below a
//! limit. The rows of two intervals are worked on at once. There are two passes for each step. The first takes
//! the prices that the step before has found, works out the slacks, and sums up matrix and side; the second
//! finds how far the step may be gone. One division serves both: w = 1/(slack · price), so 1/slack = w · price.

#![allow(
    clippy::needless_range_loop,
    reason = "the number of an end runs through several lists at once"
)]

use chordal_geometry::AXES;

use super::lanes::LanePair;
use super::start_kind::NewtonStart;

/// A row of each of two intervals. Between the passes of a step `change` is w, after them how the price changes,
/// as a share of it.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct ConstraintRow {
    pub price: LanePair,
    pub change: LanePair,
}

/// The acceleration of an axis at a node.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct AccelerationRows {
    /// By the coefficients before and after the node.
    pub slope: [LanePair; 2],
    /// Above and below.
    pub rows: [ConstraintRow; 2],
}

/// The jerk of an axis at both ends of an interval.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct JerkRows {
    /// For each end by the three coefficients around the interval.
    pub slope: [[LanePair; 3]; 2],
    /// For each end above and below.
    pub rows: [[ConstraintRow; 2]; 2],
}

/// What is summed up over all rows.
#[derive(Clone, Copy, Debug)]
pub(super) struct SlackTally {
    least: LanePair,
    open: LanePair,
}

/// What the accelerations at a node add: a matrix (00, 11, 01) and a push for the coefficients before and after
/// it, and what goes with the elastic share.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct NodeSums {
    pub matrix: [LanePair; 3],
    pub push: [LanePair; 2],
    pub turned: [LanePair; 2],
    pub weight: LanePair,
    pub pushes: LanePair,
}

/// What the jerks on an interval add: a matrix (00, 11, 22, 01, 12, 02) and a push for the coefficients around it,
/// and for each end what goes with the room for jerk.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct IntervalSums {
    pub matrix: [LanePair; 6],
    pub push: [LanePair; 3],
    pub turned: [[LanePair; 3]; 2],
    pub weight: [LanePair; 2],
    pub pushes: [LanePair; 2],
}

/// How far a step may be gone: the largest falls of slacks and of prices, as shares below zero.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct StepReach {
    slacks: LanePair,
    prices: LanePair,
}

impl ConstraintRow {
    /// Takes the step of the price; the weight of the row, and the inverse of its slack.
    #[inline(always)]
    pub fn take(
        &mut self,
        slack: LanePair,
        dual: LanePair,
        tally: &mut SlackTally,
    ) -> [LanePair; 2] {
        let price = self.price * (LanePair::both(1.0) + dual * self.change);
        let product = slack * price;
        let w = LanePair::both(1.0) / product;
        tally.least = tally.least.min(slack);
        tally.open += product;
        (self.price, self.change) = (price, w);
        let inverse = w * price;
        [inverse * price, inverse]
    }

    /// The slack changes: how the price does, then.
    #[inline(always)]
    pub fn reach(&mut self, by: LanePair, mu: LanePair, reach: &mut StepReach) {
        let w = self.change;
        let share = by * (self.price * w);
        let change = mu * w - share - LanePair::both(1.0);
        reach.slacks = reach.slacks.min(share);
        reach.prices = reach.prices.min(change);
        self.change = change;
    }

    /// The price to begin with.
    pub fn begin(&mut self, slack: LanePair, mu: f64, how: NewtonStart, tally: &mut SlackTally) {
        let least = LanePair::both(mu) / slack;
        self.price = match how {
            NewtonStart::Far => least,
            NewtonStart::Near => least.max(self.price),
        };
        self.change = LanePair::default();
        tally.least = tally.least.min(slack);
    }
}

impl SlackTally {
    pub fn new() -> SlackTally {
        SlackTally { least: LanePair::both(f64::INFINITY), open: LanePair::default() }
    }

    /// The least slack.
    pub fn least(&self) -> f64 {
        self.least.least()
    }

    /// By how much the time may be above the least, s.
    pub fn open(&self) -> f64 {
        self.open.sum()
    }
}

impl StepReach {
    /// The least change of a slack and of a price, as shares of them.
    pub fn least(&self) -> [f64; 2] {
        [self.slacks.least(), self.prices.least()]
    }
}

impl AccelerationRows {
    /// The acceleration by two coefficients, or their step.
    #[inline(always)]
    pub fn along(&self, c: [LanePair; 3]) -> LanePair {
        let [x, y] = self.slope;
        x * c[0] + y * c[1]
    }

    #[inline(always)]
    pub fn reach(
        &mut self,
        step: [LanePair; 3],
        more: LanePair,
        mu: LanePair,
        reach: &mut StepReach,
    ) {
        let used = self.along(step);
        let [above, below] = &mut self.rows;
        above.reach(more - used, mu, reach);
        below.reach(more + used, mu, reach);
    }

    pub fn begin(
        &mut self,
        c: [LanePair; 3],
        room: LanePair,
        mu: f64,
        how: NewtonStart,
        tally: &mut SlackTally,
    ) {
        let used = self.along(c);
        let [above, below] = &mut self.rows;
        above.begin(room - used, mu, how, tally);
        below.begin(room + used, mu, how, tally);
    }
}

impl JerkRows {
    /// The jerk at an end by three coefficients, or their step.
    #[inline(always)]
    pub fn along(&self, end: usize, c: [LanePair; 3]) -> LanePair {
        let [p, q, r] = self.slope[end];
        p * c[0] + q * c[1] + r * c[2]
    }

    #[inline(always)]
    pub fn reach(
        &mut self,
        step: [LanePair; 3],
        more: [LanePair; 2],
        mu: LanePair,
        reach: &mut StepReach,
    ) {
        for end in 0..2 {
            let used = self.along(end, step);
            let [above, below] = &mut self.rows[end];
            above.reach(more[end] - used, mu, reach);
            below.reach(more[end] + used, mu, reach);
        }
    }

    pub fn begin(
        &mut self,
        c: [LanePair; 3],
        room: [LanePair; 2],
        mu: f64,
        how: NewtonStart,
        tally: &mut SlackTally,
    ) {
        for end in 0..2 {
            let used = self.along(end, c);
            let [above, below] = &mut self.rows[end];
            above.begin(room[end] - used, mu, how, tally);
            below.begin(room[end] + used, mu, how, tally);
        }
    }
}

impl NodeSums {
    /// The rows of all axes.
    #[inline(never)]
    pub fn of(
        pulls: &mut [AccelerationRows],
        c: [LanePair; 3],
        room: LanePair,
        dual: LanePair,
        tally: &mut SlackTally,
    ) -> NodeSums {
        let (mut of, mut own) = (NodeSums::default(), *tally);
        for pull in pulls {
            let used = pull.along(c);
            let [x, y] = pull.slope;
            let [above, below] = &mut pull.rows;
            let [over, over_inverse] = above.take(room - used, dual, &mut own);
            let [under, under_inverse] = below.take(room + used, dual, &mut own);
            let weight = over + under;
            let turned = over - under;
            let push = over_inverse - under_inverse;
            let (wx, wy) = (weight * x, weight * y);
            of.matrix[0] += wx * x;
            of.matrix[1] += wy * y;
            of.matrix[2] += wx * y;
            of.push[0] += push * x;
            of.push[1] += push * y;
            of.turned[0] += turned * x;
            of.turned[1] += turned * y;
            of.weight += weight;
            of.pushes += over_inverse + under_inverse;
        }
        *tally = own;
        of
    }
}

impl IntervalSums {
    /// The rows of all axes, in three rounds: what is summed up in one has room in the registers.
    #[inline(never)]
    pub fn of(
        bends: &mut [JerkRows],
        c: [LanePair; 3],
        room: [LanePair; 2],
        dual: LanePair,
        tally: &mut SlackTally,
    ) -> IntervalSums {
        let (mut of, mut own) = (IntervalSums::default(), *tally);
        let mut weights = [[[LanePair::default(); 3]; 2]; AXES];
        for (bend, weights) in bends.iter_mut().zip(&mut weights) {
            for end in 0..2 {
                let used = bend.along(end, c);
                let [above, below] = &mut bend.rows[end];
                let [over, over_inverse] = above.take(room[end] - used, dual, &mut own);
                let [under, under_inverse] = below.take(room[end] + used, dual, &mut own);
                let weight = over + under;
                weights[end] = [weight, over - under, over_inverse - under_inverse];
                of.weight[end] += weight;
                of.pushes[end] += over_inverse + under_inverse;
            }
        }
        *tally = own;
        for (bend, weights) in bends.iter().zip(&weights) {
            for (&[p, q, r], &[weight, ..]) in bend.slope.iter().zip(weights) {
                let (wp, wq) = (weight * p, weight * q);
                of.matrix[0] += wp * p;
                of.matrix[1] += wq * q;
                of.matrix[2] += weight * r * r;
                of.matrix[3] += wp * q;
                of.matrix[4] += wq * r;
                of.matrix[5] += wp * r;
            }
        }
        for (bend, weights) in bends.iter().zip(&weights) {
            for end in 0..2 {
                let [_, turned, push] = weights[end];
                for (part, slope) in bend.slope[end].into_iter().enumerate() {
                    of.turned[end][part] += turned * slope;
                    of.push[part] += push * slope;
                }
            }
        }
        of
    }
}
