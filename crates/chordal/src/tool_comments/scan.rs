//! Finds out which comments of a program are about which tool.

use chordal_diagnostics::{FileId, Span};
use chordal_dialect::{Action, BeforeCode, Control, DataTarget};
use chordal_syntax::{Block, BlockPosition, BlockReader};

use super::forms::{number as plain_number, read_form};
use super::phrases::{named_tool, read_phrase};
use super::turning::read_insert;
use super::{CommentedTool, program_is_inch, read_tool_comment};
use crate::Job;

/// The tools of the comments of the first text: comments with a number first, each group in the order of the text.
pub(super) fn scan(job: &Job) -> Vec<(CommentedTool, Span)> {
    let Some(source) = job.sources().get(FileId(0)) else { return Vec::new() };
    let Some(control) = job.word_address() else { return Vec::new() };
    let text = source.text();
    let writes_tools =
        control.table.set_data.iter().any(|(_, target)| *target == DataTarget::ToolTable);
    let mut scan = ToolCommentScan {
        control,
        turns: job.turns(),
        text,
        inch: None,
        named: None,
        loose: None,
        last: 0,
        found: Vec::new(),
        without_number: Vec::new(),
    };
    let mut reader = BlockReader::new(text, FileId(0), control.table.lexicon);
    let mut block = Block::new();
    for (offset, line) in lines(text) {
        // Parsing a block costs more than scanning its bytes, and few lines have a comment or call a tool.
        if scan.loose.is_none() && !may_say(line, writes_tools) {
            continue;
        }
        reader.seek(BlockPosition { offset, line: 1 });
        if reader.read(&mut block) {
            scan.block(&block);
        }
    }
    scan.give_loose();
    scan.finish()
}

struct ToolCommentScan<'j> {
    control: &'j Control,
    turns: bool,
    text: &'j [u8],
    inch: Option<bool>,
    /// The tool number from a separate comment, for the comment after it.
    named: Option<u32>,
    /// A description without a number.
    loose: Option<(CommentedTool, Span)>,
    /// The tool that was called last; 0 where none was.
    last: u32,
    found: Vec<(CommentedTool, Span)>,
    /// Descriptions without a number, with the number of the tool that they were assigned to.
    without_number: Vec<(CommentedTool, Span)>,
}

