//! Cutter radius compensation.

use super::codes;

codes! {
    CompensationOnArc = 501, "compensation-on-arc", Error;
    "compensation starts or ends on an arc";
    r#"Cutter radius compensation starts and ends on a straight move, the lead-in and the lead-out.
With G41, G42 or G40 on an arc the control alarms."#;

    CompensationWithoutOffset = 503, "compensation-without-offset", Warning;
    "compensation is on without an offset number";
    r#"G41 or G42 is programmed, and no D word (on a Fadal in Format 1, H) came before it. Nothing says how
far the tool centre must stay away from the contour."#;

    PlaneChangeInCompensation = 504, "plane-change-in-compensation", Error;
    "the plane changes while compensation is on";
    r#"The offset is applied in the plane that was active when compensation started. The control refuses a
change of plane before G40."#;

    CompensationAtEnd = 505, "compensation-at-end", Warning;
    "compensation is still on at the end of the program";
    r#"The program ends with G41 or G42 active. Some controls alarm, others start the next program with compensation on.
Put a G40 on the lead-out."#;

    InsideArcTooSmall = 507, "inside-arc-too-small", Error;
    "an inside arc is smaller than the offset";
    r#"The tool runs inside the arc, and its radius (with wear) is larger than the arc's: it cannot touch the
arc without cutting its neighbours.

    G41 D1 G1 X-40. Y0.          D1 is 5 mm
    G1 X0.
    G3 X4.5 Y4.5 I0. J4.5        inside radius 4.5 mm

Use a smaller tool, or a larger radius. Check the offset, too: a diameter entered where the control
expects a radius doubles it."#;

    CompensationInterference = 508, "compensation-interference", Error;
    "the offset does not fit between two corners";
    r#"Between its two corners the compensated move runs opposite to the programmed one: a groove, a step or
a pocket is narrower than the tool. The control's own look-ahead finds this only between neighbouring
blocks. The block before may already cut too deep.

Controls also alarm for a step lower than the tool radius where nothing would be cut. Use a smaller
tool, or change the contour at this point."#;

    NoOffsetIntersection = 509, "no-offset-intersection", Error;
    "the offset paths of two blocks do not meet";
    r#"At an inside corner the tool goes to the point where the two offset paths cross. Here they do not
cross: an arc next to the corner is too small for the tool, or it begins and ends so that no point is
at the offset distance from both blocks."#;

    LeadInTooShort = 510, "lead-in-too-short", Error;
    "the move that starts compensation is not longer than the offset";
    r#"The control needs a straight lead-in in the plane that is longer than the offset, so that the tool can
move to its side of the contour. Start further away from the contour. On a Haas the block of G41 or G42 must move X or Y;
a block that moves only Z is not a lead-in. The same holds for the lead-out, the move with G40."#;

    SideChangeRefused = 511, "side-change-refused", Error;
    "G41 changes to G42 without G40 between";
    r#"This control does not change the side here. Cancel with G40 on a move away from the contour, then start
compensation again."#;

    CompensationPlane = 512, "compensation-plane", Error;
    "compensation does not work in this plane";
    r#"Some controls compensate in some planes only: LinuxCNC in G17 and G18, Haas arcs in G17. The path is
shown as programmed."#;

    CompensationTwice = 513, "compensation-twice", Error;
    "compensation is turned on and is already on";
    r#"This control refuses G41 or G42 while compensation is on. Cancel with G40 first."#;

    NewOffsetRefused = 514, "new-offset-refused", Error;
    "a new D while compensation is on";
    r#"This control does not accept a new offset here: not while compensation is on, or not on an arc."#;

    LookAheadLost = 515, "look-ahead-lost", Warning;
    "too many blocks without motion between two moves";
    r#"The control looks ahead over few blocks. With more blocks without motion (M8, G4, a comment line with a
number) it does not know how the contour continues, and puts the tool square to the end of the
block before. At an inside corner this cuts into the part by up to the tool radius.

    X0.            the control needs the next move here
    M8
    G4 P500
    Y40.           too late

Put the M and G4 codes elsewhere, or into the block of a move."#;

    SpiralInCompensation = 516, "spiral-in-compensation", Error;
    "a spiral while compensation is on";
    r#"The offset of a spiral is not a spiral. Some controls refuse it. Others (Fanuc) use circles through its
ends and offset the tool along the radius; that is a little nearer to the wall than an offset square to
it. Chordal shows this path on every control."#;

    ShiftInCompensation = 517, "shift-in-compensation", Error;
    "coordinates shift while compensation is on";
    r#"G28, G53, G52, G92 or a work offset comes between G41 or G42 and G40. Controls refuse it, or cancel the
offset for that move. Cancel with G40 first."#;

    InterferenceAvoided = 519, "interference-avoided", Warning;
    "the control skips a block to avoid interference";
    r#"Interference avoidance is on: where a block does not fit, the control skips it and goes to the crossing
