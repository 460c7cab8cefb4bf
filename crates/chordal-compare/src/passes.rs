//! Lathe cycles whose passes the control chooses: keeps the last pass of each, and records the others.
//!
//! For the same cycle, two controls place the roughing passes at different levels, retract by different settings, and
//! divide the depth of a thread differently. The part is determined by the last pass along the contour, the last pass
//! of the thread, and the bottom of each plunge. These are kept and compared move by move, with rapids from the start
//! of the cycle and to its end. Cycles with a cut beyond their last pass are not joined.

use std::collections::BTreeMap;

use chordal::geometry::{Curve, Line, ParamCurve, Vec3};

use crate::category::Category;
use crate::course::{ComparedMove, ComparedMoveKind, ComparedRun, RunStep};
use crate::difference::{BlockLocation, BlockRange, Difference};

/// Which part of a cycle is kept.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LastPass {
    /// The last pass along the blocks of a contour.
    Contour,
    /// The last cut.
    Cut,
    /// One cut to the bottom of each plunge.
    Plunges,
}

/// The lines whose cycles may be cut in different passes, and which part of them is kept.
pub type FreePasses = BTreeMap<u32, LastPass>;

/// Positions and lengths that differ by at most this are equal, mm: the rounding of the numbers in two texts.
const EQUAL_LENGTH_MM: f64 = 1e-6;

/// The passes of one cycle.
#[derive(Clone, Debug, PartialEq)]
pub struct CyclePasses {
    /// The block of the cycle.
    pub place: BlockLocation,
    /// The number of passes: sequences of cuts without a rapid.
    pub count: usize,
    /// The end point of each cut, in the frame of the run, mm.
    pub ends_mm: Vec<[f64; 3]>,
    /// The total length of the cuts, mm.
    pub length_mm: f64,
    /// The largest distance between adjacent levels, mm (in X: of the radius); `None` for fewer than two levels.
    pub largest_step_mm: Option<f64>,
}

impl CyclePasses {
    fn has_same_cuts(&self, other: &CyclePasses, tolerance_mm: f64) -> bool {
        let near = |one: &[f64; 3], other: &[f64; 3]| {
            let off = Vec3::from_array(*one).distance(Vec3::from_array(*other));
            off <= tolerance_mm.max(EQUAL_LENGTH_MM)
        };
        self.count == other.count
            && self.ends_mm.len() == other.ends_mm.len()
            && self.ends_mm.iter().zip(&other.ends_mm).all(|(one, other)| near(one, other))
    }
}

/// The pairs of cycles that the two runs cut in different passes. Cycles without a counterpart are added as a
/// difference of the paths.
pub(crate) fn compare(
    cycles: &[Vec<CyclePasses>; 2],
    tolerance_mm: f64,
    differences: &mut Vec<Difference>,
) -> Vec<[CyclePasses; 2]> {
    let mut others = Vec::new();
    for at in 0..cycles[0].len().max(cycles[1].len()) {
        let [one, other] = cycles.each_ref().map(|cycles| cycles.get(at));
        match (one, other) {
            (Some(one), Some(other)) => {
                if !one.has_same_cuts(other, tolerance_mm) {
                    others.push([one.clone(), other.clone()]);
                }
            }
            _ => {
                let blocks = [one, other].map(|own| own.map(|own| BlockRange::at(own.place)));
                let steps = blocks.map(|at| u64::from(at.is_some()));
                differences.push(Difference::new(Category::Path, blocks, steps, None));
                break;
            }
        }
    }
    others
}

/// Reduces the cycles in these lines to their last pass; returns all their passes.
pub(crate) fn join(course: &mut ComparedRun, lines: &FreePasses) -> Vec<CyclePasses> {
    let mut found = Vec::new();
    if lines.is_empty() {
        return found;
    }
    let old = std::mem::take(&mut course.steps);
    let mut at = 0;
    while at < old.len() {
        let end = end_of_cycle(&old, at, lines);
        let moves: Vec<&ComparedMove> = old[at..end].iter().filter_map(moved).collect();
        let last =
            moves.first().and_then(|first| last_pass(&moves, *lines.get(&first.origin.line)?));
        let Some(last) = last else {
            course.steps.push(old[at].clone());
            at += 1;
            continue;
        };
        found.push(passes(&moves));
        course.steps.extend(last.into_iter().map(RunStep::Move));
        at = end;
    }
    found
}

fn moved(step: &RunStep) -> Option<&ComparedMove> {
    match step {
        RunStep::Move(moved) => Some(moved),
        RunStep::Event { .. } => None,
    }
}

/// The index after the last step of the cycle that begins at the step `at`; `at` when no cycle begins there.
fn end_of_cycle(steps: &[RunStep], at: usize, lines: &FreePasses) -> usize {
    let is_first =
        |moved: &ComparedMove| moved.origin.cycle && lines.contains_key(&moved.origin.line);
    let Some(first) = moved(&steps[at]).filter(|moved| is_first(moved)) else { return at };
    let is_own = |step: &RunStep| {
        moved(step).is_some_and(|moved| {
            let line = moved.origin.line;
            moved.origin.cycle && (line == first.origin.line || !lines.contains_key(&line))
        })
    };
    at + steps[at..].iter().take_while(|step| is_own(step)).count()
}

