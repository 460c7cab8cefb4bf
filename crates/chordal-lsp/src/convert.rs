//! Converts results to the types of the protocol.

use chordal::diagnostics::{FileId, Label, TextRange};
use chordal::{Diagnostic, Severity};
use chordal_editor::{EditorProgram, EntryKind, FormatEdit, OutlineEntry, Token, TokenClass};
use lsp_types::{
    DiagnosticRelatedInformation, DiagnosticSeverity, DocumentSymbol, FoldingRange,
    FoldingRangeKind, Location, NumberOrString, SemanticToken, SemanticTokenType, SymbolKind,
    TextEdit, Uri,
};

use crate::place::{place_of, range_of};

/// The token types in the order of [`TokenClass::ALL`]. Editors have colours for these names.
pub fn token_types() -> Vec<SemanticTokenType> {
    TokenClass::ALL
        .iter()
        .map(|class| match class {
            TokenClass::Comment => SemanticTokenType::COMMENT,
            TokenClass::Mark => SemanticTokenType::MODIFIER,
            TokenClass::Program => SemanticTokenType::NAMESPACE,
            TokenClass::Label => SemanticTokenType::DECORATOR,
            TokenClass::GCode => SemanticTokenType::KEYWORD,
            TokenClass::MCode => SemanticTokenType::FUNCTION,
            TokenClass::Axis => SemanticTokenType::PROPERTY,
            TokenClass::Speed => SemanticTokenType::ENUM_MEMBER,
            TokenClass::Tool => SemanticTokenType::CLASS,
            TokenClass::Parameter => SemanticTokenType::PARAMETER,
            TokenClass::Variable => SemanticTokenType::VARIABLE,
            TokenClass::Keyword => SemanticTokenType::MACRO,
            TokenClass::Number => SemanticTokenType::NUMBER,
            TokenClass::Text => SemanticTokenType::STRING,
            TokenClass::Unknown => SemanticTokenType::new("unknown"),
        })
        .collect()
}

/// The tokens in the encoding of the protocol, each position relative to the previous token.
pub fn semantic_tokens(program: &EditorProgram, tokens: &[Token]) -> Vec<SemanticToken> {
    let mut last = lsp_types::Position::default();
    tokens
        .iter()
        .map(|token| {
            let range = range_of(program.source(), token.range);
            let delta_line = range.start.line - last.line;
            let from = if delta_line == 0 { last.character } else { 0 };
            last = range.start;
            SemanticToken {
                delta_line,
                delta_start: range.start.character - from,
                length: range.end.character.saturating_sub(range.start.character),
                token_type: token.class as u32,
                token_modifiers_bitset: 0,
            }
        })
        .collect()
}

/// The entries of the outline.
pub fn symbols(program: &EditorProgram, entries: Vec<OutlineEntry>) -> Vec<DocumentSymbol> {
    entries
        .into_iter()
        .map(|entry| {
            let kind = match entry.kind {
                EntryKind::Program => SymbolKind::MODULE,
                EntryKind::Subroutine => SymbolKind::FUNCTION,
                EntryKind::Tool => SymbolKind::CLASS,
                EntryKind::Operation => SymbolKind::METHOD,
                EntryKind::Label => SymbolKind::KEY,
            };
            #[allow(deprecated, reason = "the field must be given")]
            DocumentSymbol {
                name: entry.name,
                detail: Some(entry.detail).filter(|detail| !detail.is_empty()),
                kind,
                tags: None,
                deprecated: None,
                range: range_of(program.source(), entry.range),
                selection_range: range_of(program.source(), entry.head),
                children: Some(symbols(program, entry.children)),
            }
        })
        .collect()
}

/// What can be folded: each entry of the outline that has more than one line, with what lies in it.
pub fn folds(program: &EditorProgram, entries: &[OutlineEntry]) -> Vec<FoldingRange> {
    let mut folds = Vec::new();
    let mut open: Vec<&OutlineEntry> = entries.iter().rev().collect();
    while let Some(entry) = open.pop() {
        open.extend(entry.children.iter().rev());
        let range = range_of(program.source(), entry.range);
        // A range that ends with a line break ends at the start of the next line.
        let is_next_line = range.end.character == 0 && range.end.line > range.start.line;
        let end_line = range.end.line - u32::from(is_next_line);
        if end_line > range.start.line {
            folds.push(FoldingRange {
                start_line: range.start.line,
                end_line,
                kind: Some(FoldingRangeKind::Region),
                ..FoldingRange::default()
            });
        }
    }
    folds
}

/// Converts a problem. One in another file is reported at the innermost call in this file.
pub fn diagnostic(program: &EditorProgram, uri: &Uri, found: &Diagnostic) -> lsp_types::Diagnostic {
    let source = program.source();
    let here = |label: &&Label| label.span.file == FileId(0);
    let related = |label: &Label| DiagnosticRelatedInformation {
        location: Location { uri: uri.clone(), range: range_of(source, label.span.range) },
        message: label.text.clone(),
    };
    let mut information: Vec<_> = found.secondary.iter().filter(here).map(related).collect();
    let calls = found.calls.iter().filter(|call| call.file == FileId(0));
    let mut span = found.primary.span;
    let mut message = found.message.clone();
    if span.file != FileId(0) {
        let other = program.file_name(span.file);
        message = format!("{other}: {message}");
        span = found
            .calls
            .iter()
            .rev()
            .find(|call| call.file == FileId(0))
            .copied()
            .unwrap_or_default();
    } else {
        information.extend(calls.map(|call| DiagnosticRelatedInformation {
            location: Location { uri: uri.clone(), range: range_of(source, call.range) },
            message: "called here".into(),
        }));
    }
    if !found.primary.text.is_empty() {
        message.push_str(&format!("\n{}", found.primary.text));
    }
    if let Some(alarm) = &found.alarm {
        message.push_str(&format!("\nThe control shows: {alarm}"));
    }
    for note in &found.notes {
        message.push_str(&format!("\n{note}"));
    }
    if let Some(help) = &found.help {
        message.push_str(&format!("\nHelp: {help}"));
    }
    lsp_types::Diagnostic {
        range: range_of(source, span.range),
        severity: Some(match found.severity {
            Severity::Error => DiagnosticSeverity::ERROR,
            Severity::Warning => DiagnosticSeverity::WARNING,
            Severity::Note => DiagnosticSeverity::INFORMATION,
        }),
        code: Some(NumberOrString::String(found.code.info().id.into())),
        source: Some("chordal".into()),
        message,
        related_information: Some(information).filter(|list| !list.is_empty()),
        ..lsp_types::Diagnostic::default()
    }
}

/// The edits of a text.
pub fn text_edits(program: &EditorProgram, edits: Vec<FormatEdit>) -> Vec<TextEdit> {
    let edit = |edit: FormatEdit| TextEdit {
        range: range_of(program.source(), edit.range),
        new_text: edit.text,
    };
    edits.into_iter().map(edit).collect()
}

/// The end of a line without trailing spaces.
pub fn line_end(program: &EditorProgram, line: u32) -> lsp_types::Position {
    let start = program.source().line_start(line);
    let end = start + program.source().line_text(line).trim_ascii_end().len() as u32;
    place_of(program.source(), end)
}

/// The lines of a range: the first, and the one after the last, from 1.
pub fn lines(range: lsp_types::Range) -> (u32, u32) {
    (range.start.line.saturating_add(1), range.end.line.saturating_add(2))
}

/// Whether two ranges overlap or touch.
pub fn touch(one: TextRange, other: TextRange) -> bool {
    one.start <= other.end && other.start <= one.end
}
