//! One leg with the corrections that reach into it, cut into pieces and intervals.

use chordal_geometry::{AXES, Curve, ParamCurve};

use crate::AxisValues;
use crate::corner_blend::blend_sum::BlendSum;
use crate::corner_blend::leg::{LegPart, PathLeg, cuts, turning};
use crate::corner_blend::path_span::PathPart;
use crate::corner_blend::{BlendNode, LookAheadQueue};
use crate::path_limits::{AxisArrays, DerivativeBounds, limit_interval};
use crate::piece::AxisJet;
use crate::ramp_profile::LimitInterval;

/// Limits that differ by less are the same.
const EQUAL_LIMIT_SHARE: f64 = 1e-12;

/// No interval goes over more pieces, so that a long window can be emitted in its middle.
const MAX_INTERVAL_PIECES: u32 = 1024;
/// And over no more time, s, than this and one piece.
const MAX_INTERVAL_S: f64 = 0.5;

/// Places nearer to each other than this share of a leg are one.
const POSITION_ROUNDING_SHARE: f64 = 1e-12;

/// A part of a leg between two breaks, before it is an interval.
#[derive(Clone, Copy, Debug)]
struct BlendInterval {
    bounds: DerivativeBounds,
    from: f64,
    to: f64,
    pieces: u32,
}

/// Memory for one leg after the other.
#[derive(Debug, Default)]
pub struct IntervalScratch(Vec<BlendInterval>);

/// Adds a leg's pieces and intervals to a look-ahead window. The corrections have entered it, and go to its end; `nodes` are those
/// that reach into it.
pub fn make<'a, P: PathPart>(
    leg: &'a PathLeg,
    more: impl Iterator<Item = &'a LegPart>,
    nodes: impl Iterator<Item = &'a BlendNode> + Clone,
    limits: &AxisArrays,
    corrections: &mut BlendSum,
    IntervalScratch(spans): &mut IntervalScratch,
    queue: &mut LookAheadQueue<P>,
) {
    if leg.begins_at_rest
        && let Some(last) = queue.intervals.last_mut()
    {
        last.ends_at_rest = true;
    }
    spans.clear();
    cut(leg, corrections);
    let mut parts = std::iter::once(&leg.part).chain(more).peekable();
    let (mut from, end) = (leg.from, leg.end());
    let rounding = rounding(leg);
    loop {
        let next = corrections.next_before(end - rounding);
        let to = next.unwrap_or(end);
        // Breaks that miss each other by rounding are one.
        if to - from > rounding || next.is_none() {
            corrections.refresh([from, from + rounding], to - from, nodes.clone());
            let bounds = bounds(leg, corrections, from, to - from);
            let jet = corrections.jet();
            let pieces = add_pieces(leg, &mut parts, jet, from, to, &mut queue.pieces);
            if queue.keeps_speeds {
                let speed = leg.feed / bounds.rate.max(1.0);
                queue.speeds.extend(std::iter::repeat_n(speed, pieces as usize));
            }
            spans.push(BlendInterval { bounds, from, to, pieces });
            corrections.advance(to - from);
            from = to;
        }
        if next.is_none() {
            break;
        }
        corrections.pass();
    }
    if let Some(mut whole) = brief(leg, spans, limits) {
        whole.pieces = join(&mut queue.pieces, whole.pieces);
        queue.time_s += whole.length / whole.speed;
        return add(whole, &mut queue.intervals);
    }
    for span in spans {
        add_interval(leg, span, limits, queue);
    }
}

/// One interval for a whole leg where that loses little time.
fn brief(leg: &PathLeg, spans: &[BlendInterval], limits: &AxisArrays) -> Option<LimitInterval> {
    if spans.len() < 2 || !leg.may_be_brief() {
        return None;
    }
    let (mut bounds, mut pieces) = (spans[0].bounds, 0);
    for span in spans {
        bounds.widen(&span.bounds);
        pieces += span.pieces;
    }
    let interval = limit_interval(leg.length, &bounds, leg.feed, limits);
    leg.is_brief_at(interval.speed).then_some(LimitInterval { pieces, ..interval })
}

/// Places of a leg that are nearer to each other are one: it is what rounding leaves between them.
pub fn rounding(leg: &PathLeg) -> f64 {
    POSITION_ROUNDING_SHARE * leg.length + 4.0 * f64::EPSILON * leg.end()
}

/// Joins the last so many pieces where one says as much as two. Says how many are left.
fn join<P: PathPart>(pieces: &mut Vec<P>, count: u32) -> u32 {
    let begin = pieces.len() - count as usize;
    let mut last = begin;
    for index in begin + 1..pieces.len() {
        let next = pieces[index];
        if !pieces[last].take_in(&next) {
            last += 1;
            pieces[last] = next;
        }
    }
    pieces.truncate(last + 1);
    (pieces.len() - begin) as u32
}

