//! The quickest profile on a window of intervals, by Newton steps on the time itself.
//!
//! The unknowns are the coefficients c of b = σ̇² as a quadratic B-spline whose knots are the
//! nodes: at the node between two intervals of lengths g and h with coefficients c and d,
//! b = (c·h + d·g)/(g + h) and σ̈ = (d − c)/(g + h), and between nodes σ̈ is linear in σ. So velocity,
//! acceleration and jerk of an axis at a node are linear in three coefficients, but for the root
//! in J/√b, whose curvature is left out: what is left is positive definite.
//!
//! Each interval may exceed its limits by an elastic share t ≥ 0, at a price: so there is always a
//! start, and at the end t is nothing.

mod initial_point;
mod lanes;
mod rows;
mod start_kind;
mod step;

use super::WindowSide;
use super::grid::{GridInterval, GridNode, ProfileGrid, rest_factor};
use lanes::LanePair;
use rows::{AccelerationRows, JerkRows};
use start_kind::NewtonStart;
use step::{BandRow, IntervalPair, NewtonIterate};

/// Shares of the limits of acceleration and jerk that are used at the nodes. Between the nodes the true values are a little
/// above those at them; the rest of the limits is for that.
const NODE_ACCELERATION_SHARE: f64 = 0.998;
const INTERVAL_JERK_SHARE: f64 = 0.9985;
/// What is tried, one after the other, while elastic shares are left: the price of an elastic share, as a share of the time, and
/// the factor on the first profile with which the steps begin. A slower beginning is farther inside of the limits.
const START_TRIES: [[f64; 2]; 4] = [[0.1, 1.0], [0.1, 0.4], [1.0, 0.15], [10.0, 1.0]];
/// From this step on the price rises by this factor wherever a step leaves more than this share of the largest elastic share: a
/// price that is too low never brings it to nothing.
const PRICE_RISE_FROM_STEP: u32 = 6;
const MIN_ELASTIC_FALL: f64 = 0.9;
const PRICE_RISE_FACTOR: f64 = 2.0;
/// A step goes no farther than this share of the distance at which a slack or a price would be zero, as in all methods that stay
/// inside of the limits.
const WALL_STEP_SHARE: f64 = 0.99;
/// A solution takes 8 to 22 steps, and 3 to 9 from the solution before.
const MAX_NEWTON_STEPS: usize = 60;
/// A try ends when after so many steps an elastic share above the second number is left: the next beginning is quicker.
const SLOW_START: (u32, f64) = (30, 0.1);
/// A profile within all limits is taken after the last step up to this gap, as a share of the time: farther from the
/// best it may nearly stop somewhere.
const ROUGH_GAP_SHARE: f64 = 0.02;
/// Where the gap is closed to this share of the requested one, elastic shares that are left stay: the limits contradict
/// what is known at the ends.
const STUCK_GAP_SHARE: f64 = 0.01;
/// Halvings of a step that ends beyond a limit, which the root in the limit of jerk allows.
const MAX_STEP_HALVINGS: u32 = 30;
/// The least b of which a root is taken.
const MIN_SQUARE: f64 = 1e-300;
/// The largest elastic share of a solution, and of a profile that is taken after the last step. Both are no more
/// than the rest of the limits above, so the limits themselves hold.
const MAX_ELASTIC_SHARE: f64 = 3e-4;
const MAX_FINAL_ELASTIC_SHARE: f64 = 1.4e-3;

/// What a solution took.
#[derive(Clone, Copy, Debug)]
pub(super) struct WindowSolution {
    pub iterations: u32,
    pub converged: bool,
}

/// The memory of the solver, for one window after the other.
#[derive(Debug, Default)]
pub(super) struct NewtonSolver {
    /// Number of axes, and of the window's intervals.
    axes: usize,
    count: usize,
    /// Of each node: shares of the intervals before and after it in b, and the inverse of their sum.
    before: Vec<f64>,
    after: Vec<f64>,
    sum: Vec<f64>,
    /// Largest b at each node, and on each interval: what bulges out between two nodes is below the interval's
    /// coefficient.
    cap: Vec<f64>,
    interval_cap: Vec<f64>,
    lengths: Vec<f64>,
    /// The intervals from the second one on, in twos, and for each the limits of every axis.
    blocks: Vec<IntervalPair>,
    pulls: Vec<AccelerationRows>,
    bends: Vec<JerkRows>,
    /// The coefficients, and b and 1/√b at the nodes; beyond the last some without a meaning.
    c: Vec<f64>,
    b: Vec<f64>,
    root: Vec<f64>,
    lines: Vec<BandRow>,
    step: Vec<f64>,
    first: usize,
    last: usize,
    rests: [Option<f64>; 2],
}

