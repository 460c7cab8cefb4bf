//! The outline of a text, whatever its language.

use chordal::control::{TextSymbol, TextSymbolKind};
use chordal::diagnostics::{Source, TextRange};

/// What an entry of the outline is.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum EntryKind {
    /// A program, or the text before the first head.
    Program,
    /// A subroutine of O words, an L subroutine, a subprogram between labels.
    Subroutine,
    /// A tool that goes into the spindle.
    Tool,
    /// What a comment on a line of its own names.
    Operation,
    /// A block with a number, or a label.
    Label,
}

/// An entry of the outline.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct OutlineEntry {
    /// What it is called.
    pub name: String,
    /// More about it; may be empty.
    pub detail: String,
    /// What it is.
    pub kind: EntryKind,
    /// Everything that belongs to it.
    pub range: TextRange,
    /// Its own block.
    pub head: TextRange,
    /// Line of the head, from 1.
    pub line: u32,
    /// What lies in it.
    pub children: Vec<OutlineEntry>,
}

/// The outline of named places in order: each lies in the last one whose text contains it.
pub(crate) fn outline_of(symbols: Vec<TextSymbol>, source: &Source<'_>) -> Vec<OutlineEntry> {
    let mut roots = Vec::new();
    let mut open: Vec<OutlineEntry> = Vec::new();
    for symbol in symbols {
        close_before(symbol.range.start, &mut open, &mut roots);
        let mut range = symbol.body;
        if let Some(parent) = open.last() {
            range.end = range.end.min(parent.range.end);
        }
        open.push(OutlineEntry {
            name: symbol.name,
            detail: String::new(),
            kind: match symbol.kind {
                TextSymbolKind::Program => EntryKind::Program,
                TextSymbolKind::Subprogram => EntryKind::Subroutine,
                TextSymbolKind::Tool => EntryKind::Tool,
                TextSymbolKind::Label => EntryKind::Label,
            },
            range,
            head: symbol.range,
            line: source.line_of(symbol.range.start),
            children: Vec::new(),
        });
    }
    close_before(u32::MAX, &mut open, &mut roots);
    roots
}

/// Puts the entries that end at a byte or before it into those that contain them.
fn close_before(at: u32, open: &mut Vec<OutlineEntry>, roots: &mut Vec<OutlineEntry>) {
    while open.last().is_some_and(|entry| entry.range.end <= at) {
        let Some(entry) = open.pop() else { return };
        match open.last_mut() {
            Some(parent) => parent.children.push(entry),
            None => roots.push(entry),
        }
    }
}
