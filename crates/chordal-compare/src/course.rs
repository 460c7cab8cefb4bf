//! Records what a program does, in order, for comparison.

use chordal::control::{
    Command, CommandKind, CompensationSide, Coolant, EndReason, FeedMode, Origin, Overrides,
    PathMode, Position, RapidPath, RotarySurface, SpindleState,
};
use chordal::geometry::{Curve, Line, ParamCurve, Transform};
use chordal::path::{AxisMoves, PathBuilder, SegmentKind};
use chordal::{Effect, Job, PathCommand, Report, RunWatch, Segment, SourceMap};

use crate::ComparisonOptions;
use crate::RunMapping;
use crate::category::Category;
use crate::machine_places::MachinePlaces;

/// A recorded run: its moves, each with the state in which it is made, and the events between them.
#[derive(Debug)]
pub(crate) struct ComparedRun {
    pub(crate) steps: Vec<RunStep>,
    /// The states; moves refer to them by index.
    pub(crate) states: Vec<MoveState>,
    /// The rotary axes A, B and C at both ends of a move, rad; moves refer to them by index.
    pub(crate) turns: Vec<[[f64; 3]; 2]>,
    pub(crate) report: Report,
}

#[derive(Clone, Debug, PartialEq)]
#[allow(clippy::large_enum_variant, reason = "most steps are moves")]
pub(crate) enum RunStep {
    Move(ComparedMove),
    Event { what: RunEvent, origin: Origin, deletable: Option<BlockDeleteUse> },
}

impl RunStep {
    pub(crate) fn origin(&self) -> &Origin {
        match self {
            RunStep::Move(moved) => &moved.origin,
            RunStep::Event { origin, .. } => origin,
        }
    }
}

/// A move of the tool centre in the frame of the run.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct ComparedMove {
    pub(crate) curve: Curve,
    pub(crate) length_mm: f64,
    /// Whether both ends are known relative to the part.
    pub(crate) known: bool,
    pub(crate) kind: ComparedMoveKind,
    /// The feed of a cut; `None` for rapids and before the first F.
    pub(crate) feed: Option<CutSpeed>,
    /// Whether F is per revolution.
    pub(crate) per_revolution: bool,
    pub(crate) turn: u32,
    pub(crate) state: u32,
    pub(crate) origin: Origin,
    /// The number of the command that made it: a dog-leg rapid has several moves.
    pub(crate) command: u32,
}

/// The kind of a move.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum ComparedMoveKind {
    Cut,
    Rapid,
    /// A rapid on which each axis moves at its own speed, so that it is not a straight line.
    DogLeg,
}

/// The speed of a cut, independent of the program's feed mode.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum CutSpeed {
    /// The speed along the path, mm/s.
    Path(f64),
    /// For a move of rotary axes only: the reciprocal of its duration, 1/s.
    Turn(f64),
    /// The feed per revolution of a spindle without a known speed, mm.
    PerRevolution(f64),
}

/// The modal state during a move.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct MoveState {
    pub(crate) spindle: SpindleState,
    pub(crate) rpm: f64,
    pub(crate) coolant: Coolant,
    pub(crate) length_offset: Option<u32>,
    /// The tool offsets that the program sets directly (G43.1), mm and rad; `None` when they come from the offset
    /// table.
    pub(crate) own_length: Option<Position>,
    pub(crate) radius_offset: Option<u32>,
    /// The side of cutter compensation; `Off` when the compensated path is compared.
    pub(crate) side: CompensationSide,
    pub(crate) work_offset: u32,
    pub(crate) path_mode: PathMode,
    pub(crate) overrides: Overrides,
    /// The rotating surface of polar or cylindrical interpolation.
    pub(crate) surface: Option<RotarySurface>,
    /// Coordinates are those of the tip on the part (tool centre point control, a tilted plane).
    pub(crate) on_part: bool,
    /// The block delete switch that can skip the block.
    pub(crate) deletable: Option<BlockDeleteUse>,
}

