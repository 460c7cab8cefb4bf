//! Macro programs: expressions, variables, statements, calls, output.

use super::{Code, CodeInfo};
use crate::Severity;

pub(super) const BAD_EXPRESSION: CodeInfo = CodeInfo {
    code: Code::BadExpression,
    id: "CH700",
    name: "bad-expression",
    severity: Severity::Error,
    summary: "an expression cannot be read",
    explanation: r#"A value is a number, a variable (`#101`), a function (`SIN[30.]`) or a bracket. Values are joined by
`+ - * / MOD AND OR XOR EQ NE GT GE LT LE`. What cannot be read is marked; the word or the assignment it
belongs to is left out. On Fanuc, Haas, Mitsubishi and LinuxCNC brackets of expressions are `[ ]`, since
`( )` is a comment; on a Fadal they are `( )`."#,
};

pub(super) const UNBALANCED_BRACKETS: CodeInfo = CodeInfo {
    code: Code::UnbalancedBrackets,
    id: "CH701",
    name: "unbalanced-brackets",
    severity: Severity::Error,
    summary: "a bracket of an expression is not closed",
    explanation: r#"Every `[` needs its `]` on the same line. In a long formula count up by one at each `[` and down by one at
each `]`: the count must end at zero and never be below it."#,
};

pub(super) const BRACKETS_TOO_DEEP: CodeInfo = CodeInfo {
    code: Code::BracketsTooDeep,
    id: "CH702",
    name: "brackets-too-deep",
    severity: Severity::Error,
    summary: "brackets are nested deeper than the control reads",
    explanation: r#"Fanuc and Mitsubishi read five levels of brackets; those of functions and of the condition of IF or WHILE
count as well. Compute a part of the formula first and store it in a variable."#,
};

pub(super) const UNSUPPORTED_MACRO: CodeInfo = CodeInfo {
    code: Code::UnsupportedMacro,
    id: "CH703",
    name: "unsupported-macro",
    severity: Severity::Error,
    summary: "a macro form that this control does not have",
    explanation: r#"Macro languages differ in their functions and forms: FUP is not on a Haas, `##1` only on LinuxCNC, `AX[…]`
and `SETVN` only on newer Fanucs. The form is skipped, and values that depend on it are not known."#,
};

pub(super) const BAD_STATEMENT: CodeInfo = CodeInfo {
    code: Code::BadStatement,
    id: "CH704",
    name: "bad-statement",
    severity: Severity::Error,
    summary: "a macro statement cannot be read",
    explanation: r#"The macro statements of Fanuc, Haas and Mitsubishi are the assignment `#1=…`, `IF[…]GOTO n`,
`IF[…]THEN …`, `GOTO n`, `WHILE[…]DO n` with `END n`, and the output statements POPEN, DPRNT, BPRNT and
PCLOS. `IF … ENDIF` over several lines is not one of them. The statement is skipped."#,
};

pub(super) const BAD_VARIABLE: CodeInfo = CodeInfo {
    code: Code::BadVariable,
    id: "CH705",
    name: "bad-variable",
    severity: Severity::Error,
    summary: "there is no variable of that number",
    explanation: r#"The control defines the numbers of variables: local ones 1–33, common ones such as 100–199 and 500–999
(on a Haas NGC also 10000–10999), and system variables. A computed number must be whole; the message shows
the value. Reading gives null (or zero on controls without null); writing is skipped."#,
};

pub(super) const READ_ONLY_VARIABLE: CodeInfo = CodeInfo {
    code: Code::ReadOnlyVariable,
    id: "CH706",
    name: "read-only-variable",
    severity: Severity::Error,
    summary: "this variable cannot be written",
    explanation: r#"Null (#0), positions, modal codes and inputs are read-only. The assignment is skipped."#,
};

pub(super) const DIVISION_BY_ZERO: CodeInfo = CodeInfo {
    code: Code::DivisionByZero,
    id: "CH707",
    name: "division-by-zero",
    severity: Severity::Error,
    summary: "a division by zero",
    explanation: r#"The divisor is zero, or a variable that was never set: null counts as zero in arithmetic. The word or
the assignment is skipped; the control stops with an alarm."#,
};

pub(super) const OUTSIDE_DOMAIN: CodeInfo = CodeInfo {
    code: Code::OutsideDomain,
    id: "CH708",
    name: "outside-domain",
    severity: Severity::Error,
    summary: "a function has no value for its argument",
    explanation: r#"The root of a negative number, the logarithm of zero, ASIN or ACOS beyond 1, the tangent of 90°. The
message shows the argument. The usual cause is a value that should be 1 and is 1.0000000001; limit it with
IF before the function."#,
};

pub(super) const NUMBER_OVERFLOW: CodeInfo = CodeInfo {
    code: Code::NumberOverflow,
    id: "CH709",
    name: "number-overflow",
    severity: Severity::Error,
    summary: "a value is too large",
    explanation: r#"A result is larger than the control can hold, or larger than its address accepts."#,
};

