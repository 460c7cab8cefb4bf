//! Records the modal state along the path.

use chordal::control::{
    Command, CommandKind, CompensationSide, ConfiguredControl, Coolant, FeedMode, Overrides,
    PathMode, ProgramOffsets, SpindleState, Units, WorkName,
};
use chordal::geometry::{ParamCurve, Plane, Vec3};
use chordal::path::ProgramFrame;
use chordal::{PathCommand, Segment};
use serde_json::{Value, json};

/// The most state changes that are stored; later ones are ignored.
const MAX_MARKS: usize = 500_000;

/// A smaller shift is a rounding error, mm.
const MIN_SHIFT_MM: f64 = 1e-9;

/// The modal state of a control, as far as its commands show it.
#[derive(Clone, Debug, PartialEq)]
struct ModalState {
    units: Units,
    plane: Plane,
    feed_mode: FeedMode,
    feed: Option<f64>,
    spindle: SpindleState,
    rpm: f64,
    coolant: Coolant,
    tool: u32,
    selected: Option<u32>,
    length: Option<(u32, Option<f64>)>,
    side: CompensationSide,
    cutter: Option<(Option<u32>, Option<f64>)>,
    work: Option<WorkName>,
    path: Option<PathMode>,
    overrides: Overrides,
    /// The translation from program coordinates to the frame of the run, mm.
    shift: Vec3,
    /// The offsets that are active, and which axes of them are known.
    frame: ProgramFrame,
}

#[derive(Clone, Debug)]
struct ModalMark {
    /// The number of path segments before it.
    after: u32,
    line: u32,
    /// Whether it is in the main file, not in a subprogram file.
    main: bool,
    modal: ModalState,
}

/// Records the modal state while commands are executed.
#[derive(Clone, Debug)]
pub struct ModalTrack {
    now: ModalState,
    marks: Vec<ModalMark>,
    /// Whether the shift to the frame of the run must be recomputed.
    moved: bool,
    /// The frame of the first cut, which is the frame of the run; `None` before the first cut.
    base: Option<ProgramFrame>,
    /// The work offsets that were active during cuts, with the position of their zero in the frame of the run, mm.
    zeros: Vec<(WorkName, Vec3)>,
    naming: chordal::control::WorkNaming,
}

impl ModalTrack {
    /// The state before the first command.
    pub fn new(control: &dyn ConfiguredControl, frame: ProgramFrame) -> ModalTrack {
        let now = ModalState {
            units: control.rules().units,
            plane: control.rules().starts_in,
            feed_mode: control.rules().starting_feed_mode(),
            feed: None,
            spindle: SpindleState::Off,
            rpm: 0.0,
            coolant: Coolant::default(),
            tool: 0,
            selected: None,
            length: None,
            side: CompensationSide::Off,
            cutter: None,
            work: Some(control.initial_work_offset()),
            path: None,
            overrides: Overrides::ON,
            shift: Vec3::ZERO,
            frame,
        };
        let first = ModalMark { after: 0, line: 0, main: true, modal: now.clone() };
        let naming = control.profile().work_names;
        ModalTrack { now, marks: vec![first], moved: true, base: None, zeros: Vec::new(), naming }
    }

    /// Follows a command; `before` is the number of path segments before its own.
    pub fn follow(&mut self, path: &PathCommand<'_>, segments: &[Segment], before: u32) {
        let command = path.command;
        let changed = match command.kind.motion() {
            Some(_) => self.motion(command, segments),
            None => self.set(command),
        };
        if changed && self.marks.len() < MAX_MARKS {
            let (line, main) = (command.origin.line, command.origin.span.file.0 == 0);
            self.marks.push(ModalMark { after: before, line, main, modal: self.now.clone() });
        }
    }

    /// Determines from a move the position of the program zero in the frame of the run; `true` when it has changed.
    fn motion(&mut self, command: &Command, segments: &[Segment]) -> bool {
        let cuts = command.kind.feed().is_some();
        if cuts && self.base.is_none() {
            self.base = Some(self.now.frame.clone());
            self.moved = true;
        }
        let (true, Some(last), Some(motion)) = (self.moved, segments.last(), command.kind.motion())
        else {
            return false;
        };
        let to = Vec3::new(motion.to[0], motion.to[1], motion.to[2]);
        let shift = last.curve.end() - to;
        let shift = if shift.length() < MIN_SHIFT_MM { Vec3::ZERO } else { shift };
        self.moved = false;
        if cuts
            && last.unrelated_zero.is_none()
            && let Some(name) = self.now.work
            && self.zeros.len() < 100
        {
            let zero = (name, shift);
            if !self.zeros.contains(&zero) {
                self.zeros.push(zero);
            }
        }
        let changed = shift != self.now.shift;
        self.now.shift = shift;
        changed
    }

