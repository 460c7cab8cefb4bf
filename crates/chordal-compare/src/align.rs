//! Finds which steps of two runs correspond.

use std::ops::Range;

use chordal::geometry::{Curve, ParamCurve, Vec3};
use chordal::machine::PerAxis;
use imara_diff::{Algorithm, Diff, InternedInput, Interner, Token as InternedToken};

use crate::course::{ComparedMove, ComparedMoveKind, ComparedRun, RunEvent, RunStep};

/// A range of steps in both runs.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum AlignedRegion {
    /// Steps that are equal one by one, up to the grid.
    Matched(Range<usize>, Range<usize>),
    /// A rapid in both runs, each with all its straight parts.
    Rapid(Range<usize>, Range<usize>),
    /// Everything between two of those.
    Gap(Range<usize>, Range<usize>),
}

/// The key by which steps are matched. Positions are rounded to a grid, so that rounding errors do not prevent a
/// match; the exact distance is measured afterwards.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
enum AlignmentToken {
    Line {
        ends: PerAxis<i64>,
        turn: PerAxis<i64>,
    },
    Curve {
        ends: PerAxis<i64>,
        middle: [i64; 3],
        length: i64,
        turn: PerAxis<i64>,
    },
    /// A move whose position is unknown: it is matched by its displacement.
    Unknown {
        rapid: bool,
        length_cells: [i64; 3],
    },
    Tool,
    Dwell,
    Stop,
    Probed,
    Output(String),
    ReadyTool,
    Code(String),
    Written(String),
    Variable(u32),
    Message,
    Alarm,
    Deletable,
}

/// The correspondence between the steps of two runs.
#[derive(Debug, Default)]
pub(crate) struct StepAlignment {
    /// Regions in order; together they contain every step once.
    pub(crate) regions: Vec<AlignedRegion>,
    /// Sequences of moves in gaps that both runs make, but at different times: pairs of equally many equal steps.
    pub(crate) moved: Vec<[Vec<usize>; 2]>,
}

/// Matches steps that do the same; positions are rounded to the grid.
pub(crate) fn align(a: &ComparedRun, b: &ComparedRun, grid_mm: f64) -> StepAlignment {
    let (before, after) = (Vec::new(), Vec::new());
    let interner = Interner::new(a.steps.len() + b.steps.len());
    let mut input = InternedInput { before, after, interner };
    input.update_before(a.steps.iter().map(|step| token(a, step, grid_mm)));
    input.update_after(b.steps.iter().map(|step| token(b, step, grid_mm)));
    let diff = Diff::compute(Algorithm::Histogram, &input);
    let mut regions = Vec::new();
    for (is_matched, before, after) in aligned_ranges(&diff, [a.steps.len(), b.steps.len()]) {
        regions.push(if is_matched {
            AlignedRegion::Matched(before, after)
        } else {
            AlignedRegion::Gap(before, after)
        });
    }
    let moved = moved([a, b], &input, &regions);
    StepAlignment { regions, moved }
}

/// Matches the steps one by one when both runs have the same number of the same kinds in the same order; `None`
/// otherwise. Moves from or to unknown positions are left out.
pub(crate) fn in_step(
    a: &ComparedRun,
    b: &ComparedRun,
    with_unknown: bool,
) -> Option<StepAlignment> {
    // All parts of a rapid form one group.
    let groups = |course: &ComparedRun| -> Vec<Range<usize>> {
        let mut groups: Vec<Range<usize>> = Vec::new();
        for (at, step) in course.steps.iter().enumerate() {
            if let RunStep::Move(moved) = step {
                if !moved.known {
                    continue;
                }
                let before = groups.last_mut().filter(|group| group.end == at);
                if let Some(group) = before
                    && moved.kind != ComparedMoveKind::Cut
                    && course.moved(at - 1).is_some_and(|last| last.command == moved.command)
                {
                    group.end = at + 1;
                    continue;
                }
            }
            groups.push(at..at + 1);
        }
        groups
    };
    let (of_a, of_b) = (groups(a), groups(b));
    let is_alike =
        |(at, to): (&Range<usize>, &Range<usize>)| match (&a.steps[at.start], &b.steps[to.start]) {
            (RunStep::Move(one), RunStep::Move(other)) => {
                (one.kind == ComparedMoveKind::Cut) == (other.kind == ComparedMoveKind::Cut)
            }
            (RunStep::Event { what: one, .. }, RunStep::Event { what: other, .. }) => {
                std::mem::discriminant(one) == std::mem::discriminant(other)
            }
            _ => false,
        };
    if of_a.len() != of_b.len() || !of_a.iter().zip(&of_b).all(is_alike) {
        return None;
    }
    let regions = of_a.into_iter().zip(of_b).map(|(at, to)| {
        let is_rapid = a.moved(at.start).is_some_and(|moved| moved.kind != ComparedMoveKind::Cut);
        if is_rapid { AlignedRegion::Rapid(at, to) } else { AlignedRegion::Matched(at, to) }
    });
    let mut regions: Vec<AlignedRegion> = regions.collect();
    // For a move from an unknown position everything but the path is compared, at its first step.
    let unknown = [a, b].map(|course| {
        let moves = (0..course.steps.len()).filter_map(|at| Some((at, course.moved(at)?)));
        let mut first: Vec<(usize, u32)> = moves
            .filter(|(_, moved)| !moved.known)
            .map(|(at, moved)| (at, moved.command))
            .collect();
        first.dedup_by_key(|(_, command)| *command);
        first.into_iter().map(|(at, _)| at).collect::<Vec<usize>>()
    });
    if with_unknown && unknown[0].len() == unknown[1].len() {
        let pairs = unknown[0].iter().zip(&unknown[1]);
        regions.extend(pairs.map(|(at, to)| AlignedRegion::Matched(*at..at + 1, *to..to + 1)));
    }
    Some(StepAlignment { regions, moved: Vec::new() })
}

