//! Macro programs: expressions, variables, statements, calls, output.

use super::codes;

codes! {
    BadExpression = 700, "bad-expression", Error;
    "an expression cannot be read";
    r#"A value is a number, a variable (`#101`), a function (`SIN[30.]`) or a bracket. Values are joined by
`+ - * / MOD AND OR XOR EQ NE GT GE LT LE`. What cannot be read is marked; the word or the assignment it
belongs to is skipped. On Fanuc, Haas, Mitsubishi and LinuxCNC brackets of expressions are `[ ]`, since
`( )` is a comment; on a Fadal they are `( )`."#;

    UnbalancedBrackets = 701, "unbalanced-brackets", Error;
    "a bracket of an expression is not closed";
    r#"Every `[` needs its `]` on the same line. In a long formula count up by one at each `[` and down by one at
each `]`: the count must end at zero and never be below it."#;

    BracketsTooDeep = 702, "brackets-too-deep", Error;
    "brackets are nested deeper than the control reads";
    r#"Fanuc and Mitsubishi read five levels of brackets; those of functions and of the condition of IF or WHILE
count as well. Compute a part of the formula first and store it in a variable."#;

    UnsupportedMacro = 703, "unsupported-macro", Error;
    "a macro form that this control does not have";
    r#"Macro languages differ in their functions and forms: FUP is not on a Haas, `##1` only on LinuxCNC, `AX[…]`
and `SETVN` only on newer Fanucs. The form is skipped, and values that depend on it are not known."#;

    BadStatement = 704, "bad-statement", Error;
    "a macro statement cannot be read";
    r#"The macro statements of Fanuc, Haas and Mitsubishi are the assignment `#1=…`, `IF[…]GOTO n`,
`IF[…]THEN …`, `GOTO n`, `WHILE[…]DO n` with `END n`, and the output statements POPEN, DPRNT, BPRNT and
PCLOS. `IF … ENDIF` over several lines is not one of them. The statement is skipped."#;

    BadVariable = 705, "bad-variable", Error;
    "there is no variable of that number";
    r#"The control defines the numbers of variables: local ones 1–33, common ones such as 100–199 and 500–999
(on a Haas NGC also 10000–10999), and system variables. A computed number must be whole; the message shows
the value. Reading gives null (or zero on controls without null); writing is skipped."#;

    ReadOnlyVariable = 706, "read-only-variable", Error;
    "this variable cannot be written";
    r#"Null (#0), positions, modal codes and inputs are read-only. The assignment is skipped."#;

    DivisionByZero = 707, "division-by-zero", Error;
    "a division by zero";
    r#"The divisor is zero, or a variable that was never set: null counts as zero in arithmetic. The word or
the assignment is skipped; the control stops with an alarm."#;

    OutsideDomain = 708, "outside-domain", Error;
    "a function has no value for its argument";
    r#"The root of a negative number, the logarithm of zero, ASIN or ACOS beyond 1, the tangent of 90°. The
message shows the argument. The usual cause is a value that should be 1 and is 1.0000000001; limit it with
IF before the function."#;

    NumberOverflow = 709, "number-overflow", Error;
    "a value is too large";
    r#"A result is larger than the control can hold, or larger than its address accepts."#;

    ConditionAsValue = 710, "condition-as-value", Error;
    "a comparison is used where a number is needed";
    r#"On a Fanuc and a Mitsubishi a comparison (EQ, NE, GT, GE, LT, LE) belongs in the condition of IF or WHILE and
cannot be assigned. A Haas gives 1. or 0."#;

    BadLoopNumber = 711, "bad-loop-number", Error;
    "the number of DO or END is not allowed";
    r#"DO and END take 1, 2 or 3 (1 to 127 on a Mitsubishi). A number may be used again once its loop is over, and
again in a called program, but not inside the loop itself."#;

    LoopMismatch = 712, "loop-mismatch", Error;
    "DO and END do not belong together";
    r#"Each `DOn` needs an `ENDn` further down in the same program. Loops must not cross. A GOTO may leave a loop
but not enter one. An END without its DO is skipped; a DO without its END ends the run."#;

    MacroNesting = 713, "macro-nesting", Error;
    "macro calls are nested deeper than the control allows";
    r#"G65, G66 and codes that call macros may be nested four levels deep (five on newer Fanucs, nine on a Haas).
The call is not made."#;

    BadArgument = 714, "bad-argument", Error;
    "a word cannot be an argument of a macro call";
    r#"G65 and G66 pass their words to the macro as #1 to #26, except G, L, N, O and P, which belong to the call
itself. A to Z (type I) and the sets of I, J, K (type II) may be mixed; of two values for the same
variable the later one is used."#;

    MixedBlock = 715, "mixed-block", Error;
    "a macro statement and NC words in one block";
    r#"A Fanuc refuses NC words in the block of a macro statement (alarm 127); only N may come before it. Write two
blocks. Chordal carries out the words before the statement, then the statement."#;

    ProgramAlarm = 716, "program-alarm", Error;
    "the program stops itself with an alarm";
    r#"With `#3000=n (TEXT)` a program stops itself: an argument is missing, a tool is wrong, a part is not there.
The run ends here with the program's own text. Check the conditions that led to this line."#;

    OutputLimit = 717, "output-limit", Warning;
    "the program prints more than is kept";
    r#"DPRNT in a loop can print without end. Text after the limit is not kept; the run continues."#;

    BadOutput = 718, "bad-output", Error;
    "the text of DPRNT cannot be read";
    r#"DPRNT prints the letters and digits between its brackets; `*` is a blank; `#1[53]` prints variable #1 with five
digits before the decimal point and three after it. Both numbers are needed. A Haas accepts 0 to 9 for each,
older controls at most 8 digits together."#;

    SystemVariable = 719, "system-variable", Note;
    "a system variable has a value that Chordal does not know";
    r#"The variable exists on the control, and its value does not follow from the program: an input, a timer, a load, a
position that no block has named, an offset that nobody gave. Said once in a program, with all such variables that
it reads. Chordal takes the values from `[macros]
variables` of the machine file or from `--set '#1001=1'`; without one the value is unknown, and so is what is
computed from it: see CH726."#;

    WordRounded = 720, "word-rounded", Warning;
    "a value was not whole where the address needs a whole number";
    r#"The value of M, T, H, D, S, P or L was computed and has decimals; the control rounds it. If it should
be whole, check the computation; if not, write ROUND or FIX so that a reader sees it."#;

    UnsetName = 721, "unset-name", Error;
    "a named variable is read before it is set";
    r#"Named variables (`#<name>`) must be set before they are read. A typing error in the name looks the same."#;

    ProgramStop = 722, "program-message", Note;
    "the program stops and shows a message";
    r#"`#3006=n (TEXT)` stops the program, as M0 does, and shows the text to the operator."#;

    SkipAssumed = 723, "skip-assumed", Note;
    "where a skip move stops is assumed: the path is not verified from here on";
    r#"A probe or skip move (G31, LinuxCNC G38.2 to G38.5) ends where the probe touches the part; no program
says where that is. Without a word in the machine file Chordal lets it touch where the move ends, and verifies
nothing of what follows. The machine file says where it touches, and the run is whole:

    [probe]
    hit = "end"             # it touches where the move ends
    hit = "none"            # it touches nothing
    hit = { Z = "-10 mm" }  # it touches where Z reaches -10 mm, work coordinates

The positions that a program reads afterwards follow from that."#;

    DateNotSet = 724, "date-not-set", Note;
    "the program reads the date or the time";
    r#"A run must give the same result every day, so Chordal never reads the clock. Date and time come from the
machine file: `[macros] date = "2024-05-17"`, `time = "13:45:00"`; without them they are zero."#;

    OutputClosed = 725, "output-closed", Note;
    "the program prints without POPEN";
    r#"On most controls POPEN must open the port before DPRNT sends anything. Chordal keeps the text anyway."#;

    UnknownVariable = 726, "unknown-variable", Note;
    "the program reads variables before it sets them";
    r#"Common variables keep what another program or the operator has written: #500 to #999 over power-off on most
controls, #100 to #199 until power-off. A program that reads one before it sets it reads something that is
not in the program. Chordal does not invent a value: it is unknown, and whatever is computed from it is unknown
as well. Said once in a program, with all such variables.

    F#652                    an unknown feed: the time of these cuts is not counted (CH730)
    G0 X#500                 the place of X is not known until X is named again (CH727)
    IF[#501EQ1]GOTO10        the branch is assumed: not taken (CH728)

Give the values: `--set '#500=1.5'`, `[macros.variables]` of the machine file, or the control's own output of its
variables next to the program (MACRO.TXT of a Fanuc, COMMON.VAR of a Mitsubishi, the .var file of LinuxCNC and
Haas)."#;

    UnknownPath = 727, "unknown-path", Note;
    "the path from here on is not known: it depends on a value that nobody gave";
    r#"The place of an axis, the centre or the radius of an arc, a level of a cycle, a called program or the number of
repeats is computed from a variable whose value is not known (see CH726 and CH719). The run goes on without this
word: the axes are at an unknown place, and nothing is drawn, until the program names them again in G90. The run is
not verified from this line on. Said once in a program. Give the value, and the run is whole."#;

    AssumedBranch = 728, "assumed-branch", Note;
    "a condition depends on a value that nobody gave: it is taken as not fulfilled";
    r#"The condition of IF or WHILE is computed from a variable whose value is not known (see CH726). Chordal goes on
as if it were not fulfilled: a jump is not made, a loop is left out. The run is not verified from this line on.
Give the value, and the branch is the one that the control takes."#;

    MacroAlone = 729, "macro-alone", Note;
    "a macro run by itself: it needs the arguments of its caller";
    r#"The program returns with M99 and reads local variables that it does not set: they are the arguments of a call
(G65, G66, a code that calls a macro, `o<name> call`). Run alone it would compute with nothing. So nothing is run and
nothing of it is verified; the programs that call it run it with their arguments.

    O9100
    IF[#24EQ#0]GOTO900       X is missing
    G0 X#24 Y#25
    M99

Check a program that calls it; a macro in the same folder is found by its number or its name."#;

    UnknownTime = 730, "unknown-time", Note;
    "a feed or a dwell depends on a value that nobody gave";
    r#"The feed or the time of a dwell is computed from a variable whose value is not known (see CH726). The path is the
same, and what `stock` says of it holds; the time of these moves is not counted, and the feed is not held against
the limits of the machine. Said once in a program, which is not verified from this line on."#;

    VariableFile = 731, "variable-file", Warning;
    "a line of a file of variables cannot be read";
    r#"The control's output of its variables next to the program gives the values that the program reads (see CH726).
This line has none of the forms that such files have, and is left out:

    G10L85P500(4029000000000000)     MACRO.TXT of a Fanuc: the bits of the number
    #500=12.5                        COMMON.VAR of a Mitsubishi, older Fanucs
    N500 V12.5                       .VAR of a Haas
    5220 1.0                         .var of LinuxCNC"#;

    SkipByMachineFile = 732, "skip-by-machine-file", Note;
    "a skip move stops where the machine file says";
    r#"A probe or skip move ends where the probe touches the part, and `[probe] hit` of the machine file says where that
is. The path and the positions that the program reads afterwards are those of that touch, and of no other."#;

    NumberOutOfRange = 740, "number-out-of-range", Warning;
    "a value is outside the range of the control";
    r#"A Fadal refuses numbers with twelve digits or more, and results between -0.0001 and 0.0001 that are not
zero (NUMBER OUT OF RANGE). The usual cause is a difference that should be zero: round it with RND before it
is used. Chordal keeps the value."#;

    MacroLineTooLong = 741, "macro-line-too-long", Warning;
    "a macro line is longer than the control reads";
    r#"A Fadal reads 63 characters of a macro line. Compute a part of the formula in a line of its own before it."#;

    InputNotAnswered = 742, "input-not-answered", Error;
    "the program asks the operator for a number, and none is given";
    r#"`#INPUT V1` stops the program until the operator has typed a number. Chordal has no operator: the answers
come from the machine file, in the order in which the program asks:

    [macros]
    inputs = [1.5, 2]

Without an answer Chordal takes 0, as the control does when nothing is typed. What the program computes
from it is not reliable."#;

    ProbeWithoutHit = 744, "probe-without-hit", Warning;
    "a probe move touches nothing, and the control stops with an error";
    r#"G38.2 and G38.4 of LinuxCNC stop the program with an error when the move ends without a touch; G38.3 and G38.5
continue. The machine file's `[probe] hit` says where the probe touches."#;

    BadProbeMove = 745, "bad-probe-move", Error;
    "a probe move that the control refuses";
    r#"A probe move needs an end point different from its start, a feed, cutter compensation off, and on
LinuxCNC a feed that is not inverse time."#;
}
