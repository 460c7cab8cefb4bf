//! Tools from the comments of a program, as posts and people write them:
//! `(T1 D=12. CR=0. - FLAT END MILL)`, `(TOOL 3 - .500 ENDMILL)`, `T5 M6 (#7 DRILL)`.
//!
//! What they say is for pictures, reports and the shape of a tool. It never becomes a value of the
//! control's offset tables: those hold what was measured.

mod drills;
mod forms;
mod phrases;
mod read;
mod scan;
mod stock;
mod tokens;
mod turning;

use std::collections::BTreeMap;

use chordal_command::Units;
use chordal_diagnostics::{Code, Diagnostic, FileId, Span};
use chordal_dialect::code_number;
use chordal_machine::{HolderDesignation, InsertDesignation, InsertLetter, Tool, ToolShape};
use chordal_syntax::{Block, BlockReader};

pub use self::read::read_tool_comment;
use self::scan::scan;
pub use self::stock::{CommentedStock, StockPlace, commented_stock};
use crate::Job;

/// Blocks among which the units of a program stand.
const MAX_UNIT_BLOCKS: usize = 500;

/// What a comment says of a tool. Millimetres and radians.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct CommentedTool {
    /// Its number.
    pub number: u32,
    /// The diameter.
    pub diameter_mm: Option<f64>,
    /// The radius of its corners.
    pub corner_radius_mm: Option<f64>,
    /// The whole angle of its point.
    pub point_angle_rad: Option<f64>,
    /// The flat at the end of a cone.
    pub tip_diameter_mm: Option<f64>,
    /// The pitch of its thread.
    pub pitch_mm: Option<f64>,
    /// What it is.
    pub shape: Option<ToolShape>,
    /// The nose radius of a turning tool.
    pub nose_radius_mm: Option<f64>,
    /// Its tip number.
    pub tip: Option<u32>,
    /// The letter of its insert.
    pub letter: Option<InsertLetter>,
    /// The designation of its insert.
    pub insert: Option<InsertDesignation>,
    /// That of its holder.
    pub holder: Option<HolderDesignation>,
    /// The nose radius of the words next to a designation that gives another one: neither is taken.
    pub other_nose_mm: Option<f64>,
}

impl CommentedTool {
    /// Nothing but the number of a tool; 0 for one that is called later.
    const fn of(number: u32) -> CommentedTool {
        CommentedTool {
            number,
            diameter_mm: None,
            corner_radius_mm: None,
            point_angle_rad: None,
            tip_diameter_mm: None,
            pitch_mm: None,
            shape: None,
            nose_radius_mm: None,
            tip: None,
            letter: None,
            insert: None,
            holder: None,
            other_nose_mm: None,
        }
    }

    /// Both together; nothing where they say different things.
    fn joined(&self, other: &CommentedTool) -> Option<CommentedTool> {
        let joined = CommentedTool {
            diameter_mm: self.diameter_mm.or(other.diameter_mm),
            corner_radius_mm: self.corner_radius_mm.or(other.corner_radius_mm),
            point_angle_rad: self.point_angle_rad.or(other.point_angle_rad),
            tip_diameter_mm: self.tip_diameter_mm.or(other.tip_diameter_mm),
            pitch_mm: self.pitch_mm.or(other.pitch_mm),
            shape: self.shape.or(other.shape),
            nose_radius_mm: self.nose_radius_mm.or(other.nose_radius_mm),
            letter: self.letter.or(other.letter),
            insert: self.insert.or(other.insert),
            ..*self
        };
        let differs = other.diameter_mm.is_some() && joined.diameter_mm != other.diameter_mm
            || other.corner_radius_mm.is_some()
                && joined.corner_radius_mm != other.corner_radius_mm
            || other.insert.is_some() && joined.insert != other.insert
            || other.shape.is_some() && joined.shape != other.shape;
        (!differs).then_some(joined)
    }
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
    for (stated, span) in commented_tools(job) {
        let tool = tools.entry(stated.number).or_insert_with(|| known(&Tool::default()));
        // Of a tool that the machine file measures, a comment may be out of date.
        if tool.comment.is_none()
            && tool.tool.diameter_mm.is_none()
            && fill(&mut tool.tool, &stated)
        {
            tool.comment = Some(span);
        }
    }
    tools
}

/// Comments of a lathe's program that say something else of a tool than the machine file, or than themselves.
pub(crate) fn contradicted_tools(job: &Job) -> Vec<Diagnostic> {
    if !job.turns() {
        return Vec::new();
    }
    let stated = scan(job).into_iter();
    stated
        .filter_map(|(tool, span)| {
            let known = job.machine().tools.get(&tool.number);
            let message = turning::contradiction(&tool, known)?;
            let help = "correct the one that is wrong: the value of the machine file counts";
            Some(Diagnostic::new(Code::ToolContradicted, span, message).help(help))
        })
        .collect()
}

/// True when the comment gave something.
fn fill(tool: &mut Tool, stated: &CommentedTool) -> bool {
    if stated.shape.is_some() && tool.shape.is_some() && stated.shape != tool.shape {
        return false;
    }
    let before = tool.clone();
    tool.diameter_mm = tool.diameter_mm.or(stated.diameter_mm);
    tool.shape = tool.shape.or(stated.shape);
    tool.corner_radius_mm = tool.corner_radius_mm.or(stated.corner_radius_mm);
    tool.point_angle_rad = tool.point_angle_rad.or(stated.point_angle_rad);
    tool.tip_diameter_mm = tool.tip_diameter_mm.or(stated.tip_diameter_mm);
    tool.pitch_mm = tool.pitch_mm.or(stated.pitch_mm);
    turning::fill(tool, stated);
    *tool != before
}

/// What the comments of the first text say, those with a diameter first.
fn commented_tools(job: &Job) -> Vec<(CommentedTool, Span)> {
    let mut stated = scan(job);
    stated.sort_by_key(|(tool, _)| tool.diameter_mm.is_none());
    stated
}

/// The units that the program begins in: its first G20 or G21, else the control's.
fn program_is_inch(job: &Job, text: &[u8]) -> bool {
    let mut reader = BlockReader::new(text, FileId(0), job.control().table.lexicon);
    let mut block = Block::new();
    for _ in 0..MAX_UNIT_BLOCKS {
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
