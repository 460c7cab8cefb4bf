//! How the firmware of a small control checks a block: as a whole, before anything of it acts (GRBL).
//!
//! A block with an error changes nothing, not even a mode; the answer is the number of its first error.

use chordal_machine::Axis;
use chordal_syntax::Letters;

/// An error in a block, in the order in which the firmware checks for them.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum FirmwareError {
    /// A word does not begin with a letter.
    NoLetter,
    /// A letter has no number.
    NoNumber,
    /// The firmware does not have this system command.
    UnknownCommand,
    /// F, N, P, S or T is negative.
    Negative,
    /// The line has more characters than the firmware reads.
    TooLong,
    /// A jog has other words than axes, F, G20, G21, G53, G90 and G91.
    JogWords,
    /// The firmware does not have this letter or code.
    Unknown,
    /// Two codes are of one modal group.
    SameGroup,
    /// A cutting move has no feed.
    NoFeed,
    /// A code with a decimal whose whole number has no such code.
    Fraction,
    /// Two codes use the axis words.
    AxisConflict,
    /// A letter is written twice.
    Repeated,
    /// A code has no axis words and needs some.
    NoAxes,
    /// The line number is too large.
    LineNumber,
    /// A word that a code needs is missing.
    NoValue,
    /// G10 names a work offset beyond the last.
    WorkOffset,
    /// G53 comes with another motion than G0 or G1.
    MachineMotion,
    /// Axis words while G80 is active.
    AxesWithoutMotion,
    /// An arc has no axis word of its plane.
    NoPlaneAxes,
    /// An arc does not end on its circle.
    OffCircle,
    /// An arc by its radius, or a probe move, ends where it begins.
    SamePlace,
    /// The radius is too short for the distance from start to end.
    Radius,
    /// An arc has no centre word of its plane.
    NoCenter,
    /// No code uses a word of the block.
    Unused,
    /// A tool length is given for an axis that has none.
    LengthAxis,
    /// The tool number is too large.
    ToolNumber,
    /// A value must be positive and is not.
    NotPositive,
    /// The bottom of a hole is above its R level.
    LevelOrder,
    /// A spline is not in the plane XY.
    SplinePlane,
}

/// What a slash in a line does.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum SlashMeaning {
    /// The firmware drops it, wherever it is.
    Dropped,
    /// The firmware drops it; at the begin of a line it deletes the line if block delete is on.
    Deletes,
    /// It is an error, as any character that begins no word.
    Kept,
}

/// How a line of text is divided into words.
#[derive(Clone, Copy, Debug)]
pub struct LineRules {
    /// The largest number of characters of a line.
    pub longest: usize,
    /// Whether blanks and comments count as characters of the line.
    pub counts_blanks: bool,
    /// Whether the firmware itself reads a line with only `%` as a mark; otherwise the sender drops such lines.
    pub percent_marks: bool,
    /// What a slash does.
    pub slash: SlashMeaning,
    /// Digits of a number that count; further ones are read as zeros or dropped.
    pub digits: u32,
    /// Whether leading zeros count as digits.
    pub zeros_count: bool,
    /// Whether `$` may begin a command or a setting of any name.
    pub named_commands: bool,
    /// Letters of its words.
    pub letters: Letters,
    /// Whether a build may have rotary axes; the machine file says which there are.
    pub further_axes: bool,
}

/// What a firmware of the family accepts and GRBL refuses.
#[derive(Clone, Copy, Debug)]
pub struct BlockRules {
    /// G2 and G3 with a centre and no axis word of the plane are a full circle, or with the third axis one turn of
    /// a helix.
    pub bare_circles: bool,
    /// The axes that G43.1 takes.
    pub length_axes: Letters,
    /// G80 may be in one block with a one-shot code that uses the axis words.
    pub cancel_with_one_shot: bool,
    /// G28 and G30 may be in one block with a motion code, and use the axis words.
    pub reference_with_motion: bool,
}

impl BlockRules {
    /// GRBL 1.1, which accepts none of this.
    pub const STRICT: BlockRules = BlockRules {
        bare_circles: false,
        length_axes: Letters::of("Z"),
        cancel_with_one_shot: false,
        reference_with_motion: false,
    };
}

