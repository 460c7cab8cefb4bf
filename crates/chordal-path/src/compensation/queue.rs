//! The queue of blocks that wait for the next move: a corner needs both of its blocks.

use chordal_command::{Command, CommandKind, Feed, FeedMode, RapidPath};
use chordal_diagnostics::Span;
use chordal_geometry::{ParamCurve, Plane, Vec2};
use chordal_kernel::rules::{
    AllowanceRule, AloneAction, CompensationPlanes, InterferenceRemedy, InterferenceSearch,
    LeadLength, OutsideCorner, SideChange,
};

use crate::curve_of;

use super::corner::{CornerPath, CornerRuleSet, corner, rounded};
use super::plane::{CompensationCurve, OffsetEdge};
use super::{BlockRole, CompensationPhase, Compensator, PathSink, entry};

/// The largest number of commands without motion that are queued after a block.
pub(super) const MAX_TRAILING: usize = 4096;

/// A move that waits for the corner at its end.
#[derive(Clone, Debug)]
pub(super) struct QueuedBlock {
    pub command: Command,
    pub curve: CompensationCurve,
    /// Unit tangents at its start and end.
    pub tangents: Option<(Vec2, Vec2)>,
    pub role: BlockRole,
    pub side: chordal_command::CompensationSide,
    pub sign: f64,
    /// The offset at the start and at the end, mm.
    pub radii: (f64, f64),
    /// Where the tool centre begins: the end of the corner before it, mm.
    pub start: Vec2,
    /// The tool centre does not begin on the offset of this block, but where the block before it ended.
    pub loose: bool,
    /// It represents a G41 or G40 in a block without motion.
    pub made_up: bool,
    /// The corner at its end is rounded by an arc.
    pub round: bool,
    /// An error of this block or of its corner was already reported.
    pub is_reported: bool,
    /// The tool centre moves straight, because points of the corners were dropped.
    pub straight: bool,
    /// It ends perpendicular to its last direction, whatever follows.
    pub square: bool,
    pub corner: Option<CornerPath>,
    /// The feed of the block after its corner.
    pub next_feed: Option<Feed>,
    /// The path of the block after its corner, if that is a rapid.
    pub next_rapid: Option<RapidPath>,
    /// The number of blocks without motion after it.
    pub idle: u32,
    /// The last block after it that did not move in the plane.
    pub zero_move: Option<Span>,
    /// The commands between it and the next move.
    pub trailing: Vec<Command>,
}

impl QueuedBlock {
    fn end_edge(&self) -> Option<OffsetEdge> {
        let (_, tangent) = self.tangents?;
        Some(OffsetEdge::along(self.curve, tangent, self.sign, self.radii.1))
    }

    fn start_edge(&self, radius: f64) -> Option<OffsetEdge> {
        let (tangent, _) = self.tangents?;
        Some(OffsetEdge::along(self.curve, tangent, self.sign, radius))
    }

    /// The point at its end, offset perpendicular to its direction there, mm.
    pub fn square_end(&self) -> Vec2 {
        match self.end_edge() {
            Some(edge) => self.curve.to() + edge.normal * edge.radius,
            None => self.curve.to(),
        }
    }
}

impl Compensator {
    /// Follows a move.
    pub(super) fn motion(&mut self, command: &Command, out: &mut dyn PathSink) {
        let Some(motion) = command.kind.motion() else { return };
        let ends =
            self.phase == CompensationPhase::Cancelling && self.rules.compensation.off_at_once;
        if command.origin.cycle && !ends {
            return self.cycle_move(command, out);
        }
        let curve = CompensationCurve::of(motion, command.kind.shape(), self.plane);
        if !curve.moves() {
            return match ends {
                true => self.cancel_block(command, curve, out),
                false => self.still_in_plane(command, out),
            };
        }
        let by_speed;
        let command = match self.as_speed(command) {
            Some(command) => {
                by_speed = command;
                &by_speed
            }
            None => command,
        };
        if matches!(command.kind, CommandKind::Spiral { .. }) {
            self.spiral(&command.origin, out);
        }
        match self.phase {
            CompensationPhase::Off => self.put(command, out),
            CompensationPhase::Starting => self.start_block(command, curve, out),
            CompensationPhase::On => self.contour_block(command, curve, out),
            CompensationPhase::Cancelling if curve.is_arc() => {
                self.ends_on_arc(&command.origin, out);
                self.contour_block(command, curve, out);
            }
            CompensationPhase::Cancelling => self.cancel_block(command, curve, out),
        }
    }