impl ToolCommentScan<'_> {
    fn block(&mut self, block: &Block) {
        let called = self.called(block);
        if let Some(number) = called {
            self.last = number;
            self.give_loose();
            self.named = None;
        } else if b"XYZ".iter().any(|axis| block.word(*axis).is_some()) {
            // The program moves before it calls a tool: the description is of the tool that is in the spindle.
            self.give_loose();
        }
        let written = self.written(block);
        self.found.extend(written);
        let changes = block.words.iter().any(|word| {
            let row = self.control.row_of(word);
            row.is_some_and(|row| row.action == Action::Before(BeforeCode::ToolChange))
        });
        for range in &block.comments {
            let inch = *self.inch.get_or_insert_with(|| program_is_inch(self.control, self.text));
            let words = String::from_utf8_lossy(range.slice(self.text));
            let words = words.trim_matches(['(', ')', ';', '*', '\'', ' ', '\t']);
            let span = range.in_file(FileId(0));
            self.comment(words, inch, called, changes, span);
        }
    }

    fn comment(&mut self, words: &str, inch: bool, called: Option<u32>, changes: bool, span: Span) {
        if let Some(number) = named_tool(words) {
            self.named = Some(number);
            return;
        }
        // The number counts for the next comment only.
        let named = self.named.take();
        let loose = read_form(words, inch).or_else(|| read_phrase(words, inch, named));
        match loose {
            Some(tool) if tool.number > 0 => self.found.push((tool, span)),
            Some(tool) => match called {
                Some(number) => self.without_number.push((CommentedTool { number, ..tool }, span)),
                None => self.keep(tool, span),
            },
            None => {
                let called = called.filter(|_| changes);
                let turns = self.turns;
                match read_tool_comment(words, inch, called, turns) {
                    Some(tool) => self.found.push((tool, span)),
                    // `(OD ROUGH RIGHT - 80 DEG. INSERT - CNMG-432)` describes the tool that is called next.
                    None if turns => {
                        if let Some(commented) = read_insert(words) {
                            self.keep(commented, span);
                        }
                    }
                    None => {}
                }
            }
        }
    }

    /// Adds a description to that of the tool that is called next; one that contradicts it replaces it.
    fn keep(&mut self, commented: CommentedTool, span: Span) {
        let joined = self.loose.and_then(|(before, at)| Some((before.joined(&commented)?, at)));
        self.loose = Some(joined.unwrap_or((commented, span)));
    }

    fn give_loose(&mut self) {
        let Some((commented, span)) = self.loose.take() else { return };
        self.without_number.push((CommentedTool { number: self.last, ..commented }, span));
    }

    /// Comments that name their tool come first. Where others give two sizes for one tool, another tool was put into
    /// the spindle without a call, and neither is taken.
    fn finish(mut self) -> Vec<(CommentedTool, Span)> {
        let is_only = |(commented, _): &&(CommentedTool, Span)| {
            let same =
                self.without_number.iter().filter(|(other, _)| other.number == commented.number);
            let mut sizes = same.filter_map(|(other, _)| other.diameter_mm);
            let first = sizes.next();
            sizes.all(|size| Some(size) == first)
        };
        self.found.extend(self.without_number.iter().filter(is_only));
        self.found
    }

    /// `G10 L1 P1 R[10/2]` writes the radius of a tool into the control's table. People write half the diameter as a
    /// quotient.
    fn written(&mut self, block: &Block) -> Option<(CommentedTool, Span)> {
        let l = block.word(b'L')?.number()?.to_integer()?;
        let is_tool = |(number, target): &(u16, DataTarget)| {
            i64::from(*number) == l && *target == DataTarget::ToolTable
        };
        if !self.control.table.set_data.iter().any(is_tool) {
            return None;
        }
        let is_g10 =
            block.all(b'G').any(|word| word.number().and_then(|n| n.to_integer()) == Some(10));
        let number = block.word(b'P')?.number()?.to_integer()?;
        let number = u32::try_from(number).ok().filter(|number| is_g10 && *number > 0)?;
        let radius = block.word(b'R')?.range;
        let text = String::from_utf8_lossy(radius.slice(self.text)).into_owned();
        let value = text.trim_start_matches(['R', 'r', ' ']).trim_matches(['[', ']', ' ']);
        let radius = match value.split_once('/') {
            Some((above, below)) => {
                plain_number(above)? / plain_number(below).filter(|n| *n > 0.0)?
            }
            None => plain_number(value)?,
        };
        let inch = *self.inch.get_or_insert_with(|| program_is_inch(self.control, self.text));
        let diameter = 2.0 * radius * if inch { 25.4 } else { 1.0 };
        (diameter > 0.0).then(|| {
            let commented =
                CommentedTool { diameter_mm: Some(diameter), ..CommentedTool::of(number) };
            (commented, block.range.in_file(FileId(0)))
        })
    }

    /// The number of the tool that a block calls; on a lathe that of its station.
    fn called(&self, block: &Block) -> Option<u32> {
        let number = block.word(b'T')?.number()?.to_integer()?;
        let number = u32::try_from(number).ok()?;
        let station = match (self.turns, number) {
            (true, 100..) => number / 100,
            _ => number,
        };
        Some(station).filter(|number| *number > 0)
    }
}

/// The lines of a text with their offsets; a line ends at `\n` or `\r`.
fn lines(text: &[u8]) -> impl Iterator<Item = (u32, &[u8])> {
    let mut at = 0;
    std::iter::from_fn(move || {
        let rest = text.get(at..).filter(|rest| !rest.is_empty())?;
        let length = memchr::memchr2(b'\n', b'\r', rest).map_or(rest.len(), |end| end + 1);
        // A text of 4 GB is refused long before.
        let line = (at as u32, &rest[..length]);
        at += length;
        Some(line)
    })
}

/// Whether a line may have a comment or call a tool; with `writes_tools` also whether it may write one into the
/// control's table (G10).
fn may_say(line: &[u8], writes_tools: bool) -> bool {
    line.iter().enumerate().any(|(at, byte)| match byte {
        b'(' | b';' | b'*' | b'\'' | b't' | b'T' => true,
        b'g' | b'G' => writes_tools && line[at + 1..].starts_with(b"10"),
        _ => false,
    })
}