impl NewtonSolver {
    /// Solves for the coefficients of the intervals `from..to`; those known at sides that are
    /// [`WindowSide::Fixed`] (two of them) stay.
    pub fn solve(
        &mut self,
        grid: &ProfileGrid,
        (from, to): (usize, usize),
        sides: [WindowSide; 2],
        coefficients: &mut [f64],
        gap: f64,
    ) -> WindowSolution {
        let mut iterations = 0;
        self.set_up(grid, from, to, sides);
        for [price, share] in START_TRIES {
            self.c.clear();
            self.c.extend_from_slice(coefficients);
            self.c[self.first..=self.last].iter_mut().for_each(|c| *c *= share);
            self.c.resize(self.padded(), 1.0);
            let solution = self.iterate(gap, price, NewtonStart::Far);
            iterations += solution.iterations;
            if solution.converged {
                coefficients.copy_from_slice(&self.c[..self.count]);
                return WindowSolution { iterations, converged: true };
            }
        }
        WindowSolution { iterations, converged: false }
    }

    /// Solves the window that was solved last again, with limits that were taken back a little: from
    /// its solution and its prices on.
    pub fn again(
        &mut self,
        grid: &ProfileGrid,
        (from, to): (usize, usize),
        sides: [WindowSide; 2],
        coefficients: &mut [f64],
        gap: f64,
    ) -> WindowSolution {
        self.set_up(grid, from, to, sides);
        self.c.clear();
        self.c.extend_from_slice(coefficients);
        self.c.resize(self.padded(), 1.0);
        let warm = self.iterate(gap, START_TRIES[0][0], NewtonStart::Near);
        if warm.converged {
            coefficients.copy_from_slice(&self.c[..self.count]);
            return warm;
        }
        let cold = self.solve(grid, (from, to), sides, coefficients, gap);
        WindowSolution { iterations: warm.iterations + cold.iterations, ..cold }
    }

    /// So many coefficients are there, with those without a meaning.
    fn padded(&self) -> usize {
        2 * self.blocks.len() + 2
    }

    fn set_up(&mut self, grid: &ProfileGrid, from: usize, to: usize, sides: [WindowSide; 2]) {
        let (n, axes) = (to - from, grid.axes.len());
        (self.count, self.axes) = (n, axes);
        let intervals = &grid.intervals[from..to];
        let nodes = &grid.nodes[from..=to];
        self.lengths.clear();
        self.lengths.extend(intervals.iter().map(|interval| interval.length));
        // Prices stay: the same window may be solved again.
        self.blocks.resize(n / 2, IntervalPair::default());
        self.pulls.resize(n / 2 * axes, AccelerationRows::default());
        self.bends.resize(n / 2 * axes, JerkRows::default());
        let padded = self.padded();
        for list in [&mut self.before, &mut self.after, &mut self.sum, &mut self.cap] {
            list.clear();
            list.resize(padded, 0.0);
        }
        self.interval_cap.clear();
        self.interval_cap.extend(nodes.windows(2).map(|ends| ends[0].cap.min(ends[1].cap)));
        for node in 1..n {
            let (g, h) = (intervals[node - 1].length, intervals[node].length);
            let sum = 1.0 / (g + h);
            (self.before[node], self.after[node], self.sum[node]) = (h * sum, g * sum, sum);
            self.cap[node] = nodes[node].cap;
        }
        let ends = [(0, 1, 1), (n - 1, n - 2, n - 1)];
        for (side, (at, next, node)) in ends.into_iter().enumerate() {
            self.rests[side] = None;
            if sides[side] == WindowSide::Rest {
                self.rests[side] = Some(rest_factor(&intervals[at], &intervals[next]));
                let most = grid.rest_cap(from + at, side) * INTERVAL_JERK_SHARE.powi(2);
                self.cap[node] = self.cap[node].min(most);
            }
        }
        self.first = if sides[0] == WindowSide::Rest { 1 } else { 2 };
        self.last = if sides[1] == WindowSide::Rest { n - 2 } else { n - 3 };
        self.set_up_blocks(intervals, nodes);
        for index in 0..self.blocks.len() {
            for (place, &axis) in grid.axes.iter().enumerate() {
                let (node, interval) = self.slopes(1 + 2 * index, axis, intervals, nodes);
                self.pulls[index * axes + place].slope = node;
                self.bends[index * axes + place].slope = interval;
            }
        }
    }

