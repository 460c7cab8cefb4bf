//! A first profile with jerk along the path: not feasible everywhere, but near.
//!
//! A pass forward and a pass back let σ̈ grow no faster than the jerk of the axes allows, from no
//! acceleration where the profile without jerk is touched. That rounds the troughs. The tops are rounded by
//! the lower convex envelope of b + N, where N'' is twice the largest fall of σ̈ by σ.

use super::WindowSide;
use super::grid::{ProfileGrid, rest_factor};

/// Shares of the limits.
const GUESS_ACCELERATION_SHARE: f64 = 0.97;
const GUESS_JERK_SHARE: f64 = 0.85;
/// The profile is not below these shares of the one with round troughs and of the one without jerk: a profile
/// that nearly stops somewhere is an optimum of its own.
const FLOOR_SHARES: [f64; 2] = [0.5, 0.1];
const TOP_PASSES: usize = 3;

/// Its memory.
#[derive(Debug, Default)]
pub(super) struct InitialGuess {
    forward: Vec<f64>,
    both: Vec<f64>,
    law: Vec<f64>,
    rounding: Vec<f64>,
    hull: Vec<usize>,
}

/// A direction of a pass.
#[derive(Clone, Copy, PartialEq)]
enum PassDirection {
    Forward,
    Back,
}

/// The intervals of a window in a direction.
struct DirectedWindow<'a> {
    grid: &'a ProfileGrid,
    from: usize,
    count: usize,
    direction: PassDirection,
}

impl DirectedWindow<'_> {
    fn interval(&self, index: usize) -> usize {
        if self.direction == PassDirection::Forward { index } else { self.count - 1 - index }
    }

    fn length(&self, interval: usize) -> f64 {
        self.grid.intervals[self.from + interval].length
    }

    fn sign(&self) -> f64 {
        if self.direction == PassDirection::Forward { 1.0 } else { -1.0 }
    }

    /// The nodes at which an interval is entered and left.
    fn nodes(&self, interval: usize) -> [usize; 2] {
        if self.direction == PassDirection::Forward {
            [interval, interval + 1]
        } else {
            [interval + 1, interval]
        }
    }

    /// The largest growth of σ̈ by σ (or the largest fall) at both ends of an interval.
    fn growth(&self, interval: usize, b: f64, acceleration: f64, falls: bool) -> f64 {
        let sign = self.sign();
        let limit = GUESS_JERK_SHARE * self.grid.intervals[self.from + interval].share / b.sqrt();
        let mut most = f64::INFINITY;
        for side in 0..2 {
            let [first, second] = &self.grid.nodes[self.from + interval + side].by_jerk;
            let third = &self.grid.intervals[self.from + interval].third[side];
            for &axis in &self.grid.axes {
                let rate = sign * first[axis];
                if rate.abs() < 1e-15 {
                    continue;
                }
                let other = 3.0 * second[axis] * acceleration + sign * third[axis] * b;
                let other = if (rate < 0.0) == falls { other } else { -other };
                most = most.min((limit + other) / rate.abs());
            }
        }
        most
    }

    /// The largest coefficient after this one by the acceleration at the node between.
    fn most_after(&self, interval: usize, next: usize, node: usize, known: f64) -> f64 {
        let (own, other) = (self.length(interval), self.length(next));
        let sum = own + other;
        let sign = self.sign();
        let point = &self.grid.nodes[self.from + node];
        let mut most = f64::INFINITY;
        for &axis in &self.grid.axes {
            let [rate, bend] = point.by_acceleration.map(|row| row[axis]);
            let slope = sign * rate / sum + bend * own / sum;
            let level = (bend * other / sum - sign * rate / sum) * known;
            if slope > 1e-15 {
                most = most.min((GUESS_ACCELERATION_SHARE - level) / slope);
            } else if slope < -1e-15 {
                most = most.min((-GUESS_ACCELERATION_SHARE - level) / slope);
            }
        }
        most
    }

    /// The largest coefficient of the interval after one at rest by the acceleration at the node between.
    fn most_next_to_rest(&self, [one, two]: [usize; 2], factor: f64) -> f64 {
        let (own, other) = (self.length(one), self.length(two));
        let sum = own + other;
        let point = &self.grid.nodes[self.from + self.nodes(one)[1]];
        let most = self.grid.axes.iter().fold(0.0_f64, |most, &axis| {
            let [rate, bend] = point.by_acceleration.map(|row| row[axis]);
            let change = self.sign() * rate * (1.0 - factor) / sum;
            most.max((change + bend * (factor * other + own) / sum).abs())
        });
        GUESS_ACCELERATION_SHARE / most
    }

    /// A profile that is not above `most`, with growing acceleration as jerk allows it.
    fn pass(&self, most: &[f64], rest: Option<usize>, out: &mut [f64]) {
        let (one, two) = (self.interval(0), self.interval(1));
        let (own, other) = (self.length(one), self.length(two));
        (out[one], out[two]) = (most[one], most[two]);
        if let Some(side) = rest {
            let intervals = &self.grid.intervals[self.from..];
            let factor = rest_factor(&intervals[one], &intervals[two]);
            let cap = GUESS_JERK_SHARE * self.grid.rest_cap(self.from + one, side) * (own + other);
            out[two] = out[two].min(cap / (factor * other + own));
            out[two] = out[two].min(self.most_next_to_rest([one, two], factor));
            out[one] = factor * out[two];
        }
        let mut acceleration = (out[two] - out[one]) / (own + other);
        // A known profile may fall at first: that ends no sooner than jerk allows.
        let mut falls = rest.is_none() && acceleration < 0.0;
        for index in 1..self.count - 1 {
            let (interval, next) = (self.interval(index), self.interval(index + 1));
            let b = out[interval].max(1e-12);
            let length = self.length(interval);
            let (mut end, mut middle) = (acceleration, acceleration);
            for _ in 0..2 {
                // Where an axis turns back no change of σ̈ takes its jerk away: that would ask for a fall
                // without measure, to a profile that nearly stops.
                let least = if falls { acceleration } else { 0.0 };
                end = (acceleration + self.growth(interval, b, middle, false) * length).max(least);
                middle = 0.5 * (acceleration + end);
            }
            let sum = length + self.length(next);
            let node = self.nodes(interval)[1];
            let value = (out[interval] + sum * end).min(self.most_after(
                interval,
                next,
                node,
                out[interval],
            ));
            out[next] = value.max(0.0).min(most[next]);
            let change = (out[next] - out[interval]) / sum;
            falls = falls && change < 0.0 && change >= acceleration;
            acceleration = if falls { change } else { change.max(0.0) };
        }
    }
}

