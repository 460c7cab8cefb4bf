//! The longest line or arc from a point on, and the fewest of them in a row.

use crate::math;

use super::FitMeasure;
use super::deviation::deviation;
use super::flat::{FittedPiece, PlanarPoints};

/// Arcs turn by no more than this, radians: near a whole turn the ends say little about the centre.
const MAX_HALF_TURN: f64 = 5.0 / 6.0 * math::PI;

/// A line is taken where it comes this near to what an arc would reach.
const LINE_FOR_ARC: f64 = 0.85;

/// As many points of a longer row are looked at while a piece is sought; and for the place of its centre when
/// it is measured.
const SAMPLES: usize = 24;
const FINE_SAMPLES: usize = 200;

/// At which points a piece is looked at.
#[derive(Clone, Copy, PartialEq, Eq)]
enum PointSampling {
    Some,
    All,
}

/// Points from one to before another: all of few, some of many.
fn samples(from: usize, to: usize, most: usize) -> impl Iterator<Item = usize> {
    let count = (to - from).min(most);
    (0..count).map(move |sample| from + (to - from) * sample / count)
}

/// The furthest number for which there is something, and that: by steps that double, then by halving.
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
    // To a sixty-fourth: the row of pieces is made even afterwards.
    while bad - good > 1 + good / 64 {
        let next = good + (bad - good) / 2;
        match find(from + next) {
            Some(found) => (best, good) = (Some((found, from + next)), next),
            None => bad = next,
        }
    }
    best
}

/// Looks for pieces along a row of points.
pub(super) struct PieceFinder<'a> {
    pub(super) flat: &'a PlanarPoints,
    pub(super) tolerance: f64,
    pub(super) measure: FitMeasure,
    pub(super) max_radius: f64,
}

impl PieceFinder<'_> {
    /// Lines and arcs from a point to another, each as long as it can be.
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

    /// The longest line or arc from a point on.
    fn longest(&self, from: usize, last: usize, hint: usize) -> FittedPiece {
        let stiff = self.flat.stiff[from];
        let line =
            self.furthest(from, last, hint, |to, look| self.line(from, to, self.tolerance, look));
        let straight = || {
            // Further than the straight part of the path a line only cuts into the bend after it.
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

    /// The piece to the furthest point for which there is one: looked for at some of the points, then
    /// measured.
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
        // It may be beyond between the points looked at: then mostly not by much.
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

    /// Half of the turn of the arc between two points that keeps furthest from the limits that the
    /// points between set; `None` where they leave nothing.
    ///
    /// In the frame of the chord of length 2h, with (x, y) from its middle: a circle through both ends
    /// passes within e of a point where |k/2·sin ω + y·cos ω| ≤ e, k = (x² + y² − h² − e²)/h and ω half
    /// of the turn to the right. That is an interval about ω₀ = atan2(2y, −k).
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
            // Where both ends of a short interval are within, all of it is.
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
