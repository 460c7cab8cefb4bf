//! One convex step of the reference.
//!
//! Variables by node: b = σ̇² and a = σ̈ = b′/2, with b a parabola over each interval, and c ≤ √b; by
//! interval d ≥ 1/(c + c). The time is Σ 2Δd. Velocity bounds b, acceleration |q′a + q″b| ≤ A at the
//! nodes; both are linear. The jerk of an axis is √b·(q‴b + 3q″a + q′a′): its limit is
//! |q‴b + 3q″a + q′a′| ≤ J/√b, whose right side is convex in b, and its tangent at the profile of the
//! step before lies below it. What satisfies the tangent satisfies the limit.
//!
//! Next to rest the jerk is taken as even over the interval: with σ = jt³/6, b = 3aΔ/2 and
//! j = 2b^{3/2}/9Δ².

use chordal_geometry::AXES;

use super::ReferenceProfile;
use super::conic_program::{AffineExpression, ConicProgram, UnsolvedProgram};
use super::grid::{ReferenceGrid, jerk_at_rest, square_from_rest};
use crate::time_bound::PathRun;

/// Places at which the jerk is limited in an interval of many pieces.
const MAX_JERK_POINTS: usize = 12;

/// An interval that is more than this share of a piece is looked at in three places.
const ROUGH_INTERVAL_SHARE: f64 = 0.1;

/// The right side of the limit of jerk.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum JerkBoundForm {
    /// J/√b̄ with b̄ at least b: the first program.
    Fixed,
    /// The tangent of J/√b.
    Tangent,
}

/// One convex step from a profile.
pub(crate) struct ConvexStep<'a> {
    run: &'a PathRun<'a>,
    profile: &'a ReferenceProfile,
    jerk: JerkBoundForm,
    /// Scale of a, by node.
    scale: Vec<f64>,
    program: ConicProgram,
}

/// The profile that a grid begins with.
pub(crate) fn first_profile(run: &PathRun<'_>, grid: &ReferenceGrid) -> ReferenceProfile {
    let mut square = grid.square.clone();
    let last = square.len() - 1;
    // Inner nodes must be above zero: they scale the variables.
    let most = square.iter().fold(0.0, |most: f64, b| most.max(*b));
    square[1..last].iter_mut().for_each(|b| *b = b.max(1e-12 * most));
    square[last] = 0.0;
    if !grid.from_rest {
        square[0] = run.start_speed() * run.start_speed();
    }
    let mut profile = ReferenceProfile {
        sigma: grid.sigma.clone(),
        acceleration: vec![0.0; square.len()],
        square,
        step_s: grid.step_s,
        ..ReferenceProfile::default()
    };
    profile.time_s = profile.clock()[last];
    profile
}

impl<'a> ConvexStep<'a> {
    pub(crate) fn solve(
        run: &'a PathRun<'a>,
        profile: &'a ReferenceProfile,
        jerk: JerkBoundForm,
    ) -> Result<ReferenceProfile, UnsolvedProgram> {
        let nodes = profile.sigma.len();
        let clock = profile.clock();
        let total = clock[nodes - 1];
        // What a may be at a node: what jerk builds up in the time to the nearer end, or the
        // mean change of the speed.
        let scale = (0..nodes)
            .map(|node| {
                let near = clock[node].min(total - clock[node]).max(total / nodes as f64);
                profile.square[node].max(profile.square[1]).sqrt() / near
            })
            .collect();
        let program = ConicProgram::new(3 * nodes + nodes - 1);
        let mut step = ConvexStep { run, profile, jerk, scale, program };
        for node in 1..nodes - 1 {
            step.hold_node(node);
        }
        for interval in 0..nodes - 1 {
            step.time_of(interval, total);
            if profile.square[interval] <= 0.0 || profile.square[interval + 1] <= 0.0 {
                step.next_to_rest(interval);
            } else {
                step.join(interval);
                step.hold_jerk(interval);
            }
        }
        let x = step.program.solve()?;
        Ok(step.profile_of(&x))
    }

    fn at_rest(&self, node: usize) -> bool {
        self.profile.square[node] <= 0.0
    }

    fn fixed(&self, node: usize) -> bool {
        node == 0 || node + 1 == self.profile.sigma.len()
    }

    fn square(&self, node: usize) -> AffineExpression {
        let now = self.profile.square[node];
        if self.fixed(node) {
            return AffineExpression::constant(now);
        }
        AffineExpression::default().plus(3 * node, now)
    }

