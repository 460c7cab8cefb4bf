//! Texts that begin at one of their lines, as a language writes them.

use std::ops::Range;

use crate::state_items::StateItem;

/// Why a program cannot begin at a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum RestartObstacle {
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

impl RestartObstacle {
    /// The word for programs.
    pub fn word(self) -> &'static str {
        match self {
            RestartObstacle::NoBlock => "no-block",
            RestartObstacle::Beginning => "beginning",
            RestartObstacle::Called => "called",
            RestartObstacle::Repeated => "repeated",
            RestartObstacle::Compensation => "compensation",
            RestartObstacle::Cycle => "cycle",
            RestartObstacle::Frame => "frame",
            RestartObstacle::Shift => "shift",
            RestartObstacle::Open => "open",
            RestartObstacle::Position => "position",
            RestartObstacle::Unsure => "unsure",
            RestartObstacle::Form => "form",
            RestartObstacle::HeadApproach => "way-in",
            RestartObstacle::Unproved => "unproved",
        }
    }
}

/// The refusal of a line.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct RestartFault {
    /// What kind it is.
    pub obstacle: RestartObstacle,
    /// What stands in the way.
    pub what: String,
    /// What to do instead.
    pub help: String,
}

/// A function before the line that the head does not repeat: what it has set is not known.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UnrepeatedCode {
    /// The code with its words, as the program writes them.
    pub words: String,
    /// The line of the last block that says so.
    pub line: u32,
}

/// A text that begins at one of its blocks: its own first lines, a head, and the old text from the line on. Nothing is
/// proved.
#[derive(Clone, Debug)]
pub struct RestartedText {
    /// The text.
    pub text: Vec<u8>,
    /// The lines that are put in.
    pub head: Vec<String>,
    /// The text before this byte is at the same place in both.
    pub kept: u32,
    /// The first byte of the rest, in the old text and in the new one.
    pub begins: [u32; 2],
    /// The first block of the rest that is carried out, by its first byte in the old text.
    pub block: u32,
    /// Parts of the old text before the line that stand at another place of the new one: their bytes, and where they begin.
    pub moved: Vec<(Range<u32>, u32)>,
    /// The head does not go to the place of the tool: the rest goes to its first place by itself.
    pub approaches: bool,
    /// What the head does not repeat, in the order of the program.
    pub unrepeated: Vec<UnrepeatedCode>,
    /// Items that no block of the language takes from the blocks before it.
    pub free_items: &'static [StateItem],
}
