//! Relaxes a chain of pieces into a strip about the path: minimizes the sum of the squares of the distances by which
//! points are outside, while the chain stays tangent.
//!
//! The steps are those of Levenberg and Marquardt. A change of a piece affects only its neighbours, so the matrix is a
//! band with nine numbers per row. The distance of a point from an arc is computed from its power with respect to the
//! circle, which is also stable if the arc becomes straight.

use crate::{Vec2, math};

use super::band::{BandMatrix, EquationTerms};
use super::flat::PlanarPoints;
use super::row::{EACH, JointDirections, PieceRow};

/// The largest number of steps.
const STEPS: usize = 48;
/// A chain that keeps more than this fraction of its excess over [`MAX_ROUNDS_WITHOUT_GAIN`] steps is given up.
const LEFT: f64 = 0.5;
const MAX_ROUNDS_WITHOUT_GAIN: usize = 8;
/// The number of first steps in which every point counts, for a chain that is not close to the path yet.
const FIRST_STEPS: usize = 3;
/// The largest number of chords of a piece of which all points are checked; of longer pieces, this many points are
/// checked.
const PROBES: usize = 20;
/// Weight of the tangency of pieces relative to distances.
const DIRECTION: f64 = 1e5;
/// How far joints may slide, relative to what the width of the strip and the length of the pieces suggest.
const SLIDE: f64 = 16.0;

/// A strip about the path, and how chains are relaxed into it.
#[derive(Clone, Copy)]
pub(super) struct StripRow<'a> {
    pub(super) flat: &'a PlanarPoints,
    /// Half of the width of the strip, mm.
    pub(super) width: f64,
}

/// How far points are outside of the strip.
#[derive(Clone, Copy)]
struct StripExcess {
    /// The sum of the squares, mm².
    sum: f64,
    largest: f64,
}

impl StripRow<'_> {
    /// The relaxed, tangent chain, and the largest distance by which it is outside, mm. `None` if the steps do not
    /// converge.
    pub(super) fn relax(&self, row: &PieceRow, is_rough: bool) -> Option<(PieceRow, f64)> {
        let mut row = row.clone();
        if !row.is_sound() {
            return None;
        }
        if is_rough {
            for _ in 0..FIRST_STEPS {
                let probes = self.probes(&row);
                let change = self.step(&row, &probes, 0.0, 1e-4)?;
                row.change(&change)?;
                row.settle(self.flat)?;
            }
        }
        row.make_tangent()?;
        row.settle(self.flat)?;
        let probes = self.probes(&row);
        let mut outside = self.outside(&row, &probes);
        let (mut damping, mut before) = (1e-3, f64::INFINITY);
        for step in 0..STEPS {
            if step % MAX_ROUNDS_WITHOUT_GAIN == 0 {
                if outside.sum > LEFT * before {
                    break;
                }
                before = outside.sum;
            }
            if outside.largest <= 0.0 {
                break;
            }
            let change = self.step(&row, &probes, self.width, damping)?;
            match self.tried(&row, &probes, &change) {
                Some((new, left)) if left.sum < outside.sum => {
                    (row, outside) = (new, left);
                    damping = (damping * 0.3).max(1e-7);
                }
                _ => damping *= 10.0,
            }
        }
        Some((row, outside.largest))
    }

    fn tried(
        &self,
        row: &PieceRow,
        probes: &[RowProbe],
        change: &[f64],
    ) -> Option<(PieceRow, StripExcess)> {
        let mut new = row.clone();
        new.change(change)?;
        new.make_tangent()?;
        new.settle(self.flat)?;
        let outside = self.outside(&new, probes);
        Some((new, outside))
    }

    /// The positions at which the path is checked, which stay the same while joints move.
    fn probes(&self, row: &PieceRow) -> Vec<RowProbe> {
        let mut probes = Vec::with_capacity(row.len() * (PROBES + 1));
        for span in row.places.windows(2) {
            self.flat.probes(span[0], span[1], PROBES, |place| {
                probes.push(RowProbe { place, point: self.flat.point(place).0 });
            });
        }
        probes
    }

    fn outside(&self, row: &PieceRow, probes: &[RowProbe]) -> StripExcess {
        let mut outside = StripExcess { sum: 0.0, largest: 0.0 };
        each(row, probes, |_, circle, point| {
            let by = circle.off(point).abs() - self.width;
            if by > 0.0 {
                outside.sum += by * by;
                outside.largest = outside.largest.max(by);
            }
        });
        outside
    }

    /// The step that moves the chain closer to points that are farther off than `width`, mm.
    fn step(
        &self,
        row: &PieceRow,
        probes: &[RowProbe],
        width: f64,
        damping: f64,
    ) -> Option<Vec<f64>> {
        let unknowns = row.len() * EACH;
        let (mut band, mut right) = (BandMatrix::<9>::new(unknowns), vec![0.0; unknowns]);
        let along = row.along();
        each(row, probes, |piece, circle, point| {
            let off = circle.off(point);
            if off.abs() > width {
                let terms = circle.terms(row, &along, piece, point, off);
                band.add(&mut right, &terms, off.signum() * width - off, 1.0);
            }
        });
        let weight = |joint: usize| {
            let of = |piece: usize| row.chord(piece.min(row.len() - 1)).length();
            let length = of(joint.saturating_sub(1)).min(of(joint));
            (length, DIRECTION * length * length)
        };
        let first = if row.is_closed { 1 } else { 0 };
        for joint in first..=row.len() {
            if let Some((terms, off)) = row.equation(joint, &along) {
                band.add(&mut right, &terms, -off, weight(joint).1);
            }
        }
        for joint in 0..row.len() {
            let slide = (SLIDE * self.width / weight(joint).0).min(1.0);
            band.rows[joint * EACH][0] += damping;
            band.rows[joint * EACH + 1][0] += damping * slide * slide;
            band.rows[joint * EACH + 2][0] += damping;
        }
        let factored = band.factored()?;
        let mut change = factored.solve(right);
        if row.is_closed
            && let Some((terms, off)) = row.equation(0, &along)
        {
            close(&factored, &mut change, &terms, off, weight(0).1);
        }
        Some(change)
    }
}

