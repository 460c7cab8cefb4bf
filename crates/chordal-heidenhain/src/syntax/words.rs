//! The words of blocks that move: coordinates, polar words, radius, feed, compensation, M functions.

use chordal_command::CompensationSide;
use chordal_diagnostics::TextRange;
use chordal_geometry::TurnDirection;

use super::ast::{AXIS_WORDS, FeedValue, FeedWord, KlartextFaultKind, MachineFunction, PathWords};
use super::cursor::TokenCursor;
use super::operands::OperandWord;
use super::tokens::KlartextTokenKind;

/// Reads the words up to the end of the block.
pub fn path_words(cursor: &mut TokenCursor<'_>) -> PathWords {
    let mut words = PathWords::default();
    while !cursor.is_at_end() {
        if !path_word(cursor, &mut words) {
            unread_token(cursor);
        }
    }
    words
}

/// A token that no word begins with: it is reported and left out.
pub fn unread_token(cursor: &mut TokenCursor<'_>) {
    let Some(token) = cursor.take() else { return };
    let before = token.range.start.checked_sub(1);
    let byte = |at: u32| cursor.text.get(at as usize).copied().unwrap_or(b' ');
    let follows_digit = before.is_some_and(|at| byte(at).is_ascii_digit());
    let mut range = token.range;
    let is_word = matches!(token.kind, KlartextTokenKind::Word(_));
    // The number of an unknown word is part of it: one fault, not two.
    if is_word
        && !follows_digit
        && let Some(next) = cursor.peek()
        && matches!(next.kind, KlartextTokenKind::Number(_))
        && next.range.start == range.end
    {
        cursor.take();
        range = range.cover(next.range);
    }
    let shown = cursor.shown(range);
    let (kind, message) = match &token.kind {
        KlartextTokenKind::Word(word) if follows_digit && matches!(word.as_str(), "O" | "I") => {
            let digit = if word == "O" { "0" } else { "1" };
            let message = format!(
                "the letter {word} stands in a number, where the digit {digit} was probably meant"
            );
            (KlartextFaultKind::LetterForDigit, message)
        }
        KlartextTokenKind::Number(_) => {
            (KlartextFaultKind::MissingAddress, format!("the number {shown} has no word before it"))
        }
        _ => (KlartextFaultKind::Unreadable, format!("`{shown}` is not read in this block")),
    };
    cursor.fault(kind, range, message);
}

/// Reads one word; false, with nothing taken, if none begins here.
pub fn path_word(cursor: &mut TokenCursor<'_>, words: &mut PathWords) -> bool {
    let Some(token) = cursor.peek() else { return false };
    let KlartextTokenKind::Word(word) = &token.kind else { return false };
    let range = token.range;
    if feed_word(cursor, words) || function_word(cursor, &mut words.functions) {
        return true;
    }
    if let Some(side) = side_of(cursor, word) {
        cursor.take();
        if matches!(side, CompensationSide::Off) {
            cursor.take();
        }
        let range = cursor.range_from(range);
        put(cursor, &mut words.side, (side, range), range);
        return true;
    }
    if word == "DR" {
        cursor.take();
        let direction = match () {
            () if cursor.take_sign(b'+') => TurnDirection::Ccw,
            () if cursor.take_sign(b'-') => TurnDirection::Cw,
            () => {
                cursor.fault(KlartextFaultKind::MissingValue, range, "DR has no sign");
                return true;
            }
        };
        let range = cursor.range_from(range);
        put(cursor, &mut words.direction, (direction, range), range);
        return true;
    }
    let (name, is_incremental) = match word.strip_prefix('I') {
        Some(name) if !name.is_empty() => (name, true),
        _ => (word.as_str(), false),
    };
    let place: Option<fn(&mut PathWords) -> &mut Option<OperandWord>> = match name {
        "PR" => Some(|words| &mut words.polar_radius),
        "PA" => Some(|words| &mut words.polar_angle),
        "R" if !is_incremental => Some(|words| &mut words.radius),
        "LEN" if !is_incremental => Some(|words| &mut words.length),
        "CCA" if !is_incremental => Some(|words| &mut words.center_angle),
        "TX" => Some(|words| &mut words.tool_vector[0]),
        "TY" => Some(|words| &mut words.tool_vector[1]),
        "TZ" => Some(|words| &mut words.tool_vector[2]),
        _ => None,
    };
    // The normal of the surface corrects the path of tools that differ from those of the CAM system (DR, DR2), and
    // nothing else.
    if matches!(name, "NX" | "NY" | "NZ") {
        cursor.take();
        cursor.operand_of(range, false);
        return true;
    }
    let axis = AXIS_WORDS.iter().position(|axis| *axis == name);
    if place.is_none() && axis.is_none() {
        return false;
    }
    cursor.take();
    let Some(value) = cursor.operand_of(range, is_incremental) else { return true };
    let target = match (place, axis) {
        (Some(place), _) => place(words),
        (None, axis) => &mut words.axes[axis.unwrap_or_default()],
    };
    let (is_double, range) = (target.is_some(), value.range);
    *target = target.or(Some(value));
    if is_double {
        let message = format!("{name} is programmed twice in this block");
        cursor.fault(KlartextFaultKind::DoubleWord, range, message);
    }
    true
}

