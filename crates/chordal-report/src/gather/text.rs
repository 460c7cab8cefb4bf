//! What the program's own text says to people: titles, comments, words of a block.

use chordal::control::{Origin, ProgramPlace, ProgramSet, Token, TokenClass};
use chordal::diagnostics::{FileId, TextRange};
use chordal::syntax::{Block, BlockKind, BlockPosition, BlockReader};
use chordal::{Job, Source, Span};

use crate::data::CappedRows;

/// Characters of a comment that are reported.
const MAX_COMMENT_CHARS: usize = 160;
/// Characters of a program's title.
const MAX_TITLE_CHARS: usize = 60;
/// Blocks among which the head of a program ends.
const MAX_HEAD_BLOCKS: usize = 200;
/// Comments of the head that are reported.
const MAX_HEAD_COMMENTS: usize = 24;
/// Lines with block delete that are named.
const MAX_SKIPPED: usize = 60;

/// A text on one line, its controls and changes of direction made visible, cut to so many
/// characters: a program may hold anything.
pub fn clean(text: &str, most: usize) -> String {
    let shown = |c: char| match c {
        '\t' | '\n' | '\r' => ' ',
        '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}' => '\u{fffd}',
        c if c.is_control() => '\u{fffd}',
        c => c,
    };
    let text = text.trim();
    let mut out: String = text.chars().take(most).map(shown).collect();
    if text.chars().nth(most).is_some() {
        out.push('…');
    }
    out
}

/// The name of a file without its folder: where it lay is nobody's business who gets the sheet.
pub fn file_name(path: &str) -> String {
    clean(path.rsplit(['/', '\\']).next().unwrap_or(path), 200)
}

/// The comment after the head of a program that ends at `from`: `BRACKET, SIDE 2`.
pub fn title(text: &[u8], from: usize) -> Option<String> {
    let line = text.get(from..)?.split(|byte| matches!(byte, b'\n' | b'\r')).next()?;
    let line = &line[..line.len().min(4 * MAX_TITLE_CHARS)];
    let open = line.iter().position(|byte| *byte == b'(')?;
    let rest = &line[open + 1..];
    let comment = rest.split(|byte| *byte == b')').next().unwrap_or(rest);
    let comment = clean(&String::from_utf8_lossy(comment), MAX_TITLE_CHARS);
    (!comment.is_empty()).then_some(comment)
}

/// A comment without its marks.
pub fn comment(span: Span, job: &Job) -> Option<String> {
    let text = chordal_export::comment_text(span, job)?;
    let text = clean(&text, MAX_COMMENT_CHARS);
    (!text.is_empty()).then_some(text)
}

/// A comment at the head of a program.
struct HeadComment {
    text: String,
    /// It stands after the program's number, and is its title.
    is_title: bool,
}

/// Finds the comments next to the blocks.
pub struct CommentFinder<'j> {
    job: &'j Job<'j>,
    /// The programs in a language other than word-address blocks; `None` for such blocks.
    other_language: Option<Box<dyn ProgramSet + 'j>>,
    head: Vec<HeadComment>,
    /// The last line of the head in the first text.
    head_end: u32,
}

