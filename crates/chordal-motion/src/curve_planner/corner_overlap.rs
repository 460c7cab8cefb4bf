//! Two runs that overlap at the corner between them: the next begins before the last has ended, and the
//! axes make both movements at once.
//!
//! Let c be the corner, e₁ and e₂ how far the two movements are from it (e₁ ends, e₂ begins at nothing), so
//! that the tool is at c + e₁ + e₂. All sizes are in tolerances of the corner. Each run is a curve q
//! within `off` of the programmed path p at the same σ, over a distance next to the corner on which |q'| ≤ `rate`.
//! For a reach r let t₁ and t₂ be the times from rest in which the runs go the distance r, and let the overlap be
//! no longer than t₁ + t₂. Then at each instant one of the two is no farther than r from the corner:
//!
//! - *The tool is near the path.* If it is the first, |e₁| ≤ rate₁·r, and c + e₂ is within off₂ of the
//!   path: the distance is at most rate₁·r + off₂; likewise for the second.
//! - *The path is near the tool.* A place that is farther than r from the corner is passed while the other movement is
//!   within r: at most off₁ + rate₂·r. For those nearer take the instant when both are within r at once (or
//!   where a shorter overlap has them: nearer still). With k = |e₁ + e₂| there, the place p₁(σ) is
//!   c + λe₁ + δ, 0 ≤ λ ≤ 1, |δ| ≤ off₁ + max|q''|r²/8; so its distance |e₂ + (1 − λ)e₁ − δ| is at most
//!   max(rate₂·r, k) + |δ|, since a norm is convex; likewise for the other run.
//!
//! r is chosen so that all of these are at most one. From rest no run gets farther than jerk allows, J·t³/6, so
//! t₁ + t₂ is about (6r/J₁)^⅓ + (6r/J₂)^⅓, and each is about 8r from the corner when the other rests.
//! Over that distance the ends use only a share of the jerk, so that the sum of both keeps the limits
//! of axes that take part in both. What remains to be seen, as curves turn next to their ends, is measured: where
//! the sum is above a limit the overlap is made shorter.

use chordal_geometry::AXES;

use crate::AxisValues;
use crate::corner_blend::{CornerTolerance, OverlapLimits};
use crate::cube_root::cbrt;
use crate::cursor::TrajectoryCursor;
use crate::curve_fit::ChordPath;
use crate::limit_use::LimitUse;
use crate::limits::KinematicLimits;
use crate::path_limits::AxisArrays;
use crate::piece::{PathPiece, ahead};
use crate::sample::AxisState;
use crate::time_bound::JerkReserve;
use crate::trajectory::PlannedTrajectory;

/// The share of the jerk holds on this many times the expected distance from the corner, as runs turn there.
const FREE_DISTANCE_FACTOR: f64 = 1.1;
/// A bend turns the axes by κd over a distance d. From rest with jerk J, 3q''va is at most 9·κd·J there.
const TURNING_JERK_FACTOR: f64 = 9.0;
/// The distance over which the curvature next to a corner is measured, in tolerances: over less it might be rounding of coordinates.
pub const CURVATURE_LOOK_TOLERANCES: f64 = 32.0;
/// The least share of the jerk for one end, and the least saving, as a share of the overlap: t seconds of overlap save
/// (share₁ + share₂ − 1)·t, as each run is later by (1 − share)·t.
const MIN_JERK_SHARE: f64 = 0.4;
const MIN_SAVED_SHARE: f64 = 0.2;
/// Steps between the least share and one that are tried for each end, and the factor up to which two savings are equal.
const SHARE_STEPS: u32 = 8;
const EQUAL_SAVING_FACTOR: f64 = 1.0 + 1e-9;
/// Shares above this are one.
const WHOLE_SHARE: f64 = 1.0 - 1e-6;
/// Instants at which each part of an overlap without a change of jerk is measured, and parts of an overlap at least.
const PROBES_PER_PART: u32 = 3;
const MIN_OVERLAP_PARTS: u32 = 24;
/// The first and the last of these instants are so far inside of the part, as a share of it: at its end the jerk changes.
const PROBE_INSET_SHARE: f64 = 1e-6;
/// What rounding may add to a limit.
const LIMIT_ROUNDING_FACTOR: f64 = 1.0 + 1e-9;
/// Halvings in the search for the longest overlap that keeps the limits.
const OVERLAP_HALVINGS: u32 = 6;
/// Steps in which the reach is made smaller until the tool stays within the tolerance.
const MAX_REACH_STEPS: u32 = 12;

