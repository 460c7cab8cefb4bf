//! The settings of GRBL 1.1, and of who sends it programs.

use crate::vocabulary::*;

pub(super) const SETTINGS: &[Setting] = &[
    setting(
        "on error",
        Field::AfterRefusal,
        &[],
        "what the sender does after a block that GRBL refuses: `stop` or `continue`",
        Certainty::Trade,
        "senders; GRBL itself goes on with the next block",
    ),
    setting(
        "M6",
        Field::ToolChanger,
        &[],
        "who changes tools: the `sender`, which keeps M6 from GRBL, or `nobody`: error:20",
        Certainty::Trade,
        "senders; GRBL itself refuses M6",
    ),
    setting(
        "$11",
        Field::Path(PathField::JunctionDeviation),
        &[],
        "junction deviation: how fast corners are passed; 0 stops at each",
        Certainty::Documented,
        "settings",
    ),
    setting(
        "$12",
        Field::Path(PathField::ArcTolerance),
        &[],
        "arc tolerance: how far the segments of an arc are from it",
        Certainty::Documented,
        "settings",
    ),
    steps("$100", 0, "steps of X a mm: segments end on whole steps"),
    steps("$101", 1, "steps of Y a mm"),
    steps("$102", 2, "steps of Z a mm"),
    setting(
        "planner blocks",
        Field::Path(PathField::JunctionBlocks),
        &[],
        "segments that are known ahead, with the one under way",
        Certainty::Documented,
        "BLOCK_BUFFER_SIZE of the build, less one",
    ),
];

const fn steps(name: &'static str, axis: u8, text: &'static str) -> Setting {
    let field = Field::Path(PathField::Steps(axis));
    setting(name, field, &[], text, Certainty::Documented, "settings")
}
