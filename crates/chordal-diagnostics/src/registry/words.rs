//! Codes and words.

use super::codes;

codes! {
    UnknownCode = 301, "unknown-code", Error;
    "this control has no such code";
    r#"The G or M code is not in the table of this control. Perhaps the program was written for another
one: `chordal explain G154` says what a code does on each control, and
`chordal machines` lists the controls."#;

    SameGroup = 302, "same-group", Error;
    "two codes of one modal group in a block";
    r#"Codes of one group exclude each other: a block cannot be G0 and G1 at once. Some controls alarm,
others use the last one. (On a Fadal a block may have both G90 and G91; they act from left to right.)"#;

    BadWordValue = 303, "bad-word-value", Error;
    "a word has a value that it cannot have here";
    r#"The letter is right and the number is not: decimals where a whole number is needed, a negative count,
a number that is not in the table."#;

    UnusedWord = 304, "unused-word", Warning;
    "a word has no effect in this block";
    r#"Nothing in the block uses the word. The control ignores it or alarms; in either case it does not do
what was meant."#;

    MissingDecimalPoint = 305, "missing-decimal-point", Warning;
    "a number without a decimal point is read in least increments";
    r#"On this control `X3` is not three inches but three least increments: 0.0003 in, or 0.003 mm. With a
point (`X3.`) it is three inches. In a program that otherwise writes points, a missing one is nearly
always a mistake, and a dangerous one."#;

    NotSimulated = 306, "not-simulated", Note;
    "the code is known, but what it does is not simulated";
    r#"The control carries the code out. Chordal does not, and reports it, so that you know what is missing
from the path and the time."#;

    NotAlone = 307, "not-alone", Error;
    "the code must be the only one of its kind in the block";
    r#"Some codes must not be in one block with others of the same letter: on a Fadal G92 and G53 must be
the only G code of their block."#;

    MissingWord = 308, "missing-word", Error;
    "the code needs a word that is missing";
    r#"A code such as M98 needs its P, a dwell its time, a tool change its T. Without it the control alarms."#;

    NoSuchAxis = 309, "no-such-axis", Error;
    "the machine has no such axis";
    r#"The block moves an axis that the machine file does not have. Add the axis to the machine file, or
choose the machine with `--machine`."#;

    ExcessDecimals = 310, "excess-decimals", Note;
    "a length has more decimals than the control uses";
    r#"A control counts in least increments: 0.0001 in, 0.001 mm. Decimals beyond that are cut off or rounded, so
the axis does not go exactly where the text says. In G91 the differences add up. The setting
`excess_decimals` says what a control does. Reported once in each program."#;

    TooManyDigits = 311, "too-many-digits", Error;
    "a number has more digits than the control accepts";
    r#"A Fanuc-style control accepts eight digits in a number. With more it alarms, even if all of
them are decimals.

    X1.23456789              nine digits: PS0003 on a Fanuc"#;

    NotFollowed = 312, "not-followed", Error;
    "the path from here on is not known: the control does something that Chordal does not carry out";
    r#"This code or word changes the path or the place of the tool, and Chordal does not carry it out. What comes after
it is shown as if the code were not there, so no answer about it holds: not the path, not the time, not travel or
collisions. The run is not verified from this line on, and what needs the whole path (compare, convert, transform)
refuses it.

Look up what the code does. Where it has no effect in this program, delete it in a copy and check that; where a custom
code of the machine stands behind it, say what it does in `[shop_codes]` of the machine file."#;

    BlockRefused = 313, "block-refused", Error;
    "the firmware refuses this block";
    r#"Small controls (GRBL and its kin) judge a block as a whole before anything of it acts. A block with a mistake
changes nothing, not even a mode, and the control answers with a number:

    G2 X10 I5           error:22, there is no feed for this cut
    G2 X10 Y1 I5 F300   error:33, the end is not on the circle
    M6 T1               error:20, GRBL has no tool change

The control itself goes on with the next block; senders stop. The setting `on error` of the machine file chooses:
with `stop` (the default) the blocks after it are not run, with `continue` they are."#;

    ToolChangeBySender = 314, "tool-change-by-sender", Note;
    "the sender changes the tool, not the control";
    r#"GRBL has no tool change: it refuses M6 with error:20. Many senders keep M6 from it, lift the spindle and wait until the
tool is changed. Chordal takes that for granted, and says so at the first M6 of a program. Where your sender passes M6 on,
write `"M6" = "nobody"` under `[settings]` of the machine file: M6 is an error then."#;

    FeedBeforeUnits = 315, "feed-before-units", Warning;
    "F is taken before the units of its block change";
    r#"LinuxCNC and Mach3 carry a block out step by step, and F comes before G20 and G21: `G21 F300` while G20 is in force
is 300 inches a minute, not 300 mm. Write F in a block after the one with G20 or G21. Other controls read all words of a
block in its own units."#;

    PolarWords = 340, "polar-words", Error;
    "a radius or an angle that cannot be used here";
    r#"On LinuxCNC `@` is a radius and `^` an angle in degrees about the work origin, in place of X and Y:
`G1 @10 ^30`. The one that is not written stays; in G91 both are added to the present ones. They
work in G17 only, in motions and cycles, and not together with X or Y. At the work origin there is no angle
to keep, so that `@` needs `^`."#;

    NoKeptModes = 341, "no-kept-modes", Error;
    "M72 without modes that were kept";
    r#"On LinuxCNC M70 keeps the modes in force, and M72 brings them back: units, plane, G90 or G91, feed, work
offset and more. M73 keeps them until the subprogram ends. What is kept belongs to one level of calls, and M71
forgets it. M72 with nothing kept stops the program."#;
}
