//! CYCL DEF: cycles whose data are parameters, and those whose data stand on numbered lines.

use chordal_diagnostics::TextRange;
use chordal_geometry::TurnDirection;

use super::ast::{CycleValue, CycleWord, KlartextFaultKind, KlartextStatement};
use super::cursor::TokenCursor;
use super::operands::WordOperand;
use super::tokens::KlartextTokenKind;

/// What stands after CYCL DEF.
pub fn cycle_definition(cursor: &mut TokenCursor<'_>) -> KlartextStatement {
    let Some((number, line)) = cycle_number(cursor) else {
        let rest = cursor.take_rest();
        cursor.fault(KlartextFaultKind::Unreadable, rest, "the number of the cycle is missing");
        return KlartextStatement::Unknown;
    };
    match line {
        Some(line) => {
            let rest = cursor.rest();
            // The first line has the name of the cycle in the language of the shop.
            let words = if line == 0 { Vec::new() } else { cycle_words(cursor) };
            cursor.take_rest();
            KlartextStatement::CycleLine { number, line, words, rest }
        }
        None => KlartextStatement::CycleParameters { number, values: parameters(cursor) },
    }
}

/// `200`, `7.1`, `9 .0`: the cycle and the line of its data.
fn cycle_number(cursor: &mut TokenCursor<'_>) -> Option<(u32, Option<u32>)> {
    let whole = |text: &str| text.parse::<u32>().ok();
    let token = cursor.peek()?;
    let KlartextTokenKind::Number(_) = token.kind else { return None };
    cursor.take();
    let text = cursor.shown(token.range);
    if let Some((number, line)) = text.split_once('.') {
        return Some((whole(number)?, Some(whole(line)?)));
    }
    let number = whole(&text)?;
    let line = cursor.peek().and_then(|next| {
        let text = cursor.shown(next.range);
        whole(text.strip_prefix('.')?)
    });
    if line.is_some() {
        cursor.take();
    }
    Some((number, line))
}

/// The parameters of a cycle; its name, in the language of the shop, is left out.
pub fn parameters(cursor: &mut TokenCursor<'_>) -> Vec<(u32, CycleValue, TextRange)> {
    let mut values: Vec<(u32, CycleValue, TextRange)> = Vec::new();
    while let Some(token) = cursor.peek() {
        let is_set = matches!(
            cursor.peek_after(2).map(|token| &token.kind),
            Some(KlartextTokenKind::Sign(b'='))
        );
        let Some(name) = is_set.then(|| cursor.take_parameter()).flatten() else {
            cursor.take();
            continue;
        };
        cursor.take_sign(b'=');
        let value = match cursor.peek_word() {
            Some("MAX" | "FMAX") => CycleValue::Max,
            Some("AUTO" | "FAUTO") => CycleValue::OfTool,
            _ => cursor.take_operand().map_or(CycleValue::Other, CycleValue::Operand),
        };
        if matches!(value, CycleValue::Max | CycleValue::OfTool) {
            cursor.take();
        }
        let range = cursor.range_from(token.range);
        if values.iter().any(|(number, ..)| *number == name.number) {
            let message = format!("Q{} stands twice in this cycle", name.number);
            cursor.fault(KlartextFaultKind::DoubleWord, range, message);
        }
        values.push((name.number, value, range));
    }
    values
}

/// The words of a line of the data of a cycle: letters, perhaps several words of them, and a value.
fn cycle_words(cursor: &mut TokenCursor<'_>) -> Vec<CycleWord> {
    let mut words: Vec<CycleWord> = Vec::new();
    while let Some(token) = cursor.peek() {
        match &token.kind {
            KlartextTokenKind::Word(word) if cursor.peek_word() == Some("DR") => {
                cursor.take();
                let direction = match () {
                    () if cursor.take_sign(b'+') => Some(TurnDirection::Ccw),
                    () if cursor.take_sign(b'-') => Some(TurnDirection::Cw),
                    () => None,
                };
                let range = cursor.range_from(token.range);
                words.push(CycleWord { label: word.clone(), value: None, direction, range });
            }
            KlartextTokenKind::Word(word) => {
                // A parameter is a value, any other word the name of one.
                if let Some(value) = cursor.take_operand() {
                    add_value(&mut words, value, cursor.range_from(token.range));
                    continue;
                }
                cursor.take();
                let word = CycleWord {
                    label: word.clone(),
                    value: None,
                    direction: None,
                    range: token.range,
                };
                words.push(word);
            }
            KlartextTokenKind::Sign(b'#') => {
                cursor.take();
                let range = token.range;
                words.push(CycleWord { label: "#".into(), value: None, direction: None, range });
            }
            _ => {
                let Some(value) = cursor.take_operand() else {
                    cursor.take();
                    continue;
                };
                add_value(&mut words, value, cursor.range_from(token.range));
            }
        }
    }
    words
}

/// Gives a value to the last word, or makes a word without letters of it.
fn add_value(words: &mut Vec<CycleWord>, value: WordOperand, range: TextRange) {
    if let Some(last) = words.last_mut().filter(|last| last.value.is_none()) {
        last.value = Some(value);
        last.range = last.range.cover(range);
        return;
    }
    words.push(CycleWord { label: String::new(), value: Some(value), direction: None, range });
}
