//! Reads tools from the comments of a program, as post processors and people write them: `(T1 D=12. CR=0. - FLAT END
//! MILL)`, `(TOOL 3 - .500 ENDMILL)`, `T5 M6 (#7 DRILL)`.
//!
//! The result is for pictures, reports and the shape of a tool. It never becomes a value of the control's offset
//! tables: those hold measured values.

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
use chordal_dialect::{Control, code_number};
use chordal_kernel::DefinedTool;
use chordal_machine::{HolderDesignation, InsertDesignation, InsertLetter, Tool, ToolShape};
use chordal_syntax::{Block, BlockReader};

pub use self::read::read_tool_comment;
use self::scan::scan;
pub use self::stock::{CommentedStock, StockPlace, commented_stock};
use crate::Job;

/// Number of blocks at the head of a program in which its units are looked for.
const MAX_UNIT_BLOCKS: usize = 500;

/// What a comment says about a tool; each field is `None` where it does not say it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct CommentedTool {
    /// Its number.
    pub number: u32,
    /// Diameter, mm.
    pub diameter_mm: Option<f64>,
    /// Radius of its corners, mm.
    pub corner_radius_mm: Option<f64>,
    /// Included angle of its point, rad.
    pub point_angle_rad: Option<f64>,
    /// Diameter of the flat at the end of a cone, mm.
    pub tip_diameter_mm: Option<f64>,
    /// Pitch of its thread, mm.
    pub pitch_mm: Option<f64>,
    /// Its shape.
    pub shape: Option<ToolShape>,
    /// Nose radius of a turning tool, mm.
    pub nose_radius_mm: Option<f64>,
    /// Its tip number.
    pub tip: Option<u32>,
    /// The letter of its insert.
    pub letter: Option<InsertLetter>,
    /// The designation of its insert.
    pub insert: Option<InsertDesignation>,
    /// The designation of its holder.
    pub holder: Option<HolderDesignation>,
    /// The nose radius in words, mm, where it contradicts that of the insert's designation: then neither is taken.
    pub other_nose_mm: Option<f64>,
}

impl CommentedTool {
    /// Only the number of a tool; 0 for a tool that is called later.
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

    /// Both together; `None` where they contradict each other.
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
    /// The tool of the machine file, completed from the comment.
    pub tool: Tool,
    /// The comment from which something was taken; `None` without one.
    pub comment: Option<Span>,
    /// The block of the program that defines it, where its shape was assumed because neither the block nor anything else
    /// says it (TOOL DEF).
    pub assumed: Option<Span>,
}

/// Every tool of the machine file and of the comments of the program. The machine file has precedence: a comment
/// gives only what it leaves open. Diameter and shape of a tool come from one source.
pub fn known_tools(job: &Job) -> BTreeMap<u32, KnownTool> {
    let known = |tool: &Tool| KnownTool { tool: tool.clone(), comment: None, assumed: None };
    let mut tools: BTreeMap<u32, KnownTool> =
        job.machine().tools.iter().map(|(number, tool)| (*number, known(tool))).collect();
    for (commented, span) in commented_tools(job) {
        let tool = tools.entry(commented.number).or_insert_with(|| known(&Tool::default()));
        // Where the machine file has a diameter, a comment may be out of date.
        if tool.comment.is_none()
            && tool.tool.diameter_mm.is_none()
            && fill(&mut tool.tool, &commented)
        {
            tool.comment = Some(span);
        }
    }
    assume_shapes(job, &mut tools);
    tools
}

/// Gives the tools that the program itself defines the shape that is assumed of them, where nothing else says it.
fn assume_shapes(job: &Job, tools: &mut BTreeMap<u32, KnownTool>) {
    let text = job.sources().get(FileId(0)).map(|source| source.text());
    let defined = text.map(|text| job.configured_control().defined_tools(text));
    for DefinedTool { number, tool, range } in defined.into_iter().flatten() {
        let known = tools.entry(number).or_insert_with(|| KnownTool {
            tool: Tool::default(),
            comment: None,
            assumed: None,
        });
        if known.tool.shape.is_some() {
            continue;
        }
        // The radius of the block is that of the run.
        known.tool.diameter_mm = tool.diameter_mm;
        known.tool.shape = tool.shape;
        known.tool.flute_length_mm = known.tool.flute_length_mm.or(tool.flute_length_mm);
        known.assumed = Some(range.in_file(FileId(0)));
    }
}

/// Comments of a lathe program that contradict the machine file, or themselves.
pub(crate) fn contradicted_tools(job: &Job) -> Vec<Diagnostic> {
    if !job.turns() {
        return Vec::new();
    }
    let commented = scan(job).into_iter();
    commented
        .filter_map(|(tool, span)| {
            let known = job.machine().tools.get(&tool.number);
            let message = turning::contradiction(&tool, known)?;
            let help = "correct the one that is wrong: the value of the machine file counts";
            Some(Diagnostic::new(Code::ToolContradicted, span, message).help(help))
        })
        .collect()
}

/// Completes a tool from a comment. Returns true where something was taken.
fn fill(tool: &mut Tool, commented: &CommentedTool) -> bool {
    if commented.shape.is_some() && tool.shape.is_some() && commented.shape != tool.shape {
        return false;
    }
    let before = tool.clone();
    tool.diameter_mm = tool.diameter_mm.or(commented.diameter_mm);
    tool.shape = tool.shape.or(commented.shape);
    tool.corner_radius_mm = tool.corner_radius_mm.or(commented.corner_radius_mm);
    tool.point_angle_rad = tool.point_angle_rad.or(commented.point_angle_rad);
    tool.tip_diameter_mm = tool.tip_diameter_mm.or(commented.tip_diameter_mm);
    tool.pitch_mm = tool.pitch_mm.or(commented.pitch_mm);
    turning::fill(tool, commented);
    *tool != before
}

/// The tools of the comments of the first text, those with a diameter first.
fn commented_tools(job: &Job) -> Vec<(CommentedTool, Span)> {
    let mut commented = scan(job);
    commented.sort_by_key(|(tool, _)| tool.diameter_mm.is_none());
    commented
}

/// Whether the program begins in inch: by its first G20 or G21, or else by the control's setting.
fn program_is_inch(control: &Control, text: &[u8]) -> bool {
    let mut reader = BlockReader::new(text, FileId(0), control.table.lexicon);
    let mut block = Block::new();
    for _ in 0..MAX_UNIT_BLOCKS {
        if !reader.read(&mut block) {
            break;
        }
        for word in block.all(b'G') {
            let code = word.number().and_then(code_number);
            let row = code.and_then(|code| control.g_code(code));
            if let Some(units) = row.and_then(|row| row.action.units()) {
                return units == Units::Inch;
            }
        }
    }
    control.parameters.rules.units == Units::Inch
}
