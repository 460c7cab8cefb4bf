//! Emits blocks whose corners are known as commands of the tool centre.

use chordal_command::{ArcShape, Command, CommandKind, CompensationSide, Feed, Move};
use chordal_geometry::Vec2;
use chordal_kernel::rules::InterferenceSearch;
use chordal_machine::PerAxis;

use super::corner::CornerPath;
use super::plane::{CompensationCurve, NEGLIGIBLE_MM, offset_between};
use super::queue::QueuedBlock;
use super::{BlockRole, Compensator, ContourPiece, PathCommand, PathSink};

/// A compensated arc may exceed a full turn by this much because of rounding, rad.
const TURN_SLACK_RAD: f64 = 0.01;

impl Compensator {
    /// Emits a command that is not offset itself: its position in the plane is that of the tool centre.
    pub(super) fn put(&mut self, command: &Command, out: &mut dyn PathSink) {
        let (side, radius) =
            (self.side, if self.side == CompensationSide::Off { 0.0 } else { self.radius });
        let reported =
            |command| PathCommand { command, side, cutter_radius_mm: radius, inserted: false };
        match (self.at, command.kind.motion()) {
            (Some(at), Some(_)) => {
                let mut moved = command.clone();
                if let Some(motion) = motion_mut(&mut moved.kind) {
                    self.place(&mut motion.from, at);
                    self.place(&mut motion.to, at);
                }
                out.command(reported(&moved));
            }
            _ => out.command(reported(command)),
        }
    }

    /// Sets the position in the plane to that of the tool centre; for a turning tool, to that of its imaginary tip.
    fn place(&self, position: &mut PerAxis<f64>, at: Vec2) {
        let (a, b, _) = self.plane.axes();
        let at = self.tip_at(at);
        position[a] = at.a;
        position[b] = at.b;
    }

    /// The position that the control programs when the tool centre is at `centre`, mm: the imaginary tip of a turning
    /// tool.
    fn tip_at(&self, centre: Vec2) -> Vec2 {
        centre + self.tip
    }

    /// Emits a block, its corner and the commands after it.
    pub(super) fn emit(&mut self, block: Box<QueuedBlock>, out: &mut dyn PathSink) {
        let corner = block.corner.unwrap_or_else(|| CornerPath::at(block.square_end()));
        let mut centre = Vec::with_capacity(1 + corner.points().len());
        let mut at = self.at.unwrap_or(block.start);
        if block.loose && block.curve.is_arc() {
            at = self.reach_arc(&block, at, &mut centre, out);
        }
        let curve = self.centre_curve(&block, at, corner.first(), out);
        self.put_main(&block, &curve, out);
        centre.push(curve);
        let end = block.command.kind.motion().map(|motion| motion.to);
        let last_trailing =
            block.trailing.iter().rev().find_map(|command| Some(command.kind.motion()?.to));
        if self.rules.compensation.moves_before_corner && last_trailing.is_some() {
            self.at = Some(corner.first());
            self.put_trailing(&block, out);
            self.links(&block, &corner, last_trailing, &mut centre, out);
            self.at = Some(corner.last());
            self.emit_contour(&block, centre, out);
        } else {
            let before_corner = centre.len();
            self.links(&block, &corner, end, &mut centre, out);
            self.at = Some(corner.last());
            if corner.open {
                // There is no wall where the tool goes past the corner.
                centre.truncate(before_corner);
            }
            self.emit_contour(&block, centre, out);
            self.put_trailing(&block, out);
        }
        // The walls before an open corner are not those after it.
        self.contour_number += u32::from(corner.open);
    }

    /// Emits the commands after a block that are no part of the contour.
    fn put_trailing(&mut self, block: &QueuedBlock, out: &mut dyn PathSink) {
        let (side, radius) = (self.side, self.radius);
        (self.side, self.radius) = (block.side, block.radii.1);
        for command in &block.trailing {
            self.put(command, out);
        }
        (self.side, self.radius) = (side, radius);
    }

