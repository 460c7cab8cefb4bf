//! Signs by which programs of LinuxCNC (RS274/NGC) are recognized.

use crate::vocabulary::*;

pub(super) const EVIDENCE: &[Evidence] = &[
    Evidence { sign: Sign::OWord, weight: 8, reason: "O words are flow control" },
    Evidence { sign: Sign::SemicolonComment, weight: 3, reason: "comments after semicolons" },
    Evidence { sign: Sign::G(641), weight: 2, reason: "G64 P" },
    Evidence { sign: Sign::G(382), weight: 5, reason: "G38.2 probes" },
    Evidence { sign: Sign::G(901), weight: 5, reason: "G90.1 sets absolute arc centres" },
    Evidence { sign: Sign::G(911), weight: 5, reason: "G91.1 sets incremental arc centres" },
];