/// Adds the pieces between two places, which follow the moves as programmed. Says how many.
fn add_pieces<'a, P: PathPart>(
    leg: &PathLeg,
    parts: &mut std::iter::Peekable<impl Iterator<Item = &'a LegPart>>,
    correction: &AxisJet,
    from: f64,
    to: f64,
    pieces: &mut Vec<P>,
) -> u32 {
    let (mut count, mut at) = (0, from);
    while at < to {
        let Some(part) = parts.peek() else { break };
        let end = part.from + part.length;
        let last = ends_with(leg, end);
        let until = if last { to } else { end.min(to) };
        if until > at {
            P::add(pieces, leg, part, (correction, at - from), [at, until]);
            count += 1;
        }
        at = until;
        if !last && end <= to {
            parts.next();
        }
    }
    count
}

fn add_interval(
    leg: &PathLeg,
    span: &BlendInterval,
    limits: &AxisArrays,
    queue: &mut LookAheadQueue<impl PathPart>,
) {
    let BlendInterval { bounds, from, to, pieces } = *span;
    let mut interval = limit_interval(to - from, &bounds, leg.feed, limits);
    if leg.jerk_share != [1.0; 2] {
        let middle = 0.5 * (from + to);
        let share = leg.jerk_share[usize::from(middle > leg.from + leg.length / 2.0)];
        interval.ability.efforts.iter_mut().for_each(|effort| effort.jerk *= share);
    }
    interval.pieces = pieces;
    queue.time_s += interval.length / interval.speed;
    add(interval, &mut queue.intervals);
}

/// A part that ends here ends with its leg.
fn ends_with(leg: &PathLeg, end: f64) -> bool {
    end >= leg.end() * (1.0 - 1e-15) - 1e-15
}

/// Breaks of the leg's own: where its curvature or what it may use of the jerk changes.
fn cut(leg: &PathLeg, corrections: &mut BlendSum) {
    if let Some(curve) = leg.curve.as_deref() {
        let count = cuts(curve);
        (1..count)
            .for_each(|cut| corrections.cut(leg.from + leg.length * cut as f64 / count as f64));
    }
    if leg.jerk_share != [1.0; 2] {
        corrections.cut(leg.from + leg.length / 2.0);
    }
}

/// Bounds of the derivatives on a piece of a leg.
fn bounds(leg: &PathLeg, corrections: &BlendSum, from: f64, length: f64) -> DerivativeBounds {
    let (direction, correction) = (&leg.part.direction, corrections.jet());
    let [_, d1, d2, d3] = correction;
    if let Some(curve) = leg.curve.as_deref()
        && corrections.are_there()
        && let Some(near) = near_bounds(curve, from - leg.from, length, correction, direction)
    {
        return near;
    }
    let mut even = [[0.0; AXES]; 3];
    let mut rates = [[0.0_f64; 3]; 2];
    let mut axes = leg.axes.max(corrections.axes());
    for axis in 0..axes {
        // The first derivative is a parabola, within the triangle of these three.
        let first = direction[axis] + d1[axis];
        let control = first + d2[axis] * length / 2.0;
        let second = d2[axis] + d3[axis] * length;
        let last = control + second * length / 2.0;
        even[0][axis] = greater(greater(first.abs(), control.abs()), last.abs());
        even[1][axis] = greater(d2[axis].abs(), second.abs());
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
        let (turning, along) = turning(curve, at, at + length);
        for (value, along) in even[0].iter_mut().zip(along) {
            *value += along;
        }
        axes = axes.max(LINEAR_AXES);
        rate += 1.0;
        turns = Some(turning);
    } else if direction[..3] == [0.0; 3] {
        // Rotary axes alone: the feed counts them.
        rate = largest(rates[1]);
    }
    if leg.follows_tip {
        rate = 1.0;
    }
    DerivativeBounds { even, axes, turning: turns, rate }
}

/// X, Y and Z.
const LINEAR_AXES: usize = 3;
/// Places at which a short eased piece is looked at.
const PROBE_COUNT: usize = 5;

/// Values at the probes.
type ProbeValues = [f64; PROBE_COUNT];

/// The first three derivatives of X, Y and Z of a curve at even steps from a place on.
fn probes(curve: &Curve, at: f64, step: f64) -> [[ProbeValues; 3]; LINEAR_AXES] {
    let mut probed = [[[0.0; PROBE_COUNT]; 3]; LINEAR_AXES];
    if let Curve::Arc(arc) = curve {
        let derivatives = arc.derivatives_from(at, step);
        for (axis, orders) in probed.iter_mut().enumerate() {
            *orders = derivatives.of_axis(axis);
        }
        return probed;
    }
    for probe in 0..PROBE_COUNT {
        let jet = curve.jet_at(at + step * probe as f64);
        for (order, of) in jet[1..].iter().enumerate() {
            for (orders, value) in probed.iter_mut().zip(of.to_array()) {
                orders[order][probe] = value;
            }
        }
    }
    probed
}

