//! One leg with the corrections that reach into it, cut into pieces and cells.

use chordal_geometry::{Curve, ParamCurve};

use crate::Axes;
use crate::cell::{AxisArrays, Bounds, Cell, cell};
use crate::piece::{Jet, Piece};
use crate::smooth::bump::{Bump, SLOPE, TURN, bend, kink};
use crate::smooth::leg::{Leg, Part, cuts, turning};
use crate::smooth::{Node, Row};

/// Limits that differ by less are the same.
const SAME: f64 = 1e-12;

/// No cell goes over more pieces, so that a long row can be handed on in its middle.
const MOST_PIECES: u32 = 1024;
/// And over no more time, s, than this and one piece.
const MOST_S: f64 = 0.5;

/// Places of a leg nearer to each other than this share of its length are one.
const ROUNDING: f64 = 1e-12;

/// Where corrections change their polynomial.
#[derive(Clone, Copy, Debug)]
pub struct Break {
    at: f64,
    /// Changes of the third derivative of the axes.
    change: Axes,
    /// How many corrections begin, less those that end.
    begins: i32,
}

/// A stretch of a leg between two breaks, before it is a cell.
#[derive(Clone, Copy, Debug)]
struct Span {
    bounds: Bounds,
    from: f64,
    to: f64,
    pieces: u32,
}

/// Memory for one leg after the other.
#[derive(Debug, Default)]
pub struct Scratch {
    breaks: Vec<Break>,
    spans: Vec<Span>,
}

/// Adds a leg's pieces and cells to a row.
pub fn make<'a>(
    leg: &'a Leg,
    more: impl Iterator<Item = &'a Part>,
    nodes: impl Iterator<Item = &'a Node>,
    limits: &AxisArrays,
    Scratch { breaks, spans }: &mut Scratch,
    row: &mut Row,
) {
    if leg.begins_at_rest
        && let Some(last) = row.cells.last_mut()
    {
        last.ends_at_rest = true;
    }
    breaks.clear();
    spans.clear();
    let count = limits.count;
    let (mut correction, mut active) = corrections(leg, nodes, breaks, count);
    cut(leg, breaks);
    let mut parts = std::iter::once(&leg.part).chain(more).peekable();
    let mut from = leg.from;
    for index in 0..=breaks.len() {
        let to = breaks.get(index).map_or(leg.end(), |next| next.at);
        // Breaks that miss each other by rounding are one.
        let apart = to - from > ROUNDING * leg.length || index == breaks.len();
        if apart {
            let bounds = bounds(leg, &correction, from, to - from, count);
            let pieces = add_pieces(leg, &mut parts, &correction, from, to, row);
            let speed = leg.feed / bounds.rate.max(1.0);
            row.speeds.extend(std::iter::repeat_n(speed, pieces as usize));
            spans.push(Span { bounds, from, to, pieces });
            correction = ahead(&correction, to - from, count);
            from = to;
        }
        let Some(next) = breaks.get(index) else { break };
        active += next.begins;
        for (third, change) in correction[3].iter_mut().zip(next.change) {
            *third += change;
        }
        if active == 0 {
            // What is left is rounding.
            correction = [[0.0; 6]; 4];
        }
    }
    if let Some(whole) = brief(leg, spans, limits) {
        row.time_s += whole.length / whole.speed;
        return add(whole, &mut row.cells);
    }
    for span in spans {
        add_cell(leg, span, limits, row);
    }
}

/// One cell for a whole leg where that loses little time.
fn brief(leg: &Leg, spans: &[Span], limits: &AxisArrays) -> Option<Cell> {
    if spans.len() < 2 || !leg.may_be_brief() {
        return None;
    }
    let (mut bounds, mut pieces) = (spans[0].bounds, 0);
    for span in spans {
        bounds.widen(&span.bounds);
        pieces += span.pieces;
    }
    let cell = cell(leg.length, &bounds, leg.feed, limits);
    leg.is_brief_at(cell.speed).then_some(Cell { pieces, ..cell })
}

