//! A chain of lines and arcs, described by what may change: the positions of its joints, and the bulge of each piece.
//!
//! Two arcs are tangent if the angle between their chords is half the sum of the angles of the arcs. Every tangent joint
//! has such an equation.

use crate::{Vec2, math};

use super::band::{BandMatrix, EquationTerms};
use super::flat::{FittedPiece, PlanarPoints, part, shape};

/// The number of unknowns per piece: the moves of its first joint across the path and along it, and the change of its
/// bulge, all in millimetres.
pub(super) const EACH: usize = 3;
/// How much more freely a joint slides along the path than it leaves it.
const SLIDE: f64 = 16.0;
const MAX_STEPS: usize = 8;
/// A piece with a shorter chord has no direction, mm.
const MIN_CHORD_MM: f64 = 1e-9;
/// Directions that differ by less are equal, rad.
const TANGENT: f64 = 1e-11;

/// How a joint may change.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum FittedJoint {
    /// It may move, and its pieces are tangent.
    Free,
    /// It does not move, and its pieces are tangent.
    Pinned,
    /// It does not move, and its pieces need not be tangent.
    Corner,
}

/// The directions in which free joints slide.
pub(super) struct JointDirections(Vec<Option<Vec2>>);

impl JointDirections {
    /// Adds the terms of a joint to an equation, from the gradient with respect to its position.
    pub(super) fn terms(&self, joint: usize, gradient: Vec2, terms: &mut EquationTerms) {
        if let Some(along) = self.0[joint] {
            terms.push(joint * EACH, along.cross(gradient));
            terms.push(joint * EACH + 1, along.dot(gradient));
        }
    }
}

#[derive(Clone, Debug)]
pub(super) struct PieceRow {
    /// The points where pieces begin, and the end of the last piece, mm. The first and the last never move.
    pub(super) joints: Vec<Vec2>,
    pub(super) kinds: Vec<FittedJoint>,
    /// The positions of the joints along the path.
    pub(super) places: Vec<f64>,
    /// Half of the angle of each piece, rad, positive counter-clockwise.
    pub(super) halves: Vec<f64>,
    pub(super) lines: Vec<bool>,
    /// The chain is closed, and its last piece is tangent to the first.
    pub(super) is_closed: bool,
    /// The directions at the start and at the end, if they are prescribed.
    pub(super) directions: [Option<Vec2>; 2],
}

/// The angle from one direction to another, minus the intended one, rad.
fn excess(a: Vec2, b: Vec2, meant: f64) -> f64 {
    let turn = math::atan2(a.cross(b), a.dot(b)) - meant;
    turn - math::TAU * math::round(turn / math::TAU)
}

/// The gradient of the angle of a chord with respect to its end, rad/mm.
fn slope(chord: Vec2) -> Vec2 {
    chord.turned_left() * (1.0 / chord.dot(chord))
}

impl PieceRow {
    /// A chain of these pieces. Those for which `straight` is true stay lines; joints between two lines are corners.
    pub(super) fn of(pieces: &[FittedPiece], straight: impl Fn(&FittedPiece) -> bool) -> PieceRow {
        let lines: Vec<bool> = pieces.iter().map(straight).collect();
        let mut kinds: Vec<FittedJoint> = lines
            .windows(2)
            .map(|pair| if pair[0] && pair[1] { FittedJoint::Corner } else { FittedJoint::Free })
            .collect();
        kinds.insert(0, FittedJoint::Corner);
        kinds.push(FittedJoint::Corner);
        let last = &pieces[pieces.len() - 1];
        let heads = pieces.iter().map(|piece| (piece.ends[0], piece.span[0]));
        let (joints, places) = heads.chain([(last.ends[1], last.span[1])]).unzip();
        let halves = pieces.iter().map(FittedPiece::half).collect();
        PieceRow { joints, kinds, places, halves, lines, is_closed: false, directions: [None; 2] }
    }

