//! What a statement does, whatever the language that it is written in.

use chordal::control::Control;
use chordal::control::macros::MacroForm;
use chordal::diagnostics::{FileId, TextRange};
use chordal::syntax::{
    Branch, Expression, ExpressionParser, LineStatement, Op, Statement, Target,
    parse_line_statement, parse_statement,
};

use super::tree::{Tree, Variable};

/// Where a jump goes.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Label {
    /// An N number.
    Number(u32),
    /// `:LABEL`, in upper case.
    Name(String),
}

/// A statement.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Meaning {
    Nothing,
    Assign(Variable, Tree),
    /// A condition, and what is done where it holds.
    If(Tree, Box<Meaning>),
    Goto(Label),
    Label(Label),
    /// The beginning of a loop and its number.
    While(Tree, u32),
    End(u32),
    /// A line that is printed: it steers nothing.
    Print,
}

/// The statement of a block and the remark after it; nothing where it is none that other languages have.
pub(super) fn of(
    text: &[u8],
    range: TextRange,
    control: &Control,
) -> Option<(Meaning, Option<String>)> {
    let grammar = control.table.lexicon.grammar;
    let mut parser = ExpressionParser::new(text, FileId(0), grammar);
    let written = |range: TextRange| String::from_utf8_lossy(range.slice(text)).trim().to_string();
    match control.macros.form {
        MacroForm::Blocks => {
            parser.start(text, FileId(0), range);
            let meaning = block(&mut parser, text)?;
            Some((meaning, Some(written(parser.rest())).filter(|rest| !rest.is_empty())))
        }
        MacroForm::Lines => {
            // After the mark of a macro line.
            parser.start(text, FileId(0), TextRange::new(range.start + 1, range.end));
            let meaning = line(&mut parser, text)?;
            let line = written(range);
            Some((meaning, line.find('\'').map(|at| line[at..].to_string())))
        }
        MacroForm::None | MacroForm::OWords => None,
    }
}

/// The value of a word.
pub(super) fn value(text: &[u8], range: TextRange, control: &Control) -> Option<Tree> {
    let grammar = control.table.lexicon.grammar;
    let mut parser = ExpressionParser::new(text, FileId(0), grammar);
    parser.start(text, FileId(0), range);
    let value = parser.value();
    Tree::of(&parser, value, text).filter(|_| parser.rest().is_empty())
}

fn target(parser: &ExpressionParser, target: &Target, text: &[u8]) -> Option<Variable> {
    let number = Tree::of(parser, target.index, text)?;
    let Tree::Number(number) = number else { return None };
    let number = number.parse().ok()?;
    match target.kind {
        Op::Read => Some(Variable::Number(number)),
        Op::Letters(place) => {
            let letters = *parser.grammar().letter_variables.get(usize::from(place))?;
            Some(Variable::Letter(letters, number))
        }
        _ => None,
    }
}

fn number_of(parser: &ExpressionParser, expression: Expression, text: &[u8]) -> Option<Label> {
    match Tree::of(parser, expression, text)? {
        Tree::Number(number) => Some(Label::Number(number.parse().ok()?)),
        _ => None,
    }
}

/// A statement of macro B, alone in its block.
fn block(parser: &mut ExpressionParser, text: &[u8]) -> Option<Meaning> {
    let meaning = match parse_statement(parser) {
        Statement::Empty => Meaning::Nothing,
        Statement::Assign { target: to, value, text: None } => {
            Meaning::Assign(target(parser, &to, text)?, Tree::of(parser, value, text)?)
        }
        Statement::If { condition, branch: Branch::Goto(to) } => {
            let condition = Tree::of(parser, condition, text)?;
            Meaning::If(condition, Box::new(Meaning::Goto(number_of(parser, to, text)?)))
        }
        Statement::If { condition, branch: Branch::Then } => {
            let condition = Tree::of(parser, condition, text)?;
            let then = block(parser, text)?;
            matches!(then, Meaning::Assign(..)).then(|| Meaning::If(condition, Box::new(then)))?
        }
        Statement::Goto(to) => Meaning::Goto(number_of(parser, to, text)?),
        Statement::While { condition: Some(condition), number } => {
            Meaning::While(Tree::of(parser, condition, text)?, number)
        }
        Statement::End(number) => Meaning::End(number),
        Statement::Output(_) => return Some(Meaning::Print),
        _ => return None,
    };
    let rest = parser.rest().slice(text).trim_ascii();
    (rest.is_empty() || rest.starts_with(b"(")).then_some(meaning)
}

/// A macro line.
fn line(parser: &mut ExpressionParser, text: &[u8]) -> Option<Meaning> {
    Some(match parse_line_statement(parser) {
        LineStatement::Empty => Meaning::Nothing,
        LineStatement::Assign { target: to, value } => {
            Meaning::Assign(target(parser, &to, text)?, Tree::of(parser, value, text)?)
        }
        LineStatement::If(condition) => {
            let condition = Tree::of(parser, condition, text)?;
            let then = line(parser, text)?;
            matches!(then, Meaning::Assign(..) | Meaning::Goto(_))
                .then(|| Meaning::If(condition, Box::new(then)))?
        }
        LineStatement::GotoLabel(name) => Meaning::Goto(Label::Name(named(name, text))),
        LineStatement::GotoNumber(to) => Meaning::Goto(number_of(parser, to, text)?),
        LineStatement::Label(name) => Meaning::Label(Label::Name(named(name, text))),
        LineStatement::Print { .. } => Meaning::Print,
        _ => return None,
    })
}

fn named(name: TextRange, text: &[u8]) -> String {
    String::from_utf8_lossy(name.slice(text)).to_ascii_uppercase()
}
