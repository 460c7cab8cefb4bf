//! Knots, control points and pieces of the cubic B-spline.

use std::ops::Range;

use chordal_geometry::AXES;

use super::SmoothingKernel;
use super::chords::ChordPath;
use super::widths::SmoothingWidths;
use crate::AxisValues;
use crate::piece::{AxisJet, ahead};

/// A place of the curve that is to be moved.
#[derive(Clone, Copy, Debug)]
pub(super) struct CurvePull {
    /// The chord that is too far there.
    pub chord: usize,
    pub piece: usize,
    /// Where on the piece, in shares of its length.
    pub share: f64,
    pub by: AxisValues,
}

/// What the mean over a box and a cubic B-spline take off, by the square of the distance of knots.
const SECOND_ORDER_BIAS: f64 = 5.0 / 24.0;
/// No box is averaged over more control points to a side.
const MAX_BOX_POINTS: usize = 60;
/// No more pieces than so many, and so many for each chord, and no more in all: a long chord next to one of a
/// nanometre would be cut into nanometres. Smooth runs have two for each chord.
const BASE_PIECES: f64 = 10_000.0;
const MAX_PIECES_PER_CHORD: f64 = 8.0;
const MAX_CURVE_PIECES: f64 = 100_000.0;

/// The spline.
#[derive(Debug, Default)]
pub(super) struct FittedSpline {
    /// Knots, three more than the run's at each end.
    knots: Vec<f64>,
    control: Vec<AxisValues>,
    widths: Vec<f64>,
    eroded: Vec<f64>,
    /// How far control points are moved, with the square of that.
    moved: Vec<(AxisValues, f64)>,
    /// The pieces that were moved last, in order.
    pub dirty: Vec<Range<usize>>,
    /// σ where each piece begins, and where the last ends.
    pub at: Vec<f64>,
    /// The axes and their derivatives where each piece begins.
    pub jets: Vec<AxisJet>,
    /// Only X, Y and Z move.
    is_linear: bool,
}

impl FittedSpline {
    /// Fits the spline to the chords; false where that takes too many pieces.
    pub fn fit(
        &mut self,
        chords: &ChordPath,
        widths: &SmoothingWidths,
        kernel: SmoothingKernel,
    ) -> bool {
        self.is_linear = chords.is_linear;
        if !self.place_knots(chords, widths) {
            return false;
        }
        match kernel {
            SmoothingKernel::Plain => self.plain(chords, widths),
            SmoothingKernel::Sharp => self.sharp(chords),
        }
        let last = self.control.len() - 1;
        self.control[1] = chords.places[0];
        self.control[last - 1] = chords.places[chords.count()];
        self.end_without_bend();
        let count = self.at.len() - 1;
        self.jets.resize(count, [[0.0; AXES]; 4]);
        self.make_pieces(0..count);
        true
    }

    /// The place at σ; `piece` is one that begins before.
    pub fn place_at(&self, sigma: f64, piece: &mut usize) -> AxisValues {
        while *piece + 1 < self.jets.len() && self.at[*piece + 1] <= sigma {
            *piece += 1;
        }
        ahead(&self.jets[*piece], sigma - self.at[*piece], AXES)[0]
    }

    fn place_knots(&mut self, chords: &ChordPath, widths: &SmoothingWidths) -> bool {
        let density = |index: usize| {
            let span = chords.at[index] - chords.at[index - 1];
            0.5 * (1.0 / widths.knots[index] + 1.0 / widths.knots[index - 1]) * span
        };
        let whole: f64 = (1..=chords.count()).map(density).sum();
        let most =
            (BASE_PIECES + MAX_PIECES_PER_CHORD * chords.count() as f64).min(MAX_CURVE_PIECES);
        if whole > most {
            return false;
        }
        let count = (whole.ceil() as usize).max(4);
        let step = whole / count as f64;
        let length = chords.length();
        self.at.clear();
        self.at.push(0.0);
        let mut sum = 0.0;
        for index in 1..=chords.count() {
            let part = density(index);
            let span = chords.at[index] - chords.at[index - 1];
            while self.at.len() < count && sum + part >= self.at.len() as f64 * step {
                let share = (self.at.len() as f64 * step - sum) / part;
                self.at.push(chords.at[index - 1] + span * share);
            }
            sum += part;
        }
        while self.at.len() < count {
            let left = (count - self.at.len()) as f64;
            self.at.push(length * (1.0 - 1e-9 * left));
        }
        self.at.push(length);
        let turned = |index: usize| 2.0 * length - self.at[count - index];
        self.knots.clear();
        self.knots.extend((1..=3).rev().map(|index| -self.at[index]));
        self.knots.extend_from_slice(&self.at);
        self.knots.extend((1..=3).map(turned));
        true
    }

