//! The statement of a block by its first words.

use chordal_diagnostics::TextRange;

use super::ast::{
    CycleCallForm, KlartextApproachForm, KlartextFaultKind, KlartextStatement, PathFunction,
    PatternGroup, ToolCallWords, ToolName, UnfollowedFunction,
};
use super::cursor::TokenCursor;
use super::cycles::cycle_definition;
use super::free_contours::free_contour;
use super::functions::{assignment, numbered_function};
use super::labels::label_name;
use super::operands::{OperandWord, ParameterBank, WordOperand};
use super::plane_words::plane_words;
use super::tokens::{KlartextToken, KlartextTokenKind};
use super::words::{function_word, path_words, take_feed, unread_token};

/// Reads the statement of a block from its first token to its last.
pub fn statement(cursor: &mut TokenCursor<'_>) -> KlartextStatement {
    let Some(first) = cursor.peek() else { return KlartextStatement::Nothing };
    let KlartextTokenKind::Word(word) = &first.kind else {
        if cursor.take_sign(b'*') {
            cursor.take_rest();
            return KlartextStatement::Nothing;
        }
        return unknown(cursor);
    };
    if let Some(function) = path_function(word) {
        cursor.take();
        return KlartextStatement::Path(function, Box::new(path_words(cursor)));
    }
    if let Some(found) = free_contour(cursor).or_else(|| two_words(cursor, word)) {
        return found;
    }
    match word.as_str() {
        "CC" => {
            cursor.take();
            KlartextStatement::Center(Box::new(path_words(cursor)))
        }
        "RND" => {
            cursor.take();
            // R may be left out.
            let bare = cursor.take_operand();
            let range = cursor.range_from(first.range);
            let mut words = Box::new(path_words(cursor));
            let bare = bare.map(|value| OperandWord { is_incremental: false, value, range });
            words.radius = words.radius.or(bare);
            KlartextStatement::Rounding(words)
        }
        "CHF" => {
            let word = first.range;
            cursor.take();
            let size = cursor.operand_of(word, false);
            KlartextStatement::Chamfer(size, Box::new(path_words(cursor)))
        }
        "STOP" => {
            cursor.take();
            KlartextStatement::Stop(Box::new(path_words(cursor)))
        }
        "LBL" => {
            cursor.take();
            let Some(name) = label_name(cursor) else {
                let range = cursor.rest().cover(first.range);
                cursor.take_rest();
                let message = "LBL has no number and no name";
                cursor.fault(KlartextFaultKind::MissingValue, range, message);
                return KlartextStatement::Unknown;
            };
            KlartextStatement::Label(name)
        }
        "M" => KlartextStatement::Functions(Box::new(path_words(cursor))),
        "LN" => {
            cursor.take();
            KlartextStatement::Path(PathFunction::Line, Box::new(path_words(cursor)))
        }
        "PLANE" => {
            cursor.take();
            KlartextStatement::Plane(Box::new(plane_words(cursor)))
        }
        "FUNCTION" => function(cursor),
        "SEL" => selection(cursor),
        "FN" => {
            cursor.take();
            numbered_function(cursor)
        }
        "Q" | "QL" | "QR" | "QS" => assignment(cursor),
        "X" | "Y" | "Z" | "A" | "B" | "C" | "U" | "V" | "W" | "IX" | "IY" | "IZ" | "IA" | "IB"
        | "IC" => KlartextStatement::Path(PathFunction::Repeated, Box::new(path_words(cursor))),
        _ => unknown(cursor),
    }
}

/// The path function of a word. C is an axis where a sign or a number follows.
fn path_function(word: &str) -> Option<PathFunction> {
    Some(match word {
        "L" => PathFunction::Line,
        "LP" => PathFunction::PolarLine,
        "CP" => PathFunction::PolarArc,
        "CR" => PathFunction::RadiusArc,
        "CT" => PathFunction::TangentArc,
        "CTP" => PathFunction::PolarTangentArc,
        _ => return None,
    })
}

