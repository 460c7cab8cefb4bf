//! Roundings and chamfers at the end of a block: its move waits until the next one is known, then both are
//! shortened and the rounding or chamfer is inserted between them. In program coordinates.

use chordal_command::{
    ArcShape, AxisMask, CallPath, Command, CommandKind, Feed, FeedAlong, FeedMode, Move, Units,
    telling_number,
};
use chordal_diagnostics::{Code, Diagnostic};
use chordal_geometry::tolerance::COINCIDENT_MM;

use crate::corner_fit::{self, CornerFit, CornerLeg, CornerMisfit};
use crate::corner_queue::{CornerForm, ProgrammedCorner, QueuedItem, QueuedMove};
use crate::frames::InPlane;
use crate::kernel::Kernel;
use crate::modal::Modal;
use crate::rules::CornerMoves;
use crate::sink::AfterBlock;
use crate::state::State;

/// A shorter remainder of a move is not emitted, mm.
const LEFT_MM: f64 = 1e-6;

/// An arc whose radii differ by more cannot be rounded as a circle, mm.
const CIRCLE_MM: f64 = 0.05;

/// Two shortened moves and the piece between them; `None` for a move that the corner replaces completely.
struct JoinedMoves {
    first: Option<CommandKind>,
    corner: CommandKind,
    next: Option<CommandKind>,
}

/// Why a corner is not rounded or chamfered.
struct CornerRefusal {
    code: Code,
    what: String,
    help: String,
}

fn refusal(code: Code, what: impl Into<String>, help: &str) -> CornerRefusal {
    CornerRefusal { code, what: what.into(), help: help.into() }
}

