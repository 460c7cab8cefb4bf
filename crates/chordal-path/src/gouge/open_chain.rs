//! The wall of a chain that returns to none of its vertices: it is cut where it overlaps or crosses itself, or is open.

use core::f64::consts::PI;

use super::chain::{ChainWalls, closes, same_course, turn};
use super::closing::{ClosingPoint, ClosingSide, MAX_LEAD};
use super::shape::GougeCurve;
use super::{Contour, ContourBlock, GougeOptions, GougeRole, distance};

/// The wall of a chain that has no closed range.
pub(super) fn walls(
    contour: &Contour,
    mut chain: Vec<ContourBlock>,
    options: &GougeOptions,
) -> ChainWalls {
    let side = contour.side.sign();
    if cut_at_overlap(&mut chain, options) {
        return ChainWalls { blocks: chain, closed: true, lead_arcs: Vec::new() };
    }
    let lead_arcs = strip_lead_arcs(&mut chain, contour, options);
    let closed = cut_at_crossing(&mut chain, side, options) || {
        strip_run_off(&mut chain, contour.radius);
        closes(&chain, options.vertex)
    };
    ChainWalls { blocks: chain, closed, lead_arcs }
}

/// The pairs of a block near the start and one near the end, those with the longest range between them first.
fn ends(count: usize) -> impl Iterator<Item = (usize, usize)> {
    let least = count.saturating_sub(MAX_LEAD + 1);
    (0..count.min(MAX_LEAD + 1))
        .flat_map(move |first| (least.max(first + 1)..count).rev().map(move |last| (first, last)))
}

/// Cuts a chain to the part from the start of a block to where a later block passes that start along the same line or
/// circle: the program continues slightly past the start of the contour. False if there is no such block.
pub(super) fn cut_at_overlap(chain: &mut Vec<ContourBlock>, options: &GougeOptions) -> bool {
    let grain = options.vertex;
    let found = ends(chain.len()).find_map(|(first, last)| {
        let (head, tail) = (&chain[first].curve, &chain[last].curve);
        let start = head.from();
        let meets = tail.nearest(start).distance(start) <= grain
            && tail.from().distance(start) > grain
            && same_course(head, tail, grain);
        let end = tail.piece(0.0, tail.fraction(start));
        meets.then_some((first, last, end))
    });
    let Some((first, last, end)) = found else { return false };
    chain[last].curve = end;
    chain.truncate(last + 1);
    chain.drain(..first);
    true
}

/// Cuts a chain to the part between the two passes of the point where it crosses itself, if both ends beyond it are on
/// the side of the tool: there the tool approaches the first wall and leaves the last. False if there is no crossing.
fn cut_at_crossing(chain: &mut Vec<ContourBlock>, side: f64, options: &GougeOptions) -> bool {
    let grain = options.vertex;
    let found = ends(chain.len()).find_map(|(first, last)| {
        let (head, tail) = (chain[first].curve, chain[last].curve);
        let near = distance::nearest(&head, &tail);
        let at = near.first;
        // The joint of neighbours is no crossing.
        let joint = last == first + 1 && at.distance(head.to()) <= grain;
        if near.square > grain * grain || joint {
            return None;
        }
        let (cut, ended) = (head.fraction(at), tail.fraction(at));
        let (begins, ends) = (head.piece(cut, 1.0), tail.piece(0.0, ended));
        if begins.length() <= grain || ends.length() <= grain {
            return None;
        }
        let closing = ClosingPoint { first: &begins, last: &ends, side, grain };
        let before = head.piece(0.0, cut).reversed();
        let after = tail.piece(ended, 1.0);
        let on_tool_side = |lead: &GougeCurve| {
            lead.length() <= grain || closing.lies(lead) == ClosingSide::ToolSide
        };
        (on_tool_side(&before) && on_tool_side(&after)).then_some((first, last, begins, ends))
    });
    let Some((first, last, begins, ends)) = found else { return false };
    chain[first].curve = begins;
    chain[last].curve = ends;
    chain.truncate(last + 1);
    chain.drain(..first);
    true
}