    fn abscissa(&self, index: usize) -> f64 {
        (self.knots[index + 1] + self.knots[index + 2] + self.knots[index + 3]) / 3.0
    }

    fn spacing(&self, index: usize) -> f64 {
        0.5 * (self.knots[index + 3] - self.knots[index + 1])
    }

    /// Means over boxes, whose widths change evenly: a corner of the width is one of the path.
    fn plain(&mut self, chords: &ChordPath, widths: &SmoothingWidths) {
        let count = self.knots.len() - 4;
        let length = chords.length();
        let mut hint = 0;
        self.widths.clear();
        for index in 0..count {
            let at = self.abscissa(index);
            let inside = if at < 0.0 {
                -at
            } else if at > length {
                2.0 * length - at
            } else {
                at
            };
            let chord = chords.chord_at(inside, &mut hint);
            let span = chords.at[chord + 1] - chords.at[chord];
            let share = ((inside - chords.at[chord]) / span).clamp(0.0, 1.0);
            let [before, after] = [widths.boxes[chord], widths.boxes[chord + 1]];
            self.widths.push(0.5 * (before + share * (after - before)));
        }
        let reach =
            |half: f64, spacing: f64| ((half / spacing).ceil() as usize).clamp(1, MAX_BOX_POINTS);
        // The control points are symmetric about the second and the last but one.
        let fold = |index: isize| {
            let last = count as isize - 1;
            let index = if index < 0 { 2 - index } else { index };
            let index = if index > last { 2 * last - 2 - index } else { index };
            (0..=last).contains(&index).then_some(index as usize)
        };
        self.eroded.clear();
        for index in 0..count {
            let far = reach(self.widths[index], self.spacing(index)) as isize;
            let around = (-far..=far).filter_map(|k| fold(index as isize + k));
            let least = around.map(|other| self.widths[other]).fold(self.widths[index], f64::min);
            self.eroded.push(least);
        }
        let mut means = Vec::with_capacity(count);
        for index in 0..count {
            let far = reach(self.widths[index], self.spacing(index)) as isize;
            let (mut sum, mut weights) = (0.0, 0.0);
            for k in -far..=far {
                if let Some(other) = fold(index as isize + k) {
                    let weight = (far + 1 - k.abs()) as f64;
                    sum += weight * self.eroded[other];
                    weights += weight;
                }
            }
            means.push((sum / weights).min(self.widths[index]));
        }
        let mut hint = 0;
        self.control.clear();
        for (index, half) in means.into_iter().enumerate() {
            let at = self.abscissa(index);
            let place = if half > 0.0 {
                chords.mean(at, half, &mut hint)
            } else {
                chords.place_at(at, &mut hint)
            };
            self.control.push(place);
        }
    }

    /// Means over one spacing, and the bias of second order taken off.
    fn sharp(&mut self, chords: &ChordPath) {
        let count = self.knots.len() - 4;
        let length = chords.length();
        let last = self.at.len() - 1;
        let knot = |index: isize| -> f64 {
            let inner = index - 3;
            if inner < 0 {
                -self.at[(-inner as usize).min(last)]
            } else if inner as usize > last {
                2.0 * length - self.at[(2 * last).saturating_sub(inner as usize)]
            } else {
                self.at[inner as usize]
            }
        };
        let mut hint = 0;
        let mean = |index: isize, hint: &mut usize| {
            let [a, b, c] = [1, 2, 3].map(|k| knot(index + k));
            let at = (a + b + c) / 3.0;
            (at, chords.mean(at, 0.25 * (c - a), hint))
        };
        self.control.clear();
        let mut before = mean(-1, &mut hint);
        let mut here = mean(0, &mut hint);
        for index in 0..count {
            let after = mean(index as isize + 1, &mut hint);
            let (left, right) = (here.0 - before.0, after.0 - here.0);
            let spacing = self.spacing(index);
            let factor = SECOND_ORDER_BIAS * spacing * spacing * 2.0 / (left + right);
            self.control.push(std::array::from_fn(|axis| {
                let bend =
                    (after.1[axis] - here.1[axis]) / right - (here.1[axis] - before.1[axis]) / left;
                here.1[axis] - factor * bend
            }));
            (before, here) = (here, after);
        }
    }

