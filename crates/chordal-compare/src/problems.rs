//! Compares the errors and the unknown values of two runs.

use std::collections::{BTreeMap, BTreeSet};

use chordal::{Code, Diagnostic, Job, Report, Severity};

use crate::alignment_walker::ComparisonFindings;
use crate::category::Category;
use crate::difference::{BlockLocation, BlockRange, Difference, DifferenceValue};

/// Adds a difference for each error code that the two runs report a different number of times.
pub(crate) fn compare(jobs: [&Job; 2], reports: [&Report; 2], found: &mut ComparisonFindings) {
    let errors = reports.map(errors);
    let codes: BTreeSet<&str> = errors.iter().flat_map(BTreeMap::keys).copied().collect();
    for code in codes {
        let of = errors.each_ref().map(|errors| errors.get(code));
        let counts = of.map(|of| of.map_or(0, |(count, _)| *count));
        if counts[0] == counts[1] {
            continue;
        }
        let values = of.map(|of| {
            of.map_or(DifferenceValue::Nothing, |(_, first)| {
                DifferenceValue::Text(format!("{code}: {}", first.message))
            })
        });
        let blocks = [0, 1].map(|side: usize| place(jobs[side], of[side]?.1));
        found.differences.push(Difference::new(Category::Problem, blocks, counts, Some(values)));
    }
}

/// The errors of a run by code: their number and the first one.
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

/// Adds a difference for each unknown value that the two runs read a different number of times.
pub(crate) fn compare_values(
    jobs: [&Job; 2],
    reports: [&Report; 2],
    found: &mut ComparisonFindings,
) {
    let by_message = reports.map(|report| {
        let mut by_message: BTreeMap<&str, Vec<&Diagnostic>> = BTreeMap::new();
        for diagnostic in &report.diagnostics {
            if VALUES.contains(&diagnostic.code) {
                by_message.entry(diagnostic.message.as_str()).or_default().push(diagnostic);
            }
        }
        by_message
    });
    let messages: BTreeSet<&str> = by_message.iter().flat_map(BTreeMap::keys).copied().collect();
    for message in messages {
        let of =
            by_message.each_ref().map(|places| places.get(message).map_or(&[][..], Vec::as_slice));
        if of[0].len() == of[1].len() {
            continue;
        }
        let counts = of.map(|of| of.len() as u64);
        let blocks = [0, 1].map(|side: usize| place(jobs[side], of[side].first()?));
        let values = of.map(|of| match of {
            [] => DifferenceValue::Nothing,
            _ => DifferenceValue::Text(message.to_string()),
        });
        found.differences.push(Difference::new(Category::Value, blocks, counts, Some(values)));
    }
}

/// The diagnostics about unknown values.
const VALUES: &[Code] = &[
    Code::UnknownVariable,
    Code::SystemVariable,
    Code::UnknownPath,
    Code::UnknownTime,
    Code::AssumedBranch,
    Code::SkipAssumed,
    Code::CyclePathAssumed,
    Code::DateNotSet,
];

/// The block of a diagnostic.
fn place(job: &Job, diagnostic: &Diagnostic) -> Option<BlockRange> {
    let span = diagnostic.primary.span;
    let line = job.sources().get(span.file)?.line_of(span.range.start);
    Some(BlockRange::at(BlockLocation { span, line }))
}
