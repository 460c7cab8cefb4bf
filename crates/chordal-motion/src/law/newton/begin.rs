//! Where the Newton steps begin: inside of all limits, which the elastic shares make wide enough.

use super::{NEAR, Newton};

/// A window that is solved again begins with this share of its solution.
const AGAIN: f64 = 0.995;
/// So many coefficients beside two that are given the share comes gradually: a step would ask for much jerk.
const TAPER: f64 = 12.0;
/// The elastic share that everything begins with there, beyond what is used.
const NEAR_ELASTIC: f64 = 1e-5;
/// The open gap at the start, as a share of the time; near the solution in gaps that are wanted.
const FAR_OPEN: f64 = 0.1;
const NEAR_GAPS: f64 = 30.0;

/// How near the solution a start is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Begin {
    /// A first law.
    Far,
    /// The solution within limits that were a little wider, with its prices.
    Near,
}

impl Begin {
    /// The gap that is taken to be open, as a share of the time.
    pub fn open(self, gap: f64) -> f64 {
        match self {
            Begin::Far => FAR_OPEN,
            Begin::Near => NEAR_GAPS * gap,
        }
    }

    /// So much of a cap may be used, and of the coefficients that are given.
    fn shares(self) -> [f64; 2] {
        match self {
            Begin::Far => [NEAR, 1.0],
            Begin::Near => [AGAIN; 2],
        }
    }
}

impl Newton {
    /// A start inside of all limits.
    pub(super) fn begin(&mut self, how: Begin) {
        self.lower(how);
        self.speeds();
        let n = self.count;
        self.elastic.clear();
        self.elastic.resize(n, 0.0);
        for k in 1..n - 1 {
            let used = self.largest_use(k);
            self.elastic[k] = match how {
                Begin::Far => (1.2 * used - 0.7).max(0.3),
                Begin::Near => (1.2 * (used - 1.0)).max(0.0) + NEAR_ELASTIC,
            };
        }
        self.folded.clear();
        self.folded.resize(n, ([0.0; 3], 0.0));
        for list in [&mut self.elastic_price, &mut self.elastic_step] {
            list.clear();
            list.resize(n, 0.0);
        }
        for list in self.diagonals.iter_mut().chain([&mut self.step]) {
            list.clear();
            list.resize(n + 2, 0.0);
        }
    }

    /// Lowers the coefficients below all caps: all by one share, since a dent would ask for much jerk.
    fn lower(&mut self, how: Begin) {
        let (first, last) = (self.first, self.last);
        let mut c = std::mem::take(&mut self.c);
        c[first..=last].iter_mut().for_each(|c| *c = c.max(1e-12));
        self.tie(&mut c);
        let [most, mut share] = how.shares();
        for node in first..=last + 1 {
            let b = self.before[node] * c[node - 1] + self.after[node] * c[node];
            share = share.min(most * self.cap[node] / b);
        }
        for (c, cap) in c[first..=last].iter().zip(&self.cell_cap[first..=last]) {
            share = share.min(most * cap / c);
        }
        let [begins, ends] = self.rests.map(|rest| rest.is_none());
        let gradual = |is_given: bool, far: usize| {
            let part = if is_given { ((far + 1) as f64 / TAPER).min(1.0) } else { 1.0 };
            part * part * (3.0 - 2.0 * part)
        };
        let count = last - first;
        for (index, c) in c[first..=last].iter_mut().enumerate() {
            let part = gradual(begins, index) * gradual(ends, count - index);
            *c *= 1.0 - (1.0 - share) * part;
        }
        self.tie(&mut c);
        self.c = c;
    }

    /// The largest use of the limits around a cell.
    fn largest_use(&self, k: usize) -> f64 {
        let c = [self.c[k - 1], self.c[k], self.c[k + 1]];
        let mut most = 0.0_f64;
        for axis in 0..self.axes {
            let [x, y] = self.pulls[k * self.axes + axis].slope;
            most = most.max((x * c[0] + y * c[1]).abs() / self.shares[k]);
            let [left, right] = self.bends[k * self.axes + axis].along(&c);
            most = most.max(left.abs() / (self.limits[k] * self.root[k]));
            most = most.max(right.abs() / (self.limits[k] * self.root[k + 1]));
        }
        most
    }
}