    /// Moves control points so that the places that are pulled move as far as they are. Where several pull at
    /// one, the longest does. The ends stay, without bend.
    pub fn pull(&mut self, pulls: &[CurvePull]) {
        self.moved.clear();
        self.moved.resize(self.control.len(), ([0.0; AXES], 0.0));
        for pull in pulls {
            let u = pull.share;
            let left = 1.0 - u;
            // As with equal spaces between knots.
            let shares = [
                left * left * left,
                4.0 + u * u * (3.0 * u - 6.0),
                4.0 + left * left * (3.0 * left - 6.0),
                u * u * u,
            ];
            let squares: f64 = shares.iter().map(|share| share * share).sum();
            for (k, share) in shares.into_iter().enumerate() {
                let by = pull.by.map(|by| by * share * 6.0 / squares);
                let size = by.iter().map(|by| by * by).sum();
                let moved = &mut self.moved[pull.piece + k];
                if size > moved.1 {
                    *moved = (by, size);
                }
            }
        }
        let last = self.control.len() - 1;
        self.dirty.clear();
        // The ends are set anew.
        self.see_dirty(0);
        for index in 2..last - 1 {
            let (by, size) = self.moved[index];
            if size > 0.0 {
                for (place, by) in self.control[index].iter_mut().zip(by) {
                    *place += by;
                }
                self.see_dirty(index);
            }
        }
        self.see_dirty(last);
        self.end_without_bend();
        for index in 0..self.dirty.len() {
            self.make_pieces(self.dirty[index].clone());
        }
    }

    /// The outermost control points so that the curve goes through those next to them, without bend.
    fn end_without_bend(&mut self) {
        let last = self.control.len() - 1;
        for [outer, end, inner] in [[0, 1, 2], [last, last - 1, last - 2]] {
            for axis in 0..AXES {
                self.control[outer][axis] =
                    2.0 * self.control[end][axis] - self.control[inner][axis];
            }
        }
    }

    /// The pieces around a control point are moved.
    fn see_dirty(&mut self, control: usize) {
        let (begin, end) = (control.saturating_sub(3), (control + 1).min(self.jets.len()));
        match self.dirty.last_mut() {
            Some(last) if last.end >= begin => last.end = end,
            _ => self.dirty.push(begin..end),
        }
    }

    /// Pieces by the four control points around each.
    fn make_pieces(&mut self, pieces: Range<usize>) {
        if self.is_linear {
            self.make_pieces_of::<3>(pieces);
        } else {
            self.make_pieces_of::<AXES>(pieces);
        }
    }

    /// The same where no axes but the first ones move.
    fn make_pieces_of<const N: usize>(&mut self, pieces: Range<usize>) {
        for index in pieces {
            let t = &self.knots[index..index + 7];
            let c = &self.control[index..index + 4];
            let slopes = [3.0 / (t[4] - t[1]), 3.0 / (t[5] - t[2]), 3.0 / (t[6] - t[3])];
            let bends = [2.0 / (t[4] - t[2]), 2.0 / (t[5] - t[3])];
            let (share, last) = ((t[3] - t[2]) / (t[4] - t[2]), 1.0 / (t[4] - t[3]));
            let (a, b) = ((t[3] - t[1]) / (t[4] - t[1]), (t[3] - t[2]) / (t[5] - t[2]));
            let mut jet = [c[1], [0.0; AXES], [0.0; AXES], [0.0; AXES]];
            for axis in 0..N {
                let p = [c[0][axis], c[1][axis], c[2][axis], c[3][axis]];
                let d: [f64; 3] = std::array::from_fn(|k| (p[k + 1] - p[k]) * slopes[k]);
                let e: [f64; 2] = std::array::from_fn(|k| (d[k + 1] - d[k]) * bends[k]);
                let (first, second) = (p[0] + a * (p[1] - p[0]), p[1] + b * (p[2] - p[1]));
                jet[0][axis] = first + share * (second - first);
                jet[1][axis] = d[0] + share * (d[1] - d[0]);
                jet[2][axis] = e[0];
                jet[3][axis] = (e[1] - e[0]) * last;
            }
            self.jets[index] = jet;
        }
    }
}
