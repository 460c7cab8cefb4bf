//! The steps of motion: moves, waits and their reasons.

use std::sync::Arc;

use chordal_command::{AxisMask, Command, Origin, PartFrame, Position, ProgramOffsets};
use chordal_diagnostics::Diagnostic;
use chordal_geometry::Vec3;
use chordal_kernel::Outcome;
use chordal_motion::{AxisValues, MoveError, MoveRequest};
use chordal_path::{PathBuilder, SegmentKind};

use super::{MachineLimits, OperationMark};

/// What the machine does next.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(clippy::large_enum_variant, reason = "handed on by reference, never kept in numbers")]
pub enum MotionStep {
    /// It moves.
    Move(MoveRequest),
    /// Its axes come to rest and wait.
    Wait(MotionWait),
}

/// The axes come to rest and wait for a time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MotionWait {
    /// How long, s; 0 where the machine file gives no time: the axes come to rest all the same.
    pub seconds: f64,
    /// What for.
    pub kind: WaitKind,
    /// Identifies the step, as [`StepSource::tag`].
    pub tag: u64,
}

/// Why the axes wait.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash, PartialOrd, Ord)]
pub enum WaitKind {
    /// G4, or the dwell of a cycle.
    Dwell,
    /// A code of the shop's own.
    ShopCode,
    /// A tool goes into the spindle.
    ToolChange,
    /// The spindle starts, stops, reverses or changes its speed.
    SpindleSpeed,
    /// The spindle comes to rest at its mark (M19).
    SpindleOrient,
    /// Coolant is switched.
    Coolant,
    /// A probe has touched.
    Probe,
    /// M00, or M01 with optional stop on: the operator's time is not counted.
    Stop,
    /// The program ends.
    End,
}

impl WaitKind {
    /// The name for people: `tool change`.
    pub const fn name(self) -> &'static str {
        match self {
            WaitKind::Dwell => "dwell",
            WaitKind::ShopCode => "shop code",
            WaitKind::ToolChange => "tool change",
            WaitKind::SpindleSpeed => "spindle speed",
            WaitKind::SpindleOrient => "spindle orientation",
            WaitKind::Coolant => "coolant",
            WaitKind::Probe => "probe",
            WaitKind::Stop => "program stop",
            WaitKind::End => "program end",
        }
    }
}

/// What a step is, apart from its numbers.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum StepKind {
    /// A move of this kind.
    Move(SegmentKind),
    /// A wait.
    Wait(WaitKind),
}

/// Axes whose position is not known: their coordinates count from an unknown zero.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct UnknownAxes {
    /// All such axes.
    pub places: AxisMask,
    /// Those of them that move in the step: how far they go is not known, either.
    pub moves: AxisMask,
}

/// Where a step comes from.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct StepSource {
    /// Identifies the step: its number in the run in the upper 32 bits, the line of its block in the lower 32, so
    /// that tags grow. See [`StepSource::line_of`].
    pub tag: u64,
    /// The block.
    pub origin: Origin,
    /// The tool in the spindle.
    pub tool: u32,
    /// What it is.
    pub kind: StepKind,
    /// Index of its segment of [`Job::path`](crate::Job::path), from 0; for a wait that of the segment before it. A
    /// segment may have several steps.
    pub piece: u64,
    /// True where both ends are known relative to the part.
    pub known: bool,
    /// The axes whose position is not known during the step, and which of them move.
    pub unknown_axes: UnknownAxes,
    /// Length: mm along X, Y and Z, or rad where rotary axes alone move; 0 for a wait.
    pub length: f64,
    /// How long it takes at its feed with the overrides, without acceleration, s.
    pub nominal_s: f64,
    /// Position − shift is where the step is in the coordinates of [`Job::path`](crate::Job::path)
    /// (mm, rad), or, in a frame of the part, where the axes are without the offsets of the program.
    pub shift: AxisValues,
    /// The index of its frame of the part in [`MotionReport::part_frames`]; `None` where the path is that of the axes.
    pub part_frame: Option<u32>,
    /// Set where an operation begins with the step or is named before it.
    pub operation: Option<OperationMark>,
}

