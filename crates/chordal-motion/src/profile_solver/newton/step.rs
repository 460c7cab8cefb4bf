//! A Newton step: a matrix of five diagonals, and its solution.
//!
//! The right side is a sum of two: what the time asks for, and, times μ, what keeps the slacks open. Both are
//! solved for at once, so that μ can be chosen when the matrix is known.

use super::lanes::LanePair;
use super::rows::{ConstraintRow, IntervalSums, NodeSums, SlackTally, StepReach};
use super::{NewtonSolver, WALL_STEP_SHARE};

/// No step takes away more of a coefficient.
const MAX_COEFFICIENT_FALL: f64 = 0.8;

/// Two intervals that follow each other, and the nodes at which they begin. Where there is no interval, or a node has no
/// limits, all slopes are nothing.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct IntervalPair {
    /// b at the node by the coefficients before and after it.
    pub node: [LanePair; 2],
    /// b at both ends of the interval, by the first two and by the last two of the coefficients around it.
    pub ends: [[LanePair; 2]; 2],
    pub length: LanePair,
    /// The length of an interval next to a rest that ends or begins at the node.
    pub rest: LanePair,
    /// What may be used of the acceleration at the node, and of the jerk on the interval.
    pub share: LanePair,
    pub limit: LanePair,
    /// The inverses of the largest b at the node and coefficient of the interval, and their rows.
    pub caps: [LanePair; 2],
    pub cap_rows: [ConstraintRow; 2],
    pub elastic: LanePair,
    pub elastic_row: ConstraintRow,
    elastic_step: LanePair,
    folded: EliminatedShare,
}

/// A row of the matrix, from the diagonal on, and its right sides; once it is factored what the next two
/// unknowns take away, and the solution so far.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct BandRow {
    diagonals: [f64; 3],
    sides: [f64; 2],
}

/// What eliminates the elastic share of an interval: its step is `own` less these shares of the steps around it.
#[derive(Clone, Copy, Debug, Default)]
struct EliminatedShare {
    shares: [LanePair; 3],
    own: [LanePair; 2],
}

/// The state of the steps.
#[derive(Clone, Copy, Debug)]
pub(super) struct NewtonIterate {
    pub time: f64,
    /// By how much that may be above the least, s.
    pub open: f64,
    /// The least slack.
    pub least: f64,
}

/// What an interval and its node add to the step: a matrix (00, 11, 22, 01, 12, 02) and both sides of three
/// coefficients.
#[derive(Clone, Copy, Debug, Default)]
struct StepSums {
    matrix: [LanePair; 6],
    sides: [[LanePair; 3]; 2],
    /// The same of the elastic share.
    mixed: [LanePair; 3],
    own: LanePair,
    own_sides: [LanePair; 2],
}

impl IntervalPair {
    /// The room for jerk at both ends, with these 1/√b.
    #[inline(always)]
    pub fn room(&self, roots: [LanePair; 2]) -> [LanePair; 2] {
        let limit = self.limit * (LanePair::both(1.0) + self.elastic);
        roots.map(|root| limit * root)
    }

    /// How far the step may be gone: by the rows that have no axis.
    #[inline(always)]
    fn reach(&mut self, step: [LanePair; 3], mu: LanePair, reach: &mut StepReach) {
        let by = self.node[0] * step[0] + self.node[1] * step[1];
        let [node, interval] = &mut self.cap_rows;
        let none = LanePair::default();
        node.reach(none - by * self.caps[0], mu, reach);
        interval.reach(none - step[1] * self.caps[1], mu, reach);
        self.elastic_row.reach(self.elastic_step, mu, reach);
    }
}

impl StepSums {
    /// The rows of the node, all but what goes by its b.
    #[inline(always)]
    fn of_node(block: &IntervalPair, rows: &NodeSums) -> StepSums {
        let none = LanePair::default();
        let [m00, m11, m01] = rows.matrix;
        let limit = none - block.share;
        let [x, y] = rows.turned.map(|turned| limit * turned);
        StepSums {
            matrix: [m00, m11, none, m01, none, none],
            sides: [[none; 3], [none - rows.push[0], none - rows.push[1], none]],
            mixed: [x, y, none],
            own: block.share * block.share * rows.weight,
            own_sides: [none, block.share * rows.pushes],
        }
    }