/// Removes the first and the last arc of an open chain if they are tangent to their neighbour, have the tool inside and
/// make at most half a turn: such arcs only lead to the wall and away from it. Returns the removed arcs.
fn strip_lead_arcs(
    chain: &mut Vec<ContourBlock>,
    contour: &Contour,
    options: &GougeOptions,
) -> Vec<ContourBlock> {
    // The tool does not fit into a smaller arc: that is no lead, so that its gouge is reported.
    let holds_tool = |block: &ContourBlock| match block.curve {
        GougeCurve::Arc { radius, .. } => radius >= contour.radius - options.epsilon,
        GougeCurve::Line { .. } => false,
    };
    let leads =
        |block: &ContourBlock| is_lead_arc(&block.curve, contour.side.sign()) && holds_tool(block);
    // Tangent to the wall, but not on the circle of the wall: then the wall continues in the next block.
    let smooth = |before: &ContourBlock, after: &ContourBlock| {
        turn(&before.curve, &after.curve).abs() <= options.tangent
            && !same_course(&before.curve, &after.curve, options.vertex)
    };
    let [before, after] = passing(contour);
    let mut lead_arcs = Vec::new();
    if let Some(first) = chain.first().copied()
        && leads(&first)
        && chain.get(1).or(after.as_ref()).is_some_and(|second| smooth(&first, second))
    {
        lead_arcs.push(first);
        chain.remove(0);
    }
    if let Some(last) = chain.last().copied()
        && leads(&last)
        && chain.iter().rev().nth(1).or(before.as_ref()).is_some_and(|second| smooth(second, &last))
    {
        lead_arcs.push(last);
        chain.pop();
    }
    lead_arcs
}

/// Whether a curve is an arc with the tool inside that makes at most half a turn.
pub(super) fn is_lead_arc(curve: &GougeCurve, side: f64) -> bool {
    match *curve {
        GougeCurve::Arc { sweep, .. } => sweep * side > 0.0 && sweep.abs() <= PI + 1e-6,
        GougeCurve::Line { .. } => false,
    }
}

/// The blocks at another height directly before and after the chain.
fn passing(contour: &Contour) -> [Option<ContourBlock>; 2] {
    let passes =
        |block: Option<&ContourBlock>| block.filter(|b| b.role == GougeRole::Passing).copied();
    [passes(contour.blocks.first()), passes(contour.blocks.last())]
}

/// Cuts an open chain where its first and last line cross, each extended by the tool radius: the ends beyond only move
/// the tool off the part.
fn strip_run_off(chain: &mut [ContourBlock], radius: f64) {
    let count = chain.len();
    if count < 3 {
        return;
    }
    let (first, last) = (chain[0].curve, chain[count - 1].curve);
    let (GougeCurve::Line { from: a, to: b }, GougeCurve::Line { from: c, to: d }) = (first, last)
    else {
        return;
    };
    let (Some(t), Some(u)) = ((b - a).normalized(), (d - c).normalized()) else { return };
    let before = GougeCurve::line(a - t * radius, b);
    let beyond = GougeCurve::line(c, d + u * radius);
    let near = distance::nearest(&before, &beyond);
    if near.square > 0.0 || near.first == b || near.first == c {
        return;
    }
    let cross = near.first;
    let past_crossing_mm = (d - cross).dot(u);
    let begins_before = (cross - a).dot(t);
    // At least one of the two must pass the crossing without being extended.
    if past_crossing_mm <= 0.0 && begins_before <= 0.0 {
        return;
    }
    if begins_before > 0.0 {
        chain[0].curve = GougeCurve::line(cross, b);
    }
    if past_crossing_mm > 0.0 {
        chain[count - 1].curve = GougeCurve::line(c, cross);
    }
}
