//! Canonical commands: what a block means, with the control's own peculiarities resolved.
//!
//! Lengths are millimetres, angles radians, time seconds. Positions are program
//! coordinates: of the active work coordinate system, at the tool tip.

use std::ops::ControlFlow;
use std::sync::Arc;

use chordal_diagnostics::{Diagnostic, Shift, Span, TextRange};
use chordal_geometry::Plane;
use chordal_machine::{Axis, PerAxis};

use crate::interpreter::Rest;
use crate::modal::Modal;

/// A value for each axis X Y Z A B C, in mm and rad.
pub type Position = PerAxis<f64>;

/// A set of axes.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default, Hash)]
pub struct AxisMask(pub u8);

impl AxisMask {
    /// No axis.
    pub const NONE: AxisMask = AxisMask(0);
    /// All six.
    pub const ALL: AxisMask = AxisMask(0b11_1111);
    /// X, Y and Z.
    pub const LINEAR: AxisMask = AxisMask(0b111);
    /// A, B and C.
    pub const ROTARY: AxisMask = AxisMask(0b11_1000);

    /// True when the axis is in the set.
    #[inline]
    pub const fn has(self, axis: usize) -> bool {
        self.0 & (1 << axis) != 0
    }

    /// Adds an axis.
    #[inline]
    pub const fn insert(&mut self, axis: usize) {
        self.0 |= 1 << axis;
    }

    /// The axes of both.
    #[inline]
    pub const fn and(self, other: AxisMask) -> AxisMask {
        AxisMask(self.0 & other.0)
    }

    /// The axes of either.
    #[inline]
    pub const fn or(self, other: AxisMask) -> AxisMask {
        AxisMask(self.0 | other.0)
    }

    /// The axes of this set that are not in the other.
    #[inline]
    pub const fn without(self, other: AxisMask) -> AxisMask {
        AxisMask(self.0 & !other.0)
    }

    /// True when every axis of `other` is in this set.
    #[inline]
    pub const fn covers(self, other: AxisMask) -> bool {
        other.0 & !self.0 == 0
    }

    /// The axes in order.
    pub fn iter(self) -> impl Iterator<Item = Axis> {
        Axis::ALL.into_iter().filter(move |axis| self.has(*axis as usize))
    }
}

/// Which chain of calls a block was reached through; 0 is the main program.
/// [`CallPaths`] resolves it.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default, Hash, PartialOrd, Ord)]
pub struct CallPath(pub u32);

/// The block that a command comes from.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Origin {
    /// The whole block.
    pub span: Span,
    /// Its line in the file, from 1.
    pub line: u32,
    /// The calls it was reached through.
    pub call: CallPath,
    /// Made by a canned cycle that the block set off.
    pub cycle: bool,
}

impl Origin {
    /// The same in a text that has changed elsewhere; `None` where the block went.
    pub fn shifted(&self, shift: &Shift) -> Option<Origin> {
        let mut moved = Origin { span: shift.span(self.span)?, ..*self };
        if moved.span != self.span {
            moved.line = shift.place(self.span.range.start, self.line)?.1;
        }
        Some(moved)
    }
}

/// A move of the tool tip in program coordinates.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Move {
    /// Where it begins.
    pub from: Position,
    /// Where it ends.
    pub to: Position,
    /// The axes whose `from` is known relative to the part: not before the program has
    /// placed them, nor after a move in machine coordinates with an unknown work offset.
    pub from_known: AxisMask,
    /// The axes whose `to` is known relative to the part.
    pub to_known: AxisMask,
}

impl Move {
    /// Rotary axes turn and the tool tip stays where it is, so that F per time is an angle per time.
    /// An arc moves the tip even where it ends at its start.
    #[inline]
    pub fn only_turns(&self, shape: Option<&ArcShape>) -> bool {
        shape.is_none() && self.from[..3] == self.to[..3] && self.from != self.to
    }
}

/// What F counts.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum FeedMode {
    /// Length per time (G94), mm/s; where rotary axes move alone ([`Move::only_turns`]) rad/s.
    PerTime,
    /// One over the time of the block (G93), 1/s.
    InverseTime,
    /// Length per revolution of the spindle (G95), mm.
    PerRevolution,
}

/// Along what F is measured.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum FeedAlong {
    /// Along the whole path.
    Path,
    /// Along the arc in its plane; a helix is faster by its slope.
    Plane,
}