impl Kernel<'_> {
    /// True while a cycle reads a contour whose blocks have corner words of their own (RS274/NGC G71 to G73).
    pub fn reads_contour_words(&self) -> bool {
        self.rules.turning.contour_words && self.collected.is_some()
    }

    /// A shorter corner of a contour is ignored, mm (rs274 2.9: a thousandth of the program's unit).
    fn least_corner_of_contour(&self) -> f64 {
        match self.state.units {
            Units::Inch => 0.0254,
            Units::Millimetre => 0.001,
        }
    }

    /// Ends a contour: a corner word at its last move has no effect.
    pub fn end_corners_of_contour(&mut self) {
        self.corners.request = None;
        if let Some(queued) = self.corners.queued.take() {
            self.pass_on(*queued);
        }
    }

    /// Takes back the requested corner when the move of the block comes later; `None` when there is none.
    pub fn take_requested_corner(&mut self) -> Option<ProgrammedCorner> {
        self.corners.request.take()
    }

    /// Says that the waiting move is complete: the next move, in this block or another, is the one after its corner.
    pub fn corner_move_done(&mut self) {
        if let Some(queued) = &mut self.corners.queued {
            queued.is_open = false;
        }
    }

    /// Requests a corner at the end of the next move of this block.
    pub fn request_corner(&mut self, corner: ProgrammedCorner) {
        self.corners.request = Some(corner);
    }

    /// True when a move waits for the next one, so that not all commands are emitted yet.
    pub fn waits_at_corner(&self) -> bool {
        self.corners.wait()
    }

    /// Emits a command, or keeps it until the corner before it is known.
    #[cold]
    pub(crate) fn emit_at_corner(&mut self, kind: CommandKind) {
        if kind.motion().is_none() {
            let command = self.in_work(kind, self.origin);
            match &mut self.corners.queued {
                Some(queued) => queued.waiting.push(QueuedItem::Command(command)),
                None => self.hand_over(&command),
            }
            return;
        }
        let kind = match self.corners.queued.take() {
            // When one block makes several moves, the corner is at the end of the last.
            Some(queued) if queued.is_open && self.corners.request.is_none() => {
                self.corners.request = Some(queued.corner);
                self.pass_on(*queued);
                Some(kind)
            }
            Some(queued) => self.join(*queued, kind),
            None => Some(kind),
        };
        match (self.corners.request.take(), kind) {
            (Some(corner), Some(kind)) => self.hold(corner, kind),
            (None, Some(kind)) => self.push(kind),
            (Some(corner), None) => {
                let what = "the corner before it takes all of this move";
                let refusal = refusal(Code::CornerTooLarge, what, "make one of the two smaller");
                self.refuse(&corner, refusal, None);
            }
            (None, None) => {}
        }
    }

    fn push(&mut self, kind: CommandKind) {
        let command = self.in_work(kind, self.origin);
        self.hand_over(&command);
    }

    /// Keeps a move until the next one is known, or emits it if it cannot end in a corner.
    fn hold(&mut self, corner: ProgrammedCorner, kind: CommandKind) {
        if let Err(refusal) = self.may_end_in_corner(&corner, &kind) {
            self.refuse(&corner, refusal, None);
            return self.push(kind);
        }
        self.corners.queued = Some(Box::new(QueuedMove {
            corner,
            kind,
            origin: self.origin,
            call: self.call,
            block_number: self.block_number,
            plane: self.state.plane,
            frames: self.state.frames.clone(),
            is_open: true,
            waiting: Vec::new(),
            checked: 0,
            dwells: 0,
        }));
    }

    fn may_end_in_corner(
        &self,
        corner: &ProgrammedCorner,
        kind: &CommandKind,
    ) -> Result<(), CornerRefusal> {
        let help = "write it into a block that cuts a line or an arc in the active plane";
        if self.origin.cycle || self.state.overrides.in_tap {
            return Err(refusal(Code::CornerBlock, "this block makes a cycle or a thread", help));
        }
        let plane = self.state.plane;
        if !matches!(self.state.frames.in_plane(plane), InPlane::Similar { .. }) {
            return Err(refusal(
                Code::NotFollowed,
                "the plane is scaled unequally or tilted",
                "write the corner as a block of its own",
            ));
        }
        if matches!(kind, CommandKind::Rapid { .. }) && !self.reads_contour_words() {
            return Err(refusal(Code::CornerBlock, "this block is a rapid", help));
        }
        self.leg(corner, kind, [Code::CornerBlock; 2]).map(drop)
    }

    /// A move as a leg of the corner, or why it cannot be one; the codes are those of a move outside the plane
    /// (`nothing`) and of another kind of move (`other`).
    fn leg(
        &self,
        corner: &ProgrammedCorner,
        kind: &CommandKind,
        [nothing, other]: [Code; 2],
    ) -> Result<CornerLeg, CornerRefusal> {
        let plane = self.state.plane;
        let (a, b, _) = plane.axes();
        let help = "write a line or an arc in the active plane";
        let in_contour = self.reads_contour_words();
        let (motion, feed, shape) = match kind {
            CommandKind::Line { motion, feed } => (motion, *feed, None),
            CommandKind::Arc { motion, shape, feed } => (motion, *feed, Some(shape)),
            CommandKind::Rapid { motion, .. } if in_contour => (motion, feed_of(kind), None),
            CommandKind::Rapid { .. } => {
                return Err(refusal(other, "the move is a rapid", help));
            }
            _ => return Err(refusal(other, "the move is a spiral or a spline", help)),
        };
        if feed.mode == FeedMode::InverseTime {
            return Err(refusal(
                Code::NotFollowed,
                "in inverse time (G93) the feed of the parts is not known",
                "write the corner as a block of its own",
            ));
        }
        let leaves = (0..motion.from.len())
            .any(|axis| axis != a && axis != b && motion.from[axis] != motion.to[axis]);
        if leaves {
            let [first, second] = [a, b].map(|axis| chordal_machine::Axis::ALL[axis].letter());
            return Err(refusal(
                nothing,
                format!("the move is not in the plane of {first} and {second}"),
                help,
            ));
        }
        if let Some(shape) = shape {
            if shape.plane != plane {
                return Err(refusal(nothing, "the arc is not in the active plane", help));
            }
            if self.rules.corner.moves != CornerMoves::LinesAndArcs && !in_contour {
                let title = self.alarms.title;
                let what = format!("the move is an arc; {title} does this between straight moves");
                return Err(refusal(other, what, "write the corner as a block of its own"));
            }
            if matches!(corner.form, CornerForm::Chamfer | CornerForm::ChamferOfLength) {
                return Err(refusal(
                    Code::NotFollowed,
                    "the move is an arc; chamfers are carried out between straight moves only",
                    "write the chamfer as a block of its own",
                ));
            }
            if (shape.radius_from - shape.radius_to).abs() > CIRCLE_MM {
                return Err(refusal(other, "the arc ends at another radius than it starts", help));
            }
        }
        let pick = |place: &chordal_command::Position| [place[a], place[b]];
        let leg = CornerLeg {
            from: pick(&motion.from),
            to: pick(&motion.to),
            arc: shape.map(|shape| (shape.center, shape.sweep)),
        };
        if leg.length() <= COINCIDENT_MM {
            return Err(refusal(nothing, "the move has no length in the plane", help));
        }
        Ok(leg)
    }

    /// Emits the waiting move, its corner, and what came after; returns what is left of the next move.
    fn join(&mut self, queued: QueuedMove, next: CommandKind) -> Option<CommandKind> {
        match self.corner_between(&queued, &next) {
            Ok(Some(JoinedMoves { first, corner, next })) => {
                let of_corner = queued.corner.block.unwrap_or(queued.origin);
                let first = first.into_iter().map(|part| (part, queued.origin));
                for (part, origin) in first.chain([(corner, of_corner)]) {
                    let command = self.in_work(part, origin);
                    self.hand_over(&command);
                }
                self.push_waiting(queued.waiting);
                next
            }
            Ok(None) => {
                self.pass_on(queued);
                Some(next)
            }
            Err(refusal) => {
                self.give_up(queued, refusal);
                Some(next)
            }
        }
    }

    /// The shortened moves and the corner between them; `None` when the moves continue straight.
    fn corner_between(
        &self,
        queued: &QueuedMove,
        next: &CommandKind,
    ) -> Result<Option<JoinedMoves>, CornerRefusal> {
        let codes = [Code::CornerNext, Code::CornerNextMotion];
        let help = "write a line or an arc in the same plane after it";
        if self.origin.cycle || self.state.overrides.in_tap {
            return Err(refusal(codes[1], "a cycle or a thread comes next", help));
        }
        if self.state.plane != queued.plane {
            return Err(refusal(codes[0], "the plane changes before the next move", help));
        }
        let (Some(first), Some(after)) = (queued.kind.motion(), next.motion()) else {
            return Ok(None);
        };
        let moved = first.to.iter().zip(&after.from).any(|(a, b)| (a - b).abs() > COINCIDENT_MM);
        if moved || self.state.frames != queued.frames {
            return Err(refusal(codes[0], "the coordinates change before the next move", help));
        }
        let one = self.leg(&queued.corner, &queued.kind, codes)?;
        let two = self.leg(&queued.corner, next, codes).map_err(|refusal| CornerRefusal {
            what: format!("after this block {}", refusal.what),
            ..refusal
        })?;
        let straight = self.rules.corner.straight_deg.to_radians();
        let legs = [&one, &two];
        let form = queued.corner.form;
        let size_mm = match form {
            CornerForm::ChamferOfLength => {
                corner_fit::leg_of_chamfer(&one, &two, queued.corner.size_mm)
            }
            _ => queued.corner.size_mm,
        };
        let mut fit = fit_of(form, legs, size_mm, straight);
        if let Err(CornerMisfit::TooLarge(room)) = fit
            && self.rules.corner.shortens
        {
            fit = fit_of(form, legs, room, straight);
        }
        let fit = match fit {
            Ok(Some(fit)) => fit,
            Ok(None) => return Ok(None),
            // Nearly tangent moves have no room for a corner and need none.
            Err(CornerMisfit::TooLarge(room))
                if self.reads_contour_words() && room < self.least_corner_of_contour() =>
            {
                return Ok(None);
            }
            Err(misfit) => return Err(self.too_large(&queued.corner, misfit, [&one, &two])),
        };
        let span = libm::hypot(fit.end[0] - fit.start[0], fit.end[1] - fit.start[1]);
        if self.reads_contour_words() && span < self.least_corner_of_contour() {
            return Ok(None);
        }
        let (a, b, _) = queued.plane.axes();
        let plane_axes = AxisMask(1 << a | 1 << b);
        // When the start of the first move is not known, neither is the corner.
        let known = match first.from_known.covers(plane_axes) {
            true => first.to_known,
            false => first.to_known.without(plane_axes),
        };
        let place = |point: [f64; 2]| {
            let mut place = first.to;
            (place[a], place[b]) = (point[0], point[1]);
            place
        };
        let (start, end) = (place(fit.start), place(fit.end));
        let shortened = Move { to: start, to_known: known, ..*first };
        let rest = [&one, &two].map(CornerLeg::length);
        let rest =
            [rest[0] - fit_length(&one, fit.lost[0]), rest[1] - fit_length(&two, fit.lost[1])];
        let first_part =
            (rest[0] > LEFT_MM).then(|| trimmed(&queued.kind, shortened, fit.lost[0], true));
        let motion = Move { from: start, to: end, from_known: known, to_known: known };
        let mut feed = feed_of(&queued.kind);
        feed.along = FeedAlong::Path;
        feed.value = queued.corner.feed.unwrap_or(feed.value);
        let corner = match fit.arc {
            None => CommandKind::Line { motion, feed },
            Some((center, sweep)) => {
                let radius = |at: [f64; 2]| libm::hypot(at[0] - center[0], at[1] - center[1]);
                let shape = ArcShape {
                    plane: queued.plane,
                    center,
                    sweep,
                    radius_from: radius(fit.start),
                    radius_to: radius(fit.end),
                };
                CommandKind::Arc { motion, shape, feed }
            }
        };
        let shortened = Move { from: end, from_known: known, ..*after };
        let next = (rest[1] > LEFT_MM).then(|| trimmed(next, shortened, fit.lost[1], false));
        Ok(Some(JoinedMoves { first: first_part, corner, next }))
    }

    fn too_large(
        &self,
        corner: &ProgrammedCorner,
        misfit: CornerMisfit,
        legs: [&CornerLeg; 2],
    ) -> CornerRefusal {
        let form = match corner.form {
            CornerForm::Rounding => "a radius",
            CornerForm::Chamfer | CornerForm::ChamferOfLength | CornerForm::ChordOfRounding => {
                "a chamfer"
            }
        };
        let room = match misfit {
            CornerMisfit::Reversal => {
                return refusal(
                    Code::CornerTooLarge,
                    "the next move goes back over this one: there is no corner",
                    "remove the word, or check the end points",
                );
            }
            CornerMisfit::TooLarge(room) => room,
        };
        // Rounded down, so that the size in the message fits; 1e-4, as bisection ends slightly below the limit.
        let increment = self.rules.least_increment(self.state.units);
        let room = ((room / increment + 1e-4).floor()) * increment;
        let [first, second] = legs.map(|leg| self.length_text(leg.length()));
        let size = self.length_text(corner.size_mm);
        CornerRefusal {
            code: Code::CornerTooLarge,
            what: format!(
                "{form} of {size} does not fit between this move of {first} and the next of {second}"
            ),
            help: format!("at most {} fits here", self.length_text(room)),
        }
    }

    /// After a block: decides whether a waiting corner may wait for another block.
    pub fn corner_block_done(&mut self) {
        if let Some(corner) = self.corners.request.take().filter(|_| !self.reads_contour_words()) {
            let help = "write it into a block that cuts a line or an arc in the active plane";
            let refusal = refusal(Code::CornerBlock, "this block makes no move", help);
            self.refuse(&corner, refusal, None);
        }
        let Some(queued) = &mut self.corners.queued else { return };
        let own = std::mem::take(&mut queued.is_open);
        let first_new = queued.checked;
        queued.checked = queued.waiting.len();
        if own {
            return;
        }
        let mut between = None;
        for waiting in &queued.waiting[first_new..] {
            let QueuedItem::Command(command) = waiting else { continue };
            match command.kind {
                CommandKind::Idle => {}
                CommandKind::Dwell { .. } => queued.dwells += 1,
                CommandKind::End => between = Some("the program ends before the next move"),
                CommandKind::Plane(_) => between = Some("the plane changes before the next move"),
                _ => {
                    between = between.or(Some("a block without a move comes before the next move"))
                }
            }
        }
        if queued.dwells > self.rules.corner.dwells_between {
            between = between.or(Some("a dwell comes before the next move"));
        }
        if let Some(what) = between
            && let Some(queued) = self.corners.queued.take()
        {
            let help = "write the next move into the block after it";
            self.give_up(*queued, refusal(Code::CornerNext, what, help));
        }
    }

    /// Ends the program: a waiting corner has no next move.
    pub fn end_corners(&mut self) {
        self.end_corner_before("the program ends before the next move");
    }

    /// Drops a waiting corner, with the reason `what`: the next move comes too late.
    pub(crate) fn end_corner_before(&mut self, what: &'static str) {
        self.corner_block_done();
        if let Some(queued) = self.corners.queued.take() {
            let help = "write the next move after it, or remove the word";
            self.give_up(*queued, refusal(Code::CornerNext, what, help));
        }
    }

    /// Passes on that a block is complete, in order with the waiting move.
    pub fn block_done(&mut self, modal: &dyn Fn(&State) -> Modal) {
        if self.corners.queued.is_some() {
            let after = Box::new((modal(&self.state), self.state.state_items()));
            let origin = self.origin;
            if let Some(queued) = &mut self.corners.queued {
                queued.waiting.push(QueuedItem::BlockDone(origin, after));
            }
            return;
        }
        let Kernel { state, sink, origin, .. } = self;
        let (modal, items) = (&|| modal(state), &|| state.state_items());
        sink.block_done(origin, &AfterBlock { modal, items });
    }

    fn give_up(&mut self, queued: QueuedMove, refusal: CornerRefusal) {
        let corner = queued.corner;
        let reached = (queued.call, queued.block_number);
        self.pass_on(queued);
        self.refuse(&corner, refusal, Some(reached));
    }

    /// Emits the waiting move unchanged, and what came after.
    fn pass_on(&mut self, queued: QueuedMove) {
        let kind = queued.frames.map().command(queued.kind, queued.plane);
        self.hand_over(&Command { kind, origin: queued.origin });
        self.push_waiting(queued.waiting);
    }

    fn push_waiting(&mut self, waiting: Vec<QueuedItem>) {
        for item in waiting {
            match item {
                QueuedItem::Command(command) => self.hand_over(&command),
                QueuedItem::BlockDone(origin, after) => {
                    let (modal, items) = (&|| after.0.clone(), &|| after.1.clone());
                    self.sink.block_done(&origin, &AfterBlock { modal, items });
                }
            }
        }
    }

    fn refuse(
        &mut self,
        corner: &ProgrammedCorner,
        refusal: CornerRefusal,
        reached: Option<(CallPath, Option<f64>)>,
    ) {
        let own = (self.call, self.block_number);
        if let Some((call, block_number)) = reached {
            (self.call, self.block_number) = (call, block_number);
        }
        let form = match corner.form {
            CornerForm::Rounding => "rounding",
            CornerForm::Chamfer | CornerForm::ChamferOfLength | CornerForm::ChordOfRounding => {
                "chamfer"
            }
        };
        let name = corner.name;
        let diagnostic = Diagnostic::new(
            refusal.code,
            corner.word,
            format!("no {form} for `{name}`: {}", refusal.what),
        )
        .label(format!("{} {}", form, telling_number(corner.size_mm, 4)))
        .help(refusal.help);
        self.report(diagnostic);
        (self.call, self.block_number) = own;
    }
}

