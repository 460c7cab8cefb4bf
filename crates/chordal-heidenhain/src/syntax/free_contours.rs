//! Blocks of free contours: FPOL, FL, FLT, FC, FCT.

use chordal_diagnostics::TextRange;

use super::ast::{FreeElementWords, KlartextFaultKind, KlartextStatement};
use super::cursor::TokenCursor;
use super::free_words::{FreePointWords, FreeRelation, FreeRelationWord};
use super::operands::OperandWord;
use super::tokens::KlartextTokenKind;
use super::words::{path_word, path_words, unread_token};

/// The words that refer to another block.
const RELATIONS: [(&str, FreeRelation); 12] = [
    ("RX", FreeRelation::Coordinate(0)),
    ("RY", FreeRelation::Coordinate(1)),
    ("RZ", FreeRelation::Coordinate(2)),
    ("RPR", FreeRelation::Polar(0)),
    ("RPA", FreeRelation::Polar(1)),
    ("RAN", FreeRelation::Angle),
    ("PAR", FreeRelation::Parallel),
    ("RCCX", FreeRelation::Center(0)),
    ("RCCY", FreeRelation::Center(1)),
    ("RCCZ", FreeRelation::Center(2)),
    ("RCCPR", FreeRelation::CenterPolar(0)),
    ("RCCPA", FreeRelation::CenterPolar(1)),
];

/// Reads a block from its first word; `None` for another one.
pub fn free_contour(cursor: &mut TokenCursor<'_>) -> Option<KlartextStatement> {
    let (is_arc, is_tangent) = match cursor.peek_word()? {
        "FPOL" => {
            cursor.take();
            return Some(KlartextStatement::FreePole(Box::new(path_words(cursor))));
        }
        "FSELECT" => return free_selection(cursor),
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

fn free_selection(cursor: &mut TokenCursor<'_>) -> Option<KlartextStatement> {
    let word = cursor.take()?;
    let number = cursor.operand_of(word.range, false);
    while !cursor.is_at_end() {
        unread_token(cursor);
    }
    Some(number.map_or(KlartextStatement::Unknown, KlartextStatement::FreeSelection))
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
    if word == "P" && cursor.word_after(2).is_some() {
        auxiliary_word(cursor, words, token.range);
        return true;
    }
    if let Some((_, relation)) = RELATIONS.iter().find(|(name, _)| name == word) {
        relation_word(cursor, words, *relation, token.range);
        return true;
    }
    // A sign in front of an axis or an angle: ICCX, IAN.
    let (name, is_incremental) = match word.strip_prefix('I') {
        Some(name) => (name, true),
        None => (word.as_str(), false),
    };
    let Some(place) = value_place(words, name) else { return false };
    cursor.take();
    if let Some(value) = cursor.operand_of(token.range, is_incremental) {
        if place.is_some() {
            let message = format!("{name} is programmed twice in this block");
            cursor.fault(KlartextFaultKind::DoubleWord, value.range, message);
        }
        *place = place.or(Some(value));
    }
    true
}

/// The place of a word by its name; `None` for one that only other blocks have.
fn value_place<'w>(
    words: &'w mut FreeElementWords,
    name: &str,
) -> Option<&'w mut Option<OperandWord>> {
    Some(match name {
        "AN" => &mut words.angle,
        "CCX" => &mut words.center[0],
        "CCY" => &mut words.center[1],
        "CCZ" => &mut words.center[2],
        "CCPR" => &mut words.center_polar[0],
        "CCPA" => &mut words.center_polar[1],
        "D" => &mut words.distance,
        "DP" => &mut words.parallel_distance,
        name => return point_place(&mut words.distance_point, name.strip_prefix("PD")?),
    })
}

/// The place of a coordinate of a point.
fn point_place<'w>(
    point: &'w mut FreePointWords,
    name: &str,
) -> Option<&'w mut Option<OperandWord>> {
    Some(match name {
        "X" => &mut point.axes[0],
        "Y" => &mut point.axes[1],
        "Z" => &mut point.axes[2],
        "PR" => &mut point.polar[0],
        "PA" => &mut point.polar[1],
        _ => return None,
    })
}

/// P1X to P3Y, P1PR to P3PA: the number of the point and the coordinate after P.
fn auxiliary_word(cursor: &mut TokenCursor<'_>, words: &mut FreeElementWords, start: TextRange) {
    cursor.take();
    let number = cursor.take_whole();
    let name = cursor.peek_word().unwrap_or_default();
    let point =
        number.and_then(|number| words.auxiliary.get_mut((number as usize).checked_sub(1)?));
    let Some(place) = point.and_then(|point| point_place(point, name)) else {
        let range = cursor.range_from(start);
        let message = format!(
            "`{}` is no point of a free contour: P1 to P3 with X, Y, PR or PA",
            cursor.shown(range)
        );
        cursor.fault(KlartextFaultKind::Unreadable, range, message);
        cursor.take();
        cursor.take_operand();
        return;
    };
    cursor.take();
    let range = cursor.range_from(start);
    *place = cursor.operand_of(range, false);
}

/// RX20, or RX N20 for the block that it refers to.
fn relation_word(
    cursor: &mut TokenCursor<'_>,
    words: &mut FreeElementWords,
    relation: FreeRelation,
    start: TextRange,
) {
    cursor.take();
    cursor.take_word("N");
    let block = cursor.take_whole();
    let range = cursor.range_from(start);
    match block {
        Some(block) => words.relations.push(FreeRelationWord { relation, block, range }),
        None => {
            let message = format!("`{}` has no block number", cursor.shown(range));
            cursor.fault(KlartextFaultKind::MissingValue, range, message);
        }
    }
}
