//! FN, and parameters that get a value.

use super::ast::{JumpComparison, JumpCondition, KlartextFaultKind, KlartextStatement};
use super::cursor::TokenCursor;
use super::formulas::{formula, text_formula};
use super::labels::label_name;
use super::operands::{ParameterBank, WordOperand};
use super::words::unread_token;

/// `Q1 = …`, `QS1 = …`.
pub fn assignment(cursor: &mut TokenCursor<'_>) -> KlartextStatement {
    let Some(target) = cursor.take_parameter() else { return unreadable(cursor) };
    if !cursor.take_sign(b'=') {
        return unreadable(cursor);
    }
    if target.bank == ParameterBank::Text {
        let parts = text_formula(cursor);
        cursor.take_rest();
        return KlartextStatement::AssignText { target: target.number, parts };
    }
    match formula(cursor) {
        Some(formula) => KlartextStatement::Assign { target, formula },
        None => KlartextStatement::Unknown,
    }
}

/// What stands after FN.
pub fn numbered_function(cursor: &mut TokenCursor<'_>) -> KlartextStatement {
    let Some(number) = cursor.take_whole() else { return unreadable(cursor) };
    cursor.take_sign(b':');
    match number {
        0..=8 | 13 => assignment(cursor),
        9..=12 => jump(cursor),
        14 => {
            if !cursor.take_word("ERROR") || !cursor.take_sign(b'=') {
                return unreadable(cursor);
            }
            cursor.take_operand().map_or(KlartextStatement::Unknown, KlartextStatement::RaiseError)
        }
        18 => system_read(cursor),
        _ => {
            let target = cursor.take_parameter().filter(|_| cursor.take_sign(b'='));
            cursor.take_rest();
            KlartextStatement::OtherFunction { number, target }
        }
    }
}

fn jump(cursor: &mut TokenCursor<'_>) -> KlartextStatement {
    jump_of(cursor).unwrap_or_else(|| unreadable(cursor))
}

/// `IF +Q1 EQU +3 GOTO LBL 5`.
fn jump_of(cursor: &mut TokenCursor<'_>) -> Option<KlartextStatement> {
    if !cursor.take_word("IF") {
        return None;
    }
    let first = cursor.take_operand()?;
    let condition = if cursor.take_word("IS") {
        let WordOperand::Parameter { name, .. } = first else { return None };
        match () {
            () if cursor.take_word("DEFINED") => JumpCondition::Defined(name, true),
            () if cursor.take_word("UNDEFINED") => JumpCondition::Defined(name, false),
            () => return None,
        }
    } else {
        let comparison = match cursor.peek_word()? {
            "EQU" => JumpComparison::Equal,
            "NE" => JumpComparison::NotEqual,
            "GT" => JumpComparison::Greater,
            "LT" => JumpComparison::Less,
            _ => return None,
        };
        cursor.take();
        JumpCondition::Compared(first, comparison, cursor.take_operand()?)
    };
    if !(cursor.take_word("GOTO") && cursor.take_word("LBL")) {
        return None;
    }
    let label = label_name(cursor)?;
    while !cursor.is_at_end() {
        unread_token(cursor);
    }
    Some(KlartextStatement::Jump { condition, label })
}

/// `SYSREAD Q1 = ID20 NR1 IDX3`.
fn system_read(cursor: &mut TokenCursor<'_>) -> KlartextStatement {
    cursor.take_word("SYSREAD");
    let Some(target) = cursor.take_parameter() else { return unreadable(cursor) };
    if !cursor.take_sign(b'=') {
        return unreadable(cursor);
    }
    let numbers = system_numbers(cursor);
    while !cursor.is_at_end() {
        unread_token(cursor);
    }
    KlartextStatement::SystemRead { target, numbers }
}

/// ID, NR and IDX of FN 18.
pub fn system_numbers(cursor: &mut TokenCursor<'_>) -> [Option<WordOperand>; 3] {
    let mut numbers = [None; 3];
    while let Some(word) = cursor.peek_word() {
        let Some(place) = ["ID", "NR", "IDX"].iter().position(|name| *name == word) else { break };
        cursor.take();
        numbers[place] = cursor.take_operand();
    }
    numbers
}

fn unreadable(cursor: &mut TokenCursor<'_>) -> KlartextStatement {
    let rest = cursor.rest();
    let message = match rest.is_empty() {
        true => "this block ends too early".to_string(),
        false => format!("`{}` is not expected here", cursor.shown(rest)),
    };
    cursor.take_rest();
    cursor.fault(KlartextFaultKind::Unreadable, rest, message);
    KlartextStatement::Unknown
}