/// The feed of a cutting move.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Feed {
    /// In the unit of its mode; NaN before any F.
    pub value: f64,
    /// What it counts.
    pub mode: FeedMode,
    /// Along what it is measured.
    pub along: FeedAlong,
    /// Revolutions of the spindle per second, for [`FeedMode::PerRevolution`].
    pub spindle_rev_per_s: f64,
}

/// An arc, a helix, a spiral or a cone: the radius goes linearly with the angle from
/// `radius_from` to `radius_to`, the third axis and rotary axes likewise.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct ArcShape {
    /// Plane of the arc.
    pub plane: Plane,
    /// Centre on the two axes of the plane (a, b), mm.
    pub center: [f64; 2],
    /// Directed angle in rad: positive counter-clockwise (a towards b). More than a turn
    /// where the command says so.
    pub sweep: f64,
    /// Distance of the start from the centre, mm.
    pub radius_from: f64,
    /// Distance of the end from the centre, mm.
    pub radius_to: f64,
}

/// How a rapid goes.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum RapidPath {
    /// All axes arrive together.
    Straight,
    /// Each axis at its own speed.
    DogLeg,
}

/// What the spindle does.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum SpindleState {
    /// Stands.
    Off,
    /// M3.
    Cw,
    /// M4.
    Ccw,
    /// Stands at its mark (M19).
    Oriented,
}

/// Coolant valves.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default, Hash)]
pub struct Coolant {
    /// Mist.
    pub mist: bool,
    /// Flood.
    pub flood: bool,
    /// Through the tool.
    pub through_tool: bool,
}

/// Units of the program text.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum Units {
    /// G20.
    Inch,
    /// G21.
    Millimetre,
}

impl Units {
    /// A length in mm for people, in these units: to 0.0001 in or 0.001 mm.
    pub fn length_text(self, mm: f64) -> String {
        match self {
            Units::Inch => format!("{} in", number_text(mm / 25.4, 4)),
            Units::Millimetre => format!("{} mm", number_text(mm, 3)),
        }
    }
}

/// A number of at most so many decimals, without useless zeros.
pub fn number_text(value: f64, decimals: usize) -> String {
    let text = format!("{value:.decimals$}");
    if !text.contains('.') {
        return text;
    }
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".into() } else { text.into() }
}

/// A number of some decimals, and of more where it is small, so that two digits of it are seen.
pub fn telling_number(value: f64, decimals: usize) -> String {
    let mut decimals = decimals;
    while decimals < 9 && value != 0.0 && value.abs() < 10f64.powi(1 - decimals as i32) {
        decimals += 1;
    }
    number_text(value, decimals)
}

/// Cutter radius compensation.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum Side {
    /// G40.
    Off,
    /// G41.
    Left,
    /// G42.
    Right,
}

/// How corners are passed.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum PathMode {
    /// Every corner exactly, without a stop where the path is smooth (LinuxCNC G61).
    ExactPath,
    /// A stop at every corner (G61, LinuxCNC G61.1, Fadal G9).
    ExactStop,
    /// Corners may be rounded (G64, Fadal G8) within a distance in mm, where one is given.
    Continuous {
        /// Largest distance from the programmed path; `None` when the control decides.
        tolerance_mm: Option<f64>,
    },
}

/// Which overrides of the operator's panel act.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Overrides {
    /// On the feed of cuts.
    pub feed: bool,
    /// On rapids.
    pub rapid: bool,
}

impl Overrides {
    /// Both act, as at power-on and after the program's end.
    pub const ON: Overrides = Overrides { feed: true, rapid: true };
}

