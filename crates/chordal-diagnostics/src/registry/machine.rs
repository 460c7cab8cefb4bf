//! The machine and its offsets.

use super::codes;

codes! {
    TravelExceeded = 601, "travel-exceeded", Error;
    "a move leaves the travel of the machine";
    r#"The end point (or a point of an arc) lies outside the travel of an axis; or, where the work offset is
not known, the program as a whole needs more travel than the axis has."#;

    RapidIntoPart = 602, "rapid-into-part", Warning;
    "a rapid move runs below the clearance plane";
    r#"A rapid goes below the clearance plane into a place that no cut before it has cleared: sideways between two
cuts, down at an angle, or straight down inside the region that is cut next; or it joins two arcs of a contour
without a corner. Often a G0 should have been a G1.
What a cut clears is taken as the box of its moves from one rapid to the next, down to their lowest point; there is
no stock yet. A rapid through what is cleared, or outside of all that the program cuts, is not reported. The
clearance plane is Z0 of the work coordinates unless the machine file's `[program] clearance` says otherwise."#;

    OffsetNotSet = 603, "offset-not-set", Note;
    "the machine file has no value for an offset that the program uses";
    r#"The position of the machine relative to the part is not known, so moves in machine coordinates (G28, G53)
are not drawn and travel is checked only for the program as a whole. Give `[work_offsets.G54]` and
`[tools.1] length` in the machine file or with `--set`."#;

    LengthOffsetOfOtherTool = 604, "length-offset-of-other-tool", Note;
    "the length offset is not that of the tool in the spindle";
    r#"The number of H (or D) is not the number of the tool in the spindle. Where offsets have the numbers of
their tools, this is a mistake; a Haas alarms on it (Setting 15)."#;

    BadSetting = 605, "bad-setting", Error;
    "the control has no such setting, or not with this value";
    r#"`[settings]` of the machine file holds the control's own parameters. The control has no setting of this
name, or the setting cannot have this value. `chordal machines NAME` lists the settings with defaults and
sources."#;

    SpindleOverLimit = 606, "spindle-over-limit", Warning;
    "the spindle speed is above the machine's maximum";
    r#"S is larger than `[spindle] max` of the machine file."#;

    SlowCut = 607, "slow-cut", Warning;
    "a cut takes very long at its feed";
    r#"One block moves at a feed so low that it takes longer than ten minutes. Often F was meant in other units: F1.
is one inch a minute in G20 and one millimetre a minute in G21. Feeds above 20 mm/min (0.8 in/min) are not judged."#;

    AssumedLimits = 608, "assumed-limits", Note;
    "the program exceeds limits of a machine that nobody named";
    r#"No machine was named, so a common one of the control was assumed. The program leaves its travel, or is faster than
its feed or its spindle allow. That says something about the program only if the machine is yours: name your machine
with `--machine`, or describe it in `chordal.toml`. Then every such move is an error of its own."#;

    DiameterNotSet = 609, "diameter-not-set", Note;
    "the machine file has no diameter for an offset that compensates";
    r#"G41 or G42 is active, and the machine file gives no diameter for the offset: compensation has no effect, and the
programmed contour is shown instead of the path of the tool's centre. Give `[tools.1] diameter` in the machine file
or with `--set`."#;

    TipDisplaced = 610, "tip-displaced", Error;
    "the tip of the tool is not at the programmed point";
    r#"The length offset in force is not that of the tool in the spindle, or none is in force, and both lengths are
in the machine file: the tip is at the programmed point plus the length in force minus the length of the tool. Often
G43 or its H is missing, or H is the number of another tool. It is reported at the first cut, or the first rapid that
takes the tip below the clearance plane; the path, the stock and the pictures show the tip where it is."#;

    TipNotKnown = 611, "tip-not-known", Warning;
    "the length of the tool in the spindle is not taken into account";
    r#"No length offset is in force after a change of tools, or the one in force is that of another tool, and the
machine file does not give both lengths: nobody can say where the tip is, and nothing of the path of this tool is
proved. For the only tool of a program without any length it is a note: its path is taken as if Z0 was set with it.
A second length that G44 brings into force after G43, or the other way round, has the other sign. Where the work offset is set anew with each tool, set `tool_lengths` to `touched-off` in `[settings]` of the
machine file."#;

    RadiusOfOtherTool = 612, "radius-of-other-tool", Error;
    "the radius offset is that of another tool";
    r#"D has the number of a tool that the program has used before, and its radius is not that of the tool in the spindle:
the contour is cut too large or too small by the difference. Where the machine file does not give both radii, this is a
warning. Other numbers are the shop's own: `D21` for a second offset of tool 1."#;

    SpeedWithoutLimit = 613, "speed-without-limit", Warning;
    "a cutting speed turns the spindle up to the machine's maximum";
    r#"G96 keeps the cutting speed: the smaller the diameter, the faster the spindle. Towards the centre nothing but the
machine's own maximum stops it, and a chuck with long jaws or a large part may not be made for that. The message says the
diameter from which on the spindle turns at its maximum. Limit it before, with the largest speed that chuck and part allow:

    G50 S2500          Fanuc in G code system A, Haas, Mitsubishi; in systems B and C it is G92 S2500
    G96 S180 M3

On LinuxCNC the limit is D of the block with G96. With a limit that is given nothing is said. Where nobody named the machine, only
cuts up to the centre are reported, because there every machine is at its maximum."#;

    ThreadAtSurfaceSpeed = 614, "thread-at-surface-speed", Warning;
    "a thread is cut while a cutting speed is kept";
    r#"In G96 each pass of a thread has another diameter and so another speed of the spindle. The axis lags behind the spindle by
an amount that depends on the speed, so passes do not meet in one groove, and a taper or a scroll has no even lead. Write G97
with the spindle speed before the thread:

    G97 S800 M3
    G76 P021060 Q100 R100"#;

    DrillingAtSurfaceSpeed = 615, "drilling-at-surface-speed", Warning;
    "a hole in the centre is drilled or tapped while a cutting speed is kept";
    r#"At X0 the cutting speed of G96 asks for a spindle of any speed: it turns at its limit, whatever S says. The drill burns,
and a tap breaks. Write G97 with the spindle speed before the hole:

    G97 S1200 M3
    G0 X0 Z5.
    G74 Z-40. Q12000 F.15"#;

    TurretNearPart = 616, "turret-near-part", Warning;
    "the turret turns inside of what the program cuts";
    r#"T turns the turret while the tip of the tool in work, or of the tool that comes, is nearer to the axis than a cut of the program
at the same Z: it is in the part or in the chips of it. Often the move to the place of the tool change is missing:

    G1 X40. Z-30. F.2
    G0 X200. Z100.     missing
    T0202

The tool that comes is looked at where the machine file gives the offsets of both. Nothing is said where the position is not known,
as after G28 without an offset of the machine file, nor of cuts in another work offset. With `turret_clearance` in the machine
file it is also reported where a tip is nearer than that to what is cut."#;

    ThreadHeight = 617, "thread-height", Warning;
    "the height of a thread does not fit its lead";
    r#"A thread of 60° is about 0.54 (in a bore) to 0.65 times its lead high; the message says how much it is here. On a Fanuc, P and Q
of the second block of G76 count thousandths of a millimetre, or ten thousandths of an inch, and have no decimal point: the height
of M24 x 3 is `P1840`. `P184` is a thread that is not deep enough, and `P18400` one that goes through the wall. It is reported where
the height is over 1.5 times the lead or under 0.13 times (a thread with four starts is 0.135 to 0.153 times its lead high), where it
is more than the radius of the root, where the first pass is deeper than the thread, and where P or Q has a point on a control
that counts increments (setting `point in G76`)."#;

    InternalError = 901, "internal-error", Error;
    "Chordal has a defect";
    r#"This is a defect of Chordal, not of the program. Please report it with the program."#;
}
