//! Programs, calls and loops.

use super::codes;

codes! {
    MissingSubprogram = 201, "missing-subprogram", Error;
    "a called program was not found";
    r#"The program calls another program by number or name, and neither this file nor its folder has it.
Chordal looks for an `O` (or `:`) number in the file, then for files in the same folder that begin with
that number or have it as their name (`O1000`, `O1000.nc`, `1000.nc`). The call is skipped, and with it what
it moves.

A macro of the machine builder or of a probe maker, such as `G65 P9810`, is often only in the control. The machine
file can say what it does:

    [shop_codes.O9810]
    blocks = "G1 X#24 Y#25 Z#26 F#9"    # X, Y, Z and F of the call

    [shop_codes.O9832]                  # no blocks: it moves nothing
    label = "probe on""#;

    MissingLabel = 202, "missing-label", Error;
    "a jump to an N number that no block has";
    r#"`M97 P100`, `M99 P100` or `M98 P1 H100` jump to the block with `N100`. No block of the program has
it. The program ends here, as it would on the machine."#;

    NestingTooDeep = 203, "nesting-too-deep", Error;
    "calls are nested deeper than the control allows";
    r#"A subprogram may call another, up to the depth that the control allows. A program that calls
itself without end gets this message, too. The call is not made."#;

    EndlessLoop = 204, "endless-loop", Error;
    "the program repeats itself without end";
    r#"`M99` in a main program starts it again, and `M99 P` may jump back. Both are used on purpose with bar
feeders and pallets, and both happen by mistake. Chordal runs the program once, reports that it
repeats, and stops."#;

    ProgramWithoutEnd = 205, "program-without-end", Warning;
    "the program stops without an end code";
    r#"The text ends without M2, M30 (or M99 in a subprogram). Many controls alarm or wait here with the
spindle turning. Put `M30` at the end."#;

    RepeatNotAllowed = 206, "repeat-not-allowed", Error;
    "a line repeat where the control has none";
    r#"`L` on a line repeats that line. A Fadal does this in the main program only, not in subroutines and
subprograms; there a loop must be a call with repeats. Other controls have no line repeat at all."#;

    CallNotAllowed = 207, "call-not-allowed", Error;
    "this form of call is not allowed here";
    r#"Controls limit which kind of program may call which: on a Fadal a subprogram (O, M98) may not contain
or call subroutines (L)."#;

    ReturnWithoutCall = 208, "return-without-call", Warning;
    "a return where nothing was called";
    r#"There is a return code (M17, M99) outside any subroutine or subprogram."#;

    DuplicateProgram = 209, "duplicate-program", Warning;
    "two programs of the file have the same number";
    r#"Only one of them can be called. Chordal calls the first; a control refuses to load the second, or replaces
the first."#;

    HeaderOutOfPlace = 210, "header-out-of-place", Error;
    "a subroutine begins outside the subroutine section";
    r#"On a Fadal all subroutines (L100, L200, …) come before the main program, and M30 closes their section.
The control does not find a subroutine after that M30."#;

    BudgetReached = 211, "budget-reached", Error;
    "the run was stopped by its budget";
    r#"Loops, repeats and calls can make an endless run out of three lines. The run stops when it has carried
out more blocks than its budget allows. The message gives the number; `--max-blocks` sets another."#;

    ShopCodeRefused = 212, "shop-code-refused", Error;
    "a custom M code or a custom program was refused";
    r#"You can say what custom M codes and custom programs do, those that the control itself does not have: in Python
with `chordal.load(…, shop_codes=…)`, in Rust with `RunOptions::shop_codes`. Here the answer was a refusal, or it
cannot be carried out: a time below zero, or more text than a run accepts. The code is skipped; the message quotes
the answer.

In a machine file `[shop_codes.M120]` gives a custom M code its `time` and `label`, or its `blocks`, and
`[shop_codes.O9810]` the same for a program that no file holds; this is never refused."#;

    RepeatsStandStill = 213, "repeats-stand-still", Warning;
    "a helix is repeated with L in G90";
    r#"L repeats a block without any change. In G90 the third axis is at its end point after the first time, so
the repeats are flat circles at that depth. For one turn below the other write the block in G91:

    G91 I-.5 G3 Z-.1 L3
    G90"#;

    EndsOutside = 214, "ends-elsewhere", Note;
    "a subprogram with a contour in G91 does not come back to where it began";
    r#"A pocket or a boss in G91 starts at the position where it is called, and its lead-out comes back to it, so
that the next call starts there, too. Here the sum of the moves is not zero: blocks are missing, or a
number is wrong. If the subprogram moves on to the next position on purpose, nothing is wrong."#;

    NotRead = 215, "language-not-read", Error;
    "the program is in a language that Chordal does not follow";
    r#"The text shows signs of a language that Chordal recognizes and does not follow: a program for an Okuma OSP,
a Fagor or a plotter, or the code of a 3D printer. Read as something else it would give hundreds of
messages that mean nothing, or a wrong path without one. Nothing is run, and the program is not verified.

If the text is a mill program for one of the controls that Chordal has, name the machine: `--machine haas-vf2`. Then it
is read as that machine would read it, whatever its signs say."#;

    ReadingNotKnown = 216, "reading-not-known", Warning;
    "what the program moves depends on a control that nothing names";
    r#"A program that does not name its control can often be read in several ways: a number without a decimal point
is whole units on one control and least increments on another, a program without G20 or G21 starts in the units of
the machine, an arc or a cycle may differ. Chordal runs the controls that remain possible and compares where they
move. Here they do not move alike: the message gives the first block that differs, what each control makes of
it, and the size of the part. The path is shown as the first of them would go it, and nothing of it is verified.

What `X5` is can also be a setting of one control (Setting 162 of a Haas, DPI of a Fanuc). Where a program never writes
the point of a whole number, both values are compared: `--set settings.decimal_point=calculator` for 5 mm,
`least-increment` for 0.005 mm.

Name the machine: `--machine haas-vf2`, or a `chordal.toml` next to the programs. Where all controls move alike, one
is assumed and the program is verified."#;

    FeedNotKnown = 217, "feed-not-known", Note;
    "how fast the program cuts depends on a control that nothing names";
    r#"The controls that the program may be for go the same path, at other feeds. The time is that of the control that
was assumed. Name the machine: `--machine haas-vf2`."#;

    BlockDeleteDecides = 218, "block-delete-decides", Note;
    "block delete decides about a mode or a value that later blocks use";
    r#"A block behind `/` changes how the blocks after it are carried out: G91, another plane or unit, an offset, a
variable. With the switch the other way they go elsewhere:

    /G91
    X5.                      X to 5, or by 5

Chordal runs the program as the switch is said to be (`--block-delete`, off without it), and once the other way: what
only that run finds is listed with a note. Said once in a program. `--block-delete=both` asks for both runs whatever
the blocks behind `/` do. If both ways are meant to end alike, say the mode again behind the blocks that may be left
out."#;
}