    /// A cut with an inverse-time feed as a cut at a speed, on a control that computes the speed from the programmed path
    /// and keeps it for the path of the tool. `None` otherwise.
    fn as_speed(&self, command: &Command) -> Option<Command> {
        if self.phase == CompensationPhase::Off || !self.rules.compensation.inverse_time_as_speed {
            return None;
        }
        let motion = command.kind.motion()?;
        let length = curve_of(motion, command.kind.shape()).length();
        let mut command = command.clone();
        let (CommandKind::Line { feed, .. } | CommandKind::Arc { feed, .. }) = &mut command.kind
        else {
            return None;
        };
        if feed.mode != FeedMode::InverseTime {
            return None;
        }
        (feed.value, feed.mode) = (feed.value * length, FeedMode::PerTime);
        Some(command)
    }

    /// Follows a move that does not move in the plane.
    fn still_in_plane(&mut self, command: &Command, out: &mut dyn PathSink) {
        let rules = &self.rules.compensation;
        let zero = command.kind.motion().is_some_and(|motion| motion.from == motion.to);
        if self.phase == CompensationPhase::Starting && rules.lead_follows_code {
            self.lead_too_short(&command.origin, 0.0, out);
        }
        let own_code = self.code.span == command.origin.span;
        if self.phase == CompensationPhase::Cancelling
            && own_code
            && rules.lead != LeadLength::Any
            && !zero
        {
            self.no_lead_out(&command.origin, out);
        }
        let counts = if zero { rules.zero_move_counts } else { 1 };
        if let Some(last) = self.queue.back_mut() {
            last.idle = last.idle.saturating_add(counts);
            last.zero_move = Some(command.origin.span);
        }
        self.pass_on(command, out);
    }

    fn block(
        &self,
        command: &Command,
        curve: CompensationCurve,
        role: BlockRole,
    ) -> Box<QueuedBlock> {
        let before = self.queue.back().map_or(self.radius, |block| block.radii.1);
        let round = self.round_next.is_some_and(|origin| origin.span == command.origin.span);
        Box::new(QueuedBlock {
            command: command.clone(),
            curve,
            tangents: curve.tangents(),
            role,
            side: self.side,
            sign: self.sign,
            radii: (before, self.radius),
            start: curve.from(),
            loose: false,
            made_up: false,
            round,
            is_reported: false,
            straight: false,
            square: false,
            corner: None,
            next_feed: None,
            next_rapid: None,
            idle: 0,
            zero_move: None,
            trailing: Vec::new(),
        })
    }

