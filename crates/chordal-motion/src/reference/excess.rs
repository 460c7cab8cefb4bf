//! How far a velocity profile exceeds the limits: every axis, on its polynomials.

use crate::bound::Run;
use crate::reader::state_of;
use crate::trajectory::Phase;
use crate::verify::Use;

/// Parts of a phase that are looked at, in a piece that is not straight.
const PARTS: usize = 12;
/// Steps of the golden section about a largest sample.
const STEPS: usize = 16;
/// Share of the way of a phase that is rounding.
const ROUNDING: f64 = 1e-9;
/// Samples below this share of the largest so far are not followed to their peak.
const NEAR: f64 = 0.9;

/// Measures a velocity profile: the largest shares of the limits that it uses, that of the velocities
/// and of the feed being one.
pub(crate) fn excess(run: &Run<'_>, phases: &[Phase]) -> Use {
    let mut most = Use::default();
    let mut piece = 0;
    for phase in phases {
        let mut begins = 0.0;
        loop {
            let ends_at = run.from(piece) + run.pieces()[piece].length;
            let last = piece + 1 == run.pieces().len();
            let whole = phase.at(phase.duration_s).sigma;
            // A phase that ends with its piece does so but for rounding.
            let within = last || whole <= ends_at + ROUNDING * (whole - phase.from);
            let ends = if within { phase.duration_s } else { phase.time_at(ends_at, begins) };
            most = part(run, phase, piece, begins, ends, most);
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
    most
}

/// Shares of the limits at a time of a phase.
fn shares(run: &Run<'_>, phase: &Phase, piece: usize, t: f64) -> Use {
    let along = phase.at(t);
    let on = &run.pieces()[piece];
    let state = state_of(on, (along.sigma - run.from(piece)).clamp(0.0, on.length), &along);
    let axes = Use::of(&state, run.limits());
    Use { velocity: axes.velocity.max(along.speed / run.feed(piece)), ..axes }
}

/// The shares one by one.
const SHARES: [fn(&mut Use) -> &mut f64; 3] =
    [|used| &mut used.velocity, |used| &mut used.acceleration, |used| &mut used.jerk];

/// The largest so far with one part of a phase that lies in one piece.
fn part(run: &Run<'_>, phase: &Phase, piece: usize, from: f64, to: f64, so_far: Use) -> Use {
    if run.pieces()[piece].is_straight() {
        // Largest at the ends and, for the speed, where the acceleration is zero.
        let mut most = so_far.or(shares(run, phase, piece, from)).or(shares(run, phase, piece, to));
        let still = -phase.acceleration / phase.jerk;
        if still > from && still < to {
            most = most.or(shares(run, phase, piece, still));
        }
        return most;
    }
    let at = |index: usize| from + (to - from) * index as f64 / PARTS as f64;
    let samples: [Use; PARTS + 1] =
        std::array::from_fn(|index| shares(run, phase, piece, at(index)));
    let mut largest = samples.into_iter().fold(so_far, Use::or);
    for of in SHARES {
        let sample = |index: usize| *of(&mut { samples[index] });
        let most = of(&mut largest);
        let near = NEAR * *most;
        for index in 0..=PARTS {
            let (before, after) = (index.saturating_sub(1), (index + 1).min(PARTS));
            let high = sample(index) >= sample(before).max(sample(after));
            if high && sample(index) > near {
                let share = |t| *of(&mut shares(run, phase, piece, t));
                *most = most.max(peak(at(before), at(after), share));
            }
        }
    }
    largest
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
