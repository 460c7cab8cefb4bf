//! Pieces that meet at small angles are moved and bent a little, so that they meet in one direction.
//!
//! Two arcs meet tangentially where the angle between their chords is half the sum of their turns. A
//! row of n arcs has n − 1 such equations; free are the bulge of every arc and the place of every
//! joint. First the row is eased to where it nearly meets them and its largest distance from the points is
//! small (`ease`); then Newton's steps take the least change that satisfies them, where a joint may
//! slide along the path more freely than off it.

use crate::{Vec2, math};

use super::Measure;
use super::deviation::deviation;
use super::ease::{EASINGS, probes};
use super::flat::{Flat, Piece, shape};

/// How much more freely a joint slides along the path than it leaves it.
const SLIDE: f64 = 16.0;
const MOST_STEPS: usize = 12;
/// Directions that differ by less are one, radians.
const TANGENT: f64 = 1e-11;
/// A joint is looked for among so many chords beside where it was.
const MOST_CHORDS: usize = 400;

/// The joints of `pieces` that are free to be tangent, by the piece behind: all but those between lines.
pub(super) fn smooth_joints(pieces: &[Piece]) -> Vec<bool> {
    let mut smooth = vec![false; pieces.len()];
    for index in 1..pieces.len() {
        smooth[index] = !(pieces[index - 1].is_line() && pieces[index].is_line());
    }
    smooth
}

/// The pieces made tangent at the joints asked for; `None` where that does not come to an end.
pub(super) fn tangent(flat: &Flat, pieces: &[Piece], smooth: &[bool]) -> Option<Vec<Piece>> {
    let mut row = Row::of(pieces, smooth);
    let probes = probes(flat, pieces);
    for round in 0..EASINGS {
        row.ease(flat, &probes, round)?;
    }
    let mut largest = f64::INFINITY;
    for _ in 0..MOST_STEPS {
        let off = row.off();
        largest = off.iter().fold(0.0f64, |most, off| most.max(off.abs()));
        if largest <= TANGENT {
            break;
        }
        row.step(&off)?;
    }
    (largest <= TANGENT * 100.0).then(|| row.pieces(flat, pieces))?
}

/// Measures pieces anew.
pub(super) fn measure(flat: &Flat, pieces: &mut [Piece], measure: Measure) {
    for piece in pieces {
        piece.deviation = deviation(flat, piece, measure, f64::INFINITY).unwrap_or(f64::INFINITY);
    }
}

/// A row of pieces by what may change of it.
pub(super) struct Row<'a> {
    smooth: &'a [bool],
    /// Where pieces begin; the last is the end.
    pub(super) joints: Vec<Vec2>,
    /// Half of the turn of each piece.
    pub(super) halves: Vec<f64>,
    pub(super) lines: Vec<bool>,
}

/// An equation: how its left side changes with the joints before, at and behind, and with the bulges
/// of the pieces before and behind.
#[derive(Clone, Copy, Default)]
pub(super) struct Equation {
    pub(super) joints: [Vec2; 3],
    pub(super) bulges: [f64; 2],
}

