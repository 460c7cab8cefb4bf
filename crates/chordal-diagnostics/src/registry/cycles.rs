//! Canned cycles and hole patterns.

use super::codes;

codes! {
    CycleWithoutR = 800, "cycle-without-r", Error;
    "a canned cycle without its R level";
    r#"R is the level where the rapid ends and the feed begins. It stays active from hole to hole, on most
controls until the cycle is cancelled; on LinuxCNC every cycle needs its own R. After G80 it is
cleared. Give it in the block that defines the cycle: `G81 X1. Y1. Z-.5 R.1 F5.`"#;

    CycleWithoutDepth = 801, "cycle-without-depth", Error;
    "a canned cycle without the depth of its holes";
    r#"The depth is the word of the drilling axis: Z, or, on controls that drill square to the plane, Y in G18
and X in G19. It stays active like R. Give it in the block that defines the cycle."#;

    CycleWithoutPeck = 802, "cycle-without-peck", Error;
    "a pecking cycle without a usable Q";
    r#"G73 and G83 go down by Q at a time, measured from R. Without Q, or with a Q of zero, the control has no
depth of a peck; LinuxCNC also refuses a negative Q. Haas and Fadal accept I (first peck), J (reduction of
each further peck) and K (least peck) instead."#;

    CycleWithoutDwell = 803, "cycle-without-dwell", Error;
    "a cycle with a dwell, without P";
    r#"LinuxCNC needs P, the dwell time in seconds, in G82, G86, G88 and G89. Write `P0` for no dwell."#;

    CycleWithoutLead = 804, "cycle-without-lead", Error;
    "a tapping cycle without the lead of the thread";
    r#"In Format 1 a Fadal reads F of a tapping cycle as the spindle speed, and Q as the lead: for 20
threads per inch at 500 rpm write `G84 ... Q.05 F500.` The feed follows from the two."#;

    CycleLevels = 805, "cycle-levels", Error;
    "the levels of a cycle are in the wrong order";
    r#"The order from top to bottom is: initial level (where the tool was when the cycle began), R, depth.
LinuxCNC refuses a depth above R; a Fadal also refuses an R above the initial level. The other controls
run the cycle as programmed, and the tool feeds upwards. Usually a sign is missing: `Z.5` for `Z-.5`. A depth that is
the R level drills nothing, which is a warning."#;

    CycleInCompensation = 806, "cycle-in-compensation", Error;
    "a canned cycle while cutter compensation is on";
    r#"A hole is drilled at the position of the spindle, so compensation must be off. LinuxCNC alarms; the other
controls alarm or drill in the wrong position. Put G40 on the move away from the contour, before the cycle."#;

    NoCycle = 807, "no-cycle", Error;
    "a hole pattern or M45 without an active cycle";
    r#"Haas G70, G71, G72 and Fadal L93 give the positions of holes, and the active cycle drills them. Define
the cycle before; on a Haas usually with L0, so that it does not drill where it is defined:

    G81 Z-1. R.1 F10. L0
    G70 I5. J15. L12"#;

    CycleZeroRepeats = 808, "cycle-zero-repeats", Error;
    "a cycle with a repeat count of zero";
    r#"On LinuxCNC L0 is an error. A Haas moves to the position and does not drill; a Fanuc (K0) and a Mitsubishi
only store the words."#;

    CycleInInverseTime = 809, "cycle-in-inverse-time", Error;
    "a canned cycle while F is inverse time";
    r#"In G93 F is the time of one move, and a cycle makes several moves. Write G94 and a feed per minute."#;

    CycleRotaryWord = 810, "cycle-rotary-word", Error;
    "a rotary axis word in a canned cycle";
    r#"LinuxCNC does not accept A, B or C in a cycle. Turn the axis in a G0 block and start the cycle again."#;

    TooManyPecks = 811, "too-many-pecks", Error;
    "a hole with far too many pecks";
    r#"Ten thousand pecks do not reach the bottom of the hole. On controls that read a number without a decimal
point in least increments, `Q2` is 0.002 mm: write `Q2.`"#;

    CycleNotDocumented = 812, "cycle-not-documented", Warning;
    "no manual was found that says how the control runs this cycle";
    r#"The path shown follows common practice or is assumed. Read the manual of your control, try the cycle above
the part, and change the settings in the machine file so that the path fits."#;

    NoMotionInForce = 813, "no-motion-in-force", Error;
    "axis words without an active motion code";
    r#"On LinuxCNC cycles and motion codes are one group, so no motion code is active after G80. The first move
after it needs its own G0 or G1, in a block of its own:

    G80
    G0 Z1."#;

    CycleSpindle = 814, "cycle-spindle", Error;
    "the spindle does not turn as the cycle requires";
    r#"LinuxCNC taps with a spindle that already turns: clockwise for G84, counter-clockwise for G74; and G86,
which stops it, needs it turning. Other controls start the spindle themselves."#;

    CycleWithoutShift = 815, "cycle-without-shift", Warning;
    "fine or back boring without a shift";
    r#"G76 and G87 stop the spindle at its orientation and shift the tool sideways, so that the tip leaves the
wall. Without Q (or I and J) the tip stays at the wall and marks the bore; in back boring the tool hits
the part."#;

    PatternWords = 816, "pattern-words", Error;
    "a word of a hole pattern is missing";
    r#"G70: I radius, J first angle, L holes. G71: the same with K, the angle between holes. G72: I distance,
J angle of the line, L holes. Angles are degrees from X+, counter-clockwise. The tool must be at
the centre, or at the first hole of a line."#;

    CycleDepthIncremental = 817, "cycle-depth-incremental", Error;
    "the depth of a cycle is given in G91, and the control reads it as absolute";
    r#"A Fadal reads the depth and R0 as absolute levels; define the cycle in G90. G91 may follow for the positions:

    G90 G81 G99 Z-.6 R0+.1 F40. X0 Y0
    G91 X.5 L20"#;

    TapPitch = 818, "tap-pitch", Error;
    "the feed of a tap does not fit its pitch";
    r#"F divided by S, or F itself where it is per revolution, is how far the tap goes in a turn. It differs from the
`pitch` of the tool in the machine file by more than a floating holder takes up (5.5 %): the tap breaks, or the thread is
torn. Often S was changed and F was not, or G94 and G95 are exchanged."#;

    TapWithoutSpeed = 819, "tap-without-speed", Error;
    "a tapping cycle without a spindle speed";
    r#"Nothing has given the spindle a speed before the tap: no S was written, or S0. The feed of a tap is its pitch times the
speed, so it fits no spindle that turns at another speed or not at all: the tap breaks. A control that taps in step with the
spindle alarms. Write S before the cycle. Where the program has neither started the spindle nor changed a tool before, it
may be a part of another program, and this is a warning."#;

    TapExchanged = 840, "tap-exchanged", Warning;
    "a tap whose axes the control exchanges";
    r#"LinuxCNC 2.9 exchanges the coordinates of G84 and G74 twice in G18 and G19. The tool goes to the hole as
programmed, and its feed then goes somewhere else: in G18 to X depth, Y the hole's Z, Z the hole's X. The path is
shown as the control makes it. Tap in G17, or write the tap with G33.1."#;
}
