//! Finds the longest line or arc from a point, and a chain of few such pieces.

use crate::math;

use super::FitMeasure;
use super::deviation::deviation;
use super::flat::{FittedPiece, PlanarPoints};

/// Half of the largest angle of an arc, rad: close to a full turn the ends hardly determine the centre.
const MAX_HALF_TURN: f64 = 5.0 / 6.0 * math::PI;

/// A line is preferred if it reaches at least this fraction of the length of an arc.
const LINE_FOR_ARC: f64 = 0.85;

/// The largest number of points that are checked during the search for a piece.
const SAMPLES: usize = 24;
/// The largest number of points that are checked for its angle when its deviation is computed.
const FINE_SAMPLES: usize = 200;

/// Which points are checked for a piece.
#[derive(Clone, Copy, PartialEq, Eq)]
enum PointSampling {
    Some,
    All,
}

/// Indices from one up to another, excluding it: all, or `most` of them at equal distances.
fn samples(from: usize, to: usize, most: usize) -> impl Iterator<Item = usize> {
    let count = (to - from).min(most);
    (0..count).map(move |sample| from + (to - from) * sample / count)
}

/// The largest index found for which `find` returns something, with the result: first with doubling steps, then by
/// bisection. `None` if there is none.
fn search<T>(
    from: usize,
    last: usize,
    hint: usize,
    find: impl Fn(usize) -> Option<T>,
) -> Option<(T, usize)> {
    let mut best = None;
    let (mut good, mut bad) = (1, last - from + 1);
    let mut step = (hint / 2).max(1);
    while good + 1 < bad {
        let next = (good + step).min(bad - 1);
        match find(from + next) {
            Some(found) => {
                (best, good) = (Some((found, from + next)), next);
                step *= 2;
            }
            None => {
                bad = next;
                break;
            }
        }
    }
    // To a 64th, which is enough because the lengths of the pieces are balanced afterwards.
    while bad - good > 1 + good / 64 {
        let next = good + (bad - good) / 2;
        match find(from + next) {
            Some(found) => (best, good) = (Some((found, from + next)), next),
            None => bad = next,
        }
    }
    best
}

/// Searches for pieces along a sequence of points.
pub(super) struct PieceFinder<'a> {
    pub(super) flat: &'a PlanarPoints,
    pub(super) tolerance: f64,
    pub(super) measure: FitMeasure,
    pub(super) max_radius: f64,
}