/// A block, or a part of it, that a block delete switch can skip.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct BlockDeleteUse {
    pub(crate) switch: u8,
    pub(crate) partly: bool,
}

/// An event between moves.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum RunEvent {
    Tool(u32),
    ReadyTool(u32),
    Code(String),
    Written {
        name: String,
        values: Vec<Option<f64>>,
    },
    Variable {
        number: u32,
        value: Option<f64>,
    },
    Message(String),
    Alarm {
        number: f64,
        text: String,
    },
    /// A block with block delete that causes no move and no other event.
    Deletable(BlockDeleteUse),
    Dwell(f64),
    Stop {
        optional: bool,
    },
    Probed {
        hit: bool,
    },
    Output(String),
}

impl ComparedRun {
    pub(crate) fn of(
        job: &Job,
        options: &ComparisonOptions,
        machine_places: Option<MachinePlaces>,
    ) -> ComparedRun {
        let assume_known = options.assume_known;
        let mut gather =
            RunRecorder { machine_places, assume_known, ..RunRecorder::new(job, options) };
        let report = if options.programmed {
            let builder = job.path_builder();
            let mut contour =
                ProgrammedPathSink { gather: &mut gather, builder, segments: Vec::new() };
            job.report_watched(&mut contour)
        } else {
            job.report_watched(&mut gather)
        };
        gather.end_deletable();
        let RunRecorder { steps, states, turns, .. } = gather;
        ComparedRun { steps, states, turns, report }
    }

    /// Whether the run was interrupted.
    pub(crate) fn was_interrupted(&self) -> bool {
        was_interrupted(&self.report)
    }

    /// Transforms all moves, and scales feeds and speeds.
    pub(crate) fn map(&mut self, mapping: &RunMapping) {
        let scale = mapping.path.scale_factor();
        for step in &mut self.steps {
            let RunStep::Move(moved) = step else { continue };
            moved.curve = moved.curve.transformed(&mapping.path);
            moved.length_mm *= scale;
            let state = &self.states[moved.state as usize];
            // Taps are recognized by the disabled feed override.
            let is_tap = moved.origin.cycle && !state.overrides.feed;
            let feed = match (is_tap, moved.per_revolution) {
                (true, _) => mapping.speed,
                (false, true) => mapping.feed * mapping.speed,
                (false, false) => mapping.feed,
            };
            moved.feed = moved.feed.map(|speed| match speed {
                CutSpeed::Path(speed) => CutSpeed::Path(speed * feed),
                CutSpeed::Turn(speed) => CutSpeed::Turn(speed * feed),
                CutSpeed::PerRevolution(feed) => CutSpeed::PerRevolution(feed * mapping.feed),
            });
        }
        for state in &mut self.states {
            state.rpm *= mapping.speed;
        }
    }

    /// The total length of the cuts whose ends are known, mm.
    pub(crate) fn cut_mm(&self) -> f64 {
        let cuts = self.steps.iter().map(|step| match step {
            RunStep::Move(moved) if moved.known && moved.kind == ComparedMoveKind::Cut => {
                moved.length_mm
            }
            RunStep::Move(_) | RunStep::Event { .. } => 0.0,
        });
        cuts.sum()
    }

    /// The lowest feed along the path of a cut, mm/s; `None` when no cut has one.
    pub(crate) fn slowest(&self) -> Option<f64> {
        let feeds = self.steps.iter().filter_map(|step| match step {
            RunStep::Move(ComparedMove { feed: Some(CutSpeed::Path(speed)), .. }) => Some(*speed),
            RunStep::Move(_) | RunStep::Event { .. } => None,
        });
        feeds.min_by(f64::total_cmp)
    }

