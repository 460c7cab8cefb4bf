//! Code actions: fixes and renumbering.

use std::collections::HashMap;

use chordal::diagnostics::{Applicability, FileId, Fix};
use chordal_editor::{EditorProgram, FormatEdit, NumberingOptions, RunMoves};
use lsp_types::{
    CodeAction, CodeActionKind, CodeActionOrCommand, CodeActionParams, TextEdit, Uri, WorkspaceEdit,
};

use crate::convert::{diagnostic, text_edits, touch};
use crate::place::offset_of;

/// The kind of the renumbering action. Its edit is computed when the user chooses it.
pub const RENUMBER: CodeActionKind = CodeActionKind::new("source.renumber.chordal");
/// The kind of the action that makes all safe fixes of a text.
pub const FIX_ALL: CodeActionKind = CodeActionKind::SOURCE_FIX_ALL;

/// Block numbers in steps of ten, as in the editors of controls.
const NUMBERING: NumberingOptions = NumberingOptions { first: 10, step: 10, all: true };

/// An edit of one document.
#[allow(clippy::mutable_key_type, reason = "the protocol's own type")]
pub fn edit_of(uri: &Uri, edits: Vec<TextEdit>) -> WorkspaceEdit {
    let changes = Some(HashMap::from([(uri.clone(), edits)]));
    WorkspaceEdit { changes, ..WorkspaceEdit::default() }
}

/// The actions for a range of the text.
pub fn actions(
    program: &EditorProgram,
    ran: &RunMoves,
    params: &CodeActionParams,
) -> Vec<CodeActionOrCommand> {
    let uri = &params.text_document.uri;
    let only = params.context.only.as_deref();
    let is_included = |kind: &CodeActionKind| {
        only.is_none_or(|kinds| {
            kinds.iter().any(|prefix| {
                let rest = kind.as_str().strip_prefix(prefix.as_str());
                rest.is_some_and(|rest| rest.is_empty() || rest.starts_with('.'))
            })
        })
    };
    let source = program.source();
    let range = chordal::diagnostics::TextRange::new(
        offset_of(source, params.range.start),
        offset_of(source, params.range.end),
    );
    let mut found = Vec::new();
    if is_included(&CodeActionKind::QUICKFIX) {
        let problems = ran.report.diagnostics.iter();
        for (problem, fix) in problems.flat_map(|one| one.fixes().map(move |fix| (one, fix))) {
            if fix.span.file == FileId(0) && touch(problem.primary.span.range, range) {
                let safe = fix.applicability == Applicability::Safe;
                let title =
                    if safe { fix.title.clone() } else { format!("{} (check it)", fix.title) };
                found.push(CodeAction {
                    title,
                    kind: Some(CodeActionKind::QUICKFIX),
                    diagnostics: Some(vec![diagnostic(program, uri, problem)]),
                    edit: Some(edit_of(uri, text_edits(program, vec![edit(fix)]))),
                    is_preferred: Some(safe),
                    ..CodeAction::default()
                });
            }
        }
    }
    let safe = safe_fixes(ran);
    if is_included(&FIX_ALL) && !safe.is_empty() {
        found.push(CodeAction {
            title: format!("Make all safe fixes ({})", safe.len()),
            kind: Some(FIX_ALL),
            edit: Some(edit_of(uri, text_edits(program, safe))),
            ..CodeAction::default()
        });
    }
    if is_included(&RENUMBER) {
        found.push(CodeAction {
            title: "Renumber blocks by ten".into(),
            kind: Some(RENUMBER),
            data: serde_json::to_value(uri).ok(),
            ..CodeAction::default()
        });
    }
    found.into_iter().map(CodeActionOrCommand::CodeAction).collect()
}

/// Adds the edit to an action that was offered without one; the error is shown to the user.
pub fn resolved(
    program: &EditorProgram,
    uri: &Uri,
    action: CodeAction,
) -> Result<CodeAction, String> {
    if action.kind.as_ref() != Some(&RENUMBER) {
        return Ok(action);
    }
    let edits = program.renumbered(NUMBERING).map_err(|error| error.to_string())?;
    Ok(CodeAction { edit: Some(edit_of(uri, text_edits(program, edits))), ..action })
}

fn edit(fix: &Fix) -> FormatEdit {
    FormatEdit { range: fix.span.range, text: fix.replacement.clone() }
}

/// The edits of the safe fixes, in order, without duplicates and overlaps.
fn safe_fixes(ran: &RunMoves) -> Vec<FormatEdit> {
    let fixes = ran.report.diagnostics.iter().filter_map(|problem| problem.fix.as_ref());
    let safe =
        fixes.filter(|fix| fix.applicability == Applicability::Safe && fix.span.file == FileId(0));
    let mut edits: Vec<FormatEdit> = safe.map(edit).collect();
    edits.sort_by_key(|edit| (edit.range.start, edit.range.end));
    let mut separate: Vec<FormatEdit> = Vec::new();
    for edit in edits {
        if separate.last().is_none_or(|last| last.range.end <= edit.range.start && *last != edit) {
            separate.push(edit);
        }
    }
    separate
}
