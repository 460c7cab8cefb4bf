//! A velocity profile as phases of even jerk between places of the path.
//!
//! Between two places σ̈ grows evenly in time, so that the accelerations at the places say it
//! all: with Δ the way and h the time, Δ = v₀h + (2a₀ + a₁)h²/6 and v₁ = v₀ + (a₀ + a₁)h/2. From
//! rest this is σ = jt³/6. Phases begin and end where pieces do, because there the jerk of the
//! axes has a step that the jerk along the path must answer.

use super::Law;
use crate::trajectory::Phase;

/// Where a run is at its nodes.
#[derive(Clone, Debug)]
pub(crate) struct Plan {
    /// σ, σ̇ and σ̈ at the nodes.
    pub(crate) sigma: Vec<f64>,
    pub(crate) speed: Vec<f64>,
    pub(crate) acceleration: Vec<f64>,
    /// How long each phase takes, s.
    pub(crate) span_s: Vec<f64>,
}

/// Steps of the search for the law that meets in the middle.
const STEPS: usize = 30;

impl Plan {
    /// A law of b over the path as phases between its nodes.
    pub(crate) fn of(law: &Law) -> Option<Plan> {
        let last = law.sigma.len() - 1;
        let plan = Plan {
            sigma: law.sigma.clone(),
            speed: law.square.iter().map(|square| square.sqrt()).collect(),
            acceleration: law.acceleration.clone(),
            span_s: vec![0.0; last],
        };
        plan.exact()
    }

    pub(crate) fn duration_s(&self) -> f64 {
        self.span_s.iter().sum()
    }

    /// The same, `factor` times as long.
    pub(crate) fn stretched(&self, factor: f64) -> Plan {
        Plan {
            sigma: self.sigma.clone(),
            speed: self.speed.iter().map(|v| v / factor).collect(),
            acceleration: self.acceleration.iter().map(|a| a / (factor * factor)).collect(),
            span_s: self.span_s.iter().map(|h| h * factor).collect(),
        }
    }

    /// The true law near this one: speeds and times follow from the accelerations, forwards from
    /// the start and backwards from the end to the fastest node; they are changed by a multiple
    /// of σ̇², a slow change of the pace, until both meet there.
    pub(crate) fn exact(&self) -> Option<Plan> {
        let top = (1..self.sigma.len() - 1)
            .max_by(|a, b| self.speed[*a].total_cmp(&self.speed[*b]))
            .unwrap_or(1);
        let length = self.sigma[self.sigma.len() - 1];
        let gap = |share: f64| {
            let plan = self.bent(share / length, top)?;
            let (ahead, behind) = plan.1;
            Some((plan.0, (ahead - behind) / self.speed[top]))
        };
        let (mut x0, mut x1) = (0.0, 1e-3);
        let (mut plan, mut gap0) = gap(x0)?;
        for _ in 0..STEPS {
            if gap0.abs() < 1e-14 {
                break;
            }
            let (next, gap1) = gap(x1)?;
            let step = gap1 * (x1 - x0) / (gap1 - gap0);
            (plan, x0, gap0) = (next, x1, gap1);
            if !step.is_finite() {
                break;
            }
            x1 -= step.clamp(-1.0, 1.0);
        }
        (gap0.abs() < 1e-11).then_some(plan)
    }

    /// The law with its accelerations changed, and its two speeds at node `top`.
    fn bent(&self, share: f64, top: usize) -> Option<(Plan, (f64, f64))> {
        let mut plan = self.clone();
        let last = plan.sigma.len() - 1;
        for (node, a) in plan.acceleration.iter_mut().enumerate().take(last).skip(1) {
            *a += share * self.speed[node] * self.speed[node];
        }
        plan.acceleration[last] = 0.0;
        plan.speed[last] = 0.0;
        for node in 0..top {
            let way = plan.sigma[node + 1] - plan.sigma[node];
            let (a0, a1) = (plan.acceleration[node], plan.acceleration[node + 1]);
            (plan.span_s[node], plan.speed[node + 1]) = phase(way, plan.speed[node], a0, a1)?;
        }
        let ahead = plan.speed[top];
        for node in (top..last).rev() {
            let way = plan.sigma[node + 1] - plan.sigma[node];
            let (a0, a1) = (plan.acceleration[node], plan.acceleration[node + 1]);
            (plan.span_s[node], plan.speed[node]) = phase(way, plan.speed[node + 1], -a1, -a0)?;
        }
        let behind = plan.speed[top];
        Some((plan, (ahead, behind)))
    }

    /// Whether it ever goes back.
    pub(crate) fn goes_back(&self) -> bool {
        self.phases().iter().any(|phase| {
            let still = -phase.acceleration / phase.jerk;
            let inside = still > 0.0 && still < phase.duration_s;
            let tiny = 1e-12 * phase.duration_s * phase.acceleration.abs();
            phase.speed < 0.0 || (inside && phase.at(still).speed < -tiny)
        })
    }

    /// Its phases; σ and its first two derivatives have no steps, and the end is the end.
    pub(crate) fn phases(&self) -> Vec<Phase> {
        (0..self.span_s.len())
            .map(|node| Phase {
                duration_s: self.span_s[node],
                from: self.sigma[node],
                speed: self.speed[node],
                acceleration: self.acceleration[node],
                jerk: (self.acceleration[node + 1] - self.acceleration[node]) / self.span_s[node],
            })
            .collect()
    }
}

/// How long a way takes from a speed with these accelerations at its ends, and the speed then.
fn phase(way: f64, speed: f64, a0: f64, a1: f64) -> Option<(f64, f64)> {
    let root = (speed * speed + way * (2.0 * a0 + a1) / 1.5).sqrt();
    let span_s = 2.0 * way / (speed + root);
    let after = speed + 0.5 * span_s * (a0 + a1);
    (span_s > 0.0 && span_s.is_finite() && after > 0.0).then_some((span_s, after))
}
