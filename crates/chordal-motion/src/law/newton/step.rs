//! A Newton step: a matrix of five diagonals, and its solution.

use super::Newton;
use super::rows::Sums;

impl Newton {
    /// The matrix of the step and its right side.
    pub(super) fn assemble(&mut self, mu: f64, price: f64) {
        let n = self.count;
        self.diagonals.iter_mut().for_each(|diagonal| diagonal.fill(0.0));
        self.step.fill(0.0);
        for k in 1..n {
            let is_cell = k < n - 1;
            let mut sums = Sums::default();
            self.add_node(k, mu, &mut sums);
            if is_cell {
                self.add_cell(k, mu, &mut sums);
                sums.own += self.elastic_price[k] / self.elastic[k];
                sums.own_side += mu / self.elastic[k] - price;
                self.folded[k] = sums.fold();
            }
            let Sums { mut matrix, mut side, .. } = sums;
            self.add_time(k, &mut matrix, &mut side);
            let [d0, d1, d2] = &mut self.diagonals;
            d0[k - 1] += matrix[0];
            d0[k] += matrix[1];
            d1[k - 1] += matrix[3];
            self.step[k - 1] += side[0];
            self.step[k] += side[1];
            if is_cell {
                d0[k + 1] += matrix[2];
                d1[k] += matrix[4];
                d2[k - 1] += matrix[5];
                self.step[k + 1] += side[2];
            }
        }
    }

    /// Slope and curvature of the time on a cell, and next to a rest.
    fn add_time(&self, k: usize, matrix: &mut [f64; 6], side: &mut [f64; 3]) {
        let n = self.count;
        let (w0, w1) = (self.before[k], self.after[k]);
        let (b0, r0) = (self.b[k], self.root[k]);
        for (rest, node, cell) in [(0, 1, 0), (1, n - 1, n - 1)] {
            if self.rests[rest].is_some() && k == node {
                let h = self.lengths[cell];
                let (first, second) = (-1.5 * h * r0 / b0, 2.25 * h * r0 / (b0 * b0));
                side[0] -= first * w0;
                side[1] -= first * w1;
                matrix[0] += second * w0 * w0;
                matrix[1] += second * w1 * w1;
                matrix[3] += second * w0 * w1;
            }
        }
        if k >= n - 1 {
            return;
        }
        let (x0, x1) = (self.before[k + 1], self.after[k + 1]);
        let (b1, r1) = (self.b[k + 1], self.root[k + 1]);
        let (v0, v1) = (b0 * r0, b1 * r1);
        let (h, s) = (self.lengths[k], 1.0 / (v0 + v1));
        let square = s * s;
        let (f0, f1) = (-h * square * r0, -h * square * r1);
        let cross = h * square * s * r0 * r1;
        let f00 = h * square * (s * r0 * r0 + 0.5 * r0 * r0 * r0);
        let f11 = h * square * (s * r1 * r1 + 0.5 * r1 * r1 * r1);
        side[0] -= f0 * w0;
        side[1] -= f0 * w1 + f1 * x0;
        side[2] -= f1 * x1;
        matrix[0] += f00 * w0 * w0;
        matrix[1] += f00 * w1 * w1 + 2.0 * cross * w1 * x0 + f11 * x0 * x0;
        matrix[2] += f11 * x1 * x1;
        matrix[3] += f00 * w0 * w1 + cross * w0 * x0;
        matrix[4] += f11 * x0 * x1 + cross * w1 * x1;
        matrix[5] += cross * w0 * x1;
    }

    /// Solves for the step of the coefficients, then of the elastic shares.
    pub(super) fn factor(&mut self) {
        let (n, first, last) = (self.count, self.first, self.last);
        let [d0, d1, d2] = &mut self.diagonals;
        let side = &mut self.step;
        if let Some(factor) = self.rests[0] {
            side[1] += factor * side[0];
            d0[1] += factor * factor * d0[0] + 2.0 * factor * d1[0];
            d1[1] += factor * d2[0];
        }
        if let Some(factor) = self.rests[1] {
            side[n - 2] += factor * side[n - 1];
            d0[n - 2] += factor * factor * d0[n - 1] + 2.0 * factor * d1[n - 2];
            if n >= 3 {
                d1[n - 3] += factor * d2[n - 3];
            }
        }
        for k in first..=last {
            // What goes beyond the unknown ones is nothing.
            let one = if k < last { d1[k] } else { 0.0 };
            let two = if k + 1 < last { d2[k] } else { 0.0 };
            let inverse = 1.0 / d0[k];
            let (l1, l2) = (one * inverse, two * inverse);
            let value = side[k];
            if k < last {
                d0[k + 1] -= l1 * one;
                side[k + 1] -= l1 * value;
            }
            if k + 1 < last {
                d1[k + 1] -= l1 * two;
                d0[k + 2] -= l2 * two;
                side[k + 2] -= l2 * value;
            }
            (d1[k], d2[k], side[k]) = (l1, l2, value * inverse);
        }
        let (mut one, mut two) = (0.0, 0.0);
        for k in (first..=last).rev() {
            let value = side[k] - d1[k] * one - d2[k] * two;
            side[k] = value;
            (two, one) = (one, value);
        }
        side[..first].fill(0.0);
        side[last + 1..].fill(0.0);
        let mut step = std::mem::take(&mut self.step);
        self.tie(&mut step[..n]);
        for k in 1..n - 1 {
            let (f, own) = self.folded[k];
            self.elastic_step[k] = own - f[0] * step[k - 1] - f[1] * step[k] - f[2] * step[k + 1];
        }
        self.step = step;
    }
}