impl PieceFinder<'_> {
    /// Lines and arcs from one point to another, each as long as possible.
    pub(super) fn chain(&self, [from, to]: [usize; 2]) -> Vec<FittedPiece> {
        let mut pieces: Vec<FittedPiece> = Vec::new();
        let (mut at, mut hint) = (from, 1);
        while at < to {
            let piece = self.longest(at, to, hint);
            let to = piece.span[1] as usize;
            hint = to - at;
            at = to;
            pieces.push(piece);
        }
        pieces
    }

    /// The longest line or arc from a point.
    fn longest(&self, from: usize, last: usize, hint: usize) -> FittedPiece {
        let stiff = self.flat.stiff[from];
        let line =
            self.furthest(from, last, hint, |to, look| self.line(from, to, self.tolerance, look));
        let straight = || {
            // Beyond the straight part of the path, a line would only cut into the bend after it.
            let fine = self.tolerance / 10.0;
            let to = line.span[1] as usize;
            let near =
                self.furthest(from, to, to - from, |to, look| self.line(from, to, fine, look));
            let is_enough = self.length(&near) >= 0.8 * self.length(&line);
            if is_enough || stiff == from { near } else { line }
        };
        if stiff == from {
            return straight();
        }
        let arc = self.furthest(from, stiff.min(last), hint, |to, look| self.arc(from, to, look));
        if self.length(&line) >= LINE_FOR_ARC * self.length(&arc) { straight() } else { arc }
    }

    fn length(&self, piece: &FittedPiece) -> f64 {
        self.flat.length(piece.span[0] as usize, piece.span[1] as usize)
    }

    /// The piece to the farthest possible point: searched with some of the points, then with its exact deviation.
    fn furthest(
        &self,
        from: usize,
        last: usize,
        hint: usize,
        piece: impl Fn(usize, PointSampling) -> Option<FittedPiece>,
    ) -> FittedPiece {
        let single = FittedPiece::between(self.flat, from, from + 1, 0.0);
        let found = search(from, last, hint, |to| piece(to, PointSampling::Some));
        let Some((_, to)) = found else { return single };
        // Between the checked points the deviation may be too large, but usually only slightly.
        let nearer = |part: usize| from + (to - from) * part / 64;
        let tried = [64, 63, 62, 60, 56].map(nearer);
        let measured = tried.into_iter().find_map(|to| piece(to, PointSampling::All));
        measured
            .or_else(|| {
                search(from, to, (to - from) / 2, |to| piece(to, PointSampling::All)).map(|it| it.0)
            })
            .unwrap_or(single)
    }

    fn line(
        &self,
        from: usize,
        to: usize,
        tolerance: f64,
        look: PointSampling,
    ) -> Option<FittedPiece> {
        let piece = FittedPiece::between(self.flat, from, to, 0.0);
        if look == PointSampling::Some {
            let (chord, at) = (piece.chord(), &self.flat.at);
            let most = tolerance * chord.length();
            let is_near = |index: usize| (at[index] - at[from]).cross(chord).abs() <= most;
            return samples(from, to, SAMPLES).all(is_near).then_some(piece);
        }
        let deviation = deviation(self.flat, &piece, self.measure, tolerance)?;
        Some(FittedPiece { deviation, ..piece })
    }

    fn arc(&self, from: usize, to: usize, look: PointSampling) -> Option<FittedPiece> {
        if to - from < 2 {
            return None;
        }
        let most = if look == PointSampling::Some { SAMPLES } else { FINE_SAMPLES };
        let half = self.half_turn(from, to, most)?;
        let length = self.flat.at[from].distance(self.flat.at[to]);
        if length > 2.0 * self.max_radius * math::sin_cos(half).0.abs() {
            return None;
        }
        let piece = FittedPiece::between(self.flat, from, to, half);
        if look == PointSampling::Some {
            return Some(piece);
        }
        let deviation = deviation(self.flat, &piece, self.measure, self.tolerance)?;
        Some(FittedPiece { deviation, ..piece })
    }

    /// Half of the angle of the arc between two points, rad, in the middle of the range that the points between them
    /// allow; `None` if the range is empty.
    ///
    /// In the frame of the chord of length 2h, with (x, y) relative to its midpoint: a circle through both ends passes
    /// within e of a point if |k/2·sin ω + y·cos ω| ≤ e, with k = (x² + y² − h² − e²)/h and ω half of the angle to the
    /// right. That is an interval about ω₀ = atan2(2y, −k).
    fn half_turn(&self, from: usize, to: usize, most: usize) -> Option<f64> {
        let at = &self.flat.at;
        let chord = at[to] - at[from];
        let h = 0.5 * chord.length();
        let along = chord.normalized()?;
        let middle = (at[from] + at[to]) * 0.5;
        let e = self.tolerance;
        let mut range = [-MAX_HALF_TURN, MAX_HALF_TURN];
        let mut limits = range.map(math::sin_cos);
        let mut narrow = |x: f64, y: f64| {
            let half_k = 0.5 * (x * x + y * y - h * h - e * e) / h;
            let is_within = |(sin, cos): (f64, f64)| (half_k * sin + y * cos).abs() <= e;
            // If both ends of a short interval satisfy the condition, so does all of it.
            if range[1] - range[0] < 1.0 && is_within(limits[0]) && is_within(limits[1]) {
                return true;
            }
            let amplitude = (half_k * half_k + y * y).sqrt();
            if amplitude > e {
                let (zero, width) = (math::atan2(y, -half_k), math::asin(e / amplitude));
                range = [range[0].max(zero - width), range[1].min(zero + width)];
                limits = range.map(math::sin_cos);
            }
            range[0] <= range[1]
        };
        for index in samples(from, to, most) {
            let here = at[index] - middle;
            if index > from && !narrow(here.dot(along), along.cross(here)) {
                return None;
            }
            if self.flat.deep[index] {
                let deep = (at[index] + at[index + 1]) * 0.5 - middle;
                if !narrow(deep.dot(along), along.cross(deep)) {
                    return None;
                }
            }
        }
        let half = -0.5 * (range[0] + range[1]);
        (half != 0.0).then_some(half)
    }
}
