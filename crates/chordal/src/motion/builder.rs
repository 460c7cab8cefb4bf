//! Makes moves that join on to each other, and waits, from the commands of the tool centre.

mod tip_moves;

use chordal_command::{
    AxisMask, Command, CommandKind, Origin, Overrides, PathMode, RotarySurface, SpindleState,
};
use chordal_diagnostics::Diagnostic;
use chordal_geometry::{Curve, EvenPart, Line, ParamCurve, Transform, Vec3};
use chordal_kernel::Outcome;
use chordal_kernel::rules::{PathRules, RapidFeed};
use chordal_machine::{AXES, FeedLimits, Machine, NonMotionTimes};
use chordal_motion::{AxisValues, CornerMode, MoveKind, MoveRequest};
use chordal_path::{
    AxisPiece, PathBuilder, PathCommand, PathSink, RotaryLimits, Segment, SegmentKind, SurfacePart,
    curve_of, rotary_parts, surface_parts,
};

use super::corner::{CornerRequest, PieceEnd, corner_of};
use super::operations::OperationFinder;
use super::options::ActiveMotionModes;
use super::{
    MachineLimits, MotionOptions, MotionReport, MotionSink, MotionStep, MotionWait,
    PlacedPartFrame, RefusedMove, StepKind, StepSource, UnknownAxes, WaitKind,
};
use crate::job::Job;

/// How many refused moves are kept for the report.
const MAX_REFUSED_MOVES: usize = 20;

/// Ends nearer than this are one point, mm or rad: they differ by the rounding of arc ends. Ends farther apart are a
/// jump of the coordinates.
const COINCIDENT_END: f64 = 1e-7;

/// A move that waits for the next one, which decides about the corner between them. It is large, and is therefore
/// passed on by reference.
struct PendingMove {
    step: MotionStep,
    ending: CornerRequest,
    source: StepSource,
}

/// Makes the moves and waits of a run, and keeps the last move until the next one is known.
pub(crate) struct MotionBuilder<'a, S> {
    path: PathBuilder<'a>,
    segments: Vec<Segment>,
    /// Memory for the moves of the axes of one command, each with the number of its path segment.
    tip_parts: Vec<(usize, AxisPiece)>,
    rules: PathRules,
    times: NonMotionTimes,
    feed: FeedLimits,
    rapid_speeds: AxisValues,
    /// True where the control gives rapids (G0) a feed instead of the axes' rapid speeds.
    rapids_at_feed: bool,
    optional_stop: bool,
    active: ActiveMotionModes,
    forced_mode: Option<PathMode>,
    /// Which override switches the program lets act.
    overrides: Overrides,
    dog_leg_shape: bool,
    spline_tolerance_mm: f64,
    axis_chord_tolerance_mm: f64,
    mode: PathMode,
    spindle_rpm: f64,
    /// The state of a laser, which the spindle codes switch.
    laser_state: SpindleState,
    /// The block that changed the power of a laser, while it may still have a motion of its own.
    laser_change: Option<Origin>,
    /// The face or cylinder on which two coordinates are programmed, while there is one.
    surface: Option<RotarySurface>,
    tool: u32,
    /// The end of the last move.
    at: Option<AxisValues>,
    shift: AxisValues,
    number: u32,
    /// Number of path segments before those of the current command.
    pieces: u64,
    /// Number of the path segment of the last step.
    piece: u64,
    /// X, Y and Z, and the rotary axes that the control has.
    axes: AxisMask,
    /// The number of the frame of the part in which the tip is; `None` where the path is that of the axes.
    part_frame: Option<u32>,
    /// The axes whose position is not known after the last move.
    unknown_places: AxisMask,
    pending: Option<PendingMove>,
    report: MotionReport,
    operations: OperationFinder,
    sink: S,
}

