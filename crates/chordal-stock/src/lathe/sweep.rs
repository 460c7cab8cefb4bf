//! The area that a convex outline sweeps along a line or an arc, as exact loops of lines and arcs.
//!
//! The path followed forth and back is a closed curve. Where its tangent has a direction, the outline touches the
//! boundary of the swept area at the point where its own tangent has that direction; on the way back the outline is
//! walked backwards. The resulting closed curve is the convolution of the two (Guibas, Ramshaw and Stolfi 1983): its
//! winding number is at least one at every point that is swept. Nose arcs give arcs of radius A + r and A − r about
//! the path's centre, corners arcs of radius A, flanks stay straight.

use chordal_geometry::Vec2;

use super::convex::{ConvexOutline, TURN, WalkElement, WalkStep, angle, steps};
use super::edge::{ArcCircle, Box2, RegionEdge, push_arc};
use super::region::{RegionError, circle_of, in_range};
use super::segment::OutlineSegment;

/// Gaps and edges shorter than this are rounding, mm.
const NO_LENGTH: f64 = 1e-11;

/// The extent of a swept area.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct SweptRegion {
    pub bounds: Box2,
    /// Whether it is one loop that does not touch itself.
    pub simple: bool,
}

/// Sweeps every part along a path of the origin. The work turns, so a part beyond the axis also sweeps its mirror
/// image.
pub(crate) fn sweep(
    parts: &[ConvexOutline],
    path: &OutlineSegment,
    edges: &mut Vec<RegionEdge>,
) -> Result<SweptRegion, RegionError> {
    for value in [path.start.a, path.start.b, path.end.a, path.end.b] {
        in_range(value)?;
    }
    let circle = circle_of(path)?;
    edges.clear();
    for part in parts {
        let mut tracer = SweepTracer { edges, at: None, tag: path.tag };
        match circle {
            None => along_line(part, path, &mut tracer),
            Some(circle) => along_arc(part, path, circle, &mut tracer),
        }
        tracer.close();
    }
    let mut bounds = Box2::around(edges);
    let past_axis = bounds.min.b < -NO_LENGTH;
    if past_axis {
        for at in 0..edges.len() {
            edges.push(edges[at].mirrored());
        }
        bounds = Box2::around(edges);
    }
    Ok(SweptRegion { bounds, simple: parts.len() == 1 && circle.is_none() && !past_axis })
}

fn along_line(part: &ConvexOutline, path: &OutlineSegment, tracer: &mut SweepTracer<'_>) {
    let tangent = (path.end - path.start).normalized().unwrap_or(Vec2::new(1.0, 0.0));
    let first = (steps(tangent), tangent);
    let back = (first.0 + TURN / 2, -tangent);
    part.walk(first, back, |step| tracer.outline(path.end, &step));
    part.walk(back, (first.0 + TURN, tangent), |step| tracer.outline(path.start, &step));
}

fn along_arc(
    part: &ConvexOutline,
    path: &OutlineSegment,
    circle: ArcCircle,
    tracer: &mut SweepTracer<'_>,
) {
    // A clockwise arc sweeps the same as its reverse.
    let (start, end) = match circle.counterclockwise {
        true => (path.start, path.end),
        false => (path.end, path.start),
    };
    let ArcCircle { center, radius, .. } = circle;
    let tangent = |p: Vec2| (p - center).turned_left().normalized().unwrap_or(Vec2::new(1.0, 0.0));
    let begin = (steps(tangent(start)), tangent(start));
    let mut finish = (steps(tangent(end)), tangent(end));
    if start == end || finish.0 < begin.0 {
        finish.0 += TURN;
    }
    let half = |(step, tangent): (i64, Vec2)| (step + TURN / 2, -tangent);
    part.walk(begin, finish, |step| tracer.forth(center, radius, &step));
    part.walk(finish, half(finish), |step| tracer.outline(end, &step));
    let mut back = Vec::new();
    part.walk(half(begin), half(finish), |step| back.push(step));
    for step in back.iter().rev() {
        tracer.back(center, radius, step);
    }
    let again = (begin.0 + TURN, begin.1);
    part.walk(half(begin), again, |step| tracer.outline(start, &step));
}

/// The direction to the right of a tangent, which is outwards for a counter-clockwise curve.
fn outward(tangent: Vec2) -> Vec2 {
    -tangent.turned_left()
}

/// Traces one closed curve.
struct SweepTracer<'a> {
    edges: &'a mut Vec<RegionEdge>,
    /// The first and the current point of the curve.
    at: Option<(Vec2, Vec2)>,
    tag: u32,
}

impl SweepTracer<'_> {
    fn line_to(&mut self, to: Vec2) {
        let Some((first, at)) = self.at else {
            self.at = Some((to, to));
            return;
        };
        if at.distance(to) > NO_LENGTH {
            self.edges.push(RegionEdge::line(at, to, self.tag));
            self.at = Some((first, to));
        }
    }

    fn arc_to(&mut self, from: Vec2, to: Vec2, circle: ArcCircle, sweep: f64) {
        self.line_to(from);
        let Some((first, at)) = self.at else { return };
        if circle.radius > NO_LENGTH && sweep * circle.radius > NO_LENGTH {
            push_arc(self.edges, (at, to), circle, sweep, self.tag);
            self.at = Some((first, to));
        }
    }

    fn close(&mut self) {
        let Some((first, at)) = self.at.take() else { return };
        if at == first {
            return;
        }
        match self.edges.last_mut() {
            // The curve is closed up to rounding.
            Some(last) if at.distance(first) <= NO_LENGTH => last.end = first,
            _ => self.edges.push(RegionEdge::line(at, first, self.tag)),
        }
    }

    /// Traces the outline itself, with its origin at `place`.
    fn outline(&mut self, place: Vec2, step: &WalkStep) {
        self.forth(place, 0.0, step);
    }

    /// Traces the outline on a counter-clockwise path about `center`.
    fn forth(&mut self, center: Vec2, radius: f64, step: &WalkStep) {
        let [from, to] = step.tangents.map(outward);
        let sweep = angle(step.steps[1] - step.steps[0]);
        match step.element {
            WalkElement::Line(start, end) => {
                self.line_to(center + from * radius + start);
                self.line_to(center + from * radius + end);
            }
            WalkElement::Corner(corner) => {
                self.turn(center + corner, radius, [from, to], sweep, true);
            }
            WalkElement::Arc(middle, nose) => {
                self.turn(center + middle, radius + nose, [from, to], sweep, true);
            }
        }
    }

    /// Traces the outline on the way back.
    fn back(&mut self, center: Vec2, radius: f64, step: &WalkStep) {
        let [from, to] = step.tangents.map(outward);
        let sweep = angle(step.steps[1] - step.steps[0]);
        match step.element {
            WalkElement::Line(start, end) => {
                self.line_to(center - from * radius + end);
                self.line_to(center - from * radius + start);
            }
            WalkElement::Corner(corner) => {
                self.turn(center + corner, -radius, [to, from], sweep, false);
            }
            WalkElement::Arc(middle, nose) => {
                self.turn(center + middle, nose - radius, [to, from], sweep, false);
            }
        }
    }

    /// Traces an arc about `center` between two directions; a negative `reach` is on the opposite side.
    fn turn(&mut self, center: Vec2, reach: f64, out: [Vec2; 2], sweep: f64, forth: bool) {
        let [from, to] = out.map(|out| center + out * reach);
        let circle = ArcCircle { center, radius: reach.abs(), counterclockwise: forth };
        self.arc_to(from, to, circle, sweep);
    }
}