/// A corner between two runs, as the path has it.
#[derive(Clone, Copy, Debug)]
pub struct RunCorner {
    /// How far from it the axes may pass.
    pub tolerance: CornerTolerance,
    /// The derivative by σ before and after it.
    pub directions: [AxisValues; 2],
    /// The change of direction by σ before and after it, from the corner on.
    pub bends: [AxisValues; 2],
    /// The programmed speeds before and after it, mm/s, or rad/s where rotary axes alone move.
    pub speeds: [f64; 2],
    /// Rotary axes alone move.
    pub turns_only: bool,
}

/// A corner at which two runs may overlap.
#[derive(Clone, Copy, Debug)]
pub struct CornerOverlap {
    corner: RunCorner,
    /// How far from it each run may be, and which share of the jerk it may use there.
    ends: [JerkReserve; 2],
}

/// An end of a run next to a corner.
#[derive(Clone, Copy, Debug)]
pub struct RunEnd {
    /// Over this distance it is known what follows, σ.
    distance: f64,
    /// How far the curve is from the programmed path, and the largest |q'| and |q''|, in tolerances.
    off: f64,
    rate: f64,
    bend: f64,
}

impl CornerOverlap {
    /// How two runs may meet, seen from the path.
    pub fn new(corner: RunCorner, limits: &AxisArrays) -> CornerOverlap {
        let RunCorner { tolerance, directions: [before, after], .. } = &corner;
        let direction_step: AxisValues = std::array::from_fn(|axis| after[axis] - before[axis]);
        let most = tolerance.of(&direction_step).max(tolerance.of(before)).max(tolerance.of(after));
        let reach = 1.0 / most;
        let jerks = corner.directions.map(|direction| jerk_along(&direction, limits));
        let [one, two] = jerks;
        let distances = |[one, two]: [f64; 2]| {
            let ratio = cbrt(one / two);
            [1.0 + ratio, 1.0 + 1.0 / ratio]
                .map(|times| FREE_DISTANCE_FACTOR * reach * times * times * times)
        };
        let shares = shares(&corner, jerks, distances(jerks), limits);
        let [first, last] = distances([one * shares[0], two * shares[1]]);
        let ends = [
            JerkReserve { distance: first, share: shares[0] },
            JerkReserve { distance: last, share: shares[1] },
        ];
        CornerOverlap { corner, ends }
    }

    /// How the run before (0) or after the corner is to move next to it.
    pub fn end(&self, side: usize) -> JerkReserve {
        let end = self.ends[side];
        if end.share < WHOLE_SHARE { end } else { JerkReserve::NONE }
    }

    /// The same for a planner of single corners.
    pub fn overlap(&self, side: usize) -> OverlapLimits {
        let JerkReserve { distance, share } = self.ends[side];
        OverlapLimits { reach: distance / OverlapLimits::CLEAR_REACHES, jerk_share: share }
    }

    /// What is known of a run that was planned as a curve through chords, which are so many tolerances from the
    /// path.
    pub fn side_of_curve(
        &self,
        side: usize,
        trajectory: &PlannedTrajectory,
        chords: &ChordPath,
        chords_off: f64,
    ) -> RunEnd {
        let mut known = self.side(side, trajectory, |_| true);
        known.off = chords_off + self.off(side, trajectory, chords, known.distance);
        known
    }

