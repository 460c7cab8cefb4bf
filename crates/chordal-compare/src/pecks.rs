//! Holes drilled in pecks: joins the pecks to one cut from R to the bottom, and records them.
//!
//! The pecks of a hole are joined only if they remove the same material as one cut: they lie on one line, each is
//! deeper than the one before, the rapids between them stay within the drilled depth, the feed and the state of
//! spindle and coolant are constant, and nothing else happens between them. All other moves are kept and compared one
//! by one.

use std::collections::BTreeSet;

use chordal::geometry::{Curve, Line, Vec3};

use crate::COINCIDENT_MM;
use crate::category::Category;
use crate::course::{ComparedMove, ComparedMoveKind, ComparedRun, CutSpeed, RunStep};
use crate::difference::{BlockLocation, BlockRange, Difference};

/// Depths that differ by at most this are equal, mm: the rounding of the numbers in two texts.
const EQUAL_STEP_MM: f64 = 1e-6;

/// The pecks in which one hole is drilled.
#[derive(Clone, Debug, PartialEq)]
pub struct HolePecks {
    /// The block that drills the hole.
    pub place: BlockLocation,
    /// Where the first cut begins (R), in the frame of the run, mm.
    pub from_mm: [f64; 3],
    /// The bottom of the hole, in the frame of the run, mm.
    pub to_mm: [f64; 3],
    /// The depth below R at which each cut ends, mm.
    pub depths_mm: Vec<f64>,
    /// After each cut but the last, the depth below R of the tool's highest position, mm; negative above R.
    pub highest_mm: Vec<f64>,
    /// After each cut but the last, the depth below R at which the next one begins, mm.
    pub again_mm: Vec<f64>,
}

impl HolePecks {
    fn of(moved: &ComparedMove, line: Line) -> HolePecks {
        HolePecks {
            place: BlockLocation::from(&moved.origin),
            from_mm: line.start.to_array(),
            to_mm: line.end.to_array(),
            depths_mm: vec![moved.length_mm],
            highest_mm: Vec::new(),
            again_mm: Vec::new(),
        }
    }

    /// The largest depth of a single peck, mm.
    pub fn largest_step_mm(&self) -> f64 {
        let before = std::iter::once(&0.0).chain(&self.depths_mm);
        before.zip(&self.depths_mm).map(|(from, to)| to - from).fold(0.0, f64::max)
    }

    /// The largest distance above the previous depth at which the rapid into the hole stops, mm; `None` for a hole in
    /// one cut.
    pub fn clearance_mm(&self) -> Option<f64> {
        let ends = self.depths_mm.iter().zip(&self.again_mm);
        ends.map(|(depth, again)| depth - again).reduce(f64::max)
    }

    /// The largest height above R to which the tool retracts between cuts, mm: negative when it stays below R; `None`
    /// for a hole in one cut.
    pub fn above_r_mm(&self) -> Option<f64> {
        self.highest_mm.iter().map(|depth| -depth).reduce(f64::max)
    }

    /// Whether both are the same hole, regardless of the pecks.
    fn is_hole(&self, other: &HolePecks, tolerance_mm: f64) -> bool {
        let is_near = |one: [f64; 3], other: [f64; 3]| {
            Vec3::from_array(one).distance(Vec3::from_array(other)) <= tolerance_mm
        };
        is_near(self.from_mm, other.from_mm) && is_near(self.to_mm, other.to_mm)
    }

    fn has_same_steps(&self, other: &HolePecks) -> bool {
        let is_same = |one: &[f64], other: &[f64]| {
            one.len() == other.len()
                && one.iter().zip(other).all(|(one, other)| (one - other).abs() <= EQUAL_STEP_MM)
        };
        is_same(&self.depths_mm, &other.depths_mm)
            && is_same(&self.highest_mm, &other.highest_mm)
            && is_same(&self.again_mm, &other.again_mm)
    }
}

/// The pairs of holes that the two runs drill in different pecks. Holes that do not correspond are added as a
/// difference of the paths.
pub(crate) fn compare(
    holes: &[Vec<HolePecks>; 2],
    tolerance_mm: f64,
    differences: &mut Vec<Difference>,
) -> Vec<[HolePecks; 2]> {
    let tolerance_mm = tolerance_mm.max(EQUAL_STEP_MM);
    let mut others = Vec::new();
    for at in 0..holes[0].len().max(holes[1].len()) {
        let [one, other] = holes.each_ref().map(|holes| holes.get(at));
        match (one, other) {
            (Some(one), Some(other)) if one.is_hole(other, tolerance_mm) => {
                if !one.has_same_steps(other) {
                    others.push([one.clone(), other.clone()]);
                }
            }
            _ => {
                let blocks = [one, other].map(|hole| hole.map(|hole| BlockRange::at(hole.place)));
                let steps = blocks.map(|at| u64::from(at.is_some()));
                differences.push(Difference::new(Category::Path, blocks, steps, None));
                break;
            }
        }
    }
    others
}

