//! Problems of one code together, the gravest first.

use chordal::diagnostics::Code;
use chordal::{Diagnostic, Report, Severity, SourceMap};

use super::place::place;
use crate::numbers::grouped;

/// Lines, or runs of lines, that a list names.
const MAX_NAMED: usize = 8;

/// The problems of one code and severity.
#[derive(Debug)]
pub(crate) struct ProblemGroup<'r> {
    pub severity: Severity,
    pub code: Code,
    /// By place, as the report has them.
    pub kept: Vec<&'r Diagnostic>,
    /// So many more were counted and not kept.
    pub dropped: u64,
}

impl ProblemGroup<'_> {
    /// All of them.
    pub fn count(&self) -> u64 {
        self.kept.len() as u64 + self.dropped
    }
}

/// The problems of a report by code: errors, then warnings, then notes; within a severity by the first place.
pub(crate) fn groups(report: &Report) -> Vec<ProblemGroup<'_>> {
    let mut groups: Vec<ProblemGroup> = Vec::new();
    for diagnostic in &report.diagnostics {
        let (severity, code) = (diagnostic.severity, diagnostic.code);
        match groups.iter_mut().find(|group| (group.severity, group.code) == (severity, code)) {
            Some(group) => group.kept.push(diagnostic),
            None => {
                groups.push(ProblemGroup { severity, code, kept: vec![diagnostic], dropped: 0 })
            }
        }
    }
    groups.sort_by_key(|group| std::cmp::Reverse(group.severity));
    for &(code, count) in &report.dropped {
        if let Some(group) = groups.iter_mut().find(|group| group.code == code) {
            group.dropped += count;
        }
    }
    groups
}

/// Where the problems are that are not shown: `lines 34, 36 to 40, 52 and 782 more places`.
pub(crate) fn lines_of(hidden: &[&Diagnostic], dropped: u64, sources: &SourceMap) -> String {
    let mut runs: Vec<(u32, u32)> = Vec::new();
    let mut named = 0;
    for diagnostic in hidden {
        // Places of other files are counted, not named: a line number alone would mislead.
        let line = place(diagnostic.primary.span, sources)
            .filter(|_| diagnostic.primary.span.file == hidden[0].primary.span.file)
            .map(|place| place.start.line);
        let Some(line) = line else { continue };
        let full = runs.len() == MAX_NAMED;
        match runs.last_mut() {
            Some((_, last)) if line == *last || line == *last + 1 => *last = line,
            _ if full => break,
            _ => runs.push((line, line)),
        }
        named += 1;
    }
    let more = (hidden.len() - named) as u64 + dropped;
    let runs: Vec<String> = runs.iter().map(|&(from, to)| run_text(from, to)).collect();
    let word = if runs.len() == 1 && !runs[0].contains(' ') { "line" } else { "lines" };
    match (runs.is_empty(), more) {
        (true, _) => counted_places(more),
        (false, 0) => format!("{word} {}", and_list(&runs)),
        (false, more) => format!("{word} {} and {}", runs.join(", "), counted_places(more)),
    }
}

fn run_text(from: u32, to: u32) -> String {
    match to - from {
        0 => from.to_string(),
        1 => format!("{from}, {to}"),
        _ => format!("{from} to {to}"),
    }
}

fn counted_places(count: u64) -> String {
    let places = if count == 1 { "place" } else { "places" };
    format!("{} more {places}", grouped(count))
}

fn and_list(items: &[String]) -> String {
    match items {
        [before @ .., last] if !before.is_empty() => format!("{} and {last}", before.join(", ")),
        _ => items.concat(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use chordal::diagnostics::FileId;
    use chordal::{Source, Span};

    /// A text of lines of two bytes, and problems in some of them.
    fn problems(lines: &[u32]) -> (SourceMap<'static>, Vec<Diagnostic>) {
        let mut sources = SourceMap::new();
        sources.add(Source::new("part.nc", "X\n".repeat(100).into_bytes()));
        let problem = |line: &u32| {
            let at = (line - 1) * 2;
            Diagnostic::new(Code::NearlyTangent, Span::new(FileId(0), at, at + 1), "a turn")
        };
        (sources, lines.iter().map(problem).collect())
    }

    fn said(lines: &[u32], dropped: u64) -> String {
        let (sources, problems) = problems(lines);
        lines_of(&problems.iter().collect::<Vec<_>>(), dropped, &sources)
    }

    #[test]
    fn lines_are_named_in_runs() {
        assert_eq!(said(&[4], 0), "line 4");
        assert_eq!(said(&[4, 9], 0), "lines 4 and 9");
        assert_eq!(said(&[4, 5, 6, 7, 20], 0), "lines 4 to 7 and 20");
        assert_eq!(said(&[4, 5, 20], 3), "lines 4, 5, 20 and 3 more places");
        assert_eq!(
            said(&[1, 3, 5, 7, 9, 11, 13, 15, 17, 19], 1200),
            "lines 1, 3, 5, 7, 9, 11, 13, 15 and 1,202 more places"
        );
        assert_eq!(said(&[], 1), "1 more place");
    }
}
