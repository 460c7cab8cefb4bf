//! Codes and words.

use super::{Code, CodeInfo};
use crate::Severity;

pub(super) const UNKNOWN_CODE: CodeInfo = CodeInfo {
    code: Code::UnknownCode,
    id: "CH301",
    name: "unknown-code",
    severity: Severity::Error,
    summary: "this control has no such code",
    explanation: r#"The G or M code is not in the table of this control. Perhaps the program was written for another
one: `chordal explain G154 --machine haas-vf2` says what a code does on each control, and
`chordal machines` lists the controls."#,
};

pub(super) const SAME_GROUP: CodeInfo = CodeInfo {
    code: Code::SameGroup,
    id: "CH302",
    name: "same-group",
    severity: Severity::Error,
    summary: "two codes of one modal group in a block",
    explanation: r#"Codes of one group exclude each other: a block cannot be G0 and G1 at once. Some controls alarm,
others use the last one. (On a Fadal a block may have both G90 and G91; they act from left to right.)"#,
};

pub(super) const BAD_WORD_VALUE: CodeInfo = CodeInfo {
    code: Code::BadWordValue,
    id: "CH303",
    name: "bad-word-value",
    severity: Severity::Error,
    summary: "a word has a value that it cannot have here",
    explanation: r#"The letter is right and the number is not: decimals where a whole number is needed, a negative count,
a number that is not in the table."#,
};

pub(super) const UNUSED_WORD: CodeInfo = CodeInfo {
    code: Code::UnusedWord,
    id: "CH304",
    name: "unused-word",
    severity: Severity::Warning,
    summary: "a word has no effect in this block",
    explanation: r#"Nothing in the block uses the word. The control ignores it or alarms; in either case it does not do
what was meant."#,
};

pub(super) const MISSING_DECIMAL_POINT: CodeInfo = CodeInfo {
    code: Code::MissingDecimalPoint,
    id: "CH305",
    name: "missing-decimal-point",
    severity: Severity::Warning,
    summary: "a number without a decimal point is read in least increments",
    explanation: r#"On this control `X3` is not three inches but three least increments: 0.0003 in, or 0.003 mm. With a
point (`X3.`) it is three inches. In a program that otherwise writes points, a missing one is nearly
always a mistake, and a dangerous one."#,
};

pub(super) const NOT_SIMULATED: CodeInfo = CodeInfo {
    code: Code::NotSimulated,
    id: "CH306",
    name: "not-simulated",
    severity: Severity::Note,
    summary: "the code is known, and what it does is not simulated",
    explanation: r#"The control carries the code out. Chordal does not, and reports it, so that you know what is missing
from the path and the time."#,
};

pub(super) const NOT_ALONE: CodeInfo = CodeInfo {
    code: Code::NotAlone,
    id: "CH307",
    name: "not-alone",
    severity: Severity::Error,
    summary: "the code must be the only one of its kind in the block",
    explanation: r#"Some codes must not be in one block with others of the same letter: on a Fadal G92 and G53 must be
the only G code of their block."#,
};

pub(super) const MISSING_WORD: CodeInfo = CodeInfo {
    code: Code::MissingWord,
    id: "CH308",
    name: "missing-word",
    severity: Severity::Error,
    summary: "the code needs a word that is missing",
    explanation: r#"A code such as M98 needs its P, a dwell its time, a tool change its T. Without it the control alarms."#,
};

pub(super) const NO_SUCH_AXIS: CodeInfo = CodeInfo {
    code: Code::NoSuchAxis,
    id: "CH309",
    name: "no-such-axis",
    severity: Severity::Error,
    summary: "the machine has no such axis",
    explanation: r#"The block moves an axis that the machine file does not have. Add the axis to the machine file, or
choose the machine with `--machine`."#,
};

pub(super) const EXCESS_DECIMALS: CodeInfo = CodeInfo {
    code: Code::ExcessDecimals,
    id: "CH310",
    name: "excess-decimals",
    severity: Severity::Note,
    summary: "a length has more decimals than the control uses",
    explanation: r#"A control counts in least increments: 0.0001 in, 0.001 mm. Decimals beyond that are cut off or rounded, so
the axis does not go exactly where the text says. In G91 the differences add up. The setting
`excess_decimals` says what a control does. Reported once for a program."#,
};

pub(super) const TOO_MANY_DIGITS: CodeInfo = CodeInfo {
    code: Code::TooManyDigits,
    id: "CH311",
    name: "too-many-digits",
    severity: Severity::Error,
    summary: "a number has more digits than the control accepts",
    explanation: r#"A Fanuc-style control accepts eight digits in a number. With more it alarms, even if all of
them are decimals.

    X1.23456789              nine digits: PS0003 on a Fanuc"#,
};