    /// What is known of a run that was planned corner by corner: it is on the path where it is straight.
    pub fn side_of_lines(&self, side: usize, trajectory: &PlannedTrajectory) -> RunEnd {
        self.side(side, trajectory, PathPiece::is_straight)
    }

    /// The pieces next to the corner, from there on, as long as they are known.
    fn side(
        &self,
        side: usize,
        trajectory: &PlannedTrajectory,
        is_known: impl Fn(&PathPiece) -> bool,
    ) -> RunEnd {
        let tolerance = &self.corner.tolerance;
        let (mut distance, mut rate, mut bend) = (0.0, 0.0_f64, 0.0_f64);
        for piece in from_corner(side, trajectory) {
            if distance >= self.ends[side].distance || piece.base.is_some() || !is_known(piece) {
                break;
            }
            let [_, first, second, third] = &piece.start;
            let h = piece.length;
            // The first derivative is a parabola, within the triangle of these three.
            let at = |share: f64, square: f64| -> AxisValues {
                std::array::from_fn(|axis| {
                    first[axis] + h * (share * second[axis] + square * h * third[axis])
                })
            };
            let rates = [at(0.0, 0.0), at(0.5, 0.0), at(1.0, 0.5)];
            rate = rates.iter().fold(rate, |most, rate| most.max(tolerance.of(rate)));
            let end = std::array::from_fn(|axis| second[axis] + h * third[axis]);
            bend = bend.max(tolerance.of(second)).max(tolerance.of(&end));
            distance += h;
        }
        RunEnd { distance: distance.min(self.ends[side].distance), off: 0.0, rate, bend }
    }

    /// How far a curve is from its chords within a distance of the corner: at the ends of pieces and chords, and
    /// between them by |e| ≤ max(|e₀|, |e₁|) + max|q''|·δ²/8.
    fn off(
        &self,
        side: usize,
        trajectory: &PlannedTrajectory,
        chords: &ChordPath,
        distance: f64,
    ) -> f64 {
        let tolerance = &self.corner.tolerance;
        let length = chords.length();
        let last = chords.count();
        let vertex = |index: usize| {
            if side == 0 { length - chords.at[last - index] } else { chords.at[index] }
        };
        let mut hint = if side == 0 { last } else { 0 };
        let (mut off, mut begin, mut next_chord) = (0.0_f64, 0.0, 1);
        for piece in from_corner(side, trajectory) {
            if begin >= distance {
                break;
            }
            let end = begin + piece.length;
            // How far the curve is from the chords there, and how it bends.
            let mut look = |at: f64| {
                let (sigma, along) =
                    if side == 0 { (length - at, end - at) } else { (at, at - begin) };
                let jet = ahead(&piece.start, along, AXES);
                let place = chords.place_at(sigma, &mut hint);
                let e: AxisValues = std::array::from_fn(|axis| jet[0][axis] - place[axis]);
                (tolerance.of(&e), tolerance.of(&jet[2]))
            };
            let mut at = begin;
            let mut before = look(at);
            while at < end {
                while next_chord < last && vertex(next_chord) <= at {
                    next_chord += 1;
                }
                let next = vertex(next_chord).min(end);
                let next = if next > at { next } else { end };
                let after = look(next);
                let part = next - at;
                let between = before.1.max(after.1) * part * part / 8.0;
                off = off.max(before.0.max(after.0) + between);
                (at, before) = (next, after);
            }
            begin = end;
        }
        off
    }