/// Keeps the first of two words.
fn put<T>(cursor: &mut TokenCursor<'_>, place: &mut Option<T>, value: T, range: TextRange) {
    if place.is_none() {
        *place = Some(value);
        return;
    }
    let message = format!("`{}` is one too many in this block", cursor.shown(range));
    cursor.fault(KlartextFaultKind::DoubleWord, range, message);
}

/// The side of R0, RL and RR; R with another value is a radius.
fn side_of(cursor: &TokenCursor<'_>, word: &str) -> Option<CompensationSide> {
    match word {
        "RL" => Some(CompensationSide::Left),
        "RR" => Some(CompensationSide::Right),
        "R" => {
            let next = cursor.peek_after(1)?;
            (next.range.slice(cursor.text) == b"0").then_some(CompensationSide::Off)
        }
        _ => None,
    }
}

/// Reads a feed: F, FMAX, FAUTO, FU, FZ, FT, FMAXT; false if none begins here.
fn feed_word(cursor: &mut TokenCursor<'_>, words: &mut PathWords) -> bool {
    let Some(feed) = take_feed(cursor) else { return false };
    if let Some(feed) = feed {
        let range = feed.range;
        put(cursor, &mut words.feed, feed, range);
    }
    true
}

/// Takes a feed; `None` if none begins here, `Some(None)` if it has no value.
pub fn take_feed(cursor: &mut TokenCursor<'_>) -> Option<Option<FeedWord>> {
    let token = cursor.peek()?;
    let KlartextTokenKind::Word(word) = &token.kind else { return None };
    let (value, count) = match (word.as_str(), cursor.word_after(1)) {
        ("FMAX", _) => (Some(FeedValue::Rapid), 1),
        ("FMAXT" | "FT", _) => (Some(FeedValue::Time), 1),
        ("FAUTO", _) => (Some(FeedValue::OfTool), 1),
        ("F", Some("MAX")) => (Some(FeedValue::Rapid), 2),
        ("F", Some("AUTO")) => (Some(FeedValue::OfTool), 2),
        ("F" | "FU" | "FZ", _) => (None, 1),
        _ => return None,
    };
    for _ in 0..count {
        cursor.take();
    }
    if let Some(value) = value {
        if value == FeedValue::Time {
            cursor.take_operand();
        }
        return Some(Some(FeedWord { value, range: cursor.range_from(token.range) }));
    }
    let Some(operand) = cursor.operand_of(token.range, false) else { return Some(None) };
    let value = match word.as_str() {
        "FU" => FeedValue::PerRevolution(operand.value),
        "FZ" => FeedValue::PerTooth(operand.value),
        _ => FeedValue::Value(operand.value),
    };
    Some(Some(FeedWord { value, range: operand.range }))
}

/// Reads an M function with what belongs to it; false if none begins here.
pub fn function_word(cursor: &mut TokenCursor<'_>, functions: &mut Vec<MachineFunction>) -> bool {
    let Some(token) = cursor.peek() else { return false };
    if token.kind != KlartextTokenKind::Word("M".to_string()) {
        return false;
    }
    cursor.take();
    let Some(number) = cursor.take_whole() else {
        cursor.fault(KlartextFaultKind::MissingValue, token.range, "M has no number");
        return true;
    };
    let (mut value, mut is_max) = (None, false);
    // What the function takes; for M103 and M128 a feed that is not that of the block.
    let word = match number {
        140 => "MB",
        103 | 128 => "F",
        120 => "LA",
        118 => "",
        _ => " ",
    };
    if number == 118 {
        while matches!(cursor.peek_word(), Some("X" | "Y" | "Z" | "A" | "B" | "C")) {
            cursor.take();
            cursor.take_operand();
        }
    } else if cursor.take_word(word) {
        is_max = cursor.take_word("MAX");
        value = if is_max { None } else { cursor.take_operand() };
    }
    let range = cursor.range_from(token.range);
    functions.push(MachineFunction { number, value, is_max, range });
    true
}
