//! Collects the diagnostics of a run in bounded memory.

use std::collections::{BTreeMap, HashSet};

use crate::{Code, Diagnostic, Severity, Span};

/// The number of diagnostics of each severity, including those that were not kept.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct SeverityCounts {
    /// Errors.
    pub errors: u64,
    /// Warnings.
    pub warnings: u64,
    /// Notes.
    pub notes: u64,
}

impl SeverityCounts {
    /// Counts one diagnostic.
    pub fn add(&mut self, severity: Severity) {
        match severity {
            Severity::Error => self.errors += 1,
            Severity::Warning => self.warnings += 1,
            Severity::Note => self.notes += 1,
        }
    }
}

/// Collects diagnostics in bounded memory: of each code only the first few are kept, and each location is reported
/// once, even if repeats or calls execute it several times.
#[derive(Debug)]
pub struct Collector {
    limit_per_code: usize,
    kept: Vec<Diagnostic>,
    kept_per_code: BTreeMap<Code, usize>,
    dropped: BTreeMap<Code, u64>,
    reported: HashSet<(Code, Span)>,
    counts: SeverityCounts,
    path_lost: Option<Span>,
    time_lost: Option<Span>,
}

impl Collector {
    /// Keeps at most `limit_per_code` diagnostics of each code.
    pub fn new(limit_per_code: usize) -> Collector {
        Collector {
            limit_per_code,
            kept: Vec::new(),
            kept_per_code: BTreeMap::new(),
            dropped: BTreeMap::new(),
            reported: HashSet::new(),
            counts: SeverityCounts::default(),
            path_lost: None,
            time_lost: None,
        }
    }

    /// Adds a diagnostic.
    pub fn push(&mut self, diagnostic: Diagnostic) {
        let span = diagnostic.primary.span;
        if self.path_lost.is_none() && diagnostic.code.loses_path(diagnostic.severity) {
            self.path_lost = Some(span);
        }
        if self.time_lost.is_none() && diagnostic.code.loses_time() {
            // The earlier of the two losses counts.
            self.time_lost = Some(self.path_lost.unwrap_or(span));
        }
        let code = diagnostic.code;
        if self.is_repeated_in_file(code, diagnostic.primary.span) {
            return;
        }
        let kept = self.kept_per_code.entry(code).or_insert(0);
        if self.reported.contains(&(code, diagnostic.primary.span)) {
            return;
        }
        self.counts.add(diagnostic.severity);
        if *kept >= self.limit_per_code {
            *self.dropped.entry(code).or_insert(0) += 1;
            return;
        }
        *kept += 1;
        self.reported.insert((code, diagnostic.primary.span));
        self.kept.push(diagnostic);
    }

    /// Adds a diagnostic, which is copied only when it is kept.
    pub fn push_copy(&mut self, diagnostic: &Diagnostic) {
        let (code, span) = (diagnostic.code, diagnostic.primary.span);
        let full = self.kept_per_code.get(&code).is_some_and(|kept| *kept >= self.limit_per_code);
        if full {
            self.push_uncopied(code, diagnostic.severity, span, 1);
        } else {
            self.push(diagnostic.clone());
        }
    }

    /// Counts `times` diagnostics at one location without keeping them.
    pub fn push_uncopied(&mut self, code: Code, severity: Severity, span: Span, times: u64) {
        if self.reported.contains(&(code, span)) || self.is_repeated_in_file(code, span) {
            return;
        }
        for _ in 0..times {
            self.counts.add(severity);
        }
        *self.dropped.entry(code).or_insert(0) += times;
    }

    /// Whether the code is reported only once per file and was already reported in this file.
    fn is_repeated_in_file(&self, code: Code, span: Span) -> bool {
        code.is_once_per_file()
            && self.kept.iter().any(|kept| kept.code == code && kept.primary.span.file == span.file)
    }

    /// The kept diagnostics in the order in which they were added.
    pub fn diagnostics(&self) -> &[Diagnostic] {
        &self.kept
    }

    /// The number of diagnostics of each code that were not kept.
    pub fn dropped(&self) -> impl Iterator<Item = (Code, u64)> + '_ {
        self.dropped.iter().map(|(&code, &count)| (code, count))
    }

    /// The counts of all diagnostics, kept or not.
    pub fn counts(&self) -> SeverityCounts {
        self.counts
    }

    /// The location, in the order of the run, from which on the path is unknown; `None` when it is known.
    pub fn path_lost(&self) -> Option<Span> {
        self.path_lost
    }

    /// The location, in the order of the run, from which on the path or the time is unknown; `None` when both are
    /// known.
    pub fn lost(&self) -> Option<Span> {
        self.time_lost.or(self.path_lost)
    }

    /// The kept diagnostics, sorted by location.
    pub fn into_sorted(mut self) -> Vec<Diagnostic> {
        self.kept.sort_by_key(|d| (d.primary.span.file, d.primary.span.range.start));
        self.kept
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::FileId;

    fn at(start: u32) -> Diagnostic {
        Diagnostic::new(Code::BadNumber, Span::new(FileId(0), start, start + 1), "x")
    }

    #[test]
    fn a_place_is_told_once_and_a_code_is_bounded() {
        let mut collector = Collector::new(2);
        for start in [1, 1, 2, 3, 4] {
            collector.push(at(start));
        }
        assert_eq!(collector.diagnostics().len(), 2);
        assert_eq!(collector.dropped().collect::<Vec<_>>(), [(Code::BadNumber, 2)]);
        assert_eq!(collector.counts().errors, 4);
    }
}