    /// Adds a straight move to the start of the offset arc, if the tool is not there yet.
    fn reach_arc(
        &mut self,
        block: &QueuedBlock,
        at: Vec2,
        centre: &mut Vec<CompensationCurve>,
        out: &mut dyn PathSink,
    ) -> Vec2 {
        let Some((tangent, _)) = block.tangents else { return at };
        let start = block.curve.from() + tangent.turned_left() * (block.sign * block.radii.0);
        if start.distance(at) > self.rules.compensation.tangent_mm {
            let link = CompensationCurve::Line { from: at, to: start };
            self.put_link(block, &link, block.command.kind.motion().map(|m| m.from), out);
            centre.push(link);
        }
        start
    }

    fn centre_curve(
        &mut self,
        block: &QueuedBlock,
        from: Vec2,
        to: Vec2,
        out: &mut dyn PathSink,
    ) -> CompensationCurve {
        if block.straight {
            return CompensationCurve::Line { from, to };
        }
        if block.role == BlockRole::StartUp && block.curve.is_arc() {
            return entry_arc(&block.curve, from, to);
        }
        let mut curve = offset_between(&block.curve, block.sign, block.radii, from, to);
        if let (
            CompensationCurve::Arc { sweep, .. },
            CompensationCurve::Arc { sweep: programmed, .. },
        ) = (&mut curve, block.curve)
        {
            let turn = std::f64::consts::TAU;
            let strict = self.rules.compensation.interference == InterferenceSearch::Strict;
            if strict && *sweep * programmed < 0.0 {
                // LinuxCNC keeps the direction and makes a full turn.
                *sweep += turn * programmed.signum();
            }
            if programmed.abs() <= turn + 1e-9 && sweep.abs() > turn + TURN_SLACK_RAD {
                *sweep -= turn * sweep.signum();
                self.turn_lost(block, out);
            }
        }
        curve
    }

    fn put_main(&mut self, block: &QueuedBlock, curve: &CompensationCurve, out: &mut dyn PathSink) {
        let mut command = block.command.clone();
        let Some(motion) = motion_mut(&mut command.kind) else { return };
        self.place(&mut motion.from, curve.from());
        self.place(&mut motion.to, curve.to());
        let moves = motion.from != motion.to;
        let motion = *motion;
        match (&mut command.kind, curve) {
            (
                CommandKind::Arc { shape, feed, .. } | CommandKind::Spiral { shape, feed, .. },
                CompensationCurve::Arc { center, sweep, radius_from, radius_to, .. },
            ) => {
                *feed = self.inside_feed(block, *feed, *radius_to);
                if radius_from.max(*radius_to) <= NEGLIGIBLE_MM * 1e3 {
                    // The arc has shrunk to a point.
                    command.kind = CommandKind::Line { motion, feed: *feed };
                    if !moves {
                        return;
                    }
                } else {
                    let center = self.tip_at(*center);
                    *shape = ArcShape {
                        plane: shape.plane,
                        center: [center.a, center.b],
                        sweep: *sweep,
                        radius_from: *radius_from,
                        radius_to: *radius_to,
                    };
                }
            }
            (
                CommandKind::Arc { feed, .. }
                | CommandKind::Spiral { feed, .. }
                | CommandKind::Spline { feed, .. },
                CompensationCurve::Line { .. },
            ) => {
                let feed = *feed;
                command.kind = CommandKind::Line { motion, feed };
            }
            (CommandKind::Line { .. } | CommandKind::Rapid { .. }, _) if !moves => return,
            _ => {}
        }
        out.command(PathCommand {
            command: &command,
            side: block.side,
            cutter_radius_mm: block.radii.1,
            inserted: block.made_up,
        });
    }

    /// The feed of a block: lower on inside arcs if the control keeps the feed at the cutting edge.
    fn inside_feed(&self, block: &QueuedBlock, feed: Feed, radius: f64) -> Feed {
        let least = self.rules.compensation.inside_feed_least;
        let CompensationCurve::Arc { radius_to, sweep, .. } = block.curve else { return feed };
        let inside = block.sign * sweep.signum() > 0.0;
        if least >= 1.0 || !inside || radius_to <= NEGLIGIBLE_MM {
            return feed;
        }
        Feed { value: feed.value * (radius / radius_to).clamp(least, 1.0), ..feed }
    }