impl<'a, S: MotionSink> MotionBuilder<'a, S> {
    pub fn new(job: &'a Job<'_>, limits: MachineLimits, options: &MotionOptions, sink: S) -> Self {
        let machine: &Machine = job.machine();
        let rules = job.rules().path;
        let axes = job.axes().and(AxisMask::ROTARY).or(AxisMask::LINEAR);
        let report = MotionReport {
            limits,
            moves: 0,
            waits: 0,
            cuts_without_feed: 0,
            unknown_moves: 0,
            bent_rapids: 0,
            refused_moves: 0,
            refused: Vec::new(),
            part_frames: Vec::new(),
            outcomes: Vec::new(),
        };
        MotionBuilder {
            path: job.path_builder(),
            segments: Vec::new(),
            tip_parts: Vec::new(),
            mode: forced(options.path_mode, rules.start_mode()),
            rules,
            times: machine.times,
            feed: machine.feed,
            rapid_speeds: report.limits.rapid.velocity(),
            rapids_at_feed: job.rules().rapid_feed != RapidFeed::OfMachine,
            optional_stop: machine.switches.optional_stop,
            active: ActiveMotionModes::new(machine, options),
            forced_mode: options.path_mode,
            overrides: Overrides::ON,
            dog_leg_shape: options.dog_leg_shape,
            spline_tolerance_mm: options.spline_tolerance_mm,
            axis_chord_tolerance_mm: options.axis_chord_tolerance_mm,
            spindle_rpm: 0.0,
            laser_state: SpindleState::Off,
            laser_change: None,
            surface: None,
            tool: 0,
            at: None,
            shift: [0.0; AXES],
            number: 0,
            pieces: 0,
            piece: 0,
            unknown_places: axes.without(job.initial_offset().1.or(job.not_named_axes().all())),
            part_frame: None,
            axes,
            pending: None,
            report,
            operations: OperationFinder::new(job, options.operations),
            sink,
        }
    }

    /// Emits the last move and returns the report and the sink.
    pub fn finish(mut self, outcomes: Vec<Outcome>) -> (MotionReport, S) {
        self.hand_on(|_, _| CornerMode::Stop);
        self.report.outcomes = outcomes;
        (self.report, self.sink)
    }

    fn other_command(&mut self, command: &Command) {
        let origin = command.origin;
        match command.kind {
            CommandKind::Dwell { seconds, label: Some(_) } => {
                self.wait(WaitKind::ShopCode, seconds, origin);
            }
            CommandKind::PathMode(mode) => self.mode = forced(self.forced_mode, mode),
            CommandKind::Overrides(overrides) => self.overrides = overrides,
            CommandKind::Dwell { seconds, .. } => self.wait(WaitKind::Dwell, seconds, origin),
            CommandKind::Tool { number } => {
                let changes = number != self.tool;
                self.tool = number;
                if changes {
                    let seconds = self.times.tool_change_s.unwrap_or(0.0);
                    self.wait(WaitKind::ToolChange, seconds, origin);
                }
            }
            CommandKind::ToolNumber { number } => self.tool = number,
            CommandKind::Surface { surface, .. } => self.surface = surface,
            CommandKind::Spindle { state, rpm } => self.spindle(state, rpm, origin),
            CommandKind::Coolant(_) => {
                self.wait(WaitKind::Coolant, self.times.m_code_s.unwrap_or(0.0), origin);
            }
            CommandKind::Probed { .. } => {
                self.wait(WaitKind::Probe, self.times.probe_s.unwrap_or(0.0), origin);
            }
            CommandKind::Stop { optional } if !optional || self.optional_stop => {
                self.wait(WaitKind::Stop, 0.0, origin);
            }
            CommandKind::End => {
                self.wait(WaitKind::End, 0.0, origin);
                self.surface = None;
                self.mode = forced(self.forced_mode, self.rules.start_mode());
                self.overrides = Overrides::ON;
            }
            _ => {}
        }
    }