    pub(super) fn len(&self) -> usize {
        self.halves.len()
    }

    pub(super) fn chord(&self, piece: usize) -> Vec2 {
        self.joints[piece + 1] - self.joints[piece]
    }

    /// The direction of a piece at its start or its end, with the length of its chord.
    pub(super) fn direction(&self, piece: usize, at_end: bool) -> Vec2 {
        let half = if at_end { self.halves[piece] } else { -self.halves[piece] };
        let (sin, cos) = math::sin_cos(half);
        let chord = self.chord(piece);
        chord * cos + chord.turned_left() * sin
    }

    /// The pieces from one joint to another, with the directions at their ends prescribed. In a closed chain, the
    /// indices of joints may continue past its start.
    pub(super) fn part(&self, from: usize, to: usize) -> PieceRow {
        let count = self.len();
        let is_closed = self.is_closed && from == 0 && to == count;
        let before = match from {
            0 if is_closed => None,
            0 if self.is_closed => Some(self.direction(count - 1, true)),
            0 => self.directions[0],
            _ => (self.kinds[from] != FittedJoint::Corner).then(|| self.direction(from - 1, true)),
        };
        let following = match to {
            _ if is_closed => None,
            _ if self.is_closed && to >= count => Some(self.direction(to - count, false)),
            _ if to == count => self.directions[1],
            _ => (self.kinds[to] != FittedJoint::Corner).then(|| self.direction(to, false)),
        };
        // The pieces up to the end of the chain, and those after its start.
        let (once, again) = (from..to.min(count), 0..to.saturating_sub(count));
        let pieces = || once.clone().chain(again.clone());
        let joints = || from..=to;
        let joint = |at: usize| if at > count { at - count } else { at };
        PieceRow {
            joints: joints().map(|at| self.joints[joint(at)]).collect(),
            kinds: joints().map(|at| self.kinds[joint(at)]).collect(),
            places: joints().map(|at| self.places[joint(at)] + self.round(at)).collect(),
            halves: pieces().map(|at| self.halves[at]).collect(),
            lines: pieces().map(|at| self.lines[at]).collect(),
            is_closed,
            directions: [before, following],
        }
    }

    /// By how much the position of a joint is larger if its index continues past the start of a closed chain.
    fn round(&self, joint: usize) -> f64 {
        if joint > self.len() { self.places[self.len()] - self.places[0] } else { 0.0 }
    }

    /// The chain with positions reduced by `by`.
    pub(super) fn moved_back(mut self, by: f64) -> PieceRow {
        self.places.iter_mut().for_each(|place| *place -= by);
        self
    }

    /// Replaces the pieces from one joint to another by another chain with the same ends.
    pub(super) fn replace(&mut self, from: usize, to: usize, new: &PieceRow) {
        let inner = 1..new.len();
        self.joints.splice(from + 1..to, new.joints[inner.clone()].iter().copied());
        self.kinds.splice(from + 1..to, new.kinds[inner.clone()].iter().copied());
        self.places.splice(from + 1..to, new.places[inner].iter().copied());
        self.halves.splice(from..to, new.halves.iter().copied());
        self.lines.splice(from..to, new.lines.iter().copied());
    }

    pub(super) fn is_free(&self, joint: usize) -> bool {
        joint > 0 && joint < self.len() && self.kinds[joint] == FittedJoint::Free
    }

    /// The approximate direction of the path at every free joint.
    pub(super) fn along(&self) -> JointDirections {
        let unit = |piece: usize| self.chord(piece).normalized().unwrap_or(Vec2::ZERO);
        let units: Vec<Vec2> = (0..self.len()).map(unit).collect();
        let at = |joint: usize| {
            let along = || (units[joint - 1] + units[joint]).normalized().unwrap_or(Vec2::ZERO);
            self.is_free(joint).then(along)
        };
        JointDirections((0..=self.len()).map(at).collect())
    }