/// Statements that begin with two words, and C, which is an axis, too.
fn two_words(cursor: &mut TokenCursor<'_>, word: &str) -> Option<KlartextStatement> {
    let second = cursor.word_after(1);
    let take_both = |cursor: &mut TokenCursor<'_>| {
        cursor.take();
        cursor.take();
    };
    Some(match (word, second) {
        ("C", Some(_)) if cursor.peek_after(1)?.range.start > cursor.peek()?.range.end => {
            cursor.take();
            KlartextStatement::Path(PathFunction::CenterArc, Box::new(path_words(cursor)))
        }
        ("BEGIN", Some("PGM")) => {
            take_both(cursor);
            let (name, is_inch) = program_head(cursor);
            KlartextStatement::Begin { name, is_inch }
        }
        ("END", Some("PGM")) => {
            take_both(cursor);
            let (name, is_inch) = program_head(cursor);
            KlartextStatement::End { name, is_inch }
        }
        ("BLK", Some("FORM")) => {
            take_both(cursor);
            blank(cursor)
        }
        ("TOOL", Some("CALL")) => {
            take_both(cursor);
            KlartextStatement::ToolCall(Box::new(tool_call(cursor)))
        }
        ("TOOL", Some("DEF")) => {
            take_both(cursor);
            tool_definition(cursor)
        }
        ("CALL", Some("LBL")) => {
            take_both(cursor);
            call_label(cursor)
        }
        ("CALL", Some("PGM")) => {
            take_both(cursor);
            KlartextStatement::CallProgram(cursor.take_rest())
        }
        ("CYCL", Some("CALL")) => {
            take_both(cursor);
            cycle_call(cursor)
        }
        ("CYCL" | "CYCLE", Some("DEF")) => {
            if word == "CYCLE" {
                let range = cursor.peek()?.range;
                let message = "the word is CYCL DEF; CYCLE DEF is read as that";
                cursor.fault(KlartextFaultKind::Spelling, range, message);
            }
            take_both(cursor);
            cycle_definition(cursor)
        }
        ("PATTERN", Some("DEF")) => {
            take_both(cursor);
            KlartextStatement::Pattern(pattern(cursor))
        }
        ("TRANS", Some("DATUM")) => {
            take_both(cursor);
            datum(cursor)
        }
        ("TCH", Some("PROBE")) => not_followed(cursor, UnfollowedFunction::Probe),
        ("DECLARE", Some("STRING")) => {
            take_both(cursor);
            assignment(cursor)
        }
        ("APPR" | "DEP", Some(form)) => {
            let form = approach_form(form)?;
            take_both(cursor);
            let words = Box::new(path_words(cursor));
            match word {
                "APPR" => KlartextStatement::Approach(form, words),
                _ => KlartextStatement::Departure(form, words),
            }
        }
        _ => return None,
    })
}

fn approach_form(word: &str) -> Option<KlartextApproachForm> {
    Some(match word {
        "LT" | "PLT" => KlartextApproachForm::Tangent,
        "LN" | "PLN" => KlartextApproachForm::Normal,
        "CT" | "PCT" => KlartextApproachForm::Arc,
        "LCT" | "PLCT" => KlartextApproachForm::LineAndArc,
        _ => return None,
    })
}

/// FUNCTION: TCPM is carried out; milling is the mode of a mill, and other functions that end here never began.
fn function(cursor: &mut TokenCursor<'_>) -> KlartextStatement {
    let words = (cursor.word_after(1), cursor.word_after(2));
    cursor.take_rest();
    match words {
        (Some("TCPM"), _) => KlartextStatement::ToolCenterPoint(true),
        (Some("RESET"), Some("TCPM")) => KlartextStatement::ToolCenterPoint(false),
        (Some("RESET" | "MODE"), _) => KlartextStatement::Nothing,
        _ => KlartextStatement::NotFollowed(UnfollowedFunction::Function),
    }
}

fn unknown(cursor: &mut TokenCursor<'_>) -> KlartextStatement {
    let first = cursor.peek().map(|token| token.range).unwrap_or_default();
    cursor.take_rest();
    let message = format!("`{}` begins no block of this language", cursor.shown(first));
    cursor.fault(KlartextFaultKind::UnknownFunction, first, message);
    KlartextStatement::Unknown
}

