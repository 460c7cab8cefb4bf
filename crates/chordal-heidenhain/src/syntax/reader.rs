//! Divides a text into blocks: a line, with the lines that continue it.

use chordal_diagnostics::TextRange;

use super::ast::KlartextBlock;
use super::plain_line::plain_line;
use super::word_search::{contains_ignoring_case, positions_ignoring_case};

/// A block of a program before its words are read.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct KlartextLines {
    /// Its text from its first character to its last, with comments.
    pub range: TextRange,
    /// Its first line, from 1.
    pub line: u32,
    /// The parts of its lines that are no comment.
    pub parts: Vec<TextRange>,
    /// Its comments, with their semicolons.
    pub comments: Vec<TextRange>,
    /// It is a block of a DIN/ISO program.
    pub is_iso: bool,
}

impl KlartextLines {
    /// Whether it is a comment, with or without a block number.
    fn is_comment(&self, text: &[u8]) -> bool {
        !self.comments.is_empty()
            && self.parts.iter().all(|part| part.slice(text).iter().all(u8::is_ascii_digit))
    }
}

/// Reads the blocks of a text in their order, from any place on.
#[derive(Clone, Debug)]
pub struct LineReader<'t> {
    text: &'t [u8],
    offset: u32,
    line: u32,
    is_iso: bool,
}

impl<'t> LineReader<'t> {
    /// At the start of a text.
    pub fn new(text: &'t [u8]) -> LineReader<'t> {
        // A DIN/ISO program begins with its name after a percent sign.
        let first = text.trim_ascii_start().first();
        LineReader { text, offset: 0, line: 1, is_iso: first == Some(&b'%') }
    }

    /// Whether the text is a DIN/ISO program.
    pub fn is_iso(&self) -> bool {
        self.is_iso
    }

    /// The text.
    pub fn text(&self) -> &'t [u8] {
        self.text
    }

    /// The first byte of the next block.
    pub fn offset(&self) -> u32 {
        self.offset
    }

    /// The line of the next block, from 1.
    pub fn line(&self) -> u32 {
        self.line
    }

    /// Whether the next block is a straight move, so that it need not be read to know that.
    pub fn next_is_straight(&self) -> bool {
        let rest = self.text.get(self.offset as usize..).unwrap_or(&[]);
        let rest = &rest[rest.iter().take_while(|byte| matches!(byte, b' ' | b'\t')).count()..];
        let rest = &rest[rest.iter().take_while(|byte| byte.is_ascii_digit()).count()..];
        let rest = &rest[rest.iter().take_while(|byte| matches!(byte, b' ' | b'\t')).count()..];
        !self.is_iso && rest.first() == Some(&b'L') && rest.get(1) == Some(&b' ')
    }

    /// Goes to the block that begins at a byte, on a line.
    pub fn seek(&mut self, offset: u32, line: u32) {
        self.offset = offset.min(self.text.len() as u32);
        self.line = line;
    }

    /// The next line without its end; `None` at the end of the text.
    fn next_line(&mut self) -> Option<TextRange> {
        let start = self.offset as usize;
        let rest = self.text.get(start..).filter(|rest| !rest.is_empty())?;
        let length = memchr::memchr(b'\n', rest);
        let end = start + length.unwrap_or(rest.len());
        self.offset = (end + usize::from(length.is_some())) as u32;
        self.line += 1;
        Some(trimmed(self.text, TextRange::new(start as u32, end as u32)))
    }

    /// Takes the next line if it is a block that only moves straight to numbers.
    pub fn take_plain_line(&mut self) -> Option<KlartextBlock> {
        if self.is_iso {
            return None;
        }
        let (offset, line) = (self.offset, self.line);
        let range = self.next_line()?;
        let block = plain_line(self.text, range, line);
        if block.is_none() {
            (self.offset, self.line) = (offset, line);
        }
        block
    }

