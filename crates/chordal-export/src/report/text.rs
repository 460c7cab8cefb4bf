//! Problems as text for people.

use annotate_snippets::{Element, Group, Level, Origin, Patch, Renderer, Snippet};
use chordal::diagnostics::{Applicability, Fix, SeverityCounts};
use chordal::{Diagnostic, Report, Severity, SourceMap, Span};

use super::excerpt::{ExcerptMark, ProblemExcerpts};
use super::groups::{ProblemGroup, groups, lines_of};
use super::place::{call_text, place};
use crate::numbers::grouped;

/// Calls shown of a deep nesting.
const MAX_CALLS: usize = 6;

/// How much is shown of the problems.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum ReportDetail {
    /// One line for each code, without the words of the program.
    Lines,
    /// What fits a screen: the first place of a code in full, of the others the lines. Of a few errors three
    /// places; after some codes one line each.
    #[default]
    First,
    /// So many places of each code in full.
    Places(usize),
    /// Every place that was kept.
    All,
}

/// So many errors together are few.
const MAX_ERRORS_IN_FULL: u64 = 6;

/// Codes with a place in full, of those that fit a screen.
const MAX_CODES: usize = 4;

impl ReportDetail {
    /// How many places of a code are shown in full: of the code with this index, in a run with so many errors.
    fn places(self, severity: Severity, index: usize, errors: u64) -> usize {
        match (self, severity) {
            (ReportDetail::Lines, _) => 0,
            (ReportDetail::First, Severity::Error) if errors <= MAX_ERRORS_IN_FULL => 3,
            (ReportDetail::First, _) => usize::from(index < MAX_CODES),
            (ReportDetail::Places(most), _) => most.max(1),
            (ReportDetail::All, _) => usize::MAX,
        }
    }
}

/// The problems of a run as text for people: by code, errors first, with the lines they are in, and how many
/// there are. Empty when there are none.
pub fn text(report: &Report, sources: &SourceMap, color: bool, detail: ReportDetail) -> String {
    let mut out = String::new();
    let mut brief = 0;
    for (index, group) in groups(report).into_iter().enumerate() {
        match detail.places(group.severity, index, report.counts.errors) {
            0 => {
                out.push_str(&line(&group, sources));
                brief += 1;
            }
            most => out.push_str(&group_text(&group, sources, color, most)),
        }
    }
    if brief > 0 && detail == ReportDetail::First {
        out.push('\n');
    }
    out.push_str(&closing(&report.counts));
    if let Some((file, line)) = report.not_verified_line(sources) {
        out.push_str(&not_verified(file, line, report.path_lost_from.is_some()));
    }
    out
}

/// The first places of a code in full, and where the others are.
fn group_text(group: &ProblemGroup<'_>, sources: &SourceMap, color: bool, most: usize) -> String {
    let (shown, hidden) = group.kept.split_at(most.min(group.kept.len()));
    let mut out = String::new();
    for (index, diagnostic) in shown.iter().enumerate() {
        let mut text = one(diagnostic, sources, color);
        if index + 1 == shown.len() && group.count() > shown.len() as u64 {
            let id = group.code.id();
            let lines = lines_of(hidden, group.dropped, sources);
            text.push_str(&format!("{} = also {id}: {lines}\n", gutter(&text)));
        }
        out.push_str(&text);
        out.push('\n');
    }
    out
}

/// The blanks before the signs of the margin, as the lines of a problem have them.
fn gutter(text: &str) -> String {
    let is_margin = |line: &&str| line.trim_start().starts_with(['=', '|']);
    let line = text.lines().rev().find(is_margin).unwrap_or("   =");
    " ".repeat((line.len() - line.trim_start().len()).saturating_sub(1))
}

/// `part.nc:33: warning[CH414]: the path turns by … (796 places)`.
fn line(group: &ProblemGroup<'_>, sources: &SourceMap) -> String {
    let Some(first) = group.kept.first() else { return String::new() };
    let at = match place(first.primary.span, sources) {
        Some(place) => format!("{}:{}: ", clean(place.file), place.start.line),
        None => String::new(),
    };
    let places = match group.count() {
        1 => String::new(),
        count => format!(" ({} places)", grouped(count)),
    };
    let severity = group.severity.word();
    format!("{at}{severity}[{}]: {}{places}\n", group.code.id(), clean(&first.message))
}

/// One problem as text for people, with a line end.
pub fn one(diagnostic: &Diagnostic, sources: &SourceMap, color: bool) -> String {
    let message = clean(&diagnostic.message);
    let title = level(diagnostic.severity).primary_title(message).id(diagnostic.code.id());
    let mut group = Group::with_title(title);
    let excerpts = ProblemExcerpts::new(&marks(diagnostic), sources);
    if place(diagnostic.primary.span, sources).is_none()
        && let Some(source) = sources.get(diagnostic.primary.span.file)
    {
        group = group.element(Origin::path(source.name()));
    }
    group = group.elements(excerpts.snippets(sources));
    group = group.elements(footer(diagnostic, sources));
    let mut groups = vec![group];
    let fix_excerpts = diagnostic.fix.as_ref().map(|fix| fix_excerpts(fix, sources));
    if let (Some(fix), Some(excerpts)) = (&diagnostic.fix, &fix_excerpts) {
        groups.push(suggestion(fix, excerpts, sources));
    }
    let mut text = excerpts.correct(renderer(color).render(&groups), sources);
    text.push('\n');
    text
}