    /// The rows of the interval, with all that goes by b at its ends: curvature, and both sides.
    #[inline(always)]
    fn add_interval(
        &mut self,
        block: &IntervalPair,
        rows: &IntervalSums,
        of_ends: [[LanePair; 3]; 2],
        falls: [LanePair; 2],
    ) {
        for end in 0..2 {
            let [own, by_time, by_room] = of_ends[end];
            let [x, y] = block.ends[end];
            let turned = rows.turned[end].map(|turned| falls[end] * turned);
            // The coefficients that b goes by, and the other one.
            let (i, j, other) = (end, end + 1, 2 - 2 * end);
            // The places of ii, jj, ij, and of both with the other one.
            let [ii, jj, ij, io, jo] = if end == 0 { [0, 1, 3, 5, 4] } else { [1, 2, 4, 3, 5] };
            let (tx, ty) = (own * x + turned[i], own * y + turned[j]);
            self.matrix[ii] += x * (tx + turned[i]);
            self.matrix[jj] += y * (ty + turned[j]);
            self.matrix[ij] += x * ty + y * turned[i];
            self.matrix[io] += x * turned[other];
            self.matrix[jo] += y * turned[other];
            for (side, by) in self.sides.iter_mut().zip([by_time, by_room]) {
                side[i] += x * by;
                side[j] += y * by;
            }
        }
        for (value, more) in self.matrix.iter_mut().zip(rows.matrix) {
            *value += more;
        }
        for (value, push) in self.sides[1].iter_mut().zip(rows.push) {
            *value -= push;
        }
    }

    /// What the elastic share of the interval has to do with its jerk.
    #[inline(always)]
    fn add_elastic(
        &mut self,
        block: &IntervalPair,
        rows: &IntervalSums,
        roots: [LanePair; 2],
        falls: [LanePair; 2],
    ) {
        for end in 0..2 {
            let limit = block.limit * roots[end];
            let [x, y] = block.ends[end];
            let of_room = rows.weight[end] * falls[end];
            let turned = rows.turned[end];
            self.mixed[end] -= limit * x * of_room;
            self.mixed[end + 1] -= limit * y * of_room;
            for (mixed, turned) in self.mixed.iter_mut().zip(turned) {
                *mixed -= limit * turned;
            }
            self.own += limit * limit * rows.weight[end];
            self.own_sides[1] += limit * rows.pushes[end];
        }
    }

    /// Eliminates the elastic share.
    #[inline(always)]
    fn fold(&mut self) -> EliminatedShare {
        let inverse = LanePair::both(1.0) / self.own;
        let mixed = self.mixed;
        let shares = mixed.map(|value| value * inverse);
        self.matrix[0] -= shares[0] * mixed[0];
        self.matrix[1] -= shares[1] * mixed[1];
        self.matrix[2] -= shares[2] * mixed[2];
        self.matrix[3] -= shares[0] * mixed[1];
        self.matrix[4] -= shares[1] * mixed[2];
        self.matrix[5] -= shares[0] * mixed[2];
        for (sides, own) in self.sides.iter_mut().zip(self.own_sides) {
            for (side, share) in sides.iter_mut().zip(shares) {
                *side -= share * own;
            }
        }
        EliminatedShare { shares, own: self.own_sides.map(|own| own * inverse) }
    }
}

impl NewtonSolver {
    /// The three coefficients around each of two intervals, or their steps.
    #[inline(always)]
    pub(super) fn around(list: &[f64], k: usize) -> [LanePair; 3] {
        [LanePair::at(list, k - 1), LanePair::at(list, k), LanePair::at(list, k + 1)]
    }

