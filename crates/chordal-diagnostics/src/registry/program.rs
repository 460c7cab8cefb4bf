//! Programs, calls and loops.

use super::{Code, CodeInfo};
use crate::Severity;

pub(super) const MISSING_SUBPROGRAM: CodeInfo = CodeInfo {
    code: Code::MissingSubprogram,
    id: "CH201",
    name: "missing-subprogram",
    severity: Severity::Error,
    summary: "a called program is not there",
    explanation: r#"The program calls another by number or name, and neither this file nor the folder beside it holds
one. Chordal looks for an `O` (or `:`) head with that number in the file, then for files of the same
folder whose first head has the number, or whose name is the number (`O1000`, `O1000.nc`, `1000.nc`).
The call is passed over."#,
};

pub(super) const MISSING_LABEL: CodeInfo = CodeInfo {
    code: Code::MissingLabel,
    id: "CH202",
    name: "missing-label",
    severity: Severity::Error,
    summary: "no block has the N number that is jumped to",
    explanation: r#"`M97 P100`, `M99 P100` or `M98 P1 H100` jump to the block with `N100`. No block of the program has
it. The program ends here, as it would on the machine."#,
};

pub(super) const NESTING_TOO_DEEP: CodeInfo = CodeInfo {
    code: Code::NestingTooDeep,
    id: "CH203",
    name: "nesting-too-deep",
    severity: Severity::Error,
    summary: "calls are nested deeper than the control allows",
    explanation: r#"A subprogram may call another, up to a depth that belongs to the control. A program that calls
itself without end arrives here too. The call is not made."#,
};

pub(super) const ENDLESS_LOOP: CodeInfo = CodeInfo {
    code: Code::EndlessLoop,
    id: "CH204",
    name: "endless-loop",
    severity: Severity::Error,
    summary: "the program repeats itself without end",
    explanation: r#"`M99` in a main program starts it again, and `M99 P` may jump back; both are used on purpose with
bar feeders and pallets, and by accident. Chordal runs the program once through, says that it
repeats, and stops."#,
};

pub(super) const PROGRAM_WITHOUT_END: CodeInfo = CodeInfo {
    code: Code::ProgramWithoutEnd,
    id: "CH205",
    name: "program-without-end",
    severity: Severity::Warning,
    summary: "the program stops without an end code",
    explanation: r#"The text ends without M2, M30 (or M99 in a subprogram). Many controls alarm or wait here with the
spindle turning. Put `M30` at the end."#,
};

pub(super) const REPEAT_NOT_ALLOWED: CodeInfo = CodeInfo {
    code: Code::RepeatNotAllowed,
    id: "CH206",
    name: "repeat-not-allowed",
    severity: Severity::Error,
    summary: "a line repeat stands where the control has none",
    explanation: r#"`L` on a line repeats that line. A Fadal does this in the main program only, not in subroutines and
subprograms; there a loop must be a call with repeats. Other controls have no line repeat at all."#,
};

pub(super) const CALL_NOT_ALLOWED: CodeInfo = CodeInfo {
    code: Code::CallNotAllowed,
    id: "CH207",
    name: "call-not-allowed",
    severity: Severity::Error,
    summary: "this form of call is not allowed here",
    explanation: r#"Controls restrict which program may call which: on a Fadal a subprogram (O, M98) may not contain
or call subroutines (L)."#,
};

pub(super) const RETURN_WITHOUT_CALL: CodeInfo = CodeInfo {
    code: Code::ReturnWithoutCall,
    id: "CH208",
    name: "return-without-call",
    severity: Severity::Warning,
    summary: "a return stands where nothing was called",
    explanation: r#"A return code (M17, M99) was met outside any subroutine or subprogram."#,
};

pub(super) const DUPLICATE_PROGRAM: CodeInfo = CodeInfo {
    code: Code::DuplicateProgram,
    id: "CH209",
    name: "duplicate-program",
    severity: Severity::Warning,
    summary: "two programs of the file have the same number",
    explanation: r#"Only one can be called. Chordal takes the first; a control refuses to load the second, or replaces
the first."#,
};

pub(super) const HEADER_OUT_OF_PLACE: CodeInfo = CodeInfo {
    code: Code::HeaderOutOfPlace,
    id: "CH210",
    name: "header-out-of-place",
    severity: Severity::Error,
    summary: "a subroutine head stands outside the subroutine section",
    explanation: r#"On a Fadal all subroutines (L100, L200, …) come before the main program and M30 closes their
section. A head after that M30 is not found by the control."#,
};

pub(super) const BUDGET_REACHED: CodeInfo = CodeInfo {
    code: Code::BudgetReached,
    id: "CH211",
    name: "budget-reached",
    severity: Severity::Error,
    summary: "the run was stopped by its budget",
    explanation: r#"Loops, repeats and calls can make an endless run out of three lines. The run stops when it has carried
out more blocks than its budget allows; the number is told, and `--max-blocks` sets another."#,
};

pub(super) const SHOP_CODE_REFUSED: CodeInfo = CodeInfo {
    code: Code::ShopCodeRefused,
    id: "CH212",
    name: "shop-code-refused",
    severity: Severity::Error,
    summary: "a rule of the shop refuses one of its own codes",
    explanation: r#"M codes and programs that the control does not have may be answered by the shop itself: in Python
with `chordal.load(…, shop_codes=…)`, in Rust with `RunOptions::shop_codes`. The answer was a refusal, or one that
cannot be carried out: a time below zero, or more text than a run takes. The code is passed over; the message says what
the shop's rule said.

In a machine file `[shop_codes.M120]` gives such an M code its `time` and its `label`; that never refuses."#,
};

pub(super) const REPEATS_STAND_STILL: CodeInfo = CodeInfo {
    code: Code::RepeatsStandStill,
    id: "CH213",
    name: "repeats-stand-still",
    severity: Severity::Warning,
    summary: "a helix is repeated with L in G90",
    explanation: r#"L repeats a block as it stands. In G90 the third axis is at its end after the first time, so the repeats
are flat circles at that depth. For one turn after the other write the block in G91:

    G91 I-.5 G3 Z-.1 L3
    G90"#,
};

pub(super) const ENDS_ELSEWHERE: CodeInfo = CodeInfo {
    code: Code::EndsElsewhere,
    id: "CH214",
    name: "ends-elsewhere",
    severity: Severity::Note,
    summary: "a subprogram with a contour in G91 does not come back to where it began",
    explanation: r#"A pocket or a boss in G91 leads in from where it is called, and its lead-out comes back there, so that
the next call finds the tool at the same place. Here the sum of the moves is not zero: blocks are missing,
or a number is wrong. Where the subprogram steps on purpose, nothing is wrong."#,
};
