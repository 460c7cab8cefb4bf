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
mod step;

use super::Side;
use super::grid::{Grid, rest_factor};
use begin::Begin;

/// What of the limits is used; the rest is for what lies between the nodes.
const ACCELERATION: f64 = 0.998;
const JERK: f64 = 0.9985;
/// Prices of an elastic share, as shares of the time, and of the first law what is begun with: the next
/// where elastic shares stay.
const TRIES: [[f64; 2]; 4] = [[0.1, 1.0], [0.1, 0.4], [1.0, 0.15], [10.0, 1.0]];
/// So far towards a wall in one step.
const NEAR: f64 = 0.97;
/// No step takes away more of a coefficient.
const MOST_FALL: f64 = 0.8;
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

/// A row of limits at a place: slack and price.
#[derive(Clone, Copy, Debug, Default)]
struct Row {
    slack: f64,
    price: f64,
}

/// Factors of a row: of the three coefficients around a cell, and of its elastic share.
#[derive(Clone, Copy, Debug)]
struct Slope([f64; 3], f64);

impl Slope {
    #[inline(always)]
    fn along(&self, step: &[f64; 3], elastic: f64) -> f64 {
        self.0[0] * step[0] + self.0[1] * step[1] + self.0[2] * step[2] + self.1 * elastic
    }
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
    /// Two factors for each axis at each node, six for each axis on each cell.
    acceleration: Vec<[f64; 2]>,
    jerk: Vec<[f64; 6]>,
    shares: Vec<f64>,
    limits: Vec<f64>,
    lengths: Vec<f64>,
    c: Vec<f64>,
    b: Vec<f64>,
    root: Vec<f64>,
    elastic: Vec<f64>,
    elastic_price: Vec<f64>,
    rows: Vec<Row>,
    slopes: Vec<Slope>,
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

    fn rows_of_node(&self) -> usize {
        1 + 2 * self.axes
    }

