//! Where the Newton steps begin: inside of all limits, which the elastic shares make wide enough.

use super::Newton;
use super::how::Begin;
use super::lanes::Two;
use super::rows::Tally;
use super::step::Line;

/// So many coefficients beside two that are given the share comes gradually: a step would ask for much jerk.
const TAPER: f64 = 12.0;
/// The elastic share that everything begins with there, beyond what is used.
const NEAR_ELASTIC: f64 = 1e-5;

impl Newton {
    /// A start inside of all limits.
    pub(super) fn begin(&mut self, how: Begin) {
        self.lower(how);
        for list in [&mut self.b, &mut self.root] {
            list.clear();
            list.resize(self.c.len(), 1.0);
        }
        self.speeds();
        self.step.clear();
        self.step.resize(self.c.len(), 0.0);
        self.lines.clear();
        self.lines.resize(self.c.len(), Line::default());
        for index in 0..self.blocks.len() {
            let used = self.largest_use(index);
            let [factor, less, least] = match how {
                Begin::Far => [1.1, 1.045, 0.002],
                Begin::Near => [1.2, 1.2, 0.0],
            };
            let elastic = Two::both(factor) * used - Two::both(less);
            let elastic = elastic.max(Two::both(least));
            self.blocks[index].elastic = match how {
                Begin::Far => elastic,
                Begin::Near => elastic + Two::both(NEAR_ELASTIC),
            };
        }
    }

    /// The prices with which the steps begin; false where something is above its limit.
    pub(super) fn begin_prices(&mut self, mu: f64, price: f64, how: Begin) -> bool {
        let axes = self.axes;
        let mut tally = Tally::new();
        let one = Two::both(1.0);
        for (index, block) in self.blocks.iter_mut().enumerate() {
            let k = 1 + 2 * index;
            let c = Newton::around(&self.c, k);
            let caps = block.caps;
            let [node, cell] = &mut block.cap_rows;
            node.begin(one - Two::at(&self.b, k) * caps[0], mu, how, &mut tally);
            cell.begin(one - c[1] * caps[1], mu, how, &mut tally);
            let own = index * axes..(index + 1) * axes;
            let room = block.share * (one + block.elastic);
            for pull in &mut self.pulls[own.clone()] {
                pull.begin(c, room, mu, how, &mut tally);
            }
            let room = block.room([Two::at(&self.root, k), Two::at(&self.root, k + 1)]);
            for bend in &mut self.bends[own] {
                bend.begin(c, room, mu, how, &mut tally);
            }
            let least = Two::both(mu) / block.elastic;
            block.elastic_row.price = match how {
                Begin::Far => Two::both(0.9 * price),
                Begin::Near => (Two::both(10.0) * least).min(Two::both(0.5 * price)),
            };
            block.elastic_row.change = Two::default();
        }
        tally.least() > 0.0
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

    /// The largest use of the limits around two cells.
    fn largest_use(&self, index: usize) -> Two {
        let k = 1 + 2 * index;
        let c = Newton::around(&self.c, k);
        let own = index * self.axes..(index + 1) * self.axes;
        let block = &self.blocks[index];
        let none = Two::default();
        let mut most = none;
        for pull in &self.pulls[own.clone()] {
            let used = pull.along(c) / block.share;
            most = most.max(used).max(none - used);
        }
        for bend in &self.bends[own] {
            for end in 0..2 {
                let used = bend.along(end, c) / (block.limit * Two::at(&self.root, k + end));
                most = most.max(used).max(none - used);
            }
        }
        most
    }
}