    /// How long two planned runs overlap, s.
    pub fn overlap_s(
        &self,
        runs: [&PlannedTrajectory; 2],
        sides: [RunEnd; 2],
        limits: &KinematicLimits,
    ) -> f64 {
        let Some(reach) = self.reach(&runs, &sides) else { return 0.0 };
        let within =
            |distance: [f64; 2]| [0, 1].map(|side| time_to(side, runs[side], distance[side]));
        let [before_s, after_s] = within([reach; 2]);
        let known_s = within(sides.map(|side| side.distance));
        // Beyond the half a run might overlap with two others at once.
        let halves_s = runs.map(|run| 0.5 * run.duration_s());
        let longest_s = known_s.into_iter().chain(halves_s).fold(before_s + after_s, f64::min);
        if longest_s <= 0.0 {
            return 0.0;
        }
        let both = OverlappedRuns::new(runs, longest_s);
        if both.hold(longest_s, self, limits) {
            return longest_s;
        }
        let (mut fits_s, mut over_s) = (0.0, longest_s);
        for _ in 0..OVERLAP_HALVINGS {
            let middle_s = 0.5 * (fits_s + over_s);
            if both.hold(middle_s, self, limits) {
                fits_s = middle_s;
            } else {
                over_s = middle_s;
            }
        }
        fits_s
    }

    /// How far both runs may be from the corner at once, σ.
    fn reach(&self, runs: &[&PlannedTrajectory; 2], sides: &[RunEnd; 2]) -> Option<f64> {
        let tolerance = &self.corner.tolerance;
        let [one, two] = sides;
        let most = one.off.max(two.off);
        let mut reach = ((1.0 - two.off) / one.rate)
            .min((1.0 - one.off) / two.rate)
            .min(one.distance)
            .min(two.distance);
        for _ in 0..MAX_REACH_STEPS {
            if reach.is_nan() || reach <= 0.0 {
                return None;
            }
            let [e, f] = [0, 1].map(|side| from_corner_to(side, runs[side], reach));
            let sum = std::array::from_fn(|axis| e[axis] + f[axis]);
            let separation = tolerance.of(&sum).max(reach * one.rate).max(reach * two.rate);
            let bend = one.bend.max(two.bend) * reach * reach / 8.0;
            if separation + bend + most <= 1.0 {
                return Some(reach);
            }
            reach *= (0.999 * (1.0 - most) / (separation + bend)).min(0.999);
        }
        None
    }
}

/// The pieces of a run from the corner on that it ends (0) or begins at.
fn from_corner(side: usize, trajectory: &PlannedTrajectory) -> impl Iterator<Item = &PathPiece> {
    let count = trajectory.pieces.len();
    (0..count)
        .map(move |index| &trajectory.pieces[if side == 0 { count - 1 - index } else { index }])
}

/// From the corner to the place on a run that is so far from it.
fn from_corner_to(side: usize, trajectory: &PlannedTrajectory, distance: f64) -> AxisValues {
    let mut left = distance;
    let mut corner: Option<AxisValues> = None;
    for piece in from_corner(side, trajectory) {
        let here = if side == 0 { piece.length } else { 0.0 };
        let corner = corner.get_or_insert_with(|| piece.at(here)[0]);
        if left <= piece.length {
            let place = piece.at((here - left).abs())[0];
            return std::array::from_fn(|axis| place[axis] - corner[axis]);
        }
        left -= piece.length;
    }
    [f64::NAN; AXES]
}

/// The time in which a run goes a distance from rest, or the same distance to its rest, s.
fn time_to(side: usize, trajectory: &PlannedTrajectory, distance: f64) -> f64 {
    if side == 1 {
        let mut begin_s = 0.0;
        for phase in &trajectory.phases {
            if phase.at(phase.duration_s).sigma >= distance {
                return begin_s + phase.time_at(distance, 0.0);
            }
            begin_s += phase.duration_s;
        }
        return begin_s;
    }
    let from = trajectory.length() - distance;
    let mut after_s = 0.0;
    for phase in trajectory.phases.iter().rev() {
        if phase.from <= from {
            return after_s + phase.duration_s - phase.time_at(from, 0.0);
        }
        after_s += phase.duration_s;
    }
    after_s
}

