//! How far a law of time exceeds the limits: every axis, on its polynomials.

use crate::bound::Run;
use crate::reader::state_of;
use crate::trajectory::{Along, Phase};

/// The largest share of a limit that is used, 1 being the limit itself.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Excess {
    /// Of the velocities and of the feed.
    pub(crate) velocity: f64,
    pub(crate) acceleration: f64,
    pub(crate) jerk: f64,
}

/// Parts of a phase that are looked at, in a piece that is not straight.
const PARTS: usize = 12;
/// Steps of the golden section about a largest sample.
const STEPS: usize = 16;
/// Share of the way of a phase that is rounding.
const ROUNDING: f64 = 1e-9;
/// Samples below this share of the largest so far are not followed to their peak.
const NEAR: f64 = 0.9;

impl Excess {
    /// How much longer everything must take for all limits to be held.
    pub(crate) fn stretch(&self) -> f64 {
        self.velocity.max(self.acceleration.sqrt()).max(libm::cbrt(self.jerk))
    }

    fn take(&mut self, shares: [f64; 3]) {
        self.velocity = self.velocity.max(shares[0]);
        self.acceleration = self.acceleration.max(shares[1]);
        self.jerk = self.jerk.max(shares[2]);
    }
}

/// Measures a law of time.
pub(crate) fn excess(run: &Run<'_>, phases: &[Phase]) -> Excess {
    let mut excess = Excess::default();
    let mut piece = 0;
    for phase in phases {
        let mut begins = 0.0;
        loop {
            let ends_at = run.from(piece) + run.pieces()[piece].length;
            let last = piece + 1 == run.pieces().len();
            let whole = phase.at(phase.duration_s).sigma;
            // A phase that ends with its piece does so but for rounding.
            let within = last || whole <= ends_at + ROUNDING * (whole - phase.from);
            let ends = if within { phase.duration_s } else { crossing(phase, begins, ends_at) };
            part(run, phase, piece, begins, ends, &mut excess);
            begins = ends;
            if within {
                if !last && whole >= ends_at - ROUNDING * (whole - phase.from) {
                    piece += 1;
                }
                break;
            }
            piece += 1;
        }
    }
    excess
}

/// When a phase comes to a place; it does not go back.
fn crossing(phase: &Phase, from: f64, sigma: f64) -> f64 {
    let (mut low, mut high) = (from, phase.duration_s);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if phase.at(middle).sigma < sigma { low = middle } else { high = middle }
    }
    high
}

/// Shares of the limits at a time of a phase.
fn shares(run: &Run<'_>, phase: &Phase, piece: usize, t: f64) -> [f64; 3] {
    let along: Along = phase.at(t);
    let on = &run.pieces()[piece];
    let state = state_of(on, (along.sigma - run.from(piece)).clamp(0.0, on.length), &along);
    let limits = run.limits();
    let mut shares = [along.speed / run.feed(piece), 0.0, 0.0];
    for axis in 0..6 {
        let Some(limit) = limits.axis(axis) else { continue };
        shares[0] = shares[0].max(state.velocity[axis].abs() / limit.velocity);
        shares[1] = shares[1].max(state.acceleration[axis].abs() / limit.acceleration);
        shares[2] = shares[2].max(state.jerk[axis].abs() / limit.jerk);
    }
    shares
}

/// One part of a phase that lies in one piece.
fn part(run: &Run<'_>, phase: &Phase, piece: usize, from: f64, to: f64, excess: &mut Excess) {
    let on = &run.pieces()[piece];
    let straight = on.base.is_none() && on.start[2] == [0.0; 6] && on.start[3] == [0.0; 6];
    if straight {
        // Largest at the ends and, for the speed, where the acceleration is zero.
        excess.take(shares(run, phase, piece, from));
        excess.take(shares(run, phase, piece, to));
        let still = -phase.acceleration / phase.jerk;
        if still > from && still < to {
            excess.take(shares(run, phase, piece, still));
        }
        return;
    }
    let at = |index: usize| from + (to - from) * index as f64 / PARTS as f64;
    let samples: [[f64; 3]; PARTS + 1] =
        std::array::from_fn(|index| shares(run, phase, piece, at(index)));
    for quantity in 0..3 {
        let sample = |index: usize| samples[index][quantity];
        let so_far = [excess.velocity, excess.acceleration, excess.jerk][quantity];
        let most = (0..=PARTS).map(sample).fold(so_far, f64::max);
        let mut shares = [0.0; 3];
        shares[quantity] = most;
        for index in 0..=PARTS {
            let (before, after) = (index.saturating_sub(1), (index + 1).min(PARTS));
            let high = sample(index) >= sample(before).max(sample(after));
            if high && sample(index) > NEAR * most {
                let share = |t| self::shares(run, phase, piece, t)[quantity];
                shares[quantity] = shares[quantity].max(peak(at(before), at(after), share));
            }
        }
        excess.take(shares);
    }
}

/// The largest value of a function with one peak, by golden section.
fn peak(mut low: f64, mut high: f64, value: impl Fn(f64) -> f64) -> f64 {
    const GOLDEN: f64 = 0.618_033_988_749_894_9;
    let (mut a, mut b) = (high - GOLDEN * (high - low), low + GOLDEN * (high - low));
    let (mut at_a, mut at_b) = (value(a), value(b));
    for _ in 0..STEPS {
        if at_a > at_b {
            (high, b, at_b) = (b, a, at_a);
            a = high - GOLDEN * (high - low);
            at_a = value(a);
        } else {
            (low, a, at_a) = (a, b, at_b);
            b = low + GOLDEN * (high - low);
            at_b = value(b);
        }
    }
    at_a.max(at_b)
}
