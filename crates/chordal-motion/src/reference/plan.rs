//! A law of time as phases of even jerk between nodes evenly spaced in time.

use super::Law;
use crate::bound::Run;
use crate::trajectory::Phase;

/// Where a run is at its nodes.
#[derive(Clone, Debug)]
pub(crate) struct Plan {
    /// Between nodes, s.
    pub(crate) step_s: f64,
    /// σ, σ̇ and σ̈ at the nodes.
    pub(crate) sigma: Vec<f64>,
    pub(crate) speed: Vec<f64>,
    pub(crate) acceleration: Vec<f64>,
}

impl Plan {
    /// A law of b over the path, read at even times. Not yet a true law of even jerks.
    pub(crate) fn of(law: &Law, nodes: usize) -> Plan {
        let clock = law.clock();
        let last = clock.len() - 1;
        let step_s = clock[last] / nodes as f64;
        let mut plan = Plan {
            step_s,
            sigma: vec![0.0; nodes + 1],
            speed: vec![0.0; nodes + 1],
            acceleration: vec![0.0; nodes + 1],
        };
        let mut cell = 0;
        for node in 0..=nodes {
            let now = if node == nodes { clock[last] } else { step_s * node as f64 };
            while cell + 1 < last && clock[cell + 1] <= now {
                cell += 1;
            }
            let way = law.sigma[cell + 1] - law.sigma[cell];
            let span = clock[cell + 1] - clock[cell];
            let share = ((now - clock[cell]) / span).clamp(0.0, 1.0);
            let (v0, v1) = (law.square[cell].sqrt(), law.square[cell + 1].sqrt());
            let (a0, a1) = (law.acceleration[cell], law.acceleration[cell + 1]);
            plan.sigma[node] =
                law.sigma[cell] + way * hermite(share, v0 * span / way, v1 * span / way);
            let rise = v1 - v0;
            plan.speed[node] = if rise == 0.0 {
                v0
            } else {
                v0 + rise * hermite(share, a0 * span / rise, a1 * span / rise)
            };
            plan.acceleration[node] = a0 + share * (a1 - a0);
        }
        plan
    }

    pub(crate) fn duration_s(&self) -> f64 {
        self.step_s * (self.sigma.len() - 1) as f64
    }

    /// The same, `factor` times as long.
    pub(crate) fn stretched(&self, factor: f64) -> Plan {
        Plan {
            step_s: self.step_s * factor,
            sigma: self.sigma.clone(),
            speed: self.speed.iter().map(|v| v / factor).collect(),
            acceleration: self.acceleration.iter().map(|a| a / (factor * factor)).collect(),
        }
    }

    /// The phases with the accelerations at the nodes, their jerks changed by as little as a
    /// parabola in time so that the run ends at its end and at rest.
    pub(crate) fn exact(&self, run: &Run<'_>) -> Plan {
        let phases = self.sigma.len() - 1;
        let h = self.step_s;
        let mut jerks: Vec<f64> =
            self.acceleration.windows(2).map(|ends| (ends[1] - ends[0]) / h).collect();
        let start = [0.0, self.speed[0], 0.0];
        let basis = |power: i32| -> Vec<f64> {
            (0..phases).map(|k| ((k as f64 + 0.5) / phases as f64 - 0.5).powi(power)).collect()
        };
        let bases = [basis(0), basis(1), basis(2)];
        let effect = [0, 1, 2].map(|index| end_of(h, [0.0; 3], &bases[index]));
        for _ in 0..3 {
            let end = end_of(h, start, &jerks);
            let missing = [run.length() - end[0], -end[1], -end[2]];
            let Some(share) = solve3(&effect, missing) else { break };
            for (index, jerk) in jerks.iter_mut().enumerate() {
                *jerk += (0..3).map(|b| share[b] * bases[b][index]).sum::<f64>();
            }
        }
        let mut plan = self.clone();
        let mut state = start;
        for (index, jerk) in jerks.iter().enumerate() {
            [plan.sigma[index], plan.speed[index], plan.acceleration[index]] = state;
            state = after(h, state, *jerk);
        }
        plan.sigma[phases] = run.length();
        plan.speed[phases] = 0.0;
        plan.acceleration[phases] = 0.0;
        plan
    }

    /// Whether it ever goes back.
    pub(crate) fn goes_back(&self) -> bool {
        let tiny = 1e-12 * self.speed.iter().fold(0.0, |most: f64, v| most.max(*v));
        let last = self.speed.len() - 1;
        (0..last).any(|node| {
            let (v0, v1) = (self.speed[node], self.speed[node + 1]);
            let (a0, a1) = (self.acceleration[node], self.acceleration[node + 1]);
            // Least where the acceleration is zero.
            let share = if a1 != a0 { a0 / (a0 - a1) } else { 0.0 };
            let least = v0 + 0.5 * self.step_s * a0 * share;
            v0.min(v1) < -tiny || (share > 0.0 && share < 1.0 && least < -tiny)
        })
    }

    /// Its phases. The last one ends at the end of the run but for rounding.
    pub(crate) fn phases(&self) -> Vec<Phase> {
        (0..self.sigma.len() - 1)
            .map(|node| Phase {
                duration_s: self.step_s,
                from: self.sigma[node],
                speed: self.speed[node],
                acceleration: self.acceleration[node],
                jerk: (self.acceleration[node + 1] - self.acceleration[node]) / self.step_s,
            })
            .collect()
    }
}

/// From 0 to 1 with slopes at the ends.
fn hermite(t: f64, slope0: f64, slope1: f64) -> f64 {
    let u = 1.0 - t;
    t * u * u * slope0 + t * t * (3.0 - 2.0 * t) - t * t * u * slope1
}

fn after(h: f64, [s, v, a]: [f64; 3], jerk: f64) -> [f64; 3] {
    [s + h * (v + h * (a / 2.0 + h * jerk / 6.0)), v + h * (a + h * jerk / 2.0), a + h * jerk]
}

fn end_of(h: f64, start: [f64; 3], jerks: &[f64]) -> [f64; 3] {
    jerks.iter().fold(start, |state, jerk| after(h, state, *jerk))
}

/// Shares of three columns that make up a vector.
fn solve3(columns: &[[f64; 3]; 3], right: [f64; 3]) -> Option<[f64; 3]> {
    let determinant = |a: [f64; 3], b: [f64; 3], c: [f64; 3]| {
        a[0] * (b[1] * c[2] - b[2] * c[1]) - b[0] * (a[1] * c[2] - a[2] * c[1])
            + c[0] * (a[1] * b[2] - a[2] * b[1])
    };
    let [a, b, c] = *columns;
    let whole = determinant(a, b, c);
    let shares = [
        determinant(right, b, c) / whole,
        determinant(a, right, c) / whole,
        determinant(a, b, right) / whole,
    ];
    shares.iter().all(|share| share.is_finite()).then_some(shares)
}