    /// Takes the step of the prices, and makes the matrix of the next step and its right sides.
    pub(super) fn assemble(&mut self, price: f64, dual: f64) -> NewtonIterate {
        let axes = self.axes;
        let (mut tally, mut time) = (SlackTally::new(), LanePair::default());
        let (mut here, mut next) = (BandRow::default(), BandRow::default());
        let dual = LanePair::both(dual);
        for index in 0..self.blocks.len() {
            let k = 1 + 2 * index;
            let block = &mut self.blocks[index];
            let c = NewtonSolver::around(&self.c, k);
            let one = LanePair::both(1.0);
            let own = index * axes..(index + 1) * axes;
            let room = block.share * (one + block.elastic);
            let rows = NodeSums::of(&mut self.pulls[own.clone()], c, room, dual, &mut tally);
            let mut sums = StepSums::of_node(block, &rows);
            let squares = [LanePair::at(&self.b, k), LanePair::at(&self.b, k + 1)];
            let roots = [LanePair::at(&self.root, k), LanePair::at(&self.root, k + 1)];
            let room = block.room(roots);
            let rows = IntervalSums::of(&mut self.bends[own], c, room, dual, &mut tally);
            // All that goes by b at the node.
            let mut of_node = [LanePair::default(); 3];
            let [node_cap, interval_cap] = block.caps;
            let [weight, push] =
                block.cap_rows[0].take(one - squares[0] * node_cap, dual, &mut tally);
            of_node[0] += weight * node_cap * node_cap;
            of_node[2] -= push * node_cap;
            let [weight, push] =
                block.cap_rows[1].take(one - c[1] * interval_cap, dual, &mut tally);
            sums.matrix[1] += weight * interval_cap * interval_cap;
            sums.sides[1][1] -= push * interval_cap;
            let rest = block.rest * roots[0];
            let rest_squared = roots[0] * roots[0];
            time += LanePair::both(3.0) * rest;
            of_node[0] += LanePair::both(2.25) * rest * rest_squared * rest_squared;
            of_node[1] += LanePair::both(1.5) * rest * rest_squared;
            let [x, y] = block.node;
            sums.matrix[0] += of_node[0] * x * x;
            sums.matrix[1] += of_node[0] * y * y;
            sums.matrix[3] += of_node[0] * x * y;
            for (side, by) in sums.sides.iter_mut().zip([of_node[1], of_node[2]]) {
                side[0] += x * by;
                side[1] += y * by;
            }
            // All that goes by b at the ends of the interval.
            let speeds = squares[0] * roots[0] + squares[1] * roots[1];
            let s = one / speeds;
            let square = block.length * s * s;
            time += LanePair::both(2.0) * block.length * s;
            let half = LanePair::both(0.5);
            let mut falls = room;
            let mut of_ends = [[LanePair::default(); 3]; 2];
            for end in 0..2 {
                let root = roots[end];
                let squared = root * root;
                let fall = half * room[end] * squared;
                of_ends[end] = [
                    square * squared * (s + half * root) + rows.weight[end] * fall * fall,
                    square * root,
                    LanePair::default() - rows.pushes[end] * fall,
                ];
                falls[end] = fall;
            }
            sums.add_interval(block, &rows, of_ends, falls);
            sums.add_elastic(block, &rows, roots, falls);
            let cross = square * s * roots[0] * roots[1];
            let [[w0, w1], [x0, x1]] = block.ends;
            sums.matrix[1] += LanePair::both(2.0) * cross * w1 * x0;
            sums.matrix[3] += cross * w0 * x0;
            sums.matrix[4] += cross * w1 * x1;
            sums.matrix[5] += cross * w0 * x1;
            let [weight, push] = block.elastic_row.take(block.elastic, dual, &mut tally);
            sums.own += weight;
            sums.own_sides[0] -= LanePair::both(price);
            sums.own_sides[1] += push;
            block.folded = sums.fold();
            let lines = &mut self.lines[k - 1..=k];
            for (lane, line) in lines.iter_mut().enumerate() {
                let of = |two: LanePair| if lane == 0 { two.first() } else { two.second() };
                let [m00, m11, m22, m01, m12, m02] = sums.matrix.map(of);
                here.diagonals[0] += m00;
                here.diagonals[1] += m01;
                here.diagonals[2] += m02;
                let [s0, s1, s2] = [0, 1, 2].map(|i| [of(sums.sides[0][i]), of(sums.sides[1][i])]);
                for side in 0..2 {
                    here.sides[side] += s0[side];
                    next.sides[side] += s1[side];
                }
                *line = here;
                next.diagonals[0] += m11;
                next.diagonals[1] += m12;
                here = next;
                next = BandRow { diagonals: [m22, 0.0, 0.0], sides: s2 };
            }
        }
        let last = 2 * self.blocks.len();
        self.lines[last] = here;
        NewtonIterate { time: time.sum(), open: tally.open(), least: tally.least() }
    }

