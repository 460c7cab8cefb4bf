//! The rows of limits: their slacks, their prices, and what they add to a step.
//!
//! A row says that a sum of the three coefficients around a cell, and of its elastic share, stays below a
//! limit. The rows of two cells are worked on at once. There are two passes for each step. The first takes
//! the prices that the step before has found, works out the slacks, and sums up matrix and side; the second
//! finds how far the step may be gone. One division serves both: w = 1/(slack · price), so 1/slack = w · price.

#![allow(
    clippy::needless_range_loop,
    reason = "the number of an end runs through several lists at once"
)]

use chordal_geometry::AXES;

use super::how::Begin;
use super::lanes::Two;

/// A row of each of two cells. Between the passes of a step `change` is w, after them how the price changes,
/// as a share of it.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Row {
    pub price: Two,
    pub change: Two,
}

/// The acceleration of an axis at a node.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Pull {
    /// By the coefficients before and after the node.
    pub slope: [Two; 2],
    /// Above and below.
    pub rows: [Row; 2],
}

/// The jerk of an axis at both ends of a cell.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Bend {
    /// For each end by the three coefficients around the cell.
    pub slope: [[Two; 3]; 2],
    /// For each end above and below.
    pub rows: [[Row; 2]; 2],
}

/// What is summed up over all rows.
#[derive(Clone, Copy, Debug)]
pub(super) struct Tally {
    least: Two,
    open: Two,
}

/// What the accelerations at a node add: a matrix (00, 11, 01) and a push for the coefficients before and after
/// it, and what goes with the elastic share.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct OfNode {
    pub matrix: [Two; 3],
    pub push: [Two; 2],
    pub turned: [Two; 2],
    pub weight: Two,
    pub pushes: Two,
}

/// What the jerks on a cell add: a matrix (00, 11, 22, 01, 12, 02) and a push for the coefficients around it,
/// and for each end what goes with the room for jerk.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct OfCell {
    pub matrix: [Two; 6],
    pub push: [Two; 3],
    pub turned: [[Two; 3]; 2],
    pub weight: [Two; 2],
    pub pushes: [Two; 2],
}

/// How far a step may be gone: the largest falls of slacks and of prices, as shares below zero.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Reach {
    slacks: Two,
    prices: Two,
}

impl Row {
    /// Takes the step of the price; the weight of the row, and the inverse of its slack.
    #[inline(always)]
    pub fn take(&mut self, slack: Two, dual: Two, tally: &mut Tally) -> [Two; 2] {
        let price = self.price * (Two::both(1.0) + dual * self.change);
        let product = slack * price;
        let w = Two::both(1.0) / product;
        tally.least = tally.least.min(slack);
        tally.open += product;
        (self.price, self.change) = (price, w);
        let inverse = w * price;
        [inverse * price, inverse]
    }

    /// The slack changes: how the price does, then.
    #[inline(always)]
    pub fn reach(&mut self, by: Two, mu: Two, reach: &mut Reach) {
        let w = self.change;
        let share = by * (self.price * w);
        let change = mu * w - share - Two::both(1.0);
        reach.slacks = reach.slacks.min(share);
        reach.prices = reach.prices.min(change);
        self.change = change;
    }

    /// The price to begin with.
    pub fn begin(&mut self, slack: Two, mu: f64, how: Begin, tally: &mut Tally) {
        let least = Two::both(mu) / slack;
        self.price = match how {
            Begin::Far => least,
            Begin::Near => least.max(self.price),
        };
        self.change = Two::default();
        tally.least = tally.least.min(slack);
    }
}