fn not_followed(cursor: &mut TokenCursor<'_>, what: UnfollowedFunction) -> KlartextStatement {
    cursor.take_rest();
    KlartextStatement::NotFollowed(what)
}

/// The name and the unit of BEGIN PGM and END PGM.
fn program_head(cursor: &mut TokenCursor<'_>) -> (TextRange, bool) {
    let rest = cursor.take_rest();
    let text = rest.slice(cursor.text);
    let unit = text.iter().rposition(u8::is_ascii_whitespace).map_or(0, |at| at + 1);
    let is_inch = text[unit..].eq_ignore_ascii_case(b"INCH");
    let has_unit = is_inch || text[unit..].eq_ignore_ascii_case(b"MM");
    if !has_unit {
        let message = "the unit MM or INCH is missing after the name: MM is assumed";
        cursor.fault(KlartextFaultKind::Spelling, rest, message);
        return (rest, false);
    }
    let name = text[..unit].trim_ascii_end().len() as u32;
    (TextRange::new(rest.start, rest.start + name), is_inch)
}

/// BLK FORM: the corners of a block are read, all other forms are the stock alone.
fn blank(cursor: &mut TokenCursor<'_>) -> KlartextStatement {
    let form = cursor.peek().map(|token| token.range.slice(cursor.text).to_vec());
    let corner = match form.as_deref() {
        Some(b"0.1" | b"0,1") => 1,
        Some(b"0.2" | b"0,2") => 2,
        _ => {
            cursor.take_rest();
            return KlartextStatement::Blank { corner: None, words: Box::default() };
        }
    };
    cursor.take();
    // The tool axis stands alone before the coordinates.
    let is_axis = matches!(cursor.peek_word(), Some("X" | "Y" | "Z"))
        && matches!(
            cursor.peek_after(1).map(|token| &token.kind),
            Some(KlartextTokenKind::Word(_)) | None
        );
    if is_axis {
        cursor.take();
    }
    KlartextStatement::Blank { corner: Some(corner), words: Box::new(path_words(cursor)) }
}

fn call_label(cursor: &mut TokenCursor<'_>) -> KlartextStatement {
    let Some(label) = label_name(cursor) else { return unknown(cursor) };
    let mut repeats = None;
    if cursor.take_word("REP") {
        repeats = cursor.take_operand();
        // The control shows how often it is still to run after the stroke.
        if cursor.take_sign(b'/') {
            cursor.take_operand();
        }
    }
    while !cursor.is_at_end() {
        unread_token(cursor);
    }
    KlartextStatement::CallLabel { label, repeats }
}

fn tool_call(cursor: &mut TokenCursor<'_>) -> ToolCallWords {
    let mut words = ToolCallWords::default();
    let start = cursor.rest();
    if let Some(KlartextToken { kind: KlartextTokenKind::Text(name), range }) = cursor.peek() {
        cursor.take();
        words.tool = Some((ToolName::Text(name.clone()), *range));
    } else if let Some(value) = cursor.take_operand() {
        let range = cursor.range_from(TextRange::new(start.start, start.start));
        let name = match value {
            WordOperand::Parameter { name, .. } if name.bank == ParameterBank::Text => {
                ToolName::Parameter(name.number)
            }
            other => ToolName::Number(other),
        };
        words.tool = Some((name, range));
    }
    while let Some(token) = cursor.peek() {
        if let Some(feed) = take_feed(cursor) {
            words.feed = words.feed.or(feed);
            continue;
        }
        if function_word(cursor, &mut words.functions) {
            continue;
        }
        let KlartextTokenKind::Word(word) = &token.kind else {
            unread_token(cursor);
            continue;
        };
        let allowance = ["DL", "DR"].iter().position(|name| name == word);
        match (word.as_str(), allowance) {
            ("X" | "Y" | "Z", _) => {
                cursor.take();
                words.axis = ["X", "Y", "Z"].iter().position(|axis| axis == word);
            }
            ("S", _) => {
                cursor.take();
                words.speed = cursor.operand_of(token.range, false).map(|word| word.value);
            }
            (_, Some(index)) => {
                cursor.take();
                // DR2 is one word, whose value begins with a sign.
                let is_second = index == 1
                    && matches!(
                        cursor.peek_after(1).map(|token| &token.kind),
                        Some(KlartextTokenKind::Sign(b'+' | b'-'))
                    )
                    && cursor.take_whole() == Some(2);
                let value = cursor.operand_of(token.range, false).map(|word| word.value);
                words.allowances[if is_second { 2 } else { index }] = value;
            }
            _ => unread_token(cursor),
        }
    }
    words
}

