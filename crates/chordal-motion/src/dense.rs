//! Lines from rest to rest as smooth curves between corners, each with one law of time.

use std::ops::Range;

use chordal_geometry::{AXES, ParamCurve};

use crate::Axes;
use crate::bound::Run;
use crate::cell::AxisArrays;
use crate::curve::{Chords, Measure, Smoothing};
use crate::law::{Ends, Planner as LawPlanner};
use crate::limits::Limits;
use crate::piece::{Piece, ahead};
use crate::segment::{Corner, Move};
use crate::smooth::EXACT;
use crate::trajectory::Stretch;

/// A joint is a corner where the chords turn by more; short ones are looked at over some tolerances.
const CORNER_COSINE: f64 = 0.258_819_045_102_521;
const LOOK: f64 = 4.0;
/// Directions that differ by less go on in one line.
const STRAIGHT: f64 = 1e-9;
/// A piece that bends by less, in tolerances, is a line.
const BEND: f64 = 1e-7;

/// A chord of a run.
#[derive(Clone, Copy, Debug)]
struct Chord {
    /// Its number among the moves.
    index: usize,
    /// σ where it ends, from the start of the run.
    end: f64,
}

/// Plans lines from rest to rest; keeps its memory.
#[derive(Debug, Default)]
pub(crate) struct Dense {
    places: Vec<Axes>,
    lengths: Vec<f64>,
    corners: Vec<usize>,
    chords: Chords,
    parts: Vec<Chord>,
    smoothing: Smoothing,
    law: LawPlanner,
    pieces: Vec<Piece>,
    speeds: Vec<f64>,
}

impl Dense {
    /// The stretches of some lines from rest to rest, each again from rest to rest; the numbers of the
    /// moves of a run that has no curve or no law.
    pub fn plan(
        &mut self,
        moves: &[Move],
        limits: &Limits,
        gap: f64,
    ) -> Vec<Result<Stretch, Range<usize>>> {
        self.find_corners(moves);
        let corners = std::mem::take(&mut self.corners);
        let runs = corners.windows(2).map(|pair| {
            let run = pair[0]..pair[1];
            self.run(run.start, &moves[run.clone()], limits, gap).ok_or(run)
        });
        let runs = runs.collect();
        self.corners = corners;
        runs
    }

    /// The number of the last move that begins at a corner.
    pub fn last_corner(&mut self, moves: &[Move]) -> Option<usize> {
        self.find_corners(moves);
        self.corners[..self.corners.len() - 1].last().copied().filter(|index| *index > 0)
    }

    /// Numbers of the moves at which runs begin, and one past the last.
    fn find_corners(&mut self, moves: &[Move]) {
        self.places.clear();
        self.lengths.clear();
        self.places.extend(moves.first().map(Move::from));
        for motion in moves {
            self.places.push(motion.to());
            self.lengths.push(motion.length());
        }
        self.corners.clear();
        self.corners.push(0);
        for index in 1..moves.len() {
            if self.turns(moves, index) {
                self.corners.push(index);
            }
        }
        self.corners.push(moves.len());
    }

    /// Whether the chords turn at a place, seen over some tolerances.
    fn turns(&self, moves: &[Move], index: usize) -> bool {
        let Corner::Within { linear_mm, .. } = moves[index - 1].corner else { return true };
        // σ is of another kind where rotary axes alone move.
        let [turns, goes_on] = [index - 1, index].map(|at| moves[at].curve.length() <= 0.0);
        if turns != goes_on {
            return true;
        }
        let tolerance = linear_mm.max(EXACT.linear_mm);
        // What turns between chords shorter than the tolerance may be rounding.
        let look = |length: f64| if length < tolerance { LOOK * tolerance } else { length };
        let here = &self.places[index];
        let before = self.beyond(index, -look(self.lengths[index - 1]));
        let after = self.beyond(index, look(self.lengths[index]));
        let (mut dot, mut squares) = (0.0, [0.0; 2]);
        for axis in 0..3 {
            let (a, b) = (here[axis] - before[axis], after[axis] - here[axis]);
            dot += a * b;
            squares[0] += a * a;
            squares[1] += b * b;
        }
        dot < CORNER_COSINE * (squares[0] * squares[1]).sqrt()
    }

    /// The place so far from a vertex along the chords, or their end.
    fn beyond(&self, index: usize, way: f64) -> Axes {
        let (mut at, mut left) = (index, way.abs());
        loop {
            let (next, length) = if way < 0.0 {
                if at == 0 {
                    return self.places[0];
                }
                (at - 1, self.lengths[at - 1])
            } else {
                if at + 1 == self.places.len() {
                    return self.places[at];
                }
                (at + 1, self.lengths[at])
            };
            if length >= left {
                let share = if length > 0.0 { left / length } else { 0.0 };
                let (from, to) = (&self.places[at], &self.places[next]);
                return std::array::from_fn(|axis| from[axis] + share * (to[axis] - from[axis]));
            }
            left -= length;
            at = next;
        }
    }

