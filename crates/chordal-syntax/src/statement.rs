//! Statements of the macro B family: assignments, IF, WHILE, GOTO, output.

use chordal_diagnostics::{Code, TextRange};

use crate::expression::{Expression, ExpressionParser, StackOp};

/// The target of an assignment.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct AssignTarget {
    /// The number of the variable; empty for a named one.
    pub index: Expression,
    /// The kind of the variable: [`StackOp::Read`], [`StackOp::ReadNamed`] or [`StackOp::Letters`].
    pub kind: StackOp,
    /// Its text.
    pub range: TextRange,
}

/// What follows a condition.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum ConditionBranch {
    /// GOTO.
    Goto(Expression),
    /// THEN: the statement that follows on the line.
    Then,
    /// No word: the condition applies to the rest of the line (`[#1EQ2] M99`).
    Rest,
}

/// An output command.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum OutputCode {
    /// POPEN.
    Open,
    /// PCLOS.
    Close,
    /// DPRNT and the text in its brackets.
    Text(TextRange),
    /// BPRNT and the text in its brackets.
    Binary(TextRange),
}

/// One macro statement.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum MacroStatement {
    /// No statement.
    Empty,
    /// `#1=…`.
    Assign {
        /// The variable that is assigned.
        target: AssignTarget,
        /// The value.
        value: Expression,
        /// The text in parentheses directly after it (`#3000=1(TEXT)`), without them; `None` if there is none.
        text: Option<TextRange>,
    },
    /// `IF[…]…`, or `[…]…`.
    If {
        /// The condition.
        condition: Expression,
        /// What the condition controls.
        branch: ConditionBranch,
    },
    /// GOTO.
    Goto(Expression),
    /// `WHILE[…]DOn`; `DOn` alone has no condition.
    While {
        /// The condition.
        condition: Option<Expression>,
        /// The number n of the loop.
        number: u32,
    },
    /// `ENDn`.
    End(u32),
    /// POPEN, PCLOS, DPRNT, BPRNT.
    Output(OutputCode),
    /// Text that is not a statement of this control, which was reported as a problem.
    Unknown(TextRange),
}

/// Reads the next statement of a macro B line; the text after it is not read yet ([`ExpressionParser::rest`]). Problems
/// are stored in the parser.
pub fn parse_statement(parser: &mut ExpressionParser<'_>) -> MacroStatement {
    let mark = parser.next_mark();
    let start = parser.position();
    match mark {
        b'#' => return assignment(parser),
        b'[' => {
            let condition = parser.value();
            return MacroStatement::If { condition, branch: ConditionBranch::Rest };
        }
        _ if !mark.is_ascii_alphabetic() => return MacroStatement::Empty,
        _ => {}
    }
    let short = parser.grammar.abbreviations;
    if parser.take_text("IF") {
        return condition(parser);
    }
    if parser.take_text("WHILE") || short && parser.take_text("WH") {
        return while_loop(parser);
    }
    if parser.take_text("GOTO") || short && parser.take_text("GO") {
        return MacroStatement::Goto(parser.expression());
    }
    if parser.take_text("ENDIF") || parser.take_text("ELSE") || parser.take_text("THEN") {
        return unknown(parser, start, "this control has no IF block over several lines");
    }
    if parser.take_text("END") {
        return match loop_number(parser) {
            Some(number) => MacroStatement::End(number),
            None => bad_loop_number(parser, start),
        };
    }
    if parser.take_text("DO") {
        return do_number(parser, None, start);
    }
    if parser.take_text("POPEN") {
        return MacroStatement::Output(OutputCode::Open);
    }
    if parser.take_text("PCLOS") {
        return MacroStatement::Output(OutputCode::Close);
    }
    if parser.take_text("DPRNT") {
        return output(parser, start, OutputCode::Text);
    }
    if parser.take_text("BPRNT") {
        return output(parser, start, OutputCode::Binary);
    }
    // Names of variables for the screen: `SETVN500[DEPTH,WIDTH]`.
    if parser.take_text("SETVN") {
        return names_of_variables(parser, start);
    }
    unknown(parser, start, "no macro statement of this control begins like this")
}

fn assignment(parser: &mut ExpressionParser<'_>) -> MacroStatement {
    let start = parser.position();
    let (index, kind) = parser.variable();
    let range = index.range;
    let Some(kind) = kind else { return unknown_quietly(parser, start) };
    if !parser.take(b'=') {
        return unknown(parser, start, "a variable alone does nothing: write `=` and a value");
    }
    let value = parser.expression();
    let text = hugging_text(parser);
    MacroStatement::Assign { target: AssignTarget { index, kind, range }, value, text }
}

/// The text of a comment directly after the value; `None` if there is none.
fn hugging_text(parser: &mut ExpressionParser<'_>) -> Option<TextRange> {
    if parser.next_mark() != b'(' {
        return None;
    }
    let start = parser.at + 1;
    let line = &parser.text[start..parser.end];
    let length = line.iter().position(|b| *b == b')').unwrap_or(line.len());
    parser.at = (start + length + 1).min(parser.end);
    Some(TextRange::new(start as u32, (start + length) as u32))
}

