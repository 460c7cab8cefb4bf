//! What a program does, in order.

use chordal::control::{
    Command, CommandKind, Coolant, EndReason, FeedMode, Origin, Overrides, PathMode, Position,
    RapidPath, RotarySurface, Side, SpindleState,
};
use chordal::geometry::{Curve, ParamCurve};
use chordal::path::PathBuilder;
use chordal::{Effect, Job, PathCommand, Report, Segment, SourceMap, Watch};

use crate::Mapping;
use crate::Options;
use crate::category::Category;
use crate::machine_places::MachinePlaces;

/// A run: its moves, each with the state that it is made in, and what happens between them.
#[derive(Debug)]
pub(crate) struct Course {
    pub(crate) steps: Vec<Step>,
    /// States, by the numbers that moves have.
    pub(crate) states: Vec<State>,
    /// Rotary axes A B C at both ends of a move, rad, by the numbers that moves have.
    pub(crate) turns: Vec<[[f64; 3]; 2]>,
    pub(crate) report: Report,
}

#[derive(Clone, Debug, PartialEq)]
#[allow(clippy::large_enum_variant, reason = "most steps are moves")]
pub(crate) enum Step {
    Move(Moved),
    Event { what: Event, origin: Origin, deletable: Option<Deletable> },
}

impl Step {
    pub(crate) fn origin(&self) -> &Origin {
        match self {
            Step::Move(moved) => &moved.origin,
            Step::Event { origin, .. } => origin,
        }
    }
}

/// A move of the tool centre in the frame of the run.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Moved {
    pub(crate) curve: Curve,
    pub(crate) length_mm: f64,
    /// Both ends are known relative to the part.
    pub(crate) known: bool,
    pub(crate) kind: MoveKind,
    /// The feed of a cut; nothing for rapids and before any F.
    pub(crate) feed: Option<Speed>,
    /// F counts by revolutions.
    pub(crate) per_revolution: bool,
    pub(crate) turn: u32,
    pub(crate) state: u32,
    pub(crate) origin: Origin,
    /// Which command of the run made it: a dog-leg has several moves.
    pub(crate) command: u32,
}

/// How a move goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum MoveKind {
    Cut,
    Rapid,
    /// A rapid on which each axis goes at its own speed, so that it is no straight line.
    DogLeg,
}

/// How fast a cut is, so that it does not matter how the program counts it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Speed {
    /// Of the path, mm/s.
    Path(f64),
    /// Of a move of rotary axes alone, 1/s: one over its time.
    Turn(f64),
    /// For each revolution of a spindle that has no speed, mm.
    PerRevolution(f64),
}

/// What holds while a move is made.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct State {
    pub(crate) spindle: SpindleState,
    pub(crate) rpm: f64,
    pub(crate) coolant: Coolant,
    pub(crate) length_offset: Option<u32>,
    /// The tool offsets in force where the program gives them itself (G43.1), mm and rad.
    pub(crate) own_length: Option<Position>,
    pub(crate) radius_offset: Option<u32>,
    /// The side of compensation, where the path does not show it.
    pub(crate) side: Side,
    pub(crate) work_offset: u32,
    pub(crate) path_mode: PathMode,
    pub(crate) overrides: Overrides,
    /// The surface on which two coordinates lie.
    pub(crate) surface: Option<RotarySurface>,
    /// A switch leaves out the block.
    pub(crate) deletable: Option<Deletable>,
}

/// A switch of the panel leaves a block out, or a part of it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Deletable {
    pub(crate) switch: u8,
    pub(crate) partly: bool,
}

/// What happens between moves.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Event {
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
    /// A block that may be left out, and that neither moves nor makes anything else happen here.
    Deletable(Deletable),
    Dwell(f64),
    Stop {
        optional: bool,
    },
    Probed {
        hit: bool,
    },
    Output(String),
}

impl Course {
    pub(crate) fn of(
        job: &Job,
        options: &Options,
        machine_places: Option<MachinePlaces>,
    ) -> Course {
        let assume_known = options.assume_known;
        let mut gather = Gather { machine_places, assume_known, ..Gather::new(job, options) };
        let report = if options.programmed {
            let builder = job.path_builder();
            let mut contour = Programmed { gather: &mut gather, builder, segments: Vec::new() };
            job.report_watched(&mut contour)
        } else {
            job.report_watched(&mut gather)
        };
        gather.end_deletable();
        let Gather { steps, states, turns, .. } = gather;
        Course { steps, states, turns, report }
    }

