//! Where the Newton steps begin: inside of all limits, which the elastic shares make wide enough.

use super::NewtonSolver;
use super::lanes::LanePair;
use super::rows::SlackTally;
use super::start_kind::NewtonStart;
use super::step::BandRow;

/// So many coefficients next to two that are known the share comes gradually: a step would ask for much jerk.
const TAPER_COEFFICIENTS: f64 = 12.0;
/// The elastic share that everything begins with there, beyond what is used.
const WARM_ELASTIC_SHARE: f64 = 1e-5;

impl NewtonSolver {
    /// A start inside of all limits.
    pub(super) fn begin(&mut self, how: NewtonStart) {
        self.lower(how);
        for list in [&mut self.b, &mut self.root] {
            list.clear();
            list.resize(self.c.len(), 1.0);
        }
        self.speeds();
        self.step.clear();
        self.step.resize(self.c.len(), 0.0);
        self.lines.clear();
        self.lines.resize(self.c.len(), BandRow::default());
        for index in 0..self.blocks.len() {
            let used = self.largest_use(index);
            let [factor, less, least] = match how {
                NewtonStart::Far => [1.1, 1.045, 0.002],
                NewtonStart::Near => [1.2, 1.2, 0.0],
            };
            let elastic = LanePair::both(factor) * used - LanePair::both(less);
            let elastic = elastic.max(LanePair::both(least));
            self.blocks[index].elastic = match how {
                NewtonStart::Far => elastic,
                NewtonStart::Near => elastic + LanePair::both(WARM_ELASTIC_SHARE),
            };
        }
    }

    /// The prices with which the steps begin; false where something is above its limit.
    pub(super) fn begin_prices(&mut self, mu: f64, price: f64, how: NewtonStart) -> bool {
        let axes = self.axes;
        let mut tally = SlackTally::new();
        let one = LanePair::both(1.0);
        for (index, block) in self.blocks.iter_mut().enumerate() {
            let k = 1 + 2 * index;
            let c = NewtonSolver::around(&self.c, k);
            let caps = block.caps;
            let [node, interval] = &mut block.cap_rows;
            node.begin(one - LanePair::at(&self.b, k) * caps[0], mu, how, &mut tally);
            interval.begin(one - c[1] * caps[1], mu, how, &mut tally);
            let own = index * axes..(index + 1) * axes;
            let room = block.share * (one + block.elastic);
            for pull in &mut self.pulls[own.clone()] {
                pull.begin(c, room, mu, how, &mut tally);
            }
            let room = block.room([LanePair::at(&self.root, k), LanePair::at(&self.root, k + 1)]);
            for bend in &mut self.bends[own] {
                bend.begin(c, room, mu, how, &mut tally);
            }
            let least = LanePair::both(mu) / block.elastic;
            block.elastic_row.price = match how {
                NewtonStart::Far => LanePair::both(0.9 * price),
                NewtonStart::Near => {
                    (LanePair::both(10.0) * least).min(LanePair::both(0.5 * price))
                }
            };
            block.elastic_row.change = LanePair::default();
        }
        tally.least() > 0.0
    }

    /// Lowers the coefficients below all caps: all by one share, since a dent would ask for much jerk.
    fn lower(&mut self, how: NewtonStart) {
        let (first, last) = (self.first, self.last);
        let mut c = std::mem::take(&mut self.c);
        c[first..=last].iter_mut().for_each(|c| *c = c.max(1e-12));
        self.tie(&mut c);
        let [most, mut share] = how.shares();
        for node in first..=last + 1 {
            let b = self.before[node] * c[node - 1] + self.after[node] * c[node];
            share = share.min(most * self.cap[node] / b);
        }
        for (c, cap) in c[first..=last].iter().zip(&self.interval_cap[first..=last]) {
            share = share.min(most * cap / c);
        }
        let [begins, ends] = self.rests.map(|rest| rest.is_none());
        let gradual = |is_known_end: bool, far: usize| {
            let part =
                if is_known_end { ((far + 1) as f64 / TAPER_COEFFICIENTS).min(1.0) } else { 1.0 };
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

    /// The largest use of the limits around two intervals.
    fn largest_use(&self, index: usize) -> LanePair {
        let k = 1 + 2 * index;
        let c = NewtonSolver::around(&self.c, k);
        let own = index * self.axes..(index + 1) * self.axes;
        let block = &self.blocks[index];
        let none = LanePair::default();
        let mut most = none;
        for pull in &self.pulls[own.clone()] {
            let used = pull.along(c) / block.share;
            most = most.max(used).max(none - used);
        }
        for bend in &self.bends[own] {
            for end in 0..2 {
                let used = bend.along(end, c) / (block.limit * LanePair::at(&self.root, k + end));
                most = most.max(used).max(none - used);
            }
        }
        most
    }
}