/// What a command does.
#[derive(Clone, Debug, PartialEq)]
pub enum CommandKind {
    /// A move at rapid speed.
    Rapid {
        /// From where to where.
        motion: Move,
        /// Straight, or each axis at its own speed.
        path: RapidPath,
    },
    /// A straight cut.
    Line {
        /// From where to where.
        motion: Move,
        /// At what feed.
        feed: Feed,
    },
    /// An arc or a helix.
    Arc {
        /// From where to where.
        motion: Move,
        /// Centre, direction and radii.
        shape: ArcShape,
        /// At what feed.
        feed: Feed,
    },
    /// A spiral or a cone that the program asked for.
    Spiral {
        /// From where to where.
        motion: Move,
        /// Centre, direction and radii.
        shape: ArcShape,
        /// At what feed.
        feed: Feed,
    },
    /// Waiting.
    Dwell {
        /// For how long.
        seconds: f64,
        /// For what, where it is a code of the shop's own.
        label: Option<Arc<str>>,
    },
    /// A tool goes into the spindle.
    Tool {
        /// Its number.
        number: u32,
    },
    /// A tool is made ready.
    ToolSelect {
        /// Its number.
        number: u32,
    },
    /// A tool length offset comes into force.
    ToolLength {
        /// Number of the offset; `None` when lengths are cancelled.
        number: Option<u32>,
        /// What is added to Z, mm; `None` when the table has no value.
        length_mm: Option<f64>,
        /// What is added on every axis, the length with it, mm and rad; zero where the table has no value.
        offset: Position,
        /// The axes whose way from program to machine coordinates is known now.
        known: AxisMask,
    },
    /// Compensation goes on or off.
    Compensation {
        /// The side.
        side: Side,
        /// Number of the offset.
        number: Option<u32>,
        /// Radius of the offset, mm, where the table has one; negative for the other side.
        radius_mm: Option<f64>,
        /// Direction on the axes of the plane that I J K give beside G40, G41 or G42, mm.
        toward: Option<[f64; 2]>,
    },
    /// The outside corner at the end of this block's move, or without one of the block
    /// before, is rounded (G39).
    CornerArc {
        /// Direction of the next block on the axes of the plane, where the block gives it.
        toward: Option<[f64; 2]>,
    },
    /// A block that moves nothing, told while compensation is on: controls count them.
    Idle,
    /// The spindle.
    Spindle {
        /// What it does.
        state: SpindleState,
        /// Its speed.
        rpm: f64,
    },
    /// Coolant valves change.
    Coolant(Coolant),
    /// The program waits for the operator.
    Stop {
        /// Only when the optional stop switch is on.
        optional: bool,
    },
    /// The program ends.
    End,
    /// Units change.
    Units(Units),
    /// The plane changes.
    Plane(Plane),
    /// What F counts changes.
    FeedMode(FeedMode),
    /// F changes: value in the unit of the mode.
    FeedRate {
        /// mm/s, 1/s or mm per revolution.
        value: f64,
        /// What it counts.
        mode: FeedMode,
    },
    /// How corners are passed.
    PathMode(PathMode),
    /// The overrides that act change (M48, M49, tapping).
    Overrides(Overrides),
    /// The program coordinates move against the machine.
    WorkOffset {
        /// Name of the active work coordinate system (`G54`, `E1`).
        name: WorkName,
        /// What is added to program coordinates to get machine coordinates, without tool
        /// length, mm and rad.
        offset: Position,
        /// The axes whose way to machine coordinates, tool length included, is known.
        known: AxisMask,
        /// The tool tip in the new program coordinates.
        position: Position,
    },
    /// The move before was a probe or skip move, and has ended.
    Probed {
        /// Something was touched.
        hit: bool,
    },
    /// Text for the operator.
    Message(TextRange),
    /// A line that the program prints (DPRNT), its values put in.
    Output {
        /// The line without its end.
        text: String,
    },
}

/// The active work coordinate system.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash, PartialOrd, Ord)]
pub enum WorkName {
    /// G54 to G59.
    G(u16),
    /// G54.1 P or G154 P.
    Extended(u16),
    /// LinuxCNC G59.1 to G59.3.
    G59(u16),
    /// Fadal E.
    E(u16),
    /// Machine coordinates (Fadal E0).
    Machine,
}

impl WorkName {
    /// Its number, counted alike on every control: 1 is G54 and E1, 7 is G54.1 P1, G154 P1 and G59.1; 0 are
    /// machine coordinates.
    pub fn ordinal(self) -> u32 {
        match self {
            WorkName::Machine => 0,
            WorkName::G(number) => u32::from(number).saturating_sub(53),
            WorkName::Extended(number) | WorkName::G59(number) => u32::from(number) + 6,
            WorkName::E(number) => u32::from(number),
        }
    }

    /// The name in a machine file; extended systems by the control's own code.
    pub fn key(self, extended: &str) -> String {
        match self {
            WorkName::G(number) => format!("G{number}"),
            WorkName::Extended(number) => format!("{extended} P{number}"),
            WorkName::G59(number) => format!("G59.{number}"),
            WorkName::E(number) => format!("E{number}"),
            WorkName::Machine => "machine".into(),
        }
    }

