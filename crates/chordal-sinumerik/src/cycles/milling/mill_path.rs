//! The moves of a cycle so far, made from points of the coordinates of a shape.

use chordal_geometry::TurnDirection;
use chordal_kernel::frames::sin_cos_degrees;

use super::MillStep;
use crate::alarms::NO_ALARM;
use crate::cycles::arguments::{CycleCall, CycleFault};

/// More moves than these in one cycle are a slip in an argument.
const MAX_MOVES: usize = 500_000;

/// Lengths below this are 0, in units of the program.
pub(super) const COINCIDENT: f64 = 1e-7;

/// The coordinates of a shape in the plane: its centre and the angle of its length.
#[derive(Clone, Copy, Debug)]
pub(super) struct ShapeFrame {
    origin: [f64; 2],
    sin: f64,
    cos: f64,
}

impl ShapeFrame {
    /// With a centre in coordinates of the program and an angle in degrees.
    pub(super) fn new(origin: [f64; 2], degrees: f64) -> ShapeFrame {
        let (sin, cos) = sin_cos_degrees(degrees);
        ShapeFrame { origin, sin, cos }
    }

    /// The coordinates of the program of a point of the shape.
    pub(super) fn point(&self, [along, across]: [f64; 2]) -> [f64; 2] {
        let [a, b] = self.origin;
        let turned = [self.cos * along - self.sin * across, self.sin * along + self.cos * across];
        [a + turned[0], b + turned[1]]
    }
}

/// A piece of a path in the coordinates of a shape.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) enum OutlinePiece {
    /// A straight piece to a point.
    Line([f64; 2]),
    /// An arc about a centre to a point.
    Arc { center: [f64; 2], direction: TurnDirection, to: [f64; 2] },
}

impl OutlinePiece {
    /// The piece on the other side of the length, run in the other direction.
    pub(super) fn mirrored(self) -> OutlinePiece {
        let flip = |[along, across]: [f64; 2]| [along, -across];
        match self {
            OutlinePiece::Line(to) => OutlinePiece::Line(flip(to)),
            OutlinePiece::Arc { center, direction, to } => OutlinePiece::Arc {
                center: flip(center),
                direction: direction.mirrored_if(true),
                to: flip(to),
            },
        }
    }
}

/// The moves of a cycle so far. Levels are coordinates of the program along the normal of the plane.
#[derive(Debug)]
pub(super) struct MillPath {
    pub(super) steps: Vec<MillStep>,
    at: [f64; 3],
    frame: ShapeFrame,
}

impl MillPath {
    /// No moves yet; the tool is at a position of the program.
    pub(super) fn new(position: [f64; 3]) -> MillPath {
        MillPath { steps: Vec::new(), at: position, frame: ShapeFrame::new([0.0; 2], 0.0) }
    }

    /// Points are those of another shape from here on.
    pub(super) fn set_frame(&mut self, frame: ShapeFrame) {
        self.frame = frame;
    }

    /// Refuses a path of more moves than a run carries out.
    ///
    /// # Errors
    /// [`NO_ALARM`].
    pub(super) fn check_length(&self, call: &CycleCall<'_>) -> Result<(), CycleFault> {
        if self.steps.len() > MAX_MOVES {
            let text = format!("{} would take more than {MAX_MOVES} moves", call.name());
            return Err(call.fault(NO_ALARM, None, &text));
        }
        Ok(())
    }

    /// The coordinates of the program in the plane at which the tool is.
    pub(super) fn place(&self) -> [f64; 2] {
        [self.at[0], self.at[1]]
    }

    /// The level at which the tool is.
    pub(super) fn level(&self) -> f64 {
        self.at[2]
    }

    fn end(&self, point: [f64; 2], level: f64) -> [f64; 3] {
        let [a, b] = self.frame.point(point);
        [a, b, level]
    }

    /// Whether the tool is at a point of the plane.
    fn is_at(&self, to: [f64; 3]) -> bool {
        (self.at[0] - to[0]).hypot(self.at[1] - to[1]) <= COINCIDENT
    }

    /// Rapid along the normal.
    pub(super) fn rapid_to_level(&mut self, level: f64) {
        if level != self.at[2] {
            self.at[2] = level;
            self.steps.push(MillStep::Rapid(self.at));
        }
    }

    /// Rapid in the plane.
    pub(super) fn rapid_to(&mut self, point: [f64; 2]) {
        let to = self.end(point, self.at[2]);
        if !self.is_at(to) {
            self.at = to;
            self.steps.push(MillStep::Rapid(to));
        }
    }

    /// Rapid to a point of the retract plane: along the normal first when the tool is below that plane, in the plane first
    /// otherwise. `direction` is 1 when the plane is above the part.
    pub(super) fn rapid_over(&mut self, point: [f64; 2], retract: f64, direction: f64) {
        if (self.at[2] - retract) * direction < 0.0 {
            self.rapid_to_level(retract);
        }
        self.rapid_to(point);
        self.rapid_to_level(retract);
    }

    /// A straight cut along the normal.
    pub(super) fn cut_to_level(&mut self, level: f64, feed: Option<f64>) {
        if level != self.at[2] {
            self.at[2] = level;
            self.steps.push(MillStep::Line { to: self.at, feed });
        }
    }

    /// A straight cut in the plane.
    pub(super) fn cut_to(&mut self, point: [f64; 2], feed: Option<f64>) {
        self.cut_down_to(point, self.at[2], feed);
    }

    /// A straight cut to a point at a level.
    pub(super) fn cut_down_to(&mut self, point: [f64; 2], level: f64, feed: Option<f64>) {
        let to = self.end(point, level);
        if level != self.at[2] || !self.is_at(to) {
            self.at = to;
            self.steps.push(MillStep::Line { to, feed });
        }
    }

    /// An arc in the plane, or a helix to a level, with full circles in addition. An arc to where the tool is, is a full
    /// circle.
    pub(super) fn arc(
        &mut self,
        center: [f64; 2],
        direction: TurnDirection,
        end: ([f64; 2], f64),
        turns: u32,
        feed: Option<f64>,
    ) {
        let mut to = self.end(end.0, end.1);
        if self.is_at(to) {
            (to[0], to[1]) = (self.at[0], self.at[1]);
        }
        let center = self.frame.point(center);
        self.at = to;
        self.steps.push(MillStep::Arc { center, direction, to, turns, feed });
    }

    /// Pieces in the plane.
    pub(super) fn cut_pieces(&mut self, pieces: &[OutlinePiece], feed: Option<f64>) {
        for piece in pieces {
            match *piece {
                OutlinePiece::Line(to) => self.cut_to(to, feed),
                OutlinePiece::Arc { center, direction, to } => {
                    self.arc(center, direction, (to, self.at[2]), 0, feed);
                }
            }
        }
    }

    /// The speed of the spindle; 0 changes nothing.
    pub(super) fn set_speed(&mut self, rpm: f64) {
        if rpm > 0.0 {
            self.steps.push(MillStep::SpindleSpeed(Some(rpm)));
        }
    }

    /// The speed of the program, after [`MillPath::set_speed`] with the same value.
    pub(super) fn end_speed(&mut self, rpm: f64) {
        if rpm > 0.0 {
            self.steps.push(MillStep::SpindleSpeed(None));
        }
    }
}
