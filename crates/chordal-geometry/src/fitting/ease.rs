//! Eases a row of pieces to where its largest distance from the points is small and neighbours nearly
//! meet in one direction.
//!
//! Distances at a few points of every piece are made small in a high norm, which stands for the largest:
//! by weighted least squares whose weights grow with the distances (Lawson). That the pieces are to be
//! tangent are further rows of much weight. What changes of a piece touches its neighbours only, so the
//! normal equations are a band.

use crate::Vec2;

use super::flat::{Flat, Piece, Shape, shape};
use super::tangent::Row;

/// Rounds of easing.
pub(super) const EASINGS: usize = 16;
/// Places looked at between the ends of a piece.
const PROBES: usize = 10;
/// Weight of the directions' equality beside distances.
const DIRECTION: f64 = 1e5;
/// Weight of a joint's sliding along the path, and of any change at all: a row of lines leaves some free.
const SLIDE: f64 = 1e-3;
const CHANGE: f64 = 1e-6;
/// Unknowns of a piece: of its first joint off and along the path, and its bulge.
const EACH: usize = 3;
/// An equation reaches over two pieces more.
const BAND: usize = 3 * EACH;

/// The points, by their numbers, at which a piece's distance is looked at.
pub(super) fn probes(flat: &Flat, pieces: &[Piece]) -> Vec<Vec<usize>> {
    let of = |piece: &Piece| {
        let (from, to) = (piece.span[0] as usize, piece.span[1] as usize);
        let count = (to - from).clamp(1, PROBES);
        (0..=count).map(|probe| from + (to - from) * probe / count).collect()
    };
    debug_assert!(pieces.iter().all(|piece| piece.span[1] as usize <= flat.last()));
    pieces.iter().map(of).collect()
}

/// How far a piece lies to the left of a point, and the direction that is left there.
fn left_of(ends: [Vec2; 2], shape: Shape, point: Vec2) -> (f64, Vec2) {
    match shape {
        Shape::Line => {
            let left = (ends[1] - ends[0]).normalized().unwrap_or(Vec2::ZERO).turned_left();
            ((ends[0] - point).dot(left), left)
        }
        Shape::Arc { center, sweep } => {
            let (spoke, radius) = (point - center, (ends[0] - center).length());
            let outward = spoke.normalized().unwrap_or(Vec2::ZERO);
            let off = spoke.length() - radius;
            if sweep > 0.0 { (off, -outward) } else { (-off, outward) }
        }
    }
}