    /// The spindle takes time in proportion to the change of its speed; a reversal goes through zero.
    fn spindle(&mut self, state: SpindleState, rpm: f64, origin: Origin) {
        let target = match state {
            SpindleState::Cw => rpm,
            SpindleState::Ccw => -rpm,
            SpindleState::Off | SpindleState::Oriented => 0.0,
        };
        let difference = (target - self.spindle_rpm).abs();
        self.spindle_rpm = target;
        if self.rules.laser_mode {
            // A laser needs no time to change its power, but is switched only when the axes are at rest.
            let is_switched = std::mem::replace(&mut self.laser_state, state) != state;
            if is_switched {
                self.laser_change = None;
                self.wait(WaitKind::SpindleSpeed, 0.0, origin);
            } else if difference > 0.0 {
                self.laser_change = Some(origin);
            }
            return;
        }
        let per_1000 = self.times.spindle_per_1000_rpm_s.unwrap_or(0.0);
        if difference > 0.0 {
            self.wait(WaitKind::SpindleSpeed, difference / 1000.0 * per_1000, origin);
        }
        if state == SpindleState::Oriented {
            let seconds = self.times.spindle_orient_s.unwrap_or(0.0);
            self.wait(WaitKind::SpindleOrient, seconds, origin);
        }
    }

    /// A new power of the laser stops the axes, unless its block moves as well.
    #[inline]
    fn power_of_laser(&mut self, command: &Command, moves: bool) {
        let Some(changed) = self.laser_change else { return };
        let is_same_block =
            changed.span == command.origin.span && changed.call == command.origin.call;
        match (is_same_block, moves) {
            (true, true) => self.laser_change = None,
            (true, false) => {}
            (false, _) => {
                self.laser_change = None;
                self.wait(WaitKind::SpindleSpeed, 0.0, changed);
            }
        }
    }

    fn wait(&mut self, kind: WaitKind, seconds: f64, origin: Origin) {
        let seconds = if seconds > 0.0 && seconds.is_finite() { seconds } else { 0.0 };
        self.hand_on(|_, _| CornerMode::Stop);
        let tag = self.next_tag(&origin);
        let source = StepSource {
            tag,
            origin,
            tool: self.tool,
            kind: StepKind::Wait(kind),
            piece: self.piece,
            known: true,
            unknown_axes: UnknownAxes { places: self.unknown_places, ..UnknownAxes::default() },
            length: 0.0,
            nominal_s: seconds,
            shift: self.shift,
            part_frame: self.part_frame,
            operation: self.operations.step(&origin, kind == WaitKind::ToolChange, false),
        };
        self.report.waits += 1;
        // A wait cannot be refused: it has no motion that could exceed a limit.
        let _ = self.sink.step(&MotionStep::Wait(MotionWait { seconds, kind, tag }), &source);
    }

    fn next_tag(&mut self, origin: &Origin) -> u64 {
        let tag = StepSource::tag_of(self.number, origin.line);
        self.number = self.number.wrapping_add(1);
        tag
    }

    /// Makes steps of the spans of a spline, each divided where its speed is uneven.
    fn spline(&mut self, spans: &[Segment], cycle: bool) {
        let mut parts = Vec::new();
        for (piece, span) in (self.pieces..).zip(spans) {
            let mut push = |curve: Curve| {
                let length_mm = curve.length();
                let share = length_mm / span.length_mm;
                let duration_s = span.duration_s * share;
                parts.push((piece, Segment { curve, length_mm, duration_s, ..*span }));
            };
            match &span.curve {
                Curve::Spline(piece) => {
                    piece.even_parts(self.spline_tolerance_mm, &mut |part| match part {
                        EvenPart::Line(line) => push(line.into()),
                        EvenPart::Bent(bent) => push(bent.into()),
                    });
                }
                curve => push(*curve),
            }
        }
        parts.retain(|(_, part)| part.length_mm > 0.0);
        for (index, (piece, part)) in parts.iter().enumerate() {
            self.piece = *piece;
            self.segment(part, PieceEnd::new(cycle, index + 1 < parts.len()));
        }
    }