    /// The stretch of a run.
    fn run(&mut self, first: usize, moves: &[Move], limits: &Limits, gap: f64) -> Option<Stretch> {
        let arrays = AxisArrays::new(limits);
        let measure = self.enter(first, moves, &arrays)?;
        if self.chords.count() < 2 {
            return None;
        }
        self.chords.divide(measure.places_apart());
        let smooth = self.smoothing.smooth(&self.chords, &measure)?;
        self.pieces.clear();
        self.speeds.clear();
        let mut part = 0;
        for (index, jet) in smooth.jets.iter().enumerate() {
            let (begin, end) = (smooth.at[index], smooth.at[index + 1]);
            let length = end - begin;
            while part + 1 < self.parts.len() && self.parts[part].end <= begin {
                part += 1;
            }
            let mut feed = f64::INFINITY;
            for chord in &self.parts[part..] {
                feed = feed.min(moves[chord.index].speed);
                if chord.end >= end {
                    break;
                }
            }
            let mut start = *jet;
            if measure.of(&start[2].map(|bend| bend * length * length)) < BEND
                && measure.of(&start[3].map(|third| third * length.powi(3))) < BEND
            {
                start[2] = [0.0; AXES];
                start[3] = [0.0; AXES];
            }
            let piece = Piece { length, base: None, start, tag: moves[self.parts[part].index].tag };
            self.speeds.push(feed / rate(&piece).max(1.0));
            self.pieces.push(piece);
        }
        let run = Run::new(&self.pieces, &self.speeds, 0.0, limits).ok()?;
        let phases = self.law.plan(&run, [Ends::Rest; 2], gap)?;
        Some(Stretch { pieces: self.tagged(moves), phases, overlap_s: 0.0 })
    }

    /// Enters the chords of a run, with lines that go on in each other as one.
    fn enter(&mut self, first: usize, moves: &[Move], limits: &AxisArrays) -> Option<Measure> {
        let mut tolerance = [f64::INFINITY; 2];
        let mut turns_only = true;
        self.parts.clear();
        self.chords.begin(self.places[first]);
        let mut last: Option<(Axes, f64)> = None;
        for (index, motion) in moves.iter().enumerate() {
            if let (Corner::Within { linear_mm, rotary_rad }, true) =
                (motion.corner, index + 1 < moves.len())
            {
                let own = [linear_mm.max(EXACT.linear_mm), rotary_rad.max(EXACT.rotary_rad)];
                tolerance = [tolerance[0].min(own[0]), tolerance[1].min(own[1])];
            }
            turns_only &= motion.curve.length() <= 0.0;
            let length = self.lengths[first + index];
            let (from, to) = (&self.places[first + index], &self.places[first + index + 1]);
            let direction: Axes = std::array::from_fn(|axis| (to[axis] - from[axis]) / length);
            let goes_on = last.is_some_and(|(before, speed)| {
                speed == motion.speed
                    && before.iter().zip(&direction).all(|(a, b)| (a - b).abs() < STRAIGHT)
            });
            self.chords.push(*to, length, goes_on);
            self.parts.push(Chord { index, end: self.chords.length() });
            last = Some((direction, motion.speed));
        }
        let [linear, rotary] = tolerance;
        (linear.is_finite()).then(|| Measure::new(linear, rotary, turns_only, limits))
    }

    /// The pieces cut where the next move begins, each with its tag.
    fn tagged(&self, moves: &[Move]) -> Vec<Piece> {
        let mut out = Vec::with_capacity(self.pieces.len() + self.parts.len());
        let (mut part, mut at) = (0, 0.0);
        for piece in &self.pieces {
            let end = at + piece.length;
            let mut done = 0.0;
            loop {
                let is_last = part + 1 >= self.parts.len();
                let chord = &self.parts[part];
                let until = if is_last || chord.end >= end { piece.length } else { chord.end - at };
                if until > done {
                    out.push(Piece {
                        length: until - done,
                        start: if done > 0.0 {
                            ahead(&piece.start, done, AXES)
                        } else {
                            piece.start
                        },
                        tag: moves[chord.index].tag,
                        base: None,
                    });
                    done = until;
                }
                if !is_last && chord.end <= end {
                    part += 1;
                }
                if until >= piece.length {
                    break;
                }
            }
            at = end;
        }
        out
    }
}

/// The largest |q'| of the tool on a piece, or of the rotary axes where these alone move.
fn rate(piece: &Piece) -> f64 {
    let [_, d1, d2, d3] = &piece.start;
    let h = piece.length;
    let mut sums = [[0.0_f64; 3]; 2];
    for axis in 0..AXES {
        // A parabola lies within the triangle of these.
        let (first, middle) = (d1[axis], d1[axis] + d2[axis] * h / 2.0);
        let last = d1[axis] + h * (d2[axis] + d3[axis] * h / 2.0);
        for (sum, value) in sums[axis / 3].iter_mut().zip([first, middle, last]) {
            *sum += value * value;
        }
    }
    let [linear, rotary] = sums.map(|sums| sums.into_iter().fold(0.0, f64::max).sqrt());
    if linear > 0.0 { linear } else { rotary }
}
