//! Signs by which programs of Mitsubishi M700 and M800 are recognized.

use crate::vocabulary::*;

pub(super) const EVIDENCE: &[Evidence] = &[
    Evidence { sign: Sign::G(21), weight: 8, reason: "G2.1 cuts a spiral" },
    Evidence { sign: Sign::G(31), weight: 8, reason: "G3.1 cuts a spiral" },
    Evidence { sign: Sign::G(611), weight: 4, reason: "G61.1 switches high-accuracy control on" },
    Evidence { sign: Sign::G(371), weight: 4, reason: "G37.1 drills a grid" },
];