    fn links(
        &mut self,
        block: &QueuedBlock,
        corner: &CornerPath,
        to: Option<PerAxis<f64>>,
        centre: &mut Vec<CompensationCurve>,
        out: &mut dyn PathSink,
    ) {
        let points = corner.points();
        if let Some((center, sweep)) = corner.arc {
            let radius = block.radii.1;
            let link = CompensationCurve::Arc {
                from: corner.first(),
                to: corner.last(),
                center,
                sweep,
                radius_from: radius,
                radius_to: radius,
            };
            self.put_link(block, &link, to, out);
            centre.push(link);
            return;
        }
        for pair in points.windows(2) {
            let link = CompensationCurve::Line { from: pair[0], to: pair[1] };
            self.put_link(block, &link, to, out);
            centre.push(link);
        }
    }

    /// Emits a link of a corner: it belongs to the block and moves only in the plane.
    fn put_link(
        &mut self,
        block: &QueuedBlock,
        link: &CompensationCurve,
        place: Option<PerAxis<f64>>,
        out: &mut dyn PathSink,
    ) {
        let Some(place) = place else { return };
        let Some(programmed) = block.command.kind.motion() else { return };
        let mut motion = Move {
            from: place,
            to: place,
            from_known: programmed.to_known,
            to_known: programmed.to_known,
        };
        self.place(&mut motion.from, link.from());
        self.place(&mut motion.to, link.to());
        // The link to a rapid is a rapid if the corner belongs to the block that follows.
        let of_next = self.rules.compensation.corner_of_next;
        let to_rapid = block.next_rapid.filter(|_| of_next);
        let to_rapid = to_rapid.filter(|_| link.is_arc());
        let kind = match (to_rapid, &block.command.kind, *link) {
            (Some(path), ..) => CommandKind::Rapid { motion, path },
            (None, CommandKind::Rapid { path, .. }, CompensationCurve::Line { .. }) => {
                CommandKind::Rapid { motion, path: *path }
            }
            (None, CommandKind::Rapid { path, .. }, _) if block.next_feed.is_none() => {
                CommandKind::Rapid { motion, path: *path }
            }
            (None, kind, CompensationCurve::Arc { center, sweep, radius_from, radius_to, .. }) => {
                // After a rapid, the arc is cut at the feed of the block that follows.
                let next = block.next_feed.as_ref();
                let feed = if of_next { next.or(kind.feed()) } else { kind.feed().or(next) };
                let Some(feed) = feed else { return };
                let center = self.tip_at(center);
                let shape = ArcShape {
                    plane: self.plane,
                    center: [center.a, center.b],
                    sweep,
                    radius_from,
                    radius_to,
                };
                CommandKind::Arc { motion, shape, feed: *feed }
            }
            (None, kind, CompensationCurve::Line { .. }) => {
                let Some(feed) = kind.feed() else { return };
                CommandKind::Line { motion, feed: *feed }
            }
        };
        out.command(PathCommand {
            command: &Command { kind, origin: block.command.origin },
            side: block.side,
            cutter_radius_mm: block.radii.1,
            inserted: true,
        });
    }

    /// Emits the move of a G40 without motion, type C: the tool moves to the programmed end of the contour.
    pub(super) fn move_back(&mut self, command: &Command, to: Vec2, out: &mut dyn PathSink) {
        let (Some(at), Some(motion)) = (self.at, command.kind.motion()) else { return };
        let to = to - self.tip;
        let mut motion = Move { to: motion.from, to_known: motion.from_known, ..*motion };
        self.place(&mut motion.from, at);
        self.place(&mut motion.to, to);
        let kind = match &command.kind {
            CommandKind::Rapid { path, .. } => CommandKind::Rapid { motion, path: *path },
            other => match other.feed() {
                Some(feed) => CommandKind::Line { motion, feed: *feed },
                None => return,
            },
        };
        out.command(PathCommand {
            command: &Command { kind, origin: self.code },
            side: self.side,
            cutter_radius_mm: self.radius,
            inserted: true,
        });
        self.at = Some(to);
    }

