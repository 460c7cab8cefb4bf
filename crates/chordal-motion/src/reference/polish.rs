//! One linear programme about a law of time: the largest use of any limit becomes as small as
//! can be while the run takes the same time.
//!
//! Between nodes the jerk along the path is even, so the motion is exact and linear in the
//! accelerations at the nodes; where the axes are on the path is linear about the law before.
//! Limits are V(1 + e), A(1 + 2e) and J(1 + 3e) with the least e: stretched in time by 1 + e the
//! law holds them.

use super::plan::Plan;
use super::program::{Affine, Program, Unsolved};
use crate::bound::Run;
use crate::piece::Jet;

/// Limits of which less than this is used by the law before are left out.
const USED: f64 = 0.5;
/// Seams of pieces this share of a phase away are looked at from both sides.
const BESIDE: f64 = 0.3;
/// Least share of the speed before at a node.
const KEPT: f64 = 0.5;

struct Polish<'a> {
    run: &'a Run<'a>,
    plan: &'a Plan,
    /// Scales of σ and σ̈; σ̇ is scaled by its value.
    sigma: f64,
    acceleration: f64,
    program: Program,
}

/// The motion at a place of a phase: as it was, and as it may become.
struct Motion {
    sigma: f64,
    speed: f64,
    acceleration: f64,
    jerk: f64,
    to_sigma: Affine,
    to_speed: Affine,
    to_acceleration: Affine,
    to_jerk: Affine,
}

/// A better law of the same duration; `reach` is how far it may move along the path at a time,
/// σ.
pub(crate) fn polish(run: &Run<'_>, plan: &Plan, reach: f64) -> Result<Plan, Unsolved> {
    let phases = plan.sigma.len() - 1;
    let most = |values: &[f64]| values.iter().fold(0.0, |most: f64, v| most.max(v.abs()));
    let mut program = Program::new(3 * (phases + 1) + 1);
    program.cost[3 * (phases + 1)] = 1.0;
    let mut polish = Polish {
        run,
        plan,
        sigma: most(&plan.speed) * plan.step_s,
        acceleration: most(&plan.acceleration),
        program,
    };
    for phase in 0..phases {
        polish.join(phase);
        polish.hold(phase);
        if phase > 0 {
            polish.trust(phase, reach);
        }
    }
    let x = polish.program.solve()?;
    let mut better = plan.clone();
    for node in 1..phases {
        better.sigma[node] += x[3 * node] * polish.sigma;
        better.speed[node] = x[3 * node + 1] * plan.speed[node];
        better.acceleration[node] = x[3 * node + 2] * polish.acceleration;
    }
    Ok(better)
}

