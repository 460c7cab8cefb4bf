//! Checks that need the path: travel of the axes, rapids into the part, nearly tangent joints, slow cuts.

mod cutting_speed;
mod joint;
mod part_frame;
mod surface;
mod tip;
mod turret;

use chordal_command::{
    AxisMask, Command, CommandKind, CompensationSide, Feed, FeedMode, Move, Origin, Position,
    Units, number_text,
};
use chordal_diagnostics::{Code, Diagnostic, Severity, Span, TextShift};
use chordal_geometry::{Aabb, Curve, ParamCurve, Plane, Vec3};
use chordal_kernel::Alarms;
use chordal_kernel::rules::LengthRules;
use chordal_machine::{AXES, Axis, Machine, PerAxis};

use crate::builder::duration_s;
use crate::compensation::PathCommand;
use crate::contour_rapid::{ContourRapid, OpenRapid};
use crate::excess::LimitExcess;
use crate::frame::ProgramFrame;
use crate::rapid_check::{LowRapid, RapidDirection, RapidLog};
use crate::segment::{curve_of, is_known, point};
use crate::tip::TipTracker;
use crate::turret_log::TurretLog;
use cutting_speed::CuttingSpeedMemory;
use turret::TurretMemory;

/// How many consecutive rapids at depth are remembered until a cut follows.
const LEGS_KEPT: usize = 16;

/// Feeds of at least this are not reported as too slow, mm/s (20 mm/min).
const SLOW_MM_PER_S: f64 = 20.0 / 60.0;

/// A cut at a slower feed is reported if it takes longer than this, s.
const LONG_CUT_S: f64 = 600.0;

/// Tolerance for rounding: a point below the clearance plane by less is on it, mm.
const ON_PLANE_MM: f64 = 1e-6;

/// Follows the commands of a run and reports problems of its path.
#[derive(Debug)]
pub struct RunChecks<'a> {
    machine: &'a Machine,
    /// The height of the clearance plane: no part of the workpiece is above it, mm.
    clearance_mm: f64,
    /// The machine is a lathe.
    turns: bool,
    /// An example of how programs limit the spindle speed with a constant cutting speed, for help texts.
    speed_limit_example: &'static str,
    /// What the control shows when an axis would leave its travel; `None` where it is not known.
    travel_alarm: Option<String>,
    /// What the control shows when a rotary axis cannot turn as fast as the feed of the tip needs; `None` on controls that
    /// slow down, or of which it is not known.
    tip_feed_alarm: Option<String>,
    /// No machine was chosen, and its limits are assumed: exceeding them is one note at the end.
    assumed: bool,
    /// The memory at the start of a program.
    start: ChecksMemory,
    now: ChecksMemory,
    seen: CheckedRange,
}

/// What the checks remember from command to command.
#[derive(Clone, Debug)]
pub struct ChecksMemory {
    frame: ProgramFrame,
    units: Units,
    /// Cutter compensation is active for the programmed moves.
    compensated: bool,
    /// Direction and position at the end of the last cut, and its plane if it was an arc.
    last: Option<(Vec3, Vec3, Option<Plane>)>,
    /// The last cut was below the clearance plane, and only the rapids of `legs` came after it.
    at_depth: bool,
    /// Rapids sideways at depth, until the next motion shows whether they lead to a cut.
    legs: Vec<LowRapid>,
    contour: ContourRapid,
    tip: TipTracker,
    cutting_speed: CuttingSpeedMemory,
    turret: TurretMemory,
    reported_axes: AxisMask,
    /// A rotary axis that cannot keep up was reported.
    reported_speed: bool,
}

/// What a part of a run has cut and moved through, for the checks that are made at the end of the run.
#[derive(Clone, Debug)]
pub struct CheckedRange {
    /// What is cut, in program coordinates, and the rapids below the clearance plane.
    rapids: RapidLog,
    /// On a lathe: what is cut, and where the turret indexes.
    turret: TurretLog,
    /// Lowest and highest known position of each axis, mm or rad, for machines whose offsets are not known.
    extent: PerAxis<(f64, f64)>,
    /// By how much the limits of an assumed machine were exceeded.
    excess: LimitExcess,
}

impl Default for CheckedRange {
    fn default() -> CheckedRange {
        let extent = [(f64::INFINITY, f64::NEG_INFINITY); AXES];
        CheckedRange {
            rapids: RapidLog::default(),
            turret: TurretLog::default(),
            extent,
            excess: LimitExcess::default(),
        }
    }
}