    /// Emits the move that ends compensation: from the tool centre straight to the programmed end.
    pub(super) fn emit_cancel(
        &mut self,
        command: &Command,
        curve: CompensationCurve,
        out: &mut dyn PathSink,
    ) {
        let from = self.at.unwrap_or(curve.from() - self.tip);
        let mut moved = command.clone();
        if let Some(motion) = motion_mut(&mut moved.kind) {
            self.place(&mut motion.from, from);
        }
        out.command(PathCommand {
            command: &moved,
            side: CompensationSide::Off,
            cutter_radius_mm: 0.0,
            inserted: false,
        });
        out.contour(&ContourPiece {
            contour_number: self.contour_number,
            role: BlockRole::Cancel,
            plane: self.plane,
            programmed: curve.moves().then_some(curve),
            centre: vec![CompensationCurve::Line { from, to: curve.to() - self.tip }],
            sign: self.sign,
            radius_mm: self.radius,
            negative: is_negative(self.side, self.sign),
            rapid: is_rapid(command),
            height: self.height(command),
            units: self.units,
            origin: command.origin,
        });
    }

    fn emit_contour(
        &self,
        block: &QueuedBlock,
        centre: Vec<CompensationCurve>,
        out: &mut dyn PathSink,
    ) {
        out.contour(&ContourPiece {
            contour_number: self.contour_number,
            role: block.role,
            plane: self.plane,
            programmed: (!block.made_up).then_some(block.curve),
            centre,
            sign: block.sign,
            radius_mm: block.radii.1,
            negative: is_negative(block.side, block.sign),
            rapid: is_rapid(&block.command),
            height: self.height(&block.command),
            units: self.units,
            origin: block.command.origin,
        });
    }

    fn height(&self, command: &Command) -> (f64, f64) {
        let (_, _, normal) = self.plane.axes();
        command.kind.motion().map_or((0.0, 0.0), |m| (m.from[normal], m.to[normal]))
    }
}

fn is_rapid(command: &Command) -> bool {
    matches!(command.kind, CommandKind::Rapid { .. })
}

/// True if the tool is on the side opposite to the code, because the radius is negative.
fn is_negative(side: CompensationSide, sign: f64) -> bool {
    side.sign() * sign < 0.0
}

/// The arc on which compensation starts: from the position of the tool, with the direction of the programmed arc at its
/// end.
fn entry_arc(curve: &CompensationCurve, from: Vec2, to: Vec2) -> CompensationCurve {
    let straight = CompensationCurve::Line { from, to };
    let (CompensationCurve::Arc { sweep, .. }, Some((_, tangent))) = (curve, curve.tangents())
    else {
        return straight;
    };
    let w = sweep.signum();
    let inward = tangent.turned_left() * w;
    let chord = from - to;
    let along = inward.dot(chord);
    if along.abs() <= NEGLIGIBLE_MM {
        return straight;
    }
    let radius = chord.dot(chord) / (2.0 * along);
    let center = to + inward * radius;
    let mut swept = super::plane::angle(from - center, to - center);
    if swept * w < 0.0 {
        swept += std::f64::consts::TAU * w;
    }
    CompensationCurve::Arc {
        from,
        to,
        center,
        sweep: swept,
        radius_from: from.distance(center),
        radius_to: to.distance(center),
    }
}

/// The move of a motion command.
fn motion_mut(kind: &mut CommandKind) -> Option<&mut Move> {
    match kind {
        CommandKind::Rapid { motion, .. }
        | CommandKind::Line { motion, .. }
        | CommandKind::Arc { motion, .. }
        | CommandKind::Spiral { motion, .. }
        | CommandKind::Spline { motion, .. } => Some(motion),
        _ => None,
    }
}
