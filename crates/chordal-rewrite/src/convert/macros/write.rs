//! Statements in the words of a control.

use chordal::control::Control;
use chordal::control::macros::{MAX_MACRO_LINE_CHARS, MacroForm};
use chordal::syntax::{BracketStyle, MacroGrammar};

use super::meaning::{JumpLabel, MacroMeaning};
use super::names::MacroNames;
use super::tree::ExpressionTree;
use crate::source::WordStyle;

/// What binds tighter than all operators.
const TIGHTEST: u8 = u8::MAX;

/// The lines of a statement; nothing where the control has no form for it.
pub(super) fn statement(
    meaning: &MacroMeaning,
    names: &MacroNames,
    at: usize,
    to: &Control,
) -> Option<Vec<String>> {
    match to.macros.form {
        MacroForm::Lines => lines(meaning, names, at, to)
            .filter(|lines| lines.iter().all(|line| line.len() <= MAX_MACRO_LINE_CHARS)),
        MacroForm::Blocks => Some(vec![block(meaning, names, to)?]),
        MacroForm::None | MacroForm::OWords => None,
    }
}

/// The lines with the number that the block had.
pub(super) fn numbered(
    mut lines: Vec<String>,
    number: Option<String>,
    to: &Control,
    style: WordStyle,
) -> Vec<String> {
    let Some(number) = number else { return lines };
    match (to.macros.form, lines.first_mut()) {
        // A macro line begins with its mark.
        (MacroForm::Lines, _) => lines.insert(0, number),
        (_, Some(first)) => {
            *first = format!("{number}{}{first}", style.gap());
        }
        (_, None) => lines.push(number),
    }
    lines
}

/// Puts a remark after a statement.
pub(super) fn remark(lines: &mut Vec<String>, remark: &str, to: &Control) {
    let inner = remark.trim_start_matches('(').trim_end_matches(')');
    match lines.first_mut() {
        None => lines.push(remark.into()),
        Some(line) if line.is_empty() => *line = remark.into(),
        // Macro lines are short.
        Some(_) if to.macros.form == MacroForm::Lines => lines.insert(0, format!("({inner}")),
        Some(line) => *line += &format!(" {remark}"),
    }
}

fn block(meaning: &MacroMeaning, names: &MacroNames, to: &Control) -> Option<String> {
    let grammar = to.table.lexicon.grammar;
    Some(match meaning {
        MacroMeaning::Nothing => String::new(),
        MacroMeaning::Assign(variable, tree) => {
            format!("{}={}", names.variable(*variable)?, infix(tree, names, grammar)?)
        }
        MacroMeaning::If(condition, then) => {
            let condition = infix(condition, names, grammar)?;
            let then = block(then, names, to)?;
            let word = if then.starts_with("GOTO") { "" } else { "THEN " };
            format!("IF [{condition}] {word}{then}")
        }
        MacroMeaning::Goto(label) => format!("GOTO {}", names.label(label)?),
        MacroMeaning::Label(label) => format!("N{}", names.label(label)?),
        MacroMeaning::While(..) | MacroMeaning::End(_) | MacroMeaning::Print => return None,
    })
}

fn lines(
    meaning: &MacroMeaning,
    names: &MacroNames,
    at: usize,
    to: &Control,
) -> Option<Vec<String>> {
    let grammar = to.table.lexicon.grammar;
    let goto = |label: &JumpLabel| match label {
        JumpLabel::Number(number) => format!("GOTO N{number}"),
        JumpLabel::Name(name) => format!("GOTO :{name}"),
    };
    Some(match meaning {
        MacroMeaning::Nothing => Vec::new(),
        MacroMeaning::Assign(variable, tree) => {
            let (to, value) = (names.variable(*variable)?, infix(tree, names, grammar)?);
            vec![format!("# {to}={value}")]
        }
        MacroMeaning::If(condition, then) => {
            let condition = infix(condition, names, grammar)?;
            let then = match then.as_ref() {
                MacroMeaning::Goto(label) => goto(label),
                then => lines(then, names, at, to)?.pop()?.trim_start_matches("# ").to_string(),
            };
            vec![format!("# IF {condition} THEN {then}")]
        }
        MacroMeaning::Goto(label) => vec![format!("# {}", goto(label))],
        MacroMeaning::Label(_) | MacroMeaning::Print => return None,
        MacroMeaning::While(condition, _) => {
            let name = names.loop_at(at)?;
            let ends = infix(&condition.inverted()?, names, grammar)?;
            vec![format!("#:LOOP{name}"), format!("# IF {ends} THEN GOTO :END{name}")]
        }
        MacroMeaning::End(_) => {
            let name = names.loop_at(at)?;
            vec![format!("# GOTO :LOOP{name}"), format!("#:END{name}")]
        }
    })
}

/// An expression that stands alone.
pub(super) fn expression(
    tree: &ExpressionTree,
    names: &MacroNames,
    to: &Control,
) -> Option<String> {
    infix(tree, names, to.table.lexicon.grammar)
}

/// An expression after an address letter.
pub(super) fn value(tree: &ExpressionTree, names: &MacroNames, to: &Control) -> Option<String> {
    let grammar = to.table.lexicon.grammar;
    let text = infix(tree, names, grammar)?;
    let is_bracketed = match tree {
        ExpressionTree::Binary(..) => true,
        ExpressionTree::Negate(one) => matches!(one.as_ref(), ExpressionTree::Binary(..)),
        _ => false,
    };
    Some(if is_bracketed { bracketed(&text, grammar) } else { text })
}

fn infix(tree: &ExpressionTree, names: &MacroNames, grammar: &MacroGrammar) -> Option<String> {
    part(tree, names, grammar).map(|(text, _)| text)
}

/// A text and how tightly its loosest operator binds.
fn part(tree: &ExpressionTree, names: &MacroNames, grammar: &MacroGrammar) -> Option<(String, u8)> {
    Some(match tree {
        ExpressionTree::Number(text) => (text.clone(), TIGHTEST),
        ExpressionTree::Variable(variable) => (names.variable(*variable)?.to_string(), TIGHTEST),
        ExpressionTree::Negate(one) => {
            let (text, level) = part(one, names, grammar)?;
            let is_plain = level == TIGHTEST && !text.starts_with('-');
            let text = if is_plain { text } else { bracketed(&text, grammar) };
            (format!("-{text}"), 0)
        }
        ExpressionTree::Call(function, one) => {
            let names_of = grammar.functions.iter();
            let (name, _) = names_of.into_iter().find(|(_, own)| own == function)?;
            let (text, _) = part(one, names, grammar)?;
            (format!("{name}{}", bracketed(&text, grammar)), TIGHTEST)
        }
        ExpressionTree::Binary(operator, one, other) => {
            let row = grammar.operators.iter().find(|row| row.operator == *operator)?;
            let side = |tree: &ExpressionTree, least: u8| {
                let (text, level) = part(tree, names, grammar)?;
                // A sign after an operator is in brackets on every control.
                Some(if level < least { bracketed(&text, grammar) } else { text })
            };
            let (left, right) = (side(one, row.level)?, side(other, row.level + 1)?);
            let gap =
                if row.text.starts_with(|c: char| c.is_ascii_alphabetic()) { " " } else { "" };
            (format!("{left}{gap}{}{gap}{right}", row.text), row.level)
        }
    })
}

fn bracketed(text: &str, grammar: &MacroGrammar) -> String {
    match grammar.brackets {
        BracketStyle::Square => format!("[{text}]"),
        BracketStyle::Round => format!("({text})"),
    }
}
