//! One linear program about a velocity profile: the largest use of any limit becomes as small as
//! can be while the run takes the same time.
//!
//! Variables by node: σ̇ and σ̈; by phase: its duration; all linear about the law before, as what
//! joins them is (`plan.rs`). Limits are V(1 + e), A(1 + 2e) and J(1 + 3e) with the least e:
//! stretched in time by 1 + e the law holds them.

use chordal_geometry::{AXES, PerAxis};

use super::plan::Plan;
use super::program::{Affine, Program, Unsolved};
use crate::bound::Run;
use crate::piece::Jet;
use crate::trajectory::Along;

/// Velocities and accelerations of which less than this share is used by the law before are
/// left out.
const USED: f64 = 0.5;

struct Polish<'a> {
    run: &'a Run<'a>,
    plan: &'a Plan,
    /// Scale of σ̈; σ̇ and durations are scaled by their values.
    acceleration: f64,
    program: Program,
}

/// The motion at a place of a phase: as it was, and as it may become.
struct Motion {
    was: Along,
    to_speed: Affine,
    to_acceleration: Affine,
    to_jerk: Affine,
}

/// A law of the same duration that uses the limits less; no speed and no duration may change by
/// more than the share `reach`.
pub(crate) fn polish(run: &Run<'_>, plan: &Plan, reach: f64) -> Result<Plan, Unsolved> {
    let phases = plan.span_s.len();
    let acceleration = plan.acceleration.iter().fold(0.0, |most: f64, a| most.max(a.abs()));
    let mut program = Program::new(3 * phases + 3);
    program.cost[3 * phases] = 1.0;
    let mut polish = Polish { run, plan, acceleration, program };
    let total = plan.duration_s();
    let mut same = Affine::default();
    for phase in 0..phases {
        polish.join(phase);
        polish.hold(phase);
        same = same.plus(3 * phase + 2, plan.span_s[phase] / total);
        let steps = if phase > 0 { vec![3 * phase, 3 * phase + 2] } else { vec![2] };
        for variable in steps {
            let change = Affine::default().plus(variable, 1.0 / reach);
            polish.within(&change, &Affine::constant(1.0));
        }
    }
    polish.program.zero.push(same);
    // Variable 0 and 1 belong to the first node, which is given.
    let mut x = polish.program.solve()?;
    x[..2].fill(0.0);
    let mut better = plan.clone();
    for node in 1..phases {
        better.speed[node] *= 1.0 + x[3 * node];
        better.acceleration[node] = x[3 * node + 1] * acceleration;
    }
    Ok(better)
}