/// The jerk that the axes have along a direction, σ per s³.
fn jerk_along(direction: &AxisValues, limits: &AxisArrays) -> f64 {
    let most =
        (0..AXES).fold(0.0_f64, |most, axis| most.max(direction[axis].abs() / limits.jerk[axis]));
    1.0 / most
}

/// The shares of the jerk that two ends may use so that their sum keeps the limits; all of it where it is not
/// worth it to use less.
fn shares(
    corner: &RunCorner,
    jerks: [f64; 2],
    distances: [f64; 2],
    limits: &AxisArrays,
) -> [f64; 2] {
    let mut rows = [[[0.0; 2]; 4]; AXES];
    for (axis, rows) in rows.iter_mut().enumerate() {
        let shares = [0, 1].map(|side| jerks[side] / limits.jerk[axis]);
        let along = [0, 1].map(|side| shares[side] * corner.directions[side][axis]);
        let turning = [0, 1].map(|side| {
            TURNING_JERK_FACTOR * shares[side] * (distances[side] * corner.bends[side][axis]).abs()
        });
        let [[a, b], [c, d]] = [along, along.map(|along| -along)];
        // While the first has turned most the next begins, and the other way round.
        let [one, two] = turning;
        *rows = [[a + one, b], [a, b + two], [c + one, d], [c, d + two]];
    }
    // Each row times the shares is at most one.
    let largest_next_to = |side: usize, share: f64| {
        let of = |row: &[f64; 2]| {
            let [own, other] = [row[side], row[1 - side]];
            if other > 0.0 { (1.0 - own * share) / other } else { 1.0 }
        };
        rows.as_flattened().iter().map(of).fold(1.0, f64::min)
    };
    let saved = |shares: [f64; 2]| {
        let times = [0, 1].map(|side| 1.0 / cbrt(jerks[side] * shares[side]));
        (shares[0] + shares[1] - 1.0) * (times[0] + times[1])
    };
    let (mut best, mut most) = ([1.0; 2], 0.0);
    // The same pair backwards: of two that save as much the side goes first that turns first.
    let first = usize::from(is_after(&corner.directions));
    for side in [first, 1 - first] {
        for step in 0..=SHARE_STEPS {
            let share =
                MIN_JERK_SHARE + (1.0 - MIN_JERK_SHARE) * f64::from(step) / f64::from(SHARE_STEPS);
            let other = largest_next_to(side, share);
            let pair = if side == 0 { [share, other] } else { [other, share] };
            if other >= MIN_JERK_SHARE
                && share + other >= 1.0 + MIN_SAVED_SHARE
                && saved(pair) > EQUAL_SAVING_FACTOR * most
            {
                (best, most) = (pair, saved(pair));
            }
        }
    }
    best
}

/// Whether the second of two directions has the larger part of the first axis in which they differ.
fn is_after([before, after]: &[AxisValues; 2]) -> bool {
    let differs = |(a, b): &(f64, f64)| (a - b).abs() > EQUAL_SAVING_FACTOR - 1.0;
    let parts = before.iter().zip(after).map(|(a, b)| (a.abs(), b.abs()));
    parts.into_iter().find(differs).is_some_and(|(a, b)| b > a)
}

/// The ends of two runs next to their corner.
struct OverlappedRuns {
    runs: [PlannedTrajectory; 2],
    /// The duration of the first.
    ends_s: f64,
    /// When the jerk of each changes, s before the end of the first and after the start of the second.
    changes: [Vec<f64>; 2],
}

