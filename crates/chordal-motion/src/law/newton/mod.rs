//! The quickest law on a window of cells, by Newton steps on the time itself.
//!
//! The unknowns are the coefficients c of b = σ̇² as a quadratic B-spline whose knots are the
//! nodes: at the node between two cells of lengths g and h with coefficients c and d,
//! b = (c·h + d·g)/(g + h) and σ̈ = (d − c)/(g + h), and between nodes σ̈ is linear in σ. So velocity,
//! acceleration and jerk of an axis at a node are linear in three coefficients, but for the root
//! in J/√b, whose curvature is left out: what is left is positive definite.
//!
//! Each cell may exceed its limits by an elastic share t ≥ 0, at a price: so there is always a
//! start, and at the end t is nothing.

mod begin;
mod rows;
mod step;

use super::Side;
use super::grid::{Grid, rest_factor};
use begin::Begin;
use rows::{Bend, Pull, Row};

/// What of the limits is used; the rest is for what lies between the nodes.
const ACCELERATION: f64 = 0.998;
const JERK: f64 = 0.9985;
/// Prices of an elastic share, as shares of the time, and of the first law what is begun with: the next
/// where elastic shares stay.
const TRIES: [[f64; 2]; 4] = [[0.1, 1.0], [0.1, 0.4], [1.0, 0.15], [10.0, 1.0]];
/// So far towards a wall in one step.
const NEAR: f64 = 0.97;
const ITERATIONS: usize = 60;
/// An open gap below this share of the time closes no more.
const STUCK: f64 = 1e-8;
/// The largest elastic share that is left.
const ELASTIC: f64 = 3e-4;

/// What a solution took.
#[derive(Clone, Copy, Debug)]
pub(super) struct Solution {
    pub iterations: u32,
    pub converged: bool,
}

/// The memory of the solver, for one window after the other.
#[derive(Debug, Default)]
pub(super) struct Newton {
    /// Number of axes, and of the window's cells.
    axes: usize,
    count: usize,
    /// Of each node: shares of the cells before and after it in b, and the inverse of their sum.
    before: Vec<f64>,
    after: Vec<f64>,
    sum: Vec<f64>,
    /// Largest b at each node, and on each cell: what bulges out between two nodes is below the cell's
    /// coefficient.
    cap: Vec<f64>,
    cell_cap: Vec<f64>,
    /// The rows of limits: of velocity at each node and on each cell, of the acceleration of each axis at each
    /// node, of its jerk on each cell.
    cap_rows: Vec<Row>,
    cell_cap_rows: Vec<Row>,
    pulls: Vec<Pull>,
    bends: Vec<Bend>,
    shares: Vec<f64>,
    limits: Vec<f64>,
    lengths: Vec<f64>,
    c: Vec<f64>,
    b: Vec<f64>,
    root: Vec<f64>,
    elastic: Vec<f64>,
    elastic_price: Vec<f64>,
    diagonals: [Vec<f64>; 3],
    step: Vec<f64>,
    elastic_step: Vec<f64>,
    /// What eliminates the elastic share of a cell.
    folded: Vec<([f64; 3], f64)>,
    trial: (Vec<f64>, Vec<f64>),
    first: usize,
    last: usize,
    rests: [Option<f64>; 2],
}

impl Newton {
    /// Solves for the coefficients of the cells `from..to`; those given at sides that are
    /// [`Side::Fixed`] (two of them) stay.
    pub fn solve(
        &mut self,
        grid: &Grid,
        (from, to): (usize, usize),
        sides: [Side; 2],
        coefficients: &mut [f64],
        gap: f64,
    ) -> Solution {
        let mut iterations = 0;
        self.lay(grid, from, to, sides);
        for [price, share] in TRIES {
            self.c.clear();
            self.c.extend_from_slice(coefficients);
            self.c[self.first..=self.last].iter_mut().for_each(|c| *c *= share);
            let solution = self.iterate(gap, price, Begin::Far);
            iterations += solution.iterations;
            if solution.converged {
                coefficients.copy_from_slice(&self.c);
                return Solution { iterations, converged: true };
            }
        }
        Solution { iterations, converged: false }
    }

    /// Solves the window that was solved last again, with limits that were taken back a little: from
    /// its solution and its prices on.
    pub fn again(
        &mut self,
        grid: &Grid,
        (from, to): (usize, usize),
        sides: [Side; 2],
        coefficients: &mut [f64],
        gap: f64,
    ) -> Solution {
        self.lay(grid, from, to, sides);
        self.c.clear();
        self.c.extend_from_slice(coefficients);
        let warm = self.iterate(gap, TRIES[0][0], Begin::Near);
        if warm.converged {
            coefficients.copy_from_slice(&self.c);
            return warm;
        }
        let cold = self.solve(grid, (from, to), sides, coefficients, gap);
        Solution { iterations: warm.iterations + cold.iterations, ..cold }
    }

