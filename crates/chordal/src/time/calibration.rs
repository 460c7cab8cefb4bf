//! Fits a machine's limits to measured cycle times.
//!
//! Three numbers are fitted: a factor on every acceleration, a factor on every jerk, and the time of a tool change.
//! Damped Gauss-Newton steps (Levenberg-Marquardt) on the logarithms of the factors and the seconds of the tool
//! change minimize the sum of squares of the relative errors. Logarithms keep the factors positive.

use chordal_machine::Machine;

use crate::motion::{LimitError, MachineLimits};

/// A number that is fitted.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum FitParameter {
    /// The factor on accelerations.
    Acceleration,
    /// The factor on jerks.
    Jerk,
    /// The time of a tool change.
    ToolChange,
}

impl FitParameter {
    /// All of them.
    pub const ALL: [FitParameter; 3] =
        [FitParameter::Acceleration, FitParameter::Jerk, FitParameter::ToolChange];

    /// The word for people and programs.
    pub fn word(self) -> &'static str {
        match self {
            FitParameter::Acceleration => "acceleration",
            FitParameter::Jerk => "jerk",
            FitParameter::ToolChange => "tool change",
        }
    }
}

/// The values of the fitted parameters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LimitFactors {
    /// Factor on the acceleration of every axis.
    pub acceleration: f64,
    /// Factor on the jerk of every axis.
    pub jerk: f64,
    /// Time of a tool change, s.
    pub tool_change_s: f64,
}

impl LimitFactors {
    /// The machine with these factors on its limits; limits that its file does not give have their typical values.
    ///
    /// # Errors
    /// A limit of an axis that is not a positive number.
    pub fn on(&self, machine: &Machine) -> Result<Machine, LimitError> {
        let limits = MachineLimits::of(machine)?;
        let mut machine = machine.clone();
        for (index, axis) in machine.axes.iter_mut().enumerate() {
            let (Some(axis), Some(cut)) = (axis, limits.cut.axis(index)) else { continue };
            axis.max_acceleration = Some(cut.acceleration * self.acceleration);
            axis.max_jerk = Some(cut.jerk * self.jerk);
            axis.rapid_acceleration = axis.rapid_acceleration.map(|a| a * self.acceleration);
            axis.rapid_jerk = axis.rapid_jerk.map(|j| j * self.jerk);
        }
        machine.times.tool_change_s = Some(self.tool_change_s);
        Ok(machine)
    }
}

/// The cycle time of a program with some factors.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TimePrediction {
    /// Time without the tool changes, s.
    pub without_changes_s: f64,
    /// Number of tool changes.
    pub tool_changes: u64,
}

/// Why a parameter was not fitted and keeps its value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum UnfitReason {
    /// The times of these programs hardly depend on it.
    NoEffect,
    /// In these programs its effect is the same as that of other parameters, most of all of this one.
    SameAs(FitParameter),
    /// There are no more programs than parameters that are fitted already.
    TooFew,
}

/// The result of a fit.
#[derive(Clone, Debug, PartialEq)]
pub struct LimitFit {
    /// The fitted numbers; those that the programs do not determine keep their value.
    pub factors: LimitFactors,
    /// Parameters that these programs do not determine.
    pub undetermined: Vec<(FitParameter, UnfitReason)>,
    /// Each program's time as measured, predicted before and after, s.
    pub programs: Vec<FittedProgram>,
}

/// One program of a fit, s.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FittedProgram {
    /// Measured on the machine.
    pub measured_s: f64,
    /// Predicted with the machine file as it is.
    pub before_s: f64,
    /// Predicted with the fitted numbers.
    pub after_s: f64,
}

impl LimitFit {
    /// True where as many numbers were fitted as there are programs, so that the remaining error says nothing about
    /// the fit.
    pub fn is_exact_by_count(&self) -> bool {
        FitParameter::ALL.len() - self.undetermined.len() >= self.programs.len()
    }

    /// Root mean square of the relative errors that remain.
    pub fn error(&self) -> f64 {
        let square = |p: &FittedProgram| (p.after_s / p.measured_s - 1.0).powi(2);
        let sum: f64 = self.programs.iter().map(square).sum();
        (sum / self.programs.len().max(1) as f64).sqrt()
    }
}

/// Most Gauss-Newton steps of the fit.
const MAX_FIT_STEPS: u32 = 40;

/// Half the step of the central differences, in logarithms and in seconds: wide enough to average over small jumps of
/// the planned time.
const SLOPE_HALF_STEP: f64 = 0.02;

/// Factors stay between 1 / this and this.
const MAX_FACTOR: f64 = 100.0;