    fn set(&mut self, command: &Command) -> bool {
        let now = &mut self.now;
        if now.frame.follow(command) {
            self.moved = true;
        }
        match command.kind {
            CommandKind::Tool { number } => (now.tool, now.selected) = (number, None),
            CommandKind::ToolNumber { number } => now.tool = number,
            CommandKind::ToolSelect { number } => now.selected = Some(number),
            CommandKind::ToolLength { number, length_mm, .. } => {
                now.length = number.map(|number| (number, length_mm));
            }
            CommandKind::Compensation { side, number, radius_mm, .. } => {
                now.side = side;
                now.cutter = (side != CompensationSide::Off).then_some((number, radius_mm));
            }
            CommandKind::Spindle { state, rpm } => (now.spindle, now.rpm) = (state, rpm),
            CommandKind::Coolant(coolant) => now.coolant = coolant,
            CommandKind::Units(units) => now.units = units,
            CommandKind::Plane(plane) => now.plane = plane,
            CommandKind::FeedMode(mode) => (now.feed_mode, now.feed) = (mode, None),
            CommandKind::FeedRate { value, mode } => {
                (now.feed, now.feed_mode) = (Some(value), mode);
            }
            CommandKind::PathMode(mode) => now.path = Some(mode),
            CommandKind::Overrides(overrides) => now.overrides = overrides,
            CommandKind::WorkOffset { name, .. } => now.work = Some(name),
            _ => return false,
        }
        true
    }

    /// The zeros of the work offsets in the frame of the run, and the origin of that frame in machine coordinates
    /// (null per axis when unknown), mm.
    pub fn places(&self) -> Value {
        let zeros = self
            .zeros
            .iter()
            .map(|(name, at)| json!({ "name": name.key(self.naming), "at": [at.x, at.y, at.z] }));
        let base = self.base.as_ref().map(|base| {
            [0, 1, 2].map(|axis| base.known.has(axis).then(|| base.work[axis] + base.tool[axis]))
        });
        json!({ "zeros": zeros.collect::<Vec<_>>(), "machine": base })
    }

    /// What is added to positions of the axes in program coordinates at a path segment to get machine coordinates: work
    /// offset and tool offset, mm and rad.
    pub fn offsets_on(&self, row: u32) -> ProgramOffsets {
        let reached = self.marks.partition_point(|mark| mark.after <= row);
        // The first mark precedes everything.
        self.marks[reached.saturating_sub(1)].modal.frame.offsets()
    }

    /// The modal state after `done` path segments, including the changes by following blocks without motion up to
    /// `line`.
    pub fn at(&self, done: u32, line: u32) -> Value {
        let reached = self.marks.partition_point(|mark| mark.after < done);
        let beyond = self.marks[reached..]
            .iter()
            .take_while(|mark| mark.after == done && mark.main && mark.line <= line)
            .count();
        // The first mark precedes everything.
        self.text(&self.marks[(reached + beyond).saturating_sub(1)].modal)
    }

    fn text(&self, modal: &ModalState) -> Value {
        let ModalState { shift, feed, .. } = modal;
        let state = |state: SpindleState| match state {
            SpindleState::Off => "off",
            SpindleState::Cw => "clockwise",
            SpindleState::Ccw => "counter-clockwise",
            SpindleState::Oriented => "oriented",
        };
        json!({
            "inch": modal.units == Units::Inch,
            "plane": match modal.plane { Plane::Xy => "XY", Plane::Zx => "ZX", Plane::Yz => "YZ" },
            "feed_mode": match modal.feed_mode {
                FeedMode::PerTime => "per_minute",
                FeedMode::InverseTime => "inverse_time",
                FeedMode::PerRevolution => "per_revolution",
            },
            // mm/min, 1/min for inverse time, or mm per revolution.
            "feed": feed.filter(|feed| feed.is_finite()).map(|feed| match modal.feed_mode {
                FeedMode::PerRevolution => feed,
                _ => feed * 60.0,
            }),
            "spindle": state(modal.spindle),
            "rpm": modal.rpm,
            "coolant": coolant_words(modal.coolant),
            "tool": modal.tool,
            "selected": modal.selected,
            "length": modal.length.map(|(number, mm)| json!({ "number": number, "mm": mm })),
            "side": match modal.side {
                CompensationSide::Off => "off",
                CompensationSide::Left => "left",
                CompensationSide::Right => "right",
            },
            "cutter": modal.cutter.map(|(number, mm)| json!({ "number": number, "mm": mm })),
            "work": modal.work.map(|name| name.key(self.naming)),
            "path_mode": modal.path.map(path_mode_text),
            "overrides": { "feed": modal.overrides.feed, "rapid": modal.overrides.rapid },
            "shift": [shift.x, shift.y, shift.z],
        })
    }
}

fn coolant_words(coolant: Coolant) -> Vec<&'static str> {
    [(coolant.flood, "flood"), (coolant.mist, "mist"), (coolant.through_tool, "through tool")]
        .into_iter()
        .filter_map(|(on, word)| on.then_some(word))
        .collect()
}

fn path_mode_text(mode: PathMode) -> String {
    match mode {
        PathMode::ExactPath => "exact path".into(),
        PathMode::ExactStop => "exact stop".into(),
        PathMode::Continuous { tolerance_mm: None, .. } => "continuous".into(),
        PathMode::Continuous { tolerance_mm: Some(mm), .. } => format!("continuous within {mm} mm"),
    }
}
