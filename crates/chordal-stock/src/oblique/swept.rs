//! The sweep of an element on a piece of a move, between two convex bodies.

use chordal_geometry::{Curve, ParamCurve, Vec3};

use super::chord::MovingZones;
use super::element::ConvexElement;
use super::turn::ToolTurn;

/// Lengths that are counted for rounding, mm.
const ROUNDING_MM: f64 = 1e-6;

/// The motion of a tool.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ElementMotion<'a> {
    /// The path of the tip.
    pub curve: &'a Curve,
    pub turn: &'a ToolTurn,
    /// Its length, mm.
    length: f64,
    /// Upper bounds of the second derivative of the tip and of both derivatives of the direction by the share.
    bend: f64,
    rates: [f64; 2],
}

impl<'a> ElementMotion<'a> {
    pub fn new(curve: &'a Curve, turn: &'a ToolTurn) -> ElementMotion<'a> {
        let length = curve.length();
        let bend = match curve {
            Curve::Line(_) => 0.0,
            curve => curve.max_curvature() * length * length,
        };
        ElementMotion { curve, turn, length, bend, rates: turn.rates() }
    }

    /// The point at a height above the tip on the axis of the tool, at a share of the move.
    pub fn point(&self, share: f64, height: f64) -> Vec3 {
        let tip = match share {
            _ if self.length <= 0.0 || share <= 0.0 => self.curve.start(),
            _ if share >= 1.0 => self.curve.end(),
            _ => self.curve.point_at(share * self.length),
        };
        tip + self.turn.direction(share) * height
    }

    /// By how much the true sweep of an element may differ from that of its middle direction along a straight line,
    /// on a part of the move with this share of it, mm.
    pub fn deviation(&self, element: &ConvexElement, share: f64) -> f64 {
        self.deviation_within(element.reference, element.reach(), share)
    }

    /// The same for what is at most `reach` from the point at a height on the axis, mm.
    pub fn deviation_within(&self, height: f64, reach: f64, share: f64) -> f64 {
        let bend = self.bend + height.abs() * self.rates[1];
        let turned = 0.5 * self.rates[0] * share;
        0.125 * bend * share * share + turned * reach + ROUNDING_MM
    }

    /// Upper bound of how far a point of an element moves, mm.
    pub fn travel(&self, element: &ConvexElement) -> f64 {
        self.length + (element.reference.abs() + element.reach()) * self.rates[0]
    }

    /// The number of equal parts of the move on which no element deviates by more than this, mm; at most `most`.
    pub fn parts(&self, elements: &[ConvexElement], tolerance: f64, most: u32) -> u32 {
        let of = |element: &ConvexElement| {
            let bend = self.bend + element.reference.abs() * self.rates[1];
            let turn = 0.5 * self.rates[0] * element.reach();
            let least = 2.0 * turn / tolerance;
            let least = least.max((0.25 * bend / tolerance).sqrt());
            if least.is_finite() { least.ceil() } else { f64::from(most) }
        };
        elements.iter().map(of).fold(1.0, f64::max).min(f64::from(most)) as u32
    }
}

/// The sweep of an element on a part of a move.
#[derive(Clone, Debug)]
pub(crate) struct SweptElement<'a> {
    element: &'a ConvexElement,
    start: Vec3,
    travel: Vec3,
    axis: Vec3,
    /// How far the true sweep may be from that of the element in its middle direction, mm.
    pub deviation: f64,
}

impl<'a> SweptElement<'a> {
    /// The sweep between two shares of a move.
    pub fn new(
        element: &'a ConvexElement,
        motion: &ElementMotion<'_>,
        [from, to]: [f64; 2],
    ) -> SweptElement<'a> {
        let [start, end] = [from, to].map(|share| motion.point(share, element.reference));
        SweptElement {
            element,
            start,
            travel: end - start,
            axis: motion.turn.direction(0.5 * (from + to)),
            deviation: motion.deviation(element, to - from),
        }
    }

    /// Zones that are certainly swept.
    pub fn inner(&self) -> MovingZones {
        let zones = self.element.inner(self.deviation);
        MovingZones::new(zones, self.start, self.travel, self.axis)
    }

    /// Zones that contain everything that is at most `margin` from what may be swept, mm.
    pub fn outer(&self, margin: f64) -> MovingZones {
        let zones = self.element.outer(self.deviation + margin);
        MovingZones::new(zones, self.start, self.travel, self.axis)
    }

    /// The largest n·p of the points p that may be swept.
    fn support(&self, normal: Vec3) -> f64 {
        let along = normal.dot(self.axis);
        let across = (normal.length_squared() - along * along).max(0.0).sqrt();
        let place = normal.dot(self.start).max(normal.dot(self.start + self.travel));
        place + self.element.support(along, across) + self.deviation * normal.length()
    }

    /// The box of what may be swept: its least and its largest coordinates, mm.
    pub fn bounds(&self) -> [Vec3; 2] {
        let low = [Vec3::X, Vec3::Y, Vec3::Z].map(|axis| -self.support(-axis));
        let high = [Vec3::X, Vec3::Y, Vec3::Z].map(|axis| self.support(axis));
        [Vec3::from_array(low), Vec3::from_array(high)]
    }

    /// The lowest and the highest height at which something may be swept over a square (middle and half side, mm):
    /// bounds by the planes that touch the sweep where a vertical line through the middle leaves the zones. `None` where
    /// the line does not meet them; they must contain all that is swept over the square.
    pub fn span(&self, zones: &MovingZones, [x, y]: [f64; 2], half: f64) -> Option<[f64; 2]> {
        let ends = zones.chord(x, y)?;
        let mut span = ends.map(|end| end.z);
        for (side, end) in ends.iter().enumerate() {
            for normal in zones.normals(x, y, end).into_iter().flatten() {
                /// A plane that is steeper says nothing of a height.
                const LEAST_SLOPE: f64 = 1e-6;
                let is_outwards = if side == 0 { normal.z < 0.0 } else { normal.z > 0.0 };
                if !is_outwards || normal.z.abs() < LEAST_SLOPE {
                    continue;
                }
                // The plane over the corner of the square where it reaches farthest.
                let level = normal.x * x + normal.y * y;
                let tilt = half * (normal.x.abs() + normal.y.abs());
                let height = (self.support(normal) - level + tilt) / normal.z;
                span[side] = if side == 0 { span[0].max(height) } else { span[1].min(height) };
            }
        }
        (span[0] <= span[1]).then_some(span)
    }
}
