//! How FluidNC reads and checks a block, and the numbers of its answers.

use super::super::grbl::firmware as family;
use crate::vocabulary::*;
use chordal_syntax::Letters;

pub(super) static FIRMWARE: Firmware = Firmware {
    line: LineRules {
        longest: 127,
        counts_blanks: true,
        percent_marks: true,
        slash: SlashMeaning::Kept,
        digits: 8,
        zeros_count: true,
        named_commands: true,
        letters: Letters::of("EFIJKLNPQRSTXYZ"),
        further_axes: true,
    },
    block: BlockRules {
        bare_circles: false,
        length_axes: Letters::of("XYZ"),
        cancel_with_one_shot: false,
        reference_with_motion: true,
    },
    with_fractions: &[28, 30, 38, 43, 59, 61, 90, 91, 92],
    any_fraction: &[49],
    largest: [10_000_000, 255, 9],
    arc: family::ARC,
    optional: &[],
    needs: &[(b'M', 610, "Q")],
    rows: [ROWS, family::ROWS],
    // Its settings are in its configuration file.
    dump: &[],
};

const ROWS: &[RefusalRow] = &[
    family::answer(
        14,
        FirmwareError::TooLong,
        "this line has more than 127 characters, blanks and comments included",
        "write it on two lines",
    ),
    family::answer(37, FirmwareError::LengthAxis, "G43.1 needs an axis word", "write X, Y or Z"),
];
