//! The rows of limits: their slacks, their prices, and what they add to a step.
//!
//! A row says that a sum of the three coefficients around a cell, and of its elastic share, stays below a
//! limit. Rows for both signs of one value share their factors and are worked on together, those of the
//! jerk for both ends of a cell as well.

#![allow(
    clippy::needless_range_loop,
    reason = "several arrays are worked on by end or sign at once"
)]

use super::begin::Begin;
use super::{NEAR, Newton};

/// No step takes away more of a coefficient.
const MOST_FALL: f64 = 0.8;

/// One limit: of a velocity.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Row {
    slack: f64,
    price: f64,
    /// How the price changes in the step, as a share of it.
    change: f64,
}

/// The acceleration of an axis at a node; everything but the slope by sign.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Pull {
    /// By the coefficients before and after the node.
    pub slope: [f64; 2],
    slack: [f64; 2],
    price: [f64; 2],
    change: [f64; 2],
}

/// The jerk of an axis at both ends of a cell: everything by end, and all but the slope by sign.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Bend {
    /// By the three coefficients around the cell.
    pub slope: [[f64; 2]; 3],
    slack: [[f64; 2]; 2],
    price: [[f64; 2]; 2],
    change: [[f64; 2]; 2],
}

/// How the room of both ends of a cell for jerk changes: by coefficient, and by the elastic share.
#[derive(Clone, Copy, Debug)]
struct Room {
    slope: [[f64; 2]; 3],
    elastic: [f64; 2],
    /// The room itself.
    whole: [f64; 2],
}

/// What the rows around a cell add to the step: a matrix (00, 11, 22, 01, 12, 02) and a right side, and the
/// same of the elastic share.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Sums {
    pub matrix: [f64; 6],
    pub side: [f64; 3],
    mixed: [f64; 3],
    pub own: f64,
    pub own_side: f64,
}

/// How far a step may be gone, as inverses: by slacks, and by prices.
#[derive(Clone, Copy, Debug, Default)]
struct Reach {
    slacks: f64,
    prices: f64,
}

/// Like `f64::max` for numbers, in one instruction.
#[inline(always)]
fn larger(one: f64, other: f64) -> f64 {
    if one > other { one } else { other }
}

impl Reach {
    /// A row whose slack changes; how its price does.
    #[inline(always)]
    fn add(&mut self, slack: f64, price: f64, by: f64, mu: f64) -> f64 {
        let inverse = 1.0 / (slack * price);
        let change = by * price * inverse;
        let of_price = mu * inverse - change - 1.0;
        self.slacks = larger(self.slacks, -change);
        self.prices = larger(self.prices, -of_price);
        of_price
    }
}

impl Bend {
    /// The jerk at both ends by three coefficients, or their step.
    #[inline(always)]
    pub(super) fn along(&self, c: &[f64; 3]) -> [f64; 2] {
        let [p, q, r] = &self.slope;
        std::array::from_fn(|end| p[end] * c[0] + q[end] * c[1] + r[end] * c[2])
    }
}

impl Sums {
    /// One row that has no elastic share.
    #[inline(always)]
    fn add(&mut self, row: &Row, [x, y]: [f64; 2], mu: f64) {
        let inverse = 1.0 / row.slack;
        let (weight, push) = (row.price * inverse, mu * inverse);
        self.matrix[0] += weight * x * x;
        self.matrix[1] += weight * y * y;
        self.matrix[3] += weight * x * y;
        self.side[0] -= push * x;
        self.side[1] -= push * y;
    }

    /// Eliminates the elastic share: by the steps of the three coefficients, and by itself.
    pub(super) fn fold(&mut self) -> ([f64; 3], f64) {
        let inverse = 1.0 / self.own;
        let mixed = self.mixed;
        let f = mixed.map(|value| value * inverse);
        self.matrix[0] -= f[0] * mixed[0];
        self.matrix[1] -= f[1] * mixed[1];
        self.matrix[2] -= f[2] * mixed[2];
        self.matrix[3] -= f[0] * mixed[1];
        self.matrix[4] -= f[1] * mixed[2];
        self.matrix[5] -= f[0] * mixed[2];
        for (side, f) in self.side.iter_mut().zip(&f) {
            *side -= f * self.own_side;
        }
        (f, self.own_side * inverse)
    }
}

impl Newton {
    /// The nodes with rows: those between two coefficients that are given have none.
    fn has_node_rows(&self, node: usize) -> bool {
        node >= self.first && node <= self.last + 1
    }