    fn start_block(&mut self, command: &Command, curve: CompensationCurve, out: &mut dyn PathSink) {
        let rules = self.rules.compensation;
        let plane_fits = match rules.planes {
            CompensationPlanes::All => true,
            CompensationPlanes::NotYz => self.plane != Plane::Yz,
            CompensationPlanes::XyOnly => self.plane == Plane::Xy,
        };
        if !plane_fits {
            self.plane_refused(&command.origin, out);
            self.phase = CompensationPhase::Off;
            return self.put(command, out);
        }
        if curve.is_arc() && !rules.start_on_arc {
            self.starts_on_arc(&command.origin, out);
            return self.put(command, out);
        }
        self.contour_number += 1;
        self.at = Some(curve.from() - self.tip);
        self.phase = CompensationPhase::On;
        let alone = self.code.span != command.origin.span;
        if alone && rules.on_alone == AloneAction::Perpendicular {
            return self.start_square(command, curve, out);
        }
        let length = curve.from().distance(curve.to());
        let short = match rules.lead {
            LeadLength::Any => false,
            LeadLength::AtLeastOffset => length < self.radius - 1e-6,
            LeadLength::AboveOffset => length <= self.radius + 1e-9,
        };
        if short {
            self.lead_too_short(&command.origin, length, out);
        }
        let block = self.block(command, curve, BlockRole::StartUp);
        self.queue.push_back(block);
    }

    /// Starts compensation after a G41 in a block without motion, type C: the tool first moves perpendicular to the
    /// contour.
    fn start_square(
        &mut self,
        command: &Command,
        curve: CompensationCurve,
        out: &mut dyn PathSink,
    ) {
        let here = curve.from();
        let mut lead = self.block(
            command,
            CompensationCurve::Line { from: here, to: here },
            BlockRole::StartUp,
        );
        lead.made_up = true;
        lead.command.origin = self.code;
        lead.command.kind = perpendicular_move(&command.kind);
        self.queue.push_back(lead);
        self.contour_block(command, curve, out);
    }

    fn contour_block(
        &mut self,
        command: &Command,
        curve: CompensationCurve,
        out: &mut dyn PathSink,
    ) {
        if std::mem::take(&mut self.again)
            && self.code.span != command.origin.span
            && let Some(last) = self.queue.back_mut()
        {
            last.square = true;
        }
        let mut new = self.block(command, curve, BlockRole::Contour);
        self.changes_allowed(&new, out);
        new.is_reported = self.inside_arc_too_small(&new, out);
        match self.queue.pop_back() {
            Some(before) => self.join(before, new, out),
            None => {
                new.start = self.at.unwrap_or(curve.from());
                new.loose = true;
                self.queue.push_back(new);
            }
        }
        while self.queue.len() > 2
            && let Some(block) = self.queue.pop_front()
        {
            self.emit(block, out);
        }
    }

    /// Reports another side or another offset in a block where the control refuses it.
    fn changes_allowed(&self, new: &QueuedBlock, out: &mut dyn PathSink) {
        let Some(before) = self.queue.back() else { return };
        let rules = &self.rules.compensation;
        let origin = &new.command.origin;
        if before.sign != new.sign {
            let refused = match rules.side_change {
                SideChange::Along => new.curve.is_arc(),
                SideChange::RefusedOnLine => !new.curve.is_arc(),
                SideChange::Crossing | SideChange::Refused => false,
            };
            if refused {
                self.side_change_refused(origin, out);
            }
        } else if new.radii.0 != new.radii.1
            && new.curve.is_arc()
            && rules.new_offset_on_arc == AllowanceRule::Refused
        {
            self.new_offset_refused(origin, out);
        }
    }

    /// Finds the corner between two blocks, checks whether the first block still fits, and puts both back into the queue.
    fn join(
        &mut self,
        mut before: Box<QueuedBlock>,
        mut new: Box<QueuedBlock>,
        out: &mut dyn PathSink,
    ) {
        let mut corner = self.corner_of(&before, &mut new, out);
        let long_arc = matches!(new.curve, CompensationCurve::Arc { sweep, .. }
            if sweep.abs() >= std::f64::consts::PI - 1e-9);
        let limit = self.rules.compensation.drop_link_mm;
        if limit > 0.0 && !long_arc && corner.arc.is_none() {
            corner.drop_short_links(limit);
        }
        if corner.missed {
            self.no_intersection(&before, &new, out);
            before.is_reported = true;
            new.is_reported = true;
        }
        new.start = corner.last();
        before.corner = Some(corner);
        before.next_feed = new.command.kind.feed().copied();
        before.next_rapid = match new.command.kind {
            CommandKind::Rapid { path, .. } => Some(path),
            _ => None,
        };
        self.settle(before, Some(&mut new), out);
        self.queue.push_back(new);
    }

