//! Finds prose between the words of a program: a comment without its parentheses, or one that was wrapped at the end of
//! its line.

use super::*;

/// The largest number of bytes of a line that are examined to distinguish prose from words.
const MAX_INSPECTED_BYTES: usize = 400;

/// Counts of the tokens up to the end of a line.
#[derive(Default)]
struct CommentTokens {
    /// Tokens of two or more letters only.
    prose: usize,
    /// Those with three or more letters.
    long: usize,
    /// All other tokens: numbers, words of a program.
    other: usize,
    /// There is a character of expressions or statements.
    marks: bool,
    /// The number of letters of the longest prose token.
    longest: usize,
    /// The last token closes a parenthesis that was not opened on this line.
    closes: bool,
}

impl CommentTokens {
    fn of(line: &[u8]) -> CommentTokens {
        let mut tokens = CommentTokens::default();
        for token in line.split(|byte| matches!(byte, b' ' | b'\t')) {
            let token = token.trim_ascii();
            let bare = without_marks(token);
            if bare.is_empty() {
                continue;
            }
            tokens.marks |= bare.iter().any(|byte| matches!(byte, b'#' | b'[' | b']' | b'='));
            tokens.closes |= token.ends_with(b")");
            if bare.len() >= 2 && bare.iter().all(u8::is_ascii_alphabetic) {
                tokens.prose += 1;
                tokens.long += usize::from(bare.len() >= 3);
                tokens.longest = tokens.longest.max(bare.len());
            } else {
                tokens.other += 1;
            }
        }
        tokens
    }

    /// Whether the text is prose: at least as many prose tokens as others, and two of them, or one that closes a
    /// parenthesis from another line, or a single one of four or more letters.
    fn is_prose(&self) -> bool {
        let alone = self.prose == 1 && self.other == 0 && self.longest >= 4;
        (self.prose >= 2 || alone || self.closes)
            && self.long >= 1
            && self.prose >= self.other
            && !self.marks
    }
}

/// The part of a line before its first comment.
fn prose_of(line: &[u8]) -> &[u8] {
    &line[..memchr::memchr(b'(', line).unwrap_or(line.len())]
}

/// Whether a token is a letter and a number: `X5.`, `G1`.
fn is_word(token: &[u8]) -> bool {
    let [letter, number @ ..] = token else { return false };
    letter.is_ascii_alphabetic()
        && number.iter().any(u8::is_ascii_digit)
        && number.iter().all(|byte| CLASSES[*byte as usize] == CharClass::Digit)
}

/// A token without the punctuation after it.
fn without_marks(token: &[u8]) -> &[u8] {
    let mark = |byte: &u8| matches!(byte, b',' | b'.' | b':' | b'!' | b')');
    let kept = token.iter().rposition(|byte| !mark(byte)).map_or(0, |last| last + 1);
    &token[..kept]
}

impl BlockReader<'_> {
    /// Reports the prose from `start` to the end of its line or the next comment as one problem, and skips it. False if
    /// the text is not prose.
    #[cold]
    pub(super) fn remark(&mut self, block: &mut Block, start: usize) -> bool {
        // A line of a megabyte must not be searched for its end repeatedly.
        let head = prose_of(self.line_from(start, MAX_INSPECTED_BYTES));
        let tokens = CommentTokens::of(head);
        // A keyword alone is a statement of a macro language.
        if !tokens.is_prose() || tokens.prose == 1 && self.keyword(start) {
            return false;
        }
        let passed: Vec<_> = head
            .split(|byte| matches!(byte, b' ' | b'\t'))
            .filter(|token| is_word(token))
            .map(|token| String::from_utf8_lossy(token).into_owned())
            .collect();
        let line = prose_of(self.line_from(start, usize::MAX));
        let words = line.trim_ascii_end().len();
        let range = TextRange::new(start as u32, (start + words) as u32);
        let end = start + line.len();
        let label = match passed.is_empty() {
            true => "not words of a program".to_string(),
            false => format!("{} in it is skipped, too", passed.join(" ")),
        };
        self.at = end;
        // Other problems found before are part of the prose.
        block.problems.retain(|problem| problem.code == Code::UnclosedComment);
        block.comments.push(range);
        self.problem(block, || {
            Diagnostic::new(
                Code::LooksLikeRemark,
                range.in_file(self.file),
                "this looks like a comment without parentheses: it is skipped",
            )
            .label(label)
            .help("put the comment into parentheses, each line separately")
        });
        true
    }

    /// The text from `start` to the end of its line, at most `most` bytes.
    fn line_from(&self, start: usize, most: usize) -> &[u8] {
        let rest = &self.text[start..self.end.min(start.saturating_add(most))];
        &rest[..memchr::memchr2(b'\n', b'\r', rest).unwrap_or(rest.len())]
    }
}