    /// Goes on to the next block that may contain a word of letters; to the end of the text without one.
    pub fn pass_blocks_without(&mut self, word: &[u8]) {
        let from = self.offset as usize;
        let rest = self.text.get(from..).unwrap_or(&[]);
        let start = match positions_ignoring_case(rest, word).next() {
            Some(found) => self.block_start(from + found),
            None => self.text.len(),
        };
        self.line += memchr::memchr_iter(b'\n', &self.text[from..start]).count() as u32;
        self.offset = start as u32;
    }

    /// The start of a line at a byte, or of one before it that begins the block; not before the next block.
    fn block_start(&self, at: usize) -> usize {
        let from = self.offset as usize;
        let line_start = |end: usize| {
            memchr::memrchr(b'\n', &self.text[from..end]).map_or(from, |place| from + place + 1)
        };
        let mut start = line_start(at);
        while start > from {
            let before = line_start(start - 1);
            let goes_on = self.text[before..start].trim_ascii_end().last() == Some(&b'~');
            if !goes_on && !is_cycle_data(&self.text[start..]) {
                break;
            }
            start = before;
        }
        start
    }

    /// Whether the next line has a block number, so that it does not go on with a comment.
    fn next_has_number(&self) -> bool {
        let rest = self.text.get(self.offset as usize..).unwrap_or(&[]);
        let line = rest.split(|byte| *byte == b'\n').next().unwrap_or(&[]).trim_ascii_start();
        let digits = line.iter().take_while(|byte| byte.is_ascii_digit()).count();
        digits > 0 && line.get(digits).is_none_or(u8::is_ascii_whitespace)
    }

    /// Whether the next line is one of the data of a cycle that is written without `~`.
    fn continues_cycle(&self) -> bool {
        is_cycle_data(self.text.get(self.offset as usize..).unwrap_or(&[]))
    }
}

impl Iterator for LineReader<'_> {
    type Item = KlartextLines;

    fn next(&mut self) -> Option<KlartextLines> {
        let line = self.line;
        let first = self.next_line()?;
        let is_iso = self.is_iso;
        let mut block =
            KlartextLines { range: first, line, parts: Vec::new(), comments: Vec::new(), is_iso };
        let mut goes_on = add_line(self.text, first, &mut block);
        let is_cycle = begins_cycle(first.slice(self.text));
        let is_comment = goes_on && block.is_comment(self.text);
        while goes_on || is_cycle && self.continues_cycle() {
            if is_comment && self.next_has_number() {
                break;
            }
            let Some(next) = self.next_line() else { break };
            block.range.end = next.end.max(block.range.end);
            if is_comment {
                block.comments.push(next);
                goes_on = next.slice(self.text).last() == Some(&b'~');
                continue;
            }
            goes_on = add_line(self.text, next, &mut block);
        }
        Some(block)
    }
}

/// Whether a line may be one of the data of a cycle: it is indented and begins with a parameter and an equal sign.
fn is_cycle_data(text: &[u8]) -> bool {
    if !matches!(text.first(), Some(b' ' | b'\t')) {
        return false;
    }
    let line = text.split(|byte| *byte == b'\n').next().unwrap_or(&[]);
    let inside = line.trim_ascii_start();
    let digits = inside.get(1..).unwrap_or(&[]);
    let count = digits.iter().take_while(|byte| byte.is_ascii_digit()).count();
    inside.first().is_some_and(|first| first.eq_ignore_ascii_case(&b'Q'))
        && count > 0
        && digits[count..].trim_ascii_start().first() == Some(&b'=')
}

/// Whether a line defines a cycle that has its data in parameters.
fn begins_cycle(line: &[u8]) -> bool {
    contains_ignoring_case(line, b"CYCL") && contains_ignoring_case(line, b"DEF")
}

/// Adds a line to its block; true if it ends with `~`, so that the next line belongs to the block, too.
fn add_line(text: &[u8], line: TextRange, block: &mut KlartextLines) -> bool {
    let bytes = line.slice(text);
    let goes_on = bytes.last() == Some(&b'~');
    let end = line.end - u32::from(goes_on);
    let inside = &bytes[..bytes.len() - usize::from(goes_on)];
    let comment = comment_start(inside).map_or(end, |at| line.start + at as u32);
    let part = trimmed(text, TextRange::new(line.start, comment));
    if !part.is_empty() {
        block.parts.push(part);
    }
    if comment < end {
        block.comments.push(trimmed(text, TextRange::new(comment, end)));
    }
    goes_on
}

