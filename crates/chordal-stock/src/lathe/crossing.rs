//! Finds the points that two edges have in common.

use chordal_geometry::{Circle2, Line2, Meeting, Vec2, circle_circle, line_circle, line_line};

use super::edge::RegionEdge;

/// A point at which one or both of two edges are divided.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct EdgeSplit {
    pub place: Vec2,
    pub first: bool,
    pub second: bool,
}

/// Emits every point where one of two edges must be divided: ends of one that lie on the other, and proper crossings.
/// A point within `tolerance` (mm) of an end will be merged with it.
pub(crate) fn crossings(
    first: &RegionEdge,
    second: &RegionEdge,
    tolerance: f64,
    mut found: impl FnMut(EdgeSplit),
) {
    for place in [second.start, second.end] {
        if first.passes(place, tolerance) {
            found(EdgeSplit { place, first: true, second: false });
        }
    }
    for place in [first.start, first.end] {
        if second.passes(place, tolerance) {
            found(EdgeSplit { place, first: false, second: true });
        }
    }
    let mut both = |place| found(EdgeSplit { place, first: true, second: true });
    match (first.is_straight(), second.is_straight()) {
        (true, true) => {
            if let Some(crossing) = line_line(line_of(first), line_of(second), 0.0) {
                let within = |along: f64| (0.0..=1.0).contains(&along);
                // For nearly coincident lines the crossing is dominated by rounding, so it must be on both edges.
                let place = crossing.point;
                let inner = within(crossing.along_first) && within(crossing.along_second);
                if inner && first.passes(place, tolerance) && second.passes(place, tolerance) {
                    both(place);
                }
            }
        }
        (true, false) => line_with_arc(first, second, tolerance, both),
        (false, true) => line_with_arc(second, first, tolerance, both),
        (false, false) => arcs(first, second, tolerance, both),
    }
}

fn line_of(edge: &RegionEdge) -> Line2 {
    Line2 { point: edge.start, direction: edge.end - edge.start }
}

fn circle_of(edge: &RegionEdge) -> Circle2 {
    Circle2 { center: edge.circle.center, radius: edge.circle.radius }
}

/// Turns two crossings into one touch where the shapes overlap between them by no more than `tolerance`: their exact
/// places are rounding.
fn shallow(meeting: Meeting, depth: impl Fn(f64) -> f64, tolerance: f64) -> Meeting {
    match meeting {
        Meeting::Cross(p, q) if depth(0.5 * p.distance(q)) <= tolerance => {
            Meeting::Touch((p + q) * 0.5)
        }
        other => other,
    }
}

fn line_with_arc(line: &RegionEdge, arc: &RegionEdge, tolerance: f64, mut found: impl FnMut(Vec2)) {
    let along = line.end - line.start;
    let meeting = line_circle(line_of(line), circle_of(arc), 0.0);
    let depth = |half: f64| 0.5 * half * half / arc.circle.radius;
    for place in shallow(meeting, depth, tolerance).points() {
        let reach = (place - line.start).dot(along);
        if reach >= 0.0 && reach <= along.dot(along) && arc.faces(place) {
            found(place);
        }
    }
}

fn arcs(first: &RegionEdge, second: &RegionEdge, tolerance: f64, mut found: impl FnMut(Vec2)) {
    let (a, b) = (circle_of(first), circle_of(second));
    let between = a.center.distance(b.center);
    let depth = |_| (a.radius + b.radius - between).min(between - (a.radius - b.radius).abs());
    for place in shallow(circle_circle(a, b, 0.0), depth, tolerance).points() {
        // For nearly coincident circles the point is uncertain along both, and so may be off them. It is projected on
        // the first circle, and dropped if it is then off the second.
        let Some(out) = (place - a.center).normalized() else { continue };
        let place = a.center + out * a.radius;
        let off = (place.distance(b.center) - b.radius).abs();
        if off <= tolerance && first.faces(place) && second.faces(place) {
            found(place);
        }
    }
}