impl Polish<'_> {
    fn given(&self, node: usize) -> bool {
        node == 0 || node == self.plan.span_s.len()
    }

    fn speed(&self, node: usize) -> Affine {
        let now = Affine::constant(self.plan.speed[node]);
        if self.given(node) { now } else { now.plus(3 * node, self.plan.speed[node]) }
    }

    fn acceleration(&self, node: usize) -> Affine {
        if self.given(node) {
            return Affine::default();
        }
        Affine::default().plus(3 * node + 1, self.acceleration)
    }

    /// Share by which the duration of a phase changes, times `factor`.
    fn longer(&self, phase: usize, factor: f64) -> Affine {
        Affine::default().plus(3 * phase + 2, factor)
    }

    /// 1 + `times`·e.
    fn limit(&self, times: f64) -> Affine {
        Affine::constant(1.0).plus(3 * self.plan.span_s.len(), times)
    }

    fn within(&mut self, share: &Affine, limit: &Affine) {
        self.program.positive.push(limit.clone().add(share, -1.0));
        self.program.positive.push(limit.clone().add(share, 1.0));
    }

    /// The motion of a phase leads from its first node to its last.
    fn join(&mut self, phase: usize) {
        let (plan, h) = (self.plan, self.plan.span_s[phase]);
        let (a0, a1) = (self.acceleration(phase), self.acceleration(phase + 1));
        let (v0, v1) = (self.speed(phase), self.speed(phase + 1));
        let (was0, was1) = (plan.acceleration[phase], plan.acceleration[phase + 1]);
        let way = plan.sigma[phase + 1] - plan.sigma[phase];
        let speed = v1
            .add(&v0, -1.0)
            .add(&a0, -0.5 * h)
            .add(&a1, -0.5 * h)
            .add(&self.longer(phase, -0.5 * h * (was0 + was1)), 1.0);
        let rate = h * (plan.speed[phase] + h * (2.0 * was0 + was1) / 3.0);
        let sigma = Affine::constant(way)
            .add(&v0, -h)
            .add(&a0, -h * h / 3.0)
            .add(&a1, -h * h / 6.0)
            .add(&self.longer(phase, -rate), 1.0);
        let size = plan.speed[phase].max(plan.speed[phase + 1]);
        self.program.zero.push(speed.times(1.0 / size));
        self.program.zero.push(sigma.times(1.0 / way));
    }

    fn motion(&self, phase: usize, f: f64) -> Motion {
        let (plan, h) = (self.plan, self.plan.span_s[phase]);
        let (a0, a1) = (plan.acceleration[phase], plan.acceleration[phase + 1]);
        let (to_a0, to_a1) = (self.acceleration(phase), self.acceleration(phase + 1));
        let (by_first, by_last) = (h * (f - 0.5 * f * f), h * 0.5 * f * f);
        let gained = by_first * a0 + by_last * a1;
        let jerk = (a1 - a0) / h;
        Motion {
            was: Along {
                sigma: plan.sigma[phase]
                    + h * f * (plan.speed[phase] + h * f * (a0 / 2.0 + h * f * jerk / 6.0)),
                speed: plan.speed[phase] + gained,
                acceleration: a0 * (1.0 - f) + a1 * f,
                jerk,
            },
            to_speed: self
                .speed(phase)
                .add(&to_a0, by_first)
                .add(&to_a1, by_last)
                .add(&self.longer(phase, gained), 1.0),
            to_acceleration: to_a0.clone().times(1.0 - f).add(&to_a1, f),
            to_jerk: to_a1.add(&to_a0, -1.0).times(1.0 / h).add(&self.longer(phase, -jerk), 1.0),
        }
    }

    /// All limits over a phase.
    fn hold(&mut self, phase: usize) {
        let middle = 0.5 * (self.plan.sigma[phase] + self.plan.sigma[phase + 1]);
        let piece = self.run.piece_at(middle);
        for f in [0.0, 0.5, 1.0] {
            let motion = self.motion(phase, f);
            let jet = self.run.jet(piece, motion.was.sigma);
            let straight = jet[2] == [0.0; AXES] && jet[3] == [0.0; AXES];
            self.hold_speed(piece, &jet, &motion);
            if !straight || f != 0.5 {
                self.hold_acceleration(&jet, &motion, straight);
            }
            if !straight || f == 0.5 {
                self.hold_jerk(&jet, &motion, straight);
            }
        }
    }

    fn hold_speed(&mut self, piece: usize, jet: &Jet, motion: &Motion) {
        let cap = self.run.speed_cap(piece, jet);
        if motion.was.speed > USED * cap {
            let left = self.limit(1.0).add(&motion.to_speed, -1.0 / cap);
            self.program.positive.push(left);
        }
    }

    fn hold_acceleration(&mut self, jet: &Jet, motion: &Motion, straight: bool) {
        let limits = self.run.limits().acceleration();
        let (v, a) = (motion.was.speed, motion.was.acceleration);
        if straight {
            let share = motion.to_acceleration.clone().times(tightest(jet, &limits));
            self.within(&share, &self.limit(2.0));
            return;
        }
        for axis in 0..AXES {
            let (d1, d2) = (jet[1][axis], jet[2][axis]);
            if (d1 * a).abs() + d2.abs() * v * v <= USED * limits[axis] {
                continue;
            }
            let share = Affine::constant(-d2 * v * v)
                .add(&motion.to_acceleration, d1)
                .add(&motion.to_speed, 2.0 * d2 * v)
                .times(1.0 / limits[axis]);
            self.within(&share, &self.limit(2.0));
        }
    }

    fn hold_jerk(&mut self, jet: &Jet, motion: &Motion, straight: bool) {
        let limits = self.run.limits().jerk();
        let (v, a) = (motion.was.speed, motion.was.acceleration);
        if straight {
            let share = motion.to_jerk.clone().times(tightest(jet, &limits));
            self.within(&share, &self.limit(3.0));
            return;
        }
        for axis in 0..AXES {
            let [_, d1, d2, d3] = jet.map(|row| row[axis]);
            if (d1, d2, d3) == (0.0, 0.0, 0.0) {
                continue;
            }
            let share = Affine::constant(-3.0 * d2 * v * a - 2.0 * d3 * v * v * v)
                .add(&motion.to_jerk, d1)
                .add(&motion.to_acceleration, 3.0 * d2 * v)
                .add(&motion.to_speed, 3.0 * (d2 * a + d3 * v * v))
                .times(1.0 / limits[axis]);
            self.within(&share, &self.limit(3.0));
        }
    }
}

/// On a straight line, the largest share of a limit that one unit along the path uses.
fn tightest(jet: &Jet, limits: &PerAxis<f64>) -> f64 {
    (0..AXES).fold(0.0, |most: f64, axis| most.max(jet[1][axis].abs() / limits[axis]))
}
