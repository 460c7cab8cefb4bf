//! Programs that go several ways: each way of the new text is held against that of the old one.

use chordal::{AlternativeRun, BlockDeleteRuns, Job};
use chordal_compare::ComparisonVerdict;

use crate::source::{SourceBlocks, first_text};
use crate::{Certificate, ComparedSides};

/// A block of the first text that block delete may take.
pub(crate) struct DeletableBlock {
    /// The byte that it begins at.
    pub start: u32,
    /// All of it, not what stands behind a slash in its middle.
    pub is_whole: bool,
}

/// The blocks of the first text that block delete may take.
pub(crate) fn deletable_blocks(job: &Job) -> Vec<DeletableBlock> {
    if !first_text(job).contains(&b'/') {
        return Vec::new();
    }
    let blocks = SourceBlocks::of(job).blocks;
    let deletable = blocks.iter().filter_map(|block| {
        Some(DeletableBlock { start: block.range.start, is_whole: block.delete?.first })
    });
    deletable.collect()
}

/// When block delete is run both ways: always, where the text has a block that it may take.
pub(crate) fn block_delete_runs(deletable: &[DeletableBlock]) -> BlockDeleteRuns {
    match deletable {
        [] => BlockDeleteRuns::WhereItDecides,
        _ => BlockDeleteRuns::Both,
    }
}

/// Proves the ways that the first run did not take: the certificate becomes that of the first way that differs. What
/// was compared, or why not all was, is said; nothing where there is one way.
pub(crate) fn prove_other_sides(
    [old, new]: [&Job; 2],
    certificate: &mut Certificate,
    prove: impl Fn(&Job, &Job) -> Certificate,
) -> Option<String> {
    if certificate.comparison.verdict == ComparisonVerdict::Different {
        return None;
    }
    let runs = [old, new].map(|job| block_delete_runs(&deletable_blocks(job)));
    let [first_old, first_new] = &certificate.comparison.reports;
    let (olds, is_all) = old.other_side_jobs(&first_old.diagnostics, runs[0]);
    let (news, _) = new.other_side_jobs(&first_new.diagnostics, runs[1]);
    if olds.is_empty() && news.is_empty() {
        return None;
    }
    if olds.len() != news.len() {
        certificate.comparison.verdict = ComparisonVerdict::NotVerified;
        certificate.sides.is_complete = false;
        return Some(
            "the new program has other conditions that nobody knows than the old one: their sides were not compared"
                .to_string(),
        );
    }
    let mut sides = ComparedSides { is_complete: is_all, ..ComparedSides::default() };
    for ((side, old), (_, new)) in olds.iter().zip(&news) {
        match side {
            AlternativeRun::Fulfilled(_) => sides.conditions += 1,
            AlternativeRun::BlockDelete => sides.block_delete = true,
        }
        let of_side = prove(old, new);
        if of_side.comparison.verdict == ComparisonVerdict::Different {
            *certificate = Certificate { sides, ..of_side };
            return Some(differs(old, *side));
        }
    }
    if !is_all {
        certificate.comparison.verdict = ComparisonVerdict::NotVerified;
    }
    certificate.sides = sides;
    Some(compared(&sides))
}

fn differs(old: &Job, side: AlternativeRun) -> String {
    match side {
        AlternativeRun::BlockDelete => {
            "with block delete switched the other way the new program moves otherwise".to_string()
        }
        AlternativeRun::Fulfilled(condition) => {
            let source = old.sources().get(condition.file);
            let line = source.map_or(0, |source| source.line_of(condition.range.start));
            format!(
                "where the condition in line {line} is fulfilled the new program moves otherwise"
            )
        }
    }
}

fn compared(sides: &ComparedSides) -> String {
    let mut what = Vec::new();
    match sides.conditions {
        0 => {}
        1 => what.push("both sides of a condition that nobody knows".to_string()),
        more => what.push(format!("both sides of {more} conditions that nobody knows")),
    }
    if sides.block_delete {
        what.push("block delete on and off".to_string());
    }
    let what = what.join(", ");
    match sides.is_complete {
        true => format!("compared: {what}"),
        false => format!(
            "compared: {what}; the program has more conditions, of which one side was not run"
        ),
    }
}