    /// The equation of a joint, and by how much it is not satisfied; `None` if it has none. The equation between the
    /// ends of a closed chain is that of the first joint.
    pub(super) fn equation(
        &self,
        joint: usize,
        along: &JointDirections,
    ) -> Option<(EquationTerms, f64)> {
        let count = self.len();
        let mut terms = EquationTerms::default();
        let (before, following) = match joint {
            0 if self.is_closed => (Some(count - 1), Some(0)),
            0 => (None, Some(0)),
            _ if joint == count => (Some(count - 1), None),
            _ if self.kinds[joint] == FittedJoint::Corner => return None,
            _ => (Some(joint - 1), Some(joint)),
        };
        // At an end one of the directions is prescribed.
        let prescribed = self.directions[usize::from(joint == count)];
        let direction =
            |piece: Option<usize>| piece.map_or(prescribed, |piece| Some(self.chord(piece)));
        let (a, b) = (direction(before)?, direction(following)?);
        let (mut slopes, mut meant) = (Vec2::ZERO, 0.0);
        // The direction of a piece depends on its chord, and so on its other joint, and on its bulge.
        for (piece, other) in
            [before.map(|at| (at, at)), following.map(|at| (at, at + 1))].into_iter().flatten()
        {
            let slope = slope(self.chord(piece));
            along.terms(other, slope, &mut terms);
            if !self.lines[piece] {
                terms.push(piece * EACH + 2, -4.0 / self.chord(piece).length());
            }
            slopes = slopes + slope;
            meant += self.halves[piece];
        }
        along.terms(joint, -slopes, &mut terms);
        Some((terms, excess(a, b, meant)))
    }

    /// Moves joints and changes bulges; `None` if the result is not a valid chain.
    pub(super) fn change(&mut self, change: &[f64]) -> Option<()> {
        let along = self.along();
        let moves: Vec<Vec2> = (1..self.len())
            .map(|joint| {
                let Some(along) = along.0[joint] else { return Vec2::ZERO };
                // A joint must not pass another one.
                let most = 0.3 * self.chord(joint - 1).length().min(self.chord(joint).length());
                let slide = change[joint * EACH + 1].clamp(-most, most);
                along.turned_left() * change[joint * EACH] + along * slide
            })
            .collect();
        for piece in 0..self.len() {
            if !self.lines[piece] {
                self.halves[piece] += 4.0 * change[piece * EACH + 2] / self.chord(piece).length();
            }
        }
        for (joint, by) in self.joints[1..].iter_mut().zip(moves) {
            *joint = *joint + by;
        }
        self.is_sound().then_some(())
    }

    /// Whether every piece has a length, and so a direction.
    pub(super) fn is_sound(&self) -> bool {
        let has_length = |piece: usize| {
            let length = self.chord(piece).length();
            length > MIN_CHORD_MM && length.is_finite()
        };
        self.halves.iter().all(|half| half.abs() < 0.95 * math::PI)
            && (0..self.len()).all(has_length)
    }

    /// Makes the chain tangent with the smallest change, by Newton's method; `None` if it does not converge.
    pub(super) fn make_tangent(&mut self) -> Option<()> {
        let mut last = f64::INFINITY;
        for _ in 0..MAX_STEPS {
            let along = self.along();
            let equations: Vec<_> =
                (0..=self.len()).map(|joint| self.equation(joint, &along)).collect();
            let off = |equation: &Option<(EquationTerms, f64)>| {
                equation.as_ref().map_or(0.0, |it| it.1.abs())
            };
            let largest = equations.iter().map(off).fold(0.0, f64::max);
            if largest <= TANGENT {
                return Some(());
            }
            if !(largest < last * 4.0 && largest < 1.0) {
                return None;
            }
            last = largest;
            let change = self.least_change(&equations)?;
            self.change(&change)?;
        }
        None
    }

