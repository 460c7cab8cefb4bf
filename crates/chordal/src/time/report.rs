//! The report on the time of a program: times, costliest blocks, reasons.

use chordal_command::Origin;
use std::fmt;

use chordal_diagnostics::Span;

use crate::motion::WaitKind;

/// Why a block takes the time that it takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum TimeReason {
    /// It runs at the programmed feed.
    Feed,
    /// An arc or another curve: the speed on it is limited by what the axes can accelerate.
    Curvature,
    /// Speeding up and slowing down at the axes' acceleration.
    Acceleration,
    /// Speeding up and slowing down, limited most of the time by the axes' jerk.
    Jerk,
    /// It begins or ends at rest: exact stop, or a corner that may not be rounded.
    Stop,
    /// It ends at a corner that is passed within its tolerance.
    Corner,
    /// It is too short to reach its feed.
    ShortSegments,
    /// An axis moves at its largest speed.
    AxisSpeed,
    /// A rapid.
    Rapid,
    /// The axes wait.
    Wait(WaitKind),
}

impl TimeReason {
    /// The word for people and programs.
    pub fn word(self) -> &'static str {
        match self {
            TimeReason::Feed => "feed",
            TimeReason::Curvature => "curvature",
            TimeReason::Acceleration => "acceleration",
            TimeReason::Jerk => "jerk",
            TimeReason::Stop => "exact stop",
            TimeReason::Corner => "corner",
            TimeReason::ShortSegments => "short segments",
            TimeReason::AxisSpeed => "axis speed",
            TimeReason::Rapid => "rapid",
            TimeReason::Wait(kind) => kind.name(),
        }
    }
}

impl fmt::Display for TimeReason {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.word())
    }
}

/// Times of a part of a program, s.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct TimeShares {
    /// Cuts.
    pub cutting_s: f64,
    /// Rapids.
    pub rapid_s: f64,
    /// Everything else: dwells, tool changes, spindle.
    pub other_s: f64,
    /// What the moves take beyond their length over feed or rapid speed.
    pub lost_s: f64,
}

impl TimeShares {
    /// All of it, s.
    pub fn total_s(&self) -> f64 {
        self.cutting_s + self.rapid_s + self.other_s
    }
}

/// The time of one tool.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ToolTime {
    /// Its number; 0 before any tool was changed.
    pub number: u32,
    /// How often it went into the spindle.
    pub changes: u32,
    /// Its times; its own changes count as other.
    pub times: TimeShares,
}

/// The time of one operation: what a tool does from one tool change to the next, or to the end of the program; also
/// from comment to comment, where that was requested ([`OperationStart`](crate::motion::OperationStart)). A tool that
/// is used again begins another operation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OperationTime {
    /// Number of the tool.
    pub tool: u32,
    /// The first block.
    pub first: Origin,
    /// The last block.
    pub last: Origin,
    /// The comment with which it begins; `None` without one, or where operations begin at tool changes only.
    pub comment: Option<Span>,
    /// Its times.
    pub times: TimeShares,
}

/// The time of one block, all its runs together.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BlockTime {
    /// The block.
    pub origin: Origin,
    /// How often it ran.
    pub runs: u64,
    /// Time of all runs, s.
    pub time_s: f64,
    /// What the moves take beyond their length over feed or rapid speed, s.
    pub lost_s: f64,
    /// Why the longest run takes its time.
    pub reason: TimeReason,
    /// Time of the longest run, s.
    pub longest_s: f64,
    /// Why the move that loses the most in one run loses time.
    pub loses: TimeReason,
    /// What that move loses, s.
    pub largest_loss_s: f64,
}

/// How the ends of cuts are passed.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct CutEnds {
    /// At rest: exact stop, next to a rapid, before a wait.
    pub at_rest: u64,
    /// Exactly on the path: at rest where the direction changes abruptly.
    pub exact: u64,
    /// Within a tolerance.
    pub within: u64,
    /// Those of `within` where the control joins short blocks; at the others each corner is rounded by itself.
    pub joined: u64,
    /// The smallest and the largest tolerance of `within`, mm; `None` where there are none.
    pub tolerance_mm: Option<(f64, f64)>,
}

/// The time that a program takes on a machine, within the limits of acceleration and jerk.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct TimeReport {
    /// Times of the whole program.
    pub times: TimeShares,
    /// The times of waits by their reason, s; only reasons with a time are listed.
    pub waits: Vec<(WaitKind, f64)>,
    /// Length of the cuts over their feed plus length of the rapids over rapid speed, s.
    pub at_feed_s: f64,
    /// Moves that were planned.
    pub moves: u64,
    /// Moves that end at rest though the next one goes on in the same direction, as a line and a tangent arc whose
    /// change of curvature the path mode does not let the control smooth.
    pub tangent_stops: u64,
    /// How the ends of cuts are passed.
    pub cut_ends: CutEnds,
    /// Tool changes.
    pub tool_changes: u64,
    /// Tools in the order of their first use.
    pub tools: Vec<ToolTime>,
    /// Operations in the order of the run.
    pub operations: Vec<OperationTime>,
    /// Operations beyond those that are kept; their times are in the tools'.
    pub operations_left_out: u64,
    /// The blocks that take the most time, most first.
    pub longest: Vec<BlockTime>,
    /// The blocks that lose the most time beyond feed, most first.
    pub costliest: Vec<BlockTime>,
}

impl TimeReport {
    /// All of it, s.
    pub fn total_s(&self) -> f64 {
        self.times.total_s()
    }
}
