//! Signs by which programs of Fanuc 0i are recognized.

use crate::vocabulary::*;

pub(super) const EVIDENCE: &[Evidence] = &[
    Evidence { sign: Sign::G(541), weight: 3, reason: "G54.1 chooses an extended work offset" },
    Evidence { sign: Sign::G(51), weight: 2, reason: "G5.1 switches look-ahead on" },
    Evidence { sign: Sign::MacroStatement, weight: 1, reason: "macro B statements" },
    Evidence { sign: Sign::M(290), weight: 2, reason: "M29 announces rigid tapping" },
    Evidence { sign: Sign::G(430), weight: 1, reason: "G43 applies the tool length" },
];