pub(super) const CONDITION_AS_VALUE: CodeInfo = CodeInfo {
    code: Code::ConditionAsValue,
    id: "CH710",
    name: "condition-as-value",
    severity: Severity::Error,
    summary: "a comparison is used where a number is needed",
    explanation: r#"On a Fanuc and a Mitsubishi a comparison (EQ, NE, GT, GE, LT, LE) belongs in the condition of IF or WHILE and
cannot be assigned. A Haas gives 1. or 0."#,
};

pub(super) const BAD_LOOP_NUMBER: CodeInfo = CodeInfo {
    code: Code::BadLoopNumber,
    id: "CH711",
    name: "bad-loop-number",
    severity: Severity::Error,
    summary: "the number of DO or END is not allowed",
    explanation: r#"DO and END take 1, 2 or 3 (1 to 127 on a Mitsubishi). A number may be used again once its loop is over, and
again in a called program, but not inside the loop itself."#,
};

pub(super) const LOOP_MISMATCH: CodeInfo = CodeInfo {
    code: Code::LoopMismatch,
    id: "CH712",
    name: "loop-mismatch",
    severity: Severity::Error,
    summary: "DO and END do not belong together",
    explanation: r#"Each `DOn` needs an `ENDn` further down in the same program. Loops must not cross. A GOTO may leave a loop
but not enter one. An END without its DO is skipped; a DO without its END ends the run."#,
};

pub(super) const MACRO_NESTING: CodeInfo = CodeInfo {
    code: Code::MacroNesting,
    id: "CH713",
    name: "macro-nesting",
    severity: Severity::Error,
    summary: "macro calls are nested deeper than the control allows",
    explanation: r#"G65, G66 and codes that call macros may be nested four levels deep (five on newer Fanucs, nine on a Haas).
The call is not made."#,
};

pub(super) const BAD_ARGUMENT: CodeInfo = CodeInfo {
    code: Code::BadArgument,
    id: "CH714",
    name: "bad-argument",
    severity: Severity::Error,
    summary: "a word cannot be an argument of a macro call",
    explanation: r#"G65 and G66 pass their words to the macro as #1 to #26, except G, L, N, O and P, which belong to the call
itself. A to Z (type I) and the sets of I, J, K (type II) may be mixed; of two values for the same
variable the later one is used."#,
};

pub(super) const MIXED_BLOCK: CodeInfo = CodeInfo {
    code: Code::MixedBlock,
    id: "CH715",
    name: "mixed-block",
    severity: Severity::Error,
    summary: "a macro statement and NC words in one block",
    explanation: r#"A Fanuc refuses NC words in the block of a macro statement (alarm 127); only N may come before it. Write two
blocks. Chordal carries out the words before the statement, then the statement."#,
};

pub(super) const PROGRAM_ALARM: CodeInfo = CodeInfo {
    code: Code::ProgramAlarm,
    id: "CH716",
    name: "program-alarm",
    severity: Severity::Error,
    summary: "the program stops itself with an alarm",
    explanation: r#"With `#3000=n (TEXT)` a program stops itself: an argument is missing, a tool is wrong, a part is not there.
The run ends here with the program's own text. Look at the conditions that led to this line."#,
};

pub(super) const OUTPUT_LIMIT: CodeInfo = CodeInfo {
    code: Code::OutputLimit,
    id: "CH717",
    name: "output-limit",
    severity: Severity::Warning,
    summary: "the program prints more than is kept",
    explanation: r#"DPRNT in a loop can print without end. Text after the limit is not kept; the run continues."#,
};

pub(super) const BAD_OUTPUT: CodeInfo = CodeInfo {
    code: Code::BadOutput,
    id: "CH718",
    name: "bad-output",
    severity: Severity::Error,
    summary: "the text of DPRNT cannot be read",
    explanation: r#"DPRNT prints the letters and digits between its brackets; `*` is a blank; `#1[53]` prints variable #1 with five
digits before the decimal point and three after it. Both numbers are needed. A Haas accepts 0 to 9 for each,
older controls at most 8 digits together."#,
};

pub(super) const SYSTEM_VARIABLE: CodeInfo = CodeInfo {
    code: Code::SystemVariable,
    id: "CH719",
    name: "system-variable",
    severity: Severity::Note,
    summary: "a system variable has a value that Chordal does not know",
    explanation: r#"The variable exists on the control, and its value does not follow from the program: an input, a timer, a
load. Chordal takes the value from the machine file's `[macros] variables`; without one it is zero."#,
};

