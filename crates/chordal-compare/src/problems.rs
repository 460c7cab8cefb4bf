//! Errors that only one of the two runs has.

use std::collections::{BTreeMap, BTreeSet};

use chordal::{Diagnostic, Job, Report, Severity};

use crate::difference::{Blocks, Category, Difference, Place, Value};
use crate::walk::Found;

/// Adds the errors by code that occur in one run more often than in the other.
pub(crate) fn compare(jobs: [&Job; 2], reports: [&Report; 2], found: &mut Found) {
    let errors = reports.map(errors);
    let codes: BTreeSet<&str> = errors.iter().flat_map(BTreeMap::keys).copied().collect();
    for code in codes {
        let of = errors.each_ref().map(|errors| errors.get(code));
        let counts = of.map(|of| of.map_or(0, |(count, _)| *count));
        if counts[0] == counts[1] {
            continue;
        }
        let values = of.map(|of| {
            of.map_or(Value::Nothing, |(_, first)| {
                Value::Text(format!("{code}: {}", first.message))
            })
        });
        let blocks = [0, 1].map(|side: usize| {
            let span = of[side]?.1.primary.span;
            let line = jobs[side].sources().get(span.file)?.line_of(span.range.start);
            Some(Blocks::at(Place { span, line }))
        });
        found.differences.push(Difference::new(Category::Problem, blocks, counts, Some(values)));
    }
}

/// The errors of a run: how many of each code, and the first.
fn errors(report: &Report) -> BTreeMap<&'static str, (u64, &Diagnostic)> {
    let mut errors: BTreeMap<&'static str, (u64, &Diagnostic)> = BTreeMap::new();
    for diagnostic in report.diagnostics.iter().filter(|one| one.severity == Severity::Error) {
        errors.entry(diagnostic.code.id()).or_insert((0, diagnostic)).0 += 1;
    }
    for (code, count) in &report.dropped {
        if let Some((kept, _)) = errors.get_mut(code.id()) {
            *kept += count;
        }
    }
    errors
}
