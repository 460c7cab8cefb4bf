//! Reading the text.

use super::{Code, CodeInfo};
use crate::Severity;

pub(super) const BAD_NUMBER: CodeInfo = CodeInfo {
    code: Code::BadNumber,
    id: "CH101",
    name: "bad-number",
    severity: Severity::Error,
    summary: "a number cannot be read",
    explanation: r#"A word is a letter and a number: an optional sign, digits, at most one decimal point. This
is something else: two points, two signs, a sign without digits, or more digits than any
control keeps.

    G1 X1..5 F10.      two points
    G1 X--2. F10.      two signs

A control refuses the block. Chordal skips the word and continues, so that the rest of the
program can still be checked."#,
};

pub(super) const MISSING_ADDRESS: CodeInfo = CodeInfo {
    code: Code::MissingAddress,
    id: "CH102",
    name: "missing-address",
    severity: Severity::Error,
    summary: "a number without its address letter",
    explanation: r#"Every number in a block belongs to a letter. For a number alone, usually the letter was lost, or the
letter I was typed as the digit 1:

    N120 G17 G02 X3. Y2. 12. J2.      meant: I2. J2.

If the number begins with 1 and the block has a J or K but no I, the fix puts the I back."#,
};

pub(super) const LETTER_FOR_DIGIT: CodeInfo = CodeInfo {
    code: Code::LetterForDigit,
    id: "CH103",
    name: "letter-for-digit",
    severity: Severity::Error,
    summary: "a letter where a digit was meant",
    explanation: r#"A letter O inside a number was meant to be a zero; a small l or a capital I inside a number was meant to
be a one:

    G1 X1O.5          meant: X10.5

A control reads the letter as a new address and alarms, or worse, takes it for a program number."#,
};

pub(super) const UNCLOSED_COMMENT: CodeInfo = CodeInfo {
    code: Code::UnclosedComment,
    id: "CH104",
    name: "unclosed-comment",
    severity: Severity::Error,
    summary: "a comment is not closed",
    explanation: r#"A comment that begins with `(` ends with `)` on the same line. Without it the control does not read
the rest of the line, or alarms. (On a Fadal the closing parenthesis may be left out, and Chordal does
not report it.)"#,
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
    summary: "a letter appears twice in a block",
    explanation: r#"G and M may appear several times in a block, other letters once. With two X words one of them is a
mistake. Controls use the last one or alarm; Chordal reports it and uses the last one."#,
};

pub(super) const NOT_A_PROGRAM: CodeInfo = CodeInfo {
    code: Code::NotAProgram,
    id: "CH107",
    name: "not-a-program",
    severity: Severity::Error,
    summary: "the file does not look like an NC program",
    explanation: r#"The file holds bytes that no program text holds (binary data, an archive, a picture), or it could not
be read in any known encoding. Nothing was run."#,
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
    summary: "an address letter without a number",
    explanation: r#"A letter needs a value: `X` alone means nothing. Every control refuses a letter without a number. The
usual causes are a deleted number and a comment without its parenthesis."#,
};

pub(super) const NESTED_COMMENT: CodeInfo = CodeInfo {
    code: Code::NestedComment,
    id: "CH110",
    name: "nested-comment",
    severity: Severity::Error,
    summary: "a comment inside a comment",
    explanation: r#"A comment ends at the first `)`. With parentheses in parentheses the rest of the comment is read as
words, or the control refuses the block:

    (ROUGH (LEFT SIDE) TWICE)       TWICE) is outside the comment
    (ROUGH [LEFT SIDE] TWICE)       all of it is a comment

Chordal reports it once and continues after the last `)`."#,
};

pub(super) const LOOKS_LIKE_REMARK: CodeInfo = CodeInfo {
    code: Code::LooksLikeRemark,
    id: "CH111",
    name: "looks-like-remark",
    severity: Severity::Error,
    summary: "a sentence between the words of the program",
    explanation: r#"The control reads a remark without parentheses, or one that was wrapped onto the next line, as words of
the program, and most of it is not. Chordal reports it once for all lines of the remark and skips them.

    (ROUGH THE POCKET AND LEAVE
    STOCK ON THE WALLS)             this line is not a comment"#,
};
