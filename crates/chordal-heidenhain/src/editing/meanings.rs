//! The meaning of a word at a place of a text.

use chordal_diagnostics::TextRange;

use super::cycle_title;
use super::cycle_words::CYCLE_WORDS;
use super::numbers::{machine_function_meaning, numbered_function_meaning, parameter_meaning};
use super::vocabulary::meaning_of;
use crate::syntax::{KlartextToken, KlartextTokenKind, LineReader, scan_tokens};

/// The word at a byte and what it means; `None` without a known word there.
pub fn meaning_at(text: &[u8], at: u32) -> Option<(TextRange, String)> {
    let block = LineReader::new(text).find(|block| block.range.end > at)?;
    let mut tokens = Vec::new();
    block.parts.iter().for_each(|part| scan_tokens(text, *part, &mut tokens));
    let index = tokens.iter().position(|token| token.range.start <= at && at < token.range.end)?;
    numbered(&tokens, index).or_else(|| {
        let KlartextTokenKind::Word(word) = &tokens[index].kind else { return None };
        Some((tokens[index].range, meaning_of(word)?.to_string()))
    })
}

/// What a word that stands alone means: `CYCL DEF 200` with its data, `Q214`, `M99`, `FN 9`, `APPR LCT`.
pub fn word_meaning(text: &str) -> Option<String> {
    let text = text.trim().to_ascii_uppercase();
    let mut tokens = Vec::new();
    scan_tokens(text.as_bytes(), TextRange::new(0, text.len() as u32), &mut tokens);
    let cycle = match tokens.as_slice() {
        [first, .., last] if matches!(word(first)?, "CYCL" | "CYCLE" | "DEF") => whole(last),
        _ => None,
    };
    if let Some(number) = cycle {
        return cycle_meaning(number);
    }
    let parameter = match tokens.as_slice() {
        [letter, number] if word(letter)? == "Q" => whole(number),
        _ => None,
    };
    if let Some(meaning) = parameter.and_then(parameter_meaning) {
        return Some(format!("{text}, as data of a cycle: {meaning}"));
    }
    let numbered = tokens.len() > 1 && whole(&tokens[1]).is_some();
    match numbered {
        true => self::numbered(&tokens, 0).map(|(_, meaning)| meaning),
        false => Some(format!("{text}: {}", meaning_of(word(tokens.first()?)?)?)),
    }
}

/// The name of a cycle, and a line for each of its data.
fn cycle_meaning(number: u32) -> Option<String> {
    let mut meaning = format!("cycle {number}: {}", title(number)?);
    let words = CYCLE_WORDS.iter().find(|(own, _)| *own == number).map(|(_, words)| *words);
    for word in words.unwrap_or_default() {
        let what = parameter_meaning(*word).unwrap_or("");
        meaning.push_str(&format!("\n  Q{word}  {what}"));
    }
    Some(meaning)
}

fn word(token: &KlartextToken) -> Option<&str> {
    match &token.kind {
        KlartextTokenKind::Word(word) => Some(word),
        _ => None,
    }
}

fn whole(token: &KlartextToken) -> Option<u32> {
    match token.kind {
        KlartextTokenKind::Number(value) if value.fract() == 0.0 && value >= 0.0 => {
            Some(value as u32)
        }
        _ => None,
    }
}

/// A letter and a number that together have a meaning, at either of them.
fn numbered(tokens: &[KlartextToken], index: usize) -> Option<(TextRange, String)> {
    let letter = if whole(&tokens[index]).is_some() { index.checked_sub(1)? } else { index };
    let number = whole(tokens.get(letter + 1)?)?;
    let range = tokens[letter].range.cover(tokens[letter + 1].range);
    let before = letter.checked_sub(1).and_then(|before| word(&tokens[before]));
    let meaning = match (before, word(&tokens[letter])?) {
        (Some("CYCL" | "CYCLE"), "DEF") => format!("cycle {number}: {}", title(number)?),
        (_, "M") => format!("M{number}: {}", machine_function_meaning(number)?),
        (_, "FN") => format!("FN {number}: {}", numbered_function_meaning(number)?),
        (_, "Q") if is_cycle(tokens) => format!("Q{number}: {}", parameter_meaning(number)?),
        _ => return None,
    };
    Some((range, meaning))
}

fn title(number: u32) -> Option<&'static str> {
    Some(cycle_title(number)).filter(|title| !title.is_empty())
}

/// Whether the block defines a cycle: its parameters are those of cycles, others have no fixed meaning.
fn is_cycle(tokens: &[KlartextToken]) -> bool {
    tokens.windows(2).any(|pair| word(&pair[0]) == Some("CYCL") && word(&pair[1]) == Some("DEF"))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn meaning(text: &str, at: &str) -> Option<String> {
        let place = text.find(at).expect("the place") as u32;
        meaning_at(text.as_bytes(), place).map(|(_, meaning)| meaning)
    }

    #[test]
    fn numbers_have_the_meaning_of_their_letter() {
        let text = "5 CYCL DEF 200 DRILLING ~\n  Q200=+2 ;CLEARANCE ~\n  Q201=-Q5 ;DEPTH\n6 L X+5 R0 FMAX M99\n7 FN 0: Q200 = 5\n";
        assert_eq!(meaning(text, "200 DR").as_deref(), Some("cycle 200: drilling"));
        let depth = "Q201: depth: from the surface, incremental; negative is down";
        assert_eq!(meaning(text, "Q201").as_deref(), Some(depth));
        assert_eq!(meaning(text, "201=").as_deref(), Some(depth));
        assert_eq!(
            meaning(text, "99").as_deref(),
            Some("M99: runs the cycle at the end of this block")
        );
        assert_eq!(meaning(text, "FMAX").as_deref(), Some("rapid, in this block"));
        assert_eq!(meaning(text, "FN").as_deref(), Some("FN 0: sets a parameter"));
        // A parameter of a calculation has no fixed meaning.
        assert_eq!(meaning(text, "Q200 = 5").as_deref(), Some("a parameter"));
        assert_eq!(meaning(text, "+5"), None);
    }

    #[test]
    fn words_that_stand_alone_are_explained() {
        let cycle = word_meaning("CYCL DEF 200").expect("a cycle");
        assert!(cycle.starts_with("cycle 200: drilling\n  Q200  set-up clearance"), "{cycle}");
        let direction =
            "Q214, as data of a cycle: disengaging direction: 0 none, 1 -a, 2 -b, 3 +a, 4 +b";
        assert_eq!(word_meaning("q214").as_deref(), Some(direction));
        assert_eq!(
            word_meaning("M99").as_deref(),
            Some("M99: runs the cycle at the end of this block")
        );
        assert_eq!(word_meaning("FN 0").as_deref(), Some("FN 0: sets a parameter"));
        let approach = "APPR LCT: approaches a contour: LT, LN, CT or LCT";
        assert_eq!(word_meaning("APPR LCT").as_deref(), Some(approach));
        assert_eq!(word_meaning("CYCL DEF 999"), None);
        assert_eq!(word_meaning(""), None);
        assert_eq!(word_meaning("WOBBLE 5"), None);
    }
}