    /// The total time of dwells and of the cuts whose feed is known, s.
    pub(crate) fn cutting_s(&self) -> f64 {
        let times = self.steps.iter().map(|step| match step {
            // The length of a move from an unknown position is unknown.
            RunStep::Move(moved) if !moved.known => 0.0,
            RunStep::Move(moved) => match moved.feed {
                Some(CutSpeed::Path(speed)) => moved.length_mm / speed,
                Some(CutSpeed::Turn(speed)) => 1.0 / speed,
                Some(CutSpeed::PerRevolution(_)) | None => 0.0,
            },
            RunStep::Event { what: RunEvent::Dwell(seconds), .. } => *seconds,
            RunStep::Event { .. } => 0.0,
        });
        times.sum()
    }

    pub(crate) fn move_count(&self) -> u64 {
        self.steps.iter().filter(|step| matches!(step, RunStep::Move(_))).count() as u64
    }

    /// The move at a step index; `None` for an event.
    pub(crate) fn moved(&self, step: usize) -> Option<&ComparedMove> {
        match self.steps.get(step)? {
            RunStep::Move(moved) => Some(moved),
            RunStep::Event { .. } => None,
        }
    }

    pub(crate) fn state(&self, moved: &ComparedMove) -> &MoveState {
        &self.states[moved.state as usize]
    }

    pub(crate) fn turn(&self, moved: &ComparedMove) -> &[[f64; 3]; 2] {
        &self.turns[moved.turn as usize]
    }
}

/// Whether the run was interrupted.
pub(crate) fn was_interrupted(report: &Report) -> bool {
    report.outcomes.iter().any(|outcome| outcome.end == EndReason::Interrupted)
}

/// Arcs with more turns are not split.
const MAX_TURNS: f64 = 1e5;

struct RunRecorder<'j> {
    sources: &'j SourceMap<'j>,
    ignored: &'j [Category],
    ready_tools: bool,
    programmed: bool,
    in_step: bool,
    /// The current block with block delete, and whether it has made a step.
    deletable: Option<(Origin, BlockDeleteUse, bool)>,
    steps: Vec<RunStep>,
    states: Vec<MoveState>,
    turns: Vec<[[f64; 3]; 2]>,
    now: MoveState,
    machine_places: Option<MachinePlaces>,
    commands: u32,
    /// Takes every position as known.
    assume_known: bool,
    /// Gives moves of the tip as moves of the axes; `None` where the tip is compared.
    axes: Option<AxisMoves>,
}

