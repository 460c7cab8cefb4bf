//! Reading the text.

use super::{Code, CodeInfo};
use crate::Severity;

pub(super) const BAD_NUMBER: CodeInfo = CodeInfo {
    code: Code::BadNumber,
    id: "CH101",
    name: "bad-number",
    severity: Severity::Error,
    summary: "a number cannot be read",
    explanation: r#"A word is a letter and a number: an optional sign, digits, at most one decimal point. What
stands here is something else: two points, two signs, a sign without digits, or more digits
than any control keeps.

    G1 X1..5 F10.      two points
    G1 X--2. F10.      two signs

A control refuses the block. Chordal leaves the word out and goes on, so that the rest of the
program can still be looked at."#,
};

pub(super) const MISSING_ADDRESS: CodeInfo = CodeInfo {
    code: Code::MissingAddress,
    id: "CH102",
    name: "missing-address",
    severity: Severity::Error,
    summary: "a number stands without its address letter",
    explanation: r#"Every number in a block belongs to a letter. A lone number is usually a letter that was lost, or
the letter I typed as the digit 1:

    N120 G17 G02 X3. Y2. 12. J2.      meant: I2. J2.

If the number begins with 1 and the block has a J or K but no I, the fix puts the I back."#,
};

pub(super) const LETTER_FOR_DIGIT: CodeInfo = CodeInfo {
    code: Code::LetterForDigit,
    id: "CH103",
    name: "letter-for-digit",
    severity: Severity::Error,
    summary: "a letter stands where a digit was meant",
    explanation: r#"The letter O inside a number was meant to be a zero, and a small l or a capital I inside a number
a one:

    G1 X1O.5          meant: X10.5

A control reads the letter as a new address and alarms, or worse, takes it for a program number."#,
};

pub(super) const UNCLOSED_COMMENT: CodeInfo = CodeInfo {
    code: Code::UnclosedComment,
    id: "CH104",
    name: "unclosed-comment",
    severity: Severity::Error,
    summary: "a comment is opened and not closed",
    explanation: r#"A comment that begins with `(` ends with `)` on the same line. Without it the rest of the line is
lost to the control, or the control alarms. (On a Fadal the closing parenthesis may be left out,
and Chordal does not complain there.)"#,
};

pub(super) const UNEXPECTED_CHARACTER: CodeInfo = CodeInfo {
    code: Code::UnexpectedCharacter,
    id: "CH105",
    name: "unexpected-character",
    severity: Severity::Error,
    summary: "a character has no meaning here",
    explanation: r#"Outside comments a block holds letters, digits, signs, points, blanks and the control's own marks.
Anything else is refused by the control."#,
};

pub(super) const REPEATED_WORD: CodeInfo = CodeInfo {
    code: Code::RepeatedWord,
    id: "CH106",
    name: "repeated-word",
    severity: Severity::Error,
    summary: "a letter stands twice in a block",
    explanation: r#"G and M may stand several times in a block, other letters once. With two X words one of them is a
slip; controls take the last one or alarm, so Chordal does not guess silently: it says so and takes
the last."#,
};

pub(super) const NOT_A_PROGRAM: CodeInfo = CodeInfo {
    code: Code::NotAProgram,
    id: "CH107",
    name: "not-a-program",
    severity: Severity::Error,
    summary: "the file does not look like an NC program",
    explanation: r#"The file holds bytes that no program text holds (binary data, an archive, a picture), or it could not
be read as any of the encodings known. Nothing was run."#,
};

pub(super) const EMPTY_PROGRAM: CodeInfo = CodeInfo {
    code: Code::EmptyProgram,
    id: "CH108",
    name: "empty-program",
    severity: Severity::Warning,
    summary: "there is no block to run",
    explanation: r#"The file is empty, or holds only comments and blank lines. Nothing moves."#,
};

pub(super) const MISSING_VALUE: CodeInfo = CodeInfo {
    code: Code::MissingValue,
    id: "CH109",
    name: "missing-value",
    severity: Severity::Error,
    summary: "an address letter stands without a number",
    explanation: r#"A letter needs a value: `X` alone says nothing. Letters with nothing behind them are refused by
every control; the common reasons are a deleted number and a comment without its parenthesis."#,
};

pub(super) const NESTED_COMMENT: CodeInfo = CodeInfo {
    code: Code::NestedComment,
    id: "CH110",
    name: "nested-comment",
    severity: Severity::Error,
    summary: "a comment stands in a comment",
    explanation: r#"A comment ends at the first `)`. With parentheses in parentheses the rest of the comment is read as
words, or the control refuses the block:

    (ROUGH (LEFT SIDE) TWICE)       TWICE) is no comment any more
    (ROUGH [LEFT SIDE] TWICE)       is one

Chordal tells it once and reads on behind the last `)`."#,
};

pub(super) const LOOKS_LIKE_REMARK: CodeInfo = CodeInfo {
    code: Code::LooksLikeRemark,
    id: "CH111",
    name: "looks-like-remark",
    severity: Severity::Error,
    summary: "a sentence stands between the words of the program",
    explanation: r#"A remark without its parentheses, or one that was wrapped onto the next line, is read as words by the
control, and most of them are none. Chordal says it once for all the lines of a remark and passes them
over.

    (ROUGH THE POCKET AND LEAVE
    STOCK ON THE WALLS)             this line is no comment"#,
};
