use annotate_snippets::{Group, Level, Origin};
use chordal::diagnostics::FileId;
use chordal::machine::MachineError;
use chordal::{Source, SourceMap, Span};

use crate::report::{Excerpts, Mark, renderer};

/// A problem of a machine file as text for people, with the words underlined and a line end.
pub fn machine_error_text(error: &MachineError, color: bool) -> String {
    let mut sources = SourceMap::new();
    sources.add(Source::new(error.file.as_str(), error.text.as_bytes()));
    let mut group = Group::with_title(Level::ERROR.primary_title(error.message.as_str()));
    let mut origin = Origin::path(error.file.as_str());
    let mut marks = Vec::new();
    if let Some(range) = &error.span
        && let Some(source) = sources.get(FileId(0))
    {
        let span = Span::new(FileId(0), range.start as u32, range.end as u32);
        let at = source.line_column(span.range.start);
        origin = origin.line(at.line as usize).char_column(at.column as usize);
        marks.push(Mark { span, text: String::new(), primary: true });
    }
    let excerpts = Excerpts::new(&marks, &sources);
    group = group.element(origin).elements(excerpts.snippets(&sources));
    if let Some(help) = &error.help {
        group = group.element(Level::HELP.message(help.as_str()));
    }
    let mut text = renderer(color).render(&[group]);
    text.push('\n');
    text
}
