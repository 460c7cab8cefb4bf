//! Signs by which programs of Haas mill are recognized.

use crate::vocabulary::*;

pub(super) const EVIDENCE: &[Evidence] = &[
    Evidence { sign: Sign::G(1540), weight: 8, reason: "G154 chooses an extended work offset" },
    Evidence { sign: Sign::G(1870), weight: 6, reason: "G187 sets smoothness" },
    Evidence { sign: Sign::G(1500), weight: 6, reason: "G150 mills a pocket" },
    Evidence { sign: Sign::G(1030), weight: 6, reason: "G103 limits look-ahead" },
    Evidence { sign: Sign::M(970), weight: 4, reason: "M97 calls within the program" },
    Evidence {
        sign: Sign::MachineCoordinatesWithOthers,
        weight: 4,
        reason: "G53 G49 in one block",
    },
    Evidence { sign: Sign::FiveDigitProgram, weight: 3, reason: "a program number of five digits" },
    Evidence { sign: Sign::G(530), weight: 1, reason: "G53 homes an axis" },
];
