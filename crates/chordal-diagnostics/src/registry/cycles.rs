//! Canned cycles and patterns of holes.

use super::{Code, CodeInfo};
use crate::Severity;

pub(super) const WITHOUT_R: CodeInfo = CodeInfo {
    code: Code::CycleWithoutR,
    id: "CH800",
    name: "cycle-without-r",
    severity: Severity::Error,
    summary: "a canned cycle without its R level",
    explanation: r#"R is the level where the rapid ends and the feed begins. It stays in force from hole to hole, on most
controls until the cycle is cancelled; on LinuxCNC another cycle needs its own. After G80 it is
forgotten. Give it in the block that defines the cycle: `G81 X1. Y1. Z-.5 R.1 F5.`"#,
};

pub(super) const WITHOUT_DEPTH: CodeInfo = CodeInfo {
    code: Code::CycleWithoutDepth,
    id: "CH801",
    name: "cycle-without-depth",
    severity: Severity::Error,
    summary: "a canned cycle without the depth of its holes",
    explanation: r#"The depth is the word of the drilling axis: Z, or on controls that drill along the normal of the plane Y
in G18 and X in G19. It stays in force like R. Give it in the block that defines the cycle."#,
};

pub(super) const WITHOUT_PECK: CodeInfo = CodeInfo {
    code: Code::CycleWithoutPeck,
    id: "CH802",
    name: "cycle-without-peck",
    severity: Severity::Error,
    summary: "a pecking cycle without a usable Q",
    explanation: r#"G73 and G83 go down by Q at a time, measured from R. Without Q, or with a Q of zero, the control does not
know how; LinuxCNC also refuses a negative one. Haas and Fadal take I (first peck), J (how much less
each time) and K (least peck) instead."#,
};

pub(super) const WITHOUT_DWELL: CodeInfo = CodeInfo {
    code: Code::CycleWithoutDwell,
    id: "CH803",
    name: "cycle-without-dwell",
    severity: Severity::Error,
    summary: "a cycle that dwells, without P",
    explanation: r#"LinuxCNC wants the time of the dwell with P, in seconds, in G82, G86, G88 and G89. Write `P0` for none."#,
};

pub(super) const WITHOUT_LEAD: CodeInfo = CodeInfo {
    code: Code::CycleWithoutLead,
    id: "CH804",
    name: "cycle-without-lead",
    severity: Severity::Error,
    summary: "a tapping cycle without the lead of the thread",
    explanation: r#"In Format 1 a Fadal reads F of a tapping cycle as the speed of the spindle, and Q as the lead: for 20
threads per inch at 500 rpm write `G84 ... Q.05 F500.` The feed follows from the two."#,
};

pub(super) const LEVELS: CodeInfo = CodeInfo {
    code: Code::CycleLevels,
    id: "CH805",
    name: "cycle-levels",
    severity: Severity::Error,
    summary: "the levels of a cycle are in the wrong order",
    explanation: r#"From top to bottom come the initial level (where the tool stood when the cycle began), R, and the depth.
LinuxCNC refuses a depth above R, a Fadal an R above the initial level too. The other controls do as
they are told, and the tool feeds upwards. Mostly a sign is missing: `Z.5` for `Z-.5`."#,
};

pub(super) const IN_COMPENSATION: CodeInfo = CodeInfo {
    code: Code::CycleInCompensation,
    id: "CH806",
    name: "cycle-in-compensation",
    severity: Severity::Error,
    summary: "a canned cycle while cutter compensation is on",
    explanation: r#"Holes are drilled where the spindle is, so compensation must be off. LinuxCNC says so; the other controls
alarm or drill beside the hole. Put G40 on the move away from the contour, before the cycle."#,
};

pub(super) const NO_CYCLE: CodeInfo = CodeInfo {
    code: Code::NoCycle,
    id: "CH807",
    name: "no-cycle",
    severity: Severity::Error,
    summary: "a pattern or M45, and no cycle is in force",
    explanation: r#"Haas G70, G71, G72 and Fadal L93 place holes, and the cycle in force says what a hole is. Define it
before, on a Haas usually with L0 so that it does not drill where it is defined:

    G81 Z-1. R.1 F10. L0
    G70 I5. J15. L12"#,
};