impl<'j> RunRecorder<'j> {
    fn new(job: &'j Job, options: &'j ComparisonOptions) -> RunRecorder<'j> {
        let now = MoveState {
            spindle: SpindleState::Off,
            rpm: 0.0,
            coolant: Coolant::default(),
            length_offset: None,
            own_length: None,
            radius_offset: None,
            side: CompensationSide::Off,
            // Before the program selects a work offset, the control's first one is assumed.
            work_offset: 1,
            path_mode: PathMode::Continuous { tolerance_mm: None, joined: false },
            overrides: Overrides::ON,
            surface: None,
            on_part: false,
            deletable: None,
        };
        RunRecorder {
            sources: job.sources(),
            ignored: &options.ignored,
            ready_tools: options.ready_tools,
            programmed: options.programmed,
            in_step: options.in_step && options.unknown_in_step,
            deletable: None,
            steps: Vec::new(),
            states: vec![now],
            turns: vec![[[0.0; 3]; 2]],
            now,
            machine_places: None,
            assume_known: false,
            axes: options.axes.map(|axes| {
                let frame = job.path_builder().frame().clone();
                AxisMoves::new(frame, axes.chain, axes.tolerance_mm)
            }),
            commands: 0,
        }
    }

    fn state(&mut self) -> u32 {
        if self.states.last() != Some(&self.now) {
            self.states.push(self.now);
        }
        self.states.len() as u32 - 1
    }

    /// Splits an arc of several turns into single turns, because it passes the same points repeatedly.
    fn push(&mut self, moved: ComparedMove) {
        let turns = match moved.curve {
            Curve::Arc(arc)
                if self.turns[moved.turn as usize][0] == self.turns[moved.turn as usize][1] =>
            {
                arc.sweep.abs() / std::f64::consts::TAU
            }
            _ => 1.0,
        };
        if !(turns > 1.0 + 1e-9 && turns < MAX_TURNS) {
            self.steps.push(RunStep::Move(moved));
            return;
        }
        let turn_mm = moved.length_mm / turns;
        let mut from = 0.0;
        for turn in 1..=(turns - 1e-9).ceil() as u32 {
            let to = (turn_mm * f64::from(turn)).min(moved.length_mm);
            let curve = moved.curve.subsegment(from, to);
            let piece = ComparedMove { curve, length_mm: to - from, ..moved.clone() };
            self.steps.push(RunStep::Move(piece));
            from = to;
        }
    }

    fn turn(&mut self, segment: &Segment) -> u32 {
        let turn = [segment.rotary_from, segment.rotary_to];
        if self.turns.last() != Some(&turn) {
            self.turns.push(turn);
        }
        self.turns.len() as u32 - 1
    }

    fn event(&mut self, command: &Command, what: RunEvent) {
        if matches!(what, RunEvent::ReadyTool(_)) && !self.ready_tools {
            return;
        }
        // An ignored event in only one run could prevent other events from being matched.
        if Category::of(&command.kind).is_some_and(|category| self.ignored.contains(&category)) {
            return;
        }
        let deletable = self.deletable_of(&command.origin);
        self.steps.push(RunStep::Event { what, origin: command.origin, deletable });
    }

    /// The block delete of the block of a step.
    fn deletable_of(&mut self, origin: &Origin) -> Option<BlockDeleteUse> {
        let (of, deletable, is_shown) = self.deletable.as_mut()?;
        if (of.span, of.call) != (origin.span, origin.call) {
            return None;
        }
        *is_shown = true;
        Some(*deletable)
    }

    /// Ends the current block with block delete: one that made no step becomes an event.
    fn end_deletable(&mut self) {
        if let Some((origin, deletable, false)) = self.deletable.take() {
            let what = RunEvent::Deletable(deletable);
            self.steps.push(RunStep::Event { what, origin, deletable: None });
        }
    }

    fn effect(&mut self, command: &Command, effect: &Effect) {
        match effect {
            Effect::Code(words) => self.event(command, RunEvent::Code(words.clone())),
            Effect::Written { name, values } => {
                let (name, values) = (name.clone(), values.clone());
                self.event(command, RunEvent::Written { name, values });
            }
            Effect::Variable { number, value } => {
                let (number, value) = (*number, *value);
                self.event(command, RunEvent::Variable { number, value });
            }
            Effect::Alarm { number, text } => {
                let (number, text) = (*number, text.clone());
                self.event(command, RunEvent::Alarm { number, text });
            }
            Effect::Deletable { switch, partly } => {
                self.end_deletable();
                let deletable = BlockDeleteUse { switch: *switch, partly: *partly };
                self.deletable = Some((command.origin, deletable, false));
            }
        }
    }

    fn command(&mut self, command: &Command) {
        use CommandKind as Kind;
        let of_block = |(origin, ..): &(Origin, BlockDeleteUse, bool)| {
            (origin.span, origin.call) == (command.origin.span, command.origin.call)
        };
        if self.deletable.as_ref().is_some_and(|deletable| !of_block(deletable)) {
            self.end_deletable();
        }
        match &command.kind {
            Kind::Effect(effect) => self.effect(command, effect),
            Kind::ToolSelect { number } => self.event(command, RunEvent::ReadyTool(*number)),
            Kind::ToolNumber { number } => self.event(command, RunEvent::Tool(*number)),
            Kind::Message(range) => {
                let words = self.sources.words(range.in_file(command.origin.span.file));
                self.event(command, RunEvent::Message(words.trim().to_string()));
            }
            Kind::Tool { number } => self.event(command, RunEvent::Tool(*number)),
            Kind::Dwell { seconds, .. } if *seconds > 0.0 => {
                self.event(command, RunEvent::Dwell(*seconds));
            }
            Kind::Stop { optional } => self.event(command, RunEvent::Stop { optional: *optional }),
            Kind::Probed { hit } => self.event(command, RunEvent::Probed { hit: *hit }),
            Kind::Output { text } => self.event(command, RunEvent::Output(text.clone())),
            Kind::Spindle { state, rpm } => {
                self.now.spindle = *state;
                // A stopped spindle has no speed, even when S is programmed for later.
                let turns = matches!(state, SpindleState::Cw | SpindleState::Ccw);
                self.now.rpm = if turns { *rpm } else { 0.0 };
            }
            Kind::Coolant(coolant) => self.now.coolant = *coolant,
            Kind::Compensation { side, number, .. } => {
                self.now.side = if self.programmed { *side } else { CompensationSide::Off };
                self.now.radius_offset =
                    if *side == CompensationSide::Off { None } else { *number };
            }
            Kind::ToolLength { number, offset, .. } => {
                self.now.length_offset = *number;
                let is_own = number.is_none() && offset.iter().any(|value| *value != 0.0);
                self.now.own_length = is_own.then_some(*offset);
            }
            Kind::WorkOffset { name, .. } => self.now.work_offset = name.ordinal(),
            Kind::PathMode(mode) => self.now.path_mode = *mode,
            Kind::Overrides(overrides) => self.now.overrides = *overrides,
            Kind::Surface { surface, .. } => self.now.surface = *surface,
            Kind::PartFrame { frame, .. } => {
                self.now.on_part = frame.is_some() && self.axes.is_none();
            }
            Kind::End => (self.now.surface, self.now.on_part) = (None, false),
            // The effects of these are in the moves.
            Kind::Rapid { .. }
            | Kind::Line { .. }
            | Kind::Arc { .. }
            | Kind::Spiral { .. }
            | Kind::Spline { .. }
            | Kind::Dwell { .. }
            | Kind::CornerArc { .. }
            | Kind::CornerMode { .. }
            | Kind::Idle
            | Kind::Units(_)
            | Kind::Plane(_)
            | Kind::FeedMode(_)
            | Kind::FeedRate { .. } => {}
        }
    }
}

