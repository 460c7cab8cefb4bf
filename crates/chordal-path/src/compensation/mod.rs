//! Cutter radius compensation: turns the programmed path into the path of the tool centre, by the rules of the control.
//!
//! [`Compensator`] takes the commands of a run and emits the same commands, with the moves between G41 and G40
//! replaced, and the links that compensation inserts. It looks two moves ahead and buffers no more than that.
//!
//! The modules: `plane` has blocks and offsets in the two coordinates of the plane, `corner` the path at a corner,
//! `entry` the first and the last corner, `interference` the checks of the control, `queue` the blocks that wait for the
//! next move, `emit` the commands that are produced, `alarms` the diagnostics.

mod alarms;
mod corner;
mod emit;
mod entry;
mod interference;
mod plane;
mod queue;

use chordal_command::{Command, CommandKind, CompensationSide, Origin, Units};
use chordal_kernel::Alarms;
use chordal_kernel::rules::{AllowanceRule, RepeatedCodeRule, Rules};
use chordal_machine::PerAxis;
use std::collections::VecDeque;

use chordal_diagnostics::{Diagnostic, Span, TextShift};
use chordal_geometry::{Plane, Vec2};

pub use plane::CompensationCurve;
use queue::QueuedBlock;

/// A command of the tool-centre path.
#[derive(Clone, Copy, Debug)]
pub struct PathCommand<'a> {
    /// The command; positions of moves are those of the tool centre.
    pub command: &'a Command,
    /// The side the tool is on.
    pub side: CompensationSide,
    /// The offset, mm; 0 without compensation.
    pub cutter_radius_mm: f64,
    /// True for a link or a corner arc that compensation inserted; it has the origin of the block before it.
    pub inserted: bool,
}

/// The role of a block in a compensated contour.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum BlockRole {
    /// The move on which compensation starts.
    StartUp,
    /// A block of the contour.
    Contour,
    /// The move on which compensation ends.
    Cancel,
}

/// A block of a compensated contour with its path of the tool centre.
#[derive(Clone, Debug, PartialEq)]
pub struct ContourPiece {
    /// The number of the contour in the run, from 1: a contour goes from G41 or G42 to G40.
    pub contour_number: u32,
    /// The role of the block in the contour.
    pub role: BlockRole,
    /// The plane of the coordinates.
    pub plane: Plane,
    /// The programmed curve; `None` where only compensation moves the tool.
    pub programmed: Option<CompensationCurve>,
    /// The path of the tool centre, including the links after the block.
    pub centre: Vec<CompensationCurve>,
    /// +1: the tool is left of the contour; −1: right.
    pub sign: f64,
    /// The offset, mm.
    pub radius_mm: f64,
    /// The offset in the table is negative: the program already gives the tool centre and the offset is a wear, or the
    /// tool is meant to be on the other side.
    pub negative: bool,
    /// The block is a rapid, which cuts no wall.
    pub rapid: bool,
    /// Coordinates of the axis normal to the plane at the start and at the end, mm.
    pub height: (f64, f64),
    /// Units of the program at this block.
    pub units: Units,
    /// The position of the block in the program.
    pub origin: Origin,
}