    fn acceleration(&self, node: usize) -> AffineExpression {
        if self.fixed(node) {
            return AffineExpression::constant(0.0);
        }
        AffineExpression::default().plus(3 * node + 1, self.scale[node])
    }

    fn speed(&self, node: usize) -> AffineExpression {
        let now = self.profile.square[node].sqrt();
        if self.fixed(node) {
            return AffineExpression::constant(now);
        }
        AffineExpression::default().plus(3 * node + 2, now)
    }

    /// |expression| ≤ limit.
    fn within(&mut self, expression: &AffineExpression, limit: &AffineExpression) {
        self.program.positive.push(limit.clone().add(expression, -1.0));
        self.program.positive.push(limit.clone().add(expression, 1.0));
    }

    /// Speed, feed and acceleration at a node, seen from both sides.
    fn hold_node(&mut self, node: usize) {
        let sigma = self.profile.sigma[node];
        let (before, after) = (
            self.run.piece_at(0.5 * (sigma + self.profile.sigma[node - 1])),
            self.run.piece_at(0.5 * (sigma + self.profile.sigma[node + 1])),
        );
        let (square, acceleration) = (self.square(node), self.acceleration(node));
        let here = self.run.piece_at(sigma);
        let mut cap = f64::MAX;
        let mut sides = vec![here];
        for other in [before.max(here.saturating_sub(1)), after.min(here + 1)] {
            let from = self.run.from(other);
            let touches = sigma >= from && sigma <= from + self.run.pieces()[other].length;
            if touches && !sides.contains(&other) {
                sides.push(other);
            }
        }
        for (index, piece) in sides.into_iter().enumerate() {
            let jet = self.run.jet(piece, sigma);
            let speed = self.run.speed_cap(piece, &jet);
            cap = cap.min(speed * speed);
            let straight = jet[2] == [0.0; AXES];
            if index > 0 && straight {
                continue;
            }
            let limits = self.run.limits().acceleration();
            if straight {
                let least = (0..AXES)
                    .filter(|axis| jet[1][*axis] != 0.0)
                    .fold(f64::MAX, |least, axis| least.min(limits[axis] / jet[1][axis].abs()));
                let share = acceleration.clone().times(1.0 / least);
                self.within(&share, &AffineExpression::constant(1.0));
                continue;
            }
            for axis in 0..AXES {
                if jet[1][axis] == 0.0 && jet[2][axis] == 0.0 {
                    continue;
                }
                let share = acceleration
                    .clone()
                    .times(jet[1][axis] / limits[axis])
                    .add(&square, jet[2][axis] / limits[axis]);
                self.within(&share, &AffineExpression::constant(1.0));
            }
        }
        if self.jerk == JerkBoundForm::Fixed {
            cap = cap.min(self.profile.square[node]);
        }
        self.program.positive.push(AffineExpression::constant(1.0).add(&square, -1.0 / cap));
        let relative = AffineExpression::default().plus(3 * node, 1.0);
        self.program.square_below(AffineExpression::default().plus(3 * node + 2, 1.0), &relative);
    }

    /// The time of an interval enters the cost.
    fn time_of(&mut self, interval: usize, total: f64) {
        let variable = 3 * self.profile.sigma.len() + interval;
        let speeds = self.speed(interval).add(&self.speed(interval + 1), 1.0);
        let now = self.profile.square[interval].sqrt() + self.profile.square[interval + 1].sqrt();
        // d is counted in 1/(c + c) of the profile before; the true time of its interval is its cost.
        self.program.cost[variable] = self.profile.interval_time(interval) / total;
        let inverse = AffineExpression::default().plus(variable, 1.0);
        self.program.product_above_one(inverse, &speeds.times(1.0 / now));
    }

    /// Even jerk on the interval that begins or ends at rest.
    fn next_to_rest(&mut self, interval: usize) {
        let distance = self.profile.sigma[interval + 1] - self.profile.sigma[interval];
        let (rest, node, sign) = if self.at_rest(interval) {
            (interval, interval + 1, 1.0)
        } else {
            (interval + 1, interval, -1.0)
        };
        if self.fixed(node) {
            return;
        }
        let jerk = jerk_at_rest(self.run, self.profile.sigma[rest])
            .min(jerk_at_rest(self.run, self.profile.sigma[node]));
        let most = square_from_rest(jerk, distance);
        let (square, acceleration) = (self.square(node), self.acceleration(node));
        self.program.positive.push(AffineExpression::constant(1.0).add(&square, -1.0 / most));
        let join = square.add(&acceleration, -1.5 * sign * distance);
        self.program.zero.push(join.times(1.0 / self.profile.square[node]));
    }