/// A position of the path, and its point.
struct RowProbe {
    place: f64,
    point: Vec2,
}

/// Passes every probe to `see`, with the piece that it belongs to.
fn each(row: &PieceRow, probes: &[RowProbe], mut see: impl FnMut(usize, &SupportCircle, Vec2)) {
    let mut probes = probes.iter().peekable();
    for piece in 0..row.len() {
        let circle = SupportCircle::of(row, piece);
        let is_last = piece + 1 == row.len();
        while let Some(probe) = probes.next_if(|it| is_last || it.place <= row.places[piece + 1]) {
            see(piece, &circle, probe.point);
        }
    }
}

/// Includes one more equation in a solution, by the formula of Sherman and Morrison.
fn close(
    factored: &super::band::FactoredBand<9>,
    change: &mut [f64],
    terms: &EquationTerms,
    off: f64,
    weight: f64,
) {
    let mut right = vec![0.0; change.len()];
    terms.iter().for_each(|(unknown, factor)| right[unknown] += factor);
    let solved = factored.solve(right);
    let (mut met, mut reach) = (0.0, 0.0);
    for (unknown, factor) in terms.iter() {
        met += factor * change[unknown];
        reach += factor * solved[unknown];
    }
    let factor = weight * (-off - met) / (1.0 + weight * reach);
    for (entry, by) in change.iter_mut().zip(&solved) {
        *entry += factor * by;
    }
}

/// The circle or line of a piece.
struct SupportCircle {
    ends: [Vec2; 2],
    chord: Vec2,
    length: f64,
    sin: f64,
    cos: f64,
}

impl SupportCircle {
    fn of(row: &PieceRow, piece: usize) -> SupportCircle {
        let (sin, cos) = math::sin_cos(row.halves[piece]);
        let chord = row.chord(piece);
        let ends = [row.joints[piece], row.joints[piece + 1]];
        SupportCircle { ends, chord, length: chord.length(), sin, cos }
    }

    /// How far a point is to the left, mm: its power with respect to the circle, divided by the diameter.
    fn off(&self, point: Vec2) -> f64 {
        let [v, w] = self.ends.map(|end| point - end);
        (self.cos * self.chord.cross(v) - self.sin * v.dot(w)) / self.length
    }

    /// How that distance changes with the unknowns of the piece.
    fn terms(
        &self,
        row: &PieceRow,
        along: &JointDirections,
        piece: usize,
        point: Vec2,
        off: f64,
    ) -> EquationTerms {
        let [v, w] = self.ends.map(|end| point - end);
        let part = 1.0 / self.length;
        let range = self.chord * (off * part * part);
        let first = (w.turned_left() * self.cos + w * self.sin) * part + range;
        let last = (v.turned_left() * -self.cos + v * self.sin) * part - range;
        let mut terms = EquationTerms::default();
        along.terms(piece, first, &mut terms);
        along.terms(piece + 1, last, &mut terms);
        if !row.lines[piece] {
            let turn = -(self.sin * self.chord.cross(v) + self.cos * v.dot(w)) * part;
            terms.push(piece * EACH + 2, turn * 4.0 * part);
        }
        terms
    }
}