    /// The smallest change that satisfies the linearized equations: W·Aᵀ·λ with A·W·Aᵀ·λ = −off.
    fn least_change(&self, equations: &[Option<(EquationTerms, f64)>]) -> Option<Vec<f64>> {
        let weight = |unknown: usize| if unknown % EACH == 1 { SLIDE } else { 1.0 };
        // The equation that closes a chain is outside the band.
        let closing = equations[0].as_ref().filter(|_| self.is_closed);
        let inner =
            |joint: usize| equations[joint].as_ref().filter(|_| joint > 0 || closing.is_none());
        let count = equations.len();
        let mut band = BandMatrix::<3>::new(count);
        for (joint, row) in band.rows.iter_mut().enumerate() {
            let Some((terms, _)) = inner(joint) else {
                row[0] = 1.0;
                continue;
            };
            for (shift, entry) in row.iter_mut().enumerate().take(count - joint) {
                if let Some((other, _)) = inner(joint + shift) {
                    *entry = terms.product(other, weight);
                }
            }
        }
        let right = (0..count).map(|joint| inner(joint).map_or(0.0, |(_, off)| -off)).collect();
        let factored = band.factored()?;
        let mut factors = factored.solve(right);
        if let Some((terms, off)) = closing {
            let adjacent: Vec<f64> = (0..count)
                .map(|joint| inner(joint).map_or(0.0, |(other, _)| terms.product(other, weight)))
                .collect();
            let solved = factored.solve(adjacent.clone());
            let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
            let pivot = terms.product(terms, weight) - dot(&adjacent, &solved);
            let factor = (-off - dot(&adjacent, &factors)) / pivot;
            for (entry, by) in factors.iter_mut().zip(&solved) {
                *entry -= factor * by;
            }
            factors[0] = factor;
        }
        let mut change = vec![0.0; self.len() * EACH];
        for (equation, factor) in equations.iter().zip(&factors) {
            for (unknown, value) in equation.iter().flat_map(|(terms, _)| terms.iter()) {
                change[unknown] += weight(unknown) * value * factor;
            }
        }
        Some(change)
    }

    /// Replaces arcs with a radius above `max_radius`, mm, by lines; true if there were any.
    pub(super) fn flatten(&mut self, max_radius: f64) -> bool {
        let mut is_any = false;
        for piece in 0..self.len() {
            if self.lines[piece] {
                continue;
            }
            let sin = math::sin_cos(self.halves[piece]).0.abs();
            if self.chord(piece).length() > 2.0 * max_radius * sin {
                (self.lines[piece], self.halves[piece]) = (true, 0.0);
                is_any = true;
            }
        }
        is_any
    }

    /// Finds the positions of the joints along the path again; `None` if they are not in order.
    pub(super) fn settle(&mut self, flat: &PlanarPoints) -> Option<()> {
        for (joint, along) in self.along().0.iter().enumerate() {
            if let Some(along) = *along {
                self.places[joint] = flat.foot(self.places[joint], self.joints[joint], along)?;
            }
        }
        self.places.is_sorted().then_some(())
    }

    /// A piece as a curve, without its deviation.
    pub(super) fn piece(&self, flat: &PlanarPoints, index: usize) -> FittedPiece {
        let places = [index, index + 1].map(|joint| self.places[joint]);
        let ends = [index, index + 1].map(|joint| self.joints[joint]);
        let half = if self.lines[index] { 0.0 } else { self.halves[index] };
        FittedPiece {
            ends,
            heights: places.map(|place| flat.point(place).1),
            shape: shape(ends, half),
            span: places,
            deviation: f64::NAN,
        }
    }

