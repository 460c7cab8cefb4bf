//! Joins edges to loops, by the numbers of their vertices.

use chordal_geometry::Vec2;

use super::edge::RegionEdge;
use super::segment::OutlineSegment;

/// Edges are collinear where the sine of the angle between them is below this.
const STRAIGHT_SINE: f64 = 1e-9;

/// The edges, loop by loop. A chain that does not close ends its loop; after a checked operation every chain closes.
pub(crate) fn loops(edges: &[RegionEdge]) -> Vec<Vec<RegionEdge>> {
    let mut by_start: Vec<u32> = (0..edges.len() as u32).collect();
    by_start.sort_unstable_by_key(|at| (edges[*at as usize].ends[0], *at));
    let mut used = vec![false; edges.len()];
    let mut found = Vec::new();
    for first in 0..edges.len() {
        if used[first] {
            continue;
        }
        let mut chain = Vec::new();
        let mut at = first;
        loop {
            used[at] = true;
            chain.push(edges[at]);
            match next(edges, &by_start, &used, at, first) {
                Some(following) if following != first => at = following,
                _ => break,
            }
        }
        found.push(chain);
    }
    found
}

/// The next edge of a loop; its first one where the loop closes, `None` where there is none.
fn next(
    edges: &[RegionEdge],
    by_start: &[u32],
    used: &[bool],
    at: usize,
    first: usize,
) -> Option<usize> {
    let edge = &edges[at];
    let begin = by_start.partition_point(|at| edges[*at as usize].ends[0] < edge.ends[1]);
    let here = by_start[begin..].iter().map(|at| *at as usize);
    let here = here.take_while(|at| edges[*at].ends[0] == edge.ends[1]);
    let open = here.filter(|at| !used[*at] || *at == first);
    open.max_by(|x, y| turn(edge, &edges[*x]).total_cmp(&turn(edge, &edges[*y])).then(y.cmp(x)))
}

/// The angle of the turn to the left from an edge to the next, from −π to π. Loops that touch in a vertex stay
/// separate if each takes the sharpest turn towards its region.
fn turn(edge: &RegionEdge, next: &RegionEdge) -> f64 {
    let (from, to) = (edge.direction(true), next.direction(false));
    let angle = libm::atan2(from.cross(to), from.dot(to));
    // A reversal counts as a right turn (−π) if the next edge bends away to the left, otherwise as a left turn.
    if core::f64::consts::PI - angle.abs() < STRAIGHT_SINE {
        let bend = next.curvature() + edge.curvature();
        return if bend > 0.0 { -core::f64::consts::PI } else { core::f64::consts::PI };
    }
    angle
}

/// A loop as segments: adjoining edges on one line or circle that were made by one move become one segment.
pub(crate) fn outline(chain: &[RegionEdge], tolerance: f64) -> Vec<OutlineSegment> {
    let goes_on = |one: &RegionEdge, two: &RegionEdge| {
        one.tag == two.tag && is_continued(one, two, tolerance)
    };
    let count = chain.len();
    // Begin at a corner, so that no segment is divided there.
    let begin = (0..count).find(|at| !goes_on(&chain[(at + count - 1) % count], &chain[*at]));
    let begin = begin.unwrap_or(0);
    let mut drawn: Vec<RegionEdge> = Vec::new();
    for at in 0..count {
        let edge = &chain[(begin + at) % count];
        match drawn.last_mut() {
            // Compared with the whole segment so far, not with its last edge, which may have no length.
            Some(last) if goes_on(last, edge) => last.end = edge.end,
            _ => drawn.push(*edge),
        }
    }
    drawn.into_iter().map(RegionEdge::to_segment).collect()
}

/// Whether the second edge lies on the line or circle of the first and continues in its sense.
fn is_continued(one: &RegionEdge, two: &RegionEdge, tolerance: f64) -> bool {
    if one.is_straight() != two.is_straight() {
        return false;
    }
    if one.is_straight() {
        let (from, to) = (one.end - one.start, two.end - two.start);
        let whole: Vec2 = two.end - one.start;
        let off = whole.cross(one.end - one.start).abs();
        return from.dot(to) > 0.0 && off <= tolerance * whole.length();
    }
    let (a, b) = (&one.circle, &two.circle);
    a.counterclockwise == b.counterclockwise
        && a.center.distance(b.center) <= tolerance
        && (a.radius - b.radius).abs() <= tolerance
}