/// Receives the tool-centre path as it is produced.
pub trait PathSink {
    /// A command as programmed; it comes before the commands of the tool centre that it leads to.
    fn programmed(&mut self, _command: &Command) {}
    /// A command of the tool centre.
    fn command(&mut self, command: PathCommand<'_>);
    /// A problem at a block.
    fn diagnostic(&mut self, diagnostic: Diagnostic, origin: &Origin);
    /// A block of a compensated contour.
    fn contour(&mut self, _piece: &ContourPiece) {}
    /// A program has ended; `head` is the position of its number in the text, if several programs are run together.
    fn ended(&mut self, _head: Span) {}
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum CompensationPhase {
    Off,
    /// G41 or G42 was programmed; the first move is still to come.
    Starting,
    On,
    /// G40 was programmed; the last move is still to come.
    Cancelling,
}

impl<S: PathSink> PathSink for &mut S {
    fn programmed(&mut self, command: &Command) {
        (**self).programmed(command);
    }

    fn command(&mut self, command: PathCommand<'_>) {
        (**self).command(command);
    }

    fn diagnostic(&mut self, diagnostic: Diagnostic, origin: &Origin) {
        (**self).diagnostic(diagnostic, origin);
    }

    fn contour(&mut self, piece: &ContourPiece) {
        (**self).contour(piece);
    }

    fn ended(&mut self, head: Span) {
        (**self).ended(head);
    }
}

/// Turns programmed moves into moves of the tool centre.
#[derive(Debug)]
pub struct Compensator {
    rules: Rules,
    alarms: Alarms,
    radius_override: Option<f64>,
    plane: Plane,
    units: Units,
    phase: CompensationPhase,
    side: CompensationSide,
    sign: f64,
    radius: f64,
    /// The block of the last G40, G41, G42 or D.
    code: Origin,
    toward: Option<Vec2>,
    /// The active code was programmed again: if it is in a block without motion, the block before ends perpendicular to
    /// its offset point.
    again: bool,
    /// The block of a G39 that applies to the next corner.
    round_next: Option<Origin>,
    /// Outside corners end where the offset paths meet, as far as the control lets them.
    corners_meet: bool,
    /// Inside corners are cut to the ends of both elements (M98).
    corners_open: bool,
    queue: VecDeque<Box<QueuedBlock>>,
    /// The programmed point of a turning tool relative to the centre of its nose, mm.
    tip: Vec2,
    /// The tool centre, mm, if it differs from the programmed point.
    at: Option<Vec2>,
    contour_number: u32,
}

/// What a [`Compensator`] remembers while compensation is off.
#[derive(Clone, Copy, Debug)]
pub struct CompensatorMemory {
    plane: Plane,
    units: Units,
    side: CompensationSide,
    sign: f64,
    radius: f64,
    code: Origin,
    toward: Option<Vec2>,
    again: bool,
    tip: Vec2,
}

impl CompensatorMemory {
    /// Moves the positions in the text after an edit of other text; `None` if one of them was in the edited text.
    pub fn shift(&mut self, shift: &TextShift) -> Option<()> {
        self.code = self.code.shifted(shift)?;
        Some(())
    }
}

impl Compensator {
    /// A compensator for one run on a control with these rules and alarm texts.
    pub fn new(rules: &Rules, alarms: Alarms) -> Compensator {
        Compensator {
            rules: *rules,
            alarms,
            radius_override: None,
            plane: rules.starts_in,
            units: rules.units,
            phase: CompensationPhase::Off,
            side: CompensationSide::Off,
            sign: 1.0,
            radius: 0.0,
            code: Origin::default(),
            toward: None,
            again: false,
            round_next: None,
            corners_meet: false,
            corners_open: false,
            queue: VecDeque::new(),
            tip: Vec2::new(0.0, 0.0),
            at: None,
            contour_number: 0,
        }
    }

    /// Uses this radius, mm, instead of those in the offset table.
    #[must_use]
    pub fn with_radius(mut self, radius_mm: f64) -> Compensator {
        self.radius_override = Some(radius_mm);
        self
    }

    /// Whether compensation is off and no block is queued.
    pub fn is_settled(&self) -> bool {
        self.phase == CompensationPhase::Off
            && self.queue.is_empty()
            && self.at.is_none()
            && self.round_next.is_none()
    }

    /// The memory of a compensator that [is settled](Self::is_settled).
    pub fn memory(&self) -> CompensatorMemory {
        CompensatorMemory {
            plane: self.plane,
            units: self.units,
            side: self.side,
            sign: self.sign,
            radius: self.radius,
            code: self.code,
            toward: self.toward,
            again: self.again,
            tip: self.tip,
        }
    }

    /// Restores a memory, to continue from that point of the run.
    pub fn recall(&mut self, memory: &CompensatorMemory) {
        let CompensatorMemory { plane, units, side, sign, radius, code, toward, again, tip } =
            *memory;
        self.tip = tip;
        (self.plane, self.units, self.side, self.code) = (plane, units, side, code);
        (self.sign, self.radius, self.toward, self.again) = (sign, radius, toward, again);
    }

    /// Follows a command.
    #[inline]
    pub fn command(&mut self, command: &Command, out: &mut impl PathSink) {
        if self.phase == CompensationPhase::Off && !concerns(&command.kind) {
            return out.command(PathCommand {
                command,
                side: CompensationSide::Off,
                cutter_radius_mm: 0.0,
                inserted: false,
            });
        }
        self.follow(command, out);
    }

    /// Emits the queued blocks and switches compensation off, as at the end of a program.
    pub fn finish(&mut self, out: &mut dyn PathSink) {
        self.end_square(out);
        self.phase = CompensationPhase::Off;
        self.side = CompensationSide::Off;
        self.at = None;
        self.plane = self.rules.starts_in;
        self.units = self.rules.units;
    }

    fn follow(&mut self, command: &Command, out: &mut dyn PathSink) {
        match &command.kind {
            CommandKind::Idle => self.idle(&command.origin),
            CommandKind::CornerArc { .. } => self.round_next = Some(command.origin),
            CommandKind::CornerMode { meets, opens } => {
                (self.corners_meet, self.corners_open) = (*meets, *opens);
            }
            CommandKind::Compensation { side, number: _, radius_mm, toward, tip } => {
                self.pass_on(command, out);
                let radius = self.radius_override.filter(|_| radius_mm != &Some(0.0));
                let radius = radius.or(*radius_mm).unwrap_or(0.0);
                if *side != CompensationSide::Off {
                    self.tip = Vec2::new(tip[0], tip[1]) * radius.abs();
                }
                self.switch(*side, radius, *toward, &command.origin, out);
            }
            CommandKind::Units(units) => {
                self.units = *units;
                self.pass_on(command, out);
            }
            CommandKind::Plane(plane) => {
                if self.phase != CompensationPhase::Off {
                    self.leave(out);
                    // The offset position was in the coordinates of the old plane.
                    self.at = None;
                }
                self.plane = *plane;
                self.pass_on(command, out);
            }
            CommandKind::WorkOffset { position, .. }
            | CommandKind::Surface { position, .. }
            | CommandKind::PartFrame { position, .. } => {
                self.shift(command, position, out);
            }
            CommandKind::Stop { .. } if self.rules.compensation.stops_end_look_ahead => {
                if let Some(last) = self.queue.back_mut() {
                    last.idle = last.idle.saturating_add(1000);
                }
                self.pass_on(command, out);
            }
            CommandKind::End => {
                self.finish(out);
                self.pass_on(command, out);
            }
            kind if kind.motion().is_some() => self.motion(command, out),
            _ => self.pass_on(command, out),
        }
    }

    /// Emits a command without motion after the queued blocks.
    fn pass_on(&mut self, command: &Command, out: &mut dyn PathSink) {
        if self.queue.is_empty() {
            return self.put(command, out);
        }
        let last = self.queue.len() - 1;
        self.queue[last].trailing.push(command.clone());
        if self.queue[last].trailing.len() > queue::MAX_TRAILING {
            self.too_many_idle(&command.origin, out);
            self.end_square(out);
        }
    }

    /// Applies G40, G41, G42, or a new offset number.
    fn switch(
        &mut self,
        side: CompensationSide,
        radius: f64,
        toward: Option<[f64; 2]>,
        origin: &Origin,
        out: &mut dyn PathSink,
    ) {
        let on = side != CompensationSide::Off && radius != 0.0 && radius.is_finite();
        let left = if side == CompensationSide::Right { -1.0 } else { 1.0 };
        let sign = if radius < 0.0 { -left } else { left };
        let rules = self.rules.compensation;
        self.toward = None;
        match (self.phase, on) {
            (CompensationPhase::Off, false) => {}
            (CompensationPhase::Off, true) => self.phase = CompensationPhase::Starting,
            (CompensationPhase::Starting, true) => {
                if rules.repeated == RepeatedCodeRule::Refused && self.code.span != origin.span {
                    self.twice(origin, out);
                }
            }
            (CompensationPhase::Starting, false) => self.phase = CompensationPhase::Off,
            (CompensationPhase::On, true) => {
                let same = sign == self.sign && side == self.side;
                if !same {
                    self.report_side_change(origin, out);
                } else if radius.abs() != self.radius {
                    if rules.new_offset == AllowanceRule::Refused {
                        self.new_offset_refused(origin, out);
                    }
                } else if rules.repeated == RepeatedCodeRule::Refused {
                    self.twice(origin, out);
                } else {
                    self.again = rules.repeated == RepeatedCodeRule::Perpendicular;
                }
            }
            (CompensationPhase::On, false)
                if side != CompensationSide::Off && rules.repeated == RepeatedCodeRule::Refused =>
            {
                if side == self.side {
                    self.twice(origin, out);
                } else {
                    self.side_change_refused(origin, out);
                }
            }
            (CompensationPhase::On, false) => {
                self.phase = CompensationPhase::Cancelling;
                self.toward = toward.map(|[a, b]| Vec2::new(a, b));
            }
            (CompensationPhase::Cancelling, true) => self.phase = CompensationPhase::On,
            (CompensationPhase::Cancelling, false) => {}
        }
        self.code = *origin;
        let kept = self.phase == CompensationPhase::On
            && side == self.side
            && rules.new_offset == AllowanceRule::Ignored;
        if on && !kept {
            (self.side, self.sign, self.radius) = (side, sign, radius.abs());
        }
        if self.phase == CompensationPhase::Off {
            self.side = CompensationSide::Off;
        }
    }

    /// Follows a block without motion; with G39 in it, the corner before it is rounded.
    fn idle(&mut self, origin: &Origin) {
        let rounds = self.round_next.take_if(|code| code.span == origin.span).is_some();
        if let (true, Some(last)) = (rounds, self.queue.back_mut()) {
            last.round = true;
        }
        if let Some(last) = self.queue.back_mut()
            && last.command.origin.span != origin.span
            && last.zero_move != Some(origin.span)
        {
            last.idle = last.idle.saturating_add(1);
        }
    }

    /// Follows a shift of the program coordinates: the tool does not move, and the contour continues from its position in
    /// the new coordinates.
    fn shift(&mut self, command: &Command, position: &PerAxis<f64>, out: &mut dyn PathSink) {
        let before = self.queue.back().map(|block| block.curve.to());
        if matches!(self.phase, CompensationPhase::On | CompensationPhase::Cancelling) {
            let rules = &self.rules.compensation;
            let over = self.phase == CompensationPhase::Cancelling && rules.off_at_once;
            if rules.coordinate_change == AllowanceRule::Refused && !over {
                self.shift_refused(&command.origin, out);
            }
            self.end_square(out);
            if let (Some(at), Some(before)) = (self.at, before) {
                self.at = Some(at + (plane::ab(position, self.plane) - before));
            }
        }
        self.pass_on(command, out);
    }
}

/// True for the commands that matter while compensation is off.
#[inline]
fn concerns(kind: &CommandKind) -> bool {
    matches!(
        kind,
        CommandKind::Compensation { .. }
            | CommandKind::Plane(_)
            | CommandKind::Units(_)
            | CommandKind::Idle
            | CommandKind::CornerArc { .. }
            | CommandKind::CornerMode { .. }
            | CommandKind::End
    )
}
