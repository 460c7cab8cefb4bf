//! How GRBL 1.1 reads and checks a block, and the numbers of its answers.

use crate::vocabulary::*;
use chordal_machine::Axis;
use chordal_syntax::Letters;

pub(super) static FIRMWARE: Firmware = Firmware {
    line: LineRules {
        longest: 79,
        counts_blanks: false,
        percent_marks: false,
        slash: SlashMeaning::Dropped,
        digits: 8,
        zeros_count: true,
        named_commands: false,
        letters: Letters::of("FIJKLNPRSTXYZ"),
        further_axes: false,
    },
    block: BlockRules::STRICT,
    with_fractions: &[28, 30, 38, 43, 61, 90, 91, 92],
    any_fraction: &[49],
    largest: [10_000_000, 255, 6],
    arc: ARC,
    optional: &[(BuildOption::Mist, &[(b'M', 70)])],
    needs: &[],
    rows: [ROWS, &[]],
    dump: DUMP,
};

/// How far the radii of an arc may differ: 5 µm always, otherwise a thousandth of the radius, at most 0.5 mm.
pub(in crate::controls) const ARC: [f32; 3] = [0.005, 0.5, 0.001];

/// The answers that GRBL and its relatives share.
pub(in crate::controls) const ROWS: &[RefusalRow] = &[
    answer(
        1,
        FirmwareError::NoLetter,
        "a word begins with a letter, and this is none",
        "remove it: this firmware has no `%`, no `*`, no `#` and no brackets",
    ),
    answer(2, FirmwareError::NoNumber, "this letter has no number", "write the number after it"),
    answer(
        3,
        FirmwareError::UnknownCommand,
        "this firmware does not have this system command",
        "check it: `$H` homes, `$X` unlocks, `$$` lists the settings",
    ),
    answer(4, FirmwareError::Negative, "this word may not be below zero", "write it without the sign"),
    answer(
        11,
        FirmwareError::TooLong,
        "this line has more than 79 characters without blanks and comments",
        "write it on two lines",
    ),
    answer(
        16,
        FirmwareError::JogWords,
        "a jog takes axes, F, G20, G21, G53, G90 and G91 alone",
        "remove the other words",
    ),
    answer(
        20,
        FirmwareError::Unknown,
        "this firmware does not have this word",
        "remove it, or choose the post for this control: what it has is on its reference page",
    ),
    answer(21, FirmwareError::SameGroup, "this code and one before it exclude each other", "keep one of them"),
    answer(
        22,
        FirmwareError::NoFeed,
        "there is no feed for this cut",
        "write F in this block; with G93 each block needs its own",
    ),
    answer(23, FirmwareError::Fraction, "this code has no fraction", "write the whole number"),
    answer(
        24,
        FirmwareError::AxisConflict,
        "two codes of this block need the axis words",
        "write two blocks: G10, G28, G30, G92, G43.1 and G49 stand without G0 to G3",
    ),
    answer(25, FirmwareError::Repeated, "this letter stands in the block twice", "keep one of them"),
    answer(26, FirmwareError::NoAxes, "this code needs an axis word", "write X, Y or Z"),
    answer(27, FirmwareError::LineNumber, "a line number is at most 10000000", "write a smaller one, or none"),
    answer(
        28,
        FirmwareError::NoValue,
        "a word that this code needs is missing",
        "write it: P with G4 in seconds, P or L with G10, R and the depth with a cycle, Q with pecks",
    ),
    answer(29, FirmwareError::WorkOffset, "G10 does not have a work offset of this number", "P1 is G54, P6 is G59, and P0 is the active one"),
    answer(
        30,
        FirmwareError::MachineMotion,
        "G53 moves with G0 or G1 alone, and another motion is active",
        "write G0 or G1 in this block",
    ),
    answer(
        31,
        FirmwareError::AxesWithoutMotion,
        "there are axis words, and G80 has ended the motion",
        "write G0 or G1 in this block",
    ),
    answer(
        32,
        FirmwareError::NoPlaneAxes,
        "this arc names no axis of its plane",
        "write the end point, also where it is the start: a full circle needs it",
    ),
    answer(
        33,
        FirmwareError::OffCircle,
        "the end of this arc is not on its circle",
        "write more decimals of the centre and the end, or straight lines",
    ),
    answer(
        33,
        FirmwareError::SamePlace,
        "this motion ends where it begins",
        "write a full circle with I, J or K, not with R",
    ),
    answer(34, FirmwareError::Radius, "the radius is too short for the distance to the end", "check R"),
    answer(
        35,
        FirmwareError::NoCenter,
        "this arc has no centre word of its plane",
        "write I and J in G17, I and K in G18, J and K in G19, or R",
    ),
    answer(36, FirmwareError::Unused, "nothing in this block uses this word", "remove it"),
    answer(37, FirmwareError::LengthAxis, "G43.1 takes Z alone", "write Z, and no other axis"),
    answer(38, FirmwareError::ToolNumber, "a tool number is at most 255", "write a smaller one"),
];

/// A row of answers.
pub(in crate::controls) const fn answer(
    number: u8,
    refusal: FirmwareError,
    message: &'static str,
    help: &'static str,
) -> RefusalRow {
    RefusalRow { refusal, number, message, help }
}

/// The settings that describe the machine; GRBL and its relatives number them alike.
pub(in crate::controls) const DUMP: &[DumpRow] = &[
    dump(11, DumpMeaning::JunctionDeviation),
    dump(12, DumpMeaning::ArcTolerance),
    dump(32, DumpMeaning::LaserMode),
    dump(100, DumpMeaning::Steps(Axis::X)),
    dump(101, DumpMeaning::Steps(Axis::Y)),
    dump(102, DumpMeaning::Steps(Axis::Z)),
    dump(110, DumpMeaning::Velocity(Axis::X)),
    dump(111, DumpMeaning::Velocity(Axis::Y)),
    dump(112, DumpMeaning::Velocity(Axis::Z)),
    dump(120, DumpMeaning::Acceleration(Axis::X)),
    dump(121, DumpMeaning::Acceleration(Axis::Y)),
    dump(122, DumpMeaning::Acceleration(Axis::Z)),
    dump(130, DumpMeaning::Travel(Axis::X)),
    dump(131, DumpMeaning::Travel(Axis::Y)),
    dump(132, DumpMeaning::Travel(Axis::Z)),
];

const fn dump(number: u16, meaning: DumpMeaning) -> DumpRow {
    DumpRow { number, meaning }
}
