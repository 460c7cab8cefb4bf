//! Tools from the comments of a program, as posts and people write them:
//! `(T1 D=12. CR=0. - FLAT END MILL)`, `(TOOL 3 - .500 ENDMILL)`, `T5 M6 (#7 DRILL)`.
//!
//! What they say is for pictures, reports and the shape of a tool. It never becomes a value of the
//! control's offset tables: those hold what was measured.

mod drills;
mod read;
mod tokens;

use std::collections::BTreeMap;

use chordal_command::Units;
use chordal_diagnostics::{FileId, Span};
use chordal_dialect::{Action, BeforeCode, code_number};
use chordal_machine::{Tool, ToolShape};
use chordal_syntax::{Block, BlockReader, Position};

pub use self::read::read_tool_comment;
use crate::Job;

/// Blocks among which the units of a program stand.
const MOST_UNIT_BLOCKS: usize = 500;

/// What a comment says of a tool. Millimetres and radians.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SaidTool {
    /// Its number.
    pub number: u32,
    /// The diameter.
    pub diameter_mm: Option<f64>,
    /// The radius of its corners.
    pub corner_radius_mm: Option<f64>,
    /// The whole angle of its point.
    pub point_angle_rad: Option<f64>,
    /// The pitch of its thread.
    pub pitch_mm: Option<f64>,
    /// What it is.
    pub shape: Option<ToolShape>,
}

/// A tool as the machine file and the program's comments have it.
#[derive(Clone, Debug, PartialEq)]
pub struct KnownTool {
    /// The machine file's tool, what it leaves open filled in from the comment.
    pub tool: Tool,
    /// The comment that gave something.
    pub comment: Option<Span>,
}

/// Every tool that the machine file or a comment of the program speaks of. The machine file comes first:
/// a comment gives only what it leaves open, and the diameter and the shape of one tool from one of them.
pub fn known_tools(job: &Job) -> BTreeMap<u32, KnownTool> {
    let known = |tool: &Tool| KnownTool { tool: tool.clone(), comment: None };
    let mut tools: BTreeMap<u32, KnownTool> =
        job.machine().tools.iter().map(|(number, tool)| (*number, known(tool))).collect();
    for (said, span) in said_tools(job) {
        let tool = tools.entry(said.number).or_insert_with(|| known(&Tool::default()));
        // Of a tool that the machine file measures, a comment may be out of date.
        if tool.comment.is_none() && tool.tool.diameter_mm.is_none() && fill(&mut tool.tool, &said)
        {
            tool.comment = Some(span);
        }
    }
    tools
}

/// True when the comment gave something.
fn fill(tool: &mut Tool, said: &SaidTool) -> bool {
    if said.shape.is_some() && tool.shape.is_some() && said.shape != tool.shape {
        return false;
    }
    let before = tool.clone();
    tool.diameter_mm = said.diameter_mm;
    tool.shape = tool.shape.or(said.shape);
    tool.corner_radius_mm = tool.corner_radius_mm.or(said.corner_radius_mm);
    tool.point_angle_rad = tool.point_angle_rad.or(said.point_angle_rad);
    tool.pitch_mm = tool.pitch_mm.or(said.pitch_mm);
    *tool != before
}

/// What the comments of the first text say, those with a diameter first.
fn said_tools(job: &Job) -> Vec<(SaidTool, Span)> {
    let Some(source) = job.sources().get(FileId(0)) else { return Vec::new() };
    let text = source.text();
    let mut inch = None;
    let mut reader = BlockReader::new(text, FileId(0), job.control().table.lexicon);
    let mut block = Block::new();
    let mut said = Vec::new();
    for (offset, line) in lines(text) {
        // Reading blocks costs more than looking at bytes, and few lines hold a comment on a tool.
        if !may_say(line) {
            continue;
        }
        reader.seek(Position { offset, line: 1 });
        if !reader.read(&mut block) {
            continue;
        }
        let changes = block.words.iter().any(|word| {
            let row = job.control().row_of(word);
            row.is_some_and(|row| row.action == Action::Before(BeforeCode::ToolChange))
        });
        let called = block.word(b'T').filter(|_| changes);
        let called = called.and_then(|word| u32::try_from(word.number()?.to_integer()?).ok());
        for range in &block.comments {
            let inch = *inch.get_or_insert_with(|| program_is_inch(job, text));
            let words = String::from_utf8_lossy(range.slice(text));
            let words = words.trim_matches(['(', ')', ';', '*', '\'', ' ', '\t']);
            let tool = read_tool_comment(words, inch, called.filter(|number| *number > 0));
            said.extend(tool.map(|tool| (tool, range.in_file(FileId(0)))));
        }
    }
    said.sort_by_key(|(said, _)| said.diameter_mm.is_none());
    said
}

fn lines(text: &[u8]) -> impl Iterator<Item = (u32, &[u8])> {
    let mut offset = 0;
    text.split_inclusive(|byte| matches!(byte, b'\n' | b'\r')).map(move |line| {
        let at = offset;
        // A text of 4 GB is refused long before.
        offset += line.len() as u32;
        (at, line)
    })
}

/// A comment begins in the line, and there is a T in it.
fn may_say(line: &[u8]) -> bool {
    let opens = |byte: &u8| matches!(byte, b'(' | b';' | b'*' | b'\'');
    line.iter().any(opens) && line.iter().any(|byte| matches!(byte, b't' | b'T'))
}

/// The units that the program begins in: its first G20 or G21, else the control's.
fn program_is_inch(job: &Job, text: &[u8]) -> bool {
    let mut reader = BlockReader::new(text, FileId(0), job.control().table.lexicon);
    let mut block = Block::new();
    for _ in 0..MOST_UNIT_BLOCKS {
        if !reader.read(&mut block) {
            break;
        }
        for word in block.all(b'G') {
            let code = word.number().and_then(code_number);
            let row = code.and_then(|code| job.control().g_code(code));
            if let Some(units) = row.and_then(|row| row.action.units()) {
                return units == Units::Inch;
            }
        }
    }
    job.control().parameters.rules.units == Units::Inch
}
