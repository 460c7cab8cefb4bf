//! What is changed of a text, as a unified difference.

use imara_diff::{Algorithm, BasicLineDiffPrinter, Diff, InternedInput, UnifiedDiffConfig};

/// The difference of two texts with three lines around each change; empty where there is none. Line
/// ends are not shown.
pub fn unified(name: &str, before: &[u8], after: &[u8]) -> String {
    let [before, after] = [before, after].map(|text| {
        String::from_utf8_lossy(text)
            .replace("\n\r\r", "\n")
            .replace("\r\n", "\n")
            .replace(['\r', '\0'], "\n")
    });
    let input = InternedInput::new(before.as_str(), after.as_str());
    let mut diff = Diff::compute(Algorithm::Histogram, &input);
    diff.postprocess_lines(&input);
    let printer = BasicLineDiffPrinter(&input.interner);
    let hunks = diff.unified_diff(&printer, UnifiedDiffConfig::default(), &input).to_string();
    if hunks.is_empty() { hunks } else { format!("--- {name}\n+++ {name} (new)\n{hunks}") }
}