    fn has_cell_rows(&self, k: usize) -> bool {
        k + 1 >= self.first && k <= self.last + 1 && k < self.count - 1
    }

    fn has_cap(&self, k: usize) -> bool {
        (self.first..=self.last).contains(&k)
    }

    pub(super) fn count_rows(&self) -> usize {
        let nodes = (1..self.count).filter(|k| self.has_node_rows(*k)).count();
        let cells = (1..self.count).filter(|k| self.has_cell_rows(*k)).count();
        nodes * (1 + 2 * self.axes) + cells * 4 * self.axes + (self.last + 1 - self.first)
    }

    /// The elastic share of a cell; the last node has none.
    fn elastic_at(&self, k: usize) -> f64 {
        if k < self.count - 1 { self.elastic[k] } else { 0.0 }
    }

    #[inline(always)]
    fn room(&self, k: usize) -> Room {
        let limit = self.limits[k];
        let elastic = 1.0 + self.elastic[k];
        let roots = [self.root[k], self.root[k + 1]];
        let whole = roots.map(|root| limit * elastic * root);
        let fall = roots.map(|root| 0.5 * limit * elastic * root * root * root);
        Room {
            slope: [
                [fall[0] * self.before[k], 0.0],
                [fall[0] * self.after[k], fall[1] * self.before[k + 1]],
                [0.0, fall[1] * self.after[k + 1]],
            ],
            elastic: roots.map(|root| -limit * root),
            whole,
        }
    }

    /// Works out all slacks; the least of them.
    pub(super) fn slacks(&mut self) -> f64 {
        let (n, axes) = (self.count, self.axes);
        let mut least = [f64::INFINITY; 2];
        for k in 1..n {
            if self.has_node_rows(k) {
                let (c0, c1) = (self.c[k - 1], self.c[k]);
                let slack = 1.0 - self.b[k] / self.cap[k];
                self.cap_rows[k].slack = slack;
                least[0] = least[0].min(slack);
                let room = self.shares[k] * (1.0 + self.elastic_at(k));
                for pull in &mut self.pulls[k * axes..(k + 1) * axes] {
                    let used = pull.slope[0] * c0 + pull.slope[1] * c1;
                    pull.slack = [room - used, room + used];
                    let slack = room - used.abs();
                    least[0] = if slack < least[0] { slack } else { least[0] };
                }
            }
            if self.has_cap(k) {
                let slack = 1.0 - self.c[k] / self.cell_cap[k];
                self.cell_cap_rows[k].slack = slack;
                least[0] = least[0].min(slack);
            }
            if self.has_cell_rows(k) {
                let c = [self.c[k - 1], self.c[k], self.c[k + 1]];
                let room = self.room(k).whole;
                for bend in &mut self.bends[k * axes..(k + 1) * axes] {
                    let used = bend.along(&c);
                    for end in 0..2 {
                        bend.slack[0][end] = room[end] - used[end];
                        bend.slack[1][end] = room[end] + used[end];
                        let slack = room[end] - used[end].abs();
                        least[end] = if slack < least[end] { slack } else { least[end] };
                    }
                }
            }
        }
        least[0].min(least[1])
    }

    /// The prices with which the steps begin.
    pub(super) fn begin_prices(&mut self, mu: f64, how: Begin) {
        let (n, axes) = (self.count, self.axes);
        let price = |slack: f64, price: f64| match how {
            Begin::Far => mu / slack,
            Begin::Near => price.max(mu / slack),
        };
        for k in 1..n {
            if self.has_node_rows(k) {
                let row = &mut self.cap_rows[k];
                row.price = price(row.slack, row.price);
                for pull in &mut self.pulls[k * axes..(k + 1) * axes] {
                    pull.price = [0, 1].map(|sign| price(pull.slack[sign], pull.price[sign]));
                }
            }
            if self.has_cap(k) {
                let row = &mut self.cell_cap_rows[k];
                row.price = price(row.slack, row.price);
            }
            if self.has_cell_rows(k) {
                for bend in &mut self.bends[k * axes..(k + 1) * axes] {
                    for (prices, slacks) in bend.price.iter_mut().zip(&bend.slack) {
                        *prices = [0, 1].map(|end| price(slacks[end], prices[end]));
                    }
                }
            }
        }
    }

