//! Pocket cycles and fixed routines.

use super::{Code, CodeInfo};
use crate::Severity;

pub(super) const IMPROPER_FIXED_ROUTINE: CodeInfo = CodeInfo {
    code: Code::ImproperFixedRoutine,
    id: "CH820",
    name: "improper-fixed-routine",
    severity: Severity::Error,
    summary: "a rule of the fixed routines is broken",
    explanation: r#"The fixed routines (Fadal L91 to L99) need all of their R words in the same block, an active tool offset
with a diameter above zero in the table, no active drilling cycle and no active cutter compensation. They
cannot be called in MDI. R1 of the pockets is the corner radius of the tool: 0 for a square end mill. It is
never the radius of the tool itself: then the tool would have no flat end to clear the floor with.

    H3 D3 Z.1 M8
    L9601 R0+40. R1+.01 R2+2.98 R3+1.98"#,
};

pub(super) const TOO_SMALL: CodeInfo = CodeInfo {
    code: Code::PocketTooSmall,
    id: "CH821",
    name: "pocket-too-small",
    severity: Severity::Error,
    summary: "the tool does not fit into the pocket",
    explanation: r#"A pocket must be larger than the diameter of the tool, and the radii of a round pocket must increase: tool
radius, then I, then K. Compare the diameter in the offset table with the sizes in the program. The usual
cause is a radius entered as a diameter, or the reverse."#,
};

pub(super) const WITHOUT_DIAMETER: CodeInfo = CodeInfo {
    code: Code::PocketWithoutDiameter,
    id: "CH822",
    name: "pocket-without-diameter",
    severity: Severity::Error,
    summary: "a pocket needs the diameter of the tool, and none is given",
    explanation: r#"Pocket cycles offset by the tool radius themselves. They need the D word (or, where H also gives the
diameter, H) and a diameter in the machine file's tool table:

    chordal check pocket.nc --set tools.1.diameter="0.5 in""#,
};

pub(super) const WITHOUT_GEOMETRY: CodeInfo = CodeInfo {
    code: Code::PocketWithoutGeometry,
    id: "CH823",
    name: "pocket-without-geometry",
    severity: Severity::Error,
    summary: "the outline of a pocket cycle is missing",
    explanation: r#"G150 takes the outline of the pocket from the blocks that P names: those after an N number of the same
program, or a program with that O number, up to M99."#,
};

pub(super) const GEOMETRY: CodeInfo = CodeInfo {
    code: Code::PocketGeometry,
    id: "CH824",
    name: "pocket-geometry",
    severity: Severity::Error,
    summary: "the outline of a pocket cannot be used",
    explanation: r#"The outline of G150 is a closed chain of lines and arcs (G1, G2, G3) in the XY plane that does not cross
itself: at most 40 moves, without macro variables. The first move goes from the start hole to the outline.
The last move ends where the outline began, not at the start hole. The compensation must be on the inside:
G41 with a counter-clockwise outline, G42 with a clockwise one."#,
};

pub(super) const REFUSED: CodeInfo = CodeInfo {
    code: Code::PocketRefused,
    id: "CH825",
    name: "pocket-refused",
    severity: Severity::Error,
    summary: "a pocket cycle where the control does not allow one",
    explanation: r#"Pocket cycles need the XY plane (G17), cutter compensation off before them, and the words
of the cycle: I, or I with K and Q, for G12 and G13; Z, R, Q, one of I and J, and G41 or G42 with D for
G150."#,
};

pub(super) const RIDGES: CodeInfo = CodeInfo {
    code: Code::PocketRidges,
    id: "CH826",
    name: "pocket-ridges",
    severity: Severity::Warning,
    summary: "the stepover leaves material",
    explanation: r#"The passes of the pocket are further apart than the diameter of the tool, or the first circle is so large
that a core stays in the middle. The next move through this material hits it. Choose a stepover below the
diameter, about two thirds of it for a clean floor."#,
};

pub(super) const UNREACHED: CodeInfo = CodeInfo {
    code: Code::PocketUnreached,
    id: "CH827",
    name: "pocket-unreached",
    severity: Severity::Warning,
    summary: "the tool does not reach all of the pocket",
    explanation: r#"The pocket has a neck or an arm narrower than the tool (with its finishing allowance). Only the part with
the start hole is milled. Use a smaller tool, or mill the other parts as separate pockets."#,
};

pub(super) const PATH_ASSUMED: CodeInfo = CodeInfo {
    code: Code::PocketPathAssumed,
    id: "CH828",
    name: "pocket-path-assumed",
    severity: Severity::Note,
    summary: "the exact path of a routine is assumed",
    explanation: r#"The control's manual gives the size, the depth, the start and the end of this routine, but not every move
of it. Chordal shows a path that clears the whole pocket and never leaves it; the control's own order and
stepover may differ, and so may the time."#,
};
