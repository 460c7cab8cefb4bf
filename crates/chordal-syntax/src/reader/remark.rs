//! Prose between the words of a program: a remark whose marks were lost, or that was wrapped at the end
//! of its line.

use super::*;

/// How many bytes of a line are looked at to separate prose from words.
const MAX_INSPECTED_BYTES: usize = 400;

/// What the text to the end of a line holds.
#[derive(Default)]
struct CommentTokens {
    /// Letters alone, two or more of them.
    prose: usize,
    /// Prose of three letters and more.
    long: usize,
    /// All else: numbers, words of a program.
    other: usize,
    /// A mark of expressions and statements.
    marks: bool,
    /// Letters of the longest word of prose.
    longest: usize,
    /// The last of them closes a parenthesis that this line does not open.
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

    /// Words of a language, as many as there is anything else: two of them, one that closes a parenthesis
    /// opened on another line, or one long one that is alone.
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

/// A letter and a number: `X5.`, `G1`.
fn is_word(token: &[u8]) -> bool {
    let [letter, number @ ..] = token else { return false };
    letter.is_ascii_alphabetic()
        && number.iter().any(u8::is_ascii_digit)
        && number.iter().all(|byte| CLASSES[*byte as usize] == CharClass::Digit)
}

/// A token without the marks of a sentence after it.
fn without_marks(token: &[u8]) -> &[u8] {
    let mark = |byte: &u8| matches!(byte, b',' | b'.' | b':' | b'!' | b')');
    let kept = token.iter().rposition(|byte| !mark(byte)).map_or(0, |last| last + 1);
    &token[..kept]
}

impl BlockReader<'_> {
    /// Takes prose from `start` to the end of its line or a comment in it, as one problem. False, and
    /// nothing taken, where the text is none.
    #[cold]
    pub(super) fn remark(&mut self, block: &mut Block, start: usize) -> bool {
        // A megabyte on one line must not be searched for its end again and again.
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
        // What was found on the way to it is a part of it.
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

    /// The text from a place to the end of its line, or so many bytes of it.
    fn line_from(&self, start: usize, most: usize) -> &[u8] {
        let rest = &self.text[start..self.end.min(start.saturating_add(most))];
        &rest[..memchr::memchr2(b'\n', b'\r', rest).unwrap_or(rest.len())]
    }
}
