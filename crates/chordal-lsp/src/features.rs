//! Answers the editor's requests about one document.

use chordal::Source;
use chordal::control::number_text;
use chordal::diagnostics::FileId;
use chordal_editor::{
    CompletionKind, EditorProgram, NameRole, OccurrenceInFile, RunMoves, SymbolName,
};
use lsp_types::{
    CompletionItem, CompletionItemKind, CompletionTextEdit, Documentation, Hover, HoverContents,
    InlayHint, InlayHintLabel, InlayHintTooltip, Location, MarkupContent, MarkupKind, Position,
    Range, TextEdit, Uri,
};

use crate::convert::line_end;
use crate::file_uri::address_of;
use crate::place::{offset_of, range_of};

fn markdown(value: String) -> MarkupContent {
    MarkupContent { kind: MarkupKind::Markdown, value }
}

/// The meaning of a word, and the modal state after its line; `None` when there is no word.
pub fn hover(program: &EditorProgram, ran: Option<&RunMoves>, place: Position) -> Option<Hover> {
    let offset = offset_of(program.source(), place);
    let found = program.hover(offset, ran)?;
    let mut text = found.text;
    if let Some(modal) = program.modal_after(place.line + 1) {
        let state = program.modal_text(&modal);
        text.push_str(&format!("\n\nAfter this line:\n```text\n{state}\n```"));
    }
    let range = Some(range_of(program.source(), found.range));
    Some(Hover { contents: HoverContents::Markup(markdown(text)), range })
}

/// The completions at a position.
pub fn completions(program: &EditorProgram, place: Position) -> Vec<CompletionItem> {
    let offset = offset_of(program.source(), place);
    let (start, found) = program.completions(offset);
    let range = range_of(program.source(), chordal::diagnostics::TextRange::new(start, offset));
    found
        .into_iter()
        .enumerate()
        .map(|(index, completion)| CompletionItem {
            label: completion.text.clone(),
            detail: Some(completion.detail),
            documentation: (!completion.more.is_empty())
                .then_some(Documentation::String(completion.more)),
            kind: Some(match completion.kind {
                CompletionKind::Code => CompletionItemKind::KEYWORD,
                CompletionKind::Letter => CompletionItemKind::FIELD,
                CompletionKind::Variable => CompletionItemKind::VARIABLE,
                CompletionKind::Place => CompletionItemKind::REFERENCE,
                CompletionKind::Tool => CompletionItemKind::CLASS,
            }),
            sort_text: Some(format!("{index:05}")),
            text_edit: Some(CompletionTextEdit::Edit(TextEdit {
                range,
                new_text: completion.text,
            })),
            ..CompletionItem::default()
        })
        .collect()
}

/// The definitions of the name at a position; for a variable, its assignments.
pub fn definitions(program: &EditorProgram, uri: &Uri, place: Position) -> Vec<Location> {
    let Some(name) = name_at(program, place) else { return Vec::new() };
    locations(program, uri, program.definitions(&name))
}

/// All occurrences of the name at a position.
pub fn references(
    program: &EditorProgram,
    uri: &Uri,
    place: Position,
    with_definitions: bool,
) -> Vec<Location> {
    let Some(name) = name_at(program, place) else { return Vec::new() };
    let mut found = program.references(&name);
    found.retain(|found| with_definitions || found.place.role == NameRole::Use);
    locations(program, uri, found)
}

/// Converts occurrences to protocol locations; those in other texts are given by their files.
fn locations(program: &EditorProgram, uri: &Uri, found: Vec<OccurrenceInFile>) -> Vec<Location> {
    let mut last: Option<(FileId, Uri, Source<'_>)> = None;
    let mut locations = Vec::new();
    for OccurrenceInFile { file, place } in found {
        if file == FileId(0) {
            let range = range_of(program.source(), place.range);
            locations.push(Location { uri: uri.clone(), range });
            continue;
        }
        if last.as_ref().is_none_or(|(known, ..)| *known != file) {
            let Some(uri) = uri_of(program.file_name(file)) else { continue };
            last = Some((file, uri, Source::new("", program.file_text(file))));
        }
        if let Some((_, uri, source)) = &last {
            locations.push(Location { uri: uri.clone(), range: range_of(source, place.range) });
        }
    }
    locations
}

/// The URI of the file of another text; `None` when its path is not absolute.
fn uri_of(file: &str) -> Option<Uri> {
    address_of(file)?.parse().ok()
}

fn name_at(program: &EditorProgram, place: Position) -> Option<SymbolName> {
    program.name_at(offset_of(program.source(), place)).map(|found| found.name)
}

/// The range of the variable at a position; `None` when there is nothing that can be renamed.
pub fn renamable(program: &EditorProgram, place: Position) -> Option<Range> {
    let found = program.name_at(offset_of(program.source(), place))?;
    let variable = matches!(found.name, SymbolName::Variable { .. });
    variable.then(|| range_of(program.source(), found.range))
}

/// Inlay hints after the lines `from` up to, not including, `to` that move: the length, with the end position and the
/// time in the tooltip.
pub fn hints(program: &EditorProgram, ran: &RunMoves, from: u32, to: u32) -> Vec<InlayHint> {
    let units = ran.units();
    let first = ran.lines.partition_point(|moves| moves.line < from);
    let shown = ran.lines[first..].iter().take_while(|moves| moves.line < to);
    shown
        .filter(|moves| moves.pieces > 0)
        .map(|moves| {
            let length = units.length_text(moves.length_mm);
            let time = number_text(moves.seconds, 2);
            let place: Vec<String> = ["X", "Y", "Z"]
                .iter()
                .zip(moves.to)
                .map(|(axis, mm)| format!("{axis} {}", units.length_text(mm)))
                .collect();
            let tooltip = format!("ends at {}; {time} s", place.join(", "));
            InlayHint {
                position: line_end(program, moves.line),
                label: InlayHintLabel::String(length),
                kind: None,
                text_edits: None,
                tooltip: Some(InlayHintTooltip::String(tooltip)),
                padding_left: Some(true),
                padding_right: None,
                data: None,
            }
        })
        .collect()
}