/// The lines of a problem with its words underlined, without its message and what follows; empty
/// where it has no place in a text.
pub fn excerpt(diagnostic: &Diagnostic, sources: &SourceMap) -> String {
    let excerpts = ProblemExcerpts::new(&marks(diagnostic), sources);
    if excerpts.first().is_none() {
        return String::new();
    }
    let group = Group::with_level(level(diagnostic.severity)).elements(excerpts.snippets(sources));
    let mut text = renderer(false).render(&[group]);
    // As the lines of places are looked for with their ends.
    text.push('\n');
    excerpts.correct(text, sources)
}

/// How problems are drawn. The lines are cut already, so the renderer must not cut them
/// again.
pub(crate) fn renderer(color: bool) -> Renderer {
    let renderer = if color { Renderer::styled() } else { Renderer::plain() };
    renderer.term_width(500)
}

fn level(severity: Severity) -> Level<'static> {
    match severity {
        Severity::Error => Level::ERROR,
        Severity::Warning => Level::WARNING,
        Severity::Note => Level::NOTE,
    }
}

fn marks(diagnostic: &Diagnostic) -> Vec<ExcerptMark> {
    let primary = ExcerptMark {
        span: diagnostic.primary.span,
        text: clean(&diagnostic.primary.text),
        primary: true,
    };
    let others = diagnostic.secondary.iter().map(|label| ExcerptMark {
        span: label.span,
        text: clean(&label.text),
        primary: false,
    });
    std::iter::once(primary).chain(others).collect()
}

/// The alarm, notes, help and calls.
fn footer<'d>(diagnostic: &'d Diagnostic, sources: &SourceMap) -> Vec<Element<'d>> {
    let mut lines: Vec<Element> = Vec::new();
    if let Some(alarm) = &diagnostic.alarm {
        lines.push(Level::NOTE.with_name("alarm").message(clean(alarm)).into());
    }
    for note in &diagnostic.notes {
        lines.push(Level::NOTE.message(clean(note)).into());
    }
    for call in diagnostic.calls.iter().take(MAX_CALLS) {
        lines.push(Level::NOTE.message(clean(&called_from(*call, sources))).into());
    }
    if let more @ 1.. = diagnostic.calls.len().saturating_sub(MAX_CALLS) {
        lines.push(Level::NOTE.message(format!("and {more} more calls")).into());
    }
    if let Some(help) = &diagnostic.help {
        lines.push(Level::HELP.message(clean(help)).into());
    }
    lines
}

fn called_from(call: Span, sources: &SourceMap) -> String {
    let Some(place) = place(call, sources) else { return "called from the program".into() };
    let words = call_text(call, sources);
    let file = if call.file.0 == 0 { String::new() } else { format!("{}, ", place.file) };
    format!("called from {file}line {}: {words}", place.start.line)
}

fn fix_excerpts(fix: &Fix, sources: &SourceMap) -> ProblemExcerpts {
    let mark = ExcerptMark { span: fix.span, text: String::new(), primary: true };
    ProblemExcerpts::new(&[mark], sources)
}

/// The fix as a help with the line as it would be. Where the words that go are more than the
/// line shows, only its title.
fn suggestion<'f>(fix: &'f Fix, excerpts: &'f ProblemExcerpts, sources: &SourceMap) -> Group<'f> {
    let title = match fix.applicability {
        Applicability::Safe => clean(&fix.title),
        Applicability::Unsafe => format!("{} (check it first)", clean(&fix.title)),
    };
    let group = Group::with_title(Level::HELP.secondary_title(title));
    let words = sources.words(fix.span);
    match excerpts.first() {
        Some((line, text, range)) if text.get(range.clone()) == Some(&*words) => {
            let patch = Patch::new(range, clean(&fix.replacement));
            group.element(Snippet::source(text).line_start(line as usize).patch(patch))
        }
        _ => group.element(Level::HELP.message(format!("write `{}`", clean(&fix.replacement)))),
    }
}

/// Said after the problems, lest what else is said of the path, or of its time alone, be believed.
fn not_verified(file: &str, line: u32, is_path_lost: bool) -> String {
    let what = if is_path_lost { "path" } else { "time" };
    format!(
        "not verified from line {line} of {} on: the {what} after it is not known\n",
        clean(file)
    )
}

/// `2 errors, 1 warning`.
fn closing(counts: &SeverityCounts) -> String {
    let parts: Vec<String> =
        [(counts.errors, "error"), (counts.warnings, "warning"), (counts.notes, "note")]
            .into_iter()
            .filter(|(count, _)| *count > 0)
            .map(|(count, word)| {
                let plural = if count == 1 { "" } else { "s" };
                format!("{} {word}{plural}", grouped(count))
            })
            .collect();
    if parts.is_empty() { String::new() } else { parts.join(", ") + "\n" }
}

/// Text without what would steer a terminal: words of a program may hold anything.
pub(super) fn clean(text: &str) -> String {
    text.chars().map(|c| if c.is_control() && c != '\n' { '�' } else { c }).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn counts_are_words() {
        let counts = SeverityCounts { errors: 2, warnings: 1, notes: 0 };
        assert_eq!(closing(&counts), "2 errors, 1 warning\n");
        assert_eq!(closing(&SeverityCounts::default()), "");
        assert_eq!(grouped(9_912), "9,912");
        assert_eq!(grouped(1_234_567), "1,234,567");
    }
}
