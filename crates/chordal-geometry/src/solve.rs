//! Bracketed root finding, and short lists of roots.

/// Newton's method inside a bracket, with bisection where it would leave the bracket or stall.
///
/// `f` returns value and derivative. `lo` and `hi` bracket a sign change; the result is always between them, even if `f`
/// returns NaN, after at most `MAX_STEPS` evaluations.
pub(crate) fn bracketed_root(f: impl Fn(f64) -> (f64, f64), mut lo: f64, mut hi: f64) -> f64 {
    // Bisection alone needs about 60 to reach neighbouring doubles; Newton needs 4 to 6.
    const MAX_STEPS: usize = 120;
    let rising = f(lo).0 <= 0.0;
    let mut x = 0.5 * (lo + hi);
    let mut last_step = hi - lo;
    for _ in 0..MAX_STEPS {
        let (value, slope) = f(x);
        if value == 0.0 || value.is_nan() {
            break;
        }
        if (value < 0.0) == rising {
            lo = x;
        } else {
            hi = x;
        }
        let newton = x - value / slope;
        let next = if newton > lo && newton < hi && (newton - x).abs() < 0.5 * last_step {
            newton
        } else {
            0.5 * (lo + hi)
        };
        last_step = (next - x).abs();
        // Two rounding errors of the larger end: a smaller step has no effect.
        let done = last_step <= 2.0 * f64::EPSILON * lo.abs().max(hi.abs());
        x = next;
        if done {
            break;
        }
    }
    x
}

/// A short ascending list on the stack. Values that do not fit are dropped, so a loop over it is bounded for every input.
#[derive(Clone, Copy)]
pub(crate) struct KnotList {
    values: [f64; Self::CAPACITY],
    len: usize,
}

impl KnotList {
    /// Intervals span at most two turns, which gives at most ten roots and two ends.
    const CAPACITY: usize = 24;

    pub(crate) fn new() -> Self {
        Self { values: [0.0; Self::CAPACITY], len: 0 }
    }

    pub(crate) fn push(&mut self, x: f64) {
        if self.len < Self::CAPACITY {
            self.values[self.len] = x;
            self.len += 1;
        }
    }

    pub(crate) fn as_slice(&self) -> &[f64] {
        &self.values[..self.len]
    }

    /// The sign changes of `f`, which is monotone between neighbouring knots, and both outermost knots, so that the
    /// result divides the same interval.
    pub(crate) fn refine(&self, f: impl Fn(f64) -> (f64, f64)) -> KnotList {
        let mut roots = KnotList::new();
        let knots = self.as_slice();
        let (Some(&first), Some(&last)) = (knots.first(), knots.last()) else { return roots };
        roots.push(first);
        let mut before = f(first).0;
        for pair in knots.windows(2) {
            let after = f(pair[1]).0;
            if (before <= 0.0) != (after <= 0.0) {
                roots.push(bracketed_root(&f, pair[0], pair[1]));
            }
            before = after;
        }
        roots.push(last);
        roots
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn finds_roots_of_either_slope() {
        let r = bracketed_root(|x| (x * x - 2.0, 2.0 * x), 0.0, 2.0);
        assert!((r - 2.0_f64.sqrt()).abs() < 1e-15);
        let r = bracketed_root(|x| (2.0 - x * x, -2.0 * x), 0.0, 2.0);
        assert!((r - 2.0_f64.sqrt()).abs() < 1e-15);
        // Slope zero at the root, and a slope that is always wrong.
        let r = bracketed_root(|x| (x * x * x, 3.0 * x * x), -1.0, 2.0);
        assert!(r.abs() < 1e-12);
        let r = bracketed_root(|x| (x - 0.3, 0.0), 0.0, 1.0);
        assert!((r - 0.3).abs() < 1e-15);
    }

    #[test]
    fn survives_nan() {
        let r = bracketed_root(|_| (f64::NAN, f64::NAN), 0.0, 1.0);
        assert!((0.0..=1.0).contains(&r));
        assert!(bracketed_root(|x| (x, 1.0), f64::NAN, 1.0).is_nan());
    }
}