/// Bounds on a short eased piece of a curve, met by looking at it: the curvature of the curve and
/// its correction mostly cancel there.
fn near_bounds(
    curve: &Curve,
    at: f64,
    length: f64,
    correction: &AxisJet,
    direction: &AxisValues,
) -> Option<DerivativeBounds> {
    // Between two probes a sine exceeds both by its size times this.
    const MAX_PROBED_TURN_RAD: f64 = 0.8;
    // A smaller share of the curvature may be rounding, and moves what is met by nothing.
    const CURVATURE_NOISE_SHARE: f64 = 1e-9;
    let step = length / (PROBE_COUNT - 1) as f64;
    let probes = probes(curve, at, step);
    let size = |order: usize, probe: usize| {
        let (x, y, z) = (probes[0][order][probe], probes[1][order][probe], probes[2][order][probe]);
        (x * x + y * y + z * z).sqrt()
    };
    let curvature = size(1, 0).max(size(1, PROBE_COUNT - 1));
    let third = size(2, 0).max(size(2, PROBE_COUNT - 1));
    // How fast it turns: a steep helix faster than its curvature says.
    let turn = if curvature > 0.0 { curvature.max(third / curvature) } else { 0.0 };
    if turn * length > MAX_PROBED_TURN_RAD {
        return None;
    }
    let between = 1.1 * third.max(curvature * curvature) * step * step / 8.0;
    let noise = CURVATURE_NOISE_SHARE * curvature;
    let margins = [between, between * turn, between * turn * turn];
    let [_, d1, d2, d3] = correction;
    let mut even = [[0.0_f64; AXES]; 3];
    let mut squares = [0.0_f64; PROBE_COUNT];
    // What the correction's parabola exceeds two probes by, where it turns back between them.
    let mut bulges = 0.0;
    let offsets: ProbeValues = std::array::from_fn(|probe| step * probe as f64);
    let mut axes = 0;
    for axis in 0..AXES {
        let (first, second, third) = (d1[axis], d2[axis], d3[axis]);
        let moves = if axis < LINEAR_AXES {
            probes[axis].iter().flatten().any(|value| *value != 0.0)
        } else {
            direction[axis] != 0.0
        };
        if !moves && first == 0.0 && second == 0.0 && third == 0.0 {
            continue;
        }
        axes = axis + 1;
        let mut values = [[0.0; PROBE_COUNT], [0.0; PROBE_COUNT], [third; PROBE_COUNT]];
        for probe in 0..PROBE_COUNT {
            let offset = offsets[probe];
            values[0][probe] = first + offset * (second + offset * (third / 2.0));
            values[1][probe] = second + offset * third;
        }
        if axis < LINEAR_AXES {
            for (row, of) in values.iter_mut().zip(&probes[axis]) {
                row.iter_mut().zip(of).for_each(|(value, of)| *value += of);
            }
            squares.iter_mut().zip(&values[0]).for_each(|(sum, value)| *sum += value * value);
        } else {
            values[0].iter_mut().for_each(|value| *value += direction[axis]);
        }
        for order in 0..3 {
            even[order][axis] = largest_size(&values[order]) + margins[order];
        }
        if turns_back(&values[1], noise) {
            let bulge = third.abs() * step * step / 8.0;
            even[0][axis] += bulge;
            if axis < LINEAR_AXES {
                bulges += bulge * bulge;
            }
        }
    }
    let rate = squares.into_iter().fold(0.0, f64::max).sqrt();
    Some(DerivativeBounds { even, axes, turning: None, rate: rate + between + bulges.sqrt() })
}

/// The largest of some values, whatever their signs. Quicker than with a rule for what is no number.
#[inline]
fn largest_size(values: &ProbeValues) -> f64 {
    values.iter().fold(0.0, |most, value| if value.abs() > most { value.abs() } else { most })
}

/// The greater of two numbers, likewise.
#[inline]
fn greater(a: f64, b: f64) -> f64 {
    if b > a { b } else { a }
}

/// Whether values change their sign between two of them. Where they do so at one, that has met it: a
/// sign that is rounding says nothing.
#[inline]
fn turns_back(values: &ProbeValues, noise: f64) -> bool {
    values
        .windows(2)
        .any(|pair| pair[0] * pair[1] < 0.0 && pair[0].abs() > noise && pair[1].abs() > noise)
}

/// Adds an interval to a look-ahead window, or its length to the last one where the limits are the same.
fn add(interval: LimitInterval, intervals: &mut Vec<LimitInterval>) {
    if let Some(last) = intervals.last_mut()
        && !last.ends_at_rest
        && last.pieces < MAX_INTERVAL_PIECES
        && last.length < MAX_INTERVAL_S * last.speed
        && near(last.speed, interval.speed)
        && last.ability.knees.iter().zip(&interval.ability.knees).all(|(a, b)| near(*a, *b))
        && last
            .ability
            .efforts
            .iter()
            .zip(&interval.ability.efforts)
            .all(|(a, b)| near(a.acceleration, b.acceleration) && near(a.jerk, b.jerk))
    {
        last.length += interval.length;
        last.pieces += interval.pieces;
        return;
    }
    intervals.push(interval);
}

fn near(a: f64, b: f64) -> bool {
    a == b || (a - b).abs() <= EQUAL_LIMIT_SHARE * a.abs()
}
