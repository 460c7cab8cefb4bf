//! What the words of a text are and mean, for the lines that a page shows.

use chordal_editor::{Class, Entry, EntryKind, Program, Role};
use serde_json::{Value, json};

use crate::answer::units_of;
use crate::program::Opened;

/// Entries of an outline that are sent.
const MOST_ENTRIES: usize = 2_000;

/// A text as an editor asks of it, with the machine and the subprograms of what was opened last.
/// `None` for settings that the control does not know: then nothing has run either.
pub fn program(opened: &Opened, text: Vec<u8>) -> Option<Program> {
    let (name, beside) = match opened.texts.split_first() {
        Some(((name, _), beside)) => (name.as_str(), beside.to_vec()),
        None => ("", Vec::new()),
    };
    let program = Program::new(name, text, opened.machine.clone()).ok()?;
    Some(program.beside(beside).run_with(opened.options.clone(), opened.program))
}

/// The words of the lines from `from` up to, not including, `to`: four numbers each, which are
/// line (from 1), first and last column (from 0, UTF-16), and the place of its class.
pub fn tokens(program: &Program, from: u32, to: u32) -> Value {
    let source = program.source();
    let mut numbers: Vec<usize> = Vec::new();
    for token in program.tokens(from, to) {
        let (line, start) = units_of(source, token.range.start);
        let (end_line, end) = units_of(source, token.range.end);
        if end_line == line {
            numbers.extend([line as usize, start, end, token.class as usize]);
        }
    }
    let classes = Class::ALL.map(|class| format!("{class:?}").to_ascii_lowercase());
    json!({ "type": "tokens", "classes": classes, "tokens": numbers })
}

/// The byte of a line (from 1) and a column (from 0, UTF-16).
fn offset_of(program: &Program, line: u32, column: usize) -> u32 {
    let source = program.source();
    let start = source.line_start(line);
    let text = String::from_utf8_lossy(source.line_text(line)).into_owned();
    let mut units = 0;
    let before = text.chars().take_while(|character| {
        units += character.len_utf16();
        units <= column
    });
    start + before.map(char::len_utf8).sum::<usize>() as u32
}

/// What the word at a line and a column means; null where there is none.
pub fn hover(program: &Program, line: u32, column: usize) -> Value {
    let source = program.source();
    let hover = program.hover(offset_of(program, line, column), None).map(|hover| {
        let (line, column) = units_of(source, hover.range.start);
        let (_, end_column) = units_of(source, hover.range.end);
        json!({ "line": line, "column": column, "end_column": end_column, "text": hover.text })
    });
    json!({ "type": "hover", "hover": hover })
}

/// Where the program, the label or the variable that stands at a line and a column is made; null
/// where nothing in the text makes it.
pub fn definition(program: &Program, line: u32, column: usize) -> Value {
    let name = program.name_at(offset_of(program, line, column));
    let places = name.map_or_else(Vec::new, |found| program.places_of(&found.name));
    let made = places.iter().find(|place| place.role == Role::Definition);
    let place = made.map(|place| {
        let (line, column) = units_of(program.source(), place.range.start);
        json!({ "line": line, "column": column })
    });
    json!({ "type": "definition", "place": place })
}

/// Programs, in them tools, in those operations.
pub fn outline(program: &Program) -> Value {
    let mut left = MOST_ENTRIES;
    json!({ "type": "outline", "entries": entries(&program.outline(), &mut left) })
}

fn entries(of: &[Entry], left: &mut usize) -> Vec<Value> {
    let mut told = Vec::new();
    for entry in of {
        let Some(less) = left.checked_sub(1) else { break };
        *left = less;
        told.push(json!({
            "name": entry.name,
            "detail": entry.detail,
            "kind": match entry.kind {
                EntryKind::Program => "program",
                EntryKind::Subroutine => "subroutine",
                EntryKind::Tool => "tool",
                EntryKind::Operation => "operation",
                EntryKind::Label => "label",
            },
            "line": entry.line,
            "children": entries(&entry.children, left),
        }));
    }
    told
}