impl OverlappedRuns {
    /// The last and the first so many seconds of them.
    fn new([before, after]: [&PlannedTrajectory; 2], seconds: f64) -> OverlappedRuns {
        let mut changes = [Vec::new(), Vec::new()];
        let count_of = |phases: &mut dyn Iterator<Item = f64>, changes: &mut Vec<f64>| {
            let mut sum = 0.0;
            for duration_s in phases {
                sum += duration_s;
                changes.push(sum);
                if sum >= seconds {
                    break;
                }
            }
            (changes.len(), sum)
        };
        let [ends, begins] = &mut changes;
        let (count, ends_s) =
            count_of(&mut before.phases.iter().rev().map(|phase| phase.duration_s), ends);
        let mut phases = before.phases[before.phases.len() - count..].to_vec();
        let from = phases.first().map_or(0.0, |phase| phase.from);
        let (mut left, mut first) = (before.length() - from, before.pieces.len());
        while first > 0 && left > 0.0 {
            first -= 1;
            left -= before.pieces[first].length;
        }
        // The first piece begins before the phases do.
        phases.iter_mut().for_each(|phase| phase.from += -left - from);
        let before =
            PlannedTrajectory { pieces: before.pieces[first..].to_vec(), phases, overlap_s: 0.0 };
        let (count, _) = count_of(&mut after.phases.iter().map(|phase| phase.duration_s), begins);
        let phases = after.phases[..count].to_vec();
        let end = phases.last().map_or(0.0, |phase| phase.at(phase.duration_s).sigma);
        let (mut distance, mut count) = (0.0, 0);
        while count < after.pieces.len() && distance < end {
            distance += after.pieces[count].length;
            count += 1;
        }
        let after =
            PlannedTrajectory { pieces: after.pieces[..count].to_vec(), phases, overlap_s: 0.0 };
        OverlappedRuns { runs: [before, after], ends_s, changes }
    }

    /// Whether the sum of both keeps every limit and the programmed speeds with an overlap of so many seconds.
    fn hold(&self, seconds: f64, corner_overlap: &CornerOverlap, limits: &KinematicLimits) -> bool {
        let part_at = |part| seconds * (f64::from(part) / f64::from(MIN_OVERLAP_PARTS));
        let mut cuts: Vec<f64> = (0..=MIN_OVERLAP_PARTS).map(part_at).collect();
        let [ends, begins] = &self.changes;
        cuts.extend(ends.iter().map(|before| seconds - before));
        cuts.extend(begins.iter());
        cuts.retain(|at| (0.0..=seconds).contains(at));
        cuts.sort_by(f64::total_cmp);
        let mut cursors = [TrajectoryCursor::default(), TrajectoryCursor::default()];
        let from = self.ends_s - seconds;
        for pair in cuts.windows(2) {
            let part = pair[1] - pair[0];
            for look in 0..PROBES_PER_PART {
                let share = f64::from(look) / f64::from(PROBES_PER_PART - 1);
                let t =
                    pair[0] + part * (PROBE_INSET_SHARE + (1.0 - 2.0 * PROBE_INSET_SHARE) * share);
                let one = cursors[0].at(&self.runs[0], from + t);
                let two = cursors[1].at(&self.runs[1], t);
                let sum = sum(&one, &two);
                let used = LimitUse::of(&sum, limits);
                let most = used.velocity.max(used.acceleration).max(used.jerk);
                if most > LIMIT_ROUNDING_FACTOR || !corner_overlap.is_slow_enough(&sum) {
                    return false;
                }
            }
        }
        true
    }
}

impl CornerOverlap {
    /// The axes are not faster together than one of the runs may be.
    fn is_slow_enough(&self, state: &AxisState) -> bool {
        let axes = if self.corner.turns_only { &state.velocity[3..] } else { &state.velocity[..3] };
        let speed = axes.iter().map(|part| part * part).sum::<f64>().sqrt();
        let [before, after] = self.corner.speeds;
        speed <= LIMIT_ROUNDING_FACTOR * before.max(after)
    }
}

fn sum(one: &AxisState, two: &AxisState) -> AxisState {
    let add = |a: &AxisValues, b: &AxisValues| std::array::from_fn(|axis| a[axis] + b[axis]);
    AxisState {
        position: one.position,
        velocity: add(&one.velocity, &two.velocity),
        acceleration: add(&one.acceleration, &two.acceleration),
        jerk: add(&one.jerk, &two.jerk),
        tag: one.tag,
    }
}
