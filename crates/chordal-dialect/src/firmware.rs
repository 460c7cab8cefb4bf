//! How the firmware of a small control judges a block: as a whole, before anything of it acts (GRBL).
//!
//! A block with a mistake changes nothing, not even a mode, and answers with the number of its first mistake.

use chordal_machine::Axis;
use chordal_syntax::Letters;

/// A mistake in a block, in the order in which the firmware looks for them.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum Refusal {
    /// Something that is no letter where a word begins.
    NoLetter,
    /// A letter without a number.
    NoNumber,
    /// A system command that it does not have.
    UnknownCommand,
    /// F, N, P, S or T below zero.
    Negative,
    /// More characters than its line holds.
    TooLong,
    /// A jog with other words than axes, F, G20, G21, G53, G90, G91.
    JogWords,
    /// A letter or a code that it does not have.
    Unknown,
    /// Two codes of one group.
    SameGroup,
    /// A cut without a feed.
    NoFeed,
    /// A code with a fraction that has none.
    Fraction,
    /// Two codes that need the axis words.
    AxisConflict,
    /// A letter twice.
    Repeated,
    /// No axis words where they are needed.
    NoAxes,
    /// A line number above the largest.
    LineNumber,
    /// A word that a code needs is missing.
    NoValue,
    /// A work offset above the last.
    WorkOffset,
    /// G53 with another motion than G0 and G1.
    MachineMotion,
    /// Axis words while G80 is in force.
    AxesWithoutMotion,
    /// An arc without an axis of its plane.
    NoPlaneAxes,
    /// An arc that does not end on its circle.
    OffCircle,
    /// An arc by its radius, or a probe move, that ends where it begins.
    SamePlace,
    /// A radius too short for the distance.
    Radius,
    /// An arc without a centre word of its plane.
    NoCenter,
    /// Words that nothing uses.
    Unused,
    /// A tool length for another axis.
    LengthAxis,
    /// A tool number above the largest.
    ToolNumber,
}

/// What a firmware says of a mistake.
#[derive(Clone, Copy, Debug)]
pub struct RefusalRow {
    /// The mistake.
    pub refusal: Refusal,
    /// The number of its answer `error:20`.
    pub number: u8,
    /// What is wrong, for people.
    pub message: &'static str,
    /// What to do.
    pub help: &'static str,
}

/// A setting that says something of the machine.
#[derive(Clone, Copy, Debug)]
pub struct DumpRow {
    /// Its number.
    pub number: u16,
    /// What it says.
    pub meaning: DumpMeaning,
}

/// What a setting says of the machine.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DumpMeaning {
    /// How far a corner may be passed, mm.
    JunctionDeviation,
    /// How far the segments of an arc are from it, mm.
    ArcTolerance,
    /// Steps a mm.
    Steps(Axis),
    /// Rapid speed, mm/min.
    Velocity(Axis),
    /// mm/s².
    Acceleration(Axis),
    /// The axis goes from this far below zero to zero, mm.
    Travel(Axis),
}

/// How a firmware reads and judges a block.
#[derive(Clone, Copy, Debug)]
pub struct Firmware {
    /// Most characters of a line, without blanks and comments.
    pub longest_line: usize,
    /// So many digits of a number count, zeros in front included.
    pub digits: u32,
    /// Letters of its words.
    pub letters: Letters,
    /// Whole G numbers that have codes with a fraction: another fraction is an unknown code.
    pub with_fractions: &'static [u16],
    /// Whole G numbers whose fraction is not looked at.
    pub any_fraction: &'static [u16],
    /// Largest line number and tool number, and the last work offset of G10 P.
    pub largest: [u32; 3],
    /// What an arc may differ: always, at most, and in parts of its radius; mm.
    pub arc: [f32; 3],
    /// Its answers.
    pub rows: &'static [RefusalRow],
    /// What it prints for `$$`, as far as that is the machine's.
    pub dump: &'static [DumpRow],
}

impl Firmware {
    /// What it says of a mistake.
    pub fn row(&self, refusal: Refusal) -> Option<&'static RefusalRow> {
        self.rows.iter().find(|row| row.refusal == refusal)
    }
}