fn condition(parser: &mut ExpressionParser<'_>) -> MacroStatement {
    let start = parser.position();
    if parser.next_mark() != b'[' {
        return unknown(parser, start, "the condition belongs in brackets: `IF[#1EQ2]`");
    }
    let condition = parser.value();
    let short = parser.grammar.abbreviations;
    if parser.take_text("GOTO") || short && parser.take_text("GO") {
        return MacroStatement::If {
            condition,
            branch: ConditionBranch::Goto(parser.expression()),
        };
    }
    if parser.take_text("THEN") {
        return MacroStatement::If { condition, branch: ConditionBranch::Then };
    }
    if !parser.problems.is_empty() {
        return unknown_quietly(parser, start);
    }
    let (at, end) = (parser.position(), parser.end as u32);
    parser.at = parser.end;
    parser.problem(Code::BadStatement, TextRange::new(at, end.max(at)), |d| {
        d.label("GOTO or THEN is missing here").help("write `IF[…]GOTO 10`, or `IF[…]THEN #1=2`")
    });
    MacroStatement::Unknown(TextRange::new(start, end))
}

fn while_loop(parser: &mut ExpressionParser<'_>) -> MacroStatement {
    let start = parser.position();
    if parser.next_mark() != b'[' {
        return unknown(parser, start, "the condition belongs in brackets: `WHILE[#1LT5]DO1`");
    }
    let condition = parser.value();
    let at = parser.position();
    if !parser.take_text("DO") {
        return unknown(parser, at, "DO and a number are missing here: `WHILE[#1LT5]DO1`");
    }
    do_number(parser, Some(condition), at)
}

fn do_number(
    parser: &mut ExpressionParser<'_>,
    condition: Option<Expression>,
    start: u32,
) -> MacroStatement {
    match loop_number(parser) {
        Some(number) => MacroStatement::While { condition, number },
        None => bad_loop_number(parser, start),
    }
}

/// The number of DO and END. A number with a leading zero is not accepted, because there the O of DO was typed as a zero.
fn loop_number(parser: &mut ExpressionParser<'_>) -> Option<u32> {
    parser.next_mark();
    let rest = &parser.text[parser.at..parser.end];
    let digits = rest.iter().take_while(|b| b.is_ascii_digit()).count();
    if digits == 0 || digits > 4 || rest[0] == b'0' {
        return None;
    }
    parser.at += digits;
    Some(rest[..digits].iter().fold(0, |sum, b| sum * 10 + u32::from(b - b'0')))
}

fn bad_loop_number(parser: &mut ExpressionParser<'_>, start: u32) -> MacroStatement {
    unknown(parser, start, "DO and END need a number without a leading zero: `DO1`, `END1`")
}

fn output(
    parser: &mut ExpressionParser<'_>,
    start: u32,
    make: fn(TextRange) -> OutputCode,
) -> MacroStatement {
    if parser.next_mark() != b'[' {
        return unknown(parser, start, "the text belongs in brackets: `DPRNT[X#1[44]]`");
    }
    let text = parser.at + 1;
    let mut depth = 0usize;
    while parser.at < parser.end {
        match parser.text[parser.at] {
            b'[' => depth += 1,
            b']' => depth -= 1,
            _ => {}
        }
        parser.at += 1;
        if depth == 0 {
            let range = TextRange::new(text as u32, parser.at as u32 - 1);
            return MacroStatement::Output(make(range));
        }
    }
    unknown(parser, start, "the bracket of this text is not closed")
}

fn names_of_variables(parser: &mut ExpressionParser<'_>, start: u32) -> MacroStatement {
    let names = &parser.text[parser.at..parser.end];
    match names.iter().position(|byte| *byte == b']') {
        Some(close) if names.contains(&b'[') => {
            parser.at += close + 1;
            MacroStatement::Empty
        }
        _ => unknown(parser, start, "the names belong in brackets: `SETVN500[DEPTH,WIDTH]`"),
    }
}

/// Reports the statement and skips the rest of the line.
fn unknown(parser: &mut ExpressionParser<'_>, start: u32, why: &str) -> MacroStatement {
    parser.at = parser.end;
    let mut end = parser.end as u32;
    let text = parser.text;
    while end > start && text[end as usize - 1].is_ascii_whitespace() {
        end -= 1;
    }
    let range = TextRange::new(start, end);
    parser.problem(Code::BadStatement, range, |d| d.label("passed over").help(why));
    MacroStatement::Unknown(range)
}

/// The same for a statement that was already reported.
fn unknown_quietly(parser: &mut ExpressionParser<'_>, start: u32) -> MacroStatement {
    if parser.problems.is_empty() {
        return unknown(parser, start, "a macro statement is an assignment, IF, WHILE, GOTO, END");
    }
    parser.at = parser.end;
    MacroStatement::Unknown(TextRange::new(start, parser.end as u32))
}