impl CheckedRange {
    /// Adds the range of the part of the run that follows.
    pub fn and(&mut self, next: &CheckedRange) {
        self.rapids.and(&next.rapids);
        self.turret.and(&next.turret);
        for (extent, other) in self.extent.iter_mut().zip(next.extent) {
            *extent = (extent.0.min(other.0), extent.1.max(other.1));
        }
        self.excess.and(&next.excess);
    }

    /// Moves the positions in the text after an edit of other text; `None` if one of them was in the edited text.
    pub fn shift(&mut self, shift: &TextShift) -> Option<()> {
        self.turret.shift(shift)?;
        self.rapids.shift(shift)
    }
}

impl ChecksMemory {
    /// Moves the positions in the text after an edit of other text; `None` if one of them was in the edited text.
    pub fn shift(&mut self, shift: &TextShift) -> Option<()> {
        for leg in &mut self.legs {
            leg.origin = leg.origin.shifted(shift)?;
        }
        self.cutting_speed.shift(shift)?;
        self.turret.shift(shift)?;
        self.contour.shift(shift)
    }
}

impl<'a> RunChecks<'a> {
    /// Checks for one run that begins in these units. `offset` and `known` come from
    /// [`initial_offset`](chordal_gcode::initial_offset).
    pub fn new(
        machine: &'a Machine,
        offset: Position,
        known: AxisMask,
        units: Units,
    ) -> RunChecks<'a> {
        let now = ChecksMemory {
            frame: ProgramFrame::new(offset, known),
            units,
            compensated: false,
            last: None,
            at_depth: false,
            legs: Vec::new(),
            contour: ContourRapid::default(),
            tip: TipTracker::new(machine, LengthRules::ABSENT, known),
            cutting_speed: CuttingSpeedMemory::default(),
            turret: TurretMemory::default(),
            reported_axes: AxisMask::NONE,
            reported_speed: false,
        };
        RunChecks {
            machine,
            clearance_mm: clearance_mm(machine),
            turns: machine.turns(),
            speed_limit_example: "",
            travel_alarm: None,
            tip_feed_alarm: None,
            assumed: false,
            start: now.clone(),
            now,
            seen: CheckedRange::default(),
        }
    }

    /// Checks the tip of a tool where the machine puts it, not where the program assumes it to be.
    pub fn with_tool_lengths(mut self, lengths: LengthRules) -> RunChecks<'a> {
        self.now.tip = TipTracker::new(self.machine, lengths, self.now.frame.known);
        self.start = self.now.clone();
        self
    }

    /// Sets the example of how programs limit the spindle speed with a constant cutting speed, for help texts.
    pub fn with_speed_limit_example(self, example: &'static str) -> RunChecks<'a> {
        RunChecks { speed_limit_example: example, ..self }
    }

    /// Sets the alarms of the control.
    pub fn with_alarms(self, alarms: Alarms) -> RunChecks<'a> {
        let text = |code| alarms.text(code).map(|text| format!("{}: {text}", alarms.title));
        let travel_alarm = text(Code::TravelExceeded);
        RunChecks { travel_alarm, tip_feed_alarm: text(Code::TipFeedTooFast), ..self }
    }

    /// Sets whether no machine was chosen, so that its limits are assumed.
    pub fn assumed(self, assumed: bool) -> RunChecks<'a> {
        RunChecks { assumed, ..self }
    }

    /// True for a problem that these checks report in another form because the limits of the machine are assumed.
    pub fn is_guessed(&self, code: Code) -> bool {
        self.assumed && matches!(code, Code::FeedOverLimit | Code::SpindleOverLimit)
    }

    /// What the checks remember at this point of the run.
    pub fn memory(&self) -> &ChecksMemory {
        &self.now
    }

    /// Restores a memory, to continue from that point of the run.
    pub fn recall(&mut self, memory: ChecksMemory) {
        self.now = memory;
    }

    /// Returns the range that was collected so far, and starts an empty one.
    pub fn take_seen(&mut self) -> CheckedRange {
        std::mem::take(&mut self.seen)
    }

    /// Adds a range to the collected one.
    pub fn add_seen(&mut self, seen: &CheckedRange) {
        self.seen.and(seen);
    }

    /// Follows a command as programmed. Joints of a compensated contour are checked here, because the program gives their
    /// coordinates; the corners of the tool centre path are computed.
    #[inline]
    pub fn programmed(&mut self, command: &Command, mut report: impl FnMut(Diagnostic)) {
        match &command.kind {
            CommandKind::Rapid { motion, .. } => {
                self.now.contour.rapid(motion, self.depth_mm(), command.origin);
            }
            CommandKind::Arc { motion, shape, .. } => {
                if let Some(rapid) = self.now.contour.arc(motion, shape) {
                    report(self.rapid_in_contour(&rapid));
                }
            }
            CommandKind::Line { .. } | CommandKind::Spiral { .. } | CommandKind::Spline { .. } => {
                self.now.contour.other();
            }
            _ => {}
        }
        match &command.kind {
            CommandKind::Compensation { side, number, radius_mm, .. } => {
                self.now.compensated = *side != CompensationSide::Off;
                if let (true, Some(number)) = (self.now.compensated, *number) {
                    self.radius_of_other_tool(command, number, *radius_mm, &mut report);
                }
            }
            CommandKind::Line { motion, .. } if self.now.compensated => {
                self.joint_of_line(motion, command.origin, &mut report);
            }
            CommandKind::Arc { motion, shape, .. } | CommandKind::Spiral { motion, shape, .. }
                if self.now.compensated =>
            {
                let curve = curve_of(motion, Some(shape));
                self.joint_of_arc(&curve, shape.plane, command.origin, &mut report);
            }
            _ => {}
        }
    }

    /// Follows a command of the tool centre path.
    #[inline]
    pub fn command(&mut self, path: PathCommand<'_>, mut report: impl FnMut(Diagnostic)) {
        let command = path.command;
        let as_programmed = path.side == CompensationSide::Off;
        if self.turns {
            self.turret(command);
            self.cutting_speed(command, &mut report);
        }
        if self.now.frame.surface.is_some() {
            return self.on_surface(path, &mut report);
        }
        if self.now.frame.part_frame.is_some() {
            self.now.tip.follow(command, self.machine);
            return self.on_tip(path, &mut report);
        }
        self.now.tip.follow(command, self.machine);
        if self.now.tip.is_open() {
            self.tip(command, &mut report);
        }
        if self.assumed {
            self.seen.excess.command(&command.kind, self.machine);
        }
        match &command.kind {
            CommandKind::Rapid { motion, .. } => {
                self.now.last = None;
                self.extend(&motion.to, motion.to_known);
                self.travel(&motion.to, motion.to_known, command.origin, &mut report);
                self.rapid(motion, command.origin);
            }
            CommandKind::Line { motion, feed } => {
                if feed.value < SLOW_MM_PER_S {
                    self.slow(feed, motion, &curve_of(motion, None), command.origin, &mut report);
                }
                self.extend(&motion.to, motion.to_known);
                self.travel(&motion.to, motion.to_known, command.origin, &mut report);
                self.end_legs();
                if is_known(motion) {
                    let (from, to) = (point(&motion.from), point(&motion.to));
                    self.seen.rapids.cut(|cut| cut.include(from).include(to));
                }
                if as_programmed {
                    self.joint_of_line(motion, command.origin, &mut report);
                }
                self.cut_at_depth(motion);
            }
            CommandKind::Arc { motion, shape, feed }
            | CommandKind::Spiral { motion, shape, feed } => {
                let curve = curve_of(motion, Some(shape));
                if feed.value < SLOW_MM_PER_S {
                    self.slow(feed, motion, &curve, command.origin, &mut report);
                }
                self.reach(curve.bounds(), motion, command.origin, &mut report);
                if as_programmed {
                    self.joint_of_arc(&curve, shape.plane, command.origin, &mut report);
                }
                self.cut_at_depth(motion);
            }
            CommandKind::Spline { motion, curve, .. } => {
                // Joints of splines are not checked: the program gives their directions explicitly.
                self.now.last = None;
                self.reach(curve.bounds(), motion, command.origin, &mut report);
                self.cut_at_depth(motion);
            }
            CommandKind::Units(units) => self.now.units = *units,
            _ => {
                self.now.frame.follow(command);
            }
        }
    }

    /// Reports a cut whose feed is so slow that it is probably a mistake.
    #[cold]
    fn slow(
        &self,
        feed: &Feed,
        motion: &Move,
        curve: &Curve,
        origin: Origin,
        report: &mut impl FnMut(Diagnostic),
    ) {
        let (length, time) = (curve.length(), duration_s(feed, motion, curve));
        if feed.mode != FeedMode::PerTime
            || length == 0.0
            || !has_known_length(motion)
            || time <= LONG_CUT_S
        {
            return;
        }
        let minutes = (time / 60.0).round() as u64;
        let time = match minutes / 60 {
            0 => format!("{minutes} minutes"),
            hours => format!("{hours} h {} min", minutes % 60),
        };
        let length = self.now.units.length_text(length);
        let feed = self.now.units.length_text(feed.value * 60.0);
        report(
            Diagnostic::new(
                Code::SlowCut,
                origin.span,
                format!("this cut takes {time}: {length} at {feed} a minute"),
            )
            .help("check F, and that G20 or G21 is the one that F was written for"),
        );
    }

    #[inline]
    fn extend(&mut self, place: &Position, known: AxisMask) {
        for (axis, extent) in self.seen.extent.iter_mut().enumerate() {
            if known.has(axis) {
                *extent = (extent.0.min(place[axis]), extent.1.max(place[axis]));
            }
        }
    }

    /// Follows a cut along a curve with these bounds.
    fn reach(
        &mut self,
        bounds: Aabb,
        motion: &Move,
        origin: Origin,
        report: &mut impl FnMut(Diagnostic),
    ) {
        for corner in [bounds.min, bounds.max] {
            let mut place = motion.to;
            place[..3].copy_from_slice(&corner.to_array());
            self.extend(&place, motion.to_known);
            self.travel(&place, motion.to_known, origin, report);
        }
        self.end_legs();
        if is_known(motion) {
            self.seen.rapids.cut(|cut| cut.union(bounds));
        }
    }

    #[inline]
    fn travel(
        &mut self,
        place: &Position,
        place_known: AxisMask,
        origin: Origin,
        report: &mut impl FnMut(Diagnostic),
    ) {
        if self.now.frame.known == AxisMask::NONE {
            return;
        }
        for axis in self.now.frame.known.and(place_known).without(self.now.reported_axes).iter() {
            let limits = self.machine.axes[axis as usize].as_ref();
            let Some((low, high)) = limits.and_then(|limits| limits.travel) else { continue };
            let at = self.now.frame.machine(place, axis as usize);
            let over = if at < low { low - at } else { at - high };
            if over > ON_PLANE_MM && self.assumed {
                self.seen.excess.travel(axis as usize, over);
            } else if over > ON_PLANE_MM {
                self.now.reported_axes.insert(axis as usize);
                report(self.travel_exceeded(axis, at, (low, high), over, origin));
            }
        }
    }

    fn travel_exceeded(
        &self,
        axis: Axis,
        at: f64,
        (low, high): (f64, f64),
        over: f64,
        origin: Origin,
    ) -> Diagnostic {
        let text = |value: f64| self.axis_text(axis, value);
        let mut diagnostic = Diagnostic::new(
            Code::TravelExceeded,
            origin.span,
            format!(
                "{} goes to {} in machine coordinates, {} beyond its travel",
                axis.letter(),
                text(at),
                text(over)
            ),
        )
        .label(format!("travel is {} to {}", text(low), text(high)))
        .help("check the work offset and the tool length in the machine file, then this block");
        diagnostic.alarm.clone_from(&self.travel_alarm);
        diagnostic
    }

    fn axis_text(&self, axis: Axis, value: f64) -> String {
        if axis.is_rotary() {
            return format!("{} deg", number_text(value.to_degrees(), 3));
        }
        self.now.units.length_text(value * self.machine.written_factor(axis as usize))
    }

    /// Follows a rapid. One that ends below the clearance plane is remembered until it is known what the run cuts:
    /// leaving a bore or a post sideways and then lifting is common and safe.
    fn rapid(&mut self, motion: &Move, origin: Origin) {
        self.seen.rapids.end_cut();
        let at_depth = std::mem::take(&mut self.now.at_depth);
        let mut legs = std::mem::take(&mut self.now.legs);
        // The R level of a cycle is a clearance plane of its own.
        if origin.cycle || !is_known(motion) {
            return;
        }
        let (plane, units) = (self.clearance_mm, self.now.units);
        let (from, to) = (point(&motion.from), point(&motion.to));
        if to.z >= self.depth_mm() {
            return;
        }
        let rapid = |course| LowRapid { direction: course, from, to, plane, units, origin };
        let sideways = (from.x, from.y) != (to.x, to.y);
        if sideways && to.z < from.z {
            self.seen.rapids.rapid(rapid(RapidDirection::Slanting));
        } else if sideways && at_depth {
            if legs.len() < LEGS_KEPT {
                legs.push(rapid(RapidDirection::Sideways));
            }
            (self.now.at_depth, self.now.legs) = (true, legs);
        } else if !sideways && to.z < from.z {
            self.seen.rapids.rapid(rapid(RapidDirection::Down));
        }
    }

    /// Positions below this height are at depth, mm.
    fn depth_mm(&self) -> f64 {
        self.clearance_mm - ON_PLANE_MM
    }

    /// Follows a cut: the rapids at depth that led to it from another cut are logged.
    #[inline]
    fn end_legs(&mut self) {
        if !self.now.legs.is_empty() {
            self.now.legs.drain(..).for_each(|leg| self.seen.rapids.rapid(leg));
        }
    }

    #[inline]
    fn cut_at_depth(&mut self, motion: &Move) {
        let below = motion.to[2] < self.depth_mm();
        self.now.at_depth = below && is_known(motion);
    }

    fn rapid_into_part(&self, rapid: &LowRapid) -> Diagnostic {
        let depth = rapid.units.length_text(rapid.depth());
        let message = match rapid.direction {
            RapidDirection::Sideways => format!(
                "between two cuts a rapid moves sideways {depth} below the clearance plane, where nothing was cut before"
            ),
            RapidDirection::Slanting => format!(
                "a rapid moves down at an angle to {depth} below the clearance plane, where nothing was cut before"
            ),
            RapidDirection::Down => format!(
                "a rapid plunges {depth} below the clearance plane, inside the region that is cut next"
            ),
        };
        let source =
            if self.machine.clearance_mm.is_some() { "the machine file's" } else { "Z0, the" };
        Diagnostic::new(Code::RapidIntoPart, rapid.origin.span, message)
            .label(format!("below {source} clearance plane"))
            .help("use G1 if this is a cut, or lift the tool first")
    }

    #[cold]
    fn rapid_in_contour(&self, rapid: &OpenRapid) -> Diagnostic {
        let length = self.now.units.length_text((rapid.to - rapid.from).length());
        let depth = self.now.units.length_text(self.clearance_mm - rapid.to.z);
        Diagnostic::new(
            Code::RapidIntoPart,
            rapid.origin.span,
            format!(
                "a rapid of {length} in a contour: it joins the arcs before and after it without a corner, {depth} below the clearance plane"
            ),
        )
        .label("the contour goes on at rapid speed")
        .help("write G1 in this block")
    }

    /// Makes the checks that need the whole program, and resets the memory for the next one. `head` is the position of
    /// the program number in the text, if several programs are run together.
    pub fn finish(&mut self, head: Span, mut report: impl FnMut(Diagnostic)) {
        self.judge_turret(&mut report);
        let rapids = std::mem::take(&mut self.seen.rapids);
        rapids.judge(|rapid| report(self.rapid_into_part(&rapid)));
        for axis in
            AxisMask::ALL.without(self.now.reported_axes).without(self.now.frame.known).iter()
        {
            self.whole_travel(axis, head, &mut report);
        }
        if let Some(note) = self.seen.excess.note(self.machine, self.now.units, head) {
            report(note);
        }
        self.now = self.start.clone();
        self.seen = CheckedRange::default();
    }

    /// Compares the extent of an axis with its travel if no work offset is known.
    fn whole_travel(&mut self, axis: Axis, head: Span, report: &mut impl FnMut(Diagnostic)) {
        let (low, high) = self.seen.extent[axis as usize];
        let limits = self.machine.axes[axis as usize].as_ref();
        let Some((from, to)) = limits.and_then(|limits| limits.travel) else { return };
        let over = (high - low) - (to - from);
        if over <= ON_PLANE_MM {
            return;
        }
        if self.assumed {
            self.seen.excess.travel(axis as usize, over);
            return;
        }
        report(
            Diagnostic::new(
                Code::TravelExceeded,
                head,
                format!(
                    "the program needs {} in {}, and the travel is {}",
                    self.axis_text(axis, high - low),
                    axis.letter(),
                    self.axis_text(axis, to - from)
                ),
            )
            .severity(Severity::Error)
            .help("no work offset makes it fit; choose a larger machine"),
        );
    }
}

/// The height of the clearance plane, mm. A lathe tool approaches from the side, so a lathe has none: minus infinity.
fn clearance_mm(machine: &Machine) -> f64 {
    match machine.turns() {
        true => f64::NEG_INFINITY,
        false => machine.clearance_mm.unwrap_or(0.0),
    }
}

/// Positions below this height are at depth, mm: below the clearance plane by more than rounding. Minus infinity on a
/// lathe.
pub fn depth_mm(machine: &Machine) -> f64 {
    clearance_mm(machine) - ON_PLANE_MM
}

/// True if the linear axes that move are known at both ends; the others add nothing to the length.
fn has_known_length(motion: &Move) -> bool {
    let known = motion.from_known.and(motion.to_known);
    (0..3).all(|axis| known.has(axis) || motion.from[axis] == motion.to[axis])
}
