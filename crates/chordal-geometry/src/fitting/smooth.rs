//! Turns pieces through the points into tangent pieces, as few as possible.
//!
//! The chain of pieces, each as long as possible, is relaxed into a strip as wide as the tolerance. Where it does not
//! fit, one piece is added, the joints around it are redistributed, and it is relaxed again. Where the deviations leave
//! room, one piece is removed. Pieces that cannot be tangent are not changed.

use crate::{Vec2, math};

use super::deviation::deviation;
use super::flat::{FittedPiece, PlanarPoints};
use super::reach::PieceFinder;
use super::relax::StripRow;
use super::row::{ArcDensity, FittedJoint, PieceRow, SpreadRule};
use super::{FitMeasure, FitOptions};

/// The number of bisection steps for the tolerance when the lengths of pieces are balanced.
const TOLERANCE_HALVINGS: usize = 5;
/// The lengths of more pieces are not balanced.
const MAX_HALVED_PIECES: usize = 100;
/// Half the width of the strip for relaxing, as a fraction of the tolerance: points between the checked ones may be
/// farther off.
const STRIP: f64 = 0.985;
/// How often the strip is made narrower if they are.
const NARROWER: usize = 3;
/// The deviation of a chain farther out of the strip than this fraction of the tolerance is not computed.
const HOPELESS: f64 = 0.02;
/// The number of pieces of a new chain that are relaxed together.
const BLOCK: usize = 64;
/// How many of them are relaxed again with the next ones.
const OVERLAP: usize = 16;
/// The number of pieces on either side of a point whose joints are redistributed.
const SPREAD: usize = 8;
/// The number of pieces next to those on either side that only adapt.
const GIVE: usize = 4;
/// The largest number of pieces that are redistributed together.
const WINDOW: usize = 24;
/// The largest number of rounds in which pieces are added.
const ATTEMPTS: usize = 8;
/// The largest number of rounds in which a chain is cut where it cannot be tangent.
const CUTS: usize = 4;
/// The fraction of the tolerance for the chain of short arcs that shows where arcs are needed.
const FINE_TOLERANCE_SHARE: f64 = 0.05;
/// Lines with a deviation below this fraction of the tolerance stay lines.
const STRAIGHT_TOLERANCE_SHARE: f64 = 0.1001;

/// The conditions at the ends of a chain.
#[derive(Clone, Copy, Default)]
pub(super) struct RowEnds {
    /// The chain is closed and tangent there.
    pub(super) is_closed: bool,
    /// The prescribed directions at the start and at the end.
    pub(super) directions: [Option<Vec2>; 2],
}

/// Fits the points of a section.
pub(super) struct SectionFit<'a> {
    flat: &'a PlanarPoints,
    options: &'a FitOptions,
}

/// A chain with the deviations of its pieces, mm; NaN where not computed yet.
struct MeasuredRow {
    row: PieceRow,
    deviations: Vec<f64>,
}

/// A part of a chain that was relaxed.
struct RelaxedRow {
    row: PieceRow,
    deviations: Vec<f64>,
    /// By how much its deviation exceeds the tolerance, mm.
    excess: f64,
}

impl MeasuredRow {
    /// Replaces the pieces between two joints, whose indices may continue past the start of a closed chain.
    fn replace(&mut self, [from, to]: [usize; 2], new: &RelaxedRow) {
        let count = self.row.len();
        if to <= count {
            self.row.replace(from, to, &new.row);
            self.deviations.splice(from..to, new.deviations.iter().copied());
            return;
        }
        let whole = [0, new.row.len()];
        let seam = (1..whole[1]).find(|joint| new.row.kinds[*joint] == FittedJoint::Pinned);
        let seam = seam.unwrap_or(whole[1]);
        self.row.replace(from, count, &new.row.part(whole[0], seam));
        self.deviations.splice(from.., new.deviations[..seam].iter().copied());
        let turn = new.row.places[seam];
        self.row.replace(0, to - count, &new.row.part(seam, whole[1]).moved_back(turn));
        self.deviations.splice(..to - count, new.deviations[seam..].iter().copied());
    }
}

