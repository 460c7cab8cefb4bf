//! Equations with few unknowns each, and symmetric band matrices.

/// The terms of an equation: the index of an unknown and its coefficient. The equation of a joint has the most terms: two
/// coordinates of three joints, and the bulges of two pieces.
#[derive(Clone, Copy, Default)]
pub(super) struct EquationTerms {
    terms: [(usize, f64); 8],
    count: usize,
}

impl EquationTerms {
    pub(super) fn push(&mut self, unknown: usize, factor: f64) {
        self.terms[self.count] = (unknown, factor);
        self.count += 1;
    }

    pub(super) fn iter(&self) -> impl Iterator<Item = (usize, f64)> + '_ {
        self.terms[..self.count].iter().copied()
    }

    /// The scalar product of the coefficients of two equations, with a weight for each unknown.
    pub(super) fn product(&self, other: &EquationTerms, weight: impl Fn(usize) -> f64) -> f64 {
        let mut sum = 0.0;
        for (one, a) in self.iter() {
            for (two, b) in other.iter() {
                if one == two {
                    sum += a * b * weight(one);
                }
            }
        }
        sum
    }
}

/// A symmetric band matrix: each row has the diagonal and the entries after it, `W` in total.
#[derive(Clone)]
pub(super) struct BandMatrix<const W: usize> {
    pub(super) rows: Vec<[f64; W]>,
}

impl<const W: usize> BandMatrix<W> {
    pub(super) fn new(unknowns: usize) -> BandMatrix<W> {
        BandMatrix { rows: vec![[0.0; W]; unknowns] }
    }

    /// Adds an equation with a weight to the normal equations of a least-squares problem.
    pub(super) fn add(
        &mut self,
        right: &mut [f64],
        terms: &EquationTerms,
        value: f64,
        weight: f64,
    ) {
        for (one, a) in terms.iter() {
            right[one] += weight * a * value;
            for (other, b) in terms.iter() {
                if other >= one {
                    self.rows[one][other - one] += weight * a * b;
                }
            }
        }
    }

    /// Factors the matrix without pivoting, which is stable because it is positive definite. `None` if it is not.
    pub(super) fn factored(mut self) -> Option<FactoredBand<W>> {
        let count = self.rows.len();
        for row in 0..count {
            let pivot = self.rows[row];
            if !(pivot[0] > 0.0 && pivot[0].is_finite()) {
                return None;
            }
            for shift in 1..W.min(count - row) {
                let factor = pivot[shift] / pivot[0];
                if factor != 0.0 {
                    for (entry, following) in self.rows[row + shift].iter_mut().zip(&pivot[shift..])
                    {
                        *entry -= factor * following;
                    }
                }
            }
        }
        Some(FactoredBand { rows: self.rows })
    }
}

/// A factored band matrix.
pub(super) struct FactoredBand<const W: usize> {
    rows: Vec<[f64; W]>,
}

impl<const W: usize> FactoredBand<W> {
    pub(super) fn solve(&self, mut right: Vec<f64>) -> Vec<f64> {
        let count = self.rows.len();
        for row in 0..count {
            let part = right[row] / self.rows[row][0];
            for shift in 1..W.min(count - row) {
                right[row + shift] -= self.rows[row][shift] * part;
            }
        }
        for row in (0..count).rev() {
            let mut value = right[row];
            for shift in 1..W.min(count - row) {
                value -= self.rows[row][shift] * right[row + shift];
            }
            right[row] = value / self.rows[row][0];
        }
        right
    }
}
