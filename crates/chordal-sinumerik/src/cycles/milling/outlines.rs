//! The outlines of pockets and slots, and loops at a distance inside them.

use chordal_geometry::TurnDirection;

use super::mill_path::{COINCIDENT, OutlinePiece};

/// The outline of a pocket in its own coordinates: lengths along the first axis.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) enum PocketOutline {
    /// A rectangle about the origin with rounded corners. A slot has corners of half its width.
    Rectangle {
        /// Half the length and half the width.
        half: [f64; 2],
        /// The radius of the corners.
        corner: f64,
    },
    /// A circle about the origin.
    Circle {
        /// Its radius.
        radius: f64,
    },
    /// A slot along a circle about the origin, with its middle on the first axis and round ends.
    ArcSlot {
        /// The radius of its centre line.
        radius: f64,
        /// Half the angle between the centres of its ends, rad.
        half_angle: f64,
        /// Half its width.
        half_width: f64,
    },
}

impl PocketOutline {
    /// The distance from the outline at which a loop inside it has no width left.
    pub(super) fn half_width(&self) -> f64 {
        match *self {
            PocketOutline::Rectangle { half: [length, width], .. } => length.min(width),
            PocketOutline::Circle { radius } => radius,
            PocketOutline::ArcSlot { half_width, .. } => half_width,
        }
    }

    /// Whether a straight line between two points inside stays inside.
    pub(super) fn is_convex(&self) -> bool {
        !matches!(self, PocketOutline::ArcSlot { .. })
    }

    /// The line on which the innermost loop lies, as what a tool runs that starts at its first point; empty when it is a
    /// point. The second value is the first point.
    fn spine(&self) -> (Vec<OutlinePiece>, [f64; 2]) {
        match *self {
            PocketOutline::Circle { .. } => (Vec::new(), [0.0; 2]),
            PocketOutline::Rectangle { half, .. } => {
                let width = self.half_width();
                let end = half.map(|half| half - width);
                if end[0].max(end[1]) <= COINCIDENT {
                    return (Vec::new(), [0.0; 2]);
                }
                (vec![OutlinePiece::Line(end)], end.map(|half| -half))
            }
            PocketOutline::ArcSlot { radius, half_angle, .. } => {
                let (sin, cos) = libm::sincos(half_angle);
                let end = [radius * cos, radius * sin];
                let arc = |direction, to| OutlinePiece::Arc { center: [0.0; 2], direction, to };
                let pieces =
                    vec![arc(TurnDirection::Ccw, end), arc(TurnDirection::Cw, [radius, 0.0])];
                (pieces, [end[0], -end[1]])
            }
        }
    }

    /// What the tool runs after insertion to clear the innermost line: straight to its first end and along it. The first end
    /// is left out where the tool goes down there (`from_end`).
    pub(super) fn inner_cut(&self, from_end: bool) -> Vec<OutlinePiece> {
        let (mut pieces, first) = self.spine();
        // A helix ends beside a middle that is a point.
        if !from_end || pieces.is_empty() {
            pieces.insert(0, OutlinePiece::Line(first));
        }
        pieces
    }

    /// Where the tool goes down: at the first end of the innermost line, or at the middle.
    pub(super) fn insertion_point(&self, from_end: bool) -> [f64; 2] {
        match self {
            PocketOutline::ArcSlot { .. } => self.spine().1,
            _ if from_end => self.spine().1,
            _ => [0.0; 2],
        }
    }

    /// Half the length of the longest straight line of insertion about the middle, and its direction, when the tool's centre
    /// keeps a distance from the outline.
    pub(super) fn ramp(&self, distance: f64) -> (f64, [f64; 2]) {
        match *self {
            PocketOutline::Rectangle { half: [length, width], .. } if width > length => {
                (width - distance, [0.0, 1.0])
            }
            PocketOutline::Rectangle { half: [length, _], .. } => (length - distance, [1.0, 0.0]),
            PocketOutline::Circle { radius } => (radius - distance, [1.0, 0.0]),
            PocketOutline::ArcSlot { .. } => (0.0, [1.0, 0.0]),
        }
    }

