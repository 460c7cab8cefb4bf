//! Extremes in equal intervals, which grow twice as wide when there are too many: no peak is
//! lost, however long it goes on.

/// Intervals beyond which they are joined in pairs; more than a sheet has columns.
const MAX_BUCKETS: usize = 4096;

/// The extremes of `N` values in an interval.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct BucketExtremes<const N: usize> {
    pub low: [f64; N],
    pub high: [f64; N],
    /// The line of the first block in it; 0 where there is none.
    pub line: u32,
}

impl<const N: usize> BucketExtremes<N> {
    const EMPTY: BucketExtremes<N> =
        BucketExtremes { low: [f64::INFINITY; N], high: [f64::NEG_INFINITY; N], line: 0 };

    fn add(&mut self, values: &[f64; N]) {
        for (index, value) in values.iter().enumerate() {
            self.low[index] = self.low[index].min(*value);
            self.high[index] = self.high[index].max(*value);
        }
    }

    fn join(&mut self, later: &BucketExtremes<N>) {
        for index in 0..N {
            self.low[index] = self.low[index].min(later.low[index]);
            self.high[index] = self.high[index].max(later.high[index]);
        }
        if self.line == 0 {
            self.line = later.line;
        }
    }

    /// Whether anything fell into it.
    pub fn is_filled(&self) -> bool {
        N > 0 && self.low[0] <= self.high[0]
    }
}

/// Values along a quantity that grows: time, or the way.
#[derive(Clone, Debug)]
pub(super) struct ValueBuckets<const N: usize> {
    width: f64,
    cells: Vec<BucketExtremes<N>>,
    end: f64,
}

impl<const N: usize> ValueBuckets<N> {
    /// Intervals of this width at first.
    pub fn new(width: f64) -> ValueBuckets<N> {
        ValueBuckets { width, cells: Vec::new(), end: 0.0 }
    }

    /// Takes values at a place; what is not finite is left out.
    pub fn push(&mut self, at: f64, values: &[f64; N], line: u32) {
        if !(at >= 0.0 && at.is_finite() && values.iter().all(|value| value.is_finite())) {
            return;
        }
        self.end = self.end.max(at);
        while at / self.width >= MAX_BUCKETS as f64 {
            self.halve();
        }
        let index = (at / self.width) as usize;
        if index >= self.cells.len() {
            self.cells.resize(index + 1, BucketExtremes::EMPTY);
        }
        let cell = &mut self.cells[index];
        cell.add(values);
        if cell.line == 0 {
            cell.line = line;
        }
    }

    fn halve(&mut self) {
        let count = self.cells.len().div_ceil(2);
        for index in 0..count {
            let mut cell = self.cells[2 * index];
            if let Some(later) = self.cells.get(2 * index + 1) {
                cell.join(later);
            }
            self.cells[index] = cell;
        }
        self.cells.truncate(count);
        self.width *= 2.0;
    }

    /// The last place.
    pub fn end(&self) -> f64 {
        self.end
    }

    /// The middles of the intervals that anything fell into, and their extremes.
    pub fn cells(&self) -> impl Iterator<Item = (f64, &BucketExtremes<N>)> {
        let middle = |index: usize| ((index as f64 + 0.5) * self.width).min(self.end);
        self.cells
            .iter()
            .enumerate()
            .filter(|(_, cell)| cell.is_filled())
            .map(move |(index, cell)| (middle(index), cell))
    }

    /// The line that is under way at a place.
    pub fn line_at(&self, at: f64) -> Option<u32> {
        let last = self.cells.len().checked_sub(1)?;
        let index = ((at / self.width) as usize).min(last);
        self.cells[..=index].iter().rev().map(|cell| cell.line).find(|line| *line > 0)
    }

    /// The least and the largest of a value over all; `None`: there are none.
    pub fn extent(&self, value: usize) -> Option<(f64, f64)> {
        self.cells()
            .map(|(_, cell)| (cell.low[value], cell.high[value]))
            .reduce(|a, b| (a.0.min(b.0), a.1.max(b.1)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_peak_is_lost_however_long_it_goes_on() {
        let mut buckets = ValueBuckets::<2>::new(0.001);
        for index in 0..1_000_000 {
            let peak = if index == 123_456 { 7.0 } else { 0.0 };
            buckets.push(index as f64 * 0.001, &[peak, -peak], 1 + index / 1000);
        }
        assert!(buckets.cells.len() <= MAX_BUCKETS && buckets.cells.len() > MAX_BUCKETS / 4);
        assert_eq!(buckets.extent(0), Some((0.0, 7.0)));
        assert_eq!(buckets.extent(1), Some((-7.0, 0.0)));
        let (at, _) = buckets.cells().find(|(_, cell)| cell.high[0] > 0.0).unwrap();
        assert!((at - 123.456).abs() <= buckets.width);
        assert_eq!(buckets.line_at(500.0).map(|line| line.abs_diff(501) <= 1), Some(true));
    }

    #[test]
    fn jumps_leave_intervals_empty_and_far_ones_are_held() {
        let mut buckets = ValueBuckets::<1>::new(1.0);
        buckets.push(0.0, &[1.0], 3);
        buckets.push(1e15, &[2.0], 9);
        buckets.push(f64::NAN, &[5.0], 9);
        buckets.push(5.0, &[f64::INFINITY], 9);
        assert!(buckets.cells.len() <= MAX_BUCKETS);
        assert_eq!(buckets.cells().count(), 2);
        assert_eq!(buckets.extent(0), Some((1.0, 2.0)));
        assert_eq!((buckets.line_at(1.0), buckets.line_at(1e15)), (Some(3), Some(9)));
        assert_eq!(ValueBuckets::<1>::new(1.0).extent(0), None);
    }
}
