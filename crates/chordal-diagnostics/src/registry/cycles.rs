//! Canned cycles and patterns of holes.

use super::{Code, CodeInfo};
use crate::Severity;

pub(super) const WITHOUT_R: CodeInfo = CodeInfo {
    code: Code::CycleWithoutR,
    id: "CH800",
    name: "cycle-without-r",
    severity: Severity::Error,
    summary: "a canned cycle without its R level",
    explanation: r#"R is the level where the rapid ends and the feed begins. It stays active from hole to hole, on most
controls until the cycle is cancelled; on LinuxCNC every cycle needs its own R. After G80 it is
cleared. Give it in the block that defines the cycle: `G81 X1. Y1. Z-.5 R.1 F5.`"#,
};

pub(super) const WITHOUT_DEPTH: CodeInfo = CodeInfo {
    code: Code::CycleWithoutDepth,
    id: "CH801",
    name: "cycle-without-depth",
    severity: Severity::Error,
    summary: "a canned cycle without the depth of its holes",
    explanation: r#"The depth is the word of the drilling axis: Z, or, on controls that drill square to the plane, Y in G18
and X in G19. It stays active like R. Give it in the block that defines the cycle."#,
};

pub(super) const WITHOUT_PECK: CodeInfo = CodeInfo {
    code: Code::CycleWithoutPeck,
    id: "CH802",
    name: "cycle-without-peck",
    severity: Severity::Error,
    summary: "a pecking cycle without a usable Q",
    explanation: r#"G73 and G83 go down by Q at a time, measured from R. Without Q, or with a Q of zero, the control has no
depth of a peck; LinuxCNC also refuses a negative Q. Haas and Fadal accept I (first peck), J (reduction of
each further peck) and K (least peck) instead."#,
};

pub(super) const WITHOUT_DWELL: CodeInfo = CodeInfo {
    code: Code::CycleWithoutDwell,
    id: "CH803",
    name: "cycle-without-dwell",
    severity: Severity::Error,
    summary: "a cycle with a dwell, without P",
    explanation: r#"LinuxCNC needs P, the dwell time in seconds, in G82, G86, G88 and G89. Write `P0` for no dwell."#,
};

pub(super) const WITHOUT_LEAD: CodeInfo = CodeInfo {
    code: Code::CycleWithoutLead,
    id: "CH804",
    name: "cycle-without-lead",
    severity: Severity::Error,
    summary: "a tapping cycle without the lead of the thread",
    explanation: r#"In Format 1 a Fadal reads F of a tapping cycle as the spindle speed, and Q as the lead: for 20
threads per inch at 500 rpm write `G84 ... Q.05 F500.` The feed follows from the two."#,
};

pub(super) const LEVELS: CodeInfo = CodeInfo {
    code: Code::CycleLevels,
    id: "CH805",
    name: "cycle-levels",
    severity: Severity::Error,
    summary: "the levels of a cycle are in the wrong order",
    explanation: r#"The order from top to bottom is: initial level (where the tool was when the cycle began), R, depth.
LinuxCNC refuses a depth above R; a Fadal also refuses an R above the initial level. The other controls
run the cycle as programmed, and the tool feeds upwards. Usually a sign is missing: `Z.5` for `Z-.5`."#,
};

pub(super) const IN_COMPENSATION: CodeInfo = CodeInfo {
    code: Code::CycleInCompensation,
    id: "CH806",
    name: "cycle-in-compensation",
    severity: Severity::Error,
    summary: "a canned cycle while cutter compensation is on",
    explanation: r#"A hole is drilled at the position of the spindle, so compensation must be off. LinuxCNC alarms; the other
controls alarm or drill in the wrong position. Put G40 on the move away from the contour, before the cycle."#,
};

pub(super) const NO_CYCLE: CodeInfo = CodeInfo {
    code: Code::NoCycle,
    id: "CH807",
    name: "no-cycle",
    severity: Severity::Error,
    summary: "a hole pattern or M45 without an active cycle",
    explanation: r#"Haas G70, G71, G72 and Fadal L93 give the positions of holes, and the active cycle drills them. Define
the cycle before; on a Haas usually with L0, so that it does not drill where it is defined:

    G81 Z-1. R.1 F10. L0
    G70 I5. J15. L12"#,
};

