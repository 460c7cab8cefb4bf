//! Signs by which programs of Fadal CNC 88 are recognized.

use crate::vocabulary::*;

pub(super) const EVIDENCE: &[Evidence] = &[
    Evidence {
        sign: Sign::SubroutineHead,
        weight: 8,
        reason: "a subroutine section headed by an L word",
    },
    Evidence { sign: Sign::M(170), weight: 6, reason: "M17 ends a subroutine" },
    Evidence { sign: Sign::Register, weight: 8, reason: "R0+ is a register word" },
    Evidence { sign: Sign::Letters("EXY"), weight: 3, reason: "E chooses a work offset" },
    Evidence { sign: Sign::With("EXY"), weight: 4, reason: "E chooses a work offset" },
    Evidence { sign: Sign::With("HZ"), weight: 1, reason: "H with Z" },
    Evidence { sign: Sign::Letters("HZ"), weight: 3, reason: "H applies the length without G43" },
    Evidence { sign: Sign::Letters("DHZ"), weight: 3, reason: "H applies the length without G43" },
    Evidence { sign: Sign::OpenComment, weight: 3, reason: "comments are left open" },
    Evidence { sign: Sign::G(80), weight: 2, reason: "G8 switches feed ramps off" },
    Evidence { sign: Sign::M(450), weight: 4, reason: "M45 runs a cycle on the spot" },
];