/// The place of the semicolon of a comment, outside of texts in quotes.
fn comment_start(line: &[u8]) -> Option<usize> {
    let semicolon = memchr::memchr(b';', line)?;
    if memchr::memchr(b'"', &line[..semicolon]).is_none() {
        return Some(semicolon);
    }
    let mut in_text = false;
    line.iter().position(|byte| {
        in_text ^= *byte == b'"';
        *byte == b';' && !in_text
    })
}

/// A range without the blanks at both ends.
fn trimmed(text: &[u8], range: TextRange) -> TextRange {
    let bytes = range.slice(text);
    let before = bytes.len() - bytes.trim_ascii_start().len();
    let inside = bytes.trim_ascii().len();
    let start = range.start + before as u32;
    TextRange::new(start, start + inside as u32)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parts(text: &str) -> Vec<Vec<String>> {
        let read =
            |range: &TextRange| String::from_utf8_lossy(range.slice(text.as_bytes())).into_owned();
        LineReader::new(text.as_bytes())
            .map(|block| block.parts.iter().map(read).collect())
            .collect()
    }

    #[test]
    fn lines_that_continue_belong_to_the_block() {
        let text = "7 CYCL DEF 200 DRILLING ~\r\n  Q200=+2 ;CLEARANCE ~\r\n  Q201=-5 ;DEPTH\r\n8 L X+1\r\n";
        assert_eq!(
            parts(text),
            [vec!["7 CYCL DEF 200 DRILLING", "Q200=+2", "Q201=-5"], vec!["8 L X+1"]]
        );
    }

    #[test]
    fn data_of_a_cycle_may_stand_without_a_sign_that_they_go_on() {
        let text = "CYCL DEF 200\n  Q200=2\n  Q201=-5\nL X+1\n";
        assert_eq!(parts(text), [vec!["CYCL DEF 200", "Q200=2", "Q201=-5"], vec!["L X+1"]]);
        assert_eq!(parts("CYCL DEF 7.1 X+1\nQ1=2\n").len(), 2);
    }

    #[test]
    fn comments_go_on_after_a_tilde() {
        let text = "3 ;LONG COMMENT ~\n GOES ON ~\n AND ENDS\n4 ; OTHER -~\n5 L X+1\nQ200=2 ;TEXT ~\nQ201=3\n";
        let blocks: Vec<_> = LineReader::new(text.as_bytes()).collect();
        let shape = |block: &KlartextLines| (block.line, block.parts.len(), block.comments.len());
        assert_eq!(
            blocks.iter().map(shape).collect::<Vec<_>>(),
            [(1, 1, 3), (4, 1, 1), (5, 1, 0), (6, 2, 1)]
        );
    }

    #[test]
    fn blocks_with_a_word_are_found_from_their_first_line() {
        let text = "BEGIN PGM A MM\nL X+1\nL Y+1\nCYCL DEF 200\n  Q200=2\n  Q201=-5 ;LBL\nL X+1 ~\n ~\n lbl\nL\n\
                    LBL 7\n";
        let mut lines = LineReader::new(text.as_bytes());
        let mut found = Vec::new();
        loop {
            lines.pass_blocks_without(b"LBL");
            let Some(block) = lines.next() else { break };
            found.push((block.line, &text[block.range.start as usize..block.range.end as usize]));
        }
        let expected = [
            (4, "CYCL DEF 200\n  Q200=2\n  Q201=-5 ;LBL"),
            (7, "L X+1 ~\n ~\n lbl"),
            (11, "LBL 7"),
        ];
        assert_eq!(found, expected);
        assert_eq!(lines.line(), 12);
    }

    #[test]
    fn a_semicolon_in_a_text_is_no_comment() {
        assert_eq!(parts("QS1 = \"A;B\" ; C"), [vec!["QS1 = \"A;B\""]]);
    }
}
