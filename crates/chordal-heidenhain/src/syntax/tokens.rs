//! The tokens of a block: words, numbers, texts and signs.

use chordal_diagnostics::TextRange;

/// What a token is.
#[derive(Clone, PartialEq, Debug)]
pub enum KlartextTokenKind {
    /// Letters, in upper case: `L`, `FMAX`, `IX`.
    Word(String),
    /// A number without a sign; a comma counts as a point.
    Number(f64),
    /// A text in quotes, without them.
    Text(String),
    /// Any other character.
    Sign(u8),
}

/// A token and its text.
#[derive(Clone, PartialEq, Debug)]
pub struct KlartextToken {
    /// What it is.
    pub kind: KlartextTokenKind,
    /// Its text.
    pub range: TextRange,
}

/// Whether a byte belongs to a word. Bytes above ASCII are letters of the language of the shop.
fn is_letter(byte: u8) -> bool {
    byte.is_ascii_alphabetic() || byte == b'_' || byte >= 0x80
}

/// Adds the tokens of a part of a text.
pub fn scan_tokens(text: &[u8], part: TextRange, tokens: &mut Vec<KlartextToken>) {
    let mut at = part.start as usize;
    let end = (part.end as usize).min(text.len());
    while at < end {
        let byte = text[at];
        let start = at;
        if byte.is_ascii_whitespace() {
            at += 1;
            continue;
        }
        if is_letter(byte) {
            at += text[at..end].iter().take_while(|byte| is_letter(**byte)).count();
            let is_numbered = text[..end].get(at).is_some_and(u8::is_ascii_digit);
            push_word(text, start, at, is_numbered, tokens);
            continue;
        }
        let kind = match byte {
            b'0'..=b'9' | b'.' | b',' => {
                let length = number_length(&text[at..end]);
                at += length.max(1);
                number_of(&text[start..at])
                    .map_or(KlartextTokenKind::Sign(byte), KlartextTokenKind::Number)
            }
            b'"' => {
                let inside = &text[at + 1..end];
                let length = memchr::memchr(b'"', inside).unwrap_or(inside.len());
                at = (at + length + 2).min(end);
                KlartextTokenKind::Text(String::from_utf8_lossy(&inside[..length]).into_owned())
            }
            _ => {
                at += 1;
                KlartextTokenKind::Sign(byte)
            }
        };
        let range = TextRange::new(start as u32, at as u32);
        tokens.push(KlartextToken { kind, range });
    }
}

/// Adds a word. Letters that run into a parameter are two words: `FQ52` is F with Q52.
fn push_word(
    text: &[u8],
    start: usize,
    end: usize,
    is_numbered: bool,
    tokens: &mut Vec<KlartextToken>,
) {
    let bytes = &text[start..end];
    let mut word = match std::str::from_utf8(bytes) {
        Ok(word) => word.to_string(),
        Err(_) => String::from_utf8_lossy(bytes).into_owned(),
    };
    word.make_ascii_uppercase();
    let mut push = |word: String, start: usize, end: usize| {
        let range = TextRange::new(start as u32, end as u32);
        tokens.push(KlartextToken { kind: KlartextTokenKind::Word(word), range });
    };
    let banks = ["QL", "QR", "QS", "Q"].into_iter().filter(|_| is_numbered);
    let bank = banks.into_iter().find(|bank| word.ends_with(bank));
    // SQ is the square.
    if let Some(bank) = bank
        && word.len() > bank.len()
        && word.len() == end - start
        && word != "SQ"
    {
        let middle = end - bank.len();
        word.truncate(word.len() - bank.len());
        push(word, start, middle);
        return push(bank.to_string(), middle, end);
    }
    push(word, start, end);
}

/// The length of a number: digits with one point or comma.
fn number_length(text: &[u8]) -> usize {
    let mut has_point = false;
    text.iter()
        .take_while(|byte| match byte {
            b'0'..=b'9' => true,
            b'.' | b',' => !std::mem::replace(&mut has_point, true),
            _ => false,
        })
        .count()
}

/// The value of a number; `None` without a digit.
fn number_of(text: &[u8]) -> Option<f64> {
    let value: f64 = if memchr::memchr(b',', text).is_some() {
        let with_point: Vec<u8> =
            text.iter().map(|byte| if *byte == b',' { b'.' } else { *byte }).collect();
        std::str::from_utf8(&with_point).ok()?.parse().ok()?
    } else {
        std::str::from_utf8(text).ok()?.parse().ok()?
    };
    value.is_finite().then_some(value)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn scanned(text: &str) -> Vec<KlartextTokenKind> {
        let mut tokens = Vec::new();
        scan_tokens(text.as_bytes(), TextRange::new(0, text.len() as u32), &mut tokens);
        tokens.into_iter().map(|token| token.kind).collect()
    }

    #[test]
    fn words_numbers_and_parameters() {
        use KlartextTokenKind::{Number, Sign, Text, Word};
        let word = |text: &str| Word(text.to_string());
        assert_eq!(
            scanned("L X-241,781 FQ52 \"A B\""),
            [
                word("L"),
                word("X"),
                Sign(b'-'),
                Number(241.781),
                word("F"),
                word("Q"),
                Number(52.0),
                Text("A B".into())
            ]
        );
        assert_eq!(scanned("X10."), [word("X"), Number(10.0)]);
        assert_eq!(scanned("-.5"), [Sign(b'-'), Number(0.5)]);
        assert_eq!(scanned("SQ10"), [word("SQ"), Number(10.0)]);
        assert_eq!(scanned("."), [Sign(b'.')]);
    }
}
