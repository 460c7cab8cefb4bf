//! The programs of a text: a tape has several, each with a head.

use chordal_diagnostics::TextRange;

use super::ast::StatementKind;
use super::reader::BlockReader;
use super::scanner::is_blank;

/// What a program is by its head.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ProgramUnitKind {
    /// `_MPF`: a main program.
    Main,
    /// `_SPF`, or a program that begins with PROC: a subprogram.
    Sub,
    /// Neither is stated.
    Unknown,
    /// Definitions and tables of the control: no program.
    Table,
}

/// A program of a text.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct ProgramUnit {
    /// Its name in upper case without `_N_` and the type, from the head or from PROC; `None` without both.
    pub name: Option<String>,
    /// What it is.
    pub kind: ProgramUnitKind,
    /// Its text with its head.
    pub range: TextRange,
    /// The lines of its head: `%_N_NAME_MPF` and `;$PATH=…`; empty without a head.
    pub head: TextRange,
    /// The line after the head, from 1. A reader of its blocks begins at the end of `head` with this line.
    pub first_line: u32,
}

/// The programs of a text in order. A text without a head is one program.
pub fn units(text: &[u8]) -> Vec<ProgramUnit> {
    let mut units: Vec<ProgramUnit> = Vec::new();
    let mut reader = BlockReader::new(text);
    let mut has_content = false;
    let mut is_in_head = false;
    while let Some((range, _)) = reader.next_line() {
        let line = trimmed(range.slice(text));
        if let Some((name, kind)) = head_name(line) {
            // Comments before the first head belong to its program.
            let start = if units.is_empty() && !has_content { 0 } else { range.start };
            if units.is_empty() && has_content {
                units.push(headless(range.start));
            }
            if let Some(before) = units.last_mut() {
                before.range.end = range.start;
            }
            units.push(ProgramUnit {
                name: Some(name),
                kind,
                range: TextRange::new(start, start),
                head: TextRange::new(start, reader.offset()),
                first_line: reader.line(),
            });
            is_in_head = true;
            continue;
        }
        is_in_head = is_in_head && is_path_line(line);
        match units.last_mut() {
            Some(unit) if is_in_head => {
                unit.head.end = reader.offset();
                unit.first_line = reader.line();
            }
            _ => has_content |= !line.is_empty() && !matches!(line[0], b';' | b'%'),
        }
    }
    if units.is_empty() {
        units.push(headless(text.len() as u32));
    }
    if let Some(last) = units.last_mut() {
        last.range.end = text.len() as u32;
    }
    for unit in &mut units {
        name_by_procedure(text, unit);
    }
    units
}

/// The program of the text before any head.
fn headless(end: u32) -> ProgramUnit {
    ProgramUnit {
        name: None,
        kind: ProgramUnitKind::Unknown,
        range: TextRange::new(0, end),
        head: TextRange::new(0, 0),
        first_line: 1,
    }
}

/// Takes the name, and what is not known about the kind, from PROC. Only the first block with statements can be PROC.
fn name_by_procedure(text: &[u8], unit: &mut ProgramUnit) {
    let mut reader = BlockReader::new(text);
    reader.seek(unit.head.end, unit.first_line);
    reader.limit(unit.range.end);
    let Some(block) = reader.find(|block| !block.statements.is_empty()) else { return };
    let Some(StatementKind::Procedure(head)) = block.statements.first().map(|first| &first.kind)
    else {
        return;
    };
    unit.name.get_or_insert_with(|| head.name.clone());
    if unit.kind == ProgramUnitKind::Unknown {
        unit.kind = ProgramUnitKind::Sub;
    }
}

/// Blocks of a text that are looked at to find out what it is.
const BLOCKS_OF_RECOGNITION: usize = 50;

/// Whether a text is one of definitions (`DEF NCK REAL …`) or a dump of the control's tables (`$TC_DP3[1,1]=100`,
/// `$P_UIFR[1]=CTRANS(…)`, `R[1]=0`), not a program.
pub fn is_table_text(text: &[u8]) -> bool {
    let mut has_entry = false;
    for block in BlockReader::new(text).take(BLOCKS_OF_RECOGNITION) {
        for statement in &block.statements {
            match &statement.kind {
                StatementKind::Define(_) => {
                    let words = statement.range.slice(text).to_ascii_uppercase();
                    let has = |word: &[u8]| words.windows(word.len()).any(|part| part == word);
                    if !has(b" NCK ") && !has(b" CHAN ") {
                        return false;
                    }
                    has_entry = true;
                }
                StatementKind::Word(word) => match &*word.address.name {
                    "M" => {}
                    "R" => has_entry = true,
                    name if name.starts_with('$') => has_entry = true,
                    _ => return false,
                },
                StatementKind::Macro { .. } => has_entry = true,
                StatementKind::Call(call) if call.name == "CHANDATA" => {}
                StatementKind::Name(name) if name == "METRIC" || name == "INCH" => {}
                _ => return false,
            }
        }
    }
    has_entry
}

fn trimmed(line: &[u8]) -> &[u8] {
    let start = line.iter().position(|byte| !is_blank(*byte)).unwrap_or(line.len());
    let end = line.iter().rposition(|byte| !is_blank(*byte)).map_or(start, |last| last + 1);
    &line[start..end]
}

pub(super) fn is_path_line(line: &[u8]) -> bool {
    line.get(..6).is_some_and(|start| start.eq_ignore_ascii_case(b";$PATH"))
}

/// The name and the kind of a head: `%_N_NAME_MPF`, `%NAME_SPF`, `%MPF12`. `None` for any other line.
pub(super) fn head_name(line: &[u8]) -> Option<(String, ProgramUnitKind)> {
    let rest = line.strip_prefix(b"%")?;
    let length = rest.iter().take_while(|byte| byte.is_ascii_alphanumeric() || **byte == b'_');
    let name = String::from_utf8(rest[..length.count()].to_ascii_uppercase()).ok()?;
    let name = name.strip_prefix("_N_").unwrap_or(&name);
    if name.is_empty() {
        return None;
    }
    for (suffix, prefix, kind) in
        [("_MPF", "MPF", ProgramUnitKind::Main), ("_SPF", "SPF", ProgramUnitKind::Sub)]
    {
        let short = name.strip_suffix(suffix).or_else(|| {
            // `%MPF12`: the head of older controls, whose programs are numbers.
            name.strip_prefix(prefix).filter(|rest| rest.bytes().all(|byte| byte.is_ascii_digit()))
        });
        if let Some(short) = short.filter(|short| !short.is_empty()) {
            return Some((short.to_string(), kind));
        }
    }
    Some((name.to_string(), ProgramUnitKind::Unknown))
}