of its neighbours. The contour of the skipped block is not cut to size."#;

    FullTurnLost = 520, "full-turn-lost", Warning;
    "a compensated arc of more than a turn is shortened";
    r#"A change of side, or G40 with I J, makes the compensated arc longer than a full turn. This control then
runs the short arc, and a part of the circle stays uncut."#;

    TooManyIdleBlocks = 521, "too-many-idle-blocks", Error;
    "too many commands without motion while compensation is on";
    r#"The next move of a compensated contour must come within a few thousand commands. Compensation continues
as if the contour ended square to the last move."#;

    ReferenceInCompensation = 522, "reference-in-compensation", Error;
    "G28, G30 or G53 while compensation is on";
    r#"Fadal and LinuxCNC refuse a return to the reference point while compensation is on. Fanuc cancels the
offset at the intermediate point and restores it with the next move; the manuals of other controls do not
say what happens. The path is shown as if the move were part of the contour. Cancel with G40 first."#;

    ToolChangeInCompensation = 523, "tool-change-in-compensation", Error;
    "the tool is changed while compensation is on";
    r#"M6 does not cancel compensation: the next tool would run with the offset of the last one, and no move
removes the old offset. Fadal and LinuxCNC stop here. Put G40 on the move away from the contour, before M6."#;

    CutterGouges = 530, "cutter-gouges", Error;
    "the tool cuts into the programmed contour";
    r#"Somewhere on its compensated path the tool centre comes nearer to the contour of the part than the
tool radius, so it removes material that should stay. The message names the depth, the point, the
block that cuts and the block that is cut. The two blocks may be far apart in the program, in a neck or
a slot narrower than the tool; a control looks only a few blocks ahead and often runs such a program
without an alarm.

This is what the geometry says. What the control itself does, alarm or cut, is reported separately: an
alarm without this message is a false alarm, this message without an alarm is the dangerous case.

Use a smaller tool or a smaller offset; `chordal comp-range` gives the largest one and the block that
limits it. Depths under 2 microns, or under twice the least increment, are not reported."#;

    CutterGougesAtLead = 531, "cutter-gouges-at-lead", Warning;
    "the lead-in or lead-out cuts into the end of the contour";
    r#"On the lead-in and the lead-out the tool moves at an angle to the wall and is not yet, or no longer, a
full radius away from it. Within a tool radius of that end of the contour it cuts into the contour.
Programs often begin and end off the part, where this cuts air; then nothing is wrong.

The lead-in is clear of the first wall if its start lies at least a tool radius away from that wall, on
the tool's side, measured square to it. A lead-in along the line of the wall always cuts a little:
0.15 mm with a radius of 5 mm and a lead-in of 20 mm. Start further to the side, or lead in with an arc."#;

    SideAmbiguous = 532, "side-ambiguous", Note;
    "a contour is run in both directions, so neither side of it is the part";
    r#"Two blocks run along the same line or arc in opposite directions with compensation on the same side.
The tool passes on both sides of it, as in a slot programmed along its centre line, and nothing says on
which side the material should stay. The check for gouges takes the curve itself as the limit on both
sides."#;

    GougeSearchLimit = 533, "gouge-search-limit", Warning;
    "not all of the contour was checked for gouges";
    r#"The contour turns back on itself so often within a tool radius that the check stopped at its limit of
comparisons. The gouges that it reported are real; there may be more. Check the contour in parts, or with a
smaller tool."#;

    CompensationSideDoubtful = 534, "compensation-side-doubtful", Warning;
    "the tool comes from one side of the contour and runs on the other";
    r#"The lead-in begins on one side of the first wall, the lead-out ends on the same side of the last one, and
G41 or G42 puts the tool on the other side. The tool has to cross the contour twice: probably the other
code was meant, or an offset with the other sign.

    G18
    Z-.56 G41 G1              comes down from above the profile
    X1.6315 Z.942             G41 is below it here: G42 is meant

In G18 the side is as seen from +Y, where +X points up and +Z to the right."#;

    ContourNotChecked = 535, "contour-not-checked", Warning;
    "a contour is too long to be checked completely";
    r#"The check for gouges keeps the whole contour from G41 or G42 to G40, up to a few million blocks. The
blocks after that are run but not checked. End the contour with G40 earlier."#;

    FalseInterferenceAlarm = 536, "false-interference-alarm", Note;
    "the control alarms for interference where no wall would be cut";
    r#"Controls decide on interference from a few neighbouring blocks: a move that would run backwards, an arc
that becomes longer. A step or a groove lower than the tool radius can cause this although the tool
would touch no wall, and so can rounded coordinates (LinuxCNC allows an arc in inch programs 0.001 rad).

The alarm remains: the control does not run the program. This note says that the contour itself is
right, so that a smaller offset, a larger radius or changed coordinates are enough."#;
}