/// The moves that are kept, with rapids from the cycle's start and to its end; `None` when the cycle cannot be
/// reduced to them.
fn last_pass(moves: &[&ComparedMove], kind: LastPass) -> Option<Vec<ComparedMove>> {
    let (first, last) = (moves.first()?, moves.last()?);
    let line = first.origin.line;
    let kept: Vec<ComparedMove> = match kind {
        LastPass::Contour => {
            let end = moves.iter().rposition(|moved| moved.origin.line != line)? + 1;
            let own = |moved: &&&ComparedMove| moved.origin.line != line;
            let count = moves[..end].iter().rev().take_while(own).count();
            moves[end - count..end].iter().map(|moved| (*moved).clone()).collect()
        }
        LastPass::Cut => {
            let end = moves.iter().rposition(|moved| moved.kind == ComparedMoveKind::Cut)? + 1;
            let cuts =
                moves[..end].iter().rev().take_while(|moved| moved.kind == ComparedMoveKind::Cut);
            let count = cuts.count();
            moves[end - count..end].iter().map(|moved| (*moved).clone()).collect()
        }
        LastPass::Plunges => plunges(moves)?,
    };
    let (from, to) = (first.curve.start(), last.curve.end());
    if !stays_within(moves, &kept, from) {
        return None;
    }
    let mut joined = Vec::new();
    let mut here = from;
    for own in kept {
        joined.extend(rapid(here, own.curve.start(), &own));
        here = own.curve.end();
        joined.push(own);
    }
    joined.extend(rapid(here, to, last));
    Some(joined)
}

/// A rapid between two points, in the state of the move `like`; `None` when the points coincide.
fn rapid(from: Vec3, to: Vec3, like: &ComparedMove) -> Option<ComparedMove> {
    let length_mm = from.distance(to);
    (length_mm > EQUAL_LENGTH_MM).then(|| ComparedMove {
        curve: Curve::Line(Line { start: from, end: to }),
        length_mm,
        kind: ComparedMoveKind::Rapid,
        feed: None,
        per_revolution: false,
        ..like.clone()
    })
}

/// One cut to the bottom of each plunge; `None` when a cut is not a straight line.
fn plunges(moves: &[&ComparedMove]) -> Option<Vec<ComparedMove>> {
    let mut found: Vec<ComparedMove> = Vec::new();
    for own in moves.iter().filter(|moved| moved.kind == ComparedMoveKind::Cut) {
        let Curve::Line(line) = own.curve else { return None };
        let along = (line.end - line.start).normalized()?;
        let deeper = found.last_mut().and_then(|plunge| match plunge.curve {
            Curve::Line(before) => {
                let down = (before.end - before.start).normalized()?;
                let path = line.end - before.start;
                let aside = (path - down * path.dot(down)).length();
                let same = aside <= EQUAL_LENGTH_MM && along.dot(down) > 1.0 - EQUAL_LENGTH_MM;
                (same && path.dot(down) > plunge.length_mm).then_some((plunge, before.start))
            }
            _ => None,
        });
        match deeper {
            Some((plunge, start)) => {
                plunge.curve = Curve::Line(Line { start, end: line.end });
                plunge.length_mm = start.distance(line.end);
            }
            None => found.push((*own).clone()),
        }
    }
    Some(found)
}

/// Whether no cut goes beyond the kept moves, as seen from the cycle's start.
fn stays_within(moves: &[&ComparedMove], kept: &[ComparedMove], from: Vec3) -> bool {
    let boxes = || kept.iter().map(|own| own.curve.bounds());
    let from = from.to_array();
    let sides: [(f64, f64); 3] = std::array::from_fn(|axis| {
        let low = boxes().map(|one| one.min.to_array()[axis]).fold(f64::INFINITY, f64::min);
        let high = boxes().map(|one| one.max.to_array()[axis]).fold(f64::NEG_INFINITY, f64::max);
        // The side towards the start is open, because the passes come from there.
        match (high - from[axis]).abs() <= (from[axis] - low).abs() {
            true => (low, f64::INFINITY),
            false => (f64::NEG_INFINITY, high),
        }
    });
    moves.iter().filter(|moved| moved.kind == ComparedMoveKind::Cut).all(|moved| {
        let own = moved.curve.bounds();
        (0..3).all(|axis| {
            own.min.to_array()[axis] >= sides[axis].0 - EQUAL_LENGTH_MM
                && own.max.to_array()[axis] <= sides[axis].1 + EQUAL_LENGTH_MM
        })
    })
}

/// The data of the passes of a cycle.
fn passes(moves: &[&ComparedMove]) -> CyclePasses {
    let mut count = 0;
    let mut before = ComparedMoveKind::Rapid;
    let mut length_mm = 0.0;
    let mut ends_mm = Vec::new();
    let mut levels: [Vec<f64>; 2] = Default::default();
    let mut along = [0.0; 2];
    for own in moves {
        if own.kind == ComparedMoveKind::Cut {
            count += usize::from(before != ComparedMoveKind::Cut);
            length_mm += own.length_mm;
            ends_mm.push(own.curve.end().to_array());
            if let Curve::Line(line) = own.curve {
                let [dx, _, dz] = (line.end - line.start).to_array().map(f64::abs);
                // Cuts along Z have a level in X, cuts along X a level in Z.
                for (which, (path, across, level)) in
                    [(dz, dx, line.end.to_array()[0]), (dx, dz, line.end.to_array()[2])]
                        .into_iter()
                        .enumerate()
                {
                    if across <= EQUAL_LENGTH_MM && path > EQUAL_LENGTH_MM {
                        along[which] += path;
                        levels[which].push(level);
                    }
                }
            }
        }
        before = own.kind;
    }
    let which = usize::from(along[1] > along[0]);
    let mut levels = std::mem::take(&mut levels[which]);
    levels.sort_by(f64::total_cmp);
    let steps = levels.windows(2).map(|pair| pair[1] - pair[0]);
    let largest = steps.filter(|step| *step > EQUAL_LENGTH_MM).reduce(f64::max);
    let place = BlockLocation::from(&moves[0].origin);
    CyclePasses { place, count, ends_mm, length_mm, largest_step_mm: largest }
}