/// A parameter has no effect where a change by a factor e (or by a second) changes the times by less than this share,
/// as root sum of squares over the programs.
const MIN_EFFECT_SHARE: f64 = 2e-3;

/// A parameter whose effect others reproduce up to less than this share of it counts as the same as those.
const MIN_OWN_EFFECT_SHARE: f64 = 0.05;

/// The fit has converged when a step is smaller than this.
const SETTLED_STEP: f64 = 1e-9;

/// Fits the factors to measured times, s. `predict` returns the time of a program, by its index, with given factors.
pub fn fit(
    measured_s: &[f64],
    start: LimitFactors,
    predict: impl FnMut(usize, &LimitFactors) -> TimePrediction,
) -> LimitFit {
    let mut problem = FitProblem { measured_s, predict };
    let from = FitPoint::of(&start);
    let before = problem.predict_all(&from);
    let (chosen, undetermined) = determined(&problem.slopes(&from));
    let point = problem.descend(from, &chosen);
    let after = problem.predict_all(&point);
    let programs = measured_s
        .iter()
        .zip(before.iter().zip(&after))
        .map(|(measured_s, (before_s, after_s))| FittedProgram {
            measured_s: *measured_s,
            before_s: *before_s,
            after_s: *after_s,
        })
        .collect();
    LimitFit { factors: point.factors(), undetermined, programs }
}

/// Logarithms of the two factors, and the seconds of a tool change.
#[derive(Clone, Copy, Debug)]
struct FitPoint([f64; 3]);

impl FitPoint {
    fn of(factors: &LimitFactors) -> FitPoint {
        FitPoint([
            libm::log(factors.acceleration),
            libm::log(factors.jerk),
            factors.tool_change_s.max(0.0),
        ])
    }

    fn factors(&self) -> LimitFactors {
        let [acceleration, jerk, tool_change_s] = self.0;
        let (acceleration, jerk) = (libm::exp(acceleration), libm::exp(jerk));
        LimitFactors { acceleration, jerk, tool_change_s }
    }

    fn plus(&self, at: usize, by: f64) -> FitPoint {
        let mut point = *self;
        point.0[at] += by;
        point
    }

    fn within_reason(mut self) -> FitPoint {
        let farthest = libm::log(MAX_FACTOR);
        for value in &mut self.0[..2] {
            *value = value.clamp(-farthest, farthest);
        }
        self.0[2] = self.0[2].max(0.0);
        self
    }
}

/// For each program, the derivative of its relative error by each parameter.
type ErrorSlopes = Vec<[f64; 3]>;

struct FitProblem<'a, P> {
    measured_s: &'a [f64],
    predict: P,
}

impl<P: FnMut(usize, &LimitFactors) -> TimePrediction> FitProblem<'_, P> {
    fn predict_all(&mut self, point: &FitPoint) -> Vec<f64> {
        let factors = point.factors();
        (0..self.measured_s.len())
            .map(|index| {
                let prediction = (self.predict)(index, &factors);
                prediction.without_changes_s
                    + prediction.tool_changes as f64 * factors.tool_change_s
            })
            .collect()
    }

    fn errors(&mut self, point: &FitPoint) -> Vec<f64> {
        let predicted = self.predict_all(point);
        predicted.iter().zip(self.measured_s).map(|(p, m)| p / m - 1.0).collect()
    }

    fn slopes(&mut self, point: &FitPoint) -> ErrorSlopes {
        let mut slopes = vec![[0.0; 3]; self.measured_s.len()];
        for parameter in 0..3 {
            let above = self.errors(&point.plus(parameter, SLOPE_HALF_STEP));
            let below = self.errors(&point.plus(parameter, -SLOPE_HALF_STEP));
            for (row, (above, below)) in slopes.iter_mut().zip(above.iter().zip(below)) {
                row[parameter] = (above - below) / (2.0 * SLOPE_HALF_STEP);
            }
        }
        slopes
    }

    /// Gauss-Newton steps, damped until they reduce the errors.
    fn descend(&mut self, start: FitPoint, chosen: &[usize]) -> FitPoint {
        let mut point = start;
        let mut errors = self.errors(&point);
        let mut damping = 1e-6;
        for _ in 0..MAX_FIT_STEPS {
            let slopes = self.slopes(&point);
            let step = loop {
                let step = newton_step(&slopes, &errors, chosen, damping);
                let next =
                    FitPoint(std::array::from_fn(|at| point.0[at] + step[at])).within_reason();
                let there = self.errors(&next);
                if squares(&there) < squares(&errors) {
                    (point, errors) = (next, there);
                    damping = f64::max(damping / 10.0, 1e-9);
                    break Some(step);
                }
                damping *= 10.0;
                if damping > 1e6 {
                    break None;
                }
            };
            match step {
                Some(step) if step.iter().any(|by| by.abs() > SETTLED_STEP) => {}
                _ => break,
            }
        }
        point
    }
}