impl Row<'_> {
    /// One round; later ones come nearer to the largest distance.
    pub(super) fn ease(&mut self, flat: &Flat, probes: &[Vec<usize>], round: usize) -> Option<()> {
        let pieces = self.halves.len();
        let mut rows: Vec<(Terms, f64)> = Vec::with_capacity(pieces * (PROBES + 1));
        let mut largest = 0.0f64;
        for (piece, probes) in probes.iter().enumerate() {
            let ends = [self.joints[piece], self.joints[piece + 1]];
            let shape = shape(ends, self.halves[piece]);
            let (from, to) = (probes[0], probes[probes.len() - 1]);
            for probe in probes {
                let (off, left) = left_of(ends, shape, flat.at[*probe]);
                let part = flat.length(from, *probe) / flat.length(from, to);
                largest = largest.max(off.abs());
                let mut row = Terms::default();
                self.joint_terms(piece, left * (1.0 - part), &mut row);
                self.joint_terms(piece + 1, left * part, &mut row);
                if !self.lines[piece] {
                    row.push((piece * EACH + 2, -4.0 * part * (1.0 - part)));
                }
                rows.push((row, -off));
            }
        }
        let mut system = Band::new(pieces * EACH);
        let power = [2, 4, 8][(round / 2).min(2)];
        let weight = |part: f64| {
            let square = part * part;
            [1.0, square, square * square * square][(round / 2).min(2)]
        };
        for (row, off) in &rows {
            // What is far off weighs more: the norm of this power, by least squares.
            let part = (off.abs() / largest.max(f64::MIN_POSITIVE)).max(0.05);
            system.add(row.slice(), *off, weight(part));
        }
        for (joint, off) in self.off().iter().enumerate() {
            if !self.is_free(joint) {
                continue;
            }
            let equation = self.equation(joint);
            let mut row = Terms::default();
            for (beside, gradient) in equation.joints.iter().enumerate() {
                self.joint_terms(joint + beside - 1, *gradient, &mut row);
            }
            for (beside, bulge) in equation.bulges.iter().enumerate() {
                if !self.lines[joint + beside - 1] {
                    row.push(((joint + beside - 1) * EACH + 2, *bulge));
                }
            }
            let length = self.chord(joint - 1).length().min(self.chord(joint).length());
            system.add(row.slice(), -off, DIRECTION * length * length);
        }
        for unknown in 0..pieces * EACH {
            system.add(&[(unknown, 1.0)], 0.0, if unknown % EACH == 1 { SLIDE } else { CHANGE });
        }
        let change = system.solve()?;
        // Steps in a high norm overshoot.
        let part = 1.0 / f64::from(power - 1);
        self.change(&change, part);
        self.is_sound().then_some(())
    }

    /// What a joint's unknowns add to a row, for a gradient by its place.
    fn joint_terms(&self, joint: usize, gradient: Vec2, row: &mut Terms) {
        if self.is_free(joint) {
            let along = self.along(joint);
            row.push((joint * EACH, along.turned_left().dot(gradient)));
            row.push((joint * EACH + 1, along.dot(gradient)));
        }
    }

    fn change(&mut self, change: &[f64], part: f64) {
        let pieces = self.halves.len();
        let moves: Vec<Vec2> = (0..pieces)
            .map(|joint| {
                if !self.is_free(joint) {
                    return Vec2::ZERO;
                }
                let along = self.along(joint);
                let [off, slide] = [0, 1].map(|unknown| change[joint * EACH + unknown]);
                along.turned_left() * (off * part) + along * (slide * part)
            })
            .collect();
        for piece in 0..pieces {
            if !self.lines[piece] {
                let bulge = change[piece * EACH + 2] * part;
                self.halves[piece] += 4.0 * bulge / self.chord(piece).length();
            }
        }
        for (joint, by) in self.joints.iter_mut().zip(moves) {
            *joint = *joint + by;
        }
    }
}

/// The terms of an equation: unknown and factor. The most are of a joint's equation, three joints and
/// two bulges.
#[derive(Clone, Copy, Default)]
struct Terms {
    terms: [(usize, f64); 8],
    count: usize,
}

impl Terms {
    fn push(&mut self, term: (usize, f64)) {
        self.terms[self.count] = term;
        self.count += 1;
    }

    fn slice(&self) -> &[(usize, f64)] {
        &self.terms[..self.count]
    }
}

/// Normal equations, symmetric: of each row the diagonal and what stands behind it.
struct Band {
    rows: Vec<[f64; BAND]>,
    right: Vec<f64>,
}

impl Band {
    fn new(unknowns: usize) -> Band {
        Band { rows: vec![[0.0; BAND]; unknowns], right: vec![0.0; unknowns] }
    }

    /// Adds an equation with a weight.
    fn add(&mut self, terms: &[(usize, f64)], right: f64, weight: f64) {
        for (one, a) in terms {
            self.right[*one] += weight * a * right;
            for (other, b) in terms.iter().filter(|(other, _)| other >= one) {
                self.rows[*one][other - one] += weight * a * b;
            }
        }
    }

    /// By elimination without exchanges, as for every sum of squares.
    fn solve(mut self) -> Option<Vec<f64>> {
        let count = self.rows.len();
        for row in 0..count {
            let pivot = self.rows[row];
            if !(pivot[0] > 0.0 && pivot[0].is_finite()) {
                return None;
            }
            for shift in 1..BAND.min(count - row) {
                let factor = pivot[shift] / pivot[0];
                for (entry, behind) in self.rows[row + shift].iter_mut().zip(&pivot[shift..]) {
                    *entry -= factor * behind;
                }
                self.right[row + shift] -= factor * self.right[row];
            }
        }
        for row in (0..count).rev() {
            let mut value = self.right[row];
            for shift in 1..BAND.min(count - row) {
                value -= self.rows[row][shift] * self.right[row + shift];
            }
            self.right[row] = value / self.rows[row][0];
        }
        Some(self.right)
    }
}