    fn stride(&self) -> usize {
        2 + 6 * self.axes
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
        self.acceleration.clear();
        self.acceleration.resize((n + 1) * axes, [0.0; 2]);
        self.jerk.clear();
        self.jerk.resize(n * axes, [0.0; 6]);
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
                self.acceleration[node * axes + place] =
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
                self.jerk[cell * axes + place] = [
                    p * a0 - k + third * self.before[cell],
                    p * a1 + k + third * self.after[cell],
                    p * a2,
                    q * a0,
                    q * a1 - l + fourth * self.before[cell + 1],
                    q * a2 + l + fourth * self.after[cell + 1],
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

    /// The nodes with rows: those between two coefficients that are given have none.
    fn has_rows(&self, node: usize) -> bool {
        node >= self.first && node <= self.last + 1
    }

    /// Goes over all rows of the nodes and cells with their slack, slope and place in the list.
    /// The first coefficient that a slope is of is `k − 1`, where `k` is the row's cell; the last
    /// node's slopes are of the cell that would follow it.
    fn each_row(&self, mut take: impl FnMut(usize, f64, Slope)) {
        let (n, axes) = (self.count, self.axes);
        for k in 1..n {
            let is_cell = k < n - 1;
            let elastic = if is_cell { self.elastic[k] } else { 0.0 };
            let place = k * self.stride();
            let (c0, c1) = (self.c[k - 1], self.c[k]);
            let (w0, w1) = (self.before[k], self.after[k]);
            if self.has_rows(k) {
                let cap = 1.0 / self.cap[k];
                take(place, 1.0 - self.b[k] * cap, Slope([w0 * cap, w1 * cap, 0.0], 0.0));
                let limit = self.shares[k];
                let grows = if is_cell { -limit } else { 0.0 };
                for axis in 0..axes {
                    let [x, y] = self.acceleration[k * axes + axis];
                    let used = x * c0 + y * c1;
                    let room = limit * (1.0 + elastic);
                    let at = place + 1 + 2 * axis;
                    take(at, room - used, Slope([x, y, 0.0], grows));
                    take(at + 1, room + used, Slope([-x, -y, 0.0], grows));
                }
            }
            if !is_cell || k < self.first.saturating_sub(1) || k > self.last + 1 {
                continue;
            }
            if (self.first..=self.last).contains(&k) {
                let cap = 1.0 / self.cell_cap[k];
                take(place + self.stride() - 1, 1.0 - c1 * cap, Slope([0.0, cap, 0.0], 0.0));
            }
            let c2 = self.c[k + 1];
            let limit = self.limits[k];
            let (r0, r1) = (self.root[k], self.root[k + 1]);
            let fall = 0.5 * limit * (1.0 + elastic);
            let (f0, f1) = (fall * r0 * r0 * r0, fall * r1 * r1 * r1);
            let left = [f0 * w0, f0 * w1];
            let right = [f1 * self.before[k + 1], f1 * self.after[k + 1]];
            let rooms = [limit * (1.0 + elastic) * r0, limit * (1.0 + elastic) * r1];
            let place = place + self.rows_of_node();
            for axis in 0..axes {
                let p = &self.jerk[k * axes + axis];
                let at = place + 4 * axis;
                let used = p[0] * c0 + p[1] * c1 + p[2] * c2;
                let (t0, t1) = (-limit * r0, -limit * r1);
                take(at, rooms[0] - used, Slope([p[0] + left[0], p[1] + left[1], p[2]], t0));
                take(at + 1, rooms[0] + used, Slope([left[0] - p[0], left[1] - p[1], -p[2]], t0));
                let used = p[3] * c0 + p[4] * c1 + p[5] * c2;
                take(at + 2, rooms[1] - used, Slope([p[3], p[4] + right[0], p[5] + right[1]], t1));
                take(at + 3, rooms[1] + used, Slope([-p[3], right[0] - p[4], right[1] - p[5]], t1));
            }
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

    /// Works out all slacks; the least of them.
    fn slacks(&mut self) -> f64 {
        let (mut rows, mut slopes) =
            (std::mem::take(&mut self.rows), std::mem::take(&mut self.slopes));
        let mut least = f64::INFINITY;
        self.each_row(|at, slack, slope| {
            rows[at].slack = slack;
            slopes[at] = slope;
            least = least.min(slack);
        });
        (self.rows, self.slopes) = (rows, slopes);
        least
    }

    /// By how much the time may be above the least, s.
    fn open(&self) -> f64 {
        let of_rows: f64 = self.rows.iter().map(|row| row.slack * row.price).sum();
        let cells = 1..self.count - 1;
        of_rows + cells.map(|k| self.elastic[k] * self.elastic_price[k]).sum::<f64>()
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
        let rows = self.rows.iter().filter(|row| row.slack > 0.0).count() + n - 2;
        let mut mu = how.open(gap) * time / rows as f64;
        for row in self.rows.iter_mut().filter(|row| row.slack > 0.0) {
            row.price = match how {
                Begin::Far => mu / row.slack,
                Begin::Near => row.price.max(mu / row.slack),
            };
        }
        for k in 1..n - 1 {
            let least = mu / self.elastic[k];
            self.elastic_price[k] = match how {
                Begin::Far => least.min(price),
                Begin::Near => (10.0 * least).min(0.5 * price),
            };
        }
        for iterations in 0..ITERATIONS as u32 {
            let open = self.open();
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
            let open = self.open();
            mu = ((1.0 - done) * (1.0 - done)).max(0.05) * open / rows as f64;
        }
        // A law within all limits is one, if not the best.
        let elastic = self.largest_elastic();
        Solution { iterations: ITERATIONS as u32, converged: elastic < ELASTIC }
    }

    /// How far the step may be gone: by the slacks, and by their prices.
    fn reach(&self, mu: f64) -> (f64, f64) {
        let (n, stride) = (self.count, self.stride());
        let (mut primal, mut dual) = (0.0_f64, 0.0_f64);
        for k in 1..n {
            let next = if k < n - 1 { self.step[k + 1] } else { 0.0 };
            let step = [self.step[k - 1], self.step[k], next];
            let elastic = if k < n - 1 { self.elastic_step[k] } else { 0.0 };
            let rows = self.rows[k * stride..(k + 1) * stride].iter();
            for (row, slope) in rows.zip(&self.slopes[k * stride..]) {
                if row.slack <= 0.0 {
                    continue;
                }
                let change = -slope.along(&step, elastic) / row.slack;
                primal = primal.max(-change);
                dual = dual.max(1.0 + change - mu / (row.slack * row.price));
            }
            if k < n - 1 {
                let change = elastic / self.elastic[k];
                primal = primal.max(-change);
                dual = dual.max(1.0 + change - mu / (self.elastic[k] * self.elastic_price[k]));
            }
        }
        let fall =
            (self.first..=self.last).fold(0.0_f64, |most, k| most.max(-self.step[k] / self.c[k]));
        let share = |most: f64, near: f64| if most > near { near / most } else { 1.0 };
        (share(primal, NEAR).min(share(fall, MOST_FALL)), share(dual, NEAR))
    }

    /// Takes the step; shorter where the limits turn out to be nearer.
    fn advance(&mut self, mu: f64, primal: f64, dual: f64) {
        let (n, stride) = (self.count, self.stride());
        for k in 1..n {
            let next = if k < n - 1 { self.step[k + 1] } else { 0.0 };
            let step = [self.step[k - 1], self.step[k], next];
            let elastic = if k < n - 1 { self.elastic_step[k] } else { 0.0 };
            for at in k * stride..(k + 1) * stride {
                let (row, slope) = (&mut self.rows[at], &self.slopes[at]);
                if row.slack > 0.0 {
                    let change = -slope.along(&step, elastic);
                    row.price += dual * ((mu - row.price * change) / row.slack - row.price);
                }
            }
            if k < n - 1 {
                let (t, price) = (self.elastic[k], self.elastic_price[k]);
                self.elastic_price[k] += dual * ((mu - price * elastic) / t - price);
            }
        }
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
