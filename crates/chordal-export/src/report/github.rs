//! Problems as commands of GitHub's workflows.

use chordal::{Diagnostic, Report, Severity, SourceMap};

use super::place::place;

/// All problems of a run as workflow commands, one a line: GitHub shows them next to the
/// lines of the program.
pub fn github(report: &Report, sources: &SourceMap) -> String {
    report.diagnostics.iter().map(|diagnostic| annotation(diagnostic, sources)).collect()
}

fn annotation(diagnostic: &Diagnostic, sources: &SourceMap) -> String {
    let command = match diagnostic.severity {
        Severity::Error => "error",
        Severity::Warning => "warning",
        Severity::Note => "notice",
    };
    let info = diagnostic.code.info();
    let title = property(&format!("{} {}", info.id, info.name));
    let file = property(file_of(diagnostic, sources));
    let at = match place(diagnostic.primary.span, sources) {
        Some(at) if at.start.line == at.end.line => {
            format!(",line={},col={},endColumn={}", at.start.line, at.start.column, at.end.column)
        }
        // Columns are not allowed where the lines differ.
        Some(at) => format!(",line={},endLine={}", at.start.line, at.end.line),
        None => String::new(),
    };
    format!("::{command} file={file}{at},title={title}::{}\n", data(&message(diagnostic)))
}

/// The file of a problem. Where a folder is named `.`, its files begin with that; who shows them wants them without.
pub(super) fn file_of<'a>(diagnostic: &Diagnostic, sources: &'a SourceMap) -> &'a str {
    let name = sources.get(diagnostic.primary.span.file).map_or("", |source| source.name());
    name.strip_prefix("./").unwrap_or(name)
}

/// The message and what the control would show, and what to do.
pub(super) fn message(diagnostic: &Diagnostic) -> String {
    let mut text = diagnostic.message.clone();
    for (name, more) in [("alarm", &diagnostic.alarm), ("help", &diagnostic.help)] {
        if let Some(more) = more {
            text.push_str(&format!("\n{name}: {more}"));
        }
    }
    text
}

fn data(text: &str) -> String {
    text.replace('%', "%25").replace('\r', "%0D").replace('\n', "%0A")
}

fn property(text: &str) -> String {
    data(text).replace(':', "%3A").replace(',', "%2C")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_would_end_a_field_is_escaped() {
        assert_eq!(property("a,b:c%\n"), "a%2Cb%3Ac%25%0A");
        assert_eq!(data("a,b:c%\n"), "a,b:c%25%0A");
    }
}