fn tool_definition(cursor: &mut TokenCursor<'_>) -> KlartextStatement {
    let Some(number) = cursor.take_operand() else {
        // By its name, or without one: it is only made ready.
        cursor.take_rest();
        return KlartextStatement::Nothing;
    };
    let (mut length, mut radius) = (None, None);
    while let Some(token) = cursor.peek() {
        let place = match cursor.peek_word() {
            Some("L") => &mut length,
            Some("R") => &mut radius,
            _ => {
                unread_token(cursor);
                continue;
            }
        };
        cursor.take();
        *place = cursor.operand_of(token.range, false).map(|word| word.value);
    }
    KlartextStatement::ToolDefinition { number, length, radius }
}

fn cycle_call(cursor: &mut TokenCursor<'_>) -> KlartextStatement {
    let form = match () {
        () if cursor.take_word("POS") => CycleCallForm::AtPosition,
        () if cursor.take_word("PAT") => CycleCallForm::AtPattern,
        () => CycleCallForm::Here,
    };
    KlartextStatement::CycleCall(form, Box::new(path_words(cursor)))
}

/// The groups of PATTERN DEF: a name, perhaps with a number, and words in brackets.
fn pattern(cursor: &mut TokenCursor<'_>) -> Vec<PatternGroup> {
    let mut groups = Vec::new();
    while let Some(token) = cursor.peek() {
        let Some(name) = cursor.peek_word() else {
            unread_token(cursor);
            continue;
        };
        cursor.take();
        cursor.take_whole();
        let mut words = Vec::new();
        if cursor.take_sign(b'(') {
            while !cursor.is_at_end() && !cursor.take_sign(b')') {
                let word = cursor.peek_word();
                match word {
                    Some(word) => {
                        cursor.take();
                        words.extend(cursor.take_operand().map(|value| (word.to_string(), value)));
                    }
                    None => unread_token(cursor),
                }
            }
        }
        let range = cursor.range_from(token.range);
        groups.push(PatternGroup { name: name.to_string(), words, range });
    }
    groups
}

/// SEL TABLE and its like.
fn selection(cursor: &mut TokenCursor<'_>) -> KlartextStatement {
    if cursor.word_after(1) == Some("TABLE") {
        cursor.take();
        cursor.take();
        return KlartextStatement::SelectDatumTable(cursor.take_rest());
    }
    not_followed(cursor, UnfollowedFunction::Selection)
}

/// TRANS DATUM AXIS, TRANS DATUM TABLE and TRANS DATUM RESET.
fn datum(cursor: &mut TokenCursor<'_>) -> KlartextStatement {
    if cursor.take_word("AXIS") {
        return KlartextStatement::DatumShift(Box::new(path_words(cursor)));
    }
    if cursor.take_word("RESET") {
        return KlartextStatement::DatumReset;
    }
    if cursor.take_word("TABLE") {
        // The words before the number are TABLINE, or on some controls TABLE LINE.
        while cursor.peek_word().is_some_and(|word| matches!(word, "TABLINE" | "LINE")) {
            cursor.take();
        }
        if let Some(line) = cursor.take_operand() {
            let table = (!cursor.is_at_end()).then(|| cursor.take_rest());
            return KlartextStatement::DatumOfTable { line, table };
        }
        let rest = cursor.take_rest();
        cursor.fault(KlartextFaultKind::MissingValue, rest, "TRANS DATUM TABLE has no TABLINE");
        return KlartextStatement::Unknown;
    }
    not_followed(cursor, UnfollowedFunction::Selection)
}