    /// The run was given up before its end.
    pub(crate) fn was_interrupted(&self) -> bool {
        was_interrupted(&self.report)
    }

    /// Moves everything, and changes feeds and speeds.
    pub(crate) fn map(&mut self, mapping: &Mapping) {
        let scale = mapping.path.scale_factor();
        for step in &mut self.steps {
            let Step::Move(moved) = step else { continue };
            moved.curve = moved.curve.transformed(&mapping.path);
            moved.length_mm *= scale;
            let state = &self.states[moved.state as usize];
            // In a tap the panel's feed override does not act.
            let is_tap = moved.origin.cycle && !state.overrides.feed;
            let feed = match (is_tap, moved.per_revolution) {
                (true, _) => mapping.speed,
                (false, true) => mapping.feed * mapping.speed,
                (false, false) => mapping.feed,
            };
            moved.feed = moved.feed.map(|speed| match speed {
                Speed::Path(speed) => Speed::Path(speed * feed),
                Speed::Turn(speed) => Speed::Turn(speed * feed),
                Speed::PerRevolution(feed) => Speed::PerRevolution(feed * mapping.feed),
            });
        }
        for state in &mut self.states {
            state.rpm *= mapping.speed;
        }
    }

    /// The length of the cuts whose ends are known, mm.
    pub(crate) fn cut_mm(&self) -> f64 {
        let cuts = self.steps.iter().map(|step| match step {
            Step::Move(moved) if moved.known && moved.kind == MoveKind::Cut => moved.length_mm,
            Step::Move(_) | Step::Event { .. } => 0.0,
        });
        cuts.sum()
    }

    /// The lowest feed of a cut, mm/s.
    pub(crate) fn slowest(&self) -> Option<f64> {
        let feeds = self.steps.iter().filter_map(|step| match step {
            Step::Move(Moved { feed: Some(Speed::Path(speed)), .. }) => Some(*speed),
            Step::Move(_) | Step::Event { .. } => None,
        });
        feeds.min_by(f64::total_cmp)
    }

    /// The time of cuts and dwells as far as their feeds are known, s.
    pub(crate) fn cutting_s(&self) -> f64 {
        let times = self.steps.iter().map(|step| match step {
            // Where a move from an unknown place begins is not known, nor how long it is.
            Step::Move(moved) if !moved.known => 0.0,
            Step::Move(moved) => match moved.feed {
                Some(Speed::Path(speed)) => moved.length_mm / speed,
                Some(Speed::Turn(speed)) => 1.0 / speed,
                Some(Speed::PerRevolution(_)) | None => 0.0,
            },
            Step::Event { what: Event::Dwell(seconds), .. } => *seconds,
            Step::Event { .. } => 0.0,
        });
        times.sum()
    }

    pub(crate) fn move_count(&self) -> u64 {
        self.steps.iter().filter(|step| matches!(step, Step::Move(_))).count() as u64
    }

    /// The move at a step.
    pub(crate) fn moved(&self, step: usize) -> Option<&Moved> {
        match self.steps.get(step)? {
            Step::Move(moved) => Some(moved),
            Step::Event { .. } => None,
        }
    }

    pub(crate) fn state(&self, moved: &Moved) -> &State {
        &self.states[moved.state as usize]
    }

    pub(crate) fn turn(&self, moved: &Moved) -> &[[f64; 3]; 2] {
        &self.turns[moved.turn as usize]
    }
}

/// The run was given up before its end.
pub(crate) fn was_interrupted(report: &Report) -> bool {
    report.outcomes.iter().any(|outcome| outcome.end == EndReason::Interrupted)
}

/// Arcs of more turns stay whole.
const MOST_TURNS: f64 = 1e5;

struct Gather<'j> {
    sources: &'j SourceMap<'j>,
    ignored: &'j [Category],
    ready_tools: bool,
    programmed: bool,
    in_step: bool,
    /// The block that a switch leaves out, and whether a step of it has come.
    deletable: Option<(Origin, Deletable, bool)>,
    steps: Vec<Step>,
    states: Vec<State>,
    turns: Vec<[[f64; 3]; 2]>,
    now: State,
    machine_places: Option<MachinePlaces>,
    commands: u32,
    /// Every place is taken as it is counted.
    assume_known: bool,
}

