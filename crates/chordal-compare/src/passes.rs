//! Cycles of lathes cut in passes of their own: the last pass as it is, and what the others were.
//!
//! Two controls that have the same cycle lay its roughing passes at other levels, back off by other settings, and divide a
//! thread's depth in another way. What makes the part is the last pass along the contour, the last pass of the thread, the
//! bottom of each plunge: these stay and are compared move by move, with rapids from where the cycle begins and to where it
//! ends. Cycles with a cut beyond their last pass are not joined.

use std::collections::BTreeMap;

use chordal::geometry::{Curve, Line, ParamCurve, Vec3};

use crate::category::Category;
use crate::course::{ComparedMove, ComparedMoveKind, ComparedRun, RunStep};
use crate::difference::{BlockLocation, BlockRange, Difference};

/// What of a cycle stays.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LastPass {
    /// The last pass along the blocks of a contour.
    Contour,
    /// The last cut.
    Cut,
    /// One cut to the bottom of each plunge.
    Plunges,
}

/// The lines whose cycles may cut in passes of their own.
pub type FreePasses = BTreeMap<u32, LastPass>;

/// Places and lengths nearer than this, mm, are the same: what two texts leave by rounding.
const EQUAL_LENGTH_MM: f64 = 1e-6;

/// The passes of one cycle.
#[derive(Clone, Debug, PartialEq)]
pub struct CyclePasses {
    /// The block.
    pub place: BlockLocation,
    /// How many cuts it makes, one after a rapid or the cycle's start to the next rapid.
    pub count: usize,
    /// Where each move of them ends, in the frame of the run, mm.
    pub ends_mm: Vec<[f64; 3]>,
    /// Their length, mm.
    pub length_mm: f64,
    /// The largest distance of two levels next to each other, mm on the radius; nothing for fewer than two.
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

/// The cycles of two runs that are cut in other passes. Cycles that do not belong together are a difference of the paths.
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

/// Leaves the last pass of the cycles of these lines, and says what the passes were.
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

/// After the last step of the cycle that begins at a step; the step itself where none does.
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

/// The moves that stay, with rapids from the cycle's start and to its end.
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

/// A rapid between two places, in the state of a move.
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

/// One cut to the bottom of each plunge; nothing where the cuts are no plunges along one direction.
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

/// No cut goes beyond what stays, seen from where the cycle begins.
fn stays_within(moves: &[&ComparedMove], kept: &[ComparedMove], from: Vec3) -> bool {
    let boxes = || kept.iter().map(|own| own.curve.bounds());
    let from = from.to_array();
    let sides: [(f64, f64); 3] = std::array::from_fn(|axis| {
        let low = boxes().map(|one| one.min.to_array()[axis]).fold(f64::INFINITY, f64::min);
        let high = boxes().map(|one| one.max.to_array()[axis]).fold(f64::NEG_INFINITY, f64::max);
        // The side of the start is open: passes come from there.
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

/// What the passes of a cycle were.
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
                // Along Z at a level of X, along X at a level of Z.
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