    /// Where loops at a distance inside the outline begin: on the first axis, on its positive side.
    pub(super) fn loop_start(&self, distance: f64) -> [f64; 2] {
        let along = match *self {
            PocketOutline::Rectangle { half: [length, _], .. } => length - distance,
            PocketOutline::Circle { radius } => radius - distance,
            PocketOutline::ArcSlot { radius, half_width, .. } => radius + half_width - distance,
        };
        [along, 0.0]
    }

    /// The loop at a distance inside the outline, in a direction.
    pub(super) fn inner_loop(&self, distance: f64, direction: TurnDirection) -> Vec<OutlinePiece> {
        let pieces = match *self {
            PocketOutline::Rectangle { half, corner } => rectangle_loop(
                half.map(|half| (half - distance).max(0.0)),
                (corner - distance).max(0.0),
            ),
            PocketOutline::Circle { radius } => {
                let to = [radius - distance, 0.0];
                vec![OutlinePiece::Arc { center: [0.0; 2], direction: TurnDirection::Ccw, to }]
            }
            PocketOutline::ArcSlot { radius, half_angle, half_width } => {
                slot_loop(radius, half_angle, (half_width - distance).max(0.0))
            }
        };
        match direction {
            TurnDirection::Ccw => pieces,
            TurnDirection::Cw => pieces.into_iter().map(OutlinePiece::mirrored).collect(),
        }
    }

    /// Whether a tool that runs the loop at a distance cuts only inside a rectangle about the origin.
    pub(super) fn loop_is_inside(&self, distance: f64, tool_radius: f64, half: [f64; 2]) -> bool {
        let reach = match *self {
            PocketOutline::Rectangle { half, .. } => half.map(|half| half - distance),
            PocketOutline::Circle { radius } => [radius - distance; 2],
            PocketOutline::ArcSlot { .. } => return false,
        };
        (0..2).all(|axis| reach[axis] + tool_radius <= half[axis] + COINCIDENT)
    }
}

/// A counterclockwise loop about the origin from the middle of its right side, with a radius at its corners.
pub(super) fn rectangle_loop([a, b]: [f64; 2], corner: f64) -> Vec<OutlinePiece> {
    let corner = if corner <= COINCIDENT { 0.0 } else { corner.min(a).min(b) };
    let mut pieces = Vec::with_capacity(9);
    // Each corner: the signs of its quadrant, and where the side before it and the one after it meet the rounding.
    for (right, up) in [(1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0)] {
        let on_upright = [right * a, up * (b - corner)];
        let on_level = [right * (a - corner), up * b];
        let (first, second) =
            if right * up > 0.0 { (on_upright, on_level) } else { (on_level, on_upright) };
        pieces.push(OutlinePiece::Line(first));
        if corner > 0.0 {
            let center = [right * (a - corner), up * (b - corner)];
            pieces.push(OutlinePiece::Arc { center, direction: TurnDirection::Ccw, to: second });
        }
    }
    pieces.push(OutlinePiece::Line([a, 0.0]));
    pieces
}

/// A counterclockwise loop along a slot on a circle, from the middle of its outer side.
fn slot_loop(radius: f64, half_angle: f64, half_width: f64) -> Vec<OutlinePiece> {
    let (sin, cos) = libm::sincos(half_angle);
    let at = |radius: f64, side: f64| [radius * cos, side * radius * sin];
    let arc = |center, direction, to| OutlinePiece::Arc { center, direction, to };
    let (outer, inner) = (radius + half_width, radius - half_width);
    let has_width = half_width > COINCIDENT;
    let mut pieces = vec![arc([0.0; 2], TurnDirection::Ccw, at(outer, 1.0))];
    if has_width {
        pieces.push(arc(at(radius, 1.0), TurnDirection::Ccw, at(inner, 1.0)));
    }
    pieces.push(arc([0.0; 2], TurnDirection::Cw, at(inner, -1.0)));
    if has_width {
        pieces.push(arc(at(radius, -1.0), TurnDirection::Ccw, at(outer, -1.0)));
    }
    pieces.push(arc([0.0; 2], TurnDirection::Ccw, [outer, 0.0]));
    pieces
}