impl<'j> Gather<'j> {
    fn new(job: &'j Job, options: &'j Options) -> Gather<'j> {
        let now = State {
            spindle: SpindleState::Off,
            rpm: 0.0,
            coolant: Coolant::default(),
            length_offset: None,
            own_length: None,
            radius_offset: None,
            side: Side::Off,
            // Which offset holds before the program names one is the control's business: its first.
            work_offset: 1,
            path_mode: PathMode::Continuous { tolerance_mm: None, joined: false },
            overrides: Overrides::ON,
            surface: None,
            deletable: None,
        };
        Gather {
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
            commands: 0,
        }
    }

    fn state(&mut self) -> u32 {
        if self.states.last() != Some(&self.now) {
            self.states.push(self.now);
        }
        self.states.len() as u32 - 1
    }

    /// An arc of several turns passes its own places again and again: it is held turn by turn.
    fn push(&mut self, moved: Moved) {
        let turns = match moved.curve {
            Curve::Arc(arc)
                if self.turns[moved.turn as usize][0] == self.turns[moved.turn as usize][1] =>
            {
                arc.sweep.abs() / std::f64::consts::TAU
            }
            _ => 1.0,
        };
        if !(turns > 1.0 + 1e-9 && turns < MOST_TURNS) {
            self.steps.push(Step::Move(moved));
            return;
        }
        let turn_mm = moved.length_mm / turns;
        let mut from = 0.0;
        for turn in 1..=(turns - 1e-9).ceil() as u32 {
            let to = (turn_mm * f64::from(turn)).min(moved.length_mm);
            let curve = moved.curve.subsegment(from, to);
            let piece = Moved { curve, length_mm: to - from, ..moved.clone() };
            self.steps.push(Step::Move(piece));
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

    fn event(&mut self, command: &Command, what: Event) {
        if matches!(what, Event::ReadyTool(_)) && !self.ready_tools {
            return;
        }
        // An event of one run alone would keep others from finding each other.
        if Category::of(&command.kind).is_some_and(|category| self.ignored.contains(&category)) {
            return;
        }
        let deletable = self.deletable_of(&command.origin);
        self.steps.push(Step::Event { what, origin: command.origin, deletable });
    }

    /// What leaves out the block of a step.
    fn deletable_of(&mut self, origin: &Origin) -> Option<Deletable> {
        let (of, deletable, is_shown) = self.deletable.as_mut()?;
        if (of.span, of.call) != (origin.span, origin.call) {
            return None;
        }
        *is_shown = true;
        Some(*deletable)
    }

    /// The block that may be left out is over: one of which no step came is an event of its own.
    fn end_deletable(&mut self) {
        if let Some((origin, deletable, false)) = self.deletable.take() {
            let what = Event::Deletable(deletable);
            self.steps.push(Step::Event { what, origin, deletable: None });
        }
    }

    fn effect(&mut self, command: &Command, effect: &Effect) {
        match effect {
            Effect::Code(words) => self.event(command, Event::Code(words.clone())),
            Effect::Written { name, values } => {
                let (name, values) = (name.clone(), values.clone());
                self.event(command, Event::Written { name, values });
            }
            Effect::Variable { number, value } => {
                let (number, value) = (*number, *value);
                self.event(command, Event::Variable { number, value });
            }
            Effect::Alarm { number, text } => {
                let (number, text) = (*number, text.clone());
                self.event(command, Event::Alarm { number, text });
            }
            Effect::Deletable { switch, partly } => {
                self.end_deletable();
                let deletable = Deletable { switch: *switch, partly: *partly };
                self.deletable = Some((command.origin, deletable, false));
            }
        }
    }

    fn command(&mut self, command: &Command) {
        use CommandKind as Kind;
        let of_block = |(origin, ..): &(Origin, Deletable, bool)| {
            (origin.span, origin.call) == (command.origin.span, command.origin.call)
        };
        if self.deletable.as_ref().is_some_and(|deletable| !of_block(deletable)) {
            self.end_deletable();
        }
        match &command.kind {
            Kind::Effect(effect) => self.effect(command, effect),
            Kind::ToolSelect { number } => self.event(command, Event::ReadyTool(*number)),
            Kind::ToolNumber { number } => self.event(command, Event::Tool(*number)),
            Kind::Message(range) => {
                let words = self.sources.words(range.in_file(command.origin.span.file));
                self.event(command, Event::Message(words.trim().to_string()));
            }
            Kind::Tool { number } => self.event(command, Event::Tool(*number)),
            Kind::Dwell { seconds, .. } if *seconds > 0.0 => {
                self.event(command, Event::Dwell(*seconds));
            }
            Kind::Stop { optional } => self.event(command, Event::Stop { optional: *optional }),
            Kind::Probed { hit } => self.event(command, Event::Probed { hit: *hit }),
            Kind::Output { text } => self.event(command, Event::Output(text.clone())),
            Kind::Spindle { state, rpm } => {
                self.now.spindle = *state;
                // A spindle that stands has no speed, whatever S says for later.
                let turns = matches!(state, SpindleState::Cw | SpindleState::Ccw);
                self.now.rpm = if turns { *rpm } else { 0.0 };
            }
            Kind::Coolant(coolant) => self.now.coolant = *coolant,
            Kind::Compensation { side, number, .. } => {
                self.now.side = if self.programmed { *side } else { Side::Off };
                self.now.radius_offset = if *side == Side::Off { None } else { *number };
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
            Kind::End => self.now.surface = None,
            // How the words are to be read is in the moves already.
            Kind::Rapid { .. }
            | Kind::Line { .. }
            | Kind::Arc { .. }
            | Kind::Spiral { .. }
            | Kind::Spline { .. }
            | Kind::Dwell { .. }
            | Kind::CornerArc { .. }
            | Kind::Idle
            | Kind::Units(_)
            | Kind::Plane(_)
            | Kind::FeedMode(_)
            | Kind::FeedRate { .. } => {}
        }
    }
}

impl Watch for Gather<'_> {
    fn path(&mut self, path: PathCommand<'_>, segments: &[Segment]) {
        self.take(path.command, segments);
    }
}

/// The path before cutter compensation.
struct Programmed<'g, 'j, 'm> {
    gather: &'g mut Gather<'j>,
    builder: PathBuilder<'m>,
    segments: Vec<Segment>,
}

