//! Blocks of free contours: FPOL, FL, FLT, FC, FCT.

use super::ast::{FreeElementWords, KlartextFaultKind, KlartextStatement};
use super::cursor::TokenCursor;
use super::operands::OperandWord;
use super::tokens::KlartextTokenKind;
use super::words::{path_word, path_words, unread_token};

/// Words that relate an element to a point or another element; each has a value.
const RELATIONS: [&str; 15] = [
    "PDX", "PDY", "PDPR", "PDPA", "D", "RX", "RY", "RPR", "RPA", "RAN", "PAR", "DP", "RCCX",
    "RCCY", "RCCPR",
];

/// Reads a block from its first word; `None` for another one.
pub fn free_contour(cursor: &mut TokenCursor<'_>) -> Option<KlartextStatement> {
    let (is_arc, is_tangent) = match cursor.peek_word()? {
        "FPOL" => {
            cursor.take();
            return Some(KlartextStatement::FreePole(Box::new(path_words(cursor))));
        }
        "FL" => (false, false),
        "FLT" => (false, true),
        "FC" => (true, false),
        "FCT" => (true, true),
        _ => return None,
    };
    cursor.take();
    let mut words = FreeElementWords { is_arc, is_tangent, ..FreeElementWords::default() };
    while !cursor.is_at_end() {
        if !free_word(cursor, &mut words) && !path_word(cursor, &mut words.words) {
            unread_token(cursor);
        }
    }
    Some(KlartextStatement::FreeElement(Box::new(words)))
}

/// Reads a word that only free contours have; false, with nothing taken, if none begins here.
fn free_word(cursor: &mut TokenCursor<'_>, words: &mut FreeElementWords) -> bool {
    let Some(token) = cursor.peek() else { return false };
    let KlartextTokenKind::Word(word) = &token.kind else { return false };
    if word == "CLSD" {
        cursor.take();
        let closes = cursor.take_sign(b'-');
        if !closes && !cursor.take_sign(b'+') {
            cursor.fault(KlartextFaultKind::MissingValue, token.range, "CLSD has no sign");
        }
        words.closing = Some(closes);
        return true;
    }
    // P1X to P3Y: points on the element.
    if word == "P" && cursor.word_after(2).is_some() {
        cursor.take();
        cursor.take_whole();
        cursor.take();
        cursor.take_operand();
        words.has_relation = true;
        return true;
    }
    if RELATIONS.contains(&word.as_str()) {
        cursor.take();
        // RX20, or RX N20 for the block that it refers to.
        cursor.take_word("N");
        cursor.take_operand();
        words.has_relation = true;
        return true;
    }
    let place: fn(&mut FreeElementWords) -> &mut Option<OperandWord> = match word.as_str() {
        "AN" => |words| &mut words.angle,
        "CCX" => |words| &mut words.center[0],
        "CCY" => |words| &mut words.center[1],
        "CCZ" => |words| &mut words.center[2],
        "CCPR" => |words| &mut words.center_polar[0],
        "CCPA" => |words| &mut words.center_polar[1],
        _ => return false,
    };
    cursor.take();
    if let Some(value) = cursor.operand_of(token.range, false) {
        *place(words) = Some(value);
    }
    true
}
