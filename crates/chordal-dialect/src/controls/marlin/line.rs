//! How Marlin reads a line.

use crate::vocabulary::*;
use chordal_syntax::Letters;

pub(super) static COMMAND_LINE: CommandLine = CommandLine {
    commands: Letters::of("GMT"),
    texts: &[16, 23, 28, 30, 32, 117, 118, 928],
    remarks: &[0, 1, 600],
    prefixes: &[530],
    bare_axes: &[280],
    motion_words: Letters::of("XYZEFIJPR"),
    optional: &[
        (BuildOption::Planes, &[(b'G', 170), (b'G', 180), (b'G', 190)]),
        (BuildOption::Inch, &[(b'G', 200)]),
        (
            BuildOption::WorkSystems,
            &[
                (b'G', 530),
                (b'G', 540),
                (b'G', 550),
                (b'G', 560),
                (b'G', 570),
                (b'G', 580),
                (b'G', 590),
                (b'G', 591),
                (b'G', 592),
                (b'G', 593),
                (b'G', 921),
            ],
        ),
        (BuildOption::Splines, &[(b'G', 50)]),
        (BuildOption::Probe, &[(b'G', 382), (b'G', 383), (b'G', 384), (b'G', 385)]),
        (BuildOption::MotionModes, &[(b'G', 800)]),
        (BuildOption::Coolant, &[(b'M', 70), (b'M', 80), (b'M', 90)]),
    ],
    ignored_codes: IGNORED_CODES,
    unknown: ["echo:Unknown command: \"", "\""],
};

/// Codes of other controls that change nothing here: modes that Marlin always has, and marks of begin and end.
const IGNORED_CODES: &[(u8, u16)] = &[
    (b'G', 170),
    (b'G', 400),
    (b'G', 490),
    (b'G', 540),
    (b'G', 610),
    (b'G', 640),
    (b'G', 800),
    (b'G', 911),
    (b'G', 940),
    (b'G', 970),
    (b'G', 980),
];
