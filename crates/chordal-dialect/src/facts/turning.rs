//! What is known of the cycles of lathes: a row for each.

use chordal_kernel::rules::{TurnCycle, TurnFamily};

use super::CycleWordRole::{
    self, CountedInTwoBlocks, CountedLength, Distance, Lead, Length, Move, Other,
};
use crate::settings::SettingField;

/// Letters; the role of their numbers in a block that only sets the cycle up, and in the block that runs it; their meaning,
/// empty where none is on record. The number of a letter in no row is no length.
type TurnWordRow = (&'static str, [CycleWordRole; 2], &'static str);

/// What is known of a cycle of a lathe, whichever control has it.
#[derive(Clone, Copy, Debug)]
pub struct TurnFacts {
    /// Its words.
    words: &'static [TurnWordRow],
    /// A block without any of these letters only sets the cycle up, where the control programs it in two blocks; empty for
    /// cycles of one block.
    pub ends: &'static str,
    /// The settings that change what it does.
    pub settings: &'static [SettingField],
    /// The words of a block that calls it, with `{}` for the code; empty where it needs more than a block.
    pub example: &'static str,
}

impl TurnFacts {
    /// What a letter means; `None` where it does nothing to the path.
    pub fn meaning(&self, letter: u8) -> Option<&'static str> {
        let has = |row: &&TurnWordRow| row.0.contains(char::from(letter)) && !row.2.is_empty();
        self.words.iter().find(has).map(|(_, _, meaning)| *meaning)
    }

    /// What the number with a letter is.
    pub fn role(&self, letter: u8, is_setup: bool) -> CycleWordRole {
        let row = self.words.iter().find(|(letters, ..)| letters.contains(char::from(letter)));
        row.map_or(Other, |(_, [first, main], _)| if is_setup { *first } else { *main })
    }
}

/// The words of a cycle with a contour: its first and last block, and the feed and speed of all cuts.
macro_rules! rows_of_contour {
    ($($own:expr),* $(,)?) => {
        &[
            $($own,)*
            ("P", [Other; 2], "number of the first block of the contour"),
            ("Q", [Other; 2], "number of the last block of the contour"),
            ("F", [Move; 2], "feed of the cycle"),
            ("S", [Move; 2], "spindle speed of the cycle"),
        ]
    };
}

/// The words of pecks: what P and Q, along X and along Z, are.
macro_rules! rows_of_pecks {
    ($p:expr, $q:expr) => {
        &[
            ("P", [CountedLength; 2], $p),
            ("Q", [CountedLength; 2], $q),
            (
                "R",
                [Length; 2],
                "how far a peck backs off; with X or Z how far the tool goes aside at the bottom",
            ),
            ("IKD", [Length; 2], ""),
            ("XZUW", [Move; 2], ""),
            ("F", [Move; 2], "feed of the cycle"),
            ("S", [Move; 2], "spindle speed of the cycle"),
        ]
    };
}

/// The words of a cycle whose contour is in a subroutine, after those of its own.
macro_rules! rows_of_subroutine {
    ($($own:expr),* $(,)?) => {
        &[
            $($own,)*
            ("XZFS", [Move; 2], ""),
            ("Q", [Other; 2], "number of the subroutine that holds the contour"),
            ("P", [Other; 2], "number of passes"),
        ]
    };
}