/// An option that a build of a firmware has or not.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum BuildOption {
    /// An output for mist coolant: M7.
    Mist,
    /// A tool table: G43, G43.2, G10 L1.
    ToolTable,
    /// Parameters, expressions, flow control and calls.
    Expressions,
    /// Comments in parentheses are allowed.
    Parentheses,
    /// Lower-case letters are allowed.
    LowerCase,
    /// A line without a code continues the previous motion.
    MotionModes,
    /// G53 to G59.3.
    WorkSystems,
    /// G17, G18, G19.
    Planes,
    /// G20 and G21.
    Inch,
    /// P of an arc counts full turns before it.
    Turns,
    /// G5.
    Splines,
    /// G38.2 to G38.5.
    Probe,
    /// M7, M8, M9.
    Coolant,
}

impl BuildOption {
    /// All of them, in the order of their discriminants.
    pub const ALL: [BuildOption; 13] = [
        BuildOption::Mist,
        BuildOption::ToolTable,
        BuildOption::Expressions,
        BuildOption::Parentheses,
        BuildOption::LowerCase,
        BuildOption::MotionModes,
        BuildOption::WorkSystems,
        BuildOption::Planes,
        BuildOption::Inch,
        BuildOption::Turns,
        BuildOption::Splines,
        BuildOption::Probe,
        BuildOption::Coolant,
    ];
}

/// The codes that a build option adds: letter, and code in tenths.
pub type OptionalCodes = (BuildOption, &'static [(u8, u16)]);

/// Words that a code needs: the letter of the code, the code in tenths, and the letters of the words.
pub type NeededWords = (u8, u16, &'static str);

/// The answer of a firmware to an error.
#[derive(Clone, Copy, Debug)]
pub struct RefusalRow {
    /// The error.
    pub refusal: FirmwareError,
    /// The number of its answer `error:20`.
    pub number: u8,
    /// What is wrong, for users.
    pub message: &'static str,
    /// What to do, for users.
    pub help: &'static str,
}

/// A setting of the firmware (`$110`) that describes the machine.
#[derive(Clone, Copy, Debug)]
pub struct DumpRow {
    /// Its number.
    pub number: u16,
    /// What it describes.
    pub meaning: DumpMeaning,
}

/// What a setting of the firmware describes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DumpMeaning {
    /// The junction deviation, mm.
    JunctionDeviation,
    /// The largest distance of the segments of an arc from it, mm.
    ArcTolerance,
    /// Whether the output of the spindle drives a laser: 1 or 0.
    LaserMode,
    /// Steps per mm.
    Steps(Axis),
    /// The speed of rapids, mm/min.
    Velocity(Axis),
    /// The largest acceleration, mm/s².
    Acceleration(Axis),
    /// The travel, mm: the axis moves from this far below zero up to zero.
    Travel(Axis),
}

/// How a firmware reads and checks a block.
#[derive(Clone, Copy, Debug)]
pub struct Firmware {
    /// How a line is divided into words.
    pub line: LineRules,
    /// What it accepts beyond GRBL.
    pub block: BlockRules,
    /// Whole G numbers that have codes with a decimal: any other decimal is an unknown code.
    pub with_fractions: &'static [u16],
    /// Whole G numbers whose decimal is ignored.
    pub any_fraction: &'static [u16],
    /// The largest line number, tool number and work offset of G10 P.
    pub largest: [u32; 3],
    /// How far the radii at start and end of an arc may differ: always accepted, mm; never exceeded, mm; fraction
    /// of the radius accepted between these.
    pub arc: [f32; 3],
    /// Codes that depend on options of the build.
    pub optional: &'static [OptionalCodes],
    /// Codes that need words.
    pub needs: &'static [NeededWords],
    /// Its answers: its own, and those that the family shares.
    pub rows: [&'static [RefusalRow]; 2],
    /// The settings of `$$` that describe the machine.
    pub dump: &'static [DumpRow],
}

impl Firmware {
    /// Its answer to an error; `None` if it does not check for it.
    pub fn row(&self, refusal: FirmwareError) -> Option<&'static RefusalRow> {
        self.rows.into_iter().flatten().find(|row| row.refusal == refusal)
    }
}
