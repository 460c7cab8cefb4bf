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
        for token in line.split(|byte| matches!(byte, b' ' | b'\t')) {
            let word = token.trim_ascii();
            let word = word.strip_suffix(b")").unwrap_or(word);
            let bare =
                word.trim_ascii().trim_end_with(|byte| matches!(byte, b',' | b'.' | b':' | b'!'));
            if bare.is_empty() {
                continue;
            }
            tokens.marks |=
                bare.iter().any(|byte| matches!(byte, b'#' | b'[' | b']' | b'=' | b'('));
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
    /// Takes prose from `start` to the end of its line, and the lines of prose after it, as one problem.
    /// False, and nothing taken, where the text is none.
    #[cold]
    pub(super) fn remark(&mut self, block: &mut Block, start: usize) -> bool {
        if !Tokens::of(self.line_from(start)).is_prose() {
            return false;
        }
        let first = self.line_from(start).trim_ascii_end().len();
        let range = TextRange::new(start as u32, (start + first) as u32);
        self.at = start;
        self.skip_to_line_end();
        let mut more = 0;
        while more < MOST_LINES {
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
