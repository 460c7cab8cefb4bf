//! Problems of a machine file as text.

use annotate_snippets::{Group, Level, Origin};
use chordal::diagnostics::FileId;
use chordal::machine::MachineError;
use chordal::{Source, SourceMap, Span};

use crate::report::{ExcerptMark, ProblemExcerpts, renderer};

/// A problem of a machine file as text for people, with the words underlined and a line end.
pub fn machine_error_text(error: &MachineError, color: bool) -> String {
    let mut sources = SourceMap::new();
    sources.add(Source::new(error.file.as_str(), error.text.as_bytes()));
    let mut group = Group::with_title(Level::ERROR.primary_title(error.message.as_str()));
    let mark = error.span.as_ref().map(|range| ExcerptMark {
        span: Span::new(FileId(0), range.start as u32, range.end as u32),
        text: String::new(),
        primary: true,
    });
    let excerpts = ProblemExcerpts::new(mark.as_slice(), &sources);
    if error.span.is_none() {
        group = group.element(Origin::path(error.file.as_str()));
    }
    group = group.elements(excerpts.snippets(&sources));
    if let Some(help) = &error.help {
        group = group.element(Level::HELP.message(help.as_str()));
    }
    let mut text = excerpts.correct(renderer(color).render(&[group]), &sources);
    text.push('\n');
    text
}
