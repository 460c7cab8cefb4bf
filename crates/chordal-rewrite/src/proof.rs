//! The certificate: old and new compared with each other.

use chordal::Job;
use chordal_compare::{
    Category, Comparison, ComparisonOptions, ComparisonVerdict, Difference, RunMapping,
    compare_mapped,
};

/// What a comparison of the old text with the new one says.
#[derive(Debug)]
pub struct Certificate {
    /// The comparison; differences that are expected are not among its own.
    pub comparison: Comparison,
    /// Differences that no writing of the text can take away, as the shape of rapids.
    pub expected: Vec<Difference>,
    /// What the paths were allowed to be apart, mm.
    pub tolerance_mm: f64,
    /// Where the tool centre goes another way because the controls compensate otherwise: the
    /// comparison of its paths. That of the certificate is then about the programmed contours.
    pub tool_center: Option<Comparison>,
    /// The ways through the program that were compared beside the first.
    pub sides: ComparedSides,
}

/// The ways through a program that a certificate covers beside the one that its first run takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ComparedSides {
    /// Conditions that nobody knows, of which both sides were compared.
    pub conditions: u32,
    /// Block delete was compared on and off.
    pub block_delete: bool,
    /// No condition that nobody knows is left of which one side was not compared.
    pub is_complete: bool,
}

impl Default for ComparedSides {
    fn default() -> ComparedSides {
        ComparedSides { conditions: 0, block_delete: false, is_complete: true }
    }
}

impl Certificate {
    /// The motion is the same, or within the tolerance, and nothing differs that should not.
    pub fn holds(&self) -> bool {
        matches!(self.comparison.verdict, ComparisonVerdict::Same | ComparisonVerdict::Within)
    }

    /// Takes differences for expected ones.
    pub fn set_aside(&mut self, is_expected: impl Fn(&Difference) -> bool) {
        let comparison = &mut self.comparison;
        let (mut expected, others): (Vec<_>, Vec<_>) =
            std::mem::take(&mut comparison.differences).into_iter().partition(is_expected);
        self.expected.append(&mut expected);
        comparison.differences = others;
        let nothing_left = comparison.differences.is_empty() && comparison.dropped == 0;
        if comparison.verdict == ComparisonVerdict::Different && nothing_left {
            let separate =
                comparison.max_distance_mm.unwrap_or(0.0) > chordal_compare::COINCIDENT_MM;
            let verified = comparison.reports.iter().all(chordal::Report::verified);
            comparison.verdict = match separate {
                _ if !verified => ComparisonVerdict::NotVerified,
                true => ComparisonVerdict::Within,
                false => ComparisonVerdict::Same,
            };
        }
    }
}

/// Runs both and holds them against each other; differences of the categories `expected` are reported
/// apart from the others.
pub fn prove(
    old: &Job,
    new: &Job,
    options: &ComparisonOptions,
    expected: &[Category],
) -> Certificate {
    prove_mapped(old, new, options, expected, &RunMapping::default())
}

/// The same where the new path is meant to be the old one, moved.
pub fn prove_mapped(
    old: &Job,
    new: &Job,
    options: &ComparisonOptions,
    expected: &[Category],
    mapping: &RunMapping,
) -> Certificate {
    let mut certificate = Certificate {
        comparison: compare_mapped(old, new, options, mapping),
        expected: Vec::new(),
        tolerance_mm: options.tolerance_mm,
        tool_center: None,
        sides: ComparedSides::default(),
    };
    certificate.set_aside(|difference| expected.contains(&difference.category));
    certificate
}

/// The same for programs that two controls compensate each in its own way: where the tool centres go
/// differently, the contours as they are programmed must be the same.
pub fn prove_contour(
    old: &Job,
    new: &Job,
    options: &ComparisonOptions,
    expected: impl Fn(&Difference) -> bool + Copy,
) -> Certificate {
    let prove = |options: &ComparisonOptions| {
        let mut certificate = prove(old, new, options, &[]);
        certificate.set_aside(expected);
        certificate
    };
    let whole = prove(options);
    if whole.holds() {
        return whole;
    }
    let contour = prove(&ComparisonOptions { programmed: true, ..options.clone() });
    if !contour.holds() {
        return whole;
    }
    Certificate { tool_center: Some(whole.comparison), ..contour }
}