    /// Factors the matrix, and goes half way to the solution.
    pub(super) fn factor(&mut self) {
        let (n, first, last) = (self.count, self.first, self.last);
        let lines = &mut self.lines[..n];
        if let Some(factor) = self.rests[0] {
            let BandRow { diagonals: [d0, d1, d2], sides } = lines[0];
            let line = &mut lines[1];
            line.diagonals[0] += factor * factor * d0 + 2.0 * factor * d1;
            line.diagonals[1] += factor * d2;
            line.sides = [0, 1].map(|side| line.sides[side] + factor * sides[side]);
        }
        if let Some(factor) = self.rests[1] {
            let BandRow { diagonals: [d0, ..], sides } = lines[n - 1];
            let line = &mut lines[n - 2];
            line.diagonals[0] += factor * factor * d0 + 2.0 * factor * line.diagonals[1];
            line.sides = [0, 1].map(|side| line.sides[side] + factor * sides[side]);
            let [_, d1, d2] = &mut lines[n - 3].diagonals;
            *d1 += factor * *d2;
        }
        // What goes beyond the unknown ones is nothing.
        lines[last].diagonals[1] = 0.0;
        lines[last].diagonals[2] = 0.0;
        lines[last - 1].diagonals[2] = 0.0;
        // What the lines before take away of the next one, and of the one after it.
        let (mut of_next, mut of_other) = (BandRow::default(), BandRow::default());
        for line in &mut lines[first..=last] {
            let [d0, d1, two] = line.diagonals;
            let (d0, one) = (d0 - of_next.diagonals[0], d1 - of_next.diagonals[1]);
            let sides = [0, 1].map(|side| line.sides[side] - of_next.sides[side]);
            let inverse = 1.0 / d0;
            let (l1, l2) = (one * inverse, two * inverse);
            *line =
                BandRow { diagonals: [inverse, l1, l2], sides: sides.map(|side| side * inverse) };
            let [o0, ..] = of_other.diagonals;
            of_next = BandRow {
                diagonals: [o0 + l1 * one, l1 * two, 0.0],
                sides: [0, 1].map(|side| of_other.sides[side] + l1 * sides[side]),
            };
            of_other =
                BandRow { diagonals: [l2 * two, 0.0, 0.0], sides: sides.map(|side| l2 * side) };
        }
    }

    /// The step of the coefficients with a μ, and of the elastic shares.
    pub(super) fn solve_for(&mut self, mu: f64) {
        let (first, last) = (self.first, self.last);
        let mut step = std::mem::take(&mut self.step);
        let (mut one, mut two) = (0.0, 0.0);
        for (value, line) in step[first..=last].iter_mut().zip(&self.lines[first..=last]).rev() {
            let [_, l1, l2] = line.diagonals;
            let [of_time, of_rows] = line.sides;
            *value = of_time + mu * of_rows - l1 * one - l2 * two;
            (two, one) = (one, *value);
        }
        step[..first].fill(0.0);
        step[last + 1..].fill(0.0);
        self.tie(&mut step);
        self.step = step;
    }

    /// How far the step may be gone: by the slacks, and by their prices.
    pub(super) fn reach(&mut self, mu: f64) -> (f64, f64) {
        let axes = self.axes;
        let mut reach = StepReach::default();
        let centre = LanePair::both(mu);
        for (index, block) in self.blocks.iter_mut().enumerate() {
            let k = 1 + 2 * index;
            let step = NewtonSolver::around(&self.step, k);
            let EliminatedShare { shares: [x, y, z], own } = block.folded;
            let elastic = own[0] + centre * own[1] - x * step[0] - y * step[1] - z * step[2];
            block.elastic_step = elastic;
            block.reach(step, centre, &mut reach);
            let own = index * axes..(index + 1) * axes;
            let room = block.share * elastic;
            for pull in &mut self.pulls[own.clone()] {
                pull.reach(step, room, centre, &mut reach);
            }
            let roots = [LanePair::at(&self.root, k), LanePair::at(&self.root, k + 1)];
            let room = block.room(roots);
            let more = [0, 1].map(|end| {
                let [x, y] = block.ends[end];
                let by = x * step[end] + y * step[end + 1];
                let root = roots[end];
                block.limit * root * elastic - LanePair::both(0.5) * room[end] * root * root * by
            });
            for bend in &mut self.bends[own] {
                bend.reach(step, more, centre, &mut reach);
            }
        }
        let intervals = self.first..=self.last;
        let falls = self.step[intervals.clone()].iter().zip(&self.c[intervals]);
        let fall = falls.fold(0.0_f64, |least, (step, c)| least.min(step / c));
        let share = |least: f64, near: f64| if -least > near { near / -least } else { 1.0 };
        let [slacks, prices] = reach.least();
        (
            share(slacks, WALL_STEP_SHARE).min(share(fall, MAX_COEFFICIENT_FALL)),
            share(prices, WALL_STEP_SHARE),
        )
    }

    /// Goes a part of the step.
    pub(super) fn go(&mut self, part: f64) {
        for (value, step) in self.c.iter_mut().zip(&self.step) {
            *value += part * step;
        }
        for block in &mut self.blocks {
            block.elastic += LanePair::both(part) * block.elastic_step;
        }
        self.speeds();
    }
}