impl RunWatch for RunRecorder<'_> {
    fn path(&mut self, path: PathCommand<'_>, segments: &[Segment]) {
        self.take(path.command, segments);
    }
}

/// Records the programmed path, before cutter compensation.
struct ProgrammedPathSink<'g, 'j, 'm> {
    gather: &'g mut RunRecorder<'j>,
    builder: PathBuilder<'m>,
    segments: Vec<Segment>,
}

impl RunWatch for ProgrammedPathSink<'_, '_, '_> {
    fn programmed(&mut self, command: &Command) {
        self.segments.clear();
        self.builder.command(command, |segment| self.segments.push(*segment));
        self.gather.take(command, &self.segments);
    }
}

impl RunRecorder<'_> {
    /// The segments of the axes of a move of the tip, where they are compared; `None` where the segments are those already.
    fn axis_segments(&mut self, command: &Command, segments: &[Segment]) -> Option<Vec<Segment>> {
        let axes = self.axes.as_mut()?;
        if axes.follow(command) {
            return None;
        }
        let (motion, first) = (command.kind.motion()?, segments.first()?);
        let shift = Transform::translation(axes.shift_to_run(motion, first));
        // What is not known stays a move of the tip.
        let Some(pieces) = axes.pieces(&command.kind, motion).ok()? else {
            return straight_rapid(segments).map(|whole| vec![whole]);
        };
        let moves = pieces.into_iter().filter_map(|timed| {
            let whole = segments.get(timed.curve)?;
            let curve = timed.piece.curve.transformed(&shift);
            Some(Segment {
                curve,
                length_mm: curve.length(),
                duration_s: whole.duration_s * timed.share,
                rotary_from: timed.piece.rotary_from,
                rotary_to: timed.piece.rotary_to,
                ..*whole
            })
        });
        Some(moves.collect())
    }

    fn take(&mut self, command: &Command, segments: &[Segment]) {
        self.command(command);
        self.commands += 1;
        let is_of_machine = command.kind.motion().is_some()
            && self.machine_places.as_mut().is_some_and(|places| places.has(command.origin.span));
        let feed_mode = command.kind.feed().map(|feed| feed.mode);
        let of_axes = self.axis_segments(command, segments);
        for segment in of_axes.as_deref().unwrap_or(segments) {
            let turn = self.turn(segment);
            // From an unknown position, a move may have length zero in numbers although the machine moves.
            let is_counted = self.in_step && !segment.known && !self.assume_known;
            let stays = segment.length_mm == 0.0 && segment.rotary_from == segment.rotary_to;
            if stays && !is_counted {
                continue;
            }
            self.now.deletable = self.deletable_of(&segment.origin);
            let moved = ComparedMove {
                curve: segment.curve,
                length_mm: segment.length_mm,
                known: (segment.known || self.assume_known) && !is_of_machine,
                kind: kind(command),
                feed: match self.axes.is_some() && segment.rotary_from != segment.rotary_to {
                    true => duration_as_speed(command, segment),
                    false => speed(command, segment),
                },
                per_revolution: feed_mode == Some(FeedMode::PerRevolution),
                turn,
                state: self.state(),
                origin: segment.origin,
                command: self.commands,
            };
            self.push(moved);
        }
    }
}