    /// Nodes between two coefficients that are known have no limits.
    fn has_limits(&self, node: usize) -> bool {
        node >= self.first && node <= self.last + 1
    }

    fn set_up_blocks(&mut self, intervals: &[GridInterval], nodes: &[GridNode]) {
        let mut blocks = std::mem::take(&mut self.blocks);
        let n = self.count;
        let is_interval = |k: usize| k < n - 1;
        for (index, block) in blocks.iter_mut().enumerate() {
            let k = 1 + 2 * index;
            let of_interval = |value: &dyn Fn(usize) -> f64, other: f64| {
                LanePair::of(k, |k| if is_interval(k) { value(k) } else { other })
            };
            block.node = [LanePair::at(&self.before, k), LanePair::at(&self.after, k)];
            block.ends = [0, 1].map(|end| {
                [&self.before, &self.after].map(|list| of_interval(&|k| list[k + end], 0.0))
            });
            block.length = of_interval(&|k| intervals[k].length, 0.0);
            let rest = |k: usize| match self.rests {
                [Some(_), _] if k == 1 => intervals[0].length,
                [_, Some(_)] if k == n - 1 => intervals[n - 1].length,
                _ => 0.0,
            };
            block.rest = LanePair::of(k, rest);
            let has_limits = |k: usize| self.has_limits(k);
            let share = |k: usize| {
                if has_limits(k) { NODE_ACCELERATION_SHARE * nodes[k].share } else { 1.0 }
            };
            block.share = LanePair::of(k, share);
            block.limit = of_interval(&|k| INTERVAL_JERK_SHARE * intervals[k].share, 1.0);
            block.caps = [
                LanePair::of(k, |k| if has_limits(k) { 1.0 / self.cap[k] } else { 0.0 }),
                LanePair::of(k, |k| {
                    let is_free = (self.first..=self.last).contains(&k);
                    if is_free { 1.0 / self.interval_cap[k] } else { 0.0 }
                }),
            ];
        }
        self.blocks = blocks;
    }

    /// How acceleration at the node and jerk at both ends of two intervals go by the coefficients around them.
    fn slopes(
        &self,
        k: usize,
        axis: usize,
        intervals: &[GridInterval],
        nodes: &[GridNode],
    ) -> ([LanePair; 2], [[LanePair; 3]; 2]) {
        let (mut of_node, mut of_interval) = ([[0.0; 2]; 2], [[[0.0; 2]; 3]; 2]);
        for lane in 0..2 {
            let k = k + lane;
            if self.has_limits(k) {
                let [q1, q2] = nodes[k].by_acceleration.map(|row| row[axis]);
                of_node[0][lane] = q2 * self.before[k] - q1 * self.sum[k];
                of_node[1][lane] = q2 * self.after[k] + q1 * self.sum[k];
            }
            if k + 1 >= self.count {
                continue;
            }
            let inverse = 1.0 / intervals[k].length;
            // The change of σ̈ over the interval by its length.
            let (a0, a2) = (self.sum[k] * inverse, self.sum[k + 1] * inverse);
            let changes = [a0, -(a0 + a2), a2];
            for end in 0..2 {
                let node = k + end;
                let [p, q] = nodes[node].by_jerk.map(|row| row[axis]);
                let third = intervals[k].third[end][axis];
                let turn = 3.0 * q * self.sum[node];
                let slope = &mut of_interval[end];
                for (slope, change) in slope.iter_mut().zip(changes) {
                    slope[lane] = p * change;
                }
                slope[end][lane] += third * self.before[node] - turn;
                slope[end + 1][lane] += third * self.after[node] + turn;
            }
        }
        let two = |[first, second]: [f64; 2]| LanePair::new(first, second);
        (of_node.map(two), of_interval.map(|end| end.map(two)))
    }