impl Polish<'_> {
    fn ends(&self, node: usize) -> bool {
        node == 0 || node + 1 == self.plan.sigma.len()
    }

    /// How far σ moves away from the law before.
    fn shift(&self, node: usize) -> Affine {
        match self.ends(node) {
            true => Affine::default(),
            false => Affine::default().plus(3 * node, self.sigma),
        }
    }

    fn speed(&self, node: usize) -> Affine {
        match self.ends(node) {
            true => Affine::constant(self.plan.speed[node]),
            false => Affine::default().plus(3 * node + 1, self.plan.speed[node]),
        }
    }

    fn acceleration(&self, node: usize) -> Affine {
        match self.ends(node) {
            true => Affine::default(),
            false => Affine::default().plus(3 * node + 2, self.acceleration),
        }
    }

    /// 1 + `times`·e.
    fn limit(&self, times: f64) -> Affine {
        Affine::constant(1.0).plus(3 * self.plan.sigma.len(), times)
    }

    fn within(&mut self, share: &Affine, limit: &Affine) {
        self.program.positive.push(limit.clone().add(share, -1.0));
        self.program.positive.push(limit.clone().add(share, 1.0));
    }

    /// The motion of a phase leads from its first node to its last.
    fn join(&mut self, phase: usize) {
        let h = self.plan.step_s;
        let (a0, a1) = (self.acceleration(phase), self.acceleration(phase + 1));
        let (v0, v1) = (self.speed(phase), self.speed(phase + 1));
        let speed = v1.add(&v0, -1.0).add(&a0, -0.5 * h).add(&a1, -0.5 * h);
        let way = self.plan.sigma[phase + 1] - self.plan.sigma[phase];
        let sigma = Affine::constant(way)
            .add(&self.shift(phase + 1), 1.0)
            .add(&self.shift(phase), -1.0)
            .add(&v0, -h)
            .add(&a0, -h * h / 3.0)
            .add(&a1, -h * h / 6.0);
        self.program.zero.push(speed.times(1.0 / (h * self.acceleration)));
        self.program.zero.push(sigma.times(1.0 / (h * h * self.acceleration)));
    }

    /// Not too far from the law before, and forwards.
    fn trust(&mut self, node: usize, reach: f64) {
        let shift = Affine::default().plus(3 * node, self.sigma / reach);
        self.within(&shift, &Affine::constant(1.0));
        self.program.positive.push(Affine::constant(-KEPT).plus(3 * node + 1, 1.0));
        let last = self.plan.sigma.len() - 2;
        // The first and the last phase stay those that leave rest and come to it.
        if node == 1 && self.plan.speed[0] == 0.0 {
            self.program.positive.push(Affine::default().plus(3 * node + 2, 1.0));
        }
        if node == last {
            self.program.positive.push(Affine::default().plus(3 * node + 2, -1.0));
        }
    }

    fn motion(&self, phase: usize, f: f64) -> Motion {
        let (plan, h) = (self.plan, self.plan.step_s);
        let (a0, a1) = (plan.acceleration[phase], plan.acceleration[phase + 1]);
        let (v0, v1) = (plan.speed[phase], plan.speed[phase + 1]);
        let (to_a0, to_a1) = (self.acceleration(phase), self.acceleration(phase + 1));
        let to_acceleration = to_a0.clone().times(1.0 - f).add(&to_a1, f);
        let (by_first, by_last) = (h * (f - 0.5 * f * f), h * 0.5 * f * f);
        let to_speed = self.speed(phase).add(&to_a0, by_first).add(&to_a1, by_last);
        let speed = v0 + by_first * a0 + by_last * a1;
        // The law before need not be exact: the way is read between its nodes.
        let way = plan.sigma[phase + 1] - plan.sigma[phase];
        let mean = 0.5 * (v0 + v1) * h;
        let shape = h * (f * v0 + h * (0.5 * f * f * a0 + f * f * f / 6.0 * (a1 - a0)));
        let sigma = plan.sigma[phase]
            + if mean > 0.0 { (shape + f * (way - mean)).clamp(0.0, way) } else { f * way };
        let to_sigma = self.shift(phase).times(1.0 - f).add(&self.shift(phase + 1), f);
        Motion {
            sigma,
            speed,
            acceleration: a0 * (1.0 - f) + a1 * f,
            jerk: (a1 - a0) / h,
            to_sigma,
            to_speed,
            to_acceleration,
            to_jerk: to_a1.add(&to_a0, -1.0).times(1.0 / h),
        }
    }

    /// All limits over a phase.
    fn hold(&mut self, phase: usize) {
        let beside = BESIDE * (self.plan.sigma[phase + 1] - self.plan.sigma[phase]);
        let mut straight: f64 = 0.0;
        for (index, f) in [0.0, 0.5, 1.0].into_iter().enumerate() {
            let motion = self.motion(phase, f);
            let mut sides: Vec<usize> = vec![];
            for place in [motion.sigma - beside, motion.sigma, motion.sigma + beside] {
                let piece = self.run.piece_at(place.max(0.0));
                if !sides.contains(&piece) {
                    sides.push(piece);
                }
            }
            for piece in sides {
                let jet = self.run.jet(piece, motion.sigma);
                if index < 2 {
                    self.hold_speed(piece, &jet, &motion);
                    self.hold_acceleration(&jet, &motion);
                }
                if jet[2] == [0.0; 6] && jet[3] == [0.0; 6] {
                    let limits = self.run.limits().jerk();
                    straight = (0..6)
                        .fold(straight, |most, axis| most.max(jet[1][axis].abs() / limits[axis]));
                } else {
                    self.hold_jerk(&jet, &motion);
                }
            }
        }
        if straight > 0.0 {
            let motion = self.motion(phase, 0.5);
            let limit = self.limit(3.0);
            self.within(&motion.to_jerk.times(straight), &limit);
        }
    }

    fn hold_speed(&mut self, piece: usize, jet: &Jet, motion: &Motion) {
        let limit = self.limit(1.0);
        let feed = self.run.feed(piece);
        if motion.speed > USED * feed {
            self.program.positive.push(limit.clone().add(&motion.to_speed, -1.0 / feed));
        }
        let limits = self.run.limits().velocity();
        for axis in 0..6 {
            let value = jet[1][axis] * motion.speed;
            if value.abs() > USED * limits[axis] {
                let share = motion
                    .to_speed
                    .clone()
                    .times(jet[1][axis] / limits[axis])
                    .add(&motion.to_sigma, jet[2][axis] * motion.speed / limits[axis]);
                let positive = limit.clone().add(&share, -value.signum());
                self.program.positive.push(positive);
            }
        }
    }

    fn hold_acceleration(&mut self, jet: &Jet, motion: &Motion) {
        let limit = self.limit(2.0);
        let limits = self.run.limits().acceleration();
        let (v, a) = (motion.speed, motion.acceleration);
        let straight = jet[2] == [0.0; 6] && jet[3] == [0.0; 6];
        for axis in 0..6 {
            let [_, d1, d2, d3] = jet.map(|row| row[axis]);
            let used = (d1 * a).abs() + d2.abs() * v * v;
            if used <= USED * limits[axis] && !(straight && d1 != 0.0) {
                continue;
            }
            let share = motion
                .to_acceleration
                .clone()
                .times(d1)
                .add(&motion.to_speed, 2.0 * d2 * v)
                .add(&Affine::constant(-d2 * v * v), 1.0)
                .add(&motion.to_sigma, d2 * a + d3 * v * v)
                .times(1.0 / limits[axis]);
            self.within(&share, &limit);
        }
    }

    fn hold_jerk(&mut self, jet: &Jet, motion: &Motion) {
        let limit = self.limit(3.0);
        let limits = self.run.limits().jerk();
        let (v, a) = (motion.speed, motion.acceleration);
        for axis in 0..6 {
            let [_, d1, d2, d3] = jet.map(|row| row[axis]);
            if (d1, d2, d3) == (0.0, 0.0, 0.0) {
                continue;
            }
            let share = motion
                .to_jerk
                .clone()
                .times(d1)
                .add(&motion.to_acceleration, 3.0 * d2 * v)
                .add(&motion.to_speed, 3.0 * d2 * a + 3.0 * d3 * v * v)
                .add(&Affine::constant(-3.0 * d2 * v * a - 2.0 * d3 * v * v * v), 1.0)
                .add(&motion.to_sigma, d2 * motion.jerk + 3.0 * d3 * v * a)
                .times(1.0 / limits[axis]);
            self.within(&share, &limit);
        }
    }
}
