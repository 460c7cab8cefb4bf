//! Problems as rows.

use chordal::diagnostics::FileId;
use chordal::{Diagnostic, Job, Report, SourceMap, Span};
use chordal_export::report::{excerpt, place};

use super::text::{clean, file_name};
use crate::data::{CappedRows, ReportedProblem};

/// Problems that are reported; the others are counted.
const MAX_PROBLEMS: usize = 100;
/// Characters of a sentence.
const MAX_SENTENCE_CHARS: usize = 600;
/// Calls reported of a deep nesting.
const MAX_CALLS: usize = 4;

/// The problems of a run, the gravest first, those of one severity by place.
pub fn problems(report: &Report, job: &Job) -> CappedRows<ReportedProblem> {
    let mut sorted: Vec<&Diagnostic> = report.diagnostics.iter().collect();
    sorted.sort_by_key(|diagnostic| std::cmp::Reverse(diagnostic.severity));
    let rows: Vec<ReportedProblem> = sorted
        .iter()
        .take(MAX_PROBLEMS)
        .map(|diagnostic| problem(diagnostic, job.sources()))
        .collect();
    let all = report.counts.errors + report.counts.warnings + report.counts.notes;
    let left_out = all.saturating_sub(rows.len() as u64);
    CappedRows { rows, left_out }
}

/// One problem as a row.
pub fn problem(diagnostic: &Diagnostic, sources: &SourceMap) -> ReportedProblem {
    let info = diagnostic.code.info();
    let shown = |text: &str| clean(text, MAX_SENTENCE_CHARS);
    let calls = diagnostic.calls.iter().take(MAX_CALLS);
    let calls = calls.filter_map(|call| called_from(*call, sources));
    let found = place(diagnostic.primary.span, sources);
    ReportedProblem {
        severity: diagnostic.severity.word(),
        code: info.id,
        name: info.name,
        message: shown(&diagnostic.message),
        place: found.map(|place| (file_name(place.file), place.start.line)),
        excerpt: shown_lines(diagnostic, sources),
        alarm: diagnostic.alarm.as_deref().map(shown),
        notes: diagnostic.notes.iter().map(|note| shown(note)).chain(calls).collect(),
        help: diagnostic.help.as_deref().map(shown),
        fix: diagnostic.fix.as_ref().map(|fix| {
            let words = sources.words(fix.span);
            match (words.trim(), fix.replacement.trim()) {
                ("", new) => format!("{}: add {}", shown(&fix.title), clean(new, 80)),
                (old, "") => format!("{}: leave out {}", shown(&fix.title), clean(old, 80)),
                (old, new) => {
                    format!(
                        "{}: {} instead of {}",
                        shown(&fix.title),
                        clean(new, 80),
                        clean(old, 80)
                    )
                }
            }
        }),
    }
}

/// The lines with the words underlined. The program's own name is left out: a sheet that is mailed
/// need not say in which folder it was.
fn shown_lines(diagnostic: &Diagnostic, sources: &SourceMap) -> String {
    let own = sources.get(FileId(0)).map_or("", |source| source.name());
    let names_own = |line: &str| {
        let place = line.trim_start();
        let place = place.strip_prefix("--> ").or_else(|| place.strip_prefix("::: "));
        place.and_then(|place| place.strip_prefix(own)).is_some_and(|rest| rest.starts_with(':'))
    };
    let drawn = excerpt(diagnostic, sources);
    let lines: Vec<&str> = drawn.lines().filter(|line| !names_own(line)).collect();
    lines.join("\n")
}

fn called_from(call: Span, sources: &SourceMap) -> Option<String> {
    let place = place(call, sources)?;
    let file =
        if call.file.0 == 0 { String::new() } else { format!("{}, ", file_name(place.file)) };
    Some(format!(
        "called from {file}line {}: {}",
        place.start.line,
        clean(&sources.words(call), 60)
    ))
}