    fn lay(&mut self, grid: &Grid, from: usize, to: usize, sides: [Side; 2]) {
        let (n, axes) = (to - from, grid.axes.len());
        (self.count, self.axes) = (n, axes);
        let cells = &grid.cells[from..to];
        let nodes = &grid.nodes[from..=to];
        self.lengths.clear();
        self.lengths.extend(cells.iter().map(|cell| cell.length));
        for list in [&mut self.before, &mut self.after, &mut self.sum, &mut self.cap] {
            list.clear();
            list.resize(n + 1, 0.0);
        }
        // Prices stay: the same window may be solved again.
        self.cap_rows.resize(n + 1, Row::default());
        self.cell_cap_rows.resize(n, Row::default());
        self.pulls.resize((n + 1) * axes, Pull::default());
        self.bends.resize(n * axes, Bend::default());
        self.cell_cap.clear();
        self.cell_cap.extend(nodes.windows(2).map(|ends| ends[0].cap.min(ends[1].cap)));
        self.limits.clear();
        self.limits.extend(cells.iter().map(|cell| JERK * cell.share));
        self.shares.clear();
        self.shares.extend(nodes.iter().map(|node| ACCELERATION * node.share));
        for node in 1..n {
            let (g, h) = (cells[node - 1].length, cells[node].length);
            let sum = 1.0 / (g + h);
            (self.before[node], self.after[node], self.sum[node]) = (h * sum, g * sum, sum);
            self.cap[node] = nodes[node].cap;
            for (place, &axis) in grid.axes.iter().enumerate() {
                let [q1, q2] = nodes[node].by_acceleration.map(|row| row[axis]);
                self.pulls[node * axes + place].slope =
                    [q2 * h * sum - q1 * sum, q2 * g * sum + q1 * sum];
            }
        }
        for cell in 1..n - 1 {
            let inverse = 1.0 / cells[cell].length;
            // The change of σ̈ over the cell by its length.
            let (a0, a2) = (self.sum[cell] * inverse, self.sum[cell + 1] * inverse);
            let a1 = -(a0 + a2);
            for (place, &axis) in grid.axes.iter().enumerate() {
                let [third, fourth] = cells[cell].third.map(|row| row[axis]);
                let [p, k] = nodes[cell].by_jerk.map(|row| row[axis]);
                let [q, l] = nodes[cell + 1].by_jerk.map(|row| row[axis]);
                let (k, l) = (3.0 * k * self.sum[cell], 3.0 * l * self.sum[cell + 1]);
                self.bends[cell * axes + place].slope = [
                    [p * a0 - k + third * self.before[cell], q * a0],
                    [
                        p * a1 + k + third * self.after[cell],
                        q * a1 - l + fourth * self.before[cell + 1],
                    ],
                    [p * a2, q * a2 + l + fourth * self.after[cell + 1]],
                ];
            }
        }
        let ends = [(0, 1), (n - 1, n - 2)];
        for (side, (at, next)) in ends.into_iter().enumerate() {
            self.rests[side] = None;
            if sides[side] == Side::Rest {
                self.rests[side] = Some(rest_factor(&cells[at], &cells[next]));
                let node = if side == 0 { 1 } else { n - 1 };
                let most = grid.rest_cap(from + at, side) * JERK.powi(2);
                self.cap[node] = self.cap[node].min(most);
            }
        }
        self.first = if sides[0] == Side::Rest { 1 } else { 2 };
        self.last = if sides[1] == Side::Rest { n - 2 } else { n - 3 };
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
        self.b.clear();
        self.b.resize(n + 1, 0.0);
        self.root.clear();
        self.root.resize(n + 1, 0.0);
        for node in 1..n {
            let b = self.before[node] * self.c[node - 1] + self.after[node] * self.c[node];
            self.b[node] = b;
            self.root[node] = 1.0 / b.max(1e-300).sqrt();
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
        self.elastic[1..self.count - 1].iter().fold(0.0, |most, t| most.max(*t))
    }

    fn iterate(&mut self, gap: f64, price: f64, how: Begin) -> Solution {
        self.begin(how);
        let n = self.count;
        if self.first > self.last || self.slacks() <= 0.0 {
            return Solution { iterations: 0, converged: false };
        }
        let mut time = self.time();
        let price = price * time;
        let rows = (self.count_rows() + n - 2) as f64;
        let mut mu = how.open(gap) * time / rows;
        self.begin_prices(mu, how);
        for k in 1..n - 1 {
            let least = mu / self.elastic[k];
            self.elastic_price[k] = match how {
                Begin::Far => least.min(price),
                Begin::Near => (10.0 * least).min(0.5 * price),
            };
        }
        let mut open = self.open();
        for iterations in 0..ITERATIONS as u32 {
            let elastic = self.largest_elastic();
            if open < gap * time && elastic < ELASTIC {
                return Solution { iterations, converged: true };
            }
            // Where limits contradict what is given, the elastic shares stay.
            if open.is_nan() || open <= STUCK * time {
                break;
            }
            self.assemble(mu, price);
            self.factor();
            let (primal, dual) = self.reach(mu);
            self.advance(mu, primal, dual);
            time = self.time();
            let done = primal.min(dual);
            open = self.open();
            mu = ((1.0 - done) * (1.0 - done)).max(0.05) * open / rows;
        }
        // A law within all limits is one, if not the best.
        let elastic = self.largest_elastic();
        Solution { iterations: ITERATIONS as u32, converged: elastic < ELASTIC }
    }

    /// Takes the step; shorter where the limits turn out to be nearer.
    fn advance(&mut self, mu: f64, primal: f64, dual: f64) {
        let n = self.count;
        self.advance_prices(mu, dual);
        let (mut c, mut t) = std::mem::take(&mut self.trial);
        c.clone_from(&self.c);
        t.clone_from(&self.elastic);
        let mut way = primal;
        for _ in 0..30 {
            for k in 0..n {
                self.c[k] = c[k] + way * self.step[k];
                self.elastic[k] = t[k] + way * self.elastic_step[k];
            }
            self.speeds();
            if self.slacks() > 0.0 {
                break;
            }
            way *= 0.5;
        }
        self.trial = (c, t);
    }
}
