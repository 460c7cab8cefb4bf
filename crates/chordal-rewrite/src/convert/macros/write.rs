//! Statements in the words of a control.

use chordal::control::Control;
use chordal::control::macros::{LONGEST_LINE, MacroForm};
use chordal::syntax::{Brackets, MacroGrammar};

use super::meaning::{Label, Meaning};
use super::names::Names;
use super::tree::Tree;
use crate::source::Style;

/// What binds tighter than all operators.
const TIGHTEST: u8 = u8::MAX;

/// The lines of a statement; nothing where the control has no form for it.
pub(super) fn statement(
    meaning: &Meaning,
    names: &Names,
    at: usize,
    to: &Control,
) -> Option<Vec<String>> {
    match to.macros.form {
        MacroForm::Lines => lines(meaning, names, at, to)
            .filter(|lines| lines.iter().all(|line| line.len() <= LONGEST_LINE)),
        MacroForm::Blocks => Some(vec![block(meaning, names, to)?]),
        MacroForm::None | MacroForm::OWords => None,
    }
}

/// The lines with the number that the block had.
pub(super) fn numbered(
    mut lines: Vec<String>,
    number: Option<String>,
    to: &Control,
    style: Style,
) -> Vec<String> {
    let Some(number) = number else { return lines };
    match (to.macros.form, lines.first_mut()) {
        // A macro line begins with its mark.
        (MacroForm::Lines, _) => lines.insert(0, number),
        (_, Some(first)) => {
            *first = format!("{number}{}{first}", if style.spaced { " " } else { "" });
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

fn block(meaning: &Meaning, names: &Names, to: &Control) -> Option<String> {
    let grammar = to.table.lexicon.grammar;
    Some(match meaning {
        Meaning::Nothing => String::new(),
        Meaning::Assign(variable, tree) => {
            format!("{}={}", names.variable(*variable)?, infix(tree, names, grammar)?)
        }
        Meaning::If(condition, then) => {
            let condition = infix(condition, names, grammar)?;
            let then = block(then, names, to)?;
            let word = if then.starts_with("GOTO") { "" } else { "THEN " };
            format!("IF [{condition}] {word}{then}")
        }
        Meaning::Goto(label) => format!("GOTO {}", names.label(label)?),
        Meaning::Label(label) => format!("N{}", names.label(label)?),
        Meaning::While(..) | Meaning::End(_) | Meaning::Print => return None,
    })
}

fn lines(meaning: &Meaning, names: &Names, at: usize, to: &Control) -> Option<Vec<String>> {
    let grammar = to.table.lexicon.grammar;
    let goto = |label: &Label| match label {
        Label::Number(number) => format!("GOTO N{number}"),
        Label::Name(name) => format!("GOTO :{name}"),
    };
    Some(match meaning {
        Meaning::Nothing => Vec::new(),
        Meaning::Assign(variable, tree) => {
            let (to, value) = (names.variable(*variable)?, infix(tree, names, grammar)?);
            vec![format!("# {to}={value}")]
        }
        Meaning::If(condition, then) => {
            let condition = infix(condition, names, grammar)?;
            let then = match then.as_ref() {
                Meaning::Goto(label) => goto(label),
                then => lines(then, names, at, to)?.pop()?.trim_start_matches("# ").to_string(),
            };
            vec![format!("# IF {condition} THEN {then}")]
        }
        Meaning::Goto(label) => vec![format!("# {}", goto(label))],
        Meaning::Label(_) | Meaning::Print => return None,
        Meaning::While(condition, _) => {
            let name = names.loop_at(at)?;
            let ends = infix(&condition.inverted()?, names, grammar)?;
            vec![format!("#:LOOP{name}"), format!("# IF {ends} THEN GOTO :END{name}")]
        }
        Meaning::End(_) => {
            let name = names.loop_at(at)?;
            vec![format!("# GOTO :LOOP{name}"), format!("#:END{name}")]
        }
    })
}

/// An expression that stands alone.
pub(super) fn expression(tree: &Tree, names: &Names, to: &Control) -> Option<String> {
    infix(tree, names, to.table.lexicon.grammar)
}

/// An expression after an address letter.
pub(super) fn value(tree: &Tree, names: &Names, to: &Control) -> Option<String> {
    let grammar = to.table.lexicon.grammar;
    let text = infix(tree, names, grammar)?;
    let is_bracketed = match tree {
        Tree::Binary(..) => true,
        Tree::Negate(one) => matches!(one.as_ref(), Tree::Binary(..)),
        _ => false,
    };
    Some(if is_bracketed { bracketed(&text, grammar) } else { text })
}

fn infix(tree: &Tree, names: &Names, grammar: &MacroGrammar) -> Option<String> {
    part(tree, names, grammar).map(|(text, _)| text)
}

/// A text and how tightly its loosest operator binds.
fn part(tree: &Tree, names: &Names, grammar: &MacroGrammar) -> Option<(String, u8)> {
    Some(match tree {
        Tree::Number(text) => (text.clone(), TIGHTEST),
        Tree::Variable(variable) => (names.variable(*variable)?.to_string(), TIGHTEST),
        Tree::Negate(one) => {
            let (text, level) = part(one, names, grammar)?;
            let is_plain = level == TIGHTEST && !text.starts_with('-');
            let text = if is_plain { text } else { bracketed(&text, grammar) };
            (format!("-{text}"), 0)
        }
        Tree::Call(function, one) => {
            let names_of = grammar.functions.iter();
            let (name, _) = names_of.into_iter().find(|(_, own)| own == function)?;
            let (text, _) = part(one, names, grammar)?;
            (format!("{name}{}", bracketed(&text, grammar)), TIGHTEST)
        }
        Tree::Binary(operator, one, other) => {
            let row = grammar.operators.iter().find(|row| row.operator == *operator)?;
            let side = |tree: &Tree, least: u8| {
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
        Brackets::Square => format!("[{text}]"),
        Brackets::Round => format!("({text})"),
    }
}