impl SectionFit<'_> {
    pub(super) fn of<'a>(flat: &'a PlanarPoints, options: &'a FitOptions) -> SectionFit<'a> {
        SectionFit { flat, options }
    }

    pub(super) fn row(&self, ends: RowEnds) -> Vec<FittedPiece> {
        let range = [0, self.flat.last()];
        let longest = self.chain(range, self.options.tolerance);
        let is_single = longest.len() < 2 && ends.directions == [None; 2];
        if is_single || longest.iter().all(|piece| self.is_straight(piece)) {
            return longest;
        }
        let even = self.even(&longest, range);
        if !self.options.tangent {
            return even;
        }
        let mut row = PieceRow::of(&even, |piece| self.is_straight(piece));
        (row.is_closed, row.directions) = (ends.is_closed, ends.directions);
        if row.is_closed {
            let last = row.len();
            (row.kinds[0], row.kinds[last]) = (FittedJoint::Pinned, FittedJoint::Pinned);
        }
        let mut measured = MeasuredRow { deviations: vec![f64::NAN; row.len()], row };
        self.relax_all(&mut measured);
        self.finish(measured, &self.density(ends.is_closed), CUTS)
    }

    fn chain(&self, range: [usize; 2], tolerance: f64) -> Vec<FittedPiece> {
        let FitOptions { measure, max_radius, .. } = *self.options;
        PieceFinder { flat: self.flat, tolerance, measure, max_radius }.chain(range)
    }

    fn density(&self, is_closed: bool) -> ArcDensity {
        let last = self.flat.last();
        let fine = self.chain([0, last], FINE_TOLERANCE_SHARE * self.options.tolerance);
        let heads = fine.iter().map(|piece| piece.span[0] as usize).chain([last]);
        let mut density = ArcDensity(heads.map(|head| self.flat.along[head]).collect());
        if is_closed {
            density.go_round_twice();
        }
        density
    }

    /// The same number of pieces with the smallest tolerance that this number allows, so that the last piece is not
    /// short and the joints have room to move.
    fn even(&self, longest: &[FittedPiece], range: [usize; 2]) -> Vec<FittedPiece> {
        let mut best = longest.to_vec();
        if longest.len() > MAX_HALVED_PIECES {
            return best;
        }
        let (mut low, mut high) = (0.0, self.options.tolerance);
        for _ in 0..TOLERANCE_HALVINGS {
            let middle = 0.5 * (low + high);
            let row = self.chain(range, middle);
            if row.len() <= best.len() {
                (best, high) = (row, middle);
            } else {
                low = middle;
            }
        }
        best
    }

    fn is_straight(&self, piece: &FittedPiece) -> bool {
        let is_chord = piece.span[1] - piece.span[0] <= 1.0;
        piece.is_line()
            && (piece.deviation <= STRAIGHT_TOLERANCE_SHARE * self.options.tolerance
                || is_chord && self.flat.stiff[piece.span[0] as usize] == piece.span[0] as usize)
    }

    /// The chain relaxed into the tolerance, or as close to it as possible.
    fn relaxed(&self, row: &PieceRow) -> Option<RelaxedRow> {
        let FitOptions { tolerance, measure, .. } = *self.options;
        let mut strip = StripRow { flat: self.flat, width: STRIP * tolerance };
        let (mut row, mut outside) = strip.relax(row, true)?;
        if row.flatten(self.options.max_radius) {
            (row, outside) = strip.relax(&row, false)?;
        }
        for _ in 0..NARROWER {
            if outside > HOPELESS * tolerance {
                break;
            }
            let deviations: Vec<f64> = (0..row.len())
                .map(|at| self.measured(&row.piece(self.flat, at), measure))
                .collect();
            let worst = deviations.iter().copied().fold(0.0, f64::max);
            if worst <= tolerance {
                return Some(RelaxedRow { row, deviations, excess: 0.0 });
            }
            outside = worst - tolerance;
            if outside > 0.1 * tolerance {
                break;
            }
            strip.width *= 0.999 * tolerance / worst;
            (row, outside) = strip.relax(&row, false)?;
        }
        let deviations = vec![f64::NAN; row.len()];
        Some(RelaxedRow { row, deviations, excess: outside.max(f64::MIN_POSITIVE) })
    }

    /// Adds and removes pieces until the chain is within the tolerance with few pieces; cuts it where it cannot be
    /// tangent.
    fn finish(
        &self,
        mut measured: MeasuredRow,
        density: &ArcDensity,
        cuts: usize,
    ) -> Vec<FittedPiece> {
        let mut bad = self.bad(&mut measured);
        for _ in 0..ATTEMPTS {
            if bad.is_empty() {
                break;
            }
            // From the end, so that earlier indices stay valid.
            for [from, to] in self.windows(&mut measured, &bad).into_iter().rev() {
                self.widen(&mut measured, [from, to], density);
            }
            bad = self.bad(&mut measured);
        }
        if !bad.is_empty() {
            return self.cut(&measured.row, &bad, density, cuts);
        }
        self.thin(&mut measured, density);
        self.pieces(&measured)
    }

    /// Relaxes a new chain in overlapping blocks.
    fn relax_all(&self, measured: &mut MeasuredRow) {
        let count = measured.row.len();
        let mut from = 0;
        loop {
            let to = if from + BLOCK + OVERLAP >= count { count } else { from + BLOCK };
            let mut part = measured.row.part(from, to);
            if to < count {
                // The pieces after it are not tangent yet.
                part.directions[1] = None;
                if from == 0 && measured.row.is_closed {
                    part.directions[0] = None;
                }
            }
            if let Some(new) = self.relaxed(&part) {
                measured.replace([from, to], &new);
            }
            if to == count {
                return;
            }
            from = to - OVERLAP;
        }
    }

    /// Computes missing deviations, and returns the pieces that are too far off or not tangent.
    fn bad(&self, measured: &mut MeasuredRow) -> Vec<usize> {
        let FitOptions { tolerance, measure, .. } = *self.options;
        let row = &measured.row;
        let new: Vec<usize> =
            (0..row.len()).filter(|at| measured.deviations[*at].is_nan()).collect();
        for at in new {
            let piece = row.piece(self.flat, at);
            measured.deviations[at] = self.measured(&piece, measure);
        }
        let along = row.along();
        let is_met = |joint: usize| match row.equation(joint, &along) {
            Some((_, off)) => off.abs() <= 1e-9,
            None => true,
        };
        let closing = row.is_closed && !is_met(0);
        let is_kinked = |piece: usize| {
            let is_last = piece + 1 == row.len();
            !is_met(piece) || !is_met(piece + 1) || is_last && closing
        };
        (0..row.len())
            .filter(|piece| measured.deviations[*piece] > tolerance || is_kinked(*piece))
            .collect()
    }

    fn measured(&self, piece: &FittedPiece, measure: FitMeasure) -> f64 {
        let length = piece.chord().length();
        let sin = math::sin_cos(piece.half()).0.abs();
        let is_flat = !piece.is_line() && length > 2.0 * self.options.max_radius * sin;
        let measured = deviation(self.flat, piece, measure, f64::INFINITY);
        measured.filter(|_| !is_flat).unwrap_or(f64::INFINITY)
    }

    /// The ranges of arcs around the pieces that are too far off.
    fn windows(&self, measured: &mut MeasuredRow, bad: &[usize]) -> Vec<[usize; 2]> {
        let row = &mut measured.row;
        for piece in bad {
            // A line that does not fit may become an arc.
            let is_chord = row.places[piece + 1] - row.places[*piece] <= 1.0;
            if row.lines[*piece] && !is_chord {
                row.lines[*piece] = false;
            }
        }
        let mut windows: Vec<[usize; 2]> = Vec::new();
        for piece in bad.iter().copied() {
            // This piece is next to a line that has to stay.
            let about = if row.lines[piece] {
                [piece.checked_sub(1), (piece + 1 < row.len()).then_some(piece + 1)]
            } else {
                [Some(piece), None]
            };
            for piece in about.into_iter().flatten().filter(|piece| !row.lines[*piece]) {
                let start = windows.last().map_or(0, |[_, end]| *end);
                if piece < start {
                    continue;
                }
                let [mut from, mut to] = [piece, piece + 1];
                while from > start && piece - from < SPREAD && is_inner(row, from) {
                    from -= 1;
                }
                while to < row.len() && to - piece <= SPREAD && is_inner(row, to) {
                    to += 1;
                }
                match windows.last_mut() {
                    Some(last)
                        if from < last[1] + SPREAD
                            && to - last[0] <= WINDOW
                            && runs(row, last[0], to) =>
                    {
                        last[1] = to
                    }
                    _ => windows.push([from, to]),
                }
            }
        }
        windows
    }

    /// Adds one piece between two joints.
    fn widen(&self, measured: &mut MeasuredRow, window: [usize; 2], density: &ArcDensity) {
        let count = window[1] - window[0] + 1;
        let chords = measured.row.places[window[1]] - measured.row.places[window[0]];
        // The chords themselves would be almost as few.
        if 3.0 * count as f64 > chords {
            return;
        }
        if let Some((part, range)) = self.spread(&measured.row, window, count, density) {
            measured.replace(range, &part);
        }
    }

    /// The part of a chain around the pieces between two joints with another number of pieces: the better of the results
    /// from two initial distributions.
    fn spread(
        &self,
        row: &PieceRow,
        [from, to]: [usize; 2],
        count: usize,
        density: &ArcDensity,
    ) -> Option<(RelaxedRow, [usize; 2])> {
        let [start, end] = about(row, from, to);
        let part = row.part(start, end);
        let lead = (from + row.len() - start) % row.len();
        let mut best: Option<RelaxedRow> = None;
        for by in [SpreadRule::Joints, SpreadRule::Density(density)] {
            let mut part = part.clone();
            part.spread(self.flat, [lead, lead + to - from], count, by);
            if let Some(part) = self.relaxed(&part)
                && best.as_ref().is_none_or(|best| part.excess < best.excess)
            {
                let is_done = part.excess <= 0.0;
                best = Some(part);
                if is_done {
                    break;
                }
            }
        }
        best.map(|part| (part, [start, end]))
    }

    /// Removes pieces where the deviations leave room.
    fn thin(&self, measured: &mut MeasuredRow, density: &ArcDensity) {
        let tolerance = self.options.tolerance;
        let mut from = 0;
        while from < measured.row.len() {
            let row = &measured.row;
            let mut to = from + 1;
            while to < row.len() && to - from < WINDOW && is_inner(row, to) {
                to += 1;
            }
            // Deviations grow with the third power of the lengths.
            let room: f64 = measured.deviations[from..to]
                .iter()
                .map(|off| 1.0 - (off / tolerance).cbrt())
                .sum();
            let is_whole = to - from == row.len();
            let mut is_thinner = false;
            if to - from > 1
                && !row.lines[from]
                && (room > 0.6 || is_whole)
                && let Some((part, range)) = self.spread(row, [from, to], to - from - 1, density)
                && part.excess <= 0.0
            {
                measured.replace(range, &part);
                is_thinner = true;
            }
            if !is_thinner {
                from = if to - from >= WINDOW { from + WINDOW / 2 } else { to };
            }
        }
    }

    fn pieces(&self, measured: &MeasuredRow) -> Vec<FittedPiece> {
        let with = |at: usize| FittedPiece {
            deviation: measured.deviations[at],
            ..measured.row.piece(self.flat, at)
        };
        (0..measured.row.len()).map(with).collect()
    }

    /// Cuts a chain at the points next to pieces that cannot be tangent, where the original pieces stay.
    fn cut(
        &self,
        row: &PieceRow,
        bad: &[usize],
        density: &ArcDensity,
        cuts: usize,
    ) -> Vec<FittedPiece> {
        let ends = [row.places[0] as usize, row.places[row.len()] as usize];
        let mut gaps: Vec<[usize; 2]> = Vec::new();
        for piece in bad {
            let from = row.places[*piece] as usize;
            let to = math::ceil(row.places[piece + 1]) as usize;
            match gaps.last_mut() {
                Some(last) if from <= last[1] => last[1] = last[1].max(to),
                _ => gaps.push([from, to]),
            }
        }
        if cuts == 0 {
            gaps = vec![ends];
        }
        let mut pieces: Vec<FittedPiece> = Vec::new();
        let mut at = ends[0];
        for [from, to] in gaps.into_iter().chain([[ends[1]; 2]]) {
            let directions = [
                row.directions[0].filter(|_| at == ends[0]),
                match pieces.first() {
                    Some(first) if row.is_closed => Some(first.direction()),
                    _ => row.directions[1],
                }
                .filter(|_| from == ends[1]),
            ];
            pieces.extend(self.between(row, [at, from], directions, density, cuts));
            pieces.extend(self.chain([from, to], self.options.tolerance));
            at = to;
        }
        pieces
    }

    /// The part of a chain between two points of the path, which become its ends.
    fn between(
        &self,
        row: &PieceRow,
        range: [usize; 2],
        directions: [Option<Vec2>; 2],
        density: &ArcDensity,
        cuts: usize,
    ) -> Vec<FittedPiece> {
        let [first, last] = range.map(|point| point as f64);
        // A piece has at least one chord.
        let from = row.places.partition_point(|place| *place < first + 1.0);
        let to = row.places.partition_point(|place| *place <= last - 1.0);
        if from >= to {
            return self.chain(range, self.options.tolerance);
        }
        let mut part = row.part(from - 1, to);
        part.directions = directions;
        part.end_at(self.flat, range);
        let count = part.len();
        let mut measured = MeasuredRow { deviations: vec![f64::NAN; count], row: part };
        let near = SPREAD.min(count);
        for [from, to] in [[0, near], [count - near, count]] {
            if let Some(new) = self.relaxed(&measured.row.part(from, to)) {
                measured.replace([from, to], &new);
            }
        }
        self.finish(measured, density, cuts - 1)
    }
}

/// The range of joints whose pieces adapt to those between two joints; indices may continue past the start of a closed
/// chain.
fn about(row: &PieceRow, from: usize, to: usize) -> [usize; 2] {
    let count = row.len();
    if !row.is_closed {
        [from.saturating_sub(GIVE), (to + GIVE).min(count)]
    } else if to - from + 2 * GIVE >= count {
        [0, count]
    } else {
        let start = (from + count - GIVE) % count;
        [start, start + to - from + 2 * GIVE]
    }
}

/// Whether a joint is between arcs and may move.
fn is_inner(row: &PieceRow, joint: usize) -> bool {
    row.kinds[joint] == FittedJoint::Free && !row.lines[joint - 1] && !row.lines[joint]
}

/// Whether all pieces between two joints are arcs whose joints may move.
fn runs(row: &PieceRow, from: usize, to: usize) -> bool {
    (from + 1..to).all(|joint| is_inner(row, joint))
}
