//! The certificate: old and new held against each other.

use chordal::Job;
use chordal_compare::{Category, Comparison, Difference, Options, Verdict, compare};

/// What a comparison of the old text with the new one says.
#[derive(Debug)]
pub struct Certificate {
    /// The comparison; differences that are expected are not among its own.
    pub comparison: Comparison,
    /// Differences that no writing of the text can take away, as the shape of rapids.
    pub expected: Vec<Difference>,
    /// What the paths were allowed to be apart, mm.
    pub tolerance_mm: f64,
}

impl Certificate {
    /// The motion is the same, or within the tolerance, and nothing differs that should not.
    pub fn holds(&self) -> bool {
        self.comparison.verdict != Verdict::Different
    }
}

/// Runs both and holds them against each other; differences of the categories `expected` are told
/// apart from the others.
pub fn prove(old: &Job, new: &Job, options: &Options, expected: &[Category]) -> Certificate {
    let mut comparison = compare(old, new, options);
    let (expected, others): (Vec<_>, Vec<_>) = std::mem::take(&mut comparison.differences)
        .into_iter()
        .partition(|difference| expected.contains(&difference.category));
    comparison.differences = others;
    if comparison.verdict == Verdict::Different
        && comparison.differences.is_empty()
        && comparison.dropped == 0
    {
        let apart = comparison.max_distance_mm.unwrap_or(0.0) > chordal_compare::SAME_MM;
        comparison.verdict = if apart { Verdict::Within } else { Verdict::Same };
    }
    Certificate { comparison, expected, tolerance_mm: options.tolerance_mm }
}