    /// The name under which the control's table of work offsets has it.
    pub fn table_key(self, extended: &str) -> String {
        match self {
            // Fadal's E1 to E6 are G54 to G59 of its Format 2: one table.
            WorkName::G(number) if extended == "E" => format!("E{}", number.saturating_sub(53)),
            other => other.key(extended),
        }
    }
}

/// A command and the block it comes from.
#[derive(Clone, Debug, PartialEq)]
pub struct Command {
    /// What is done.
    pub kind: CommandKind,
    /// Which block says so.
    pub origin: Origin,
}

impl CommandKind {
    /// The move, where the command is one.
    #[inline]
    pub fn motion(&self) -> Option<&Move> {
        match self {
            CommandKind::Rapid { motion, .. }
            | CommandKind::Line { motion, .. }
            | CommandKind::Arc { motion, .. }
            | CommandKind::Spiral { motion, .. } => Some(motion),
            _ => None,
        }
    }

    /// The feed, where the command cuts.
    #[inline]
    pub fn feed(&self) -> Option<&Feed> {
        match self {
            CommandKind::Line { feed, .. }
            | CommandKind::Arc { feed, .. }
            | CommandKind::Spiral { feed, .. } => Some(feed),
            _ => None,
        }
    }

    /// See [`Move::only_turns`].
    #[inline]
    pub fn only_turns(&self) -> bool {
        self.motion().is_some_and(|motion| motion.only_turns(self.shape()))
    }

    /// The arc, where the command is one.
    #[inline]
    pub fn shape(&self) -> Option<&ArcShape> {
        match self {
            CommandKind::Arc { shape, .. } | CommandKind::Spiral { shape, .. } => Some(shape),
            _ => None,
        }
    }
}

/// Takes what a run produces, as it is produced.
pub trait Sink {
    /// A command.
    fn command(&mut self, command: &Command);
    /// A problem.
    fn diagnostic(&mut self, diagnostic: Diagnostic);
    /// Whether [`block_done`](Self::block_done) is to be told; asked once.
    fn wants_blocks(&self) -> bool {
        false
    }
    /// A block has been carried out; `modal` tells what is in force behind it.
    fn block_done(&mut self, _origin: &Origin, _modal: &dyn Fn() -> Modal) {}
    /// From which byte of the main program on a [`Rest`] is wanted; asked at the beginning and
    /// after each.
    fn next_rest(&self) -> u32 {
        u32::MAX
    }
    /// Whether what has come so far can be left off here.
    fn is_settled(&self) -> bool {
        true
    }
    /// A place at which the run may be taken up again. `Break` ends it here. `looked` is what of
    /// the first text was read since the rest before, beside the blocks between the two: called
    /// programs, and those that were searched for a label.
    fn rest(&mut self, _rest: Rest, _looked: Option<TextRange>) -> ControlFlow<()> {
        ControlFlow::Continue(())
    }
}

/// The chains of calls of a run, each stored once.
#[derive(Clone, Debug, Default)]
pub struct CallPaths {
    paths: Vec<(CallPath, Span)>,
}

impl CallPaths {
    /// The path that `block`, itself reached through `parent`, leads to by its call.
    pub(crate) fn enter(&mut self, parent: CallPath, block: Span) -> CallPath {
        // The newest entries are the likely ones: a loop of calls finds its own at once.
        let known = self.paths.iter().rposition(|entry| *entry == (parent, block));
        let index = known.unwrap_or_else(|| {
            self.paths.push((parent, block));
            self.paths.len() - 1
        });
        CallPath(index as u32 + 1)
    }

    /// How many chains there are.
    pub(crate) fn count(&self) -> usize {
        self.paths.len()
    }

    /// Makes them the chains of a text that has changed elsewhere; `None` where a call went.
    pub fn shift(&mut self, shift: &Shift) -> Option<()> {
        for (_, block) in &mut self.paths {
            *block = shift.span(*block)?;
        }
        Some(())
    }

    /// The calling blocks, innermost first.
    pub fn resolve(&self, mut path: CallPath) -> Vec<Span> {
        let mut blocks = Vec::new();
        while let Some((parent, block)) =
            path.0.checked_sub(1).and_then(|index| self.paths.get(index as usize))
        {
            blocks.push(*block);
            path = *parent;
        }
        blocks
    }
}