    /// The coefficients next to a rest follow the next ones.
    fn tie(&self, c: &mut [f64]) {
        let n = self.count;
        if let Some(factor) = self.rests[0] {
            c[0] = factor * c[1];
        }
        if let Some(factor) = self.rests[1] {
            c[n - 1] = factor * c[n - 2];
        }
    }

    /// b and 1/√b at the nodes.
    fn speeds(&mut self) {
        let n = self.count;
        let c = self.c[..n].windows(2).zip(self.before[1..n].iter().zip(&self.after[1..n]));
        let nodes = self.b[1..n].iter_mut().zip(&mut self.root[1..n]);
        for ((b, root), (c, (before, after))) in nodes.zip(c) {
            *b = before * c[0] + after * c[1];
            // A b below zero is left to the limits, which refuse it.
            *root = 1.0 / if *b > MIN_SQUARE { *b } else { MIN_SQUARE }.sqrt();
        }
    }

    fn time(&self) -> f64 {
        let n = self.count;
        let speed = |node: usize| self.b[node] * self.root[node];
        let mut time: f64 =
            (1..n - 1).map(|k| 2.0 * self.lengths[k] / (speed(k) + speed(k + 1))).sum();
        if self.rests[0].is_some() {
            time += 3.0 * self.lengths[0] * self.root[1];
        }
        if self.rests[1].is_some() {
            time += 3.0 * self.lengths[n - 1] * self.root[n - 1];
        }
        time
    }

    fn largest_elastic(&self) -> f64 {
        let most = |most: LanePair, block: &IntervalPair| most.max(block.elastic);
        self.blocks.iter().fold(LanePair::default(), most).most()
    }

    fn iterate(&mut self, gap: f64, price: f64, how: NewtonStart) -> WindowSolution {
        let failed = WindowSolution { iterations: 0, converged: false };
        if self.first > self.last {
            return failed;
        }
        self.begin(how);
        let time = self.time();
        let mut price = price * time;
        let mut known = f64::INFINITY;
        let rows = (2 * self.blocks.len() * (3 + 6 * self.axes)) as f64;
        let mut mu = how.open(gap) * time / rows;
        if !self.begin_prices(mu, price, how) {
            return failed;
        }
        let mut now = self.assemble(price, 0.0);
        for iterations in 0..MAX_NEWTON_STEPS as u32 {
            let elastic = self.largest_elastic();
            if now.open < gap * now.time && elastic < MAX_ELASTIC_SHARE {
                return WindowSolution { iterations, converged: true };
            }
            // Where limits contradict what is known, the elastic shares stay.
            let is_stuck = now.open.is_nan() || now.open <= STUCK_GAP_SHARE * gap * now.time;
            let is_slow = iterations >= SLOW_START.0 && elastic > SLOW_START.1;
            if is_stuck || is_slow {
                break;
            }
            if iterations > 0 {
                mu *= now.open / rows;
            }
            if iterations >= PRICE_RISE_FROM_STEP && elastic > MIN_ELASTIC_FALL * known {
                price *= PRICE_RISE_FACTOR;
            }
            known = elastic;
            self.factor();
            self.solve_for(mu);
            let (primal, dual) = self.reach(mu);
            now = self.advance(price, primal, dual);
            let done = primal.min(dual);
            mu = ((1.0 - done) * (1.0 - done) * (1.0 - done)).max(0.02);
        }
        // A profile within all limits is one, if not the best; one far from the best may nearly stop somewhere.
        let converged = self.largest_elastic() < MAX_FINAL_ELASTIC_SHARE
            && now.open < ROUGH_GAP_SHARE * now.time;
        WindowSolution { iterations: MAX_NEWTON_STEPS as u32, converged }
    }

    /// Takes the step; shorter where the limits turn out to be nearer.
    fn advance(&mut self, price: f64, primal: f64, dual: f64) -> NewtonIterate {
        self.go(primal);
        let mut now = self.assemble(price, dual);
        let mut share = primal;
        for _ in 0..MAX_STEP_HALVINGS {
            if now.least > 0.0 {
                break;
            }
            share *= 0.5;
            self.go(-share);
            // The prices have taken their step.
            now = self.assemble(price, 0.0);
        }
        now
    }
}