pub(super) const ZERO_REPEATS: CodeInfo = CodeInfo {
    code: Code::CycleZeroRepeats,
    id: "CH808",
    name: "cycle-zero-repeats",
    severity: Severity::Error,
    summary: "a cycle with a repeat count of zero",
    explanation: r#"On LinuxCNC L0 is an error. A Haas moves to the position and does not drill; a Fanuc (K0) and a Mitsubishi
only store the words."#,
};

pub(super) const IN_INVERSE_TIME: CodeInfo = CodeInfo {
    code: Code::CycleInInverseTime,
    id: "CH809",
    name: "cycle-in-inverse-time",
    severity: Severity::Error,
    summary: "a canned cycle while F is inverse time",
    explanation: r#"In G93 F is the time of one move, and a cycle makes several moves. Write G94 and a feed per minute."#,
};

pub(super) const ROTARY_WORD: CodeInfo = CodeInfo {
    code: Code::CycleRotaryWord,
    id: "CH810",
    name: "cycle-rotary-word",
    severity: Severity::Error,
    summary: "a rotary axis word in a canned cycle",
    explanation: r#"LinuxCNC does not accept A, B or C in a cycle. Turn the axis in a G0 block and start the cycle again."#,
};

pub(super) const TOO_MANY_PECKS: CodeInfo = CodeInfo {
    code: Code::TooManyPecks,
    id: "CH811",
    name: "too-many-pecks",
    severity: Severity::Error,
    summary: "a hole with far too many pecks",
    explanation: r#"Ten thousand pecks do not reach the bottom of the hole. On controls that read a number without a decimal
point in least increments, `Q2` is 0.002 mm: write `Q2.`"#,
};

pub(super) const NOT_DOCUMENTED: CodeInfo = CodeInfo {
    code: Code::CycleNotDocumented,
    id: "CH812",
    name: "cycle-not-documented",
    severity: Severity::Warning,
    summary: "no manual was found that says how the control runs this cycle",
    explanation: r#"The path shown follows common practice or what is likely. Look into the manual of your control, try the
cycle above the part, and change the settings in the machine file so that the path fits."#,
};

pub(super) const NO_MOTION: CodeInfo = CodeInfo {
    code: Code::NoMotionInForce,
    id: "CH813",
    name: "no-motion-in-force",
    severity: Severity::Error,
    summary: "axis words without an active motion code",
    explanation: r#"On LinuxCNC cycles and motion codes are one group, so no motion code is active after G80. The first move
after it needs its own G0 or G1, in a block of its own:

    G80
    G0 Z1."#,
};

pub(super) const SPINDLE: CodeInfo = CodeInfo {
    code: Code::CycleSpindle,
    id: "CH814",
    name: "cycle-spindle",
    severity: Severity::Error,
    summary: "the spindle does not turn as the cycle requires",
    explanation: r#"LinuxCNC taps with a spindle that already turns: clockwise for G84, counter-clockwise for G74; and G86,
which stops it, needs it turning. Other controls start the spindle themselves."#,
};

pub(super) const WITHOUT_SHIFT: CodeInfo = CodeInfo {
    code: Code::CycleWithoutShift,
    id: "CH815",
    name: "cycle-without-shift",
    severity: Severity::Warning,
    summary: "fine or back boring without a shift",
    explanation: r#"G76 and G87 stop the spindle at its orientation and shift the tool sideways, so that the tip leaves the
wall. Without Q (or I and J) the tip stays at the wall and marks the bore; in back boring the tool hits
the part."#,
};

pub(super) const PATTERN_WORDS: CodeInfo = CodeInfo {
    code: Code::PatternWords,
    id: "CH816",
    name: "pattern-words",
    severity: Severity::Error,
    summary: "a word of a hole pattern is missing",
    explanation: r#"G70: I radius, J first angle, L holes. G71: the same with K, the angle between holes. G72: I distance,
J angle of the line, L holes. Angles are degrees from X+, counter-clockwise. The tool must be at
the centre, or at the first hole of a line."#,
};

pub(super) const DEPTH_INCREMENTAL: CodeInfo = CodeInfo {
    code: Code::CycleDepthIncremental,
    id: "CH817",
    name: "cycle-depth-incremental",
    severity: Severity::Error,
    summary: "the depth of a cycle is given in G91, and the control reads it as absolute",
    explanation: r#"A Fadal reads the depth and R0 as absolute levels; define the cycle in G90. G91 may follow for the positions:

    G90 G81 G99 Z-.6 R0+.1 F40. X0 Y0
    G91 X.5 L20"#,
};