fn feed_of(kind: &CommandKind) -> Feed {
    match kind.feed() {
        Some(feed) => *feed,
        None => Feed {
            value: f64::NAN,
            mode: FeedMode::PerTime,
            along: FeedAlong::Path,
            spindle_rev_per_s: 0.0,
            lead_change: 0.0,
            surface: None,
        },
    }
}

fn fit_length(leg: &CornerLeg, lost: f64) -> f64 {
    match leg.arc {
        None => lost,
        Some((_, sweep)) => leg.length() * lost / sweep.abs(),
    }
}

/// A line or an arc shortened at its end or at its beginning.
fn trimmed(kind: &CommandKind, motion: Move, lost: f64, at_end: bool) -> CommandKind {
    match kind {
        CommandKind::Line { feed, .. } => CommandKind::Line { motion, feed: *feed },
        CommandKind::Rapid { path, .. } => CommandKind::Rapid { motion, path: *path },
        CommandKind::Arc { shape, feed, .. } => {
            let (a, b, _) = shape.plane.axes();
            let place = if at_end { motion.to } else { motion.from };
            let radius = libm::hypot(place[a] - shape.center[0], place[b] - shape.center[1]);
            let mut shape = *shape;
            shape.sweep -= shape.sweep.signum() * lost;
            match at_end {
                true => shape.radius_to = radius,
                false => shape.radius_from = radius,
            }
            CommandKind::Arc { motion, shape, feed: *feed }
        }
        other => other.clone(),
    }
}

/// A corner of a form and a size (radius, or leg of the chamfer, mm) between two legs; `None` when they continue
/// straight.
fn fit_of(
    form: CornerForm,
    [one, two]: [&CornerLeg; 2],
    size_mm: f64,
    straight_rad: f64,
) -> Result<Option<CornerFit>, CornerMisfit> {
    match form {
        CornerForm::Rounding => corner_fit::rounding(one, two, size_mm, straight_rad),
        CornerForm::Chamfer | CornerForm::ChamferOfLength => {
            corner_fit::chamfer(one, two, size_mm, straight_rad)
        }
        CornerForm::ChordOfRounding => {
            let fit = corner_fit::rounding(one, two, size_mm, straight_rad);
            fit.map(|fit| fit.map(|fit| CornerFit { arc: None, ..fit }))
        }
    }
}