    /// Moves the ends of the chain to two points of the path.
    pub(super) fn end_at(&mut self, flat: &PlanarPoints, [from, to]: [usize; 2]) {
        let last = self.len();
        self.is_closed = false;
        for (joint, point) in [(0, from), (last, to)] {
            self.joints[joint] = flat.at[point];
            self.places[joint] = point as f64;
            self.kinds[joint] = FittedJoint::Corner;
        }
        for piece in [0, last - 1] {
            let [from, to] = [piece, piece + 1].map(|joint| flat.length_at(self.places[joint]));
            let middle = flat.point(flat.place(0.5 * (from + to))).0;
            if !self.lines[piece] {
                self.halves[piece] =
                    half_through(self.joints[piece], middle, self.joints[piece + 1]);
            }
        }
    }

    /// Replaces the arcs between two joints by `count` arcs, each through three points of the path, with lengths
    /// according to `rule`.
    pub(super) fn spread(
        &mut self,
        flat: &PlanarPoints,
        [from, to]: [usize; 2],
        count: usize,
        by: SpreadRule,
    ) {
        let ends = [from, to].map(|joint| flat.length_at(self.places[joint]));
        let table = match by {
            SpreadRule::Joints => {
                let lengths = self.places[from..=to].iter().map(|place| flat.length_at(*place));
                lengths.enumerate().map(|(joint, length)| (joint as f64, length)).collect()
            }
            SpreadRule::Density(density) => density.table(ends),
        };
        let whole = table[table.len() - 1].0;
        let at = |joint: f64| {
            let level = whole * joint / count as f64;
            let following =
                table.partition_point(|(there, _)| *there < level).clamp(1, table.len() - 1);
            let [(a, from), (b, to)] = [table[following - 1], table[following]];
            flat.place(from + part(level, a, b) * (to - from))
        };
        let inner = 1..count;
        let places: Vec<f64> = inner.clone().map(|joint| at(joint as f64)).collect();
        self.joints.splice(from + 1..to, places.iter().map(|place| flat.point(*place).0));
        self.places.splice(from + 1..to, places);
        self.kinds.splice(from + 1..to, inner.map(|_| FittedJoint::Free));
        self.lines.splice(from..to, (0..count).map(|_| false));
        let halves: Vec<f64> = (0..count)
            .map(|piece| {
                let middle = flat.point(at(piece as f64 + 0.5)).0;
                half_through(self.joints[from + piece], middle, self.joints[from + piece + 1])
            })
            .collect();
        self.halves.splice(from..to, halves);
    }
}

/// How the lengths of new arcs are chosen.
#[derive(Clone, Copy)]
pub(super) enum SpreadRule<'a> {
    /// In proportion to the lengths of the replaced pieces.
    Joints,
    /// By the number of arcs that the path needs at each point.
    Density(&'a ArcDensity),
}

/// How many arcs the path needs at each point: the lengths along the path up to the joints of a chain of far shorter
/// arcs, mm.
pub(super) struct ArcDensity(pub(super) Vec<f64>);

impl ArcDensity {
    pub(super) fn go_round_twice(&mut self) {
        let round = self.0[self.0.len() - 1];
        let again: Vec<f64> = self.0[1..].iter().map(|length| length + round).collect();
        self.0.extend(again);
    }

    /// The number of arcs up to each length, between two lengths.
    fn table(&self, [start, end]: [f64; 2]) -> Vec<(f64, f64)> {
        let rank = |length: f64| {
            let following =
                self.0.partition_point(|joint| *joint < length).clamp(1, self.0.len() - 1);
            let (a, b) = (self.0[following - 1], self.0[following]);
            (following - 1) as f64 + part(length, a, b)
        };
        let first = self.0.partition_point(|length| *length <= start);
        let inner = self.0[first..].iter().copied().take_while(|length| *length < end);
        core::iter::once(start)
            .chain(inner)
            .chain([end])
            .map(|length| (rank(length) - rank(start), length))
            .collect()
    }
}

/// Half of the angle of the arc from one point through another to a third, rad.
fn half_through(from: Vec2, through: Vec2, to: Vec2) -> f64 {
    let (v, w) = (through - from, through - to);
    math::atan2(-(to - from).cross(v), -v.dot(w))
}
