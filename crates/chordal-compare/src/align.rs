//! Which steps of two runs belong together.

use std::ops::Range;

use chordal::geometry::{Curve, ParamCurve, Vec3};
use imara_diff::{Algorithm, Diff, InternedInput, Interner};

use crate::course::{Course, Event, Moved, Step, Way};

/// A stretch of both runs.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Region {
    /// Step for step the same, as far as the grid tells.
    Matched(Range<usize>, Range<usize>),
    /// Everything else between two of those.
    Gap(Range<usize>, Range<usize>),
}

/// What is the same on both sides is the same here. Places are rounded to a grid, so that rounding
/// does not keep moves from finding each other; how far apart they are is measured afterwards.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
enum Token {
    Line { ends: [i64; 6], turn: [i64; 6] },
    Curve { ends: [i64; 6], middle: [i64; 3], length: i64, turn: [i64; 6] },
    Unknown { rapid: bool },
    Tool,
    Dwell,
    Stop,
    Probed,
    Output(String),
}

/// Regions in order, gaps where nothing matches; together they hold every step once.
pub(crate) fn align(a: &Course, b: &Course, grid_mm: f64) -> Vec<Region> {
    let (before, after) = (Vec::new(), Vec::new());
    let interner = Interner::new(a.steps.len() + b.steps.len());
    let mut input = InternedInput { before, after, interner };
    input.update_before(a.steps.iter().map(|step| token(a, step, grid_mm)));
    input.update_after(b.steps.iter().map(|step| token(b, step, grid_mm)));
    let diff = Diff::compute(Algorithm::Histogram, &input);
    let mut regions = Vec::new();
    let (mut at_a, mut at_b) = (0, 0);
    let matched = |at_a: &mut usize, at_b: &mut usize, to_a: usize, to_b: usize| {
        let region = Region::Matched(*at_a..to_a, *at_b..to_b);
        (*at_a, *at_b) = (to_a, to_b);
        (!matches!(&region, Region::Matched(range, _) if range.is_empty())).then_some(region)
    };
    for hunk in diff.hunks() {
        let [gap_a, gap_b] = [&hunk.before, &hunk.after]
            .map(|range| range.start as usize..range.end as usize);
        regions.extend(matched(&mut at_a, &mut at_b, gap_a.start, gap_b.start));
        (at_a, at_b) = (gap_a.end, gap_b.end);
        regions.push(Region::Gap(gap_a, gap_b));
    }
    regions.extend(matched(&mut at_a, &mut at_b, a.steps.len(), b.steps.len()));
    regions
}

fn token(course: &Course, step: &Step, grid_mm: f64) -> Token {
    match step {
        Step::Move(moved) => move_token(course, moved, grid_mm),
        Step::Event { what, .. } => match what {
            Event::Tool(_) => Token::Tool,
            Event::Dwell(_) => Token::Dwell,
            Event::Stop { .. } => Token::Stop,
            Event::Probed { .. } => Token::Probed,
            Event::Output(text) => Token::Output(text.clone()),
        },
    }
}

fn move_token(course: &Course, moved: &Moved, grid_mm: f64) -> Token {
    if !moved.known {
        return Token::Unknown { rapid: moved.way != Way::Cut };
    }
    // Rounding saturates: a place that is no number is at zero, one beyond all bounds at the bound.
    let grid = |value: f64| (value / grid_mm).round() as i64;
    let place = |place: Vec3| place.to_array().map(grid);
    let (start, end) = (place(moved.curve.start()), place(moved.curve.end()));
    let ends = [start[0], start[1], start[2], end[0], end[1], end[2]];
    // An angle moves what is turned by about a tenth of a metre.
    let angle = |value: f64| grid(100.0 * value);
    let [from, to] = course.turn(moved).map(|turn| turn.map(angle));
    let turn = [from[0], from[1], from[2], to[0], to[1], to[2]];
    match moved.curve {
        Curve::Line(_) => Token::Line { ends, turn },
        curve => {
            let middle = place(curve.point_at(moved.length_mm / 2.0));
            Token::Curve { ends, middle, length: grid(moved.length_mm), turn }
        }
    }
}
