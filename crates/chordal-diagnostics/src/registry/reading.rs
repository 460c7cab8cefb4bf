//! Reading the text.

use super::codes;

codes! {
    BadNumber = 101, "bad-number", Error;
    "a number cannot be read";
    r#"A word is a letter and a number: an optional sign, digits, at most one decimal point. This
is something else: two points, two signs, a sign without digits, or more digits than any
control keeps.

    G1 X1..5 F10.      two points
    G1 X--2. F10.      two signs

A control refuses the block. Chordal skips the word and continues, so that the rest of the
program can still be checked."#;

    MissingAddress = 102, "missing-address", Error;
    "a number without its address letter";
    r#"Every number in a block belongs to a letter. If a number stands alone, usually its letter was lost, or
the letter I was typed as the digit 1:

    N120 G17 G02 X3. Y2. 12. J2.      meant: I2. J2.

If the number begins with 1 and the block has a J or K but no I, the fix puts the I back."#;

    LetterForDigit = 103, "letter-for-digit", Error;
    "a letter where a digit was meant";
    r#"A letter O inside a number was meant to be a zero; a small l or a capital I inside a number was meant to
be a one:

    G1 X1O.5          meant: X10.5

A control reads the letter as a new address and alarms, or worse, reads it as a program number."#;

    UnclosedComment = 104, "unclosed-comment", Error;
    "a comment is not closed";
    r#"A comment that begins with `(` ends with `)` on the same line. Without it the control does not read
the rest of the line, or alarms. (On a Fadal the closing parenthesis may be left out, and Chordal does
not report it.)"#;

    UnexpectedCharacter = 105, "unexpected-character", Error;
    "a character has no meaning here";
    r#"Outside comments a block holds letters, digits, signs, points, blanks and the control's own marks.
Anything else is refused by the control."#;

    RepeatedWord = 106, "repeated-word", Error;
    "a letter appears twice in a block";
    r#"G and M may appear several times in a block, other letters once. With two X words one of them is a
mistake. Controls use the last one or alarm; Chordal reports it and uses the last one."#;

    NotAProgram = 107, "not-a-program", Error;
    "the file does not look like an NC program";
    r#"The file holds bytes that no program text holds (binary data, an archive, a picture), or it could not
be read in any known encoding. Nothing was run."#;

    EmptyProgram = 108, "empty-program", Warning;
    "there is no block to run";
    r#"The file is empty, or holds only comments and blank lines. Nothing moves."#;

    MissingValue = 109, "missing-value", Error;
    "an address letter without a number";
    r#"A letter needs a value: `X` alone means nothing. Every control refuses a letter without a number. The
usual causes are a deleted number and a comment without its parenthesis."#;

    NestedComment = 110, "nested-comment", Error;
    "a comment inside a comment";
    r#"A comment ends at the first `)`. With parentheses in parentheses the rest of the comment is read as
words, or the control refuses the block:

    (ROUGH (LEFT SIDE) TWICE)       TWICE) is outside the comment
    (ROUGH [LEFT SIDE] TWICE)       all of it is a comment

Chordal reports it once and continues after the last `)`."#;

    LooksLikeRemark = 111, "looks-like-remark", Error;
    "a sentence between the words of the program";
    r#"The control reads a comment without parentheses, or one that was wrapped onto the next line, as words of
the program, and most of them have no meaning. Chordal reports all lines of the comment once and skips them.

    (ROUGH THE POCKET AND LEAVE
    STOCK ON THE WALLS)             this line is not a comment"#;

    LineTooLong = 140, "line-too-long", Error;
    "a line is longer than the control reads";
    r#"LinuxCNC reads lines of at most 253 characters, comments and blanks included. A longer one stops
the program. Write it on several lines; a long comment may stand on a line of its own."#;

    BlockDeleteForm = 141, "block-delete-form", Error;
    "block delete in a form that the control does not read";
    r#"On LinuxCNC block delete is a slash as the first character of the line, without a number, and it deletes the whole
line. A number after it, or a slash later in the line, stops the program.

    /2 G0 X1         write / G0 X1
    G0 X1 /Y2        write two lines"#;
}