impl<'a> Row<'a> {
    fn of(pieces: &[Piece], smooth: &'a [bool]) -> Row<'a> {
        let mut joints: Vec<Vec2> = pieces.iter().map(|piece| piece.ends[0]).collect();
        joints.extend(pieces.last().map(|piece| piece.ends[1]));
        Row {
            smooth,
            joints,
            halves: pieces.iter().map(Piece::half).collect(),
            lines: pieces.iter().map(Piece::is_line).collect(),
        }
    }

    pub(super) fn chord(&self, piece: usize) -> Vec2 {
        self.joints[piece + 1] - self.joints[piece]
    }

    /// By how much the equations of the joints are not met; zero for joints that need not be tangent.
    pub(super) fn off(&self) -> Vec<f64> {
        let off = |piece: usize| {
            if piece == 0 || !self.smooth[piece] {
                return 0.0;
            }
            let (a, b) = (self.chord(piece - 1), self.chord(piece));
            let turn =
                math::atan2(a.cross(b), a.dot(b)) - self.halves[piece - 1] - self.halves[piece];
            turn - math::TAU * math::round(turn / math::TAU)
        };
        (0..self.halves.len()).map(off).collect()
    }

    /// Whether the joint at the head of a piece may be moved.
    pub(super) fn is_free(&self, joint: usize) -> bool {
        self.smooth.get(joint).copied().unwrap_or(false)
    }

    pub(super) fn equation(&self, piece: usize) -> Equation {
        if !self.is_free(piece) {
            return Equation::default();
        }
        let slope = |piece: usize| {
            let chord = self.chord(piece);
            chord.turned_left() * (1.0 / chord.dot(chord))
        };
        let (before, behind) = (slope(piece - 1), slope(piece));
        let bulge = |piece: usize| {
            if self.lines[piece] { 0.0 } else { -4.0 / self.chord(piece).length() }
        };
        Equation {
            joints: [before, -(before + behind), behind],
            bulges: [bulge(piece - 1), bulge(piece)],
        }
    }

    /// The direction of the path at a joint, about.
    pub(super) fn along(&self, joint: usize) -> Vec2 {
        let unit = |piece: usize| self.chord(piece).normalized().unwrap_or(Vec2::ZERO);
        (unit(joint - 1) + unit(joint)).normalized().unwrap_or(Vec2::ZERO)
    }

    /// How a joint moves for a pull: not at all where it is fixed.
    fn give(&self, joint: usize, pull: Vec2) -> Vec2 {
        if !self.is_free(joint) {
            return Vec2::ZERO;
        }
        let along = self.along(joint);
        pull + along * (along.dot(pull) * (SLIDE - 1.0))
    }

    /// One step of Newton, the least in the sense of the weights.
    fn step(&mut self, off: &[f64]) -> Option<()> {
        let equations: Vec<Equation> = (0..off.len()).map(|piece| self.equation(piece)).collect();
        let factors = self.solve(&equations, off)?;
        let mut pulls = vec![Vec2::ZERO; self.joints.len()];
        let mut bulges = vec![0.0; off.len()];
        for (piece, equation) in equations.iter().enumerate().skip(1) {
            for (beside, gradient) in equation.joints.iter().enumerate() {
                pulls[piece + beside - 1] = pulls[piece + beside - 1] + *gradient * factors[piece];
            }
            bulges[piece - 1] += equation.bulges[0] * factors[piece];
            bulges[piece] += equation.bulges[1] * factors[piece];
        }
        let moves: Vec<Vec2> =
            pulls.iter().enumerate().map(|(joint, pull)| self.give(joint, *pull)).collect();
        for (piece, bulge) in bulges.iter().enumerate() {
            if !self.lines[piece] {
                self.halves[piece] += bulge * 4.0 / self.chord(piece).length();
            }
        }
        for (joint, by) in self.joints.iter_mut().zip(moves) {
            *joint = *joint + by;
        }
        self.is_sound().then_some(())
    }

    pub(super) fn is_sound(&self) -> bool {
        self.halves.iter().all(|half| half.abs() < 0.95 * math::PI)
            && self.joints.iter().all(|joint| joint.a.is_finite() && joint.b.is_finite())
    }

    /// Factors λ of the equations with A·W·Aᵀ·λ = −off: a band of two beside the diagonal.
    fn solve(&self, equations: &[Equation], off: &[f64]) -> Option<Vec<f64>> {
        let count = equations.len();
        let product = |one: usize, other: usize| {
            // Joint j of the row is the `j + 1 − k`th of equation k.
            let shift = other - one;
            let mut sum = 0.0;
            for beside in shift..3 {
                let give = self.give(one + beside - 1, equations[one].joints[beside]);
                sum += give.dot(equations[other].joints[beside - shift]);
            }
            for beside in shift..2 {
                sum += equations[one].bulges[beside] * equations[other].bulges[beside - shift];
            }
            sum
        };
        let mut band = vec![[0.0f64; 3]; count];
        for (row, band) in band.iter_mut().enumerate() {
            if !self.is_free(row) {
                band[0] = 1.0;
                continue;
            }
            for (shift, entry) in band.iter_mut().enumerate() {
                if row + shift < count && self.is_free(row + shift) {
                    *entry = product(row, row + shift);
                }
            }
        }
        solve_band(band, off.iter().map(|off| -off).collect())
    }

    fn pieces(&self, flat: &Flat, old: &[Piece]) -> Option<Vec<Piece>> {
        let mut new: Vec<Piece> = Vec::with_capacity(old.len());
        for (index, piece) in old.iter().enumerate() {
            let ends = [self.joints[index], self.joints[index + 1]];
            let mut piece = Piece { ends, shape: shape(ends, self.halves[index]), ..*piece };
            if let Some(before) = new.last_mut()
                && self.smooth[index]
            {
                let (sin, cos) = math::sin_cos(-self.halves[index]);
                let chord = self.chord(index);
                let tangent = chord * cos + chord.turned_left() * sin;
                let place = foot(flat, piece.span[0], ends[0], tangent)?;
                if place < before.span[0] {
                    return None;
                }
                piece.span[0] = place;
                before.span[1] = place;
                piece.heights[0] = flat.point(place).1;
                before.heights[1] = piece.heights[0];
            }
            new.push(piece);
        }
        let is_forward = |piece: &Piece| piece.span[0] <= piece.span[1];
        new.iter().all(is_forward).then_some(new)
    }
}

/// The place of the path, near to another, where it crosses the line through a joint square to a
/// direction.
fn foot(flat: &Flat, near: f64, joint: Vec2, tangent: Vec2) -> Option<f64> {
    let ahead = |index: usize| (flat.at[index] - joint).dot(tangent);
    let mut index = (near as usize).min(flat.last());
    for _ in 0..MOST_CHORDS {
        let here = ahead(index);
        if here > 0.0 {
            index = index.checked_sub(1)?;
            continue;
        }
        if index == flat.last() {
            return (here == 0.0).then_some(index as f64);
        }
        let next = ahead(index + 1);
        if next > 0.0 {
            return Some(index as f64 + here / (here - next));
        }
        index += 1;
    }
    None
}

/// Solves a symmetric system whose rows hold the diagonal and two entries behind it.
fn solve_band(mut band: Vec<[f64; 3]>, mut right: Vec<f64>) -> Option<Vec<f64>> {
    let count = band.len();
    for row in 0..count {
        let [diagonal, one, two] = band[row];
        if !(diagonal > 0.0 && diagonal.is_finite()) {
            return None;
        }
        if row + 1 < count {
            band[row + 1][0] -= one * one / diagonal;
            band[row + 1][1] -= one * two / diagonal;
            right[row + 1] -= one / diagonal * right[row];
        }
        if row + 2 < count {
            band[row + 2][0] -= two * two / diagonal;
            right[row + 2] -= two / diagonal * right[row];
        }
    }
    for row in (0..count).rev() {
        let [diagonal, one, two] = band[row];
        let mut value = right[row];
        value -= if row + 1 < count { one * right[row + 1] } else { 0.0 };
        value -= if row + 2 < count { two * right[row + 2] } else { 0.0 };
        right[row] = value / diagonal;
    }
    Some(right)
}
