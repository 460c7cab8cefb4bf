//! Fills the blocks of a window: what the axes do in each at the least and at the most.

use chordal_geometry::{AXES, Tracer};

use crate::piece::{add_curve, ahead};
use crate::trajectory::ProfilePoint;
use crate::{AxisJet, AxisValues};

use super::block::MotionBlock;
use super::window::{PlacedPiece, StreamWindow, WindowLeg};

/// Longest block, s.
const MAX_BLOCK_S: f64 = 0.002;
/// Longest step between two looks at the motion, s.
const MAX_PROBE_STEP_S: f64 = 0.000_25;

/// Fills the blocks of a window whose legs, phases and pieces are known.
pub(super) fn fill(window: &mut StreamWindow) {
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
pub(super) fn fastest(blocks: &[MotionBlock]) -> AxisValues {
    let mut fastest = [0.0_f64; AXES];
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
fn divide(window: &StreamWindow, blocks: &mut Vec<MotionBlock>) {
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
        let mut end = (now + MAX_BLOCK_S).min(window.duration_s);
        if let Some(at) = cut {
            end = end.min(at);
        }
        // The last one takes what rounding leaves.
        if window.duration_s - end < 1e-9 {
            end = window.duration_s;
        }
        blocks.push(MotionBlock::empty(end));
        now = end;
    }
}

/// Adds what a chain of legs does to the blocks it is in.
fn add_chain(window: &StreamWindow, (first, end): (usize, usize), blocks: &mut [MotionBlock]) {
    let begins = window.legs[first].from_s.max(0.0);
    let mut block = blocks.partition_point(|block| block.end_s <= begins);
    let mut hull = ValueHull::new();
    let mut below = BaseCurve::default();
    for leg in &window.legs[first..end] {
        let (from, to) = leg.phases;
        let mut piece = leg.pieces.0;
        for timed in &window.phases[from..to] {
            let mut t = timed.from_s.max(0.0);
            let until = (timed.from_s + timed.phase.duration_s).min(window.duration_s);
            while t < until {
                while block < blocks.len() && blocks[block].end_s <= t {
                    hull.add_to(&mut blocks[block]);
                    hull = ValueHull::new();
                    block += 1;
                }
                let Some(current) = blocks.get(block) else { return };
                let next = (t + MAX_PROBE_STEP_S).min(until).min(current.end_s);
                let looks = [t, (t + next) / 2.0, next].map(|t| timed.phase.at(t - timed.from_s));
                hull.look(window, leg, &mut piece, &mut below, &looks);
                t = next;
            }
        }
    }
    if let Some(block) = blocks.get_mut(block) {
        hull.add_to(block);
    }
}

/// Least and largest of what was looked at.
struct ValueHull {
    low: [AxisValues; 3],
    high: [AxisValues; 3],
    has_values: bool,
}

impl ValueHull {
    fn new() -> ValueHull {
        ValueHull {
            low: [[f64::INFINITY; AXES]; 3],
            high: [[f64::NEG_INFINITY; AXES]; 3],
            has_values: false,
        }
    }

    /// Takes in the motion of a phase from the first to the last of three instants, on every
    /// piece it meets there.
    fn look(
        &mut self,
        window: &StreamWindow,
        leg: &WindowLeg,
        hint: &mut usize,
        below: &mut BaseCurve,
        looks: &[ProfilePoint; 3],
    ) {
        let [one, middle, two] = looks;
        let sigma = two.sigma - one.sigma;
        let part =
            |at: f64| if sigma > 0.0 { ((at - one.sigma) / sigma).clamp(0.0, 1.0) } else { 0.0 };
        loop {
            let placed = &window.pieces[*hint];
            let (from, end) = (placed.from, placed.from + placed.length);
            let last = *hint + 1 >= leg.pieces.1;
            let mut on = |along: &ProfilePoint| {
                let sigma = (along.sigma - from).clamp(0.0, placed.length);
                derivatives(&below.jet_at(window, placed, sigma), along)
            };
            if one.sigma >= from && (two.sigma <= end || last) {
                self.take(&on(one), &on(middle), &on(two));
            } else {
                // Short pieces are met within a step: the velocity profile there lies between the two.
                let mut at = |sigma: f64| on(&between(one, two, part(sigma)));
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
    fn take(&mut self, one: &[AxisValues; 3], middle: &[AxisValues; 3], two: &[AxisValues; 3]) {
        self.has_values = true;
        for row in 0..3 {
            for axis in 0..AXES {
                let (a, m, b) = (one[row][axis], middle[row][axis], two[row][axis]);
                // A peak between the three rises above them by less than half of what the
                // middle is off the chord.
                let margin = (m - (a + b) / 2.0).abs() / 2.0;
                self.low[row][axis] = self.low[row][axis].min(a.min(b).min(m) - margin);
                self.high[row][axis] = self.high[row][axis].max(a.max(b).max(m) + margin);
            }
        }
    }

    fn add_to(&self, block: &mut MotionBlock) {
        if self.has_values {
            for row in 0..3 {
                for axis in 0..AXES {
                    block.low[row][axis] += self.low[row][axis];
                    block.high[row][axis] += self.high[row][axis];
                }
            }
        }
    }
}

/// The curve that was last met, made ready.
#[derive(Default)]
struct BaseCurve(Option<(usize, Tracer)>);

impl BaseCurve {
    /// The axes and their derivatives at `sigma` from the start of a piece.
    fn jet_at(&mut self, window: &StreamWindow, placed: &PlacedPiece, sigma: f64) -> AxisJet {
        let mut jet = ahead(&placed.start, sigma, AXES);
        if let Some((curve, from)) = placed.base {
            let tracer = match &mut self.0 {
                Some((ready, tracer)) if *ready == curve => tracer,
                none => &mut none.insert((curve, Tracer::new(&window.curves[curve]))).1,
            };
            add_curve(&mut jet, tracer.jet_at(from + sigma));
        }
        jet
    }
}

fn between(one: &ProfilePoint, two: &ProfilePoint, part: f64) -> ProfilePoint {
    let mix = |a: f64, b: f64| a + (b - a) * part;
    ProfilePoint {
        sigma: mix(one.sigma, two.sigma),
        speed: mix(one.speed, two.speed),
        acceleration: mix(one.acceleration, two.acceleration),
        jerk: one.jerk,
    }
}

/// Velocity, acceleration and jerk of the axes.
fn derivatives(jet: &AxisJet, along: &ProfilePoint) -> [AxisValues; 3] {
    let [_, d1, d2, d3] = jet;
    let ProfilePoint { speed: v, acceleration: a, jerk: j, .. } = *along;
    let mut rows = [[0.0; AXES]; 3];
    for axis in 0..AXES {
        rows[0][axis] = d1[axis] * v;
        rows[1][axis] = d1[axis] * a + d2[axis] * v * v;
        rows[2][axis] = d1[axis] * j + 3.0 * d2[axis] * v * a + d3[axis] * v * v * v;
    }
    rows
}