    /// Makes the interference check of the control for a block whose corners are both known, and puts it back into the
    /// queue.
    fn settle(
        &mut self,
        mut block: Box<QueuedBlock>,
        new: Option<&mut QueuedBlock>,
        out: &mut dyn PathSink,
    ) {
        let strict = self.rules.compensation.interference == InterferenceSearch::Strict;
        let in_contour = block.role == BlockRole::Contour || (strict && !block.made_up);
        let checked = in_contour && !block.is_reported && !block.loose;
        if checked && let Some(found) = self.interferes(&mut block, new.as_deref()) {
            let avoid = self.rules.compensation.remedy == InterferenceRemedy::Avoid;
            if avoid && let Some(new) = new {
                match self.avoid(&block, new) {
                    Some(()) => {
                        self.avoided(&block, out);
                        if let Some(last) = self.queue.back_mut() {
                            last.trailing.append(&mut block.trailing);
                        }
                        return;
                    }
                    None => self.report_interference(&block, &found, out),
                }
            } else {
                self.report_interference(&block, &found, out);
            }
        }
        self.queue.push_back(block);
    }

    /// Tries to skip a block that does not fit: its neighbours are joined instead. `None` if that is not possible.
    fn avoid(&mut self, block: &QueuedBlock, new: &mut QueuedBlock) -> Option<()> {
        let before = self.queue.back_mut().filter(|b| b.role == BlockRole::Contour)?;
        let end = before.end_edge()?;
        let start = new.start_edge(block.radii.1)?;
        let at = before.curve.to();
        let point = super::plane::meeting(at, &end, &start, 0.0)?;
        // The control does not skip a block if the offset vectors differ by more than a right angle.
        let (one, other) = (point - at, point - new.curve.from());
        if one.dot(other) < 0.0 {
            return None;
        }
        before.corner = Some(CornerPath::at(point));
        new.start = point;
        Some(())
    }

    pub(super) fn corner_rules(&self) -> CornerRuleSet {
        let rules = &self.rules.compensation;
        CornerRuleSet {
            tangent_mm: rules.tangent_mm,
            tangent_sine: if rules.tangent_rad > 0.0 { libm::sin(rules.tangent_rad) } else { 0.0 },
            round: self.rules.outside_corner == OutsideCorner::Arc,
            opens: self.corners_open,
            cusps_meet: rules.cusps_meet,
            meets_rad: rules.corner_angles.map(|angles| {
                if self.corners_meet { angles.meets_rad } else { angles.always_meets_rad }
            }),
        }
    }

    fn corner_of(
        &mut self,
        before: &QueuedBlock,
        new: &mut QueuedBlock,
        out: &mut dyn PathSink,
    ) -> CornerPath {
        let at = before.curve.to();
        let rules = self.rules.compensation;
        let Some(first) = new.start_edge(before.radii.1) else { return CornerPath::at(at) };
        if before.made_up {
            return CornerPath::at(at + first.normal * first.radius);
        }
        let Some(end) = before.end_edge() else { return CornerPath::at(at) };
        let square = at + end.normal * end.radius;
        if rules.idle_blocks.is_some_and(|limit| before.idle > limit) {
            new.loose = true;
            self.look_ahead_lost(before, out);
            return CornerPath::at(if before.role == BlockRole::StartUp { at } else { square });
        }
        if before.square {
            new.loose = true;
            return CornerPath::at(square);
        }
        let how = self.corner_rules();
        if before.role == BlockRole::StartUp {
            return entry::start(self.rules.compensation_entry, at, &end, &first, &how);
        }
        if before.sign != new.sign {
            return match rules.side_change {
                SideChange::Along => {
                    new.loose = true;
                    CornerPath::at(square)
                }
                _ => entry::side_change(at, &end, &first, how.tangent_mm),
            };
        }
        if before.round { rounded(at, &end, &first, &how) } else { corner(at, &end, &first, &how) }
    }

