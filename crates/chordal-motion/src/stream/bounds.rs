//! What the axes do in short blocks of time: the room that is left for changing the rate.

use crate::limits::Limits;
use crate::trajectory::Along;
use crate::{Axes, Jet};

use super::window::{Leg, Placed, Window};

/// Longest block, s.
const BLOCK_S: f64 = 0.002;
/// Longest step between two looks at the motion, s.
const LOOK_S: f64 = 0.000_25;

/// The least and the largest of velocity, acceleration and jerk of each axis in some time.
#[derive(Clone, Copy, Debug)]
pub(super) struct Block {
    /// When it ends, s from the start of the window; it begins where the one before ends.
    pub end_s: f64,
    low: [Axes; 3],
    high: [Axes; 3],
}

/// What the rate of time does in a while: its value and its slope, each between two bounds, and
/// its second derivative.
#[derive(Clone, Copy, Debug)]
pub(super) struct Rates {
    pub rate: (f64, f64),
    pub slope: (f64, f64),
    pub bend: f64,
}

/// The limits as the checks use them, with a relative slack far below what is promised.
#[derive(Clone, Copy, Debug)]
pub(super) struct Room {
    velocity: Axes,
    acceleration: Axes,
    jerk: Axes,
}

impl Room {
    pub fn new(limits: &Limits) -> Room {
        let slack = |axes: Axes| axes.map(|value| value * (1.0 + 2e-7));
        Room {
            velocity: slack(limits.velocity()),
            acceleration: slack(limits.acceleration()),
            jerk: slack(limits.jerk()),
        }
    }

    /// The steepest slope and bend of the rate with which an axis at its `fastest` keeps its
    /// limits where the plan itself takes nothing of them.
    pub fn steepest(&self, fastest: &Axes) -> (f64, f64) {
        let mut steepest = (1e3_f64, 1e6_f64);
        for (axis, fastest) in fastest.iter().enumerate().filter(|(_, fastest)| **fastest > 0.0) {
            steepest.0 = steepest.0.min(self.acceleration[axis] / fastest);
            steepest.1 = steepest.1.min(self.jerk[axis] / fastest);
        }
        steepest
    }
}

impl Block {
    fn empty(end_s: f64) -> Block {
        Block { end_s, low: [[0.0; 6]; 3], high: [[0.0; 6]; 3] }
    }

    /// Whether every axis keeps its limits anywhere in the block with any of these rates:
    /// v → vφ, a → aφ² + vφ̇, j → jφ³ + 3aφφ̇ + vφ̈.
    #[inline]
    pub fn allows(&self, rates: &Rates, room: &Room) -> bool {
        let Rates { rate: (slow, fast), slope, bend } = *rates;
        let squares = (slow * slow, fast * fast);
        let cubes = (squares.0 * slow, squares.1 * fast);
        let mixed = times((slow, fast), slope);
        let mixed = (3.0 * mixed.0, 3.0 * mixed.1);
        let mut held = true;
        for axis in 0..6 {
            let of = |row: usize| (self.low[row][axis], self.high[row][axis]);
            let (v, a, j) = (of(0), of(1), of(2));
            // What does not move needs no check.
            if v.0 == 0.0 && v.1 == 0.0 {
                continue;
            }
            held &= fast * v.1.max(-v.0) <= room.velocity[axis];
            let acceleration = plus(times(a, squares), times(v, slope));
            held &= acceleration.1.max(-acceleration.0) <= room.acceleration[axis];
            let own = plus(times(j, cubes), times(a, mixed));
            let jerk = plus(own, times(v, (bend, bend)));
            held &= jerk.1.max(-jerk.0) <= room.jerk[axis];
        }
        held
    }
}

type Interval = (f64, f64);

#[inline]
fn times(a: Interval, b: Interval) -> Interval {
    let (p, q, r, s) = (a.0 * b.0, a.0 * b.1, a.1 * b.0, a.1 * b.1);
    (p.min(q).min(r.min(s)), p.max(q).max(r.max(s)))
}

#[inline]
fn plus(a: Interval, b: Interval) -> Interval {
    (a.0 + b.0, a.1 + b.1)
}

/// Fills the blocks of a window whose legs, phases and pieces stand.
pub(super) fn fill(window: &mut Window) {
    let mut blocks = std::mem::take(&mut window.blocks);
    divide(window, &mut blocks);
    let mut chain = 0;
    while chain < window.legs.len() {
        // Legs that follow one another at an instant share their blocks; one that overlaps adds
        // to them.
        let mut end = chain + 1;
        while end < window.legs.len() && !window.legs[end].overlaps {
            end += 1;
        }
        add_chain(window, (chain, end), &mut blocks);
        chain = end;
    }
    window.fastest = fastest(&blocks);
    window.blocks = blocks;
}

/// Largest speed of each axis in some blocks.
pub(super) fn fastest(blocks: &[Block]) -> Axes {
    let mut fastest = [0.0_f64; 6];
    for block in blocks {
        for (fastest, (low, high)) in
            fastest.iter_mut().zip(block.low[0].iter().zip(&block.high[0]))
        {
            *fastest = fastest.max(*high).max(-low);
        }
    }
    fastest
}

