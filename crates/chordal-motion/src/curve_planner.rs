//! Moves from rest to rest as smooth curves between corners, each with one velocity profile. Arcs are cut
//! into chords far within the tolerance first.

use std::ops::Range;

use chordal_geometry::{AXES, Curve, ParamCurve};

mod candidates;
mod chain;
mod corner_overlap;

use crate::AxisValues;
use crate::corner_blend::{EXACT_TOLERANCE, OverlapLimits};
use crate::curve_fit::{ChordPath, SmoothCurve, ToleranceMeasure};
use crate::limits::KinematicLimits;
use crate::move_request::{CornerMode, MoveRequest};
use crate::path_limits::AxisArrays;
use crate::piece::{AxisJet, PathPiece, SIXTH, ahead};
use crate::profile_solver::SolverWork;
use crate::time_bound::{JerkReserve, PathRun};
use crate::trajectory::PlannedTrajectory;
use crate::tuning::TUNING;
use candidates::{CandidateSearch, SolvedCurve};
pub(crate) use chain::ChainLink;

/// Directions that differ by less go on in one line.
const EQUAL_DIRECTION: f64 = 1e-9;
/// A piece that bends by less, in tolerances, and turns by less, in rad, is a line. The direction has a step of such
/// a turn at its ends: at 500 mm/s, seen through setpoints at 4 kHz, a millionth of a jerk of 1e5 mm/s³.
const MAX_LINE_BEND_TOLERANCES: f64 = 1e-7;
const MAX_LINE_TURN_RAD: f64 = 1e-11;
/// A piece is not divided nearer to its ends, as a share of its length.
const MIN_PART_SHARE: f64 = 0.1;

/// The joints at which runs end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum JointFilter {
    Corners,
    /// These, and what turns by less.
    Bends,
}

/// A move of a run.
#[derive(Clone, Copy, Debug)]
struct RunPart {
    /// The number of its move.
    index: usize,
    /// σ where it ends, from the start of the run.
    end: f64,
}

/// How moves are planned that are no curve: each corner by itself.
pub(crate) trait CornerStrategy {
    /// Appends the trajectories of some moves from rest to rest, with what their ends overlap.
    fn plan(
        &mut self,
        moves: &[MoveRequest],
        overlaps: [Option<OverlapLimits>; 2],
        out: &mut Vec<PlannedTrajectory>,
    );

    /// Whether a curve that takes so long, and about so long without jerk, is quicker in any case.
    fn is_quick(&self, moves: &[MoveRequest], time_s: f64, least_s: f64) -> bool;
}

/// Plans moves from rest to rest; keeps its memory.
#[derive(Debug, Default)]
pub(crate) struct CurvePlanner {
    /// The ends of all chords, and their lengths.
    places: Vec<AxisValues>,
    lengths: Vec<f64>,
    /// The number of the move of each chord, and of the first chord of each move.
    owners: Vec<u32>,
    firsts: Vec<usize>,
    /// The chords at which runs begin, and one past the last.
    corners: Vec<usize>,
    /// Chords and corners are those of the moves that are planned next.
    is_cut: bool,
    chords: ChordPath,
    parts: Vec<RunPart>,
    quickest: CandidateSearch,
}

impl CurvePlanner {
    /// The number of the last move that begins at a corner; without one of the move in the second half that
    /// begins at the sharpest joint.
    pub fn last_corner(&mut self, moves: &[MoveRequest]) -> Option<usize> {
        if !self.cut(moves) {
            return None;
        }
        self.corners = self.corners_of(moves, 0..moves.len(), JointFilter::Corners);
        let last = *self.corners[..self.corners.len() - 1].last()?;
        if last > 0 {
            return Some(self.owners[last] as usize);
        }
        let half = moves.len() / 2 + 1..moves.len();
        let cosine = |index: &usize| self.turn(moves, *index).map_or(-1.0, |(cosine, _)| cosine);
        half.min_by(|a, b| cosine(a).total_cmp(&cosine(b)))
    }

