//! How the firmware of a small control judges a block: as a whole, before anything of it acts (GRBL).
//!
//! A block with a mistake changes nothing, not even a mode, and answers with the number of its first mistake.

use chordal_machine::Axis;
use chordal_syntax::Letters;

/// A mistake in a block, in the order in which the firmware looks for them.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum FirmwareError {
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
    /// A value that must be above zero.
    NotPositive,
    /// A hole whose bottom is above its R level.
    LevelOrder,
    /// A spline in another plane than XY.
    SplinePlane,
}

/// What a slash in a line does.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum SlashMeaning {
    /// It is dropped, wherever it stands.
    Dropped,
    /// The same, but at the begin of a line it takes the line away where block delete is on.
    Deletes,
    /// It is a character that begins no word.
    Kept,
}

/// How a line of text becomes words.
#[derive(Clone, Copy, Debug)]
pub struct LineRules {
    /// Most characters.
    pub longest: usize,
    /// Blanks and comments count among them.
    pub counts_blanks: bool,
    /// The firmware itself reads `%` on a line of its own as a mark; for others the sender drops it.
    pub percent_marks: bool,
    /// A slash.
    pub slash: SlashMeaning,
    /// So many digits of a number count.
    pub digits: u32,
    /// Zeros in front are among them.
    pub zeros_count: bool,
    /// A `$` may begin a command or a setting of any name.
    pub named_commands: bool,
    /// Letters of its words.
    pub letters: Letters,
    /// A build may have rotary axes; the machine file says which.
    pub further_axes: bool,
}

/// What a firmware lets pass that its kin refuses.
#[derive(Clone, Copy, Debug)]
pub struct BlockRules {
    /// G2 and G3 with a centre and no axis word of the plane: a full circle, or with the third axis a ring of a helix.
    pub bare_circles: bool,
    /// The axes that G43.1 takes.
    pub length_axes: Letters,
    /// G80 may stand next to a code that takes the axis words.
    pub cancel_with_one_shot: bool,
    /// G28 and G30 take the axis words also next to a motion.
    pub reference_with_motion: bool,
}

impl BlockRules {
    /// GRBL 1.1.
    pub const STRICT: BlockRules = BlockRules {
        bare_circles: false,
        length_axes: Letters::of("Z"),
        cancel_with_one_shot: false,
        reference_with_motion: false,
    };
}

/// What a build of a firmware has or not.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum BuildOption {
    /// An output for mist: M7.
    Mist,
    /// A tool table: G43, G43.2, G10 L1.
    ToolTable,
    /// Parameters, expressions, flow control and calls.
    Expressions,
    /// Comments in parentheses.
    Parentheses,
    /// Lower-case letters.
    LowerCase,
    /// A line of words alone goes on with the motion before it.
    MotionModes,
    /// G53 to G59.3.
    WorkSystems,
    /// G17, G18, G19.
    Planes,
    /// G20 and G21.
    Inch,
    /// P of an arc counts full circles before it.
    Turns,
    /// G5.
    Splines,
    /// G38.2 to G38.5.
    Probe,
    /// M7, M8, M9.
    Coolant,
}

impl BuildOption {
    /// All of them, in the order of their numbers.
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

/// The codes that a build option brings: letter and ten times the number.
pub type OptionalCodes = (BuildOption, &'static [(u8, u16)]);

/// Words that a code needs: its letter, ten times its number, and the letters of the words.
pub type NeededWords = (u8, u16, &'static str);

/// What a firmware says of a mistake.
#[derive(Clone, Copy, Debug)]
pub struct RefusalRow {
    /// The mistake.
    pub refusal: FirmwareError,
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
    /// Whether the output of the spindle drives a laser: 1 or 0.
    LaserMode,
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
    /// From text to words.
    pub line: LineRules,
    /// What passes.
    pub block: BlockRules,
    /// Whole G numbers that have codes with a fraction: another fraction is an unknown code.
    pub with_fractions: &'static [u16],
    /// Whole G numbers whose fraction is not looked at.
    pub any_fraction: &'static [u16],
    /// Largest line number and tool number, and the last work offset of G10 P.
    pub largest: [u32; 3],
    /// What an arc may differ: always, at most, and in parts of its radius; mm.
    pub arc: [f32; 3],
    /// Codes that not every build has.
    pub optional: &'static [OptionalCodes],
    /// Codes that need words.
    pub needs: &'static [NeededWords],
    /// Its answers: its own, and those that it has with its kin.
    pub rows: [&'static [RefusalRow]; 2],
    /// What it prints for `$$`, as far as that is the machine's.
    pub dump: &'static [DumpRow],
}

impl Firmware {
    /// What it says of a mistake.
    pub fn row(&self, refusal: FirmwareError) -> Option<&'static RefusalRow> {
        self.rows.into_iter().flatten().find(|row| row.refusal == refusal)
    }
}