    /// By how much the time may be above the least, s.
    pub(super) fn open(&self) -> f64 {
        let (n, axes) = (self.count, self.axes);
        let mut open = [0.0; 2];
        for k in 1..n {
            if self.has_node_rows(k) {
                let row = &self.cap_rows[k];
                open[0] += row.slack * row.price;
                for pull in &self.pulls[k * axes..(k + 1) * axes] {
                    for sign in 0..2 {
                        open[sign] += pull.slack[sign] * pull.price[sign];
                    }
                }
            }
            if self.has_cap(k) {
                let row = &self.cell_cap_rows[k];
                open[0] += row.slack * row.price;
            }
            if self.has_cell_rows(k) {
                for bend in &self.bends[k * axes..(k + 1) * axes] {
                    for end in 0..2 {
                        open[end] += bend.slack[0][end] * bend.price[0][end]
                            + bend.slack[1][end] * bend.price[1][end];
                    }
                }
            }
            if k < n - 1 {
                open[0] += self.elastic[k] * self.elastic_price[k];
            }
        }
        open[0] + open[1]
    }

    /// What the rows of a node add to the step.
    #[inline(always)]
    pub(super) fn add_node(&self, k: usize, mu: f64, sums: &mut Sums) {
        if !self.has_node_rows(k) {
            return;
        }
        let cap = 1.0 / self.cap[k];
        sums.add(&self.cap_rows[k], [self.before[k] * cap, self.after[k] * cap], mu);
        let (mut weights, mut pushes, mut turned) = (0.0, 0.0, [0.0; 2]);
        for pull in &self.pulls[k * self.axes..(k + 1) * self.axes] {
            let [x, y] = pull.slope;
            let inverse = pull.slack.map(|slack| 1.0 / slack);
            let weight = [pull.price[0] * inverse[0], pull.price[1] * inverse[1]];
            let (sum, more) = (weight[0] + weight[1], weight[0] - weight[1]);
            sums.matrix[0] += sum * x * x;
            sums.matrix[1] += sum * y * y;
            sums.matrix[3] += sum * x * y;
            let push = mu * (inverse[0] - inverse[1]);
            sums.side[0] -= push * x;
            sums.side[1] -= push * y;
            turned[0] += more * x;
            turned[1] += more * y;
            weights += sum;
            pushes += mu * (inverse[0] + inverse[1]);
        }
        if k < self.count - 1 {
            let limit = self.shares[k];
            sums.mixed[0] -= limit * turned[0];
            sums.mixed[1] -= limit * turned[1];
            sums.own += limit * limit * weights;
            sums.own_side += limit * pushes;
        }
    }

    /// What the rows of a cell add to the step.
    #[inline(always)]
    pub(super) fn add_cell(&self, k: usize, mu: f64, sums: &mut Sums) {
        if self.has_cap(k) {
            sums.add(&self.cell_cap_rows[k], [0.0, 1.0 / self.cell_cap[k]], mu);
        }
        if !self.has_cell_rows(k) {
            return;
        }
        let (mut matrix, mut side, mut turned) = ([[0.0; 2]; 6], [[0.0; 2]; 3], [[0.0; 2]; 3]);
        let (mut weights, mut pushes) = ([0.0; 2], [0.0; 2]);
        for bend in &self.bends[k * self.axes..(k + 1) * self.axes] {
            let [p, q, r] = &bend.slope;
            for end in 0..2 {
                let inverse = [1.0 / bend.slack[0][end], 1.0 / bend.slack[1][end]];
                let weight = [bend.price[0][end] * inverse[0], bend.price[1][end] * inverse[1]];
                let (sum, more) = (weight[0] + weight[1], weight[0] - weight[1]);
                let (sp, sq, sr) = (sum * p[end], sum * q[end], sum * r[end]);
                matrix[0][end] += sp * p[end];
                matrix[1][end] += sq * q[end];
                matrix[2][end] += sr * r[end];
                matrix[3][end] += sp * q[end];
                matrix[4][end] += sq * r[end];
                matrix[5][end] += sp * r[end];
                turned[0][end] += more * p[end];
                turned[1][end] += more * q[end];
                turned[2][end] += more * r[end];
                let push = mu * (inverse[0] - inverse[1]);
                side[0][end] += push * p[end];
                side[1][end] += push * q[end];
                side[2][end] += push * r[end];
                weights[end] += sum;
                pushes[end] += mu * (inverse[0] + inverse[1]);
            }
        }
        let room = self.room(k);
        for end in 0..2 {
            let slope = room.slope.map(|slope| slope[end]);
            let turned = turned.map(|turned| turned[end]);
            let (sum, elastic) = (weights[end], room.elastic[end]);
            const PLACES: [[usize; 2]; 6] = [[0, 0], [1, 1], [2, 2], [0, 1], [1, 2], [0, 2]];
            for (value, (own, [i, j])) in sums.matrix.iter_mut().zip(matrix.iter().zip(PLACES)) {
                *value += own[end]
                    + sum * slope[i] * slope[j]
                    + turned[i] * slope[j]
                    + slope[i] * turned[j];
            }
            for i in 0..3 {
                sums.mixed[i] += elastic * (turned[i] + sum * slope[i]);
                sums.side[i] -= side[i][end] + pushes[end] * slope[i];
            }
            sums.own += sum * elastic * elastic;
            sums.own_side -= pushes[end] * elastic;
        }
    }