    /// Keeps the chords and corners of the moves before one of those that were looked at last, for the next
    /// plan: it is the plan of these moves.
    pub fn keep(&mut self, moves: usize) {
        let chords = self.firsts[moves];
        self.places.truncate(chords + 1);
        self.lengths.truncate(chords);
        self.owners.truncate(chords);
        self.firsts.truncate(moves);
        self.corners.retain(|corner| *corner < chords);
        self.corners.push(chords);
        self.is_cut = true;
    }

    /// What the profiles of all plans took.
    pub fn work(&self) -> SolverWork {
        self.quickest.work()
    }

    /// The next plan is of other moves than those kept.
    pub fn forget(&mut self) {
        self.is_cut = false;
    }

    /// Cuts all moves into chords; false when there are too many.
    fn cut(&mut self, moves: &[MoveRequest]) -> bool {
        let error = TUNING.curves.arc_chord_share * tolerance_of(moves);
        self.places.clear();
        self.lengths.clear();
        self.owners.clear();
        self.firsts.clear();
        self.places.extend(moves.first().map(MoveRequest::from));
        for (index, motion) in moves.iter().enumerate() {
            let length = motion.length();
            self.firsts.push(self.owners.len());
            let count = match motion.curve {
                Curve::Line(_) => 1.0,
                _ => (length * (motion.curve.max_curvature() / (8.0 * error)).sqrt()).ceil(),
            };
            if count.is_nan()
                || count >= (TUNING.curves.max_group_chords - self.owners.len()) as f64
            {
                return false;
            }
            let count = count.max(1.0) as u32;
            for chord in 1..count {
                let share = f64::from(chord) / f64::from(count);
                self.places.push(motion.at(share));
            }
            self.places.push(motion.to());
            let each = (length / f64::from(count), index as u32);
            self.lengths.extend((0..count).map(|_| each.0));
            self.owners.extend((0..count).map(|_| each.1));
        }
        true
    }

    /// The chords of some moves at which runs begin, and one past the last: the first chord, and where the path
    /// turns by more.
    fn corners_of(
        &self,
        moves: &[MoveRequest],
        of: Range<usize>,
        joints: JointFilter,
    ) -> Vec<usize> {
        let mut corners = vec![self.firsts[of.start]];
        // The last corner that may yet turn out to be the lesser of two, with its cosine and tolerance.
        let mut last: Option<(f64, f64)> = None;
        let mut since = 0.0;
        for index in of.start + 1..of.end {
            since += moves[index - 1].length();
            let Some((cosine, tolerance)) = self.turn(moves, index) else {
                corners.push(self.firsts[index]);
                last = None;
                continue;
            };
            let first = self.firsts[index];
            let is_one = match joints {
                JointFilter::Corners => {
                    cosine < TUNING.curves.corner_cosine
                        && self.is_sharp_below(moves, index, tolerance)
                }
                JointFilter::Bends => cosine < TUNING.curves.bend_cosine,
            };
            if !is_one || self.goes_on(first) {
                continue;
            }
            // Of a bend as sharp as the tolerance is wide only the sharpest joint is a corner.
            match last {
                Some((sharper, near)) if since < TUNING.curves.look_tolerances * near => {
                    if cosine < sharper {
                        corners.pop();
                    } else {
                        continue;
                    }
                }
                _ => {}
            }
            corners.push(self.firsts[index]);
            (last, since) = (Some((cosine, tolerance)), 0.0);
        }
        corners.push(self.firsts.get(of.end).copied().unwrap_or(self.owners.len()));
        corners
    }

    /// The cosine of the turn where a move begins, seen over some tolerances, with the tolerance; `None`
    /// where it is a corner in any case.
    fn turn(&self, moves: &[MoveRequest], index: usize) -> Option<(f64, f64)> {
        let CornerMode::Joined { linear_mm, .. } = moves[index - 1].corner else { return None };
        // σ is of another kind where rotary axes alone move.
        let [turns, goes_on] = [index - 1, index].map(|at| moves[at].turns_only());
        if turns != goes_on {
            return None;
        }
        let tolerance = linear_mm.max(EXACT_TOLERANCE.linear_mm);
        Some((self.cosine_within(moves, index, tolerance), tolerance))
    }