/// Adds the pieces between two places, which follow the moves as programmed. Says how many.
fn add_pieces<'a>(
    leg: &Leg,
    parts: &mut std::iter::Peekable<impl Iterator<Item = &'a Part>>,
    correction: &Jet,
    from: f64,
    to: f64,
    row: &mut Row,
) -> u32 {
    let (mut count, mut at) = (0, from);
    while at < to {
        let Some(part) = parts.peek() else { break };
        let end = part.from + part.length;
        let last = ends_with(leg, end);
        let until = if last { to } else { end.min(to) };
        if until > at {
            let jet = if at > from { ahead(correction, at - from, 6) } else { *correction };
            row.pieces.push(piece(leg, part, jet, at, until - at));
            count += 1;
        }
        at = until;
        if !last && end <= to {
            parts.next();
        }
    }
    count
}

fn add_cell(leg: &Leg, span: &Span, limits: &AxisArrays, row: &mut Row) {
    let Span { bounds, from, to, pieces } = *span;
    let mut cell = cell(to - from, &bounds, leg.feed, limits);
    if leg.jerk_share != [1.0; 2] {
        let middle = 0.5 * (from + to);
        let share = leg.jerk_share[usize::from(middle > leg.from + leg.length / 2.0)];
        cell.ability.efforts.iter_mut().for_each(|effort| effort.jerk *= share);
    }
    cell.pieces = pieces;
    row.time_s += cell.length / cell.speed;
    add(cell, &mut row.cells);
}

/// A part that ends here ends with its leg.
fn ends_with(leg: &Leg, end: f64) -> bool {
    end >= leg.end() * (1.0 - 1e-15) - 1e-15
}

/// Breaks of the leg's own: where its curvature or what it may use of the jerk changes.
fn cut(leg: &Leg, breaks: &mut Vec<Break>) {
    let mut take = |at: f64| breaks.push(Break { at, change: [0.0; 6], begins: 0 });
    if let Some(curve) = leg.curve.as_deref() {
        let count = cuts(curve);
        (1..count).for_each(|cut| take(leg.from + leg.length * cut as f64 / count as f64));
    }
    if leg.jerk_share != [1.0; 2] {
        take(leg.from + leg.length / 2.0);
    }
    breaks.sort_unstable_by(|a, b| a.at.total_cmp(&b.at));
}

/// The sum of the corrections at the start of a leg, how many there are, and the places in the
/// leg at which they change.
fn corrections<'a>(
    leg: &Leg,
    nodes: impl Iterator<Item = &'a Node>,
    breaks: &mut Vec<Break>,
    count: usize,
) -> (Jet, i32) {
    // Breaks that miss an end of the leg by rounding are at the end.
    let rounding = ROUNDING * leg.length;
    let (from, to) = (leg.from + rounding, leg.end() - rounding);
    let mut jet = [[0.0; 6]; 4];
    let mut active = 0;
    for node in nodes {
        let w = leg.from - node.at;
        // A node is at one end of a leg or outside: it lies before the leg or after it.
        let side = 0.5 * (from + to) - node.at;
        let mut take =
            |step: &Axes, h: f64, bump: fn(f64, f64, f64) -> Bump, turns: &[(f64, f64)]| {
                if h <= 0.0 || node.at + h <= from {
                    return;
                }
                // The breaks below are asked in the same words, so that none is lost by rounding.
                let passed = |place: f64| node.at + place * h <= from;
                if passed(-1.0) {
                    active += 1;
                    let inside = match (passed(-TURN), passed(TURN)) {
                        (false, _) => -0.5 * (1.0 + TURN),
                        (_, true) => 0.5 * (1.0 + TURN),
                        _ => 0.5 * TURN.copysign(side),
                    };
                    for (row, factor) in jet.iter_mut().zip(bump(w, inside * h, h)) {
                        for (value, step) in row.iter_mut().zip(step).take(count) {
                            *value += step * factor;
                        }
                    }
                }
                for (place, jump) in turns {
                    let at = node.at + place * h;
                    if at > from && at < to {
                        let change = step.map(|step| step * jump);
                        let begins = if *place == -1.0 { 1 } else { -i32::from(*place == 1.0) };
                        breaks.push(Break { at, change, begins });
                    }
                }
            };
        let h = node.kink_half;
        let k = 1.0 / (h * h);
        take(&node.step.kink, h, kink, &[(-1.0, k), (1.0, k)]);
        let h = node.bend_half;
        let m = SLOPE / h;
        take(&node.step.bend, h, bend, &[(-1.0, -m), (-TURN, 2.0 * m), (TURN, -2.0 * m), (1.0, m)]);
    }
    (jet, active)
}