/// The ranges that are equal and those that differ, in order.
fn aligned_ranges(diff: &Diff, ends: [usize; 2]) -> Vec<(bool, Range<usize>, Range<usize>)> {
    let mut all = Vec::new();
    let mut at = [0, 0];
    let hunks = diff.hunks().map(|hunk| [hunk.before, hunk.after]);
    let hunks = hunks.map(|hunk| hunk.map(|range| range.start as usize..range.end as usize));
    for [before, after] in hunks.chain([ends.map(|end| end..end)]) {
        if at[0] < before.start {
            all.push((true, at[0]..before.start, at[1]..after.start));
        }
        at = [before.end, after.end];
        if !(before.is_empty() && after.is_empty()) {
            all.push((false, before, after));
        }
    }
    all
}

/// Moves that are missing in one gap and present in another: found by a second comparison without the matched steps.
fn moved(
    courses: [&ComparedRun; 2],
    input: &InternedInput<AlignmentToken>,
    regions: &[AlignedRegion],
) -> Vec<[Vec<usize>; 2]> {
    let left = [0, 1].map(|side: usize| -> Vec<usize> {
        let gaps = regions.iter().filter_map(|region| match region {
            AlignedRegion::Gap(a, b) => Some([a, b][side].clone()),
            AlignedRegion::Matched(..) | AlignedRegion::Rapid(..) => None,
        });
        let is_known = |at: &usize| courses[side].moved(*at).is_some_and(|moved| moved.known);
        gaps.flatten().filter(is_known).collect()
    });
    if left.iter().any(Vec::is_empty) {
        return Vec::new();
    }
    let tokens = |side: usize, all: &[InternedToken]| -> Vec<InternedToken> {
        left[side].iter().map(|at| all[*at]).collect()
    };
    let (before, after) = (tokens(0, &input.before), tokens(1, &input.after));
    let mut diff = Diff::default();
    diff.compute_with(Algorithm::Histogram, &before, &after, input.interner.num_tokens());
    let same = aligned_ranges(&diff, [before.len(), after.len()]).into_iter();
    let same = same.filter(|(is_matched, ..)| *is_matched);
    let same = same.map(|(_, a, b)| [left[0][a].to_vec(), left[1][b].to_vec()]);
    // Rapids alone may be equal by chance: to the same retract plane or the same tool change position.
    let has_cut = |[moves, _]: &[Vec<usize>; 2]| {
        let mut moves = moves.iter().filter_map(|at| courses[0].moved(*at));
        moves.any(|moved| moved.kind == ComparedMoveKind::Cut)
    };
    same.filter(has_cut).collect()
}

fn token(course: &ComparedRun, step: &RunStep, grid_mm: f64) -> AlignmentToken {
    match step {
        RunStep::Move(moved) => move_token(course, moved, grid_mm),
        RunStep::Event { what, .. } => match what {
            RunEvent::Tool(_) => AlignmentToken::Tool,
            RunEvent::Dwell(_) => AlignmentToken::Dwell,
            RunEvent::Stop { .. } => AlignmentToken::Stop,
            RunEvent::Probed { .. } => AlignmentToken::Probed,
            RunEvent::Output(text) => AlignmentToken::Output(text.clone()),
            RunEvent::ReadyTool(_) => AlignmentToken::ReadyTool,
            RunEvent::Code(words) => AlignmentToken::Code(words.clone()),
            RunEvent::Written { name, .. } => AlignmentToken::Written(name.clone()),
            RunEvent::Variable { number, .. } => AlignmentToken::Variable(*number),
            RunEvent::Message(_) => AlignmentToken::Message,
            RunEvent::Alarm { .. } => AlignmentToken::Alarm,
            RunEvent::Deletable(_) => AlignmentToken::Deletable,
        },
    }
}

fn move_token(course: &ComparedRun, moved: &ComparedMove, grid_mm: f64) -> AlignmentToken {
    // The conversion saturates: NaN becomes zero, and values beyond the range become its bounds.
    let grid = |value: f64| (value / grid_mm).round() as i64;
    let place = |place: Vec3| place.to_array().map(grid);
    if !moved.known {
        let route = place(moved.curve.end() - moved.curve.start());
        return AlignmentToken::Unknown {
            rapid: moved.kind != ComparedMoveKind::Cut,
            length_cells: route,
        };
    }
    let (start, end) = (place(moved.curve.start()), place(moved.curve.end()));
    let ends = [start[0], start[1], start[2], end[0], end[1], end[2]];
    // An angle counts as the movement of a point 100 mm from the axis.
    let angle = |value: f64| grid(100.0 * value);
    let [from, to] = course.turn(moved).map(|turn| turn.map(angle));
    let turn = [from[0], from[1], from[2], to[0], to[1], to[2]];
    match moved.curve {
        Curve::Line(_) => AlignmentToken::Line { ends, turn },
        curve => {
            let middle = place(curve.point_at(moved.length_mm / 2.0));
            AlignmentToken::Curve { ends, middle, length: grid(moved.length_mm), turn }
        }
    }
}