impl Tally {
    pub fn new() -> Tally {
        Tally { least: Two::both(f64::INFINITY), open: Two::default() }
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

impl Reach {
    /// The least change of a slack and of a price, as shares of them.
    pub fn least(&self) -> [f64; 2] {
        [self.slacks.least(), self.prices.least()]
    }
}

impl Pull {
    /// The acceleration by two coefficients, or their step.
    #[inline(always)]
    pub fn along(&self, c: [Two; 3]) -> Two {
        let [x, y] = self.slope;
        x * c[0] + y * c[1]
    }

    #[inline(always)]
    pub fn reach(&mut self, step: [Two; 3], more: Two, mu: Two, reach: &mut Reach) {
        let used = self.along(step);
        let [above, below] = &mut self.rows;
        above.reach(more - used, mu, reach);
        below.reach(more + used, mu, reach);
    }

    pub fn begin(&mut self, c: [Two; 3], room: Two, mu: f64, how: Begin, tally: &mut Tally) {
        let used = self.along(c);
        let [above, below] = &mut self.rows;
        above.begin(room - used, mu, how, tally);
        below.begin(room + used, mu, how, tally);
    }
}

impl Bend {
    /// The jerk at an end by three coefficients, or their step.
    #[inline(always)]
    pub fn along(&self, end: usize, c: [Two; 3]) -> Two {
        let [p, q, r] = self.slope[end];
        p * c[0] + q * c[1] + r * c[2]
    }

    #[inline(always)]
    pub fn reach(&mut self, step: [Two; 3], more: [Two; 2], mu: Two, reach: &mut Reach) {
        for end in 0..2 {
            let used = self.along(end, step);
            let [above, below] = &mut self.rows[end];
            above.reach(more[end] - used, mu, reach);
            below.reach(more[end] + used, mu, reach);
        }
    }

    pub fn begin(&mut self, c: [Two; 3], room: [Two; 2], mu: f64, how: Begin, tally: &mut Tally) {
        for end in 0..2 {
            let used = self.along(end, c);
            let [above, below] = &mut self.rows[end];
            above.begin(room[end] - used, mu, how, tally);
            below.begin(room[end] + used, mu, how, tally);
        }
    }
}

impl OfNode {
    /// The rows of all axes.
    #[inline(never)]
    pub fn of(pulls: &mut [Pull], c: [Two; 3], room: Two, dual: Two, tally: &mut Tally) -> OfNode {
        let (mut of, mut own) = (OfNode::default(), *tally);
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

impl OfCell {
    /// The rows of all axes, in three rounds: what is summed up in one has room in the registers.
    #[inline(never)]
    pub fn of(
        bends: &mut [Bend],
        c: [Two; 3],
        room: [Two; 2],
        dual: Two,
        tally: &mut Tally,
    ) -> OfCell {
        let (mut of, mut own) = (OfCell::default(), *tally);
        let mut found = [[[Two::default(); 3]; 2]; AXES];
        for (bend, found) in bends.iter_mut().zip(&mut found) {
            for end in 0..2 {
                let used = bend.along(end, c);
                let [above, below] = &mut bend.rows[end];
                let [over, over_inverse] = above.take(room[end] - used, dual, &mut own);
                let [under, under_inverse] = below.take(room[end] + used, dual, &mut own);
                let weight = over + under;
                found[end] = [weight, over - under, over_inverse - under_inverse];
                of.weight[end] += weight;
                of.pushes[end] += over_inverse + under_inverse;
            }
        }
        *tally = own;
        for (bend, found) in bends.iter().zip(&found) {
            for (&[p, q, r], &[weight, ..]) in bend.slope.iter().zip(found) {
                let (wp, wq) = (weight * p, weight * q);
                of.matrix[0] += wp * p;
                of.matrix[1] += wq * q;
                of.matrix[2] += weight * r * r;
                of.matrix[3] += wp * q;
                of.matrix[4] += wq * r;
                of.matrix[5] += wp * r;
            }
        }
        for (bend, found) in bends.iter().zip(&found) {
            for end in 0..2 {
                let [_, turned, push] = found[end];
                for (part, slope) in bend.slope[end].into_iter().enumerate() {
                    of.turned[end][part] += turned * slope;
                    of.push[part] += push * slope;
                }
            }
        }
        of
    }
}
