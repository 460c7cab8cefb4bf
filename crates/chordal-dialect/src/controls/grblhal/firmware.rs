//! How grblHAL reads and checks a block, and the numbers of its answers.

use super::super::grbl::firmware as family;
use crate::vocabulary::*;
use chordal_syntax::Letters;

pub(super) static FIRMWARE: Firmware = Firmware {
    line: LineRules {
        longest: 256,
        counts_blanks: false,
        percent_marks: true,
        slash: SlashMeaning::Deletes,
        digits: 9,
        zeros_count: false,
        named_commands: true,
        letters: Letters::of("DEFHIJKLNOPQRSTXYZ"),
        further_axes: true,
    },
    block: BlockRules {
        bare_circles: true,
        length_axes: Letters::of("XYZ"),
        cancel_with_one_shot: true,
        reference_with_motion: false,
    },
    with_fractions: &[5, 28, 30, 38, 43, 59, 61, 90, 91, 92],
    any_fraction: &[49],
    largest: [10_000_000, 255, 9],
    arc: family::ARC,
    optional: &[
        (BuildOption::ToolTable, &[(b'G', 430), (b'G', 432)]),
        (BuildOption::Expressions, &[(b'G', 650), (b'M', 980), (b'M', 990)]),
    ],
    needs: &[
        (b'G', 432, "H"),
        (b'M', 610, "Q"),
        (b'M', 980, "P"),
    ],
    rows: [ROWS, family::ROWS],
    dump: family::DUMP,
};

const ROWS: &[RefusalRow] = &[
    family::answer(
        14,
        FirmwareError::TooLong,
        "this line has more than 256 characters without blanks and comments",
        "write it on two lines",
    ),
    family::answer(19, FirmwareError::NotPositive, "this value must be above zero", "write a larger one"),
    family::answer(37, FirmwareError::LengthAxis, "G43.1 needs an axis word", "write X, Y or Z"),
    family::answer(42, FirmwareError::SplinePlane, "a spline needs the plane XY", "write G17 before it"),
    family::answer(
        54,
        FirmwareError::LevelOrder,
        "the bottom of this hole is above its R level",
        "check R and Z: from top to bottom it is R, then Z",
    ),
];
