//! Prose between the words of a program: a remark whose marks were lost, or that was wrapped at the end
//! of its line.

use super::*;

/// How many bytes of a line are looked at to tell prose from words.
const LOOKED_AT: usize = 400;

/// How many lines one remark may go on.
const MOST_LINES: usize = 200;

/// What the text to the end of a line holds.
#[derive(Default)]
struct Tokens {
    /// Letters alone, two or more of them.
    prose: usize,
    /// Prose of three letters and more.
    long: usize,
    /// All else: numbers, words of a program.
    other: usize,
    /// A mark of expressions and statements.
    marks: bool,
    /// The first of them is a word of a program: a letter and a number.
    begins_with_word: bool,
}

impl Tokens {
    fn of(line: &[u8]) -> Tokens {
        let mut tokens = Tokens::default();
        let line = &line[..line.len().min(LOOKED_AT)];
        // What follows a parenthesis is a comment.
        let line = &line[..memchr::memchr(b'(', line).unwrap_or(line.len())];
        for token in line.split(|byte| matches!(byte, b' ' | b'\t')) {
            let word = token.trim_ascii();
            let word = word.strip_suffix(b")").unwrap_or(word);
            let bare =
                word.trim_ascii().trim_end_with(|byte| matches!(byte, b',' | b'.' | b':' | b'!'));
            if bare.is_empty() {
                continue;
            }
            tokens.marks |= bare.iter().any(|byte| matches!(byte, b'#' | b'[' | b']' | b'='));
            if tokens.prose + tokens.other == 0 {
                let value = bare.get(1).is_some_and(|byte| CLASSES[*byte as usize] == Class::Digit);
                tokens.begins_with_word = bare[0].is_ascii_alphabetic() && value;
            }
            if bare.len() >= 2 && bare.iter().all(u8::is_ascii_alphabetic) {
                tokens.prose += 1;
                tokens.long += usize::from(bare.len() >= 3);
            } else {
                tokens.other += 1;
            }
        }
        tokens
    }

    /// At least two words of a language, and as much of it as of anything else.
    fn is_prose(&self) -> bool {
        self.prose >= 2 && self.long >= 1 && self.prose >= self.other && !self.marks
    }

    /// A line that goes on where one like that came before.
    fn goes_on(&self) -> bool {
        self.long >= 1 && self.prose >= self.other && !self.marks && !self.begins_with_word
    }
}

/// `trim_end_matches` of bytes.
trait TrimEnd {
    fn trim_end_with(&self, out: impl Fn(u8) -> bool) -> &[u8];
}

impl TrimEnd for [u8] {
    fn trim_end_with(&self, out: impl Fn(u8) -> bool) -> &[u8] {
        let kept = self.iter().rposition(|byte| !out(*byte)).map_or(0, |last| last + 1);
        &self[..kept]
    }
}

impl BlockReader<'_> {
    /// Takes prose from `start` to the end of its line or a comment in it, and the lines of prose after it, as one problem.
    /// False, and nothing taken, where the text is none.
    #[cold]
    pub(super) fn remark(&mut self, block: &mut Block, start: usize) -> bool {
        if !Tokens::of(self.line_from(start)).is_prose() {
            return false;
        }
        let line = self.line_from(start);
        let opened = memchr::memchr(b'(', line);
        let first = line[..opened.unwrap_or(line.len())].trim_ascii_end().len();
        let range = TextRange::new(start as u32, (start + first) as u32);
        self.at = start + opened.unwrap_or(line.len());
        let mut more = 0;
        while opened.is_none() && more < MOST_LINES {
            let Some(next) = self.next_line() else { break };
            if !Tokens::of(self.line_from(next)).goes_on() {
                break;
            }
            let byte = self.text[self.at];
            self.skip_line_end(byte);
            self.skip_to_line_end();
            more += 1;
        }
        // What was found on the way to it is a part of it.
        block.problems.retain(|problem| problem.code == Code::UnclosedComment);
        block.comments.push(TextRange::new(start as u32, self.at as u32));
        self.problem(block, || {
            let lines = match more {
                0 => String::new(),
                1 => ", with the line after it".to_string(),
                more => format!(", with the {more} lines after it"),
            };
            Diagnostic::new(
                Code::LooksLikeRemark,
                range.in_file(self.file),
                format!("this looks like a remark{lines}: it is passed over"),
            )
            .label("no words of a program")
            .help("put the remark into parentheses, each line in its own")
        });
        true
    }

    /// A comment that was wrapped: lines of prose follow, and one of them closes it. All of it is the comment,
    /// and one problem.
    #[cold]
    pub(super) fn comment_closed_later(&mut self, block: &mut Block, start: usize) -> bool {
        let (kept_at, kept_line) = (self.at, self.line);
        for more in 1..=MOST_LINES {
            let Some(next) = self.next_line() else { break };
            let line = self.line_from(next);
            if !Tokens::of(line).goes_on() {
                break;
            }
            let close = memchr::memchr(b')', line);
            let byte = self.text[self.at];
            self.skip_line_end(byte);
            if let Some(close) = close {
                self.at = next + close + 1;
                block.comments.push(TextRange::new(start as u32, self.at as u32));
                let lines = if more == 1 { "the next line" } else { "a later line" };
                self.problem(block, || {
                    let open = Span::new(self.file, start as u32, start as u32 + 1);
                    let close = Span::new(self.file, self.at as u32 - 1, self.at as u32);
                    Diagnostic::new(
                        Code::UnclosedComment,
                        open,
                        format!(
                            "this comment is closed on {lines}; a control reads that line as words"
                        ),
                    )
                    .label("opened here")
                    .also(close, "closed here")
                    .help("join the lines, or put each line into parentheses of its own")
                });
                return true;
            }
            self.skip_to_line_end();
        }
        (self.at, self.line) = (kept_at, kept_line);
        false
    }

    fn line_from(&self, start: usize) -> &[u8] {
        let rest = &self.text[start..self.end];
        &rest[..memchr::memchr2(b'\n', b'\r', rest).unwrap_or(rest.len())]
    }

    /// Where the text of the next line begins; nothing at the end.
    fn next_line(&self) -> Option<usize> {
        let rest = &self.text[self.at..self.end];
        let ends = match rest {
            [b'\r', b'\n', ..] => 2,
            [b'\n' | b'\r', ..] => 1,
            _ => return None,
        };
        (ends < rest.len()).then_some(self.at + ends)
    }
}
