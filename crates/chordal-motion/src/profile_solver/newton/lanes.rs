//! Two numbers that are worked on as one: those of two intervals that follow each other.
//!
//! Two neighbours in memory that see the same operations become one instruction of the baseline of x86-64
//! each; the results are those of each number by itself, so they are the same to the bit everywhere.

use std::ops::{Add, AddAssign, Div, Mul, Sub, SubAssign};

/// Two numbers.
#[derive(Clone, Copy, Debug)]
#[repr(align(16))]
pub(super) struct LanePair([f64; 2]);

impl LanePair {
    #[inline(always)]
    pub fn new(first: f64, second: f64) -> LanePair {
        LanePair([first, second])
    }

    /// The same number twice.
    #[inline(always)]
    pub fn both(value: f64) -> LanePair {
        LanePair([value; 2])
    }

    /// The two that begin at a place of a list.
    #[inline(always)]
    pub fn at(list: &[f64], index: usize) -> LanePair {
        LanePair([list[index], list[index + 1]])
    }

    /// A value of each of two that follow each other.
    pub fn of(index: usize, value: impl Fn(usize) -> f64) -> LanePair {
        LanePair([value(index), value(index + 1)])
    }

    #[inline(always)]
    pub fn first(self) -> f64 {
        self.0[0]
    }

    #[inline(always)]
    pub fn second(self) -> f64 {
        self.0[1]
    }

    /// The smaller of each; the other's where one is not a number.
    #[inline(always)]
    pub fn min(self, other: LanePair) -> LanePair {
        let least = |a: f64, b: f64| if a < b { a } else { b };
        LanePair([least(self.0[0], other.0[0]), least(self.0[1], other.0[1])])
    }

    /// The larger of each; the other's where one is not a number.
    #[inline(always)]
    pub fn max(self, other: LanePair) -> LanePair {
        let most = |a: f64, b: f64| if a > b { a } else { b };
        LanePair([most(self.0[0], other.0[0]), most(self.0[1], other.0[1])])
    }

    /// The smaller of both.
    #[inline(always)]
    pub fn least(self) -> f64 {
        let [a, b] = self.0;
        if a < b { a } else { b }
    }

    /// The larger of both.
    #[inline(always)]
    pub fn most(self) -> f64 {
        let [a, b] = self.0;
        if a > b { a } else { b }
    }

    #[inline(always)]
    pub fn sum(self) -> f64 {
        self.0[0] + self.0[1]
    }
}

macro_rules! operation {
    ($kind:ident, $name:ident, $sign:tt) => {
        impl $kind for LanePair {
            type Output = LanePair;

            #[inline(always)]
            fn $name(self, other: LanePair) -> LanePair {
                LanePair([self.0[0] $sign other.0[0], self.0[1] $sign other.0[1]])
            }
        }
    };
}

operation!(Add, add, +);
operation!(Sub, sub, -);
operation!(Mul, mul, *);
operation!(Div, div, /);

impl AddAssign for LanePair {
    #[inline(always)]
    fn add_assign(&mut self, other: LanePair) {
        *self = *self + other;
    }
}

impl SubAssign for LanePair {
    #[inline(always)]
    fn sub_assign(&mut self, other: LanePair) {
        *self = *self - other;
    }
}

impl Default for LanePair {
    #[inline(always)]
    fn default() -> LanePair {
        LanePair::both(0.0)
    }
}

#[cfg(test)]
mod tests {
    use super::LanePair;

    #[test]
    fn each_number_is_worked_on_by_itself() {
        let (a, b) = (LanePair::new(3.0, -4.0), LanePair::new(0.3, 7.0));
        let pair = |two: LanePair| [two.first(), two.second()];
        assert_eq!(pair(a + b), [3.0 + 0.3, 3.0]);
        assert_eq!(pair(a - b), [3.0 - 0.3, -11.0]);
        assert_eq!(pair(a * b), [3.0 * 0.3, -28.0]);
        assert_eq!(pair(a / b), [3.0 / 0.3, -4.0 / 7.0]);
        assert_eq!(pair(a.min(b)), [0.3, -4.0]);
        assert_eq!(pair(a.max(b)), [3.0, 7.0]);
        assert_eq!(pair(LanePair::at(&[1.0, 2.0, 3.0], 1)), [2.0, 3.0]);
        assert_eq!(pair(LanePair::of(4, |k| k as f64)), [4.0, 5.0]);
        assert_eq!((a.sum(), a.least(), a.most()), (-1.0, -4.0, 3.0));
        assert_eq!(pair(LanePair::default()), [0.0; 2]);
    }

    #[test]
    fn what_is_not_a_number_gives_the_other() {
        let (one, none) = (LanePair::both(1.0), LanePair::both(f64::NAN));
        assert_eq!([none.min(one).first(), none.max(one).first()], [1.0; 2]);
        assert!(one.min(none).first().is_nan());
    }
}