/// Ends of blocks: even steps, and where an overlap begins or ends.
fn divide(window: &Window, blocks: &mut Vec<Block>) {
    blocks.clear();
    let mut cuts =
        window.legs.iter().enumerate().filter(|(_, leg)| leg.overlaps).flat_map(|(index, leg)| {
            let end = index.checked_sub(1).map_or(0.0, |before| window.legs[before].to_s);
            [leg.from_s, end]
        });
    let mut cut = cuts.next();
    let mut now = 0.0;
    while now < window.duration_s {
        while cut.is_some_and(|at| at <= now) {
            cut = cuts.next();
        }
        let mut end = (now + BLOCK_S).min(window.duration_s);
        if let Some(at) = cut {
            end = end.min(at);
        }
        // The last one takes what rounding leaves.
        if window.duration_s - end < 1e-9 {
            end = window.duration_s;
        }
        blocks.push(Block::empty(end));
        now = end;
    }
}

/// Adds what a chain of legs does to the blocks it is in.
fn add_chain(window: &Window, (first, end): (usize, usize), blocks: &mut [Block]) {
    let begins = window.legs[first].from_s.max(0.0);
    let mut block = blocks.partition_point(|block| block.end_s <= begins);
    let mut hull = Hull::new();
    for leg in &window.legs[first..end] {
        let (from, to) = leg.phases;
        let mut piece = leg.pieces.0;
        for timed in &window.phases[from..to] {
            let mut t = timed.from_s.max(0.0);
            let until = (timed.from_s + timed.phase.duration_s).min(window.duration_s);
            while t < until {
                while block < blocks.len() && blocks[block].end_s <= t {
                    hull.add_to(&mut blocks[block]);
                    hull = Hull::new();
                    block += 1;
                }
                let Some(current) = blocks.get(block) else { return };
                let next = (t + LOOK_S).min(until).min(current.end_s);
                let looks = [t, (t + next) / 2.0, next].map(|t| timed.phase.at(t - timed.from_s));
                hull.look(window, leg, &mut piece, &looks);
                t = next;
            }
        }
    }
    if let Some(block) = blocks.get_mut(block) {
        hull.add_to(block);
    }
}

/// Least and largest of what was looked at.
struct Hull {
    low: [Axes; 3],
    high: [Axes; 3],
    seen: bool,
}

impl Hull {
    fn new() -> Hull {
        Hull { low: [[f64::INFINITY; 6]; 3], high: [[f64::NEG_INFINITY; 6]; 3], seen: false }
    }

    /// Takes in the motion of a phase from the first to the last of three instants, on every
    /// piece it meets there.
    fn look(&mut self, window: &Window, leg: &Leg, hint: &mut usize, looks: &[Along; 3]) {
        let [one, middle, two] = looks;
        let sigma = two.sigma - one.sigma;
        let part =
            |at: f64| if sigma > 0.0 { ((at - one.sigma) / sigma).clamp(0.0, 1.0) } else { 0.0 };
        loop {
            let Placed { from, piece } = &window.pieces[*hint];
            let end = from + piece.length;
            let last = *hint + 1 >= leg.pieces.1;
            let on = |along: &Along| {
                derivatives(&piece.at((along.sigma - from).clamp(0.0, piece.length)), along)
            };
            if one.sigma >= *from && (two.sigma <= end || last) {
                self.take(&on(one), &on(middle), &on(two));
            } else {
                // Short pieces are met within a step: the velocity profile there lies between the two.
                let at = |sigma: f64| on(&between(one, two, part(sigma)));
                let (from, to) = (from.max(one.sigma), end.min(two.sigma));
                self.take(&at(from), &at((from + to) / 2.0), &at(to));
            }
            if last || two.sigma < end {
                return;
            }
            *hint += 1;
        }
    }

    /// Takes in three values that follow one another on a smooth curve.
    fn take(&mut self, one: &[Axes; 3], middle: &[Axes; 3], two: &[Axes; 3]) {
        self.seen = true;
        for row in 0..3 {
            for axis in 0..6 {
                let (a, m, b) = (one[row][axis], middle[row][axis], two[row][axis]);
                // A peak between the three rises above them by less than half of what the
                // middle is off the chord.
                let margin = (m - (a + b) / 2.0).abs() / 2.0;
                self.low[row][axis] = self.low[row][axis].min(a.min(b).min(m) - margin);
                self.high[row][axis] = self.high[row][axis].max(a.max(b).max(m) + margin);
            }
        }
    }

    fn add_to(&self, block: &mut Block) {
        if self.seen {
            for row in 0..3 {
                for axis in 0..6 {
                    block.low[row][axis] += self.low[row][axis];
                    block.high[row][axis] += self.high[row][axis];
                }
            }
        }
    }
}

fn between(one: &Along, two: &Along, part: f64) -> Along {
    let mix = |a: f64, b: f64| a + (b - a) * part;
    Along {
        sigma: mix(one.sigma, two.sigma),
        speed: mix(one.speed, two.speed),
        acceleration: mix(one.acceleration, two.acceleration),
        jerk: one.jerk,
    }
}

/// Velocity, acceleration and jerk of the axes.
fn derivatives(jet: &Jet, along: &Along) -> [Axes; 3] {
    let [_, d1, d2, d3] = jet;
    let Along { speed: v, acceleration: a, jerk: j, .. } = *along;
    let mut rows = [[0.0; 6]; 3];
    for axis in 0..6 {
        rows[0][axis] = d1[axis] * v;
        rows[1][axis] = d1[axis] * a + d2[axis] * v * v;
        rows[2][axis] = d1[axis] * j + 3.0 * d2[axis] * v * a + d3[axis] * v * v * v;
    }
    rows
}