/// The parts of a dog-leg as one straight line: rapids in a frame of the part are straight, and where those of the axes bend
/// instead is told as a difference of the kind of rapid. `None` for other moves.
fn straight_rapid(segments: &[Segment]) -> Option<Segment> {
    let [first, .., last] = segments else { return None };
    if first.kind != SegmentKind::Rapid {
        return None;
    }
    let line = Line { start: first.curve.start(), end: last.curve.end() };
    Some(Segment {
        curve: Curve::Line(line),
        length_mm: line.length(),
        rotary_to: last.rotary_to,
        ..*first
    })
}

fn kind(command: &Command) -> ComparedMoveKind {
    match &command.kind {
        CommandKind::Rapid { path: RapidPath::DogLeg, motion } => {
            // Along a single axis, both kinds are the same line.
            let moving = (0..3).filter(|axis| motion.from[*axis] != motion.to[*axis]).count();
            if moving > 1 { ComparedMoveKind::DogLeg } else { ComparedMoveKind::Rapid }
        }
        CommandKind::Rapid { .. } => ComparedMoveKind::Rapid,
        _ => ComparedMoveKind::Cut,
    }
}

/// The duration of a move of the axes that follow the tip: how far X, Y and Z go meanwhile may be next to nothing.
fn duration_as_speed(command: &Command, segment: &Segment) -> Option<CutSpeed> {
    command.kind.feed()?;
    (segment.duration_s > 0.0).then(|| CutSpeed::Turn(segment.duration_s.recip()))
}

/// The speed of a segment, from its duration without acceleration; `None` when unknown.
fn speed(command: &Command, segment: &Segment) -> Option<CutSpeed> {
    let feed = command.kind.feed()?;
    if !(segment.duration_s > 0.0 && segment.duration_s.is_finite()) {
        let is_unknown = feed.mode != FeedMode::PerRevolution || !feed.value.is_finite();
        return if is_unknown { None } else { Some(CutSpeed::PerRevolution(feed.value)) };
    }
    if segment.length_mm > 0.0 {
        return Some(CutSpeed::Path(segment.length_mm / segment.duration_s));
    }
    Some(CutSpeed::Turn(1.0 / segment.duration_s))
}