/// Joins the pecks of all holes drilled by canned cycles in these lines; returns the pecks.
pub(crate) fn join(course: &mut ComparedRun, lines: &BTreeSet<u32>) -> Vec<HolePecks> {
    let mut holes = Vec::new();
    if lines.is_empty() {
        return holes;
    }
    let old = std::mem::take(&mut course.steps);
    let mut at = 0;
    while at < old.len() {
        let found = match &old[at] {
            RunStep::Move(moved) if lines.contains(&moved.origin.line) => hole(&old, at, moved),
            _ => None,
        };
        let Some((pecks, joined, next)) = found else {
            course.steps.push(old[at].clone());
            at += 1;
            continue;
        };
        course.steps.push(RunStep::Move(joined));
        holes.push(pecks);
        at = next;
    }
    holes
}

/// The hole whose first cut is the step at `at`: its pecks, the joined cut, and the index of the next step. `None`
/// when that step is not such a cut.
fn hole(
    steps: &[RunStep],
    at: usize,
    first: &ComparedMove,
) -> Option<(HolePecks, ComparedMove, usize)> {
    let is_cut = first.origin.cycle && first.kind == ComparedMoveKind::Cut && first.length_mm > 0.0;
    let line = line_of(first).filter(|_| is_cut)?;
    let down = (line.end - line.start).normalized()?;
    let depth = |point: Vec3| {
        let depth = (point - line.start).dot(down);
        let aside = (point - line.start - down * depth).length();
        (aside <= COINCIDENT_MM).then_some(depth)
    };
    let mut pecks = HolePecks::of(first, line);
    let mut bottom = line.end;
    let mut next = at + 1;
    while let Some((again, cut, after)) = step(steps, next, first) {
        let deepest = *pecks.depths_mm.last()?;
        let levels: Option<Vec<f64>> = again.iter().map(|point| depth(*point)).collect();
        let (Some(levels), Some(end)) = (levels, depth(cut.end)) else { break };
        let lowest = levels.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let highest = levels.iter().copied().fold(f64::INFINITY, f64::min);
        let Some(begin) = depth(cut.start) else { break };
        if lowest > deepest + COINCIDENT_MM || end <= deepest + COINCIDENT_MM {
            break;
        }
        pecks.depths_mm.push(end);
        pecks.highest_mm.push(highest);
        pecks.again_mm.push(begin);
        bottom = cut.end;
        next = after;
    }
    pecks.to_mm = bottom.to_array();
    let curve = Curve::Line(Line { start: line.start, end: bottom });
    let length_mm = line.start.distance(bottom);
    Some((pecks, ComparedMove { curve, length_mm, ..first.clone() }, next))
}

/// The next peck: rapids and a cut in the same block and state as the first cut. Returns the ends of the rapids, the
/// cut, and the index of the next step; `None` when there is no such peck.
fn step(steps: &[RunStep], from: usize, first: &ComparedMove) -> Option<(Vec<Vec3>, Line, usize)> {
    let mut ends = Vec::new();
    for (at, step) in steps.iter().enumerate().skip(from) {
        let RunStep::Move(moved) = step else { return None };
        let is_of_hole = moved.origin.cycle
            && moved.origin.span == first.origin.span
            && moved.origin.call == first.origin.call
            && (moved.state, moved.turn, moved.known) == (first.state, first.turn, first.known);
        let line = line_of(moved).filter(|_| is_of_hole)?;
        match moved.kind {
            ComparedMoveKind::Rapid => ends.push(line.end),
            ComparedMoveKind::Cut if !ends.is_empty() && is_feed(moved.feed, first.feed) => {
                return Some((ends, line, at + 1));
            }
            _ => return None,
        }
    }
    None
}

fn line_of(moved: &ComparedMove) -> Option<Line> {
    match moved.curve {
        Curve::Line(line) => Some(line),
        _ => None,
    }
}

/// Whether two feeds are equal up to rounding: they are computed from lengths and times.
fn is_feed(one: Option<CutSpeed>, other: Option<CutSpeed>) -> bool {
    match (one, other) {
        (Some(CutSpeed::Path(one)), Some(CutSpeed::Path(other))) => {
            (one - other).abs() <= 1e-9 * one.abs().max(other.abs())
        }
        (one, other) => one == other,
    }
}
