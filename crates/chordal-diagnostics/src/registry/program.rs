//! Programs, calls and loops.

use super::{Code, CodeInfo};
use crate::Severity;

pub(super) const MISSING_SUBPROGRAM: CodeInfo = CodeInfo {
    code: Code::MissingSubprogram,
    id: "CH201",
    name: "missing-subprogram",
    severity: Severity::Error,
    summary: "a called program was not found",
    explanation: r#"The program calls another program by number or name, and neither this file nor its folder has it.
Chordal looks for an `O` (or `:`) number in the file, then for files in the same folder that begin with
that number or have it as their name (`O1000`, `O1000.nc`, `1000.nc`). The call is skipped."#,
};

pub(super) const MISSING_LABEL: CodeInfo = CodeInfo {
    code: Code::MissingLabel,
    id: "CH202",
    name: "missing-label",
    severity: Severity::Error,
    summary: "a jump to an N number that no block has",
    explanation: r#"`M97 P100`, `M99 P100` or `M98 P1 H100` jump to the block with `N100`. No block of the program has
it. The program ends here, as it would on the machine."#,
};

pub(super) const NESTING_TOO_DEEP: CodeInfo = CodeInfo {
    code: Code::NestingTooDeep,
    id: "CH203",
    name: "nesting-too-deep",
    severity: Severity::Error,
    summary: "calls are nested deeper than the control allows",
    explanation: r#"A subprogram may call another, up to the depth that the control allows. A program that calls
itself without end gets this message, too. The call is not made."#,
};

pub(super) const ENDLESS_LOOP: CodeInfo = CodeInfo {
    code: Code::EndlessLoop,
    id: "CH204",
    name: "endless-loop",
    severity: Severity::Error,
    summary: "the program repeats itself without end",
    explanation: r#"`M99` in a main program starts it again, and `M99 P` may jump back. Both are used on purpose with bar
feeders and pallets, and both happen by mistake. Chordal runs the program once, reports that it
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
    summary: "a line repeat where the control has none",
    explanation: r#"`L` on a line repeats that line. A Fadal does this in the main program only, not in subroutines and
subprograms; there a loop must be a call with repeats. Other controls have no line repeat at all."#,
};

pub(super) const CALL_NOT_ALLOWED: CodeInfo = CodeInfo {
    code: Code::CallNotAllowed,
    id: "CH207",
    name: "call-not-allowed",
    severity: Severity::Error,
    summary: "this form of call is not allowed here",
    explanation: r#"Controls limit which kind of program may call which: on a Fadal a subprogram (O, M98) may not contain
or call subroutines (L)."#,
};

pub(super) const RETURN_WITHOUT_CALL: CodeInfo = CodeInfo {
    code: Code::ReturnWithoutCall,
    id: "CH208",
    name: "return-without-call",
    severity: Severity::Warning,
    summary: "a return where nothing was called",
    explanation: r#"There is a return code (M17, M99) outside any subroutine or subprogram."#,
};

pub(super) const DUPLICATE_PROGRAM: CodeInfo = CodeInfo {
    code: Code::DuplicateProgram,
    id: "CH209",
    name: "duplicate-program",
    severity: Severity::Warning,
    summary: "two programs of the file have the same number",
    explanation: r#"Only one of them can be called. Chordal takes the first; a control refuses to load the second, or replaces
the first."#,
};

pub(super) const HEADER_OUT_OF_PLACE: CodeInfo = CodeInfo {
    code: Code::HeaderOutOfPlace,
    id: "CH210",
    name: "header-out-of-place",
    severity: Severity::Error,
    summary: "a subroutine begins outside the subroutine section",
    explanation: r#"On a Fadal all subroutines (L100, L200, …) come before the main program, and M30 closes their section.
The control does not find a subroutine after that M30."#,
};

pub(super) const BUDGET_REACHED: CodeInfo = CodeInfo {
    code: Code::BudgetReached,
    id: "CH211",
    name: "budget-reached",
    severity: Severity::Error,
    summary: "the run was stopped by its budget",
    explanation: r#"Loops, repeats and calls can make an endless run out of three lines. The run stops when it has carried
out more blocks than its budget allows. The message gives the number; `--max-blocks` sets another."#,
};

pub(super) const SHOP_CODE_REFUSED: CodeInfo = CodeInfo {
    code: Code::ShopCodeRefused,
    id: "CH212",
    name: "shop-code-refused",
    severity: Severity::Error,
    summary: "a custom M code or a custom program was refused",
    explanation: r#"You can say what custom M codes and custom programs do, those that the control itself does not have: in Python
with `chordal.load(…, shop_codes=…)`, in Rust with `RunOptions::shop_codes`. Here the answer was a refusal, or it
cannot be carried out: a time below zero, or more text than a run accepts. The code is skipped; the message quotes
the answer.

In a machine file `[shop_codes.M120]` gives a custom M code its `time` and its `label`; this is never refused."#,
};

pub(super) const REPEATS_STAND_STILL: CodeInfo = CodeInfo {
    code: Code::RepeatsStandStill,
    id: "CH213",
    name: "repeats-stand-still",
    severity: Severity::Warning,
    summary: "a helix is repeated with L in G90",
    explanation: r#"L repeats a block without any change. In G90 the third axis is at its end point after the first time, so
the repeats are flat circles at that depth. For one turn below the other write the block in G91:

    G91 I-.5 G3 Z-.1 L3
    G90"#,
};

pub(super) const ENDS_ELSEWHERE: CodeInfo = CodeInfo {
    code: Code::EndsElsewhere,
    id: "CH214",
    name: "ends-elsewhere",
    severity: Severity::Note,
    summary: "a subprogram with a contour in G91 does not come back to where it began",
    explanation: r#"A pocket or a boss in G91 starts at the position where it is called, and its lead-out comes back to it, so
that the next call starts there, too. Here the sum of the moves is not zero: blocks are missing, or a
number is wrong. If the subprogram moves on to the next position on purpose, nothing is wrong."#,
};