impl<'j> CommentFinder<'j> {
    /// Of a job whose run begins with this program of the first text.
    pub fn new(job: &'j Job<'j>, main: Option<&ProgramPlace>) -> CommentFinder<'j> {
        let mut comments =
            CommentFinder { job, other_language: None, head: Vec::new(), head_end: 0 };
        let Some(source) = job.sources().get(FileId(0)) else { return comments };
        let Some(control) = job.word_address() else {
            let programs = job.program_set();
            comments.take_first_lines(source, &*programs);
            comments.other_language = Some(programs);
            return comments;
        };
        let mut reader = BlockReader::new(source.text(), FileId(0), control.table.lexicon);
        let mut block = Block::new();
        if let Some(main) = main {
            // What stands before the number of the first program is about that program.
            reader.limit(main.range.start);
            let begin = reader.position();
            let mut only_head = true;
            while only_head && reader.read(&mut block) {
                only_head = is_head(&block);
            }
            reader.limit(main.range.end);
            let start = BlockPosition { offset: main.range.start, line: main.line };
            reader.seek(if only_head { begin } else { start });
        }
        for _ in 0..MAX_HEAD_BLOCKS {
            let is_head = reader.read(&mut block) && is_head(&block);
            if !is_head || comments.head.len() >= MAX_HEAD_COMMENTS {
                break;
            }
            comments.head_end = block.line;
            let is_title = block.word(b'O').is_some();
            let texts = block.comments.iter().map(|range| range.in_file(FileId(0)));
            let texts = texts.filter_map(|span| comment(span, job));
            comments.head.extend(texts.map(|text| HeadComment { text, is_title }));
        }
        comments
    }

    /// Takes the lines that are only comments at the beginning of a text in another language.
    fn take_first_lines(&mut self, source: &Source<'_>, programs: &dyn ProgramSet) {
        let tokens = programs.tokens(TextRange::new(0, source.text().len() as u32));
        let comments = tokens.iter().take_while(|token| token.class == TokenClass::Comment);
        for token in comments.take(MAX_HEAD_COMMENTS) {
            self.head_end = source.line_of(token.range.start);
            let text = comment(token.range.in_file(FileId(0)), self.job);
            self.head.extend(text.map(|text| HeadComment { text, is_title: false }));
        }
    }

    /// The comments at the head, but for the title.
    pub fn head(&self) -> Vec<String> {
        let others = self.head.iter().filter(|comment| !comment.is_title);
        others.map(|comment| comment.text.clone()).collect()
    }

    /// What the program says of a tool: in the block of its call, in a list at the head, on the
    /// line before or on the line after.
    pub fn of_tool(&self, number: u32, call: &Origin) -> Option<String> {
        let file = call.span.file;
        let after_head = file != FileId(0) || call.line > self.head_end + 1;
        self.in_line(file, call.line)
            .or_else(|| {
                let named = self.head.iter().find(|comment| names_tool(&comment.text, number));
                named.map(|comment| comment.text.clone())
            })
            .or_else(|| after_head.then(|| self.alone(file, call.line.wrapping_sub(1))).flatten())
            .or_else(|| self.alone(file, call.line + 1))
    }

    /// What the program says next to a block: in it, on the line before, on the line after.
    pub fn comment_at(&self, origin: &Origin) -> Option<String> {
        let (file, line) = (origin.span.file, origin.line);
        self.in_line(file, line)
            .or_else(|| self.alone(file, line.wrapping_sub(1)))
            .or_else(|| self.alone(file, line + 1))
    }

    fn in_line(&self, file: FileId, line: u32) -> Option<String> {
        self.of_line(file, line).map(|(text, _)| text)
    }

    /// The comment of a line that holds nothing else.
    fn alone(&self, file: FileId, line: u32) -> Option<String> {
        self.of_line(file, line).filter(|(_, alone)| *alone).map(|(text, _)| text)
    }

    fn of_line(&self, file: FileId, line: u32) -> Option<(String, bool)> {
        let source = self.job.sources().get(file).filter(|_| line > 0)?;
        let (start, text) = (source.line_start(line), source.line_text(line));
        if let Some(programs) = &self.other_language {
            let tokens = programs.tokens(TextRange::new(start, start + text.len() as u32));
            let of_comment = |token: &&Token| token.class == TokenClass::Comment;
            let found = tokens.iter().find(of_comment).filter(|_| file == FileId(0))?;
            let text = comment(found.range.in_file(file), self.job)?;
            return Some((text, tokens.iter().all(|token| of_comment(&token))));
        }
        let control = self.job.word_address()?;
        let mut reader = BlockReader::new(text, file, control.table.lexicon);
        let mut block = Block::new();
        if !reader.read(&mut block) {
            return None;
        }
        let alone =
            block.kind == BlockKind::Words && block.words.iter().all(|word| word.letter == b'N');
        let found = block.comments.iter().find_map(|range| {
            let mut span = range.in_file(file);
            span.range.start += start;
            span.range.end += start;
            comment(span, self.job)
        });
        found.map(|text| (text, alone))
    }
}

/// A block that carries nothing out: `%`, a program's number, comments.
fn is_head(block: &Block) -> bool {
    match block.kind {
        BlockKind::Words => block.words.iter().all(|word| matches!(word.letter, b'O' | b'N')),
        BlockKind::Percent | BlockKind::Folder => true,
        BlockKind::Macro(_) => false,
    }
}

/// True where a comment speaks of this tool: `T5 D=12. END MILL`, `TOOL 5 - DRILL`.
fn names_tool(comment: &str, number: u32) -> bool {
    let text = comment.trim_start();
    let Some(rest) = text.strip_prefix(['T', 't']) else { return false };
    let rest = match rest.get(..3) {
        Some(word) if word.eq_ignore_ascii_case("ool") => &rest[3..],
        _ => rest,
    };
    let rest = rest.trim_start_matches([' ', '#', ':', '-']);
    let digits = rest.bytes().take_while(u8::is_ascii_digit).count();
    rest[..digits].parse() == Ok(number)
}

/// The lines of the first text that the block delete switch leaves out.
pub fn skipped(job: &Job) -> CappedRows<u32> {
    let mut lines = CappedRows { rows: Vec::new(), left_out: 0 };
    let text = job.sources().get(FileId(0)).map_or(&[][..], |source| source.text());
    let Some(control) = job.word_address().filter(|_| text.contains(&b'/')) else { return lines };
    let mut reader = BlockReader::new(text, FileId(0), control.table.lexicon);
    let mut block = Block::new();
    while reader.read(&mut block) {
        if block.delete.is_none() {
            continue;
        }
        if lines.rows.len() < MAX_SKIPPED {
            lines.rows.push(block.line);
        } else {
            lines.left_out += 1;
        }
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_list_of_tools_is_read_as_people_write_it() {
        for text in ["T5 D=12.", "TOOL 5 - DRILL", "Tool #5", "T05", "tool: 5"] {
            assert!(names_tool(text, 5), "{text}");
        }
        for text in ["T51 DRILL", "TABLE 5", "5 HOLES", "TOOLING", "T", ""] {
            assert!(!names_tool(text, 5), "{text}");
        }
    }

    #[test]
    fn texts_are_made_safe_to_show() {
        assert_eq!(clean(" A\tB\u{7}\u{202e}C ", 20), "A B\u{fffd}\u{fffd}C");
        assert_eq!(clean("ABCDEF", 3), "ABC…");
        assert_eq!(clean("ÄÖÜ", 3), "ÄÖÜ");
    }

    #[test]
    fn a_title_stands_behind_the_number() {
        assert_eq!(title(b"O1 (PART A) (B)\nX1", 2).as_deref(), Some("PART A"));
        assert_eq!(title(b"O1 (MAIN\nX1", 2).as_deref(), Some("MAIN"));
        assert_eq!(title(b"O1\n(NO)", 2), None);
    }
}