    /// Makes a move of one path segment.
    fn segment(&mut self, segment: &Segment, end: PieceEnd) {
        let kind = match segment.kind {
            SegmentKind::Rapid => MoveKind::Rapid,
            _ => MoveKind::Cut,
        };
        let path_length = end.tip_length_mm.and_then(|tip| tip_moves::path_length(segment, tip));
        let mut motion = MoveRequest {
            curve: segment.curve,
            rotary_from: segment.rotary_from,
            rotary_to: segment.rotary_to,
            path_length,
            speed: f64::INFINITY,
            corner: CornerMode::Stop,
            kind,
            tag: 0,
        };
        let length = motion.length();
        if length <= 0.0 {
            return;
        }
        let speed = match kind {
            MoveKind::Rapid => self.rapid_speed(&motion, length, segment.duration_s),
            MoveKind::Cut => self.cut_speed(segment, length, end.tip_length_mm),
        };
        let Some(speed) = speed else {
            self.report.cuts_without_feed += 1;
            self.hand_on(|_, _| CornerMode::Stop);
            return;
        };
        motion.speed = speed;
        // The last move must be emitted first: where it is refused, this one joins on to its start.
        let (rules, active) = (self.rules, self.active);
        self.hand_on(|last, ending| corner_of(last, ending, &motion, &rules, &active));
        self.join(&mut motion);
        motion.tag = self.next_tag(&segment.origin);
        let nominal_s = match kind {
            MoveKind::Rapid => segment.duration_s / self.rapid_override().min(1.0),
            MoveKind::Cut => length / speed,
        };
        let source = StepSource {
            tag: motion.tag,
            origin: segment.origin,
            tool: segment.tool,
            kind: StepKind::Move(segment.kind),
            piece: self.piece,
            known: segment.known,
            unknown_axes: self.unknown_axes(segment, &motion),
            length,
            nominal_s,
            shift: self.shift,
            part_frame: self.part_frame,
            operation: self.operations.step(&segment.origin, false, true),
        };
        self.at = Some(motion.to());
        self.unknown_places = self.axes.without(known_at(segment)[1]);
        let ending = CornerRequest {
            mode: self.mode,
            cycle: end.cycle,
            bends: end.bends,
            chord_tolerance_mm: end.chord_tolerance_mm,
        };
        self.pending = Some(PendingMove { step: MotionStep::Move(motion), ending, source });
    }

    fn unknown_axes(&self, segment: &Segment, motion: &MoveRequest) -> UnknownAxes {
        let [from, to] = known_at(segment);
        let places = self.axes.without(from.and(to));
        if places == AxisMask::NONE {
            return UnknownAxes::default();
        }
        let size = segment.curve.bounds().size().to_array();
        let turn = |axis: usize| motion.rotary_to[axis] - motion.rotary_from[axis];
        let mut moves = AxisMask::NONE;
        (0..3).filter(|axis| size[*axis] != 0.0).for_each(|axis| moves.insert(axis));
        (0..3).filter(|axis| turn(*axis) != 0.0).for_each(|axis| moves.insert(axis + 3));
        UnknownAxes { places, moves: moves.and(places) }
    }

    fn feed_override(&self) -> f64 {
        if self.overrides.feed { self.active.feed_override } else { 1.0 }
    }

    fn rapid_override(&self) -> f64 {
        if self.overrides.rapid { self.active.rapid_override } else { 1.0 }
    }

    /// Speed along a cut with the override, mm/s or rad/s, at most the machine's largest feed, which is that of the tip where
    /// its length is another one. `None` without a feed.
    fn cut_speed(&self, segment: &Segment, length: f64, tip_length_mm: Option<f64>) -> Option<f64> {
        // A cut without a feed has no duration. The largest feed of the machine must not replace one that the program
        // has not set.
        if segment.duration_s.is_nan() || segment.duration_s <= 0.0 {
            return None;
        }
        let speed = length / segment.duration_s * self.feed_override();
        let turns_only = segment.length_mm <= 0.0;
        let largest = if turns_only { self.feed.max_rad_per_s } else { self.feed.max_mm_per_s };
        let largest = largest.unwrap_or(f64::INFINITY);
        let speed = speed.min(match tip_length_mm {
            Some(tip) if tip > 0.0 => largest * length / tip,
            Some(_) => f64::INFINITY,
            None => largest,
        });
        (speed > 0.0 && speed.is_finite()).then_some(speed)
    }

