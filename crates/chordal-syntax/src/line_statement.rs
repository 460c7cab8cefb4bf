//! Statements of macro lines (Fadal): one statement per line after `#`, as in BASIC.

use chordal_diagnostics::{Code, TextRange};

use crate::expression::{Expression, ExpressionParser, StackOp};
use crate::statement::AssignTarget;

/// An item of a PRINT statement.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum PrintItem {
    /// The text between quotation marks, without them.
    Text(TextRange),
    /// A value.
    Value(Expression),
}

/// The statement of a macro line.
#[derive(Clone, PartialEq, Debug)]
pub enum LineStatement {
    /// No statement, a remark, or WAIT.
    Empty,
    /// `V1=…`.
    Assign {
        /// The variable that is assigned.
        target: AssignTarget,
        /// The value.
        value: Expression,
    },
    /// `IF … THEN`; the statement after it is not read yet.
    If(Expression),
    /// `GOTO :LABEL`.
    GotoLabel(TextRange),
    /// `GOTO N45`.
    GotoNumber(Expression),
    /// `:LABEL`.
    Label(TextRange),
    /// `START n`: continues in another program.
    Start(Expression),
    /// `PRINT "X IS ",V1`.
    Print {
        /// The items that are printed.
        items: Vec<PrintItem>,
        /// There is a comma at the end: the next PRINT continues in the same line.
        holds: bool,
    },
    /// `INPUT V1`.
    Input(Vec<AssignTarget>),
    /// `CLEAR V3-V7,V15`: pairs of the first and the last variable.
    Clear(Vec<(AssignTarget, AssignTarget)>),
    /// `SET RADIANS`, `SET DEGREES`.
    SetRadians(bool),
    /// `SET RND3`.
    SetPlaces(Expression),
    /// Text that is not a statement, which was reported as a problem.
    Unknown(TextRange),
}

/// Reads the next statement of a line, after `#` or THEN. Problems are stored in the parser.
pub fn parse_line_statement(parser: &mut ExpressionParser<'_>) -> LineStatement {
    let mark = parser.next_mark();
    let start = parser.position();
    let statement = match mark {
        b':' => LineStatement::Label(label(parser)),
        b'\'' | b'*' | b'\n' => LineStatement::Empty,
        _ => keyword(parser, start),
    };
    if matches!(statement, LineStatement::If(_)) {
        return statement;
    }
    let rest = parser.next_mark();
    if !matches!(rest, b'\'' | b'\n' | b'\r' | b';') && parser.problems.is_empty() {
        let range = TextRange::new(parser.position(), parser.end as u32);
        parser.problem(Code::BadStatement, range, |d| {
            d.label("nothing may come here").help("a macro line holds one statement")
        });
    }
    parser.at = parser.end;
    statement
}

fn keyword(parser: &mut ExpressionParser<'_>, start: u32) -> LineStatement {
    if parser.take_text("IF") {
        let condition = parser.expression();
        if parser.take_text("THEN") {
            return LineStatement::If(condition);
        }
        return unknown(parser, start, "THEN and a statement are missing: `#IF V1>2 THEN V1=0`");
    }
    if parser.take_text("GOTO") {
        if parser.next_mark() == b':' {
            return LineStatement::GotoLabel(label(parser));
        }
        parser.take_text("N");
        return LineStatement::GotoNumber(parser.expression());
    }
    if parser.take_text("START") {
        parser.take_text("O");
        return LineStatement::Start(parser.expression());
    }
    if parser.take_text("SPRINT") || parser.take_text("PRINT") {
        return print(parser);
    }
    if parser.take_text("INPUT") {
        return input(parser);
    }
    if parser.take_text("CLEAR") {
        return clear(parser, start);
    }
    if parser.take_text("WAIT") {
        return LineStatement::Empty;
    }
    if parser.take_text("SET") {
        return set(parser, start);
    }
    assignment(parser, start)
}