    /// b over an interval is a parabola.
    fn join(&mut self, interval: usize) {
        let distance = self.profile.sigma[interval + 1] - self.profile.sigma[interval];
        let join = self
            .square(interval + 1)
            .add(&self.square(interval), -1.0)
            .add(&self.acceleration(interval), -distance)
            .add(&self.acceleration(interval + 1), -distance);
        let size = self.profile.square[interval].max(self.profile.square[interval + 1]);
        self.program.zero.push(join.times(1.0 / size));
    }

    /// The limit of jerk over an interval.
    fn hold_jerk(&mut self, interval: usize) {
        let (s0, s1) = (self.profile.sigma[interval], self.profile.sigma[interval + 1]);
        let distance = s1 - s0;
        let (b0, b1) = (self.square(interval), self.square(interval + 1));
        let (a0, a1) = (self.acceleration(interval), self.acceleration(interval + 1));
        // The mean speed of the interval, and b that belongs to it.
        let speed = distance / self.profile.interval_time(interval);
        let sum = self.profile.square[interval] + self.profile.square[interval + 1];
        let limit = match self.jerk {
            JerkBoundForm::Fixed => AffineExpression::constant(1.0),
            JerkBoundForm::Tangent => {
                AffineExpression::constant(1.5).add(&b0, -0.5 / sum).add(&b1, -0.5 / sum)
            }
        };
        let limits = self.run.limits().jerk();
        let slope = a1.clone().add(&a0, -1.0).times(1.0 / distance);
        let mut straight = 0.0;
        for (share, jet) in self.places(interval) {
            if jet[2] == [0.0; AXES] && jet[3] == [0.0; AXES] {
                let rate = (0..AXES).map(|axis| jet[1][axis].abs() / limits[axis]);
                straight = rate.fold(straight, f64::max);
                continue;
            }
            let square = b0.clone().times(1.0 - share).add(&b1, share);
            let acceleration = a0.clone().times(1.0 - share).add(&a1, share);
            for axis in 0..AXES {
                if (1..4).all(|row| jet[row][axis] == 0.0) {
                    continue;
                }
                let factor = speed / limits[axis];
                let jerk = square
                    .clone()
                    .times(jet[3][axis] * factor)
                    .add(&acceleration, 3.0 * jet[2][axis] * factor)
                    .add(&slope, jet[1][axis] * factor);
                self.within(&jerk, &limit);
            }
        }
        if straight > 0.0 {
            self.within(&slope.times(straight * speed), &limit);
        }
    }

    /// Where the jerk is limited in an interval: in the middle of each piece's part of it, and near the
    /// ends too where that is much of the piece. Shares of the interval, and the derivatives there.
    fn places(&self, interval: usize) -> Vec<(f64, crate::AxisJet)> {
        let (s0, s1) = (self.profile.sigma[interval], self.profile.sigma[interval + 1]);
        let (first, last) = (self.run.piece_at(s0), self.run.piece_at(s1));
        let stride = (last - first) / MAX_JERK_POINTS + 1;
        let mut places = Vec::new();
        for piece in (first..=last).step_by(stride) {
            let whole = &self.run.pieces()[piece];
            let from = self.run.from(piece).max(s0);
            let to = (self.run.from(piece) + whole.length).min(s1);
            if to <= from {
                continue;
            }
            let rough = !whole.is_straight() && to - from > ROUGH_INTERVAL_SHARE * whole.length;
            let shares: &[f64] = if rough { &[0.15, 0.5, 0.85] } else { &[0.5] };
            for share in shares {
                let at = from + share * (to - from);
                places.push(((at - s0) / (s1 - s0), self.run.jet(piece, at)));
            }
        }
        places
    }

    fn profile_of(&self, x: &[f64]) -> ReferenceProfile {
        let mut profile = self.profile.clone();
        let last = profile.sigma.len() - 1;
        for node in 1..last {
            profile.square[node] *= x[3 * node].max(1e-9);
            profile.acceleration[node] = x[3 * node + 1] * self.scale[node];
        }
        profile.time_s = profile.clock()[last];
        profile.change_s = self.profile.time_s - profile.time_s;
        profile
    }
}