/// A jet of polynomials of the third degree, further on.
fn ahead(jet: &Jet, way: f64, count: usize) -> Jet {
    let [x, d1, d2, d3] = jet;
    let mut next = *jet;
    for axis in 0..count {
        next[0][axis] =
            x[axis] + way * (d1[axis] + way * (d2[axis] / 2.0 + way * (d3[axis] / 6.0)));
        next[1][axis] = d1[axis] + way * (d2[axis] + way * (d3[axis] / 2.0));
        next[2][axis] = d2[axis] + way * d3[axis];
    }
    next
}

fn piece(leg: &Leg, part: &Part, mut start: Jet, at: f64, length: f64) -> Piece {
    let done = at - part.from;
    let [position, first, ..] = &mut start;
    for (axis, direction) in part.direction.iter().enumerate() {
        position[axis] += part.start[axis] + direction * done;
        first[axis] += direction;
    }
    Piece {
        length,
        base: leg.curve.as_deref().map(|curve| (*curve, at - leg.from)),
        start,
        tag: part.tag,
    }
}

/// Bounds of the derivatives on a piece of a leg.
fn bounds(leg: &Leg, correction: &Jet, from: f64, length: f64, count: usize) -> Bounds {
    let direction = &leg.part.direction;
    let [_, d1, d2, d3] = correction;
    let mut even = [[0.0; 6]; 3];
    let mut rates = [[0.0_f64; 3]; 2];
    for axis in 0..count {
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
    if let Some(curve) = leg.curve.as_deref() {
        let at = from - leg.from;
        let eased = d3.iter().any(|third| *third != 0.0);
        if eased && let Some(near) = near_bounds(curve, at, length, correction, direction) {
            return near;
        }
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

/// Bounds on a short eased piece of a curve, met by looking at it: the curvature of the curve and
/// its correction mostly cancel there.
fn near_bounds(
    curve: &Curve,
    at: f64,
    length: f64,
    correction: &Jet,
    direction: &Axes,
) -> Option<Bounds> {
    const PROBES: u32 = 4;
    // Between two probes a sine exceeds both by its size times this.
    const MOST_TURN: f64 = 0.8;
    let step = length / f64::from(PROBES);
    let curvature = curve.jet_at(at)[2].length().max(curve.jet_at(at + length)[2].length());
    if curvature * length > MOST_TURN {
        return None;
    }
    let between = 1.1 * (curvature * step / 2.0).powi(2) / 2.0;
    let mut even = [[0.0_f64; 6]; 3];
    let mut rate = 0.0_f64;
    for probe in 0..=PROBES {
        let way = step * f64::from(probe);
        let bent = curve.jet_at(at + way);
        let eased = ahead(correction, way, 6);
        let mut first = [0.0; 3];
        for order in 0..3 {
            let vector = bent[order + 1].to_array();
            for axis in 0..6 {
                let mut value = eased[order + 1][axis];
                if axis < 3 {
                    value += vector[axis];
                } else if order == 0 {
                    value += direction[axis];
                }
                let margin = between * curvature.powi(order as i32);
                even[order][axis] = even[order][axis].max(value.abs() + margin);
                if order == 0 && axis < 3 {
                    first[axis] = value;
                }
            }
        }
        rate = rate.max(first.iter().map(|value| value * value).sum::<f64>().sqrt());
    }
    Some(Bounds { even, turning: None, rate: rate + between })
}

/// Adds a cell to a row, or its length to the last one where the limits are the same.
fn add(cell: Cell, cells: &mut Vec<Cell>) {
    if let Some(last) = cells.last_mut()
        && !last.ends_at_rest
        && last.pieces < MOST_PIECES
        && last.length < MOST_S * last.speed
        && near(last.speed, cell.speed)
        && last.ability.knees.iter().zip(&cell.ability.knees).all(|(a, b)| near(*a, *b))
        && last
            .ability
            .efforts
            .iter()
            .zip(&cell.ability.efforts)
            .all(|(a, b)| near(a.acceleration, b.acceleration) && near(a.jerk, b.jerk))
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
