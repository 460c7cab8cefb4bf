//! Answers questions about a text: classes, meanings and definitions of words, and the outline.

use chordal::Source;
use chordal::diagnostics::FileId;
use chordal_editor::{
    EditorProgram, EntryKind, LineColumnIndex, OutlineEntry, TokenClass, byte_of, line_and_column,
};
use serde_json::{Value, json};

/// The most entries of an outline that are sent.
const MAX_ENTRIES: usize = 2_000;

/// The most coloured words of one answer: the end of a very long line stays uncoloured.
const MAX_TOKENS: usize = 20_000;

/// The most bytes of another text that are sent: subprograms are short.
const MAX_TEXT_BYTES: usize = 1 << 20;

/// The words of the lines from `from` up to, not including, `to`, as four numbers each: line (from 1), start and end
/// column (from 0, in UTF-16 code units), and the index of its class.
pub fn tokens(program: &EditorProgram, from: u32, to: u32) -> Value {
    let mut places = LineColumnIndex::of(program.source());
    let mut numbers: Vec<u32> = Vec::new();
    for token in program.tokens(from, to).into_iter().take(MAX_TOKENS) {
        let (line, start) = places.at(token.range.start);
        let (end_line, end) = places.at(token.range.end);
        if end_line == line {
            numbers.extend([line, start, end, token.class as u32]);
        }
    }
    let classes = TokenClass::ALL.map(|class| format!("{class:?}").to_ascii_lowercase());
    json!({ "type": "tokens", "classes": classes, "tokens": numbers })
}

/// The meaning of the word at a line and a column; null when there is none.
pub fn hover(program: &EditorProgram, line: u32, column: u32) -> Value {
    let source = program.source();
    let hover = program.hover(byte_of(program.source(), line, column), None).map(|hover| {
        let (line, column) = line_and_column(source, hover.range.start);
        let (_, end_column) = line_and_column(source, hover.range.end);
        json!({ "line": line, "column": column, "end_column": end_column, "text": hover.text })
    });
    json!({ "type": "hover", "hover": hover })
}

/// The definition of the program, label or variable at a line and a column; null when it is not defined. A definition
/// in another text is sent with that text.
pub fn definition(program: &EditorProgram, line: u32, column: u32) -> Value {
    let name = program.name_at(byte_of(program.source(), line, column));
    let made = name.and_then(|found| program.definitions(&found.name).into_iter().next());
    let place = made.map(|found| {
        let start = found.place.range.start;
        if found.file == FileId(0) {
            let (line, column) = line_and_column(program.source(), start);
            return json!({ "line": line, "column": column });
        }
        let text = program.file_text(found.file);
        let shown = &text[..text.len().min(MAX_TEXT_BYTES)];
        let (line, column) = line_and_column(&Source::new("", text), start);
        json!({
            "line": line,
            "column": column,
            "file": program.file_name(found.file),
            "text": String::from_utf8_lossy(shown),
            "cut_off": shown.len() < text.len(),
        })
    });
    json!({ "type": "definition", "place": place })
}

/// The outline: programs contain tools, and tools contain operations.
pub fn outline(program: &EditorProgram) -> Value {
    let mut left = MAX_ENTRIES;
    json!({ "type": "outline", "entries": entries(&program.outline(), &mut left) })
}

fn entries(of: &[OutlineEntry], left: &mut usize) -> Vec<Value> {
    let mut values = Vec::new();
    for entry in of {
        let Some(less) = left.checked_sub(1) else { break };
        *left = less;
        values.push(json!({
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
    values
}