    /// Speed of a rapid, mm/s or rad/s: infinite where only the axes limit it, otherwise by the override or the
    /// control's feed for rapids.
    fn rapid_speed(&self, motion: &MoveRequest, length: f64, duration_s: f64) -> Option<f64> {
        let part = self.rapid_override();
        if part >= 1.0 && !self.rapids_at_feed {
            return Some(f64::INFINITY);
        }
        let (from, to) = (motion.from(), motion.to());
        let seconds = (0..AXES)
            .map(|axis| (to[axis] - from[axis]).abs() / self.rapid_speeds[axis])
            .fold(0.0, f64::max);
        let seconds = if self.rapids_at_feed { seconds.max(duration_s) } else { seconds };
        Some(if seconds > 0.0 { length / seconds * part } else { f64::INFINITY })
    }

    /// Shifts a move so that it begins where the last one ended.
    fn join(&mut self, motion: &mut MoveRequest) {
        let from = motion.from();
        if let Some(at) = self.at {
            let away = |axis: usize| (from[axis] + self.shift[axis] - at[axis]).abs();
            if (0..AXES).any(|axis| away(axis) > COINCIDENT_END) {
                self.shift = std::array::from_fn(|axis| at[axis] - from[axis]);
            }
        }
        let shift = self.shift;
        if shift == [0.0; AXES] {
            return;
        }
        let by = Vec3::new(shift[0], shift[1], shift[2]);
        motion.curve = match motion.curve {
            Curve::Line(line) => Curve::Line(Line { start: line.start + by, end: line.end + by }),
            curve => curve.transformed(&Transform::translation(by)),
        };
        for axis in 0..3 {
            motion.rotary_from[axis] += shift[axis + 3];
            motion.rotary_to[axis] += shift[axis + 3];
        }
    }

    /// Emits the pending move with the corner at its end.
    fn hand_on(&mut self, corner: impl FnOnce(&MoveRequest, CornerRequest) -> CornerMode) {
        let Some(pending) = &mut self.pending else { return };
        let PendingMove { step, ending, source } = pending;
        if let MotionStep::Move(motion) = step {
            motion.corner = corner(motion, *ending);
        }
        match self.sink.step(step, source) {
            Ok(()) => {
                self.report.moves += 1;
                self.report.unknown_moves += u64::from(!source.known);
            }
            Err(error) => {
                if let MotionStep::Move(motion) = step {
                    self.at = Some(motion.from());
                }
                self.report.refused_moves += 1;
                if self.report.refused.len() < MAX_REFUSED_MOVES {
                    self.report.refused.push(RefusedMove { error, source: *source });
                }
            }
        }
        self.pending = None;
    }

    /// Makes steps of a cut under constant surface speed, in pieces with a speed each. Returns false for every other
    /// cut.
    fn keeps_surface_speed(&mut self, command: &Command, whole: &Segment) -> bool {
        let feed = command.kind.feed().filter(|feed| feed.surface.is_some());
        let (Some(feed), Some(motion)) = (feed, command.kind.motion()) else { return false };
        // The X coordinate of the program is the radius; the segment itself may have been shifted.
        let curve = curve_of(motion, command.kind.shape());
        let Some(parts) = surface_parts(feed, &curve) else { return false };
        self.in_parts(command, whole, parts);
        true
    }

    fn in_parts(&mut self, command: &Command, whole: &Segment, parts: Vec<SurfacePart>) {
        let count = parts.len();
        for (index, part) in parts.into_iter().enumerate() {
            let segment = Segment {
                curve: whole.curve.subsegment(part.from, part.to),
                length_mm: part.to - part.from,
                duration_s: part.seconds,
                ..*whole
            };
            self.segment(&segment, PieceEnd::new(command.origin.cycle, index + 1 < count));
        }
    }

    /// Makes steps of a cut on a face or cylinder whose rotary axis cannot keep up with the feed, in pieces as slow
    /// as that axis. Returns false for every other cut.
    fn waits_for_rotary(&mut self, command: &Command, whole: &Segment) -> bool {
        let (Some(surface), Some(motion)) = (self.surface, command.kind.motion()) else {
            return false;
        };
        if command.kind.feed().is_none() {
            return false;
        }
        let limits = RotaryLimits {
            velocity: self.report.limits.cut.velocity()[surface.rotary],
            acceleration: self.report.limits.cut.acceleration()[surface.rotary],
        };
        let curve = curve_of(motion, command.kind.shape());
        let Some(parts) = rotary_parts(&surface, &curve, whole.duration_s, limits) else {
            return false;
        };
        self.in_parts(command, whole, parts);
        true
    }

