//! Recognizes letters, notes and other text without NC blocks.

use super::sample::TextSample;

/// A text with fewer words is not called prose: it may be a program that somebody begins to write.
const FEWEST_WORDS: usize = 5;

/// In prose, at most one line in this many looks like a block.
const LINES_TO_A_BLOCK: usize = 20;

/// Whether hardly any line begins like a block or a comment of a program, and there are enough words.
pub(super) fn is_prose(sample: &TextSample) -> bool {
    let all = sample.lines().count();
    let blocks = sample.count(may_be_block);
    let words: usize = sample.lines().map(words).sum();
    words >= FEWEST_WORDS && blocks * LINES_TO_A_BLOCK <= all
}

/// A line with this many words is a sentence: a block has fewer words outside comments.
const SENTENCE: usize = 4;

/// Whether the line begins like a block: with a letter and a number, a program head, a comment, a variable or a
/// setting.
fn may_be_block(line: &str) -> bool {
    let mut bytes = line.bytes().filter(|byte| !matches!(byte, b' ' | b'\t' | 0));
    match (bytes.next(), bytes.next()) {
        (Some(b'%' | b'(' | b';' | b'\'' | b'$' | b'/' | b':' | b'<' | b'&' | b'"' | b'*'), _) => {
            true
        }
        (Some(b'#'), next) => !matches!(next, Some(b'#')) && !line.starts_with("# "),
        (Some(first), Some(next)) => {
            let code = line.split(['(', ';']).next().unwrap_or("");
            first.is_ascii_alphabetic()
                && !(next.is_ascii_alphabetic() || next >= 0x80)
                && words(code) < SENTENCE
        }
        _ => false,
    }
}

fn words(line: &str) -> usize {
    line.split_whitespace().filter(|word| is_word(word)).count()
}

/// Whether this consists of three or more letters, with at most punctuation after them.
fn is_word(word: &str) -> bool {
    let word = word.trim_end_matches(['.', ',', ';', ':', '!', '?']);
    word.chars().count() >= 3 && word.chars().all(char::is_alphabetic)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn prose(text: &str) -> bool {
        is_prose(&TextSample::new(text.as_bytes()))
    }

    #[test]
    fn letters_are_prose_and_programs_are_not() {
        assert!(prose("Dear colleague,\n\nthe holes at X10 are too near to the edge.\n"));
        assert!(!prose("(THE ONLY LINE OF THIS PROGRAM IS A COMMENT)\n"));
        assert!(!prose("O1 (A PART WITH A VERY LONG NAME)\nM30\n"));
        assert!(!prose("typing now\n"));
    }
}
