//! One leg with the corrections that reach into it, cut into pieces and cells.

use crate::Axes;
use crate::cell::{AxisArrays, Bounds, Cell, cell};
use crate::piece::{Jet, Piece};
use crate::smooth::bump::{Bump, TURN, bend, kink};
use crate::smooth::leg::{Leg, Part, cuts, turning};
use crate::smooth::{Node, Row};

/// Limits that differ by less are the same.
const SAME: f64 = 1e-12;

/// Adds a leg's pieces and cells to a row.
pub fn make<'a>(
    leg: &'a Leg,
    more: impl Iterator<Item = &'a Part>,
    nodes: impl Iterator<Item = &'a Node> + Clone,
    limits: &AxisArrays,
    breaks: &mut Vec<f64>,
    row: &mut Row,
) {
    if leg.begins_at_rest
        && let Some(last) = row.cells.last_mut()
    {
        last.ends_at_rest = true;
    }
    find_breaks(leg, nodes.clone(), breaks);
    let mut parts = std::iter::once(&leg.part).chain(more).peekable();
    let mut from = leg.from;
    for index in 0..=breaks.len() {
        let to = breaks.get(index).copied().unwrap_or(leg.end());
        if to <= from {
            continue;
        }
        let middle = 0.5 * (from + to);
        let correction = corrections(nodes.clone(), from, middle);
        let mut count = 0;
        let mut at = from;
        // The pieces follow the moves as programmed, the cell does not care about them.
        while at < to {
            let Some(part) = parts.peek() else { break };
            let end = part.from + part.length;
            let last = parts_end(leg, end);
            let until = if last { to } else { end.min(to) };
            if until > at {
                let jet =
                    if at == from { correction } else { corrections(nodes.clone(), at, middle) };
                row.pieces.push_back(piece(leg, part, jet, at, until - at));
                count += 1;
            }
            at = until;
            if !last && end <= to {
                parts.next();
            } else if until >= to {
                break;
            }
        }
        let mut cell =
            cell(to - from, &bounds(leg, &correction, from, to - from), leg.feed, limits);
        let share = leg.jerk_share[usize::from(middle > leg.from + leg.length / 2.0)];
        cell.ability.low.jerk *= share;
        cell.ability.high.jerk *= share;
        cell.pieces = count;
        add(cell, &mut row.cells);
        from = to;
    }
}

/// The part ends with its leg.
fn parts_end(leg: &Leg, end: f64) -> bool {
    end >= leg.end() * (1.0 - 1e-15) - 1e-15
}

fn find_breaks<'a>(leg: &Leg, nodes: impl Iterator<Item = &'a Node>, breaks: &mut Vec<f64>) {
    breaks.clear();
    let (from, to) = (leg.from, leg.end());
    let mut take = |at: f64| {
        if at > from && at < to {
            breaks.push(at);
        }
    };
    for node in nodes {
        for half in [node.kink_half, node.bend_half, TURN * node.bend_half] {
            if half > 0.0 {
                take(node.at - half);
                take(node.at + half);
            }
        }
    }
    if let Some(curve) = &leg.curve {
        let count = cuts(curve);
        (1..count).for_each(|cut| take(from + leg.length * cut as f64 / count as f64));
    }
    if leg.jerk_share != [1.0; 2] {
        take(from + leg.length / 2.0);
    }
    breaks.sort_unstable_by(f64::total_cmp);
}

/// The sum of the corrections at a place and their derivatives there, as they are from there to
/// beyond `middle`.
fn corrections<'a>(nodes: impl Iterator<Item = &'a Node>, at: f64, middle: f64) -> Jet {
    let mut jet = [[0.0; 6]; 4];
    let mut add = |step: &Axes, bump: Bump| {
        for (row, factor) in jet.iter_mut().zip(bump) {
            for (value, step) in row.iter_mut().zip(step) {
                *value += step * factor;
            }
        }
    };
    for node in nodes {
        let (w, side) = (at - node.at, middle - node.at);
        if side.abs() < node.kink_half {
            add(&node.step.kink, kink(w, side, node.kink_half));
        }
        if side.abs() < node.bend_half {
            add(&node.step.bend, bend(w, side, node.bend_half));
        }
    }
    jet
}

fn piece(leg: &Leg, part: &Part, mut start: Jet, at: f64, length: f64) -> Piece {
    let done = at - part.from;
    for axis in 0..6 {
        start[0][axis] += part.start[axis] + part.direction[axis] * done;
        start[1][axis] += part.direction[axis];
    }
    Piece { length, base: leg.curve.map(|curve| (curve, at - leg.from)), start, tag: part.tag }
}

/// Bounds of the derivatives on a piece of a leg.
fn bounds(leg: &Leg, correction: &Jet, from: f64, length: f64) -> Bounds {
    let direction = &leg.part.direction;
    let [_, d1, d2, d3] = correction;
    let mut even = [[0.0; 6]; 3];
    let mut rates = [[0.0_f64; 3]; 2];
    for axis in 0..6 {
        // The first derivative is a parabola, within the triangle of these three.
        let first = direction[axis] + d1[axis];
        let control = first + d2[axis] * length / 2.0;
        let second = d2[axis] + d3[axis] * length;
        let last = control + second * length / 2.0;
        even[0][axis] = first.abs().max(control.abs()).max(last.abs());
        even[1][axis] = d2[axis].abs().max(second.abs());
        even[2][axis] = d3[axis].abs();
        for (sum, value) in rates[axis / 3].iter_mut().zip([first, control, last]) {
            *sum += value * value;
        }
    }
    let largest = |squares: [f64; 3]| squares.into_iter().fold(0.0, f64::max).sqrt();
    let mut rate = largest(rates[0]);
    let mut turns = None;
    if let Some(curve) = &leg.curve {
        let at = from - leg.from;
        let (turning, along) = turning(curve, at, at + length);
        for (value, along) in even[0].iter_mut().zip(along) {
            *value += along;
        }
        rate += 1.0;
        turns = Some(turning);
    } else if direction[..3] == [0.0; 3] {
        // Rotary axes alone: the feed counts them.
        rate = largest(rates[1]);
    }
    Bounds { even, turning: turns, rate }
}

/// Adds a cell to a row, or its length to the last one where the limits are the same.
fn add(cell: Cell, cells: &mut Vec<Cell>) {
    if let Some(last) = cells.last_mut()
        && !last.ends_at_rest
        && near(last.speed, cell.speed)
        && near(last.ability.knee, cell.ability.knee)
        && near(last.ability.low.acceleration, cell.ability.low.acceleration)
        && near(last.ability.low.jerk, cell.ability.low.jerk)
        && near(last.ability.high.acceleration, cell.ability.high.acceleration)
        && near(last.ability.high.jerk, cell.ability.high.jerk)
    {
        last.length += cell.length;
        last.pieces += cell.pieces;
        return;
    }
    cells.push(cell);
}

fn near(a: f64, b: f64) -> bool {
    a == b || (a - b).abs() <= SAME * a.abs()
}
