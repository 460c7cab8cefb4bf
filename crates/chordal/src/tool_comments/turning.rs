//! Reads inserts and holders from comments of lathe programs.

use chordal_machine::{
    HolderDesignation, InsertDesignation, InsertLetter, Tool, ToolShape, WrittenDesignation,
};

use super::CommentedTool;
use super::tokens::{CommentToken, CommentTokenKind};

/// Nose radii that differ by less than this are equal, mm: 1/32 in (0.794 mm) is 0.8 mm in a catalogue.
const NOSE_TOLERANCE_MM: f64 = 0.02;
/// Largest nose radius, mm.
const MAX_NOSE_MM: f64 = 20.0;

/// Adds what a comment of a lathe program says about the insert and its holder.
pub(super) fn read_turning(
    text: &str,
    tokens: &[CommentToken<'_>],
    inch: bool,
    tool: &mut CommentedTool,
) {
    tool.insert = insert_in(text);
    tool.holder = holder_in(text);
    tool.letter = tool.insert.map(|insert| insert.letter).or_else(|| letter_after_key(text));
    tool.tip = tip(tokens);
    let nose = nose(tokens, inch);
    let of_insert = tool.insert.map(|insert| insert.nose_mm);
    match (nose, of_insert) {
        (Some(nose), Some(own)) if (nose - own).abs() > NOSE_TOLERANCE_MM => {
            tool.other_nose_mm = Some(nose);
        }
        (nose, own) => tool.nose_radius_mm = nose.or(own),
    }
    if tool.nose_radius_mm.is_some() || tool.insert.is_some() || tool.tip.is_some() {
        tool.shape = tool.shape.or(Some(ToolShape::Insert));
    }
    if tool.shape == Some(ToolShape::Insert) {
        // A radius in words is that of the nose.
        tool.corner_radius_mm = None;
        tool.diameter_mm = None;
    }
}

/// The insert of a comment that names no tool.
pub(super) fn read_insert(text: &str) -> Option<CommentedTool> {
    let insert = insert_in(&text.to_ascii_uppercase())?;
    Some(CommentedTool {
        insert: Some(insert),
        letter: Some(insert.letter),
        nose_radius_mm: Some(insert.nose_mm),
        shape: Some(ToolShape::Insert),
        ..CommentedTool::of(0)
    })
}

/// Parts of the text that may be a designation: each word, and each pair of words.
fn candidates(text: &str) -> impl Iterator<Item = String> {
    let words: Vec<&str> =
        text.split([' ', ',', ';', ':', '=', '(', ')']).filter(|w| !w.is_empty()).collect();
    let pairs: Vec<String> = words.windows(2).map(|pair| pair.join(" ")).collect();
    let single: Vec<String> = words.into_iter().map(str::to_string).collect();
    single.into_iter().chain(pairs)
}

fn insert_in(text: &str) -> Option<InsertDesignation> {
    candidates(text)
        .filter(|word| word.bytes().take(4).all(|byte| byte.is_ascii_alphabetic()))
        .find_map(|word| InsertDesignation::parse(&word).ok())
}

fn holder_in(text: &str) -> Option<HolderDesignation> {
    // At least four digits are required: five letters alone may be any word.
    candidates(text)
        .filter(|word| word.bytes().filter(u8::is_ascii_digit).count() >= 4)
        .find_map(|word| HolderDesignation::parse(&word).ok())
}

/// `INSERT: DNMG`: the shape without a size.
fn letter_after_key(text: &str) -> Option<InsertLetter> {
    let after = text.split_once("INSERT")?.1.trim_start_matches([' ', ':', '=', '-']);
    let word = after.split([' ', ',']).next()?;
    // A designation with a size is read as a whole; here a dummy size completes it.
    let is_letters = word.len() == 4 && word.bytes().all(|byte| byte.is_ascii_uppercase());
    let whole = || InsertDesignation::parse(&format!("{word}120404")).ok();
    is_letters.then(whole).flatten().map(|read| read.letter)
}

/// The index of the number after one of these keys, signs skipped.
fn value_after(tokens: &[CommentToken<'_>], keys: &[&[&str]]) -> Option<usize> {
    (0..tokens.len()).find_map(|at| {
        let fits = |key: &&&[&str]| {
            key.iter().enumerate().all(|(step, word)| {
                tokens.get(at + step).and_then(CommentToken::word) == Some(*word)
            })
        };
        let key = keys.iter().find(fits)?;
        let is_sign = |token: &&CommentToken<'_>| {
            matches!(token.kind, CommentTokenKind::Sign(':' | '=' | '-' | '.' | '#'))
        };
        let after = at + key.len();
        let value = after + tokens.get(after..)?.iter().take_while(is_sign).count();
        tokens.get(value)?.number().map(|_| value)
    })
}

/// The nose radius, mm: `NOSE RADIUS: 0.8`, `TNR .031`.
fn nose(tokens: &[CommentToken<'_>], inch: bool) -> Option<f64> {
    let keys: [&[&str]; 5] =
        [&["NOSE", "RADIUS"], &["NOSE", "RAD"], &["NOSE", "R"], &["TNR"], &["NR"]];
    let at = value_after(tokens, &keys)?;
    let number = tokens[at].number()?;
    let nose = number.mm(inch);
    (number.is_size() && nose <= MAX_NOSE_MM).then_some(nose)
}

/// The tip number: `TOOL TIP: 3`, `TIP 3`, `ORIENTATION 3`.
fn tip(tokens: &[CommentToken<'_>]) -> Option<u32> {
    let keys: [&[&str]; 4] =
        [&["TIP"], &["ORIENTATION"], &["TIP", "NUMBER"], &["TIP", "DIRECTION"]];
    let at = value_after(tokens, &keys)?;
    tokens[at].number()?.whole().filter(|tip| *tip <= 9)
}

/// Completes a turning tool with the insert and the holder of a comment.
pub(super) fn fill(tool: &mut Tool, commented: &CommentedTool) {
    let is_turning = commented.shape == Some(ToolShape::Insert) && tool.shape == commented.shape;
    if !is_turning {
        return;
    }
    tool.nose_radius_mm = tool.nose_radius_mm.or(commented.nose_radius_mm);
    tool.tip = tool.tip.or(commented.tip);
    tool.turning.insert = tool.turning.insert.or(commented.letter);
    let edge = commented.insert.and_then(|insert| insert.edge_mm);
    tool.flute_length_mm = tool.flute_length_mm.or(edge);
    let approach = commented.holder.and_then(|holder| holder.approach_degrees());
    let fits = commented.holder.is_some_and(|holder| tool.turning.insert == Some(holder.letter));
    let approach = approach.filter(|_| fits).map(f64::to_radians);
    tool.turning.approach_angle_rad = tool.turning.approach_angle_rad.or(approach);
}

/// The message that a comment contradicts its own designation or the machine file; `None` where it does not.
pub(super) fn contradiction(commented: &CommentedTool, known: Option<&Tool>) -> Option<String> {
    let number = commented.number;
    let differs = |one: f64, other: f64| (one - other).abs() > NOSE_TOLERANCE_MM;
    if let (Some(words), Some(insert)) = (commented.other_nose_mm, commented.insert) {
        return Some(format!(
            "tool {number}: the comment says a nose radius of {words} mm, and its insert has {} mm",
            insert.nose_mm
        ));
    }
    let known = known?;
    let (commented_nose, own) = (commented.nose_radius_mm?, known.nose_radius_mm?);
    let from = known
        .turning
        .insert_designation
        .as_ref()
        .map(|written: &WrittenDesignation<_>| format!(" (its insert is {})", written.text));
    differs(commented_nose, own).then(|| {
        format!(
            "tool {number}: the comment says a nose radius of {commented_nose} mm, and the machine file {own} mm{}",
            from.unwrap_or_default()
        )
    })
}