pub(super) const ZERO_REPEATS: CodeInfo = CodeInfo {
    code: Code::CycleZeroRepeats,
    id: "CH808",
    name: "cycle-zero-repeats",
    severity: Severity::Error,
    summary: "a cycle with a repeat count of zero",
    explanation: r#"On LinuxCNC L0 is an error. On a Haas it goes to the place without a hole, on a Fanuc (K0) and a
Mitsubishi it only stores the words."#,
};

pub(super) const IN_INVERSE_TIME: CodeInfo = CodeInfo {
    code: Code::CycleInInverseTime,
    id: "CH809",
    name: "cycle-in-inverse-time",
    severity: Severity::Error,
    summary: "a canned cycle while F is inverse time",
    explanation: r#"In G93 F belongs to one block, and a cycle makes several moves of one. Write G94 and a feed per minute."#,
};

pub(super) const ROTARY_WORD: CodeInfo = CodeInfo {
    code: Code::CycleRotaryWord,
    id: "CH810",
    name: "cycle-rotary-word",
    severity: Severity::Error,
    summary: "a rotary axis word in a canned cycle",
    explanation: r#"LinuxCNC takes no A, B or C in a cycle. Turn the axis in a G0 block and begin the cycle again."#,
};

pub(super) const TOO_MANY_PECKS: CodeInfo = CodeInfo {
    code: Code::TooManyPecks,
    id: "CH811",
    name: "too-many-pecks",
    severity: Severity::Error,
    summary: "a hole with more pecks than anybody wants",
    explanation: r#"Ten thousand pecks do not get to the bottom of the hole. Where a number without a decimal point counts
least increments, `Q2` is 0.002 mm: write `Q2.`"#,
};

pub(super) const NOT_DOCUMENTED: CodeInfo = CodeInfo {
    code: Code::CycleNotDocumented,
    id: "CH812",
    name: "cycle-not-documented",
    severity: Severity::Warning,
    summary: "what the control makes of this cycle was not found in a manual",
    explanation: r#"The path shown follows what the trade says or what is likely. Look into the manual of your control, try it
above the part, and set the machine file's settings so that the path fits."#,
};

pub(super) const NO_MOTION: CodeInfo = CodeInfo {
    code: Code::NoMotionInForce,
    id: "CH813",
    name: "no-motion-in-force",
    severity: Severity::Error,
    summary: "axis words, and no motion code is in force",
    explanation: r#"On LinuxCNC cycles and motion codes are one group, so that G80 leaves no motion in force. The first move
after it needs its own G0 or G1, in a block of its own:

    G80
    G0 Z1."#,
};

pub(super) const SPINDLE: CodeInfo = CodeInfo {
    code: Code::CycleSpindle,
    id: "CH814",
    name: "cycle-spindle",
    severity: Severity::Error,
    summary: "the spindle does not turn as the cycle needs it",
    explanation: r#"LinuxCNC taps with a spindle that already turns: clockwise for G84, counter-clockwise for G74; and G86,
which stops it, needs it turning. Other controls start the spindle themselves."#,
};

pub(super) const WITHOUT_SHIFT: CodeInfo = CodeInfo {
    code: Code::CycleWithoutShift,
    id: "CH815",
    name: "cycle-without-shift",
    severity: Severity::Warning,
    summary: "fine or back boring without a shift",
    explanation: r#"G76 and G87 stop the spindle at its mark and step aside, so that the tip leaves the wall. Without Q (or I
and J) it does not, and marks the bore; in back boring it hits the part."#,
};

pub(super) const PATTERN_WORDS: CodeInfo = CodeInfo {
    code: Code::PatternWords,
    id: "CH816",
    name: "pattern-words",
    severity: Severity::Error,
    summary: "a pattern of holes lacks a word",
    explanation: r#"G70: I radius, J first angle, L holes. G71: the same with K, the angle between holes. G72: I distance,
J angle of the line, L holes. Angles are degrees from X+, counter-clockwise. The tool must stand in
the centre, or at the first hole of a line."#,
};

pub(super) const DEPTH_INCREMENTAL: CodeInfo = CodeInfo {
    code: Code::CycleDepthIncremental,
    id: "CH817",
    name: "cycle-depth-incremental",
    severity: Severity::Error,
    summary: "the depth of a cycle is given in G91 on a control that wants it absolute",
    explanation: r#"A Fadal reads the depth and R0 as absolute levels; define the cycle in G90. G91 may follow for the places:

    G90 G81 G99 Z-.6 R0+.1 F40. X0 Y0
    G91 X.5 L20"#,
};