/// Reads a label with its colon: letters and digits.
fn label(parser: &mut ExpressionParser<'_>) -> TextRange {
    parser.take(b':');
    parser.next_mark();
    let start = parser.at;
    let named = |b: &u8| b.is_ascii_alphanumeric() || *b == b'_';
    let rest = &parser.text[parser.at..parser.end];
    parser.at += rest.iter().take_while(|b| named(b)).count();
    let range = TextRange::new(start as u32, parser.at as u32);
    if range.is_empty() {
        parser.problem(Code::BadStatement, range, |d| {
            d.label("a label is missing here").help("write letters and digits: `:END`")
        });
    }
    range
}

fn target(parser: &mut ExpressionParser<'_>) -> Option<AssignTarget> {
    let (index, kind) = parser.variable();
    let kind = kind.filter(|kind| matches!(kind, StackOp::Letters(_)))?;
    Some(AssignTarget { index, kind, range: index.range })
}

fn assignment(parser: &mut ExpressionParser<'_>, start: u32) -> LineStatement {
    const HELP: &str = "a macro line is an assignment (`V1=2`), IF, GOTO, a label, START, PRINT, \
                        SPRINT, INPUT, CLEAR, SET or WAIT";
    let Some(target) = target(parser) else {
        parser.problems.clear();
        return unknown(parser, start, HELP);
    };
    if !parser.take(b'=') {
        return unknown(parser, start, "`=` and a value are missing after the variable");
    }
    LineStatement::Assign { target, value: parser.expression() }
}

fn print(parser: &mut ExpressionParser<'_>) -> LineStatement {
    let mut items = Vec::new();
    let mut holds = false;
    loop {
        match parser.next_mark() {
            b'"' => {
                let start = parser.at + 1;
                let line = &parser.text[start..parser.end];
                let length = line.iter().position(|b| *b == b'"');
                if length.is_none() {
                    let range = TextRange::new(start as u32 - 1, start as u32);
                    parser.problem(Code::BadOutput, range, |d| {
                        d.label("this text is not closed").help("close it with `\"`")
                    });
                }
                let end = start + length.unwrap_or(line.len());
                parser.at = (end + 1).min(parser.end);
                items.push(PrintItem::Text(TextRange::new(start as u32, end as u32)));
            }
            b'\n' | b'\r' | b'\'' => break,
            _ => items.push(PrintItem::Value(parser.expression())),
        }
        holds = parser.take(b',') || parser.take(b';');
        if !holds {
            break;
        }
    }
    LineStatement::Print { items, holds }
}

/// Reads INPUT, which may have a prompt text.
fn input(parser: &mut ExpressionParser<'_>) -> LineStatement {
    if parser.next_mark() == b'"' {
        let line = &parser.text[parser.at + 1..parser.end];
        let length = line.iter().position(|b| *b == b'"').map_or(line.len(), |at| at + 1);
        parser.at += 1 + length;
        parser.take(b',');
    }
    let mut targets = Vec::new();
    while let Some(target) = target(parser) {
        targets.push(target);
        if !parser.take(b',') {
            break;
        }
    }
    LineStatement::Input(targets)
}

fn clear(parser: &mut ExpressionParser<'_>, start: u32) -> LineStatement {
    let mut ranges = Vec::new();
    loop {
        let Some(first) = target(parser) else {
            return unknown(parser, start, "name the variables: `CLEAR V3-V7,V15`");
        };
        let mut last = first;
        if parser.take(b'-') {
            match target(parser) {
                Some(named) => last = named,
                None => return unknown(parser, start, "name the last variable: `CLEAR V3-V7`"),
            }
        }
        ranges.push((first, last));
        if !parser.take(b',') {
            return LineStatement::Clear(ranges);
        }
    }
}

