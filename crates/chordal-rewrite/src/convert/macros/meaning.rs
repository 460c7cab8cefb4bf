//! What a statement does, whatever the language that it is written in.

use chordal::control::Control;
use chordal::control::macros::MacroForm;
use chordal::diagnostics::{FileId, TextRange};
use chordal::syntax::{
    AssignTarget, ConditionBranch, Expression, ExpressionParser, LineStatement, MacroStatement,
    StackOp, parse_line_statement, parse_statement,
};

use super::tree::{ExpressionTree, VariableRef};

/// Where a jump goes.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum JumpLabel {
    /// An N number.
    Number(u32),
    /// `:LABEL`, in upper case.
    Name(String),
}

/// A statement.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum MacroMeaning {
    Nothing,
    Assign(VariableRef, ExpressionTree),
    /// A condition, and what is done where it holds.
    If(ExpressionTree, Box<MacroMeaning>),
    Goto(JumpLabel),
    Label(JumpLabel),
    /// The beginning of a loop and its number.
    While(ExpressionTree, u32),
    End(u32),
    /// A line that is printed: it steers nothing.
    Print,
}

/// The statement of a block and the remark after it; nothing where it is none that other languages have.
pub(super) fn of(
    text: &[u8],
    range: TextRange,
    control: &Control,
) -> Option<(MacroMeaning, Option<String>)> {
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
pub(super) fn value(text: &[u8], range: TextRange, control: &Control) -> Option<ExpressionTree> {
    let grammar = control.table.lexicon.grammar;
    let mut parser = ExpressionParser::new(text, FileId(0), grammar);
    parser.start(text, FileId(0), range);
    let value = parser.value();
    ExpressionTree::of(&parser, value, text).filter(|_| parser.rest().is_empty())
}

fn target(parser: &ExpressionParser, target: &AssignTarget, text: &[u8]) -> Option<VariableRef> {
    let number = ExpressionTree::of(parser, target.index, text)?;
    let ExpressionTree::Number(number) = number else { return None };
    let number = number.parse().ok()?;
    match target.kind {
        StackOp::Read => Some(VariableRef::Number(number)),
        StackOp::Letters(place) => {
            let letters = *parser.grammar().letter_variables.get(usize::from(place))?;
            Some(VariableRef::Letter(letters, number))
        }
        _ => None,
    }
}

fn number_of(parser: &ExpressionParser, expression: Expression, text: &[u8]) -> Option<JumpLabel> {
    match ExpressionTree::of(parser, expression, text)? {
        ExpressionTree::Number(number) => Some(JumpLabel::Number(number.parse().ok()?)),
        _ => None,
    }
}

/// A statement of macro B, alone in its block.
fn block(parser: &mut ExpressionParser, text: &[u8]) -> Option<MacroMeaning> {
    let meaning = match parse_statement(parser) {
        MacroStatement::Empty => MacroMeaning::Nothing,
        MacroStatement::Assign { target: to, value, text: None } => MacroMeaning::Assign(
            target(parser, &to, text)?,
            ExpressionTree::of(parser, value, text)?,
        ),
        MacroStatement::If { condition, branch: ConditionBranch::Goto(to) } => {
            let condition = ExpressionTree::of(parser, condition, text)?;
            MacroMeaning::If(condition, Box::new(MacroMeaning::Goto(number_of(parser, to, text)?)))
        }
        MacroStatement::If { condition, branch: ConditionBranch::Then } => {
            let condition = ExpressionTree::of(parser, condition, text)?;
            let then = block(parser, text)?;
            matches!(then, MacroMeaning::Assign(..))
                .then(|| MacroMeaning::If(condition, Box::new(then)))?
        }
        MacroStatement::Goto(to) => MacroMeaning::Goto(number_of(parser, to, text)?),
        MacroStatement::While { condition: Some(condition), number } => {
            MacroMeaning::While(ExpressionTree::of(parser, condition, text)?, number)
        }
        MacroStatement::End(number) => MacroMeaning::End(number),
        MacroStatement::Output(_) => return Some(MacroMeaning::Print),
        _ => return None,
    };
    let rest = parser.rest().slice(text).trim_ascii();
    (rest.is_empty() || rest.starts_with(b"(")).then_some(meaning)
}

/// A macro line.
fn line(parser: &mut ExpressionParser, text: &[u8]) -> Option<MacroMeaning> {
    Some(match parse_line_statement(parser) {
        LineStatement::Empty => MacroMeaning::Nothing,
        LineStatement::Assign { target: to, value } => MacroMeaning::Assign(
            target(parser, &to, text)?,
            ExpressionTree::of(parser, value, text)?,
        ),
        LineStatement::If(condition) => {
            let condition = ExpressionTree::of(parser, condition, text)?;
            let then = line(parser, text)?;
            matches!(then, MacroMeaning::Assign(..) | MacroMeaning::Goto(_))
                .then(|| MacroMeaning::If(condition, Box::new(then)))?
        }
        LineStatement::GotoLabel(name) => MacroMeaning::Goto(JumpLabel::Name(named(name, text))),
        LineStatement::GotoNumber(to) => MacroMeaning::Goto(number_of(parser, to, text)?),
        LineStatement::Label(name) => MacroMeaning::Label(JumpLabel::Name(named(name, text))),
        LineStatement::Print { .. } => MacroMeaning::Print,
        _ => return None,
    })
}

fn named(name: TextRange, text: &[u8]) -> String {
    String::from_utf8_lossy(name.slice(text)).to_ascii_uppercase()
}