    /// Follows the move on which compensation ends: all queued blocks are emitted.
    fn cancel_block(
        &mut self,
        command: &Command,
        curve: CompensationCurve,
        out: &mut dyn PathSink,
    ) {
        let alone = self.code.span != command.origin.span;
        let back = alone && self.rules.compensation.off_alone == AloneAction::Perpendicular;
        if let Some(mut last) = self.queue.pop_back() {
            let corner = if alone && back { None } else { self.last_corner(&last, curve) };
            last.corner = Some(corner.unwrap_or_else(|| CornerPath::at(last.square_end())));
            self.settle(last, None, out);
        }
        while let Some(block) = self.queue.pop_front() {
            self.emit(block, out);
        }
        if back {
            self.move_back(command, curve.from(), out);
        }
        self.emit_cancel(command, curve, out);
        self.at = None;
        self.phase = CompensationPhase::Off;
        self.side = chordal_command::CompensationSide::Off;
    }

    fn last_corner(&self, last: &QueuedBlock, curve: CompensationCurve) -> Option<CornerPath> {
        let at = last.curve.to();
        let end = last.end_edge()?;
        if last.role == BlockRole::StartUp {
            // G40 follows directly on G41: there was no contour.
            return Some(CornerPath::at(at + end.normal * end.radius));
        }
        if let Some(direction) = self.toward {
            let found = entry::toward(at, &end, direction, self.rules.compensation.tangent_mm);
            if found.is_some() {
                return found;
            }
        }
        let lead = OffsetEdge::start(curve, last.sign, last.radii.1)?;
        Some(entry::cancel(self.rules.compensation_entry, at, &end, &lead))
    }

    /// Emits the queued blocks; the last ends perpendicular to its direction, and the tool stays offset.
    pub(super) fn end_square(&mut self, out: &mut dyn PathSink) {
        if let Some(mut last) = self.queue.pop_back() {
            last.corner = Some(CornerPath::at(last.square_end()));
            self.settle(last, None, out);
        }
        while let Some(block) = self.queue.pop_front() {
            self.emit(block, out);
        }
    }

    /// Emits the queued blocks, and starts compensation again with the next move.
    pub(super) fn leave(&mut self, out: &mut dyn PathSink) {
        self.end_square(out);
        if self.phase == CompensationPhase::On {
            self.phase = CompensationPhase::Starting;
        }
    }

    /// Follows a move of a cycle, which is not offset: the contour continues from its end.
    fn cycle_move(&mut self, command: &Command, out: &mut dyn PathSink) {
        self.end_square(out);
        if let Some(motion) = command.kind.motion() {
            self.at = self.at.map(|_| super::plane::ab(&motion.to, self.plane) - self.tip);
        }
        let displaced = self.at.take();
        self.put(command, out);
        self.at = displaced;
    }
}

/// The move perpendicular to the contour for a G41 without motion, at the feed of the block after it.
fn perpendicular_move(kind: &CommandKind) -> CommandKind {
    let still = |motion: &chordal_command::Move| {
        let mut motion = *motion;
        motion.to = motion.from;
        motion.to_known = motion.from_known;
        motion
    };
    match kind {
        CommandKind::Rapid { motion, path } => {
            CommandKind::Rapid { motion: still(motion), path: *path }
        }
        CommandKind::Line { motion, feed }
        | CommandKind::Arc { motion, feed, .. }
        | CommandKind::Spiral { motion, feed, .. }
        | CommandKind::Spline { motion, feed, .. } => {
            CommandKind::Line { motion: still(motion), feed: *feed }
        }
        other => other.clone(),
    }
}