fn squares(errors: &[f64]) -> f64 {
    errors.iter().map(|error| error * error).sum()
}

/// The damped least-squares step of the linear model in the chosen parameters.
fn newton_step(slopes: &ErrorSlopes, errors: &[f64], chosen: &[usize], damping: f64) -> [f64; 3] {
    let mut matrix = [[0.0; 4]; 3];
    for (row, error) in slopes.iter().zip(errors) {
        for &a in chosen {
            for &b in chosen {
                matrix[a][b] += row[a] * row[b];
            }
            matrix[a][3] -= row[a] * error;
        }
    }
    for (at, row) in matrix.iter_mut().enumerate() {
        row[at] = if chosen.contains(&at) { row[at] * (1.0 + damping) } else { 1.0 };
    }
    // Gauss-Jordan elimination: the matrix is symmetric and positive definite, so no pivoting is needed.
    for at in 0..3 {
        let pivot = matrix[at];
        for (other, row) in matrix.iter_mut().enumerate() {
            let factor = row[at] / pivot[at];
            if other != at && factor.is_finite() {
                row.iter_mut().zip(pivot).for_each(|(value, p)| *value -= factor * p);
            }
        }
    }
    std::array::from_fn(|at| {
        let value = matrix[at][3] / matrix[at][at];
        if value.is_finite() { value } else { 0.0 }
    })
}

