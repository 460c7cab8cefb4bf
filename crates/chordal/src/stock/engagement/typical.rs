//! The median of a quantity, weighted by time, in bounded memory.

use std::collections::BTreeMap;

/// Width of a histogram step: values within this share of each other count as one.
const EQUAL_SHARE: f64 = 0.01;

/// A histogram of values, weighted by the time for which they lasted.
#[derive(Clone, Debug, Default)]
pub(super) struct TimeWeightedValues {
    /// For each step of [`EQUAL_SHARE`] in the logarithm: the time, and the sum of value times time.
    steps: BTreeMap<i32, (f64, f64)>,
}

impl TimeWeightedValues {
    /// Adds a value above zero; others are ignored.
    pub fn add(&mut self, value: f64, seconds: f64) {
        if value > 0.0 && value.is_finite() && seconds > 0.0 {
            let step = (libm::log(value) / EQUAL_SHARE).round() as i32;
            let entry = self.steps.entry(step).or_default();
            *entry = (entry.0 + seconds, entry.1 + value * seconds);
        }
    }

    /// The median by time; `None` without values.
    pub fn median(&self) -> Option<f64> {
        let all: f64 = self.steps.values().map(|entry| entry.0).sum();
        let mut sum = 0.0;
        self.steps.values().find_map(|&(seconds, product)| {
            sum += seconds;
            (2.0 * sum >= all).then(|| product / seconds)
        })
    }

    /// The largest value that is reached or exceeded for at least this time; the median where the whole time is
    /// shorter.
    pub fn lasting(&self, least_seconds: f64) -> Option<f64> {
        let mut sum = 0.0;
        let found = self.steps.values().rev().find_map(|&(seconds, product)| {
            sum += seconds;
            (sum >= least_seconds).then(|| product / seconds)
        });
        found.or_else(|| self.median())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_median_is_by_time() {
        let mut typical = TimeWeightedValues::default();
        assert_eq!(typical.median(), None);
        typical.add(10.0, 1.0);
        typical.add(2.0, 5.0);
        typical.add(f64::NAN, 100.0);
        typical.add(0.5, 3.0);
        assert_eq!(typical.median(), Some(2.0));
        assert_eq!(typical.lasting(0.5), Some(10.0));
        assert_eq!(typical.lasting(2.0), Some(2.0));
        assert_eq!(typical.lasting(100.0), Some(2.0));
    }
}
