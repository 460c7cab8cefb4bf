//! Two numbers that are worked on as one: those of two cells that follow each other.
//!
//! Two neighbours in memory that see the same operations become one instruction of the baseline of x86-64
//! each; the results are those of each number by itself, so they are the same to the bit everywhere.

use std::ops::{Add, AddAssign, Div, Mul, Sub, SubAssign};

/// Two numbers.
#[derive(Clone, Copy, Debug)]
#[repr(align(16))]
pub(super) struct Two([f64; 2]);

impl Two {
    #[inline(always)]
    pub fn new(first: f64, second: f64) -> Two {
        Two([first, second])
    }

    /// The same number twice.
    #[inline(always)]
    pub fn both(value: f64) -> Two {
        Two([value; 2])
    }

    /// The two that begin at a place of a list.
    #[inline(always)]
    pub fn at(list: &[f64], index: usize) -> Two {
        Two([list[index], list[index + 1]])
    }

    /// A value of each of two that follow each other.
    pub fn of(index: usize, value: impl Fn(usize) -> f64) -> Two {
        Two([value(index), value(index + 1)])
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
    pub fn min(self, other: Two) -> Two {
        let least = |a: f64, b: f64| if a < b { a } else { b };
        Two([least(self.0[0], other.0[0]), least(self.0[1], other.0[1])])
    }

    /// The larger of each; the other's where one is not a number.
    #[inline(always)]
    pub fn max(self, other: Two) -> Two {
        let most = |a: f64, b: f64| if a > b { a } else { b };
        Two([most(self.0[0], other.0[0]), most(self.0[1], other.0[1])])
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
        impl $kind for Two {
            type Output = Two;

            #[inline(always)]
            fn $name(self, other: Two) -> Two {
                Two([self.0[0] $sign other.0[0], self.0[1] $sign other.0[1]])
            }
        }
    };
}

operation!(Add, add, +);
operation!(Sub, sub, -);
operation!(Mul, mul, *);
operation!(Div, div, /);

impl AddAssign for Two {
    #[inline(always)]
    fn add_assign(&mut self, other: Two) {
        *self = *self + other;
    }
}

impl SubAssign for Two {
    #[inline(always)]
    fn sub_assign(&mut self, other: Two) {
        *self = *self - other;
    }
}

impl Default for Two {
    #[inline(always)]
    fn default() -> Two {
        Two::both(0.0)
    }
}

#[cfg(test)]
mod tests {
    use super::Two;

    #[test]
    fn each_number_is_worked_on_by_itself() {
        let (a, b) = (Two::new(3.0, -4.0), Two::new(0.3, 7.0));
        let pair = |two: Two| [two.first(), two.second()];
        assert_eq!(pair(a + b), [3.0 + 0.3, 3.0]);
        assert_eq!(pair(a - b), [3.0 - 0.3, -11.0]);
        assert_eq!(pair(a * b), [3.0 * 0.3, -28.0]);
        assert_eq!(pair(a / b), [3.0 / 0.3, -4.0 / 7.0]);
        assert_eq!(pair(a.min(b)), [0.3, -4.0]);
        assert_eq!(pair(a.max(b)), [3.0, 7.0]);
        assert_eq!(pair(Two::at(&[1.0, 2.0, 3.0], 1)), [2.0, 3.0]);
        assert_eq!(pair(Two::of(4, |k| k as f64)), [4.0, 5.0]);
        assert_eq!((a.sum(), a.least(), a.most()), (-1.0, -4.0, 3.0));
        assert_eq!(pair(Two::default()), [0.0; 2]);
    }

    #[test]
    fn what_is_not_a_number_gives_the_other() {
        let (one, none) = (Two::both(1.0), Two::both(f64::NAN));
        assert_eq!([none.min(one).first(), none.max(one).first()], [1.0; 2]);
        assert!(one.min(none).first().is_nan());
    }
}
