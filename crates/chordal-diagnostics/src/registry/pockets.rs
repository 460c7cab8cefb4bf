//! Pocket cycles and fixed routines.

use super::codes;

codes! {
    ImproperFixedRoutine = 820, "improper-fixed-routine", Error;
    "a rule of the fixed routines is broken";
    r#"The fixed routines (Fadal L91 to L99) need all of their R words in the same block, an active tool offset
with a diameter above zero in the table, no active drilling cycle and no active cutter compensation. They
cannot be called in MDI. R1 of the pockets is the corner radius of the tool: 0 for a square end mill. It is
never the full radius of the tool: such a tool has no flat end to clear the floor.

    H3 D3 Z.1 M8
    L9601 R0+40. R1+.01 R2+2.98 R3+1.98"#;

    PocketTooSmall = 821, "pocket-too-small", Error;
    "the tool does not fit into the pocket";
    r#"A pocket must be larger than the diameter of the tool, and the radii of a round pocket must increase: tool
radius, then I, then K. Compare the diameter in the offset table with the sizes in the program. The usual
cause is a radius entered as a diameter, or the reverse."#;

    PocketWithoutDiameter = 822, "pocket-without-diameter", Error;
    "a pocket needs the diameter of the tool, and none is given";
    r#"Pocket cycles offset by the tool radius themselves. They need the D word (or, where H also gives the
diameter, H) and a diameter in the machine file's tool table:

    chordal check pocket.nc --set tools.1.diameter="0.5 in""#;

    PocketWithoutGeometry = 823, "pocket-without-geometry", Error;
    "the outline of a pocket cycle is missing";
    r#"G150 takes the outline of the pocket from the blocks that P names: those after an N number of the same
program, or a program with that O number, up to M99."#;

    PocketGeometry = 824, "pocket-geometry", Error;
    "the outline of a pocket cannot be used";
    r#"The outline of G150 is a closed chain of lines and arcs (G1, G2, G3) in the XY plane that does not cross
itself: at most 40 moves, without macro variables. The first move goes from the start hole to the outline.
The last move ends where the outline began, not at the start hole. The compensation must be on the inside:
G41 with a counter-clockwise outline, G42 with a clockwise one."#;

    PocketRefused = 825, "pocket-refused", Error;
    "a pocket cycle where the control does not allow one";
    r#"Pocket cycles need the XY plane (G17), cutter compensation off before them, and the words
of the cycle: I, or I with K and Q, for G12 and G13; Z, R, Q, one of I and J, and G41 or G42 with D for
G150."#;

    PocketRidges = 826, "pocket-ridges", Warning;
    "the stepover leaves material";
    r#"The passes of the pocket are further apart than the diameter of the tool, or the first circle is so large
that a core stays in the middle. The next move through this material hits it. Choose a stepover below the
diameter, about two thirds of it for a clean floor."#;

    PocketUnreached = 827, "pocket-unreached", Warning;
    "the tool does not reach all of the pocket";
    r#"The pocket has a neck or an arm narrower than the tool (with its finishing allowance). Only the part with
the start hole is milled. Use a smaller tool, or mill the other parts as separate pockets."#;

    PocketPathAssumed = 828, "pocket-path-assumed", Note;
    "the exact path of a routine is assumed";
    r#"The control's manual gives the size, the depth, the start and the end of this routine, but not every move
of it. Chordal shows a path that clears the whole pocket and never leaves it; the control's own order and
stepover may differ, and so may the time."#;

    CyclePathAssumed = 829, "cycle-path-assumed", Note;
    "the order of the cuts of a cycle is assumed";
    r#"The control's manual gives the shape, the depth, the infeeds, the start and the end of this cycle, but not every
move of it. Chordal clears the shape in loops from the inside out, or in rows. The control's own order of the cuts
may differ, the shape and what comes after the cycle do not. Time and load of the tool are those of the assumed
path: the time is not verified from this line on, and no proof that two programs move alike holds over it.

    POCKET3(10,0,2,-15,60,40,8,0,0,0,4,0.2,0.1,500,150,0,11,5)"#;
}
