//! A convex outline of lines and arcs, walked by the direction of its tangent.
//!
//! Directions are compared as integers, so that an edge parallel to a move is met exactly once, and adding half a
//! turn is exact.

use core::f64::consts::TAU;

use chordal_geometry::Vec2;

use super::region::{RegionError, circle_of, in_range};
use super::segment::OutlineSegment;

/// Steps of a whole turn. One step is 1.4e-12 rad, about the accuracy of an angle between nearby points.
pub(crate) const TURN: i64 = 1 << 42;
/// Tangents that differ by at most this many steps join smoothly.
const SMOOTH: i64 = 64;

/// A direction in steps, from 0 up to [`TURN`].
pub(crate) fn steps(direction: Vec2) -> i64 {
    let part = libm::atan2(direction.b, direction.a) / TAU;
    (libm::round(part * TURN as f64) as i64).rem_euclid(TURN)
}

/// The angle of a number of steps, rad.
pub(crate) fn angle(steps: i64) -> f64 {
    steps as f64 / TURN as f64 * TAU
}

/// A line or a counter-clockwise arc (radius above zero) of the outline.
#[derive(Clone, Copy, Debug, PartialEq)]
struct OutlineSide {
    start: Vec2,
    end: Vec2,
    center: Vec2,
    radius: f64,
    /// Unit tangents at both ends.
    tangents: [Vec2; 2],
    /// The tangents in steps, ascending along the outline.
    steps: [i64; 2],
}

/// An element of the outline in a walk around it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum WalkElement {
    /// A corner.
    Corner(Vec2),
    /// A line.
    Line(Vec2, Vec2),
    /// An arc about a centre with a radius.
    Arc(Vec2, f64),
}

/// An element of a walk, with the tangents at its start and end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct WalkStep {
    pub element: WalkElement,
    pub tangents: [Vec2; 2],
    pub steps: [i64; 2],
}

/// A convex outline, counter-clockwise.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct ConvexOutline {
    sides: Vec<OutlineSide>,
}

impl ConvexOutline {
    /// The outline of a closed counter-clockwise loop of segments; `None` if it is not convex.
    pub fn of(segments: &[OutlineSegment]) -> Result<Option<ConvexOutline>, RegionError> {
        let mut sides = Vec::new();
        for segment in segments {
            for value in [segment.start.a, segment.start.b, segment.end.a, segment.end.b] {
                in_range(value)?;
            }
            let OutlineSegment { start, end, .. } = *segment;
            let circle = circle_of(segment)?;
            if circle.is_some_and(|circle| !circle.counterclockwise) {
                return Ok(None);
            }
            let (center, radius) =
                circle.map_or((start, 0.0), |circle| (circle.center, circle.radius));
            let tangents = match circle {
                Some(_) => [(start - center).turned_left(), (end - center).turned_left()],
                None => [end - start; 2],
            };
            let [Some(first), Some(last)] = tangents.map(Vec2::normalized) else { continue };
            let turned = if start == end { TURN } else { steps(last) - steps(first) };
            let turned = if turned < 0 { turned + TURN } else { turned };
            let (tangents, steps) = ([first, last], [steps(first), steps(first) + turned]);
            sides.push(OutlineSide { start, end, center, radius, tangents, steps });
        }
        Ok(ConvexOutline { sides }.unwound())
    }

    /// Makes the steps ascend along the outline by one turn in total; `None` if that is not possible.
    fn unwound(mut self) -> Option<ConvexOutline> {
        let first = self.sides.first()?.steps[0];
        let mut last = first;
        for side in &mut self.sides {
            let ahead = (side.steps[0] - last + SMOOTH).rem_euclid(TURN) - SMOOTH;
            let [from, to] = side.steps;
            let turned = to - from;
            // At a smooth joint both tangents are made equal.
            let from = if ahead.abs() <= SMOOTH { last } else { last + ahead };
            side.steps = [from, from + turned];
            last = from + turned;
        }
        let over = last - first - TURN;
        if over.abs() <= SMOOTH && over > 0 {
            // The last side joins the first one smoothly, but exceeds it by rounding.
            let end = self.sides.len() - 1;
            let [from, to] = self.sides[end].steps;
            self.sides[end].steps = [from.min(first + TURN), to.min(first + TURN)];
        }
        (over <= SMOOTH).then_some(self)
    }

    /// Mirrored along the axis (`along_axis`) or at the axis.
    pub fn mirrored(&self, along_axis: bool) -> Option<ConvexOutline> {
        let flip = |p: Vec2| if along_axis { Vec2::new(-p.a, p.b) } else { Vec2::new(p.a, -p.b) };
        let sides = self.sides.iter().rev().map(|side| {
            let tangents = [side.tangents[1], side.tangents[0]].map(|tangent| -flip(tangent));
            let first = steps(tangents[0]);
            OutlineSide {
                start: flip(side.end),
                end: flip(side.start),
                center: flip(side.center),
                radius: side.radius,
                tangents,
                steps: [first, first + side.steps[1] - side.steps[0]],
            }
        });
        ConvexOutline { sides: sides.collect() }.unwound()
    }

    /// Moved by a vector, mm.
    pub fn moved(mut self, by: Vec2) -> ConvexOutline {
        for side in &mut self.sides {
            side.start = side.start + by;
            side.end = side.end + by;
            side.center = side.center + by;
        }
        self
    }

    /// The outline as segments.
    pub fn outline(&self) -> Vec<OutlineSegment> {
        let of = |side: &OutlineSide| match side.radius == 0.0 {
            true => OutlineSegment::line(side.start, side.end),
            false => OutlineSegment::arc(side.start, side.end, side.center, true),
        };
        self.sides.iter().map(of).collect()
    }

    /// Emits the elements that are passed while the tangent turns from `from` to `to` (exclusive), in order. Each
    /// argument is a direction in steps and the tangent itself.
    pub fn walk(&self, from: (i64, Vec2), to: (i64, Vec2), mut found: impl FnMut(WalkStep)) {
        let Some(first) = self.sides.first().map(|side| side.steps[0]) else { return };
        let mut clip = |element, tangents: [Vec2; 2], steps: [i64; 2]| {
            let (mut tangents, mut steps) = (tangents, steps);
            if steps[0] < from.0 {
                (steps[0], tangents[0]) = from;
            }
            if steps[1] > to.0 {
                (steps[1], tangents[1]) = to;
            }
            if steps[0] < steps[1] {
                found(WalkStep { element, tangents, steps });
            }
        };
        let mut base = (from.0 - first).div_euclid(TURN) * TURN;
        while first + base < to.0 {
            for (at, side) in self.sides.iter().enumerate() {
                let on = side.steps.map(|step| step + base);
                if side.radius > 0.0 {
                    clip(WalkElement::Arc(side.center, side.radius), side.tangents, on);
                } else if from.0 <= on[0] && on[0] < to.0 {
                    let element = WalkElement::Line(side.start, side.end);
                    // A line has a single direction, so it is emitted whole.
                    clip(element, side.tangents, [on[0], on[0] + 1]);
                }
                let next = self.sides.get(at + 1);
                let (tangent, step) = match next {
                    Some(next) => (next.tangents[0], next.steps[0]),
                    None => (self.sides[0].tangents[0], first + TURN),
                };
                let corner = WalkElement::Corner(side.end);
                clip(corner, [side.tangents[1], tangent], [on[1], step + base]);
            }
            base += TURN;
        }
    }
}