impl InitialGuess {
    /// The coefficients of a first profile on the intervals `from..to`; those that are known at fixed sides stay.
    pub fn find(
        &mut self,
        grid: &ProfileGrid,
        (from, to): (usize, usize),
        sides: [WindowSide; 2],
        coefficients: &mut [f64],
    ) {
        let count = to - from;
        let mut most: Vec<f64> = grid.bound[from..to].to_vec();
        for (side, fixed_range) in [(0, 0..2), (1, count - 2..count)] {
            if sides[side] == WindowSide::Fixed {
                most[fixed_range.clone()].copy_from_slice(&coefficients[fixed_range]);
            }
        }
        for list in [&mut self.forward, &mut self.both, &mut self.law, &mut self.rounding] {
            list.clear();
            list.resize(count, 0.0);
        }
        let rest = |side: usize| (sides[side] == WindowSide::Rest).then_some(side);
        let view = |direction| DirectedWindow { grid, from, count, direction };
        view(PassDirection::Forward).pass(&most, rest(0), &mut self.forward);
        view(PassDirection::Back).pass(&self.forward, rest(1), &mut self.both);
        self.round(&view(PassDirection::Forward));
        let inner = 2..count - 2;
        for (k, value) in coefficients.iter_mut().enumerate() {
            let fixed = (k < 2 && sides[0] == WindowSide::Fixed)
                || (k >= count - 2 && sides[1] == WindowSide::Fixed);
            if !fixed {
                let [share, least] = FLOOR_SHARES;
                let floor = (share * self.both[k]).max(least * most[k]);
                *value = if inner.contains(&k) { self.law[k].max(floor) } else { self.both[k] };
            }
        }
    }

    /// Rounds the tops.
    fn round(&mut self, view: &DirectedWindow<'_>) {
        let count = view.count;
        let middle = |k: usize| {
            let node = &view.grid.nodes[view.from + k];
            node.at + 0.5 * view.length(k)
        };
        self.law.clone_from(&self.both);
        for _ in 0..TOP_PASSES {
            let mut slope = 0.0;
            self.rounding[0] = 0.0;
            for k in 0..count - 1 {
                if k > 0 {
                    let (a, b) =
                        (view.length(k - 1) + view.length(k), view.length(k) + view.length(k + 1));
                    let acceleration = 0.5
                        * ((self.law[k] - self.law[k - 1]) / a
                            + (self.law[k + 1] - self.law[k]) / b);
                    let fall = view.growth(k, self.law[k].max(1e-12), acceleration, true).max(0.0);
                    if fall.is_finite() {
                        slope += 2.0 * fall * view.length(k);
                    }
                }
                self.rounding[k + 1] = self.rounding[k] + slope * (middle(k + 1) - middle(k));
            }
            self.envelope(middle);
        }
    }

    /// The lower convex envelope of the profile with round troughs and its rounding, less the rounding.
    fn envelope(&mut self, middle: impl Fn(usize) -> f64) {
        let height = |k: usize| self.both[k] + self.rounding[k];
        self.hull.clear();
        for k in 0..self.both.len() {
            while let [.., i, j] = self.hull[..] {
                let above = (height(j) - height(i)) * (middle(k) - middle(i))
                    >= (height(k) - height(i)) * (middle(j) - middle(i));
                if !above {
                    break;
                }
                self.hull.pop();
            }
            self.hull.push(k);
        }
        for pair in self.hull.windows(2) {
            let (i, j) = (pair[0], pair[1]);
            let slope = (height(j) - height(i)) / (middle(j) - middle(i));
            for k in i..=j {
                self.law[k] = height(i) + slope * (middle(k) - middle(i)) - self.rounding[k];
            }
        }
    }
}
