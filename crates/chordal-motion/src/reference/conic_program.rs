//! A convex program, row by row, and its solution.

use clarabel::algebra::CscMatrix;
use clarabel::solver::{
    DefaultSettings, DefaultSolver, IPSolver, NonnegativeConeT, SecondOrderConeT, SolverStatus,
    ZeroConeT,
};

/// An affine expression: Σ coefficient·variable + constant.
#[derive(Clone, Debug, Default)]
pub(crate) struct AffineExpression {
    pub(crate) terms: Vec<(usize, f64)>,
    pub(crate) constant: f64,
}

impl AffineExpression {
    pub(crate) fn constant(constant: f64) -> AffineExpression {
        AffineExpression { terms: Vec::new(), constant }
    }

    pub(crate) fn plus(mut self, variable: usize, coefficient: f64) -> AffineExpression {
        self.terms.push((variable, coefficient));
        self
    }

    /// The sum with `factor` times another.
    pub(crate) fn add(mut self, other: &AffineExpression, factor: f64) -> AffineExpression {
        self.terms.extend(other.terms.iter().map(|(index, value)| (*index, value * factor)));
        self.constant += other.constant * factor;
        self
    }

    pub(crate) fn times(mut self, factor: f64) -> AffineExpression {
        self.terms.iter_mut().for_each(|term| term.1 *= factor);
        self.constant *= factor;
        self
    }
}

/// Smallest `cost · x` where the expressions in `zero` vanish, those in `positive` are not
/// negative, and of each three in `cones` the first is no smaller than the length of the others.
#[derive(Debug, Default)]
pub(crate) struct ConicProgram {
    pub(crate) cost: Vec<f64>,
    pub(crate) zero: Vec<AffineExpression>,
    pub(crate) positive: Vec<AffineExpression>,
    pub(crate) cones: Vec<[AffineExpression; 3]>,
}

/// How a program ended without a solution.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct UnsolvedProgram;

impl ConicProgram {
    pub(crate) fn new(variables: usize) -> ConicProgram {
        ConicProgram { cost: vec![0.0; variables], ..ConicProgram::default() }
    }

    /// x·y ≥ 1 and both positive.
    pub(crate) fn product_above_one(&mut self, x: AffineExpression, y: &AffineExpression) {
        let sum = x.clone().add(y, 1.0);
        let difference = x.add(y, -1.0);
        self.cones.push([sum, AffineExpression::constant(2.0), difference]);
    }

    /// x² ≤ y.
    pub(crate) fn square_below(&mut self, x: AffineExpression, y: &AffineExpression) {
        let sum = AffineExpression::constant(1.0).add(y, 1.0);
        let difference = AffineExpression::constant(-1.0).add(y, 1.0);
        self.cones.push([sum, x.times(2.0), difference]);
    }

    /// Solves it. The solver runs in one thread and without a limit of time, so that the same
    /// program has the same solution to the bit.
    pub(crate) fn solve(&self) -> Result<Vec<f64>, UnsolvedProgram> {
        let columns = self.cost.len();
        let rows = self.zero.iter().chain(&self.positive).chain(self.cones.iter().flatten());
        // s = b − Ax lies in the cone: A holds the coefficients with the other sign.
        let (mut from, mut to, mut values, mut b) = (vec![], vec![], vec![], vec![]);
        for (index, row) in rows.enumerate() {
            b.push(row.constant);
            for (column, value) in &row.terms {
                from.push(index);
                to.push(*column);
                values.push(-value);
            }
        }
        let matrix = CscMatrix::new_from_triplets(b.len(), columns, from, to, values);
        let nothing = CscMatrix::zeros((columns, columns));
        let mut cones = vec![ZeroConeT(self.zero.len()), NonnegativeConeT(self.positive.len())];
        cones.extend(self.cones.iter().map(|_| SecondOrderConeT(3)));
        let settings = DefaultSettings {
            verbose: false,
            max_iter: 100,
            max_threads: 1,
            direct_solve_method: "qdldl".into(),
            presolve_enable: false,
            ..DefaultSettings::default()
        };
        let mut solver = DefaultSolver::new(&nothing, &self.cost, &matrix, &b, &cones, settings)
            .map_err(|_| UnsolvedProgram)?;
        solver.solve();
        match solver.solution.status {
            SolverStatus::Solved | SolverStatus::AlmostSolved => Ok(solver.solution.x.clone()),
            _ => Err(UnsolvedProgram),
        }
    }
}