fn set(parser: &mut ExpressionParser<'_>, start: u32) -> LineStatement {
    if parser.take_text("RADIANS") {
        LineStatement::SetRadians(true)
    } else if parser.take_text("DEGREES") {
        LineStatement::SetRadians(false)
    } else if parser.take_text("RND") {
        LineStatement::SetPlaces(parser.expression())
    } else {
        unknown(parser, start, "SET takes RADIANS, DEGREES, or RND with a number of decimals")
    }
}

/// Reports the statement and skips the rest of the line.
fn unknown(parser: &mut ExpressionParser<'_>, start: u32, why: &str) -> LineStatement {
    let text = parser.text;
    let mut end = parser.end;
    while end > start as usize && text[end - 1].is_ascii_whitespace() {
        end -= 1;
    }
    parser.at = parser.end;
    let range = TextRange::new(start, end as u32);
    if parser.problems.is_empty() {
        parser.problem(Code::BadStatement, range, |d| d.label("passed over").help(why));
    }
    LineStatement::Unknown(range)
}

#[cfg(test)]
mod tests {
    use chordal_diagnostics::FileId;

    use super::*;
    use crate::{BracketStyle, MacroGrammar, Operator, operator};

    /// The grammar of a control with macro lines, as far as the statements below need it.
    static GRAMMAR: MacroGrammar = MacroGrammar {
        brackets: BracketStyle::Round,
        operators: &[operator("+", Operator::Add, 2), operator("=", Operator::Equal, 1)],
        abbreviations: false,
        letter_variables: &["TU", "FX", "V", "R"],
        ..MacroGrammar::MACRO_B
    };

    fn parse(text: &str) -> (LineStatement, usize) {
        let mut parser = ExpressionParser::new(text.as_bytes(), FileId(0), &GRAMMAR);
        parser.start(text.as_bytes(), FileId(0), TextRange::new(0, text.len() as u32));
        let statement = parse_line_statement(&mut parser);
        (statement, parser.problems.len())
    }

    #[test]
    fn statements_are_told_apart() {
        assert!(matches!(parse("V1=V2+1"), (LineStatement::Assign { .. }, 0)));
        assert!(matches!(parse(" IF V1=2 THEN V3=1"), (LineStatement::If(_), 0)));
        assert!(matches!(parse("GOTO :END"), (LineStatement::GotoLabel(_), 0)));
        assert!(matches!(parse("GOTO:END ' out"), (LineStatement::GotoLabel(_), 0)));
        assert!(matches!(parse("GOTO N45"), (LineStatement::GotoNumber(_), 0)));
        assert!(matches!(parse(":END"), (LineStatement::Label(_), 0)));
        assert!(matches!(parse("START 9200"), (LineStatement::Start(_), 0)));
        assert!(matches!(parse("' a remark"), (LineStatement::Empty, 0)));
        assert!(matches!(parse("WAIT"), (LineStatement::Empty, 0)));
        assert!(matches!(parse("SET RADIANS"), (LineStatement::SetRadians(true), 0)));
        assert!(matches!(parse("SET RND 3"), (LineStatement::SetPlaces(_), 0)));
        assert!(matches!(parse("TU(R9)=FX(V10)"), (LineStatement::Assign { .. }, 0)));
    }

    #[test]
    fn lists() {
        let (LineStatement::Print { items, holds }, 0) = parse("PRINT \"A \",V1,\" ' B\",") else {
            panic!("no PRINT");
        };
        assert_eq!((items.len(), holds), (3, true));
        let (LineStatement::Clear(ranges), 0) = parse("CLEAR V3-V7,V15") else {
            panic!("no CLEAR");
        };
        assert_eq!(ranges.len(), 2);
        assert!(matches!(parse("INPUT V1"), (LineStatement::Input(list), 0) if list.len() == 1));
    }

    #[test]
    fn what_cannot_be_read_is_told_once() {
        for text in ["HELLO", "IF V1 THEN2", "V1", "V1=1 V2=2", "CLEAR", "PRINT \"A", "GOTO :"] {
            assert_eq!(parse(text).1, usize::from(text != "IF V1 THEN2"), "{text}");
        }
    }
}