    /// Whether a joint is as sharp over lower tolerances: a bend that is round within a lower one stays a bend.
    fn is_sharp_below(&self, moves: &[MoveRequest], index: usize, tolerance: f64) -> bool {
        let mut lower =
            TUNING.curves.tolerance_ladder_mm.iter().rev().filter(|value| **value < tolerance);
        lower.all(|value| self.cosine_within(moves, index, *value) < TUNING.curves.corner_cosine)
    }

    /// The cosine of the turn where a move begins, seen over some tolerances.
    fn cosine_within(&self, moves: &[MoveRequest], index: usize, tolerance: f64) -> f64 {
        let (first, arm_mm) = (self.firsts[index], arm_mm(moves, index));
        let here = &self.places[first];
        let before = self.beyond(first, -self.look((0..first).rev(), tolerance));
        let after = self.beyond(first, self.look(first..self.lengths.len(), tolerance));
        let (mut dot, mut squares) = (0.0, [0.0; 2]);
        let axes = if arm_mm > 0.0 { AXES } else { 3 };
        for axis in 0..axes {
            let mm = if axis < 3 { 1.0 } else { arm_mm };
            let (a, b) = (mm * (here[axis] - before[axis]), mm * (after[axis] - here[axis]));
            dot += a * b;
            squares[0] += a * a;
            squares[1] += b * b;
        }
        let size = (squares[0] * squares[1]).sqrt();
        // Rotary axes alone have no angle in space.
        if size > 0.0 { dot / size } else { 1.0 }
    }

    /// How far the direction of a chord is looked at, with the chords that follow it: over the line that they
    /// go on in. Where that is shorter than the tolerance what turns may be rounding.
    fn look(&self, mut chords: impl Iterator<Item = usize>, tolerance: f64) -> f64 {
        let Some(first) = chords.next() else { return 0.0 };
        let mut length = self.lengths[first];
        if length >= tolerance {
            return length;
        }
        let direction = self.direction(first);
        for chord in chords {
            if !is_same(&direction, &self.direction(chord)) {
                break;
            }
            length += self.lengths[chord];
            if length >= tolerance {
                return length;
            }
        }
        TUNING.curves.look_tolerances * tolerance
    }

    /// Whether a chord goes on in the line of the one before: a joint within a line is no corner, however
    /// short its chords are.
    fn goes_on(&self, chord: usize) -> bool {
        is_same(&self.direction(chord - 1), &self.direction(chord))
    }

    fn direction(&self, chord: usize) -> AxisValues {
        let (from, to) = (&self.places[chord], &self.places[chord + 1]);
        std::array::from_fn(|axis| (to[axis] - from[axis]) / self.lengths[chord])
    }