/// The parameters that the slopes separate, and why not the others. The parameter with the largest effect is taken
/// first, then the one with the largest effect that is orthogonal to the first, and so on (Gram-Schmidt with
/// pivoting).
fn determined(slopes: &ErrorSlopes) -> (Vec<usize>, Vec<(FitParameter, UnfitReason)>) {
    let column = |at: usize| -> Vec<f64> { slopes.iter().map(|row| row[at]).collect() };
    let whole: [Vec<f64>; 3] = std::array::from_fn(column);
    let mut left = whole.clone();
    let mut chosen: Vec<usize> = Vec::new();
    while chosen.len() < slopes.len().min(3) {
        let open = (0..3).filter(|at| {
            let (own, all) = (squares(&left[*at]).sqrt(), squares(&whole[*at]).sqrt());
            !chosen.contains(at) && own > MIN_EFFECT_SHARE && own > MIN_OWN_EFFECT_SHARE * all
        });
        let best = open.max_by(|a, b| squares(&left[*a]).total_cmp(&squares(&left[*b])));
        let Some(best) = best else { break };
        chosen.push(best);
        let along = left[best].clone();
        let length = squares(&along);
        for (_, other) in left.iter_mut().enumerate().filter(|(at, _)| !chosen.contains(at)) {
            let part = dot(other, &along) / length;
            other.iter_mut().zip(&along).for_each(|(value, a)| *value -= part * a);
        }
    }
    let why = |at: usize| {
        if squares(&whole[at]).sqrt() <= MIN_EFFECT_SHARE {
            return UnfitReason::NoEffect;
        }
        let alike = |other: usize| {
            dot(&whole[at], &whole[other]).abs()
                / (squares(&whole[at]) * squares(&whole[other])).sqrt()
        };
        let nearest = chosen.iter().copied().max_by(|a, b| alike(*a).total_cmp(&alike(*b)));
        match nearest {
            Some(other) if slopes.len() > chosen.len() => {
                UnfitReason::SameAs(FitParameter::ALL[other])
            }
            _ => UnfitReason::TooFew,
        }
    };
    let undetermined = (0..3)
        .filter(|at| !chosen.contains(at))
        .map(|at| (FitParameter::ALL[at], why(at)))
        .collect();
    chosen.sort_unstable();
    (chosen, undetermined)
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A program of moves from rest to rest of some lengths at a speed: each takes its length
    /// over speed, and speed over acceleration, and acceleration over jerk.
    struct TestProgram {
        moves: f64,
        length: f64,
        speed: f64,
        changes: u64,
    }

    fn seconds(program: &TestProgram, factors: &LimitFactors) -> TimePrediction {
        let (a, j) = (2000.0 * factors.acceleration, 50_000.0 * factors.jerk);
        let once = program.length / program.speed + program.speed / a + a / j;
        TimePrediction { without_changes_s: program.moves * once, tool_changes: program.changes }
    }

    const PROGRAMS: [TestProgram; 5] = [
        TestProgram { moves: 1000.0, length: 30.0, speed: 50.0, changes: 4 },
        TestProgram { moves: 300.0, length: 200.0, speed: 300.0, changes: 1 },
        TestProgram { moves: 5000.0, length: 5.0, speed: 100.0, changes: 0 },
        TestProgram { moves: 10.0, length: 400.0, speed: 20.0, changes: 20 },
        TestProgram { moves: 2000.0, length: 60.0, speed: 400.0, changes: 2 },
    ];

    const START: LimitFactors = LimitFactors { acceleration: 1.0, jerk: 1.0, tool_change_s: 5.0 };

    fn measure(programs: &[TestProgram], truth: &LimitFactors) -> Vec<f64> {
        programs
            .iter()
            .map(|program| {
                let prediction = seconds(program, truth);
                prediction.without_changes_s + prediction.tool_changes as f64 * truth.tool_change_s
            })
            .collect()
    }

    #[test]
    fn known_limits_are_found_again() {
        for truth in [
            LimitFactors { acceleration: 0.6, jerk: 2.5, tool_change_s: 8.5 },
            LimitFactors { acceleration: 1.7, jerk: 0.4, tool_change_s: 1.2 },
            START,
        ] {
            let measured = measure(&PROGRAMS, &truth);
            let fit = fit(&measured, START, |index, factors| seconds(&PROGRAMS[index], factors));
            assert_eq!(fit.undetermined, []);
            assert!((fit.factors.acceleration / truth.acceleration - 1.0).abs() < 1e-6, "{fit:?}");
            assert!((fit.factors.jerk / truth.jerk - 1.0).abs() < 1e-6, "{fit:?}");
            assert!((fit.factors.tool_change_s - truth.tool_change_s).abs() < 1e-6, "{fit:?}");
            assert!(fit.error() < 1e-8);
            assert!(!fit.is_exact_by_count());
        }
    }

    /// Measurements that are off by up to a percent give limits that are off by little, and
    /// errors that remain of that size.
    #[test]
    fn errors_of_the_watch_remain() {
        let truth = LimitFactors { acceleration: 0.6, jerk: 2.5, tool_change_s: 8.5 };
        let mut measured = measure(&PROGRAMS, &truth);
        for (seconds, off) in measured.iter_mut().zip([1.01, 0.995, 1.0, 1.005, 0.99]) {
            *seconds *= off;
        }
        let fit = fit(&measured, START, |index, factors| seconds(&PROGRAMS[index], factors));
        assert!((fit.factors.acceleration / truth.acceleration - 1.0).abs() < 0.15, "{fit:?}");
        assert!((1e-4..0.01).contains(&fit.error()), "{}", fit.error());
        let worse = fit
            .programs
            .iter()
            .filter(|p| (p.after_s - p.measured_s).abs() > (p.before_s - p.measured_s).abs());
        assert_eq!(worse.count(), 0, "{fit:?}");
    }

    #[test]
    fn what_programs_do_not_determine_stays() {
        let truth = LimitFactors { acceleration: 0.6, jerk: 2.5, tool_change_s: 8.5 };
        let fit_of = |programs: &[TestProgram]| {
            let measured = measure(programs, &truth);
            fit(&measured, START, |index, factors| seconds(&programs[index], factors))
        };
        // One program: one number.
        let one = fit_of(&PROGRAMS[..1]);
        assert_eq!(one.undetermined.len(), 2);
        assert!(one.undetermined.iter().all(|(_, why)| *why == UnfitReason::TooFew), "{one:?}");
        assert!(one.is_exact_by_count());
        // No tool changes: nothing about their time.
        let without = |moves, length, speed| TestProgram { moves, length, speed, changes: 0 };
        let dry = [without(10.0, 5.0, 100.0), without(10.0, 50.0, 300.0), without(10.0, 9.0, 20.0)];
        let fit = fit_of(&dry);
        assert_eq!(fit.undetermined, [(FitParameter::ToolChange, UnfitReason::NoEffect)]);
        assert_eq!(fit.factors.tool_change_s, START.tool_change_s);
        assert!((fit.factors.jerk / truth.jerk - 1.0).abs() < 1e-6);
        // All moves alike: acceleration and jerk do the same.
        let alike = [
            TestProgram { moves: 10.0, length: 50.0, speed: 100.0, changes: 1 },
            TestProgram { moves: 20.0, length: 50.0, speed: 100.0, changes: 0 },
            TestProgram { moves: 30.0, length: 50.0, speed: 100.0, changes: 5 },
        ];
        let fit = fit_of(&alike);
        assert!(
            matches!(
                fit.undetermined.as_slice(),
                [(FitParameter::Jerk, UnfitReason::SameAs(FitParameter::Acceleration))]
                    | [(FitParameter::Acceleration, UnfitReason::SameAs(FitParameter::Jerk))]
            ),
            "{fit:?}"
        );
    }
}
