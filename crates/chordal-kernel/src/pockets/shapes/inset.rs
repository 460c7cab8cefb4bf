//! The inward offset of an outline: the border of the points that a tool's centre may reach.
//!
//! Every line is offset by the distance, every arc's radius changes by it, every corner gets a circle. These
//! candidates are split where they meet, parts nearer to the outline than the distance are dropped, and the
//! rest is chained into loops. The order of the outline is not used, so narrow passages, arms and short
//! segments need no special cases.

use core::f64::consts::TAU;

use chordal_geometry::Vec2;

use super::outline::{COINCIDENT_POINT_MM, Outline, OutlineElement};

/// A region that walls enclose.
pub trait WalledRegion {
    /// The walls, with the region on their left.
    fn walls(&self) -> Vec<OutlineElement>;
    /// The distance of a point from the walls, mm.
    fn distance(&self, p: Vec2) -> f64;
    /// True for a point inside.
    fn contains(&self, p: Vec2) -> bool;
}

impl WalledRegion for Outline {
    fn walls(&self) -> Vec<OutlineElement> {
        self.elements().to_vec()
    }

    fn distance(&self, p: Vec2) -> f64 {
        Outline::distance(self, p)
    }

    fn contains(&self, p: Vec2) -> bool {
        Outline::contains(self, p)
    }
}

/// Parts whose middle comes nearer than the distance by more than this, mm, are dropped.
const NEARER_MM: f64 = 1e-9;

/// A shorter loop, mm, is an artefact of tangent candidates and not room for a tool.
const SHORT_LOOP_MM: f64 = 1e-2;

/// Ends closer than this, mm, are joined: tangent candidates cross at shallow angles, where the crossing is
/// poorly conditioned.
const JOIN_MM: f64 = 5e-4;

/// The border of the region of a tool centre, `distance` (zero or more, mm) inside an outline: one
/// counter-clockwise loop for each connected part.
pub fn inset(outline: &Outline, distance: f64) -> Vec<Outline> {
    if distance <= COINCIDENT_POINT_MM {
        return vec![outline.clone()];
    }
    borders(outline, distance)
}

/// The border of the points of a region that are at least a distance (above zero, mm) from its walls. Its loops have the
/// points on their left: those about an island go clockwise.
pub fn borders(region: &dyn WalledRegion, distance: f64) -> Vec<Outline> {
    let candidates = candidates(&region.walls(), distance);
    let mut kept: Vec<OutlineElement> = Vec::new();
    for (index, candidate) in candidates.iter().enumerate() {
        for (begin, end) in
            kept_ranges(region, distance, candidate, &cuts(candidate, index, &candidates))
        {
            let part = candidate.part(begin, end);
            if !kept.iter().any(|other| same(other, &part)) {
                kept.push(part);
            }
        }
    }
    chain(kept)
}

/// The offset lines and arcs, and a circle about every corner.
fn candidates(walls: &[OutlineElement], distance: f64) -> Vec<OutlineElement> {
    let mut candidates: Vec<OutlineElement> =
        walls.iter().filter_map(|element| element.moved_left(distance)).collect();
    for element in walls {
        let center = element.from();
        let from = center + Vec2::new(distance, 0.0);
        candidates.push(OutlineElement::Arc { from, to: from, center, sweep: -TAU });
    }
    candidates
}

/// Where a candidate meets the others, as sorted fractions of its length, including 0 and 1.
fn cuts(candidate: &OutlineElement, index: usize, all: &[OutlineElement]) -> Vec<f64> {
    let mut at = Vec::new();
    for (other_index, other) in all.iter().enumerate() {
        if other_index == index {
            continue;
        }
        for point in candidate.crossings(other, COINCIDENT_POINT_MM) {
            at.extend(candidate.fraction(point, COINCIDENT_POINT_MM));
        }
        // Also where the other ends on this one, or overlaps it.
        for end in [other.from(), other.to()] {
            if candidate.distance(end) < COINCIDENT_POINT_MM {
                at.extend(candidate.fraction(end, COINCIDENT_POINT_MM));
            }
        }
    }
    at.sort_by(f64::total_cmp);
    let short = COINCIDENT_POINT_MM / candidate.length();
    let mut cuts = vec![0.0];
    for t in at {
        // A touching point is found twice, or very near an end.
        if t - cuts[cuts.len() - 1] > short && 1.0 - t > short {
            cuts.push(t);
        }
    }
    cuts.push(1.0);
    cuts
}

/// The ranges between cuts that are far enough from the outline; adjacent ones are merged.
fn kept_ranges(
    region: &dyn WalledRegion,
    distance: f64,
    candidate: &OutlineElement,
    cuts: &[f64],
) -> Vec<(f64, f64)> {
    let mut ranges: Vec<(f64, f64)> = Vec::new();
    for pair in cuts.windows(2) {
        let (begin, end) = (pair[0], pair[1]);
        let middle = candidate.point(0.5 * (begin + end));
        let near = region.distance(middle) < distance - NEARER_MM;
        if near
            || !region.contains(middle)
            || (end - begin) * candidate.length() < COINCIDENT_POINT_MM
        {
            continue;
        }
        match ranges.last_mut() {
            Some(last) if last.1 == begin => last.1 = end,
            _ => ranges.push((begin, end)),
        }
    }
    ranges
}

/// True for equal parts: same ends, same middle.
fn same(a: &OutlineElement, b: &OutlineElement) -> bool {
    let near = |p: Vec2, q: Vec2| p.distance(q) < 10.0 * COINCIDENT_POINT_MM;
    near(a.from(), b.from()) && near(a.to(), b.to()) && near(a.point(0.5), b.point(0.5))
}

/// Chains parts into loops: each end is joined to the nearest start.
fn chain(mut parts: Vec<OutlineElement>) -> Vec<Outline> {
    let mut loops = Vec::new();
    while let Some(first) = parts.pop() {
        let start = first.from();
        let mut chain = vec![first];
        loop {
            let end = chain.last().map_or(start, OutlineElement::to);
            let home = end.distance(start);
            let next = parts
                .iter()
                .enumerate()
                .map(|(index, part)| (end.distance(part.from()), index))
                .min_by(|a, b| a.0.total_cmp(&b.0))
                .filter(|(gap, _)| *gap <= JOIN_MM && *gap < home);
            let Some((_, index)) = next else { break };
            let mut part = parts.swap_remove(index);
            match &mut part {
                OutlineElement::Line { from, .. } | OutlineElement::Arc { from, .. } => *from = end,
            }
            chain.push(part);
        }
        let end = chain.last().map_or(start, OutlineElement::to);
        if end.distance(start) > JOIN_MM {
            // An open chain comes from two touching candidates and bounds no region.
            continue;
        }
        if let Some(OutlineElement::Line { to, .. } | OutlineElement::Arc { to, .. }) =
            chain.last_mut()
        {
            *to = start;
        }
        if chain.iter().map(OutlineElement::length).sum::<f64>() > SHORT_LOOP_MM {
            loops.push(Outline::of_loop(chain));
        }
    }
    loops
}
