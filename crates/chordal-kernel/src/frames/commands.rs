//! Commands of the kernel in the work coordinate system: moves, arcs and sides through the active frames.

use std::f64::consts::TAU;
use std::sync::Arc;

use chordal_command::{ArcShape, CommandKind, CompensationSide, Feed, Move, Position};
use chordal_geometry::{Plane, Spline, TurnDirection, Vec3, arc_sweep};
use chordal_machine::AXES;

use super::map::{FrameMap, InPlane};

impl FrameMap {
    /// Maps a command into the work coordinate system; `plane` is that of compensation.
    pub(crate) fn command(&self, kind: CommandKind, plane: Plane) -> CommandKind {
        match kind {
            CommandKind::Rapid { motion, path } => {
                CommandKind::Rapid { motion: self.motion(&motion), path }
            }
            CommandKind::Line { motion, feed } => {
                CommandKind::Line { motion: self.motion(&motion), feed }
            }
            CommandKind::Arc { motion, shape, feed }
                if self.in_plane(shape.plane) == InPlane::Tilted =>
            {
                self.tilted_arc(&motion, &shape, feed)
            }
            CommandKind::Arc { motion, shape, feed } => {
                let mapped = self.motion(&motion);
                CommandKind::Arc { motion: mapped, shape: self.shape(&shape, &mapped), feed }
            }
            CommandKind::Spiral { motion, shape, feed } => {
                let mapped = self.motion(&motion);
                CommandKind::Spiral { motion: mapped, shape: self.shape(&shape, &mapped), feed }
            }
            CommandKind::Spline { motion, curve, feed } => {
                let mapped = curve.mapped(|place| {
                    let mut at = motion.from;
                    (at[0], at[1], at[2]) = (place.x, place.y, place.z);
                    point(&self.point(&at))
                });
                let curve = Arc::new(mapped);
                CommandKind::Spline { motion: self.motion(&motion), curve, feed }
            }
            CommandKind::Compensation { side, number, radius_mm, toward, tip } => {
                let toward = toward.map(|course| self.distance_in_plane(plane, course));
                CommandKind::Compensation {
                    side: self.side(side, plane),
                    number,
                    radius_mm,
                    toward,
                    tip,
                }
            }
            CommandKind::CornerArc { toward } => CommandKind::CornerArc {
                toward: toward.map(|course| self.distance_in_plane(plane, course)),
            },
            CommandKind::WorkOffset { name, offset, zero, turned, known, position } => {
                let position = self.point(&position);
                CommandKind::WorkOffset { name, offset, zero, turned, known, position }
            }
            // The others have no coordinates.
            other @ (CommandKind::Dwell { .. }
            | CommandKind::Tool { .. }
            | CommandKind::ToolNumber { .. }
            | CommandKind::ToolSelect { .. }
            | CommandKind::ToolLength { .. }
            | CommandKind::CornerMode { .. }
            | CommandKind::Idle
            | CommandKind::Spindle { .. }
            | CommandKind::Coolant(_)
            | CommandKind::Stop { .. }
            | CommandKind::End
            | CommandKind::Units(_)
            | CommandKind::Plane(_)
            | CommandKind::FeedMode(_)
            | CommandKind::FeedRate { .. }
            | CommandKind::PathMode(_)
            | CommandKind::Overrides(_)
            | CommandKind::Surface { .. }
            | CommandKind::PartFrame { .. }
            | CommandKind::Probed { .. }
            | CommandKind::Message(_)
            | CommandKind::Output { .. }
            | CommandKind::Effect(_)) => other,
        }
    }

    fn motion(&self, motion: &Move) -> Move {
        Move {
            from: self.point(&motion.from),
            to: self.point(&motion.to),
            from_known: self.known(motion.from_known),
            to_known: self.known(motion.to_known),
        }
    }

    /// An arc between mapped ends. A tilted plane was refused before.
    fn shape(&self, shape: &ArcShape, mapped: &Move) -> ArcShape {
        let (a, b, _) = shape.plane.axes();
        let mut place = [0.0; AXES];
        (place[a], place[b]) = (shape.center[0], shape.center[1]);
        let center = self.point(&place);
        let center = [center[a], center[b]];
        match self.in_plane(shape.plane) {
            InPlane::Similar { factor, mirrored } => ArcShape {
                center,
                sweep: if mirrored { -shape.sweep } else { shape.sweep },
                radius_from: shape.radius_from * factor,
                radius_to: shape.radius_to * factor,
                ..*shape
            },
            InPlane::Unequal { mirrored, .. } => {
                let left = (shape.sweep > 0.0) != mirrored;
                let direction = if left { TurnDirection::Ccw } else { TurnDirection::Cw };
                let turns = full_turns(shape.sweep);
                arc_between(shape.plane, &mapped.from, &mapped.to, center, direction, turns)
            }
            InPlane::Tilted => ArcShape { center, ..*shape },
        }
    }

    /// A flat arc whose plane is no longer one of the axis planes: the same curve as a spline.
    fn tilted_arc(&self, motion: &Move, shape: &ArcShape, feed: Feed) -> CommandKind {
        let (a, b, normal) = shape.plane.axes();
        let mut center = motion.from;
        (center[a], center[b]) = (shape.center[0], shape.center[1]);
        let mut upright = [0.0; AXES];
        upright[normal] = 1.0;
        let mapped = self.motion(motion);
        let axis = point(&self.vector(&upright));
        let (start, end) = (point(&mapped.from), point(&mapped.to));
        let curve = Spline::arc(start, point(&self.point(&center)), axis, shape.sweep, end);
        match curve {
            Ok(curve) => CommandKind::Spline { motion: mapped, curve: Arc::new(curve), feed },
            Err(_) => CommandKind::Line { motion: mapped, feed },
        }
    }

    /// The side of compensation; a mirror exchanges left and right.
    pub(crate) fn side(&self, side: CompensationSide, plane: Plane) -> CompensationSide {
        side.mirrored_if(self.in_plane(plane).is_mirrored())
    }

    fn distance_in_plane(&self, plane: Plane, course: [f64; 2]) -> [f64; 2] {
        let (a, b, _) = plane.axes();
        let mut whole = [0.0; AXES];
        (whole[a], whole[b]) = (course[0], course[1]);
        let turned = self.vector(&whole);
        [turned[a], turned[b]]
    }
}

/// Full turns that an arc makes before its last, partial or full, turn.
fn full_turns(sweep: f64) -> u32 {
    ((sweep.abs() - 1e-9) / TAU).floor().max(0.0) as u32
}

fn arc_between(
    plane: Plane,
    from: &Position,
    to: &Position,
    center: [f64; 2],
    direction: TurnDirection,
    turns: u32,
) -> ArcShape {
    let (start, end) = (point(from), point(to));
    let fit = arc_sweep(plane, start, end, (center[0], center[1]), direction, turns);
    ArcShape {
        plane,
        center,
        sweep: fit.sweep,
        radius_from: fit.radius_start,
        radius_to: fit.radius_end,
    }
}

/// X, Y and Z of a position.
fn point(position: &Position) -> Vec3 {
    Vec3::new(position[0], position[1], position[2])
}