    /// Takes a command and its path segments, and the frame of the part in which they lie.
    pub fn follow(
        &mut self,
        command: &Command,
        segments: &[Segment],
        part_frame: Option<PlacedPartFrame>,
    ) {
        self.power_of_laser(command, !segments.is_empty());
        self.sink.command(command);
        if segments.is_empty() {
            return self.other_command(command);
        }
        self.moves(command, segments, part_frame);
        self.pieces += segments.len() as u64;
    }

    /// Makes the steps of a command that moves.
    fn moves(
        &mut self,
        command: &Command,
        segments: &[Segment],
        part_frame: Option<PlacedPartFrame>,
    ) {
        let Some((last, bends)) = segments.split_last() else { return };
        let last_piece = self.pieces + bends.len() as u64;
        let is_one = bends.is_empty() && last.kind != SegmentKind::Spline;
        if is_one {
            self.piece = last_piece;
            if self.keeps_surface_speed(command, last) || self.waits_for_rotary(command, last) {
                return;
            }
        }
        let cycle = command.origin.cycle;
        if let Some(part_frame) = part_frame
            && self.follows_tip(command, segments, part_frame)
        {
            return;
        }
        match bends.first() {
            _ if last.kind == SegmentKind::Spline => self.spline(segments, cycle),
            Some(first) if !self.dog_leg_shape => {
                self.piece = last_piece;
                self.segment(&chord(first, bends, last), PieceEnd::new(cycle, false));
            }
            _ => {
                self.report.bent_rapids += u64::from(!bends.is_empty());
                for (piece, segment) in (self.pieces..).zip(bends) {
                    self.piece = piece;
                    self.segment(segment, PieceEnd::new(cycle, true));
                }
                self.piece = last_piece;
                self.segment(last, PieceEnd::new(cycle, false));
            }
        }
    }
}

/// The axes whose position is known at the start and at the end of a path segment. An axis that the program does not
/// name counts as known, at zero.
fn known_at(segment: &Segment) -> [AxisMask; 2] {
    let linear = segment.places().map(|axes| axes.or(segment.not_named.all()));
    let rotary = [segment.from_known, segment.to_known].map(|axes| axes.and(AxisMask::ROTARY));
    [linear[0].or(rotary[0]), linear[1].or(rotary[1])]
}

/// One straight segment from the start to the end of a dog-leg rapid.
fn chord(first: &Segment, bends: &[Segment], last: &Segment) -> Segment {
    let line = Line { start: first.curve.start(), end: last.curve.end() };
    Segment {
        curve: Curve::Line(line),
        length_mm: line.length(),
        duration_s: bends.iter().map(|bend| bend.duration_s).sum::<f64>() + last.duration_s,
        rotary_from: first.rotary_from,
        ..*last
    }
}

impl<S: MotionSink> PathSink for MotionBuilder<'_, S> {
    fn command(&mut self, path: PathCommand<'_>) {
        let mut segments = std::mem::take(&mut self.segments);
        segments.clear();
        self.path.command(path.command, |segment| segments.push(*segment));
        let part_frame = PlacedPartFrame::of(&self.path);
        self.follow(path.command, &segments, part_frame);
        self.segments = segments;
    }

    fn diagnostic(&mut self, diagnostic: Diagnostic, _: &Origin) {
        self.sink.diagnostic(diagnostic);
    }
}

/// The path mode that the caller forces, or else the program's own. Whether short blocks are joined stays with the
/// program.
fn forced(requested: Option<PathMode>, own: PathMode) -> PathMode {
    match (requested, own) {
        (Some(PathMode::Continuous { tolerance_mm, joined: requested }), own) => {
            let joined = requested || matches!(own, PathMode::Continuous { joined: true, .. });
            PathMode::Continuous { tolerance_mm, joined }
        }
        (Some(requested), _) => requested,
        (None, own) => own,
    }
}