    /// How far the step may be gone: by the slacks, and by their prices.
    pub(super) fn reach(&mut self, mu: f64) -> (f64, f64) {
        let (n, axes) = (self.count, self.axes);
        let mut reaches = [Reach::default(); 2];
        for k in 1..n {
            let is_cell = k < n - 1;
            let next = if is_cell { self.step[k + 1] } else { 0.0 };
            let step = [self.step[k - 1], self.step[k], next];
            let elastic = if is_cell { self.elastic_step[k] } else { 0.0 };
            if self.has_node_rows(k) {
                let by = -(self.before[k] * step[0] + self.after[k] * step[1]) / self.cap[k];
                let row = &mut self.cap_rows[k];
                row.change = reaches[0].add(row.slack, row.price, by, mu);
                let room = self.shares[k] * elastic;
                for pull in &mut self.pulls[k * axes..(k + 1) * axes] {
                    let used = pull.slope[0] * step[0] + pull.slope[1] * step[1];
                    let by = [room - used, room + used];
                    for sign in 0..2 {
                        pull.change[sign] =
                            reaches[sign].add(pull.slack[sign], pull.price[sign], by[sign], mu);
                    }
                }
            }
            if self.has_cap(k) {
                let row = &mut self.cell_cap_rows[k];
                row.change = reaches[0].add(row.slack, row.price, -step[1] / self.cell_cap[k], mu);
            }
            if self.has_cell_rows(k) {
                let room = self.room(k);
                let [p, q, r] = &room.slope;
                let more: [f64; 2] = std::array::from_fn(|end| {
                    let falls = p[end] * step[0] + q[end] * step[1] + r[end] * step[2];
                    -(falls + room.elastic[end] * elastic)
                });
                for bend in &mut self.bends[k * axes..(k + 1) * axes] {
                    let used = bend.along(&step);
                    for end in 0..2 {
                        let (slack, price) = (&bend.slack, &bend.price);
                        bend.change[0][end] = reaches[end].add(
                            slack[0][end],
                            price[0][end],
                            more[end] - used[end],
                            mu,
                        );
                        bend.change[1][end] = reaches[end].add(
                            slack[1][end],
                            price[1][end],
                            more[end] + used[end],
                            mu,
                        );
                    }
                }
            }
            if is_cell {
                reaches[0].add(self.elastic[k], self.elastic_price[k], elastic, mu);
            }
        }
        let fall =
            (self.first..=self.last).fold(0.0_f64, |most, k| most.max(-self.step[k] / self.c[k]));
        let share = |most: f64, near: f64| if most > near { near / most } else { 1.0 };
        let [one, other] = reaches;
        let slacks = share(one.slacks.max(other.slacks), NEAR).min(share(fall, MOST_FALL));
        (slacks, share(one.prices.max(other.prices), NEAR))
    }

    /// Takes the step of all prices.
    pub(super) fn advance_prices(&mut self, mu: f64, dual: f64) {
        let (n, axes) = (self.count, self.axes);
        for k in 1..n {
            if self.has_node_rows(k) {
                let row = &mut self.cap_rows[k];
                row.price *= 1.0 + dual * row.change;
                for pull in &mut self.pulls[k * axes..(k + 1) * axes] {
                    for sign in 0..2 {
                        pull.price[sign] *= 1.0 + dual * pull.change[sign];
                    }
                }
            }
            if self.has_cap(k) {
                let row = &mut self.cell_cap_rows[k];
                row.price *= 1.0 + dual * row.change;
            }
            if self.has_cell_rows(k) {
                for bend in &mut self.bends[k * axes..(k + 1) * axes] {
                    for (prices, changes) in bend.price.iter_mut().zip(&bend.change) {
                        for end in 0..2 {
                            prices[end] *= 1.0 + dual * changes[end];
                        }
                    }
                }
            }
            if k < n - 1 {
                let (t, price) = (self.elastic[k], self.elastic_price[k]);
                self.elastic_price[k] += dual * ((mu - price * self.elastic_step[k]) / t - price);
            }
        }
    }
}