pub(super) const WORD_ROUNDED: CodeInfo = CodeInfo {
    code: Code::WordRounded,
    id: "CH720",
    name: "word-rounded",
    severity: Severity::Warning,
    summary: "a value was not whole where the address needs a whole number",
    explanation: r#"The value of M, T, H, D, S, P or L was computed and has decimals; the control rounds it. If it should
be whole, check the computation; if not, write ROUND or FIX so that a reader sees it."#,
};

pub(super) const UNSET_NAME: CodeInfo = CodeInfo {
    code: Code::UnsetName,
    id: "CH721",
    name: "unset-name",
    severity: Severity::Error,
    summary: "a named variable is read before it is set",
    explanation: r#"Named variables (`#<name>`) must be set before they are read. A typing error in the name looks the same."#,
};

pub(super) const PROGRAM_STOP: CodeInfo = CodeInfo {
    code: Code::ProgramStop,
    id: "CH722",
    name: "program-message",
    severity: Severity::Note,
    summary: "the program stops and shows a message",
    explanation: r#"`#3006=n (TEXT)` stops the program, as M0 does, and shows the text to the operator."#,
};

pub(super) const SKIP_ASSUMED: CodeInfo = CodeInfo {
    code: Code::SkipAssumed,
    id: "CH723",
    name: "skip-assumed",
    severity: Severity::Note,
    summary: "where a skip move stops is assumed",
    explanation: r#"A probe or skip move (G31, LinuxCNC G38.2 to G38.5) ends where the probe touches the part; no program
says where that is. The machine file says what to assume:

    [probe]
    hit = "end"             # it touches where the move ends (the default)
    hit = "none"            # it touches nothing
    hit = { Z = "-10 mm" }  # it touches where Z reaches -10 mm, work coordinates

The positions that a program reads afterwards follow from that."#,
};

pub(super) const DATE_NOT_SET: CodeInfo = CodeInfo {
    code: Code::DateNotSet,
    id: "CH724",
    name: "date-not-set",
    severity: Severity::Note,
    summary: "the program reads the date or the time",
    explanation: r#"A run must give the same result every day, so Chordal never reads the clock. Date and time come from the
machine file: `[macros] date = "2024-05-17"`, `time = "13:45:00"`; without them they are zero."#,
};

pub(super) const OUTPUT_CLOSED: CodeInfo = CodeInfo {
    code: Code::OutputClosed,
    id: "CH725",
    name: "output-closed",
    severity: Severity::Note,
    summary: "the program prints without POPEN",
    explanation: r#"On most controls POPEN must open the port before DPRNT sends anything. Chordal keeps the text anyway."#,
};

pub(super) const NUMBER_OUT_OF_RANGE: CodeInfo = CodeInfo {
    code: Code::NumberOutOfRange,
    id: "CH740",
    name: "number-out-of-range",
    severity: Severity::Warning,
    summary: "a value is outside the range of the control",
    explanation: r#"A Fadal refuses numbers with twelve digits or more, and results between -0.0001 and 0.0001 that are not
zero (NUMBER OUT OF RANGE). The usual cause is a difference that should be zero: round it with RND before it
is used. Chordal keeps the value."#,
};

pub(super) const MACRO_LINE_TOO_LONG: CodeInfo = CodeInfo {
    code: Code::MacroLineTooLong,
    id: "CH741",
    name: "macro-line-too-long",
    severity: Severity::Warning,
    summary: "a macro line is longer than the control reads",
    explanation: r#"A Fadal reads 63 characters of a macro line. Compute a part of the formula in a line of its own before it."#,
};

pub(super) const INPUT_NOT_ANSWERED: CodeInfo = CodeInfo {
    code: Code::InputNotAnswered,
    id: "CH742",
    name: "input-not-answered",
    severity: Severity::Error,
    summary: "the program asks the operator for a number, and none is given",
    explanation: r#"`#INPUT V1` stops the program until the operator has typed a number. Chordal has no operator: the answers
come from the machine file, in the order in which the program asks:

    [macros]
    inputs = [1.5, 2]

Without an answer Chordal takes 0, as the control does when nothing is typed. What the program computes
from it means little."#,
};

pub(super) const PROBE_WITHOUT_HIT: CodeInfo = CodeInfo {
    code: Code::ProbeWithoutHit,
    id: "CH744",
    name: "probe-without-hit",
    severity: Severity::Warning,
    summary: "a probe move touches nothing, and the control stops with an error",
    explanation: r#"G38.2 and G38.4 of LinuxCNC stop the program with an error when the move ends without a touch; G38.3 and G38.5
continue. The machine file's `[probe] hit` says where the probe touches."#,
};

pub(super) const BAD_PROBE_MOVE: CodeInfo = CodeInfo {
    code: Code::BadProbeMove,
    id: "CH745",
    name: "bad-probe-move",
    severity: Severity::Error,
    summary: "a probe move that the control refuses",
    explanation: r#"A probe move needs an end point different from its start, a feed, cutter compensation off, and on
LinuxCNC a feed that is not inverse time."#,
};