impl StepSource {
    /// The tag of the step with this number, from a block on this line.
    pub const fn tag_of(number: u32, line: u32) -> u64 {
        (number as u64) << 32 | line as u64
    }

    /// The line of a tag, from 1.
    pub const fn line_of(tag: u64) -> u32 {
        tag as u32
    }

    /// The number of a tag's step in the run, from 0.
    pub const fn number_of(tag: u64) -> u32 {
        (tag >> 32) as u32
    }
}

/// Takes the moves and waits of a run.
pub trait MotionSink {
    /// A command of the tool centre, before its steps.
    fn command(&mut self, _command: &Command) {}

    /// A step.
    ///
    /// # Errors
    /// Where a move cannot be taken. The moves after it then join on to the last one that was.
    fn step(&mut self, step: &MotionStep, source: &StepSource) -> Result<(), MoveError>;

    /// A problem of the program.
    fn diagnostic(&mut self, _diagnostic: Diagnostic) {}
}

impl<F: FnMut(&MotionStep, &StepSource) -> Result<(), MoveError>> MotionSink for F {
    fn step(&mut self, step: &MotionStep, source: &StepSource) -> Result<(), MoveError> {
        self(step, source)
    }
}

/// A move that could not be planned.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RefusedMove {
    /// Why.
    pub error: MoveError,
    /// Where it comes from.
    pub source: StepSource,
}

/// The counts of a run's steps, and how they were made.
#[derive(Clone, Debug)]
pub struct MotionReport {
    /// The limits that were used, and which of them the machine file does not give.
    pub limits: MachineLimits,
    /// Moves emitted.
    pub moves: u64,
    /// Waits emitted.
    pub waits: u64,
    /// Rapids that keep the bends of a dog-leg, each of which costs a little time.
    pub bent_rapids: u64,
    /// Cuts that are left out because they have no feed.
    pub cuts_without_feed: u64,
    /// Moves with an end that is not known relative to the part: they are planned as if offsets that the machine file
    /// does not give were zero.
    pub unknown_moves: u64,
    /// Moves that could not be planned; they are left out.
    pub refused_moves: u64,
    /// The first refused moves, at most 20.
    pub refused: Vec<RefusedMove>,
    /// The frames of the part in which the tip was, in order.
    pub part_frames: Vec<PlacedPartFrame>,
    /// How each program ended.
    pub outcomes: Vec<Outcome>,
}

/// A frame of the part with the offsets that were in force, and its place in the frame of the run.
#[derive(Clone, Debug, PartialEq)]
pub struct PlacedPartFrame {
    /// The frame.
    pub frame: Arc<PartFrame>,
    /// The offsets.
    pub offsets: ProgramOffsets,
    /// From work coordinates to the frame of the run, mm.
    pub shift: Vec3,
}

impl PlacedPartFrame {
    /// That of the last command of a path; `None` where its coordinates are those of the axes.
    pub(crate) fn of(path: &PathBuilder) -> Option<PlacedPartFrame> {
        let frame = Arc::clone(path.frame().part_frame.as_ref()?);
        let offsets = path.frame().offsets();
        Some(PlacedPartFrame { frame, offsets, shift: path.shift_to_run() })
    }

    /// The position of the tip in program coordinates, from the positions of the axes without the offsets, mm and rad.
    pub fn program_position(&self, axes: &Position) -> Position {
        self.frame.tip_of_axes(axes, &self.offsets)
    }

    /// A position in program coordinates in the frame of the run, mm.
    pub fn in_run_frame(&self, program: &Position) -> Vec3 {
        let [x, y, z, ..] = *program;
        self.frame.plane.apply_point(Vec3::new(x, y, z)) + self.shift
    }
}
