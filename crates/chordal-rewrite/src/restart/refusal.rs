//! Why a program cannot begin at a line.

use crate::TransformRefusal;

/// Why a program cannot begin at a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum RefusalReason {
    /// There is no block to begin at.
    NoBlock,
    /// The program begins there anyway.
    Beginning,
    /// The line is in a called program.
    Called,
    /// The line is in a loop, a jump, or between a variable and its use, or is carried out again.
    Repeated,
    /// Cutter compensation is on.
    Compensation,
    /// A canned cycle is in force that a head cannot say again.
    Cycle,
    /// A rotation, scaling, mirror or polar coordinates are in force.
    Frame,
    /// The zero was moved by G92 or G52 in a way that a head cannot say again.
    Shift,
    /// A code is in force that a head cannot say again.
    Open,
    /// The position is not known.
    Position,
    /// The program has an error before the line or is not verified there.
    Unsure,
    /// The control has no form for what is needed.
    Form,
    /// The way in meets what stands on a lathe.
    HeadApproach,
    /// The new program would not do the same.
    Unproved,
}

impl RefusalReason {
    /// The word for programs.
    pub fn word(self) -> &'static str {
        match self {
            RefusalReason::NoBlock => "no-block",
            RefusalReason::Beginning => "beginning",
            RefusalReason::Called => "called",
            RefusalReason::Repeated => "repeated",
            RefusalReason::Compensation => "compensation",
            RefusalReason::Cycle => "cycle",
            RefusalReason::Frame => "frame",
            RefusalReason::Shift => "shift",
            RefusalReason::Open => "open",
            RefusalReason::Position => "position",
            RefusalReason::Unsure => "unsure",
            RefusalReason::Form => "form",
            RefusalReason::HeadApproach => "way-in",
            RefusalReason::Unproved => "unproved",
        }
    }
}

/// A refusal and its kind.
#[derive(Debug)]
pub struct RestartRefusal {
    /// What kind it is.
    pub reason: RefusalReason,
    /// What is said about it.
    pub refusal: TransformRefusal,
}