    /// The place so far from a vertex along the chords, or their end.
    fn beyond(&self, index: usize, distance: f64) -> AxisValues {
        let (mut at, mut left) = (index, distance.abs());
        loop {
            let (next, length) = if distance < 0.0 {
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

    /// The trajectory of a run of chords, in pieces that moves share.
    fn run(
        &mut self,
        moves: &[MoveRequest],
        chords: Range<usize>,
        limits: &KinematicLimits,
        gap: f64,
        reserve: [JerkReserve; 2],
    ) -> Option<SolvedCurve> {
        let arrays = AxisArrays::new(limits);
        let measure = self.enter(moves, chords, &arrays);
        if self.chords.count() < 2 {
            return self.line(moves, limits, gap, reserve);
        }
        let measure = measure?;
        let parts = &self.parts;
        self.quickest.plan(
            &self.chords,
            &measure,
            (limits, gap),
            |smooth, pieces, speeds| make_pieces(moves, parts, smooth, &measure, (pieces, speeds)),
            |pieces, speeds| {
                Some(PathRun::new(pieces, speeds, 0.0, limits).ok()?.with_ends(reserve))
            },
        )
    }

    /// Where each move of the run that was entered last ends, σ, and its tag.
    fn moves_of_run(&self, moves: &[MoveRequest]) -> Vec<(f64, u64)> {
        self.parts.iter().map(|part| (part.end, moves[part.index].tag)).collect()
    }

    /// Enters the chords of a run, with lines that go on in each other as one.
    fn enter(
        &mut self,
        moves: &[MoveRequest],
        run: Range<usize>,
        limits: &AxisArrays,
    ) -> Option<ToleranceMeasure> {
        let of_moves = self.owners[run.start] as usize..self.owners[run.end - 1] as usize + 1;
        let mut tolerance = [f64::INFINITY; 2];
        for motion in &moves[of_moves.start..of_moves.end - 1] {
            if let Some((linear_mm, rotary_rad)) = motion.corner.tolerance() {
                let own = [
                    linear_mm.max(EXACT_TOLERANCE.linear_mm),
                    rotary_rad.max(EXACT_TOLERANCE.rotary_rad),
                ];
                tolerance = [tolerance[0].min(own[0]), tolerance[1].min(own[1])];
            }
        }
        let own = &moves[of_moves];
        let turns_only = own.iter().all(MoveRequest::turns_only);
        if own.iter().any(|motion| !matches!(motion.curve, Curve::Line(_))) {
            tolerance[0] -= TUNING.curves.arc_chord_share * tolerance_of(moves);
        }
        self.parts.clear();
        self.chords.begin(self.places[run.start]);
        let mut last: Option<(AxisValues, f64)> = None;
        for chord in run {
            let (index, length) = (self.owners[chord] as usize, self.lengths[chord]);
            let direction = self.direction(chord);
            let speed = moves[index].speed;
            let goes_on =
                last.is_some_and(|(before, known)| speed == known && is_same(&before, &direction));
            self.chords.push(self.places[chord + 1], length, goes_on);
            let end = self.chords.length();
            match self.parts.last_mut() {
                Some(part) if part.index == index => part.end = end,
                _ => self.parts.push(RunPart { index, end }),
            }
            // Against the first of them: many small turns are a bend.
            if !goes_on {
                last = Some((direction, speed));
            }
        }
        let [linear, rotary] = tolerance;
        (linear.is_finite()).then(|| ToleranceMeasure::new(linear, rotary, turns_only, limits))
    }
}

/// The pieces of a curve, each with its largest speed, cut where the feed changes.
fn make_pieces(
    moves: &[MoveRequest],
    parts: &[RunPart],
    smooth: &SmoothCurve<'_>,
    measure: &ToleranceMeasure,
    (pieces, speeds): (&mut Vec<PathPiece>, &mut Vec<f64>),
) {
    let mut part = 0;
    for (index, jet) in smooth.jets.iter().enumerate() {
        let (begin, end) = (smooth.at[index], smooth.at[index + 1]);
        let whole = straightened(*jet, end - begin, measure);
        let mut at = begin;
        while at < end {
            while part + 1 < parts.len() && parts[part].end <= at {
                part += 1;
            }
            let motion = &moves[parts[part].index];
            let (until, feed) = same_feed(moves, &parts[part..], at, begin..end);
            let start = if at > begin { ahead(&whole, at - begin, AXES) } else { whole };
            let piece = PathPiece { length: until - at, base: None, start, tag: motion.tag };
            // The feed along the path of the tip is none of the axes.
            let rate = if motion.path_length.is_some() { 1.0 } else { rate(&piece).max(1.0) };
            speeds.push(feed / rate);
            pieces.push(piece);
            at = until;
        }
    }
}

/// The radius at which the rotary axes count for the angle where a move begins, mm: where the axes follow a tip, X, Y and Z
/// may turn round while a table turns on, which is no corner.
fn arm_mm(moves: &[MoveRequest], index: usize) -> f64 {
    let follows_tip = moves[index - 1..=index].iter().any(|motion| motion.path_length.is_some());
    match moves[index - 1].corner.tolerance() {
        Some((linear_mm, rotary_rad)) if follows_tip => {
            linear_mm.max(EXACT_TOLERANCE.linear_mm) / rotary_rad.max(EXACT_TOLERANCE.rotary_rad)
        }
        _ => 0.0,
    }
}

fn is_same(one: &AxisValues, other: &AxisValues) -> bool {
    one.iter().zip(other).all(|(a, b)| (a - b).abs() < EQUAL_DIRECTION)
}

/// How far from a place on a piece the feed is the same, and the feed. What is left of the piece on either
/// side is no sliver: that takes the lower of two feeds.
fn same_feed(
    moves: &[MoveRequest],
    parts: &[RunPart],
    at: f64,
    Range { start, end }: Range<f64>,
) -> (f64, f64) {
    let least = MIN_PART_SHARE * (end - start);
    let mut feed = moves[parts[0].index].speed;
    for pair in parts.windows(2) {
        let until = pair[0].end;
        if until >= end {
            break;
        }
        let next = moves[pair[1].index].speed;
        if next == feed {
            continue;
        }
        if until - at >= least && end - until >= least {
            return (until, feed);
        }
        feed = feed.min(next);
    }
    (end, feed)
}

/// A piece of a length; a line between its ends where bends are rounding.
fn straightened(start: AxisJet, length: f64, measure: &ToleranceMeasure) -> AxisJet {
    let turns = [start[2].map(|bend| bend * length), start[3].map(|third| third * length * length)];
    let is_even = |turn: &AxisValues| turn.iter().all(|turn| turn.abs() < MAX_LINE_TURN_RAD);
    let is_line = turns.iter().all(is_even)
        && turns
            .iter()
            .all(|turn| measure.of(&turn.map(|turn| turn * length)) < MAX_LINE_BEND_TOLERANCES);
    if !is_line {
        return start;
    }
    // It ends where the next piece begins.
    let [first, rate, second, third] = &start;
    let even = std::array::from_fn(|axis| {
        rate[axis] + length * (second[axis] / 2.0 + length * (third[axis] * SIXTH))
    });
    [*first, even, [0.0; AXES], [0.0; AXES]]
}

/// The least tolerance of some moves, mm.
fn tolerance_of(moves: &[MoveRequest]) -> f64 {
    let of = |motion: &MoveRequest| {
        motion.corner.tolerance().map_or(f64::INFINITY, |(mm, _)| mm.max(EXACT_TOLERANCE.linear_mm))
    };
    moves.iter().map(of).fold(f64::INFINITY, f64::min)
}

/// The largest |q'| of the tool on a piece, or of the rotary axes where these alone move.
fn rate(piece: &PathPiece) -> f64 {
    let [_, d1, d2, d3] = &piece.start;
    let h = piece.length;
    // q' is a parabola within the triangle of three values, and its square lies within what these have as
    // products: the coefficients of Bernstein.
    let mut sums = [[0.0_f64; 5]; 2];
    for axis in 0..AXES {
        let (first, middle) = (d1[axis], d1[axis] + d2[axis] * h / 2.0);
        let last = d1[axis] + h * (d2[axis] + d3[axis] * h / 2.0);
        let between = (first * last + 2.0 * middle * middle) / 3.0;
        let products = [first * first, first * middle, between, middle * last, last * last];
        for (sum, product) in sums[axis / 3].iter_mut().zip(products) {
            *sum += product;
        }
    }
    let [linear, rotary] = sums.map(|sums| sums.into_iter().fold(0.0, f64::max).sqrt());
    if linear > 0.0 { linear } else { rotary }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_rate_of_a_piece_is_its_largest_and_hardly_more() {
        // Turns of up to a sixth of a turn, and a rate that changes by up to a tenth.
        for step in 0..100 {
            let turn = 0.01 * f64::from(step);
            let change = 0.001 * f64::from(step % 7);
            let d1 = [1.0, 0.0, 0.0, 0.0, 0.0, 0.0];
            let d2 = [change, turn, 0.0, 0.0, 0.0, 0.0];
            let d3 = [-turn * turn, 0.5 * change, 0.3 * turn * turn, 0.0, 0.0, 0.0];
            let piece =
                PathPiece { length: 1.0, base: None, start: [[0.0; 6], d1, d2, d3], tag: 0 };
            let most = (0..=1000).fold(0.0_f64, |most, part| {
                let [_, rate, ..] = piece.at(f64::from(part) / 1000.0);
                most.max(rate.iter().map(|rate| rate * rate).sum::<f64>().sqrt())
            });
            let rate = rate(&piece);
            assert!(rate >= most * (1.0 - 1e-15), "{turn}: {rate} below {most}");
            assert!(
                rate <= most * (1.0 + 0.2 * turn.powi(4) + 1e-6),
                "{turn}: {rate} above {most}"
            );
        }
    }
}