impl Watch for Programmed<'_, '_, '_> {
    fn programmed(&mut self, command: &Command) {
        self.segments.clear();
        self.builder.command(command, |segment| self.segments.push(*segment));
        self.gather.take(command, &self.segments);
    }
}

impl Gather<'_> {
    fn take(&mut self, command: &Command, segments: &[Segment]) {
        self.command(command);
        self.commands += 1;
        let is_of_machine = command.kind.motion().is_some()
            && self.machine_places.as_mut().is_some_and(|places| places.has(command.origin.span));
        let feed_mode = command.kind.feed().map(|feed| feed.mode);
        for segment in segments {
            let turn = self.turn(segment);
            // From a place that is not known the numbers may say that nothing moves.
            let is_counted = self.in_step && !segment.known && !self.assume_known;
            let stays = segment.length_mm == 0.0 && segment.rotary_from == segment.rotary_to;
            if stays && !is_counted {
                continue;
            }
            self.now.deletable = self.deletable_of(&segment.origin);
            let moved = Moved {
                curve: segment.curve,
                length_mm: segment.length_mm,
                known: (segment.known || self.assume_known) && !is_of_machine,
                kind: kind(command),
                feed: speed(command, segment),
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

fn kind(command: &Command) -> MoveKind {
    match &command.kind {
        CommandKind::Rapid { path: RapidPath::DogLeg, motion } => {
            // Along a single axis both are the same line.
            let moving = (0..3).filter(|axis| motion.from[*axis] != motion.to[*axis]).count();
            if moving > 1 { MoveKind::DogLeg } else { MoveKind::Rapid }
        }
        CommandKind::Rapid { .. } => MoveKind::Rapid,
        _ => MoveKind::Cut,
    }
}

/// The feed as speed, from the time that the segment takes without acceleration.
fn speed(command: &Command, segment: &Segment) -> Option<Speed> {
    let feed = command.kind.feed()?;
    if !(segment.duration_s > 0.0 && segment.duration_s.is_finite()) {
        let is_unknown = feed.mode != FeedMode::PerRevolution || !feed.value.is_finite();
        return if is_unknown { None } else { Some(Speed::PerRevolution(feed.value)) };
    }
    if segment.length_mm > 0.0 {
        return Some(Speed::Path(segment.length_mm / segment.duration_s));
    }
    Some(Speed::Turn(1.0 / segment.duration_s))
}
