//! Pocket cycles and fixed routines.

use super::{Code, CodeInfo};
use crate::Severity;

pub(super) const IMPROPER_FIXED_ROUTINE: CodeInfo = CodeInfo {
    code: Code::ImproperFixedRoutine,
    id: "CH820",
    name: "improper-fixed-routine",
    severity: Severity::Error,
    summary: "a rule of the fixed routines is broken",
    explanation: r#"The fixed routines (Fadal L91 to L99) are called with all of their R words in the same block, with a tool
offset in force whose diameter in the table is not zero, with no drilling cycle and no cutter compensation
in force, and never by hand (MDI). R1 of the pockets is the corner radius of the tool: 0 for a square end,
never the radius of the tool itself, which would leave no flat to step over with.

    H3 D3 Z.1 M8
    L9601 R0+40. R1+.01 R2+2.98 R3+1.98"#,
};

pub(super) const TOO_SMALL: CodeInfo = CodeInfo {
    code: Code::PocketTooSmall,
    id: "CH821",
    name: "pocket-too-small",
    severity: Severity::Error,
    summary: "the tool does not go into the pocket",
    explanation: r#"A pocket's size must be above the diameter of the tool, and the radii of a round pocket must grow: tool
radius, then I, then K. Compare the diameter in the offset table with the program's sizes; a radius
entered as a diameter, or the reverse, is the usual cause."#,
};

pub(super) const WITHOUT_DIAMETER: CodeInfo = CodeInfo {
    code: Code::PocketWithoutDiameter,
    id: "CH822",
    name: "pocket-without-diameter",
    severity: Severity::Error,
    summary: "a pocket needs the diameter of the tool, and there is none",
    explanation: r#"Pocket cycles offset by the radius of the tool on their own. They need the D word (or, where H brings the
diameter too, H) and a diameter in the machine file's tool table:

    chordal check pocket.nc --set tools.1.diameter="0.5 in""#,
};

pub(super) const WITHOUT_GEOMETRY: CodeInfo = CodeInfo {
    code: Code::PocketWithoutGeometry,
    id: "CH823",
    name: "pocket-without-geometry",
    severity: Severity::Error,
    summary: "a pocket cycle names no outline, or one that is not there",
    explanation: r#"G150 takes the outline of the pocket from the blocks that P names: those behind an N number of the same
program, or a program with that O number, up to M99."#,
};

pub(super) const GEOMETRY: CodeInfo = CodeInfo {
    code: Code::PocketGeometry,
    id: "CH824",
    name: "pocket-geometry",
    severity: Severity::Error,
    summary: "the outline of a pocket cannot be used",
    explanation: r#"The outline of G150 is a closed chain of lines and arcs (G1, G2, G3) in the XY plane that does not cross
itself: at most 40 moves, without macro variables. The first move goes from the start hole to the outline
and the last one ends where the outline began, not at the start hole. The side of the compensation is the
inside: G41 with a counter-clockwise outline, G42 with a clockwise one."#,
};

pub(super) const REFUSED: CodeInfo = CodeInfo {
    code: Code::PocketRefused,
    id: "CH825",
    name: "pocket-refused",
    severity: Severity::Error,
    summary: "a pocket cycle where the control does not allow one",
    explanation: r#"Pocket cycles work in the XY plane (G17), with cutter compensation off before them, and with the words
that they need: G12 and G13 take I, or I with K and Q; G150 takes Z, R, Q, one of I and J, and G41 or G42
with D."#,
};

pub(super) const RIDGES: CodeInfo = CodeInfo {
    code: Code::PocketRidges,
    id: "CH826",
    name: "pocket-ridges",
    severity: Severity::Warning,
    summary: "the stepover leaves material standing",
    explanation: r#"The passes of the pocket are further apart than the diameter of the tool, or the first circle is so large
that a core stays in the middle. What stays is hit by the next move through it. Choose a stepover below
the diameter, about two thirds of it for a clean floor."#,
};

pub(super) const UNREACHED: CodeInfo = CodeInfo {
    code: Code::PocketUnreached,
    id: "CH827",
    name: "pocket-unreached",
    severity: Severity::Warning,
    summary: "the tool does not reach all of the pocket",
    explanation: r#"The pocket has a throat or an arm narrower than the tool (with its finishing allowance). Only the part in
which the start hole lies is milled. Take a smaller tool, or mill the other parts by pockets of their own."#,
};

pub(super) const PATH_ASSUMED: CodeInfo = CodeInfo {
    code: Code::PocketPathAssumed,
    id: "CH828",
    name: "pocket-path-assumed",
    severity: Severity::Note,
    summary: "the exact path of a routine is a choice",
    explanation: r#"The control's manual gives the size, the depth, the start and the end of this routine, but not every move
of it. Chordal shows a path that clears the pocket wall to wall and never leaves it; the control's own
order and stepover may differ, and with them the time."#,
};