/// What is known of a cycle of a lathe.
pub fn turn_facts(cycle: TurnCycle) -> TurnFacts {
    let words: &'static [TurnWordRow] = match cycle {
        TurnCycle::Finish => rows_of_contour![],
        TurnCycle::Rough => rows_of_contour![
            (
                "U",
                [Length, Distance(0)],
                "depth of a pass on the radius; with P and Q the finishing allowance on the diameter",
            ),
            ("W", [Length, Distance(2)], "finishing allowance along Z"),
            ("R", [Length, Other], "how far a pass backs off"),
            ("D", [Other, Length], "depth of a pass, in one block"),
            ("IK", [Other, Length], ""),
        ],
        TurnCycle::RoughFace => rows_of_contour![
            ("U", [Length, Distance(0)], "finishing allowance on the diameter"),
            (
                "W",
                [Length, Distance(2)],
                "depth of a pass; with P and Q the finishing allowance along Z",
            ),
            ("R", [Length, Other], "how far a pass backs off"),
            ("D", [Other, Length], "depth of a pass, in one block"),
            ("IK", [Other, Length], ""),
        ],
        TurnCycle::Pattern => rows_of_contour![
            (
                "U",
                [Distance(0); 2],
                "what is to be removed, on the radius; with P and Q the finishing allowance on the diameter",
            ),
            (
                "W",
                [Distance(2); 2],
                "what is to be removed along Z; with P and Q the finishing allowance",
            ),
            ("R", [Other; 2], "number of passes"),
            ("I", [Distance(0); 2], ""),
            ("K", [Distance(2); 2], ""),
        ],
        TurnCycle::PeckZ => {
            rows_of_pecks!["distance of the plunges, on the radius", "depth of a peck"]
        }
        TurnCycle::PeckX => {
            rows_of_pecks!["depth of a peck, on the radius", "distance of the plunges along Z"]
        }
        TurnCycle::Thread => &[
            (
                "P",
                [Other, CountedInTwoBlocks],
                "passes, exit and angle in two digits each; with X and Z the height of the thread",
            ),
            (
                "Q",
                [CountedLength, CountedInTwoBlocks],
                "least depth of a pass; with X and Z the depth of the first pass",
            ),
            ("R", [Length, Distance(0)], "depth of the finishing pass; with X and Z the taper"),
            ("K", [CountedLength; 2], "height of the thread, in one block"),
            ("D", [CountedLength; 2], "depth of the first pass, in one block"),
            ("A", [Other; 2], "angle of the thread, in one block"),
            ("I", [Distance(0); 2], "taper on the radius, in one block"),
            ("XZUW", [Move; 2], ""),
            ("F", [Lead; 2], "feed of the cycle"),
            ("S", [Move; 2], "spindle speed of the cycle"),
        ],
        TurnCycle::FinishSubroutine => rows_of_subroutine![
            (
                "D",
                [Length; 2],
                "what is left on the contour; of G70 the distance before the first pass",
            ),
            ("E", [Length; 2], "distance of the last pass"),
            ("I", [Other; 2], "depth of a pass, on the radius"),
            ("R", [Other; 2], "how far a pass backs off"),
        ],
        TurnCycle::RoughSubroutine(_) | TurnCycle::RoughFaceSubroutine(_) => rows_of_subroutine![
            (
                "D",
                [Length; 2],
                "what is left on the contour; of G70 the distance before the first pass",
            ),
            ("E", [Other; 2], "distance of the last pass"),
            ("I", [Length; 2], "depth of a pass, on the radius"),
            ("R", [Length; 2], "how far a pass backs off"),
        ],
        TurnCycle::LineThread => &[
            ("P", [Lead; 2], "lead of the thread"),
            (
                "I",
                [Distance(0); 2],
                "from the start to the crest; below zero outside, above zero in a bore",
            ),
            ("J", [Length; 2], "depth of the first pass"),
            ("K", [Length; 2], "height of the thread"),
            ("R", [Other; 2], "how the depth of the passes falls: 1 equal steps, 2 equal areas"),
            ("Q", [Other; 2], "angle of the infeed, degrees"),
            ("H", [Other; 2], "further passes at the whole height"),
            ("E", [Length; 2], "length of the tapered ends along Z"),
            ("L", [Other; 2], "tapered ends: 0 none, 1 at the start, 2 at the end, 3 both"),
            ("XZFS", [Move; 2], ""),
        ],
    };
    TurnFacts { words, ..of_family(cycle) }
}

/// What the cycles of a family share; `example` is empty for cycles that need the blocks of a contour, too.
fn of_family(cycle: TurnCycle) -> TurnFacts {
    let facts = TurnFacts { words: &[], ends: "", settings: &[], example: "" };
    match cycle.family() {
        TurnFamily::Finish | TurnFamily::Subroutine => facts,
        TurnFamily::LineThread => TurnFacts { example: "{} P1.5 Z-20. I-1. J0.2 K0.92", ..facts },
        TurnFamily::Pattern => TurnFacts { ends: "PQ", ..facts },
        TurnFamily::Rough => TurnFacts {
            ends: "PQ",
            settings: &[
                SettingField::TURNING_ROUGH_DEPTH,
                SettingField::TURNING_ROUGH_RETRACT,
                SettingField::TURNING_FIRST_LEVEL,
            ],
            ..facts
        },
        TurnFamily::Peck => TurnFacts {
            ends: "XZUW",
            settings: &[SettingField::TURNING_PECK_RETRACT],
            example: match cycle == TurnCycle::PeckX {
                true => "{} X40. Z-30. P3000 Q2500 F0.1",
                false => "{} Z-40. Q12000 F0.15",
            },
            ..facts
        },
        TurnFamily::Thread => TurnFacts {
            ends: "XZUW",
            settings: &[
                SettingField::TURNING_THREAD_EXIT,
                SettingField::TURNING_THREAD_LEAST,
                SettingField::TURNING_THREAD_FINISH,
                SettingField::TURNING_THREAD_FINISH_PASSES,
                SettingField::TURNING_THREAD_ANGLE,
            ],
            example: "{} X20.376 Z-25. P1812 Q500 F3.",
            ..facts
        },
    }
}
